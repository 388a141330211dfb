//! The section on level floors: the same walk over floors of one piece, narrow and wide, and over floors that are cut into pieces.

use crate::hard;
use crate::movers;
use crate::page::{Page, metres};
use crate::run;
use crate::scene::{Scene, rect, v};
use crate::scenes::empty;
use glam::DVec2;
use std::sync::Arc;

/// How far the walk goes, how fast, and where it starts: in the middle of each floor, m and m/s.
const WAY: f64 = 20.0;
const SPEED: f64 = 5.0;

/// Half widths of the floors, m; all hold the way.
const HALVES: [f64; 4] = [25.0, 100.0, 400.0, 1600.0];

/// Width of a piece where a floor is cut, m.
const PIECE: f64 = 5.0;

pub fn write(page: &mut Page) {
    page.heading(3, "Floors by width");
    page.say(&format!(
        "A walk of {WAY} m at {SPEED} m/s over level ground, at {} Hz, from the middle of the floor. A cell is the largest error in \
         metres. Some movers depend on how wide the *pieces* of a floor are: shape casts in 32 bits lose the way on wide ones. So \
         each width is shown as one piece and cut into pieces of {PIECE} m; the floors of all other scenes have their widths in \
         their names.",
        hard::RATE,
    ));
    let makers = movers::all();
    let mut rows = Vec::new();
    for half in HALVES {
        let whole = vec![rect((-half, half), (-1.0, 0.0))];
        for (solids, how) in [(whole, "one piece"), (cut(half), "cut")] {
            let scene = walk(solids);
            let cells = makers.iter().map(|maker| match (maker.make)(&scene) {
                Ok(mut mover) => metres(run::error(&mut *mover, &scene, hard::RATE)),
                Err(why) => format!("cannot: {why}"),
            });
            let name = format!("{} m, {how}", 2.0 * half);
            rows.push(std::iter::once(name).chain(cells).collect());
        }
    }
    let names = makers.iter().map(|maker| maker.name);
    let head: Vec<&str> = std::iter::once("floor").chain(names).collect();
    page.table(&head, &rows);
}

/// A floor in pieces.
fn cut(half: f64) -> Vec<Vec<DVec2>> {
    let count = (2.0 * half / PIECE) as i32;
    let from = |i: i32| f64::from(i) * PIECE - half;
    let piece = |i| rect((from(i), from(i + 1)), (-1.0, 0.0));
    (0..count).map(piece).collect()
}

fn walk(solids: Vec<Vec<DVec2>>) -> Scene {
    let from = -0.5 * WAY;
    Scene {
        solids,
        start: v(from, 0.0),
        velocity: v(SPEED, 0.0),
        walk: Some(SPEED),
        stands: true,
        slides: false,
        exact: Arc::new(move |_, t| Some(v(from + SPEED * t, 0.0))),
        ..empty("floor", "walks over a level floor", WAY / SPEED)
    }
}
