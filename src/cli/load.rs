//! From paths to what is played: a level with its meshes, a replay.

use super::files::{FileError, find, read_text};
use super::{lines, terminal};
use crate::game::{Replay, Stage, StageError};
use crate::level::{self, LevelError};
use crate::mesh::{Left, Part, Phase};
use std::path::Path;
use std::sync::Arc;

/// Why a level or a replay cannot be played; names the file.
#[derive(Debug)]
pub enum LoadError {
    /// The file, the replay's text or the level's meshes.
    File(FileError),
    /// The level's text.
    Level(LevelError),
}

impl std::fmt::Display for LoadError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            LoadError::File(error) => error.fmt(f),
            LoadError::Level(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for LoadError {}

/// A level, ready to play.
///
/// # Errors
/// The file is missing or broken, or the hero does not fit at the start.
pub fn stage(path: &Path) -> Result<Arc<Stage>, LoadError> {
    stage_watched(path, Part::UNSEEN)
}

/// The same, as long work that others wait for.
///
/// # Errors
/// As for [`stage`], or if nobody waits for it any more.
pub fn stage_watched(path: &Path, part: Part) -> Result<Arc<Stage>, LoadError> {
    let failed = |error: StageError| LoadError::File(FileError::new(path, format!("{error}")));
    let reading = part.between(0.0, 0.1);
    let left = |_: Left| failed(StageError::Left);
    reading.begin(Phase::Reading).map_err(left)?;
    let level = level::load(&find(path)).map_err(LoadError::Level)?;
    let stage = Stage::watched(level, part.between(0.1, 1.0)).map_err(failed)?;
    Ok(Arc::new(stage))
}

/// A recorded run. Of one that breaks off, what is whole; that is said in the terminal.
///
/// # Errors
/// The file is missing, or not a replay that this program understands.
pub fn replay(path: &Path) -> Result<Replay, LoadError> {
    let path = find(path);
    let text = read_text(&path).map_err(LoadError::File)?;
    Replay::parse(&text).or_else(|error| {
        if let Some(replay) = Replay::parse_cut(&text) {
            let (file, ticks) = (path.display(), replay.ticks());
            terminal::say(format!(
                "{file}: breaks off; its first {ticks} ticks are whole"
            ));
            return Ok(replay);
        }
        let line = error
            .field()
            .map(|name| format!("line {}: ", lines::of_field(&text, name)));
        let reason = format!("{}{error}", line.unwrap_or_default());
        Err(LoadError::File(FileError::new(&path, reason)))
    })
}

/// The world of a replay at its start.
///
/// # Errors
/// Its level is missing, broken, or not the one that it was recorded in.
pub fn replay_world(path: &Path, replay: &Replay) -> Result<crate::game::World, LoadError> {
    let stage = stage(Path::new(&replay.level))?;
    replay
        .world(stage)
        .map_err(|error| LoadError::File(FileError::new(path, error.to_string())))
}
