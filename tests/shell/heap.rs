//! Nothing is allocated to show a moment: while pictures are drawn, every request for memory is noted, with where it came from.
//!
//! What is not seen here: the memory that OpenGL's driver, SDL and ImGui ask for in C; a letter's first appearance, after which
//! it stays in the picture of all letters; open menus and the open overlay; the ticks themselves; and kira, which wants a box
//! for each sound that begins.

use super::hands::{FLAT, FRAME, config_dir, frames, key, open, options};
use super::heard::each_moment;
use edgewalker::cli::{Options, Preset, Source, load};
use edgewalker::shell::app::App;
use sdl2::keyboard::Scancode;
use std::alloc::{GlobalAlloc, Layout, System};
use std::backtrace::Backtrace;
use std::cell::{Cell, RefCell};
use std::fs;
use std::path::Path;
use std::time::Duration;

/// The recorded run.
const RUN: &str = "tests/golden/quarry.replay.ron";
/// Frames that are not watched.
const WARM_UP: u32 = 60;

/// The system's allocator, which tells what is asked of it.
struct Watcher;

#[global_allocator]
static WATCHER: Watcher = Watcher;

thread_local! {
    /// Whether this thread is watched, and what it was seen to do.
    static IS_WATCHED: Cell<bool> = const { Cell::new(false) };
    static SEEN: RefCell<Vec<Backtrace>> = const { RefCell::new(Vec::new()) };
}

/// Notes who asks for memory. What that needs itself is not noted.
fn note() {
    if IS_WATCHED.replace(false) {
        SEEN.with_borrow_mut(|seen| seen.push(Backtrace::force_capture()));
        IS_WATCHED.set(true);
    }
}

// SAFETY: the system's allocator does all of it.
unsafe impl GlobalAlloc for Watcher {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        note();
        // SAFETY: the caller's promises are the system's conditions.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        note();
        // SAFETY: as above.
        unsafe { System.realloc(place, layout, size) }
    }
}

/// Does something that must not ask for memory.
fn watch<T>(act: impl FnOnce() -> T) -> T {
    IS_WATCHED.set(true);
    let done = act();
    IS_WATCHED.set(false);
    let seen = SEEN.take();
    let ours = |seen: &Backtrace| {
        let text = seen.to_string();
        let lines = text.lines().filter(|line| line.contains("edgewalker::"));
        lines.take(4).collect::<Vec<_>>().join("\n")
    };
    let first = seen.first().map(ours).unwrap_or_default();
    assert!(
        seen.is_empty(),
        "{} allocations, the first in\n{first}",
        seen.len()
    );
    done
}

/// Lets the game go on, and watches how each moment is shown once more.
fn watch_frames(app: &mut App, count: u32) {
    frames(app, WARM_UP);
    for _ in 0..count {
        app.frame(FRAME).unwrap();
        watch(|| app.frame(Duration::ZERO)).unwrap();
    }
}

/// The recorded run, with outlines, in the presets with the fewest and the most passes; then a player's, with prompts.
pub fn nothing_is_allocated_for_a_picture(_: &Path) {
    for (preset, count) in [(Preset::Low, 300), (Preset::High, 40)] {
        fs::create_dir_all(config_dir()).unwrap();
        let settings = "(version: 1, accessibility: (contrast: true))";
        fs::write(config_dir().join("settings.ron"), settings).unwrap();
        let mut app = open(&Options {
            source: Source::Replay(RUN.into()),
            preset: Some(preset),
            ..options(FLAT)
        });
        assert!(app.settings().accessibility.contrast);
        watch_frames(&mut app, count);
        fs::remove_dir_all(config_dir()).unwrap();
    }
    let mut app = open(&options("levels/quarry.ron"));
    key(&app, Scancode::D, true);
    watch_frames(&mut app, 100);
}

/// What is heard of the recorded run is decided without asking for memory.
pub fn nothing_is_allocated_for_cues(_: &Path) {
    let replay = load::replay(Path::new(RUN)).unwrap_or_else(|e| panic!("{e}"));
    let mut cues = 0;
    each_moment(Path::new(RUN), &replay, |tick, scape, moment| {
        cues += match tick < replay.tick_rate as usize {
            true => scape.tick(moment).cues.len(),
            false => watch(|| scape.tick(moment).cues.len()),
        };
    });
    assert!(cues > 1000, "{cues}");
}
