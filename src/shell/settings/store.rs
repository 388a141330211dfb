//! The files of settings and progress. A broken one is set aside and told of, one of a newer game is left alone, and nothing
//! that goes wrong with them keeps anybody from playing.

use super::fields::{Complaints, Fields};
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

/// Both documents, and where they are kept.
#[derive(Debug, Default)]
pub struct Store {
    /// As they are saved; what the command line says for one run is not among them.
    pub settings: Settings,
    /// What has been reached.
    pub progress: Progress,
    settings_file: Option<PathBuf>,
    progress_file: Option<PathBuf>,
    saver: Saver,
}

impl Store {
    /// Reads the files of a folder, which need not be there; says what was wrong with them. Without a folder nothing is kept.
    pub fn open(folder: Option<&Path>) -> (Store, Vec<String>) {
        let Some(folder) = folder else {
            return (Store::default(), Vec::new());
        };
        let mut said = Vec::new();
        let (settings, settings_file) = load(folder, &mut said);
        let (progress, progress_file) = load(folder, &mut said);
        let store = Store {
            settings,
            progress,
            settings_file,
            progress_file,
            saver: Saver::default(),
        };
        (store, said)
    }

    /// Writes the settings.
    ///
    /// # Errors
    /// The file cannot be written; the game goes on with what it has.
    pub fn save_settings(&self) -> Result<(), FileError> {
        save(&self.settings, self.settings_file.as_deref())
    }

    /// Begins to write what has been reached, beside the game that goes on.
    ///
    /// # Errors
    /// It cannot be told as text. What becomes of the file is [`saved`](Self::saved).
    pub fn save_progress(&mut self) -> Result<(), FileError> {
        if let Some(path) = &self.progress_file {
            let text = text_of(&self.progress, path)?;
            self.saver.save(path.clone(), text);
        }
        Ok(())
    }

    /// What became of the progress that was saved last, once, when it is over.
    pub fn saved(&mut self) -> Option<Saved> {
        self.saver.outcome()
    }

    /// Waits until the progress is saved; what became of it, unless that was told before.
    pub fn settle(&mut self) -> Option<Saved> {
        self.saver.wait()
    }
}

/// A document from its file, and the file if it may be written.
fn load<T: Document>(folder: &Path, said: &mut Vec<String>) -> (T, Option<PathBuf>) {
    let path = folder.join(T::FILE);
    if !path.exists() {
        return (T::default(), Some(path));
    }
    let mut complaints = Complaints::new();
    let read = files::read_text(&path).map_err(|e| e.to_string());
    let read = read.and_then(|text| {
        let Header { version } = ron::from_str(&text).map_err(|e| at(&path, &e))?;
        if version > T::VERSION {
            return Ok(Err(version));
        }
        let read = T::read(&text, &mut complaints);
        read.map(Ok).map_err(|e| at(&path, &e))
    });
    said.extend(complaints.iter().map(|complaint| at(&path, complaint)));
    match read {
        Ok(Ok(document)) => (document, Some(path)),
        Ok(Err(version)) => {
            let known = T::VERSION;
            let reason = format!(
                "is of version {version}, this game knows up to {known}: it is left as it is, and nothing is saved"
            );
            said.push(at(&path, &reason));
            (T::default(), None)
        }
        Err(reason) => {
            let (kept, may_write) = match set_aside(&path) {
                Ok(aside) => (format!("kept as {}", aside.display()), true),
                Err(e) => (format!("it stays, and nothing is saved ({e})"), false),
            };
            said.push(format!("{reason}; {kept}"));
            (T::default(), may_write.then_some(path))
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

/// Writes a document, making its folder if need be.
fn save<T: Document>(document: &T, path: Option<&Path>) -> Result<(), FileError> {
    let Some(path) = path else { return Ok(()) };
    saver::write(path, &text_of(document, path)?)
}

fn text_of<T: Document>(document: &T, path: &Path) -> Result<String, FileError> {
    let failed = |e: ron::Error| FileError::new(path, format!("cannot be saved: {e}"));
    document.write().map_err(failed)
}

#[cfg(test)]
mod tests;
