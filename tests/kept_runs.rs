//! Runs that are left and gone on with, and the way back to the last checkpoint.

#[path = "common/hall.rs"]
mod hall;

use edgewalker::game::{Input, Replay, Run, World};
use edgewalker::level::{Feature, Kind};
use edgewalker::tune::Tuning;
use glam::DVec2;
use hall::{play, region, world};

const RATES: [u32; 4] = [15, 60, 120, 1000];

fn checkpoint() -> Feature {
    Feature {
        respawn: Some(DVec2::new(5.0, 0.0)),
        ..region("lamp", Kind::Checkpoint, 4.0, 6.0)
    }
}

/// Going back by hand is a death like any other: at the last checkpoint, with the clock going on.
#[test]
fn going_back_to_the_checkpoint_by_hand() {
    for rate in RATES {
        let mut world = world(&[checkpoint()], &[], rate);
        play(&mut world, 2.0, 1);
        assert!(world.view().position.x > 6.0);
        go_back(&mut world);
        let view = world.view();
        assert_eq!((view.position.x, view.deaths, view.began_at), (5.0, 1, 0.0));
    }
}

/// A tick in which the player asks to go back to the last checkpoint.
fn go_back(world: &mut World) {
    let back = Input {
        respawn: true,
        ..Input::default()
    };
    world.step(back, &Tuning::default());
}

/// A run that was left goes on where it was: what has come of it is a value.
#[test]
fn a_run_goes_on_in_another_world() {
    let features = [checkpoint(), region("cave", Kind::Secret, 2.0, 3.0)];
    let mut first = world(&features, &[], 120);
    play(&mut first, 2.0, 1);
    go_back(&mut first);
    let run = first.so_far();
    assert_eq!(run.checkpoint.as_deref(), Some("lamp"));
    assert_eq!(
        (run.deaths, run.secrets.as_slice()),
        (1, &["cave".to_string()][..])
    );
    assert_eq!(run.seconds, first.time());

    let mut second = world(&features, &[], 60);
    assert!(second.resume(&run));
    assert_eq!(second.so_far(), run);
    expect_same_again(&run, second.clone());
    assert_eq!(second.view().position, DVec2::new(5.0, 0.0));
    play(&mut second, 1.0, 0);
    assert!((second.view().run_time() - run.seconds - 1.0).abs() < 1e-9);
    second.check().unwrap();

    let mut changed = world(&features[1..], &[], 60);
    assert!(!changed.resume(&run), "the checkpoint is gone");
    assert_eq!(changed.view().position, DVec2::ZERO);
}

/// A run that was gone on with is a replay like any other: its text says what it went on with.
fn expect_same_again(run: &Run, mut world: World) {
    let tuning = Tuning::default();
    let mut replay = Replay::new("hall", world.stage(), world.tick_rate(), 0, &tuning);
    replay.run = Some(run.clone());
    for tick in 0..90 {
        let input = Input {
            run: if tick < 60 { 127 } else { -127 },
            ..Input::default()
        };
        replay.push(input);
        world.step(input, &tuning);
    }
    let read = Replay::parse(&replay.to_text()).unwrap();
    assert_eq!(read, replay);
    let again = read.run(world.stage().clone()).unwrap();
    assert_eq!(
        (again.hash(), again.so_far()),
        (world.hash(), world.so_far())
    );
    let bad = replay
        .to_text()
        .replacen("seconds: ", "seconds: -inf, // ", 1);
    let refused = Replay::parse(&bad).unwrap_err().to_string();
    assert!(refused.contains("field `run`"), "{refused}");
}
