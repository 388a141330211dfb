//! A stage as triangles: everything that stands still, cut into chunks that can be skipped when out of sight.

use super::frame::PointLight;
use super::kit::Kit;
use super::model::{Model, VERTEX_WORDS, normal};
use super::shards::Shards;
use super::{backdrop, bake, fixtures, guides, scenery, terrain, water};
use crate::game::Stage;
use crate::geom::Collider;
use crate::level::Feature;
use glam::{Vec2, Vec3};
use std::collections::BTreeMap;
use std::ops::Range;

/// Metres along the sides of a chunk, of the level and of the distance.
const NEAR_CHUNK: f32 = 6.0;
const FAR_CHUNK: f32 = 20.0;
/// Height of the water above the level's bottom: who falls out of the level is under it.
const WATER: f32 = 1.2;
/// A facet whose unit normal leads further away from the viewer than this is seen from nowhere: he looks along -z, and the
/// edge of a picture 32:9 wide is 54 degrees aside.
const AWAY: f32 = -0.82;

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
    pub lamps: Vec<PointLight>,
    /// What shines when the goal is reached.
    pub gate: Option<PointLight>,
    /// Height of the water.
    pub water: f32,
    /// Corners of its surface.
    pub water_words: Vec<u32>,
}

impl Scene {
    /// Builds the scene of a stage; what floats in it goes to the shards.
    pub fn of(stage: &Stage, kit: &Kit, shards: &mut Shards) -> Scene {
        let outlines = stage
            .meshes(&Collider::point())
            .expect("the stage was built with the mesh of its outlines");
        let corners = stage
            .features()
            .flat_map(|(_, feature)| &feature.outline)
            .map(|p| p.as_vec2());
        let start = stage.level.start.as_vec2();
        let (min, max) = corners.fold((start, start), |(min, max), p: Vec2| {
            (min.min(p), max.max(p))
        });
        let water = stage.level.bottom as f32 + WATER;
        let (things, mut lamps) = scenery::build(kit, &stage.level);
        let moves = |id| outlines.movers.iter().any(|m| m.kind_of(id).is_some());
        let still = stage.features().filter(|&(id, _)| !moves(id));
        let still: Vec<&Feature> = still.map(|(_, feature)| feature).collect();
        let fixtures = fixtures::build(kit, &still, shards);
        let goal = fixtures::goal(kit, &stage.level, shards);
        lamps.extend(fixtures.lamps.iter().chain(&goal.lamps));
        let water_words = water::corners(min, max, water);
        let mut scene = Scene {
            gate: goal.lamps.first().copied(),
            lamps,
            water,
            water_words,
            ..Scene::default()
        };
        let solids = terrain::solids(&outlines.level, stage);
        scene.add(&terrain::build(&solids), NEAR_CHUNK);
        scene.add(&things, NEAR_CHUNK);
        scene.add(&fixtures.model, NEAR_CHUNK);
        scene.add(&goal.model, NEAR_CHUNK);
        scene.add(&guides::build(kit, &stage.level.movers), NEAR_CHUNK);
        bake::bake(&mut scene.words, &scene.lamps);
        scene.add(&backdrop::build(kit, min, max, water), FAR_CHUNK);
        scene
    }

    /// Appends a model without its backs, cut along x and y into chunks of `side` metres.
    fn add(&mut self, model: &Model, side: f32) {
        let mut cells: BTreeMap<(i32, i32), Vec<u32>> = BTreeMap::new();
        let facets = model.words.chunks_exact(3 * VERTEX_WORDS);
        for triangle in facets.filter(|facet| normal(facet).z > AWAY) {
            let number = |word: u32| (f32::from_bits(word) / side).floor() as i32;
            let cell = (number(triangle[0]), number(triangle[1]));
            cells.entry(cell).or_default().extend(triangle);
        }
        for words in cells.values() {
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
}

#[cfg(test)]
mod tests {
    use super::super::model::paint;
    use super::*;

    #[test]
    fn what_looks_away_from_the_viewer_is_left_out() {
        let mut model = Model::default();
        let front = [Vec3::ZERO, Vec3::X, Vec3::X + Vec3::Y, Vec3::Y];
        let [a, b, c, d] = front;
        model.quad(front, paint(0x808080));
        model.quad([d, c, b, a], paint(0x808080));
        let mut scene = Scene::default();
        scene.add(&model, NEAR_CHUNK);
        assert_eq!(
            scene.words.len() / (3 * VERTEX_WORDS),
            2,
            "the front's two facets"
        );
        assert!(
            scene
                .words
                .chunks_exact(VERTEX_WORDS)
                .all(|vertex| normal(vertex).z > 0.9)
        );
        let chunks = scene.chunks.iter().map(|chunk| chunk.vertices.len());
        assert_eq!(chunks.sum::<usize>(), 6);
    }
}
