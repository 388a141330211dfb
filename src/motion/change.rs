//! Conditions that change inside a piece of motion, as events with a root.
//!
//! What holds a body on a surface is decided by its speeds in the world: where the stick and gravity would take it in the air,
//! against where the surface goes. Along a surface of the level those speeds change with the speed along it, whose marks end a
//! piece. Where what carries the body speeds up, or what presses on it drives it, they change by themselves: each then comes to its
//! marks at a time of its own, the root of a linear function, or of a quadratic one on a ladder. Between two of these times
//! nothing can change, so that one instant of each stretch says whether the condition still holds there.

use super::body::{Body, EventKind, Mode, Next, Surface, Trace};
use super::grip::Grip;
use super::ladder::Reach;
use super::law;
use super::mover::Piece;
use super::terrain::Terrain;
use super::track::Track;
use crate::tune::Motion;
use glam::DVec2;

/// What rounding makes of a speed along a road, relative to it.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A stretch for which the end of the last one stands, s.
const LAST: f64 = 1.0;

/// How a body on a surface moves at a time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moment {
    /// The time, s.
    pub(super) at: f64,
    /// In the world, m/s.
    pub(super) v: DVec2,
    /// What carries the body, m/s.
    pub(super) carried: DVec2,
    /// The acceleration of that, m/s^2.
    pub(super) follows: DVec2,
    /// What rounding may have made of the speeds, m/s.
    pub(super) rounding: f64,
}

impl Moment {
    /// With a speed along a tangent, carried by a frame.
    pub(super) fn on(frame: &Piece, at: f64, tangent: DVec2, speed: f64) -> Moment {
        let carried = frame.velocity(at);
        let moves = *frame != Piece::default();
        Moment {
            at,
            v: tangent * speed + carried,
            carried,
            follows: frame.accel,
            rounding: match moves {
                true => frame.rounding(at) + ROUNDING * speed.abs(),
                false => 0.0,
            },
        }
    }
}

/// So many marks are looked at: nine speeds, and four for each of what presses on a body, of which two are at work.
const TIMES: usize = 32;

/// The times at which something comes to a mark.
#[derive(Default)]
pub(super) struct Times {
    times: [f64; TIMES],
    count: usize,
}

impl Times {
    /// When `value`, that grows at `rate`, comes to a mark after `now`; what is there already but for rounding is there.
    pub(super) fn linear(&mut self, now: f64, value: f64, rate: f64, marks: &[f64], rounding: f64) {
        if rate == 0.0 {
            return;
        }
        for &mark in marks {
            let miss = mark - value;
            if miss.abs() > rounding && miss * rate > 0.0 {
                self.push(now + miss / rate);
            }
        }
    }

    /// When `value`, 0 at `now` but for rounding, is more than that.
    pub(super) fn departs(&mut self, now: f64, value: f64, rate: f64, rounding: f64) {
        if rate != 0.0 && value.abs() <= rounding {
            let soon = 4.0 * rounding / rate.abs() + 8.0 * f64::EPSILON * now.abs();
            self.push(now + soon.max(f64::MIN_POSITIVE));
        }
    }

    /// When c + b t + a t^2 is 0, with t counted from `now`.
    pub(super) fn quadratic(&mut self, now: f64, c: f64, b: f64, a: f64) {
        let d = b * b - 4.0 * a * c;
        if d < 0.0 {
            return;
        }
        let q = -0.5 * (b + d.sqrt().copysign(b));
        for t in [q / a, c / q] {
            if t.is_finite() && t > 0.0 {
                self.push(now + t);
            }
        }
    }

    fn push(&mut self, at: f64) {
        if let Some(free) = self.times.get_mut(self.count) {
            *free = at;
            self.count += 1;
        }
    }

    /// Those before a time, in order.
    fn before(&mut self, until: f64) -> &[f64] {
        let times = &mut self.times[..self.count];
        times.sort_by(f64::total_cmp);
        let count = times.partition_point(|&t| t < until);
        &times[..count]
    }
}

impl Body {
    /// The present moment on a road, with a speed along it.
    pub(super) fn moment(&self, track: &Track, speed: f64) -> Moment {
        Moment::on(&self.frame_piece(), self.time, track.tangent, speed)
    }

    /// The present moment.
    pub(super) fn now(&self) -> Moment {
        let v = self.local_velocity();
        Moment::on(&self.frame_piece(), self.time, v, 1.0)
    }

    /// The time at which what holds the body on its surface, or at its vertex, holds it no longer, if that comes first.
    pub(super) fn sooner_if_changes(
        &self,
        next: Option<(f64, Next)>,
        terrain: &Terrain,
    ) -> Option<(f64, Next)> {
        let (held, pressed) = (self.is_only_held(), self.is_pressed());
        if !held && !pressed {
            return next;
        }
        let node = self.frame.and_then(|ride| ride.until);
        let until = next.map_or(f64::INFINITY, |(at, _)| at);
        let until = node.map_or(until, |node| until.min(node));
        match self.changes(held, until, terrain) {
            Some(at) => Some((at, Next::Change)),
            None => next,
        }
    }

    /// Whether nothing but speeds says if the body stays where it is.
    fn is_only_held(&self) -> bool {
        let accelerates = self.frame_accel() != DVec2::ZERO;
        match &self.mode {
            Mode::Air(_) if self.reach == Reach::Landed => true,
            Mode::Air(_) | Mode::Crushed(_) => false,
            Mode::Surface(on) if self.is_pinned(on.track.normal) => false,
            Mode::Surface(on) if on.grip != Grip::None => false,
            Mode::Surface(on) if on.walkable => accelerates,
            Mode::Surface(_) => {
                let ladder_moves = self.climbing && self.ladder.is_some();
                self.frame.is_some() || self.is_pressed() || ladder_moves
            }
            Mode::Wedge(_) => accelerates && !self.is_pinned(DVec2::Y),
        }
    }

    /// When a condition changes, before a time: what holds the body, if nothing else does, and what squeezes it.
    fn changes(&self, held: bool, until: f64, terrain: &Terrain) -> Option<f64> {
        if matches!(self.mode, Mode::Air(_)) {
            return self.apart_from_ground(terrain).filter(|&at| at < until);
        }
        let mut times = Times::default();
        if held {
            self.holding_times(&mut times, terrain);
        }
        self.squeezing_times(&mut times, terrain);
        let times = times.before(until);
        if times.is_empty() {
            return None;
        }
        let ends = times.iter().skip(1).copied();
        let last = times.last().map(|t| until.min(t + LAST));
        let middles = ends.chain(last).zip(times);
        let middles = middles.map(|(end, &start)| (start, 0.5 * (start + end)));
        let condition = |at: f64| {
            let holds = !held || self.holds_at(at, terrain);
            (holds, self.is_squeezed(at, terrain))
        };
        let now = condition(self.time);
        middles
            .filter(|&(start, middle)| middle > start)
            .find(|&(_, middle)| condition(middle) != now)
            .map(|(start, _)| start)
    }

    /// The body's moment at a time of its piece.
    fn moment_at(&self, at: f64) -> Moment {
        let frame = self.frame_piece();
        match &self.mode {
            Mode::Surface(on) => Moment::on(&frame, at, on.track.tangent, on.speed(at)),
            _ => Moment::on(&frame, at, DVec2::X, 0.0),
        }
    }

    /// Whether the condition holds at a time of the piece.
    fn holds_at(&self, at: f64, terrain: &Terrain) -> bool {
        let (moment, t) = (self.moment_at(at), terrain.tuning);
        match &self.mode {
            Mode::Surface(on) if on.walkable => {
                let drops = self.drops_at(on.track.normal, moment.follows, &moment, t);
                !drops && self.keeps_at_end(on, at, terrain) != Some(false)
            }
            Mode::Surface(on) => !self.pulled_off(&on.track, &moment, terrain),
            Mode::Wedge(_) => !self.drops_at(DVec2::Y, moment.follows, &moment, t),
            Mode::Air(_) | Mode::Crushed(_) => true,
        }
    }

    /// When the speeds that decide come to their marks.
    fn holding_times(&self, times: &mut Times, terrain: &Terrain) {
        let (t, now) = (terrain.tuning, self.time);
        let moment = self.moment_at(now);
        let along = match &self.mode {
            Mode::Surface(on) => on.track.tangent * on.accel,
            _ => DVec2::ZERO,
        };
        let rate = along + moment.follows;
        let slack = moment.rounding + f64::EPSILON * now.abs() * rate.length();
        if self.climbing {
            if let Mode::Surface(on) = &self.mode {
                self.climbing_times(times, on.track.normal, &moment, rate, t);
            }
            return;
        }
        let mut linear = |value: f64, rate: f64, marks: &[f64]| {
            times.linear(now, value, rate, marks, slack);
        };
        linear(
            moment.v.x,
            rate.x,
            &law::marks_of_steering(&self.control, t),
        );
        linear(moment.v.y, rate.y, &law::marks_of_fall(&self.control, t));
        if let Some(cut) = self.rise_in_world(DVec2::ZERO, t) {
            let (v, rate) = match self.frame {
                Some(_) => (moment.v - moment.carried, along),
                None => (moment.v, rate),
            };
            linear(v.y, rate.y, &[cut.from, cut.to]);
        }
        if let Mode::Surface(on) = &self.mode {
            let n = on.track.normal;
            linear(n.dot(moment.carried), n.dot(moment.follows), &[0.0]);
        }
    }

    /// A condition changes: the body looks again what holds it.
    pub(super) fn change(&mut self, trace: &mut Trace) {
        self.rebase();
        self.log(EventKind::Limit, trace);
    }
}

impl Surface {
    /// The acceleration of a slide along what speeds up itself, and the speed at which it changes. `fall`: that of the slide at a
    /// speed, were it at rest; `drift`: what its own acceleration adds. A mark to which both sides lead back is kept to.
    pub(super) fn choose_drift(&mut self, fall: impl Fn(f64) -> f64, drift: f64, marks: &[f64]) {
        let rate = |u: f64| fall(u) + drift;
        let met = |mark: &&f64| (self.u0 - **mark).abs() <= 4.0 * ROUNDING * mark.abs();
        self.accel = match marks.iter().find(met) {
            None => rate(self.u0),
            Some(&mark) => {
                let aside = 1e-9 * (1.0 + mark.abs());
                let (below, above) = (rate(mark - aside), rate(mark + aside));
                match (below < 0.0, above > 0.0) {
                    (false, false) => 0.0,
                    (true, false) => below,
                    (false, true) => above,
                    (true, true) => rate(mark),
                }
            }
        };
        let after =
            |&&mark: &&f64| mark.is_finite() && !met(&&mark) && (mark - self.u0) * self.accel > 0.0;
        let nearer = |a: &&f64, b: &&f64| (*a - self.u0).abs().total_cmp(&(*b - self.u0).abs());
        let mark = marks.iter().filter(after).min_by(nearer);
        self.limit = mark.map(|mark| (self.t0 + (mark - self.u0) / self.accel, *mark));
    }
}

/// Whether a speed counts as that of a mark: but for rounding it is there.
pub(super) fn settled(speed: f64, marks: &[f64], rounding: f64) -> f64 {
    let near = |mark: &&f64| (speed - **mark).abs() <= rounding;
    marks.iter().find(near).copied().unwrap_or(speed)
}

/// The laws of flight at a moment: sideways, and up and down.
pub(super) fn flight(body: &Body, moment: &Moment, t: &Motion) -> (law::Law, law::Law) {
    let control = &body.control();
    let x = settled(
        moment.v.x,
        &law::marks_of_steering(control, t),
        moment.rounding,
    );
    let y = settled(moment.v.y, &law::marks_of_fall(control, t), moment.rounding);
    let steer = law::steer(x, control, t);
    let x = match steer.turns_at_once(x, moment.at) {
        true => law::steer(0.0, control, t),
        false => steer,
    };
    let cut = body.rise_in_world(moment.carried, t);
    (x, law::rise_or_fall(y, cut, control, t))
}
