//! What the tests do with an open game: start it, press keys, let frames pass, look.

use edgewalker::cli::{Options, Source};
use edgewalker::shell::app::App;
use edgewalker::shell::notices::Topic;
use edgewalker::tune::Motion;
use sdl2::event::Event;
use sdl2::keyboard::{Mod, Scancode};
use sdl2::mouse::MouseButton;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// A sixtieth of a second.
pub const FRAME: Duration = Duration::from_nanos(16_666_667);
/// Longer than any level takes, however busy the machine is.
const LONGEST_LOAD: Duration = Duration::from_secs(120);
/// Even ground between two walls.
pub const FLAT: &str = "levels/dev/flat.ron";

/// Where these tests keep settings: not in the folder of whoever runs them.
pub fn config_dir() -> PathBuf {
    std::env::temp_dir().join(format!("edgewalker-config-{}", std::process::id()))
}

pub fn options(level: &str) -> Options {
    Options {
        source: Source::Live {
            level: Some(level.into()),
            tuning: None,
            tick_rate: 120,
            seed: 0,
            record: None,
        },
        screenshot: None,
        size: Some((320, 200)),
        fullscreen: false,
        vsync: false,
        preset: None,
        config_dir: Some(config_dir()),
        screen: None,
        device: None,
        film: None,
        bench_frames: None,
        overlay: false,
        mesh: false,
        mute: true,
    }
}

pub fn open(options: &Options) -> App {
    App::open(options).unwrap_or_else(|e| panic!("{e}"))
}

pub fn frames(app: &mut App, count: u32) {
    for _ in 0..count {
        app.frame(FRAME).unwrap();
        await_level(app);
    }
}

/// Waits for a level that is on its way; no time passes in the game.
pub fn await_level(app: &mut App) {
    let begin = Instant::now();
    while app.loading().is_some() {
        assert!(begin.elapsed() < LONGEST_LOAD, "a level is still not there");
        std::thread::sleep(Duration::from_millis(2));
        app.frame(Duration::ZERO).unwrap();
    }
}

pub fn key(app: &App, code: Scancode, down: bool) {
    let (timestamp, window_id, keycode, keymod) = (0, 0, None, Mod::NOMOD);
    let (scancode, repeat) = (Some(code), false);
    let event = if down {
        Event::KeyDown {
            timestamp,
            window_id,
            keycode,
            scancode,
            keymod,
            repeat,
        }
    } else {
        Event::KeyUp {
            timestamp,
            window_id,
            keycode,
            scancode,
            keymod,
            repeat,
        }
    };
    app.event_sender().push_event(event).unwrap();
}

pub fn tap(app: &mut App, code: Scancode) {
    key(app, code, true);
    frames(app, 1);
    key(app, code, false);
    frames(app, 1);
}

pub fn with_tuning(path: &Path) -> Options {
    let mut options = options(FLAT);
    if let Source::Live { tuning, .. } = &mut options.source {
        *tuning = Some(path.to_path_buf());
    }
    options
}

pub fn index_of(name: &str) -> usize {
    Motion::META
        .iter()
        .position(|meta| meta.name == name)
        .unwrap()
}

pub fn has_problem(app: &App, topic: Topic, words: &[&str]) -> bool {
    let problem = app.notices.problems().iter().find(|(t, _)| *t == topic);
    problem.is_some_and(|(_, text)| words.iter().all(|word| text.contains(word)))
}

/// Presses the left mouse button, or lets it go.
pub fn button(app: &App, down: bool) {
    let (timestamp, window_id, which, mouse_btn) = (0, 0, 0, MouseButton::Left);
    let (clicks, x, y) = (1, 0, 0); // where the mouse is counts, not where the event says it was
    let event = if down {
        Event::MouseButtonDown {
            timestamp,
            window_id,
            which,
            mouse_btn,
            clicks,
            x,
            y,
        }
    } else {
        Event::MouseButtonUp {
            timestamp,
            window_id,
            which,
            mouse_btn,
            clicks,
            x,
            y,
        }
    };
    app.event_sender().push_event(event).unwrap();
}

/// Clicks at a point, with the frames that a hand would take.
pub fn click(app: &mut App, (x, y): (i32, i32)) {
    app.move_mouse(x, y);
    frames(app, 2);
    button(app, true);
    frames(app, 2);
    button(app, false);
    frames(app, 2);
}
