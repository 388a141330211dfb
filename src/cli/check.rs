//! The check of a level for those who make it: all its meshes, and random play with every invariant watched.

use super::load::{self, LoadError};
use super::tuning;
use super::walk::{Player, Start, Walk, walk};
use crate::game::{Replay, Shape, Stage, World};
use crate::level::Kind;
use crate::mesh::Mesh;
use crate::tune::Tuning;
use std::path::{Path, PathBuf};
use std::sync::Arc;

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
    check_meshes(&stage, &mut report);
    check_purpose(&stage, &mut report);
    check_walks(&stage, plan, &tuning, &mut report);
    Ok(report)
}

/// Every mesh of every collider and mover keeps its invariants.
fn check_meshes(stage: &Stage, report: &mut Report) {
    let Shape { stand, crouch } = Shape::hero();
    let point = crate::geom::Collider::point();
    let (mut count, mut vertices) = (0, 0);
    for (size, collider) in [("standing", stand), ("crouching", crouch), ("point", point)] {
        let meshes = match stage.meshes(&collider) {
            Ok(meshes) => meshes,
            Err(error) => {
                report.faults.push(format!("{size} mesh: {error}"));
                continue;
            }
        };
        let level = std::iter::once(("the level".to_owned(), &meshes.level));
        let names = stage.level.movers.iter();
        let names = names.map(|mover| format!("mover {:?}", mover.id));
        for (what, mesh) in level.chain(names.zip(&meshes.movers)) {
            let mesh: &Mesh = mesh;
            (count, vertices) = (count + 1, vertices + mesh.vertices().count());
            if let Err(error) = mesh.check() {
                report
                    .faults
                    .push(format!("{size} mesh of {what}: {error}"));
            }
        }
    }
    let line = format!("meshes    {count} built and checked, {vertices} vertices");
    report.done.push(line);
}

/// A trigger that nothing waits for, and a region that solids fill, are mistakes of whoever made the level.
fn check_purpose(stage: &Stage, report: &mut Report) {
    let movers = 0..stage.level.movers.len();
    let awaited: Vec<_> = movers.filter_map(|mover| stage.trigger(mover)).collect();
    let land = stage.land(&Shape::hero());
    let open = |id| {
        let mesh = &land.as_ref().ok()?.stand.level;
        let free = |&f: &_| mesh.cover(f).contains(&id) && !mesh.is_solid(f);
        Some(mesh.faces().any(|f| free(&f)))
    };
    for (id, feature) in stage.features() {
        let name = match feature.id.as_str() {
            "" => "the goal box".to_owned(),
            name => format!("feature {name:?}"),
        };
        if feature.kind == Kind::Trigger && !awaited.contains(&id) {
            report
                .faults
                .push(format!("{name}: nothing waits for this trigger"));
        }
        if !feature.kind.is_terrain() && open(id) == Some(false) {
            report.faults.push(format!(
                "{name}: the standing hero can never be in it, for solids fill it"
            ));
        }
    }
}

/// Random play from the start and from every checkpoint.
fn check_walks(stage: &Arc<Stage>, plan: &Plan, tuning: &Tuning, report: &mut Report) {
    let start = Start {
        name: "the start".into(),
        at: stage.level.start,
    };
    let checkpoint = |feature: &crate::level::Feature| {
        let name = format!("checkpoint {:?}", feature.id);
        feature.respawn.map(|at| Start { name, at })
    };
    let checkpoints = stage.level.features.iter().filter_map(checkpoint);
    let starts: Vec<Start> = std::iter::once(start).chain(checkpoints).collect();
    let walks = starts.len() as u64;
    let Plan {
        ticks,
        tick_rate,
        seed,
        ..
    } = *plan;
    report.done.push(format!(
        "walks     {walks}, together {ticks} ticks at {tick_rate} Hz, seed {seed}"
    ));
    for (number, start) in (0..).zip(&starts) {
        // What is left over goes to the first walks.
        let share = ticks / walks + u64::from(number < ticks % walks);
        let mut player = Player::new(seed.wrapping_add(number));
        let level = plan.level.to_string_lossy();
        let mut replay = Replay::new(&level, stage, tick_rate, seed, tuning);
        replay.start = (number > 0).then_some(start.at);
        let world = match replay.world(Arc::clone(stage)) {
            Ok(world) => world,
            Err(error) => {
                report.faults.push(format!("{}: {error}", start.name));
                continue;
            }
        };
        let Walk { replay, fault } = walk(world, share, replay, &mut player, World::check);
        if let Some(fault) = fault {
            report.faults.push(format!("from {}: {fault}", start.name));
            report.replay.get_or_insert(replay);
        }
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
