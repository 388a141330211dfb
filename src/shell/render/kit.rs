//! The set pieces as models, ready to be placed: read once at start from `pieces.glb`.

use super::RenderError;
use super::frame::PointLight;
use super::model::{Corner, Model};
use crate::level::SceneryKind;
use crate::pieces::{Light, Piece, Pieces};
use glam::{Mat4, Vec3};
use std::collections::BTreeMap;
use std::path::Path;

/// The file in the folder of the models.
const FILE: &str = "pieces.glb";
/// How much the wind moves a place on the way from the root of a piece to its far end: little at first.
const BEND: f32 = 1.6;

/// A piece that belongs to a rule of the game rather than to the scenery.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A metre of spikes, one metre tall.
    Spikes,
    /// A metre of a machine's jaw, half a metre tall.
    Teeth,
    /// A metre to climb, for each kind of ladder.
    LadderMetre,
    /// The same of iron.
    ChainMetre,
    /// The same at rock.
    VineMetre,
    /// The standing stone of a checkpoint.
    Lodestone,
    /// What floats over it.
    LodestoneShard,
    /// What stands at the goal.
    Gate,
    /// What of it lights up.
    GateLight,
    /// What a trigger is seen as.
    Pedestal,
}

impl Part {
    /// All parts with the nodes that draw them.
    const NODES: [(Part, &str); 10] = [
        (Part::Spikes, "spikes"),
        (Part::Teeth, "teeth"),
        (Part::LadderMetre, "ladder_metre"),
        (Part::ChainMetre, "chain_metre"),
        (Part::VineMetre, "vine_metre"),
        (Part::Lodestone, "lodestone"),
        (Part::LodestoneShard, "lodestone_shard"),
        (Part::Gate, "gate"),
        (Part::GateLight, "gate_light"),
        (Part::Pedestal, "pedestal"),
    ];

    fn node(self) -> &'static str {
        let found = Part::NODES.iter().find(|(part, _)| *part == self);
        found.map_or("", |(_, node)| node)
    }
}

/// A piece as it is drawn, with its lamps.
#[derive(Default)]
struct Entry {
    model: Model,
    lights: Vec<Light>,
}

/// All pieces that the game draws, by node.
pub struct Kit(BTreeMap<&'static str, Entry>);

impl Kit {
    /// Reads the pieces from the folder of the models.
    ///
    /// # Errors
    /// The file is missing or broken, or one of the pieces that the game draws is not in it.
    pub fn load(folder: &Path) -> Result<Kit, RenderError> {
        let path = folder.join(FILE);
        let bytes = std::fs::read(&path).map_err(|error| RenderError::Read {
            path: path.clone(),
            error,
        })?;
        let pieces = Pieces::read(&bytes, &path)?;
        let parts = Part::NODES.iter().map(|(_, node)| *node);
        let scenery = SceneryKind::ALL.iter().map(|kind| kind.node());
        let entry = |node| Ok((node, entry(pieces.get(node)?)));
        let entries = scenery.chain(parts).map(entry);
        let mut kit = Kit(entries.collect::<Result<_, RenderError>>()?);
        for (number, entry) in kit.0.values_mut().enumerate() {
            entry.model.piece = Some(number);
        }
        Ok(kit)
    }

    /// All pieces, each at the place that its number says.
    pub fn pieces(&self) -> impl Iterator<Item = &Model> {
        self.0.values().map(|entry| &entry.model)
    }

    /// The model of a kind of scenery.
    pub fn scenery(&self, kind: SceneryKind) -> &Model {
        &self.entry(kind.node()).model
    }

    /// The model of a part.
    pub fn part(&self, part: Part) -> &Model {
        &self.entry(part.node()).model
    }

    /// The number of a part.
    pub fn number(&self, part: Part) -> usize {
        let before = self.0.keys().take_while(|node| **node != part.node());
        before.count()
    }

    /// How many pieces there are.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// The lamps of a kind of scenery that is placed; `scale` is that of the place.
    pub fn scenery_lights(&self, kind: SceneryKind, place: Mat4, scale: f32) -> Vec<PointLight> {
        lights(&self.entry(kind.node()).lights, place, scale)
    }

    /// The lamps of a part that is placed.
    pub fn part_lights(&self, part: Part, place: Mat4) -> Vec<PointLight> {
        lights(&self.entry(part.node()).lights, place, 1.0)
    }

    fn entry(&self, node: &str) -> &Entry {
        self.0
            .get(node)
            .expect("every node was looked up when the kit was loaded")
    }
}

fn lights(lights: &[Light], place: Mat4, scale: f32) -> Vec<PointLight> {
    let placed = |light: &Light| PointLight {
        at: place.transform_point3(light.at),
        reach: light.reach * scale,
        colour: light.colour,
    };
    lights.iter().map(placed).collect()
}

/// The triangles of a piece; the wind moves what is far from the height of its origin.
fn entry(piece: &Piece) -> Entry {
    let mut model = Model::default();
    let (min, max) = piece.bounds();
    let far = max.y.max(-min.y).max(f32::EPSILON);
    for facet in &piece.facets {
        let corner = |i: usize| {
            let corner = facet.corners[i];
            Corner {
                at: corner.at,
                colour: screen(corner.colour),
                open: corner.open,
                sway: piece.sway * (corner.at.y.abs() / far).powf(BEND),
            }
        };
        let glow = if facet.glows { 1.0 } else { 0.0 };
        model.shaded([corner(0), corner(1), corner(2)], glow);
    }
    Entry {
        model,
        lights: piece.lights.clone(),
    }
}

/// A linear colour as on the screen (sRGB).
fn screen(linear: Vec3) -> Vec3 {
    let encode = |c: f32| match c <= 0.003_130_8 {
        true => 12.92 * c,
        false => 1.055 * c.powf(1.0 / 2.4) - 0.055,
    };
    Vec3::from_array(linear.to_array().map(encode))
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// The kit of the repository.
    pub fn kit() -> Kit {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/models");
        Kit::load(&folder).unwrap()
    }

    #[test]
    fn every_part_has_its_own_node() {
        let kit = kit();
        assert_eq!(kit.0.len(), SceneryKind::ALL.len() + Part::NODES.len());
        for (part, node) in Part::NODES {
            assert_eq!(part.node(), node);
        }
    }

    #[test]
    fn a_linear_colour_is_encoded_for_the_screen() {
        let half = screen(Vec3::splat(0.2140)).x;
        assert!((half - 0.5).abs() < 1e-3, "{half}");
        assert_eq!(screen(Vec3::ZERO), Vec3::ZERO);
    }

    #[test]
    fn a_missing_file_is_named() {
        let error = Kit::load(Path::new("nowhere")).err().unwrap().to_string();
        assert!(error.starts_with("nowhere/pieces.glb: "), "{error}");
    }
}
