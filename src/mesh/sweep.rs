//! What a straight line passes on its way through the mesh: faces, edges and vertices, in order, exactly.
//!
//! Every turn is decided by the exact side of a mesh vertex with respect to the line between the two given positions,
//! so the line may run through vertices and along edges.

use super::{EdgeId, FaceId, Mesh, Place, VertexId};
use crate::geom::Point;
use crate::geom::predicates::{line_side, side, steps};
use glam::DVec2;
use std::cmp::Ordering;

/// Something that a line passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Through the inside of a face.
    Inside(FaceId),
    /// Across the inside of an edge, from its left to its right.
    Across(EdgeId),
    /// Along an edge, in its direction.
    Along(EdgeId),
    /// Through a vertex, from one side to another.
    Through(VertexId),
}

/// The passes of one line. Where it ends on an edge or a vertex it does not pass that; where it starts on an edge or
/// a vertex, what it enters first is its first pass.
#[derive(Clone, Debug)]
pub struct Sweep<'a> {
    mesh: &'a Mesh,
    line: Line,
    next: Option<Pass>,
}

/// A line from one position to another, in steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub from: DVec2,
    pub to: DVec2,
}

/// Where a direction leaves a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Spoke {
    /// Along this edge.
    Along(EdgeId),
    /// Into the face left of this edge.
    Into(EdgeId),
}

impl Line {
    /// On which side of the line a point lies.
    fn side(&self, p: Point) -> Ordering {
        line_side(self.from, self.to, p)
    }

    /// Whether a point of the line lies before its end, so that the line goes on behind it.
    fn goes_beyond(&self, p: Point) -> bool {
        let before = |p: f64, from: f64, to: f64| if from < to { p < to } else { p > to };
        if self.from.x != self.to.x {
            before(f64::from(p.x), self.from.x, self.to.x)
        } else {
            before(f64::from(p.y), self.from.y, self.to.y)
        }
    }

    /// Whether the way from one point of the line to another is that of the line.
    fn leads(&self, p: Point, q: Point) -> bool {
        if self.from.x != self.to.x {
            (p.x < q.x) == (self.from.x < self.to.x)
        } else {
            (p.y < q.y) == (self.from.y < self.to.y)
        }
    }

    pub(super) fn reversed(self) -> Line {
        Line {
            from: self.to,
            to: self.from,
        }
    }

    /// Where the line leaves a vertex that lies on it. Edges around a vertex are less than half a turn apart (and at
    /// the corners of the world, lines come from inside), so the signs at two neighbours tell.
    pub(super) fn spoke(&self, mesh: &Mesh, v: VertexId) -> Spoke {
        let here = mesh.point(v);
        let mut e = mesh.vertex_edge(v);
        let mut s = self.side(mesh.point(mesh.dest(e)));
        loop {
            let end = mesh.point(mesh.dest(e));
            if s == Ordering::Equal && self.leads(here, end) {
                return Spoke::Along(e);
            }
            let next = mesh.onext(e);
            let s_next = self.side(mesh.point(mesh.dest(next)));
            if s == Ordering::Less && s_next == Ordering::Greater {
                return Spoke::Into(e);
            }
            (e, s) = (next, s_next);
        }
    }
}

impl Mesh {
    /// What the line between two positions, in metres, passes; `near` is where to start looking for the first. Empty if
    /// that is not strictly inside the world's box, or anything is not a number. At the world's border the line ends.
    pub fn sweep(&self, from: DVec2, to: DVec2, near: Option<FaceId>) -> Sweep<'_> {
        let line = Line {
            from: steps(from),
            to: steps(to),
        };
        let start = self.locate(from, near).filter(|_| to.is_finite());
        let next = start.and_then(|place| self.first_pass(&line, place));
        Sweep {
            mesh: self,
            line,
            next,
        }
    }

    /// The faces whose inside the line between two positions meets, in order.
    pub fn faces_along(
        &self,
        from: DVec2,
        to: DVec2,
        near: Option<FaceId>,
    ) -> impl Iterator<Item = FaceId> + '_ {
        self.sweep(from, to, near).filter_map(|pass| match pass {
            Pass::Inside(face) => Some(face),
            _ => None,
        })
    }

    fn first_pass(&self, line: &Line, place: Place) -> Option<Pass> {
        let moves = line.from != line.to;
        match place {
            Place::Face(face) => Some(Pass::Inside(face)),
            Place::Edge(e) if moves => match self.side_of(e, line.to) {
                Ordering::Greater => self.left(e).map(Pass::Inside),
                Ordering::Less => self.left(self.sym(e)).map(Pass::Inside),
                Ordering::Equal => {
                    let (a, b) = (self.point(self.origin(e)), self.point(self.dest(e)));
                    let along = if line.leads(a, b) { e } else { self.sym(e) };
                    Some(Pass::Along(along))
                }
            },
            Place::Vertex(v) if moves => self.pass_from(line, v),
            _ => None,
        }
    }

    /// On which side of an edge a position, in steps, lies.
    fn side_of(&self, e: EdgeId, p: DVec2) -> Ordering {
        side(self.point(self.origin(e)), self.point(self.dest(e)), p)
    }

    /// What a line enters from a vertex.
    fn pass_from(&self, line: &Line, v: VertexId) -> Option<Pass> {
        match line.spoke(self, v) {
            Spoke::Along(e) => Some(Pass::Along(e)),
            Spoke::Into(e) => self.left(e).map(Pass::Inside),
        }
    }

    /// How a line that meets the inside of a face leaves it, if it does.
    fn exit(&self, line: &Line, face: FaceId) -> Option<Pass> {
        let sides = self.sides(face);
        let at = sides.map(|e| line.side(self.point(self.origin(e))));
        for i in 0..3 {
            let (behind, here, ahead) = (at[(i + 2) % 3], at[i], at[(i + 1) % 3]);
            match here {
                // From the right of the line to its left: the line leaves across this side.
                Ordering::Less if ahead == Ordering::Greater => {
                    let beyond = self.side_of(sides[i], line.to) == Ordering::Less;
                    return beyond.then_some(Pass::Across(sides[i]));
                }
                Ordering::Equal if behind == Ordering::Less && ahead == Ordering::Greater => {
                    return self.through(line, self.origin(sides[i]));
                }
                _ => {}
            }
        }
        // A line without length has no sides.
        None
    }

    /// The vertex, if the line goes on behind it.
    fn through(&self, line: &Line, v: VertexId) -> Option<Pass> {
        line.goes_beyond(self.point(v)).then_some(Pass::Through(v))
    }
}

impl Iterator for Sweep<'_> {
    type Item = Pass;

    fn next(&mut self) -> Option<Pass> {
        let (mesh, line) = (self.mesh, &self.line);
        let pass = self.next?;
        self.next = match pass {
            Pass::Inside(face) => mesh.exit(line, face),
            Pass::Across(e) => mesh.left(mesh.sym(e)).map(Pass::Inside),
            Pass::Along(e) => mesh.through(line, mesh.dest(e)),
            Pass::Through(v) => mesh.pass_from(line, v),
        };
        Some(pass)
    }
}
