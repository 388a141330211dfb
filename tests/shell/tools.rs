//! The overlay's tools, and files that change under the running game.

use super::hands::{
    FLAT, FRAME, await_level, button, click, frames, has_problem, index_of, key, open, options,
    tap, with_tuning,
};
use edgewalker::cli::Options;
use edgewalker::game::Stance;
use edgewalker::level::Skill;
use edgewalker::shell::app::App;
use edgewalker::shell::edits::{Edit, Group};
use edgewalker::shell::notices::Topic;
use edgewalker::tune::{Motion, Tuning};
use sdl2::keyboard::Scancode;
use std::fs;
use std::path::Path;
use std::time::Instant;

/// Jumps from rest with the key held; the greatest height above the ground.
pub fn jump(app: &mut App) -> f64 {
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

pub fn a_tunable_acts(_: &Path) {
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

/// Where things are in the panel of a picture of 1280 by 720.
const FILTER: (i32, i32) = (200, 624);
const FIRST_SLIDER: (i32, i32) = (177, 670);
const LEVELS: (i32, i32) = (200, 474);
const FIRST_LEVEL: (i32, i32) = (60, 498);
const BESIDE_THE_PANEL: (i32, i32) = (900, 300);

fn with_panel() -> App {
    let mut app = open(&Options {
        size: Some((1280, 720)),
        overlay: true,
        ..options(FLAT)
    });
    frames(&mut app, 3);
    app
}

pub fn a_field_takes_the_keyboard(_: &Path) {
    let mut app = with_panel();
    key(&app, Scancode::D, true);
    frames(&mut app, 10);
    assert!(app.play.world.view().velocity.x > 0.0);
    click(&mut app, FILTER);
    assert!(app.overlay.typing());
    frames(&mut app, 30);
    let there = app.play.world.view();
    assert_eq!(
        there.velocity.x, 0.0,
        "held keys are let go when a field takes the keyboard"
    );
    for code in [
        Scancode::A,
        Scancode::Space,
        Scancode::P,
        Scancode::R,
        Scancode::Period,
    ] {
        tap(&mut app, code);
        frames(&mut app, 5);
    }
    let now = app.play.world.view();
    assert_eq!((now.position, now.stance), (there.position, there.stance));
    assert!(!app.is_paused() && now.time > there.time);
    tap(&mut app, Scancode::Escape); // leaves the field, and asks the game for nothing
    frames(&mut app, 3);
    assert!(!app.overlay.typing() && !app.is_paused());
    key(&app, Scancode::A, true);
    frames(&mut app, 5);
    assert!(
        app.play.world.view().velocity.x < 0.0,
        "the keyboard is the game's again"
    );
}

pub fn a_slider_is_dragged(_: &Path) {
    let mut app = with_panel();
    let usual = app.tuning().motion.run_speed;
    app.move_mouse(FIRST_SLIDER.0, FIRST_SLIDER.1);
    frames(&mut app, 2);
    button(&app, true);
    frames(&mut app, 2);
    for step in 1..=10 {
        app.move_mouse(FIRST_SLIDER.0 + 10 * step, FIRST_SLIDER.1);
        frames(&mut app, 1);
    }
    button(&app, false);
    frames(&mut app, 2);
    let dragged = app.tuning().motion.run_speed;
    assert!(dragged > 2.0 * usual, "{usual} {dragged}");
    click(&mut app, BESIDE_THE_PANEL);
    key(&app, Scancode::D, true);
    frames(&mut app, 30);
    assert!(
        app.play.world.view().velocity.x > usual,
        "what was dragged is felt"
    );
}

pub fn tuning_is_saved_and_loaded(folder: &Path) {
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
pub fn await_reload(app: &mut App) {
    frames(app, 20);
}

pub fn a_broken_level(folder: &Path) {
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

pub fn a_broken_tuning(folder: &Path) {
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

pub fn a_broken_shader(folder: &Path) {
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

pub fn a_level_is_clicked(_: &Path) {
    let mut app = with_panel();
    click(&mut app, LEVELS);
    click(&mut app, FIRST_LEVEL);
    assert_eq!(app.play.summary.level, "The Drowned Quarry");
    assert!(app.play.world.tick() < 20, "it begins anew");
}

pub fn another_level(_: &Path) {
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

/// The tuning beside a chosen level holds while that is played, and is told of; the player's own is then as it was, and so is its
/// file, even if somebody saves meanwhile. A broken one is told of, and holds for nobody.
pub fn a_level_with_its_own_tuning(folder: &Path) {
    let (level, tuning, mine) = (
        folder.join("own.ron"),
        folder.join("own.tuning.ron"),
        folder.join("mine.ron"),
    );
    fs::copy(FLAT, &level).unwrap();
    fs::write(&tuning, "(motion: (gravity: 30.0))").unwrap();
    fs::write(&mine, "(motion: (gravity: 50.0))").unwrap();
    let mut app = open(&with_tuning(&mine));
    assert_eq!(app.tuning().motion.gravity, 50.0);
    let choose = |app: &mut App, level: &Path| {
        app.apply(Edit::OpenLevel(level.into()));
        await_level(app);
    };
    for _ in 0..2 {
        choose(&mut app, &level);
        assert_eq!(app.tuning().motion.gravity, 30.0);
        let said = app.notices.notice().map(|(words, _)| words.to_owned());
        assert!(said.is_some_and(|words| words.contains("own.tuning.ron")));
    }
    app.apply(Edit::SaveTuning);
    choose(&mut app, Path::new(FLAT));
    assert_eq!(app.tuning().motion.gravity, 50.0);
    assert_eq!(
        fs::read_to_string(&mine).unwrap(),
        "(motion: (gravity: 50.0))"
    );
    app.apply(Edit::SaveTuning);
    assert!(fs::read_to_string(&mine).unwrap().contains("50.0"));
    fs::write(&tuning, "(motion: (gravity: much))").unwrap();
    choose(&mut app, &level);
    assert!(has_problem(
        &app,
        Topic::Tuning,
        &["own.tuning.ron", "line 1"]
    ));
    assert_eq!(app.tuning().motion.gravity, 50.0);
}

/// A level tells how to crouch where it says so, until that was done once; then no level and no later start does.
pub fn a_prompt_is_gone_when_it_was_done_once(folder: &Path) {
    let level = folder.join("told.ron");
    let text = fs::read_to_string(FLAT).unwrap();
    let prompts = "prompts: [(skill: Crouch, room: (min: (-90, -9), max: (90, 9)))], features:";
    fs::write(&level, text.replace("features:", prompts)).unwrap();
    let settings = folder.join("settings");
    let options = Options {
        config_dir: Some(settings.clone()),
        ..options(&level.to_string_lossy())
    };
    let mut app = open(&options);
    frames(&mut app, 60);
    assert_eq!(app.hud.told(), None, "the first prompts are there");
    frames(&mut app, 700);
    assert_eq!(app.hud.told(), Some(Skill::Crouch));
    key(&app, Scancode::C, true);
    frames(&mut app, 60);
    key(&app, Scancode::C, false);
    frames(&mut app, 60);
    assert_eq!(app.hud.told(), None);
    app.finish().unwrap();
    drop(app);
    let mut app = open(&options);
    frames(&mut app, 760);
    assert_eq!(app.hud.told(), None, "it is remembered");
}

/// A level with so many beams across as many others that it is not there at once.
fn huge() -> String {
    let beam = |id: String, [a, b, c, d]: [f64; 4]| {
        format!("(id: \"{id}\", outline: [({a}, {b}), ({c}, {b}), ({c}, {d}), ({a}, {d})]),\n")
    };
    let ground = beam("ground".into(), [-5.0, -1.0, 5.0, 0.0]);
    let beams = (0..200).flat_map(|i| {
        let at = 20.0 + 3.0 * f64::from(i);
        let lying = beam(format!("lying {i}"), [19.0, at, 621.0, at + 0.05]);
        [
            lying,
            beam(format!("standing {i}"), [at, 19.0, at + 0.05, 621.0]),
        ]
    });
    let features: String = beams.collect();
    format!(
        "(version: 1, name: \"Huge\", start: (0, 0), goal: (min: (4, 0), max: (5, 1)), bottom: -10,\n\
         features: [\n{ground}{features}])\n"
    )
}

pub fn a_huge_level_shows_a_bar_that_can_be_left(folder: &Path) {
    let path = folder.join("huge.ron");
    fs::write(&path, huge()).unwrap();
    let mut app = open(&options(FLAT));
    frames(&mut app, 2);
    let (name, tick) = (
        app.play.world.stage().level.name.clone(),
        app.play.world.tick(),
    );
    app.apply(Edit::OpenLevel(path.clone()));
    let mut before = 0.0;
    let begin = Instant::now();
    while before < 0.2 {
        let share = app.loading().expect("it is still on its way").share();
        assert!(share >= before && begin.elapsed().as_secs() < 120);
        before = share;
        app.frame(FRAME).unwrap();
    }
    assert!(app.play.world.tick() > tick, "the game goes on meanwhile");
    key(&app, Scancode::Escape, true);
    app.frame(FRAME).unwrap();
    key(&app, Scancode::Escape, false);
    app.frame(FRAME).unwrap();
    assert!(app.loading().is_none() && !app.is_paused());
    assert!(app.notices.problems().is_empty());
    assert_eq!(app.play.world.stage().level.name, name, "nothing is lost");
    app.apply(Edit::OpenLevel(path));
    assert!(app.loading().is_some());
    await_level(&mut app);
    assert_eq!(app.play.world.stage().level.name, "Huge");
}
