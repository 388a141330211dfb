//! Turns at the files of a folder, for several games that run at once.

use std::fs::{File, TryLockError};
use std::path::Path;
use std::time::{Duration, Instant};

const FILE: &str = ".lock";
/// How long another game is waited for. None needs more than a moment; one that stands still holds up nobody.
const PATIENCE: Duration = Duration::from_millis(500);
const NAP: Duration = Duration::from_millis(2);

/// A turn, until it is dropped. The system takes it from a game that ends, however it ends: the file stays, and means
/// nothing by itself.
#[derive(Debug)]
pub struct Turn {
    held: Option<File>,
}

impl Turn {
    /// Waits for a turn at a folder. Where the system has no such locks, or somebody does not let go, it goes on without:
    /// what is in the files is merged all the same.
    pub fn at(folder: &Path) -> Turn {
        let file = File::options()
            .create(true)
            .truncate(false)
            .write(true)
            .open(folder.join(FILE));
        let begin = Instant::now();
        let held = file.ok().filter(|file| {
            loop {
                match file.try_lock() {
                    Ok(()) => return true,
                    Err(TryLockError::WouldBlock) if begin.elapsed() < PATIENCE => {
                        std::thread::sleep(NAP);
                    }
                    Err(_) => return false,
                }
            }
        });
        Turn { held }
    }

    /// Whether nobody else has one.
    pub fn is_alone(&self) -> bool {
        self.held.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_after_the_other_and_nobody_for_ever() {
        let folder = std::env::temp_dir().join(format!("edgewalker-lock-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join(FILE), "left by whom?").unwrap();
        let first = Turn::at(&folder);
        assert!(first.is_alone(), "a file that was left locks nothing");
        let begin = Instant::now();
        assert!(!Turn::at(&folder).is_alone());
        assert!(begin.elapsed() < PATIENCE * 4);
        drop(first);
        assert!(Turn::at(&folder).is_alone());
        assert!(!Turn::at(&folder.join("missing")).is_alone());
        std::fs::remove_dir_all(folder).unwrap();
    }
}
