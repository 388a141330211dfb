//! One step of the mover against the clock, and the meshes of the shipped level.
//! `cargo bench --no-default-features --bench motion`.

#[path = "../tests/common/player.rs"]
mod player;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use edgewalker::game::{Replay, Shape, Stage};
use edgewalker::geom::{Collider, ExpandedEdge, Point, expand};
use edgewalker::mesh::{Kind, Mesh};
use edgewalker::motion::{Body, Control, Mode, Mover, Path, Piece, Region, Terrain, Trace, Traits};
use edgewalker::tune::Motion;
use glam::DVec2;
use player::crossing;
use std::sync::Arc;

fn main() {
    divan::main();
}

/// Steps a body again and again from the same state: `n` ticks at 120 Hz, after `warm` of them.
fn ticks(bencher: Bencher, warm: u32, n: u32, control: Control) {
    let stage = Stage::build(crossing()).unwrap();
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

/// One step in each mode, in a small world made for it; items are steps of 1/120 s, 60 of them from the same state.
#[divan::bench(args = MODES)]
fn steps_by_mode(bencher: Bencher, mode: &str) {
    let site = Site::of(mode);
    let terrain = Terrain {
        traits: &site.traits,
        movers: &site.movers,
        ..Terrain::new(&site.mesh, &site.mesh, &site.tuning)
    };
    let mut trace = Trace::default();
    let mut body = Body::spawn(site.start, 0.0, &terrain).unwrap();
    body.apply(site.control, &terrain, &mut trace);
    body.advance(site.ready, &terrain, &mut trace);
    assert!((site.is_there)(&body), "{mode}: {:?}", body.mode());
    bencher.counter(ItemsCount::new(60u32)).bench_local(|| {
        let mut body = black_box(&body).clone();
        trace.clear();
        for tick in 1..=60 {
            body.advance(site.ready + f64::from(tick) / 120.0, &terrain, &mut trace);
            black_box(body.position());
        }
        body
    });
}

/// The modes, and what a body is doing in them.
const MODES: [&str; 9] = [
    "air",
    "ground",
    "slide",
    "wall",
    "wedge",
    "ladder",
    "riding",
    "walking on a lift",
    "pushed",
];

/// A world in which a body comes into a mode, and when it is in it.
struct Site {
    mesh: Mesh,
    traits: Vec<Traits>,
    movers: Vec<Mover>,
    tuning: Motion,
    start: DVec2,
    control: Control,
    ready: f64,
    is_there: fn(&Body) -> bool,
}

const FLOOR: [(i32, i32); 4] = [(-60, -1), (60, -1), (60, 0), (-60, 0)];

impl Site {
    fn of(mode: &str) -> Site {
        match mode {
            "riding" | "walking on a lift" | "pushed" => Site::with_a_lift(mode),
            "ladder" => Site::with_a_ladder(),
            _ => Site::still(mode),
        }
    }

    /// One solid, and a body in it that will be in a mode.
    fn new(
        solid: &[(i32, i32)],
        start: (f64, f64),
        run: f64,
        ready: f64,
        is_there: fn(&Body) -> bool,
    ) -> Site {
        Site {
            mesh: Mesh::of(&[(0, Kind::Solid, grown(solid))]).unwrap(),
            traits: Vec::new(),
            movers: Vec::new(),
            tuning: Motion::default(),
            start: DVec2::new(start.0, start.1),
            control: Control {
                run,
                ..Control::default()
            },
            ready,
            is_there,
        }
    }

    fn still(mode: &str) -> Site {
        let slides: fn(&Body) -> bool = |b| matches!(b.mode(), Mode::Surface(_)) && !b.supported();
        let slope = [(0, 0), (50, 0), (0, 100)];
        let wall = [(0, 0), (1, 0), (1, 90), (0, 90)];
        let vee = [(-9, 9), (-9, -9), (9, -9), (9, 9), (0, -8)];
        match mode {
            "air" => Site::new(&FLOOR, (0.0, 50.0), 1.0, 0.5, |b| {
                matches!(b.mode(), Mode::Air(_))
            }),
            "ground" => Site::new(&FLOOR, (0.0, 0.0), 1.0, 0.5, Body::supported),
            "slide" => Site::new(&slope, (4.0, 96.0), 0.0, 1.0, slides),
            "wall" => Site::new(&wall, (-0.5, 60.0), 1.0, 1.0, slides),
            "wedge" => Site::new(&vee, (0.0, 4.0), 0.0, 3.0, |b| {
                matches!(b.mode(), Mode::Wedge(_))
            }),
            _ => unreachable!("one of MODES"),
        }
    }

    fn with_a_ladder() -> Site {
        let ladder = grown(&[(-2, 0), (2, 0), (2, 80), (-2, 80)]);
        let climb = Traits {
            region: Region::Ladder,
            ..Traits::default()
        };
        Site {
            mesh: Mesh::of(&[(0, Kind::Solid, grown(&FLOOR)), (1, Kind::Region, ladder)]).unwrap(),
            traits: vec![Traits::default(), climb],
            control: Control {
                up: true,
                ..Control::default()
            },
            ..Site::new(&FLOOR, (0.0, 3.0), 0.0, 0.5, Body::climbing)
        }
    }

    fn with_a_lift(mode: &str) -> Site {
        let carried: fn(&Body) -> bool = |b| b.carrier().is_some();
        let (at, velocity, site) = match mode {
            "riding" => (
                (-15, 20),
                DVec2::new(0.0, 2.0),
                Site::new(&FLOOR, (0.0, 21.0), 0.0, 1.0, carried),
            ),
            "pushed" => (
                (-31, 1),
                DVec2::new(2.0, 0.0),
                Site::new(&FLOOR, (0.0, 0.0), 0.0, 1.5, |b| b.pushed_by().is_some()),
            ),
            _ => (
                (-15, 20),
                DVec2::new(1.0, 2.0),
                Site::new(&FLOOR, (-10.0, 21.0), 1.0, 1.0, carried),
            ),
        };
        Site {
            movers: vec![lift(at, velocity)],
            ..site
        }
    }
}

/// An outline with corners in metres, expanded by the standing hero.
fn grown(outline: &[(i32, i32)]) -> Vec<ExpandedEdge> {
    let corners: Vec<_> = outline
        .iter()
        .map(|&(x, y)| Point::new(x << 16, y << 16))
        .collect();
    expand(&corners, &Collider::hero())
}

/// A platform 30 m long and 1 m thick, its upper left corner drawn at a place, that moves on and on.
fn lift((x, y): (i32, i32), velocity: DVec2) -> Mover {
    let outline = [(x, y - 1), (x + 30, y - 1), (x + 30, y), (x, y)];
    let mesh = Arc::new(Mesh::of(&[(2, Kind::Solid, grown(&outline))]).unwrap());
    let on = Piece {
        v0: velocity,
        ..Piece::default()
    };
    Mover {
        stand: Arc::clone(&mesh),
        crouch: mesh,
        path: Path {
            pieces: vec![on],
            period: None,
        },
        start: Some(0.0),
    }
}

/// The whole golden run through the rules of the game; items are ticks.
#[divan::bench(sample_count = 20)]
fn ticks_of_the_golden_run(bencher: Bencher) {
    let stage = Arc::new(Stage::build(crossing()).unwrap());
    let replay = Replay::parse(include_str!("../tests/golden/crossing.replay.ron")).unwrap();
    bencher
        .counter(ItemsCount::new(replay.ticks()))
        .bench_local(|| replay.run(Arc::clone(&stage)).unwrap().hash());
}

/// A snapshot.
#[divan::bench]
fn clone_a_body(bencher: Bencher) {
    let stage = Stage::build(crossing()).unwrap();
    let tuning = Motion::default();
    let land = stage.land(&Shape::hero()).unwrap();
    let terrain = land.terrain(&stage, &tuning);
    let body = Body::spawn(stage.level.start, 0.0, &terrain).unwrap();
    bencher.bench_local(|| black_box(&body).clone());
}

/// A snapshot of the whole game.
#[divan::bench]
fn clone_a_world(bencher: Bencher) {
    let stage = Arc::new(Stage::build(crossing()).unwrap());
    let replay = Replay::parse(include_str!("../tests/golden/crossing.replay.ron")).unwrap();
    let world = replay.run(stage).unwrap();
    bencher.bench_local(|| black_box(&world).clone());
}

/// All three meshes of the crossing: standing, crouching, outlines.
#[divan::bench(sample_count = 20)]
fn build_the_crossing(bencher: Bencher) {
    bencher
        .with_inputs(crossing)
        .bench_local_values(|level| Stage::build(level).unwrap());
}
