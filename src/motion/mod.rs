//! One body in the mesh.
