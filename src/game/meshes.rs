//! The meshes of a stage, one set for each collider: built on first use, then kept and edited.

use crate::geom::{Collider, ColliderError, Point};
use crate::level::{Feature, Kind};
use crate::mesh::{self, FeatureId, Mesh, MeshError, Part};
use serde::{Deserialize, Serialize};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The meshes for one collider.
#[derive(Clone, Debug)]
pub struct Meshes {
    /// All that stands still.
    pub level: Arc<Mesh>,
    /// Each mover by itself, where it was drawn.
    pub movers: Vec<Arc<Mesh>>,
}

/// The sizes of a body. A crouching collider must share the lower chain of the standing one, its sides counted alike.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Corners", into = "Corners")]
pub struct Shape {
    /// Upright.
    pub stand: Collider,
    /// Crouched.
    pub crouch: Collider,
}

impl Shape {
    /// The hero's.
    pub fn hero() -> Shape {
        Shape {
            stand: Collider::hero(),
            crouch: Collider::hero_crouched(),
        }
    }

    /// A body that cannot crouch.
    pub fn rigid(collider: Collider) -> Shape {
        Shape {
            stand: collider.clone(),
            crouch: collider,
        }
    }
}

/// A shape as text: the corners of both colliders, in grid steps.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Corners {
    stand: Vec<(i32, i32)>,
    crouch: Vec<(i32, i32)>,
}

impl From<Shape> for Corners {
    fn from(shape: Shape) -> Corners {
        let corners = |c: &Collider| c.corners().iter().map(|p| (p.x, p.y)).collect();
        Corners {
            stand: corners(&shape.stand),
            crouch: corners(&shape.crouch),
        }
    }
}

impl TryFrom<Corners> for Shape {
    type Error = ColliderError;

    fn try_from(text: Corners) -> Result<Shape, ColliderError> {
        let collider = |corners: &[(i32, i32)]| {
            Collider::new(corners.iter().map(|&(x, y)| Point::new(x, y)).collect())
        };
        Ok(Shape {
            stand: collider(&text.stand)?,
            crouch: collider(&text.crouch)?,
        })
    }
}

/// A feature with its id in the meshes.
pub(super) type Numbered = (FeatureId, Feature);

/// What meshes are made of: the level as it was loaded, and what was changed since, in order.
///
/// A mesh that is built late goes the same way as one that was there all the time: first the level, then the changes.
/// So its handles, which bodies hold, depend on nothing else.
#[derive(Clone, Debug, Default)]
pub(super) struct Plan {
    /// Of the level, by id.
    pub still: Vec<Numbered>,
    /// Of each mover, by id.
    pub movers: Vec<Vec<Numbered>>,
    /// Since then: which went, and what came.
    pub changes: Vec<(Option<FeatureId>, Option<Numbered>)>,
}

impl Plan {
    fn build(&self, collider: &Collider, part: Part) -> Result<Meshes, MeshError> {
        let mesh = |features: &[Numbered], part: Part| {
            let entry = |(id, f): &Numbered| (*id, kind(f.kind), f.expand(collider));
            Mesh::watched(&features.iter().map(entry).collect::<Vec<_>>(), part)
        };
        let mut level = mesh(&self.still, part.between(0.0, 0.9))?;
        for change in &self.changes {
            apply(&mut level, collider, change)?;
        }
        let rest = part.between(0.9, 1.0);
        let movers = self.movers.iter().map(|own| mesh(own, rest).map(Arc::new));
        Ok(Meshes {
            level: Arc::new(level),
            movers: movers.collect::<Result<_, _>>()?,
        })
    }
}

/// Changes a mesh.
fn apply(
    mesh: &mut Mesh,
    collider: &Collider,
    (gone, come): &(Option<FeatureId>, Option<Numbered>),
) -> Result<(), MeshError> {
    if let Some(id) = gone {
        mesh.remove(*id)?;
    }
    match come {
        Some((id, f)) => mesh.insert_as(*id, kind(f.kind), &f.expand(collider)),
        None => Ok(()),
    }
}

/// What a kind of feature is to the mesh.
fn kind(kind: Kind) -> mesh::Kind {
    match kind {
        Kind::Solid => mesh::Kind::Solid,
        Kind::OneWay => mesh::Kind::OneWay,
        Kind::Ladder
        | Kind::Hazard
        | Kind::Checkpoint
        | Kind::Goal
        | Kind::Trigger
        | Kind::Secret => mesh::Kind::Region,
    }
}

type Cell = OnceLock<Result<Meshes, MeshError>>;

/// The meshes that have been asked for, by collider.
#[derive(Debug, Default)]
pub(super) struct Kept(Mutex<Vec<(Collider, Arc<Cell>)>>);

impl Kept {
    /// The meshes for a collider. Whoever comes first builds them; others who want the same ones wait for him, and
    /// nobody else does.
    pub fn get(&self, collider: &Collider, plan: &Plan, part: Part) -> Result<Meshes, MeshError> {
        let cell = {
            let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            match kept.iter().find(|(c, _)| c == collider) {
                Some((_, cell)) => Arc::clone(cell),
                None => {
                    let cell = Arc::new(Cell::new());
                    kept.push((collider.clone(), Arc::clone(&cell)));
                    cell
                }
            }
        };
        cell.get_or_init(|| plan.build(collider, part)).clone()
    }

    /// Changes all meshes. A mesh that somebody else holds is copied first.
    ///
    /// # Errors
    /// If a mesh refuses the change; meshes before it are changed.
    pub fn apply(
        &mut self,
        change: &(Option<FeatureId>, Option<Numbered>),
    ) -> Result<(), MeshError> {
        let kept = self.0.get_mut().unwrap_or_else(PoisonError::into_inner);
        for (collider, cell) in kept {
            if let Some(Ok(meshes)) = Arc::make_mut(cell).get_mut() {
                apply(Arc::make_mut(&mut meshes.level), collider, change)?;
            }
        }
        Ok(())
    }

    /// How many have been asked for.
    pub fn count(&self) -> usize {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).len()
    }
}

impl Clone for Kept {
    fn clone(&self) -> Kept {
        let kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        Kept(Mutex::new(kept.clone()))
    }
}
