//! The part of the check that asks whether one-ways hold anybody.

use super::{Case, Report, name_of};
use crate::game::Shape;
use crate::level::Kind;
use crate::mesh::{FeatureId, SegmentId};
use crate::motion::{Ground, Size};

/// A one-way that is too steep everywhere, or lies in solids, lets everybody pass from either side.
pub(super) fn check(case: &Case, report: &mut Report) {
    let stage = case.stage;
    let Ok(land) = stage.land(&Shape::hero()) else {
        return; // the meshes have been told of
    };
    let terrain = land.terrain(stage, &case.tuning.motion);
    let movers = (0..stage.level.movers.len() as u32).map(Some);
    let grounds: Vec<Ground> = std::iter::once(None)
        .chain(movers)
        .map(|mover| terrain.ground_under(mover, Size::Stand))
        .collect();
    for (id, feature) in stage.features() {
        if feature.kind == Kind::OneWay && !grounds.iter().any(|&ground| holds(ground, id)) {
            report.wrong(format!(
                "{}, from outline[0] on: this one-way holds nobody",
                name_of(feature)
            ));
        }
    }
}

/// Whether some piece of a feature stops who comes from its front.
fn holds(ground: Ground, feature: FeatureId) -> bool {
    let stops = |&s: &SegmentId| {
        let mut pieces = ground.chain(s).windows(2);
        pieces.any(|ends| {
            let front = ground.edge_between(ends[1], ends[0]);
            front.is_some_and(|e| ground.is_one_way(e))
        })
    };
    ground.segments_of(feature).iter().any(stops)
}
