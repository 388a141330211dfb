//! Contacts: what presses on a body that is on a surface from another frame, and what that leaves of its freedom.
//!
//! The body keeps to its surface, and each contact bounds its speed along it from one side: with the normal n of the contact and
//! the tangent t of the surface, n . (t u + v_surface - v_contact) >= 0. While a bound is met the motion along the surface is that of
//! the bound, a quadratic again. It ends when the body's own law would lead it away, or when it has slid past the end of the edge
//! that presses. Where the bounds leave no speed, the body is crushed, at that very time.

use super::beside::Beside;
use super::body::{Air, Body, Mode, Next, Trace};
use super::mover::Piece;
use super::roots::exit;
use super::size::piece_at;
use super::terrain::{Ground, Terrain};
use super::track::{Axis, Track};
use crate::geom::{Point, STEP};
use crate::mesh::{EdgeId, SegmentId};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// What rounding makes of a speed that was worked out in two ways, relative to the largest part of it.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

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
        let was = *old.segment(self.segment);
        let segment = new.segment_of(was.feature, was.source)?;
        let is = new.segment(segment);
        if (is.a, is.b) != (was.a, was.b) {
            return None;
        }
        let piece = [old.origin(self.edge), old.dest(self.edge)].map(|v| old.point(v));
        self.at(at, segment, new, Some(piece))
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
    /// What rounding may have made of `speed`.
    rounding: f64,
}

impl Bound {
    /// Of a contact with normal `n` that moves as `piece`, for a body on a road with tangent `t` that is carried by `mine`.
    fn new(entry: usize, n: DVec2, t: DVec2, piece: Piece, mine: Piece, now: f64) -> Bound {
        let lever = n.dot(t);
        let closing = n.dot(piece.velocity(now) - mine.velocity(now));
        let closing_accel = n.dot(piece.accel - mine.accel);
        let sizes = |p: Piece| p.v0.length() + p.accel.length() * (now - p.t0);
        Bound {
            entry,
            side: if lever == 0.0 { 0.0 } else { lever.signum() },
            speed: closing / lever,
            accel: closing_accel / lever,
            closes: lever == 0.0 && (closing > 0.0 || closing == 0.0 && closing_accel > 0.0),
            rounding: ROUNDING * (sizes(piece) + sizes(mine)) / lever.abs(),
        }
    }
}

/// What the bounds say about a speed.
enum Verdict {
    /// It is allowed, or this one is next to it.
    Speed(f64),
    /// There is none.
    Crushed,
}

/// The speed nearest to `u` within the bounds. Differences that rounding explains are none.
fn allowed(bounds: &[Bound], u: f64) -> Verdict {
    let of = |side: f64| bounds.iter().filter(move |b| b.side == side);
    let low = of(1.0).max_by(|a, b| a.speed.total_cmp(&b.speed));
    let high = of(-1.0).min_by(|a, b| a.speed.total_cmp(&b.speed));
    let shut = low
        .zip(high)
        .is_some_and(|(low, high)| low.speed - high.speed > low.rounding + high.rounding);
    if shut || bounds.iter().any(|b| b.closes) {
        return Verdict::Crushed;
    }
    let met = |b: &&Bound| (b.speed - u) * b.side >= -(b.rounding + ROUNDING * u.abs());
    Verdict::Speed(low.filter(met).or(high.filter(met)).map_or(u, |b| b.speed))
}

impl Body {
    /// Whether another frame presses on the body.
    pub(super) fn is_pressed(&self) -> bool {
        self.beside.iter().any(|b| b.contact.is_some())
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
        let mesh = beside.ground(self.size, terrain);
        let segment = beside.contact.map(|c| c.segment);
        let segment = segment.or(beside.flight.touching[0])?;
        let (track, (q, _)) = (mesh.track(segment), self.seen_from(beside));
        let mine = self.frame_piece();
        let closes = track
            .normal
            .dot(beside.piece().velocity(now) - mine.velocity(now));
        if closes <= 0.0 || track.height(q, q, q).0.abs() > STEP {
            return None;
        }
        let edge = piece_at(mesh, segment, track.parameter(q), &track, None)?;
        Some(Contact {
            segment,
            track,
            edge,
        })
    }

    /// Whether something of another frame would strike the body at once if it came to rest here.
    pub(super) fn is_driven(&self, terrain: &Terrain) -> bool {
        let driven = |b: &Beside| self.driving(b, terrain).is_some();
        self.beside.iter().any(driven)
    }

    /// At a joint where the body would stop: what drives it there presses on it again, though the body would run ahead.
    pub(super) fn is_pressed_at_joint(&mut self, terrain: &Terrain) -> bool {
        for i in 0..self.beside.len() {
            let beside = &self.beside[i];
            if beside.contact.is_none()
                && let Some(contact) = self.driving(beside, terrain)
            {
                let beside = &mut self.beside[i];
                (beside.contact, beside.of) = (Some(contact), None);
            }
        }
        self.is_pressed()
    }

    /// The bounds of all contacts for a road in the present frame.
    fn bounds(&self, track: &Track) -> Vec<Bound> {
        let now = self.time;
        let mine = self.frame_piece();
        let entries = self.beside.iter().enumerate();
        entries
            .filter_map(|(i, b)| {
                let normal = b.contact?.track.normal;
                Some(Bound::new(i, normal, track.tangent, b.piece(), mine, now))
            })
            .collect()
    }

    /// Before the law is chosen: the speed that the contacts allow. Walled up in the direction of the push, the body is pressed
    /// into the joint there, which decides.
    pub(super) fn press_speed(&mut self, terrain: &Terrain, trace: &mut Trace) {
        if !self.is_pressed() {
            return;
        }
        let Mode::Surface(on) = &self.mode else {
            return self.release_all();
        };
        let bounds = self.bounds(&on.track);
        match allowed(&bounds, on.speed(self.time)) {
            Verdict::Crushed => self.crush(terrain, trace),
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
        let Mode::Surface(on) = &mut self.mode else {
            return;
        };
        let (u, track, wish) = (on.u0, on.track, on.accel);
        let bounds = self.bounds(&track);
        let binds = |b: &&Bound| b.side != 0.0 && b.speed == u;
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
        if let Mode::Surface(on) = &mut self.mode
            && accel != wish
        {
            on.accel = accel;
            let marks = [on.limit.map_or(0.0, |(_, until)| until), 0.0];
            let time = |mark: f64| (on.t0 + (mark - on.u0) / accel, mark);
            let rounding = bounds.iter().map(|b| b.rounding).fold(0.0, f64::max);
            let ahead = marks
                .into_iter()
                .filter(|mark| (mark - on.u0) * accel.signum() > rounding);
            on.limit = ahead.map(time).min_by(|a, b| a.0.total_cmp(&b.0));
            if accel * on.against > 0.0 {
                on.against = 0.0;
            }
        }
        for b in &bounds {
            let apart = (u - b.speed) * b.side;
            let stays = apart == 0.0 && (accel - b.accel) * b.side <= 0.0;
            if !stays {
                self.release(b.entry);
            }
        }
    }

    /// A contact is no more: a free flight in that frame, not yet apart from it.
    fn release(&mut self, entry: usize) {
        let beside = &mut self.beside[entry];
        (beside.contact, beside.of) = (None, None);
    }

    fn release_all(&mut self) {
        for entry in 0..self.beside.len() {
            if self.beside[entry].contact.is_some() {
                self.release(entry);
            }
        }
    }

    /// Whether a contact pushes in a direction along the present surface, and is not only leant on.
    pub(super) fn presses_on(&self, direction: DVec2) -> bool {
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        let ahead = on.track.tangent.dot(direction);
        self.bounds(&on.track).iter().any(|b| b.side * ahead > 0.0)
    }

    /// At a joint, pressed: whether the contacts leave a speed along the next surface that leads away from the joint.
    pub(super) fn squeezes(&self, onward: &Track, sign: f64, speed: f64) -> Option<f64> {
        match allowed(&self.bounds(onward), sign * speed) {
            Verdict::Speed(u) if u * sign >= 0.0 => Some(u),
            _ => None,
        }
    }
}
