//! Numbers only: points on the grid, exact predicates, polygons and their Minkowski sums.

pub mod grid;
pub mod minkowski;
pub mod polygon;
pub mod predicates;

pub use grid::{BOUND, Point, STEP};
pub use minkowski::{Collider, ColliderError, ExpandedEdge, Source, expand};
pub use polygon::{OutlineError, check_outline};
