//! Where a hero can do what the place asks for, in whole levels at every tick rate: ladders that end at their platform, ledges with
//! room to crouch, one-ways at the foot of a ladder, the sides of the world.

use edgewalker::cli::check::{Plan, run};
use edgewalker::game::{Input, Shape, Stage, World};
use edgewalker::level::parse;
use edgewalker::motion::mount::short_of_ground;
use edgewalker::motion::{EventKind, Size};
use edgewalker::tune::Tuning;
use std::path::Path;
use std::sync::Arc;

const RATES: [u32; 5] = [30, 60, 120, 240, 1000];

/// A floor at y = 0 and what else is said.
fn level(start: &str, bottom: f64, features: &str) -> Arc<Stage> {
    let text = format!(
        "(version: 1, name: \"places\", start: {start}, goal: (min: (900, 0), max: (901, 1)), bottom: {bottom},
         features: [(id: \"floor\", outline: [(-20, -2), (20, -2), (20, 0), (-20, 0)]), {features}])"
    );
    let level = parse(&text, Path::new("places.ron")).unwrap();
    Arc::new(Stage::build(level).unwrap())
}

/// Plays a list of inputs, each until a time, at every rate. What it hands to the test, and the hash at the end, must be equal.
fn at_every_rate(
    stage: &Arc<Stage>,
    tuning: &Tuning,
    plan: &[(f64, Input)],
    test: impl Fn(&World, &[(f64, EventKind)]),
) {
    let mut told = Vec::new();
    for rate in RATES {
        let mut world = World::new(Arc::clone(stage), rate, 0);
        let mut events = Vec::new();
        for &(until, input) in plan {
            while (world.time() - until) * f64::from(rate) < -0.5 {
                world.step(input, tuning);
                world.check().unwrap();
                events.extend(world.trace().events.iter().map(|e| (e.time, e.kind)));
            }
        }
        test(&world, &events);
        let body = world.hero();
        told.push((body.position(), body.velocity(), events));
    }
    for other in &told {
        assert_eq!(*other, told[0]);
    }
}

const NONE: Input = Input {
    run: 0,
    jump: false,
    down: false,
    up: false,
    retry: false,
    respawn: false,
};
const UP: Input = Input { up: true, ..NONE };
const DOWN: Input = Input { down: true, ..NONE };
const RIGHT: Input = Input { run: 127, ..NONE };

const LADDER: &str =
    "(id: \"ladder\", kind: Ladder, outline: [(-0.5, 0), (0.5, 0), (0.5, 6), (-0.5, 6)]),";
const SIDES: &str = "(id: \"left\", outline: [(-6, 5.5), (-0.6, 5.5), (-0.6, 6), (-6, 6)]),
     (id: \"right\", outline: [(0.6, 5.5), (6, 5.5), (6, 6), (0.6, 6)]),";
const ACROSS: &str = "(id: \"top\", kind: OneWay, outline: [(-0.6, 6), (0.6, 6)]),";

#[test]
fn a_ladder_as_high_as_its_platform_is_climbed_up_and_down() {
    let whole = [LADDER, SIDES, ACROSS].concat();
    at_every_rate(
        &level("(0, 6)", -40.0, &whole),
        &Tuning::default(),
        &[(2.0, DOWN), (4.0, UP), (4.5, NONE)],
        |world, events| {
            assert!(world.hero().supported());
            assert_eq!(world.hero().position().to_array(), [0.0, 6.0]);
            assert!(!events.contains(&(events[0].0, EventKind::Resized(Size::Crouch))));
            let landings: Vec<f64> = events
                .iter()
                .filter(|e| matches!(e.1, EventKind::Landed(_)))
                .map(|e| e.0)
                .collect();
            // Down 6 m at 4 m/s, reached with 60 m/s^2, and up again from rest.
            let climb = (6.0 + 2.0 / 15.0) / 4.0;
            let [.., down, up] = landings[..] else {
                panic!("{events:?}");
            };
            assert!((down - climb).abs() < 1e-12, "{down}");
            assert!((up - 2.0 - climb).abs() < 1e-12, "{up}");
        },
    );
    // Without what is across, onto the side to which he has looked.
    for side in [1, -1] {
        let looks = Input {
            run: 20 * side,
            ..NONE
        };
        let open = [LADDER, SIDES].concat();
        at_every_rate(
            &level("(0, 0)", -40.0, &open),
            &Tuning::default(),
            &[(0.1, looks), (0.3, NONE), (3.0, UP), (3.5, NONE)],
            |world, _| {
                assert!(world.hero().supported());
                let at = world.hero().position();
                assert_eq!(at.y, 6.0);
                assert!(at.x * f64::from(side) > 0.3, "{at}");
            },
        );
    }
    // One side alone, and a ladder that ends somewhat below it, or above.
    for top in [5.6, 5.9, 6.0, 6.4] {
        let right = format!(
            "(id: \"ladder\", kind: Ladder, outline: [(-0.5, 0), (0.5, 0), (0.5, {top}), (-0.5, {top})]),
             (id: \"right\", outline: [(0.6, 5.5), (6, 5.5), (6, 6), (0.6, 6)]),"
        );
        at_every_rate(
            &level("(0, 0)", -40.0, &right),
            &Tuning::default(),
            &[(3.0, UP), (3.5, NONE)],
            |world, _| {
                assert!(world.hero().supported());
                assert_eq!(world.hero().position().y, 6.0, "{top}");
            },
        );
    }
}

#[test]
fn a_ledge_with_room_to_crouch_is_climbed_onto() {
    for roof in [4.76, 5.0, 5.3, 5.49] {
        let ledge = format!(
            "(id: \"block\", outline: [(1.2, 0), (8, 0), (8, 3.8), (1.2, 3.8)]),
             (id: \"roof\", outline: [(1.2, {roof}), (4, {roof}), (4, 9), (1.2, 9)]),"
        );
        let jump = Input {
            jump: true,
            ..RIGHT
        };
        at_every_rate(
            &level("(0, 0)", -40.0, &ledge),
            &Tuning::default(),
            &[
                (0.1, NONE),
                (0.5, jump),
                (1.5, RIGHT),
                (2.5, UP),
                (3.0, NONE),
                (5.0, RIGHT),
            ],
            |world, events| {
                let has = |kind| events.iter().any(|e| e.1 == kind);
                assert!(has(EventKind::Grabbed), "{roof}: {events:?}");
                assert!(has(EventKind::Resized(Size::Crouch)));
                // Through under the roof, and upright behind it.
                assert!(world.hero().position().x > 4.0, "{roof}");
                assert_eq!(world.hero().size(), Size::Stand);
            },
        );
    }
}

#[test]
fn who_lets_go_of_a_ladder_at_its_foot_stands_on_the_one_way_there() {
    let foot = "(id: \"boards\", kind: OneWay, outline: [(-3, 3), (3, 3)]),
         (id: \"ladder\", kind: Ladder, outline: [(-0.5, 3), (0.5, 3), (0.5, 9), (-0.5, 9)]),";
    let both = Input { jump: true, ..DOWN };
    for held in [0.1, 0.5, 1.0] {
        at_every_rate(
            &level("(0, 3)", -40.0, foot),
            &Tuning::default(),
            // Up a little, and off again; then down along it with down held, and a jump at its foot.
            &[
                (held, UP),
                (held + 0.1, both),
                (2.0, NONE),
                (3.0, UP),
                (5.0, DOWN),
                (5.5, NONE),
            ],
            |world, events| {
                assert_eq!(world.hero().position().to_array(), [0.0, 3.0]);
                assert!(world.hero().supported());
                assert!(events.iter().all(|e| e.1 != EventKind::Dropped));
            },
        );
    }
    // Who stands there, and holds nothing, falls through as anywhere.
    at_every_rate(
        &level("(0, 3)", -40.0, foot),
        &Tuning::default(),
        &[(0.5, NONE), (0.6, both), (2.0, NONE)],
        |world, events| {
            assert_eq!(world.hero().position().to_array(), [0.0, 0.0]);
            assert!(events.iter().any(|e| e.1 == EventKind::Dropped));
        },
    );
}

#[test]
fn beyond_the_sides_of_the_world_he_has_fallen_out() {
    for side in [1.0, -1.0] {
        let far = format!(
            "(id: \"rim\", outline: [({}, -1), ({}, -1), ({}, 0), ({}, 0)]),",
            3900.0 * side,
            3999.0 * side,
            3999.0 * side,
            3900.0 * side
        );
        let run = Input {
            run: 127 * side as i8,
            ..NONE
        };
        at_every_rate(
            &level(&format!("({}, 0)", 3990.0 * side), -3990.0, &far),
            &Tuning::default(),
            &[(6.0, run)],
            |world, events| {
                assert_eq!(world.view().deaths, 1);
                let pit = EventKind::Entered(world.stage().pit());
                let fell = events.iter().find(|e| e.1 == pit).unwrap().0;
                // 42 m at 8 m/s, reached with 80 m/s^2.
                assert!((fell - (42.0 + 0.4) / 8.0).abs() < 1e-9, "{fell}");
            },
        );
    }
}

#[test]
fn above_the_world_too() {
    let high = "(id: \"roof\", outline: [(-9, 3980), (9, 3980), (9, 3990), (-9, 3990)]),";
    let mut weightless = Tuning::default();
    weightless.motion.gravity = 1e-3;
    let jump = Input { jump: true, ..NONE };
    at_every_rate(
        &level("(0, 3990)", -40.0, high),
        &weightless,
        &[(0.2, NONE), (3.0, jump)],
        |world, events| {
            assert_eq!(world.view().deaths, 1);
            let sky = EventKind::Entered(world.stage().pit() + 1);
            let fell = events.iter().find(|e| e.1 == sky).unwrap().0;
            // 16 t - t^2 / 2000 = 42.
            let rises = (16.0 - f64::sqrt(256.0 - 0.084)) / 1e-3;
            assert!((fell - 0.2 - rises).abs() < 1e-9, "{fell}");
        },
    );
}

/// What a check says of a ladder in a level.
fn checked(features: &str) -> Option<f64> {
    let stage = level("(0, 0)", -40.0, features);
    let land = stage.land(&Shape::hero()).unwrap();
    let tuning = Tuning::default();
    short_of_ground(1, &land.terrain(&stage, &tuning.motion))
}

#[test]
fn a_check_tells_of_ladders_that_end_too_far_below_their_platform() {
    let to = |top: f64| {
        format!(
            "(id: \"ladder\", kind: Ladder, outline: [(-0.5, 0), (0.5, 0), (0.5, {top}), (-0.5, {top})]),"
        )
    };
    // 0.5 m below it is the furthest; and what is too short is said.
    for (top, short) in [
        (6.0, None),
        (5.5, None),
        (5.0, Some(0.5)),
        (3.75, Some(1.75)),
        (3.0, None),
    ] {
        for platform in [ACROSS, SIDES] {
            let found = checked(&[&to(top), platform].concat());
            let near = match (found, short) {
                (Some(found), Some(short)) => (found - short).abs() < 1e-4,
                (found, short) => found == short,
            };
            assert!(near, "{top}: {found:?}");
        }
    }
    // It ends above the ledge onto which one steps off; it leads nowhere; it stands under a ceiling.
    let ledge = "(id: \"ledge\", outline: [(0.6, 0), (9, 0), (9, 4), (0.6, 4)]),";
    let ceiling = "(id: \"rock\", outline: [(-9, 8), (9, 8), (9, 12), (-9, 12)]),";
    assert_eq!(checked(&[&to(5.0), ledge, ACROSS].concat()), None);
    assert_eq!(checked(&to(5.0)), None);
    assert_eq!(checked(&[&to(6.0), ceiling].concat()), None);
}

#[test]
fn the_check_of_a_level_names_the_ladder() {
    let folder = std::env::temp_dir().join(format!("edgewalker-places-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let text = "(version: 1, name: \"short\", start: (4, 0), goal: (min: (900, 0), max: (901, 1)), bottom: -40,
         features: [(id: \"floor\", outline: [(-20, -2), (20, -2), (20, 0), (-20, 0)]),
          (id: \"rungs\", kind: Ladder, outline: [(-0.5, 0), (0.5, 0), (0.5, 5), (-0.5, 5)]),
          (id: \"top\", kind: OneWay, outline: [(-3, 6), (3, 6)])])";
    let file = folder.join("short.ron");
    std::fs::write(&file, text).unwrap();
    let plan = Plan {
        level: file,
        tuning: None,
        ticks: 10,
        tick_rate: 60,
        seed: 1,
        record: None,
    };
    let report = run(&plan).unwrap().to_string();
    std::fs::remove_dir_all(&folder).unwrap();
    let said = "feature \"rungs\": ends 0.50 m too far below the ground over it";
    assert!(report.contains(said), "{report}");
}
