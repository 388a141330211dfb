//! The quarry can be finished: a simple player runs it from start to goal. A level that only works at its limits would stop
//! him: he also has to finish at 85 % of the speed, and with jumps 85 % as high.

#[path = "common/player.rs"]
mod player;

use edgewalker::game::{Input, Replay, Stage, World};
use edgewalker::level::{Kind, Level};
use edgewalker::tune::Tuning;
use glam::DVec2;
use player::{Act, Drop, Duck, Fall, Jump, Player, Run, Walk, quarry, way};
use std::sync::Arc;

/// Its name, where one lands in it, the way out, where that leads.
type Pocket = (&'static str, (f64, f64), &'static [Act], (f64, f64));

/// The pockets beside the way: where one may fall to, the way out, and where that leads.
const POCKETS: &[Pocket] = &[
    (
        "west of the fallen stones",
        (30.6, -1.7),
        &[
            Run(32.0),
            Jump(33.6),
            Walk(33.85),
            Jump(34.75),
            Walk(34.9),
            Jump(37.4),
        ],
        (37.4, 3.2),
    ),
    (
        "east of the fallen stones",
        (40.7, -2.3),
        &[
            Jump(39.1),
            Run(38.0),
            Run(36.9),
            Jump(35.0),
            Walk(34.9),
            Jump(37.4),
        ],
        (37.4, 3.2),
    ),
    (
        "behind the bench block",
        (54.6, -2.5),
        &[Jump(56.0)],
        (56.0, -2.1),
    ),
    (
        "the floor of the shaft",
        (81.8, -6.7),
        &[Walk(81.4), Jump(83.2)],
        (83.2, -5.0),
    ),
    (
        "on the wedged lintel",
        (217.0, 7.0),
        &[Walk(217.2), Jump(219.8)],
        (219.8, 8.3),
    ),
    (
        "on the leaning column",
        (223.0, 5.5),
        &[Run(223.6), Jump(226.0)],
        (226.0, 7.2),
    ),
];

/// The secrets: where one stands before them, the way through them and out again, and where that leads.
const SECRETS: &[Pocket] = &[
    (
        "under the brow",
        (-4.8, 8.2),
        &[
            Jump(-6.9),
            Jump(-7.4),
            Jump(-9.8),
            Walk(-11.0),
            Run(-9.0),
            Fall(-5.0),
        ],
        (-5.0, 8.0),
    ),
    (
        "crack in the lip",
        (73.2, -6.8),
        &[
            Jump(74.6),
            Walk(74.9),
            Jump(71.0),
            Walk(70.8),
            Run(72.2),
            Fall(73.4),
        ],
        (73.4, -6.9),
    ),
    (
        "brow of the lip",
        (75.2, 22.2),
        &[
            Jump(72.2),
            Jump(70.0),
            Run(67.6),
            Fall(65.4),
            Run(63.4),
            Fall(61.2),
            Run(58.8),
            Fall(58.2),
        ],
        (58.2, -5.2),
    ),
    (
        "alcove of the well",
        (113.4, -12.5),
        &[Jump(110.8), Run(110.6), Run(112.4), Fall(113.0)],
        (113.0, -12.7),
    ),
    (
        "culvert",
        (163.0, -16.7),
        &[
            Walk(160.5),
            Walk(163.4),
            Run(164.3),
            Fall(161.6),
            Run(162.0),
            Walk(164.4),
            Jump(163.2),
        ],
        (164.2, -16.9),
    ),
    (
        "heart of the press",
        (137.7, -3.3),
        &[Duck(133.2), Drop(132.7), Duck(127.4)],
        (127.3, -8.4),
    ),
    (
        "on the buttress",
        (281.2, 38.5),
        &[Jump(286.2), Run(290.4), Run(293.0), Fall(295.6)],
        (295.6, 19.4),
    ),
];

/// A rate that divides all that are played at.
const SLOWEST: u32 = 30;

/// Seconds from start to goal.
fn finish(tuning: Tuning, tick_rate: u32) -> f64 {
    let stage = Arc::new(Stage::build(quarry()).unwrap());
    let mut player = Player::new(stage, tuning, tick_rate);
    for act in way() {
        let done = player.act(&act);
        let view = player.world.view();
        println!(
            "{:7.2} s  {:8.2} {:7.2}  {act:?}",
            view.time, view.position.x, view.position.y
        );
        done.unwrap();
    }
    player
        .world
        .view()
        .won_at
        .expect("the way leads to the goal")
}

#[test]
fn the_quarry_can_be_finished_at_every_tick_rate() {
    for tick_rate in [30, 60, 120, 240, 1000] {
        let seconds = finish(Tuning::default(), tick_rate);
        assert!(
            (150.0..280.0).contains(&seconds),
            "{seconds} s at {tick_rate} Hz"
        );
    }
}

#[test]
fn no_jump_needs_more_than_85_percent_of_the_speed() {
    let mut tuning = Tuning::default();
    tuning.motion.run_speed *= 0.85;
    finish(tuning, 120);
}

#[test]
fn no_jump_needs_more_than_85_percent_of_the_height() {
    let mut tuning = Tuning::default();
    let motion = &mut tuning.motion;
    // Up to the float at the apex under full gravity, then under its share of it.
    let height = |v: f64| (v * v - motion.apex_speed.powi(2)) / (2.0 * motion.gravity);
    let float = motion.apex_speed.powi(2) / (2.0 * motion.gravity * motion.apex_gravity);
    let wanted = 0.85 * (height(motion.jump_speed) + float) - float;
    motion.jump_speed = (2.0 * motion.gravity * wanted + motion.apex_speed.powi(2)).sqrt();
    finish(tuning, 120);
}

/// Goes a way from a place; the player where it ends.
fn go((name, start, way, end): &Pocket) -> Player {
    let level = Level {
        start: DVec2::from(*start),
        ..quarry()
    };
    let stage = Stage::build(level).unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut player = Player::new(Arc::new(stage), Tuning::default(), 120);
    for _ in 0..60 {
        player.world.step(Input::default(), &player.tuning);
    }
    for act in *way {
        let done = player.act(act);
        done.unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    let at = player.world.view().position;
    let missed = (at - DVec2::from(*end)).abs().max_element();
    assert!(missed < 1.0, "{name}: ended at {at}");
    player
}

#[test]
fn every_pocket_beside_the_way_can_be_left() {
    for pocket in POCKETS {
        go(pocket);
    }
}

#[test]
fn every_secret_can_be_found_and_left_again() {
    let stage = Stage::build(quarry()).unwrap();
    assert_eq!(SECRETS.len(), stage.secret_count());
    for secret in SECRETS {
        let found = go(secret).world.view().secrets;
        assert_eq!(found, 1, "{}", secret.0);
    }
}

#[test]
fn the_way_itself_passes_no_secret_and_no_death() {
    let mut player = Player::new(
        Arc::new(Stage::build(quarry()).unwrap()),
        Tuning::default(),
        120,
    );
    let mut areas = vec![0];
    for act in way() {
        player.act(&act).unwrap();
        areas.push(player.world.view().area);
    }
    let view = player.world.view();
    assert_eq!((view.deaths, view.secrets), (0, 0));
    areas.dedup();
    assert_eq!(areas, [0, 1, 2]);
}

/// Who dies loses at most this much of the recorded run, s.
const LONGEST_WAY_BACK: f64 = 30.0;

/// The longest that the recorded run stands still with nothing held, for a machine to come, s.
const LONGEST_WAIT: f64 = 3.0;

/// Machines come soon to who walks up to them: in the recorded run nobody waits long.
#[test]
fn no_machine_is_waited_for_long() {
    let run = include_str!("golden/quarry.replay.ron");
    let replay = Replay::parse(run).unwrap();
    let mut world = replay
        .world(Arc::new(Stage::build(quarry()).unwrap()))
        .unwrap();
    let (mut since, mut waits, mut whole) = (0.0, 0, 0.0);
    for input in replay.iter() {
        let before = world.time();
        world.step(input, &replay.tuning);
        let view = world.view();
        if input == Input::default() && view.velocity == DVec2::ZERO {
            continue;
        }
        let seconds = before - since;
        if seconds > 0.25 {
            println!("{seconds:5.2} s at {}", view.position);
            waits += 1;
            whole += seconds;
        }
        assert!(seconds <= LONGEST_WAIT, "{seconds} s at {}", view.position);
        since = world.time();
    }
    println!("{waits} waits, {whole:.1} s of {:.1} s", world.time());
    assert!(waits > 5, "there are machines");
}

/// From start to checkpoint, from there to the next, and to the goal: never far in the recorded run.
#[test]
fn no_death_costs_more_than_half_a_minute() {
    let run = include_str!("golden/quarry.replay.ron");
    let replay = Replay::parse(run).unwrap();
    let mut world = replay
        .world(Arc::new(Stage::build(quarry()).unwrap()))
        .unwrap();
    let mut safe = (0.0, "the start".to_string());
    let mut reached = 0;
    for input in replay.iter() {
        let before = world.view().checkpoint;
        world.step(input, &replay.tuning);
        let view = world.view();
        let goal = view.won_at.is_some();
        if view.checkpoint == before && !goal {
            continue;
        }
        let camp = world.checkpoint().filter(|_| !goal);
        let place = camp.map_or("the goal".to_string(), |camp| camp.id.clone());
        let seconds = view.won_at.unwrap_or(view.time) - safe.0;
        println!("{seconds:6.2} s from {} to {place}", safe.1);
        assert!(
            seconds <= LONGEST_WAY_BACK,
            "{} to {place}: {seconds} s",
            safe.1
        );
        safe = (view.time, place);
        reached += 1;
        if goal {
            break;
        }
    }
    let camps = world.stage().level.features.iter();
    let camps = camps.filter(|feature| feature.kind == Kind::Checkpoint);
    assert_eq!(reached, camps.count() + 1, "every one, and the goal");
}

/// The inputs of a player who decides thirty times a second, given to worlds with more ticks: the run is the same to the bit.
#[test]
fn the_run_is_the_same_at_every_tick_rate() {
    let stage = Arc::new(Stage::build(quarry()).unwrap());
    let mut player = Player::new(Arc::clone(&stage), Tuning::default(), SLOWEST);
    for act in way() {
        player.act(&act).unwrap();
    }
    let expected = player.world.view();
    for rate in [60, 120, 240, 990] {
        let mut world = World::new(Arc::clone(&stage), rate, 0);
        for input in &player.inputs {
            for _ in 0..rate / SLOWEST {
                world.step(*input, &player.tuning);
            }
        }
        let view = world.view();
        assert_eq!(view.won_at, expected.won_at, "{rate} Hz");
        assert_eq!(view.position, expected.position, "{rate} Hz");
        assert_eq!(world.hero().hash(), player.world.hero().hash(), "{rate} Hz");
    }
}
