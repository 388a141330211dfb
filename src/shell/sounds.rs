//! The running game's sound: opened, told of every tick and of the menus, and as loud as the settings say.

use super::app::App;
use super::audio::{Audio, Volumes};
use super::menu::MenuEvent;
use super::notices::Topic;
use super::settings::Settings;
use crate::cli::terminal;
use crate::sound::{Ear, Sound};
use std::time::Duration;

/// Volumes in the settings are percents.
const FULL: f32 = 100.0;

/// The volumes that settings ask for.
fn volumes(settings: &Settings) -> Volumes {
    let share = |percent: u32| percent as f32 / FULL;
    Volumes {
        master: share(settings.audio.master),
        effects: share(settings.audio.effects),
        music: share(settings.audio.music),
    }
}

/// What is heard of something that happened in the menus.
fn sound_of(event: MenuEvent) -> Sound {
    match event {
        MenuEvent::Moved | MenuEvent::Changed => Sound::MenuMove,
        MenuEvent::Chosen => Sound::MenuChoose,
        MenuEvent::Back | MenuEvent::Refused => Sound::MenuBack,
    }
}

impl App {
    /// Opens the sound. Without it the game goes on, and says so once.
    pub(super) fn open_audio(&mut self) {
        match self.platform.audio().and_then(Audio::open) {
            Ok(audio) => self.audio = audio,
            Err(reason) => {
                let said = format!("No sound: {reason}");
                terminal::say(format!("{said}; the game goes on without it"));
                self.notices.say(said);
            }
        }
        self.apply_volumes();
    }

    /// Makes the settings' volumes hold.
    pub(super) fn apply_volumes(&mut self) {
        let volumes = volumes(self.settings());
        self.audio.set_volumes(volumes);
    }

    /// A tick has been made.
    pub(super) fn hear_tick(&mut self) {
        let (before, now) = self.play.moments();
        let at = self.play.pose(1.0, &self.tuning).target.truncate();
        self.audio.tick(&self.play.world, before, now, Ear { at });
    }

    /// What menus and ticks of this frame have given to hear.
    pub(super) fn play_sounds(&mut self, elapsed: Duration) {
        for event in self.front.heard.drain(..) {
            self.audio.play(sound_of(event));
        }
        let world = &self.play.world;
        let span = 1.0 / f64::from(world.tick_rate());
        let now = world.time() + self.clock.share() * span;
        let problem = self.audio.frame(elapsed, now, self.speed(), self.paused);
        if let Some(problem) = problem {
            self.notices.fail(Topic::Sound, problem);
        }
    }
}
