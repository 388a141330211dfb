//! The one place where the sign of anything is decided. Every answer is exact.
//!
//! Grid coordinates have 29 bits, so plain machine integers hold every determinant below: orient2d
//! needs 60 bits, a segment against a pixel 62, a crossing 90 and in_circle 120. Nothing here has a
//! tolerance, a filter or a special case for round-off, and nothing can differ between processors.
//!
//! The *pixel* of a grid point is the unit square around it. Pixels are half-open so that they tile the
//! plane: a border belongs to the pixel further from x = 0, and to the upper one. Rounding a
//! position to its pixel (halves away from zero in x, up in y) therefore commutes with the mirror x -> -x.

use super::grid::{Point, STEP};
use glam::DVec2;
use std::cmp::Ordering;

/// Twice the signed area of the triangle a, b, c: positive when they turn counter-clockwise.
#[inline]
pub fn orient2d(a: Point, b: Point, c: Point) -> i64 {
    cross(delta(a, b), delta(a, c))
}

/// The vector from a to b.
#[inline]
pub(crate) fn delta(a: Point, b: Point) -> (i64, i64) {
    (
        i64::from(b.x) - i64::from(a.x),
        i64::from(b.y) - i64::from(a.y),
    )
}

/// The z component of the cross product: positive when v is counter-clockwise of u.
#[inline]
pub(crate) fn cross(u: (i64, i64), v: (i64, i64)) -> i64 {
    u.0 * v.1 - u.1 * v.0
}

/// The dot product.
#[inline]
pub(crate) fn dot(u: (i64, i64), v: (i64, i64)) -> i64 {
    u.0 * v.0 + u.1 * v.1
}

/// Positive when d lies strictly inside the circle through a, b, c (given counter-clockwise),
/// zero when the four are cocircular.
///
/// With c and d on both sides of a-b, the angles at which they see it then make half a turn: this is minus the sine of
/// their sum, times the lengths of the sides from a and b to c and d. As a polynomial it is the usual determinant, but with
/// two wide products in place of three.
#[inline]
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> i128 {
    let (ca, cb, da, db) = (delta(c, a), delta(c, b), delta(d, a), delta(d, b));
    let wide = |x: i64, y: i64| i128::from(x) * i128::from(y);
    wide(cross(db, da), -dot(ca, cb)) - wide(cross(ca, cb), dot(da, db))
}

/// On which side of the directed line a -> b a position lies (`Greater` is left).
///
/// `p` is in *steps*, as [`steps`] gives it; exact for every position between 2^-200 and 2^200 steps
/// and for zero (adaptive precision after Shewchuk 1997, by the `robust` crate).
#[inline]
pub fn side(a: Point, b: Point, p: DVec2) -> Ordering {
    side_value(a, b, p)
        .partial_cmp(&0.0)
        .unwrap_or(Ordering::Equal)
}

/// Twice the signed area of the triangle a, b, p, in square steps, with the exact sign; the value is rounded.
#[inline]
pub fn side_value(a: Point, b: Point, p: DVec2) -> f64 {
    robust::orient2d(coord(a), coord(b), robust::Coord { x: p.x, y: p.y })
}

/// On which side of the directed line between two positions, in steps, a grid point lies (`Greater` is left). Exact as
/// [`side`] is.
#[inline]
pub fn line_side(from: DVec2, to: DVec2, p: Point) -> Ordering {
    let at = |p: DVec2| robust::Coord { x: p.x, y: p.y };
    let sign = robust::orient2d(at(from), at(to), coord(p));
    sign.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

fn coord(p: Point) -> robust::Coord<f64> {
    robust::Coord {
        x: f64::from(p.x),
        y: f64::from(p.y),
    }
}

/// A position in metres, converted to grid steps; exact, since a step is a power of two.
#[inline]
pub fn steps(p: DVec2) -> DVec2 {
    p / STEP
}

/// Whether the segments a-b and c-d cross at a point inside both; touching and overlapping do not count.
#[inline]
pub fn crosses(a: Point, b: Point, c: Point, d: Point) -> bool {
    let apart = |s: i64, t: i64| (s > 0 && t < 0) || (s < 0 && t > 0);
    apart(orient2d(a, b, c), orient2d(a, b, d)) && apart(orient2d(c, d, a), orient2d(c, d, b))
}

/// The grid point whose pixel holds the crossing of the segments a-b and c-d, which must cross.
pub fn crossing_pixel(a: Point, b: Point, c: Point, d: Point) -> Point {
    let (s, t) = (i128::from(orient2d(c, d, a)), i128::from(orient2d(c, d, b)));
    // The crossing divides a-b in the ratio s : -t, so it is (b s - a t) / (s - t); make the divisor positive.
    let (s, t) = if s > t { (s, t) } else { (-s, -t) };
    let at = |a: i32, b: i32| i128::from(b) * s - i128::from(a) * t;
    round_to_pixel(at(a.x, b.x), at(a.y, b.y), s - t)
}

/// The grid point whose pixel holds (x / divisor, y / divisor), for a positive divisor.
fn round_to_pixel(x: i128, y: i128, divisor: i128) -> Point {
    let half_up = |n: i128| (2 * n + divisor).div_euclid(2 * divisor) as i32;
    let x = if x < 0 { -half_up(-x) } else { half_up(x) };
    Point::new(x, half_up(y))
}

/// Whether the segment a-b, ends included, meets the half-open pixel of p.
///
/// Separating axes: the segment misses the square iff their boxes are apart, or all four corners of the
/// square lie on one side of the line. Ends of segments are grid points and sides of pixels lie
/// between them, so only a corner can be touched: then all depends on whether it belongs to the pixel.
#[inline]
pub fn meets_pixel(a: Point, b: Point, p: Point) -> bool {
    let apart = |a: i32, b: i32, p: i32| (a < p && b < p) || (a > p && b > p);
    if apart(a.x, b.x, p.x) || apart(a.y, b.y, p.y) {
        return false;
    }
    let (dx, dy) = delta(a, b);
    let centre = 2 * orient2d(a, b, p);
    let reach = dx.abs() + dy.abs();
    match centre.abs().cmp(&reach) {
        Ordering::Less => true,
        Ordering::Greater => false,
        // Line and square share one corner, on the line's side of the centre. (Neither dx nor dy is 0
        // here: 2 (p - a) is even. A segment without length has both 0 and lies on the centre.)
        Ordering::Equal => {
            reach == 0
                || owns_corner(
                    p,
                    -centre.signum() * dy.signum(),
                    centre.signum() * dx.signum(),
                )
        }
    }
}

/// Whether the pixel of p contains the one of its corners from which (x, y) points towards its centre.
fn owns_corner(p: Point, x: i64, y: i64) -> bool {
    // Of its corners a pixel owns at most one: a lower one, on the side of x = 0.
    y > 0 && x * i64::from(p.x.signum()) > 0
}
