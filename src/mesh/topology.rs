//! The quad-edge structure of Guibas and Stolfi (1985), for triangulations: who is next to whom, and no coordinates.
//!
//! An undirected edge is one record of four *quarter-edges*: the edge in both directions (even, r = 0 and 2)
//! and its dual in both directions (odd, r = 1 and 3). A quarter-edge is the number `4 * record + r`, so turning
//! it is bit arithmetic. `next` is the next quarter-edge counter-clockwise about the same origin; an
//! origin is a vertex for even quarter-edges and a face for odd ones, so the dual graph is walked by the same rule.
//!
//! Invariants (see `check`): `next` is a permutation; `rot(next(rot(next(q)))) = q`; all
//! quarter-edges of a ring carry the same origin; every face but [`OUTSIDE`] is a triangle. The sequence of calls fixes all ids.

/// The face around everything.
pub const OUTSIDE: u32 = 0;
/// No vertex, no face, no edge.
pub const NONE: u32 = u32::MAX;

/// A quarter-edge.
pub type Quarter = u32;

/// One undirected edge with its dual: 32 bytes, half a cache line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct QuadEdge {
    /// For each quarter-edge the next one counter-clockwise about its origin.
    next: [Quarter; 4],
    /// For each quarter-edge its origin: vertex, right face, vertex, left face.
    data: [u32; 4],
}

/// A record that is not in use.
const UNUSED: QuadEdge = QuadEdge {
    next: [NONE; 4],
    data: [NONE; 4],
};

/// The dual edge that crosses from the right face to the left one.
#[inline]
pub const fn rot(q: Quarter) -> Quarter {
    (q & !3) | ((q + 1) & 3)
}

/// The dual edge that crosses from the left face to the right one.
#[inline]
pub const fn inv_rot(q: Quarter) -> Quarter {
    (q & !3) | ((q + 3) & 3)
}

/// The same edge, other way.
#[inline]
pub const fn sym(q: Quarter) -> Quarter {
    q ^ 2
}

/// Vertices, edges and faces of a triangulation.
#[derive(Clone, Debug, Default)]
pub struct Topology {
    quads: Vec<QuadEdge>,
    /// For each vertex one edge that starts there; `NONE` for unused ids.
    vertex_edge: Vec<Quarter>,
    /// For each face one edge that has it on its left; `NONE` for unused ids.
    face_edge: Vec<Quarter>,
    free_quads: Vec<u32>,
    free_faces: Vec<u32>,
    /// Per face: whether it was made, changed or removed since [`Topology::take_touched`].
    touched: Vec<bool>,
    touched_list: Vec<u32>,
}

// Reading: one or two loads each.
impl Topology {
    /// Next edge counter-clockwise about the origin.
    #[inline]
    pub fn onext(&self, q: Quarter) -> Quarter {
        self.quads[(q >> 2) as usize].next[(q & 3) as usize]
    }

    /// Next edge clockwise about the origin.
    #[inline]
    pub fn oprev(&self, q: Quarter) -> Quarter {
        rot(self.onext(rot(q)))
    }

    /// Next edge counter-clockwise about the left face.
    #[inline]
    pub fn lnext(&self, q: Quarter) -> Quarter {
        rot(self.onext(inv_rot(q)))
    }

    /// Previous edge counter-clockwise about the left face.
    #[inline]
    pub fn lprev(&self, q: Quarter) -> Quarter {
        sym(self.onext(q))
    }

    /// The vertex (of an edge) or face (of a dual edge) where a quarter-edge starts.
    #[inline]
    pub fn origin(&self, q: Quarter) -> u32 {
        self.quads[(q >> 2) as usize].data[(q & 3) as usize]
    }

    /// Where a quarter-edge ends.
    #[inline]
    pub fn dest(&self, q: Quarter) -> u32 {
        self.origin(sym(q))
    }

    /// The face on the left.
    #[inline]
    pub fn left(&self, q: Quarter) -> u32 {
        self.origin(inv_rot(q))
    }

    /// The vertex across the left triangle.
    #[inline]
    pub fn apex(&self, q: Quarter) -> u32 {
        self.origin(self.lprev(q))
    }

    /// Start and end of an edge, and the corner of the triangle on its right that is neither.
    #[inline]
    pub fn triangle_beyond(&self, q: Quarter) -> [u32; 3] {
        let quad = &self.quads[(q >> 2) as usize];
        let (here, there) = ((q & 3) as usize, (sym(q) & 3) as usize);
        let [start, end] = [here, there].map(|i| quad.data[i]);
        [start, end, self.dest(quad.next[there])]
    }

    /// One edge that starts at a vertex.
    #[inline]
    pub fn vertex_edge(&self, v: u32) -> Quarter {
        self.vertex_edge[v as usize]
    }

    /// One edge with a face on its left.
    #[inline]
    pub fn face_edge(&self, f: u32) -> Quarter {
        self.face_edge[f as usize]
    }

    /// All edges that start at a vertex, counter-clockwise.
    pub fn ring(&self, v: u32) -> impl Iterator<Item = Quarter> + '_ {
        self.ring_from(self.vertex_edge(v))
    }

    /// All edges that start where one does, counter-clockwise, beginning with that one.
    pub fn ring_from(&self, first: Quarter) -> impl Iterator<Item = Quarter> + '_ {
        std::iter::successors(Some(first), move |&q| {
            Some(self.onext(q)).filter(|&next| next != first)
        })
    }

    /// The edge from one vertex to another.
    pub fn edge_between(&self, v: u32, w: u32) -> Option<Quarter> {
        self.ring(v).find(|&q| self.dest(q) == w)
    }

    /// One more than the largest vertex id in use so far.
    pub fn vertex_count(&self) -> usize {
        self.vertex_edge.len()
    }

    /// One more than the largest record id in use so far.
    pub fn quad_count(&self) -> usize {
        self.quads.len()
    }

    /// Whether a vertex id is in use.
    pub fn has_vertex(&self, v: u32) -> bool {
        self.vertex_edge.get(v as usize).is_some_and(|&q| q != NONE)
    }

    /// Whether a face id is in use.
    pub fn is_face(&self, f: u32) -> bool {
        self.face_edge.get(f as usize).is_some_and(|&e| e != NONE)
    }

    /// The three edges that have a face on their left, counter-clockwise.
    #[inline]
    pub fn sides(&self, f: u32) -> [Quarter; 3] {
        let e = self.face_edge(f);
        [e, self.lnext(e), self.lprev(e)]
    }

    /// All faces but [`OUTSIDE`], ascending.
    pub fn faces(&self) -> impl Iterator<Item = u32> + '_ {
        (1..self.face_edge.len() as u32).filter(|&f| self.face_edge(f) != NONE)
    }

    /// One edge of each record in use (r = 0), ascending.
    pub fn edges(&self) -> impl Iterator<Item = Quarter> + '_ {
        (0..self.quads.len() as u32)
            .map(|quad| 4 * quad)
            .filter(|&q| self.origin(q) != NONE)
    }

    /// One more than the largest face id in use so far.
    pub fn face_count(&self) -> usize {
        self.face_edge.len()
    }
}

// Rewiring.
impl Topology {
    /// A square of four vertices 0..4 (counter-clockwise), cut from 0 to 2, with faces 1 (0 1 2) and 2 (0 2 3).
    pub fn square() -> Self {
        let mut t = Topology {
            vertex_edge: vec![NONE; 4],
            face_edge: vec![NONE; 1],
            touched: vec![true],
            ..Self::default()
        };
        let sides = [(0, 1), (1, 2), (2, 3), (3, 0)].map(|(v, w)| t.make_edge(v, w));
        for i in 0..4 {
            t.splice(sym(sides[i]), sides[(i + 1) % 4]);
        }
        // Connect corner 2 with corner 0 across the inside.
        let cut = t.make_edge(2, 0);
        t.splice(cut, t.lnext(sides[1]));
        t.splice(sym(cut), sides[0]);
        let (f, g) = (t.make_face(), t.make_face());
        t.set_triangle([sides[0], sides[1], cut], f);
        t.set_triangle([sym(cut), sides[2], sides[3]], g);
        for side in sides {
            t.set_origin(rot(side), OUTSIDE);
        }
        t.face_edge[OUTSIDE as usize] = sym(sides[0]);
        t
    }

    /// Makes room for so many more vertices, with the edges and faces that come with them.
    pub fn reserve(&mut self, vertices: usize) {
        self.vertex_edge.reserve(vertices);
        self.quads.reserve(3 * vertices);
        self.face_edge.reserve(2 * vertices);
        self.touched.reserve(2 * vertices);
    }

    /// A loose edge between two vertices: `make_edge` of the paper.
    fn make_edge(&mut self, v: u32, w: u32) -> Quarter {
        let q = self.make_quad();
        self.quads[(q >> 2) as usize] = QuadEdge {
            next: [q, q + 3, q + 2, q + 1],
            data: [v, NONE, w, NONE],
        };
        self.vertex_edge[v as usize] = q;
        self.vertex_edge[w as usize] = sym(q);
        q
    }

    /// A record to be filled.
    fn make_quad(&mut self) -> Quarter {
        let quad = self.free_quads.pop().unwrap_or_else(|| {
            self.quads.push(UNUSED);
            self.quads.len() as u32 - 1
        });
        4 * quad
    }

    /// Joins the rings of a and b if they are apart and parts them if they are one; so, too, for the dual rings.
    fn splice(&mut self, a: Quarter, b: Quarter) {
        let (alpha, beta) = (rot(self.onext(a)), rot(self.onext(b)));
        let (a_next, b_next) = (self.onext(a), self.onext(b));
        let (alpha_next, beta_next) = (self.onext(alpha), self.onext(beta));
        self.set_next(a, b_next);
        self.set_next(b, a_next);
        self.set_next(alpha, beta_next);
        self.set_next(beta, alpha_next);
    }

    #[inline]
    fn set_next(&mut self, q: Quarter, next: Quarter) {
        self.quads[(q >> 2) as usize].next[(q & 3) as usize] = next;
    }

    #[inline]
    fn set_origin(&mut self, q: Quarter, origin: u32) {
        self.quads[(q >> 2) as usize].data[(q & 3) as usize] = origin;
    }

    /// Makes three edges, each starting where the one before ends, the triangle of a face.
    ///
    /// This wires both graphs: the three dual edges become the ring of the face, and at each corner the side that
    /// leaves it is followed by the side that reaches it. All operations below are made of it.
    #[inline]
    pub fn set_triangle(&mut self, sides: [Quarter; 3], face: u32) {
        let [x, y, z] = sides;
        self.set_side(x, z, y, face);
        self.set_side(y, x, z, face);
        self.set_side(z, y, x, face);
        self.face_edge[face as usize] = x;
        self.touch(face);
    }

    /// Makes an edge a side of a triangle, between the sides before and after it.
    #[inline]
    fn set_side(&mut self, q: Quarter, before: Quarter, after: Quarter, face: u32) {
        let quad = &mut self.quads[(q >> 2) as usize];
        let dual = (inv_rot(q) & 3) as usize;
        quad.next[(q & 3) as usize] = sym(before);
        quad.next[dual] = inv_rot(after);
        quad.data[dual] = face;
    }

    #[inline]
    fn touch(&mut self, face: u32) {
        if !self.touched[face as usize] {
            self.touched[face as usize] = true;
            self.touched_list.push(face);
        }
    }

    /// Gives an edge other ends. The triangles beside it are to be set next.
    #[inline]
    pub fn set_ends(&mut self, q: Quarter, v: u32, w: u32) {
        self.set_origin(q, v);
        self.set_origin(sym(q), w);
    }

    /// Notes that an edge starts at its origin, for [`Topology::vertex_edge`].
    #[inline]
    pub fn anchor(&mut self, q: Quarter) {
        let v = self.origin(q);
        self.vertex_edge[v as usize] = q;
    }

    fn make_face(&mut self) -> u32 {
        self.free_faces.pop().unwrap_or_else(|| {
            self.face_edge.push(NONE);
            self.touched.push(false);
            self.face_edge.len() as u32 - 1
        })
    }

    /// Turns an edge that lies between two triangles into the other diagonal of their quadrangle.
    ///
    /// ```text
    ///        d                  d
    ///      / ^ \              /   \
    ///    n1  |  m2          n1     m2         counter-clockwise: e, n1, n2 and sym e, m1, m2 before,
    ///    l   e   r    ->    l <-e-- r         e, n2, m1 and sym e, m2, n1 after
    ///    n2  |  m1          n2     m1
    ///      \ | /              \   /
    ///        o                  o
    /// ```
    pub fn flip(&mut self, e: Quarter) {
        let (q, p) = ((e & 3) as usize, (sym(e) & 3) as usize);
        let (q_dual, p_dual) = ((inv_rot(e) & 3) as usize, (rot(e) & 3) as usize);
        // All of it is in the record of e.
        let quad = &self.quads[(e >> 2) as usize];
        let (n1, n2) = (rot(quad.next[q_dual]), sym(quad.next[q]));
        let (m1, m2) = (rot(quad.next[p_dual]), sym(quad.next[p]));
        let [o, d, f, g] = [q, p, q_dual, p_dual].map(|i| quad.data[i]);
        let ends = [self.origin(m2), self.origin(n2)];
        let quad = &mut self.quads[(e >> 2) as usize];
        [quad.data[q], quad.data[p]] = ends;
        quad.next[q] = sym(m1);
        quad.next[p] = sym(n1);
        quad.next[q_dual] = inv_rot(n2);
        quad.next[p_dual] = inv_rot(m2);
        // The rings of o and d lose the edge.
        self.vertex_edge[o as usize] = m1;
        self.vertex_edge[d as usize] = n1;
        self.set_side(n2, e, m1, f);
        self.set_side(m1, n2, e, f);
        self.set_side(m2, sym(e), n1, g);
        self.set_side(n1, m2, sym(e), g);
        self.face_edge[f as usize] = e;
        self.face_edge[g as usize] = sym(e);
        self.touch(f);
        self.touch(g);
    }

    /// Puts the new vertex v into a face; returns an edge that starts at v.
    ///
    /// ```text
    ///          c                   c
    ///        /   \               / | \          x, y, z run counter-clockwise from a;
    ///       z     y     ->      z  r  y         p, q, r start at v; the old face
    ///      /       \           / p v q \        keeps the triangle at x
    ///     a ---x--- b         a ---x--- b
    /// ```
    pub fn insert(&mut self, v: u32, face: u32) -> Quarter {
        let x = self.face_edge(face);
        let (y, z) = (self.lnext(x), self.lprev(x));
        if self.vertex_edge.len() <= v as usize {
            self.vertex_edge.resize(v as usize + 1, NONE);
        }
        let [a, b, c] = [x, y, z].map(|side| self.origin(side));
        let (g, h) = (self.make_face(), self.make_face());
        let [p, q, r] = [(); 3].map(|()| self.make_quad());
        for (spoke, ring, sides, faces, corner) in [
            (p, [q, r], [x, z], [face, h], a),
            (q, [r, p], [y, x], [g, face], b),
            (r, [p, q], [z, y], [h, g], c),
        ] {
            // Of each pair the first is counter-clockwise of the spoke, and the other clockwise.
            self.quads[(spoke >> 2) as usize] = QuadEdge {
                next: [ring[0], inv_rot(ring[1]), sym(sides[1]), inv_rot(sides[0])],
                data: [v, faces[1], corner, faces[0]],
            };
        }
        self.vertex_edge[v as usize] = p;
        self.set_side(x, p, sym(q), face);
        self.set_side(y, q, sym(r), g);
        self.set_side(z, r, sym(p), h);
        self.face_edge[face as usize] = x;
        self.face_edge[g as usize] = y;
        self.face_edge[h as usize] = z;
        [face, g, h].into_iter().for_each(|f| self.touch(f));
        p
    }

    /// Removes a vertex of degree three, with its edges, leaving one face: [`Topology::insert`] backwards.
    pub fn remove(&mut self, v: u32) -> u32 {
        let p = self.vertex_edge(v);
        let (q, r) = (self.onext(p), self.oprev(p));
        debug_assert_eq!(
            self.onext(q),
            r,
            "only a vertex of degree three can be removed"
        );
        let sides = [p, q, r].map(|spoke| self.lnext(spoke));
        let faces = [p, q, r].map(|spoke| self.left(spoke));
        sides.iter().for_each(|&side| self.anchor(side));
        for spoke in [p, q, r] {
            self.quads[(spoke >> 2) as usize] = UNUSED;
            self.free_quads.push(spoke >> 2);
        }
        for face in [faces[1], faces[2]] {
            self.face_edge[face as usize] = NONE;
            self.free_faces.push(face);
            self.touch(face);
        }
        self.vertex_edge[v as usize] = NONE;
        self.set_triangle(sides, faces[0]);
        faces[0]
    }

    /// Writes the faces made, changed or removed since the last call to a list, in order of the first change.
    pub fn take_touched(&mut self, list: &mut Vec<u32>) {
        for &f in &self.touched_list {
            self.touched[f as usize] = false;
        }
        list.clear();
        std::mem::swap(list, &mut self.touched_list);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The corners of all faces, each from its smallest, sorted: the triangulation without any ids but vertices.
    fn faces(t: &Topology) -> Vec<[u32; 3]> {
        let corners = |f: u32| {
            let mut corners = t.sides(f).map(|e| t.origin(e));
            let smallest = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
            corners.rotate_left(smallest);
            corners
        };
        let mut faces: Vec<_> = t.faces().map(corners).collect();
        faces.sort_unstable();
        faces
    }

    #[test]
    fn the_square_has_two_triangles_and_an_outside() {
        let t = Topology::square();
        assert_eq!(faces(&t), [[0, 1, 2], [0, 2, 3]]);
        let outside = t.edges().filter(|&q| t.left(sym(q)) == OUTSIDE).count();
        assert_eq!((outside, t.edges().count()), (4, 5));
        assert_eq!(t.ring(0).map(|q| t.dest(q)).collect::<Vec<_>>().len(), 3);
        assert_eq!(t.edge_between(1, 3), None);
    }

    #[test]
    fn four_flips_are_none() {
        let mut t = Topology::square();
        let cut = t.edge_between(0, 2).unwrap();
        let before = t.quads.clone();
        t.flip(cut);
        assert_eq!(faces(&t), [[0, 1, 3], [1, 2, 3]]);
        for _ in 0..3 {
            t.flip(cut);
        }
        assert_eq!(t.quads, before);
    }

    #[test]
    fn removing_undoes_inserting_and_frees_what_it_used() {
        let mut t = Topology::square();
        let before = faces(&t);
        for v in [4, 5, 4] {
            let face = t.faces().next().unwrap();
            t.insert(v, face);
            assert_eq!((t.ring(v).count(), t.faces().count()), (3, 4));
            t.remove(v);
            assert_eq!(faces(&t), before);
        }
        assert_eq!((t.quad_count(), t.face_count()), (8, 5));
    }
}
