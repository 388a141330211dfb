//! What it costs to act the hero: a moment of the figure in the recorded run of the quarry, and its matrices.
//! `cargo bench --no-default-features --bench anim`; the allocations that it prints are none.

use divan::counter::ItemsCount;
use divan::{AllocProfiler, Bencher, black_box};
use edgewalker::anim::{Figure, Ground, Moves, Rig};
use edgewalker::game::{Replay, Sights, Soles, Stage};
use edgewalker::level;
use std::path::Path;
use std::sync::Arc;

#[global_allocator]
static ALLOCATIONS: AllocProfiler = AllocProfiler::system();

/// Ticks of the run that are acted.
const TICKS: usize = 1200;

fn main() {
    divan::main();
}

fn rig() -> Rig {
    let bytes = std::fs::read("assets/models/hero.glb").unwrap();
    Rig::read("hero.glb", &bytes).unwrap()
}

/// What the body does in the first ticks of the recorded run, and the ground there.
fn run() -> (Vec<Moves>, Soles) {
    let text = std::fs::read_to_string("tests/golden/quarry.replay.ron").unwrap();
    let replay = Replay::parse(&text).unwrap();
    let stage = Stage::build(level::load(Path::new(&replay.level)).unwrap()).unwrap();
    let mut world = replay.world(Arc::new(stage)).unwrap();
    let (soles, sights) = (Soles::of(world.stage()), Sights::of(world.stage()));
    let moves = replay.iter().take(TICKS).map(|input| {
        world.step(input, &replay.tuning);
        let view = world.view();
        view.moves(0.0, sights.near(view.position))
    });
    (moves.collect(), soles)
}

/// One moment of the figure; items are ticks.
#[divan::bench]
fn moments(bencher: Bencher) {
    let (rig, (moves, soles)) = (rig(), run());
    let start = Figure::new(&moves[0], &rig, &soles);
    bencher
        .counter(ItemsCount::new(moves.len()))
        .bench_local(|| {
            let mut figure = start;
            for moment in &moves {
                figure.advance(moment, &rig, &soles);
            }
            black_box(*figure.shown())
        });
}

/// The matrices of all bones, for a picture between two ticks.
#[divan::bench]
fn matrices(bencher: Bencher) {
    let (rig, (moves, soles)) = (rig(), run());
    let figure = Figure::new(&moves[0], &rig, &soles);
    let shown = *figure.shown();
    bencher.bench_local(|| black_box(black_box(&shown).since(&shown, 0.5).skin(&rig)));
}

/// Where the ground is under one foot; items are looks.
#[divan::bench]
fn soles(bencher: Bencher) {
    let (moves, soles) = run();
    bencher
        .counter(ItemsCount::new(moves.len()))
        .bench_local(|| {
            let look = |m: &Moves| soles.under(m.foot.x, m.foot.y + 0.75, m.foot.y - 0.75);
            black_box(moves.iter().filter_map(look).count())
        });
}
