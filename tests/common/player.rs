//! A simple player with a list of intentions. He sees where the hero is and steers, so that his runs survive changes of the
//! feel.

#![allow(dead_code, reason = "each test uses its own part")]

use edgewalker::game::{Input, Stage, Stance, View, World};
use edgewalker::level::{self, Level};
use edgewalker::motion::grip::Grip;
use edgewalker::tune::Tuning;
use std::path::Path;
use std::sync::Arc;

/// What the player wants next.
#[derive(Clone, Copy, Debug)]
pub enum Act {
    /// Run at full speed until x is passed.
    Run(f64),
    /// The same, crouched.
    Duck(f64),
    /// Step carefully to x and stop there.
    Walk(f64),
    /// Jump as high as possible and come down at x.
    Jump(f64),
}
pub use Act::{Duck, Jump, Run, Walk};

/// From the camp to the gate.
pub const WAY: &[Act] = &[
    // Down the rim, over the broken bridge, down the benches.
    Run(32.4),
    Jump(37.5),
    Run(49.0),
    Run(54.2),
    Jump(56.2),
    Run(69.0),
    // Under the Lip.
    Duck(79.6),
    // Up the shaft.
    Walk(81.4),
    Jump(83.2),
    Walk(82.6),
    Jump(80.4),
    Walk(81.2),
    Jump(84.2),
    Walk(83.4),
    Jump(79.9),
    Walk(80.5),
    Jump(84.9),
    Walk(84.6),
    Jump(87.4),
    // Over the boiler and up the girder, then from stack to stack.
    Run(88.8),
    Jump(91.6),
    Run(105.2),
    Jump(110.0),
    Run(111.1),
    Jump(116.2),
    Run(117.3),
    Jump(122.0),
    Run(124.0),
    Jump(128.8),
    Run(129.4),
    Jump(134.0),
    // The viaduct and its gap.
    Run(145.2),
    Jump(148.4),
    Run(149.1),
    Jump(155.5),
    // Up the tower, from side to side.
    Run(176.5),
    Jump(179.4),
    Walk(178.1),
    Jump(174.6),
    Walk(176.0),
    Jump(180.0),
    Walk(178.6),
    Jump(174.0),
    Walk(175.4),
    Jump(180.6),
    Walk(180.8),
    Jump(183.4),
    Run(191.0),
];

/// The level as it ships.
pub fn quarry() -> Level {
    level::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("levels/quarry.ron")).unwrap()
}

fn stick(wish: f64) -> i8 {
    (wish.clamp(-1.0, 1.0) * 127.0) as i8
}

/// The player: his world and what he has seen of the present act.
pub struct Player {
    /// The game.
    pub world: World,
    /// How the hero moves.
    pub tuning: Tuning,
    /// What he has held so far, tick by tick.
    pub inputs: Vec<Input>,
    /// Ticks in the present act.
    ticks: u32,
    /// The hero has been in the air in it.
    flown: bool,
}

impl Player {
    /// Before his first act.
    pub fn new(stage: Arc<Stage>, tuning: Tuning, tick_rate: u32) -> Self {
        Player {
            world: World::new(stage, tick_rate, 0),
            tuning,
            inputs: Vec::new(),
            ticks: 0,
            flown: false,
        }
    }

    /// Does one act; says where it ended otherwise.
    pub fn act(&mut self, act: Act) -> Result<(), String> {
        let from = self.world.view();
        (self.ticks, self.flown) = (0, false);
        while let Some(input) = self.next_input(act, from.position.x) {
            self.world.step(input, &self.tuning);
            self.inputs.push(input);
            self.ticks += 1;
            let view = self.world.view();
            if view.won_at.is_some() {
                return Ok(());
            }
            if view.deaths > from.deaths || view.time > from.time + 15.0 {
                return Err(format!(
                    "{act:?} from {} ended at {} ({:?})",
                    from.position, view.position, view.stance
                ));
            }
        }
        Ok(())
    }

    /// What to hold in this tick; `None` when the act is done.
    fn next_input(&mut self, act: Act, from: f64) -> Option<Input> {
        let View {
            position,
            velocity,
            stance,
            ..
        } = self.world.view();
        let grounded = matches!(stance, Stance::Ground | Stance::Wedge);
        self.flown |= !grounded;
        let full = self.tuning.motion.run_speed;
        if self.world.hero().grip() != Grip::None {
            // At a ledge he climbs up.
            let up = true;
            return Some(Input {
                up,
                ..Input::default()
            });
        }
        match act {
            Run(x) | Duck(x) => {
                let way = (x - from).signum();
                let input = Input {
                    run: stick(way),
                    down: matches!(act, Duck(_)),
                    ..Input::default()
                };
                ((x - position.x) * way > 0.0).then_some(input)
            }
            Walk(x) => {
                let there = (x - position.x).abs() < 0.1 && velocity.x.abs() < 0.3;
                (!there).then_some(Input {
                    run: stick(((x - position.x) * 3.0 / full).clamp(-0.6, 0.6)),
                    ..Input::default()
                })
            }
            Jump(x) => {
                let falling = self.flown && velocity.y < -4.0;
                let input = Input {
                    run: stick((x - position.x) * 5.0 / full),
                    jump: self.ticks > 0 && !falling,
                    ..Input::default()
                };
                (!(self.flown && grounded)).then_some(input)
            }
        }
    }
}
