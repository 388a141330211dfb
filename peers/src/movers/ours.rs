//! Edgewalker's own mover.

use super::{Maker, Mover};
use crate::scene::{Scene, Shape, collider, snapped};
use edgewalker::geom::expand;
use edgewalker::mesh::{Kind, Mesh};
use edgewalker::motion::{self, Body, Control, Path, Terrain, Trace};
use edgewalker::tune::Motion;
use glam::DVec2;
use std::sync::Arc;

const SETTINGS: &str = "box 13/16 by 29/16 m; the scene's gravity, joints `ballistic`, whole gravity along slopes, no accelerations of its own";

struct Ours {
    mesh: Mesh,
    tuning: Motion,
    movers: Vec<motion::Mover>,
    start: Body,
    body: Body,
    trace: Trace,
}

pub fn maker() -> Maker {
    Maker {
        name: "Edgewalker",
        settings: SETTINGS,
        make: |scene| Ok(Box::new(Ours::new(scene)?)),
    }
}

/// Gravity, and nothing else that would act by itself.
pub fn tuning(gravity: f64) -> Motion {
    Motion {
        gravity,
        run_accel: 0.0,
        run_brake: 0.0,
        over_speed_decay: 0.0,
        air_accel: 0.0,
        air_brake: 0.0,
        apex_gravity: 1.0,
        fall_speed: 1e12,
        fast_fall_speed: 1e12,
        joint: 2.0,
        joint_stick: 0.0,
        slope_gravity: 1.0,
        floor_snap: 0.0,
        step_up: 0.0,
        corner_correction: 0.0,
        ledge_correction: 0.0,
        wall_slide_speed: 0.0,
        wall_jump_out: 0.0,
        wall_jump_up: 0.0,
        ledge_hang: 0.0,
        ledge_magnet: 0.0,
        ..Motion::default()
    }
}

fn terrain<'a>(mesh: &'a Mesh, tuning: &'a Motion, movers: &'a [motion::Mover]) -> Terrain<'a> {
    Terrain {
        movers,
        ..Terrain::new(mesh, mesh, tuning)
    }
}

impl Ours {
    fn new(scene: &Scene) -> Result<Ours, &'static str> {
        let grown = |outline: &[DVec2]| snapped(outline).map(|o| expand(&o, &collider()));
        let features = scene.solids.iter().map(|outline| grown(outline));
        let features: Option<Vec<_>> = features.collect();
        let features = features.ok_or("outside the world of 4 km")?;
        let mesh = Mesh::build(&features).map_err(|_| "outside the world of 4 km")?;
        let mut movers = Vec::new();
        if let Some(lift) = &scene.lift {
            let edges = grown(&lift.outline).ok_or("outside the world of 4 km")?;
            let id = scene.solids.len() as u32;
            let mesh =
                Arc::new(Mesh::of(&[(id, Kind::Solid, edges)]).map_err(|_| "outside the world")?);
            movers.push(motion::Mover {
                stand: Arc::clone(&mesh),
                crouch: mesh,
                path: Path {
                    pieces: lift.pieces.clone(),
                    period: lift.period,
                },
                start: Some(0.0),
            });
        }
        let tuning = tuning(scene.gravity);
        let mut trace = Trace::default();
        let ground = terrain(&mesh, &tuning, &movers);
        let mut body =
            Body::spawn(scene.start, 0.0, &ground).map_err(|_| "no room at the start")?;
        body.advance(0.0, &ground, &mut trace);
        body.set_velocity(scene.velocity, &ground, &mut trace);
        if scene.walk.is_some() {
            let run = scene.velocity.x.signum();
            body.apply(
                Control {
                    run,
                    ..Control::default()
                },
                &ground,
                &mut trace,
            );
        }
        Ok(Ours {
            start: body.clone(),
            mesh,
            tuning,
            movers,
            body,
            trace,
        })
    }
}

impl Mover for Ours {
    fn name(&self) -> &'static str {
        "Edgewalker"
    }

    fn shape(&self) -> Shape {
        Shape::Box
    }

    fn reset(&mut self) {
        self.body.clone_from(&self.start);
        self.trace.clear();
    }

    fn tick(&mut self, rate: f64, tick: u32) {
        let terrain = terrain(&self.mesh, &self.tuning, &self.movers);
        self.body
            .advance(f64::from(tick) / rate, &terrain, &mut self.trace);
    }

    fn at(&self) -> DVec2 {
        self.body.position()
    }

    fn counts(&self) -> Option<(usize, usize)> {
        Some((self.trace.events.len(), self.trace.crossed as usize))
    }
}
