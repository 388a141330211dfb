//! One mesh for one set of features, whatever the order of edits: by hash, and with every invariant checked.

use crate::common::checker;
use crate::common::soups::{covers_agree, polygons, segment, small_collider, sound};
use crate::common::worlds::{self, Dice, wire};
use edgewalker::geom::{
    Collider, ExpandedEdge, Point, Source, check_outline, expand, expand_about, expand_one_way,
};
use edgewalker::mesh::{FeatureId, Kind, Mesh, Place};
use glam::DVec2;
use std::collections::BTreeSet;

/// A mesh made by inserting features in a given order.
fn inserted(features: &[Vec<ExpandedEdge>], order: &[usize]) -> Mesh {
    let mut mesh = Mesh::build(&[]).unwrap();
    for &i in order {
        mesh.insert(i as FeatureId, &features[i]).unwrap();
    }
    mesh
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
fn rings_in_rings_are_covered_alike_built_or_put_in_one_by_one() {
    // Each starts at another corner than those next to it: in the order in which they are built they follow one another
    // neither outwards nor inwards.
    let rings = 60;
    let ring = |i: i32| {
        let half = 100 * (i + 1);
        let mut corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
            .map(|(x, y)| Point::new(x, y));
        corners.rotate_left(i as usize * 7 % 4);
        expand(&corners, &Collider::point())
    };
    let features: Vec<Vec<ExpandedEdge>> = (0..rings).map(ring).collect();
    let mesh = Mesh::build(&features).unwrap();
    sound(&mesh, &"rings");
    let order: Vec<usize> = (0..features.len())
        .map(|i| i * 23 % features.len())
        .collect();
    assert_eq!(mesh.hash(), inserted(&features, &order).hash());
    for i in 0..rings {
        let between = Point::new(100 * i + 50, 0).metres();
        let Some(Place::Face(face)) = mesh.locate(between + DVec2::new(0.0, 1e-6), None) else {
            panic!("inside a face");
        };
        let around: Vec<FeatureId> = (i as FeatureId..rings as FeatureId).collect();
        assert_eq!(mesh.cover(face), around, "ring {i}");
    }
}

#[test]
fn wires_whose_edges_share_a_source_are_told_apart_by_their_ends() {
    let source = Source::Edge { edge: 0 };
    let (p, q) = (Point::new(0, 0), Point::new(9, 4));
    let both = [(p, q), (q, p)].map(|(a, b)| ExpandedEdge::new(a, b, source));
    let other = wire(&[(Point::new(3, -5), Point::new(4, 9))]);
    let expected = Mesh::build(&[both.to_vec(), other.clone()]).unwrap().hash();
    // Ids that were given away in another order come back in another order.
    let mut mesh = Mesh::build(&[other.clone(), other.clone(), other.clone()]).unwrap();
    for id in [0, 1, 2] {
        mesh.remove(id).unwrap();
    }
    mesh.insert(0, &both).unwrap();
    mesh.insert(1, &other).unwrap();
    assert_eq!(mesh.hash(), expected);
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

/// A random world of a family on the grid, moved and turned, as features of all kinds.
fn mixed_world(name_of: worlds::Family, seed: u64) -> Vec<(FeatureId, Kind, Vec<ExpandedEdge>)> {
    let mut dice = Dice::new(seed);
    let world = name_of.1(&mut dice, 24);
    let angle = [0.0, 0.7, 2.4][seed as usize % 3];
    let offset = DVec2::new(dice.between(-900.0, 900.0), dice.between(-900.0, 900.0));
    let outlines = worlds::snapped(&worlds::placed(&world, offset, angle));
    let collider = Collider::hero();
    let feature = |(id, outline): (FeatureId, &Vec<Point>)| match id % 4 {
        0 => (id, Kind::OneWay, expand_one_way(outline, &collider)),
        1 => (
            id,
            Kind::Region,
            expand_about(outline, Point::new(0, 55_000)),
        ),
        _ => (id, Kind::Solid, expand(outline, &collider)),
    };
    (0..).zip(&outlines).map(feature).collect()
}

/// In CI 60 edits for each family; `MESH_EDITS=1000` makes the long run.
#[test]
fn a_thousand_edits_of_each_family_equal_a_rebuild() {
    let edits = worlds::setting("MESH_EDITS", 60);
    for (seed, family) in (0..).zip(worlds::families()) {
        let features = mixed_world(family, seed);
        let whole = Mesh::of(&features).unwrap();
        let mut mesh = whole.clone();
        let mut present: BTreeSet<usize> = (0..features.len()).collect();
        let mut dice = Dice::new(seed + 50);
        for edit in 0..edits {
            let i = dice.below(features.len() as u32) as usize;
            let (id, kind, edges) = &features[i];
            if present.remove(&i) {
                mesh.remove(*id).unwrap();
            } else {
                present.insert(i);
                mesh.insert_as(*id, *kind, edges).unwrap();
            }
            let rest: Vec<_> = present.iter().rev().map(|&i| features[i].clone()).collect();
            let rebuilt = Mesh::of(&rest).unwrap();
            assert_eq!(
                mesh.hash(),
                rebuilt.hash(),
                "{} after {edit} edits",
                family.0
            );
        }
        checker::check(&mesh).unwrap_or_else(|wrong| panic!("{}: {wrong}", family.0));
        sound(&mesh, &family.0);
        for (i, (id, kind, edges)) in features.iter().enumerate() {
            if present.insert(i) {
                mesh.insert_as(*id, *kind, edges).unwrap();
            }
        }
        assert_eq!(mesh.hash(), whole.hash(), "{}: all of it again", family.0);
    }
}

/// How many vertices of a mesh lie in a box about some edges, with a margin in steps around it.
fn vertices_near(mesh: &Mesh, edges: &[ExpandedEdge], margin: i32) -> usize {
    let low = |c: fn(&ExpandedEdge) -> i32| edges.iter().map(c).min().unwrap() - margin;
    let high = |c: fn(&ExpandedEdge) -> i32| edges.iter().map(c).max().unwrap() + margin;
    let (x, y) = (
        low(|e| e.a.x)..=high(|e| e.a.x),
        low(|e| e.a.y)..=high(|e| e.a.y),
    );
    let points = mesh.vertices().map(|v| mesh.point(v));
    points
        .filter(|p| x.contains(&p.x) && y.contains(&p.y))
        .count()
}

#[test]
fn edits_touch_the_vertices_in_their_box_however_large_the_mesh() {
    let mut means = Vec::new();
    for octagons in [90, 900, 9000] {
        let mut dice = Dice::new(6);
        let world = worlds::snapped(&worlds::octagons(&mut dice, octagons));
        let mut mesh = Mesh::build(&worlds::expanded(&world, &Collider::point())).unwrap();
        let before = mesh.hash();
        let half = worlds::octagons_half_width(octagons) - 6.0;
        let mut total = 0;
        for round in 0..60 {
            let platform = worlds::snapped(&[worlds::octagon(&mut dice, half)]).remove(0);
            let edges = expand(&platform, &Collider::point());
            let insert = |mesh: &mut Mesh| mesh.insert(1 << 20, &edges).unwrap();
            let remove = |mesh: &mut Mesh| mesh.remove(1 << 20).unwrap();
            insert(&mut mesh);
            // 3 m: in the gaps between octagons, free edges reach about so far.
            let near = vertices_near(&mesh, &edges, 3 * 65_536);
            let inserted = mesh.touched();
            remove(&mut mesh);
            let removed = mesh.touched();
            assert!(
                inserted <= near && removed <= near,
                "{octagons}, {round}: {inserted} and {removed} of {near} near it"
            );
            assert!(inserted >= 8 && removed >= 8, "at least its own corners");
            total += inserted + removed;
        }
        assert_eq!(mesh.hash(), before);
        means.push((mesh.vertices().count(), total as f64 / 120.0));
    }
    let (small, large) = (means[0], means[2]);
    assert!(small.0 < 1500 && large.0 > 90_000, "{means:?}");
    assert!(
        large.1 < 1.3 * small.1,
        "vertices, touched on average: {means:?}"
    );
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
