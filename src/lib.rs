//! The folders in reading order; each may name itself and those above it, never those below. Blank lines keep the
//! order: the formatter would sort modules that stand together.
//!
#![doc = include_str!("../README.md")]
#![deny(unsafe_code)]
#![warn(missing_docs)]

pub mod tune;

pub mod geom;

pub mod mesh;

pub mod motion;

pub mod anim;

pub mod pieces;

pub mod level;

pub mod game;

pub mod sound;

pub mod cli;

#[cfg(feature = "shell")]
pub mod shell;
