//! The part of the check that asks what triggers, regions and ladders are there for.

use super::{Case, Report, name_of};
use crate::game::Shape;
use crate::level::Kind;
use crate::motion::mount::short_of_ground;

/// A trigger that nothing waits for, a region that solids fill, and a ladder that ends too far below the ground that it leads to
/// are mistakes of whoever made the level.
pub(super) fn check(case: &Case, report: &mut Report) {
    let stage = case.stage;
    let awaited: Vec<_> = stage.triggers().collect();
    let land = stage.land(&Shape::hero());
    let missing = |id| {
        let land = land.as_ref().ok()?;
        short_of_ground(id, &land.terrain(stage, &case.tuning.motion))
    };
    let open = |id| {
        let meshes = &land.as_ref().ok()?.stand;
        let mesh = match stage.mover_of(id) {
            Some(mover) => &meshes.movers[mover],
            None => &meshes.level,
        };
        let free = |&f: &_| mesh.cover(f).contains(&id) && !mesh.is_solid(f);
        Some(mesh.faces().any(|f| free(&f)))
    };
    for (id, feature) in stage.features() {
        let name = name_of(feature);
        if feature.kind == Kind::Trigger && !awaited.contains(&id) {
            report.wrong(format!("{name}: nothing waits for this trigger"));
        }
        if let Some(short) = missing(id).filter(|_| feature.kind == Kind::Ladder) {
            report.wrong(format!(
                "{name}: ends {short:.2} m too far below the ground over it for who climbs up to stand there"
            ));
        }
        if !feature.kind.is_terrain() && open(id) == Some(false) {
            report.wrong(format!(
                "{name}: the standing hero can never be in it, for solids fill it"
            ));
        }
    }
}
