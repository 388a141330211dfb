//! What is left of a run when the game fails: its inputs as a replay, and where they are.

use super::log::Log;
use crate::cli::terminal;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// How many of them are kept; of more, the last is replaced.
const MOST: u32 = 99;

/// The run that is played now, and the folder for what is left of it.
static PLAYED: Mutex<Option<(Arc<Log>, PathBuf)>> = Mutex::new(None);

/// From now on this is the run that is played; without a folder of the user's, what is left of it goes to where the system
/// keeps what soon goes.
pub fn watch(log: &Arc<Log>, folder: Option<&Path>) {
    let folder = folder.map_or_else(std::env::temp_dir, Path::to_path_buf);
    *PLAYED.lock().unwrap_or_else(PoisonError::into_inner) = Some((log.clone(), folder));
}

/// Plays; should that fail, what led to it is kept before the program ends as it would have.
pub fn keep<T>(play: impl FnOnce() -> T) -> T {
    // Nothing of what failed is used again: all of it is dropped, but for the inputs, which are whole after every tick.
    catch_unwind(AssertUnwindSafe(play)).unwrap_or_else(|fault| {
        terminal::say("this is a fault of the game, not yours");
        let played = PLAYED.lock().unwrap_or_else(PoisonError::into_inner).take();
        if let Some((log, folder)) = played {
            terminal::say(match leave(&log, &folder) {
                Ok(said) => format!("what led to it is kept, to be played with --replay: {said}"),
                Err(reason) => format!("what led to it could not be kept: {reason}"),
            });
        }
        resume_unwind(fault)
    })
}

/// Writes the inputs under a name that is free.
fn leave(log: &Log, folder: &Path) -> Result<String, String> {
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let named = |number: u32| folder.join(format!("fault-{number}.replay"));
    let free = (1..=MOST).map(named).find(|path| !path.exists());
    log.write(&free.unwrap_or_else(|| named(MOST)))
        .map_err(|e| e.to_string())
}
