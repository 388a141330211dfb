//! Lines and triangles that are drawn over the scene for developers.

use super::frame::{Line, Tri};
use super::gl::{Geometry, Gl};
use super::model::pack;
use super::state::Format;

/// Layout of a line: one instance.
const LINE: [Format; 4] = [Format::F3, Format::F3, Format::Unorm4, Format::F1];
/// Layout of a triangle's corner.
const CORNER: [Format; 2] = [Format::F3, Format::Unorm4];

/// The buffers for them.
pub struct Debug {
    /// One instance for each line.
    pub lines: Geometry,
    /// Three vertices for each triangle.
    pub tris: Geometry,
}

impl Debug {
    /// Empty buffers.
    pub fn new(gl: &Gl) -> Result<Debug, String> {
        Ok(Debug {
            lines: gl.geometry(&LINE, true)?,
            tris: gl.geometry(&CORNER, false)?,
        })
    }

    /// Replaces what they hold; `words` is room to work in.
    pub fn upload(&mut self, lines: &[Line], tris: &[Tri], words: &mut Vec<u32>) {
        words.clear();
        for line in lines {
            words.extend(line.a.to_array().map(f32::to_bits));
            words.extend(line.b.to_array().map(f32::to_bits));
            words.extend([pack(line.colour), line.width.to_bits()]);
        }
        self.lines.upload(words);
        words.clear();
        for tri in tris {
            for corner in tri.corners {
                words.extend(corner.to_array().map(f32::to_bits));
                words.push(pack(tri.colour));
            }
        }
        self.tris.upload(words);
    }
}
