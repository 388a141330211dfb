//! Work against precision: every mover in every scene at every rate.

use crate::clock::interleaved;
use crate::movers::{self, Maker, Mover};
use crate::page::{Axes, Line, Page, SeriesLabelPosition, metres};
use crate::run;
use crate::scene::Scene;
use crate::scenes;

/// Ticks per second.
pub const RATES: [f64; 7] = [15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0];

/// One mover in one scene.
struct Row {
    name: &'static str,
    errors: Vec<f64>,
    /// ns per tick.
    times: Vec<f64>,
    /// Events and faces crossed per tick, if it knows.
    counts: Vec<Option<(f64, f64)>>,
}

/// What the summary needs of this section.
#[derive(Default)]
pub struct Precision {
    /// Largest error of ours in any scene at any rate, m.
    pub ours: f64,
    /// Smallest error of any peer, with its name and scene.
    pub best_peers: Vec<(f64, String)>,
}

pub fn write(page: &mut Page, quick: bool) -> Precision {
    page.heading(2, "1. Work against precision");
    page.say(
        "Each scene has a known exact trajectory for each shape. The error is the largest distance from it at the end of \
         any tick of the run. A line joins the rates 15, 30, 60, 120, 240, 480 and 960 ticks a second: to the right \
         costs more, lower is better. Errors below 1e-16 m are drawn there.",
    );
    let mut found = Precision::default();
    for scene in scenes::all() {
        let rows = measure(&scene, if quick { 3 } else { 25 });
        found.ours = rows[0].errors.iter().copied().fold(found.ours, f64::max);
        for row in &rows[1..] {
            let best = row.errors.iter().copied().fold(f64::INFINITY, f64::min);
            found
                .best_peers
                .push((best, format!("{} in `{}`", row.name, scene.name)));
        }
        show(page, &scene, &rows);
    }
    found
}

fn measure(scene: &Scene, rounds: usize) -> Vec<Row> {
    let makers: Vec<Maker> = movers::all();
    let mut movers: Vec<Box<dyn Mover>> = makers
        .iter()
        .filter_map(|maker| (maker.make)(scene).ok())
        .collect();
    let mut rows: Vec<Row> = movers
        .iter()
        .map(|mover| Row {
            name: mover.name(),
            errors: Vec::new(),
            times: Vec::new(),
            counts: Vec::new(),
        })
        .collect();
    for rate in RATES {
        let ticks = f64::from(run::ticks(scene, rate));
        for (row, mover) in rows.iter_mut().zip(&mut movers) {
            row.errors.push(run::error(&mut **mover, scene, rate));
            let per_tick =
                |(events, faces): (usize, usize)| (events as f64 / ticks, faces as f64 / ticks);
            row.counts.push(mover.counts().map(per_tick));
        }
        let mut runs: Vec<_> = movers
            .iter_mut()
            .map(|mover| move || run::go(&mut **mover, scene, rate))
            .collect();
        let mut work: Vec<&mut dyn FnMut()> =
            runs.iter_mut().map(|run| run as &mut dyn FnMut()).collect();
        for (row, time) in rows.iter_mut().zip(interleaved(rounds, &mut work)) {
            row.times.push(time / ticks);
        }
    }
    rows
}

fn show(page: &mut Page, scene: &Scene, rows: &[Row]) {
    page.heading(3, &format!("`{}`: {}", scene.name, scene.what));
    let line = |row: &Row| Line {
        name: row.name.to_string(),
        points: (0..RATES.len())
            .map(|i| (row.times[i] * RATES[i], row.errors[i]))
            .collect(),
    };
    let axes = Axes {
        title: scene.name,
        x: "ns per simulated second",
        y: "largest error, m",
        floor: 1e-16,
        legend: SeriesLabelPosition::MiddleLeft,
    };
    let lines: Vec<Line> = rows.iter().map(line).collect();
    page.plot(&format!("precision-{}.svg", scene.name), &axes, &lines);
    let columns = [0, 2, 4, 6];
    let mut head = vec!["error in m, and ns per tick".to_string()];
    head.extend(columns.map(|i| format!("{} Hz", RATES[i])));
    let cells = |row: &Row| {
        let cell = |i: usize| {
            let counts =
                row.counts[i].map(|(events, faces)| format!(" ({events:.2} e, {faces:.2} f)"));
            let (error, time) = (metres(row.errors[i]), row.times[i]);
            format!("{error}, {time:.1} ns{}", counts.unwrap_or_default())
        };
        std::iter::once(row.name.to_string())
            .chain(columns.map(cell))
            .collect()
    };
    let rows: Vec<Vec<String>> = rows.iter().map(cells).collect();
    page.table(&head.iter().map(String::as_str).collect::<Vec<_>>(), &rows);
}
