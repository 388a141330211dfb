//! What stands on each screen: the entries in their order, their names and notes.

use super::Facts;
use crate::shell::settings::Deed;

/// A page of the menus.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Screen {
    /// The first that players see.
    Title,
    /// Which level to play.
    Levels,
    /// Time stands still.
    Pause,
    /// The goal is reached.
    Results,
    /// Which settings.
    Settings,
    /// Window and picture.
    Video,
    /// Volumes.
    Audio,
    /// Keys and buttons.
    Controls,
    /// For eyes, hands and nerves.
    Access,
    /// Who made what.
    Credits,
    /// Whether it is meant.
    Confirm(Question),
}

/// What is asked before something is lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    /// Give up the run under way for a new one, in the level of this number.
    NewGame(usize),
    /// Give up the run under way and begin it again.
    Restart,
    /// All keys and buttons as they were.
    ResetControls,
}

/// An entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Item {
    /// Go on with the run that was left.
    Continue,
    /// Begin a run.
    NewGame,
    /// To the settings.
    Settings,
    /// To the credits.
    Credits,
    /// Leave the game.
    Quit,
    /// Play a level, by its number.
    Level(usize),
    /// Go on.
    Resume,
    /// Back to the last checkpoint.
    Retry,
    /// Back to the start, for a new run.
    Restart,
    /// To the title.
    ToTitle,
    /// The same level once more.
    Again,
    /// To the video settings.
    Video,
    /// To the audio settings.
    Audio,
    /// To the controls.
    Controls,
    /// To the accessibility settings.
    Access,
    /// Size of the window.
    Size,
    /// The whole display.
    Fullscreen,
    /// Wait for the display.
    Vsync,
    /// How much the picture may cost.
    Preset,
    /// Frames a second.
    FrameCap,
    /// Volume of all.
    Master,
    /// Volume of what happens.
    Effects,
    /// Volume of the music.
    Music,
    /// Keys and button of a deed.
    Bind(Deed),
    /// The left stick's middle.
    MoveDeadZone,
    /// The right stick's middle.
    LookDeadZone,
    /// All keys and buttons as they were.
    ResetControls,
    /// How much the picture shakes.
    Shake,
    /// Bright flashes.
    Flashes,
    /// How fast the game runs.
    Speed,
    /// The hero and dangers stand out.
    Contrast,
    /// Crouching by holding or by pressing.
    Crouch,
    /// Running and climbing by holding or by pressing.
    Moves,
    /// It is meant.
    Yes,
    /// Back to the page before.
    Back,
}

/// The entries of a screen, from the top down.
pub fn entries(screen: Screen, facts: &Facts) -> Vec<Item> {
    use Item as I;
    match screen {
        Screen::Title => {
            let mut items = vec![I::Continue, I::NewGame, I::Settings, I::Credits, I::Quit];
            items.retain(|item| facts.has_run || *item != I::Continue);
            items
        }
        Screen::Levels => (0..facts.levels.len())
            .map(I::Level)
            .chain([I::Back])
            .collect(),
        Screen::Pause => vec![
            I::Resume,
            I::Retry,
            I::Restart,
            I::Settings,
            I::ToTitle,
            I::Quit,
        ],
        Screen::Results => vec![I::Again, I::ToTitle],
        Screen::Settings => vec![I::Video, I::Audio, I::Controls, I::Access, I::Back],
        Screen::Video => vec![
            I::Size,
            I::Fullscreen,
            I::Vsync,
            I::FrameCap,
            I::Preset,
            I::Back,
        ],
        Screen::Audio => vec![I::Master, I::Effects, I::Music, I::Back],
        Screen::Controls => {
            let rest = [
                I::MoveDeadZone,
                I::LookDeadZone,
                I::Crouch,
                I::ResetControls,
                I::Back,
            ];
            Deed::ALL.into_iter().map(I::Bind).chain(rest).collect()
        }
        Screen::Access => vec![
            I::Speed,
            I::Contrast,
            I::Shake,
            I::Flashes,
            I::Crouch,
            I::Moves,
            I::Back,
        ],
        Screen::Credits => vec![I::Back],
        Screen::Confirm(_) => vec![I::Yes, I::Back],
    }
}

impl Screen {
    /// What stands over it.
    pub fn heading(self) -> &'static str {
        match self {
            Screen::Title => "Edgewalker",
            Screen::Levels => "Choose a level",
            Screen::Pause => "Paused",
            Screen::Results => "Goal reached",
            Screen::Settings => "Settings",
            Screen::Video => "Video",
            Screen::Audio => "Audio",
            Screen::Controls => "Controls",
            Screen::Access => "Accessibility",
            Screen::Credits => "Credits",
            Screen::Confirm(Question::NewGame(_)) => "Begin anew?",
            Screen::Confirm(Question::Restart) => "Back to the start?",
            Screen::Confirm(Question::ResetControls) => "Reset the controls?",
        }
    }

    /// What is said below the heading.
    pub fn preface(self) -> Option<&'static str> {
        match self {
            Screen::Confirm(Question::NewGame(_)) => Some("The run that is under way is given up."),
            Screen::Confirm(Question::Restart) => {
                Some("Checkpoints, secrets and the clock of this run are given up.")
            }
            Screen::Confirm(Question::ResetControls) => {
                Some("All keys, buttons and dead zones become what they were.")
            }
            _ => None,
        }
    }

    /// By its name on the command line, one of [`SCREENS`](crate::cli::SCREENS).
    pub fn named(name: &str) -> Option<Screen> {
        Some(match name {
            "title" => Screen::Title,
            "levels" => Screen::Levels,
            "pause" => Screen::Pause,
            "results" => Screen::Results,
            "settings" => Screen::Settings,
            "video" => Screen::Video,
            "audio" => Screen::Audio,
            "controls" => Screen::Controls,
            "accessibility" => Screen::Access,
            "credits" => Screen::Credits,
            "confirm" => Screen::Confirm(Question::Restart),
            _ => return None,
        })
    }
}

impl Item {
    /// Its name; a level has that of the level.
    pub fn label(self) -> &'static str {
        match self {
            Item::Continue => "Continue",
            Item::NewGame => "New game",
            Item::Settings => "Settings",
            Item::Credits => "Credits",
            Item::Quit => "Quit",
            Item::Level(_) => "Level",
            Item::Resume => "Resume",
            Item::Retry => "Back to the checkpoint",
            Item::Restart => "Start over",
            Item::ToTitle => "Title screen",
            Item::Again => "Once more",
            Item::Video => "Video",
            Item::Audio => "Audio",
            Item::Controls => "Controls",
            Item::Access => "Accessibility",
            Item::Size => "Window size",
            Item::Fullscreen => "Fullscreen",
            Item::Vsync => "Vertical sync",
            Item::Preset => "Picture",
            Item::FrameCap => "Frame limit",
            Item::Master => "Overall",
            Item::Effects => "Effects",
            Item::Music => "Music",
            Item::Bind(deed) => deed.label(),
            Item::MoveDeadZone => "Left stick, dead zone",
            Item::LookDeadZone => "Right stick, dead zone",
            Item::ResetControls => "Reset the controls",
            Item::Shake => "Camera shake",
            Item::Flashes => "Flashes",
            Item::Speed => "Game speed",
            Item::Contrast => "High contrast",
            Item::Crouch => "Crouching",
            Item::Moves => "Running and climbing",
            Item::Yes => "Yes",
            Item::Back => "Back",
        }
    }

    /// A sentence about it, for those to whom the name says too little.
    pub fn note(self) -> &'static str {
        match self {
            Item::Size => "Size of the window when it does not fill the display.",
            Item::Fullscreen => "The picture fills the whole display.",
            Item::Vsync => "Frames wait for the display: no tearing.",
            Item::FrameCap => "Fewer frames a second keep the machine cool and quiet.",
            Item::Preset => "Low runs without a graphics card. High wants a good one.",
            Item::Master => "All sound and music together.",
            Item::Effects => "Steps, wind, water, machines.",
            Item::Music => "The music that follows the place.",
            Item::Bind(_) => "Choose, then press a key or a button. What is bound twice is marked.",
            Item::MoveDeadZone => "How far the left stick must be pushed before the hero runs.",
            Item::LookDeadZone => "How far the right stick must be pushed before the camera looks.",
            Item::Crouch => {
                "Held as long as the key is, or pressed once to go down and once to stand up."
            }
            Item::Moves => "Held, or pressed once to go and once to stop. Sticks are always held.",
            Item::ResetControls => "All keys, buttons and dead zones as they were.",
            Item::Shake => "How much hard landings shake the picture.",
            Item::Flashes => {
                "A death lights the picture up for a moment; without flashes it darkens it."
            }
            Item::Speed => "Everything moves more slowly, and nothing else changes.",
            Item::Contrast => "Bright outlines around the hero and everything deadly.",
            _ => "",
        }
    }
}
