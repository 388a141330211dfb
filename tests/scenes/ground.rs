//! Walkable ground: friction and the pull of slopes, belts, bends that keep or project the speed.

use super::rig::*;
use edgewalker::geom::Point;
use edgewalker::motion::{Concave, EventKind, Mode};
use edgewalker::tune::Motion;

/// Sine and cosine of 8:15:17.
const SIN: f64 = 8.0 / 17.0;
const COS: f64 = 15.0 / 17.0;

/// Gravity pulls one who does not wish to run, and nothing else acts on him.
fn sliding(t: &mut Motion) {
    (t.slope_gravity, t.friction) = (1.0, 0.0);
}

/// A slope of 8:15:17 that falls to the right; (0, 16) is on it.
fn slope() -> Scene {
    Scene::point().solid(&[(-30.0, 0.0), (30.0, 0.0), (-30.0, 32.0)])
}

#[test]
fn scene_36_down_a_slope_from_rest() {
    for friction in [0.0, 0.2] {
        let accel = 30.0 * (SIN - friction * COS);
        let by_tuning = slope().tune(|t| (t.slope_gravity, t.friction) = (1.0, friction));
        let by_trait = slope()
            .traits(|t| t.friction = Some(friction))
            .tune(|t| (t.slope_gravity, t.friction) = (1.0, 3.0));
        for scene in [by_tuning, by_trait] {
            scene.each(|run| {
                run.spawn(-15.0, 24.0).advance(1.5);
                let s = 0.5 * accel * 1.5 * 1.5;
                run.near(-15.0 + s * COS, 24.0 - s * SIN, 1e-12);
                close(run.speed().length(), accel * 1.5, 1e-12);
            });
        }
    }
}

#[test]
fn scene_36_friction_sticks_up_to_its_bound_and_not_beyond() {
    let bound = 8.0 / 15.0;
    for (friction, sticks) in [(bound, true), (bound - 1e-9, false)] {
        let scene = slope().tune(|t| (t.slope_gravity, t.friction) = (1.0, friction));
        scene.each(|run| {
            run.spawn(-15.0, 24.0).advance(0.0);
            if sticks {
                run.frozen(6000);
            } else {
                run.advance(100.0);
                let s = 0.5 * 30.0 * 1e-9 * COS * 100.0 * 100.0;
                run.near(-15.0 + s * COS, 24.0 - s * SIN, 1e-9);
                assert!(s > 1e-4);
            }
        });
    }
    // Only a brake: it holds by its force alone.
    for (brake, sticks) in [(30.0 * SIN + 1e-9, true), (30.0 * SIN - 1e-9, false)] {
        slope()
            .tune(|t| (t.slope_gravity, t.run_brake) = (1.0, brake))
            .each(|run| {
                run.spawn(-15.0, 24.0).advance(100.0);
                assert_eq!(run.speed().length() == 0.0, sticks);
            });
    }
}

#[test]
fn scene_37_up_a_slope_to_a_stop_and_back() {
    for friction in [0.0, 0.2] {
        let (up, down) = (30.0 * (SIN + friction * COS), 30.0 * (SIN - friction * COS));
        let scene = slope().tune(|t| (t.slope_gravity, t.friction) = (1.0, friction));
        scene.each(|run| {
            run.spawn(0.0, 16.0).advance(0.0);
            run.velocity(-10.0 * COS, 10.0 * SIN);
            let (stop, s) = (10.0 / up, 50.0 / up);
            run.advance(stop).near(-s * COS, 16.0 + s * SIN, 1e-12);
            close(run.when(|k| k == EventKind::Limit), stop, 1e-15);
            let back = f64::sqrt(2.0 * s / down);
            run.advance(stop + back).near(0.0, 16.0, 1e-11);
            close(run.speed().length(), f64::sqrt(2.0 * s * down), 1e-12);
        });
    }
}

#[test]
fn swings_in_a_valley_end_at_its_bottom() {
    let valley = Scene::point().under(&[(-15.0, 8.0), (0.0, 0.0), (15.0, 8.0)], -1.0);
    let scene = valley.tune(|t| (t.slope_gravity, t.friction) = (1.0, 0.4));
    scene.each(|run| {
        run.spawn(-7.5, 4.0).ticks(3600, 60.0);
        run.near(0.0, 0.0, 0.0);
        run.frozen(600);
        let swings = run
            .kinds()
            .iter()
            .filter(|&&k| k == EventKind::Joint)
            .count();
        // Each swing keeps (sin - mu cos) / (sin + mu cos) of the height, down to two grid steps.
        let kept: f64 = (SIN - 0.4 * COS) / (SIN + 0.4 * COS);
        let expected = (2.0 / 65536.0 / 4.0_f64).ln() / kept.ln();
        close(swings as f64, expected, 2.0);
        run.jump(true).advance(60.2);
        assert!(run.airborne());
    });
}

#[test]
fn slopes_change_the_wished_speed() {
    let scene = slope().tune(|t| {
        (t.slope_speed, t.run_accel, t.run_brake) = (0.5, 40.0, 40.0);
        t.over_speed_decay = 40.0;
    });
    scene.each(|run| {
        for (wish, speed) in [
            (1.0, 5.0 * (1.0 + 0.5 * SIN)),
            (-1.0, 5.0 * (1.0 - 0.5 * SIN)),
        ] {
            run.spawn(0.0, 16.0).hold(wish).advance(0.5);
            close(run.speed().length(), speed, 1e-15);
        }
    });
}

/// Two belts that meet at x = 0, run towards each other, and hold on to what stands on them.
fn belts(scene: Scene) -> Scene {
    scene
        .rect((-10.0, 0.0), (-1.0, 0.0))
        .traits(|t| t.conveyor = 3.0)
        .rect((0.0, 10.0), (-1.0, 0.0))
        .traits(|t| t.conveyor = -3.0)
        .tune(|t| (t.run_accel, t.run_brake, t.over_speed_decay) = (50.0, 50.0, 50.0))
}

#[test]
fn scene_59_two_belts_that_meet_hold_a_body_between_them() {
    for scene in [belts(Scene::point()), belts(Scene::boxed())] {
        for start in [-5.0, 4.0, 0.0] {
            scene.each(|run| {
                run.spawn(start, 0.5).advance(4.0);
                assert!(run.supported() && run.at().x.abs() <= HALF && run.at().y == 0.0);
                run.trace.clear();
                run.frozen(600);
                assert_eq!(run.kinds(), []);
                // Out by a jump, and back.
                run.jump(true).wait(0.1);
                assert!(run.airborne());
                run.jump(false).wait(3.0).frozen(60);
                // A wish that is no faster than the belt does not get out; a faster one does, either way.
                for wish in [0.6, -0.6] {
                    run.hold(wish).wait(3.0).frozen(60);
                    assert!(run.at().x.abs() <= HALF + 0.1);
                }
                for wish in [1.0, -1.0] {
                    run.hold(wish).wait(1.0);
                    close(run.speed().x, 2.0 * wish, 1e-15);
                    assert!(run.at().x * wish > 1.0);
                    run.hold(0.0).wait(3.0).frozen(60);
                }
            });
        }
    }
}

#[test]
fn scene_59_one_who_is_faster_than_the_belt_passes_the_joint_once() {
    belts(Scene::point()).each(|run| {
        run.spawn(-1.0, 0.0).advance(0.0);
        run.velocity(9.0, 0.0);
        // Braked to 3 on the first belt, past the joint at sqrt(81 - 2 * 50 * 1) if that is more than 3.
        run.advance(5.0).near(0.0, 0.0, 0.0);
        run.frozen(60);
        run.spawn(-0.25, 0.0).advance(0.0);
        run.velocity(9.0, 0.0).advance(0.2);
        assert!(run.at().x > 0.0);
        run.advance(5.0).near(0.0, 0.0, 0.0);
        run.frozen(60);
    });
}

#[test]
fn scene_59_a_sloping_belt_moves_along_itself() {
    let scene = slope()
        .traits(|t| t.conveyor = -3.0)
        .tune(|t| t.run_brake = 50.0);
    scene.each(|run| {
        run.spawn(0.0, 16.0).advance(0.06);
        close(run.speed().length(), 3.0, 1e-15);
        let (x, y) = (run.at().x, run.at().y);
        run.trace.clear();
        run.advance(2.06).near(x - 6.0 * COS, y + 6.0 * SIN, 1e-12);
        assert_eq!(run.kinds(), [], "no event while it carries");
    });
}

#[test]
fn from_a_belt_to_the_floor_and_into_the_air() {
    let belt = |scene: Scene| {
        scene
            .rect((-10.0, 0.0), (-1.0, 0.0))
            .traits(|t| t.conveyor = 3.0)
            .tune(|t| t.run_brake = 50.0)
    };
    belt(Scene::point().rect((0.0, 10.0), (-1.0, 0.0)).traits(|_| ())).each(|run| {
        run.spawn(-1.0, 0.0).advance(3.0);
        run.near(9.0 / 100.0, 0.0, 1e-15);
        run.frozen(60);
    });
    belt(Scene::point()).each(|run| {
        run.spawn(-1.0, 0.0).advance(3.0);
        let off = run.when(|k| k == EventKind::Left);
        run.near(3.0 * (3.0 - off), -15.0 * (3.0 - off) * (3.0 - off), 1e-11);
    });
}

#[test]
fn a_belt_in_a_floor_of_the_same_height_is_felt() {
    let scene = Scene::point()
        .rect((-10.0, 10.0), (-1.0, 0.0))
        .rect((-2.0, 2.0), (-0.5, 0.0))
        .traits(|t| t.conveyor = 3.0)
        .tune(|t| t.run_brake = 50.0);
    scene.each(|run| {
        run.spawn(-1.0, 0.0).advance(3.0).near(2.09, 0.0, 1e-14);
        run.frozen(60);
        run.spawn(-3.0, 0.0).walk(5.0).hold(0.0).advance(0.05);
        run.advance(4.0);
        assert!(run.at().x < -2.0, "brakes on the floor before it");
    });
}

#[test]
fn a_belt_presses_against_a_wall_in_peace() {
    let scene = Scene::boxed()
        .rect((-10.0, 0.0), (-1.0, 0.0))
        .traits(|t| t.conveyor = 3.0)
        .rect((0.0, 1.0), (-1.0, 3.0))
        .tune(|t| t.run_brake = 50.0);
    scene.each(|run| {
        run.spawn(-2.0, 0.0).advance(2.0).near(-HALF, 0.0, 0.0);
        run.frozen(600);
    });
}

/// The quarter pipe: a floor, N chords of a quarter circle of 10 m, and an upright wall.
fn pipe(n: u32) -> (Scene, Vec<(f64, f64)>) {
    let grid = |p: (f64, f64)| {
        let p = Point::snap(v(p.0, p.1)).unwrap().metres();
        (p.x, p.y)
    };
    let mut top = vec![(-20.0, 0.0)];
    top.extend((0..=n).map(|i| {
        let angle = f64::from(i) / f64::from(n) * std::f64::consts::FRAC_PI_2;
        grid((10.0 * libm::sin(angle), 10.0 - 10.0 * libm::cos(angle)))
    }));
    top.push((10.0, 14.0));
    let mut outline = vec![(-20.0, -2.0), (12.0, -2.0), (12.0, 14.0)];
    outline.extend(top.iter().rev());
    (Scene::point().solid(&outline), top)
}

#[test]
fn scene_39_a_quarter_pipe_keeps_the_speed_or_projects_it_at_every_joint() {
    let hard = [
        (4, 4.326),
        (8, 11.421),
        (16, 14.351),
        (64, 16.567),
        (1024, 17.273),
    ];
    for (n, listed) in hard {
        for choice in [Concave::Keep, Concave::Project] {
            let (scene, top) = pipe(n);
            let scene = scene.tune(sliding).traits(|t| t.concave = Some(choice));
            // What each joint and each rise leaves, on the grid.
            let mut square: f64 = 900.0;
            for corner in top.windows(3) {
                let [a, b, c] = [corner[0], corner[1], corner[2]].map(|p| v(p.0, p.1));
                if choice == Concave::Project {
                    let cos = (b - a).normalize().dot((c - b).normalize());
                    square *= cos * cos;
                }
                square -= if c.y <= 10.0 { 60.0 * (c.y - b.y) } else { 0.0 };
            }
            scene.each(|run| {
                run.spawn(-1.0, 0.0).advance(0.0).velocity(30.0, 0.0);
                while run.at().y <= 10.0 {
                    run.wait(0.01);
                }
                let speed = f64::sqrt(run.speed().length_squared() + 60.0 * (run.at().y - 10.0));
                close(speed, square.sqrt(), 1e-9);
                let listed = if choice == Concave::Keep {
                    300.0_f64.sqrt()
                } else {
                    listed
                };
                close(speed, listed, 2e-2);
            });
        }
    }
}

#[test]
fn scene_40_a_feature_overrides_the_tuning_from_either_side() {
    let bend = Scene::point().under(&[(-10.0, 0.0), (0.0, 0.0), (15.0, 8.0)], -2.0);
    for (concave, choice, share) in [
        (1.0, Some(Concave::Keep), 1.0),
        (0.0, Some(Concave::Project), COS),
        (0.0, None, 1.0),
        (1.0, None, COS),
    ] {
        let scene = bend
            .clone()
            .tune(|t| t.concave = concave)
            .traits(|t| t.concave = choice);
        scene.each(|run| {
            run.spawn(-5.0, 0.0).walk(5.0).advance(1.5);
            close(run.speed().length(), 5.0 * share, 1e-12);
            run.spawn(7.5, 4.0).walk(-5.0).advance(2.5);
            assert!(run.at().x < 0.0);
            close(run.speed().length(), 5.0 * share, 1e-12);
        });
    }
}

#[test]
fn scene_40_of_two_features_one_that_projects_decides() {
    let joint = |a: Option<Concave>, b: Option<Concave>| {
        Scene::point()
            .rect((-10.0, 0.0), (-1.0, 0.0))
            .traits(|t| t.concave = a)
            .solid(&[(0.0, -1.0), (15.0, -1.0), (15.0, 8.0), (0.0, 0.0)])
            .traits(|t| t.concave = b)
            .tune(|t| t.concave = 1.0)
    };
    let (keep, project) = (Some(Concave::Keep), Some(Concave::Project));
    for (a, b, share) in [
        (keep, keep, 1.0),
        (keep, None, 1.0),
        (keep, project, COS),
        (None, None, COS),
    ] {
        for scene in [joint(a, b), joint(b, a)] {
            scene.each(|run| {
                run.spawn(-5.0, 0.0).walk(5.0).advance(1.5);
                close(run.speed().length(), 5.0 * share, 1e-12);
                run.spawn(7.5, 4.0).walk(-5.0).advance(2.5);
                close(run.speed().length(), 5.0 * share, 1e-12);
            });
        }
    }
}

#[test]
fn a_wall_is_no_bend_even_of_a_feature_that_keeps_the_speed() {
    let scene = Scene::boxed()
        .under(&[(-10.0, 0.0), (0.0, 0.0), (0.0, 5.0), (1.0, 5.0)], -1.0)
        .traits(|t| t.concave = Some(Concave::Keep));
    scene.each(|run| {
        run.spawn(-2.0, 0.0).walk(5.0).advance(2.0);
        run.near(-HALF, 0.0, 0.0);
        run.frozen(60);
        assert!(matches!(run.body().mode(), Mode::Surface(_)));
    });
}
