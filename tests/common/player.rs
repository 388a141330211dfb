//! A simple player with a list of intentions. He sees where the hero is and steers, so that his runs survive changes of the
//! feel.

#![allow(dead_code, reason = "each test uses its own part")]

use edgewalker::game::{Input, Stage, Stance, View, World};
use edgewalker::level::{self, Level};
use edgewalker::motion::grip::Grip;
use edgewalker::tune::Tuning;
use glam::DVec2;
use serde::Deserialize;
use std::path::Path;
use std::sync::Arc;

/// What the player wants next.
#[derive(Clone, Debug, Deserialize)]
pub enum Act {
    /// Run at full speed until x is passed.
    Run(f64),
    /// The same, crouched.
    Duck(f64),
    /// Step carefully to x and stop there.
    Walk(f64),
    /// Jump as high as possible and come down at x.
    Jump(f64),
    /// Go over an edge without a jump and come down at x.
    Fall(f64),
    /// Down through the one-way below, and come down at x.
    Drop(f64),
    /// Jump towards x and take hold of a ladder or vines there.
    Mount(f64),
    /// Up a ladder or vines to this height, or until there is ground below the feet.
    Climb(f64),
    /// Jump at the wall to the right (1) or left (-1), then from wall to wall, until this height is passed.
    Kick(f64, f64),
    /// Do nothing until the mover with this id is this far (x, y) from where it was drawn.
    Wait(String, f64, f64),
    /// Do nothing until that mover comes there: if it is there already, until it comes back.
    Meet(String, f64, f64),
}
pub use Act::{Drop, Duck, Fall, Jump, Run, Walk};

/// From the camp to the gate: what `tests/golden/quarry.way.ron` says.
pub fn way() -> Vec<Act> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/quarry.way.ron");
    let text = std::fs::read_to_string(file).unwrap();
    ron::from_str(&text).unwrap_or_else(|error| panic!("quarry.way.ron: {error}"))
}

/// A mover counts as being at a place when it is as near as this, m.
const THERE: f64 = 0.05;

/// The longest that an act may take, s.
const LONGEST: f64 = 20.0;

/// The level as it ships.
pub fn quarry() -> Level {
    load("levels/quarry.ron")
}

/// The small level that nothing moves in, for measurements.
pub fn crossing() -> Level {
    load("levels/dev/crossing.ron")
}

fn load(file: &str) -> Level {
    level::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap()
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
    /// The mover that is waited for is there.
    there: bool,
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
            there: true,
        }
    }

    /// Does one act; says where it ended otherwise.
    pub fn act(&mut self, act: &Act) -> Result<(), String> {
        let from = self.world.view();
        (self.ticks, self.flown, self.there) = (0, false, true);
        while let Some(input) = self.next_input(act, from.position.x) {
            self.world.step(input, &self.tuning);
            self.inputs.push(input);
            self.ticks += 1;
            let view = self.world.view();
            if view.won_at.is_some() {
                return Ok(());
            }
            if view.deaths > from.deaths || view.time > from.time + LONGEST {
                return Err(format!(
                    "{act:?} from {} ended at {} ({:?})",
                    from.position, view.position, view.stance
                ));
            }
        }
        Ok(())
    }

    /// What to hold in this tick; `None` when the act is done.
    fn next_input(&mut self, act: &Act, from: f64) -> Option<Input> {
        let View {
            position,
            velocity,
            stance,
            ..
        } = self.world.view();
        let grounded = matches!(stance, Stance::Ground | Stance::Wedge);
        self.flown |= !grounded;
        let none = Input::default();
        if matches!(self.world.hero().grip(), Grip::Ledge | Grip::Over) {
            // At a ledge he climbs up.
            return Some(Input { up: true, ..none });
        }
        let holds = stance == Stance::Climb || self.world.hero().grip() == Grip::Wall;
        let full = self.tuning.motion.run_speed;
        let steer = |x: f64| stick((x - position.x) * 5.0 / full);
        let landed = self.flown && grounded;
        match *act {
            Run(x) | Duck(x) => {
                let way = (x - from).signum();
                let input = Input {
                    run: stick(way),
                    down: matches!(act, Duck(_)),
                    ..none
                };
                ((x - position.x) * way > 0.0).then_some(input)
            }
            Walk(x) => {
                let there = (x - position.x).abs() < 0.1 && velocity.x.abs() < 0.3;
                let run = stick(((x - position.x) * 3.0 / full).clamp(-0.6, 0.6));
                (!there).then_some(Input { run, ..none })
            }
            Jump(x) => {
                let falling = self.flown && velocity.y < -4.0;
                let jump = self.ticks > 0 && !falling;
                let run = steer(x);
                (!landed).then_some(Input { run, jump, ..none })
            }
            Fall(x) => (!landed).then_some(Input {
                run: steer(x),
                ..none
            }),
            Drop(x) => {
                let through = self.flown;
                (!landed).then_some(Input {
                    run: if through { steer(x) } else { 0 },
                    down: !through,
                    jump: !through && self.ticks > 1,
                    ..none
                })
            }
            Act::Mount(x) => (!holds).then_some(Input {
                run: steer(x),
                jump: self.ticks > 0,
                up: self.flown,
                ..none
            }),
            Act::Climb(y) => {
                let there = position.y >= y || (landed && self.ticks > 0);
                (!there).then_some(Input { up: true, ..none })
            }
            Act::Kick(side, y) => self.kick(side, y),
            Act::Wait(ref id, x, y) => (!self.is_there(id, x, y)).then_some(none),
            Act::Meet(ref id, x, y) => {
                let is_there = self.is_there(id, x, y);
                let was_there = std::mem::replace(&mut self.there, is_there);
                (was_there || !is_there).then_some(none)
            }
        }
    }

    /// Whether a mover is so far from where it was drawn.
    fn is_there(&self, id: &str, x: f64, y: f64) -> bool {
        (self.offset_of(id) - DVec2::new(x, y)).abs().max_element() < THERE
    }

    /// How far a mover is from where it was drawn.
    fn offset_of(&self, id: &str) -> DVec2 {
        let movers = &self.world.stage().level.movers;
        let index = movers.iter().position(|mover| mover.id == id);
        let index = index.unwrap_or_else(|| panic!("no mover {id:?}"));
        let mut offsets = self.world.offsets_at(self.world.time());
        offsets.nth(index).expect("every mover has its place")
    }

    /// Towards a wall, and off it when he slides down it.
    fn kick(&mut self, side: f64, y: f64) -> Option<Input> {
        let View {
            position, stance, ..
        } = self.world.view();
        let held = self.inputs.last().copied().unwrap_or_default();
        let begins = self.ticks == 0;
        let slides = stance == Stance::Slide;
        let (run, jump) = match (begins, slides) {
            (true, _) => (stick(side), false),
            (_, true) if held.jump => (held.run, false),
            (_, true) => (-held.run, true),
            (_, false) => (held.run, true),
        };
        (position.y < y).then_some(Input {
            run,
            jump,
            ..Input::default()
        })
    }
}
