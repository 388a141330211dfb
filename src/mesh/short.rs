//! Lists that are mostly short, and then need no memory of their own.

use std::ops::Deref;

/// Items in order; up to `FEW` of them are kept in place.
#[derive(Clone, Debug)]
pub enum Short<T, const FEW: usize> {
    /// The first so many of the array.
    Few([T; FEW], u8),
    /// More than that.
    Many(Vec<T>),
}

impl<T: Copy + Default, const FEW: usize> Default for Short<T, FEW> {
    fn default() -> Self {
        Short::Few([T::default(); FEW], 0)
    }
}

impl<T: Copy + Default, const FEW: usize> From<&[T]> for Short<T, FEW> {
    fn from(items: &[T]) -> Self {
        if items.len() > FEW {
            return Short::Many(items.to_vec());
        }
        let mut few = [T::default(); FEW];
        few[..items.len()].copy_from_slice(items);
        Short::Few(few, items.len() as u8)
    }
}

impl<T, const FEW: usize> Deref for Short<T, FEW> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        match self {
            Short::Few(items, count) => &items[..usize::from(*count)],
            Short::Many(items) => items,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_what_it_was_made_of_whatever_its_length() {
        let items: Vec<u32> = (1..20).collect();
        for length in 0..items.len() {
            assert_eq!(*Short::<u32, 6>::from(&items[..length]), items[..length]);
        }
        assert!(Short::<u32, 6>::default().is_empty());
    }
}
