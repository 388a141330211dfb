//! The shell: window, picture, overlay.

pub mod render;
