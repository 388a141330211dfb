//! The hero's figure without a picture: planted feet, no jump between two poses, springs that stay calm, nothing allocated.

mod brinks;
mod feet;
mod model;
mod stage;
mod states;
mod tails;

use edgewalker::anim::{Bone, Figure, Ground, Moves, Rig, Shown};
use glam::{DVec2, Vec3};
use std::sync::LazyLock;

/// The shipped model.
static RIG: LazyLock<Rig> = LazyLock::new(|| {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/models/hero.glb");
    let bytes = std::fs::read(path).unwrap();
    Rig::read("hero.glb", &bytes).unwrap_or_else(|error| panic!("{error}"))
});

/// Ground of one slope through the origin.
struct Slope(f64);

impl Ground for Slope {
    fn under(&self, x: f64, high: f64, low: f64) -> Option<(f64, f32)> {
        let y = self.0 * x;
        (low..=high).contains(&y).then_some((y, self.0 as f32))
    }
}

/// Stairs that rise a step of 0.2 m every 0.6 m.
struct Stairs;

impl Ground for Stairs {
    fn under(&self, x: f64, high: f64, low: f64) -> Option<(f64, f32)> {
        let y = (x / 0.6).floor() * 0.2;
        (low..=high).contains(&y).then_some((y, 0.0))
    }
}

/// Where a bone is in the level, m.
fn at(shown: &Shown, bone: Bone) -> DVec2 {
    let place = shown.bones(&RIG)[RIG.bone(bone)].transform_point3(Vec3::ZERO);
    shown.foot + place.truncate().as_dvec2()
}

#[test]
fn the_figure_is_a_plain_value_without_a_heap() {
    fn is_plain<T: Copy>() {}
    is_plain::<Figure>();
    assert!(
        size_of::<Figure>() < 24_000,
        "{} bytes",
        size_of::<Figure>()
    );
}

/// Running at a speed over ground of a slope, for so long.
fn running(speed: f64, slope: f64, time: f64) -> Moves {
    let along = DVec2::new(1.0, slope).normalize();
    let x = speed * along.x * time;
    Moves {
        time,
        velocity: along * speed,
        normal: DVec2::new(-slope, 1.0).normalize().as_vec2(),
        facing: speed.signum() as f32,
        ..Moves::standing(DVec2::new(x, slope * x))
    }
}
