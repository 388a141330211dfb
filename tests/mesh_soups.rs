//! Random soups of segments and polygons: the arrangement and the covers against slow twins, every invariant,
//! and one mesh for one set, whatever the order of edits.

mod common;

use common::slow::{self, Spot, spot};
use common::worlds::{Dice, wire};
use edgewalker::geom::{BOUND, Collider, ExpandedEdge, Point, check_outline, expand};
use edgewalker::mesh::{FeatureId, Mesh, Place};
use std::collections::BTreeSet;

/// A segment of some length with small coordinates around x = 0, where pixels change their borders.
fn segment(dice: &mut Dice) -> (Point, Point) {
    loop {
        let (a, b) = (dice.point(13), dice.point(13));
        if a != b {
            return (Point::new(a.x - 6, a.y), Point::new(b.x - 6, b.y));
        }
    }
}

/// 3 to 7 loose segments.
fn segments(dice: &mut Dice) -> Vec<(Point, Point)> {
    (0..3 + dice.below(5)).map(|_| segment(dice)).collect()
}

/// Some small simple polygons that overlap, expanded by a small collider.
fn polygons(dice: &mut Dice, n: usize, collider: &Collider) -> Vec<Vec<ExpandedEdge>> {
    let mut features = Vec::new();
    while features.len() < n {
        let at = dice.point(24);
        let corner = |p: Point| Point::new(at.x + p.x - 16, at.y + p.y);
        let outline: Vec<Point> = (0..3 + dice.below(4))
            .map(|_| corner(dice.point(16)))
            .collect();
        if check_outline(&outline).is_ok() {
            features.push(expand(&outline, collider));
        }
    }
    features
}

fn small_collider() -> Collider {
    Collider::new(
        [(-1, 0), (1, 0), (2, 1), (2, 3), (-2, 3), (-2, 1)]
            .map(|(x, y)| Point::new(x, y))
            .to_vec(),
    )
    .unwrap()
}

/// Asserts all invariants.
fn sound(mesh: &Mesh, story: &dyn std::fmt::Debug) {
    if let Err(wrong) = mesh.check() {
        panic!("{wrong}\n{story:?}");
    }
}

/// The vertices without the corners of the world.
fn vertices(mesh: &Mesh) -> BTreeSet<Spot> {
    mesh.vertices()
        .skip(4)
        .map(|v| spot(mesh.point(v)))
        .collect()
}

/// A mesh made by inserting features in a given order.
fn inserted(features: &[Vec<ExpandedEdge>], order: &[usize]) -> Mesh {
    let mut mesh = Mesh::build(&[]).unwrap();
    for &i in order {
        mesh.insert(i as FeatureId, &features[i]).unwrap();
    }
    mesh
}

#[test]
fn chains_are_those_of_the_slow_twin() {
    for seed in 0..100_000 {
        let segments = segments(&mut Dice::new(seed));
        let mesh = Mesh::build(&[wire(&segments)]).unwrap();
        sound(&mesh, &segments);
        let spots: Vec<(Spot, Spot)> = segments.iter().map(|&(a, b)| (spot(a), spot(b))).collect();
        let (hot, chains) = slow::snap(&spots);
        assert_eq!(vertices(&mesh), hot, "seed {seed}: {segments:?}");
        for (&s, expected) in mesh.segments_of(0).iter().zip(chains) {
            let chain: Vec<Spot> = mesh.chain(s).iter().map(|&v| spot(mesh.point(v))).collect();
            assert_eq!(chain, expected, "seed {seed}: {segments:?}");
        }
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

/// All orders of the numbers below n.
fn permutations(n: usize) -> Vec<Vec<usize>> {
    if n == 0 {
        return vec![Vec::new()];
    }
    let shorter = permutations(n - 1);
    let with = |order: &Vec<usize>| {
        (0..n)
            .map(|at| [&order[..at], &[n - 1], &order[at..]].concat())
            .collect::<Vec<_>>()
    };
    shorter.iter().flat_map(with).collect()
}

#[test]
fn all_orders_of_five_segments_give_one_mesh() {
    let orders = permutations(5);
    assert_eq!(orders.len(), 120);
    for seed in 0..40 {
        let mut dice = Dice::new(seed);
        let features: Vec<_> = (0..5).map(|_| wire(&[segment(&mut dice)])).collect();
        let hash = Mesh::build(&features).unwrap().hash();
        for order in &orders {
            let mesh = inserted(&features, order);
            assert_eq!(
                mesh.hash(),
                hash,
                "seed {seed}, order {order:?}: {features:?}"
            );
        }
    }
}

#[test]
fn all_orders_of_five_polygons_give_one_mesh() {
    for seed in 0..12 {
        let features = polygons(&mut Dice::new(seed), 5, &small_collider());
        let built = Mesh::build(&features).unwrap();
        sound(&built, &features);
        for order in permutations(5) {
            let mesh = inserted(&features, &order);
            assert_eq!(mesh.hash(), built.hash(), "seed {seed}, order {order:?}");
        }
    }
}

#[test]
fn edits_in_any_order_equal_a_rebuild() {
    for seed in 0..60 {
        let mut dice = Dice::new(1000 + seed);
        let features = polygons(&mut dice, 8, &small_collider());
        let mut mesh = Mesh::build(&features).unwrap();
        let mut present: BTreeSet<usize> = (0..8).collect();
        for step in 0..24 {
            let i = dice.below(8) as usize;
            if present.remove(&i) {
                mesh.remove(i as FeatureId).unwrap();
            } else {
                present.insert(i);
                mesh.insert(i as FeatureId, &features[i]).unwrap();
            }
            sound(&mesh, &(seed, step));
            let order: Vec<usize> = present.iter().rev().copied().collect();
            assert_eq!(
                mesh.hash(),
                inserted(&features, &order).hash(),
                "seed {seed}, step {step}"
            );
        }
        for i in present {
            mesh.remove(i as FeatureId).unwrap();
        }
        assert_eq!(
            mesh.hash(),
            Mesh::build(&[]).unwrap().hash(),
            "seed {seed}: something remains"
        );
    }
}

/// The outline of a feature after snapping, in thirds of a step.
fn snapped_outline(mesh: &Mesh, feature: FeatureId) -> Vec<Spot> {
    let chains = mesh.segments_of(feature).iter().map(|&s| mesh.chain(s));
    let starts = chains.flat_map(|chain| &chain[..chain.len() - 1]);
    starts
        .map(|&v| spot(mesh.point(v)))
        .map(|(x, y)| (3 * x, 3 * y))
        .collect()
}

/// Asserts that a face is covered exactly by the features whose snapped outline winds around its centre.
fn covers_agree(mesh: &Mesh, story: &dyn std::fmt::Debug) -> (usize, usize) {
    let outlines: Vec<_> = mesh
        .features()
        .map(|f| (f, snapped_outline(mesh, f)))
        .collect();
    let mut counts = (0, 0);
    for face in mesh.faces() {
        let corners = mesh.corners(face).map(spot);
        // Three times the centre, in thirds of a step, is the sum of the corners.
        let centre = corners
            .iter()
            .fold((0, 0), |sum, c| (sum.0 + c.0, sum.1 + c.1));
        let around: Vec<FeatureId> = outlines
            .iter()
            .filter(|(_, o)| slow::winding(o, centre) > 0)
            .map(|o| o.0)
            .collect();
        assert_eq!(mesh.cover(face), around, "{face:?} {corners:?}\n{story:?}");
        assert_eq!(mesh.is_solid(face), !around.is_empty());
        if around.is_empty() {
            counts.0 += 1
        } else {
            counts.1 += 1
        }
    }
    counts
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
fn a_fan_of_300_can_be_cut_and_mended() {
    // All through one pixel, none through its middle, with ends far away.
    let spoke = |i: i32| {
        (
            Point::new(-30_000 + 200 * i, -30_011),
            Point::new(30_013 - 200 * i, 30_000 + i % 7),
        )
    };
    let fan: Vec<Vec<ExpandedEdge>> = (0..300).map(|i| wire(&[spoke(i)])).collect();
    let before = Mesh::build(&fan).unwrap();
    sound(&before, &"fan");
    let mut mesh = before.clone();
    let cut = wire(&[
        (Point::new(-20_000, 5), Point::new(20_000, -3)),
        (Point::new(7, -20_000), Point::new(0, 20_000)),
    ]);
    mesh.insert(300, &cut).unwrap();
    sound(&mesh, &"cut fan");
    assert_ne!(mesh.hash(), before.hash());
    for i in (0..300).step_by(3) {
        mesh.remove(i).unwrap();
    }
    sound(&mesh, &"thinned fan");
    for i in (0..300).step_by(3) {
        mesh.insert(i, &fan[i as usize]).unwrap();
    }
    mesh.remove(300).unwrap();
    assert_eq!(mesh.hash(), before.hash());
}

#[test]
fn one_of_three_equal_features_can_go() {
    let outline = [(0, 0), (40, 3), (38, 30), (5, 33)].map(|(x, y)| Point::new(x, y));
    let feature = expand(&outline, &small_collider());
    let other = expand(
        &outline.map(|p| Point::new(p.x + 17, p.y + 9)),
        &small_collider(),
    );
    let three = vec![
        feature.clone(),
        other.clone(),
        feature.clone(),
        feature.clone(),
    ];
    let mut mesh = Mesh::build(&three).unwrap();
    covers_agree(&mesh, &"three");
    mesh.remove(2).unwrap();
    sound(&mesh, &"two of three");
    covers_agree(&mesh, &"two of three");
    mesh.remove(0).unwrap();
    let mut expected = Mesh::build(&[]).unwrap();
    expected.insert(3, &feature).unwrap();
    expected.insert(1, &other).unwrap();
    assert_eq!(mesh.hash(), expected.hash());
}

#[test]
fn opposite_duplicates_cancel_and_leave_nothing_behind() {
    // Two boxes that share a side, and a wire back and forth along it.
    let corners =
        |x: i32| [(x, 0), (x + 10, 0), (x + 10, 20), (x, 20)].map(|(x, y)| Point::new(x, y));
    let boxes = [
        expand(&corners(0), &Collider::point()),
        expand(&corners(10), &Collider::point()),
    ];
    let (p, q) = (Point::new(10, -5), Point::new(10, 25));
    let mut mesh = Mesh::build(&boxes).unwrap();
    let before = mesh.hash();
    mesh.insert(9, &wire(&[(p, q), (q, p)])).unwrap();
    sound(&mesh, &"opposite");
    covers_agree(&mesh, &"opposite");
    let seam = mesh
        .edges()
        .find(|&e| mesh.uses(e).count() == 4)
        .expect("two sides and the wire both ways");
    assert_eq!(mesh.uses(seam).filter(|u| u.forward).count(), 2);
    assert!(
        !mesh.blocks(seam) && !mesh.blocks(mesh.sym(seam)),
        "a seam between solids is no wall"
    );
    mesh.remove(9).unwrap();
    assert_eq!(mesh.hash(), before);
}

#[test]
fn combs_with_teeth_of_a_step_collapse_without_turning_inside_out() {
    for shear in -3..=3 {
        // A comb whose teeth and gaps are one step wide; sheared and cut, some corridors collapse.
        let mut comb = vec![Point::new(0, 0), Point::new(41, 41 * shear / 10)];
        for i in (0..20).rev() {
            let x = 2 * i;
            let at = |x: i32, y: i32| Point::new(x, y + x * shear / 10);
            comb.extend([at(x + 1, 40), at(x, 40)]);
            if i > 0 {
                comb.extend([at(x, 3), at(x - 1, 3)]);
            }
        }
        assert_eq!(check_outline(&comb), Ok(()), "shear {shear}");
        let cuts = [(-5, 7, 50, 29), (-3, 33, 47, 5), (0, 20, 41, 21)]
            .map(|(a, b, c, d)| (Point::new(a, b), Point::new(c, d)));
        let features = vec![
            expand(&comb, &Collider::point()),
            wire(&cuts),
            expand(&comb, &small_collider()),
        ];
        let mut mesh = Mesh::build(&features).unwrap();
        sound(&mesh, &shear);
        covers_agree_but_wires(&mesh, 1);
        let before = mesh.hash();
        for i in [1, 0, 2] {
            mesh.remove(i).unwrap();
            sound(&mesh, &(shear, i));
            mesh.insert(i, &features[i as usize]).unwrap();
        }
        assert_eq!(mesh.hash(), before, "shear {shear}");
    }
}

/// As [`covers_agree`], for a mesh with one wire, whose ends do not close.
fn covers_agree_but_wires(mesh: &Mesh, wire: FeatureId) {
    let mut without = mesh.clone();
    without.remove(wire).unwrap();
    covers_agree(&without, &"comb");
}

#[test]
fn edits_touch_their_neighbourhood_alone() {
    let mut dice = Dice::new(5);
    let mut features = Vec::new();
    for i in 0..2500 {
        let at = Point::new(100 * (i % 50), 100 * (i / 50));
        let corners = [(0, 0), (60, 5), (55, 70)]
            .map(|(x, y)| Point::new(at.x + x + dice.below(9), at.y + y + dice.below(9)));
        features.push(expand(&corners, &Collider::point()));
    }
    let mut mesh = Mesh::build(&features).unwrap();
    let faces = mesh.faces().count();
    for i in (0..2500).step_by(97) {
        mesh.remove(i).unwrap();
        assert!(
            mesh.rewired() < 60,
            "removing one of {faces} faces' triangles rewired {}",
            mesh.rewired()
        );
        mesh.insert(i, &features[i as usize]).unwrap();
        assert!(
            mesh.rewired() < 60,
            "inserting into {faces} faces rewired {}",
            mesh.rewired()
        );
    }
    assert_eq!(mesh.hash(), Mesh::build(&features).unwrap().hash());
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
