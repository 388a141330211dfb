//! The follow camera over the recorded run through the quarry: smooth, leading, the hero always in the picture.

use edgewalker::cli::load;
use edgewalker::game::camera::{CameraState, Pose};
use edgewalker::game::framing::{Framing, half_picture};
use edgewalker::game::{Input, Stage, Stance, View, World};
use edgewalker::level::{self, Area, Frame, Level, Mood, Rect, Scenery};
use edgewalker::tune::{Camera, Tuning};
use glam::DVec2;
use std::path::Path;
use std::sync::Arc;

const GOLDEN: &str = "tests/golden/quarry.replay.ron";
const TICK: f64 = 1.0 / 120.0;

/// View and pose after every tick of the run.
fn run() -> Vec<(View, Pose)> {
    let path = Path::new(GOLDEN);
    let replay = load::replay(path).unwrap();
    let mut world = load::replay_world(path, &replay).unwrap();
    let framing = Framing::new(&world.stage().level);
    let mut camera = CameraState::new(&world.view(), &framing);
    let step = |input| {
        world.step(input, &replay.tuning);
        camera.step(&world.view(), 0.0, &framing, &replay.tuning.camera, TICK);
        (world.view(), camera.pose(&framing, &replay.tuning.camera))
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
    let mut most = DVec2::ZERO;
    for moment in run() {
        let p = in_picture(&moment);
        assert!(
            p.x.abs() < 0.62 && p.y.abs() < 0.86,
            "{p} at {} s",
            moment.0.time
        );
        most = most.max(p.abs());
    }
    println!("farthest from the middle, in shares of half the picture: {most}");
}

/// A jump of the speed is seen as a jerk, whatever caused it: a landing, a wall, a turn, another shot. Where the hero comes
/// back after a death, the picture is cut.
#[test]
fn the_speed_of_the_camera_has_no_jumps() {
    let run = run();
    let mut sharpest = DVec2::ZERO;
    for moments in run.windows(3) {
        let [a, b, c] = moments else { unreachable!() };
        if b.0.is_cut_from(&a.0) || c.0.is_cut_from(&b.0) {
            continue;
        }
        let change = (c.1.eye - 2.0 * b.1.eye + a.1.eye).truncate().abs() / (TICK * TICK);
        let View { time, position, .. } = b.0;
        assert!(
            change.x < 110.0 && change.y < 150.0,
            "{change} m/s^2 at {time} s, {position}"
        );
        sharpest = sharpest.max(change);
    }
    println!("greatest acceleration of the camera: {sharpest} m/s^2");
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

/// How much of the plane of play is seen below a hero's foot, m.
fn seen_below((view, pose): &(View, Pose)) -> f64 {
    let half = (pose.fov_degrees / 2.0).to_radians().tan() * pose.eye.distance(pose.target);
    view.position.y - (pose.target.y - half)
}

/// How far ahead a fall is to be seen, s.
const FORESEEN: f64 = 0.4;

/// Whoever falls at full speed sees what is below him for 0.4 s, or the ground that he will land on before.
#[test]
fn a_fall_sees_where_it_leads() {
    let run = run();
    let full = Tuning::default().motion.fall_speed;
    let (mut falls, mut least) = (0, f64::MAX);
    for (i, moment) in run.iter().enumerate() {
        let view = moment.0;
        if view.stance != Stance::Air || view.velocity.y > -0.99 * full {
            continue;
        }
        let landing = run[i..].iter().find(|(view, _)| view.stance != Stance::Air);
        let left = landing.map_or(f64::MAX, |(end, _)| view.position.y - end.position.y);
        let below = seen_below(moment);
        let wanted = (FORESEEN * full).min(left + 0.5);
        assert!(below > wanted, "{below} m of {wanted} at {} s", view.time);
        falls += 1;
        least = least.min(below / wanted);
    }
    println!(
        "{falls} ticks of full fall; at least {least:.2} times what is to be seen below the feet"
    );
    assert!(falls > 20);
}

/// A fall in which no ground is known is seen as far ahead as soon as it has its full speed for as long.
#[test]
fn a_fall_into_the_unknown_sees_ahead_too() {
    let (tuning, framing) = (Tuning::default(), Framing::free());
    let (full, gravity) = (tuning.motion.fall_speed, tuning.motion.gravity);
    let at = |time: f64| {
        let braked = (time - full / gravity).max(0.0);
        let depth = 0.5 * gravity * (time - braked).powi(2) + full * braked;
        View {
            time,
            velocity: DVec2::new(0.0, -(gravity * time).min(full)),
            ..View::at(DVec2::new(0.0, -depth))
        }
    };
    let mut camera = CameraState::new(&at(0.0), &framing);
    for tick in 1..=360 {
        let view = at(f64::from(tick) * TICK);
        camera.step(&view, 0.0, &framing, &tuning.camera, TICK);
        let below = seen_below(&(view, camera.pose(&framing, &tuning.camera)));
        if view.time > full / gravity + FORESEEN {
            assert!(below > FORESEEN * full, "{below} m at {} s", view.time);
        }
    }
}

/// View and pose after each tick on a flat level, from standing still: so many ticks of each input.
fn on_level_ground(parts: &[(u32, Input)]) -> Vec<(View, Pose)> {
    let level = level::load(Path::new("levels/dev/flat.ron")).unwrap();
    let (tuning, framing) = (Tuning::default(), Framing::new(&level));
    let mut world = World::new(Arc::new(Stage::build(level).unwrap()), 120, 0);
    let mut camera = CameraState::new(&world.view(), &framing);
    let held = parts
        .iter()
        .flat_map(|&(ticks, input)| (0..ticks).map(move |_| input));
    let step = |input| {
        world.step(input, &tuning);
        camera.step(&world.view(), 0.0, &framing, &tuning.camera, TICK);
        (world.view(), camera.pose(&framing, &tuning.camera))
    };
    held.map(step).collect()
}

fn running(run: i8, jump: bool) -> Input {
    Input {
        run,
        jump,
        ..Input::default()
    }
}

/// The highest jump over level ground, standing and running, leaves the picture where it is, and draws nothing back.
#[test]
fn a_jump_over_level_ground_does_not_nod() {
    for run in [0, 127, -127] {
        let still = (60, running(0, false));
        let moments =
            on_level_ground(&[still, (60, running(run, true)), (90, running(run, false))]);
        let heights = moments.iter().map(|(view, _)| view.position.y);
        assert!(heights.fold(0.0, f64::max) > 2.5, "a full jump");
        let rest = moments[0].1.eye;
        let moved =
            |(_, pose): &(View, Pose)| (pose.eye.y - rest.y).abs().max((pose.eye.z - rest.z).abs());
        let most = moments.iter().map(moved).fold(0.0, f64::max);
        println!("a full jump moves the picture by {most} m");
        assert!(most < 0.1, "{most} m");
    }
}

/// Who turns round sees more of what is then before him within 0.4 s.
#[test]
fn a_turn_is_led_soon() {
    for way in [127, -127] {
        let parts = [(60, running(way, false)), (90, running(-way, false))];
        let moments = on_level_ground(&parts);
        let turned = 60
            + moments[60..]
                .iter()
                .position(|(view, _)| view.velocity.x * f64::from(way) < 0.0)
                .unwrap();
        let leads = |moment: &(View, Pose)| in_picture(moment).x * f64::from(way) > 0.0;
        let led = 60 + moments[60..].iter().position(leads).unwrap();
        let seconds = [60, turned].map(|from| (led - from) as f64 * TICK);
        println!(
            "leads {:.3} s after the key, {:.3} s after the turn",
            seconds[0], seconds[1]
        );
        assert!(seconds[0] < 0.4, "{seconds:?}");
    }
}

/// How much further down than where it rests the picture goes after a landing from high up: on ground, and on a mover, which is
/// not foreseen, m.
const SWINGS: [f64; 2] = [1.2, 3.0];

#[test]
fn a_landing_is_soft() {
    let run = run();
    let mut landings = 0;
    for (i, pair) in run.windows(2).enumerate() {
        let (before, landed) = (pair[0].0, pair[1].0);
        if before.velocity.y > -20.0 || landed.stance != Stance::Ground {
            continue;
        }
        landings += 1;
        let foot = landed.position.y;
        let after = run[i..].iter();
        let after = after.take_while(|(view, _)| (view.position.y - foot).abs() < 0.5);
        let aims = after.map(|(view, pose)| pose.target.y - view.position.y);
        let swing = Camera::default().height - aims.fold(f64::MAX, f64::min);
        let most = SWINGS[usize::from(landed.carried != DVec2::ZERO)];
        println!("{swing:5.2} m at {}", landed.position);
        assert!(swing < most, "{swing} m at {}", landed.position);
    }
    assert!(landings > 2, "{landings} hard landings");
}

/// A level of two areas with a frame: from x = -50 to 50 and on to 150, the frame from 10 to 20.
fn framed() -> (Level, Framing) {
    let rect = |x0: f64, y0: f64, x1: f64, y1: f64| Rect {
        min: DVec2::new(x0, y0),
        max: DVec2::new(x1, y1),
    };
    let area = |name: &str, room: Rect| Area {
        name: name.into(),
        room,
        mood: Mood::Dusk,
    };
    let mut level = level::load(Path::new("levels/dev/flat.ron")).unwrap();
    level.areas = vec![
        area("east", rect(50.0, -4.0, 150.0, 40.0)),
        area("west", rect(-50.0, -20.0, 50.0, 40.0)),
    ];
    level.frames = vec![Frame {
        room: rect(10.0, -1.0, 19.999, 5.0),
        at: Some(DVec2::new(18.0, 6.0)),
        zoom: 0.5,
    }];
    let framing = Framing::new(&level);
    (level, framing)
}

/// The poses of a run at 8 m/s from x to x, so many ticks a second, with so many seconds of rest at the end.
fn walk(from: f64, to: f64, rest: f64, rate: f64) -> Vec<(View, Pose)> {
    let (_, framing) = framed();
    let tuning = Camera::default();
    let speed = 8.0 * (to - from).signum();
    let arrival = (to - from) / speed;
    let at = |time: f64| View {
        time,
        stance: Stance::Ground,
        velocity: DVec2::new(if time < arrival { speed } else { 0.0 }, 0.0),
        ..View::at(DVec2::new(from + speed * time.min(arrival), 0.0))
    };
    let mut camera = CameraState::new(&at(0.0), &framing);
    let ticks = ((arrival + rest) * rate).round() as u32;
    let step = |tick| {
        let view = at(f64::from(tick) / rate);
        camera.step(&view, 0.0, &framing, &tuning, 1.0 / rate);
        (view, camera.pose(&framing, &tuning))
    };
    (1..=ticks).map(step).collect()
}

#[test]
fn the_picture_stays_in_its_room() {
    let half = half_picture(Camera::default().distance, &Camera::default());
    let (_, west) = *walk(0.0, -41.0, 4.0, 120.0).last().unwrap();
    let (_, east) = *walk(60.0, 141.0, 4.0, 120.0).last().unwrap();
    let near = |a: f64, b: f64| (a - b).abs() < 1e-6;
    assert!(
        near(west.target.x, -50.0 + half.x),
        "it stops at the wall: {west:?}"
    );
    assert!(
        near(east.target.x, 150.0 - half.x),
        "and at the other: {east:?}"
    );
    assert!(
        east.target.y >= -4.0 + half.y,
        "and above the floor: {east:?}"
    );
    for (view, pose) in walk(-41.0, 141.0, 4.0, 120.0) {
        let sides = pose.target.x - half.x >= -50.001 && pose.target.x + half.x <= 150.001;
        assert!(sides || (10.0..30.0).contains(&view.position.x), "{view:?}");
    }
}

#[test]
fn a_set_piece_is_framed_and_let_go_smoothly() {
    let poses = walk(0.0, 16.0, 6.0, 120.0);
    let (_, there) = *poses.last().unwrap();
    assert!(
        (there.eye.z - 2.0 * Camera::default().distance).abs() < 1e-3,
        "zoomed out"
    );
    let aim = DVec2::new(16.0, 1.6).lerp(DVec2::new(18.0, 6.0), 0.7);
    assert!((there.target.truncate() - aim).length() < 1e-3, "{there:?}");
    let run = walk(0.0, 60.0, 4.0, 120.0);
    for pair in run.windows(3) {
        let [a, b, c] = pair else { unreachable!() };
        let speed = (b.1.eye - a.1.eye) / TICK;
        assert!(speed.length() < 60.0, "{speed} at {}", b.0.position);
        let change = (c.1.eye - 2.0 * b.1.eye + a.1.eye) / (TICK * TICK);
        assert!(change.length() < 250.0, "{change} at {}", b.0.position);
    }
    let (_, end) = *run.last().unwrap();
    assert!((end.eye.z - Camera::default().distance).abs() < 1e-3);
}

#[test]
fn where_areas_meet_a_resting_camera_rests() {
    let poses = walk(30.0, 50.0, 20.0, 120.0);
    let late = &poses[poses.len() - 600..];
    let drift = |pair: &[(View, Pose)]| (pair[1].1.eye - pair[0].1.eye).length();
    let worst = late.windows(2).map(drift).fold(0.0, f64::max);
    assert!(worst < 1e-12, "{worst:e} m in a tick");
}

#[test]
fn the_shots_do_not_depend_on_the_rate() {
    // Borders are passed at multiples of a second over eight, which all rates share.
    let fine = walk(0.0, 64.0, 0.0, 960.0);
    for rate in [24, 40, 120, 240] {
        let coarse = walk(0.0, 64.0, 0.0, f64::from(rate));
        for (i, (view, pose)) in coarse.iter().enumerate() {
            let other = fine[(i + 1) * 960 / rate as usize - 1].1;
            let apart = (pose.eye - other.eye).length();
            assert!(apart < 0.02, "{rate} Hz: {apart} m at {}", view.position);
        }
    }
}

#[test]
fn the_camera_keeps_clear_of_what_stands_before_the_level() {
    let (mut level, _) = framed();
    level.frames[0].zoom = 4.0;
    level.scenery.push(Scenery {
        depth: 6.0,
        scale: 2.0,
        ..level.scenery.first().cloned().unwrap_or_else(pillar)
    });
    let framing = Framing::new(&level);
    let view = View::at(DVec2::new(15.0, 0.0));
    let pose = CameraState::new(&view, &framing).pose(&framing, &Camera::default());
    assert!(pose.eye.z >= 6.0 + 2.0 + 2.0, "{pose:?}");
}

fn pillar() -> Scenery {
    ron::from_str("(kind: Pillar, at: (15, 0))").unwrap()
}
