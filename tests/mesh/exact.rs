//! The predicates and the expansion by a collider against slow twins.

use crate::common::slow::{self, Spot, spot};
use crate::common::worlds::Dice;
use edgewalker::geom::predicates::{
    crosses, crossing_pixel, in_circle, meets_pixel, orient2d, side, steps,
};
use edgewalker::geom::{BOUND, Collider, Point, Source, check_outline, expand, polygon};
use edgewalker::mesh::Mesh;
use glam::DVec2;
use std::cmp::Ordering;

fn mirrored(p: Point) -> Point {
    Point::new(-p.x, p.y)
}

/// A point anywhere in the world.
fn anywhere(dice: &mut Dice) -> Point {
    let mut coordinate = || dice.below(2 * BOUND as u32 - 1) - BOUND + 1;
    Point::new(coordinate(), coordinate())
}

#[test]
fn segment_meets_pixel_as_by_clipping_for_all_small_cases() {
    let all: Vec<Point> = (-3..=3)
        .flat_map(|x| (-1..=3).map(move |y| Point::new(x, y)))
        .collect();
    for &a in &all {
        for &b in &all {
            for &p in &all {
                let meets = meets_pixel(a, b, p);
                assert_eq!(
                    meets,
                    slow::meets(spot(a), spot(b), spot(p)),
                    "{a:?} {b:?} {p:?}"
                );
                assert_eq!(meets, meets_pixel(b, a, p), "{a:?} {b:?} {p:?} backwards");
                assert_eq!(
                    meets,
                    meets_pixel(mirrored(a), mirrored(b), mirrored(p)),
                    "{a:?} {b:?} {p:?} mirrored"
                );
            }
        }
    }
}

#[test]
fn segment_meets_pixel_as_by_clipping_across_the_world() {
    let mut dice = Dice::new(1);
    let mut met = 0;
    for _ in 0..200_000 {
        let (a, b) = (anywhere(&mut dice), anywhere(&mut dice));
        // A pixel near the segment, so that both answers occur.
        let t = dice.unit();
        let on = |a: i32, b: i32| (f64::from(a) + (f64::from(b) - f64::from(a)) * t) as i32;
        let p = Point::new(
            on(a.x, b.x) + dice.below(3) - 1,
            on(a.y, b.y) + dice.below(3) - 1,
        );
        let meets = meets_pixel(a, b, p);
        assert_eq!(
            meets,
            slow::meets(spot(a), spot(b), spot(p)),
            "{a:?} {b:?} {p:?}"
        );
        met += u32::from(meets);
    }
    assert!((40_000..160_000).contains(&met), "{met} of 200000 met");
}

#[test]
fn crossings_fall_into_their_pixels() {
    let mut dice = Dice::new(2);
    let mut crossed = 0;
    for round in 0..200_000 {
        let p: Vec<Point> = (0..4)
            .map(|_| {
                if round % 2 == 0 {
                    anywhere(&mut dice)
                } else {
                    Point::new(dice.below(13) - 6, dice.below(13) - 6)
                }
            })
            .collect();
        let (a, b, c, d) = (p[0], p[1], p[2], p[3]);
        let expected = slow::crossing(spot(a), spot(b), spot(c), spot(d));
        assert_eq!(crosses(a, b, c, d), expected.is_some(), "{p:?}");
        let Some((x, y, w)) = expected else { continue };
        let pixel = crossing_pixel(a, b, c, d);
        assert!(slow::in_pixel(x, y, w, spot(pixel)), "{p:?} -> {pixel:?}");
        assert_eq!(crossing_pixel(d, c, a, b), pixel, "{p:?} in another order");
        assert_eq!(
            crossing_pixel(mirrored(a), mirrored(b), mirrored(c), mirrored(d)),
            mirrored(pixel),
            "{p:?} mirrored"
        );
        crossed += 1;
    }
    assert!(crossed > 30_000, "{crossed} crossed");
}

#[test]
fn halves_round_away_from_the_middle_and_up() {
    let p = Point::new;
    assert_eq!(crossing_pixel(p(0, 0), p(1, 1), p(0, 1), p(1, 0)), p(1, 1));
    assert_eq!(
        crossing_pixel(p(0, 0), p(-1, 1), p(0, 1), p(-1, 0)),
        p(-1, 1)
    );
    assert_eq!(
        crossing_pixel(p(0, 0), p(-1, -1), p(0, -1), p(-1, 0)),
        p(-1, 0)
    );
    let half = |x: f64, y: f64| Point::snap(DVec2::new(x, y) / 65536.0).unwrap();
    assert_eq!(
        (half(0.5, 0.5), half(-0.5, -0.5), half(1.25, -1.75)),
        (p(1, 1), p(-1, 0), p(1, -2))
    );
}

/// The circle's centre as a fraction, and whether d is nearer to it than a.
fn in_circle_by_centre(a: Spot, b: Spot, c: Spot, d: Spot) -> Ordering {
    let (bx, by, cx, cy, dx, dy) = (
        b.0 - a.0,
        b.1 - a.1,
        c.0 - a.0,
        c.1 - a.1,
        d.0 - a.0,
        d.1 - a.1,
    );
    let w = 2 * (bx * cy - by * cx);
    let (b2, c2) = (bx * bx + by * by, cx * cx + cy * cy);
    let (ux, uy) = (cy * b2 - by * c2, bx * c2 - cx * b2);
    let reach = ux * ux + uy * uy;
    reach.cmp(&((dx * w - ux).pow(2) + (dy * w - uy).pow(2)))
}

#[test]
fn in_circle_agrees_with_the_distance_from_the_centre() {
    let mut dice = Dice::new(3);
    let mut cocircular = 0;
    for round in 0..100_000 {
        let n = if round % 2 == 0 { 9 } else { 40_000 };
        let p: Vec<Point> = (0..4).map(|_| dice.point(n)).collect();
        if orient2d(p[0], p[1], p[2]) <= 0 {
            continue;
        }
        let expected = in_circle_by_centre(spot(p[0]), spot(p[1]), spot(p[2]), spot(p[3]));
        assert_eq!(in_circle(p[0], p[1], p[2], p[3]).cmp(&0), expected, "{p:?}");
        cocircular += u32::from(expected == Ordering::Equal);
    }
    assert!(cocircular > 500, "{cocircular} cocircular");
}

#[test]
fn in_circle_is_exact_at_the_edge_of_the_world() {
    let r = BOUND - 1;
    let p = Point::new;
    let (a, b, c) = (p(-r, -r), p(r, -r), p(r, r));
    assert_eq!(in_circle(a, b, c, p(-r, r)).cmp(&0), Ordering::Equal);
    assert_eq!(in_circle(a, b, c, p(1 - r, r)).cmp(&0), Ordering::Greater);
    assert_eq!(
        in_circle(b, c, p(-r, r), p(1 - r, 1 - r)).cmp(&0),
        Ordering::Greater
    );
    // A triple (3, 4, 5) turned through all quadrants, as large as it fits.
    let k = r / 5;
    let (a, b, c) = (p(5 * k, 0), p(3 * k, 4 * k), p(-4 * k, 3 * k));
    assert_eq!(in_circle(a, b, c, p(0, -5 * k)), 0);
    assert!(in_circle(a, b, c, p(0, 1 - 5 * k)) > 0 && in_circle(a, b, c, p(1, -5 * k)) < 0);
}

#[test]
fn sides_of_positions_between_grid_points_are_exact() {
    let mut dice = Dice::new(4);
    let mut on_line = 0;
    for round in 0..100_000 {
        let (a, b) = (anywhere(&mut dice), anywhere(&mut dice));
        // Positions with 20 bits behind the point, every second one at or next to the line.
        let fine = f64::from(1 << 20);
        let p = if round % 2 == 0 {
            DVec2::new(dice.between(-1e8, 1e8), dice.between(-1e8, 1e8))
        } else {
            let halves = DVec2::new(
                f64::from(a.x) + f64::from(b.x),
                f64::from(a.y) + f64::from(b.y),
            ) / 2.0;
            halves + DVec2::new(f64::from(dice.below(3) - 1), 0.0) / fine
        };
        let p = (p * fine).round() / fine;
        let scaled = |p: Point| (i128::from(p.x) << 20, i128::from(p.y) << 20);
        let expected = slow::turn(
            scaled(a),
            scaled(b),
            ((p.x * fine) as i128, (p.y * fine) as i128),
        )
        .cmp(&0);
        assert_eq!(side(a, b, p), expected, "{a:?} {b:?} {p:?}");
        on_line += u32::from(expected == Ordering::Equal);
    }
    assert!(on_line > 10_000, "{on_line} on the line");
    assert_eq!(steps(DVec2::new(1.0, -0.25)), DVec2::new(65536.0, -16384.0));
}

/// A random simple outline with small coordinates, mostly concave, either way around.
fn outline(dice: &mut Dice, size: u32) -> Vec<Point> {
    loop {
        let corners = 3 + dice.below(5);
        let outline: Vec<Point> = (0..corners).map(|_| dice.point(size)).collect();
        if check_outline(&outline).is_ok() {
            return outline;
        }
    }
}

fn colliders() -> Vec<Collider> {
    let polygon = |corners: &[(i32, i32)]| {
        Collider::new(corners.iter().map(|&(x, y)| Point::new(x, y)).collect()).unwrap()
    };
    vec![
        Collider::point(),
        polygon(&[(-1, 0), (1, 0), (2, 1), (2, 4), (-2, 4), (-2, 1)]),
        polygon(&[(-1, -1), (1, -1), (1, 1), (-1, 1)]),
        polygon(&[(0, 0), (3, 1), (1, 2)]),
    ]
}

#[test]
fn expansion_winds_around_a_point_iff_the_body_there_meets_the_outline() {
    let mut dice = Dice::new(5);
    let mut counts = [0; 2];
    for round in 0..800 {
        let outline = outline(&mut dice, 9);
        let collider = &colliders()[round % 4];
        let edges = expand(&outline, collider);
        let chain: Vec<Point> = edges.iter().map(|e| e.a).collect();
        for (i, e) in edges.iter().enumerate() {
            assert_eq!(
                e.b,
                chain[(i + 1) % chain.len()],
                "the chain is closed: {outline:?}"
            );
        }
        let mut sources: Vec<Source> = edges.iter().map(|e| e.source).collect();
        sources.sort();
        assert!(
            sources.windows(2).all(|s| s[0] < s[1]),
            "sources are unique: {outline:?}"
        );
        let solid: Vec<Spot> = outline.iter().map(|&p| spot(p)).collect();
        for p in (-5..14).flat_map(|x| (-6..14).map(move |y| Point::new(x, y))) {
            let Some(winding) = polygon::winding(&chain, p) else {
                continue;
            };
            let body: Vec<Spot> = collider
                .corners()
                .iter()
                .map(|c| spot(Point::new(p.x + c.x, p.y + c.y)))
                .collect();
            let meets = slow::polygons_meet(&solid, &body);
            assert!(
                winding >= 0 && (winding > 0) == meets,
                "{outline:?} {collider:?} {p:?}: {winding}"
            );
            counts[usize::from(meets)] += 1;
        }
    }
    assert!(counts.iter().all(|&n| n > 10_000), "{counts:?}");
}

#[test]
fn both_sizes_of_the_hero_share_all_that_the_lower_chain_makes() {
    let mut dice = Dice::new(6);
    let mut shared = 0;
    for _ in 0..200 {
        let outline: Vec<Point> = outline(&mut dice, 9)
            .iter()
            .map(|p| Point::new(p.x << 16, p.y << 16))
            .collect();
        let stand = expand(&outline, &Collider::hero());
        let crouch = expand(&outline, &Collider::hero_crouched());
        // Sides 0, 1 and 5 are the foot and the flanks; floors are touched by the ends of the foot.
        for e in &stand {
            let lower = match e.source {
                Source::Corner { side, .. } => [0, 1, 5].contains(&side),
                Source::Edge { .. } => {
                    e.b.x < e.a.x && i64::from(e.b.y - e.a.y).abs() < i64::from(e.a.x - e.b.x)
                }
            };
            if lower {
                assert!(crouch.contains(e), "{outline:?}: {e:?}");
                shared += 1;
            }
        }
    }
    assert!(shared > 500, "{shared} shared");
}

#[test]
fn expansion_commutes_with_the_mirror_and_with_reversal() {
    let mut dice = Dice::new(7);
    for _ in 0..500 {
        let outline = outline(&mut dice, 9);
        let ends = |outline: &[Point], flip: bool| {
            let ends = |e: &edgewalker::geom::ExpandedEdge| {
                if flip {
                    (mirrored(e.b), mirrored(e.a))
                } else {
                    (e.a, e.b)
                }
            };
            let mut edges: Vec<_> = expand(outline, &colliders()[1]).iter().map(ends).collect();
            edges.sort();
            edges
        };
        let reversed: Vec<Point> = outline.iter().rev().copied().collect();
        let mirror: Vec<Point> = outline.iter().map(|&p| mirrored(p)).collect();
        assert_eq!(
            ends(&outline, false),
            ends(&reversed, false),
            "{outline:?} reversed"
        );
        assert_eq!(
            ends(&outline, false),
            ends(&mirror, true),
            "{outline:?} mirrored"
        );
    }
}

#[test]
fn collider_sides_join_the_edges_that_they_are_parallel_to() {
    let outline = |corners: &[(i32, i32)]| -> Vec<Point> {
        corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
    };
    let collider = &colliders()[2];
    let expanded = |corners: &[(i32, i32)]| -> Vec<_> {
        let edges = expand(&outline(corners), collider);
        edges
            .iter()
            .map(|e| (spot(e.a), spot(e.b), e.source))
            .collect()
    };
    let edge = |edge| Source::Edge { edge };
    // A box by a box is a box of four edges.
    let boxed = expanded(&[(0, 0), (10, 0), (10, 10), (0, 10)]);
    let sides = [
        ((-1, -1), (11, -1), edge(0)),
        ((11, -1), (11, 11), edge(1)),
        ((11, 11), (-1, 11), edge(2)),
        ((-1, 11), (-1, -1), edge(3)),
    ];
    assert_eq!(boxed, sides);
    // The floor of a pit is what the body can reach of it.
    let pit = [
        (0, 0),
        (20, 0),
        (20, 10),
        (15, 10),
        (15, 4),
        (5, 4),
        (5, 10),
        (0, 10),
    ];
    assert!(expanded(&pit).contains(&((14, 5), (6, 5), edge(4))));
    // Between two edges in line, the side is a piece of its own.
    let straight = expanded(&[(0, 0), (10, 0), (10, 10), (5, 10), (0, 10)]);
    let corner = Source::Corner { vertex: 3, side: 0 };
    let top = [
        ((11, 11), (6, 11), edge(2)),
        ((6, 11), (4, 11), corner),
        ((4, 11), (-1, 11), edge(3)),
    ];
    assert_eq!(straight[2..5], top);
}

#[test]
fn colliders_are_checked() {
    use edgewalker::geom::ColliderError::{Labels, NotConvex, TooLarge};
    let p = Point::new;
    assert_eq!(
        Collider::new(vec![p(0, 0), p(0, 1), p(1, 0)]),
        Err(NotConvex)
    );
    assert_eq!(Collider::new(vec![]), Err(NotConvex));
    assert_eq!(
        Collider::new(vec![p(0, 0), p(1 << 23, 0), p(0, 1)]),
        Err(TooLarge)
    );
    assert_eq!(
        Collider::with_labels(vec![p(0, 0), p(1, 0), p(0, 1)], vec![0]),
        Err(Labels)
    );
}

#[test]
fn a_square_has_its_diagonal_at_the_smallest_corner() {
    for (x, y) in [(0, 0), (-7, 3), (-1, -1)] {
        let corners =
            [(x, y), (x + 4, y), (x + 4, y + 4), (x, y + 4)].map(|(x, y)| Point::new(x, y));
        let mesh = Mesh::build(&[expand(&corners, &Collider::point())]).unwrap();
        let at = |p: Point| mesh.vertices().find(|&v| mesh.point(v) == p).unwrap();
        assert!(mesh.edge_between(at(corners[0]), at(corners[2])).is_some());
        assert!(mesh.edge_between(at(corners[1]), at(corners[3])).is_none());
    }
}
