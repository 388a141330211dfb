//! What the mesh tests share.

pub mod worlds;
pub mod slow;
