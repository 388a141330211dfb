//! Regions: coming and going are events at their own times, and change no bit of the motion.

use super::rig::*;
use edgewalker::motion::{Event, EventKind, Region};

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

#[test]
fn a_fall_through_a_region_has_the_times_of_the_closed_form() {
    let scene = floor()
        .region(Region::Plain, (-1.0, 1.0), (2.0, 4.0))
        .region(Region::None, (-1.0, 1.0), (5.0, 6.0))
        .region(Region::Plain, (-9.0, 9.0), (3.0, 30.0));
    for rate in [15.0, 60.0, 1000.0] {
        scene.each(|run| {
            run.spawn(0.0, 10.0);
            assert_eq!(run.body().regions(), [3], "put there without an event");
            run.ticks(2 * rate as u32, rate);
            let seen = visits(run);
            let at = |y: f64| ((10.0 - y) / 15.0f64).sqrt();
            let expected = [(at(4.0), 1, true), (at(3.0), 3, false), (at(2.0), 1, false)];
            assert_eq!(seen.len(), 3, "{seen:?}");
            for (got, want) in seen.iter().zip(expected) {
                close(got.0, want.0, 1e-12);
                assert_eq!((got.1, got.2), (want.1, want.2));
            }
        });
    }
}

#[test]
fn a_walk_through_a_region_has_no_other_event() {
    floor()
        .region(Region::Plain, (2.0, 4.0), (-1.0, 1.0))
        .each(|run| {
            run.spawn(0.0, 0.0).walk(5.0);
            run.trace.clear();
            run.advance(2.0).near(10.0, 0.0, 0.0);
            assert_eq!(run.kinds(), [EventKind::Entered(1), EventKind::Exited(1)]);
            let times: Vec<_> = run.trace.events.iter().map(|e| e.time).collect();
            assert_eq!(times, [0.4, 0.8]);
        });
}

#[test]
fn a_body_that_stands_in_a_region_jumps_in_it_and_out_of_it() {
    let scene = floor().region(Region::Plain, (-1.0, 1.0), (-1.0, 1.0));
    scene.each(|run| {
        run.spawn(0.0, 0.0);
        assert_eq!((run.body().regions(), visits(run)), (&[1][..], vec![]));
        run.jump(true).advance(1.0);
        // 12 t - 15 t^2 = 1.
        let root = (144.0f64 - 60.0).sqrt();
        let seen = visits(run);
        close(seen[0].0, (12.0 - root) / 30.0, 1e-15);
        close(seen[1].0, (12.0 + root) / 30.0, 1e-15);
        assert_eq!(run.body().regions(), [1]);
    });
}

#[test]
fn to_fall_through_a_one_way_may_be_to_change_regions() {
    let scene = Scene::boxed()
        .one_way(&[(-5.0, 0.0), (5.0, 0.0)])
        .region(Region::Plain, (-5.0, 5.0), (0.0, 3.0))
        .region(Region::Plain, (-5.0, 5.0), (-3.0, 0.0));
    scene.each(|run| {
        run.spawn(0.0, 0.0);
        assert_eq!(run.body().regions(), [1]);
        run.advance(0.5).down(true).jump(true);
        assert_eq!(visits(run), [(0.5, 1, false), (0.5, 2, true)]);
    });
}

/// Hills and walls, with one-ways, and regions all over them.
fn hills(regions: bool) -> Scene {
    let top = [
        (-20.0, 6.0),
        (-12.0, 1.7),
        (-7.0, 2.9),
        (-3.0, 0.0),
        (4.0, 0.4),
        (9.0, 4.1),
        (20.0, 6.3),
    ];
    let scene = Scene::boxed()
        .under(&top, -5.0)
        .rect((-1.0, 1.0), (2.5, 3.0))
        .one_way(&[(2.0, 2.0), (4.1, 2.7), (6.3, 3.4)]);
    let sizes = [0.3, 1.1, 2.7, 0.07];
    (0..60u32).filter(|_| regions).fold(scene, |scene, i| {
        let (x, y) = (
            f64::from(i) * 0.61 - 18.3,
            f64::from(i * 7 % 11) * 0.63 - 1.4,
        );
        let size = sizes[i as usize % 4];
        scene.region(Region::Plain, (x, x + size), (y, y + 1.7 * size))
    })
}

#[test]
fn regions_change_no_bit_of_the_motion() {
    let states = |regions: bool, variant: Variant| {
        let out = std::cell::RefCell::new(Vec::new());
        hills(regions)
            .tune(|t| t.run_accel = 40.0)
            .with(variant, &|run: &mut Run| {
                for i in 0..40u32 {
                    run.spawn(f64::from(i) * 0.83 - 16.1, 7.0);
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
    for variant in [Variant::Plain, Variant::Mirrored, Variant::Shifted] {
        let (with, without) = (states(true, variant), states(false, variant));
        let differs = with.iter().zip(&without).position(|(a, b)| a != b);
        assert_eq!(
            differs.map(|i| (i, with[i], without[i])),
            None,
            "{variant:?}"
        );
    }
}
