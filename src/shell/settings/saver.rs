//! Files written aside: a disk that takes its time holds up no frame.

use crate::cli::files::{self, FileError};
use std::path::{Path, PathBuf};
use std::thread::{self, JoinHandle};

/// The outcome of a save.
pub type Saved = Result<(), FileError>;

/// Writes files on a thread of its own, one after the other. Dropped, it waits for the last of them.
#[derive(Debug, Default)]
pub struct Saver {
    last: Option<JoinHandle<Saved>>,
}

impl Saver {
    /// Begins to write a file, after those before it.
    pub fn save(&mut self, path: PathBuf, text: String) {
        let before = self.last.take();
        self.last = Some(thread::spawn(move || {
            // What became of an older state of the file matters no more.
            let _ = before.map(JoinHandle::join);
            write(&path, &text)
        }));
    }

    /// What became of the last save, once, when it is over.
    pub fn outcome(&mut self) -> Option<Saved> {
        let is_over = self.last.as_ref().is_some_and(JoinHandle::is_finished);
        if is_over { self.wait() } else { None }
    }

    /// Waits until all is written; what became of the last save, unless that was told before.
    pub fn wait(&mut self) -> Option<Saved> {
        self.last.take()?.join().ok()
    }
}

impl Drop for Saver {
    fn drop(&mut self) {
        let _ = self.wait();
    }
}

/// Writes a text whole, making its folder if need be.
///
/// # Errors
/// The file cannot be written.
pub fn write(path: &Path, text: &str) -> Saved {
    if let Some(folder) = path.parent() {
        let made = std::fs::create_dir_all(folder);
        made.map_err(|e| FileError::new(path, format!("cannot be saved: {e}")))?;
    }
    files::write_atomic(path, text.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_of_many_saves_is_what_stays() {
        let folder = std::env::temp_dir().join(format!("edgewalker-saver-{}", std::process::id()));
        let path = folder.join("made/file");
        let mut saver = Saver::default();
        assert!(saver.outcome().is_none(), "nothing was saved");
        for number in 0..20 {
            saver.save(path.clone(), number.to_string());
        }
        drop(saver);
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "19");
        let mut saver = Saver::default();
        saver.save(path.join("in a file"), String::new());
        let why = saver.wait().unwrap().unwrap_err().to_string();
        assert!(why.contains("in a file: cannot be saved"), "{why}");
        assert!(saver.wait().is_none(), "told once");
        std::fs::remove_dir_all(folder).unwrap();
    }
}
