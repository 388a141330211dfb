//! Finding a place by walking straight towards it through the triangles, by exact tests.
//!
//! The walk follows the line from a vertex to the target (Devillers, Pion, Teillaud 2002): around the vertex
//! to the triangle that the line enters, then across one edge after the other. Where the line meets a vertex, the
//! walk starts again from there. Every step is closer to the target along the line, so the walk ends, in any
//! triangulation.

use super::topology::{Quarter, Topology, sym};
use crate::geom::Point;
use crate::geom::predicates::{orient2d, side};
use glam::DVec2;
use std::cmp::Ordering;

/// What can be walked to. It must lie strictly inside the outer box.
pub trait Target {
    /// On which side of the directed line a -> b it lies; `Greater` is left.
    fn side(&self, a: Point, b: Point) -> Ordering;
    /// Whether it is this grid point.
    fn is(&self, p: Point) -> bool;
}

impl Target for Point {
    #[inline]
    fn side(&self, a: Point, b: Point) -> Ordering {
        orient2d(a, b, *self).cmp(&0)
    }
    #[inline]
    fn is(&self, p: Point) -> bool {
        *self == p
    }
}

/// A position in steps, between grid points.
impl Target for DVec2 {
    #[inline]
    fn side(&self, a: Point, b: Point) -> Ordering {
        side(a, b, *self)
    }
    #[inline]
    fn is(&self, p: Point) -> bool {
        self.x == f64::from(p.x) && self.y == f64::from(p.y)
    }
}

/// Where a walk ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// Strictly inside the face left of this edge.
    Face(Quarter),
    /// Strictly inside this edge.
    Edge(Quarter),
    /// At this vertex.
    Vertex(u32),
}

/// Where the line from a vertex to the target leaves the vertex.
enum Exit {
    /// Along this edge.
    Along(Quarter),
    /// Into the left face of this edge, strictly between its edges.
    Between(Quarter),
}

/// Walks from a vertex to a target.
pub fn walk(t: &Topology, points: &[Point], start: u32, target: &impl Target) -> Found {
    let mut from = start;
    loop {
        if target.is(points[from as usize]) {
            return Found::Vertex(from);
        }
        let next = match exit(t, points, from, target) {
            Exit::Along(e) => follow(t, points, e, target),
            Exit::Between(e) => cross(t, points, from, t.lnext(e), target),
        };
        match next {
            Ok(found) => return found,
            Err(vertex) => from = vertex,
        }
    }
}

/// Turns around a vertex to where the line to the target leaves it.
fn exit(t: &Topology, points: &[Point], from: u32, target: &impl Target) -> Exit {
    let side = |e: Quarter| target.side(points[from as usize], points[t.dest(e) as usize]);
    // Find the edge which the target is not right of while it is right of the next one. Neighbours around
    // a vertex are less than half a turn apart, so `Equal` after the first turn means ahead, not behind.
    let mut e = t.vertex_edge(from);
    let mut s = side(e);
    if s == Ordering::Less {
        while s == Ordering::Less {
            e = t.oprev(e);
            s = side(e);
        }
    } else {
        loop {
            let next = t.onext(e);
            let s_next = side(next);
            if s_next == Ordering::Less {
                break;
            }
            (e, s) = (next, s_next);
        }
    }
    if s == Ordering::Equal {
        Exit::Along(e)
    } else {
        Exit::Between(e)
    }
}

/// The target is ahead on the line of an edge: on the edge, or at or beyond its end (`Err`: walk on from there).
fn follow(t: &Topology, points: &[Point], e: Quarter, target: &impl Target) -> Result<Found, u32> {
    let end = t.dest(e);
    let onwards = t.lnext(e);
    if target.side(points[end as usize], points[t.dest(onwards) as usize]) == Ordering::Greater {
        Ok(Found::Edge(e))
    } else {
        Err(end)
    }
}

/// Crosses one edge after the other, beginning with `e`, whose inside is met by the line from vertex `from`.
fn cross(
    t: &Topology,
    points: &[Point],
    from: u32,
    mut e: Quarter,
    target: &impl Target,
) -> Result<Found, u32> {
    let at = |v: u32| points[v as usize];
    loop {
        match target.side(at(t.origin(e)), at(t.dest(e))) {
            Ordering::Greater => return Ok(Found::Face(e)),
            Ordering::Equal => return Ok(Found::Edge(e)),
            Ordering::Less => e = sym(e),
        }
        // The line leaves the triangle beyond on the side of its apex that the target is on.
        let apex = t.apex(e);
        match target.side(at(from), at(apex)) {
            Ordering::Greater => e = t.lprev(e),
            Ordering::Less => e = t.lnext(e),
            Ordering::Equal => return Err(apex),
        }
    }
}
