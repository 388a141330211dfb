//! Light that can be worked out when a level is read, put into the vertices: how open they are to the sky, which share of
//! the key light reaches them, and the lamps that stand still.
//!
//! Who sees what is found as a shadow map does it: the triangles are drawn, here by the processor, into a map of heights
//! along a direction; a vertex is reached from there unless the map holds something higher.

use super::frame::{PointLight, SUN};
use super::model::{VERTEX_WORDS, pack, unpack_signed};
use glam::{Vec2, Vec3};

/// Directions from which a vertex may see the sky: rows of (elevation in degrees, how many, the first one's azimuth).
const SKY: [(f32, usize, f32); 3] = [(18.0, 6, 0.2), (48.0, 5, 0.9), (82.0, 1, 0.0)];
/// Metres to a texel of the map of the key light, and of those of the sky; larger for levels that need more of them.
const KEY_TEXEL: f32 = 0.18;
const SKY_TEXEL: f32 = 0.4;
const MOST_TEXELS: f32 = 6e6;
/// How far from its corner, along the normal and towards the middle of its facet, a vertex looks out.
const LIFT: f32 = 0.14;
const INWARD: f32 = 0.12;
/// The least openness that is left in the deepest corner.
const DARKEST: f32 = 0.34;
/// Surfaces that are seen more slantingly than this are taken to be so steep and no more.
const STEEPEST: f32 = 0.12;
/// Light of lamps that fits into a vertex.
const BRIGHTEST: f32 = 4.0;

/// A place that looks out, with its normal.
struct Lookout {
    at: Vec3,
    normal: Vec3,
}

/// Puts the light of what stands still into all vertices of a scene.
pub fn bake(words: &mut [u32], lamps: &[PointLight]) {
    let corners: Vec<Vec3> = words.chunks_exact(VERTEX_WORDS).map(place).collect();
    let lookouts = lookouts(words, &corners);
    let key = key_light(&corners, &lookouts);
    let open = openness(&corners, &lookouts);
    for (i, vertex) in words.chunks_exact_mut(VERTEX_WORDS).enumerate() {
        let [r, g, b, shade] = vertex[4].to_ne_bytes().map(|byte| f32::from(byte) / 255.0);
        vertex[4] = pack([r, g, b, shade * open[i]]);
        let light = lamp_light(lamps, corners[i], lookouts[i].normal) / BRIGHTEST;
        let [r, g, b] = light.to_array().map(|c| c.max(0.0).sqrt());
        vertex[5] |= BAKED;
        vertex[6] = pack([r, g, b, key[i]]);
    }
}

/// The last trait: that the vertex's light is baked.
const BAKED: u32 = u32::from_ne_bytes([0, 0, 0, 255]);

fn place(vertex: &[u32]) -> Vec3 {
    Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(vertex[i])))
}

/// Where the vertices look out from: off their surface, and off the corner that they share with others.
fn lookouts(words: &[u32], corners: &[Vec3]) -> Vec<Lookout> {
    let normals = words
        .chunks_exact(VERTEX_WORDS)
        .map(|v| unpack_signed(v[3]));
    let lookout = |(i, normal): (usize, Vec3)| {
        let first = i / 3 * 3;
        let middle = corners[first..(first + 3).min(corners.len())]
            .iter()
            .sum::<Vec3>()
            / 3.0;
        let at = corners[i].lerp(middle, INWARD) + normal * LIFT;
        Lookout { at, normal }
    };
    normals.enumerate().map(lookout).collect()
}

/// The share of the key light that reaches each place.
fn key_light(corners: &[Vec3], lookouts: &[Lookout]) -> Vec<f32> {
    let map = Heights::of(corners, SUN.normalize(), KEY_TEXEL);
    lookouts.iter().map(|from| map.share_seen(from)).collect()
}

/// The share of the sky that each place sees, of what it would see if it stood free.
fn openness(corners: &[Vec3], lookouts: &[Lookout]) -> Vec<f32> {
    let directions: Vec<Vec3> = SKY.into_iter().flat_map(row).collect();
    let mut seen = vec![0.0f32; lookouts.len()];
    let mut whole = vec![1e-3f32; lookouts.len()];
    for direction in directions {
        let map = Heights::of(corners, direction, SKY_TEXEL);
        for ((from, seen), whole) in lookouts.iter().zip(&mut seen).zip(&mut whole) {
            let weight = from.normal.dot(direction) + 0.15;
            if weight > 0.0 {
                *whole += weight;
                *seen += weight * map.share_seen(from);
            }
        }
    }
    let share =
        |(seen, whole): (f32, f32)| DARKEST + (1.0 - DARKEST) * (seen / whole).clamp(0.0, 1.0);
    seen.into_iter().zip(whole).map(share).collect()
}

/// Directions all around at one elevation.
fn row((elevation, count, first): (f32, usize, f32)) -> impl Iterator<Item = Vec3> {
    let (up, out) = elevation.to_radians().sin_cos();
    (0..count).map(move |i| {
        let (sin, cos) = (first + std::f32::consts::TAU * i as f32 / count as f32).sin_cos();
        Vec3::new(cos * out, up, sin * out)
    })
}

/// The light of lamps at a place. The same as `lamps` in shaders/light.glsl.
fn lamp_light(lamps: &[PointLight], at: Vec3, normal: Vec3) -> Vec3 {
    let mut light = Vec3::ZERO;
    for lamp in lamps {
        let way = lamp.at - at;
        let far = way.length_squared() / (lamp.reach * lamp.reach);
        if far < 1.0 {
            let facing = normal.dot(way) / (way.length_squared() + 0.01).sqrt() * 0.7 + 0.3;
            let fade = (1.0 - far) * (1.0 - far) / (1.0 + 9.0 * far);
            light += lamp.colour * (facing.max(0.0) * fade);
        }
    }
    light
}

/// How high triangles reach along a direction, on a grid across it.
struct Heights {
    right: Vec3,
    up: Vec3,
    towards: Vec3,
    min: Vec2,
    texel: f32,
    width: usize,
    height: usize,
    highest: Vec<f32>,
}

impl Heights {
    /// The heights of triangles, given by their corners.
    fn of(corners: &[Vec3], towards: Vec3, texel: f32) -> Heights {
        let right = towards.any_orthonormal_vector();
        let up = towards.cross(right);
        let flat = |p: &Vec3| Vec2::new(right.dot(*p), up.dot(*p));
        let (min, max) = corners
            .iter()
            .map(flat)
            .fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(min, max), p| {
                (min.min(p), max.max(p))
            });
        let extent = (max - min).max(Vec2::ZERO);
        let texel = texel.max((extent.x * extent.y / MOST_TEXELS).sqrt());
        let side = |metres: f32| (metres / texel).min(MOST_TEXELS) as usize + 2;
        let (width, height) = match corners.is_empty() {
            true => (1, 1),
            false => (side(extent.x), side(extent.y)),
        };
        let highest = vec![f32::NEG_INFINITY; width * height];
        let mut heights = Heights {
            right,
            up,
            towards,
            min,
            texel,
            width,
            height,
            highest,
        };
        for triangle in corners.chunks_exact(3) {
            heights.draw([triangle[0], triangle[1], triangle[2]]);
        }
        heights
    }

    /// A place on the grid, in texels, and its height.
    fn project(&self, p: Vec3) -> (Vec2, f32) {
        let flat = Vec2::new(self.right.dot(p), self.up.dot(p));
        ((flat - self.min) / self.texel, self.towards.dot(p))
    }

    /// Raises the texels whose middles a triangle covers.
    fn draw(&mut self, triangle: [Vec3; 3]) {
        let [(a, ha), (b, hb), (c, hc)] = triangle.map(|p| self.project(p));
        let area = (b - a).perp_dot(c - a);
        if area.abs() < 1e-6 {
            return;
        }
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        for y in low.y.max(0.0) as usize..=(high.y as usize).min(self.height - 1) {
            for x in low.x.max(0.0) as usize..=(high.x as usize).min(self.width - 1) {
                let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let (u, v) = (
                    (b - p).perp_dot(c - p) / area,
                    (c - p).perp_dot(a - p) / area,
                );
                let w = 1.0 - u - v;
                if u >= 0.0 && v >= 0.0 && w >= 0.0 {
                    let texel = &mut self.highest[y * self.width + x];
                    *texel = texel.max(u * ha + v * hb + w * hc);
                }
            }
        }
    }

    /// Which share of three by three texels about a place is not higher than the plane of its surface.
    fn share_seen(&self, from: &Lookout) -> f32 {
        let (at, height) = self.project(from.at);
        let across = Vec2::new(from.normal.dot(self.right), from.normal.dot(self.up));
        let slope = -across / from.normal.dot(self.towards).max(STEEPEST);
        let (x, y) = (at.x.max(0.0) as usize, at.y.max(0.0) as usize);
        let (mut seen, mut asked) = (0, 0);
        for row in y.saturating_sub(1)..(y + 2).min(self.height) {
            for texel in x.saturating_sub(1)..(x + 2).min(self.width) {
                let middle = Vec2::new(texel as f32 + 0.5, row as f32 + 0.5);
                let plane = height + slope.dot(middle - at) * self.texel;
                asked += 1;
                seen +=
                    usize::from(self.highest[row * self.width + texel] <= plane + self.texel * 0.5);
            }
        }
        seen as f32 / asked.max(1) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::super::model::{Model, paint};
    use super::*;

    /// The openness and the share of the key light of a vertex.
    fn light(vertex: &[u32]) -> (f32, f32) {
        let last = |word: u32| f32::from(word.to_ne_bytes()[3]) / 255.0;
        (last(vertex[4]), last(vertex[6]))
    }

    /// A floor of 20 by 20 m; with a roof of 12 by 12 m over its middle, if wanted. The vertex near the middle.
    fn middle_of_a_floor(roofed: bool, lamps: &[PointLight]) -> Vec<u32> {
        let mut model = Model::default();
        let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
        for x in -10..10 {
            for z in -10..10 {
                let (x, z) = (x as f32, z as f32);
                let corners = [
                    at(x, 0.0, z + 1.0),
                    at(x + 1.0, 0.0, z + 1.0),
                    at(x + 1.0, 0.0, z),
                    at(x, 0.0, z),
                ];
                model.quad(corners, paint(0x808080));
            }
        }
        if roofed {
            let corners = [(-6.0, 6.0), (6.0, 6.0), (6.0, -6.0), (-6.0, -6.0)];
            model.quad(corners.map(|(x, z)| at(x, 3.0, z)), paint(0x808080));
        }
        bake(&mut model.words, lamps);
        let near = |v: &&[u32]| place(v) == Vec3::ZERO;
        model
            .words
            .chunks_exact(VERTEX_WORDS)
            .find(near)
            .unwrap()
            .to_vec()
    }

    #[test]
    fn a_roof_keeps_the_sky_and_the_sun_away() {
        let ((open, key), (under, shaded)) = (
            light(&middle_of_a_floor(false, &[])),
            light(&middle_of_a_floor(true, &[])),
        );
        assert!(open > 0.98 && key > 0.98, "{open} {key}");
        assert!(under < 0.75 && shaded < 0.02, "{under} {shaded}");
    }

    #[test]
    fn a_lamp_lights_what_is_near() {
        let lamp = |x: f32| PointLight {
            at: Vec3::new(x, 1.0, 0.0),
            reach: 5.0,
            colour: Vec3::new(1.0, 0.5, 0.0),
        };
        let [near, far] = [0.0, 9.0].map(|x| middle_of_a_floor(false, &[lamp(x)])[6].to_ne_bytes());
        assert!(
            near[0] > 60 && near[0] > near[1] && near[2] == 0,
            "{near:?}"
        );
        assert_eq!(far[..3], [0, 0, 0]);
    }

    #[test]
    fn nothing_is_baked_into_nothing() {
        bake(&mut [], &[]);
    }
}
