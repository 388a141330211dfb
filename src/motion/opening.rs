//! When a place among moving solids is free: in closed form, out of their paths.
//!
//! Seen from a moving solid a resting place goes along its path backwards, a quadratic in each piece. It comes into the
//! solid and out of it only where it crosses the line of one of the solid's feature edges. Between two such times nothing
//! changes, so one look in the middle tells how it is there.

use super::body::{Body, Size};
use super::mover::{Mover, Piece};
use super::roots::zeros;
use super::size::free_face;
use super::terrain::{Ground, Terrain};
use crate::geom::STEP;
use crate::mesh::{FeatureId, Kind, Mesh, Place};
use glam::DVec2;

/// A span of time, from its first moment to its last, s.
type Span = (f64, f64);

/// How far beyond the ends of a feature edge a crossing of its line still counts, m.
const BEYOND: f64 = 4.0 * STEP;

/// A place that may ride on a moving solid.
#[derive(Clone, Copy, Debug)]
pub struct Spot<'a> {
    /// Where it was drawn, m.
    pub drawn: DVec2,
    /// What it rides on.
    pub carrier: Option<&'a Mover>,
}

impl Spot<'_> {
    /// How it moves at a time, in the world.
    fn piece_at(&self, t: f64) -> Piece {
        let piece = self.carrier.map(|mover| mover.piece_at(t));
        let piece = piece.unwrap_or_default();
        Piece {
            p0: self.drawn + piece.p0,
            ..piece
        }
    }

    /// When that changes next.
    fn next_node(&self, t: f64) -> Option<f64> {
        self.carrier.and_then(|mover| mover.next_node(t))
    }
}

impl Terrain<'_> {
    /// The first time, not before one and not after another, from which on a standing body has room at a place and nothing there
    /// kills, for `lasts` seconds at least. `kills` tells which regions do.
    ///
    /// That time is a root in closed form: it does not depend on when somebody asks.
    pub fn opens(
        &self,
        spot: Spot,
        (from, latest): Span,
        lasts: f64,
        kills: impl Fn(FeatureId) -> bool,
    ) -> Option<f64> {
        let span = (from, latest + lasts);
        let solids = self.movers.iter();
        let mut closed: Vec<Span> = solids
            .flat_map(|solid| spans(Some(solid), spot, span, self, &kills))
            .collect();
        if spot.carrier.is_some() {
            closed.extend(spans(None, spot, span, self, &kills));
        } else if !self.is_open(spot.drawn, from, &kills) {
            return None;
        }
        closed.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut open = from;
        for (begin, end) in closed {
            if begin - open >= lasts {
                break;
            }
            open = open.max(end);
        }
        (open <= latest).then_some(open)
    }

    /// Whether the level alone leaves room at a place at rest.
    fn is_open(&self, place: DVec2, time: f64, kills: &impl Fn(FeatureId) -> bool) -> bool {
        let still = Terrain {
            movers: &[],
            ..*self
        };
        let body = Body::spawn(place, time, &still);
        body.is_ok_and(|body| !body.regions().iter().any(|&id| kills(id)))
    }
}

impl Mover {
    /// When the solid, from its path's beginning on, first comes to where a standing body at rest would be, or brings there what
    /// kills; as a time of the path, s.
    pub fn comes_over(
        &self,
        place: DVec2,
        terrain: &Terrain,
        kills: impl Fn(FeatureId) -> bool,
    ) -> Option<f64> {
        let started = Mover {
            start: Some(0.0),
            ..self.clone()
        };
        // A path that does not come round rests after its last piece has begun: one look beyond that is enough.
        let last = self.path.pieces.last().map_or(0.0, |piece| piece.t0);
        let round = (0.0, self.path.period.unwrap_or(last + 1.0));
        let spot = Spot {
            drawn: place,
            carrier: None,
        };
        let closed = spans(Some(&started), spot, round, terrain, &kills);
        closed.first().map(|span| span.0)
    }
}

/// The spans in which a moving solid, or the level, is where a standing body would be, or has there what kills.
fn spans(
    solid: Option<&Mover>,
    spot: Spot,
    (from, until): Span,
    terrain: &Terrain,
    kills: &impl Fn(FeatureId) -> bool,
) -> Vec<Span> {
    let mesh = solid.map_or(terrain.stand, |solid| solid.mesh(Size::Stand));
    let segments = segments(mesh, kills);
    let bounds = bounds(&segments);
    let mut found: Vec<Span> = Vec::new();
    let mut now = from;
    while now < until {
        let piece = solid.map(|solid| solid.piece_at(now)).unwrap_or_default();
        let node = solid.and_then(|solid| solid.next_node(now));
        let nodes = node.into_iter().chain(spot.next_node(now));
        let end = nodes.fold(until, f64::min);
        let seen = spot.piece_at(now).seen_from(&piece);
        if comes_near(&seen, (now, end), bounds) {
            let times = crossings(&seen, (now, end), &segments);
            for pair in times.windows(2) {
                let middle = 0.5 * (pair[0] + pair[1]);
                if pair[0] < pair[1] && is_closed(mesh, seen, middle, terrain, kills) {
                    found.push((pair[0], pair[1]));
                }
            }
        }
        now = end;
    }
    found
}

/// The feature edges of what stops or kills, by their ends, m.
fn segments(mesh: &Mesh, kills: &impl Fn(FeatureId) -> bool) -> Vec<[DVec2; 2]> {
    let counts = |&f: &FeatureId| match mesh.kind_of(f) {
        Some(Kind::Region) => kills(f),
        Some(Kind::OneWay) | None => false,
        Some(_) => true,
    };
    let ends = |&s: &_| {
        let segment = mesh.segment(s);
        [segment.a, segment.b].map(|p| p.metres())
    };
    let features = mesh.features().filter(counts);
    features
        .flat_map(|f| mesh.segments_of(f).iter().map(ends))
        .collect()
}

/// The box around all of it.
fn bounds(segments: &[[DVec2; 2]]) -> (DVec2, DVec2) {
    let none = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let grow = |(min, max): (DVec2, DVec2), p: &DVec2| (min.min(*p), max.max(*p));
    segments.iter().flatten().fold(none, grow)
}

/// Whether a motion may come into a box in a span of time.
fn comes_near(seen: &Piece, (from, until): Span, (min, max): (DVec2, DVec2)) -> bool {
    let [a, b] = [seen.offset(from), seen.offset(until)];
    let turn = |v: f64, accel: f64| seen.t0 - v / accel;
    let turns = [turn(seen.v0.x, seen.accel.x), turn(seen.v0.y, seen.accel.y)];
    let between = turns
        .into_iter()
        .filter(|&t| t > from && t < until)
        .map(|t| seen.offset(t));
    let (low, high) = between.fold((a.min(b), a.max(b)), |(low, high), p| {
        (low.min(p), high.max(p))
    });
    low.cmple(max + BEYOND).all() && high.cmpge(min - BEYOND).all()
}

/// When a motion crosses lines of feature edges near these, in a span of time and with its ends, in order.
fn crossings(seen: &Piece, (from, until): Span, segments: &[[DVec2; 2]]) -> Vec<f64> {
    let mut times = vec![from, until];
    for [a, b] in segments {
        let along = (b - a).normalize_or_zero();
        let length = (b - a).length();
        let across = |v: DVec2| along.perp_dot(v);
        let (c, b, e) = (
            across(seen.p0 - a),
            across(seen.v0),
            0.5 * across(seen.accel),
        );
        for dt in zeros(c, b, e).into_iter().flatten() {
            let at = seen.t0 + dt;
            let s = along.dot(seen.offset(at) - a);
            if at > from && at < until && (-BEYOND..=length + BEYOND).contains(&s) {
                times.push(at);
            }
        }
    }
    times.sort_by(f64::total_cmp);
    times
}

/// Whether the place, seen from a mesh, is in a solid of it at a time, or in what kills.
fn is_closed(
    mesh: &Mesh,
    seen: Piece,
    at: f64,
    terrain: &Terrain,
    kills: &impl Fn(FeatureId) -> bool,
) -> bool {
    let ground = Ground {
        mesh,
        ..terrain.ground(Size::Stand)
    };
    let p = seen.offset(at);
    let Ok(face) = free_face(ground, p, seen.velocity(at), DVec2::NEG_Y) else {
        return true;
    };
    // On the rim of what kills nobody is in it.
    let inside = matches!(mesh.locate(p, None), Some(Place::Face(_)));
    inside && mesh.cover(face).iter().any(|&f| kills(f))
}
