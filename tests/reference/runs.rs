//! Random runs: a world, a shape, a tuning and inputs held for random times.

use super::double::Vector;
use super::outline::World;
use super::worlds::{self, Dice};
use edgewalker::geom::{Collider, Point};
use edgewalker::motion::Control;
use edgewalker::tune::Motion;
use glam::DVec2;

/// Ticks of a run: two seconds.
const TICKS: usize = 120;

/// One run, as a value.
pub struct Run {
    pub outlines: Vec<Vec<Point>>,
    pub collider: Collider,
    pub tuning: Motion,
    pub start: DVec2,
    /// For each tick.
    pub controls: Vec<Control>,
}

fn metres(p: (f64, f64)) -> DVec2 {
    DVec2::new(p.0, p.1)
}

fn rectangle(from: DVec2, to: DVec2) -> Vec<DVec2> {
    vec![from, DVec2::new(to.x, from.y), to, DVec2::new(from.x, to.y)]
}

/// Ground from left to right with a random top, down to a depth.
fn terrain(dice: &mut Dice) -> Vec<DVec2> {
    let corners = 3 + dice.below(6);
    let step = 16.0 / f64::from(corners);
    let (mut outline, mut y) = (vec![metres((-8.0, -6.0)), metres((8.0, -6.0))], 0.0);
    for i in 0..=corners {
        let x = 8.0 - f64::from(i) * step
            + if i % corners == 0 {
                0.0
            } else {
                dice.between(-0.4, 0.4) * step
            };
        outline.push(metres((x, y)));
        y = (y + dice.between(-1.5, 1.5)).clamp(-4.0, 3.0);
    }
    outline
}

/// On a lattice: boxes and triangles with shared and collinear edges.
fn block(dice: &mut Dice) -> Vec<DVec2> {
    let half = |n: u32, dice: &mut Dice| 0.5 * f64::from(dice.below(n));
    let at = DVec2::new(half(24, dice) - 6.0, half(12, dice) - 4.0);
    let size = DVec2::new(0.5 + half(12, dice), 0.5 + half(5, dice));
    let mut corners = rectangle(at, at + size);
    if dice.below(3) == 0 {
        corners.remove(dice.below(4) as usize);
    }
    corners
}

/// Three to eight outlines of one of three families.
fn outlines(dice: &mut Dice) -> Vec<Vec<Point>> {
    let family = dice.below(3);
    let count = 3 + dice.below(6) as usize;
    let mut world = Vec::new();
    if family == 0 {
        world.push(terrain(dice));
    }
    while world.len() < count {
        let centre = DVec2::new(dice.between(-6.0, 6.0), dice.between(-4.0, 3.0));
        let corners = 3 + dice.below(6) as usize;
        let far = dice.between(0.6, 3.5);
        world.push(match (family, world.len()) {
            (2, _) => block(dice),
            (1, 0) => rectangle(metres((-7.0, -6.0)), metres((7.0, -3.0))),
            _ => worlds::star(dice, centre, corners, 0.4 * far, far),
        });
    }
    worlds::snapped(&world)
}

fn shape(dice: &mut Dice) -> Collider {
    match dice.below(4) {
        0 => Collider::point(),
        1 => worlds::centred_box(13.0 / 32.0, 29.0 / 32.0),
        2 => Collider::hero_crouched(),
        _ => Collider::hero(),
    }
}

fn tuning(dice: &mut Dice) -> Motion {
    Motion {
        run_speed: dice.between(2.0, 12.0),
        run_accel: dice.between(20.0, 150.0),
        run_brake: dice.between(20.0, 150.0),
        over_speed_decay: dice.between(5.0, 60.0),
        crouch_speed: dice.between(1.0, 5.0),
        air_accel: dice.between(10.0, 90.0),
        air_brake: dice.between(5.0, 60.0),
        gravity: dice.between(20.0, 60.0),
        jump_speed: dice.between(6.0, 18.0),
        jump_cut_speed: dice.between(0.0, 8.0),
        jump_cut_brake: dice.between(0.0, 1000.0),
        jump_least: dice.between(0.0, 1.0),
        apex_speed: dice.between(0.0, 4.0),
        apex_gravity: dice.between(0.3, 1.0),
        fall_speed: dice.between(8.0, 30.0),
        fast_fall_speed: dice.between(12.0, 40.0),
        fast_fall_gravity: dice.between(1.0, 2.0),
        coyote_time: dice.between(0.0, 0.2),
        jump_buffer: dice.between(0.0, 0.2),
        max_slope: [1.0, 0.5, 2.0, 0.8][dice.below(4) as usize],
        joint: f64::from(dice.below(3)),
        joint_stick: dice.between(0.0, 60.0),
        joint_span: dice.between(0.3, 2.0),
        concave: f64::from(dice.below(2)),
        // What the reference does not know.
        floor_snap: 0.0,
        step_up: 0.0,
        corner_correction: 0.0,
        ledge_correction: 0.0,
        wall_slide_speed: 0.0,
        wall_jump_up: 0.0,
        ledge_hang: 0.0,
        ..Motion::default()
    }
}

/// Controls held for random times.
fn controls(dice: &mut Dice) -> Vec<Control> {
    let mut all = Vec::new();
    while all.len() < TICKS {
        let control = Control {
            run: [-1.0, 1.0, -1.0, 1.0, 0.0, dice.between(-1.0, 1.0)][dice.below(6) as usize],
            jump: dice.below(2) == 0,
            down: dice.below(6) == 0,
            ..Control::default()
        };
        let held = 1 + dice.below(30) as usize;
        all.extend(std::iter::repeat_n(control, held));
    }
    all.truncate(TICKS);
    all
}

impl Run {
    /// The run of a seed.
    pub fn new(seed: u64) -> Run {
        let mut dice = Dice::new(seed);
        let (outlines, collider) = (outlines(&mut dice), shape(&mut dice));
        let world = World::new(&outlines, &collider);
        let start = loop {
            let p = DVec2::new(dice.between(-6.0, 6.0), dice.between(-3.0, 5.0));
            if world.depth(Vector::new(p.x, p.y)) < -0.01 {
                break p;
            }
        };
        Run {
            outlines,
            collider,
            tuning: tuning(&mut dice),
            start,
            controls: controls(&mut dice),
        }
    }
}
