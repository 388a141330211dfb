//! One step of the mover against the clock, and the meshes of the shipped level.
//! `cargo bench --no-default-features --bench motion`.

#[path = "../tests/common/player.rs"]
mod player;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use edgewalker::game::{Replay, Shape, Stage};
use edgewalker::motion::{Body, Control, Trace};
use edgewalker::tune::Motion;
use player::quarry;
use std::sync::Arc;

fn main() {
    divan::main();
}

/// Steps a body again and again from the same state: `n` ticks at 120 Hz, after `warm` of them.
fn ticks(bencher: Bencher, warm: u32, n: u32, control: Control) {
    let stage = Stage::build(quarry()).unwrap();
    let tuning = Motion::default();
    let land = stage.land(&Shape::hero()).unwrap();
    let terrain = land.terrain(&stage, &tuning);
    let mut trace = Trace::default();
    let mut body = Body::spawn(stage.level.start, 0.0, &terrain).unwrap();
    body.advance(2.0, &terrain, &mut trace);
    body.apply(control, &terrain, &mut trace);
    let start = body.time();
    body.advance(start + f64::from(warm) / 120.0, &terrain, &mut trace);
    bencher.counter(ItemsCount::new(n)).bench_local(|| {
        let mut body = black_box(&body).clone();
        trace.clear();
        for tick in 1..=n {
            body.advance(start + f64::from(warm + tick) / 120.0, &terrain, &mut trace);
            black_box(body.position());
        }
        body
    });
}

/// Supported: half a second of running over natural slopes; items are steps.
#[divan::bench]
fn steps_supported(bencher: Bencher) {
    ticks(
        bencher,
        0,
        60,
        Control {
            run: 1.0,
            ..Control::default()
        },
    );
}

/// Airborne: a jump while running; items are steps.
#[divan::bench]
fn steps_airborne(bencher: Bencher) {
    ticks(
        bencher,
        1,
        60,
        Control {
            run: 1.0,
            jump: true,
            ..Control::default()
        },
    );
}

/// The whole golden run through the rules of the game; items are ticks.
#[divan::bench(sample_count = 20)]
fn ticks_of_the_golden_run(bencher: Bencher) {
    let stage = Arc::new(Stage::build(quarry()).unwrap());
    let replay = Replay::parse(include_str!("../tests/golden/quarry.replay.ron")).unwrap();
    bencher
        .counter(ItemsCount::new(replay.ticks()))
        .bench_local(|| replay.run(Arc::clone(&stage)).unwrap().hash());
}

/// A snapshot.
#[divan::bench]
fn clone_a_body(bencher: Bencher) {
    let stage = Stage::build(quarry()).unwrap();
    let tuning = Motion::default();
    let land = stage.land(&Shape::hero()).unwrap();
    let terrain = land.terrain(&stage, &tuning);
    let body = Body::spawn(stage.level.start, 0.0, &terrain).unwrap();
    bencher.bench_local(|| black_box(&body).clone());
}

/// A snapshot of the whole game.
#[divan::bench]
fn clone_a_world(bencher: Bencher) {
    let stage = Arc::new(Stage::build(quarry()).unwrap());
    let replay = Replay::parse(include_str!("../tests/golden/quarry.replay.ron")).unwrap();
    let world = replay.run(stage).unwrap();
    bencher.bench_local(|| black_box(&world).clone());
}

/// All three meshes of the quarry: standing, crouching, outlines.
#[divan::bench(sample_count = 20)]
fn build_the_quarry(bencher: Bencher) {
    bencher
        .with_inputs(quarry)
        .bench_local_values(|level| Stage::build(level).unwrap());
}
