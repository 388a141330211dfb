//! Moving solids that are started at run time: where a body is then changes by no bit, whatever it has to do with them.

use super::ledges::hanging;
use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::EventKind;
use edgewalker::motion::grip::Grip;
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// Eased: 3 m/s^2 for a second, and the same back. Or at once, at 2 m/s.
fn ways(towards: DVec2) -> [Vec<(f64, DVec2, DVec2, DVec2)>; 2] {
    let a = towards * 3.0;
    [
        vec![
            (0.0, ZERO, ZERO, a),
            (1.0, a * 0.5, a, -a),
            (2.0, a, ZERO, ZERO),
        ],
        vec![(0.0, ZERO, towards * 2.0, ZERO)],
    ]
}

/// How far such a way has come at a time after its start.
fn offset(way: &[(f64, DVec2, DVec2, DVec2)], t: f64) -> DVec2 {
    let &(t0, p, u, a) = way.iter().rfind(|p| p.0 <= t).unwrap();
    p + u * (t - t0) + a * (0.5 * (t - t0) * (t - t0))
}

/// When the movers of these scenes are started: at no tick of any rate.
const AT: f64 = 1.03;

fn starting(mut scene: Scene) -> Scene {
    scene.starts = Some(AT);
    scene
}

#[test]
fn a_lift_starts_under_its_rider() {
    for towards in [v(0.0, 1.0), v(1.0, 1.0), v(-1.0, 0.0), v(0.0, -1.0)] {
        for (eased, way) in ways(towards).into_iter().enumerate() {
            let scene = starting(Scene::boxed().moving((-9.0, 9.0), (-1.0, 0.0), &way))
                .tune(|t| t.run_brake = 1e9);
            at_every_rate(&scene, |run, rate| {
                run.spawn(0.3, 0.0).play(AT, rate).near(0.3, 0.0, 0.0);
                run.trace.clear();
                run.start();
                assert_eq!(run.kinds().first(), Some(&EventKind::Node(0)));
                if eased == 1 && towards.y < 0.0 {
                    // Away from under him at once: he falls after it.
                    assert!(run.airborne());
                    run.play(AT + 0.1, rate).near(0.3, -0.15, 1e-14);
                }
                for tenth in 3..30 {
                    let t = f64::from(tenth) / 10.0;
                    run.play(AT + t, rate);
                    let at = offset(&way, t);
                    run.near(0.3 + at.x, at.y, 1e-12);
                }
            });
        }
    }
}

#[test]
fn a_lift_starts_under_a_walker() {
    let way = &ways(v(0.0, 1.0))[0];
    let scene = starting(Scene::boxed().moving((-9.0, 9.0), (-1.0, 0.0), way));
    at_every_rate(&scene, |run, rate| {
        run.spawn(-4.3, 0.0).walk(2.7).play(AT, rate).start();
        run.play(AT + 1.5, rate);
        run.near(-4.3 + 2.7 * (AT + 1.5), offset(way, 1.5).y, 1e-13);
        assert_eq!(run.body().carrier(), Some(0));
    });
}

#[test]
fn a_door_starts_beside_who_leans_on_it() {
    let floor = || Scene::boxed().rect((-20.0, 20.0), (-1.0, 0.0));
    let door = |way: &[_]| starting(floor().moving((2.0, 3.0), (0.0, 3.0), way));
    // Up, away from him, and towards him.
    let [eased, _] = ways(v(0.0, 1.0));
    at_every_rate(&door(&eased).tune(|t| t.run_accel = 10.0), |run, rate| {
        run.spawn(0.0, 0.0).walk(5.0).play(AT, rate);
        run.near(2.0 - HALF, 0.0, 0.0).start();
        // Clear of it after sqrt(2 TALL / 3) s and more: in its second half.
        let clear = AT + 2.0 - f64::sqrt(2.0 * (3.0 - TALL) / 3.0);
        run.play(clear + 0.25, rate);
        run.near(2.0 - HALF + 5.0 / 16.0, 0.0, 1e-12);
    });
    let [_, away] = ways(v(1.0, 0.0));
    at_every_rate(&door(&away).tune(|t| t.run_accel = 10.0), |run, rate| {
        run.spawn(0.0, 0.0).walk(5.0).play(AT, rate);
        run.near(2.0 - HALF, 0.0, 0.0).start();
        // 10 m/s^2 make 5 m/s; the door keeps 2 ahead until he is at it again after 0.4 s, and then leads.
        run.play(AT + 1.0, rate).near(4.0 - HALF, 0.0, 1e-13);
    });
    for way in ways(v(-1.0, 0.0)) {
        let leans = door(&way).tune(|t| (t.run_accel, t.run_brake) = (10.0, 10.0));
        at_every_rate(&leans, |run, rate| {
            run.spawn(0.0, 0.0).walk(5.0).play(AT, rate);
            run.near(2.0 - HALF, 0.0, 0.0).start();
            for tenth in 1..20 {
                let t = f64::from(tenth) / 10.0;
                run.play(AT + t, rate);
                run.near(2.0 - HALF + offset(&way, t).x, 0.0, 1e-13);
            }
            assert_eq!(run.body().pushed_by(), Some(0));
        });
    }
}

#[test]
fn a_wall_starts_under_who_hangs_from_it() {
    for towards in [v(0.0, 1.0), v(1.0, -1.0), v(-1.0, 0.0)] {
        for way in ways(towards) {
            let scene = starting(hanging(Scene::boxed().moving(
                (0.0, 5.0),
                (-60.0, 0.0),
                &way,
            )));
            at_every_rate(&scene, |run, rate| {
                run.spawn(-HALF, -0.5).hold(1.0).play(AT, rate);
                run.near(-HALF, -1.25, 0.0).start();
                for tenth in 1..30 {
                    let t = f64::from(tenth) / 10.0;
                    run.play(AT + t, rate);
                    let at = offset(&way, t);
                    run.near(at.x - HALF, at.y - 1.25, 1e-13);
                    assert_eq!(run.body().grip(), Grip::Ledge);
                }
            });
        }
    }
}

#[test]
fn what_starts_far_away_changes_no_bit() {
    // Walking, in flight, hanging, climbing down a ladder of its own: once with the start and once without.
    let way = &ways(v(1.0, 1.0))[0];
    let slopes = [
        (-50.0, 3.0),
        (-7.0, 1.0),
        (0.0, 0.0),
        (11.0, 2.0),
        (40.0, 0.0),
    ];
    let scene = starting(
        steering_on(&slopes)
            .moving((300.0, 305.0), (0.0, 4.0), way)
            .moving((-2.0, 2.0), (20.0, 21.0), &[(0.0, ZERO, ZERO, ZERO)]),
    );
    for variant in [Variant::Plain, Variant::Mirrored, Variant::Shifted] {
        let story = |starts: bool| {
            let told = std::cell::RefCell::new(Vec::new());
            scene.with(variant, &|run: &mut Run| {
                run.spawn(-30.7, 4.0).hold(0.7);
                for tick in 1..=240u32 {
                    if starts && tick == 62 {
                        run.advance(AT).start();
                    }
                    run.jump(tick % 37 > 30)
                        .hold(if tick > 150 { -0.3 } else { 0.7 });
                    run.advance(f64::from(tick) / 60.0);
                    told.borrow_mut()
                        .push((run.body().mode().clone(), run.body().hash()));
                }
            });
            told.into_inner()
        };
        assert_eq!(story(true), story(false), "{variant:?}");
    }
}

/// Slopes, and every acceleration of a run.
fn steering_on(top: &[(f64, f64)]) -> Scene {
    Scene::boxed().under(top, -3.0).tune(|t| {
        (t.run_accel, t.run_brake, t.air_accel) = (37.0, 41.0, 13.0);
        (t.air_brake, t.jump_speed) = (7.0, 9.1);
    })
}
