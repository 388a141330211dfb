//! Scene 60: one-way platforms. They are decided by the face that a body comes from: no margins, no flags.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::geom::STEP;
use edgewalker::motion::{EventKind, Region, Size};

/// A one-way from -5 to 5 at a height.
fn platform(y: f64) -> Scene {
    Scene::boxed().one_way(&[(-5.0, y), (5.0, y)])
}

fn dropped(kind: EventKind) -> bool {
    kind == EventKind::Dropped
}

fn landings(run: &Run) -> usize {
    let landed = |k: &EventKind| matches!(k, EventKind::Landed(_));
    run.kinds().iter().filter(|k| landed(k)).count()
}

/// Asks to fall through.
fn ask(run: &mut Run) {
    run.down(true).jump(true).jump(false).down(false);
}

#[test]
fn scene_60_an_apex_exactly_on_it_has_not_crossed() {
    // 12 m/s under 30 m/s^2 rise 2.4 m; 76 / 32 and 30.4 do so exactly.
    let exact = platform(2.25)
        .rect((-5.0, 5.0), (-1.0, 0.0))
        .tune(|t| t.gravity = 32.0);
    exact.each(|run| {
        run.spawn(0.0, 0.0).jump(true).advance(0.375);
        run.near(0.0, 2.25, 0.0).advance(0.75);
        assert_eq!(
            run.when(|k| matches!(k, EventKind::Landed(v) if v == 12.0)),
            0.75
        );
        run.near(0.0, 0.0, 0.0).frozen(60);
    });
    let one_step_lower = platform(2.25 - STEP)
        .rect((-5.0, 5.0), (-1.0, 0.0))
        .tune(|t| t.gravity = 32.0);
    one_step_lower.each(|run| {
        run.spawn(0.0, 0.0).jump(true).advance(2.0);
        run.near(0.0, 2.25 - STEP, 0.0).frozen(60);
        // Over the top in 2 sqrt(2 h / g) = 2^-9 s, h one step.
        assert_eq!(run.trace.events.last().unwrap().time, 0.375 + 1.0 / 1024.0);
    });
}

#[test]
fn scene_60_passing_up_at_5_changes_nothing() {
    let (with, without) = (platform(0.0), Scene::boxed());
    for variant in [Variant::Plain, Variant::Mirrored, Variant::Shifted] {
        let states = |scene: &Scene, until: f64| {
            let out = std::cell::RefCell::new(Vec::new());
            scene.with(variant, &|run: &mut Run| {
                run.spawn(1.0, -1.0).velocity(0.5, 85f64.sqrt());
                while run.time() < until {
                    run.ticks(1, 240.0);
                    out.borrow_mut().push((run.at(), run.speed()));
                }
            });
            out.into_inner()
        };
        // Up to the landing, at 5 m/s through it and for a third of a second over it.
        assert_eq!(states(&with, 0.42), states(&without, 0.42));
        with.with(variant, &|run: &mut Run| {
            run.spawn(1.0, -1.0)
                .velocity(0.5, 85f64.sqrt())
                .advance(2.0);
            close(run.at().y, 0.0, 0.0);
            assert!(run.supported());
        });
    }
}

#[test]
fn scene_60_a_thousand_jumps_on_the_seam_of_two() {
    let seam = Scene::boxed()
        .one_way(&[(-5.0, 0.0), (0.0, 0.0)])
        .one_way(&[(0.0, 0.0), (5.0, 0.0)]);
    for x in [0.0, HALF, -HALF] {
        seam.each(|run| {
            run.spawn(x, 0.0);
            for n in 0..1000u32 {
                run.jump(true).jump(false);
                run.advance(f64::from(n + 1));
                run.near(x, 0.0, 0.0);
                assert!(run.supported());
            }
            assert_eq!(landings(run), 1001);
        });
    }
}

#[test]
fn scene_60_next_to_a_wall() {
    let corner = platform(0.0).rect((5.0, 6.0), (-5.0, 5.0));
    corner.each(|run| {
        // Rises along the wall, through the platform, comes down on it, and stays in the corner.
        run.spawn(5.0 - HALF, -1.0).hold(1.0).velocity(0.0, 10.0);
        run.advance(3.0).near(5.0 - HALF, 0.0, 0.0);
        assert!(run.supported());
        run.frozen(60);
        // And down again along it.
        run.trace.clear();
        ask(run);
        assert!(run.kinds().contains(&EventKind::Dropped));
        run.advance(5.0);
        close(run.at().y, -15.0, 1e-12);
        close(run.at().x, 5.0 - HALF, 0.0);
    });
}

#[test]
fn scene_60_a_slope() {
    // 8:15:17. The box stands with one corner of its foot on it.
    let slope = Scene::boxed()
        .one_way(&[(-7.5, -4.0), (7.5, 4.0)])
        .tune(|t| t.run_brake = 1000.0);
    slope.each(|run| {
        run.spawn(0.0, 3.0).advance(2.0);
        let y = HALF * 8.0 / 15.0;
        close(run.at().y - run.at().x * 8.0 / 15.0, y, 1e-12);
        run.frozen(600);
        // Up from below: through it and back onto it.
        run.spawn(1.0, -2.0).velocity(-1.0, 14.0).advance(3.0);
        assert!(run.supported());
        close(run.at().y - run.at().x * 8.0 / 15.0, y, 1e-12);
        // A walk along it and a drop on the way: free fall from there.
        run.walk(3.4);
        run.ticks(6, 60.0);
        run.trace.clear();
        ask(run);
        let (at, t) = (run.at(), run.time());
        assert_eq!(run.last(dropped), t);
        run.advance(t + 1.0);
        run.near(at.x + 3.0, at.y + 1.6 - 15.0, 1e-9);
    });
}

#[test]
fn a_bent_slope_is_fallen_through_at_every_place() {
    // Other features cut this one-way in many places, so that its pieces point up and down by a step.
    let cut = (0..40).fold(
        Scene::point().one_way(&[(-7.0, -0.7), (7.01, 0.71)]),
        |s, i| {
            let x = -6.5 + 0.3171 * f64::from(i);
            s.wire((x, -9.0), (x + 0.093, 9.0))
        },
    );
    cut.each(|run| {
        for i in 0..200u32 {
            let x = -6.0 + 0.0597 * f64::from(i);
            run.spawn(x, 2.0).advance(1.0);
            assert!(run.supported(), "{i}");
            run.walk([3.0, -3.0][i as usize % 2]);
            let t = run.time() + f64::from(i % 7) * 1e-3;
            run.advance(t);
            ask(run);
            run.advance(t + 0.5);
            assert!(run.airborne(), "{i}: {:?}", run.trace.events);
            close(run.at().y, run.at().x * 1.41 / 14.01, 4.0);
            assert!(run.at().y < run.at().x * 1.41 / 14.01 - 3.0);
        }
    });
}

#[test]
fn scene_60_two_close_together_are_left_one_by_one() {
    let two = platform(0.0)
        .one_way(&[(-5.0, -0.05), (5.0, -0.05)])
        .rect((-5.0, 5.0), (-3.0, -2.0));
    two.each(|run| {
        run.spawn(0.0, 0.0);
        let lower = run
            .terrain
            .stand
            .segment(run.terrain.stand.segments_of(2)[0])
            .a
            .metres();
        let depth = -run.variant.back_y(lower.y);
        ask(run);
        run.advance(1.0);
        run.near(0.0, -depth, 0.0);
        assert_eq!(landings(run), 2);
        ask(run);
        run.advance(2.0);
        run.near(0.0, -2.0, 0.0);
        // On a solid the same request is a jump.
        run.down(true).jump(true);
        assert!(run.airborne() && run.speed().y == 12.0);
    });
}

#[test]
fn scene_60_a_press_in_the_air_is_a_jump_at_the_landing() {
    at_every_rate(&platform(0.0), |run, rate| {
        // Pressed 1/16 s before the landing, with down held: he lands, jumps at 12 m/s at that very time, and lands again.
        run.spawn(0.0, 15.0).play(15.0 / 16.0, rate);
        run.down(true).jump(true).play(1.25, rate);
        assert_eq!(run.when(|k| k == EventKind::Jumped), 1.0);
        run.near(0.0, 12.0 / 4.0 - 15.0 / 16.0, 1e-12);
        run.play(3.0, rate).near(0.0, 0.0, 0.0);
        assert_eq!(landings(run), 2);
        assert!(!run.kinds().into_iter().any(dropped));
        // Pressed anew on the platform, it is a request to fall through.
        run.jump(false).jump(true).play(3.25, rate);
        assert_eq!(run.last(dropped), 3.0);
        run.near(0.0, -15.0 / 16.0, 1e-12);
        // Too early a press is none.
        run.spawn(0.0, 15.0).play(7.0 / 8.0, rate);
        run.down(true).jump(true).play(1.5, rate);
        assert!(run.supported());
    });
}

#[test]
fn scene_60_moving_level_over_the_edge_is_no_landing_and_no_fall() {
    platform(0.0).tune(|t| t.gravity = 0.0).each(|run| {
        // Exactly along it, from outside: on whatever side, it stays level.
        run.spawn(-8.0, 0.0).velocity(4.0, 0.0).advance(4.0);
        run.near(8.0, 0.0, 0.0);
        assert_eq!(landings(run), 0);
    });
    platform(0.0).each(|run| {
        // Its foot level with the platform just as it comes to the end: not before its front, so past its end.
        run.spawn(-5.0 - HALF - 4.0, 15.0 / 4.0)
            .velocity(8.0, 0.0)
            .advance(0.5);
        run.near(-5.0 - HALF, 0.0, 1e-15).advance(1.0);
        assert!(run.at().y < -1.0 || run.supported());
    });
}

#[test]
fn scene_60_at_rest_nothing_falls_through_and_nothing_pops_up() {
    let scene = platform(0.0).rect((-50.0, 50.0), (-1.0 - TALL / 2.0, -TALL / 2.0));
    scene.each(|run| {
        // On it, at every place along it, for ten seconds; down alone is no request.
        for x in [-5.0, -4.3, 0.0, 1.0 / 3.0, 5.0] {
            run.spawn(x, 0.0)
                .up(true)
                .down(true)
                .advance(0.5)
                .frozen(600);
            run.near(x, 0.0, 0.0);
            assert!(run.supported() && landings(run) == 1);
        }
        // Under it, with the head through it.
        run.spawn(0.0, -TALL / 2.0).advance(0.5).frozen(600);
        run.near(0.0, -TALL / 2.0, 0.0);
    });
}

#[test]
fn a_walker_leaves_at_the_end_of_a_platform() {
    platform(0.0).each(|run| {
        run.spawn(4.0, 0.0).walk(5.0).advance(2.0);
        let leaves = (5.0 + HALF - 4.0) / 5.0;
        close(run.when(|k| k == EventKind::Left), leaves, 1e-15);
        run.near(14.0, -15.0 * (2.0 - leaves) * (2.0 - leaves), 1e-11);
    });
}

#[test]
fn a_platform_in_line_with_ground_goes_on_as_ground() {
    let scene = Scene::boxed()
        .rect((-10.0, 0.0), (-1.0, 0.0))
        .one_way(&[(0.0, 0.0), (4.0, 0.0)])
        .rect((4.0, 10.0), (-1.0, 0.0))
        // Laid over solid ground it stops like that.
        .one_way(&[(6.0, 0.0), (8.0, 0.0)]);
    scene.each(|run| {
        run.spawn(-8.0, 0.0).walk(5.0);
        let before = run.kinds().len();
        run.advance(3.0).near(7.0, 0.0, 1e-12);
        assert_eq!(run.kinds().len(), before, "{:?}", run.trace.events);
        run.hold(0.0).velocity(0.0, 0.0);
        ask(run);
        assert!(run.speed().y == 12.0, "solid: a jump");
        run.spawn(2.0, 0.0);
        ask(run);
        assert!(run.speed().y == 0.0 && run.airborne(), "a drop");
    });
}

#[test]
fn what_is_seen_from_behind_stops_nobody() {
    let scene = Scene::boxed()
        // From right to left: its front is down.
        .one_way(&[(5.0, 0.0), (-5.0, 0.0)])
        // Down, and steeply up: who goes to the right comes from behind.
        .one_way(&[(1.0, 5.0), (1.0, -5.0)])
        .one_way(&[(6.0, -30.0), (3.0, -36.0)])
        .region(Region::Plain, (-3.0, 3.0), (-3.0, 3.0));
    scene.each(|run| {
        run.spawn(0.0, 6.0).velocity(1.0, 0.0).advance(2.0);
        run.near(2.0, 6.0 - 60.0, 1e-10);
        assert!(
            run.kinds()
                .iter()
                .all(|k| matches!(k, EventKind::Entered(_) | EventKind::Exited(_)))
        );
    });
}

#[test]
fn sizes_keep_to_their_side() {
    let mut scene = platform(0.0).rect((-5.0, 5.0), (-9.0, -8.0));
    scene.crouch = box_collider(HALF, TALL / 2.0);
    scene.each(|run| {
        // Crouches on it, falls through it crouched, and stands up at that very place.
        run.spawn(0.0, 0.0).down(true);
        assert!(run.crouched());
        ask(run);
        assert!(run.airborne() && run.body().size() == Size::Stand);
        run.near(0.0, 0.0, 0.0).advance(0.25);
        run.near(0.0, -15.0 / 16.0, 1e-12);
        // Jumps from it crouched, and stands up at once: over it.
        run.spawn(0.0, 0.0)
            .down(true)
            .down(false)
            .jump(true)
            .advance(1.5);
        run.near(0.0, 0.0, 0.0);
        assert!(run.supported());
    });
}
