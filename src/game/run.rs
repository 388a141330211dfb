//! A run as players count it: how far it has come, what it has cost. A plain value to be kept, and a world to go on with.

use super::world::World;
use crate::level::{Feature, Kind};
use serde::{Deserialize, Serialize};

/// A run that is under way.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Run {
    /// The id of the last checkpoint; `None`: it has not come to one.
    pub checkpoint: Option<String>,
    /// Time that it has taken so far, in seconds.
    pub seconds: f64,
    /// Deaths so far.
    pub deaths: u32,
    /// The ids of the secrets that were found.
    pub secrets: Vec<String>,
}

impl World {
    /// The run so far.
    pub fn so_far(&self) -> Run {
        let id = |feature: &Feature| feature.id.clone();
        let secrets = self.state.secrets.iter();
        Run {
            checkpoint: self.checkpoint().map(id),
            seconds: self.view().run_time(),
            deaths: self.state.deaths,
            secrets: secrets
                .filter_map(|&s| self.stage.feature(s).map(id))
                .collect(),
        }
    }

    /// Goes on with a run: at its last checkpoint, with its time, deaths and secrets. What the level has no more is left
    /// out; whether the checkpoint is still there, if there was one.
    pub fn resume(&mut self, run: &Run) -> bool {
        let find = |id: &String, kind: Kind| {
            let mut features = self.stage.features();
            let is_it = |f: &Feature| f.kind == kind && f.id == *id;
            features.find(|(_, f)| is_it(f)).map(|(number, _)| number)
        };
        let checkpoint = run.checkpoint.as_ref().map(|id| find(id, Kind::Checkpoint));
        let secrets = run.secrets.iter().filter_map(|id| find(id, Kind::Secret));
        let secrets = secrets.collect();
        self.restart();
        let now = self.time();
        self.state.checkpoint = checkpoint.flatten();
        self.state.secrets = secrets;
        self.state.deaths = run.deaths;
        self.state.began_at = now - run.seconds;
        self.come_back(now);
        self.note_area();
        checkpoint != Some(None)
    }
}
