//! Joints: where a surface turns into another one, turns away from the body, or ends.

use super::body::{Body, EventKind, Mode, Size, Surface, Trace};
use super::footing::Footing;
use super::grip::Grip;
use super::terrain::{Concave, Ground, Terrain};
use super::track::{Track, wide_cross, wide_dot};
use super::vertex::{
    Bearing, Heading, JOINT_STEPS, Sector, ahead, behind, bridge, is_lip, past_lips, sector,
    segment_at, surface_next, turns_towards,
};
use crate::geom::STEP;
use crate::mesh::{EdgeId, SegmentId, Source};
use crate::tune::Motion;
use glam::DVec2;

/// The joint that a body has come to: how it came, and what is next.
pub(super) struct Joint {
    /// Speed, not negative.
    pub(super) speed: f64,
    /// Sign of the parameter's change so far.
    pub(super) sign: f64,
    pub(super) heading: Heading,
    /// The edge of the surface so far.
    pub(super) edge: EdgeId,
    /// The feature edge so far, and its road.
    pub(super) segment: SegmentId,
    pub(super) track: Track,
    /// Exact direction of the motion so far.
    pub(super) before: (i64, i64),
    /// The edge out of the vertex that has the face beside the surface so far on its left.
    pub(super) beside: EdgeId,
    /// The next edge of the surface, if it goes on.
    pub(super) next: Option<EdgeId>,
}

/// A way on from a joint.
pub(super) struct Onward {
    pub(super) edge: EdgeId,
    pub(super) segment: SegmentId,
    pub(super) track: Track,
    /// Sign of the parameter's change there.
    pub(super) sign: f64,
    /// Exact direction of the motion there.
    pub(super) after: (i64, i64),
    /// The parameter there at which it starts.
    pub(super) start: f64,
    /// The surface turns towards the body.
    pub(super) towards: bool,
    /// Cosine of the turn.
    pub(super) cosine: f64,
}

impl Joint {
    /// The joint ahead of a body that comes to it with a speed.
    pub(super) fn ahead(on: &Surface, sign: f64, speed: f64, mesh: Ground) -> Joint {
        let heading = on.heading(sign);
        Joint {
            speed,
            sign,
            heading,
            edge: on.edge,
            segment: on.segment,
            track: on.track,
            before: mesh.heading(on.segment, &on.track, sign),
            beside: match heading {
                Heading::Along => mesh.lnext(on.edge),
                Heading::Against => on.edge,
            },
            next: surface_next(mesh, on.edge, heading),
        }
    }

    /// 1 or -1 as the motion so far goes towards growing or falling x.
    pub(super) fn forward(&self) -> f64 {
        self.before.0.signum() as f64
    }

    /// The edge out of the vertex where `onward` begins that has the face beside it on its left.
    fn nearest(&self, onward: Option<EdgeId>, mesh: Ground) -> EdgeId {
        onward.map_or(self.beside, |onward| match self.heading {
            Heading::Along => onward,
            Heading::Against => mesh.lnext(onward),
        })
    }

    /// An edge out of that vertex that has a free face beside the surface on its left: beside the surface so far if it comes
    /// to that vertex, for what is reached from there counts. `onward`: the edge that would continue it, if there is one.
    pub(super) fn spoke(&self, onward: Option<EdgeId>, mesh: Ground) -> EdgeId {
        let nearest = self.nearest(onward, mesh);
        match mesh.origin(nearest) == mesh.origin(self.beside) {
            true => self.beside,
            false => nearest,
        }
    }

    /// The way on along an edge of the surface, as part of a feature edge.
    pub(super) fn onto(&self, mesh: Ground, edge: EdgeId, segment: SegmentId) -> Onward {
        let track = mesh.track(segment);
        let sign = self.heading.sign(&track);
        let after = mesh.heading(segment, &track, sign);
        let vertex = mesh.point(behind(mesh, edge, self.heading));
        Onward {
            edge,
            segment,
            track,
            sign,
            after,
            start: track.parameter_at_joint(mesh.segment(segment), &self.track, vertex),
            towards: turns_towards(self.before, after, self.heading),
            cosine: wide_dot(self.before, after) as f64 / (length(self.before) * length(after)),
        }
    }

    /// The way on along the surface, as part of the best of the feature edges there.
    pub(super) fn onward(&self, mesh: Ground) -> Option<Onward> {
        let next = self.next?;
        let segment = segment_at(mesh, next, |_| false)?;
        Some(self.onto(mesh, next, segment))
    }

    /// Whether a way on has the direction so far, as both were drawn.
    fn goes_straight_on(&self, on: &Onward) -> bool {
        wide_cross(self.before, on.after) == 0 && wide_dot(self.before, on.after) > 0
    }

    /// Whether the ground ends here, for what would continue it turns away or is not there at all.
    pub(super) fn is_end(&self, onward: Option<&Onward>) -> bool {
        onward.map_or(self.next.is_none(), |on| !on.towards)
    }

    /// The speed that is lost where only `kept` of it goes on.
    pub(super) fn lost(&self, kept: f64) -> f64 {
        (self.speed * self.speed - kept * kept).max(0.0).sqrt()
    }
}

fn vector(v: (i64, i64)) -> DVec2 {
    DVec2::new(v.0 as f64, v.1 as f64)
}

fn length(v: (i64, i64)) -> f64 {
    vector(v).length()
}

impl Body {
    /// At the vertex ahead. True if the surface simply goes on along the same line: that is no event.
    pub(super) fn pass_vertex(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = self.ground(terrain);
        let now = self.time;
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        trace.passed += 1;
        let sign = on.sign();
        let heading = on.heading(sign);
        let next = surface_next(mesh, on.edge, heading);
        let same_line = |s: SegmentId| s == on.segment || mesh.track(s).same_line(&on.track);
        let onward = next.and_then(|next| segment_at(mesh, next, same_line).map(|s| (next, s)));
        let alike = |to| !on.walkable || mesh.drive_alike((on.edge, on.segment), to);
        let straight = onward.filter(|&to| same_line(to.1) && alike(to));
        let regrips = straight.is_some_and(|(next, _)| self.meets_other_grip(next, terrain));
        let Mode::Surface(on) = &mut self.mode else {
            return false;
        };
        if let Some((next, s)) = straight.filter(|_| !regrips || on.grip == Grip::None) {
            (on.edge, on.segment, on.since) = (next, s, (now - on.t0).max(on.since));
            if regrips {
                self.rebase();
            }
            return !regrips;
        }
        let joint = Joint::ahead(on, sign, on.speed(now).abs(), mesh);
        let walks = on.walkable;
        let onward = onward.map(|(next, s)| joint.onto(mesh, next, s));
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
        if let Some(ground) = self.ground_ahead(&joint, onward.as_ref(), terrain) {
            return self.walk_on(joint, ground, terrain, trace);
        }
        let bump = onward.as_ref().is_some_and(|on| is_bump(&joint, on, mesh));
        match onward {
            _ if joint.is_end(onward.as_ref())
                && self.is_brought_back(&joint, self.time, terrain) =>
            {
                self.stop(&joint, onward.as_ref(), trace, mesh);
            }
            Some(on) if !on.towards => self.leave_or_snap(joint, Some(&on), terrain, trace),
            None if joint.next.is_none() => self.leave_or_snap(joint, None, terrain, trace),
            Some(on)
                if !bump
                    && keeps(&joint, &on, false, mesh, terrain)
                    && climbs(joint.speed, t)
                    && self.squeezes(&on, joint.speed, terrain).is_some() =>
            {
                self.bend(&on, joint.speed, terrain, trace);
            }
            on if self.is_pressed_at_joint(terrain, trace) => {
                self.squeeze(joint, on, terrain, trace)
            }
            Some(_) if self.step_up(&joint, terrain, trace) => {}
            Some(on) if !bump && climbs(joint.speed * on.cosine, t) => {
                let up = joint.speed * on.cosine;
                let (u, into) = (on.sign * up, joint.lost(up));
                self.settle(on.segment, on.edge, on.start, u, into, terrain, trace);
            }
            on => self.stop(&joint, on.as_ref(), trace, mesh),
        }
        false
    }

    /// The walkable ground beyond a joint, if the surface, or a lip that rounding has left, leads onto some.
    pub(super) fn ground_ahead(
        &self,
        joint: &Joint,
        onward: Option<&Onward>,
        terrain: &Terrain,
    ) -> Option<Onward> {
        let mesh = self.ground(terrain);
        let next = onward.map(|on| (on.edge, on.segment));
        let next = next.filter(|&(_, s)| mesh.walkable(s));
        let (edge, s) = match next {
            Some((_, s)) if !is_lip(mesh.segment(s)) => next,
            _ => {
                let home = mesh.origin(joint.beside);
                // Round a hole no larger than a joint the surface comes back to where the walker is.
                let back = |e: EdgeId| Some(e) == self.edge();
                let bridge = bridge(mesh, home, joint.next, joint.heading);
                bridge.filter(|&(e, _)| !back(e)).or(next)
            }
        }?;
        Some(joint.onto(mesh, edge, s))
    }

    /// Round a bend from walkable ground to walkable ground. True as for [`Body::pass_vertex`].
    fn walk_on(&mut self, joint: Joint, on: Onward, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = self.ground(terrain);
        let t = terrain.tuning;
        let now = self.time;
        let Mode::Surface(surface) = &mut self.mode else {
            return false;
        };
        let edge = surface.edge;
        let straight = joint.goes_straight_on(&on);
        let alike = mesh.drive_alike((edge, joint.segment), (on.edge, on.segment));
        let parallel = on.track.is_parallel(&joint.track);
        if straight && parallel && alike {
            // Parallel, within the steps of a joint: the same parameter, so the piece goes on.
            (surface.edge, surface.segment, surface.track) = (on.edge, on.segment, on.track);
            surface.since = (now - surface.t0).max(surface.since);
            return true;
        }
        if self.is_pressed_at_joint(terrain, trace) && self.is_shut(&joint, &on, terrain) {
            self.be_shut(&on, terrain, trace);
            return false;
        }
        if self.is_held(&joint, &on, terrain) {
            self.stop(&joint, Some(&on), trace, mesh);
            return false;
        }
        let hops = !on.towards && !straight;
        let hops = hops && !joint.holds(edge, &on, mesh, t);
        if hops && !self.is_brought_back(&joint, self.time, terrain) {
            self.leave(joint, Some(on.edge), terrain, trace);
            return false;
        }
        let kept = match on.towards && !keeps(&joint, &on, t.concave == 0.0, mesh, terrain) {
            true => on.cosine.max(0.0),
            false => 1.0,
        };
        self.bend(&on, joint.speed * kept, terrain, trace);
        false
    }

    /// Round a bend onto another feature edge, with a speed along it.
    pub(super) fn bend(&mut self, on: &Onward, speed: f64, terrain: &Terrain, trace: &mut Trace) {
        self.put_on(on.edge, on.segment, on.start, on.sign * speed, terrain);
        self.log(EventKind::Joint, trace);
    }

    /// Onto a feature edge of what carries the body, from another one: at a parameter, with a speed along it.
    pub(super) fn put_on(
        &mut self,
        edge: EdgeId,
        segment: SegmentId,
        s0: f64,
        u0: f64,
        terrain: &Terrain,
    ) {
        let mesh = self.ground(terrain);
        let place = (segment, mesh.track(segment), edge);
        let walks = mesh.walkable(segment);
        self.mode = Mode::Surface(Surface::new(self.time, place, s0, u0, walks));
    }

    /// At rest before a wall (none: the world's border), which from now on takes up every push.
    pub(super) fn stop(
        &mut self,
        joint: &Joint,
        wall: Option<&Onward>,
        trace: &mut Trace,
        mesh: Ground,
    ) {
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
    /// would continue it, if there is one.
    pub(super) fn leave(
        &mut self,
        joint: Joint,
        onward: Option<EdgeId>,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let mesh = self.ground(terrain);
        let walked = self.supported();
        let spoke = joint.spoke(onward, mesh);
        let bearing = Bearing {
            d: vector(joint.before),
            then: DVec2::new(0.0, -1.0),
        };
        let face = match sector(mesh, spoke, bearing) {
            Sector::Free(face) => Some(face),
            Sector::Solid(..) => mesh.left(joint.nearest(onward, mesh)),
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
        // At the free end of a one-way nothing is in the way.
        let blocks = onward
            .as_ref()
            .map_or(joint.next.is_some(), |on| on.towards);
        if blocks && self.is_pressed_at_joint(terrain, trace) {
            return self.squeeze(joint, onward, terrain, trace);
        }
        if self.climbing {
            return self.ladder_joint(joint, onward, terrain, trace);
        }
        if self.climb_joint(&joint, onward.as_ref(), terrain, trace) {
            return;
        }
        let Some(on) = onward else {
            return match joint.next {
                None => self.leave(joint, None, terrain, trace),
                Some(_) => self.stop(&joint, None, trace, mesh),
            };
        };
        // Drawn as one line, which the grid has bent a little.
        if joint.goes_straight_on(&on) && !on.track.is_parallel(&joint.track) {
            return self.bend(&on, joint.speed, terrain, trace);
        }
        if !on.towards {
            return self.leave(joint, Some(on.edge), terrain, trace);
        }
        let keeps = keeps(&joint, &on, false, mesh, terrain);
        let kept = if keeps {
            joint.speed
        } else {
            (joint.speed * on.cosine).max(0.0)
        };
        let into = joint.lost(kept);
        let u = on.sign * kept;
        let (sinks, goes_down) = (joint.before.1 < 0, on.after.1 < 0);
        let lasts =
            kept > 0.0 || !self.pulled_off(&on.track, &self.moment(&on.track, 0.0), terrain);
        if mesh.walkable(on.segment) {
            // Who is driven against the slope that he comes down on stands at its foot: else each return would set him off again.
            let crouched = self.size == Size::Crouch;
            let footing = Footing::under(on.edge, on.segment, &on.track, mesh, terrain);
            let wish = footing.steady(&self.control, crouched, terrain.tuning);
            let stands = !keeps && wish * vector(on.after).x < 0.0 && kept <= wish.abs();
            let u = if stands { 0.0 } else { u };
            self.settle(on.segment, on.edge, on.start, u, into, terrain, trace);
            if let (true, Mode::Surface(ground)) = (stands, &mut self.mode) {
                ground.against = -on.sign;
            }
        } else if keeps && (goes_down || climbs(kept, terrain.tuning)) {
            self.bend(&on, kept, terrain, trace);
        } else if lasts && (goes_down || !sinks && kept > 0.0) {
            self.settle(on.segment, on.edge, on.start, u, into, terrain, trace);
        } else if sinks && !goes_down {
            // Gravity drives it back from both sides.
            let vertex = mesh.point(behind(mesh, on.edge, joint.heading));
            let at = on.track.corner(&joint.track, vertex);
            self.wedge(at, on.edge, terrain, trace);
        } else {
            self.stop(&joint, Some(&on), trace, mesh);
        }
    }
}

/// Whether a walker comes to the corner of a step, which the bevelled flank of his own foot would slide up: to him it is a wall.
/// Not the lip that rounding leaves of such a flank at the foot of a slope.
fn is_bump(joint: &Joint, on: &Onward, mesh: Ground) -> bool {
    if !on.towards {
        return false;
    }
    let home = mesh.origin(joint.beside);
    let edge = past_lips(mesh, home, on.edge, joint.heading);
    let Some(s) = edge.and_then(|e| segment_at(mesh, e, |s| s == on.segment)) else {
        return false;
    };
    let after = joint.onto(mesh, on.edge, s).after;
    let is_flank = matches!(mesh.segment(s).source, Source::Corner { .. });
    is_flank && !mesh.walkable(s) && after.1 > 0 && after.0 as f64 * joint.forward() > 0.0
}

/// Whether the speed round a concave joint is kept and not projected: as the two features say, else `otherwise`. A turn of a
/// right angle or more is a wall, not a bend: nobody runs on round it.
fn keeps(joint: &Joint, on: &Onward, otherwise: bool, mesh: Ground, terrain: &Terrain) -> bool {
    let [from, to] = [joint.segment, on.segment].map(|s| mesh.segment(s).feature);
    let choice = terrain.concave_of(from, to);
    wide_dot(joint.before, on.after) > 0 && choice.map_or(otherwise, |c| c == Concave::Keep)
}

/// Whether a speed up a steep face carries a body higher than a joint may rise: only then it goes up at all, so that the ever
/// smaller returns of a push end.
fn climbs(up: f64, t: &Motion) -> bool {
    up > 0.0 && up * up > 2.0 * t.gravity * f64::from(JOINT_STEPS) * STEP
}
