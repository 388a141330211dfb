//! The usual hand-made approach: move, then push out of whatever is overlapped, by the shortest way, a few times.

use super::Maker;
use super::walker::{Moved, Rule, Slide, Walker};
use crate::scene::{Form, Shape, collider, pieces};
use glam::DVec2;
use std::collections::HashMap;

/// Pushes in one move.
const PUSHES: usize = 8;

/// Side of the squares that the pieces are sorted into, m.
const SQUARE: f64 = 2.0;

const SETTINGS: &str = "box 13/16 by 29/16 m, 64-bit; convex pieces in a hash of 2 m squares; at most 8 pushes a move, each out of the \
    piece that is overlapped deepest, by the shortest way (separating axes); a push takes the velocity into it";

pub struct PushOut {
    form: Form,
    /// Directions in which it may be pushed, besides those of the pieces.
    axes: Vec<DVec2>,
    pieces: Vec<Piece>,
    /// How many of the pieces stand still; the others move.
    still: usize,
    squares: HashMap<(i32, i32), Vec<u32>>,
    offset: DVec2,
}

/// A convex piece with its outward normals.
struct Piece {
    corners: Vec<DVec2>,
    normals: Vec<DVec2>,
}

pub fn maker() -> Maker {
    Maker {
        name: "push out",
        settings: SETTINGS,
        make: |scene| {
            let moving = scene.lift.as_ref().map(|lift| &lift.outline[..]);
            let push_out = PushOut::new(&Form::of(&collider()), &scene.solids, moving);
            Ok(Box::new(Walker::new(
                push_out,
                "push out",
                Rule::Euler,
                scene,
            )))
        },
    }
}

fn square(p: DVec2) -> (i32, i32) {
    ((p.x / SQUARE).floor() as i32, (p.y / SQUARE).floor() as i32)
}

impl PushOut {
    pub fn new(form: &Form, solids: &[Vec<DVec2>], moving: Option<&[DVec2]>) -> PushOut {
        let mut all: Vec<Piece> = solids
            .iter()
            .flat_map(|s| pieces(s))
            .map(Piece::new)
            .collect();
        let still = all.len();
        all.extend(moving.into_iter().flat_map(pieces).map(Piece::new));
        let mut squares: HashMap<(i32, i32), Vec<u32>> = HashMap::new();
        for (i, piece) in all[..still].iter().enumerate() {
            let fold =
                |f: fn(DVec2, DVec2) -> DVec2| piece.corners.iter().copied().reduce(f).unwrap();
            let (low, high) = (square(fold(DVec2::min)), square(fold(DVec2::max)));
            for x in low.0..=high.0 {
                for y in low.1..=high.1 {
                    squares.entry((x, y)).or_default().push(i as u32);
                }
            }
        }
        let axes = normals(&form.corners).into_iter().map(|n| -n).collect();
        PushOut {
            form: form.clone(),
            axes,
            pieces: all,
            still,
            squares,
            offset: DVec2::ZERO,
        }
    }

    /// The longest of the shortest ways out of all pieces that a box overlaps.
    fn deepest(&self, at: DVec2) -> Option<DVec2> {
        let mut deepest: Option<(f64, DVec2)> = None;
        let mut try_piece = |piece: &Piece, at: DVec2| {
            if let Some((depth, normal)) = self.way_out(piece, at)
                && deepest.is_none_or(|(other, _)| depth > other)
            {
                deepest = Some((depth, normal));
            }
        };
        let size = self.form.size();
        let (low, high) = (square(at - DVec2::new(size.x, 0.0)), square(at + size));
        for x in low.0..=high.0 {
            for y in low.1..=high.1 {
                for &i in self.squares.get(&(x, y)).into_iter().flatten() {
                    try_piece(&self.pieces[i as usize], at);
                }
            }
        }
        self.pieces[self.still..]
            .iter()
            .for_each(|piece| try_piece(piece, at - self.offset));
        deepest.map(|(depth, normal)| normal * depth)
    }
}

/// The outward normals of a convex outline.
fn normals(corners: &[DVec2]) -> Vec<DVec2> {
    let n = corners.len();
    let normal = |i: usize| -(corners[(i + 1) % n] - corners[i]).perp().normalize();
    (0..n).map(normal).collect()
}

impl Piece {
    fn new(corners: Vec<DVec2>) -> Piece {
        let normals = normals(&corners);
        Piece { corners, normals }
    }
}

impl PushOut {
    /// How deep the body is in a piece, and the direction of the shortest way out.
    fn way_out(&self, piece: &Piece, at: DVec2) -> Option<(f64, DVec2)> {
        let mut best: Option<(f64, DVec2)> = None;
        for &axis in piece.normals.iter().chain(&self.axes) {
            let far = |corners: &[DVec2], axis: DVec2| {
                corners
                    .iter()
                    .map(|c| c.dot(axis))
                    .fold(f64::NEG_INFINITY, f64::max)
            };
            let depth = far(&piece.corners, axis) + far(&self.form.corners, -axis) - at.dot(axis);
            if depth <= 0.0 {
                return None;
            }
            if best.is_none_or(|(other, _)| depth < other) {
                best = Some((depth, axis));
            }
        }
        best
    }
}

impl Slide for PushOut {
    fn shape(&self) -> Shape {
        Shape::Box
    }

    fn slide(&mut self, at: DVec2, velocity: DVec2, delta: DVec2, _: f64) -> Moved {
        let (mut here, mut speed, mut grounded) = (at + delta, velocity, false);
        for _ in 0..PUSHES {
            let Some(push) = self.deepest(here) else {
                break;
            };
            here += push;
            let normal = push.normalize_or_zero();
            speed -= normal * speed.dot(normal).min(0.0);
            grounded |= normal.y > 0.7;
        }
        Moved {
            at: here,
            velocity: speed,
            grounded,
        }
    }

    fn carry(&mut self, offset: DVec2, _: f64) {
        self.offset = offset;
    }
}
