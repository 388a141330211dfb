//! The figure in real levels: the whole recorded runs.

use super::RIG;
use edgewalker::anim::{Figure, Ground, angle_between};
use edgewalker::game::{Input, Replay, Sights, Soles, Stage, World};
use edgewalker::level;
use std::path::Path;
use std::sync::Arc;

/// The furthest that a bone turns within a tick, rad: a running thigh turns by 0.43.
const FASTEST: f32 = 0.49;

fn replay(name: &str) -> (Replay, World) {
    let path = Path::new("tests/golden").join(format!("{name}.replay.ron"));
    let replay = Replay::parse(&std::fs::read_to_string(path).unwrap()).unwrap();
    let stage = Stage::build(level::load(Path::new(&replay.level)).unwrap()).unwrap();
    let world = replay.world(Arc::new(stage)).unwrap();
    (replay, world)
}

#[test]
fn recorded_runs_are_acted_without_a_jump() {
    for run in ["gym", "quarry"] {
        let (replay, mut world) = replay(run);
        let mut soles = Soles::of(world.stage());
        let sights = Sights::of(world.stage());
        let mut figure = Figure::new(&world.view().moves(0.0, None), &RIG, &soles);
        let mut before = *figure.shown();
        let mut deaths = 0;
        let mut kinds = Vec::new();
        for input in replay.iter() {
            world.step(input, &replay.tuning);
            soles.follow(&world);
            let view = world.view();
            figure.advance(&view.moves(0.0, sights.near(view.position)), &RIG, &soles);
            assert!(figure.is_finite(), "{run}, tick {}", world.tick());
            let kind = figure.state().kind;
            if !kinds.contains(&kind) {
                kinds.push(kind);
            }
            let now = *figure.shown();
            if view.deaths == deaths {
                for (i, joint) in RIG.model.skeleton.joints.iter().enumerate() {
                    if ["cape", "lantern", "crest"]
                        .iter()
                        .any(|tail| joint.name.starts_with(tail))
                    {
                        continue; // what hangs swings freely
                    }
                    let turn = angle_between(before.pose.bones[i].turn, now.pose.bones[i].turn);
                    assert!(
                        turn < FASTEST,
                        "{run}, tick {}: {} turns by {turn} in {kind:?}",
                        world.tick(),
                        joint.name
                    );
                }
            }
            (before, deaths) = (now, view.deaths);
        }
        assert!(kinds.len() > 5, "{run}: {kinds:?}");
    }
}

#[test]
fn soles_find_floors_slopes_one_ways_and_movers() {
    let (_, mut world) = replay("gym");
    let mut soles = Soles::of(world.stage());
    let start = world.view().position;
    world.step(Input::default(), &Default::default());
    soles.follow(&world);
    let (height, slope) = soles.under(start.x, start.y + 0.7, start.y - 2.0).unwrap();
    assert!(
        (height - start.y).abs() < 2.0 && slope.abs() < 1.1,
        "{height} {slope}"
    );
    assert_eq!(soles.under(start.x, start.y + 500.0, start.y + 490.0), None);
}
