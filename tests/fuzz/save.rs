//! Failing runs as files: the run itself, and where the formats of the game can hold it, a level to look at in the game.

use super::case::{Build, Case};
use edgewalker::level::{self, Level, Rect};
use glam::DVec2;
use ron::ser::PrettyConfig;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Writes a run below `target/fuzz`, and its level to `levels/dev` if a level file says it all. Returns the files.
pub fn save(case: &Case) -> Vec<PathBuf> {
    let folder = root().join("target/fuzz");
    std::fs::create_dir_all(&folder).unwrap();
    let run = folder.join(format!("{}.ron", case.seed));
    let text = ron::ser::to_string_pretty(case, PrettyConfig::default()).unwrap();
    std::fs::write(&run, text).unwrap();
    let mut files = vec![run];
    let life = &case.life;
    if case.world.body == Build::Hero && life.edits.is_empty() && life.since == 0 {
        let file = root().join(format!("levels/dev/fuzz-{}.ron", case.seed));
        if level::check(&as_level(case)).is_ok() && level::save(&as_level(case), &file).is_ok() {
            files.push(file);
        }
    }
    files
}

/// Reads a run that was saved.
pub fn load(path: &Path) -> Case {
    let text = std::fs::read_to_string(path).unwrap();
    ron::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// All runs in a folder, in order of their names.
pub fn load_all(folder: &Path) -> Vec<(PathBuf, Case)> {
    let files = std::fs::read_dir(root().join(folder)).unwrap();
    let mut paths: Vec<PathBuf> = files.map(|f| f.unwrap().path()).collect();
    paths.sort();
    paths.into_iter().map(|p| (p.clone(), load(&p))).collect()
}

fn as_level(case: &Case) -> Level {
    let mut features = case.world.features.clone();
    let mut movers = case.world.movers.clone();
    for (i, feature) in features.iter_mut().enumerate() {
        feature.id = format!("feature {i}");
    }
    for (i, mover) in movers.iter_mut().enumerate() {
        mover.id = format!("mover {i}");
        for (j, feature) in mover.features.iter_mut().enumerate() {
            feature.id = format!("mover {i} part {j}");
        }
    }
    Level {
        version: level::VERSION,
        name: format!("Fuzz {}", case.seed),
        start: case.life.start,
        goal: Rect {
            min: DVec2::splat(100.0),
            max: DVec2::splat(101.0),
        },
        bottom: -60.0,
        features,
        movers,
        areas: Vec::new(),
        frames: Vec::new(),
        prompts: Vec::new(),
        scenery: Vec::new(),
    }
}
