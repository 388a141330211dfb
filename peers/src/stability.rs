//! The section on numerical stability: far away, thin, steep, long.

use crate::hard::RATE;
use crate::movers;
use crate::page::{Page, metres};
use crate::run;
use crate::scene::{FlightAndSlide, Scene, Shape, rect, v};
use crate::scenes::{GRAVITY, empty, jump, seams};
use glam::DVec2;
use std::sync::Arc;

pub fn write(page: &mut Page, quick: bool) {
    page.heading(2, "5. Stability");
    page.say("Largest errors in metres at 60 Hz, as the scene gets harder. Edgewalker's world ends 4096 m from the origin, and it says so.");
    let makers = movers::all();
    let head: Vec<&str> = std::iter::once("")
        .chain(makers.iter().map(|maker| maker.name))
        .collect();
    let mut table = |title: &str, scenes: Vec<(String, Scene)>| {
        page.heading(3, title);
        let mut rows = Vec::new();
        for (name, scene) in scenes {
            let mut row = vec![name];
            for maker in &makers {
                row.push(match (maker.make)(&scene) {
                    Ok(mut mover) => metres(run::error(&mut *mover, &scene, RATE)),
                    Err(why) => format!("refused: {why}"),
                });
            }
            rows.push(row);
        }
        page.table(&head, &rows);
    };
    let far = [0.0, 10.0, 100.0, 1000.0, 3900.0, 1e5, 1e6];
    let distance = |d: &f64| format!("{d} m");
    table(
        "Distance from the origin: a jump and a glide",
        far.iter()
            .map(|d| (distance(d), shifted(jump(), v(*d, -d / 2.0))))
            .collect(),
    );
    table(
        "Distance from the origin: walking over 100 boxes",
        far.iter()
            .map(|d| (distance(d), shifted(short_walk(), v(*d, -d / 2.0))))
            .collect(),
    );
    let thin = [1.0, 1e-2, 1e-3, 1e-4, 1.6e-5];
    table(
        "Thinness: landing on a slab at 100 m/s",
        thin.iter().map(|t| (format!("{t} m"), slab(*t))).collect(),
    );
    let angles: [(f64, f64); 7] = [
        (1.0, 50.0),
        (5.0, 12.0),
        (8.0, 15.0),
        (20.0, 21.0),
        (35.0, 12.0),
        (20.0, 1.0),
        (50.0, 1.0),
    ];
    let name = |rise: f64, run: f64| format!("{:.1} degrees", rise.atan2(run).to_degrees());
    table(
        "Angle: falling onto an icy slope and sliding down it",
        angles
            .iter()
            .map(|&(rise, run)| (name(rise, run), slide(rise, run)))
            .collect(),
    );
    let long: &[f64] = if quick {
        &[1.0, 60.0]
    } else {
        &[1.0, 60.0, 600.0, 3600.0]
    };
    table(
        "Length of the run: up and down in a lift, as long as that (the peers are not told how fast it goes)",
        long.iter()
            .map(|&s| (format!("{s} s"), shuttle(s)))
            .collect(),
    );
}

/// A scene elsewhere.
fn shifted(scene: Scene, by: DVec2) -> Scene {
    let exact = Arc::clone(&scene.exact);
    let outlines = scene
        .solids
        .iter()
        .map(|o| o.iter().map(|&p| p + by).collect());
    Scene {
        solids: outlines.collect(),
        start: scene.start + by,
        exact: Arc::new(move |shape, t| exact(shape, t).map(|p| p + by)),
        ..scene
    }
}

fn short_walk() -> Scene {
    Scene {
        solids: seams(100),
        start: v(0.5, 0.0),
        velocity: v(5.0, 0.0),
        walk: Some(5.0),
        stands: true,
        slides: false,
        exact: Arc::new(|_, t| Some(v(0.5 + 5.0 * t, 0.0))),
        ..empty("", "", 10.0)
    }
}

fn slab(thickness: f64) -> Scene {
    Scene {
        solids: vec![rect((-10.0, 10.0), (-thickness, 0.0))],
        start: v(0.0, 20.0),
        velocity: v(0.0, -100.0),
        exact: Arc::new(|_, t| Some(v(0.0, (20.0 - 100.0 * t - 15.0 * t * t).max(0.0)))),
        ..empty("", "", 1.0)
    }
}

/// A slope down to the right through the origin.
fn slide(rise: f64, run: f64) -> Scene {
    let normal = v(rise, run).normalize();
    let path = FlightAndSlide {
        from: v(0.0, 1.0 + Shape::Box.reach(normal) / normal.y),
        velocity: DVec2::ZERO,
        gravity: GRAVITY,
        normal,
    };
    // From some metres before to ninety after, in whole steps of the slope, so that all lies on the grid.
    let at = |s: f64| v(run, -rise) * s;
    let length = rise.max(run);
    let (top, foot) = (at(-(10.0 / length).ceil()), at((90.0 / length).ceil()));
    Scene {
        solids: vec![vec![
            v(top.x - 1.0, foot.y - 1.0),
            foot - DVec2::Y,
            foot,
            top,
        ]],
        start: path.from,
        exact: Arc::new(move |shape, t| Some(path.at(shape, t))),
        ..empty("", "", 2.0)
    }
}

/// A lift that goes up and down by 4 m in 4 s, over and over.
fn shuttle(seconds: f64) -> Scene {
    let mut scene = crate::scenes::lift();
    if let Some(lift) = &mut scene.lift {
        let piece = |t0: f64, p0: f64, v0: f64, a: f64| edgewalker::motion::Piece {
            t0,
            p0: v(0.0, p0),
            v0: v(0.0, v0),
            accel: v(0.0, a),
        };
        lift.pieces = vec![
            piece(0.0, 0.0, 0.0, 4.0),
            piece(1.0, 2.0, 4.0, -4.0),
            piece(3.0, 2.0, -4.0, 4.0),
        ];
        lift.period = Some(4.0);
        let path = lift.clone();
        scene.exact = Arc::new(move |_, t| Some(path.offset(t)));
    }
    Scene { seconds, ..scene }
}
