//! Game controllers: plugged in and out at any time, all of them equal.

use super::menu::prompts::Make;
use sdl2::GameControllerSubsystem;
use sdl2::controller::{Axis, Button, GameController};
use sdl2::event::Event;

/// Share of a stick's way that counts as its middle unless asked otherwise, and from which it counts as fully pushed.
const DEAD_ZONE: f64 = 0.25;
const FULL: f64 = 0.95;
/// Share of a stick's way from which its device counts as used.
const USED: f64 = 0.5;
/// How far up or down the stick must be to climb or crouch: clearly more than by running carelessly.
const TILT: f64 = 0.6;

/// One connected controller. Its handle must live as long as it shall be heard.
struct Pad {
    device: GameController,
    stick: [f64; 2], // left stick, right and down positive
    look: f64,       // right stick, down positive
    held: Vec<Button>,
    aside: Vec<Button>, // held as well, but since something else had the buttons
    make: Make,
}

/// All connected controllers.
pub struct Pads {
    pads: Vec<Pad>,
    move_dead_zone: f64,
    look_dead_zone: f64,
}

impl Default for Pads {
    fn default() -> Self {
        Pads {
            pads: Vec::new(),
            move_dead_zone: DEAD_ZONE,
            look_dead_zone: DEAD_ZONE,
        }
    }
}

/// What an event of a controller means, beside what is held now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Change {
    /// Nothing.
    #[default]
    None,
    /// A button went down.
    Down(Button),
    /// A button went up.
    Up(Button),
    /// A controller is gone, with all that it held.
    Gone,
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
        let is_new = |pad: &Pad| pad.device.instance_id() != device.instance_id();
        if self.pads.iter().all(is_new) {
            self.pads.push(Pad {
                make: Make::of(device.vendor_id(), &device.name()),
                device,
                stick: [0.0; 2],
                look: 0.0,
                held: Vec::new(),
                aside: Vec::new(),
            });
        }
        Ok(())
    }

    /// How many are connected.
    pub fn count(&self) -> usize {
        self.pads.len()
    }

    /// Shares of the sticks' ways that count as their middle, in percent.
    pub fn set_dead_zones(&mut self, moving: u32, looking: u32) {
        (self.move_dead_zone, self.look_dead_zone) =
            (f64::from(moving) / 100.0, f64::from(looking) / 100.0);
    }

    /// Takes note of an event of a controller; other events change nothing. While something else has the buttons
    /// (`taken`), none of them is held.
    pub fn handle(&mut self, event: &Event, taken: bool) -> Change {
        match *event {
            Event::ControllerAxisMotion {
                which, axis, value, ..
            } => {
                self.axis(which, axis, f64::from(value) / f64::from(i16::MAX));
                Change::None
            }
            Event::ControllerButtonDown { which, button, .. } => match self.find(which) {
                Some(pad) if taken => {
                    pad.aside.push(button);
                    Change::None
                }
                Some(pad) => {
                    pad.held.push(button);
                    Change::Down(button)
                }
                None => Change::None,
            },
            Event::ControllerButtonUp { which, button, .. } => {
                if let Some(pad) = self.find(which) {
                    pad.held.retain(|held| *held != button);
                    pad.aside.retain(|held| *held != button);
                }
                Change::Up(button)
            }
            Event::ControllerDeviceRemoved { which, .. } => {
                self.pads.retain(|pad| pad.device.instance_id() != which);
                Change::Gone
            }
            _ => Change::None,
        }
    }

    /// Whose controller an event shows to be used.
    pub fn used(&self, event: &Event) -> Option<Make> {
        let which = match *event {
            Event::ControllerButtonDown { which, .. } => which,
            Event::ControllerAxisMotion { which, value, .. }
                if f64::from(value).abs() > USED * f64::from(i16::MAX) =>
            {
                which
            }
            _ => return None,
        };
        let pad = self
            .pads
            .iter()
            .find(|pad| pad.device.instance_id() == which);
        pad.map(|pad| pad.make)
    }

    fn find(&mut self, which: u32) -> Option<&mut Pad> {
        self.pads
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

    /// Lets go of everything; a stick that is still pushed counts again when it moves.
    pub fn release_all(&mut self) {
        for pad in &mut self.pads {
            (pad.stick, pad.look) = ([0.0; 2], 0.0);
            pad.held.clear();
            pad.aside.clear();
        }
    }

    /// Something else has the buttons from now on: what is held is remembered, and the sticks are still followed.
    pub fn set_aside(&mut self) {
        for pad in &mut self.pads {
            pad.aside.append(&mut pad.held);
        }
    }

    /// The hero has the buttons again; of those that are held, these count.
    pub fn take_back(&mut self, buttons: &[Option<Button>]) {
        for pad in &mut self.pads {
            pad.held = std::mem::take(&mut pad.aside);
            pad.held.retain(|held| buttons.contains(&Some(*held)));
        }
    }

    /// A button is held on one of them.
    pub fn holds(&self, button: Button) -> bool {
        self.pads.iter().any(|pad| pad.held.contains(&button))
    }

    /// A stick is pushed down.
    pub fn pushed_down(&self) -> bool {
        self.pads.iter().any(|pad| pad.stick[1] > TILT)
    }

    /// A stick is pushed up.
    pub fn pushed_up(&self) -> bool {
        self.pads.iter().any(|pad| pad.stick[1] < -TILT)
    }

    /// The wished run of the one that wishes most; these buttons go left and right.
    pub fn run(&self, buttons: [Option<Button>; 2]) -> i8 {
        let runs = self
            .pads
            .iter()
            .map(|pad| pad.run(buttons, self.move_dead_zone));
        runs.max_by_key(|run| run.unsigned_abs()).unwrap_or(0)
    }

    /// The wished look of the one that wishes most, up positive.
    pub fn look(&self) -> f64 {
        let looks = self
            .pads
            .iter()
            .map(|pad| -beyond(pad.look, self.look_dead_zone));
        looks
            .max_by(|a, b| a.abs().total_cmp(&b.abs()))
            .unwrap_or(0.0)
    }
}

impl Pad {
    fn run(&self, buttons: [Option<Button>; 2], dead_zone: f64) -> i8 {
        let holds = |button: Option<Button>| button.is_some_and(|b| self.held.contains(&b));
        match buttons.map(holds) {
            [true, false] => -127,
            [false, true] => 127,
            _ => (beyond(self.stick[0], dead_zone) * 127.0).round() as i8,
        }
    }
}

/// A stick's way with its middle taken out: 0 up to the dead zone, then evenly to 1.
fn beyond(value: f64, dead_zone: f64) -> f64 {
    let way = (value.abs() - dead_zone) / (FULL - dead_zone);
    way.clamp(0.0, 1.0).copysign(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_dead_zone_is_dead_and_the_rest_is_even() {
        assert_eq!(beyond(0.2, DEAD_ZONE), 0.0);
        assert_eq!(beyond(-1.0, DEAD_ZONE), -1.0);
        assert!((beyond(-0.6, DEAD_ZONE) + 0.5).abs() < 1e-12);
        assert!(beyond(0.26, DEAD_ZONE) < 0.02);
        assert_eq!(beyond(0.26, 0.5), 0.0);
    }
}
