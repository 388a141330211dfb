//! The pass that shows a page: one draw call.

use super::atlas::SIDE;
use super::page::Text;
use crate::shell::render::RenderError;
use crate::shell::render::gl::{Geometry, Gl, Owned, Program};
use crate::shell::render::program::{self, Library};
use crate::shell::render::state::{Blend, Cull, Depth, Format, Spec, Texels};
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Layout of a page's vertices: places on the screen and in the picture, and the colour.
const VERTEX: [Format; 2] = [Format::F4, Format::Unorm4];

/// What shows pages in one OpenGL context.
pub struct Pass {
    program: Program,
    geometry: Geometry,
    letters: Owned,
    shader_dir: PathBuf,
    gl: Gl,
}

impl Pass {
    /// Compiles the shaders of a directory and makes the buffers.
    ///
    /// # Errors
    /// A shader file is missing or wrong, or OpenGL is out of memory.
    pub fn new(ctx: Rc<glow::Context>, shader_dir: &Path) -> Result<Pass, RenderError> {
        let gl = Gl::new(ctx);
        let spec = Spec {
            size: (SIDE as u32, SIDE as u32),
            texels: Texels::Coverage,
            samples: 0,
        };
        let smooth = [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER];
        Ok(Pass {
            program: load(&gl, shader_dir)?,
            geometry: gl.geometry(&VERTEX, false)?,
            letters: gl.texture(&spec, &smooth.map(|name| (name, glow::LINEAR)))?,
            shader_dir: shader_dir.to_path_buf(),
            gl,
        })
    }

    /// Reads the shaders again.
    ///
    /// # Errors
    /// Names file and line of the first error; the program stays as it was.
    pub fn reload_shaders(&mut self) -> Result<(), RenderError> {
        self.program = load(&self.gl, &self.shader_dir)?;
        Ok(())
    }

    /// Draws a page over what is in the framebuffer that is bound.
    pub fn draw(&mut self, text: &mut Text) {
        if text.quads() == 0 {
            return;
        }
        let [width, height] = text.size();
        self.gl.reset();
        self.gl.viewport(width as u32, height as u32);
        self.gl.state(Depth::Off, Blend::Over, Cull::Off);
        if let Some((rows, texels)) = text.atlas().take_changes() {
            let (side, first) = (SIDE as u32, rows.start as u32);
            self.gl.write_rows(&self.letters, side, first, texels);
        }
        self.gl.read_from(0, &self.letters);
        self.geometry.upload(text.words());
        self.gl
            .triangles(&self.program, &self.geometry, 0..usize::MAX);
    }
}

fn load(gl: &Gl, dir: &Path) -> Result<Program, RenderError> {
    let defines = "";
    program::load(gl, &Library { dir, defines }, "text", "text")
}
