//! What is heard of scripted runs, as values: no device, no files.

#[path = "../common/heard.rs"]
mod heard;
mod rig;

use edgewalker::anim::{Figure, Rig, Stride};
use edgewalker::cli::load;
use edgewalker::game::{Input, Soles};
use edgewalker::level::{
    Easing, Feature, Kind, Material, Mover, Repeat, Scenery, SceneryKind, Starts, Stop,
};
use edgewalker::sound::{Cue, LOOPS, Layer, Level, Loop, STRIDES, Sound};
use edgewalker::tune::Tuning;
use glam::DVec2;
use heard::each_moment;
use rig::{Run, block, floor, level, region};
use std::path::Path;

#[test]
fn steps_follow_the_way_and_the_material() {
    for (material, sound) in [
        (Material::Rock, Sound::StepRock),
        (Material::Masonry, Sound::StepMasonry),
        (Material::Timber, Sound::StepTimber),
        (Material::Iron, Sound::StepIron),
    ] {
        let mut run = Run::new(level(vec![floor(material)], vec![]));
        run.play(5.0, 1);
        let way = run.world.view().position.x;
        let steps = run.heard(sound);
        let per_metre = steps.len() as f64 / way;
        assert!((0.6..0.7).contains(&per_metre), "{per_metre} steps a metre");
        // Evenly, to a fraction of a tick: at full speed a stride takes 0.195 s, which is no whole number of ticks.
        let gaps = steps.windows(2).map(|pair| pair[1].at - pair[0].at);
        for gap in gaps.skip(3) {
            assert!((gap - STRIDES[1] / 8.0).abs() < 1e-6, "{gap}");
        }
        let others = run
            .cues
            .iter()
            .filter(|cue| cue.sound != sound && cue.sound != Sound::Swing);
        assert_eq!(others.count(), 0, "{:?}", run.cues);
    }
}

/// The times at which a foot of the figure comes down in a run to the right, on even ground.
fn contacts(rig: &Rig, run: &mut Run, seconds: f64) -> Vec<f64> {
    let mut soles = Soles::of(run.world.stage());
    soles.follow(&run.world);
    let mut figure = Figure::new(&run.world.view().moves(0.0, None), rig, &soles);
    let mut stood = [true; 2];
    let mut times = Vec::new();
    while run.world.time() < seconds {
        run.play(1.0 / 120.0, 1);
        soles.follow(&run.world);
        figure.advance(&run.world.view().moves(0.0, None), rig, &soles);
        for (side, stood) in stood.iter_mut().enumerate() {
            let stands = figure.stands_on(side).is_some();
            if stands && !*stood {
                times.push(run.world.time());
            }
            *stood = stands;
        }
    }
    times
}

#[test]
fn steps_are_heard_when_feet_come_down() {
    let bytes = std::fs::read("assets/models/hero.glb").unwrap();
    let rig = Rig::read("hero.glb", &bytes).unwrap();
    for (stride, step) in [Stride::Walk, Stride::Run, Stride::Crawl]
        .into_iter()
        .zip(STRIDES)
    {
        let cycle = f64::from(rig.stride(stride));
        assert!((cycle / 2.0 - step).abs() < 1e-3, "{stride:?}: {cycle}");
    }
    let mut run = Run::new(level(vec![floor(Material::Rock)], vec![]));
    let contacts = contacts(&rig, &mut run, 6.0);
    let steps = run.heard(Sound::StepRock);
    assert!(steps.len() > 25 && contacts.len() + 2 > steps.len());
    for step in &steps {
        let apart = contacts.iter().map(|at| (at - step.at).abs());
        let apart = apart.fold(f64::MAX, f64::min);
        assert!(apart < LATE, "a step at {} is {apart} s off", step.at);
    }
}

/// How far what is heard of a step may be from what is seen of it, s: two pictures.
const LATE: f64 = 0.033;

/// What stands still makes no steps, neither on a belt nor on a ferry; who walks against a belt does.
#[test]
fn what_carries_along_makes_no_steps() {
    let belt = Feature {
        conveyor: 2.0,
        ..floor(Material::Iron)
    };
    let mut run = Run::new(level(vec![belt], vec![]));
    run.play(2.0, 0);
    assert!(run.world.view().position.x > 2.0);
    assert_eq!(run.heard(Sound::StepIron), []);
    assert!(run.loudest(Loop::Belt) > 0.5);

    let mut run = Run::new(level(vec![floor(Material::Rock)], vec![ferry()]));
    run.world.put(DVec2::new(3.0, 1.0)).unwrap();
    run.play(4.5, 0);
    assert!(
        run.world.view().position.x > 8.0,
        "{:?}",
        run.world.view().position
    );
    assert_eq!(run.heard(Sound::StepTimber), []);
    run.play(0.5, -1);
    assert!(!run.heard(Sound::StepTimber).is_empty());
}

/// A belt is heard as fast as it runs, whichever way, up to the speed from which all sound alike.
#[test]
fn a_belt_is_heard_at_its_own_speed() {
    for (speed, share) in [
        (0.5, 0.125),
        (1.0, 0.25),
        (-1.0, 0.25),
        (3.0, 0.75),
        (4.0, 1.0),
        (-9.0, 1.0),
    ] {
        let belt = Feature {
            conveyor: speed,
            ..floor(Material::Iron)
        };
        let mut run = Run::new(level(vec![belt], vec![]));
        run.ear = Some(DVec2::ZERO); // right over it
        run.play(0.2, 0);
        let heard = run.levels[Loop::Belt.slots()][0];
        let (gain, pitch) = (0.5 + 0.5 * share, 0.8 + 0.4 * share);
        assert!((heard.gain - gain).abs() < 1e-3, "{speed} m/s: {heard:?}");
        assert!((heard.pitch - pitch).abs() < 1e-3, "{speed} m/s: {heard:?}");
    }
}

fn ferry() -> Mover {
    let stop = |x: f64, wait: f64| Stop {
        at: DVec2::new(x, 0.0),
        wait,
        seconds: 3.0,
        easing: Easing::Eased,
    };
    Mover {
        id: "ferry".into(),
        features: vec![block("deck", Material::Timber, (1.0, 0.5), (5.0, 1.0))],
        path: vec![stop(0.0, 1.0), stop(6.0, 2.0)],
        repeat: Default::default(),
        starts: Starts::AtOnce,
        ..Mover::default()
    }
}

#[test]
fn uphill_is_lower_and_louder_than_downhill() {
    let slope = |rise: f64| Feature {
        outline: [
            (-60.0, -90.0),
            (60.0, -90.0),
            (60.0, 60.0 * rise),
            (-60.0, -60.0 * rise),
        ]
        .map(DVec2::from)
        .to_vec(),
        ..floor(Material::Rock)
    };
    let mean = |rise: f64| {
        let mut hill = level(vec![slope(rise)], vec![]);
        (hill.start, hill.bottom) = (DVec2::Y, -80.0);
        let mut run = Run::new(hill);
        run.play(0.5, 0).cues.clear();
        run.play(3.0, 1);
        let steps = run.heard(Sound::StepRock);
        assert!(steps.len() > 8, "{}", steps.len());
        let sum =
            |value: fn(&Cue) -> f32| steps.iter().map(value).sum::<f32>() / steps.len() as f32;
        (sum(|cue| cue.pitch), sum(|cue| cue.gain))
    };
    let (up, down) = (mean(0.9), mean(-0.9));
    assert!(
        up.0 < down.0 - 0.04 && up.1 > down.1 + 0.1,
        "{up:?} {down:?}"
    );
}

/// The higher the fall, the louder the landing, at the time of the landing itself.
#[test]
fn landings_tell_how_hard_they_are() {
    let land = |height: f64| {
        let mut run = Run::new(level(vec![floor(Material::Masonry)], vec![]));
        run.play(0.2, 0);
        run.cues.clear();
        run.world.put(DVec2::new(0.0, height)).unwrap();
        run.play(2.0, 0);
        run
    };
    let gravity = Tuning::default().motion.gravity;
    let mut last = 0.0;
    for height in [0.05, 0.5, 1.0, 2.0, 3.0, 6.0] {
        let run = land(height);
        let [step] = run.heard(Sound::StepMasonry)[..] else {
            panic!("{height}: {:?}", run.cues);
        };
        let fallen = 0.2 + (2.0 * height / gravity).sqrt();
        assert!(
            (step.at - fallen).abs() < 1e-3,
            "{height}: {} {fallen}",
            step.at
        );
        let soft = run
            .heard(Sound::LandSoft)
            .iter()
            .map(|cue| cue.gain)
            .sum::<f32>();
        let hard = run
            .heard(Sound::LandHard)
            .iter()
            .map(|cue| cue.gain)
            .sum::<f32>();
        let speed = (2.0 * gravity * height).sqrt();
        assert_eq!(
            (soft > 0.0, hard > 0.0),
            (speed > 2.5, speed > 14.0),
            "{height}: {:?}",
            run.cues
        );
        assert!(soft + hard >= last && soft + hard + step.gain > last);
        last = soft + hard;
    }
}

/// A slide is heard while it lasts, then fades by the mixer; the jump off the wall comes at its own time.
#[test]
fn walls_are_heard() {
    let walls = vec![
        floor(Material::Rock),
        block("wall", Material::Rock, (3.0, 0.0), (6.0, 40.0)),
    ];
    let mut run = Run::new(level(walls, vec![]));
    run.play(0.1, 0);
    run.world.put(DVec2::new(2.5, 20.0)).unwrap();
    run.play(1.0, 1);
    assert!(
        run.loudest(Loop::Slide) > 0.6,
        "{}",
        run.loudest(Loop::Slide)
    );
    let jump = Input {
        run: 127,
        jump: true,
        ..Input::default()
    };
    let from = run.world.time();
    run.step(jump);
    assert_eq!(run.heard(Sound::WallJump).len(), 1);
    assert!((run.heard(Sound::WallJump)[0].at - from).abs() < 1e-9);
    run.loops.clear();
    for _ in 0..10 {
        run.step(Input {
            jump: true,
            ..Input::default()
        });
    }
    assert_eq!(run.loudest(Loop::Slide), 0.0, "off the wall");
    assert!(run.loudest(Loop::Cape) > 0.5, "but fast");
}

/// A lift is heard near by and from its side; far away it is not.
#[test]
fn machines_are_heard_by_distance() {
    let slam = Mover {
        id: "crusher".into(),
        features: vec![block("head", Material::Iron, (10.0, 8.0), (13.0, 10.0))],
        path: vec![
            Stop {
                wait: 1.0,
                seconds: 0.5,
                ..Stop::default()
            },
            Stop {
                at: DVec2::new(0.0, -5.0),
                wait: 1.0,
                seconds: 2.0,
                easing: Easing::Eased,
            },
        ],
        repeat: Default::default(),
        starts: Starts::AtOnce,
        ..Mover::default()
    };
    let listen = |x: f64| {
        let mut run = Run::new(level(vec![floor(Material::Rock)], vec![slam.clone()]));
        run.ear = Some(DVec2::new(x, 3.0));
        run.play(4.6, 0);
        run
    };
    let (near, far, right) = (listen(8.0), listen(60.0), listen(16.0));
    let slams = near.heard(Sound::Slam);
    assert_eq!(slams.len(), 1, "{:?}", near.cues);
    assert!((slams[0].at - 1.5).abs() < 1e-9 && slams[0].gain > 0.5 && slams[0].pan > 0.0);
    // It sets off twice, and comes to rest at the top once.
    let clunks: Vec<f64> = near.heard(Sound::Clunk).iter().map(|cue| cue.at).collect();
    assert_eq!(clunks, [1.0, 2.5, 4.5]);
    assert!(right.heard(Sound::Slam)[0].pan < 0.0);
    assert!(near.loudest(Loop::Motor) > 0.5 && near.loudest(Loop::Chain) > 0.5);
    assert_eq!(
        (far.cues.len(), far.loudest(Loop::Motor)),
        (0, 0.0),
        "{:?}",
        far.cues
    );
}

/// A box of iron over a floor, which goes up and down or aside.
fn machine(id: &str, x: f64, way: DVec2) -> Mover {
    let stop = |at: DVec2| Stop {
        at,
        seconds: 1.0,
        ..Stop::default()
    };
    Mover {
        id: id.into(),
        features: vec![block(id, Material::Iron, (x, 8.0), (x + 2.0, 10.0))],
        path: vec![stop(DVec2::ZERO), stop(way)],
        repeat: Default::default(),
        starts: Starts::AtOnce,
        ..Mover::default()
    }
}

/// Several machines are heard at once, each from its side; the farthest of too many is not.
#[test]
fn machines_are_heard_side_by_side() {
    let places = [-9.0, 7.0, 2.0, 25.0];
    let up = DVec2::new(0.0, 3.0);
    let movers = places.map(|x| machine(&format!("at {x}"), x, up));
    let mut run = Run::new(level(vec![floor(Material::Rock)], movers.to_vec()));
    run.ear = Some(DVec2::new(0.0, 8.0));
    run.play(0.5, 0);
    for which in [Loop::Motor, Loop::Chain] {
        let levels = &run.levels[which.slots()];
        assert!(levels.iter().all(|level| level.gain > 0.1), "{levels:?}");
        let mut pans: Vec<f32> = levels.iter().map(|level| level.pan).collect();
        pans.sort_by(f32::total_cmp);
        let [left, middle, right] = pans[..] else {
            panic!("{pans:?}");
        };
        assert!(left < -0.3 && (0.05..0.2).contains(&middle), "{pans:?}");
        assert!((0.3..0.5).contains(&right), "{pans:?}");
    }
    let before = run.levels;
    run.play(3.0, 0);
    let side = |levels: &[Level; LOOPS]| {
        levels[Loop::Motor.slots()]
            .iter()
            .map(|l| l.pan)
            .collect::<Vec<_>>()
    };
    assert_eq!(side(&run.levels), side(&before), "nobody has changed sides");
}

/// What comes down on the hero is a danger, too, while it is near; a lift that goes aside is none. Two are more than one.
#[test]
fn crushers_are_a_danger() {
    let tense = |movers: Vec<Mover>| {
        let mut run = Run::new(level(vec![floor(Material::Rock)], movers));
        run.play(3.0, 0);
        run.layers[Layer::Tension as usize]
    };
    let (down, aside) = (DVec2::new(0.0, -4.0), DVec2::new(3.0, 0.0));
    let one = tense(vec![machine("a", 3.0, down)]);
    let two = tense(vec![machine("a", 3.0, down), machine("b", -5.0, down)]);
    assert!(one > 0.2 && two > one + 0.1 && two < 1.0, "{one} {two}");
    assert_eq!(tense(vec![machine("a", 3.0, aside)]), 0.0);
    assert_eq!(tense(vec![machine("a", 40.0, down)]), 0.0);
}

#[test]
fn places_tell_themselves_once() {
    let button = region("button", Kind::Trigger, 6.0);
    let checkpoint = Feature {
        respawn: Some(DVec2::new(10.5, 0.0)),
        ..region("stone", Kind::Checkpoint, 10.0)
    };
    let (secret, thorns) = (
        region("hidden", Kind::Secret, 14.0),
        region("thorns", Kind::Hazard, 20.0),
    );
    let door = Mover {
        id: "door".into(),
        features: vec![block("leaf", Material::Iron, (30.0, 0.0), (31.0, 4.0))],
        path: vec![
            Stop {
                seconds: 1.0,
                ..Stop::default()
            },
            Stop {
                at: DVec2::new(0.0, 5.0),
                ..Stop::default()
            },
        ],
        repeat: Repeat::Once,
        starts: Starts::On("button".into()),
        ..Mover::default()
    };
    let features = vec![floor(Material::Rock), button, checkpoint, secret, thorns];
    let mut run = Run::new(level(features, vec![door]));
    run.ear = Some(DVec2::new(15.0, 1.0));
    for _ in 0..3 {
        run.play(1.8, 1).play(1.0, -1);
    }
    run.play(3.0, 1);
    let counts = [Sound::Lever, Sound::Checkpoint, Sound::Secret, Sound::Door]
        .map(|sound| run.heard(sound).len());
    assert_eq!(counts, [1, 1, 1, 1], "{:?}", run.world.view());
    let deaths = run.world.view().deaths as usize;
    assert!(deaths >= 1);
    assert_eq!(run.heard(Sound::Death).len(), deaths);
    assert_eq!(run.heard(Sound::Respawn).len(), deaths);
    assert_eq!(run.heard(Sound::Splash).len(), 0);
}

/// The music is tense near danger, lower after a death, and moves with who moves.
#[test]
fn music_follows_motion_and_danger() {
    let features = vec![floor(Material::Rock), region("thorns", Kind::Hazard, 60.0)];
    let mut run = Run::new(level(features, vec![]));
    run.play(4.0, 0);
    let [pad, pulse, melody, tension] = run.layers;
    assert_eq!((pad, tension), (1.0, 0.0));
    assert!(pulse < 0.05 && melody > 0.9, "{:?}", run.layers);
    run.play(6.0, 1);
    assert!(run.layers[Layer::Pulse as usize] > 0.4, "{:?}", run.layers);
    run.world.put(DVec2::new(56.0, 0.0)).unwrap();
    run.play(3.0, 0);
    assert!(
        run.layers[Layer::Tension as usize] > 0.5,
        "{:?}",
        run.layers
    );
    run.play(1.0, 1);
    assert_eq!(run.world.view().deaths, 1);
    assert!(run.duck < 0.6, "{}", run.duck);
    run.play(12.0, 0);
    assert!(run.duck > 0.95 && run.layers[Layer::Tension as usize] < 0.2);
}

#[test]
fn lamps_hum_and_water_laps_near_by() {
    let mut calm = level(vec![floor(Material::Rock)], vec![]);
    calm.bottom = -5.0;
    calm.scenery.push(Scenery {
        kind: SceneryKind::Lantern,
        at: DVec2::new(30.0, 0.0),
        depth: -1.0,
        scale: 1.0,
        turn: None,
        flip: false,
    });
    let gains = |x: f64, y: f64| {
        let mut run = Run::new(calm.clone());
        run.world.put(DVec2::new(x, y)).unwrap();
        run.play(0.1, 0);
        (run.loudest(Loop::Hum), run.loudest(Loop::Water))
    };
    let (near, far, high) = (gains(30.0, 0.0), gains(0.0, 0.0), gains(0.0, 30.0));
    assert!(near.0 > 0.4 && far.0 < 0.2, "{near:?} {far:?}");
    assert!(far.1 > 0.6 && high.1 < 0.2, "{far:?} {high:?}");
}

/// The recorded run through the gym has some of everything, and never too much at once.
#[test]
fn the_golden_run_is_heard() {
    let path = Path::new("tests/golden/gym.replay.ron");
    let replay = load::replay(path).unwrap_or_else(|e| panic!("{e}"));
    let listen = || {
        let mut cues = Vec::new();
        each_moment(path, &replay, |_, scape, moment| {
            cues.extend(&scape.tick(moment).cues);
        });
        cues
    };
    let cues = listen();
    for sound in [
        Sound::StepRock,
        Sound::LandSoft,
        Sound::LandHard,
        Sound::Jump,
        Sound::Bump,
        Sound::WallJump,
        Sound::Grab,
        Sound::Rung,
        Sound::Clunk,
        Sound::Slam,
        Sound::Door,
        Sound::Death,
        Sound::Respawn,
    ] {
        let is_heard = cues.iter().any(|cue: &Cue| cue.sound == sound);
        assert!(is_heard, "{sound:?} is never heard");
    }
    for pair in cues.windows(2) {
        let is_twice = pair[0].sound == pair[1].sound && pair[1].at - pair[0].at < 0.04;
        assert!(!is_twice, "{pair:?}");
    }
    assert_eq!(listen(), cues, "the same every time");
}
