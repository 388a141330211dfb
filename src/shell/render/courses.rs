//! Fronts of what was built: courses of dressed blocks, planks, riveted plates, each cut to the outline.
//!
//! A front is flat, and is lit as such also where it bends to a rim. Its triangles are cut by a grid of pieces with gaps between them; what shows in the gaps lies a little
//! deeper and is dark.

use super::model::{Model, Paint, hash};
use crate::level::Material;
use glam::{Vec2, Vec3};

/// How pieces lie.
pub struct Courses {
    /// Height of a course and length of a piece in it, in metres.
    size: Vec2,
    /// Width of the gaps.
    gap: f32,
    /// How far pieces stand out differently.
    relief: f32,
    /// How much they differ in brightness.
    variety: f32,
    /// Whether rivets hold them.
    riveted: bool,
}

/// How deep the gaps are, in metres.
const GAP_DEPTH: f32 = 0.07;
/// Brightness at the lower edge of a piece, where the upper edge has 1.
const LOWER_EDGE: f32 = 0.70;
/// Half width and height of a rivet, and how far it is from the corners of its plate.
const RIVET: (f32, f32) = (0.045, 0.05);
const RIVET_INSET: f32 = 0.16;

/// How pieces of a material lie, so many times larger than usual; nothing for what was not built.
pub fn courses(material: Material, scale: f32) -> Option<Courses> {
    let courses = |size: Vec2, gap, relief, variety, riveted| Courses {
        size: size * scale,
        gap,
        relief,
        variety,
        riveted,
    };
    match material {
        Material::Rock => None,
        Material::Masonry => Some(courses(Vec2::new(1.30, 0.62), 0.045, 0.10, 0.22, false)),
        Material::Timber => Some(courses(Vec2::new(2.60, 0.27), 0.035, 0.06, 0.26, false)),
        Material::Iron => Some(courses(Vec2::new(1.50, 1.15), 0.030, 0.03, 0.14, true)),
    }
}

impl Courses {
    /// Adds the front of a triangle, counter-clockwise seen from before it; `shade` is how open it is.
    pub fn add(
        &self,
        triangle: [Vec3; 3],
        shade: f32,
        upright: bool,
        paint: Paint,
        model: &mut Model,
    ) {
        let joint = Paint {
            colour: paint.colour * 0.42,
            ..paint.varied(0.0)
        };
        model.facet_facing(
            Vec3::Z,
            triangle.map(|p| p - Vec3::Z * GAP_DEPTH),
            [shade; 3],
            joint,
        );
        let local = triangle.map(|p| turned(p.truncate(), upright));
        let front = Front {
            triangle,
            local,
            shade,
            upright,
            paint,
        };
        let (low, high) = local
            .iter()
            .fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), p| {
                (low.min(*p), high.max(*p))
            });
        for row in (low.y / self.size.y).floor() as i32..=(high.y / self.size.y).floor() as i32 {
            let joint = |n: i32| self.joint(row, n);
            let first = (low.x / self.size.x).floor() as i32 - 1;
            let last = (high.x / self.size.x).ceil() as i32 + 1;
            for n in first..last {
                let (left, right) = (joint(n), joint(n + 1));
                if right > low.x && left < high.x {
                    let bottom = row as f32 * self.size.y;
                    let piece = Piece {
                        min: Vec2::new(left, bottom) + self.gap / 2.0,
                        max: Vec2::new(right, bottom + self.size.y) - self.gap / 2.0,
                        seed: Vec3::new(n as f32, row as f32, 5.0),
                    };
                    self.add_piece(&piece, &front, model);
                }
            }
        }
    }

    /// Where the joint before a piece is: courses are shifted against each other, and no piece has the length of its
    /// neighbour.
    fn joint(&self, row: i32, n: i32) -> f32 {
        let shift = 0.5 * (row.rem_euclid(2)) as f32;
        let uneven = 0.36 * (hash(Vec3::new(n as f32, row as f32, 6.0), 400) - 0.5);
        (n as f32 + shift + uneven) * self.size.x
    }

    /// The part of a piece that lies in a triangle.
    fn add_piece(&self, piece: &Piece, front: &Front, model: &mut Model) {
        let outline = piece.cut(front.local);
        if outline.len() < 3 {
            return;
        }
        let chance = |salt: u32| hash(piece.seed, 401 + salt) - 0.5;
        let out = self.relief * chance(0);
        let warmth = Vec3::new(1.0 + 0.10 * chance(2), 1.0, 1.0 - 0.10 * chance(2));
        let paint = Paint {
            colour: front.paint.colour * (1.0 + 2.0 * self.variety * chance(1)) * warmth,
            ..front.paint.varied(0.0)
        };
        let light = |p: Vec2| {
            let share = (p.y - piece.min.y) / (piece.max.y - piece.min.y);
            front.shade * (LOWER_EDGE + (1.0 - LOWER_EDGE) * share.clamp(0.0, 1.0))
        };
        for i in 2..outline.len() {
            let part = [outline[0], outline[i - 1], outline[i]];
            model.facet_facing(
                Vec3::Z,
                part.map(|p| front.place(p, out)),
                part.map(light),
                paint,
            );
        }
        if self.riveted {
            let held = piece.corners(RIVET_INSET).into_iter();
            for at in held.filter(|p| is_inside(front.local, *p, RIVET.0)) {
                let ring = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                let ring = ring.map(|(x, y)| front.place(at + Vec2::new(x, y) * RIVET.0, out));
                let tip = front.place(at, out + RIVET.1);
                for i in 0..4 {
                    model.facet([ring[i], ring[(i + 1) % 4], tip], [front.shade; 3], paint);
                }
            }
        }
    }
}

/// Planks of posts run upwards: a place as their courses have it.
fn turned(p: Vec2, upright: bool) -> Vec2 {
    if upright { Vec2::new(p.y, -p.x) } else { p }
}

/// A triangle of a front.
struct Front {
    triangle: [Vec3; 3],
    /// As the courses have it.
    local: [Vec2; 3],
    shade: f32,
    upright: bool,
    paint: Paint,
}

impl Front {
    /// The place on the triangle's plane, so far out of it towards the viewer.
    fn place(&self, local: Vec2, out: f32) -> Vec3 {
        let p = if self.upright {
            Vec2::new(-local.y, local.x)
        } else {
            local
        };
        let [a, b, c] = self.triangle;
        let normal = (b - a).cross(c - a);
        let flat = p - a.truncate();
        let slope = -(normal.x * flat.x + normal.y * flat.y) / normal.z.max(f32::MIN_POSITIVE);
        p.extend(a.z + slope + out)
    }
}

/// A block, plank or plate.
struct Piece {
    min: Vec2,
    max: Vec2,
    seed: Vec3,
}

impl Piece {
    /// The part of a triangle within the piece, counter-clockwise as the triangle (I. Sutherland, G. Hodgman 1974).
    fn cut(&self, triangle: [Vec2; 3]) -> Vec<Vec2> {
        let sides = [
            (Vec2::X, self.min.x),
            (Vec2::NEG_X, -self.max.x),
            (Vec2::Y, self.min.y),
            (Vec2::NEG_Y, -self.max.y),
        ];
        let mut outline = triangle.to_vec();
        for (normal, least) in sides {
            let height = |p: Vec2| normal.dot(p) - least;
            let mut kept = Vec::new();
            for (i, &b) in outline.iter().enumerate() {
                let a = outline[(i + outline.len() - 1) % outline.len()];
                let (ha, hb) = (height(a), height(b));
                if (ha < 0.0) != (hb < 0.0) {
                    kept.push(a.lerp(b, ha / (ha - hb)));
                }
                if hb >= 0.0 {
                    kept.push(b);
                }
            }
            outline = kept;
        }
        outline
    }

    /// Places near the corners.
    fn corners(&self, inset: f32) -> [Vec2; 4] {
        let (min, max) = (self.min + inset, self.max - inset);
        [min, Vec2::new(max.x, min.y), max, Vec2::new(min.x, max.y)]
    }
}

/// Whether a point is inside a triangle, at least so far from its sides.
fn is_inside(triangle: [Vec2; 3], p: Vec2, margin: f32) -> bool {
    (0..3).all(|i| {
        let (a, b) = (triangle[i], triangle[(i + 1) % 3]);
        (b - a).perp_dot(p - a) >= margin * a.distance(b)
    })
}

#[cfg(test)]
mod tests {
    use super::super::model::{VERTEX_WORDS, paint};
    use super::*;

    /// Twice the area of the facets at a depth or nearer.
    fn area(model: &Model, least: f32) -> f32 {
        let at = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        let corners: Vec<Vec3> = model.words.chunks_exact(VERTEX_WORDS).map(at).collect();
        let flat = corners
            .chunks_exact(3)
            .filter(|t| t.iter().all(|p| p.z >= least));
        flat.map(|t| (t[1] - t[0]).cross(t[2] - t[0]).z).sum()
    }

    #[test]
    fn pieces_fill_a_front_but_for_their_gaps() {
        let triangle = [
            Vec2::new(0.3, -4.0),
            Vec2::new(17.0, 1.0),
            Vec2::new(2.0, 9.0),
        ];
        let whole = (triangle[1] - triangle[0]).perp_dot(triangle[2] - triangle[0]);
        for material in [Material::Masonry, Material::Timber, Material::Iron] {
            for upright in [false, true] {
                let courses = courses(material, 1.0).unwrap();
                let mut model = Model::default();
                courses.add(
                    triangle.map(|p| p.extend(1.0)),
                    1.0,
                    upright,
                    paint(0x808080),
                    &mut model,
                );
                let pieces = area(&model, 1.0 - 0.6 * GAP_DEPTH.max(courses.relief)) / whole;
                assert!((0.75..0.98).contains(&pieces), "{material:?}: {pieces}");
                let back = area(&model, 0.0) / whole - pieces;
                assert!((back - 1.0).abs() < 0.03, "{material:?}: {back}");
            }
        }
        assert!(courses(Material::Rock, 1.0).is_none());
    }
}
