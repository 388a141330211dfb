//! The levels there are to choose from.

use crate::cli::files;
use std::fs;
use std::path::{Path, PathBuf};

/// Folders with levels, those for players first.
const FOLDERS: &[&str] = &["levels", "levels/dev"];

/// Files beside the levels that hold the tuning for one of them end like this.
const TUNING: &str = ".tuning.ron";

/// All level files, by folder and name.
pub fn list() -> Vec<PathBuf> {
    FOLDERS
        .iter()
        .flat_map(|folder| in_folder(&files::find(Path::new(folder))))
        .collect()
}

fn in_folder(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let is_level = |path: &PathBuf| {
        let name = path.to_string_lossy();
        name.ends_with(".ron") && !name.ends_with(TUNING)
    };
    let mut levels: Vec<PathBuf> = paths.filter(is_level).collect();
    levels.sort();
    levels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shipped_levels_are_found_in_order() {
        let levels = list();
        assert!(
            levels
                .iter()
                .any(|path| path.ends_with("levels/dev/flat.ron"))
        );
        let (game, dev): (Vec<_>, Vec<_>) = levels
            .iter()
            .partition(|path| !path.to_string_lossy().contains("/dev/"));
        assert!(game.is_sorted() && dev.is_sorted());
    }
}
