//! The ground of a level as chains of edges, and which chains are next to which: what path finding starts from.

use super::{EdgeId, FaceId, Mesh, Segment, SegmentId, VertexId};
use crate::geom::Point;
use std::collections::{BTreeMap, BTreeSet};

/// A chain of ground: edges with free on their left, each followed by the next thing that a body on it comes to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Surface {
    /// In order. Ground with free above it is walked towards growing x.
    pub edges: Vec<EdgeId>,
    /// The feature edges along it that are ground, in order, each once for every stretch of it.
    pub segments: Vec<SegmentId>,
    /// Where it starts.
    pub start: VertexId,
    /// Where it ends; the start, for one that closes.
    pub end: VertexId,
}

/// All ground of a mesh.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Surfaces {
    /// The chains, ascending by the points of their first edge.
    pub list: Vec<Surface>,
    /// Chains by index: the first ends where the second starts, as near as was asked for.
    pub joints: Vec<(usize, usize)>,
    /// Chains by index, the smaller first: between them lies free space that is nearer to these than to all others, counted in
    /// faces. Whether a body can get from one to the other by a jump or a drop is for the caller to find out; but where
    /// free space connects two chains, some row of such neighbours does.
    pub beside: Vec<(usize, usize)>,
}

impl Mesh {
    /// The chains of edges that are ground: walls and fronts of one-ways with a feature edge that is `walkable`.
    ///
    /// Ends within `joint` steps per axis of a start make a joint. Takes time in proportion to the mesh.
    pub fn surfaces(&self, joint: u32, walkable: impl Fn(&Segment) -> bool) -> Surfaces {
        let mut grounds = Grounds::of(self, walkable);
        let mut list = Vec::new();
        // Open chains from their starts; what is left closes.
        for only_starts in [true, false] {
            for e in grounds.in_order() {
                let starts = grounds.before(e).is_none();
                if (starts || !only_starts) && grounds.edges.contains_key(&e) {
                    list.push(grounds.take_chain(e));
                }
            }
        }
        let first = |s: &Surface| s.edges.first().map(|&e| self.ends(e));
        list.sort_by_key(first);
        Surfaces {
            joints: self.joints(&list, joint),
            beside: self.beside(&list),
            list,
        }
    }

    /// Ends of chains that lie near starts of chains.
    fn joints(&self, list: &[Surface], steps: u32) -> Vec<(usize, usize)> {
        let mut starts: BTreeMap<Point, Vec<usize>> = BTreeMap::new();
        for (i, surface) in list.iter().enumerate() {
            starts.entry(self.point(surface.start)).or_default().push(i);
        }
        let reach = i32::try_from(steps).unwrap_or(i32::MAX);
        let mut joints = BTreeSet::new();
        for (i, surface) in list.iter().enumerate() {
            let p = self.point(surface.end);
            let from = Point::new(p.x.saturating_sub(reach), i32::MIN);
            let to = Point::new(p.x.saturating_add(reach), i32::MAX);
            for (q, there) in starts.range(from..=to) {
                if p.y.abs_diff(q.y) <= steps {
                    joints.extend(there.iter().map(|&j| (i, j)).filter(|(i, j)| i != j));
                }
            }
        }
        joints.into_iter().collect()
    }

    /// Chains whose shares of free space touch: each free face belongs to the chain that is reached from it through the
    /// fewest faces.
    fn beside(&self, list: &[Surface]) -> Vec<(usize, usize)> {
        let mut owner: Vec<Option<usize>> = vec![None; self.topology().face_count()];
        let mut beside = BTreeSet::new();
        let mut reached: Vec<(usize, FaceId)> = Vec::new();
        for (i, surface) in list.iter().enumerate() {
            reached.extend(
                surface
                    .edges
                    .iter()
                    .filter_map(|&e| Some((i, self.left(e)?))),
            );
        }
        while !reached.is_empty() {
            // Of equally near chains the first has the face: the order of faces depends on the history of the mesh.
            reached.sort_unstable();
            for (i, face) in std::mem::take(&mut reached) {
                let owner = &mut owner[face.0 as usize];
                match *owner {
                    Some(j) if i != j => {
                        beside.insert((i.min(j), i.max(j)));
                    }
                    Some(_) => {}
                    None => {
                        *owner = Some(i);
                        reached.extend(self.free_neighbours(face).map(|(_, beyond)| (i, beyond)));
                    }
                }
            }
        }
        beside.into_iter().collect()
    }
}

/// The edges that are ground, as long as no chain has them.
struct Grounds<'a> {
    mesh: &'a Mesh,
    /// Each with its feature edges that are ground.
    edges: BTreeMap<EdgeId, Vec<SegmentId>>,
    /// All of them.
    all: BTreeSet<EdgeId>,
}

impl<'a> Grounds<'a> {
    fn of(mesh: &'a Mesh, walkable: impl Fn(&Segment) -> bool) -> Self {
        let mut edges = BTreeMap::new();
        for e in mesh.edges().flat_map(|e| [e, mesh.sym(e)]) {
            let free = mesh.left(e).is_some_and(|face| !mesh.is_solid(face));
            let walls = mesh.walls(e).filter(|_| mesh.blocks(e));
            let facing = walls.chain(mesh.fronts(e));
            let ground: Vec<SegmentId> = facing.filter(|&s| walkable(mesh.segment(s))).collect();
            if free && !ground.is_empty() {
                edges.insert(e, ground);
            }
        }
        let all = edges.keys().copied().collect();
        Grounds { mesh, edges, all }
    }

    /// By the points of their ends, which do not depend on how the mesh came about.
    fn in_order(&self) -> Vec<EdgeId> {
        let mut edges: Vec<EdgeId> = self.edges.keys().copied().collect();
        edges.sort_by_key(|&e| self.mesh.ends(e));
        edges
    }

    /// Whether a surface goes on along an edge: a wall or ground.
    fn stops(&self, e: EdgeId) -> bool {
        self.mesh.blocks(e) || self.all.contains(&e)
    }

    /// The wall or ground that comes after an edge: turning about its end through free faces. `None` at the tip of a one-way.
    fn turn(&self, e: EdgeId, side: impl Fn(EdgeId) -> EdgeId) -> Option<EdgeId> {
        let mut f = side(e);
        while !self.stops(f) && f != self.mesh.sym(e) {
            f = side(self.mesh.sym(f));
        }
        Some(f).filter(|&f| f != self.mesh.sym(e))
    }

    /// The ground that follows an edge of ground.
    fn after(&self, e: EdgeId) -> Option<EdgeId> {
        let next = self.turn(e, |e| self.mesh.lnext(e));
        next.filter(|&f| self.all.contains(&f) && self.turn_back(f) == Some(e))
    }

    /// The ground that an edge of ground follows.
    fn before(&self, e: EdgeId) -> Option<EdgeId> {
        let last = self.turn_back(e);
        last.filter(|&f| self.all.contains(&f) && self.after(f) == Some(e))
    }

    /// The wall or ground that comes before an edge.
    fn turn_back(&self, e: EdgeId) -> Option<EdgeId> {
        let mesh = self.mesh;
        self.turn(e, |e| mesh.lnext(mesh.lnext(e)))
    }

    /// Takes the chain that begins with an edge.
    fn take_chain(&mut self, first: EdgeId) -> Surface {
        let (mut edges, mut segments) = (Vec::new(), Vec::new());
        let mut under: Vec<SegmentId> = Vec::new();
        let mut at = Some(first);
        while let Some((e, ground)) = at.and_then(|e| self.edges.remove_entry(&e)) {
            edges.push(e);
            segments.extend(ground.iter().filter(|s| !under.contains(s)));
            under = ground;
            at = self.after(e);
        }
        let last = edges.last().copied().unwrap_or(first);
        Surface {
            edges,
            segments,
            start: self.mesh.origin(first),
            end: self.mesh.dest(last),
        }
    }
}
