//! F. Timing and stress.

use super::rig::*;
use edgewalker::geom::{Collider, Point};
use edgewalker::motion::{Body, Control, EventKind, SpawnError};

/// Height of a tunnel for a crouched body, on the grid.
const LOW: f64 = 77.0 / 64.0;

fn floor() -> Scene {
    Scene::boxed().rect((-50.0, 50.0), (-1.0, 0.0))
}

fn landing(kind: EventKind) -> bool {
    matches!(kind, EventKind::Landed(_))
}

/// The greatest height and the landing time of a jump at time 0, at a tick rate.
fn jump(scene: &Scene, rate: f64, release: Option<f64>) -> (f64, f64) {
    let out = std::cell::Cell::new((0.0, 0.0));
    scene.with(Variant::Plain, &|run: &mut Run| {
        run.spawn(0.0, 0.0).jump(true);
        run.trace.clear();
        let mut top: f64 = 0.0;
        for tick in 1..=(2.0 * rate) as u32 {
            if release == Some(f64::from(tick - 1) / rate) {
                run.jump(false);
            }
            run.advance(f64::from(tick) / rate);
            top = top.max(run.at().y);
        }
        out.set((top, run.when(landing)));
    });
    out.get()
}

#[test]
fn scene_70_a_jump_has_its_height_and_length_at_every_rate() {
    for rate in [10.0, 30.0, 60.0, 240.0, 1000.0] {
        let (top, flight) = jump(&floor(), rate, None);
        close(flight, 0.8, 1e-15);
        close(top, 2.4, 1e-12);
    }
}

#[test]
fn scene_70_a_jump_let_go_is_cut() {
    let cut = floor().tune(|t| {
        (t.jump_cut_speed, t.jump_cut_brake, t.jump_least) = (4.0, 390.0, 0.0);
    });
    let (top, _) = jump(&cut, 1000.0, Some(0.1));
    // From 9 m/s at 1.05 m: braked to 4 by 390 m/s^2, and on from there by 30. The apex lies between ticks: at most
    // g (dt/2)^2 / 2 above the highest of them.
    let exact = 12.0 * 0.1 - 15.0 * 0.01 + (81.0 - 16.0) / 780.0 + 4.0 * 4.0 / 60.0;
    close(exact, 1.4, 1e-12);
    close(top, exact, 15.0 * 0.0005f64.powi(2) + 1e-12);
}

#[test]
fn scene_70_half_gravity_about_the_apex() {
    let band = floor().tune(|t| (t.apex_speed, t.apex_gravity) = (4.0, 0.5));
    let (top, flight) = jump(&band, 1000.0, None);
    close(top, 2.6666666666666667, 8.0 * 0.0005f64.powi(2) + 1e-12);
    close(flight, 2.0 * ((12.0 - 4.0) / 30.0 + 4.0 / 15.0), 1e-12);
}

#[test]
fn scene_70_terminal_speed_from_100_m() {
    floor()
        .tune(|t| (t.fall_speed, t.over_speed_decay) = (20.0, 50.0))
        .each(|run| {
            run.spawn(0.0, 100.0);
            run.advance(8.0);
            close(run.when(landing), 5.333333333333333, 1e-11);
            assert!(run.kinds().len() <= 5, "{:?}", run.kinds());
        });
}

#[test]
fn a_ten_second_fall_in_one_step_costs_at_most_five_events() {
    let deep = Scene::boxed().rect((-50.0, 50.0), (-3000.0, -2999.0));
    deep.with(Variant::Plain, &|run: &mut Run| {
        run.spawn(0.0, 0.0).advance(10.0).near(0.0, -1500.0, 1e-9);
        assert!(run.kinds().len() <= 5, "{:?}", run.kinds());
    });
}

#[test]
fn a_minute_of_hops_agrees_with_the_closed_form_at_every_rate() {
    // I10: runs at 5 m/s over seams, and hops once a second for 0.8 s.
    let hop = |dt: f64| (12.0 * dt - 15.0 * dt * dt).max(0.0);
    let flat = (0..70).fold(Scene::boxed(), |s, i| {
        s.rect((5.0 * f64::from(i), 5.0 * f64::from(i + 1)), (-1.0, 0.0))
    });
    for rate in [15.0, 30.0, 60.0, 120.0, 240.0, 1000.0] {
        let worst = std::cell::Cell::new(0.0f64);
        flat.with(Variant::Plain, &|run: &mut Run| {
            run.spawn(1.0, 0.0).walk(5.0);
            for second in 0..60u32 {
                run.jump(true).jump(false);
                for tick in 1..=rate as u32 {
                    let t = f64::from(second) + f64::from(tick) / rate;
                    run.advance((f64::from(second) * rate + f64::from(tick)) / rate);
                    let exact = v(1.0 + 5.0 * t, hop(f64::from(tick) / rate));
                    worst.set(worst.get().max((run.at() - exact).length()));
                }
            }
        });
        println!("{rate} Hz: {:e} m", worst.get());
        assert!(worst.get() <= 1e-9, "{rate} Hz: {:e} m", worst.get());
    }
}

#[test]
fn scene_70_coyote_time_counts_from_the_edge() {
    // Leaves at (2 + 13/32) / 5 s, between ticks.
    let scene = Scene::boxed().rect((-20.0, 0.0), (-1.0, 0.0));
    let left = (2.0 + HALF) / 5.0;
    for (late, granted) in [(-1e-9, true), (1e-9, false)] {
        scene.each(|run| {
            run.spawn(-2.0, 0.0)
                .walk(5.0)
                .advance(0.5)
                .advance(left + 0.1 + late)
                .jump(true);
            assert_eq!(run.speed().y > 0.0, granted);
        });
    }
}

#[test]
fn scene_70_the_jump_buffer_counts_to_the_landing() {
    // From 0.2 above the floor: lands at sqrt(0.4 / 30).
    let lands = f64::sqrt(2.0 * 15.0 / 30.0);
    for (early, granted) in [(-1e-9, true), (1e-9, false)] {
        floor().each(|run| {
            run.spawn(0.0, 15.0)
                .advance(lands - 0.1 - early)
                .jump(true)
                .advance(lands + 0.01);
            assert_eq!(run.kinds().contains(&EventKind::Jumped), granted);
            if granted {
                close(run.when(|k| k == EventKind::Jumped), lands, 1e-12);
            }
        });
    }
}

#[test]
fn scene_64_crouched_under_a_low_ceiling() {
    let tall = Scene {
        crouch: box_collider(HALF, 1.0),
        ..Scene::boxed()
    };
    let scene = tall
        .rect((-20.0, 20.0), (-1.0, 0.0))
        .rect((0.0, 5.0), (LOW, 3.0));
    scene.clone().tune(|t| t.crouch_speed = 3.0).each(|run| {
        run.spawn(-2.0, 0.0).walk(3.0).down(true);
        assert!(run.crouched());
        run.ticks(60, 60.0);
        assert!(run.at().x > 0.0);
        run.down(false);
        assert!(run.crouched(), "no room");
        run.advance(6.0);
        assert!(!run.crouched() && run.supported());
        let stood = run.last(|k| matches!(k, EventKind::Resized(_)));
        close(stood, (2.0 + 5.0 + HALF) / 3.0, 1e-12);
    });
    // In the air under a ceiling: stands up as soon as it has fallen clear.
    let drop = Scene {
        crouch: box_collider(HALF, 1.0),
        ..Scene::boxed()
    }
    .rect((-20.0, 0.0), (-1.0, 0.0))
    .rect((0.0, 20.0), (LOW, 3.0));
    drop.tune(|t| t.crouch_speed = 3.0).each(|run| {
        run.spawn(-2.0, 0.0)
            .walk(3.0)
            .down(true)
            .advance(0.9)
            .down(false)
            .advance(2.0);
        assert!(!run.crouched());
        let left = run.when(|k| k == EventKind::Left);
        let stood = run.last(|k| matches!(k, EventKind::Resized(_)));
        close(stood - left, f64::sqrt((TALL - LOW) / 15.0), 1e-11);
    });
}

#[test]
fn scene_68_a_snapshot_goes_on_as_the_original() {
    super::swept::course().with(Variant::Plain, &|run: &mut Run| {
        run.spawn(1.0, 3.0).hold(1.0);
        for step in 0..600 {
            run.jump(step % 50 > 30)
                .hold([1.0, -1.0, 1.0][step / 90 % 3])
                .ticks(1, 60.0);
            let text = ron::to_string(run.body()).unwrap();
            let copy: Body = ron::from_str(&text).unwrap();
            assert_eq!((copy.hash(), &copy), (run.body().hash(), run.body()));
        }
    });
}

#[test]
fn scene_69_bad_numbers_are_errors() {
    floor().with(Variant::Plain, &|run: &mut Run| {
        for (x, y, error) in [
            (f64::NAN, 0.0, SpawnError::Outside),
            (f64::INFINITY, 0.0, SpawnError::Outside),
            (1e300, 0.0, SpawnError::Outside),
            (0.0, -0.5, SpawnError::Solid),
        ] {
            assert_eq!(Body::spawn(v(x, y), 0.0, &run.terrain), Err(error));
        }
        Body::spawn(v(5e-324, 5e-324), 0.0, &run.terrain).unwrap();
        run.spawn(0.0, 0.0)
            .hold(f64::NAN)
            .advance(1.0)
            .near(0.0, 0.0, 0.0);
    });
    assert_eq!(Point::snap(v(f64::NAN, 0.0)), None);
    assert!(Collider::new(vec![Point::new(0, 0), Point::new(1, 0)]).is_err());
}

#[test]
fn who_is_pulled_off_a_slope_in_the_coyote_time_jumps_at_once() {
    // Off the edge at 1.5 s, down on a slope of 2 in 1 at 1.5267 s, where no jump is granted; pushing off it takes the body into
    // the air, where the coyote time still counts, at the moment of the press and not at some later event.
    let scene = Scene::point()
        .under(&[(-5.0, 0.0), (0.0, 0.0), (5.0, -10.0)], -12.0)
        .tune(|t| t.air_accel = 40.0);
    scene.each(|run| {
        run.spawn(-0.1, 0.01).advance(1.0).walk(0.2).hold(0.0);
        run.advance(1.56);
        assert!(!run.airborne() && !run.supported(), "sliding");
        run.control(Control {
            run: 1.0,
            jump: true,
            ..Control::default()
        });
        run.advance(1.57);
        assert_eq!(run.when(|kind| kind == EventKind::Jumped), 1.56);
        close(run.speed().y, 12.0 - 30.0 * 0.01, 1e-9);
    });
}

#[test]
fn crouching_at_a_tip_that_touches_the_floor_stays_on_its_side() {
    // The body stands where the floor has a vertex; which of the two pieces there it is on, the numbers cannot say.
    let scene = Scene::point()
        .rect((-10.0, 10.0), (-1.0, 0.0))
        .solid(&[(0.0, 0.0), (6.0, 1.0), (0.0, 1.0)])
        .tune(|t| (t.run_accel, t.run_brake) = (50.0, 50.0));
    for side in [-1.0, 1.0] {
        scene.each(|run| {
            run.spawn(2.0 * side, 0.0).hold(-side).advance(2.0);
            run.near(0.0, 0.0, 0.0);
            for down in [true, false] {
                let later = run.time() + 1.0;
                run.down(down).advance(later);
                assert_eq!(run.crouched(), down);
                run.near(0.0, 0.0, 0.0);
            }
            let later = run.time() + 0.1;
            run.hold(side).advance(later);
            assert!(run.at().x * side > 0.1, "back to where it came from");
        });
    }
}
