//! Stairs: floor snap on the way down, step-up on the way up, and what neither of them does.

use super::rig::*;
use edgewalker::geom::{Collider, STEP};
use edgewalker::motion::{Control, EventKind};

/// Metres on the grid.
fn grid(metres: f64) -> f64 {
    (metres / STEP).round() * STEP
}

fn snapped(run: &Run) -> Vec<f64> {
    let depth = |k| match k {
        EventKind::Snapped(depth) => Some(depth),
        _ => None,
    };
    run.kinds().into_iter().filter_map(depth).collect()
}

fn stepped(run: &Run) -> Vec<f64> {
    let height = |k| match k {
        EventKind::SteppedUp(height) => Some(height),
        _ => None,
    };
    run.kinds().into_iter().filter_map(height).collect()
}

/// A floor up to x = 0, then stairs: each so deep, and by `rise` higher than the one before.
fn stairs(scene: Scene, n: u32, deep: f64, rise: f64) -> Scene {
    let mut top = vec![(-10.0, 0.0)];
    for i in 0..n {
        let (x, y) = (f64::from(i) * deep, f64::from(i) * rise);
        top.extend([(x, y), (x, y + rise)]);
    }
    let (x, y) = top[top.len() - 1];
    top.push((x + 20.0, y));
    scene.under(&top, -20.0)
}

#[test]
fn scene_44_stairs_down_are_walked_without_leaving_them() {
    let (deep, drop) = (grid(0.3), grid(0.2));
    for scene in [Scene::point(), Scene::boxed()] {
        let scene = stairs(scene, 40, deep, -drop).tune(|t| t.floor_snap = 0.3);
        scene.each(|run| {
            for rate in [30.0, 60.0, 240.0] {
                run.spawn(-1.0, 0.0).walk(5.0);
                for tick in 1..=(2.0 * rate) as u32 {
                    run.advance(f64::from(tick) / rate);
                    assert!(run.supported());
                }
                // The body stands on a stair until its last point has left it.
                let half = if run.body().position().x == 0.0 {
                    0.0
                } else {
                    run.at().x - 9.0
                };
                assert!(half.abs() <= 1e-11, "no time lost: {}", run.at());
                assert!(snapped(run).iter().all(|d| (d - drop).abs() <= 1e-12));
            }
        });
    }
    // Each stair at its own time: the first at 1 m / 5 m/s.
    stairs(Scene::point(), 40, deep, -drop)
        .tune(|t| t.floor_snap = 0.3)
        .each(|run| {
            run.spawn(-1.0, 0.0).walk(5.0).advance(2.0);
            close(run.when(|k| matches!(k, EventKind::Snapped(_))), 0.2, 1e-13);
            let count = snapped(run).len();
            assert_eq!(count as f64, (9.0 / deep).floor() + 1.0);
            run.near(9.0, -(count as f64) * drop, 1e-11);
        });
}

#[test]
fn scene_44_the_limit_still_snaps_and_a_step_more_does_not() {
    let limit = grid(0.3);
    for (drop, snaps) in [(limit, true), (limit + STEP, false)] {
        for scene in [Scene::point(), Scene::boxed()] {
            let scene = stairs(scene, 1, 1.0, -drop).tune(|t| t.floor_snap = 0.3);
            scene.each(|run| {
                run.spawn(-1.0, 0.0).walk(5.0).advance(0.3);
                assert_eq!(run.supported(), snaps);
                assert_eq!(run.kinds().contains(&EventKind::Left), !snaps);
                assert_eq!(snapped(run).len(), usize::from(snaps));
            });
        }
    }
    // Without it he falls, however little.
    stairs(Scene::point(), 1, 1.0, -grid(0.01)).each(|run| {
        run.spawn(-1.0, 0.0).walk(5.0).advance(0.21);
        assert!(run.airborne());
    });
}

#[test]
fn off_an_overhang_onto_the_ground_below() {
    for scene in [Scene::point(), Scene::boxed()] {
        let scene = scene
            .rect((-10.0, 0.0), (-0.0625, 0.0))
            .rect((-10.0, 10.0), (-1.0, -0.25))
            .tune(|t| t.floor_snap = 0.25);
        scene.each(|run| {
            for direction in [1.0, -1.0] {
                run.spawn(-5.0 - 3.0 * direction, 0.0)
                    .walk(5.0 * direction)
                    .advance(1.8);
                assert_eq!(run.supported(), direction > 0.0);
                if direction > 0.0 {
                    assert_eq!(snapped(run), [0.25]);
                    run.near(1.0, -0.25, 1e-14);
                }
            }
        });
    }
}

#[test]
fn onto_a_slope_the_speed_along_the_ground_is_kept() {
    let scene = Scene::point()
        .rect((-10.0, 0.0), (-1.0, 0.0))
        .under(&[(-7.5, 3.5), (0.0, -0.5), (7.5, -4.5)], -8.0)
        .rect((-10.0, -0.5), (-1.0, 0.0))
        .tune(|t| t.floor_snap = 0.5);
    scene.each(|run| {
        // The slope at x = 0 is half a metre down.
        run.spawn(-0.25, 0.0).walk(5.0).advance(0.05);
        assert_eq!(snapped(run), [0.5]);
        let on = 5.0 * (run.time() - 0.05);
        assert!(on.abs() < 1e-15);
        run.advance(0.25);
        run.near(1.0 * 15.0 / 17.0, -0.5 - 8.0 / 17.0, 1e-14);
    });
}

#[test]
fn only_the_end_of_the_ground_snaps() {
    // A bend that is too sharp for the speed is left as it is without a snap.
    let bend = Scene::point().under(&[(-10.0, 0.0), (0.0, 0.0), (30.0, -16.0)], -20.0);
    bend.tune(|t| (t.joint, t.floor_snap) = (2.0, 0.3))
        .each(|run| {
            run.spawn(-1.0, 0.0).walk(5.0).advance(0.25);
            assert!(run.airborne() && snapped(run).is_empty());
        });
    // A face too steep to walk falls away under the vertex: nothing is straight below.
    let steep = Scene::point().under(
        &[(-10.0, 0.0), (0.0, 0.0), (0.0625, -0.25), (9.0, -0.25)],
        -2.0,
    );
    steep.tune(|t| t.floor_snap = 0.5).each(|run| {
        run.spawn(-1.0, 0.0).walk(5.0).advance(0.21);
        assert!(run.airborne() && snapped(run).is_empty());
    });
    // Nor is what cannot be walked on.
    let spikes = Scene::point()
        .rect((-10.0, 0.0), (-1.0, 0.0))
        .solid(&[(-0.5, -1.0), (0.5, -1.0), (-0.125, -0.0625)])
        .tune(|t| t.floor_snap = 1.0);
    spikes.each(|run| {
        run.spawn(-1.0, 0.0).walk(5.0).advance(0.21);
        assert!(!run.supported() && snapped(run).is_empty());
    });
}

#[test]
fn one_who_jumps_is_not_set_down() {
    stairs(Scene::boxed(), 1, 1.0, -0.25)
        .tune(|t| t.floor_snap = 0.25)
        .each(|run| {
            run.spawn(-1.0, 0.0)
                .walk(5.0)
                .advance(0.1)
                .jump(true)
                .advance(0.5);
            assert!(run.airborne() && snapped(run).is_empty());
        });
}

#[test]
fn scene_45_up_to_the_limit_and_not_a_step_more() {
    let limit = grid(0.2);
    for (rise, steps) in [(limit, true), (limit - STEP, true), (limit + STEP, false)] {
        for scene in [Scene::point(), Scene::boxed()] {
            let scene = stairs(scene, 1, 1.0, rise).tune(|t| t.step_up = 0.2);
            scene.each(|run| {
                run.spawn(-2.0, 0.0).walk(5.0).advance(0.6);
                if steps {
                    assert_eq!(stepped(run).len(), 1);
                    close(stepped(run)[0], rise, 1e-12);
                    run.near(1.0, rise, 1e-12);
                } else {
                    assert!(stepped(run).is_empty() && run.at().x <= 0.0);
                    run.frozen(60);
                }
            });
        }
    }
}

#[test]
fn stairs_up_and_down_again_lose_no_time() {
    for scene in [Scene::point(), Scene::boxed()] {
        let scene = stairs(scene, 20, grid(0.3), grid(0.2))
            .tune(|t| (t.step_up, t.floor_snap) = (0.2, 0.2));
        scene.each(|run| {
            for rate in [30.0, 60.0, 240.0, 1000.0] {
                run.spawn(-1.0, 0.0)
                    .walk(5.0)
                    .ticks((2.0 * rate) as u32, rate);
                run.near(9.0, 20.0 * grid(0.2), 1e-11);
                assert_eq!(stepped(run).len(), 20);
                run.walk(-5.0).ticks((2.0 * rate) as u32, rate);
                run.near(-1.0, 0.0, 1e-11);
                assert_eq!(snapped(run).len(), 20);
            }
        });
    }
}

#[test]
fn scene_45_a_low_ceiling_or_a_steep_face_behind_prevents_it() {
    let limit = grid(0.2);
    let step = || stairs(Scene::boxed(), 1, 1.0, limit).tune(|t| t.step_up = 0.2);
    for (gap, steps) in [(0.0, false), (limit - STEP, false), (limit + STEP, true)] {
        let low = step().rect((-0.25, 5.0), (TALL + gap, 6.0));
        low.each(|run| {
            run.spawn(-2.0, 0.0).walk(5.0).advance(0.6);
            assert_eq!(!stepped(run).is_empty(), steps, "gap {gap}");
        });
    }
    // Behind a riser of half the limit the face goes on at 63 degrees.
    let steep = Scene::boxed()
        .under(
            &[
                (-10.0, 0.0),
                (0.0, 0.0),
                (0.0, 0.125),
                (2.0, 4.125),
                (9.0, 4.125),
            ],
            -1.0,
        )
        .tune(|t| t.step_up = 0.2);
    steep.each(|run| {
        run.spawn(-2.0, 0.0).walk(5.0).advance(0.6);
        assert!(stepped(run).is_empty() && run.at().x <= 0.0);
    });
    // A wall that leans back over him is none to step on.
    let lean = Scene::point()
        .solid(&[
            (-10.0, -1.0),
            (9.0, -1.0),
            (9.0, limit),
            (-0.0625, limit),
            (0.0, 0.0),
            (-10.0, 0.0),
        ])
        .tune(|t| t.step_up = 0.2);
    lean.each(|run| {
        run.spawn(-2.0, 0.0).walk(5.0).advance(0.6);
        assert!(stepped(run).is_empty());
    });
}

#[test]
fn a_step_is_taken_from_rest_and_with_a_slanting_riser() {
    let scene =
        stairs(Scene::boxed(), 1, 1.0, 0.125).tune(|t| (t.run_accel, t.step_up) = (10.0, 0.125));
    scene.each(|run| {
        // Down along the riser to its foot.
        run.spawn(-HALF, 0.5).advance(1.0);
        run.near(-HALF, 0.0, 0.0);
        run.frozen(60);
        run.control(Control {
            run: 0.5,
            ..Control::default()
        });
        run.wait(0.0);
        assert_eq!(stepped(run), [0.125]);
        let from = run.time();
        run.advance(from + 0.2)
            .near(-HALF + 0.5 * 10.0 * 0.04, 0.125, 1e-14);
    });
    let slanting = Scene::point()
        .under(
            &[(-10.0, 0.0), (0.0, 0.0), (0.0625, 0.1875), (9.0, 0.1875)],
            -1.0,
        )
        .tune(|t| t.step_up = 0.1875);
    slanting.each(|run| {
        run.spawn(-1.0, 0.0).walk(5.0).advance(0.2 + 0.1);
        assert_eq!(stepped(run), [0.1875]);
        run.near(0.0625 + 0.5, 0.1875, 1e-14);
    });
}

#[test]
fn it_takes_a_wish_and_ground_to_step_up() {
    // Carried by a belt.
    let belt = Scene::boxed()
        .rect((-10.0, 0.0), (-1.0, 0.0))
        .traits(|t| t.conveyor = 3.0)
        .rect((0.0, 9.0), (-1.0, 0.125))
        .tune(|t| (t.run_brake, t.step_up) = (50.0, 0.25));
    belt.each(|run| {
        run.spawn(-2.0, 0.0).advance(2.0);
        run.near(-HALF, 0.0, 0.0);
        run.frozen(60);
        run.hold(1.0);
        assert_eq!(stepped(run), [0.125]);
    });
    // Coming down a steep face against a riser.
    let slide = Scene::point()
        .under(&[(-4.0, 8.0), (0.0, 0.0), (0.0, 0.125), (9.0, 0.125)], -1.0)
        .tune(|t| (t.step_up, t.air_accel) = (0.25, 5.0));
    slide.each(|run| {
        run.spawn(-2.0, 4.0).advance(0.0).hold(1.0).advance(2.0);
        assert!(stepped(run).is_empty());
    });
}

/// What stops the standing body need not stop the crouched one.
#[test]
fn one_who_crouches_before_a_low_passage_goes_on() {
    let scene = Scene {
        crouch: box_collider(HALF, 1.0),
        ..Scene::boxed()
    };
    let scene = scene
        .rect((-10.0, 10.0), (-1.0, 0.0))
        .rect((0.0, 5.0), (1.25, 3.0))
        .tune(|t| (t.run_accel, t.crouch_speed) = (50.0, 2.0));
    scene.each(|run| {
        run.spawn(-2.0, 0.0).walk(5.0).advance(1.0);
        run.near(-HALF, 0.0, 0.0);
        run.down(true).advance(3.0);
        assert!(run.crouched() && run.at().x > 1.0, "{}", run.at());
    });
}

/// The hero's foot is 1/2 m wide, and his flanks lean out by 5 in 11 up to 11/32 m: down stairs he slides off each along a flank.
fn hero() -> Scene {
    Scene {
        stand: Collider::hero(),
        crouch: Collider::hero(),
        ..Scene::point()
    }
}

#[test]
fn scene_44_a_foot_with_bevelled_flanks_walks_down_stairs() {
    let (deep, drop) = (grid(0.6), grid(0.25));
    let out = grid(drop * 5.0 / 11.0);
    for direction in [1.0, -1.0] {
        // Up to the left, so that the same stairs are gone down to the left too.
        let mut scene = hero();
        let stair = |i: u32| f64::from(i);
        for i in 0..10 {
            let x = -direction * deep * stair(i);
            let (from, to) = (x - direction * 40.0, x);
            scene = scene.rect((from.min(to), from.max(to)), (-20.0, drop * stair(i)));
        }
        let (top, start) = (drop * 9.0, -direction * (deep * 9.0 + 1.0));
        let scene = scene
            .rect((-60.0, 60.0), (-20.0, -drop))
            .tune(|t| t.floor_snap = 0.3);
        scene.each(|run| {
            for rate in [30.0, 60.0, 240.0] {
                run.spawn(start, top).walk(5.0 * direction);
                run.trace.clear();
                for tick in 1..=(2.0 * rate) as u32 {
                    run.advance(f64::from(tick) / rate);
                    assert!(run.supported(), "{:?}", run.kinds());
                }
                assert_eq!(snapped(run), [drop; 10]);
                let x = direction * 10.0 + start + direction * 10.0 * out;
                run.near(x, -drop, 1e-11);
            }
        });
    }
}

#[test]
fn scene_44_the_limit_holds_for_bevelled_flanks_and_beyond_them() {
    // 0.5 m is more than the flanks are high: down their whole way, 5/32 m out, and straight down from there.
    for (limit, out) in [(grid(0.3), grid(grid(0.3) * 5.0 / 11.0)), (0.5, 5.0 / 32.0)] {
        for (drop, snaps) in [(limit, true), (limit + STEP, false)] {
            let scene = stairs(hero(), 1, 1.0, -drop).tune(|t| t.floor_snap = limit);
            scene.each(|run| {
                run.spawn(-1.0, 0.0).walk(5.0).advance(0.3);
                assert_eq!(run.supported(), snaps);
                assert_eq!(run.kinds().contains(&EventKind::Left), !snaps);
                match snaps {
                    true => run.near(0.5 + out, -drop, 1e-13),
                    false => run.near(0.5, -15.0 * 0.05 * 0.05, 1e-13),
                };
            });
        }
    }
}

#[test]
fn a_face_that_the_level_has_drawn_is_no_bevel() {
    // Steeper than walkable, flatter than the flanks: it begins at the end of the ground, and falls away from it.
    let top = [(-10.0, 0.0), (0.0, 0.0), (0.1875, -0.25), (9.0, -0.25)];
    hero()
        .under(&top, -2.0)
        .tune(|t| t.floor_snap = 0.5)
        .each(|run| {
            run.spawn(-1.0, 0.0).walk(5.0).advance(0.26);
            assert!(run.airborne() && snapped(run).is_empty());
        });
}
