//! Moving solids: translations with piecewise constant acceleration, so that every relative motion stays quadratic.

use super::beside::ROUNDING;
use super::body::Size;
use crate::mesh::{Kind, Mesh};
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// One piece of a translation: a quadratic in time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Piece {
    /// When it starts, s.
    pub t0: f64,
    /// Offset from the drawn place then, m.
    pub p0: DVec2,
    /// Velocity then, m/s.
    pub v0: DVec2,
    /// Acceleration throughout, m/s^2.
    pub accel: DVec2,
}

impl Piece {
    /// The offset at a time, m.
    pub fn offset(&self, t: f64) -> DVec2 {
        let dt = t - self.t0;
        self.p0 + self.v0 * dt + self.accel * (0.5 * dt * dt)
    }

    /// The velocity at a time, m/s.
    pub fn velocity(&self, t: f64) -> DVec2 {
        self.v0 + self.accel * (t - self.t0)
    }

    /// The sum of the sizes that a velocity at a time is worked out from, m/s.
    pub(super) fn sizes(&self, t: f64) -> f64 {
        self.v0.length() + self.accel.length() * (t - self.t0)
    }

    /// What rounding may make of the velocity at a time, that of the time included, m/s.
    pub(super) fn rounding(&self, t: f64) -> f64 {
        ROUNDING * self.sizes(t) + f64::EPSILON * t * self.accel.length()
    }

    /// The same motion relative to another, from when both have begun.
    pub(super) fn seen_from(&self, other: &Piece) -> Piece {
        let t0 = self.t0.max(other.t0);
        Piece {
            t0,
            p0: self.offset(t0) - other.offset(t0),
            v0: self.velocity(t0) - other.velocity(t0),
            accel: self.accel - other.accel,
        }
    }

    /// A motion relative to this one's frame, in the world.
    pub(super) fn carried_by(&self, frame: &Piece) -> Piece {
        let t0 = self.t0.max(frame.t0);
        Piece {
            t0,
            p0: self.offset(t0) + frame.offset(t0),
            v0: self.velocity(t0) + frame.velocity(t0),
            accel: self.accel + frame.accel,
        }
    }
}

/// A translation through time: pieces one after the other, the first at the path's own time 0, repeated for ever or
/// resting after the last one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Path {
    /// In order of time. Before the first one, and without any, the solid rests where the first one starts.
    pub pieces: Vec<Piece>,
    /// After this time it starts again, s; `None`: the last piece goes on for ever.
    pub period: Option<f64>,
}

impl Path {
    /// The piece in force at a time; at a node, the one that starts there.
    ///
    /// Its `t0` is in the time that was asked about. `start`: when the path's own time 0 is; `None` while it waits.
    pub fn piece_at(&self, t: f64, start: Option<f64>) -> Piece {
        let Some(first) = self.pieces.first() else {
            return Piece::default();
        };
        let parked = Piece {
            p0: first.p0,
            ..Piece::default()
        };
        let Some(start) = start.filter(|&start| t >= start) else {
            return parked;
        };
        let base = self.base(t, start);
        let started = |p: &&Piece| base + p.t0 <= t;
        let piece = self.pieces.iter().rfind(started).unwrap_or(first);
        Piece {
            t0: base + piece.t0,
            ..*piece
        }
    }

    /// The highest speed on it, m/s: infinite if its last piece speeds up for ever.
    pub fn fastest(&self) -> f64 {
        let ends = self.pieces.iter().skip(1).map(|p| Some(p.t0));
        let last = self.pieces.first().and(self.period);
        let speed = |(piece, end): (&Piece, Option<f64>)| match end {
            Some(end) => piece.v0.length().max(piece.velocity(end).length()),
            None if piece.accel == DVec2::ZERO => piece.v0.length(),
            None => f64::INFINITY,
        };
        let speeds = self.pieces.iter().zip(ends.chain([last])).map(speed);
        speeds.fold(0.0, f64::max)
    }

    /// When the next piece starts, strictly after a time.
    pub fn next_node(&self, t: f64, start: Option<f64>) -> Option<f64> {
        let start = start?;
        if t < start {
            return Some(start);
        }
        let base = self.base(t, start);
        let later = self.pieces.iter().map(|p| base + p.t0).find(|&at| at > t);
        later.or_else(|| self.period.map(|period| self.cycle(t, start, period, 1.0)))
    }

    /// When the cycle that holds a time began.
    fn base(&self, t: f64, start: f64) -> f64 {
        match self.period {
            None => start,
            Some(period) => self.cycle(t, start, period, 0.0),
        }
    }

    /// The start of the cycle that holds a time, or of one after it: a whole number of periods from the start, rounded once.
    fn cycle(&self, t: f64, start: f64, period: f64, after: f64) -> f64 {
        let mut n = ((t - start) / period).floor();
        // The quotient may round across a node; the sum decides.
        if start + n * period > t {
            n -= 1.0;
        } else if start + (n + 1.0) * period <= t {
            n += 1.0;
        }
        start + (n + after) * period
    }
}

/// A moving solid: its own small meshes, in its own frame, and where that frame goes.
#[derive(Clone, Debug)]
pub struct Mover {
    /// Its features alone, for the standing collider, at offset 0.
    pub stand: Arc<Mesh>,
    /// The same for the crouching collider.
    pub crouch: Arc<Mesh>,
    /// Where it goes.
    pub path: Path,
    /// When the path's own time 0 is; `None`: it waits where the path begins.
    pub start: Option<f64>,
}

impl Mover {
    /// The mesh for a size.
    pub fn mesh(&self, size: Size) -> &Mesh {
        match size {
            Size::Stand => &self.stand,
            Size::Crouch => &self.crouch,
        }
    }

    /// Whether some of its features are regions.
    pub fn has_regions(&self) -> bool {
        let is_region = |f| self.stand.kind_of(f) == Some(Kind::Region);
        self.stand.features().any(is_region)
    }

    /// The piece of its motion in force at a time.
    pub fn piece_at(&self, t: f64) -> Piece {
        self.path.piece_at(t, self.start)
    }

    /// When its motion changes next, strictly after a time.
    pub fn next_node(&self, t: f64) -> Option<f64> {
        self.path.next_node(t, self.start)
    }
}

/// What carries a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ride {
    /// Index of the moving solid.
    pub mover: u32,
    /// The piece of its motion in force.
    pub piece: Piece,
    /// When the next one begins, s.
    pub until: Option<f64>,
}

impl Ride {
    /// A moving solid at a time.
    pub(super) fn at(mover: u32, t: f64, movers: &[Mover]) -> Ride {
        let solid = &movers[mover as usize];
        Ride {
            mover,
            piece: solid.piece_at(t),
            until: solid.next_node(t),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lift() -> Path {
        let piece = |t0: f64, y: f64, v: f64| Piece {
            t0,
            p0: DVec2::new(0.0, y),
            v0: DVec2::new(0.0, v),
            accel: DVec2::ZERO,
        };
        Path {
            pieces: vec![
                piece(0.0, 0.0, 2.0),
                piece(1.0, 2.0, 0.0),
                piece(1.5, 2.0, -2.0),
            ],
            period: Some(2.5),
        }
    }

    #[test]
    fn a_path_rests_starts_and_comes_round() {
        let path = lift();
        assert_eq!(path.piece_at(7.0, None).velocity(7.0), DVec2::ZERO);
        assert_eq!(path.piece_at(0.5, Some(1.0)).velocity(0.5), DVec2::ZERO);
        assert_eq!(path.next_node(0.5, Some(1.0)), Some(1.0));
        let y = |t: f64| path.piece_at(t, Some(1.0)).offset(t).y;
        assert_eq!(
            [y(1.5), y(2.0), y(2.25), y(3.0), y(4.0)],
            [1.0, 2.0, 2.0, 1.0, 1.0]
        );
        assert_eq!(path.next_node(2.0, Some(1.0)), Some(2.5));
        assert_eq!(path.next_node(2.75, Some(1.0)), Some(3.5));
        assert_eq!(path.next_node(3.5, Some(1.0)), Some(4.5));
    }

    #[test]
    fn nodes_of_late_cycles_are_met_exactly() {
        let path = Path {
            period: Some(1.7),
            ..lift()
        };
        let mut t = 0.1;
        for _ in 0..10_000 {
            let next = path.next_node(t, Some(0.1)).unwrap();
            assert!(next > t);
            assert_eq!(path.piece_at(next, Some(0.1)).t0, next);
            t = next;
        }
    }
}
