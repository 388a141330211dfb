//! The part of the check that asks what triggers and regions are there for.

use super::{Case, Report, name_of};
use crate::game::Shape;
use crate::level::Kind;

/// A trigger that nothing waits for, and a region that solids fill, are mistakes of whoever made the level.
pub(super) fn check(case: &Case, report: &mut Report) {
    let stage = case.stage;
    let awaited: Vec<_> = stage.triggers().collect();
    let land = stage.land(&Shape::hero());
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
        if !feature.kind.is_terrain() && open(id) == Some(false) {
            report.wrong(format!(
                "{name}: the standing hero can never be in it, for solids fill it"
            ));
        }
    }
}
