//! What is played: from a player or a replay, in which level, recorded where.

use super::ShellError;
use super::input::Controls;
use super::notices::{Notices, Topic};
use super::play::Play;
use super::reload::Watch;
use crate::cli::files::{self, FileError};
use crate::cli::{Options, Source, load, tuning};
use crate::game::{Input, Replay, World};
use crate::tune::Tuning;
use std::path::{Path, PathBuf};

/// The level that is played unless asked otherwise.
pub const LEVEL: &str = "levels/quarry.ron";

/// Everything that is known before there is a window.
pub struct Start {
    /// The world.
    pub play: Play,
    /// Where its input comes from.
    pub feed: Feed,
    /// Where its input goes to.
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
            let recorder = record
                .as_deref()
                .map(|path| Recorder::new(path, level, &world, *seed, &tuning));
            Ok(Start {
                play: Play::new(world, &tuning),
                feed: Feed::Player,
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
    Ok(Start {
        play: Play::new(world, &replay.tuning),
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
            (Feed::Player, Some(recorder)) if recorder.ended.is_none() => {
                format!("player, recorded: {} ticks", recorder.replay.ticks())
            }
            (Feed::Player, _) => "player".into(),
        }
    }
}

/// A run being recorded. A replay holds one tuning and one level: when they change, the recording ends there.
pub struct Recorder {
    path: PathBuf,
    replay: Replay,
    ended: Option<&'static str>,
}

impl Recorder {
    /// A recording that will be written to a file.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn new(
        path: &Path,
        level: &Path,
        world: &World,
        seed: u64,
        tuning: &Tuning,
    ) -> Result<Recorder, FileError> {
        files::check_writable(path)?;
        let level = level.to_string_lossy();
        let replay = Replay::new(&level, world.stage(), world.tick_rate(), seed, tuning);
        Ok(Recorder {
            path: path.to_path_buf(),
            replay,
            ended: None,
        })
    }

    /// Adds the input of a tick.
    pub fn push(&mut self, input: Input) {
        if self.ended.is_none() {
            self.replay.push(input);
        }
    }

    /// The motion changes. Before the first tick that is where the run begins. Returns whether this ended the recording.
    pub fn retune(&mut self, tuning: &Tuning) -> bool {
        if self.replay.inputs.is_empty() {
            self.replay.tuning = tuning.clone();
        }
        self.replay.tuning.motion != tuning.motion && self.end("the tuning was changed")
    }

    /// Ends the recording; returns whether it was still going on.
    pub fn end(&mut self, reason: &'static str) -> bool {
        let was_going_on = self.ended.is_none();
        self.ended.get_or_insert(reason);
        was_going_on
    }

    /// Writes the file; says what was written.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(self) -> Result<String, FileError> {
        files::write_atomic(&self.path, self.replay.to_text().as_bytes())?;
        let reason = self
            .ended
            .map(|reason| format!(" (ended when {reason})"))
            .unwrap_or_default();
        let (ticks, path) = (self.replay.ticks(), self.path.display());
        Ok(format!("recorded  {ticks} ticks to {path}{reason}"))
    }
}
