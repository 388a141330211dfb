//! Carried by a moving solid: its nodes, coming off it, going from one frame to another on foot.
//!
//! A rider's motion is written in the frame of what carries him, so he keeps no distance from it that could change. He comes off
//! where the solid falls away faster than he would fall, and where a node of its path takes it away from under him.

use super::beside::Beside;
use super::body::{Air, Body, EventKind, Mode, Surface, Trace};
use super::change::{Moment, flight};
use super::grip::Grip;
use super::joint::Joint;
use super::ladder::Reach;
use super::mover::{Piece, Ride};
use super::terrain::{Ground, Terrain};
use super::vertex::{Bearing, JOINT_STEPS, Sector, sector, segment_at, spokes};
use crate::geom::STEP;
use crate::mesh::{EdgeId, FaceId, SegmentId};
use crate::tune::Motion;
use glam::DVec2;

/// What rounding makes of a sum of products, relative to the largest of them.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Body {
    /// What carries the body begins another piece of its path. Where that takes it away from the body at once, the body flies on
    /// as fast as it was; else it is taken along.
    pub(super) fn ride_on(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let Some(old) = self.frame else {
            return;
        };
        let now = self.time;
        let new = Ride::at(old.mover, now, terrain.movers);
        self.rebase();
        self.log(EventKind::Node(old.mover), trace);
        trace.touched += 1;
        let (was, is) = (old.piece.velocity(now), new.piece.velocity(now));
        let leap = is - was;
        // The end of a piece that eases in or out and the start of the next agree but for rounding.
        let rounding = ROUNDING * (was.length() + is.length() + old.piece.accel.length() * now);
        if leap.length() <= rounding {
            self.frame = Some(new);
            return;
        }
        if is.length_squared() < was.length_squared() {
            self.lift = Some((now, was));
        }
        let up = match &self.mode {
            // Who holds on is taken along, wherever that goes.
            Mode::Surface(on) if on.grip != Grip::None => DVec2::ZERO,
            _ if self.climbs(self.carrier()) => DVec2::ZERO,
            Mode::Surface(on) => on.track.normal,
            _ => DVec2::Y,
        };
        if up.dot(leap) < -rounding {
            self.come_off(terrain, trace);
            let entry = self
                .beside
                .iter_mut()
                .find(|b| b.mover() == Some(old.mover));
            if let Some(entry) = entry {
                (entry.frame, entry.of) = (Some(new), None);
            }
            return;
        }
        self.frame = Some(new);
        if !self.climbs(Some(old.mover))
            && let Mode::Surface(on) = &mut self.mode
            && !on.walkable
            && on.grip == Grip::None
        {
            on.u0 -= on.track.tangent.dot(leap);
        }
    }

    /// Tells of a moving solid that minds it that the body has come to stand on it, or is on it no longer.
    pub(super) fn note_ride(&mut self, terrain: &Terrain, trace: &mut Trace) {
        if terrain.movers.is_empty() {
            return;
        }
        let mover = match &self.mode {
            _ if self.climbing => self.ladder,
            Mode::Surface(on) if !on.walkable && on.grip == Grip::None => None,
            Mode::Air(_) | Mode::Crushed(_) => None,
            Mode::Surface(_) | Mode::Wedge(_) => self.carrier(),
        };
        let now = mover.filter(|&mover| terrain.minds_riders(mover));
        let before = std::mem::replace(&mut self.rides, now);
        if before == now {
            return;
        }
        if let Some(old) = before {
            self.log(EventKind::Dismounted(old), trace);
        }
        if let Some(new) = now {
            self.log(EventKind::Mounted(new), trace);
        }
    }

    /// Off what carries the body, with the velocity that it has.
    fn come_off(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let mesh = self.ground(terrain);
        let (face, v) = (self.face(&mesh), self.local_velocity());
        let at = match &self.mode {
            Mode::Surface(on) => on.take_off_point(self.time, mesh),
            _ => self.local_position(),
        };
        let kind = match self.supported() {
            true => EventKind::Left,
            false => EventKind::Parted,
        };
        if kind == EventKind::Left {
            self.coyote_from = Some(self.time);
        }
        self.fly(at, v, face, [self.segment(), None]);
        self.log(kind, trace);
        self.go_home(terrain);
    }

    /// Off ground that falls away faster than the body would.
    pub(super) fn come_off_if_dropped(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let Some(ride) = self.frame.filter(|ride| ride.piece.accel != DVec2::ZERO) else {
            return;
        };
        let normal = match &self.mode {
            Mode::Surface(on) if on.walkable => on.track.normal,
            Mode::Wedge(_) => DVec2::Y,
            _ => return,
        };
        let drops = self.drops_from(normal, ride.piece.accel, terrain.tuning);
        if drops && !self.is_pinned(normal) {
            self.come_off(terrain, trace);
        }
    }

    /// Whether ground with this normal and acceleration falls away faster than the body would. In flight the laws of the fall and
    /// of the stick hold, so those must lead away too, lest the body comes back at once.
    pub(super) fn drops_from(&self, normal: DVec2, accel: DVec2, t: &Motion) -> bool {
        self.drops_at(normal, accel, &self.now(), t)
    }

    /// The same at a moment.
    pub(super) fn drops_at(
        &self,
        normal: DVec2,
        accel: DVec2,
        moment: &Moment,
        t: &Motion,
    ) -> bool {
        let (x, y) = flight(self, moment, t);
        let flight = DVec2::new(x.accel, y.accel);
        let away = |x: f64, y: f64| normal.dot(DVec2::new(x, y) - accel) > 0.0;
        away(0.0, -t.gravity) && away(0.0, flight.y) && away(flight.x, flight.y)
    }

    /// The acceleration that the body would have in the air, m/s^2.
    pub(super) fn flight_accel(&self, t: &Motion) -> DVec2 {
        let (x, y) = flight(self, &self.now(), t);
        DVec2::new(x.accel, y.accel)
    }

    /// The motion of what carries the body: rest for the level.
    pub(super) fn frame_piece(&self) -> Piece {
        self.frame.map(|ride| ride.piece).unwrap_or_default()
    }

    /// The motion of a frame: rest for the level.
    pub(super) fn piece_of(&self, mover: Option<u32>) -> Piece {
        if mover == self.carrier() {
            return self.frame_piece();
        }
        let mut others = self.beside.iter();
        let entry = others.find(|b| mover.is_some() && b.mover() == mover);
        entry.map(Beside::piece).unwrap_or_default()
    }

    /// The acceleration of what carries the body, m/s^2.
    pub(super) fn frame_accel(&self) -> DVec2 {
        self.frame_piece().accel
    }

    /// The velocity that a jump gets from what carries the body beyond the present one: what it had before it slowed down, for
    /// as long as that is remembered.
    pub(super) fn remembered(&self, terrain: &Terrain) -> DVec2 {
        let within = |at: f64| self.time - at <= terrain.tuning.lift_memory;
        match (self.frame, self.lift) {
            (Some(ride), Some((at, had))) if within(at) => had - ride.piece.velocity(self.time),
            _ => DVec2::ZERO,
        }
    }

    /// From a place in the present frame to a surface of another, whose frame becomes that of the body.
    pub(super) fn board(&mut self, i: usize, surface: Surface, terrain: &Terrain) {
        let (p, v) = (self.local_position(), self.local_velocity());
        let face = self.face(&self.ground(terrain));
        let touching = [self.segment(), None];
        let left = Air {
            t0: self.time,
            v0: v,
            touching,
            ..Air::resting(p, face)
        };
        self.change_frame(i);
        self.beside[i].flight = left;
        self.mode = Mode::Surface(surface);
        self.keep_to_edge(terrain);
        if self.supported() {
            (self.rise, self.coyote_from) = (None, None);
            if std::mem::take(&mut self.climbing) {
                self.reach = Reach::Landed;
            }
        }
        (self.lift, self.off_wall) = (None, None);
    }

    /// A walker at the end of the ground: onto ground of another frame that goes on there. Gaps,
    /// rises and drops of at most [`JOINT_STEPS`] are joints, as in one mesh. The level comes first, then the others in order.
    pub(super) fn walk_aboard(
        &mut self,
        joint: &Joint,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let from = self.ground(terrain);
        let before = joint.track.tangent * joint.sign;
        let dx = before.x.signum();
        let mut order: Vec<usize> = (0..self.beside.len()).collect();
        order.sort_by_key(|&i| self.beside[i].mover());
        for i in order {
            let beside = &self.beside[i];
            let mesh = beside.ground(self.size, terrain);
            let (q, w) = self.seen_from(beside);
            let Some((edge, segment)) = ground_near(mesh, beside.flight.face, q, dx) else {
                continue;
            };
            let track = mesh.track(segment);
            let sign = (dx * track.tangent.x).signum();
            let bends_away = track.normal.dot(before) > ROUNDING;
            let follows = !bends_away || {
                let (after, length) = (mesh.heading(segment, &track, sign), mesh.length(segment));
                joint.holds_onto(after, length, from, terrain.tuning)
            };
            let u = before.dot(w);
            if self.parts_from(beside, track.normal) || u < 0.0 || !follows {
                continue;
            }
            let (place, s) = ((segment, track, edge), track.parameter(q));
            let surface = Surface::new(self.time, place, s, u * sign, true);
            let mover = beside.mover();
            let v = track.tangent * (u * sign) + beside.piece().velocity(self.time)
                - self.frame_piece().velocity(self.time);
            let bearing = Bearing {
                d: v,
                then: DVec2::NEG_Y,
            };
            let left = sector(from, joint.spoke(joint.next, from), bearing);
            self.board(i, surface, terrain);
            if let Sector::Free(face) = left {
                // Past the end of the old ground.
                let old = &mut self.beside[i].flight;
                (old.face, old.touching) = (face, [None; 2]);
            }
            self.log(EventKind::Boarded(mover), trace);
            return true;
        }
        false
    }

    /// Whether two frames part where their grounds meet.
    fn parts_from(&self, other: &Beside, normal: DVec2) -> bool {
        let mine = self.frame_piece().velocity(self.time);
        let apart = mine - other.piece().velocity(self.time);
        normal.dot(apart) > ROUNDING * apart.length()
    }

    /// Position and velocity in another frame.
    pub(super) fn seen_from(&self, other: &Beside) -> (DVec2, DVec2) {
        let piece = other.piece();
        (
            self.position() - piece.offset(self.time),
            self.velocity() - piece.velocity(self.time),
        )
    }

    /// A walker at a lip of another frame, at most [`JOINT_STEPS`] high: passes over it, once, on the ground that he has. True if
    /// there is one.
    pub(super) fn passes_lip(&mut self, i: usize, lip: SegmentId, terrain: &Terrain) -> bool {
        let beside = &self.beside[i];
        if beside.flight.touching.contains(&Some(lip)) {
            return false;
        }
        let mesh = beside.ground(self.size, terrain);
        let (q, w) = self.seen_from(beside);
        let goes = if w.x != 0.0 {
            w.x
        } else {
            beside.flight.accel.x
        };
        if goes == 0.0 {
            return false;
        }
        let Some((edge, segment)) = ground_near(mesh, beside.flight.face, q, goes.signum()) else {
            return false;
        };
        let Some(face) = mesh.left(edge).filter(|&f| f != beside.flight.face) else {
            return false;
        };
        let (now, size) = (self.time, self.size);
        let beside = &mut self.beside[i];
        beside.flight.face = face;
        beside.flight.touching = [Some(segment), Some(lip)];
        beside.plan(now, size, terrain);
        true
    }
}

/// Walkable ground about a face that goes on towards `dx` from a position at most [`JOINT_STEPS`] above or below it: the edge and its
/// feature edge. The nearest in height.
pub(super) fn ground_near(
    mesh: Ground,
    face: FaceId,
    q: DVec2,
    dx: f64,
) -> Option<(EdgeId, SegmentId)> {
    let reach = f64::from(JOINT_STEPS) * STEP;
    let about = mesh.sides(face).into_iter();
    let edges = about.flat_map(|side| spokes(mesh, mesh.origin(side)));
    let sides = edges.flat_map(|e| [e, mesh.sym(e)]);
    let found = sides.filter(|&e| mesh.blocks(e)).filter_map(|e| {
        let segment = segment_at(mesh, e, |_| false)?;
        if !mesh.walkable(segment) {
            return None;
        }
        let track = mesh.track(segment);
        let ends = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres().x * dx);
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let height = track.normal.dot(q - track.position(track.parameter(q)));
        let goes_on = from - reach <= q.x * dx && q.x * dx + reach < to;
        (goes_on && height.abs() <= reach).then_some((height.abs(), e, segment))
    });
    let rank = |s: SegmentId| (mesh.segment(s).feature, mesh.segment(s).source);
    found
        .min_by(|a, b| a.0.total_cmp(&b.0).then_with(|| rank(a.2).cmp(&rank(b.2))))
        .map(|(_, edge, segment)| (edge, segment))
}
