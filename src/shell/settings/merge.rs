//! What several games that ran at once have reached, in one: nothing that one of them has reached is lost.
//!
//! Best values, sets and the newest of something come out the same in whatever order and however often states are merged.
//! Counts do not, by themselves: they are merged as what each side has added to a state that both had.

use super::progress::{Progress, Record};
use crate::game::Run;
use std::cmp::Ordering;

/// The least or greatest of what is there.
fn best<T: Copy>(a: Option<T>, b: Option<T>, of: impl Fn(T, T) -> T) -> Option<T> {
    match (a, b) {
        (Some(a), Some(b)) => Some(of(a, b)),
        _ => a.or(b),
    }
}

/// The one that is further on, of two states that were reached at the same time: any order will do that is one.
fn further(a: &Run, b: &Run) -> Ordering {
    let known = |run: &Run| (run.deaths, run.secrets.len());
    (a.seconds.total_cmp(&b.seconds))
        .then(known(a).cmp(&known(b)))
        .then_with(|| (&a.checkpoint, &a.secrets).cmp(&(&b.checkpoint, &b.secrets)))
        .then_with(|| format!("{a:?}").cmp(&format!("{b:?}")))
}

impl Record {
    /// Takes over a state of the run (`None`: there is none any more) if it is not older than its own.
    pub(super) fn take_run(&mut self, reached: u64, run: Option<Run>) {
        let order = reached
            .cmp(&self.reached)
            .then_with(|| match (&run, &self.run) {
                (Some(new), Some(own)) => further(new, own),
                (new, own) => new.is_some().cmp(&own.is_some()),
            });
        if order == Ordering::Greater {
            (self.reached, self.run) = (reached, run);
        }
    }

    /// Takes over what another state of the record has that goes beyond; `before` is how often the goal had been reached when
    /// both went their ways.
    fn take(&mut self, other: &Record, before: u32) {
        self.take_run(other.reached, other.run.clone());
        self.best_seconds = best(self.best_seconds, other.best_seconds, f64::min);
        self.marked_seconds = best(self.marked_seconds, other.marked_seconds, f64::min);
        self.fewest_deaths = best(self.fewest_deaths, other.fewest_deaths, u32::min);
        self.most_secrets = self.most_secrets.max(other.most_secrets);
        self.found.extend(other.found.iter().cloned());
        let more = other.finished.saturating_sub(before);
        self.finished = self.finished.saturating_add(more);
    }
}

impl Progress {
    /// What two games have reached that both went on from a state.
    pub fn merged(base: &Progress, a: &Progress, b: &Progress) -> Progress {
        let mut merged = a.clone();
        for (level, record) in &b.levels {
            let before = base.levels.get(level).map_or(0, |record| record.finished);
            let own = merged.levels.entry(level.clone());
            let own = own.or_insert_with(|| Record {
                finished: before,
                ..Record::default()
            });
            own.take(record, before);
        }
        merged.take_last(b.last_at, b.last.clone());
        merged.learnt.extend(&b.learnt);
        merged
    }

    /// Takes over the level that was played last, if it was played later.
    pub(super) fn take_last(&mut self, at: u64, level: Option<String>) {
        if (at, &level) > (self.last_at, &self.last) {
            (self.last_at, self.last) = (at, level);
        }
    }
}

#[cfg(test)]
mod tests;
