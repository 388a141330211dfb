//! The levels there are to choose from.

use crate::cli::files;
use crate::level;
use std::fs;
use std::path::{Path, PathBuf};

/// Folders with levels, those for players first.
const FOLDERS: &[&str] = &["levels", "levels/dev"];

/// Files beside the levels that hold the tuning for one of them end like this.
const TUNING: &str = ".tuning.ron";

/// A level that players may choose.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// Its file.
    pub path: PathBuf,
    /// What progress knows it by: the file's name.
    pub key: String,
    /// What players call it.
    pub name: String,
}

/// The levels for players, one that is named before all others; those that cannot be read are left out.
pub fn for_players(first: &Path) -> Vec<Choice> {
    let mut paths = in_folder(&files::find(Path::new(FOLDERS[0])));
    paths.sort_by_key(|path| path.file_name() != first.file_name());
    let choice = |path: PathBuf| {
        let name = level::load(&path).ok()?.name;
        let key = path.file_stem()?.to_string_lossy().into_owned();
        Some(Choice { path, key, name })
    };
    paths.into_iter().filter_map(choice).collect()
}

/// All level files, by folder and name.
pub fn list() -> Vec<PathBuf> {
    FOLDERS
        .iter()
        .flat_map(|folder| in_folder(&files::find(Path::new(folder))))
        .collect()
}

/// The tuning that lies beside a level for it, if there is one.
pub fn tuning_of(level: &Path) -> Option<PathBuf> {
    let path = level.with_extension(&TUNING[1..]);
    path.is_file().then_some(path)
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
    fn the_gym_has_its_tuning_and_the_quarry_has_none() {
        let find = |level: &str| tuning_of(&files::find(Path::new(level)));
        let gym = find("levels/dev/gym.ron");
        assert!(gym.is_some_and(|path| path.ends_with("levels/dev/gym.tuning.ron")));
        assert_eq!(find("levels/quarry.ron"), None);
    }

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
