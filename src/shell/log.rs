//! The inputs of the run, kept as they come: a recording is written by a thread of its own at every beat, so that neither a
//! kill nor a crash nor a picture that hangs loses more than that, and a fault of the game leaves what led to it.

use crate::cli::files::{self, FileError};
use crate::game::replay::LONGEST;
use crate::game::{Input, Replay};
use crate::tune::Tuning;
use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// Time between two writes: what a kill loses at most, beside the time of a write.
const BEAT: Duration = Duration::from_millis(400);

/// What a lock guards is whole even if its holder has failed: each change of it is one.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The inputs of a run so far. A replay holds one tuning and one level: when they change, the log ends there.
#[derive(Debug)]
pub struct Log(Mutex<Inputs>);

#[derive(Debug)]
struct Inputs {
    replay: Replay,
    ticks: u64,
    ended: Option<&'static str>,
}

impl Log {
    /// Of a run that begins as a replay does, and has its inputs.
    pub fn of(replay: Replay) -> Arc<Log> {
        let ticks = replay.ticks();
        Arc::new(Log(Mutex::new(Inputs {
            replay,
            ticks,
            ended: None,
        })))
    }

    /// Adds the input of a tick; whether that ended the log, since no replay may be longer.
    pub fn push(&self, input: Input) -> bool {
        let mut inputs = locked(&self.0);
        if inputs.ended.is_some() {
            return false;
        }
        if inputs.ticks >= LONGEST {
            inputs.ended = Some("it was as long as a replay may be");
            return true;
        }
        inputs.ticks += 1;
        inputs.replay.push(input);
        false
    }

    /// The motion changes. Before the first tick that is where the run begins. Returns whether this ended the log.
    pub fn retune(&self, tuning: &Tuning) -> bool {
        let mut inputs = locked(&self.0);
        if inputs.ticks == 0 {
            inputs.replay.tuning = tuning.clone();
        }
        let changes = inputs.replay.tuning.motion != tuning.motion;
        drop(inputs);
        changes && self.end("the tuning was changed")
    }

    /// Ends the log; returns whether it was still going on.
    pub fn end(&self, reason: &'static str) -> bool {
        let mut inputs = locked(&self.0);
        let was_going_on = inputs.ended.is_none();
        inputs.ended.get_or_insert(reason);
        was_going_on
    }

    /// Whether it goes on.
    pub fn goes_on(&self) -> bool {
        locked(&self.0).ended.is_none()
    }

    /// How many ticks it has.
    pub fn ticks(&self) -> u64 {
        locked(&self.0).ticks
    }

    /// Writes it as a replay; says what was written.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, path: &Path) -> Result<String, FileError> {
        let inputs = locked(&self.0);
        let (text, ticks) = (inputs.replay.to_text(), inputs.ticks);
        let reason = inputs
            .ended
            .map(|reason| format!(" (ended when {reason})"))
            .unwrap_or_default();
        drop(inputs);
        files::write_atomic(path, text.as_bytes())?;
        Ok(format!("{ticks} ticks to {}{reason}", path.display()))
    }
}

/// A file that holds a log up to some moment: at any time it is a whole replay.
#[derive(Debug)]
struct Page {
    path: PathBuf,
    file: Option<File>,
    /// Ticks that are written.
    ticks: u64,
    /// The last entry that is written, which may still grow, and the byte where its line begins.
    open: (usize, u64),
    /// Why the last write failed, until that was told.
    failed: Option<FileError>,
}

impl Page {
    /// Brings the file up to date. A failure is kept to be told; the next beat tries again.
    fn flush(&mut self, log: &Log) {
        self.failed = match self.file {
            None => self.begin(log).err(),
            Some(_) => self
                .go_on(log)
                .map_err(|e| FileError::new(&self.path, format!("cannot be written: {e}")))
                .err(),
        };
    }

    /// The first write, when there is something to write: what was there before is replaced in one step.
    fn begin(&mut self, log: &Log) -> Result<(), FileError> {
        let inputs = locked(&log.0);
        if inputs.ticks == 0 {
            return Ok(());
        }
        let ticks = inputs.ticks;
        let open = inputs.replay.inputs.len() - 1;
        let text = inputs.replay.to_text();
        let at = text.len() - inputs.replay.tail(open).len();
        drop(inputs);
        files::write_atomic(&self.path, text.as_bytes())?;
        let file = File::options().write(true).open(&self.path);
        self.file = Some(file.map_err(|e| FileError::new(&self.path, e.to_string()))?);
        (self.ticks, self.open) = (ticks, (open, at as u64));
        Ok(())
    }

    /// Puts the new end in the place of the old one, which is never longer, in one write.
    fn go_on(&mut self, log: &Log) -> io::Result<()> {
        let (Some(file), (open, at)) = (&mut self.file, self.open) else {
            return Ok(());
        };
        let inputs = locked(&log.0);
        if inputs.ticks == self.ticks {
            return Ok(());
        }
        let ticks = inputs.ticks;
        let last = inputs.replay.inputs.len() - 1;
        let (tail, end) = (inputs.replay.tail(open), inputs.replay.tail(last));
        drop(inputs);
        file.seek(SeekFrom::Start(at))?;
        file.write_all(tail.as_bytes())?;
        let ahead = (tail.len() - end.len()) as u64;
        (self.ticks, self.open) = (ticks, (last, at + ahead));
        Ok(())
    }
}

/// A run being recorded: its file follows the log at every beat.
#[derive(Debug)]
pub struct Recorder {
    log: Arc<Log>,
    page: Arc<Mutex<Page>>,
    beats: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Recorder {
    /// Begins to record into a file. What is there stays until the first tick.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn new(path: &Path, log: Arc<Log>) -> Result<Recorder, FileError> {
        files::check_writable(path)?;
        let page = Arc::new(Mutex::new(Page {
            path: path.to_path_buf(),
            file: None,
            ticks: 0,
            open: (0, 0),
            failed: None,
        }));
        let (stop, stopped) = channel();
        let (theirs, inputs) = (page.clone(), log.clone());
        let beats = thread::spawn(move || {
            while stopped.recv_timeout(BEAT) == Err(RecvTimeoutError::Timeout) {
                locked(&theirs).flush(&inputs);
            }
        });
        Ok(Recorder {
            log,
            page,
            beats: Some((stop, beats)),
        })
    }

    /// What is recorded.
    pub fn log(&self) -> &Log {
        &self.log
    }

    /// Why the file could not be written, once, if nobody is writing now.
    pub fn problem(&self) -> Option<FileError> {
        self.page.try_lock().ok()?.failed.take()
    }

    /// Ends the recording: writes the file whole; says what was written.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(mut self) -> Result<String, FileError> {
        self.stop();
        let path = locked(&self.page).path.clone();
        let said = self.log.write(&path)?;
        Ok(format!("recorded  {said}"))
    }

    fn stop(&mut self) {
        if let Some((stop, beats)) = self.beats.take() {
            drop(stop);
            let _ = beats.join();
        }
    }
}

/// Whoever does not come to write it, since something has failed, leaves all that there is.
impl Drop for Recorder {
    fn drop(&mut self) {
        if self.beats.is_some() {
            self.stop();
            locked(&self.page).flush(&self.log);
        }
    }
}

#[cfg(test)]
mod tests;
