//! Who made what.

/// A line of the credits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// What was made.
    Part(&'static str),
    /// By whom, or with what.
    Name(&'static str),
    /// Room.
    Gap,
}

use Line::{Gap, Name, Part};

/// All lines, from the first to the last.
pub const LINES: &[Line] = &[
    Part("Edgewalker"),
    Name("made by the Edgewalker authors"),
    Gap,
    Part("World and rules"),
    Name("The hero, the quarry-city and every stone in it"),
    Name("Movement, exact to the last bit"),
    Name("Pictures, sounds and music"),
    Name("All of it was made for this game."),
    Gap,
    Part("Letters"),
    Name("Quattrocento and Cabin, by Pablo Impallari and Igino Marini"),
    Name("SIL Open Font License"),
    Name("DejaVu Sans, by the DejaVu fonts team"),
    Gap,
    Part("Built with"),
    Name("Rust, and the work of many in its crates"),
    Name("SDL, OpenGL, glow, Dear ImGui"),
    Name("glam, serde, RON, gltf, robust, xxHash, lexopt"),
    Name("fontdue, png, kira, Symphonia, rtrb"),
    Name("Their licences are in THIRD-PARTY.txt of a release."),
    Gap,
    Part("Standing on"),
    Name("Guibas and Stolfi, for the edges"),
    Name("Delaunay, for the triangles"),
    Name("Minkowski, for the sums"),
    Name("Hobby, for the rounding"),
    Gap,
    Part("Thank you"),
    Name("for carrying the lantern this far."),
];
