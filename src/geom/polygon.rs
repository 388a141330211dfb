//! Closed outlines of grid points: area, winding number, and the test at the door that they are simple.
//!
//! The edge `i` of an outline runs from corner `i` to the next one, the last edge back to corner 0.

use super::grid::Point;
use super::predicates::{cross, delta, dot, orient2d};
use std::fmt;

/// Why an outline is not a simple polygon, or a polyline has no front.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutlineError {
    /// Fewer than three corners.
    TooFew {
        /// How many there are.
        corners: usize,
    },
    /// A polyline of fewer than two corners.
    TooShort {
        /// How many there are.
        corners: usize,
    },
    /// An edge starts and ends at the same grid point.
    ZeroLength {
        /// The edge.
        edge: usize,
    },
    /// The outline turns back on itself at a corner.
    Spike {
        /// The corner.
        corner: usize,
    },
    /// Two edges that are not neighbours cross or touch.
    Meet {
        /// The edge with the smaller index.
        first: usize,
        /// The other edge.
        second: usize,
    },
}

impl fmt::Display for OutlineError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            OutlineError::TooFew { corners } => {
                write!(f, "an outline needs 3 corners and this one has {corners}")
            }
            OutlineError::TooShort { corners } => {
                write!(f, "a polyline needs 2 corners and this one has {corners}")
            }
            OutlineError::ZeroLength { edge } => {
                write!(f, "edge {edge} has no length (on the grid)")
            }
            OutlineError::Spike { corner } => {
                write!(f, "the outline turns back on itself at corner {corner}")
            }
            OutlineError::Meet { first, second } => {
                write!(f, "edges {first} and {second} cross or touch")
            }
        }
    }
}

impl std::error::Error for OutlineError {}

/// Ends of edge `i` of an outline.
#[inline]
pub fn edge(outline: &[Point], i: usize) -> (Point, Point) {
    (
        outline[i],
        outline[if i + 1 == outline.len() { 0 } else { i + 1 }],
    )
}

/// Twice the signed area: positive for a counter-clockwise outline.
pub fn area2(outline: &[Point]) -> i128 {
    let origin = Point::default();
    (0..outline.len())
        .map(|i| edge(outline, i))
        .map(|(a, b)| i128::from(orient2d(origin, a, b)))
        .sum()
}

/// How often an outline, simple or not, winds counter-clockwise about a point; `None` if the point is on it.
pub fn winding(outline: &[Point], p: Point) -> Option<i32> {
    let mut turns = 0;
    for (a, b) in (0..outline.len()).map(|i| edge(outline, i)) {
        let side = orient2d(a, b, p);
        if side == 0 && dot(delta(p, a), delta(p, b)) <= 0 {
            return None;
        }
        // Count the crossings of the ray from p to the right; half-open in y, so that corners count once.
        if a.y <= p.y && b.y > p.y && side > 0 {
            turns += 1;
        } else if b.y <= p.y && a.y > p.y && side < 0 {
            turns -= 1;
        }
    }
    Some(turns)
}

/// Checks that an outline is a simple polygon: no two edges meet but neighbours at their common corner.
///
/// # Errors
/// The first thing found wrong, by the indices of the edges or corners that are involved.
pub fn check_outline(outline: &[Point]) -> Result<(), OutlineError> {
    let n = outline.len();
    if n < 3 {
        return Err(OutlineError::TooFew { corners: n });
    }
    if let Some(edge) = (0..n).find(|&i| edge(outline, i).0 == edge(outline, i).1) {
        return Err(OutlineError::ZeroLength { edge });
    }
    let spike = |&i: &usize| {
        let (a, b, c) = (outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]);
        orient2d(a, b, c) == 0 && dot(delta(b, a), delta(b, c)) > 0
    };
    match (0..n).find(spike) {
        Some(corner) => Err(OutlineError::Spike { corner }),
        None => check_apart(outline),
    }
}

/// Checks that no two edges meet, apart from neighbours; sweeps over x, so that long terrain stays cheap.
fn check_apart(outline: &[Point]) -> Result<(), OutlineError> {
    let n = outline.len();
    let left = |i: usize| edge(outline, i).0.x.min(edge(outline, i).1.x);
    let right = |i: usize| edge(outline, i).0.x.max(edge(outline, i).1.x);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by_key(|&i| (left(i), i));
    let mut active: Vec<usize> = Vec::new();
    for &i in &order {
        active.retain(|&j| right(j) >= left(i));
        for &j in &active {
            let neighbours = (i + 1) % n == j || (j + 1) % n == i;
            if !neighbours && meet(edge(outline, i), edge(outline, j)) {
                return Err(OutlineError::Meet {
                    first: i.min(j),
                    second: i.max(j),
                });
            }
        }
        active.push(i);
    }
    Ok(())
}

/// Whether two segments have a point in common.
fn meet((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let on =
        |a: Point, b: Point, p: Point, side: i64| side == 0 && dot(delta(p, a), delta(p, b)) <= 0;
    let (sc, sd) = (orient2d(a, b, c), orient2d(a, b, d));
    let (sa, sb) = (orient2d(c, d, a), orient2d(c, d, b));
    let split = |s: i64, t: i64| (s > 0 && t < 0) || (s < 0 && t > 0);
    (split(sc, sd) && split(sa, sb))
        || on(a, b, c, sc)
        || on(a, b, d, sd)
        || on(c, d, a, sa)
        || on(c, d, b, sb)
}

/// Whether corners, taken in order, turn strictly left everywhere and go around once.
pub fn is_convex(outline: &[Point]) -> bool {
    let n = outline.len();
    let turns_left =
        |i: usize| orient2d(outline[i], outline[(i + 1) % n], outline[(i + 2) % n]) > 0;
    // All turns are left turns of less than half a turn; they add up to one turn iff the edges change
    // from pointing down (or left) to pointing up (or right) only once.
    let upward = |i: usize| {
        let d = delta(outline[i % n], outline[(i + 1) % n]);
        d.1 > 0 || (d.1 == 0 && d.0 > 0)
    };
    n >= 3 && (0..n).all(turns_left) && (0..n).filter(|&i| !upward(i) && upward(i + 1)).count() == 1
}

/// Whether direction v turns left (`Greater`), right (`Less`) or not at all from direction u.
pub(crate) fn turn(u: (i64, i64), v: (i64, i64)) -> std::cmp::Ordering {
    cross(u, v).cmp(&0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(corners: &[(i32, i32)]) -> Vec<Point> {
        corners.iter().map(|&(x, y)| Point::new(x, y)).collect()
    }

    #[test]
    fn simple_outlines_pass_and_the_rest_are_named() {
        assert_eq!(
            check_outline(&outline(&[(0, 0), (4, 0), (4, 4), (0, 4)])),
            Ok(())
        );
        assert_eq!(
            check_outline(&outline(&[(0, 0), (4, 0)])),
            Err(OutlineError::TooFew { corners: 2 })
        );
        assert_eq!(
            check_outline(&outline(&[(0, 0), (4, 0), (4, 0), (0, 4)])),
            Err(OutlineError::ZeroLength { edge: 1 })
        );
        assert_eq!(
            check_outline(&outline(&[(0, 0), (4, 0), (2, 0), (0, 4)])),
            Err(OutlineError::Spike { corner: 1 })
        );
        let bow_tie = outline(&[(0, 0), (4, 4), (4, 0), (0, 4)]);
        assert_eq!(
            check_outline(&bow_tie),
            Err(OutlineError::Meet {
                first: 0,
                second: 2
            })
        );
        // The corner between edges 2 and 3 lies on edge 0; the sweep comes to edge 3 first.
        let touching = outline(&[(0, 0), (8, 0), (8, 8), (4, 0), (0, 8)]);
        assert_eq!(
            check_outline(&touching),
            Err(OutlineError::Meet {
                first: 0,
                second: 3
            })
        );
    }

    #[test]
    fn area_and_winding_follow_the_orientation() {
        let mut square = outline(&[(-1, -1), (3, -1), (3, 3), (-1, 3)]);
        assert_eq!(
            (area2(&square), winding(&square, Point::new(0, 0))),
            (32, Some(1))
        );
        square.reverse();
        assert_eq!(
            (area2(&square), winding(&square, Point::new(2, 2))),
            (-32, Some(-1))
        );
        assert_eq!(winding(&square, Point::new(9, 3)), Some(0));
        assert_eq!(winding(&square, Point::new(3, 3)), None);
        let twice = [square.clone(), square].concat();
        assert_eq!(winding(&twice, Point::new(0, 0)), Some(-2));
    }

    #[test]
    fn a_pentagram_turns_left_but_is_not_convex() {
        let star = outline(&[(0, 10), (-6, -8), (9, 3), (-9, 3), (6, -8)]);
        assert!(!is_convex(&star) && is_convex(&outline(&[(0, 0), (1, 0), (0, 1)])));
        assert!(!is_convex(&outline(&[(0, 0), (1, 0), (2, 0), (0, 1)])));
    }
}
