//! The rules: Input in, View and Event out. CONTRACT (skeleton): the signatures below are what the shell calls.

mod blend;
pub mod camera;

use crate::level::Level;
use crate::mesh::Mesh;
use crate::tune::Tuning;
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What the player holds at a tick.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Input {
    /// Wished run, -127 (left) to 127 (right).
    pub run: i8,
    /// Jump is held.
    pub jump: bool,
    /// Down is held: crouch on the ground, fast fall in the air.
    pub down: bool,
    /// Back to the start, at once.
    pub retry: bool,
}

/// A level made ready to play: checked, with its meshes built.
#[derive(Debug)]
pub struct Stage {
    /// The level.
    pub level: Level,
    /// Motion mesh of the standing hero.
    pub stand: Mesh,
    /// Motion mesh of the crouching hero.
    pub crouch: Mesh,
    /// Mesh of the outlines themselves (a point as collider): what there is to see.
    pub outline: Mesh,
}

/// What the hero is doing, for pictures and sounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stance {
    /// In the air.
    Air,
    /// On walkable ground.
    Ground,
    /// Along something too steep to stand on.
    Slide,
    /// Wedged at a vertex.
    Wedge,
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
    /// Simulated time of the last take-off, landing.
    pub left_at: f64,
    /// Simulated time of the last landing.
    pub landed_at: f64,
    /// Speed into the ground at the last landing, m/s.
    pub landed_speed: f64,
    /// The goal has been reached, at this simulated time.
    pub won_at: Option<f64>,
    /// How often the hero fell out of the level.
    pub deaths: u32,
}

/// The whole simulation state.
#[derive(Clone, Debug)]
pub struct World {
    stage: Arc<Stage>,
}

impl World {
    /// A world at tick 0, the hero at the start.
    pub fn new(stage: Arc<Stage>, tick_rate: u32, seed: u64) -> World { let _ = (tick_rate, seed); World { stage } }
    /// One tick.
    pub fn step(&mut self, _input: Input, _tuning: &Tuning) { todo!() }
    /// What to draw.
    pub fn view(&self) -> View { todo!() }
    /// Ticks done.
    pub fn tick(&self) -> u64 { todo!() }
    /// Hash of the state, equal on every machine and in every build.
    pub fn hash(&self) -> u64 { todo!() }
    /// The level.
    pub fn stage(&self) -> &Arc<Stage> { &self.stage }
    /// The mesh that the hero moves in now.
    pub fn mesh(&self) -> &Mesh { &self.stage.stand }
}
