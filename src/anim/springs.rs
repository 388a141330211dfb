//! What hangs and follows: the cape, the lantern, the crest. Points on threads of fixed length, moved by weight and wind.
//!
//! The steps are at whole multiples of a fixed time, whatever the pictures' rate, and the state between two of them is
//! found on the way: so nothing here depends on the frame rate.

use glam::Vec3;
use std::f32::consts::TAU;

/// Seconds of one step.
pub const STEP: f64 = 1.0 / 240.0;
/// Fastest that a point moves, m/s: a bound for jolts, far above what weight and wind do.
const FASTEST: f32 = 25.0;
/// How often the air beats, 1/s, and which way.
const BEATS: [f32; 2] = [4.3, 7.3];
const BEATEN: Vec3 = Vec3::new(0.0, 1.0, 0.35);
/// Share of its constraint's work that a point takes from the speed of the one above.
const PULLS: f32 = 0.85;
/// Longest time that is caught up with, s; after more the threads hang still.
const LONGEST: f64 = 0.5;

/// What a thread is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stuff {
    /// Downward acceleration, m/s^2.
    pub weight: f32,
    /// How fast it takes on the speed of the air, 1/s.
    pub drag: f32,
    /// How strongly it goes back to its rest, 1/s^2.
    pub stiffness: f32,
    /// How fast it takes on the speed of its fixed end, 1/s.
    pub damping: f32,
    /// The farthest that it bends from one point to the next, as the cosine.
    pub bend: f32,
}

/// Where a thread is held at a moment, in a space that moves with the figure's foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hold<const N: usize> {
    /// The fixed end.
    pub anchor: Vec3,
    /// Where each point would be if nothing moved.
    pub rest: [Vec3; N],
    /// Velocity of the air against the level, m/s.
    pub wind: Vec3,
    /// How strongly it beats, m/s.
    pub beat: f32,
}

/// A thread of points, each at a fixed distance from the one before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thread<const N: usize> {
    /// Number of the last step.
    step: i64,
    time: f64,
    /// At the last step: places, speeds, and the fixed end.
    points: [Vec3; N],
    speeds: [Vec3; N],
    anchor: Vec3,
    hold: Hold<N>,
}

impl<const N: usize> Thread<N> {
    /// At rest at a time.
    pub fn new(time: f64, hold: Hold<N>) -> Thread<N> {
        Thread {
            step: (time / STEP).floor() as i64,
            time,
            points: hold.rest,
            speeds: [Vec3::ZERO; N],
            anchor: hold.anchor,
            hold,
        }
    }

    /// Lets time pass. `moved` is how far the space has come since the last time: the points stay behind.
    /// `keep` puts a point that is somewhere where it may not be back.
    pub fn advance(
        &mut self,
        time: f64,
        hold: Hold<N>,
        moved: Vec3,
        stuff: &Stuff,
        keep: impl Fn(Vec3) -> Vec3,
    ) {
        let span = time - self.time;
        if !(0.0..LONGEST).contains(&span) {
            *self = Thread::new(time, hold);
            return;
        }
        self.points.iter_mut().for_each(|p| *p -= moved);
        self.anchor -= moved;
        let mut from = self.hold;
        from.anchor -= moved;
        from.rest.iter_mut().for_each(|p| *p -= moved);
        let last = (time / STEP).floor() as i64;
        while self.step < last {
            self.step += 1;
            let share = match span > 0.0 {
                true => (self.step as f64 * STEP - self.time) / span,
                false => 1.0,
            };
            let left = moved * (1.0 - share as f32);
            let keep = |p: Vec3| keep(p + left) - left;
            self.take_step(&from.towards(&hold, share as f32), stuff, &keep);
        }
        (self.time, self.hold) = (time, hold);
    }

    fn take_step(&mut self, hold: &Hold<N>, stuff: &Stuff, keep: &impl Fn(Vec3) -> Vec3) {
        let dt = STEP as f32;
        let seconds = (self.step as f64 * STEP).rem_euclid(3600.0) as f32;
        let [slow, fast] = BEATS.map(|rate| (TAU * rate * seconds).sin());
        let wind = hold.wind + BEATEN * (hold.beat * (slow + 0.6 * fast));
        let held = ((hold.anchor - self.anchor) / dt).clamp_length_max(FASTEST);
        let (mut above, mut along) = (hold.anchor, None);
        for i in 0..N {
            let (now, speed) = (self.points[i], self.speeds[i]);
            let pull = (hold.rest[i] - now) * stuff.stiffness - (speed - held) * stuff.damping;
            let wished = speed + (pull + Vec3::NEG_Y * stuff.weight) * dt;
            // The air's share in closed form, so that no drag is too strong for the step.
            let speed = wind + (wished - wind) * (-stuff.drag * dt).exp();
            let start = if i == 0 {
                hold.anchor
            } else {
                hold.rest[i - 1]
            };
            let length = start.distance(hold.rest[i]);
            let free = now + speed * dt;
            let way = (keep(free) - above).normalize_or(Vec3::NEG_Y);
            let way = along.map_or(way, |along| bent(along, way, stuff.bend));
            let next = above + way * length;
            self.speeds[i] = ((next - now) / dt).clamp_length_max(FASTEST);
            // Each point is put at its distance without pulling at the one above; what that lacks is taken from its speed.
            if i > 0 {
                self.speeds[i - 1] -= (next - free) * (PULLS / dt);
                self.speeds[i - 1] = self.speeds[i - 1].clamp_length_max(FASTEST);
            }
            self.points[i] = next;
            (above, along) = (next, Some(way));
        }
        self.anchor = hold.anchor;
    }

    /// The fixed end at that time.
    pub fn anchor(&self) -> Vec3 {
        self.hold.anchor
    }

    /// Where the points are at the time that was last advanced to.
    pub fn points(&self) -> [Vec3; N] {
        let share = (self.time / STEP - self.step as f64).clamp(0.0, 1.0) as f32;
        let mut points = self.points;
        for (point, speed) in points.iter_mut().zip(&self.speeds) {
            *point += *speed * (share * STEP as f32);
        }
        points
    }
}

/// A direction that is bent no further than this from the one before.
fn bent(along: Vec3, way: Vec3, least: f32) -> Vec3 {
    let cos = along.dot(way);
    let aside = (way - along * cos).normalize_or_zero();
    match cos < least && aside != Vec3::ZERO {
        true => along * least + aside * (1.0 - least * least).sqrt(),
        false => way,
    }
}

impl<const N: usize> Hold<N> {
    fn towards(&self, to: &Hold<N>, share: f32) -> Hold<N> {
        let mut hold = *self;
        hold.anchor = self.anchor.lerp(to.anchor, share);
        hold.wind = self.wind.lerp(to.wind, share);
        hold.beat += (to.beat - self.beat) * share;
        for (rest, to) in hold.rest.iter_mut().zip(&to.rest) {
            *rest = rest.lerp(*to, share);
        }
        hold
    }
}
