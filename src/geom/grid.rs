//! The integer grid on which all static geometry lies, so that every decision about it is exact.

use glam::DVec2;

/// Metres per grid step: 2^-16, about 15 micrometres.
pub const STEP: f64 = 1.0 / 65536.0;

/// Coordinates of grid points are smaller than this in magnitude: a world of +-4096 m.
pub const BOUND: i32 = 1 << 28;

/// A point of the grid, in steps of [`STEP`] metres.
///
/// Ordered by x, then y: the lexicographic order that breaks ties between cocircular points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Point {
    /// Steps to the right.
    pub x: i32,
    /// Steps up.
    pub y: i32,
}

impl Point {
    /// The point at these grid coordinates.
    pub const fn new(x: i32, y: i32) -> Self {
        Point { x, y }
    }

    /// The grid point whose half-open pixel holds a position in metres, or `None` outside the world.
    ///
    /// Halves round away from zero in x and up in y, which makes rounding commute with the mirror x -> -x.
    pub fn snap(p: DVec2) -> Option<Self> {
        let (x, y) = (p.x / STEP, p.y / STEP);
        let floor = y.floor();
        let (x, y) = (
            x.round(),
            if y - floor >= 0.5 { floor + 1.0 } else { floor },
        );
        let inside = |c: f64| c.abs() < f64::from(BOUND);
        (inside(x) && inside(y)).then_some(Point::new(x as i32, y as i32))
    }

    /// The position in metres, exactly.
    pub fn metres(self) -> DVec2 {
        DVec2::new(f64::from(self.x), f64::from(self.y)) * STEP
    }
}
