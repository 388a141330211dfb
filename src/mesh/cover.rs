//! Provenance of faces: how often each feature winds around them.
//!
//! Few different covers occur among many faces, so they are interned and a face holds a number. The cover of a
//! face follows from that of a neighbour by the uses of the edge between them: who crosses a feature edge to its
//! left enters the feature once more. Opposite directions cancel, duplicates count twice. Covers that no face has
//! any more are dropped and their numbers used again, so that endless edits need no more memory than their mesh.

use super::FeatureId;
use super::buckets::CellHasher;
use super::limit::{MOST_COVERS, Stop};
use super::progress::Part;
use super::regions::Regions;
use super::short::Short;
use super::topology::{NONE, OUTSIDE, Quarter, Topology, sym};
use std::collections::{BTreeSet, HashMap};
use std::hash::{BuildHasherDefault, Hasher};

/// How often each feature winds around a place; ascending by feature, no zeros.
pub type Windings = Vec<(FeatureId, i32)>;

/// Number of an interned cover.
type CoverId = u32;

/// The cover of open country.
const EMPTY: CoverId = 0;
/// The face is new and its cover not known yet.
const UNKNOWN: CoverId = u32::MAX;

/// How often the borders of regions are gone through. What is then unknown, as may be where many lie in one another, is found
/// by walking.
const PASSES: usize = 4;

/// So many borders are gone through between two looks at whether anybody still waits.
const CHECKED: usize = 1024;

#[derive(Clone, Debug)]
struct Cover {
    /// Those that wind around the place in their own sense: all of them, once each, if `odd` does not tell otherwise.
    features: Short<FeatureId, 4>,
    /// All that wind around it, and how often, if some do otherwise than once.
    odd: Option<Box<[(FeatureId, i32)]>>,
    /// The sum of what [`hash_of`] says of each.
    hash: u64,
    /// Whether one of the features is a solid.
    solid: bool,
    /// How many faces have it.
    faces: u32,
    /// Another cover with the same hash.
    next: CoverId,
}

impl Cover {
    fn windings(&self) -> impl Iterator<Item = (FeatureId, i32)> + '_ {
        let once: &[FeatureId] = if self.odd.is_none() {
            &self.features
        } else {
            &[]
        };
        let odd = self.odd.iter().flatten().copied();
        odd.chain(once.iter().map(|&feature| (feature, 1)))
    }
}

/// Covers of all faces.
#[derive(Clone, Debug)]
pub struct Covers {
    interned: Vec<Cover>,
    /// Numbers that can be given away.
    vacant: Vec<CoverId>,
    /// By the hash of its windings the first of the covers that have it.
    ids: HashMap<u64, CoverId, BuildHasherDefault<CellHasher>>,
    of_face: Vec<CoverId>,
    /// Per face: whether a body is stopped by it. The outside stops bodies though nothing covers it.
    solid: Vec<bool>,
    /// How many features the covers have together.
    listed: usize,
    /// Those of the features that stop nobody.
    regions: BTreeSet<FeatureId>,
    /// What was added to what last, and what it gave: faces next to each other mostly have the same cover.
    sum: Option<Sum>,
    /// Scratch for a cover that is not interned yet.
    scratch: Windings,
    /// Scratch for what an edge adds to a cover.
    gains: Windings,
    /// Scratch for the features that it has.
    inside: Vec<FeatureId>,
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
        let empty = Cover {
            features: Short::default(),
            odd: None,
            hash: 0,
            solid: false,
            faces: 1,
            next: NONE,
        };
        let ids = std::iter::once((0, EMPTY)).collect();
        Covers {
            interned: vec![empty],
            vacant: Vec::new(),
            ids,
            of_face: vec![EMPTY],
            solid: vec![true],
            listed: 0,
            regions: BTreeSet::new(),
            sum: None,
            scratch: Windings::new(),
            gains: Windings::new(),
            inside: Vec::new(),
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
    pub fn windings(&self, face: u32) -> impl Iterator<Item = (FeatureId, i32)> + '_ {
        self.interned[self.of_face[face as usize] as usize].windings()
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
    fn intern(&mut self, windings: &[(FeatureId, i32)], hash: u64) -> CoverId {
        let first = self.ids.get(&hash).copied().unwrap_or(NONE);
        let mut at = first;
        while let Some(cover) = self.interned.get(at as usize) {
            if cover.windings().eq(windings.iter().copied()) {
                return at;
            }
            at = cover.next;
        }
        self.listed += windings.len();
        let inside = windings.iter().filter(|w| w.1 > 0).map(|w| w.0);
        self.inside.clear();
        self.inside.extend(inside);
        let cover = Cover {
            odd: windings.iter().any(|w| w.1 != 1).then(|| windings.into()),
            hash,
            features: self.inside.as_slice().into(),
            solid: self.inside.iter().any(|f| !self.regions.contains(f)),
            faces: 0,
            next: first,
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
        self.ids.insert(hash, id);
        id
    }

    /// Lets the number of a cover that no face has be given away.
    fn drop_cover(&mut self, id: CoverId) {
        let Cover { hash, next, .. } = self.interned[id as usize];
        self.listed -= self.interned[id as usize].windings().count();
        let first = self.ids.get(&hash).copied().unwrap_or(NONE);
        if first != id {
            let mut before = first as usize;
            while self.interned[before].next != id {
                before = self.interned[before].next as usize;
            }
            self.interned[before].next = next;
        } else if next == NONE {
            self.ids.remove(&hash);
        } else {
            self.ids.insert(hash, next);
        }
        self.vacant.push(id);
        self.sum = self.sum.filter(|sum| sum.from != id && sum.to != id);
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
            self.drop_cover(id);
        }
    }

    /// Works out the covers of new faces from those of their neighbours.
    ///
    /// `gain` writes by how much more each feature winds around the left of an edge than around its right, ascending by
    /// feature, which may occur several times. Where nothing runs along an edge (`is_free`) there is no difference:
    /// such edges are crossed first, so that the others are asked once per region and not once per face.
    pub fn spread(
        &mut self,
        t: &Topology,
        new: &[u32],
        is_free: &impl Fn(Quarter) -> bool,
        gain: &impl Fn(Quarter, &mut Windings),
    ) {
        self.make_room(t);
        for &face in new {
            self.forget(face);
        }
        // First from face to face as they lie in memory, each with what no edge parts from it; then, wherever that found nothing
        // to begin with, on across the borders.
        let (mut inner, mut border) = (Vec::with_capacity(64), Vec::new());
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
                    let from = self.of_face[t.left(sym(e)) as usize];
                    let cover = self.beyond(e, from, gain);
                    self.set(t.left(e), cover);
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
    }

    /// The same for all faces of a mesh that was made at once: region by region, and the borders between them as they lie in
    /// memory, forth and back.
    ///
    /// # Errors
    /// Nobody waits for it any more, or it is too much and there is a bound.
    pub fn spread_first(
        &mut self,
        t: &Topology,
        is_free: &impl Fn(Quarter) -> bool,
        gain: &impl Fn(Quarter, &mut Windings),
        bounded: bool,
        part: Part,
    ) -> Result<(), Stop> {
        self.make_room(t);
        for face in t.faces() {
            self.forget(face);
        }
        let Regions {
            of_face,
            mut borders,
        } = Regions::of(t, is_free);
        let (all, mut stopped) = (borders.len(), None);
        for pass in 0..PASSES {
            let part = part.between(pass as f32 / PASSES as f32, 1.0);
            let mut seen = 0;
            borders.retain(|&border| {
                seen += 1;
                if seen % CHECKED == 0 {
                    let stop = part.done(seen, PASSES * all).err().map(Stop::from);
                    let large = bounded && self.listed > MOST_COVERS;
                    stopped = stopped.or(stop).or(large.then_some(Stop::TooMuch));
                }
                if stopped.is_some() {
                    return true;
                }
                let known = |region: u32| self.of_face[region as usize] != UNKNOWN;
                let border = match (known(border.left), known(border.right)) {
                    (false, true) => border,
                    (true, false) => border.turned(),
                    (left, right) => return !left && !right,
                };
                let from = self.of_face[border.right as usize];
                let cover = self.beyond(border.edge, from, gain);
                self.set(border.left, cover);
                false
            });
            borders.reverse();
        }
        if let Some(stop) = stopped {
            return Err(stop);
        }
        let mut unknown = Vec::new();
        for face in t.faces() {
            match self.of_face[of_face[face as usize] as usize] {
                UNKNOWN => unknown.push(face),
                cover if of_face[face as usize] != face => self.set(face, cover),
                _ => {}
            }
        }
        self.spread(t, &unknown, is_free, gain);
        Ok(())
    }

    /// Makes room for the covers of all faces.
    fn make_room(&mut self, t: &Topology) {
        self.of_face.resize(t.face_count(), UNKNOWN);
        self.solid.resize(t.face_count(), false);
    }

    /// The cover left of an edge, given that on its right.
    fn beyond(
        &mut self,
        e: Quarter,
        from: CoverId,
        gain: &impl Fn(Quarter, &mut Windings),
    ) -> CoverId {
        self.gains.clear();
        gain(e, &mut self.gains);
        if self.gains.is_empty() {
            return from;
        }
        let mut sum = std::mem::take(&mut self.scratch);
        sum.clear();
        let before = &self.interned[from as usize];
        let change = add(before.windings(), &self.gains, &mut sum);
        let cover = self.intern(&sum, before.hash.wrapping_add(change));
        self.scratch = sum;
        cover
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
        let before = &self.interned[from as usize];
        let change = add(before.windings(), &[(feature, winding)], &mut windings);
        let to = self.intern(&windings, before.hash.wrapping_add(change));
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
        let next = |&id: &CoverId| Some(self.interned[id as usize].next).filter(|&id| id != NONE);
        let found = |&first: &CoverId| std::iter::successors(Some(first), next).count();
        let listed: usize = self.ids.values().map(found).sum();
        if in_use + self.vacant.len() != counts.len() || in_use != listed {
            return Err(format!(
                "{in_use} covers in use, {listed} of them found by their windings, {} of {} vacant",
                self.vacant.len(),
                counts.len()
            ));
        }
        Ok(())
    }

    /// How often a feature winds around a face.
    pub fn winding(&self, face: u32, feature: FeatureId) -> i32 {
        let Cover { features, odd, .. } = &self.interned[self.of_face[face as usize] as usize];
        match odd {
            Some(all) => {
                let found = all.binary_search_by_key(&feature, |w| w.0);
                found.map_or(0, |i| all[i].1)
            }
            None => i32::from(features.binary_search(&feature).is_ok()),
        }
    }
}

/// What a feature adds to the hash of a cover: nothing if it does not wind at all. Other covers may have the same hash.
fn hash_of(feature: FeatureId, winding: i32) -> u64 {
    if winding == 0 {
        return 0;
    }
    let mut hasher = CellHasher::default();
    hasher.write_u64(u64::from(feature) << 32 | u64::from(winding as u32));
    hasher.finish()
}

/// Writes what windings and gains, both ascending by feature, come to together. Returns what that adds to the hash.
fn add(
    windings: impl Iterator<Item = (FeatureId, i32)>,
    gains: &[(FeatureId, i32)],
    sum: &mut Windings,
) -> u64 {
    let (mut windings, mut change) = (windings.peekable(), 0_u64);
    for gains in gains.chunk_by(|g, h| g.0 == h.0) {
        let feature = gains[0].0;
        while let Some(smaller) = windings.next_if(|w| w.0 < feature) {
            sum.push(smaller);
        }
        let before = windings.next_if(|w| w.0 == feature).map_or(0, |w| w.1);
        let after = before + gains.iter().map(|g| g.1).sum::<i32>();
        if after != 0 {
            sum.push((feature, after));
        }
        let [before, after] = [before, after].map(|winding| hash_of(feature, winding));
        change = change.wrapping_sub(before).wrapping_add(after);
    }
    sum.extend(windings);
    change
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
