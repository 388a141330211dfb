//! Levels as data: what a level file says, and nothing of how it is played or drawn.
//!
//! A file is read by [`load`], which checks everything once ([`check`]); after that a [`Level`] is
//! trusted. Lengths are metres, y points up, and the plane of play is depth 0. Features may overlap,
//! touch and lie inside each other; what is absent on purpose: tiles, layers, holes, and any
//! number that is a matter of feel (those are in [`crate::tune`]).

mod check;
mod error;
mod file;
mod marks;

pub use check::{COORDINATE_LIMIT, CORNER_LIMIT, check};
pub use error::{Entity, Flaw, LevelError};
pub use file::{check_writable, load, parse, read, save, without_mark, write_atomically};

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
    /// The terrain.
    pub features: Vec<Feature>,
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
    /// Whether a point is inside or on the rim.
    pub fn contains(&self, p: DVec2) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }
}

/// A piece of terrain: a simple closed outline, counter-clockwise or clockwise, in metres.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Feature {
    /// Unique name.
    pub id: String,
    /// What it is made of: how it looks and sounds.
    pub material: Material,
    /// Corners; the last one is joined to the first.
    pub outline: Vec<DVec2>,
}

/// What a feature is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Material {
    /// The quarry's own rock.
    #[default]
    Rock,
    /// Dressed stone blocks.
    Masonry,
    /// Beams and planks.
    Timber,
    /// Rusted machinery.
    Iron,
}

/// A thing that is seen and not touched.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scenery {
    /// What it is.
    pub kind: SceneryKind,
    /// Its foot, in metres, in the plane of play.
    pub at: DVec2,
    /// How far behind (negative) or in front of the plane of play, in metres.
    #[serde(default)]
    pub depth: f64,
    /// Size, as a multiple of its usual one.
    #[serde(default = "one")]
    pub scale: f64,
}

fn one() -> f64 {
    1.0
}

/// Kinds of scenery.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum SceneryKind {
    /// A lamp on a post that lights its surroundings.
    Lantern,
    /// A standing or broken column.
    Pillar,
    /// A square tower in the distance.
    Tower,
    /// A wooden crane of the quarry.
    Crane,
    /// A tuft of grass or a bush.
    Plant,
    /// A hanging cloth.
    Banner,
}
