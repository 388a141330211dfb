//! Movers in the picture: models that are put where their movers are, frame by frame.

use super::model::{Model, VERTEX_WORDS};
use super::{fixtures, terrain};
use crate::game::Stage;
use crate::geom::Collider;
use glam::{DVec2, Mat4, Vec3};

/// The models of all movers, where they were drawn.
#[derive(Default)]
pub struct Carried(Vec<Model>);

impl Carried {
    /// Builds the movers of a stage.
    pub fn of(stage: &Stage) -> Carried {
        let outlines = stage
            .meshes(&Collider::point())
            .expect("the stage was built with the mesh of its outlines");
        let movers = stage.level.movers.iter().zip(&outlines.movers);
        let model = movers.map(|(mover, mesh)| {
            let mut model = terrain::build(&terrain::solids(mesh, stage));
            let (fixtures, _) = fixtures::build(mover.features.iter());
            model.add(&fixtures, Mat4::IDENTITY);
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
