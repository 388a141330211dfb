//! Worlds in which the fuzzer has found faults, cut down to what they need.

use super::rig::*;
use edgewalker::geom::STEP;
use edgewalker::motion::EventKind;
use edgewalker::tune::Motion;

/// Solids given in grid steps, for a point under the usual tuning but for wall jumps.
fn steps(solids: &[&[(i32, i32)]]) -> Scene {
    let metres = |&(x, y): &(i32, i32)| (f64::from(x) * STEP, f64::from(y) * STEP);
    let scene = Scene::point().tune(|t| {
        *t = Motion {
            wall_jump_up: 0.0,
            ..Motion::default()
        };
    });
    solids.iter().fold(scene, |scene, solid| {
        scene.solid(&solid.iter().map(metres).collect::<Vec<_>>())
    })
}

#[test]
fn a_slide_past_a_lip_of_one_step_is_not_put_back() {
    // Two long walls cross under a hundredth of a degree, one step beside a vertex of the second.
    let scene = steps(&[
        &[(490598, -946094), (440630, -1030752), (640000, -1030752)],
        &[
            (540566, -861437),
            (473942, -974313),
            (463702, -996841),
            (640000, -996841),
        ],
    ]);
    scene.each(|run| {
        run.spawn(7.69, -14.07).hold(1.0);
        let mut last = (run.at(), run.speed());
        for tick in 1..3000 {
            let at = run.advance(f64::from(tick) / 4000.0).at();
            let fastest = run.speed().length().max(last.1.length());
            let moved = (at - last.0).length();
            assert!(moved <= fastest / 4000.0 + 4.0 * STEP, "{last:?}, {at}");
            last = (at, run.speed());
        }
        assert!(last.0.y < -14.9, "{:?}: {last:?}", run.variant);
    });
}

#[test]
fn off_a_cut_wall_under_a_ceiling() {
    let scene = steps(&[
        &[
            (-528026, -784647),
            (-474778, -784647),
            (-474778, -700000),
            (-528026, -700000),
        ],
        &[
            (-505022, -838947),
            (-521602, -775543),
            (-600000, -775543),
            (-600000, -838947),
        ],
    ]);
    scene.each(|run| {
        run.spawn(-7.560681560539477, -12.247950398824482)
            .hold(1.0)
            .jump(true)
            .velocity(-9.978839086247095, 16.0)
            .ticks(2400, 24000.0);
        let parted = run
            .kinds()
            .iter()
            .filter(|k| **k == EventKind::Parted)
            .count();
        assert!(parted > 2, "{parted}, {:?}", run.trace.events);
    });
}

#[test]
fn a_rise_beside_a_corner_by_less_than_the_rounding_of_its_height() {
    let scene = Scene::point()
        .rect((0.0, 1.0), (1.0, 2.0))
        .rect((-9.0, 9.0), (-1.0, 0.0))
        .tune(|t| t.jump_speed = 16.0);
    for variant in [Variant::Plain, Variant::Mirrored] {
        scene.with(variant, &|run| {
            run.spawn(5.7e-14, 0.0)
                .advance(50.0)
                .jump(true)
                .ticks(60, 60.0);
            let hit = run.last(|k| matches!(k, EventKind::Hit(_))) - 50.0;
            // The first root of 16 t - 15 t^2 = 1.
            close(hit, (8.0 - 7.0) / 15.0, 1e-12);
        });
    }
}
