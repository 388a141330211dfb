//! A scene: solids, a body, what drives it, and where it should be at each time.

use edgewalker::geom::{Collider, Point, expand};
use edgewalker::mesh::Mesh;
use edgewalker::motion::Piece;
use glam::DVec2;
use std::sync::Arc;

/// Half the width of the body, and its height, m: on the grid, and exact in 32 bits.
pub const HALF: f64 = 13.0 / 32.0;
pub const TALL: f64 = 29.0 / 16.0;

/// The shapes that the movers have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    Box,
    /// Upright, as wide and as high as the box.
    Capsule,
}

impl Shape {
    /// How far the middle of the foot is from a line that the shape touches with its normal towards the shape, along that
    /// normal, m.
    pub fn reach(self, n: DVec2) -> f64 {
        match self {
            Shape::Box => HALF * n.x.abs() + TALL * (-n.y).max(0.0),
            Shape::Capsule => HALF + (-n.y * HALF).max(-n.y * (TALL - HALF)),
        }
    }

    /// Where the foot leaves level ground that ends at x = 0 and bends or drops away, m: a capsule that is fast enough flies
    /// from where its middle passes the end, a box from where its rear corner does.
    pub fn leaves_at(self) -> f64 {
        match self {
            Shape::Box => HALF,
            Shape::Capsule => 0.0,
        }
    }
}

/// A convex shape about the middle of its foot.
#[derive(Clone, Debug)]
pub struct Form {
    /// Counter-clockwise, m.
    pub corners: Vec<DVec2>,
}

impl Form {
    pub fn of(collider: &Collider) -> Form {
        let corners = collider.corners().iter().map(|p| p.metres());
        Form {
            corners: corners.collect(),
        }
    }

    /// Half its width, and its height, m: those of the capsule that Box2D gets.
    pub fn size(&self) -> DVec2 {
        self.corners
            .iter()
            .copied()
            .reduce(DVec2::max)
            .expect("corners")
    }

    /// From the foot to the middle, m.
    pub fn middle(&self) -> DVec2 {
        v(0.0, 0.5 * self.size().y)
    }
}

/// A solid that moves, from time 0 on.
#[derive(Clone)]
pub struct Lift {
    pub outline: Vec<DVec2>,
    pub pieces: Vec<Piece>,
    /// After this time it starts again, s.
    pub period: Option<f64>,
}

impl Lift {
    /// Its offset from where it is drawn, m.
    pub fn offset(&self, t: f64) -> DVec2 {
        let t = self
            .period
            .map_or(t, |period| t - (t / period).floor() * period);
        let after = self.pieces.partition_point(|piece| piece.t0 <= t);
        self.pieces[after.max(1) - 1].offset(t)
    }
}

/// Where a body of a shape should be at a time; `None` while the scene does not say.
pub type Exact = Arc<dyn Fn(Shape, f64) -> Option<DVec2> + Send + Sync>;

/// A scene.
#[derive(Clone)]
pub struct Scene {
    pub name: &'static str,
    /// What happens in it, in a sentence.
    pub what: &'static str,
    pub solids: Vec<Vec<DVec2>>,
    pub lift: Option<Lift>,
    /// The middle of the foot at time 0, and the velocity.
    pub start: DVec2,
    pub velocity: DVec2,
    /// It starts on the ground.
    pub stands: bool,
    /// A walk: the velocity along x that is wished all the time.
    pub walk: Option<f64>,
    pub gravity: f64,
    /// Bodies slide on its slopes as if on ice.
    pub slides: bool,
    /// Length of the run, s.
    pub seconds: f64,
    pub exact: Exact,
}

pub fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

pub fn rect(x: (f64, f64), y: (f64, f64)) -> Vec<DVec2> {
    vec![v(x.0, y.0), v(x.1, y.0), v(x.1, y.1), v(x.0, y.1)]
}

/// The box as a collider.
pub fn collider() -> Collider {
    let corners = [v(-HALF, 0.0), v(HALF, 0.0), v(HALF, TALL), v(-HALF, TALL)];
    let corners = corners.map(|p| Point::snap(p).expect("near the origin"));
    Collider::new(corners.to_vec()).expect("a convex box")
}

/// An outline on the grid; `None` if it leaves the world.
pub fn snapped(outline: &[DVec2]) -> Option<Vec<Point>> {
    outline.iter().map(|&p| Point::snap(p)).collect()
}

fn cross(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// Whether an outline, counter-clockwise, is strictly convex.
pub fn is_convex(outline: &[DVec2]) -> bool {
    let n = outline.len();
    (0..n).all(|i| cross(outline[i], outline[(i + 1) % n], outline[(i + 2) % n]) > 0.0)
}

/// An outline in convex pieces, counter-clockwise: itself, or triangles.
pub fn pieces(outline: &[DVec2]) -> Vec<Vec<DVec2>> {
    if is_convex(outline) {
        return vec![outline.to_vec()];
    }
    let corners = snapped(outline).expect("inside the world");
    let mesh = Mesh::build(&[expand(&corners, &Collider::point())]).expect("inside the world");
    let solid = mesh.faces().filter(|&f| mesh.is_solid(f));
    solid
        .map(|f| mesh.corners(f).map(Point::metres).to_vec())
        .collect()
}

/// Constant acceleration.
pub fn parabola(p: DVec2, v: DVec2, a: DVec2, t: f64) -> DVec2 {
    p + v * t + a * (0.5 * t * t)
}

/// A flight from a place until the body touches the line through the origin with a normal, then a slide along it without
/// friction.
#[derive(Clone, Copy)]
pub struct FlightAndSlide {
    pub from: DVec2,
    pub velocity: DVec2,
    pub gravity: f64,
    pub normal: DVec2,
}

impl FlightAndSlide {
    fn pull(&self) -> DVec2 {
        v(0.0, -self.gravity)
    }

    /// When the line is touched, s.
    pub fn lands(&self, shape: Shape) -> f64 {
        let c = self.normal.dot(self.from) - shape.reach(self.normal);
        let (b, a) = (
            self.normal.dot(self.velocity),
            0.5 * self.normal.dot(self.pull()),
        );
        // The later root, each time in the form in which nothing cancels.
        let root = (b * b - 4.0 * a * c).sqrt();
        match b > 0.0 {
            true => (-b - root) / (2.0 * a),
            false => 2.0 * c / (root - b),
        }
    }

    /// Where and how fast the slide starts, and its acceleration.
    pub fn slide(&self, shape: Shape) -> (DVec2, DVec2, DVec2) {
        let t = self.lands(shape);
        let flat = |w: DVec2| w - self.normal * w.dot(self.normal);
        let p = parabola(self.from, self.velocity, self.pull(), t);
        (p, flat(self.velocity + self.pull() * t), flat(self.pull()))
    }

    pub fn at(&self, shape: Shape, t: f64) -> DVec2 {
        let landing = self.lands(shape);
        if t <= landing {
            return parabola(self.from, self.velocity, self.pull(), t);
        }
        let (p, v, a) = self.slide(shape);
        parabola(p, v, a, t - landing)
    }
}
