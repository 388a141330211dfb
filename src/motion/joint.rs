//! Joints: where a surface turns into another one, turns away from the body, or ends.

use super::body::{Body, EventKind, Mode, Surface, Trace};
use super::terrain::{Ground, Terrain};
use super::track::{Track, cross, dot, walkable};
use super::vertex::{
    Bearing, Heading, JOINT_STEPS, Sector, ahead, behind, bridge, is_lip, sector, segment_at,
    surface_next, turns_towards,
};
use crate::geom::STEP;
use crate::mesh::{EdgeId, SegmentId};
use crate::tune::Motion;
use glam::DVec2;

/// The joint that a body has come to: how it came, and what is next.
struct Joint {
    /// Speed, not negative.
    speed: f64,
    /// Sign of the parameter's change so far.
    sign: f64,
    heading: Heading,
    /// The feature edge so far, and its road.
    segment: SegmentId,
    track: Track,
    /// Exact direction of the motion so far.
    before: (i64, i64),
    /// The next edge of the surface.
    next: EdgeId,
}

/// A way on from a joint.
struct Onward {
    edge: EdgeId,
    segment: SegmentId,
    track: Track,
    /// Sign of the parameter's change there.
    sign: f64,
    /// Exact direction of the motion there.
    after: (i64, i64),
    /// The parameter there at which it starts.
    start: f64,
    /// The surface turns towards the body.
    towards: bool,
    /// Cosine of the turn.
    cosine: f64,
}

impl Joint {
    /// The way on along an edge of the surface, as part of a feature edge.
    fn onto(&self, mesh: Ground, edge: EdgeId, segment: SegmentId) -> Onward {
        let track = Track::of(mesh.segment(segment));
        let grows = (self.heading == Heading::Along) == track.leftward_free;
        let sign = if grows { 1.0 } else { -1.0 };
        let after = track.heading(sign);
        let vertex = mesh.point(behind(mesh, edge, self.heading));
        Onward {
            edge,
            segment,
            track,
            sign,
            after,
            start: track.parameter_at_joint(mesh.segment(segment), &self.track, vertex),
            towards: turns_towards(self.before, after, self.heading),
            cosine: dot(self.before, after) as f64 / (length(self.before) * length(after)),
        }
    }

    /// The speed that is lost where only `kept` of it goes on.
    fn lost(&self, kept: f64) -> f64 {
        (self.speed * self.speed - kept * kept).max(0.0).sqrt()
    }

    /// Whether a walker stays on the ground where it bends away.
    ///
    /// By curvature: iff s^2 k <= g cos(slope) + stick, with the slope of the bisector and k = 2 tan(turn / 2) over the
    /// mean length of the two feature edges, each counted up to the curve span; independent of how finely a curve is drawn.
    fn holds(&self, on: &Onward, mesh: Ground, t: &Motion) -> bool {
        if t.joint == 0.0 {
            return true;
        }
        if t.joint == 2.0 {
            return self.speed == 0.0;
        }
        let (before, after) = (unit(self.before), unit(on.after));
        let tan_half = before.perp_dot(after).abs() / (1.0 + before.dot(after));
        let span = |s: SegmentId| {
            let segment = mesh.segment(s);
            let length = (segment.b.metres() - segment.a.metres()).length();
            length.min(t.joint_span)
        };
        let curvature = 2.0 * tan_half / (0.5 * (span(self.segment) + span(on.segment)));
        let bisector = before + after;
        let cos_slope = bisector.x.abs() / bisector.length();
        self.speed * self.speed * curvature <= t.gravity * cos_slope + t.joint_stick
    }
}

fn vector(v: (i64, i64)) -> DVec2 {
    DVec2::new(v.0 as f64, v.1 as f64)
}

fn length(v: (i64, i64)) -> f64 {
    vector(v).length()
}

fn unit(v: (i64, i64)) -> DVec2 {
    vector(v) / length(v)
}

impl Body {
    /// At the vertex ahead. True if the surface simply goes on along the same line: that is no event.
    pub(super) fn pass_vertex(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = self.ground(terrain);
        let now = self.time;
        let Mode::Surface(on) = &mut self.mode else {
            return false;
        };
        trace.passed += 1;
        let sign = on.sign();
        let heading = on.heading(sign);
        let next = surface_next(mesh, on.edge, heading);
        let same_line =
            |s: SegmentId| s == on.segment || Track::of(mesh.segment(s)).same_line(&on.track);
        let segment = segment_at(mesh, next, terrain.tuning.max_slope, same_line);
        if let Some(s) = segment.filter(|&s| same_line(s)) {
            (on.edge, on.segment, on.since) = (next, s, (now - on.t0).max(on.since));
            return true;
        }
        let joint = Joint {
            speed: on.speed(now).abs(),
            sign,
            heading,
            segment: on.segment,
            track: on.track,
            before: on.track.heading(sign),
            next,
        };
        let walks = on.walkable;
        let onward = segment.map(|s| joint.onto(mesh, next, s));
        match walks {
            true => return self.walk_joint(joint, onward, terrain, trace),
            false => self.slide_joint(joint, onward, terrain, trace),
        }
        false
    }

    /// A walker at a joint: on to walkable ground, up against a wall, off an edge. True as for [`Body::pass_vertex`].
    fn walk_joint(
        &mut self,
        joint: Joint,
        onward: Option<Onward>,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let mesh = self.ground(terrain);
        let t = terrain.tuning;
        let next = onward.as_ref().map(|on| (on.edge, on.segment));
        let next = next.filter(|&(_, s)| walkable(mesh.segment(s), t.max_slope));
        let ground = match next {
            Some((_, s)) if !is_lip(mesh.segment(s)) => next,
            _ => bridge(mesh, joint.next, joint.heading, t.max_slope).or(next),
        };
        if let Some((edge, s)) = ground {
            let onward = joint.onto(mesh, edge, s);
            return self.walk_on(joint, onward, terrain, trace);
        }
        match onward {
            Some(on) if !on.towards => self.leave(joint, on.edge, terrain, trace),
            Some(on) if climbs(joint.speed * on.cosine, t) => {
                let up = joint.speed * on.cosine;
                let (u, into) = (on.sign * up, joint.lost(up));
                self.settle(on.segment, on.edge, on.start, u, into, terrain, trace);
            }
            on => self.stop(joint, on, trace, mesh),
        }
        false
    }

    /// Round a bend from walkable ground to walkable ground. True as for [`Body::pass_vertex`].
    fn walk_on(
        &mut self,
        joint: Joint,
        onward: Onward,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let mesh = self.ground(terrain);
        let t = terrain.tuning;
        let now = self.time;
        let Onward {
            edge,
            segment,
            track,
            sign,
            after,
            start,
            towards,
            cosine,
        } = onward;
        let Mode::Surface(on) = &mut self.mode else {
            return false;
        };
        let straight = cross(joint.before, after) == 0 && dot(joint.before, after) > 0;
        if straight && track.axis == on.track.axis {
            // Parallel, within the steps of a joint: the same parameter, so the piece goes on.
            (on.edge, on.segment, on.track) = (edge, segment, track);
            on.since = (now - on.t0).max(on.since);
            return true;
        }
        if !towards && !joint.holds(&onward, mesh, t) {
            self.leave(joint, edge, terrain, trace);
            return false;
        }
        let kept = if towards && t.concave == 1.0 {
            cosine.max(0.0)
        } else {
            1.0
        };
        *on = Surface {
            t0: now,
            s0: start,
            u0: sign * joint.speed * kept,
            accel: 0.0,
            limit: None,
            segment,
            track,
            edge,
            since: 0.0,
            walkable: true,
            against: 0.0,
        };
        self.log(EventKind::Joint, trace);
        false
    }

    /// At rest before a wall (none: the world's border), which from now on takes up every push.
    fn stop(&mut self, joint: Joint, wall: Option<Onward>, trace: &mut Trace, mesh: Ground) {
        let now = self.time;
        let Mode::Surface(on) = &mut self.mode else {
            return;
        };
        let vertex = mesh.point(ahead(mesh, on.edge, joint.heading));
        let wall = wall.map_or(joint.track, |wall| wall.track);
        let feature_edge = mesh.segment(on.segment);
        on.s0 = on.track.parameter_at_joint(feature_edge, &wall, vertex);
        (on.t0, on.u0, on.since) = (now, 0.0, 0.0);
        on.against = joint.sign;
        self.log(EventKind::Stopped(joint.speed), trace);
    }

    /// Off the end of a surface, in the direction of the motion so far, from the vertex where `onward` begins: the edge that
    /// would continue it.
    fn leave(&mut self, joint: Joint, onward: EdgeId, terrain: &Terrain, trace: &mut Trace) {
        let mesh = self.ground(terrain);
        let walked = self.supported();
        // The edge out of that vertex that has a free face beside the surface on its left.
        let spoke = match joint.heading {
            Heading::Along => onward,
            Heading::Against => mesh.lnext(onward),
        };
        let bearing = Bearing {
            d: vector(joint.before),
            then: DVec2::new(0.0, -1.0),
        };
        let face = match sector(mesh, spoke, bearing) {
            Sector::Free(face) => Some(face),
            Sector::Solid(..) => mesh.left(spoke),
        };
        let face = face.expect("a surface has a free face beside it");
        let vertex = mesh.point(mesh.origin(spoke)).metres();
        let v = joint.track.tangent * (joint.sign * joint.speed);
        self.come_off_wall(terrain);
        self.fly(vertex, v, face, [None; 2]);
        if walked {
            self.coyote_from = Some(self.time);
            self.log(EventKind::Left, trace);
        } else {
            self.log(EventKind::Parted, trace);
        }
    }

    /// One who slides, at a joint: lands, goes on, is wedged, stops, or flies off.
    fn slide_joint(
        &mut self,
        joint: Joint,
        onward: Option<Onward>,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let mesh = self.ground(terrain);
        let Some(on) = onward else {
            return self.stop(joint, None, trace, mesh);
        };
        if !on.towards {
            return self.leave(joint, on.edge, terrain, trace);
        }
        let kept = (joint.speed * on.cosine).max(0.0);
        let into = joint.lost(kept);
        let u = on.sign * kept;
        let (sinks, goes_down) = (joint.before.1 < 0, on.after.1 < 0);
        let lasts = kept > 0.0 || !self.pulled_off(&on.track, 0.0, terrain);
        if walkable(mesh.segment(on.segment), terrain.tuning.max_slope) {
            // Who holds against the slope that he comes down on stands at its foot: else each return would set him off again.
            let wish = self.control.run * terrain.tuning.run_speed;
            let stands = wish * vector(on.after).x < 0.0 && kept <= wish.abs();
            let u = if stands { 0.0 } else { u };
            self.settle(on.segment, on.edge, on.start, u, into, terrain, trace);
            if let (true, Mode::Surface(ground)) = (stands, &mut self.mode) {
                ground.against = -on.sign;
            }
        } else if lasts && (goes_down || !sinks && kept > 0.0) {
            self.settle(on.segment, on.edge, on.start, u, into, terrain, trace);
        } else if sinks && !goes_down {
            // Gravity drives it back from both sides.
            let vertex = mesh.point(behind(mesh, on.edge, joint.heading));
            let at = on.track.corner(&joint.track, vertex);
            self.wedge(at, on.edge, terrain, trace);
        } else {
            self.stop(joint, Some(on), trace, mesh);
        }
    }
}

/// Whether a speed up a steep face carries a body higher than a joint may rise: only then it goes up at all, so that the ever
/// smaller returns of a push end.
fn climbs(up: f64, t: &Motion) -> bool {
    up > 0.0 && up * up > 2.0 * t.gravity * f64::from(JOINT_STEPS) * STEP
}
