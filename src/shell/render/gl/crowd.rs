//! Shapes that are drawn many times at once, each time at another place.

use super::{Format, Gl, Name, Owned, Program};
use glow::HasContext;
use std::ops::Range;

/// Vertices of shapes, and places that each draw takes some of.
pub struct Crowd {
    gl: Gl,
    array: glow::VertexArray,
    shapes: Part,
    places: Part,
    layout: &'static [Format],
    /// Attribute of a place's first format.
    first: u32,
    _owned: [Owned; 3],
}

/// One of its buffers.
struct Part {
    buffer: glow::Buffer,
    stride: usize,
    capacity: usize,
    count: usize,
}

fn stride(layout: &[Format]) -> usize {
    layout.iter().map(|format| format.parts().3 as usize).sum()
}

impl Gl {
    /// An empty crowd. The attributes of its places come after those of its vertices.
    pub fn crowd(
        &self,
        vertex: &'static [Format],
        place: &'static [Format],
    ) -> Result<Crowd, String> {
        let gl = &self.ctx;
        // SAFETY: the names belong to the Crowd, which deletes them; offsets stay below the stride.
        unsafe {
            let array = gl.create_vertex_array()?;
            let array_owner = self.own(Name::Array(array));
            let shapes = gl.create_buffer()?;
            let shapes_owner = self.own(Name::Buffer(shapes));
            let places = gl.create_buffer()?;
            let part = |buffer, layout| Part {
                buffer,
                stride: stride(layout),
                capacity: 0,
                count: 0,
            };
            let crowd = Crowd {
                gl: self.clone(),
                array,
                shapes: part(shapes, vertex),
                places: part(places, place),
                layout: place,
                first: vertex.len() as u32,
                _owned: [array_owner, shapes_owner, self.own(Name::Buffer(places))],
            };
            gl.bind_vertex_array(Some(array));
            gl.bind_buffer(glow::ARRAY_BUFFER, Some(shapes));
            self.attributes(vertex, 0, 0);
            for (index, _) in (crowd.first..).zip(place) {
                gl.enable_vertex_attrib_array(index);
                gl.vertex_attrib_divisor(index, 1);
            }
            (0..crowd.first).for_each(|index| gl.enable_vertex_attrib_array(index));
            gl.bind_vertex_array(None);
            Ok(crowd)
        }
    }

    /// Lets the attributes from `first` on read the bound buffer, from a byte on.
    ///
    /// # Safety
    /// The vertex array and the buffer are bound.
    unsafe fn attributes(&self, layout: &[Format], first: u32, start: usize) {
        let stride = stride(layout) as i32;
        let mut offset = start as i32;
        for (index, format) in (first..).zip(layout) {
            let (components, kind, normalized, size) = format.parts();
            // SAFETY: no memory is read before a draw, whose caller checks what it reads.
            unsafe {
                let gl = &self.ctx;
                gl.vertex_attrib_pointer_f32(index, components, kind, normalized, stride, offset);
            }
            offset += size;
        }
    }

    /// Draws some vertices at each of some places.
    ///
    /// # Panics
    /// There are no such vertices or places.
    pub fn draw_crowd(
        &self,
        program: &Program,
        crowd: &Crowd,
        vertices: &Range<usize>,
        places: &Range<usize>,
    ) {
        assert!(vertices.end <= crowd.shapes.count && places.end <= crowd.places.count);
        let (gl, count) = (&self.ctx, vertices.len());
        self.note(
            4 + crowd.layout.len() as u32,
            Some(count / 3 * places.len()),
        );
        // SAFETY: vertices and places were uploaded, as is checked above.
        unsafe {
            gl.use_program(Some(program.raw));
            gl.bind_vertex_array(Some(crowd.array));
            gl.bind_buffer(glow::ARRAY_BUFFER, Some(crowd.places.buffer));
            let start = places.start * crowd.places.stride;
            self.attributes(crowd.layout, crowd.first, start);
            let first = vertices.start as i32;
            let times = places.len() as i32;
            gl.draw_arrays_instanced(glow::TRIANGLES, first, count as i32, times);
        }
    }

    /// Lets fronts run the other way around, for shapes that are mirrored.
    pub fn mirror(&self, on: bool) {
        self.note(1, None);
        // SAFETY: state.
        unsafe { self.ctx.front_face(if on { glow::CW } else { glow::CCW }) }
    }

    /// A table of pairs of words that shaders read by `texelFetch`: rows of `width` pairs, the last one filled up.
    pub fn table(&self, pairs: &[[u32; 2]], width: usize) -> Result<Owned, String> {
        let gl = &self.ctx;
        let rows = pairs.len().div_ceil(width).max(1);
        let mut bytes = Vec::with_capacity(rows * width * 8);
        for word in pairs.iter().flatten() {
            bytes.extend(word.to_ne_bytes());
        }
        bytes.resize(rows * width * 8, 0);
        let (kind, inner) = (glow::TEXTURE_2D, glow::RG32UI as i32);
        let (format, texel) = (glow::RG_INTEGER, glow::UNSIGNED_INT);
        let (width, rows) = (width as i32, rows as i32);
        // SAFETY: the bytes are as many as the texture takes.
        unsafe {
            let raw = gl.create_texture()?;
            let owned = self.own(Name::Texture(raw));
            gl.bind_buffer(glow::PIXEL_UNPACK_BUFFER, None);
            gl.pixel_store_i32(glow::UNPACK_ALIGNMENT, 1);
            gl.pixel_store_i32(glow::UNPACK_ROW_LENGTH, 0);
            gl.bind_texture(kind, Some(raw));
            gl.tex_image_2d(kind, 0, inner, width, rows, 0, format, texel, Some(&bytes));
            for name in [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER] {
                gl.tex_parameter_i32(kind, name, glow::NEAREST as i32);
            }
            Ok(owned)
        }
    }
}

impl Crowd {
    /// Replaces the vertices of all shapes.
    pub fn set_shapes(&mut self, words: &[u32]) {
        self.shapes.upload(&self.gl, words);
    }

    /// Replaces all places.
    pub fn set_places(&mut self, words: &[u32]) {
        self.places.upload(&self.gl, words);
    }
}

impl Part {
    fn upload(&mut self, gl: &Gl, words: &[u32]) {
        let bytes = size_of_val(words);
        self.count = bytes / self.stride;
        self.capacity = self.capacity.max(bytes.next_power_of_two());
        gl.refill((glow::ARRAY_BUFFER, self.buffer), self.capacity, words);
    }
}
