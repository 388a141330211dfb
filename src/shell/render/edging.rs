//! Dressed stones along the outlines of masonry, at its walls long and short by turns: so that its ends and corners are made
//! of larger stones than its courses, and its outline reads.

use super::facets::{Facets, next};
use super::inward::Inward;
use super::model::{Model, Paint, hash};
use super::rims::Rims;
use super::terrain::rim;
use crate::level::Material;
use glam::{Vec2, Vec3};

/// How far short and long ones reach inwards, in metres; those along floors and ceilings, less steep than this, are all short.
const REACHES: [f32; 2] = [0.44, 0.78];
const STEEP: f64 = 0.7;
/// Metres along a wall after which they change.
const TURN: f32 = 1.1;
/// What is thinner than this share of a stone's reach has none.
const THIN: f32 = 0.8;
/// How far they stand out of the courses, and half of the gap between two.
const PROUD: f32 = 0.075;
const GAP: f32 = 0.022;
/// The shortest piece of an outline that has one, and the least share of its length that one has within.
const SHORTEST: f32 = 0.3;
const NARROWEST: f32 = 0.45;
/// How far, in metres, a long one may reach beyond its piece of the outline: at a hollow corner it would cover the short ones
/// that it meets.
const JUTS: f32 = 0.15;
/// The least cosine of half a corner's turn up to which ends are mitred.
const SHARPEST: f64 = 0.6;
/// How much brighter than the courses they are, and how much they differ.
const BRIGHTER: f32 = 1.10;
const VARIETY: f32 = 0.07;
/// Brightness at their lower ends, where the upper ones have 1.
const LOWER: f32 = 0.84;

/// Adds the stones of all masonry; `front` is the depth of its front.
pub fn add(
    facets: &Facets,
    rims: &Rims,
    inward: &Inward,
    front: f32,
    paint: Paint,
    model: &mut Model,
) {
    let masonry = |e: &usize| facets.look[e / 3].material == Material::Masonry;
    let mut is_seam = vec![false; facets.points.len()];
    for e in (0..facets.origin.len()).filter(|e| !masonry(e)) {
        is_seam[facets.origin[e]] = true;
    }
    let borders = (0..facets.origin.len()).filter(|&e| facets.is_border(e));
    for e in borders.filter(masonry) {
        let Some([a, b, c, d]) = stone(facets, rims, &is_seam, inward, e) else {
            continue;
        };
        let seed = ((a + b) / 2.0).extend(front);
        let paint = Paint {
            colour: paint.colour * BRIGHTER * (1.0 + 2.0 * VARIETY * (hash(seed, 500) - 0.5)),
            ..paint.varied(0.0)
        };
        let (low, high) = [b, c, d]
            .iter()
            .fold((a.y, a.y), |(low, high), p| (low.min(p.y), high.max(p.y)));
        let corner = |p: Vec2| p.extend(front + PROUD);
        let light = |p: Vec2| LOWER + (1.0 - LOWER) * (p.y - low) / (high - low).max(SHORTEST);
        for part in [[a, b, c], [a, c, d]] {
            model.facet_facing(Vec3::Z, part.map(corner), part.map(light), paint);
        }
    }
}

/// The corners of the stone on a piece of border, counter-clockwise; nothing where there is no room for one. Its ends are
/// mitred, but not at a seam, where something else than masonry begins.
fn stone(
    facets: &Facets,
    rims: &Rims,
    is_seam: &[bool],
    inward: &Inward,
    e: usize,
) -> Option<[Vec2; 4]> {
    let (a, b) = facets.ends(e);
    let normal = -(b - a).normalize_or_zero().perp();
    let [from, to] = [a, b].map(|p| p.as_vec2());
    let mitred = |v: usize| {
        let outward = if is_seam[v] { normal } else { rims.outward(v) };
        (outward / normal.dot(outward).max(SHARPEST)).as_vec2()
    };
    let [out_a, out_b] = [e, next(e)].map(|e| mitred(facets.origin[e]));
    let middle = (from + to) / 2.0;
    let is_turn = ((middle.y / TURN).floor() as i32).rem_euclid(2) == 0;
    let [short, long] = REACHES;
    let wanted = match normal.x.abs() > STEEP && is_turn {
        true => long,
        false => short,
    };
    let along = (to - from).normalize_or_zero();
    let gap = along * GAP;
    let outer = rim(facets.look[e / 3]) as f32 + GAP;
    let stone = |reach: f32| {
        let corners = [
            from - out_a * outer + gap,
            to - out_b * outer - gap,
            to - out_b * reach - gap,
            from - out_a * reach + gap,
        ];
        let length = |i: usize, j: usize| (corners[j] - corners[i]).dot(along);
        let is_whole = length(0, 1) > 0.0 && length(3, 2) > length(0, 1) * NARROWEST;
        let has_room = inward.at(middle - normal.as_vec2() * reach) > reach * THIN;
        let juts = reach > short && (length(1, 2) > JUTS || length(3, 0) > JUTS);
        (is_whole && has_room && !juts).then_some(corners)
    };
    let long_enough = from.distance(to) > SHORTEST;
    [wanted, short]
        .into_iter()
        .filter(|_| long_enough)
        .find_map(stone)
}

#[cfg(test)]
mod tests {
    use super::super::facets::Look;
    use super::super::model::{VERTEX_WORDS, paint};
    use super::*;
    use crate::geom::Point;
    use glam::DVec2;

    /// The corners of the stones of a slab of so many metres.
    fn stones(width: i32, height: i32, material: Material) -> Vec<Vec3> {
        let p = |x: i32, y: i32| Point::new(x << 16, y << 16);
        let [a, b, c, d] = [p(0, 0), p(width, 0), p(width, height), p(0, height)];
        let look = Look {
            material,
            ..Look::default()
        };
        let mut facets = Facets::new(&[([a, b, c], look), ([a, c, d], look)]);
        facets.refine(1.25, f64::INFINITY, |_| DVec2::ZERO);
        let mut model = Model::default();
        let (rims, inward) = (Rims::of(&facets), Inward::of(&facets));
        add(&facets, &rims, &inward, 0.6, paint(0x808080), &mut model);
        let place = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        model.words.chunks_exact(VERTEX_WORDS).map(place).collect()
    }

    #[test]
    fn masonry_alone_has_stones_along_its_outline_and_within_it() {
        assert!(stones(12, 5, Material::Rock).is_empty());
        let corners = stones(12, 5, Material::Masonry);
        assert!(corners.len() > 20 * 6, "{}", corners.len());
        let most = REACHES[1] * 1.01;
        for p in &corners {
            let [x, y] = [p.x.min(12.0 - p.x), p.y.min(5.0 - p.y)];
            assert!(x.min(y) > 0.1 && x.min(y) < most, "{p}");
        }
        let reached = |far: fn(&Vec3) -> f32, reach: f32| {
            corners.iter().any(|p| (far(p) - reach).abs() < 0.01)
        };
        assert!(
            reached(|p| p.y, REACHES[0]) && !reached(|p| p.y, REACHES[1]),
            "floor"
        );
        assert!(reached(|p| p.x, REACHES[1]), "long ones at walls");
    }

    #[test]
    fn stones_that_meet_in_a_hollow_corner_reach_alike() {
        let p = |x: i32, y: i32| Point::new(x << 16, y << 16);
        let look = Look {
            material: Material::Masonry,
            ..Look::default()
        };
        // An L: its hollow corner is at (6, 2), under a wall of 5 m that begins with a long one.
        let [a, b, c, d, e, f, g] =
            [(0, 0), (12, 0), (12, 2), (6, 2), (6, 7), (0, 7), (6, 0)].map(|(x, y)| p(x, y));
        let triangles = [[a, g, d], [g, b, c], [g, c, d], [a, d, f], [d, e, f]];
        let mut facets = Facets::new(&triangles.map(|triangle| (triangle, look)));
        facets.refine(1.25, f64::INFINITY, |_| DVec2::ZERO);
        let (rims, inward) = (Rims::of(&facets), Inward::of(&facets));
        let mut model = Model::default();
        add(&facets, &rims, &inward, 0.6, paint(0x808080), &mut model);
        let places = model.words.chunks_exact(VERTEX_WORDS);
        let places = places.map(|v| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i]))));
        let deepest = places.filter(|p| p.x > 3.0 && p.x < 6.5 && p.y > 1.0 && p.y < 2.0);
        let lowest = deepest.map(|p| p.y).fold(2.0, f32::min);
        assert!((2.0 - lowest - REACHES[0]).abs() < 0.05, "{lowest}");
    }
}
