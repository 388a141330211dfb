//! A level made ready to play: its meshes are built and its start is free.

use crate::geom::{Collider, Point, expand};
use crate::level::{Kind, Level};
use crate::mesh::{Mesh, MeshError};
use crate::motion::{Body, SpawnError, Terrain};
use crate::tune::Motion;
use xxhash_rust::xxh3::xxh3_64;

/// A level made ready to play.
#[derive(Debug)]
pub struct Stage {
    /// The level.
    pub level: Level,
    /// Motion mesh of the standing hero.
    pub stand: Mesh,
    /// Motion mesh of the crouching hero.
    pub crouch: Mesh,
    /// Mesh of the outlines themselves (a point as collider): what there is to see.
    pub outline: Mesh,
}

/// Why a level cannot be played.
#[derive(Clone, Debug, PartialEq)]
pub enum StageError {
    /// A feature has a corner that is not in the world.
    Corner {
        /// Name of the feature.
        feature: String,
        /// Index of the corner.
        corner: usize,
    },
    /// The mesh refuses an outline.
    Mesh(MeshError),
    /// The hero cannot start there.
    Start(SpawnError),
}

impl std::fmt::Display for StageError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            StageError::Corner { feature, corner } => write!(
                f,
                "feature \"{feature}\", outline[{corner}]: outside the world"
            ),
            StageError::Mesh(error) => write!(f, "mesh: {error}"),
            StageError::Start(error) => write!(f, "start: {error}"),
        }
    }
}

impl std::error::Error for StageError {}

impl Stage {
    /// Builds the meshes of a level.
    ///
    /// # Errors
    /// If an outline leaves the world when expanded, or the hero does not fit at the start.
    pub fn build(level: Level) -> Result<Stage, StageError> {
        let outlines = snapped(&level)?;
        let mesh = |collider: &Collider| {
            let features: Vec<_> = outlines
                .iter()
                .zip(&level.features)
                .map(|(outline, feature)| match feature.kind {
                    Kind::Solid => expand(outline, collider),
                    _ => Vec::new(),
                })
                .collect();
            Mesh::build(&features).map_err(StageError::Mesh)
        };
        let (stand, crouch, outline) = (
            mesh(&Collider::hero())?,
            mesh(&Collider::hero_crouched())?,
            mesh(&Collider::point())?,
        );
        let stage = Stage {
            level,
            stand,
            crouch,
            outline,
        };
        let tuning = Motion::default();
        Body::spawn(stage.level.start, 0.0, &stage.terrain(&tuning)).map_err(StageError::Start)?;
        Ok(stage)
    }

    /// What bodies move in.
    pub fn terrain<'a>(&'a self, tuning: &'a Motion) -> Terrain<'a> {
        Terrain::new(&self.stand, &self.crouch, tuning)
    }

    /// Hash of what the level says, whatever its layout and comments.
    pub fn fingerprint(&self) -> u64 {
        let text = ron::to_string(&self.level).expect("a level is plain data");
        xxh3_64(text.as_bytes())
    }
}

/// The outlines on the grid.
fn snapped(level: &Level) -> Result<Vec<Vec<Point>>, StageError> {
    let corner = |feature: &str, (corner, p)| {
        Point::snap(p).ok_or_else(|| StageError::Corner {
            feature: feature.to_owned(),
            corner,
        })
    };
    let outline = |feature: &crate::level::Feature| {
        feature
            .outline
            .iter()
            .copied()
            .enumerate()
            .map(|c| corner(&feature.id, c))
            .collect()
    };
    level.features.iter().map(outline).collect()
}
