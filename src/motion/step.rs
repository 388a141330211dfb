//! The order of operations: controls come in at a time, events are taken in order of time up to another.

use super::body::{Air, Body, Control, Event, EventKind, Mode, Next, Size, Surface, Trace, Wedge};
use super::event::Way;
use super::footing::Footing;
use super::grip::Grip;
use super::ladder::Reach;
use super::law;
use super::terrain::Terrain;
use crate::mesh::{FaceId, SegmentId};
use glam::DVec2;

/// So many events at one and the same time can only be a cycle. Far above the degree of any vertex of a sound level.
const CYCLE: u32 = 4096;

/// How much later, as a share of the time, rounding may make an event that comes at once.
pub(super) const CREEP: f64 = 8.0 * f64::EPSILON;

impl Body {
    /// Sets the velocity, as an explosion or a test would: along the tangent on a surface. An event.
    pub fn set_velocity(&mut self, v: DVec2, terrain: &Terrain, trace: &mut Trace) {
        self.rebase();
        match &mut self.mode {
            Mode::Air(air) => air.v0 = v,
            Mode::Surface(on) => {
                let v = self
                    .frame
                    .map_or(v, |ride| v - ride.piece.velocity(self.time));
                (on.u0, on.against) = (on.track.tangent.dot(v), 0.0);
            }
            Mode::Wedge(_) | Mode::Crushed(_) => {}
        }
        self.refresh(terrain, trace);
    }

    /// Has a control from now on as if it had been so before: what is held does not count as pressed now.
    pub fn keep_control(&mut self, control: Control, terrain: &Terrain, trace: &mut Trace) {
        self.rebase();
        self.control = control;
        self.refresh(terrain, trace);
    }

    /// Takes a control, from now on. An event if it differs from the one before, else nothing.
    pub fn apply(&mut self, control: Control, terrain: &Terrain, trace: &mut Trace) {
        let run = if control.run.is_finite() {
            control.run.clamp(-1.0, 1.0)
        } else {
            0.0
        };
        let control = Control { run, ..control };
        let before = std::mem::replace(&mut self.control, control);
        if before == control {
            return;
        }
        if run != 0.0 {
            self.faces = run.signum();
        }
        if control.jump && !before.jump {
            (self.pressed_at, self.released_at) = (Some(self.time), None);
        }
        if !control.jump && before.jump {
            self.released_at = Some(self.time);
        }
        let anew = control.up && !before.up || control.down && !before.down;
        if anew || self.reach == Reach::Landed {
            self.reach = Reach::Open;
        }
        if anew {
            self.anew_at = Some(self.time);
        }
        self.rebase();
        if !control.jump && before.jump {
            self.cut_jump();
        }
        self.refresh(terrain, trace);
    }

    /// Takes up changed tuning from now on. An event.
    pub fn retune(&mut self, terrain: &Terrain, trace: &mut Trace) {
        self.rebase();
        self.refresh(terrain, trace);
    }

    /// Moves up to a time, event by event. Nothing happens if it is not later than now.
    pub fn advance(&mut self, to: f64, terrain: &Terrain, trace: &mut Trace) {
        let (mut still, mut held) = (0, false);
        while let Some((at, what)) = self.next.filter(|&(at, _)| at <= to) {
            // Times that rounding may have told apart are one here: a cycle may creep.
            let stands = at - self.time <= CREEP * self.time.abs();
            still = if stands { still + 1 } else { 0 };
            held &= stands;
            self.time = at.max(self.time);
            if still > CYCLE {
                // Where rest does not end it either, between solids that move, the body is crushed.
                match held {
                    true => self.crush(terrain, trace),
                    false => self.hold(terrain, trace),
                }
                self.refresh(terrain, trace);
                (still, held) = (0, true);
                continue;
            }
            if !matches!(what, Next::Cross(..)) {
                self.leave_way(trace);
            }
            self.handle(what, terrain, trace);
        }
        self.time = self.time.max(to);
    }

    /// Notes how the body has moved until now.
    pub fn leave_way(&self, trace: &mut Trace) {
        let (piece, until) = (self.motion(), self.time);
        trace.ends(Way { piece, until });
    }

    fn handle(&mut self, what: Next, terrain: &Terrain, trace: &mut Trace) {
        match what {
            Next::Cross(edge, since) => return self.cross(edge, since, terrain, trace),
            Next::Hit(edge, since) => self.hit(edge, since, terrain, trace),
            Next::Limit => self.reach_limit(trace),
            Next::Vertex if self.pass_vertex(terrain, trace) => {
                return self.come_to_place(terrain, trace);
            }
            Next::Vertex => {}
            Next::Clear(parameter) => self.come_clear(parameter),
            Next::Unlock => self.unlock(trace),
            Next::Grab(parameter) => self.grab(parameter, trace),
            Next::Mount => self.come_to_ground(terrain, trace),
            Next::Node => self.ride_on(terrain, trace),
            Next::Change => self.change(trace),
            Next::Cut => self.come_to_cut(trace),
            Next::Beside(i) => return self.handle_beside(i as usize, terrain, trace),
        }
        self.refresh(terrain, trace);
    }

    /// After an event: sizes and jumps that have waited for it, the new accelerations, the next event.
    pub(super) fn refresh(&mut self, terrain: &Terrain, trace: &mut Trace) {
        self.come_apart_from_one_way(terrain);
        self.note_regions(terrain, trace);
        self.mind_ladders(terrain, trace);
        self.resize_as_wished(terrain, trace);
        self.jump_if_asked(terrain, trace);
        self.grip_as_wished(terrain, trace);
        // What a contact gives a body at once comes before what pulls it off slowly.
        self.press_speed(terrain, trace);
        self.meet_at_once(terrain, trace);
        if !self.beside.is_empty() {
            self.meet_again(terrain, trace);
        }
        self.comes_off(terrain, trace);
        // Once more for who is off the slope on which he was granted none: in the air the coyote time may count.
        self.jump_if_asked(terrain, trace);
        if !self.beside.is_empty() {
            self.go_home(terrain);
            self.press_speed(terrain, trace);
        }
        // Off what he was on, or held on to, one may take hold of a ladder that he could not from there.
        if !self.regions.is_empty() && !self.supported() {
            let climbs = (self.climbing, self.ladder);
            self.mind_ladders(terrain, trace);
            if (self.climbing, self.ladder) != climbs {
                self.comes_off(terrain, trace);
            }
        }
        self.choose_law(terrain);
        if self.press_on(terrain, trace) {
            self.choose_law(terrain);
        }
        if let Mode::Surface(on) = &mut self.mode {
            on.stand_against_wall();
        }
        if self.is_pressed() {
            self.press_accel(terrain, trace);
            if !self.is_pressed() && self.comes_off(terrain, trace) {
                self.choose_law(terrain);
            }
        }
        self.note_ride(terrain, trace);
        self.come_to_place(terrain, trace);
    }

    /// Off what the body is pulled from, or what falls away from under it. True if it is in the air then.
    fn comes_off(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        self.part_if_pulled(terrain, trace);
        if !self.beside.is_empty() {
            self.come_off_if_dropped(terrain, trace);
            self.go_home(terrain);
        }
        matches!(self.mode, Mode::Air(_))
    }

    /// Starts a new piece here and now.
    pub(super) fn rebase(&mut self) {
        let t = self.time;
        match &mut self.mode {
            Mode::Air(air) => {
                (air.p0, air.v0) = (air.position(t), air.velocity(t));
                (air.t0, air.since) = (t, 0.0);
            }
            Mode::Surface(on) => {
                (on.s0, on.u0) = (on.parameter(t), on.speed(t));
                (on.t0, on.since) = (t, 0.0);
            }
            Mode::Wedge(_) | Mode::Crushed(_) => {}
        }
    }

    /// Goes into the air here and now.
    pub(super) fn fly(
        &mut self,
        p0: DVec2,
        v0: DVec2,
        face: FaceId,
        touching: [Option<SegmentId>; 2],
    ) {
        self.mode = Mode::Air(Air {
            t0: self.time,
            v0,
            touching,
            ..Air::resting(p0, face)
        });
    }

    /// Goes into the air here and now, as fast as it is, from nothing that it would still touch.
    pub(super) fn come_free(&mut self, terrain: &Terrain) {
        let face = self.face(&self.ground(terrain));
        self.fly(
            self.local_position(),
            self.local_velocity(),
            face,
            [None; 2],
        );
    }

    /// A jump, if one was asked for not too long ago and there is ground, or was not too long ago; else one from a wall.
    fn jump_if_asked(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let t = terrain.tuning;
        if !self.within(self.pressed_at, t.jump_buffer)
            || self.drop_if_asked(terrain, trace)
            || self.let_go_if_asked(terrain, trace)
        {
            return;
        }
        let grounded = match &self.mode {
            _ if self.climbing => true,
            Mode::Air(_) => self.within(self.coyote_from, t.coyote_time),
            // Held between frames counts like a wedge: nothing may lock a player in.
            Mode::Surface(on) => on.walkable || on.u0 == 0.0 && self.is_pressed(),
            Mode::Wedge(_) => true,
            Mode::Crushed(_) => false,
        };
        match grounded {
            true => self.jump(terrain, trace),
            false => self.wall_jump_if_there(terrain, trace),
        }
    }

    /// Whether something happened at most a time span ago.
    pub(super) fn within(&self, since: Option<f64>, span: f64) -> bool {
        since.is_some_and(|since| self.time - since <= span)
    }

    fn jump(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let t = terrain.tuning;
        let mesh = self.ground(terrain);
        let (p, mut v) = (self.local_position(), self.local_velocity());
        v.y = v.y.max(0.0) + t.jump_speed;
        v = self.leap(v, 0.0, terrain);
        // In a corner the wall takes up what goes into it: its piece there may have been displaced, and tell nothing.
        let wall = self.wall_beside(mesh);
        let [first, second] = self.left_behind(terrain);
        if let Some(wall) = wall {
            let normal = |s: SegmentId| mesh.track(s).normal;
            v -= normal(wall) * normal(wall).dot(v).min(0.0);
            // In a crevice, which narrows upwards, that leads into the ground: there is no way to jump.
            if first.is_some_and(|ground| normal(ground).dot(v) < 0.0) {
                v = DVec2::ZERO;
            }
        }
        let (face, touching) = (self.face_ahead(v, mesh), [first, wall.or(second)]);
        self.fly(p, v, face, touching);
        // What is held takes hold of a ladder here, or again, only when the jump is over.
        if std::mem::take(&mut self.climbing) || self.on_ladder(terrain) {
            self.reach = Reach::AfterApex;
        }
        self.log(EventKind::Jumped, trace);
        self.rise(terrain);
    }

    /// Chooses the constant accelerations of the piece that starts now, and when they stop to hold.
    fn choose_law(&mut self, terrain: &Terrain) {
        let (t, control) = (terrain.tuning, self.control);
        if self.climbing {
            return self.choose_on_ladder(t);
        }
        let turns = self.reach == Reach::AfterApex;
        let slows = self.is_slowed_by_wall(terrain);
        let cut = self.braked_rise(t);
        let (mesh, crouched) = (self.ground(terrain), self.size == Size::Crouch);
        let carried = self.frame_accel();
        let limit = |from: f64, law: law::Law, speed: f64| {
            law.until
                .zip(law.time_left(speed))
                .map(|(until, left)| (from + left, until))
        };
        match &mut self.mode {
            Mode::Air(air) => {
                let run = air.lock.map_or(control.run, |lock| lock.run);
                let steer = |speed: f64| law::steer(speed, &Control { run, ..control }, t);
                if steer(air.v0.x).turns_at_once(air.v0.x, air.t0) {
                    air.v0.x = 0.0;
                }
                let (x, fall) = (
                    steer(air.v0.x),
                    law::rise_or_fall(air.v0.y, cut, &control, t),
                );
                let y = if turns {
                    fall.up_to_turn(air.v0.y)
                } else {
                    fall
                };
                air.accel = DVec2::new(x.accel, y.accel);
                air.limits = [limit(air.t0, x, air.v0.x), limit(air.t0, y, air.v0.y)];
            }
            Mode::Surface(on) if on.walkable => {
                // The wish counts along x; the parameter of ground steeper than 45 degrees along y.
                let x = if on.track.tangent.x < 0.0 { -1.0 } else { 1.0 };
                let footing = Footing::under(on.edge, on.segment, &on.track, mesh, terrain);
                let law = footing.law(on.u0 * x, &control, crouched, t);
                on.accel = law.accel * x;
                on.limit = limit(on.t0, law, on.u0 * x).map(|(at, until)| (at, until * x));
            }
            Mode::Surface(on) => match on.grip {
                Grip::None => on.choose_slide(&control, slows, cut, carried, t),
                _ => on.choose_climb(&control, t),
            },
            Mode::Wedge(_) | Mode::Crushed(_) => {}
        }
    }

    fn reach_limit(&mut self, trace: &mut Trace) {
        let now = self.time;
        self.rebase();
        match &mut self.mode {
            Mode::Air(air) => {
                for (limit, speed) in air.limits.iter().zip([&mut air.v0.x, &mut air.v0.y]) {
                    if let Some((_, until)) = limit.filter(|&(at, _)| at <= now) {
                        *speed = until;
                    }
                }
            }
            Mode::Surface(on) => on.u0 = on.limit.map_or(on.u0, |(_, until)| until),
            Mode::Wedge(_) | Mode::Crushed(_) => {}
        }
        self.log(EventKind::Limit, trace);
    }

    /// Finds the next event.
    pub(super) fn schedule(&mut self, terrain: &Terrain) {
        let mesh = self.ground(terrain);
        // What comes next in other frames is asked of the motion that begins now.
        self.follow(terrain);
        let found = match &self.mode {
            Mode::Air(air) => air.next(mesh),
            Mode::Surface(on) => on.next(mesh),
            Mode::Wedge(_) | Mode::Crushed(_) => None,
        };
        let found = self.sooner_if_clear(found, terrain);
        let found = self.sooner_if_grabs(found, terrain);
        let found = match self.mount {
            Some(mount) => self.sooner_if_mounts(&mount, found),
            None => found,
        };
        let found = self.sooner_if_cut(found);
        let own = self
            .sooner_if_unlocked(found)
            .map(|(at, what)| (at.max(self.time), what));
        self.next = match self.beside.is_empty() {
            true => own,
            false => self.first_of_all(self.sooner_if_changes(own, terrain), terrain),
        };
    }

    /// The last resort against a cycle of events: rest where the body is.
    pub(super) fn hold(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let (at, face) = (self.local_position(), self.face(&self.ground(terrain)));
        self.mode = Mode::Wedge(Wedge { at, face });
        (self.next, self.climbing) = (None, false);
        self.log(EventKind::Stuck, trace);
    }

    pub(super) fn log(&self, kind: EventKind, trace: &mut Trace) {
        trace.events.push(Event {
            time: self.time,
            kind,
        });
    }
}

impl Surface {
    /// No push against the wall that has stopped the body here.
    fn stand_against_wall(&mut self) {
        if self.u0 == 0.0 && self.accel * self.against > 0.0 {
            (self.accel, self.limit) = (0.0, None);
        }
        if self.sign() != 0.0 {
            self.against = 0.0;
        }
    }
}
