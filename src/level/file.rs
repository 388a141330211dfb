//! Reading and writing level files: the only place outside the shell that touches the disk.

use super::marks::Marks;
use super::{Flaw, Level, LevelError, VERSION, check};
use ron::ser::PrettyConfig;
use serde::Deserialize;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Largest file that is read, in bytes.
const LARGEST: u64 = 1 << 30;

/// Reads a level file and checks it.
///
/// # Errors
/// The file cannot be read, is not text, is not a level, or breaks a rule of [`check`].
pub fn load(path: &Path) -> Result<Level, LevelError> {
    let bytes = read(path).map_err(|error| whole_file(path, format!("cannot be read: {error}")))?;
    match std::str::from_utf8(&bytes) {
        Ok(text) => parse(text, path),
        Err(error) => {
            let message = format!(
                "is not UTF-8 text (byte {} of the file)",
                error.valid_up_to()
            );
            Err(whole_file(path, message))
        }
    }
}

/// Reads a level from text and checks it; `file` is only what errors call it.
///
/// # Errors
/// The text is not a level, or breaks a rule of [`check`].
pub fn parse(text: &str, file: &Path) -> Result<Level, LevelError> {
    let text = without_mark(text);
    if text.trim().is_empty() {
        return Err(whole_file(file, "is empty".into()));
    }
    let syntax = |error| syntax_error(text, file, error);
    // A newer version may have fields that this build does not know: its number is read first.
    let Header { version } = ron::from_str(text).map_err(syntax)?;
    if version == VERSION {
        let level: Level = ron::from_str(text).map_err(syntax)?;
        return check(&level)
            .map(|()| level)
            .map_err(|flaw| rule_error(text, file, flaw));
    }
    let message = format!("{version} is not supported; this build reads version {VERSION}");
    Err(rule_error(text, file, Flaw::of_level("version", message)))
}

/// Writes a level. Comments of the file that it replaces are lost.
///
/// # Errors
/// The level breaks a rule of [`check`], or the file cannot be written; it is then as it was before.
pub fn save(level: &Level, path: &Path) -> Result<(), LevelError> {
    check(level).map_err(|flaw| LevelError {
        line: None,
        ..rule_error("", path, flaw)
    })?;
    let text = ron::ser::to_string_pretty(level, PrettyConfig::new().new_line("\n"))
        .map_err(|error| whole_file(path, format!("cannot be put into words: {error}")))?;
    write_atomically(path, format!("{text}\n").as_bytes())
        .map_err(|error| whole_file(path, format!("cannot be written: {error}")))
}

/// The whole content of a file. A pipe would be waited for and a device may never end: neither is read.
///
/// # Errors
/// The file is missing, not readable, no regular file, or larger than a gibibyte.
pub fn read(path: &Path) -> io::Result<Vec<u8>> {
    let meta = fs::metadata(path)?;
    refuse_special(&meta)?;
    if meta.len() > LARGEST {
        let message = format!("has {} bytes; at most {LARGEST} are read", meta.len());
        return Err(io::Error::new(io::ErrorKind::InvalidData, message));
    }
    fs::read(path)
}

/// The text behind the byte order mark that some editors put first.
pub fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// Replaces a file in one step: whoever reads it sees the old bytes or the new, even after a crash. Of a link, what it
/// leads to.
///
/// # Errors
/// The directory or the file cannot be written, or it is no regular file; the old file is then untouched.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> io::Result<()> {
    replace(path, |file| file.write_all(bytes))
}

/// Replaces a file by what is written into another one beside it, of which nothing stays if that fails.
fn replace(path: &Path, write: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let path = &target(path)?;
    let temporary = temporary_beside(path)?;
    let written = File::create(&temporary).and_then(|mut file| {
        write(&mut file)?;
        file.sync_all()
    });
    let replaced = written.and_then(|()| fs::rename(&temporary, path));
    if replaced.is_err() {
        // Nothing more can be done if this fails as well; the first error is the one to report.
        let _ = fs::remove_file(&temporary);
    }
    replaced
}

/// Finds out now whether [`write_atomically`] could write there later.
///
/// # Errors
/// As [`write_atomically`].
pub fn check_writable(path: &Path) -> io::Result<()> {
    let temporary = temporary_beside(&target(path)?)?;
    File::create(&temporary).and_then(|_| fs::remove_file(&temporary))
}

/// Where to write, links followed. What is there already must be a file: to replace a device would break it.
fn target(path: &Path) -> io::Result<PathBuf> {
    if let Ok(meta) = fs::metadata(path) {
        refuse_special(&meta)?;
        return fs::canonicalize(path);
    }
    Ok(path.into())
}

fn refuse_special(meta: &fs::Metadata) -> io::Result<()> {
    let (kind, message) = match meta {
        m if m.is_file() => return Ok(()),
        m if m.is_dir() => (io::ErrorKind::IsADirectory, "is a directory, not a file"),
        _ => (io::ErrorKind::InvalidInput, "is not a regular file"),
    };
    Err(io::Error::new(kind, message))
}

/// The part of the format that every version has.
#[derive(Deserialize)]
#[serde(rename = "Level")]
struct Header {
    version: u32,
}

/// A name in the same directory, hence on the same disk, that no other running program uses.
fn temporary_beside(path: &Path) -> io::Result<PathBuf> {
    let is_folder = path.to_string_lossy().ends_with(std::path::is_separator);
    let Some(name) = path.file_name().filter(|_| !is_folder) else {
        return Err(io::Error::new(
            io::ErrorKind::InvalidInput,
            "is not the name of a file",
        ));
    };
    let mut temporary = std::ffi::OsString::from(".");
    temporary.push(name);
    temporary.push(format!(".{}.tmp", std::process::id()));
    Ok(path.with_file_name(temporary))
}

fn whole_file(file: &Path, message: String) -> LevelError {
    LevelError {
        file: file.into(),
        line: None,
        entity: None,
        field: None,
        message,
    }
}

fn syntax_error(text: &str, file: &Path, error: ron::error::SpannedError) -> LevelError {
    LevelError {
        file: file.into(),
        line: u32::try_from(error.span.start.line).ok(),
        entity: Marks::read(text).and_then(|marks| marks.entity(&error.span)),
        field: None,
        message: error.code.to_string(),
    }
}

fn rule_error(text: &str, file: &Path, flaw: Flaw) -> LevelError {
    LevelError {
        file: file.into(),
        line: Marks::read(text).and_then(|marks| marks.line(&flaw)),
        entity: Some(flaw.entity),
        field: Some(flaw.field),
        message: flaw.message,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A full disk leaves what was there, and nothing beside it.
    #[test]
    fn a_write_that_fails_leaves_nothing_behind() {
        let folder = std::env::temp_dir().join(format!("edgewalker-half-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("file");
        let full = |file: &mut File| {
            file.write_all(b"half")?;
            Err(io::Error::from(io::ErrorKind::StorageFull))
        };
        for before in [None, Some("old")] {
            if let Some(text) = before {
                fs::write(&path, text).unwrap();
            }
            let failed = replace(&path, full).unwrap_err();
            assert_eq!(failed.kind(), io::ErrorKind::StorageFull);
            assert_eq!(fs::read_to_string(&path).ok().as_deref(), before);
            let left = fs::read_dir(&folder).unwrap().count();
            assert_eq!(left, usize::from(before.is_some()), "files in the folder");
        }
        fs::remove_dir_all(folder).unwrap();
    }
}
