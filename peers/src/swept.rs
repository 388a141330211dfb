//! Our mover with pieces taken out: a point in the same mesh, but moved by straight sweeps, with a velocity that is changed once a
//! tick. What it lacks is what exactness costs.

use crate::movers::Mover;
use crate::movers::walker::{Rule, integrate};
use crate::scene::{Scene, Shape, collider, snapped};
use edgewalker::geom::expand;
use edgewalker::mesh::{Cast, FaceId, Mesh, Place};
use glam::DVec2;

/// Sweeps in one tick.
const SWEEPS: usize = 8;

/// What is swapped.
#[derive(Clone, Copy)]
pub struct Pieces {
    pub name: &'static str,
    pub rule: Rule,
    /// Positions and velocities have 32 bits.
    pub single: bool,
}

pub struct Swept {
    mesh: Mesh,
    scene: Scene,
    pieces: Pieces,
    at: DVec2,
    velocity: DVec2,
    face: Option<FaceId>,
}

impl Swept {
    pub fn new(scene: &Scene, pieces: Pieces) -> Swept {
        let grown = scene
            .solids
            .iter()
            .map(|o| expand(&snapped(o).expect("near the origin"), &collider()));
        Swept {
            mesh: Mesh::build(&grown.collect::<Vec<_>>()).expect("near the origin"),
            scene: scene.clone(),
            pieces,
            at: scene.start,
            velocity: scene.velocity,
            face: None,
        }
    }

    fn round(&self, p: DVec2) -> DVec2 {
        match self.pieces.single {
            true => p.as_vec2().as_dvec2(),
            false => p,
        }
    }

    /// The distance that is kept from surfaces, m: without a discrete place a position must not touch one, or it may be
    /// inside by rounding.
    fn skin(&self) -> f64 {
        if self.pieces.single { 1e-4 } else { 1e-9 }
    }
}

impl Mover for Swept {
    fn name(&self) -> &'static str {
        self.pieces.name
    }

    fn shape(&self) -> Shape {
        Shape::Box
    }

    fn reset(&mut self) {
        let above = DVec2::new(0.0, self.skin());
        (self.at, self.velocity, self.face) = (self.scene.start + above, self.scene.velocity, None);
    }

    fn tick(&mut self, rate: f64, _: u32) {
        let gravity = DVec2::new(0.0, -self.scene.gravity);
        let (mut left, after) = integrate(self.velocity, gravity, 1.0 / rate, self.pieces.rule);
        self.velocity = self.round(after);
        for _ in 0..SWEEPS {
            let to = self.round(self.at + left);
            let Cast::Hit(hit) = self.mesh.cast(self.at, to, self.face) else {
                self.at = to;
                break;
            };
            let (a, b) = self.mesh.ends(hit.edges[0]);
            let normal = (b.metres() - a.metres()).perp().normalize();
            left = (to - hit.point) - normal * (to - hit.point).dot(normal);
            self.velocity = self.round(self.velocity - normal * self.velocity.dot(normal).min(0.0));
            self.at = self.round(hit.point + normal * self.skin());
        }
        if let Some(Place::Face(face)) = self.mesh.locate(self.at, self.face) {
            self.face = Some(face);
        }
    }

    fn at(&self) -> DVec2 {
        self.at
    }
}
