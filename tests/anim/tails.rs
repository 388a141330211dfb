//! Cape, lantern and crest at any frame rate.

use super::{RIG, Slope, at, running};
use edgewalker::anim::{Bone, Figure, Leap, Moves, Support};
use glam::DVec2;

/// A second of running, a jump, a landing, a stop.
fn run(t: f64) -> Moves {
    let x = 8.0 * t.min(1.6);
    let air = (t - 0.8).clamp(0.0, 0.6);
    let y = 12.0 * air - 20.0 * air * air;
    let flies = (0.8..1.4).contains(&t);
    Moves {
        time: t,
        velocity: DVec2::new(
            if t < 1.6 { 8.0 } else { 0.0 },
            if flies { 12.0 - 40.0 * air } else { 0.0 },
        ),
        support: if flies { Support::Air } else { Support::Ground },
        left: (0.8, Leap::Jumped),
        landed: if t < 1.4 {
            (f64::NEG_INFINITY, 0.0)
        } else {
            (1.4, 12.0)
        },
        ..Moves::standing(DVec2::new(x, y))
    }
}

fn play(rate: u32) -> Vec<DVec2> {
    let mut figure = Figure::new(&run(0.0), &RIG, &Slope(0.0));
    let mut seen = Vec::new();
    for tick in 1..=rate * 2 {
        figure.advance(&run(f64::from(tick) / f64::from(rate)), &RIG, &Slope(0.0));
        assert!(figure.is_finite(), "{rate} Hz, tick {tick}");
        if tick % (rate / 5).max(1) == 0 {
            seen.push(at(figure.shown(), Bone::Cape5));
        }
    }
    seen
}

#[test]
fn the_cape_hangs_alike_at_any_rate() {
    let fine = play(1000);
    for rate in [15, 20, 30, 45] {
        play(rate); // the pose that carries it is itself seen too rarely: it only has to stay calm
    }
    for rate in [60, 120, 240] {
        let seen = play(rate);
        assert_eq!(seen.len(), fine.len());
        for (i, (a, b)) in seen.iter().zip(&fine).enumerate() {
            let near = 0.2; // of a cape of 0.8 m
            assert!(
                a.distance(*b) < near,
                "{rate} Hz, sample {i}: {a} instead of {b}"
            );
        }
    }
}

#[test]
fn the_cape_streams_behind_a_run_and_hangs_at_rest() {
    let behind = |speed: f64| {
        let mut figure = Figure::new(&running(speed, 0.0, 0.0), &RIG, &Slope(0.0));
        for tick in 1..=240 {
            figure.advance(
                &running(speed, 0.0, f64::from(tick) / 120.0),
                &RIG,
                &Slope(0.0),
            );
        }
        at(figure.shown(), Bone::Cape1) - at(figure.shown(), Bone::Cape5)
    };
    let (still, run, left) = (behind(0.0), behind(8.0), behind(-8.0));
    assert!(still.y > 0.5, "it hangs: {still}");
    assert!(run.x > 0.35 && run.y < 0.6, "it streams: {run}");
    assert!(left.x < -0.35, "to the other side too: {left}");
}

#[test]
fn a_jump_in_space_or_time_leaves_everything_at_rest() {
    let mut figure = Figure::new(&running(8.0, 0.0, 0.0), &RIG, &Slope(0.0));
    for tick in 1..=60 {
        figure.advance(
            &running(8.0, 0.0, f64::from(tick) / 120.0),
            &RIG,
            &Slope(0.0),
        );
    }
    for (time, x) in [(0.51, 900.0), (30.0, 4.2), (0.2, 1.6)] {
        let moves = Moves {
            time,
            ..Moves::standing(DVec2::X * x)
        };
        let mut cut = figure;
        cut.advance(&moves, &RIG, &Slope(0.0));
        let fresh = Figure::new(&moves, &RIG, &Slope(0.0));
        assert!(cut == fresh, "to {x} m at {time} s");
    }
}
