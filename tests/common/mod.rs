//! What the mesh tests share.

pub mod checker;
pub mod slow;
pub mod soups;
pub mod tangles;
pub mod worlds;
