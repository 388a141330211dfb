//! The places of a body in the frames that do not carry it: in the mesh of the level while it rides, and in the mesh of every
//! moving solid that it is not on.
//!
//! Frames translate with piecewise constant acceleration, so in each of them the body is again a point on a quadratic among the
//! faces of a mesh at rest, and the code that finds crossings and hits in the level finds them there. Which face it is in
//! is kept as a discrete fact in every frame. Events there end no piece of the body's own motion, unless it is struck; and an
//! event of its own renews only what follows from it, so that a tick without events costs nothing.

use super::body::{Air, Body, Crushed, EventKind, Mode, Next, Size, SpawnError, Trace};
use super::contact::Contact;
use super::mover::{Mover, Piece, Ride};
use super::size::{clear_in_flight, free_face, free_face_at};
use super::terrain::{Ground, Terrain};
use super::vertex::{Bearing, JOINT_STEPS, Sector, sector};
use crate::geom::STEP;
use crate::mesh::{EdgeId, FaceId, Mesh, SegmentId};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// What rounding makes of a velocity that is worked out from others, relative to the sum of their sizes.
pub(super) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The place of a body in a frame that does not carry it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Beside {
    /// The frame; `None`: the level.
    pub(super) frame: Option<Ride>,
    /// The motion of the body in it, and its face there.
    pub(super) flight: Air,
    /// What presses on the body from this frame, while it is on a surface of another.
    pub(super) contact: Option<Contact>,
    /// The body climbs on a ladder: one-ways of this frame do not stop it.
    #[serde(default)]
    climbing: bool,
    /// The motion of the body in the world from which the flight was worked out; `None` if that is to be done.
    pub(super) of: Option<Piece>,
    /// The next event in this frame.
    pub(super) next: Option<(f64, Next)>,
}

impl Beside {
    /// At rest in a face, until [`Beside::follow`] says otherwise.
    pub(super) fn new(frame: Option<Ride>, at: DVec2, face: FaceId) -> Beside {
        Beside {
            frame,
            flight: Air::resting(at, face),
            contact: None,
            climbing: false,
            of: None,
            next: None,
        }
    }

    /// The moving solid; `None`: the level.
    pub(super) fn mover(&self) -> Option<u32> {
        self.frame.map(|ride| ride.mover)
    }

    /// The motion of the frame.
    pub(super) fn piece(&self) -> Piece {
        self.frame.map_or(Piece::default(), |ride| ride.piece)
    }

    /// The mesh of the frame, as the body meets it.
    pub(super) fn ground<'a>(&self, size: Size, terrain: &Terrain<'a>) -> Ground<'a> {
        let mesh = terrain.ground_under(self.mover(), size);
        mesh.climbed(self.climbing).with_ladder(false)
    }

    /// Takes up whether the body climbs.
    fn climb(&mut self, climbing: bool, size: Size, terrain: &Terrain) {
        if self.climbing != climbing {
            (self.climbing, self.of) = (climbing, None);
            let mesh = self.ground(size, terrain);
            self.contact = self.contact.filter(|c| mesh.blocks(c.edge));
        }
    }

    /// Takes up a motion of the body, if it or that of the frame is new.
    /// `grain`: what rounding may have made of the body's velocity.
    fn follow(&mut self, body: Piece, grain: f64, now: f64, size: Size, terrain: &Terrain) {
        if self.of == Some(body) {
            return;
        }
        let piece = self.piece();
        let seen = body.seen_from(&piece);
        let mesh = self.ground(size, terrain);
        let (from, to) = (self.flight.position(now), seen.offset(now));
        let air = &mut self.flight;
        air.face = moved(mesh, air.face, from, to);
        // Who has been beyond the border of a moving solid's small world comes back anywhere.
        let at_border = |e: EdgeId| mesh.left(mesh.sym(e)).is_none();
        if self.frame.is_some() && mesh.sides(air.face).into_iter().any(at_border) {
            air.face = free_face(mesh, to, DVec2::NEG_Y, DVec2::NEG_Y).unwrap_or(air.face);
        }
        (air.t0, air.p0, air.v0, air.accel) = (seen.t0, seen.p0, seen.v0, seen.accel);
        (air.since, air.limits) = (now - seen.t0, [None; 2]); // those belong to the body's own motion
        air.grain = grain + piece.rounding(now);
        let apart = |s| mesh.track(s).height(to, to, to).0.abs() > STEP;
        air.through = air.through.filter(|&s| !apart(s));
        air.touching = air.touching.map(|s| s.filter(|&s| !apart(s)));
        if self.contact.is_none() {
            self.turn_at_vertex(to, now, mesh);
        }
        self.of = Some(body);
        self.plan(now, size, terrain);
    }

    /// Exactly at a vertex a new motion may lead out of the face there: into the next one, or along an edge that is touched.
    fn turn_at_vertex(&mut self, at: DVec2, now: f64, mesh: Ground) {
        let air = &mut self.flight;
        let mut sides = mesh.sides(air.face).into_iter();
        let Some(spoke) = sides.find(|&e| mesh.point(mesh.origin(e)).metres() == at) else {
            return;
        };
        let touches = |&e: &EdgeId| mesh.facing(e).any(|s| air.touching.contains(&Some(s)));
        let ahead = match sector(mesh, spoke, Bearing::of(air.velocity(now), air.accel)) {
            Sector::Free(face) => Some(face),
            Sector::Solid(out, into) => {
                let along = [out, into].into_iter().find(touches);
                along.and_then(|e| mesh.left(e))
            }
        };
        air.face = ahead.unwrap_or(air.face);
    }

    /// From now on an edge presses.
    pub(super) fn press(&mut self, contact: Contact, mesh: Ground) {
        let face = mesh.left(contact.edge);
        self.flight.face = face.expect("free on the left of a blocking edge");
        let before = self.flight.touching.into_iter().flatten();
        let before = before.into_iter().find(|&s| s != contact.segment);
        self.flight.touching = [Some(contact.segment), before];
        (self.contact, self.of) = (Some(contact), None);
    }

    /// The face, and what presses, in the mesh of a size; `None` if the place is not free there, but for the `rounding` of the position.
    fn place(
        &self,
        now: f64,
        rounding: f64,
        size: Size,
        terrain: &Terrain,
    ) -> Option<(FaceId, Option<Contact>)> {
        let mesh = self.ground(size, terrain);
        let (p, v) = (self.flight.position(now), self.flight.velocity(now));
        let other = match size {
            Size::Stand => Size::Crouch,
            Size::Crouch => Size::Stand,
        };
        let again = |c: &Contact| c.again(p, self.ground(other, terrain), mesh);
        if let Some(contact) = self.contact.as_ref().and_then(again) {
            return Some((mesh.left(contact.edge)?, Some(contact)));
        }
        let bearing = Bearing::of(v, DVec2::NEG_Y);
        Some((free_face_at(mesh, p, bearing, rounding).ok()?, None))
    }

    /// Finds the next event in this frame. At the same time its own new piece comes first: a lift that stops under a ceiling
    /// crushes nobody.
    pub(super) fn plan(&mut self, now: f64, size: Size, terrain: &Terrain) {
        let mesh = self.ground(size, terrain);
        let found = match &self.contact {
            Some(contact) => contact.next(&self.flight, mesh),
            None => self.flight.next(mesh),
        };
        let found = found.filter(|&(_, what)| !self.is_border(what, mesh));
        let node = self.frame.and_then(|ride| ride.until);
        self.next = Next::node_before(node, found).map(|(at, what)| (at.max(now), what));
    }

    /// The border of a moving solid's own small world is nothing to meet.
    fn is_border(&self, what: Next, mesh: Ground) -> bool {
        matches!(what, Next::Hit(e, _) if self.frame.is_some() && mesh.left(mesh.sym(e)).is_none())
    }
}

/// The face of a place after an event: another one only if the body was set down, stepped up or corrected.
fn moved(mesh: Ground, face: FaceId, from: DVec2, to: DVec2) -> FaceId {
    if (to - from).abs().max_element() <= f64::from(2 * JOINT_STEPS) * STEP {
        return face;
    }
    cast(mesh, face, from, to)
        .or_else(|| free_face(mesh, to, DVec2::NEG_Y, DVec2::NEG_Y).ok())
        .unwrap_or(face)
}

/// The face at the end of a straight way through the free faces of a mesh; `None` if something is in the way.
fn cast(mesh: Ground, from: FaceId, start: DVec2, end: DVec2) -> Option<FaceId> {
    let mut way = Air {
        v0: end - start,
        ..Air::resting(start, from)
    };
    loop {
        let Some((at, edge)) = way.way_out(mesh).filter(|&(at, _)| at < 1.0) else {
            return Some(way.face);
        };
        if mesh.blocks(edge) {
            return None;
        }
        way.face = mesh.left(mesh.sym(edge))?;
        way.since = at;
    }
}

impl Next {
    /// A node of a path, or an event that comes before it.
    fn node_before(node: Option<f64>, event: Option<(f64, Next)>) -> Option<(f64, Next)> {
        match (node, event) {
            (Some(node), event) if event.is_none_or(|(at, _)| node <= at) => {
                Some((node, Next::Node))
            }
            (_, event) => event,
        }
    }
}

impl Body {
    /// The motion in the world that goes on until the next event of the body's own.
    pub fn motion(&self) -> Piece {
        let local = match &self.mode {
            Mode::Air(air) => Piece {
                t0: air.t0,
                p0: air.p0,
                v0: air.v0,
                accel: air.accel,
            },
            Mode::Surface(on) => Piece {
                t0: on.t0,
                p0: on.track.position(on.s0),
                v0: on.track.tangent * on.u0,
                accel: on.track.tangent * on.accel,
            },
            Mode::Wedge(_) | Mode::Crushed(_) => Piece {
                p0: self.local_position(),
                ..Piece::default()
            },
        };
        self.frame
            .map_or(local, |ride| local.carried_by(&ride.piece))
    }

    /// Finds the places of a new body in the frames of all moving solids.
    ///
    /// # Errors
    /// If it would be inside one of them.
    pub(super) fn find_places(&mut self, terrain: &Terrain) -> Result<(), SpawnError> {
        let (p, v) = (self.position(), self.velocity());
        self.beside.clear();
        self.regions_move = terrain.movers.iter().any(Mover::has_regions);
        for mover in 0..terrain.movers.len() as u32 {
            let ride = Ride::at(mover, self.time, terrain.movers);
            let at = p - ride.piece.offset(self.time);
            let v = v - ride.piece.velocity(self.time);
            let mesh = terrain.ground_under(Some(mover), self.size);
            let face = free_face(mesh, at, v, DVec2::NEG_Y)?;
            self.beside.push(Beside::new(Some(ride), at, face));
        }
        Ok(())
    }

    /// Takes up the present motion in all other frames.
    pub(super) fn follow(&mut self, terrain: &Terrain) {
        let (now, size, motion) = (self.time, self.size, self.motion());
        let grain = self.frame_piece().rounding(now) + ROUNDING * self.local_velocity().length();
        // At rest there is none, and yet a difference of two: accelerations are rounded too.
        let grain = grain.max(f64::MIN_POSITIVE);
        for beside in &mut self.beside {
            // One-ways of the level hold who climbs there, and only slides along something that moves.
            let climbs = self.climbing && (beside.frame.is_some() || self.ladder.is_some());
            beside.climb(climbs, size, terrain);
            beside.follow(motion, grain, now, size, terrain);
        }
    }

    /// The first of the body's own next event, a node of what carries it, and the events in all other frames.
    pub(super) fn first_of_all(
        &mut self,
        own: Option<(f64, Next)>,
        terrain: &Terrain,
    ) -> Option<(f64, Next)> {
        self.follow(terrain);
        let node = self.frame.and_then(|ride| ride.until);
        let mut first = Next::node_before(node, own);
        for (i, beside) in self.beside.iter().enumerate() {
            if let Some((at, _)) = beside.next
                && first.is_none_or(|(earliest, _)| at < earliest)
            {
                first = Some((at, Next::Beside(i as u32)));
            }
        }
        first.map(|(at, what)| (at.max(self.time), what))
    }

    /// An event in another frame.
    pub(super) fn handle_beside(&mut self, i: usize, terrain: &Terrain, trace: &mut Trace) {
        let (now, size) = (self.time, self.size);
        let beside = &mut self.beside[i];
        let mesh = beside.ground(size, terrain);
        match beside.next.take() {
            Some((_, Next::Cross(edge, since))) => {
                let beyond = mesh.left(mesh.sym(edge));
                beside.flight.face = beyond.expect("a free edge has a face on either side");
                beside.flight.since = since;
                let p = beside.flight.position(now);
                let touches = |&s: &SegmentId| mesh.track(s).height(p, p, p).0.abs() <= STEP;
                beside.flight.touching = beside.flight.touching.map(|s| s.filter(touches));
                trace.crossed += 1;
                beside.plan(now, size, terrain);
                return self.come_to_place(terrain, trace);
            }
            Some((_, Next::Hit(edge, since))) => {
                trace.touched += 1;
                beside.flight.since = since;
                match &self.mode {
                    Mode::Air(_) => self.hit_in_flight(i, edge, since, terrain, trace),
                    Mode::Surface(_) => self.struck(i, edge, terrain, trace),
                    Mode::Wedge(_) => self.struck_in_wedge(i, edge, terrain, trace),
                    Mode::Crushed(_) => {}
                }
            }
            Some((_, Next::Vertex)) => {
                trace.touched += 1;
                if self.slide_past(i, terrain, trace) {
                    return self.come_to_place(terrain, trace);
                }
            }
            Some((_, Next::Node)) => {
                trace.touched += 1;
                if self.take_up_node(i, terrain, trace) {
                    match self.regions_move {
                        _ if self.waits_for_room() => self.rebase(),
                        true => return self.come_to_place(terrain, trace),
                        false => return self.schedule(terrain),
                    }
                }
            }
            _ => {}
        }
        self.refresh(terrain, trace);
    }

    /// Writes a flight in the frame of another entry, and that in the frame of this one.
    pub(super) fn change_frame(&mut self, i: usize) {
        let beside = &mut self.beside[i];
        std::mem::swap(&mut self.frame, &mut beside.frame);
        if let Mode::Air(air) = &mut self.mode {
            std::mem::swap(air, &mut beside.flight);
            // The direction that a wall jump holds goes with the body.
            std::mem::swap(&mut air.lock, &mut beside.flight.lock);
        }
        (beside.contact, beside.of) = (None, None);
    }

    /// The frame of a body in the air: that of the ladder that it climbs, else the level.
    fn home(&self) -> Option<u32> {
        self.ladder.filter(|_| self.climbing)
    }

    /// Whether a body in the air is written in the frame that is its own.
    pub(super) fn is_at_home(&self) -> bool {
        self.carrier() == self.home() || !matches!(self.mode, Mode::Air(_))
    }

    /// A body in the air is written in the frame that is its own.
    pub(super) fn go_home(&mut self, terrain: &Terrain) {
        if self.is_at_home() {
            return;
        }
        let (t, home) = (self.time, self.piece_of(self.home()));
        let (p, v) = (
            self.position() - home.offset(t),
            self.velocity() - home.velocity(t),
        );
        // A velocity that only rounding tells from rest is rest.
        let frames = self.frame_piece().rounding(t) + home.rounding(t);
        let grain = frames + ROUNDING * self.local_velocity().length();
        let still = |c: f64| if c.abs() <= grain { 0.0 } else { c };
        let v = DVec2::new(still(v.x), still(v.y));
        let mut places = self.beside.iter();
        let home = places.position(|b| b.mover() == self.home());
        self.change_frame(home.expect("a body has a place in every frame"));
        let level = self.ground(terrain);
        if let Mode::Air(air) = &mut self.mode {
            let face = moved(level, air.face, air.position(t), p);
            // Before what it leaves in the level, and not behind it by the rounding of the way there.
            let before = |p: DVec2, s: SegmentId| {
                let track = level.track(s);
                let (height, ..) = track.height(p, p, p);
                match (-STEP..0.0).contains(&height) {
                    true => p - track.normal * height,
                    false => p,
                }
            };
            let p = air.touching.into_iter().flatten().fold(p, before);
            *air = Air {
                touching: air.touching,
                lock: air.lock,
                through: air.through,
                ..Air::resting(p, face)
            };
            (air.t0, air.v0) = (t, v);
        }
    }

    /// In flight at a blocking edge of another frame: what happens there happens as in the level. A touch changes nothing of the
    /// flight.
    fn hit_in_flight(
        &mut self,
        i: usize,
        edge: EdgeId,
        since: f64,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let of = self.beside[i].of;
        self.change_frame(i);
        let before = self.motion();
        self.hit(edge, since, terrain, trace);
        if matches!(self.mode, Mode::Air(_)) && self.motion() == before {
            self.change_frame(i);
            let beside = &mut self.beside[i];
            beside.of = of;
            beside.plan(self.time, self.size, terrain);
        }
    }

    /// The place of a rider in the level.
    pub(super) fn level_entry(&self) -> Option<&Beside> {
        self.beside.iter().find(|b| b.frame.is_none())
    }

    /// The place of a rider in the level after an edit: the face, what presses on him as far as it is still there, what he touches.
    pub(super) fn take_level_place(
        &mut self,
        face: FaceId,
        pressing: Option<SegmentId>,
        touching: [Option<SegmentId>; 2],
        ground: Ground,
    ) {
        let now = self.time;
        let Some(level) = self.beside.iter_mut().find(|b| b.frame.is_none()) else {
            return;
        };
        let at = level.flight.position(now);
        let contact = level.contact.zip(pressing);
        level.contact = contact.and_then(|(c, segment)| c.at(at, segment, ground, None));
        let beside = level.contact.and_then(|c| ground.left(c.edge));
        level.flight.face = beside.unwrap_or(face);
        level.flight.touching = touching;
        level.of = None;
    }

    /// The face of the level's mesh, of the body's size, that the body is in or beside, whatever carries it.
    pub fn level_face(&self, level: &Mesh) -> FaceId {
        self.level_entry()
            .map_or_else(|| self.face(level), |level| level.flight.face)
    }

    /// Whether nothing of another frame is in the way from where the body is to another place of its own frame.
    pub(super) fn is_clear_to(&self, place: DVec2, terrain: &Terrain) -> bool {
        let by = place - self.local_position();
        self.beside.iter().all(|b| {
            let from = b.flight.position(self.time);
            let mesh = b.ground(self.size, terrain);
            cast(mesh, b.flight.face, from, from + by).is_some()
        })
    }

    /// Whether no moving solid is where the body has been put.
    pub(super) fn is_free_beside(&self, terrain: &Terrain) -> bool {
        self.beside.iter().all(|b| {
            let (at, v) = self.seen_from(b);
            free_face(b.ground(self.size, terrain), at, v, DVec2::NEG_Y).is_ok()
        })
    }

    /// Whether a place in every other frame is free for another size too.
    pub(super) fn fits_beside(&self, size: Size, terrain: &Terrain) -> bool {
        let rounding = self.rounding();
        let fits = |b: &Beside| b.place(self.time, rounding, size, terrain).is_some();
        self.beside.iter().all(fits)
    }

    /// Takes the places in all other frames for a size that fits there.
    pub(super) fn take_places(&mut self, size: Size, terrain: &Terrain) {
        let (now, rounding) = (self.time, self.rounding());
        for beside in &mut self.beside {
            if let Some((face, contact)) = beside.place(now, rounding, size, terrain) {
                beside.flight.face = face;
                beside.flight.touching = [contact.map(|c| c.segment), None];
                (beside.contact, beside.of) = (contact, None);
            }
        }
    }

    /// When the body, which waits to stand up where its own frame has room, is clear of the solids of other frames too.
    pub(super) fn clear_beside(&self, until: f64, terrain: &Terrain) -> Option<f64> {
        let rounding = self.rounding();
        let blocked = |b: &&Beside| {
            let place = b.place(self.time, rounding, Size::Stand, terrain);
            place.is_none()
        };
        let clear = self.beside.iter().filter(blocked).map(|b| {
            let mesh = b.ground(Size::Stand, terrain);
            let clear = clear_in_flight(&b.flight, DVec2::ZERO, self.time, until, mesh);
            // Where rounding alone says that it is not, it is so after a step.
            match clear {
                Some(at) if at > self.time => at,
                Some(_) => b.flight.a_step_on(self.time),
                None => f64::INFINITY,
            }
        });
        clear
            .max_by(f64::total_cmp)
            .filter(|&at| at > self.time && at.is_finite())
    }

    /// Caught between two solids that close: stays here.
    pub(super) fn crush(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let face = self.level_face(terrain.mesh(self.size));
        let at = self.position();
        self.mode = Mode::Crushed(Crushed { at, face });
        (self.frame, self.climbing) = (None, false);
        self.beside.clear();
        self.meetings.clear();
        self.log(EventKind::Crushed, trace);
    }
}
