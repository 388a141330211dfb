//! What is under the hero's feet and hands, for his picture: he is one point to the motion, but stands on two feet, and
//! climbs in the middle of a ladder.

use super::meshes::Meshes;
use super::stage::Stage;
use super::world::World;
use crate::anim::Ground;
use crate::geom::Collider;
use crate::level::Kind;
use crate::mesh::{Cast, Mesh};
use glam::DVec2;

/// The ground as it was drawn, with its movers where they are.
#[derive(Clone, Debug)]
pub struct Soles {
    meshes: Meshes,
    offsets: Vec<DVec2>,
    /// The outlines of the ladders, and the mover that each belongs to.
    ladders: Vec<(Vec<DVec2>, Option<usize>)>,
}

/// Steeper ground than this is none for a sole.
const STEEPEST: f32 = 1.5;

impl Soles {
    /// The ground of a stage; its movers are where they were drawn.
    pub fn of(stage: &Stage) -> Soles {
        let meshes = stage.meshes(&Collider::point());
        let meshes = meshes.expect("the stage was built with the meshes of a point");
        let level = &stage.level;
        let movers = level.movers.iter().enumerate();
        let moving = movers.flat_map(|(i, mover)| mover.features.iter().map(move |f| (f, Some(i))));
        let all = level.features.iter().map(|f| (f, None)).chain(moving);
        let ladders = all.filter(|(feature, _)| feature.kind == Kind::Ladder);
        Soles {
            offsets: vec![DVec2::ZERO; meshes.movers.len()],
            ladders: ladders.map(|(f, i)| (f.outline.clone(), i)).collect(),
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

/// The ends of an outline at a height.
fn ends_at(outline: &[DVec2], y: f64) -> Option<(f64, f64)> {
    let next = outline.iter().cycle().skip(1);
    let crossed = outline.iter().zip(next).filter_map(|(&a, &b)| {
        let share = (y - a.y) / (b.y - a.y);
        (0.0..=1.0).contains(&share).then(|| a.lerp(b, share).x)
    });
    crossed.fold(None, |ends, x| {
        let (left, right) = ends.unwrap_or((x, x));
        Some((left.min(x), right.max(x)))
    })
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
    fn ladder(&self, x: f64, y: f64) -> Option<(f64, f64)> {
        let ends = self.ladders.iter().filter_map(|(outline, mover)| {
            let offset = mover.map_or(DVec2::ZERO, |i| self.offsets[i]);
            let (left, right) = ends_at(outline, y - offset.y)?;
            Some((left + offset.x, right + offset.x))
        });
        let mut around = ends.filter(|&(left, right)| left <= x && x <= right);
        around.next()
    }
}
