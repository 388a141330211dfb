//! The constrained Delaunay mesh of a set of features, each expanded by one collider.
//!
//! CONTRACT (skeleton): the signatures below are what motion, game and shell call.

use crate::geom::Point;
use glam::DVec2;

/// Index of a feature in the list the mesh was built from.
pub type FeatureId = u32;

/// A directed primal edge of the quad-edge structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub struct EdgeId(pub u32);
/// A triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub struct FaceId(pub u32);
/// A mesh vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub struct VertexId(pub u32);
/// A feature edge: one edge of one expanded outline, as it was before anything cut it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
pub struct SegmentId(pub u32);

/// What part of a feature's outline and of the collider an expanded edge comes from.
/// Equal in the meshes of all sizes of a body, wherever they share that part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Source {
    /// Outline edge `edge` moved by a collider vertex.
    Edge { /** Index of the outline edge. */ edge: u32 },
    /// Collider edge `side` moved along to outline vertex `vertex`.
    Corner { /** Index of the outline vertex. */ vertex: u32, /** Index of the collider edge. */ side: u32 },
}

/// A feature edge. The solid is on its left.
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

/// The mesh.
#[derive(Clone, Debug)]
pub struct Mesh {}

impl Mesh {
    /// The point of a vertex.
    pub fn point(&self, _v: VertexId) -> Point { todo!() }
    /// Where an edge starts.
    pub fn origin(&self, _e: EdgeId) -> VertexId { todo!() }
    /// Where an edge ends.
    pub fn dest(&self, _e: EdgeId) -> VertexId { todo!() }
    /// The same edge, other way.
    pub fn sym(&self, _e: EdgeId) -> EdgeId { todo!() }
    /// Next edge counter-clockwise about the same origin.
    pub fn onext(&self, _e: EdgeId) -> EdgeId { todo!() }
    /// Next edge clockwise about the same origin.
    pub fn oprev(&self, _e: EdgeId) -> EdgeId { todo!() }
    /// Next edge counter-clockwise about the left face.
    pub fn lnext(&self, _e: EdgeId) -> EdgeId { todo!() }
    /// The face on the left; `None` outside the world's box.
    pub fn left(&self, _e: EdgeId) -> Option<FaceId> { todo!() }
    /// One edge that has this face on its left.
    pub fn face_edge(&self, _f: FaceId) -> EdgeId { todo!() }
    /// One edge that starts at this vertex.
    pub fn vertex_edge(&self, _v: VertexId) -> EdgeId { todo!() }
    /// Whether some solid covers the face.
    pub fn is_solid(&self, _f: FaceId) -> bool { todo!() }
    /// Whether a body left of the edge is stopped by it: the left face is free, the right one solid or outside the world.
    pub fn blocks(&self, _e: EdgeId) -> bool { todo!() }
    /// The features that cover the face, ascending.
    pub fn cover(&self, _f: FaceId) -> &[FeatureId] { todo!() }
    /// The feature edges that run along a mesh edge.
    pub fn uses(&self, _e: EdgeId) -> impl Iterator<Item = Use> + '_ { std::iter::empty() }
    /// A feature edge by its id.
    pub fn segment(&self, _s: SegmentId) -> &Segment { todo!() }
    /// The mesh vertices that a feature edge runs through, from a to b.
    pub fn chain(&self, _s: SegmentId) -> &[VertexId] { todo!() }
    /// The feature edge of a feature with a given source.
    pub fn segment_of(&self, _feature: FeatureId, _source: Source) -> Option<SegmentId> { todo!() }
    /// The edge from one vertex to another, if there is one.
    pub fn edge_between(&self, _v: VertexId, _w: VertexId) -> Option<EdgeId> { todo!() }
    /// Finds a position by walking, by exact tests, from a known face. `None` outside the world's box.
    pub fn locate(&self, _p: DVec2, _near: Option<FaceId>) -> Option<Place> { todo!() }
    /// All faces, ascending by id.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + '_ { std::iter::empty() }
    /// The corners of a face, counter-clockwise.
    pub fn corners(&self, _f: FaceId) -> [Point; 3] { todo!() }
}
