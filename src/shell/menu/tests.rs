//! The menus without a window: every entry by directions alone, what choosing does, waits for keys.

use super::prompts::Device;
use super::*;
use crate::shell::settings::bindings;
use sdl2::controller::Button;
use sdl2::keyboard::Scancode;

fn facts(has_run: bool, levels: &[&str]) -> Facts {
    Facts {
        has_run,
        levels: levels.iter().map(|name| (*name).to_owned()).collect(),
        results: Some(Results::default()),
        ..Facts::default()
    }
}

fn menu(screen: Screen) -> Menu {
    let mut menu = Menu::default();
    menu.open(screen);
    menu
}

/// Moves down to an entry, as a hand would; how many steps it took.
fn go_to(menu: &mut Menu, item: Item, settings: &mut Settings, facts: &Facts) -> usize {
    let count = entries(menu.screen().unwrap(), facts).len();
    for steps in 0..=count {
        if menu.focused(facts) == Some(item) {
            return steps;
        }
        assert_eq!(menu.act(Nav::Down, settings, facts), None);
    }
    panic!("{item:?} is not reached");
}

/// Chooses every entry of a page, then those of the pages that it opens; notes what was seen.
fn explore(menu: &Menu, facts: &Facts, seen: &mut Vec<Item>, commands: &mut Vec<Command>) {
    let screen = menu.screen().unwrap();
    for item in entries(screen, facts) {
        let (mut menu, mut settings) = (menu.clone(), Settings::default());
        if screen != Screen::Credits {
            go_to(&mut menu, item, &mut settings, facts);
        }
        let depth = menu.pages.len();
        menu.take_events();
        let command = menu.act(Nav::Choose, &mut settings, facts);
        let events = menu.take_events();
        let is_scale = matches!(values::value(item, &settings), Value::Scale(..));
        assert_eq!(
            events.len(),
            usize::from(!is_scale),
            "{screen:?} {item:?}: {events:?}"
        );
        assert!(!events.contains(&MenuEvent::Refused), "{screen:?} {item:?}");
        commands.extend(command);
        // Of the sliders and switches each has another value somewhere to the left.
        if !matches!(values::value(item, &settings), Value::None | Value::Keys) {
            let before = settings.clone();
            menu.act(Nav::Left, &mut settings, facts);
            assert_ne!(settings, before, "{item:?}");
        }
        let is_new = !seen.contains(&item);
        seen.push(item);
        if menu.pages.len() > depth && is_new {
            explore(&menu, facts, seen, commands);
        }
    }
}

#[test]
fn every_entry_is_reached_and_does_something() {
    let facts = facts(true, &["One", "Two"]);
    let (mut seen, mut commands) = (Vec::new(), Vec::new());
    for screen in [Screen::Title, Screen::Pause, Screen::Results] {
        explore(&menu(screen), &facts, &mut seen, &mut commands);
    }
    for command in [
        Command::Continue,
        Command::Begin(1),
        Command::Resume,
        Command::Retry,
        Command::Restart,
        Command::ToTitle,
        Command::Quit,
    ] {
        assert!(commands.contains(&command), "{command:?}: {commands:?}");
    }
    for deed in Deed::ALL {
        assert!(seen.contains(&Item::Bind(deed)), "{deed:?}");
    }
    for item in [
        Item::Level(1),
        Item::Preset,
        Item::Music,
        Item::Contrast,
        Item::LookDeadZone,
    ] {
        assert!(seen.contains(&item), "{item:?}: {seen:?}");
    }
}

#[test]
fn the_focus_goes_round() {
    let (facts, mut settings) = (facts(false, &["One"]), Settings::default());
    let mut menu = menu(Screen::Title);
    assert_eq!(menu.focused(&facts), Some(Item::NewGame));
    menu.act(Nav::Up, &mut settings, &facts);
    assert_eq!(menu.focused(&facts), Some(Item::Quit));
    menu.act(Nav::Down, &mut settings, &facts);
    assert_eq!(menu.focused(&facts), Some(Item::NewGame));
    assert_eq!(menu.take_events(), [MenuEvent::Moved, MenuEvent::Moved]);
}

#[test]
fn going_back_leads_out_of_every_page() {
    let (facts, mut settings) = (facts(true, &["One"]), Settings::default());
    let mut menu = menu(Screen::Pause);
    go_to(&mut menu, Item::Settings, &mut settings, &facts);
    menu.act(Nav::Choose, &mut settings, &facts);
    go_to(&mut menu, Item::Audio, &mut settings, &facts);
    menu.act(Nav::Choose, &mut settings, &facts);
    assert_eq!(menu.screen(), Some(Screen::Audio));
    assert_eq!(menu.act(Nav::Back, &mut settings, &facts), None);
    assert_eq!(menu.focused(&facts), Some(Item::Audio), "where it was left");
    assert_eq!(menu.act(Nav::Back, &mut settings, &facts), None);
    assert_eq!(
        menu.act(Nav::Back, &mut settings, &facts),
        Some(Command::Resume)
    );
    let mut title = self::menu(Screen::Title);
    assert_eq!(title.act(Nav::Back, &mut settings, &facts), None);
    assert_eq!(title.screen(), Some(Screen::Title));
    let mut results = self::menu(Screen::Results);
    assert_eq!(
        results.act(Nav::Back, &mut settings, &facts),
        Some(Command::ToTitle)
    );
}

#[test]
fn a_run_is_not_given_up_by_a_slip() {
    let (facts, mut settings) = (facts(true, &["One"]), Settings::default());
    let mut menu = menu(Screen::Title);
    go_to(&mut menu, Item::NewGame, &mut settings, &facts);
    assert_eq!(menu.act(Nav::Choose, &mut settings, &facts), None);
    assert_eq!(menu.focused(&facts), Some(Item::Back));
    let mut again = menu.clone();
    assert_eq!(menu.act(Nav::Choose, &mut settings, &facts), None);
    assert_eq!(menu.screen(), Some(Screen::Title));
    again.act(Nav::Up, &mut settings, &facts);
    assert_eq!(
        again.act(Nav::Choose, &mut settings, &facts),
        Some(Command::Begin(0))
    );
}

#[test]
fn without_a_run_a_new_game_begins_at_once_and_levels_are_chosen_if_there_are_several() {
    let mut settings = Settings::default();
    let one = facts(false, &["One"]);
    assert_eq!(
        menu(Screen::Title).act(Nav::Choose, &mut settings, &one),
        Some(Command::Begin(0))
    );
    let two = facts(false, &["One", "Two"]);
    let mut menu = menu(Screen::Title);
    assert_eq!(menu.act(Nav::Choose, &mut settings, &two), None);
    assert_eq!(menu.screen(), Some(Screen::Levels));
    menu.act(Nav::Down, &mut settings, &two);
    assert_eq!(
        menu.act(Nav::Choose, &mut settings, &two),
        Some(Command::Begin(1))
    );
}

/// The controls' table with a wait for what shall jump, in a column.
fn waiting(column: usize) -> (Menu, Settings, Facts) {
    let (facts, mut settings) = (facts(false, &["One"]), Settings::default());
    let mut menu = menu(Screen::Controls);
    go_to(&mut menu, Item::Bind(Deed::Jump), &mut settings, &facts);
    for _ in 0..column {
        menu.act(Nav::Right, &mut settings, &facts);
    }
    menu.act(Nav::Choose, &mut settings, &facts);
    assert_eq!(
        menu.wait().map(|wait| (wait.deed, wait.column)),
        Some((Deed::Jump, column))
    );
    menu.take_events();
    (menu, settings, facts)
}

#[test]
fn a_key_and_a_button_are_given() {
    let (mut menu, mut settings, _) = waiting(1);
    menu.give(bindings::Input::Key(Scancode::J), &mut settings);
    let bindings = &settings.controls.bindings;
    assert_eq!(
        bindings.keys(Deed::Jump),
        [Some(Scancode::Space), Some(Scancode::J)]
    );
    assert_eq!(
        (menu.wait(), menu.take_events()),
        (None, vec![MenuEvent::Changed])
    );
    let (mut menu, mut settings, _) = waiting(BUTTON_COLUMN);
    menu.give(bindings::Input::Button(Button::Y), &mut settings);
    assert_eq!(
        settings.controls.bindings.button(Deed::Jump),
        Some(Button::Y)
    );
}

#[test]
fn a_wait_ends_by_going_back_by_the_wrong_device_by_a_fixed_key_and_by_time() {
    let unchanged = |menu: &mut Menu, settings: &Settings| {
        assert_eq!((menu.wait(), settings), (None, &Settings::default()));
        assert_eq!(menu.take_events(), [MenuEvent::Refused]);
    };
    let (mut menu, mut settings, facts) = waiting(0);
    menu.act(Nav::Back, &mut settings, &facts);
    unchanged(&mut menu, &settings);
    assert_eq!(menu.screen(), Some(Screen::Controls));
    let (mut menu, mut settings, _) = waiting(0);
    menu.give(bindings::Input::Button(Button::Y), &mut settings);
    unchanged(&mut menu, &settings);
    let (mut menu, mut settings, _) = waiting(0);
    menu.give(bindings::Input::Key(Scancode::F1), &mut settings);
    unchanged(&mut menu, &settings);
    let (mut menu, settings, _) = waiting(0);
    menu.advance(PATIENCE + 0.1);
    unchanged(&mut menu, &settings);
}

#[test]
fn keys_are_taken_away_and_come_back() {
    let (facts, mut settings) = (facts(false, &["One"]), Settings::default());
    let mut menu = menu(Screen::Controls);
    go_to(&mut menu, Item::Bind(Deed::Jump), &mut settings, &facts);
    menu.act(Nav::Clear, &mut settings, &facts);
    assert_eq!(
        settings.controls.bindings.keys(Deed::Jump),
        [None, Some(Scancode::Z)]
    );
    menu.act(Nav::Left, &mut settings, &facts); // round to the buttons
    menu.act(Nav::Clear, &mut settings, &facts);
    assert_eq!(settings.controls.bindings.button(Deed::Jump), None);
    go_to(&mut menu, Item::ResetControls, &mut settings, &facts);
    menu.act(Nav::Choose, &mut settings, &facts);
    menu.act(Nav::Up, &mut settings, &facts);
    assert_eq!(menu.act(Nav::Choose, &mut settings, &facts), None);
    assert_eq!(settings, Settings::default());
    assert_eq!(menu.screen(), Some(Screen::Controls));
}

#[test]
fn every_device_has_a_name_of_its_own() {
    let mut devices: Vec<Device> = Vec::new();
    for name in crate::cli::DEVICES {
        let device = Device::named(name).unwrap();
        assert!(!devices.contains(&device), "{name}");
        devices.push(device);
    }
}

/// The pointer finds each entry where it is drawn, on wide and on tall pictures.
#[test]
fn the_pointer_finds_every_entry() {
    let facts = facts(true, &["One", "Two"]);
    for name in crate::cli::SCREENS {
        let screen = Screen::named(name).unwrap();
        let menu = menu(screen);
        for size in [
            [1280.0, 720.0],
            [1920.0, 1080.0],
            [800.0, 1000.0],
            [3440.0, 1440.0],
            [320.0, 200.0],
        ] {
            let layout = layout::Layout::of(&menu, &facts, size).unwrap();
            for (index, row) in layout.rows.iter().enumerate() {
                let [x, y, width, height] = row.rect;
                let found = layout.under([x + width * 0.2, y + height / 2.0]);
                assert!(
                    matches!(found, Some(Nav::Point(i, _)) if i == index),
                    "{screen:?} {found:?}"
                );
                assert!(
                    x >= 0.0 && x + width <= size[0] && y + height <= size[1],
                    "{screen:?} {size:?}"
                );
            }
            assert_eq!(layout.under([size[0] - 1.0, 1.0]), None);
        }
    }
}
