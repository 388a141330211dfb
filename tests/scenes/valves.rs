//! One-ways that are no floors: walls and ceilings that are passed from one side. A line's front is on the left of the way in
//! which it is drawn, whatever that is: it holds who comes from there.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::geom::Collider;
use edgewalker::motion::EventKind;
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// A floor, and a line over it.
fn over_floor(line: &[(f64, f64)]) -> Scene {
    Scene::boxed()
        .rect((-50.0, 50.0), (-1.0, 0.0))
        .one_way(line)
}

fn hero(scene: Scene) -> Scene {
    Scene {
        stand: Collider::hero(),
        crouch: Collider::hero_crouched(),
        ..scene
    }
}

fn stopped(kind: EventKind) -> bool {
    matches!(kind, EventKind::Stopped(_))
}

#[test]
fn a_line_drawn_upwards_stops_who_comes_from_the_left() {
    for (line, stops) in [
        ([(0.0, 0.0), (0.0, 3.0)], 1.0),
        ([(0.0, 3.0), (0.0, 0.0)], -1.0),
    ] {
        at_every_rate(&over_floor(&line), |run, rate| {
            for speed in [0.5, 5.0, 60.0] {
                run.trace.clear();
                run.spawn(-3.0 * stops, 0.0).walk(speed * stops);
                run.play(8.0, rate).near(-HALF * stops, 0.0, 0.0);
                close(run.when(stopped), (3.0 - HALF) / speed, 1e-12);
                run.frozen(60);
                // From the other side it is no event at all, and no way back.
                run.spawn(3.0 * stops, 0.0).walk(-speed * stops);
                run.trace.clear();
                let through = 8.0 / speed;
                run.play(through, rate).near(-5.0 * stops, 0.0, 1e-12);
                assert_eq!(run.kinds(), []);
                run.walk(speed * stops);
                run.play(2.0 * through, rate).near(-HALF * stops, 0.0, 0.0);
            }
        });
    }
}

#[test]
fn who_has_not_passed_it_with_all_of_him_may_turn_back() {
    at_every_rate(&over_floor(&[(0.0, 0.0), (0.0, 3.0)]), |run, rate| {
        // From behind until his left side is 0.01 m before the line's end of the way: its front is his right side's.
        run.spawn(3.0, 0.0).walk(-5.0);
        let half_way = (3.0 + HALF - 0.01) / 5.0;
        run.play(half_way, rate).walk(5.0);
        run.play(2.0 * half_way, rate).near(3.0, 0.0, 1e-12);
        // And a little further he may not.
        run.spawn(3.0, 0.0).walk(-5.0);
        run.play(half_way + 0.004, rate).walk(5.0);
        run.play(2.0, rate).near(-HALF, 0.0, 0.0);
    });
}

#[test]
fn a_line_drawn_from_right_to_left_is_a_ceiling_to_who_comes_from_below() {
    let scene = over_floor(&[(3.0, 3.0), (-3.0, 3.0)]);
    at_every_rate(&scene, |run, rate| {
        // 3 - 29/16 m of room over him, at 12 m/s under 30 m/s^2.
        let room = 3.0 - TALL;
        let up = (12.0 - f64::sqrt(144.0 - 60.0 * room)) / 30.0;
        let fast = 12.0 - 30.0 * up;
        run.spawn(1.0, 0.0).jump(true).play(3.0, rate);
        close(
            run.when(|k| matches!(k, EventKind::Hit(v) if (v - fast).abs() < 1e-12)),
            up,
            1e-12,
        );
        let down = f64::sqrt(room / 15.0);
        close(
            run.last(|k| matches!(k, EventKind::Landed(_))),
            up + down,
            1e-12,
        );
        // From above he falls through it, feet and head.
        run.spawn(0.0, 8.0);
        run.trace.clear();
        run.play(f64::sqrt(7.5 / 15.0), rate).near(0.0, 0.5, 1e-12);
        assert_eq!(run.kinds(), []);
    });
}

#[test]
fn it_holds_like_the_side_of_a_solid() {
    // The same side of a line and of a solid: who comes from its front moves in the same bits.
    let sides: [[&[(f64, f64)]; 2]; 4] = [
        // A wall that leans back, one that overhangs, a ceiling that falls to the right, a wall with a floor on top.
        [
            &[(0.0, 0.0), (2.0, 5.0)],
            &[(0.0, 0.0), (2.0, 0.0), (2.0, 5.0)],
        ],
        [
            &[(0.5, -1.0), (0.0, 6.0)],
            &[(0.5, -1.0), (3.0, -1.0), (3.0, 6.0), (0.0, 6.0)],
        ],
        [
            &[(6.0, 4.5), (-6.0, 5.5)],
            &[(6.0, 4.5), (6.0, 9.0), (-6.0, 9.0), (-6.0, 5.5)],
        ],
        [
            &[(1.0, -1.0), (1.0, 0.7), (9.0, 0.7)],
            &[(1.0, -1.0), (9.0, -1.0), (9.0, 0.7), (1.0, 0.7)],
        ],
    ];
    let lives = [
        (v(-1.0, 3.0), v(3.0, 2.0)),
        (v(-2.0, 0.0), v(6.0, 0.0)),
        (v(-2.0, 0.25), v(2.5, 9.0)),
        (v(-1.5, 0.0), v(0.0, 14.0)),
    ];
    let floor = || hero(Scene::boxed()).rect((-50.0, 50.0), (-2.0, 0.0));
    for [line, solid] in sides {
        for (at, velocity) in lives {
            let states = |scene: &Scene| {
                let out = std::cell::RefCell::new(Vec::new());
                scene.each(|run| {
                    run.spawn(at.x, at.y).velocity(velocity.x, velocity.y);
                    for _ in 0..30 {
                        run.ticks(1, 30.0);
                        out.borrow_mut().push((run.at(), run.speed()));
                    }
                });
                out.into_inner()
            };
            let [one, other] = [floor().one_way(line), floor().solid(solid)].map(|s| states(&s));
            assert_eq!(one, other, "{line:?}, {at}, {velocity}");
        }
    }
}

#[test]
fn it_is_slid_along_and_left_at_its_free_end() {
    let line = Scene::boxed().one_way(&[(0.0, -9.0), (0.0, 3.0)]);
    at_every_rate(&line, |run, rate| {
        // At the wall after 1/4 s; up along it, past its end, and on.
        run.spawn(-1.0 - HALF, 0.0)
            .velocity(4.0, 14.0)
            .play(0.5, rate);
        run.near(-HALF, 7.0 - 3.75, 1e-12);
        assert_eq!(run.when(|k| k == EventKind::Hit(4.0)), 0.25);
        // Down along it, past its lower end.
        run.spawn(-1.0 - HALF, 0.0)
            .velocity(4.0, 0.0)
            .play(2.0, rate);
        run.near(-HALF, -60.0, 1e-11);
    });
}

#[test]
fn a_jump_off_it_is_a_wall_jump() {
    let scene = over_floor(&[(0.0, 0.0), (0.0, 30.0)])
        .tune(|t| (t.wall_jump_out, t.wall_jump_up) = (6.0, 10.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(-1.0 - HALF, 9.0)
            .velocity(4.0, 0.0)
            .play(0.5, rate);
        run.jump(true);
        assert_eq!(run.speed(), v(-6.0, 10.0));
        run.play(0.75, rate);
        run.near(-HALF - 1.5, 9.0 - 3.75 + 2.5 - 15.0 / 16.0, 1e-12);
    });
}

#[test]
fn the_hero_meets_its_ends_as_he_meets_walls() {
    // Lower than his hip, a hand over the floor, or as low as his shin: it stops the walker, who does not ride up.
    for line in [
        [(0.0, 0.1), (0.0, 3.0)],
        [(0.0, 1.5), (0.0, 3.0)],
        [(0.0, 0.0), (0.0, 0.5)],
        [(0.0, 0.0), (0.0, 0.3)],
    ] {
        at_every_rate(&hero(over_floor(&line)), |run, rate| {
            run.spawn(-3.0, 0.0).walk(5.0).play(2.0, rate);
            assert!(run.supported());
            close(run.at().y, 0.0, 0.0);
            assert!((-HALF..=-0.25).contains(&run.at().x), "{}", run.at());
            run.spawn(3.0, 0.0).walk(-5.0).play(1.0, rate);
            run.near(-2.0, 0.0, 1e-12);
        });
    }
}

#[test]
fn a_moving_one_pushes_who_is_before_it_and_passes_who_is_behind() {
    let line = || Scene::boxed().one_way(&[(0.0, 0.0), (0.0, 3.0)]);
    let floor = Scene::boxed().rect((-50.0, 50.0), (-1.0, 0.0));
    let scene = floor.mover(line(), &[(0.0, v(2.0, 0.0), v(-4.0, 0.0), ZERO)]);
    at_every_rate(&scene, |run, rate| {
        // Its front comes to his right side after (2 - HALF) / 4 s.
        run.spawn(0.0, 0.0).play(3.0, rate);
        run.near(2.0 - 12.0 - HALF, 0.0, 1e-12);
        close(
            run.when(|k| k == EventKind::Pushed(0)),
            (2.0 - HALF) / 4.0,
            1e-12,
        );
        // To the right of it he is behind it.
        run.trace.clear();
        run.spawn(5.0, 0.0).play(3.0, rate).near(5.0, 0.0, 0.0);
    });
    let floor = Scene::boxed().rect((-50.0, 50.0), (-1.0, 0.0));
    let back = floor.mover(line(), &[(0.0, v(-2.0, 0.0), v(4.0, 0.0), ZERO)]);
    at_every_rate(&back, |run, rate| {
        run.spawn(0.0, 0.0);
        run.trace.clear();
        run.play(3.0, rate).near(0.0, 0.0, 0.0);
        assert_eq!(run.kinds(), []);
    });
}

#[test]
fn a_ceiling_that_comes_down_on_him_presses_and_one_that_rises_passes() {
    let line = || Scene::boxed().one_way(&[(5.0, 0.0), (-5.0, 0.0)]);
    let floor = || Scene::boxed().rect((-50.0, 50.0), (-1.0, 0.0));
    let falls = floor().mover(line(), &[(0.0, v(0.0, 6.0), v(0.0, -2.0), ZERO)]);
    at_every_rate(&falls, |run, rate| {
        run.spawn(0.0, 0.0).play(4.0, rate);
        close(
            run.when(|k| k == EventKind::Crushed),
            (6.0 - TALL) / 2.0,
            1e-12,
        );
    });
    let rises = floor().mover(line(), &[(0.0, v(0.0, -1.0), v(0.0, 2.0), ZERO)]);
    at_every_rate(&rises, |run, rate| {
        run.spawn(0.0, 0.0);
        run.trace.clear();
        run.play(4.0, rate).near(0.0, 0.0, 0.0);
        assert_eq!(run.kinds(), []);
    });
}

#[test]
fn climbers_are_held_by_walls_and_ceilings_too() {
    let scene = over_floor(&[(5.0, 5.0), (-5.0, 5.0)])
        .one_way(&[(0.75, 0.0), (0.75, 9.0)])
        .region(edgewalker::motion::Region::Ladder, (-2.0, 2.0), (0.0, 9.0));
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).up(true).play(3.0, rate);
        run.near(0.0, 5.0 - TALL, 0.0);
        run.up(false).hold(1.0).play(4.0, rate);
        run.near(0.75 - HALF, 5.0 - TALL, 0.0);
        assert!(run.body().climbing());
    });
}
