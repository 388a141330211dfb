//! What is drawn as instances: the pieces of the kit, which stand in a level many times over; and what moves by itself, each
//! at a place of its own in this picture.
//!
//! A piece has one mesh for all its places. Only the light of its vertices differs from place to place: shaders read it from a
//! table. Who is in sight is found anew for each picture, piece by piece, and handed over in one upload. Also without a GPU that
//! is quicker than chunks into which the pieces are merged: a third fewer triangles are drawn, for chunks are seen sooner.

use super::frame::FrameBlock;
use super::gl::crowd::Crowd as Buffers;
use super::gl::{Gl, Owned, Program};
use super::kit::Kit;
use super::model::{Model, VERTEX_WORDS};
use super::scene::Instance;
use super::state::Format;
use glam::{Mat4, Vec3};
use std::ops::Range;

/// A place: three rows of a matrix; where the light begins in the table less the first vertex, and the glow, if it is not
/// that of the vertices (else negative).
const PLACE: [Format; 4] = [Format::F4; 4];
const PLACE_WORDS: usize = 16;
/// Entries in a row of the table of light. The same as in shaders/piece.vert.
const ROW: usize = 2048;
/// Entries of the table that a float can number.
const MOST: usize = 1 << 24;

/// One mesh.
struct Shape {
    vertices: Range<usize>,
    min: Vec3,
    max: Vec3,
}

/// One draw: a mesh at some places.
#[derive(Clone, Debug, PartialEq)]
struct Batch {
    vertices: Range<usize>,
    places: Range<usize>,
    mirrored: bool,
}

/// All meshes and all places.
pub struct Crowd {
    gl: Gl,
    buffers: Buffers,
    shapes: Vec<Shape>,
    still: Vec<Instance>,
    light: Option<Owned>,
    seen: Vec<Batch>,
    casting: Vec<Batch>,
    loose: Vec<Batch>,
}

impl Crowd {
    /// Nobody yet; `vertex` is the layout of vertices without their baked light.
    pub fn new(gl: &Gl) -> Result<Crowd, String> {
        Ok(Crowd {
            gl: gl.clone(),
            buffers: gl.crowd(&super::VERTEX, &PLACE)?,
            shapes: Vec::new(),
            still: Vec::new(),
            light: None,
            seen: Vec::new(),
            casting: Vec::new(),
            loose: Vec::new(),
        })
    }

    /// Replaces all meshes, by the pieces of a kit and by others; and the pieces that stand still.
    pub fn set<'a>(
        &mut self,
        kit: &'a Kit,
        others: impl Iterator<Item = &'a Model>,
        still: Vec<Instance>,
        light: &[[u32; 2]],
    ) {
        let mut words = Vec::new();
        self.shapes.clear();
        for model in kit.pieces().chain(others) {
            let first = words.len() / VERTEX_WORDS;
            words.extend(&model.words);
            let (min, max) = model.bounds();
            self.shapes.push(Shape {
                vertices: first..words.len() / VERTEX_WORDS,
                min,
                max,
            });
        }
        self.buffers.set_shapes(&words);
        let fits = light.len() < MOST.min(ROW * self.gl.largest_side() as usize);
        let table = fits.then(|| self.gl.table(light, ROW).ok());
        self.light = table.flatten();
        self.still = still;
    }

    /// Whether the pieces that stand still can be drawn: there was room for their light.
    pub fn has_still(&self) -> bool {
        self.light.is_some()
    }

    /// Begins a picture in which nobody is seen.
    pub fn begin(&mut self, words: &mut Vec<u32>) {
        words.clear();
        self.seen.clear();
        self.casting.clear();
        self.loose.clear();
    }

    /// Shows what stands still and is in sight, and what throws a shadow into it.
    pub fn show_still(&mut self, block: &FrameBlock, shadows: bool, words: &mut Vec<u32>) {
        let Crowd {
            shapes,
            still,
            seen,
            casting,
            ..
        } = self;
        for instance in still.iter().filter(|i| block.sees(i.min, i.max)) {
            put_still(instance, shapes, seen, words);
        }
        let shading = |i: &&Instance| shadows && block.shades(i.min, i.max);
        for instance in still.iter().filter(shading) {
            put_still(instance, shapes, casting, words);
        }
    }

    /// Shows a mesh, by its number, at a place of this picture.
    pub fn show(
        &mut self,
        block: &FrameBlock,
        (shape, place): (usize, Mat4),
        glow: Option<f32>,
        words: &mut Vec<u32>,
    ) {
        let shape = &self.shapes[shape];
        // The box around the box that is moved.
        let (middle, half) = ((shape.min + shape.max) / 2.0, (shape.max - shape.min) / 2.0);
        let middle = place.transform_point3(middle);
        let [x, y, z] =
            [place.x_axis, place.y_axis, place.z_axis].map(|axis| axis.truncate().abs());
        let half = x * half.x + y * half.y + z * half.z;
        let (min, max) = (middle - half, middle + half);
        if block.sees(min, max) || block.shades(min, max) {
            let record = [0.0, glow.unwrap_or(-1.0)];
            put(&shape.vertices, place, record, &mut self.loose, words);
        }
    }

    /// Hands over all places.
    pub fn upload(&mut self, words: &[u32]) {
        self.buffers.set_places(words);
    }

    /// Draws the pieces that stand still, their light read from a texture unit.
    pub fn draw_still(&self, program: &Program, unit: u32) {
        if let Some(light) = &self.light {
            self.gl.read_from(unit, light);
            self.draw(program, &self.seen);
        }
    }

    /// Draws what moves.
    pub fn draw_loose(&self, program: &Program) {
        self.draw(program, &self.loose);
    }

    /// Draws the pieces that throw shadows, and what moves.
    pub fn draw_casting(&self, program: &Program) {
        self.draw(program, &self.casting);
        self.draw(program, &self.loose);
    }

    fn draw(&self, program: &Program, batches: &[Batch]) {
        for batch in batches {
            if batch.mirrored {
                self.gl.mirror(true);
            }
            self.gl
                .draw_crowd(program, &self.buffers, &batch.vertices, &batch.places);
            if batch.mirrored {
                self.gl.mirror(false);
            }
        }
    }
}

/// Adds the place of a piece that stands still.
fn put_still(
    instance: &Instance,
    shapes: &[Shape],
    batches: &mut Vec<Batch>,
    words: &mut Vec<u32>,
) {
    let vertices = &shapes[instance.piece].vertices;
    // Shaders number vertices from the first of all meshes on.
    let light = instance.light as f32 - vertices.start as f32;
    put(vertices, instance.place, [light, -1.0], batches, words);
}

/// Adds a place: to the last draw, if that is of the same mesh.
fn put(
    vertices: &Range<usize>,
    place: Mat4,
    [light, glow]: [f32; 2],
    batches: &mut Vec<Batch>,
    words: &mut Vec<u32>,
) {
    let number = words.len() / PLACE_WORDS;
    let rows = place.transpose();
    for row in [rows.x_axis, rows.y_axis, rows.z_axis] {
        words.extend(row.to_array().map(f32::to_bits));
    }
    words.extend([light, glow, 0.0, 0.0].map(f32::to_bits));
    let mirrored = place.determinant() < 0.0;
    match batches.last_mut() {
        Some(last)
            if last.vertices == *vertices
                && last.mirrored == mirrored
                && last.places.end == number =>
        {
            last.places.end += 1;
        }
        _ => batches.push(Batch {
            vertices: vertices.clone(),
            places: number..number + 1,
            mirrored,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_of_one_mesh_are_drawn_at_once() {
        let (mut batches, mut words) = (Vec::new(), Vec::new());
        let mirror = Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0));
        let places = [
            (0..3, Mat4::IDENTITY),
            (0..3, Mat4::from_translation(Vec3::Y * 5.0)),
            (0..3, mirror),
            (3..9, mirror),
        ];
        for (vertices, place) in places {
            put(&vertices, place, [7.0, -1.0], &mut batches, &mut words);
        }
        let found = batches.iter().map(|b| (b.places.clone(), b.mirrored));
        assert_eq!(
            found.collect::<Vec<_>>(),
            [(0..2, false), (2..3, true), (3..4, true)]
        );
        assert_eq!(words.len(), 4 * PLACE_WORDS);
        let second = &words[PLACE_WORDS..2 * PLACE_WORDS];
        assert_eq!(
            f32::from_bits(second[7]),
            5.0,
            "how far up, in the second row"
        );
        assert_eq!(f32::from_bits(second[12]), 7.0);
    }
}
