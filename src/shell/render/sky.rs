//! What is behind everything: a gradient at the corners of a coarse grid, the sun, stars, and shards of cloud in layers
//! that drift past each other.

use super::gl::{Geometry, Gl};
use super::model::hash;
use super::state::Format;
use glam::{Vec2, Vec3, Vec4};
use std::f32::consts::TAU;

/// Layouts: a corner of the grid; a corner of a thing in the sky about that thing's middle.
const GRID: [Format; 1] = [Format::F4];
const THING: [Format; 2] = [Format::F4, Format::F4];
/// Cells of the grid over the picture.
const CELLS: (usize, usize) = (20, 14);
/// Where the sun stands, to the right of straight ahead and above the horizon, and how large it is, in radians.
const SUN: Vec2 = Vec2::new(-0.55, 0.085);
const SUN_RADIUS: f32 = 0.042;
const STARS: usize = 90;

/// A layer of clouds: how high, how thick, how large its shards are, how fast they drift, how dense they look.
struct Layer {
    count: u32,
    height: (f32, f32),
    size: Vec2,
    drift: f32,
    opacity: f32,
}

const LAYERS: [Layer; 3] = [
    Layer {
        count: 26,
        height: (0.05, 0.16),
        size: Vec2::new(0.20, 0.012),
        drift: 0.0011,
        opacity: 0.50,
    },
    Layer {
        count: 20,
        height: (0.14, 0.30),
        size: Vec2::new(0.24, 0.022),
        drift: 0.0018,
        opacity: 0.42,
    },
    Layer {
        count: 12,
        height: (0.30, 0.55),
        size: Vec2::new(0.34, 0.040),
        drift: 0.0030,
        opacity: 0.30,
    },
];

/// Kinds of things, as the shader tells them apart.
const KINDS: [f32; 3] = [0.0, 1.0, 2.0];

/// The grid.
pub fn grid(gl: &Gl) -> Result<Geometry, String> {
    let mut words = Vec::new();
    let (columns, rows) = CELLS;
    let at = |x: usize, y: usize| {
        let share = Vec2::new(x as f32 / columns as f32, y as f32 / rows as f32);
        (share * 2.0 - 1.0).extend(0.0).extend(0.0)
    };
    for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
        let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
        push(&mut words, [a, b, c, a, c, d]);
    }
    let mut grid = gl.geometry(&GRID, false)?;
    grid.upload(&words);
    Ok(grid)
}

/// Sun, stars and clouds, from back to front.
pub fn things(gl: &Gl) -> Result<Geometry, String> {
    let mut words = Vec::new();
    for star in 0..STARS {
        let chance = |salt: u32| hash(Vec3::X * star as f32, 300 + salt);
        let about = Vec2::new((chance(0) - 0.5) * 3.2, 0.12 + 0.8 * chance(1));
        let size = 0.0012 + 0.0016 * chance(2) * chance(2);
        disc(
            about,
            KINDS[1],
            Vec2::splat(size),
            4,
            0.5 + 0.5 * chance(3),
            &mut words,
        );
    }
    disc(SUN, KINDS[0], Vec2::splat(SUN_RADIUS), 11, 1.0, &mut words);
    for (number, layer) in LAYERS.iter().enumerate() {
        for index in 0..layer.count {
            cloud(
                layer,
                Vec3::new(index as f32, number as f32, 7.0),
                &mut words,
            );
        }
    }
    let mut things = gl.geometry(&THING, false)?;
    things.upload(&words);
    Ok(things)
}

fn push<const N: usize>(words: &mut Vec<u32>, vectors: [Vec4; N]) {
    words.extend(
        vectors
            .into_iter()
            .flat_map(|v| v.to_array().map(f32::to_bits)),
    );
}

/// A regular shape of one colour.
fn disc(about: Vec2, kind: f32, radius: Vec2, sides: usize, opacity: f32, words: &mut Vec<u32>) {
    let about = about.extend(0.0).extend(kind);
    let corner = |i: usize| {
        let at = Vec2::from_angle(TAU * i as f32 / sides as f32) * radius;
        Vec4::new(at.x, at.y, 1.0, opacity)
    };
    for i in 0..sides {
        let middle = Vec4::new(0.0, 0.0, 1.0, opacity);
        push(
            words,
            [about, middle, about, corner(i), about, corner(i + 1)],
        );
    }
}

/// A long shard: pointed at both ends, flat and lit below, humped above.
fn cloud(layer: &Layer, seed: Vec3, words: &mut Vec<u32>) {
    let chance = |salt: u32| hash(seed, 310 + salt);
    let height = layer.height.0 + (layer.height.1 - layer.height.0) * chance(0);
    let about = Vec4::new(
        chance(1) * 3.6,
        height,
        layer.drift * (0.8 + 0.4 * chance(2)),
        KINDS[2],
    );
    let size = layer.size * (0.5 + chance(3)) * Vec2::new(1.0, 0.7 + 0.6 * chance(4));
    let humps = 4 + (3.0 * chance(5)) as u32;
    let opacity = layer.opacity * (0.6 + 0.4 * chance(6));
    let along = |i: u32| (i as f32 / humps as f32 * 2.0 - 1.0) * size.x;
    let rise = |i: u32| match i {
        0 => 0.0,
        i if i == humps => 0.0,
        i => size.y * (0.35 + 0.65 * chance(20 + i)),
    };
    let point = |x: f32, y: f32, lit: f32| Vec4::new(x, y, lit, opacity);
    for i in 0..humps {
        let [a, b] = [along(i), along(i + 1)];
        let [high_a, high_b] = [rise(i), rise(i + 1)];
        let dip = |high: f32| -0.35 * high;
        let shade = 0.25 * chance(40 + i);
        let [top_a, top_b] = [point(a, high_a, shade), point(b, high_b, shade)];
        let [low_a, low_b] = [point(a, dip(high_a), 1.0), point(b, dip(high_b), 1.0)];
        push(words, [about, low_a, about, low_b, about, top_b]);
        push(words, [about, low_a, about, top_b, about, top_a]);
    }
}
