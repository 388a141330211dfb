//! Which of the lamps light a picture: the shaders know only so many.

use super::frame::{MAX_LIGHTS, PointLight};
use glam::Vec3;

/// Puts the lights that matter for a picture around a point into `chosen`: the nearest, in order of distance.
pub fn choose(
    lamps: impl IntoIterator<Item = PointLight>,
    around: Vec3,
    chosen: &mut Vec<PointLight>,
) {
    let distance = |lamp: &PointLight| lamp.at.distance(around) - lamp.reach;
    for lamp in lamps {
        let rank = chosen.partition_point(|other| distance(other) <= distance(&lamp));
        if rank < MAX_LIGHTS {
            chosen.insert(rank, lamp);
            chosen.truncate(MAX_LIGHTS);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_lamps_are_chosen() {
        let lamp = |x: i32| PointLight {
            at: Vec3::X * x as f32,
            reach: 5.0,
            colour: Vec3::ONE,
        };
        let lamps: Vec<PointLight> = (0..40).rev().map(lamp).collect();
        let mut chosen = Vec::new();
        choose(lamps, Vec3::X * 3.2, &mut chosen);
        assert_eq!(chosen.len(), MAX_LIGHTS);
        assert_eq!(chosen[0].at.x, 3.0);
        assert!(chosen.iter().all(|lamp| lamp.at.x < 15.5));
    }
}
