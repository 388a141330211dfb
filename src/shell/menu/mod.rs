//! The menus as a value: which page is open, what is focused, what an input means. No window, no picture, no clock.
//!
//! In reading order: [`items`] (what stands on each page), [`values`] (what entries show and change), this file (the logic),
//! [`nav`] (from devices to what it understands), [`prompts`] (what keys and buttons are called), [`layout`] (where things
//! are), [`view`] (how they look), [`credits`].

pub mod caps;
pub mod credits;
pub mod devices;
pub mod items;
pub mod layout;
pub mod nav;
pub mod prompts;
pub mod values;
pub mod view;

pub use items::{Item, Question, Screen};
pub use nav::Nav;
pub use values::Value;

use super::settings::bindings::{Input, KEYS};
use super::settings::progress::Results;
use super::settings::{Deed, Settings};
use items::entries;

/// Seconds after which a wait for a key ends by itself.
const PATIENCE: f32 = 6.0;

/// What the menus need to know of the game.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    /// There is a run to go on with.
    pub has_run: bool,
    /// Names of the levels to choose from.
    pub levels: Vec<String>,
    /// The best that was reached in each of them, in a line; empty where nothing was.
    pub records: Vec<String>,
    /// The run that is paused, in a line: where, how long, how many deaths.
    pub paused_run: String,
    /// What the run has come to that has just reached the goal.
    pub results: Option<Results>,
}

/// What the game is to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Go on with the run that was left.
    Continue,
    /// Begin a run in the level of this number.
    Begin(usize),
    /// Go on.
    Resume,
    /// Back to the last checkpoint.
    Retry,
    /// A new run in this level.
    Restart,
    /// To the title.
    ToTitle,
    /// Leave.
    Quit,
}

/// What has happened in the menus, for the sounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MenuEvent {
    /// The focus has moved.
    Moved,
    /// Something was chosen.
    Chosen,
    /// A value has changed.
    Changed,
    /// One page back.
    Back,
    /// That cannot be done.
    Refused,
}

/// A page that is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Page {
    screen: Screen,
    focus: usize,
}

/// A wait for a key or button.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wait {
    /// What it shall do.
    pub deed: Deed,
    /// Which of its keys, or its button ([`BUTTON_COLUMN`]).
    pub column: usize,
    /// Seconds that are left.
    pub left: f32,
}

/// The column of the controls' table that has the buttons; those before it have keys.
pub const BUTTON_COLUMN: usize = KEYS;

/// The menus.
#[derive(Clone, Debug, Default)]
pub struct Menu {
    /// The pages, each opened from the one before it; empty while the menus are closed.
    pages: Vec<Page>,
    column: usize,
    wait: Option<Wait>,
    events: Vec<MenuEvent>,
    /// Seconds since the page was opened, and since the focus moved.
    pub age: f32,
    /// How far the credits have been pushed along by hand, in lines.
    pub pushed: f32,
}

impl Menu {
    /// Opens a page alone.
    pub fn open(&mut self, screen: Screen) {
        self.pages.clear();
        self.wait = None;
        self.enter(screen);
    }

    /// Closes all pages.
    pub fn close(&mut self) {
        self.pages.clear();
        self.wait = None;
    }

    /// The page that is seen.
    pub fn screen(&self) -> Option<Screen> {
        self.pages.last().map(|page| page.screen)
    }

    /// The page under all others: the title, the pause, the results.
    pub fn root(&self) -> Option<Screen> {
        self.pages.first().map(|page| page.screen)
    }

    /// The number of the focused entry.
    pub fn focus(&self) -> usize {
        self.pages.last().map_or(0, |page| page.focus)
    }

    /// The focused column of the controls' table.
    pub fn column(&self) -> usize {
        self.column
    }

    /// The focused entry.
    pub fn focused(&self, facts: &Facts) -> Option<Item> {
        entries(self.screen()?, facts).get(self.focus()).copied()
    }

    /// The key or button that is being waited for.
    pub fn wait(&self) -> Option<Wait> {
        self.wait
    }

    /// What has happened since the last call.
    pub fn take_events(&mut self) -> Vec<MenuEvent> {
        std::mem::take(&mut self.events)
    }

    /// Lets time pass, in seconds.
    pub fn advance(&mut self, seconds: f32) {
        self.age += seconds;
        if let Some(wait) = &mut self.wait {
            wait.left -= seconds;
            if wait.left <= 0.0 {
                self.stop_waiting();
            }
        }
    }

    /// Does what an input means here; says what the game is to do.
    pub fn act(&mut self, nav: Nav, settings: &mut Settings, facts: &Facts) -> Option<Command> {
        let screen = self.screen()?;
        if self.wait.is_some() {
            self.stop_waiting();
            return None;
        }
        let items = entries(screen, facts);
        let item = items.get(self.focus()).copied()?;
        match nav {
            Nav::Up if screen == Screen::Credits => self.pushed -= 1.0,
            Nav::Down if screen == Screen::Credits => self.pushed += 1.0,
            Nav::Up => self.move_to((self.focus() + items.len() - 1) % items.len()),
            Nav::Down => self.move_to((self.focus() + 1) % items.len()),
            Nav::Point(index, column) => {
                if index < items.len() {
                    self.move_to(index);
                    self.move_column(column.unwrap_or(self.column));
                }
            }
            Nav::Left | Nav::Right => self.sideways(item, nav == Nav::Right, settings),
            Nav::Share(share) => {
                if values::set_share(item, settings, share) {
                    self.events.push(MenuEvent::Changed);
                }
            }
            Nav::Clear => self.clear(item, settings),
            Nav::Back => return self.back(screen),
            Nav::Choose => return self.choose(item, settings, facts),
        }
        None
    }

    /// A key or button that came while one was waited for. One of the other kind of device ends the wait.
    pub fn give(&mut self, input: Input, settings: &mut Settings) {
        let Some(Wait { deed, column, .. }) = self.wait.take() else {
            return;
        };
        let bindings = &mut settings.controls.bindings;
        let taken = match input {
            Input::Key(key) if column < BUTTON_COLUMN => bindings.set_key(deed, column, Some(key)),
            Input::Button(button) if column == BUTTON_COLUMN => {
                bindings.set_button(deed, Some(button))
            }
            _ => false,
        };
        self.events.push(if taken {
            MenuEvent::Changed
        } else {
            MenuEvent::Refused
        });
    }

    /// Opens a page over the one that is open.
    pub fn enter(&mut self, screen: Screen) {
        // What gives something up must be gone to.
        let focus = usize::from(matches!(screen, Screen::Confirm(_)));
        self.pages.push(Page { screen, focus });
        (self.age, self.pushed, self.column) = (0.0, 0.0, 0);
    }

    fn stop_waiting(&mut self) {
        self.wait = None;
        self.events.push(MenuEvent::Refused);
    }

    fn move_to(&mut self, index: usize) {
        if let Some(page) = self.pages.last_mut()
            && page.focus != index
        {
            page.focus = index;
            self.events.push(MenuEvent::Moved);
        }
    }

    fn move_column(&mut self, column: usize) {
        if self.column != column && column <= BUTTON_COLUMN {
            self.column = column;
            self.events.push(MenuEvent::Moved);
        }
    }

    /// Left and right change a value, or walk along the table.
    fn sideways(&mut self, item: Item, right: bool, settings: &mut Settings) {
        if let Item::Bind(_) = item {
            let columns = BUTTON_COLUMN + 1;
            let step = if right { 1 } else { columns - 1 };
            self.move_column((self.column + step) % columns);
        } else if values::step(item, settings, right) {
            self.events.push(MenuEvent::Changed);
        }
    }

    /// Takes a key or button away.
    fn clear(&mut self, item: Item, settings: &mut Settings) {
        let Item::Bind(deed) = item else { return };
        let bindings = &mut settings.controls.bindings;
        match self.column {
            BUTTON_COLUMN => bindings.set_button(deed, None),
            slot => bindings.set_key(deed, slot, None),
        };
        self.events.push(MenuEvent::Changed);
    }

    /// One page back; from the pause that is the game, from the title nowhere, from the results the title.
    fn back(&mut self, screen: Screen) -> Option<Command> {
        match screen {
            Screen::Title => return None,
            Screen::Results if self.pages.len() == 1 => {
                self.events.push(MenuEvent::Back);
                return Some(Command::ToTitle);
            }
            _ => {}
        }
        self.events.push(MenuEvent::Back);
        if self.pages.len() == 1 {
            // A page that was opened alone leads to the game.
            return Some(Command::Resume);
        }
        self.pages.pop();
        (self.age, self.column) = (0.0, 0);
        None
    }

    fn choose(&mut self, item: Item, settings: &mut Settings, facts: &Facts) -> Option<Command> {
        if item == Item::Back {
            return self.back(self.screen()?);
        }
        let page = |item| {
            Some(match item {
                Item::Settings => Screen::Settings,
                Item::Credits => Screen::Credits,
                Item::Video => Screen::Video,
                Item::Audio => Screen::Audio,
                Item::Controls => Screen::Controls,
                Item::Access => Screen::Access,
                Item::Restart => Screen::Confirm(Question::Restart),
                Item::ResetControls => Screen::Confirm(Question::ResetControls),
                Item::NewGame if facts.levels.len() > 1 => Screen::Levels,
                Item::NewGame if facts.has_run => Screen::Confirm(Question::NewGame(0)),
                Item::Level(level) if facts.has_run => Screen::Confirm(Question::NewGame(level)),
                _ => return None,
            })
        };
        if let Some(screen) = page(item) {
            self.events.push(MenuEvent::Chosen);
            self.enter(screen);
            return None;
        }
        if let Item::Bind(deed) = item {
            self.events.push(MenuEvent::Chosen);
            let (column, left) = (self.column, PATIENCE);
            self.wait = Some(Wait { deed, column, left });
            return None;
        }
        if matches!(values::value(item, settings), Value::Scale(..)) {
            return None; // a scale has two directions: neither is the one that is meant
        }
        if values::step(item, settings, true) {
            self.events.push(MenuEvent::Changed);
            return None;
        }
        let command = self.command(item, settings);
        self.events.push(match (command, item) {
            (None, item) if item != Item::Yes => MenuEvent::Refused,
            _ => MenuEvent::Chosen,
        });
        command
    }

    /// What an entry asks of the game.
    fn command(&mut self, item: Item, settings: &mut Settings) -> Option<Command> {
        Some(match item {
            Item::Continue => Command::Continue,
            Item::NewGame => Command::Begin(0),
            Item::Level(level) => Command::Begin(level),
            Item::Resume => Command::Resume,
            Item::Retry => Command::Retry,
            Item::Again => Command::Restart,
            Item::ToTitle => Command::ToTitle,
            Item::Quit => Command::Quit,
            Item::Yes => match self.screen()? {
                Screen::Confirm(Question::NewGame(level)) => Command::Begin(level),
                Screen::Confirm(Question::Restart) => Command::Restart,
                _ => {
                    values::reset_controls(settings);
                    self.pages.pop();
                    return None;
                }
            },
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests;
