//! The slow twin: snap rounding and point-in-polygon written again, plainly, from their definitions.
//!
//! Nothing here calls the code under test. Points are pairs of i128, so a test may scale them as it likes, and
//! fractions have positive denominators.

#![allow(dead_code, reason = "each test uses its own part")]

use edgewalker::geom::Point;
use std::collections::BTreeSet;

/// A point of the plane, in whatever unit the caller has scaled it to.
pub type Spot = (i128, i128);

/// The grid point, in steps.
pub fn spot(p: Point) -> Spot {
    (i128::from(p.x), i128::from(p.y))
}

/// Positive when a, b, c turn left.
pub fn turn(a: Spot, b: Spot, c: Spot) -> i128 {
    (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)
}

/// Lower and upper border of a pixel in twice the unit, each with whether it belongs to the pixel.
fn borders(p: Spot) -> [[(i128, bool); 2]; 2] {
    let x = [(2 * p.0 - 1, p.0 > 0), (2 * p.0 + 1, p.0 < 0)];
    let y = [(2 * p.1 - 1, true), (2 * p.1 + 1, false)];
    [x, y]
}

/// Whether the position (x / w, y / w), w > 0, lies in the half-open pixel of p.
pub fn in_pixel(x: i128, y: i128, w: i128, p: Spot) -> bool {
    let within = |c: i128, [low, high]: [(i128, bool); 2]| {
        let above = if low.1 {
            2 * c >= low.0 * w
        } else {
            2 * c > low.0 * w
        };
        let below = if high.1 {
            2 * c <= high.0 * w
        } else {
            2 * c < high.0 * w
        };
        above && below
    };
    let [bx, by] = borders(p);
    within(x, bx) && within(y, by)
}

/// A bound on the parameter along a segment: num / den with den > 0, and whether the bound itself is allowed.
#[derive(Clone, Copy)]
struct Bound {
    num: i128,
    den: i128,
    closed: bool,
}

/// Whether the segment from a to b meets the half-open pixel of p, by clipping its parameter to each border in turn.
pub fn meets(a: Spot, b: Spot, p: Spot) -> bool {
    let mut low = Bound {
        num: 0,
        den: 1,
        closed: true,
    };
    let mut high = Bound {
        num: 1,
        den: 1,
        closed: true,
    };
    for (start, end, [from, to]) in [(a.0, b.0, borders(p)[0]), (a.1, b.1, borders(p)[1])] {
        let step = 2 * (end - start);
        if step == 0 {
            let above = 2 * start > from.0 || (from.1 && 2 * start == from.0);
            let below = 2 * start < to.0 || (to.1 && 2 * start == to.0);
            if !(above && below) {
                return false;
            }
            continue;
        }
        let bound = |border: (i128, bool)| Bound {
            num: (border.0 - 2 * start) * step.signum(),
            den: step.abs(),
            closed: border.1,
        };
        let (enter, leave) = if step > 0 {
            (bound(from), bound(to))
        } else {
            (bound(to), bound(from))
        };
        let tighter = |x: Bound, y: Bound, sign: i128| {
            let difference = sign * (x.num * y.den - y.num * x.den);
            if difference > 0 || (difference == 0 && !x.closed) {
                x
            } else {
                y
            }
        };
        low = tighter(enter, low, 1);
        high = tighter(leave, high, -1);
    }
    let room = high.num * low.den - low.num * high.den;
    room > 0 || (room == 0 && low.closed && high.closed)
}

/// Where the open segments a-b and c-d cross, as (x, y, w) with w > 0.
pub fn crossing(a: Spot, b: Spot, c: Spot, d: Spot) -> Option<(i128, i128, i128)> {
    // Lines as p x + q y = r, solved by Cramer's rule.
    let line = |s: Spot, t: Spot| (t.1 - s.1, s.0 - t.0, (t.1 - s.1) * s.0 + (s.0 - t.0) * s.1);
    let ((p1, q1, r1), (p2, q2, r2)) = (line(a, b), line(c, d));
    let w = p1 * q2 - p2 * q1;
    if w == 0 {
        return None;
    }
    let sign = w.signum();
    let (x, y, w) = (
        sign * (r1 * q2 - r2 * q1),
        sign * (p1 * r2 - p2 * r1),
        w.abs(),
    );
    // Strictly between the ends, in whichever coordinate the segment has some extent.
    let between = |s: Spot, t: Spot| {
        let (c, from, to) = if s.0 == t.0 {
            (y, s.1, t.1)
        } else {
            (x, s.0, t.0)
        };
        from.min(to) * w < c && c < from.max(to) * w
    };
    (between(a, b) && between(c, d)).then_some((x, y, w))
}

/// The pixel that holds a position, found by trying those around it.
pub fn pixel(x: i128, y: i128, w: i128) -> Spot {
    let (column, row) = (x.div_euclid(w), y.div_euclid(w));
    let around = (column - 1..=column + 2).flat_map(|c| (row - 1..=row + 2).map(move |r| (c, r)));
    let holding: Vec<Spot> = around.filter(|&p| in_pixel(x, y, w, p)).collect();
    assert_eq!(holding.len(), 1, "pixels tile the plane");
    holding[0]
}

/// All hot pixels of segments, and the chain of each segment.
pub fn snap(segments: &[(Spot, Spot)]) -> (BTreeSet<Spot>, Vec<Vec<Spot>>) {
    let mut hot: BTreeSet<Spot> = segments.iter().flat_map(|&(a, b)| [a, b]).collect();
    for (i, &(a, b)) in segments.iter().enumerate() {
        let crossings = segments[..i]
            .iter()
            .filter_map(|&(c, d)| crossing(a, b, c, d));
        hot.extend(crossings.map(|(x, y, w)| pixel(x, y, w)));
    }
    let chain = |&(a, b): &(Spot, Spot)| {
        let mut chain: Vec<Spot> = hot.iter().copied().filter(|&p| meets(a, b, p)).collect();
        let along = |p: &Spot| (p.0 - a.0) * (b.0 - a.0) + (p.1 - a.1) * (b.1 - a.1);
        chain.sort_by_key(along);
        chain
    };
    let chains = segments.iter().map(chain).collect();
    (hot, chains)
}

/// How often a closed outline winds around a spot that is not on it, by adding up quarter turns.
pub fn winding(outline: &[Spot], p: Spot) -> i128 {
    let quadrant = |q: Spot| match (q.0 >= p.0, q.1 >= p.1) {
        (true, true) => 0,
        (false, true) => 1,
        (false, false) => 2,
        (true, false) => 3,
    };
    let mut quarters = 0;
    for (i, &a) in outline.iter().enumerate() {
        let b = outline[(i + 1) % outline.len()];
        quarters += match (quadrant(b) - quadrant(a) + 4) % 4 {
            1 => 1,
            3 => -1,
            2 if turn(a, b, p) > 0 => 2,
            2 => -2,
            _ => 0,
        };
    }
    quarters / 4
}

/// Whether two closed polygons (given with the same unit) have a point in common.
pub fn polygons_meet(p: &[Spot], q: &[Spot]) -> bool {
    let edges = |o: &[Spot]| {
        (0..o.len())
            .map(|i| (o[i], o[(i + 1) % o.len()]))
            .collect::<Vec<_>>()
    };
    let touches = |(a, b): (Spot, Spot), (c, d): (Spot, Spot)| {
        let overlap =
            |s: i128, t: i128, u: i128, v: i128| s.min(t) <= u.max(v) && u.min(v) <= s.max(t);
        let apart = |s: i128, t: i128| s.signum() * t.signum() > 0;
        overlap(a.0, b.0, c.0, d.0)
            && overlap(a.1, b.1, c.1, d.1)
            && !apart(turn(a, b, c), turn(a, b, d))
            && !apart(turn(c, d, a), turn(c, d, b))
    };
    let borders = edges(p)
        .iter()
        .any(|&e| edges(q).iter().any(|&f| touches(e, f)));
    borders || winding(p, q[0]) != 0 || winding(q, p[0]) != 0
}
