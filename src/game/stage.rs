//! A level made ready to play: its meshes are built and its start is free.

use super::meshes::{Kept, Meshes, Numbered, Plan, Shape};
use super::paths::{Cause, Route};
use crate::geom::{BOUND, Collider, Point, STEP};
use crate::level::{self, By, Concave, Feature, Flaw, Kind, Level, Rect};
use crate::mesh::{FeatureId, MOST_VERTICES, MeshError, Part};
use crate::motion::{self, Body, Mover, Region, SpawnError, Terrain, Traits};
use crate::tune::Motion;
use glam::DVec2;
use serde::{Deserialize, Serialize};
use xxhash_rust::xxh3::xxh3_64;

/// A level made ready to play.
///
/// Features have numbers: those of the level as listed there, then those of the movers, then the goal box, then the *pit*, all
/// of the world below the level's bottom and beyond its sides, and the *sky*, all above it, then whatever [`Stage::edit`]
/// puts in. A number is never used again.
#[derive(Clone, Debug)]
pub struct Stage {
    /// The level, as it was loaded.
    pub level: Level,
    /// By number; `None` once it is gone, and for the pit and the sky, which nobody has drawn.
    features: Vec<Option<Feature>>,
    /// The number of the pit.
    pit: FeatureId,
    traits: Vec<Traits>,
    /// Where the level's areas are, on the grid.
    rooms: Vec<Rect>,
    /// Of each mover.
    routes: Vec<Route>,
    /// Some mover turns round by itself; to some it matters who rides them.
    turns: bool,
    minds_riders: bool,
    plan: Plan,
    kept: Kept,
    edits: Vec<Edit>,
    fingerprint: u64,
}

/// The ground for bodies of one shape: its meshes, and the movers, which carry theirs.
#[derive(Clone, Debug)]
pub struct Land {
    /// For the standing collider.
    pub stand: Meshes,
    /// For the crouching one.
    pub crouch: Meshes,
    /// In the order of the level; those that wait for something have not started.
    pub movers: Vec<Mover>,
}

/// A change of the level while it is played.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Edit {
    /// Puts in a feature with a new id.
    Insert(Feature),
    /// Takes out the feature with this id.
    Remove(String),
    /// Takes out the feature with the same id and puts in this one.
    Replace(Feature),
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
    /// There would be too many corners and crossings; names two features that cross most often, or one twice.
    TooMuch(String, String),
    /// Nobody waits for it any more.
    Left,
    /// The hero cannot start there.
    Start(SpawnError),
    /// The hero would start in a hazard: this one, or the pit, which has no name.
    Deadly(String),
}

impl std::fmt::Display for StageError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            StageError::Corner { feature, corner } => write!(
                f,
                "feature \"{feature}\", outline[{corner}]: outside the world"
            ),
            StageError::Mesh(error) => write!(f, "mesh: {error}"),
            StageError::TooMuch(first, second) => {
                let among = match first == second {
                    true => format!("those of \"{first}\" among them"),
                    false => format!("\"{first}\" and \"{second}\" cross most"),
                };
                write!(
                    f,
                    "too large: its outlines have more than {MOST_VERTICES} corners and crossings; {among}"
                )
            }
            StageError::Left => write!(f, "left before it was ready"),
            StageError::Start(error) => write!(f, "start: {error}"),
            StageError::Deadly(id) if id.is_empty() => {
                f.write_str("start: the hero would fall out of the level there")
            }
            StageError::Deadly(id) => {
                write!(f, "start: the hero would die there, in feature {id:?}")
            }
        }
    }
}

impl std::error::Error for StageError {}

/// Why an edit is refused; nothing has changed then.
#[derive(Clone, Debug, PartialEq)]
pub enum EditError {
    /// No feature of the level has this id, or it moves.
    Unknown(String),
    /// A feature has this id already.
    Taken(String),
    /// The feature breaks a rule.
    Flaw(Flaw),
}

impl std::fmt::Display for EditError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            EditError::Unknown(id) => write!(f, "there is no feature {id:?} that stands still"),
            EditError::Taken(id) => write!(f, "there is a feature {id:?} already"),
            EditError::Flaw(flaw) => flaw.fmt(f),
        }
    }
}

impl std::error::Error for EditError {}

impl Stage {
    /// Builds the hero's meshes of a level.
    ///
    /// # Errors
    /// If an outline leaves the world when expanded, there are too many crossings, or the hero does not fit at the start.
    pub fn build(level: Level) -> Result<Stage, StageError> {
        Stage::watched(level, Part::UNSEEN)
    }

    /// The same, as a part of long work that others wait for.
    ///
    /// # Errors
    /// As for [`Stage::build`], or if nobody waits for it any more.
    pub fn watched(level: Level, part: Part) -> Result<Stage, StageError> {
        let mut features = level.features.clone();
        let still = features.len();
        let riders = level.movers.iter().flat_map(|mover| &mover.features);
        features.extend(riders.cloned());
        features.push(goal_box(&level));
        features.iter().try_for_each(check_corners)?;
        let numbered: Vec<Numbered> = (0..).zip(features.iter().cloned()).collect();
        let mut next = still;
        let movers = level.movers.iter().map(|mover| {
            let first = next;
            next += mover.features.len();
            numbered[first..next].to_vec()
        });
        let pit = features.len() as FeatureId;
        let beyond = [pit_of(&level), sky()];
        let outside = (pit..).zip(beyond.iter().cloned());
        let plan = Plan {
            movers: movers.collect(),
            still: [&numbered[..still], &numbered[features.len() - 1..]].concat(),
            // After the rest, so that what the mesh takes for the usual size of things is that of the level.
            changes: outside.map(|feature| (None, Some(feature))).collect(),
        };
        let routes: Vec<Route> = level.movers.iter().map(|m| Route::of(m, &level)).collect();
        let mut traits: Vec<Traits> = features.iter().chain(&beyond).map(traits).collect();
        for (route, own) in routes.iter().zip(&plan.movers) {
            for (id, _) in own {
                traits[*id as usize].minds_riders = route.minds_riders();
            }
        }
        let stage = Stage {
            traits,
            features: features.into_iter().map(Some).chain([None, None]).collect(),
            pit,
            rooms: level.areas.iter().map(|area| on_grid(area.room)).collect(),
            turns: routes.iter().any(Route::turns),
            minds_riders: routes.iter().any(Route::minds_riders),
            routes,
            plan,
            kept: Kept::default(),
            edits: Vec::new(),
            fingerprint: fingerprint(&level),
            level,
        };
        let Shape { stand, crouch } = Shape::hero();
        for (share, collider) in [(0.0, stand), (0.35, crouch), (0.7, Collider::point())] {
            let part = part.between(share, share + 0.34);
            let built = stage.kept.get(&collider, &stage.plan, part);
            built.map_err(|error| stage.refused(error))?;
        }
        let land = stage.land(&Shape::hero()).map_err(StageError::Mesh)?;
        let tuning = Motion::default();
        let terrain = land.terrain(&stage, &tuning);
        let hero = Body::spawn(stage.level.start, 0.0, &terrain).map_err(StageError::Start)?;
        if let Some(&id) = hero.regions().iter().find(|&&id| stage.kills(id)) {
            let feature = stage.feature(id).map(|feature| feature.id.clone());
            return Err(StageError::Deadly(feature.unwrap_or_default()));
        }
        Ok(stage)
    }

    /// What a mesh's error means for the level.
    fn refused(&self, error: MeshError) -> StageError {
        let name = |id| match self.feature(id) {
            Some(feature) => feature.id.clone(),
            None => "the level's bottom".into(),
        };
        match error {
            MeshError::TooMuch { first, second } => StageError::TooMuch(name(first), name(second)),
            MeshError::Left => StageError::Left,
            error => StageError::Mesh(error),
        }
    }

    /// The meshes for a collider: built on first use, by one thread, and kept.
    ///
    /// # Errors
    /// If an outline leaves the world when expanded.
    pub fn meshes(&self, collider: &Collider) -> Result<Meshes, MeshError> {
        self.kept.get(collider, &self.plan, Part::UNSEEN)
    }

    /// How many colliders have their meshes.
    pub fn mesh_count(&self) -> usize {
        self.kept.count()
    }

    /// The ground for bodies of a shape.
    ///
    /// # Errors
    /// If an outline leaves the world when expanded.
    pub fn land(&self, shape: &Shape) -> Result<Land, MeshError> {
        let (stand, crouch) = (self.meshes(&shape.stand)?, self.meshes(&shape.crouch)?);
        let mover = |(i, route): (usize, &Route)| Mover {
            stand: stand.movers[i].clone(),
            crouch: crouch.movers[i].clone(),
            path: route.out.clone(),
            start: (route.cause == Cause::Level).then_some(0.0),
        };
        let movers = self.routes.iter().enumerate().map(mover).collect();
        Ok(Land {
            stand,
            crouch,
            movers,
        })
    }

    /// What features are to bodies, by number.
    pub fn traits(&self) -> &[Traits] {
        &self.traits
    }

    /// The features that stand still and those that move, with their numbers.
    pub fn features(&self) -> impl Iterator<Item = (FeatureId, &Feature)> {
        let numbered = (0..).zip(&self.features);
        numbered.filter_map(|(id, feature)| Some((id, feature.as_ref()?)))
    }

    /// The feature with a number.
    pub fn feature(&self, id: FeatureId) -> Option<&Feature> {
        self.features.get(id as usize)?.as_ref()
    }

    /// How many secrets there are to be found.
    pub fn secret_count(&self) -> usize {
        let secrets = self.features().filter(|(_, f)| f.kind == Kind::Secret);
        secrets.count()
    }

    /// Whether it kills the hero to be in the region with a number.
    pub fn kills(&self, id: FeatureId) -> bool {
        let is_hazard = |feature: &Feature| feature.kind == Kind::Hazard;
        self.is_outside(id) || self.feature(id).is_some_and(is_hazard)
    }

    /// Whether to be in the region with a number is to have fallen out of the level: in the pit or in the sky.
    pub fn is_outside(&self, id: FeatureId) -> bool {
        id == self.pit || id == self.pit + 1
    }

    /// The number of the pit.
    pub fn pit(&self) -> FeatureId {
        self.pit
    }

    /// The mover that a feature belongs to.
    pub fn mover_of(&self, id: FeatureId) -> Option<usize> {
        let mut movers = self.plan.movers.iter();
        movers.position(|own| own.iter().any(|&(rider, _)| rider == id))
    }

    /// The trigger that a mover waits for.
    pub fn trigger(&self, mover: usize) -> Option<FeatureId> {
        match self.routes.get(mover)?.cause {
            Cause::Trigger(id) => Some(id),
            Cause::Level | Cause::Rider => None,
        }
    }

    /// Whether a mover waits for something before it sets out.
    pub(super) fn waits(&self, mover: usize) -> bool {
        let route = self.routes.get(mover);
        route.is_some_and(|route| route.cause != Cause::Level)
    }

    /// The triggers that movers wait for, or that call them.
    pub fn triggers(&self) -> impl Iterator<Item = FeatureId> + '_ {
        let movers = 0..self.routes.len();
        let awaited = movers.filter_map(|mover| self.trigger(mover));
        let calls = self.routes.iter().flat_map(|route| &route.calls);
        awaited.chain(calls.map(|&(id, _)| id))
    }

    /// Where each mover goes, and what makes it.
    pub(super) fn routes(&self) -> &[Route] {
        &self.routes
    }

    /// Whether some mover turns round by itself.
    pub(super) fn turns(&self) -> bool {
        self.turns
    }

    /// Whether it matters to some mover who rides it.
    pub(super) fn minds_riders(&self) -> bool {
        self.minds_riders
    }

    /// Where the level's areas are, in their order.
    pub(super) fn rooms(&self) -> &[Rect] {
        &self.rooms
    }

    /// Changes the level. Meshes are edited in place, unless somebody else holds them.
    ///
    /// # Errors
    /// If the id is taken or unknown, or the feature breaks a rule; nothing has changed then.
    pub fn edit(&mut self, edit: Edit) -> Result<(), EditError> {
        let still = |id: &str| {
            let found = self.features().find(|(_, f)| f.id == id);
            found
                .map(|(n, _)| n)
                .filter(|&n| self.mover_of(n).is_none())
        };
        let known = |id: &str| still(id).ok_or_else(|| EditError::Unknown(id.into()));
        let (gone, feature) = match &edit {
            Edit::Insert(f) if self.features().any(|(_, other)| other.id == f.id) => {
                return Err(EditError::Taken(f.id.clone()));
            }
            Edit::Insert(f) => (None, Some(f.clone())),
            Edit::Remove(id) => (Some(known(id)?), None),
            Edit::Replace(f) => (Some(known(&f.id)?), Some(f.clone())),
        };
        if let Some(f) = &feature {
            level::check_feature(f).map_err(EditError::Flaw)?;
        }
        let come = feature.map(|f| (self.features.len() as FeatureId, f));
        let change = (gone, come.clone());
        self.kept
            .apply(&change)
            .expect("every mesh has room for a feature that keeps the rules");
        if let Some(id) = gone {
            self.features[id as usize] = None;
        }
        if let Some((_, f)) = come {
            self.traits.push(traits(&f));
            self.features.push(Some(f));
        }
        self.plan.changes.push(change);
        self.edits.push(edit);
        Ok(())
    }

    /// All edits since the level was loaded.
    pub fn edits(&self) -> &[Edit] {
        &self.edits
    }

    /// Hash of what the level said when it was loaded, whatever its layout and comments; not of what is only to be seen.
    pub fn fingerprint(&self) -> u64 {
        self.fingerprint
    }
}

impl Land {
    /// What bodies of the shape move in.
    pub fn terrain<'a>(&'a self, stage: &'a Stage, tuning: &'a Motion) -> Terrain<'a> {
        Terrain {
            stand: &self.stand.level,
            crouch: &self.crouch.level,
            tuning,
            traits: &stage.traits,
            movers: &self.movers,
        }
    }
}

/// Hash of all that a run depends on: scenery, the camera's frames and prompts change none.
fn fingerprint(level: &Level) -> u64 {
    let played = Level {
        scenery: Vec::new(),
        frames: Vec::new(),
        prompts: Vec::new(),
        ..level.clone()
    };
    let text = ron::to_string(&played).expect("a level is plain data");
    xxh3_64(text.as_bytes())
}

/// A room with its corners where the grid has them, as it has those of the ground: who stands on a floor at its height is in it.
fn on_grid(room: Rect) -> Rect {
    let snap = |p: DVec2| Point::snap(p).map_or(p, Point::metres);
    Rect {
        min: snap(room.min),
        max: snap(room.max),
    }
}

/// The goal box is a region like others, entered by the hero's foot.
fn goal_box(level: &Level) -> Feature {
    let (min, max) = (level.goal.min, level.goal.max);
    Feature {
        kind: Kind::Goal,
        by: Some(By::Foot),
        outline: vec![min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)],
        ..Feature::default()
    }
}

/// How far from the origin, to the sides and up, the world of every level ends, m: beyond all that can be drawn, and before the
/// border of the mesh, which stops who comes there.
pub const WORLD: f64 = 4032.0;

/// Where the mesh ends, m.
const END: f64 = (BOUND - 2) as f64 * STEP;

/// The place below the level's bottom and beyond its sides, to the borders of the mesh: who comes into it with his foot has fallen out.
fn pit_of(level: &Level) -> Feature {
    outside(&[
        (-END, -END),
        (END, -END),
        (END, END),
        (WORLD, END),
        (WORLD, level.bottom),
        (-WORLD, level.bottom),
        (-WORLD, END),
        (-END, END),
    ])
}

/// The place above all levels.
fn sky() -> Feature {
    outside(&[(-WORLD, WORLD), (WORLD, WORLD), (WORLD, END), (-WORLD, END)])
}

fn outside(outline: &[(f64, f64)]) -> Feature {
    Feature {
        kind: Kind::Hazard,
        by: Some(By::Foot),
        outline: outline.iter().copied().map(DVec2::from).collect(),
        ..Feature::default()
    }
}

fn check_corners(feature: &Feature) -> Result<(), StageError> {
    match feature
        .outline
        .iter()
        .position(|&p| Point::snap(p).is_none())
    {
        None => Ok(()),
        Some(corner) => Err(StageError::Corner {
            feature: feature.id.clone(),
            corner,
        }),
    }
}

/// What a feature is to the motion.
fn traits(feature: &Feature) -> Traits {
    Traits {
        region: match feature.kind {
            Kind::Solid | Kind::OneWay => Region::None,
            Kind::Ladder => Region::Ladder,
            Kind::Hazard | Kind::Checkpoint | Kind::Goal | Kind::Trigger | Kind::Secret => {
                Region::Plain
            }
        },
        drawn: match feature.kind {
            Kind::Ladder => feature.drawn_ends(&Collider::hero()),
            _ => [0.0; 2],
        },
        climbable: feature.climbable,
        conveyor: feature.conveyor,
        friction: feature.friction,
        concave: feature.concave.map(|concave| match concave {
            Concave::Keep => motion::Concave::Keep,
            Concave::Project => motion::Concave::Project,
        }),
        minds_riders: false,
    }
}
