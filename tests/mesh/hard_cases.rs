//! The scenes of HARD_CASES.md that are about the mesh alone: 19, 21 and 66.

use crate::common::checker;
use crate::common::soups::{polygons, small_collider, sound};
use crate::common::worlds::{self, Dice, wire};
use edgewalker::geom::{
    BOUND, Collider, ExpandedEdge, OutlineError, Point, Source, check_outline, expand,
};
use edgewalker::mesh::{Mesh, MeshError};

fn outline(corners: &[(i32, i32)]) -> Vec<Point> {
    corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
}

/// The same edges, with other numbers for the edges and corners of their outline.
fn renamed(
    edges: &[ExpandedEdge],
    of_edge: impl Fn(u32) -> u32,
    of_corner: impl Fn(u32) -> u32,
) -> Vec<ExpandedEdge> {
    let rename = |e: &ExpandedEdge| {
        let source = match e.source {
            Source::Edge { edge } => Source::Edge {
                edge: of_edge(edge),
            },
            Source::Corner { vertex, side } => Source::Corner {
                vertex: of_corner(vertex),
                side,
            },
        };
        ExpandedEdge { source, ..*e }
    };
    edges.iter().map(rename).collect()
}

#[test]
fn scene_19_bad_outlines_are_typed_errors() {
    let bow_tie = outline(&[(0, 0), (4, 4), (4, 0), (0, 4)]);
    assert_eq!(
        check_outline(&bow_tie),
        Err(OutlineError::Meet {
            first: 0,
            second: 2
        })
    );
    let doubled = outline(&[(0, 0), (4, 0), (4, 0), (0, 4)]);
    assert_eq!(
        check_outline(&doubled),
        Err(OutlineError::ZeroLength { edge: 1 })
    );
    let spike = outline(&[(0, 0), (8, 0), (8, 8), (12, 8), (8, 8), (0, 8)]);
    assert_eq!(
        check_outline(&spike),
        Err(OutlineError::Spike { corner: 3 })
    );
    let there_and_back = outline(&[(0, 0), (8, 0), (0, 0)]);
    assert!(check_outline(&there_and_back).is_err());
    // The mesh has a door of its own.
    let point = Point::new(3, 3);
    let error = Mesh::build(&[wire(&[(point, point)])]).unwrap_err();
    assert_eq!(
        error,
        MeshError::ZeroLength {
            feature: 0,
            edge: 0
        }
    );
}

#[test]
fn scene_19_a_clockwise_ring_is_the_ring() {
    let mut dice = Dice::new(19);
    let mut rings = 0;
    for _ in 0..300 {
        let n = 3 + dice.below(5) as u32;
        let ring: Vec<Point> = (0..n).map(|_| dice.point(12)).collect();
        if check_outline(&ring).is_err() {
            continue;
        }
        let reversed: Vec<Point> = ring.iter().rev().copied().collect();
        for collider in [Collider::point(), small_collider()] {
            // What was edge i, from corner i, starts at corner n - 2 - i now.
            let back = renamed(
                &expand(&reversed, &collider),
                |i| (2 * n - 2 - i) % n,
                |i| n - 1 - i,
            );
            let (here, there) = (
                Mesh::build(&[expand(&ring, &collider)]).unwrap(),
                Mesh::build(&[back]).unwrap(),
            );
            assert_eq!(here.hash(), there.hash(), "{ring:?}");
        }
        rings += 1;
    }
    assert!(rings > 50, "{rings}");
}

#[test]
fn scene_19_whatever_passes_the_door_makes_a_sound_mesh() {
    let mut dice = Dice::new(190);
    let mut passed = 0;
    for seed in 0..3000 {
        // Few places for many corners: most outlines touch, double or cross themselves.
        let ring: Vec<Point> = (0..3 + dice.below(5)).map(|_| dice.point(5)).collect();
        if check_outline(&ring).is_ok() {
            let mesh = Mesh::build(&[expand(&ring, &small_collider())]).unwrap();
            checker::check(&mesh).unwrap_or_else(|wrong| panic!("{seed}: {wrong}: {ring:?}"));
            passed += 1;
        }
    }
    assert!((300..2500).contains(&passed), "{passed} of 3000");
}

#[test]
fn scene_21_edges_that_cross_at_two_billionths_of_a_radian() {
    let end = BOUND - 2;
    // Each rises by a step or two over the width of the world, up or down.
    let lines = [
        (0, 1),
        (1, 0),
        (0, 2),
        (2, 0),
        (1, 2),
        (2, 1),
        (0, 0),
        (1, 1),
    ];
    let features: Vec<_> = lines
        .iter()
        .map(|&(left, right)| wire(&[(Point::new(-end, left), Point::new(end, right))]))
        .collect();
    let mut mesh = Mesh::build(&features).unwrap();
    checker::check(&mesh).unwrap();
    let hash = mesh.hash();
    for id in 0..lines.len() as u32 {
        mesh.remove(id).unwrap();
        checker::check(&mesh).unwrap();
        mesh.insert(id, &features[id as usize]).unwrap();
        assert_eq!(mesh.hash(), hash, "without {id} and with it again");
    }
    // A million metres away is beyond the world, and said to be.
    let far = wire(&[(Point::new(0, 0), Point::new(i32::MAX, 1))]);
    let error = mesh.insert(99, &far).unwrap_err();
    assert_eq!(
        error,
        MeshError::OutOfBounds {
            feature: 99,
            edge: 0
        }
    );
}

#[test]
fn scene_21_ten_thousand_corners_in_a_spot() {
    // A billionth of a metre is less than a step, so the spot is the size of 40 steps, with every grid point in it
    // a corner of many triangles.
    let mut dice = Dice::new(21);
    let mut features = Vec::new();
    while features.len() < 3400 {
        let corners: Vec<Point> = (0..3).map(|_| dice.point(41)).collect();
        if check_outline(&corners).is_ok() {
            features.push(expand(&corners, &Collider::point()));
        }
    }
    let mut mesh = Mesh::build(&features).unwrap();
    let census = checker::check(&mesh).unwrap();
    assert_eq!(
        census.vertices,
        41 * 41 + 4,
        "all of the spot, and the corners of the world"
    );
    let hash = mesh.hash();
    mesh.remove(1700).unwrap();
    mesh.insert(1700, &features[1700]).unwrap();
    assert_eq!(mesh.hash(), hash);
}

#[test]
fn scene_66_a_hundred_orders_and_starts_give_one_hash() {
    for seed in 0..4 {
        let mut dice = Dice::new(660 + seed);
        let features = if seed % 2 == 0 {
            polygons(&mut dice, 12, &small_collider())
        } else {
            worlds::expanded(
                &worlds::snapped(&worlds::slopes(&mut dice, 12)),
                &Collider::hero(),
            )
        };
        let built = Mesh::build(&features).unwrap();
        sound(&built, &seed);
        for _ in 0..100 {
            let mut order: Vec<usize> = (0..features.len()).collect();
            for i in (1..order.len()).rev() {
                order.swap(i, dice.below(i as u32 + 1) as usize);
            }
            let mut mesh = Mesh::build(&[]).unwrap();
            for i in order {
                // The chain of edges starts anywhere.
                let mut edges = features[i].clone();
                let start = dice.below(edges.len() as u32) as usize;
                edges.rotate_left(start);
                mesh.insert(i as u32, &edges).unwrap();
            }
            assert_eq!(mesh.hash(), built.hash(), "seed {seed}");
        }
    }
}

#[test]
fn scene_66_an_outline_may_start_at_any_corner() {
    let corners = [(0, 0), (30, 0), (34, 9), (20, 20), (21, 11), (5, 12)];
    let ring = outline(&corners);
    assert_eq!(check_outline(&ring), Ok(()));
    let n = ring.len() as u32;
    let whole = Mesh::build(&[expand(&ring, &small_collider())])
        .unwrap()
        .hash();
    for k in 0..n {
        let mut turned = ring.clone();
        turned.rotate_left(k as usize);
        let back = |i: u32| (i + k) % n;
        let edges = renamed(&expand(&turned, &small_collider()), back, back);
        assert_eq!(
            Mesh::build(&[edges]).unwrap().hash(),
            whole,
            "from corner {k}"
        );
    }
}
