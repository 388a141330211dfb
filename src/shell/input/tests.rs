//! Keys without a window: what is held, pressed, tapped, toggled.

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
fn keys_do_what_they_are_given_and_what_they_are_given_asks_for_nothing_else() {
    let mut hands = Hands::default();
    assert!(hands.bindings.set_key(Deed::Jump, 0, Some(Scancode::P)));
    let mut controls = Controls::default();
    assert_eq!(
        controls.handle(&key(Scancode::P, true), false),
        Some(Action::Hold)
    );
    controls.set(&hands, Hold::Hold, Hold::Hold);
    assert_eq!(controls.handle(&key(Scancode::P, true), false), None);
    assert!(controls.take().jump);
    assert_eq!(
        controls.handle(&key(Scancode::Escape, true), false),
        Some(Action::Pause)
    );
}

#[test]
fn crouching_is_held_or_toggled() {
    let mut held = controls(&[(Scancode::C, true)]);
    assert!(held.take().down);
    held.handle(&key(Scancode::C, false), false);
    assert!(!held.take().down);
    let mut toggled = Controls::default();
    toggled.set(&Hands::default(), Hold::Toggle, Hold::Hold);
    let mut tap = |code| {
        toggled.handle(&key(code, true), false);
        toggled.handle(&key(code, false), false);
        toggled.take().down
    };
    assert_eq!(
        [Scancode::C, Scancode::C, Scancode::C].map(&mut tap),
        [true, false, true]
    );
    assert!(!tap(Scancode::Space), "a jump ends it");
    assert!(tap(Scancode::C) && !tap(Scancode::R), "so does going back");
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
fn going_back_is_asked_for_once_per_press() {
    let mut back = controls(&[(Scancode::R, true)]);
    assert!(back.take().respawn);
    assert!(!back.take().respawn);
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

#[test]
fn running_and_climbing_are_held_or_toggled() {
    let mut controls = Controls::default();
    controls.set(&Hands::default(), Hold::Hold, Hold::Toggle);
    let mut tap = |code| {
        controls.handle(&key(code, true), false);
        controls.handle(&key(code, false), false);
        let Input { run, up, down, .. } = controls.take();
        (run, up, down, controls.look())
    };
    assert_eq!(tap(Scancode::D), (127, false, false, 0.0));
    assert_eq!(
        tap(Scancode::Space),
        (127, false, false, 0.0),
        "a jump goes on"
    );
    assert_eq!(tap(Scancode::A), (-127, false, false, 0.0), "the other way");
    assert_eq!(
        tap(Scancode::W),
        (0, true, false, 1.0),
        "up, and no longer aside"
    );
    assert_eq!(
        tap(Scancode::W),
        (0, false, false, 0.0),
        "once more ends it"
    );
    assert_eq!(tap(Scancode::S), (0, false, true, 0.0));
    assert_eq!(
        tap(Scancode::R),
        (0, false, false, 0.0),
        "so does going back"
    );
}
