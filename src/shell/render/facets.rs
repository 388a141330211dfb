//! Cuts the solid triangles of a level into facets of even size, as if carved.
//!
//! A triangulation as half-edges: half-edge `e` belongs to triangle `e / 3`, starts at `origin[e]`, and `twin[e]` runs the
//! other way in the neighbouring triangle, or is [`NONE`] where free space begins. Refining only splits edges that are too
//! long and then restores the Delaunay property by flips (C. Lawson 1977), never across borders of free space or of
//! materials. This is a picture: coordinates are floats, and new points on a border may lie off it by a rounding.

use crate::geom::Point;
use crate::level::Material;
use glam::DVec2;
use robust::{Coord, incircle, orient2d};
use std::collections::BTreeMap;

/// What a triangle is to look like.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Look {
    /// What it is made of.
    pub material: Material,
    /// Slippery.
    pub slick: bool,
    /// Part of something that is taller than wide.
    pub upright: bool,
}

/// How much longer edges may be within what was built: its fronts are flat.
const BUILT: f64 = 4.0;

/// No neighbour: free space.
pub const NONE: usize = usize::MAX;

/// The triangulation.
#[derive(Default)]
pub struct Facets {
    /// Vertices, in metres.
    pub points: Vec<DVec2>,
    /// The vertex at which each half-edge starts.
    pub origin: Vec<usize>,
    /// The half-edge on the other side.
    pub twin: Vec<usize>,
    /// The look of each triangle.
    pub look: Vec<Look>,
    /// One half-edge that starts at each vertex.
    leaving: Vec<usize>,
}

/// The half-edge after `e` in its triangle, counter-clockwise.
pub fn next(e: usize) -> usize {
    if e % 3 == 2 { e - 2 } else { e + 1 }
}

/// The half-edge before `e` in its triangle.
pub fn prev(e: usize) -> usize {
    if e.is_multiple_of(3) { e + 2 } else { e - 1 }
}

fn coord(p: DVec2) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

impl Facets {
    /// Joins triangles (counter-clockwise) along the edges that they share. Their order does not matter, nor which of their
    /// corners comes first: the picture is the same however the mesh was built.
    pub fn new(triangles: &[([Point; 3], Look)]) -> Facets {
        let from_least = |([a, b, c], look): &([Point; 3], Look)| {
            let corners = [[a, b, c], [b, c, a], [c, a, b]].map(|turned| turned.map(|p| *p));
            (corners.into_iter().min().unwrap_or([*a, *b, *c]), *look)
        };
        let mut triangles: Vec<_> = triangles.iter().map(from_least).collect();
        triangles.sort_by_key(|(corners, _)| *corners);
        let mut facets = Facets::default();
        let mut vertices: BTreeMap<Point, usize> = BTreeMap::new();
        let mut edges: BTreeMap<(usize, usize), usize> = BTreeMap::new();
        for (corners, look) in &triangles {
            let corners = corners.map(|point| {
                *vertices.entry(point).or_insert_with(|| {
                    facets.points.push(point.metres());
                    facets.leaving.push(NONE);
                    facets.points.len() - 1
                })
            });
            facets.look.push(*look);
            for i in 0..3 {
                let e = facets.origin.len();
                edges.insert((corners[i], corners[(i + 1) % 3]), e);
                facets.origin.push(corners[i]);
                facets.leaving[corners[i]] = e;
            }
        }
        let twin = |e: usize| {
            edges
                .get(&(facets.origin[next(e)], facets.origin[e]))
                .copied()
                .unwrap_or(NONE)
        };
        facets.twin = (0..facets.origin.len()).map(twin).collect();
        facets.restore((0..facets.origin.len()).collect());
        facets
    }

    /// Start and end of a half-edge.
    pub fn ends(&self, e: usize) -> (DVec2, DVec2) {
        (
            self.points[self.origin[e]],
            self.points[self.origin[next(e)]],
        )
    }

    /// Whether free space lies on the right of a half-edge.
    pub fn is_border(&self, e: usize) -> bool {
        self.twin[e] == NONE
    }

    /// Splits edges until none is longer than `border` metres where free space begins, then until none is longer than
    /// `inner` elsewhere; the longest first, or points would crowd where a long edge is still whole. Inner edges are
    /// split off their middle and off their line by what `jitter` gives for it, -1 to 1 on both axes.
    pub fn refine(&mut self, border: f64, inner: f64, jitter: impl Fn(DVec2) -> DVec2) {
        for (on_border, limit) in [(true, border), (false, inner)] {
            for longest in [64.0, 16.0, 8.0, 4.0, 2.0, 1.0].map(|factor| factor * limit) {
                // The corners keep their distance, so few sweeps do; the bound is for numbers that no level has.
                (0..24).any(|_| !self.sweep(on_border, longest, limit / 4.0, &jitter));
            }
        }
    }

    /// Splits every edge longer than `longest` once; gives whether there was one.
    fn sweep(
        &mut self,
        on_border: bool,
        longest: f64,
        gap: f64,
        jitter: impl Fn(DVec2) -> DVec2,
    ) -> bool {
        let before = self.points.len();
        for e in 0..self.origin.len() {
            let (a, b) = self.ends(e);
            let longest = match self.look[e / 3].material {
                Material::Rock => longest,
                _ if on_border => longest,
                _ => longest * BUILT,
            };
            if self.is_border(e) == on_border && a.distance(b) > longest {
                let middle = (a + b) / 2.0;
                if let Some(play) = self.play(e, gap) {
                    self.split(e, middle + jitter(middle) * play);
                }
            }
        }
        self.points.len() > before
    }

    /// How far the middle of an edge may move aside, in metres: not at all where it has to stay on a line. `None` if it
    /// should not be split, because an opposite corner is nearer to its middle than `gap`.
    fn play(&self, e: usize, gap: f64) -> Option<f64> {
        let f = self.twin[e];
        let (a, b) = self.ends(e);
        let way = |e: usize| self.points[self.origin[prev(e)]].distance((a + b) / 2.0);
        let nearest = if f == NONE {
            return Some(0.0);
        } else {
            way(e).min(way(f))
        };
        let fixed = self.look[e / 3] != self.look[f / 3];
        let height = |e: usize| {
            (b - a)
                .perp_dot(self.points[self.origin[prev(e)]] - a)
                .abs()
                / a.distance(b)
        };
        let play = if fixed {
            0.0
        } else {
            height(e).min(height(f)).min(a.distance(b)) * 0.15
        };
        (nearest > gap).then_some(play)
    }

    /// Puts a new vertex on an edge, cuts the triangles beside it in two and restores the Delaunay property.
    fn split(&mut self, e: usize, at: DVec2) {
        let v = self.add_point(at);
        let f = self.twin[e];
        let beyond = self.halve(e, v);
        let mut outer = vec![prev(e), next(beyond)];
        if f != NONE {
            let back = self.halve(f, v);
            self.link(e, back);
            self.link(f, beyond);
            outer.extend([prev(f), next(back)]);
        }
        self.restore(outer);
    }

    /// Cuts the triangle of `e` from `v` on `e` to the opposite corner; `e` ends at `v` then. Gives the half-edge that
    /// starts at `v` and goes on to where `e` ended; its twin is not set.
    ///
    /// ```text
    ///        c               c
    ///       / \             /|\
    ///      /   \    ->     / | \
    ///     a--e--b         a-e v-g-b
    /// ```
    fn halve(&mut self, e: usize, v: usize) -> usize {
        let (b, c, outer) = (
            self.origin[next(e)],
            self.origin[prev(e)],
            self.twin[next(e)],
        );
        let g = self.origin.len();
        self.add_triangle(e, [v, b, c]);
        self.start(next(e), v);
        self.link(g + 1, outer);
        self.link(g + 2, next(e));
        g
    }

    fn add_point(&mut self, at: DVec2) -> usize {
        self.points.push(at);
        self.leaving.push(NONE);
        self.points.len() - 1
    }

    /// Appends a triangle of the look of half-edge `like`, without neighbours yet.
    fn add_triangle(&mut self, like: usize, corners: [usize; 3]) {
        let t = self.origin.len();
        self.origin.extend(corners);
        self.twin.extend([NONE; 3]);
        self.look.push(self.look[like / 3]);
        for (e, v) in (t..).zip(corners) {
            self.leaving[v] = e;
        }
    }

    /// Makes a half-edge start at a vertex.
    fn start(&mut self, e: usize, v: usize) {
        self.origin[e] = v;
        self.leaving[v] = e;
    }

    /// Joins two half-edges as the two sides of an edge.
    fn link(&mut self, e: usize, f: usize) {
        self.twin[e] = f;
        if f != NONE {
            self.twin[f] = e;
        }
    }

    /// Flips these edges, and those around each flip, until all are Delaunay or may not be flipped.
    fn restore(&mut self, mut suspects: Vec<usize>) {
        while let Some(e) = suspects.pop() {
            if self.wants_flip(e) {
                let f = self.twin[e];
                self.flip(e);
                suspects.extend([next(e), prev(e), next(f), prev(f)]);
            }
        }
    }

    /// Whether the corner beyond an inner edge lies in the circle of the triangle before it, and a flip keeps both
    /// triangles counter-clockwise.
    fn wants_flip(&self, e: usize) -> bool {
        let f = self.twin[e];
        if f == NONE || self.look[e / 3] != self.look[f / 3] {
            return false;
        }
        let [a, b, c, d] =
            [e, next(e), prev(e), prev(f)].map(|e| coord(self.points[self.origin[e]]));
        incircle(a, b, c, d) > 0.0 && orient2d(d, c, a) > 0.0 && orient2d(c, d, b) > 0.0
    }

    /// Turns the edge between two triangles into the other diagonal of their quadrilateral.
    ///
    /// ```text
    ///        c                c
    ///       / \              /|\
    ///      / e \            / | \
    ///     a-----b    ->    a  e  b
    ///      \ f /            \ | /
    ///       \ /              \|/
    ///        d                d
    /// ```
    fn flip(&mut self, e: usize) {
        let f = self.twin[e];
        let [b, c, a, d] = [next(e), prev(e), next(f), prev(f)].map(|e| self.origin[e]);
        let [bc, ca, ad, db] = [next(e), prev(e), next(f), prev(f)].map(|e| self.twin[e]);
        for (edge, origin) in [
            (e, d),
            (next(e), c),
            (prev(e), a),
            (f, c),
            (next(f), d),
            (prev(f), b),
        ] {
            self.start(edge, origin);
        }
        for (edge, twin) in [(next(e), ca), (prev(e), ad), (next(f), db), (prev(f), bc)] {
            self.link(edge, twin);
        }
    }

    /// Adds a vertex strictly inside the solid, found by walking from vertex `from`, unless a border is in the way or a
    /// corner is nearer than `gap` metres.
    pub fn insert(&mut self, from: usize, at: DVec2, gap: f64) -> Option<usize> {
        let t = self.walk(self.leaving[from], at)?;
        let near = |e: usize| self.points[self.origin[e]].distance(at) < gap;
        if (t..t + 3).any(near) {
            return None;
        }
        let v = self.add_point(at);
        let (outer, corners) = (
            [0, 1, 2].map(|i| self.twin[t + i]),
            [0, 1, 2].map(|i| self.origin[t + i]),
        );
        let n = self.origin.len();
        self.add_triangle(t, [corners[1], corners[2], v]);
        self.add_triangle(t, [corners[2], corners[0], v]);
        self.start(t + 2, v);
        for (e, f) in [
            (t, outer[0]),
            (n, outer[1]),
            (n + 3, outer[2]),
            (t + 1, n + 2),
            (n + 1, n + 5),
            (n + 4, t + 2),
        ] {
            self.link(e, f);
        }
        self.restore(vec![t, n, n + 3]);
        Some(v)
    }

    /// The first half-edge of the triangle that holds a point strictly inside; `None` behind a border or on an edge.
    fn walk(&self, start: usize, at: DVec2) -> Option<usize> {
        let mut t = start / 3 * 3;
        for _ in 0..64 {
            let side = |e: usize| orient2d(coord(self.ends(e).0), coord(self.ends(e).1), coord(at));
            let Some(e) = (t..t + 3).find(|&e| side(e) < 0.0) else {
                return (t..t + 3).all(|e| side(e) > 0.0).then_some(t);
            };
            if self.is_border(e) || self.look[e / 3] != self.look[self.twin[e] / 3] {
                return None;
            }
            t = self.twin[e] / 3 * 3;
        }
        None
    }

    /// How far each vertex lies from free space, along edges, in metres.
    pub fn depths(&self) -> Vec<f64> {
        let mut depth = vec![f64::INFINITY; self.points.len()];
        for e in (0..self.origin.len()).filter(|&e| self.is_border(e)) {
            depth[self.origin[e]] = 0.0;
            depth[self.origin[next(e)]] = 0.0;
        }
        let mut changed = true;
        while changed {
            changed = false;
            for e in 0..self.origin.len() {
                let (v, w) = (self.origin[e], self.origin[next(e)]);
                let way = self.points[v].distance(self.points[w]);
                for (from, to) in [(v, w), (w, v)] {
                    if depth[from] + way < depth[to] {
                        depth[to] = depth[from] + way;
                        changed = true;
                    }
                }
            }
        }
        depth
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area that the triangles cover; checks on the way that all are counter-clockwise and rightly linked.
    fn checked_area(facets: &Facets) -> f64 {
        for e in 0..facets.origin.len() {
            let f = facets.twin[e];
            assert!(
                f == NONE
                    || (facets.twin[f] == e
                        && facets.ends(f) == (facets.ends(e).1, facets.ends(e).0)),
                "edge {e}"
            );
        }
        let area = |t: usize| {
            let [a, b, c] = [0, 1, 2].map(|i| facets.points[facets.origin[3 * t + i]]);
            let area = (b - a).perp_dot(c - a);
            assert!(area > 0.0, "triangle {t} at {a}");
            area
        };
        (0..facets.look.len()).map(area).sum()
    }

    /// A 40 m by 10 m slab as two triangles, with a masonry block of 10 m by 10 m at its right end.
    fn slab() -> Facets {
        Facets::new(&slab_triangles())
    }

    fn slab_triangles() -> [([Point; 3], Look); 4] {
        let p = |x: i32, y: i32| Point::new(x << 16, y << 16);
        let rock = Look::default();
        let masonry = Look {
            material: Material::Masonry,
            ..rock
        };
        [
            ([p(0, 0), p(40, 0), p(40, 10)], rock),
            ([p(0, 0), p(40, 10), p(0, 10)], rock),
            ([p(40, 0), p(50, 0), p(50, 10)], masonry),
            ([p(40, 0), p(50, 10), p(40, 10)], masonry),
        ]
    }

    #[test]
    fn the_order_of_triangles_and_of_their_corners_does_not_matter() {
        let mut other = slab_triangles();
        other.reverse();
        other
            .iter_mut()
            .for_each(|(corners, _)| corners.rotate_left(1));
        let mut both = [slab(), Facets::new(&other)];
        both.iter_mut().for_each(|f| f.refine(1.3, 1.8, jitter));
        assert_eq!(both[0].points, both[1].points);
        assert_eq!(both[0].origin, both[1].origin);
    }

    fn jitter(p: DVec2) -> DVec2 {
        DVec2::new(
            (p.x * 91.7 + p.y * 13.1).sin(),
            (p.x * 37.3 - p.y * 71.9).sin(),
        )
    }

    #[test]
    fn refining_keeps_the_shape_and_shortens_every_edge() {
        let mut facets = slab();
        facets.refine(1.3, 1.8, jitter);
        assert!((checked_area(&facets) - 1000.0).abs() < 1e-9);
        let length = |e: usize| facets.ends(e).0.distance(facets.ends(e).1);
        let limit = |e: usize| match facets.look[e / 3].material {
            _ if facets.is_border(e) => 1.3,
            Material::Rock => 1.8,
            _ => 1.8 * BUILT,
        };
        let long = (0..facets.origin.len()).filter(|&e| length(e) > limit(e));
        assert!(long.count() * 100 < facets.origin.len());
        let masonry =
            (0..facets.look.len()).filter(|&t| facets.look[t].material == Material::Masonry);
        let right =
            |t: usize| (0..3).all(|i| facets.points[facets.origin[3 * t + i]].x >= 40.0 - 1e-9);
        assert!(masonry.clone().count() > 30 && masonry.clone().all(right));
    }

    #[test]
    fn points_are_inserted_inside_and_refused_behind_borders() {
        let mut facets = slab();
        facets.refine(1.3, 4.0, jitter);
        let border = (0..facets.origin.len())
            .find(|&e| facets.is_border(e))
            .expect("a slab has borders");
        let (a, b) = facets.ends(border);
        let inward = (b - a).perp().normalize();
        assert!(
            facets
                .insert(facets.origin[border], (a + b) / 2.0 - inward * 0.3, 0.1)
                .is_none()
        );
        let v = facets
            .insert(facets.origin[border], (a + b) / 2.0 + inward * 0.3, 0.1)
            .expect("there is room");
        assert!((checked_area(&facets) - 1000.0).abs() < 1e-9);
        assert!(
            (facets.depths()[v] - (0.3f64.powi(2) + (a.distance(b) / 2.0).powi(2)).sqrt()).abs()
                < 1e-9
        );
    }
}
