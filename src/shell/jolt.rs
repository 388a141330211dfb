//! What a hard landing does to the picture: the camera dips and comes back. A function of the view alone, so that it
//! stands still with the world and is the same at any frame rate. The camera itself never shakes.

use crate::game::View;
use crate::game::camera::Pose;
use glam::DVec3;
use std::f64::consts::TAU;

/// Speeds into the ground at which it begins and is full, m/s: above that of a plain jump, at that of a fast fall.
const SPEEDS: (f64, f64) = (19.0, 34.0);
/// The deepest dip, m; how fast it dies away, 1/s; how often it swings, 1/s; when it is over, s.
const DEPTH: f64 = 0.14;
const FADING: f64 = 11.0;
const SWINGS: f64 = 7.0;
const OVER: f64 = 0.5;

/// A pose as the last landing shakes it; `share` (0 to 1) is how much the player wants of that.
pub fn shaken(pose: Pose, view: &View, share: f64) -> Pose {
    let aside = DVec3::Y * (dip(view.time - view.landed_at, view.landed_speed) * share);
    Pose {
        eye: pose.eye + aside,
        target: pose.target + aside,
        ..pose
    }
}

/// How far the camera is off its height, m, so many seconds after a landing at a speed.
fn dip(age: f64, speed: f64) -> f64 {
    if !(0.0..OVER).contains(&age) {
        return 0.0;
    }
    let strength = ((speed - SPEEDS.0) / (SPEEDS.1 - SPEEDS.0)).clamp(0.0, 1.0);
    let left = (1.0 - age / OVER) * (-FADING * age).exp();
    -DEPTH * strength * left * (TAU * SWINGS * age).sin()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_hard_landings_shake_and_not_for_long() {
        let most = |speed: f64| {
            let ages = (0..500).map(|n| dip(f64::from(n) * 0.001, speed).abs());
            ages.fold(0.0, f64::max)
        };
        assert_eq!(most(17.0), 0.0, "after a full jump on level ground");
        assert!(most(24.0) > 0.01, "after a long fall");
        assert!(most(24.0) < most(34.0) && most(34.0) == most(1e300));
        assert!(most(1e300) < DEPTH);
        assert_eq!((dip(0.0, 34.0), dip(OVER, 34.0)), (0.0, 0.0));
        assert_eq!((dip(-1.0, 34.0), dip(f64::INFINITY, 34.0)), (0.0, 0.0));
    }

    #[test]
    fn it_goes_down_first_and_without_jumps() {
        assert!(dip(0.02, 34.0) < 0.0);
        let steps = (1..500).map(|n| {
            let age = f64::from(n) * 0.001;
            (dip(age, 34.0) - dip(age - 0.001, 34.0)).abs()
        });
        assert!(steps.fold(0.0, f64::max) < 0.01, "metres in a millisecond");
    }
}
