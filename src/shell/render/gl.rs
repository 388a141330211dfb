//! OpenGL 3.3 behind safe functions: this file and its folder are all of the crate that has unsafe code.
//!
//! Every call goes to the context that made the objects, so names cannot be mixed up. Memory is safe because all data
//! crosses as checked slices, draws stay inside the vertices that were uploaded, and uniform buffers are as large as the
//! smallest block limit that OpenGL guarantees. The context must be current on the calling thread; it is never sent away.
#![allow(unsafe_code)]

pub mod crowd;
mod pixels;

use super::state::{CompileError, Format, Spec, Stage, Texels, Work};
use glow::HasContext;
use std::cell::Cell;
use std::ops::Range;
use std::rc::Rc;

/// Bytes of every uniform buffer: the block size that each OpenGL 3.3 allows.
const BLOCK_BYTES: usize = 16384;

/// An OpenGL context.
#[derive(Clone)]
pub struct Gl {
    ctx: Rc<glow::Context>,
    /// What was asked of OpenGL.
    pub work: Rc<Cell<Work>>,
}

/// An object of OpenGL, deleted when this is dropped.
pub struct Owned {
    ctx: Rc<glow::Context>,
    name: Name,
}

/// The name of an object.
#[derive(Clone, Copy)]
enum Name {
    Shader(glow::Shader),
    Program(glow::Program),
    Array(glow::VertexArray),
    Buffer(glow::Buffer),
    Texture(glow::Texture),
    Renderbuffer(glow::Renderbuffer),
    Framebuffer(glow::Framebuffer),
}

/// A linked program.
pub struct Program {
    raw: glow::Program,
    _owned: Owned,
}

/// Vertices (or instances) on the GPU, with their layout.
pub struct Geometry {
    gl: Gl,
    array: glow::VertexArray,
    buffer: glow::Buffer,
    stride: usize,
    capacity: usize,
    count: usize,
    _owned: [Owned; 2],
}

/// A block of uniforms, bound for good to its binding point.
pub struct Uniforms {
    gl: Gl,
    buffer: glow::Buffer,
    _owned: Owned,
}

/// A framebuffer to draw into; `None` is the window.
#[derive(Clone, Copy)]
pub struct Bound(Option<glow::Framebuffer>);

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
        let work = Rc::default();
        Gl { ctx, work }
    }

    /// Notes calls, and the triangles of a draw.
    fn note(&self, calls: u32, triangles: Option<usize>) {
        self.work.set(self.work.get().with(calls, triangles));
    }

    /// Waits until all is drawn.
    pub fn finish(&self) {
        // SAFETY: no memory is involved.
        unsafe { self.ctx.finish() }
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

    /// Compiles and links a program; its uniform blocks are bound to the points of `blocks`, its samplers to the texture
    /// units of `samplers`, both by position.
    pub fn program(
        &self,
        vertex: &str,
        fragment: &str,
        (blocks, samplers): (&[&str], &[&str]),
    ) -> Result<Program, CompileError> {
        let gl = &self.ctx;
        let linking = |log| CompileError { stage: None, log };
        let vertex = self.shader(Stage::Vertex, vertex)?;
        let fragment = self.shader(Stage::Fragment, fragment)?;
        // SAFETY: only live names are used.
        unsafe {
            let raw = gl.create_program().map_err(linking)?;
            let _owned = self.own(Name::Program(raw));
            gl.attach_shader(raw, vertex.0);
            gl.attach_shader(raw, fragment.0);
            gl.link_program(raw);
            if !gl.get_program_link_status(raw) {
                return Err(linking(gl.get_program_info_log(raw)));
            }
            for (point, name) in (0..).zip(blocks) {
                if let Some(index) = gl.get_uniform_block_index(raw, name) {
                    gl.uniform_block_binding(raw, index, point);
                }
            }
            gl.use_program(Some(raw));
            for (unit, name) in (0..).zip(samplers) {
                let place = gl.get_uniform_location(raw, name);
                gl.uniform_1_i32(place.as_ref(), unit);
            }
            Ok(Program { raw, _owned })
        }
    }

    /// Compiles one stage.
    fn shader(&self, stage: Stage, source: &str) -> Result<(glow::Shader, Owned), CompileError> {
        let (gl, kind) = (&self.ctx, stage.kind());
        let stage = Some(stage);
        // SAFETY: only live names are used.
        unsafe {
            let raw = gl
                .create_shader(kind)
                .map_err(|log| CompileError { stage, log })?;
            let owned = self.own(Name::Shader(raw));
            gl.shader_source(raw, source);
            gl.compile_shader(raw);
            match gl.get_shader_compile_status(raw) {
                true => Ok((raw, owned)),
                false => Err(CompileError {
                    stage,
                    log: gl.get_shader_info_log(raw),
                }),
            }
        }
    }

    /// Empty geometry; `per_instance` advances its attributes once per instance, not once per vertex.
    pub fn geometry(&self, layout: &[Format], per_instance: bool) -> Result<Geometry, String> {
        let gl = &self.ctx;
        let stride: i32 = layout.iter().map(|format| format.parts().3).sum();
        // SAFETY: offsets stay below the stride; the names belong to the Geometry, which deletes them.
        unsafe {
            let array = gl.create_vertex_array()?;
            let array_owner = self.own(Name::Array(array));
            let buffer = gl.create_buffer()?;
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
                gl: self.clone(),
                array,
                buffer,
                stride: stride as usize,
                capacity: 0,
                count: 0,
                _owned: [array_owner, self.own(Name::Buffer(buffer))],
            })
        }
    }

    /// A uniform block at a binding point.
    pub fn uniforms(&self, point: u32) -> Result<Uniforms, String> {
        let (gl, ctx) = (self.clone(), &self.ctx);
        // SAFETY: the buffer has BLOCK_BYTES bytes before anything reads it.
        unsafe {
            let buffer = ctx.create_buffer()?;
            let _owned = self.own(Name::Buffer(buffer));
            let uniforms = Uniforms { gl, buffer, _owned };
            uniforms.upload(&[]);
            ctx.bind_buffer_base(glow::UNIFORM_BUFFER, point, Some(buffer));
            Ok(uniforms)
        }
    }

    /// An empty texture with these parameters.
    pub fn texture(&self, spec: &Spec, parameters: &[(u32, u32)]) -> Result<Owned, String> {
        let (gl, kind) = (&self.ctx, glow::TEXTURE_2D);
        let (inner, outer, data) = spec.texels.format();
        let (width, height, inner) = (spec.size.0 as i32, spec.size.1 as i32, inner as i32);
        // SAFETY: no client memory is passed.
        unsafe {
            let raw = gl.create_texture()?;
            gl.bind_texture(kind, Some(raw));
            gl.tex_image_2d(kind, 0, inner, width, height, 0, outer, data, None);
            for &(name, value) in parameters {
                gl.tex_parameter_i32(kind, name, value as i32);
            }
            Ok(self.own(Name::Texture(raw)))
        }
    }

    /// An empty buffer that is drawn into and never read by shaders.
    pub fn renderbuffer(&self, spec: &Spec) -> Result<Owned, String> {
        let gl = &self.ctx;
        let (width, height) = (spec.size.0 as i32, spec.size.1 as i32);
        let (kind, samples) = (glow::RENDERBUFFER, spec.samples as i32);
        let (format, _, _) = spec.texels.format();
        // SAFETY: no client memory is passed.
        unsafe {
            let raw = gl.create_renderbuffer()?;
            let owned = self.own(Name::Renderbuffer(raw));
            gl.bind_renderbuffer(kind, Some(raw));
            gl.renderbuffer_storage_multisample(kind, samples, format, width, height);
            Ok(owned)
        }
    }

    /// A framebuffer of a picture, a depth buffer, or both in this order. It stays bound.
    pub fn framebuffer(&self, parts: &[(Texels, &Owned)]) -> Result<Owned, String> {
        let gl = &self.ctx;
        use glow::{FRAMEBUFFER, RENDERBUFFER, TEXTURE_2D};
        let buffer = parts[0].0.buffer();
        // SAFETY: all names are live; an incomplete framebuffer is an error that is told.
        unsafe {
            let raw = gl.create_framebuffer()?;
            let owned = self.own(Name::Framebuffer(raw));
            gl.bind_framebuffer(FRAMEBUFFER, Some(raw));
            let all = FRAMEBUFFER;
            gl.draw_buffer(buffer);
            gl.read_buffer(buffer);
            for (texels, part) in parts {
                let at = texels.attachment();
                match part.name {
                    Name::Texture(t) => gl.framebuffer_texture_2d(all, at, TEXTURE_2D, Some(t), 0),
                    Name::Renderbuffer(r) => {
                        gl.framebuffer_renderbuffer(all, at, RENDERBUFFER, Some(r))
                    }
                    _ => {} // leaves the framebuffer incomplete
                }
            }
            match gl.check_framebuffer_status(FRAMEBUFFER) {
                glow::FRAMEBUFFER_COMPLETE => Ok(owned),
                status => Err(format!("framebuffer status {status:#x}")),
            }
        }
    }

    /// The largest side of a texture that the driver allows.
    pub fn largest_side(&self) -> u32 {
        // SAFETY: a query of state.
        unsafe { self.ctx.get_parameter_i32(glow::MAX_TEXTURE_SIZE) }.max(1) as u32
    }

    /// Lets shaders read a texture, at a texture unit.
    pub fn read_from(&self, unit: u32, texture: &Owned) {
        let Name::Texture(raw) = texture.name else {
            return;
        };
        let gl = &self.ctx;
        self.note(3, None);
        // SAFETY: no program reads it while it is the target.
        unsafe {
            gl.active_texture(glow::TEXTURE0 + unit);
            gl.bind_texture(glow::TEXTURE_2D, Some(raw));
            gl.active_texture(glow::TEXTURE0);
        }
    }

    /// Copies a picture to another of the same size; of several samples a pixel, the mean.
    pub fn copy(&self, from: Bound, to: Bound, (width, height): (u32, u32)) {
        let (gl, w, h) = (&self.ctx, width as i32, height as i32);
        let (mask, filter) = (glow::COLOR_BUFFER_BIT, glow::NEAREST);
        self.note(3, None);
        // SAFETY: no client memory is involved.
        unsafe {
            gl.bind_framebuffer(glow::READ_FRAMEBUFFER, from.0);
            gl.bind_framebuffer(glow::DRAW_FRAMEBUFFER, to.0);
            gl.blit_framebuffer(0, 0, w, h, 0, 0, w, h, mask, filter);
        }
    }

    /// The framebuffer that is bound for drawing.
    pub fn bound(&self) -> Bound {
        let name = glow::DRAW_FRAMEBUFFER_BINDING;
        // SAFETY: a query of state.
        Bound(unsafe { self.ctx.get_parameter_framebuffer(name) })
    }

    /// Binds a framebuffer that [`Gl::bound`] named.
    pub fn bind(&self, bound: Bound) {
        self.note(1, None);
        // SAFETY: an unknown name is an OpenGL error, not a memory error.
        unsafe { self.ctx.bind_framebuffer(glow::FRAMEBUFFER, bound.0) }
    }

    /// Puts data at the start of a buffer of so many bytes. It gets new memory, so that nobody waits for draws that read
    /// the old.
    fn refill(&self, (kind, buffer): (u32, glow::Buffer), capacity: usize, words: &[u32]) {
        let (gl, data) = (&self.ctx, bytes(words));
        assert!(data.len() <= capacity, "{} bytes", data.len());
        self.note(3, None);
        // SAFETY: what is written lies within the buffer.
        unsafe {
            gl.bind_buffer(kind, Some(buffer));
            gl.buffer_data_size(kind, capacity as i32, glow::DYNAMIC_DRAW);
            gl.buffer_sub_data_u8_slice(kind, 0, data);
        }
    }

    /// Will delete an object.
    fn own(&self, name: Name) -> Owned {
        let ctx = self.ctx.clone();
        Owned { ctx, name }
    }

    /// Sets what no pass changes, whatever others left behind.
    pub fn set_defaults(&self, units: u32) {
        let gl = &self.ctx;
        self.note(8 + units, None);
        // SAFETY: state; no memory is involved.
        unsafe {
            gl.polygon_mode(glow::FRONT_AND_BACK, glow::FILL);
            gl.color_mask(true, true, true, true);
            gl.front_face(glow::CCW);
            gl.cull_face(glow::BACK);
            gl.depth_func(glow::LEQUAL);
            gl.blend_equation(glow::FUNC_ADD);
            gl.blend_func(glow::ONE, glow::ONE_MINUS_SRC_ALPHA);
            gl.active_texture(glow::TEXTURE0);
            (0..units).for_each(|unit| gl.bind_sampler(unit, None));
        }
    }

    /// Turns something on or off.
    pub fn switch(&self, name: u32, on: bool) {
        self.note(1, None);
        // SAFETY: state; an unknown name is an OpenGL error.
        match on {
            true => unsafe { self.ctx.enable(name) },
            false => unsafe { self.ctx.disable(name) },
        }
    }

    /// Whether the depth of what is drawn is kept.
    pub fn keep_depth(&self, keep: bool) {
        self.note(1, None);
        // SAFETY: state.
        unsafe { self.ctx.depth_mask(keep) }
    }

    /// Draws into this part of the target and clears its depth; its colour is left to the passes.
    pub fn viewport(&self, width: u32, height: u32) {
        let gl = &self.ctx;
        let clamp = |side: u32| side.min(i32::MAX as u32) as i32;
        self.note(3, None);
        // SAFETY: OpenGL clamps the size to what it can do.
        unsafe {
            gl.viewport(0, 0, clamp(width), clamp(height));
            gl.depth_mask(true);
            gl.clear(glow::DEPTH_BUFFER_BIT);
        }
    }

    /// Fills the target with one colour, as it shall appear.
    pub fn fill(&self, [r, g, b]: [f32; 3]) {
        let gl = &self.ctx;
        // SAFETY: no memory is involved.
        unsafe {
            gl.clear_color(r, g, b, 1.0);
            gl.clear(glow::COLOR_BUFFER_BIT);
        }
    }

    /// Draws triangles of per-vertex geometry; the range is cut to what there is.
    pub fn triangles(&self, program: &Program, geometry: &Geometry, range: Range<usize>) {
        let count = range.end.min(geometry.count).saturating_sub(range.start);
        self.draw(program, geometry, (range.start, count), 1);
    }

    /// Draws all instances, each of `vertices` corners that the shader makes from `gl_VertexID`.
    pub fn instances(&self, program: &Program, geometry: &Geometry, vertices: u32) {
        self.draw(program, geometry, (0, vertices as usize), geometry.count);
    }

    /// Draws some vertices so many times.
    fn draw(
        &self,
        program: &Program,
        from: &Geometry,
        (first, count): (usize, usize),
        times: usize,
    ) {
        let (gl, kind) = (&self.ctx, glow::TRIANGLES);
        if count == 0 || times == 0 {
            return;
        }
        self.note(3, Some(count / 3 * times));
        // SAFETY: the callers keep vertices, or instances, within those that were uploaded.
        unsafe {
            gl.use_program(Some(program.raw));
            gl.bind_vertex_array(Some(from.array));
            gl.draw_arrays_instanced(kind, first as i32, count as i32, times as i32);
        }
    }
}

impl Geometry {
    /// Replaces all vertices; the buffer grows when it must and never shrinks.
    pub fn upload(&mut self, words: &[u32]) {
        let bytes = size_of_val(words);
        self.count = bytes / self.stride;
        self.capacity = self.capacity.max(bytes.next_power_of_two());
        self.gl
            .refill((glow::ARRAY_BUFFER, self.buffer), self.capacity, words);
    }
}

impl Uniforms {
    /// Replaces the start of the block.
    pub fn upload(&self, words: &[u32]) {
        self.gl
            .refill((glow::UNIFORM_BUFFER, self.buffer), BLOCK_BYTES, words);
    }
}

impl Owned {
    /// A framebuffer, to be bound.
    pub fn target(&self) -> Bound {
        match self.name {
            Name::Framebuffer(name) => Bound(Some(name)),
            _ => Bound(None),
        }
    }
}

impl Drop for Owned {
    fn drop(&mut self) {
        let gl = &self.ctx;
        // SAFETY: the name is ours and used nowhere else.
        unsafe {
            match self.name {
                Name::Shader(name) => gl.delete_shader(name),
                Name::Program(name) => gl.delete_program(name),
                Name::Array(name) => gl.delete_vertex_array(name),
                Name::Buffer(name) => gl.delete_buffer(name),
                Name::Texture(name) => gl.delete_texture(name),
                Name::Renderbuffer(name) => gl.delete_renderbuffer(name),
                Name::Framebuffer(name) => gl.delete_framebuffer(name),
            }
        }
    }
}
