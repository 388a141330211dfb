//! A run as players count it: how far it has come, what it has cost. A plain value to be kept, and a world to go on with.

use super::going::Going;
use super::returns::Visit;
use super::world::World;
use crate::level::{Feature, Kind};
use crate::mesh::FeatureId;
use serde::{Deserialize, Serialize};

/// What was set going longer ago than this counts as waiting still, s: no run lasts so long.
const LONGEST: f64 = 1e7;

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
    /// The ids of the checkpoints before the last one, in the order in which it came to them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub earlier: Vec<String>,
    /// What the last checkpoint keeps of the level: the ids of the movers that had been set going, and how long ago, in seconds.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub started: Vec<(String, f64)>,
    /// It counts for no best time.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub marked: bool,
}

impl World {
    /// The run so far.
    pub fn so_far(&self) -> Run {
        let id = |feature: &Feature| feature.id.clone();
        let named = |&number: &FeatureId| self.stage.feature(number).map(id);
        let visited = self.state.visited.iter().map(|visit| &visit.checkpoint);
        let mut visited: Vec<String> = visited.filter_map(named).collect();
        let now = self.time();
        let kept = self.state.visited.last().into_iter();
        let kept = kept.flat_map(|visit| visit.going.iter().enumerate());
        let started = kept.filter(|&(mover, _)| self.stage.waits(mover));
        let age = |(mover, going): (usize, &Going)| {
            let mover = self.stage.level.movers.get(mover)?;
            let start = going.start.filter(|_| !going.home)?;
            Some((mover.id.clone(), now - start))
        };
        Run {
            checkpoint: visited.pop(),
            earlier: visited,
            started: started.filter_map(age).collect(),
            seconds: self.view().run_time(),
            deaths: self.state.deaths,
            secrets: self.state.secrets.iter().filter_map(named).collect(),
            marked: self.state.marked,
        }
    }

    /// Goes on with a run: at its last checkpoint, with its time, deaths, secrets and what it had set going. What the level has
    /// no more is left out; whether the checkpoint is still there, if there was one.
    pub fn resume(&mut self, run: &Run) -> bool {
        let find = |id: &String, kind: Kind| {
            let mut features = self.stage.features();
            let is_it = |f: &Feature| f.kind == kind && f.id == *id;
            features.find(|(_, f)| is_it(f)).map(|(number, _)| number)
        };
        let last = run.checkpoint.as_ref().map(|id| find(id, Kind::Checkpoint));
        let visited = run.earlier.iter().chain(&run.checkpoint);
        let visited: Vec<FeatureId> = visited
            .filter_map(|id| find(id, Kind::Checkpoint))
            .collect();
        let secrets = run.secrets.iter().filter_map(|id| find(id, Kind::Secret));
        let secrets = secrets.collect();
        let now = self.time();
        let going = self.going_of(run, now);
        self.restart();
        let visit = |checkpoint| Visit {
            checkpoint,
            going: going.clone(),
        };
        let state = &mut self.state;
        (state.visited, state.secrets) = (visited.into_iter().map(visit).collect(), secrets);
        (state.deaths, state.marked) = (run.deaths, state.marked || run.marked);
        state.began_at = now - run.seconds;
        self.leave(now, now);
        self.settle();
        self.note_area();
        last != Some(None)
    }

    /// Where the movers are that a run has set going, for who goes on with it now.
    fn going_of(&self, run: &Run, now: f64) -> Vec<Going> {
        let mut all = Going::at_first(&self.stage, now);
        let movers = self.stage.level.movers.iter().enumerate();
        for ((i, mover), going) in movers.zip(&mut all) {
            let started = run.started.iter().find(|(id, _)| *id == mover.id);
            if let Some((_, ago)) = started.filter(|(_, ago)| (0.0..=LONGEST).contains(ago))
                && self.stage.waits(i)
            {
                going.start = Some(now - ago);
            }
        }
        all
    }
}
