//! Files as the program touches them: found in three places, read whole, written whole or not at all.

use crate::level;
use std::path::{Path, PathBuf};

/// What went wrong with which file.
#[derive(Debug)]
pub struct FileError {
    path: PathBuf,
    reason: String,
}

impl FileError {
    /// An error of this file.
    pub fn new(path: &Path, reason: impl Into<String>) -> FileError {
        FileError {
            path: path.to_path_buf(),
            reason: reason.into(),
        }
    }
}

impl std::fmt::Display for FileError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.reason)
    }
}

impl std::error::Error for FileError {}

/// Set while a release is built: a program that goes elsewhere knows nothing of the tree that it was built from.
const IS_PACKAGED: bool = option_env!("EDGEWALKER_PACKAGED").is_some();

/// Where a file or folder of the game is: as given from the current directory, else next to the program, else
/// in the source tree that the program was built from. A path found nowhere comes back as it was given.
pub fn find(path: &Path) -> PathBuf {
    let beside = std::env::current_exe()
        .ok()
        .and_then(|exe| Some(exe.parent()?.join(path)));
    let source = (!IS_PACKAGED).then(|| Path::new(env!("CARGO_MANIFEST_DIR")).join(path));
    let candidates = [Some(path.to_path_buf()), beside, source];
    candidates
        .into_iter()
        .flatten()
        .find(|p| p.exists())
        .unwrap_or_else(|| path.to_path_buf())
}

/// The whole text of a file, without the byte order mark that some editors put first.
///
/// # Errors
/// As [`read`], or the file is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, FileError> {
    let bytes = read(path)?;
    let text =
        String::from_utf8(bytes).map_err(|_| FileError::new(path, "is not a text file (UTF-8)"))?;
    Ok(level::without_mark(&text).to_owned())
}

/// The whole content of a file.
///
/// # Errors
/// The file is missing, not readable, or something else: a directory, a pipe, a device.
pub fn read(path: &Path) -> Result<Vec<u8>, FileError> {
    level::read(path).map_err(|e| FileError::new(path, io_reason(&e)))
}

/// Writes a file so that at any moment there is either the old or the new content, never half of it.
///
/// # Errors
/// The folder is missing or not writable, the disk is full, or the path is no file.
pub fn write_atomic(path: &Path, content: &[u8]) -> Result<(), FileError> {
    level::write_atomically(path, content).map_err(|e| FileError::new(path, io_reason(&e)))
}

/// Finds out now whether [`write_atomic`] could write there later.
///
/// # Errors
/// As [`write_atomic`].
pub fn check_writable(path: &Path) -> Result<(), FileError> {
    level::check_writable(path)
        .map_err(|e| FileError::new(path, format!("cannot be written: {}", io_reason(&e))))
}

fn io_reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "not found".into(),
        std::io::ErrorKind::PermissionDenied => "permission denied".into(),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_written_file_reads_back_and_leaves_nothing_beside_it() {
        let folder = std::env::temp_dir().join(format!("edgewalker-files-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("a.ron");
        check_writable(&path).unwrap();
        assert!(!path.exists());
        write_atomic(&path, b"old").unwrap();
        write_atomic(&path, b"new").unwrap();
        assert_eq!(read_text(&path).unwrap(), "new");
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        write_atomic(&path, "\u{feff}marked".as_bytes()).unwrap();
        assert_eq!(read_text(&path).unwrap(), "marked");
        write_atomic(&path, b"\xff\xfe").unwrap();
        assert!(
            read_text(&path)
                .unwrap_err()
                .to_string()
                .ends_with("a.ron: is not a text file (UTF-8)")
        );
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn what_cannot_be_read_or_written_says_why() {
        let nowhere = Path::new("no/such/folder/file");
        assert_eq!(
            read(nowhere).unwrap_err().to_string(),
            "no/such/folder/file: not found"
        );
        assert!(
            check_writable(nowhere)
                .unwrap_err()
                .to_string()
                .contains("cannot be written: not found")
        );
        assert!(write_atomic(nowhere, b"").is_err());
        assert_eq!(
            read(Path::new("/")).unwrap_err().to_string(),
            "/: is a directory, not a file"
        );
    }

    /// What is found out before a recording holds for its end.
    #[test]
    fn what_is_no_name_of_a_file_is_refused_at_once() {
        let folder = std::env::temp_dir().join(format!("edgewalker-names-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        for name in [
            Path::new(""),
            &folder.join("new/"),
            &folder.join(".."),
            &folder,
        ] {
            let refused = check_writable(name).unwrap_err().to_string();
            assert!(refused.contains("cannot be written: is "), "{refused}");
            assert!(write_atomic(name, b"").is_err(), "{name:?}");
        }
        fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn links_are_written_through_and_sockets_left_alone() {
        let folder = std::env::temp_dir().join(format!("edgewalker-links-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let (file, link, socket) = (folder.join("f"), folder.join("l"), folder.join("s"));
        fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write_atomic(&link, b"new").unwrap();
        assert!(link.is_symlink());
        assert_eq!(read_text(&file).unwrap(), "new");
        let _listener = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        for error in [
            check_writable(&socket),
            write_atomic(&socket, b""),
            read(&socket).map(drop),
        ] {
            let message = error.unwrap_err().to_string();
            assert!(message.ends_with("is not a regular file"), "{message}");
        }
        assert!(!fs::metadata(&socket).unwrap().is_file());
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn the_source_tree_is_the_last_place_to_look() {
        assert!(find(Path::new("Cargo.toml")).is_file());
        assert_eq!(find(Path::new("no/such/file")), Path::new("no/such/file"));
    }
}
