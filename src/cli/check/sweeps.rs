//! The part of the check that looks at the places where the hero begins: what moves may come over them.

use super::{Case, Report};
use crate::game::Shape;
use glam::DVec2;

/// A mover that comes over the start or the place of a checkpoint lets the hero wait there, or crushes him as soon as he is back.
pub(super) fn check(case: &Case, report: &mut Report) {
    let stage = case.stage;
    let Ok(land) = stage.land(&Shape::hero()) else {
        return; // that is told by the part that looks at meshes
    };
    let terrain = land.terrain(stage, &case.tuning.motion);
    let start = ("the start".to_owned(), stage.level.start);
    let respawn = |feature: &crate::level::Feature| {
        let name = format!("where checkpoint {:?} puts the hero", feature.id);
        Some((name, feature.respawn?))
    };
    let respawns = stage.level.features.iter().filter_map(respawn);
    let places: Vec<(String, DVec2)> = [start].into_iter().chain(respawns).collect();
    for (mover, solid) in stage.level.movers.iter().zip(&land.movers) {
        for (name, place) in &places {
            let over = solid.comes_over(*place, &terrain, |id| stage.kills(id));
            if let Some(after) = over {
                report.wrong(format!(
                    "mover {:?}: {after:.3} s after it sets out it comes over {name}",
                    mover.id
                ));
            }
        }
    }
}
