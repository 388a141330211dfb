//! The whole state of a world as a plain value.

use super::going::Going;
use super::meshes::Shape;
use super::returns::{Away, Return, Visit};
use super::stage::{Edit, Land, Stage};
use super::world::Actor;
use crate::anim::Leap;
use crate::mesh::FeatureId;
use crate::motion::{Body, Control};
use crate::tune::Motion;
use serde::{Deserialize, Serialize};
use xxhash_rust::xxh3::Xxh3;

/// Everything that a world needs, beside its level, to go on from here to the bit. Numbers must be written exactly,
/// as RON does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// The level's [`Stage::fingerprint`].
    pub(super) fingerprint: u64,
    /// What was changed in the level since it was loaded.
    pub(super) edits: Vec<Edit>,
    /// Hash of the rest as text: a state that somebody has changed is none that a world has been in.
    pub(super) sum: u64,
    pub(super) state: State,
}

/// What changes from tick to tick.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct State {
    // Time.
    pub rate: u32,
    pub seed: u64,
    pub tick: u64,
    // Bodies, the hero first, and the shapes that they have.
    pub shapes: Vec<Shape>,
    pub actors: Vec<Actor>,
    // The level: where each mover is on its way, and where the hero comes back.
    pub going: Vec<Going>,
    /// The checkpoints that he has come to, the last one last.
    #[serde(default)]
    pub visited: Vec<Visit>,
    /// He is nowhere.
    #[serde(default)]
    pub away: Option<Away>,
    #[serde(default)]
    pub returned: Option<Return>,
    // The tick before: what changed since then is an event.
    pub tuning: Motion,
    pub retry: bool,
    #[serde(default)]
    pub respawn: bool,
    // What has come of it so far.
    pub facing: f64,
    pub left_at: f64,
    #[serde(default)]
    pub leap: Leap,
    #[serde(default)]
    pub held_at: f64,
    /// Height of the ledge that was taken hold of last, m.
    #[serde(default)]
    pub ledge_at: f64,
    pub landed_at: f64,
    pub landed_speed: f64,
    pub won_at: Option<f64>,
    pub deaths: u32,
    pub began_at: f64,
    /// The run counts for no best time.
    #[serde(default)]
    pub marked: bool,
    pub area: usize,
    /// In the order in which they were found.
    pub secrets: Vec<FeatureId>,
    pub secret_at: Option<f64>,
}

impl State {
    /// The hero alone, at tick 0.
    pub fn new(stage: &Stage, hero: Body, rate: u32, seed: u64) -> State {
        State {
            rate,
            seed,
            tick: 0,
            shapes: vec![Shape::hero()],
            actors: vec![Actor {
                shape: 0,
                control: Control::default(),
                body: hero,
            }],
            going: Going::at_first(stage, 0.0),
            visited: Vec::new(),
            away: None,
            returned: None,
            tuning: Motion::default(),
            retry: false,
            respawn: false,
            facing: 1.0,
            left_at: 0.0,
            leap: Leap::Walked,
            held_at: 0.0,
            ledge_at: 0.0,
            landed_at: 0.0,
            landed_speed: 0.0,
            won_at: None,
            deaths: 0,
            began_at: 0.0,
            marked: false,
            area: 0,
            secrets: Vec::new(),
            secret_at: None,
        }
    }

    /// The ground for every shape.
    pub fn lands(&self, stage: &Stage) -> Vec<Land> {
        let land = |shape: &Shape| {
            let mut land = stage
                .land(shape)
                .expect("every shape has its meshes, and edits keep them within the world");
            Going::bring(&self.going, stage, &mut land);
            land
        };
        self.shapes.iter().map(land).collect()
    }

    /// The checkpoint that the hero came to last.
    pub fn checkpoint(&self) -> Option<FeatureId> {
        self.visited.last().map(|visit| visit.checkpoint)
    }

    /// A new run begins.
    pub fn forget_run(&mut self, now: f64) {
        self.visited.clear();
        self.returned = None;
        self.secrets.clear();
        self.secret_at = None;
        self.deaths = 0;
        self.won_at = None;
        self.began_at = now;
        self.marked = self.tuning != Motion::default();
    }

    /// Keeps nothing that is about a level in which the bodies no longer are.
    pub fn forget_level(&mut self, stage: &Stage) {
        self.going = Going::at_first(stage, 0.0);
        self.visited.clear();
        self.returned = None;
        self.secrets.clear();
        self.marked = true;
        self.area = 0;
        // A shape too large for the new level would have no meshes there.
        let fits: Vec<bool> = self.shapes.iter().map(|s| stage.land(s).is_ok()).collect();
        self.actors.retain(|actor| fits[actor.shape]);
        for (shape, _) in self.shapes.iter_mut().zip(fits).filter(|(_, fits)| !fits) {
            *shape = Shape::hero();
        }
    }

    /// Adds all but the bodies to a hash.
    pub fn hash_into(&self, hash: &mut Xxh3) {
        let time = |t: Option<f64>| (t.unwrap_or(-1.0) + 0.0).to_bits();
        for word in [
            self.tick,
            self.seed,
            u64::from(self.deaths),
            u64::from(self.retry)
                + 2 * u64::from(self.away.is_some())
                + 4 * u64::from(self.respawn),
            self.facing.to_bits(),
            time(self.won_at),
            self.began_at.to_bits(),
            self.area as u64,
            self.secrets.len() as u64,
            time(self.secret_at),
        ] {
            hash.update(&word.to_le_bytes());
        }
        for id in self.checkpoint().iter().chain(&self.secrets) {
            hash.update(&id.to_le_bytes());
        }
        for going in &self.going {
            going.hash_into(hash);
        }
        if let Some(away) = self.away {
            hash.update(&time(away.until).to_le_bytes());
        }
    }
}
