//! Runs as values: what is recorded or replayed in a window is the same without one.

use super::hands::{FLAT, frames, index_of, key, open, options, tap};
use edgewalker::cli::summary::Summary;
use edgewalker::cli::{Options, Source, headless, load};
use edgewalker::game::{Input, Replay, World};
use edgewalker::shell::edits::{Edit, Group};
use edgewalker::tune::Tuning;
use sdl2::event::Event;
use sdl2::keyboard::Scancode;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

fn recording(path: &Path) -> Options {
    let mut options = options(FLAT);
    if let Source::Live { record, .. } = &mut options.source {
        *record = Some(path.to_path_buf());
    }
    options
}

fn replaying(path: &Path) -> Options {
    Options {
        source: Source::Replay(path.to_path_buf()),
        ..options(FLAT)
    }
}

fn without_window(path: &Path) -> Summary {
    headless::play(path).unwrap_or_else(|e| panic!("{e}"))
}

pub fn a_recorded_run(folder: &Path) {
    let path = folder.join("run.replay");
    let mut app = open(&recording(&path));
    for code in [Scancode::D, Scancode::Space, Scancode::A] {
        key(&app, code, true);
        frames(&mut app, 20);
        key(&app, code, false);
        frames(&mut app, 7);
    }
    app.event_sender()
        .push_event(Event::Quit { timestamp: 0 })
        .unwrap();
    app.run().unwrap();
    let headless = without_window(&path);
    assert_eq!(headless, app.play.summary);
    assert!(headless.ticks > 100 && headless.highest > 1.0, "{headless}");
}

/// A run right and left with jumps, for ten seconds.
fn write_replay(path: &Path) -> World {
    let stage = load::stage(Path::new("levels/dev/stairs.ron")).unwrap_or_else(|e| panic!("{e}"));
    let mut replay = Replay::new("levels/dev/stairs.ron", &stage, 120, 7, &Tuning::default());
    for tick in 0..1200_u32 {
        let run = if tick % 300 < 200 { 127 } else { -90 };
        replay.push(Input {
            run,
            jump: tick % 90 < 30,
            down: tick % 200 > 180,
            up: false,
            retry: tick == 700,
            respawn: tick == 900,
        });
    }
    fs::write(path, replay.to_text()).unwrap();
    replay.run(stage).unwrap()
}

pub fn a_replay_in_a_window(folder: &Path) {
    let path: PathBuf = folder.join("run.replay");
    let expected = write_replay(&path);
    let mut app = open(&replaying(&path));
    key(&app, Scancode::D, true); // a player's keys do not touch a replay
    frames(&mut app, 590);
    assert!(!app.is_paused());
    frames(&mut app, 20);
    assert!(app.is_paused(), "a replay that is over waits");
    assert_eq!(
        (app.play.world.tick(), app.play.world.hash()),
        (1200, expected.hash())
    );
    assert_eq!(without_window(&path), app.play.summary);
}

/// The recorded run through the whole quarry, in few frames: how many there are must not matter.
pub fn the_golden_run(_: &Path) {
    let path = Path::new("tests/golden/quarry.replay.ron");
    let mut app = open(&replaying(path));
    while !app.is_paused() {
        app.frame(Duration::from_millis(250)).unwrap();
    }
    assert!(app.play.world.view().won_at.is_some());
    assert_eq!(without_window(path), app.play.summary);
}

/// A picture of a tick shows what the player would see then: not what was told long before.
pub fn a_picture_of_a_tick(folder: &Path) {
    let mut app = open(&replaying(Path::new("tests/golden/gym.replay.ron")));
    let file = folder.join("picture.png");
    app.screenshot(&file, 4500).unwrap();
    assert_eq!(
        (app.play.world.tick(), app.play.world.view().deaths),
        (4500, 1)
    );
    assert!(file.exists() && app.notices.notice().is_none());
}

/// After a replay the player may go on from its end.
pub fn going_on_after_a_replay(folder: &Path) {
    let path = folder.join("run.replay");
    write_replay(&path);
    let mut app = open(&replaying(&path));
    while !app.is_paused() {
        app.frame(Duration::from_millis(250)).unwrap();
    }
    let end = app.play.world.tick();
    tap(&mut app, Scancode::Escape);
    frames(&mut app, 10);
    assert!(!app.is_paused() && app.play.world.tick() > end);
}

/// A replay holds one tuning: what was played with another one is not in it.
pub fn a_changed_tuning_ends_the_recording(folder: &Path) {
    let path = folder.join("run.replay");
    let mut app = open(&recording(&path));
    let gravity = |value: f64| {
        let (group, index) = (Group::Motion, index_of("gravity"));
        Edit::Tune {
            group,
            index,
            value,
        }
    };
    app.apply(gravity(30.0)); // before the first tick: the run begins with it
    key(&app, Scancode::D, true);
    frames(&mut app, 30);
    let (tick, hash) = (app.play.world.tick(), app.play.world.hash());
    app.apply(gravity(20.0));
    frames(&mut app, 30);
    assert!(app.play.world.tick() > tick);
    app.finish().unwrap();
    let summary = without_window(&path);
    assert_eq!((summary.ticks, summary.hash), (tick, hash));
}

/// However many ticks a frame has to make, they are those of the run.
pub fn the_frame_rate_does_not_matter(_: &Path) {
    let path = Path::new("tests/golden/quarry.replay.ron");
    let replay = load::replay(path).unwrap_or_else(|e| panic!("{e}"));
    for milliseconds in [3, 7, 100] {
        let mut app = open(&replaying(path));
        for _ in 0..40 {
            app.frame(Duration::from_millis(milliseconds)).unwrap();
        }
        let mut world = load::replay_world(path, &replay).unwrap_or_else(|e| panic!("{e}"));
        for input in replay.iter().take(app.play.world.tick() as usize) {
            world.step(input, &replay.tuning);
        }
        let due = 40 * milliseconds * 120 / 1000;
        assert!(world.tick().abs_diff(due) <= 1, "{} {due}", world.tick());
        assert_eq!(world.hash(), app.play.world.hash());
    }
}
