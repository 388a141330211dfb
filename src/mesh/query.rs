//! Questions of the game and its tools about a neighbourhood: the nearest wall, what a shape overlaps, where one can go.

use super::{EdgeId, FaceId, FeatureId, Mesh, Place};
use crate::geom::distance::SquaredDistance;
use crate::geom::polygon::is_convex;
use crate::geom::predicates::{delta, dot, orient2d};
use crate::geom::{Point, STEP};
use glam::DVec2;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

/// The nearest wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// The edge that it is on, with the free side on its left.
    pub edge: EdgeId,
    /// Its nearest point, m; rounded.
    pub point: DVec2,
    /// How far away that is, m; rounded.
    pub distance: f64,
}

/// What a shape overlaps.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Overlap {
    /// The faces whose inside has points in common with the inside of the shape, ascending.
    pub faces: Vec<FaceId>,
    /// The features that cover one of these faces, and those with an edge through the inside of the shape, ascending.
    pub features: Vec<FeatureId>,
}

impl Mesh {
    /// The place where free meets solid, or the world ends, that is nearest to the grid point next to a position in metres:
    /// compared exactly; of equally near edges the one with the lexicographically smallest ends. `None` where
    /// [`Mesh::locate`] finds nothing, or if all the world is solid.
    ///
    /// Looks at the edges in order of their distance, from face to face: a straight way to the nearest place crosses only edges
    /// that are no further away.
    pub fn nearest_wall(&self, p: DVec2, near: Option<FaceId>) -> Option<Nearest> {
        let target = Point::snap(p)?;
        let start = self.locate(target.metres(), near)?;
        let mut best: Option<(SquaredDistance, [Point; 2], EdgeId)> = None;
        let key = |e: EdgeId| {
            let (a, b) = self.ends(e);
            let distance = SquaredDistance::to_segment(target, a, b);
            (distance, [a.min(b), a.max(b)])
        };
        self.outwards(start, key, |e, &(distance, ends)| {
            if best.is_some_and(|best| distance > best.0) {
                return true;
            }
            if let Some(edge) = [e, self.sym(e)].into_iter().find(|&e| self.blocks(e)) {
                let wall = (distance, ends, edge);
                best = Some(best.map_or(wall, |best| best.min(wall)));
            }
            false
        });
        best.map(|best| self.wall(best, target))
    }

    /// Shows edges from a place outwards, that with the smallest key first, until one is found to be enough: Dijkstra's search
    /// over the faces. An edge is met when one of the faces beside it has been entered, so keys must grow with the distance.
    pub(crate) fn outwards<K: Ord>(
        &self,
        start: Place,
        key: impl Fn(EdgeId) -> K,
        mut enough: impl FnMut(EdgeId, &K) -> bool,
    ) {
        let mut seen = BTreeSet::new();
        let mut queue = BinaryHeap::new();
        let mut entered = self.faces_at(start);
        loop {
            for e in entered.drain(..).flat_map(|face| self.sides(face)) {
                let e = e.min(self.sym(e));
                if seen.insert(e) {
                    queue.push(Reverse((key(e), e)));
                }
            }
            let Some(Reverse((key, e))) = queue.pop() else {
                return;
            };
            if enough(e, &key) {
                return;
            }
            entered.extend([e, self.sym(e)].into_iter().filter_map(|e| self.left(e)));
        }
    }

    /// The nearest point of an edge, for the caller.
    fn wall(
        &self,
        (distance, _, edge): (SquaredDistance, [Point; 2], EdgeId),
        target: Point,
    ) -> Nearest {
        let (a, b) = self.ends(edge);
        let (along, to) = (delta(a, b), delta(a, target));
        let share = (dot(along, to) as f64 / dot(along, along) as f64).clamp(0.0, 1.0);
        Nearest {
            edge,
            point: a.metres().lerp(b.metres(), share),
            distance: distance.root() * STEP,
        }
    }

    /// The faces that a place is in, or that meet there.
    pub fn faces_at(&self, place: Place) -> Vec<FaceId> {
        match place {
            Place::Face(face) => vec![face],
            Place::Edge(e) => [e, self.sym(e)]
                .into_iter()
                .filter_map(|e| self.left(e))
                .collect(),
            Place::Vertex(v) => self.spokes(v).filter_map(|e| self.left(e)).collect(),
        }
    }

    /// What the inside of a convex shape overlaps, exactly: touching does not count. Corners counter-clockwise, in steps. `None`
    /// if the shape is not strictly convex and counter-clockwise, or its first corner is not strictly inside the world's box.
    ///
    /// Other shapes can be cut into convex ones.
    pub fn overlap(&self, shape: &[Point]) -> Option<Overlap> {
        if !is_convex(shape) {
            return None;
        }
        let start = self.locate(shape[0].metres(), None)?;
        let mut faces = BTreeSet::new();
        let mut features = BTreeSet::new();
        let mut stack = self.faces_at(start);
        while let Some(face) = stack.pop() {
            if faces.contains(&face) || !overlaps(&self.corners(face), shape) {
                continue;
            }
            faces.insert(face);
            features.extend(self.cover(face));
            for e in self.sides(face) {
                let (a, b) = self.ends(e);
                if overlaps(&[a, b], shape) {
                    features.extend(self.uses(e).map(|u| self.segment(u.segment).feature));
                }
                stack.extend(self.left(self.sym(e)));
            }
        }
        Some(Overlap {
            faces: faces.into_iter().collect(),
            features: features.into_iter().collect(),
        })
    }

    /// The free faces next to a face that nothing stops a body from entering, each with the edge that leads there, which has the
    /// given face on its left.
    pub fn free_neighbours(&self, face: FaceId) -> impl Iterator<Item = (EdgeId, FaceId)> + '_ {
        let beyond = |e: EdgeId| Some((e, self.left(self.sym(e))?));
        let sides = self.sides(face).into_iter().filter_map(beyond);
        sides.filter(|&(_, face)| !self.is_solid(face))
    }

    /// The points where an edge starts and ends.
    #[inline]
    pub fn ends(&self, e: EdgeId) -> (Point, Point) {
        (self.point(self.origin(e)), self.point(self.dest(e)))
    }
}

/// Whether the insides of two convex shapes have a point in common; of a shape of two corners, the segment between them.
///
/// If not, a line along some side parts them (the separating axis theorem; a side of their Minkowski difference).
fn overlaps(p: &[Point], q: &[Point]) -> bool {
    !parts(p, q) && !parts(q, p)
}

/// Whether a line along a side of a convex counter-clockwise shape has the shape on its left and another one not.
fn parts(shape: &[Point], other: &[Point]) -> bool {
    let outside = |a: Point, b: Point| other.iter().all(|&p| orient2d(a, b, p) <= 0);
    let next = |i: usize| shape[(i + 1) % shape.len()];
    (0..shape.len()).any(|i| outside(shape[i], next(i)))
}
