//! Ladders beside platforms that move: taken hold of from one, left onto one, and one-ways that pass a climber.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::{EventKind, Region};
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// A platform whose top starts at height 0, and a ladder. Climbing: 4 m/s at 60 m/s^2.
fn scene(velocity: DVec2, x: (f64, f64), y: (f64, f64)) -> Scene {
    Scene::boxed()
        .moving((-2.0, 2.0), (-1.0, 0.0), &[(0.0, ZERO, velocity, ZERO)])
        .region(Region::Ladder, x, y)
}

fn landed(kind: EventKind) -> bool {
    matches!(kind, EventKind::Landed(_))
}

#[test]
fn a_ladder_is_taken_hold_of_from_a_platform_that_carries_past_it() {
    // He comes into the ladder at 5 s with 2 m/s, and is driven straight from (2, 0) to (0, 4) m/s. Its foot is in the ground or
    // just flush with it.
    for low in [-1.0, 0.0] {
        let scene = scene(v(2.0, 0.0), (10.0, 12.0), (low, 30.0)).tune(|t| t.run_brake = 1000.0);
        let turns = f64::sqrt(20.0) / 60.0;
        at_every_rate(&scene, |run, rate| {
            run.spawn(0.0, 0.0).velocity(2.0, 0.0).up(true);
            run.play(4.5, rate).near(9.0, 0.0, 1e-14);
            run.play(7.0, rate);
            close(run.when(|k| k == EventKind::Climbed), 5.0, 1e-12);
            run.near(10.0 + turns, 2.0 * turns + 4.0 * (2.0 - turns), 1e-12);
            assert!(run.body().climbing());
        });
    }
}

#[test]
fn a_ladder_is_taken_hold_of_from_a_lift() {
    // Rising at 1 m/s he takes hold after 1 s, and is at 4 m/s 1/20 s later.
    let scene = scene(v(0.0, 1.0), (-1.0, 1.0), (-1.0, 30.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).velocity(0.0, 1.0).play(1.0, rate);
        run.near(0.0, 1.0, 1e-14).up(true);
        assert!(run.body().climbing());
        run.play(2.0, rate);
        run.near(0.0, 1.0 + 2.5 / 20.0 + 4.0 * 0.95, 1e-12);
    });
}

#[test]
fn a_ladder_is_left_onto_a_platform_that_passes_below() {
    // Down from 5 m: 2/15 m until 4 m/s are reached. Without friction the platform slides on under him, else it takes him along.
    let lands = (5.0 + 2.0 / 15.0) / 4.0;
    for brake in [0.0, 20.0] {
        let scene = scene(v(1.0, 0.0), (-1.0, 1.0), (-0.5, 9.0)).tune(|t| t.run_brake = brake);
        at_every_rate(&scene, |run, rate| {
            run.spawn(0.0, 5.0).down(true).play(2.0, rate);
            close(run.when(landed), lands, 1e-12);
            assert!(run.supported() && !run.body().climbing());
            assert_eq!(run.body().carrier(), Some(0));
            let slips = if brake > 0.0 { 1.0 / 20.0 } else { 2.0 - lands };
            run.near(
                2.0 - lands - slips / if brake > 0.0 { 2.0 } else { 1.0 },
                0.0,
                1e-12,
            );
        });
    }
}

#[test]
fn a_lift_takes_a_climber_off_his_ladder() {
    let scene = scene(v(0.0, 2.0), (-1.0, 1.0), (-1.0, 30.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 4.0).up(true).up(false).play(1.5, rate);
        run.near(0.0, 4.0, 0.0);
        assert!(run.body().climbing());
        run.play(3.0, rate).near(0.0, 6.0, 1e-14);
        close(run.when(|k| k == EventKind::Landed(2.0)), 2.0, 1e-12);
        assert_eq!(run.body().carrier(), Some(0));
    });
}

#[test]
fn a_moving_one_way_does_not_stop_a_climber() {
    // Neither one that he climbs through, nor one that rises through him.
    let line = || Scene::boxed().one_way(&[(-5.0, 0.0), (5.0, 0.0)]);
    let ladder = Scene::boxed().region(Region::Ladder, (-1.0, 1.0), (-1.0, 30.0));
    let scene = ladder
        .mover(line(), &[(0.0, v(0.0, 6.0), v(0.5, 0.0), ZERO)])
        .mover(line(), &[(0.0, v(0.0, -9.0), v(0.0, 8.0), ZERO)]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 8.0).up(true).up(false).down(true);
        run.play(1.5, rate);
        run.near(0.0, 8.0 + 2.0 / 15.0 - 4.0 * 1.5, 1e-12);
        run.down(false).play(3.0, rate);
        assert!(run.body().climbing() && run.speed() == ZERO);
        assert_eq!(run.kinds().into_iter().filter(|k| landed(*k)).count(), 0);
    });
}

#[test]
fn who_lets_go_over_a_moving_one_way_lands_on_it() {
    let ladder = Scene::boxed().region(Region::Ladder, (-1.0, 1.0), (-1.0, 30.0));
    let line = Scene::boxed().one_way(&[(-5.0, 0.0), (5.0, 0.0)]);
    let scene = ladder.mover(line, &[(0.0, ZERO, v(0.0, 2.0), ZERO)]);
    at_every_rate(&scene, |run, rate| {
        // It has risen to 2 m when he lets go 3 m above it: 3 - 2 t - 15 t^2.
        run.spawn(0.0, 5.0).up(true).up(false).play(1.0, rate);
        run.down(true).jump(true).jump(false).down(false);
        assert!(!run.body().climbing());
        run.play(3.0, rate).near(0.0, 6.0, 1e-13);
        let falls = (-2.0 + f64::sqrt(4.0 + 180.0)) / 30.0;
        close(run.when(landed), 1.0 + falls, 1e-12);
    });
}
