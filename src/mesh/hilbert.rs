//! An order of points in which neighbours in the list are mostly neighbours in the plane, and so in memory.

use crate::geom::{BOUND, Point};

/// Position of a point along a Hilbert curve through the world (Hilbert 1891), 29 levels deep.
pub fn hilbert(p: Point) -> u64 {
    let (mut x, mut y) = ((p.x + BOUND) as u32, (p.y + BOUND) as u32);
    let mut along = 0;
    for level in (0..29).rev() {
        let (right, up) = ((x >> level) & 1, (y >> level) & 1);
        along = (along << 2) | u64::from((3 * right) ^ up);
        // Turn the quadrant so that the curve inside it starts and ends where it should.
        if up == 0 {
            if right == 1 {
                (x, y) = (!x, !y);
            }
            (x, y) = (y, x);
        }
    }
    along
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn consecutive_points_of_a_block_are_neighbours() {
        let mut block: Vec<Point> = (0..256).map(|i| Point::new(i % 16, i / 16 - 64)).collect();
        block.sort_by_key(|&p| hilbert(p));
        for pair in block.windows(2) {
            assert_eq!(hilbert(pair[1]) - hilbert(pair[0]), 1);
            let (dx, dy) = (pair[0].x.abs_diff(pair[1].x), pair[0].y.abs_diff(pair[1].y));
            assert_eq!(dx + dy, 1, "{pair:?}");
        }
    }
}
