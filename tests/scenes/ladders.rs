//! Ladders: climbing under a constant acceleration to a constant speed, exact ends, and the ways on and off. The tunables:
//! 4 m/s, 60 m/s^2, so that full speed is reached after 1/15 s and 2/15 m.

use super::rig::*;
use edgewalker::motion::{Control, EventKind, Region};
use glam::DVec2;

/// How long it takes to climb so far from rest.
fn time_for(distance: f64) -> f64 {
    (distance + 2.0 / 15.0) / 4.0
}

/// A floor, and a ladder over it from its level to a height.
fn ladder(top: f64) -> Scene {
    Scene::boxed()
        .rect((-50.0, 50.0), (-1.0, 0.0))
        .region(Region::Ladder, (-1.0, 1.0), (0.0, top))
}

fn climbed(kind: EventKind) -> bool {
    kind == EventKind::Climbed
}

fn hit(kind: EventKind) -> bool {
    matches!(kind, EventKind::Hit(_))
}

#[test]
fn up_a_ladder_and_rest_at_its_top() {
    ladder(6.0).each(|run| {
        run.spawn(0.0, 0.0).up(true);
        assert!(run.body().climbing());
        for rate in [30.0, 60.0] {
            run.spawn(0.0, 0.0).up(true);
            run.ticks((rate / 30.0) as u32, rate);
            run.near(0.0, 30.0 / 900.0, 1e-15);
            run.ticks(rate as u32, rate);
            let t = run.time();
            run.near(0.0, 4.0 * t - 2.0 / 15.0, 1e-12);
        }
        run.advance(3.0).near(0.0, 6.0, 0.0);
        close(run.last(hit), time_for(6.0), 1e-12);
        assert!(run.body().climbing() && run.speed() == DVec2::ZERO);
        run.frozen(600).up(false).frozen(600).up(true).frozen(600);
        // Down again, onto the floor.
        run.up(false)
            .down(true)
            .advance(40.0 + time_for(6.0) + 1e-9);
        run.near(0.0, 0.0, 0.0);
        assert!(run.supported() && !run.body().climbing());
        assert!(run.kinds().contains(&EventKind::Landed(4.0)));
    });
}

#[test]
fn at_its_foot_in_the_air_too() {
    let hanging = Scene::boxed().region(Region::Ladder, (-1.0, 1.0), (2.0, 6.0));
    hanging.each(|run| {
        run.spawn(0.0, 5.0)
            .down(true)
            .advance(2.0)
            .near(0.0, 2.0, 0.0);
        run.frozen(600).down(false).frozen(60);
        // Along it, and off over the side.
        let t = run.time();
        run.hold(1.0).advance(t + 10.0);
        assert!(run.airborne() && run.at().y < -50.0 && !run.body().climbing());
    });
}

#[test]
fn a_hold_in_mid_fall_begins_at_its_own_time() {
    for rate in [15.0, 60.0, 240.0, 1000.0] {
        ladder(6.0).each(|run| {
            run.spawn(0.5, 10.0)
                .up(true)
                .ticks(rate as u32 / 5 * 4, rate);
            let t = (8.0f64 / 30.0).sqrt();
            close(run.when(climbed), t, 1e-15);
            // From 15.5 m/s down, braked by 60 m/s^2.
            let dt = 0.8 - t;
            run.near(0.5, 6.0 - 30.0 * t * dt + 30.0 * dt * dt, 1e-12);
        });
    }
}

#[test]
fn a_jump_leaves_it_and_what_is_held_takes_hold_at_the_apex() {
    ladder(20.0).each(|run| {
        run.spawn(0.0, 0.0).up(true).advance(1.0);
        let y = run.at().y;
        // With the speed of the climb: 16 m/s, apex after 8/15 s.
        run.jump(true);
        assert_eq!(run.speed(), v(0.0, 16.0));
        run.advance(2.0);
        close(run.last(climbed), 1.0 + 8.0 / 15.0, 1e-15);
        let dt = 1.0 - 8.0 / 15.0;
        run.near(0.0, y + 64.0 / 15.0 + 4.0 * dt - 2.0 / 15.0, 1e-12);
        // Pressed anew while it rises: at once.
        run.jump(false).jump(true).advance(2.125);
        run.up(false).up(true);
        assert_eq!(run.last(climbed), 2.125);
        // Not held: it jumps, and falls.
        run.up(false).jump(false).jump(true).advance(2.75);
        assert!(run.airborne() && !run.body().climbing());
    });
}

#[test]
fn over_the_side_it_falls() {
    ladder(20.0).each(|run| {
        run.spawn(0.0, 0.0).up(true).advance(1.0).hold(1.0);
        let (y, side) = (4.0 - 2.0 / 15.0, time_for(1.0));
        run.advance(2.0);
        let gone = |k| k == EventKind::LetGo;
        close(run.when(gone), 1.0 + side, 1e-14);
        let dt = 1.0 - side;
        run.near(
            1.0 + 4.0 * dt,
            y + 4.0 * side + 4.0 * dt - 15.0 * dt * dt,
            1e-12,
        );
        assert!(!run.body().climbing() && run.body().regions().is_empty());
    });
}

#[test]
fn who_lets_go_falls_and_holds_again_only_when_asked_anew() {
    ladder(20.0).each(|run| {
        run.spawn(0.0, 0.0)
            .up(true)
            .advance(3.0)
            .up(false)
            .advance(4.0);
        let y = run.at().y;
        run.frozen(60).down(true).jump(true).advance(5.5);
        run.near(0.0, y - 15.0 * 0.25, 1e-12);
        assert_eq!(*run.kinds().last().unwrap(), EventKind::LetGo);
        run.down(false).down(true);
        assert!(run.body().climbing());
    });
}

#[test]
fn up_through_a_platform_and_onto_one_at_the_top() {
    let scene = ladder(6.0)
        .one_way(&[(-3.0, 3.0), (3.0, 3.0)])
        .one_way(&[(-3.0, 6.0), (3.0, 6.0)]);
    scene.each(|run| {
        run.spawn(0.0, 0.0).up(true).advance(1.0);
        run.near(0.0, 4.0 - 2.0 / 15.0, 1e-12);
        run.advance(3.0).near(0.0, 6.0, 0.0);
        let landed = |k| k == EventKind::Landed(0.0);
        close(run.last(landed), time_for(6.0), 1e-12);
        assert!(run.supported() && !run.body().climbing());
        run.frozen(600).up(false).frozen(60);
        // Down takes hold of what goes on below, and passes the other one.
        let t = run.time();
        run.down(true).advance(t + 1.0);
        run.near(0.0, 6.0 - 4.0 + 2.0 / 15.0, 1e-12);
        assert!(run.body().climbing() && !run.crouched());
    });
}

#[test]
fn from_the_top_onto_a_ledge_of_that_height() {
    let scene = ladder(6.0).rect((0.75, 9.0), (0.0, 6.0));
    scene.tune(|t| t.run_accel = 50.0).each(|run| {
        // Up stops where he is let go of it, and the stick leads on.
        run.spawn(0.0, 0.0).up(true).advance(1.5);
        run.up(false).hold(1.0).up(true).advance(2.5);
        assert!(run.supported() && run.at().x > 1.0, "{}", run.at());
        close(run.at().y, 6.0, 0.0);
        // With up alone it is the same ledge.
        run.spawn(0.0, 0.0).up(true).advance(3.0);
        assert!(run.supported(), "{}", run.at());
        close(run.at().y, 6.0, 0.0);
    });
}

#[test]
fn solids_stop_who_climbs_and_he_goes_along_them() {
    let scene = ladder(9.0)
        .rect((0.75, 9.0), (1.0, 3.0))
        .rect((-9.0, 9.0), (5.0 + TALL, 8.0));
    scene.each(|run| {
        // Against a wall, still up along it, past its end, to the ceiling.
        run.spawn(0.75 - HALF, 1.5).control(Control {
            run: 1.0,
            up: true,
            ..Control::default()
        });
        run.advance(0.25);
        close(run.at().x, 0.75 - HALF, 0.0);
        close(run.at().y, 1.5 + 1.0 - 2.0 / 15.0, 1e-12);
        run.hold(0.0).advance(2.0);
        run.near(0.75 - HALF, 5.0, 0.0).frozen(600);
        // Along the ceiling to the other side, and down.
        let t = run.time();
        run.hold(-1.0).advance(t + 0.25);
        run.near(0.75 - HALF - 1.0 + 2.0 / 15.0, 5.0, 1e-12);
        run.up(false).down(true).hold(0.0).advance(t + 3.0);
        assert!(run.supported());
    });
}

#[test]
fn a_corner_at_the_top_holds_him_and_lets_him_go() {
    let scene = ladder(6.0).rect((0.75, 9.0), (0.0, 9.0));
    scene.each(|run| {
        run.spawn(0.0, 0.0).up(true).hold(1.0).advance(3.0);
        run.near(0.75 - HALF, 6.0, 0.0).frozen(600);
        run.up(false).frozen(60);
        let t = run.time();
        run.down(true).advance(t + 1.0);
        run.near(0.75 - HALF, 6.0 - 4.0 + 2.0 / 15.0, 1e-11);
    });
}

#[test]
fn one_above_the_other_is_one_ladder() {
    let two = ladder(3.0).region(Region::Ladder, (-1.0, 1.0), (3.0, 9.0));
    two.each(|run| {
        run.spawn(0.0, 0.0).up(true).advance(2.0);
        run.near(0.0, 8.0 - 2.0 / 15.0, 1e-12);
        assert_eq!(run.body().regions(), [2]);
    });
}

#[test]
fn the_same_bits_at_every_rate() {
    let scene = ladder(6.0)
        .one_way(&[(-3.0, 4.0), (3.0, 4.0)])
        .tune(|t| (t.run_accel, t.air_accel) = (50.0, 30.0));
    let run_at = |rate: f64, variant: Variant| {
        let out = std::cell::RefCell::new(Vec::new());
        scene.with(variant, &|run: &mut Run| {
            run.spawn(-3.0, 0.0);
            for n in 0..200u32 {
                let pick = |k: u32| (n * 7919 + k * 104_729) % 13;
                run.hold([1.0, -1.0, 0.0, 1.0, -1.0][pick(1) as usize % 5]);
                run.up(pick(2) < 7).down(pick(3) < 3).jump(pick(4) < 3);
                run.ticks((rate / 5.0) as u32, rate);
                let (p, w) = (run.at(), run.speed());
                out.borrow_mut()
                    .push([p.x, p.y, w.x, w.y].map(|c| (c + 0.0).to_bits()));
                if p.x.abs() > 8.0 {
                    let x = if n % 2 == 0 { 0.5 } else { -0.25 };
                    let t = run.time();
                    run.spawn(x, 0.0).advance(t);
                }
            }
        });
        out.into_inner()
    };
    let once = run_at(5.0, Variant::Plain);
    for rate in [15.0, 30.0, 60.0, 240.0, 1000.0] {
        assert_eq!(once, run_at(rate, Variant::Plain), "{rate}");
    }
    assert_eq!(once, run_at(60.0, Variant::Mirrored));
}

#[test]
fn a_climb_that_leads_back_into_a_corner_rests_there() {
    // Up and to the right, under a wall that leans over him.
    let scene = ladder(6.0).solid(&[(0.75, 0.0), (2.0, 0.0), (2.0, 4.0), (-0.75, 1.0)]);
    let scene = Scene {
        stand: edgewalker::geom::Collider::point(),
        crouch: edgewalker::geom::Collider::point(),
        ..scene
    };
    scene.tune(|t| t.run_accel = 50.0).each(|run| {
        run.spawn(-0.5, 0.0)
            .hold(1.0)
            .advance(1.0)
            .near(0.75, 0.0, 0.0);
        run.up(true).advance(2.0).near(0.75, 0.0, 0.0);
        run.frozen(60);
        // Another wish gets him out.
        let t = run.time();
        run.hold(-1.0).advance(t + 0.2);
        assert!(run.body().climbing() && run.at().x < 0.5);
    });
}
