//! Scene 60 with one-ways that move: passed from below, landed on, ridden without a distance, dropped through on the way.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::EventKind;
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// A one-way from -5 to 5 at height 0 that moves by pieces.
fn platform(pieces: &[(f64, DVec2, DVec2, DVec2)]) -> Scene {
    let line = Scene::boxed().one_way(&[(-5.0, 0.0), (5.0, 0.0)]);
    Scene::boxed().mover(line, pieces)
}

/// At a constant velocity.
fn steady(velocity: DVec2) -> Scene {
    platform(&[(0.0, ZERO, velocity, ZERO)])
}

fn landed(kind: EventKind) -> bool {
    matches!(kind, EventKind::Landed(_))
}

/// Asks to fall through.
fn ask(run: &mut Run) {
    run.down(true).jump(true).jump(false).down(false);
}

#[test]
fn scene_60_a_one_way_that_rises_at_ten_keeps_no_distance() {
    at_every_rate(&steady(v(0.0, 10.0)), |run, rate| {
        run.spawn(0.5, 0.0);
        run.trace.clear();
        for tenth in 1..=50 {
            let t = f64::from(tenth) / 10.0;
            run.play(t, rate).near(0.5, 10.0 * t, 1e-13);
        }
        assert_eq!(run.kinds(), []);
        assert_eq!(run.body().carrier(), Some(0));
    });
}

#[test]
fn scene_60_a_one_way_that_rises_is_jumped_through_and_landed_on() {
    // From 1 m below at 12 m/s; it rises at 2: relative to it -1 + 10 t - 15 t^2.
    let scene = steady(v(0.5, 2.0)).rect((-5.0, 5.0), (-2.0, -1.0));
    let root = f64::sqrt(40.0);
    let back = (10.0 + root) / 30.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, -1.0).jump(true).play(0.2, rate);
        run.near(0.0, -1.0 + 2.4 - 0.6, 1e-14).play(0.5, rate);
        assert!(run.airborne());
        run.play(2.0, rate);
        close(run.last(landed), back, 1e-12);
        let hardness = run.kinds().iter().rev().find_map(|k| match k {
            EventKind::Landed(into) => Some(*into),
            _ => None,
        });
        close(hardness.unwrap(), root, 1e-12);
        // Without friction it slides under him.
        run.near(0.0, 4.0, 1e-14);
        assert_eq!((run.speed(), run.body().carrier()), (v(0.0, 2.0), Some(0)));
    });
}

#[test]
fn scene_60_an_apex_exactly_on_a_moving_one_way_has_not_crossed() {
    // It rises at 2 m/s from 2.25 m up: at 14 m/s and 32 m/s^2 he meets it after 3/8 s, neither rising nor falling.
    let scene = platform(&[(0.0, v(0.0, 2.25), v(0.0, 2.0), ZERO)])
        .rect((-5.0, 5.0), (-1.0, 0.0))
        .tune(|t| (t.gravity, t.jump_speed) = (32.0, 14.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).jump(true).play(0.375, rate);
        run.near(0.0, 3.0, 0.0).play(0.875, rate);
        let at = run.when(|k| k == EventKind::Landed(14.0));
        assert_eq!(at, 0.875);
        run.near(0.0, 0.0, 0.0).frozen(60);
    });
}

#[test]
fn scene_60_a_moving_one_way_is_dropped_through() {
    // At a constant velocity, and rising ever faster from rest: each way relative to it he falls from rest.
    for (velocity, accel) in [
        (v(3.0, 2.0), ZERO),
        (v(3.0, -2.0), ZERO),
        (v(0.0, 0.0), v(1.0, 4.0)),
        (v(1.0, 6.0), v(0.0, -8.0)),
    ] {
        let scene = platform(&[(0.0, ZERO, velocity, accel)]).tune(|t| t.run_brake = 1000.0);
        at_every_rate(&scene, |run, rate| {
            run.spawn(0.0, 0.0).velocity(velocity.x, velocity.y);
            run.play(0.5, rate);
            let (p, u) = (run.at(), run.speed());
            close((u - velocity - accel * 0.5).length(), 0.0, 1e-12);
            ask(run);
            let at = run.last(|k| k == EventKind::Dropped);
            assert_eq!(at, 0.5);
            assert_eq!((run.at(), run.speed()), (p, u));
            run.play(1.5, rate);
            run.near(p.x + u.x, p.y + u.y - 15.0, 1e-12);
            assert!(!run.kinds().into_iter().skip(1).any(landed));
        });
    }
}

#[test]
fn scene_60_a_one_way_that_rises_from_the_floor_takes_along_who_stands_there() {
    let scene = platform(&[(0.0, v(0.0, -3.0), v(0.0, 2.0), ZERO)]).rect((-9.0, 9.0), (-1.0, 0.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).play(1.25, rate);
        assert_eq!(run.body().carrier(), None);
        run.play(3.0, rate).near(0.0, 3.0, 1e-14);
        assert_eq!(run.body().carrier(), Some(0));
        close(run.when(|k| k == EventKind::Boarded(Some(0))), 1.5, 0.0);
    });
}

#[test]
fn scene_60_a_one_way_that_comes_from_above_or_aside_passes_through_a_body() {
    let floor = Scene::boxed().rect((-20.0, 20.0), (-1.0, 0.0));
    let line = || Scene::boxed().one_way(&[(-5.0, 0.0), (5.0, 0.0)]);
    let scene = floor
        .mover(line(), &[(0.0, v(0.0, 5.0), v(0.0, -4.0), ZERO)])
        .mover(line(), &[(0.0, v(-12.0, 0.5), v(9.0, 0.0), ZERO)])
        .mover(line(), &[(0.0, v(-12.0, TALL), v(7.0, 0.0), ZERO)]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0);
        run.trace.clear();
        run.play(4.0, rate).near(0.0, 0.0, 0.0);
        assert_eq!(run.kinds(), []);
    });
}

#[test]
fn scene_60_a_one_way_that_falls_below_the_floor_leaves_who_rides_it_there() {
    let scene = platform(&[(0.0, v(0.0, 4.0), v(0.0, -2.0), ZERO)]).rect((-9.0, 9.0), (-1.0, 0.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 4.0).velocity(0.0, -2.0).play(1.5, rate);
        run.near(0.0, 1.0, 1e-14).play(4.0, rate);
        run.near(0.0, 0.0, 0.0).frozen(60);
        close(run.when(|k| k == EventKind::Boarded(None)), 2.0, 1e-12);
    });
}
