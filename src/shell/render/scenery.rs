//! The things of a level that are seen and not touched, as models made in code.

use super::frame::PointLight;
use super::model::{Model, Paint, hash, paint};
use super::terrain;
use crate::level::{Level, Scenery, SceneryKind};
use glam::{Mat4, Vec3, vec3};
use std::f32::consts::TAU;

const STONE: Paint = paint(0x8d8a8e).varied(0.10);
const PALE: Paint = paint(0xb0a79c).varied(0.08);
const WOOD: Paint = paint(0x6d4d36).varied(0.12);
const ROPE: Paint = paint(0x9a8260);
const IRON: Paint = paint(0x3d4046);
const FLAME: Paint = paint(0xffcf73).glowing(1.0);
const WINDOW: Paint = paint(0xffb45a).glowing(0.75);
const LEAF: Paint = paint(0x6f8f5a).varied(0.22);
const CLOTH: Paint = paint(0xa8332e).varied(0.10);
const TILES: Paint = paint(0x5c4a55);
const LODESTONE: Paint = paint(0x7ff0e0).glowing(0.9);

/// Builds all scenery of a level, the gate at its goal and the camp at its start, with their lamps.
pub fn build(level: &Level) -> (Model, Vec<PointLight>) {
    let (mut all, mut lamps) = (Model::default(), Vec::new());
    for thing in &level.scenery {
        // What stands in front would hang before the fronts of the terrain.
        let depth = (thing.depth as f32).min(terrain::EDGE - 0.12);
        let foot = thing.at.as_vec2().extend(depth);
        let scale = thing.scale as f32;
        let size = Vec3::splat(scale) * Vec3::new(if thing.flip { -1.0 } else { 1.0 }, 1.0, 1.0);
        let place = Mat4::from_translation(foot) * Mat4::from_scale(size) * turn(thing, foot);
        all.add(&model(thing.kind, foot), place);
        if thing.kind == SceneryKind::Lantern {
            let at = place.transform_point3(Vec3::new(0.42, 2.0, 0.35));
            lamps.push(PointLight {
                at,
                reach: 9.0 * scale.max(0.2),
                colour: Vec3::new(3.4, 1.75, 0.60),
            });
        }
    }
    let foot = gate_foot(level);
    all.add(&gate(), Mat4::from_translation(foot));
    lamps.push(gate_light(level, 1.0));
    (all, lamps)
}

/// Where the gate stands: in the middle of the goal, behind the plane of play.
fn gate_foot(level: &Level) -> Vec3 {
    let middle = (level.goal.min.x + level.goal.max.x) / 2.0;
    Vec3::new(middle as f32, level.goal.min.y as f32, -0.9)
}

/// The light of the gate's lodestone: 1 as it waits, more when it is reached.
pub fn gate_light(level: &Level, strength: f32) -> PointLight {
    PointLight {
        at: gate_foot(level) + Vec3::new(0.0, 2.3, 0.8),
        reach: 13.0,
        colour: Vec3::new(0.25, 1.7, 1.5) * strength,
    }
}

/// What stands where the hero comes back: a lantern, and behind it a banner.
pub fn checkpoint() -> Model {
    let (mut model, mut cloth) = (Model::default(), Model::default());
    lantern(&mut model);
    banner(&mut cloth);
    model.add(&cloth, Mat4::from_translation(vec3(-0.5, 0.0, -0.4)));
    model
}

/// How a thing is turned about its own axis: as it says, else so that no two look alike and nothing flat is seen edge-on.
fn turn(thing: &Scenery, foot: Vec3) -> Mat4 {
    let free = (hash(foot, 20) - 0.5) * 2.0;
    let own = match thing.kind {
        SceneryKind::Pillar | SceneryKind::Grass => free * TAU / 2.0,
        SceneryKind::Tower | SceneryKind::Crane => 0.6 * free + 0.3,
        _ => 0.2 * free,
    };
    Mat4::from_rotation_y(
        thing
            .turn
            .map_or(own, |degrees| degrees.to_radians() as f32),
    )
}

fn model(kind: SceneryKind, foot: Vec3) -> Model {
    use SceneryKind::*;
    let mut model = Model::default();
    match kind {
        Lantern | LanternDead | LanternWall | LanternWallDead | LanternHanging
        | LanternHangingDead => lantern(&mut model),
        Pillar | PillarFluted | PillarSquare | PillarBroken | PillarFallen | Arch | ArchBroken
        | StatueHead | StatueKneeling | Tomb | Stalactite => pillar(foot, &mut model),
        Tower | TowerRuin | Aqueduct | CliffStack | Windmill => tower(foot, &mut model),
        Crane | Press | Winch | Boiler | Treadwheel | Scaffold => crane(&mut model),
        Banner | BannerTorn | BannerLong | Ladder => banner(&mut model),
        _ => plant(foot, &mut model),
    }
    model
}

/// A crooked post, 2.4 m tall, with a lamp on a hook.
fn lantern(model: &mut Model) {
    model.block(Vec3::Y * -0.3, (0.22, 0.22), (0.16, 0.16), 0.5, STONE);
    let (waist, top, hook) = (
        vec3(-0.04, 1.4, 0.0),
        vec3(0.03, 2.45, 0.0),
        vec3(0.42, 2.42, 0.0),
    );
    model.beam(Vec3::Y * 0.1, waist, 0.06, WOOD);
    model.beam(waist - Vec3::Y * 0.04, top, 0.05, WOOD);
    model.beam(vec3(-0.15, 2.36, 0.0), hook + Vec3::X * 0.08, 0.035, WOOD);
    model.beam(vec3(-0.02, 2.05, 0.0), vec3(0.26, 2.38, 0.0), 0.025, WOOD);
    // The lamp hangs 0.44 m below the hook: chain, hood, flame, foot.
    let lamp = hook - Vec3::Y * 0.44;
    let glass = [(0.0, 0.10), (0.14, 0.145), (0.29, 0.11)];
    model.beam(hook, lamp + Vec3::Y * 0.26, 0.012, IRON);
    model.lathe(lamp + Vec3::Y * 0.17, 6, &[(0.0, 0.19), (0.12, 0.0)], IRON);
    model.lathe(lamp - Vec3::Y * 0.12, 6, &glass, FLAME);
    model.lathe(lamp - Vec3::Y * 0.18, 6, &[(0.0, 0.09), (0.06, 0.15)], IRON);
}

/// A column of drums, 5 m tall on a pier that goes down 5 m more: whole with a capital, or broken.
fn pillar(foot: Vec3, model: &mut Model) {
    let chance = |salt: u32| hash(foot, salt);
    let broken = chance(21) < 0.45;
    let drums = if broken {
        2 + (chance(22) * 2.0) as u32
    } else {
        4
    };
    model.block(Vec3::Y * -5.0, (0.85, 0.85), (0.72, 0.72), 5.3, STONE);
    for drum in 0..drums {
        let (height, radius) = (0.3 + 1.05 * drum as f32, 0.52 - 0.025 * drum as f32);
        let shift = vec3(chance(23 + drum) - 0.5, 0.0, chance(33 + drum) - 0.5) * 0.10;
        let [joint, body] = [radius - 0.05, radius];
        let profile = [
            (0.0, joint),
            (0.08, body),
            (0.97, body - 0.02),
            (1.05, joint),
        ];
        model.lathe(Vec3::Y * height + shift, 9, &profile, PALE);
    }
    let top = Vec3::Y * (0.3 + 1.05 * drums as f32);
    if broken {
        model.lathe(top, 5, &[(0.0, 0.40), (0.22, 0.28), (0.45, 0.0)], PALE);
    } else {
        model.block(top, (0.45, 0.45), (0.68, 0.68), 0.30, STONE);
        model.slab(top + Vec3::Y * 0.30, (0.78, 0.78), 0.26, PALE);
    }
}

/// A square tower, 14 m tall over a foot that goes down 10 m more: shaft, gallery, upper floor, and a roof or a ruin.
fn tower(foot: Vec3, model: &mut Model) {
    model.block(Vec3::Y * -10.0, (2.9, 2.9), (2.5, 2.5), 12.0, STONE);
    model.block(Vec3::Y * 2.0, (2.3, 2.3), (1.95, 1.95), 8.5, STONE);
    model.slab(Vec3::Y * 10.5, (2.45, 2.45), 0.7, PALE);
    model.block(Vec3::Y * 11.2, (1.9, 1.9), (1.8, 1.8), 2.4, STONE);
    let roofed = hash(foot, 24) < 0.5;
    if roofed {
        let tent = [(0.0, 3.0), (0.25, 3.1), (4.2, 0.0)];
        model.lathe(Vec3::Y * 13.6, 4, &tent, TILES);
    }
    for (along, salt) in [(-1.2, 25), (0.0, 26), (1.2, 27)] {
        let height = if roofed {
            0.0
        } else {
            0.5 + 1.4 * hash(foot, salt)
        };
        model.block(
            vec3(along, 13.6, 1.4),
            (0.45, 0.35),
            (0.4, 0.3),
            height,
            STONE,
        );
        model.block(
            vec3(-1.4, 13.6, along - 0.3),
            (0.35, 0.45),
            (0.3, 0.4),
            height * 0.8,
            STONE,
        );
    }
    // Somebody lives there: a few windows are lit. The wall they sit in leans back with the height.
    for (x, y, wall, salt) in [
        (-0.7, 4.2, 2.23, 40),
        (0.6, 6.4, 2.14, 41),
        (-0.5, 8.6, 2.05, 42),
        (0.4, 12.0, 1.88, 43),
    ] {
        if hash(foot, salt) < 0.7 {
            model.block(
                vec3(x, y, wall - 0.03),
                (0.24, 0.05),
                (0.20, 0.05),
                0.85,
                WINDOW,
            );
        }
    }
}

/// A crane of the quarry, 7 m tall, its jib to the right: two trestles, the jib, ropes, a counterweight and a block.
fn crane(model: &mut Model) {
    let (mast, tip, tail) = (
        vec3(0.0, 7.1, 0.0),
        vec3(4.5, 7.3, 0.0),
        vec3(-2.5, 4.2, 0.0),
    );
    for side in [-0.9, 0.9] {
        let apex = vec3(0.0, 5.2, side * 0.25);
        model.beam(vec3(-1.3, -0.6, side), apex, 0.16, WOOD);
        model.beam(vec3(1.3, -0.6, side), apex, 0.16, WOOD);
        model.beam(
            vec3(-0.85, 1.4, side * 0.8),
            vec3(0.85, 1.4, side * 0.8),
            0.11,
            WOOD,
        );
    }
    model.beam(tail, tip, 0.17, WOOD);
    model.beam(Vec3::Y * 5.0, mast, 0.13, WOOD);
    model.beam(mast, tip, 0.035, ROPE);
    model.beam(mast, tail, 0.035, ROPE);
    model.block(tail - Vec3::Y * 1.1, (0.55, 0.55), (0.6, 0.6), 1.0, STONE);
    model.beam(tip, tip - Vec3::Y * 3.7, 0.03, ROPE);
    model.beam(tip - Vec3::Y * 3.9, tip - Vec3::Y * 3.65, 0.10, IRON);
    model.slab(tip - Vec3::Y * 4.8, (0.6, 0.5), 0.9, PALE);
}

/// A tuft: pointed blades that lean outwards and move in the wind.
fn plant(foot: Vec3, model: &mut Model) {
    for blade in 0..9 {
        let chance = |salt: u32| hash(foot, 50 + blade * 7 + salt);
        let (sin, cos) = (TAU * (blade as f32 + chance(0)) / 9.0).sin_cos();
        let out = Vec3::new(cos, 0.0, sin);
        let (height, lean) = (0.45 + 0.55 * chance(1), 0.15 + 0.45 * chance(2));
        let (root, tip) = (out * 0.10 - Vec3::Y * 0.06, out * lean + Vec3::Y * height);
        let middle = root.lerp(tip, 0.5) + out * 0.05 + Vec3::Y * 0.10;
        let across = Vec3::new(-sin, 0.0, cos) * 0.075;
        let (low, high) = (
            LEAF.swaying(0.25),
            LEAF.swaying(0.9).towards(paint(0xc9c27a), 0.45),
        );
        for [a, b] in [
            [middle - across, middle + across],
            [middle + across, middle - across],
        ] {
            model.facet([root, a, b], [0.55, 1.0, 1.0], low);
            model.facet([a, tip, b], [1.0; 3], high);
        }
    }
}

/// A cloth on a pole, 3.4 m tall, torn at its lower end.
fn banner(model: &mut Model) {
    model.beam(Vec3::Y * -0.4, Vec3::Y * 3.5, 0.055, WOOD);
    model.beam(
        Vec3::new(-0.15, 3.25, 0.0),
        Vec3::new(1.15, 3.25, 0.0),
        0.04,
        WOOD,
    );
    let rows = 5;
    let corner = |row: usize, x: f32| {
        let down = row as f32 / rows as f32;
        Vec3::new(
            x,
            3.22 - 1.9 * down,
            0.06 + 0.12 * (down * 5.0 + x * 3.0).sin() * down,
        )
    };
    for row in 0..rows {
        let cloth =
            if row == 1 { paint(0xe0b060) } else { CLOTH }.swaying(row as f32 / rows as f32 * 0.8);
        let [a, b] = [corner(row, 0.1), corner(row, 1.05)];
        let (mut c, mut d) = (corner(row + 1, 1.05), corner(row + 1, 0.1));
        if row + 1 == rows {
            (c, d) = (c + Vec3::Y * 0.25, d - Vec3::Y * 0.15);
        }
        model.quad([d, c, b, a], cloth);
        model.quad([a, b, c, d], cloth);
    }
}

/// The end of the way: two leaning stones and between them the lodestone, hanging free in its own light.
pub fn gate() -> Model {
    let mut model = Model::default();
    for side in [-1.0f32, 1.0] {
        let foot = Vec3::new(1.75 * side, -0.4, 0.0);
        model.block(foot, (0.62, 0.55), (0.5, 0.45), 0.9, STONE);
        let shoulder = Vec3::new(1.65 * side, 2.6, 0.0);
        model.beam(foot + Vec3::Y * 0.8, shoulder, 0.36, PALE);
        model.beam(
            shoulder - Vec3::Y * 0.15,
            Vec3::new(0.62 * side, 4.15, 0.0),
            0.32,
            PALE,
        );
        for rune in 0..3 {
            let at = Vec3::new(1.71 * side, 0.9 + 0.55 * rune as f32, 0.36);
            model.block(at, (0.07, 0.03), (0.07, 0.03), 0.26, LODESTONE);
        }
    }
    model.block(Vec3::Y * 3.95, (0.5, 0.42), (0.72, 0.45), 0.75, STONE);
    model.lathe(
        Vec3::Y * 1.55,
        6,
        &[(0.0, 0.0), (0.55, 0.36), (0.85, 0.30), (1.5, 0.0)],
        LODESTONE,
    );
    model
}
