//! Robustness in bulk, by the checker that shares no code with the mesh. Here in small numbers; by hand in large ones:
//!
//! ```text
//! MESH_WORLDS=100 MESH_POLYGONS=100000 MESH_TERRAIN=1000000 cargo test --release --no-default-features --test mesh scale::
//! ```

use crate::common::checker;
use crate::common::worlds::{self, Dice, setting, wire};
use edgewalker::geom::{Collider, ExpandedEdge, Point, check_outline, expand};
use edgewalker::mesh::Mesh;
use glam::DVec2;

/// Asserts that a mesh is right, and says how large it is.
fn right(mesh: &Mesh, story: &dyn std::fmt::Debug) -> checker::Census {
    match checker::check(mesh) {
        Ok(census) => census,
        Err(wrong) => panic!("{story:?}: {wrong}"),
    }
}

/// Takes a feature out and puts it back; nothing may remain of that.
fn out_and_in(mesh: &mut Mesh, id: u32, edges: &[ExpandedEdge], story: &dyn std::fmt::Debug) {
    let hash = mesh.hash();
    mesh.remove(id).unwrap();
    right(mesh, story);
    mesh.insert(id, edges).unwrap();
    assert_eq!(mesh.hash(), hash, "{story:?}");
}

/// The collider that a family is expanded by.
fn collider(name: &str) -> Collider {
    match name {
        "slopes" => worlds::centred_box(0.4, 0.8),
        "grid" => Collider::hero_crouched(),
        _ => Collider::hero(),
    }
}

#[test]
fn every_family_at_every_offset_and_rotation() {
    let worlds = setting("MESH_WORLDS", 1);
    let mut meshes = 0;
    for (name, family) in worlds::families() {
        for seed in 0..worlds as u64 {
            let world = family(&mut Dice::new(seed), 20);
            for x in [0.0, 1.0 / 3.0, 10.0, 100.0, 300.0, 1000.0] {
                for turn in 0..50 {
                    let angle = f64::from(turn) * std::f64::consts::TAU / 50.0;
                    let placed = worlds::placed(&world, DVec2::new(x, x / 2.0), angle);
                    let outlines = worlds::snapped(&placed);
                    let features = worlds::expanded(&outlines, &collider(name));
                    let mut mesh = Mesh::build(&features).unwrap();
                    let story = (name, seed, x, turn);
                    right(&mesh, &story);
                    if turn % 10 == 0 {
                        let id = features.len() / 2;
                        out_and_in(&mut mesh, id as u32, &features[id], &story);
                    }
                    meshes += 1;
                }
            }
        }
    }
    println!("{meshes} meshes of 4 families at 6 offsets and 50 rotations, all right");
}

#[test]
fn fans_of_hundreds_of_edges_at_one_vertex() {
    // Spikes around one vertex that all of them share, and lines through it.
    let hub = Point::new(1000, -500);
    let rim = |i: i32, n: i32, radius: f64| {
        let angle = f64::from(i) * std::f64::consts::TAU / f64::from(n);
        let p = DVec2::from_angle(angle) * radius;
        Point::new(hub.x + p.x as i32, hub.y + p.y as i32)
    };
    for n in [60, 300, 900] {
        let mut features = Vec::new();
        for i in 0..n {
            let (near, far) = (rim(3 * i, 3 * n, 2e6), rim(3 * i + 2, 3 * n, 3e6));
            features.push(expand(&[hub, near, far], &Collider::point()));
        }
        for i in 0..n / 10 {
            features.push(wire(&[(rim(i, n, 4e6), rim(i + n / 2, n, 4e6))]));
        }
        let mut mesh = Mesh::build(&features).unwrap();
        let census = right(&mesh, &n);
        assert!(census.pieces > 3 * n as usize);
        for id in [0, n / 2, n + 1] {
            out_and_in(&mut mesh, id as u32, &features[id as usize], &(n, id));
        }
    }
}

#[test]
fn a_star_of_a_thousand_spikes() {
    let corner = |i: i32| {
        let radius = if i % 2 == 0 { 3e6 } else { 1e6 };
        let p = DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 2000.0) * radius;
        Point::new(p.x as i32, p.y as i32)
    };
    let star: Vec<Point> = (0..2000).map(corner).collect();
    assert_eq!(check_outline(&star), Ok(()));
    let features = [
        expand(&star, &Collider::hero()),
        expand(&star, &Collider::point()),
    ];
    let mut mesh = Mesh::build(&features).unwrap();
    let census = right(&mesh, &"star");
    assert!(census.vertices > 10_000, "{census:?}");
    out_and_in(&mut mesh, 0, &features[0], &"star");
}

#[test]
fn crowds_of_overlapping_polygons() {
    let n = setting("MESH_POLYGONS", 3000);
    let world = worlds::octagons(&mut Dice::new(7), n);
    let features = worlds::expanded(&worlds::snapped(&world), &Collider::point());
    let mut mesh = Mesh::build(&features).unwrap();
    let census = right(&mesh, &n);
    println!("{n} overlapping polygons: {census:?}");
    assert!(census.edges > 25 * n, "{census:?}");
    out_and_in(&mut mesh, 5, &features[5], &n);
}

#[test]
fn a_long_terrain() {
    let n = setting("MESH_TERRAIN", 20_000) as i32;
    let mut dice = Dice::new(8);
    // As much of the world as there is, in steps of a millimetre or more.
    let pitch = (500_000_000 / n).min(30_000);
    let x = |i: i32| (i - n / 2) * pitch;
    let mut outline = vec![
        Point::new(x(0), -9_000_000),
        Point::new(x(n - 1), -9_000_000),
    ];
    let mut y = 0;
    for i in (0..n).rev() {
        y = (y + dice.below(2 * pitch as u32 + 1) - pitch).clamp(-8_000_000, 8_000_000);
        outline.push(Point::new(x(i), y));
    }
    assert_eq!(check_outline(&outline), Ok(()));
    let features = [expand(&outline, &Collider::hero())];
    let edges = features[0].len();
    let mut mesh = Mesh::build(&features).unwrap();
    let census = right(&mesh, &n);
    println!("a terrain of {n} corners, {edges} expanded edges: {census:?}");
    assert!(edges > n as usize);
    let block = worlds::snapped(&[vec![
        DVec2::new(-2.0, -200.0),
        DVec2::new(2.0, -200.0),
        DVec2::new(2.0, 200.0),
        DVec2::new(-2.0, 200.0),
    ]]);
    let hash = mesh.hash();
    mesh.insert(1, &expand(&block[0], &Collider::hero()))
        .unwrap();
    right(&mesh, &"terrain with a block");
    mesh.remove(1).unwrap();
    assert_eq!(mesh.hash(), hash);
}
