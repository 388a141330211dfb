//! A recorded run as its sounds are decided, tick by tick.

use edgewalker::cli::load;
use edgewalker::game::Replay;
use edgewalker::sound::{Ear, Moment, Soundscape};
use std::path::Path;

/// Plays a run, and lets each of its moments be heard, from where the hero is, with the number of its tick.
pub fn each_moment(
    path: &Path,
    replay: &Replay,
    mut hear: impl FnMut(usize, &mut Soundscape, &Moment),
) {
    let mut world = load::replay_world(path, replay).unwrap_or_else(|e| panic!("{e}"));
    let mut scape = Soundscape::new(&world);
    for (tick, input) in replay.iter().enumerate() {
        let before = world.view();
        world.step(input, &replay.tuning);
        let now = world.view();
        let moment = Moment {
            world: &world,
            before: &before,
            now: &now,
            ear: Ear { at: now.position },
        };
        hear(tick, &mut scape, &moment);
    }
}
