//! Pixels from the machine to OpenGL and back.

use super::{Gl, Name, Owned};
use glow::HasContext;

impl Gl {
    /// The lower left `width` by `height` pixels of the bound framebuffer: RGB, rows from the bottom up.
    pub fn read_pixels(&self, width: u32, height: u32) -> Vec<u8> {
        let gl = &self.ctx;
        let row = width as usize * 3;
        let mut pixels = vec![0; row * height as usize];
        if pixels.is_empty() {
            return pixels;
        }
        let (format, kind) = (glow::RGB, glow::UNSIGNED_BYTE);
        // SAFETY: with a pack alignment of 1 exactly `row * height` bytes are written.
        unsafe {
            gl.bind_buffer(glow::PIXEL_PACK_BUFFER, None);
            gl.pixel_store_i32(glow::PACK_ALIGNMENT, 1);
            gl.pixel_store_i32(glow::PACK_ROW_LENGTH, 0);
            let into = glow::PixelPackData::Slice(&mut pixels);
            gl.read_pixels(0, 0, width as i32, height as i32, format, kind, into);
        }
        pixels
    }

    /// Replaces rows of a texture of coverage that is `width` texels wide, from the row `first` on. What lies beyond the
    /// texture is an error of OpenGL and changes nothing.
    pub fn write_rows(&self, texture: &Owned, width: u32, first: u32, coverage: &[u8]) {
        let (gl, kind) = (&self.ctx, glow::TEXTURE_2D);
        let (Name::Texture(raw), 1..) = (texture.name, width) else {
            return;
        };
        let rows = coverage.len() / width as usize;
        let data = glow::PixelUnpackData::Slice(&coverage[..rows * width as usize]);
        let (width, first, rows) = (width as i32, first as i32, rows as i32);
        let (format, texel) = (glow::RED, glow::UNSIGNED_BYTE);
        // SAFETY: with an unpack alignment of 1 exactly `width * rows` bytes are read.
        unsafe {
            gl.bind_buffer(glow::PIXEL_UNPACK_BUFFER, None);
            gl.pixel_store_i32(glow::UNPACK_ALIGNMENT, 1);
            gl.pixel_store_i32(glow::UNPACK_ROW_LENGTH, 0);
            gl.bind_texture(kind, Some(raw));
            gl.tex_sub_image_2d(kind, 0, 0, first, width, rows, format, texel, data);
        }
    }
}
