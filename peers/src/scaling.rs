//! The section on scaling: steps against level size and speed, meshes against size, edits against size.

use crate::clock::{in_turn, keep, making, median, time};
use crate::memory;
use crate::meshes;
use crate::movers::box2d::Box2d;
use crate::movers::ours::tuning;
use crate::movers::rapier::Rapier;
use crate::movers::walker::{Rule, Slide, integrate};
use crate::page::{Axes, Line, Page, SeriesLabelPosition, time as shown};
use crate::reference::worlds::{self, Dice};
use crate::scene::{Form, collider, snapped, v};
use edgewalker::geom::expand;
use edgewalker::mesh::{FeatureId, Kind, Mesh};
use edgewalker::motion::{Body, Control, Terrain, Trace};
use edgewalker::tune::Motion;
use glam::DVec2;
use spade::Triangulation;

/// What the summary needs of this section.
#[derive(Default)]
pub struct Scaling {
    /// ns per step of one body in the smallest and in the largest level, and what their edges count.
    pub steps: [f64; 2],
    pub edges: [usize; 2],
    /// Building 1e4 overlapping octagons: ours and spade's, ns.
    pub build: [f64; 2],
    /// Our time in spade's at the size where that is largest: octagons that cross, and octagons apart.
    pub slowest: [f64; 2],
    /// Moving one octagon among 1000: median ns, and vertices before and after.
    pub moving: f64,
    pub vertices: [usize; 2],
    /// Sweeping, ns per edge crossed.
    pub sweep: f64,
}

pub fn write(page: &mut Page, quick: bool) -> Scaling {
    page.heading(2, "4. Scaling");
    let mut found = Scaling::default();
    steps(page, quick, &mut found);
    speed(page, quick);
    building(page, quick, &mut found);
    queries(page, quick, &mut found);
    edits(page, quick, &mut found);
    found
}

/// Rows of uneven ground, ten metres apart, of metre-wide pieces.
fn level(rows: usize, columns: usize) -> Vec<Vec<DVec2>> {
    let mut dice = Dice::new(9);
    let mut all = Vec::with_capacity(rows * columns);
    for row in 0..rows {
        let base = (row as f64 - (rows / 2) as f64) * 10.0;
        let mut height = 0.0;
        for column in 0..columns {
            let x = column as f64 - (columns / 2) as f64;
            let next = (height + dice.between(-0.25, 0.25)).clamp(-1.0, 1.0);
            all.push(vec![
                v(x, base - 3.0),
                v(x + 1.0, base - 3.0),
                v(x + 1.0, base + next),
                v(x, base + height),
            ]);
            height = next;
        }
    }
    all
}

/// Sizes of levels: rows and columns that make about 1e2 to 1e6 constrained edges.
const LEVELS: [(usize, usize); 5] = [(1, 20), (4, 40), (10, 160), (34, 470), (100, 1650)];

const RATE: f64 = 120.0;

/// Ticks that a run has.
const TICKS: u32 = 120;

fn steps(page: &mut Page, quick: bool, found: &mut Scaling) {
    page.heading(3, "Steps against the size of the level");
    page.say(
        "Rows of uneven ground of metre-wide pieces. One body runs for a second at 8 m/s from the middle of the level at 120 Hz, and \
         again from there; or 1e4 bodies all over it do, in turn, one tick each.",
    );
    let mut rows = Vec::new();
    let (mut lines, levels) = (
        vec![Vec::new(), Vec::new(), Vec::new(), Vec::new()],
        if quick { &LEVELS[..4] } else { &LEVELS[..] },
    );
    for &(count, columns) in levels {
        let solids = level(count, columns);
        let features: Vec<_> = solids
            .iter()
            .map(|o| expand(&snapped(o).expect("inside"), &collider()))
            .collect();
        let mesh = Mesh::build(&features).expect("inside the world");
        let edges = mesh
            .edges()
            .filter(|&e| mesh.uses(e).next().is_some())
            .count();
        let one = one_body(&mesh, if quick { 5 } else { 21 });
        let many = many_bodies(&mesh, columns, count);
        let form = Form::of(&collider());
        let peers = (edges < 500_000).then(|| {
            let box2d = peer_steps(&mut Box2d::new(&form, &solids, None));
            (box2d, peer_steps(&mut Rapier::new(&form, &solids, None)))
        });
        let per = |i: usize| one[i] / f64::from(TICKS);
        rows.push(vec![
            edges.to_string(),
            format!("{:.1} ns ({:.2} events)", per(0), per(1)),
            format!(
                "{:.1} ns ({:.2} events, {:.2} faces)",
                many[0], many[1], many[2]
            ),
            peers.map_or("not run".into(), |p| shown(p.0)),
            peers.map_or("not run".into(), |p| shown(p.1)),
        ]);
        if found.edges[0] == 0 {
            (found.steps[0], found.edges[0]) = (per(0), edges);
        }
        (found.steps[1], found.edges[1]) = (per(0), edges);
        lines[0].push((edges as f64, per(0)));
        lines[1].push((edges as f64, many[0]));
        if let Some((box2d, rapier)) = peers {
            lines[2].push((edges as f64, box2d));
            lines[3].push((edges as f64, rapier));
        }
    }
    let head = [
        "constrained edges",
        "Edgewalker, one body",
        "Edgewalker, 1e4 bodies",
        "Box2D, one body",
        "Rapier, one body",
    ];
    page.table(&head, &rows);
    let names = [
        "Edgewalker, one body",
        "Edgewalker, 1e4 bodies",
        "Box2D, one body",
        "Rapier, one body",
    ];
    let lines: Vec<Line> = names
        .into_iter()
        .zip(lines)
        .map(|(name, points)| Line {
            name: name.to_string(),
            points,
        })
        .collect();
    let axes = Axes {
        title: "a step against the size of the level",
        x: "constrained edges",
        y: "ns per step",
        floor: 1.0,
        legend: SeriesLabelPosition::LowerRight,
    };
    page.plot("scaling-steps.svg", &axes, &lines);
    page.say(
        "One body needs only what is around it, which stays in the cache whatever the level's size. 1e4 bodies all over a large \
         level do not share a neighbourhood: there the growth is that of cache misses, some hundred bytes a body from memory \
         at each event, and none of searching: the events and faces per step stay what they are.",
    );
}

/// Bodies without accelerations of their own, that take small bends as they come.
fn runner() -> Motion {
    Motion {
        joint: 0.0,
        slope_gravity: 0.0,
        run_speed: 8.0,
        ..tuning(30.0)
    }
}

const RIGHT: Control = Control {
    run: 1.0,
    jump: false,
    down: false,
    up: false,
};

/// A body that runs to the right from somewhere above ground, once it has landed.
fn running(at: DVec2, terrain: &Terrain, trace: &mut Trace) -> Option<Body> {
    let mut body = Body::spawn(at, 0.0, terrain).ok()?;
    body.advance(1.0, terrain, trace);
    body.apply(RIGHT, terrain, trace);
    body.set_velocity(body.normal().perp() * -8.0, terrain, trace);
    Some(body)
}

/// Median ns of a run of one body, and its events.
fn one_body(mesh: &Mesh, rounds: usize) -> [f64; 2] {
    let tuning = runner();
    let terrain = Terrain::new(mesh, mesh, &tuning);
    let mut trace = Trace::default();
    let body = running(v(0.5, 2.0), &terrain, &mut trace).expect("free air");
    trace.clear();
    let start = body.time();
    let run = |trace: &mut Trace| {
        let mut body = body.clone();
        for tick in 1..=TICKS {
            body.advance(start + f64::from(tick) / RATE, &terrain, trace);
            keep(body.position());
        }
    };
    run(&mut trace);
    let events = trace.events.len() + trace.passed as usize;
    let mut times = Vec::new();
    for _ in 0..rounds {
        trace.clear();
        times.push(time(|| run(&mut trace)));
    }
    [median(times), events as f64]
}

/// ns, events and faces per step of 1e4 bodies, 60 ticks each.
fn many_bodies(mesh: &Mesh, columns: usize, rows: usize) -> [f64; 3] {
    let tuning = runner();
    let terrain = Terrain::new(mesh, mesh, &tuning);
    let (mut trace, mut dice) = (Trace::default(), Dice::new(11));
    let mut bodies: Vec<Body> = Vec::new();
    while bodies.len() < 10_000 {
        let half = 0.45 * columns as f64;
        let row = f64::from(dice.below(rows as u32)) - (rows / 2) as f64;
        let at = v(dice.between(-half, half), row * 10.0 + 2.0);
        bodies.extend(running(at, &terrain, &mut trace));
    }
    let start = bodies[0].time();
    trace.clear();
    let ticks = 60;
    let ns = time(|| {
        for tick in 1..=ticks {
            let to = start + f64::from(tick) / RATE;
            for body in &mut bodies {
                body.advance(to, &terrain, &mut trace);
            }
        }
    });
    let steps = f64::from(ticks) * bodies.len() as f64;
    [
        ns,
        (trace.events.len() + trace.passed as usize) as f64,
        trace.crossed as f64,
    ]
    .map(|n| n / steps)
}

/// ns per step of a peer that runs the same way.
fn peer_steps(slide: &mut dyn Slide) -> f64 {
    let mut run = || {
        let (mut at, mut velocity) = (v(0.5, 2.0), DVec2::ZERO);
        for _ in 0..TICKS {
            velocity.x = 8.0;
            let (delta, after) = integrate(velocity, v(0.0, -30.0), 1.0 / RATE, Rule::Euler);
            let moved = slide.slide(at, after, delta, 1.0 / RATE);
            (at, velocity) = (moved.at, moved.velocity);
        }
    };
    run();
    median((0..5).map(|_| time(&mut run)).collect()) / f64::from(TICKS)
}

fn speed(page: &mut Page, quick: bool) {
    page.heading(3, "Steps against speed");
    page.say(
        "A body flies level through the mesh of 1e4 overlapping octagons that stop nobody, at 60 Hz: what a step costs is a \
         matter of the edges on its way.",
    );
    let features: Vec<(FeatureId, Kind, _)> = (0..)
        .zip(meshes::edges(&meshes::octagons(
            1,
            if quick { 1000 } else { 10_000 },
        )))
        .map(|(id, edges)| (id, Kind::Region, edges))
        .collect();
    let mesh = Mesh::of(&features).expect("inside the world");
    let tuning = Motion {
        run_speed: 0.0,
        ..tuning(0.0)
    };
    let terrain = Terrain::new(&mesh, &mesh, &tuning);
    let mut rows = Vec::new();
    for speed in [1.0, 10.0, 100.0, 1e3, 1e4, 1e5] {
        let mut trace = Trace::default();
        let mut body = Body::spawn(v(-60.0, 0.3), 0.0, &terrain).expect("free air");
        body.set_velocity(v(speed, speed * 1e-3), &terrain, &mut trace);
        // Until it has come 120 m, or 2 s.
        let ticks = ((120.0 / speed * 60.0) as u32).clamp(1, 120);
        let mut times = Vec::new();
        for _ in 0..if quick { 5 } else { 31 } {
            trace.clear();
            let mut body = body.clone();
            times.push(time(|| {
                for tick in 1..=ticks {
                    body.advance(
                        (f64::from(tick) / 60.0).min(120.0 / speed),
                        &terrain,
                        &mut trace,
                    );
                }
            }));
        }
        let (ns, ticks, faces) = (median(times), f64::from(ticks), trace.crossed as f64);
        rows.push(vec![
            format!("{speed} m/s"),
            shown(ns / ticks),
            format!("{:.1}", faces / ticks),
            format!("{:.0} ns", ns / faces),
        ]);
    }
    page.table(&["speed", "a step", "faces per step", "per face"], &rows);
}

fn building(page: &mut Page, quick: bool, found: &mut Scaling) {
    page.heading(3, "Building a mesh");
    page.say(
        "Overlapping octagons. Edgewalker's mesh cuts and snaps all crossings to the grid, and knows for every edge and face whose \
         it is; spade's splits constraints where they cross (corners in bulk by `bulk_load_cdt`, then \
         `add_constraint_and_split`), without provenance. Octagons that do not touch are given to all three; to delaunator as plain \
         points, which is all that it does.",
    );
    let mut rows = Vec::new();
    let sizes: &[usize] = if quick {
        &[100, 1000, 10_000]
    } else {
        &[100, 1000, 10_000, 100_000]
    };
    for &n in sizes {
        let (crossing, apart) = (meshes::octagons(1, n), meshes::apart(1, n));
        let (edges, apart_edges) = (meshes::edges(&crossing), meshes::edges(&apart));
        let points = meshes::corners(&apart);
        let rounds = (if quick { 30_000 } else { 150_000 } / n).clamp(1, 15);
        let t = in_turn(
            rounds,
            &mut [
                &mut || making(|| Mesh::build(&edges)),
                &mut || making(|| meshes::spade(&crossing)),
                &mut || making(|| Mesh::build(&apart_edges)),
                &mut || making(|| meshes::spade(&apart)),
                &mut || making(|| meshes::delaunator(&points)),
            ],
        );
        let ratios = [t[0] / t[1], t[2] / t[3]];
        found.slowest = [0, 1].map(|i| ratios[i].max(found.slowest[i]));
        if n == 10_000 {
            found.build = [t[0], t[1]];
        }
        let (mesh, bytes) = memory::of(|| Mesh::build(&edges).expect("inside the world"));
        let (other, other_bytes) = memory::of(|| meshes::spade(&crossing));
        let count = mesh.vertices().count();
        let others = other.as_ref().map_or(1, |mesh| mesh.num_vertices());
        rows.push(vec![
            n.to_string(),
            count.to_string(),
            shown(t[0]),
            other.as_ref().map_or("panics".into(), |_| shown(t[1])),
            format!("{:.2}", t[0] / t[1]),
            shown(t[2]),
            shown(t[3]),
            shown(t[4]),
            format!("{}, {}", bytes / count, other_bytes / others),
        ]);
    }
    let head = [
        "octagons",
        "vertices",
        "crossing: Edgewalker",
        "spade",
        "ratio",
        "apart: Edgewalker",
        "spade",
        "delaunator",
        "bytes per vertex: Edgewalker, spade",
    ];
    page.table(&head, &rows);
}

fn queries(page: &mut Page, quick: bool, found: &mut Scaling) {
    page.heading(3, "Asking a mesh");
    page.say(
        "Straight sweeps of 100 m from a known face, and point location along a random walk of 10 cm steps from the last \
         place. Spade's line iterator takes no face to start from: it looks for its start. Each is asked the same again and again: the mesh is in \
         the cache as far as it fits.",
    );
    let mut rows = Vec::new();
    for n in [1000, 10_000] {
        let outlines = meshes::octagons(1, n);
        let mesh = Mesh::build(&meshes::edges(&outlines)).expect("inside the world");
        let Some(spade) = meshes::spade(&outlines) else {
            continue;
        };
        let (sweeps, steps) = (meshes::sweeps(&mesh, n, 32), meshes::steps(10_000));
        let crossed: usize = sweeps
            .iter()
            .map(|&sweep| meshes::edges_swept(&mesh, sweep))
            .sum();
        let theirs: usize = sweeps
            .iter()
            .map(|s| meshes::edges_of_spade(&spade, s.1, s.2))
            .sum();
        let again = |work: &mut dyn FnMut()| {
            work();
            median(
                (0..if quick { 5 } else { 51 })
                    .map(|_| time(&mut *work))
                    .collect(),
            )
        };
        let locate = again(&mut || {
            sweeps
                .iter()
                .for_each(|s| keep(mesh.locate(s.2, Some(s.0))))
        });
        let sweep = again(&mut || {
            sweeps
                .iter()
                .for_each(|&s| keep(meshes::edges_swept(&mesh, s)))
        });
        let line = again(&mut || {
            sweeps
                .iter()
                .for_each(|s| keep(meshes::edges_of_spade(&spade, s.1, s.2)))
        });
        let walk = again(&mut || keep(meshes::walk(&mesh, &steps)));
        let walk_there = again(&mut || keep(meshes::walk_in_spade(&spade, &steps)));
        let per = |ns: f64, n: usize| format!("{:.1} ns", ns / n as f64);
        found.sweep = locate / crossed as f64;
        rows.push(vec![
            mesh.vertices().count().to_string(),
            per(locate, crossed),
            per(sweep, crossed),
            per(line, theirs),
            per(walk, steps.len()),
            per(walk_there, steps.len()),
        ]);
    }
    let head = [
        "vertices",
        "to the end of a sweep (`locate`), per edge",
        "every face on the way (`faces_along`), per edge",
        "spade's line iterator, per edge",
        "locating nearby",
        "spade",
    ];
    page.table(&head, &rows);
}

fn edits(page: &mut Page, quick: bool, found: &mut Scaling) {
    page.heading(3, "Editing a mesh");
    page.say(
        "One octagon among many overlapping ones is taken out and another is put in somewhere else. (Spade cannot take out a constraint that was \
         split together with its crossings, and delaunator cannot edit at all.) In the end all are taken out again: no vertex stays behind.",
    );
    let mut rows = Vec::new();
    let sizes: &[usize] = if quick {
        &[100, 1000, 10_000]
    } else {
        &[100, 1000, 10_000, 100_000]
    };
    for &n in sizes {
        let all = meshes::edges(&meshes::octagons(1, n));
        let mut dice = Dice::new(6);
        let half = worlds::octagons_half_width(n);
        let others: Vec<_> = (0..1000)
            .map(|_| worlds::octagon(&mut dice, half))
            .collect();
        let others = meshes::edges(&worlds::snapped(&others));
        let mut mesh = Mesh::build(&all).expect("inside the world");
        let before = mesh.vertices().count();
        let (mut times, mut rewired) = (Vec::new(), 0);
        for edges in &others {
            times.push(time(|| {
                mesh.remove(0).expect("it is there");
                mesh.insert(0, edges).expect("inside the world");
            }));
            rewired += mesh.rewired();
        }
        mesh.remove(0).expect("it is there");
        mesh.insert(0, &all[0]).expect("inside the world");
        let after = mesh.vertices().count();
        if n == 1000 {
            (found.moving, found.vertices) = (median(times.clone()), [before, after]);
        }
        rows.push(vec![
            n.to_string(),
            shown(median(times)),
            (rewired / others.len()).to_string(),
            format!("{before}, {after}"),
        ]);
    }
    let head = [
        "octagons",
        "moving one, median",
        "faces changed by the insertion",
        "vertices before and after 1000 moves",
    ];
    page.table(&head, &rows);
}
