//! The constrained Delaunay mesh of a set of features, each expanded by one collider.
//!
//! ```text
//! snap           segments -> hot pixels and chains     the set of segments decides, exactly
//! triangulation  chains -> triangles                   legal, with ties broken by rule
//! uses, cover    which features run along an edge, which lie around a face
//! walk           where is a position
//! sweep, cast    what a straight line passes, and what stops it
//! query          nearest wall, overlap, free neighbours
//! surfaces       chains of ground, and which are next to which
//! check, hash    every invariant as a function; equal meshes have equal hashes
//! ```
//!
//! The mesh is a pure function of the set of features and their ids: building it at once, or by any sequence
//! of [`Mesh::insert`] and [`Mesh::remove`], gives the same hash.

mod buckets;
mod cast;
mod check;
mod cover;
mod covering;
mod edit;
mod enforce;
mod hash;
mod hilbert;
mod limit;
mod progress;
mod query;
mod regions;
mod short;
mod snap;
mod surfaces;
mod sweep;
mod topology;
mod triangulation;
mod uses;
mod walk;

use crate::geom::{Aside, Drawn, Point, predicates};
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

pub use crate::geom::{ExpandedEdge, Source};
pub use cast::{Cast, Hit};
pub use limit::MOST_VERTICES;
pub use progress::{Left, Part, Phase, Progress};
pub use query::{Nearest, Overlap};
pub use surfaces::{Surface, Surfaces};
pub use sweep::{Pass, Sweep};

/// Index of a feature in the list the mesh was built from.
pub type FeatureId = u32;

/// What a feature does to bodies.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub enum Kind {
    /// A closed chain of edges that stops bodies outside it. If it is open it is a *wire*: in the mesh, and no more.
    #[default]
    Solid,
    /// Edges that may stop a body that comes from their *front*, the side on their right; they cover nothing.
    OneWay,
    /// A closed chain of edges around a place that bodies can be in; it stops nobody.
    Region,
    /// Edges without anything between them that stop a body from either side: each comes twice, there and back.
    Line,
}

impl Kind {
    /// Whether its edges stop bodies by what they are, and not by what they enclose.
    pub(crate) fn has_fronts(self) -> bool {
        matches!(self, Kind::OneWay | Kind::Line)
    }
}

/// A directed primal edge of the quad-edge structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct EdgeId(pub u32);
/// A triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct FaceId(pub u32);
/// A mesh vertex.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
pub struct VertexId(pub u32);
/// A feature edge: one edge of one expanded outline, as it was before anything cut it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct SegmentId(pub u32);

impl VertexId {
    fn index(self) -> usize {
        self.0 as usize
    }
}

impl SegmentId {
    fn index(self) -> usize {
        self.0 as usize
    }
}

/// A feature edge. The solid or the region is on its left, the front of a one-way on its right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Segment {
    /// Start.
    pub a: Point,
    /// End.
    pub b: Point,
    /// The feature whose expanded outline it belongs to.
    pub feature: FeatureId,
    /// What it comes from.
    pub source: Source,
    /// How far beside its ends it was drawn.
    pub aside: Aside,
}

impl Segment {
    /// Its ends as they were drawn.
    pub fn drawn(&self) -> [Drawn; 2] {
        self.aside.ends(self.a, self.b)
    }

    /// A vertex of it as it was drawn: where it starts or ends; any other is where the grid has it.
    pub fn drawn_at(&self, vertex: Point) -> Drawn {
        let [a, b] = self.drawn();
        match () {
            () if vertex == self.a => a,
            () if vertex == self.b => b,
            () => vertex.into(),
        }
    }

    /// From its start to its end as it was drawn, in parts; of an edge on the grid in steps.
    #[inline]
    pub fn direction(&self) -> (i64, i64) {
        if self.aside.is_none() {
            return predicates::delta(self.a, self.b);
        }
        let [a, b] = self.drawn();
        b.vector_from(a)
    }

    /// Orders feature edges by what they are and not by their ids.
    fn rank(&self) -> (FeatureId, Source, Point, Point) {
        (self.feature, self.source, self.a, self.b)
    }
}

/// A feature edge that runs along a mesh edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Use {
    /// The feature edge.
    pub segment: SegmentId,
    /// Whether it runs in the direction of the mesh edge that was asked about.
    pub forward: bool,
}

/// Where a position lies, exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Strictly inside a face.
    Face(FaceId),
    /// Strictly inside this edge.
    Edge(EdgeId),
    /// On this vertex.
    Vertex(VertexId),
}

/// Why a feature cannot go into a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshError {
    /// An edge leaves the world: both coordinates must stay below [`BOUND`](crate::geom::BOUND)` - 1` steps.
    OutOfBounds {
        /// The feature.
        feature: FeatureId,
        /// Index of the edge in it.
        edge: usize,
    },
    /// An edge starts and ends at the same grid point.
    ZeroLength {
        /// The feature.
        feature: FeatureId,
        /// Index of the edge in it.
        edge: usize,
    },
    /// There is a feature with this id.
    Occupied {
        /// The id.
        feature: FeatureId,
    },
    /// There is no feature with this id.
    Unknown {
        /// The id.
        feature: FeatureId,
    },
    /// The mesh would be too large: see [`MOST_VERTICES`].
    TooMuch {
        /// One of the two features that cross most often, as far as some of their edges tell.
        first: FeatureId,
        /// The other one; the same, if no two cross.
        second: FeatureId,
    },
    /// Nobody waits for the mesh any more.
    Left,
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            MeshError::OutOfBounds { feature, edge } => write!(
                f,
                "feature {feature}: expanded edge {edge} leaves the world of +-4096 m"
            ),
            MeshError::ZeroLength { feature, edge } => {
                write!(f, "feature {feature}: expanded edge {edge} has no length")
            }
            MeshError::Occupied { feature } => {
                write!(f, "feature {feature} is in the mesh already")
            }
            MeshError::Unknown { feature } => write!(f, "feature {feature} is not in the mesh"),
            MeshError::TooMuch { first, second } => write!(
                f,
                "more than {MOST_VERTICES} corners and crossings; features {first} and {second} cross most"
            ),
            MeshError::Left => write!(f, "left before it was done"),
        }
    }
}

impl std::error::Error for MeshError {}

/// The mesh.
#[derive(Clone, Debug)]
pub struct Mesh {
    arrangement: snap::Arrangement,
    triangulation: triangulation::Triangulation,
    uses: uses::Uses,
    covers: cover::Covers,
    /// Feature edges by id; unused ids keep their last one.
    segments: Vec<Segment>,
    /// Per segment: the kind of its feature.
    kinds: Vec<Kind>,
    /// Per segment: whether its feature covers what it winds around.
    winds: Vec<bool>,
    features: BTreeMap<FeatureId, Feature>,
    /// Faces that the last edit made, changed or removed.
    rewired: Vec<u32>,
    /// How many vertices it removed.
    buried: usize,
}

/// The edges of one feature.
#[derive(Clone, Debug)]
struct Feature {
    kind: Kind,
    /// In the order in which they were given.
    segments: Vec<SegmentId>,
    /// The same by source.
    by_source: Vec<SegmentId>,
    /// Whether it covers what its edges wind around: solids and regions do whose edges form one closed chain.
    winds: bool,
}

// Topology and geometry.
impl Mesh {
    /// The point of a vertex.
    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.triangulation.point(v.0)
    }

    /// Where an edge starts.
    #[inline]
    pub fn origin(&self, e: EdgeId) -> VertexId {
        VertexId(self.topology().origin(e.0))
    }

    /// Where an edge ends.
    #[inline]
    pub fn dest(&self, e: EdgeId) -> VertexId {
        VertexId(self.topology().dest(e.0))
    }

    /// The same edge, other way.
    #[inline]
    pub fn sym(&self, e: EdgeId) -> EdgeId {
        EdgeId(topology::sym(e.0))
    }

    /// Next edge counter-clockwise about the same origin.
    #[inline]
    pub fn onext(&self, e: EdgeId) -> EdgeId {
        EdgeId(self.topology().onext(e.0))
    }

    /// Next edge clockwise about the same origin.
    #[inline]
    pub fn oprev(&self, e: EdgeId) -> EdgeId {
        EdgeId(self.topology().oprev(e.0))
    }

    /// Next edge counter-clockwise about the left face.
    #[inline]
    pub fn lnext(&self, e: EdgeId) -> EdgeId {
        EdgeId(self.topology().lnext(e.0))
    }

    /// The face on the left; `None` outside the world's box.
    #[inline]
    pub fn left(&self, e: EdgeId) -> Option<FaceId> {
        let face = self.topology().left(e.0);
        (face != topology::OUTSIDE).then_some(FaceId(face))
    }

    /// The three edges that have this face on their left, counter-clockwise.
    #[inline]
    pub fn sides(&self, f: FaceId) -> [EdgeId; 3] {
        self.topology().sides(f.0).map(EdgeId)
    }

    /// One edge that starts at this vertex.
    #[inline]
    pub fn vertex_edge(&self, v: VertexId) -> EdgeId {
        EdgeId(self.topology().vertex_edge(v.0))
    }

    /// All edges that start at a vertex, counter-clockwise.
    pub fn spokes(&self, v: VertexId) -> impl Iterator<Item = EdgeId> + '_ {
        self.spokes_from(self.vertex_edge(v))
    }

    /// All edges that start where one does, counter-clockwise, beginning with that one.
    pub fn spokes_from(&self, first: EdgeId) -> impl Iterator<Item = EdgeId> + '_ {
        self.topology().ring_from(first.0).map(EdgeId)
    }

    /// The edge from one vertex to another, if there is one.
    pub fn edge_between(&self, v: VertexId, w: VertexId) -> Option<EdgeId> {
        self.topology().edge_between(v.0, w.0).map(EdgeId)
    }

    /// All faces, ascending by id.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.topology().faces().map(FaceId)
    }

    /// All edges, one direction of each, ascending by id.
    pub fn edges(&self) -> impl Iterator<Item = EdgeId> + '_ {
        self.topology().edges().map(EdgeId)
    }

    /// All vertices, ascending by id; the first four are the corners of the world's box.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        let t = self.topology();
        (0..t.vertex_count() as u32)
            .filter(|&v| t.has_vertex(v))
            .map(VertexId)
    }

    /// Whether there is a face with this id now; edits may give ids to other faces.
    pub fn is_face(&self, f: FaceId) -> bool {
        self.topology().is_face(f.0)
    }

    /// The corners of a face, counter-clockwise.
    #[inline]
    pub fn corners(&self, f: FaceId) -> [Point; 3] {
        self.topology()
            .sides(f.0)
            .map(|e| self.triangulation.point(self.topology().origin(e)))
    }

    /// Finds a position by walking, by exact tests, from a known face. `None` on or outside the world's box, and
    /// for what is not a number.
    pub fn locate(&self, p: DVec2, near: Option<FaceId>) -> Option<Place> {
        let p = predicates::steps(p);
        let inside = |c: f64| c.abs() < f64::from(triangulation::EDGE_OF_WORLD);
        if !(inside(p.x) && inside(p.y)) {
            return None;
        }
        let t = self.topology();
        let start = near
            .filter(|f| t.is_face(f.0))
            .map_or(0, |f| t.origin(t.face_edge(f.0)));
        Some(
            match walk::walk(t, self.triangulation.points(), start, &p) {
                walk::Found::Face(e) => Place::Face(FaceId(t.left(e))),
                walk::Found::Edge(e) => Place::Edge(EdgeId(e)),
                walk::Found::Vertex(v) => Place::Vertex(VertexId(v)),
            },
        )
    }

    fn topology(&self) -> &topology::Topology {
        &self.triangulation.topology
    }
}

// Provenance.
impl Mesh {
    /// Whether some solid covers the face.
    #[inline]
    pub fn is_solid(&self, f: FaceId) -> bool {
        self.covers.is_solid(f.0)
    }

    /// Whether a body left of the edge is stopped by solids: the left face is free, the right one solid or outside
    /// the world. One-ways are not counted: ask [`Mesh::has_front`].
    #[inline]
    pub fn blocks(&self, e: EdgeId) -> bool {
        let t = self.topology();
        !self.covers.is_solid(t.left(e.0)) && self.covers.is_solid(t.left(topology::sym(e.0)))
    }

    /// Whether the front of some one-way or line lies left of the edge: it may stop a body that comes from there.
    #[inline]
    pub fn has_front(&self, e: EdgeId) -> bool {
        self.uses.has_front(e.0)
    }

    /// The feature edges of one-ways and lines along an edge that have their front on its left, in the order of
    /// [`Mesh::uses`].
    pub fn fronts(&self, e: EdgeId) -> impl Iterator<Item = SegmentId> + '_ {
        let front = |u: &Use| !u.forward && self.kind(u.segment).has_fronts();
        self.uses.of(e.0).filter(front).map(|u| u.segment)
    }

    /// The solids and regions that cover the face, ascending.
    pub fn cover(&self, f: FaceId) -> &[FeatureId] {
        self.covers.features(f.0)
    }

    /// The feature edges that run along a mesh edge, by feature, source and ends: an order that edits elsewhere do not change.
    pub fn uses(&self, e: EdgeId) -> impl Iterator<Item = Use> + '_ {
        self.uses.of(e.0)
    }

    /// A feature edge by its id.
    #[inline]
    pub fn segment(&self, s: SegmentId) -> &Segment {
        &self.segments[s.index()]
    }

    /// The kind of the feature that a feature edge belongs to.
    #[inline]
    pub fn kind(&self, s: SegmentId) -> Kind {
        self.kinds[s.index()]
    }

    /// The kind of a feature.
    pub fn kind_of(&self, feature: FeatureId) -> Option<Kind> {
        self.features.get(&feature).map(|f| f.kind)
    }

    /// The mesh vertices that a feature edge runs through, from a to b.
    pub fn chain(&self, s: SegmentId) -> &[VertexId] {
        self.arrangement.chain(s)
    }

    /// The feature edge of a feature with a given source.
    pub fn segment_of(&self, feature: FeatureId, source: Source) -> Option<SegmentId> {
        let by_source = &self.features.get(&feature)?.by_source;
        let source_of = |s: &SegmentId| self.segment(*s).source;
        let i = by_source.binary_search_by_key(&source, source_of).ok()?;
        Some(by_source[i])
    }

    /// All feature edges of a feature, in the order in which they were given.
    pub fn segments_of(&self, feature: FeatureId) -> &[SegmentId] {
        self.features.get(&feature).map_or(&[], |f| &f.segments)
    }

    /// How many faces the last edit made, changed or removed: a measure of its locality.
    pub fn rewired(&self) -> usize {
        self.rewired.len()
    }

    /// How many vertices the last edit made, removed, or left with other faces around them.
    pub fn touched(&self) -> usize {
        let t = self.topology();
        let faces = self.rewired.iter().filter(|&&f| t.is_face(f));
        let mut vertices: Vec<u32> = faces
            .flat_map(|&f| t.sides(f))
            .map(|e| t.origin(e))
            .collect();
        vertices.sort_unstable();
        vertices.dedup();
        vertices.len() + self.buried
    }

    /// How many different covers of faces there is room for; edits use the room of covers that are gone again.
    pub fn cover_room(&self) -> usize {
        self.covers.capacity()
    }

    /// The ids of all features, ascending.
    pub fn features(&self) -> impl Iterator<Item = FeatureId> + '_ {
        self.features.keys().copied()
    }
}
