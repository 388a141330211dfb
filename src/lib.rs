//! Edgewalker: a side-scroller whose movement runs, exactly, on a constrained Delaunay mesh.
//!
//! The folders in reading order; each may name itself and those above it, never those below.
#![deny(unsafe_code)]
#![warn(missing_docs)]

pub mod anim;
pub mod cli;
pub mod game;
pub mod geom;
pub mod level;
pub mod mesh;
pub mod motion;
#[cfg(feature = "shell")]
pub mod shell;
pub mod tune;
