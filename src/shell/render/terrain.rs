//! The level's solids as carved stone: faceted fronts with bevelled rims, and walls that run back into the depth.
//!
//! The plane of play is z = 0. Between [`FLAT_BACK`] and the rim the walls stand exactly on the outlines, so that the
//! picture shows what the mover stands on; further back they swell into the open, which makes ledges of floors and caves
//! of passages.

use super::courses::{Tone, courses};
use super::edging;
use super::facets::{Facets, Look, next};
use super::growth;
use super::inward::Inward;
use super::model::{Model, Paint, hash, paint};
use super::rims::Rims;
use super::seen;
use crate::game::Stage;
use crate::geom::Point;
use crate::level::{Feature, Material};
use crate::mesh::{Kind, Mesh};
use glam::{DVec2, Vec2, Vec3};

/// Depth of the fronts, and of the rim around them, in metres.
pub const FRONT: f32 = 0.75;
const RIM: f32 = 0.24;
/// Depth at which the walls end in front: what stands on the ground stands behind it.
pub const EDGE: f32 = FRONT - RIM;
/// Behind this depth the walls leave the outlines.
const FLAT_BACK: f32 = -0.9;
/// Where walls of rock are cut across, from front to back, and how far they swell there, in metres.
const ROCK: &[(f32, f32)] = &[
    (EDGE, 0.0),
    (FLAT_BACK, 0.0),
    (-2.6, 0.34),
    (-5.0, 0.9),
    (-8.5, 1.7),
];
/// The same for things that were built: straight, and no deeper than they would be.
const MASONRY: &[(f32, f32)] = &[(EDGE, 0.0), (FLAT_BACK, 0.0), (-2.4, 0.0)];
const SMALL: &[(f32, f32)] = &[(EDGE, 0.0), (-0.6, 0.0)];

/// In levels of more square metres than this, blocks and planks are larger.
const COURSED: f32 = 60_000.0;

/// A facet at the rim that is so many times broader than that belongs to the front, and so does one that reaches so many times
/// further inward: across a thin beam.
const WIDE: f32 = 1.7;
const ACROSS: f64 = 2.2;

/// Facets of rock that are narrower and longer than that, in metres, are lit as if they were upright: else they would be rays.
const SLIVER: (f32, f32) = (0.15, 0.6);

/// Ground of less friction than this looks slippery.
const SLIPPERY: f64 = 0.25;

/// Longest edges of facets, in metres, at the rim and within; larger where a level would need more than this many.
const FACET: (f64, f64) = (1.25, 2.6);
const MOST: f64 = 40_000.0;

/// By how much rock is less uneven deep within, and from which to which distance from the open, in metres.
const CALM: f32 = 0.7;
const CALMER: (f32, f32) = (1.5, 5.0);

/// Wet or frozen ground, on which nobody finds hold.
const SLICK: Paint = paint(0x9ccfdc).varied(0.03);

/// The colours of a look.
struct Palette {
    /// Faces that look up: moss, dust, worn planks.
    top: Paint,
    /// Fronts near the rim.
    face: Paint,
    /// Fronts deep within.
    deep: Paint,
    /// Walls and undersides.
    side: Paint,
    /// Where the walls are cut across.
    stations: &'static [(f32, f32)],
}

fn palette(look: Look) -> Palette {
    let colours = |[top, face, deep, side]: [u32; 4], stations| Palette {
        top: paint(top),
        face: paint(face),
        deep: paint(deep),
        side: paint(side),
        stations,
    };
    let palette = match look.material {
        Material::Rock => colours([0x8f9e62, 0x75788a, 0x31485f, 0x6f7286], ROCK),
        Material::Masonry => colours([0xb3a78c, 0xa0968e, 0x5a6272, 0x8b8486], MASONRY),
        Material::Timber => colours([0xbd9160, 0x92683f, 0x5c4433, 0x74533a], SMALL),
        Material::Iron => colours([0xb88462, 0x7d5c50, 0x4a4448, 0x5f4d4c], SMALL),
    };
    let top = if look.slick { SLICK } else { palette.top };
    let face = palette
        .face
        .towards(SLICK, if look.slick { 0.35 } else { 0.0 });
    Palette {
        top,
        face,
        ..palette
    }
}

/// How wide the rim of a look is, in metres: built things have sharper edges.
pub(super) fn rim(look: Look) -> f64 {
    match look.material {
        Material::Rock => f64::from(RIM),
        Material::Masonry => 0.15,
        Material::Timber | Material::Iron => 0.08,
    }
}

/// Depth of the front of what was built: its edges are bevelled evenly, so that thin beams stay flat.
fn built_front(look: Look) -> f32 {
    EDGE + rim(look) as f32
}

/// The solid faces of a mesh of outlines with the look of the last solid that covers them; but what is sunk in rock, or in
/// masonry, is not seen there: it stands in it, and no seam runs through it. Belts alone are let in flush.
pub fn solids(mesh: &Mesh, stage: &Stage) -> Vec<([Point; 3], Look)> {
    let look = |face| {
        let covers = mesh.cover(face).iter().rev();
        let solids = covers.filter(|&&id| mesh.kind_of(id) == Some(Kind::Solid));
        let features: Vec<&Feature> = solids.filter_map(|&id| stage.feature(id)).collect();
        let of = |material| features.iter().find(|f| f.material == material);
        let seen = match features.first() {
            Some(top) if top.conveyor != 0.0 => Some(top),
            top => of(Material::Rock).or(of(Material::Masonry)).or(top),
        };
        seen.map_or_else(Look::default, |feature| look_of(feature))
    };
    let solid = mesh.faces().filter(|&face| mesh.is_solid(face));
    seen::visible(solid.map(|face| (mesh.corners(face), look(face))).collect())
}

/// What a feature is to look like.
fn look_of(feature: &Feature) -> Look {
    let corners = || feature.outline.iter().map(|p| p.as_vec2());
    let (low, high) = (
        corners().fold(Vec2::INFINITY, Vec2::min),
        corners().fold(Vec2::NEG_INFINITY, Vec2::max),
    );
    Look {
        material: feature.material,
        slick: feature.friction.is_some_and(|friction| friction < SLIPPERY),
        upright: feature.material == Material::Timber && high.y - low.y > high.x - low.x,
    }
}

/// Builds the terrain of solid triangles.
pub fn build(solids: &[([Point; 3], Look)]) -> Model {
    let mut facets = Facets::new(solids);
    let (border, inner) = facet_sizes(&facets);
    let jitter = |p: DVec2| {
        let p = p.as_vec2().extend(0.0);
        DVec2::new(f64::from(hash(p, 3)), f64::from(hash(p, 4))) * 2.0 - 1.0
    };
    facets.refine(border, f64::INFINITY, jitter);
    let rims = Rims::of(&facets);
    rims.bend(&mut facets);
    facets.refine(f64::INFINITY, border.max(inner), jitter);
    let mut model = Model::default();
    add_front(&facets, &rims, &mut model);
    add_walls(&facets, &rims, &mut model);
    growth::add_grass(&facets, &mut model);
    model
}

/// Facets' longest edges at borders and within.
fn facet_sizes(facets: &Facets) -> (f64, f64) {
    let length = |e: usize| facets.ends(e).0.distance(facets.ends(e).1);
    let border: f64 = (0..facets.origin.len())
        .filter(|&e| facets.is_border(e))
        .map(length)
        .sum();
    (
        FACET.0.max(border / MOST),
        FACET.1.max((area(facets) / MOST).sqrt()),
    )
}

/// The area of all facets, in square metres.
fn area(facets: &Facets) -> f64 {
    let area = |t: usize| {
        let ((a, b), c) = (facets.ends(3 * t), facets.ends(3 * t + 2).0);
        (b - a).perp_dot(c - a) / 2.0
    };
    (0..facets.look.len()).map(area).sum()
}

/// The fronts: bent down at the rim; rock uneven within and in beds, what was built flat and in courses; darker and
/// cooler with the distance from the open.
fn add_front(facets: &Facets, rims: &Rims, model: &mut Model) {
    let depths = facets.depths();
    let inward = Inward::of(facets);
    let scale = (area(facets) as f32 / COURSED).sqrt().max(1.0);
    let at = |v: usize| facets.points[v].as_vec2();
    let is_seam = seams(facets);
    for t in 0..facets.look.len() {
        let vertices = [0, 1, 2].map(|i| facets.origin[3 * t + i]);
        let depth = vertices.map(|v| depths[v] as f32);
        let mean = depth.iter().sum::<f32>() / 3.0;
        let look = facets.look[t];
        let colours = palette(look);
        let is_rim = depth.contains(&0.0);
        let face = colours.face.towards(colours.deep, smooth(0.2, 5.0, mean));
        let place = |i: usize| {
            let p = at(vertices[i]);
            p.extend(front(p, depth[i], look, is_seam[vertices[i]]))
        };
        let corners = [0, 1, 2].map(place);
        let is_wide = breadth(vertices.map(at)) > WIDE * rim(look) as f32;
        let is_across = vertices.into_iter().any(|v| {
            let depth = |o: usize| rims.inward(v, facets.points[v], facets.points[o]);
            vertices.into_iter().map(depth).fold(0.0, f64::max) > ACROSS * rim(look)
        });
        let is_front = !is_rim || is_wide || is_across;
        if let (Some(courses), true) = (courses(look.material, scale), is_front) {
            let tone = Tone {
                face: colours.face,
                deep: colours.deep,
                inward: &inward,
            };
            courses.add(corners, look.upright, &tone, model);
            continue;
        }
        let flat = vertices.map(at);
        let normal = match breadth(flat) < SLIVER.0 && longest(flat) > SLIVER.1 {
            true => Vec3::Z,
            false => (corners[1] - corners[0])
                .cross(corners[2] - corners[0])
                .normalize_or_zero(),
        };
        if normal == Vec3::ZERO {
            continue;
        }
        let tinted = strata(face, (corners[0] + corners[1] + corners[2]) / 3.0);
        let shade = depth.map(|depth| 1.0 - 0.50 * smooth(0.0, 6.0, depth));
        let surface = weathered(tinted, &colours, normal);
        let surface = match is_rim {
            true => worn(surface, normal),
            false => surface,
        };
        model.facet_facing(normal, corners, shade, surface);
    }
    let masonry = Look {
        material: Material::Masonry,
        ..Look::default()
    };
    let paint = palette(masonry).face;
    edging::add(facets, rims, &inward, built_front(masonry), paint, model);
}

/// The depth of a front at a place so far from the open: what is nearer to it than the rim is wide lies on the rim's bevel; what
/// was built is flat, and so is rock where it meets that.
fn front(p: Vec2, depth: f32, look: Look, is_seam: bool) -> f32 {
    let rim = rim(look) as f32;
    let bevelled = EDGE + rim * (depth / rim).min(1.0);
    match look.material {
        Material::Rock if !is_seam => bevelled + relief(p, depth),
        _ => bevelled,
    }
}

/// Which vertices lie where two looks meet.
fn seams(facets: &Facets) -> Vec<bool> {
    let mut is_seam = vec![false; facets.points.len()];
    for e in (0..facets.origin.len()).filter(|&e| !facets.is_border(e)) {
        if facets.look[e / 3] != facets.look[facets.twin[e] / 3] {
            is_seam[facets.origin[e]] = true;
        }
    }
    is_seam
}

/// The least height of a triangle, in metres.
fn breadth([a, b, c]: [Vec2; 3]) -> f32 {
    (b - a).perp_dot(c - a) / longest([a, b, c]).max(f32::MIN_POSITIVE)
}

/// The longest side of a triangle, in metres.
fn longest([a, b, c]: [Vec2; 3]) -> f32 {
    a.distance(b).max(b.distance(c)).max(c.distance(a))
}

/// How far rock stands out at a depth from the open, in metres: beds of different hardness, and chance; less so deep within,
/// where nothing shall draw the eye.
fn relief(p: Vec2, depth: f32) -> f32 {
    let flat = p.extend(0.0);
    let bed = hash(Vec3::new(0.0, bed(flat), 0.0), 10) - 0.5;
    let wave = (p.x * 0.33 + 0.7 * (p.y * 0.41).sin()).sin();
    let uneven = 0.36 * (hash(flat, 5) - 0.5) + 0.34 * bed + 0.16 * wave;
    let quiet = 1.0 - CALM * smooth(CALMER.0, CALMER.1, depth);
    uneven * ((depth - RIM) / 1.4).clamp(0.0, 1.0) * quiet
}

/// An edge is worn, and catches the light where it looks up.
fn worn(base: Paint, normal: Vec3) -> Paint {
    Paint {
        colour: (base.colour * (1.05 + 0.17 * normal.y.max(0.0))).min(Vec3::ONE),
        ..base
    }
}

/// The walls: from the rims back into the depth.
fn add_walls(facets: &Facets, rims: &Rims, model: &mut Model) {
    let place = |v: usize, (z, swell): (f32, f32)| {
        let p = facets.points[v].as_vec2();
        let flat = p.extend(z);
        let amount = swell * (0.35 + 0.65 * hash(flat, 6));
        (p + rims.outward(v).as_vec2() * amount).extend(z - swell.min(1.0) * 0.8 * hash(flat, 7))
    };
    for e in 0..facets.origin.len() {
        let (a, b) = (facets.origin[e], facets.origin[next(e)]);
        let colours = palette(facets.look[e / 3]);
        let hidden = depth_behind(facets, e);
        for (station, pair) in colours.stations.windows(2).enumerate() {
            let [front, back] = [pair[0], pair[1]];
            if back.0 >= hidden {
                continue;
            }
            let corners = [(a, front), (a, back), (b, back), (b, front)];
            let dim = |further: usize| 1.0 - 0.17 * (station + further).saturating_sub(1) as f32;
            let shades = [(a, 0), (a, 1), (b, 1), (b, 0)];
            add_wall_piece(
                corners.map(|(v, station)| place(v, station)),
                shades.map(|(v, further)| rims.open(v) * dim(further)),
                &colours,
                model,
            );
        }
    }
}

/// How far back a wall on a half-edge is hidden by what lies on its other side: not at all by free space, for good by the
/// same material, else down to where the other material ends.
fn depth_behind(facets: &Facets, e: usize) -> f32 {
    if facets.is_border(e) {
        return f32::INFINITY;
    }
    let (this, other) = (facets.look[e / 3], facets.look[facets.twin[e] / 3]);
    let ends = palette(other)
        .stations
        .last()
        .map_or(0.0, |station| station.0);
    if this.material == other.material {
        f32::NEG_INFINITY
    } else {
        ends
    }
}

/// Two facets of a wall; the diagonal runs either way.
fn add_wall_piece(corners: [Vec3; 4], shades: [f32; 4], colours: &Palette, model: &mut Model) {
    let halves = if hash(corners[0] + corners[2], 8) < 0.5 {
        [[0, 1, 2], [0, 2, 3]]
    } else {
        [[0, 1, 3], [1, 2, 3]]
    };
    for half in halves {
        let triangle = half.map(|i| corners[i]);
        let normal = (triangle[1] - triangle[0])
            .cross(triangle[2] - triangle[0])
            .normalize_or_zero();
        let middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
        let surface = weathered(strata(colours.side, middle), colours, normal);
        // What recedes turns dark and cool, so that nobody takes it for the ground that is walked on.
        let receding = surface.towards(colours.deep, 0.6 * smooth(FLAT_BACK - 0.3, -7.0, middle.z));
        model.facet(triangle, half.map(|i| shades[i]), receding);
    }
}

/// Stone lies in beds of different tone, which dip a little.
fn strata(base: Paint, at: Vec3) -> Paint {
    let tone = hash(Vec3::new(0.0, bed(at), 0.0), 9) - 0.5;
    let warmth = Vec3::new(1.0 + 0.10 * tone, 1.0, 1.0 - 0.10 * tone);
    Paint {
        colour: base.colour * (1.0 + 0.20 * tone) * warmth,
        ..base
    }
}

/// The number of the bed that a place is in.
fn bed(at: Vec3) -> f32 {
    let height = at.y + at.x * 0.07 + (at.x * 0.21).sin() * 0.5;
    (height / 1.9).floor()
}

/// What looks up is overgrown or worn pale, what looks down stays dark.
fn weathered(base: Paint, colours: &Palette, normal: Vec3) -> Paint {
    let up = base.towards(colours.top, smooth(0.42, 0.72, normal.y));
    Paint {
        colour: up.colour * (1.0 - 0.35 * smooth(0.2, 0.9, -normal.y)),
        ..up
    }
}

/// 0 below `from`, 1 above `to`, without a bend at either.
pub(super) fn smooth(from: f32, to: f32, value: f32) -> f32 {
    let t = ((value - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::super::model::VERTEX_WORDS;
    use super::*;

    /// A slab from the origin to a corner, in metres.
    fn slab(width: i32, height: i32, material: Material) -> Vec<([Point; 3], Look)> {
        let p = |x: i32, y: i32| Point::new(x << 16, y << 16);
        let [a, b, c, d] = [p(0, 0), p(width, 0), p(width, height), p(0, height)];
        let look = Look {
            material,
            ..Look::default()
        };
        vec![([a, b, c], look), ([a, c, d], look)]
    }

    fn places(model: &Model) -> Vec<Vec3> {
        let place = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        model.words.chunks_exact(VERTEX_WORDS).map(place).collect()
    }

    #[test]
    fn near_the_plane_of_play_the_picture_ends_where_the_solid_ends() {
        let places = places(&build(&slab(20, 3, Material::Masonry)));
        assert!(places.len() > 500);
        for p in &places {
            let inside = (-1e-4..=20.0001).contains(&p.x) && (-1e-4..=3.0001).contains(&p.y);
            assert!(inside, "{p}");
        }
        // The top is there all the way, from the front edge to behind the hero.
        let top = |z: f32| {
            places
                .iter()
                .filter(|p| p.y == 3.0 && (p.z - z).abs() < 1e-4)
                .count()
        };
        assert!(top(EDGE) > 16 && top(FLAT_BACK) > 16);
    }

    #[test]
    fn rock_leaves_its_outline_only_in_the_depth() {
        let model = build(&slab(20, 3, Material::Rock));
        let beyond = |p: &&Vec3| p.y > 3.0001 && p.z < FLAT_BACK - 0.5;
        assert!(places(&model).iter().filter(beyond).count() > 20);
        // Grass alone grows above the ground in front.
        let high = |p: &Vec3| p.z > FLAT_BACK && p.y > 3.4;
        assert!(!places(&model).iter().any(high));
    }

    #[test]
    fn a_level_as_large_as_the_world_stays_within_bounds() {
        let model = build(&slab(4000, 4000, Material::Rock));
        assert!(places(&model).iter().all(|p| p.is_finite()));
        assert!(
            model.words.len() / VERTEX_WORDS < 2_000_000,
            "{}",
            model.words.len()
        );
    }

    #[test]
    fn a_wall_is_hidden_by_the_same_stone_and_open_to_the_air() {
        let right = slab(4, 3, Material::Timber)
            .into_iter()
            .map(|(corners, look)| (corners.map(|p| Point::new(p.x + (20 << 16), p.y)), look));
        let facets = Facets::new(
            &slab(20, 3, Material::Rock)
                .into_iter()
                .chain(right)
                .collect::<Vec<_>>(),
        );
        let behind: Vec<f32> = (0..facets.origin.len())
            .map(|e| depth_behind(&facets, e))
            .collect();
        let count = |depth: f32| behind.iter().filter(|&&behind| behind == depth).count();
        // Six borders; two diagonals, two sides each; between the materials each side ends where the other does.
        assert_eq!((count(f32::INFINITY), count(f32::NEG_INFINITY)), (6, 4));
        assert_eq!((count(SMALL[1].0), count(ROCK[4].0)), (1, 1));
    }
}
