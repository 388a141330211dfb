//! Contacts: what presses on a body that is on a surface from another frame, and what that leaves of its freedom.
//!
//! The body keeps to its surface, and each contact bounds its speed along it from one side: with the normal n of the contact and
//! the tangent t of the surface, n . (t u + v_surface - v_contact) >= 0. While a bound is met the motion along the surface is that of
//! the bound, a quadratic again. It ends when the body's own law would lead it away, or when it has slid past the end of the edge
//! that presses. Where the bounds leave no speed, the body is crushed, at that very time.

use super::beside::{Beside, ROUNDING};
use super::body::{Air, Body, EventKind, Mode, Next, Surface, Trace};
use super::change::Times;
use super::edit::again;
use super::joint::Onward;
use super::mover::Piece;
use super::roots::exit;
use super::size::piece_at;
use super::terrain::{Ground, Terrain};
use super::track::{Axis, Track};
use super::vertex::{JOINT_STEPS, segment_at};
use crate::geom::{Point, STEP};
use crate::mesh::{EdgeId, SegmentId};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// An edge of another frame that presses on a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// The feature edge.
    pub segment: SegmentId,
    /// Its road.
    pub track: Track,
    /// The mesh edge where the body is, with the free face on its left.
    pub edge: EdgeId,
}

impl Contact {
    /// When the body, which slides along the contact, reaches one of the ends of its mesh edge.
    pub(super) fn next(&self, flight: &Air, mesh: Ground) -> Option<(f64, Next)> {
        let along = |p: DVec2| match self.track.axis {
            Axis::X => p.x,
            Axis::Y => p.y,
        };
        let (s, u, a) = (along(flight.p0), along(flight.v0), along(flight.accel));
        let ends = [mesh.origin(self.edge), mesh.dest(self.edge)]
            .map(|v| self.track.parameter_of(mesh.point(v)));
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let down = exit(s - low, u, 0.5 * a, flight.since);
        let up = exit(high - s, -u, -0.5 * a, flight.since);
        let first = down.into_iter().chain(up).min_by(f64::total_cmp)?;
        Some((flight.t0 + first, Next::Vertex))
    }
}

impl Contact {
    /// The same contact in the mesh of another size, if its feature edge is there too and free at a position.
    pub(super) fn again(&self, at: DVec2, old: Ground, new: Ground) -> Option<Contact> {
        let segment = again(new, old.segment(self.segment))?;
        let piece = [old.origin(self.edge), old.dest(self.edge)].map(|v| old.point(v));
        self.at(at, segment, new, Some(piece))
    }

    /// How far a position is past the ends of the mesh edge, m; not positive between them.
    fn passed(&self, at: DVec2, mesh: Ground) -> f64 {
        let ends = [mesh.origin(self.edge), mesh.dest(self.edge)];
        self.track.past(at, ends.map(|v| mesh.point(v)))
    }

    /// The same contact on the piece of a feature edge at a position, if that is free; `was` are the ends of its piece so far.
    pub(super) fn at(
        &self,
        at: DVec2,
        segment: SegmentId,
        mesh: Ground,
        was: Option<[Point; 2]>,
    ) -> Option<Contact> {
        let edge = piece_at(mesh, segment, self.track.parameter(at), &self.track, was)?;
        Some(Contact {
            segment,
            edge,
            ..*self
        })
    }
}

/// The bound that a contact sets to the speed along a surface.
#[derive(Clone, Copy, Debug)]
struct Bound {
    /// Which entry of the body's places it belongs to.
    entry: usize,
    /// 1: no slower than `speed`; -1: no faster; 0: it stands across the surface and bounds nothing, or everything.
    side: f64,
    speed: f64,
    accel: f64,
    /// It stands across the surface and closes in.
    closes: bool,
    /// How fast it moves, as what carries the body sees it, m/s.
    moves: f64,
    /// What rounding may have made of `speed`, that of the time of an event included.
    rounding: f64,
    /// The same of `accel`.
    accel_rounding: f64,
}

impl Bound {
    /// Of a contact with normal `n` that moves as `piece`, for a body that is carried by `mine` on a road with tangent `t`.
    /// `parallel`: its edge is parallel to the road, and where it closes in it is all along that.
    fn new(
        entry: usize,
        n: DVec2,
        t: DVec2,
        parallel: bool,
        frames: [Piece; 2],
        now: f64,
    ) -> Bound {
        let [piece, mine] = frames;
        let closing = n.dot(piece.velocity(now) - mine.velocity(now));
        let closing_accel = n.dot(piece.accel - mine.accel);
        let speeds = piece.rounding(now) + mine.rounding(now);
        let closing = if closing.abs() <= speeds {
            0.0
        } else {
            closing
        };
        let closes = closing > 0.0 || closing == 0.0 && closing_accel > 0.0;
        let lever = match parallel && closes {
            true => 0.0,
            false => n.dot(t),
        };
        let share = |size: f64| ROUNDING * size / lever.abs();
        let accels = piece.accel.length() + mine.accel.length();
        let accel = closing_accel / lever;
        Bound {
            entry,
            side: if lever == 0.0 { 0.0 } else { lever.signum() },
            speed: closing / lever,
            accel,
            closes: lever == 0.0 && closes,
            moves: (piece.velocity(now) - mine.velocity(now)).length(),
            rounding: share(piece.sizes(now) + mine.sizes(now)) + f64::EPSILON * now * accel.abs(),
            accel_rounding: share(accels),
        }
    }

    /// Whether a speed is that of the bound, as rounding goes: then the contact is closed.
    fn is_met(&self, u: f64) -> bool {
        self.side != 0.0 && (u - self.speed).abs() <= self.rounding + ROUNDING * u.abs()
    }

    /// Whether it is, but for what the acceleration `accel` makes of it in a unit in the last place of the time: an open contact that
    /// would close again at this very time is closed.
    fn is_closed(&self, u: f64, accel: f64, now: f64) -> bool {
        let closes = (accel - self.accel) * self.side < 0.0;
        let drift = f64::EPSILON * now * (accel - self.accel).abs();
        self.is_met(u) || closes && self.side != 0.0 && (u - self.speed).abs() <= drift
    }

    /// Whether a speed is beyond the bound, by more than rounding.
    fn forbids(&self, u: f64) -> bool {
        (u - self.speed) * self.side < 0.0 && !self.is_met(u)
    }

    /// Whether it drives the body along faster than `limit`, and than it moves itself: a squeeze that nobody gets out of.
    fn crushes(&self, u: f64, limit: f64) -> bool {
        let excess = u.abs() - limit.max(self.moves);
        let grows = u * self.accel > 0.0;
        let drives = self.is_met(u) && u * self.side > 0.0;
        drives && (excess > self.rounding || grows && excess >= -self.rounding)
    }

    /// Whether an acceleration leads away from the closed contact, by more than rounding.
    fn opens(&self, accel: f64) -> bool {
        (accel - self.accel) * self.side > self.accel_rounding + ROUNDING * accel.abs()
    }
}

/// What the bounds say about a speed.
enum Verdict {
    /// It is allowed, or this one is next to it.
    Speed(f64),
    /// There is none.
    Crushed,
}

/// The speed nearest to `u` within the bounds. Differences that rounding explains are none: a speed that meets a bound stays as
/// it is, for the law that holds from it on may begin exactly there.
fn allowed(bounds: &[Bound], u: f64) -> Verdict {
    let of = |side: f64| bounds.iter().filter(move |b| b.side == side);
    let rank = |b: &&Bound| (b.speed * b.side, b.rounding);
    let tightest = |side: f64| {
        let by =
            |a: &&Bound, b: &&Bound| rank(a).partial_cmp(&rank(b)).expect("no NaN in a motion");
        of(side).max_by(by)
    };
    let (low, high) = (tightest(1.0), tightest(-1.0));
    let shut = low
        .zip(high)
        .is_some_and(|(low, high)| low.speed - high.speed > low.rounding + high.rounding);
    if shut || bounds.iter().any(|b| b.closes) {
        return Verdict::Crushed;
    }
    let rests = |b: &&Bound| b.speed == 0.0 && b.is_met(u);
    let bound = low.into_iter().chain(high);
    let bound = bound
        .clone()
        .find(|b| b.forbids(u))
        .or(bound.clone().find(rests));
    Verdict::Speed(bound.map_or(u, |b| b.speed))
}

impl Body {
    /// Whether another frame presses on the body.
    pub(super) fn is_pressed(&self) -> bool {
        self.beside.iter().any(|b| b.contact.is_some())
    }

    /// Whether another frame presses the body onto a surface with this normal. Then nothing pulls it off: it keeps to both, as it
    /// does in a wedge, until the contact opens.
    pub(super) fn is_pinned(&self, normal: DVec2) -> bool {
        let pins = |b: &Beside| b.contact.is_some_and(|c| c.track.normal.dot(normal) < 0.0);
        self.beside.iter().any(pins)
    }

    /// The moving solid that pushes the body along its surface, if one does.
    pub fn pushed_by(&self) -> Option<u32> {
        let pushes = |b: &&Beside| b.contact.is_some() && b.frame.is_some();
        self.beside.iter().find(pushes).and_then(Beside::mover)
    }

    /// What goes on into a body at rest here: the contact of another frame, or the edge of it that the body has drawn away from
    /// but not yet come apart from.
    fn driving(&self, beside: &Beside, terrain: &Terrain) -> Option<Contact> {
        let now = self.time;
        let segment = beside.contact.map(|c| c.segment);
        let segment = segment.or(beside.flight.touching[0])?;
        let mine = self.frame_piece();
        let closing = beside.piece().velocity(now) - mine.velocity(now);
        self.at_hand(beside, segment, terrain)
            .filter(|c| c.track.normal.dot(closing) > 0.0)
    }

    /// An edge of another frame that the body has not yet come apart from, as what would press on it.
    pub(super) fn at_hand(
        &self,
        beside: &Beside,
        segment: SegmentId,
        terrain: &Terrain,
    ) -> Option<Contact> {
        let mesh = beside.ground(self.size, terrain);
        let (track, (q, _)) = (mesh.track(segment), self.seen_from(beside));
        if track.height(q, q, q).0.abs() > STEP {
            return None;
        }
        let edge = piece_at(mesh, segment, track.parameter(q), &track, None)?;
        Some(Contact {
            segment,
            track,
            edge,
        })
    }

    /// Whether the body, on a surface, runs into edges of other frames that are within a step of it, against what it is on or
    /// what presses on it: all of them decide at once. One after the other they would throw it to and fro, for ever at one time.
    pub(super) fn meet_at_once(&mut self, terrain: &Terrain, trace: &mut Trace) {
        for i in 0..self.beside.len() {
            if let Some(contact) = self.runs_into(i, terrain) {
                trace.touched += 1;
                match self.beside[i].contact {
                    None => self.struck(i, contact.edge, terrain, trace),
                    Some(_) => self.press_in_corner(i, contact, terrain, trace),
                }
                self.press_speed(terrain, trace);
            }
        }
    }

    /// The edge of another frame that the body runs into so, if there is one.
    pub(super) fn runs_into(&self, i: usize, terrain: &Terrain) -> Option<Contact> {
        let (Mode::Surface(on), Some(beside)) = (&self.mode, self.beside.get(i)) else {
            return None;
        };
        let (_, w) = self.seen_from(beside);
        let rounding = beside.piece().rounding(self.time) + ROUNDING * w.length();
        let pressing = self.beside.iter().filter_map(|b| b.contact);
        let against = |n: DVec2| {
            n.dot(on.track.normal) < 0.0 || pressing.clone().any(|c| n.dot(c.track.normal) < 0.0)
        };
        let leads_into = |c: &Contact| {
            let n = c.track.normal;
            let pressing = beside.contact.is_some_and(|old| old.segment == c.segment);
            n.dot(w) < -rounding && !pressing && against(n)
        };
        let mesh = beside.ground(self.size, terrain);
        let sides = mesh.sides(beside.flight.face).into_iter();
        let around = sides.filter(|&e| mesh.blocks(e));
        let around = around.filter_map(|e| segment_at(mesh, e, |_| false));
        let touched = beside.flight.touching.into_iter().flatten().chain(around);
        let mut touched = touched.filter_map(|s| self.at_hand(beside, s, terrain));
        touched.find(leads_into)
    }

    /// Whether something of another frame would strike the body at once if it came to rest here.
    pub(super) fn is_driven(&self, terrain: &Terrain) -> bool {
        let driven = |b: &Beside| self.driving(b, terrain).is_some();
        self.beside.iter().any(driven)
    }

    /// At a joint where the body would stop: what drives it there presses on it again, though the body would run ahead.
    pub(super) fn is_pressed_at_joint(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        for i in 0..self.beside.len() {
            let beside = &self.beside[i];
            if beside.contact.is_none()
                && let Some(contact) = self.driving(beside, terrain)
            {
                let beside = &mut self.beside[i];
                (beside.contact, beside.of) = (Some(contact), None);
                trace.touched += 1;
            }
        }
        self.is_pressed()
    }

    /// The bounds of all contacts for a road in the present frame.
    fn bounds(&self, segment: SegmentId, track: &Track, now: f64, terrain: &Terrain) -> Vec<Bound> {
        let mine = self.frame_piece();
        let length = self.ground(terrain).length(segment);
        let entries = self.beside.iter().enumerate();
        let bound = |(i, b): (usize, &Beside)| {
            let contact = b.contact?;
            let (n, t) = (contact.track.normal, track.tangent);
            // What rounding has turned out of parallel, by less than the width of a joint over the shorter of both, is parallel.
            let shorter = length.min(b.ground(self.size, terrain).length(contact.segment));
            let parallel = n.dot(t).abs() * shorter <= f64::from(JOINT_STEPS) * STEP;
            Some(Bound::new(i, n, t, parallel, [b.piece(), mine], now))
        };
        entries.filter_map(bound).collect()
    }

    /// A contact on the same side as the surface, parallel to it, that overtakes it: from now on the body is on that. True if there
    /// is one.
    fn is_overtaken(&mut self, bounds: &[Bound], terrain: &Terrain, trace: &mut Trace) -> bool {
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        let overtakes = |b: &&Bound| {
            let contact = self.beside[b.entry].contact;
            b.closes && contact.is_some_and(|c| c.track.normal.dot(on.track.normal) > 0.0)
        };
        let overtaking = bounds.iter().find(overtakes).map(|b| b.entry);
        if let Some(i) = overtaking {
            self.be_taken_over(i, terrain, trace);
        }
        overtaking.is_some()
    }

    /// From now on the body is on what presses on it.
    pub(super) fn be_taken_over(&mut self, i: usize, terrain: &Terrain, trace: &mut Trace) {
        let beside = &self.beside[i];
        let Some(contact) = beside.contact else {
            return;
        };
        let (mesh, (q, w)) = (beside.ground(self.size, terrain), self.seen_from(beside));
        let (track, mover) = (contact.track, beside.mover());
        let walks = mesh.walkable(contact.segment);
        let place = (contact.segment, track, contact.edge);
        let (s, u) = (track.parameter(q), track.tangent.dot(w));
        let into = (-track.normal.dot(w)).max(0.0);
        let kind = match (self.supported(), walks) {
            (true, true) => EventKind::Boarded(mover),
            (_, true) => EventKind::Landed(into),
            _ => EventKind::Hit(into),
        };
        self.board(i, Surface::new(self.time, place, s, u, walks), terrain);
        self.log(kind, trace);
    }

    /// Before the law is chosen: the speed that the contacts allow. Walled up in the direction of the push, the body is pressed
    /// into the joint there, which decides.
    pub(super) fn press_speed(&mut self, terrain: &Terrain, trace: &mut Trace) {
        if !self.is_pressed() {
            return;
        }
        self.release_distant(terrain);
        let Mode::Surface(on) = &self.mode else {
            return self.release_all();
        };
        let bounds = self.bounds(on.segment, &on.track, self.time, terrain);
        let limit = terrain.tuning.squeeze_speed;
        match allowed(&bounds, on.speed(self.time)) {
            // Each frame overtakes another one at most once.
            _ if self.is_overtaken(&bounds, terrain, trace) => self.press_speed(terrain, trace),
            Verdict::Crushed => self.crush(terrain, trace),
            Verdict::Speed(u) if bounds.iter().any(|b| b.crushes(u, limit)) => {
                self.crush(terrain, trace)
            }
            Verdict::Speed(u) => {
                self.rebase();
                if let Mode::Surface(on) = &mut self.mode {
                    on.u0 = u;
                    if u * on.against > 0.0 {
                        on.against = 0.0;
                    }
                }
            }
        }
    }

    /// After the law is chosen: the acceleration that the contacts allow; those that the body draws away from are let go.
    pub(super) fn press_accel(&mut self, terrain: &Terrain, trace: &mut Trace) {
        if !self.is_pressed() {
            return;
        }
        let Mode::Surface(on) = &self.mode else {
            return;
        };
        let (u, wish, now) = (on.u0, on.accel, self.time);
        let bounds = self.bounds(on.segment, &on.track, self.time, terrain);
        let binds = |b: &&Bound| b.is_closed(u, wish, now);
        let end = |side: f64| {
            bounds
                .iter()
                .filter(binds)
                .filter(move |b| b.side == side)
                .map(|b| b.accel)
        };
        let low = end(1.0).fold(f64::NEG_INFINITY, f64::max);
        let high = end(-1.0).fold(f64::INFINITY, f64::min);
        if low > high && low - high > ROUNDING * (low.abs() + high.abs()) {
            return self.crush(terrain, trace);
        }
        let accel = wish.min(high).max(low);
        let drifts = self.climbing && self.drift().accel != DVec2::ZERO;
        if let Mode::Surface(on) = &mut self.mode
            && accel != wish
        {
            on.accel = accel;
            // A wish that drifts, as on a ladder beside what speeds up, is no mark to come to.
            let fixed = on.limit.filter(|_| !drifts);
            let marks = [fixed.map_or(0.0, |(_, until)| until), 0.0];
            let rounding = bounds.iter().map(|b| b.rounding).fold(0.0, f64::max);
            if on.u0 * accel < 0.0 && on.u0.abs() <= rounding {
                on.u0 = 0.0; // no turn to wait for
            }
            let time = |mark: f64| (on.t0 + (mark - on.u0) / accel, mark);
            let ahead = marks
                .into_iter()
                .filter(|mark| accel != 0.0 && (mark - on.u0) * accel.signum() > rounding);
            on.limit = ahead.map(time).min_by(|a, b| a.0.total_cmp(&b.0));
            if accel * on.against > 0.0 {
                on.against = 0.0;
            }
        }
        for b in &bounds {
            if !b.is_closed(u, wish, now) || b.opens(accel) {
                self.release(b.entry);
            }
        }
    }

    /// Whether what presses on the body squeezes it, at a time of its piece, faster than it bears.
    pub(super) fn is_squeezed(&self, at: f64, terrain: &Terrain) -> bool {
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        let (u, limit) = (on.speed(at), terrain.tuning.squeeze_speed);
        let bounds = self.bounds(on.segment, &on.track, at, terrain);
        bounds.iter().any(|b| b.crushes(u, limit))
    }

    /// When that may begin.
    pub(super) fn squeezing_times(&self, times: &mut Times, terrain: &Terrain) {
        let Mode::Surface(on) = &self.mode else {
            return;
        };
        let (now, limit) = (self.time, terrain.tuning.squeeze_speed);
        let u = on.speed(now);
        let slack = f64::EPSILON * now.abs() * on.accel.abs() + ROUNDING * limit;
        times.linear(now, u, on.accel, &[limit, -limit], slack);
        let mine = self.frame_piece();
        for pressing in self.beside.iter().filter(|b| b.contact.is_some()) {
            let w = pressing.piece().velocity(now) - mine.velocity(now);
            let a = pressing.piece().accel - mine.accel;
            let [c, b] = [u * u - w.dot(w), 2.0 * (u * on.accel - w.dot(a))];
            times.quadratic(now, c, b, on.accel * on.accel - a.dot(a));
        }
    }

    /// A contact is no more: a free flight in that frame, not yet apart from it.
    fn release(&mut self, entry: usize) {
        let beside = &mut self.beside[entry];
        (beside.contact, beside.of) = (None, None);
    }

    /// Those from which the body has been moved away: set down, stepped up. Where that was along the feature edge, the piece of
    /// it there presses.
    fn release_distant(&mut self, terrain: &Terrain) {
        for entry in 0..self.beside.len() {
            let beside = &self.beside[entry];
            let Some(contact) = beside.contact else {
                continue;
            };
            let (mesh, (q, _)) = (beside.ground(self.size, terrain), self.seen_from(beside));
            let width = f64::from(JOINT_STEPS) * STEP;
            let (height, passed) = (contact.track.height(q, q, q).0, contact.passed(q, mesh));
            // Behind it, though, one has not been moved away but driven: there it presses all the more.
            if height > width || passed > width {
                let there = contact.at(q, contact.segment, mesh, None);
                self.release(entry);
                if let Some(there) = there.filter(|_| height.abs() <= width) {
                    self.beside[entry].press(there, mesh);
                }
            }
        }
    }

    fn release_all(&mut self) {
        for entry in 0..self.beside.len() {
            if self.beside[entry].contact.is_some() {
                self.release(entry);
            }
        }
    }

    /// Whether a contact pushes in a direction along the present surface, and is not only leant on.
    pub(super) fn presses_on(&self, direction: DVec2, terrain: &Terrain) -> bool {
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        let ahead = on.track.tangent.dot(direction);
        let bounds = self.bounds(on.segment, &on.track, self.time, terrain);
        bounds.iter().any(|b| b.side * ahead > 0.0)
    }

    /// At a joint, pressed: whether the contacts leave a speed along the next surface that leads away from the joint.
    pub(super) fn squeezes(&self, onward: &Onward, speed: f64, terrain: &Terrain) -> Option<f64> {
        let bounds = self.bounds(onward.segment, &onward.track, self.time, terrain);
        match allowed(&bounds, onward.sign * speed) {
            Verdict::Speed(u) if u * onward.sign >= 0.0 => Some(u),
            _ => None,
        }
    }
}
