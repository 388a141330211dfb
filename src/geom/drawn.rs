//! Lengths as their author wrote them: the one rule about decimals.
//!
//! What a level says in decimals the grid can only come near to, and what is compared on the grid alone depends on where it was
//! drawn: a ramp of 45 degrees would be a step too steep in one place and not in the next. So, everywhere:
//!
//! - **A coordinate counts in whole micrometres**; one that lies on the grid exactly counts as it is ([`Drawn`]).
//! - A corner goes into the mesh as the grid point next to it. Equal coordinates stay equal by that, and every edge keeps how far
//!   from there its ends were drawn ([`Aside`]).
//! - **Limits compare what was drawn**, in integers: slopes ([`rises_at_most`]) as directions of whole edges, heights
//!   ([`Height`]) where both were drawn. A position is on a floor whose height is the same number.
//! - **Where a height was not drawn**, because outlines cross there or something moves, it is known to half a step of the grid,
//!   and the limit is two steps wider ([`SLACK`]).
//! - Among corners on the grid itself, limits are rounded to it.
//!
//! A micrometre is 2^10 and a step 5^6 *parts*, so that all of it is whole numbers: a world has 44 bits of them.

use super::grid::{BOUND, Point, STEP};
use super::minkowski::ExpandedEdge;
use glam::DVec2;

/// Parts to a micrometre.
pub const PER_MICROMETRE: i64 = 1 << 10;

/// Parts to a grid step.
pub const PER_STEP: i64 = 15_625;

/// Parts to a metre.
const PER_METRE: f64 = (PER_MICROMETRE * 1_000_000) as f64;

/// How much wider a limit is where a height was not drawn, in grid steps.
pub const SLACK: i64 = 2;

/// A point as it was drawn, in parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Drawn {
    /// To the right.
    pub x: i64,
    /// Up.
    pub y: i64,
}

/// A length in parts: whole micrometres, or exactly what it is if that is whole steps of the grid. For up to 2^22 m.
pub fn length(metres: f64) -> i64 {
    let steps = metres / STEP;
    match steps == steps.trunc() {
        true => steps as i64 * PER_STEP,
        false => (metres * 1e6).round() as i64 * PER_MICROMETRE,
    }
}

/// The grid step next to a coordinate in parts. There are no ties, for steps have an odd number of parts.
fn step(parts: i64) -> i64 {
    (parts + PER_STEP / 2).div_euclid(PER_STEP)
}

impl Drawn {
    /// The point that a position in metres means; `None` outside the world, and for what is no position.
    pub fn of(p: DVec2) -> Option<Drawn> {
        let inside = |c: f64| c.abs() < f64::from(BOUND) * STEP;
        if !(inside(p.x) && inside(p.y)) {
            return None;
        }
        let drawn = Drawn {
            x: length(p.x),
            y: length(p.y),
        };
        let inside = |c: i64| step(c).abs() < i64::from(BOUND);
        (inside(drawn.x) && inside(drawn.y)).then_some(drawn)
    }

    /// The grid point next to it.
    pub fn point(self) -> Point {
        Point::new(step(self.x) as i32, step(self.y) as i32)
    }

    /// How far it is from the grid point next to it, in parts; less than half a step of them.
    fn aside(self) -> [i16; 2] {
        [self.x, self.y].map(|c| (c - step(c) * PER_STEP) as i16)
    }

    /// The grid point, and how far beside it.
    fn beside(p: Point, [x, y]: [i16; 2]) -> Drawn {
        let parts = |c: i32, aside: i16| i64::from(c) * PER_STEP + i64::from(aside);
        Drawn {
            x: parts(p.x, x),
            y: parts(p.y, y),
        }
    }

    /// From another point to this one.
    pub fn vector_from(self, other: Drawn) -> (i64, i64) {
        (self.x - other.x, self.y - other.y)
    }

    /// The point so much further.
    pub fn moved(self, x: i64, y: i64) -> Drawn {
        Drawn {
            x: self.x + x,
            y: self.y + y,
        }
    }

    /// The position, m, rounded once.
    pub fn metres(self) -> DVec2 {
        DVec2::new(self.x as f64, self.y as f64) / PER_METRE
    }
}

impl From<Point> for Drawn {
    fn from(p: Point) -> Drawn {
        Drawn::beside(p, [0; 2])
    }
}

/// How far from their grid points the two ends of an edge were drawn, in parts: start x, y, end x, y.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Aside([i16; 4]);

impl Aside {
    /// Of an edge from one drawn point to another.
    pub fn of(from: Drawn, to: Drawn) -> Aside {
        let ([a, b], [c, d]) = (from.aside(), to.aside());
        Aside([a, b, c, d])
    }

    /// Whether both ends were drawn on the grid.
    #[inline]
    pub fn is_none(self) -> bool {
        self.0 == [0; 4]
    }

    /// Of the same edge, other way.
    pub fn turned(self) -> Aside {
        let [a, b, c, d] = self.0;
        Aside([c, d, a, b])
    }

    /// The ends of an edge as they were drawn, for the grid points to which they went.
    pub fn ends(self, a: Point, b: Point) -> [Drawn; 2] {
        let [ax, ay, bx, by] = self.0;
        [Drawn::beside(a, [ax, ay]), Drawn::beside(b, [bx, by])]
    }
}

/// Whether a closed chain of edges winds about a point as both were drawn, deeper inside than by a micrometre to which a point
/// on a slope had to be rounded. On the grid nothing has been.
pub fn winds_about(edges: &[ExpandedEdge], p: Drawn) -> bool {
    let inside = |x: i64, y: i64| winding(edges, p.moved(x, y)) > 0;
    let exact = p == p.point().into() && edges.iter().all(|edge| edge.aside.is_none());
    let near = [(1, 0), (-1, 0), (0, 1), (0, -1)].into_iter();
    let mut near = near.map(|(x, y)| (x * PER_MICROMETRE, y * PER_MICROMETRE));
    inside(0, 0) && (exact || near.all(|(x, y)| inside(x, y)))
}

/// How often a closed chain of edges winds counter-clockwise about a point; not at all about one that is on it.
fn winding(edges: &[ExpandedEdge], p: Drawn) -> i32 {
    let mut turns = 0;
    for edge in edges {
        let [a, b] = edge
            .aside
            .ends(edge.a, edge.b)
            .map(|end| end.vector_from(p));
        let wide = |(x, y): (i64, i64)| (i128::from(x), i128::from(y));
        let ((ax, ay), (bx, by)) = (wide(a), wide(b));
        let side = ax * by - ay * bx;
        if side == 0 && ax * bx + ay * by <= 0 {
            return 0;
        }
        // The crossings of the ray from p to the right; half-open in y, so that corners count once.
        if ay <= 0 && by > 0 && side > 0 {
            turns += 1;
        } else if by <= 0 && ay > 0 && side < 0 {
            turns -= 1;
        }
    }
    turns
}

/// Whether a rise over a run, both in parts and neither negative, is at most a slope: of a slope in decimals exactly.
#[inline]
pub fn rises_at_most(rise: i64, run: i64, slope: f64) -> bool {
    let (rise, run) = (rise as f64, run as f64);
    let excess = rise - slope * run;
    // Both products below are rounded; nearer than that only the decimals of the slope tell.
    if excess.abs() > 1e-12 * rise {
        return excess < 0.0;
    }
    let millionths = (slope * 1e6).round();
    match (millionths - slope * 1e6).abs() <= 1e-9 * millionths {
        true => (rise as i128) * 1_000_000 <= (millionths as i128) * (run as i128),
        false => excess <= 0.0,
    }
}

/// A height to be compared with a limit, in parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Height {
    /// Of a corner or a level edge on the grid.
    OnGrid(i64),
    /// Of a corner or a level edge drawn in decimals.
    Drawn(i64),
    /// Of a crossing, or of something that moves: the grid's.
    Rounded(i64),
}

impl Height {
    /// Of a drawn point.
    pub fn of(drawn: Drawn) -> Height {
        match drawn.y % PER_STEP {
            0 => Height::OnGrid(drawn.y),
            _ => Height::Drawn(drawn.y),
        }
    }

    /// Of a vertex that nobody drew.
    pub fn rounded(p: Point) -> Height {
        Height::Rounded(i64::from(p.y) * PER_STEP)
    }

    fn parts(self) -> i64 {
        match self {
            Height::OnGrid(y) | Height::Drawn(y) | Height::Rounded(y) => y,
        }
    }

    /// Whether this is at most `limit` metres above another one.
    pub fn is_within(self, limit: f64, above: Height) -> bool {
        let rise = self.parts() - above.parts();
        rise <= match (self, above) {
            (Height::OnGrid(_), Height::OnGrid(_)) => (limit / STEP).round() as i64 * PER_STEP,
            (Height::Rounded(_), _) | (_, Height::Rounded(_)) => length(limit) + SLACK * PER_STEP,
            _ => length(limit),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, y: f64) -> Drawn {
        Drawn::of(DVec2::new(x, y)).unwrap()
    }

    #[test]
    fn micrometres_and_steps_are_both_whole() {
        assert_eq!(at(0.1, -3.2).metres(), DVec2::new(0.1, -3.2));
        assert_eq!(at(0.1 + 0.2, 0.0), at(0.3, 0.0), "whatever a sum left");
        let point = Point::new(1, -BOUND + 1);
        let drawn = Drawn::of(point.metres()).unwrap();
        assert_eq!((drawn, drawn.point()), (Drawn::from(point), point));
        assert_eq!(drawn.metres(), point.metres());
        assert_eq!(Drawn::of(DVec2::new(4096.0, 0.0)), None);
        assert_eq!(Drawn::of(DVec2::new(4095.999995, 0.0)), None, "on the grid");
        assert_eq!(Drawn::of(DVec2::new(0.0, f64::NAN)), None);
    }

    #[test]
    fn the_next_grid_point_is_the_one_that_positions_have() {
        for k in -2_000..2_000 {
            let p = DVec2::new(f64::from(k) * 0.3571, f64::from(k) * -1.0007);
            let drawn = Drawn::of(p).unwrap();
            assert_eq!(Some(drawn.point()), Point::snap(drawn.metres()));
            assert_eq!(Drawn::beside(drawn.point(), drawn.aside()), drawn);
            let mirrored = Drawn::of(DVec2::new(-p.x, p.y)).unwrap();
            assert_eq!(
                mirrored.point(),
                Point::new(-drawn.point().x, drawn.point().y)
            );
        }
    }

    #[test]
    fn a_slope_in_decimals_is_met_exactly() {
        // Whole numbers of parts up to the width of the world, at slopes of up to six places.
        for (slope, millionths) in [
            (1.0, 1_000_000),
            (0.7, 700_000),
            (0.1, 100_000),
            (3.3, 3_300_000),
        ] {
            for run in [
                1_000_000,
                3_000_000,
                777_000_000,
                4_096_000_000_000 / 3 * 1_000_000 / 1_000_000,
            ] {
                let run = run / 1_000_000 * 1_000_000;
                let rise = run / 1_000_000 * millionths;
                assert!(rises_at_most(rise, run, slope), "{slope}, {run}");
                assert!(!rises_at_most(rise + 1, run, slope), "{slope}, {run}");
            }
        }
        assert!(rises_at_most(1, 3, 1.0 / 3.0) && !rises_at_most(2, 3, 1.0 / 3.0));
        assert!(rises_at_most(0, 5, 0.0) && !rises_at_most(1, 5, 0.0));
    }

    #[test]
    fn heights_are_compared_as_they_were_drawn() {
        let (low, high) = (Height::of(at(0.0, 0.9)), Height::of(at(0.0, 1.1)));
        assert!(high.is_within(0.2, low));
        assert!(!Height::of(at(0.0, 1.100001)).is_within(0.2, low));
        // On the grid the limit is the nearest to it: 0.35 m are 22937.6 steps.
        let [base, top] = [0, 22_938].map(|y| Height::of(Drawn::from(Point::new(0, y))));
        assert!(top.is_within(0.35, base) && !top.is_within(0.3499, base));
        // A crossing is known to a step.
        let crossing = |y| Height::rounded(Point::new(0, y));
        assert!(crossing(13_109).is_within(0.2, base) && !crossing(13_110).is_within(0.2, base));
    }
}
