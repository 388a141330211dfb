//! Regions that move: coming and going are events with the times of the closed form, in whatever frame the body is, at rest too.

use super::moving::at_every_rate;
use super::rig::*;
use edgewalker::motion::{Event, EventKind, Region};
use glam::DVec2;

const ZERO: DVec2 = DVec2::ZERO;

/// A region alone, as what moves.
fn plain(x: (f64, f64), y: (f64, f64)) -> Scene {
    Scene::boxed().region(Region::Plain, x, y)
}

fn floor() -> Scene {
    Scene::boxed().rect((-50.0, 50.0), (-1.0, 0.0))
}

/// Comings and goings: time, feature, whether it came in.
fn visits(run: &Run) -> Vec<(f64, u32, bool)> {
    let visit = |e: &Event| match e.kind {
        EventKind::Entered(f) => Some((e.time, f, true)),
        EventKind::Exited(f) => Some((e.time, f, false)),
        _ => None,
    };
    run.trace.events.iter().filter_map(visit).collect()
}

fn expect(run: &Run, wanted: &[(f64, u32, bool)]) {
    let seen = visits(run);
    assert_eq!(seen.len(), wanted.len(), "{seen:?}, not {wanted:?}");
    for (got, want) in seen.iter().zip(wanted) {
        close(got.0, want.0, 1e-12);
        assert_eq!((got.1, got.2), (want.1, want.2), "{seen:?}");
    }
}

#[test]
fn a_region_sweeps_over_a_body_at_rest_and_moves_it_by_no_bit() {
    // At 4 m/s from 10 m away; from rest with 2 m/s^2 from 9 m away, and back where it came from.
    let even = (0.0, v(-10.0, 0.0), v(4.0, 0.0), ZERO);
    let eased = (0.0, v(-9.0, 0.0), ZERO, v(2.0, 0.0));
    let cases = [(even, 2.25, 2.75), (eased, f64::sqrt(8.0), f64::sqrt(10.0))];
    for (piece, comes, goes) in cases {
        let scene = floor().mover(plain((-1.0, 1.0), (-1.0, 1.0)), &[piece]);
        at_every_rate(&scene, |run, rate| {
            run.spawn(0.0, 0.0).play(2.0, rate);
            let before = run.at();
            run.play(4.0, rate);
            expect(run, &[(comes, 1, true), (goes, 1, false)]);
            assert_eq!((run.at(), run.speed()), (before, ZERO));
            assert!(run.supported());
        });
    }
}

#[test]
fn a_region_that_turns_at_the_body_itself_has_not_been_entered() {
    // It comes to the body with its border at 2 s, exactly, and turns back; or goes on a millimetre for a moment.
    for (reach, entered) in [(0.0, false), (1.0 / 1024.0, true)] {
        let at = -1.0 + reach;
        let pieces = [
            (0.0, v(at - 4.0, 0.0), v(2.0, 0.0), ZERO),
            (2.0, v(at, 0.0), v(-2.0, 0.0), ZERO),
        ];
        let scene = floor().mover(plain((-1.0, 1.0), (-1.0, 1.0)), &pieces);
        at_every_rate(&scene, |run, rate| {
            run.spawn(0.0, 0.0).play(4.0, rate);
            match entered {
                true => expect(
                    run,
                    &[(2.0 - reach / 2.0, 1, true), (2.0 + reach / 2.0, 1, false)],
                ),
                false => expect(run, &[]),
            }
        });
    }
}

#[test]
fn a_fall_through_a_rising_region_has_the_times_of_the_closed_form() {
    // 10 - 15 t^2 against borders at 2 + 3 t + t^2 and 4 + 3 t + t^2.
    let piece = (0.0, ZERO, v(0.0, 3.0), v(0.0, 2.0));
    let scene = floor().mover(plain((-1.0, 1.0), (2.0, 4.0)), &[piece]);
    let at = |y: f64| (-3.0 + f64::sqrt(9.0 + 64.0 * (10.0 - y))) / 32.0;
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 10.0).play(2.0, rate);
        expect(run, &[(at(4.0), 1, true), (at(2.0), 1, false)]);
    });
}

#[test]
fn a_walker_comes_into_regions_of_what_carries_him_and_of_what_passes() {
    // A platform with a region on it, 1 m of it ahead; another region hangs in the level, a third comes the other way.
    let deck = Scene::boxed().rect((-5.0, 5.0), (-1.0, 0.0)).region(
        Region::Plain,
        (1.0, 2.0),
        (-0.5, 3.0),
    );
    let scene = Scene::boxed()
        .region(Region::Plain, (10.0, 11.0), (0.0, 3.0))
        .mover(deck, &[(0.0, ZERO, v(3.0, 0.0), ZERO)])
        .mover(
            plain((0.0, 1.0), (-4.0, 4.0)),
            &[(0.0, v(20.0, 0.0), v(-2.0, 0.0), ZERO)],
        );
    at_every_rate(&scene, |run, rate| {
        // He rides at 3 m/s, from 1 s on he walks over the deck at 2 m/s.
        run.spawn(0.0, 0.0).velocity(3.0, 0.0).play(1.0, rate);
        run.trace.clear();
        run.walk(5.0).play(2.0, rate);
        run.near(8.0, 0.0, 1e-12);
        run.play(4.0, rate);
        // On the deck after 1/2 and 1 s; the one that comes, at 20 - 2 t and 21 - 2 t, meets 3 + 5 (t - 1) in between.
        expect(
            run,
            &[
                (1.5, 2, true),
                (2.0, 2, false),
                (1.0 + 7.0 / 5.0, 0, true),
                (1.0 + 8.0 / 5.0, 0, false),
                (22.0 / 7.0, 3, true),
                (23.0 / 7.0, 3, false),
            ],
        );
    });
}

#[test]
fn a_crushers_spikes_are_met_before_the_crusher() {
    // Its underside comes down from 5 m at 2 m/s, with teeth of half a metre; the point meets them at 4.5 m of way.
    let head =
        Scene::point()
            .rect((-2.0, 2.0), (5.0, 7.0))
            .region(Region::Plain, (-2.0, 2.0), (4.5, 5.0));
    let scene = Scene::point()
        .rect((-50.0, 50.0), (-1.0, 0.0))
        .mover(head, &[(0.0, ZERO, v(0.0, -2.0), ZERO)]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0).play(2.25, rate);
        expect(run, &[(2.25, 2, true)]);
        assert_eq!(
            run.kinds()
                .iter()
                .filter(|k| **k == EventKind::Crushed)
                .count(),
            0
        );
        run.play(3.0, rate);
        close(run.when(|k| k == EventKind::Crushed), 2.5, 1e-12);
    });
}

#[test]
fn a_body_that_is_pushed_along_stays_in_the_region_of_the_pusher() {
    // 3 m ahead of the wall he comes in, and stays in while he is pushed.
    let wall = Scene::point().rect((-4.0, -3.0), (-9.0, 9.0)).region(
        Region::Plain,
        (-4.0, 0.0),
        (-1.0, 1.0),
    );
    let scene = Scene::point()
        .rect((-50.0, 50.0), (-1.0, 0.0))
        .mover(wall, &[(0.0, ZERO, v(2.0, 0.0), ZERO)]);
    at_every_rate(&scene, |run, rate| {
        run.spawn(2.0, 0.0).play(5.0, rate);
        expect(run, &[(1.0, 2, true)]);
        run.near(7.0, 0.0, 1e-12);
        close(run.when(|k| matches!(k, EventKind::Pushed(_))), 2.5, 1e-12);
    });
}

#[test]
fn who_is_put_into_a_moving_region_is_in_it_without_an_event() {
    let scene = floor().mover(
        plain((-1.0, 1.0), (-1.0, 3.0)),
        &[(0.0, ZERO, v(0.5, 0.0), ZERO)],
    );
    at_every_rate(&scene, |run, rate| {
        run.spawn(0.0, 0.0);
        assert_eq!(run.body().regions(), [1]);
        run.play(3.0, rate);
        expect(run, &[(2.0, 1, false)]);
    });
}

#[test]
fn regions_that_move_change_no_bit_of_the_motion() {
    let states = |moves: bool| {
        let out = std::cell::RefCell::new(Vec::new());
        let scene = Scene::boxed()
            .under(
                &[
                    (-20.0, 6.0),
                    (-7.0, 2.9),
                    (-3.0, 0.0),
                    (4.0, 0.4),
                    (20.0, 6.3),
                ],
                -5.0,
            )
            .one_way(&[(2.0, 2.0), (6.3, 3.4)])
            .tune(|t| t.run_accel = 40.0)
            .moving(
                (-4.0, 0.0),
                (3.0, 3.5),
                &[(0.0, ZERO, v(0.7, 0.0), v(0.1, 0.0))],
            );
        let saw = plain((-2.0, 2.0), (-1.0, 1.5));
        let still = Scene::boxed().region(Region::None, (-2.0, 2.0), (-1.0, 1.5));
        let way = [(0.0, v(-8.0, 2.0), v(3.1, 0.2), v(0.3, -0.1))];
        let scene = match moves {
            true => scene.mover(saw, &way),
            false => scene.mover(still, &[(0.0, v(300.0, 300.0), ZERO, ZERO)]),
        };
        scene.with(Variant::Plain, &|run: &mut Run| {
            for i in 0..20u32 {
                run.spawn(f64::from(i) * 1.63 - 16.1, 7.0);
                for n in 0..40u32 {
                    let wish = [1.0, -1.0, 1.0, 0.0, -1.0][((i + n) % 5) as usize];
                    run.hold(wish).jump(n % 3 == i % 3).down(n % 7 == 3);
                    run.advance(f64::from(n + 1) / 10.0);
                    let (p, w) = (run.at(), run.speed());
                    out.borrow_mut()
                        .push([p.x, p.y, w.x, w.y].map(f64::to_bits));
                }
            }
        });
        out.into_inner()
    };
    let (with, without) = (states(true), states(false));
    let differs = with.iter().zip(&without).position(|(a, b)| a != b);
    assert_eq!(differs, None);
}
