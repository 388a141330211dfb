//! Numbers only: points on the grid, exact predicates, polygons and their Minkowski sums.

pub mod distance;
pub mod drawn;
pub mod grid;
pub mod minkowski;
pub mod one_way;
pub mod polygon;
pub mod predicates;

pub use drawn::{Aside, Drawn};
pub use grid::{BOUND, Point, STEP};
pub use minkowski::{Collider, ColliderError, ExpandedEdge, Source, expand, expand_drawn};
pub use one_way::{check_polyline, expand_about, expand_one_way, expand_one_way_drawn};
pub use polygon::{OutlineError, check_outline};
