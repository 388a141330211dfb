//! On a surface: along feature edges, round their joints, off their ends.

use super::body::{Body, EventKind, Mode, Next, Surface, Terrain, Trace};
use super::roots::cover;
use super::track::{Track, cross, dot, walkable};
use super::vertex::{
    Bearing, Heading, JOINT_STEPS, Sector, ahead, behind, bridge, sector, segment_at, surface_next,
    turns_towards,
};
use crate::geom::STEP;
use crate::mesh::{EdgeId, Mesh, SegmentId};
use crate::tune::Motion;
use glam::DVec2;

impl Surface {
    /// The first of: the vertex ahead, a speed limit.
    pub(super) fn next(&self, mesh: &Mesh) -> Option<(f64, Next)> {
        let sign = self.sign();
        if sign == 0.0 {
            return None;
        }
        let there = self
            .track
            .parameter_of(mesh.point(ahead(mesh, self.edge, self.heading(sign))));
        let vertex = self
            .reaches(there)
            .map(|dt| (self.t0 + dt.max(self.since), Next::Vertex));
        match (vertex, self.limit) {
            (Some((at, _)), Some((limit, _))) if limit < at => Some((limit, Next::Limit)),
            (None, Some((limit, _))) => Some((limit, Next::Limit)),
            (vertex, _) => vertex,
        }
    }

    /// When a parameter ahead is reached, as a time after `t0`.
    pub(super) fn reaches(&self, there: f64) -> Option<f64> {
        let sign = self.sign();
        let distance = ((there - self.s0) * sign).max(0.0);
        let rate = self.track.rate();
        cover(distance, rate * self.u0.abs(), rate * self.accel * sign)
    }

    /// The position at a time, on the free side of the mesh edge too: rounding may have put that up to half a step per axis
    /// before the feature edge, and a flight has to start inside its face.
    pub(super) fn take_off_point(&self, t: f64, mesh: &Mesh) -> DVec2 {
        let p = self.track.position(self.parameter(t));
        // In a corner it is where both feature edges meet: off one would be into the other.
        if mesh.chain(self.segment).len() == 2 || self.against != 0.0 {
            return p;
        }
        let [from, to] =
            [mesh.origin(self.edge), mesh.dest(self.edge)].map(|v| mesh.point(v).metres());
        let along = to - from;
        // Measured from the lower end, for the mirror's sake.
        let lower = if along.y < 0.0 { to } else { from };
        let depth = -along.perp_dot(p - lower) / along.length_squared();
        p + along.perp() * depth.max(0.0)
    }

    /// Along or against the mesh edges, whose left is free.
    pub(super) fn heading(&self, sign: f64) -> Heading {
        if (sign > 0.0) == self.track.leftward_free {
            Heading::Along
        } else {
            Heading::Against
        }
    }

    /// The sign of the parameter for a heading on another road.
    fn sign_on(track: &Track, heading: Heading) -> f64 {
        if (heading == Heading::Along) == track.leftward_free {
            1.0
        } else {
            -1.0
        }
    }
}

/// The joint that a body has come to: where it is, how it came, what is next.
struct Joint {
    /// Speed, not negative.
    speed: f64,
    /// Sign of the parameter's change so far.
    sign: f64,
    heading: Heading,
    /// The road so far.
    track: Track,
    /// Exact direction of the motion so far.
    before: (i64, i64),
    /// The next edge of the surface.
    next: EdgeId,
    /// The feature edge there; none at the world's border.
    segment: Option<SegmentId>,
}

/// Cosine of the turn between two exact directions.
fn cosine(v: (i64, i64), w: (i64, i64)) -> f64 {
    dot(v, w) as f64 / (length(v) * length(w))
}

fn length(v: (i64, i64)) -> f64 {
    let (x, y) = (v.0 as f64, v.1 as f64);
    (x * x + y * y).sqrt()
}

impl Body {
    /// At the vertex ahead. True if the surface simply goes on along the same line: that is no event.
    pub(super) fn pass_vertex(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = terrain.mesh(self.size);
        let now = self.time;
        let Mode::Surface(on) = &mut self.mode else {
            return false;
        };
        let sign = on.sign();
        let heading = on.heading(sign);
        let next = surface_next(mesh, on.edge, heading);
        let same_line =
            |s: SegmentId| s == on.segment || Track::of(mesh.segment(s)).same_line(&on.track);
        let segment = segment_at(mesh, next, terrain.tuning.max_slope, same_line);
        if let Some(s) = segment.filter(|&s| same_line(s)) {
            (on.edge, on.segment, on.since) = (next, s, (now - on.t0).max(on.since));
            trace.passed += 1;
            return true;
        }
        let joint = Joint {
            speed: on.speed(now).abs(),
            sign,
            heading,
            track: on.track,
            before: on.track.heading(sign),
            next,
            segment,
        };
        match on.walkable {
            true => self.walk_joint(joint, terrain, trace),
            false => self.slide_joint(joint, terrain, trace),
        }
    }

    /// A walker at a joint: on to walkable ground, up against a wall, off an edge.
    fn walk_joint(&mut self, joint: Joint, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = terrain.mesh(self.size);
        let t = terrain.tuning;
        let direct = joint
            .segment
            .filter(|&s| walkable(mesh.segment(s), t.max_slope))
            .map(|s| (joint.next, s));
        if let Some((edge, s)) =
            direct.or_else(|| bridge(mesh, joint.next, joint.heading, t.max_slope))
        {
            return self.walk_on(joint, edge, s, terrain, trace);
        }
        let Some(s) = joint.segment else {
            return self.stop(joint, terrain, trace);
        };
        let track = Track::of(mesh.segment(s));
        let sign = Surface::sign_on(&track, joint.heading);
        let after = track.heading(sign);
        if !turns_towards(joint.before, after, joint.heading) {
            let onward = joint.next;
            return self.leave(joint, onward, terrain, trace);
        }
        // Up a steep face goes only what rises by more than a joint may: so the ever smaller returns of a push end.
        let up = joint.speed * cosine(joint.before, after);
        if up > 0.0 && up * up > 2.0 * t.gravity * f64::from(JOINT_STEPS) * STEP {
            let at = track.parameter_at_joint(
                mesh.segment(s),
                &joint.track,
                mesh.point(behind(mesh, joint.next, joint.heading)),
            );
            let into = (joint.speed * joint.speed - up * up).max(0.0).sqrt();
            self.settle(s, joint.next, at, sign * up, into, terrain, trace);
            return false;
        }
        self.stop(joint, terrain, trace)
    }

    /// Round a bend from walkable ground to walkable ground.
    fn walk_on(
        &mut self,
        joint: Joint,
        edge: EdgeId,
        segment: SegmentId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let mesh = terrain.mesh(self.size);
        let t = terrain.tuning;
        let now = self.time;
        let Mode::Surface(on) = &mut self.mode else {
            return false;
        };
        let track = Track::of(mesh.segment(segment));
        let sign = Surface::sign_on(&track, joint.heading);
        let after = track.heading(sign);
        if cross(joint.before, after) == 0
            && dot(joint.before, after) > 0
            && track.axis == on.track.axis
        {
            // Parallel, within the steps of a joint: the same parameter, so the piece goes on.
            (on.edge, on.segment, on.track, on.since) =
                (edge, segment, track, (now - on.t0).max(on.since));
            trace.passed += 1;
            return true;
        }
        let towards = turns_towards(joint.before, after, joint.heading);
        if !towards && !holds(&joint, after, mesh, on.segment, segment, t) {
            return self.leave(joint, edge, terrain, trace);
        }
        let kept = if towards && t.concave == 1.0 {
            cosine(joint.before, after).max(0.0)
        } else {
            1.0
        };
        let s0 = track.parameter_at_joint(
            mesh.segment(segment),
            &on.track,
            mesh.point(behind(mesh, edge, joint.heading)),
        );
        let u0 = sign * joint.speed * kept;
        *on = Surface {
            t0: now,
            s0,
            u0,
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

    /// At rest before a wall, which from now on takes up every push.
    fn stop(&mut self, joint: Joint, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = terrain.mesh(self.size);
        let now = self.time;
        let Mode::Surface(on) = &mut self.mode else {
            return false;
        };
        let vertex = mesh.point(ahead(mesh, on.edge, joint.heading));
        let wall = joint.segment.map(|s| Track::of(mesh.segment(s)));
        let s0 = on.track.parameter_at_joint(
            mesh.segment(on.segment),
            wall.as_ref().unwrap_or(&on.track),
            vertex,
        );
        (on.t0, on.s0, on.u0, on.since) = (now, s0, 0.0, 0.0);
        on.against = joint.sign;
        self.log(EventKind::Stopped(joint.speed), trace);
        false
    }

    /// Off the end of a surface, in the direction of the motion so far, from the vertex where `onward` begins: the edge that
    /// would continue it.
    fn leave(
        &mut self,
        joint: Joint,
        onward: EdgeId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let mesh = terrain.mesh(self.size);
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        let (walkable, v) = (on.walkable, on.track.tangent * (joint.sign * joint.speed));
        // The edge out of that vertex that has a free face beside the surface on its left.
        let spoke = match joint.heading {
            Heading::Along => onward,
            Heading::Against => mesh.lnext(onward),
        };
        let d = DVec2::new(joint.before.0 as f64, joint.before.1 as f64);
        let then = DVec2::new(0.0, -1.0);
        let face = match sector(mesh, spoke, Bearing { d, then }) {
            Sector::Free(face) => Some(face),
            Sector::Solid(..) => mesh.left(spoke),
        };
        let vertex = mesh.point(mesh.origin(spoke)).metres();
        self.fly(
            vertex,
            v,
            face.expect("a surface has a free face beside it"),
            [None; 2],
        );
        if walkable {
            self.coyote_from = Some(self.time);
            self.log(EventKind::Left, trace);
        } else {
            self.log(EventKind::Parted, trace);
        }
        false
    }

    /// One who slides, at a joint: lands, goes on, is wedged, or flies off.
    fn slide_joint(&mut self, joint: Joint, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = terrain.mesh(self.size);
        let Some(s) = joint.segment else {
            return self.stop(joint, terrain, trace);
        };
        let track = Track::of(mesh.segment(s));
        let sign = Surface::sign_on(&track, joint.heading);
        let after = track.heading(sign);
        if !turns_towards(joint.before, after, joint.heading) {
            let onward = joint.next;
            return self.leave(joint, onward, terrain, trace);
        }
        let vertex = mesh.point(behind(mesh, joint.next, joint.heading));
        let onward = (joint.speed * cosine(joint.before, after)).max(0.0);
        let into = (joint.speed * joint.speed - onward * onward)
            .max(0.0)
            .sqrt();
        let at = track.parameter_at_joint(mesh.segment(s), &joint.track, vertex);
        let (sinks, goes_down) = (joint.before.1 < 0, after.1 < 0);
        let lasts = onward > 0.0 || !self.pulled_off(&track, 0.0, terrain);
        if walkable(mesh.segment(s), terrain.tuning.max_slope) {
            // Who holds against the slope that he comes down on stands at its foot: else each return would set him off again.
            let wish = self.control.run * terrain.tuning.run_speed;
            let holds = wish * f64::from(after.0.signum() as i32) < 0.0 && onward <= wish.abs();
            let u = if holds { 0.0 } else { sign * onward };
            self.settle(s, joint.next, at, u, into, terrain, trace);
            if let (true, Mode::Surface(on)) = (holds, &mut self.mode) {
                on.against = -sign;
            }
        } else if lasts && (goes_down || !sinks && onward > 0.0) {
            self.settle(s, joint.next, at, sign * onward, into, terrain, trace);
        } else if sinks && !goes_down {
            // Gravity drives it back from both sides.
            self.wedge(track.position(at), joint.next, terrain, trace);
        } else {
            return self.stop(joint, terrain, trace);
        }
        false
    }
}

/// Whether a walker stays on the ground where it bends away.
///
/// By curvature: iff s^2 k <= g cos(slope) + stick, with the slope of the bisector and k = 2 tan(turn / 2) over the mean
/// length of the two feature edges, each counted up to the curve span; independent of how finely a curve is drawn.
fn holds(
    joint: &Joint,
    after: (i64, i64),
    mesh: &Mesh,
    from: SegmentId,
    to: SegmentId,
    t: &Motion,
) -> bool {
    if t.joint == 0.0 {
        return true;
    }
    if t.joint == 2.0 {
        return joint.speed == 0.0;
    }
    let (l, m) = (length(joint.before), length(after));
    let (turn, along) = (
        cross(joint.before, after) as f64,
        dot(joint.before, after) as f64,
    );
    let tan_half = turn.abs() / (l * m + along);
    let span = |s: SegmentId| {
        let segment = mesh.segment(s);
        (segment.b.metres() - segment.a.metres())
            .length()
            .min(t.joint_span)
    };
    let curvature = 2.0 * tan_half / (0.5 * (span(from) + span(to)));
    let (x, y) = (
        joint.before.0 as f64 / l + after.0 as f64 / m,
        joint.before.1 as f64 / l + after.1 as f64 / m,
    );
    let cos_slope = x.abs() / (x * x + y * y).sqrt();
    joint.speed * joint.speed * curvature <= t.gravity * cos_slope + t.joint_stick
}
