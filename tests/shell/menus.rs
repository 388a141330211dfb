//! The menus in the running game: every entry by each device alone, what is kept, and what becomes of broken files.

use super::hands::{FRAME, button, frames, has_problem, key, open, options, tap};
use super::virtual_pad::VirtualPad;
use edgewalker::cli::{Options, Preset, Source};
use edgewalker::shell::app::App;
use edgewalker::shell::menu::items::entries;
use edgewalker::shell::menu::prompts::{Device, Make};
use edgewalker::shell::menu::values::{Value, value};
use edgewalker::shell::menu::{Facts, Item, Screen};
use edgewalker::shell::notices::Topic;
use edgewalker::shell::settings::{Deed, Hold};
use sdl2::controller::Button;
use sdl2::keyboard::Scancode;
use std::fs;
use std::path::Path;
use std::time::Duration;

/// The game as players start it, with its files in a folder.
fn from_title(folder: &Path) -> Options {
    let mut options = options("");
    if let Source::Live { level, .. } = &mut options.source {
        *level = None;
    }
    Options {
        config_dir: Some(folder.join("config")),
        preset: Some(Preset::Low),
        ..options
    }
}

fn screen(app: &App) -> Option<Screen> {
    app.front.menu.screen()
}

/// A device that steps through menus.
trait Hand {
    /// Makes an entry of the open page the focused one.
    fn focus(&self, app: &mut App, index: usize);
    /// Chooses the focused entry.
    fn choose(&self, app: &mut App);
    /// Makes the focused value larger, or smaller.
    fn change(&self, app: &mut App, more: bool);
    /// Goes back a page.
    fn back(&self, app: &mut App);
}

struct Keyboard;

impl Hand for Keyboard {
    fn focus(&self, app: &mut App, index: usize) {
        while app.front.menu.focus() != index {
            let down = app.front.menu.focus() < index;
            tap(app, if down { Scancode::Down } else { Scancode::Up });
        }
    }

    fn choose(&self, app: &mut App) {
        tap(app, Scancode::Return);
    }

    fn change(&self, app: &mut App, more: bool) {
        tap(
            app,
            if more {
                Scancode::Right
            } else {
                Scancode::Left
            },
        );
    }

    fn back(&self, app: &mut App) {
        tap(app, Scancode::Escape);
    }
}

/// SDL's numbers of the buttons of a controller without a mapping of its own.
struct Pad(VirtualPad);

impl Pad {
    fn plug_in(app: &mut App) -> Pad {
        let pad = Pad(VirtualPad::plug_in());
        frames(app, 2);
        pad
    }

    fn tap(&self, app: &mut App, button: Button) {
        self.0.set(0, 0, button as i32, true);
        frames(app, 2);
        self.0.set(0, 0, button as i32, false);
        frames(app, 2);
    }
}

impl Hand for Pad {
    fn focus(&self, app: &mut App, index: usize) {
        while app.front.menu.focus() != index {
            let down = app.front.menu.focus() < index;
            self.tap(
                app,
                if down {
                    Button::DPadDown
                } else {
                    Button::DPadUp
                },
            );
        }
    }

    fn choose(&self, app: &mut App) {
        self.tap(app, Button::A);
    }

    fn change(&self, app: &mut App, more: bool) {
        let button = if more {
            Button::DPadRight
        } else {
            Button::DPadLeft
        };
        self.tap(app, button);
    }

    fn back(&self, app: &mut App) {
        self.tap(app, Button::B);
    }
}

struct Mouse;

impl Mouse {
    /// Presses and lets go at a share of the way through an entry's row, or through its value.
    fn click(app: &mut App, index: usize, of_value: bool, share: f32) {
        let row = app.front.layout().unwrap().rows[index];
        let [x, y, width, height] = if of_value { row.value } else { row.rect };
        let at = [x + width * share, y + height / 2.0].map(|c| c.round() as i32);
        app.move_mouse(at[0], at[1]);
        frames(app, 2);
        button(app, true);
        frames(app, 1);
        button(app, false);
        frames(app, 1);
    }
}

/// Left of the values and arrows of every row.
const LABEL: f32 = 0.1;

impl Hand for Mouse {
    fn focus(&self, app: &mut App, index: usize) {
        let [x, y, width, height] = app.front.layout().unwrap().rows[index].rect;
        app.move_mouse((x + width * LABEL) as i32, (y + height / 2.0) as i32);
        frames(app, 2);
        assert_eq!(app.front.menu.focus(), index);
    }

    fn choose(&self, app: &mut App) {
        Mouse::click(app, app.front.menu.focus(), false, LABEL);
    }

    fn change(&self, app: &mut App, more: bool) {
        let share = if more { 0.62 } else { 0.3 };
        Mouse::click(app, app.front.menu.focus(), true, share);
    }

    fn back(&self, app: &mut App) {
        let last = app.front.layout().unwrap().rows.len() - 1;
        Mouse::click(app, last, false, LABEL);
    }
}

fn items(app: &App) -> Vec<Item> {
    let rows = &app.front.layout().unwrap().rows;
    rows.iter().map(|row| row.item).collect()
}

fn go(hand: &dyn Hand, app: &mut App, item: Item) {
    let index = items(app).iter().position(|i| *i == item);
    hand.focus(
        app,
        index.unwrap_or_else(|| panic!("{item:?} is not on {:?}", screen(app))),
    );
    hand.choose(app);
}

/// Goes through the settings, operates each entry, and comes back.
fn walk_the_settings(hand: &dyn Hand, app: &mut App) {
    let begin = screen(app);
    go(hand, app, Item::Settings);
    for page in [Item::Video, Item::Audio, Item::Controls, Item::Access] {
        go(hand, app, page);
        for (index, item) in items(app).into_iter().enumerate() {
            // The window of the tests stays as it is.
            if matches!(
                item,
                Item::Back | Item::Size | Item::Fullscreen | Item::Vsync
            ) {
                continue;
            }
            hand.focus(app, index);
            let before = app.settings().clone();
            match value(item, &before) {
                Value::Keys => {
                    hand.choose(app);
                    assert!(app.front.menu.wait().is_some(), "{item:?}");
                    tap(app, Scancode::Escape);
                    assert!(app.front.menu.wait().is_none());
                }
                Value::None => {
                    hand.choose(app);
                    assert!(matches!(screen(app), Some(Screen::Confirm(_))), "{item:?}");
                    hand.back(app);
                }
                _ => {
                    hand.change(app, true);
                    let more = app.settings().clone();
                    hand.change(app, false);
                    assert!(before != more || more != *app.settings(), "{item:?}");
                }
            }
        }
        hand.back(app);
    }
    hand.back(app);
    assert_eq!(screen(app), begin);
}

/// From the title through every page into the game, through its pause back to the title, and out.
fn walk(hand: &dyn Hand, app: &mut App) {
    frames(app, 2);
    assert_eq!(screen(app), Some(Screen::Title));
    walk_the_settings(hand, app);
    go(hand, app, Item::Credits);
    assert_eq!(screen(app), Some(Screen::Credits));
    hand.back(app);
    go(hand, app, Item::NewGame);
    assert_eq!(screen(app), None, "in play");
    frames(app, 10);
    tap(app, Scancode::Escape);
    frames(app, 1);
    assert!(app.is_paused() && screen(app) == Some(Screen::Pause));
    walk_the_settings(hand, app);
    go(hand, app, Item::Resume);
    assert!(!app.is_paused() && screen(app).is_none());
    for item in [Item::Retry, Item::Restart] {
        tap(app, Scancode::Escape);
        frames(app, 1);
        go(hand, app, item);
        if let Some(Screen::Confirm(_)) = screen(app) {
            go(hand, app, Item::Yes);
        }
        assert!(!app.is_paused() && screen(app).is_none(), "{item:?}");
        frames(app, 2);
    }
    assert_eq!(app.play.world.view().deaths, 0, "a restart forgets them");
    tap(app, Scancode::Escape);
    frames(app, 1);
    go(hand, app, Item::ToTitle);
    assert_eq!(screen(app), Some(Screen::Title));
    assert_eq!(items(app)[0], Item::Continue);
    go(hand, app, Item::NewGame);
    assert!(
        matches!(screen(app), Some(Screen::Confirm(_))),
        "a run is under way"
    );
    hand.back(app);
    go(hand, app, Item::Continue);
    assert_eq!(screen(app), None);
    app.open_menu(Screen::Results);
    frames(app, 1);
    go(hand, app, Item::ToTitle);
    go(hand, app, Item::Quit);
    assert!(app.has_quit());
}

pub fn by_keyboard(folder: &Path) {
    walk(&Keyboard, &mut open(&from_title(folder)));
}

pub fn by_controller(folder: &Path) {
    let mut app = open(&from_title(folder));
    let pad = Pad::plug_in(&mut app);
    pad.tap(&mut app, Button::DPadDown);
    assert_eq!(app.controls.device(), Device::Pad(Make::Letters));
    pad.tap(&mut app, Button::DPadUp);
    walk(&pad, &mut app);
    // Pausing and going on by its own button, and the stick, which repeats.
    app.open_menu(Screen::Pause);
    pad.tap(&mut app, Button::Start);
    assert_eq!(screen(&app), None);
    pad.tap(&mut app, Button::Start);
    assert_eq!(screen(&app), Some(Screen::Pause));
    pad.0.set(1, i16::MAX, 0, false);
    frames(&mut app, 2);
    assert_eq!(app.front.menu.focus(), 1);
    frames(&mut app, 30);
    assert!(app.front.menu.focus() > 1, "a held stick repeats");
    pad.0.set(1, 0, 0, false);
    frames(&mut app, 2);
    tap(&mut app, Scancode::Up);
    assert_eq!(app.controls.device(), Device::Keys);
    pad.0.pull_out();
    frames(&mut app, 2);
}

pub fn by_mouse(folder: &Path) {
    walk(&Mouse, &mut open(&from_title(folder)));
}

pub fn the_title_leads_into_the_game(folder: &Path) {
    let mut app = open(&from_title(folder));
    frames(&mut app, 5);
    let tick = app.play.world.tick();
    assert!(
        tick > 0 && !app.is_paused(),
        "the scene behind the title lives"
    );
    tap(&mut app, Scancode::D);
    assert_eq!(app.play.world.view().velocity.x, 0.0, "and the hero stands");
    tap(&mut app, Scancode::Return);
    assert_eq!(screen(&app), None);
    assert!(app.play.world.tick() < 5, "a world of its own");
    key(&app, Scancode::D, true);
    frames(&mut app, 30);
    assert!(app.play.world.view().velocity.x > 0.0);
    drop(app);
    // In play at once, if a level was named.
    assert_eq!(screen(&open(&options(super::hands::FLAT))), None);
}

pub fn settings_survive_a_restart(folder: &Path) {
    let mut app = open(&from_title(folder));
    frames(&mut app, 1);
    go(&Keyboard, &mut app, Item::Settings);
    go(&Keyboard, &mut app, Item::Audio);
    let music = app.settings().audio.music;
    go(&Keyboard, &mut app, Item::Music);
    tap(&mut app, Scancode::Left);
    tap(&mut app, Scancode::Left);
    tap(&mut app, Scancode::Escape);
    go(&Keyboard, &mut app, Item::Access);
    go(&Keyboard, &mut app, Item::Crouch);
    let expected = app.settings().clone();
    assert_eq!(
        (expected.audio.music, expected.accessibility.crouch),
        (music - 10, Hold::Toggle)
    );
    frames(&mut app, 60); // saved by itself, without leaving the game
    drop(app);
    let again = open(&from_title(folder));
    assert_eq!(again.settings().audio, expected.audio);
    assert_eq!(again.settings().accessibility, expected.accessibility);
    assert!(again.notices.problems().is_empty());
}

pub fn a_run_is_gone_on_with(folder: &Path) {
    let mut app = open(&from_title(folder));
    frames(&mut app, 1);
    go(&Keyboard, &mut app, Item::NewGame);
    frames(&mut app, 60);
    tap(&mut app, Scancode::R); // back to the start: a death
    frames(&mut app, 30);
    assert_eq!(app.play.world.view().deaths, 1);
    let seconds = app.play.world.view().run_time();
    app.finish().unwrap();
    drop(app);
    let mut again = open(&from_title(folder));
    frames(&mut again, 1);
    assert_eq!(items(&again)[0], Item::Continue);
    go(&Keyboard, &mut again, Item::Continue);
    let view = again.play.world.view();
    assert!(
        view.deaths == 1 && (view.run_time() - seconds).abs() < 0.1,
        "{view:?} {seconds}"
    );
}

pub fn what_the_command_line_says_is_not_saved(folder: &Path) {
    let mut options = from_title(folder);
    options.vsync = true;
    drop(open(&options));
    options.vsync = false;
    let mut app = open(&options);
    assert!(!app.settings().video.vsync && app.front.store.settings.video.vsync);
    frames(&mut app, 1);
    go(&Keyboard, &mut app, Item::Settings);
    go(&Keyboard, &mut app, Item::Audio);
    tap(&mut app, Scancode::Left);
    app.finish().unwrap();
    drop(app);
    let text = fs::read_to_string(folder.join("config/settings.ron")).unwrap();
    assert!(
        text.contains("vsync: true") && text.contains("master: 75"),
        "{text}"
    );
    assert!(!text.contains("320"), "{text}");
}

pub fn broken_files_are_told_of(folder: &Path) {
    let config = folder.join("config");
    fs::create_dir_all(&config).unwrap();
    fs::write(config.join("settings.ron"), "(version: 1, audio: (music").unwrap();
    fs::write(config.join("progress.ron"), "(version: 99)").unwrap();
    let mut app = open(&from_title(folder));
    frames(&mut app, 2);
    assert!(has_problem(
        &app,
        Topic::Settings,
        &["settings.ron.broken-1", "version 99"]
    ));
    go(&Keyboard, &mut app, Item::NewGame);
    frames(&mut app, 10);
    app.finish().unwrap();
    let kept = fs::read_to_string(config.join("progress.ron")).unwrap();
    assert_eq!(kept, "(version: 99)");
}

pub fn keys_are_bound_by_hand(folder: &Path) {
    let mut app = open(&from_title(folder));
    frames(&mut app, 1);
    go(&Keyboard, &mut app, Item::Settings);
    go(&Keyboard, &mut app, Item::Controls);
    go(&Keyboard, &mut app, Item::Bind(Deed::Jump));
    assert!(app.front.menu.wait().is_some());
    tap(&mut app, Scancode::J);
    let keys = app.settings().controls.bindings.keys(Deed::Jump);
    assert_eq!(keys, [Some(Scancode::J), Some(Scancode::Z)]);
    for _ in 0..3 {
        tap(&mut app, Scancode::Escape);
    }
    assert_eq!(screen(&app), Some(Screen::Title));
    go(&Keyboard, &mut app, Item::NewGame);
    frames(&mut app, 30);
    let ground = app.play.world.view().position.y;
    tap(&mut app, Scancode::Space);
    assert_eq!(app.play.world.view().position.y, ground);
    tap(&mut app, Scancode::J);
    assert!(app.play.world.view().position.y > ground);
}

/// A level of which the hero is at the goal as soon as he runs: what it came to is shown, and kept from the title on.
pub fn results_at_the_goal(folder: &Path) {
    let flat = fs::read_to_string(super::hands::FLAT).unwrap();
    let goal = flat.find("goal:").unwrap();
    let rest = goal + flat[goal..].find('\n').unwrap();
    let near = format!(
        "{}goal: (min: (2, 0), max: (4, 3)),{}",
        &flat[..goal],
        &flat[rest..]
    );
    let path = folder.join("near.ron");
    fs::write(&path, near).unwrap();
    let mut app = open(&options(path.to_str().unwrap()));
    frames(&mut app, 30);
    key(&app, Scancode::D, true);
    frames(&mut app, 60);
    key(&app, Scancode::D, false);
    let won = app.play.world.view().won_at.expect("at the goal");
    assert_eq!(screen(&app), None);
    for _ in 0..100 {
        app.frame(FRAME).unwrap();
    }
    assert_eq!(screen(&app), Some(Screen::Results));
    assert!(app.play.world.time() - won > 1.5);
    go(&Keyboard, &mut app, Item::Again);
    frames(&mut app, 3);
    let view = app.play.world.view();
    assert!(screen(&app).is_none() && view.won_at.is_none() && view.run_time() < 0.2);
}

pub fn time_runs_slower_by_wish(folder: &Path) {
    let mut app = open(&from_title(folder));
    frames(&mut app, 1);
    go(&Keyboard, &mut app, Item::Settings);
    go(&Keyboard, &mut app, Item::Access);
    assert_eq!(entries(Screen::Access, &Facts::default())[0], Item::Speed);
    for _ in 0..12 {
        tap(&mut app, Scancode::Left);
    }
    assert_eq!(app.settings().accessibility.speed, 50);
    for _ in 0..2 {
        tap(&mut app, Scancode::Escape);
    }
    go(&Keyboard, &mut app, Item::NewGame);
    let tick = app.play.world.tick();
    for _ in 0..10 {
        app.frame(Duration::from_millis(100)).unwrap();
    }
    let slow = app.play.world.tick() - tick;
    assert!((59..=61).contains(&slow), "{slow}");
}
