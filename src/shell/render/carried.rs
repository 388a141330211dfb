//! What moves by itself in the picture: movers, put where they are frame by frame, and the arrows of belts.

use super::fixtures::Arrows;
use super::frame::PointLight;
use super::kit::Kit;
use super::model::Model;
use super::shards::Shards;
use super::{dangers, fixtures, terrain};
use crate::game::Stage;
use crate::geom::Collider;
use crate::level::Feature;
use glam::{DVec2, Mat4, Vec3};

/// How far the marks of what crushes stand out of its front, in metres.
const PROUD: f32 = 0.03;

/// The models of all movers, where they were drawn, and the arrows of belts that stand still.
#[derive(Default)]
pub struct Carried {
    movers: Vec<Model>,
    belts: Vec<Arrows>,
    /// The lamps that ride, each with the number of its mover.
    lamps: Vec<(usize, PointLight)>,
}

impl Carried {
    /// Builds the movers and belts of a stage; what floats over them goes to the shards.
    pub fn of(stage: &Stage, kit: &Kit, shards: &mut Shards) -> Carried {
        let outlines = stage
            .meshes(&Collider::point())
            .expect("the stage was built with the mesh of its outlines");
        let mut lamps = Vec::new();
        let movers = stage.level.movers.iter().zip(&outlines.movers).enumerate();
        let model = movers.map(|(number, (mover, mesh))| {
            let mut model = terrain::build(&terrain::solids(mesh, stage));
            let features: Vec<&Feature> = mover.features.iter().collect();
            let fixtures = fixtures::build(kit, &features, shards.riding(number));
            model.add(&fixtures.model, Mat4::IDENTITY);
            lamps.extend(fixtures.lamps.into_iter().map(|lamp| (number, lamp)));
            for feature in &mover.features {
                add_resting_arrows(feature, &features, &mut model);
            }
            for feature in mover.crushers() {
                dangers::crusher(feature, terrain::FRONT + PROUD, &mut model);
            }
            model
        });
        let movers = model.collect();
        let still: Vec<&Feature> = stage.level.features.iter().collect();
        let belts = still
            .iter()
            .flat_map(|feature| fixtures::arrows(feature, &still));
        Carried {
            movers,
            lamps,
            belts: belts.collect(),
        }
    }

    /// The models of all movers, then those of the belts' arrows.
    pub fn models(&self) -> impl Iterator<Item = &Model> {
        let arrows = self.belts.iter().map(|belt| &belt.model);
        self.movers.iter().chain(arrows)
    }

    /// The lamps that ride, where they are by the offsets of the movers.
    pub fn lamps<'a>(&'a self, offsets: &'a [DVec2]) -> impl Iterator<Item = PointLight> + 'a {
        self.lamps.iter().filter_map(|&(mover, lamp)| {
            let offset = offsets.get(mover)?.as_vec2().extend(0.0);
            Some(PointLight {
                at: lamp.at + offset,
                ..lamp
            })
        })
    }

    /// Calls `show` with the number of each model and how far it is from where it was drawn, in metres: movers by their
    /// offsets, the arrows of belts by a time, in seconds.
    pub fn place(&self, offsets: &[DVec2], time: f64, mut show: impl FnMut(usize, Vec3)) {
        for (number, offset) in offsets.iter().take(self.movers.len()).enumerate() {
            show(number, offset.as_vec2().extend(0.0));
        }
        for (number, belt) in (self.movers.len()..).zip(&self.belts) {
            let way = (time * f64::from(belt.pace)).rem_euclid(1.0) as f32;
            for i in 0..belt.count {
                show(number, belt.from + belt.step * (i as f32 + way));
            }
        }
    }
}

/// The arrows of a belt that is itself carried show where it runs, and no more.
fn add_resting_arrows(feature: &Feature, features: &[&Feature], model: &mut Model) {
    for belt in fixtures::arrows(feature, features) {
        for i in 0..belt.count {
            let at = belt.from + belt.step * (i as f32 + 0.5);
            model.add(&belt.model, Mat4::from_translation(at));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrows_run_with_their_belt_and_never_leave_it() {
        let outline = [(0.0, -1.0), (6.0, -1.0), (6.0, 0.0), (0.0, 0.0)];
        let belt = Feature {
            conveyor: -2.0,
            outline: outline.map(DVec2::from).to_vec(),
            ..Feature::default()
        };
        let carried = Carried {
            belts: fixtures::arrows(&belt, &[]),
            ..Carried::default()
        };
        let tips = |time: f64| {
            let tip = f32::from_bits(carried.belts[0].model.words[0]);
            let mut tips = Vec::new();
            carried.place(&[], time, |_, at| tips.push(at.x + tip));
            tips
        };
        let (before, after) = (tips(100.0), tips(100.05));
        assert_eq!(before.len(), 6);
        assert!(
            before.iter().chain(&after).all(|x| (-0.3..6.0).contains(x)),
            "{before:?} {after:?}"
        );
        let moved = (before[3] - after[3]).rem_euclid(1.0);
        assert!((moved - 0.1).abs() < 1e-3, "{moved}");
    }
}
