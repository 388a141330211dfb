//! One death is one; the place of return is waited for at an exact time.

use super::hall::block;
use super::story::{RATES, Story, anew, back, hall, play, run, stage, told};
use edgewalker::game::{Back, Edit, Input, Stage, World};
use edgewalker::level::Kind;
use glam::DVec2;
use std::sync::Arc;

/// Height and half the width of the standing hero, m.
const TALL: f64 = 109.0 / 64.0;
const HALF: f64 = 13.0 / 32.0;

/// He has died once and come back once, at this time.
fn once(story: &Story, at: f64) {
    assert_eq!(story.last.deaths, 1, "{story:?}");
    assert_eq!(story.returns.len(), 1, "{story:?}");
    let late = story.returns[0] - at;
    assert!(late.abs() < 1e-12, "{late:e} s after {at}");
    assert_eq!(story.last.away, None);
}

const CAMP: &str =
    "(id: \"camp\", kind: Checkpoint, respawn: Some((0,0)), outline: [(-1,0),(1,0),(1,2),(-1,2)]),";

#[test]
fn who_falls_while_the_start_is_closed_dies_once_and_waits() {
    let level = "(version: 1, name: \"lift\", start: (0, 0), goal: (min: (900, 0), max: (901, 1)), bottom: -4, \
        features: [(id: \"far\", outline: [(30,-3),(40,-3),(40,-2),(30,-2)])], \
        movers: [(id: \"lift\", features: [(id: \"deck\", outline: [(-2,-0.5),(2,-0.5),(2,0),(-2,0)])], \
        path: [(at: (0,0), wait: 0.5, seconds: 1, easing: Eased),(at: (0,1), wait: 2, seconds: 1, easing: Eased)])])";
    let story = told(level, &[(9, run(0)), (7, run(1)), (31, run(0))]);
    once(&story, 4.5);
    assert_eq!(story.last.position, DVec2::ZERO);
    // Half a second later the deck takes him up.
    let story = told(level, &[(9, run(0)), (7, run(1)), (46, run(0))]);
    once(&story, 4.5);
    assert_eq!(story.last.position, DVec2::Y);
}

#[test]
fn a_press_over_the_start_kills_once_and_lets_him_back_under_it() {
    let press = "(id: \"press\", features: [(id: \"p\", outline: [(-3,4),(3,4),(3,7),(-3,7)])], \
        path: [(at: (0,0), wait: 0.3, seconds: 1),(at: (0,-3.5), wait: 0.5, seconds: 1)])";
    let down = Input {
        down: true,
        ..Input::default()
    };
    let story = told(&hall("", press), &[(13, down), (12, run(0))]);
    once(&story, 1.8 + (TALL - 0.5) / 3.5);
    // What is held counts as soon as he is there, and from that very time.
    let story = told(&hall("", press), &[(13, down), (9, run(1))]);
    once(&story, 1.8 + (TALL - 0.5) / 3.5);
    let ran = story.last.position.x;
    let expected = 40.0 * (2.2 - story.returns[0]).powi(2);
    assert!((ran - expected).abs() < 1e-12, "{ran} {expected}");
}

#[test]
fn a_checkpoint_under_a_press_stays_his() {
    let press = "(id: \"press\", features: [(id: \"p\", outline: [(-1,4),(1,4),(1,7),(-1,7)])], \
        path: [(at: (0,0), wait: 1.5, seconds: 1),(at: (0,-3), wait: 0.5, seconds: 1)])";
    let text = hall(CAMP, press).replace("start: (0, 0)", "start: (-6, 0)");
    let story = told(&text, &[(7, run(1)), (30, run(0))]);
    once(&story, 3.0 + (TALL - 1.0) / 3.0);
    assert_eq!(story.last.checkpoint, Some(DVec2::ZERO));
    assert_eq!(story.last.position, DVec2::ZERO);
}

#[test]
fn a_checkpoint_that_is_covered_for_a_moment_is_waited_for() {
    let block = "(id: \"block\", features: [(id: \"b\", outline: [(3,0.01),(9,0.01),(9,4),(3,4)])], \
        path: [(at: (0,0), wait: 1.5, seconds: 1),(at: (-6,0), wait: 3, seconds: 1)])";
    let text = hall(CAMP, block).replace("start: (0, 0)", "start: (-6, 0)");
    let script = [
        (7, run(1)),
        (8, run(-1)),
        (15, run(0)),
        (1, back()),
        (35, run(0)),
    ];
    let story = told(&text, &script);
    once(&story, 5.5 + (3.0 + HALF) / 6.0);
    assert_eq!(story.last.position, DVec2::ZERO);
    // While he waits he is not there: asking again changes nothing, and nothing strikes him.
    let mut asks = script[..4].to_vec();
    asks.extend([
        (1, run(0)),
        (1, back()),
        (1, run(0)),
        (1, back()),
        (31, run(0)),
    ]);
    assert_eq!(told(&text, &asks).last, story.last);
}

/// A stone that is thrown over the camp after a second and a half and stays.
fn stone(at: f64) -> String {
    format!(
        "(id: \"stone {at}\", features: [(id: \"s{at}\", outline: [({0},6),({1},6),({1},8),({0},8)])], \
         path: [(at: (0,0), wait: 1.5, seconds: 0.5),(at: (0,-6))], repeat: Once)",
        at - 1.0,
        at + 1.0
    )
}

fn camp(at: f64) -> String {
    format!(
        "(id: \"camp {at}\", kind: Checkpoint, respawn: Some(({at},0)), outline: [({0},0),({1},0),({1},2),({0},2)]),",
        at - 0.5,
        at + 0.5
    )
}

#[test]
fn a_place_that_is_closed_for_ever_makes_way_for_an_earlier_one() {
    let camps = format!("{}{}", camp(3.0), camp(6.0));
    let script = [(11, run(1)), (11, run(0)), (1, back()), (2, run(0))];
    let at = |movers: &str| {
        let story = told(&hall(&camps, movers), &script);
        once(&story, 2.2);
        (story.last.position.x, story.last.returned.unwrap().back)
    };
    assert_eq!(at(""), (6.0, Back::Last));
    assert_eq!(at(&stone(6.0)), (3.0, Back::Earlier));
    let both = format!("{},{}", stone(6.0), stone(3.0));
    assert_eq!(at(&both), (0.0, Back::Start));
    // Where not even the start can be free again, all that moves begins anew. The last camp is free then, but it is too late.
    let all = format!("{both},{}", stone(0.0));
    let story = told(&hall(&camps, &all), &script);
    once(&story, 2.2);
    let place = story.last.returned.unwrap().back;
    assert_eq!((story.last.position, place), (DVec2::ZERO, Back::Anew));
    assert!(story.offsets.iter().all(|o| *o == DVec2::ZERO), "{story:?}");
    // The last camp stays his, though he came back at an earlier one and stands in that.
    let script = [&script[..], &[(1, back()), (1, run(0))]].concat();
    let story = told(&hall(&camps, &stone(6.0)), &script);
    assert_eq!(story.last.checkpoint, Some(DVec2::new(6.0, 0.0)));
    assert_eq!((story.last.deaths, story.last.position.x), (2, 3.0));
}

#[test]
fn ten_seconds_are_waited_for_and_not_more() {
    // Closed from 2 s on, for 9 or 12 s.
    let gate = |closed: f64| {
        format!(
            "(id: \"gate\", features: [(id: \"g\", outline: [(5,6),(7,6),(7,8),(5,8)])], \
             path: [(at: (0,0), wait: 1.5, seconds: 0.5),(at: (0,-6), wait: {closed}, seconds: 0.5)])"
        )
    };
    let camps = format!("{}{}", camp(3.0), camp(6.0));
    let script = [(11, run(1)), (11, run(0)), (1, back()), (100, run(0))];
    let story = told(&hall(&camps, &gate(9.0)), &script);
    once(&story, 11.0 + 0.5 * TALL / 6.0);
    assert_eq!(story.last.position.x, 6.0);
    let story = told(&hall(&camps, &gate(12.0)), &script);
    once(&story, 2.2);
    assert_eq!(story.last.position.x, 3.0);
    // The start is waited for longer: there is no other place.
    let only = hall("", &gate(12.0)).replace("start: (0, 0)", "start: (6, 0)");
    let story = told(
        &only,
        &[(4, run(-1)), (18, run(0)), (1, back()), (130, run(0))],
    );
    once(&story, 14.0 + 0.5 * TALL / 6.0);
}

/// A stone that had set out before he came to the camp comes back by itself, which is foreseen.
#[test]
fn what_turns_round_by_itself_is_waited_for() {
    let button = "(id: \"button\", kind: Trigger, outline: [(-1,0),(1,0),(1,1),(-1,1)]),";
    let stone = "(id: \"stone\", features: [(id: \"s\", outline: [(5,6),(7,6),(7,8),(5,8)])], \
        path: [(at: (0,0), wait: 1.5, seconds: 0.5),(at: (0,-6))], repeat: Once, starts: On(\"button\"), back: Some(2))";
    let script = [(11, run(1)), (11, run(0)), (1, back()), (40, run(0))];
    let story = told(&hall(&format!("{button}{}", camp(6.0)), stone), &script);
    once(&story, 4.0 + 0.5 * TALL / 6.0);
    assert_eq!(story.last.returned.unwrap().back, Back::Last);
    assert_eq!((story.last.position.x, story.offsets[0].y), (6.0, 0.0));
}

#[test]
fn a_gap_too_short_to_live_in_is_none() {
    // A hammer that is off the place for a hundredth of a second, and after some blows for a second.
    let blow = "(at: (0,-6), wait: 0.4, seconds: 0.1),(at: (0,-4.29), seconds: 0.1),";
    let hammer = format!(
        "(id: \"hammer\", features: [(id: \"h\", outline: [(5,6),(7,6),(7,8),(5,8)])], \
         path: [(at: (0,0), wait: 1.9, seconds: 0.1),{}(at: (0,-6), wait: 1, seconds: 0.5)])",
        blow.repeat(3)
    );
    let script = [(11, run(1)), (11, run(0)), (1, back()), (40, run(0))];
    let story = told(&hall(&camp(6.0), &hammer), &script);
    // Three blows of 0.6 s, then the long rest, then up by 6 m in half a second.
    once(&story, 2.0 + 3.0 * 0.6 + 1.0 + 0.5 * TALL / 6.0);
}

#[test]
fn a_place_that_kills_is_not_free() {
    // The camp is not there when the level is read: thorns come over it as he plays.
    let stage = stage(&hall(&format!("{}{}", camp(3.0), camp(6.0)), ""));
    for rate in RATES {
        let mut world = World::new(Arc::clone(&stage), rate, 0);
        play(&mut world, &[(11, run(1)), (5, run(0))]);
        let thorns = block("thorns", Kind::Hazard, (5.5, 0.0), (6.5, 1.0));
        world.edit(Edit::Insert(thorns)).unwrap();
        let story = play(&mut world, &[(1, back()), (2, run(0))]);
        once(&story, 1.6);
        let place = story.last.returned.unwrap().back;
        assert_eq!((story.last.position.x, place), (3.0, Back::Earlier));
    }
    // At the start it is refused.
    let mut level = stage.level.clone();
    level
        .features
        .push(block("thorns", Kind::Hazard, (-0.5, 0.0), (0.5, 1.0)));
    let error = Stage::build(level).unwrap_err();
    assert_eq!(
        error.to_string(),
        "start: the hero would die there, in feature \"thorns\""
    );
}

#[test]
fn asking_to_go_back_is_one_death_however_long_it_is_asked() {
    let text = hall(&camp(3.0), "");
    let story = told(&text, &[(9, run(1)), (5, back()), (3, run(0))]);
    assert_eq!((story.last.deaths, story.last.position.x), (1, 3.0));
    let twice = [(9, run(1)), (5, back()), (1, run(0)), (1, back())];
    assert_eq!(told(&text, &twice).last.deaths, 2);
}

#[test]
fn a_new_run_begins_at_once_also_out_of_a_wait() {
    let press = "(id: \"press\", features: [(id: \"p\", outline: [(-3,4),(3,4),(3,7),(-3,7)])], \
        path: [(at: (0,0), wait: 0.3, seconds: 1),(at: (0,-3.5), wait: 0.5, seconds: 1)])";
    let script = [(15, run(0)), (1, anew()), (1, run(0))];
    let story = told(&hall("", press), &script);
    let view = story.last;
    assert_eq!((view.deaths, view.began_at, view.away), (0, 1.5, None));
    assert_eq!(view.position, DVec2::ZERO);
    assert_eq!(story.offsets, [DVec2::ZERO], "all that moves begins anew");
}

#[test]
fn a_wait_survives_a_snapshot_and_an_edit() {
    let press = "(id: \"press\", features: [(id: \"p\", outline: [(-3,4),(3,4),(3,7),(-3,7)])], \
        path: [(at: (0,0), wait: 0.3, seconds: 1),(at: (0,-3.5), wait: 0.5, seconds: 1)])";
    let stage = stage(&hall("", press));
    let mut world = World::new(Arc::clone(&stage), 120, 0);
    play(&mut world, &[(16, run(0))]);
    let away = world.view().away.unwrap();
    assert!((away.until.unwrap() - 2.14375).abs() < 1e-12);
    let text = ron::to_string(&world.snapshot()).unwrap();
    let mut again = World::restore(stage, ron::from_str(&text).unwrap()).unwrap();
    play(&mut world, &[(9, run(1))]);
    play(&mut again, &[(9, run(1))]);
    assert_eq!(again.hash(), world.hash());
    assert_eq!(world.view().away, None);
}
