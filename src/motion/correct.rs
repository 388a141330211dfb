//! Forgiveness at corners: a head that barely strikes a ceiling's corner is moved aside, feet that barely miss a ledge are
//! lifted onto it. The body is moved along the boundary of free space, never through anything.

use super::body::{Body, EventKind, Mode, Trace};
use super::ledge::top_above;
use super::terrain::{Ground, Terrain};
use super::track::Track;
use super::vertex::{
    Bearing, Heading, Sector, ahead, behind, sector, segment_at, surface_next, turns_towards,
};
use crate::mesh::{EdgeId, SegmentId};
use glam::DVec2;

/// The end of a ceiling where the boundary turns away from the body, up a wall.
struct Rim {
    /// How far along the ceiling it is, m.
    distance: f64,
    heading: Heading,
    /// The edge of the wall and its feature edge.
    wall: EdgeId,
    segment: SegmentId,
}

/// The end of a ceiling's line towards growing (1) or falling (-1) parameters, at most `limit` metres from the parameter `s`.
///
/// Distances are differences of parameters, which are exact where the body is on the grid: exactly the limit is within it.
fn rim(mesh: Ground, e: EdgeId, track: &Track, sign: f64, s: f64, limit: f64) -> Option<Rim> {
    let heading = Heading::of(sign, track);
    let same_line = |s: SegmentId| mesh.track(s).same_line(track);
    let rate = track.rate().abs();
    let mut e = e;
    loop {
        let ahead = (track.parameter_of(mesh.point(ahead(mesh, e, heading))) - s) * sign;
        if ahead > limit * rate {
            return None;
        }
        e = surface_next(mesh, e, heading)?;
        let segment = segment_at(mesh, e, same_line)?;
        if same_line(segment) {
            continue;
        }
        let wall = mesh.track(segment);
        let after = wall.heading(heading.sign(&wall));
        let opens = mesh.is_wall(segment)
            && after.1 > 0
            && !turns_towards(track.heading(sign), after, heading);
        let distance = ahead.max(0.0) / rate;
        return opens.then_some(Rim {
            distance,
            heading,
            wall: e,
            segment,
        });
    }
}

impl Body {
    /// A rising head that strikes a ceiling near its end is moved to that end, and goes on with its velocity; into the wall
    /// above the corner it goes as in any contact. True if it was.
    ///
    /// Of two ends the nearer one counts; of equally near ones that to which the body moves sideways, and none if it does not.
    pub(super) fn correct_corner(
        &mut self,
        edge: EdgeId,
        segment: SegmentId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let (mesh, limit) = (self.ground(terrain), terrain.tuning.corner_correction);
        let (at, v) = (self.local_position(), self.local_velocity());
        let track = mesh.track(segment);
        let is_ceiling = track.normal.y < 0.0 && !mesh.is_wall(segment);
        if limit == 0.0 || v.y <= 0.0 || track.normal.dot(v) >= 0.0 || !is_ceiling {
            return false;
        }
        let [left, right] =
            [-1.0, 1.0].map(|sign| rim(mesh, edge, &track, sign, track.parameter(at), limit));
        let sideways = v.x * track.tangent.x;
        let nearest = match (left, right) {
            (Some(a), Some(b)) if a.distance == b.distance => match sideways {
                0.0 => None,
                x if x < 0.0 => Some(a),
                _ => Some(b),
            },
            (Some(a), Some(b)) => Some(if a.distance < b.distance { a } else { b }),
            (a, b) => a.or(b),
        };
        // Flush with the wall above the corner, and not into it: it was only a touch.
        let touch = |rim: &Rim| {
            let wall = mesh.track(rim.segment);
            rim.distance == 0.0 && wall.normal.dot(v) >= 0.0
        };
        let Some(rim) = nearest.filter(|rim| !touch(rim)) else {
            return false;
        };
        let corner = mesh.point(behind(mesh, rim.wall, rim.heading)).metres();
        if !self.is_clear_to(corner, terrain) {
            return false;
        }
        self.log(EventKind::Corrected(rim.distance), trace);
        self.go_round(&rim, &track, v, terrain, trace);
        true
    }

    /// From the end of a ceiling on, with a velocity.
    fn go_round(
        &mut self,
        rim: &Rim,
        ceiling: &Track,
        v: DVec2,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let mesh = self.ground(terrain);
        let spoke = match rim.heading {
            Heading::Along => rim.wall,
            Heading::Against => mesh.lnext(rim.wall),
        };
        let accel = match &self.mode {
            Mode::Air(air) => air.accel,
            _ => DVec2::NEG_Y,
        };
        let vertex = mesh.point(mesh.origin(spoke));
        match sector(mesh, spoke, Bearing::of(v, accel)) {
            Sector::Free(face) => {
                let lock = self.lock();
                self.fly(vertex.metres(), v, face, [Some(rim.segment), None]);
                if let Mode::Air(air) = &mut self.mode {
                    air.lock = lock;
                }
            }
            Sector::Solid(..) => {
                let feature_edge = mesh.segment(rim.segment);
                let wall = mesh.track(rim.segment);
                let s = wall.parameter_at_joint(feature_edge, ceiling, vertex);
                let (u, into) = (wall.tangent.dot(v), (-wall.normal.dot(v)).max(0.0));
                self.settle(rim.segment, rim.wall, s, u, into, terrain, trace);
            }
        }
    }

    /// Feet that come to a wall just below the ground on top of it are lifted onto it, and walk on as fast as they flew
    /// sideways. True if they were.
    ///
    /// Only who moves into the wall and does not rise: in a rise the same wall is slid up, and the top reached by itself. Nor who
    /// falls too fast: he would stop dead in the middle of a long fall.
    pub(super) fn correct_ledge(
        &mut self,
        edge: EdgeId,
        segment: SegmentId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let (mesh, limit) = (self.ground(terrain), terrain.tuning.ledge_correction);
        let (at, v) = (self.local_position(), self.local_velocity());
        let track = mesh.track(segment);
        let slow = -v.y <= terrain.tuning.ledge_correction_speed;
        let comes = v.y <= 0.0 && v.x * track.normal.x < 0.0 && track.normal.dot(v) < 0.0 && slow;
        if limit == 0.0 || !comes || !mesh.is_wall(segment) {
            return false;
        }
        let Some(top) = top_above(mesh, edge, &track, at.y + limit) else {
            return false;
        };
        // The sum above may round; the difference decides.
        let height = (top.height - at.y).max(0.0);
        if height > limit {
            return false;
        }
        let feature_edge = mesh.segment(top.segment);
        let ground = mesh.track(top.segment);
        let s = ground.parameter_at_joint(feature_edge, &top.wall, top.vertex);
        // Up a wall that leans the whole way counts; up an upright one that is the height, to the last bit.
        if (ground.position(s) - at).length() > limit {
            return false;
        }
        // The parameter of ground steeper than 45 degrees is a height.
        let along = if ground.tangent.x < 0.0 { -v.x } else { v.x };
        if !self.is_clear_to(ground.position(s), terrain) {
            return false;
        }
        self.log(EventKind::Corrected(height), trace);
        self.settle(top.segment, top.edge, s, along, -v.y, terrain, trace);
        true
    }
}
