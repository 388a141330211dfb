//! Solids that speed up and brake: what holds a body to them is asked all the time, not at its events alone.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::EventKind;
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// The laws of the game without gravity: 8 m/s, reached with 50 m/s^2 in the air; what is faster decays with 20, what is let go of
/// brakes with 30.
fn weightless(scene: Scene) -> Scene {
    scene.tune(|t| {
        (t.gravity, t.run_speed) = (0.0, 8.0);
        (t.air_accel, t.air_brake, t.over_speed_decay) = (50.0, 30.0, 20.0);
    })
}

/// A wall whose face to the right is at -1 m.
fn wall(pieces: &[(f64, DVec2, DVec2, DVec2)]) -> Scene {
    weightless(Scene::point().moving((-5.0, -1.0), (-60.0, 60.0), pieces))
}

/// 12 m/s for a second, then braking by 10 m/s^2.
fn brakes() -> [(f64, DVec2, DVec2, DVec2); 2] {
    [
        (0.0, ZERO, v(12.0, 0.0), ZERO),
        (1.0, v(12.0, 0.0), v(12.0, 0.0), v(-10.0, 0.0)),
    ]
}

fn parted(kind: EventKind) -> bool {
    kind == EventKind::Parted
}

#[test]
fn who_is_pushed_by_a_wall_leaves_it_when_it_is_slower_than_he_wishes() {
    at_every_rate(&wall(&brakes()), |run, rate| {
        run.spawn(-1.0, 0.0).hold(1.0).play(2.0, rate);
        close(run.when(parted), 1.4, 1e-15);
        run.near(19.8, 0.0, 1e-14);
        assert_eq!(run.speed(), v(8.0, 0.0));
    });
}

#[test]
fn a_wall_that_draws_back_ever_faster_is_left_at_the_speed_of_the_stick() {
    // From rest, drawing back by 10 m/s^2: the stick follows it to 8 m/s, in 0.8 s, and no further.
    let draws_back = [(0.0, ZERO, ZERO, v(-10.0, 0.0))];
    at_every_rate(&wall(&draws_back), |run, rate| {
        run.spawn(-1.0, 0.0).hold(-1.0).play(2.0, rate);
        close(run.when(parted), 0.8, 1e-15);
        run.near(-1.0 - 3.2 - 8.0 * 1.2, 0.0, 1e-14);
    });
}

#[test]
fn a_steep_slope_that_brakes_is_left_when_the_wish_is_faster() {
    // 3:4:5 and too steep, moving right at 20 m/s for a second and then braking by 10: across itself it moves at 16, and so takes
    // him along at (12.8, 9.6). Three quarters of a second later that is (8, 6).
    let pieces = [
        (0.0, ZERO, v(20.0, 0.0), ZERO),
        (1.0, v(20.0, 0.0), v(20.0, 0.0), v(-10.0, 0.0)),
    ];
    let slope = Scene::point().solid(&[(-80.0, -40.0), (0.0, -40.0), (-60.0, 40.0)]);
    let scene = weightless(Scene::point().mover(slope, &pieces));
    at_every_rate(&scene, |run, rate| {
        run.spawn(-30.0, 0.0).hold(1.0).play(3.0, rate);
        close(run.last(parted), 1.75, 1e-14);
        run.near(-30.0 + 12.8 + 7.8 + 10.0, 9.6 + 5.85 + 7.5, 1e-13);
    });
}

#[test]
fn a_lift_that_falls_ever_faster_is_left_where_a_fast_fall_ends() {
    // Down held, 1.6 times 30 m/s^2 outrun the lift's 40 up to 34 m/s: there the fall is at its end, and the lift is not.
    let falls = [(0.0, ZERO, ZERO, v(0.0, -40.0))];
    let scene = Scene::boxed()
        .moving((-2.0, 2.0), (-1.0, 0.0), &falls)
        .tune(|t| {
            (t.gravity, t.fast_fall_gravity, t.fast_fall_speed) = (30.0, 1.6, 34.0);
        });
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).down(true).play(2.0, rate);
        close(run.when(|k| k == EventKind::Left), 0.85, 1e-15);
        run.near(0.0, -20.0 * 0.85 * 0.85 - 34.0 * 1.15, 1e-13);
    });
}

#[test]
fn a_slide_at_its_terminal_speed_keeps_it_on_a_wall_that_speeds_up() {
    // The wall rises by 2 m/s^2: relative to it 20 m/s are the most, and stay the most.
    let rises = [(0.0, ZERO, ZERO, v(0.0, 2.0))];
    let scene = weightless(Scene::point().moving((-5.0, -1.0), (-600.0, 60.0), &rises))
        .tune(|t| (t.gravity, t.fall_speed) = (30.0, 20.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(-1.0, 0.0).hold(-1.0).play(2.0, rate);
        let reached = 20.0 / 32.0;
        let slid = 16.0 * reached * reached + 20.0 * (2.0 - reached);
        run.near(-1.0, 4.0 - slid, 1e-12);
        close(run.speed().y, 4.0 - 20.0, 1e-13);
    });
}
