//! Every setting: one line with its name, type, default and range. From these lines come the file, its reading and the menus.

use super::bindings::Bindings;
use super::fields::{self, Complaints, Fields};
use crate::cli::Preset;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// Version of the file.
pub const VERSION: u32 = 1;

/// Shares in percent.
pub const SHARE: RangeInclusive<u32> = 0..=100;
/// Frames a second that the picture may be held to: with fewer nobody could reach the menu that says so.
const CAPS: RangeInclusive<u32> = 20..=1000;
/// Sides of a window, in points.
const SIDES: RangeInclusive<u32> = 64..=16384;

/// A group of settings, with its default and with its reading.
macro_rules! group {
    ($(#[$doc:meta])* $name:ident {
        $($(#[$note:meta])* $field:ident: $type:ty = $default:expr $(, $range:expr)?;)+
    }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize)]
        pub struct $name { $($(#[$note])* pub $field: $type,)+ }

        impl Default for $name {
            fn default() -> Self {
                $name { $($field: $default,)+ }
            }
        }

        impl $name {
            /// Takes over what differs between two states of the group.
            fn adopt(&mut self, before: &$name, after: &$name) {
                $(if before.$field != after.$field {
                    self.$field.clone_from(&after.$field);
                })+
            }

            /// Takes over the fields of a group; complains about what is unknown or makes no sense.
            fn read(fields: Fields, group: &str, complaints: &mut Complaints) -> $name {
                let mut read = $name::default();
                for (name, raw) in fields.0 {
                    let path = format!("{group}.{name}");
                    match name.as_str() {
                        $(stringify!($field) => {
                            read.$field = fields::value(raw, &path, read.$field, complaints);
                            $(read.$field = fields::within(read.$field, &path, &$range, complaints);)?
                        })+
                        _ => complaints.push(format!("{path} is unknown and left out")),
                    }
                }
                read
            }
        }
    };
}

group! {
    /// The window and the picture.
    Video {
        /// Size of the window in points.
        size: Size = Size { width: 1280, height: 720 };
        /// The whole display.
        fullscreen: bool = false;
        /// Wait for the display.
        vsync: bool = true;
        /// How much the picture may cost; `None` until it has been measured.
        preset: Option<Preset> = None;
        /// Frames a second at most.
        frame_cap: FrameCap = FrameCap::NONE;
    }
}

group! {
    /// How loud, in percent.
    Audio {
        /// All of it.
        master: u32 = 80, SHARE;
        /// What happens.
        effects: u32 = 100, SHARE;
        /// The music.
        music: u32 = 80, SHARE;
    }
}

group! {
    /// Keys, buttons and sticks.
    Hands {
        /// What does what.
        bindings: Bindings = Bindings::default();
        /// Share of the left stick's way that counts as its middle, percent.
        move_dead_zone: u32 = 25, 5..=60;
        /// The same of the right stick.
        look_dead_zone: u32 = 25, 5..=60;
    }
}

group! {
    /// For eyes, hands and nerves.
    Access {
        /// How much the picture may shake, percent.
        shake: u32 = 100, SHARE;
        /// Bright flashes are shown.
        flashes: bool = true;
        /// How fast the game runs, percent.
        speed: u32 = 100, 50..=100;
        /// The hero and everything dangerous stand out.
        contrast: bool = false;
        /// Whether crouching lasts as long as its key is held.
        crouch: Hold = Hold::Hold;
        /// Whether running and climbing last as long as their keys are held.
        moves: Hold = Hold::Hold;
    }
}

/// What a key that is pressed for a while does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Hold {
    /// It counts while it is held.
    #[default]
    Hold,
    /// Pressed once it counts, pressed again no longer.
    Toggle,
}

/// Size of a window in points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "(u32, u32)", into = "(u32, u32)")]
pub struct Size {
    /// Across.
    pub width: u32,
    /// Down.
    pub height: u32,
}

impl TryFrom<(u32, u32)> for Size {
    type Error = String;

    fn try_from((width, height): (u32, u32)) -> Result<Size, String> {
        if SIDES.contains(&width) && SIDES.contains(&height) {
            return Ok(Size { width, height });
        }
        let (low, high) = (SIDES.start(), SIDES.end());
        Err(format!(
            "{width} by {height} is no window: sides are {low} to {high}"
        ))
    }
}

impl From<Size> for (u32, u32) {
    fn from(size: Size) -> (u32, u32) {
        (size.width, size.height)
    }
}

/// Frames a second at most; 0 in the file is no limit of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(try_from = "u32", into = "u32")]
pub struct FrameCap(u32);

impl FrameCap {
    /// No limit.
    pub const NONE: FrameCap = FrameCap(0);
    /// Those that the menu offers.
    pub const OFFERED: [FrameCap; 6] = [
        Self::NONE,
        Self(30),
        Self(60),
        Self(90),
        Self(120),
        Self(240),
    ];

    /// How many, if there is a limit.
    pub fn per_second(self) -> Option<u32> {
        (self != Self::NONE).then_some(self.0)
    }
}

impl TryFrom<u32> for FrameCap {
    type Error = String;

    fn try_from(frames: u32) -> Result<FrameCap, String> {
        if frames == 0 || CAPS.contains(&frames) {
            return Ok(FrameCap(frames));
        }
        let (low, high) = (CAPS.start(), CAPS.end());
        Err(format!(
            "{frames} frames a second are no limit: that is 0 for none, or {low} to {high}"
        ))
    }
}

impl From<FrameCap> for u32 {
    fn from(cap: FrameCap) -> u32 {
        cap.0
    }
}

/// All settings.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Settings {
    /// The window and the picture.
    pub video: Video,
    /// How loud.
    pub audio: Audio,
    /// Keys, buttons and sticks.
    pub controls: Hands,
    /// For eyes, hands and nerves.
    pub accessibility: Access,
}

impl Settings {
    /// Takes over what differs between two states.
    pub fn adopt(&mut self, before: &Settings, after: &Settings) {
        self.video.adopt(&before.video, &after.video);
        self.audio.adopt(&before.audio, &after.audio);
        self.controls.adopt(&before.controls, &after.controls);
        self.accessibility
            .adopt(&before.accessibility, &after.accessibility);
    }

    /// Takes over the groups of a file.
    pub(super) fn read(fields: Fields, complaints: &mut Complaints) -> Settings {
        let mut read = Settings::default();
        for (name, raw) in fields.0 {
            let group = || raw.into_rust::<Fields>();
            let done = match name.as_str() {
                "version" => Ok(()),
                "video" => group().map(|f| read.video = Video::read(f, &name, complaints)),
                "audio" => group().map(|f| read.audio = Audio::read(f, &name, complaints)),
                "controls" => group().map(|f| read.controls = Hands::read(f, &name, complaints)),
                "accessibility" => {
                    group().map(|f| read.accessibility = Access::read(f, &name, complaints))
                }
                _ => {
                    complaints.push(format!("{name} is unknown and left out"));
                    Ok(())
                }
            };
            if let Err(error) = done {
                complaints.push(format!("{name}: {error}; the defaults are used"));
            }
        }
        read
    }
}
