//! OpenGL 3.3 behind safe functions: the only file of the crate with unsafe code.
//!
//! Every call goes to the context that made the objects, so names cannot be mixed up. Memory is safe because all data
//! crosses as checked slices, draws stay inside the vertices that were uploaded, and uniform buffers are as large as the
//! smallest block limit that OpenGL guarantees. The context must be current on the calling thread; it is never sent away.
#![allow(unsafe_code)]

use super::state::{Blend, CompileError, Cull, Depth, Format, Stage};
use glow::HasContext;
use std::ops::Range;
use std::rc::Rc;

/// Bytes of every uniform buffer: the block size that each OpenGL 3.3 allows.
const BLOCK_BYTES: usize = 16384;

/// An OpenGL context.
#[derive(Clone)]
pub struct Gl {
    ctx: Rc<glow::Context>,
}

/// A linked program.
pub struct Program {
    ctx: Rc<glow::Context>,
    raw: glow::Program,
}

/// Vertices (or instances) on the GPU, with their layout.
pub struct Geometry {
    ctx: Rc<glow::Context>,
    array: glow::VertexArray,
    buffer: glow::Buffer,
    stride: usize,
    capacity: usize,
    count: usize,
}

/// A block of uniforms, bound for good to its binding point.
pub struct Uniforms {
    ctx: Rc<glow::Context>,
    buffer: glow::Buffer,
}

/// A square depth texture that can be drawn into and compared with.
pub struct DepthTarget {
    ctx: Rc<glow::Context>,
    texture: glow::Texture,
    framebuffer: glow::Framebuffer,
    size: i32,
}

/// A framebuffer that was bound by somebody else; `None` is the window.
#[derive(Clone, Copy)]
pub struct Target(Option<glow::Framebuffer>);

/// The words as bytes, in the order of this machine.
fn bytes(words: &[u32]) -> &[u8] {
    // SAFETY: u8 has no alignment and no invalid values; the length in bytes is that of the slice.
    unsafe { std::slice::from_raw_parts(words.as_ptr().cast(), size_of_val(words)) }
}

/// Looks up OpenGL's functions by name in the context that is current on this thread.
pub fn load(find: impl FnMut(&str) -> *const std::ffi::c_void) -> glow::Context {
    // SAFETY: the names are OpenGL's own, and SDL's look-up gives the driver's function for each, or null, which is
    // never called.
    unsafe { glow::Context::from_loader_function(find) }
}

impl Gl {
    /// Wraps a context that is current on this thread.
    pub fn new(ctx: Rc<glow::Context>) -> Self {
        Gl { ctx }
    }

    /// Major and minor version of the context.
    pub fn version(&self) -> (u32, u32) {
        let version = self.ctx.version();
        (version.major, version.minor)
    }

    /// The first error since the last call, as OpenGL's number.
    pub fn take_error(&self) -> Option<u32> {
        // SAFETY: no memory is involved.
        let code = unsafe { self.ctx.get_error() };
        (code != glow::NO_ERROR).then_some(code)
    }

    /// Compiles and links a program; its uniform blocks are bound to the points of `blocks`, by position.
    pub fn program(
        &self,
        vertex: &str,
        fragment: &str,
        blocks: &[&str],
    ) -> Result<Program, CompileError> {
        let gl = &self.ctx;
        let linking = |log| CompileError { stage: None, log };
        // SAFETY: only names made here are used, and each is deleted once (the program by its Drop).
        unsafe {
            let vertex = self.shader(glow::VERTEX_SHADER, Stage::Vertex, vertex)?;
            let fragment = self
                .shader(glow::FRAGMENT_SHADER, Stage::Fragment, fragment)
                .inspect_err(|_| gl.delete_shader(vertex))?;
            let raw = gl.create_program().map_err(linking)?;
            let program = Program {
                ctx: self.ctx.clone(),
                raw,
            };
            for shader in [vertex, fragment] {
                gl.attach_shader(raw, shader);
            }
            gl.link_program(raw);
            for shader in [vertex, fragment] {
                gl.detach_shader(raw, shader);
                gl.delete_shader(shader);
            }
            if !gl.get_program_link_status(raw) {
                return Err(linking(gl.get_program_info_log(raw)));
            }
            for (point, name) in blocks.iter().enumerate() {
                if let Some(index) = gl.get_uniform_block_index(raw, name) {
                    gl.uniform_block_binding(raw, index, point as u32);
                }
            }
            Ok(program)
        }
    }

    /// Compiles one stage.
    fn shader(&self, kind: u32, stage: Stage, source: &str) -> Result<glow::Shader, CompileError> {
        let gl = &self.ctx;
        let failed = |log| CompileError {
            stage: Some(stage),
            log,
        };
        // SAFETY: the name is made here and deleted here or handed out.
        unsafe {
            let shader = gl.create_shader(kind).map_err(failed)?;
            gl.shader_source(shader, source);
            gl.compile_shader(shader);
            if gl.get_shader_compile_status(shader) {
                return Ok(shader);
            }
            let log = gl.get_shader_info_log(shader);
            gl.delete_shader(shader);
            Err(failed(log))
        }
    }

    /// Empty geometry; `per_instance` advances its attributes once per instance instead of once per vertex.
    pub fn geometry(&self, layout: &[Format], per_instance: bool) -> Result<Geometry, String> {
        let gl = &self.ctx;
        let stride: i32 = layout.iter().map(|format| format.parts().3).sum();
        // SAFETY: offsets stay below the stride; the names belong to the Geometry, which deletes them.
        unsafe {
            let array = gl.create_vertex_array()?;
            let buffer = gl
                .create_buffer()
                .inspect_err(|_| gl.delete_vertex_array(array))?;
            gl.bind_vertex_array(Some(array));
            gl.bind_buffer(glow::ARRAY_BUFFER, Some(buffer));
            let mut offset = 0;
            for (index, format) in (0..).zip(layout) {
                let (components, kind, normalized, size) = format.parts();
                gl.enable_vertex_attrib_array(index);
                gl.vertex_attrib_pointer_f32(index, components, kind, normalized, stride, offset);
                gl.vertex_attrib_divisor(index, u32::from(per_instance));
                offset += size;
            }
            gl.bind_vertex_array(None);
            Ok(Geometry {
                ctx: self.ctx.clone(),
                array,
                buffer,
                stride: stride as usize,
                capacity: 0,
                count: 0,
            })
        }
    }

    /// A uniform block at a binding point.
    pub fn uniforms(&self, point: u32) -> Result<Uniforms, String> {
        let gl = &self.ctx;
        // SAFETY: the buffer has BLOCK_BYTES bytes before anything reads it.
        unsafe {
            let buffer = gl.create_buffer()?;
            gl.bind_buffer(glow::UNIFORM_BUFFER, Some(buffer));
            gl.buffer_data_size(glow::UNIFORM_BUFFER, BLOCK_BYTES as i32, glow::DYNAMIC_DRAW);
            gl.bind_buffer_base(glow::UNIFORM_BUFFER, point, Some(buffer));
            Ok(Uniforms {
                ctx: self.ctx.clone(),
                buffer,
            })
        }
    }

    /// A depth texture of `size` by `size` texels, read by comparison with linear filtering.
    pub fn depth_target(&self, size: u32) -> Result<DepthTarget, String> {
        let gl = &self.ctx;
        use glow::{DEPTH_ATTACHMENT, FRAMEBUFFER, FRAMEBUFFER_COMPLETE, NONE, TEXTURE_2D};
        let size = size as i32;
        let bound = self.target();
        let texture = self.depth_texture(size)?;
        // SAFETY: the names belong to the DepthTarget, which deletes them.
        let (target, status) = unsafe {
            let framebuffer = gl.create_framebuffer();
            let framebuffer = framebuffer.inspect_err(|_| gl.delete_texture(texture))?;
            let ctx = self.ctx.clone();
            let target = DepthTarget {
                ctx,
                texture,
                framebuffer,
                size,
            };
            gl.bind_framebuffer(FRAMEBUFFER, Some(framebuffer));
            gl.framebuffer_texture_2d(FRAMEBUFFER, DEPTH_ATTACHMENT, TEXTURE_2D, Some(texture), 0);
            gl.draw_buffer(NONE);
            gl.read_buffer(NONE);
            (target, gl.check_framebuffer_status(FRAMEBUFFER))
        };
        self.bind(bound);
        match status {
            FRAMEBUFFER_COMPLETE => Ok(target),
            _ => Err(format!("framebuffer status {status:#x}")),
        }
    }

    /// An empty depth texture for comparison.
    fn depth_texture(&self, size: i32) -> Result<glow::Texture, String> {
        let gl = &self.ctx;
        use glow::{
            CLAMP_TO_EDGE, COMPARE_REF_TO_TEXTURE, LEQUAL, LINEAR, TEXTURE_2D, UNSIGNED_INT,
        };
        let parameters = [
            (glow::TEXTURE_MIN_FILTER, LINEAR),
            (glow::TEXTURE_MAG_FILTER, LINEAR),
            (glow::TEXTURE_WRAP_S, CLAMP_TO_EDGE),
            (glow::TEXTURE_WRAP_T, CLAMP_TO_EDGE),
            (glow::TEXTURE_COMPARE_MODE, COMPARE_REF_TO_TEXTURE),
            (glow::TEXTURE_COMPARE_FUNC, LEQUAL),
        ];
        let (inner, outer) = (glow::DEPTH_COMPONENT24 as i32, glow::DEPTH_COMPONENT);
        // SAFETY: no client memory is passed; the caller owns the name.
        unsafe {
            let texture = gl.create_texture()?;
            gl.bind_texture(TEXTURE_2D, Some(texture));
            gl.tex_image_2d(
                TEXTURE_2D,
                0,
                inner,
                size,
                size,
                0,
                outer,
                UNSIGNED_INT,
                None,
            );
            for (name, value) in parameters {
                gl.tex_parameter_i32(TEXTURE_2D, name, value as i32);
            }
            Ok(texture)
        }
    }

    /// The framebuffer that is bound for drawing.
    pub fn target(&self) -> Target {
        // SAFETY: a query of state.
        Target(unsafe {
            self.ctx
                .get_parameter_framebuffer(glow::DRAW_FRAMEBUFFER_BINDING)
        })
    }

    /// Binds a framebuffer that [`Gl::target`] named.
    pub fn bind(&self, target: Target) {
        // SAFETY: an unknown name is an OpenGL error, not a memory error.
        unsafe { self.ctx.bind_framebuffer(glow::FRAMEBUFFER, target.0) }
    }

    /// Sets all state that the passes rely on, whatever others left behind.
    pub fn reset(&self) {
        let gl = &self.ctx;
        use glow::{
            BLEND, FRAMEBUFFER_SRGB, POLYGON_OFFSET_FILL, PRIMITIVE_RESTART, SCISSOR_TEST,
            STENCIL_TEST,
        };
        // SAFETY: switches of state; no memory is involved.
        unsafe {
            for switch in [
                BLEND,
                FRAMEBUFFER_SRGB,
                POLYGON_OFFSET_FILL,
                PRIMITIVE_RESTART,
                SCISSOR_TEST,
                STENCIL_TEST,
            ] {
                gl.disable(switch);
            }
            gl.enable(glow::MULTISAMPLE);
            gl.polygon_mode(glow::FRONT_AND_BACK, glow::FILL);
            gl.color_mask(true, true, true, true);
            gl.front_face(glow::CCW);
            gl.cull_face(glow::BACK);
            gl.depth_func(glow::LEQUAL);
            gl.blend_equation(glow::FUNC_ADD);
            gl.blend_func(glow::ONE, glow::ONE_MINUS_SRC_ALPHA);
            gl.active_texture(glow::TEXTURE0);
            gl.bind_sampler(0, None);
        }
    }

    /// How the next draws meet what is there.
    pub fn state(&self, depth: Depth, blend: Blend, cull: Cull) {
        let gl = &self.ctx;
        let switch = |name, on| {
            // SAFETY: a switch of state.
            unsafe {
                if on {
                    gl.enable(name)
                } else {
                    gl.disable(name)
                }
            }
        };
        switch(glow::DEPTH_TEST, depth != Depth::Off);
        switch(glow::BLEND, blend == Blend::Over);
        switch(glow::CULL_FACE, cull == Cull::Back);
        // SAFETY: as above.
        unsafe { gl.depth_mask(depth == Depth::Write) }
    }

    /// Draws into this part of the target and clears its depth; its colour is left to the passes.
    pub fn viewport(&self, width: u32, height: u32) {
        let gl = &self.ctx;
        let clamp = |side: u32| side.min(i32::MAX as u32) as i32;
        // SAFETY: OpenGL clamps the size to what it can do.
        unsafe {
            gl.viewport(0, 0, clamp(width), clamp(height));
            gl.depth_mask(true);
            gl.clear(glow::DEPTH_BUFFER_BIT);
        }
    }

    /// Fills the target with one colour, as it shall appear.
    pub fn fill(&self, [r, g, b]: [f32; 3]) {
        // SAFETY: no memory is involved.
        unsafe {
            self.ctx.clear_color(r, g, b, 1.0);
            self.ctx.clear(glow::COLOR_BUFFER_BIT);
        }
    }

    /// Draws triangles of per-vertex geometry; the range is cut to what there is.
    pub fn triangles(&self, program: &Program, geometry: &Geometry, range: Range<usize>) {
        let gl = &self.ctx;
        let end = range.end.min(geometry.count);
        let count = end.saturating_sub(range.start);
        // SAFETY: the range lies within the uploaded vertices.
        unsafe {
            gl.use_program(Some(program.raw));
            gl.bind_vertex_array(Some(geometry.array));
            gl.draw_arrays(glow::TRIANGLES, range.start as i32, count as i32);
        }
    }

    /// Draws all instances, each of `vertices` corners that the shader makes from `gl_VertexID`.
    pub fn instances(&self, program: &Program, geometry: &Geometry, vertices: u32) {
        let gl = &self.ctx;
        // SAFETY: attributes advance per instance and there are `count` of them.
        unsafe {
            gl.use_program(Some(program.raw));
            gl.bind_vertex_array(Some(geometry.array));
            gl.draw_arrays_instanced(glow::TRIANGLES, 0, vertices as i32, geometry.count as i32);
        }
    }

    /// The lower left `width` by `height` pixels of the bound framebuffer: RGB, rows from the bottom up.
    pub fn read_pixels(&self, width: u32, height: u32) -> Vec<u8> {
        let gl = &self.ctx;
        let row = width as usize * 3;
        let mut pixels = vec![0; row * height as usize];
        if pixels.is_empty() {
            return pixels;
        }
        // SAFETY: with a pack alignment of 1 exactly `row * height` bytes are written.
        unsafe {
            gl.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
            gl.pixel_store_i32(glow::PACK_ALIGNMENT, 1);
            gl.pixel_store_i32(glow::PACK_ROW_LENGTH, 0);
            let into = glow::PixelPackData::Slice(&mut pixels);
            gl.read_pixels(
                0,
                0,
                width as i32,
                height as i32,
                glow::RGB,
                glow::UNSIGNED_BYTE,
                into,
            );
        }
        pixels
    }
}

impl Geometry {
    /// Replaces all vertices; the buffer grows when it must and never shrinks.
    pub fn upload(&mut self, words: &[u32]) {
        let gl = &self.ctx;
        let data = bytes(words);
        self.count = data.len() / self.stride;
        // SAFETY: the sub-range that is written lies within the buffer, whose size is `capacity`.
        unsafe {
            gl.bind_buffer(glow::ARRAY_BUFFER, Some(self.buffer));
            if data.len() > self.capacity {
                self.capacity = data.len().next_power_of_two();
                gl.buffer_data_size(glow::ARRAY_BUFFER, self.capacity as i32, glow::DYNAMIC_DRAW);
            }
            gl.buffer_sub_data_u8_slice(glow::ARRAY_BUFFER, 0, data);
        }
    }
}

impl Uniforms {
    /// Replaces the start of the block.
    pub fn upload(&self, words: &[u32]) {
        let data = bytes(words);
        assert!(
            data.len() <= BLOCK_BYTES,
            "a uniform block of {} bytes",
            data.len()
        );
        // SAFETY: the buffer has BLOCK_BYTES bytes.
        unsafe {
            self.ctx
                .bind_buffer(glow::UNIFORM_BUFFER, Some(self.buffer));
            self.ctx
                .buffer_sub_data_u8_slice(glow::UNIFORM_BUFFER, 0, data);
        }
    }
}

impl DepthTarget {
    /// Makes it the target and clears it.
    pub fn draw_into(&self, gl: &Gl) {
        // SAFETY: the framebuffer is complete.
        unsafe {
            self.ctx
                .bind_framebuffer(glow::FRAMEBUFFER, Some(self.framebuffer))
        }
        gl.viewport(self.size as u32, self.size as u32);
    }

    /// Lets shaders read it, at texture unit 0.
    pub fn read_from(&self) {
        // SAFETY: the texture lives as long as self; no program reads it while it is the target.
        unsafe { self.ctx.bind_texture(glow::TEXTURE_2D, Some(self.texture)) }
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        // SAFETY: the name is ours and used nowhere else.
        unsafe { self.ctx.delete_program(self.raw) }
    }
}

impl Drop for Geometry {
    fn drop(&mut self) {
        // SAFETY: the names are ours and used nowhere else.
        unsafe {
            self.ctx.delete_vertex_array(self.array);
            self.ctx.delete_buffer(self.buffer);
        }
    }
}

impl Drop for Uniforms {
    fn drop(&mut self) {
        // SAFETY: as above.
        unsafe { self.ctx.delete_buffer(self.buffer) }
    }
}

impl Drop for DepthTarget {
    fn drop(&mut self) {
        // SAFETY: as above.
        unsafe {
            self.ctx.delete_framebuffer(self.framebuffer);
            self.ctx.delete_texture(self.texture);
        }
    }
}
