//! What lies behind the level: the drowned city, stacks in the water, and cliffs that fade into the haze.
//!
//! All of it is real depth, so that it moves against the level as the camera does. It is made from the level's extent
//! alone, and is the same for the same level.

use super::kit::Kit;
use super::model::{Model, Paint, hash, paint};
use crate::level::SceneryKind;
use glam::{Mat4, Vec2, Vec3, vec3};

/// A row of cliffs: how far away, how tall above the water, how wide a step, and what they are made of.
struct Row {
    depth: f32,
    height: f32,
    step: f32,
    colour: Paint,
}

const ROWS: [Row; 3] = [
    Row {
        depth: -62.0,
        height: 22.0,
        step: 9.0,
        colour: paint(0x767688).varied(0.10),
    },
    Row {
        depth: -115.0,
        height: 44.0,
        step: 15.0,
        colour: paint(0x6d7088).varied(0.10),
    },
    Row {
        depth: -200.0,
        height: 78.0,
        step: 26.0,
        colour: paint(0x666b88).varied(0.10),
    },
];

/// What grows on the benches, far away.
const LEDGE: Paint = paint(0x8f9a86);

/// What stands in the water before the cliffs.
const CITY: [SceneryKind; 7] = [
    SceneryKind::TowerRuin,
    SceneryKind::Aqueduct,
    SceneryKind::CliffStack,
    SceneryKind::Windmill,
    SceneryKind::Tower,
    SceneryKind::Aqueduct,
    SceneryKind::TowerRuin,
];
/// Metres from one to the next, the share of places that are empty, the depths between which they stand.
const CITY_STEP: f32 = 31.0;
const CITY_GAPS: f32 = 0.25;
const CITY_DEPTHS: [f32; 2] = [-56.0, -34.0];
/// Their scales, and how far their feet are above the water.
const CITY_SCALES: [f32; 2] = [1.2, 2.2];
const CITY_FEET: [f32; 2] = [0.5, 6.0];
/// Over which angle they are turned.
const CITY_TURN: f32 = 1.2;

/// Builds it for a level between two corners, over water of a height.
pub fn build(kit: &Kit, min: Vec2, max: Vec2, water: f32) -> Model {
    let mut model = city(kit, min, max, water);
    for (index, row) in ROWS.iter().enumerate() {
        let beyond = 40.0 - row.depth * 0.9;
        let (first, last) = (
            ((min.x - beyond) / row.step) as i32,
            ((max.x + beyond) / row.step) as i32,
        );
        for cell in first..=last {
            let seed = Vec3::new(cell as f32, index as f32, 0.0);
            mesa(row, seed, water, &mut model);
        }
    }
    model
}

/// What is left of the city, from piece to piece.
fn city(kit: &Kit, min: Vec2, max: Vec2, water: f32) -> Model {
    let mut model = Model::default();
    let beyond = 40.0 - CITY_DEPTHS[0] * 0.9;
    let cells = [min.x - beyond, max.x + beyond].map(|x| (x / CITY_STEP) as i32);
    for cell in cells[0]..=cells[1] {
        let chance = |salt: u32| hash(vec3(cell as f32, 7.0, 0.0), 300 + salt);
        let between = |[low, high]: [f32; 2], salt: u32| low + (high - low) * chance(salt);
        if chance(0) < CITY_GAPS {
            continue;
        }
        // One after the other, so that no two alike are neighbours.
        let kind = CITY[cell.rem_euclid(CITY.len() as i32) as usize];
        let x = (cell as f32 + 0.7 * chance(1)) * CITY_STEP;
        let foot = vec3(x, water + between(CITY_FEET, 2), between(CITY_DEPTHS, 3));
        let mirror = if chance(4) < 0.5 { -1.0 } else { 1.0 };
        let place = Mat4::from_translation(foot)
            * Mat4::from_rotation_y((chance(5) - 0.5) * CITY_TURN)
            * Mat4::from_scale(vec3(mirror, 1.0, 1.0) * between(CITY_SCALES, 6));
        model.add(kit.scenery(kind), place);
    }
    model
}

/// One cliff: benches cut back one above the other; some cells are gaps, through which the rows behind are seen.
fn mesa(row: &Row, seed: Vec3, water: f32, model: &mut Model) {
    let chance = |salt: u32| hash(seed, 60 + salt);
    if chance(0) < 0.22 {
        return;
    }
    let benches = 2 + (chance(1) * 3.0) as u32;
    let share = (0.35 + 0.65 * chance(2) * chance(3).sqrt()) * (0.6 + 0.8 * chance(4));
    let height = row.height * share;
    let (x, z) = (
        (seed.x + chance(6)) * row.step,
        row.depth - row.step * chance(7),
    );
    let mut half = Vec2::new(row.step * (0.55 + 0.45 * chance(5)), row.step * 0.8);
    let mut centre = vec3(x, water - 6.0, z);
    let mut ring = outline(centre, half, seed, 0);
    for bench in 0..benches {
        let chance = |salt: u32| hash(seed, 70 + salt + 20 * bench);
        let top = water + height * (bench as f32 + 0.6 + 0.4 * chance(0)) / benches as f32;
        let brink = brink(centre, &ring, top, seed, bench);
        model.band(&ring, &brink, row.colour);
        half *= 0.60 + 0.22 * chance(1);
        centre = vec3(x + (chance(2) - 0.5) * half.x * 0.7, top, z - half.y * 0.2);
        let next = outline(centre, half, seed, bench + 1);
        model.band(&brink, &next, row.colour.towards(LEDGE, 0.45));
        ring = next;
    }
    let peak = centre + Vec3::Y * height * 0.12;
    for (i, &corner) in ring.iter().enumerate() {
        let triangle = [corner, ring[(i + 1) % ring.len()], peak];
        model.facet(triangle, [1.0; 3], row.colour);
    }
}

/// The upper end of a wall: it leans back, and its corners are broken off at different heights.
fn brink(centre: Vec3, foot: &[Vec3], top: f32, seed: Vec3, bench: u32) -> Vec<Vec3> {
    let corner = |(i, foot): (u32, &Vec3)| {
        let chance = hash(seed, 200 + 8 * bench + i);
        let inward = (centre - *foot).with_y(0.0) * (0.06 + 0.12 * chance);
        *foot + inward + Vec3::Y * (top - foot.y) * (0.80 + 0.35 * chance)
    };
    (0..).zip(foot).map(corner).collect()
}

/// A rough seven-sided outline, counter-clockwise seen from above.
fn outline(centre: Vec3, half: Vec2, seed: Vec3, salt: u32) -> Vec<Vec3> {
    let corner = |i: u32| {
        let (sin, cos) = (std::f32::consts::TAU * (i as f32 + 0.3) / 7.0).sin_cos();
        let reach = 0.65 + 0.5 * hash(seed, 90 + 11 * salt + i);
        centre + Vec3::new(cos * half.x, 0.0, -sin * half.y) * reach
    };
    (0..7).map(corner).collect()
}
