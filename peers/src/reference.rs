//! Our own error against a reference that shares no code with the mesh or the motion: the one that the tests use, in 32
//! digits, on random runs and on the recorded inputs in the quarry.

#![allow(dead_code, reason = "the tests use more of it")]

#[path = "../../tests/reference/body.rs"]
mod body;
#[path = "../../tests/reference/corner.rs"]
mod corner;
#[path = "../../tests/reference/double.rs"]
mod double;
#[path = "../../tests/reference/duel.rs"]
mod duel;
#[path = "../../tests/reference/flight.rs"]
mod flight;
#[path = "../../tests/reference/jump.rs"]
mod jump;
#[path = "../../tests/reference/law.rs"]
mod law;
#[path = "../../tests/reference/outline.rs"]
mod outline;
#[path = "../../tests/reference/piece.rs"]
mod piece;
#[path = "../../tests/reference/runs.rs"]
mod runs;
#[path = "../../tests/common/worlds.rs"]
pub mod worlds;

use crate::level::Quarry;
use edgewalker::geom::{Collider, Point};
use edgewalker::tune::Motion;
use glam::DVec2;

/// Largest differences from the reference: position in m, velocity in m/s, event times in s.
#[derive(Clone, Debug, Default)]
pub struct Difference {
    pub runs: usize,
    pub ticks: usize,
    pub events: usize,
    pub largest: [f64; 3],
    /// Runs that ended before their time, where rounding to the grid makes both answers right.
    pub doubts: usize,
    /// Runs left out of `largest`: the grid moved a crossing that they came off.
    pub blurred: usize,
    pub failures: Vec<String>,
}

impl Difference {
    fn add(&mut self, outcome: Result<duel::Outcome, String>) {
        self.runs += 1;
        match outcome {
            Ok(outcome) => {
                self.ticks += outcome.ticks.iter().sum::<usize>();
                self.events += outcome.events;
                self.doubts += usize::from(outcome.doubt.is_some());
                self.blurred += usize::from(outcome.blurred);
                if !outcome.blurred {
                    for (largest, error) in self.largest.iter_mut().zip(outcome.errors) {
                        *largest = largest.max(error);
                    }
                }
            }
            Err(failure) => self.failures.push(failure),
        }
    }
}

/// Random runs of two seconds each.
pub fn random(runs: u64) -> Difference {
    let mut all = Difference::default();
    (1..=runs).for_each(|seed| all.add(duel::play(&runs::Run::new(seed))));
    all
}

/// The recorded inputs in the quarry, in pieces of so many ticks at 60 Hz from 5 cm above where the
/// recorded run was then. What the
/// reference does not know (ledges, corrections, wall slides and wall jumps) is off for both.
pub fn quarry(quarry: &Quarry, ticks: usize) -> Difference {
    let tuning = Motion {
        floor_snap: 0.0,
        step_up: 0.0,
        corner_correction: 0.0,
        ledge_correction: 0.0,
        wall_slide_speed: 0.0,
        wall_jump_up: 0.0,
        ledge_hang: 0.0,
        ..quarry.replay.tuning.motion.clone()
    };
    let snap = |outline: &Vec<_>| {
        outline
            .iter()
            .map(|&p| Point::snap(p).expect("a sound level"))
            .collect()
    };
    let outlines: Vec<Vec<Point>> = quarry.solids.iter().map(snap).collect();
    let controls: Vec<_> = quarry.controls.iter().step_by(2).copied().collect();
    let moments = quarry.moments(60.0);
    let mut all = Difference::default();
    let chunks = controls.chunks(ticks).zip(moments.chunks(ticks));
    for (piece, moments) in chunks.filter(|(_, moments)| moments[0].plain) {
        all.add(duel::play(&runs::Run {
            outlines: outlines.clone(),
            collider: Collider::hero(),
            tuning: tuning.clone(),
            // In the air: a start in touch with the ground is in doubt.
            start: moments[0].at + DVec2::new(0.0, 0.05),
            controls: piece.to_vec(),
        }));
    }
    all
}
