//! What triggers have set going belongs to what a checkpoint keeps, and a death resets the rest.

use super::story::{anew, back, hall, play, run, stage, told};
use edgewalker::game::{Shape, World};
use edgewalker::motion::Mode;
use glam::DVec2;
use std::sync::Arc;

/// A ledge that only a lift leads to, which leaves once, half a second after somebody has touched the button on it.
const LIFT: &str = "(version: 1, name: \"lift\", start: (0, 0), goal: (min: (900, 0), max: (901, 1)), bottom: -20, \
    features: [(id: \"left\", outline: [(-20,-2),(2,-2),(2,0),(-20,0)]),(id: \"button\", kind: Trigger, outline: [(2.5,0),(4.5,0),(4.5,1),(2.5,1)]), \
    (id: \"ledge\", outline: [(6,-2),(20,-2),(20,8),(6,8)])CAMP], \
    movers: [(id: \"lift\", features: [(id: \"deck\", outline: [(2,-0.5),(6,-0.5),(6,0),(2,0)])], \
    path: [(at: (0,0), wait: 0.5, seconds: 3),(at: (0,8))], repeat: Once, starts: On(\"button\"))])";

fn lift(camp: &str) -> String {
    LIFT.replace("CAMP", camp)
}

/// The camp at a place that he comes through before or after the button.
fn camp(at: f64) -> String {
    format!(
        ",(id: \"camp\", kind: Checkpoint, respawn: Some((0,0)), outline: [({0},0),({1},0),({1},1),({0},1)])",
        at,
        at + 0.25
    )
}

#[test]
fn a_lift_that_left_without_him_waits_again_after_a_death() {
    // On the button and back, and the lift is gone.
    let leaves = [(5, run(1)), (6, run(-1)), (50, run(0))];
    let story = told(&lift(""), &leaves);
    assert_eq!(story.offsets, [DVec2::new(0.0, 8.0)]);
    assert!(story.last.position.x < 2.0, "{}", story.last.position);
    let dies = [&leaves[..], &[(1, back()), (1, run(0))]].concat();
    let story = told(&lift(""), &dies);
    assert_eq!(story.offsets, [DVec2::ZERO]);
    // And takes him up now.
    let rides = [&dies[..], &[(6, run(1)), (50, run(0)), (5, run(1))]].concat();
    let story = told(&lift(""), &rides);
    assert!(story.last.position.y == 8.0 && story.last.position.x > 6.0);
}

#[test]
fn a_checkpoint_keeps_what_had_started_when_he_came_to_it() {
    let script = [
        (5, run(1)),
        (6, run(-1)),
        (50, run(0)),
        (1, back()),
        (2, run(0)),
    ];
    // He comes through the camp on his way to the button, and again on his way back: it keeps what it knew at first.
    let before = told(&lift(&camp(0.5)), &script);
    assert_eq!(before.last.checkpoint, Some(DVec2::ZERO));
    assert_eq!(before.offsets, [DVec2::ZERO]);
    // He comes to the camp when the lift has left.
    let after = told(
        &lift(&camp(-2.0)),
        &[&script[..2], &[(4, run(-1)), (50, run(0))], &script[3..]].concat(),
    );
    assert_eq!(after.last.checkpoint, Some(DVec2::ZERO));
    assert_eq!(after.offsets, [DVec2::new(0.0, 8.0)]);
    // It goes on as if nothing had happened, not anew.
    let early = told(
        &lift(&camp(-2.0)),
        &[
            &script[..2],
            &[(4, run(-1)), (3, run(0)), (1, back()), (1, run(0))],
        ]
        .concat(),
    );
    let y = early.offsets[0].y;
    assert!(y > 2.0 && y < 8.0, "{y}");
    let undisturbed = told(
        &lift(&camp(-2.0)),
        &[&script[..2], &[(4, run(-1)), (5, run(0))]].concat(),
    );
    assert_eq!(early.offsets, undisturbed.offsets);
    // A new run begins with all as it was.
    let anew = told(
        &lift(&camp(-2.0)),
        &[&script[..2], &[(4, run(-1)), (3, run(0)), (1, anew())]].concat(),
    );
    assert_eq!(anew.offsets, [DVec2::ZERO]);
}

#[test]
fn what_a_checkpoint_keeps_is_kept_with_the_run() {
    let stage = stage(&lift(&camp(-2.0)));
    let mut first = World::new(Arc::clone(&stage), 120, 0);
    play(
        &mut first,
        &[(5, run(1)), (6, run(-1)), (4, run(-1)), (40, run(0))],
    );
    let kept = first.so_far();
    assert_eq!(kept.started.len(), 1);
    let text = ron::to_string(&kept).unwrap();
    let mut second = World::new(Arc::clone(&stage), 60, 0);
    assert!(second.resume(&ron::from_str(&text).unwrap()));
    let offset = |world: &World| world.offsets_at(world.time()).next();
    assert_eq!(offset(&second), Some(DVec2::new(0.0, 8.0)));
    assert_eq!(second.so_far(), kept);
    // A run that an older game has left says nothing of it.
    let old = "(checkpoint: Some(\"camp\"), seconds: 9.0, deaths: 1, secrets: [])";
    assert!(second.resume(&ron::from_str(old).unwrap()));
    assert_eq!(offset(&second), Some(DVec2::ZERO));
    assert_eq!(second.view().deaths, 1);
}

/// A lift that waits again takes along whom it carries; who is where it comes to is crushed, as by any solid that is put there.
#[test]
fn a_reset_decides_about_everybody() {
    let stage = stage(&lift(""));
    let mut world = World::new(stage, 120, 0);
    play(&mut world, &[(5, run(1)), (7, run(-1))]);
    let rider = world
        .add_body(&Shape::hero(), DVec2::new(5.0, 3.0))
        .unwrap();
    play(&mut world, &[(30, run(0))]);
    let below = world
        .add_body(&Shape::hero(), DVec2::new(3.0, -1.0))
        .unwrap();
    let mode = |world: &World, body: usize| world.bodies().nth(body).unwrap().mode().clone();
    assert_eq!(world.bodies().nth(rider).unwrap().carrier(), Some(0));
    play(&mut world, &[(1, back())]);
    assert_eq!(
        world.bodies().nth(rider).unwrap().position(),
        DVec2::new(5.0, 0.0)
    );
    assert!(matches!(mode(&world, below), Mode::Crushed(_)));
    assert!(matches!(mode(&world, 0), Mode::Surface(_)));
    assert!(!hall("", "").is_empty());
}
