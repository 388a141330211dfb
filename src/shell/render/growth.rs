//! What grows on ledges of rock: tufts of grass in the plane of play, low enough to hide nobody's feet.

use super::facets::{Facets, next};
use super::model::{Model, Paint, hash, paint};
use crate::level::Material;
use glam::{Vec2, Vec3};

/// Least height of the ground's unit normal on which grass holds.
const FLAT: f32 = 0.86;
/// Most tufts on a metre, and blades in a tuft.
const TUFTS: f32 = 1.1;
const BLADES: u32 = 3;
/// Depths between which it grows.
const DEPTHS: (f32, f32) = (-0.85, 0.42);

const ROOT: Paint = paint(0x55704f).varied(0.2);
const TIP: Paint = paint(0xa9b36c).varied(0.25);

/// Adds the grass of a terrain.
pub fn add_grass(facets: &Facets, model: &mut Model) {
    for e in (0..facets.origin.len()).filter(|&e| facets.is_border(e)) {
        let (a, b) = (
            facets.points[facets.origin[e]].as_vec2(),
            facets.points[facets.origin[next(e)]].as_vec2(),
        );
        let normal = -(b - a).perp().normalize_or_zero();
        if normal.y < FLAT
            || facets.look[e / 3].material != Material::Rock
            || facets.look[e / 3].slick
        {
            continue;
        }
        // Bare stretches between overgrown ones.
        let lush = 0.5 + 0.5 * (a.x * 0.37 + 1.3 * (a.x * 0.11).sin()).sin();
        let count = (a.distance(b) * TUFTS * lush + hash(a.extend(0.0), 100)) as u32;
        for tuft in 0..count {
            add_tuft(a, b, tuft * 16, model);
        }
    }
}

/// One tuft somewhere on the edge from `a` to `b`.
fn add_tuft(a: Vec2, b: Vec2, salt: u32, model: &mut Model) {
    let chance = |n: u32| hash(a.extend(1.0), 101 + salt + n);
    let depth = DEPTHS.0 + (DEPTHS.1 - DEPTHS.0) * chance(0);
    let foot = a.lerp(b, chance(1)).extend(depth);
    let size = 0.18 + 0.20 * chance(2);
    for blade in 0..BLADES {
        let fan = (blade as f32 + chance(3 + blade)) / BLADES as f32 - 0.5;
        let root = foot + Vec3::new(fan * 0.2, -0.03, 0.0);
        let tip = root + Vec3::new(fan * 0.9, 1.0 - fan.abs() * 0.8, 0.25 * chance(9)) * size;
        let across = Vec3::new(0.055, 0.0, 0.02 - 0.04 * chance(8));
        let paint = ROOT.towards(TIP, 0.3 + 0.7 * chance(10 + blade));
        model.blade([root - across, root + across, tip], paint);
    }
}
