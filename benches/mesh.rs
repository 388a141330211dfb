//! The mesh against the clock: building, walking, editing. `cargo bench --no-default-features --bench mesh`.

#[path = "../tests/common/worlds.rs"]
mod worlds;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use edgewalker::geom::predicates::crosses;
use edgewalker::geom::{Collider, ExpandedEdge, Point};
use edgewalker::mesh::{FaceId, Mesh, Place};
use glam::DVec2;
use worlds::Dice;

fn main() {
    let mesh = Mesh::build(&features()).unwrap();
    println!(
        "1e4 octagons: {} vertices, {} edges, {} faces",
        mesh.vertices().count(),
        mesh.edges().count(),
        mesh.faces().count()
    );
    divan::main();
}

/// Half-width of the square that the polygons lie in, in metres.
const HALF: f64 = 195.0;

/// 1e4 overlapping octagons of radius 0.5 to 4: about 112 thousand vertices with the crossings.
fn features() -> Vec<Vec<ExpandedEdge>> {
    let mut dice = Dice::new(1);
    let mut polygon = || {
        let centre = DVec2::new(dice.between(-HALF, HALF), dice.between(-HALF, HALF));
        let radius = dice.between(0.5, 4.0);
        worlds::star(&mut dice, centre, 8, radius * 0.8, radius)
    };
    let world: Vec<_> = (0..10_000).map(|_| polygon()).collect();
    worlds::expanded(&worlds::snapped(&world), &Collider::point())
}

#[divan::bench(sample_count = 20)]
fn build_10_000_polygons(bencher: Bencher) {
    let features = features();
    bencher.bench_local(|| Mesh::build(black_box(&features)).unwrap());
}

#[divan::bench(sample_count = 20)]
fn build_250_slopes_for_the_hero(bencher: Bencher) {
    let world = worlds::slopes(&mut Dice::new(2), 250);
    let features = worlds::expanded(&worlds::snapped(&world), &Collider::hero());
    bencher.bench_local(|| Mesh::build(black_box(&features)).unwrap());
}

/// A random walk of 10 cm steps, each located from the face of the one before.
#[divan::bench]
fn locate_near(bencher: Bencher) {
    let mesh = Mesh::build(&features()).unwrap();
    let mut dice = Dice::new(3);
    let mut at = DVec2::ZERO;
    let mut near: Option<FaceId> = None;
    bencher.bench_local(|| {
        at += DVec2::new(dice.between(-0.1, 0.1), dice.between(-0.1, 0.1));
        if let Some(Place::Face(face)) = mesh.locate(at, near) {
            near = Some(face);
        }
        near
    });
}

/// Straight sweeps of 100 m; an item is an edge crossed.
#[divan::bench]
fn sweep_edges(bencher: Bencher) {
    let mesh = Mesh::build(&features()).unwrap();
    let mut dice = Dice::new(4);
    let mut sweeps = Vec::new();
    let mut edges = 0;
    for _ in 0..32 {
        let p = DVec2::new(
            dice.between(-HALF, HALF) * 0.6,
            dice.between(-HALF, HALF) * 0.6,
        );
        let Some(Place::Face(face)) = mesh.locate(p, None) else {
            continue;
        };
        let start = mesh.point(mesh.origin(mesh.sides(face)[0]));
        let end =
            start.metres() + DVec2::from_angle(dice.between(0.0, std::f64::consts::TAU)) * 100.0;
        let end = Point::snap(end).unwrap();
        let ends = |e| (mesh.point(mesh.origin(e)), mesh.point(mesh.dest(e)));
        edges += mesh
            .edges()
            .map(ends)
            .filter(|&(a, b)| crosses(a, b, start, end))
            .count();
        sweeps.push((face, end.metres()));
    }
    bencher.counter(ItemsCount::new(edges)).bench_local(|| {
        for &(face, end) in &sweeps {
            black_box(mesh.locate(black_box(end), Some(face)));
        }
    });
}

/// Moves one octagon about among 1000: a removal and an insertion.
#[divan::bench]
fn move_one_among_1000(bencher: Bencher) {
    let features = features();
    let mut mesh = Mesh::build(&features[..1000]).unwrap();
    let mut next = 1000;
    bencher.bench_local(|| {
        mesh.remove(0).unwrap();
        mesh.insert(0, &features[next]).unwrap();
        next = if next == 1999 { 1000 } else { next + 1 };
    });
}
