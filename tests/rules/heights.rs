//! The greatest height of a run does not depend on where its ticks end.

use super::story::{RATES, hall, run, stage};
use edgewalker::cli::summary::Summary;
use edgewalker::game::{Input, World};
use edgewalker::tune::{Motion, Tuning};
use std::sync::Arc;

/// How high a full jump is, m: against half of gravity where it is slow.
fn jump() -> f64 {
    let t = Motion::default();
    let slow = t.apex_speed * t.apex_speed / (2.0 * t.gravity);
    t.jump_speed * t.jump_speed / (2.0 * t.gravity) - slow + slow / t.apex_gravity
}

#[test]
fn the_highest_is_the_apex_at_every_rate() {
    let lift = "(id: \"lift\", features: [(id: \"deck\", outline: [(4,-2),(8,-2),(8,0),(4,0)])], \
        path: [(at: (0,0), wait: 0.9, seconds: 1.37, easing: Eased),(at: (0,3), seconds: 1.01)])";
    let stage = stage(&hall("", lift));
    let keys = Input {
        jump: true,
        ..run(0)
    };
    let highest = |rate: u32, script: &[(u32, Input)]| {
        let mut world = World::new(Arc::clone(&stage), rate, 0);
        let mut summary = Summary::new(&world);
        for &(tenths, input) in script {
            for _ in 0..tenths * rate / 10 {
                world.step(input, &Tuning::default());
                summary.watch(&world);
            }
        }
        summary.highest
    };
    for rate in RATES {
        let jumped = highest(rate, &[(1, run(0)), (9, keys)]);
        assert!((jumped - jump()).abs() < 1e-12, "{rate} Hz: {jumped} m");
        // On the deck to its upper end, at a time between all ticks, and down again.
        let rode = highest(rate, &[(7, run(1)), (33, run(0))]);
        assert!((rode - 3.0).abs() < 1e-12, "{rate} Hz: {rode} m");
    }
}
