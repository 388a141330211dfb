//! Levels that are read and built beside the running game: a thread works, frames go on, a bar shows how far it is, and who does
//! not want to wait leaves.
//!
//! Time spent here is none of the simulation's: a world begins, or goes on, when its level is there.

use super::app::App;
use super::menu::caps::{self, with_alpha};
use super::menu::prompts::{self, Device};
use super::menu::view::{INK, PAPER, WARM};
use super::notices::Topic;
use super::reload::Watch;
use super::text::{Face, Style, Text};
use crate::cli::load::{self, LoadError};
use crate::game::{Run, Stage};
use crate::mesh::{Part, Phase, Progress};
use sdl2::controller::Button;
use sdl2::event::Event;
use sdl2::keyboard::Scancode;
use sdl2::mouse::MouseButton;
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError, channel};
use std::time::Duration;

/// How long a frame waits for a level before a bar is shown: most are there sooner.
const PATIENCE: Duration = Duration::from_millis(250);
/// Size of the picture's height that lengths are meant for.
const DESIGN: f32 = 720.0;
/// The plate: width, height, and its top as a share of the picture's height.
const PLATE: [f32; 2] = [460.0, 104.0];
const PLATE_AT: f32 = 0.72;
/// Room within it, and height of the bar.
const ROOM: f32 = 24.0;
const BAR: f32 = 8.0;

/// What is done with a level that is there.
pub(super) enum Then {
    /// A run of a level of this name, from its start or from where one was left.
    Begin(String, Option<Run>),
    /// It is played from its start, and leaves no traces.
    Open,
    /// The world that is played goes on in it.
    Reload,
}

type Answer = Result<Arc<Stage>, LoadError>;

/// A level on its way.
pub struct Loading {
    wait: Wait,
    answer: Receiver<Answer>,
    name: String,
    file: Watch,
    then: Then,
}

/// Somebody waits, as long as this is there.
struct Wait(Arc<Progress>);

impl Drop for Wait {
    fn drop(&mut self) {
        self.0.leave();
    }
}

impl App {
    /// Reads and builds a level. What is then to be done is done at once, if that is quick. One that is on its way is left.
    pub(super) fn load_level(&mut self, path: &Path, then: Then) {
        self.loading = None;
        let file = Watch::new(path);
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let progress = Arc::new(Progress::default());
        let (send, answer) = channel();
        let loading = Loading {
            wait: Wait(Arc::clone(&progress)),
            answer,
            name: name.into_owned(),
            file,
            then,
        };
        let path = path.to_path_buf();
        let work = move || {
            let answer = load::stage_watched(&path, Part::whole(&progress));
            let _ = send.send(answer); // whoever waited may have left
        };
        let worker = std::thread::Builder::new().name("level".into());
        if let Err(error) = worker.spawn(work) {
            return self.notices.fail(Topic::Level, error);
        }
        match loading.answer.recv_timeout(PATIENCE) {
            Err(RecvTimeoutError::Timeout) => self.loading = Some(loading),
            answer => self.take_level(loading, answer.ok()),
        }
    }

    /// Takes the level that was waited for, once it is there.
    pub(super) fn look_for_level(&mut self) {
        let Some(loading) = self.loading.take() else {
            return;
        };
        match loading.answer.try_recv() {
            Err(TryRecvError::Empty) => self.loading = Some(loading),
            answer => self.take_level(loading, answer.ok()),
        }
    }

    /// The level that is on its way.
    pub fn loading(&self) -> Option<&Loading> {
        self.loading.as_ref()
    }

    fn take_level(&mut self, loading: Loading, answer: Option<Answer>) {
        let Loading { file, then, .. } = loading;
        let stage = match answer {
            Some(Ok(stage)) => stage,
            Some(Err(error)) => return self.notices.fail(Topic::Level, error),
            None => return self.notices.fail(Topic::Level, "it could not be built"),
        };
        self.notices.solve(Topic::Level);
        match then {
            Then::Begin(key, run) => self.begin_in(stage, key, run.as_ref(), file),
            Then::Open => self.open_stage(stage, file),
            Then::Reload => self.go_on_in(stage),
        }
    }

    /// While a level is on its way, who goes back leaves it; in a menu nothing else is done. Whether that was all of an event.
    pub(super) fn loading_takes(&mut self, event: &Event) -> bool {
        if self.loading.is_none() {
            return false;
        }
        let in_menu = self.front.is_open();
        let back = match event {
            Event::KeyDown {
                scancode: Some(Scancode::Escape),
                repeat: false,
                ..
            } => true,
            Event::ControllerButtonDown { button, .. } => in_menu && *button == Button::B,
            Event::MouseButtonDown { mouse_btn, .. } => in_menu && *mouse_btn == MouseButton::Right,
            _ => false,
        };
        if back {
            self.loading = None;
            self.notices.say("Left: the level was not loaded");
        }
        let is_press = matches!(
            event,
            Event::KeyDown { .. }
                | Event::ControllerButtonDown { .. }
                | Event::MouseButtonDown { .. }
                | Event::MouseWheel { .. }
        );
        back || in_menu && is_press
    }
}

/// What is being done, for people.
fn words(phase: Phase) -> &'static str {
    match phase {
        Phase::Reading => "reading",
        Phase::Crossing => "finding crossings",
        Phase::Snapping => "rounding to the grid",
        Phase::Triangulating => "drawing triangles",
        Phase::Covering => "finding what lies in what",
    }
}

impl Loading {
    /// How much of it is done, 0 to 1.
    pub fn share(&self) -> f32 {
        self.wait.0.share()
    }

    /// Whether the world that is played goes on in it.
    pub(super) fn is_reload(&self) -> bool {
        matches!(self.then, Then::Reload)
    }

    /// The bar.
    pub(super) fn draw(&self, text: &mut Text, device: Device) {
        let [width, height] = text.size();
        let unit = height / DESIGN;
        let [plate, high] = PLATE.map(|length| length * unit);
        let (left, top) = ((width - plate) / 2.0, height * PLATE_AT);
        let (from, to) = (left + ROOM * unit, left + plate - ROOM * unit);
        let style = Style {
            face: Face::Body,
            px: 17.0 * unit,
            tracking: 0.0,
            colour: PAPER,
            shadow: 0.0,
        };
        let small = Style {
            px: 15.0 * unit,
            ..style
        };
        text.rect([left, top, plate, high], with_alpha(INK, 0.86));
        text.write(
            style,
            from,
            top + 34.0 * unit,
            &format!("Loading {}", self.name),
        );
        let percent = format!("{} %", (self.share() * 100.0) as u32);
        text.ending(style, to, top + 34.0 * unit, &percent);
        let bar = [from, top + 46.0 * unit, to - from, BAR * unit];
        text.rect(bar, with_alpha(PAPER, 0.22));
        let done = [bar[0], bar[1], bar[2] * self.share(), bar[3]];
        text.rect(done, WARM);
        let line = top + 83.0 * unit;
        text.write(small.faded(0.85), from, line, words(self.wait.0.phase()));
        // Beside a running game buttons are the hero's.
        let cap = prompts::back(device);
        let leave = text.width(small, "Leave");
        let room = caps::width(text, &cap, small.px) + 8.0 * unit;
        let x = caps::draw(text, &cap, to - leave - room, line, small.px, PAPER);
        text.write(small, x + 8.0 * unit, line, "Leave");
    }
}
