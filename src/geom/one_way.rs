//! One-way polylines expanded by a collider, and regions by one point of a body.
//!
//! A one-way polyline has a front: walked in order, it is on the left, so that a polyline drawn from left to right has its
//! front up. Think of it as an outline without area, walked there and back: on the way back its outward normal n is the
//! front's. Of the expansion of that outline, this keeps what a body that comes from the front can touch: the edges
//! whose outward normal m has m.n > 0.
//!
//! ```text
//!          front
//!        <---------      the edge, moved by the corner (or side) of the collider that reaches furthest towards it
//!       v  o-----o  ^    caps: the sides of the reflected collider that look to the front, moved to both ends
//! ```
//!
//! At a joint that is convex towards the front the collider's sides between both normals close the gap. At any other joint
//! the edges overlap: a body may come through one of them from behind and still rest on the other.

use super::drawn::Drawn;
use super::grid::Point;
use super::minkowski::{Collider, ExpandedEdge, Source, expand, note_aside, push, sum};
use super::polygon::{OutlineError, turn};
use super::predicates::{delta, dot, orient2d};
use std::cmp::Ordering;

/// Checks that a polyline has a side to be its front everywhere. It may cross and touch itself.
///
/// # Errors
/// If it has fewer than two corners, an edge without length, or turns back on itself.
pub fn check_polyline(polyline: &[Point]) -> Result<(), OutlineError> {
    let corners = polyline.len();
    if corners < 2 {
        return Err(OutlineError::TooShort { corners });
    }
    if let Some(edge) = polyline.windows(2).position(|pair| pair[0] == pair[1]) {
        return Err(OutlineError::ZeroLength { edge });
    }
    let spike = |p: &[Point]| {
        orient2d(p[0], p[1], p[2]) == 0 && dot(delta(p[1], p[0]), delta(p[1], p[2])) > 0
    };
    match polyline.windows(3).position(spike) {
        Some(i) => Err(OutlineError::Spike { corner: i + 1 }),
        None => Ok(()),
    }
}

/// Expands a one-way polyline, which passes [`check_polyline`], by a collider. Walked from left to right its front is up.
///
/// The edges run against the polyline, so that their front is on their right, like the free side of a solid's.
/// Indices in their sources are those of the polyline as it was given. By a point, it is the polyline itself.
pub fn expand_one_way(polyline: &[Point], collider: &Collider) -> Vec<ExpandedEdge> {
    let way_back = WayBack { polyline, collider };
    let mut edges = Vec::with_capacity(polyline.len() + collider.corners().len());
    way_back.first_cap(&mut edges);
    for i in (0..polyline.len().saturating_sub(1)).rev() {
        way_back.edge(i, &mut edges);
        if i > 0 {
            way_back.joint(i, &mut edges);
        }
    }
    way_back.last_cap(&mut edges);
    edges
}

/// The same for a polyline as it was drawn: it goes round the collider on the grid, and each edge keeps how far beside it was
/// drawn.
pub fn expand_one_way_drawn(polyline: &[Drawn], collider: &Collider) -> Vec<ExpandedEdge> {
    let points: Vec<Point> = polyline.iter().map(|corner| corner.point()).collect();
    let mut edges = expand_one_way(&points, collider);
    note_aside(&mut edges, polyline, true);
    edges
}

/// The edges around a place where one point of the body, `at` steps from its reference point, is inside an outline.
///
/// `at` must be within [`Collider::REACH`], as the corners of colliders are.
pub fn expand_about(outline: &[Point], at: Point) -> Vec<ExpandedEdge> {
    expand(outline, &Collider::just(at))
}

/// A polyline walked from its last corner to its first, around a collider.
struct WayBack<'a> {
    polyline: &'a [Point],
    collider: &'a Collider,
}

impl WayBack<'_> {
    /// Direction of edge i on the way back.
    fn direction(&self, i: usize) -> (i64, i64) {
        delta(self.polyline[i + 1], self.polyline[i])
    }

    /// Collider corners with which the edge into corner i, counted along the polyline, and the edge out of it reach it.
    ///
    /// As in the expansion of outlines: of two extreme corners a convex joint takes the outer one.
    fn contacts(&self, i: usize) -> (usize, usize) {
        let into = self.collider.extreme(self.direction(i));
        let out = self.collider.extreme(self.direction(i - 1));
        match turn(self.direction(i), self.direction(i - 1)) {
            Ordering::Greater => (into.1, out.0),
            _ => (into.0, out.1),
        }
    }

    /// Edge i, from its contact at corner i + 1 to its contact at corner i.
    fn edge(&self, i: usize, edges: &mut Vec<ExpandedEdge>) {
        let start = if i + 2 == self.polyline.len() {
            self.collider.extreme(self.direction(i)).0
        } else {
            self.contacts(i + 1).1
        };
        let end = if i == 0 {
            self.collider.extreme(self.direction(i)).1
        } else {
            self.contacts(i).0
        };
        push(
            edges,
            sum(self.polyline[i + 1], self.collider.reflected(start)),
            sum(self.polyline[i], self.collider.reflected(end)),
            Source::Edge { edge: i as u32 },
        );
    }

    /// The arc around corner i, if the joint is convex or straight.
    fn joint(&self, i: usize, edges: &mut Vec<ExpandedEdge>) {
        if turn(self.direction(i), self.direction(i - 1)) == Ordering::Less {
            return;
        }
        let (mut at, end) = self.contacts(i);
        while at != end {
            self.side(i, at, edges);
            at = self.collider.after(at);
        }
    }

    /// The collider's sides before the first contact that look to the front of the last edge, in order.
    fn first_cap(&self, edges: &mut Vec<ExpandedEdge>) {
        let Some(last) = self.polyline.len().checked_sub(2) else {
            return;
        };
        let direction = self.direction(last);
        let contact = self.collider.extreme(direction).0;
        let mut at = contact;
        while self.looks_to_front(self.collider.before(at), direction) {
            at = self.collider.before(at);
        }
        while at != contact {
            self.side(last + 1, at, edges);
            at = self.collider.after(at);
        }
    }

    /// The collider's sides after the last contact that look to the front of the first edge.
    fn last_cap(&self, edges: &mut Vec<ExpandedEdge>) {
        if self.polyline.len() < 2 {
            return;
        }
        let direction = self.direction(0);
        let mut at = self.collider.extreme(direction).1;
        while self.looks_to_front(at, direction) {
            self.side(0, at, edges);
            at = self.collider.after(at);
        }
    }

    /// Whether the outward normal of a side of the reflected collider has a part along the normal of a direction.
    fn looks_to_front(&self, side: usize, direction: (i64, i64)) -> bool {
        let (a, b) = (
            self.collider.reflected(side),
            self.collider.reflected(self.collider.after(side)),
        );
        dot(delta(a, b), direction) > 0
    }

    /// Adds a side of the reflected collider, moved along to a corner of the polyline.
    fn side(&self, vertex: usize, side: usize, edges: &mut Vec<ExpandedEdge>) {
        let p = self.polyline[vertex];
        let next = self.collider.after(side);
        let source = Source::Corner {
            vertex: vertex as u32,
            side: self.collider.label(side),
        };
        push(
            edges,
            sum(p, self.collider.reflected(side)),
            sum(p, self.collider.reflected(next)),
            source,
        );
    }
}
