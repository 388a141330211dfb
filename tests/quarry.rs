//! The quarry can be finished: a simple player with a list of intentions runs it from start to goal.
//!
//! He sees where the hero is and steers, so that his runs survive changes of the feel. A level that only works at
//! its limits would stop him: he also has to finish at 70 % of the speed, and with jumps 70 % as high.

use edgewalker::game::{Input, Stage, Stance, View, World};
use edgewalker::level::{self, Level};
use edgewalker::tune::Tuning;
use glam::DVec2;
use std::path::Path;
use std::sync::Arc;

/// What the player wants next.
#[derive(Clone, Copy, Debug)]
enum Act {
    /// Run at full speed until x is passed.
    Run(f64),
    /// The same, crouched.
    Duck(f64),
    /// Step carefully to x and stop there.
    Walk(f64),
    /// Jump as high as possible and come down at x.
    Jump(f64),
}
use Act::{Duck, Jump, Run, Walk};

/// From the camp to the gate.
const WAY: &[Act] = &[
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

/// The pockets beside the way: where one may fall to, the way out, and where that leads.
const POCKETS: &[(&str, (f64, f64), &[Act], (f64, f64))] = &[
    (
        "west of the fallen stones",
        (30.6, -1.7),
        &[
            Run(32.0),
            Jump(33.6),
            Walk(33.85),
            Jump(34.75),
            Walk(34.9),
            Jump(37.4),
        ],
        (37.4, 3.2),
    ),
    (
        "east of the fallen stones",
        (40.7, -2.3),
        &[
            Jump(39.1),
            Run(38.0),
            Run(36.9),
            Jump(35.0),
            Walk(34.9),
            Jump(37.4),
        ],
        (37.4, 3.2),
    ),
    (
        "behind the bench block",
        (54.6, -2.5),
        &[Jump(56.0)],
        (56.0, -2.1),
    ),
    (
        "the floor of the shaft",
        (81.8, -6.7),
        &[Walk(81.4), Jump(83.2)],
        (83.2, -5.0),
    ),
    (
        "on the wedged lintel",
        (113.0, 7.0),
        &[Walk(113.2), Jump(115.8)],
        (115.8, 8.3),
    ),
    (
        "on the leaning column",
        (119.0, 5.5),
        &[Run(119.6), Jump(122.0)],
        (122.0, 7.2),
    ),
];

fn quarry() -> Level {
    level::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("levels/quarry.ron")).unwrap()
}

fn stick(wish: f64) -> i8 {
    (wish.clamp(-1.0, 1.0) * 127.0) as i8
}

/// The player: his world and what he has seen of the present act.
struct Player {
    world: World,
    tuning: Tuning,
    /// Ticks in the present act.
    ticks: u32,
    /// The hero has been in the air in it.
    flown: bool,
}

impl Player {
    fn new(stage: Arc<Stage>, tuning: Tuning, tick_rate: u32) -> Self {
        Player {
            world: World::new(stage, tick_rate, 0),
            tuning,
            ticks: 0,
            flown: false,
        }
    }

    /// Does one act; says where it ended otherwise.
    fn act(&mut self, act: Act) -> Result<(), String> {
        let from = self.world.view();
        (self.ticks, self.flown) = (0, false);
        while let Some(input) = self.next_input(act, from.position.x) {
            self.world.step(input, &self.tuning);
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

/// Seconds from start to goal.
fn finish(tuning: Tuning, tick_rate: u32) -> f64 {
    let stage = Arc::new(Stage::build(quarry()).unwrap());
    let mut player = Player::new(stage, tuning, tick_rate);
    for &act in WAY {
        player.act(act).unwrap();
    }
    player
        .world
        .view()
        .won_at
        .expect("the way leads to the goal")
}

#[test]
fn the_quarry_can_be_finished_at_every_tick_rate() {
    for tick_rate in [30, 60, 120, 240, 1000] {
        let seconds = finish(Tuning::default(), tick_rate);
        assert!(
            (35.0..60.0).contains(&seconds),
            "{seconds} s at {tick_rate} Hz"
        );
    }
}

#[test]
fn no_jump_needs_more_than_seventy_percent_of_the_speed() {
    let mut tuning = Tuning::default();
    tuning.motion.run_speed *= 0.7;
    finish(tuning, 120);
}

#[test]
fn no_jump_needs_more_than_seventy_percent_of_the_height() {
    let mut tuning = Tuning::default();
    let motion = &mut tuning.motion;
    // Up to the float at the apex under full gravity, then under its share of it.
    let height = |v: f64| (v * v - motion.apex_speed.powi(2)) / (2.0 * motion.gravity);
    let float = motion.apex_speed.powi(2) / (2.0 * motion.gravity * motion.apex_gravity);
    let wanted = 0.7 * (height(motion.jump_speed) + float) - float;
    motion.jump_speed = (2.0 * motion.gravity * wanted + motion.apex_speed.powi(2)).sqrt();
    finish(tuning, 120);
}

#[test]
fn every_pocket_beside_the_way_can_be_left() {
    for &(name, (x, y), way, (to_x, to_y)) in POCKETS {
        let stage = Arc::new(
            Stage::build(Level {
                start: DVec2::new(x, y),
                ..quarry()
            })
            .unwrap_or_else(|error| panic!("{name}: {error}")),
        );
        let mut player = Player::new(stage, Tuning::default(), 120);
        for _ in 0..120 {
            player.world.step(Input::default(), &player.tuning);
        }
        for &act in way {
            player
                .act(act)
                .unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        let end = player.world.view().position;
        assert!(
            (end - DVec2::new(to_x, to_y)).abs().max_element() < 1.0,
            "{name}: ended at {end}"
        );
    }
}
