//! The expansion of one-way polylines and of regions by a point: against the convex hull, against outlines that have the
//! polyline as a part, and mirrored.

use crate::common::slow::{self, Spot, spot};
use crate::common::worlds::Dice;
use edgewalker::geom::{
    Collider, ExpandedEdge, OutlineError, Point, Source, check_outline, check_polyline, expand,
    expand_about, expand_one_way,
};
use std::collections::BTreeSet;

fn colliders() -> Vec<Collider> {
    let polygon = |corners: &[(i32, i32)]| {
        Collider::new(corners.iter().map(|&(x, y)| Point::new(x, y)).collect()).unwrap()
    };
    vec![
        polygon(&[(-1, 0), (1, 0), (2, 1), (2, 4), (-2, 4), (-2, 1)]),
        polygon(&[(-1, -1), (1, -1), (1, 1), (-1, 1)]),
        polygon(&[(0, 0), (3, 1), (1, 2)]),
        polygon(&[(0, -2), (2, 0), (0, 2), (-2, 0)]),
    ]
}

/// Ends without sources, in any order.
fn ends(edges: &[ExpandedEdge]) -> BTreeSet<(Point, Point)> {
    edges.iter().map(|e| (e.a, e.b)).collect()
}

/// The corners of the convex hull, counter-clockwise (Andrew's monotone chain).
fn hull(mut points: Vec<Spot>) -> Vec<Spot> {
    points.sort_unstable();
    points.dedup();
    let half = |points: &mut dyn Iterator<Item = &Spot>| {
        let mut chain: Vec<Spot> = Vec::new();
        for &p in points {
            while chain.len() > 1
                && slow::turn(chain[chain.len() - 2], chain[chain.len() - 1], p) <= 0
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    [half(&mut points.iter()), half(&mut points.iter().rev())].concat()
}

#[test]
fn one_edge_keeps_the_front_of_the_hull_around_it() {
    let mut dice = Dice::new(31);
    for round in 0..2000 {
        let (p, q) = (dice.point(12), dice.point(12));
        if p == q {
            continue;
        }
        let collider = &colliders()[round % 4];
        let reflected = |end: Point| {
            let corners = collider.corners().iter();
            corners.map(move |c| spot(Point::new(end.x - c.x, end.y - c.y)))
        };
        let hull = hull(reflected(p).chain(reflected(q)).collect());
        // The front's normal is the direction turned left; an outward normal is an edge turned right.
        let n = (spot(p).1 - spot(q).1, spot(q).0 - spot(p).0);
        let sides = (0..hull.len()).map(|i| (hull[i], hull[(i + 1) % hull.len()]));
        let faces_front = |&(a, b): &(Spot, Spot)| (b.1 - a.1) * n.0 - (b.0 - a.0) * n.1 > 0;
        let expected: BTreeSet<(Spot, Spot)> = sides.filter(faces_front).collect();
        let edges = expand_one_way(&[p, q], collider);
        let found: BTreeSet<_> = edges.iter().map(|e| (spot(e.a), spot(e.b))).collect();
        assert_eq!(found, expected, "{p:?} {q:?} {collider:?}");
        for pair in edges.windows(2) {
            assert_eq!(pair[0].b, pair[1].a, "in order, from end to end");
        }
    }
}

/// The upper side of a random outline: a polyline from its left to its right, and the outline of all below it.
fn terrain(dice: &mut Dice) -> (Vec<Point>, Vec<Point>) {
    let mut x = 0;
    let mut top = Vec::new();
    for _ in 0..3 + dice.below(4) {
        top.push(Point::new(x, dice.below(10)));
        x += 1 + dice.below(9);
    }
    let (first, last) = (top[0], top[top.len() - 1]);
    let mut outline = top.clone();
    outline.extend([Point::new(last.x, -60), Point::new(first.x, -60)]);
    (top, outline)
}

#[test]
fn between_its_ends_a_polyline_is_expanded_like_the_top_of_a_solid() {
    let mut dice = Dice::new(32);
    let mut joints = 0;
    for round in 0..2000 {
        let (top, outline) = terrain(&mut dice);
        assert_eq!(check_outline(&outline), Ok(()));
        let collider = &colliders()[round % 4];
        let edges = expand_one_way(&top, collider);
        let solid = expand(&outline, collider);
        let last = top.len() as u32 - 1;
        for e in &edges {
            let inner = match e.source {
                Source::Edge { edge } => edge > 0 && edge + 1 < last,
                Source::Corner { vertex, .. } => vertex > 0 && vertex < last,
            };
            if inner {
                assert!(solid.contains(e), "{e:?} {top:?} {collider:?}");
                joints += 1;
            }
        }
        // Nothing of the top is missing but what runs backwards, under a joint that is not convex.
        for e in solid {
            let inner = match e.source {
                Source::Edge { edge } => edge > 0 && edge + 1 < last,
                Source::Corner { vertex, .. } => vertex > 0 && vertex < last,
            };
            assert!(
                !inner || e.b.x > e.a.x || edges.contains(&e) || e.a.x == e.b.x,
                "{e:?}"
            );
        }
        let mut sources: Vec<Source> = edges.iter().map(|e| e.source).collect();
        sources.sort();
        assert!(
            sources.windows(2).all(|s| s[0] < s[1]),
            "sources are unique: {top:?}"
        );
    }
    assert!(joints > 3000, "{joints}");
}

#[test]
fn by_a_point_a_polyline_is_itself_backwards() {
    let line = [(0, 0), (5, 2), (9, 2), (9, 7)].map(|(x, y)| Point::new(x, y));
    let edges = expand_one_way(&line, &Collider::point());
    let found: Vec<_> = edges.iter().map(|e| (e.a, e.b, e.source)).collect();
    let edge = |i: usize| (line[i + 1], line[i], Source::Edge { edge: i as u32 });
    assert_eq!(found, [edge(2), edge(1), edge(0)]);
}

#[test]
fn a_flat_platform_has_a_top_and_flanks_for_the_hero() {
    let metres = |m: f64| (m * 65536.0) as i32;
    let line = [Point::new(0, 0), Point::new(metres(4.0), 0)];
    let edges = expand_one_way(&line, &Collider::hero());
    assert_eq!(
        edges,
        expand_one_way(&line, &Collider::hero_crouched()),
        "both sizes alike"
    );
    let sources: Vec<Source> = edges.iter().map(|e| e.source).collect();
    // Walked from the right: the body's left flank, its foot on the platform, its right flank.
    let flank = |vertex, side| Source::Corner { vertex, side };
    assert_eq!(
        sources,
        [flank(1, 5), Source::Edge { edge: 0 }, flank(0, 1)]
    );
    let top = edges[1];
    let foot = metres(0.25);
    assert_eq!(
        (top.a, top.b),
        (Point::new(metres(4.0) + foot, 0), Point::new(-foot, 0))
    );
}

#[test]
fn one_ways_commute_with_the_mirror() {
    let mut dice = Dice::new(33);
    let mirrored = |p: Point| Point::new(-p.x, p.y);
    for round in 0..2000 {
        let line: Vec<Point> = (0..2 + dice.below(4)).map(|_| dice.point(9)).collect();
        if check_polyline(&line).is_err() {
            continue;
        }
        // Colliders that are mirror images of themselves.
        let collider = &colliders()[[0, 1, 3][round % 3]];
        let mirror: Vec<Point> = line.iter().rev().map(|&p| mirrored(p)).collect();
        let here = ends(&expand_one_way(&line, collider));
        let there = ends(&expand_one_way(&mirror, collider));
        let expected = here
            .iter()
            .map(|&(a, b)| (mirrored(b), mirrored(a)))
            .collect();
        assert_eq!(there, expected, "{line:?} {collider:?}");
    }
}

#[test]
fn polylines_without_a_front_are_refused() {
    let line = |corners: &[(i32, i32)]| -> Vec<Point> {
        corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
    };
    let check = |corners: &[(i32, i32)]| check_polyline(&line(corners));
    assert_eq!(check(&[(0, 0)]), Err(OutlineError::TooShort { corners: 1 }));
    assert_eq!(
        check(&[(0, 0), (3, 0), (3, 0)]),
        Err(OutlineError::ZeroLength { edge: 1 })
    );
    assert_eq!(
        check(&[(0, 0), (6, 3), (2, 1)]),
        Err(OutlineError::Spike { corner: 1 })
    );
    assert_eq!(
        check(&[(0, 0), (6, 3), (8, 4), (0, 5), (3, 0)]),
        Ok(()),
        "straight on and across"
    );
    assert!(expand_one_way(&[], &Collider::hero()).is_empty());
    assert!(expand_one_way(&line(&[(1, 1)]), &Collider::hero()).is_empty());
    let text = OutlineError::TooShort { corners: 1 }.to_string();
    assert!(text.contains("2 corners"), "{text}");
}

#[test]
fn a_region_by_a_point_of_the_body_is_moved_the_other_way() {
    let outline = [(0, 0), (0, 10), (10, 10), (10, 0)].map(|(x, y)| Point::new(x, y));
    let edges = expand_about(&outline, Point::new(3, 20));
    let corner = |x: i32, y: i32| Point::new(x - 3, y - 20);
    let expected = [
        (corner(10, 0), corner(10, 10)),
        (corner(10, 10), corner(0, 10)),
        (corner(0, 10), corner(0, 0)),
        (corner(0, 0), corner(10, 0)),
    ];
    assert_eq!(
        ends(&edges),
        expected.into_iter().collect(),
        "counter-clockwise"
    );
    assert!(
        edges
            .iter()
            .all(|e| matches!(e.source, Source::Edge { .. }))
    );
}
