//! Provenance of faces: how often each feature winds around them.
//!
//! Few different covers occur among many faces, so they are interned and a face holds a number. The cover of a
//! face follows from that of a neighbour by the uses of the edge between them: who crosses a feature edge to its
//! left enters the feature once more. Opposite directions cancel, duplicates count twice. Covers that no face has
//! any more are dropped and their numbers used again, so that endless edits need no more memory than their mesh.

use super::FeatureId;
use super::buckets::CellHasher;
use super::topology::{OUTSIDE, Quarter, Topology, sym};
use std::collections::{BTreeSet, HashMap};
use std::hash::BuildHasherDefault;
use std::sync::Arc;

/// How often each feature winds around a place; ascending by feature, no zeros.
pub type Windings = Vec<(FeatureId, i32)>;

/// The same as a cover and its index keep them.
type Shared = Arc<[(FeatureId, i32)]>;

/// Number of an interned cover.
type CoverId = u32;

/// The cover of open country.
const EMPTY: CoverId = 0;
/// The face is new and its cover not known yet.
const UNKNOWN: CoverId = u32::MAX;

#[derive(Clone, Debug)]
struct Cover {
    windings: Shared,
    features: Vec<FeatureId>,
    /// Whether one of the features is a solid.
    solid: bool,
    /// How many faces have it.
    faces: u32,
}

/// Covers of all faces.
#[derive(Clone, Debug)]
pub struct Covers {
    interned: Vec<Cover>,
    /// Numbers that can be given away.
    vacant: Vec<CoverId>,
    ids: HashMap<Shared, CoverId, BuildHasherDefault<CellHasher>>,
    of_face: Vec<CoverId>,
    /// Per face: whether a body is stopped by it. The outside stops bodies though nothing covers it.
    solid: Vec<bool>,
    /// Those of the features that stop nobody.
    regions: BTreeSet<FeatureId>,
    /// What was added to what last, and what it gave: faces next to each other mostly have the same cover.
    sum: Option<Sum>,
    /// Scratch for a cover that is not interned yet.
    scratch: Windings,
}

/// A cover, so many windings of a feature more, and the cover that this makes. Both are in use.
#[derive(Clone, Copy, Debug)]
struct Sum {
    from: CoverId,
    feature: FeatureId,
    winding: i32,
    to: CoverId,
}

impl Covers {
    /// Nothing is covered.
    pub fn new() -> Self {
        let nothing: Shared = Arc::new([]);
        let empty = Cover {
            windings: Arc::clone(&nothing),
            features: Vec::new(),
            solid: false,
            faces: 1,
        };
        let ids = std::iter::once((nothing, EMPTY)).collect();
        Covers {
            interned: vec![empty],
            vacant: Vec::new(),
            ids,
            of_face: vec![EMPTY],
            solid: vec![true],
            regions: BTreeSet::new(),
            sum: None,
            scratch: Windings::new(),
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
    pub fn windings(&self, face: u32) -> &[(FeatureId, i32)] {
        &self.interned[self.of_face[face as usize] as usize].windings
    }

    /// Notes, before a feature covers any face, whether it is a region; otherwise it is a solid.
    pub fn set_region(&mut self, feature: FeatureId, region: bool) {
        if region {
            self.regions.insert(feature);
        } else {
            self.regions.remove(&feature);
        }
    }

    /// How many different covers there is room for: a measure of the memory in use.
    pub fn capacity(&self) -> usize {
        self.interned.len()
    }

    /// The number of a cover. It is to be given to a face next, or else stays for good.
    fn intern(&mut self, windings: &[(FeatureId, i32)]) -> CoverId {
        if let Some(&id) = self.ids.get(windings) {
            return id;
        }
        let inside = windings.iter().filter(|w| w.1 > 0).map(|w| w.0);
        let features: Vec<FeatureId> = inside.collect();
        let windings: Shared = windings.into();
        let cover = Cover {
            windings: Arc::clone(&windings),
            solid: features.iter().any(|f| !self.regions.contains(f)),
            features,
            faces: 0,
        };
        let id = match self.vacant.pop() {
            Some(id) => {
                self.interned[id as usize] = cover;
                id
            }
            None => {
                self.interned.push(cover);
                self.interned.len() as CoverId - 1
            }
        };
        self.ids.insert(windings, id);
        id
    }

    /// Gives a cover to a face.
    fn set(&mut self, face: u32, cover: CoverId) {
        self.interned[cover as usize].faces += 1;
        self.forget(face);
        self.of_face[face as usize] = cover;
        self.solid[face as usize] = face == OUTSIDE || self.interned[cover as usize].solid;
    }

    /// Makes the cover of a face unknown, and drops it if no other face has it.
    fn forget(&mut self, face: u32) {
        let id = std::mem::replace(&mut self.of_face[face as usize], UNKNOWN);
        let Some(cover) = self.interned.get_mut(id as usize) else {
            return;
        };
        cover.faces -= 1;
        if cover.faces == 0 && id != EMPTY {
            self.ids.remove(&cover.windings);
            self.vacant.push(id);
            self.sum = self.sum.filter(|sum| sum.from != id && sum.to != id);
        }
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
            self.forget(face);
        }
        let (mut inner, mut border) = (Vec::with_capacity(64), Vec::new());
        let mut scratch = std::mem::take(&mut self.scratch);
        // First from face to face as they lie in memory, each with what no edge parts from it; then, wherever that found nothing
        // to begin with, on across the borders.
        for across in [false, true] {
            for &face in new {
                if self.of_face[face as usize] != UNKNOWN || !t.is_face(face) {
                    continue;
                }
                let known = |&e: &Quarter| self.of_face[t.left(sym(e)) as usize] != UNKNOWN;
                inner.extend(t.sides(face).into_iter().find(known));
                while let Some(e) = inner.pop().or_else(|| border.pop()) {
                    if self.of_face[t.left(e) as usize] != UNKNOWN {
                        continue;
                    }
                    self.enter(t, e, &mut scratch, gain);
                    for beyond in [t.lnext(e), t.lprev(e)].map(sym) {
                        if is_free(beyond) {
                            inner.push(beyond);
                        } else if across {
                            border.push(beyond);
                        }
                    }
                }
            }
        }
        self.scratch = scratch;
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
        let from = self.of_face[face as usize];
        let known = |sum: &Sum| (sum.from, sum.feature, sum.winding) == (from, feature, winding);
        if let Some(sum) = self.sum.filter(known) {
            return self.set(face, sum.to);
        }
        let mut windings = std::mem::take(&mut self.scratch);
        windings.clear();
        windings.extend_from_slice(self.windings(face));
        match windings.binary_search_by_key(&feature, |w| w.0) {
            Ok(i) if windings[i].1 + winding == 0 => drop(windings.remove(i)),
            Ok(i) => windings[i].1 += winding,
            Err(i) => windings.insert(i, (feature, winding)),
        }
        let to = self.intern(&windings);
        self.scratch = windings;
        self.sum = Some(Sum {
            from,
            feature,
            winding,
            to,
        });
        self.set(face, to);
    }

    /// Checks, given all faces, that each cover knows how many of them have it, and that the others are vacant.
    pub fn check_counts(&self, faces: impl Iterator<Item = u32>) -> Result<(), String> {
        let mut counts = vec![0; self.interned.len()];
        for face in faces {
            counts[self.of_face[face as usize] as usize] += 1;
        }
        for (id, (cover, &count)) in self.interned.iter().zip(&counts).enumerate() {
            if cover.faces != count {
                return Err(format!(
                    "cover {id}: {count} faces have it, it counts {}",
                    cover.faces
                ));
            }
        }
        let in_use = counts.iter().filter(|&&count| count > 0).count();
        if in_use + self.vacant.len() != counts.len() || in_use != self.ids.len() {
            return Err(format!(
                "{in_use} covers in use, {} of them found by their windings, {} of {} vacant",
                self.ids.len(),
                self.vacant.len(),
                counts.len()
            ));
        }
        Ok(())
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
