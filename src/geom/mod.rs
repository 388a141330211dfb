//! Numbers only: points on the grid, exact predicates, polygons and their Minkowski sums.

pub mod grid;

pub use grid::{BOUND, Point, STEP};
