//! Every invariant of the mesh as a function: tests and fuzzers call [`Mesh::check`] after each step.

use super::cover::merge;
use super::topology::{NONE, OUTSIDE, Quarter, inv_rot, rot, sym};
use super::triangulation::CORNERS;
use super::{EdgeId, Kind, Mesh, SegmentId, VertexId};
use crate::geom::Point;
use crate::geom::predicates::{meets_pixel, orient2d};

/// What is wrong, in words.
type Wrong = String;

/// Turns a condition into a result.
fn ensure(holds: bool, what: impl FnOnce() -> Wrong) -> Result<(), Wrong> {
    if holds { Ok(()) } else { Err(what()) }
}

impl Mesh {
    /// Checks everything; takes time in proportion to the mesh.
    ///
    /// # Errors
    /// The first invariant found broken, in words.
    pub fn check(&self) -> Result<(), String> {
        self.check_quad_edges()?;
        self.check_triangles()?;
        self.check_euler()?;
        self.check_legal()?;
        self.check_chains()?;
        self.check_uses()?;
        self.check_covers()
    }

    /// The algebra of quad-edges, and that all quarter-edges of a ring have the same origin.
    fn check_quad_edges(&self) -> Result<(), Wrong> {
        let t = self.topology();
        for q in t.edges().flat_map(|e| e..e + 4) {
            let next = t.onext(q);
            ensure(rot(t.onext(rot(next))) == q, || {
                format!("quarter-edge {q}: rot next rot next is not the identity")
            })?;
            ensure(t.origin(next) == t.origin(q), || {
                format!("quarter-edge {q}: its ring changes origin")
            })?;
            ensure(t.origin(q) != NONE, || {
                format!("quarter-edge {q} has no origin")
            })?;
            ensure(inv_rot(rot(q)) == q && sym(sym(q)) == q, || {
                format!("quarter-edge {q} does not turn back")
            })?;
        }
        for v in self.vertices() {
            ensure(t.origin(t.vertex_edge(v.0)) == v.0, || {
                format!("vertex {v:?}: its edge starts elsewhere")
            })?;
        }
        for f in t.faces() {
            ensure(t.left(t.face_edge(f)) == f, || {
                format!("face {f}: its edge has another face on the left")
            })?;
        }
        Ok(())
    }

    /// Every face is a triangle that turns left; the outside has four sides.
    fn check_triangles(&self) -> Result<(), Wrong> {
        let t = self.topology();
        for f in t.faces() {
            let [x, y, z] = t.sides(f);
            ensure(t.lnext(y) == z && t.lnext(z) == x, || {
                format!("face {f} is not a triangle")
            })?;
            let [a, b, c] = self.corners(super::FaceId(f));
            ensure(orient2d(a, b, c) > 0, || {
                format!("face {f}: {a:?} {b:?} {c:?} does not turn left")
            })?;
        }
        let mut e = t.face_edge(OUTSIDE);
        for _ in 0..4 {
            ensure(t.left(e) == OUTSIDE && t.origin(e) < 4, || {
                "the outer box is broken".into()
            })?;
            e = t.lnext(e);
        }
        ensure(e == t.face_edge(OUTSIDE), || {
            "the outside has not four sides".into()
        })
    }

    /// Euler's formula, and that every edge record belongs to a vertex's ring.
    fn check_euler(&self) -> Result<(), Wrong> {
        let t = self.topology();
        let (v, e, f) = (
            self.vertices().count(),
            t.edges().count(),
            t.faces().count() + 1,
        );
        ensure(v + f == e + 2, || {
            format!("{v} vertices, {e} edges, {f} faces do not make a plane")
        })?;
        let ends: usize = self.vertices().map(|v| t.ring(v.0).count()).sum();
        ensure(ends == 2 * e, || {
            format!("{ends} ends in the rings of vertices, {e} edges")
        })
    }

    /// Free edges are legal, ties included; fixed ones are those in use and the outer box.
    fn check_legal(&self) -> Result<(), Wrong> {
        let t = self.topology();
        for q in t.edges() {
            let outer = t.left(q) == OUTSIDE || t.left(sym(q)) == OUTSIDE;
            let fixed = self.triangulation.is_fixed(q);
            ensure(fixed == (outer || !self.uses.is_empty(q)), || {
                format!("edge {q}: fixed {fixed}, outer {outer}")
            })?;
            ensure(fixed || self.triangulation.is_legal(q), || {
                format!("edge {q} is free and illegal")
            })?;
        }
        Ok(())
    }

    /// Chains lead from end to end along edges in use, monotone, through pixels that their segments meet; every
    /// vertex but the corners of the box is on one.
    fn check_chains(&self) -> Result<(), Wrong> {
        let mut on_chain = vec![false; self.topology().vertex_count()];
        on_chain[..CORNERS.len()].fill(true);
        for s in self.all_segments() {
            let (segment, chain) = (self.segment(s), self.chain(s));
            let points: Vec<Point> = chain.iter().map(|&v| self.point(v)).collect();
            let ends = (points.first(), points.last());
            ensure(ends == (Some(&segment.a), Some(&segment.b)), || {
                format!("{s:?}: its chain has other ends")
            })?;
            let meets = |p: &Point| meets_pixel(segment.a, segment.b, *p);
            ensure(points.iter().all(meets), || {
                format!("{s:?}: its chain leaves its segment")
            })?;
            ensure(is_monotone(segment.a, segment.b, &points), || {
                format!("{s:?}: its chain turns back")
            })?;
            for pair in chain.windows(2) {
                self.check_piece(s, pair[0], pair[1])?;
            }
            chain.iter().for_each(|v| on_chain[v.index()] = true);
        }
        let idle = self.vertices().find(|v| !on_chain[v.index()]);
        ensure(idle.is_none(), || format!("{idle:?} is on no chain"))
    }

    /// A piece of a chain is an edge that knows of it.
    fn check_piece(&self, s: SegmentId, v: VertexId, w: VertexId) -> Result<(), Wrong> {
        let e = self
            .edge_between(v, w)
            .ok_or_else(|| format!("{s:?}: {v:?} {w:?} is no edge"))?;
        let uses = self.uses(e).filter(|u| u.segment == s && u.forward).count();
        ensure(uses == 1, || {
            format!("{s:?}: edge {e:?} knows of it {uses} times")
        })
    }

    /// There are as many uses as pieces (so with the chains checked, they are the same), in their order.
    fn check_uses(&self) -> Result<(), Wrong> {
        let pieces: usize = self.all_segments().map(|s| self.chain(s).len() - 1).sum();
        let uses: usize = self
            .topology()
            .edges()
            .map(|q| self.uses.of(q).count())
            .sum();
        ensure(pieces == uses, || {
            format!("{pieces} pieces of chains, {uses} uses of edges")
        })?;
        for q in self.topology().edges() {
            let ranks = self.uses.of(q).map(|u| self.segment(u.segment).rank());
            ensure(ranks.is_sorted(), || {
                format!("edge {q}: its uses are not in order")
            })?;
            for e in [q, sym(q)].map(EdgeId) {
                let front = self.fronts(e).next().is_some();
                ensure(self.has_front(e) == front, || {
                    format!("{e:?}: fronts on its left: {front}, noted otherwise")
                })?;
            }
        }
        Ok(())
    }

    /// Across each edge the covers differ by the features that run along it; nothing winds backwards.
    fn check_covers(&self) -> Result<(), Wrong> {
        let t = self.topology();
        ensure(self.covers.windings(OUTSIDE).next().is_none(), || {
            "the outside is covered".into()
        })?;
        for e in t.edges() {
            self.check_step(e)?;
        }
        for f in t.faces() {
            let is_solid = |&feature: &_| self.kind_of(feature) == Some(Kind::Solid);
            let solid = self.covers.features(f).iter().any(is_solid);
            ensure(self.covers.is_solid(f) == solid, || {
                format!("face {f}: solid or not, its cover says otherwise")
            })?;
        }
        self.covers
            .check_counts(std::iter::once(OUTSIDE).chain(t.faces()))
    }

    fn check_step(&self, e: Quarter) -> Result<(), Wrong> {
        let t = self.topology();
        let mut windings: Vec<_> = self.covers.windings(t.left(sym(e))).collect();
        self.gain(e, &mut windings);
        merge(&mut windings);
        let found: Vec<_> = self.covers.windings(t.left(e)).collect();
        ensure(windings == found, || {
            format!("edge {e}: its left is covered {found:?}, not {windings:?}")
        })
    }

    /// The feature edges of all features.
    fn all_segments(&self) -> impl Iterator<Item = SegmentId> + '_ {
        self.features
            .values()
            .flat_map(|f| f.segments.iter().copied())
    }
}

/// Whether points follow each other in the direction from a to b, in both coordinates.
fn is_monotone(a: Point, b: Point, points: &[Point]) -> bool {
    let along = |from: i32, to: i32, p: i32, q: i32| if from <= to { p <= q } else { p >= q };
    points
        .windows(2)
        .all(|p| p[0] != p[1] && along(a.x, b.x, p[0].x, p[1].x) && along(a.y, b.y, p[0].y, p[1].y))
}
