//! The set pieces as values: what `assets/models/pieces.glb` holds, read from its bytes and checked once.
//!
//! Each node with a mesh is a piece. Metres, y up, the foot (or what it hangs from) at the origin; a piece's children
//! without a mesh, named "light" (Blender adds a number), are its lamps. Absent on purpose: textures, hierarchies,
//! animation, and any knowledge of which pieces the game wants; who draws asks for them by name.

use crate::anim::{Glb, Numbers};
use glam::Vec3;
use gltf::Semantic;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Material of what shines by itself.
const GLOW: &str = "glow";
/// What the name of a lamp begins with.
const LIGHT: &str = "light";
/// The attribute that says how much of the sky a corner sees, 0 to 1.
const OPENNESS: &str = "OPENNESS";
/// Farthest that a lamp may shine, in metres.
const FARTHEST: f32 = 100.0;

/// All pieces of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Pieces {
    file: PathBuf,
    pieces: BTreeMap<String, Piece>,
}

/// A set piece.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Piece {
    /// Its triangles.
    pub facets: Vec<Facet>,
    /// Its lamps.
    pub lights: Vec<Light>,
    /// How much the wind moves its far end, 0 to 1.
    pub sway: f32,
}

/// A triangle, counter-clockwise seen from its front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Its corners.
    pub corners: [Corner; 3],
    /// Whether it shines by itself.
    pub glows: bool,
}

/// A corner of a facet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Its place, in metres.
    pub at: Vec3,
    /// Linear red, green, blue.
    pub colour: Vec3,
    /// The share of the sky that it sees past the rest of the piece, 0 to 1.
    pub open: f32,
}

/// A lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Its place, in metres.
    pub at: Vec3,
    /// How far it shines, in metres.
    pub reach: f32,
    /// Linear red, green, blue.
    pub colour: Vec3,
}

/// Why the pieces cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub struct PiecesError {
    /// The file.
    pub file: PathBuf,
    /// The node that something is wrong with; none: the whole file.
    pub node: Option<String>,
    /// What is wrong.
    pub message: String,
}

impl std::fmt::Display for PiecesError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{}: ", self.file.display())?;
        if let Some(node) = &self.node {
            write!(f, "node \"{node}\": ")?;
        }
        write!(f, "{}", self.message)
    }
}

impl std::error::Error for PiecesError {}

/// The extras of a piece's node.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Traits {
    sway: f32,
}

/// The extras of a lamp's node.
#[derive(Deserialize)]
struct Lamp {
    reach: f32,
    colour: [f32; 3],
}

impl Pieces {
    /// Reads the bytes of a .glb file; `file` is what errors call it.
    ///
    /// # Errors
    /// The bytes are no .glb, or a node is not as the header of this file says.
    pub fn read(bytes: &[u8], file: &Path) -> Result<Pieces, PiecesError> {
        let whole = |message: String| PiecesError {
            file: file.into(),
            node: None,
            message,
        };
        let glb = Glb::open(bytes).map_err(whole)?;
        let (document, numbers) = (&glb.document, glb.numbers());
        let mut pieces = BTreeMap::new();
        for node in document.nodes().filter(|node| node.mesh().is_some()) {
            let name = node.name().unwrap_or_default().to_string();
            let fail = |message: String| PiecesError {
                node: Some(name.clone()),
                ..whole(message)
            };
            let piece = piece(&node, numbers).map_err(fail)?;
            if pieces.insert(name.clone(), piece).is_some() {
                return Err(fail("there is another one of this name".into()));
            }
        }
        Ok(Pieces {
            file: file.into(),
            pieces,
        })
    }

    /// The piece of this name.
    ///
    /// # Errors
    /// There is none.
    pub fn get(&self, name: &str) -> Result<&Piece, PiecesError> {
        self.pieces.get(name).ok_or_else(|| PiecesError {
            file: self.file.clone(),
            node: Some(name.into()),
            message: "is missing".into(),
        })
    }

    /// All pieces with their names, in the order of the names.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Piece)> {
        self.pieces
            .iter()
            .map(|(name, piece)| (name.as_str(), piece))
    }
}

impl Piece {
    /// The lower and the upper corner of the box around it, in metres.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        let corners = self.facets.iter().flat_map(|facet| facet.corners);
        corners.fold(
            (Vec3::INFINITY, Vec3::NEG_INFINITY),
            |(min, max), corner| (min.min(corner.at), max.max(corner.at)),
        )
    }
}

fn piece(node: &gltf::Node, numbers: Numbers) -> Result<Piece, String> {
    let mut piece = Piece::default();
    for primitive in node.mesh().iter().flat_map(|mesh| mesh.primitives()) {
        read_facets(&primitive, numbers, &mut piece.facets)?;
    }
    if piece.facets.is_empty() {
        return Err("has no triangles".into());
    }
    if let Some(text) = node.extras() {
        let traits: Traits = gltf::json::deserialize::from_str(text.get())
            .map_err(|error| format!("extras: {error}"))?;
        piece.sway = traits.sway;
    }
    if !(0.0..=1.0).contains(&piece.sway) {
        return Err(format!("extras: sway {} is outside 0..=1", piece.sway));
    }
    for child in node.children() {
        let name = child.name().unwrap_or_default();
        if name.split('.').next() == Some(LIGHT) {
            piece
                .lights
                .push(light(&child).map_err(|why| format!("\"{name}\": {why}"))?);
        }
    }
    Ok(piece)
}

fn read_facets(
    primitive: &gltf::Primitive,
    numbers: Numbers,
    facets: &mut Vec<Facet>,
) -> Result<(), String> {
    let places: Vec<[f32; 3]> = numbers.attribute(primitive, Semantic::Positions)?;
    let colours = numbers.colours(primitive)?;
    let open: Vec<[f32; 1]> = numbers.attribute(primitive, Semantic::Extras(OPENNESS.into()))?;
    if colours.len() != places.len() || open.len() != places.len() {
        return Err("its attributes are of different lengths".into());
    }
    let glows = primitive.material().name() == Some(GLOW);
    let corner = |i: &usize| Corner {
        at: places[*i].into(),
        colour: colours[*i].into(),
        open: open[*i][0].clamp(0.0, 1.0),
    };
    for triangle in numbers.corners(primitive, places.len())?.chunks_exact(3) {
        if let [a, b, c] = triangle {
            let corners = [corner(a), corner(b), corner(c)];
            facets.push(Facet { corners, glows });
        }
    }
    Ok(())
}

fn light(node: &gltf::Node) -> Result<Light, String> {
    let extras = node.extras().as_ref().ok_or("has no extras")?;
    let Lamp { reach, colour } = gltf::json::deserialize::from_str(extras.get())
        .map_err(|error| format!("extras: {error}"))?;
    let (place, _, _) = node.transform().decomposed();
    let fair = reach > 0.0 && reach <= FARTHEST && colour.iter().all(|&c| c >= 0.0);
    match fair && place.iter().all(|c| c.is_finite()) {
        true => Ok(Light {
            at: place.into(),
            reach,
            colour: colour.into(),
        }),
        false => Err(format!(
            "extras: reach {reach}, colour {colour:?}, place {place:?}"
        )),
    }
}
