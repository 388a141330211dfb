//! Step-up: a walker stopped by a wall that is no higher than a step goes on top of it.
//!
//! From the foot of the wall the border of free space is followed upwards, edge by edge, as long as it only rises and
//! does not lean back over him. If it comes to walkable ground no higher than the limit, he is put there, at its
//! beginning, with the speed that he had. All of that path is on the border of free space, so there is room for him:
//! under a low ceiling the border runs into the ceiling first. Heights are compared as they were drawn
//! ([`crate::geom::drawn`]).
//!
//! Stepping up is walking: it takes a wish in that direction, and ground to do it from. Who is carried to a step by a belt or
//! by his momentum stops there, and who slides down a steep face onto a step is no walker.

use super::body::{Body, EventKind, Trace};
use super::joint::Joint;
use super::snap::in_steps;
use super::terrain::{Ground, Terrain};
use super::vertex::{behind, bridge, segment_at, surface_next};
use crate::geom::drawn::SLACK;
use crate::mesh::{EdgeId, SegmentId};

/// More pieces than the side of any step has; a bound, so that a knot of rounded edges cannot hold the search for ever.
const PIECES: u32 = 1024;

impl Body {
    /// At the foot of a wall: onto it, if it is a step. False, and nothing changed, if it is none.
    pub(super) fn step_up(&mut self, joint: &Joint, terrain: &Terrain, trace: &mut Trace) -> bool {
        let t = terrain.tuning;
        let mesh = self.ground(terrain);
        if in_steps(t.step_up) == 0 || self.control.run * joint.forward() <= 0.0 {
            return false;
        }
        let Some((edge, segment)) = top(joint, t.step_up, mesh) else {
            return false;
        };
        let before = self.position().y;
        let on = joint.onto(mesh, edge, segment);
        if !self.is_clear_to(on.track.position(on.start), terrain) {
            return false;
        }
        self.put_on(edge, segment, on.start, on.sign * joint.speed, terrain);
        let height = self.position().y - before;
        self.log(EventKind::SteppedUp(height), trace);
        true
    }
}

/// The walkable ground at the top of a wall at most `limit` metres high.
fn top(joint: &Joint, limit: f64, mesh: Ground) -> Option<(EdgeId, SegmentId)> {
    let start = |e| mesh.point(behind(mesh, e, joint.heading));
    let first = joint.next?;
    let highest = start(first).y + in_steps(limit) + SLACK as i32;
    let (edge, segment) = climb(joint, first, highest, mesh)?;
    let foot = mesh.height(joint.segment, start(first));
    let top = mesh.height(segment, start(edge));
    top.is_within(limit, foot).then_some((edge, segment))
}

/// Up the border of free space to walkable ground, not beyond a height.
fn climb(joint: &Joint, first: EdgeId, highest: i32, mesh: Ground) -> Option<(EdgeId, SegmentId)> {
    let heading = joint.heading;
    let mut edge = first;
    for _ in 0..PIECES {
        let segment = segment_at(mesh, edge, |_| false)?;
        if mesh.walkable(segment) {
            return Some((edge, segment));
        }
        let on = joint.onto(mesh, edge, segment);
        let rises = on.after.1 > 0 && on.after.0 as f64 * joint.forward() >= 0.0;
        let from = behind(mesh, edge, heading);
        if !rises || mesh.point(from).y > highest {
            // At the top there may be a lip that rounding has left.
            return bridge(mesh, from, Some(edge), heading);
        }
        edge = surface_next(mesh, edge, heading)?;
    }
    None
}
