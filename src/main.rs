//! The game's program: understands its arguments, then plays.

use edgewalker::cli::check::{self, Plan};
use edgewalker::cli::{self, Command, Heard, Options, terminal};
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let result = match cli::parse(std::env::args_os().skip(1)) {
        Ok(Command::Help) => print(cli::HELP.trim_end()),
        Ok(Command::Version) => print(concat!("edgewalker ", env!("CARGO_PKG_VERSION"))),
        Ok(Command::Headless { replay }) => cli::headless::play(&replay)
            .map_err(|e| e.to_string())
            .and_then(|summary| print(&summary.to_string())),
        Ok(Command::Soundtrack { of, file }) => write_soundtrack(&of, &file),
        Ok(Command::Check(plan)) => check(&plan),
        Ok(Command::Window(options)) => play(&options),
        Err(error) => {
            terminal::say(format!("{error}\nTry `edgewalker --help`."));
            return ExitCode::from(2);
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            terminal::say(reason);
            ExitCode::FAILURE
        }
    }
}

/// To the terminal, or to a reader who may have gone.
fn print(text: &str) -> Result<(), String> {
    use std::io::Write;
    match writeln!(std::io::stdout(), "{text}") {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(e.to_string()),
        _ => Ok(()),
    }
}

/// Prints what is wrong with a level; an error if something is.
fn check(plan: &Plan) -> Result<(), String> {
    let report = check::run(plan).map_err(|e| e.to_string())?;
    print(&report.to_string())?;
    if let Some(text) = check::write_replay(plan, &report).map_err(|e| e.to_string())? {
        print(&text)?;
    }
    match report.is_clean() {
        true => Ok(()),
        false => Err(format!("{}: not as it should be", plan.level.display())),
    }
}

#[cfg(feature = "shell")]
fn play(options: &Options) -> Result<(), String> {
    edgewalker::shell::run(options).map_err(|e| e.to_string())
}

#[cfg(feature = "shell")]
fn write_soundtrack(of: &Heard, file: &Path) -> Result<(), String> {
    use edgewalker::shell::audio::soundtrack;
    let written = match of {
        Heard::Replay(replay) => soundtrack::write(replay, file),
        Heard::Sound(sound) => soundtrack::write_sound(sound, file),
    };
    written.map_err(|e| e.to_string())
}

#[cfg(not(feature = "shell"))]
fn write_soundtrack(_: &Heard, _: &Path) -> Result<(), String> {
    Err("this build has no sound: it plays replays only (--headless --replay FILE)".into())
}

#[cfg(not(feature = "shell"))]
fn play(_: &Options) -> Result<(), String> {
    Err("this build has no window: it plays replays only (--headless --replay FILE)".into())
}
