//! What features are seen as that are no plain solids: planks, ladders, vines, belts, lodestones, gates, triggers.
//!
//! Each shows in the plane of play where it begins and ends to the mover; what it looks like there tells what it does.

use super::dangers;
use super::frame::PointLight;
use super::kit::{Kit, Part};
use super::model::{Model, Paint, hash, paint};
use super::seen::unburied;
use super::shards::{DIM, Shards};
use super::terrain::EDGE;
use crate::level::{Feature, Kind, Level, Material};
use glam::{Mat4, Vec2, Vec3, vec3};

/// How far planks and belts reach back, in metres.
const BACK: f32 = -0.85;
/// About how far a belt's arrows are from each other, and how far before the plane of play.
const ARROW_GAP: f32 = 0.9;
const ARROW_DEPTH: f32 = 0.84;
/// Half the length and half the height of their chevrons, and their height and that of the skirt that they are painted on, both
/// from the band down, in metres.
const CHEVRON: [f32; 2] = [0.2, 0.15];
const PAINTED: f32 = 0.26;
const SKIRTS: [f32; 2] = [0.07, 0.45];
/// Where ladders stand, just behind the hero.
const BEHIND: f32 = -0.5;
/// Where lodestones and gates stand, behind the hero.
const STONES: f32 = -0.85;
const GATE: f32 = -1.1;
/// Width of the vines that hang over the front of a wall that can be climbed, and their depth, just before the rim.
const DRAPE: f32 = 0.62;
const DRAPED: f32 = 0.66;
/// Width of the iron chain and of the ladder, in metres, where the feature is wider.
const WIDEST: f32 = 1.5;

const PLANK: Paint = paint(0xa47d52).varied(0.16);
const GRATE: Paint = paint(0x7d6258).varied(0.10);
const RAIL: Paint = paint(0x6d4d36).varied(0.10);
const IRON: Paint = paint(0x4b4d55).varied(0.08);
const SKIRT: Paint = paint(0x37343a).varied(0.06);
const CHALK: Paint = paint(0xcfc2a2).varied(0.06);

/// What is built of features.
#[derive(Default)]
pub struct Built {
    /// Their triangles.
    pub model: Model,
    /// Their lamps.
    pub lamps: Vec<PointLight>,
}

/// Builds what is to be seen of features beside their solids; what floats goes to the shards.
pub fn build(kit: &Kit, features: &[&Feature], shards: &mut Shards) -> Built {
    let mut built = Built::default();
    for feature in features {
        match feature.kind {
            Kind::Solid => solid(kit, feature, features, &mut built.model),
            Kind::OneWay => planks(feature, &mut built.model),
            Kind::Ladder => ladder(kit, feature, &mut built.model),
            Kind::Hazard => {
                let Built { model, lamps } = &mut built;
                dangers::build(kit, feature, features, model, lamps);
            }
            Kind::Checkpoint => checkpoint(kit, feature, &mut built, shards),
            Kind::Trigger => trigger(kit, feature, &mut built),
            Kind::Secret => {} // what is hidden there is scenery
            Kind::Goal if feature.id.is_empty() => {} // the goal box has its gate
            Kind::Goal => {
                let (min, max) = bounds(feature);
                gate(
                    kit,
                    Vec2::new((min.x + max.x) / 2.0, min.y),
                    &mut built,
                    shards,
                );
            }
        }
    }
    built
}

/// The gate of a level's goal box.
pub fn goal(kit: &Kit, level: &Level, shards: &mut Shards) -> Built {
    let mut built = Built::default();
    let middle = (level.goal.min.x + level.goal.max.x) / 2.0;
    let foot = Vec2::new(middle as f32, level.goal.min.y as f32);
    gate(kit, foot, &mut built, shards);
    built
}

/// Corners as pairs, each edge with the outside on its right.
pub fn edges(feature: &Feature) -> Vec<(Vec2, Vec2)> {
    let corners: Vec<Vec2> = outline(feature).collect();
    let n = corners.len();
    let all = (0..n).map(|i| (corners[i], corners[(i + 1) % n]));
    let area: f32 = all.clone().map(|(a, b)| a.perp_dot(b)).sum();
    match area >= 0.0 {
        true => all.collect(),
        false => all.map(|(a, b)| (b, a)).collect(),
    }
}

/// The corners of a feature.
pub fn outline(feature: &Feature) -> impl Iterator<Item = Vec2> + '_ {
    feature.outline.iter().map(|p| p.as_vec2())
}

/// The box around a feature: its lower left and upper right corners.
pub fn bounds(feature: &Feature) -> (Vec2, Vec2) {
    outline(feature).fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(min, max), p| {
        (min.min(p), max.max(p))
    })
}

/// A place on the edge from a to b.
fn on(a: Vec2, b: Vec2, share: f32, z: f32) -> Vec3 {
    a.lerp(b, share).extend(z)
}

/// Bands along belts, vines on walls that can be climbed: where nothing buries them.
fn solid(kit: &Kit, feature: &Feature, features: &[&Feature], model: &mut Model) {
    if feature.conveyor == 0.0 && !feature.climbable {
        return;
    }
    let pieces = edges(feature).into_iter();
    for (a, b) in pieces.flat_map(|edge| unburied(edge, feature, features)) {
        let along = (b - a).normalize_or_zero();
        let outward = -along.perp();
        if feature.conveyor != 0.0 && outward.y > 0.5 {
            belt(a, b, model);
        }
        if feature.climbable && outward.y.abs() < 0.7 {
            vines(kit, a, b, outward, model);
        }
    }
}

/// A worn black band between two rollers; its arrows move, and are not part of this.
fn belt(a: Vec2, b: Vec2, model: &mut Model) {
    let (a, b) = if a.x < b.x { (a, b) } else { (b, a) };
    for end in [a, b] {
        let middle = end.extend(ARROW_DEPTH - 0.02) - Vec3::Y * PAINTED;
        for (radius, out, paint) in [(0.24, 0.0, IRON), (0.15, 0.05, GRATE), (0.06, 0.09, RAIL)] {
            let rim = (0..8).map(|i| {
                let (sin, cos) = (std::f32::consts::TAU * i as f32 / 8.0).sin_cos();
                middle + Vec3::new(radius * cos, radius * sin, out)
            });
            model.cap(&rim.collect::<Vec<_>>(), paint);
        }
    }
    let low = |p: Vec2, down: f32| p.extend(ARROW_DEPTH - 0.03) - Vec3::Y * down;
    let [upper, lower] = SKIRTS;
    let skirt = [low(a, lower), low(b, lower), low(b, upper), low(a, upper)];
    model.quad(skirt, SKIRT);
    let up = Vec2::new(0.0, 0.02);
    let corners = [(a, EDGE), (b, EDGE), (b, BACK), (a, BACK)];
    model.quad(corners.map(|(p, z)| (p + up).extend(z)), IRON);
}

/// A chevron at the origin that points to the right (1) or to the left (-1): two painted bars.
fn chevron(way: f32) -> Model {
    let mut model = Model::default();
    let [half, high] = CHEVRON;
    for side in [1.0, -1.0] {
        let at = |x: f32, y: f32| Vec3::new(x * way, y * side, 0.0);
        let bar = [at(half, 0.0), at(0.0, high), at(-half, high), at(0.0, 0.0)];
        match side * way > 0.0 {
            true => model.quad(bar, CHALK),
            false => model.quad([bar[0], bar[3], bar[2], bar[1]], CHALK),
        }
    }
    model
}

/// The arrows of a belt: one model, and the way on which they follow each other.
pub struct Arrows {
    /// A chevron at the origin, pointing where the belt runs, and a cleat on the band above it.
    pub model: Model,
    /// Where the first one starts.
    pub from: Vec3,
    /// To the next one.
    pub step: Vec3,
    /// How many there are.
    pub count: u32,
    /// How many steps they go in a second, against `step` if negative.
    pub pace: f32,
}

/// The arrows of all belts of a feature, where nothing of some features buries them.
pub fn arrows(feature: &Feature, features: &[&Feature]) -> Vec<Arrows> {
    let speed = feature.conveyor as f32;
    if speed == 0.0 {
        return Vec::new();
    }
    let pieces = edges(feature).into_iter();
    let pieces = pieces.flat_map(|edge| unburied(edge, feature, features));
    let runs = pieces.filter(|(a, b)| {
        let outward = -(*b - *a).normalize_or_zero().perp();
        feature.kind == Kind::Solid && outward.y > 0.5
    });
    let arrows = |(a, b): (Vec2, Vec2)| {
        let (a, b) = if a.x < b.x { (a, b) } else { (b, a) };
        let count = (a.distance(b) / ARROW_GAP).max(1.0) as u32;
        let step = (b - a) / count as f32;
        let mut model = chevron(speed.signum());
        let cleat = |z: f32| Vec3::new(0.0, PAINTED + 0.03, z - ARROW_DEPTH);
        model.beam(cleat(BACK + 0.1), cleat(EDGE - 0.04), 0.05, RAIL);
        Arrows {
            model,
            from: a.extend(ARROW_DEPTH) - Vec3::Y * PAINTED,
            step: step.extend(0.0),
            count,
            pace: speed / step.length(),
        }
    };
    runs.map(arrows).collect()
}

/// Vines up a wall, one metre on the other: on the wall itself, and around its edge on the front, where they are seen best.
fn vines(kit: &Kit, a: Vec2, b: Vec2, outward: Vec2, model: &mut Model) {
    let (foot, top) = if a.y < b.y { (a, b) } else { (b, a) };
    let length = foot.distance(top);
    let count = length.round().max(1.0);
    let up = (top - foot) / length.max(f32::EPSILON);
    // On the wall the piece's front looks out of it and its width runs into the depth; on the front it looks at the viewer.
    let across = if outward.x > 0.0 {
        Vec3::NEG_Z
    } else {
        Vec3::Z
    };
    let right = Vec2::new(up.y, -up.x);
    for i in 0..count as u32 {
        let root = on(foot, top, i as f32 / count, 0.0);
        let mut add = |width: Vec3, front: Vec3, at: Vec3| {
            let place = Mat4::from_cols(
                width.extend(0.0),
                (up * length / count).extend(0.0).extend(0.0),
                front.extend(0.0),
                at.extend(1.0),
            );
            model.add(kit.part(Part::VineMetre), place);
        };
        let wall = outward.extend(0.0);
        add(across, wall, root + wall * 0.02);
        let mirror = if i % 2 == 0 { DRAPE } else { -DRAPE };
        let edge = root - wall * DRAPE * 0.4 + Vec3::Z * DRAPED;
        add(right.extend(0.0) * mirror, Vec3::Z, edge);
    }
}

/// Whether a line of boards is stood on throughout: it runs to the right, and not too steeply.
pub fn is_floor(feature: &Feature) -> bool {
    let corners: Vec<Vec2> = outline(feature).collect();
    corners.windows(2).all(|pair| faces_up(pair[0], pair[1]))
}

fn faces_up(a: Vec2, b: Vec2) -> bool {
    (b - a).normalize_or_zero().x > 0.6
}

/// Arrows behind a part of a one-way that is a wall or a ceiling: they show the way through it.
fn way_through(a: Vec2, b: Vec2, model: &mut Model) {
    let along = (b - a).normalize_or_zero();
    let back = -along.perp();
    let count = (a.distance(b) / 1.2).round().max(1.0);
    for i in 0..count as u32 {
        let at = a.lerp(b, (i as f32 + 0.5) / count);
        let place = |behind: f32, aside: f32| (at + back * behind + along * aside).extend(EDGE);
        for side in [0.2, -0.2] {
            model.beam(place(0.5, side), place(0.24, 0.0), 0.05, CHALK);
        }
    }
}

/// Boards on two runners, of timber or of iron.
fn planks(feature: &Feature, model: &mut Model) {
    let iron = feature.material == Material::Iron;
    let (board, runner) = if iron { (GRATE, IRON) } else { (PLANK, RAIL) };
    let corners: Vec<Vec2> = outline(feature).collect();
    for pair in corners.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let down = Vec3::from(((b - a).normalize_or_zero().perp() * -0.11, 0.0));
        let count = (a.distance(b) / 0.48).round().max(1.0);
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
            let at = |p: Vec2| p.extend(z) + down * 1.6;
            model.beam(at(a), at(b), 0.07, runner);
        }
        if !faces_up(a, b) {
            way_through(a, b, model);
        }
    }
}

/// A ladder of timber, a chain of iron, vines at rock: as wide and high as the outline's box.
fn ladder(kit: &Kit, feature: &Feature, model: &mut Model) {
    let part = match feature.material {
        Material::Iron => Part::ChainMetre,
        Material::Timber | Material::Masonry => Part::LadderMetre,
        Material::Rock => Part::VineMetre,
    };
    let (min, max) = bounds(feature);
    let (width, height) = (max.x - min.x, max.y - min.y);
    // Chains keep their shape, and vines grow side by side where there is room.
    let columns = match part {
        Part::VineMetre => width.round().max(1.0),
        _ => 1.0,
    };
    let wide = match part {
        Part::ChainMetre => 1.0,
        _ => (width / columns).min(WIDEST),
    };
    let rows = height.round().max(1.0);
    for column in 0..columns as u32 {
        for row in 0..rows as u32 {
            let x = min.x + width * (column as f32 + 0.5) / columns;
            let foot = vec3(x, min.y + height * row as f32 / rows, BEHIND);
            let mirror = if part == Part::VineMetre && (row + column) % 2 == 1 {
                -1.0
            } else {
                1.0
            };
            let size = vec3(wide * mirror, height / rows, 1.0);
            let place = Mat4::from_translation(foot) * Mat4::from_scale(size);
            model.add(kit.part(part), place);
        }
    }
}

/// A lodestone where the hero comes back, its shard floating over it.
fn checkpoint(kit: &Kit, feature: &Feature, built: &mut Built, shards: &mut Shards) {
    let Some(respawn) = feature.respawn else {
        return;
    };
    let foot = respawn.as_vec2().extend(STONES);
    let place = Mat4::from_translation(foot);
    built.model.add(kit.part(Part::Lodestone), place);
    let lights = kit.part_lights(Part::Lodestone, place);
    built.lamps.extend(lights.iter().map(|light| PointLight {
        colour: light.colour * DIM,
        ..*light
    }));
    shards.lodestone(respawn, foot, lights.first().copied());
}

/// The gate, its light apart.
fn gate(kit: &Kit, foot: Vec2, built: &mut Built, shards: &mut Shards) {
    let foot = foot.extend(GATE);
    let place = Mat4::from_translation(foot);
    built.model.add(kit.part(Part::Gate), place);
    built.lamps.extend(kit.part_lights(Part::Gate, place));
    shards.gate(foot);
}

/// A stone with an eye, in the middle of the lower edge of the outline's box.
fn trigger(kit: &Kit, feature: &Feature, built: &mut Built) {
    let (min, max) = bounds(feature);
    let foot = vec3((min.x + max.x) / 2.0, min.y, BEHIND - 0.1);
    let place = Mat4::from_translation(foot);
    built.model.add(kit.part(Part::Pedestal), place);
    built.lamps.extend(kit.part_lights(Part::Pedestal, place));
}

#[cfg(test)]
mod tests {
    use super::super::kit::tests::kit;
    use super::super::model::VERTEX_WORDS;
    use super::*;
    use glam::DVec2;

    fn places(kind: Kind, material: Material, climbable: bool) -> Vec<Vec3> {
        let line = [(2.0, 4.0), (5.0, 4.0)].as_slice();
        let square = [(2.0, 1.0), (5.0, 1.0), (5.0, 4.0), (2.0, 4.0)].as_slice();
        let corners = if kind == Kind::OneWay { line } else { square };
        let feature = Feature {
            kind,
            material,
            climbable,
            outline: corners.iter().copied().map(DVec2::from).collect(),
            respawn: Some(DVec2::new(3.0, 1.0)),
            ..Feature::default()
        };
        let kit = kit();
        let built = build(&kit, &[&feature], &mut Shards::new(&kit));
        let place = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        let words = built.model.words.chunks_exact(VERTEX_WORDS);
        words.map(place).collect()
    }

    #[test]
    fn whatever_a_body_can_meet_is_seen_and_stays_near_its_outline() {
        for kind in [Kind::Ladder, Kind::Hazard, Kind::Trigger] {
            for material in [Material::Rock, Material::Timber, Material::Iron] {
                let places = places(kind, material, false);
                assert!(places.len() > 30, "{kind:?}");
                for p in places {
                    let near = (1.7..=5.3).contains(&p.x) && (0.7..=4.3).contains(&p.y);
                    assert!(near && p.z < EDGE + 0.1, "{kind:?}: {p}");
                }
            }
        }
        assert!(places(Kind::Checkpoint, Material::Rock, false).len() > 100);
        // Boards lie on the line; what carries them hangs below.
        let boards = places(Kind::OneWay, Material::Timber, false);
        assert!(boards.len() > 30);
        assert!(boards.iter().all(|p| p.y <= 4.05 && p.z < EDGE + 0.1));
    }

    #[test]
    fn ladders_of_different_materials_look_different() {
        let counts = [Material::Rock, Material::Timber, Material::Iron]
            .map(|material| places(Kind::Ladder, material, false).len());
        assert!(
            counts[0] != counts[1] && counts[1] != counts[2] && counts[0] != counts[2],
            "{counts:?}"
        );
    }

    #[test]
    fn vines_grow_on_walls_that_can_be_climbed_and_on_no_others() {
        assert!(places(Kind::Solid, Material::Rock, false).is_empty());
        let leaves = places(Kind::Solid, Material::Rock, true);
        assert!(leaves.len() > 300);
        // On the front, before the hero, they may reach over the stone.
        let beside = |p: &&Vec3| p.z < EDGE;
        assert!(
            leaves
                .iter()
                .filter(beside)
                .all(|p| p.x < 2.25 || p.x > 4.75)
        );
        assert!(leaves.iter().all(|p| p.x < 2.9 || p.x > 4.1));
    }
}
