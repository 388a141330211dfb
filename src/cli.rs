//! The command line: what may be asked of the program, and what contradicts what.
//!
//! Parsing touches nothing but its arguments, so that every refusal can be tested without a window.

pub mod check;
pub mod files;
pub mod headless;
mod help;
pub mod lines;
pub mod load;
mod preset;
pub mod summary;
pub mod terminal;
pub mod tuning;
mod walk;

pub use help::HELP;
pub use preset::Preset;

use crate::game::replay::LONGEST;
use lexopt::Arg;
use std::ffi::OsString;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::str::FromStr;

/// Ticks per second unless asked otherwise.
pub const TICK_RATE: u32 = 120;
const TICK_RATES: RangeInclusive<u32> = 10..=2000;
const FILM_SECONDS: RangeInclusive<u32> = 1..=3600;
const BENCH_FRAMES: RangeInclusive<u32> = 1..=100_000;
const SIDES: RangeInclusive<u32> = 64..=16384;

/// The devices that `--device` knows.
pub const DEVICES: [&str; 4] = ["keys", "letters", "shapes", "signs"];

/// The menus that `--screen` knows.
pub const SCREENS: [&str; 11] = [
    "title",
    "levels",
    "pause",
    "results",
    "settings",
    "video",
    "audio",
    "controls",
    "accessibility",
    "credits",
    "confirm",
];

/// What the program was asked to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Print [`HELP`].
    Help,
    /// Print the version.
    Version,
    /// Play a replay without a window.
    Headless {
        /// The replay file.
        replay: PathBuf,
    },
    /// Write what a replay, or a file of sound, is heard as.
    Soundtrack {
        /// What is heard.
        of: Heard,
        /// The WAV to write.
        file: PathBuf,
    },
    /// Check a level.
    Check(check::Plan),
    /// Open a window.
    Window(Options),
}

/// What a soundtrack is of.
#[derive(Clone, Debug, PartialEq)]
pub enum Heard {
    /// A replay file.
    Replay(PathBuf),
    /// A file of sound or music.
    Sound(PathBuf),
}

/// How to run with a window.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Where level and input come from.
    pub source: Source,
    /// Take this picture and leave, instead of being played.
    pub screenshot: Option<Screenshot>,
    /// Take these pictures and leave, instead of being played.
    pub film: Option<Film>,
    /// Measure so many frames and leave, instead of being played.
    pub bench_frames: Option<u32>,
    /// Size in points; `None` for the default.
    pub size: Option<(u32, u32)>,
    /// Start in fullscreen.
    pub fullscreen: bool,
    /// Wait for the display.
    pub vsync: bool,
    /// How much the picture may cost; `None` if nobody said.
    pub preset: Option<Preset>,
    /// Where settings and progress are kept; `None` for the user's folder.
    pub config_dir: Option<PathBuf>,
    /// The menu to start with, by its name.
    pub screen: Option<&'static str>,
    /// The device whose prompts are shown until one is used, by its name.
    pub device: Option<&'static str>,
    /// Start with the overlay open.
    pub overlay: bool,
    /// Start with the mesh drawn.
    pub mesh: bool,
    /// No sound.
    pub mute: bool,
}

impl Options {
    /// Whether the game starts in play, instead of at its title.
    pub fn is_direct(&self) -> bool {
        let asked = match &self.source {
            Source::Replay(_) => true,
            Source::Live { level, record, .. } => level.is_some() || record.is_some(),
        };
        asked || self.screenshot.is_some() || self.film.is_some() || self.bench_frames.is_some()
    }
}

/// Where level and input come from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// A player.
    Live {
        /// Level file; `None` for the default.
        level: Option<PathBuf>,
        /// Tuning file; `None` for the default.
        tuning: Option<PathBuf>,
        /// Ticks per second.
        tick_rate: u32,
        /// Seed of the game's random numbers.
        seed: u64,
        /// Where to write the inputs.
        record: Option<PathBuf>,
    },
    /// A replay file.
    Replay(PathBuf),
}

/// One picture of one moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Screenshot {
    /// The PNG to write.
    pub file: PathBuf,
    /// The tick to show.
    pub at: u64,
}

/// Pictures of some seconds of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Where they go, one after the other; a pipe will do.
    pub file: PathBuf,
    /// The tick before the first of them.
    pub at: u64,
    /// How many seconds.
    pub seconds: u32,
}

/// Why the options make no sense.
#[derive(Clone, Debug, PartialEq)]
pub struct UsageError(String);

impl std::fmt::Display for UsageError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for UsageError {}

/// Understands the arguments (without the program's name).
///
/// # Errors
/// An option that is unknown, given twice, without its value, with a value that cannot be, or together with one
/// that it contradicts.
pub fn parse(args: impl IntoIterator<Item = OsString>) -> Result<Command, UsageError> {
    let given = Given::collect(args)?;
    if given.has("help") {
        return Ok(Command::Help);
    }
    if given.has("version") {
        return Ok(Command::Version);
    }
    given.check_contradictions()?;
    let replay = given.path("replay").unwrap_or_default();
    if given.has("headless") {
        return Ok(Command::Headless { replay });
    }
    if let Some(file) = given.path("soundtrack") {
        let of = match given.path("sound") {
            Some(sound) => Heard::Sound(sound),
            None => Heard::Replay(replay),
        };
        return Ok(Command::Soundtrack { of, file });
    }
    if let Some(level) = given.path("check") {
        return Ok(Command::Check(given.check_plan(level)?));
    }
    Ok(Command::Window(Options {
        source: given.source()?,
        screenshot: given.screenshot()?,
        film: given.film()?,
        bench_frames: given.number("bench-frames", BENCH_FRAMES)?,
        size: given.size()?,
        fullscreen: given.has("fullscreen"),
        vsync: !given.has("no-vsync"),
        preset: given.preset()?,
        config_dir: given.path("config-dir"),
        screen: given.one_of("screen", &SCREENS)?,
        device: given.one_of("device", &DEVICES)?,
        overlay: given.has("overlay"),
        mesh: given.has("mesh"),
        mute: given.has("mute"),
    }))
}

/// Options that stand alone, and options that take a value.
const FLAGS: &[&str] = &[
    "headless",
    "fullscreen",
    "no-vsync",
    "overlay",
    "mesh",
    "mute",
    "help",
    "version",
];
const VALUED: &[&str] = &[
    "check",
    "ticks",
    "level",
    "tuning",
    "record",
    "replay",
    "screenshot",
    "soundtrack",
    "sound",
    "at",
    "film",
    "seconds",
    "bench-frames",
    "size",
    "preset",
    "config-dir",
    "screen",
    "device",
    "tick-rate",
    "seed",
];

/// Options that are about a window.
const NO_WINDOW: &[&str] = &[
    "screenshot",
    "at",
    "film",
    "seconds",
    "bench-frames",
    "size",
    "fullscreen",
    "no-vsync",
    "preset",
    "config-dir",
    "screen",
    "device",
    "overlay",
    "mesh",
    "mute",
];

/// Pairs that contradict each other, with the reason.
const CONTRADICTIONS: &[(&str, &[&str], &str)] = &[
    (
        "replay",
        &["level", "tuning", "tick-rate", "seed"],
        "a replay brings its own",
    ),
    ("replay", &["record"], "a replay is recorded already"),
    (
        "screenshot",
        &["record", "fullscreen"],
        "a screenshot is not played",
    ),
    (
        "bench-frames",
        &["record", "screenshot", "film"],
        "what is measured is not played",
    ),
    ("film", &["record", "screenshot"], "a film is not played"),
    (
        "check",
        &["level", "replay", "headless", "soundtrack"],
        "it names the level, and plays it without a window",
    ),
    (
        "check",
        NO_WINDOW,
        "without a window there is nothing to show",
    ),
    (
        "headless",
        NO_WINDOW,
        "without a window there is nothing to show",
    ),
    (
        "soundtrack",
        NO_WINDOW,
        "without a window there is nothing to show",
    ),
    ("soundtrack", &["headless"], "one thing at a time"),
    ("sound", &["replay"], "one thing at a time"),
];

/// Options that are pointless without another one, or without one of several.
const NEEDS: &[(&str, &[&str])] = &[
    ("ticks", &["check"]),
    ("headless", &["replay"]),
    ("soundtrack", &["replay", "sound"]),
    ("sound", &["soundtrack"]),
    ("screenshot", &["at"]),
    ("at", &["screenshot", "film"]),
    ("film", &["seconds"]),
    ("seconds", &["film"]),
];

/// The arguments by name, each at most once; flags have no value.
struct Given(Vec<(&'static str, Option<OsString>)>);

impl Given {
    fn collect(args: impl IntoIterator<Item = OsString>) -> Result<Given, UsageError> {
        let mut parser = lexopt::Parser::from_args(args);
        let mut given = Given(Vec::new());
        while let Some(arg) = parser.next().map_err(|e| UsageError(e.to_string()))? {
            let (name, valued) = known(arg)?;
            if given.has(name) {
                return usage(format!("--{name} is given twice"));
            }
            let value = if valued {
                Some(parser.value().map_err(|e| UsageError(e.to_string()))?)
            } else {
                None
            };
            given.0.push((name, value));
        }
        Ok(given)
    }

    fn has(&self, name: &str) -> bool {
        self.0.iter().any(|(n, _)| *n == name)
    }

    fn value(&self, name: &str) -> Option<&OsString> {
        self.0.iter().find(|(n, _)| *n == name)?.1.as_ref()
    }

    fn path(&self, name: &str) -> Option<PathBuf> {
        self.value(name).map(PathBuf::from)
    }

    fn check_contradictions(&self) -> Result<(), UsageError> {
        for (one, others, why) in CONTRADICTIONS {
            if let Some(other) = others.iter().find(|other| self.has(one) && self.has(other)) {
                return usage(format!(
                    "--{one} and --{other} contradict each other: {why}"
                ));
            }
        }
        let lacks = |others: &[&str]| !others.iter().any(|other| self.has(other));
        match NEEDS
            .iter()
            .find(|(one, others)| self.has(one) && lacks(others))
        {
            Some((one, others)) => usage(format!("--{one} needs --{}", others.join(" or --"))),
            None => Ok(()),
        }
    }

    fn source(&self) -> Result<Source, UsageError> {
        if let Some(replay) = self.path("replay") {
            return Ok(Source::Replay(replay));
        }
        Ok(Source::Live {
            level: self.path("level"),
            tuning: self.path("tuning"),
            tick_rate: self.number("tick-rate", TICK_RATES)?.unwrap_or(TICK_RATE),
            seed: self.number("seed", 0..=u64::MAX)?.unwrap_or(0),
            record: self.path("record"),
        })
    }

    fn check_plan(&self, level: PathBuf) -> Result<check::Plan, UsageError> {
        Ok(check::Plan {
            level,
            tuning: self.path("tuning"),
            ticks: self.number("ticks", 0..=LONGEST)?.unwrap_or(check::TICKS),
            tick_rate: self.number("tick-rate", TICK_RATES)?.unwrap_or(TICK_RATE),
            seed: self.number("seed", 0..=u64::MAX)?.unwrap_or(0),
            record: self.path("record"),
        })
    }

    fn screenshot(&self) -> Result<Option<Screenshot>, UsageError> {
        let at = self.number("at", 0..=LONGEST)?;
        Ok(self
            .path("screenshot")
            .zip(at)
            .map(|(file, at)| Screenshot { file, at }))
    }

    fn film(&self) -> Result<Option<Film>, UsageError> {
        let seconds = self.number("seconds", FILM_SECONDS)?;
        let film = self.path("film").zip(seconds);
        let at = self.number("at", 0..=LONGEST)?.unwrap_or(0);
        Ok(film.map(|(file, seconds)| Film { file, at, seconds }))
    }

    fn size(&self) -> Result<Option<(u32, u32)>, UsageError> {
        let Some(value) = self.value("size") else {
            return Ok(None);
        };
        let text = value.to_string_lossy();
        let sides = text
            .split_once('x')
            .and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
        match sides {
            Some((w, h)) if SIDES.contains(&w) && SIDES.contains(&h) => Ok(Some((w, h))),
            _ => usage(format!(
                "--size: `{text}` is not WIDTHxHEIGHT with sides from {} to {}",
                SIDES.start(),
                SIDES.end()
            )),
        }
    }

    fn one_of(
        &self,
        option: &str,
        names: &[&'static str],
    ) -> Result<Option<&'static str>, UsageError> {
        let Some(value) = self.value(option) else {
            return Ok(None);
        };
        let text = value.to_string_lossy();
        match names.iter().find(|name| **name == text) {
            Some(name) => Ok(Some(name)),
            None => usage(format!(
                "--{option}: `{text}` is none of {}",
                names.join(", ")
            )),
        }
    }

    fn preset(&self) -> Result<Option<Preset>, UsageError> {
        let Some(value) = self.value("preset") else {
            return Ok(None);
        };
        let text = value.to_string_lossy();
        match Preset::named(&text) {
            None => usage(format!("--preset: `{text}` is not low, medium or high")),
            preset => Ok(preset),
        }
    }

    fn number<T>(&self, name: &str, range: RangeInclusive<T>) -> Result<Option<T>, UsageError>
    where
        T: FromStr + PartialOrd + std::fmt::Display,
    {
        let Some(value) = self.value(name) else {
            return Ok(None);
        };
        let text = value.to_string_lossy();
        match text.parse() {
            Ok(number) if range.contains(&number) => Ok(Some(number)),
            _ => usage(format!(
                "--{name}: `{text}` is not a whole number from {} to {}",
                range.start(),
                range.end()
            )),
        }
    }
}

/// The option's name as we write it, and whether it takes a value.
fn known(arg: Arg) -> Result<(&'static str, bool), UsageError> {
    let name = match arg {
        Arg::Long(name) => name,
        Arg::Short('h') => "help",
        Arg::Short('V') => "version",
        Arg::Short(c) => return usage(format!("unknown option -{c}")),
        Arg::Value(value) => {
            return usage(format!("unexpected argument `{}`", value.to_string_lossy()));
        }
    };
    let find = |names: &[&'static str]| names.iter().find(|n| **n == name).copied();
    match (find(FLAGS), find(VALUED)) {
        (Some(flag), _) => Ok((flag, false)),
        (None, Some(valued)) => Ok((valued, true)),
        (None, None) => usage(format!("unknown option --{name}")),
    }
}

fn usage<T>(message: String) -> Result<T, UsageError> {
    Err(UsageError(message))
}

#[cfg(test)]
mod tests;
