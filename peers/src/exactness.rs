//! The section on what exactness costs and buys.

use crate::clock::{interleaved, keep};
use crate::flat::{Double, Exact, Flat, Sides, Single, steps};
use crate::meshes;
use crate::movers::walker::Rule;
use crate::movers::{Mover, ours};
use crate::page::{Page, metres};
use crate::reference::worlds::Dice;
use crate::run;
use crate::scenes;
use crate::swept::{Pieces, Swept};
use edgewalker::geom::{Point, STEP, predicates::in_circle};
use edgewalker::mesh::{FaceId, Mesh, Place};
use glam::DVec2;

const VARIANTS: [Pieces; 3] = [
    Pieces {
        name: "straight sweeps, semi-implicit Euler",
        rule: Rule::Euler,
        single: false,
    },
    Pieces {
        name: "straight sweeps, mean velocity",
        rule: Rule::Middle,
        single: false,
    },
    Pieces {
        name: "the same with 32-bit positions",
        rule: Rule::Middle,
        single: true,
    },
];

pub fn write(page: &mut Page, quick: bool) {
    page.heading(2, "2. What exactness costs and buys");
    page.say(
        "The same core with pieces swapped. First the motion: in the same mesh, around the same grown outlines, a point goes \
         straight from tick to tick (`Mesh::cast`, exact) instead of along parabolas from event to event; it keeps 1e-9 m (with 32 bits \
         1e-4 m) from surfaces, since without a place on an edge rounding would put it inside.",
    );
    motion(page, if quick { 3 } else { 9 });
    page.say(
        "Then the signs: a sweep across a bare copy of the mesh of 1e4 overlapping octagons (triangles and neighbours, no \
         provenance), with exact predicates, with plain 64-bit and with plain 32-bit arithmetic. `Random` lines go from anywhere \
         to anywhere within 100 m. Lines `to an edge` end at a point of a mesh edge, as near as rounding comes to it: where a body that \
         touches something is. A sweep is wrong if its last face does not hold its end, or if it loses its way.",
    );
    signs(page, if quick { 3 } else { 15 });
}

fn motion(page: &mut Page, rounds: usize) {
    let scenes = [
        scenes::jump(),
        scenes::slope(),
        scenes::hill(8.0),
        scenes::vee(),
    ];
    let rates = [60.0, 960.0];
    let mut rows: Vec<Vec<String>> = vec![vec!["Edgewalker: parabolas, 64 bits".to_string()]];
    rows.extend(VARIANTS.map(|pieces| vec![pieces.name.to_string()]));
    let mut head = vec!["error in m, ns per tick".to_string()];
    for scene in &scenes {
        for rate in rates {
            head.push(format!("{}, {rate} Hz", scene.name));
            let mut movers: Vec<Box<dyn Mover>> =
                vec![(ours::maker().make)(scene).expect("it can do all of them")];
            movers.extend(
                VARIANTS.map(|pieces| Box::new(Swept::new(scene, pieces)) as Box<dyn Mover>),
            );
            let errors: Vec<f64> = movers
                .iter_mut()
                .map(|m| run::error(&mut **m, scene, rate))
                .collect();
            let mut runs: Vec<_> = movers
                .iter_mut()
                .map(|m| move || run::go(&mut **m, scene, rate))
                .collect();
            let mut work: Vec<&mut dyn FnMut()> =
                runs.iter_mut().map(|run| run as &mut dyn FnMut()).collect();
            let times = interleaved(rounds, &mut work);
            for (row, (error, time)) in rows.iter_mut().zip(errors.iter().zip(times)) {
                let ns = time / f64::from(run::ticks(scene, rate));
                row.push(format!("{}, {ns:.0} ns", metres(*error)));
            }
        }
    }
    page.table(&head.iter().map(String::as_str).collect::<Vec<_>>(), &rows);
    page.say(
        "So the parabola costs nothing: a body that looks ahead to its next event has less to do at most ticks than one that \
         sweeps at every tick, and it is the sweep that is paid for again and again.",
    );
}

/// How often the same lines are swept in one measurement.
const AGAIN: usize = 16;

/// A line: the face it starts in, and its ends in steps.
type Way = (u32, DVec2, DVec2);

fn signs(page: &mut Page, rounds: usize) {
    let mesh = Mesh::build(&meshes::edges(&meshes::octagons(1, 10_000))).expect("inside the world");
    let flat = Flat::new(&mesh);
    let mut scrambled = flat.clone();
    scrambled.scramble(7);
    let sweeps = meshes::sweeps(&mesh, 10_000, 256);
    let random: Vec<Way> = sweeps
        .iter()
        .map(|&(f, a, b)| (flat.face(f), steps(a), steps(b)))
        .collect();
    let touching = touching(&mesh, &flat, &sweeps);
    let refound: Vec<Way> = random
        .iter()
        .take(16)
        .filter_map(|&(_, a, b)| Some((scrambled.find(a)?, a, b)))
        .collect();
    let mut rows = Vec::new();
    for (name, ways) in [("random", &random), ("to an edge", &touching)] {
        // A few lines, so that they stay in the cache and the arithmetic shows.
        let few = &ways[..ways.len().min(16)];
        let crossed = edges::<Exact>(&flat, few) as f64;
        let again = |sweep: fn(&Flat, &[Way]) -> usize| {
            let flat = &flat;
            move || (0..AGAIN).for_each(|_| keep(sweep(flat, few)))
        };
        let (mut exact, mut double, mut single) = (
            again(edges::<Exact>),
            again(edges::<Double>),
            again(edges::<Single>),
        );
        let times = interleaved(rounds, &mut [&mut exact, &mut double, &mut single]);
        let wrong = [
            wrong::<Exact>(&flat, ways),
            wrong::<Double>(&flat, ways),
            wrong::<Single>(&flat, ways),
        ];
        for ((kind, time), wrong) in ["exact", "plain 64-bit", "plain 32-bit"]
            .iter()
            .zip(times)
            .zip(wrong)
        {
            rows.push(vec![
                format!("{name}, {kind}"),
                format!("{:.1}", time / crossed / AGAIN as f64),
                format!("{:.0}", crossed / few.len() as f64),
                format!("{wrong} of {}", ways.len()),
            ]);
        }
    }
    let same: Vec<Way> = random[..refound.len()].to_vec();
    let mut better = || (0..AGAIN).for_each(|_| keep(edges::<Exact>(&flat, &same)));
    let mut worse = || (0..AGAIN).for_each(|_| keep(edges::<Exact>(&scrambled, &refound)));
    let times = interleaved(rounds, &mut [&mut better, &mut worse]);
    let times: Vec<f64> = times.iter().map(|ns| ns / AGAIN as f64).collect();
    for (name, flat, ways, time) in [
        ("Delaunay", &flat, &same, times[0]),
        (
            "free edges flipped at random",
            &scrambled,
            &refound,
            times[1],
        ),
    ] {
        let crossed = edges::<Exact>(flat, ways) as f64;
        rows.push(vec![
            format!(
                "random lines, exact, {name}: {:.2} µs each",
                time / 1e3 / ways.len() as f64
            ),
            format!("{:.1}", time / crossed),
            format!("{:.0}", crossed / ways.len() as f64),
            format!("{} of {}", wrong::<Exact>(flat, ways), ways.len()),
        ]);
    }
    page.table(
        &["sweeps of 100 m", "ns per edge", "edges each", "wrong"],
        &rows,
    );
    circles(page, rounds);
}

/// Lines from inside a face to a point of an edge of the face in which another line ends, rounded.
fn touching(mesh: &Mesh, flat: &Flat, sweeps: &[(FaceId, DVec2, DVec2)]) -> Vec<Way> {
    let mut dice = Dice::new(8);
    let mut ways = Vec::new();
    for &(face, from, to) in sweeps {
        let Some(Place::Face(last)) = mesh.locate(to, Some(face)) else {
            continue;
        };
        let [a, b, _] = mesh.corners(last).map(Point::metres);
        let end = a + (b - a) * dice.between(0.1, 0.9);
        ways.push((flat.face(face), steps(from), steps(end)));
    }
    ways
}

fn edges<S: Sides>(flat: &Flat, ways: &[Way]) -> usize {
    ways.iter()
        .filter_map(|&(face, from, to)| flat.sweep::<S>(face, from, to))
        .map(|found| found.1)
        .sum()
}

fn wrong<S: Sides>(flat: &Flat, ways: &[Way]) -> usize {
    let right = |&&(face, from, to): &&Way| {
        let end = flat.sweep::<S>(face, from, to);
        end.is_some_and(|(last, _)| flat.holds(last, to))
    };
    ways.len() - ways.iter().filter(right).count()
}

/// The in-circle test in integers and in plain 64-bit arithmetic, on random points and on corners of boxes.
fn circles(page: &mut Page, rounds: usize) {
    let mut dice = Dice::new(5);
    let random: Vec<[Point; 4]> = (0..4096)
        .map(|_| [(); 4].map(|()| dice.point(1 << 24)))
        .collect();
    let boxes: Vec<[Point; 4]> = (0..4096)
        .map(|_| {
            let (p, size) = (dice.point(1 << 28), dice.point(1 << 20));
            [(0, 0), (1, 0), (1, 1), (0, 1)]
                .map(|(x, y)| Point::new(p.x + x * size.x, p.y + y * size.y))
        })
        .collect();
    let mut rows = Vec::new();
    for (name, all) in [("random points", &random), ("corners of boxes", &boxes)] {
        let mut exact = || {
            all.iter().for_each(|&[a, b, c, d]| {
                keep(in_circle(a, b, c, d));
            })
        };
        let mut plain = || {
            all.iter().for_each(|&[a, b, c, d]| {
                keep(plain_in_circle(a, b, c, d));
            })
        };
        let times = interleaved(rounds * 5, &mut [&mut exact, &mut plain]);
        let differ = all.iter().filter(|&&[a, b, c, d]| {
            let exact = in_circle(a, b, c, d).signum() as f64;
            let plain = plain_in_circle(a, b, c, d);
            exact != if plain == 0.0 { 0.0 } else { plain.signum() }
        });
        rows.push(vec![
            name.to_string(),
            format!("{:.1} ns", times[0] / all.len() as f64),
            format!("{:.1} ns", times[1] / all.len() as f64),
            format!("{} of {}", differ.count(), all.len()),
        ]);
    }
    page.say(
        "The exact signs cost about a nanosecond an edge, since they compute the plain value first and stop there unless it is in \
         doubt; and where a body touches something, it is. The flips buy little speed here (the last two rows): sweeps cross some edges \
         fewer. What they buy is that the mesh is a function of its features alone, whatever the order in which they came. The circle \
         test that decides them, in 128-bit integers and in plain 64-bit arithmetic:",
    );
    page.table(&["in-circle", "exact", "plain", "signs that differ"], &rows);
}

fn plain_in_circle(a: Point, b: Point, c: Point, d: Point) -> f64 {
    // Absolute coordinates, as a program without a grid has them.
    let at = |p: Point| DVec2::new(f64::from(p.x) * STEP, f64::from(p.y) * STEP);
    let [a, b, c, d] = [a, b, c, d].map(at);
    let (u, v, w) = (a - d, b - d, c - d);
    u.length_squared() * v.perp_dot(w)
        + v.length_squared() * w.perp_dot(u)
        + w.length_squared() * u.perp_dot(v)
}
