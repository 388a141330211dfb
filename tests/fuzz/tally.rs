//! What runs did, to show that they did something.

use edgewalker::motion::{Body, EventKind, Mode, Trace};
use glam::DVec2;
use std::collections::BTreeMap;
use std::fmt;

/// Counts over any number of runs.
#[derive(Default)]
pub struct Tally {
    pub ticks: u64,
    /// Ticks in which a body did not move though it might.
    pub idle: u64,
    pub modes: BTreeMap<String, u64>,
    pub transitions: BTreeMap<(String, String), u64>,
    pub events: BTreeMap<String, u64>,
    last: Option<(String, DVec2)>,
}

/// Modes that must not be rarer than one tick in [`RAREST`].
const MODES: &[&str] = &[
    "Air",
    "ClimbOnMover",
    "Crushed",
    "Ground",
    "Ride",
    "Slide",
    "SlideOnMover",
    "Wedge",
];

/// Ways from mode to mode for which the same holds.
const TRANSITIONS: &[(&str, &str)] = &[
    ("Air", "Ground"),
    ("Air", "Ride"),
    ("Air", "Slide"),
    ("Air", "SlideOnMover"),
    ("Ground", "Air"),
    ("Ride", "Air"),
    ("Slide", "Air"),
    ("Slide", "Ground"),
    ("SlideOnMover", "Air"),
];

/// Events for which the same holds: all but `Stuck`, which must not occur.
const EVENTS: &[&str] = &[
    "Boarded",
    "Climbed",
    "Corrected",
    "Crushed",
    "Embedded",
    "Entered",
    "Exited",
    "Grabbed",
    "Hit",
    "Joint",
    "Jumped",
    "Landed",
    "Left",
    "LetGo",
    "Limit",
    "Mounted",
    "Node",
    "Parted",
    "Pushed",
    "Resized",
    "Stopped",
    "Unlocked",
    "WallJumped",
    "Wedged",
    "SteppedUp",
    "Snapped",
    "Dropped",
];

/// What occurs less than once in so many ticks is too rare to be tested.
const RAREST: u64 = 10_000;

impl Tally {
    /// Forgets where the last body was.
    pub fn begin(&mut self) {
        self.last = None;
    }

    /// Notes a tick.
    pub fn note(&mut self, body: &Body, trace: &Trace) {
        self.ticks += 1;
        let (mode, at) = (mode(body), body.position());
        if let Some((from, before)) = self.last.take() {
            self.idle += u64::from(before == at && mode != "Crushed");
            if from != mode {
                *self.transitions.entry((from, mode.clone())).or_default() += 1;
            }
        }
        match self.modes.get_mut(&mode) {
            Some(count) => *count += 1,
            None => _ = self.modes.insert(mode.clone(), 1),
        }
        for event in &trace.events {
            *self.events.entry(name(&event.kind)).or_default() += 1;
        }
        self.last = Some((mode, at));
    }

    /// What is too rare, or too often idle.
    pub fn complaints(&self) -> Vec<String> {
        let rare = |count: Option<&u64>| count.copied().unwrap_or(0) * RAREST < self.ticks;
        let modes = MODES.iter().filter(|&&m| rare(self.modes.get(m)));
        let modes = modes.map(|m| format!("mode {m} is too rare"));
        let ways = TRANSITIONS
            .iter()
            .filter(|(from, to)| rare(self.transitions.get(&(from.to_string(), to.to_string()))));
        let ways = ways.map(|(from, to)| format!("from {from} to {to} is too rare"));
        let events = EVENTS.iter().filter(|&&e| rare(self.events.get(e)));
        let events = events.map(|e| format!("event {e} is too rare"));
        let idle = (2 * self.idle > self.ticks).then(|| format!("{} idle ticks", self.idle));
        modes.chain(ways).chain(events).chain(idle).collect()
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let share = |count: &u64| *count as f64 / self.ticks as f64;
        writeln!(
            f,
            "{} ticks, {:.3} of them idle",
            self.ticks,
            share(&self.idle)
        )?;
        for (mode, count) in &self.modes {
            writeln!(f, "  mode {mode:<12} {count:>10} {:.6}", share(count))?;
        }
        for ((from, to), count) in &self.transitions {
            writeln!(
                f,
                "  {from:>12} -> {to:<12} {count:>10} {:.6}",
                share(count)
            )?;
        }
        for (event, count) in &self.events {
            writeln!(f, "  event {event:<12} {count:>10} {:.6}", share(count))?;
        }
        Ok(())
    }
}

fn mode(body: &Body) -> String {
    let rides = body.carrier().is_some();
    let name = match body.mode() {
        Mode::Air(_) if rides => "ClimbOnMover",
        Mode::Air(_) => "Air",
        Mode::Surface(_) if body.supported() && rides => "Ride",
        Mode::Surface(_) if body.supported() => "Ground",
        Mode::Surface(_) if rides => "SlideOnMover",
        Mode::Surface(_) => "Slide",
        Mode::Wedge(_) => "Wedge",
        other => return head(format!("{other:?}")),
    };
    name.to_owned()
}

fn name(kind: &EventKind) -> String {
    head(format!("{kind:?}"))
}

/// What stands before the first bracket.
fn head(mut text: String) -> String {
    text.truncate(text.find(['(', ' ', '{']).unwrap_or(text.len()));
    text
}
