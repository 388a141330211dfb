//! Random play: a player without intentions, watched at every tick.

use crate::game::{Input, Replay, World};
use glam::DVec2;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Where a walk begins.
pub(super) struct Start {
    /// What that place is called.
    pub name: String,
    /// The hero's foot, m.
    pub at: DVec2,
}

/// How a walk went.
pub(super) struct Walk {
    /// All its inputs; with a fault, up to the tick that shows it.
    pub replay: Replay,
    /// What went wrong, when, and where.
    pub fault: Option<String>,
}

/// A player who holds something for a while, then something else.
pub(super) struct Player {
    state: u64,
    input: Input,
    left: u64,
}

impl Player {
    pub fn new(seed: u64) -> Player {
        Player {
            state: seed,
            input: Input::default(),
            left: 0,
        }
    }

    /// The next number: splitmix64, after Steele, Lea and Flood (2014).
    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn one_in(&mut self, n: u64) -> bool {
        self.next().is_multiple_of(n)
    }

    /// What is held in the next tick.
    fn input(&mut self) -> Input {
        if self.left == 0 {
            self.left = 1 + self.next() % 60;
            let way = [-127, -127, 127, 127, 127, 0, 50, -20];
            self.input = Input {
                run: way[self.next() as usize % way.len()],
                jump: self.one_in(2),
                down: self.one_in(6),
                up: self.one_in(4),
                ..Input::default()
            };
        }
        self.left -= 1;
        self.input
    }
}

/// Plays some ticks, and asks after each whether the world is sound. Stops at the first fault; a panic is one.
pub(super) fn walk(
    mut world: World,
    ticks: u64,
    mut replay: Replay,
    player: &mut Player,
    sound: impl Fn(&World) -> Result<(), String>,
) -> Walk {
    for _ in 0..ticks {
        let input = player.input();
        replay.push(input);
        let before = world.hero().position();
        let tick = catch_unwind(AssertUnwindSafe(|| {
            world.step(input, &replay.tuning);
            sound(&world)
        }));
        let fault = match tick {
            Ok(Ok(())) => continue,
            Ok(Err(fault)) => fault,
            Err(_) => "the program panicked".to_owned(),
        };
        let (x, y) = (before.x, before.y);
        let tick = replay.ticks();
        return Walk {
            replay,
            fault: Some(format!("tick {tick}, near ({x:.4}, {y:.4}): {fault}")),
        };
    }
    Walk {
        replay,
        fault: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::load;
    use crate::tune::Tuning;
    use std::path::Path;
    use std::sync::Arc;

    /// A world that is called unsound as soon as the hero is a metre from where he began.
    #[test]
    fn a_fault_is_shown_by_the_replay_that_comes_with_it() {
        let stage = load::stage(Path::new("levels/dev/flat.ron")).unwrap();
        let far = |world: &World| {
            let way = world.hero().position().x - world.stage().level.start.x;
            (way.abs() < 1.0)
                .then_some(())
                .ok_or_else(|| "too far".to_owned())
        };
        let replay = Replay::new("levels/dev/flat.ron", &stage, 120, 5, &Tuning::default());
        let world = replay.world(Arc::clone(&stage)).unwrap();
        let Walk { replay, fault } = walk(world, 100_000, replay, &mut Player::new(5), far);
        let fault = fault.unwrap();
        assert!(fault.ends_with(": too far"), "{fault}");
        let mut world = replay.world(stage).unwrap();
        let mut inputs = replay.iter().peekable();
        while let Some(input) = inputs.next() {
            world.step(input, &replay.tuning);
            assert_eq!(
                far(&world).is_err(),
                inputs.peek().is_none(),
                "tick {}",
                world.tick()
            );
        }
    }

    #[test]
    fn a_panic_is_a_fault() {
        let stage = load::stage(Path::new("levels/dev/flat.ron")).unwrap();
        let replay = Replay::new("levels/dev/flat.ron", &stage, 120, 0, &Tuning::default());
        let world = replay.world(stage).unwrap();
        let broken = |world: &World| match world.tick() {
            7 => std::panic::panic_any(()),
            _ => Ok(()),
        };
        let found = walk(world, 100, replay, &mut Player::new(0), broken);
        assert_eq!(found.replay.ticks(), 7);
        assert!(found.fault.unwrap().ends_with("the program panicked"));
    }
}
