//! What is under the hero's feet, for his picture: he is one point to the motion, but stands on two feet.

use super::meshes::Meshes;
use super::stage::Stage;
use super::world::World;
use crate::anim::Ground;
use crate::geom::Collider;
use crate::mesh::{Cast, Mesh};
use glam::DVec2;

/// The ground as it was drawn, with its movers where they are.
#[derive(Clone, Debug)]
pub struct Soles {
    meshes: Meshes,
    offsets: Vec<DVec2>,
}

/// Steeper ground than this is none for a sole.
const STEEPEST: f32 = 1.5;

impl Soles {
    /// The ground of a stage; its movers are where they were drawn.
    pub fn of(stage: &Stage) -> Soles {
        let meshes = stage.meshes(&Collider::point());
        let meshes = meshes.expect("the stage was built with the meshes of a point");
        Soles {
            offsets: vec![DVec2::ZERO; meshes.movers.len()],
            meshes,
        }
    }

    /// Moves the movers to where they are in a world of that stage.
    pub fn follow(&mut self, world: &World) {
        let offsets = world.offsets_at(world.time());
        for (mine, offset) in self.offsets.iter_mut().zip(offsets) {
            *mine = offset;
        }
    }
}

/// The ground of one mesh under a place, if it is walkable.
fn under(mesh: &Mesh, from: DVec2, low: f64) -> Option<(f64, f32)> {
    let stops = |e| mesh.blocks(e) || mesh.has_front(e);
    let Cast::Hit(hit) = mesh.cast_by(from, DVec2::new(from.x, low), None, stops) else {
        return None;
    };
    let (a, b) = mesh.ends(hit.edges[0]);
    let along = b.metres() - a.metres();
    let slope = (along.y / along.x) as f32;
    (slope.abs() <= STEEPEST).then_some((hit.point.y, slope))
}

impl Ground for Soles {
    fn under(&self, x: f64, high: f64, low: f64) -> Option<(f64, f32)> {
        // From high up a ceiling may be in the way: then from half as high.
        let look = |mesh: &Mesh, offset: DVec2| {
            let found = [high, 0.5 * high + 0.5 * (0.5 * high + 0.5 * low)]
                .into_iter()
                .find_map(|top| under(mesh, DVec2::new(x, top) - offset, low - offset.y));
            found.map(|(height, slope)| (height + offset.y, slope))
        };
        let still = look(&self.meshes.level, DVec2::ZERO);
        let movers = self.meshes.movers.iter().zip(&self.offsets);
        let moving = movers.filter_map(|(mesh, &offset)| look(mesh, offset));
        still
            .into_iter()
            .chain(moving)
            .max_by(|a, b| a.0.total_cmp(&b.0))
    }
}
