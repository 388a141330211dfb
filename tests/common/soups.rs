//! Soups of segments and polygons with small coordinates, and what must hold of every mesh.

#![allow(dead_code, reason = "each test uses its own part")]

use super::slow::{self, Spot, spot};
use super::worlds::Dice;
use edgewalker::geom::{Collider, ExpandedEdge, Point, check_outline, expand};
use edgewalker::mesh::{FeatureId, Mesh};

/// A segment of some length with small coordinates around x = 0, where pixels change their borders.
pub fn segment(dice: &mut Dice) -> (Point, Point) {
    loop {
        let (a, b) = (dice.point(13), dice.point(13));
        if a != b {
            return (Point::new(a.x - 6, a.y), Point::new(b.x - 6, b.y));
        }
    }
}

/// 3 to 7 loose segments.
pub fn segments(dice: &mut Dice) -> Vec<(Point, Point)> {
    (0..3 + dice.below(5)).map(|_| segment(dice)).collect()
}

/// Some small simple polygons that overlap, expanded by a small collider.
pub fn polygons(dice: &mut Dice, n: usize, collider: &Collider) -> Vec<Vec<ExpandedEdge>> {
    let mut features = Vec::new();
    while features.len() < n {
        let at = dice.point(24);
        let corner = |p: Point| Point::new(at.x + p.x - 16, at.y + p.y);
        let outline: Vec<Point> = (0..3 + dice.below(4))
            .map(|_| corner(dice.point(16)))
            .collect();
        if check_outline(&outline).is_ok() {
            features.push(expand(&outline, collider));
        }
    }
    features
}

pub fn small_collider() -> Collider {
    Collider::new(
        [(-1, 0), (1, 0), (2, 1), (2, 3), (-2, 3), (-2, 1)]
            .map(|(x, y)| Point::new(x, y))
            .to_vec(),
    )
    .unwrap()
}

/// Asserts all invariants.
pub fn sound(mesh: &Mesh, story: &dyn std::fmt::Debug) {
    if let Err(wrong) = mesh.check() {
        panic!("{wrong}\n{story:?}");
    }
}

/// The outline of a feature after snapping, in thirds of a step.
pub fn snapped_outline(mesh: &Mesh, feature: FeatureId) -> Vec<Spot> {
    let chains = mesh.segments_of(feature).iter().map(|&s| mesh.chain(s));
    let starts = chains.flat_map(|chain| &chain[..chain.len() - 1]);
    starts
        .map(|&v| spot(mesh.point(v)))
        .map(|(x, y)| (3 * x, 3 * y))
        .collect()
}

/// Asserts that a face is covered exactly by the features whose snapped outline winds around its centre.
pub fn covers_agree(mesh: &Mesh, story: &dyn std::fmt::Debug) -> (usize, usize) {
    let outlines: Vec<_> = mesh
        .features()
        .map(|f| (f, snapped_outline(mesh, f)))
        .collect();
    let mut counts = (0, 0);
    for face in mesh.faces() {
        let corners = mesh.corners(face).map(spot);
        // Three times the centre, in thirds of a step, is the sum of the corners.
        let centre = corners
            .iter()
            .fold((0, 0), |sum, c| (sum.0 + c.0, sum.1 + c.1));
        let around: Vec<FeatureId> = outlines
            .iter()
            .filter(|(_, o)| slow::winding(o, centre) > 0)
            .map(|o| o.0)
            .collect();
        assert_eq!(mesh.cover(face), around, "{face:?} {corners:?}\n{story:?}");
        assert_eq!(mesh.is_solid(face), !around.is_empty());
        if around.is_empty() {
            counts.0 += 1
        } else {
            counts.1 += 1
        }
    }
    counts
}
