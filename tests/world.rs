//! The rules of the game over the motion: several bodies, edits while they move, snapshots.

#[path = "common/player.rs"]
mod player;

use edgewalker::game::{Edit, EditError, Input, Shape, Snapshot, Stage, World};
use edgewalker::geom::{Collider, Point};
use edgewalker::level::{Feature, Kind, Level, Material, Rect};
use edgewalker::motion::Control;
use edgewalker::tune::Tuning;
use glam::DVec2;
use player::quarry;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use std::sync::Arc;

/// A box between two corners.
fn block(id: &str, (x0, y0): (f64, f64), (x1, y1): (f64, f64)) -> Feature {
    Feature {
        id: id.into(),
        material: Material::Timber,
        outline: [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
            .map(DVec2::from)
            .to_vec(),
        ..Feature::default()
    }
}

/// A floor of masonry with something on it.
fn level(more: &[Feature]) -> Level {
    let floor = Feature {
        material: Material::Masonry,
        ..block("floor", (-50.0, -1.0), (50.0, 0.0))
    };
    Level {
        version: 1,
        name: "A floor".into(),
        start: DVec2::ZERO,
        goal: Rect {
            min: DVec2::new(48.0, 0.0),
            max: DVec2::new(49.0, 3.0),
        },
        bottom: -20.0,
        features: [&[floor], more].concat(),
        movers: Vec::new(),
        areas: Vec::new(),
        frames: Vec::new(),
        prompts: Vec::new(),
        scenery: Vec::new(),
    }
}

fn world(more: &[Feature]) -> World {
    World::new(Arc::new(Stage::build(level(more)).unwrap()), 120, 0)
}

fn run(run: i8) -> Input {
    Input {
        run,
        ..Input::default()
    }
}

fn step(world: &mut World, input: Input, ticks: usize) {
    let tuning = Tuning::default();
    (0..ticks).for_each(|_| world.step(input, &tuning));
}

#[test]
fn the_game_knows_what_the_hero_stands_on() {
    let mut world = world(&[block("crate", (3.0, 0.0), (6.0, 0.4))]);
    step(&mut world, Input::default(), 30);
    assert_eq!(world.view().material, Some(Material::Masonry));
    let jump = Input {
        jump: true,
        ..run(127)
    };
    step(&mut world, jump, 20);
    assert_eq!(world.view().material, None);
    while world.view().position.x < 4.0 {
        step(&mut world, jump, 1);
    }
    step(&mut world, Input::default(), 60);
    assert_eq!(world.view().material, Some(Material::Timber));
}

/// A gap that is too low for one body is open to a smaller one, in the same level.
#[test]
fn bodies_of_several_sizes_meet_the_same_level() {
    let mut world = world(&[block("lintel", (5.0, 1.0), (7.0, 4.0))]);
    let (w, h) = (1 << 14, 1 << 15);
    let corners = [(-w, 0), (w, 0), (w, h), (-w, h)];
    let small = Collider::new(corners.map(|(x, y)| Point::new(x, y)).to_vec()).unwrap();
    assert_eq!(world.stage().mesh_count(), 3);
    let rat = world
        .add_body(&Shape::rigid(small.clone()), DVec2::new(2.0, 0.0))
        .unwrap();
    let twin = world
        .add_body(&Shape::hero(), DVec2::new(1.0, 0.0))
        .unwrap();
    assert_eq!(
        world.stage().mesh_count(),
        4,
        "a shape's meshes are built once"
    );
    let right = Control {
        run: 1.0,
        ..Control::default()
    };
    world.control(rat, right);
    world.control(twin, right);
    step(&mut world, Input::default(), 360);
    let at: Vec<f64> = world.bodies().map(|body| body.position().x).collect();
    assert_eq!(at[0], 0.0);
    assert!(at[rat] > 20.0, "{at:?}");
    assert_eq!(at[twin], 5.0 - 13.0 / 32.0);
    assert!(
        world
            .add_body(&Shape::rigid(small), DVec2::new(6.0, 2.0))
            .is_err()
    );
}

#[test]
fn meshes_are_built_by_one_thread_and_shared_by_all() {
    let stage = Stage::build(quarry()).unwrap();
    let odd = Collider::new(vec![
        Point::new(0, 0),
        Point::new(9999, 0),
        Point::new(0, 9999),
    ])
    .unwrap();
    let found: Vec<_> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..8)
            .map(|_| scope.spawn(|| stage.meshes(&odd).unwrap()))
            .collect();
        threads
            .into_iter()
            .map(|thread| thread.join().unwrap())
            .collect()
    });
    assert!(
        found
            .iter()
            .all(|meshes| Arc::ptr_eq(&meshes.level, &found[0].level))
    );
}

#[test]
fn an_edit_is_felt_by_those_it_touches_and_by_nobody_else() {
    let mut edited = world(&[block("bridge", (5.0, 3.0), (9.0, 4.0))]);
    let near = edited
        .add_body(&Shape::hero(), DVec2::new(7.0, 4.0))
        .unwrap();
    step(&mut edited, Input::default(), 60);
    step(&mut edited, run(-127), 10);
    let mut untouched = edited.clone();
    edited.edit(Edit::Remove("bridge".into())).unwrap();
    step(&mut edited, run(-127), 1);
    step(&mut untouched, run(-127), 1);
    assert_eq!(edited.hero(), untouched.hero(), "the hero runs far away");
    let fall = edited.bodies().nth(near).unwrap();
    assert!(!fall.supported() && fall.velocity().y < 0.0);
    edited
        .edit(Edit::Insert(block("bridge", (5.0, 1.0), (9.0, 2.0))))
        .unwrap();
    step(&mut edited, Input::default(), 120);
    assert_eq!(edited.bodies().nth(near).unwrap().position().y, 2.0);
    edited
        .edit(Edit::Replace(block("bridge", (5.0, 1.0), (9.0, 1.5))))
        .unwrap();
    step(&mut edited, Input::default(), 120);
    assert_eq!(edited.bodies().nth(near).unwrap().position().y, 1.5);
}

#[test]
fn a_refused_edit_says_why_and_changes_nothing() {
    let mut world = world(&[]);
    let (hash, edits) = (world.hash(), world.stage().edits().len());
    let floor = block("floor", (0.0, 1.0), (1.0, 2.0));
    assert_eq!(
        world.edit(Edit::Insert(floor)),
        Err(EditError::Taken("floor".into()))
    );
    assert_eq!(
        world.edit(Edit::Remove("door".into())),
        Err(EditError::Unknown("door".into()))
    );
    let nowhere = block("nowhere", (0.0, f64::NAN), (1.0, 2.0));
    let refused = world.edit(Edit::Insert(nowhere)).unwrap_err().to_string();
    assert_eq!(
        refused,
        "feature \"nowhere\", outline[0].y: NaN is not a finite number"
    );
    let line = Feature {
        kind: Kind::OneWay,
        conveyor: f64::INFINITY,
        ..block("belt", (0.0, 1.0), (1.0, 2.0))
    };
    assert!(world.edit(Edit::Replace(line)).is_err());
    assert_eq!((world.hash(), world.stage().edits().len()), (hash, edits));
}

/// A hero who does something else every few ticks, in a level that changes as he plays.
struct Chaos(Pcg64Mcg, Input);

impl Chaos {
    fn step(&mut self, world: &mut World, tick: u32) {
        let dice = &mut self.0;
        if dice.next_u32().is_multiple_of(6) {
            let word = dice.next_u32();
            self.1 = Input {
                run: [-127, -40, 0, 90, 127][(word % 5) as usize],
                jump: word & 8 != 0,
                down: word & 48 == 48,
                up: word & 64 != 0,
                retry: false,
                ..Input::default()
            };
        }
        if tick % 40 == 20 {
            let at = f64::from(dice.next_u32() % 80) - 40.0;
            let id = format!("box {}", (tick / 40) % 4);
            let new = block(&id, (at, 0.0), (at + 2.0, 1.0));
            match tick / 160 % 3 {
                0 => world.edit(Edit::Insert(new)).unwrap(),
                1 => world.edit(Edit::Replace(new)).unwrap(),
                _ => world.edit(Edit::Remove(id)).unwrap(),
            }
        }
        world.step(self.1, &Tuning::default());
    }
}

/// Hard case 68. Every snapshot goes through text, and is taken up in the stage as it was loaded.
#[test]
fn a_snapshot_of_every_chaotic_tick_goes_on_to_the_same_end() {
    let fresh = Arc::new(Stage::build(level(&[block("step", (10.0, 0.0), (12.0, 2.0))])).unwrap());
    let mut world = World::new(Arc::clone(&fresh), 120, 7);
    let rat = Collider::new(vec![
        Point::new(0, 0),
        Point::new(20000, 0),
        Point::new(0, 30000),
    ]);
    let rat = world
        .add_body(&Shape::rigid(rat.unwrap()), DVec2::new(-3.0, 0.0))
        .unwrap();
    let mut chaos = Chaos(Pcg64Mcg::seed_from_u64(68), Input::default());
    let mut kept: Vec<(String, Pcg64Mcg, Input)> = Vec::new();
    let play = |world: &mut World, chaos: &mut Chaos, tick: u32| {
        let run = if tick % 70 < 35 { 0.7 } else { -1.0 };
        let jump = tick % 50 < 10;
        world.control(
            rat,
            Control {
                run,
                jump,
                ..Control::default()
            },
        );
        chaos.step(world, tick);
    };
    let mut hashes = Vec::new();
    for tick in 0..600 {
        kept.push((
            ron::to_string(&world.snapshot()).unwrap(),
            chaos.0.clone(),
            chaos.1,
        ));
        play(&mut world, &mut chaos, tick);
        hashes.push(world.hash());
    }
    for (tick, (text, dice, input)) in (0..).zip(kept) {
        let snapshot: Snapshot = ron::from_str(&text).unwrap();
        let mut again = World::restore(Arc::clone(&fresh), snapshot).unwrap();
        let mut chaos = Chaos(dice, input);
        // To the end from every 60th, and a few ticks on from the others.
        let until = if tick % 60 == 0 {
            600
        } else {
            (tick + 3).min(600)
        };
        for t in tick..until {
            play(&mut again, &mut chaos, t);
            assert_eq!(
                again.hash(),
                hashes[t as usize],
                "from tick {tick}, at tick {t}"
            );
        }
    }
}

#[test]
fn a_snapshot_belongs_to_its_level() {
    let snapshot = world(&[]).snapshot();
    let other = Arc::new(Stage::build(level(&[block("new", (1.0, 1.0), (2.0, 2.0))])).unwrap());
    let refused = World::restore(other, snapshot.clone())
        .unwrap_err()
        .to_string();
    assert_eq!(refused, "the snapshot is of another level");
    let mut edited = world(&[]);
    edited
        .edit(Edit::Insert(block("new", (1.0, 1.0), (2.0, 2.0))))
        .unwrap();
    let stage = Arc::clone(edited.stage());
    assert!(World::restore(Arc::clone(&stage), edited.snapshot()).is_ok());
    let refused = World::restore(stage, snapshot).unwrap_err().to_string();
    assert_eq!(
        refused,
        "the level was edited in another way than in the snapshot"
    );
}
