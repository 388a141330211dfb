//! A bare copy of a mesh for experiments: triangles, neighbours, points. Its sweep takes any predicate, and its free edges can
//! be flipped out of the Delaunay order.

use crate::reference::worlds::Dice;
use edgewalker::geom::predicates::{line_side, orient2d, side};
use edgewalker::geom::{Point, STEP};
use edgewalker::mesh::{FaceId, Mesh};
use glam::DVec2;
use std::cmp::Ordering;

/// Nothing beyond.
const NONE: u32 = u32::MAX;

/// Triangles, counter-clockwise; side i of a triangle goes from its corner i to the next.
#[derive(Clone)]
pub struct Flat {
    corners: Vec<[u32; 3]>,
    /// Beyond each side.
    beyond: Vec<[u32; 3]>,
    /// Whether a side must stay.
    fixed: Vec<[bool; 3]>,
    points: Vec<Point>,
    /// By face of the mesh that it is a copy of.
    index: Vec<u32>,
}

/// The sides that a sweep asks for: of a point relative to the line, and of the target relative to an edge.
pub trait Sides {
    fn of_point(from: DVec2, to: DVec2, p: Point) -> Ordering;
    fn of_target(a: Point, b: Point, to: DVec2) -> Ordering;
}

/// Adaptive exact arithmetic, as the core uses it.
pub struct Exact;

/// Plain 64-bit arithmetic.
pub struct Double;

/// Plain 32-bit arithmetic.
pub struct Single;

impl Sides for Exact {
    #[inline]
    fn of_point(from: DVec2, to: DVec2, p: Point) -> Ordering {
        line_side(from, to, p)
    }
    #[inline]
    fn of_target(a: Point, b: Point, to: DVec2) -> Ordering {
        side(a, b, to)
    }
}

impl Sides for Double {
    #[inline]
    fn of_point(from: DVec2, to: DVec2, p: Point) -> Ordering {
        let p = DVec2::new(f64::from(p.x), f64::from(p.y));
        (to - from).perp_dot(p - from).total_cmp(&0.0)
    }
    #[inline]
    fn of_target(a: Point, b: Point, to: DVec2) -> Ordering {
        let [a, b] = [a, b].map(|p| DVec2::new(f64::from(p.x), f64::from(p.y)));
        (b - a).perp_dot(to - a).total_cmp(&0.0)
    }
}

impl Sides for Single {
    #[inline]
    fn of_point(from: DVec2, to: DVec2, p: Point) -> Ordering {
        let (from, to) = (from.as_vec2(), to.as_vec2());
        (to - from)
            .perp_dot(glam::Vec2::new(p.x as f32, p.y as f32) - from)
            .total_cmp(&0.0)
    }
    #[inline]
    fn of_target(a: Point, b: Point, to: DVec2) -> Ordering {
        let [a, b] = [a, b].map(|p| glam::Vec2::new(p.x as f32, p.y as f32));
        (b - a).perp_dot(to.as_vec2() - a).total_cmp(&0.0)
    }
}

impl Flat {
    pub fn new(mesh: &Mesh) -> Flat {
        let faces: Vec<FaceId> = mesh.faces().collect();
        let mut index = vec![NONE; faces.iter().map(|f| f.0 as usize + 1).max().unwrap_or(0)];
        (0..).zip(&faces).for_each(|(i, f)| index[f.0 as usize] = i);
        let inside = |f: Option<FaceId>| {
            f.and_then(|f| index.get(f.0 as usize))
                .copied()
                .unwrap_or(NONE)
        };
        let of = |f: &FaceId| mesh.sides(*f);
        let ids = mesh.vertices().map(|v| v.0 as usize + 1).max().unwrap_or(0);
        let mut all = vec![Point::new(0, 0); ids];
        mesh.vertices()
            .for_each(|v| all[v.0 as usize] = mesh.point(v));
        Flat {
            corners: faces
                .iter()
                .map(|f| of(f).map(|e| mesh.origin(e).0))
                .collect(),
            beyond: faces
                .iter()
                .map(|f| of(f).map(|e| inside(mesh.left(mesh.sym(e)))))
                .collect(),
            fixed: faces
                .iter()
                .map(|f| of(f).map(|e| mesh.uses(e).next().is_some()))
                .collect(),
            points: all,
            index,
        }
    }

    /// The copy of a face.
    pub fn face(&self, face: FaceId) -> u32 {
        self.index[face.0 as usize]
    }

    fn point(&self, face: u32, corner: usize) -> Point {
        self.points[self.corners[face as usize][corner % 3] as usize]
    }

    /// Goes from inside a face straight to a position, in steps: the last face and how many edges were crossed. `None` if
    /// it loses its way.
    pub fn sweep<S: Sides>(&self, face: u32, from: DVec2, to: DVec2) -> Option<(u32, usize)> {
        let right = |i: usize| S::of_point(from, to, self.point(face, i)) != Ordering::Greater;
        let mut exit = (0..3).find(|&i| right(i) && !right((i + 1) % 3))?;
        let (mut here, mut crossed) = (face, 0);
        while S::of_target(self.point(here, exit), self.point(here, exit + 1), to) == Ordering::Less
        {
            let there = self.beyond[here as usize][exit];
            if there == NONE || crossed > self.corners.len() {
                return None;
            }
            let entry = self.beyond[there as usize]
                .iter()
                .position(|&f| f == here)?;
            crossed += 1;
            // The apex is the corner after the end of the side that was come through.
            let apex = self.point(there, entry + 2);
            let left = S::of_point(from, to, apex) == Ordering::Greater;
            exit = if left { entry + 1 } else { entry + 2 } % 3;
            here = there;
        }
        Some((here, crossed))
    }

    /// Whether a position, in steps, is in a face or on its border.
    pub fn holds(&self, face: u32, p: DVec2) -> bool {
        (0..3).all(|i| side(self.point(face, i), self.point(face, i + 1), p) != Ordering::Less)
    }

    /// The copy of the face that holds a position, by looking at all.
    pub fn find(&self, p: DVec2) -> Option<u32> {
        (0..self.corners.len() as u32).find(|&f| self.holds(f, p))
    }

    /// Flips free edges at random, as many times as there are faces, wherever the quadrangle is convex.
    pub fn scramble(&mut self, seed: u64) {
        let mut dice = Dice::new(seed);
        for _ in 0..self.corners.len() {
            let face = dice.below(self.corners.len() as u32) as u32;
            self.flip(face, dice.below(3) as usize);
        }
    }

    fn flip(&mut self, f: u32, i: usize) {
        let g = self.beyond[f as usize][i];
        if g == NONE || self.fixed[f as usize][i] {
            return;
        }
        let Some(j) = self.beyond[g as usize].iter().position(|&face| face == f) else {
            return;
        };
        // From o to d, with l on the left in f and r on the right in g.
        let [fc, gc] = [self.corners[f as usize], self.corners[g as usize]];
        let (o, d, l, r) = (fc[i], fc[(i + 1) % 3], fc[(i + 2) % 3], gc[(j + 2) % 3]);
        let at = |v: u32| self.points[v as usize];
        if orient2d(at(r), at(d), at(l)) <= 0 || orient2d(at(l), at(o), at(r)) <= 0 {
            return;
        }
        let of = |all: &[[u32; 3]], face: u32, side: usize| all[face as usize][side % 3];
        let fixed = |face: u32, side: usize| self.fixed[face as usize][side % 3];
        let (dl, lo) = (of(&self.beyond, f, i + 1), of(&self.beyond, f, i + 2));
        let (or, rd) = (of(&self.beyond, g, j + 1), of(&self.beyond, g, j + 2));
        let (new_f, new_g) = (
            [false, fixed(g, j + 2), fixed(f, i + 1)],
            [false, fixed(f, i + 2), fixed(g, j + 1)],
        );
        self.corners[f as usize] = [l, r, d];
        self.corners[g as usize] = [r, l, o];
        self.beyond[f as usize] = [g, rd, dl];
        self.beyond[g as usize] = [f, lo, or];
        (self.fixed[f as usize], self.fixed[g as usize]) = (new_f, new_g);
        for (outside, old, new) in [(rd, g, f), (lo, f, g)] {
            if outside != NONE {
                let sides = &mut self.beyond[outside as usize];
                sides
                    .iter_mut()
                    .filter(|face| **face == old)
                    .for_each(|face| *face = new);
            }
        }
    }
}

/// A position in steps.
pub fn steps(p: DVec2) -> DVec2 {
    p / STEP
}
