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

/// A ladder alone, as what moves: by pieces of (time, offset, velocity, acceleration).
fn ladder(x: (f64, f64), y: (f64, f64), pieces: &[(f64, DVec2, DVec2, DVec2)]) -> Scene {
    Scene::boxed().mover(Scene::boxed().region(Region::Ladder, x, y), pieces)
}

#[test]
fn a_ladder_that_moves_carries_who_climbs_it() {
    // He takes hold at rest, and is driven straight from (-2, 0) to (0, 4) m/s, as the ladder sees it; then he goes with it.
    let scene = ladder((-9.0, 9.0), (-9.0, 90.0), &[(0.0, ZERO, v(2.0, 0.0), ZERO)]);
    let turns = f64::sqrt(20.0) / 60.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 5.0).up(true).play(3.0, rate);
        close(run.when(|k| k == EventKind::Climbed), 0.0, 0.0);
        run.near(6.0 - turns, 5.0 + 2.0 * turns + 4.0 * (3.0 - turns), 1e-12);
        assert!((run.speed() - v(2.0, 4.0)).length() < 1e-14);
        assert_eq!(run.body().carrier(), Some(0));
    });
}

#[test]
fn who_holds_on_to_a_ladder_keeps_to_it_however_it_moves() {
    // At rest with it at first; then it speeds up, jumps from 4 m/s to -1, and slows down. He never moves on it by a bit.
    let pieces = [
        (0.0, ZERO, ZERO, ZERO),
        (1.0, ZERO, ZERO, v(2.0, 1.0)),
        (3.0, v(4.0, 2.0), v(-1.0, 6.0), v(0.5, -3.0)),
        (5.0, v(3.0, 8.0), ZERO, ZERO),
    ];
    let scene = ladder((-1.0, 1.0), (-1.0, 30.0), &pieces);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.5, 4.0).up(true).up(false).play(1.0, rate);
        run.near(0.5, 4.0, 0.0);
        run.play(2.0, rate).near(1.5, 4.5, 1e-14);
        run.play(4.0, rate).near(0.5 + 3.25, 4.0 + 6.5, 1e-13);
        run.play(6.0, rate).near(3.5, 12.0, 1e-13);
        assert!(run.body().climbing() && run.speed() == ZERO);
    });
}

#[test]
fn the_end_of_a_ladder_that_moves_stops_who_climbs_it() {
    // Down from 2.5 m up the ladder, which rises: at its foot he rests, and rises with it.
    let scene = ladder(
        (-1.0, 1.0),
        (0.0, 9.0),
        &[(0.0, ZERO, v(0.0, 1.0), v(0.0, 0.5))],
    );
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 2.5).up(true).up(false).down(true);
        run.play(3.0, rate).near(0.0, 3.0 + 2.25, 1e-13);
        assert!(run.body().climbing());
        run.play(4.0, rate).near(0.0, 4.0 + 4.0, 1e-13);
        assert!((run.speed() - v(0.0, 3.0)).length() < 1e-13);
    });
}

#[test]
fn a_jump_off_a_ladder_that_moves_takes_its_velocity_along() {
    // Gravity 30, jump 12: from a ladder that goes by at (2, 3) m/s.
    let scene = ladder((-9.0, 9.0), (-9.0, 90.0), &[(0.0, ZERO, v(2.0, 3.0), ZERO)]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).velocity(2.0, 3.0).up(true).up(false);
        run.play(1.0, rate).near(2.0, 3.0, 1e-14).jump(true);
        assert_eq!(run.speed(), v(2.0, 15.0));
        assert!(!run.body().climbing() && run.body().carrier().is_none());
        run.play(1.5, rate).near(3.0, 3.0 + 7.5 - 3.75, 1e-13);
    });
}

#[test]
fn who_steps_off_a_ladder_that_moves_falls_with_its_velocity() {
    // Sideways at 4 m/s from the middle, 1 m to go: 1/15 s and 2/15 m to get going.
    let scene = ladder((-1.0, 1.0), (-9.0, 90.0), &[(0.0, ZERO, v(0.0, 2.0), ZERO)]);
    let off = 1.0 / 15.0 + (1.0 - 2.0 / 15.0) / 4.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).velocity(0.0, 2.0).up(true).up(false);
        run.hold(1.0).play(1.0, rate);
        close(run.when(|k| k == EventKind::LetGo), off, 1e-14);
        let falls = 1.0 - off;
        run.near(1.0 + 4.0 * falls, 2.0 - 15.0 * falls * falls, 1e-12);
    });
}

#[test]
fn one_who_climbs_goes_over_from_one_ladder_to_another_that_passes() {
    // A ladder stands; another one comes along and takes him with it only where the first ends.
    let other = Scene::boxed().region(Region::Ladder, (0.5, 3.0), (-9.0, 30.0));
    let scene = Scene::boxed()
        .region(Region::Ladder, (-1.0, 1.0), (-9.0, 30.0))
        .mover(other, &[(0.0, ZERO, v(0.0, 1.0), ZERO)]);
    let over = 1.0 / 15.0 + (1.0 - 2.0 / 15.0) / 4.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).up(true).up(false).hold(1.0);
        run.play(0.25, rate);
        assert_eq!(run.body().carrier(), None);
        run.play(0.5, rate).hold(0.0);
        assert_eq!(run.body().carrier(), Some(0));
        assert!(run.kinds().iter().all(|&k| k != EventKind::LetGo));
        run.play(1.0, rate);
        // From (4, -1) m/s, as the ladder sees it, he is driven to (4, 0), and at 1/2 s to rest.
        let [drives, brakes] = [1.0 / 60.0, 4.0 / 60.0];
        let y = (0.5 - over) - drives / 2.0 + 0.5;
        run.near(1.0 + 4.0 * (0.5 - over) + 2.0 * brakes, y, 1e-12);
        assert!(run.body().climbing());
    });
}

#[test]
fn a_ladder_that_goes_down_sets_its_climber_on_the_floor() {
    let scene = ladder((-1.0, 1.0), (-9.0, 9.0), &[(0.0, ZERO, v(0.0, -2.0), ZERO)])
        .rect((-9.0, 9.0), (-5.0, -4.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).velocity(0.0, -2.0).up(true).up(false);
        run.play(1.5, rate).near(0.0, -3.0, 1e-14).play(3.0, rate);
        run.near(0.0, -4.0, 0.0);
        close(run.when(landed), 2.0, 1e-14);
        assert!(run.supported() && !run.body().climbing());
        assert_eq!(run.body().carrier(), None);
    });
}

#[test]
fn a_ladder_on_a_lift_is_climbed_from_its_deck_and_down_to_it() {
    // The lift rises from rest with 1 m/s^2; the deck is at 0 and the ladder on it 6 m high.
    let lift = Scene::boxed().rect((-2.0, 2.0), (-1.0, 0.0)).region(
        Region::Ladder,
        (-1.0, 1.0),
        (0.0, 6.0),
    );
    let scene = Scene::boxed().mover(lift, &[(0.0, ZERO, ZERO, v(0.0, 1.0))]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).play(1.0, rate).near(0.0, 0.5, 1e-14);
        run.up(true).play(2.0, rate);
        // 2/15 m until he climbs at 4 m/s.
        run.near(0.0, 2.0 + 2.0 / 15.0 + 4.0 * (1.0 - 1.0 / 15.0), 1e-12);
        run.play(4.0, rate).near(0.0, 8.0 + 6.0, 1e-12);
        assert!(run.body().climbing(), "at its top");
        run.up(false).down(true).play(6.0, rate);
        run.near(0.0, 18.0, 1e-12);
        assert!(run.supported() && run.body().carrier() == Some(0));
    });
}

#[test]
fn a_wall_holds_back_who_climbs_a_ladder_that_passes_it() {
    // The wall's side is at 3 m, he is 13/32 m wide: the ladder leaves him there, 6 m long, with its far end.
    let scene = ladder((-3.0, 3.0), (-9.0, 30.0), &[(0.0, ZERO, v(2.0, 0.5), ZERO)])
        .rect((3.0, 4.0), (-20.0, 40.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).velocity(2.0, 0.5).up(true).up(false);
        run.play(2.0, rate).near(3.0 - HALF, 1.0, 1e-12);
        assert!(run.body().climbing(), "it carries him up along the wall");
        run.play(2.5, rate).near(3.0 - HALF, 1.25, 1e-12);
        // Its near end, at -3 + 2 t, passes him there.
        run.play(4.0, rate);
        close(
            run.when(|k| k == EventKind::LetGo),
            (6.0 - HALF) / 2.0,
            1e-12,
        );
    });
}
