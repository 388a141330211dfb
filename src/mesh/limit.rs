//! How much may be in a mesh that is built at once. Who asks for more is told soon, by name, and neither waits for ever nor runs out
//! of memory.

use super::edit::Entry;
use super::progress::Left;
use super::{FeatureId, MeshError};
use crate::geom::Point;
use crate::geom::predicates::crosses;
use std::collections::BTreeMap;

/// The most corners and crossings of outlines, which become vertices: a mesh then has about 2 GB and takes ten seconds.
pub const MOST_VERTICES: usize = 4_000_000;

/// The most crossings, where many lie in the same vertex.
pub(super) const MOST_CROSSINGS: usize = 1 << 26;

/// The most pieces of feature edges, where many run along the same edge of the mesh.
pub(super) const MOST_PIECES: usize = 1 << 25;

/// The most features in the covers of faces together, where many lie on one another.
pub(super) const MOST_COVERS: usize = 1 << 28;

/// Edges that are looked at to find the features that cross most.
const SAMPLE: usize = 2000;

/// Why a mesh is not built to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stop {
    /// Nobody waits for it.
    Left,
    /// It would be too large.
    TooMuch,
}

impl From<Left> for Stop {
    fn from(_: Left) -> Stop {
        Stop::Left
    }
}

impl Stop {
    /// Says what is wrong with features.
    pub fn told_of(self, batch: &[Entry]) -> MeshError {
        match self {
            Stop::Left => MeshError::Left,
            Stop::TooMuch => {
                let (first, second) = most_crossed(batch);
                MeshError::TooMuch { first, second }
            }
        }
    }
}

/// Of some edges from all over the list, the two features that cross most often; the same one twice if no two cross.
fn most_crossed(batch: &[Entry]) -> (FeatureId, FeatureId) {
    let count: usize = batch.iter().map(|entry| entry.edges.len()).sum();
    let edges = batch
        .iter()
        .flat_map(|entry| entry.edges.iter().map(|e| (entry.id, e.a, e.b)));
    // Not every so many-th: outlines have equally many edges often.
    let one_of = count.div_ceil(SAMPLE).max(1) as u64;
    let chosen = |i: u64| (i.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32).is_multiple_of(one_of);
    let some: Vec<(FeatureId, Point, Point)> = (0..)
        .zip(edges)
        .filter_map(|(i, edge)| chosen(i).then_some(edge))
        .collect();
    let mut crossings: BTreeMap<(FeatureId, FeatureId), usize> = BTreeMap::new();
    for (i, &(feature, a, b)) in some.iter().enumerate() {
        for &(other, c, d) in &some[..i] {
            if feature != other && crosses(a, b, c, d) {
                let pair = (feature.min(other), feature.max(other));
                *crossings.entry(pair).or_default() += 1;
            }
        }
    }
    // Of pairs that cross as often the first.
    let most = crossings.into_iter().rev().max_by_key(|&(_, count)| count);
    let first = some.first().map_or(0, |edge| edge.0);
    most.map_or((first, first), |(pair, _)| pair)
}
