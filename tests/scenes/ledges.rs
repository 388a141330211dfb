//! Ledges and climbable walls: taking hold, hanging, climbing, letting go; corners that are forgiven.

use super::rig::*;
use super::walls::{at_all_rates, cliff, steering};
use edgewalker::geom::{Collider, STEP};
use edgewalker::motion::grip::Grip;
use edgewalker::motion::{Control, EventKind, Traits};

/// Hands reach 1.25 m up, and the last fifth of a metre is helped.
pub fn hanging(scene: Scene) -> Scene {
    steering(scene).tune(|t| {
        (t.ledge_hang, t.ledge_magnet) = (1.25, 0.2);
        (t.ledge_climb_speed, t.climb_accel, t.climb_speed) = (5.0, 60.0, 4.0);
    })
}

fn up(run: &mut Run, up: bool) {
    run.control(Control {
        up,
        ..Control::default()
    });
}

fn has(run: &Run, kind: EventKind) -> bool {
    run.kinds().contains(&kind)
}

fn corrected(run: &Run) -> Option<f64> {
    run.kinds().into_iter().find_map(|k| match k {
        EventKind::Corrected(distance) => Some(distance),
        _ => None,
    })
}

#[test]
fn a_slide_past_a_ledge_takes_hold_of_it_and_hangs_frozen() {
    at_all_rates(&hanging(cliff()), |run, rate| {
        run.spawn(-HALF, -0.5).hold(1.0).ticks(rate as u32, rate);
        close(
            run.when(|k| k == EventKind::Grabbed),
            f64::sqrt(0.75 / 15.0),
            1e-12,
        );
        run.near(-HALF, -1.25, 0.0);
        run.frozen(60);
        run.hold(0.0).frozen(3600);
        assert_eq!(run.body().grip(), Grip::Ledge);
    });
}

#[test]
fn up_or_jump_climbs_onto_the_ledge() {
    // 1/12 s to 5 m/s, then at that speed: 1.25 m in 7/24 s.
    for jumps in [false, true] {
        at_all_rates(&hanging(cliff()), |run, rate| {
            run.spawn(-HALF, -0.5).hold(1.0).ticks(rate as u32, rate);
            match jumps {
                true => {
                    run.jump(true);
                }
                false => up(run, true),
            }
            run.ticks(rate as u32, rate);
            assert!(has(run, EventKind::Climbed) && run.supported());
            close(
                run.when(|k| k == EventKind::Landed(0.0)),
                1.0 + 7.0 / 24.0,
                1e-12,
            );
            run.near(-HALF, 0.0, 0.0);
            run.frozen(60);
        });
    }
}

#[test]
fn down_or_away_lets_go_and_does_not_take_hold_again() {
    for away in [false, true] {
        at_all_rates(&hanging(cliff()), |run, rate| {
            run.spawn(-HALF, -0.5).hold(1.0).ticks(rate as u32, rate);
            match away {
                true => run.hold(-1.0).hold(0.0),
                false => run.down(true).down(false),
            };
            run.advance(1.0).hold(if away { 0.0 } else { 1.0 });
            run.ticks(rate as u32 / 2, rate);
            run.near(-HALF, -1.25 - 15.0 / 4.0, 1e-12);
            let grabs = run.kinds().into_iter().filter(|&k| k == EventKind::Grabbed);
            assert_eq!(grabs.count(), 1);
            assert!(has(run, EventKind::LetGo));
        });
    }
}

#[test]
fn a_jump_away_from_a_ledge_is_a_wall_jump() {
    let scene = hanging(cliff()).tune(|t| (t.wall_jump_out, t.wall_jump_up) = (6.0, 10.0));
    scene.each(|run| {
        run.spawn(-HALF, -0.5).hold(1.0).advance(1.0);
        run.control(Control {
            run: -1.0,
            jump: true,
            ..Control::default()
        });
        assert!(has(run, EventKind::WallJumped) && !has(run, EventKind::Climbed));
        assert_eq!(run.speed(), v(-6.0, 10.0));
    });
}

#[test]
fn a_ledge_is_caught_from_a_little_below() {
    // At the wall after 0.25 s, having fallen 15/16 m.
    for (low, caught) in [(0.0, true), (0.125, true), (0.1999, true), (0.2001, false)] {
        at_all_rates(&hanging(cliff()), |run, rate| {
            run.spawn(-HALF - 1.0, -1.25 - low + 0.9375)
                .velocity(4.0, 0.0)
                .ticks(rate as u32 / 2, rate);
            assert_eq!(has(run, EventKind::Grabbed), caught, "{low}");
            if caught {
                close(run.when(|k| k == EventKind::Grabbed), 0.25, 1e-12);
                run.near(-HALF, -1.25, 0.0);
            }
        });
    }
}

#[test]
fn no_hold_in_a_rise_nor_below_a_ledge_without_room() {
    hanging(cliff()).each(|run| {
        run.spawn(-HALF, -2.5)
            .velocity(0.0, 14.0)
            .hold(1.0)
            .advance(0.5);
        assert!(!has(run, EventKind::Grabbed) && run.at().y > 0.0);
    });
    // 1.8 m of room: a step less than the body.
    let low = hanging(cliff()).rect((-0.25, 5.0), (TALL - STEP, 4.0));
    low.each(|run| {
        run.spawn(-HALF, -0.5).hold(1.0).advance(1.0);
        assert!(!has(run, EventKind::Grabbed));
        run.near(-HALF, -15.5, 1e-12);
    });
}

#[test]
fn the_hero_climbs_over_the_bevel_of_his_foot() {
    let hero = Scene {
        stand: Collider::hero(),
        crouch: Collider::hero_crouched(),
        ..cliff()
    };
    at_all_rates(&hanging(hero), |run, rate| {
        run.spawn(-HALF, -0.75).hold(1.0).ticks(rate as u32, rate);
        assert!(has(run, EventKind::Grabbed));
        run.near(-HALF, -1.25, 0.0);
        up(run, true);
        run.ticks(rate as u32, rate);
        assert!(run.supported(), "{:?}", run.kinds());
        run.near(-0.25, 0.0, 0.0);
        // Up the upright side to the hip, then along the flank; from 1.25 m on at 5 m/s.
        let flank = v(13.0 / 32.0 - 0.25, 11.0 / 32.0).length();
        let way = 1.25 - 11.0 / 32.0 + flank;
        let lands = run.last(|k| matches!(k, EventKind::Landed(_)));
        close(lands, 1.0 + 1.0 / 12.0 + (way - 5.0 / 24.0) / 5.0, 1e-12);
    });
}

/// The lower wall of two can be climbed; they meet at y = -4.
const VINES: [Traits; 2] = [
    Traits {
        climbable: true,
        region: edgewalker::motion::Region::None,
        drawn: [0.0; 2],
        conveyor: 0.0,
        friction: None,
        concave: None,
        minds_riders: false,
    },
    Traits {
        climbable: false,
        region: edgewalker::motion::Region::None,
        drawn: [0.0; 2],
        conveyor: 0.0,
        friction: None,
        concave: None,
        minds_riders: false,
    },
];

fn vines() -> Scene {
    hanging(Scene::boxed())
        .tune(|t| t.ledge_hang = 0.0)
        .rect((0.0, 5.0), (-60.0, -4.0))
        .rect((0.0, 5.0), (-4.0, 0.0))
}

#[test]
fn a_climbable_wall_is_climbed_up_to_its_end() {
    at_all_rates(&vines(), |run, rate| {
        run.terrain.traits = &VINES;
        // Falls past the bare wall, takes hold where it becomes climbable, and is at rest a metre below.
        run.spawn(-HALF, -2.0)
            .hold(1.0)
            .ticks(2 * rate as u32, rate);
        close(
            run.when(|k| k == EventKind::Climbed),
            f64::sqrt(2.0 / 15.0),
            1e-12,
        );
        run.near(-HALF, -4.0 - 1.0, 1e-12);
        run.frozen(60);
        run.hold(0.0).frozen(60);
        // 1/15 s to 4 m/s; stops where the climbable part ends.
        up(run, true);
        run.trace.clear();
        run.ticks(rate as u32, rate);
        let way: f64 = 1.0;
        close(
            run.when(|k| k == EventKind::Stopped(4.0)) - 4.0,
            1.0 / 15.0 + (way - 2.0 / 15.0) / 4.0,
            1e-11,
        );
        run.near(-HALF, -4.0, 0.0);
        run.frozen(60);
        up(run, false);
        run.frozen(60).down(true).ticks(rate as u32, rate);
        close(run.speed().y, -4.0, 0.0);
    });
}

#[test]
fn a_climbable_wall_is_climbed_over_and_left() {
    let scene = vines();
    let vines = [VINES[0], VINES[0]];
    scene.each(|run| {
        run.terrain.traits = Box::leak(Box::new(vines));
        run.spawn(-HALF, -2.0).hold(1.0).advance(1.0);
        up(run, true);
        run.advance(3.0);
        assert!(run.supported());
        run.near(-HALF, 0.0, 0.0);
        run.frozen(60);
    });
    // The stick away lets go; a jump leaves with or without wall jumps.
    for (jump, out, up, speed) in [
        (false, 6.0, 10.0, v(0.0, 0.0)),
        (true, 6.0, 10.0, v(-6.0, 10.0)),
        (true, 6.0, 0.0, v(-6.0, 6.0)),
    ] {
        let scene = scene
            .clone()
            .tune(|t| (t.wall_jump_out, t.wall_jump_up) = (out, up));
        scene.each(|run| {
            run.terrain.traits = Box::leak(Box::new(vines));
            run.spawn(-HALF, -2.0).hold(1.0).advance(1.0);
            match jump {
                true => run.jump(true),
                false => run.hold(-1.0),
            };
            assert!(run.airborne());
            assert_eq!(has(run, EventKind::LetGo), !jump);
            assert_eq!(run.speed(), speed);
        });
    }
}

#[test]
fn a_belt_on_top_does_not_make_a_climber_climb_without_end() {
    let hero = Scene {
        stand: Collider::hero(),
        crouch: Collider::hero_crouched(),
        ..vines().tune(|t| t.run_brake = 30.0)
    };
    let belt = Traits {
        conveyor: -3.0,
        ..VINES[0]
    };
    for variant in [Variant::Plain, Variant::Shifted] {
        hero.with(variant, &|run: &mut Run| {
            run.terrain.traits = Box::leak(Box::new([VINES[0], belt]));
            run.spawn(-HALF, -2.0).hold(1.0).advance(1.0);
            up(run, true);
            run.advance(3.0);
            let landings = run.kinds().into_iter();
            let landings = landings.filter(|k| matches!(k, EventKind::Landed(_)));
            assert_eq!((landings.count(), run.supported()), (1, true));
            run.near(-0.25, 0.0, 0.0);
            run.frozen(60);
        });
    }
}

#[test]
fn a_climber_comes_down_onto_the_ground() {
    let scene = vines().rect((-5.0, 5.0), (-9.0, -8.0));
    scene.each(|run| {
        run.terrain.traits = Box::leak(Box::new([VINES[0]; 3]));
        run.spawn(-HALF, -7.0).hold(1.0).advance(0.25).hold(0.0);
        assert_eq!(run.body().grip(), Grip::Wall);
        run.down(true).advance(2.0);
        assert!(run.supported());
        run.near(-HALF, -8.0, 0.0);
    });
}

/// A floor, and a block over it whose lower left corner is at (0, `bottom`).
fn under_block(bottom: f64, right: f64, limit: f64) -> Scene {
    Scene::boxed()
        .rect((-9.0, 9.0), (-1.0, 0.0))
        .rect((0.0, right), (bottom, bottom + 1.0))
        .tune(|t| t.corner_correction = limit)
}

#[test]
fn scene_70_corner_correction_to_its_limit_and_not_beyond() {
    let c = 0.125;
    let rises = |x: f64| {
        move |run: &mut Run| {
            run.spawn(x, 0.0).jump(true).advance(0.25);
        }
    };
    for (x, granted) in [(c, true), (c + STEP, false), (c / 2.0, true), (0.0, true)] {
        at_all_rates(&under_block(3.0, 5.0, c), |run, rate| {
            run.spawn(-HALF + x, 0.0)
                .jump(true)
                .ticks((0.4 * rate) as u32, rate);
            let moved = corrected(run);
            assert_eq!(moved, (granted && x > 0.0).then_some(x), "{x}");
            if granted {
                run.near(
                    -HALF,
                    12.0 * run.time() - 15.0 * run.time() * run.time(),
                    1e-12,
                );
            }
        });
    }
    // One unit in the last place more; far from the origin that is lost.
    for variant in [Variant::Plain, Variant::Mirrored] {
        let x: f64 = -HALF + c;
        for (x, granted) in [(x, true), (x.next_up(), false)] {
            under_block(3.0, 5.0, c).with(variant, &|run: &mut Run| {
                rises(x)(run);
                assert_eq!(corrected(run).is_some(), granted);
            });
        }
    }
}

#[test]
fn of_two_corners_the_nearer_one_counts() {
    // Rises to the block in 0.25 s; the ceiling is 2 HALF + 0.125 = 0.9375 m wide. A step beside its middle decides.
    for (x, end) in [
        (-STEP, Some(-HALF)),
        (0.0, None),
        (STEP, Some(0.125 + HALF)),
    ] {
        let scene = under_block(2.0625 + TALL, 0.125, 0.5);
        scene.each(|run| {
            run.spawn(0.0625 + x, 0.0).jump(true).advance(0.25);
            match end {
                Some(end) => {
                    run.near(end, 2.0625, 1e-12);
                    assert_eq!(run.speed(), v(0.0, 4.5));
                }
                None => assert!(has(run, EventKind::Hit(4.5)) && corrected(run).is_none()),
            }
        });
    }
    // In the middle the sideways speed decides.
    for side in [-1.0, 1.0] {
        under_block(2.0625 + TALL, 0.125, 0.5).each(|run| {
            run.spawn(0.0625 - 0.25 * side, 0.0)
                .jump(true)
                .velocity(side, 12.0)
                .advance(0.25);
            run.near(0.0625 + side * 0.46875, 2.0625, 1e-12);
            assert_eq!(run.speed(), v(side, 4.5));
        });
    }
}

#[test]
fn round_a_corner_a_motion_into_the_wall_goes_up_along_it() {
    under_block(2.0625 + TALL, 5.0, 0.125).each(|run| {
        run.spawn(-HALF + 0.0625 - 0.25, 0.0)
            .jump(true)
            .velocity(1.0, 12.0)
            .advance(0.25);
        assert_eq!(corrected(run), Some(0.0625));
        assert!(has(run, EventKind::Hit(1.0)));
        run.near(-HALF, 2.0625, 1e-12);
        assert_eq!(run.speed(), v(0.0, 4.5));
    });
}

#[test]
fn feet_that_barely_miss_a_ledge_are_lifted_onto_it() {
    let c = 0.125;
    let scene = cliff().tune(|t| t.ledge_correction = c);
    for (low, granted) in [(c, true), (c + STEP, false), (0.0625, true)] {
        at_all_rates(&scene, |run, rate| {
            // At the wall after 0.25 s, 15/16 m lower.
            run.spawn(-HALF - 1.0, 0.9375 - low)
                .velocity(4.0, 0.0)
                .ticks(rate as u32 / 2, rate);
            assert_eq!(corrected(run), granted.then_some(low));
            if granted {
                assert_eq!(run.when(|k| matches!(k, EventKind::Landed(_))), 0.25);
                run.near(-HALF + 4.0 * (run.time() - 0.25), 0.0, 1e-12);
            }
        });
    }
    // Not in a rise.
    scene.each(|run| {
        run.spawn(-HALF - 0.5, -1.0).velocity(4.0, 8.0).advance(0.2);
        assert_eq!(corrected(run), None);
    });
}

#[test]
fn a_fast_fall_is_not_stopped_by_a_ledge_that_is_barely_missed() {
    // At the wall after 1/4 s, 1/16 m too low and 7.5 m/s faster than at first.
    let scene = cliff().tune(|t| (t.ledge_correction, t.ledge_correction_speed) = (0.125, 10.0));
    for (down, granted) in [(2.5, true), (2.5 + 1e-9, false), (20.0, false)] {
        at_all_rates(&scene, |run, rate| {
            run.spawn(-HALF - 1.0, 0.25 * down + 0.9375 - 0.0625)
                .velocity(4.0, -down)
                .ticks(rate as u32 / 2, rate);
            assert_eq!(corrected(run).is_some(), granted);
        });
    }
}
