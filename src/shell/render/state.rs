//! Plain values that [`super::gl`] speaks in: formats of vertices, how fragments are written, errors of compilers; and
//! the state that passes set by them.

use super::gl::Gl;

/// Texture units that passes read from.
const UNITS: u32 = 5;

/// One vertex attribute; data are 32-bit words, so each format is a multiple of four bytes.
#[derive(Clone, Copy, Debug)]
pub enum Format {
    /// A float.
    F1,
    /// Three floats.
    F3,
    /// Four floats.
    F4,
    /// Four bytes, 0 to 255 read as 0 to 1.
    Unorm4,
    /// Four signed bytes, -127 to 127 read as -1 to 1.
    Snorm4,
}

impl Format {
    /// How OpenGL reads it: components, type, whether integers are normalized, bytes.
    pub fn parts(self) -> (i32, u32, bool, i32) {
        match self {
            Format::F1 => (1, glow::FLOAT, false, 4),
            Format::F3 => (3, glow::FLOAT, false, 12),
            Format::F4 => (4, glow::FLOAT, false, 16),
            Format::Unorm4 => (4, glow::UNSIGNED_BYTE, true, 4),
            Format::Snorm4 => (4, glow::BYTE, true, 4),
        }
    }
}

/// What a texture or a buffer is to be like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spec {
    /// Width and height in texels.
    pub size: (u32, u32),
    /// What a texel holds.
    pub texels: Texels,
    /// Samples a pixel; 0 for one that shaders can read.
    pub samples: u32,
}

/// What a texel holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Texels {
    /// A depth, which is read by comparison with linear filtering.
    Depth,
    /// Linear light, also brighter than white.
    Light,
    /// A colour as on the screen.
    Screen,
    /// How much of it is covered, one byte.
    Coverage,
}

impl Texels {
    /// As OpenGL has it: its format inside, and the format and type of data for it.
    pub fn format(self) -> (u32, u32, u32) {
        match self {
            Texels::Depth => (
                glow::DEPTH_COMPONENT24,
                glow::DEPTH_COMPONENT,
                glow::UNSIGNED_INT,
            ),
            Texels::Light => (glow::RGBA16F, glow::RGBA, glow::FLOAT),
            Texels::Screen => (glow::RGBA8, glow::RGBA, glow::UNSIGNED_BYTE),
            Texels::Coverage => (glow::R8, glow::RED, glow::UNSIGNED_BYTE),
        }
    }

    /// Which part of a framebuffer it is.
    pub fn attachment(self) -> u32 {
        match self {
            Texels::Depth => glow::DEPTH_ATTACHMENT,
            Texels::Light | Texels::Screen | Texels::Coverage => glow::COLOR_ATTACHMENT0,
        }
    }

    /// Which buffer colours go to; none if it has no colours.
    pub fn buffer(self) -> u32 {
        match self {
            Texels::Depth => glow::NONE,
            Texels::Light | Texels::Screen | Texels::Coverage => glow::COLOR_ATTACHMENT0,
        }
    }
}

/// What was asked of OpenGL.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Work {
    /// Calls of its functions.
    pub calls: u32,
    /// Those that draw.
    pub draws: u32,
    /// Triangles that were drawn.
    pub triangles: usize,
}

impl Work {
    /// With more calls, and perhaps a draw of so many triangles among them.
    pub fn with(self, calls: u32, triangles: Option<usize>) -> Work {
        Work {
            calls: self.calls + calls,
            draws: self.draws + u32::from(triangles.is_some()),
            triangles: self.triangles + triangles.unwrap_or(0),
        }
    }
}

/// How the depth buffer takes part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Depth {
    /// Not at all.
    Off,
    /// Hidden fragments are dropped; nothing is written.
    Test,
    /// Hidden fragments are dropped; the others are written.
    Write,
}

/// How a fragment meets the colour below it. Sources are premultiplied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blend {
    /// Replaces it.
    Off,
    /// Covers it by its alpha; with alpha 0 it only adds light.
    Over,
}

/// Faces that are dropped; front faces run counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cull {
    /// None.
    Off,
    /// Those that look away.
    Back,
}

impl Gl {
    /// Sets all state that the passes rely on, whatever others left behind.
    pub fn reset(&self) {
        use glow::{FRAMEBUFFER_SRGB, POLYGON_OFFSET_FILL, PRIMITIVE_RESTART};
        for name in [FRAMEBUFFER_SRGB, POLYGON_OFFSET_FILL, PRIMITIVE_RESTART] {
            self.switch(name, false);
        }
        self.switch(glow::SCISSOR_TEST, false);
        self.switch(glow::STENCIL_TEST, false);
        self.switch(glow::MULTISAMPLE, true);
        self.set_defaults(UNITS);
    }

    /// How the next draws meet what is there.
    pub fn state(&self, depth: Depth, blend: Blend, cull: Cull) {
        self.switch(glow::DEPTH_TEST, depth != Depth::Off);
        self.switch(glow::BLEND, blend == Blend::Over);
        self.switch(glow::CULL_FACE, cull == Cull::Back);
        self.keep_depth(depth == Depth::Write);
    }
}

/// What went wrong between source text and program.
pub struct CompileError {
    /// Whether the vertex shader is meant, the fragment shader, or neither (linking).
    pub stage: Option<Stage>,
    /// The driver's words.
    pub log: String,
}

/// A stage of the pipeline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stage {
    /// Once per vertex.
    Vertex,
    /// Once per fragment.
    Fragment,
}

impl Stage {
    /// As OpenGL names it.
    pub fn kind(self) -> u32 {
        match self {
            Stage::Vertex => glow::VERTEX_SHADER,
            Stage::Fragment => glow::FRAGMENT_SHADER,
        }
    }
}
