//! How the peers are driven: the velocity takes up gravity, the body is moved by it, contacts clip it.

use super::Mover;
use crate::scene::{Scene, Shape};
use glam::DVec2;

/// What became of a wished displacement.
#[derive(Clone, Copy, Debug)]
pub struct Moved {
    /// Where the body is now, m.
    pub at: DVec2,
    /// Its velocity after contacts, m/s.
    pub velocity: DVec2,
    /// It stands on something.
    pub grounded: bool,
}

/// A library's way to move a body by a displacement among solids.
pub trait Slide {
    /// The shape that it moves.
    fn shape(&self) -> Shape;

    /// Moves a body that is at `at` and goes at `velocity` by `delta` in `dt` seconds.
    fn slide(&mut self, at: DVec2, velocity: DVec2, delta: DVec2, dt: f64) -> Moved;

    /// Puts the moving solid of the scene elsewhere: its offset at the end of the tick.
    fn carry(&mut self, offset: DVec2, dt: f64);

    /// The gap that it keeps to what it stands on, m: where a scene starts on the ground, it starts so far above it.
    fn gap(&self) -> f64 {
        0.0
    }

    /// The moving solid goes before the body does, not after it.
    fn carries_first(&self) -> bool {
        true
    }
}

/// How a tick's displacement comes from the velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// Semi-implicit Euler, as the samples of both libraries do: with the velocity at the end of the tick.
    Euler,
    /// With the mean of the velocities before and after: exact for constant acceleration until something is touched.
    Middle,
}

/// A peer in a scene.
pub struct Walker<S> {
    slide: S,
    name: &'static str,
    rule: Rule,
    scene: Scene,
    at: DVec2,
    velocity: DVec2,
    grounded: bool,
}

impl<S: Slide> Walker<S> {
    pub fn new(slide: S, name: &'static str, rule: Rule, scene: &Scene) -> Self {
        Walker {
            slide,
            name,
            rule,
            scene: scene.clone(),
            at: scene.start,
            velocity: scene.velocity,
            grounded: false,
        }
    }
}

/// The displacement and the new velocity of a tick without contacts.
pub fn integrate(velocity: DVec2, accel: DVec2, dt: f64, rule: Rule) -> (DVec2, DVec2) {
    let after = velocity + accel * dt;
    let mean = match rule {
        Rule::Euler => after,
        Rule::Middle => 0.5 * (velocity + after),
    };
    (mean * dt, after)
}

impl<S: Slide> Mover for Walker<S> {
    fn name(&self) -> &'static str {
        self.name
    }

    fn shape(&self) -> Shape {
        self.slide.shape()
    }

    fn reset(&mut self) {
        let gap = if self.scene.stands {
            self.slide.gap()
        } else {
            0.0
        };
        (self.at, self.velocity) = (self.scene.start + DVec2::new(0.0, gap), self.scene.velocity);
        self.grounded = false;
        if self.scene.lift.is_some() {
            self.slide.carry(DVec2::ZERO, 1.0);
        }
    }

    fn tick(&mut self, rate: f64, tick: u32) {
        let dt = 1.0 / rate;
        let lift = self
            .scene
            .lift
            .as_ref()
            .map(|lift| lift.offset(f64::from(tick) / rate));
        let first = self.slide.carries_first();
        lift.filter(|_| first)
            .into_iter()
            .for_each(|to| self.slide.carry(to, dt));
        if let Some(walk) = self.scene.walk {
            self.velocity.x = walk;
        }
        // Who walks on still ground is not pulled down while he stands: else he would creep down every slope.
        let stands = self.scene.walk.is_some() && self.scene.lift.is_none() && self.grounded;
        if stands {
            self.velocity.y = self.velocity.y.max(0.0);
        }
        let gravity = DVec2::new(0.0, if stands { 0.0 } else { -self.scene.gravity });
        let (delta, after) = integrate(self.velocity, gravity, dt, self.rule);
        let moved = self.slide.slide(self.at, after, delta, dt);
        (self.at, self.velocity, self.grounded) = (moved.at, moved.velocity, moved.grounded);
        lift.filter(|_| !first)
            .into_iter()
            .for_each(|to| self.slide.carry(to, dt));
    }

    fn at(&self) -> DVec2 {
        self.at
    }
}
