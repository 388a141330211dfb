//! The check of a level for those who make it: all its meshes, what does not mean what it seems to, and random play with every
//! invariant watched. Each part is a file of its own, and a line of [`PARTS`].

mod meshes;
mod one_ways;
mod purpose;
mod slopes;
mod sweeps;
mod walks;

use super::load::{self, LoadError};
use super::tuning;
use crate::game::{Replay, Stage};
use crate::level::Feature;
use crate::tune::Tuning;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The parts of the check, in the order in which they are done and told.
const PARTS: &[fn(&Case, &mut Report)] = &[
    meshes::check,
    purpose::check,
    slopes::check,
    one_ways::check,
    sweeps::check,
    walks::check,
];

/// Ticks that are walked unless asked otherwise.
pub const TICKS: u64 = 100_000;

/// Where a run that shows a fault is written unless asked otherwise.
pub const REPLAY: &str = "check.replay.ron";

/// What is to be checked, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The level.
    pub level: PathBuf,
    /// The tuning to walk with; `None` for the defaults.
    pub tuning: Option<PathBuf>,
    /// Ticks to walk, all walks together.
    pub ticks: u64,
    /// Ticks a second.
    pub tick_rate: u32,
    /// Seed of the random player.
    pub seed: u64,
    /// Where to write the run that shows what is wrong; `None` for [`REPLAY`].
    pub record: Option<PathBuf>,
}

/// What each part looks at.
struct Case<'a> {
    plan: &'a Plan,
    stage: &'a Arc<Stage>,
    tuning: &'a Tuning,
}

/// What a check has found.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// What was done, line by line.
    done: Vec<String>,
    /// What is wrong, and where.
    faults: Vec<String>,
    /// A run that shows the first fault of a walk.
    pub replay: Option<Replay>,
}

impl Report {
    /// Nothing is wrong.
    pub fn is_clean(&self) -> bool {
        self.faults.is_empty()
    }

    /// Says what was done.
    fn done(&mut self, line: String) {
        self.done.push(line);
    }

    /// Says what is wrong, and where.
    fn wrong(&mut self, fault: String) {
        self.faults.push(fault);
    }
}

impl std::fmt::Display for Report {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        for line in &self.done {
            writeln!(f, "{line}")?;
        }
        for fault in &self.faults {
            writeln!(f, "wrong     {fault}")?;
        }
        match self.faults.len() {
            0 => write!(f, "found     nothing wrong"),
            n => write!(f, "found     {n} wrong"),
        }
    }
}

/// Checks a level.
///
/// # Errors
/// The level or the tuning cannot be read, or breaks a rule of its format.
pub fn run(plan: &Plan) -> Result<Report, LoadError> {
    let stage = load::stage(&plan.level)?;
    let tuning = match &plan.tuning {
        Some(path) => tuning::load(path).map_err(LoadError::File)?,
        None => Tuning::default(),
    };
    let name = &stage.level.name;
    let mut report = Report {
        done: vec![format!("level     {}: {name}", plan.level.display())],
        faults: Vec::new(),
        replay: None,
    };
    let case = Case {
        plan,
        stage: &stage,
        tuning: &tuning,
    };
    PARTS.iter().for_each(|check| check(&case, &mut report));
    Ok(report)
}

/// What a feature is called in a report.
fn name_of(feature: &Feature) -> String {
    match feature.id.as_str() {
        "" => "the goal box".to_owned(),
        id => format!("feature {id:?}"),
    }
}

/// Writes the run that shows a fault, if there is one; says where.
///
/// # Errors
/// The file cannot be written.
pub fn write_replay(
    plan: &Plan,
    report: &Report,
) -> Result<Option<String>, super::files::FileError> {
    let Some(replay) = &report.replay else {
        return Ok(None);
    };
    let path = plan.record.as_deref().unwrap_or(Path::new(REPLAY));
    super::files::write_atomic(path, replay.to_text().as_bytes())?;
    Ok(Some(format!("replay    {}", path.display())))
}
