//! Which keys and buttons do what. Keys are kept by their place on the keyboard, so that they lie the same on every layout.

use sdl2::controller::Button;
use sdl2::keyboard::Scancode;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Keys per deed.
pub const KEYS: usize = 2;

/// Something that the hero, or the game at once, can be made to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Deed {
    /// Run left.
    Left,
    /// Run right.
    Right,
    /// Climb, look up.
    Up,
    /// Crouch, fall faster, climb down.
    Down,
    /// Jump.
    Jump,
    /// Crouch, held or toggled.
    Crouch,
    /// Back to the last checkpoint.
    Retry,
}

impl Deed {
    /// All of them, in the order in which they are shown.
    pub const ALL: [Deed; 7] = [
        Deed::Left,
        Deed::Right,
        Deed::Up,
        Deed::Down,
        Deed::Jump,
        Deed::Crouch,
        Deed::Retry,
    ];

    /// For people.
    pub fn label(self) -> &'static str {
        match self {
            Deed::Left => "Run left",
            Deed::Right => "Run right",
            Deed::Up => "Climb, look up",
            Deed::Down => "Down, fall faster",
            Deed::Jump => "Jump",
            Deed::Crouch => "Crouch",
            Deed::Retry => "Back to checkpoint",
        }
    }

    /// As the file has it.
    fn name(self) -> &'static str {
        match self {
            Deed::Left => "left",
            Deed::Right => "right",
            Deed::Up => "up",
            Deed::Down => "down",
            Deed::Jump => "jump",
            Deed::Crouch => "crouch",
            Deed::Retry => "retry",
        }
    }
}

/// Keys that always mean the same and cannot be given another meaning.
pub const FIXED_KEYS: [Scancode; 5] = [
    Scancode::Escape,
    Scancode::F1,
    Scancode::F11,
    Scancode::LGui,
    Scancode::RGui,
];
/// Buttons that cannot be given another meaning.
pub const FIXED_BUTTONS: [Button; 2] = [Button::Start, Button::Guide];

/// What can be given to a deed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// A key, by its place.
    Key(Scancode),
    /// A button of a controller.
    Button(Button),
}

/// For each deed two keys and a button, each of which may be absent.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Names", into = "Names")]
pub struct Bindings {
    keys: [[Option<Scancode>; KEYS]; Deed::ALL.len()],
    buttons: [Option<Button>; Deed::ALL.len()],
}

impl Default for Bindings {
    fn default() -> Self {
        use Scancode as K;
        let one = |key| [Some(key), None];
        let two = |a, b| [Some(a), Some(b)];
        Bindings {
            keys: [
                two(K::Left, K::A),
                two(K::Right, K::D),
                two(K::Up, K::W),
                two(K::Down, K::S),
                two(K::Space, K::Z),
                two(K::C, K::LCtrl),
                one(K::R),
            ],
            buttons: [
                Some(Button::DPadLeft),
                Some(Button::DPadRight),
                Some(Button::DPadUp),
                Some(Button::DPadDown),
                Some(Button::A),
                Some(Button::B),
                Some(Button::Back),
            ],
        }
    }
}

impl Bindings {
    /// The keys of a deed.
    pub fn keys(&self, deed: Deed) -> [Option<Scancode>; KEYS] {
        self.keys[deed as usize]
    }

    /// The button of a deed.
    pub fn button(&self, deed: Deed) -> Option<Button> {
        self.buttons[deed as usize]
    }

    /// What a key does.
    pub fn of_key(&self, key: Scancode) -> impl Iterator<Item = Deed> {
        let has = move |deed: &Deed| self.keys(*deed).contains(&Some(key));
        Deed::ALL.into_iter().filter(has)
    }

    /// What a button does.
    pub fn of_button(&self, button: Button) -> impl Iterator<Item = Deed> {
        let has = move |deed: &Deed| self.button(*deed) == Some(button);
        Deed::ALL.into_iter().filter(has)
    }

    /// Gives a deed a key; whether it can have it.
    pub fn set_key(&mut self, deed: Deed, slot: usize, key: Option<Scancode>) -> bool {
        // A key without a name could not be saved.
        let may = |key: Scancode| !FIXED_KEYS.contains(&key) && !key.name().is_empty();
        let is_free = key.is_none_or(may);
        if is_free && let Some(place) = self.keys[deed as usize].get_mut(slot) {
            *place = key;
        }
        is_free
    }

    /// Gives a deed a button; whether it can have it.
    pub fn set_button(&mut self, deed: Deed, button: Option<Button>) -> bool {
        let is_free = button.is_none_or(|button| !FIXED_BUTTONS.contains(&button));
        if is_free {
            self.buttons[deed as usize] = button;
        }
        is_free
    }

    /// Another deed that the same key or button does.
    pub fn conflict(&self, deed: Deed, input: Input) -> Option<Deed> {
        let other = |found: &Deed| *found != deed;
        match input {
            Input::Key(key) => self.of_key(key).find(other),
            Input::Button(button) => self.of_button(button).find(other),
        }
    }
}

/// As the file has it: names of keys and of buttons by the name of what they do.
#[derive(Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Names {
    keys: BTreeMap<String, Vec<String>>,
    buttons: BTreeMap<String, String>,
}

impl From<Bindings> for Names {
    fn from(bindings: Bindings) -> Names {
        let names = |deed: Deed| {
            let keys = bindings.keys(deed).into_iter().flatten();
            keys.map(|key| key.name().to_owned()).collect()
        };
        let button = |deed: Deed| Some((deed.name().into(), bindings.button(deed)?.string()));
        Names {
            keys: Deed::ALL
                .map(|deed| (deed.name().to_owned(), names(deed)))
                .into(),
            buttons: Deed::ALL.into_iter().filter_map(button).collect(),
        }
    }
}

impl TryFrom<Names> for Bindings {
    type Error = String;

    /// What is not named keeps its keys; of the buttons it has none, for the file names all that there are.
    fn try_from(names: Names) -> Result<Bindings, String> {
        let deed = |name: &str| {
            let found = Deed::ALL.into_iter().find(|deed| deed.name() == name);
            found.ok_or(format!("`{name}` is nothing that can be done"))
        };
        let mut bindings = Bindings {
            buttons: Default::default(),
            ..Bindings::default()
        };
        for (name, keys) in &names.keys {
            let deed = deed(name)?;
            bindings.keys[deed as usize] = [None; KEYS];
            for (slot, key) in keys.iter().take(KEYS).enumerate() {
                let code = Scancode::from_name(key).ok_or(format!("`{key}` is no key"))?;
                if !bindings.set_key(deed, slot, Some(code)) {
                    return Err(format!("`{key}` always means the same"));
                }
            }
        }
        for (name, button) in &names.buttons {
            let found = Button::from_string(button).ok_or(format!("`{button}` is no button"))?;
            if !bindings.set_button(deed(name)?, Some(found)) {
                return Err(format!("`{button}` always means the same"));
            }
        }
        Ok(bindings)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_two_deeds_share_is_a_conflict() {
        let mut bindings = Bindings::default();
        for deed in Deed::ALL {
            for key in bindings.keys(deed).into_iter().flatten() {
                assert_eq!(bindings.conflict(deed, Input::Key(key)), None);
            }
        }
        assert!(bindings.set_key(Deed::Jump, 0, Some(Scancode::A)));
        let (a, button) = (Input::Key(Scancode::A), Input::Button(Button::B));
        assert_eq!(bindings.conflict(Deed::Jump, a), Some(Deed::Left));
        assert_eq!(bindings.conflict(Deed::Left, a), Some(Deed::Jump));
        assert_eq!(bindings.conflict(Deed::Jump, button), Some(Deed::Crouch));
        assert_eq!(bindings.conflict(Deed::Crouch, button), None);
    }

    #[test]
    fn a_file_that_names_some_keys_leaves_the_others() {
        let names = Names {
            keys: [("jump".to_owned(), vec!["J".to_owned()])].into(),
            buttons: BTreeMap::new(),
        };
        let bindings = Bindings::try_from(names).unwrap();
        assert_eq!(bindings.keys(Deed::Jump), [Some(Scancode::J), None]);
        let before = Bindings::default().keys(Deed::Left);
        assert_eq!(bindings.keys(Deed::Left), before);
        assert_eq!(bindings.button(Deed::Jump), None);
    }

    #[test]
    fn keys_that_lead_out_cannot_be_taken() {
        let mut bindings = Bindings::default();
        assert!(!bindings.set_key(Deed::Jump, 0, Some(Scancode::Escape)));
        assert!(!bindings.set_button(Deed::Jump, Some(Button::Start)));
        assert_eq!(bindings, Bindings::default());
    }
}
