//! Laws of merging, over random states: in any order, as often as one likes, and nothing is lost.

use super::*;
use std::collections::BTreeSet;

/// Random numbers: splitmix64, after Steele, Lea and Flood (2014).
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % n
    }

    fn run(&mut self) -> Run {
        let secrets = (0..self.below(3)).map(|_| format!("s{}", self.below(4)));
        let secrets: BTreeSet<String> = secrets.collect();
        Run {
            checkpoint: (self.below(3) > 0).then(|| format!("c{}", self.below(2))),
            seconds: self.below(4) as f64 / 4.0,
            deaths: self.below(3) as u32,
            secrets: secrets.into_iter().collect(),
            ..Run::default()
        }
    }

    /// A game goes on from a state, and reaches something. Few values, so that they often meet; also two games whose clocks
    /// show the same.
    fn played(&mut self, base: &Progress) -> Progress {
        let mut progress = base.clone();
        for _ in 0..self.below(5) {
            let level = ["a", "b", "c"][self.below(3) as usize];
            let run = self.run();
            if self.below(3) == 0 {
                progress.finish(level, &run, 4);
            } else {
                let reached = self.below(6);
                progress.note(level, run, reached);
            }
        }
        progress
    }
}

fn merged(base: &Progress, a: &Progress, b: &Progress) -> Progress {
    Progress::merged(base, a, b)
}

/// Everything in `part` is in `whole`, or something better.
fn holds(whole: &Progress, part: &Progress) {
    assert!(whole.last_at >= part.last_at);
    for (level, part) in &part.levels {
        let whole = &whole.levels[level];
        assert!(whole.reached >= part.reached);
        if let (true, Some(part)) = (whole.reached == part.reached, &part.run) {
            assert!(whole.run.as_ref().unwrap().seconds >= part.seconds);
        }
        let best = |record: &Record| record.best_seconds.unwrap_or(f64::INFINITY);
        let fewest = |record: &Record| record.fewest_deaths.unwrap_or(u32::MAX);
        assert!(best(whole) <= best(part) && fewest(whole) <= fewest(part));
        assert!(whole.most_secrets >= part.most_secrets && whole.finished >= part.finished);
        assert!(whole.found.is_superset(&part.found));
    }
}

fn finished(progress: &Progress) -> u32 {
    progress.levels.values().map(|record| record.finished).sum()
}

#[test]
fn the_order_does_not_matter_and_nothing_is_lost() {
    for seed in 0..4000 {
        let mut dice = Dice(seed);
        let base = dice.played(&Progress::default());
        let [a, b, c] = [(); 3].map(|()| dice.played(&base));
        let both = merged(&base, &a, &b);
        assert_eq!(both, merged(&base, &b, &a), "commutative, seed {seed}");
        let all = merged(&base, &both, &c);
        let other = merged(&base, &a, &merged(&base, &b, &c));
        assert_eq!(all, other, "associative, seed {seed}");
        for part in [&base, &a, &b, &c] {
            holds(&all, part);
        }
        let more: u32 = [&a, &b, &c]
            .map(|x| finished(x) - finished(&base))
            .iter()
            .sum();
        assert_eq!(finished(&all), finished(&base) + more, "seed {seed}");
    }
}

#[test]
fn again_changes_nothing() {
    for seed in 0..4000 {
        let mut dice = Dice(seed);
        let base = dice.played(&Progress::default());
        let (a, b) = (dice.played(&base), dice.played(&base));
        assert_eq!(merged(&a, &a, &a), a);
        assert_eq!(
            merged(&base, &base, &a),
            a,
            "who has reached nothing takes over"
        );
        let both = merged(&base, &a, &b);
        assert_eq!(merged(&both, &both, &both), both);
        // The second save of a game that has reached nothing since its first.
        assert_eq!(merged(&a, &a, &both), merged(&a, &both, &a));
        assert_eq!(merged(&a, &a, &both), both, "seed {seed}");
    }
}

#[test]
fn the_newest_checkpoint_is_gone_on_with() {
    let run = |checkpoint: &str, seconds: f64| Run {
        checkpoint: Some(checkpoint.into()),
        seconds,
        ..Run::default()
    };
    let mut base = Progress::default();
    base.note("a", run("gate", 10.0), 100);
    let (mut one, mut two) = (base.clone(), base.clone());
    one.note("a", run("well", 50.0), 300);
    two.note("a", run("gate", 90.0), 100); // stood about, and left last
    for both in [merged(&base, &one, &two), merged(&base, &two, &one)] {
        assert_eq!(both.unfinished(), Some(("a", &run("well", 50.0))));
    }
    one.finish("a", &run("well", 60.0), 0);
    for both in [merged(&base, &one, &two), merged(&base, &two, &one)] {
        assert_eq!(both.unfinished(), None, "it came to its goal since");
    }
}
