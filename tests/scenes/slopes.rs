//! C. Slopes, vertices, launch.

use super::rig::*;
use super::swept::course;
use edgewalker::geom::STEP;
use edgewalker::motion::{Control, EventKind};
use edgewalker::tune::Motion;

#[test]
fn scene_34_idle_for_an_hour_on_44_degrees() {
    Scene::boxed()
        .solid(&[(0.0, 0.0), (21.0, 0.0), (0.0, 20.0)])
        .tune(|t| t.run_brake = 50.0)
        .each(|run| {
            run.spawn(10.0, 12.0).advance(5.0);
            assert!(run.supported());
            run.frozen(216_000);
        });
}

#[test]
fn scene_35_45_degrees_is_walkable_and_a_step_more_is_not() {
    for (rise, walkable) in [(1.0, true), (1.0 + STEP, false)] {
        Scene::point()
            .solid(&[(0.0, 0.0), (1.0, 0.0), (1.0, rise)])
            .each(|run| {
                run.spawn(0.5, 2.0).advance(0.35);
                assert_eq!(run.supported(), walkable);
            });
    }
}

/// A zig-zag of 8:15:17 slopes with edges of 17/32 m.
fn zigzag(n: i32) -> Vec<(f64, f64)> {
    (0..n)
        .map(|i| {
            (
                15.0 / 32.0 * f64::from(i),
                if i % 2 == 0 { 0.0 } else { 0.25 },
            )
        })
        .collect()
}

#[test]
fn scene_38_a_zigzag_is_walked_at_constant_speed() {
    let scene = Scene::point()
        .under(&zigzag(202), -1.0)
        .tune(|t| t.joint = 0.0);
    scene.each(|run| {
        for direction in [1.0, -1.0] {
            let start = 100.0 * 15.0 / 32.0;
            run.spawn(start, 0.0).walk(5.0 * direction);
            for tick in 1..=600 {
                run.advance(f64::from(tick) / 60.0);
                assert!(run.supported());
            }
            close((run.at().x - start) * direction * 17.0 / 15.0, 50.0, 1e-9);
        }
    });
}

#[test]
fn scene_40_a_concave_joint_keeps_or_projects() {
    let scene = Scene::point().under(&[(-10.0, 0.0), (0.0, 0.0), (15.0, 8.0)], -2.0);
    for (concave, speed) in [(0.0, 5.0), (1.0, 5.0 * 15.0 / 17.0)] {
        scene.clone().tune(|t| t.concave = concave).each(|run| {
            run.spawn(-5.0, 0.0).walk(5.0).advance(1.5);
            close(run.speed().length(), speed, 1e-12);
            assert!(run.at().x > 0.0);
        });
    }
}

#[test]
fn scene_41_a_hill_is_left_above_its_critical_speed() {
    // R = 20 m, 0.01 rad an edge. Rounding to the grid bends single joints by up to 1 %, and so 0.5 % of the speed.
    let top: Vec<_> = (-40..=40)
        .map(|i| {
            let angle = f64::from(i) * 0.01;
            (20.0 * libm::sin(angle), 20.0 * libm::cos(angle))
        })
        .collect();
    let hill = Scene::point().under(&top, 10.0);
    let critical = f64::sqrt(20.0 * 30.0 * libm::cos(0.4));
    for (share, stays) in [(0.985, true), (1.03, false)] {
        let speed = share * critical;
        hill.clone().tune(|t| t.run_speed = speed).each(|run| {
            let (x, y) = top[1];
            run.spawn(x + 0.01, y + 0.1).advance(0.2).walk(speed);
            run.trace.clear();
            run.advance(0.2 + 14.0 / speed);
            let left = run.kinds().contains(&EventKind::Left);
            assert_eq!(left, !stays, "at {share} of the critical speed");
        });
    }
}

#[test]
fn scene_42_hops_over_a_convex_joint() {
    // 8:15:17: turn d with sin 8/17, cos 15/17; next slope the same.
    let (sin, cos) = (8.0 / 17.0, 15.0 / 17.0);
    let scene = Scene::point()
        .under(&[(-10.0, 0.0), (0.0, 0.0), (30.0, -16.0)], -20.0)
        .tune(|t| (t.joint, t.run_speed) = (2.0, 8.0));
    for s in [8.0, 5.0, 2.0] {
        scene.clone().tune(|t| t.run_speed = s).each(|run| {
            run.spawn(-1.0, 0.0).walk(s).advance(3.0);
            let (off, down) = (
                run.when(|k| k == EventKind::Left),
                run.last(|k| matches!(k, EventKind::Landed(_))),
            );
            let flight = 2.0 * s * sin / (30.0 * cos);
            close(down - off, flight, 1e-11);
            close(off, 1.0 / s, 1e-12);
        });
    }
}

#[test]
fn scene_43_off_the_end_of_a_floor() {
    Scene::boxed().rect((-20.0, 0.0), (-1.0, 0.0)).each(|run| {
        run.spawn(-2.0, 0.0).walk(5.0).advance(1.0);
        let left = run.when(|k| k == EventKind::Left);
        close(
            left,
            (2.0 + HALF) / 5.0,
            1e-15
                * if run.variant == Variant::Shifted {
                    1e3
                } else {
                    1.0
                },
        );
        for rate in [30.0, 60.0, 1000.0] {
            run.spawn(-2.0, 0.0).walk(5.0).ticks(rate as u32, rate);
            run.advance(left + 1.0).near(HALF + 5.0, -15.0, 1e-12);
        }
    });
}

#[test]
fn scene_46_a_jump_while_running_up_or_down_clears_the_slope() {
    let scene = Scene::boxed()
        .solid(&[(-20.0, 0.0), (20.0, 0.0), (20.0, 40.0)])
        .tune(|t| t.run_speed = 10.0);
    scene.each(|run| {
        for direction in [1.0, -1.0] {
            run.spawn(0.0, 20.5)
                .advance(1.0)
                .walk(10.0 * direction)
                .advance(1.2)
                .jump(true);
            let mut before = -1.0;
            for tick in 1..=20 {
                run.advance(1.2 + f64::from(tick) / 120.0);
                assert!(run.airborne());
                let clearance = run.at().y - run.at().x;
                assert!(clearance > before, "grows");
                before = clearance;
            }
            run.jump(false);
        }
    });
}

#[test]
fn scene_47_landing_on_45_degrees_keeps_the_speed_along_it() {
    let scene = Scene::point().solid(&[(-20.0, 0.0), (20.0, 0.0), (-20.0, 40.0)]);
    scene.each(|run| {
        // At the surface: along it, with all of its speed.
        run.spawn(0.0, 20.0).advance(0.0).velocity(10.0, -10.0);
        assert!(run.supported());
        close(run.speed().length(), 14.142135623730951, 1e-14);
        // From half a metre above it: v = (10, -10 - 30 t) when 15 t^2 = 0.5, and what of it runs along the slope stays.
        run.spawn(0.0, 20.5).velocity(10.0, -10.0).advance(0.3);
        let t = f64::sqrt(0.5 / 15.0);
        close(
            run.speed().length(),
            (20.0 + 30.0 * t) / f64::sqrt(2.0),
            1e-11,
        );
        assert!(run.supported() && run.speed().x > 0.0 && run.speed().y < 0.0);
    });
    scene.tune(|t| t.gravity = 0.0).each(|run| {
        run.spawn(0.0, 22.0).velocity(0.0, -20.0).advance(0.2);
        assert!(run.supported());
        close(run.speed().length(), 14.142135623730951, 1e-14);
        assert!(run.speed().x > 0.0, "downhill");
    });
}

#[test]
fn scene_48_a_wall_of_almost_90_degrees_is_no_ground() {
    // 89.999 degrees: tan is 57295.8; on the grid 1 step in 57296.
    let rise = 57296.0 * STEP * 64.0;
    let scene = Scene::point().solid(&[(0.0, 0.0), (9.0, 0.0), (9.0, rise), (64.0 * STEP, rise)]);
    scene.tune(|t| t.air_accel = 10.0).each(|run| {
        run.spawn(-0.01, rise - 1.0).hold(1.0).advance(0.5);
        assert!(!run.supported() && !run.airborne(), "slides");
        let (t, u) = (run.time(), run.speed().length());
        run.advance(t + 0.5);
        let sine = 57296.0 / f64::sqrt(57296.0 * 57296.0 + 1.0);
        close((run.speed().length() - u) / 0.5, 30.0 * sine, 1e-9);
        close(30.0 * sine, 29.9999999954, 1e-9);
    });
}

#[test]
fn scene_49_the_mirror_image_moves_in_mirrored_bits() {
    let course = course();
    let states = [Variant::Plain, Variant::Mirrored].map(|variant| {
        let out = std::cell::RefCell::new(Vec::new());
        course.with(variant, &|run: &mut Run| {
            run.spawn(1.0, 3.0);
            for step in 0..600u32 {
                let held = Control {
                    run: [1.0, 1.0, -1.0, 0.5][(step / 37 % 4) as usize],
                    jump: step / 23 % 3 == 0,
                    down: step / 51 % 5 == 4,
                    up: false,
                };
                run.control(held).ticks(1, 60.0);
                out.borrow_mut().push((
                    run.at().x + 0.0,
                    run.at().y,
                    run.speed().x + 0.0,
                    run.speed().y + 0.0,
                ));
            }
        });
        out.into_inner()
    });
    assert_eq!(states[0], states[1]);
    assert!(states[0].iter().any(|s| s.0 > 20.0), "gets somewhere");
}

#[test]
fn scene_50_crests_and_feet_of_slopes() {
    let scene = Scene::boxed().under(
        &[
            (-20.0, 0.0),
            (0.0, 0.0),
            (15.0, 8.0),
            (30.0, 8.0),
            (45.0, 0.0),
            (60.0, 0.0),
        ],
        -2.0,
    );
    scene.tune(|t| t.joint_stick = 10.0).each(|run| {
        run.spawn(-2.0, 0.0).walk(5.0);
        for tick in 1..=720 {
            run.advance(f64::from(tick) / 60.0);
            assert!(run.supported(), "at {}", run.at());
        }
        assert!(run.at().x > 50.0);
    });
}

#[test]
fn scene_51_between_walkable_and_too_steep() {
    let scene = Scene::point()
        .under(&[(-20.0, 0.0), (0.0, 0.0), (1.0, 2.0), (2.0, 2.0)], -2.0)
        .tune(|t| (t.run_accel, t.run_speed) = (50.0, 5.0));
    scene.each(|run| {
        run.spawn(0.0, 0.0).advance(0.1);
        assert!(
            run.supported(),
            "at the vertex it stands on what is walkable"
        );
        run.frozen(60);
        run.hold(1.0).ticks(600, 60.0);
        assert!(run.at().y < 0.01, "does not climb: {}", run.at());
        run.frozen(60);
    });
}

/// The fall of a slide is a component of its speed, which was computed from that fall: it may differ in its last bit. Taken
/// for faster than the terminal speed it was braked, which lifted the body off; it fell back, for ever at one and the same time.
#[test]
fn a_slide_at_the_terminal_speed_goes_on_at_that_speed() {
    for i in 0..40 {
        let width = 20.0 + 1.75 * f64::from(i); // on the grid
        Scene::point()
            .solid(&[(0.0, 0.0), (width, 0.0), (0.0, 100.0)])
            .tune(|t| {
                *t = Motion {
                    air_brake: 0.0,
                    ..Motion::default()
                }
            })
            .each(|run| {
                let fall = Motion::default().fall_speed;
                run.spawn(0.05 * width, 95.5).advance(0.5);
                run.velocity(0.01 * width * fall, -fall).advance(3.0);
                assert!(!run.kinds().contains(&EventKind::Parted), "width {width}");
                close(run.speed().y, -fall, 1e-12);
            });
    }
}

#[test]
fn a_hop_off_a_ledge_keeps_the_speed_along_the_slope_below() {
    // From (-2, 0) with (4, 12): lands where 12 t - 15 t^2 = -4 - (4 t - 2), on 45 degrees falling right from (0, -4), far
    // below the line of the ledge that the body left. That ledge is no second edge that holds it.
    let scene = Scene::point().rect((-10.0, 0.0), (-5.0, 0.0)).solid(&[
        (-10.0, -14.0),
        (10.0, -14.0),
        (0.0, -4.0),
        (-10.0, -4.0),
    ]);
    scene.each(|run| {
        run.spawn(-2.0, 0.5).advance(0.5).velocity(4.0, 0.0);
        run.jump(true);
        let t = (16.0 + (16.0f64 * 16.0 + 4.0 * 15.0 * 2.0).sqrt()) / 30.0;
        run.advance(0.5 + t + 1e-9);
        let (x, y) = (4.0, 12.0 - 30.0 * t);
        let along = (x - y) / 2.0;
        close(run.speed().x, along, 1e-6);
        close(run.speed().y, -along, 1e-6);
        assert!(run.supported());
    });
}

#[test]
fn a_hop_on_one_slope_keeps_the_speed_along_it() {
    // Up with 12 and down with 12 onto the edge that was left: it is no second edge either, whatever its normal rounds to.
    for rise in 1..60 {
        let top = f64::from(rise) / 4.0;
        let scene = Scene::point().under(&[(-16.0, -top), (16.0, top)], -20.0);
        scene.each(|run| {
            run.spawn(1.0, 5.0).advance(1.0).velocity(0.0, 0.0);
            run.jump(true).advance(1.8 + 1e-9);
            let length = (16.0 * 16.0 + top * top).sqrt();
            let along = -12.0 * top / length;
            close(run.speed().x, along * 16.0 / length, 1e-6);
            close(run.speed().y, along * top / length, 1e-6);
        });
    }
}

#[test]
fn a_push_that_reaches_the_wish_holds_nobody_to_an_overhang() {
    // Pressed to the right against the underside of a 45 degree overhang, sliding down along it: the push ends at the wished
    // speed, and then gravity pulls the body off. Whether the speed along the slope turns back into exactly that wish is rounding.
    for wish in 40..80 {
        let wish = f64::from(wish) / 10.0;
        let scene = Scene::point()
            .solid(&[(-10.0, 10.0), (10.0, -10.0), (10.0, 10.0)])
            .tune(|t| (t.run_speed, t.air_accel) = (wish, 60.0));
        scene.each(|run| {
            run.spawn(-0.05, 0.0).hold(1.0).advance(2.0);
            let parted = run.when(|kind| kind == EventKind::Parted);
            assert_eq!(run.when(|kind| kind == EventKind::Limit), parted);
            assert!(run.airborne());
            close(run.speed().x, wish, 1e-12);
        });
    }
}
