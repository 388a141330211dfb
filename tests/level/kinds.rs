//! Kinds of features, their traits, and movers: what is read, and what is refused in which words.

use super::{mutants, survive};
use edgewalker::level::{
    self, By, Concave, Easing, End, Kind, Material, Mood, Repeat, Skill, Starts,
};
use std::path::Path;

/// A level with every kind of feature and every field.
const FULL: &str = r#"(
    version: 1,
    name: "Everything",
    start: (0, 0),
    goal: (min: (90, 0), max: (91, 2)),
    bottom: -10,
    features: [
        (id: "floor", material: Iron, conveyor: -2.5, friction: Some(0.5), concave: Some(Project),
         outline: [(-5, -1), (99, -1), (99, 0), (-5, 0)]),
        (id: "vine", climbable: true, outline: [(20, 0), (21, 0), (21, 9), (20, 9)]),
        (id: "plank", kind: OneWay, material: Timber, outline: [(3, 3), (5, 3), (6, 4)]),
        (id: "ladder", kind: Ladder, by: Some(Point(0, 1)), outline: [(9, 0), (10, 0), (10, 5), (9, 5)]),
        (id: "spikes", kind: Hazard, by: Some(Foot), outline: [(30, 0), (31, 0), (31, 1)]),
        (id: "camp", kind: Checkpoint, respawn: Some((41, 0)), outline: [(40, 0), (42, 0), (42, 3)]),
        (id: "gate", kind: Goal, by: Some(Middle), outline: [(50, 0), (51, 0), (51, 3)]),
        (id: "button", kind: Trigger, outline: [(60, 0), (61, 0), (61, 3)]), (id: "cave", kind: Secret, outline: [(65, 0), (66, 0), (66, 2)]),
    ],
    movers: [
        (
            id: "lift",
            features: [
                (id: "deck", outline: [(70, 0), (72, 0), (72, 1)]),
                (id: "rail", kind: OneWay, outline: [(70, 2), (72, 2)]),
            ],
            path: [
                (at: (0, 0), wait: 1.5, seconds: 2, easing: Eased),
                (at: (0, 5), seconds: 3),
            ],
        ),
        (
            id: "door",
            features: [(id: "leaf", outline: [(80, 0), (81, 0), (81, 4)])],
            path: [
                (at: (0, 0), seconds: 1),
                (at: (0, 4)),
            ],
            repeat: Once,
            starts: On("button"),
        ),
    ],
    areas: [
        (name: "The Rim", room: (min: (-20, -10), max: (50, 30)), mood: Dusk),
        (name: "The Works", room: (min: (50, -9), max: (99, 30)), mood: Depths),
    ],
    frames: [
        (room: (min: (60, 0), max: (70, 9)), at: Some((66, 4.5)), zoom: 0.75),
        (room: (min: (88, 1), max: (92, 9))),
    ],
    prompts: [
        (skill: WallJump, room: (min: (70, 0), max: (74, 8))),
    ],
)
"#;

fn complaint(from: &str, to: &str) -> String {
    assert_eq!(
        FULL.matches(from).count(),
        1,
        "the change must hit one place: {from}"
    );
    let text = FULL.replacen(from, to, 1);
    let error = level::parse(&text, Path::new("full.ron")).expect_err(to);
    error.to_string()
}

/// A place in the text, what is put there, and what is then said.
type Change = (&'static str, &'static str, &'static str);

fn refused(cases: &[Change]) {
    for (from, to, expected) in cases {
        assert_eq!(complaint(from, to), format!("full.ron:{expected}"));
    }
}

#[test]
fn every_field_arrives() {
    let level = level::parse(FULL, Path::new("full.ron")).unwrap();
    let [floor, vine, plank, ladder, spikes, camp, gate, button, cave] = &level.features[..] else {
        panic!("{} features", level.features.len());
    };
    assert_eq!(
        (floor.kind, floor.conveyor, floor.friction),
        (Kind::Solid, -2.5, Some(0.5))
    );
    assert_eq!(
        (floor.concave, floor.material),
        (Some(Concave::Project), Material::Iron)
    );
    assert!(vine.climbable && vine.material == Material::Rock && !plank.climbable);
    assert_eq!((plank.kind, plank.outline.len()), (Kind::OneWay, 3));
    assert_eq!(
        (ladder.by(), spikes.by(), camp.by()),
        (By::Point(0.0, 1.0), By::Foot, By::Body)
    );
    assert_eq!((gate.by(), button.by()), (By::Middle, By::Body));
    assert_eq!(camp.respawn.unwrap().x, 41.0);
    assert_eq!((cave.kind, cave.by()), (Kind::Secret, By::Body));
    let [rim, works] = &level.areas[..] else {
        panic!("{} areas", level.areas.len());
    };
    assert_eq!((rim.mood, works.mood), (Mood::Dusk, Mood::Depths));
    assert_eq!((works.name.as_str(), works.room.min.y), ("The Works", -9.0));
    let [machine, gate] = level.frames[..] else {
        panic!("{} frames", level.frames.len());
    };
    assert_eq!((machine.at.unwrap().y, machine.zoom), (4.5, 0.75));
    assert_eq!((gate.at, gate.zoom, gate.room.max.x), (None, 1.0, 92.0));
    let [told] = level.prompts[..] else {
        panic!("{} prompts", level.prompts.len());
    };
    assert_eq!((told.skill, told.room.max.y), (Skill::WallJump, 8.0));
    let [lift, door] = &level.movers[..] else {
        panic!("{} movers", level.movers.len());
    };
    assert_eq!(
        (lift.features.len(), lift.repeat, &lift.starts),
        (2, Repeat::Loop, &Starts::AtOnce)
    );
    assert_eq!(
        (lift.path[0].easing, lift.path[1].easing),
        (Easing::Eased, Easing::Linear)
    );
    assert_eq!((lift.path[0].wait, lift.path[1].seconds), (1.5, 3.0));
    assert_eq!(
        (door.repeat, &door.starts),
        (Repeat::Once, &Starts::On("button".into()))
    );
}

#[test]
fn a_plain_level_is_written_without_the_fields_that_it_does_not_use() {
    let level = level::load(Path::new("levels/dev/slopes.ron")).unwrap();
    let text = ron::to_string(&level).unwrap();
    for field in [
        "kind:Solid",
        "climbable",
        "conveyor",
        "friction",
        "movers",
        "areas",
        "frames",
        "prompts",
        "respawn",
        "by:",
    ] {
        assert!(!text.contains(field), "{field}");
    }
    let movers = level::parse(FULL, Path::new("full.ron")).unwrap().movers;
    let text = ron::to_string(&movers).unwrap();
    for field in ["back", "calls"] {
        assert!(!text.contains(field), "{field}");
    }
}

#[test]
fn every_kind_moves_and_movers_come_back_when_they_are_ridden_or_called() {
    let lift = r#"features: [(id: "shelf", outline: [(80, 0), (81, 0), (81, 4)]),
        (id: "chain", kind: Ladder, outline: [(83, 0), (84, 0), (84, 5)]),
        (id: "teeth", kind: Hazard, outline: [(80, -1), (81, -1), (81, 0)]),
        (id: "rest", kind: Checkpoint, respawn: Some((80, 5)), outline: [(80, 4), (81, 4), (81, 6)]),
        (id: "out", kind: Goal, outline: [(85, 0), (86, 0), (86, 1)]),
        (id: "cabin", kind: Trigger, outline: [(80, 4), (81, 4), (81, 6)]),
        (id: "nook", kind: Secret, outline: [(87, 0), (88, 0), (88, 1)])]"#;
    let plain = r#"features: [(id: "leaf", outline: [(80, 0), (81, 0), (81, 4)])]"#;
    let starts = r#"starts: On("button")"#;
    let ridden = r#"starts: Ridden, back: Some(2.5), calls: [(by: "cabin", to: First), (by: "button", to: Last)]"#;
    let text = FULL.replacen(plain, lift, 1).replacen(starts, ridden, 1);
    let level = level::parse(&text, Path::new("full.ron")).unwrap();
    let mover = &level.movers[1];
    assert_eq!(mover.features.len(), 7);
    assert_eq!((&mover.starts, mover.back), (&Starts::Ridden, Some(2.5)));
    let calls: Vec<_> = mover.calls.iter().map(|c| (c.by.as_str(), c.to)).collect();
    assert_eq!(calls, [("cabin", End::First), ("button", End::Last)]);
    let written = ron::to_string(&level).unwrap();
    assert_eq!(
        level::parse(&written, Path::new("full.ron")).unwrap(),
        level
    );
}

#[test]
fn lines_have_rules_of_their_own() {
    let line = "[(3, 3), (5, 3), (6, 4)]";
    let expected = |message: &str| format!("11: feature \"plank\", outline: {message}");
    for (to, message) in [
        ("[]", "a polyline needs 2 corners and this one has 0"),
        ("[(3, 3)]", "a polyline needs 2 corners and this one has 1"),
        (
            "[(3, 3), (3, 3), (6, 4)]",
            "edge 0 has no length (on the grid): (3, 3) to (3, 3)",
        ),
        (
            "[(3, 3), (6, 3), (5, 3)]",
            "the outline turns back on itself at corner 1: (6, 3)",
        ),
    ] {
        assert_eq!(
            complaint(line, to),
            format!("full.ron:{}", expected(message))
        );
    }
    let crossing = FULL.replacen(line, "[(3, 3), (6, 3), (6, 5), (4, 2)]", 1);
    level::parse(&crossing, Path::new("full.ron")).expect("a line may cross itself");
}

/// Fields of features that cannot be.
const BAD_TRAITS: &[Change] = &[
    (
        "-2.5",
        "NaN",
        "8: feature \"floor\", conveyor: NaN is outside -100..=100 m/s",
    ),
    (
        "-2.5",
        "101",
        "8: feature \"floor\", conveyor: 101 is outside -100..=100 m/s",
    ),
    (
        "-2.5",
        "1e300",
        "8: feature \"floor\", conveyor: 1e300 is outside -100..=100 m/s",
    ),
    (
        "Some(0.5)",
        "Some(-1)",
        "8: feature \"floor\", friction: -1 is outside 0..=10",
    ),
    (
        "kind: Hazard, by: Some(Foot)",
        "conveyor: 1, kind: Hazard",
        "13: feature \"spikes\", conveyor: means nothing for kind Hazard",
    ),
    (
        "kind: OneWay, material: Timber",
        "kind: OneWay, climbable: true",
        "11: feature \"plank\", climbable: means nothing for kind OneWay",
    ),
    (
        "climbable: true",
        "by: Some(Foot)",
        "10: feature \"vine\", by: means nothing for kind Solid",
    ),
    (
        "climbable: true",
        "respawn: Some((1, 1))",
        "10: feature \"vine\", respawn: means nothing for kind Solid",
    ),
    (
        "Point(0, 1)",
        "Point(0, inf)",
        "12: feature \"ladder\", by: Point(0, inf) is not within 64 m of the foot",
    ),
    (
        "respawn: Some((41, 0)), ",
        "",
        "14: feature \"camp\", respawn: is missing: a checkpoint says where the hero comes back",
    ),
    (
        "(41, 0)",
        "(41, NaN)",
        "14: feature \"camp\", respawn.y: NaN is not a finite number",
    ),
    (
        "(41, 0)",
        "(41, -0.5)",
        "14: feature \"camp\", respawn: the hero would stand inside feature \"floor\"",
    ),
    (
        "(41, 0)",
        "(41, -20)",
        "14: feature \"camp\", respawn: lies below the bottom, where the hero falls out of the level",
    ),
    (
        "(41, 0)",
        "(71, 0)",
        "14: feature \"camp\", respawn: the hero would stand inside feature \"deck\"",
    ),
    (
        "start: (0, 0)",
        "start: (30.9, 0.5)",
        "4: level, start: the hero would die in feature \"spikes\"",
    ),
    (
        "start: (0, 0)",
        "start: (50.9, 0)",
        "4: level, start: the hero would win at once in feature \"gate\"",
    ),
];

#[test]
fn traits_that_make_no_sense_are_refused() {
    refused(BAD_TRAITS);
    assert!(complaint("kind: Ladder", "kind: Stairs").starts_with(
        "full.ron:12: feature \"ladder\": Unexpected variant named `Stairs` in enum `Kind`"
    ));
}

/// Movers that cannot be.
const BAD_MOVERS: &[Change] = &[
    (
        "id: \"door\"",
        "id: \"lift\"",
        "31: mover \"lift\", id: is the id of movers[0] as well",
    ),
    (
        "id: \"leaf\"",
        "id: \"floor\"",
        "32: movers[1], feature \"floor\", id: is the id of features[0] as well",
    ),
    (
        "id: \"leaf\"",
        "id: \"deck\"",
        "32: movers[1], feature \"deck\", id: is the id of movers[0].features[0] as well",
    ),
    (
        "[(id: \"leaf\", outline: [(80, 0), (81, 0), (81, 4)])]",
        "[]",
        "32: mover \"door\", features: nothing moves: there are none",
    ),
    (
        "(70, 2), (72, 2)]",
        "(70, 2), (72, 2)], by: Some(Foot)",
        "23: movers[0], feature \"rail\", by: means nothing for kind OneWay",
    ),
    (
        "id: \"deck\"",
        "id: \"deck\", kind: Checkpoint",
        "22: movers[0], feature \"deck\", respawn: is missing: a checkpoint says where the hero comes back",
    ),
    (
        "id: \"deck\"",
        "id: \"deck\", kind: Checkpoint, respawn: Some((60, 3995))",
        "22: movers[0], feature \"deck\", respawn.y: at path[1], 4000 is out of bounds: coordinates are between -4000 and 4000 m",
    ),
    (
        "id: \"deck\"",
        "id: \"deck\", kind: Checkpoint, respawn: Some((81, 1))",
        "22: movers[0], feature \"deck\", respawn: the hero would stand inside feature \"leaf\"",
    ),
    (
        "id: \"deck\"",
        "id: \"deck\", kind: Checkpoint, respawn: Some((60, -11))",
        "22: movers[0], feature \"deck\", respawn: lies below the bottom, where the hero falls out of the level",
    ),
    (
        "id: \"lift\",",
        "id: \"lift\", back: Some(1),",
        "20: mover \"lift\", back: needs a path of two or more stops that is gone Once",
    ),
    (
        "id: \"lift\",",
        "id: \"lift\", calls: [(by: \"button\", to: Last)],",
        "20: mover \"lift\", calls: needs a path of two or more stops that is gone Once",
    ),
    (
        "repeat: Once",
        "repeat: Once, back: Some(-1)",
        "37: mover \"door\", back: -1 is outside 0..=3600 s",
    ),
    (
        "repeat: Once",
        "repeat: Once, calls: [(by: \"button\", to: First),\n (by: \"knob\", to: Last)]",
        "38: mover \"door\", calls[1].by: there is no feature \"knob\"",
    ),
    (
        "repeat: Once",
        "repeat: Once, calls: [(by: \"leaf\", to: First)]",
        "37: mover \"door\", calls[0].by: feature \"leaf\" is no Trigger",
    ),
    (
        "repeat: Once",
        "repeat: Once, calls: [(by: \"button\", to: Middle)]",
        "37: mover \"door\": Unexpected variant named `Middle` in enum `End`, expected either `First` or `Last` instead",
    ),
    (
        "(id: \"leaf\", outline: [(80, 0), (81, 0), (81, 4)])],\n            path: [\n                (at: (0, 0), seconds: 1),\n                (at: (0, 4)),\n            ],\n            repeat: Once,\n            starts: On(\"button\")",
        "(id: \"leaf\", kind: Hazard, outline: [(80, 0), (81, 0), (81, 4)])],\n            path: [\n                (at: (0, 0), seconds: 1),\n                (at: (0, 4)),\n            ],\n            repeat: Once,\n            starts: Ridden",
        "38: mover \"door\", starts: nobody can ride it: it has no Solid, OneWay or Ladder",
    ),
    (
        "(81, 4)])]",
        "(80, 0)])]",
        "32: movers[1], feature \"leaf\", outline: edge 2 has no length (on the grid): (80, 0) to (80, 0)",
    ),
    (
        "(81, 4)",
        "(81, NaN)",
        "32: movers[1], feature \"leaf\", outline[2].y: NaN is not a finite number",
    ),
    (
        "wait: 1.5",
        "wait: -1",
        "26: mover \"lift\", path[0].wait: -1 is outside 0..=3600 s",
    ),
    (
        "seconds: 3",
        "seconds: 1e300",
        "27: mover \"lift\", path[1].seconds: 1e300 is outside 0.01..=3600 s: the way to the next stop takes some time",
    ),
    (
        "seconds: 3",
        "seconds: 0",
        "27: mover \"lift\", path[1].seconds: 0 is outside 0.01..=3600 s: the way to the next stop takes some time",
    ),
    (
        "(0, 4))",
        "(0, 4), seconds: 1)",
        "35: mover \"door\", path[1].seconds: 1 s to nowhere: no stop follows this one",
    ),
    (
        "(0, 5)",
        "(inf, 5)",
        "27: mover \"lift\", path[1].at.x: inf is not a finite number",
    ),
    (
        "(0, 5)",
        "(3930, 5)",
        "22: movers[0], feature \"deck\", outline[0].x: at path[1], 4000 is out of bounds: coordinates are between -4000 and 4000 m",
    ),
    (
        "On(\"button\")",
        "On(\"floor\")",
        "38: mover \"door\", starts: feature \"floor\" is no Trigger",
    ),
    (
        "On(\"button\")",
        "On(\"knob\")",
        "38: mover \"door\", starts: there is no feature \"knob\"",
    ),
    (
        "repeat: Once",
        "repeat: Twice",
        "37: mover \"door\": Unexpected variant named `Twice` in enum `Repeat`, expected one of `Loop`, `PingPong`, or `Once` instead",
    ),
    (
        "id: \"leaf\"",
        "ID: \"leaf\"",
        "32: movers[1], feature \"#0\": Unexpected field named `ID` in `Feature`, expected one of `id`, `material`, `kind`, `outline`, `climbable`, `conveyor`, `friction`, `concave`, `by`, or `respawn` instead",
    ),
];

#[test]
fn movers_that_make_no_sense_are_refused() {
    refused(BAD_MOVERS);
}

/// Areas and frames that cannot be.
const BAD_PLACES: &[Change] = &[
    (
        "The Rim",
        "",
        "42: area \"\", name: must have 1 to 64 characters, none of them a control character",
    ),
    (
        "(50, -9)",
        "(99, -9)",
        "43: area \"The Works\", room: min is not below and left of max",
    ),
    (
        "(-20, -10)",
        "(NaN, -10)",
        "42: area \"The Rim\", room.min.x: NaN is not a finite number",
    ),
    (
        "mood: Dusk",
        "mood: Dull",
        "42: area \"The Rim\": Unexpected variant named `Dull` in enum `Mood`, expected one of `Dusk`, `Works`, `Depths`, or `Summit` instead",
    ),
    (
        "zoom: 0.75",
        "zoom: 0",
        "46: frames[0], zoom: 0 is outside 0.25..=4",
    ),
    (
        "zoom: 0.75",
        "zoom: NaN",
        "46: frames[0], zoom: NaN is outside 0.25..=4",
    ),
    (
        "(66, 4.5)",
        "(66, inf)",
        "46: frames[0], at.y: inf is not a finite number",
    ),
    (
        "(92, 9)",
        "(92, 4000)",
        "47: frames[1], room.max.y: 4000 is out of bounds: coordinates are between -4000 and 4000 m",
    ),
    (
        "(92, 9)))",
        "(92, 9)), size: 2)",
        "47: frames[1]: Unexpected field named `size` in `Frame`, expected one of `room`, `at`, or `zoom` instead",
    ),
    (
        "(74, 8)",
        "(74, 0)",
        "50: prompts[0], room: min is not below and left of max",
    ),
    (
        "(70, 0), max: (74, 8)",
        "(NaN, 0), max: (74, 8)",
        "50: prompts[0], room.min.x: NaN is not a finite number",
    ),
    (
        "WallJump",
        "Fly",
        "50: prompts[0]: Unexpected variant named `Fly` in enum `Skill`, expected one of `Crouch`, `Drop`, `WallJump`, `Ledge`, or `Look` instead",
    ),
];

#[test]
fn places_that_make_no_sense_are_refused() {
    refused(BAD_PLACES);
}

#[test]
fn every_truncation_is_refused_in_words() {
    for end in 0..FULL.trim_end().len() {
        let error =
            level::parse(&FULL[..end], Path::new("full.ron")).expect_err("a truncated level");
        assert!(error.to_string().starts_with("full.ron:"), "{error}");
    }
}

#[test]
fn random_damage_never_panics() {
    mutants(FULL, 0x5eed, 6000).for_each(|text| survive(&text));
}
