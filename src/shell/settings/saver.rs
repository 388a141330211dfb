//! Files written aside: a disk that takes its time holds up no frame.

use crate::cli::files::{self, FileError};
use std::path::Path;
use std::thread::{self, JoinHandle};

/// The outcome of a save.
pub type Saved = Result<(), FileError>;

/// Does one job with files at a time, on a thread of its own. Dropped, it waits for it.
#[derive(Debug)]
pub struct Saver<T> {
    job: Option<JoinHandle<Result<T, FileError>>>,
}

impl<T> Default for Saver<T> {
    fn default() -> Self {
        Saver { job: None }
    }
}

impl<T: Send + 'static> Saver<T> {
    /// Begins a job, if there is none whose outcome has yet to be asked for.
    pub fn begin(&mut self, job: impl FnOnce() -> Result<T, FileError> + Send + 'static) {
        if !self.is_busy() {
            self.job = Some(thread::spawn(job));
        }
    }
}

impl<T> Saver<T> {
    /// Whether a job was begun whose outcome nobody has asked for.
    pub fn is_busy(&self) -> bool {
        self.job.is_some()
    }

    /// What became of the job, once, when it is over.
    pub fn outcome(&mut self) -> Option<Result<T, FileError>> {
        let is_over = self.job.as_ref().is_some_and(JoinHandle::is_finished);
        if is_over { self.wait() } else { None }
    }

    /// Waits for the job; what became of it, unless that was told before.
    pub fn wait(&mut self) -> Option<Result<T, FileError>> {
        self.job.take()?.join().ok()
    }
}

impl<T> Drop for Saver<T> {
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
    fn one_job_at_a_time_and_its_outcome_once() {
        let folder = std::env::temp_dir().join(format!("edgewalker-saver-{}", std::process::id()));
        let path = folder.join("made/file");
        let mut saver = Saver::default();
        assert!(saver.outcome().is_none(), "nothing was saved");
        for number in 0..20 {
            assert!(!saver.is_busy());
            let path = path.clone();
            saver.begin(move || write(&path, &number.to_string()).map(|()| number));
            saver.begin(|| Ok(99));
            assert_eq!(saver.wait().unwrap().unwrap(), number);
            assert!(saver.wait().is_none(), "told once");
        }
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "19");
        let inside = path.join("in a file");
        saver.begin(move || write(&inside, "").map(|()| 0));
        let why = saver.wait().unwrap().unwrap_err().to_string();
        assert!(why.contains("in a file: cannot be saved"), "{why}");
        let late = path.clone();
        saver.begin(move || write(&late, "late").map(|()| 0));
        drop(saver);
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "late");
        std::fs::remove_dir_all(folder).unwrap();
    }
}
