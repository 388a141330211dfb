//! A replay without a window.

use super::load::{self, LoadError};
use super::summary::Summary;
use std::path::Path;

/// Plays a replay to its end.
///
/// # Errors
/// The replay or its level cannot be played.
pub fn play(path: &Path) -> Result<Summary, LoadError> {
    let replay = load::replay(path)?;
    let mut world = load::replay_world(path, &replay)?;
    let mut summary = Summary::new(&world);
    for input in replay.iter() {
        world.step(input, &replay.tuning);
        summary.watch(&world);
    }
    Ok(summary)
}
