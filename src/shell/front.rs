//! The menus in the running game: what reaches them, and what they show.

use super::app::App;
use super::games::Seen;
use super::hud;
use super::levels::Choice;
use super::menu::devices::{Navigator, pressed};
use super::menu::layout::Layout;
use super::menu::prompts::Device;
use super::menu::values::{self, Value};
use super::menu::view::{self, Look};
use super::menu::{Command, Facts, Menu, MenuEvent, Nav, Screen};
use super::runs::Feed;
use super::settings::progress::Record;
use super::settings::{Settings, Store};
use crate::game::View;
use sdl2::event::Event;
use sdl2::mouse::MouseButton;
use std::path::PathBuf;
use std::time::Duration;

/// Time from a change of a setting to its being saved: a slider that is dragged is saved once.
const SETTLE: Duration = Duration::from_millis(600);

/// Everything around the game.
pub struct Front {
    /// The menus.
    pub menu: Menu,
    /// What happened in them in this frame, for the sounds.
    pub heard: Vec<MenuEvent>,
    /// What is saved.
    pub store: Store,
    /// Where that is; `None`: nowhere.
    pub(super) folder: Option<PathBuf>,
    /// The settings as they hold now, with what the command line says for this run.
    pub(super) live: Settings,
    pub(super) facts: Facts,
    pub(super) levels: Vec<Choice>,
    /// The level whose run is kept, by its name in the file; `None`: this run leaves no traces.
    pub(super) kept: Option<String>,
    /// What the kept run had come to when it was last looked at.
    pub(super) seen: Seen,
    /// Time since the run was kept.
    pub(super) since_kept: Duration,
    navigator: Navigator,
    look: Look,
    layout: Option<Layout>,
    pointer: [f32; 2],
    drags: bool,
    pub(super) unsaved: Option<Duration>,
    /// Seconds since the game was started, for what moves behind the title.
    pub(super) clock: f64,
}

impl Front {
    /// With the settings that are saved, and those that hold for this run.
    pub fn new(
        store: Store,
        folder: Option<PathBuf>,
        live: Settings,
        levels: Vec<Choice>,
    ) -> Front {
        let facts = Facts {
            has_run: store.progress.unfinished().is_some(),
            levels: levels.iter().map(|level| level.name.clone()).collect(),
            ..Facts::default()
        };
        Front {
            menu: Menu::default(),
            heard: Vec::new(),
            store,
            folder,
            live,
            facts,
            levels,
            kept: None,
            seen: Seen::default(),
            since_kept: Duration::ZERO,
            navigator: Navigator::default(),
            look: Look::default(),
            layout: None,
            pointer: [-1.0; 2],
            drags: false,
            unsaved: None,
            clock: 0.0,
        }
    }

    /// What is played from now on is no run to be kept.
    pub(super) fn leave_run(&mut self) {
        (self.kept, self.seen) = (None, Seen::default());
    }

    /// A menu is open.
    pub fn is_open(&self) -> bool {
        self.menu.screen().is_some()
    }

    /// The title is the page under all others.
    pub fn is_title(&self) -> bool {
        self.menu.root() == Some(Screen::Title)
    }

    /// Where the open page's entries are, as they were drawn last.
    pub fn layout(&self) -> Option<&Layout> {
        self.layout.as_ref()
    }
}

impl App {
    /// Opens a menu; the hero is let go of.
    pub fn open_menu(&mut self, screen: Screen) {
        self.controls.set_aside();
        self.front.navigator.clear();
        let progress = &self.front.store.progress;
        self.front.facts.has_run = progress.unfinished().is_some();
        let record = |level: &Choice| progress.levels.get(&level.key).map(Record::in_a_line);
        let records = self.front.levels.iter().map(record);
        self.front.facts.records = records.map(Option::unwrap_or_default).collect();
        self.front.menu.open(screen);
    }

    pub(super) fn close_menu(&mut self) {
        self.front.menu.close();
        self.front.navigator.clear();
        self.controls.take_back();
    }

    /// The pause menu, unless something else is open.
    pub(super) fn open_pause(&mut self) {
        if !self.front.is_open() {
            self.pause(true);
            self.front.facts.paused_run = self.paused_run();
            self.open_menu(Screen::Pause);
        }
    }

    /// An event while a menu is open.
    pub(super) fn menu_event(&mut self, event: &Event) {
        if self.front.menu.wait().is_some() {
            self.await_key(event);
            return;
        }
        let is_start = matches!(event, Event::ControllerButtonDown { button, .. }
            if *button == sdl2::controller::Button::Start);
        if is_start && self.front.menu.root() == Some(Screen::Pause) {
            return self.command(Command::Resume);
        }
        match event {
            Event::MouseButtonDown { mouse_btn, .. } if !self.overlay.takes_mouse() => {
                match mouse_btn {
                    MouseButton::Left => self.click(),
                    MouseButton::Right => self.nav(Nav::Back),
                    _ => {}
                }
            }
            Event::MouseButtonUp { .. } => self.front.drags = false,
            Event::MouseWheel { y, .. } if *y != 0 && !self.overlay.takes_mouse() => {
                self.nav(if *y > 0 { Nav::Up } else { Nav::Down });
            }
            _ => {
                let keys = &self.front.live.controls.bindings;
                if let Some(nav) = self.front.navigator.handle(event, keys) {
                    self.nav(nav);
                }
            }
        }
    }

    /// A key or button for what was chosen in the controls' table.
    fn await_key(&mut self, event: &Event) {
        match pressed(event) {
            Some(Some(input)) => self.with_settings(|menu, settings, _| {
                menu.give(input, settings);
                None
            }),
            Some(None) => self.nav(Nav::Back), // a menu that waits takes anything for an end of it
            None => {}
        }
    }

    /// Does what a player wants of the open menu.
    pub(super) fn nav(&mut self, nav: Nav) {
        self.with_settings(|menu, settings, facts| menu.act(nav, settings, facts));
    }

    /// Lets the menu change the settings, then makes what has changed hold.
    fn with_settings(
        &mut self,
        act: impl FnOnce(&mut Menu, &mut Settings, &Facts) -> Option<Command>,
    ) {
        let Front {
            menu,
            live,
            facts,
            heard,
            ..
        } = &mut self.front;
        let before = live.clone();
        let command = act(menu, live, facts);
        heard.extend(menu.take_events());
        self.adopt(&before);
        if let Some(command) = command {
            self.command(command);
        }
    }

    /// What differs from before was chosen by the player: it holds now, and it is saved.
    pub(super) fn adopt(&mut self, before: &Settings) {
        let Front { live, store, .. } = &mut self.front;
        if live == before {
            return;
        }
        store.settings.adopt(before, live);
        self.front.unsaved = Some(Duration::ZERO);
        self.apply_settings(before);
    }

    /// The mouse: what it points at, and what it drags.
    fn point(&mut self) {
        let mouse = self.platform.mouse();
        let moved = mouse != self.front.pointer;
        self.front.pointer = mouse;
        if !moved || self.overlay.takes_mouse() {
            return;
        }
        let Some(layout) = &self.front.layout else {
            return;
        };
        if self.front.drags {
            if let Some(row) = layout.rows.get(self.front.menu.focus()) {
                let share = layout.share(row, mouse[0]);
                self.nav(Nav::Share(share));
            }
        } else if self.controls.device() == Device::Keys
            && self.front.menu.wait().is_none()
            && let Some(nav) = layout.under(mouse)
        {
            self.nav(nav);
        }
    }

    /// The left mouse button, where the mouse is.
    fn click(&mut self) {
        self.point();
        let Front {
            layout,
            live,
            pointer,
            ..
        } = &self.front;
        let Some((layout, nav)) = layout.as_ref().and_then(|l| Some((l, l.under(*pointer)?)))
        else {
            return;
        };
        let Nav::Point(index, _) = nav else { return };
        let item = layout.rows[index].item;
        let value = values::value(item, live);
        let wanted = layout.click(index, &value, *pointer);
        self.front.drags = matches!((&value, wanted), (Value::Scale(..), Nav::Share(_)));
        self.nav(nav);
        self.nav(wanted);
    }

    /// Lets time pass for everything around the game.
    pub(super) fn advance_front(&mut self, elapsed: Duration) {
        self.front.clock += elapsed.as_secs_f64();
        self.look_for_level();
        self.hud
            .advance(elapsed.as_secs_f32(), &self.play.world.view());
        let lesson = self.lesson();
        self.hud.teach(elapsed.as_secs_f32(), lesson);
        if self.front.is_open() {
            self.front.menu.advance(elapsed.as_secs_f32());
            self.point();
            if let Some(nav) = self.front.navigator.advance(elapsed) {
                self.nav(nav);
            }
        } else {
            self.look_for_goal();
        }
        self.keep_run_at_times(elapsed);
        let news = self.front.store.saved();
        self.tell_saved(news);
        if let Some(since) = &mut self.front.unsaved {
            *since += elapsed;
            if *since >= SETTLE {
                self.save_settings();
            }
        }
    }

    /// Fills the page of text: display, problems, menus.
    pub(super) fn write_page(&mut self, view: &View, elapsed: f32, covered: f32) {
        self.text.begin(self.platform.pixels());
        let flashes = self.front.live.accessibility.flashes;
        self.hud.veil(&mut self.text, flashes);
        if !self.front.is_open() {
            let over = self.feed.is_over().then_some("The replay is over");
            let held = over.or(Some("Time stands still"));
            let scene = hud::Scene {
                world: &self.play.world,
                view,
                notices: &self.notices,
                bindings: &self.front.live.controls.bindings,
                device: self.controls.device(),
                held: held.filter(|_| self.paused && !self.overlay.open),
                is_shown_only: !matches!(self.feed, Feed::Player) || self.overlay.open,
                covered,
            };
            self.hud.draw(&mut self.text, &scene);
        }
        let scene = view::Scene {
            menu: &self.front.menu,
            settings: &self.front.live,
            facts: &self.front.facts,
            device: self.controls.device(),
            elapsed,
        };
        self.front.layout = self.front.look.draw(&mut self.text, &scene);
        if !self.overlay.open {
            hud::Hud::problems(&mut self.text, &self.notices);
        }
        if let Some(loading) = &self.loading {
            loading.draw(&mut self.text, self.controls.device());
        }
    }
}
