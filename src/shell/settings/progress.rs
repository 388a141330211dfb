//! What has been reached: for each level the run that is under way, and the best of those that came to the goal.

use super::fields::Complaints;
use crate::game::Run;
use crate::level::Skill;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::time::SystemTime;

/// Version of the file.
pub const VERSION: u32 = 1;

/// What is said of a time that counts for no best one.
pub const MARKED: &str = "with other speed or tuning";

/// Everything that has been reached.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename = "Progress")]
pub struct Progress {
    /// Version of the format.
    pub version: u32,
    /// The level that was played last.
    pub last: Option<String>,
    /// When its run was begun, came to a checkpoint or ended: a [`now`].
    pub last_at: u64,
    /// By the level's path.
    pub levels: BTreeMap<String, Record>,
    /// What the player has done once and need not be told of.
    pub learnt: BTreeSet<Skill>,
}

/// What has been reached in one level.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Record {
    /// The run that was left before its goal.
    pub run: Option<Run>,
    /// When it was begun, came to its checkpoint or ended: a [`now`]. The newest of several is kept.
    pub reached: u64,
    /// Shortest time to the goal, in seconds, of the runs at full speed with the game's own tuning.
    pub best_seconds: Option<f64>,
    /// The same of all others.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub marked_seconds: Option<f64>,
    /// Fewest deaths on the way there, in the runs that count.
    pub fewest_deaths: Option<u32>,
    /// Most secrets found in one run.
    pub most_secrets: u32,
    /// The ids of all secrets that were ever found.
    pub found: BTreeSet<String>,
    /// How often the goal was reached.
    pub finished: u32,
}

impl Record {
    /// The best of all runs that came to the goal, in a line; empty if none did.
    pub fn in_a_line(&self) -> String {
        let best = self.best_seconds.map(|seconds| {
            let deaths = self.fewest_deaths.unwrap_or_default();
            format!("Best time {}   ·   fewest deaths {deaths}", clock(seconds))
        });
        let marked = self.marked_seconds;
        let marked = marked.map(|seconds| format!("{} {MARKED}", clock(seconds)));
        let secrets = match (self.most_secrets, self.finished) {
            (0, _) | (_, 0) => None,
            (most, _) => Some(format!("most secrets {most}")),
        };
        let parts = [best, marked, secrets];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        parts.join("   ·   ")
    }
}

/// What a run came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Results {
    /// Time to the goal, in seconds.
    pub seconds: f64,
    /// Deaths on the way.
    pub deaths: u32,
    /// Secrets found, and how many there are.
    pub secrets: (u32, u32),
    /// The shortest time before this run, in seconds.
    pub best_before: Option<f64>,
    /// It counts for no best time.
    pub marked: bool,
}

impl Results {
    /// The shortest time that there is now, if there is one.
    pub fn best(&self) -> Option<f64> {
        let own = Some(self.seconds).filter(|_| !self.marked);
        let both = self.best_before.into_iter().chain(own);
        both.min_by(f64::total_cmp)
    }

    /// This run was the fastest of several.
    pub fn is_record(&self) -> bool {
        !self.marked && self.best_before.is_some_and(|best| self.seconds < best)
    }
}

impl Progress {
    /// The level and the run to go on with.
    pub fn unfinished(&self) -> Option<(&str, &Run)> {
        let name = self.last.as_deref()?;
        Some((name, self.levels.get(name)?.run.as_ref()?))
    }

    /// A time for what is reached now in a level: later than all that is known there, even if the clock was set back.
    pub fn stamp(&self, level: &str) -> u64 {
        let known = self.levels.get(level).map_or(0, |record| record.reached);
        now().max(known.max(self.last_at) + 1)
    }

    /// A run is under way: its last checkpoint, time and deaths; `reached` is the [`stamp`](Self::stamp) of its beginning or
    /// its checkpoint. One that another game has reached later stays.
    pub fn note(&mut self, level: &str, run: Run, reached: u64) {
        self.take_last(reached, Some(level.to_owned()));
        let record = self.record(level);
        record.found.extend(run.secrets.iter().cloned());
        record.take_run(reached, Some(run));
    }

    /// A run has come to the goal, in a level with so many secrets.
    pub fn finish(&mut self, level: &str, run: &Run, of: u32) -> Results {
        let at = self.stamp(level);
        self.take_last(at, Some(level.to_owned()));
        let record = self.record(level);
        let (seconds, deaths) = (run.seconds, run.deaths);
        let secrets = (run.secrets.len() as u32, of);
        let results = Results {
            seconds,
            deaths,
            secrets,
            best_before: record.best_seconds,
            marked: run.marked,
        };
        record.take_run(at, None);
        record.found.extend(run.secrets.iter().cloned());
        record.best_seconds = results.best();
        if run.marked {
            let best = record.marked_seconds;
            record.marked_seconds = Some(best.map_or(seconds, |best| best.min(seconds)));
        } else {
            record.fewest_deaths = Some(record.fewest_deaths.map_or(deaths, |f| f.min(deaths)));
        }
        record.most_secrets = record.most_secrets.max(secrets.0);
        record.finished += 1;
        results
    }

    fn record(&mut self, level: &str) -> &mut Record {
        self.levels.entry(level.to_owned()).or_default()
    }

    /// Leaves out times that no clock could show.
    pub(super) fn mend(&mut self, complaints: &mut Complaints) {
        let is_time = |seconds: f64| seconds.is_finite() && seconds >= 0.0;
        for (level, record) in &mut self.levels {
            if record.best_seconds.is_some_and(|best| !is_time(best)) {
                complaints.push(format!("{level}: best_seconds is no time and left out"));
                record.best_seconds = None;
            }
            if record.marked_seconds.is_some_and(|best| !is_time(best)) {
                complaints.push(format!("{level}: marked_seconds is no time and left out"));
                record.marked_seconds = None;
            }
            if record.run.as_ref().is_some_and(|run| !is_time(run.seconds)) {
                complaints.push(format!(
                    "{level}: run.seconds is no time; the run is left out"
                ));
                record.run = None;
            }
        }
    }
}

/// Milliseconds since the beginning of 1970; 0 before that.
pub fn now() -> u64 {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    since.map_or(0, |since| since.as_millis() as u64)
}

/// Minutes, seconds and hundredths.
pub struct Clock(u64);

impl std::fmt::Display for Clock {
    fn fmt(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Clock(all) = self;
        write!(out, "{}:{:02}.{:02}", all / 6000, all / 100 % 60, all % 100)
    }
}

/// Seconds as on a watch.
pub fn clock(seconds: f64) -> Clock {
    Clock((seconds * 100.0).floor() as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run at its goal.
    fn won(seconds: f64, deaths: u32, secrets: &[&str]) -> Run {
        Run {
            seconds,
            deaths,
            secrets: secrets.iter().map(ToString::to_string).collect(),
            ..Run::default()
        }
    }

    #[test]
    fn the_best_of_several_runs_is_kept() {
        let mut progress = Progress::default();
        let first = progress.finish("a", &won(100.0, 3, &["x"]), 4);
        assert!(!first.is_record() && first.best() == Some(100.0) && first.secrets == (1, 4));
        let slower = progress.finish("a", &won(120.0, 0, &["x", "y", "z"]), 4);
        assert!(!slower.is_record() && slower.best() == Some(100.0));
        let faster = progress.finish("a", &won(80.0, 9, &["w"]), 4);
        assert!(faster.is_record() && faster.best_before == Some(100.0));
        let record = &progress.levels["a"];
        assert_eq!(record.best_seconds, Some(80.0));
        assert_eq!((record.fewest_deaths, record.most_secrets), (Some(0), 3));
        assert_eq!((record.finished, record.found.len()), (3, 4));
    }

    #[test]
    fn a_marked_run_is_shown_and_is_no_best_one() {
        let mut progress = Progress::default();
        let slow = |seconds: f64| Run {
            marked: true,
            ..won(seconds, 0, &["x", "y"])
        };
        let first = progress.finish("a", &slow(50.0), 4);
        assert!(first.marked && !first.is_record() && first.best().is_none());
        assert_eq!(
            progress.levels["a"].in_a_line(),
            "0:50.00 with other speed or tuning   ·   most secrets 2"
        );
        assert_eq!(
            progress.finish("a", &won(100.0, 3, &["x"]), 4).best(),
            Some(100.0)
        );
        let second = progress.finish("a", &slow(60.0), 4);
        assert!(!second.is_record() && second.best() == Some(100.0));
        let record = &progress.levels["a"];
        let times = (record.best_seconds, record.marked_seconds);
        assert_eq!(times, (Some(100.0), Some(50.0)));
        assert_eq!((record.fewest_deaths, record.finished), (Some(3), 3));
        // An older game writes none, and a file of its is read.
        let old = "(best_seconds: Some(9.0), finished: 1)";
        let old: Record = ron::from_str(old).unwrap();
        assert_eq!((old.best_seconds, old.marked_seconds), (Some(9.0), None));
    }

    #[test]
    fn a_run_is_under_way_until_it_is_finished() {
        let mut progress = Progress::default();
        assert_eq!(progress.unfinished(), None);
        let run = |seconds: f64| Run {
            seconds,
            ..Run::default()
        };
        let begun = progress.stamp("a");
        assert!(begun >= 1 && begun.abs_diff(now()) < 60_000);
        progress.note("a", run(9.0), begun);
        assert_eq!(progress.unfinished(), Some(("a", &run(9.0))));
        progress.note("a", run(10.0), begun);
        assert_eq!(progress.unfinished(), Some(("a", &run(10.0))), "further on");
        progress.note("a", run(4.0), begun - 1);
        assert_eq!(
            progress.unfinished(),
            Some(("a", &run(10.0))),
            "an older one"
        );
        let again = progress.stamp("a");
        assert!(again > begun, "even within a millisecond");
        progress.note("a", run(0.0), again);
        assert_eq!(progress.unfinished(), Some(("a", &run(0.0))), "a new one");
        progress.note("b", run(1.0), progress.stamp("b"));
        progress.finish("b", &run(12.0), 0);
        assert_eq!(progress.unfinished(), None);
        assert_eq!(progress.levels["a"].run, Some(run(0.0)));
    }

    #[test]
    fn times_are_written_as_on_a_watch() {
        assert_eq!(
            [0.0, 59.999, 83.456].map(|seconds| clock(seconds).to_string()),
            ["0:00.00", "0:59.99", "1:23.45"]
        );
    }

    #[test]
    fn a_record_in_a_line_says_what_there_is() {
        let mut record = Record::default();
        assert_eq!(record.in_a_line(), "");
        record.best_seconds = Some(83.456);
        record.fewest_deaths = Some(2);
        assert_eq!(
            record.in_a_line(),
            "Best time 1:23.45   ·   fewest deaths 2"
        );
        (record.most_secrets, record.finished) = (7, 1);
        assert!(record.in_a_line().ends_with("most secrets 7"));
    }
}
