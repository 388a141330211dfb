//! D. Moving solids. Scene 55 (a platform that turns) is left out on purpose: rotation would make relative motion other than
//! quadratic, and every time of impact a search instead of a closed form.

use super::rig::*;
use edgewalker::motion::{EventKind, Mode};
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// A lift 4 m wide whose top starts at height 0.
fn lift(pieces: &[(f64, DVec2, DVec2, DVec2)]) -> Scene {
    Scene::boxed().moving((-2.0, 2.0), (-1.0, 0.0), pieces)
}

fn left(kind: EventKind) -> bool {
    kind == EventKind::Left
}

fn landed(kind: EventKind) -> bool {
    matches!(kind, EventKind::Landed(_))
}

#[test]
fn scene_52_a_lift_on_parabolas_keeps_its_rider_up_to_gravity() {
    for a in [5.0, 29.0, 30.0] {
        // Up from rest, over the top and down to rest: accelerations a, -a, a.
        let (v1, y1) = (a * 0.5, a * 0.125);
        let pieces = [
            (0.0, ZERO, ZERO, v(0.0, a)),
            (0.5, v(0.0, y1), v(0.0, v1), v(0.0, -a)),
            (1.5, v(0.0, y1), v(0.0, -v1), v(0.0, a)),
            (2.0, ZERO, ZERO, ZERO),
        ];
        lift(&pieces).each(|run| {
            run.spawn(0.5, 0.0);
            for tick in 1..=150 {
                let t = f64::from(tick) / 60.0;
                run.advance(t);
                let piece = pieces.iter().rfind(|p| p.0 <= t).unwrap();
                let dt = t - piece.0;
                let y = piece.1.y + piece.2.y * dt + piece.3.y * (0.5 * dt * dt);
                assert!(run.supported(), "a = {a}, t = {t}: {:?}", run.kinds());
                run.near(0.5, y, 1e-14);
            }
        });
    }
}

#[test]
fn scene_52_a_lift_that_falls_faster_than_its_rider_is_left_at_the_switch() {
    // Rises at 13 m/s^2 for half a second, then a = -52: leaves at 0.5 s with 6.5 m/s at 1.625 m.
    let pieces = [
        (0.0, ZERO, ZERO, v(0.0, 13.0)),
        (0.5, v(0.0, 1.625), v(0.0, 6.5), v(0.0, -52.0)),
        (0.75, v(0.0, 1.625), v(0.0, -6.5), ZERO),
    ];
    lift(&pieces).each(|run| {
        run.spawn(0.0, 0.0)
            .advance(0.625)
            .near(0.0, 1.625 + 6.5 * 0.125 - 15.0 / 64.0, 1e-14);
        assert!(run.airborne());
        run.advance(2.0);
        assert_eq!(run.when(left), 0.5);
        // At 0.75 s the rider is 0.6875 above the lift at -1 m/s, which goes on at -6.5: 0.6875 + 5.5 t = 15 t^2.
        let flight = (5.5 + (5.5f64 * 5.5 + 60.0 * 0.6875).sqrt()) / 30.0;
        close(run.last(landed), 0.75 + flight, 1e-14);
        assert!(run.supported());
    });
}

#[test]
fn scene_53_a_lift_that_stops_dead_tosses_its_rider() {
    let pieces = [
        (0.0, ZERO, v(0.0, 10.0), ZERO),
        (1.0, v(0.0, 10.0), ZERO, ZERO),
    ];
    lift(&pieces).each(|run| {
        run.spawn(0.0, 0.0).advance(1.0 + 1.0 / 3.0);
        run.near(0.0, 10.0 + 5.0 / 3.0, 1e-13);
        run.advance(3.0).near(0.0, 10.0, 1e-13);
        assert_eq!(run.when(left), 1.0);
        close(run.last(landed), 1.0 + 2.0 / 3.0, 1e-13);
    });
}

#[test]
fn scene_54_a_jump_inherits_the_velocity_of_the_platform() {
    let platform = Scene::boxed().rect((-20.0, 40.0), (-2.0, -1.0)).moving(
        (-6.0, 6.0),
        (-1.0, 0.0),
        &[(0.0, ZERO, v(8.0, 0.0), ZERO)],
    );
    platform.each(|run| {
        run.spawn(0.0, 0.0).velocity(8.0, 0.0);
        run.advance(0.25).near(2.0, 0.0, 1e-15);
        run.jump(true).advance(1.5);
        close(run.last(landed), 1.05, 1e-14);
        // Lands 6.4 further, on the platform, which has kept up; and goes on with it.
        run.near(12.0, 0.0, 1e-13);
        assert_eq!(run.speed(), v(8.0, 0.0));
    });
}

#[test]
fn scene_54_the_speed_of_a_platform_is_remembered_to_the_limit() {
    let stops = [
        (0.0, ZERO, v(8.0, 0.0), ZERO),
        (1.0, v(8.0, 0.0), ZERO, ZERO),
    ];
    let scene = lift(&stops).tune(|t| t.lift_memory = 0.125);
    for (at, vx) in [(1.0, 8.0), (1.125, 8.0), (1.1250000000000002, 0.0)] {
        scene.each(|run| {
            run.spawn(0.0, 0.0).velocity(8.0, 0.0).advance(at);
            run.jump(true).advance(at + 0.25);
            assert_eq!(run.speed().x, vx, "jump at {at}");
            assert_eq!(run.at().x, 8.0 + 0.25 * vx);
        });
    }
}

#[test]
fn scene_56_a_pusher_crushes_against_a_wall() {
    let scene = Scene::boxed()
        .rect((-20.0, 20.0), (-1.0, 0.0))
        .rect((0.0, 1.0), (0.0, 5.0))
        .moving(
            (-8.0, -5.0),
            (0.25, 3.0),
            &[(0.0, ZERO, v(10.0, 0.0), ZERO)],
        );
    scene.each(|run| {
        run.spawn(-1.0, 0.0).advance(1.0);
        close(run.when(|k| k == EventKind::Crushed), 0.41875, 1e-15);
        close(
            run.when(|k| k == EventKind::Pushed(0)),
            (4.0 - 2.0 * HALF + HALF) / 10.0,
            1e-15,
        );
        run.near(-HALF, 0.0, 1e-15);
        run.frozen(60);
        assert!(matches!(run.body().mode(), Mode::Crushed(_)));
    });
}

#[test]
fn who_is_crushed_crouched_stays_so() {
    let mut scene = Scene::boxed().rect((-20.0, 20.0), (-1.0, 0.0)).moving(
        (-2.0, 2.0),
        (3.0, 4.0),
        &[(0.0, ZERO, v(0.0, -2.0), ZERO)],
    );
    scene.crouch = box_collider(HALF, TALL / 2.0);
    scene.movers[0].0.crouch = scene.crouch.clone();
    scene.each(|run| {
        run.spawn(0.0, 0.0).down(true).advance(2.0);
        close(
            run.when(|k| k == EventKind::Crushed),
            (3.0 - TALL / 2.0) / 2.0,
            1e-15,
        );
        run.down(false).frozen(60);
        assert!(run.crouched() && matches!(run.body().mode(), Mode::Crushed(_)));
    });
}

#[test]
fn a_pusher_crushes_in_a_valley_that_it_does_not_let_him_out_of() {
    // Slopes of 1:2; the face that comes down on him is flatter, 1:5, and so drives him to the bottom from either side.
    let scene = Scene::point()
        .under(&[(-8.0, 4.0), (0.0, 0.0), (8.0, 4.0)], -2.0)
        .mover(
            Scene::point().solid(&[(-3.0, 4.0), (2.0, 5.0), (-3.0, 5.0)]),
            &[(0.0, ZERO, v(0.0, -2.0), ZERO)],
        );
    scene.each(|run| {
        run.spawn(-1.0, 0.5).advance(0.0).advance(4.0);
        assert!(
            matches!(run.body().mode(), Mode::Crushed(_)),
            "{:?}",
            run.kinds()
        );
    });
}

#[test]
fn scene_56_a_floor_crushes_against_a_ceiling() {
    let scene = lift(&[(0.0, ZERO, v(0.0, 2.0), ZERO)]).rect((-20.0, 20.0), (5.0, 6.0));
    scene.each(|run| {
        run.spawn(0.0, 0.0).advance(2.0);
        close(run.when(|k| k == EventKind::Crushed), 1.59375, 1e-15);
        run.near(0.0, 5.0 - TALL, 1e-15);
    });
}

#[test]
fn scene_57_a_pusher_moves_a_body_over_seams_and_up_a_slope() {
    let mut scene = Scene::boxed();
    for i in 0..10 {
        scene = scene.rect((f64::from(i), f64::from(i) + 1.0), (-1.0, 0.0));
    }
    let scene = scene
        .solid(&[(10.0, -1.0), (25.0, -1.0), (25.0, 8.0), (10.0, 0.0)])
        .moving((-4.0, 0.0), (-1.0, 12.0), &[(0.0, ZERO, v(2.0, 0.0), ZERO)]);
    scene.each(|run| {
        run.spawn(1.0, 0.0);
        for tick in 1..=600 {
            let t = f64::from(tick) / 60.0;
            let x = (2.0 * t + HALF).max(1.0);
            // The foot's leading corner is what meets the slope.
            let y = ((x + HALF - 10.0) * 8.0 / 15.0).max(0.0);
            run.advance(t).near(x, y, 1e-12);
            assert!(run.supported(), "{t}: {:?}", run.kinds());
        }
    });
}

#[test]
fn scene_58_a_platform_that_slides_past_changes_nothing() {
    // Its side passes the body's at no distance, and its underside over the head.
    let still = Scene::boxed().rect((-20.0, 20.0), (-1.0, 0.0));
    let up = [(0.0, v(0.0, -8.0), v(0.0, 5.0), ZERO)];
    let along = [(0.0, v(-15.0, 0.0), v(9.0, 0.0), ZERO)];
    let busy = still
        .clone()
        .moving((HALF, HALF + 1.0), (0.0, 4.0), &up)
        .moving((-3.0, 3.0), (TALL, TALL + 1.0), &along);
    busy.each(|run| {
        run.spawn(0.0, 0.0);
        run.trace.clear();
        run.frozen(240);
        assert_eq!(run.kinds(), []);
    });
}

/// No event but these, and never in the air.
fn kept_to(run: &Run, kinds: &[EventKind]) {
    let other = |k: &EventKind| !kinds.contains(k) && *k != EventKind::Limit;
    let found: Vec<_> = run.kinds().into_iter().filter(other).collect();
    assert_eq!(found, [], "{:?}", run.variant);
}

#[test]
fn scene_60_a_lift_that_rises_at_ten_keeps_no_distance() {
    for rate in [30.0, 60.0, 1000.0] {
        lift(&[(0.0, ZERO, v(0.0, 10.0), ZERO)]).each(|run| {
            run.spawn(0.5, 0.0);
            run.trace.clear();
            for tick in 1..=(5.0 * rate) as u32 {
                let t = f64::from(tick) / rate;
                run.advance(t).near(0.5, 10.0 * t, 1e-13);
            }
            assert_eq!(run.kinds(), []);
        });
    }
}

#[test]
fn a_lift_takes_over_who_stands_on_the_floor_it_rises_from() {
    // Flush with the floor until 1 s, then up at 2 m/s, and down again at 3 s: left standing on the floor at 5 s.
    let up = [
        (0.0, ZERO, ZERO, ZERO),
        (1.0, ZERO, v(0.0, 2.0), ZERO),
        (3.0, v(0.0, 4.0), v(0.0, -2.0), ZERO),
    ];
    let scene = lift(&up).rect((-20.0, 20.0), (-2.0, 0.0));
    scene.each(|run| {
        run.spawn(0.0, 0.0);
        run.trace.clear();
        run.advance(1.0).advance(2.0).near(0.0, 2.0, 1e-14);
        assert_eq!(run.body().carrier(), Some(0));
        kept_to(run, &[EventKind::Boarded(Some(0))]);
        // Down at 2 m/s at once: tossed at 2 m/s, and back on it after (2 + 2) / 15 s.
        run.advance(4.0).near(0.0, 2.0, 1e-13);
        close(run.last(landed), 3.0 + 4.0 / 15.0, 1e-14);
        run.advance(6.0).near(0.0, 0.0, 1e-14);
        assert_eq!(run.body().carrier(), None);
        close(run.when(|k| k == EventKind::Boarded(None)), 5.0, 1e-13);
    });
}

#[test]
fn a_walker_goes_over_flush_seams_of_ground_and_platforms_without_a_stumble() {
    let step = 1.0 / 65536.0;
    for (gap, low) in [
        (0.0, 0.0),
        (0.0, 2.0 * step),
        (0.0, -2.0 * step),
        (step, step),
        (2.0 * step, -step),
    ] {
        // Floor, two platforms at rest, floor.
        let scene = Scene::boxed()
            .rect((-10.0, 0.0), (-1.0, 0.0))
            .moving((gap, 4.0), (-1.0, low), &[(0.0, ZERO, ZERO, ZERO)])
            .moving((4.0, 8.0), (-1.0, 0.0), &[(0.0, ZERO, ZERO, ZERO)])
            .rect((8.0, 20.0), (-1.0, 0.0));
        for (from, speed) in [(-5.0, 5.0), (13.0, -5.0)] {
            scene.each(|run| {
                run.spawn(from, 0.0).walk(speed);
                run.trace.clear();
                for tick in 1..=216 {
                    let t = f64::from(tick) / 60.0;
                    run.advance(t).near(from + speed * t, 0.0, 2.5 * step);
                    assert!(run.supported(), "{:?}", run.kinds());
                }
                kept_to(run, &[Some(0), Some(1), None].map(EventKind::Boarded));
                assert_eq!(run.body().carrier(), None);
                assert_eq!(run.speed(), v(speed, 0.0));
            });
        }
    }
}

#[test]
fn a_walker_is_handed_from_platform_to_platform_and_to_the_ground() {
    // Both go right at 1 m/s and stop flush with the ground after 2 s; he walks at 5 m/s relative to what carries him.
    let ride = [
        (0.0, v(-2.0, 0.0), v(1.0, 0.0), ZERO),
        (2.0, ZERO, ZERO, ZERO),
    ];
    let scene = Scene::boxed()
        .moving((-12.0, -6.0), (-1.0, 0.0), &ride)
        .moving((-6.0, 0.0), (-1.0, 0.0), &ride)
        .rect((0.0, 20.0), (-1.0, 0.0));
    scene.each(|run| {
        run.spawn(-13.0, 0.0).velocity(6.0, 0.0).hold(1.0);
        run.trace.clear();
        // At 6 m/s in the world for 2 s, then at 5.
        run.advance(2.0)
            .near(-1.0, 0.0, 1e-13)
            .advance(3.0)
            .near(4.0, 0.0, 1e-13);
        let boarded = [Some(1), None].map(EventKind::Boarded);
        kept_to(
            run,
            &[
                boarded[0],
                boarded[1],
                EventKind::Node(0),
                EventKind::Node(1),
            ],
        );
        assert_eq!(run.body().carrier(), None);
        // The collider's foot reaches half a body over the end of what carries it: x = -6 - 2 + t + 13/32.
        close(
            run.when(|k| k == boarded[0]),
            (13.0 - 8.0 + HALF) / 5.0,
            1e-13,
        );
    });
}

#[test]
fn a_steep_wall_squeezes_a_body_upwards_between_it_and_a_pusher() {
    // A wall of 12:5, too steep to walk on, and a pusher at 2.5 m/s: along the wall at 2.5 * 13/5.
    let scene = Scene::boxed()
        .rect((-20.0, 20.0), (-1.0, 0.0))
        .solid(&[(2.0, 0.0), (12.0, 0.0), (12.0, 24.0)])
        .moving(
            (-8.0, -4.0),
            (-1.0, 30.0),
            &[(0.0, ZERO, v(2.5, 0.0), ZERO)],
        );
    scene.each(|run| {
        run.spawn(0.0, 0.0).advance(2.0 - 2.0 * HALF / 2.5 + 0.8);
        // It touches both at (6 - 2 HALF) / 2.5 s; then rises 12/5 of what the pusher advances.
        let (meets, t) = ((6.0 - 2.0 * HALF) / 2.5, run.time());
        assert!(t > meets);
        let by = 2.5 * (t - meets);
        run.near(2.0 - HALF + by, by * 12.0 / 5.0, 1e-12);
        assert_eq!(run.body().pushed_by(), Some(0));
    });
}

#[test]
fn a_body_at_a_door_goes_on_as_soon_as_it_has_risen() {
    // 2 m high, opens upwards at 1 m/s from 1 s on; the body is 29/16 m tall.
    let scene = Scene::boxed()
        .rect((-20.0, 20.0), (-1.0, 0.0))
        .moving(
            (2.0, 3.0),
            (0.0, 3.0),
            &[(0.0, ZERO, ZERO, ZERO), (1.0, ZERO, v(0.0, 1.0), ZERO)],
        )
        .tune(|t| t.run_accel = 10.0);
    scene.each(|run| {
        run.spawn(0.0, 0.0).walk(5.0);
        run.advance(0.5)
            .near(2.0 - HALF, 0.0, 0.0)
            .advance(2.5)
            .near(2.0 - HALF, 0.0, 0.0);
        close(
            run.when(|k| matches!(k, EventKind::Stopped(_))),
            (2.0 - HALF) / 5.0,
            1e-15,
        );
        // Clear at 1 + 29/16 s; then 10 m/s^2 up to 5 m/s.
        let clear = 1.0 + TALL;
        run.advance(clear + 0.25)
            .near(2.0 - HALF + 5.0 * 0.0625, 0.0, 1e-13);
        run.advance(clear + 1.0)
            .near(2.0 - HALF + 1.25 + 2.5, 0.0, 1e-13);
    });
}

#[test]
fn rides_pushes_and_jumps_have_the_same_bits_at_every_rate() {
    let sway = [
        (0.0, ZERO, ZERO, v(3.0, 1.0)),
        (1.0, v(1.5, 0.5), v(3.0, 1.0), v(-3.0, -1.0)),
        (3.0, v(1.5, 0.5), v(-3.0, -1.0), v(3.0, 1.0)),
    ];
    let mut scene = Scene::boxed()
        .rect((-20.0, 20.0), (-1.0, 0.0))
        .solid(&[(4.0, 0.0), (12.0, 0.0), (12.0, 4.0)])
        .moving((-4.0, -1.0), (0.5, 1.0), &sway)
        .moving(
            (-12.0, -8.0),
            (0.25, 3.0),
            &[(0.0, ZERO, v(1.5, 0.0), v(0.25, 0.0))],
        )
        .tune(|t| (t.run_accel, t.run_brake, t.air_accel) = (40.0, 30.0, 20.0));
    for (_, path) in &mut scene.movers[..1] {
        path.period = Some(4.0);
    }
    let hashes = std::cell::RefCell::new(Vec::<Vec<u64>>::new());
    for rate in [30.0, 60.0, 120.0, 240.0, 1000.0] {
        scene.with(Variant::Plain, &|run: &mut Run| {
            run.spawn(-2.5, 1.0);
            let mut seen = Vec::new();
            for tenth in 0..80u32 {
                // Rides, runs off to the right, hops, waits for the pusher and is pushed up the slope.
                run.hold(if (25..33).contains(&tenth) { 1.0 } else { 0.0 });
                run.jump(tenth == 35 || tenth == 61);
                let from = f64::from(tenth) * rate / 10.0;
                for tick in 1..=(rate / 10.0) as u32 {
                    run.advance((from + f64::from(tick)) / rate);
                }
                seen.push(run.body().hash());
            }
            let has = |f: fn(&EventKind) -> bool| run.kinds().iter().any(f);
            assert!(
                has(|k| matches!(k, EventKind::Pushed(_))) && has(|k| *k == EventKind::Node(0))
            );
            hashes.borrow_mut().push(seen);
        });
    }
    for other in &hashes.borrow()[1..] {
        assert_eq!(*other, hashes.borrow()[0]);
    }
}
