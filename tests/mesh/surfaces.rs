//! Surfaces: which edges they have, how they are joined, and that their neighbours span all free space.

use crate::common::worlds::{self, Dice};
use edgewalker::geom::{Collider, Point, expand, expand_one_way};
use edgewalker::mesh::{EdgeId, FaceId, Kind, Mesh, Segment, Surfaces};
use std::collections::{BTreeMap, BTreeSet};

/// Ground of at most 45 degrees.
fn walkable(s: &Segment) -> bool {
    s.b.x < s.a.x && s.a.y.abs_diff(s.b.y) <= s.a.x.abs_diff(s.b.x)
}

/// The ends of each chain as points, from left to right.
fn spans(mesh: &Mesh, surfaces: &Surfaces) -> Vec<[(i32, i32); 2]> {
    let flat = |p: Point| (p.x, p.y);
    let span = |s: &edgewalker::mesh::Surface| [s.start, s.end].map(|v| flat(mesh.point(v)));
    surfaces.list.iter().map(span).collect()
}

/// A box of grid points.
fn boxed(x: [i32; 2], y: [i32; 2]) -> Vec<edgewalker::geom::ExpandedEdge> {
    let corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])];
    expand(&corners.map(|(x, y)| Point::new(x, y)), &Collider::point())
}

#[test]
fn a_floor_with_a_block_a_lip_and_a_platform_has_four_surfaces() {
    let one_way = [Point::new(20, 60), Point::new(70, 60)];
    let mesh = Mesh::of(&[
        (0, Kind::Solid, boxed([0, 100], [0, 10])),
        (1, Kind::Solid, boxed([40, 50], [5, 30])),
        // Two boxes that continue the floor: one flush, one a step higher.
        (2, Kind::Solid, boxed([100, 150], [0, 10])),
        (3, Kind::Solid, boxed([150, 200], [0, 11])),
        (
            4,
            Kind::OneWay,
            expand_one_way(&one_way, &Collider::point()),
        ),
        (5, Kind::Region, boxed([10, 30], [5, 40])),
    ])
    .unwrap();
    let surfaces = mesh.surfaces(2, walkable);
    let expected = [
        [(0, 10), (40, 10)],
        [(20, 60), (70, 60)],
        [(40, 30), (50, 30)],
        [(50, 10), (150, 10)],
        [(150, 11), (200, 11)],
    ];
    assert_eq!(spans(&mesh, &surfaces), expected);
    assert_eq!(
        surfaces.joints,
        [(3, 4)],
        "over a lip of one step, and not the other way"
    );
    assert_eq!(mesh.surfaces(0, walkable).joints, []);
    let features = |i: usize| -> Vec<u32> {
        let segments = surfaces.list[i].segments.iter();
        segments.map(|&s| mesh.segment(s).feature).collect()
    };
    assert_eq!(
        (features(0), features(1), features(3)),
        (vec![0], vec![4], vec![0, 2])
    );
    assert!(surfaces.beside.contains(&(0, 1)) && surfaces.beside.contains(&(1, 2)));
    assert!(
        !surfaces.beside.contains(&(0, 4)),
        "the block and the platform are between"
    );
}

#[test]
fn a_chain_may_close() {
    let mesh = Mesh::build(&[boxed([0, 10], [0, 10])]).unwrap();
    let surfaces = mesh.surfaces(2, |_| true);
    assert_eq!(surfaces.list.len(), 1);
    let ring = &surfaces.list[0];
    assert_eq!(
        (ring.edges.len(), ring.segments.len(), ring.start),
        (4, 4, ring.end)
    );
}

/// The connected parts of a graph: for each node, the smallest one that it is connected with.
fn parts<T: Copy + Ord>(nodes: &[T], links: &[(T, T)]) -> BTreeMap<T, T> {
    let mut part: BTreeMap<T, T> = nodes.iter().map(|&n| (n, n)).collect();
    loop {
        let mut changed = false;
        for (a, b) in links {
            let least = part[a].min(part[b]);
            for n in [a, b] {
                changed |= part[n] != least;
                part.insert(*n, least);
            }
        }
        if !changed {
            return part;
        }
    }
}

/// Asserts what holds of the surfaces of any mesh.
fn surfaces_agree(mesh: &Mesh, story: &dyn std::fmt::Debug) -> usize {
    let surfaces = mesh.surfaces(2, walkable);
    // Each edge of ground is in one chain.
    let edges: Vec<EdgeId> = surfaces.list.iter().flat_map(|s| s.edges.clone()).collect();
    let found: BTreeSet<EdgeId> = edges.iter().copied().collect();
    assert_eq!(found.len(), edges.len(), "{story:?}");
    let is_ground =
        |&e: &EdgeId| mesh.blocks(e) && mesh.walls(e).any(|s| walkable(mesh.segment(s)));
    let both = mesh.edges().flat_map(|e| [e, mesh.sym(e)]);
    assert_eq!(found, both.filter(is_ground).collect(), "{story:?}");
    for (i, surface) in surfaces.list.iter().enumerate() {
        for pair in surface.edges.windows(2) {
            assert_eq!(mesh.dest(pair[0]), mesh.origin(pair[1]), "{story:?}");
        }
        let grounds = |&s: &_| surface.edges.iter().any(|&e| mesh.walls(e).any(|w| w == s));
        assert!(!surface.segments.is_empty() && surface.segments.iter().all(grounds));
        // No two chains could be one: where another one starts at an end, a wall or a solid is between.
        let end = *surface.edges.last().unwrap();
        let mut next = mesh.lnext(end);
        while !mesh.blocks(next) {
            next = mesh.lnext(mesh.sym(next));
        }
        assert!(
            !found.contains(&next) || surface.start == surface.end,
            "{story:?}: chain {i} goes on"
        );
    }
    // Two chains are connected by neighbours iff free space connects them.
    let free: Vec<FaceId> = mesh.faces().filter(|&f| !mesh.is_solid(f)).collect();
    let doors = |&f: &FaceId| {
        mesh.free_neighbours(f)
            .map(move |(_, g)| (f, g))
            .collect::<Vec<_>>()
    };
    let space = parts(&free, &free.iter().flat_map(doors).collect::<Vec<_>>());
    let nodes: Vec<usize> = (0..surfaces.list.len()).collect();
    let graph = parts(&nodes, &surfaces.beside);
    let place = |i: usize| space[&mesh.left(surfaces.list[i].edges[0]).unwrap()];
    for &i in &nodes {
        for &j in &nodes[..i] {
            assert_eq!(
                graph[&i] == graph[&j],
                place(i) == place(j),
                "{story:?}: {i} and {j}"
            );
        }
    }
    nodes.len()
}

#[test]
fn surfaces_of_all_families_have_all_ground_and_span_free_space() {
    let mut count = 0;
    for (name, family) in worlds::families() {
        for seed in 0..20 {
            let outlines = worlds::snapped(&family(&mut Dice::new(seed), 30));
            let features = worlds::expanded(&outlines, &Collider::hero_crouched());
            let mesh = Mesh::build(&features).unwrap();
            count += surfaces_agree(&mesh, &(name, seed));
            // The same chains, whatever the history of the mesh.
            let mut edited = Mesh::build(&[]).unwrap();
            for (id, edges) in features.iter().enumerate().rev() {
                edited.insert(id as u32, edges).unwrap();
            }
            let (here, there) = (mesh.surfaces(2, walkable), edited.surfaces(2, walkable));
            assert_eq!(spans(&mesh, &here), spans(&edited, &there));
            assert_eq!(
                (here.joints, here.beside),
                (there.joints, there.beside),
                "{name} {seed}"
            );
        }
    }
    assert!(count > 500, "{count} chains");
}
