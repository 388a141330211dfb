//! Queries against slow twins that look at every face or edge: sweeps, casts, the nearest wall, overlaps.

use crate::common::slow::{Spot, spot, turn};
use crate::common::soups::{self, polygons, small_collider};
use crate::common::worlds::{self, Dice, wire};
use edgewalker::geom::{Collider, Point, expand};
use edgewalker::mesh::{Cast, EdgeId, FaceId, Kind, Mesh, Pass};
use glam::DVec2;
use std::cmp::Ordering;

/// A share of a segment: numerator and positive denominator.
type Share = (i128, i128);

fn compare(s: Share, t: Share) -> Ordering {
    (s.0 * t.1).cmp(&(t.0 * s.1))
}

/// From where to where a segment runs through the inside of a triangle, by clipping it to one side after the other.
fn clip((a, b): (Spot, Spot), triangle: [Spot; 3]) -> Option<(Share, Share)> {
    let (mut enter, mut leave) = ((0, 1), (1, 1));
    for i in 0..3 {
        let (p, q) = (triangle[i], triangle[(i + 1) % 3]);
        let (before, behind) = (turn(p, q, a), turn(p, q, b));
        let sign = (before - behind).signum();
        let at = (before * sign, (before - behind).abs());
        match sign {
            0 if before <= 0 => return None,
            0 => {}
            1 if compare(at, leave).is_lt() => leave = at,
            -1 if compare(at, enter).is_gt() => enter = at,
            _ => {}
        }
    }
    compare(enter, leave).is_lt().then_some((enter, leave))
}

/// The faces whose inside a segment meets, in order, with where it enters them.
fn slow_faces(mesh: &Mesh, segment: (Spot, Spot)) -> Vec<(Share, FaceId)> {
    let met = |f| Some((clip(segment, mesh.corners(f).map(spot))?.0, f));
    let mut faces: Vec<_> = mesh.faces().filter_map(met).collect();
    faces.sort_by(|s, t| compare(s.0, t.0));
    faces
}

/// One world of each family with its mesh, and a square of grid points around it.
fn family_meshes(seed: u64) -> Vec<(&'static str, Mesh, Vec<Point>)> {
    let mesh = |(name, family): worlds::Family| {
        let mut dice = Dice::new(seed);
        let outlines = worlds::snapped(&family(&mut dice, 12));
        let features = worlds::expanded(&outlines, &worlds::centred_box(0.5, 0.5));
        let corners: Vec<Point> = features.iter().flatten().map(|e| e.a).collect();
        let low = |c: fn(&Point) -> i32| corners.iter().map(c).min().unwrap() - 65_536;
        let high = |c: fn(&Point) -> i32| corners.iter().map(c).max().unwrap() + 65_536;
        let (x, y) = ([low(|p| p.x), high(|p| p.x)], [low(|p| p.y), high(|p| p.y)]);
        // Corners of the world and points of a lattice of half a metre, so that lines run through vertices and along edges.
        let mut points = corners;
        for _ in 0..200 {
            let lattice = |c: [i32; 2], dice: &mut Dice| {
                (c[0] + dice.below((c[1] - c[0]) as u32)).div_euclid(32_768) * 32_768
            };
            points.push(Point::new(lattice(x, &mut dice), lattice(y, &mut dice)));
            points.push(Point::new(
                dice.below((x[1] - x[0]) as u32) + x[0],
                dice.below((y[1] - y[0]) as u32) + y[0],
            ));
        }
        (name, Mesh::build(&features).unwrap(), points)
    };
    worlds::families().into_iter().map(mesh).collect()
}

fn pick(dice: &mut Dice, points: &[Point]) -> Point {
    points[dice.below(points.len() as u32) as usize]
}

/// Two of the points, or points with which the line between them is upright or level.
fn pick_line(dice: &mut Dice, points: &[Point]) -> (Point, Point) {
    let (p, q) = (pick(dice, points), pick(dice, points));
    match dice.below(4) {
        0 => (p, Point::new(p.x, q.y)),
        1 => (p, Point::new(q.x, p.y)),
        _ => (p, q),
    }
}

#[test]
fn a_sweep_meets_exactly_the_faces_that_it_should_in_order() {
    let (mut degenerate, mut along) = (0, 0);
    for seed in 0..6 {
        for (name, mesh, points) in family_meshes(seed) {
            let mut dice = Dice::new(seed + 100);
            for _ in 0..150 {
                let (p, q) = pick_line(&mut dice, &points);
                let story = format!("{name} {seed} {p:?} {q:?}");
                let expected = slow_faces(&mesh, (spot(p), spot(q)));
                let expected: Vec<FaceId> = expected.into_iter().map(|f| f.1).collect();
                let found: Vec<FaceId> = mesh.faces_along(p.metres(), q.metres(), None).collect();
                if p != q {
                    assert_eq!(found, expected, "{story}");
                }
                let passes: Vec<Pass> = mesh.sweep(p.metres(), q.metres(), None).collect();
                follows(&mesh, &passes, &story);
                degenerate += passes
                    .iter()
                    .filter(|p| matches!(p, Pass::Through(_)))
                    .count();
                along += passes
                    .iter()
                    .filter(|p| matches!(p, Pass::Along(_)))
                    .count();
            }
        }
    }
    assert!(
        degenerate > 500 && along > 500,
        "{degenerate} vertices, {along} edges along"
    );
}

/// Asserts that each pass leads to the next.
fn follows(mesh: &Mesh, passes: &[Pass], story: &str) {
    let has_corner = |f, v| mesh.sides(f).iter().any(|&e| mesh.origin(e) == v);
    for pair in passes.windows(2) {
        let fits = match (pair[0], pair[1]) {
            (Pass::Inside(f), Pass::Across(e)) => mesh.left(e) == Some(f),
            (Pass::Across(e), Pass::Inside(f)) => mesh.left(mesh.sym(e)) == Some(f),
            (Pass::Inside(f), Pass::Through(v)) | (Pass::Through(v), Pass::Inside(f)) => {
                has_corner(f, v)
            }
            (Pass::Through(v), Pass::Along(e)) => mesh.origin(e) == v,
            (Pass::Along(e), Pass::Through(v)) => mesh.dest(e) == v,
            _ => false,
        };
        assert!(fits, "{pair:?} in {story}");
    }
}

#[test]
fn a_cast_stops_where_the_line_first_enters_a_solid_face() {
    let (mut hits, mut clear, mut pinched) = (0, 0, 0);
    for seed in 0..6 {
        for (name, mesh, points) in family_meshes(seed) {
            let mut dice = Dice::new(seed + 200);
            for _ in 0..150 {
                let (p, q) = pick_line(&mut dice, &points);
                if p == q {
                    continue;
                }
                let story = format!("{name} {seed} {p:?} {q:?}");
                let line = (spot(p), spot(q));
                let faces = slow_faces(&mesh, line).into_iter();
                let solid = faces.clone().find(|&(_, f)| mesh.is_solid(f));
                let share = |(num, den): Share| num as f64 / den as f64;
                match (mesh.cast(p.metres(), q.metres(), None), solid) {
                    (Cast::Clear, None) => clear += 1,
                    (Cast::Hit(hit), Some((at, _))) if (hit.at - share(at)).abs() < 1e-12 => {
                        assert!(hit.edges.iter().all(|&e| mesh.blocks(e)), "{story}");
                        assert!(hit.edges.iter().any(|&e| mesh.walls(e).next().is_some()));
                        hits += 1;
                    }
                    (Cast::Hit(hit), solid) => {
                        // Before it enters a solid, if it does, it is between two that touch.
                        assert!(
                            solid.is_none_or(|(at, _)| hit.at < share(at)),
                            "{story}: {hit:?}"
                        );
                        assert!(is_pinch(&mesh, hit.point, line), "{story}: {hit:?}");
                        pinched += 1;
                    }
                    (Cast::NoStart, _) => {
                        let place = mesh.locate(p.metres(), None).unwrap();
                        assert!(
                            mesh.faces_at(place).iter().all(|&f| mesh.is_solid(f))
                                || faces.clone().next().is_none(),
                            "{story}"
                        );
                    }
                    (Cast::Clear, Some(_)) => panic!("{story}: not stopped"),
                }
            }
        }
    }
    assert!(
        hits > 800 && clear > 200,
        "{hits} hits, {clear} clear, {pinched} pinched"
    );
}

/// Whether the free faces at a vertex are in several parts, or a line goes on from it along an edge between solids.
fn is_pinch(mesh: &Mesh, at: DVec2, line: (Spot, Spot)) -> bool {
    let Some(v) = mesh.vertices().find(|&v| mesh.point(v).metres() == at) else {
        return false;
    };
    let ahead = |e: EdgeId| {
        let (a, b) = mesh.ends(e);
        let (along, way) = (difference(spot(a), spot(b)), difference(line.0, line.1));
        along.0 * way.1 == along.1 * way.0 && along.0 * way.0 + along.1 * way.1 > 0
    };
    let shut = |e: EdgeId| {
        [e, mesh.sym(e)]
            .iter()
            .all(|&e| mesh.left(e).is_some_and(|f| mesh.is_solid(f)))
    };
    let borders = mesh.spokes(v).filter(|&e| mesh.blocks(e)).count();
    borders > 1 || mesh.spokes(v).any(|e| ahead(e) && shut(e))
}

fn difference(a: Spot, b: Spot) -> Spot {
    (b.0 - a.0, b.1 - a.1)
}

/// A box of grid points as a solid.
fn boxed(x: [i32; 2], y: [i32; 2]) -> Vec<edgewalker::geom::ExpandedEdge> {
    let corners = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])];
    expand(&corners.map(|(x, y)| Point::new(x, y)), &Collider::point())
}

fn at(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y) / 65536.0
}

#[test]
fn a_cast_touches_without_harm_and_does_not_slip_between_corners() {
    // Two boxes that touch at (10, 10), and one beside them at a distance.
    let features = [
        boxed([0, 10], [0, 10]),
        boxed([10, 20], [10, 20]),
        boxed([30, 40], [0, 10]),
    ];
    let mesh = Mesh::build(&features).unwrap();
    let cast = |a: (f64, f64), b: (f64, f64)| mesh.cast(at(a.0, a.1), at(b.0, b.1), None);
    let stopped_at = |a, b| -> (f64, f64) {
        let Cast::Hit(hit) = cast(a, b) else {
            panic!("{a:?} to {b:?} is not stopped");
        };
        (hit.point * 65536.0).into()
    };
    // Between the corners, along a wall from outside, along a wall into the corner.
    let corner: (f64, f64) = (10.0, 10.0);
    assert_eq!(stopped_at((5.0, 15.0), (15.0, 5.0)), corner);
    assert_eq!(stopped_at((2.0, 10.0), (18.0, 10.0)), corner);
    assert_eq!(cast((-5.0, 10.0), (5.0, 10.0)), Cast::Clear);
    assert_eq!(cast((-5.0, 0.0), (45.0, 0.0)), Cast::Clear);
    assert_eq!(stopped_at((25.0, 15.0), (35.0, 5.0)), (30.0, 10.0));
    assert_eq!(cast((-5.0, 5.0), (5.0, -5.0)), Cast::Clear, "past a corner");
    // A start on a wall may leave it; going in is a hit at once; inside there is no start.
    assert_eq!(cast((0.0, 5.0), (-5.0, 7.0)), Cast::Clear);
    assert!(matches!(cast((0.0, 5.0), (5.0, 7.0)), Cast::Hit(hit) if hit.at == 0.0));
    assert!(matches!(cast((0.0, 0.0), (5.0, 5.0)), Cast::Hit(hit) if hit.at == 0.0));
    assert_eq!(cast((5.0, 5.0), (5.0, 50.0)), Cast::NoStart);
    for wrong in [f64::NAN, f64::INFINITY, 1e300] {
        assert_eq!(
            mesh.cast(DVec2::new(0.0, wrong), DVec2::ZERO, None),
            Cast::NoStart
        );
    }
    assert_eq!(
        mesh.cast(at(-5.0, 0.0), DVec2::new(f64::NAN, 0.0), None),
        Cast::NoStart
    );
}

#[test]
fn a_ray_ends_at_the_border_of_the_world() {
    let mesh = Mesh::build(&[boxed([0, 10], [0, 10])]).unwrap();
    let start = at(-5.0, 5.0);
    let Cast::Hit(right) = mesh.ray(start, DVec2::new(3.0, 0.0), None) else {
        panic!("it meets the box");
    };
    assert!((right.point - at(0.0, 5.0)).length() < 1e-9, "{right:?}");
    for direction in [
        DVec2::NEG_X,
        DVec2::new(-1e-300, 2e-300),
        DVec2::new(-1e300, -1e300),
    ] {
        let Cast::Hit(hit) = mesh.ray(start, direction, None) else {
            panic!("the world ends");
        };
        let end = hit.point.abs().max_element();
        assert!((end - 4096.0).abs() < 1e-3, "{hit:?}");
        assert_eq!(mesh.left(mesh.sym(hit.edges[0])), None);
    }
    assert_eq!(mesh.ray(start, DVec2::ZERO, None), Cast::NoStart);
}

#[test]
fn one_ways_stop_who_asks_for_it_from_their_front() {
    let line = edgewalker::geom::expand_one_way(
        &[Point::new(0, 0), Point::new(10, 0)],
        &Collider::point(),
    );
    let mesh = Mesh::of(&[(3, Kind::OneWay, line)]).unwrap();
    let stops = |e: EdgeId| mesh.blocks(e) || mesh.has_front(e);
    let fall = |a: DVec2, b: DVec2| mesh.cast_by(a, b, None, stops);
    assert_eq!(mesh.cast(at(5.0, 4.0), at(5.0, -4.0), None), Cast::Clear);
    let Cast::Hit(hit) = fall(at(5.0, 4.0), at(5.0, -12.0)) else {
        panic!("it comes from the front");
    };
    let features = hit
        .edges
        .map(|e| mesh.fronts(e).map(|s| mesh.segment(s).feature).next());
    assert_eq!((hit.at, features), (0.25, [Some(3); 2]));
    assert_eq!(
        fall(at(5.0, -4.0), at(5.0, 4.0)),
        Cast::Clear,
        "from behind"
    );
    assert_eq!(
        fall(at(10.0, 4.0), at(10.0, -4.0)),
        Cast::Clear,
        "around the tip"
    );
    assert_eq!(fall(at(-3.0, 0.0), at(13.0, 0.0)), Cast::Clear, "along it");
}

#[test]
fn the_nearest_wall_is_the_nearest_of_all() {
    let mut inside = 0;
    for seed in 0..8 {
        for (name, mesh, points) in family_meshes(seed) {
            let walls: Vec<EdgeId> = mesh
                .edges()
                .flat_map(|e| [e, mesh.sym(e)])
                .filter(|&e| mesh.blocks(e))
                .collect();
            let mut dice = Dice::new(seed + 300);
            for _ in 0..60 {
                let p = pick(&mut dice, &points).metres();
                let found = mesh.nearest_wall(p, None).unwrap();
                let away = |e: EdgeId| {
                    let (a, b) = mesh.ends(e);
                    let (a, b) = (a.metres(), b.metres());
                    let share = (p - a).dot(b - a) / (b - a).length_squared();
                    (a + (b - a) * share.clamp(0.0, 1.0)).distance(p)
                };
                let nearest = walls.iter().map(|&e| away(e)).fold(f64::INFINITY, f64::min);
                assert!(
                    (found.distance - nearest).abs() < 1e-9,
                    "{name} {seed} {p}: {found:?}, {nearest}"
                );
                assert!(
                    (found.point.distance(p) - nearest).abs() < 1e-9 && mesh.blocks(found.edge)
                );
                let place = mesh.locate(p, None).unwrap();
                inside += usize::from(mesh.faces_at(place).iter().all(|&f| mesh.is_solid(f)));
            }
        }
    }
    assert!(inside > 100, "{inside} asked from inside solids");
    let empty = Mesh::build(&[]).unwrap();
    let border = empty.nearest_wall(DVec2::new(4000.0, 10.0), None).unwrap();
    assert!((border.distance - 96.0).abs() < 1e-3, "{border:?}");
    assert_eq!(empty.nearest_wall(DVec2::NAN, None), None);
}

#[test]
fn equally_near_walls_do_not_depend_on_history() {
    let features = [
        boxed([-20, -10], [-5, 5]),
        boxed([10, 20], [-5, 5]),
        boxed([-5, 5], [10, 20]),
    ];
    let built = Mesh::build(&features).unwrap();
    let ends = |mesh: &Mesh| mesh.ends(mesh.nearest_wall(DVec2::ZERO, None).unwrap().edge);
    for first in 0..3 {
        let mut mesh = Mesh::build(&[]).unwrap();
        for i in 0..3 {
            let id = (first + i) % 3;
            mesh.insert(id as u32, &features[id]).unwrap();
        }
        assert_eq!(ends(&mesh), ends(&built));
    }
}

/// Twice the area (of two corners: the length) that a convex shape keeps inside another one (Sutherland, Hodgman 1974).
fn common_size(shape: &[Point], within: &[Point]) -> f64 {
    let flat = |p: &Point| DVec2::new(f64::from(p.x), f64::from(p.y));
    let mut kept: Vec<DVec2> = shape.iter().map(flat).collect();
    for i in 0..within.len() {
        let (a, b) = (flat(&within[i]), flat(&within[(i + 1) % within.len()]));
        let side = |p: DVec2| (b - a).perp_dot(p - a);
        let mut next = Vec::new();
        for j in 0..kept.len() {
            let (p, q) = (kept[j], kept[(j + 1) % kept.len()]);
            if side(p) >= 0.0 {
                next.push(p);
            }
            if side(p) * side(q) < 0.0 {
                next.push(p.lerp(q, side(p) / (side(p) - side(q))));
            }
        }
        kept = next;
    }
    let edges = (0..kept.len()).map(|i| (kept[i], kept[(i + 1) % kept.len()]));
    if shape.len() == 2 {
        // Along a side of the other shape it is not inside.
        let inside = |p: DVec2| {
            (0..within.len()).all(|i| {
                let (a, b) = (flat(&within[i]), flat(&within[(i + 1) % within.len()]));
                (b - a).perp_dot(p - a) > 1e-9
            })
        };
        let through = edges.clone().any(|(p, q)| inside(p.lerp(q, 0.5)));
        return if through {
            edges.map(|(p, q)| p.distance(q)).sum()
        } else {
            0.0
        };
    }
    edges.map(|(p, q)| p.perp_dot(q)).sum()
}

#[test]
fn overlaps_are_those_of_clipped_areas() {
    let (mut shapes, mut overlapped) = (0, 0);
    for seed in 0..120 {
        let mut dice = Dice::new(4000 + seed);
        let mut features = polygons(&mut dice, 4, &small_collider());
        features.push(wire(&[soups::segment(&mut dice)]));
        // A frame around it all, so that the faces inside are small enough for floating point.
        let frame = [(-50, -50), (60, -50), (60, 60), (-50, 60)].map(|(x, y)| Point::new(x, y));
        features.push(wire(&[0, 1, 2, 3].map(|i| (frame[i], frame[(i + 1) % 4]))));
        let mesh = Mesh::build(&features).unwrap();
        let corner = |dice: &mut Dice| Point::new(dice.below(30) - 12, dice.below(30) - 3);
        let shape: Vec<Point> = (0..3).map(|_| corner(&mut dice)).collect();
        let Some(found) = mesh.overlap(&shape) else {
            assert!(turn(spot(shape[0]), spot(shape[1]), spot(shape[2])) <= 0);
            continue;
        };
        let meets = |other: &[Point]| common_size(other, &shape) > 1e-7;
        let faces: Vec<FaceId> = mesh.faces().filter(|&f| meets(&mesh.corners(f))).collect();
        assert_eq!(found.faces, faces, "seed {seed}: {shape:?}");
        let has = |&f: &u32| {
            let runs_through = mesh.segments_of(f).iter().any(|&s| {
                let chain = mesh.chain(s).windows(2);
                chain
                    .into_iter()
                    .any(|pair| meets(&[mesh.point(pair[0]), mesh.point(pair[1])]))
            });
            runs_through || faces.iter().any(|&face| mesh.cover(face).contains(&f))
        };
        let expected: Vec<u32> = mesh.features().filter(has).collect();
        assert_eq!(found.features, expected, "seed {seed}: {shape:?}");
        shapes += 1;
        overlapped += faces.len();
    }
    assert!(
        shapes > 40 && overlapped > 500,
        "{shapes} shapes, {overlapped} faces"
    );
}

#[test]
fn free_neighbours_are_across_open_edges() {
    let (_, mesh, _) = family_meshes(3).swap_remove(2);
    let mut pairs = 0;
    for face in mesh.faces().filter(|&f| !mesh.is_solid(f)) {
        for (e, beyond) in mesh.free_neighbours(face) {
            assert!(mesh.left(e) == Some(face) && !mesh.is_solid(beyond) && !mesh.blocks(e));
            assert!(mesh.free_neighbours(beyond).any(|(_, back)| back == face));
            pairs += 1;
        }
        let walls = mesh
            .sides(face)
            .into_iter()
            .filter(|&e| mesh.blocks(e))
            .count();
        assert_eq!(walls + mesh.free_neighbours(face).count(), 3);
    }
    assert!(pairs > 50, "{pairs}");
}
