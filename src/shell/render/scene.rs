//! A stage as triangles: everything that stands still, cut into chunks that can be skipped when out of sight.

use super::frame::PointLight;
use super::model::{Model, VERTEX_WORDS};
use glam::Vec3;
use std::collections::BTreeMap;
use std::ops::Range;

/// Metres of the level in one chunk.
const CHUNK: f32 = 12.0;

/// Triangles that are drawn or skipped together.
pub struct Chunk {
    /// Which vertices.
    pub vertices: Range<usize>,
    /// Lower corner of the box around them.
    pub min: Vec3,
    /// Upper corner.
    pub max: Vec3,
}

/// Everything that stands still.
#[derive(Default)]
pub struct Scene {
    /// Vertices of all chunks.
    pub words: Vec<u32>,
    /// The chunks, those at the plane of play before those in the distance.
    pub chunks: Vec<Chunk>,
    /// The lamps.
    pub lights: Vec<PointLight>,
}

impl Scene {
    /// Appends a model, cut along x into chunks of `width` metres.
    pub fn add(&mut self, model: &Model, width: f32) {
        let mut columns: BTreeMap<i32, Vec<u32>> = BTreeMap::new();
        for triangle in model.words.chunks_exact(3 * VERTEX_WORDS) {
            let column = (f32::from_bits(triangle[0]) / width).floor() as i32;
            columns.entry(column).or_default().extend(triangle);
        }
        for words in columns.values() {
            let start = self.words.len() / VERTEX_WORDS;
            let at = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
            let corners = words.chunks_exact(VERTEX_WORDS).map(at);
            let (min, max) = corners.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), p| {
                (min.min(p), max.max(p))
            });
            self.words.extend(words);
            self.chunks.push(Chunk {
                vertices: start..self.words.len() / VERTEX_WORDS,
                min,
                max,
            });
        }
    }

    /// Appends a model of the level itself.
    pub fn add_near(&mut self, model: &Model) {
        self.add(model, CHUNK);
    }
}
