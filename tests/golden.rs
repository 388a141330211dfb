//! Golden runs: a recorded run and what it came to, to the bit. When the motion, the tuning or the level changes on
//! purpose, record anew with `GOLDEN=record cargo test --no-default-features --test golden`, look at the difference of
//! the positions, and explain it in the commit.

#[path = "common/player.rs"]
mod player;
#[path = "common/way.rs"]
mod way;

use edgewalker::cli::tuning;
use edgewalker::game::{Input, Replay, Stage, World};
use edgewalker::level::{self, Level};
use edgewalker::motion::EventKind;
use edgewalker::tune::Tuning;
use player::{Player, crossing, quarry, way as quarry_way};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What a run came to.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Outcome {
    /// Hash of the final state, in hexadecimal.
    hash: String,
    /// When the goal was reached, s.
    won_at: Option<f64>,
    /// Tick and position at twenty times from the first tick to the last.
    positions: Vec<(u64, f64, f64)>,
}

fn file(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/golden")
        .join(name)
}

fn play(replay: &Replay, stage: Arc<Stage>) -> Outcome {
    let mut world = replay.world(stage).unwrap();
    let ticks = replay.ticks();
    let marks: Vec<u64> = (1..=20).map(|i| i * ticks / 20).collect();
    let mut positions = Vec::new();
    for input in replay.iter() {
        world.step(input, &replay.tuning);
        if marks.contains(&world.tick()) {
            let p = world.view().position;
            positions.push((world.tick(), p.x, p.y));
        }
    }
    Outcome {
        hash: format!("{:016x}", world.hash()),
        won_at: world.view().won_at,
        positions,
    }
}

/// The player's run from start to goal, and a second more.
fn record(stage: &Arc<Stage>) -> Replay {
    let mut player = Player::new(Arc::clone(stage), Tuning::default(), 120);
    for act in quarry_way() {
        player.act(&act).unwrap();
    }
    replay_of("levels/quarry.ron", stage, &player.tuning, &player.inputs)
}

fn replay_of(level: &str, stage: &Stage, tuning: &Tuning, inputs: &[Input]) -> Replay {
    let mut replay = Replay::new(level, stage, 120, 0, tuning);
    let rest = [Input::default(); 120];
    inputs.iter().chain(&rest).for_each(|&i| replay.push(i));
    replay
}

/// Compares a recorded run with what it came to; records both anew if that is asked for. The run.
fn check(name: &str, stage: &Arc<Stage>, record: impl Fn(&Arc<Stage>) -> Replay) -> Replay {
    let (run, outcome) = (
        file(&format!("{name}.replay.ron")),
        file(&format!("{name}.outcome.ron")),
    );
    if std::env::var_os("GOLDEN").is_some_and(|v| v == "record") {
        let replay = record(stage);
        std::fs::write(&run, replay.to_text()).unwrap();
        let pretty = ron::ser::PrettyConfig::new().depth_limit(2);
        let text = ron::ser::to_string_pretty(&play(&replay, Arc::clone(stage)), pretty).unwrap();
        std::fs::write(&outcome, text + "\n").unwrap();
    }
    let replay = Replay::parse(&std::fs::read_to_string(&run).unwrap()).unwrap();
    let expected: Outcome = ron::from_str(&std::fs::read_to_string(&outcome).unwrap()).unwrap();
    assert!(expected.won_at.is_some() && expected.positions.len() == 20);
    assert_eq!(play(&replay, Arc::clone(stage)), expected);
    replay
}

#[test]
fn the_quarry_from_start_to_goal() {
    check("quarry", &Arc::new(Stage::build(quarry()).unwrap()), record);
}

/// The gym, and the tuning that turns on what it is for.
fn gym() -> (Arc<Stage>, Tuning) {
    let level = level::load(Path::new("levels/dev/gym.ron")).unwrap();
    let tuning = tuning::load(Path::new("levels/dev/gym.tuning.ron")).unwrap();
    (Arc::new(Stage::build(level).unwrap()), tuning)
}

/// The way through the gym as it was written down.
fn gym_inputs(stage: &Arc<Stage>, tuning: &Tuning, rate: u32) -> Vec<Input> {
    let way = std::fs::read_to_string(file("gym.way.ron")).unwrap();
    way::go(&way, stage, tuning, rate).unwrap_or_else(|error| panic!("{rate} Hz: {error}"))
}

/// A mechanism, and whether an event shows it.
type Mechanism = (&'static str, fn(&EventKind) -> bool);

/// What must happen on the way through the gym.
const MECHANISMS: &[Mechanism] = &[
    ("a step up", |kind| matches!(kind, EventKind::SteppedUp(_))),
    ("a step down", |kind| matches!(kind, EventKind::Snapped(_))),
    ("a fall through planks", |kind| {
        matches!(kind, EventKind::Dropped)
    }),
    ("a climb", |kind| matches!(kind, EventKind::Climbed)),
    ("a wall jump", |kind| matches!(kind, EventKind::WallJumped)),
    ("a ledge", |kind| matches!(kind, EventKind::Grabbed)),
    ("a ride", |kind| {
        matches!(kind, EventKind::Boarded(Some(_)) | EventKind::Node(_))
    }),
    ("a push", |kind| matches!(kind, EventKind::Pushed(_))),
    ("a region", |kind| matches!(kind, EventKind::Entered(_))),
    ("the way out of one", |kind| {
        matches!(kind, EventKind::Exited(_))
    }),
];

#[test]
fn the_gym_by_every_mechanism() {
    let (stage, tuning) = gym();
    let replay = check("gym", &stage, |stage| {
        let inputs = gym_inputs(stage, &tuning, 120);
        replay_of("levels/dev/gym.ron", stage, &tuning, &inputs)
    });
    assert_eq!(
        replay.tuning, tuning,
        "recorded with the tuning that comes with the level"
    );
    let mut world = replay.world(stage).unwrap();
    let mut events = Vec::new();
    for input in replay.iter() {
        world.step(input, &replay.tuning);
        world
            .check()
            .unwrap_or_else(|error| panic!("tick {}: {error}", world.tick()));
        events.extend(world.trace().events.iter().map(|event| event.kind));
    }
    for (name, happens) in MECHANISMS {
        assert!(events.iter().any(happens), "no {name}");
    }
    assert_eq!(world.view().deaths, 1, "once into the thorns");
}

#[test]
fn the_way_through_the_gym_is_open_at_other_tick_rates() {
    let (stage, tuning) = gym();
    for rate in [60, 240, 500] {
        gym_inputs(&stage, &tuning, rate);
    }
}

#[test]
fn a_replay_survives_its_text_and_refuses_what_it_does_not_understand() {
    let stage = Arc::new(Stage::build(quarry()).unwrap());
    let text = std::fs::read_to_string(file("quarry.replay.ron")).unwrap();
    let replay = Replay::parse(&text).unwrap();
    assert_eq!(Replay::parse(&replay.to_text()).unwrap(), replay);
    let refused = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        Replay::parse(&text.replacen(from, to, 1))
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        refused("version: 1", "version: 2"),
        "field `version`: 2 is not understood, only 1 is"
    );
    assert_eq!(
        refused("tick_rate: 120", "tick_rate: 0"),
        "field `tick_rate`: 0 is outside 1..=10000"
    );
    assert_eq!(
        refused("gravity: 45.0", "gravity: 1e300"),
        "tuning, field `gravity`: 1e300 is outside 0..=400 m/s^2"
    );
    assert!(refused("seed:", "sead:").contains("sead"));
    for cut in [0, 1, 20, text.len() / 2, text.len() - 3] {
        assert!(Replay::parse(&text[..cut]).is_err(), "cut at {cut}");
    }
    let other = Replay {
        fingerprint: "0".into(),
        ..replay
    };
    assert!(
        other
            .run(stage)
            .unwrap_err()
            .to_string()
            .contains("fingerprint")
    );
}

/// The benches and the peers play it.
#[test]
fn the_run_that_is_measured_reaches_its_goal() {
    let stage = Arc::new(Stage::build(crossing()).unwrap());
    let text = std::fs::read_to_string(file("crossing.replay.ron")).unwrap();
    let world = Replay::parse(&text).unwrap().run(stage).unwrap();
    assert!(
        world.view().won_at.is_some(),
        "it ended at {}",
        world.view().position
    );
    assert_eq!(world.view().deaths, 0);
}

#[test]
fn a_level_that_only_looks_different_has_the_same_runs() {
    let level = quarry();
    let bare = Level {
        scenery: Vec::new(),
        prompts: Vec::new(),
        frames: Vec::new(),
        ..level.clone()
    };
    let other = Level {
        bottom: level.bottom - 1.0,
        ..level.clone()
    };
    let fingerprint = |level| Stage::build(level).unwrap().fingerprint();
    assert_eq!(fingerprint(bare), fingerprint(level.clone()));
    assert_ne!(fingerprint(other), fingerprint(level));
}

#[test]
fn a_snapshot_of_the_world_goes_on_as_the_original() {
    let stage = Arc::new(Stage::build(quarry()).unwrap());
    let replay =
        Replay::parse(&std::fs::read_to_string(file("quarry.replay.ron")).unwrap()).unwrap();
    let inputs: Vec<_> = replay.iter().collect();
    let mut world = replay.world(stage).unwrap();
    let end = |mut world: World, inputs: &[Input]| {
        inputs
            .iter()
            .for_each(|&input| world.step(input, &replay.tuning));
        world.hash()
    };
    let expected = end(world.clone(), &inputs);
    for (tick, &input) in inputs.iter().enumerate() {
        if tick % 500 == 250 {
            assert_eq!(
                end(world.clone(), &inputs[tick..]),
                expected,
                "from tick {tick}"
            );
        }
        world.step(input, &replay.tuning);
    }
}
