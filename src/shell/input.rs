//! From keys and game controllers to what the simulation reads once per tick.
//!
//! Held keys are remembered here from events, never polled: so a tap between two ticks is not lost, and whoever
//! takes the keyboard away (a text field, another window) can have all of them let go.

use super::menu::prompts::Device;
use super::pads::{Change, Pads};
use super::settings::{Bindings, Deed, Hands, Hold};
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
    /// Open the pause menu.
    Pause,
    /// Stop time to look at the scene, or let it run.
    Hold,
    /// One tick, paused.
    Step,
    /// Half as fast.
    Slower,
    /// Twice as fast.
    Faster,
}

const ACTION_KEYS: &[(Scancode, Action)] = &[
    (Scancode::F1, Action::Overlay),
    (Scancode::F11, Action::Fullscreen),
    (Scancode::Escape, Action::Pause),
    (Scancode::P, Action::Hold),
    (Scancode::Period, Action::Step),
    (Scancode::LeftBracket, Action::Slower),
    (Scancode::RightBracket, Action::Faster),
];

/// Keys that work even while a text field has the keyboard: nobody types them.
const ALWAYS: &[Scancode] = &[Scancode::F1, Scancode::F11];

/// What is done for as long as it is held, and leads the hero somewhere.
const LEADS: [Deed; 4] = [Deed::Left, Deed::Right, Deed::Up, Deed::Down];

/// The state of all input devices, between ticks.
#[derive(Default)]
pub struct Controls {
    bindings: Bindings,
    crouch: Hold,
    moves: Hold,
    keys: Vec<Scancode>,  // held, in the order in which they went down
    aside: Vec<Scancode>, // held as well, but since something else had the keyboard
    pads: Pads,
    jump: Tap,
    toggled: bool,       // crouching until it is pressed again
    going: Option<Deed>, // likewise, where he is led
    away: bool,          // something else has the keys and the buttons
    retry: bool,         // asked for since the last tick
    respawn: bool,       // likewise
    device: Device,
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
    /// What does what from now on, and how crouching works, and running and climbing.
    pub fn set(&mut self, hands: &Hands, crouch: Hold, moves: Hold) {
        self.bindings = hands.bindings.clone();
        (self.crouch, self.moves) = (crouch, moves);
        (self.toggled, self.going) = (false, None);
        self.pads
            .set_dead_zones(hands.move_dead_zone, hands.look_dead_zone);
    }

    /// Takes note of an event; says what was asked for beside the hero's input.
    /// `typing`: something else has the keyboard and the buttons.
    pub fn handle(&mut self, event: &Event, typing: bool) -> Option<Action> {
        self.note_device(event);
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
                self.aside.retain(|held| *held != code);
                self.jump.released |= self.does(code, Deed::Jump);
                None
            }
            _ => {
                let change = self.pads.handle(event, typing);
                self.button(change)
            }
        }
    }

    /// What a change of a controller means.
    fn button(&mut self, change: Change) -> Option<Action> {
        match change {
            Change::None => None,
            Change::Down(sdl2::controller::Button::Start) => Some(Action::Pause),
            Change::Down(button) => {
                for deed in Deed::ALL {
                    if self.bindings.button(deed) == Some(button) {
                        self.press(deed);
                    }
                }
                None
            }
            Change::Up(button) => {
                self.jump.released |= self.bindings.button(Deed::Jump) == Some(button);
                None
            }
            Change::Gone => {
                self.jump.released = true;
                None
            }
        }
    }

    /// A key may both move the hero and ask for something, unless it was given to the hero by hand.
    fn key_down(&mut self, code: Scancode, keymod: Mod, typing: bool) -> Option<Action> {
        if code == Scancode::Return && keymod.intersects(Mod::LALTMOD | Mod::RALTMOD) {
            return Some(Action::Fullscreen);
        }
        if typing && !ALWAYS.contains(&code) {
            self.aside.push(code);
            return None;
        }
        let mut is_bound = false;
        for deed in Deed::ALL {
            if self.does(code, deed) {
                is_bound = true;
                self.press(deed);
            }
        }
        if is_bound {
            self.keys.push(code);
            return None;
        }
        ACTION_KEYS
            .iter()
            .find(|(key, _)| *key == code)
            .map(|(_, action)| *action)
    }

    /// What counts at the moment in which something goes down.
    fn press(&mut self, deed: Deed) {
        if self.is_toggled(deed) {
            self.going = (self.going != Some(deed)).then_some(deed);
        }
        match deed {
            Deed::Jump => {
                self.jump.pressed = true;
                self.toggled = false;
            }
            Deed::Up => self.toggled = false,
            Deed::Crouch if self.crouch == Hold::Toggle => self.toggled = !self.toggled,
            Deed::Retry => {
                self.respawn = true;
                (self.toggled, self.going) = (false, None);
            }
            _ => {}
        }
    }

    /// Which device was used last.
    fn note_device(&mut self, event: &Event) {
        match *event {
            Event::KeyDown { .. } | Event::MouseMotion { .. } | Event::MouseButtonDown { .. } => {
                self.device = Device::Keys;
            }
            _ => {
                if let Some(make) = self.pads.used(event) {
                    self.device = Device::Pad(make);
                }
            }
        }
    }

    /// The device that was used last.
    pub fn device(&self) -> Device {
        self.device
    }

    /// Takes this for the device that was used last, for pictures.
    pub fn pretend(&mut self, device: Device) {
        self.device = device;
    }

    /// Connects a game controller that SDL has announced.
    pub fn pads(&mut self) -> &mut Pads {
        &mut self.pads
    }

    /// Asks for a restart of the level.
    pub fn ask_retry(&mut self) {
        self.retry = true;
    }

    /// Asks to go back to the last checkpoint, as its key does.
    pub fn ask_respawn(&mut self) {
        self.respawn = true;
    }

    /// Whether a restart was asked for since the last tick, of the level or from the last checkpoint.
    pub fn wants_retry(&self) -> bool {
        self.retry || self.respawn
    }

    /// Something else has the keys and the buttons from now on: what is held is remembered, and moves nobody.
    pub fn set_aside(&mut self) {
        let mut held = std::mem::take(&mut self.aside);
        held.append(&mut self.keys);
        self.let_go();
        self.pads.set_aside();
        (self.aside, self.away) = (held, true);
    }

    /// The hero has the keys and the buttons again: those that lead him somewhere count at once if they are still held or
    /// were pressed meanwhile. What happens in a moment (a jump, going back) has to be asked for anew.
    pub fn take_back(&mut self) {
        self.let_go();
        let held = std::mem::take(&mut self.aside);
        let leads = |key: &Scancode| LEADS.iter().any(|deed| self.does(*key, *deed));
        self.keys = held.into_iter().filter(leads).collect();
        let buttons = LEADS.map(|deed| self.bindings.button(deed));
        self.pads.take_back(&buttons);
        (self.jump, self.away) = (Tap::default(), false);
    }

    /// Lets go of every key and button.
    pub fn release_all(&mut self) {
        self.let_go();
        self.aside.clear();
        self.pads.release_all();
    }

    /// Nothing that was pressed or asked for counts any more.
    fn let_go(&mut self) {
        self.release_keys();
        (self.retry, self.respawn, self.toggled) = (false, false, false);
        self.going = None;
        self.jump.pressed = false;
    }

    /// Lets go of every key.
    pub fn release_keys(&mut self) {
        self.jump.released |= self.holds(Deed::Jump);
        self.keys.clear();
    }

    /// The input of the next tick.
    pub fn take(&mut self) -> Input {
        if self.away {
            return Input {
                retry: std::mem::take(&mut self.retry),
                respawn: std::mem::take(&mut self.respawn),
                ..Input::default()
            };
        }
        let jump = self.holds(Deed::Jump);
        let crouches = self.toggled || self.crouch == Hold::Hold && self.holds(Deed::Crouch);
        Input {
            run: self.run(),
            jump: self.jump.take(jump),
            down: crouches || self.holds(Deed::Down) || self.pads.pushed_down(),
            up: self.holds(Deed::Up) || self.pads.pushed_up(),
            retry: std::mem::take(&mut self.retry),
            respawn: std::mem::take(&mut self.respawn),
        }
    }

    /// Where the player wants to look, from -1 (down) to 1 (up).
    pub fn look(&self) -> f64 {
        if self.away {
            0.0
        } else if self.is_led(Deed::Up) {
            1.0
        } else {
            self.pads.look()
        }
    }

    fn does(&self, key: Scancode, deed: Deed) -> bool {
        self.bindings.keys(deed).contains(&Some(key))
    }

    /// Whether a deed lasts from one press to the next rather than for as long as it is held.
    fn is_toggled(&self, deed: Deed) -> bool {
        self.moves == Hold::Toggle && LEADS.contains(&deed)
    }

    /// By a key, or from one press to the next.
    fn is_led(&self, deed: Deed) -> bool {
        match self.is_toggled(deed) {
            true => self.going == Some(deed),
            false => self.keys.iter().any(|key| self.does(*key, deed)),
        }
    }

    fn holds(&self, deed: Deed) -> bool {
        let button = self
            .bindings
            .button(deed)
            .filter(|_| !self.is_toggled(deed));
        self.is_led(deed) || button.is_some_and(|button| self.pads.holds(button))
    }

    /// The keyboard before the controllers, and of two opposite keys the later one.
    fn run(&self) -> i8 {
        let way = |deed: Deed| match deed {
            Deed::Left => Some(-127),
            Deed::Right => Some(127),
            _ => None,
        };
        if self.moves == Hold::Toggle {
            let going = self.going.and_then(way);
            return going.unwrap_or_else(|| self.pads.run([None, None]));
        }
        let key_way = |key: &Scancode| {
            let mut sides = [Deed::Left, Deed::Right].into_iter();
            sides.find(|side| self.does(*key, *side)).and_then(way)
        };
        let last = self.keys.iter().rev().find_map(key_way);
        let buttons = [Deed::Left, Deed::Right].map(|deed| self.bindings.button(deed));
        last.unwrap_or_else(|| self.pads.run(buttons))
    }
}

#[cfg(test)]
mod tests;
