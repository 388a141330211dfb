//! Move and slide by Parry's shape casts: cast by what is left to go, go there, drop what goes into the surface, and again.

use super::Maker;
use super::rapier::{Solids, double, shape_of, single};
use super::walker::{Moved, Rule, Slide, Walker};
use crate::scene::{Form, Shape, collider};
use glam::DVec2;
use parry2d::bounding_volume::BoundingVolume;
use parry2d::query::{Contact, ShapeCastOptions, contact};
use rapier2d::prelude::{Pose, SharedShape, Vector};

/// Casts in one move.
const CASTS: usize = 4;

/// Gap that is kept to surfaces, m.
const SKIN: f32 = 1e-3;

/// How far a cast that follows a hit leans away from the surface, m.
const NUDGE: f32 = 1e-4;

/// How far down ground is looked for, m.
const PROBE: f32 = 5e-3;

const SETTINGS: &str = "box 13/16 by 29/16 m; first pushed out to 1.1 mm from what is nearer than 1 mm (`contact`), then at most 4 casts a move, `target_distance` 1 mm, all other options default; the rest of the \
    way and the velocity are projected on the surface that was hit, and on both where two were; ground is looked for 5 mm \
    below. The tree over the shapes is Rapier's";

pub struct Parry {
    solids: Solids,
    shape: SharedShape,
    middle: DVec2,
}

pub fn maker() -> Maker {
    Maker {
        name: "Parry",
        settings: SETTINGS,
        make: |scene| {
            let parry = Parry::new(
                &Form::of(&collider()),
                &scene.solids,
                scene.lift.as_ref().map(|lift| &lift.outline[..]),
            );
            Ok(Box::new(Walker::new(parry, "Parry", Rule::Euler, scene)))
        },
    }
}

impl Parry {
    pub fn new(form: &Form, solids: &[Vec<DVec2>], moving: Option<&[DVec2]>) -> Parry {
        Parry {
            solids: Solids::new(solids, moving),
            shape: shape_of(form),
            middle: form.middle(),
        }
    }
}

impl Parry {
    /// The way back to the gap, from whatever is nearer than that.
    fn recover(&self, here: Vector) -> Vector {
        let queries = self.solids.world.query_pipeline();
        let mut by = Vector::ZERO;
        for _ in 0..CASTS {
            let pose = Pose::from_translation(here + by);
            let around = self.shape.compute_aabb(&pose).loosened(SKIN);
            let mut worst: Option<Contact> = None;
            for (_, collider) in queries.intersect_aabb_conservative(around) {
                let found = contact(
                    &pose,
                    &*self.shape,
                    collider.position(),
                    collider.shape(),
                    SKIN,
                );
                if let Ok(Some(found)) = found
                    && found.dist < worst.map_or(SKIN, |worst| worst.dist)
                {
                    worst = Some(found);
                }
            }
            let Some(worst) = worst else { break };
            by += worst.normal2 * (SKIN + NUDGE - worst.dist);
        }
        by
    }
}

impl Slide for Parry {
    fn shape(&self) -> Shape {
        Shape::Box
    }

    fn slide(&mut self, at: DVec2, velocity: DVec2, delta: DVec2, _: f64) -> Moved {
        let queries = self.solids.world.query_pipeline();
        let (mut here, mut left, mut speed) =
            (single(at + self.middle), single(delta), single(velocity));
        let (mut normals, mut grounded): (Vec<Vector>, bool) = (Vec::new(), false);
        here += self.recover(here);
        for _ in 0..CASTS {
            let options = ShapeCastOptions {
                target_distance: SKIN,
                max_time_of_impact: 1.0,
                stop_at_penetration: false,
                compute_impact_geometry_on_penetration: true,
            };
            let pose = Pose::from_translation(here);
            let Some((_, hit)) = queries.cast_shape(&pose, left, &*self.shape, options) else {
                here += left;
                break;
            };
            here += left * hit.time_of_impact;
            left *= 1.0 - hit.time_of_impact;
            normals.push(hit.normal1);
            grounded |= hit.normal1.y > 0.7;
            (left, speed) = (along(left, &normals), along(speed, &normals));
            left += hit.normal1 * NUDGE;
        }
        if !grounded {
            let pose = Pose::from_translation(here);
            let down = ShapeCastOptions::with_max_time_of_impact(1.0);
            let floor = queries.cast_shape(&pose, Vector::new(0.0, -PROBE), &*self.shape, down);
            grounded = floor.is_some_and(|(_, hit)| hit.normal1.y > 0.7) && speed.y <= 0.0;
        }
        Moved {
            at: double(here) - self.middle,
            velocity: double(speed),
            grounded,
        }
    }

    fn gap(&self) -> f64 {
        f64::from(SKIN + NUDGE)
    }

    fn carry(&mut self, offset: DVec2, dt: f64) {
        self.solids.carry(offset, dt);
    }
}

/// What of a vector goes into none of the surfaces: nothing, where each way along one goes into another.
fn along(vector: Vector, normals: &[Vector]) -> Vector {
    let rounding = 1e-5 * vector.length();
    let free = |v: Vector| normals.iter().all(|&n| v.dot(n) >= -rounding);
    if free(vector) {
        return vector;
    }
    let mut slides = normals.iter().map(|&n| vector - n * vector.dot(n));
    slides.find(|&v| free(v)).unwrap_or(Vector::ZERO)
}
