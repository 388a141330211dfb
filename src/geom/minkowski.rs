//! Outlines expanded by a collider, after which the body is a point.
//!
//! The reference point of a body at p touches the outline P iff p is in the Minkowski sum of P and the
//! reflected collider -C. The boundary of that sum lies on the *convolution* of the two outlines (Guibas,
//! Ramshaw, Stolfi 1983): every outline edge moved by the corner of -C that is extreme in its outward
//! direction, joined by arcs of -C around the corners of P, forwards at convex ones and backwards at reflex
//! ones. The result is one closed chain, self-crossing for concave outlines, whose winding number is never
//! negative and is positive exactly inside the sum: no cutting into convex parts, no union.
//!
//! Where an edge is parallel to a collider side, both ends of the side are extreme. A convex corner takes
//! the outer one and any other corner the inner one, which commutes with mirroring.

use super::drawn::{Aside, Drawn};
use super::grid::{Point, STEP};
use super::polygon::{area2, is_convex, turn};
use super::predicates::delta;
use std::cmp::Ordering;
use std::fmt;

/// What part of a feature's outline and of the collider an expanded edge comes from.
///
/// Equal in the meshes of all sizes of a body, wherever they share that part. Indices are those of
/// the outline as it was given, clockwise or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Source {
    /// Outline edge `edge` moved by a collider vertex (and lengthened, if a collider side is parallel to it).
    Edge {
        /// Index of the outline edge.
        edge: u32,
    },
    /// Collider edge `side` moved along to outline vertex `vertex`.
    Corner {
        /// Index of the outline vertex.
        vertex: u32,
        /// Label of the collider edge.
        side: u32,
    },
}

/// One edge of an expanded outline; the solid is on its left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExpandedEdge {
    /// Start.
    pub a: Point,
    /// End.
    pub b: Point,
    /// What it comes from.
    pub source: Source,
    /// How far beside its ends it was drawn.
    pub aside: Aside,
}

impl ExpandedEdge {
    /// An edge between grid points, drawn there.
    pub fn new(a: Point, b: Point, source: Source) -> ExpandedEdge {
        ExpandedEdge {
            a,
            b,
            source,
            aside: Aside::default(),
        }
    }
}

/// Why a collider is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColliderError {
    /// It must be one point, or strictly convex and counter-clockwise.
    NotConvex,
    /// A coordinate reaches further than [`Collider::REACH`] steps.
    TooLarge,
    /// There must be one label for each side.
    Labels,
}

impl fmt::Display for ColliderError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            ColliderError::NotConvex => {
                "a collider must be a point or strictly convex and counter-clockwise"
            }
            ColliderError::TooLarge => "a collider reaches further than 64 m",
            ColliderError::Labels => "a collider needs one label for each side",
        })
    }
}

impl std::error::Error for ColliderError {}

/// A body's shape: a convex polygon about the body's reference point, or the single point itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Collider {
    /// Corners, counter-clockwise, in steps from the reference point.
    corners: Vec<Point>,
    /// Label of the side that starts at the corner with the same index.
    labels: Vec<u32>,
}

impl Collider {
    /// Furthest coordinate that a corner may have, in steps: 64 m.
    pub const REACH: i32 = 1 << 22;

    /// A collider whose sides are labelled 0, 1, 2 ... in order.
    ///
    /// # Errors
    /// If it is not convex, not counter-clockwise or too large.
    pub fn new(corners: Vec<Point>) -> Result<Self, ColliderError> {
        let labels = (0..corners.len() as u32).collect();
        Self::with_labels(corners, labels)
    }

    /// A collider with chosen labels: sizes of one body label the sides that they share alike.
    ///
    /// # Errors
    /// If it is not convex, not counter-clockwise or too large, or has not one label per side.
    pub fn with_labels(corners: Vec<Point>, labels: Vec<u32>) -> Result<Self, ColliderError> {
        let far = |c: &i32| c.unsigned_abs() > Self::REACH.unsigned_abs();
        match () {
            () if corners.iter().any(|p| far(&p.x) || far(&p.y)) => Err(ColliderError::TooLarge),
            () if corners.len() != 1 && !is_convex(&corners) => Err(ColliderError::NotConvex),
            () if corners.len() != labels.len() => Err(ColliderError::Labels),
            () => Ok(Collider { corners, labels }),
        }
    }

    /// A body without size: the expanded outline is the outline.
    pub fn point() -> Self {
        Self::just(Point::default())
    }

    /// One point of a body, in steps from its reference point.
    pub(super) fn just(at: Point) -> Self {
        Collider {
            corners: vec![at],
            labels: vec![0],
        }
    }

    /// The standing hero, 13/16 m wide and 109/64 m tall, so that he passes where it is 0.82 m wide and 1.71 m high; the reference point is the middle of the flat foot.
    pub fn hero() -> Self {
        Self::hexagon(metres(109.0 / 64.0))
    }

    /// The crouching hero, 61/64 m tall, who passes under 0.96 m: the same up to the sides, so that both sizes stand on the same floors.
    pub fn hero_crouched() -> Self {
        Self::hexagon(metres(61.0 / 64.0))
    }

    /// Foot, two flanks that widen from it, two upright sides and a flat top at the given height in steps.
    fn hexagon(top: i32) -> Self {
        let (foot, half, hip) = (metres(0.25), metres(13.0 / 32.0), metres(11.0 / 32.0));
        let corners = [
            (-foot, 0),
            (foot, 0),
            (half, hip),
            (half, top),
            (-half, top),
            (-half, hip),
        ];
        let corners = corners.map(|(x, y)| Point::new(x, y)).to_vec();
        Collider {
            corners,
            labels: (0..6).collect(),
        }
    }

    /// Corners, counter-clockwise, in steps from the reference point.
    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// Corner `i` of the reflected collider, counter-clockwise as well.
    pub(super) fn reflected(&self, i: usize) -> Point {
        Point::new(-self.corners[i].x, -self.corners[i].y)
    }

    /// Index of the corner after corner `i`, counter-clockwise.
    pub(super) fn after(&self, i: usize) -> usize {
        (i + 1) % self.corners.len()
    }

    /// Index of the corner before corner `i`.
    pub(super) fn before(&self, i: usize) -> usize {
        (i + self.corners.len() - 1) % self.corners.len()
    }

    /// Label of the side that starts at corner `i`.
    pub(super) fn label(&self, i: usize) -> u32 {
        self.labels[i]
    }

    /// First and last (counter-clockwise) of the corners of the reflected collider that are furthest to the
    /// right of a direction: equal, or the ends of the side that is parallel to it.
    pub(super) fn extreme(&self, direction: (i64, i64)) -> (usize, usize) {
        let n = self.corners.len();
        let height = |i: usize| {
            let p = self.reflected(i);
            direction.1 * i64::from(p.x) - direction.0 * i64::from(p.y)
        };
        let top = (0..n).map(height).max().unwrap_or(0);
        let is_top = |&i: &usize| height(i) == top;
        let first = (0..n)
            .find(|&i| is_top(&i) && !is_top(&self.before(i)))
            .unwrap_or(0);
        let last = (0..n)
            .find(|&i| is_top(&i) && !is_top(&self.after(i)))
            .unwrap_or(first);
        (first, last)
    }
}

/// Grid steps in a dyadic number of metres.
fn metres(m: f64) -> i32 {
    (m / STEP) as i32
}

/// An outline on its way around a collider. Its corners and edges are counted counter-clockwise here.
struct Walker<'a> {
    outline: &'a [Point],
    collider: &'a Collider,
    /// Whether the outline was given clockwise.
    reversed: bool,
}

/// Expands a simple outline (clockwise ones are reversed first) by a collider: the edges of one closed chain, in order.
pub fn expand(outline: &[Point], collider: &Collider) -> Vec<ExpandedEdge> {
    let walker = Walker {
        outline,
        collider,
        reversed: area2(outline) < 0,
    };
    let mut edges = Vec::with_capacity(outline.len() + collider.corners.len());
    for i in 0..outline.len() {
        walker.edge(i, &mut edges);
        walker.corner(i + 1, &mut edges);
    }
    edges
}

/// The same for an outline as it was drawn: it goes round the collider on the grid, and each edge keeps how far beside it was
/// drawn.
pub fn expand_drawn(outline: &[Drawn], collider: &Collider) -> Vec<ExpandedEdge> {
    let points: Vec<Point> = outline.iter().map(|corner| corner.point()).collect();
    let mut edges = expand(&points, collider);
    note_aside(&mut edges, outline, area2(&points) < 0);
    edges
}

/// Notes in edges how far beside the ends of what they come from was drawn: of an outline that they follow, or follow backwards.
pub(super) fn note_aside(edges: &mut [ExpandedEdge], outline: &[Drawn], backwards: bool) {
    for edge in edges {
        let (from, to) = match edge.source {
            Source::Corner { vertex, .. } => (vertex as usize, vertex as usize),
            Source::Edge { edge } => (edge as usize, (edge as usize + 1) % outline.len()),
        };
        let (from, to) = (outline[from], outline[to]);
        edge.aside = match backwards {
            true => Aside::of(to, from),
            false => Aside::of(from, to),
        };
    }
}

impl Walker<'_> {
    /// Index in the outline as given of the i-th corner counter-clockwise.
    fn index(&self, i: usize) -> usize {
        let n = self.outline.len();
        if self.reversed { n - 1 - i % n } else { i % n }
    }

    /// Index in the outline as given of the edge from the i-th corner to the next.
    fn edge_index(&self, i: usize) -> usize {
        if self.reversed {
            self.index(i + 1)
        } else {
            self.index(i)
        }
    }

    fn point(&self, i: usize) -> Point {
        self.outline[self.index(i)]
    }

    fn direction(&self, i: usize) -> (i64, i64) {
        delta(self.point(i), self.point(i + 1))
    }

    /// How the outline turns at its i-th corner: `Greater` at a convex one.
    fn turn(&self, i: usize) -> Ordering {
        turn(
            self.direction(i + self.outline.len() - 1),
            self.direction(i),
        )
    }

    /// Collider corners with which the edge into and the edge out of the i-th corner reach it.
    fn contacts(&self, i: usize) -> (usize, usize) {
        let into = self
            .collider
            .extreme(self.direction(i + self.outline.len() - 1));
        let out = self.collider.extreme(self.direction(i));
        if self.turn(i) == Ordering::Greater {
            (into.1, out.0)
        } else {
            (into.0, out.1)
        }
    }

    /// The i-th edge, from its contact at one corner to its contact at the next.
    fn edge(&self, i: usize, edges: &mut Vec<ExpandedEdge>) {
        let start = self.collider.reflected(self.contacts(i).1);
        let end = self.collider.reflected(self.contacts(i + 1).0);
        let source = Source::Edge {
            edge: self.edge_index(i) as u32,
        };
        push(
            edges,
            sum(self.point(i), start),
            sum(self.point(i + 1), end),
            source,
        );
    }

    /// The arc around the i-th corner: forwards along the collider where the outline is convex or straight,
    /// backwards where it is reflex.
    fn corner(&self, i: usize, edges: &mut Vec<ExpandedEdge>) {
        let (mut at, end) = self.contacts(i);
        let forward = self.turn(i) != Ordering::Less;
        let p = self.point(i);
        while at != end {
            let next = if forward {
                self.collider.after(at)
            } else {
                self.collider.before(at)
            };
            let side = self.collider.label(if forward { at } else { next });
            let source = Source::Corner {
                vertex: self.index(i) as u32,
                side,
            };
            push(
                edges,
                sum(p, self.collider.reflected(at)),
                sum(p, self.collider.reflected(next)),
                source,
            );
            at = next;
        }
    }
}

pub(super) fn sum(p: Point, q: Point) -> Point {
    Point::new(p.x + q.x, p.y + q.y)
}

/// Adds an edge, unless it has no length.
pub(super) fn push(edges: &mut Vec<ExpandedEdge>, a: Point, b: Point, source: Source) {
    if a != b {
        edges.push(ExpandedEdge::new(a, b, source));
    }
}
