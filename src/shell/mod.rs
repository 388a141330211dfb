//! The shell: window, input, picture, overlay. Everything that needs SDL2, OpenGL or ImGui is in this folder.
//!
//! In reading order: [`app`] (the frame, as a sequence), `picture` (what it shows), [`platform`] (the window), `xlib` (what X servers complain of),
//! [`input`] and [`pads`] (devices), [`clock`] (time to ticks), [`runs`] (from player or replay, recorded or not),
//! [`log`] (a run's inputs as they come), [`guard`] (what is left of it if the game fails), [`play`] (a world being
//! played), [`edits`] (what the overlay may ask for), [`reload`] (files that change), [`levels`] (those to choose from),
//! [`notices`] (what went wrong), [`capture`] (pictures as files), `bench` (frame times), [`settings`] (what is set and what has been reached, and their files), [`menu`] (title, pause, settings as
//! values, and their look), [`front`] (the menus in the running game), `games` (runs begun and finished), `loading` (levels on
//! their way), `liking`
//! (settings made to hold), [`audio`] and `sounds` (what is heard), [`hud`] (what is told beside the world), `contrast`
//! (bright outlines by wish), `jolt` (how hard landings shake the picture), [`text`] (letters), [`overlay`] (panels and
//! drawings for developers), [`puppet`] (the hero's model and figure), [`render`] (the world's picture).

pub mod app;
pub mod audio;
mod bench;
pub mod capture;
pub mod clock;
mod contrast;
pub mod edits;
mod fall;
pub mod front;
mod games;
pub mod guard;
pub mod hud;
pub mod input;
mod jolt;
pub mod levels;
mod liking;
mod loading;
pub mod log;
pub mod menu;
pub mod notices;
pub mod overlay;
pub mod pads;
mod picture;
pub mod platform;
pub mod play;
pub mod puppet;
pub mod reload;
pub mod render;
pub mod runs;
pub mod settings;
mod shots;
mod sounds;
pub mod text;
mod xlib;

use crate::cli::files::FileError;
use crate::cli::load::LoadError;
use crate::cli::{Film, Options, Screenshot};

/// Why there is no game, or no longer one.
#[derive(Debug)]
pub enum ShellError {
    /// No display, no OpenGL, no events.
    Platform(String),
    /// A file that was asked for.
    File(FileError),
    /// The level, or the replay.
    Load(LoadError),
    /// The replay is shorter than was asked for.
    Replay(String),
    /// The picture.
    Render(render::RenderError),
}

impl std::fmt::Display for ShellError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            ShellError::Platform(reason) | ShellError::Replay(reason) => f.write_str(reason),
            ShellError::File(error) => error.fmt(f),
            ShellError::Load(error) => error.fmt(f),
            ShellError::Render(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for ShellError {}

impl From<FileError> for ShellError {
    fn from(error: FileError) -> Self {
        ShellError::File(error)
    }
}

impl From<LoadError> for ShellError {
    fn from(error: LoadError) -> Self {
        ShellError::Load(error)
    }
}

impl From<render::RenderError> for ShellError {
    fn from(error: render::RenderError) -> Self {
        ShellError::Render(error)
    }
}

/// Opens the window and plays, or takes the picture that was asked for; returns when the game is left.
///
/// # Errors
/// Whatever keeps the game from starting, and a recording or picture that cannot be written.
pub fn run(options: &Options) -> Result<(), ShellError> {
    let begin = std::time::Instant::now();
    guard::keep(|| run_app(options, begin))
}

fn run_app(options: &Options, begin: std::time::Instant) -> Result<(), ShellError> {
    let mut app = app::App::open(options)?;
    if let Some(Screenshot { file, at }) = &options.screenshot {
        return app.screenshot(file, *at);
    }
    if let Some(Film { file, at, seconds }) = &options.film {
        return app.film(file, *at, *seconds);
    }
    match options.bench_frames {
        Some(frames) => bench::run(&mut app, frames, options.preset, begin),
        None => app.run(),
    }
}
