//! From events of keyboard and controllers to what menus understand.

use super::nav::{Nav, Repeater, StickNav};
use crate::shell::settings::{Bindings, Deed, bindings};
use sdl2::controller::{Axis, Button};
use sdl2::event::Event;
use sdl2::keyboard::{Mod, Scancode};
use std::time::Duration;

/// The devices as a menu sees them.
#[derive(Debug, Default)]
pub struct Navigator {
    repeater: Repeater,
    stick: StickNav,
    at: [f64; 2],
}

impl Navigator {
    /// What an event asks for.
    pub fn handle(&mut self, event: &Event, keys: &Bindings) -> Option<Nav> {
        match *event {
            Event::KeyDown {
                scancode: Some(code),
                keymod,
                repeat: false,
                ..
            } => self.press(of_key(code, keymod, keys)),
            Event::KeyUp {
                scancode: Some(code),
                keymod,
                ..
            } => self.release(of_key(code, keymod, keys)),
            Event::ControllerButtonDown { button, .. } => self.press(of_button(button)),
            Event::ControllerButtonUp { button, .. } => self.release(of_button(button)),
            Event::ControllerAxisMotion { axis, value, .. } => {
                let place = match axis {
                    Axis::LeftX => 0,
                    Axis::LeftY => 1,
                    _ => return None,
                };
                self.at[place] = f64::from(value) / f64::from(i16::MAX);
                let (taken, left) = self.stick.moved(self.at);
                self.release(left);
                self.press(taken)
            }
            Event::ControllerDeviceRemoved { .. } => {
                *self = Navigator::default();
                None
            }
            _ => None,
        }
    }

    /// Lets time pass; a held direction that counts again.
    pub fn advance(&mut self, elapsed: Duration) -> Option<Nav> {
        self.repeater.advance(elapsed)
    }

    /// Nothing is held any more.
    pub fn clear(&mut self) {
        self.repeater.clear();
    }

    fn press(&mut self, nav: Option<Nav>) -> Option<Nav> {
        if let Some(nav) = nav {
            self.repeater.press(nav);
        }
        nav
    }

    fn release(&mut self, nav: Option<Nav>) -> Option<Nav> {
        if let Some(nav) = nav {
            self.repeater.release(nav);
        }
        None
    }
}

/// Keys that every menu knows, and the hero's directions wherever they lie.
fn of_key(code: Scancode, keymod: Mod, keys: &Bindings) -> Option<Nav> {
    use Scancode as K;
    if keymod.intersects(Mod::LALTMOD | Mod::RALTMOD) {
        return None;
    }
    Some(match code {
        K::Up => Nav::Up,
        K::Down => Nav::Down,
        K::Left => Nav::Left,
        K::Right => Nav::Right,
        K::Return | K::KpEnter | K::Space => Nav::Choose,
        K::Escape | K::Backspace => Nav::Back,
        K::Delete => Nav::Clear,
        K::Tab if keymod.intersects(Mod::LSHIFTMOD | Mod::RSHIFTMOD) => Nav::Up,
        K::Tab => Nav::Down,
        _ => {
            return keys.of_key(code).find_map(|deed| match deed {
                Deed::Up => Some(Nav::Up),
                Deed::Down => Some(Nav::Down),
                Deed::Left => Some(Nav::Left),
                Deed::Right => Some(Nav::Right),
                _ => None,
            });
        }
    })
}

fn of_button(button: Button) -> Option<Nav> {
    Some(match button {
        Button::DPadUp => Nav::Up,
        Button::DPadDown => Nav::Down,
        Button::DPadLeft => Nav::Left,
        Button::DPadRight => Nav::Right,
        Button::A => Nav::Choose,
        Button::B => Nav::Back,
        Button::X => Nav::Clear,
        _ => return None,
    })
}

/// The key or button that an event presses, for those who wait for one. `None` inside: it ends the wait.
pub fn pressed(event: &Event) -> Option<Option<bindings::Input>> {
    match *event {
        Event::KeyDown {
            scancode: Some(Scancode::Escape),
            ..
        } => Some(None),
        Event::KeyDown {
            scancode: Some(code),
            repeat: false,
            ..
        } => Some(Some(bindings::Input::Key(code))),
        Event::ControllerButtonDown { button, .. } => Some(Some(bindings::Input::Button(button))),
        Event::MouseButtonDown { .. } => Some(None),
        _ => None,
    }
}
