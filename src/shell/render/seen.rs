//! What is seen of solids that lie in one another: the boundary of all of them together, and nothing that is buried.
//!
//! A part of one look that meets no free space takes the look of what is around it, and corners around which all is of one
//! look go: the facets of a front come from what can be seen of it.

use super::dangers::contains;
use super::facets::Look;
use super::fixtures::edges;
use crate::geom::Point;
use crate::geom::predicates::{in_circle, orient2d};
use crate::level::{Feature, Kind};
use glam::Vec2;
use std::collections::BTreeMap;

/// A triangle, counter-clockwise, and what it looks like.
pub type Triangle = ([Point; 3], Look);

/// How far before an edge it is asked whether it is buried, in metres.
const BEFORE: f32 = 0.01;

/// Makes solid triangles into those of what is seen: they cover the same places. The order of those given does not matter.
pub fn visible(mut triangles: Vec<Triangle>) -> Vec<Triangle> {
    for (corners, _) in &mut triangles {
        let [a, b, c] = *corners;
        *corners = [[a, b, c], [b, c, a], [c, a, b]]
            .into_iter()
            .min()
            .unwrap_or(*corners);
    }
    triangles.sort_by_key(|(corners, _)| *corners);
    adopt(&mut triangles);
    let mut triangles = dissolve(triangles);
    legalise(&mut triangles);
    triangles
}

/// Gives parts of one look that meet no free space the look of what they border on most.
fn adopt(triangles: &mut [Triangle]) {
    let sides: BTreeMap<(Point, Point), usize> = triangles
        .iter()
        .enumerate()
        .flat_map(|(t, ([a, b, c], _))| [((*a, *b), t), ((*b, *c), t), ((*c, *a), t)])
        .collect();
    let twin = |a: Point, b: Point| sides.get(&(b, a)).copied();
    // What was buried within what is buried comes up round by round.
    loop {
        let part = parts(triangles, twin);
        let count = part.iter().max().map_or(0, |last| last + 1);
        let mut open = vec![false; count];
        for (t, ([a, b, c], _)) in triangles.iter().enumerate() {
            let is_open = [(a, b), (b, c), (c, a)]
                .iter()
                .any(|(a, b)| twin(**a, **b).is_none());
            open[part[t]] |= is_open;
        }
        // Of each buried part: how far it borders on each look that is open, in metres.
        let mut around: Vec<Vec<(Look, f64)>> = vec![Vec::new(); count];
        for (t, ([a, b, c], _)) in triangles.iter().enumerate() {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                let other = twin(*a, *b).filter(|&o| !open[part[t]] && open[part[o]]);
                let Some((_, look)) = other.map(|o| triangles[o]) else {
                    continue;
                };
                let length = a.metres().distance(b.metres());
                let looks = &mut around[part[t]];
                match looks.iter_mut().find(|(known, _)| *known == look) {
                    Some((_, border)) => *border += length,
                    None => looks.push((look, length)),
                }
            }
        }
        let most = |looks: &Vec<(Look, f64)>| {
            let best = looks.iter().copied();
            best.reduce(|best, next| if next.1 > best.1 { next } else { best })
        };
        let host: Vec<Option<(Look, f64)>> = around.iter().map(most).collect();
        if host.iter().all(Option::is_none) {
            return;
        }
        for (t, (_, look)) in triangles.iter_mut().enumerate() {
            *look = host[part[t]].map_or(*look, |(host, _)| host);
        }
    }
}

/// The number of the part of one look that each triangle belongs to.
fn parts(triangles: &[Triangle], twin: impl Fn(Point, Point) -> Option<usize>) -> Vec<usize> {
    let mut part = vec![usize::MAX; triangles.len()];
    let mut count = 0;
    for first in 0..triangles.len() {
        if part[first] != usize::MAX {
            continue;
        }
        let mut todo = vec![first];
        part[first] = count;
        while let Some(t) = todo.pop() {
            let ([a, b, c], look) = triangles[t];
            for other in [(a, b), (b, c), (c, a)]
                .into_iter()
                .filter_map(|(a, b)| twin(a, b))
            {
                if part[other] == usize::MAX && triangles[other].1 == look {
                    part[other] = count;
                    todo.push(other);
                }
            }
        }
        count += 1;
    }
    part
}

/// Takes out every corner around which all is solid and of one look.
fn dissolve(mut triangles: Vec<Triangle>) -> Vec<Triangle> {
    let mut alive = vec![true; triangles.len()];
    let mut around: BTreeMap<Point, Vec<usize>> = BTreeMap::new();
    for (t, (corners, _)) in triangles.iter().enumerate() {
        for corner in corners {
            around.entry(*corner).or_default().push(t);
        }
    }
    let corners: Vec<Point> = around.keys().copied().collect();
    for corner in corners {
        let at = around.entry(corner).or_default();
        at.retain(|&t| alive[t]);
        let Some((ring, look)) = ring(corner, at, &triangles) else {
            continue;
        };
        for &t in at.iter() {
            alive[t] = false;
        }
        for filling in filled(ring) {
            for corner in filling {
                around.entry(corner).or_default().push(triangles.len());
            }
            triangles.push((filling, look));
            alive.push(true);
        }
    }
    let alive = triangles.into_iter().zip(alive);
    alive.filter_map(|(t, alive)| alive.then_some(t)).collect()
}

/// The corners around a corner, counter-clockwise, if the triangles at it close around it and are of one look.
fn ring(corner: Point, at: &[usize], triangles: &[Triangle]) -> Option<(Vec<Point>, Look)> {
    let look = triangles[*at.first()?].1;
    let mut after: BTreeMap<Point, Point> = BTreeMap::new();
    for &t in at {
        let ([a, b, c], own) = triangles[t];
        let (from, to) = match corner {
            _ if own != look => return None,
            _ if corner == a => (b, c),
            _ if corner == b => (c, a),
            _ => (a, b),
        };
        after.insert(from, to);
    }
    let first = *after.keys().next()?;
    let mut ring = vec![first];
    loop {
        let next = *after.get(ring.last()?)?;
        if next == first {
            // Two fans that share a corner alone do not close around it.
            return (ring.len() == at.len()).then_some((ring, look));
        }
        ring.push(next);
    }
}

/// Triangles that fill a simple polygon, counter-clockwise: its ears, one after the other.
fn filled(mut ring: Vec<Point>) -> Vec<[Point; 3]> {
    let mut triangles = Vec::with_capacity(ring.len().saturating_sub(2));
    while ring.len() > 3 {
        let n = ring.len();
        let ear = |i: usize| [ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]];
        let is_ear = |&i: &usize| {
            let [a, b, c] = ear(i);
            let inside = |p: &Point| {
                orient2d(a, b, *p) >= 0 && orient2d(b, c, *p) >= 0 && orient2d(c, a, *p) >= 0
            };
            let others = ring.iter().filter(|p| ![a, b, c].contains(p));
            orient2d(a, b, c) > 0 && !others.into_iter().any(inside)
        };
        // A simple polygon has two ears (G. Meisters 1975).
        let Some(i) = (0..n).find(is_ear) else {
            break;
        };
        triangles.push(ear(i));
        ring.remove(i);
    }
    if let [a, b, c] = ring[..] {
        triangles.push([a, b, c]);
    }
    triangles
}

/// Makes the triangles of each look those that depend on its border alone, by flips (C. Lawson 1977): Delaunay within the border,
/// and of two diagonals on one circle the one at the least corner.
fn legalise(triangles: &mut [Triangle]) {
    let sides = |[a, b, c]: [Point; 3]| [(a, b), (b, c), (c, a)];
    let mut owner: BTreeMap<(Point, Point), usize> = BTreeMap::new();
    for (t, (corners, _)) in triangles.iter().enumerate() {
        owner.extend(sides(*corners).map(|side| (side, t)));
    }
    let mut suspects: Vec<(Point, Point)> = owner.keys().copied().collect();
    while let Some((a, b)) = suspects.pop() {
        let (Some(&left), Some(&right)) = (owner.get(&(a, b)), owner.get(&(b, a))) else {
            continue;
        };
        if triangles[left].1 != triangles[right].1 {
            continue;
        }
        let apex = |t: usize| triangles[t].0.into_iter().find(|p| *p != a && *p != b);
        let (Some(c), Some(d)) = (apex(left), apex(right)) else {
            continue;
        };
        let is_illegal = match in_circle(a, b, c, d) {
            0 => c.min(d) < a.min(b),
            inside => inside > 0,
        };
        if is_illegal && orient2d(d, c, a) > 0 && orient2d(c, d, b) > 0 {
            owner.remove(&(a, b));
            owner.remove(&(b, a));
            for (t, corners) in [(left, [c, a, d]), (right, [d, b, c])] {
                triangles[t].0 = corners;
                owner.extend(sides(corners).map(|side| (side, t)));
            }
            suspects.extend([(b, c), (c, a), (a, d), (d, b)]);
        }
    }
}

/// The pieces of an edge of a feature that lie in no other solid of some features, in order.
pub fn unburied(
    (a, b): (Vec2, Vec2),
    feature: &Feature,
    features: &[&Feature],
) -> Vec<(Vec2, Vec2)> {
    let is_other = |f: &&&Feature| f.kind == Kind::Solid && !std::ptr::eq::<Feature>(**f, feature);
    let others: Vec<&Feature> = features.iter().filter(is_other).copied().collect();
    let along = b - a;
    let mut cuts = vec![0.0, 1.0];
    for (c, d) in others.iter().flat_map(|f| edges(f)) {
        let turn = along.perp_dot(d - c);
        let (share, across) = (
            (c - a).perp_dot(d - c) / turn,
            (c - a).perp_dot(along) / turn,
        );
        if turn != 0.0 && (0.0..=1.0).contains(&across) && (0.0..=1.0).contains(&share) {
            cuts.push(share);
        }
    }
    cuts.sort_by(f32::total_cmp);
    let outward = -along.normalize_or_zero().perp() * BEFORE;
    let mut pieces: Vec<(f32, f32)> = Vec::new();
    for pair in cuts.windows(2).filter(|pair| pair[1] > pair[0]) {
        let middle = a + along * ((pair[0] + pair[1]) / 2.0) + outward;
        if others.iter().any(|f| contains(f, middle)) {
            continue;
        }
        match pieces.last_mut() {
            Some(last) if last.1 == pair[0] => last.1 = pair[1],
            _ => pieces.push((pair[0], pair[1])),
        }
    }
    let at = |share: f32| match share {
        0.0 => a,
        1.0 => b,
        _ => a + along * share,
    };
    let ends = pieces.into_iter().map(|(from, to)| (at(from), at(to)));
    ends.filter(|(from, to)| from.distance(*to) > BEFORE)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::terrain::{build, solids};
    use super::*;
    use crate::game::Stage;
    use crate::geom::Collider;
    use crate::level;

    const ROCK: &str = "(id: \"rock\", outline: [(-20, -20), (20, -20), (20, 0), (-20, 0)])";

    /// The words of all vertices of the terrain of a level of such features, in RON.
    fn words(features: &[String]) -> Vec<u32> {
        let level = format!(
            "(version: 1, name: \"buried\", start: (-15, 0), goal: (min: (300, 300), max: (301, 301)), bottom: -40,
            features: [{}])",
            features.join(", ")
        );
        let stage =
            Stage::build(level::parse(&level, std::path::Path::new("buried")).unwrap()).unwrap();
        let outlines = stage.meshes(&Collider::point()).unwrap();
        build(&solids(&outlines.level, &stage)).words
    }

    /// A many-cornered pebble of a material, with whatever else it is.
    fn pebble(id: &str, what: &str, (x, y): (f64, f64), radius: f64) -> String {
        let corner = |i: u32| {
            let (sin, cos) = libm::sincos(f64::from(i) * std::f64::consts::TAU / 47.0);
            let radius = radius + 0.012 * libm::sin(f64::from(i) * 13.0);
            format!("({:.3}, {:.3})", x + radius * cos, y + radius * sin)
        };
        let corners: Vec<String> = (0..47).map(corner).collect();
        format!("(id: \"{id}\", {what} outline: [{}])", corners.join(", "))
    }

    const KINDS: [&str; 6] = [
        "",
        "material: Masonry,",
        "material: Timber,",
        "material: Iron,",
        "friction: Some(0.1),",
        "material: Iron, conveyor: 2,",
    ];

    #[test]
    fn what_is_buried_does_not_show() {
        for host in [
            "",
            "material: Masonry,",
            "material: Timber,",
            "material: Iron,",
        ] {
            let rock = ROCK.replace("outline", &format!("{host} outline"));
            let alone = words(std::slice::from_ref(&rock));
            for kind in KINDS {
                let mut all = vec![rock.clone()];
                for (i, at) in [
                    (3.0, -2.0),
                    (-4.0, -1.2),
                    (6.0, -3.0),
                    (1.5, -0.9),
                    (3.1, -2.2),
                ]
                .iter()
                .enumerate()
                {
                    all.push(pebble(&format!("pebble {i}"), kind, *at, 0.35));
                }
                assert!(words(&all) == alone, "{kind} in {host}");
                all.push(pebble(
                    "within a pebble",
                    "material: Timber,",
                    (3.0, -2.0),
                    0.1,
                ));
                all.rotate_left(1);
                assert!(words(&all) == alone, "{kind} in {host}, the last first");
            }
        }
    }

    /// Of what sticks out half way, the half that is buried is not seen: the facets are those of the outline that is left.
    #[test]
    fn what_sticks_out_shows_its_visible_boundary_alone() {
        let half = |x: f64, i: u32| {
            let (sin, cos) = libm::sincos(f64::from(i) * std::f64::consts::PI / 8.0);
            (x + cos, sin)
        };
        for kind in &KINDS[..4] {
            let arc: Vec<String> = (0..=8)
                .map(|i| half(2.0, i))
                .map(|(x, y)| format!("({x:.3}, {y:.3})"))
                .collect();
            let below = |depth: f64, many: bool| {
                let corners = (1..40).filter(|i| many || i % 39 == 1).map(|i| {
                    let share = f64::from(i) / 40.0;
                    let wave = if many {
                        0.1 * libm::sin(f64::from(i) * 7.0)
                    } else {
                        0.0
                    };
                    format!("({:.3}, {:.3})", 1.0 + 2.0 * share, -depth + wave)
                });
                corners.collect::<Vec<String>>().join(", ")
            };
            let stone = |depth: f64, many: bool| {
                let outline = format!("{}, {}", arc.join(", "), below(depth, many));
                format!("(id: \"stone\", {kind} outline: [{outline}])")
            };
            let plain = words(&[ROCK.into(), stone(0.6, false)]);
            // Deeper ones are taller than wide, for which timber has upright planks.
            let deepest = if kind.contains("Timber") { 0.8 } else { 4.0 };
            for depth in [0.6, 0.8, deepest] {
                let rough = words(&[ROCK.into(), stone(depth, true)]);
                assert!(rough == plain, "{kind} {depth}");
                let first = words(&[stone(depth, true), ROCK.into()]);
                assert!(first == plain, "{kind} {depth}, before the rock");
            }
        }
    }

    #[test]
    fn an_edge_is_seen_where_nothing_buries_it() {
        let feature = |corners: &[(f64, f64)]| Feature {
            outline: corners.iter().copied().map(glam::DVec2::from).collect(),
            ..Feature::default()
        };
        let belt = feature(&[(0.0, -1.0), (9.0, -1.0), (9.0, 0.0), (0.0, 0.0)]);
        let rock = feature(&[(2.0, -3.0), (4.0, -3.0), (4.0, 3.0), (2.0, 3.0)]);
        let top = (Vec2::new(9.0, 0.0), Vec2::ZERO);
        let at = |from: f32, to: f32| (Vec2::new(from, 0.0), Vec2::new(to, 0.0));
        assert_eq!(unburied(top, &belt, &[&belt]), [at(9.0, 0.0)]);
        let pieces = unburied(top, &belt, &[&rock, &belt]);
        assert_eq!(pieces.len(), 2);
        for ((a, b), (from, to)) in pieces.iter().zip([at(9.0, 4.0), at(2.0, 0.0)]) {
            assert!(a.distance(from) < 1e-5 && b.distance(to) < 1e-5, "{a} {b}");
        }
        let all = feature(&[(-1.0, -3.0), (10.0, -3.0), (10.0, 3.0), (-1.0, 3.0)]);
        assert!(unburied(top, &belt, &[&belt, &rock, &all]).is_empty());
    }
}
