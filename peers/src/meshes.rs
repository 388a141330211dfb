//! The meshes side by side: ours, spade with constraints that are split where they cross, delaunator on plain points.

use crate::reference::worlds::{self, Dice, Outline};
use edgewalker::geom::{Collider, ExpandedEdge, Point};
use edgewalker::mesh::{FaceId, Mesh, Place};
use glam::DVec2;
use spade::handles::FixedVertexHandle;
use spade::{
    ConstrainedDelaunayTriangulation, Intersection, LineIntersectionIterator, Point2, Triangulation,
};

/// Spade's mesh of plain points.
pub type Spade = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Overlapping octagons of radius 0.5 to 4 m, on the grid: as dense whatever their number.
pub fn octagons(seed: u64, n: usize) -> Vec<Vec<Point>> {
    worlds::snapped(&worlds::octagons(&mut Dice::new(seed), n))
}

/// Octagons on a lattice that do not touch.
pub fn apart(seed: u64, n: usize) -> Vec<Vec<Point>> {
    let mut dice = Dice::new(seed);
    let side = (n as f64).sqrt().ceil() as usize;
    let one = |i: usize, dice: &mut Dice| -> Outline {
        let cell =
            DVec2::new((i % side) as f64, (i / side) as f64) - DVec2::splat(0.5 * side as f64);
        let radius = dice.between(0.5, 3.5);
        worlds::star(dice, cell * 8.0, 8, 0.8 * radius, radius)
    };
    let all: Vec<Outline> = (0..n).map(|i| one(i, &mut dice)).collect();
    worlds::snapped(&all)
}

/// The outlines as our mesh takes them.
pub fn edges(outlines: &[Vec<Point>]) -> Vec<Vec<ExpandedEdge>> {
    worlds::expanded(outlines, &Collider::point())
}

/// Spade's mesh of outlines: corners in bulk, then every side, split where it crosses others. `None` where spade panics.
pub fn spade(outlines: &[Vec<Point>]) -> Option<Spade> {
    let corners = outlines
        .iter()
        .flatten()
        .map(|p| Point2::new(p.metres().x, p.metres().y));
    let corners: Vec<_> = corners.collect();
    std::panic::catch_unwind(|| {
        let mut mesh = Spade::bulk_load_cdt(corners, Vec::new()).ok()?;
        let mut first = 0;
        for outline in outlines {
            for i in 0..outline.len() {
                let end = |i: usize| FixedVertexHandle::from_index(first + i % outline.len());
                mesh.add_constraint_and_split(end(i), end(i + 1), |p| p);
            }
            first += outline.len();
        }
        Some(mesh)
    })
    .ok()
    .flatten()
}

/// Straight sweeps of 100 m among the first n octagons, from corners: start, end, in metres.
pub fn sweeps(mesh: &Mesh, octagons: usize, count: usize) -> Vec<(FaceId, DVec2, DVec2)> {
    let mut dice = Dice::new(4);
    let half = 0.6 * worlds::octagons_half_width(octagons);
    let mut all = Vec::new();
    while all.len() < count {
        let p = DVec2::new(dice.between(-half, half), dice.between(-half, half));
        let to = p + DVec2::from_angle(dice.between(0.0, std::f64::consts::TAU)) * 100.0;
        if let (Some(Place::Face(face)), Some(to)) = (mesh.locate(p, None), Point::snap(to)) {
            all.push((face, p, to.metres()));
        }
    }
    all
}

/// How many mesh edges our sweep along a line crosses.
pub fn edges_swept(mesh: &Mesh, (face, from, to): (FaceId, DVec2, DVec2)) -> usize {
    mesh.faces_along(from, to, Some(face)).count() - 1
}

/// The same for spade: the edges that its iterator names.
pub fn edges_of_spade(mesh: &Spade, from: DVec2, to: DVec2) -> usize {
    let point = |p: DVec2| Point2::new(p.x, p.y);
    LineIntersectionIterator::new(mesh, point(from), point(to))
        .filter(|met| matches!(met, Intersection::EdgeIntersection(_)))
        .count()
}

/// Locations along a random walk of 10 cm steps, each from the place of the one before: ns are for all of them.
pub fn walk(mesh: &Mesh, steps: &[DVec2]) -> usize {
    let (mut near, mut found) = (None, 0);
    for &at in steps {
        if let Some(Place::Face(face)) = mesh.locate(at, near) {
            (near, found) = (Some(face), found + 1);
        }
    }
    found
}

pub fn walk_in_spade(mesh: &Spade, steps: &[DVec2]) -> usize {
    use spade::PositionInTriangulation::*;
    let (mut near, mut found) = (FixedVertexHandle::from_index(0), 0);
    for &at in steps {
        if let OnFace(face) = mesh.locate_with_hint(Point2::new(at.x, at.y), near) {
            (near, found) = (mesh.face(face).vertices()[0].fix(), found + 1);
        }
    }
    found
}

pub fn steps(count: usize) -> Vec<DVec2> {
    let (mut dice, mut at) = (Dice::new(3), DVec2::ZERO);
    let mut step = || {
        at += DVec2::new(dice.between(-0.1, 0.1), dice.between(-0.1, 0.1));
        at
    };
    (0..count).map(|_| step()).collect()
}

/// Triangles of plain points by delaunator.
pub fn delaunator(points: &[delaunator::Point]) -> usize {
    delaunator::triangulate(points).triangles.len() / 3
}

/// The corners of outlines as delaunator takes them.
pub fn corners(outlines: &[Vec<Point>]) -> Vec<delaunator::Point> {
    let point = |p: &Point| delaunator::Point {
        x: p.metres().x,
        y: p.metres().y,
    };
    outlines.iter().flatten().map(point).collect()
}
