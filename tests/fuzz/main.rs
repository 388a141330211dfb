//! A seeded fuzz test of the motion: random worlds with every mechanism, random controls and edits, every invariant after
//! every tick and every event. `FUZZ_TICKS`, `FUZZ_SEED` and `FUZZ_WORLDS` lengthen it and move it; `FUZZ_CASE` names a
//! file with one run to repeat. Most worlds have moving solids.
//!
//! A run that fails is cut down to what it needs and written to `target/fuzz`, and as a level to `levels/dev` if it can be one.
//! Once its fault is mended it belongs into `tests/fuzz/found`, where every run is repeated.

mod case;
#[path = "../common/worlds.rs"]
mod dice;
mod invariants;
mod run;
mod save;
mod shrink;
mod tally;
mod worlds;

use case::{Build, Case, Ready};
use dice::Dice;
use edgewalker::motion::{Body, Trace};
use edgewalker::tune::Motion;
use glam::DVec2;
use run::{born, change, free_start, live};
use std::path::Path;
use tally::Tally;

/// Worlds in which the mirror image of a run once was another one.
const ONCE_LOPSIDED: [u64; 2] = [1620, 1739];

/// Ticks in one world, in one life (at most so many seconds).
const TICKS: u64 = 4_000;
const SECONDS: f64 = 20.0;

fn env(name: &str, default: u64) -> u64 {
    std::env::var(name)
        .ok()
        .map_or(default, |s| s.parse().expect("a number"))
}

/// Lives lives in one random world. A failure is cut down and saved; its text names the files.
fn world(seed: u64, tally: &mut Tally) -> Result<(), String> {
    let mut dice = Dice::new(seed);
    let world = worlds::world(&mut dice);
    let original = world.ready();
    let mut ready = original.clone();
    let mut left = TICKS;
    while left > 0 {
        let ticks = left.min((SECONDS * world.rate) as u64);
        let since = [0, 0, dice.below(1_000_000) as u64][dice.below(3) as usize];
        let life = worlds::life(&mut dice, &world, DVec2::ZERO, since, ticks);
        let mut case = Case {
            seed,
            world: world.clone(),
            life,
        };
        case.life.start = free_start(&ready, &case, || worlds::spot(&mut dice));
        let before = tally.ticks;
        if let Err(failure) = live(&case, &mut ready, tally) {
            let (small, failure) = shrink::shrink(&case, &failure);
            let files = save::save(&small);
            return Err(format!(
                "seed {seed}: {}\n    saved as {files:?}",
                failure.what
            ));
        }
        left -= (tally.ticks - before).clamp(1, left);
        if ready.edited {
            ready = original.clone();
        }
    }
    Ok(())
}

#[test]
fn a_million_random_ticks_keep_every_invariant() {
    let (wanted, mut seed) = (env("FUZZ_TICKS", 1_000_000), env("FUZZ_SEED", 1));
    let mut tally = Tally::default();
    let mut failures = Vec::new();
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {})); // panics are reported as failures
    while tally.ticks < wanted && failures.len() < 10 {
        if let Err(failure) = world(seed, &mut tally) {
            eprintln!("{failure}");
            failures.push(failure);
        }
        seed += 1;
    }
    std::panic::set_hook(hook);
    println!("{tally}");
    assert_eq!(failures, Vec::<String>::new());
    assert_eq!(tally.complaints(), Vec::<String>::new());
}

#[test]
fn runs_that_failed_once_keep_every_invariant() {
    let cases = match std::env::var("FUZZ_CASE") {
        Ok(file) => vec![(file.clone().into(), save::load(Path::new(&file)))],
        Err(_) => save::load_all(Path::new("tests/fuzz/found")),
    };
    for (path, case) in cases {
        let lived = live(&case, &mut case.world.ready(), &mut Tally::default());
        assert!(
            lived.is_ok(),
            "{}: {}",
            path.display(),
            lived.unwrap_err().what
        );
    }
}

/// A run as a list of states at common times; `split` cuts every tick into that many.
fn states(case: &Case, sign: f64, split: impl Fn(&mut Dice) -> u32, resume: bool) -> Vec<[u64; 4]> {
    let mut ready = case.world.ready();
    let (tuning, life) = (&case.world.tuning, &case.life);
    let Some(mut body) = born(&ready, tuning, life.start, 0.0) else {
        return Vec::new();
    };
    let mut cuts = Dice::new(case.seed);
    let mut trace = Trace::default();
    let mut out = Vec::new();
    for n in 1..=life.ticks {
        for (_, edit) in life.edits.iter().filter(|e| e.0 == n) {
            change(&mut ready, tuning, &mut body, edit, &mut trace);
        }
        let terrain = ready.terrain(tuning);
        for &(_, control) in life.inputs.iter().filter(|i| i.0 == n) {
            body.apply(control, &terrain, &mut trace);
        }
        let (from, to) = ((n - 1) as f64 / case.world.rate, n as f64 / case.world.rate);
        let parts = split(&mut cuts);
        for part in 1..parts {
            let share = f64::from(part) / f64::from(parts);
            body.advance(from + (to - from) * share, &terrain, &mut trace);
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
    let mut born = 0;
    for seed in (0..env("FUZZ_WORLDS", 300)).chain(ONCE_LOPSIDED) {
        let mut case = worlds::case(seed, 100);
        case.world.rate = 10.0;
        let once = states(&case, 1.0, |_| 1, false);
        born += u64::from(!once.is_empty());
        let same =
            |what: &str, other: Vec<[u64; 4]>| assert_eq!(once, other, "{what}, seed {seed}");
        same("I7, again", states(&case, 1.0, |_| 1, false));
        same("I7, resumed", states(&case, 1.0, |_| 3, true));
        same(
            "split at random",
            states(&case, 1.0, |d| 1 + d.below(40) as u32, false),
        );
        same("I7, mirrored", states(&case.mirrored(), -1.0, |_| 2, false));
        let mut edited = case.clone();
        edited
            .world
            .features
            .extend(worlds::far_away(&mut Dice::new(seed + 100)));
        if case.world.movers.is_empty() && case.life.edits.is_empty() {
            same("I9", states(&edited, 1.0, |_| 1, false));
        }
    }
    assert!(3 * born > env("FUZZ_WORLDS", 300), "{born} were born");
}

#[test]
fn idle_is_frozen() {
    let mut rested = 0;
    for seed in 200..260 {
        let mut dice = Dice::new(seed);
        let mut world = worlds::world(&mut dice);
        world.movers.clear();
        world.features.iter_mut().for_each(|f| f.conveyor = 0.0);
        (world.body, world.tuning) = (Build::Hero, Motion::default());
        let ready: Ready = world.ready();
        let terrain = ready.terrain(&world.tuning);
        let mut body = loop {
            let at = worlds::spot(&mut dice);
            if let Ok(body) = Body::spawn(at, 0.0, &terrain) {
                break body;
            }
        };
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
