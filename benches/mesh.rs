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

/// 1e4 overlapping octagons of radius 0.5 to 4: about 112 thousand vertices with the crossings.
fn features() -> Vec<Vec<ExpandedEdge>> {
    let world = worlds::octagons(&mut Dice::new(1), 10_000);
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
    let half = worlds::octagons_half_width(10_000);
    let mut sweeps = Vec::new();
    let mut edges = 0;
    for _ in 0..32 {
        let p = DVec2::new(
            dice.between(-half, half) * 0.6,
            dice.between(-half, half) * 0.6,
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

/// A mesh of about 11 vertices for each of some octagons, and others to put in, all over it.
fn crowd(octagons: usize) -> (Mesh, Vec<Vec<ExpandedEdge>>) {
    let mut dice = Dice::new(5);
    let world = worlds::octagons(&mut dice, octagons);
    let half = worlds::octagons_half_width(octagons) * 0.8;
    let others: Vec<_> = (0..512).map(|_| worlds::octagon(&mut dice, half)).collect();
    let [world, others] = [world, others]
        .map(|outlines| worlds::expanded(&worlds::snapped(&outlines), &Collider::point()));
    (Mesh::build(&world).unwrap(), others)
}

/// Numbers of octagons that make meshes of 1e3, 1e4 and 1e5 vertices.
const CROWDS: [usize; 3] = [90, 900, 9000];

/// Inserts one platform of 8 vertices somewhere; its removal is not counted.
#[divan::bench(args = CROWDS)]
fn insert_a_platform(bencher: Bencher, octagons: usize) {
    let (mesh, others) = crowd(octagons);
    let (mesh, mut i) = (std::cell::RefCell::new(mesh), 0);
    bencher
        .with_inputs(|| {
            // All but the first time, take out what went in the time before.
            let _ = mesh.borrow_mut().remove(PLATFORM);
            i = (i + 1) % others.len();
            &others[i]
        })
        .bench_local_values(|edges| mesh.borrow_mut().insert(PLATFORM, edges).unwrap());
}

/// Removes one platform of 8 vertices; its insertion is not counted.
#[divan::bench(args = CROWDS)]
fn remove_a_platform(bencher: Bencher, octagons: usize) {
    let (mesh, others) = crowd(octagons);
    let (mesh, mut i) = (std::cell::RefCell::new(mesh), 0);
    bencher
        .with_inputs(|| {
            i = (i + 1) % others.len();
            mesh.borrow_mut().insert(PLATFORM, &others[i]).unwrap();
        })
        .bench_local_values(|()| mesh.borrow_mut().remove(PLATFORM).unwrap());
}

/// An id that no other feature has.
const PLATFORM: u32 = 1 << 20;
