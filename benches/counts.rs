//! Small fixed pieces of work for counting instructions: `scripts/counts` runs them under callgrind.
//! `counts WORK TIMES` does a piece of work so many times.

#[path = "../tests/common/player.rs"]
mod player;
#[path = "../tests/common/worlds.rs"]
mod worlds;

use edgewalker::game::{Shape, Stage};
use edgewalker::geom::{Collider, ExpandedEdge};
use edgewalker::mesh::Mesh;
use edgewalker::motion::{Body, Control, Terrain, Trace};
use edgewalker::tune::Motion;
use player::crossing;
use std::hint::black_box;
use worlds::Dice;

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, work, times, ..] = arguments.as_slice() else {
        return; // `cargo bench` calls it without any
    };
    let Ok(times) = times.parse() else { return };
    match work.as_str() {
        "step-air" => steps(times, true),
        "step-ground" => steps(times, false),
        "insert" => inserts(times),
        "build" => builds(times),
        _ => panic!("no such work: {work}"),
    }
}

/// Half a second of running over natural slopes, or of a jump while running, at 120 Hz.
fn steps(times: u32, jump: bool) {
    let stage = Stage::build(crossing()).unwrap();
    let tuning = Motion::default();
    let land = stage.land(&Shape::hero()).unwrap();
    let terrain: Terrain = land.terrain(&stage, &tuning);
    let mut trace = Trace::default();
    let mut body = Body::spawn(stage.level.start, 0.0, &terrain).unwrap();
    body.advance(2.0, &terrain, &mut trace);
    let control = Control {
        run: 1.0,
        jump,
        ..Control::default()
    };
    for _ in 0..times {
        let mut body = black_box(&body).clone();
        trace.clear();
        body.apply(control, &terrain, &mut trace);
        for tick in 1..=60 {
            body.advance(2.0 + f64::from(tick) / 120.0, &terrain, &mut trace);
            black_box(body.position());
        }
    }
}

fn octagons(seed: u64, count: usize) -> Vec<Vec<ExpandedEdge>> {
    let world = worlds::octagons(&mut Dice::new(seed), count);
    worlds::expanded(&worlds::snapped(&world), &Collider::point())
}

/// One octagon among 300 overlapping ones goes, and another comes.
fn inserts(times: u32) {
    let mut mesh = Mesh::build(&octagons(1, 300)).unwrap();
    let others = octagons(2, 300);
    for i in 0..times {
        mesh.remove(0).unwrap();
        mesh.insert(0, &others[i as usize % others.len()]).unwrap();
    }
}

/// 300 overlapping octagons.
fn builds(times: u32) {
    let features = octagons(1, 300);
    for _ in 0..times {
        black_box(Mesh::build(black_box(&features)).unwrap());
    }
}
