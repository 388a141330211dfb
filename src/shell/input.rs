//! From keys and game controllers to what the simulation reads once per tick.
//!
//! Held keys are remembered here from events, never polled: so a tap between two ticks is not lost, and whoever
//! takes the keyboard away (a text field, another window) can have all of them let go.

use super::pads::Pads;
use crate::game::Input;
use sdl2::event::Event;
use sdl2::keyboard::{Mod, Scancode};

/// What the game can be asked for beside the hero's input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// Open or close the overlay.
    Overlay,
    /// Into fullscreen or out of it.
    Fullscreen,
    /// Pause, or go on.
    Pause,
    /// One tick, paused.
    Step,
    /// Half as fast.
    Slower,
    /// Twice as fast.
    Faster,
    /// Leave, if paused.
    Quit,
}

/// What a key does to the hero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Held {
    Left,
    Right,
    Up,
    Down,
    Jump,
    Retry,
}

/// Keys by their place on the keyboard, so that they lie the same on every layout.
const HERO_KEYS: &[(Scancode, Held)] = &[
    (Scancode::Left, Held::Left),
    (Scancode::A, Held::Left),
    (Scancode::Right, Held::Right),
    (Scancode::D, Held::Right),
    (Scancode::Up, Held::Up),
    (Scancode::W, Held::Up),
    (Scancode::Down, Held::Down),
    (Scancode::S, Held::Down),
    (Scancode::Space, Held::Jump),
    (Scancode::Z, Held::Jump),
    (Scancode::R, Held::Retry),
];

const ACTION_KEYS: &[(Scancode, Action)] = &[
    (Scancode::F1, Action::Overlay),
    (Scancode::F11, Action::Fullscreen),
    (Scancode::Escape, Action::Pause),
    (Scancode::P, Action::Pause),
    (Scancode::Period, Action::Step),
    (Scancode::LeftBracket, Action::Slower),
    (Scancode::RightBracket, Action::Faster),
    (Scancode::Q, Action::Quit),
];

/// Keys that work even while a text field has the keyboard: nobody types them.
const ALWAYS: &[Scancode] = &[Scancode::F1, Scancode::F11];

/// The state of all input devices, between ticks.
#[derive(Default)]
pub struct Controls {
    keys: Vec<Scancode>, // held, in the order in which they went down
    pads: Pads,
    jump: Tap,
    retry: bool, // asked for since the last tick
}

/// A button whose shortest taps and gaps are seen by one tick each.
#[derive(Clone, Copy, Debug, Default)]
struct Tap {
    given: bool,
    pressed: bool,
    released: bool,
}

impl Tap {
    /// The state for the next tick, from what is held now and what happened since the last one.
    fn take(&mut self, held: bool) -> bool {
        let gap = self.given && self.released;
        self.given = !gap && (held || self.pressed);
        if !gap {
            self.pressed = false;
        }
        self.released = false;
        self.given
    }
}

impl Controls {
    /// Takes note of an event; says what was asked for beside the hero's input.
    /// `typing`: something else has the keyboard.
    pub fn handle(&mut self, event: &Event, typing: bool) -> Option<Action> {
        match *event {
            Event::KeyDown {
                scancode: Some(code),
                keymod,
                repeat: false,
                ..
            } => self.key_down(code, keymod, typing),
            Event::KeyUp {
                scancode: Some(code),
                ..
            } => {
                self.keys.retain(|held| *held != code);
                self.jump.released |= bound(code) == Some(Held::Jump);
                None
            }
            _ => {
                let change = self.pads.handle(event);
                self.jump.pressed |= change.jump_down;
                self.jump.released |= change.jump_up;
                self.retry |= change.retry;
                change.action
            }
        }
    }

    /// A key may both move the hero and ask for something.
    fn key_down(&mut self, code: Scancode, keymod: Mod, typing: bool) -> Option<Action> {
        if typing && !ALWAYS.contains(&code) {
            return None;
        }
        if code == Scancode::Return && keymod.intersects(Mod::LALTMOD | Mod::RALTMOD) {
            return Some(Action::Fullscreen);
        }
        if let Some(held) = bound(code) {
            self.keys.push(code);
            self.jump.pressed |= held == Held::Jump;
            self.retry |= held == Held::Retry;
        }
        ACTION_KEYS
            .iter()
            .find(|(key, _)| *key == code)
            .map(|(_, action)| *action)
    }

    /// Connects a game controller that SDL has announced.
    pub fn pads(&mut self) -> &mut Pads {
        &mut self.pads
    }

    /// Asks for a restart, as its key does.
    pub fn ask_retry(&mut self) {
        self.retry = true;
    }

    /// Whether a restart was asked for since the last tick.
    pub fn wants_retry(&self) -> bool {
        self.retry
    }

    /// Lets go of every key and button.
    pub fn release_all(&mut self) {
        self.release_keys();
        self.pads.release_all();
        self.retry = false;
        self.jump.pressed = false;
    }

    /// Lets go of every key.
    pub fn release_keys(&mut self) {
        self.jump.released |= self.holds(Held::Jump);
        self.keys.clear();
    }

    /// The input of the next tick.
    pub fn take(&mut self) -> Input {
        let jump = self.holds(Held::Jump) || self.pads.jump();
        Input {
            run: self.run(),
            jump: self.jump.take(jump),
            down: self.holds(Held::Down) || self.pads.down(),
            up: self.holds(Held::Up) || self.pads.up(),
            retry: std::mem::take(&mut self.retry),
        }
    }

    /// Where the player wants to look, from -1 (down) to 1 (up).
    pub fn look(&self) -> f64 {
        if self.holds(Held::Up) {
            1.0
        } else {
            self.pads.look()
        }
    }

    fn holds(&self, what: Held) -> bool {
        self.keys.iter().any(|key| bound(*key) == Some(what))
    }

    /// The keyboard before the stick, and of two opposite keys the later one.
    fn run(&self) -> i8 {
        let last = self.keys.iter().rev().find_map(|key| match bound(*key) {
            Some(Held::Left) => Some(-127),
            Some(Held::Right) => Some(127),
            _ => None,
        });
        last.unwrap_or_else(|| self.pads.run())
    }
}

fn bound(code: Scancode) -> Option<Held> {
    HERO_KEYS
        .iter()
        .find(|(key, _)| *key == code)
        .map(|(_, held)| *held)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(code: Scancode, down: bool) -> Event {
        let (timestamp, window_id, keycode, keymod) = (0, 0, None, Mod::NOMOD);
        let (scancode, repeat) = (Some(code), false);
        if down {
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
        }
    }

    fn controls(events: &[(Scancode, bool)]) -> Controls {
        let mut controls = Controls::default();
        for (code, down) in events {
            controls.handle(&key(*code, *down), false);
        }
        controls
    }

    #[test]
    fn of_two_opposite_keys_the_later_one_counts() {
        let mut both = controls(&[(Scancode::A, true), (Scancode::Right, true)]);
        assert_eq!(both.take().run, 127);
        both.handle(&key(Scancode::Right, false), false);
        assert_eq!(both.take().run, -127);
    }

    #[test]
    fn a_tap_between_two_ticks_is_one_tick_long() {
        let mut tapped = controls(&[(Scancode::Space, true), (Scancode::Space, false)]);
        assert!(tapped.take().jump);
        assert!(!tapped.take().jump);
    }

    #[test]
    fn letting_go_and_pressing_again_between_two_ticks_is_a_new_press() {
        let mut held = controls(&[(Scancode::Space, true)]);
        assert!(held.take().jump);
        held.handle(&key(Scancode::Space, false), false);
        held.handle(&key(Scancode::Space, true), false);
        assert!(!held.take().jump);
        assert!(held.take().jump && held.take().jump);
    }

    #[test]
    fn retry_is_asked_for_once_per_press() {
        let mut retry = controls(&[(Scancode::R, true)]);
        assert!(retry.take().retry);
        assert!(!retry.take().retry);
    }

    #[test]
    fn keys_typed_into_a_field_do_not_reach_the_game() {
        let mut controls = Controls::default();
        assert_eq!(controls.handle(&key(Scancode::D, true), true), None);
        assert_eq!(controls.handle(&key(Scancode::P, true), true), None);
        assert_eq!(
            controls.handle(&key(Scancode::F1, true), true),
            Some(Action::Overlay)
        );
        assert_eq!(controls.take(), Input::default());
    }

    #[test]
    fn released_keys_stay_up_until_pressed_again() {
        let mut held = controls(&[
            (Scancode::D, true),
            (Scancode::Space, true),
            (Scancode::W, true),
        ]);
        assert_eq!(held.look(), 1.0);
        assert!(held.take().jump);
        held.release_all();
        assert_eq!((held.take(), held.look()), (Input::default(), 0.0));
        held.handle(&key(Scancode::D, true), false);
        assert_eq!(held.take().run, 127);
    }
}
