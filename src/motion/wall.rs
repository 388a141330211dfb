//! At walls: what is too steep to stand on and no ceiling. A wall that is pushed against slows a fall, and it can be jumped
//! off, also for a moment after coming off it.

use super::body::{Body, Control, EventKind, Mode, Next, Surface, Trace};
use super::grip::Grip;
use super::law::{self, Cut, Law};
use super::terrain::Terrain;
use super::track::walkable;
use crate::mesh::Segment;
use crate::tune::Motion;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A wall may overhang by one part in so many: levels are drawn by hand and rotated.
const OVERHANG: i64 = 8;

/// The direction that a wall jump holds against the stick, until a time or the first contact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lock {
    /// When it ends, s.
    pub until: f64,
    /// The wish for the run that counts instead of the stick's.
    pub run: f64,
}

/// A wall that the body came off.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OffWall {
    /// When, s.
    pub at: f64,
    /// The sign of x that leads away from it.
    pub away: f64,
}

/// Whether a feature edge is a wall: too steep to stand on, and leaning back, upright, or overhanging by at most 1 in 8.
/// What overhangs more is a ceiling. Exact.
pub fn is_wall(segment: &Segment, max_slope: f64) -> bool {
    // The free side is on the right of a -> b: an edge that runs to the right there faces down.
    let (dx, dy) = segment.direction();
    !walkable(segment, max_slope) && OVERHANG * dx <= dy.abs()
}

impl Body {
    /// The direction that a wall jump holds, while it does.
    pub(super) fn lock(&self) -> Option<Lock> {
        match &self.mode {
            Mode::Air(air) => air.lock,
            _ => None,
        }
    }

    /// The sign of x that leads away from the wall that the body is on; `None` if it is not on one.
    pub(super) fn away_from_wall(&self, terrain: &Terrain) -> Option<f64> {
        let Mode::Surface(on) = &self.mode else {
            return None;
        };
        let mesh = self.ground(terrain);
        mesh.is_wall(on.segment).then(|| on.track.normal.x.signum())
    }

    /// On a wall that the stick pushes into, without the wish to fall fast.
    pub(super) fn is_slowed_by_wall(&self, terrain: &Terrain) -> bool {
        let pushes = |away: f64| self.control.run * away < 0.0;
        terrain.tuning.wall_slide_speed > 0.0
            && !self.control.down
            && self.away_from_wall(terrain).is_some_and(pushes)
    }

    /// Remembers the wall that the body is about to leave: a jump from it is granted a little longer.
    pub(super) fn come_off_wall(&mut self, terrain: &Terrain) {
        let at = self.time;
        self.off_wall = self
            .away_from_wall(terrain)
            .map(|away| OffWall { at, away });
    }

    /// A jump from the wall that the body is on, or came off not too long ago.
    pub(super) fn wall_jump_if_there(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let t = terrain.tuning;
        // One who hangs climbs with a jump, unless the stick leads away.
        let hangs = matches!(self.grip(), Grip::Ledge | Grip::Over);
        if hangs && !self.turns_from_wall(terrain) {
            return;
        }
        let (left, touching) = match &self.mode {
            Mode::Air(air) => (self.off_wall, air.touching),
            _ => (None, [self.segment(), None]),
        };
        let left = left.filter(|wall| self.within(Some(wall.at), t.wall_grace));
        let away = self
            .away_from_wall(terrain)
            .or_else(|| left.map(|wall| wall.away));
        let Some(away) = away else {
            return;
        };
        let leap = match (t.wall_jump_up > 0.0, self.grip()) {
            (true, _) => DVec2::new(away * t.wall_jump_out, t.wall_jump_up),
            (false, Grip::None) => return,
            // Without wall jumps, one who holds on can still hop off.
            (false, _) => DVec2::new(away, 1.0) * (0.5 * t.jump_speed),
        };
        let (p, v) = (self.local_position(), self.leap(leap, away, terrain));
        let face = self.face(&self.ground(terrain));
        self.fly(p, v, face, touching);
        if let (true, Mode::Air(air)) = (t.wall_jump_lock > 0.0, &mut self.mode) {
            let until = self.time + t.wall_jump_lock;
            air.lock = Some(Lock { until, run: away });
        }
        self.log(EventKind::WallJumped, trace);
        self.rise(terrain);
    }

    /// The end of a wall jump's hold on the direction, if that comes first.
    pub(super) fn sooner_if_unlocked(&self, next: Option<(f64, Next)>) -> Option<(f64, Next)> {
        let unlock = self.lock().map(|lock| (lock.until, Next::Unlock));
        Next::sooner(next, unlock)
    }

    /// From now on the stick steers again.
    pub(super) fn unlock(&mut self, trace: &mut Trace) {
        self.rebase();
        if let Mode::Air(air) = &mut self.mode {
            air.lock = None;
        }
        self.log(EventKind::Unlocked, trace);
    }
}

impl Surface {
    /// The acceleration of a slide along what is too steep, and the speed at which it changes. `slows`: against a wall that
    /// brakes a fall down to the speed of a wall slide. `cut`: how its rise is braked. `carried`: the acceleration of what carries
    /// the body.
    pub(super) fn choose_slide(
        &mut self,
        control: &Control,
        slows: bool,
        cut: Option<Cut>,
        carried: DVec2,
        t: &Motion,
    ) {
        let DVec2 { x: run, y: climb } = self.track.tangent;
        let fall = law::rise_or_fall(self.u0 * climb, cut, control, t);
        let slowest = -climb.signum() * t.wall_slide_speed;
        let excess = (self.u0 - slowest) * slowest.signum();
        let drift = -self.track.tangent.dot(carried);
        let sinks = (fall.accel * climb + drift) * slowest > 0.0;
        if slows && (excess > 0.0 || excess == 0.0 && sinks) {
            let brake = Law::towards(self.u0, slowest, t.wall_slide_brake);
            self.accel = brake.accel;
            self.limit = brake.until.zip(brake.time_left(self.u0));
            self.limit = self.limit.map(|(until, left)| (self.t0 + left, until));
            return;
        }
        if drift != 0.0 {
            let [a, b, c, d] = law::marks_of_fall(control, t).map(|mark| mark / climb);
            let slowest = if slows { slowest } else { 0.0 };
            let fall = |u: f64| law::rise_or_fall(u * climb, cut, control, t).accel * climb;
            let [from, to] = cut.map_or([0.0; 2], |cut| [cut.from / climb, cut.to / climb]);
            return self.choose_drift(fall, drift, &[a, b, c, d, slowest, from, to]);
        }
        self.accel = fall.accel * climb;
        // The speeds at which the fall changes, the slide turns, the push of the stick ends, and the wall begins to brake.
        let marks = [
            fall.until.map(|until| until / climb),
            Some(0.0),
            Some(control.run * t.run_speed / run),
            slows.then_some(slowest),
        ];
        let after = |&mark: &f64| mark.is_finite() && (mark - self.u0) * self.accel > 0.0;
        let first = |a: &f64, b: &f64| (a - self.u0).abs().total_cmp(&(b - self.u0).abs());
        let mark = marks.into_iter().flatten().filter(after).min_by(first);
        self.limit = mark.map(|mark| (self.t0 + (mark - self.u0) / self.accel, mark));
    }
}
