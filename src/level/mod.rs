//! Levels as data: CONTRACT (skeleton).

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A level file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Level {
    /// Version of the format.
    pub version: u32,
    /// What players call it.
    pub name: String,
    /// Where the hero's foot starts, in metres.
    pub start: DVec2,
    /// Reaching this box with the foot ends the level.
    pub goal: Rect,
    /// A body below this height has fallen out of the level.
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

/// A piece of terrain: a simple closed outline, counter-clockwise or clockwise, in metres.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Feature {
    /// Unique name.
    pub id: String,
    /// What it is made of: how it looks and sounds.
    pub material: Material,
    /// Corners.
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
    /// How far behind (negative) or in front of the plane of play.
    #[serde(default)]
    pub depth: f64,
    /// Size, as a multiple of its usual one.
    #[serde(default = "one")]
    pub scale: f64,
}

fn one() -> f64 { 1.0 }

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
