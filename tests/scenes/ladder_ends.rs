//! The ends of ladders: up onto ground at the top, down from it, and what is at their feet. Climbing: 4 m/s at 60 m/s^2.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::{EventKind, Region};

/// A floor, and a ladder of 6 m that is climbed with a point of the body 0.875 m above its feet.
fn ladder(top: f64) -> Scene {
    let mut scene = Scene::boxed().rect((-50.0, 50.0), (-1.0, 0.0)).region(
        Region::Ladder,
        (-0.5, 0.5),
        (-0.875, top - 0.875),
    );
    scene.drawn = [0.875; 2];
    scene
}

/// How long it takes to climb so far from rest.
fn time_for(distance: f64) -> f64 {
    (distance + 2.0 / 15.0) / 4.0
}

fn landed(kind: EventKind) -> bool {
    matches!(kind, EventKind::Landed(_))
}

#[test]
fn up_a_ladder_as_high_as_the_one_way_across_it() {
    // Somewhat below it and above it too.
    for (top, from) in [(6.0, 0.0), (5.6, 0.125), (6.5, -0.25)] {
        let scene = ladder(top).one_way(&[(-3.0, 6.0), (3.0, 6.0)]);
        at_every_rate(&scene, |run, rate| {
            run.spawn(from, 0.0).up(true).play(3.0, rate);
            run.near(from, 6.0, 0.0);
            assert!(run.supported() && !run.body().climbing());
            // Without a stop on the way.
            close(run.last(landed), time_for(6.0), 1e-12);
            run.frozen(60).up(false).frozen(60);
            // Down climbs down, and does not crouch.
            let t = run.time();
            run.down(true).play(t + 1.0, rate);
            assert!(run.body().climbing() && !run.crouched());
            run.near(from, 6.0 - 4.0 + 2.0 / 15.0, 1e-12);
            run.play(t + 3.0, rate).near(from, 0.0, 0.0);
            assert!(run.supported());
        });
    }
}

#[test]
fn up_a_ladder_between_two_platforms() {
    let scene = ladder(6.0)
        .rect((-9.0, -0.75), (5.5, 6.0))
        .rect((0.75, 9.0), (5.5, 6.0));
    // The nearer one; in the middle the one that he looks to.
    for (from, looks, side) in [
        (0.125, 0.0, 1.0),
        (-0.125, 0.0, -1.0),
        (0.0, -1.0, -1.0),
        (0.0, 1.0, 1.0),
    ] {
        let from: f64 = from;
        at_every_rate(&scene, |run, rate| {
            run.spawn(from, 0.0).hold(looks).hold(0.0).up(true);
            run.play(4.0, rate);
            assert!(run.supported() && !run.body().climbing(), "{}", run.at());
            close(run.at().y, 6.0, 0.0);
            assert!(run.at().x * side > 0.0);
            // Up to its height, to rest there, then aside: the box stands as soon as a corner of its foot is over the ground.
            let aside = 0.75 - HALF - from.abs();
            close(run.last(landed), time_for(6.0) + time_for(aside), 1e-12);
            run.up(false).frozen(60);
        });
    }
}

#[test]
fn another_ladder_on_the_way_aside_is_only_passed() {
    let other = (Region::Ladder, (0.2, 0.7), (5.5, 8.0));
    let scene = ladder(6.0).rect((0.75, 9.0), (5.5, 6.0));
    let scene = scene.region(other.0, other.1, other.2);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).up(true).play(4.0, rate);
        // Onto the platform, and from there up the other one, since up is held.
        close(
            run.last(landed),
            time_for(6.0) + time_for(0.75 - HALF),
            1e-12,
        );
        run.near(0.75 - HALF, 8.0, 1e-12);
        assert!(run.body().climbing());
        run.frozen(60);
    });
}

#[test]
fn up_a_ladder_beside_one_platform() {
    for solid in [true, false] {
        let scene = match solid {
            true => ladder(6.0).rect((0.75, 9.0), (5.5, 6.0)),
            false => ladder(6.0).one_way(&[(0.75, 6.0), (9.0, 6.0)]),
        };
        at_every_rate(&scene, |run, rate| {
            for from in [-0.375, 0.0, 0.25] {
                run.trace.clear();
                run.spawn(from, 0.0).up(true).play(4.0, rate);
                assert!(run.supported(), "{}", run.at());
                close(run.at().y, 6.0, 0.0);
            }
        });
    }
}

#[test]
fn he_may_rest_on_the_way_and_go_back() {
    let scene = ladder(6.0).one_way(&[(-3.0, 6.0), (3.0, 6.0)]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).up(true).play(1.375, rate);
        // Past the end of the ladder at 5.125, and braked in 2/15 m.
        run.up(false).play(2.0, rate).frozen(60);
        let high = 4.0 * 1.375 - 2.0 / 15.0 + 2.0 / 15.0;
        run.near(0.0, high, 1e-12);
        assert!(run.body().climbing() && run.body().regions().is_empty());
        // The stick leads nowhere.
        let t = run.time();
        run.hold(1.0).play(t + 0.5, rate).near(0.0, high, 1e-12);
        run.hold(0.0).down(true).play(t + 1.5, rate);
        run.near(0.0, high - 4.0 + 2.0 / 15.0, 1e-12);
        assert!(run.body().climbing());
        run.down(false).up(true).play(t + 6.0, rate);
        run.near(0.0, 6.0, 0.0);
        assert!(run.supported());
    });
}

#[test]
fn out_of_reach_he_rests_at_the_end() {
    // 1.375 m above the feet is in reach, as far as a joint.
    for (height, reached) in [(5.125 + 1.375, true), (5.125 + 1.3755, false)] {
        let scene = ladder(6.0).one_way(&[(-3.0, height), (3.0, height)]);
        at_every_rate(&scene, |run, rate| {
            run.spawn(0.0, 0.0).up(true).play(4.0, rate);
            assert_eq!(run.supported(), reached);
            run.near(0.0, if reached { height } else { 5.125 }, 1e-5);
            run.frozen(60);
        });
    }
    // Under a roof there is no way on.
    let low = ladder(6.0)
        .one_way(&[(-3.0, 6.0), (3.0, 6.0)])
        .rect((-3.0, 3.0), (7.0, 8.0));
    at_every_rate(&low, |run, rate| {
        run.spawn(0.0, 0.0).up(true).play(4.0, rate);
        run.near(0.0, 5.125, 0.0).frozen(60);
        assert!(run.body().climbing());
    });
}

#[test]
fn a_jump_in_the_head_of_a_ladder_leaves_it() {
    let scene = ladder(6.0).one_way(&[(-3.0, 6.0), (3.0, 6.0)]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).up(true).play(1.4, rate);
        let y = run.at().y;
        run.jump(true);
        assert!(!run.body().climbing());
        assert_eq!(run.speed(), v(0.0, 16.0));
        run.play(1.5, rate).near(0.0, y + 1.6 - 0.15, 1e-12);
        // Let go of instead, it is a fall.
        run.jump(false).spawn(0.0, 0.0).up(true).play(1.4, rate);
        run.up(false).down(true).jump(true);
        assert!(!run.body().climbing() && run.airborne());
    });
}

#[test]
fn a_slope_over_a_ladder_is_climbed_onto_where_it_is() {
    let scene = ladder(6.0)
        .one_way(&[(-8.0, 2.0), (8.0, 10.0)])
        .tune(|t| t.run_brake = 1000.0);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.25, 0.0).up(true).play(4.0, rate);
        // The box stands on it with the corner of its foot.
        run.near(0.25, 6.0 + (0.25 + HALF) / 2.0, 1e-12);
        assert!(run.supported());
    });
}

#[test]
fn at_the_foot_of_a_ladder_a_one_way_is_stood_on() {
    // The ladder is drawn down to the one-way, to 1 mm above it, and below it: only that leads through.
    for (low, through) in [(3.0, false), (3.001, false), (2.5, true)] {
        let mut scene = Scene::boxed()
            .rect((-50.0, 50.0), (-1.0, 0.0))
            .one_way(&[(-3.0, 3.0), (3.0, 3.0)])
            .region(Region::Ladder, (-0.5, 0.5), (low - 0.875, 9.0));
        scene.drawn = [0.875; 2];
        at_every_rate(&scene, |run, rate| {
            run.spawn(0.0, 6.0).down(true).play(3.0, rate);
            assert_eq!(run.body().climbing(), through);
            if through {
                run.near(0.0, low - 0.875, 1e-4);
                return;
            }
            run.near(0.0, 3.0, 0.0);
            assert!(run.supported());
            // Down crouches there; up takes hold again.
            run.up(false).down(false).down(true).play(3.5, rate);
            run.near(0.0, 3.0, 0.0);
            assert!(run.supported() && !run.body().climbing());
            // Who holds the ladder and lets go with down and jump stands on the one-way then.
            run.down(false).up(true).play(3.6, rate);
            assert!(run.body().climbing() && run.at().y > 3.0);
            run.up(false).down(true).jump(true).play(5.0, rate);
            run.near(0.0, 3.0, 0.0);
            let dropped = run.kinds().contains(&EventKind::Dropped);
            assert!(run.supported() && !dropped, "{:?}", run.kinds());
        });
    }
}

#[test]
fn who_lets_go_at_the_end_of_a_ladder_in_line_with_a_one_way_stands_on_that() {
    let scene = Scene::boxed().one_way(&[(-3.0, 3.0), (3.0, 3.0)]).region(
        Region::Ladder,
        (-0.5, 0.5),
        (3.0, 9.0),
    );
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 6.0).down(true).play(1.0, rate);
        run.near(0.0, 3.0, 0.0);
        run.down(false).up(true).up(false);
        run.down(true).jump(true).jump(false).down(false);
        run.play(2.0, rate).near(0.0, 3.0, 0.0);
    });
}
