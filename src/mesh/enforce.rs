//! Putting an edge into the triangulation: what it crosses gives way.
//!
//! The triangles that the line meets are taken as one polygon, which the line cuts into two. Each is filled from the
//! line outwards: of its corners take the one whose circle through both ends of the base holds no other, make that
//! triangle, and go on with what remains beyond its two other sides (Anglada 1997). The edges and
//! faces that were there are exactly enough.

use super::topology::{Quarter, sym};
use super::triangulation::Triangulation;
use crate::geom::predicates::{in_circle, orient2d};

/// What the line between two vertices runs through.
#[derive(Default)]
struct Channel {
    /// The edges that it crosses, in order, each from right to left.
    edges: Vec<Quarter>,
    /// The triangles that it meets.
    faces: Vec<u32>,
    /// The border on its left; each edge has the channel on its own left, and so leads backwards.
    left: Vec<Quarter>,
    /// The border on its right.
    right: Vec<Quarter>,
}

impl Triangulation {
    /// Fixes the edge between two vertices of a legal triangulation, which is made if it is not there.
    ///
    /// All edges that cross it must be free, and no vertex may lie on it.
    pub fn enforce(&mut self, v: u32, w: u32) -> Quarter {
        let there = self.topology.edge_between(w, v).map(sym);
        let e = there.unwrap_or_else(|| self.make_way(v, w));
        self.fix(e);
        self.legalise();
        e
    }

    /// Makes the edge between two vertices that no edge joins.
    fn make_way(&mut self, v: u32, w: u32) -> Quarter {
        let mut channel = self.channel(v, w);
        channel.left.reverse();
        let fixed = channel.edges.iter().any(|&e| self.is_fixed(e));
        debug_assert!(!fixed, "two fixed edges cross");
        for &q in channel.left.iter().chain(&channel.right) {
            self.topology.anchor(q);
        }
        let border = channel.left.iter().chain(&channel.right);
        self.suspect(border.chain(&channel.edges));
        let Channel {
            mut edges,
            mut faces,
            left,
            right,
        } = channel;
        let e = self.take_edge(&mut edges, v, w);
        self.fill(e, &left, &mut edges, &mut faces);
        self.fill(sym(e), &right, &mut edges, &mut faces);
        e
    }

    /// Walks along the line between two vertices that no edge joins.
    fn channel(&self, v: u32, w: u32) -> Channel {
        let t = &self.topology;
        let (a, b) = (self.point(v), self.point(w));
        let is_entered = |q: &Quarter| {
            let (p, n) = (self.point(t.dest(*q)), self.point(t.apex(*q)));
            orient2d(a, p, b) > 0 && orient2d(a, n, b) < 0 && orient2d(a, p, n) > 0
        };
        let first = t.ring(v).find(is_entered);
        let first = first.expect("a line between vertices that no edge joins enters a triangle");
        let mut channel = Channel {
            faces: vec![t.left(first)],
            left: vec![t.lprev(first)],
            right: vec![first],
            ..Channel::default()
        };
        let mut e = t.lnext(first);
        loop {
            channel.edges.push(e);
            e = sym(e);
            channel.faces.push(t.left(e));
            let apex = t.apex(e);
            let side = orient2d(a, b, self.point(apex));
            if side >= 0 {
                channel.left.push(t.lprev(e));
            }
            if side <= 0 {
                channel.right.push(t.lnext(e));
            }
            if apex == w {
                return channel;
            }
            e = if side > 0 { t.lnext(e) } else { t.lprev(e) };
        }
    }

    /// Fills a polygon, left of its base edge, that is closed by a border from the end of the base to its start.
    fn fill<'a>(
        &mut self,
        base: Quarter,
        border: &'a [Quarter],
        edges: &mut Vec<Quarter>,
        faces: &mut Vec<u32>,
    ) {
        let mut todo = vec![(base, border)];
        while let Some((base, border)) = todo.pop() {
            let (start, end) = (self.topology.origin(base), self.topology.dest(base));
            let (near, far) = border.split_at(self.closest(start, end, border));
            let corner = self.topology.origin(far[0]);
            // A side is the border beyond, if that is one edge; else a new edge with more to fill beyond it.
            let mut side = |from: u32, to: u32, beyond: &'a [Quarter]| {
                if let [edge] = beyond {
                    return *edge;
                }
                let side = self.take_edge(edges, from, to);
                todo.push((sym(side), beyond));
                side
            };
            let sides = [base, side(end, corner, near), side(corner, start, far)];
            let face = faces.pop().expect("there are as many faces as before");
            self.topology.set_triangle(sides, face);
        }
    }

    /// An edge that is no longer needed, between other vertices.
    fn take_edge(&mut self, edges: &mut Vec<Quarter>, v: u32, w: u32) -> Quarter {
        let e = edges.pop().expect("there are as many edges as before");
        self.topology.set_ends(e, v, w);
        e
    }

    /// Index in a border of the edge that starts at the corner whose circle through two points holds no other corner.
    ///
    /// Corners may lie on the wrong side of a base within the channel, but then outside the circle of the triangle
    /// on that side; so the determinant, whose sign turns with the side, prefers every corner on the right side.
    fn closest(&self, start: u32, end: u32, border: &[Quarter]) -> usize {
        let point = |i: usize| self.point(self.topology.origin(border[i]));
        let (a, b) = (self.point(start), self.point(end));
        let better = |best: usize, i: usize| {
            if in_circle(a, b, point(best), point(i)) > 0 {
                i
            } else {
                best
            }
        };
        (2..border.len()).fold(1, better)
    }
}
