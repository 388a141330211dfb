//! Runs as values: the inputs of a run with all that they depend on, as text.

use super::run::Run;
use super::stage::Stage;
use super::{Input, World};
use crate::tune::{TuneError, Tuning};
use glam::DVec2;
use ron::extensions::Extensions;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Version of the format that this program writes, and the only one that it reads.
pub const VERSION: u32 = 1;

/// Most ticks that a replay may have: a day at 1000 Hz.
pub const LONGEST: u64 = 86_400_000;

/// Highest tick rate.
pub const FASTEST: u32 = 10_000;

/// What comes before the inputs in the text, before each of them, and after the last.
const LIST: &str = "inputs: [";
const ENTRY: &str = "        ";
const END: &str = "    ],\n)\n";

/// A recorded run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Replay {
    /// Version of the format.
    pub version: u32,
    /// The level's file, as it was given.
    pub level: String,
    /// The level's [`Stage::fingerprint`], in hexadecimal: the run means something in that level only.
    pub fingerprint: String,
    /// Ticks a second.
    pub tick_rate: u32,
    /// Seed of the game's generator.
    pub seed: u64,
    /// Where the hero's foot is at first, m; `None`: at the level's start.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start: Option<DVec2>,
    /// The run that it goes on with; `None`: it begins anew.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub run: Option<Run>,
    /// All tunables.
    pub tuning: Tuning,
    /// The inputs: for how many ticks, which.
    pub inputs: Vec<(u32, Input)>,
}

/// Why a replay is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum ReplayError {
    /// Not this kind of text. With line and column.
    Syntax(String),
    /// Written by another version of the format.
    Version(u32),
    /// A field holds what it cannot.
    Field(&'static str, String),
    /// A tunable out of its range.
    Tuning(TuneError),
    /// The level is not the one that the run was recorded in.
    OtherLevel {
        /// Fingerprint in the replay.
        recorded: String,
        /// Fingerprint of the level.
        found: String,
    },
}

impl std::fmt::Display for ReplayError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            ReplayError::Syntax(error) => f.write_str(error),
            ReplayError::Version(found) => write!(
                f,
                "field `version`: {found} is not understood, only {VERSION} is"
            ),
            ReplayError::Field(name, problem) => write!(f, "field `{name}`: {problem}"),
            ReplayError::Tuning(error) => write!(f, "tuning, {error}"),
            ReplayError::OtherLevel { recorded, found } => {
                write!(
                    f,
                    "field `fingerprint`: recorded in level {recorded}, but the level is now {found}"
                )
            }
        }
    }
}

impl std::error::Error for ReplayError {}

impl ReplayError {
    /// The field that it is about, where it is one of the file's.
    pub fn field(&self) -> Option<&'static str> {
        match self {
            ReplayError::Syntax(_) => None,
            ReplayError::Version(_) => Some("version"),
            ReplayError::Field(name, _) => Some(name),
            ReplayError::Tuning(error) => Some(error.meta.name),
            ReplayError::OtherLevel { .. } => Some("fingerprint"),
        }
    }
}

/// The one field that every version has; the others are skipped.
#[derive(Deserialize)]
struct Header {
    version: u32,
}

impl Replay {
    /// The start of a recording.
    pub fn new(level: &str, stage: &Stage, tick_rate: u32, seed: u64, tuning: &Tuning) -> Replay {
        let fingerprint = format!("{:016x}", stage.fingerprint());
        Replay {
            version: VERSION,
            level: level.to_owned(),
            fingerprint,
            tick_rate,
            seed,
            start: None,
            run: None,
            tuning: tuning.clone(),
            inputs: Vec::new(),
        }
    }

    /// Adds a tick.
    pub fn push(&mut self, input: Input) {
        match self.inputs.last_mut() {
            Some((ticks, last)) if *last == input && *ticks < u32::MAX => *ticks += 1,
            _ => self.inputs.push((1, input)),
        }
    }

    /// How many ticks it has.
    pub fn ticks(&self) -> u64 {
        self.inputs.iter().map(|&(ticks, _)| u64::from(ticks)).sum()
    }

    /// The input of every tick.
    pub fn iter(&self) -> impl Iterator<Item = Input> + '_ {
        self.inputs
            .iter()
            .flat_map(|&(ticks, input)| std::iter::repeat_n(input, ticks as usize))
    }

    /// A world as it was when the recording began.
    ///
    /// # Errors
    /// If the stage is not of the level that the run was recorded in, or the hero does not fit where it begins.
    pub fn world(&self, stage: Arc<Stage>) -> Result<World, ReplayError> {
        let found = format!("{:016x}", stage.fingerprint());
        if found != self.fingerprint {
            return Err(ReplayError::OtherLevel {
                recorded: self.fingerprint.clone(),
                found,
            });
        }
        let mut world = World::new(stage, self.tick_rate, self.seed);
        if let Some(start) = self.start {
            let put = world.put(start);
            put.map_err(|error| ReplayError::Field("start", error.to_string()))?;
        }
        if let Some(run) = &self.run {
            world.resume(run);
        }
        Ok(world)
    }

    /// Runs it to its end.
    ///
    /// # Errors
    /// As [`Replay::world`].
    pub fn run(&self, stage: Arc<Stage>) -> Result<World, ReplayError> {
        let mut world = self.world(stage)?;
        for input in self.iter() {
            world.step(input, &self.tuning);
        }
        Ok(world)
    }

    /// As text.
    pub fn to_text(&self) -> String {
        let pretty = ron::ser::PrettyConfig::new().new_line("\n").depth_limit(2);
        ron::ser::to_string_pretty(self, pretty).expect("a replay is plain data") + "\n"
    }

    /// The end of [`to_text`](Self::to_text) from an entry of the inputs on: what takes the place of the end of an older text
    /// whose last entry that is.
    pub fn tail(&self, from: usize) -> String {
        let pretty = ron::ser::PrettyConfig::new().depth_limit(0);
        let mut tail = String::new();
        for entry in self.inputs.iter().skip(from) {
            let text = ron::ser::to_string_pretty(entry, pretty.clone());
            let text = text.expect("an entry is plain data");
            tail.extend([ENTRY, &text, ",\n"]);
        }
        tail + END
    }

    /// From a text that breaks off among its inputs, as that of a program which was stopped while it wrote, or of a full disk:
    /// the run up to the last entry that is whole. `None` if it breaks off before its inputs, or does not break off but
    /// is wrong.
    pub fn parse_cut(text: &str) -> Option<Replay> {
        let list = text.find(LIST)? + LIST.len();
        let last = text[list..].rfind("))").map(|at| list + at + 2);
        let kept = last.unwrap_or(list);
        let rest = text[kept..].trim_start_matches(',').trim_start();
        let is_entry =
            |c: char| c.is_ascii_alphanumeric() || c.is_whitespace() || "_:,()-".contains(c);
        let breaks_off = match rest.strip_prefix(']') {
            Some(end) => matches!(end.trim_end(), "" | ","),
            None => rest.is_empty() || rest.starts_with('(') && rest.chars().all(is_entry),
        };
        let whole = format!("{}])", &text[..kept]);
        Replay::parse(&whole).ok().filter(|_| breaks_off)
    }

    /// From text.
    ///
    /// # Errors
    /// If it is not a replay of this version, or a field holds what it cannot.
    pub fn parse(text: &str) -> Result<Replay, ReplayError> {
        let options = ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
        let syntax = |error: ron::error::SpannedError| ReplayError::Syntax(error.to_string());
        // The version first: a newer file shall be called newer, not broken.
        if let Ok(Header { version }) = options.from_str(text)
            && version != VERSION
        {
            return Err(ReplayError::Version(version));
        }
        let replay: Replay = options.from_str(text).map_err(syntax)?;
        replay.check()?;
        Ok(replay)
    }

    fn check(&self) -> Result<(), ReplayError> {
        if self.version != VERSION {
            return Err(ReplayError::Version(self.version));
        }
        if !(1..=FASTEST).contains(&self.tick_rate) {
            return Err(ReplayError::Field(
                "tick_rate",
                format!("{} is outside 1..={FASTEST}", self.tick_rate),
            ));
        }
        if let Some(i) = self.inputs.iter().position(|&(ticks, _)| ticks == 0) {
            return Err(ReplayError::Field(
                "inputs",
                format!("entry {i} lasts 0 ticks"),
            ));
        }
        if self.ticks() > LONGEST {
            return Err(ReplayError::Field(
                "inputs",
                format!("{} ticks are more than {LONGEST}", self.ticks()),
            ));
        }
        if self
            .run
            .as_ref()
            .is_some_and(|run| !run.seconds.is_finite())
        {
            return Err(ReplayError::Field("run", "its time is no number".into()));
        }
        self.tuning.check().map_err(ReplayError::Tuning)
    }
}

#[cfg(test)]
mod tests;
