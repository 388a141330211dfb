//! Fronts of what was built: courses of dressed blocks, planks, riveted plates, each cut to the outline.
//!
//! A front is flat, and is lit as such also where it bends to a rim. Its triangles are cut by a grid of pieces with gaps between them; what shows in the gaps lies a little
//! deeper and is dark.

use super::inward::Inward;
use super::model::{Model, Paint, hash};
use super::terrain::smooth;
use crate::level::Material;
use glam::{Vec2, Vec3};

/// How pieces lie.
pub struct Courses {
    /// Height of a course and length of a piece in it, in metres.
    size: Vec2,
    /// How much higher than that the courses are, and how much longer their pieces, over and over again.
    rows: &'static [f32],
    /// Width of the gaps.
    gap: f32,
    /// How far pieces stand out differently.
    relief: f32,
    /// How much they differ in brightness.
    variety: f32,
    /// Whether rivets hold them.
    riveted: bool,
    /// Whether patches of it are rendered, and others stained.
    weathered: bool,
}

/// The rows of what is even, and of masonry; the sum is their number.
const EVEN: &[f32] = &[1.0];
const UNEVEN: &[f32] = &[1.0, 0.78, 1.24, 0.88, 1.1];
/// How deep the gaps are, in metres.
const GAP_DEPTH: f32 = 0.07;
/// Brightness at the lower edge of a piece, where the upper edge has 1.
const LOWER_EDGE: f32 = 0.74;
/// Half width and height of a rivet, and how far it is from the corners of its plate.
const RIVET: (f32, f32) = (0.06, 0.06);
const RIVET_INSET: f32 = 0.2;
/// The open leaves a wall quiet from this far on, in metres; how much of their differences its pieces lose there.
const QUIET: f32 = 3.5;
const CALM: f32 = 0.65;
/// How dark gaps are: near the open, and where it is quiet.
const GAPS: [f32; 2] = [0.42, 0.72];
/// Patches: what of the waves over a wall is render, and what is stained; their colour, and how much of it they have.
const RENDER: f32 = 1.2;
const STAIN: f32 = -1.05;
const RENDERED: Paint = super::model::paint(0xa89a88);
const STAINED: f32 = 0.80;

/// How pieces of a material lie, so many times larger than usual; nothing for what was not built.
pub fn courses(material: Material, scale: f32) -> Option<Courses> {
    let courses = |size: Vec2, rows, gap, relief, variety, riveted| Courses {
        size: size * scale,
        rows,
        gap,
        relief,
        variety,
        riveted,
        weathered: material == Material::Masonry,
    };
    match material {
        Material::Rock => None,
        Material::Masonry => {
            let size = Vec2::new(1.75, 0.84);
            Some(courses(size, UNEVEN, 0.06, 0.10, 0.20, false))
        }
        Material::Timber => Some(courses(
            Vec2::new(2.8, 0.34),
            EVEN,
            0.045,
            0.06,
            0.26,
            false,
        )),
        Material::Iron => Some(courses(
            Vec2::new(1.60, 1.25),
            EVEN,
            0.045,
            0.03,
            0.14,
            true,
        )),
    }
}

/// What a front looks like by how far its places are from the open: no triangle of it is seen in that.
pub struct Tone<'a> {
    /// Near the open.
    pub face: Paint,
    /// Deep within.
    pub deep: Paint,
    /// How far places are from it.
    pub inward: &'a Inward,
}

impl Tone<'_> {
    fn paint(&self, p: Vec2) -> Paint {
        let share = smooth(0.2, 5.0, self.inward.at(p));
        self.face.towards(self.deep, share)
    }

    /// How open to the light a place is.
    fn shade(&self, p: Vec2) -> f32 {
        1.0 - 0.45 * smooth(0.0, 7.0, self.inward.at(p))
    }

    /// 0 at the open, 1 where a wall is quiet.
    fn quiet(&self, p: Vec2) -> f32 {
        smooth(0.4, QUIET, self.inward.at(p))
    }
}

/// What a piece shows.
#[derive(Clone, Copy, PartialEq)]
enum Patch {
    Bare,
    Rendered,
    Stained,
}

impl Courses {
    /// Adds the front of a triangle, counter-clockwise seen from before it.
    pub fn add(&self, triangle: [Vec3; 3], upright: bool, tone: &Tone, model: &mut Model) {
        let joint = Paint {
            colour: tone.face.towards(tone.deep, 0.4).colour,
            ..tone.face.varied(0.0)
        };
        let dark = |p: Vec3| {
            let p = p.truncate();
            tone.shade(p) * (GAPS[0] + (GAPS[1] - GAPS[0]) * tone.quiet(p))
        };
        let back = triangle.map(|p| p - Vec3::Z * GAP_DEPTH);
        model.facet_facing(Vec3::Z, back, triangle.map(dark), joint);
        let local = triangle.map(|p| turned(p.truncate(), upright));
        let front = Front {
            triangle,
            local,
            upright,
            tone,
        };
        let (low, high) = local
            .iter()
            .fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), p| {
                (low.min(*p), high.max(*p))
            });
        let mut row = self.row(low.y);
        while self.bottom(row) < high.y {
            let length = self.size.x * self.height(row) / self.size.y;
            let joint = |n: i32| self.joint(row, n, length);
            let first = (low.x / length).floor() as i32 - 1;
            let last = (high.x / length).ceil() as i32 + 1;
            for n in first..last {
                let (left, right) = (joint(n), joint(n + 1));
                if right > low.x && left < high.x {
                    let piece = Piece {
                        min: Vec2::new(left, self.bottom(row)),
                        max: Vec2::new(right, self.bottom(row + 1)),
                        seed: Vec3::new(n as f32, row as f32, 5.0),
                    };
                    self.add_piece(piece, &front, model);
                }
            }
            row += 1;
        }
    }

    /// The height of a course, in metres.
    fn height(&self, row: i32) -> f32 {
        self.size.y * self.rows[row.rem_euclid(self.rows.len() as i32) as usize]
    }

    /// Where a course begins.
    fn bottom(&self, row: i32) -> f32 {
        let count = self.rows.len() as i32;
        let first = row.div_euclid(count) * count;
        let below: f32 = (first..row).map(|row| self.height(row)).sum();
        first as f32 * self.size.y + below
    }

    /// The course at a height.
    fn row(&self, y: f32) -> i32 {
        let count = self.rows.len() as i32;
        let first = (y / (self.size.y * count as f32)).floor() as i32 * count;
        let after = (first..first + count).find(|row| self.bottom(row + 1) > y);
        after.unwrap_or(first + count)
    }

    /// Where the joint before a piece is: courses are shifted against each other, and no piece has the length of its
    /// neighbour.
    fn joint(&self, row: i32, n: i32, length: f32) -> f32 {
        let shift = 0.5 * (row.rem_euclid(2)) as f32;
        let uneven = 0.40 * (hash(Vec3::new(n as f32, row as f32, 6.0), 400) - 0.5);
        (n as f32 + shift + uneven) * length
    }

    /// What a piece shows: waves of several metres over the wall decide.
    fn patch(&self, at: Vec2, quiet: f32) -> Patch {
        let wave = (at.x * 0.31 + 1.7 * (at.y * 0.23).sin()).sin()
            + (at.y * 0.37 + 1.3 * (at.x * 0.19).sin()).sin();
        match wave {
            _ if !self.weathered => Patch::Bare,
            _ if wave > RENDER && quiet > 0.0 => Patch::Rendered,
            _ if wave < STAIN => Patch::Stained,
            _ => Patch::Bare,
        }
    }

    /// The part of a piece that lies in a triangle.
    fn add_piece(&self, piece: Piece, front: &Front, model: &mut Model) {
        let middle = front.place((piece.min + piece.max) / 2.0, 0.0).truncate();
        let quiet = front.tone.quiet(middle);
        let patch = self.patch(middle, quiet);
        let piece = match patch {
            Patch::Rendered => piece,
            Patch::Bare | Patch::Stained => piece.within(self.gap / 2.0),
        };
        let outline = piece.cut(front.local);
        if outline.len() < 3 {
            return;
        }
        let alive = match patch {
            Patch::Rendered => 0.2,
            Patch::Bare | Patch::Stained => 1.0 - CALM * quiet,
        };
        let chance = |salt: u32| (hash(piece.seed, 401 + salt) - 0.5) * alive;
        let out = self.relief * chance(0);
        let warmth = Vec3::new(1.0 + 0.10 * chance(2), 1.0, 1.0 - 0.10 * chance(2));
        let base = front.tone.paint(middle);
        let base = match patch {
            Patch::Bare => base.colour,
            Patch::Rendered => base.towards(RENDERED, 0.5).colour,
            Patch::Stained => base.colour * STAINED,
        };
        let paint = Paint {
            colour: base * (1.0 + 2.0 * self.variety * chance(1)) * warmth,
            ..front.tone.face.varied(0.0)
        };
        let lower = match patch {
            Patch::Rendered => 1.0,
            Patch::Bare | Patch::Stained => LOWER_EDGE,
        };
        let light = |p: Vec2| {
            let share = (p.y - piece.min.y) / (piece.max.y - piece.min.y);
            let at = front.place(p, 0.0).truncate();
            front.tone.shade(at) * (lower + (1.0 - lower) * share.clamp(0.0, 1.0))
        };
        for i in 2..outline.len() {
            let part = [outline[0], outline[i - 1], outline[i]];
            let places = part.map(|p| front.place(p, out));
            model.facet_facing(Vec3::Z, places, part.map(light), paint);
        }
        if self.riveted {
            let held = piece.corners(RIVET_INSET).into_iter();
            for at in held.filter(|p| is_inside(front.local, *p, RIVET.0)) {
                let ring = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                let ring = ring.map(|(x, y)| front.place(at + Vec2::new(x, y) * RIVET.0, out));
                let tip = front.place(at, out + RIVET.1);
                for i in 0..4 {
                    let sides = [ring[i], ring[(i + 1) % 4], tip];
                    model.facet(sides, [light(at); 3], paint);
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
struct Front<'a> {
    triangle: [Vec3; 3],
    /// As the courses have it.
    local: [Vec2; 3],
    upright: bool,
    tone: &'a Tone<'a>,
}

impl Front<'_> {
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
    /// The same without a margin.
    fn within(self, margin: f32) -> Piece {
        Piece {
            min: self.min + margin,
            max: self.max - margin,
            ..self
        }
    }

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
                let tone = Tone {
                    face: paint(0x808080),
                    deep: paint(0x404040),
                    inward: &Inward::default(),
                };
                courses.add(triangle.map(|p| p.extend(1.0)), upright, &tone, &mut model);
                let pieces = area(&model, 1.0 - 0.6 * GAP_DEPTH.max(courses.relief)) / whole;
                assert!((0.75..0.98).contains(&pieces), "{material:?}: {pieces}");
                let back = area(&model, 0.0) / whole - pieces;
                assert!((back - 1.0).abs() < 0.03, "{material:?}: {back}");
            }
        }
        assert!(courses(Material::Rock, 1.0).is_none());
    }

    #[test]
    fn every_height_has_its_course_and_every_course_follows_on_the_one_before() {
        let courses = courses(Material::Masonry, 1.0).unwrap();
        for step in -400..400 {
            let y = step as f32 * 0.07;
            let row = courses.row(y);
            let (bottom, top) = (courses.bottom(row), courses.bottom(row + 1));
            assert!(
                bottom <= y + 1e-4 && y < top + 1e-4,
                "{y}: {bottom} to {top}"
            );
            assert!((top - bottom - courses.height(row)).abs() < 1e-4);
        }
    }
}
