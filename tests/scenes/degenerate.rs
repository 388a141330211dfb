//! A. Degenerate but legal geometry.

use super::rig::*;
use edgewalker::geom::STEP;
use edgewalker::motion::EventKind;

fn boxes(scene: Scene, n: u32) -> Scene {
    (0..n).fold(scene, |s, i| {
        s.rect((f64::from(i), f64::from(i) + 1.0), (-1.0, 0.0))
    })
}

#[test]
fn scene_01_a_thousand_abutting_boxes_are_one_floor() {
    boxes(Scene::boxed(), 1000).each(|run| {
        run.spawn(0.5, 0.0).walk(5.0);
        let ground = run.body().position().y.to_bits();
        for tick in 1..=600 {
            run.advance(f64::from(tick) / 60.0);
            assert!(run.supported());
            assert_eq!(run.body().position().y.to_bits(), ground, "0 ulp");
            assert_eq!(run.body().normal(), v(0.0, 1.0));
        }
        run.near(50.5, 0.0, 1e-12);
    });
}

#[test]
fn scene_02_tops_one_step_apart_are_one_floor() {
    let scene = (0..200).fold(Scene::boxed(), |s, i| {
        let x = f64::from(i) * 0.1;
        s.rect((x, x + 0.1), (-1.0, f64::from(i % 2) * STEP))
    });
    scene.each(|run| {
        run.spawn(0.5, 2.0 * STEP).advance(0.5).walk(5.0);
        let start = run.at();
        run.trace.clear();
        for tick in 1..=180 {
            run.advance(0.5 + f64::from(tick) / 60.0);
            assert!(run.supported(), "at {}", run.at());
            close(run.at().y, start.y, STEP);
        }
        assert_eq!(run.kinds(), [], "no event");
        close(run.at().x, start.x + 15.0, 1e-9);
    });
}

#[test]
fn scene_03_flush_with_a_column_of_boxes_is_a_free_fall() {
    let column = (-200..=0).fold(Scene::boxed(), |s, k| {
        s.rect((0.0, 1.0), (f64::from(k), f64::from(k) + 1.0))
    });
    for (gap, pushes) in [(0.0, 0.0), (0.0, 1.0), (1.0 / 32.0, 0.0)] {
        let column = column.clone().tune(|t| t.air_accel = 20.0);
        column.each(|run| {
            run.spawn(-HALF - gap, 0.0).hold(pushes);
            let x = run.body().position().x.to_bits();
            for tick in 1..=120 {
                let t = f64::from(tick) / 60.0;
                run.advance(t);
                run.near(-HALF - gap, -15.0 * t * t, 1e-12);
                assert_eq!(run.body().position().x.to_bits(), x, "0 ulp");
                assert!(!run.supported());
            }
        });
    }
}

#[test]
fn scene_04_t_junctions_in_a_wall_do_not_show() {
    let scene = (0..20).fold(Scene::boxed().rect((0.0, 10.0), (-1.0, 0.0)), |s, k| {
        s.rect((10.0, 11.0), (0.7 * f64::from(k), 0.7 * f64::from(k) + 0.7))
    });
    scene
        .tune(|t| (t.air_accel, t.run_accel) = (20.0, 1000.0))
        .each(|run| {
            run.spawn(9.0, 0.0)
                .hold(1.0)
                .advance(1.0)
                .near(10.0 - HALF, 0.0, 0.0);
            run.jump(true);
            for tick in 1..=48 {
                let dt = f64::from(tick) / 60.0;
                run.advance(1.0 + dt);
                run.near(10.0 - HALF, (12.0 * dt - 15.0 * dt * dt).max(0.0), 1e-12);
            }
            assert!(run.advance(1.9).supported());
        });
}

#[test]
fn scene_05_overlaps_and_duplicates_change_no_bit() {
    let single = Scene::boxed().rect((0.0, 10.0), (-1.0, 0.0));
    let cluttered = single
        .clone()
        .rect((0.0, 10.0), (-1.0, 0.0))
        .rect((0.0, 10.0), (-1.0, 0.0));
    let cluttered = cluttered
        .rect((0.0, 6.0), (-1.0, 0.0))
        .rect((4.0, 10.0), (-1.0, 0.0))
        .solid(&[(0.0, 0.0), (10.0, 0.0), (10.0, -1.0), (0.0, -1.0)]);
    for variant in [Variant::Plain, Variant::Mirrored, Variant::Shifted] {
        let hashes = [&single, &cluttered].map(|scene| {
            let hashes = std::cell::RefCell::new(Vec::new());
            scene
                .clone()
                .tune(|t| (t.run_accel, t.run_brake) = (7.0, 9.0))
                .with(variant, &|run: &mut Run| {
                    run.spawn(1.0, 2.0).hold(1.0);
                    for tick in 1..=300 {
                        run.advance(f64::from(tick) / 60.0);
                        hashes.borrow_mut().push(run.body().hash());
                    }
                });
            hashes.into_inner()
        });
        assert_eq!(hashes[0], hashes[1]);
    }
}

#[test]
fn scene_06_boxes_that_touch_at_a_corner_leave_no_way_between() {
    let scene = Scene::point()
        .rect((0.0, 1.0), (0.0, 1.0))
        .rect((1.0, 2.0), (1.0, 2.0));
    scene.each(|run| {
        run.spawn(0.5, 1.0).walk(5.0).advance(3.0);
        assert_eq!(run.at(), v(1.0, 1.0));
        assert!(run.supported());
    });
    scene.tune(|t| t.gravity = 0.0).each(|run| {
        run.spawn(0.0, 2.0).velocity(10.0, -10.0).advance(1.0);
        assert_eq!((run.at(), run.speed()), (v(1.0, 1.0), v(0.0, 0.0)));
    });
}

#[test]
fn scene_07_seven_edges_at_one_vertex() {
    // Thin triangles from the origin; between each two of them a free sector that nobody leaves over the origin.
    let bearings = [10.0, 60.0, 100.0, 150.0, 200.0, 260.0, 320.0f64];
    let at = |degrees: f64, far: f64| {
        (
            far * degrees.to_radians().cos(),
            far * degrees.to_radians().sin(),
        )
    };
    let scene = bearings.iter().fold(Scene::point(), |s, &b| {
        s.solid(&[(0.0, 0.0), at(b - 1.0, 10.0), at(b + 1.0, 10.0)])
    });
    let mut state = 1u64;
    let mut random = move || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let pushes: Vec<_> = (0..1500).map(|_| (random(), random())).collect();
    scene.tune(|t| t.gravity = 0.0).each(|run| {
        for i in 0..7 {
            let (low, high) = (
                bearings[i] + 1.0,
                bearings[(i + 1) % 7] - 1.0 + if i == 6 { 360.0 } else { 0.0 },
            );
            let (x, y) = at((low + high) / 2.0, 0.5);
            run.spawn(x, y);
            for (tick, &(turn, speed)) in pushes.iter().enumerate() {
                // Mostly towards the origin, so that the corner is where it happens.
                let p = run.at();
                let push =
                    -p * (2.0 * speed / p.length().max(1e-9)) + v(turn - 0.5, speed - 0.5) * 4.0;
                run.velocity(push.x, push.y)
                    .advance((tick + 1) as f64 / 60.0);
                let p = run.at();
                let bearing = p.y.atan2(p.x).to_degrees();
                let turned = (bearing - low).rem_euclid(360.0);
                let inside = turned <= high - low + 1e-3 || turned >= 360.0 - 1e-3;
                assert!(
                    inside || p.length() < 1e-4,
                    "sector {i}: {p} at {bearing} degrees"
                );
                if p.length() > 8.0 {
                    run.spawn(x, y).advance((tick + 1) as f64 / 60.0);
                }
            }
        }
    });
}

#[test]
fn scene_08_a_slab_a_step_thick_stops_ten_kilometres_a_second() {
    let fast = |t: &mut edgewalker::tune::Motion| (t.gravity, t.fall_speed) = (30.0, 1e12);
    Scene::point()
        .rect((-10.0, 10.0), (-STEP, 0.0))
        .tune(fast)
        .each(|run| {
            run.spawn(0.0, 100.0).velocity(0.0, -10_000.0).advance(0.02);
            let t = run.when(|k| matches!(k, EventKind::Landed(_)));
            close(
                t,
                0.00999985000449983,
                1e-15
                    * if run.variant == Variant::Shifted {
                        1e3
                    } else {
                        1.0
                    },
            );
            assert_eq!(run.at().y, 0.0);
        });
}

#[test]
fn scene_09_a_line_stops_ten_kilometres_a_second_from_both_sides() {
    let scene = Scene::point().line((-10.0, 0.0), (10.0, 0.0));
    let time = |run: &Run, at: f64| {
        let slack = if run.variant == Variant::Shifted {
            1e-12
        } else {
            1e-15
        };
        close(
            run.when(|k| matches!(k, EventKind::Landed(_) | EventKind::Hit(_))),
            at,
            slack,
        );
        close(run.at().y, 0.0, 1e-18);
    };
    scene.each(|run| {
        run.spawn(0.0, 100.0).velocity(0.0, -10_000.0).advance(0.02);
        time(run, 0.00999985000449983);
        assert!(run.supported());
        run.frozen(60);
    });
    scene.each(|run| {
        // Upwards: 100 = 10000 t - 15 t^2.
        run.spawn(0.0, -100.0).velocity(0.0, 10_000.0);
        let t = 2.0 * 100.0 / (10_000.0 + (1e8f64 - 60.0 * 100.0).sqrt());
        run.advance(t * (1.0 + 1e-9));
        time(run, t);
        run.advance(t + 1.0).near(0.0, -15.0, 1e-5);
        // Along its end, out from under it, and back onto it from above.
        run.velocity(10.0, 0.0).advance(t + 3.0);
        assert!(run.at().x > 10.0 && run.airborne());
    });
    scene.each(|run| {
        run.spawn(9.0, 1.0).advance(1.0).walk(5.0).advance(1.4);
        close(run.when(|k| k == EventKind::Left), 1.2, 1e-12);
        assert!(run.airborne() && run.at().y < 0.0);
    });
}

#[test]
fn scene_10_the_first_of_seven_slabs_stops() {
    let slabs = (0..7).fold(Scene::point(), |s, k| {
        let top = -f64::from(2 * k) * STEP;
        s.rect((-10.0, 10.0), (top - STEP, top))
    });
    slabs.each(|run| {
        run.spawn(0.0, 1.0).velocity(0.0, -1e6).advance(1.0);
        assert_eq!(run.at(), v(0.0, 0.0));
    });
}

#[test]
fn scene_11_a_needle() {
    let needle = Scene::point().solid(&[(0.0, 0.0), (1.0 / 512.0, 0.0), (1.0 / 1024.0, 10.0)]);
    let needle = needle.rect((-5.0, 5.0), (-1.0, 0.0));
    needle.each(|run| {
        run.spawn(1.0 / 1024.0, 12.0).advance(2.0);
        assert_eq!(
            (run.at(), run.speed()),
            (v(1.0 / 1024.0, 10.0), v(0.0, 0.0)),
            "rests on the tip"
        );
        run.spawn(1.0 / 1024.0 + STEP, 12.0).advance(0.4);
        assert!(
            run.at().x > 1.0 / 1024.0 && run.at().y < 10.0,
            "slides down the right face, {}",
            run.at()
        );
    });
    let boxed = Scene {
        solids: needle.solids,
        ..Scene::boxed()
    };
    boxed.tune(|t| t.run_accel = 50.0).each(|run| {
        run.spawn(-2.0, 0.0).walk(5.0).advance(3.0);
        assert_eq!(run.at(), v(-HALF, 0.0));
    });
}

/// A V of two walls with its apex at the origin, as the snapped corners give it.
fn vee(scene: Scene, width: f64, height: f64) -> Scene {
    let (w, h) = (width, height);
    scene
        .solid(&[
            (0.0, 0.0),
            (w, h),
            (w + 1.0, h),
            (w + 1.0, -1.0),
            (0.0, -1.0),
        ])
        .solid(&[
            (0.0, 0.0),
            (0.0, -1.0),
            (-w - 1.0, -1.0),
            (-w - 1.0, h),
            (-w, h),
        ])
}

#[test]
fn scene_12_a_vee_holds_what_falls_into_it() {
    for degrees in [45.0f64, 30.0, 15.0, 5.0, 0.5] {
        let height = if degrees == 0.5 { 100.0 } else { 20.0 };
        let width = if degrees == 45.0 {
            20.0
        } else {
            (height * degrees.to_radians().tan() / STEP).round() * STEP
        };
        let rest = HALF * height / width;
        vee(Scene::point(), width, height)
            .tune(|t| (t.air_accel, t.run_accel) = (30.0, 0.0))
            .each(|run| {
                run.spawn(0.0, 6.0).advance(2.0);
                assert_eq!((run.at(), run.speed()), (v(0.0, 0.0), v(0.0, 0.0)));
                run.frozen(600);
            });
        for side in [0.0, 0.01, -0.01] {
            vee(Scene::boxed(), width, height)
                .tune(|t| (t.air_accel, t.concave) = (30.0, 1.0))
                .each(|run| {
                    let top = if rest + 6.0 < height {
                        rest + 6.0
                    } else {
                        height + 6.0
                    };
                    run.spawn(side, top).advance(5.0);
                    run.near(0.0, rest, 2.0 * STEP * height / width);
                    assert_eq!(run.speed(), v(0.0, 0.0), "{degrees} degrees");
                    run.frozen(600);
                    for direction in [1.0, -1.0, 0.0] {
                        run.hold(direction).frozen(100);
                    }
                    let low = run.at().y;
                    let now = run.time();
                    run.jump(true).advance(now + 0.1);
                    assert!(run.at().y > low + 0.5, "a jump gets out");
                });
        }
    }
}

#[test]
fn scene_13_a_wedge_of_floor_and_ceiling() {
    let scene = Scene::boxed().rect((-2.0, 70.0), (-1.0, 0.0)).solid(&[
        (0.0, 2.0),
        (64.0, 1.0),
        (64.0, 9.0),
        (0.0, 9.0),
    ]);
    scene
        .tune(|t| (t.run_accel, t.run_brake) = (50.0, 50.0))
        .each(|run| {
            run.spawn(1.0, 0.0)
                .walk(5.0)
                .advance(4.0)
                .near(11.59375, 0.0, 0.0);
            run.frozen(300);
            let now = run.time();
            run.hold(0.0).frozen(60);
            run.hold(-1.0).advance(now + 2.0);
            assert!(run.at().x < 11.0, "walks left");
        });
}

#[test]
fn scene_14_a_ramp_into_a_wall() {
    let scene = Scene::boxed()
        .solid(&[(0.0, 0.0), (5.0, 0.0), (5.0, 5.0)])
        .rect((5.0, 6.0), (0.0, 12.0))
        .rect((-9.0, 5.0), (-1.0, 0.0));
    scene
        .tune(|t| (t.run_accel, t.run_brake) = (50.0, 50.0))
        .each(|run| {
            run.spawn(-2.0, 0.0)
                .hold(1.0)
                .advance(5.0)
                .near(5.0 - HALF, 5.0, 0.0);
            run.frozen(300);
        });
}

#[test]
fn scene_15_a_shaft_of_the_bodys_width() {
    // Documented choice: a gap of exactly the body's size has no free face, so it is closed.
    for (extra, falls) in [(0.0, false), (-1.0, false), (1.0, true)] {
        let right = 2.0 * HALF + extra * STEP;
        let scene = Scene::boxed()
            .rect((-5.0, 0.0), (-50.0, 0.0))
            .rect((right, right + 5.0), (-50.0, 0.0));
        scene.each(|run| {
            run.spawn(HALF, 1.0).advance(1.0);
            match falls {
                true => run.near(HALF, 1.0 - 15.0, 1e-12),
                false => run.near(HALF, 0.0, 0.0),
            };
        });
    }
}

#[test]
fn scene_16_a_corridor_of_the_bodys_height() {
    for (extra, passes) in [(0.0, false), (-1.0, false), (1.0, true)] {
        let height = TALL + extra * STEP;
        let scene = Scene::boxed()
            .rect((-9.0, 70.0), (-1.0, 0.0))
            .rect((0.0, 70.0), (height, height + 5.0));
        scene.each(|run| {
            run.spawn(-2.0, 0.0).walk(5.0).advance(10.0);
            run.near(if passes { 48.0 } else { -HALF }, 0.0, 1e-12);
        });
    }
}

#[test]
fn scene_17_exactly_beside_a_ledge_is_no_contact() {
    let scene = Scene::boxed().rect((-1.0, 0.0), (-1.0, 0.0));
    scene.each(|run| {
        run.spawn(HALF, 5.0);
        for tick in 1..=120 {
            let t = f64::from(tick) / 60.0;
            run.advance(t).near(HALF, 5.0 - 15.0 * t * t, 1e-12);
        }
        assert_eq!(run.kinds(), []);
        run.spawn(HALF - STEP, 5.0)
            .advance(2.0)
            .near(HALF - STEP, 0.0, 0.0);
    });
}

#[test]
fn scene_18_corner_on_corner_lands_on_the_top() {
    // Documented choice: a corner struck head-on is landed on where one of its sides can be stood on.
    let scene = Scene::boxed()
        .rect((-3.0, 0.0), (-1.0, 0.0))
        .tune(|t| t.gravity = 0.0);
    scene.each(|run| {
        run.spawn(HALF + 2.0, 2.0).velocity(-7.0, -7.0).advance(0.5);
        assert!(run.supported());
        close(run.speed().x, -7.0, 1e-12);
        assert_eq!(run.at().y, 0.0);
    });
}
