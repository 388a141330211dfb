//! Pieces: the constant accelerations of now, and what ends them first.

use super::body::{Body, MARGIN, Mode, Next};
use super::double::{Double, Vector};
use super::flight;
use super::law;

impl Body<'_> {
    /// In the air both laws act; on a side one of them, along it.
    pub fn acceleration(&self) -> Vector {
        match self.mode {
            Mode::Air { v, .. } => Vector::new(
                law::steer(v.x, &self.control, self.tuning).accel,
                self.fall(v.y).accel,
            ),
            Mode::On {
                side, u, against, ..
            } => self.side(side).tangent * self.along(side, u, against).accel,
            Mode::Rest { .. } => Vector::default(),
        }
    }

    /// The acceleration along a side: the wish on ground; on what is too steep, as much of the fall as it lets through.
    fn along(&self, side: usize, u: Double, against: f64) -> law::Drive {
        let tangent = self.side(side).tangent;
        let mut drive = if self.walkable(side) {
            law::walk(u, &self.control, self.crouched, self.tuning)
        } else {
            let fall = self.fall(u * tangent.y);
            let steep = !tangent.y.is_tiny();
            law::Drive {
                accel: fall.accel * tangent.y,
                until: fall.until.filter(|_| steep).map(|v| v / tangent.y),
            }
        };
        if u.is_tiny() && drive.accel.sign() * against > 0.0 {
            (drive.accel, drive.until) = (Double::ZERO, None);
        }
        drive
    }

    /// The end of the piece that begins now: how long from now, and what.
    pub fn next(&mut self) -> Option<(Double, Next)> {
        let motion = self.next_of_motion();
        first(motion, self.cut_ahead().map(|dt| (dt, Next::Cut)))
    }

    fn next_of_motion(&mut self) -> Option<(Double, Next)> {
        match self.mode {
            Mode::Air { p, v } => {
                let accel = self.acceleration();
                let (x, y) = (law::steer(v.x, &self.control, self.tuning), self.fall(v.y));
                let lasts = |drive: law::Drive, v: Double| {
                    drive.until.map(|until| ((until - v) / drive.accel, until))
                };
                let (x, y) = (lasts(x, v.x), lasts(y, v.y));
                let limit = [x, y]
                    .into_iter()
                    .flatten()
                    .map(|l| l.0)
                    .reduce(Double::min);
                let reached =
                    |l: Option<(Double, Double)>| l.filter(|l| limit == Some(l.0)).map(|l| l.1);
                let limit = limit.map(|dt| (dt, Next::Limit([reached(x), reached(y)])));
                let hit = flight::first_hit(self, p, v, accel, limit.map(|l| l.0));
                first(hit.map(|(dt, side)| (dt, Next::Hit(side))), limit)
            }
            Mode::On {
                side,
                s,
                u,
                against,
            } => self.next_along(side, s, u, against),
            Mode::Rest { .. } => None,
        }
    }

    fn next_along(
        &mut self,
        side: usize,
        s: Double,
        u: Double,
        against: f64,
    ) -> Option<(Double, Next)> {
        let drive = self.along(side, u, against);
        let direction = if u.is_tiny() {
            drive.accel.sign()
        } else {
            u.sign()
        };
        if direction == 0.0 {
            return None;
        }
        let tangent = self.side(side).tangent;
        // Also where a slide turns, and where the push of the stick ends.
        let wish = Double::from(self.control.run) * self.tuning.run_speed.into();
        let turns = [
            Some(Double::ZERO),
            (!tangent.x.is_tiny()).then(|| wish / tangent.x),
        ];
        let marks = drive.until.into_iter().chain(turns.into_iter().flatten());
        let after =
            |mark: &Double| !(*mark - u).is_tiny() && (*mark - u).sign() * drive.accel.sign() > 0.0;
        let limit = marks
            .filter(after)
            .map(|mark| ((mark - u) / drive.accel, mark))
            .reduce(|a, b| if b.0 < a.0 { b } else { a })
            .map(|(dt, mark)| (dt, Next::Limit([Some(mark), None])));
        let sign = Double::from(direction);
        let distance = ((self.side(side).end(direction) - s) * sign).max(Double::ZERO);
        let end = self.reach(distance, u.abs(), drive.accel * sign);
        first(end.map(|dt| (dt, Next::End(direction))), limit)
    }

    /// When a motion that starts with a speed and does not turn covers a distance ahead.
    fn reach(&mut self, distance: Double, u: Double, a: Double) -> Option<Double> {
        let square = u * u + a * distance * 2.0.into();
        if distance.is_tiny() {
            return (u.sign() > 0.0 || a.sign() > 0.0).then_some(Double::ZERO);
        }
        if a.sign() < 0.0 {
            self.sure(
                square,
                2.0 * a.abs().to_f64() * MARGIN,
                "a stop at a corner",
            );
        }
        (square.sign() >= 0.0 && (u.sign() > 0.0 || a.sign() > 0.0))
            .then(|| distance * 2.0.into() / (u + square.sqrt()))
    }
}

/// The earlier of an event and a limit; the event where they coincide.
fn first(event: Option<(Double, Next)>, limit: Option<(Double, Next)>) -> Option<(Double, Next)> {
    match (event, limit) {
        (Some(e), Some(l)) if l.0 < e.0 => Some(l),
        (None, limit) => limit,
        (event, _) => event,
    }
}
