//! Ledges with room for one who crouches and no more: held, climbed onto crouching, and stood up on where there is room. The
//! hero, whose hands reach 1.25 m up; he is 109/64 m tall, crouched 61/64 m.

use super::ledges::hanging;
use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::geom::Collider;
use edgewalker::motion::grip::Grip;
use edgewalker::motion::{Control, EventKind, Size};
use glam::DVec2;

/// A ledge at y = 0, and over it from x = `from` to 2 a roof so high.
fn ledge(room: f64, from: f64) -> Scene {
    let hero = Scene {
        stand: Collider::hero(),
        crouch: Collider::hero_crouched(),
        ..Scene::boxed()
    };
    hanging(hero)
        .rect((0.0, 9.0), (-60.0, 0.0))
        .rect((from, 2.0), (room, room + 6.0))
        .tune(|t| (t.run_speed, t.run_accel, t.run_brake, t.crouch_speed) = (5.0, 50.0, 50.0, 3.0))
}

fn grabbed(kind: EventKind) -> bool {
    kind == EventKind::Grabbed
}

fn up(run: &mut Run, up: bool) {
    run.control(Control {
        up,
        ..Control::default()
    });
}

/// From the hang at -1.25 over the bevel of his foot: 1/12 s to 5 m/s, then at that speed.
fn climb_time() -> f64 {
    let flank = v(13.0 / 32.0 - 0.25, 11.0 / 32.0).length();
    let way = 1.25 - 11.0 / 32.0 + flank;
    1.0 / 12.0 + (way - 5.0 / 24.0) / 5.0
}

#[test]
fn a_ledge_with_room_to_crouch_is_held_and_climbed_onto_crouching() {
    for room in [0.9535, 0.96, 1.2, 1.5, 1.7] {
        for from in [0.0, -0.1] {
            at_every_rate(&ledge(room, from), |run, rate| {
                let start = (room - 109.0 / 64.0 - 0.1).min(-0.75);
                run.spawn(-HALF, start).hold(1.0).play(1.0, rate);
                let falls = f64::sqrt((start + 1.25) / 15.0);
                close(run.when(grabbed), falls, 1e-12);
                run.near(-HALF, -1.25, 0.0).frozen(60);
                assert_eq!(
                    (run.body().grip(), run.body().size()),
                    (Grip::Ledge, Size::Stand)
                );
                // Up, crouched, at rest on the rim, and there he stays crouched.
                let t = run.time();
                up(run, true);
                assert_eq!(
                    (run.body().grip(), run.body().size()),
                    (Grip::Over, Size::Crouch)
                );
                run.play(t + 1.0, rate).near(-0.25, 0.0, 0.0);
                let lands = run.last(|k| matches!(k, EventKind::Landed(_)));
                close(lands, t + climb_time(), 1e-12);
                assert!(run.supported() && run.crouched() && run.speed() == DVec2::ZERO);
                up(run, false);
                run.frozen(60);
                // In under the roof; beyond it he stands up, as soon as his back is clear.
                let t = run.time();
                run.hold(1.0).play(t + 3.0, rate);
                let way = 2.0 + HALF + 0.25;
                let stands = 3.0 / 50.0 + (way - 0.09) / 3.0;
                let at = run.last(|k| k == EventKind::Resized(Size::Stand));
                close(at, t + stands, 1e-11);
                assert!(!run.crouched());
            });
        }
    }
}

#[test]
fn with_less_room_it_is_no_ledge() {
    for room in [0.95, 0.9, 0.5] {
        at_every_rate(&ledge(room, 0.0), |run, rate| {
            run.spawn(-HALF, -0.85).hold(1.0).play(1.0, rate);
            assert!(!run.kinds().into_iter().any(grabbed));
            run.near(-HALF, -15.85, 1e-12);
        });
    }
}

#[test]
fn a_low_ledge_is_caught_in_flight_too() {
    // At the wall after 0.25 s, having fallen 15/16 m.
    for (low, caught) in [(0.0, true), (0.1875, true), (0.2001, false)] {
        at_every_rate(&ledge(1.2, 0.0), |run, rate| {
            run.spawn(-HALF - 1.0, -1.25 - low + 0.9375)
                .velocity(4.0, 0.0)
                .play(0.5, rate);
            assert_eq!(run.kinds().into_iter().any(grabbed), caught, "{low}");
            if caught {
                close(run.when(grabbed), 0.25, 1e-12);
                run.near(-HALF, -1.25, 0.0);
            }
        });
    }
}

#[test]
fn who_lets_go_on_the_way_up_hangs_no_more_and_stands_again() {
    at_every_rate(&ledge(1.2, 0.0), |run, rate| {
        run.spawn(-HALF, -0.85).hold(1.0).play(1.0, rate);
        up(run, true);
        run.play(1.15, rate);
        assert!(run.crouched() && run.body().grip() == Grip::Over);
        up(run, false);
        // Down keeps who is crouched in the air as he is.
        run.down(true).play(1.5, rate);
        assert!(run.body().grip() == Grip::None && run.crouched());
        run.down(false).play(2.0, rate);
        assert!(!run.crouched());
        // At 5 m/s up the wall when he lets go, and free from there on.
        let high = -1.25 + 5.0 / 24.0 + 5.0 * (0.15 - 1.0 / 12.0);
        run.near(-HALF, high + 5.0 * 0.85 - 15.0 * 0.85 * 0.85, 1e-12);
    });
}

#[test]
fn a_ledge_on_a_moving_solid_too() {
    let hero = Scene {
        stand: Collider::hero(),
        crouch: Collider::hero_crouched(),
        ..Scene::boxed()
    };
    let solids = hero
        .clone()
        .rect((0.0, 9.0), (-60.0, 0.0))
        .rect((0.0, 9.0), (1.2, 8.0));
    let still = (0.0, DVec2::ZERO, v(0.0, 0.0), DVec2::ZERO);
    let scene = hanging(hero).mover(solids, &[still]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(-HALF, -0.85).hold(1.0).play(1.0, rate);
        assert!(run.kinds().into_iter().any(grabbed), "{:?}", run.kinds());
        up(run, true);
        run.play(2.0, rate).near(-0.25, 0.0, 1e-12);
        assert!(run.supported() && run.crouched());
    });
}
