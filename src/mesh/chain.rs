//! The vertices of a chain. Most chains have few, and so need no memory of their own.

use super::VertexId;
use std::ops::Deref;

/// So many are kept in place.
const FEW: usize = 6;

/// Vertices in order.
#[derive(Clone, Debug)]
pub enum Chain {
    /// The first so many of the array.
    Few([VertexId; FEW], u8),
    /// More than that.
    Many(Vec<VertexId>),
}

impl Chain {
    /// No vertices.
    pub const EMPTY: Chain = Chain::Few([VertexId(0); FEW], 0);
}

impl Default for Chain {
    fn default() -> Self {
        Chain::EMPTY
    }
}

impl From<&[VertexId]> for Chain {
    fn from(vertices: &[VertexId]) -> Self {
        if vertices.len() > FEW {
            return Chain::Many(vertices.to_vec());
        }
        let mut few = [VertexId(0); FEW];
        few[..vertices.len()].copy_from_slice(vertices);
        Chain::Few(few, vertices.len() as u8)
    }
}

impl Deref for Chain {
    type Target = [VertexId];

    fn deref(&self) -> &[VertexId] {
        match self {
            Chain::Few(vertices, count) => &vertices[..usize::from(*count)],
            Chain::Many(vertices) => vertices,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_is_what_it_was_made_of_whatever_its_length() {
        let vertices: Vec<VertexId> = (0..20).map(VertexId).collect();
        for length in 0..vertices.len() {
            assert_eq!(*Chain::from(&vertices[..length]), vertices[..length]);
        }
        assert!(Chain::EMPTY.is_empty());
    }
}
