//! The section on the recorded run of the level.

use crate::clock::{interleaved, keep, median, time};
use crate::level::{Quarry, RATE, hero, lead};
use crate::movers::box2d::Box2d;
use crate::movers::parry::Parry;
use crate::movers::push_out::PushOut;
use crate::movers::rapier::Rapier;
use crate::movers::walker::Slide;
use crate::page::{Axes, Line, Page, SeriesLabelPosition, metres};
use crate::precision::RATES;
use crate::reference::{self, Difference};
use crate::scene::Form;
use edgewalker::game::Shape;
use edgewalker::motion::{Body, Mode, Trace};

/// What the summary needs of this section: ns per tick at the recorded rate.
#[derive(Default)]
pub struct Recorded {
    pub ours: f64,
    pub box2d: f64,
    pub rapier: f64,
    /// Median ns of single steps in the air and on the ground.
    pub steps: [f64; 2],
    /// Largest error of ours against our own run without ticks, and against the reference.
    pub errors: [f64; 2],
}

struct Row {
    name: &'static str,
    times: Vec<f64>,
    /// Largest and median error: alone for one tick, alone for one second.
    tick: Vec<[f64; 2]>,
    second: Vec<[f64; 2]>,
}

pub fn write(page: &mut Page, quick: bool) -> Recorded {
    let quarry = Quarry::load();
    page.heading(3, "The whole recorded run of `levels/dev/crossing.ron`");
    page.say(&format!(
        "A run of {:.1} s through a small level of ours, {} outlines with {} corners, recorded at 120 inputs a second \
         (`tests/golden/crossing.replay.ron`). Edgewalker plays it with all of the game's rules. No peer has these. So each is \
         put where the run is, gets the accelerations that act there (by semi-implicit Euler) and the changes of speed that jumps \
         make, and moves by itself, once for one tick and once for a second, until it is put back; the stretches on which the \
         hero crouches or hangs from a ledge are left out for them. What is compared is the position. Below 120 Hz \
         Edgewalker takes each input at its own time within the tick. The peers' times are those of their moves alone, ours has the \
         game's rules for movement in it.",
        quarry.seconds(),
        quarry.solids.len(),
        quarry.solids.iter().map(Vec::len).sum::<usize>(),
    ));
    let form = Form::of(&hero());
    let mut peers: Vec<(&'static str, Box<dyn Slide>)> = vec![
        ("Box2D", Box::new(Box2d::new(&form, &quarry.solids, None))),
        ("Rapier", Box::new(Rapier::new(&form, &quarry.solids, None))),
        ("Parry", Box::new(Parry::new(&form, &quarry.solids, None))),
        (
            "push out",
            Box::new(PushOut::new(&form, &quarry.solids, None)),
        ),
    ];
    let names = ["Edgewalker"]
        .into_iter()
        .chain(peers.iter().map(|peer| peer.0));
    let mut rows: Vec<Row> = names
        .map(|name| Row {
            name,
            times: Vec::new(),
            tick: Vec::new(),
            second: Vec::new(),
        })
        .collect();
    let mut counts = Vec::new();
    for rate in RATES {
        counts.push(measure(
            &quarry,
            &mut peers,
            rate,
            &mut rows,
            if quick { 3 } else { 25 },
        ));
    }
    show(page, &rows, &counts);
    let at = RATES
        .iter()
        .position(|&rate| rate == RATE)
        .expect("120 Hz is measured");
    let own = rows[0].tick.iter().map(|e| e[0]).fold(0.0, f64::max);
    Recorded {
        ours: rows[0].times[at],
        box2d: rows[1].times[at],
        rapier: rows[2].times[at],
        steps: steps(page, &quarry),
        errors: [own, differences(page, &quarry, quick)],
    }
}

/// Runs all at one rate. Events and faces per tick of ours.
fn measure(
    quarry: &Quarry,
    peers: &mut [(&'static str, Box<dyn Slide>)],
    rate: f64,
    rows: &mut [Row],
    rounds: usize,
) -> [f64; 2] {
    let moments = quarry.moments(rate);
    let (mut tick, mut own) = (0, Vec::new());
    let counts = quarry.play(rate, |body| {
        tick += 1;
        own.push((body.position() - moments[tick].at).length());
    });
    rows[0].tick.push(largest_and_median(own.clone()));
    rows[0].second.push(largest_and_median(own));
    let ticks = moments.len() as f64 - 1.0;
    let mut asked = 1.0;
    for (row, (_, slide)) in rows[1..].iter_mut().zip(peers.iter_mut()) {
        for (every, errors) in [(1, &mut row.tick), (rate as usize, &mut row.second)] {
            let mut all = Vec::new();
            asked = lead(&mut **slide, &moments, rate, every, |error| all.push(error)) as f64;
            errors.push(largest_and_median(all));
        }
    }
    let moments = &moments;
    let mut play = || {
        quarry.play(rate, |body| {
            keep(body.position());
        });
    };
    let mut runs: Vec<_> = peers
        .iter_mut()
        .map(|(_, slide)| move || keep(lead(&mut **slide, moments, rate, 1, keep)))
        .collect();
    let mut work: Vec<&mut dyn FnMut()> = vec![&mut play];
    work.extend(runs.iter_mut().map(|run| run as &mut dyn FnMut()));
    let times = interleaved(rounds, &mut work);
    rows[0].times.push(times[0] / ticks);
    for (row, time) in rows[1..].iter_mut().zip(&times[1..]) {
        row.times.push(time / asked);
    }
    [counts.0 as f64 / ticks, counts.1 as f64 / ticks]
}

fn largest_and_median(errors: Vec<f64>) -> [f64; 2] {
    [errors.iter().copied().fold(0.0, f64::max), median(errors)]
}

fn show(page: &mut Page, rows: &[Row], counts: &[[f64; 2]]) {
    let line = |row: &Row| Line {
        name: row.name.to_string(),
        points: (0..RATES.len())
            .map(|i| (row.times[i] * RATES[i], row.second[i][1]))
            .collect(),
    };
    let axes = Axes {
        title: "the recorded run of the quarry",
        x: "ns per simulated second",
        y: "median error after a second alone, m",
        floor: 1e-16,
        legend: SeriesLabelPosition::MiddleLeft,
    };
    page.plot(
        "precision-quarry.svg",
        &axes,
        &rows.iter().map(line).collect::<Vec<_>>(),
    );
    let columns = [0, 2, 3, 4, 6];
    let mut head =
        vec!["largest error after a tick, median after a second (m), ns per tick".to_string()];
    head.extend(columns.map(|i| format!("{} Hz", RATES[i])));
    let mut cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| {
            let cell = |i: usize| {
                let (tick, second) = (metres(row.tick[i][0]), metres(row.second[i][1]));
                format!("{tick}, {second}, {:.0} ns", row.times[i])
            };
            std::iter::once(row.name.to_string())
                .chain(columns.map(cell))
                .collect()
        })
        .collect();
    let events = |i: usize| format!("{:.2}, {:.2}", counts[i][0], counts[i][1]);
    cells.push(
        std::iter::once("our events and faces per tick".to_string())
            .chain(columns.map(events))
            .collect(),
    );
    let ratio = |row: usize, i: usize| format!("{:.1}", rows[row].times[i] / rows[0].times[i]);
    for (row, name) in [(1, "Box2D's time in ours"), (2, "Rapier's time in ours")] {
        cells.push(
            std::iter::once(name.to_string())
                .chain(columns.map(|i| ratio(row, i)))
                .collect(),
        );
    }
    page.table(&head.iter().map(String::as_str).collect::<Vec<_>>(), &cells);
}

/// Bodies that take the same tick one after the other.
const COPIES: usize = 32;

/// The median time of single ticks at 120 Hz, in the air and on the ground, ns.
fn steps(page: &mut Page, quarry: &Quarry) -> [f64; 2] {
    let land = quarry
        .stage
        .land(&Shape::hero())
        .expect("the hero's meshes");
    let terrain = land.terrain(&quarry.stage, &quarry.replay.tuning.motion);
    let mut trace = Trace::default();
    let mut body = Body::spawn(quarry.stage.level.start, 0.0, &terrain).expect("a free start");
    let mut times = [Vec::new(), Vec::new()];
    for (tick, &control) in quarry.controls.iter().enumerate() {
        let to = (tick + 1) as f64 / RATE;
        // The same tick many times, each on a body of its own: the clock is too coarse for one.
        let mut bodies = vec![body.clone(); COPIES];
        let ns = time(|| {
            for body in &mut bodies {
                trace.clear();
                body.apply(control, &terrain, &mut trace);
                body.advance(to, &terrain, &mut trace);
            }
        });
        body = bodies.swap_remove(0);
        match body.mode() {
            Mode::Air(_) => times[0].push(ns / COPIES as f64),
            Mode::Surface(on) if on.walkable => times[1].push(ns / COPIES as f64),
            _ => {}
        }
    }
    let ninety = |times: &[f64]| {
        let mut sorted = times.to_vec();
        sorted.sort_by(f64::total_cmp);
        sorted[sorted.len() * 9 / 10]
    };
    let nineties = [ninety(&times[0]), ninety(&times[1])];
    let medians = times.map(median);
    page.say(&format!(
        "Single ticks at 120 Hz, input and all: median {:.0} ns in the air and {:.0} ns on the ground; nine of ten take at most {:.0} ns and {:.0} ns. Most ticks have no event: a body whose next event is \
         later than the tick's end costs a comparison.",
        medians[0], medians[1], nineties[0], nineties[1],
    ));
    medians
}

/// Our error against the slow reference of the tests.
fn differences(page: &mut Page, quarry: &Quarry, quick: bool) -> f64 {
    page.say(
        "The error of ours above is that of a run in ticks against the same run from input to input, so it shows only that \
         ticks change nothing: not one bit. How far the run itself is from the truth is measured against the slow reference \
         of the tests (`tests/reference`): it shares no code with the mesh or the motion, tests every outline by itself, and \
         computes with 32 digits. It does not know ledges, corrections and walls, so these are off for both. A run ends \
         where rounding to the grid makes two answers right; runs are counted apart (`shifted`) once they \
         have come off a crossing of outlines, which the grid of 15 micrometres moves by up to half a step.",
    );
    let random = reference::random(if quick { 100 } else { 1000 });
    let level = reference::quarry(quarry, 120);
    let row = |name: &str, d: &Difference| {
        vec![
            name.to_string(),
            d.runs.to_string(),
            d.ticks.to_string(),
            d.events.to_string(),
            metres(d.largest[0]),
            format!("{:.0e}", d.largest[2]),
            d.doubts.to_string(),
            d.blurred.to_string(),
            d.failures.len().to_string(),
        ]
    };
    let head = [
        "against 32 digits",
        "runs",
        "ticks",
        "events",
        "largest error, m",
        "in event times, s",
        "ended early",
        "shifted",
        "differ",
    ];
    let rows = [
        row("random worlds, tunings, inputs; 2 s each", &random),
        row(
            "the recorded inputs in the quarry, 2 s each from 5 cm above the run",
            &level,
        ),
    ];
    page.table(&head, &rows);
    for failure in random.failures.iter().chain(&level.failures) {
        eprintln!("differs from the reference: {failure}");
    }
    random.largest[0].max(level.largest[0])
}
