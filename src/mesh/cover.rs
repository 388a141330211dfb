//! Provenance of faces: how often each feature winds around them.
//!
//! Few different covers occur among many faces, so they are interned and a face holds a number. The cover of a
//! face follows from that of a neighbour by the uses of the edge between them: who crosses a feature edge to its
//! left enters the feature once more. Opposite directions cancel, duplicates count twice.

use super::FeatureId;
use super::buckets::CellHasher;
use super::topology::{OUTSIDE, Quarter, Topology, sym};
use std::collections::HashMap;
use std::hash::BuildHasherDefault;

/// How often each feature winds around a place; ascending by feature, no zeros.
pub type Windings = Vec<(FeatureId, i32)>;

/// Number of an interned cover.
type CoverId = u32;

/// The cover of open country.
const EMPTY: CoverId = 0;
/// The face is new and its cover not known yet.
const UNKNOWN: CoverId = u32::MAX;

#[derive(Clone, Debug)]
struct Cover {
    windings: Windings,
    features: Vec<FeatureId>,
}

/// Covers of all faces.
#[derive(Clone, Debug)]
pub struct Covers {
    interned: Vec<Cover>,
    ids: HashMap<Windings, CoverId, BuildHasherDefault<CellHasher>>,
    of_face: Vec<CoverId>,
    /// Per face: whether a body is stopped by it. The outside stops bodies though nothing covers it.
    solid: Vec<bool>,
}

impl Covers {
    /// Nothing is covered.
    pub fn new() -> Self {
        let empty = Cover {
            windings: Vec::new(),
            features: Vec::new(),
        };
        let ids = std::iter::once((Vec::new(), EMPTY)).collect();
        Covers {
            interned: vec![empty],
            ids,
            of_face: vec![EMPTY],
            solid: vec![true],
        }
    }

    /// Whether a face stops bodies.
    #[inline]
    pub fn is_solid(&self, face: u32) -> bool {
        self.solid[face as usize]
    }

    /// The features around a face, ascending.
    pub fn features(&self, face: u32) -> &[FeatureId] {
        &self.interned[self.of_face[face as usize] as usize].features
    }

    /// How often each feature winds around a face.
    pub fn windings(&self, face: u32) -> &Windings {
        &self.interned[self.of_face[face as usize] as usize].windings
    }

    fn intern(&mut self, windings: &Windings) -> CoverId {
        if let Some(&id) = self.ids.get(windings) {
            return id;
        }
        let features = windings.iter().filter(|w| w.1 > 0).map(|w| w.0).collect();
        let id = self.interned.len() as CoverId;
        self.ids.insert(windings.clone(), id);
        self.interned.push(Cover {
            windings: windings.clone(),
            features,
        });
        id
    }

    fn set(&mut self, face: u32, cover: CoverId) {
        self.of_face[face as usize] = cover;
        self.solid[face as usize] =
            face == OUTSIDE || !self.interned[cover as usize].features.is_empty();
    }

    /// Works out the covers of new faces from those of their neighbours.
    ///
    /// `gain` writes by how much more each feature winds around the left of an edge than around its right; a
    /// feature may occur several times. Where nothing runs along an edge (`is_free`) there is no difference:
    /// such edges are crossed first, so that the others are asked once per region and not once per face.
    pub fn spread(
        &mut self,
        t: &Topology,
        new: &[u32],
        is_free: &impl Fn(Quarter) -> bool,
        gain: &impl Fn(Quarter, &mut Windings),
    ) {
        self.of_face.resize(t.face_count(), UNKNOWN);
        self.solid.resize(t.face_count(), false);
        for &face in new {
            self.of_face[face as usize] = UNKNOWN;
        }
        let (mut inner, mut border) = (Vec::new(), Vec::new());
        let mut scratch = Windings::new();
        for &face in new {
            if self.of_face[face as usize] != UNKNOWN || !t.is_face(face) {
                continue;
            }
            let known = |&e: &Quarter| self.of_face[t.left(sym(e)) as usize] != UNKNOWN;
            border.extend(t.sides(face).into_iter().find(known));
            // Into the unknown, as far as it goes.
            while let Some(e) = inner.pop().or_else(|| border.pop()) {
                if self.of_face[t.left(e) as usize] == UNKNOWN {
                    self.enter(t, e, &mut scratch, gain);
                    for beyond in [t.lnext(e), t.lprev(e)].map(sym) {
                        let stack = if is_free(beyond) {
                            &mut inner
                        } else {
                            &mut border
                        };
                        stack.push(beyond);
                    }
                }
            }
        }
    }

    /// Sets the cover of the face left of an edge from that of the face on its right.
    fn enter(
        &mut self,
        t: &Topology,
        e: Quarter,
        scratch: &mut Windings,
        gain: &impl Fn(Quarter, &mut Windings),
    ) {
        let mut cover = self.of_face[t.left(sym(e)) as usize];
        scratch.clear();
        gain(e, scratch);
        if !scratch.is_empty() {
            scratch.extend_from_slice(&self.interned[cover as usize].windings);
            merge(scratch);
            cover = self.intern(scratch);
        }
        self.set(t.left(e), cover);
    }

    /// Adds to the winding of one feature around a face.
    pub fn add(&mut self, face: u32, feature: FeatureId, winding: i32) {
        let mut windings = self.windings(face).clone();
        windings.push((feature, winding));
        merge(&mut windings);
        let cover = self.intern(&windings);
        self.set(face, cover);
    }

    /// How often a feature winds around a face.
    pub fn winding(&self, face: u32, feature: FeatureId) -> i32 {
        let windings = self.windings(face);
        windings
            .binary_search_by_key(&feature, |w| w.0)
            .map_or(0, |i| windings[i].1)
    }
}

/// Sorts by feature and adds up what belongs to the same one.
pub fn merge(windings: &mut Windings) {
    windings.sort_unstable();
    windings.dedup_by(|from, into| {
        let same = from.0 == into.0;
        if same {
            into.1 += from.1;
        }
        same
    });
    windings.retain(|w| w.1 != 0);
}
