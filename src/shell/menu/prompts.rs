//! What keys and buttons are called on the device in use, and how that looks.

use crate::shell::settings::bindings::{Bindings, Deed};
use crate::shell::text::Symbol;
use sdl2::controller::Button;
use sdl2::keyboard::{Keycode, Scancode};

/// Whose words a controller's buttons bear.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Make {
    /// A, B, X, Y; also for those that nobody knows.
    #[default]
    Letters,
    /// Cross, circle, square, triangle.
    Shapes,
    /// A, B, X, Y, plus and minus.
    Signs,
}

/// What the player has used last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Device {
    /// Keyboard and mouse.
    #[default]
    Keys,
    /// A controller.
    Pad(Make),
}

impl Device {
    /// By its name on the command line, one of [`DEVICES`](crate::cli::DEVICES).
    pub fn named(name: &str) -> Option<Device> {
        Some(match name {
            "keys" => Device::Keys,
            "letters" => Device::Pad(Make::Letters),
            "shapes" => Device::Pad(Make::Shapes),
            "signs" => Device::Pad(Make::Signs),
            _ => return None,
        })
    }
}

/// Numbers by which USB knows the makers of controllers.
const SONY: u16 = 0x054c;
const NINTENDO: u16 = 0x057e;
/// Parts of names that controllers of those kinds have, whoever made them.
const SHAPES: [&str; 4] = ["dualsense", "dualshock", "playstation", "ps4"];
const SIGNS: [&str; 3] = ["nintendo", "switch", "joy-con"];

impl Make {
    /// From what a controller says of itself.
    pub fn of(vendor: Option<u16>, name: &str) -> Make {
        let name = name.to_lowercase();
        let says = |words: &[&str]| words.iter().any(|word| name.contains(word));
        match vendor {
            Some(SONY) => Make::Shapes,
            Some(NINTENDO) => Make::Signs,
            _ if says(&SHAPES) => Make::Shapes,
            _ if says(&SIGNS) => Make::Signs,
            _ => Make::Letters,
        }
    }
}

/// How a key or button is shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Cap {
    /// A key with its name.
    Key(String),
    /// A key with a drawing.
    Arrow(Symbol),
    /// A round button with a letter.
    Letter(&'static str),
    /// A round button with a drawing.
    Shape(Symbol),
    /// A long button with its name.
    Plate(&'static str),
}

/// A key, by its name on the layout in use.
pub fn key(code: Scancode) -> Cap {
    match code {
        Scancode::Left => Cap::Arrow(Symbol::ToLeft),
        Scancode::Right => Cap::Arrow(Symbol::ToRight),
        Scancode::Up => Cap::Arrow(Symbol::ToTop),
        Scancode::Down => Cap::Arrow(Symbol::ToBottom),
        _ => Cap::Key(key_name(code)),
    }
}

/// A key's name on the layout in use, or else by its place.
pub fn key_name(code: Scancode) -> String {
    let name = Keycode::from_scancode(code)
        .map(Keycode::name)
        .filter(|name| !name.is_empty());
    let name = name.unwrap_or_else(|| code.name().to_owned());
    match name.as_str() {
        "Return" => "Enter".into(),
        "Escape" => "Esc".into(),
        "Backspace" => "Back".into(),
        _ => name
            .replace("Left ", "L ")
            .replace("Right ", "R ")
            .replace("Keypad ", "Pad "),
    }
}

/// A button, by the words of its make.
pub fn button(button: Button, make: Make) -> Cap {
    use Make::{Letters, Shapes, Signs};
    let pick = |letters, shapes, signs| match make {
        Letters => letters,
        Shapes => shapes,
        Signs => signs,
    };
    match (button, make) {
        (Button::A, Shapes) => Cap::Shape(Symbol::Cross),
        (Button::B, Shapes) => Cap::Shape(Symbol::Ring),
        (Button::X, Shapes) => Cap::Shape(Symbol::Square),
        (Button::Y, Shapes) => Cap::Shape(Symbol::Triangle),
        (Button::A, _) => Cap::Letter("A"),
        (Button::B, _) => Cap::Letter("B"),
        (Button::X, _) => Cap::Letter("X"),
        (Button::Y, _) => Cap::Letter("Y"),
        (Button::DPadLeft, _) => Cap::Arrow(Symbol::ToLeft),
        (Button::DPadRight, _) => Cap::Arrow(Symbol::ToRight),
        (Button::DPadUp, _) => Cap::Arrow(Symbol::ToTop),
        (Button::DPadDown, _) => Cap::Arrow(Symbol::ToBottom),
        (Button::Back, _) => Cap::Plate(pick("View", "Share", "−")),
        (Button::Start, _) => Cap::Plate(pick("Menu", "Options", "+")),
        (Button::LeftShoulder, _) => Cap::Plate(pick("LB", "L1", "L")),
        (Button::RightShoulder, _) => Cap::Plate(pick("RB", "R1", "R")),
        (Button::LeftStick, _) => Cap::Plate(pick("LS", "L3", "LS")),
        (Button::RightStick, _) => Cap::Plate(pick("RS", "R3", "RS")),
        (Button::Guide, _) => Cap::Plate("Home"),
        (Button::Misc1, _) => Cap::Plate("Misc"),
        (Button::Touchpad, _) => Cap::Plate("Pad"),
        (Button::Paddle1 | Button::Paddle2 | Button::Paddle3 | Button::Paddle4, _) => {
            Cap::Plate("Paddle")
        }
    }
}

/// What does a deed on the device in use; `None` if nothing does.
pub fn deed(deed: Deed, device: Device, bindings: &Bindings) -> Option<Cap> {
    match device {
        Device::Keys => bindings.keys(deed).into_iter().flatten().next().map(key),
        Device::Pad(make) => bindings.button(deed).map(|b| button(b, make)),
    }
}

/// What looks up.
pub fn look(device: Device, bindings: &Bindings) -> Option<Cap> {
    match device {
        Device::Keys => deed(Deed::Up, device, bindings),
        Device::Pad(_) => Some(Cap::Plate("R stick")),
    }
}

/// What chooses in menus.
pub fn choose(device: Device) -> Cap {
    match device {
        Device::Keys => key(Scancode::Return),
        Device::Pad(make) => button(Button::A, make),
    }
}

/// What goes back in menus.
pub fn back(device: Device) -> Cap {
    match device {
        Device::Keys => key(Scancode::Escape),
        Device::Pad(make) => button(Button::B, make),
    }
}

/// What takes a key away.
pub fn clear(device: Device) -> Cap {
    match device {
        Device::Keys => key(Scancode::Delete),
        Device::Pad(make) => button(Button::X, make),
    }
}

/// What pauses.
pub fn pause(device: Device) -> Cap {
    match device {
        Device::Keys => key(Scancode::Escape),
        Device::Pad(make) => button(Button::Start, make),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prompts_follow_the_device() {
        let bindings = Bindings::default();
        let jump = |device| deed(Deed::Jump, device, &bindings);
        assert_eq!(jump(Device::Keys), Some(Cap::Key("Space".into())));
        assert_eq!(jump(Device::Pad(Make::Letters)), Some(Cap::Letter("A")));
        assert_eq!(
            jump(Device::Pad(Make::Shapes)),
            Some(Cap::Shape(Symbol::Cross))
        );
        assert_eq!(jump(Device::Pad(Make::Signs)), Some(Cap::Letter("A")));
        assert_eq!(pause(Device::Pad(Make::Signs)), Cap::Plate("+"));
        assert_eq!(pause(Device::Pad(Make::Shapes)), Cap::Plate("Options"));
        let mut bare = bindings.clone();
        bare.set_button(Deed::Jump, None);
        assert_eq!(deed(Deed::Jump, Device::Pad(Make::Letters), &bare), None);
    }

    #[test]
    fn controllers_are_known_by_their_maker_or_their_name() {
        assert_eq!(Make::of(Some(SONY), "Wireless Controller"), Make::Shapes);
        assert_eq!(Make::of(Some(NINTENDO), ""), Make::Signs);
        assert_eq!(
            Make::of(Some(0x2dc8), "8BitDo for Nintendo Switch"),
            Make::Signs
        );
        assert_eq!(Make::of(None, "PS4 Controller"), Make::Shapes);
        assert_eq!(Make::of(Some(0x045e), "Xbox One"), Make::Letters);
        assert_eq!(Make::of(None, ""), Make::Letters);
    }
}
