//! The scenery of a level: set pieces, put where the level wants them.

use super::dangers::contains;
use super::frame::PointLight;
use super::kit::Kit;
use super::model::{FACET_WORDS, Model, VERTEX_WORDS, hash};
use super::terrain;
use crate::level::{Kind, Level, Scenery, SceneryKind};
use glam::{Mat4, Vec2, vec3};
use std::f32::consts::TAU;

/// How far in front of the plane of play scenery may stand: what is further in front would hang before the terrain.
const FOREMOST: f32 = terrain::EDGE - 0.12;
/// Least scale at which the reach of a lamp shrinks with it.
const SMALLEST_LAMP: f32 = 0.2;

/// Metres under its foot at which what something stands on is looked for, and steps in which its end is.
const UNDER: f32 = 0.15;
const STEP: f32 = 0.25;
/// What reaches this far above its foot stands on it, in metres; what does not hangs.
const STANDS: f32 = 0.5;

/// Builds all scenery of a level, with its lamps.
pub fn build(kit: &Kit, level: &Level) -> (Model, Vec<PointLight>) {
    let (mut all, mut lamps) = (Model::default(), Vec::new());
    for thing in &level.scenery {
        let (place, scale) = place(thing);
        let model = kit.scenery(thing.kind);
        let (low, high) = model.bounds();
        match high.y > STANDS && is_on_a_slab(level, thing, -low.y * scale) {
            true => all.add(&without_footing(model), place),
            false => all.add(model, place),
        }
        lamps.extend(kit.scenery_lights(thing.kind, place, scale.max(SMALLEST_LAMP)));
    }
    (all, lamps)
}

/// Whether what a thing stands on ends before its footing does, which would hang into the room below.
fn is_on_a_slab(level: &Level, thing: &Scenery, footing: f32) -> bool {
    let foot = thing.at.as_vec2();
    let solids = || level.features.iter().filter(|f| f.kind == Kind::Solid);
    let is_solid = |below: f32| solids().any(|f| contains(f, foot - Vec2::Y * below));
    let steps = (1..=(footing / STEP) as u32).map(|step| step as f32 * STEP);
    is_solid(UNDER)
        && steps
            .filter(|&below| below > UNDER)
            .any(|below| !is_solid(below))
}

/// A model without the facets that lie below its foot.
fn without_footing(model: &Model) -> Model {
    let mut words = Vec::with_capacity(model.words.len());
    for facet in model.words.chunks_exact(FACET_WORDS) {
        let heights = facet
            .chunks_exact(VERTEX_WORDS)
            .map(|v| f32::from_bits(v[1]));
        if heights.fold(f32::MIN, f32::max) > UNDER / 3.0 {
            words.extend(facet);
        }
    }
    Model {
        words,
        ..Model::default()
    }
}

/// Where a thing stands, and its scale.
fn place(thing: &Scenery) -> (Mat4, f32) {
    let foot = thing
        .at
        .as_vec2()
        .extend((thing.depth as f32).min(FOREMOST));
    let scale = thing.scale as f32;
    let mirror = vec3(if thing.flip { -1.0 } else { 1.0 }, 1.0, 1.0);
    let turn = match thing.turn {
        Some(degrees) => (degrees as f32).to_radians(),
        None => own_turn(thing.kind) * (hash(foot, 20) - 0.5),
    };
    let place = Mat4::from_translation(foot)
        * Mat4::from_rotation_y(turn)
        * Mat4::from_scale(mirror * scale);
    (place, scale)
}

/// Over which angle a kind may be turned by its place, so that no two look alike and nothing flat is seen edge-on.
fn own_turn(kind: SceneryKind) -> f32 {
    use SceneryKind::*;
    match kind {
        // What is round, or has no front.
        Pillar | PillarFluted | PillarBroken | Barrel | Grass | Fern | Bush | Reed | DeadTree
        | Mushrooms | Rubble | RubbleSmall | Stalactite | CliffStack => TAU,
        // What hangs at a wall, or is to be looked at from the front.
        LanternWall | LanternWallDead | Ivy | Ladder | Scaffold | Gear | Arch | ArchBroken => 0.0,
        Tower | TowerRuin | Windmill | Crane | Aqueduct => 1.0,
        Crate | Crates | Cart | Tomb | StatueHead | RubbleBlocks | Boiler | Tree => 0.7,
        Lantern | LanternDead | LanternHanging | LanternHangingDead | PillarSquare
        | PillarFallen | Banner | BannerTorn | BannerLong | GearSmall | Press | Winch | Pipe
        | Treadwheel | Pulley | Vine | Chain | Rope | StatueKneeling | Bird => 0.4,
    }
}

#[cfg(test)]
mod tests {
    use super::super::bearers::Bearers;
    use super::super::fixtures::edges;
    use super::super::inward::distance;
    use super::super::kit::tests::kit;
    use super::*;
    use crate::level;
    use glam::{DVec2, Vec3};
    use std::path::Path;

    fn thing(turn: Option<f64>, flip: bool) -> Scenery {
        Scenery {
            kind: SceneryKind::Lantern,
            at: DVec2::new(3.0, 2.0),
            depth: -1.0,
            scale: 2.0,
            turn,
            flip,
        }
    }

    #[test]
    fn scenery_stands_where_it_is_put_turned_and_flipped() {
        let right = Vec3::X;
        let shown = |turn, flip| place(&thing(turn, flip)).0.transform_point3(right);
        let near = |a: Vec3, b: Vec3| assert!(a.distance(b) < 1e-5, "{a} {b}");
        near(shown(Some(0.0), false), vec3(5.0, 2.0, -1.0));
        near(shown(Some(0.0), true), vec3(1.0, 2.0, -1.0));
        // Counter-clockwise seen from above: right becomes away from the viewer.
        near(shown(Some(90.0), false), vec3(3.0, 2.0, -3.0));
        let free = shown(None, false);
        assert!(free.distance(vec3(5.0, 2.0, -1.0)) < 0.5 && free != shown(Some(0.0), false));
    }

    #[test]
    fn footings_do_not_hang_through_a_slab() {
        let with_slab = |bottom: f64| {
            let text = format!(
                "(version: 1, name: \"n\", start: (1, 9), goal: (min: (8, 9), max: (9, 12)), bottom: -20,
                features: [(id: \"slab\", outline: [(0, {bottom}), (9, {bottom}), (9, 2), (0, 2)])],
                scenery: [(kind: PillarSquare, at: (3, 2), depth: -3)])"
            );
            level::parse(&text, Path::new("test")).unwrap()
        };
        let lowest = |level: &Level| build(&kit(), level).0.bounds().0.y;
        assert!(lowest(&with_slab(-9.0)) < 1.0, "in the rock");
        assert!(lowest(&with_slab(1.2)) > 1.8, "on a slab");
    }

    /// How far under its ceiling what hangs may begin, and how far over its ground what stands may end, in metres.
    const NEAR: f32 = 0.3;
    /// What stands further back than this is seen through the haze, its foot behind what is before it.
    const HAZY: f64 = -20.0;

    #[test]
    fn in_the_quarry_no_scenery_floats() {
        let level = super::super::bearers::tests::quarry();
        let water = super::super::scene::water(&level);
        let solids = Bearers::solids(&level, water);
        let kit = kit();
        let bounds = |thing: &Scenery| {
            let (low, high) = kit.scenery(thing.kind).bounds();
            let at = thing.at.as_vec2().extend(thing.depth as f32);
            (
                at + low * thing.scale as f32,
                at + high * thing.scale as f32,
            )
        };
        // What hangs at boards, or at scenery that stands.
        let boards = |p: Vec2| {
            let lines = level.features.iter().filter(|f| f.kind == Kind::OneWay);
            let mut edges = lines.flat_map(edges);
            edges.any(|(a, b)| distance(p, a, b) < NEAR)
        };
        let stands_at = |p: Vec3, other: &Scenery| {
            let (low, high) = bounds(other);
            high.y > other.at.y as f32 + STANDS
                && (low - NEAR).cmple(p).all()
                && (high + NEAR).cmpge(p).all()
        };
        for thing in level.scenery.iter().filter(|thing| thing.depth > HAZY) {
            let at = thing.at.as_vec2();
            let (low, high) = bounds(thing);
            let own = (high.y - at.y) / thing.scale as f32;
            let place = at.extend(thing.depth as f32);
            let others = || level.scenery.iter().filter(|other| *other != thing);
            let near = |way: Vec2| solids.hold(at + way * NEAR);
            let hangs = own < STANDS || thing.kind == SceneryKind::Ivy;
            let held = match hangs {
                true => [Vec2::Y, Vec2::X, Vec2::NEG_X, Vec2::NEG_Y]
                    .into_iter()
                    .any(near),
                false => {
                    let from = at + Vec2::Y * NEAR;
                    let ground = solids.reach(from, Vec2::NEG_Y, from.y - low.y);
                    ground.is_some() || near(Vec2::NEG_Y) || low.y < water
                }
            };
            let held = held || boards(at) || others().any(|other| stands_at(place, other));
            assert!(held, "{:?} at {at}, depth {}", thing.kind, thing.depth);
        }
    }

    #[test]
    fn nothing_stands_before_the_terrain() {
        let close = Scenery {
            depth: 5.0,
            ..thing(None, false)
        };
        assert_eq!(place(&close).0.transform_point3(Vec3::ZERO).z, FOREMOST);
    }
}
