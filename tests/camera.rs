//! The follow camera over the recorded run through the quarry: smooth, leading, the hero always in the picture.

use edgewalker::cli::load;
use edgewalker::game::camera::{CameraState, Pose};
use edgewalker::game::{Stance, View};
use glam::DVec2;
use std::path::Path;

const GOLDEN: &str = "tests/golden/quarry.replay.ron";
const TICK: f64 = 1.0 / 120.0;

/// View and pose after every tick of the run.
fn run() -> Vec<(View, Pose)> {
    let path = Path::new(GOLDEN);
    let replay = load::replay(path).unwrap();
    let mut world = load::replay_world(path, &replay).unwrap();
    let mut camera = CameraState::new(&world.view());
    let step = |input| {
        world.step(input, &replay.tuning);
        camera.step(&world.view(), 0.0, &replay.tuning.camera, TICK);
        (world.view(), camera.pose(&replay.tuning.camera))
    };
    replay.iter().map(step).collect()
}

/// Where the hero's foot is in a picture of 16 to 9: -1 to 1 in both directions.
fn in_picture((view, pose): &(View, Pose)) -> DVec2 {
    let half = (pose.fov_degrees / 2.0).to_radians().tan() * pose.eye.distance(pose.target);
    (view.position - pose.target.truncate()) / DVec2::new(half * 16.0 / 9.0, half)
}

#[test]
fn the_hero_stays_well_inside_the_picture() {
    let places: Vec<DVec2> = run().iter().map(in_picture).collect();
    let reach = places.iter().fold(DVec2::ZERO, |most, p| most.max(p.abs()));
    println!("farthest from the middle, in shares of half the picture: {reach}");
    assert!(reach.x < 0.3 && reach.y < 0.7, "{reach}");
}

/// A jump of the speed is seen as a jerk, whatever caused it: a landing, a wall, a turn.
#[test]
fn the_speed_of_the_camera_has_no_jumps() {
    let between = |pair: &[(View, Pose)]| (pair[1].1.target - pair[0].1.target).truncate() / TICK;
    let speeds: Vec<DVec2> = run().windows(2).map(between).collect();
    let change = |pair: &[DVec2]| (pair[1] - pair[0]).abs() / TICK;
    let sharpest = speeds.windows(2).map(change).fold(DVec2::ZERO, DVec2::max);
    println!("greatest acceleration of the camera: {sharpest} m/s^2");
    assert!(sharpest.x < 100.0 && sharpest.y < 120.0, "{sharpest}");
}

#[test]
fn a_runner_sees_more_of_what_is_before_him() {
    let runs = |(view, _): &&(View, Pose)| {
        (1.5..4.5).contains(&view.time) && view.stance == Stance::Ground && view.velocity.x > 7.0
    };
    let run = run();
    let places: Vec<f64> = run
        .iter()
        .filter(runs)
        .map(|moment| in_picture(moment).x)
        .collect();
    assert!(places.len() > 100, "{}", places.len());
    assert!(places.iter().all(|x| *x < -0.1), "{places:?}");
}
