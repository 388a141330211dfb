//! A feature edge as a road: its direction, its normal, and positions along it.
//!
//! The parameter is the world x of the position, or the world y on edges steeper than 45 degrees, and the line is written with
//! coprime integers: so collinear edges share every bit whatever their length and direction, and a mirrored world
//! gives mirrored bits.

use crate::geom::drawn::rises_at_most;
use crate::geom::{Point, STEP};
use crate::mesh::Segment;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// Which coordinate serves as the parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Axis {
    /// World x: edges of at most 45 degrees.
    X,
    /// World y: steeper ones.
    Y,
}

/// The line of a feature edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Track {
    /// The parameter's axis.
    pub axis: Axis,
    /// Unit tangent, towards growing parameters.
    pub tangent: DVec2,
    /// Unit normal, towards the free side.
    pub normal: DVec2,
    /// The parameter grows from the segment's end b to its start a: the direction that has the free side on its left.
    pub leftward_free: bool,
    /// Coprime direction, towards growing parameters.
    direction: (i64, i64),
    /// Cross product of the direction with any point of the line, in steps.
    offset: i64,
}

fn gcd(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

impl Track {
    /// The road along a feature edge.
    pub fn of(segment: &Segment) -> Track {
        let (dx, dy) = delta(segment.a, segment.b);
        let g = gcd(dx.unsigned_abs(), dy.unsigned_abs()) as i64;
        let axis = if dx.abs() >= dy.abs() {
            Axis::X
        } else {
            Axis::Y
        };
        let from_b = if axis == Axis::X { dx < 0 } else { dy < 0 };
        let sign = if from_b { -g } else { g };
        let (dx, dy) = (dx / sign, dy / sign);
        let (x, y) = (dx as f64, dy as f64);
        let length = (x * x + y * y).sqrt();
        let tangent = DVec2::new(x / length, y / length);
        // The solid is left of a -> b, so the free side is left of b -> a.
        let side = if from_b { 1.0 } else { -1.0 };
        let normal = DVec2::new(-tangent.y * side, tangent.x * side);
        let offset = dx * i64::from(segment.a.y) - dy * i64::from(segment.a.x);
        Track {
            axis,
            tangent,
            normal,
            leftward_free: from_b,
            direction: (dx, dy),
            offset,
        }
    }

    /// The parameter of a position.
    pub fn parameter(&self, p: DVec2) -> f64 {
        match self.axis {
            Axis::X => p.x,
            Axis::Y => p.y,
        }
    }

    /// The parameter of a grid point.
    pub fn parameter_of(&self, p: Point) -> f64 {
        self.parameter(p.metres())
    }

    /// Where another road crosses this one, at a vertex that is only the rounded place of it; the vertex itself where the
    /// lines do not cross within a step of it. The same bits whichever of the two is asked.
    pub fn corner(&self, other: &Track, vertex: Point) -> DVec2 {
        let (d, e) = (self.direction, other.direction);
        let det = i128::from(cross(d, e));
        if det == 0 {
            return vertex.metres();
        }
        // The point p with cross(d, p) and cross(e, p) equal to the two offsets, by Cramer's rule; 3b + 5 = 92 bits.
        let solve = |d: i64, e: i64| {
            let numerator =
                i128::from(e) * i128::from(self.offset) - i128::from(d) * i128::from(other.offset);
            (numerator / det) as f64 + (numerator % det) as f64 / det as f64
        };
        let (x, y) = (solve(d.0, e.0), solve(d.1, e.1));
        let near = |c: f64, v: i32| (c - f64::from(v)).abs() <= 1.0;
        if near(x, vertex.x) && near(y, vertex.y) {
            DVec2::new(x, y) * STEP
        } else {
            vertex.metres()
        }
    }

    /// How far a position is past the ends of a stretch of the road, in the parameter, m; not positive between them.
    pub fn past(&self, at: DVec2, ends: [Point; 2]) -> f64 {
        let s = self.parameter(at);
        let [a, b] = ends.map(|end| self.parameter_of(end));
        (a.min(b) - s).max(s - a.max(b))
    }

    /// The parameter at a vertex where another road meets this one, the road of `segment`: that of their crossing, or of the
    /// vertex itself where the segment ends there.
    pub fn parameter_at_joint(&self, segment: &Segment, other: &Track, vertex: Point) -> f64 {
        if vertex == segment.a || vertex == segment.b {
            self.parameter_of(vertex)
        } else {
            self.parameter(self.corner(other, vertex))
        }
    }

    /// The parameter at a world x, in grid steps; for roads that are not upright.
    pub fn parameter_at_x(&self, x: i32) -> f64 {
        if self.axis == Axis::X {
            return f64::from(x) * STEP;
        }
        let numerator = i128::from(self.direction.1) * i128::from(x) + i128::from(self.offset);
        let dx = i128::from(self.direction.0);
        ((numerator / dx) as f64 + (numerator % dx) as f64 / dx as f64) * STEP
    }

    /// The position on the line straight above or below another one; for roads that are not upright.
    pub fn above(&self, p: DVec2) -> DVec2 {
        let (dx, dy) = (self.direction.0 as f64, self.direction.1 as f64);
        DVec2::new(p.x, (dy * p.x + self.offset as f64 * STEP) / dx)
    }

    /// The position on the line at a parameter.
    pub fn position(&self, s: f64) -> DVec2 {
        let (dx, dy) = (self.direction.0 as f64, self.direction.1 as f64);
        let offset = self.offset as f64 * STEP;
        match self.axis {
            Axis::X => DVec2::new(s, (dy * s + offset) / dx),
            Axis::Y => DVec2::new((dx * s - offset) / dy, s),
        }
    }

    /// Growth of the parameter per metre along the road: 1 on level ground and on upright walls.
    pub fn rate(&self) -> f64 {
        match self.axis {
            Axis::X => self.tangent.x,
            Axis::Y => self.tangent.y,
        }
    }

    /// Signed height of a position over the line, times a positive factor; positive on the free side.
    /// Also its first and second derivative along a motion: the `c`, `b`, `e` of [`super::roots::exit`].
    pub fn height(&self, p: DVec2, v: DVec2, a: DVec2) -> (f64, f64, f64) {
        let on_line = self.position(self.parameter(p));
        (
            self.normal.dot(p - on_line),
            self.normal.dot(v),
            0.5 * self.normal.dot(a),
        )
    }

    /// Whether two roads have the same direction and the free side on the same side.
    pub fn is_parallel(&self, other: &Track) -> bool {
        self.direction == other.direction && self.leftward_free == other.leftward_free
    }

    /// Whether two roads lie on one line, with the free side on the same side.
    pub fn same_line(&self, other: &Track) -> bool {
        self.direction == other.direction
            && self.offset == other.offset
            && self.leftward_free == other.leftward_free
    }

    /// The exact direction of a motion along the road: towards growing (1) or falling (-1) parameters.
    pub fn heading(&self, sign: f64) -> (i64, i64) {
        if sign > 0.0 {
            self.direction
        } else {
            (-self.direction.0, -self.direction.1)
        }
    }
}

/// From a to b, in steps.
pub fn delta(a: Point, b: Point) -> (i64, i64) {
    (
        i64::from(b.x) - i64::from(a.x),
        i64::from(b.y) - i64::from(a.y),
    )
}

/// Cross product of two exact directions. Sign: positive if `w` is counter-clockwise of `v`.
pub fn cross(v: (i64, i64), w: (i64, i64)) -> i64 {
    v.0 * w.1 - v.1 * w.0
}

/// Cross product of two exact directions of any scale.
pub fn wide_cross(v: (i64, i64), w: (i64, i64)) -> i128 {
    i128::from(v.0) * i128::from(w.1) - i128::from(v.1) * i128::from(w.0)
}

/// Dot product of two exact directions of any scale.
pub fn wide_dot(v: (i64, i64), w: (i64, i64)) -> i128 {
    i128::from(v.0) * i128::from(w.0) + i128::from(v.1) * i128::from(w.1)
}

/// Dot product of two exact directions.
pub fn dot(v: (i64, i64), w: (i64, i64)) -> i64 {
    v.0 * w.0 + v.1 * w.1
}

/// Whether a body can stand on a feature edge: the free side is up, and as it was drawn it rises at most `max_slope` per run.
pub fn walkable(segment: &Segment, max_slope: f64) -> bool {
    let (dx, dy) = segment.direction();
    segment.b.x < segment.a.x && dx < 0 && rises_at_most(dy.abs(), -dx, max_slope)
}

/// A direction by the smallest numbers.
pub fn reduced((dx, dy): (i64, i64)) -> (i64, i64) {
    let g = gcd(dx.unsigned_abs(), dy.unsigned_abs()).max(1) as i64;
    (dx / g, dy / g)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::Aside;
    use crate::mesh::Source;

    fn segment(a: (i32, i32), b: (i32, i32)) -> Segment {
        Segment {
            a: Point::new(a.0, a.1),
            b: Point::new(b.0, b.1),
            feature: 0,
            source: Source::Edge { edge: 0 },
            aside: Aside::default(),
        }
    }

    #[test]
    fn a_floor_has_its_normal_up_and_its_height_exact() {
        let floor = Track::of(&segment((65536 * 7, 0), (0, 0)));
        assert_eq!(
            (floor.axis, floor.tangent, floor.normal),
            (Axis::X, DVec2::X, DVec2::Y)
        );
        assert_eq!(floor.position(0.1), DVec2::new(0.1, 0.0));
        assert!(floor.leftward_free);
    }

    #[test]
    fn collinear_edges_share_their_bits() {
        let (long, short) = (
            Track::of(&segment((90, 40), (0, -20))),
            Track::of(&segment((30, 0), (27, -2))),
        );
        assert!(long.same_line(&short));
        assert_eq!(long.position(0.3), short.position(0.3));
    }

    #[test]
    fn a_joint_lies_on_both_lines() {
        let (low, steep) = (segment((90, 40), (0, -20)), segment((7, -40), (20, 35)));
        let (floor, wall) = (Track::of(&low), Track::of(&steep));
        let vertex = Point::new(12, -12);
        let (s, t) = (
            floor.parameter_at_joint(&low, &wall, vertex),
            wall.parameter_at_joint(&steep, &floor, vertex),
        );
        assert!((floor.position(s) - wall.position(t)).length() < 1e-16);
        assert_eq!(
            floor.parameter_at_joint(&low, &wall, Point::new(30, 0)),
            30.0 * STEP,
            "not there"
        );
    }

    #[test]
    fn walls_are_measured_in_y() {
        let left_side = Track::of(&segment((0, 5), (0, -5)));
        assert_eq!((left_side.axis, left_side.normal), (Axis::Y, -DVec2::X));
        let right_side = Track::of(&segment((0, -5), (0, 5)));
        assert_eq!(right_side.normal, DVec2::X);
        assert!(!right_side.same_line(&left_side));
    }

    #[test]
    fn forty_five_degrees_is_walkable_and_one_step_more_is_not() {
        assert!(walkable(&segment((65536, 65536), (0, 0)), 1.0));
        assert!(!walkable(&segment((65536, 65537), (0, 0)), 1.0));
        assert!(
            !walkable(&segment((0, 0), (65536, 65536)), 1.0),
            "a ceiling"
        );
    }
}
