//! Scenes 21, 65 and 71: edges almost parallel, crowds of vertices, far and scaled worlds, shapes made to break movers.

use super::rig::*;
use crate::worlds::{Dice, Outline, random};
use edgewalker::geom::{Collider, Point, STEP, expand};
use edgewalker::mesh::{Mesh, MeshError};
use edgewalker::motion::{Body, Control, EventKind, Terrain, Trace, check::check};
use edgewalker::tune::Motion;
use glam::DVec2;

#[test]
fn scene_21_floors_that_cross_at_two_billionths_of_a_radian() {
    // From one end of the world to the other, the one a step higher on the left and the other on the right: where B walks,
    // they cross.
    let far = 3900.0;
    let floor = |left: f64, right: f64| [(-far, -1.0), (far, -1.0), (far, right), (-far, left)];
    let scene = Scene::boxed()
        .solid(&floor(STEP, 0.0))
        .solid(&floor(0.0, STEP));
    for variant in [Variant::Plain, Variant::Mirrored] {
        scene.with(variant, &|run: &mut Run| {
            run.spawn(-5.0, 1.0).advance(1.0).walk(5.0);
            run.trace.clear();
            let start = run.at();
            for tick in 1..=120 {
                run.advance(1.0 + f64::from(tick) / 60.0);
                assert!(run.supported());
                close(run.at().y, start.y, STEP);
            }
            assert!(run.kinds().iter().all(|&kind| kind == EventKind::Joint));
            close(run.at().x, start.x + 10.0, 1e-9);
        });
    }
}

#[test]
fn scene_21_ten_thousand_corners_on_a_spot_of_a_floor_do_not_show() {
    let mut dice = Dice::new(21);
    let mut scene = Scene::boxed().rect((-20.0, 20.0), (-1.0, 0.0));
    while scene.solids.len() < 3_334 {
        // Triangles with corners within four steps of the origin, none higher than a joint.
        let corner = |dice: &mut Dice| {
            v(
                f64::from(dice.below(9)) - 4.0,
                f64::from(dice.below(6)) - 3.0,
            )
        };
        let [a, b, c] = [(); 3].map(|()| corner(&mut dice));
        if (b - a).perp_dot(c - a) > 0.0 {
            scene.solids.push([a, b, c].map(|p| p * STEP).to_vec());
        }
    }
    scene.each(|run| {
        run.spawn(-3.0, 0.0).walk(5.0);
        run.trace.clear();
        for tick in 1..=72 {
            run.advance(f64::from(tick) / 60.0);
            assert!(run.supported());
            close(run.at().y, 0.0, 2.0 * STEP);
        }
        assert_eq!(run.kinds(), [], "no event");
        close(run.at().x, 3.0, 1e-9);
    });
}

/// Scenes 1, 12, 14, 39 and 42 in small, one after the other: boxes, a valley, a ramp into a wall, an arc, a drop; `scale`
/// is a power of two, and times stay the same.
fn course(scale: f64, offset: DVec2) -> (Vec<EventKind>, Vec<[f64; 2]>) {
    let outlines: Vec<Vec<(f64, f64)>> = vec![
        vec![(0.0, -1.0), (1.0, -1.0), (1.0, 0.0), (0.0, 0.0)],
        vec![(1.0, -1.0), (2.0, -1.0), (2.0, 0.0), (1.0, 0.0)],
        vec![
            (2.0, -1.0),
            (8.0, -5.0),
            (8.0, -4.0),
            (5.0, -2.0),
            (4.0, 0.0),
            (2.0, 0.0),
        ],
        vec![
            (8.0, -6.0),
            (16.0, -6.0),
            (16.0, -4.0),
            (14.0, -4.0),
            (12.0, -5.0),
            (8.0, -4.0),
        ],
        vec![
            (16.0, -6.0),
            (20.0, -6.0),
            (20.0, 2.0),
            (19.0, 2.0),
            (18.0, -1.0),
            (16.0, -4.0),
        ],
        vec![(20.0, -6.0), (21.0, -6.0), (21.0, 9.0), (20.0, 9.0)],
    ];
    let corner = |&(x, y): &(f64, f64)| Point::snap(v(x, y) * scale + offset).unwrap();
    let grown = v(HALF, TALL) * scale;
    let collider = box_collider(grown.x, grown.y);
    let features: Vec<_> = outlines
        .iter()
        .map(|o| expand(&o.iter().map(corner).collect::<Vec<_>>(), &collider))
        .collect();
    let mesh = Mesh::build(&features).unwrap();
    let base = plain();
    let tuning = Motion {
        gravity: base.gravity * scale,
        run_speed: base.run_speed * scale,
        run_accel: 20.0 * scale,
        run_brake: 20.0 * scale,
        jump_speed: base.jump_speed * scale,
        joint_span: base.joint_span * scale,
        ..base
    };
    let terrain = Terrain::new(&mesh, &mesh, &tuning);
    let mut trace = Trace::default();
    let mut body = Body::spawn(v(0.5, 0.5) * scale + offset, 0.0, &terrain).unwrap();
    let mut states = Vec::new();
    for tick in 0..600u32 {
        let control = Control {
            run: [1.0, 1.0, 1.0, -1.0, 0.0][(tick / 60 % 5) as usize],
            jump: tick % 90 > 70,
            ..Control::default()
        };
        body.apply(control, &terrain, &mut trace);
        body.advance(f64::from(tick + 1) / 60.0, &terrain, &mut trace);
        states.push(((body.position() - offset) / scale).to_array());
    }
    // Speeds count in the scaled world; what happened is the same.
    let plain = |kind: EventKind| match kind {
        EventKind::Landed(_) => EventKind::Landed(0.0),
        EventKind::Hit(_) => EventKind::Hit(0.0),
        EventKind::Stopped(_) => EventKind::Stopped(0.0),
        kind => kind,
    };
    (trace.events.iter().map(|e| plain(e.kind)).collect(), states)
}

fn largest_difference(a: &[[f64; 2]], b: &[[f64; 2]]) -> f64 {
    let off = |(p, q): (&[f64; 2], &[f64; 2])| (p[0] - q[0]).abs().max((p[1] - q[1]).abs());
    a.iter().zip(b).map(off).fold(0.0, f64::max)
}

#[test]
fn scene_65_scaled_and_shifted_worlds_move_alike() {
    let (events, here) = course(1.0, DVec2::ZERO);
    assert!(events.len() >= 20, "{events:?}");
    for scale in [1.0 / 1024.0, 1.0 / 64.0, 16.0, 32.0] {
        let (scaled, states) = course(scale, DVec2::ZERO);
        assert_eq!(scaled, events, "times {scale}");
        let off = largest_difference(&here, &states);
        assert!(off <= 1e-9, "times {scale}: off by {off}");
    }
    for offset in [v(1000.5, -2000.25), v(-4000.0, 4000.0), v(4060.0, -4080.0)] {
        let (shifted, states) = course(1.0, offset);
        assert_eq!(shifted, events, "at {offset}");
        let off = largest_difference(&here, &states);
        assert!(off <= 1e-9, "at {offset}: off by {off}");
    }
}

#[test]
fn scene_65_beyond_the_bound_of_the_world_is_an_error() {
    for far in [1e6, 1e9] {
        assert_eq!(Point::snap(v(far, 0.0)), None);
    }
    let edge = |x: i32| Point::new(x, 0);
    let far = edgewalker::geom::BOUND - 2;
    let outline = [edge(far - 65536), edge(far), Point::new(far, 65536)];
    let refused = Mesh::build(&[expand(&outline, &Collider::hero())]);
    assert!(matches!(
        refused,
        Err(MeshError::OutOfBounds { feature: 0, .. })
    ));
}

/// A comb: teeth a thousandth of a metre wide.
fn comb() -> Vec<Outline> {
    let tooth = |i: u32| {
        let x = f64::from(i) * 0.02;
        vec![
            v(x, 0.0),
            v(x + 0.001, 0.0),
            v(x + 0.001, 3.0 - f64::from(i % 7) * 0.3),
            v(x, 2.5),
        ]
    };
    (0..1000).map(tooth).collect()
}

/// A corridor that winds inwards: upright parts a thousandth wider than the hero, level parts just higher than he is.
fn spiral() -> Vec<Outline> {
    let (wide, high, wall) = (2.0 * 13.0 / 32.0 * 1.001, 109.0 / 64.0 * 1.001, 0.25);
    let rect =
        |x0: f64, y0: f64, x1: f64, y1: f64| vec![v(x0, y0), v(x1, y0), v(x1, y1), v(x0, y1)];
    let ring = |turn: u32| {
        let (x, y) = (
            1.0 + f64::from(turn) * (wide + wall),
            2.0 + f64::from(turn) * (high + wall),
        );
        // Each ring is open at its upper left, where the next one begins.
        [
            rect(-x - wall, -y - wall, x + wall, -y),
            rect(x, -y - wall, x + wall, y + wall),
            rect(-x + wide, y, x + wall, y + wall),
            rect(-x - wall, -y - wall, -x, y - high),
        ]
    };
    (0..6).flat_map(ring).collect()
}

/// A star of a thousand spikes.
fn spikes() -> Vec<Outline> {
    let corner = |i: u32| {
        let r = if i.is_multiple_of(2) { 12.0 } else { 4.0 };
        DVec2::from_angle(f64::from(i) / 2000.0 * std::f64::consts::TAU) * r
    };
    vec![(0..2000).map(corner).collect()]
}

/// Koch's snowflake, seven times refined: 3 * 4^7 corners.
fn koch() -> Vec<Outline> {
    let turn = DVec2::from_angle(-std::f64::consts::FRAC_PI_3);
    let mut curve: Outline = (0..3)
        .map(|i| DVec2::from_angle(f64::from(i) / 3.0 * std::f64::consts::TAU + 0.3) * 60.0)
        .collect();
    for _ in 0..7 {
        let side = |i: usize| {
            let (a, e) = (curve[i], curve[(i + 1) % curve.len()]);
            let third = (e - a) / 3.0;
            [
                a,
                a + third,
                a + third + turn.rotate(third),
                a + third * 2.0,
            ]
        };
        curve = (0..curve.len()).flat_map(side).collect();
    }
    vec![curve]
}

/// Ground of a hundred thousand corners.
fn terrain() -> Vec<Outline> {
    let mut dice = Dice::new(71);
    let n = 1000;
    let block = |b: u32, dice: &mut Dice| {
        let x = |i: u32| f64::from(b * n + i) * 0.02 - 1000.0;
        let mut outline = vec![v(x(0), -9.0), v(x(n), -9.0)];
        outline.extend((0..=n).rev().map(|i| v(x(i), dice.between(0.0, 0.03))));
        outline
    };
    (0..100).map(|b| block(b, &mut dice)).collect()
}

/// Lets heroes run, jump and crouch about in a world, every invariant checked after every tick; how many ticks were not idle.
fn populate(name: &str, world: &[Outline], reach: f64, bodies: u64, ticks: u32) -> u64 {
    let snap = |o: &Outline| {
        o.iter()
            .map(|&p| Point::snap(p).unwrap())
            .collect::<Vec<_>>()
    };
    let [stand, crouch] = [Collider::hero(), Collider::hero_crouched()].map(|collider| {
        let features: Vec<_> = world.iter().map(|o| expand(&snap(o), &collider)).collect();
        Mesh::build(&features).unwrap()
    });
    let tuning = Motion::default();
    let terrain = Terrain::new(&stand, &crouch, &tuning);
    let mut awake = 0;
    for seed in 0..bodies {
        let mut dice = Dice::new(seed);
        let mut body = loop {
            let at = v(dice.between(-reach, reach), dice.between(-reach, reach));
            if let Ok(body) = Body::spawn(at, 0.0, &terrain) {
                break body;
            }
        };
        let mut trace = Trace::default();
        for tick in 0..ticks {
            trace.clear();
            if tick % 12 == 0 {
                let control = Control {
                    run: f64::from(dice.below(3) - 1),
                    jump: dice.below(2) == 0,
                    down: dice.below(5) == 0,
                    ..Control::default()
                };
                body.apply(control, &terrain, &mut trace);
            }
            body.advance(f64::from(tick + 1) / 60.0, &terrain, &mut trace);
            let stuck = trace.events.iter().any(|e| e.kind == EventKind::Stuck);
            assert!(!stuck, "{name}, body {seed}, tick {tick}: stuck");
            let found = check(&body, &terrain, &trace);
            found.unwrap_or_else(|e| panic!("{name}, body {seed}, tick {tick}: {e}"));
            awake += u64::from(body.velocity() != DVec2::ZERO);
            if body.position().y < -3000.0 {
                break;
            }
        }
    }
    awake
}

#[test]
fn scene_71_shapes_made_to_break_movers() {
    let worlds = [
        ("comb", comb(), 8.0),
        ("spiral", spiral(), 14.0),
        ("spikes", spikes(), 14.0),
        ("koch", koch(), 70.0),
        ("terrain", terrain(), 30.0),
    ];
    for (name, world, reach) in &worlds {
        let awake = populate(name, world, *reach, 20, 600);
        assert!(awake > 1000, "{name}: {awake} ticks in motion");
    }
}

#[test]
fn scene_71_a_thousand_bodies_among_ten_thousand_polygons() {
    let world = random(&mut Dice::new(71), 10_000);
    let awake = populate("random", &world, 390.0, 1_000, 1_000);
    println!("{awake} of 1000000 steps in motion");
    assert!(awake > 300_000, "{awake}");
}
