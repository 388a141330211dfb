//! The constrained Delaunay triangulation: a topology, the points of its vertices and the edges that are fixed.
//!
//! A free edge between triangles (o d l) and (d o r) is *legal* if r is outside the circle through o, d and l. Of
//! cocircular quadrangles the diagonal at the lexicographically smallest corner is legal: as if each vertex
//! were lifted above the paraboloid by an infinitesimal that shrinks with its rank, so flipping illegal edges
//! (Lawson 1977) ends, always in the same triangulation. It depends on the vertices and the fixed edges alone.

use super::topology::{NONE, Quarter, Topology, sym};
use super::walk::{Found, walk};
use crate::geom::predicates::{in_circle, orient2d};
use crate::geom::{BOUND, Point};
use std::cmp::Ordering;

/// Furthest coordinate of the outer box, in steps; all other vertices lie strictly inside.
pub const EDGE_OF_WORLD: i32 = BOUND - 1;

/// Corners of the outer box: vertices 0 to 3.
pub const CORNERS: [Point; 4] = [
    Point::new(-EDGE_OF_WORLD, -EDGE_OF_WORLD),
    Point::new(EDGE_OF_WORLD, -EDGE_OF_WORLD),
    Point::new(EDGE_OF_WORLD, EDGE_OF_WORLD),
    Point::new(-EDGE_OF_WORLD, EDGE_OF_WORLD),
];

/// The triangulation.
#[derive(Clone, Debug)]
pub struct Triangulation {
    /// Who is next to whom.
    pub topology: Topology,
    /// Point of each vertex.
    points: Vec<Point>,
    /// Per edge record: whether the edge must stay.
    fixed: Vec<bool>,
    /// Edges that may have become illegal.
    suspects: Vec<Quarter>,
    /// Where the next walk starts: the vertex that was inserted last, or one that is nearer to the next.
    recent: u32,
}

impl Triangulation {
    /// The outer box alone.
    pub fn new() -> Self {
        let topology = Topology::square();
        let outer = |q: Quarter| {
            topology.left(q) == super::topology::OUTSIDE
                || topology.left(sym(q)) == super::topology::OUTSIDE
        };
        let fixed = topology.edges().map(outer).collect();
        let suspects = topology.edges().collect();
        let mut t = Triangulation {
            topology,
            points: CORNERS.to_vec(),
            fixed,
            suspects,
            recent: 0,
        };
        t.legalise();
        t
    }

    /// Point of a vertex.
    #[inline]
    pub fn point(&self, v: u32) -> Point {
        self.points[v as usize]
    }

    /// Points by vertex id; those of unused ids mean nothing.
    #[inline]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Whether an edge must stay: constraints and the outer box.
    #[inline]
    pub fn is_fixed(&self, q: Quarter) -> bool {
        self.fixed
            .get((q >> 2) as usize)
            .is_some_and(|&fixed| fixed)
    }

    /// Makes an edge stay whatever its circle says.
    pub fn fix(&mut self, q: Quarter) {
        let quads = self.topology.quad_count();
        if self.fixed.len() < quads {
            self.fixed.resize(quads, false);
        }
        self.fixed[(q >> 2) as usize] = true;
    }

    /// Lets an edge go.
    pub fn release(&mut self, q: Quarter) {
        self.fixed[(q >> 2) as usize] = false;
        self.suspects.push(q);
    }

    /// Whether a free edge is legal.
    #[inline]
    pub fn is_legal(&self, e: Quarter) -> bool {
        self.is_legal_from(e, self.point(self.topology.apex(e)))
    }

    /// The same, given the corner on its left.
    #[inline]
    fn is_legal_from(&self, e: Quarter, l: Point) -> bool {
        let [o, d, r] = self.topology.triangle_beyond(e);
        let (o, d, r) = (self.point(o), self.point(d), self.point(r));
        match in_circle(o, d, l, r).cmp(&0) {
            Ordering::Less => true,
            Ordering::Greater => false,
            Ordering::Equal => is_first(o, d, l, r),
        }
    }

    /// Makes room for so many more vertices.
    pub fn reserve(&mut self, vertices: usize) {
        self.points.reserve(vertices);
        self.topology.reserve(vertices);
    }

    /// Lets the next insertion look for its place from a vertex.
    pub fn start_at(&mut self, v: u32) {
        self.recent = v;
    }

    /// Inserts a vertex into a legal triangulation and makes it legal again. The point must lie strictly inside
    /// the box and on no vertex and no fixed edge.
    pub fn insert(&mut self, v: u32, p: Point) {
        if self.points.len() <= v as usize {
            self.points.resize(v as usize + 1, p);
        }
        self.points[v as usize] = p;
        let start = if self.topology.has_vertex(self.recent) {
            self.recent
        } else {
            0
        };
        match walk(&self.topology, &self.points, start, &p) {
            Found::Face(e) => {
                self.topology.insert(v, self.topology.left(e));
            }
            Found::Edge(e) => {
                // Into the face beside the edge, where it makes a triangle without area, which the flip opens.
                debug_assert!(!self.is_fixed(e), "a new vertex lies on a fixed edge");
                self.topology.insert(v, self.topology.left(e));
                self.topology.flip(e);
            }
            Found::Vertex(w) => debug_assert!(false, "vertex {v} lies on vertex {w}"),
        }
        self.recent = v;
        self.legalise_around(v);
    }

    /// Legalises after an insertion: only edges across from the new vertex can be illegal.
    fn legalise_around(&mut self, v: u32) {
        let mut opposite: Vec<Quarter> = std::mem::take(&mut self.suspects);
        let settled = opposite.len();
        let first = self.topology.vertex_edge(v);
        let mut spoke = first;
        loop {
            opposite.push(self.topology.lnext(spoke));
            spoke = self.topology.onext(spoke);
            if spoke == first {
                break;
            }
        }
        let p = self.point(v);
        while opposite.len() > settled {
            let Some(e) = opposite.pop() else { break };
            if !self.is_fixed(e) && !self.is_legal_from(e, p) {
                // v is the left corner; beyond are the two sides of the right triangle.
                let (m1, m2) = (self.topology.lnext(sym(e)), self.topology.lprev(sym(e)));
                self.topology.flip(e);
                opposite.push(m1);
                opposite.push(m2);
            }
        }
        self.suspects = opposite;
    }

    /// Flips illegal free edges until there are none.
    pub fn legalise(&mut self) {
        while let Some(e) = self.suspects.pop() {
            if self.topology.origin(e) != NONE && !self.is_fixed(e) && !self.is_legal(e) {
                self.flip(e);
            }
        }
    }

    /// Notes edges that may have become illegal.
    pub fn suspect<'a>(&mut self, edges: impl IntoIterator<Item = &'a Quarter>) {
        self.suspects.extend(edges);
    }

    /// Flips an edge and suspects the sides of its quadrangle. The edge itself is a side of the next flip nearby,
    /// or stays as it is.
    fn flip(&mut self, e: Quarter) {
        let t = &mut self.topology;
        self.suspects
            .extend([t.lnext(e), t.lprev(e), t.lnext(sym(e)), t.lprev(sym(e))]);
        t.flip(e);
    }

    /// Deletes a vertex all of whose edges are free. Call [`Self::legalise`] when all is done.
    ///
    /// Flips cut ears off the star of v until three spokes are left. A spoke v-w can be flipped if the ear
    /// p w n turns left and leaves v inside or on the new edge; of four or more spokes one always can
    /// (of two ears that do not overlap, only one can hold v).
    ///
    /// ```text
    ///       w                 w
    ///     / | \             /   \
    ///    n  |  p     ->    n --- p
    ///     \ | /             \   /
    ///       v                 v
    /// ```
    pub fn delete(&mut self, v: u32) {
        let mut spoke = self.topology.vertex_edge(v);
        let mut degree = self.topology.ring(v).count();
        while degree > 3 {
            let t = &self.topology;
            debug_assert!(!self.is_fixed(spoke), "a vertex on a fixed edge is deleted");
            let next = t.onext(spoke);
            let [w, p, n] = [spoke, t.oprev(spoke), next].map(|q| self.point(t.dest(q)));
            if orient2d(p, w, n) > 0 && orient2d(self.point(v), p, n) >= 0 {
                self.flip(spoke);
                degree -= 1;
            }
            spoke = next;
        }
        let face = self.topology.remove(v);
        let e = self.topology.face_edge(face);
        self.suspects
            .extend([e, self.topology.lnext(e), self.topology.lprev(e)]);
    }
}

/// Which diagonal of a cocircular quadrangle is legal: that at the smallest corner.
#[cold]
fn is_first(o: Point, d: Point, l: Point, r: Point) -> bool {
    o.min(d) < l.min(r)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a small lattice in a scrambled order: full of cocircular and collinear ones.
    fn lattice() -> Vec<Point> {
        (0..49)
            .map(|i| i * 23 % 49)
            .map(|i| Point::new(i % 7, i / 7))
            .collect()
    }

    fn triangulated(points: &[Point]) -> Triangulation {
        let mut t = Triangulation::new();
        for (v, &p) in (4..).zip(points) {
            t.insert(v, p);
        }
        t
    }

    fn triangles(t: &Triangulation) -> Vec<[Point; 3]> {
        let corners = |f: u32| t.topology.sides(f).map(|e| t.point(t.topology.origin(e)));
        let sorted = |mut c: [Point; 3]| {
            c.sort();
            c
        };
        let mut all: Vec<_> = t.topology.faces().map(corners).map(sorted).collect();
        all.sort();
        all
    }

    #[test]
    fn no_circle_holds_a_vertex() {
        let points: Vec<Point> = (0..60)
            .map(|i| Point::new(i * 7919 % 101, i * i * 31 % 97))
            .collect();
        let t = triangulated(&points);
        for f in t.topology.faces() {
            let [a, b, c] = t.topology.sides(f).map(|e| t.point(t.topology.origin(e)));
            let inside = |&&p: &&Point| in_circle(a, b, c, p) > 0;
            assert_eq!(
                points.iter().chain(&CORNERS).find(inside),
                None,
                "{a:?} {b:?} {c:?}"
            );
        }
    }

    #[test]
    fn deleting_undoes_inserting_in_any_order() {
        let points = lattice();
        let mut t = triangulated(&points);
        for v in 4 + 9..4 + points.len() as u32 {
            t.delete(v);
            t.legalise();
        }
        assert_eq!(triangles(&t), triangles(&triangulated(&points[..9])));
    }

    #[test]
    fn an_enforced_edge_stays_until_it_is_released() {
        let points = lattice();
        let mut t = triangulated(&points);
        let before = triangles(&t);
        let id = |p: Point| 4 + points.iter().position(|&q| q == p).unwrap() as u32;
        let (v, w) = (id(Point::new(0, 1)), id(Point::new(6, 2)));
        let e = t.enforce(v, w);
        t.fix(e);
        t.legalise();
        let e = t.topology.edge_between(v, w).expect("it is fixed");
        assert_ne!(triangles(&t), before);
        t.release(e);
        t.legalise();
        assert_eq!(triangles(&t), before);
    }
}
