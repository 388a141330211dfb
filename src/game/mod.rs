//! The rules: Input in, View and Event out.
//!
//! A [`Stage`] is a level with its meshes, a [`World`] the state of a game in it, a [`Snapshot`] that state as a plain value,
//! a [`Replay`] a run as one. Nothing here opens a window, reads a clock or touches a file.

mod blend;
pub mod camera;
pub mod framing;
mod going;
mod lessons;
mod meshes;
mod moves;
mod paths;
pub mod replay;
mod restore;
mod returns;
mod rules;
mod run;
mod snapshot;
mod soles;
mod stage;
mod ways;
mod world;

pub use lessons::Lessons;
pub use meshes::{Meshes, Shape};
pub use moves::Sights;
pub use replay::{Replay, ReplayError};
pub use restore::RestoreError;
pub use returns::{Away, Back, Return};
pub use run::Run;
pub use snapshot::Snapshot;
pub use soles::Soles;
pub use stage::{Edit, EditError, Land, Stage, StageError};
pub use world::{Actor, AddError, World};

use crate::anim::Leap;
use crate::level::Material;
use crate::motion::Grip;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// What the player holds at a tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Input {
    /// Wished run, -127 (left) to 127 (right).
    pub run: i8,
    /// Jump is held.
    pub jump: bool,
    /// Down is held: crouch on the ground, fast fall in the air, climb down.
    pub down: bool,
    /// Up is held: climb.
    pub up: bool,
    /// Back to the start, at once: a new run, when this is asked for anew.
    pub retry: bool,
    /// Back to the last checkpoint, when this is asked for anew. That counts as a death.
    #[serde(skip_serializing_if = "is_false")]
    pub respawn: bool,
}

/// Recordings without it stay as they were.
fn is_false(value: &bool) -> bool {
    !value
}

/// What the hero is doing, for pictures and sounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stance {
    /// In the air.
    Air,
    /// On walkable ground.
    Ground,
    /// Along something too steep to stand on: sliding, or with a hold on it ([`View::grip`]).
    Slide,
    /// Wedged at a vertex.
    Wedge,
    /// On a ladder.
    Climb,
}

/// Everything that a picture of one moment needs; a plain value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Simulated seconds.
    pub time: f64,
    /// The hero's foot, in metres.
    pub position: DVec2,
    /// Metres per second.
    pub velocity: DVec2,
    /// Unit normal of the ground or wall in contact; zero in the air.
    pub normal: DVec2,
    /// What the hero is doing.
    pub stance: Stance,
    /// In the smaller size.
    pub crouched: bool,
    /// -1 left, 1 right.
    pub facing: f64,
    /// What the ground or wall in contact is made of.
    pub material: Option<Material>,
    /// What he holds on to, on a wall.
    pub grip: Grip,
    /// Velocity of what carries him: of a mover, of a belt.
    pub carried: DVec2,
    /// Height over the foot of the ledge from which he hangs or onto which he climbs, m; else 0.
    pub ledge: f64,
    /// Simulated time of the last take-off.
    pub left_at: f64,
    /// How that was.
    pub leap: Leap,
    /// Simulated time when he last took hold of something, or began to climb it.
    pub held_at: f64,
    /// Simulated time of the last landing.
    pub landed_at: f64,
    /// Speed into the ground at the last landing, m/s.
    pub landed_speed: f64,
    /// The goal has been reached, at this simulated time.
    pub won_at: Option<f64>,
    /// How often the hero died, or fell out of the level, since the run began.
    pub deaths: u32,
    /// He is nowhere: he has died, and the place where he comes back is not free yet.
    pub away: Option<Away>,
    /// When and where he came back last in this run.
    pub returned: Option<Return>,
    /// The run counts for no best time: in it tuning, level or speed were others than the game's own.
    pub marked: bool,
    /// When the run began: 0, or the simulated time of the last restart.
    pub began_at: f64,
    /// Index of the level's area that the hero is in, or was in last; 0 in a level without areas.
    pub area: usize,
    /// How many secrets he has found in this run.
    pub secrets: u32,
    /// Simulated time at which he found the last of them.
    pub secret_at: Option<f64>,
    /// Where the checkpoint that he entered last puts his foot, in metres, as it was drawn; without one he starts anew.
    pub checkpoint: Option<DVec2>,
}
