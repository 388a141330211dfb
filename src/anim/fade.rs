//! A change of movement without a jump: what the old pose had beyond the new one dies away, from the speed that it had.
//!
//! Unlike a mix of two running clips this needs no memory of where the old ones were, and may be broken off at any time
//! by the next change. In closed form: a critically damped spring for each bone, so the frame rate does not matter.

use super::pose::Pose;
use super::skeleton::MAX_BONES;
use glam::{Quat, Vec3};

/// Share of a fade's time in which the spring loses a factor of e: the rest is then below 2 %.
const SHARE: f32 = 1.0 / 6.0;
/// Fastest turn that is kept from the old movement, rad/s, and fastest shift, m/s: more would overshoot.
const FASTEST: (f32, f32) = (12.0, 3.0);

/// What one bone still has of the old pose: a turn as an axis times an angle, a shift; and their speeds at the start.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Rest {
    turn: Vec3,
    turning: Vec3,
    shift: Vec3,
    shifting: Vec3,
}

/// A change of movement that is dying away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fade {
    began: f64,
    rate: f32,
    rests: [Rest; MAX_BONES],
}

/// The turn from one to the other as an axis times an angle.
fn turn_between(from: Quat, to: Quat) -> Vec3 {
    let way = from.conjugate() * to;
    let way = if way.w < 0.0 { -way } else { way };
    way.to_scaled_axis()
}

impl Fade {
    /// No change.
    pub fn none() -> Fade {
        Fade {
            began: f64::NEG_INFINITY,
            rate: 1.0,
            rests: [Rest::default(); MAX_BONES],
        }
    }

    /// A change from an old pose to a new one at a time, within so many seconds; `earlier` is the old pose some seconds before.
    pub fn new(began: f64, seconds: f32, old: &Pose, earlier: (&Pose, f32), new: &Pose) -> Fade {
        let (earlier, span) = earlier;
        let mut fade = Fade::none();
        fade.began = began;
        fade.rate = 1.0 / (SHARE * seconds.max(1e-3));
        let speed = |way: Vec3, fastest: f32| match span > 1e-4 {
            true => (way / span).clamp_length_max(fastest),
            false => Vec3::ZERO,
        };
        for (i, rest) in fade.rests.iter_mut().enumerate() {
            let (old, was, new) = (&old.bones[i], &earlier.bones[i], &new.bones[i]);
            rest.turn = turn_between(new.turn, old.turn);
            rest.turning = speed(turn_between(was.turn, old.turn), FASTEST.0);
            rest.shift = old.place - new.place;
            rest.shifting = speed(old.place - was.place, FASTEST.1);
        }
        fade
    }

    /// Adds what is left of the old pose at a time.
    pub fn apply(&self, time: f64, pose: &mut Pose) {
        let age = (time - self.began) as f32;
        let decay = (-self.rate * age).exp();
        if decay < 1e-4 {
            return;
        }
        // x(t) = (x0 + (v0 + rate x0) t) e^(-rate t)
        let left = |start: Vec3, speed: Vec3| (start + (speed + start * self.rate) * age) * decay;
        for (bone, rest) in pose.bones.iter_mut().zip(&self.rests) {
            bone.turn =
                (bone.turn * Quat::from_scaled_axis(left(rest.turn, rest.turning))).normalize();
            bone.place += left(rest.shift, rest.shifting);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::trs::angle_between;
    use super::*;

    fn turned(angle: f32) -> Pose {
        let mut pose = Pose::default();
        pose.bones[0].turn = Quat::from_rotation_x(angle);
        pose
    }

    #[test]
    fn it_starts_at_the_old_pose_and_ends_at_the_new_one() {
        let (old, new) = (turned(1.0), turned(-0.5));
        let fade = Fade::new(2.0, 0.2, &old, (&old, 0.01), &new);
        let at = |time: f64| {
            let mut pose = new;
            fade.apply(time, &mut pose);
            angle_between(pose.bones[0].turn, new.bones[0].turn)
        };
        assert!((at(2.0) - 1.5).abs() < 1e-5, "{}", at(2.0));
        assert!(at(2.2) < 0.03 && at(3.0) < 1e-6, "{}", at(2.2));
        let steps: Vec<f32> = (0..200).map(|i| at(2.0 + f64::from(i) * 0.001)).collect();
        assert!(
            steps
                .windows(2)
                .all(|pair| pair[1] <= pair[0] && pair[0] - pair[1] < 0.03)
        );
    }

    #[test]
    fn the_speed_goes_on() {
        let (earlier, old) = (turned(0.9), turned(1.0));
        let fade = Fade::new(0.0, 0.3, &old, (&earlier, 0.02), &turned(0.0));
        let mut pose = turned(0.0);
        fade.apply(0.002, &mut pose);
        let angle = angle_between(pose.bones[0].turn, Quat::IDENTITY);
        assert!((angle - 1.01).abs() < 0.003, "5 rad/s for 2 ms: {angle}");
    }
}
