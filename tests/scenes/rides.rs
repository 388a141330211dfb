//! Belts on what moves, and what closes on a body in the air.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::{EventKind, Mode};
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// A lift 4 m wide whose top, a belt, starts at height 0.
fn belt(speed: f64, pieces: &[(f64, DVec2, DVec2, DVec2)]) -> Scene {
    let deck = Scene::boxed()
        .rect((-2.0, 2.0), (-1.0, 0.0))
        .traits(|t| t.conveyor = speed);
    Scene::boxed()
        .mover(deck, pieces)
        .tune(|t| t.run_brake = 50.0)
}

#[test]
fn scene_59_a_belt_on_a_lift_moves_along_with_both() {
    // At rest in the world at first: -1 m/s over the deck, which the belt makes 3 in 0.08 s and 0.08 m.
    let scene = belt(3.0, &[(0.0, ZERO, v(1.0, 2.0), ZERO)]);
    // The foot's other corner comes off the deck 2 m and half a body on.
    let off = 0.08 + (2.0 + HALF + 1.0 - 0.08) / 3.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(-1.0, 0.0).play(0.5, rate);
        run.near(-1.0 + 0.5 + 0.08 + 3.0 * 0.42, 1.0, 1e-14);
        assert_eq!(run.speed(), v(4.0, 2.0));
        run.play(off + 0.5, rate);
        close(run.when(|k| k == EventKind::Left), off, 1e-12);
        let x = 2.0 + HALF + off + 4.0 * 0.5;
        run.near(x, 2.0 * off + 1.0 - 3.75, 1e-12);
    });
}

#[test]
fn scene_59_a_belt_against_the_way_of_its_deck_holds_a_body_in_place() {
    let scene = belt(-2.0, &[(0.0, ZERO, v(2.0, 0.0), ZERO)]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).play(0.5, rate);
        run.near(0.0, 0.0, 0.0).play(0.75, rate);
        run.near(0.0, 0.0, 0.0);
        assert_eq!(run.speed(), ZERO);
        // Off the deck's back after (2 + HALF) / 2 s, straight down.
        run.play(2.0, rate);
        let off = (2.0 + HALF) / 2.0;
        close(run.when(|k| k == EventKind::Left), off, 1e-12);
        run.near(0.0, -15.0 * (2.0 - off) * (2.0 - off), 1e-13);
    });
}

/// Two walls that close at these speeds, 3 m to either side at first.
fn closing(left: f64, right: f64) -> Scene {
    Scene::boxed()
        .moving(
            (-9.0, -3.0),
            (-90.0, 90.0),
            &[(0.0, ZERO, v(left, 0.0), ZERO)],
        )
        .moving(
            (3.0, 9.0),
            (-90.0, 90.0),
            &[(0.0, ZERO, v(-right, 0.0), ZERO)],
        )
}

#[test]
fn scene_56_walls_that_close_crush_in_mid_air() {
    for (left, right) in [(2.0, 2.0), (3.0, 1.0), (0.0, 4.0)] {
        let crushed = (6.0 - 2.0 * HALF) / (left + right);
        at_every_rate(&closing(left, right), |run, rate| {
            run.spawn(0.25, 40.0).play(2.0, rate);
            close(run.when(|k| k == EventKind::Crushed), crushed, 1e-12);
            // Until then it fell freely, along one of them at last.
            let x = -3.0 + left * crushed + HALF;
            run.near(x, 40.0 - 15.0 * crushed * crushed, 1e-12);
            assert!(matches!(run.body().mode(), Mode::Crushed(_)));
            run.frozen(60);
        });
    }
}

#[test]
fn scene_56_a_wall_that_comes_crushes_against_one_that_stands() {
    let scene = Scene::boxed().rect((3.0, 9.0), (-90.0, 90.0)).moving(
        (-9.0, -3.0),
        (-90.0, 90.0),
        &[(0.0, ZERO, v(4.0, -5.0), ZERO)],
    );
    let crushed = (6.0 - 2.0 * HALF) / 4.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 40.0).play(2.0, rate);
        close(run.when(|k| k == EventKind::Crushed), crushed, 1e-12);
        run.near(3.0 - HALF, 40.0 - 15.0 * crushed * crushed, 1e-12);
    });
}

#[test]
fn scene_56_a_floor_and_a_ceiling_that_close_crush_in_mid_air() {
    // The floor rises at 3 m/s from -2, the ceiling falls at 2 from 5: the feet land on the floor first.
    let scene = Scene::boxed()
        .moving((-4.0, 4.0), (-4.0, -2.0), &[(0.0, ZERO, v(0.0, 3.0), ZERO)])
        .moving((-4.0, 4.0), (5.0, 7.0), &[(0.0, ZERO, v(0.0, -2.0), ZERO)]);
    let crushed = (7.0 - TALL) / 5.0;
    let lands = (-3.0 + f64::sqrt(9.0 + 120.0)) / 30.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.5, 0.0).play(2.0, rate);
        close(
            run.when(|k| matches!(k, EventKind::Landed(_))),
            lands,
            1e-14,
        );
        close(run.when(|k| k == EventKind::Crushed), crushed, 1e-12);
        run.near(0.5, -2.0 + 3.0 * crushed, 1e-13);
    });
    // And struck by both at once, in the middle of a flight.
    let both = Scene::boxed()
        .moving((-4.0, 4.0), (-4.0, -1.0), &[(0.0, ZERO, v(0.0, 8.0), ZERO)])
        .moving(
            (-4.0, 4.0),
            (2.0 + TALL - 1.0, 9.0),
            &[(0.0, ZERO, v(0.0, -8.0), v(0.0, 0.0))],
        )
        .tune(|t| t.gravity = 0.0);
    at_every_rate(&both, |run, rate| {
        run.spawn(0.5, 0.0).play(1.0, rate);
        close(run.when(|k| k == EventKind::Crushed), 0.125, 1e-12);
        run.near(0.5, 0.0, 1e-14);
    });
}
