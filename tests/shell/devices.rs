//! Keys, controllers, focus and time.

use super::hands::{FLAT, frames, key, open, options, tap};
use super::virtual_pad::VirtualPad;
use edgewalker::game::{Input, Stance};
use edgewalker::shell::app::App;
use edgewalker::shell::edits::Edit;
use sdl2::event::{Event, WindowEvent};
use sdl2::keyboard::Scancode;
use std::fs;
use std::path::Path;
use std::time::Duration;

pub fn keys_move_the_hero(_: &Path) {
    let mut app = open(&options(FLAT));
    frames(&mut app, 10);
    let start = app.play.world.view().position;
    key(&app, Scancode::D, true);
    frames(&mut app, 1);
    assert!(
        app.play.world.view().velocity.x > 0.0,
        "a key acts in the frame that sees it"
    );
    frames(&mut app, 29);
    let there = app.play.world.view().position;
    assert!(
        there.x > start.x + 2.0 && there.y == start.y,
        "{start} {there}"
    );
    key(&app, Scancode::D, false);
    frames(&mut app, 30);
    assert_eq!(app.play.world.view().velocity.x, 0.0);
    tap(&mut app, Scancode::Space);
    assert_eq!(app.play.world.view().stance, Stance::Air);
    frames(&mut app, 120);
    assert_eq!(app.play.world.view().stance, Stance::Ground);
    tap(&mut app, Scancode::R);
    assert_eq!(app.play.world.view().position.x, start.x);
}

/// Held keys and a stick that is pushed while a menu is open, as by a player who waits for a level to begin.
pub fn what_is_held_when_a_menu_closes_leads_the_hero(_: &Path) {
    let mut app = open(&options(FLAT));
    let runs = |app: &App| app.play.world.view().velocity.x;
    frames(&mut app, 10);
    tap(&mut app, Scancode::Escape);
    assert!(app.front.is_open());
    for code in [Scancode::D, Scancode::Space] {
        key(&app, code, true);
        frames(&mut app, 2);
    }
    assert!(!app.front.is_open(), "Space resumes");
    frames(&mut app, 10);
    let view = app.play.world.view();
    assert!(view.velocity.x > 4.0, "D was held: {}", view.velocity);
    assert_eq!(view.stance, Stance::Ground, "Space was not for him");
    // What is held when a menu opens goes on when it closes, unless it was let go of meanwhile.
    tap(&mut app, Scancode::Escape);
    tap(&mut app, Scancode::Escape);
    frames(&mut app, 10);
    assert!(runs(&app) > 4.0, "{}", runs(&app));
    tap(&mut app, Scancode::Escape);
    key(&app, Scancode::D, false);
    frames(&mut app, 1);
    tap(&mut app, Scancode::Escape);
    frames(&mut app, 20);
    assert_eq!(runs(&app), 0.0);
    let pad = VirtualPad::plug_in();
    frames(&mut app, 2);
    tap(&mut app, Scancode::Escape);
    pad.set(0, i16::MAX, 0, false);
    frames(&mut app, 2);
    tap(&mut app, Scancode::Escape);
    frames(&mut app, 10);
    assert!(runs(&app) > 4.0, "the stick was pushed: {}", runs(&app));
    pad.pull_out();
    frames(&mut app, 20);
    assert_eq!(runs(&app), 0.0, "a pad that is gone holds nothing");
}

pub fn a_stall_is_dropped(_: &Path) {
    let mut app = open(&options(FLAT));
    app.frame(Duration::from_secs(600)).unwrap();
    assert_eq!(app.play.world.tick(), 30);
}

pub fn losing_the_focus_pauses(_: &Path) {
    let mut app = open(&options(FLAT));
    key(&app, Scancode::D, true);
    frames(&mut app, 5);
    let lost = Event::Window {
        timestamp: 0,
        window_id: 1,
        win_event: WindowEvent::FocusLost,
    };
    app.event_sender().push_event(lost).unwrap();
    frames(&mut app, 1);
    let tick = app.play.world.tick();
    frames(&mut app, 10);
    assert!(app.is_paused() && app.play.world.tick() == tick);
    tap(&mut app, Scancode::Escape);
    assert!(!app.is_paused());
    assert_eq!(
        app.controls.take(),
        Input::default(),
        "held keys were let go"
    );
}

pub fn pause_step_speed(_: &Path) {
    let mut app = open(&options(FLAT));
    tap(&mut app, Scancode::P);
    let tick = app.play.world.tick();
    tap(&mut app, Scancode::Period);
    assert_eq!(app.play.world.tick(), tick + 1);
    tap(&mut app, Scancode::P);
    tap(&mut app, Scancode::LeftBracket);
    assert_eq!(notice(&app), Some("Speed × 0.5"));
    tap(&mut app, Scancode::LeftBracket);
    let tick = app.play.world.tick();
    frames(&mut app, 60);
    let slow = app.play.world.tick() - tick;
    assert!((29..=31).contains(&slow), "{slow}");
}

fn notice(app: &App) -> Option<&str> {
    app.notices.notice().map(|(text, _)| text)
}

pub fn a_fall_is_told(folder: &Path) {
    let path = folder.join("pit.ron");
    let flat = fs::read_to_string(FLAT).unwrap();
    let pit = flat.replacen("start: (0, 0)", "start: (-16, 0)", 1); // beside all ground
    assert_ne!(pit, flat);
    fs::write(&path, pit).unwrap();
    let mut app = open(&options(FLAT));
    frames(&mut app, 5);
    assert_eq!(notice(&app), None);
    app.apply(Edit::OpenLevel(path));
    frames(&mut app, 10);
    assert_eq!(notice(&app), None, "falling");
    frames(&mut app, 60);
    assert_eq!(notice(&app), Some("Back at the start"));
}

pub fn a_controller_comes_and_goes(_: &Path) {
    let mut app = open(&options(FLAT));
    frames(&mut app, 5);
    assert_eq!(app.controls.pads().count(), 0);
    let pad = VirtualPad::plug_in();
    frames(&mut app, 2);
    assert_eq!(app.controls.pads().count(), 1);
    let start = app.play.world.view().position;
    pad.set(0, i16::MAX, 0, false);
    frames(&mut app, 30);
    assert!(app.play.world.view().position.x > start.x + 2.0);
    pad.set(0, i16::MAX, 0, true);
    frames(&mut app, 3);
    assert_eq!(app.play.world.view().stance, Stance::Air);
    pad.set(0, 3000, 0, false);
    frames(&mut app, 120);
    assert_eq!(
        app.play.world.view().velocity.x,
        0.0,
        "within the dead zone"
    );
    pad.set(0, i16::MIN, 0, false);
    frames(&mut app, 5);
    assert!(app.play.world.view().velocity.x < 0.0);
    pad.pull_out();
    frames(&mut app, 60);
    assert_eq!(app.controls.pads().count(), 0);
    assert_eq!(
        app.play.world.view().velocity.x,
        0.0,
        "a controller that is gone holds nothing"
    );
}

/// Frames until the world goes on after a death.
fn frames_of_a_death(app: &mut App) -> u32 {
    let deaths = app.play.world.view().deaths;
    while app.play.world.view().deaths == deaths {
        frames(app, 1);
    }
    let died = app.play.world.tick();
    let waited = (0..100).take_while(|_| {
        frames(app, 1);
        app.play.world.tick() == died
    });
    waited.count() as u32
}

/// He is seen going down for a moment. No time passes meanwhile, though a key is held, and pressing one ends it.
pub fn a_death_is_seen_and_a_key_goes_on(folder: &Path) {
    let thorns = fs::read_to_string(FLAT).unwrap().replace(
        "    features: [",
        "    features: [(id: \"thorns\", kind: Hazard, outline: [(2, 0), (3, 0), (3, 1), (2, 1)]),",
    );
    let level = folder.join("thorns.ron");
    fs::write(&level, thorns).unwrap();
    let mut app = open(&options(level.to_str().unwrap()));
    key(&app, Scancode::D, true);
    let seconds = frames_of_a_death(&mut app) as f32 / 60.0;
    assert!((0.25..0.4).contains(&seconds), "{seconds} s");
    // The next one is cut short: the press counts, too.
    let deaths = app.play.world.view().deaths;
    while app.play.world.view().deaths == deaths {
        frames(&mut app, 1);
    }
    assert!(app.play.is_falling());
    frames(&mut app, 3);
    assert!(app.play.is_falling());
    key(&app, Scancode::Space, true);
    frames(&mut app, 2);
    assert!(!app.play.is_falling());
    assert_eq!(
        app.play.world.view().stance,
        Stance::Air,
        "he jumps at once"
    );
    // Who asks to come back waits for nothing.
    key(&app, Scancode::R, true);
    frames(&mut app, 1);
    assert!(app.play.world.view().deaths == deaths + 2 && !app.play.is_falling());
}
