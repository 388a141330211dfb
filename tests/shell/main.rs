//! The program with its window, on SDL's offscreen driver: events go in as from outside, values are looked at.
//!
//! SDL and ImGui allow one context per process, so these tests share one and run one after another.

mod devices;
mod hands;
mod heap;
#[path = "../common/heard.rs"]
mod heard;
mod menus;
mod runs;
mod sound;
mod tools;
mod virtual_pad;

use std::ffi::OsString;
use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

const DRIVER: (&str, &str) = ("SDL_VIDEODRIVER", "offscreen");
/// Offscreen windows never have the focus, without which SDL drops the events of controllers.
const PADS: (&str, &str) = ("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1");

/// What would be heard is written to a file.
const SOUND: (&str, &str) = ("SDL_AUDIODRIVER", "disk");
/// The test that needs a process without a sound device.
const DEAF: &str = "without a sound device";

type Test = (&'static str, fn(&Path));

const TESTS: &[Test] = &[
    ("keys move the hero", devices::keys_move_the_hero),
    (
        "what is held when a menu closes leads the hero",
        devices::what_is_held_when_a_menu_closes_leads_the_hero,
    ),
    ("a stall is dropped", devices::a_stall_is_dropped),
    ("losing the focus pauses", devices::losing_the_focus_pauses),
    ("pause, step, speed", devices::pause_step_speed),
    ("a fall is told", devices::a_fall_is_told),
    (
        "a death is seen, and a key goes on",
        devices::a_death_is_seen_and_a_key_goes_on,
    ),
    (
        "the overlay opens, and a tunable acts",
        tools::a_tunable_acts,
    ),
    (
        "a field takes the keyboard, and gives it back",
        tools::a_field_takes_the_keyboard,
    ),
    ("a slider is dragged", tools::a_slider_is_dragged),
    (
        "tuning is saved and loaded",
        tools::tuning_is_saved_and_loaded,
    ),
    (
        "a broken level goes on with the last good one",
        tools::a_broken_level,
    ),
    (
        "a broken tuning goes on with the last good one",
        tools::a_broken_tuning,
    ),
    (
        "a broken shader goes on with the last good one",
        tools::a_broken_shader,
    ),
    (
        "a controller comes and goes",
        devices::a_controller_comes_and_goes,
    ),
    (
        "a recorded run is the same without a window",
        runs::a_recorded_run,
    ),
    (
        "a replay in a window is the same as without",
        runs::a_replay_in_a_window,
    ),
    (
        "the golden run is the same in a window",
        runs::the_golden_run,
    ),
    (
        "the frame rate does not matter",
        runs::the_frame_rate_does_not_matter,
    ),
    (
        "a picture of a tick shows what is seen then",
        runs::a_picture_of_a_tick,
    ),
    ("going on after a replay", runs::going_on_after_a_replay),
    (
        "a changed tuning ends the recording",
        runs::a_changed_tuning_ends_the_recording,
    ),
    (
        "the title leads into the game",
        menus::the_title_leads_into_the_game,
    ),
    ("menus by keyboard alone", menus::by_keyboard),
    ("menus by controller alone", menus::by_controller),
    ("menus by mouse alone", menus::by_mouse),
    (
        "settings survive a restart",
        menus::settings_survive_a_restart,
    ),
    ("a run is gone on with", menus::a_run_is_gone_on_with),
    (
        "what the command line says is not saved",
        menus::what_the_command_line_says_is_not_saved,
    ),
    ("broken files are told of", menus::broken_files_are_told_of),
    ("keys are bound by hand", menus::keys_are_bound_by_hand),
    ("results at the goal", menus::results_at_the_goal),
    ("time runs slower by wish", menus::time_runs_slower_by_wish),
    (
        "nothing is allocated for a picture",
        heap::nothing_is_allocated_for_a_picture,
    ),
    (
        "nothing is allocated for cues",
        heap::nothing_is_allocated_for_cues,
    ),
    ("another level", tools::another_level),
    (
        "a huge level shows a bar that can be left",
        tools::a_huge_level_shows_a_bar_that_can_be_left,
    ),
    ("a level is clicked", tools::a_level_is_clicked),
    (
        "a level with its own tuning",
        tools::a_level_with_its_own_tuning,
    ),
    (
        "a prompt is gone when it was done once",
        tools::a_prompt_is_gone_when_it_was_done_once,
    ),
    ("a run is heard", sound::a_run_is_heard),
    (
        "volumes of nothing are silent",
        sound::volumes_of_nothing_are_silent,
    ),
    (DEAF, sound::without_a_device),
];

/// The drivers are chosen by the environment of a fresh process; in there the tests run in order. One without a sound device
/// follows.
fn main() -> ExitCode {
    let is_set = |(name, value)| std::env::var(name).as_deref() == Ok(value);
    if [DRIVER, PADS, SOUND].into_iter().all(is_set) {
        run_tests();
        return ExitCode::SUCCESS;
    }
    let file = std::env::temp_dir().join(format!("edgewalker-sound-{}.raw", std::process::id()));
    let done = again(&file, std::env::args_os().skip(1).collect())
        && again(Path::new(sound::NOWHERE), vec![DEAF.into()]);
    drop(fs::remove_file(file)); // if no test has sounded, there is none
    if done {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// This program again, with the drivers, and a file to write sound to; whether all went well.
fn again(file: &Path, args: Vec<OsString>) -> bool {
    Command::new(std::env::current_exe().unwrap())
        .args(args)
        .envs([DRIVER, PADS, SOUND])
        .env(sound::FILE_VARIABLE, file)
        .status()
        .unwrap()
        .success()
}

fn run_tests() {
    let is_deaf = std::env::var(sound::FILE_VARIABLE).as_deref() == Ok(sound::NOWHERE);
    let wanted = std::env::args()
        .skip(1)
        .find(|arg| !arg.starts_with('-'))
        .unwrap_or_default();
    let folder = std::env::temp_dir().join(format!("edgewalker-shell-{}", std::process::id()));
    let tests = TESTS.iter().filter(|(name, _)| name.contains(&wanted));
    for (name, test) in tests.filter(|(name, _)| (*name == DEAF) == is_deaf) {
        fs::create_dir_all(&folder).unwrap();
        print!("test {name} ... ");
        test(&folder);
        println!("ok");
        fs::remove_dir_all(&folder).unwrap();
    }
}
