//! Floor snap: a walker who comes to the end of the ground is set down on the next, if that is near enough below.
//!
//! It is straight below the vertex where he would leave: found by an exact cast through the free faces, which meets a
//! vertex or runs along a wall on the side that he is going to. So it can pass through nothing, and a slope that falls
//! away under the vertex, too steep to walk on, is none to be set down on. Depths are compared as they were drawn
//! ([`crate::geom::drawn`]).
//!
//! A foot with bevelled flanks slides off a corner along its flank: the expanded corner begins with edges that no feature
//! has drawn. Those are followed first, along the border of free space, and what is looked for is where they end.
//!
//! Only the end of the ground counts. Where the ground goes on, but bends away too sharply for his speed, he hops because
//! the tunable `joint` says so, and a jump is nobody's accident.

use super::body::{Body, EventKind, Trace};
use super::joint::{Joint, Onward};
use super::terrain::{Ground, Terrain};
use super::vertex::{Bearing, Heading, Sector, ahead, bridge, sector, segment_at, surface_next};
use crate::geom::drawn::{Height, SLACK};
use crate::geom::{Point, STEP, Source, predicates::orient2d};
use crate::mesh::{EdgeId, SegmentId, VertexId};
use glam::DVec2;

/// How far a piece of the steepest walkable feature edge (10 : 1) may lie above or below it, in grid steps: rounding has moved
/// it by up to half a step per axis.
const DISPLACED: i32 = 6;

/// More pieces than the flanks of any foot have; a bound, as for steps.
const PIECES: u32 = 1024;

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
        let home = mesh.point(mesh.origin(joint.spoke(next, mesh)));
        let depth = Depth {
            from: mesh.height(joint.segment, home),
            limit: t.floor_snap,
            lowest: home.y - in_steps(t.floor_snap) - SLACK as i32,
        };
        let found = match t.floor_snap > 0.0 {
            true => below(&joint, onward, depth, mesh),
            false => None,
        };
        let place = |found: &Below| {
            let track = mesh.track(found.segment);
            track.position(track.parameter_at_x(found.x))
        };
        let found = found.filter(|found| self.is_clear_to(place(found), terrain));
        match (found, onward) {
            (Some(found), _) => self.set_down(&joint, home, &found, terrain, trace),
            (None, Some(on))
                if joint.speed == 0.0 && (on.track.normal.y > 0.0 || self.is_pressed()) =>
            {
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
        below: &Below,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let track = self.ground(terrain).track(below.segment);
        let sign = joint.forward() * track.tangent.x.signum();
        let s0 = track.parameter_at_x(below.x);
        self.put_on(below.edge, below.segment, s0, sign * joint.speed, terrain);
        let depth = from.metres().y - track.position(s0).y;
        self.log(EventKind::Snapped(depth), trace);
    }
}

/// Ground below the end of the ground.
struct Below {
    /// The world x at which it is come to, in grid steps.
    x: i32,
    edge: EdgeId,
    segment: SegmentId,
}

/// How deep ground may lie below the end of the ground.
#[derive(Clone, Copy)]
struct Depth {
    from: Height,
    /// m.
    limit: f64,
    /// The grid step that nothing within the limit lies below.
    lowest: i32,
}

impl Depth {
    /// Whether a feature edge of ground is within it at a world x, in grid steps.
    fn holds(&self, mesh: Ground, s: SegmentId, x: i32) -> bool {
        let segment = mesh.segment(s);
        let end = [segment.a, segment.b].into_iter().find(|end| end.x == x);
        match mesh.height(s, end.unwrap_or_default()) {
            // Somewhere along a slope: the solid is left of a -> b, below.
            Height::Rounded(_) => orient2d(segment.a, segment.b, Point::new(x, self.lowest)) >= 0,
            ground => self.from.is_within(self.limit, ground),
        }
    }
}

/// The ground below a joint that is the end of the ground, not deeper than it may be.
fn below(joint: &Joint, onward: Option<&Onward>, depth: Depth, mesh: Ground) -> Option<Below> {
    let heading = joint.heading;
    let mut spoke = joint.spoke(onward.map(|on| on.edge), mesh);
    let mut next = onward.map(|on| (on.edge, on.segment));
    for _ in 0..PIECES {
        let Some((edge, _)) = next.filter(|&(_, s)| is_bevel(joint, mesh, s)) else {
            break;
        };
        // Down the flank of the body's own foot, which the corner of the ground slides along.
        let end = ahead(mesh, edge, heading);
        spoke = match heading {
            Heading::Along => mesh.lnext(edge),
            Heading::Against => edge,
        };
        next = surface_next(mesh, edge, heading)
            .and_then(|e| Some((e, segment_at(mesh, e, |_| false)?)));
        let ground = next.filter(|&(_, s)| mesh.walkable(s));
        let lip = || bridge(mesh, end, next.map(|next| next.0), heading);
        let met = match next.is_some_and(|(_, s)| is_bevel(joint, mesh, s)) {
            true => None,
            false => ground.or_else(lip),
        };
        if let Some((edge, segment)) = met {
            let x = mesh.point(end).x;
            let found = depth.holds(mesh, segment, x);
            return found.then_some(Below { x, edge, segment });
        }
    }
    let x = mesh.point(mesh.origin(spoke)).x;
    let plumb = Plumb {
        mesh,
        forward: joint.forward(),
        x,
        depth,
    };
    let (edge, segment) = plumb.ground(spoke)?;
    Some(Below { x, edge, segment })
}

/// Whether a feature edge is a flank of the body's foot drawn round a corner of the ground, which falls away forwards and is
/// too steep to stand on.
fn is_bevel(joint: &Joint, mesh: Ground, s: SegmentId) -> bool {
    let track = mesh.track(s);
    let (dx, dy) = track.heading(joint.heading.sign(&track));
    let falls = dy < 0 && dx as f64 * joint.forward() > 0.0;
    falls && !mesh.walkable(s) && matches!(mesh.segment(s).source, Source::Corner { .. })
}

/// A line straight down from a vertex; where it meets vertices it passes them on the side of the motion.
struct Plumb<'a> {
    mesh: Ground<'a>,
    /// 1 or -1: the side of the motion.
    forward: f64,
    /// Its place, in grid steps.
    x: i32,
    depth: Depth,
}

/// Where a plumb line goes on from a face.
enum Way {
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
        ground
            .next()
            .filter(|&(_, s)| self.depth.holds(mesh, s, self.x))
    }

    /// The blocking edge that the line meets first; at a vertex both of its solid sector, the one ahead first.
    fn first_met(&self, spoke: EdgeId) -> Option<[EdgeId; 2]> {
        let mut below = self.through_vertex(spoke).ok()?;
        while !self.is_too_deep(&below) {
            below = match below {
                Way::Vertex(spoke) => match self.through_vertex(spoke) {
                    Ok(below) => below,
                    Err(met) => return Some(met),
                },
                Way::Edge(e) if self.mesh.blocks(e) => return Some([e, e]),
                Way::Edge(e) => self.across(self.mesh.sym(e)),
            };
        }
        None
    }

    /// Down from a vertex into the face there; `Err`: into the solid between two edges, the one ahead first.
    fn through_vertex(&self, spoke: EdgeId) -> Result<Way, [EdgeId; 2]> {
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
            .map_or(Way::Edge(opposite), Way::Vertex))
    }

    /// Down into the face left of an edge that the line crosses between its ends, and on.
    fn across(&self, e: EdgeId) -> Way {
        let mesh = self.mesh;
        let next = mesh.lnext(e);
        let last = mesh.lnext(next);
        let is_left = |e: EdgeId| mesh.point(mesh.origin(e)).x < self.x;
        if self.meets(last) {
            Way::Vertex(last)
        } else if is_left(next) != is_left(last) {
            Way::Edge(next)
        } else {
            Way::Edge(last)
        }
    }

    /// Whether the start of an edge is on the line.
    fn meets(&self, e: EdgeId) -> bool {
        self.mesh.point(self.mesh.origin(e)).x == self.x
    }

    fn is_too_deep(&self, below: &Way) -> bool {
        let deep = |v: VertexId| self.mesh.point(v).y < self.depth.lowest - DISPLACED;
        match *below {
            Way::Vertex(e) => deep(self.mesh.origin(e)),
            Way::Edge(e) => deep(self.mesh.origin(e)) && deep(self.mesh.dest(e)),
        }
    }
}
