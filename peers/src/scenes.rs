//! The scenes of the work-precision diagrams: each has a closed form for all movers and shapes.

use crate::scene::{FlightAndSlide, Lift, Scene, Shape, rect, v};
use edgewalker::motion::Piece;
use glam::DVec2;
use std::sync::Arc;

/// Gravity of all of them, m/s^2.
pub const GRAVITY: f64 = 30.0;

/// Normal of a slope that falls 8 m on 15 m to the right: 28.07 degrees, and no rounding in a unit vector.
pub const SLOPE: DVec2 = DVec2::new(8.0 / 17.0, 15.0 / 17.0);

/// A scene without solids, at rest at the origin.
pub fn empty(name: &'static str, what: &'static str, seconds: f64) -> Scene {
    Scene {
        name,
        what,
        solids: Vec::new(),
        lift: None,
        start: DVec2::ZERO,
        velocity: DVec2::ZERO,
        stands: false,
        walk: None,
        gravity: GRAVITY,
        slides: true,
        seconds,
        exact: Arc::new(|_, _| None),
    }
}

/// Boxes of a metre side by side, from x = 0.
pub fn seams(count: u32) -> Vec<Vec<DVec2>> {
    let unit = |i| rect((f64::from(i), f64::from(i) + 1.0), (-1.0, 0.0));
    (0..count).map(unit).collect()
}

/// All of them.
pub fn all() -> Vec<Scene> {
    vec![jump(), slope(), seamed(), hill(8.0), lift(), vee()]
}

pub fn jump() -> Scene {
    let path = FlightAndSlide {
        from: v(0.0, 1.0),
        velocity: v(5.0, 12.0),
        gravity: GRAVITY,
        normal: DVec2::Y,
    };
    Scene {
        solids: vec![rect((-5.0, 40.0), (-1.0, 0.0))],
        start: path.from,
        velocity: path.velocity,
        exact: Arc::new(move |shape, t| Some(path.at(shape, t))),
        slides: false,
        ..empty(
            "jump",
            "jumps with 12 m/s up and 5 m/s ahead, lands a metre lower on a floor of one piece, 45 m wide, glides on",
            2.0,
        )
    }
}

pub fn slope() -> Scene {
    let path = FlightAndSlide {
        from: v(0.0, 1.0),
        velocity: DVec2::ZERO,
        gravity: GRAVITY,
        normal: SLOPE,
    };
    Scene {
        solids: vec![vec![v(-15.0, -40.0), v(75.0, -40.0), v(-15.0, 8.0)]],
        start: path.from,
        exact: Arc::new(move |shape, t| Some(path.at(shape, t))),
        ..empty(
            "slope",
            "falls onto an icy slope of 28 degrees, of one piece, 90 m wide, and slides down it",
            2.0,
        )
    }
}

pub fn seamed() -> Scene {
    Scene {
        solids: seams(1000),
        start: v(0.5, 0.0),
        velocity: v(5.0, 0.0),
        stands: true,
        walk: Some(5.0),
        slides: false,
        exact: Arc::new(|_, t| Some(v(0.5 + 5.0 * t, 0.0))),
        ..empty(
            "seams",
            "walks 50 m over a level floor of 1000 boxes, each 1 m wide, at 5 m/s",
            10.0,
        )
    }
}

/// Level ground that bends down by 28 degrees, passed at a speed at which everybody takes off.
pub fn hill(speed: f64) -> Scene {
    let path = move |shape: Shape| FlightAndSlide {
        from: v(shape.leaves_at(), 0.0),
        velocity: v(speed, 0.0),
        gravity: GRAVITY,
        normal: SLOPE,
    };
    let ahead = 2.0;
    Scene {
        solids: vec![vec![
            v(-20.0, -40.0),
            v(75.0, -40.0),
            v(0.0, 0.0),
            v(-20.0, 0.0),
        ]],
        start: v(-ahead, 0.0),
        stands: true,
        velocity: v(speed, 0.0),
        exact: Arc::new(move |shape, t| {
            let leaves = (ahead + shape.leaves_at()) / speed;
            Some(match t < leaves {
                true => v(speed * t - ahead, 0.0),
                false => path(shape).at(shape, t - leaves),
            })
        }),
        ..empty(
            "hill",
            "glides over a crest of one piece, 95 m wide, fast enough to take off, lands on the far side, slides on",
            2.0,
        )
    }
}

pub fn lift() -> Scene {
    let piece = |t0, p0: f64, v0: f64, a: f64| Piece {
        t0,
        p0: v(0.0, p0),
        v0: v(0.0, v0),
        accel: v(0.0, a),
    };
    let lift = Lift {
        outline: rect((-3.0, 3.0), (-1.0, 0.0)),
        pieces: vec![
            piece(0.0, 0.0, 0.0, 10.0),
            piece(1.0, 5.0, 10.0, -10.0),
            piece(2.0, 10.0, 0.0, 0.0),
        ],
        period: None,
    };
    Scene {
        solids: vec![rect((-9.0, 9.0), (-20.0, -19.0))],
        lift: Some(lift.clone()),
        slides: false,
        stands: true,
        walk: Some(0.0),
        exact: Arc::new(move |_, t| Some(lift.offset(t))),
        ..empty(
            "lift",
            "stands on a lift, 6 m wide, that rises 10 m in 2 s, speeding up and braking at 10 m/s^2",
            3.0,
        )
    }
}

/// Walls of a V with its apex in the origin that rise `rise` on `run`, up to a height.
pub fn walls(run: f64, rise: f64, times: f64) -> Vec<Vec<DVec2>> {
    let (x, y) = (run * times, rise * times);
    vec![
        vec![
            v(-x - 1.0, -1.0),
            v(0.0, -1.0),
            v(0.0, 0.0),
            v(-x, y),
            v(-x - 1.0, y),
        ],
        vec![
            v(0.0, -1.0),
            v(x + 1.0, -1.0),
            v(x + 1.0, y),
            v(x, y),
            v(0.0, 0.0),
        ],
    ]
}

pub fn vee() -> Scene {
    // The left wall's normal; walls of 28.07 degrees from the vertical.
    let normal = v(15.0 / 17.0, 8.0 / 17.0);
    let path = FlightAndSlide {
        from: v(-2.0, 9.0),
        velocity: DVec2::ZERO,
        gravity: GRAVITY,
        normal,
    };
    Scene {
        solids: walls(8.0, 15.0, 1.0),
        start: path.from,
        exact: Arc::new(move |shape, t| {
            let p = path.at(shape, t);
            let rest = v(0.0, shape.reach(normal) / normal.y);
            Some(if p.x < 0.0 { p } else { rest })
        }),
        ..empty(
            "V",
            "falls onto a wall of a V, slides down it, and rests in the V",
            3.0,
        )
    }
}
