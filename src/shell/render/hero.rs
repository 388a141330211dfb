//! The hero in the picture: his mesh, the bones that move it on the GPU, the line around him, the light of his lantern.

use super::frame::PointLight;
use super::gl::{Geometry, Gl, Uniforms};
use super::model::{pack, pack_signed};
use super::state::Format;
use crate::anim::{MAX_BONES, Model, Rig, Shown, Vertex};
use glam::{Mat4, Vec3, Vec4};
use std::collections::HashMap;
use std::sync::Arc;

/// Layout of his vertices: position, normal, colour, traits, bones, weights, the way outwards.
const VERTEX: [Format; 7] = [
    Format::F3,
    Format::Snorm4,
    Format::Unorm4,
    Format::Unorm4,
    Format::Unorm4,
    Format::Unorm4,
    Format::Snorm4,
];
/// Binding point of his uniforms, in [`super::program::BLOCKS`].
const BINDING: u32 = 1;
/// Light along his outline, linear.
const RIM: Vec3 = Vec3::new(0.75, 0.62, 0.55);
/// Width of the line around him when he is marked, in pixels.
const LINE: f32 = 2.0;
/// Places as near as this are one corner, in 1/m.
const SAME_PLACE: f32 = 2000.0;

/// The hero's part of the renderer.
pub struct Hero {
    /// His mesh; empty until there is a model.
    pub mesh: Geometry,
    uniforms: Uniforms,
    rig: Option<Arc<Rig>>,
    /// Linear colour of the line around him, if there is one.
    mark: Option<Vec3>,
}

impl Hero {
    /// Nobody yet.
    pub fn new(gl: &Gl) -> Result<Hero, String> {
        Ok(Hero {
            mesh: gl.geometry(&VERTEX, false)?,
            uniforms: gl.uniforms(BINDING)?,
            rig: None,
            mark: None,
        })
    }

    /// Takes up a model.
    pub fn set_model(&mut self, rig: &Arc<Rig>) {
        self.mesh.upload(&words(&rig.model));
        self.rig = Some(Arc::clone(rig));
    }

    /// Draws a line of this colour (linear) around him, or none.
    pub fn mark(&mut self, colour: Option<Vec3>) {
        self.mark = colour;
    }

    /// Whether there is a line around him.
    pub fn is_marked(&self) -> bool {
        self.mark.is_some()
    }

    /// Hands over where his bones are; his lamp, or none if he is not there.
    pub fn upload(
        &self,
        shown: Option<&Shown>,
        time: f64,
        words: &mut Vec<u32>,
    ) -> Option<PointLight> {
        let (rig, shown) = (self.rig.as_deref()?, shown?);
        let foot = shown.foot.as_vec2().extend(0.0);
        let place = Mat4::from_translation(foot);
        words.clear();
        let bones: [Mat4; MAX_BONES] = shown.skin(rig).map(|bone| place * bone);
        for bone in bones {
            words.extend(bone.to_cols_array().map(f32::to_bits));
        }
        let line = self.mark.map_or(Vec4::ZERO, |colour| colour.extend(LINE));
        for vector in [RIM.extend(0.0), line] {
            words.extend(vector.to_array().map(f32::to_bits));
        }
        self.uniforms.upload(words);
        Some(lamp(foot + shown.lantern(rig), time))
    }
}

/// The light of his lantern; it flickers a little.
fn lamp(flame: Vec3, time: f64) -> PointLight {
    let seconds = time.rem_euclid(3600.0) as f32;
    let flicker = 1.0 + 0.05 * (seconds * 11.0).sin() + 0.04 * (seconds * 17.3).sin();
    PointLight {
        at: flame + Vec3::Z * 0.2,
        reach: 6.0,
        colour: Vec3::new(1.15, 0.66, 0.27) * flicker,
    }
}

/// Vertices as the GPU takes them.
fn words(model: &Model) -> Vec<u32> {
    let place = |vertex: &Vertex| (vertex.at * SAME_PLACE).round().as_ivec3();
    let mut outwards: HashMap<_, Vec3> = HashMap::new();
    for vertex in &model.vertices {
        *outwards.entry(place(vertex)).or_default() += vertex.normal;
    }
    let mut words = Vec::with_capacity(model.vertices.len() * (VERTEX.len() + 2));
    for vertex in &model.vertices {
        let colour = vertex.colour.map(f32::sqrt);
        words.extend(vertex.at.to_array().map(f32::to_bits));
        words.push(pack_signed(vertex.normal));
        words.push(pack([colour.x, colour.y, colour.z, 1.0]));
        words.push(pack([f32::from(u8::from(vertex.glows)), 0.0, 0.0, 0.0]));
        words.push(u32::from_ne_bytes(vertex.joints));
        words.push(whole_weights(vertex.weights));
        words.push(pack_signed(outwards[&place(vertex)].normalize_or_zero()));
    }
    words
}

/// Weights as bytes that still are one in sum: the largest takes what rounding leaves.
fn whole_weights(weights: [f32; 4]) -> u32 {
    let mut bytes = weights.map(|weight| (weight.clamp(0.0, 1.0) * 255.0).round() as i32);
    let largest = (0..4).max_by_key(|&i| bytes[i]).unwrap_or(0);
    bytes[largest] += 255 - bytes.iter().sum::<i32>();
    u32::from_ne_bytes(bytes.map(|byte| byte.clamp(0, 255) as u8))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_stay_one_in_sum() {
        for weights in [[1.0, 0.0, 0.0, 0.0], [0.25; 4], [0.334, 0.333, 0.333, 0.0]] {
            let bytes = whole_weights(weights).to_ne_bytes();
            assert_eq!(
                bytes.iter().map(|&b| u32::from(b)).sum::<u32>(),
                255,
                "{weights:?}"
            );
        }
    }
}
