//! The hash of a mesh: of points, features and sources, never of ids that depend on how the mesh was made.

use super::topology::sym;
use super::{Mesh, Source};
use crate::geom::Point;
use xxhash_rust::xxh3::Xxh3;

impl Mesh {
    /// Equal for meshes with the same triangles, the same feature edges of the same kinds along each edge and the same covers,
    /// whatever the order in which the features came.
    pub fn hash(&self) -> u64 {
        let mut hash = Xxh3::new();
        self.hash_faces(&mut hash);
        self.hash_edges(&mut hash);
        hash.digest()
    }

    /// Triangles in order of their corners, each with its cover.
    fn hash_faces(&self, hash: &mut Xxh3) {
        let mut faces: Vec<_> = self
            .faces()
            .map(|f| (from_smallest(self.corners(f)), f))
            .collect();
        faces.sort_unstable();
        for (corners, face) in faces {
            for p in corners {
                write_point(hash, p);
            }
            for (feature, winding) in self.covers.windings(face.0) {
                hash.update(&feature.to_le_bytes());
                hash.update(&winding.to_le_bytes());
            }
        }
    }

    /// Edges in use in order of their ends, from the smaller to the larger, each with what runs along it. Uses
    /// are listed by feature, source and ends, so nothing is left to sort.
    fn hash_edges(&self, hash: &mut Xxh3) {
        let t = self.topology();
        let rightward = |q: u32| {
            if self.point_of(t.origin(q)) < self.point_of(t.dest(q)) {
                q
            } else {
                sym(q)
            }
        };
        let used = t.edges().filter(|&q| !self.uses.is_empty(q)).map(rightward);
        let mut edges: Vec<_> = used
            .map(|q| (self.point_of(t.origin(q)), self.point_of(t.dest(q)), q))
            .collect();
        edges.sort_unstable();
        for (a, b, q) in edges {
            write_point(hash, a);
            write_point(hash, b);
            for u in self.uses.of(q) {
                let segment = self.segment(u.segment);
                hash.update(&segment.feature.to_le_bytes());
                let (form, index, side) = match segment.source {
                    Source::Edge { edge } => (u8::from(u.forward), edge, 0),
                    Source::Corner { vertex, side } => (2 + u8::from(u.forward), vertex, side),
                };
                hash.update(&[self.kind(u.segment) as u8, form]);
                hash.update(&index.to_le_bytes());
                hash.update(&side.to_le_bytes());
            }
        }
    }

    fn point_of(&self, v: u32) -> Point {
        self.triangulation.point(v)
    }
}

/// The corners of a triangle, turned so that the lexicographically smallest comes first.
fn from_smallest([a, b, c]: [Point; 3]) -> [Point; 3] {
    if a < b && a < c {
        [a, b, c]
    } else if b < c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

fn write_point(hash: &mut Xxh3, p: Point) {
    hash.update(&p.x.to_le_bytes());
    hash.update(&p.y.to_le_bytes());
}
