//! The files of settings and progress. A broken one is set aside and told of, one of a newer game is left alone, and nothing
//! that goes wrong with them keeps anybody from playing.

use super::fields::{Complaints, Fields};
use super::lock::Turn;
use super::progress::{self, Progress};
use super::saver::{self, Saved, Saver};
use super::values::{self, Settings};
use crate::cli::files::{self, FileError};
use ron::ser::PrettyConfig;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

const SETTINGS_FILE: &str = "settings.ron";
const PROGRESS_FILE: &str = "progress.ron";
/// How many broken files are kept beside the good one.
const MOST_BROKEN: u32 = 99;

/// The part of a file that every version has.
#[derive(Deserialize)]
struct Header {
    version: u32,
}

/// What is kept in a file.
trait Document: Sized + Default {
    const FILE: &'static str;
    const VERSION: u32;

    /// From a text of this version; complains about single values.
    fn read(text: &str, complaints: &mut Complaints) -> Result<Self, String>;
    fn write(&self) -> Result<String, ron::Error>;
}

/// The settings with the version before them, as they are written.
#[derive(Serialize)]
#[serde(rename = "Settings")]
struct Versioned<'a> {
    version: u32,
    video: &'a values::Video,
    audio: &'a values::Audio,
    controls: &'a values::Hands,
    accessibility: &'a values::Access,
}

impl Document for Settings {
    const FILE: &'static str = SETTINGS_FILE;
    const VERSION: u32 = values::VERSION;

    fn read(text: &str, complaints: &mut Complaints) -> Result<Settings, String> {
        let fields: Fields = ron::from_str(text).map_err(|e| e.to_string())?;
        Ok(Settings::read(fields, complaints))
    }

    fn write(&self) -> Result<String, ron::Error> {
        pretty(&Versioned {
            version: values::VERSION,
            video: &self.video,
            audio: &self.audio,
            controls: &self.controls,
            accessibility: &self.accessibility,
        })
    }
}

impl Document for Progress {
    const FILE: &'static str = PROGRESS_FILE;
    const VERSION: u32 = progress::VERSION;

    fn read(text: &str, complaints: &mut Complaints) -> Result<Progress, String> {
        let mut progress: Progress = ron::from_str(text).map_err(|e| e.to_string())?;
        progress.mend(complaints);
        Ok(progress)
    }

    fn write(&self) -> Result<String, ron::Error> {
        pretty(&Progress {
            version: progress::VERSION,
            ..self.clone()
        })
    }
}

fn pretty(value: &impl Serialize) -> Result<String, ron::Error> {
    ron::ser::to_string_pretty(value, PrettyConfig::new().new_line("\n")).map(|text| text + "\n")
}

/// Both documents, and where they are kept. Several games may keep theirs in one place: each save reads what the others have
/// saved, and brings both together.
#[derive(Debug, Default)]
pub struct Store {
    /// As they are saved; what the command line says for one run is not among them.
    pub settings: Settings,
    /// What has been reached.
    pub progress: Progress,
    /// Both as they were last in their files.
    known: (Settings, Progress),
    settings_file: Option<PathBuf>,
    progress_file: Option<PathBuf>,
    saver: Saver<Progress>,
    /// The progress that is being saved.
    handed: Progress,
    /// It has changed since.
    is_waiting: bool,
}

impl Store {
    /// Reads the files of a folder, which need not be there; says what was wrong with them. Without a folder nothing is kept.
    pub fn open(folder: Option<&Path>) -> (Store, Vec<String>) {
        let Some(folder) = folder else {
            return (Store::default(), Vec::new());
        };
        let mut said = Vec::new();
        let turn = Turn::at(folder);
        if turn.is_alone() {
            remove_halves(folder);
        }
        let (settings, settings_file) = load::<Settings>(folder, &mut said);
        let (progress, progress_file) = load::<Progress>(folder, &mut said);
        let store = Store {
            known: (settings.clone(), progress.clone()),
            settings,
            progress,
            settings_file,
            progress_file,
            ..Store::default()
        };
        (store, said)
    }

    /// Writes the settings: those that were changed here, and those that other games have changed.
    ///
    /// # Errors
    /// The file cannot be written; the game goes on with what it has.
    pub fn save_settings(&mut self) -> Result<(), FileError> {
        let Some(path) = &self.settings_file else {
            return Ok(());
        };
        let (own, base) = (&self.settings, &self.known.0);
        let saved = sync(path, |found: Option<Settings>| match found {
            Some(mut theirs) => {
                theirs.adopt(base, own);
                theirs
            }
            None => own.clone(),
        })?;
        self.known.0 = saved.clone();
        self.settings = saved;
        Ok(())
    }

    /// Begins to write what has been reached, here and in other games, beside the game that goes on. While that lasts, what
    /// is saved next waits.
    pub fn save_progress(&mut self) {
        let Some(path) = self.progress_file.clone() else {
            return;
        };
        self.is_waiting = self.saver.is_busy();
        if self.is_waiting {
            return;
        }
        self.handed = self.progress.clone();
        let (own, base) = (self.handed.clone(), self.known.1.clone());
        self.saver.begin(move || {
            sync(&path, |found: Option<Progress>| match found {
                Some(theirs) => Progress::merged(&base, &own, &theirs),
                None => own,
            })
        });
    }

    /// What became of the progress that was saved last, once, when it is over.
    pub fn saved(&mut self) -> Option<Saved> {
        let outcome = self.saver.outcome()?;
        let saved = self.take(outcome);
        if self.is_waiting {
            self.save_progress();
        }
        Some(saved)
    }

    /// Waits until the progress is saved; what became of it, unless that was told before.
    pub fn settle(&mut self) -> Option<Saved> {
        let mut last = None;
        while let Some(outcome) = self.saver.wait() {
            last = Some(self.take(outcome));
            if std::mem::take(&mut self.is_waiting) {
                self.save_progress();
            }
        }
        last
    }

    /// Takes over what is in the file now, beside what has been reached since it was handed over.
    fn take(&mut self, outcome: Result<Progress, FileError>) -> Saved {
        let saved = outcome?;
        self.progress = Progress::merged(&self.handed, &self.progress, &saved);
        self.known.1 = saved;
        Ok(())
    }
}

/// Brings a file up to date in one turn: reads what is there, gives it away, and writes what comes back if that is something
/// else. A file that is not there, or broken, is nothing.
fn sync<T: Document + PartialEq>(
    path: &Path,
    merge: impl FnOnce(Option<T>) -> T,
) -> Result<T, FileError> {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder)
        .map_err(|e| FileError::new(path, format!("cannot be saved: {e}")))?;
    let _turn = Turn::at(folder);
    let found = match read::<T>(path, &mut Complaints::new()) {
        Ok(found) => found,
        Err(Unread::Newer(_)) => {
            let reason = "was written by a newer game: it is left as it is, and nothing is saved";
            return Err(FileError::new(path, reason));
        }
        Err(Unread::Broken(reason)) => {
            let aside = set_aside(path);
            aside.map_err(|e| FileError::new(path, format!("{reason}; it stays ({e})")))?;
            None
        }
    };
    let before = found.as_ref().map(|found| text_of(found, path));
    let merged = merge(found);
    let text = text_of(&merged, path)?;
    if before.and_then(Result::ok).as_ref() != Some(&text) {
        saver::write(path, &text)?;
    }
    Ok(merged)
}

/// Why there is nothing of a document.
enum Unread {
    /// Its version, which this game does not know.
    Newer(u32),
    /// What is wrong.
    Broken(String),
}

/// A document from its file, if there is one.
fn read<T: Document>(path: &Path, complaints: &mut Complaints) -> Result<Option<T>, Unread> {
    if !path.exists() {
        return Ok(None);
    }
    let broken = |reason: String| Unread::Broken(reason);
    let text = files::read_text(path).map_err(|e| broken(e.to_string()))?;
    let Header { version } = ron::from_str(&text).map_err(|e| broken(at(path, &e)))?;
    if version > T::VERSION {
        return Err(Unread::Newer(version));
    }
    let read = T::read(&text, complaints);
    read.map(Some).map_err(|e| broken(at(path, &e)))
}

/// A document from its file, and the file if it may be written.
fn load<T: Document>(folder: &Path, said: &mut Vec<String>) -> (T, Option<PathBuf>) {
    let path = folder.join(T::FILE);
    let mut complaints = Complaints::new();
    let read = read::<T>(&path, &mut complaints);
    said.extend(complaints.iter().map(|complaint| at(&path, complaint)));
    match read {
        Ok(document) => (document.unwrap_or_default(), Some(path)),
        Err(Unread::Newer(version)) => {
            let known = T::VERSION;
            let reason = format!(
                "is of version {version}, this game knows up to {known}: it is left as it is, and nothing is saved"
            );
            said.push(at(&path, &reason));
            (T::default(), None)
        }
        Err(Unread::Broken(reason)) => {
            let (kept, may_write) = match set_aside(&path) {
                Ok(aside) => (format!("kept as {}", aside.display()), true),
                Err(e) => (format!("it stays, and nothing is saved ({e})"), false),
            };
            said.push(format!("{reason}; {kept}"));
            (T::default(), may_write.then_some(path))
        }
    }
}

/// Removes what games have left that were stopped while they wrote. Only in a turn, when nobody else writes.
fn remove_halves(folder: &Path) {
    let is_half = |name: &str| {
        let mut files = [SETTINGS_FILE, PROGRESS_FILE].into_iter();
        files.any(|file| name.starts_with(&format!(".{file}.")) && name.ends_with(".tmp"))
    };
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.file_name().to_str().is_some_and(is_half) {
            // What cannot be removed is in nobody's way.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

fn at(path: &Path, reason: &impl std::fmt::Display) -> String {
    format!("{}: {reason}", path.display())
}

/// Gives a broken file another name, so that nothing in it is lost.
fn set_aside(path: &Path) -> std::io::Result<PathBuf> {
    let named = |number: u32| {
        let mut name = path.as_os_str().to_owned();
        name.push(format!(".broken-{number}"));
        PathBuf::from(name)
    };
    let free = (1..=MOST_BROKEN).map(named).find(|aside| !aside.exists());
    let aside = free.unwrap_or_else(|| named(MOST_BROKEN));
    std::fs::rename(path, &aside)?;
    Ok(aside)
}

fn text_of<T: Document>(document: &T, path: &Path) -> Result<String, FileError> {
    let failed = |e: ron::Error| FileError::new(path, format!("cannot be saved: {e}"));
    document.write().map_err(failed)
}

#[cfg(test)]
mod tests;
