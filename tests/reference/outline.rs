//! The level as a point-sized body meets it: the boundary of the union of all outlines, each grown by the reflected
//! collider, one by one and without rounding any crossing.
//!
//! Every outline is cut into triangles; each of these, grown, is the convex hull of its corners' sums. The union of the hulls is
//! the solid. Its boundary lies on outline edges that are pushed out by the collider and on collider sides at convex corners;
//! what part of them is left is found by clipping each of them against each hull: signs from integers, ends to 32 digits.

use super::double::{Double, Vector};
use edgewalker::geom::{Collider, Point, STEP};

/// Positions nearer to each other are one, m: far above the 32 digits, far below what two crossings on the grid can be apart
/// in random worlds.
pub const SAME: f64 = 1e-15;

/// A corner in grid steps; i64, so that no sum or product overflows.
pub type Corner = (i64, i64);

fn minus(a: Corner, b: Corner) -> Corner {
    (a.0 - b.0, a.1 - b.1)
}

fn plus(a: Corner, b: Corner) -> Corner {
    (a.0 + b.0, a.1 + b.1)
}

fn cross(u: Corner, v: Corner) -> i64 {
    u.0 * v.1 - u.1 * v.0
}

/// Twice the area of a triangle; positive if it turns left.
fn area(a: Corner, b: Corner, c: Corner) -> i64 {
    cross(minus(b, a), minus(c, a))
}

fn metres(p: Corner) -> Vector {
    Vector::new(p.0 as f64 * STEP, p.1 as f64 * STEP)
}

/// A stretch of a straight boundary, with the free side on its left.
#[derive(Clone, Debug)]
pub struct Side {
    /// Ends of the whole edge, before anything was cut off.
    a: Corner,
    b: Corner,
    pub start: Vector,
    pub tangent: Vector,
    /// Towards the free side.
    pub normal: Vector,
    /// Length of the whole edge, m.
    pub length: Double,
    /// A side of the collider at a corner of an outline, and no edge of one.
    pub is_flank: bool,
    /// The stretch that is boundary: from and to, in metres from `start`.
    pub from: Double,
    pub to: Double,
}

impl Side {
    fn new(a: Corner, b: Corner) -> Side {
        let along = metres(minus(b, a));
        let length = along.length();
        let tangent = Vector::new(along.x / length, along.y / length);
        Side {
            a,
            b,
            start: metres(a),
            tangent,
            normal: tangent.left(),
            length,
            is_flank: false,
            from: Double::ZERO,
            to: length,
        }
    }

    pub fn at(&self, s: Double) -> Vector {
        self.start + self.tangent * s
    }

    /// The end of the stretch in a direction: 1 along the tangent, -1 against it.
    pub fn end(&self, direction: f64) -> Double {
        if direction > 0.0 { self.to } else { self.from }
    }

    /// Whether a body can stand on it, given the steepest ground as rise per run.
    pub fn walkable(&self, max_slope: f64) -> bool {
        let (dx, dy) = minus(self.b, self.a);
        dx > 0 && Double::from(dy.abs()) <= Double::from(max_slope) * Double::from(dx)
    }

    pub fn same_line(&self, other: &Side) -> bool {
        let (u, v) = (minus(self.b, self.a), minus(other.b, other.a));
        cross(u, v) == 0 && u.0 * v.0 + u.1 * v.1 > 0 && area(self.a, self.b, other.a) == 0
    }
}

/// The boundary of a level.
pub struct World {
    pub sides: Vec<Side>,
    hulls: Vec<Vec<Corner>>,
}

impl World {
    /// Of simple outlines, for a body of a shape.
    pub fn new(outlines: &[Vec<Point>], collider: &Collider) -> World {
        let corner = |p: &Point| (i64::from(p.x), i64::from(p.y));
        let shape: Vec<Corner> = collider
            .corners()
            .iter()
            .map(corner)
            .map(|c| (-c.0, -c.1))
            .collect();
        let (mut hulls, mut edges) = (Vec::new(), Vec::new());
        for outline in outlines {
            let mut outline: Vec<Corner> = outline.iter().map(corner).collect();
            let doubled: i64 = (1..outline.len() - 1)
                .map(|i| area(outline[0], outline[i], outline[i + 1]))
                .sum();
            if doubled < 0 {
                outline.reverse();
            }
            hulls.extend(triangles(&outline).iter().map(|t| grown(t, &shape)));
            edges.extend(pushed_out(&outline, &shape));
        }
        let side = |&(a, b, is_flank): &(Corner, Corner, bool)| Side {
            is_flank,
            ..Side::new(b, a)
        };
        let stretches = edges.iter().flat_map(|edge| exposed(&side(edge), &hulls));
        let sides = split_where_they_touch(stretches.collect());
        World { sides, hulls }
    }

    /// How deep in the solid a position is, m: the largest distance to the border of a hull that holds it; negative outside.
    pub fn depth(&self, p: Vector) -> f64 {
        let in_hull = |hull: &Vec<Corner>| {
            let depth = |(a, b): (Corner, Corner)| {
                let side = Side::new(a, b);
                side.normal.dot(p - side.start).to_f64()
            };
            edges_of(hull).map(depth).fold(f64::INFINITY, f64::min)
        };
        self.hulls
            .iter()
            .map(in_hull)
            .fold(f64::NEG_INFINITY, f64::max)
    }
}

fn edges_of(outline: &[Corner]) -> impl Iterator<Item = (Corner, Corner)> + '_ {
    let n = outline.len();
    (0..n).map(move |i| (outline[i], outline[(i + 1) % n]))
}

/// Cuts ears off a counter-clockwise simple outline until a triangle is left.
fn triangles(outline: &[Corner]) -> Vec<[Corner; 3]> {
    let mut rest = outline.to_vec();
    let mut found = Vec::new();
    while rest.len() >= 3 {
        let n = rest.len();
        let corners = |i: usize| [rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]];
        let holds = |[a, b, c]: [Corner; 3], p: Corner| {
            ![a, b, c].contains(&p)
                && area(a, b, p) >= 0
                && area(b, c, p) >= 0
                && area(c, a, p) >= 0
        };
        let is_ear = |&i: &usize| {
            let [a, b, c] = corners(i);
            area(a, b, c) > 0 && !rest.iter().any(|&p| holds([a, b, c], p))
        };
        let is_flat = |&i: &usize| {
            let [a, b, c] = corners(i);
            area(a, b, c) == 0
        };
        if let Some(i) = (0..n).find(is_flat) {
            rest.remove(i);
        } else {
            let i = (0..n).find(is_ear).expect("a simple outline has an ear");
            found.push(corners(i));
            rest.remove(i);
        }
    }
    found
}

/// The convex hull of all sums of corners, by monotone chains (Andrew 1979).
fn grown(triangle: &[Corner; 3], shape: &[Corner]) -> Vec<Corner> {
    let mut sums: Vec<Corner> = triangle
        .iter()
        .flat_map(|&p| shape.iter().map(move |&q| plus(p, q)))
        .collect();
    sums.sort_unstable();
    sums.dedup();
    let half = |sums: &mut dyn Iterator<Item = &Corner>| {
        let mut chain: Vec<Corner> = Vec::new();
        for &p in sums {
            while let [.., a, b] = chain[..]
                && area(a, b, p) <= 0
            {
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sums.iter());
    hull.extend(half(&mut sums.iter().rev()));
    hull
}

/// The edges that can bound a grown outline, with the solid on their left, and whether each is a side of the shape.
fn pushed_out(outline: &[Corner], shape: &[Corner]) -> Vec<(Corner, Corner, bool)> {
    let n = outline.len();
    let along = |i: usize| minus(outline[(i + 1) % n], outline[i % n]);
    let convex = |i: usize| cross(along(i + n - 1), along(i)) > 0;
    let mut edges = Vec::new();
    for i in 0..n {
        let d = along(i);
        // The corners of the shape that reach furthest to the right of the edge: one, or the ends of a parallel side.
        let reach = |c: &Corner| cross(*c, d);
        let furthest = shape.iter().map(reach).max().expect("a shape has corners");
        let ahead = |c: &&Corner| c.0 * d.0 + c.1 * d.1;
        let at_reach = || shape.iter().filter(|c| reach(c) == furthest);
        let (rear, front) = (
            *at_reach().min_by_key(ahead).expect("not empty"),
            *at_reach().max_by_key(ahead).expect("not empty"),
        );
        let a = plus(outline[i], if convex(i) { rear } else { front });
        let b = plus(
            outline[(i + 1) % n],
            if convex((i + 1) % n) { front } else { rear },
        );
        let along_d = minus(b, a);
        if along_d.0 * d.0 + along_d.1 * d.1 > 0 {
            edges.push((a, b, false));
        }
        let before = along(i + n - 1);
        if cross(before, d) == 0 && rear != front {
            // A corner of half a turn on a line along a side of the shape: both edges stop short of it.
            edges.push((plus(outline[i], rear), plus(outline[i], front), true));
        }
        let turned_to = |&(a, b): &(Corner, Corner)| {
            cross(before, minus(b, a)) > 0 && cross(minus(b, a), d) > 0
        };
        if convex(i) {
            let corner = |(a, b)| (plus(outline[i], a), plus(outline[i], b), true);
            edges.extend(edges_of(shape).filter(turned_to).map(corner));
        }
    }
    edges
}

/// The stretches of an edge whose free side no hull covers.
fn exposed(side: &Side, hulls: &[Vec<Corner>]) -> Vec<Side> {
    let mut free = vec![(Double::ZERO, Double::ONE)];
    for (low, high) in hulls.iter().filter_map(|hull| covered(side, hull)) {
        let pieces = free
            .iter()
            .flat_map(|&(from, to)| [(from, low.min(to)), (high.max(from), to)]);
        free = pieces
            .filter(|(from, to)| !(*to - *from).is_tiny() && from < to)
            .collect();
    }
    let stretch = |(from, to): (Double, Double)| Side {
        from: from * side.length,
        to: to * side.length,
        ..side.clone()
    };
    free.into_iter().map(stretch).collect()
}

/// Cuts stretches at the ends of others: no motion goes between a wall and a tip that touches it.
fn split_where_they_touch(stretches: Vec<Side>) -> Vec<Side> {
    let ends: Vec<Vector> = stretches
        .iter()
        .flat_map(|side| [side.at(side.from), side.at(side.to)])
        .collect();
    let pieces = |side: &Side| {
        let on = |q: &Vector| side.normal.dot(*q - side.start).to_f64().abs() < SAME;
        let within = |s: &Double| (*s - side.from).min(side.to - *s).to_f64() > SAME;
        let along = ends
            .iter()
            .filter(|q| on(q))
            .map(|q| side.tangent.dot(*q - side.start));
        let mut cuts: Vec<Double> = along.filter(within).chain([side.from, side.to]).collect();
        cuts.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        cuts.dedup_by(|a, b| (*a - *b).to_f64().abs() < SAME);
        let piece = |ends: &[Double]| Side {
            from: ends[0],
            to: ends[1],
            ..side.clone()
        };
        cuts.windows(2).map(piece).collect::<Vec<_>>()
    };
    stretches.iter().flat_map(pieces).collect()
}

/// The share of an edge, from and to, along which a hull lies at its free side.
fn covered(side: &Side, hull: &[Corner]) -> Option<(Double, Double)> {
    let (mut low, mut high) = (Double::ZERO, Double::ONE);
    for (p, q) in edges_of(hull) {
        let (at_a, at_b) = (area(p, q, side.a), area(p, q, side.b));
        if at_a == 0 && at_b == 0 {
            // Along a border of the hull: it is on the left of that, and the free side is on the left of the edge.
            let (u, v) = (minus(q, p), minus(side.b, side.a));
            if u.0 * v.0 + u.1 * v.1 < 0 {
                return None;
            }
        } else if at_a <= 0 && at_b <= 0 {
            return None;
        } else if at_a < 0 || at_b < 0 {
            let at = Double::from(at_a) / (Double::from(at_a) - Double::from(at_b));
            if at_a < 0 {
                low = low.max(at);
            } else {
                high = high.min(at);
            }
        }
    }
    (low < high && !(high - low).is_tiny()).then_some((low, high))
}

/// The middle of three corners on one line along the collider's foot leaves no gap, and a notch narrower than the foot closes.
#[test]
fn grown_ground_is_whole() {
    let point = |(x, y): (i32, i32)| Point::new(x, y);
    let shape = [(-2, 0), (2, 0), (2, 5), (-2, 5)].map(point).to_vec();
    let shape = Collider::new(shape).unwrap();
    let outline = [
        (0, 0),
        (30, 0),
        (30, 9),
        (20, 9),
        (12, 9),
        (12, 4),
        (9, 4),
        (9, 9),
        (0, 9),
    ];
    let world = World::new(&[outline.map(point).to_vec()], &shape);
    let top = world.sides.iter().filter(|side| side.walkable(1.0));
    let mut spans: Vec<(f64, f64)> = top
        .map(|side| (side.at(side.from), side.at(side.to)))
        .map(|(a, b)| (a.x.to_f64() / STEP, b.x.to_f64() / STEP))
        .collect();
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert_eq!((spans[0].0, spans[spans.len() - 1].1), (-2.0, 32.0));
    assert!(
        spans.windows(2).all(|pair| pair[1].0 <= pair[0].1),
        "{spans:?}"
    );
    let inside = |x: f64, y: f64| world.depth(Vector::new(x * STEP, y * STEP)) > 0.0;
    assert!(inside(10.5, 8.0) && !inside(10.5, 9.5) && inside(32.0 - 0.1, 3.0));
}
