//! Reached is reached.

use super::story::{anew, back, hall, run, told};

/// A goal over a pit with spikes, which comes 1 m before them.
const GATE: &str = "(version: 1, name: \"gate\", start: (0, 0), goal: (min: (900, 0), max: (901, 1)), bottom: -40, \
    features: [(id: \"floor\", outline: [(-20,-2),(3,-2),(3,0),(-20,0)]),(id: \"pit\", outline: [(3,-4),(12,-4),(12,-3),(3,-3)]), \
    (id: \"gate\", kind: Goal, outline: [(5,-1),(6,-1),(6,4),(5,4)]), \
    (id: \"spikes\", kind: Hazard, outline: [(3,-3),(12,-3),(12,-2),(3,-2)])])";

#[test]
fn no_death_takes_the_goal_back() {
    let story = told(GATE, &[(8, run(1)), (30, run(0))]);
    let won = story.last.won_at.unwrap();
    assert!((0.5..0.8).contains(&won), "{won}");
    assert_eq!((story.last.deaths, &story.returns[..]), (0, &[][..]));
    // The whole run in one tick or in a thousand.
    assert_eq!(story.last.run_time(), won);
}

#[test]
fn going_back_takes_nothing_back_and_a_new_run_does() {
    let story = told(GATE, &[(8, run(1)), (1, back()), (1, run(0)), (1, back())]);
    assert!(story.last.won_at.is_some());
    assert_eq!(story.last.deaths, 0);
    let story = told(GATE, &[(8, run(1)), (1, anew()), (1, run(0))]);
    assert_eq!((story.last.won_at, story.last.began_at), (None, 0.8));
}

#[test]
fn behind_the_goal_nothing_is_counted_any_more() {
    let places = "(id: \"gate\", kind: Goal, outline: [(2,0),(3,0),(3,2),(2,2)]), \
        (id: \"cave\", kind: Secret, outline: [(5,0),(6,0),(6,2),(5,2)]), \
        (id: \"camp\", kind: Checkpoint, respawn: Some((8,0)), outline: [(7,0),(8,0),(8,2),(7,2)]), \
        (id: \"more\", kind: Goal, outline: [(9,0),(10,0),(10,2),(9,2)]),";
    let story = told(&hall(places, ""), &[(20, run(1))]);
    assert!(story.last.position.x > 10.0);
    assert!(story.last.won_at.unwrap() < 0.4);
    assert_eq!((story.last.secrets, story.last.checkpoint), (0, None));
}

#[test]
fn who_reaches_the_goal_and_thorns_at_one_time_has_reached_it() {
    let places = "(id: \"thorns\", kind: Hazard, outline: [(2,0),(3,0),(3,2),(2,2)]), \
        (id: \"gate\", kind: Goal, outline: [(2,0),(3,0),(3,2),(2,2)]),";
    let story = told(&hall(places, ""), &[(10, run(1))]);
    assert_eq!(story.last.deaths, 0);
    assert!(story.last.won_at.is_some());
}
