//! The program with its window, on SDL's offscreen driver: events go in as from outside, values are looked at.
//!
//! SDL and ImGui allow one context per process, so these tests share one and run one after another.

mod virtual_pad;

use edgewalker::cli::{Options, Source, load};
use edgewalker::game::{Input, Replay, Stance, World};
use edgewalker::shell::app::App;
use edgewalker::shell::edits::{Edit, Group};
use edgewalker::shell::notices::Topic;
use edgewalker::tune::{Motion, Tuning};
use sdl2::event::{Event, WindowEvent};
use sdl2::keyboard::{Mod, Scancode};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Duration;
use virtual_pad::VirtualPad;

const DRIVER: (&str, &str) = ("SDL_VIDEODRIVER", "offscreen");
/// Offscreen windows never have the focus, without which SDL drops the events of controllers.
const PADS: (&str, &str) = ("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1");
const FRAME: Duration = Duration::from_nanos(16_666_667);
const FLAT: &str = "levels/dev/flat.ron";

type Test = (&'static str, fn(&Path));

const TESTS: &[Test] = &[
    ("keys move the hero", keys_move_the_hero),
    ("a stall is dropped", a_stall_is_dropped),
    ("losing the focus pauses", losing_the_focus_pauses),
    ("pause, step, speed", pause_step_speed),
    ("the overlay opens, and a tunable acts", a_tunable_acts),
    ("tuning is saved and loaded", tuning_is_saved_and_loaded),
    (
        "a broken level goes on with the last good one",
        a_broken_level,
    ),
    (
        "a broken tuning goes on with the last good one",
        a_broken_tuning,
    ),
    (
        "a broken shader goes on with the last good one",
        a_broken_shader,
    ),
    ("a controller comes and goes", a_controller_comes_and_goes),
    (
        "a recorded run is the same without a window",
        a_recorded_run,
    ),
    (
        "a replay in a window is the same as without",
        a_replay_in_a_window,
    ),
    ("another level", another_level),
];

/// The driver is chosen by the environment of a fresh process; in there the tests run in order.
fn main() -> ExitCode {
    if std::env::var(DRIVER.0).as_deref() != Ok(DRIVER.1) {
        let again = Command::new(std::env::current_exe().unwrap())
            .args(std::env::args_os().skip(1))
            .envs([DRIVER, PADS])
            .status();
        return if again.unwrap().success() {
            ExitCode::SUCCESS
        } else {
            ExitCode::FAILURE
        };
    }
    let wanted = std::env::args()
        .skip(1)
        .find(|arg| !arg.starts_with('-'))
        .unwrap_or_default();
    let folder = std::env::temp_dir().join(format!("edgewalker-shell-{}", std::process::id()));
    for (name, test) in TESTS.iter().filter(|(name, _)| name.contains(&wanted)) {
        fs::create_dir_all(&folder).unwrap();
        print!("test {name} ... ");
        test(&folder);
        println!("ok");
        fs::remove_dir_all(&folder).unwrap();
    }
    ExitCode::SUCCESS
}

fn options(level: &str) -> Options {
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
        overlay: false,
        mesh: false,
    }
}

fn open(options: &Options) -> App {
    App::open(options).unwrap_or_else(|e| panic!("{e}"))
}

fn frames(app: &mut App, count: u32) {
    for _ in 0..count {
        app.frame(FRAME).unwrap();
    }
}

fn key(app: &App, code: Scancode, down: bool) {
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

fn tap(app: &mut App, code: Scancode) {
    key(app, code, true);
    frames(app, 1);
    key(app, code, false);
    frames(app, 1);
}

fn keys_move_the_hero(_: &Path) {
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

fn a_stall_is_dropped(_: &Path) {
    let mut app = open(&options(FLAT));
    app.frame(Duration::from_secs(600)).unwrap();
    assert_eq!(app.play.world.tick(), 30);
}

fn losing_the_focus_pauses(_: &Path) {
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

fn pause_step_speed(_: &Path) {
    let mut app = open(&options(FLAT));
    tap(&mut app, Scancode::P);
    let tick = app.play.world.tick();
    tap(&mut app, Scancode::Period);
    assert_eq!(app.play.world.tick(), tick + 1);
    tap(&mut app, Scancode::P);
    let tick = app.play.world.tick();
    app.apply(Edit::Scale(0.25));
    frames(&mut app, 60);
    let slow = app.play.world.tick() - tick;
    assert!((29..=31).contains(&slow), "{slow}");
}

/// Jumps from rest with the key held; the greatest height above the ground.
fn jump(app: &mut App) -> f64 {
    let ground = app.play.world.view().position.y;
    key(app, Scancode::Space, true);
    let mut top = 0.0_f64;
    for _ in 0..240 {
        frames(app, 1);
        top = top.max(app.play.world.view().position.y - ground);
    }
    key(app, Scancode::Space, false);
    frames(app, 2);
    assert_eq!(app.play.world.view().stance, Stance::Ground);
    top
}

fn index_of(name: &str) -> usize {
    Motion::META
        .iter()
        .position(|meta| meta.name == name)
        .unwrap()
}

fn a_tunable_acts(_: &Path) {
    let mut app = open(&options(FLAT));
    frames(&mut app, 30);
    tap(&mut app, Scancode::F1);
    assert!(app.overlay.open);
    app.overlay.show.mesh = true;
    let usual = jump(&mut app);
    app.apply(Edit::Tune {
        group: Group::Motion,
        index: index_of("jump_speed"),
        value: 20.0,
    });
    let higher = jump(&mut app);
    let (g, v) = (Motion::default().gravity, Motion::default().jump_speed);
    let gain = (20.0 * 20.0 - v * v) / (2.0 * g);
    assert!(
        (higher - usual - gain).abs() < 0.02,
        "{usual} {higher} {gain}"
    );
    app.apply(Edit::Tune {
        group: Group::Motion,
        index: index_of("jump_speed"),
        value: 1e300,
    });
    assert_eq!(
        app.tuning().motion.jump_speed,
        Motion::META[index_of("jump_speed")].max
    );
    app.apply(Edit::Tune {
        group: Group::Motion,
        index: index_of("jump_speed"),
        value: f64::NAN,
    });
    assert!(app.tuning().check().is_ok());
    app.apply(Edit::ResetTuning);
    assert_eq!(*app.tuning(), Tuning::default());
    tap(&mut app, Scancode::F1);
    assert!(!app.overlay.open);
}

fn with_tuning(path: &Path) -> Options {
    let mut options = options(FLAT);
    if let Source::Live { tuning, .. } = &mut options.source {
        *tuning = Some(path.to_path_buf());
    }
    options
}

fn tuning_is_saved_and_loaded(folder: &Path) {
    let path = folder.join("tuning.ron");
    fs::write(&path, "()").unwrap();
    let mut app = open(&with_tuning(&path));
    app.apply(Edit::Tune {
        group: Group::Motion,
        index: index_of("gravity"),
        value: 33.125,
    });
    app.apply(Edit::SaveTuning);
    app.apply(Edit::ResetTuning);
    app.apply(Edit::LoadTuning);
    assert_eq!(app.tuning().motion.gravity, 33.125);
    drop(app);
    assert_eq!(open(&with_tuning(&path)).tuning().motion.gravity, 33.125);
}

/// Frames enough for a look at the disk.
fn await_reload(app: &mut App) {
    frames(app, 20);
}

fn has_problem(app: &App, topic: Topic, words: &[&str]) -> bool {
    let problem = app.notices.problems().iter().find(|(t, _)| *t == topic);
    problem.is_some_and(|(_, text)| words.iter().all(|word| text.contains(word)))
}

fn a_broken_level(folder: &Path) {
    let path = folder.join("level.ron");
    let good = fs::read_to_string(FLAT).unwrap();
    fs::write(&path, &good).unwrap();
    let mut app = open(&options(path.to_str().unwrap()));
    key(&app, Scancode::D, true);
    frames(&mut app, 30);
    key(&app, Scancode::D, false);
    let there = app.play.world.view().position;
    fs::write(&path, &good[..good.len() / 2]).unwrap();
    let tick = app.play.world.tick();
    await_reload(&mut app);
    assert!(
        has_problem(&app, Topic::Level, &["level.ron"]),
        "{:?}",
        app.notices
    );
    assert!(app.play.world.tick() > tick);
    fs::write(&path, good.replace("name: \"", "name: \"New ")).unwrap();
    await_reload(&mut app);
    assert!(app.notices.problems().is_empty(), "{:?}", app.notices);
    assert!(app.play.world.stage().level.name.starts_with("New "));
    assert!(
        app.play.world.view().position.x >= there.x,
        "the hero stays where he is"
    );
}

fn a_broken_tuning(folder: &Path) {
    let path = folder.join("tuning.ron");
    fs::write(&path, "(motion: (gravity: 30.0))").unwrap();
    let mut app = open(&with_tuning(&path));
    fs::write(&path, "(motion: (gravity: -1.0))").unwrap();
    await_reload(&mut app);
    assert!(
        has_problem(&app, Topic::Tuning, &["tuning.ron", "line 1", "gravity"]),
        "{:?}",
        app.notices
    );
    assert_eq!(app.tuning().motion.gravity, 30.0);
    fs::write(&path, "(motion: (gravity: 25.0))").unwrap();
    await_reload(&mut app);
    assert!(app.notices.problems().is_empty());
    assert_eq!(app.tuning().motion.gravity, 25.0);
}

fn a_broken_shader(folder: &Path) {
    let home = std::env::current_dir().unwrap();
    let shaders = folder.join("shaders");
    fs::create_dir_all(&shaders).unwrap();
    for entry in fs::read_dir("shaders").unwrap() {
        let path = entry.unwrap().path();
        fs::copy(&path, shaders.join(path.file_name().unwrap())).unwrap();
    }
    let level = home.join(FLAT);
    std::env::set_current_dir(folder).unwrap(); // where shaders are looked for first
    let mut app = open(&options(level.to_str().unwrap()));
    std::env::set_current_dir(&home).unwrap();
    let good = fs::read_to_string("shaders/sky.frag").unwrap();
    // Where the game looks is a path from the folder that it was started in.
    std::env::set_current_dir(folder).unwrap();
    fs::write(
        shaders.join("sky.frag"),
        format!("{good}\nthis is no shader\n"),
    )
    .unwrap();
    await_reload(&mut app);
    assert!(
        has_problem(&app, Topic::Shaders, &["sky.frag"]),
        "{:?}",
        app.notices
    );
    fs::write(shaders.join("sky.frag"), &good).unwrap();
    await_reload(&mut app);
    assert!(app.notices.problems().is_empty(), "{:?}", app.notices);
    std::env::set_current_dir(&home).unwrap();
}

fn a_controller_comes_and_goes(_: &Path) {
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

fn a_recorded_run(folder: &Path) {
    let path = folder.join("run.replay");
    let mut options = options(FLAT);
    if let Source::Live { record, .. } = &mut options.source {
        *record = Some(path.clone());
    }
    let mut app = open(&options);
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
    let headless = edgewalker::cli::headless::play(&path).unwrap_or_else(|e| panic!("{e}"));
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
            retry: tick == 700,
        });
    }
    fs::write(path, replay.to_text()).unwrap();
    replay.run(stage).unwrap()
}

fn a_replay_in_a_window(folder: &Path) {
    let path: PathBuf = folder.join("run.replay");
    let expected = write_replay(&path);
    let mut app = open(&Options {
        source: Source::Replay(path.clone()),
        ..options(FLAT)
    });
    key(&app, Scancode::D, true); // a player's keys do not touch a replay
    frames(&mut app, 590);
    assert!(!app.is_paused());
    frames(&mut app, 20);
    assert!(app.is_paused(), "a replay that is over waits");
    assert_eq!(
        (app.play.world.tick(), app.play.world.hash()),
        (1200, expected.hash())
    );
    assert_eq!(
        edgewalker::cli::headless::play(&path).unwrap_or_else(|e| panic!("{e}")),
        app.play.summary
    );
}

fn another_level(_: &Path) {
    let mut app = open(&options(FLAT));
    frames(&mut app, 10);
    app.apply(Edit::OpenLevel("levels/dev/slopes.ron".into()));
    frames(&mut app, 10);
    assert!(app.notices.problems().is_empty(), "{:?}", app.notices);
    assert!(app.play.world.tick() <= 21);
    app.apply(Edit::OpenLevel("levels/dev/no-such.ron".into()));
    frames(&mut app, 1);
    assert!(has_problem(&app, Topic::Level, &["no-such.ron"]));
}
