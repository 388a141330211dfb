//! A differential test: short random runs of the motion against a slow reference that shares no code with mesh or motion.
//!
//! The reference (`body`, `piece`, `flight`, `corner`, `jump`) tests every snapped outline, grown by the collider, one by one (`outline`), in
//! 32 digits (`double`), under laws written from the sentences of the tunables (`law`). `runs` makes the runs, `duel` plays and
//! compares them. `REFERENCE_RUNS` and `REFERENCE_SEED` lengthen the test and move it.

mod body;
mod corner;
mod double;
mod duel;
mod flight;
mod jump;
mod law;
mod outline;
mod piece;
mod runs;
#[path = "../common/worlds.rs"]
mod worlds;

use duel::Outcome;
use std::collections::BTreeMap;

fn env(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |text| {
        text.parse()
            .unwrap_or_else(|e| panic!("{name}={text}: {e}"))
    })
}

/// What all runs together showed.
#[derive(Default)]
struct Tally {
    runs: usize,
    events: usize,
    ticks: [usize; 4],
    /// Runs that came off a cut edge.
    blurred: usize,
    /// Largest errors of the other runs, and of these.
    exact: [f64; 3],
    shifted: [f64; 3],
    /// Runs that ended early, by reason.
    doubts: BTreeMap<&'static str, usize>,
    failures: Vec<String>,
}

impl Tally {
    fn add(&mut self, outcome: Outcome) {
        self.events += outcome.events;
        for (all, ticks) in self.ticks.iter_mut().zip(outcome.ticks) {
            *all += ticks;
        }
        self.blurred += usize::from(outcome.blurred);
        let largest = match outcome.blurred {
            true => &mut self.shifted,
            false => &mut self.exact,
        };
        for (largest, error) in largest.iter_mut().zip(outcome.errors) {
            *largest = largest.max(error);
        }
        if let Some(why) = outcome.doubt {
            *self.doubts.entry(why).or_default() += 1;
        }
    }

    fn doubted(&self) -> usize {
        self.doubts.values().sum()
    }

    fn print(&self) {
        let [air, ground, slide, rest] = self.ticks;
        let of = |errors: [f64; 3]| errors.map(|e| format!("{e:.1e}")).join(", ");
        println!("{} runs, {} events", self.runs, self.events);
        println!("ticks: {air} in the air, {ground} on ground, {slide} sliding, {rest} in a V");
        println!("largest error (m, m/s, s): {}", of(self.exact));
        println!(
            "of {} runs off cut edges: {}",
            self.blurred,
            of(self.shifted)
        );
        println!("in doubt: {} runs {:?}", self.doubted(), self.doubts);
    }
}

#[test]
fn random_runs_agree_with_the_reference() {
    let (runs, first) = (env("REFERENCE_RUNS", 1000), env("REFERENCE_SEED", 1));
    let mut tally = Tally::default();
    for seed in first..first + runs {
        tally.runs += 1;
        match duel::play(&runs::Run::new(seed)) {
            Ok(outcome) => tally.add(outcome),
            Err(e) => tally.failures.push(format!("seed {seed}: {e}")),
        }
    }
    tally.print();
    let shown = tally.failures.len().min(5);
    assert!(
        tally.failures.is_empty(),
        "{} runs differ:\n{}",
        tally.failures.len(),
        tally.failures[..shown].join("\n")
    );
    assert!(tally.doubted() * 10 <= tally.runs + 20, "too many in doubt");
    // A few runs alone, to look at one, may do little.
    assert!(
        tally.runs < 500
            || tally.ticks.iter().all(|&ticks| ticks > 0) && tally.events > 2 * tally.runs,
        "too little happens"
    );
}
