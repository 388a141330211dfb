//! Families of worlds with many crossings for their size: n things that make about n * n of them.

#![allow(dead_code, reason = "each test uses its own part")]

use super::worlds::{Dice, Outline};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// A family by name: worlds of some size.
pub type Tangle = (&'static str, fn(usize) -> Vec<Outline>);

/// All families.
pub const TANGLES: [Tangle; 14] = [
    ("beams", beams),
    ("tilted beams", tilted_beams),
    ("slivers", slivers),
    ("fine slivers", fine_slivers),
    ("combs", combs),
    ("tilted combs", tilted_combs),
    ("sticks", sticks),
    ("needles", needles),
    ("pencils", pencils),
    ("stars", stars),
    ("stack", stack),
    ("stairs", stairs),
    ("parallels", parallels),
    ("corner", corner),
];

/// A quadrangle around the line between two points, so thick.
fn beam(a: DVec2, b: DVec2, thickness: f64) -> Outline {
    let side = (b - a).perp().normalize() * (thickness / 2.0);
    vec![a - side, b - side, b + side, a + side]
}

fn turned(world: Vec<Outline>, angle: f64) -> Vec<Outline> {
    let turn = DVec2::from_angle(angle);
    let turned = |outline: Outline| outline.into_iter().map(|p| turn.rotate(p)).collect();
    world.into_iter().map(turned).collect()
}

/// n lying beams across n standing ones, each 5 cm thick, half a metre apart.
pub fn beams(n: usize) -> Vec<Outline> {
    let end = 0.5 * n as f64 + 0.5;
    let at = |i: usize| 0.5 * i as f64 + 0.5;
    let lying = (0..n).map(|i| beam(DVec2::new(0.0, at(i)), DVec2::new(end, at(i)), 0.05));
    let standing = (0..n).map(|i| beam(DVec2::new(at(i), 0.0), DVec2::new(at(i), end), 0.05));
    lying.chain(standing).collect()
}

/// The same, turned.
pub fn tilted_beams(n: usize) -> Vec<Outline> {
    turned(beams(n), 0.3)
}

fn through_a_point(n: usize, thickness: f64) -> Vec<Outline> {
    let sliver = |i: usize| {
        let along = DVec2::from_angle(PI * i as f64 / n as f64) * 10.0;
        beam(-along, along, thickness)
    };
    (0..n).map(sliver).collect()
}

/// n slivers of 2 cm through a point.
pub fn slivers(n: usize) -> Vec<Outline> {
    through_a_point(n, 0.02)
}

/// n slivers of half a millimetre through a point.
pub fn fine_slivers(n: usize) -> Vec<Outline> {
    through_a_point(n, 0.0005)
}

/// A comb with n teeth, upwards, as one outline in a square of the unit side.
fn comb(n: usize) -> Outline {
    let pitch = 1.0 / n as f64;
    let tooth = |i: usize| {
        let x = 1.0 - pitch * i as f64;
        let y = [0.05, 1.0, 1.0, 0.05];
        let x = [
            x - 0.2 * pitch,
            x - 0.2 * pitch,
            x - 0.6 * pitch,
            x - 0.6 * pitch,
        ];
        (0..4).map(move |k| DVec2::new(x[k], y[k]))
    };
    let foot = [DVec2::ZERO, DVec2::X];
    foot.into_iter().chain((0..n).flat_map(tooth)).collect()
}

/// Two combs of n teeth, one across the other.
pub fn combs(n: usize) -> Vec<Outline> {
    let size = 0.25 * n as f64;
    let upwards: Outline = comb(n).into_iter().map(|p| p * size).collect();
    let across = upwards
        .iter()
        .map(|p| DVec2::new(size * 1.02 - p.y, p.x + size * 0.1));
    vec![upwards.clone(), across.collect()]
}

/// The same, turned.
pub fn tilted_combs(n: usize) -> Vec<Outline> {
    turned(combs(n), 0.7)
}

/// n thin beams anywhere in a square whose side they are about as long as.
pub fn sticks(n: usize) -> Vec<Outline> {
    let (mut dice, size) = (Dice::new(11), 0.5 * n as f64);
    let mut stick = |_| {
        let mut end = || DVec2::new(dice.between(0.0, size), dice.between(0.0, size));
        beam(end(), end(), 0.03)
    };
    (0..n).map(&mut stick).collect()
}

/// n triangles of 40 m that are next to nothing wide, almost on one another.
pub fn needles(n: usize) -> Vec<Outline> {
    let mut dice = Dice::new(12);
    let mut needle = |_| {
        let mut end = |x: f64| DVec2::new(x, dice.between(-0.2, 0.2));
        let (a, b, c) = (end(-20.0), end(20.0), end(20.0));
        let (low, high) = if b.y < c.y { (b, c) } else { (c, b) };
        vec![a, low, high]
    };
    (0..n).map(&mut needle).collect()
}

/// n beams that meet at each of four points.
pub fn pencils(n: usize) -> Vec<Outline> {
    let mut world = Vec::new();
    for hub in [
        DVec2::ZERO,
        DVec2::new(7.0, 1.0),
        DVec2::new(3.0, 6.0),
        DVec2::new(9.0, 8.0),
    ] {
        for i in 0..n / 4 {
            let along = DVec2::from_angle(PI * (i as f64 + 0.3) / (n / 4) as f64) * 6.0;
            world.push(beam(hub - along, hub + along, 0.01));
        }
    }
    world
}

/// Two stars with n spikes each, one a little turned.
pub fn stars(n: usize) -> Vec<Outline> {
    let star = |turn: f64| {
        let corner = |i: usize| {
            let radius = if i.is_multiple_of(2) { 30.0 } else { 3.0 };
            DVec2::from_angle(TAU * (i as f64 + turn) / (2 * n) as f64) * radius
        };
        (0..2 * n).map(corner).collect()
    };
    (0..8).map(|k| star(f64::from(k) * 0.2)).collect()
}

/// n boxes, the same, on one another.
pub fn stack(n: usize) -> Vec<Outline> {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)];
    vec![corners.map(DVec2::from).to_vec(); n]
}

/// n boxes on one floor, each wider than the one before: each floor lies along all the ones before.
pub fn stairs(n: usize) -> Vec<Outline> {
    let step = |i: usize| {
        let (w, h) = (1.0 + 0.25 * i as f64, 1.0 + 0.25 * (n - i) as f64);
        [(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)]
            .map(DVec2::from)
            .to_vec()
    };
    (0..n).map(step).collect()
}

/// n beams side by side, aslant: long, close and without a crossing.
pub fn parallels(n: usize) -> Vec<Outline> {
    let size = 0.25 * n as f64;
    let along = DVec2::from_angle(0.6) * size;
    let aside = |i: usize| along.perp().normalize() * (0.25 * i as f64);
    (0..n)
        .map(|i| beam(aside(i), aside(i) + along, 0.05))
        .collect()
}

/// A tenth as many beams across one another on a hand's breadth, in a level of 10 n octagons.
pub fn corner(n: usize) -> Vec<Outline> {
    let mut world = super::worlds::octagons(&mut Dice::new(13), 10 * n);
    let scale = 0.1 / n as f64;
    let small = beams(n)
        .into_iter()
        .map(|outline| outline.into_iter().map(|p| p * scale).collect());
    world.extend(small.map(|outline: Outline| outline));
    world
}
