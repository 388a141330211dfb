//! Belts faster than the runner, and belts that lie flush over each other.

use super::ledges::hanging;
use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::EventKind;

/// 8 m/s, reached with 80 m/s^2, braked with 100; what is faster decays with 20.
fn running(scene: Scene) -> Scene {
    scene.tune(|t| {
        (t.run_speed, t.run_accel, t.run_brake, t.over_speed_decay) = (8.0, 80.0, 100.0, 20.0);
    })
}

/// Floor up to x = 0, and a belt from there on.
fn floor_and_belt(speed: f64) -> Scene {
    let scene = Scene::point().rect((-20.0, 0.0), (-1.0, 0.0));
    running(
        scene
            .rect((0.0, 40.0), (-1.0, 0.0))
            .traits(|t| t.conveyor = speed),
    )
}

#[test]
fn a_runner_enters_a_faster_belt_and_is_carried_back() {
    // He comes to it after half a second. Against 8.1 m/s his 8 decay by 20 m/s^2 to -0.1: he turns after 0.4 s, 1.6 m in.
    at_every_rate(&floor_and_belt(-8.1), |run, rate| {
        run.spawn(-4.0, 0.0).walk(8.0).play(0.75, rate);
        run.near(8.0 * 0.25 - 10.0 * 0.0625, 0.0, 1e-12)
            .play(1.5, rate);
        let slows = 0.1 / 20.0;
        let turned = 1.6 - 10.0 * slows * slows;
        run.near(turned - 0.1 * (1.5 - 0.9 - slows), 0.0, 1e-12);
        close(run.speed().x, -0.1, 1e-12);
        // Back at the edge he stays there, running.
        let back = 0.9 + slows + turned / 0.1;
        run.play(back + 0.001, rate)
            .near(0.0, 0.0, 1e-12)
            .frozen(600);
        assert!(run.kinds().len() < 12, "{:?}", run.kinds());
    });
    // Twice as fast as he it brings him back as fast as he came, and no further.
    at_every_rate(&floor_and_belt(-20.0), |run, rate| {
        run.spawn(-4.0, 0.0).walk(8.0).play(1.2, rate);
        run.near(8.0 * 0.7 - 10.0 * 0.49, 0.0, 1e-12)
            .play(1.4, rate);
        run.near(0.0, 0.0, 1e-12).frozen(600);
        assert!(run.kinds().len() < 12, "{:?}", run.kinds());
        // Let go of, he stays on the floor; the other way he runs off.
        run.hold(-1.0).wait(0.5);
        assert!(run.at().x < -2.0 && run.supported());
    });
}

#[test]
fn a_runner_is_not_stopped_by_a_belt_that_runs_with_him() {
    at_every_rate(&floor_and_belt(8.1), |run, rate| {
        run.spawn(-4.0, 0.0).walk(8.0).play(1.0, rate);
        // From 8 to the 8.1 m/s of the belt by 100 m/s^2, from there to 16.1 by 80.
        let way = 8.05 * 0.001 + 12.1 * 0.1 + 16.1 * (0.5 - 0.101);
        run.near(way, 0.0, 1e-12);
        assert!(
            !run.kinds()
                .iter()
                .any(|k| matches!(k, EventKind::Stopped(_)))
        );
    });
}

/// Belts from x = 0 to 20, all with the same top, in an order.
fn flush(speeds: &[f64]) -> Scene {
    let belt = |scene: Scene, &speed: &f64| {
        let belt = scene.rect((0.0, 20.0), (-1.0, 0.0));
        belt.traits(|t| t.conveyor = speed)
    };
    running(speeds.iter().fold(Scene::point(), belt))
}

#[test]
fn of_flush_belts_the_faster_one_counts_whatever_their_order() {
    for (speeds, counts) in [
        (&[2.0, -3.0][..], -3.0),
        (&[-3.0, 2.0], -3.0),
        (&[1.0, 4.0, 2.0], 4.0),
        (&[4.0, 2.0, 1.0], 4.0),
        (&[2.0, 1.0, 4.0], 4.0),
        // As fast the other way: neither moves.
        (&[3.0, -3.0], 0.0),
        (&[-3.0, 3.0], 0.0),
        (&[-3.0, 1.0, 3.0], 0.0),
    ] {
        at_every_rate(&flush(speeds), |run, rate| {
            run.spawn(10.0, 0.0).play(1.0, rate);
            close(run.speed().x, counts, 1e-12);
            let gains = counts.abs() / 100.0;
            let away = counts.signum() * 50.0 * gains * gains + counts * (1.0 - gains);
            run.near(10.0 + if counts == 0.0 { 0.0 } else { away }, 0.0, 1e-12);
        });
    }
}

#[test]
fn belts_that_overlap_in_part_do_not_depend_on_their_order_either() {
    // From 5 to 10 both are there, as long and as fast as each other.
    let belts = [((0.0, 10.0), 3.0), ((5.0, 15.0), -3.0)];
    for order in [[0, 1], [1, 0]] {
        let add = |scene: Scene, i: usize| {
            let (x, speed) = belts[i];
            scene.rect(x, (-1.0, 0.0)).traits(|t| t.conveyor = speed)
        };
        let scene = running(order.into_iter().fold(Scene::point(), add));
        at_every_rate(&scene, |run, rate| {
            // Braked from 3 m/s by 100 m/s^2.
            run.spawn(2.0, 0.0).play(4.0, rate).near(5.045, 0.0, 1e-12);
            run.frozen(600);
        });
    }
}

#[test]
fn flush_walls_can_be_climbed_if_one_of_them_can_whatever_their_order() {
    for climbable in [[true, false], [false, true]] {
        let wall = |scene: Scene, can: bool| {
            let wall = scene.rect((0.0, 5.0), (-60.0, 0.0));
            wall.traits(|t| t.climbable = can)
        };
        let scene = climbable.into_iter().fold(Scene::boxed(), wall);
        let scene = hanging(scene).tune(|t| t.ledge_hang = 0.0);
        at_every_rate(&scene, |run, rate| {
            run.spawn(-HALF, -10.0).hold(1.0).play(1.0, rate);
            assert!(run.kinds().contains(&EventKind::Climbed), "{climbable:?}");
            let held = run.at().y;
            run.up(true).play(2.0, rate);
            close(run.at().y - held, 4.0 - 2.0 / 15.0, 1e-9);
        });
    }
}
