//! What entries show and how they change the settings.

use super::items::Item;
use crate::cli::Preset;
use crate::shell::settings::{FrameCap, Hands, Hold, Settings, Size};
use std::ops::RangeInclusive;

/// Sizes of windows that are offered.
const SIZES: [(u32, u32); 7] = [
    (960, 540),
    (1280, 720),
    (1366, 768),
    (1600, 900),
    (1920, 1080),
    (2560, 1440),
    (3840, 2160),
];
/// Percent by which a step moves a slider.
const STEP: u32 = 5;

/// What an entry shows beside its name.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Nothing: it does something.
    None,
    /// One of several words.
    Choice(String),
    /// On or off.
    Switch(bool),
    /// A number on a scale, and the scale's ends.
    Scale(u32, RangeInclusive<u32>),
    /// Keys and a button.
    Keys,
}

/// What an entry shows.
pub fn value(item: Item, settings: &Settings) -> Value {
    let Settings {
        video,
        accessibility: access,
        ..
    } = settings;
    if let Some((number, range)) = scale(item, &mut settings.clone()) {
        return Value::Scale(*number, range);
    }
    match item {
        Item::Size => Value::Choice(format!("{} × {}", video.size.width, video.size.height)),
        Item::FrameCap => Value::Choice(match video.frame_cap.per_second() {
            None => "None".into(),
            Some(cap) => format!("{cap} per second"),
        }),
        Item::Preset => Value::Choice(match video.preset {
            None => "Automatic".into(),
            Some(preset) => format!("{preset:?}"),
        }),
        Item::Crouch => held(access.crouch),
        Item::Moves => held(access.moves),
        Item::Bind(_) => Value::Keys,
        _ => switch(item, &mut settings.clone()).map_or(Value::None, |on| Value::Switch(*on)),
    }
}

/// How a key counts, in a word.
fn held(hold: Hold) -> Value {
    Value::Choice(match hold {
        Hold::Hold => "Hold".into(),
        Hold::Toggle => "Press".into(),
    })
}

/// Moves an entry's value by one step, up or down; whether it has changed. Choices go round.
pub fn step(item: Item, settings: &mut Settings, up: bool) -> bool {
    let before = settings.clone();
    if let Some((number, range)) = scale(item, settings) {
        let moved = if up {
            *number + STEP
        } else {
            number.saturating_sub(STEP)
        };
        *number = moved.clamp(*range.start(), *range.end());
    } else if let Some(on) = switch(item, settings) {
        *on = !*on;
    }
    match item {
        Item::Size => step_size(&mut settings.video.size, up),
        Item::FrameCap => {
            settings.video.frame_cap = next(&FrameCap::OFFERED, settings.video.frame_cap, up);
        }
        Item::Preset => {
            let now = settings.video.preset.unwrap_or_default();
            settings.video.preset = Some(next(&Preset::ALL, now, up));
        }
        Item::Crouch | Item::Moves => {
            let access = &mut settings.accessibility;
            let hold = match item {
                Item::Crouch => &mut access.crouch,
                _ => &mut access.moves,
            };
            *hold = next(&[Hold::Hold, Hold::Toggle], *hold, up);
        }
        _ => {}
    }
    *settings != before
}

/// Puts an entry's value at a share, 0 to 1, of its scale, on the nearest step; whether it has changed.
pub fn set_share(item: Item, settings: &mut Settings, share: f32) -> bool {
    let Some((number, range)) = scale(item, settings) else {
        return false;
    };
    let (low, high) = (*range.start(), *range.end());
    let wanted = low as f32 + share.clamp(0.0, 1.0) * (high - low) as f32;
    let steps = (wanted / STEP as f32).round() as u32;
    let before = std::mem::replace(number, (steps * STEP).clamp(low, high));
    *number != before
}

/// Everything that the controls' reset sets back.
pub fn reset_controls(settings: &mut Settings) {
    settings.controls = Hands::default();
}

fn scale(item: Item, settings: &mut Settings) -> Option<(&mut u32, RangeInclusive<u32>)> {
    let Settings {
        audio,
        controls,
        accessibility: access,
        ..
    } = settings;
    Some(match item {
        Item::Master => (&mut audio.master, 0..=100),
        Item::Effects => (&mut audio.effects, 0..=100),
        Item::Music => (&mut audio.music, 0..=100),
        Item::MoveDeadZone => (&mut controls.move_dead_zone, 5..=60),
        Item::LookDeadZone => (&mut controls.look_dead_zone, 5..=60),
        Item::Shake => (&mut access.shake, 0..=100),
        Item::Speed => (&mut access.speed, 50..=100),
        _ => return None,
    })
}

fn switch(item: Item, settings: &mut Settings) -> Option<&mut bool> {
    Some(match item {
        Item::Fullscreen => &mut settings.video.fullscreen,
        Item::Vsync => &mut settings.video.vsync,
        Item::Flashes => &mut settings.accessibility.flashes,
        Item::Contrast => &mut settings.accessibility.contrast,
        _ => return None,
    })
}

/// The neighbour of a value in a list, round its ends; the first if it is not in it.
fn next<T: Copy + PartialEq>(list: &[T], now: T, up: bool) -> T {
    let Some(place) = list.iter().position(|value| *value == now) else {
        return list[0];
    };
    let step = if up { 1 } else { list.len() - 1 };
    list[(place + step) % list.len()]
}

/// The next larger or smaller of the sizes that are offered, round the ends.
fn step_size(size: &mut Size, up: bool) {
    let now = (size.width, size.height);
    let found = match up {
        true => SIZES.iter().find(|s| **s > now).unwrap_or(&SIZES[0]),
        false => SIZES
            .iter()
            .rev()
            .find(|s| **s < now)
            .unwrap_or(&SIZES[SIZES.len() - 1]),
    };
    (size.width, size.height) = *found;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_go_round_and_scales_end() {
        let mut settings = Settings::default();
        for item in [
            Item::Size,
            Item::FrameCap,
            Item::Preset,
            Item::Crouch,
            Item::Moves,
            Item::Fullscreen,
        ] {
            let mut seen = vec![value(item, &settings)];
            while step(item, &mut settings, true) && !seen.contains(&value(item, &settings)) {
                seen.push(value(item, &settings));
            }
            assert!(seen.len() > 1, "{item:?} goes round");
        }
        let steps = (0..100)
            .filter(|_| step(Item::Speed, &mut settings, false))
            .count();
        assert_eq!((steps, settings.accessibility.speed), (10, 50));
        assert!(!step(Item::Quit, &mut settings, true));
    }

    #[test]
    fn a_share_of_a_scale_falls_on_a_step() {
        let mut settings = Settings::default();
        assert!(set_share(Item::Music, &mut settings, 0.337));
        assert_eq!(settings.audio.music, 35);
        assert!(set_share(Item::Speed, &mut settings, 2.0) || settings.accessibility.speed == 100);
        set_share(Item::MoveDeadZone, &mut settings, -1.0);
        assert_eq!(settings.controls.move_dead_zone, 5);
    }

    #[test]
    fn a_size_of_its_own_is_left_for_the_next_one_offered() {
        let mut size = Size {
            width: 1300,
            height: 700,
        };
        step_size(&mut size, true);
        assert_eq!(
            size,
            Size {
                width: 1366,
                height: 768
            }
        );
        step_size(&mut size, false);
        assert_eq!(
            size,
            Size {
                width: 1280,
                height: 720
            }
        );
    }
}
