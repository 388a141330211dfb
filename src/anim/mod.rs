//! Poses as values: plain numbers about a moment in, a matrix for each part of a figure out. No picture is drawn here.

pub mod hero;
mod numbers;

pub use numbers::Numbers;
