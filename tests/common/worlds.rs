//! Families of worlds for tests and benchmarks: seeded, so that a failure names its world by number.

#![allow(dead_code, reason = "each test uses its own part")]

use edgewalker::geom::{Collider, ExpandedEdge, Point, Source, check_outline, expand};
use glam::DVec2;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// A generator of the numbers a test wants.
#[derive(Clone)]
pub struct Dice(Pcg32);

impl Dice {
    /// The generator of one test world.
    pub fn new(seed: u64) -> Self {
        Dice(Pcg32::new(seed, 0x6d65_7368))
    }

    /// An integer in 0..n.
    pub fn below(&mut self, n: u32) -> i32 {
        (self.0.next_u32() % n) as i32
    }

    /// A number in 0..1.
    pub fn unit(&mut self) -> f64 {
        f64::from(self.0.next_u32()) / 4_294_967_296.0
    }

    /// A number in a range.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A grid point with coordinates in 0..n.
    pub fn point(&mut self, n: u32) -> Point {
        Point::new(self.below(n), self.below(n))
    }
}

/// An outline in metres.
pub type Outline = Vec<DVec2>;

/// A polygon around a centre, star-shaped, with corners at the given distances.
pub fn star(dice: &mut Dice, centre: DVec2, corners: usize, near: f64, far: f64) -> Outline {
    let corner = |i: usize, dice: &mut Dice| {
        let turn = (i as f64 + dice.between(0.0, 0.9)) / corners as f64;
        centre + DVec2::from_angle(turn * std::f64::consts::TAU) * dice.between(near, far)
    };
    (0..corners).map(|i| corner(i, dice)).collect()
}

/// *random*: 3-6-gons of radius 0.5 to 4 in a box of half-width 4 sqrt(n).
pub fn random(dice: &mut Dice, n: usize) -> Vec<Outline> {
    let half = 4.0 * (n as f64).sqrt();
    (0..n)
        .map(|_| {
            let centre = DVec2::new(dice.between(-half, half), dice.between(-half, half));
            let corners = 3 + dice.below(4) as usize;
            let radius = dice.between(0.5, 4.0);
            star(dice, centre, corners, radius, radius)
        })
        .collect()
}

/// *sparse*: 3-6-gons on a lattice of 11 metres.
pub fn sparse(dice: &mut Dice, n: usize) -> Vec<Outline> {
    (0..n)
        .map(|i| {
            let centre = DVec2::new((i % 7) as f64, (i / 7) as f64) * 11.0;
            let corners = 3 + dice.below(4) as usize;
            star(dice, centre, corners, 2.0, 4.0)
        })
        .collect()
}

/// *slopes*: boxes and right triangles on a grid of half a metre: shared and collinear edges.
pub fn slopes(dice: &mut Dice, n: usize) -> Vec<Outline> {
    let side = 2 * (n as f64).sqrt() as u32 + 4;
    let half = |dice: &mut Dice, n: u32| f64::from(dice.below(n)) * 0.5;
    (0..n)
        .map(|_| {
            let (x, y) = (half(dice, side), half(dice, side));
            let (w, h) = (0.5 + half(dice, 6), 0.5 + half(dice, 4));
            let mut corners = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
                .map(DVec2::from)
                .to_vec();
            if dice.below(2) == 0 {
                corners.remove(dice.below(4) as usize);
            }
            corners
        })
        .collect()
}

/// *grid*: boxes with integer corners.
pub fn grid(dice: &mut Dice, n: usize) -> Vec<Outline> {
    let side = 2 * (n as f64).sqrt() as u32 + 2;
    (0..n)
        .map(|_| {
            let (x, y) = (f64::from(dice.below(side)), f64::from(dice.below(side)));
            let (w, h) = (
                1.0 + f64::from(dice.below(3)),
                1.0 + f64::from(dice.below(3)),
            );
            [(x, y), (x + w, y), (x + w, y + h), (x, y + h)]
                .map(DVec2::from)
                .to_vec()
        })
        .collect()
}

/// A crowd of overlapping octagons, as dense whatever their number: about 11 mesh vertices for each of them.
pub fn octagons(dice: &mut Dice, n: usize) -> Vec<Outline> {
    let half = octagons_half_width(n);
    (0..n).map(|_| octagon(dice, half)).collect()
}

/// Half the width of the square that the centres of [`octagons`] lie in, m.
pub fn octagons_half_width(n: usize) -> f64 {
    1.95 * (n as f64).sqrt()
}

/// One octagon of radius 0.5 to 4 with its centre in a square.
pub fn octagon(dice: &mut Dice, half: f64) -> Outline {
    let centre = DVec2::new(dice.between(-half, half), dice.between(-half, half));
    let radius = dice.between(0.5, 4.0);
    star(dice, centre, 8, radius * 0.8, radius)
}

/// A number that a long run by hand sets in the environment, and what it is otherwise.
pub fn setting(name: &str, default: usize) -> usize {
    std::env::var(name)
        .ok()
        .map_or(default, |s| s.parse().expect("a number"))
}

/// A family by name: worlds of some size by the dice.
pub type Family = (&'static str, fn(&mut Dice, usize) -> Vec<Outline>);

/// All families.
pub fn families() -> [Family; 4] {
    [
        ("sparse", sparse),
        ("random", random),
        ("slopes", slopes),
        ("grid", grid),
    ]
}

/// Moves a world and turns it by an angle in radians.
pub fn placed(world: &[Outline], offset: DVec2, angle: f64) -> Vec<Outline> {
    let turn = DVec2::from_angle(angle);
    world
        .iter()
        .map(|outline| outline.iter().map(|&p| turn.rotate(p) + offset).collect())
        .collect()
}

/// Snaps a world to the grid; outlines that are no longer simple are left out.
pub fn snapped(world: &[Outline]) -> Vec<Vec<Point>> {
    let snap = |outline: &Outline| {
        outline
            .iter()
            .map(|&p| Point::snap(p))
            .collect::<Option<Vec<Point>>>()
    };
    world
        .iter()
        .filter_map(snap)
        .filter(|outline| check_outline(outline).is_ok())
        .collect()
}

/// Expands all outlines of a world.
pub fn expanded(outlines: &[Vec<Point>], collider: &Collider) -> Vec<Vec<ExpandedEdge>> {
    outlines
        .iter()
        .map(|outline| expand(outline, collider))
        .collect()
}

/// A box as a collider, with its reference point in the middle.
pub fn centred_box(half_width: f64, half_height: f64) -> Collider {
    let p = |x: f64, y: f64| Point::snap(DVec2::new(x * half_width, y * half_height)).unwrap();
    Collider::new(vec![p(-1.0, -1.0), p(1.0, -1.0), p(1.0, 1.0), p(-1.0, 1.0)]).unwrap()
}

/// Loose segments as one feature: a wire.
pub fn wire(segments: &[(Point, Point)]) -> Vec<ExpandedEdge> {
    let edge = |(i, &(a, b)): (usize, &(Point, Point))| {
        ExpandedEdge::new(a, b, Source::Edge { edge: i as u32 })
    };
    segments.iter().enumerate().map(edge).collect()
}
