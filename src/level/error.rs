//! What can be wrong with a level, said so that its author finds the place.

use std::fmt;
use std::path::PathBuf;

/// Longer ids than this, in bytes, are no help in a message: 64 characters of four bytes.
const LONGEST_ID: usize = 256;

/// Which part of a level is meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Entity {
    /// The level itself.
    Level,
    /// A feature, by its index and id.
    Feature(usize, String),
    /// A mover, by its index and id.
    Mover(usize, String),
    /// A feature of a mover: the mover's index, then its own and its id.
    Rider(u32, u32, String),
    /// An area, by its index and name.
    Area(usize, String),
    /// A frame of the camera, by its index.
    Frame(usize),
    /// A prompt, by its index.
    Prompt(usize),
    /// A piece of scenery, by its index.
    Scenery(usize),
}

/// A rule that the data of a level breaks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Flaw {
    /// In which part.
    pub entity: Entity,
    /// In which field, as `outline[4].x`.
    pub field: String,
    /// The corner of the outline that is meant, if it is about one.
    pub corner: Option<usize>,
    /// What is wrong.
    pub message: String,
}

/// Why a level could not be read, with the place as far as it is known.
///
/// It displays as `levels/quarry.ron:41: feature "ledge-3", outline[4].x: NaN is not a finite number`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LevelError {
    /// The file, as it was named by the caller.
    pub file: PathBuf,
    /// The line, counted from 1, where there is one to point at.
    pub line: Option<u32>,
    /// Which part of the level, where it is known.
    pub entity: Option<Entity>,
    /// Which field of that part, where it is known.
    pub field: Option<String>,
    /// What is wrong.
    pub message: String,
}

impl Flaw {
    /// A flaw of the level itself.
    pub(super) fn of_level(field: &str, message: String) -> Self {
        Flaw {
            entity: Entity::Level,
            field: field.into(),
            corner: None,
            message,
        }
    }
}

impl fmt::Display for Entity {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Entity::Level => f.write_str("level"),
            Entity::Feature(_, id) if id.len() <= LONGEST_ID => write!(f, "feature {id:?}"),
            Entity::Feature(index, _) => write!(f, "features[{index}]"),
            Entity::Mover(_, id) if id.len() <= LONGEST_ID => write!(f, "mover {id:?}"),
            Entity::Mover(index, _) => write!(f, "movers[{index}]"),
            Entity::Rider(mover, _, id) if id.len() <= LONGEST_ID => {
                write!(f, "movers[{mover}], feature {id:?}")
            }
            Entity::Rider(mover, index, _) => write!(f, "movers[{mover}].features[{index}]"),
            Entity::Area(_, name) if name.len() <= LONGEST_ID => write!(f, "area {name:?}"),
            Entity::Area(index, _) => write!(f, "areas[{index}]"),
            Entity::Frame(index) => write!(f, "frames[{index}]"),
            Entity::Prompt(index) => write!(f, "prompts[{index}]"),
            Entity::Scenery(index) => write!(f, "scenery[{index}]"),
        }
    }
}

impl fmt::Display for Flaw {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}, {}: {}", self.entity, self.field, self.message)
    }
}

impl fmt::Display for LevelError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}:", self.file.display())?;
        if let Some(line) = self.line {
            write!(f, "{line}:")?;
        }
        match (&self.entity, &self.field) {
            (Some(entity), Some(field)) => write!(f, " {entity}, {field}:")?,
            (Some(entity), None) => write!(f, " {entity}:")?,
            (None, _) => {}
        }
        write!(f, " {}", self.message)
    }
}

impl std::error::Error for Flaw {}

impl std::error::Error for LevelError {}
