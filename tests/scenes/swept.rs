//! B. Swept motion.

use super::rig::*;
use edgewalker::geom::STEP;
use edgewalker::motion::EventKind;

#[test]
fn scene_22_exactly_through_free_vertices() {
    // Stars of free edges with their centres on the parabola x = 4t, y = 8t - 16t^2 and on the upright x = 0.
    let star = |scene: Scene, x: f64, y: f64| {
        let tips = [
            (1.0, 0.5),
            (-0.5, 1.0),
            (-1.0, -0.25),
            (0.25, -0.75),
            (0.5, 0.0),
            (0.0, 0.5),
        ];
        tips.iter()
            .fold(scene, |s, (dx, dy)| s.wire((x, y), (x + dx, y + dy)))
    };
    let scene = Scene::point().tune(|t| t.gravity = 32.0);
    let scene = [0.125, 0.25, 0.5, 0.75]
        .iter()
        .fold(scene, |s, t| star(s, 4.0 * t, 8.0 * t - 16.0 * t * t));
    let scene = star(scene, 0.0, -4.0);
    scene.each(|run| {
        run.spawn(0.0, 0.0).velocity(4.0, 8.0);
        for tick in 1..=64 {
            let t = f64::from(tick) / 64.0;
            run.advance(t).near(4.0 * t, 8.0 * t - 16.0 * t * t, 0.0);
        }
        run.spawn(0.0, 0.0).advance(0.5).near(0.0, -4.0, 0.0);
        run.advance(1.0).near(0.0, -16.0, 0.0);
        assert_eq!(run.kinds(), []);
    });
}

#[test]
fn scene_23_along_a_hundred_free_edges() {
    let scene = (0..100).fold(Scene::point(), |s, i| {
        let x = f64::from(i) * 0.5;
        s.wire((x, 0.0), (x + 0.5, 0.0))
            .wire((x, 0.0), (x, if i % 2 == 0 { 1.0 } else { -1.0 }))
    });
    scene.tune(|t| t.gravity = 0.0).each(|run| {
        run.spawn(-1.0, 0.0)
            .velocity(8.0, 0.0)
            .advance(8.0)
            .near(63.0, 0.0, 0.0);
        assert_eq!(run.kinds(), []);
        assert!(run.trace.crossed <= 400, "{} crossings", run.trace.crossed);
    });
}

#[test]
fn scene_24_starts_on_edges_and_vertices() {
    // On the top of a box, at its corner, on its side: in, out and along. What leads in is stopped, what leads out goes on, what
    // leads along is a touch.
    let scene = Scene::point()
        .rect((0.0, 2.0), (0.0, 2.0))
        .tune(|t| t.gravity = 0.0);
    let still = (0.0, 0.0);
    let cases = [
        ((1.0, 2.0), (0.0, -3.0), still),
        ((1.0, 2.0), (0.0, 3.0), (0.0, 3.0)),
        ((1.0, 2.0), (3.0, 0.0), (3.0, 0.0)),
        ((2.0, 2.0), (3.0, 4.0), (3.0, 4.0)),
        ((2.0, 2.0), (0.0, -3.0), (0.0, -3.0)),
        ((2.0, 2.0), (3.0, 0.0), (3.0, 0.0)),
        ((2.0, 1.0), (-3.0, 0.0), still),
        ((2.0, 1.0), (3.0, 0.0), (3.0, 0.0)),
        ((2.0, 1.0), (0.0, 3.0), (0.0, 3.0)),
    ];
    scene.each(|run| {
        for ((x, y), (vx, vy), (wx, wy)) in cases {
            run.spawn(x, y).velocity(vx, vy).advance(0.25);
            run.near(x + wx * 0.25, y + wy * 0.25, 0.0);
            assert_eq!(run.speed(), v(wx, wy), "from ({x}, {y}) with ({vx}, {vy})");
            assert!(run.trace.crossed <= 8, "{} hops", run.trace.crossed);
        }
    });
}

#[test]
fn scene_25_out_and_in_by_the_same_edge_in_one_step() {
    // A tall thin spike beside the path gives the free space edges that the parabola crosses twice.
    let scene = Scene::point()
        .rect((-20.0, 20.0), (-1.0, 0.0))
        .rect((-20.0, -19.0), (0.0, 3.0))
        .rect((19.0, 20.0), (0.0, 3.0));
    scene.each(|run| {
        for height in [2.0, 4.0, 9.0] {
            run.spawn(-3.0, 1.0)
                .velocity(2.0, f64::sqrt(60.0 * height))
                .advance(0.4);
            let t = run.time();
            run.near(
                -3.0 + 2.0 * t,
                1.0 + f64::sqrt(60.0 * height) * t - 15.0 * t * t,
                1e-12,
            );
        }
    });
}

#[test]
fn scene_26_a_ceiling_at_the_apex_and_one_step_below() {
    let scene = |ceiling: f64| {
        Scene::point()
            .rect((-5.0, 5.0), (-1.0, 0.0))
            .rect((-5.0, 5.0), (ceiling, 9.0))
            .tune(|t| t.gravity = 32.0)
    };
    let landing = |k| matches!(k, EventKind::Landed(_));
    scene(2.25).with(Variant::Plain, &|run: &mut Run| {
        run.spawn(0.0, 0.0).jump(true);
        run.trace.clear();
        run.advance(1.0);
        assert_eq!(
            (run.kinds().len(), run.when(landing)),
            (1, 0.75),
            "no loss at a touch"
        );
    });
    scene(2.25 - STEP).with(Variant::Plain, &|run: &mut Run| {
        run.spawn(0.0, 0.0).jump(true);
        run.trace.clear();
        run.advance(1.0);
        assert_eq!(run.trace.events[0].time, 0.3740234375);
        assert_eq!(run.trace.events[0].kind, EventKind::Hit(0.03125));
        close(run.when(landing), 0.749022165932, 1e-12);
    });
    let speed = 12.0 * (1.0 + f64::powi(2.0, -34));
    scene(2.25)
        .tune(|t| t.jump_speed = speed)
        .with(Variant::Plain, &|run: &mut Run| {
            run.spawn(0.0, 0.0).jump(true).advance(1.0);
            let exact =
                (speed - 12.0 * f64::sqrt(f64::powi(2.0, -33) + f64::powi(2.0, -68))) / 32.0;
            close(run.when(|k| matches!(k, EventKind::Hit(_))), exact, 3e-6);
        });
}

#[test]
fn scene_27_a_hundred_thousand_kilometres_a_second() {
    let scene = (0..1000).fold(Scene::point(), |s, i| {
        let x = 4.0 * f64::from(i % 500) - 1000.0;
        s.rect(
            (x, x + 1.0),
            if i < 500 { (-1.0, 0.5) } else { (-5.0, -4.0) },
        )
    });
    scene.tune(|t| t.gravity = 0.0).each(|run| {
        run.spawn(-1001.0, 0.25)
            .velocity(1e8, 0.0)
            .advance(1.0)
            .near(-1000.0, 0.25, 0.0);
        run.spawn(-1001.0, 0.75).velocity(1e8, 0.0).advance(1e-5);
        assert!(
            run.trace.crossed < 4000,
            "linear in the faces crossed: {}",
            run.trace.crossed
        );
    });
}

#[test]
fn scene_28_steps_of_no_and_of_great_length() {
    let scene = Scene::boxed().rect((-50.0, 50.0), (-1.0, 0.0));
    scene.each(|run| {
        run.spawn(0.0, 5.0).velocity(1.0, 2.0).advance(0.1);
        let before = run.body().clone();
        run.advance(0.1);
        assert_eq!(*run.body(), before, "0 ulp");
        for tiny in [1e-300, 1e-12] {
            let now = run.time();
            let (p, u) = (run.at(), run.speed());
            run.advance(now + tiny)
                .near(p.x + u.x * tiny, p.y + u.y * tiny, 1e-14);
        }
        run.advance(10.1);
        assert!(run.supported());
    });
}

#[test]
fn scene_29_ten_thousand_stairs_in_one_step() {
    let mut top = Vec::new();
    for i in 0..10_000 {
        let (x, y) = (f64::from(i) * 0.25, -f64::from(i) * 0.125);
        top.extend([(x, y), (x + 0.25, y)]);
    }
    let scene = Scene::boxed()
        .under(&top, -1300.0)
        .tune(|t| t.run_speed = 200.0);
    let ends = [1, 1_000].map(|steps| {
        let end = std::cell::Cell::new((v(0.0, 0.0), 0));
        scene.with(Variant::Plain, &|run: &mut Run| {
            run.spawn(0.1, 0.0)
                .walk(200.0)
                .ticks(steps, f64::from(steps) / 10.0);
            end.set((run.at(), run.trace.events.len()));
        });
        end.get()
    });
    assert_eq!(ends[0], ends[1]);
    assert!(ends[0].0.x > 1_000.0);
}

/// Slopes, joints, a step, a wall: something of everything.
pub fn course() -> Scene {
    let top = [
        (0.0, 0.0),
        (8.0, 0.0),
        (12.0, 2.0),
        (15.0, 2.0),
        (20.0, -1.0),
        (26.0, -1.0),
        (26.0, 0.5),
        (34.0, 0.5),
    ];
    let scene = Scene::boxed()
        .under(&top, -5.0)
        .rect((33.0, 36.0), (-5.0, 9.0))
        .solid(&[(5.0, 3.5), (11.0, 5.0), (5.0, 5.0)]);
    scene.tune(|t| {
        (
            t.run_accel,
            t.run_brake,
            t.air_accel,
            t.run_speed,
            t.jump_speed,
        ) = (40.0, 60.0, 20.0, 7.0, 12.0)
    })
}

#[test]
fn scene_30_the_tick_rate_changes_no_bit() {
    for variant in [Variant::Plain, Variant::Mirrored, Variant::Shifted] {
        let run_at = |rate: f64| {
            let out = std::cell::RefCell::new(Vec::new());
            course().with(variant, &|run: &mut Run| {
                run.spawn(1.0, 3.0).hold(1.0).jump(true);
                for _ in 0..60 {
                    run.ticks((rate / 10.0) as u32, rate);
                    out.borrow_mut().push(run.body().hash());
                }
                out.borrow_mut()
                    .extend(run.trace.events.iter().map(|e| e.time.to_bits()));
            });
            out.into_inner()
        };
        let slow = run_at(30.0);
        for rate in [10.0, 60.0, 120.0, 240.0, 1000.0] {
            assert_eq!(slow, run_at(rate), "{rate} Hz");
        }
    }
}

#[test]
fn scene_31_a_thin_wall_stops_a_fast_walker() {
    let scene = Scene::boxed()
        .rect((-20.0, 20.0), (-1.0, 0.0))
        .rect((10.0, 10.0 + STEP), (0.0, 3.0));
    scene.tune(|t| t.run_speed = 1e4).each(|run| {
        run.spawn(0.0, 0.0)
            .walk(10_000.0)
            .advance(1.0)
            .near(10.0 - HALF, 0.0, 0.0);
        assert!(run.supported());
        assert_eq!(run.speed(), v(0.0, 0.0));
    });
}

#[test]
fn scene_32_a_slanted_landing_keeps_what_runs_along() {
    Scene::point()
        .rect((-50.0, 50.0), (-1.0, 0.0))
        .tune(|t| t.gravity = 0.0)
        .with(Variant::Plain, &|run: &mut Run| {
            run.spawn(0.0, 1.0)
                .velocity(10.0, -10.0)
                .advance(1.0)
                .near(10.0, 0.0, 1e-14);
            close(run.when(|k| matches!(k, EventKind::Landed(_))), 0.1, 1e-16);
        });
}

#[test]
fn scene_33_landing_and_slide_within_one_step() {
    let scene = Scene::boxed().under(&[(0.0, 8.0), (15.0, 0.0), (40.0, 0.0)], -2.0);
    let end = |rate: f64| {
        let out = std::cell::Cell::new(0);
        scene.with(Variant::Plain, &|run: &mut Run| {
            run.spawn(3.0, 8.0)
                .velocity(3.0, -20.0)
                .ticks((rate * 2.0) as u32, rate);
            out.set(run.body().hash());
        });
        out.get()
    };
    assert_eq!(end(30.0), end(240.0));
}
