//! What features are seen as that are no plain solids: planks, ladders, vines, belts, spikes, checkpoints, triggers.
//!
//! Each shows in the plane of play where it begins and ends to the mover; what it looks like there tells what it does.

use super::frame::PointLight;
use super::model::{Model, Paint, hash, paint};
use super::scenery;
use super::terrain::EDGE;
use crate::level::{Feature, Kind, Material};
use glam::{Mat4, Vec2, Vec3};

/// How far planks and belts reach back, in metres.
const BACK: f32 = -0.85;
/// Where ladders stand, just behind the hero.
const BEHIND: f32 = -0.5;

const PLANK: Paint = paint(0xa47d52).varied(0.16);
const GRATE: Paint = paint(0x7d6258).varied(0.10);
const RAIL: Paint = paint(0x6d4d36).varied(0.10);
const IRON: Paint = paint(0x4b4d55).varied(0.08);
const VINE: Paint = paint(0x4c6b3c).varied(0.15);
const LEAF: Paint = paint(0x7fa35a).varied(0.30);
const THORN: Paint = paint(0x3b2f3a).varied(0.12);
const TIP: Paint = paint(0xe0563c).glowing(0.35);
const ARROW: Paint = paint(0xf2b552).glowing(0.55);
const EYE: Paint = paint(0x7ff0e0).glowing(0.8);
const SLAB: Paint = paint(0x8d8a8e).varied(0.08);

/// Builds what is to be seen of features beside their solids.
pub fn build<'a>(features: impl Iterator<Item = &'a Feature>) -> (Model, Vec<PointLight>) {
    let (mut model, mut lamps) = (Model::default(), Vec::new());
    for feature in features {
        match feature.kind {
            Kind::Solid => solid(feature, &mut model),
            Kind::OneWay => planks(feature, &mut model),
            Kind::Ladder => ladder(feature, &mut model),
            Kind::Hazard => spikes(feature, &mut model),
            Kind::Checkpoint => lamps.extend(checkpoint(feature, &mut model)),
            Kind::Trigger => lamps.push(trigger(feature, &mut model)),
            Kind::Secret => {} // what is hidden there is scenery
            Kind::Goal if feature.id.is_empty() => {} // the goal box has its gate
            Kind::Goal => {
                let (min, max) = bounds(feature);
                let foot = Vec3::new((min.x + max.x) / 2.0, min.y, -0.9);
                model.add(&scenery::gate(), Mat4::from_translation(foot));
            }
        }
    }
    (model, lamps)
}

/// Corners as pairs, each edge with the outside on its right.
fn edges(feature: &Feature) -> Vec<(Vec2, Vec2)> {
    let corners: Vec<Vec2> = feature.outline.iter().map(|p| p.as_vec2()).collect();
    let n = corners.len();
    let all = (0..n).map(|i| (corners[i], corners[(i + 1) % n]));
    let area: f32 = all.clone().map(|(a, b)| a.perp_dot(b)).sum();
    match area >= 0.0 {
        true => all.collect(),
        false => all.map(|(a, b)| (b, a)).collect(),
    }
}

fn bounds(feature: &Feature) -> (Vec2, Vec2) {
    let corners = feature.outline.iter().map(|p| p.as_vec2());
    corners.fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(min, max), p| {
        (min.min(p), max.max(p))
    })
}

/// A place on the edge from a to b.
fn on(a: Vec2, b: Vec2, share: f32, z: f32) -> Vec3 {
    a.lerp(b, share).extend(z)
}

/// Arrows along belts, leaves on walls that can be climbed.
fn solid(feature: &Feature, model: &mut Model) {
    for (a, b) in edges(feature) {
        let along = (b - a).normalize_or_zero();
        let outward = -along.perp();
        if feature.conveyor != 0.0 && outward.y > 0.5 {
            belt(a, b, feature.conveyor as f32, model);
        }
        if feature.climbable && outward.y.abs() < 0.7 {
            vines(a, b, outward, model);
        }
    }
}

/// A worn black band with arrows in front, that point where it runs.
fn belt(a: Vec2, b: Vec2, speed: f32, model: &mut Model) {
    let (a, b) = if a.x < b.x { (a, b) } else { (b, a) };
    let up = Vec2::new(0.0, 0.02);
    let corners = [(a, EDGE), (b, EDGE), (b, BACK), (a, BACK)];
    model.quad(corners.map(|(p, z)| (p + up).extend(z)), IRON);
    let count = (a.distance(b) / 0.75).max(1.0) as u32;
    for i in 0..count {
        let middle = on(a, b, (i as f32 + 0.5) / count as f32, 0.8) - Vec3::Y * 0.26;
        let (x, y) = (0.2 * speed.signum(), 0.13);
        let tip = middle + Vec3::X * x;
        let [high, low] = [y, -y].map(|y| middle + Vec3::new(-x, y, 0.0));
        let corners = if x > 0.0 {
            [tip, high, low]
        } else {
            [tip, low, high]
        };
        model.facet(corners, [1.0; 3], ARROW);
    }
}

/// Stems up a wall, leaves to both sides and into the open.
fn vines(a: Vec2, b: Vec2, outward: Vec2, model: &mut Model) {
    for stem in 0..3 {
        let z = 0.3 - 0.42 * stem as f32;
        let from = on(a, b, 0.0, z) + outward.extend(0.0) * 0.03;
        let to = on(a, b, 1.0, z) + outward.extend(0.0) * 0.03;
        model.beam(from, to, 0.035, VINE);
        let count = (a.distance(b) / 0.16) as u32;
        for leaf in 0..count {
            let root = from.lerp(to, (leaf as f32 + 0.5) / count as f32);
            let chance = |salt: u32| hash(root, 200 + salt) - 0.5;
            let size = 0.2 + 0.12 * chance(0);
            let out = outward.extend(0.0) * (0.1 + 0.1 * chance(1));
            let aside = Vec3::new(0.0, 0.5 * chance(2), chance(3)).normalize_or_zero() * size;
            let tip = root + out + aside - Vec3::Y * 0.08;
            let broad = out.cross(aside).normalize_or_zero() * 0.07;
            model.blade([root - broad, root + broad, tip], LEAF);
            model.blade([root + broad, root - broad, tip], LEAF);
        }
    }
}

/// Boards on two runners; of iron, a grate.
fn planks(feature: &Feature, model: &mut Model) {
    let (board, runner) = match feature.material {
        Material::Iron => (GRATE, IRON),
        Material::Rock | Material::Masonry | Material::Timber => (PLANK, RAIL),
    };
    let corners: Vec<Vec2> = feature.outline.iter().map(|p| p.as_vec2()).collect();
    for pair in corners.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let down = Vec3::from(((b - a).normalize_or_zero().perp() * -0.09, 0.0));
        let count = (a.distance(b) / 0.36).round().max(1.0);
        for i in 0..count as u32 {
            let share = |end: f32| (i as f32 + end) / count;
            let (from, to) = (on(a, b, share(0.06), 0.0), on(a, b, share(0.94), 0.0));
            let ring = |z: f32| {
                let z = Vec3::Z * (z + 0.06 * (hash(from, 210) - 0.5));
                [from + down + z, to + down + z, to + z, from + z]
            };
            let (front, back) = (ring(EDGE - 0.06), ring(BACK));
            model.cap(&front, board);
            model.band(&back, &front, board);
        }
        for z in [EDGE - 0.22, BACK + 0.2] {
            let at = |p: Vec2| p.extend(z) + down * 1.8;
            model.beam(at(a), at(b), 0.055, runner);
        }
    }
}

/// Two rails and rungs, as wide and high as the outline's box.
fn ladder(feature: &Feature, model: &mut Model) {
    let paint = match feature.material {
        Material::Iron => IRON,
        Material::Rock | Material::Masonry | Material::Timber => RAIL,
    };
    let (min, max) = bounds(feature);
    let inset = 0.08f32.min((max.x - min.x) / 4.0);
    for x in [min.x + inset, max.x - inset] {
        let (foot, top) = (Vec2::new(x, min.y), Vec2::new(x, max.y));
        model.beam(foot.extend(BEHIND), top.extend(BEHIND), 0.055, paint);
    }
    let count = ((max.y - min.y) / 0.34) as u32;
    for i in 0..count {
        let y = min.y + 0.34 * (i as f32 + 0.6);
        let [a, b] = [min.x, max.x].map(|x| Vec3::new(x, y, BEHIND + 0.03));
        model.beam(a, b, 0.035, PLANK);
    }
}

/// Rows of thorns, as high as the outline's box.
fn spikes(feature: &Feature, model: &mut Model) {
    let (min, max) = bounds(feature);
    let count = ((max.x - min.x) / 0.42).max(1.0) as u32;
    for i in 0..count {
        for (row, z) in [0.25f32, -0.25, -0.7].into_iter().enumerate() {
            let x = min.x + (max.x - min.x) * (i as f32 + 0.5) / count as f32;
            let foot = Vec3::new(x + 0.1 * row as f32 - 0.1, min.y, z);
            let height = (max.y - min.y) * (0.75 + 0.25 * hash(foot, 220));
            let (waist, radius) = (height * 0.72, 0.15);
            model.lathe(foot, 5, &[(0.0, radius), (waist, radius * 0.3)], THORN);
            model.lathe(foot, 5, &[(waist, radius * 0.3), (height, 0.0)], TIP);
        }
    }
}

/// A lantern with a banner where the hero comes back.
fn checkpoint(feature: &Feature, model: &mut Model) -> Option<PointLight> {
    let foot = feature.respawn?.as_vec2().extend(-0.6);
    model.add(&scenery::checkpoint(), Mat4::from_translation(foot));
    Some(PointLight {
        at: foot + Vec3::new(0.42, 2.0, 0.35),
        reach: 8.0,
        colour: Vec3::new(2.4, 1.5, 0.8),
    })
}

/// A stone with an eye, on the lower edge of the outline's box.
fn trigger(feature: &Feature, model: &mut Model) -> PointLight {
    let (min, max) = bounds(feature);
    let foot = Vec3::new((min.x + max.x) / 2.0, min.y, BEHIND);
    let half = ((max.x - min.x) / 2.0).max(0.1);
    model.block(foot, (half, 0.3), (half * 0.92, 0.26), 0.07, SLAB);
    model.block(foot, (0.24, 0.2), (0.18, 0.15), 1.0, SLAB);
    let stone = [(0.0, 0.0), (0.16, 0.14), (0.36, 0.0)];
    model.lathe(foot + Vec3::Y * 1.06, 6, &stone, EYE);
    PointLight {
        at: foot + Vec3::new(0.0, 1.2, 0.5),
        reach: 5.0,
        colour: Vec3::new(0.2, 1.1, 1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::super::model::VERTEX_WORDS;
    use super::*;
    use glam::DVec2;

    fn places(kind: Kind, climbable: bool) -> Vec<Vec3> {
        let feature = Feature {
            kind,
            climbable,
            outline: [(2.0, 1.0), (5.0, 1.0), (5.0, 4.0), (2.0, 4.0)]
                .map(DVec2::from)
                .to_vec(),
            respawn: Some(DVec2::new(3.0, 1.0)),
            ..Feature::default()
        };
        let (model, _) = build(std::iter::once(&feature));
        let place = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        model.words.chunks_exact(VERTEX_WORDS).map(place).collect()
    }

    #[test]
    fn whatever_a_body_can_meet_is_seen_and_stays_near_its_outline() {
        for kind in [Kind::OneWay, Kind::Ladder, Kind::Hazard, Kind::Trigger] {
            let places = places(kind, false);
            assert!(places.len() > 30, "{kind:?}");
            for p in places {
                let near = (1.7..=5.3).contains(&p.x) && (0.7..=4.3).contains(&p.y);
                assert!(near && p.z < EDGE + 0.1, "{kind:?}: {p}");
            }
        }
        assert!(places(Kind::Checkpoint, false).len() > 100);
    }

    #[test]
    fn vines_grow_on_walls_that_can_be_climbed_and_on_no_others() {
        assert!(places(Kind::Solid, false).is_empty());
        let leaves = places(Kind::Solid, true);
        assert!(leaves.len() > 300);
        assert!(leaves.iter().all(|p| p.x < 2.2 || p.x > 4.8));
    }
}
