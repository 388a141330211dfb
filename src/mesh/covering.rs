//! Keeping the covers of faces right through edits.
//!
//! Faces that an edit made or changed take their cover from a neighbour that it left alone. That is enough for
//! re-routed chains: between an old chain and a new one lie only such faces. A feature that comes or goes
//! also changes the cover of the old faces inside it, which are found from its chain inwards.

use super::cover::Windings;
use super::limit::Stop;
use super::progress::{Part, Phase};
use super::topology::{Quarter, sym};
use super::{FeatureId, Mesh};

impl Mesh {
    /// By how much more each feature winds around the left of an edge than around its right.
    pub(super) fn gain(&self, e: Quarter, gains: &mut Windings) {
        gains.extend(self.uses.gains(e));
    }

    /// By how much more one feature winds around the left of an edge than around its right.
    fn gain_of(&self, feature: FeatureId, e: Quarter) -> i32 {
        let own = self.uses.gains(e).filter(|g| g.0 == feature);
        own.map(|g| g.1).sum()
    }

    /// Gives all faces of a mesh that was built at once their covers.
    pub(super) fn spread_first(&mut self, bounded: bool, part: Part) -> Result<(), Stop> {
        part.begin(Phase::Covering)?;
        let topology = &mut self.triangulation.topology;
        topology.take_touched(&mut self.rewired);
        let uses = &self.uses;
        let is_free = |e: Quarter| uses.is_empty(e);
        let gain = |e, gains: &mut Windings| gains.extend(uses.gains(e));
        self.covers
            .spread_first(topology, &is_free, &gain, bounded, part)
    }

    /// Gives new faces their covers, leaving one feature out of account.
    pub(super) fn spread(&mut self, without: Option<FeatureId>) {
        let topology = &mut self.triangulation.topology;
        topology.take_touched(&mut self.rewired);
        let uses = &self.uses;
        let is_free = |e: Quarter| uses.is_empty(e);
        let others = |e, gains: &mut Windings| {
            gains.extend(uses.gains(e).filter(|g| Some(g.0) != without));
        };
        self.covers
            .spread(topology, &self.rewired, &is_free, &others);
    }

    /// Adds a feature that was just inserted to the covers of the faces inside it.
    pub(super) fn cover_inside(&mut self, feature: FeatureId) {
        if !self.features[&feature].winds {
            return;
        }
        let mut stack = self.windings_along(feature);
        stack.retain(|s| s.1 != 0);
        while let Some((face, winding)) = stack.pop() {
            if self.covers.winding(face, feature) != 0 {
                continue;
            }
            self.covers.add(face, feature, winding);
            for e in self.triangulation.topology.sides(face).map(sym) {
                let beyond = winding + self.gain_of(feature, e);
                if beyond != 0 {
                    stack.push((self.triangulation.topology.left(e), beyond));
                }
            }
        }
    }

    /// How often a closed feature winds around each face that has a corner on its chain; faces may recur.
    ///
    /// Beyond the lexicographically smallest vertex of the chain it does not wind at all; from there the
    /// count is carried around that vertex, and along the chain around each of the others.
    fn windings_along(&self, feature: FeatureId) -> Vec<(u32, i32)> {
        let t = &self.triangulation.topology;
        let point = |v: u32| self.triangulation.point(v);
        let segments = &self.features[&feature].segments;
        let pieces = segments
            .iter()
            .flat_map(|&s| self.arrangement.chain(s).windows(2));
        let mut chain: Vec<u32> = pieces.map(|pair| pair[0].0).collect();
        let first = (0..chain.len()).min_by_key(|&i| point(chain[i]));
        chain.rotate_left(first.unwrap_or(0));
        let beyond = |&q: &Quarter| point(t.dest(q)) < point(chain[0]);
        let way_out = t.ring(chain[0]).find(beyond);
        let mut at = way_out.expect("the outer box lies around every feature");
        let mut winding = 0;
        let mut found = Vec::with_capacity(8 * chain.len());
        for i in 0..chain.len() {
            // Around the vertex from `at`, left of which the winding is known.
            let (towards, mut onwards) = (chain[(i + 1) % chain.len()], None);
            winding -= self.gain_of(feature, at);
            for q in t.ring_from(at) {
                winding += self.gain_of(feature, q);
                found.push((t.left(q), winding));
                if t.dest(q) == towards {
                    onwards = Some((t.lnext(q), winding));
                }
            }
            (at, winding) = onwards.expect("each piece of a chain is an edge");
        }
        found
    }

    /// Takes a feature that is about to be removed out of the covers of the faces inside it.
    pub(super) fn uncover_inside(&mut self, feature: FeatureId) {
        let t = &self.triangulation.topology;
        let segments = &self.features[&feature].segments;
        let mut stack = Vec::with_capacity(8 * segments.len());
        for &s in segments {
            for pair in self.arrangement.chain(s).windows(2) {
                let e = self.piece(pair);
                stack.extend([t.left(e), t.left(sym(e))]);
            }
        }
        while let Some(face) = stack.pop() {
            let winding = self.covers.winding(face, feature);
            if winding != 0 {
                self.covers.add(face, feature, -winding);
                stack.extend(t.sides(face).map(|e| t.left(sym(e))));
            }
        }
    }
}
