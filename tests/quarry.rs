//! The quarry can be finished: a simple player runs it from start to goal. A level that only works at its limits would stop
//! him: he also has to finish at 85 % of the speed, and with jumps 85 % as high.

#[path = "common/player.rs"]
mod player;

use edgewalker::game::{Input, Stage};
use edgewalker::level::Level;
use edgewalker::tune::Tuning;
use glam::DVec2;
use player::{Act, Jump, Player, Run, Walk, quarry, way};
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

#[test]
fn every_pocket_beside_the_way_can_be_left() {
    for &(name, (x, y), way, (to_x, to_y)) in POCKETS {
        let stage = Arc::new(
            Stage::build(Level {
                start: DVec2::new(x, y),
                ..quarry()
            })
            .unwrap_or_else(|error| panic!("{name}: {error}")),
        );
        let mut player = Player::new(stage, Tuning::default(), 120);
        for _ in 0..120 {
            player.world.step(Input::default(), &player.tuning);
        }
        for act in way {
            player
                .act(act)
                .unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        let end = player.world.view().position;
        assert!(
            (end - DVec2::new(to_x, to_y)).abs().max_element() < 1.0,
            "{name}: ended at {end}"
        );
    }
}
