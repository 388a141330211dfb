//! What the overlay, its keys and the tests may ask of the running game: plain values, applied in one place.

use super::app::App;
use super::guard;
use super::levels;
use super::loading::Then;
use super::log::{Log, Recorder};
use super::menu::Screen;
use super::notices::Topic;
use super::play::Play;
use super::reload::Watch;
use super::runs::Feed;
use crate::cli::tuning;
use crate::game::{Replay, Run, Stage, World};
use crate::tune::{Camera, Meta, Motion, Tuning};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Slowest and fastest time, as a share of real time.
pub const SCALES: std::ops::RangeInclusive<f64> = 0.03125..=4.0;

/// A group of tunables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// How the hero moves.
    Motion,
    /// How the camera follows.
    Camera,
}

impl Group {
    /// The declarations.
    pub fn meta(self) -> &'static [Meta] {
        match self {
            Group::Motion => Motion::META,
            Group::Camera => Camera::META,
        }
    }

    /// The values, in the order of the declarations.
    pub fn values(self, tuning: &Tuning) -> Vec<f64> {
        match self {
            Group::Motion => tuning.motion.values(),
            Group::Camera => tuning.camera.values(),
        }
    }

    /// Sets a value, kept within its range; what is no number changes nothing.
    fn set(self, tuning: &mut Tuning, index: usize, value: f64) {
        let slots = match self {
            Group::Motion => tuning.motion.values_mut(),
            Group::Camera => tuning.camera.values_mut(),
        };
        if let (Some(slot), Some(meta), false) = (
            slots.into_iter().nth(index),
            self.meta().get(index),
            value.is_nan(),
        ) {
            *slot = value.clamp(meta.min, meta.max);
        }
    }
}

/// Something that is asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Edit {
    /// Set a tunable, by its place in the declarations.
    Tune {
        /// Of which group.
        group: Group,
        /// Which one.
        index: usize,
        /// The new value.
        value: f64,
    },
    /// All tunables back to their defaults.
    ResetTuning,
    /// Write the tuning file.
    SaveTuning,
    /// Read the tuning file.
    LoadTuning,
    /// Play another level.
    OpenLevel(PathBuf),
    /// Back to the start.
    Restart,
    /// Stop time, or let it run.
    Pause(bool),
    /// One tick, paused.
    Step,
    /// How fast time runs, as a share of real time.
    Scale(f64),
    /// Open or close the overlay.
    Overlay(bool),
    /// Into fullscreen or out of it.
    Fullscreen,
    /// Leave the game.
    Quit,
}

impl App {
    /// Does what was asked for. What fails is told to the player, and the game goes on.
    pub fn apply(&mut self, edit: Edit) {
        match edit {
            Edit::Tune {
                group,
                index,
                value,
            } => {
                let mut tuning = self.tuning.clone();
                group.set(&mut tuning, index, value);
                self.set_tuning(tuning);
            }
            Edit::ResetTuning => self.set_tuning(Tuning::default()),
            Edit::SaveTuning => self.save_tuning(),
            Edit::LoadTuning => self.load_tuning(),
            Edit::OpenLevel(path) => self.open_level(&path),
            Edit::Restart => self.controls.ask_retry(),
            Edit::Pause(paused) => self.pause(paused),
            Edit::Step => self.step_once(),
            Edit::Scale(scale) => self.scale = scale.clamp(*SCALES.start(), *SCALES.end()),
            Edit::Overlay(open) => self.overlay.open = open,
            Edit::Fullscreen => self.toggle_fullscreen(),
            Edit::Quit => self.quit = true,
        }
    }

    /// The tunables.
    pub fn tuning(&self) -> &Tuning {
        &self.tuning
    }

    /// Whether time stands still.
    pub fn is_paused(&self) -> bool {
        self.paused
    }

    /// All changes of the tunables come through here, so that a recording knows of them.
    fn set_tuning(&mut self, tuning: Tuning) {
        self.tuning = tuning;
        if self.log.retune(&self.tuning) {
            self.tell_recording_ends("the tuning was changed");
        }
    }

    /// The log of the run has ended; whoever records it must know.
    pub(super) fn tell_recording_ends(&mut self, reason: &str) {
        let is_recorded = |recorder: &Recorder| std::ptr::eq(recorder.log(), &*self.log);
        if self.recorder.as_ref().is_some_and(is_recorded) {
            self.notices
                .say(format!("The recording ends here: {reason}"));
        }
    }

    /// What is played from now on begins anew, or goes on with a run.
    pub(super) fn log_anew(&mut self, run: Option<&Run>) {
        let world = &self.play.world;
        let level = self.level_file.path().to_string_lossy();
        let begin = Replay::new(
            &level,
            world.stage(),
            world.tick_rate(),
            self.seed,
            &self.tuning,
        );
        self.log = Log::of(Replay {
            run: run.cloned(),
            ..begin
        });
        guard::watch(&self.log, self.front.folder.as_deref());
    }

    /// The tuning that lies beside a chosen level holds while that is played, with its own file; the player's, and its file, are
    /// put aside until another level is chosen.
    pub(super) fn tune_for(&mut self, level: &Path) {
        if let Some((tuning, file)) = self.own_tuning.take() {
            self.tuning_file = file;
            self.set_tuning(tuning);
        }
        let Some(path) = levels::tuning_of(level) else {
            return;
        };
        match tuning::load(&path) {
            Ok(tuning) => {
                let file = std::mem::replace(&mut self.tuning_file, Watch::new(&path));
                self.own_tuning = Some((self.tuning.clone(), file));
                self.set_tuning(tuning);
                self.notices
                    .say(format!("Tuned for this level by {}", path.display()));
            }
            Err(error) => self.notices.fail(Topic::Tuning, error),
        }
    }

    /// Writes the file, and takes what was written for known: it is no change to be loaded again.
    fn save_tuning(&mut self) {
        let path = self.tuning_file.path().to_path_buf();
        match tuning::save(&path, &self.tuning) {
            Ok(()) => {
                self.tuning_file = Watch::new(&path);
                self.notices.say(format!("Saved to {}", path.display()));
                self.notices.solve(Topic::Tuning);
            }
            Err(error) => self.notices.fail(Topic::Tuning, error),
        }
    }

    /// Reads the tuning file; a broken one changes nothing and says why.
    pub(super) fn load_tuning(&mut self) {
        match tuning::load(self.tuning_file.path()) {
            Ok(tuning) => {
                self.set_tuning(tuning);
                self.notices.solve(Topic::Tuning);
                self.notices.say("Tuning loaded");
            }
            Err(error) => self.notices.fail(Topic::Tuning, error),
        }
    }

    /// Plays a level from its start; a broken one is not entered.
    fn open_level(&mut self, path: &Path) {
        self.load_level(path, Then::Open);
    }

    /// Plays a level that is there from its start.
    pub(super) fn open_stage(&mut self, stage: Arc<Stage>, level_file: Watch) {
        self.tune_for(level_file.path());
        let tick_rate = self.play.world.tick_rate();
        self.play = Play::new(World::new(stage, tick_rate, self.seed), &self.tuning);
        self.level_file = level_file;
        self.feed = Feed::Player;
        self.front.leave_run();
        self.hud.begin();
        self.enter_stage();
        self.log_anew(None);
    }

    /// Reads the changed level again, to go on in it.
    pub(super) fn reload_level(&mut self) {
        let path = self.level_file.path().to_path_buf();
        self.load_level(&path, Then::Reload);
    }

    /// Goes on in the changed level, where the hero is if that place is still free.
    pub(super) fn go_on_in(&mut self, stage: Arc<Stage>) {
        self.play.replace_stage(stage);
        self.notices.say("Level loaded");
        self.enter_stage();
    }

    /// What is left to do when the world has another stage.
    pub(super) fn enter_stage(&mut self) {
        self.show_stage();
        self.audio.enter(&self.play.world);
        if self.log.end("the level was changed") {
            self.tell_recording_ends("the level was changed");
        }
    }

    /// Stops time or lets it run; after a replay the player goes on from its end.
    pub(super) fn pause(&mut self, paused: bool) {
        if paused {
            self.clock.settle();
        } else {
            if self.feed.is_over() {
                self.feed = Feed::Player;
            }
            if self.front.menu.root() == Some(Screen::Pause) {
                self.front.menu.close();
            }
        }
        self.paused = paused;
    }

    /// One tick, after which time stands still.
    fn step_once(&mut self) {
        self.pause(true);
        self.play.world.mark();
        self.tick();
    }
}
