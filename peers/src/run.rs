//! Running a mover through a scene: error and time.

use crate::movers::Mover;
use crate::scene::Scene;

/// How many ticks a scene has.
pub fn ticks(scene: &Scene, rate: f64) -> u32 {
    (scene.seconds * rate).round() as u32
}

/// The largest distance from where the body should be, at the ends of all ticks, m. Infinite if it is nowhere.
pub fn error(mover: &mut dyn Mover, scene: &Scene, rate: f64) -> f64 {
    mover.reset();
    let mut largest = 0.0f64;
    for tick in 1..=ticks(scene, rate) {
        mover.tick(rate, tick);
        let time = f64::from(tick) / rate;
        if let Some(exact) = (scene.exact)(mover.shape(), time) {
            let error = (mover.at() - exact).length();
            largest = largest.max(if error.is_finite() {
                error
            } else {
                f64::INFINITY
            });
        }
    }
    largest
}

/// The same run without looking.
pub fn go(mover: &mut dyn Mover, scene: &Scene, rate: f64) {
    mover.reset();
    for tick in 1..=ticks(scene, rate) {
        mover.tick(rate, tick);
    }
}
