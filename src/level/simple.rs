//! Whether an outline is simple, exactly, on the grid.

use crate::geom::Point;
use std::cmp::{max, min};

/// The first pair of edges of a closed outline that meet where they should not.
/// Edge i runs from corner i to the next one; neighbours may share their common corner only.
pub(super) fn first_clash(outline: &[Point]) -> Option<(usize, usize)> {
    let n = outline.len();
    let edge = |i: usize| (outline[i], outline[(i + 1) % n]);
    for i in 0..n {
        for j in i + 1..n {
            let clash = if j == i + 1 {
                folds_back(edge(i).0, edge(i).1, edge(j).1)
            } else if (j + 1) % n == i {
                folds_back(edge(j).0, edge(j).1, edge(i).1)
            } else {
                meet(edge(i), edge(j))
            };
            if clash {
                return Some((i, j));
            }
        }
    }
    None
}

/// Whether a walk from a over b to c turns back along the edge it came on.
fn folds_back(a: Point, b: Point, c: Point) -> bool {
    let along = |p: Point| (i64::from(p.x - b.x), i64::from(p.y - b.y));
    let ((ax, ay), (cx, cy)) = (along(a), along(c));
    orient(a, b, c) == 0 && ax * cx + ay * cy > 0
}

/// Whether two closed segments have a point in common.
fn meet((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let boxes = min(a.x, b.x) <= max(c.x, d.x)
        && min(c.x, d.x) <= max(a.x, b.x)
        && min(a.y, b.y) <= max(c.y, d.y)
        && min(c.y, d.y) <= max(a.y, b.y);
    boxes && orient(a, b, c) * orient(a, b, d) <= 0 && orient(c, d, a) * orient(c, d, b) <= 0
}

fn orient(a: Point, b: Point, c: Point) -> i64 {
    let (ux, uy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
    let (vx, vy) = (i64::from(c.x - a.x), i64::from(c.y - a.y));
    (ux * vy - uy * vx).signum()
}
