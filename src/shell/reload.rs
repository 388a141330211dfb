//! Files that are read again when they change on disk. Polled: that loses no rename and needs no service.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Time between two looks at the disk.
const PERIOD: Duration = Duration::from_millis(250);

/// What tells one state of a file from another.
type Stamp = (PathBuf, SystemTime, u64);

/// A file, or all files of a folder, and how they were when last looked at.
#[derive(Debug)]
pub struct Watch {
    path: PathBuf,
    stamps: Vec<Stamp>,
}

impl Watch {
    /// Watches from now on; make it before reading the file, so that no change falls in between.
    pub fn new(path: &Path) -> Watch {
        Watch {
            path: path.to_path_buf(),
            stamps: stamps(path),
        }
    }

    /// The file or folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether something changed since the last call. A file that is gone is no change: an editor may be
    /// about to put the new one in its place.
    pub fn changed(&mut self) -> bool {
        let now = stamps(&self.path);
        if now.is_empty() || now == self.stamps {
            return false;
        }
        self.stamps = now;
        true
    }
}

fn stamps(path: &Path) -> Vec<Stamp> {
    let stamp = |path: PathBuf| -> Option<Stamp> {
        let meta = fs::metadata(&path).ok().filter(fs::Metadata::is_file)?;
        Some((path, meta.modified().ok()?, meta.len()))
    };
    let mut found: Vec<Stamp> = match fs::read_dir(path) {
        Ok(entries) => entries
            .filter_map(|entry| stamp(entry.ok()?.path()))
            .collect(),
        Err(_) => stamp(path.to_path_buf()).into_iter().collect(),
    };
    found.sort();
    found
}

/// Says when it is time to look at the disk.
#[derive(Debug, Default)]
pub struct Timer(Duration);

impl Timer {
    /// Lets time pass; true once per period.
    pub fn is_due(&mut self, elapsed: Duration) -> bool {
        self.0 += elapsed;
        let due = self.0 >= PERIOD;
        if due {
            self.0 = Duration::ZERO;
        }
        due
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_is_seen_once_and_a_missing_file_is_none() {
        let folder = std::env::temp_dir().join(format!("edgewalker-reload-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let file = folder.join("a");
        let (mut one, mut all) = (Watch::new(&file), Watch::new(&folder));
        assert!(!one.changed() && !all.changed());
        fs::write(&file, "1").unwrap();
        assert!(one.changed() && all.changed());
        assert!(!one.changed() && !all.changed());
        fs::write(&file, "22").unwrap();
        assert!(one.changed() && all.changed());
        fs::remove_file(&file).unwrap();
        assert!(!one.changed());
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn the_disk_is_looked_at_four_times_a_second() {
        let mut timer = Timer::default();
        let looks = (0..1000)
            .filter(|_| timer.is_due(Duration::from_millis(10)))
            .count();
        assert_eq!(looks, 40);
    }
}
