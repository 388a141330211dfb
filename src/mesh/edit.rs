//! Putting features into the mesh and taking them out.
//!
//! An edit goes through the layers from top to bottom: the arrangement says which chains change; all
//! of these are taken out of the triangulation, dead vertices are deleted and new ones inserted, and all chains
//! are put in; then the faces that are new get their covers. Work is bounded by what lies near the edit.

use super::cover::Covers;
use super::hilbert::hilbert;
use super::limit::Stop;
use super::progress::{Left, Part, Phase};
use super::snap::{Arrangement, Diff};
use super::topology::Quarter;
use super::triangulation::{CORNERS, EDGE_OF_WORLD, Triangulation};
use super::uses::{Owner, Uses};
use super::{Feature, FeatureId, Kind, Mesh, MeshError, Segment, SegmentId, VertexId};
use crate::geom::{ExpandedEdge, Point};
use std::collections::{BTreeMap, BTreeSet};

/// Binary logarithm of the cell size of a mesh without segments to judge by: 1 m.
const DEFAULT_SHIFT: u32 = 16;

/// Binary logarithm of the smallest cell size, 4 mm: a segment right across the world then still has few cells.
const MIN_SHIFT: u32 = 8;

/// Before all others go in the first vertices of every so many-th segment: with some vertices all over the place the others
/// find short ways to where they belong, and few edges to flip.
const SAMPLES: [usize; 2] = [64, 8];

/// The vertices of longer chains go in as neighbours in the plane follow one another. Along a chain each would have to flip the
/// edges that the one before has drawn to the vertices ahead.
const LONG: usize = 24;

/// A feature on its way into the mesh.
#[derive(Clone, Copy)]
pub(super) struct Entry<'a> {
    pub id: FeatureId,
    kind: Kind,
    pub edges: &'a [ExpandedEdge],
}

impl Mesh {
    /// The mesh of solids with ids 0, 1, 2 ... in order.
    ///
    /// Edges that form one closed chain cover what it winds around, the solid on their left. Others are
    /// *wires*: they are in the mesh and cover nothing.
    ///
    /// # Errors
    /// If an edge leaves the world or has no length, or the mesh would be too large.
    pub fn build(features: &[Vec<ExpandedEdge>]) -> Result<Mesh, MeshError> {
        let kind = Kind::Solid;
        let entry = |(id, edges)| Entry { id, kind, edges };
        let edges = features.iter().map(Vec::as_slice);
        Self::assemble((0..).zip(edges).map(entry).collect(), Part::UNSEEN)
    }

    /// The mesh of features of any kinds, with ids of the caller's choice.
    ///
    /// # Errors
    /// If two have the same id, or an edge leaves the world or has no length, or the mesh would be too large.
    pub fn of(features: &[(FeatureId, Kind, Vec<ExpandedEdge>)]) -> Result<Mesh, MeshError> {
        Self::watched(features, Part::UNSEEN)
    }

    /// The same, as a part of long work that others wait for.
    ///
    /// # Errors
    /// As for [`Mesh::of`], or if nobody waits for it any more.
    pub fn watched(
        features: &[(FeatureId, Kind, Vec<ExpandedEdge>)],
        part: Part,
    ) -> Result<Mesh, MeshError> {
        let mut seen = BTreeSet::new();
        if let Some(&(feature, ..)) = features.iter().find(|f| !seen.insert(f.0)) {
            return Err(MeshError::Occupied { feature });
        }
        let entries = features.iter().map(|(id, kind, edges)| Entry {
            id: *id,
            kind: *kind,
            edges,
        });
        Self::assemble(entries.collect(), part)
    }

    /// The mesh of features whose ids differ.
    fn assemble(mut batch: Vec<Entry>, part: Part) -> Result<Mesh, MeshError> {
        for entry in &batch {
            check(entry)?;
        }
        let mut mesh = Mesh::empty(usual_shift(&batch));
        // Neighbours in the plane become neighbours in memory.
        batch.sort_by_cached_key(|entry| entry.edges.first().map(|e| hilbert(e.a)));
        match mesh.fill(&batch, part) {
            Ok(()) => Ok(mesh),
            Err(stop) => Err(stop.told_of(&batch)),
        }
    }

    /// Adds checked features to an empty mesh.
    fn fill(&mut self, batch: &[Entry], part: Part) -> Result<(), Stop> {
        self.put(batch, true, part.between(0.0, 0.85))?;
        self.spread_first(true, part.between(0.85, 1.0))?;
        Ok(part.done(1, 1)?)
    }

    /// A mesh without features, with buckets of 2^shift steps.
    fn empty(shift: u32) -> Mesh {
        let mut mesh = Mesh {
            arrangement: Arrangement::new(shift, &CORNERS),
            triangulation: Triangulation::new(),
            uses: Uses::default(),
            covers: Covers::new(),
            segments: Vec::new(),
            kinds: Vec::new(),
            winds: Vec::new(),
            features: BTreeMap::new(),
            rewired: Vec::new(),
            buried: 0,
        };
        mesh.spread_first(false, Part::UNSEEN)
            .expect("there is no bound, and nobody to leave");
        mesh
    }

    /// Adds a solid under an id of the caller's choice.
    ///
    /// # Errors
    /// If the id is taken, or an edge leaves the world or has no length; then nothing has changed.
    pub fn insert(&mut self, feature: FeatureId, edges: &[ExpandedEdge]) -> Result<(), MeshError> {
        self.insert_as(feature, Kind::Solid, edges)
    }

    /// Adds a feature of some kind under an id of the caller's choice.
    ///
    /// # Errors
    /// If the id is taken, or an edge leaves the world or has no length; then nothing has changed.
    pub fn insert_as(
        &mut self,
        feature: FeatureId,
        kind: Kind,
        edges: &[ExpandedEdge],
    ) -> Result<(), MeshError> {
        if self.features.contains_key(&feature) {
            return Err(MeshError::Occupied { feature });
        }
        let id = feature;
        let entry = Entry { id, kind, edges };
        check(&entry)?;
        self.put(&[entry], false, Part::UNSEEN)
            .map_err(|stop| stop.told_of(&[entry]))?;
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
        let removed = self
            .arrangement
            .edit(&[], &segments, false, Part::UNSEEN)
            .and_then(|diff| self.apply(&diff, Part::UNSEEN));
        removed.map_err(|stop| stop.told_of(&[]))?;
        self.spread(None);
        self.covers.set_region(feature, false);
        Ok(())
    }

    /// Adds checked features to everything but the covers.
    fn put(&mut self, batch: &[Entry], bounded: bool, part: Part) -> Result<(), Stop> {
        let edges = batch.iter().flat_map(|entry| entry.edges);
        let ends: Vec<(Point, Point)> = edges.map(|e| (e.a, e.b)).collect();
        let snapped = part.between(0.0, 0.4);
        let diff = self.arrangement.edit(&ends, &[], bounded, snapped)?;
        let mut ids = diff.added.as_slice();
        for entry in batch {
            let (own, rest) = ids.split_at(entry.edges.len());
            self.record(entry, own);
            ids = rest;
        }
        self.apply(&diff, part.between(0.4, 1.0))
    }

    /// Notes which segments are whose.
    fn record(&mut self, entry: &Entry, ids: &[SegmentId]) {
        let &Entry { id, kind, edges } = entry;
        let (feature, winds) = (id, !kind.has_fronts() && is_closed(edges));
        for (id, edge) in ids.iter().zip(edges) {
            let &ExpandedEdge {
                a,
                b,
                source,
                aside,
            } = edge;
            let segment = Segment {
                a,
                b,
                feature,
                source,
                aside,
            };
            if id.index() == self.segments.len() {
                self.segments.push(segment);
                self.kinds.push(kind);
                self.winds.push(winds);
            }
            self.segments[id.index()] = segment;
            self.kinds[id.index()] = kind;
            self.winds[id.index()] = winds;
        }
        self.covers.set_region(feature, kind == Kind::Region);
        let segments = ids.to_vec();
        let mut by_source = segments.clone();
        by_source.sort_unstable_by_key(|&s| (self.segments[s.index()].source, s));
        self.features.insert(
            feature,
            Feature {
                kind,
                segments,
                by_source,
                winds,
            },
        );
    }

    /// Makes the triangulation follow the arrangement: all changed chains out, then all in.
    fn apply(&mut self, diff: &Diff, part: Part) -> Result<(), Stop> {
        self.buried = diff.dead.len();
        for route in &diff.rerouted {
            for pair in route.old.windows(2) {
                let e = self.piece(pair);
                self.uses.remove(e, route.segment);
                if self.uses.is_empty(e) {
                    self.triangulation.release(e);
                }
            }
        }
        for v in &diff.dead {
            self.triangulation.delete(v.0);
        }
        self.triangulation.legalise();
        self.triangulation.reserve(diff.born.len());
        self.uses
            .reserve(3 * diff.born.len(), diff.added.len() + diff.born.len());
        let first = diff.born.first();
        if let Some(v) = first.and_then(|&first| self.neighbour(first)) {
            self.triangulation.start_at(v.0);
        }
        for step in SAMPLES {
            for &segment in diff.added.iter().step_by(step) {
                let v = self.arrangement.chain(segment)[0];
                settle(&mut self.triangulation, &self.arrangement, v);
            }
        }
        let (crowds, chains) = (part.between(0.0, 0.5), part.between(0.5, 1.0));
        crowds.begin(Phase::Triangulating)?;
        self.settle_crowds(diff, crowds)?;
        // Every other new vertex is on an added chain, too: its place is found from the vertex before.
        for (i, &segment) in diff.added.iter().enumerate() {
            self.lay(segment, None);
            chains.done(i, diff.added.len())?;
        }
        for route in &diff.rerouted {
            self.lay(route.segment, Some(&route.new));
        }
        self.uses.settle(&self.segments);
        Ok(())
    }

    /// Puts the vertices of long chains into the triangulation, without their edges.
    fn settle_crowds(&mut self, diff: &Diff, part: Part) -> Result<(), Left> {
        let chains = diff.added.iter().map(|&s| self.arrangement.chain(s));
        let long = chains.filter(|chain| chain.len() > LONG).flatten();
        let is_new = |v: &VertexId| !self.triangulation.topology.has_vertex(v.0);
        let mut crowd: Vec<VertexId> = long.copied().filter(is_new).collect();
        crowd.sort_unstable();
        crowd.dedup();
        crowd.sort_by_cached_key(|&v| hilbert(self.arrangement.point(v)));
        for step in SAMPLES.into_iter().chain([1]) {
            for (i, &v) in crowd.iter().enumerate().step_by(step) {
                settle(&mut self.triangulation, &self.arrangement, v);
                part.done(i / step, crowd.len())?;
            }
        }
        Ok(())
    }

    /// Puts a chain into the triangulation, or the stretch of it that is not there.
    fn lay(&mut self, segment: SegmentId, stretch: Option<&[VertexId]>) {
        let owner = Owner {
            feature: self.segments[segment.index()].feature,
            has_fronts: self.kinds[segment.index()].has_fronts(),
            winds: self.winds[segment.index()],
        };
        let Mesh {
            arrangement,
            triangulation,
            uses,
            segments,
            ..
        } = self;
        let mut before = None;
        for &v in stretch.unwrap_or(arrangement.chain(segment)) {
            settle(triangulation, arrangement, v);
            if let Some(before) = before {
                let e = triangulation.enforce(before, v.0);
                uses.add(e, segment, owner, segments);
            }
            before = Some(v.0);
        }
    }

    /// A vertex of the triangulation near one that is not in it yet: a short way to where it belongs, however large the mesh.
    fn neighbour(&self, v: VertexId) -> Option<VertexId> {
        let p = self.arrangement.point(v);
        let is_there = |v: &VertexId| self.triangulation.topology.has_vertex(v.0);
        self.arrangement.near(p).find(is_there)
    }

    /// The edge between two consecutive vertices of a chain that is in the triangulation.
    pub(super) fn piece(&self, pair: &[VertexId]) -> Quarter {
        let edge = self
            .triangulation
            .topology
            .edge_between(pair[0].0, pair[1].0);
        edge.expect("each piece of a chain is an edge")
    }
}

/// Inserts a vertex into the triangulation, if it is not there, and lets the next one look for its place from there.
fn settle(triangulation: &mut Triangulation, arrangement: &Arrangement, v: VertexId) {
    if !triangulation.topology.has_vertex(v.0) {
        triangulation.insert(v.0, arrangement.point(v));
    }
    triangulation.start_at(v.0);
}

/// Checks the edges of a feature at the door.
fn check(entry: &Entry) -> Result<(), MeshError> {
    let &Entry {
        id: feature, edges, ..
    } = entry;
    let inside = |p: Point| p.x.unsigned_abs().max(p.y.unsigned_abs()) < EDGE_OF_WORLD as u32;
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
fn usual_shift(batch: &[Entry]) -> u32 {
    let length = |e: &ExpandedEdge| u64::from(e.a.x.abs_diff(e.b.x).max(e.a.y.abs_diff(e.b.y)));
    let count = batch.iter().map(|entry| entry.edges.len()).sum::<usize>() as u64;
    let total: u64 = batch.iter().flat_map(|entry| entry.edges).map(length).sum();
    total
        .checked_div(count)
        .and_then(u64::checked_ilog2)
        .map_or(DEFAULT_SHIFT, |shift| shift.max(MIN_SHIFT))
}
