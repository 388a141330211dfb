//! The same minute of play at every tick rate: the same bits at common times; and with ticks split at random. In the quarry, and
//! from several places of the gym, which has every mechanism: platforms, ladders, belts, walls to jump from and to climb.

#[path = "common/player.rs"]
mod player;
#[path = "common/worlds.rs"]
mod worlds;

use edgewalker::game::{Shape, Stage};
use edgewalker::level;
use edgewalker::motion::{Body, Control, EventKind, Terrain, Trace};
use edgewalker::tune::{Motion, Tuning};
use glam::DVec2;
use player::quarry;
use std::path::Path;
use worlds::Dice;

/// Inputs change this often in a minute, every fifth of a second: a time that all rates share.
const STRETCHES: u32 = 300;
const PER_SECOND: u32 = 5;

/// A minute of wishes: jumps, turns, crouches, climbs, with a bias to the right.
fn wishes(seed: u64) -> Vec<Control> {
    let mut dice = Dice::new(seed);
    let mut wish = Control::default();
    (0..STRETCHES)
        .map(|_| {
            if dice.below(3) > 0 {
                let run = [1.0, 1.0, 1.0, 0.5, -1.0, 0.0][dice.below(6) as usize];
                wish = Control {
                    run,
                    jump: dice.below(2) == 0,
                    down: dice.below(8) == 0,
                    up: dice.below(3) == 0,
                };
            }
            wish
        })
        .collect()
}

/// The hero at the end of every stretch, and all events. `cuts` names the times of the ticks within one.
fn play(
    terrain: &Terrain,
    start: DVec2,
    wishes: &[Control],
    mut cuts: impl FnMut(u32) -> Vec<f64>,
) -> (Vec<Body>, Trace) {
    let mut body = Body::spawn(start, 0.0, terrain).unwrap();
    let mut trace = Trace::default();
    let bodies = (0..STRETCHES).zip(wishes).map(|(stretch, &wish)| {
        body.apply(wish, terrain, &mut trace);
        for time in cuts(stretch) {
            body.advance(time, terrain, &mut trace);
        }
        let end = f64::from(stretch + 1) / f64::from(PER_SECOND);
        body.advance(end, terrain, &mut trace);
        body.clone()
    });
    (bodies.collect(), trace)
}

/// Asserts the same bits at every rate and split for one minute; returns its events.
fn same_at_every_rate(terrain: &Terrain, start: DVec2, seed: u64) -> (Vec<Body>, Trace) {
    let wishes = wishes(seed);
    let at_rate = |rate: u32| {
        play(terrain, start, &wishes, |stretch| {
            let n = rate / PER_SECOND;
            let tick = |i| f64::from(stretch * n + i) / f64::from(rate);
            (1..=n).map(tick).collect()
        })
    };
    let (slow, trace) = at_rate(15);
    for rate in [30, 60, 120, 240, 1000] {
        let (fast, events) = at_rate(rate);
        let differs = slow.iter().zip(&fast).position(|(a, b)| a != b);
        assert_eq!(differs, None, "{rate} Hz, from {start}, seed {seed}");
        assert_eq!(events, trace, "{rate} Hz, from {start}, seed {seed}");
    }
    let mut largest: f64 = 0.0;
    for seed in 0..20 {
        let mut dice = Dice::new(seed);
        let (split, _) = play(terrain, start, &wishes, |stretch| {
            let n = dice.below(60);
            let mut times: Vec<_> = (0..n)
                .map(|_| (f64::from(stretch) + dice.unit()) / f64::from(PER_SECOND))
                .collect();
            times.sort_by(f64::total_cmp);
            times
        });
        for (a, b) in slow.iter().zip(&split) {
            largest = largest.max((a.position() - b.position()).length());
            assert_eq!(a.hash(), b.hash(), "from {start}, seed {seed}");
        }
    }
    println!("largest difference over 20 random splits of the minute: {largest:e} m");
    assert_eq!(largest, 0.0);
    (slow, trace)
}

fn count(trace: &Trace, kind: impl Fn(&EventKind) -> bool) -> usize {
    trace.events.iter().filter(|e| kind(&e.kind)).count()
}

#[test]
fn a_minute_has_the_same_bits_at_every_rate_and_split() {
    let stage = Stage::build(quarry()).unwrap();
    let tuning = Motion::default();
    let land = stage.land(&Shape::hero()).unwrap();
    let terrain = land.terrain(&stage, &tuning);
    let (_, trace) = same_at_every_rate(&terrain, stage.level.start, 11);
    assert!(count(&trace, |k| *k == EventKind::Jumped) > 20, "jumps");
    assert!(count(&trace, |k| *k == EventKind::Joint) > 10, "slopes");
    let wall = |k: &EventKind| matches!(k, EventKind::Hit(_) | EventKind::Stopped(_));
    assert!(count(&trace, wall) > 5, "walls");
}

/// Where the minutes in the gym start: the floor, the scaffold, the ladder, the shaft, the lift, the ferry, before the pusher.
const PLACES: [(f64, f64); 7] = [
    (0.0, 0.5),
    (23.0, 3.0),
    (35.3, 1.0),
    (56.6, 7.0),
    (73.8, 24.8),
    (84.8, 12.5),
    (111.6, 12.5),
];

#[test]
fn every_mechanism_has_the_same_bits_at_every_rate_and_split() {
    let file = |name: &str| {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("levels/dev")
            .join(name)
    };
    let stage = Stage::build(level::load(&file("gym.ron")).unwrap()).unwrap();
    let text = std::fs::read_to_string(file("gym.tuning.ron")).unwrap();
    let options =
        ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
    let tuning: Tuning = options.from_str(&text).unwrap();
    let land = stage.land(&Shape::hero()).unwrap();
    let terrain = land.terrain(&stage, &tuning.motion);
    let (mut all, mut rides) = (Trace::default(), 0);
    for (i, place) in PLACES.into_iter().enumerate() {
        let (bodies, trace) = same_at_every_rate(&terrain, place.into(), 100 + i as u64);
        rides += bodies.iter().filter(|b| b.carrier().is_some()).count();
        all.events.extend(trace.events);
    }
    let has = |kind: fn(&EventKind) -> bool| count(&all, kind);
    assert!(rides > 10, "{rides} stretches end on platforms");
    assert!(has(|k| *k == EventKind::WallJumped) > 3, "wall jumps");
    assert!(has(|k| *k == EventKind::Climbed) > 3, "ladders and vines");
    assert!(has(|k| matches!(k, EventKind::Entered(_))) > 3, "regions");
    assert!(
        has(|k| matches!(k, EventKind::SteppedUp(_) | EventKind::Snapped(_))) > 3,
        "steps"
    );
}
