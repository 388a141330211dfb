//! The parts of a level that are about places: areas with a name and a mood, and what the camera frames.

use super::Rect;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A part of the level that has a name of its own. Areas may overlap: the first in the list counts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Area {
    /// What players call it.
    pub name: String,
    /// Who has his foot in it is in the area. The picture stays inside, but for sides at which another area goes on.
    pub room: Rect,
    /// How it looks and sounds.
    pub mood: Mood,
}

/// How an area looks and sounds: its palette, its air, the layers of its music.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Mood {
    /// Open air, low warm sun, wind.
    #[default]
    Dusk,
    /// Among water and machines.
    Works,
    /// Deep inside, where only lanterns give light.
    Depths,
    /// High up, clear and cold.
    Summit,
}

/// What the camera shows as long as the hero's foot is in a room. Frames may overlap: the first in the list counts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Frame {
    /// Where it holds.
    pub room: Rect,
    /// What is then near the middle of the picture, in metres; without it, the camera follows as everywhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<DVec2>,
    /// How many times larger than usual things are seen.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub zoom: f64,
}

/// Something that the hero can do and a player may not know of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Skill {
    /// Crouching under what hangs low.
    Crouch,
    /// Dropping through the boards that he stands on.
    Drop,
    /// Jumping off a wall.
    WallJump,
    /// Climbing up from a ledge that he hangs from.
    Ledge,
    /// Looking up.
    Look,
}

/// Where a skill is needed: how it is done is told while the hero's foot is in a room, until he has done it once. Prompts may
/// overlap: of those that are not known yet, the first in the list counts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Prompt {
    /// What is told.
    pub skill: Skill,
    /// Where.
    pub room: Rect,
}

fn one() -> f64 {
    1.0
}

fn is_one(zoom: &f64) -> bool {
    *zoom == one()
}
