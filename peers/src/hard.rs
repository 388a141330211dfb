//! The hard cases that all movers can be asked: each a scene with a closed form, run at 60 Hz.

use crate::scene::{FlightAndSlide, HALF, Scene, Shape, TALL, parabola, rect, v};
use crate::scenes::{GRAVITY, SLOPE, empty, hill, jump, lift, slope, vee, walls};
use edgewalker::geom::STEP;
use edgewalker::motion::Piece;
use glam::DVec2;
use std::sync::Arc;

/// A case: its number among the 71 of the hard cases, and its scene.
pub struct Case {
    pub number: &'static str,
    pub scene: Scene,
    /// What counts as held, m: for us; the grid's own rounding where a scene is finer than that.
    pub tolerance: f64,
}

/// Ticks per second.
pub const RATE: f64 = 60.0;

const EXACT: f64 = 1e-9;

fn case(number: &'static str, scene: Scene) -> Case {
    Case {
        number,
        scene,
        tolerance: EXACT,
    }
}

/// A scene in which bodies walk.
fn walk(what: &'static str, speed: f64, from: f64, seconds: f64) -> Scene {
    Scene {
        start: v(from, 0.0),
        velocity: v(speed, 0.0),
        walk: Some(speed),
        stands: true,
        slides: false,
        ..empty("", what, seconds)
    }
}

/// A scene without gravity.
fn weightless(what: &'static str, start: DVec2, velocity: DVec2, seconds: f64) -> Scene {
    Scene {
        start,
        velocity,
        gravity: 0.0,
        ..empty("", what, seconds)
    }
}

/// A fall from rest at x = 0.
fn drop(what: &'static str, from: f64, seconds: f64) -> Scene {
    Scene {
        start: v(0.0, from),
        ..empty("", what, seconds)
    }
}

fn box_only(path: impl Fn(f64) -> DVec2 + Send + Sync + 'static) -> crate::scene::Exact {
    Arc::new(move |_, t| Some(path(t)))
}

pub fn all() -> Vec<Case> {
    let mut all = geometry();
    all.extend(vees());
    all.extend(corridors());
    all.extend(swept());
    all.extend(slopes());
    all.extend(moving());
    all
}

fn geometry() -> Vec<Case> {
    let floor = |top: f64| rect((-20.0, 40.0), (top - 1.0, top));
    let uneven = (0..1000).map(|i| {
        let lip = f64::from(i % 2) * STEP;
        rect(
            (f64::from(i) * 0.125, f64::from(i + 1) * 0.125),
            (-1.0, lip),
        )
    });
    let column = |gap: f64| -> Vec<Vec<DVec2>> {
        let x = 0.0 + gap;
        (-200..=0)
            .map(|k| rect((x, x + 1.0), (f64::from(k), f64::from(k) + 1.0)))
            .collect()
    };
    let beside = |gap, what| Scene {
        solids: column(gap),
        start: v(-HALF, -TALL / 2.0),
        exact: box_only(|t| v(-HALF, -TALL / 2.0 - 15.0 * t * t)),
        ..empty("", what, 2.0)
    };
    let thin = |i: u32| {
        rect(
            (-10.0, 10.0),
            (f64::from(2 * i) * -STEP - STEP, f64::from(2 * i) * -STEP),
        )
    };
    let onto = |count: u32, what| Scene {
        solids: (0..count).map(thin).collect(),
        exact: Arc::new(|_, t| Some(v(0.0, (100.0 - 10_000.0 * t - 15.0 * t * t).max(0.0)))),
        velocity: v(0.0, -10_000.0),
        ..drop(what, 100.0, 1.0)
    };
    let needle = vec![v(0.0, 0.0), v(1.0 / 512.0, 0.0), v(1.0 / 1024.0, 10.0)];
    vec![
        case(
            "1",
            Scene {
                name: "",
                ..crate::scenes::seamed()
            },
        ),
        Case {
            tolerance: 2.0 * STEP,
            ..case(
                "2",
                Scene {
                    solids: uneven.collect(),
                    start: v(1.0, STEP),
                    exact: box_only(|t| v(1.0 + 5.0 * t, 0.0)),
                    ..walk(
                        "walks over boxes whose tops differ by 15 micrometres",
                        5.0,
                        1.0,
                        10.0,
                    )
                },
            )
        },
        case(
            "3",
            beside(0.0, "falls along a column of boxes, touching it"),
        ),
        case(
            "3",
            beside(1.0 / 32.0, "falls along a column of boxes, 31 mm from it"),
        ),
        case("8", onto(1, "hits a slab 15 micrometres thick at 10 km/s")),
        case("10", onto(7, "hits seven of them, 15 micrometres apart")),
        case(
            "11",
            Scene {
                solids: vec![floor(0.0), needle],
                exact: Arc::new(|shape, t| Some(v((5.0 * t - 5.0).min(-stops(shape)), 0.0))),
                ..walk("walks into a needle 2 mm thick", 5.0, -5.0, 3.0)
            },
        ),
    ]
}

/// How far from an upright wall's foot the middle of the foot stops.
fn stops(_: Shape) -> f64 {
    HALF
}

fn vees() -> Vec<Case> {
    let vee_of = |run: f64, rise: f64, times: f64, what| {
        let normal = v(rise, run) / (run * run + rise * rise).sqrt();
        let rest = move |shape: Shape| shape.reach(normal) / normal.y;
        // From so high that both shapes start clear of the walls.
        let from = rest(Shape::Box).max(rest(Shape::Capsule)) + 6.0;
        Case {
            // Where walls are steep, the grid's half step across is more along.
            tolerance: EXACT,
            ..case(
                "12",
                Scene {
                    solids: walls(run, rise, times),
                    exact: Arc::new(move |shape, t| {
                        Some(v(0.0, (from - 15.0 * t * t).max(rest(shape))))
                    }),
                    ..drop(what, from, 10.0)
                },
            )
        }
    };
    vec![
        vee_of(16.0, 16.0, 1.0, "falls into a V of half-angle 45 degrees"),
        vee_of(8.0, 15.0, 2.0, "of 28 degrees"),
        vee_of(15.0, 56.0, 1.0, "of 15 degrees"),
        vee_of(7.0, 80.0, 1.0, "of 5 degrees"),
        vee_of(1.0, 115.0, 1.0, "of 0.5 degrees"),
    ]
}

fn corridors() -> Vec<Case> {
    let ceiling = vec![
        v(-20.0, 10.0),
        v(-20.0, 2.0 + 20.0 / 64.0),
        v(64.0, 1.0),
        v(64.0, 10.0),
    ];
    let floor = rect((-20.0, 80.0), (-1.0, 0.0));
    let corridor = |steps: f64| {
        vec![
            floor.clone(),
            rect((0.0, 60.0), (TALL + steps * STEP, 10.0)),
        ]
    };
    let ledge = |aside: f64| Scene {
        solids: vec![rect((-1.0, 0.0), (-1.0, 0.0))],
        start: v(HALF - aside, 5.0),
        ..empty("", "", 2.0)
    };
    let normal = v(-1.0, -64.0) / 4097f64.sqrt();
    // The ceiling's line, 64 y + x = 128, touched from below while the foot is at y = 0.
    let wedged = move |shape: Shape| 128.0 - shape.reach(normal) * 4097f64.sqrt();
    vec![
        case(
            "13",
            Scene {
                solids: vec![floor.clone(), ceiling],
                exact: Arc::new(move |shape, t| Some(v((5.0 * t).min(wedged(shape)), 0.0))),
                ..walk(
                    "walks under a ceiling that comes down to meet it",
                    5.0,
                    0.0,
                    10.0,
                )
            },
        ),
        case(
            "14",
            Scene {
                solids: vec![
                    rect((-20.0, 6.0), (-1.0, 0.0)),
                    vec![v(0.0, 0.0), v(5.0, 0.0), v(5.0, 5.0)],
                    rect((5.0, 6.0), (0.0, 20.0)),
                ],
                exact: Arc::new(|shape, t| {
                    let foot = match shape {
                        Shape::Box => 5.0,
                        Shape::Capsule => 5.0 - HALF + HALF * (2f64.sqrt() - 1.0),
                    };
                    (t >= 6.0).then(|| v(5.0 - HALF, foot))
                }),
                ..walk(
                    "walks up a ramp of 45 degrees into a wall, and holds on",
                    5.0,
                    -2.0,
                    10.0,
                )
            },
        ),
        case(
            "16",
            Scene {
                solids: corridor(1.0),
                exact: box_only(|t| v(5.0 * t - 5.0, 0.0)),
                ..walk(
                    "walks through a corridor 15 micrometres higher than it",
                    5.0,
                    -5.0,
                    10.0,
                )
            },
        ),
        case(
            "16",
            Scene {
                solids: corridor(-1.0),
                exact: Arc::new(|shape, t| match shape {
                    Shape::Box => Some(v((5.0 * t - 5.0).min(-HALF), 0.0)),
                    Shape::Capsule => None,
                }),
                ..walk("is stopped by one 15 micrometres lower", 5.0, -5.0, 10.0)
            },
        ),
        case(
            "17",
            Scene {
                what: "falls past a ledge with its side in line with the ledge's",
                exact: box_only(|t| v(HALF, 5.0 - 15.0 * t * t)),
                ..ledge(0.0)
            },
        ),
        case(
            "17",
            Scene {
                what: "the same 15 micrometres over it: lands on it",
                exact: Arc::new(|shape, t| match shape {
                    Shape::Box => Some(v(HALF - STEP, (5.0 - 15.0 * t * t).max(0.0))),
                    Shape::Capsule => None,
                }),
                ..ledge(STEP)
            },
        ),
    ]
}

fn swept() -> Vec<Case> {
    let walls = |count: u32| -> Vec<Vec<DVec2>> {
        (0..count)
            .map(|i| rect((10.0 + f64::from(i), 10.5 + f64::from(i)), (-50.0, 50.0)))
            .collect()
    };
    // A jump that just reaches a ceiling: with gravity 32 from 12 m/s up it turns 2.25 m higher.
    let grazes = Scene {
        gravity: 32.0,
        solids: vec![
            rect((-9.0, 9.0), (-1.0, 0.0)),
            rect((-9.0, 9.0), (2.75 + TALL, 9.0)),
        ],
        velocity: v(0.0, 12.0),
        exact: box_only(|t| v(0.0, (0.5 + 12.0 * t - 16.0 * t * t).max(0.0))),
        ..drop(
            "jumps until its head grazes a ceiling at no speed",
            0.5,
            1.0,
        )
    };
    vec![
        case("26", grazes),
        case(
            "27",
            Scene {
                solids: walls(1000),
                exact: box_only(|t| v((1e8 * t).min(10.0 - HALF), 0.0)),
                ..weightless(
                    "flies at 1e8 m/s into the first of 1000 walls",
                    DVec2::ZERO,
                    v(1e8, 0.0),
                    0.1,
                )
            },
        ),
        case(
            "31",
            Scene {
                solids: vec![
                    rect((-20.0, 40.0), (-1.0, 0.0)),
                    rect((10.0, 10.0 + STEP), (0.0, 3.0)),
                ],
                exact: box_only(|t| v((1e4 * t).min(10.0 - HALF), 0.0)),
                ..walk(
                    "glides at 10 km/s into a wall 15 micrometres thick",
                    1e4,
                    0.0,
                    0.5,
                )
            },
        ),
        case(
            "32",
            Scene {
                solids: vec![rect((-20.0, 40.0), (-1.0, 0.0))],
                exact: box_only(|t| v(10.0 * t, (1.0 - 10.0 * t).max(0.0))),
                ..weightless(
                    "lands without gravity and glides on",
                    v(0.0, 1.0),
                    v(10.0, -10.0),
                    1.0,
                )
            },
        ),
        case("33", jump()),
    ]
}

fn slopes() -> Vec<Case> {
    // Ground that rises 20 m on 21 m, 43.6 degrees.
    let steep = v(-20.0, 21.0) / 29.0;
    let stand =
        |normal: DVec2, shape: Shape, x: f64| v(x, (shape.reach(normal) - normal.x * x) / normal.y);
    let idle = Scene {
        solids: vec![vec![v(-42.0, -40.0), v(42.0, -40.0), v(42.0, 40.0)]],
        start: v(-HALF, 0.0),
        exact: Arc::new(move |shape, t| (t >= 1.0).then(|| stand(steep, shape, -HALF))),
        ..walk(
            "idles on a slope of 43.6 degrees for a minute",
            0.0,
            0.0,
            60.0,
        )
    };
    let up = v(-SLOPE.x, SLOPE.y);
    let thrown = FlightAndSlide {
        from: v(-4.0, 1.0),
        velocity: v(10.0, 0.0),
        gravity: GRAVITY,
        normal: up,
    };
    let landing = FlightAndSlide {
        from: v(-1.0, 4.0),
        velocity: v(10.0, -10.0),
        gravity: 0.0,
        normal: v(1.0, 1.0) / 2f64.sqrt(),
    };
    let edge = Scene {
        solids: vec![rect((-20.0, 0.0), (-1.0, 0.0))],
        exact: Arc::new(|shape, t| {
            let air = (t - (5.0 + shape.leaves_at()) / 5.0).max(0.0);
            Some(v(5.0 * t - 5.0, -15.0 * air * air))
        }),
        ..walk("walks off a floor's end and falls", 5.0, -5.0, 2.0)
    };
    vec![
        case("34", idle),
        case("36", slope()),
        case(
            "37",
            Scene {
                solids: vec![vec![
                    v(-30.0, -40.0),
                    v(75.0, -40.0),
                    v(75.0, 40.0),
                    v(-30.0, -16.0),
                ]],
                start: thrown.from,
                velocity: thrown.velocity,
                exact: Arc::new(move |shape, t| Some(thrown.at(shape, t))),
                ..empty(
                    "",
                    "lands on an icy slope going up, slides up, stops, comes back",
                    2.0,
                )
            },
        ),
        case("42", hill(8.0)),
        case(
            "42",
            Scene {
                what: "the same at 5 m/s",
                ..hill(5.0)
            },
        ),
        case("43", edge),
        case(
            "47",
            Scene {
                solids: vec![vec![v(-30.0, 30.0), v(-30.0, -30.0), v(30.0, -30.0)]],
                exact: Arc::new(move |shape, t| Some(landing.at(shape, t))),
                ..weightless(
                    "lands along a slope of 45 degrees and keeps its speed",
                    landing.from,
                    landing.velocity,
                    1.0,
                )
            },
        ),
    ]
}

fn moving() -> Vec<Case> {
    let stops_dead = |t: f64| match t {
        t if t < 1.0 => v(0.0, 10.0 * t),
        t => v(
            0.0,
            parabola(v(0.0, 10.0), v(0.0, 10.0), v(0.0, -GRAVITY), t - 1.0)
                .y
                .max(10.0),
        ),
    };
    let piece = |t0, y: f64, u: f64| Piece {
        t0,
        p0: v(0.0, y),
        v0: v(0.0, u),
        accel: DVec2::ZERO,
    };
    let mut rises = lift();
    if let Some(lift) = &mut rises.lift {
        lift.pieces = vec![piece(0.0, 0.0, 10.0), piece(1.0, 10.0, 0.0)];
    }
    vec![
        case("52", lift()),
        case(
            "53",
            Scene {
                what: "stands on a lift that rises at 10 m/s and stops dead: flies on and lands",
                seconds: 2.5,
                velocity: v(0.0, 10.0),
                exact: Arc::new(move |_, t| Some(stops_dead(t))),
                ..rises
            },
        ),
        case("58", slides_past()),
        case("12", vee()),
    ]
}

/// A platform passes under the floor that the body stands on.
fn slides_past() -> Scene {
    let mut scene = lift();
    scene.solids = vec![rect((-9.0, 9.0), (-1.0, 0.0))];
    if let Some(lift) = &mut scene.lift {
        lift.outline = rect((-6.0, 0.0), (-2.0, 0.0));
        lift.pieces = vec![Piece {
            t0: 0.0,
            p0: DVec2::ZERO,
            v0: v(3.0, 0.0),
            accel: DVec2::ZERO,
        }];
    }
    Scene {
        what: "stands on a floor while a platform slides past in it, level with it",
        start: v(5.0, 0.0),
        exact: Arc::new(|_, _| Some(v(5.0, 0.0))),
        ..scene
    }
}
