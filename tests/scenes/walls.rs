//! Walls: slides that they slow, jumps from them.

use super::rig::*;
use edgewalker::geom::STEP;
use edgewalker::motion::EventKind;

/// A wall from x = 0 on, its top at y = 0; nothing below.
pub fn cliff() -> Scene {
    Scene::boxed().rect((0.0, 5.0), (-60.0, 0.0))
}

/// Steers at 16 m/s^2, and leaves the speed alone when the stick is released.
pub fn steering(scene: Scene) -> Scene {
    scene.tune(|t| (t.air_accel, t.air_brake) = (16.0, 0.0))
}

/// Runs a test on a scene in all variants with ticks of several lengths: all must print the same.
pub fn at_all_rates(scene: &Scene, test: impl Fn(&mut Run, f64)) {
    let story = std::cell::RefCell::new(Vec::new());
    for rate in [30.0, 60.0, 120.0, 240.0] {
        scene.each(|run| {
            test(run, rate);
            let mut told = vec![run.body().hash()];
            told.extend(run.trace.events.iter().map(|e| e.time.to_bits()));
            story.borrow_mut().push((run.variant, told));
        });
    }
    for (variant, told) in story.borrow().iter() {
        let first = &story.borrow()[*variant as usize].1;
        assert_eq!(told, first, "{variant:?}");
    }
}

#[test]
fn a_wall_that_is_pushed_against_slows_the_fall() {
    // From rest at 30 m/s^2 to 6 m/s, then at that speed.
    let scene = steering(cliff()).tune(|t| t.wall_slide_speed = 6.0);
    at_all_rates(&scene, |run, rate| {
        run.spawn(-HALF, -4.0).hold(1.0).ticks(rate as u32, rate);
        run.near(-HALF, -4.0 - 0.6 - 6.0 * 0.8, 1e-12);
        close(run.speed().y, -6.0, 0.0);
        // Let go of, it is a free fall again; with down held too.
        run.hold(0.0).ticks(rate as u32 / 2, rate);
        close(run.speed().y, -6.0 - 15.0, 1e-12);
    });
}

#[test]
fn a_fast_fall_is_braked_to_the_speed_of_the_slide() {
    let scene = steering(cliff())
        .tune(|t| (t.wall_slide_speed, t.wall_slide_brake, t.fall_speed) = (4.0, 100.0, 24.0));
    at_all_rates(&scene, |run, rate| {
        run.spawn(-HALF, -4.0)
            .velocity(0.0, -24.0)
            .hold(1.0)
            .ticks(rate as u32, rate);
        // 0.2 s from 24 to 4 m/s, 0.8 s at 4.
        run.near(-HALF, -4.0 - 2.8 - 3.2, 1e-11);
        run.down(true).ticks(rate as u32 / 10, rate);
        close(run.speed().y, -4.0 - 3.0, 1e-12);
    });
}

#[test]
fn a_slide_along_a_steep_slope_is_slowed_along_it() {
    // 3:4:5 and too steep: gravity along it is 24.
    let scene = Scene::boxed()
        .solid(&[(0.0, -40.0), (30.0, 0.0), (30.0, -40.0)])
        .tune(|t| (t.wall_slide_speed, t.air_accel) = (6.0, 10.0));
    scene.each(|run| {
        run.spawn(15.0 - HALF, -20.0).hold(1.0).advance(1.0);
        let speed = run.speed();
        close(speed.length(), 6.0, 1e-12);
        close(speed.y, -4.8, 1e-12);
    });
}

#[test]
fn a_wall_jump_leads_away_and_holds_the_direction() {
    let scene = steering(cliff()).tune(|t| {
        (t.wall_jump_out, t.wall_jump_up, t.wall_jump_lock) = (6.0, 10.0, 0.125);
        (t.air_brake, t.over_speed_decay) = (16.0, 8.0);
    });
    at_all_rates(&scene, |run, rate| {
        run.spawn(-HALF, -4.0)
            .hold(1.0)
            .advance(0.5)
            .near(-HALF, -7.75, 1e-12);
        run.jump(true);
        assert_eq!(run.kinds().last(), Some(&EventKind::WallJumped));
        assert_eq!(run.speed(), v(-6.0, 10.0));
        run.ticks((rate * 0.8) as u32, rate);
        // Over the wished 5 m/s it decays, while the direction is held; then the stick turns it.
        close(run.when(|k| k == EventKind::Unlocked), 0.625, 0.0);
        let turned = 0.625 + 5.0 / 16.0;
        let out = 6.0 / 8.0 - 4.0 / 64.0 + 25.0 / 32.0;
        let back = 25.0 / 32.0 + 5.0 * (1.3 - turned - 5.0 / 16.0);
        run.near(-HALF - out + back, -7.75 + 8.0 - 15.0 * 0.64, 1e-11);
    });
}

#[test]
fn a_jump_pressed_too_early_is_made_at_the_wall() {
    let scene = steering(cliff())
        .tune(|t| (t.wall_jump_out, t.wall_jump_up, t.jump_buffer) = (6.0, 10.0, 0.1));
    // Meets the wall after 0.25 s.
    for (early, granted) in [(-1e-9, true), (1e-9, false)] {
        scene.each(|run| {
            run.spawn(-HALF - 1.0, -4.0)
                .velocity(4.0, 0.0)
                .advance(0.15 - early)
                .jump(true)
                .advance(0.5);
            assert_eq!(run.kinds().contains(&EventKind::WallJumped), granted);
            if granted {
                close(run.when(|k| k == EventKind::WallJumped), 0.25, 1e-12);
            }
        });
    }
}

#[test]
fn a_wall_jump_is_granted_a_little_after_the_wall() {
    let scene = steering(cliff())
        .tune(|t| (t.wall_jump_out, t.wall_jump_up, t.wall_grace) = (6.0, 10.0, 0.08));
    for (late, granted) in [(-1e-9, true), (1e-9, false)] {
        scene.each(|run| {
            run.spawn(-HALF, -4.0)
                .hold(1.0)
                .advance(0.5)
                .hold(-1.0)
                .advance(0.58 + late);
            assert!(run.airborne() && run.kinds().contains(&EventKind::Parted));
            run.jump(true);
            assert_eq!(run.kinds().contains(&EventKind::WallJumped), granted);
            assert_eq!(run.speed().y == 10.0, granted);
        });
    }
}

#[test]
fn the_ground_has_precedence_over_the_wall() {
    // Off the floor at 0.48125 s, at the wall at 0.51875, off it at 0.53: a jump could be granted by either.
    let scene = steering(Scene::boxed())
        .rect((-5.0, 0.0), (-9.0, 0.0))
        .rect((1.0, 5.0), (-9.0, 9.0))
        .tune(|t| {
            (t.wall_jump_out, t.wall_jump_up) = (6.0, 10.0);
            (t.coyote_time, t.wall_grace) = (0.1, 0.5);
        });
    for (press, kind) in [(0.54, EventKind::Jumped), (0.59, EventKind::WallJumped)] {
        scene.each(|run| {
            run.spawn(-2.0, 0.0).walk(5.0).advance(0.53).hold(-1.0);
            assert_eq!(run.kinds().last(), Some(&EventKind::Parted));
            run.advance(press).jump(true);
            assert_eq!(run.kinds().last(), Some(&kind));
        });
    }
}

#[test]
fn no_wall_jump_without_its_speed_and_none_from_a_ceiling() {
    let still = steering(cliff());
    still.each(|run| {
        run.spawn(-HALF, -4.0).hold(1.0).advance(0.3).jump(true);
        assert!(!run.kinds().contains(&EventKind::WallJumped));
    });
    // One part out for seven up is more than a wall may overhang; one for eight is not.
    for (out, granted) in [(8.0, true), (8.0 + 8.0 * STEP, false)] {
        let scene = steering(Scene::point())
            .solid(&[(0.0, -64.0), (40.0, -64.0), (40.0, 0.0), (-out, 0.0)])
            .tune(|t| (t.wall_jump_out, t.wall_jump_up, t.air_accel) = (6.0, 10.0, 100.0));
        scene.each(|run| {
            run.spawn(-5.0, -32.0).hold(1.0).advance(0.5);
            let slides = !run.airborne();
            run.jump(true);
            assert!(slides, "{:?}", run.kinds());
            assert_eq!(run.kinds().contains(&EventKind::WallJumped), granted);
        });
    }
}
