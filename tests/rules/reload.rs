//! Another version of the level under a hero who plays.

use super::story::{hall, play, run, stage};
use edgewalker::game::{Input, Stage, World};
use edgewalker::tune::Tuning;
use glam::DVec2;
use std::sync::Arc;

/// What may be in a small level.
const PARTS: [&str; 7] = [
    "(id: \"hill\", outline: [(-3,-1),(4,-1),(3,1.25),(-2,1.25)]),",
    "(id: \"ramp\", outline: [(2,-1),(9,-1),(9,3)]),",
    "(id: \"roof\", outline: [(-9,1.2),(9,1.2),(9,3),(-9,3)]),",
    "(id: \"plank\", kind: OneWay, outline: [(-4,0.5),(6,0.5)]),",
    "(id: \"rungs\", kind: Ladder, outline: [(-1,0),(5,0),(5,6),(-1,6)]),",
    "(id: \"thorns\", kind: Hazard, outline: [(1,0),(3,0),(3,1),(1,1)]),",
    "(id: \"camp\", kind: Checkpoint, respawn: Some((0,3)), outline: [(0,0),(2,0),(2,2),(0,2)]),",
];

const MOVERS: [&str; 4] = [
    "",
    "(id: \"lift\", features: [(id: \"deck\", outline: [(-3,-1),(3,-1),(3,0.1),(-3,0.1)])], \
     path: [(at: (0,-1), seconds: 0.7, easing: Eased),(at: (0,3), seconds: 0.7)])",
    "(id: \"pusher\", features: [(id: \"block\", outline: [(-9,0),(-6,0),(-6,3),(-9,3)])], \
     path: [(at: (0,0), seconds: 1),(at: (9,0), seconds: 1)])",
    "(id: \"press\", features: [(id: \"head\", outline: [(-8,5),(8,5),(8,7),(-8,7)])], \
     path: [(at: (0,0), wait: 0.3, seconds: 0.4),(at: (0,-4.5), seconds: 0.4)])",
];

/// Thirty small levels; the hero starts above all of them.
fn levels() -> Vec<Arc<Stage>> {
    let all = (0..30_usize).map(|i| {
        let bits = i * 37 % 128;
        let parts = PARTS.iter().enumerate();
        let chosen = parts.filter(|(bit, _)| bits >> bit & 1 == 1);
        let features: String = chosen.map(|(_, part)| *part).collect();
        let text = hall(&features, MOVERS[i % 4]);
        // In some of them the ground is gone, or a step higher.
        let floor = ["(20,0),(-20,0)", "(20,-9),(-20,-9)", "(20,0.7),(-20,0.7)"][i % 3];
        let floor = text.replace("(20,0),(-20,0)", floor);
        stage(
            &floor
                .replace("(-20,-2),(20,-2)", "(-20,-12),(20,-12)")
                .replace("start: (0, 0)", "start: (0, 8)"),
        )
    });
    all.collect()
}

#[test]
fn every_level_may_follow_every_other_one() {
    let levels = levels();
    let (mut lost, mut kept) = (0, 0);
    for (i, from) in levels.iter().enumerate() {
        for (j, to) in levels.iter().enumerate() {
            let mut world = World::new(Arc::clone(from), 60, 0);
            let spots = world.add_body(&edgewalker::game::Shape::hero(), DVec2::new(-12.0, 8.0));
            assert_eq!(spots.unwrap(), 1);
            // He falls, runs, jumps and ducks until some moment.
            let at = |tick: usize| Input {
                run: [127, 127, -127, 0][(tick / 23 + i) % 4],
                jump: (tick + 5 * j) % 31 < 9,
                down: (tick + 3 * i) % 47 > 35,
                up: tick % 19 > 9,
                ..Input::default()
            };
            let until = 20 + (31 * i + 17 * j) % 90;
            let step = |world: &mut World, ticks: std::ops::Range<usize>| {
                for tick in ticks {
                    world.step(at(tick), &Tuning::default());
                    world
                        .check()
                        .unwrap_or_else(|e| panic!("{i} to {j}, tick {tick}: {e}"));
                }
            };
            step(&mut world, 0..until);
            let (p, v, began) = (
                world.view().position,
                world.view().velocity,
                world.view().began_at,
            );
            let away = world.view().away.is_some();
            world.replace_stage(Arc::clone(to));
            world.check().unwrap_or_else(|e| panic!("{i} to {j}: {e}"));
            let now = world.view();
            match now.began_at != began {
                true => lost += 1,
                false => {
                    assert!(!away);
                    if now.deaths == 0 && now.away.is_none() {
                        kept += 1;
                        assert_eq!(now.position, p, "{i} to {j}");
                        assert!(
                            i != j || (now.velocity - v).length() < 1e-9,
                            "{i}: {v} {}",
                            now.velocity
                        );
                    }
                }
            }
            step(&mut world, until..until + 40);
        }
    }
    println!("{kept} stayed where they were, {lost} began anew");
    assert!(kept > 200 && lost > 100, "{kept} {lost}");
}

/// Saving a level that has not changed where he is changes nothing of his way.
#[test]
fn he_goes_on_as_fast_as_he_was() {
    let lift = MOVERS[1];
    let roof = "(id: \"roof\", outline: [(4,1.2),(19,1.2),(19,3),(4,3)]),";
    let text = hall(roof, lift);
    let jump = Input {
        jump: true,
        ..run(1)
    };
    let duck = Input {
        down: true,
        ..run(1)
    };
    let scripts: [(&str, &[(u32, Input)]); 4] = [
        ("running", &[(3, run(1))]),
        ("in a jump", &[(1, run(1)), (1, jump)]),
        ("crouched under a roof", &[(3, run(1)), (12, duck)]),
        ("on the lift", &[(4, run(0))]),
    ];
    for (what, script) in scripts {
        let mut world = World::new(stage(&text), 120, 0);
        play(&mut world, script);
        let mut straight = world.clone();
        world.replace_stage(stage(&text.replace("hall", "other hall")));
        let (now, before) = (world.view(), straight.view());
        assert_eq!(
            (now.position, now.velocity),
            (before.position, before.velocity),
            "{what}"
        );
        assert!(
            what == "on the lift" || before.velocity.x > 2.0,
            "{what}: {}",
            before.velocity
        );
        assert_eq!(now.crouched, before.crouched, "{what}");
        let last = script[script.len() - 1].1;
        play(&mut world, &[(1, last)]);
        play(&mut straight, &[(1, last)]);
        let apart = (world.view().position - straight.view().position).length();
        assert!(
            apart < 1e-6,
            "{what}: {apart} m apart a tenth of a second later"
        );
    }
}
