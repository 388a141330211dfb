//! The part of the check that looks at meshes.

use super::{Case, Report};
use crate::game::Shape;
use crate::geom::Collider;
use crate::mesh::Mesh;

/// Every mesh of every collider and mover keeps its invariants.
pub(super) fn check(case: &Case, report: &mut Report) {
    let stage = case.stage;
    let Shape { stand, crouch } = Shape::hero();
    let point = Collider::point();
    let (mut count, mut vertices) = (0, 0);
    for (size, collider) in [("standing", stand), ("crouching", crouch), ("point", point)] {
        let meshes = match stage.meshes(&collider) {
            Ok(meshes) => meshes,
            Err(error) => {
                report.wrong(format!("{size} mesh: {error}"));
                continue;
            }
        };
        let level = std::iter::once(("the level".to_owned(), &meshes.level));
        let names = stage.level.movers.iter();
        let names = names.map(|mover| format!("mover {:?}", mover.id));
        for (what, mesh) in level.chain(names.zip(&meshes.movers)) {
            let mesh: &Mesh = mesh;
            (count, vertices) = (count + 1, vertices + mesh.vertices().count());
            if let Err(error) = mesh.check() {
                report.wrong(format!("{size} mesh of {what}: {error}"));
            }
        }
    }
    let line = format!("meshes    {count} built and checked, {vertices} vertices");
    report.done(line);
}
