//! Exact distances between grid points and segments, to compare and not to compute with.

use super::grid::Point;
use super::predicates::{cross, delta, dot};
use std::cmp::Ordering;

/// The square of a distance in steps, a fraction. Equal values may be written differently; they compare as equal.
#[derive(Clone, Copy, Debug)]
pub struct SquaredDistance {
    /// At most 2^120.
    numerator: u128,
    /// At least 1 and at most 2^59.
    denominator: u64,
}

impl SquaredDistance {
    /// From a point to the segment a-b, ends included.
    pub fn to_segment(p: Point, a: Point, b: Point) -> Self {
        let (along, to) = (delta(a, b), delta(a, p));
        let (ahead, length) = (dot(along, to), dot(along, along));
        if ahead <= 0 {
            Self::whole(dot(to, to))
        } else if ahead >= length {
            let to = delta(b, p);
            Self::whole(dot(to, to))
        } else {
            let area = u128::from(cross(along, to).unsigned_abs());
            SquaredDistance {
                numerator: area * area,
                denominator: length.unsigned_abs(),
            }
        }
    }

    fn whole(square: i64) -> Self {
        SquaredDistance {
            numerator: u128::from(square.unsigned_abs()),
            denominator: 1,
        }
    }

    /// The distance in steps, rounded.
    pub fn root(self) -> f64 {
        (self.numerator as f64 / self.denominator as f64).sqrt()
    }
}

impl Ord for SquaredDistance {
    /// By cross-multiplication, in 184 bits.
    fn cmp(&self, other: &Self) -> Ordering {
        let wide = |n: u128, d: u64| {
            let low = (n & u128::from(u64::MAX)) * u128::from(d);
            let high = (n >> 64) * u128::from(d) + (low >> 64);
            (high, low as u64)
        };
        wide(self.numerator, other.denominator).cmp(&wide(other.numerator, self.denominator))
    }
}

impl PartialOrd for SquaredDistance {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for SquaredDistance {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for SquaredDistance {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::BOUND;

    #[test]
    fn fractions_are_compared_exactly_across_the_world() {
        let p = Point::new;
        let end = BOUND - 1;
        // Lines right across the world that pass the origin at distances which differ in the 57th bit.
        let far = SquaredDistance::to_segment(p(0, 0), p(-end, 1), p(end, 2));
        let near = SquaredDistance::to_segment(p(0, 0), p(-end, 0), p(end, 3));
        assert!(near.root() == far.root() && near < far);
        assert_eq!(
            far,
            SquaredDistance::to_segment(p(0, 0), p(end, -2), p(-end, -1))
        );
        // A 3-4-5 triangle: the line 3x + 4y = 15.
        let slope = SquaredDistance::to_segment(p(0, 0), p(5, 0), p(-11, 12));
        assert_eq!(
            slope,
            SquaredDistance::to_segment(p(7, 4), p(7, 7), p(9, 7))
        );
        assert_eq!(slope.root(), 3.0);
    }

    #[test]
    fn beyond_the_ends_the_ends_count() {
        let p = Point::new;
        for (from, expected) in [
            ((-3, 4), 5.0),
            ((13, -4), 5.0),
            ((5, 7), 7.0),
            ((10, 0), 0.0),
        ] {
            let found = SquaredDistance::to_segment(p(from.0, from.1), p(0, 0), p(10, 0));
            assert_eq!(found.root(), expected, "{from:?}");
        }
    }
}
