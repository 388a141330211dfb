//! Flights: the first side that a parabola hits, asked of all of them.

use super::body::{Body, MARGIN};
use super::corner::{Onward, onward};
use super::double::{Double, Vector};
use super::outline::{SAME, Side, World};

/// A hit slower than this into a side is in doubt, m/s: its time is not known well.
const SLOW: f64 = 1e-4;

/// What a parabola does with one side, and when.
struct Meeting {
    at: Double,
    side: usize,
    /// Why it may be otherwise.
    doubt: Option<&'static str>,
}

/// A parabola.
struct Flight {
    p: Vector,
    v: Vector,
    a: Vector,
}

impl Flight {
    fn at(&self, t: Double) -> (Vector, Vector) {
        let half = t * t * 0.5.into();
        (self.p + self.v * t + self.a * half, self.v + self.a * t)
    }
}

/// The first hit not later than `until`, as a time from now, and the side; doubts that come before it are noted.
pub fn first_hit(
    body: &mut Body,
    p: Vector,
    v: Vector,
    a: Vector,
    until: Option<Double>,
) -> Option<(Double, usize)> {
    let flight = Flight { p, v, a };
    let mut met: Vec<Meeting> = (0..body.world.sides.len())
        .flat_map(|side| {
            let graze = graze(&body.world.sides[side], side, &flight);
            [hit(body.world, side, &flight), graze]
        })
        .flatten()
        .filter(|m| until.is_none_or(|until| m.at <= until))
        .collect();
    let hits = met.iter().filter(|m| m.doubt.is_none());
    let first = hits.map(|m| m.at).reduce(Double::min);
    met.retain(|m| first.is_none_or(|first| m.at <= first || (m.at - first).is_tiny()));
    if let Some(why) = met.iter().find_map(|m| m.doubt) {
        // Not yet: other pieces may come before it.
        let at = met.iter().filter(|m| m.doubt.is_some()).map(|m| m.at);
        let at = at.reduce(Double::min).expect("one was found");
        body.doubtful = Some((body.time + at, why));
    }
    let side = met
        .iter()
        .filter(|m| m.doubt.is_none())
        .map(|m| m.side)
        .max_by(|&a, &b| preferred(body, a, b))?;
    first.map(|at| (at, side))
}

/// Of several sides that are hit at once ground comes first, then the longer one.
fn preferred(body: &Body, a: usize, b: usize) -> std::cmp::Ordering {
    let rank = |side: usize| (body.walkable(side), body.side(side).length);
    rank(a).partial_cmp(&rank(b)).expect("lengths are numbers")
}

/// Zero for what is zero but for rounding.
fn clean(a: Double) -> Double {
    if a.is_tiny() { Double::ZERO } else { a }
}

/// Height over a side along a flight: c + b t + e t^2.
fn height(side: &Side, flight: &Flight) -> [Double; 3] {
    let n = side.normal;
    [
        clean(n.dot(flight.p - side.start)),
        clean(n.dot(flight.v)),
        clean(n.dot(flight.a) * 0.5.into()),
    ]
}

/// When c + b t + e t^2 first goes from positive to negative, not before now.
fn goes_under([c, b, e]: [Double; 3]) -> Option<Double> {
    let zero = Double::ZERO;
    if b >= zero && e >= zero {
        return None;
    }
    let root = (b * b - Double::from(4.0) * e * c).sqrt();
    let touches = b * b <= Double::from(4.0) * e * c;
    if touches && !(c == zero && b == zero) {
        return None;
    }
    let at = if b > zero {
        (b + root) / (e * (-2.0).into())
    } else if c == zero {
        zero
    } else {
        Double::from(2.0) * c / (root - b)
    };
    (at >= zero).then_some(at)
}

/// Where a flight goes under the line of a side: on it, beside it, or too near its end to say.
fn hit(world: &World, side: usize, flight: &Flight) -> Option<Meeting> {
    let on = &world.sides[side];
    let [c, b, e] = height(on, flight);
    let at = goes_under([c, b, e])?;
    let (p, v) = flight.at(at);
    let s = on.tangent.dot(p - on.start);
    let into = (b + e * at * 2.0.into()).abs().to_f64();
    let met = |doubt| Some(Meeting { at, side, doubt });
    if at > Double::ZERO && into < SLOW {
        return met(Some("a hit that is hardly one")).filter(|_| beside(on, s) < MARGIN);
    }
    let (direction, beyond) = if s - on.from < on.to - s {
        (-1.0, on.from - s)
    } else {
        (1.0, s - on.to)
    };
    if beyond.abs().to_f64() > MARGIN {
        return met(None).filter(|_| beyond.sign() < 0.0);
    }
    match onward(world, side, direction) {
        Onward::Straight(_) => met(None).filter(|_| beyond.sign() < 0.0 || beyond.is_tiny()),
        _ if !beyond.is_tiny() => met(Some("a hit near a corner")),
        _ if ends_at(world, on.at(on.end(direction))) > 2 => met(Some("a corner of several")),
        Onward::Turn { towards: true, .. } => met(None),
        _ => {
            // Exactly at a tip: who has just left it, or falls in line with it, goes free.
            let along = clean(on.tangent.dot(v));
            let along = if along == Double::ZERO {
                clean(on.tangent.dot(flight.a))
            } else {
                along
            };
            let outward = along.sign() * direction;
            match (at.is_tiny(), outward < 0.0, outward == 0.0) {
                (true, true, _) => met(None),
                (true, ..) | (false, _, true) => None,
                _ => met(Some("a hit on a tip")),
            }
        }
    }
}

/// How many stretches end at a position.
fn ends_at(world: &World, p: Vector) -> usize {
    let ends = |side: &Side| [side.at(side.from), side.at(side.to)];
    let here = |q: &Vector| (*q - p).length().to_f64() < SAME;
    world.sides.iter().flat_map(ends).filter(here).count()
}

/// How far beyond the ends of a stretch an arc length is, m; not positive on it.
fn beside(on: &Side, s: Double) -> f64 {
    (on.from - s).max(s - on.to).to_f64()
}

/// Where a flight comes near a side and turns away from it.
fn graze(on: &Side, side: usize, flight: &Flight) -> Option<Meeting> {
    let [c, b, e] = height(on, flight);
    if b.sign() >= 0.0 || e.sign() <= 0.0 {
        return None;
    }
    let at = -b / (e * 2.0.into());
    let low = c + b * at * 0.5.into();
    let s = on.tangent.dot(flight.at(at).0 - on.start);
    let near = low.abs().to_f64() < MARGIN && beside(on, s) < MARGIN;
    let doubt = Some("a graze");
    near.then_some(Meeting { at, side, doubt })
}
