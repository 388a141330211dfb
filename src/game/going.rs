//! What the state of a game knows of each mover: whether it has set out, and when.

use super::stage::{Land, Stage};
use serde::{Deserialize, Serialize};

/// Where a mover is on its way. A plain value: what a checkpoint knows of movers is a copy of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Going {
    /// When it set out, s; `None`: it waits at its first stop.
    pub start: Option<f64>,
}

impl Going {
    /// All movers of a stage as they are when a level begins.
    pub fn at_first(stage: &Stage) -> Vec<Going> {
        let start = |mover| stage.trigger(mover).is_none().then_some(0.0);
        let movers = 0..stage.level.movers.len();
        let going = movers.map(|mover| Going {
            start: start(mover),
        });
        going.collect()
    }

    /// Lets the movers of a shape be where these say.
    pub fn bring(going: &[Going], land: &mut Land) {
        for (mover, going) in land.movers.iter_mut().zip(going) {
            mover.start = going.start;
        }
    }
}
