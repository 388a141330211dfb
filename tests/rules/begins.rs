//! Who begins in a region comes into it at once.

use super::story::{RATES, back, hall, play, run, stage, told};
use edgewalker::game::{Edit, Input, Shape, World};
use edgewalker::level::{Feature, Kind};
use edgewalker::motion::EventKind;
use glam::DVec2;
use std::sync::Arc;

const HERE: &str = "(id: \"button\", kind: Trigger, outline: [(-1,0),(1,0),(1,2),(-1,2)]), \
    (id: \"cave\", kind: Secret, outline: [(-1,0),(1,0),(1,2),(-1,2)]), \
    (id: \"camp\", kind: Checkpoint, respawn: Some((0,0)), outline: [(-1,0),(1,0),(1,2),(-1,2)]),";
const DOOR: &str = "(id: \"door\", features: [(id: \"leaf\", outline: [(8,3),(10,3),(10,4),(8,4)])], \
    path: [(at: (0,0), seconds: 1),(at: (0,3))], repeat: Once, starts: On(\"button\"))";

#[test]
fn at_the_start() {
    let text = hall(HERE, DOOR);
    let story = told(&text, &[(5, run(0))]);
    assert_eq!(story.offsets, [DVec2::new(0.0, 1.5)]);
    assert_eq!((story.last.secrets, story.last.secret_at), (1, Some(0.0)));
    assert_eq!(story.last.checkpoint, Some(DVec2::ZERO));
    let entered = story
        .events
        .iter()
        .filter(|(time, kind)| *time == 0.0 && matches!(kind, EventKind::Entered(_)));
    assert_eq!(entered.count(), 3, "{:?}", story.events);
    // It has happened before the first tick.
    let world = World::new(stage(&text), 60, 0);
    assert_eq!(world.view().secrets, 1);
}

#[test]
fn where_he_is_put_and_where_he_comes_back() {
    let there = HERE.replace("(-1,0),(1,0),(1,2),(-1,2)", "(5,0),(7,0),(7,2),(5,2)");
    let there = there.replace("Some((0,0))", "Some((6,0))");
    let text = hall(&there, DOOR);
    for rate in RATES {
        let mut world = World::new(stage(&text), rate, 0);
        play(&mut world, &[(5, run(0))]);
        world.put(DVec2::new(6.0, 0.0)).unwrap();
        assert_eq!(
            (world.view().secrets, world.view().secret_at),
            (1, Some(0.5))
        );
        assert_eq!(world.view().checkpoint, Some(DVec2::new(6.0, 0.0)));
        play(&mut world, &[(5, run(0))]);
        assert_eq!(world.offsets_at(1.0).next(), Some(DVec2::new(0.0, 1.5)));
    }
    // Beside the camp is its place, in the button: who comes back there sets the door going.
    let apart = "(id: \"button\", kind: Trigger, outline: [(5,0),(7,0),(7,2),(5,2)]), \
        (id: \"camp\", kind: Checkpoint, respawn: Some((6,0)), outline: [(3,0),(4,0),(4,2),(3,2)]),";
    let story = told(&hall(apart, DOOR), &[(5, run(1)), (1, back()), (4, run(0))]);
    assert_eq!(story.offsets, [DVec2::new(0.0, 1.5)]);
}

#[test]
fn anybody() {
    let there = HERE.replace("(-1,0),(1,0),(1,2),(-1,2)", "(5,0),(7,0),(7,2),(5,2)");
    let mut world = World::new(stage(&hall(&there, DOOR)), 60, 0);
    play(&mut world, &[(5, run(0))]);
    let twin = world
        .add_body(&Shape::hero(), DVec2::new(6.0, 0.0))
        .unwrap();
    play(&mut world, &[(5, run(0))]);
    assert_eq!(world.offsets_at(1.0).next(), Some(DVec2::new(0.0, 1.5)));
    assert_eq!(world.view().secrets, 0, "that is for the hero");
    assert_eq!(twin, 1);
}

#[test]
fn when_an_edit_or_another_version_puts_a_region_around_him() {
    let cave = Feature {
        id: "cave".into(),
        kind: Kind::Secret,
        outline: [(-1.0, 0.0), (1.0, 0.0), (1.0, 2.0), (-1.0, 2.0)]
            .map(DVec2::from)
            .to_vec(),
        ..Feature::default()
    };
    let mut world = World::new(stage(&hall("", "")), 60, 0);
    play(&mut world, &[(5, run(0))]);
    world.edit(Edit::Insert(cave.clone())).unwrap();
    assert_eq!(
        (world.view().secrets, world.view().secret_at),
        (1, Some(0.5))
    );
    let thorns = Feature {
        id: "thorns".into(),
        kind: Kind::Hazard,
        outline: [(2.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0)]
            .map(DVec2::from)
            .to_vec(),
        ..Feature::default()
    };
    world.put(DVec2::new(3.0, 0.0)).unwrap();
    world.edit(Edit::Insert(thorns)).unwrap();
    let view = world.view();
    assert_eq!((view.deaths, view.position), (1, DVec2::ZERO));
    let mut world = World::new(stage(&hall("", "")), 60, 0);
    play(&mut world, &[(5, run(0))]);
    world.replace_stage(stage(&hall(HERE, DOOR)));
    assert_eq!(world.view().secrets, 1);
    assert_eq!(world.view().checkpoint, Some(DVec2::ZERO));
    play(&mut world, &[(5, run(0))]);
    assert_eq!(world.offsets_at(1.0).next(), Some(DVec2::new(0.0, 1.5)));
}

/// A change of size that a key asks for comes at the key's own time, with all that follows from it.
#[test]
fn who_stands_up_into_a_region_is_in_it_from_that_time_on() {
    let above = "(id: \"cave\", kind: Secret, outline: [(-1,1.2),(1,1.2),(1,2),(-1,2)]), \
        (id: \"thorns\", kind: Hazard, outline: [(3,1.2),(5,1.2),(5,2),(3,2)]),";
    let duck = |run: i8| Input {
        run: 127 * run,
        down: true,
        ..Input::default()
    };
    let text = hall(above, "").replace("start: (0, 0)", "start: (-3, 0)");
    let under = told(&text, &[(10, duck(1)), (1, duck(0)), (1, run(0))]);
    assert!(
        (under.last.position.x - 0.0).abs() < 0.5,
        "{}",
        under.last.position
    );
    assert_eq!(under.last.secret_at, Some(1.1));
    let story = told(&text, &[(22, duck(1)), (3, duck(0)), (1, run(0))]);
    assert_eq!(story.last.deaths, 1, "{}", story.last.position);
    assert_eq!(story.returns, [2.5]);
}

/// In one long tick as in many short ones: everything that starts, starts at its own time.
#[test]
fn a_tick_has_room_for_everything() {
    let buttons: String = (0..20)
        .map(|i| {
            let x = 1.0 + 0.5 * f64::from(i);
            format!(
                "(id: \"b{i}\", kind: Trigger, outline: [({x},0),({0},0),({0},1),({x},1)]),",
                x + 0.25
            )
        })
        .collect();
    let doors: Vec<String> = (0..20)
        .map(|i| {
            DOOR.replace("door", &format!("d{i}"))
                .replace("leaf", &format!("l{i}"))
                .replace("button", &format!("b{i}"))
        })
        .collect();
    let stage = stage(&hall(&buttons, &doors.join(",")));
    let offsets = |rate: u32| {
        let mut world = World::new(Arc::clone(&stage), rate, 0);
        let right = run(1);
        for _ in 0..2 * rate {
            world.step(right, &Default::default());
        }
        world.offsets_at(2.0).collect::<Vec<_>>()
    };
    let slow = offsets(1);
    assert!(slow.iter().all(|o| o.y > 0.0), "{slow:?}");
    assert_eq!(offsets(1000), slow);
}
