//! Paths of movers, from the stops of a level to the pieces of the motion, and what sets them going.

use crate::geom::Point;
use crate::level::{Easing, End, Level, Mover, Repeat, Starts, Stop};
use crate::mesh::FeatureId;
use crate::motion::{Path, Piece};
use glam::DVec2;

/// Where a mover goes, and what makes it.
#[derive(Clone, Debug)]
pub(super) struct Route {
    /// From its first stop on.
    pub out: Path,
    /// From its last stop to the first, the way that it came; empty if nothing ever sends it there.
    pub home: Path,
    /// What sets it going.
    pub cause: Cause,
    /// The triggers that call it, and where to.
    pub calls: Vec<(FeatureId, End)>,
    /// For how long it stays at its last stop after nobody rides it any more, s.
    pub back: Option<f64>,
}

/// What sets a mover going.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cause {
    /// The beginning of the level.
    Level,
    /// Somebody who enters a trigger.
    Trigger(FeatureId),
    /// Somebody who comes to ride it.
    Rider,
}

impl Route {
    /// That of a mover of a level, whose features have numbers in the order in which they are listed.
    pub fn of(mover: &Mover, level: &Level) -> Route {
        let riders = || level.movers.iter().flat_map(|mover| &mover.features);
        let trigger = |id: &str| {
            let mut all = level.features.iter().chain(riders());
            let found = all.position(|feature| feature.id == id);
            found.map(|index| index as FeatureId)
        };
        let cause = match &mover.starts {
            Starts::AtOnce => Cause::Level,
            Starts::On(id) => trigger(id).map_or(Cause::Level, Cause::Trigger),
            Starts::Ridden => Cause::Rider,
        };
        let calls = mover.calls.iter();
        let calls = calls.filter_map(|call| Some((trigger(&call.by)?, call.to)));
        let comes_back = mover.back.is_some() || !mover.calls.is_empty();
        Route {
            out: path(mover),
            home: if comes_back {
                home(mover)
            } else {
                Path::default()
            },
            cause,
            calls: calls.collect(),
            back: mover.back,
        }
    }

    /// Whether it turns round by itself.
    pub fn turns(&self) -> bool {
        !self.home.pieces.is_empty()
    }

    /// Whether it matters who rides it.
    pub fn minds_riders(&self) -> bool {
        self.cause == Cause::Rider || self.back.is_some()
    }
}

/// How long a path takes that is gone once, s.
pub(super) fn seconds(path: &Path) -> f64 {
    path.pieces.last().map_or(0.0, |piece| piece.t0)
}

/// The path from the last stop back to the first, which it leaves and reaches without a wait.
fn home(mover: &Mover) -> Path {
    let mut line = Line::default();
    for (i, pair) in mover.path.windows(2).rev().enumerate() {
        if i > 0 {
            line.rest(&pair[1]);
        }
        line.go(&pair[1], &pair[0], &pair[0]);
    }
    if let Some(first) = mover.path.first() {
        line.stay(first);
    }
    line.path
}

/// The path of a mover. At every stop its offset is a point of the grid, exactly.
fn path(mover: &Mover) -> Path {
    let stops = &mover.path;
    let mut line = Line::default();
    let ways = stops.windows(2);
    for pair in ways.clone() {
        line.rest(&pair[0]);
        line.go(&pair[0], &pair[1], &pair[0]);
    }
    let (Some(first), Some(last)) = (stops.first(), stops.last()) else {
        return Path::default();
    };
    match mover.repeat {
        _ if stops.len() == 1 => {}
        Repeat::Once => {}
        Repeat::Loop => {
            line.rest(last);
            line.go(last, first, last);
            return line.around();
        }
        Repeat::PingPong => {
            for pair in ways.rev() {
                line.rest(&pair[1]);
                line.go(&pair[1], &pair[0], &pair[0]);
            }
            return line.around();
        }
    }
    line.stay(last);
    line.path
}

/// A path in the making, and how long it takes so far.
#[derive(Default)]
struct Line {
    path: Path,
    seconds: f64,
}

impl Line {
    /// Waits at a stop.
    fn rest(&mut self, stop: &Stop) {
        if stop.wait > 0.0 {
            self.stay(stop);
            self.seconds += stop.wait;
        }
    }

    /// At a stop, until something else follows.
    fn stay(&mut self, stop: &Stop) {
        self.piece(0.0, offset(stop), DVec2::ZERO, DVec2::ZERO);
    }

    /// From one stop to another, in the time and the manner of the way that `how` names.
    fn go(&mut self, from: &Stop, to: &Stop, how: &Stop) {
        let (a, b, time) = (offset(from), offset(to), how.seconds);
        let speed = (b - a) / time;
        match how.easing {
            Easing::Linear => self.piece(0.0, a, speed, DVec2::ZERO),
            Easing::Eased => {
                // Half the way in half the time, where it is twice as fast as on average.
                let accel = speed * (4.0 / time);
                self.piece(0.0, a, DVec2::ZERO, accel);
                self.piece(0.5 * time, (a + b) * 0.5, speed * 2.0, -accel);
            }
        }
        self.seconds += time;
    }

    fn piece(&mut self, after: f64, p0: DVec2, v0: DVec2, accel: DVec2) {
        let t0 = self.seconds + after;
        self.path.pieces.push(Piece { t0, p0, v0, accel });
    }

    /// The path, when it begins anew at its end.
    fn around(self) -> Path {
        Path {
            period: Some(self.seconds),
            ..self.path
        }
    }
}

/// Where a stop is, on the grid.
fn offset(stop: &Stop) -> DVec2 {
    Point::snap(stop.at).unwrap_or_default().metres()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mover(repeat: Repeat) -> Mover {
        let stop = |x: f64, wait: f64, seconds: f64, easing| Stop {
            at: DVec2::new(x, 0.1),
            wait,
            seconds,
            easing,
        };
        let end = if repeat == Repeat::Loop { 4.0 } else { 0.0 };
        Mover {
            id: "lift".into(),
            features: Vec::new(),
            path: vec![
                stop(0.0, 1.0, 2.0, Easing::Eased),
                stop(8.0, 0.5, 1.0, Easing::Linear),
                stop(5.0, 0.0, end, Easing::Linear),
            ],
            repeat,
            starts: Starts::AtOnce,
            ..Mover::default()
        }
    }

    /// The offset and the velocity along x at some times.
    fn along(repeat: Repeat, times: &[f64]) -> Vec<(f64, f64)> {
        let path = path(&mover(repeat));
        let at = |&t: &f64| {
            let piece = path.piece_at(t, Some(0.0));
            (piece.offset(t).x, piece.velocity(t).x)
        };
        times.iter().map(at).collect()
    }

    #[test]
    fn an_eased_way_is_fastest_in_its_middle_and_ends_at_rest() {
        let found = along(Repeat::Once, &[0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.25]);
        let expected = [
            (0.0, 0.0),
            (0.0, 0.0),
            (1.0, 4.0),
            (4.0, 8.0),
            (7.0, 4.0),
            (8.0, 0.0),
            (8.0, 0.0),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn what_follows_the_last_stop_is_the_first_the_way_back_or_nothing() {
        let times = [4.0, 4.5, 5.5, 8.5, 9.5];
        let ends = |repeat| {
            along(repeat, &times)
                .into_iter()
                .map(|p| p.0)
                .collect::<Vec<_>>()
        };
        assert_eq!(ends(Repeat::Once), [6.5, 5.0, 5.0, 5.0, 5.0]);
        assert_eq!(ends(Repeat::Loop), [6.5, 5.0, 3.75, 0.0, 0.0]);
        assert_eq!(ends(Repeat::PingPong), [6.5, 5.0, 8.0, 0.0, 1.0]);
        let path = path(&mover(Repeat::PingPong));
        assert_eq!(path.period, Some(8.0));
    }

    #[test]
    fn stops_lie_on_the_grid() {
        for piece in path(&mover(Repeat::Loop)).pieces {
            let steps = piece.p0 * 65536.0;
            assert_eq!(steps, steps.round());
        }
    }
}
