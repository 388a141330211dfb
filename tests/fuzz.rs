//! A seeded fuzz test of the motion: random levels, random controls, every invariant after every tick and every event.
//! `FUZZ_TICKS`, `FUZZ_SEED` and `FUZZ_WORLDS` lengthen it and move it.

#[path = "common/worlds.rs"]
mod worlds;

use edgewalker::geom::{Collider, Point, expand};
use edgewalker::mesh::Mesh;
use edgewalker::motion::{
    Body, Control, EventKind, Mode, Terrain, Trace, check::check, vertex::JOINT_STEPS,
};
use edgewalker::tune::Motion;
use glam::DVec2;
use std::collections::BTreeMap;
use worlds::Dice;

/// Half the width of a random level, m.
const REACH: f64 = 22.0;

/// The outlines of a random level: a floor and a litter of polygons of one of the world families, perhaps rotated.
fn level(dice: &mut Dice) -> Vec<Vec<Point>> {
    let family = dice.below(3);
    let turn = if dice.below(2) == 0 {
        0.0
    } else {
        dice.between(-0.6, 0.6)
    };
    let (sin, cos) = (libm::sin(turn), libm::cos(turn));
    let mut outlines: Vec<Vec<DVec2>> = vec![
        rect(-REACH - 2.0, -12.0, REACH + 2.0, -10.0),
        rect(-REACH - 2.0, -12.0, -REACH, 12.0),
        rect(REACH, -12.0, REACH + 2.0, 12.0),
    ];
    for _ in 0..30 + dice.below(30) {
        let at = DVec2::new(dice.between(-REACH, REACH), dice.between(-11.0, 8.0));
        outlines.push(match family {
            0 => gon(dice, at),
            1 => {
                let at = (at * 2.0).round() / 2.0;
                let (w, h) = (
                    f64::from(1 + dice.below(8)) / 2.0,
                    f64::from(1 + dice.below(4)) / 2.0,
                );
                if dice.below(2) == 0 {
                    rect(at.x, at.y, at.x + w, at.y + h)
                } else {
                    vec![at, at + DVec2::new(w, 0.0), at + DVec2::new(w, h)]
                }
            }
            _ => {
                let at = at.round();
                rect(
                    at.x,
                    at.y,
                    at.x + 1.0 + f64::from(dice.below(4)),
                    at.y + 1.0,
                )
            }
        });
    }
    let place =
        |p: DVec2| Point::snap(DVec2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y)).unwrap();
    outlines
        .iter()
        .map(|o| o.iter().map(|&p| place(p)).collect())
        .collect()
}

fn rect(x0: f64, y0: f64, x1: f64, y1: f64) -> Vec<DVec2> {
    vec![
        DVec2::new(x0, y0),
        DVec2::new(x1, y0),
        DVec2::new(x1, y1),
        DVec2::new(x0, y1),
    ]
}

/// A polygon of 3 to 6 corners on an ellipse.
fn gon(dice: &mut Dice, at: DVec2) -> Vec<DVec2> {
    let (n, wide, tall, start) = (
        3 + dice.below(4) as u32,
        dice.between(0.5, 4.0),
        dice.between(0.5, 2.5),
        dice.between(0.0, 6.0),
    );
    let corner = |i: u32| {
        let angle = start + f64::from(i) / f64::from(n) * std::f64::consts::TAU;
        at + DVec2::new(wide * libm::cos(angle), tall * libm::sin(angle))
    };
    (0..n).map(corner).collect()
}

fn mirrored(outlines: &[Vec<Point>]) -> Vec<Vec<Point>> {
    outlines
        .iter()
        .map(|o| o.iter().rev().map(|p| Point::new(-p.x, p.y)).collect())
        .collect()
}

fn meshes(outlines: &[Vec<Point>]) -> [Mesh; 2] {
    [Collider::hero(), Collider::hero_crouched()].map(|collider| {
        let features: Vec<_> = outlines.iter().map(|o| expand(o, &collider)).collect();
        Mesh::build(&features).unwrap()
    })
}

/// A control that is held for a while.
fn control(dice: &mut Dice) -> Control {
    let run = [-1.0, 1.0, -1.0, 1.0, 0.0, 0.4][dice.below(6) as usize];
    Control {
        run,
        jump: dice.below(3) == 0,
        down: dice.below(6) == 0,
        up: false,
    }
}

fn tuning(dice: &mut Dice) -> Motion {
    Motion {
        joint: f64::from(dice.below(3)),
        concave: f64::from(dice.below(2)),
        max_slope: [1.0, 1.0, 0.5, 2.0][dice.below(4) as usize],
        run_speed: dice.between(2.0, 20.0),
        ..Motion::default()
    }
}

/// What a run did, to show that it did something.
#[derive(Default)]
struct Tally {
    ticks: u64,
    modes: BTreeMap<&'static str, u64>,
    events: BTreeMap<&'static str, u64>,
}

impl Tally {
    fn note(&mut self, body: &Body, trace: &Trace) {
        self.ticks += 1;
        let mode = match body.mode() {
            Mode::Air(_) => "air",
            Mode::Surface(_) if body.supported() => "ground",
            Mode::Surface(_) => "slide",
            Mode::Wedge(_) => "wedge",
            Mode::Crushed(_) => "crushed",
        };
        *self.modes.entry(mode).or_default() += 1;
        for event in &trace.events {
            let kind = match event.kind {
                EventKind::Jumped => "jumped",
                EventKind::Left => "left",
                EventKind::Landed(_) => "landed",
                EventKind::Hit(_) => "hit",
                EventKind::Parted => "parted",
                EventKind::Joint => "joint",
                EventKind::Stopped(_) => "stopped",
                EventKind::Wedged => "wedged",
                EventKind::Resized(_) => "resized",
                EventKind::Limit => "limit",
                EventKind::Stuck => "stuck",
                _ => "other",
            };
            *self.events.entry(kind).or_default() += 1;
        }
    }
}

/// A tick, event by event. I4: no time is left. I6: no event lifts or speeds up a body, or moves it further than a joint may.
fn tick(body: &mut Body, to: f64, terrain: &Terrain, trace: &mut Trace) -> Result<(), String> {
    while let Some(at) = body.next_at().filter(|&at| at <= to) {
        let (p, v) = body.forecast(at);
        let events = trace.events.len();
        body.advance(at, terrain, trace);
        let news = &trace.events[events..];
        if news.iter().any(|e| e.kind == EventKind::Jumped) {
            continue;
        }
        let (q, w) = (body.position(), body.velocity());
        let slack = f64::from(2 * JOINT_STEPS) * edgewalker::geom::STEP * (1 + news.len()) as f64;
        if (q - p).length() > slack {
            return Err(format!(
                "I6: an event moved the body by {} at {p}: {news:?}",
                q - p
            ));
        }
        if w.length() > v.length() * (1.0 + 1e-12) + 1e-12 {
            return Err(format!(
                "I6: an event sped the body up from {v} to {w} at {p}: {news:?}"
            ));
        }
    }
    body.advance(to, terrain, trace);
    if body.time() != to {
        return Err(format!("I4: {} s left", to - body.time()));
    }
    Ok(())
}

/// Free places to start from.
fn start(dice: &mut Dice, terrain: &Terrain, time: f64) -> Body {
    loop {
        let at = DVec2::new(dice.between(-REACH, REACH), dice.between(-9.0, 10.0));
        if let Ok(body) = Body::spawn(at, time, terrain) {
            return body;
        }
    }
}

/// Runs one random level; every failure names its seed.
fn run(seed: u64, ticks: u64, tally: &mut Tally) -> Result<(), String> {
    let mut dice = Dice::new(seed);
    let outlines = level(&mut dice);
    let [stand, crouch] = meshes(&outlines);
    let tuning = tuning(&mut dice);
    let terrain = Terrain::new(&stand, &crouch, &tuning);
    let rate = [30.0, 60.0, 120.0, 240.0, 1000.0][dice.below(5) as usize];
    let mut body = start(&mut dice, &terrain, 0.0);
    let (mut trace, mut hold, mut born) = (Trace::default(), 0, 0);
    for n in 1..=ticks {
        trace.clear();
        if hold == 0 {
            hold = 1 + dice.below((rate * 0.7) as u32);
            body.apply(control(&mut dice), &terrain, &mut trace);
        }
        hold -= 1;
        let to = n as f64 / rate;
        let context = |e: String, body: &Body| {
            format!(
                "seed {seed}, tick {n} at {rate} Hz, {}: {e}, {:?} {:?}",
                body.position(),
                body.velocity(),
                body.control()
            )
        };
        tick(&mut body, to, &terrain, &mut trace).map_err(|e| context(e, &body))?;
        tally.note(&body, &trace);
        if trace.events.iter().any(|e| e.kind == EventKind::Stuck) {
            let cycle: Vec<_> = trace.events.iter().rev().take(5).collect();
            return Err(context(format!("a cycle of events {cycle:?}"), &body));
        }
        check(&body, &terrain, &trace).map_err(|e| context(e, &body))?;
        if body.position().y < -60.0 || n - born > (20.0 * rate) as u64 {
            body = start(&mut dice, &terrain, to);
            (born, hold) = (n, 0);
        }
    }
    Ok(())
}

fn env(name: &str, default: u64) -> u64 {
    std::env::var(name)
        .ok()
        .map_or(default, |s| s.parse().expect("a number"))
}

#[test]
fn a_million_random_ticks_keep_every_invariant() {
    let (wanted, mut seed) = (env("FUZZ_TICKS", 1_000_000), env("FUZZ_SEED", 1));
    let mut tally = Tally::default();
    let mut failures = Vec::new();
    while tally.ticks < wanted {
        if let Err(failure) = run(seed, 4_000, &mut tally) {
            eprintln!("{failure}");
            failures.push(failure);
            assert!(failures.len() < 10, "too many failures");
        }
        seed += 1;
    }
    println!(
        "{} ticks, modes {:?}, events {:?}",
        tally.ticks, tally.modes, tally.events
    );
    assert_eq!(failures, Vec::<String>::new());
    for (mode, count) in &tally.modes {
        assert!(*count * 10_000 > tally.ticks, "{mode} is too rare: {count}");
    }
    assert_eq!(tally.modes.len(), 4);
    assert_eq!(tally.events.len(), 10, "every kind of event but `stuck`");
}

/// One random run as a list of states at common times; `split` cuts every stretch between inputs into ticks.
fn states(
    seed: u64,
    outlines: &[Vec<Point>],
    sign: f64,
    split: impl Fn(&mut Dice) -> u32,
    resume: bool,
) -> Vec<[u64; 4]> {
    let mut dice = Dice::new(seed ^ 0x5eed);
    let [stand, crouch] = meshes(outlines);
    let tuning = tuning(&mut dice);
    let terrain = Terrain::new(&stand, &crouch, &tuning);
    let mut body = loop {
        let at = DVec2::new(sign * dice.between(-REACH, REACH), dice.between(-9.0, 10.0));
        if let Ok(body) = Body::spawn(at, 0.0, &terrain) {
            break body;
        }
    };
    let mut cuts = Dice::new(seed);
    let mut trace = Trace::default();
    let mut out = Vec::new();
    for stretch in 0..100u32 {
        let wish = control(&mut dice);
        body.apply(
            Control {
                run: wish.run * sign,
                ..wish
            },
            &terrain,
            &mut trace,
        );
        let (from, to) = (f64::from(stretch) / 10.0, f64::from(stretch + 1) / 10.0);
        let ticks = split(&mut cuts);
        for tick in 1..ticks {
            body.advance(
                from + (to - from) * f64::from(tick) / f64::from(ticks),
                &terrain,
                &mut trace,
            );
        }
        body.advance(to, &terrain, &mut trace);
        if resume {
            body = ron::from_str(&ron::to_string(&body).unwrap()).unwrap();
        }
        let (p, v) = (body.position(), body.velocity());
        out.push([p.x * sign + 0.0, p.y + 0.0, v.x * sign + 0.0, v.y + 0.0].map(f64::to_bits));
    }
    out
}

#[test]
fn the_same_bits_again_resumed_mirrored_split_and_far_from_edits() {
    for seed in 0..env("FUZZ_WORLDS", 300) {
        let outlines = level(&mut Dice::new(seed));
        let once = states(seed, &outlines, 1.0, |_| 1, false);
        assert_eq!(
            once,
            states(seed, &outlines, 1.0, |_| 1, false),
            "I7, again, seed {seed}"
        );
        assert_eq!(
            once,
            states(seed, &outlines, 1.0, |_| 3, true),
            "I7, resumed, seed {seed}"
        );
        assert_eq!(
            once,
            states(
                seed,
                &outlines,
                1.0,
                |dice| 1 + dice.below(40) as u32,
                false
            ),
            "split at random, seed {seed}"
        );
        assert_eq!(
            once,
            states(seed, &mirrored(&outlines), -1.0, |_| 2, false),
            "I7, mirrored, seed {seed}"
        );
        let mut edited = outlines.clone();
        for _ in 0..20 {
            let dice = &mut Dice::new(seed + 100);
            let at = DVec2::new(dice.between(60.0, 90.0), dice.between(-50.0, 50.0));
            edited.push(
                gon(dice, at)
                    .iter()
                    .map(|&p| Point::snap(p).unwrap())
                    .collect(),
            );
        }
        assert_eq!(
            once,
            states(seed, &edited, 1.0, |_| 1, false),
            "I9, seed {seed}"
        );
    }
}

#[test]
fn idle_is_frozen() {
    let mut rested = 0;
    for seed in 200..260 {
        let mut dice = Dice::new(seed);
        let [stand, crouch] = meshes(&level(&mut dice));
        let tuning = Motion::default();
        let terrain = Terrain::new(&stand, &crouch, &tuning);
        let mut body = start(&mut dice, &terrain, 0.0);
        let mut trace = Trace::default();
        body.advance(20.0, &terrain, &mut trace);
        if body.velocity() != DVec2::ZERO {
            continue;
        }
        rested += 1;
        let before = (body.position(), body.normal());
        body.advance(3620.0, &terrain, &mut trace);
        assert_eq!((body.position(), body.normal()), before, "I8, seed {seed}");
    }
    assert!(rested > 40, "{rested} of 60 came to rest");
}
