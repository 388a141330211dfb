//! Jumps as the game has them: how high a tap and a held key go, from the ground, from a buffer, and from what moves.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::EventKind;
use edgewalker::tune::Motion;
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// The game's jump: 16 m/s under 45 m/s^2, let go of braked by 900 m/s^2 to 4 m/s, no lower than 0.79 m.
fn usual(scene: Scene) -> Scene {
    scene.tune(|t| {
        let usual = Motion::default();
        (t.gravity, t.jump_speed) = (45.0, 16.0);
        (t.jump_cut_speed, t.jump_cut_brake) = (usual.jump_cut_speed, usual.jump_cut_brake);
        t.jump_least = usual.jump_least;
        assert_eq!(
            (t.jump_cut_speed, t.jump_cut_brake, t.jump_least),
            (4.0, 900.0, 0.79)
        );
    })
}

fn ground() -> Scene {
    usual(Scene::boxed().rect((-20.0, 20.0), (-1.0, 0.0)))
}

/// A deck 8 m wide, its top at y = 0.
fn deck(velocity: DVec2) -> Scene {
    usual(Scene::boxed().moving((-4.0, 4.0), (-1.0, 0.0), &[(0.0, ZERO, velocity, ZERO)]))
}

/// The apex of a jump whose key is held for so long: its time after take-off, and its height.
fn apex(held: f64) -> (f64, f64) {
    // The speed at which the brake of a tap begins, so that it rises 0.79 m.
    let square: f64 = (16.0 * 16.0 + 16.0 - 16.0 / 20.0) / 90.0 - 0.79;
    let least = (square / (1.0 / 90.0 - 1.0 / 1800.0)).sqrt();
    let begins = f64::max(held, (16.0 - least) / 45.0);
    let speed = 16.0 - 45.0 * begins;
    let height = 16.0 * begins - 22.5 * begins * begins;
    match speed > 4.0 {
        true => (
            begins + (speed - 4.0) / 900.0 + 4.0 / 45.0,
            height + (speed * speed - 16.0) / 1800.0 + 16.0 / 90.0,
        ),
        false => (16.0 / 45.0, 256.0 / 90.0),
    }
}

#[test]
fn a_tap_rises_the_least_and_a_longer_press_continuously_more() {
    let mut last = 0.0;
    for held in [
        0.001,
        1.0 / 60.0,
        1.0 / 30.0,
        0.05,
        0.1,
        0.2,
        0.26,
        0.27,
        0.3,
    ] {
        let (time, height) = apex(held);
        assert!(height >= 0.79 - 1e-12 && height >= last, "{held}: {height}");
        close(apex(held + 1e-7).1, height, 2e-6);
        last = height;
        at_every_rate(&ground(), |run, rate| {
            run.spawn(0.0, 0.0).advance(0.0).jump(true).play(held, rate);
            run.jump(false).play(time, rate);
            run.near(0.0, height, 1e-12);
            close(run.speed().y, 0.0, 1e-12);
        });
    }
    // About what it was for two ticks of the screen.
    close(apex(1.0 / 30.0).1, 0.79, 0.01);
}

#[test]
fn a_buffered_tap_is_the_same_hop_as_one_from_the_ground() {
    let lands = (2.0f64 * 0.9 / 45.0).sqrt();
    for (down, up) in [(0.09, 0.04), (0.09, 0.001), (0.05, 0.03)] {
        let (time, height) = apex(down - up);
        at_every_rate(&ground(), |run, rate| {
            run.spawn(0.0, 0.9).play(lands - down, rate).jump(true);
            run.play(lands - up, rate).jump(false);
            run.play(lands + time, rate);
            close(run.when(|k| k == EventKind::Jumped), lands, 1e-13);
            run.near(0.0, height, 1e-12);
        });
    }
}

#[test]
fn a_tap_on_a_rising_lift_rises_from_it_as_from_the_ground() {
    for velocity in [v(0.0, 12.0), v(3.0, 12.0), v(0.0, 2.0)] {
        for held in [0.01, 0.1] {
            let (time, height) = apex(held);
            at_every_rate(&deck(velocity), |run, rate| {
                run.spawn(0.0, 0.0)
                    .advance(0.0)
                    .velocity(velocity.x, velocity.y);
                run.jump(true).play(held, rate).jump(false).play(time, rate);
                run.near(velocity.x * time, velocity.y * time + height, 1e-12);
                run.play(2.0, rate);
                assert_eq!(run.body().carrier(), Some(0));
            });
        }
    }
}

#[test]
fn a_jump_takes_what_the_choice_says_of_the_velocity_that_it_leaves() {
    let cases = [
        (v(0.0, -24.0), [16.0, -8.0, 16.0]),
        (v(8.0, -3.0), [16.0, 13.0, 16.0]),
        (v(-2.0, 12.0), [28.0, 28.0, 16.0]),
        // A deck that rises faster than he jumps takes him along.
        (v(0.0, 20.0), [36.0, 36.0, 20.0]),
    ];
    for (velocity, up) in cases {
        for (choice, up) in [0.0, 1.0, 2.0].into_iter().zip(up) {
            let scene = deck(velocity).tune(|t| t.lift_jump = choice);
            at_every_rate(&scene, |run, rate| {
                run.spawn(0.0, 0.0)
                    .advance(0.0)
                    .velocity(velocity.x, velocity.y);
                run.play(0.25, rate).jump(true);
                let aside = if choice == 2.0 { 0.0 } else { velocity.x };
                assert_eq!(run.speed(), v(aside, up), "{velocity} {choice}");
            });
        }
    }
}

#[test]
fn a_jump_from_a_platform_that_crumbles_is_one() {
    // It falls by 40 m/s^2 and takes him along; he jumps half a second later, when it falls at 20 m/s.
    let falls = [(0.0, ZERO, ZERO, v(0.0, -40.0))];
    let scene = usual(Scene::boxed().moving((-4.0, 4.0), (-1.0, 0.0), &falls));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).play(0.5, rate).jump(true);
        run.play(0.75, rate);
        run.near(0.0, -5.0 + 16.0 * 0.25 - 22.5 * 0.0625, 1e-13);
    });
}
