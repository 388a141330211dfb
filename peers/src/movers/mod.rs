//! The movers side by side: what a scene asks of them, and how each is driven.

pub mod box2d;
pub mod ours;
pub mod parry;
pub mod push_out;
pub mod rapier;
pub mod walker;

use crate::scene::{Scene, Shape};
use glam::DVec2;

/// One body in one scene. Positions are those of the middle of its foot, m.
pub trait Mover {
    /// What tables call it.
    fn name(&self) -> &'static str;

    /// Its shape: Box2D's is a capsule, all others are boxes of the same width and height.
    fn shape(&self) -> Shape;

    /// Puts the body at the start of the scene, with the scene's velocity, at time 0.
    fn reset(&mut self);

    /// One tick. The last argument is its number, from 1; ticks are `1 / rate` seconds long.
    fn tick(&mut self, rate: f64, tick: u32);

    /// Where it is.
    fn at(&self) -> DVec2;

    /// Events and faces crossed since the start, if it knows such things.
    fn counts(&self) -> Option<(usize, usize)> {
        None
    }
}

/// How to make a mover for a scene.
pub struct Maker {
    /// What tables call it.
    pub name: &'static str,
    /// Every setting that is not a default of its library, in words.
    pub settings: &'static str,
    /// Makes it; `Err` says why it cannot do the scene.
    pub make: fn(&Scene) -> Result<Box<dyn Mover>, &'static str>,
}

/// All movers, ours first.
pub fn all() -> Vec<Maker> {
    vec![
        ours::maker(),
        box2d::maker(),
        rapier::maker(),
        parry::maker(),
        push_out::maker(),
        box2d::middle_maker(),
        rapier::middle_maker(),
        rapier::pressed_maker(),
    ]
}
