//! Movers in the picture: models that are put where their movers are, frame by frame.

use super::kit::Kit;
use super::model::{Model, VERTEX_WORDS};
use super::shards::Shards;
use super::{dangers, fixtures, guides, terrain};
use crate::game::Stage;
use crate::geom::Collider;
use crate::level::{Feature, Material};
use glam::{DVec2, Mat4, Vec3};

/// How far the marks of what crushes stand out of its front, in metres.
const PROUD: f32 = 0.03;

/// The models of all movers, where they were drawn.
#[derive(Default)]
pub struct Carried(Vec<Model>);

impl Carried {
    /// Builds the movers of a stage.
    pub fn of(stage: &Stage, kit: &Kit) -> Carried {
        let outlines = stage
            .meshes(&Collider::point())
            .expect("the stage was built with the mesh of its outlines");
        let movers = stage.level.movers.iter().zip(&outlines.movers);
        let model = movers.map(|(mover, mesh)| {
            let mut model = terrain::build(&terrain::solids(mesh, stage));
            let features: Vec<&Feature> = mover.features.iter().collect();
            // No shard and no lamp rides on a mover.
            let fixtures = fixtures::build(kit, &features, &mut Shards::default());
            model.add(&fixtures.model, Mat4::IDENTITY);
            if guides::stamps(mover) {
                for feature in features.iter().filter(|f| f.material == Material::Iron) {
                    dangers::crusher(feature, terrain::FRONT + PROUD, &mut model);
                }
            }
            model
        });
        Carried(model.collect())
    }

    /// Replaces `words` by all vertices, each mover this far from where it was drawn, in metres.
    pub fn write(&self, offsets: &[DVec2], words: &mut Vec<u32>) {
        words.clear();
        for (model, offset) in self.0.iter().zip(offsets) {
            let offset = offset.as_vec2().extend(0.0);
            for vertex in model.words.chunks_exact(VERTEX_WORDS) {
                let at = Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(vertex[i]))) + offset;
                words.extend(at.to_array().map(f32::to_bits));
                words.extend(&vertex[3..]);
            }
        }
    }
}
