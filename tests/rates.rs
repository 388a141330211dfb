//! The same minute of play at every tick rate: the same bits at common times; and with ticks split at random.

#[path = "common/player.rs"]
mod player;
#[path = "common/worlds.rs"]
mod worlds;

use edgewalker::game::{Shape, Stage};
use edgewalker::motion::{Body, Control, EventKind, Terrain, Trace};
use edgewalker::tune::Motion;
use glam::DVec2;
use player::quarry;
use worlds::Dice;

/// Inputs change every tenth of a second.
const STRETCHES: u32 = 600;

/// A minute of wishes: jumps, turns, crouches, with a bias to the right.
fn wishes() -> Vec<Control> {
    let mut dice = Dice::new(11);
    let mut wish = Control::default();
    (0..STRETCHES)
        .map(|_| {
            if dice.below(3) == 0 {
                let run = [1.0, 1.0, 1.0, 0.5, -1.0, 0.0][dice.below(6) as usize];
                wish = Control {
                    run,
                    jump: dice.below(2) == 0,
                    down: dice.below(8) == 0,
                    up: false,
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
    mut cuts: impl FnMut(u32) -> Vec<f64>,
) -> (Vec<Body>, Trace) {
    let mut body = Body::spawn(start, 0.0, terrain).unwrap();
    let mut trace = Trace::default();
    let bodies = (0..STRETCHES).zip(wishes()).map(|(stretch, wish)| {
        body.apply(wish, terrain, &mut trace);
        for time in cuts(stretch) {
            body.advance(time, terrain, &mut trace);
        }
        body.advance(f64::from(stretch + 1) / 10.0, terrain, &mut trace);
        body.clone()
    });
    (bodies.collect(), trace)
}

#[test]
fn a_minute_has_the_same_bits_at_every_rate_and_split() {
    let stage = Stage::build(quarry()).unwrap();
    let tuning = Motion::default();
    let land = stage.land(&Shape::hero()).unwrap();
    let terrain = land.terrain(&stage, &tuning);
    let start = stage.level.start;
    let at_rate = |rate: u32| {
        play(&terrain, start, |stretch| {
            let n = rate / 10;
            (1..=n)
                .map(|i| f64::from(stretch * n + i) / f64::from(rate))
                .collect()
        })
    };
    let (slow, trace) = at_rate(30);
    let has = |kind: fn(&EventKind) -> bool| trace.events.iter().filter(|e| kind(&e.kind)).count();
    assert!(
        has(|k| *k == EventKind::Jumped) > 20 && has(|k| *k == EventKind::Joint) > 10,
        "jumps and slopes"
    );
    assert!(
        has(|k| matches!(k, EventKind::Hit(_) | EventKind::Stopped(_))) > 5,
        "walls"
    );
    for rate in [60, 120, 240, 1000] {
        assert_eq!(at_rate(rate), (slow.clone(), trace.clone()), "{rate} Hz");
    }
    let mut largest: f64 = 0.0;
    for seed in 0..20 {
        let mut dice = Dice::new(seed);
        let (split, _) = play(&terrain, start, |stretch| {
            let n = dice.below(30);
            let mut times: Vec<_> = (0..n)
                .map(|_| (f64::from(stretch) + dice.unit()) / 10.0)
                .collect();
            times.sort_by(f64::total_cmp);
            times
        });
        for (a, b) in slow.iter().zip(&split) {
            largest = largest.max((a.position() - b.position()).length());
            assert_eq!(a.hash(), b.hash());
        }
    }
    println!("largest difference over 20 random splits of the minute: {largest:e} m");
    assert_eq!(largest, 0.0);
}
