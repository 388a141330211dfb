//! Box2D v3's character mover, as its documentation describes it and its sample drives it: collect the planes around a
//! capsule, solve for the displacement that satisfies them, cast the capsule by it, and again until little moves; then
//! clip the velocity. The C functions are called directly, so that no wrapper is timed with them.

#![allow(unsafe_code, reason = "Box2D is a C library")]

use super::walker::{Moved, Rule, Slide, Walker};
use super::{Maker, Mover};
use crate::scene::{Form, Scene, Shape, collider, is_convex};
use boxdd_sys::ffi::*;
use glam::DVec2;
use std::ffi::c_void;

/// Rounds of planes and cast in one move, and the move below which no other follows, m: those of the sample.
const ROUNDS: usize = 5;
const TOLERANCE: f32 = 0.01;

/// More planes than this are left out, as in the sample.
const PLANES: usize = 8;

/// Box2D refuses segments that are not longer than its linear slop, m.
const SHORTEST: f64 = 0.005;

const SETTINGS: &str = "capsule 13/16 m wide and 29/16 m high; at most 5 rounds of `b2World_CollideMover`, `b2SolvePlanes` \
    (rigid planes) and `b2World_CastMover`, tolerance 0.01 m and 8 planes as in its sample; then `b2ClipVector`. Convex outlines \
    of up to 8 corners are polygons, others loops of segments \
    (those not longer than 5 mm left out: Box2D refuses them). The C functions are called directly";

/// A world of static shapes, and one body that may move.
pub struct Box2d {
    world: b2WorldId,
    moving: b2BodyId,
    capsule: b2Capsule,
    filter: b2QueryFilter,
    planes: Vec<b2CollisionPlane>,
}

pub fn maker() -> Maker {
    Maker {
        name: "Box2D",
        settings: SETTINGS,
        make: |scene| walker(scene, "Box2D", Rule::Euler),
    }
}

pub fn middle_maker() -> Maker {
    Maker {
        name: "Box2D, mean velocity",
        settings: "the same, moved by the mean of the velocities before and after the tick instead of semi-implicit Euler",
        make: |scene| walker(scene, "Box2D, mean velocity", Rule::Middle),
    }
}

fn walker(scene: &Scene, name: &'static str, rule: Rule) -> Result<Box<dyn Mover>, &'static str> {
    let form = Form::of(&collider());
    let mover = Box2d::new(
        &form,
        &scene.solids,
        scene.lift.as_ref().map(|lift| &lift.outline[..]),
    );
    Ok(Box::new(Walker::new(mover, name, rule, scene)))
}

fn vector(p: DVec2) -> b2Vec2 {
    b2Vec2 {
        x: p.x as f32,
        y: p.y as f32,
    }
}

fn metres(p: b2Vec2) -> DVec2 {
    DVec2::new(f64::from(p.x), f64::from(p.y))
}

impl Box2d {
    /// A world of outlines, one of which may move, and a capsule as wide and as high as a form.
    pub fn new(form: &Form, solids: &[Vec<DVec2>], moving: Option<&[DVec2]>) -> Box2d {
        // SAFETY: plain calls in the order of the manual; all definitions come from Box2D's own defaults.
        let (world, still, carrier, filter) = unsafe {
            let world = b2CreateWorld(&b2DefaultWorldDef());
            let still = b2CreateBody(world, &b2DefaultBodyDef());
            let kinematic = b2BodyDef {
                type_: b2BodyType_b2_kinematicBody,
                ..b2DefaultBodyDef()
            };
            (
                world,
                still,
                b2CreateBody(world, &kinematic),
                b2DefaultQueryFilter(),
            )
        };
        solids.iter().for_each(|outline| add(still, outline));
        moving.into_iter().for_each(|outline| add(carrier, outline));
        let size = form.size();
        let radius = size.x as f32;
        Box2d {
            world,
            moving: carrier,
            capsule: b2Capsule {
                center1: b2Vec2 { x: 0.0, y: radius },
                center2: b2Vec2 {
                    x: 0.0,
                    y: size.y as f32 - radius,
                },
                radius,
            },
            filter,
            planes: Vec::with_capacity(PLANES),
        }
    }
}

impl Drop for Box2d {
    fn drop(&mut self) {
        // SAFETY: the world is ours, and goes once.
        unsafe { b2DestroyWorld(self.world) }
    }
}

/// A shape for an outline: a polygon if its hull has kept every corner, else all of its sides.
fn add(body: b2BodyId, outline: &[DVec2]) {
    let points: Vec<b2Vec2> = outline.iter().map(|&p| vector(p)).collect();
    // SAFETY: the points live through the calls, and a polygon is made of a valid hull only.
    unsafe {
        let definition = b2DefaultShapeDef();
        if outline.len() <= 8 && is_convex(outline) {
            let hull = b2ComputeHull(points.as_ptr(), points.len() as i32);
            if hull.count as usize == points.len() {
                b2CreatePolygonShape(body, &definition, &b2MakePolygon(&hull, 0.0));
                return;
            }
        }
        for i in 0..points.len() {
            let segment = b2Segment {
                point1: points[i],
                point2: points[(i + 1) % points.len()],
            };
            let along = outline[i].distance(outline[(i + 1) % points.len()]);
            if along > SHORTEST {
                b2CreateSegmentShape(body, &definition, &segment);
            }
        }
    }
}

unsafe extern "C" fn collect(
    _: b2ShapeId,
    result: *const b2PlaneResult,
    context: *mut c_void,
) -> bool {
    // SAFETY: Box2D passes on the pointer that `slide` gave it, and a result that lives through the call.
    let (planes, result) = unsafe { (&mut *context.cast::<Vec<b2CollisionPlane>>(), &*result) };
    if result.hit && planes.len() < PLANES {
        planes.push(b2CollisionPlane {
            plane: result.plane,
            pushLimit: f32::MAX,
            push: 0.0,
            clipVelocity: true,
        });
    }
    true
}

impl Slide for Box2d {
    fn shape(&self) -> Shape {
        Shape::Capsule
    }

    fn slide(&mut self, at: DVec2, velocity: DVec2, delta: DVec2, _: f64) -> Moved {
        let mut here = vector(at);
        let target = vector(at + delta);
        let mut grounded = false;
        // SAFETY: `planes` is used by nobody else while Box2D fills it through the context pointer.
        let clipped = unsafe {
            for _ in 0..ROUNDS {
                self.planes.clear();
                let context = (&raw mut self.planes).cast::<c_void>();
                b2World_CollideMover(
                    self.world,
                    here,
                    &self.capsule,
                    self.filter,
                    Some(collect),
                    context,
                );
                let wish = b2Vec2 {
                    x: target.x - here.x,
                    y: target.y - here.y,
                };
                let count = self.planes.len() as i32;
                let solved = b2SolvePlanes(wish, self.planes.as_mut_ptr(), count).translation;
                let fraction =
                    b2World_CastMover(self.world, here, &self.capsule, solved, self.filter);
                let step = b2Vec2 {
                    x: fraction * solved.x,
                    y: fraction * solved.y,
                };
                (here.x, here.y) = (here.x + step.x, here.y + step.y);
                if step.x * step.x + step.y * step.y < TOLERANCE * TOLERANCE {
                    break;
                }
            }
            grounded |= self.planes.iter().any(|plane| plane.plane.normal.y > 0.7);
            b2ClipVector(
                vector(velocity),
                self.planes.as_ptr(),
                self.planes.len() as i32,
            )
        };
        Moved {
            at: metres(here),
            velocity: metres(clipped),
            grounded,
        }
    }

    fn carry(&mut self, offset: DVec2, _: f64) {
        // SAFETY: a body of this world.
        unsafe { b2Body_SetTransform(self.moving, vector(offset), b2Rot { c: 1.0, s: 0.0 }) }
    }
}
