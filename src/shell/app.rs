//! The game as a program: one frame as a sequence, and the loop around it. The only place that reads a clock.

use super::audio::Audio;
use super::clock::{FrameLimiter, TickClock};
use super::edits::Edit;
use super::front::Front;
use super::hud::Hud;
use super::input::{Action, Controls};
use super::loading::Loading;
use super::log::{Log, Recorder};
use super::menu::Screen;
use super::menu::prompts::Device;
use super::notices::{Notices, Topic};
use super::overlay::Overlay;
use super::overlay::scene::MeshPicture;
use super::overlay::stats::Stats;
use super::picture::Sketch;
use super::platform::Platform;
use super::play::Play;
use super::reload::{Timer, Watch};
use super::render::Renderer;
use super::runs::Feed;
use super::settings::Settings;
use super::text::{Pass, Text};
use super::{ShellError, guard, levels, liking, puppet};
use crate::anim::Rig;
use crate::cli::{Options, files};
use crate::game::Lessons;
use crate::tune::Tuning;
use sdl2::event::{Event, EventSender, WindowEvent};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

const SHADERS: &str = "shaders";
const MODELS: &str = "assets/models";
/// Time per frame without vsync by wish, and of a window that nobody looks at.
const FREE_FRAME: Duration = Duration::from_micros(4000);
const IDLE_FRAME: Duration = Duration::from_millis(33);
/// Time per frame where frames are measured.
pub(super) const MEASURED_FRAME: Duration = Duration::from_nanos(16_666_666);

/// The running game.
pub struct App {
    /// The world that is played.
    pub play: Play,
    /// What the player must be told.
    pub notices: Notices,
    /// The panels, and what is drawn over the scene.
    pub overlay: Overlay,
    /// Keys and controllers.
    pub controls: Controls,
    /// The menus, the settings, and what has been reached.
    pub front: Front,
    /// What is seen beside the world.
    pub hud: Hud,
    pub(super) lessons: Lessons,
    // The run: where its inputs come from and go to, and what it depends on beside them.
    pub(super) feed: Feed,
    pub(super) log: Arc<Log>,
    pub(super) recorder: Option<Recorder>,
    pub(super) tuning: Tuning,
    pub(super) seed: u64,
    // Time.
    pub(super) clock: TickClock,
    pub(super) paused: bool,
    pub(super) scale: f64,
    pub(super) quit: bool,
    // Files that are read again when they change, and the levels to choose from.
    pub(super) tuning_file: Watch,
    /// The player's tuning and its file, while that of a level holds.
    pub(super) own_tuning: Option<(Tuning, Watch)>,
    pub(super) level_file: Watch,
    pub(super) levels: Vec<PathBuf>,
    pub(super) loading: Option<Loading>,
    shader_files: Watch,
    hero_file: Watch,
    disk: Timer,
    // The picture. The window comes last: what draws in it is dropped before it.
    pub(super) stats: Stats,
    pub(super) mesh_pictures: [MeshPicture; 2], // of the standing and of the crouched hero
    pub(super) renderer: Renderer,
    pub(super) sketch: Sketch,
    pub(super) text: Text,
    pub(super) text_pass: Pass,
    pub(super) rig: Arc<Rig>,
    focused: bool,
    /// What is heard.
    pub audio: Audio,
    pub(super) platform: Platform,
}

impl App {
    /// Loads everything and opens the window.
    ///
    /// # Errors
    /// A file is missing or broken, or there is no window with OpenGL 3.3.
    pub fn open(options: &Options) -> Result<App, ShellError> {
        let mut start = super::runs::prepare(options)?;
        let front = liking::prepare(options, &mut start.notices);
        let platform = Platform::open(&liking::window(&front.live))?;
        let shader_files = Watch::new(&files::find(Path::new(SHADERS)));
        let mut renderer = Renderer::new(
            platform.gl.clone(),
            shader_files.path(),
            &files::find(Path::new(MODELS)),
        )?;
        renderer.set_preset(front.live.video.preset.unwrap_or_default())?;
        let text_pass = Pass::new(platform.gl.clone(), shader_files.path())?;
        let hero_file = Watch::new(&files::find(Path::new(puppet::MODEL)));
        let rig = puppet::load(hero_file.path())?;
        renderer.set_hero(&rig);
        let mut overlay = Overlay::new(&platform)?;
        overlay.open = options.overlay;
        overlay.show.mesh = options.mesh;
        let mut app = App {
            clock: TickClock::new(start.play.world.tick_rate()),
            play: start.play,
            feed: start.feed,
            log: start.log,
            recorder: start.recorder,
            tuning: start.tuning,
            tuning_file: start.tuning_file,
            own_tuning: None,
            level_file: start.level_file,
            seed: start.seed,
            notices: start.notices,
            overlay,
            controls: Controls::default(),
            front,
            hud: Hud::default(),
            lessons: Lessons::default(),
            paused: false,
            scale: 1.0,
            quit: false,
            shader_files,
            hero_file,
            rig,
            levels: levels::list(),
            loading: None,
            disk: Timer::default(),
            stats: Stats::default(),
            mesh_pictures: Default::default(),
            renderer,
            sketch: Sketch::default(),
            text: Text::new()?,
            text_pass,
            focused: true,
            audio: Audio::default(),
            platform,
        };
        if let Some(device) = options.device.and_then(Device::named) {
            app.controls.pretend(device);
        }
        guard::watch(&app.log, app.front.folder.as_deref());
        app.show_stage();
        let Settings {
            controls,
            accessibility,
            ..
        } = app.settings().clone();
        app.controls
            .set(&controls, accessibility.crouch, accessibility.moves);
        if !options.mute && options.screenshot.is_none() {
            app.open_audio();
        }
        app.open_first_menu(options);
        Ok(app)
    }

    /// The title, unless the game starts in play; then the menu that was asked for.
    fn open_first_menu(&mut self, options: &Options) {
        let asked = options.screen.and_then(Screen::named);
        match asked {
            Some(Screen::Pause) => self.open_pause(),
            Some(Screen::Results) => {
                self.front.facts.results = Some(self.results(&self.play.world.view()));
                self.open_menu(Screen::Results);
            }
            Some(screen) => {
                self.open_menu(Screen::Title);
                self.front.menu.enter(screen);
            }
            None if !options.is_direct() => self.open_menu(Screen::Title),
            None => {}
        }
    }

    /// Plays until the game is left, then writes the recording and says what the run came to.
    ///
    /// # Errors
    /// OpenGL fails, or the recording cannot be written. It is written even if the picture failed.
    pub fn run(&mut self) -> Result<(), ShellError> {
        let played = self.choose_first_preset().and_then(|()| self.play_on());
        played.and(self.finish())
    }

    /// The loop: frames, until somebody quits.
    fn play_on(&mut self) -> Result<(), ShellError> {
        let mut vsync = self.platform.vsync;
        let mut limiter = FrameLimiter::new(vsync);
        let mut last = Instant::now();
        while !self.quit {
            let now = Instant::now();
            self.frame(now - last)?;
            last = now;
            if vsync != self.platform.vsync {
                vsync = self.platform.vsync;
                limiter = FrameLimiter::new(vsync);
            }
            let (shown, wanted) = (self.platform.frame_time(), self.frame_time());
            let wait = limiter.wait(now.elapsed(), shown, wanted);
            if !wait.is_zero() {
                std::thread::sleep(wait);
            }
        }
        Ok(())
    }

    /// What is done when the game is left.
    ///
    /// # Errors
    /// The recording cannot be written.
    pub fn finish(&mut self) -> Result<(), ShellError> {
        self.save_all();
        let written = self.recorder.take().map(Recorder::write).transpose()?;
        let mut out = std::io::stdout().lock();
        let said = writeln!(out, "{}", self.play.summary).and_then(|()| match written {
            Some(text) => writeln!(out, "{text}"),
            None => Ok(()),
        });
        drop(said); // whoever was to read it may have gone
        Ok(())
    }

    /// One frame, `elapsed` after the last: input, files, ticks, picture.
    ///
    /// # Errors
    /// OpenGL fails.
    pub fn frame(&mut self, elapsed: Duration) -> Result<(), ShellError> {
        self.stats.frame.push(elapsed.as_secs_f32() * 1000.0);
        self.notices.advance(elapsed);
        if self.disk.is_due(elapsed) {
            self.reload_changed();
        }
        self.poll_events();
        self.advance_front(elapsed);
        self.advance(elapsed);
        self.play_sounds(elapsed);
        let edits = self.draw(elapsed.as_secs_f32())?;
        self.platform.window.gl_swap_window();
        edits.into_iter().for_each(|edit| self.apply(edit));
        Ok(())
    }

    /// The ticks of one frame of a sixtieth of a second, for measuring.
    pub(super) fn measured_ticks(&mut self) {
        self.poll_events();
        self.paused = false;
        self.advance_front(MEASURED_FRAME);
        self.advance(MEASURED_FRAME);
    }

    /// The picture of one frame, for measuring: so long after the one before, and no waiting for anything but that.
    ///
    /// # Errors
    /// OpenGL fails.
    pub(super) fn measured_picture(&mut self, after: Duration) -> Result<(), ShellError> {
        self.draw(after.as_secs_f32())?;
        self.platform.window.gl_swap_window();
        self.renderer.finish();
        Ok(())
    }

    /// Everything that has happened since the last frame, right before the ticks that shall react to it.
    fn poll_events(&mut self) {
        // A field that has taken the keyboard since the last frame has taken the held keys as well.
        if self.overlay.typing() {
            self.controls.release_keys();
        }
        while let Some(event) = self.platform.events.poll_event() {
            self.overlay.handle(&event);
            match &event {
                Event::Quit { .. } => self.quit = true,
                Event::Window {
                    win_event: WindowEvent::FocusLost,
                    ..
                } => self.lose_focus(),
                Event::Window {
                    win_event: WindowEvent::FocusGained,
                    ..
                } => self.focused = true,
                Event::ControllerDeviceAdded { which, .. } => self.connect(*which),
                _ => self.hand_on(&event),
            }
        }
        self.platform.take_text(self.overlay.typing());
    }

    /// An event of keys, controllers or the mouse: to the menu that is open, or to the hero.
    fn hand_on(&mut self, event: &Event) {
        if self.loading_takes(event) {
            return;
        }
        let typing = self.overlay.typing();
        let in_menu = self.front.is_open() && !typing;
        let pressed = matches!(
            event,
            Event::KeyDown { repeat: false, .. } | Event::ControllerButtonDown { .. }
        );
        if pressed && !in_menu {
            self.play.skip_fall();
        }
        if in_menu {
            self.menu_event(event);
        }
        if let Some(action) = self.controls.handle(event, typing || in_menu) {
            self.act(action);
        }
    }

    /// A controller was plugged in; SDL announces it by its place in the list of devices.
    fn connect(&mut self, index: u32) {
        if let Err(reason) = self
            .controls
            .pads()
            .connect(&self.platform.controllers, index)
        {
            self.notices.fail(Topic::Device, reason);
        }
    }

    /// Another window has the keyboard: it will get the releases of what is held now.
    fn lose_focus(&mut self) {
        self.focused = false;
        self.controls.release_all();
        self.overlay.release_all();
        self.open_pause();
    }

    /// What a key asks for depends on how things are.
    fn act(&mut self, action: Action) {
        match action {
            Action::Overlay => self.apply(Edit::Overlay(!self.overlay.open)),
            Action::Fullscreen => self.apply(Edit::Fullscreen),
            Action::Pause if self.paused => self.apply(Edit::Pause(false)),
            Action::Pause => self.open_pause(),
            Action::Hold => self.apply(Edit::Pause(!self.paused)),
            Action::Step => self.apply(Edit::Step),
            Action::Slower => self.change_speed(0.5),
            Action::Faster => self.change_speed(2.0),
        }
    }

    /// By a key, which shows nothing by itself: so it is said.
    fn change_speed(&mut self, factor: f64) {
        self.apply(Edit::Scale(self.scale * factor));
        self.notices.say(format!("Speed × {}", self.scale));
    }

    /// The ticks that are due. Asking for a restart ends a pause; the end of a replay begins one.
    pub(super) fn advance(&mut self, elapsed: Duration) {
        if self.paused && self.controls.wants_retry() {
            self.pause(false);
        }
        if self.paused || self.front.menu.root() == Some(Screen::Results) {
            return;
        }
        if self.play.is_falling() {
            self.play.fall(elapsed.as_secs_f64() * self.speed());
            return;
        }
        let due = self.clock.advance(elapsed, self.speed());
        let begin = Instant::now();
        let events = self.play.events;
        let mut done = 0;
        while done < due && !self.play.is_falling() {
            if !self.tick() {
                self.pause(true);
                break;
            }
            done += 1;
        }
        if done > 0 {
            self.stats
                .tick
                .push(begin.elapsed().as_secs_f32() * 1e6 / done as f32);
            let count = self.play.events - events;
            self.stats.events.push(count as f32 / done as f32);
        }
    }

    /// One tick; `false` if there is no input for it, since a replay is over.
    pub fn tick(&mut self) -> bool {
        let Some(input) = self.feed.next(&mut self.controls) else {
            return false;
        };
        if self.log.push(input) {
            self.tell_recording_ends("it is as long as a replay may be");
        }
        if self.speed() != 1.0 {
            self.play.world.mark();
        }
        self.play.tick(input, self.controls.look(), &self.tuning);
        self.note_tick();
        self.note_lesson(input);
        self.hear_tick();
        true
    }

    /// Whether somebody has asked to leave.
    pub fn has_quit(&self) -> bool {
        self.quit
    }

    /// A way to send events to the game as if from outside.
    pub fn event_sender(&self) -> EventSender {
        self.platform.event_sender()
    }

    /// Puts the mouse at a point of the window, as a hand would.
    pub fn move_mouse(&self, x: i32, y: i32) {
        self.platform.move_mouse(x, y);
    }

    /// Reads again what has changed on disk; what is broken says why, and the last good state goes on.
    fn reload_changed(&mut self) {
        if self.overlay.open {
            self.levels = levels::list();
        }
        if self.tuning_file.changed() {
            self.load_tuning();
        }
        // Who waits for another level does not wait for this one.
        let may_reload = self.loading.as_ref().is_none_or(Loading::is_reload);
        if may_reload && self.level_file.changed() {
            self.reload_level();
        }
        if self.hero_file.changed() {
            match puppet::load(self.hero_file.path()) {
                Ok(rig) => {
                    self.renderer.set_hero(&rig);
                    self.play.show_hero(&rig);
                    self.rig = rig;
                    self.notices.solve(Topic::Hero);
                }
                Err(error) => self.notices.fail(Topic::Hero, error),
            }
        }
        if self.shader_files.changed() {
            let reloaded = self.renderer.reload_shaders();
            match reloaded.and_then(|()| self.text_pass.reload_shaders()) {
                Ok(()) => self.notices.solve(Topic::Shaders),
                Err(error) => self.notices.fail(Topic::Shaders, error),
            }
        }
    }

    /// How often a frame is enough.
    fn frame_time(&self) -> Duration {
        match (self.focused, self.front.live.video.vsync) {
            (false, _) => IDLE_FRAME,
            (true, true) => self.capped(self.platform.frame_time()),
            (true, false) => self.capped(FREE_FRAME),
        }
    }
}
