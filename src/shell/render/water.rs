//! The water that drowned the quarry: a plane of facets that the shader lets wave.

use super::gl::{Geometry, Gl};
use super::state::Format;
use glam::{Vec2, Vec3};

/// Layout of a corner: its place.
const CORNER: [Format; 1] = [Format::F3];
/// Metres along a facet at the level, and in the distance.
const NEAR_STEP: f32 = 4.0;
const FAR_STEP: f32 = 20.0;
/// From the camera's side of the level to the far cliffs.
const DEPTHS: [f32; 2] = [12.0, -240.0];

/// An empty surface.
pub fn surface(gl: &Gl) -> Result<Geometry, String> {
    gl.geometry(&CORNER, false)
}

/// The corners of the surface beside a level between two corners, as words.
pub fn corners(min: Vec2, max: Vec2, height: f32) -> Vec<u32> {
    let mut words = Vec::new();
    let mut near = DEPTHS[0];
    while near > DEPTHS[1] {
        // Facets grow with the distance, as the picture shows them smaller.
        let step = if near > -30.0 { NEAR_STEP } else { FAR_STEP };
        let (far, beyond) = (near - step, 40.0 - near.min(0.0) * 0.9);
        let (first, last) = (
            ((min.x - beyond) / step).floor() as i32,
            ((max.x + beyond) / step).ceil() as i32,
        );
        for cell in first..last {
            let (left, right) = (cell as f32 * step, (cell + 1) as f32 * step);
            let at = |x: f32, z: f32| Vec3::new(x, height, z);
            let [a, b, c, d] = [
                at(left, near),
                at(right, near),
                at(right, far),
                at(left, far),
            ];
            let halves = if cell.rem_euclid(2) == 0 {
                [a, b, c, a, c, d]
            } else {
                [a, b, d, b, c, d]
            };
            words.extend(
                halves
                    .into_iter()
                    .flat_map(|p| p.to_array())
                    .map(f32::to_bits),
            );
        }
        near = far;
    }
    words
}
