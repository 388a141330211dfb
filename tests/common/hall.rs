//! A long hall with regions and movers, for tests of what the rules make of events.

#![allow(dead_code, reason = "each test uses its own part")]

use edgewalker::game::{Input, Stage, World};
use edgewalker::level::{By, Feature, Kind, Level, Mover, Rect};
use edgewalker::tune::Tuning;
use glam::DVec2;
use std::sync::Arc;

/// A box between two corners.
pub fn block(id: &str, kind: Kind, (x0, y0): (f64, f64), (x1, y1): (f64, f64)) -> Feature {
    Feature {
        id: id.into(),
        kind,
        outline: [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
            .map(DVec2::from)
            .to_vec(),
        ..Feature::default()
    }
}

/// The same as a region that is entered by the foot.
pub fn region(id: &str, kind: Kind, from: f64, to: f64) -> Feature {
    Feature {
        by: Some(By::Foot),
        ..block(id, kind, (from, -0.5), (to, 3.0))
    }
}

/// A long floor with regions and movers.
pub fn world(more: &[Feature], movers: &[Mover], rate: u32) -> World {
    let floor = block("floor", Kind::Solid, (-60.0, -1.0), (60.0, 0.0));
    let level = Level {
        version: 1,
        name: "Hall".into(),
        start: DVec2::ZERO,
        goal: Rect {
            min: DVec2::new(48.0, -0.5),
            max: DVec2::new(49.0, 3.0),
        },
        bottom: -20.0,
        features: [&[floor], more].concat(),
        movers: movers.to_vec(),
        areas: Vec::new(),
        frames: Vec::new(),
        prompts: Vec::new(),
        scenery: Vec::new(),
    };
    World::new(Arc::new(Stage::build(level).unwrap()), rate, 0)
}

/// Plays until a time, to the right (1), to the left (-1) or at rest (0).
pub fn play(world: &mut World, until: f64, run: i8) {
    let input = Input {
        run: 127 * run,
        ..Input::default()
    };
    while world.time() < until {
        world.step(input, &Tuning::default());
    }
}
