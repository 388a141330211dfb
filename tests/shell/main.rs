//! The program with its window, on SDL's offscreen driver: events go in as from outside, values are looked at.
//!
//! SDL and ImGui allow one context per process, so these tests share one and run one after another.

mod devices;
mod hands;
mod menus;
mod runs;
mod tools;
mod virtual_pad;

use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

const DRIVER: (&str, &str) = ("SDL_VIDEODRIVER", "offscreen");
/// Offscreen windows never have the focus, without which SDL drops the events of controllers.
const PADS: (&str, &str) = ("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1");

type Test = (&'static str, fn(&Path));

const TESTS: &[Test] = &[
    ("keys move the hero", devices::keys_move_the_hero),
    ("a stall is dropped", devices::a_stall_is_dropped),
    ("losing the focus pauses", devices::losing_the_focus_pauses),
    ("pause, step, speed", devices::pause_step_speed),
    ("a fall is told", devices::a_fall_is_told),
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
    ("another level", tools::another_level),
    ("a level is clicked", tools::a_level_is_clicked),
];

/// The driver is chosen by the environment of a fresh process; in there the tests run in order.
fn main() -> ExitCode {
    let is_set = |(name, value)| std::env::var(name).as_deref() == Ok(value);
    if !(is_set(DRIVER) && is_set(PADS)) {
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
