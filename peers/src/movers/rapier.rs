//! Rapier's kinematic character controller, as its guide drives it: ask for a translation, take what it grants.

use super::walker::{Moved, Rule, Slide, Walker};
use super::{Maker, Mover};
use crate::scene::{Form, Scene, Shape, collider as box_collider, is_convex};
use glam::DVec2;
use rapier2d::control::{CharacterCollision, KinematicCharacterController};
use rapier2d::prelude::*;

const SETTINGS: &str = "box 13/16 by 29/16 m; all defaults of the controller: offset 1 % of the height, slopes to 45 degrees, snap to \
    ground 20 % of the height, no autostep; where a scene slides on a slope, `min_slope_slide_angle` and `max_slope_climb_angle` 0 and \
    no snap. Convex outlines are convex polygons (`convex_polyline_unmodified`), others polylines. Who stands has no \
    gravity, and every surface that was hit takes the velocity into it";

/// The outlines as a world of Rapier's.
pub struct Solids {
    pub world: PhysicsWorld,
    pub moving: Option<RigidBodyHandle>,
}

impl Solids {
    pub fn new(solids: &[Vec<DVec2>], moving: Option<&[DVec2]>) -> Solids {
        let mut world = PhysicsWorld::new();
        for outline in solids {
            world.insert_collider(collider(outline), None);
        }
        let moving = moving.map(|outline| {
            let body = world.insert_body(RigidBodyBuilder::kinematic_position_based());
            world.insert_collider(collider(outline), Some(body));
            body
        });
        // The first step puts the colliders into the tree that queries look in.
        world.gravity = Vector::ZERO;
        world.step();
        Solids { world, moving }
    }

    /// Moves what moves, through a step of the world, as the guide asks for kinematic bodies.
    pub fn carry(&mut self, offset: DVec2, dt: f64) {
        let Some(handle) = self.moving else { return };
        self.world.bodies[handle]
            .set_next_kinematic_position(Pose::from_translation(single(offset)));
        self.world.integration_parameters.dt = dt as f32;
        self.world.step();
    }
}

pub fn single(p: DVec2) -> Vector {
    Vector::new(p.x as f32, p.y as f32)
}

pub fn double(p: Vector) -> DVec2 {
    DVec2::new(f64::from(p.x), f64::from(p.y))
}

fn collider(outline: &[DVec2]) -> ColliderBuilder {
    let points: Vec<Vector> = outline.iter().map(|&p| single(p)).collect();
    let n = points.len() as u32;
    let loop_of = |points| {
        let sides = (0..n).map(|i| [i, (i + 1) % n]).collect();
        ColliderBuilder::polyline(points, Some(sides))
    };
    match is_convex(outline) {
        true => ColliderBuilder::new(convex(points)),
        false => loop_of(points),
    }
}

/// A convex polygon with all of its corners. The constructor without `unmodified` leaves out corners that bend by less than 1.5
/// degrees, without a word, and makes nothing of 257 corners or more.
fn convex(points: Vec<Vector>) -> SharedShape {
    let count = points.len();
    let shape = SharedShape::convex_polyline_unmodified(points).expect("three corners or more");
    let kept = shape
        .as_convex_polygon()
        .map(|polygon| polygon.points().len());
    assert_eq!(kept, Some(count), "corners that the peer has kept");
    shape
}

/// A form as a shape about its middle.
pub fn shape_of(form: &Form) -> SharedShape {
    let size = form.size();
    if form.corners.len() == 4 {
        return SharedShape::cuboid(size.x as f32, (0.5 * size.y) as f32);
    }
    let corners = form.corners.iter().map(|&p| single(p - form.middle()));
    convex(corners.collect())
}

pub struct Rapier {
    solids: Solids,
    controller: KinematicCharacterController,
    shape: SharedShape,
    /// From the foot to the middle, m.
    middle: DVec2,
    /// On walkable ground after the last move: then gravity is left out, as the guide's examples do.
    stands: bool,
    /// Speed down at which it is moved while it stands, m/s.
    press: f64,
}

/// The controller looks for ground only where a movement goes down. So who stands may be moved down a little: 0.3 m/s.
const PRESS: f64 = 0.3;

pub fn maker() -> Maker {
    Maker {
        name: "Rapier",
        settings: SETTINGS,
        make: |scene| walker(scene, "Rapier", Rule::Euler, 0.0),
    }
}

pub fn pressed_maker() -> Maker {
    Maker {
        name: "Rapier, pressed down",
        settings: "the same as Rapier, but who stands is moved down at 0.3 m/s beside his walk: the controller snaps to ground only then",
        make: |scene| walker(scene, "Rapier, pressed down", Rule::Euler, PRESS),
    }
}

pub fn middle_maker() -> Maker {
    Maker {
        name: "Rapier, mean velocity",
        settings: "the same, moved by the mean of the velocities before and after the tick instead of semi-implicit Euler",
        make: |scene| walker(scene, "Rapier, mean velocity", Rule::Middle, 0.0),
    }
}

fn walker(
    scene: &Scene,
    name: &'static str,
    rule: Rule,
    press: f64,
) -> Result<Box<dyn Mover>, &'static str> {
    let form = Form::of(&box_collider());
    let mut mover = Rapier::new(
        &form,
        &scene.solids,
        scene.lift.as_ref().map(|lift| &lift.outline[..]),
    );
    mover.press = press;
    if scene.slides {
        mover.controller.min_slope_slide_angle = 0.0;
        mover.controller.max_slope_climb_angle = 0.0;
        mover.controller.snap_to_ground = None;
    }
    Ok(Box::new(Walker::new(mover, name, rule, scene)))
}

impl Rapier {
    /// The controller with its defaults.
    pub fn new(form: &Form, solids: &[Vec<DVec2>], moving: Option<&[DVec2]>) -> Rapier {
        Rapier {
            solids: Solids::new(solids, moving),
            controller: KinematicCharacterController::default(),
            shape: shape_of(form),
            middle: form.middle(),
            stands: false,
            press: 0.0,
        }
    }
}

impl Slide for Rapier {
    fn shape(&self) -> Shape {
        Shape::Box
    }

    fn slide(&mut self, at: DVec2, velocity: DVec2, delta: DVec2, dt: f64) -> Moved {
        let world = &self.solids.world;
        let queries = world.query_pipeline();
        let (start, mut wish, mut speed) = (single(at + self.middle), single(delta), velocity);
        if self.stands && wish.y <= 0.0 {
            (wish.y, speed.y) = ((-self.press * dt) as f32, 0.0);
        }
        let pose = Pose::from_translation(start);
        let note = |hit: CharacterCollision| {
            let normal = double(hit.hit.normal1);
            speed -= normal * speed.dot(normal).min(0.0);
        };
        let granted =
            self.controller
                .move_shape(dt as f32, &queries, &*self.shape, &pose, wish, note);
        self.stands = granted.grounded && self.controller.snap_to_ground.is_some();
        Moved {
            at: double(start + granted.translation) - self.middle,
            velocity: speed,
            grounded: granted.grounded,
        }
    }

    fn gap(&self) -> f64 {
        // One hundredth of the height, a little more for rounding.
        0.0101 * 2.0 * self.middle.y
    }

    fn carries_first(&self) -> bool {
        false
    }

    fn carry(&mut self, offset: DVec2, dt: f64) {
        self.solids.carry(offset, dt);
    }
}
