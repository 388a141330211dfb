//! Struck by another frame: a body on a surface, or wedged, that an edge of another frame comes up against, or that comes up
//! against one. It is taken over by that edge, or stays and is pressed by it: see [`super::contact`].

use super::body::{Body, EventKind, Mode, Size, Surface, Trace, Wedge};
use super::contact::Contact;
use super::footing::Footing;
use super::grip::Grip;
use super::joint::{Joint, Onward};
use super::terrain::{Ground, Terrain};
use super::track::Track;
use super::vertex::{
    Bearing, Heading, JOINT_STEPS, Sector, face_towards, fan_ends, gone_into, sector, segment_at,
    surface_next,
};
use crate::geom::STEP;
use crate::mesh::{EdgeId, FaceId, SegmentId};
use crate::tune::Motion;
use glam::DVec2;

impl Body {
    /// On a surface, and an edge of another frame is reached: taken over by that, or pressed by it.
    pub(super) fn struck(&mut self, i: usize, edge: EdgeId, terrain: &Terrain, trace: &mut Trace) {
        let t = terrain.tuning;
        let mesh = self.beside[i].ground(self.size, terrain);
        let (q, w) = self.seen_from(&self.beside[i]);
        let Some(segment) = gone_into(mesh, edge, w, self.beside[i].flight.accel) else {
            return self.crush(terrain, trace);
        };
        let track = mesh.track(segment);
        let into = -track.normal.dot(w);
        if self.only_touches(i, edge, segment, terrain, trace) {
            return;
        }
        let Mode::Surface(on) = &self.mode else {
            return;
        };
        let onto = mesh.walkable(segment);
        let (walks, below) = (on.walkable, on.clone());
        if walks && !onto && self.passes_lip(i, segment, terrain) {
            return;
        }
        self.rebase();
        self.keep_to_edge(terrain);
        let into = into.max(0.0);
        let opens = below.track.normal.dot(track.normal);
        // Who is pressed onto his surface has all of them decide together.
        let free = opens > 0.0 && !self.is_pinned(below.track.normal);
        let hands_over = match (walks, onto) {
            (true, true) => free,
            // Who holds on is pushed by ground from which he would come off at once.
            (false, true) => {
                let accel = self.beside[i].piece().accel;
                below.grip == Grip::None || !self.drops_from(track.normal, accel, t)
            }
            (true, false) => false,
            (false, false) => free && rises(into * opens, t),
        };
        let contact = Contact {
            segment,
            track,
            edge,
        };
        let u = match (walks, onto) {
            (true, true) => onward_speed(below.speed(self.time), &below.track, &track, w, t),
            _ => track.tangent.dot(w),
        };
        let held = walks && onto && self.is_held_beside(i, &contact, u, terrain);
        if held || !hands_over {
            return self.touch(i, contact, into, trace, mesh);
        }
        let (s, mover) = (track.parameter(q), self.beside[i].mover());
        let wall = self.wall_beside(self.ground(terrain));
        let surface = Surface::new(self.time, (segment, track, edge), s, u, onto);
        self.board(i, surface, terrain);
        self.log(
            match (walks, onto) {
                (true, true) => EventKind::Boarded(mover),
                (_, true) => EventKind::Landed(into),
                _ => EventKind::Hit(into),
            },
            trace,
        );
        if opens <= 0.0 {
            // The old surface stands in the way of the new one.
            let was = Contact {
                segment: below.segment,
                track: below.track,
                edge: below.edge,
            };
            self.beside[i].contact = Some(was);
        } else if let Some(wall) = wall.and_then(|s| self.at_hand(&self.beside[i], s, terrain)) {
            // And so does what he has stood against.
            let mesh = self.beside[i].ground(self.size, terrain);
            self.beside[i].press(wall, mesh);
        }
    }

    /// Where rounding of the time has put the body before the end of its piece that it has just passed, that end.
    pub(super) fn keep_to_edge(&mut self, terrain: &Terrain) {
        let mesh = self.ground(terrain);
        let Mode::Surface(on) = &self.mode else {
            return;
        };
        let ends = [mesh.origin(on.edge), mesh.dest(on.edge)];
        let [a, b] = ends.map(|v| on.track.parameter_of(mesh.point(v)));
        let s = on.s0.clamp(a.min(b), a.max(b));
        let rounding = self.rounding_along(&on.track, self.local_velocity());
        if let Mode::Surface(on) = &mut self.mode
            && (s - on.s0).abs() <= rounding
        {
            on.s0 = s;
        }
    }

    /// Whether a walker whom ground of another frame strikes is held between that and his own: each drives him into the other, and
    /// with the speed `u` on the new one he would come no further off the old than the width of a joint before he turns. He stays on
    /// the old then, pressed by the new. In one frame [`Body::is_held`] says the same.
    fn is_held_beside(&self, i: usize, new: &Contact, u: f64, terrain: &Terrain) -> bool {
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        let (now, beside) = (self.time, &self.beside[i]);
        let (mine, other) = (self.frame_piece(), beside.piece());
        let mesh = beside.ground(self.size, terrain);
        let footing = Footing::under(new.edge, new.segment, &new.track, mesh, terrain);
        let (crouched, t) = (self.size == Size::Crouch, terrain.tuning);
        // The law counts along x, the parameter of ground steeper than 45 degrees along y.
        let x = if new.track.tangent.x < 0.0 { -1.0 } else { 1.0 };
        let law = footing.law(u * x, &self.control, crouched, t);
        let apart = new.track.tangent * u + other.velocity(now) - mine.velocity(now);
        let drive = match self.drops_from(new.track.normal, other.accel, t) {
            // He would not stay on it: so he falls.
            true => self.flight_accel(t) - mine.accel,
            false => new.track.tangent * (law.accel * x) + other.accel - mine.accel,
        };
        let push = on.track.tangent * on.accel + mine.accel - other.accel;
        let (away, back) = (on.track.normal.dot(apart), on.track.normal.dot(drive));
        let width = f64::from(JOINT_STEPS) * STEP;
        new.track.normal.dot(push) < 0.0
            && back < 0.0
            && (away <= 0.0 || away * away <= -2.0 * back * width)
    }

    /// Whether an edge of another frame is met without being gone into: at its end, on the way past; or moving off, where only a lip
    /// that rounding has left is in the way.
    fn only_touches(
        &mut self,
        i: usize,
        edge: EdgeId,
        segment: SegmentId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let (now, size) = (self.time, self.size);
        let (q, w) = self.seen_from(&self.beside[i]);
        let beside = &mut self.beside[i];
        let mesh = beside.ground(size, terrain);
        let track = mesh.track(segment);
        let known = beside.flight.touching.contains(&Some(segment));
        let (s, rounding) = (track.parameter(q), self.rounding_along(&track, w));
        let beside = &mut self.beside[i];
        let bearing = Bearing::of(w, beside.flight.accel);
        let ends =
            [edge, mesh.lnext(edge)].map(|e| (track.parameter_of(mesh.point(mesh.origin(e))), e));
        let beyond = |(end, _): (f64, EdgeId), (other, _): (f64, EdgeId)| {
            (s - end) * (other - end).signum() <= rounding
        };
        let at_end = [(ends[0], ends[1]), (ends[1], ends[0])]
            .into_iter()
            .find(|&(end, other)| beyond(end, other))
            .map(|((_, spoke), _)| sector(mesh, spoke, bearing));
        let past = match at_end {
            // Again: here rounding keeps it on the piece.
            Some(Sector::Free(face)) if !known => Some(face),
            _ => None,
        };
        let moves_off = track.normal.dot(w) > 0.0 && !known;
        if past.is_none() && !moves_off {
            return false;
        }
        if let Some(face) = past {
            beside.flight.face = face;
            trace.crossed += 1;
        }
        beside.flight.touching[1] = Some(segment);
        beside.plan(now, size, terrain);
        true
    }

    /// Begins a contact.
    fn touch(&mut self, i: usize, contact: Contact, into: f64, trace: &mut Trace, mesh: Ground) {
        let mine = self.frame_piece();
        let beside = &mut self.beside[i];
        let apart = beside.piece().velocity(self.time) - mine.velocity(self.time);
        let kind = match beside.mover() {
            Some(mover) if contact.track.normal.dot(apart) > 0.0 => EventKind::Pushed(mover),
            _ => EventKind::Stopped(into),
        };
        beside.press(contact, mesh);
        self.log(kind, trace);
        self.keep_before(i, &contact);
        if let Mode::Surface(on) = &mut self.mode
            && std::mem::take(&mut on.grip) != Grip::None
        {
            self.log(EventKind::LetGo, trace);
        }
    }

    /// On a surface, and in a contact with another frame: where rounding of the time has put the body behind that, in front of it. From
    /// here on its speed may be too small to explain it.
    fn keep_before(&mut self, i: usize, contact: &Contact) {
        let (q, w) = self.seen_from(&self.beside[i]);
        let (height, ..) = contact.track.height(q, q, q);
        let rounding = self.rounding_at(w.length());
        let Mode::Surface(on) = &mut self.mode else {
            return;
        };
        let back = height / contact.track.normal.dot(on.track.tangent);
        if height < 0.0 && back.abs() <= rounding {
            on.s0 -= back * on.track.rate();
        }
    }

    /// At an end of the mesh edge that presses: on along the same line, round a corner that presses too, or past its end. True if
    /// the motion of the body does not change.
    pub(super) fn slide_past(&mut self, i: usize, terrain: &Terrain, trace: &mut Trace) -> bool {
        let (now, size, _t) = (self.time, self.size, terrain.tuning);
        let (_, w) = self.seen_from(&self.beside[i]);
        let beside = &mut self.beside[i];
        let mesh = beside.ground(size, terrain);
        let Some(mut contact) = beside.contact else {
            return true;
        };
        let moves = contact.track.tangent.dot(w);
        let turns = contact.track.tangent.dot(beside.flight.accel);
        let sign = if moves != 0.0 { moves } else { turns };
        let heading = Heading::of(sign, &contact.track);
        let next = surface_next(mesh, contact.edge, heading);
        let same = |s: SegmentId| s == contact.segment || mesh.track(s).same_line(&contact.track);
        let next = next.and_then(|e| Some((e, segment_at(mesh, e, same)?)));
        if let Some((next, s)) = next.filter(|&(_, s)| same(s)) {
            (contact.edge, contact.segment) = (next, s);
            beside.contact = Some(contact);
            beside.flight.face = mesh.left(next).unwrap_or(beside.flight.face);
            beside.flight.touching = [Some(s), None];
            beside.flight.since = now - beside.flight.t0;
            beside.plan(now, size, terrain);
            return true;
        }
        self.rebase();
        let beside = &mut self.beside[i];
        let onward = next.map(|(e, s)| (e, s, mesh.track(s)));
        let outwards = contact.track.tangent * sign.signum();
        let starts = moves.abs() <= beside.flight.grain;
        match onward {
            Some((edge, segment, track)) if track.normal.dot(outwards) < 0.0 => {
                // The corner turns towards the body: now that edge presses, if there is a speed for both.
                let new = Contact {
                    segment,
                    track,
                    edge,
                };
                self.press_in_corner(i, new, terrain, trace);
            }
            // From rest it is drawn round the corner: the edge there presses at once, or it is let go of for its law leads away.
            Some((edge, segment, track)) if starts => {
                beside.flight.face = mesh.left(edge).unwrap_or(beside.flight.face);
                beside.flight.touching = [Some(segment), Some(contact.segment)];
                beside.contact = Some(Contact {
                    segment,
                    track,
                    edge,
                });
                beside.of = None;
            }
            _ => {
                let spoke = match heading {
                    Heading::Along => mesh.lnext(contact.edge),
                    Heading::Against => contact.edge,
                };
                let bearing = Bearing {
                    d: outwards,
                    then: contact.track.normal,
                };
                let face = face_towards(mesh, spoke, bearing);
                beside.flight.face = face.unwrap_or(beside.flight.face);
                beside.flight.touching = [None; 2];
                (beside.contact, beside.of) = (None, None);
            }
        }
        false
    }

    /// Two edges of one frame press at a corner: the second alone from here on, if it presses to the same side; else there is no
    /// way out.
    pub(super) fn press_in_corner(
        &mut self,
        i: usize,
        new: Contact,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let Mode::Surface(on) = &self.mode else {
            return;
        };
        let mesh = self.beside[i].ground(self.size, terrain);
        let side = |c: &Contact| {
            let lever = c.track.normal.dot(on.track.tangent);
            if lever == 0.0 { 0.0 } else { lever.signum() }
        };
        let old = self.beside[i].contact;
        if side(&new) == 0.0 || old.is_some_and(|old| side(&old) != side(&new)) {
            return self.crush(terrain, trace);
        }
        self.touch(i, new, 0.0, trace, mesh);
    }

    /// Pressed against a joint by another frame: onto the next surface as far as the contacts leave room, else crushed. One who
    /// only leans on what presses stops as ever.
    pub(super) fn squeeze(
        &mut self,
        joint: Joint,
        onward: Option<Onward>,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let mesh = self.ground(terrain);
        let Some(on) = onward else {
            return self.crush(terrain, trace);
        };
        let up = (joint.speed * on.cosine).max(0.0);
        let driven = self.presses_on(joint.track.tangent * joint.sign, terrain);
        match self.squeezes(&on, up, terrain) {
            // From rest he goes on only if he has to: else he would be back at once.
            Some(u) if u != 0.0 || driven => {
                let into = joint.lost(up);
                self.settle(on.segment, on.edge, on.start, u, into, terrain, trace);
            }
            None if driven => self.crush(terrain, trace),
            _ => self.stop(&joint, Some(&on), trace, mesh),
        }
    }

    /// Whether what presses on a walker drives him into a joint, and back into it along the ground beyond.
    pub(super) fn is_shut(&self, joint: &Joint, on: &Onward, terrain: &Terrain) -> bool {
        self.squeezes(on, joint.speed, terrain).is_none()
            && self.presses_on(joint.track.tangent * joint.sign, terrain)
    }

    /// Shut in at a joint: on what presses, if that is on the same side as both surfaces and so comes up under him; else crushed.
    pub(super) fn be_shut(&mut self, onward: &Onward, terrain: &Terrain, trace: &mut Trace) {
        let normals = match &self.mode {
            Mode::Surface(on) => [on.track.normal, onward.track.normal],
            _ => return,
        };
        let below = |c: Contact| normals.iter().all(|n| n.dot(c.track.normal) > 0.0);
        match self
            .beside
            .iter()
            .position(|b| b.contact.is_some_and(below))
        {
            Some(i) => self.be_taken_over(i, terrain, trace),
            None => self.crush(terrain, trace),
        }
    }

    /// Held at a vertex, and struck by an edge of another frame: taken over by it, pressed up one of the sides, or crushed.
    pub(super) fn struck_in_wedge(
        &mut self,
        i: usize,
        edge: EdgeId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let _t = terrain.tuning;
        let mesh = self.beside[i].ground(self.size, terrain);
        let segment = segment_at(mesh, edge, |_| false);
        let Some((segment, [a, b])) = segment.zip(self.sides_of_wedge(terrain)) else {
            return self.crush(terrain, trace);
        };
        let track = mesh.track(segment);
        let (q, w) = self.seen_from(&self.beside[i]);
        let into = -track.normal.dot(w);
        if self.only_touches(i, edge, segment, terrain, trace) {
            return;
        }
        let blocked = [a, b]
            .into_iter()
            .filter(|(side, _)| side.track.normal.dot(track.normal) < 0.0);
        let blocked: Vec<(Surface, DVec2)> = blocked.collect();
        match &blocked[..] {
            [] => {
                let onto = mesh.walkable(segment);
                let (s, u) = (track.parameter(q), track.tangent.dot(w));
                self.board(
                    i,
                    Surface::new(self.time, (segment, track, edge), s, u, onto),
                    terrain,
                );
                let kind = if onto {
                    EventKind::Landed(into)
                } else {
                    EventKind::Hit(into)
                };
                self.log(kind, trace);
            }
            // Along it out of the corner, and not into it.
            [(side, out)] if out.dot(track.normal) > 0.0 => {
                self.mode = Mode::Surface(side.clone());
                self.touch(
                    i,
                    Contact {
                        segment,
                        track,
                        edge,
                    },
                    into,
                    trace,
                    mesh,
                );
            }
            _ => self.crush(terrain, trace),
        }
    }

    /// The feature edges that a flight from here leaves: what the body is on, or what wedges it.
    pub(super) fn left_behind(&self, terrain: &Terrain) -> [Option<SegmentId>; 2] {
        match self.sides_of_wedge(terrain) {
            Some([(a, _), (b, _)]) => [Some(a.segment), Some(b.segment)],
            None => [self.segment(), None],
        }
    }

    /// The free face into which a velocity leads from here: out of a wedge not always the one that it is in.
    pub(super) fn face_ahead(&self, v: DVec2, mesh: Ground) -> FaceId {
        let spoke = match &self.mode {
            Mode::Wedge(wedge) => spoke_of(wedge, mesh),
            _ => None,
        };
        let bearing = Bearing {
            d: v,
            then: DVec2::ZERO,
        };
        match spoke.map(|spoke| sector(mesh, spoke, bearing)) {
            Some(Sector::Free(face)) => face,
            _ => self.face(&mesh),
        }
    }

    /// The two surfaces that hold a wedged body, at rest on each of them, and the directions that lead out of the corner.
    pub(super) fn sides_of_wedge(&self, terrain: &Terrain) -> Option<[(Surface, DVec2); 2]> {
        let Mode::Wedge(wedge) = &self.mode else {
            return None;
        };
        let mesh = self.ground(terrain);
        let spoke = spoke_of(wedge, mesh)?;
        let surface = |edge: EdgeId| {
            let segment = segment_at(mesh, edge, |_| false)?;
            let track = mesh.track(segment);
            let walks = mesh.walkable(segment);
            let s = track.parameter(wedge.at);
            let place = (segment, track, edge);
            let surface = Surface::new(self.time, place, s, 0.0, walks);
            let away = (mesh.origin(edge) == mesh.origin(spoke)) == track.leftward_free;
            Some((surface, if away { track.tangent } else { -track.tangent }))
        };
        let (out, into) = fan_ends(mesh, spoke)?;
        Some([surface(out)?, surface(into)?])
    }
}

/// The edge out of the vertex of a wedge with its face on the left.
fn spoke_of(wedge: &Wedge, mesh: Ground) -> Option<EdgeId> {
    let distance = |e: &EdgeId| (mesh.point(mesh.origin(*e)).metres() - wedge.at).length();
    let corners = mesh.sides(wedge.face).into_iter();
    corners.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

/// The speed of a walker who goes on from a road, where he has the speed `u`, onto another of another frame, in which his velocity
/// is `w`: what `w` has along the second; or, where bends keep the speed and he walks towards it, all of `u` and not only its part
/// along that.
fn onward_speed(u: f64, from: &Track, onto: &Track, w: DVec2, t: &Motion) -> f64 {
    let along = onto.tangent.dot(w);
    let kept = onto.tangent.dot(from.tangent * u);
    let overtakes = onto.normal.dot(from.tangent * u) >= 0.0;
    match t.concave == 1.0 || overtakes {
        true => along,
        false => along - kept + u.abs().copysign(kept),
    }
}

/// Whether a speed carries a body further than a joint may rise, so that ever smaller bounces end.
fn rises(speed: f64, t: &Motion) -> bool {
    speed * speed > 2.0 * t.gravity * f64::from(JOINT_STEPS) * STEP
}
