//! What the peers say of themselves, measured again; and the scenes that suit them.

use crate::clock::{keep, median, time};
use crate::meshes::{self, Spade};
use crate::movers::{Maker, box2d, rapier};
use crate::page::{Page, time as shown};
use crate::reference::worlds::Dice;
use crate::run;
use crate::scene::{Scene, rect, v};
use crate::scenes::empty;
use parry2d::query::{ShapeCastOptions, cast_shapes};
use parry2d::shape::Ball;
use rapier2d::prelude::{Pose, Vector};
use spade::Point2;

pub fn write(page: &mut Page, quick: bool) {
    page.heading(2, "6. The peers' own figures, and where they do well");
    let mut rows = Vec::new();
    rows.push(vec![
        "Box2D: planes are pushed apart to its linear slop (`B2_LINEAR_SLOP`), 5 mm".to_string(),
        "a mover at rest is so deep in level ground".to_string(),
        format!("{:.2} mm", -1e3 * rest(box2d::maker())),
    ]);
    rows.push(vec![
        "Rapier: `offset`, the gap that is kept, by default 1 % of the height (here 18.125 mm)"
            .to_string(),
        "the gap under a character at rest on level ground".to_string(),
        format!("{:.2} mm", 1e3 * rest(rapier::maker())),
    ]);
    rows.push(vec![
        "Parry: the example of `cast_shapes`: balls of radius 1, 10 apart, one coming at speed 2, meet at 4".to_string(),
        "time of impact".to_string(),
        format!("{}", impact()),
    ]);
    let ms = spade_of(14_000, if quick { 5 } else { 31 });
    rows.push(vec![
        "spade: its comparison page says of 14 000 points 5.8 or 7.3 ms (spade 2.0, machine not named)".to_string(),
        "bulk loading 14 000 uniform points".to_string(),
        shown(ms),
    ]);
    let figures: &[(usize, &str)] = &[
        (1000, "277.64 µs"),
        (10_000, "3.753 ms"),
        (100_000, "63.627 ms"),
        (1_000_000, "898.78 ms"),
    ];
    for &(n, figure) in &figures[..if quick { 3 } else { 4 }] {
        rows.push(vec![
            format!("delaunator: {n} points in {figure} (Core i7 of 2017)"),
            "uniform points".to_string(),
            shown(delaunator_of(n, (300_000 / n).clamp(1, 31))),
        ]);
    }
    page.table(&["published", "measured here", ""], &rows);
    page.list(&[
        "**Box2D** holds its 5 mm under any speed: `hits a slab at 10 km/s` and `flies at 1e8 m/s` in section 3. It pushes back and is pushed \
         by dynamic bodies, which Edgewalker does not have, and with the mean of the velocities its jump is exact to its slop."
            .to_string(),
        "**Rapier** idles on steep slopes for as long as one likes and hits slabs at any speed, within its gap, has 3D and dynamic bodies, takes any convex shape, turns it, \
         and is not bound to a grid or to 4 km: in section 5 it goes on where Edgewalker refuses."
            .to_string(),
        "**Parry** is exact to its last bit where one cast decides (`lands along a slope of 45 degrees`), for any pair of shapes.".to_string(),
        "**Push out**, some hundred lines, is exact on level ground and on lifts, and cheap where little is around.".to_string(),
        "**spade** takes coordinates as they are, needs half of the memory per vertex, and refines meshes. **delaunator** is the fastest \
         for plain points."
            .to_string(),
    ]);
}

/// A body on level ground.
fn standing() -> Scene {
    Scene {
        solids: vec![rect((-5.0, 5.0), (-1.0, 0.0))],
        start: v(0.0, 0.5),
        walk: Some(0.0),
        slides: false,
        ..empty("", "", 3.0)
    }
}

/// How high a mover stands after three seconds, m.
fn rest(maker: Maker) -> f64 {
    let scene = standing();
    let mut mover = (maker.make)(&scene).expect("anybody can stand");
    run::go(&mut *mover, &scene, 60.0);
    mover.at().y
}

fn impact() -> f32 {
    let (ball, options) = (Ball::new(1.0), ShapeCastOptions::default());
    let [here, there] = [0.0, 10.0].map(|x| Pose::from_translation(Vector::new(x, 0.0)));
    let speed = Vector::new(2.0, 0.0);
    let hit = cast_shapes(&here, speed, &ball, &there, Vector::ZERO, &ball, options);
    hit.ok()
        .flatten()
        .map_or(f32::NAN, |hit| hit.time_of_impact)
}

fn spade_of(n: usize, rounds: usize) -> f64 {
    let mut dice = Dice::new(2);
    let points: Vec<_> = (0..n)
        .map(|_| Point2::new(dice.unit(), dice.unit()))
        .collect();
    let times = (0..rounds).map(|_| {
        let mut points = Some(points.clone());
        time(|| keep(points.take().map(|p| Spade::bulk_load_cdt(p, Vec::new()))))
    });
    median(times.collect())
}

fn delaunator_of(n: usize, rounds: usize) -> f64 {
    let mut dice = Dice::new(2);
    let point = |dice: &mut Dice| delaunator::Point {
        x: dice.unit(),
        y: dice.unit(),
    };
    let points: Vec<_> = (0..n).map(|_| point(&mut dice)).collect();
    median(
        (0..rounds)
            .map(|_| time(|| keep(meshes::delaunator(&points))))
            .collect(),
    )
}
