//! Casting a point along a straight line to what stops it first.
//!
//! What stops a cast is what would stop a body without size on a path as close to the line as one likes: touching is no
//! hit, a line may run along a wall and past a corner. At a vertex it has to get around on one side or the other through
//! faces that let it, so it does not slip between two solids that touch there.

use super::sweep::{Line, Pass, Spoke, Sweep};
use super::{EdgeId, FaceId, Kind, Mesh, Place, SegmentId, VertexId};
use crate::geom::STEP;
use crate::geom::predicates::{side_value, steps};
use glam::DVec2;

/// How a cast ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cast {
    /// It reaches its end.
    Clear,
    /// Something stops it.
    Hit(Hit),
    /// It cannot start: inside a solid, not inside the world's box, or not a number.
    NoStart,
}

/// What stops a cast.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The edges that stop it, with the side that it comes from on their left. At the inside of an edge both are that edge; at
    /// a vertex they are those met on the way around it on the left and on the right of the line.
    pub edges: [EdgeId; 2],
    /// How far along it came: 0 at the start, 1 at the end. Rounded, the hit itself is exact.
    pub at: f64,
    /// Where, m; rounded, but a vertex's own point.
    pub point: DVec2,
}

/// Which sides of the edge that a cast runs along it may be on; within a face, both.
#[derive(Clone, Copy, Debug)]
struct Sides {
    left: bool,
    right: bool,
}

const BOTH: Sides = Sides {
    left: true,
    right: true,
};

const NEITHER: Sides = Sides {
    left: false,
    right: false,
};

/// What stops a cast; `None` if it cannot start.
type Stop = Option<Hit>;

/// What a cast needs to know: the mesh, its line, and which edges stop who comes from their left.
struct Caster<'a, B> {
    mesh: &'a Mesh,
    line: Line,
    blocks: B,
}

impl Mesh {
    /// The first thing between two positions, in metres, that stops a point without size: a solid or the world's border.
    /// `near` is where to start looking for the first position.
    ///
    /// A start on an edge or a vertex counts as being in what the line enters first; if that is solid, but something else there
    /// is free, the cast is stopped at once.
    pub fn cast(&self, from: DVec2, to: DVec2, near: Option<FaceId>) -> Cast {
        self.cast_by(from, to, near, |e| self.blocks(e))
    }

    /// As [`Mesh::cast`], for who is stopped at an edge with the side that it comes from on the left as `blocks` says: at least
    /// wherever [`Mesh::blocks`] does.
    pub fn cast_by(
        &self,
        from: DVec2,
        to: DVec2,
        near: Option<FaceId>,
        blocks: impl Fn(EdgeId) -> bool,
    ) -> Cast {
        let start = self.locate(from, near).filter(|_| to.is_finite());
        let caster = Caster {
            mesh: self,
            line: Line {
                from: steps(from),
                to: steps(to),
            },
            blocks,
        };
        let sweep = self.sweep(from, to, near);
        match start.map_or(Err(None), |start| caster.run(start, sweep)) {
            Ok(()) => Cast::Clear,
            Err(None) => Cast::NoStart,
            Err(Some(hit)) => Cast::Hit(hit),
        }
    }

    /// As [`Mesh::cast`], from a position in a direction, to the world's border. The line is that to a point beyond the border,
    /// which is rounded. `NoStart` for a direction without length.
    pub fn ray(&self, from: DVec2, direction: DVec2, near: Option<FaceId>) -> Cast {
        let largest = direction.abs().max_element();
        if !(largest > 0.0 && largest.is_finite()) {
            return Cast::NoStart;
        }
        self.cast(from, from + direction / largest * RAY, near)
    }

    /// The feature edges of solids that make a wall of an edge for who is on its left, in the order of [`Mesh::uses`].
    pub fn walls(&self, e: EdgeId) -> impl Iterator<Item = SegmentId> + '_ {
        let wall = |u: &super::Use| !u.forward && self.kind(u.segment) == Kind::Solid;
        self.uses(e).filter(wall).map(|u| u.segment)
    }
}

/// Longer than the world is wide, m.
const RAY: f64 = 16384.0;

impl<B: Fn(EdgeId) -> bool> Caster<'_, B> {
    /// Follows the line from its start to its end, or to what stops it.
    fn run(&self, start: Place, sweep: Sweep) -> Result<(), Stop> {
        let mut sides = BOTH;
        for (i, pass) in sweep.enumerate() {
            match pass {
                _ if i == 0 => sides = self.enter(start, pass)?,
                Pass::Across(e) if (self.blocks)(e) => return Err(Some(self.crossing(e))),
                Pass::Through(v) => {
                    let stopped = |edges| Some(self.passing(v, edges));
                    sides = self.round(v, sides).map_err(stopped)?;
                }
                Pass::Inside(_) | Pass::Across(_) | Pass::Along(_) => {}
            }
        }
        Ok(())
    }

    fn is_free(&self, face: Option<FaceId>) -> bool {
        face.is_some_and(|f| !self.mesh.is_solid(f))
    }

    /// Enters what the line passes first.
    fn enter(&self, start: Place, first: Pass) -> Result<Sides, Stop> {
        let mesh = self.mesh;
        let sides = match first {
            Pass::Along(e) => Sides {
                left: self.is_free(mesh.left(e)),
                right: self.is_free(mesh.left(mesh.sym(e))),
            },
            Pass::Inside(f) if mesh.is_solid(f) => NEITHER,
            _ => BOTH,
        };
        if sides.left || sides.right {
            return Ok(sides);
        }
        let edges = match start {
            Place::Face(_) => None,
            Place::Edge(e) => [e, mesh.sym(e)]
                .into_iter()
                .find(|&e| mesh.blocks(e))
                .map(|e| [e; 2]),
            Place::Vertex(v) => self.walls_beside(v),
        };
        let point = self.line.from * STEP;
        Err(edges.map(|edges| Hit {
            edges,
            at: 0.0,
            point,
        }))
    }

    /// The walls at a vertex next to the line, which leads into a solid: left and right of it.
    fn walls_beside(&self, v: VertexId) -> Option<[EdgeId; 2]> {
        let mesh = self.mesh;
        let (Spoke::Along(into) | Spoke::Into(into)) = self.line.spoke(mesh, v);
        let spokes = || mesh.spokes_from(into);
        // Counter-clockwise from the line, the first spoke with free on its left; clockwise, on its right.
        let left = spokes().find(|&e| mesh.blocks(e))?;
        let blocking = spokes().map(|e| mesh.sym(e)).filter(|&e| mesh.blocks(e));
        let right = match self.line.spoke(mesh, v) {
            Spoke::Into(e) | Spoke::Along(e) if mesh.blocks(mesh.sym(e)) => mesh.sym(e),
            _ => blocking.last()?,
        };
        Some([left, right])
    }

    /// Gets from one side of a vertex to the other, on the left or on the right of the line; or what stops it there.
    fn round(&self, v: VertexId, sides: Sides) -> Result<Sides, [EdgeId; 2]> {
        let back = self.line.reversed().spoke(self.mesh, v);
        let into = self.line.spoke(self.mesh, v);
        let left = sides.left.then(|| self.left_way(back, into));
        let right = sides.right.then(|| self.right_way(back, into));
        let mut reached = Sides {
            left: left == Some(Ok(())),
            right: right == Some(Ok(())),
        };
        if !(reached.left || reached.right) {
            let stops = [left, right].map(|way| way.and_then(Result::err));
            let [Some(e), Some(f)] = [stops[0].or(stops[1]), stops[1].or(stops[0])] else {
                return Ok(reached);
            };
            return Err([e, f]);
        }
        match into {
            Spoke::Into(_) => return Ok(BOTH),
            // From one side of the edge ahead to the other, if that is open.
            Spoke::Along(e) => {
                let (left, right) = (reached.left, reached.right);
                reached.right |= left && !(self.blocks)(e);
                reached.left |= right && !(self.blocks)(self.mesh.sym(e));
            }
        }
        Ok(reached)
    }

    /// Turns about a vertex through the faces left of the line: clockwise. `Err` is what stops it.
    fn left_way(&self, back: Spoke, into: Spoke) -> Result<(), EdgeId> {
        let mesh = self.mesh;
        // The spoke on the clockwise side of the face that the turn has come to.
        let mut border = match back {
            Spoke::Into(e) => e,
            Spoke::Along(e) => mesh.oprev(e),
        };
        let (Spoke::Along(end) | Spoke::Into(end)) = into;
        while border != end {
            if (self.blocks)(border) {
                return Err(border);
            }
            border = mesh.oprev(border);
        }
        Ok(())
    }

    /// Turns about a vertex through the faces right of the line: counter-clockwise. `Err` is what stops it.
    fn right_way(&self, back: Spoke, into: Spoke) -> Result<(), EdgeId> {
        let mesh = self.mesh;
        // The spoke on the counter-clockwise side of the face that the turn has come to.
        let (Spoke::Along(first) | Spoke::Into(first)) = back;
        let mut border = mesh.onext(first);
        let end = match into {
            Spoke::Into(e) => mesh.onext(e),
            Spoke::Along(e) => e,
        };
        while border != end {
            let crossed = mesh.sym(border);
            if (self.blocks)(crossed) {
                return Err(crossed);
            }
            border = mesh.onext(border);
        }
        Ok(())
    }

    /// Stopped where the line crosses an edge from its left to its right.
    fn crossing(&self, e: EdgeId) -> Hit {
        let Line { from, to } = self.line;
        let (a, b) = self.mesh.ends(e);
        let (before, behind) = (side_value(a, b, from), side_value(a, b, to));
        let at = before / (before - behind);
        Hit {
            edges: [e; 2],
            at,
            point: from.lerp(to, at) * STEP,
        }
    }

    /// Stopped by two edges at a vertex on the line.
    fn passing(&self, v: VertexId, edges: [EdgeId; 2]) -> Hit {
        let Line { from, to } = self.line;
        let p = self.mesh.point(v);
        let way = (to - from).abs();
        let at = if way.x >= way.y {
            (f64::from(p.x) - from.x) / (to.x - from.x)
        } else {
            (f64::from(p.y) - from.y) / (to.y - from.y)
        };
        let point = p.metres();
        Hit { edges, at, point }
    }
}
