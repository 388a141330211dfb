//! Levels as data: what a level file says, and nothing of how it is played or drawn.
//!
//! A file is read by [`load`], which checks everything once ([`check`]); after that a [`Level`] is
//! trusted. Lengths are metres, y points up, and the plane of play is depth 0; what decimals of them mean is said in
//! [`crate::geom::drawn`], and nowhere else. Features may overlap,
//! touch and lie inside each other; what is absent on purpose: tiles, layers, holes, and any
//! number that is a matter of feel (those are in [`crate::tune`]).

mod check;
mod error;
mod feature;
mod file;
mod marks;
mod mover;
mod place;
mod scenery;

pub use check::{COORDINATE_LIMIT, CORNER_LIMIT, check, check_feature};
pub use error::{Entity, Flaw, LevelError};
pub use feature::{By, Concave, Feature, Kind, Material};
pub use file::{check_writable, load, parse, read, save, without_mark, write_atomically};
pub use mover::{Call, Easing, End, Mover, Repeat, Starts, Stop, is_upright};
pub use place::{Area, Frame, Mood, Prompt, Skill};
pub use scenery::{Scenery, SceneryKind};

use crate::geom::{Drawn, STEP};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The version of the format that this build reads and writes.
pub const VERSION: u32 = 1;

/// A level file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Level {
    /// Version of the format: [`VERSION`].
    pub version: u32,
    /// What players call it.
    pub name: String,
    /// Where the hero's foot starts, in metres.
    pub start: DVec2,
    /// Reaching this box with the foot ends the level.
    pub goal: Rect,
    /// A body below this height has fallen out of the level, in metres.
    pub bottom: f64,
    /// Its parts that have a name and a mood.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub areas: Vec<Area>,
    /// What the camera frames.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub frames: Vec<Frame>,
    /// Where the player is told how something is done.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub prompts: Vec<Prompt>,
    /// The terrain, and the regions that do something to the hero.
    pub features: Vec<Feature>,
    /// Features that move.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub movers: Vec<Mover>,
    /// Things that are seen and not touched.
    #[serde(default)]
    pub scenery: Vec<Scenery>,
}

/// An axis-aligned box, in metres.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rect {
    /// Lower left corner.
    pub min: DVec2,
    /// Upper right corner.
    pub max: DVec2,
}

impl Rect {
    /// Whether a point is inside or on the rim, on the grid: who stands on a floor is in what begins at its height.
    pub fn contains(&self, p: DVec2) -> bool {
        let step = DVec2::splat(STEP);
        if p.cmplt(self.min - step).any() || p.cmpgt(self.max + step).any() {
            return false;
        }
        if p.cmpgt(self.min + step).all() && p.cmplt(self.max - step).all() {
            return true;
        }
        let [p, min, max] = [p, self.min, self.max].map(|p| Drawn::of(p).map(Drawn::point));
        let Some(((p, min), max)) = p.zip(min).zip(max) else {
            return false;
        };
        (min.x..=max.x).contains(&p.x) && (min.y..=max.y).contains(&p.y)
    }
}
