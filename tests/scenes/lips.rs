//! Lips of at most two grid steps, as rounding leaves them, in the middle of a wall: they neither stop who climbs nor hide the
//! ledge above, and they are no ledges.

use super::ledges::hanging;
use super::rig::*;
use super::walls::at_all_rates;
use edgewalker::geom::STEP;
use edgewalker::motion::EventKind;
use edgewalker::motion::grip::Grip;

/// A wall at x = 0 up to a height, from there to y = 0 so many steps further in (or out).
fn wall(lip: f64, steps: i32, climbable: bool) -> Scene {
    let x = f64::from(steps) * STEP;
    hanging(Scene::point())
        .rect((0.0, 5.0), (-60.0, lip))
        .traits(|t| t.climbable = climbable)
        .rect((x, 5.0), (lip, 0.0))
        .traits(|t| t.climbable = climbable)
}

const LIPS: [i32; 4] = [-2, -1, 1, 2];

#[test]
fn a_lip_in_a_wall_does_not_stop_a_climber() {
    for steps in LIPS {
        let scene = wall(-2.0, steps, true).tune(|t| t.ledge_hang = 0.0);
        at_all_rates(&scene, |run, rate| {
            run.spawn(0.0, -4.0)
                .hold(1.0)
                .up(true)
                .ticks(2 * rate as u32, rate);
            // 4 m/s at 60 m/s^2: 4 m take 1 s and 1/30.
            close(
                run.when(|k| k == EventKind::Landed(0.0)),
                1.0 + 1.0 / 30.0,
                1e-12,
            );
            run.near(f64::from(steps) * STEP, 0.0, 0.0);
            assert!(run.supported());
        });
    }
    // Down over it too. A step deeper, it is a ledge to stand on, or a ceiling.
    for steps in [-3, -2, -1, 1, 2, 3] {
        let scene = wall(-2.0, steps, true).tune(|t| t.ledge_hang = 0.0);
        at_all_rates(&scene, |run, rate| {
            let lip = steps.abs() < 3;
            run.spawn(f64::from(steps) * STEP, -1.0)
                .hold(1.0)
                .down(true);
            run.ticks(rate as u32, rate);
            let far = -1.0 - 4.0 + 2.0 / 15.0;
            if lip {
                run.near(0.0, far, 1e-12);
                assert_eq!(run.body().grip(), Grip::Wall);
            } else {
                run.near(f64::from(steps) * STEP, -2.0, 1e-12);
            }
            run.spawn(0.0, -4.0)
                .hold(1.0)
                .up(true)
                .ticks(rate as u32, rate);
            assert_eq!(run.at().y > -2.0, lip);
        });
    }
}

#[test]
fn a_ledge_is_caught_and_climbed_over_lips_below_it() {
    // At the wall after 1/4 s, 1/8 m lower than one hangs: the lip above the hands' way, or on it.
    for lip in [-0.5, -1.3125] {
        for steps in LIPS {
            at_all_rates(&wall(lip, steps, false), |run, rate| {
                run.spawn(-1.0, -1.25 - 0.125 + 0.9375).velocity(4.0, 0.0);
                run.ticks(rate as u32, rate);
                close(run.when(|k| k == EventKind::Grabbed), 0.25, 1e-12);
                let inwards = f64::from(steps) * STEP;
                run.near(if lip < -1.0 { inwards } else { 0.0 }, -1.25, 0.0);
                run.frozen(60).up(true).ticks(rate as u32, rate);
                run.near(inwards, 0.0, 0.0);
                assert!(run.supported());
            });
        }
    }
}

#[test]
fn a_slide_down_a_wall_takes_hold_of_the_ledge_above_a_lip_that_leans_out() {
    at_all_rates(&wall(-0.5, -1, false), |run, rate| {
        run.spawn(-STEP, -0.25).hold(1.0).ticks(rate as u32, rate);
        run.near(0.0, -1.25, 0.0);
        assert_eq!(run.body().grip(), Grip::Ledge);
    });
}
