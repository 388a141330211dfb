//! Hazards, checkpoints, secrets, goals, triggers and crushers, at their own times.

use super::hall::{block, play, region, world};
use edgewalker::game::{Input, Shape, Stage, World};
use edgewalker::level::{Area, Easing, Feature, Kind, Mood, Mover, Rect, Repeat, Starts, Stop};
use edgewalker::motion::{Control, EventKind};
use edgewalker::tune::{Motion, Tuning};
use glam::DVec2;
use std::sync::Arc;

const RATES: [u32; 6] = [15, 30, 60, 120, 250, 1000];

/// A tick in which the player asks to begin anew.
fn restart(world: &mut World) {
    let retry = Input {
        retry: true,
        ..Input::default()
    };
    world.step(retry, &Tuning::default());
}

/// When somebody who starts to run at time 0 has come this far, m.
fn run_time(way: f64) -> f64 {
    let Motion {
        run_speed,
        run_accel,
        ..
    } = Motion::default();
    let ramp = run_speed / run_accel;
    ramp + (way - run_speed * ramp / 2.0) / run_speed
}

/// How far he has come at this time.
fn run_way(time: f64) -> f64 {
    let Motion {
        run_speed,
        run_accel,
        ..
    } = Motion::default();
    let ramp = time.min(run_speed / run_accel);
    run_accel * ramp * ramp / 2.0 + run_speed * (time - ramp)
}

/// The time of the last event of a kind in the last tick.
fn time_of(world: &World, wanted: impl Fn(EventKind) -> bool) -> Option<f64> {
    let events = world.trace().events.iter().rev();
    events
        .filter(|event| wanted(event.kind))
        .map(|event| event.time)
        .next()
}

#[test]
fn a_hazard_kills_when_it_is_entered() {
    for rate in RATES {
        let mut world = world(&[region("thorns", Kind::Hazard, 5.125, 9.0)], &[], rate);
        let mut entered = None;
        while world.view().deaths == 0 {
            assert!(world.time() < 3.0, "{rate} Hz: he lives");
            let now = world.time() + 0.5 / f64::from(rate);
            play(&mut world, now, 1);
            entered = time_of(&world, |kind| matches!(kind, EventKind::Entered(1)));
        }
        let late = (entered.unwrap() - run_time(5.125)).abs();
        assert!(late < 1e-12, "{rate} Hz: {late:e} s");
        assert!(world.time() - run_time(5.125) < 1.0 / f64::from(rate));
        // Back, and running again from that time on.
        let way = run_way(world.time() - entered.unwrap());
        assert!((world.view().position.x - way).abs() < 1e-12, "{rate} Hz");
    }
}

#[test]
fn who_dies_comes_back_at_the_last_checkpoint() {
    let camp = |id: &str, at: f64| Feature {
        respawn: Some(DVec2::new(at, 0.0)),
        ..region(id, Kind::Checkpoint, at - 0.5, at + 0.5)
    };
    let thorns = region("thorns", Kind::Hazard, 12.0, 15.0);
    let mut world = world(&[camp("first", 3.0), camp("second", 7.0), thorns], &[], 120);
    for deaths in 1..4 {
        while world.view().deaths < deaths {
            assert!(world.time() < 9.0, "he lives");
            let now = world.time() + 1e-3;
            play(&mut world, now, 1);
        }
        let way = world.view().position.x - 7.0;
        assert!((0.0..=run_way(1.0 / 120.0)).contains(&way), "{way}");
    }
    assert_eq!(world.view().run_time(), world.time());
    // Who asks for a restart begins anew, and has been nowhere.
    let now = world.time();
    restart(&mut world);
    let view = world.view();
    assert_eq!((view.position, view.deaths), (DVec2::ZERO, 0));
    let run = (view.began_at, view.run_time());
    assert_eq!(run, (now, world.time() - now), "a new run");
}

#[test]
fn a_secret_counts_once_in_a_run_and_at_its_own_time() {
    for rate in RATES {
        let secrets = [
            region("cave", Kind::Secret, 3.0, 4.0),
            region("attic", Kind::Secret, -8.0, -7.0),
        ];
        let mut world = world(&secrets, &[], rate);
        assert_eq!(world.stage().secret_count(), 2);
        let fresh = world.hash();
        play(&mut world, 1.0, 1);
        assert_eq!(world.view().secrets, 1, "{rate} Hz");
        let late = world.view().secret_at.unwrap() - run_time(3.0);
        assert!(late.abs() < 1e-12, "{rate} Hz: {late:e} s");
        play(&mut world, 3.0, -1);
        assert_eq!(world.view().secrets, 2, "back over the first, to the other");
        restart(&mut world);
        assert_eq!((world.view().secrets, world.view().secret_at), (0, None));
        assert_ne!(world.hash(), fresh, "the time goes on");
    }
}

#[test]
fn the_area_is_the_first_one_with_the_foot_in_it_and_lasts_until_the_next() {
    let area = |name: &str, from: f64, to: f64| Area {
        name: name.into(),
        room: Rect {
            min: DVec2::new(from, -9.0),
            max: DVec2::new(to, 9.0),
        },
        mood: Mood::Works,
    };
    let mut level = world(&[], &[], 120).stage().level.clone();
    level.areas = vec![
        area("west", -9.0, 1.0),
        area("east", 4.0, 9.0),
        area("all", 6.0, 20.0),
    ];
    let mut world = World::new(Arc::new(Stage::build(level).unwrap()), 120, 0);
    let at = |world: &mut World, x: f64| {
        world.put(DVec2::new(x, 0.0)).unwrap();
        world.view().area
    };
    let places = [0.0, 2.0, 5.0, 8.0, 12.0, 30.0, 3.0];
    assert_eq!(places.map(|x| at(&mut world, x)), [0, 0, 1, 1, 2, 2, 2]);
    let here = world.hash();
    at(&mut world, 0.0);
    at(&mut world, 3.0);
    assert_ne!(world.hash(), here, "the same place, come from the west");
}

#[test]
fn the_goal_is_reached_at_its_own_time_at_every_rate() {
    for rate in RATES {
        let mut world = world(&[], &[], rate);
        play(&mut world, 7.0, 1);
        let late = (world.view().won_at.unwrap() - run_time(48.0)).abs();
        assert!(late < 1e-12, "{rate} Hz: {late:e} s");
    }
    let mut other = world(&[region("short cut", Kind::Goal, 10.0, 11.0)], &[], 120);
    play(&mut other, 3.0, 1);
    assert!((other.view().won_at.unwrap() - run_time(10.0)).abs() < 1e-12);
}

/// Four metres up in a second, when somebody has entered "button".
fn door() -> Mover {
    let stop = |y: f64, seconds: f64| Stop {
        at: DVec2::new(0.0, y),
        wait: 0.0,
        seconds,
        easing: Easing::Linear,
    };
    Mover {
        id: "door".into(),
        features: vec![block("leaf", Kind::Solid, (10.0, 0.0), (11.0, 4.0))],
        path: vec![stop(0.0, 1.0), stop(4.0, 0.0)],
        repeat: Repeat::Once,
        starts: Starts::On("button".into()),
        ..Mover::default()
    }
}

#[test]
fn a_trigger_starts_its_movers_when_anybody_enters_it() {
    for rate in RATES {
        let button = region("button", Kind::Trigger, -6.0, -5.0);
        let mut world = world(&[button], &[door()], rate);
        let twin = world
            .add_body(&Shape::hero(), DVec2::new(-2.0, 0.0))
            .unwrap();
        world.control(
            twin,
            Control {
                run: -1.0,
                ..Control::default()
            },
        );
        play(&mut world, 1.0, 0);
        let height = world.offsets_at(world.time()).next().unwrap().y;
        let expected = 4.0 * (world.time() - run_time(3.0));
        assert!(
            (height - expected).abs() < 1e-11,
            "{rate} Hz: {height} {expected}"
        );
        play(&mut world, 2.0, 0);
        assert_eq!(world.offsets_at(2.0).next().unwrap().y, 4.0);
    }
}

/// The door is shut for who comes too early, and open for who waits; a restart shuts it.
#[test]
fn a_door_lets_pass_who_has_opened_it() {
    let button = region("button", Kind::Trigger, -3.0, -2.0);
    let mut world = world(&[button], &[door()], 120);
    play(&mut world, 2.0, 1);
    assert_eq!(world.view().position.x, 10.0 - 13.0 / 32.0);
    play(&mut world, 4.5, -1);
    play(&mut world, 7.5, 1);
    let x = world.view().position.x;
    assert!(x > 12.0, "{x}, {:?}", world.offsets_at(world.time()).next());
    restart(&mut world);
    let later = world.time() + 2.0;
    play(&mut world, later, 1);
    let short = 10.0 - 13.0 / 32.0 - world.view().position.x;
    assert!(short.abs() < 1e-12, "{short:e} m before the door");
}

#[test]
fn a_crusher_kills_when_it_has_closed() {
    for rate in RATES {
        let stop = |y: f64, seconds: f64| Stop {
            at: DVec2::new(0.0, y),
            wait: 0.0,
            seconds,
            easing: Easing::Linear,
        };
        let crusher = Mover {
            id: "crusher".into(),
            features: vec![block("head", Kind::Solid, (18.0, 4.0), (24.0, 6.0))],
            path: vec![stop(0.0, 2.0), stop(-4.0, 2.0)],
            repeat: Repeat::Loop,
            starts: Starts::AtOnce,
            ..Mover::default()
        };
        let mut world = world(&[], &[crusher], rate);
        world.put(DVec2::new(21.0, 0.0)).unwrap();
        play(&mut world, 1.1, 0);
        assert_eq!(world.view().deaths, 0);
        let mut crushed = None;
        while world.view().deaths == 0 {
            assert!(world.time() < 2.0, "{rate} Hz: not crushed");
            let now = world.time() + 0.5 / f64::from(rate);
            play(&mut world, now, 0);
            crushed = time_of(&world, |kind| kind == EventKind::Crushed);
        }
        // The head, 109/64 m up, meets the crusher at 2 m/s.
        let expected = (4.0 - 109.0 / 64.0) / 2.0;
        let late = (crushed.unwrap() - expected).abs();
        assert!(late < 1e-12, "{rate} Hz: {late:e} s");
        assert_eq!(world.view().position, DVec2::ZERO);
    }
}

/// A snapshot taken while the door opens, and one while it waits, go on as the world they were taken from.
#[test]
fn snapshots_know_what_moves() {
    let button = region("button", Kind::Trigger, 4.0, 5.0);
    let mut original = world(&[button], &[door()], 120);
    for until in [0.4, 1.1, 2.6] {
        play(&mut original, until, 1);
        let text = ron::to_string(&original.snapshot()).unwrap();
        let stage = Arc::clone(original.stage());
        let mut again = World::restore(stage, ron::from_str(&text).unwrap()).unwrap();
        let mut straight = original.clone();
        play(&mut straight, until + 2.0, 1);
        play(&mut again, until + 2.0, 1);
        assert_eq!(again.hash(), straight.hash(), "from {until} s");
        assert!(straight.view().position.x > 8.0);
    }
}

/// How long a fall from rest takes under the default tuning.
fn fall_time(way: f64) -> f64 {
    let Motion {
        gravity: g,
        fall_speed: v,
        ..
    } = Motion::default();
    match way <= v * v / (2.0 * g) {
        true => (2.0 * way / g).sqrt(),
        false => v / g + (way - v * v / (2.0 * g)) / v,
    }
}

#[test]
fn who_falls_out_of_the_level_dies_at_the_very_time_at_every_rate() {
    let mut seen = Vec::new();
    for rate in RATES {
        let mut world = world(&[], &[], rate);
        world.put(DVec2::new(70.0, 5.0)).unwrap();
        let pit = world.stage().pit();
        let mut fell = None;
        while world.view().deaths == 0 {
            assert!(world.time() < 3.0, "{rate} Hz: he lives");
            let now = world.time() + 0.5 / f64::from(rate);
            play(&mut world, now, 1);
            fell = time_of(&world, |kind| kind == EventKind::Entered(pit));
        }
        let fell = fell.unwrap();
        assert!((fell - fall_time(25.0)).abs() < 1e-12, "{rate} Hz: {fell}");
        assert!(world.time() - fell < 1.0 / f64::from(rate));
        // Back at the start from that time on, and running.
        play(&mut world, 4.0, 1);
        let way = world.view().position.x;
        assert!((run_way(4.0 - fell) - way).abs() < 1e-12, "{rate} Hz");
        seen.push((fell.to_bits(), world.hero().hash()));
    }
    assert!(seen.iter().all(|other| *other == seen[0]), "{seen:?}");
}

#[test]
fn a_dip_below_the_bottom_between_two_ticks_counts() {
    // A platform 1/16 m over the bottom; down by 1/8 m in 1/20 s, of which the second half is below it, and back alike.
    let stop = |y: f64, wait: f64| Stop {
        at: DVec2::new(0.0, y),
        wait,
        seconds: 0.05,
        easing: Easing::Eased,
    };
    let lift = Mover {
        id: "lift".into(),
        features: vec![block("deck", Kind::Solid, (79.0, -21.0), (81.0, -19.9375))],
        path: vec![stop(0.0, 0.98), stop(-0.125, 0.0)],
        repeat: Repeat::Loop,
        starts: Starts::AtOnce,
        ..Mover::default()
    };
    // So heavy that he stays on it. At 15 Hz he is above the bottom at the ticks before and after.
    let mut heavy = Tuning::default();
    (heavy.motion.gravity, heavy.motion.fall_speed) = (400.0, 200.0);
    for rate in RATES {
        let mut world = world(&[], std::slice::from_ref(&lift), rate);
        world.put(DVec2::new(80.0, -19.9375)).unwrap();
        let pit = world.stage().pit();
        let mut falls = Vec::new();
        while world.time() < 1.5 {
            world.step(Input::default(), &heavy);
            falls.extend(time_of(&world, |kind| kind == EventKind::Entered(pit)));
        }
        assert_eq!(world.view().deaths, 1, "{rate} Hz");
        assert!((falls[0] - 1.005).abs() < 1e-12, "{rate} Hz: {falls:?}");
    }
}

#[test]
fn who_is_put_where_it_kills_dies_at_the_next_tick() {
    let mut world = world(&[region("thorns", Kind::Hazard, 5.125, 9.0)], &[], 120);
    for (deaths, place) in [(1, (7.0, 0.5)), (2, (70.0, -21.0))] {
        world.put(place.into()).unwrap();
        world.step(Input::default(), &Tuning::default());
        assert_eq!(world.view().deaths, deaths);
        assert!(world.view().position.length() < 0.1);
    }
}

#[test]
fn a_start_far_away_changes_no_bit_of_a_body() {
    // A twin runs into the button, and the door opens: the hero, who walks the other way, does not feel it.
    for rate in RATES {
        let button = region("button", Kind::Trigger, -6.0, -5.0);
        let run = |movers: &[Mover]| {
            let mut world = world(std::slice::from_ref(&button), movers, rate);
            let twin = world
                .add_body(&Shape::hero(), DVec2::new(-2.0, 0.0))
                .unwrap();
            let left = Control {
                run: -1.0,
                ..Control::default()
            };
            world.control(twin, left);
            let mut story = Vec::new();
            while world.time() < 1.0 {
                let input = Input {
                    run: 101,
                    jump: world.tick() % 30 > 20,
                    ..Input::default()
                };
                world.step(input, &Tuning::default());
                story.push((world.hero().mode().clone(), world.hero().hash()));
            }
            (story, world.offsets_at(1.0).next())
        };
        let far = |starts| {
            let mut door = Mover { starts, ..door() };
            for corner in &mut door.features[0].outline {
                corner.x += 40.0;
            }
            run(&[door])
        };
        let (with, moved) = far(Starts::On("button".into()));
        let (without, _) = far(Starts::On("goal".into()));
        assert!(moved.unwrap().y > 1.0, "{rate} Hz: it has started");
        assert_eq!(with, without, "{rate} Hz");
    }
}

#[test]
fn a_lift_that_its_rider_starts_takes_him_along_from_that_time() {
    // He walks over a deck just above the floor into the trigger on it, stops, and is 4 m up after a second.
    let stop = |y: f64, seconds: f64| Stop {
        at: DVec2::new(0.0, y),
        wait: 0.0,
        seconds,
        easing: Easing::Eased,
    };
    let lift = Mover {
        id: "lift".into(),
        features: vec![block("deck", Kind::Solid, (2.0, -1.0), (12.0, 0.0625))],
        path: vec![stop(0.0, 1.0), stop(4.0, 0.0)],
        repeat: Repeat::Once,
        starts: Starts::On("button".into()),
        ..Mover::default()
    };
    let mut seen = Vec::new();
    for rate in RATES {
        let mut world = world(
            &[region("button", Kind::Trigger, 5.0, 6.0)],
            std::slice::from_ref(&lift),
            rate,
        );
        world.put(DVec2::new(3.0, 0.0625)).unwrap();
        play(&mut world, 0.6, 1);
        play(&mut world, 1.0, 0);
        assert_eq!(world.hero().carrier(), Some(0), "{rate} Hz");
        let offset = world.offsets_at(1.0).next().unwrap().y;
        // Eased: twice 4 m/s on average in the middle, so 16 m/s^2 either way.
        let expected = |t: f64| match t < 0.5 {
            true => 8.0 * t * t,
            false => 4.0 - 8.0 * (1.0 - t) * (1.0 - t),
        };
        assert!((offset - expected(1.0 - run_time(2.0))).abs() < 1e-12);
        assert_eq!(world.view().position.y, 0.0625 + offset, "{rate} Hz");
        let mut bits = vec![world.hero().hash()];
        play(&mut world, 2.0, 0);
        assert_eq!(world.view().position.y, 4.0625, "{rate} Hz");
        bits.push(world.hero().hash());
        seen.push(bits);
    }
    assert!(seen.iter().all(|other| *other == seen[0]), "{seen:?}");
}
