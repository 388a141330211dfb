//! Steps that are too high to be walked up stop a walker at his foot, whatever of his foot is bevelled.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::geom::Collider;
use edgewalker::motion::{Concave, EventKind};

/// How far before the step the hero's foot stops: where its bevelled flank, 5/32 m wide and 11/32 m high, touches the edge.
fn before(height: f64) -> f64 {
    let (foot, flank, hip) = (0.25, 5.0 / 32.0, 11.0 / 32.0);
    foot + flank * (height / hip).min(1.0)
}

fn step(height: f64) -> Scene {
    Scene {
        stand: Collider::hero(),
        crouch: Collider::hero_crouched(),
        ..Scene::boxed()
    }
    .rect((-50.0, 50.0), (-1.0, 0.0))
    .rect((0.0, 50.0), (-1.0, height))
    .tune(|t| (t.step_up, t.run_accel, t.run_brake) = (0.2, 80.0, 100.0))
}

#[test]
fn a_step_that_is_too_high_stops_a_walker_without_lifting_him() {
    for height in [
        0.2 + 1.0 / 1024.0,
        0.25,
        0.28125,
        0.3,
        0.34375,
        0.35,
        0.4,
        0.5,
        1.0,
    ] {
        at_every_rate(&step(height), |run, rate| {
            for speed in [0.5, 2.0, 5.0, 20.0, 60.0] {
                run.trace.clear();
                run.terrain.tuning = Box::leak(Box::new(edgewalker::tune::Motion {
                    run_speed: speed,
                    ..run.terrain.tuning.clone()
                }));
                run.spawn(-3.0, 0.0).walk(speed);
                let met = (3.0 - before(height)) / speed;
                let mut t = 0.0;
                while t < met + 1.0 {
                    t += 1.0 / 32.0;
                    run.play(t, rate);
                    close(run.at().y, 0.0, 0.0);
                    assert!(run.supported());
                }
                // The foot of the flank is a grid point: half a step per axis, and its slope.
                run.near(-before(height), 0.0, 4e-5);
                close(
                    run.when(|k| matches!(k, EventKind::Stopped(v) if v == speed)),
                    met,
                    4e-5 / speed,
                );
                let rests = run.at();
                run.frozen(60).hold(0.0).frozen(60);
                // Away from it again at once.
                let t = run.time();
                run.hold(-1.0).play(t + 0.25, rate);
                assert!(run.at().x < rests.x && run.supported());
            }
        });
    }
}

#[test]
fn a_step_of_its_limit_is_walked_up() {
    at_every_rate(&step(0.1875), |run, rate| {
        run.spawn(-3.0, 0.0).walk(5.0).play(2.0, rate);
        assert!(run.supported());
        close(run.at().y, 0.1875, 0.0);
    });
}

#[test]
fn it_stops_him_on_ground_that_keeps_the_speed_round_bends_too() {
    let keep = step(0.3).traits(|t| t.concave = Some(Concave::Keep));
    at_every_rate(&keep, |run, rate| {
        run.spawn(-3.0, 0.0).walk(5.0).play(2.0, rate);
        run.near(-before(0.3), 0.0, 4e-5);
    });
}

#[test]
fn it_stops_who_slides_on_without_a_wish_and_who_crouches() {
    at_every_rate(&step(0.3).tune(|t| t.run_brake = 0.0), |run, rate| {
        run.spawn(-3.0, 0.0).walk(5.0).hold(0.0).play(2.0, rate);
        run.near(-before(0.3), 0.0, 4e-5).frozen(60);
        run.spawn(-3.0, 0.0).down(true).walk(5.0).play(3.0, rate);
        run.near(-before(0.3), 0.0, 4e-5).frozen(60);
        assert!(run.crouched());
    });
}

#[test]
fn a_slope_that_begins_with_a_lip_of_rounding_is_run_up_as_before() {
    // A wedge of 60 degrees laid on the floor, at many places: its foot is in line with the floor.
    let scene = |x: f64| {
        Scene {
            stand: Collider::hero(),
            crouch: Collider::hero_crouched(),
            ..Scene::boxed()
        }
        .rect((-50.0, 50.0), (-1.0, 0.1))
        .solid(&[(x, 0.1), (x + 3.0, 0.1), (x + 3.0, 5.3)])
        .tune(|t| t.step_up = 0.2)
    };
    for i in 0..40 {
        scene(0.017 * f64::from(i)).each(|run| {
            let floor = run
                .terrain
                .stand
                .locate(run.variant.there(v(-3.0, 0.1)), None);
            assert!(floor.is_some());
            run.spawn(-3.0, 0.25).advance(0.5).walk(5.0).advance(1.5);
            let highest = run
                .kinds()
                .into_iter()
                .any(|k| matches!(k, EventKind::Hit(_)));
            assert!(highest, "{i}: {:?}", run.trace.events);
        });
    }
}
