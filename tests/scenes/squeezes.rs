//! Squeezed between solids that close on a slope to each other: out as fast as `squeeze_speed`, else crushed.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::{EventKind, Mode, check::speed};
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

fn crushed(kind: EventKind) -> bool {
    kind == EventKind::Crushed
}

/// A deck that rises under a ceiling 4 m up at x = 0, which falls 1 in so many towards growing x.
fn press(slope: f64, pieces: &[(f64, DVec2, DVec2, DVec2)]) -> Scene {
    let low = 4.0 - 16.0 / slope;
    Scene::point()
        .moving((-16.0, 16.0), (-1.0, 0.0), pieces)
        .solid(&[
            (-16.0, 4.0 + 16.0 / slope),
            (16.0, low),
            (16.0, 30.0),
            (-16.0, 30.0),
        ])
        .tune(|t| t.squeeze_speed = 24.0)
}

#[test]
fn a_squeeze_faster_than_the_bound_crushes_when_it_begins() {
    // At 3 m/s: 1 in 7 drives out at 21 m/s, 1 in 9 would at 27, 1 in 60 at 180, 1 in 600 at 1800.
    for (slope, lives) in [(7.0, true), (9.0, false), (60.0, false), (600.0, false)] {
        let scene = press(slope, &[(0.0, ZERO, v(0.0, 3.0), ZERO)]);
        at_every_rate(&scene, |run, rate| {
            run.spawn(0.0, 0.0).play(1.5, rate);
            if lives {
                assert!(!run.kinds().into_iter().any(crushed));
                run.near(-21.0 * (1.5 - 4.0 / 3.0), 4.5, 1e-4);
            } else {
                close(run.when(crushed), 4.0 / 3.0, 1e-15);
                assert!(matches!(run.body().mode(), Mode::Crushed(_)));
                run.near(0.0, 4.0, 1e-15);
            }
            speed(run.body(), &run.terrain).unwrap();
        });
    }
}

#[test]
fn a_squeeze_that_grows_to_the_bound_crushes_there() {
    // From 1 m/s at the ceiling, faster by 2 m/s^2, 1 in 8: 8 m/s at first, and 24 a second later.
    let pieces = [
        (0.0, ZERO, v(0.0, 4.0), ZERO),
        (1.0, v(0.0, 4.0), v(0.0, 1.0), v(0.0, 2.0)),
    ];
    let scene = press(8.0, &pieces).tune(|t| t.squeeze_speed = 16.0);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).play(2.0, rate);
        close(run.when(crushed), 1.5, 1e-14);
        run.near(-8.0 * 0.5 - 8.0 * 0.25, 4.75, 1e-13);
    });
}

#[test]
fn who_is_only_pushed_may_be_pushed_as_fast_as_that_moves() {
    let scene = Scene::point().rect((-50.0, 100.0), (-2.0, 0.0)).moving(
        (-9.0, -1.0),
        (-1.0, 3.0),
        &[(0.0, ZERO, v(40.0, 0.0), ZERO)],
    );
    at_every_rate(&scene.tune(|t| t.squeeze_speed = 24.0), |run, rate| {
        run.spawn(0.0, 0.0).play(1.0, rate);
        run.near(39.0, 0.0, 1e-13);
        assert_eq!(run.speed(), v(40.0, 0.0));
    });
}
