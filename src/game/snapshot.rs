//! The whole state of a world as a plain value.

use super::going::Going;
use super::meshes::Shape;
use super::stage::{Edit, EditError, Land, Stage};
use super::world::{Actor, World};
use crate::anim::Leap;
use crate::mesh::{FeatureId, MeshError};
use crate::motion::{Body, Control, Trace};
use crate::tune::Motion;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use xxhash_rust::xxh3::Xxh3;

/// Everything that a world needs, beside its level, to go on from here to the bit. Numbers must be written exactly,
/// as RON does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// The level's [`Stage::fingerprint`].
    fingerprint: u64,
    /// What was changed in the level since it was loaded.
    edits: Vec<Edit>,
    state: State,
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
    pub checkpoint: Option<FeatureId>,
    // The tick before: what changed since then is an event.
    pub tuning: Motion,
    pub retry: bool,
    /// The hero has died and could not come back in that tick.
    pub doomed: bool,
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
            going: Going::at_first(stage),
            checkpoint: None,
            tuning: Motion::default(),
            retry: false,
            doomed: false,
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

    /// A new run begins.
    pub fn forget_run(&mut self, now: f64) {
        self.checkpoint = None;
        self.secrets.clear();
        self.secret_at = None;
        self.deaths = 0;
        self.began_at = now;
    }

    /// Keeps nothing that is about a level in which the bodies no longer are.
    pub fn forget_level(&mut self, stage: &Stage) {
        self.going = Going::at_first(stage);
        self.checkpoint = None;
        self.secrets.clear();
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
            u64::from(self.retry) + 2 * u64::from(self.doomed),
            self.facing.to_bits(),
            time(self.won_at),
            self.began_at.to_bits(),
            self.area as u64,
            self.secrets.len() as u64,
            time(self.secret_at),
        ] {
            hash.update(&word.to_le_bytes());
        }
        for id in self.checkpoint.iter().chain(&self.secrets) {
            hash.update(&id.to_le_bytes());
        }
        for going in &self.going {
            going.hash_into(hash);
        }
    }
}

/// Why a snapshot cannot be taken up.
#[derive(Clone, Debug, PartialEq)]
pub enum RestoreError {
    /// It is of another level.
    OtherLevel,
    /// The stage has edits that the snapshot does not begin with.
    OtherEdits,
    /// One of its edits is refused.
    Edit(EditError),
    /// The level has no meshes for one of its shapes.
    Mesh(MeshError),
}

impl std::fmt::Display for RestoreError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            RestoreError::OtherLevel => f.write_str("the snapshot is of another level"),
            RestoreError::OtherEdits => {
                f.write_str("the level was edited in another way than in the snapshot")
            }
            RestoreError::Edit(error) => write!(f, "an edit of the snapshot: {error}"),
            RestoreError::Mesh(error) => write!(f, "a shape of the snapshot: {error}"),
        }
    }
}

impl std::error::Error for RestoreError {}

impl World {
    /// The whole state, at this moment between two ticks.
    pub fn snapshot(&self) -> Snapshot {
        Snapshot {
            fingerprint: self.stage.fingerprint(),
            edits: self.stage.edits().to_vec(),
            state: self.state.clone(),
        }
    }

    /// The world of a snapshot, in the stage that it was taken in, or in the same before some of its edits.
    ///
    /// # Errors
    /// If the stage is another one.
    pub fn restore(mut stage: Arc<Stage>, snapshot: Snapshot) -> Result<World, RestoreError> {
        let Snapshot {
            fingerprint,
            edits,
            state,
        } = snapshot;
        if stage.fingerprint() != fingerprint {
            return Err(RestoreError::OtherLevel);
        }
        let missing = edits.strip_prefix(stage.edits());
        for edit in missing.ok_or(RestoreError::OtherEdits)?.to_vec() {
            let stage = Arc::make_mut(&mut stage);
            stage.edit(edit).map_err(RestoreError::Edit)?;
        }
        for shape in &state.shapes {
            stage.land(shape).map_err(RestoreError::Mesh)?;
        }
        Ok(World {
            lands: Arc::new(state.lands(&stage)),
            traces: vec![Trace::default(); state.actors.len()],
            stage,
            state,
        })
    }
}
