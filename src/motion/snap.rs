//! Floor snap: a walker who comes to the end of the ground is set down on the next, if that is near enough below.
//!
//! It is straight below the vertex where he would leave: found by an exact cast through the free faces, which meets a
//! vertex or runs along a wall on the side that he is going to. So it can pass through nothing, and a slope that falls
//! away under the vertex, too steep to walk on, is none to be set down on. Depths are compared in whole grid steps,
//! the limit rounded to them.
//!
//! Only the end of the ground counts. Where the ground goes on, but bends away too sharply for his speed, he hops because
//! the tunable `joint` says so, and a jump is nobody's accident.

use super::body::{Body, EventKind, Trace};
use super::joint::{Joint, Onward};
use super::terrain::{Ground, Terrain};
use super::vertex::{Bearing, Sector, sector, segment_at};
use crate::geom::{Point, STEP, predicates::orient2d};
use crate::mesh::{EdgeId, SegmentId, VertexId};
use glam::DVec2;

/// How far a piece of the steepest walkable feature edge (10 : 1) may lie above or below it, in grid steps: rounding has moved
/// it by up to half a step per axis.
const DISPLACED: i32 = 6;

/// A tunable distance, rounded to whole grid steps.
pub(super) fn in_steps(distance: f64) -> i32 {
    (distance / STEP).round() as i32
}

impl Body {
    /// At the end of the ground: set down on what is near below, else off into the air. `onward` is what continues the surface,
    /// if anything does.
    pub(super) fn leave_or_snap(
        &mut self,
        joint: Joint,
        onward: Option<&Onward>,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        if self.walk_aboard(&joint, terrain, trace) {
            return;
        }
        let t = terrain.tuning;
        let mesh = self.ground(terrain);
        let next = onward.map(|on| on.edge);
        let spoke = joint.spoke(next, mesh);
        let vertex = mesh.point(mesh.origin(spoke));
        let lowest = Point::new(vertex.x, vertex.y - in_steps(t.floor_snap));
        let plumb = Plumb {
            mesh,
            forward: joint.forward(),
            lowest,
        };
        let found = match t.floor_snap > 0.0 {
            true => plumb.ground(spoke),
            false => None,
        };
        let below = |s: SegmentId| {
            let track = mesh.track(s);
            track.position(track.parameter_at_x(vertex.x))
        };
        let found = found.filter(|&(_, s)| self.is_clear_to(below(s), terrain));
        match (found, onward) {
            (Some((edge, segment)), _) => {
                self.set_down(&joint, vertex, edge, segment, terrain, trace);
            }
            (None, Some(on)) if joint.speed == 0.0 && on.track.normal.y > 0.0 => {
                self.tip_over(on, terrain, trace);
            }
            _ => self.leave(joint, next, terrain, trace),
        }
    }

    /// From rest over the end of the ground, down the steep face behind it: in the air he would fall on the vertex itself, be
    /// on the ground again, and be driven over its end again, all at one time.
    fn tip_over(&mut self, on: &Onward, terrain: &Terrain, trace: &mut Trace) {
        self.coyote_from = Some(self.time);
        self.log(EventKind::Left, trace);
        self.settle(on.segment, on.edge, on.start, 0.0, 0.0, terrain, trace);
    }

    /// On ground below a vertex, with the speed along it that he had along the old one.
    fn set_down(
        &mut self,
        joint: &Joint,
        from: Point,
        edge: EdgeId,
        segment: SegmentId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let track = self.ground(terrain).track(segment);
        let sign = joint.forward() * track.tangent.x.signum();
        let s0 = track.parameter_at_x(from.x);
        self.put_on(edge, segment, s0, sign * joint.speed, terrain);
        let depth = from.metres().y - track.position(s0).y;
        self.log(EventKind::Snapped(depth), trace);
    }
}

/// A line straight down from a vertex; where it meets vertices it passes them on the side of the motion.
struct Plumb<'a> {
    mesh: Ground<'a>,
    /// 1 or -1: the side of the motion.
    forward: f64,
    /// Its lowest point.
    lowest: Point,
}

/// Where a plumb line goes on from a face.
enum Below {
    /// Through a vertex of it; this edge leaves that, with the face on its left.
    Vertex(EdgeId),
    /// Across this edge of it.
    Edge(EdgeId),
}

impl Plumb<'_> {
    /// The walkable ground that the line meets first, not below its lowest point. `spoke` leaves the vertex where it starts,
    /// with a free face on its left.
    fn ground(&self, spoke: EdgeId) -> Option<(EdgeId, SegmentId)> {
        let mesh = self.mesh;
        let candidates = self.first_met(spoke)?.into_iter();
        let feature_edges = candidates.filter_map(|e| Some((e, segment_at(mesh, e, |_| false)?)));
        let mut ground = feature_edges.filter(|&(_, s)| mesh.walkable(s));
        // The solid is left of a -> b, below: the lowest point must not be above it.
        let within = |s: SegmentId| {
            let segment = mesh.segment(s);
            orient2d(segment.a, segment.b, self.lowest) >= 0
        };
        ground.next().filter(|&(_, s)| within(s))
    }

    /// The blocking edge that the line meets first; at a vertex both of its solid sector, the one ahead first.
    fn first_met(&self, spoke: EdgeId) -> Option<[EdgeId; 2]> {
        let mut below = self.through_vertex(spoke).ok()?;
        while !self.is_too_deep(&below) {
            below = match below {
                Below::Vertex(spoke) => match self.through_vertex(spoke) {
                    Ok(below) => below,
                    Err(met) => return Some(met),
                },
                Below::Edge(e) if self.mesh.blocks(e) => return Some([e, e]),
                Below::Edge(e) => self.across(self.mesh.sym(e)),
            };
        }
        None
    }

    /// Down from a vertex into the face there; `Err`: into the solid between two edges, the one ahead first.
    fn through_vertex(&self, spoke: EdgeId) -> Result<Below, [EdgeId; 2]> {
        let mesh = self.mesh;
        let down = Bearing {
            d: DVec2::NEG_Y,
            then: DVec2::new(self.forward, 0.0),
        };
        let face = match sector(mesh, spoke, down) {
            Sector::Free(face) => face,
            Sector::Solid(out, into) if self.forward > 0.0 => return Err([out, into]),
            Sector::Solid(out, into) => return Err([into, out]),
        };
        let home = mesh.origin(spoke);
        let out = mesh
            .sides(face)
            .into_iter()
            .find(|&e| mesh.origin(e) == home);
        let out = out.expect("the faces about a vertex have it as a corner");
        let opposite = mesh.lnext(out);
        Ok([opposite, mesh.lnext(opposite)]
            .into_iter()
            .find(|&e| self.meets(e))
            .map_or(Below::Edge(opposite), Below::Vertex))
    }

    /// Down into the face left of an edge that the line crosses between its ends, and on.
    fn across(&self, e: EdgeId) -> Below {
        let mesh = self.mesh;
        let next = mesh.lnext(e);
        let last = mesh.lnext(next);
        let is_left = |e: EdgeId| mesh.point(mesh.origin(e)).x < self.lowest.x;
        if self.meets(last) {
            Below::Vertex(last)
        } else if is_left(next) != is_left(last) {
            Below::Edge(next)
        } else {
            Below::Edge(last)
        }
    }

    /// Whether the start of an edge is on the line.
    fn meets(&self, e: EdgeId) -> bool {
        self.mesh.point(self.mesh.origin(e)).x == self.lowest.x
    }

    fn is_too_deep(&self, below: &Below) -> bool {
        let deep = |v: VertexId| self.mesh.point(v).y < self.lowest.y - DISPLACED;
        match *below {
            Below::Vertex(e) => deep(self.mesh.origin(e)),
            Below::Edge(e) => deep(self.mesh.origin(e)) && deep(self.mesh.dest(e)),
        }
    }
}
