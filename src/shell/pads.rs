//! Game controllers: plugged in and out at any time, all of them equal.

use super::input::Action;
use sdl2::GameControllerSubsystem;
use sdl2::controller::{Axis, Button, GameController};
use sdl2::event::Event;

/// Share of a stick's way that counts as its middle, and from which it counts as fully pushed.
const DEAD_ZONE: f64 = 0.25;
const FULL: f64 = 0.95;
/// How far up or down the stick must be to climb or crouch: clearly more than by running carelessly.
const TILT: f64 = 0.6;

/// One connected controller. Its handle must live as long as it shall be heard.
struct Pad {
    device: GameController,
    stick: [f64; 2], // left stick, right and down positive
    look: f64,       // right stick, down positive
    held: Vec<Button>,
}

/// All connected controllers.
#[derive(Default)]
pub struct Pads(Vec<Pad>);

/// What an event of a controller means, beside what is held now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Change {
    /// A jump button went down.
    pub jump_down: bool,
    /// A jump button went up.
    pub jump_up: bool,
    /// The restart button went down.
    pub retry: bool,
    /// What was asked for.
    pub action: Option<Action>,
}

impl Pads {
    /// Opens a controller by the device index of its announcement.
    ///
    /// # Errors
    /// The driver's words; the game goes on without it.
    pub fn connect(
        &mut self,
        subsystem: &GameControllerSubsystem,
        index: u32,
    ) -> Result<(), String> {
        let device = subsystem
            .open(index)
            .map_err(|e| format!("game controller: {e}"))?;
        if self
            .0
            .iter()
            .all(|pad| pad.device.instance_id() != device.instance_id())
        {
            self.0.push(Pad {
                device,
                stick: [0.0; 2],
                look: 0.0,
                held: Vec::new(),
            });
        }
        Ok(())
    }

    /// How many are connected.
    pub fn count(&self) -> usize {
        self.0.len()
    }

    /// Takes note of an event of a controller; other events change nothing.
    pub fn handle(&mut self, event: &Event) -> Change {
        match *event {
            Event::ControllerAxisMotion {
                which, axis, value, ..
            } => {
                self.axis(which, axis, f64::from(value) / f64::from(i16::MAX));
                Change::default()
            }
            Event::ControllerButtonDown { which, button, .. } => self.button_down(which, button),
            Event::ControllerButtonUp { which, button, .. } => {
                if let Some(pad) = self.find(which) {
                    pad.held.retain(|held| *held != button);
                }
                Change {
                    jump_up: button == Button::A,
                    ..Change::default()
                }
            }
            Event::ControllerDeviceRemoved { which, .. } => {
                self.0.retain(|pad| pad.device.instance_id() != which);
                Change {
                    jump_up: true,
                    ..Change::default()
                }
            }
            _ => Change::default(),
        }
    }

    fn find(&mut self, which: u32) -> Option<&mut Pad> {
        self.0
            .iter_mut()
            .find(|pad| pad.device.instance_id() == which)
    }

    /// Triggers and the right stick's way across mean nothing here.
    fn axis(&mut self, which: u32, axis: Axis, value: f64) {
        let Some(pad) = self.find(which) else { return };
        match axis {
            Axis::LeftX => pad.stick[0] = value,
            Axis::LeftY => pad.stick[1] = value,
            Axis::RightY => pad.look = value,
            _ => {}
        }
    }

    /// Held buttons are kept as they are: what they mean is asked for once per tick.
    fn button_down(&mut self, which: u32, button: Button) -> Change {
        let Some(pad) = self.find(which) else {
            return Change::default();
        };
        pad.held.push(button);
        Change {
            jump_down: button == Button::A,
            retry: button == Button::Back,
            action: (button == Button::Start).then_some(Action::Pause),
            ..Change::default()
        }
    }

    /// Lets go of everything; a stick that is still pushed counts again when it moves.
    pub fn release_all(&mut self) {
        for pad in &mut self.0 {
            (pad.stick, pad.look) = ([0.0; 2], 0.0);
            pad.held.clear();
        }
    }

    /// Jump is held on one of them.
    pub fn jump(&self) -> bool {
        self.holds(Button::A)
    }

    /// Down is held on one of them.
    pub fn down(&self) -> bool {
        self.holds(Button::DPadDown)
            || self.holds(Button::B)
            || self.0.iter().any(|pad| pad.stick[1] > TILT)
    }

    /// Up is held on one of them.
    pub fn up(&self) -> bool {
        self.holds(Button::DPadUp) || self.0.iter().any(|pad| pad.stick[1] < -TILT)
    }

    /// The wished run of the one that wishes most.
    pub fn run(&self) -> i8 {
        self.0
            .iter()
            .map(Pad::run)
            .max_by_key(|run| run.unsigned_abs())
            .unwrap_or(0)
    }

    /// The wished look of the one that wishes most, up positive.
    pub fn look(&self) -> f64 {
        let looks = self.0.iter().map(|pad| -beyond_dead_zone(pad.look));
        looks
            .max_by(|a, b| a.abs().total_cmp(&b.abs()))
            .unwrap_or(0.0)
    }

    fn holds(&self, button: Button) -> bool {
        self.0.iter().any(|pad| pad.held.contains(&button))
    }
}

impl Pad {
    fn run(&self) -> i8 {
        let (left, right) = (
            self.held.contains(&Button::DPadLeft),
            self.held.contains(&Button::DPadRight),
        );
        match (left, right) {
            (true, false) => -127,
            (false, true) => 127,
            _ => (beyond_dead_zone(self.stick[0]) * 127.0).round() as i8,
        }
    }
}

/// A stick's way with its middle taken out: 0 up to the dead zone, then evenly to 1.
fn beyond_dead_zone(value: f64) -> f64 {
    let way = (value.abs() - DEAD_ZONE) / (FULL - DEAD_ZONE);
    way.clamp(0.0, 1.0).copysign(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_dead_zone_is_dead_and_the_rest_is_even() {
        assert_eq!(beyond_dead_zone(0.2), 0.0);
        assert_eq!(beyond_dead_zone(-1.0), -1.0);
        assert!((beyond_dead_zone(-0.6) + 0.5).abs() < 1e-12);
        assert!(beyond_dead_zone(0.26) < 0.02);
    }
}
