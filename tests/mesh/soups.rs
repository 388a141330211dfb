//! Random soups of segments and polygons: the arrangement and the covers against slow twins, and places.

use crate::common::slow::{self, Spot, spot};
use crate::common::soups::{covers_agree, polygons, segments, small_collider, sound};
use crate::common::worlds::{Dice, wire};
use edgewalker::geom::{BOUND, Collider, ExpandedEdge, Point};
use edgewalker::mesh::{FeatureId, Mesh, Place};
use std::collections::BTreeSet;

/// The vertices without the corners of the world.
fn vertices(mesh: &Mesh) -> BTreeSet<Spot> {
    mesh.vertices()
        .skip(4)
        .map(|v| spot(mesh.point(v)))
        .collect()
}

/// Asserts that the vertices and chains of a mesh of loose segments are those of the slow twin.
fn chains_agree(segments: &[(Point, Point)], story: &dyn std::fmt::Debug) {
    let mesh = Mesh::build(&[wire(segments)]).unwrap();
    sound(&mesh, story);
    let spots: Vec<(Spot, Spot)> = segments.iter().map(|&(a, b)| (spot(a), spot(b))).collect();
    let (hot, chains) = slow::snap(&spots);
    assert_eq!(vertices(&mesh), hot, "{story:?}: {segments:?}");
    for (&s, expected) in mesh.segments_of(0).iter().zip(chains) {
        let chain: Vec<Spot> = mesh.chain(s).iter().map(|&v| spot(mesh.point(v))).collect();
        assert_eq!(chain, expected, "{story:?}: {segments:?}");
    }
}

#[test]
fn chains_are_those_of_the_slow_twin() {
    for seed in 0..100_000 {
        chains_agree(&segments(&mut Dice::new(seed)), &seed);
    }
}

#[test]
fn chains_are_those_of_the_slow_twin_across_many_cells() {
    for seed in 0..10_000 {
        let mut dice = Dice::new(seed);
        // The same soups pulled apart, by a little more or less at each end.
        let mut pull = |p: Point| Point::new(p.x * 613 + dice.below(3), p.y * 613 + dice.below(3));
        let small = segments(&mut Dice::new(seed));
        let pulled: Vec<_> = small.iter().map(|&(a, b)| (pull(a), pull(b))).collect();
        chains_agree(&pulled, &seed);
    }
}

#[test]
fn mirrored_soups_have_mirrored_vertices() {
    for seed in 0..3000 {
        let segments = segments(&mut Dice::new(seed));
        let mirror = |p: Point| Point::new(-p.x, p.y);
        let mirrored: Vec<(Point, Point)> = segments
            .iter()
            .map(|&(a, b)| (mirror(a), mirror(b)))
            .collect();
        let (here, there) = (
            Mesh::build(&[wire(&segments)]).unwrap(),
            Mesh::build(&[wire(&mirrored)]).unwrap(),
        );
        let expected: BTreeSet<Spot> = vertices(&here).into_iter().map(|(x, y)| (-x, y)).collect();
        assert_eq!(vertices(&there), expected, "seed {seed}: {segments:?}");
    }
}

#[test]
fn faces_are_covered_by_the_outlines_around_them() {
    let (mut free, mut solid) = (0, 0);
    for seed in 0..400 {
        let collider = if seed % 2 == 0 {
            small_collider()
        } else {
            Collider::point()
        };
        let features = polygons(&mut Dice::new(2000 + seed), 6, &collider);
        let mut mesh = Mesh::build(&features).unwrap();
        sound(&mesh, &features);
        let counts = covers_agree(&mesh, &features);
        (free, solid) = (free + counts.0, solid + counts.1);
        mesh.remove(seed as FeatureId % 6).unwrap();
        covers_agree(&mesh, &features);
        mesh.insert(seed as FeatureId % 6, &features[seed as usize % 6])
            .unwrap();
        covers_agree(&mesh, &features);
    }
    assert!(
        free > 10_000 && solid > 20_000,
        "{free} free, {solid} solid"
    );
}

/// Whether a spot is further than a distance from a segment.
fn is_far(p: Spot, (a, b): (Spot, Spot), distance: i128) -> bool {
    let square = |v: Spot| v.0 * v.0 + v.1 * v.1;
    let minus = |v: Spot, w: Spot| (v.0 - w.0, v.1 - w.1);
    let (along, to) = (minus(b, a), minus(p, a));
    let ahead = along.0 * to.0 + along.1 * to.1;
    if ahead <= 0 {
        square(to) > distance * distance
    } else if ahead >= square(along) {
        square(minus(p, b)) > distance * distance
    } else {
        slow::turn(a, b, p).pow(2) > distance * distance * square(along)
    }
}

#[test]
fn away_from_the_edges_covers_are_those_of_the_outlines_before_snapping() {
    let mut seen = [0; 2];
    for seed in 0..60 {
        let grown = |p: Point| Point::new(p.x * 37, p.y * 41);
        let mut features = polygons(&mut Dice::new(3000 + seed), 6, &small_collider());
        for e in features.iter_mut().flatten() {
            (e.a, e.b) = (grown(e.a), grown(e.b));
        }
        let mesh = Mesh::build(&features).unwrap();
        let thirds = |p: Point| (3 * i128::from(p.x), 3 * i128::from(p.y));
        let ends = |e: &ExpandedEdge| (thirds(e.a), thirds(e.b));
        let outlines: Vec<Vec<(Spot, Spot)>> = features
            .iter()
            .map(|f| f.iter().map(ends).collect())
            .collect();
        for face in mesh.faces() {
            let corners = mesh.corners(face).map(spot);
            let centre = corners
                .iter()
                .fold((0, 0), |sum, c| (sum.0 + c.0, sum.1 + c.1));
            // One step is three thirds; a chain may be half a step off in x and in y.
            if outlines.iter().flatten().all(|&e| is_far(centre, e, 3)) {
                let winds = |outline: &Vec<(Spot, Spot)>| {
                    let starts: Vec<Spot> = outline.iter().map(|e| e.0).collect();
                    slow::winding(&starts, centre) > 0
                };
                let around: Vec<FeatureId> = (0..)
                    .zip(&outlines)
                    .filter(|(_, o)| winds(o))
                    .map(|o| o.0)
                    .collect();
                assert_eq!(mesh.cover(face), around, "seed {seed}, {corners:?}");
                seen[usize::from(around.is_empty())] += 1;
            }
        }
    }
    assert!(seen.iter().all(|&n| n > 1000), "{seen:?}");
}

#[test]
fn blocking_edges_part_free_from_solid() {
    let features = polygons(&mut Dice::new(77), 8, &small_collider());
    let mesh = Mesh::build(&features).unwrap();
    let mut blocking = 0;
    for e in mesh.edges().flat_map(|e| [e, mesh.sym(e)]) {
        let free = mesh.left(e).is_some_and(|f| !mesh.is_solid(f));
        let shut = mesh.left(mesh.sym(e)).is_none_or(|f| mesh.is_solid(f));
        assert_eq!(mesh.blocks(e), free && shut);
        let outer = mesh.left(mesh.sym(e)).is_none();
        assert!(
            !mesh.blocks(e) || outer || mesh.uses(e).next().is_some(),
            "something runs along every wall"
        );
        blocking += usize::from(mesh.blocks(e));
    }
    assert!(blocking > 20, "{blocking}");
}

#[test]
fn places_are_found_from_anywhere() {
    let features = polygons(&mut Dice::new(8), 12, &small_collider());
    let mesh = Mesh::build(&features).unwrap();
    let faces: Vec<_> = mesh.faces().collect();
    let mut dice = Dice::new(9);
    let metres =
        |p: Spot, scale: i128| glam::DVec2::new(p.0 as f64, p.1 as f64) / scale as f64 / 65536.0;
    for &face in &faces {
        let near = Some(faces[dice.below(faces.len() as u32) as usize]);
        let [a, b, c] = mesh.corners(face).map(spot);
        // A point inside, with dyadic weights, one inside an edge and one at a vertex.
        let inside = (2 * a.0 + b.0 + c.0, 2 * a.1 + b.1 + c.1);
        assert_eq!(
            mesh.locate(metres(inside, 4), near),
            Some(Place::Face(face))
        );
        // The rim of the world is outside.
        let rim = |p: Spot| p.0.abs().max(p.1.abs()) == i128::from(BOUND - 1);
        match mesh.locate(metres((a.0 + b.0, a.1 + b.1), 2), near) {
            Some(Place::Edge(e)) => {
                let ends = [mesh.origin(e), mesh.dest(e)].map(|v| spot(mesh.point(v)));
                assert!(ends == [a, b] || ends == [b, a]);
            }
            other => assert!(
                other.is_none() && rim(a) && rim(b),
                "{other:?} is not on the edge"
            ),
        }
        match mesh.locate(metres(c, 1), near) {
            Some(Place::Vertex(v)) => assert_eq!(spot(mesh.point(v)), c),
            other => assert!(other.is_none() && rim(c), "{other:?} is not the vertex"),
        }
    }
    for outside in [4096.0, -1e300, f64::INFINITY, f64::NAN] {
        assert_eq!(mesh.locate(glam::DVec2::new(0.0, outside), None), None);
        assert_eq!(mesh.locate(glam::DVec2::new(outside, 0.0), None), None);
    }
}
