//! Walls that move: slides along them, jumps from them, hanging from their ledges, climbing them. All of it happens in the
//! frame of the wall, so numbers are those of a wall at rest, with the wall's own motion added.

use super::ledges::hanging;
use super::moving::at_every_rate;
use super::rig::*;
use super::walls::steering;
use edgewalker::motion::grip::Grip;
use edgewalker::motion::{Control, EventKind};
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// A wall from x = 0 on, its top at y = 0, that moves by pieces.
fn cliff(pieces: &[(f64, DVec2, DVec2, DVec2)]) -> Scene {
    Scene::boxed().moving((0.0, 5.0), (-60.0, 0.0), pieces)
}

/// At a constant velocity.
fn steady(velocity: DVec2) -> Scene {
    cliff(&[(0.0, ZERO, velocity, ZERO)])
}

fn has(run: &Run, kind: EventKind) -> bool {
    run.kinds().contains(&kind)
}

#[test]
fn a_slide_along_a_moving_wall_is_slowed_relative_to_it() {
    // The wall comes at 1.5 m/s and rises at 2: from rest the slide begins at 2 m/s down it, and 30 m/s^2 make it 6.
    let scene = steering(steady(v(-1.5, 2.0))).tune(|t| t.wall_slide_speed = 6.0);
    let braked = 4.0 / 30.0;
    let fell = 2.0 * braked + 15.0 * braked * braked;
    at_every_rate(&scene, |run, rate| {
        run.spawn(-HALF, -4.0).hold(1.0).play(1.0, rate);
        let down = fell + 6.0 * (1.0 - braked);
        run.near(-HALF - 1.5, -4.0 + 2.0 - down, 1e-12);
        assert_eq!(run.speed(), v(-1.5, -4.0));
        assert_eq!(run.body().carrier(), Some(0));
        // Let go of, it is a free fall again, and the stick away leaves it.
        run.hold(0.0).play(1.5, rate);
        close(run.speed().y, -4.0 - 15.0, 1e-12);
        run.near(-HALF - 2.25, -2.0 - down - 2.0 - 3.75, 1e-12);
    });
}

#[test]
fn a_jump_from_a_moving_wall_has_all_of_its_velocity_but_a_fall() {
    for (velocity, choice) in [
        (v(-1.5, 2.0), 0.0),
        (v(-2.0, -3.0), 0.0),
        (v(-2.0, -3.0), 1.0),
        (v(0.0, 4.0), 0.0),
        (v(-1.5, 2.0), 2.0),
    ] {
        let taken = match choice {
            0.0 => v(velocity.x, velocity.y.max(0.0)),
            1.0 => velocity,
            _ => ZERO,
        };
        let scene = steering(steady(velocity))
            .tune(|t| (t.wall_jump_out, t.wall_jump_up, t.wall_slide_speed) = (6.0, 10.0, 6.0))
            .tune(|t| t.lift_jump = choice);
        at_every_rate(&scene, |run, rate| {
            run.spawn(-HALF, -4.0).hold(1.0).play(0.5, rate);
            let at = run.at();
            run.hold(0.0).jump(true);
            assert!(has(run, EventKind::WallJumped) && run.airborne());
            assert_eq!(run.speed(), v(-6.0, 10.0) + taken);
            run.play(1.0, rate);
            let (x, y) = (-3.0 + 0.5 * taken.x, 5.0 + 0.5 * taken.y - 3.75);
            run.near(at.x + x, at.y + y, 1e-12);
        });
    }
}

/// There and back along x and y, with accelerations.
fn sway() -> [(f64, DVec2, DVec2, DVec2); 3] {
    let a = v(2.0, -3.0);
    [
        (0.0, ZERO, ZERO, a),
        (1.0, a * 0.5, a, -a),
        (3.0, a * 0.5, -a, a),
    ]
}

#[test]
fn who_hangs_from_a_ledge_that_moves_keeps_no_distance() {
    // A ledge that is still for a second, in which it is taken hold of, and then sways.
    let pieces = sway().map(|(t, p, u, a)| (t + 1.0, p, u, a));
    let still = [(0.0, ZERO, ZERO, ZERO)];
    let scene = hanging(cliff(&[&still[..], &pieces].concat()));
    at_every_rate(&scene, |run, rate| {
        run.spawn(-HALF, -0.5).hold(1.0).play(1.0, rate);
        let grabs = f64::sqrt(0.75 / 15.0);
        close(run.when(|k| k == EventKind::Grabbed), grabs, 1e-12);
        for tenth in 11..=50 {
            let t = f64::from(tenth) / 10.0;
            run.play(t, rate);
            let &(t0, p, u, a) = pieces.iter().rfind(|p| p.0 <= t).unwrap();
            let offset = p + u * (t - t0) + a * (0.5 * (t - t0) * (t - t0));
            run.near(offset.x - HALF, offset.y - 1.25, 1e-14);
            assert_eq!(run.body().grip(), Grip::Ledge);
        }
    });
}

#[test]
fn a_ledge_that_goes_up_is_slid_down_to_taken_hold_of_and_climbed() {
    // The ledge rises at 1 m/s from rest beside it: relative to it the slide begins at 1 m/s, 0.75 m above the hands' height.
    let scene = hanging(steady(v(-0.5, 1.0)));
    let grabs = (-1.0 + f64::sqrt(1.0 + 60.0 * 0.75)) / 30.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(-HALF, -0.5).hold(1.0).play(1.0, rate);
        close(run.when(|k| k == EventKind::Grabbed), grabs, 1e-12);
        run.near(-HALF - 0.5, -0.25, 1e-14);
        run.control(Control {
            up: true,
            ..Control::default()
        });
        run.play(2.0, rate);
        close(
            run.when(|k| k == EventKind::Landed(0.0)),
            1.0 + 7.0 / 24.0,
            1e-12,
        );
        run.near(-HALF - 1.0, 2.0, 1e-14);
        assert!(run.supported() && run.body().carrier() == Some(0));
    });
}

#[test]
fn a_jump_away_from_a_ledge_that_moves_has_its_velocity() {
    let scene =
        hanging(steady(v(-0.5, 1.0))).tune(|t| (t.wall_jump_out, t.wall_jump_up) = (6.0, 10.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(-HALF, -0.5).hold(1.0).play(1.0, rate);
        run.control(Control {
            run: -1.0,
            jump: true,
            ..Control::default()
        });
        assert!(has(run, EventKind::WallJumped));
        assert_eq!(run.speed(), v(-6.5, 11.0));
    });
}

#[test]
fn a_ledge_that_comes_by_is_caught_in_flight() {
    // A body at the apex of its flight, and a wall that comes at 4 m/s from 1 m away and falls at 3: in 0.25 s the feet have
    // fallen 15/16 m and the ledge 3/4.
    for (low, caught) in [(0.0, true), (0.1999, true), (0.2001, false)] {
        let scene = hanging(steady(v(-4.0, -3.0)));
        at_every_rate(&scene, |run, rate| {
            run.spawn(-HALF - 1.0, -1.25 - low + 0.9375 - 0.75);
            run.play(0.5, rate);
            assert_eq!(has(run, EventKind::Grabbed), caught, "{low}");
            if caught {
                close(run.when(|k| k == EventKind::Grabbed), 0.25, 1e-12);
                run.near(-HALF - 2.0, -1.25 - 1.5, 1e-14);
                assert_eq!(run.speed(), v(-4.0, -3.0));
            }
        });
    }
}

#[test]
fn a_moving_wall_is_climbed_relative_to_it() {
    let mut scene = hanging(steady(v(-0.5, 1.0)));
    scene.movers[0].0 = scene.movers[0].0.clone().traits(|t| t.climbable = true);
    scene = scene.tune(|t| t.ledge_hang = 0.0);
    // 4 m/s at 60 m/s^2, from the 1 m/s by which the wall rises past who is at rest.
    let starts = 5.0 / 60.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(-HALF, -10.0).up(true).play(1.0, rate);
        let up = 1.0 * (1.0 / 60.0) / 2.0;
        let climbed = 16.0 / 120.0 + 4.0 * (1.0 - starts) - up;
        run.near(-HALF - 0.5, -10.0 + 1.0 + climbed, 1e-12);
        assert_eq!(run.speed(), v(-0.5, 5.0));
        // Held without a wish, it is at rest on the wall; down leads down; away lets go with the wall's velocity.
        run.up(false).play(2.0, rate);
        assert_eq!(run.speed(), v(-0.5, 1.0));
        assert_eq!(run.body().grip(), Grip::Wall);
        run.down(true).play(3.0, rate);
        assert_eq!(run.speed(), v(-0.5, -3.0));
        run.down(false).play(4.0, rate).hold(-1.0);
        assert_eq!(run.speed(), v(-0.5, 1.0));
        assert!(run.airborne() && has(run, EventKind::LetGo));
    });
}

#[test]
fn a_wall_that_stops_dead_leaves_who_slides_his_speed_and_takes_along_who_holds_on() {
    let stops = [
        (0.0, ZERO, v(0.0, 4.0), ZERO),
        (1.0, v(0.0, 4.0), ZERO, ZERO),
    ];
    let slide = steering(cliff(&stops));
    at_every_rate(&slide, |run, rate| {
        run.spawn(-HALF, -8.0).velocity(0.0, 12.0).hold(1.0);
        run.play(2.0, rate);
        run.near(-HALF, -8.0 + 24.0 - 60.0, 1e-12);
        close(run.speed().y, 12.0 - 60.0, 1e-12);
    });
    let hang = hanging(cliff(&stops));
    at_every_rate(&hang, |run, rate| {
        run.spawn(-HALF, -0.5).hold(1.0).play(2.0, rate);
        run.near(-HALF, 4.0 - 1.25, 1e-14);
        assert_eq!((run.speed(), run.body().grip()), (ZERO, Grip::Ledge));
    });
}
