//! Putting features into the mesh and taking them out.
//!
//! An edit goes through the layers from top to bottom: the arrangement says which chains change; all
//! of these are taken out of the triangulation, dead vertices are deleted and new ones inserted, and all chains
//! are put in; then the faces that are new get their covers. Work is bounded by what lies near the edit.

use super::cover::{Covers, Windings, merged};
use super::snap::{Arrangement, Diff};
use super::topology::{Quarter, sym};
use super::triangulation::{CORNERS, EDGE_OF_WORLD, Triangulation};
use super::uses::Uses;
use super::{Feature, FeatureId, Mesh, MeshError, Segment, SegmentId, VertexId};
use crate::geom::{ExpandedEdge, Point};
use std::collections::BTreeMap;

/// Binary logarithm of the cell size of a mesh without segments to judge by: 1 m.
const DEFAULT_SHIFT: u32 = 16;

impl Mesh {
    /// The mesh of features with ids 0, 1, 2 ... in order.
    ///
    /// Edges that form one closed chain cover what it winds around, the solid on their left. Others are
    /// *wires*: they are in the mesh and cover nothing.
    ///
    /// # Errors
    /// If an edge leaves the world or has no length.
    pub fn build(features: &[Vec<ExpandedEdge>]) -> Result<Mesh, MeshError> {
        let batch: Vec<(FeatureId, &[ExpandedEdge])> =
            (0..).zip(features.iter().map(Vec::as_slice)).collect();
        for (id, edges) in &batch {
            check(*id, edges)?;
        }
        let mut mesh = Mesh::empty(usual_shift(features));
        mesh.put(&batch);
        mesh.spread(None);
        Ok(mesh)
    }

    /// A mesh without features, with buckets of 2^shift steps.
    fn empty(shift: u32) -> Mesh {
        let mut mesh = Mesh {
            arrangement: Arrangement::new(shift, &CORNERS),
            triangulation: Triangulation::new(),
            uses: Uses::default(),
            covers: Covers::new(),
            segments: Vec::new(),
            features: BTreeMap::new(),
            rewired: 0,
        };
        mesh.spread(None);
        mesh
    }

    /// Adds a feature under an id of the caller's choice.
    ///
    /// # Errors
    /// If the id is taken, or an edge leaves the world or has no length; then nothing has changed.
    pub fn insert(&mut self, feature: FeatureId, edges: &[ExpandedEdge]) -> Result<(), MeshError> {
        if self.features.contains_key(&feature) {
            return Err(MeshError::Occupied { feature });
        }
        check(feature, edges)?;
        self.put(&[(feature, edges)]);
        self.spread(Some(feature));
        self.cover_inside(feature);
        Ok(())
    }

    /// Removes a feature.
    ///
    /// # Errors
    /// If there is none with this id.
    pub fn remove(&mut self, feature: FeatureId) -> Result<(), MeshError> {
        if !self.features.contains_key(&feature) {
            return Err(MeshError::Unknown { feature });
        }
        self.uncover_inside(feature);
        let segments = self
            .features
            .remove(&feature)
            .map(|f| f.segments)
            .unwrap_or_default();
        let (_, diff) = self.arrangement.edit(&[], &segments);
        self.apply(&diff);
        self.spread(None);
        Ok(())
    }

    /// Adds checked features to everything but the covers.
    fn put(&mut self, batch: &[(FeatureId, &[ExpandedEdge])]) {
        let ends: Vec<(Point, Point)> = batch
            .iter()
            .flat_map(|(_, edges)| edges.iter().map(|e| (e.a, e.b)))
            .collect();
        let (ids, diff) = self.arrangement.edit(&ends, &[]);
        let mut ids = ids.into_iter();
        for &(feature, edges) in batch {
            let segments: Vec<SegmentId> = ids.by_ref().take(edges.len()).collect();
            for (&id, &ExpandedEdge { a, b, source }) in segments.iter().zip(edges) {
                let segment = Segment {
                    a,
                    b,
                    feature,
                    source,
                };
                match self.segments.get_mut(id.index()) {
                    Some(free) => *free = segment,
                    None => self.segments.push(segment),
                }
            }
            let mut by_source: Vec<_> = segments
                .iter()
                .zip(edges)
                .map(|(&id, e)| (e.source, id))
                .collect();
            by_source.sort_unstable();
            let closed = is_closed(edges);
            self.features.insert(
                feature,
                Feature {
                    segments,
                    by_source,
                    closed,
                },
            );
        }
        self.apply(&diff);
    }

    /// Makes the triangulation follow the arrangement: all changed chains out, then all in.
    fn apply(&mut self, diff: &Diff) {
        for route in &diff.rerouted {
            for pair in route.old.windows(2) {
                let e = self
                    .triangulation
                    .topology
                    .edge_between(pair[0].0, pair[1].0);
                let e = e.expect("each piece of a chain is an edge");
                self.uses.remove(e, route.slot);
                if self.uses.is_empty(e) {
                    self.triangulation.release(e);
                }
            }
        }
        for v in &diff.dead {
            self.triangulation.delete(v.0);
        }
        self.triangulation.legalise();
        for v in self.nearby_order(&diff.born) {
            self.triangulation
                .insert(v.0, self.arrangement.points()[v.index()]);
        }
        for route in &diff.rerouted {
            for pair in route.new.windows(2) {
                let e = self.triangulation.enforce(pair[0].0, pair[1].0);
                self.triangulation.fix(e);
                self.uses.add(e, route.slot, &self.segments);
            }
        }
        self.triangulation.legalise();
    }

    /// Vertices in an order in which neighbours in the list are mostly neighbours in the plane.
    fn nearby_order(&self, vertices: &[VertexId]) -> Vec<VertexId> {
        let mut keyed: Vec<(u64, VertexId)> = vertices
            .iter()
            .map(|&v| (hilbert(self.arrangement.points()[v.index()]), v))
            .collect();
        keyed.sort_unstable();
        keyed.into_iter().map(|(_, v)| v).collect()
    }
}

// Covers.
impl Mesh {
    /// By how much more each feature winds around the left of an edge than around its right.
    pub(super) fn gain(&self, e: Quarter, gains: &mut Windings) {
        for u in self.uses.of(e) {
            let feature = self.segments[u.segment.index()].feature;
            if self.features[&feature].closed {
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
    fn spread(&mut self, without: Option<FeatureId>) {
        let new = self.triangulation.topology.take_touched();
        self.rewired = new.len();
        let mut covers = std::mem::replace(&mut self.covers, Covers::new());
        covers.spread(&self.triangulation.topology, &new, &|e, gains| {
            self.gain(e, gains);
            gains.retain(|g| Some(g.0) != without);
            *gains = merged(std::mem::take(gains));
        });
        self.covers = covers;
    }

    /// Adds a feature that was just inserted to the covers of the faces inside it.
    fn cover_inside(&mut self, feature: FeatureId) {
        if !self.features[&feature].closed {
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
        let pieces = self.features[&feature]
            .segments
            .iter()
            .flat_map(|&s| self.arrangement.chain(s).windows(2));
        let mut chain: Vec<u32> = pieces.map(|pair| pair[0].0).collect();
        let point = |v: u32| self.triangulation.point(v);
        let first = (0..chain.len())
            .min_by_key(|&i| point(chain[i]))
            .unwrap_or(0);
        chain.rotate_left(first);
        let mut at = t
            .ring(chain[0])
            .find(|&q| point(t.dest(q)) < point(chain[0]))
            .expect("the outer box lies around every feature");
        let mut winding = 0;
        let mut found = Vec::new();
        for i in 0..chain.len() {
            // Around chain[i], from the face left of `at`.
            let towards = chain[(i + 1) % chain.len()];
            let (start, mut next) = (at, None);
            loop {
                found.push((t.left(at), winding));
                if t.dest(at) == towards {
                    next = Some((t.lnext(at), winding));
                }
                at = t.onext(at);
                if at == start {
                    break;
                }
                winding += self.gain_of(feature, at);
            }
            (at, winding) = next.expect("each piece of a chain is an edge");
        }
        found
    }

    /// Takes a feature that is about to be removed out of the covers of the faces inside it.
    fn uncover_inside(&mut self, feature: FeatureId) {
        let t = &self.triangulation.topology;
        let mut stack = Vec::new();
        for &s in &self.features[&feature].segments {
            for pair in self.arrangement.chain(s).windows(2) {
                let e = t
                    .edge_between(pair[0].0, pair[1].0)
                    .expect("each piece of a chain is an edge");
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

/// Checks the edges of a feature at the door.
fn check(feature: FeatureId, edges: &[ExpandedEdge]) -> Result<(), MeshError> {
    let inside = |p: Point| p.x.abs() < EDGE_OF_WORLD && p.y.abs() < EDGE_OF_WORLD;
    for (edge, e) in edges.iter().enumerate() {
        if !(inside(e.a) && inside(e.b)) {
            return Err(MeshError::OutOfBounds { feature, edge });
        }
        if e.a == e.b {
            return Err(MeshError::ZeroLength { feature, edge });
        }
    }
    Ok(())
}

/// Whether edges form one closed chain, each starting where the one before ends.
fn is_closed(edges: &[ExpandedEdge]) -> bool {
    !edges.is_empty() && (0..edges.len()).all(|i| edges[i].b == edges[(i + 1) % edges.len()].a)
}

/// Binary logarithm of the mean length of the edges.
fn usual_shift(features: &[Vec<ExpandedEdge>]) -> u32 {
    let length = |e: &ExpandedEdge| u64::from(e.a.x.abs_diff(e.b.x).max(e.a.y.abs_diff(e.b.y)));
    let count = features.iter().map(Vec::len).sum::<usize>() as u64;
    let total: u64 = features.iter().flatten().map(length).sum();
    total
        .checked_div(count)
        .and_then(u64::checked_ilog2)
        .unwrap_or(DEFAULT_SHIFT)
}

/// Position of a point along a Hilbert curve through the world (Hilbert 1891), 29 levels deep.
fn hilbert(p: Point) -> u64 {
    let (mut x, mut y) = ((p.x + EDGE_OF_WORLD) as u32, (p.y + EDGE_OF_WORLD) as u32);
    let mut along = 0;
    for level in (0..29).rev() {
        let (right, up) = ((x >> level) & 1, (y >> level) & 1);
        along = (along << 2) | u64::from((3 * right) ^ up);
        // Turn the quadrant so that the curve inside it starts and ends where it should.
        if up == 0 {
            if right == 1 {
                (x, y) = (!x, !y);
            }
            (x, y) = (y, x);
        }
    }
    along
}
