//! What is played: from a player or a replay, in which level, recorded where.

use super::ShellError;
use super::input::Controls;
use super::log::{Log, Recorder};
use super::notices::{Notices, Topic};
use super::play::Play;
use super::reload::Watch;
use crate::cli::files;
use crate::cli::{Options, Source, load, tuning};
use crate::game::{Input, Replay, World};
use crate::tune::Tuning;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The level that is played unless asked otherwise.
pub const LEVEL: &str = "levels/quarry.ron";

/// Everything that is known before there is a window.
pub struct Start {
    /// The world.
    pub play: Play,
    /// Where its input comes from.
    pub feed: Feed,
    /// Its inputs, from the beginning.
    pub log: Arc<Log>,
    /// Where they are written as they come, if they are.
    pub recorder: Option<Recorder>,
    /// Its tunables.
    pub tuning: Tuning,
    /// Their file.
    pub tuning_file: Watch,
    /// The level's file.
    pub level_file: Watch,
    /// Seed of the game's random numbers.
    pub seed: u64,
    /// What went wrong and keeps nobody from playing.
    pub notices: Notices,
}

/// Loads what was asked for.
///
/// # Errors
/// A file that was asked for is missing or broken, or the recording could not be written.
pub fn prepare(options: &Options) -> Result<Start, ShellError> {
    match &options.source {
        Source::Replay(path) => prepare_replay(path),
        Source::Live {
            level,
            tuning,
            tick_rate,
            seed,
            record,
        } => {
            let level = level.as_deref().unwrap_or(Path::new(LEVEL));
            let is_played = options.screenshot.is_none();
            let (tuning, tuning_file, notices) = prepare_tuning(tuning.as_deref(), is_played)?;
            let level_file = Watch::new(&files::find(level));
            let world = World::new(load::stage(level)?, *tick_rate, *seed);
            let log = Log::of(Replay::new(
                &level.to_string_lossy(),
                world.stage(),
                *tick_rate,
                *seed,
                &tuning,
            ));
            let recorder = record
                .as_deref()
                .map(|path| Recorder::new(path, log.clone()));
            Ok(Start {
                play: Play::new(world, &tuning),
                feed: Feed::Player,
                log,
                recorder: recorder.transpose()?,
                tuning,
                tuning_file,
                level_file,
                seed: *seed,
                notices,
            })
        }
    }
}

fn prepare_replay(path: &Path) -> Result<Start, ShellError> {
    let replay = load::replay(path)?;
    let level_file = Watch::new(&files::find(Path::new(&replay.level)));
    let world = load::replay_world(path, &replay)?;
    let log = Replay {
        inputs: Vec::new(),
        ..replay.clone()
    };
    Ok(Start {
        play: Play::new(world, &replay.tuning),
        log: Log::of(log),
        recorder: None,
        tuning: replay.tuning.clone(),
        tuning_file: Watch::new(Path::new(tuning::DEFAULT_FILE)),
        level_file,
        seed: replay.seed,
        notices: Notices::default(),
        feed: Feed::Replay {
            replay: Box::new(replay),
            entry: 0,
            used: 0,
        },
    })
}

/// A tuning file that was named must be good; the one that lies there by itself may be broken.
fn prepare_tuning(
    named: Option<&Path>,
    is_played: bool,
) -> Result<(Tuning, Watch, Notices), ShellError> {
    let mut notices = Notices::default();
    let path = named.map_or_else(|| PathBuf::from(tuning::DEFAULT_FILE), files::find);
    let watch = Watch::new(&path);
    let tuning = if named.is_some() {
        tuning::load(&path)?
    } else if is_played && path.exists() {
        tuning::load(&path).unwrap_or_else(|error| {
            notices.fail(Topic::Tuning, error);
            Tuning::default()
        })
    } else {
        Tuning::default()
    };
    Ok((tuning, watch, notices))
}

/// Where input comes from.
pub enum Feed {
    /// Keys and controllers.
    Player,
    /// A replay, so far.
    Replay {
        /// The recorded run.
        replay: Box<Replay>,
        /// Index of the entry that is being used.
        entry: usize,
        /// Ticks of that entry that are used up.
        used: u32,
    },
}

impl Feed {
    /// The input of the next tick; `None` when a replay is over.
    pub fn next(&mut self, controls: &mut Controls) -> Option<Input> {
        let live = controls.take(); // also during a replay, which shall not be followed by what was pressed in it
        let Feed::Replay {
            replay,
            entry,
            used,
        } = self
        else {
            return Some(live);
        };
        let (ticks, input) = *replay.inputs.get(*entry)?;
        *used += 1;
        if *used >= ticks {
            (*entry, *used) = (*entry + 1, 0);
        }
        Some(input)
    }

    /// How many ticks a replay has; none if a player plays.
    pub fn ticks(&self) -> u64 {
        match self {
            Feed::Replay { replay, .. } => replay.ticks(),
            Feed::Player => 0,
        }
    }

    /// Whether this is a replay without any more ticks.
    pub fn is_over(&self) -> bool {
        matches!(self, Feed::Replay { replay, entry, .. } if *entry >= replay.inputs.len())
    }

    /// For people.
    pub fn describe(&self, recorder: Option<&Recorder>) -> String {
        match (self, recorder) {
            (Feed::Replay { replay, .. }, _) => format!("replay of {} ticks", replay.ticks()),
            (Feed::Player, Some(recorder)) if recorder.log().goes_on() => {
                format!("player, recorded: {} ticks", recorder.log().ticks())
            }
            (Feed::Player, _) => "player".into(),
        }
    }
}
