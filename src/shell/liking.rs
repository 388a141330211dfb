//! Settings made to hold: at the start, when they change, and in their file.

use super::app::App;
use super::front::Front;
use super::levels;
use super::notices::{Notices, Topic};
use super::platform::WindowOptions;
use super::runs;
use super::settings::saver::Saved;
use super::settings::{Settings, Size, Store};
use crate::cli::Options;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The folder of settings and progress, within the user's folder for such things.
const FOLDER: &str = "edgewalker";

/// Everything around the game, with the settings of their files and of the command line; tells what is wrong with the files.
pub fn prepare(options: &Options, notices: &mut Notices) -> Front {
    let folder = folder(options).unwrap_or_else(|reason| {
        notices.fail(Topic::Settings, reason);
        None
    });
    let (store, said) = Store::open(folder.as_deref());
    if !said.is_empty() {
        notices.fail(Topic::Settings, said.join("\n"));
    }
    let live = overridden(&store.settings, options);
    let levels = levels::for_players(Path::new(runs::LEVEL));
    Front::new(store, folder, live, levels)
}

/// Where settings are kept. A picture is the same for everybody: it is taken with the usual settings, unless a folder is named.
fn folder(options: &Options) -> Result<Option<PathBuf>, String> {
    if options.config_dir.is_some() || options.screenshot.is_some() {
        return Ok(options.config_dir.clone());
    }
    let folder = sdl2::filesystem::pref_path("", FOLDER);
    let failed = |e| format!("no folder to keep settings in: {e}");
    folder.map(|path| Some(path.into())).map_err(failed)
}

/// The settings that hold for this run.
fn overridden(saved: &Settings, options: &Options) -> Settings {
    let mut live = saved.clone();
    if let Some((width, height)) = options.size {
        live.video.size = Size { width, height };
    }
    live.video.fullscreen |= options.fullscreen;
    live.video.vsync &= options.vsync;
    live.video.preset = options.preset.or(live.video.preset);
    live
}

/// The window that settings ask for.
pub fn window(settings: &Settings) -> WindowOptions {
    let video = &settings.video;
    WindowOptions {
        size: Some(video.size.into()),
        fullscreen: video.fullscreen,
        vsync: video.vsync,
    }
}

impl App {
    /// The settings as they hold now.
    pub fn settings(&self) -> &Settings {
        &self.front.live
    }

    /// Makes everything hold that differs from before. What the system refuses is told.
    pub(super) fn apply_settings(&mut self, before: &Settings) {
        let Settings {
            video,
            audio,
            controls,
            ..
        } = self.front.live.clone();
        let mut result = Ok(());
        if video.fullscreen != before.video.fullscreen {
            result = self.platform.set_fullscreen(video.fullscreen);
        }
        if video.size != before.video.size && !video.fullscreen {
            result = result.and(self.platform.resize(video.size.width, video.size.height));
        }
        if video.vsync != before.video.vsync {
            self.platform.set_vsync(video.vsync);
        }
        if video.preset != before.video.preset {
            let preset = self.renderer.set_preset(video.preset.unwrap_or_default());
            result = result.and(preset.map_err(|e| e.to_string()));
        }
        let holds = |settings: &Settings| {
            let access = &settings.accessibility;
            (access.crouch, access.moves)
        };
        let (crouch, moves) = holds(&self.front.live);
        if controls != before.controls || (crouch, moves) != holds(before) {
            self.controls.set(&controls, crouch, moves);
        }
        if audio != before.audio {
            self.apply_volumes();
        }
        if let Err(reason) = result {
            self.notices.say(reason);
        }
    }

    /// By its key: as if it had been chosen in the settings.
    pub(super) fn toggle_fullscreen(&mut self) {
        let before = self.front.live.clone();
        self.front.live.video.fullscreen ^= true;
        self.adopt(&before);
    }

    /// How often a frame is enough, by the settings.
    pub(super) fn capped(&self, frame: Duration) -> Duration {
        match self.front.live.video.frame_cap.per_second() {
            None => frame,
            Some(cap) => frame.max(Duration::from_secs(1) / cap),
        }
    }

    /// How fast time runs, as a share of real time.
    pub(super) fn speed(&self) -> f64 {
        self.scale * f64::from(self.front.live.accessibility.speed) / 100.0
    }

    /// Writes the settings now; what fails is told.
    pub(super) fn save_settings(&mut self) {
        self.front.unsaved = None;
        match self.front.store.save_settings() {
            Ok(()) => {
                self.notices.solve(Topic::Settings);
                self.notices.solve(Topic::Unsaved);
            }
            Err(error) => self.notices.fail(Topic::Unsaved, error),
        }
    }

    /// Begins to write what has been reached.
    pub(super) fn save_progress(&mut self) {
        self.front.store.save_progress();
    }

    /// What became of a save, if there is news.
    pub(super) fn tell_saved(&mut self, news: Option<Saved>) {
        match news {
            Some(Ok(())) => self.notices.solve(Topic::Progress),
            Some(Err(error)) => self.notices.fail(Topic::Progress, error),
            None => {}
        }
    }

    /// What is not saved yet is saved when the game is left.
    pub(super) fn save_all(&mut self) {
        if self.front.unsaved.is_some() {
            self.save_settings();
        }
        self.keep_run();
        let news = self.front.store.settle();
        self.tell_saved(news);
    }
}
