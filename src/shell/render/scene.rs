//! A stage as triangles: everything that stands still, cut into chunks that can be skipped when out of sight.

use super::frame::PointLight;
use super::kit::Kit;
use super::model::{FACET_WORDS, Model, Placed, VERTEX_WORDS, corner_order, light_of, normal};
use super::shards::Shards;
use super::{backdrop, bake, fixtures, guides, scenery, stands, terrain, water};
use crate::game::Stage;
use crate::geom::Collider;
use crate::level::{Feature, Level};
use glam::{Mat4, Vec2, Vec3};
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
    /// Those of them that are no pieces' of the kit: the first.
    pub bare: Range<usize>,
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
    /// The pieces of the kit among the triangles, those alike one after the other.
    pub pieces: Vec<Instance>,
    /// The light of their vertices: colour and openness, lamps and key light, as in the words of a vertex.
    pub light: Vec<[u32; 2]>,
}

/// A piece of the kit that stands somewhere.
pub struct Instance {
    /// Which one, and where.
    pub piece: usize,
    /// Its place.
    pub place: Mat4,
    /// Where the light of its vertices begins.
    pub light: usize,
    /// Lower corner of the box around it.
    pub min: Vec3,
    /// Upper corner.
    pub max: Vec3,
}

impl Instance {
    /// Whether left and right are exchanged.
    pub fn is_mirrored(&self) -> bool {
        self.place.determinant() < 0.0
    }
}

/// Height of a level's water.
pub fn water(level: &Level) -> f32 {
    level.bottom as f32 + WATER
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
        let water = self::water(&stage.level);
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
        let mut near = terrain::build(&solids);
        let guides = guides::build(&stage.level, water);
        let stands = stands::build(&stage.level, water);
        for model in [&things, &fixtures.model, &goal.model, &guides, &stands] {
            near.add(model, Mat4::IDENTITY);
        }
        let (lit, kept) = without_backs(near, |words| bake::bake(words, &scene.lamps));
        scene.add(&lit, &kept, NEAR_CHUNK);
        let (lit, kept) = without_backs(backdrop::build(kit, min, max, water), |_| {});
        scene.add(&lit, &kept, FAR_CHUNK);
        let key = |instance: &Instance| (instance.piece, instance.is_mirrored());
        scene.pieces.sort_by_key(key);
        scene
    }

    /// Appends a model, cut along x and y into chunks of `side` metres. Of each facet is told where its words are, if it is
    /// one that is ever seen.
    fn add(&mut self, model: &Model, kept: &[Option<usize>], side: f32) {
        let mut cells: BTreeMap<(i32, i32), [Vec<u32>; 2]> = BTreeMap::new();
        let mut is_piece = vec![false; kept.len()];
        for placed in &model.placed {
            is_piece[placed.facets.clone()].fill(true);
            self.pieces
                .extend(instance(placed, model, kept, &mut self.light));
        }
        for (&at, is_piece) in kept.iter().zip(is_piece) {
            let Some(facet) = at.map(|at| &model.words[at..at + FACET_WORDS]) else {
                continue;
            };
            let number = |word: u32| (f32::from_bits(word) / side).floor() as i32;
            let cell = (number(facet[0]), number(facet[1]));
            cells.entry(cell).or_default()[usize::from(is_piece)].extend(facet);
        }
        for [bare, pieces] in cells.values() {
            let start = self.words.len() / VERTEX_WORDS;
            let (min, max) = bounds(
                bare.chunks_exact(VERTEX_WORDS)
                    .chain(pieces.chunks_exact(VERTEX_WORDS)),
            );
            self.words.extend(bare);
            let bare = start..self.words.len() / VERTEX_WORDS;
            self.words.extend(pieces);
            let vertices = start..self.words.len() / VERTEX_WORDS;
            self.chunks.push(Chunk {
                vertices,
                bare,
                min,
                max,
            });
        }
    }
}

/// Takes the facets that are seen from nowhere out of a model's words, and lights the others; gives of each facet where its
/// words are now.
fn without_backs(mut model: Model, light: impl FnOnce(&mut [u32])) -> (Model, Vec<Option<usize>>) {
    let mut words = Vec::with_capacity(model.words.len());
    let facets = model.words.chunks_exact(FACET_WORDS);
    let kept = facets.map(|facet| {
        let start = words.len();
        let is_seen = normal(facet).z > AWAY;
        if is_seen {
            words.extend(facet);
        }
        is_seen.then_some(start)
    });
    let kept = kept.collect();
    light(&mut words);
    model.words = words;
    (model, kept)
}

/// A piece among the facets of a model, and the light of its vertices; none of one that is never seen.
fn instance(
    placed: &Placed,
    model: &Model,
    kept: &[Option<usize>],
    light: &mut Vec<[u32; 2]>,
) -> Option<Instance> {
    let begin = light.len();
    let order = corner_order(placed.place);
    let facets = &kept[placed.facets.clone()];
    for &at in facets {
        // Whichever corner comes first in the piece, here it is where the order says.
        light.extend(order.map(|corner| match at {
            Some(at) => light_of(&model.words[at + corner * VERTEX_WORDS..]),
            None => [0; 2],
        }));
    }
    let seen = facets.iter().flatten();
    let (min, max) =
        bounds(seen.flat_map(|&at| model.words[at..at + FACET_WORDS].chunks_exact(VERTEX_WORDS)));
    (min.x <= max.x).then_some(Instance {
        piece: placed.piece,
        place: placed.place,
        light: begin,
        min,
        max,
    })
}

/// The box around some vertices: its lower and upper corners.
fn bounds<'a>(vertices: impl Iterator<Item = &'a [u32]>) -> (Vec3, Vec3) {
    let at = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
    vertices
        .map(at)
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), p| {
            (min.min(p), max.max(p))
        })
}

#[cfg(test)]
mod tests {
    use super::super::kit::tests::kit;
    use super::super::model::paint;
    use super::*;
    use crate::level::SceneryKind;

    #[test]
    fn what_looks_away_from_the_viewer_is_left_out() {
        let mut model = Model::default();
        let front = [Vec3::ZERO, Vec3::X, Vec3::X + Vec3::Y, Vec3::Y];
        let [a, b, c, d] = front;
        model.quad(front, paint(0x808080));
        model.quad([d, c, b, a], paint(0x808080));
        let mut scene = Scene::default();
        let (model, kept) = without_backs(model, |_| {});
        scene.add(&model, &kept, NEAR_CHUNK);
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

    /// A piece's mesh at an instance's place, with the light of the table, is what was merged into the chunks.
    #[test]
    fn instances_show_what_is_merged() {
        let kit = kit();
        let crate_ = kit.scenery(SceneryKind::Crate);
        let mut model = Model::default();
        for (x, mirror) in [(0.0, 1.0), (3.0, -1.0)] {
            let place = Mat4::from_translation(Vec3::X * x) * Mat4::from_rotation_y(0.4);
            model.add(
                crate_,
                place * Mat4::from_scale(Vec3::new(mirror, 1.0, 1.0)),
            );
        }
        let lamp = PointLight {
            at: Vec3::new(1.0, 1.0, 2.0),
            reach: 6.0,
            colour: Vec3::ONE,
        };
        let (lit, kept) = without_backs(model, |words| bake::bake(words, &[lamp]));
        let mut scene = Scene::default();
        scene.add(&lit, &kept, NEAR_CHUNK);
        assert_eq!(scene.pieces.len(), 2);
        assert!(scene.pieces[1].is_mirrored() && !scene.pieces[0].is_mirrored());
        let at = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        let merged: Vec<&[u32]> = scene.words.chunks_exact(VERTEX_WORDS).collect();
        let mut found = 0;
        for instance in &scene.pieces {
            for (i, vertex) in crate_.words.chunks_exact(VERTEX_WORDS).enumerate() {
                let light = scene.light[instance.light + i];
                let place = instance.place.transform_point3(at(vertex));
                let same = |v: &&&[u32]| light_of(v) == light && at(v).distance(place) < 1e-5;
                found += usize::from(light != [0; 2] && merged.iter().any(|v| same(&v)));
            }
        }
        assert_eq!(found, merged.len());
        assert!(scene.chunks.iter().all(|chunk| chunk.bare.is_empty()));
    }
}
