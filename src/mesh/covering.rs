//! Keeping the covers of faces right through edits.
//!
//! Faces that an edit made or changed take their cover from a neighbour that it left alone. That is enough for
//! re-routed chains: between an old chain and a new one lie only such faces. A feature that comes or goes
//! also changes the cover of the old faces inside it, which are found from its chain inwards.

use super::cover::{Covers, Windings};
use super::topology::{Quarter, sym};
use super::{FeatureId, Mesh};

impl Mesh {
    /// By how much more each feature winds around the left of an edge than around its right.
    pub(super) fn gain(&self, e: Quarter, gains: &mut Windings) {
        for u in self.uses.of(e) {
            if self.winds[u.segment.index()] {
                let feature = self.segments[u.segment.index()].feature;
                gains.push((feature, if u.forward { 1 } else { -1 }));
            }
        }
    }

    /// By how much more one feature winds around the left of an edge than around its right.
    fn gain_of(&self, feature: FeatureId, e: Quarter) -> i32 {
        let along = |forward: bool| if forward { 1 } else { -1 };
        self.uses
            .of(e)
            .filter(|u| self.segments[u.segment.index()].feature == feature)
            .map(|u| along(u.forward))
            .sum()
    }

    /// Gives new faces their covers, leaving one feature out of account.
    pub(super) fn spread(&mut self, without: Option<FeatureId>) {
        let new = self.triangulation.topology.take_touched();
        let mut covers = std::mem::replace(&mut self.covers, Covers::new());
        let is_free = |e: Quarter| self.uses.is_empty(e);
        covers.spread(&self.triangulation.topology, &new, &is_free, &|e, gains| {
            self.gain(e, gains);
            gains.retain(|g| Some(g.0) != without);
        });
        self.covers = covers;
        self.rewired = new;
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
        let mut found = Vec::new();
        for i in 0..chain.len() {
            let around = self.windings_around(feature, at, winding);
            found.extend(around.iter().map(|&(q, winding)| (t.left(q), winding)));
            let towards = chain[(i + 1) % chain.len()];
            let onwards = around.iter().find(|&&(q, _)| t.dest(q) == towards);
            let &(q, left) = onwards.expect("each piece of a chain is an edge");
            (at, winding) = (t.lnext(q), left);
        }
        found
    }

    /// The edges around the origin of an edge, beginning with it, each with how often a feature winds around
    /// its left face, which is given for the first.
    fn windings_around(
        &self,
        feature: FeatureId,
        at: Quarter,
        winding: i32,
    ) -> Vec<(Quarter, i32)> {
        let mut winding = winding - self.gain_of(feature, at);
        let ring = self.triangulation.topology.ring_from(at);
        ring.map(|q| {
            winding += self.gain_of(feature, q);
            (q, winding)
        })
        .collect()
    }

    /// Takes a feature that is about to be removed out of the covers of the faces inside it.
    pub(super) fn uncover_inside(&mut self, feature: FeatureId) {
        let t = &self.triangulation.topology;
        let mut stack = Vec::new();
        for &s in &self.features[&feature].segments {
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
