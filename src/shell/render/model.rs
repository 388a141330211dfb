//! Flat-shaded triangles and the simple solids that everything in the picture is built of.

use glam::{Mat4, Vec3};
use std::ops::Range;

/// Words of one vertex: position, normal, colour and shade, traits, baked light; and of a facet.
pub const VERTEX_WORDS: usize = 7;
pub const FACET_WORDS: usize = 3 * VERTEX_WORDS;
/// Of the baked light: no lamp, and the key light unhindered.
const UNBAKED: u32 = u32::from_ne_bytes([0, 0, 0, 255]);

/// Which of them are the normal, the colour and the traits.
const NORMAL: usize = 3;
const COLOUR: usize = 4;
const TRAITS: usize = 5;

/// What a surface looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paint {
    /// Red, green, blue as on the screen (sRGB), 0 to 1.
    pub colour: Vec3,
    /// Share of the colour that shines by itself.
    pub glow: f32,
    /// How far the wind moves it, 0 to 1.
    pub sway: f32,
    /// How much neighbouring facets differ from each other in brightness and hue.
    pub variety: f32,
}

/// A dull paint of this sRGB colour, 0xRRGGBB.
pub const fn paint(rgb: u32) -> Paint {
    let colour = Vec3::new(channel(rgb >> 16), channel(rgb >> 8), channel(rgb));
    Paint {
        colour,
        glow: 0.0,
        sway: 0.0,
        variety: 0.06,
    }
}

/// The lowest byte, as 0 to 1.
const fn channel(rgb: u32) -> f32 {
    (rgb & 255) as f32 / 255.0
}

impl Paint {
    /// The same, shining.
    pub const fn glowing(self, glow: f32) -> Paint {
        Paint { glow, ..self }
    }

    /// The same, with facets that differ more or less.
    pub const fn varied(self, variety: f32) -> Paint {
        Paint { variety, ..self }
    }

    /// The colour between two paints; the rest is the first one's.
    pub fn towards(self, other: Paint, share: f32) -> Paint {
        Paint {
            colour: self.colour.lerp(other.colour, share),
            ..self
        }
    }
}

/// A number from 0 to 1 that depends on a position (to the centimetre) and a salt, and on nothing else.
pub fn hash(p: Vec3, salt: u32) -> f32 {
    let mut h = salt.wrapping_mul(0x9e37_79b9) ^ 0x85eb_ca6b;
    for c in p.to_array() {
        h = (h ^ (c * 100.0).round() as i32 as u32).wrapping_mul(0xcc9e_2d51);
        h = (h ^ (h >> 15)).wrapping_mul(0x1b87_3593);
        h ^= h >> 13;
    }
    (h >> 8) as f32 / (1 << 24) as f32
}

/// A corner of a facet whose light was worked out before.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// Its place.
    pub at: Vec3,
    /// Its colour as on the screen (sRGB), 0 to 1.
    pub colour: Vec3,
    /// The share of the sky that it sees.
    pub open: f32,
    /// How far the wind moves it, 0 to 1.
    pub sway: f32,
}

/// Triangles under construction, in the words that go to the GPU.
#[derive(Clone, Default)]
pub struct Model {
    /// [`VERTEX_WORDS`] words for each corner of each triangle.
    pub words: Vec<u32>,
    /// Which piece of the kit this is, if it is one.
    pub piece: Option<usize>,
    /// The pieces of the kit that were added, and which facets are theirs.
    pub placed: Vec<Placed>,
}

/// A piece of the kit in a model.
#[derive(Clone)]
pub struct Placed {
    /// Which one.
    pub piece: usize,
    /// Where it is.
    pub place: Mat4,
    /// Its facets in the model, in its own order.
    pub facets: Range<usize>,
}

/// The order of a facet's corners after it was moved, so that a mirrored one is seen from its front as before.
pub fn corner_order(place: Mat4) -> [usize; 3] {
    match place.determinant() < 0.0 {
        true => [0, 2, 1],
        false => [0, 1, 2],
    }
}

impl Model {
    /// A facet, counter-clockwise seen from its front; `shade` darkens each corner (1 is open to the sky).
    /// A facet without area is left out.
    pub fn facet(&mut self, corners: [Vec3; 3], shade: [f32; 3], paint: Paint) {
        let [a, b, c] = corners;
        let Some(normal) = (b - a).cross(c - a).try_normalize() else {
            return;
        };
        self.facet_facing(normal, corners, shade, paint);
    }

    /// A facet that is lit as if it faced a direction.
    pub fn facet_facing(
        &mut self,
        normal: Vec3,
        corners: [Vec3; 3],
        shade: [f32; 3],
        paint: Paint,
    ) {
        let middle = corners.iter().sum::<Vec3>() / 3.0;
        let brighter = (hash(middle, 1) - 0.5) * 2.0 * paint.variety;
        let warmer = (hash(middle, 2) - 0.5) * 0.6 * paint.variety;
        let colour = paint.colour * (1.0 + brighter) * Vec3::new(1.0 + warmer, 1.0, 1.0 - warmer);
        let traits = pack([paint.glow, paint.sway, 0.0, 0.0]);
        for (at, shade) in corners.into_iter().zip(shade) {
            self.words.extend(at.to_array().map(f32::to_bits));
            self.words.push(pack_signed(normal));
            self.words.push(pack([colour.x, colour.y, colour.z, shade]));
            self.words.push(traits);
            self.words.push(UNBAKED);
        }
    }

    /// A facet, counter-clockwise seen from its front, with the colours of its corners; `glow` is the share of them that
    /// shines by itself. A facet without area is left out.
    pub fn shaded(&mut self, corners: [Corner; 3], glow: f32) {
        let before = self.words.len();
        self.facet(
            corners.map(|corner| corner.at),
            corners.map(|corner| corner.open),
            paint(0),
        );
        let vertices = self.words[before..].chunks_exact_mut(VERTEX_WORDS);
        for (
            vertex,
            Corner {
                colour, open, sway, ..
            },
        ) in vertices.zip(corners)
        {
            vertex[COLOUR] = pack(colour.extend(open).to_array());
            vertex[TRAITS] = pack([glow, sway, 0.0, 0.0]);
        }
    }

    /// The box around it: lower and upper corner.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        let at = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        let corners = self.words.chunks_exact(VERTEX_WORDS).map(at);
        corners.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), p| {
            (min.min(p), max.max(p))
        })
    }

    /// A blade of grass: a facet whose last corner alone the wind moves, dark at the root.
    pub fn blade(&mut self, corners: [Vec3; 3], paint: Paint) {
        let before = self.words.len();
        self.facet(corners, [0.6, 0.6, 1.0], paint);
        let tip = before + 3 * VERTEX_WORDS - 2;
        if let Some(traits) = self.words.get_mut(tip) {
            *traits = pack([paint.glow, 0.6, 0.0, 0.0]);
        }
    }

    /// A quadrilateral, counter-clockwise seen from its front, as two facets.
    pub fn quad(&mut self, [a, b, c, d]: [Vec3; 4], paint: Paint) {
        self.facet([a, b, c], [1.0; 3], paint);
        self.facet([a, c, d], [1.0; 3], paint);
    }

    /// The band between two rings of equally many points, both counter-clockwise seen from the upper one's side.
    pub fn band(&mut self, lower: &[Vec3], upper: &[Vec3], paint: Paint) {
        for i in 0..lower.len() {
            let j = (i + 1) % lower.len();
            self.quad([lower[i], lower[j], upper[j], upper[i]], paint);
        }
    }

    /// A fan that closes a convex ring, seen from the side where it runs counter-clockwise.
    pub fn cap(&mut self, ring: &[Vec3], paint: Paint) {
        for i in 2..ring.len() {
            self.facet([ring[0], ring[i - 1], ring[i]], [1.0; 3], paint);
        }
    }

    /// A solid whose cross-sections are regular polygons about `base` + y: pairs of height and radius, from below.
    pub fn lathe(&mut self, base: Vec3, sides: usize, profile: &[(f32, f32)], paint: Paint) {
        let rings: Vec<Vec<Vec3>> = profile
            .iter()
            .map(|&(height, radius)| ring(base + Vec3::Y * height, sides, radius))
            .collect();
        for pair in rings.windows(2) {
            self.band(&pair[0], &pair[1], paint);
        }
        if let (Some(first), Some(last)) = (rings.first(), rings.last()) {
            let below: Vec<Vec3> = first.iter().rev().copied().collect();
            self.cap(&below, paint);
            self.cap(last, paint);
        }
    }

    /// A square beam from one point to another.
    pub fn beam(&mut self, from: Vec3, to: Vec3, half: f32, paint: Paint) {
        let Some(along) = (to - from).try_normalize() else {
            return;
        };
        let side = if along.y.abs() > 0.9 {
            Vec3::X
        } else {
            Vec3::Y
        }
        .cross(along)
        .normalize()
            * half;
        let up = along.cross(side);
        let ring = |p: Vec3| [p + side + up, p - side + up, p - side - up, p + side - up];
        let (start, end) = (ring(from), ring(to));
        self.band(&start, &end, paint);
        self.cap(&end, paint);
        self.cap(&[start[3], start[2], start[1], start[0]], paint);
    }

    /// Adds another model, moved; mirrored facets are seen from their fronts as before.
    pub fn add(&mut self, other: &Model, place: Mat4) {
        let order = corner_order(place);
        let before = self.words.len() / FACET_WORDS;
        let whole = other.piece.map(|piece| Placed {
            piece,
            place: Mat4::IDENTITY,
            facets: 0..other.words.len() / FACET_WORDS,
        });
        for placed in whole.iter().chain(&other.placed) {
            self.placed.push(Placed {
                piece: placed.piece,
                place: place * placed.place,
                facets: placed.facets.start + before..placed.facets.end + before,
            });
        }
        let facets = other.words.chunks_exact(FACET_WORDS);
        let corner = |i: usize| i * VERTEX_WORDS..(i + 1) * VERTEX_WORDS;
        for vertex in facets.flat_map(|facet| order.map(|i| &facet[corner(i)])) {
            let at = Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(vertex[i])));
            let normal = unpack_signed(vertex[3]);
            self.words
                .extend(place.transform_point3(at).to_array().map(f32::to_bits));
            self.words.push(pack_signed(
                place.transform_vector3(normal).normalize_or_zero(),
            ));
            self.words.extend(&vertex[4..]);
        }
    }
}

/// The unit normal of the facet or the vertex with these words.
pub fn normal(words: &[u32]) -> Vec3 {
    unpack_signed(words[NORMAL])
}

/// Of the words of a vertex those that light changes: colour and openness, lamps and key light.
pub fn light_of(words: &[u32]) -> [u32; 2] {
    [words[COLOUR], words[TRAITS + 1]]
}

/// A regular polygon about a point, counter-clockwise seen from above.
pub fn ring(centre: Vec3, sides: usize, radius: f32) -> Vec<Vec3> {
    let corner = |i: usize| {
        let (sin, cos) = (std::f32::consts::TAU * (i as f32 + 0.5) / sides as f32).sin_cos();
        centre + Vec3::new(cos, 0.0, -sin) * radius
    };
    (0..sides).map(corner).collect()
}

/// Four numbers from 0 to 1 as bytes, the first lowest.
pub fn pack(values: [f32; 4]) -> u32 {
    u32::from_ne_bytes(values.map(|v| (v.clamp(0.0, 1.0) * 255.0).round() as u8))
}

/// A unit vector as signed bytes.
pub fn pack_signed(v: Vec3) -> u32 {
    let [x, y, z] = v
        .to_array()
        .map(|c| (c.clamp(-1.0, 1.0) * 127.0).round() as i8 as u8);
    u32::from_ne_bytes([x, y, z, 0])
}

/// Back from signed bytes.
pub fn unpack_signed(word: u32) -> Vec3 {
    let [x, y, z, _] = word.to_ne_bytes().map(|b| f32::from(b as i8) / 127.0);
    Vec3::new(x, y, z)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six times the volume that closed triangles enclose: positive if all of them look outwards.
    fn volume(model: &Model) -> f32 {
        let at = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        let corners: Vec<Vec3> = model.words.chunks_exact(VERTEX_WORDS).map(at).collect();
        corners
            .chunks_exact(3)
            .map(|t| t[0].dot(t[1].cross(t[2])))
            .sum()
    }

    #[test]
    fn solids_look_outwards() {
        let grey = paint(0x808080);
        let mut model = Model::default();
        model.beam(Vec3::ZERO, Vec3::new(3.0, 0.0, 0.0), 0.5, grey);
        assert!((volume(&model) - 18.0).abs() < 1e-4, "{}", volume(&model));
        let mut model = Model::default();
        model.lathe(
            Vec3::ZERO,
            4,
            &[(0.0, 0.5f32.sqrt()), (1.0, 0.5f32.sqrt())],
            grey,
        );
        assert!((volume(&model) - 6.0).abs() < 1e-4, "{}", volume(&model));
    }

    #[test]
    fn what_is_mirrored_still_looks_outwards() {
        let (mut block, mut mirrored) = (Model::default(), Model::default());
        block.beam(Vec3::X, Vec3::new(1.0, 2.0, 0.0), 0.5, paint(0x808080));
        mirrored.add(&block, Mat4::from_scale(Vec3::new(-1.0, 1.0, 1.0)));
        assert!((volume(&mirrored) - 12.0).abs() < 1e-4);
        assert_eq!(mirrored.words.len(), block.words.len());
    }

    #[test]
    fn packing_keeps_signs_and_order() {
        assert_eq!(pack([1.0, 0.0, 2.0, -1.0]).to_ne_bytes(), [255, 0, 255, 0]);
        assert_eq!(unpack_signed(pack_signed(Vec3::NEG_Y)), Vec3::NEG_Y);
    }
}
