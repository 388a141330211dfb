//! Random worlds with every mechanism, and random lives in them.

use super::case::{Build, Case, Edit, Life, World};
use super::dice::Dice;
use edgewalker::geom::{Point, check_outline, check_polyline};
use edgewalker::level::{Concave, Easing, Feature, Kind, Mover, Repeat, Starts, Stop};
use edgewalker::motion::Control;
use edgewalker::tune::Motion;
use glam::DVec2;

/// Half the width of a random level, m.
pub const REACH: f64 = 16.0;

/// How the pieces of a level lie.
#[derive(Clone, Copy, PartialEq)]
enum Family {
    /// Polygons anywhere.
    Loose,
    /// Boxes and triangles on half metres: shared and collinear edges.
    Half,
    /// Boxes on whole metres.
    Whole,
}

/// A random world.
pub fn world(dice: &mut Dice) -> World {
    let family = [Family::Loose, Family::Half, Family::Whole][dice.below(3) as usize];
    let turn = match dice.below(2) {
        0 => 0.0,
        _ => dice.between(-0.6, 0.6),
    };
    let mut features = room();
    for _ in 0..20 + dice.below(20) {
        let outline = shape(dice, family);
        features.push(solid(dice, outline));
    }
    for _ in 0..4 + dice.below(7) {
        features.push(one_way(dice, family));
    }
    for _ in 0..2 + dice.below(3) {
        features.push(stairs(dice, family));
    }
    for _ in 0..2 + dice.below(4) {
        features.push(region(dice, family));
    }
    for _ in 0..1 + dice.below(4) {
        features.push(valve(dice, family));
    }
    for _ in 0..1 + dice.below(2) {
        features.extend(ladder_to_platform(dice, family));
    }
    let mut movers: Vec<Mover> = (0..dice.below(4)).map(|_| mover(dice, family)).collect();
    movers.extend((0..1 + dice.below(3)).map(|_| machine(dice, family)));
    // Of numbers of their own, so that the rest is as it was without.
    moving_regions(&mut dice.clone(), family, &mut movers);
    let in_movers = movers.iter_mut().flat_map(|m| &mut m.features);
    for feature in features.iter_mut().chain(in_movers) {
        rotate(&mut feature.outline, turn);
    }
    features.retain(sound);
    World {
        features,
        movers,
        tuning: tuning(dice),
        body: [Build::Hero, Build::Hero, Build::Small, Build::Wide][dice.below(4) as usize],
        rate: [30.0, 60.0, 120.0, 240.0, 1000.0][dice.below(5) as usize],
    }
}

/// A life of a body in a world.
pub fn life(dice: &mut Dice, world: &World, start: DVec2, since: u64, ticks: u64) -> Life {
    let (mut inputs, mut n) = (Vec::new(), 1);
    while n <= ticks {
        inputs.push((n, control(dice)));
        n += 1 + dice.below((world.rate * 0.7) as u32) as u64;
    }
    let mut edits = Vec::new();
    if dice.below(3) == 0 {
        for _ in 0..1 + dice.below(4) {
            edits.push((1 + dice.below(ticks as u32) as u64, edit(dice, world)));
        }
        edits.sort_by_key(|e| e.0);
    }
    Life {
        since,
        start,
        inputs,
        edits,
        ticks,
    }
}

/// Somewhere in the room.
pub fn spot(dice: &mut Dice) -> DVec2 {
    DVec2::new(dice.between(-REACH, REACH), dice.between(-7.0, 9.0))
}

/// A control that is held for a while.
fn control(dice: &mut Dice) -> Control {
    let through = dice.below(10) == 0;
    Control {
        run: [-1.0, 1.0, -1.0, 1.0, 0.0, 51.0 / 127.0][dice.below(6) as usize],
        jump: dice.below(3) == 0 || through,
        down: dice.below(6) == 0 || through,
        up: dice.below(5) == 0,
    }
}

fn edit(dice: &mut Dice, world: &World) -> Edit {
    match dice.below(4) {
        0 => {
            let outline = shape(dice, Family::Loose);
            Edit::Insert(solid(dice, outline))
        }
        1 => {
            let outline = gon(dice, DVec2::ZERO);
            Edit::InsertHere(solid(dice, outline))
        }
        2 => Edit::Remove(3 + dice.below(world.features.len() as u32 - 3) as u32),
        _ => Edit::RemoveGround,
    }
}

/// Floor and walls, which are never removed at random.
fn room() -> Vec<Feature> {
    [
        rect(-REACH - 2.0, -10.0, REACH + 2.0, -8.0),
        rect(-REACH - 2.0, -10.0, -REACH, 12.0),
        rect(REACH, -10.0, REACH + 2.0, 12.0),
    ]
    .map(|outline| Feature {
        outline,
        ..Feature::default()
    })
    .to_vec()
}

fn solid(dice: &mut Dice, outline: Vec<DVec2>) -> Feature {
    Feature {
        climbable: dice.below(4) == 0,
        conveyor: belt(dice),
        friction: (dice.below(6) == 0).then(|| dice.between(0.0, 1.5)),
        concave: [None, None, Some(Concave::Keep), Some(Concave::Project)][dice.below(4) as usize],
        outline,
        ..Feature::default()
    }
}

/// Steps up to the right or down, all of one height: for step-up and floor snap.
fn stairs(dice: &mut Dice, family: Family) -> Feature {
    let (from, steps) = (place(dice, family), 2 + dice.below(6));
    let (wide, high) = (dice.between(0.3, 1.5), dice.between(0.05, 0.35));
    let high = if dice.below(2) == 0 { high } else { -high };
    let end = from + DVec2::new(wide, high) * f64::from(steps);
    let low = from.y.min(end.y) - 1.0;
    let mut outline = vec![DVec2::new(from.x, low), DVec2::new(end.x, low)];
    for i in (0..steps).rev() {
        let at = |right: i32| from + DVec2::new(wide * f64::from(i + right), high * f64::from(i));
        outline.extend([at(1), at(0)]);
    }
    solid(dice, outline)
}

/// The speed of a conveyor, mostly 0.
fn belt(dice: &mut Dice) -> f64 {
    match dice.below(6) {
        0 => [-3.0, 3.0, dice.between(-6.0, 6.0)][dice.below(3) as usize],
        _ => 0.0,
    }
}

/// A line of one to three edges from left to right.
fn one_way(dice: &mut Dice, family: Family) -> Feature {
    let mut at = place(dice, family);
    let mut outline = vec![at];
    for _ in 0..1 + dice.below(3) {
        let slope = if dice.below(2) == 0 {
            0.0
        } else {
            dice.between(-1.2, 1.2)
        };
        let run = f64::from(1 + dice.below(3));
        at += DVec2::new(run, run * slope);
        outline.push(at);
    }
    Feature {
        kind: Kind::OneWay,
        conveyor: belt(dice),
        outline,
        ..Feature::default()
    }
}

/// A line of one to three edges in any direction, mostly upright or from right to left.
fn valve(dice: &mut Dice, family: Family) -> Feature {
    let mut at = place(dice, family);
    let mut outline = vec![at];
    for _ in 0..1 + dice.below(3) {
        let long = f64::from(1 + dice.below(3));
        at += match dice.below(4) {
            0 => DVec2::new(0.0, long),
            1 => DVec2::new(0.0, -long),
            2 => DVec2::new(-long, 0.0),
            _ => DVec2::new(dice.between(-long, long), dice.between(-long, long)),
        };
        outline.push(at);
    }
    Feature {
        kind: Kind::OneWay,
        outline,
        ..Feature::default()
    }
}

/// A ladder, and a platform about as high as its end, across it or beside it; sometimes one at its foot.
fn ladder_to_platform(dice: &mut Dice, family: Family) -> Vec<Feature> {
    let at = place(dice, family);
    let top = at.y + f64::from(2 + dice.below(4));
    let ends = match dice.below(2) {
        0 => top,
        _ => top + dice.between(-0.7, 0.5),
    };
    let board = |y: f64, x0: f64, x1: f64| Feature {
        kind: Kind::OneWay,
        outline: vec![DVec2::new(x0, y), DVec2::new(x1, y)],
        ..Feature::default()
    };
    let mut features = vec![Feature {
        kind: Kind::Ladder,
        outline: rect(at.x, at.y, at.x + 1.0, ends),
        ..Feature::default()
    }];
    match dice.below(3) {
        0 => features.push(board(top, at.x - 1.0, at.x + 2.0)),
        1 => features.push(board(top, at.x + 1.25, at.x + 4.0)),
        _ => {
            let sides = [(at.x - 3.0, at.x - 0.25), (at.x + 1.25, at.x + 4.0)];
            for (x0, x1) in sides {
                let outline = rect(x0, top - 0.5, x1, top);
                features.push(solid(dice, outline));
            }
        }
    }
    if dice.below(2) == 0 {
        features.push(board(at.y, at.x - 1.0, at.x + 2.0));
    }
    features
}

fn region(dice: &mut Dice, family: Family) -> Feature {
    let at = place(dice, family);
    let ladder = dice.below(2) == 0;
    let (w, h) = match ladder {
        true => (0.75, f64::from(2 + dice.below(6))),
        false => (dice.between(0.5, 4.0), dice.between(0.5, 4.0)),
    };
    Feature {
        kind: if ladder { Kind::Ladder } else { Kind::Trigger },
        outline: rect(at.x, at.y, at.x + w, at.y + h),
        ..Feature::default()
    }
}

/// A platform, a lift, a crusher: whatever its way makes of it.
fn mover(dice: &mut Dice, family: Family) -> Mover {
    let at = place(dice, family);
    let outline = match dice.below(4) {
        0 => gon(dice, at),
        _ => rect(
            at.x,
            at.y,
            at.x + 1.0 + f64::from(dice.below(3)),
            at.y + 0.5,
        ),
    };
    let body = match dice.below(6) {
        0 => one_way(dice, family),
        1 => valve(dice, family),
        _ => solid(dice, outline),
    };
    let mut path: Vec<Stop> = (0..2 + dice.below(2)).map(|_| stop(dice)).collect();
    path[0].at = DVec2::ZERO;
    Mover {
        id: String::new(),
        features: vec![body],
        path,
        repeat: [Repeat::Loop, Repeat::PingPong][dice.below(2) as usize],
        starts: Default::default(),
        ..Mover::default()
    }
}

/// Regions on what moves, and some that move alone; and some of what moves begins only when it is ridden.
fn moving_regions(dice: &mut Dice, family: Family, movers: &mut Vec<Mover>) {
    for mover in movers.iter_mut() {
        let (low, high) = mover.features[0]
            .outline
            .iter()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| {
                (low.min(*p), high.max(*p))
            });
        let outline = match dice.below(4) {
            0 => rect(low.x, low.y - 0.5, high.x, low.y), // spikes below
            1 => rect(low.x - 0.5, low.y, high.x + 0.5, high.y + 4.0),
            _ => continue,
        };
        let on_top = dice.below(2) == 0;
        let ladder = Feature {
            kind: Kind::Ladder,
            outline: rect(high.x - 0.75, high.y, high.x, high.y + 5.0),
            ..Feature::default()
        };
        let plain = Feature {
            kind: Kind::Trigger,
            outline,
            ..Feature::default()
        };
        mover.features.push(if on_top { ladder } else { plain });
    }
    for _ in 0..dice.below(3) {
        let mut alone = mover(dice, family);
        alone.features = vec![region(dice, family)];
        movers.push(alone);
    }
    for mover in movers.iter_mut() {
        if dice.below(4) == 0 {
            mover.starts = Starts::Ridden;
        }
    }
}

/// A block that comes down to the floor, or sweeps over it, or a lift that comes up out of it.
fn machine(dice: &mut Dice, family: Family) -> Mover {
    let x = place(dice, family).x;
    let kind = dice.below(3) as usize;
    let outline = match kind {
        0 => rect(x, -7.75, x + 0.5, -5.0),
        1 => rect(x, -5.5, x + 5.0, -4.5),
        _ => rect(x, -9.0, x + 4.0, -8.25),
    };
    let side = [-9.0, 9.0][dice.below(2) as usize];
    let way = [(side, 0.0), (0.0, -2.5), (0.0, 1.5)].map(DVec2::from)[kind];
    let stop = |at: DVec2, dice: &mut Dice| Stop { at, ..stop(dice) };
    Mover {
        id: String::new(),
        features: vec![solid(dice, outline)],
        path: vec![stop(DVec2::ZERO, dice), stop(way, dice)],
        repeat: Repeat::PingPong,
        starts: Default::default(),
        ..Mover::default()
    }
}

fn stop(dice: &mut Dice) -> Stop {
    let half = |dice: &mut Dice, n: u32| f64::from(dice.below(2 * n + 1) - n as i32) * 0.5;
    let at = match dice.below(3) {
        0 => DVec2::new(half(dice, 10), 0.0),
        1 => DVec2::new(0.0, half(dice, 8)),
        _ => DVec2::new(half(dice, 8), half(dice, 6)),
    };
    Stop {
        at,
        wait: [0.0, 0.5][dice.below(2) as usize],
        seconds: dice.between(0.5, 3.0),
        easing: [Easing::Linear, Easing::Eased][dice.below(2) as usize],
    }
}

fn place(dice: &mut Dice, family: Family) -> DVec2 {
    let at = DVec2::new(dice.between(-REACH, REACH), dice.between(-8.5, 6.0));
    match family {
        Family::Loose => at,
        Family::Half => (at * 2.0).round() / 2.0,
        Family::Whole => at.round(),
    }
}

fn shape(dice: &mut Dice, family: Family) -> Vec<DVec2> {
    let at = place(dice, family);
    let (w, h) = (
        f64::from(1 + dice.below(8)) / 2.0,
        f64::from(1 + dice.below(4)) / 2.0,
    );
    match family {
        Family::Loose => gon(dice, at),
        Family::Half if dice.below(2) == 0 => {
            vec![at, at + DVec2::new(w, 0.0), at + DVec2::new(w, h)]
        }
        Family::Half => rect(at.x, at.y, at.x + w, at.y + h),
        Family::Whole => rect(at.x, at.y, at.x + (w + 0.5).floor(), at.y + 1.0),
    }
}

fn rect(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<DVec2> {
    [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        .map(DVec2::from)
        .to_vec()
}

/// A polygon of 3 to 6 corners on an ellipse.
fn gon(dice: &mut Dice, at: DVec2) -> Vec<DVec2> {
    let n = 3 + dice.below(4) as u32;
    let (wide, tall) = (dice.between(0.5, 4.0), dice.between(0.5, 2.5));
    let start = dice.between(0.0, 6.0);
    let corner = |i: u32| {
        let angle = start + f64::from(i) / f64::from(n) * std::f64::consts::TAU;
        at + DVec2::new(wide * libm::cos(angle), tall * libm::sin(angle))
    };
    (0..n).map(corner).collect()
}

/// Turns an outline about the origin and puts it on the grid.
fn rotate(outline: &mut [DVec2], turn: f64) {
    let (sin, cos) = (libm::sin(turn), libm::cos(turn));
    for p in outline {
        let turned = DVec2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
        *p = Point::snap(turned).unwrap().metres();
    }
}

/// Whether the level reader would take the outline.
pub fn sound(feature: &Feature) -> bool {
    let corners = feature.snapped();
    match feature.kind {
        Kind::OneWay => check_polyline(&corners).is_ok(),
        _ => check_outline(&corners).is_ok(),
    }
}

/// Every mechanism on in most worlds, off in some.
fn tuning(dice: &mut Dice) -> Motion {
    let mut some = |low: f64, high: f64| match dice.below(4) {
        0 => 0.0,
        _ => dice.between(low, high),
    };
    let mechanisms = Motion {
        slope_gravity: some(0.1, 1.0),
        friction: some(0.0, 1.0),
        slope_speed: some(0.0, 0.6),
        floor_snap: some(0.1, 0.5),
        step_up: some(0.05, 0.6),
        corner_correction: some(0.05, 0.3),
        ledge_correction: some(0.05, 0.3),
        wall_slide_speed: some(1.0, 8.0),
        wall_jump_out: some(4.0, 12.0),
        wall_jump_up: some(6.0, 16.0),
        wall_jump_lock: some(0.05, 0.3),
        wall_grace: some(0.02, 0.2),
        ledge_hang: some(0.8, 1.6),
        ledge_magnet: some(0.05, 0.4),
        lift_memory: some(0.05, 0.3),
        climb_speed: some(2.0, 6.0),
        ..Motion::default()
    };
    Motion {
        joint: f64::from(dice.below(3)),
        concave: f64::from(dice.below(2)),
        max_slope: [1.0, 1.0, 0.5, 2.0][dice.below(4) as usize],
        run_speed: dice.between(2.0, 20.0),
        gravity: [45.0, 45.0, 30.0, dice.between(5.0, 90.0)][dice.below(4) as usize],
        ..mechanisms
    }
}

/// The outlines of solids elsewhere, which nobody meets.
pub fn far_away(dice: &mut Dice) -> Vec<Feature> {
    let mut features: Vec<Feature> = (0..20)
        .map(|_| {
            let at = DVec2::new(dice.between(60.0, 90.0), dice.between(-50.0, 50.0));
            let outline = gon(dice, at);
            let mut feature = solid(dice, outline);
            rotate(&mut feature.outline, 0.0);
            feature
        })
        .collect();
    features.retain(sound);
    features
}

/// A case of its own: the first life of a random world.
pub fn case(seed: u64, ticks: u64) -> Case {
    let mut dice = Dice::new(seed);
    let world = world(&mut dice);
    let start = spot(&mut dice);
    let life = life(&mut dice, &world, start, 0, ticks);
    Case { seed, world, life }
}
