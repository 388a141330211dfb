//! Regions: faces that no edge in use parts.
//!
//! Edges are read one after the other, as they lie in memory; that is several times faster than to walk from face to face. A
//! union-find structure (Tarjan 1975) joins what lies on both sides of a free one.

use super::topology::{Quarter, Topology, sym};

/// The regions of all faces, and the edges between them.
pub struct Regions {
    /// For each face its region, named by the smallest face in it.
    pub of_face: Vec<u32>,
    /// The edges that part regions.
    pub borders: Vec<Border>,
}

/// An edge that parts two regions, which may be the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Border {
    /// The edge.
    pub edge: Quarter,
    /// The region on its left.
    pub left: u32,
    /// The region on its right.
    pub right: u32,
}

impl Border {
    /// The same, other way.
    pub fn turned(self) -> Self {
        Border {
            edge: sym(self.edge),
            left: self.right,
            right: self.left,
        }
    }
}

impl Regions {
    /// The regions of a triangulation; free edges part nothing.
    pub fn of(t: &Topology, is_free: &impl Fn(Quarter) -> bool) -> Self {
        // Of each face first itself or a smaller one of the same region.
        let mut of_face: Vec<u32> = (0..t.face_count() as u32).collect();
        let mut borders = Vec::with_capacity(t.face_count());
        for edge in t.edges() {
            let (left, right) = (t.left(edge), t.left(sym(edge)));
            if is_free(edge) {
                join(&mut of_face, left, right);
            } else {
                borders.push(Border { edge, left, right });
            }
        }
        for face in 0..of_face.len() {
            of_face[face] = of_face[of_face[face] as usize];
        }
        for border in &mut borders {
            border.left = of_face[border.left as usize];
            border.right = of_face[border.right as usize];
        }
        Regions { of_face, borders }
    }
}

/// The smallest face that a face is known to be joined with.
fn smallest(regions: &mut [u32], mut face: u32) -> u32 {
    loop {
        let smaller = regions[face as usize];
        if smaller == face {
            return face;
        }
        // Halve the way for the next time.
        let next = regions[smaller as usize];
        regions[face as usize] = next;
        face = next;
    }
}

fn join(regions: &mut [u32], f: u32, g: u32) {
    let (f, g) = (smallest(regions, f), smallest(regions, g));
    regions[f.max(g) as usize] = f.min(g);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_in_use_parts_what_no_way_around_it_joins() {
        // A square cut from 2 to 0, and a vertex in one half: faces 1, 3 and 4 there, 2 in the other, 0 outside.
        let mut t = Topology::square();
        t.insert(4, 1);
        let between = |v: u32, w: u32| t.edge_between(v, w).expect("an edge");
        let (cut, spoke) = (between(2, 0), between(4, 0));
        let outer = [between(0, 1), between(1, 2), between(2, 3), between(3, 0)];
        let regions = |walls: &[Quarter]| {
            let is_free = |e: Quarter| !walls.iter().any(|&wall| wall >> 2 == e >> 2);
            Regions::of(&t, &is_free)
        };
        assert_eq!(regions(&[]).of_face, [0; 5]);
        assert_eq!(regions(&outer).of_face, [0, 1, 1, 1, 1]);
        let mut walls = outer.to_vec();
        walls.extend([cut, spoke]);
        let halves = regions(&walls);
        assert_eq!(halves.of_face, [0, 1, 2, 1, 1]);
        assert_eq!(halves.borders.len(), walls.len());
        for border in halves.borders.iter().flat_map(|b| [*b, b.turned()]) {
            assert_eq!(halves.of_face[t.left(border.edge) as usize], border.left);
            let beyond = t.left(sym(border.edge));
            assert_eq!(halves.of_face[beyond as usize], border.right);
        }
    }
}
