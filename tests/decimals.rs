//! Lengths as authors write them: the same scene anywhere on a raster of decimals, drawn either way round. What is exactly at a
//! limit is within it everywhere, and what is just beyond it nowhere.
//!
//! Numbers in names are those of the hard cases. `PLACES=100000 cargo test --release --test decimals` asks for that many places instead of the usual number.

#[path = "common/worlds.rs"]
mod worlds;

use edgewalker::game::{Input, Stage, World};
use edgewalker::level;
use edgewalker::tune::{Motion, Tuning};
use glam::DVec2;
use std::path::Path;
use std::sync::Arc;
use worlds::Dice;

/// How many places the walk over all limits is tried at, unless the environment says otherwise.
const PLACES: u32 = 3000;

/// Each other scene is tried at one in so many.
const SHARE: u32 = 15;

/// Rasters, in micrometres.
const RASTERS: [i64; 3] = [100_000, 10_000, 1_000];

/// A place on a raster, and which way the scene is drawn there.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Micrometres.
    x: i64,
    y: i64,
    raster: i64,
    mirrored: bool,
    /// The corners are listed the other way round.
    clockwise: bool,
}

impl Place {
    fn random(dice: &mut Dice, number: u32) -> Place {
        let raster = RASTERS[number as usize % 3];
        // Near the origin, and as far out as the world goes.
        let reach = [20, 900, 3900][dice.below(3) as usize] * 1_000_000 / raster;
        let mut coordinate = || (dice.between(-1.0, 1.0) * reach as f64).round() as i64 * raster;
        let (x, y) = (coordinate(), coordinate());
        Place {
            x,
            y,
            raster,
            mirrored: dice.below(2) == 0,
            clockwise: dice.below(2) == 0,
        }
    }

    /// A point of the scene, micrometres to the right of the place and above it, as a level file writes it.
    fn at(&self, (x, y): (i64, i64)) -> String {
        let x = if self.mirrored {
            self.x - x
        } else {
            self.x + x
        };
        let decimal = |c: i64| {
            let (sign, c) = (if c < 0 { "-" } else { "" }, c.unsigned_abs());
            format!("{sign}{}.{:06}", c / 1_000_000, c % 1_000_000)
        };
        format!("({}, {})", decimal(x), decimal(self.y + y))
    }

    /// The same as a position.
    fn metres(&self, (x, y): (i64, i64)) -> DVec2 {
        let x = if self.mirrored {
            self.x - x
        } else {
            self.x + x
        };
        DVec2::new(x as f64 / 1e6, (self.y + y) as f64 / 1e6)
    }

    /// A length rounded up to the raster.
    fn up(&self, length: i64) -> i64 {
        (length + self.raster - 1) / self.raster * self.raster
    }

    fn outline(&self, corners: &[(i64, i64)]) -> String {
        let mut corners: Vec<String> = corners.iter().map(|&c| self.at(c)).collect();
        if self.clockwise {
            corners.reverse();
        }
        format!("outline: [{}]", corners.join(", "))
    }

    /// A line with its front up: from left to right.
    fn line(&self, corners: &[(i64, i64)]) -> String {
        let mut corners: Vec<String> = corners.iter().map(|&c| self.at(c)).collect();
        if self.mirrored {
            corners.reverse();
        }
        format!("outline: [{}]", corners.join(", "))
    }

    /// Room in a level from one corner of it to another.
    fn room(&self, (x0, y0): (i64, i64), (x1, y1): (i64, i64)) -> String {
        let (x0, x1) = if self.mirrored { (x1, x0) } else { (x0, x1) };
        format!("(min: {}, max: {})", self.at((x0, y0)), self.at((x1, y1)))
    }

    fn run(&self, run: i8) -> Input {
        Input {
            run: if self.mirrored { -run } else { run },
            ..Input::default()
        }
    }

    /// A world with these features and areas, and its start; `None` if that is refused.
    fn world(&self, start: (i64, i64), features: &[String], areas: &[String]) -> Option<World> {
        let ids = features.iter().enumerate();
        let features: Vec<String> = ids.map(|(i, f)| format!("(id: \"{i}\", {f})")).collect();
        let text = format!(
            "(version: 1, name: \"place\", start: {}, goal: {}, bottom: -3999, features: [{}], areas: [{}])",
            self.at(start),
            self.room((-40 * M, 30 * M), (-39 * M, 31 * M)),
            features.join(", "),
            areas.join(", ")
        );
        let level = level::parse(&text, Path::new("place.ron"));
        let level = level.unwrap_or_else(|e| panic!("{e}\n{text}"));
        Some(World::new(Arc::new(Stage::build(level).ok()?), 120, 0))
    }
}

/// A metre, in micrometres.
const M: i64 = 1_000_000;

/// A solid from one corner of a box to the other.
fn block(place: &Place, (x0, y0): (i64, i64), (x1, y1): (i64, i64)) -> String {
    place.outline(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
}

/// How high above its place the hero is, micrometres, rounded; and whether he stands.
fn height(world: &World, place: &Place) -> (i64, bool) {
    let up = (world.view().position.y - place.y as f64 / 1e6) * 1e6;
    (up.round() as i64, world.hero().supported())
}

/// What is wrong with a scene at a place; `None`: nothing.
type Trial = fn(&Place, &mut Dice) -> Option<String>;

/// Tries a scene at many places: none may fail.
fn everywhere(name: &str, trial: Trial) {
    tried(name, SHARE, trial);
}

/// Tries one at one place in so many.
fn tried(name: &str, share: u32, trial: Trial) {
    let count = std::env::var("PLACES").ok();
    let count = count.map_or(PLACES, |count| count.parse().expect("a number of places"));
    let count = count.div_ceil(share);
    let mut failures = Vec::new();
    for number in 0..count {
        let mut dice = Dice::new(u64::from(number) + 77);
        let place = Place::random(&mut dice, number);
        if let Some(wrong) = trial(&place, &mut dice) {
            failures.push(format!("{number}: {wrong} at {place:?}"));
        }
    }
    println!("{name}: {} of {count} fail", failures.len());
    assert!(
        failures.is_empty(),
        "{} of {count} {name}, first {}",
        failures.len(),
        failures[0]
    );
}

/// How far up he comes at last who starts on the floor at -2 m and runs to the right; `None` if he cannot start or is in the air.
///
/// Of 127 parts of full speed he runs with so many: what is steep he comes up a little with his speed alone.
fn ends_at(place: &Place, tuning: &Motion, features: &[String], run: i8) -> Option<i64> {
    let world = &mut place.world((-2 * M, 0), features, &[])?;
    let tuning = Tuning {
        motion: tuning.clone(),
        ..Tuning::default()
    };
    for _ in 0..(if run == 127 { 120 } else { 240 }) {
        world.step(place.run(run), &tuning);
    }
    let (up, stands) = height(world, place);
    stands.then_some(up)
}

/// Whether two heights are one but for the grid.
fn same(found: Option<i64>, wanted: i64) -> bool {
    found.is_some_and(|found| (found - wanted).abs() <= 40)
}

/// Below everything that matters.
const DEEP: i64 = -3 * M;

/// A floor, a ramp from its end, a level top. Its foot may reach through the floor: then it begins at a crossing.
fn ramp(place: &Place, run: i64, rise: i64, sunk: bool) -> [String; 3] {
    let foot = if sunk { (-run, -rise) } else { (0, 0) };
    [
        block(
            place,
            (-8 * M, DEEP - rise),
            (if sunk { run / 2 } else { 0 }, 0),
        ),
        place.outline(&[(foot.0, DEEP - rise), (run, DEEP - rise), (run, rise), foot]),
        block(place, (run, DEEP), (run + 20 * M, rise)),
    ]
}

#[test]
fn scene_35_a_ramp_at_the_limit_is_walked_and_one_beyond_it_is_not() {
    everywhere("ramps", |place, dice| {
        let run = place.up(50_000 + i64::from(dice.below(2_000_000)));
        let sunk = dice.below(2) == 0;
        let usual = Motion {
            step_up: 0.0,
            ..Motion::default()
        };
        let half = Motion {
            max_slope: 0.5,
            ..usual.clone()
        };
        // A tenth of a degree more: tan 45.1 = 1.003497, and half as much again twice as far out.
        let over = place.up(run * 3_497 / M + 1);
        let top =
            |run, rise, tuning, speed| ends_at(place, tuning, &ramp(place, run, rise, sunk), speed);
        let mut wrong = Vec::new();
        if !same(top(run, run, &usual, 127), run) {
            wrong.push("45 degrees are not walked");
        }
        if same(top(run, run + over, &usual, 20), run + over) {
            wrong.push("more than 45 degrees are walked");
        }
        if !same(top(2 * run, run, &half, 127), run) {
            wrong.push("half a slope is not walked");
        }
        if same(top(2 * run, run + over, &half, 20), run + over) {
            wrong.push("more than half a slope is walked");
        }
        (!wrong.is_empty()).then(|| format!("{wrong:?}, {run}, {sunk}"))
    });
}

/// A floor, and a step up from it at 0. The step may begin above the floor's depth or end in it.
fn step(place: &Place, rise: i64, sunk: bool) -> [String; 2] {
    let end = if sunk { 20 * M } else { 0 };
    [
        block(place, (-8 * M, DEEP), (end, 0)),
        block(place, (0, DEEP), (20 * M, rise)),
    ]
}

#[test]
fn scene_45_a_step_at_the_limit_is_climbed_and_one_beyond_it_is_not() {
    everywhere("steps up", |place, dice| {
        let sunk = dice.below(2) == 0;
        let usual = Motion::default();
        let (high, limit) = (
            Motion {
                step_up: 0.3,
                ..usual.clone()
            },
            300_000,
        );
        let top = |rise, tuning| ends_at(place, tuning, &step(place, rise, sunk), 127);
        let over = place.up(1_000);
        let mut wrong = Vec::new();
        if !same(top(200_000, &usual), 200_000) {
            wrong.push("0.2 m is not climbed");
        }
        if same(top(200_000 + over, &usual), 200_000 + over) {
            wrong.push("more than 0.2 m is climbed");
        }
        if !same(top(limit, &high), limit) {
            wrong.push("0.3 m is not climbed");
        }
        if same(top(limit + over, &high), limit + over) {
            wrong.push("more than 0.3 m is climbed");
        }
        (!wrong.is_empty()).then(|| format!("{wrong:?}, {sunk}"))
    });
}

/// Whether one who runs off a step down is ever in the air.
fn falls(place: &Place, drop: i64, tuning: &Motion, sunk: bool) -> Option<bool> {
    let low = if sunk { -8 * M } else { 0 };
    let features = [
        block(place, (-8 * M, DEEP), (0, 0)),
        block(place, (low, DEEP), (20 * M, -drop)),
    ];
    let world = &mut place.world((-2 * M, 0), &features, &[])?;
    let tuning = Tuning {
        motion: tuning.clone(),
        ..Tuning::default()
    };
    world.step(place.run(127), &tuning);
    let mut falls = false;
    for _ in 0..90 {
        world.step(place.run(127), &tuning);
        falls |= !world.hero().supported();
    }
    let (up, stands) = height(world, place);
    (stands && (up + drop).abs() <= 40).then_some(falls)
}

#[test]
fn scene_44_a_step_down_at_the_limit_is_walked_and_off_one_beyond_it_he_falls() {
    everywhere("steps down", |place, dice| {
        let sunk = dice.below(2) == 0;
        let usual = Motion::default();
        let deep = Motion {
            floor_snap: 0.4,
            ..usual.clone()
        };
        let over = place.up(1_000);
        let found = [
            falls(place, 200_000, &usual, sunk),
            falls(place, 200_000 + over, &usual, sunk),
            falls(place, 400_000, &deep, sunk),
            falls(place, 400_000 + over, &deep, sunk),
        ];
        let right = [false, true, false, true].map(Some);
        (found != right).then(|| format!("falls: {found:?}, {sunk}"))
    });
}

/// Whether one who falls on the middle of a one-way of a slope comes to stand on it.
fn holds(place: &Place, run: i64, rise: i64, tuning: &Motion) -> Option<bool> {
    let line = format!("kind: OneWay, {}", place.line(&[(0, 0), (run, rise)]));
    let start = (run / 2, rise / 2 + M);
    let features = [block(place, (-8 * M, DEEP - M), (20 * M, DEEP)), line];
    let world = &mut place.world(start, &features, &[])?;
    let tuning = Tuning {
        motion: tuning.clone(),
        ..Tuning::default()
    };
    for _ in 0..120 {
        world.step(Input::default(), &tuning);
    }
    let (up, stands) = height(world, place);
    Some(stands && up > 0)
}

#[test]
fn scene_60_a_one_way_at_the_limit_holds_and_one_beyond_it_does_not() {
    everywhere("one-ways", |place, dice| {
        let run = place.up(2_000_000 + i64::from(dice.below(2_000_000)));
        let over = place.up(run * 3_497 / M + 1);
        let usual = Motion::default();
        let half = Motion {
            max_slope: 0.5,
            ..usual.clone()
        };
        let found = [
            holds(place, run, run, &usual),
            holds(place, run, run + over, &usual),
            holds(place, 2 * run, run, &half),
            holds(place, 2 * run, run + over, &half),
        ];
        let right = [true, false, true, false].map(Some);
        (found != right).then(|| format!("holds: {found:?}, {run}"))
    });
}

/// Whether he stands, at a height, after no more than a tick, and has not moved.
fn stands_at_once(world: &mut World, place: &Place, at: (i64, i64)) -> bool {
    world.step(Input::default(), &Tuning::default());
    let away = (world.view().position - place.metres(at))
        .abs()
        .max_element();
    world.hero().supported() && away <= 2e-5 && world.hero().velocity() == DVec2::ZERO
}

#[test]
fn who_is_put_on_a_floor_stands_on_it() {
    everywhere("starts and respawns", |place, dice| {
        // Level ground, and a slope of 3 in 10 from its end on.
        let far = place.up(3 * M) / 3 * 10;
        let rise = far / 10 * 3;
        let features = [
            block(place, (-8 * M, DEEP), (0, 0)),
            place.outline(&[(0, DEEP), (far, DEEP), (far, rise), (0, 0)]),
            format!(
                "kind: OneWay, {}",
                place.line(&[(-6 * M, 4 * M), (-2 * M, 4 * M)])
            ),
            format!(
                "kind: Checkpoint, {}, respawn: Some({})",
                block(place, (-5 * M, 0), (-4 * M, M)),
                place.at((-5 * M, 4 * M))
            ),
            format!(
                "kind: Hazard, by: Some(Foot), {}",
                block(place, (-8 * M, 0), (-7 * M, M))
            ),
        ];
        let slope = i64::from(dice.below(900)) * (far / 1000) + far / 20;
        // On a slope the foot's uphill corner touches: a quarter of a metre beside its middle.
        let on_slope = (slope, (slope + 250_000) * 3 / 10);
        let Some(mut world) = place.world((-3 * M, 0), &features, &[]) else {
            return Some("the start is refused".into());
        };
        if !stands_at_once(&mut world, place, (-3 * M, 0)) {
            return Some("does not stand at the start".into());
        }
        for at in [(-M, 0), (-4 * M, 4 * M), on_slope] {
            if world.put(place.metres(at)).is_err() {
                return Some(format!("{at:?} is refused"));
            }
            if !stands_at_once(&mut world, place, at) {
                return Some(format!("does not stand at {at:?}"));
            }
        }
        let _ = world.put(place.metres((-3_500_000, 0)));
        for _ in 0..30 {
            world.step(place.run(-127), &Tuning::default());
        }
        let _ = world.put(place.metres((-7_500_000, 100_000)));
        for _ in 0..3 {
            world.step(Input::default(), &Tuning::default());
        }
        let back = world.view().deaths == 1 && stands_at_once(&mut world, place, (-5 * M, 4 * M));
        (!back).then(|| "does not stand where he comes back".into())
    });
}

#[test]
fn a_room_that_begins_at_the_height_of_a_floor_is_entered() {
    everywhere("rooms", |place, dice| {
        let up = place.up(M + i64::from(dice.below(4_000_000)));
        let area =
            |name: &str, room: String| format!("(name: \"{name}\", room: {room}, mood: Dusk)");
        let areas = [
            area("upper", place.room((-8 * M, up), (0, up + 3 * M))),
            area("lower", place.room((-8 * M, 0), (0, up - 1_000))),
            area("else", place.room((-8 * M, DEEP), (8 * M, up + 4 * M))),
        ];
        let line = format!("kind: OneWay, {}", place.line(&[(-8 * M, up), (8 * M, up)]));
        let features = [block(place, (-8 * M, DEEP), (8 * M, 0)), line];
        let Some(mut world) = place.world((3 * M, 0), &features, &areas) else {
            return Some("the start is refused".into());
        };
        // At its sides a room ends where the grid has them, up to half a step from there: a millimetre inside he is in it.
        for (at, area) in [
            ((-M, 0), 1),
            ((M, up), 2),
            ((-M, up), 0),
            ((-M, 2_000), 1),
            ((-1_000, up), 0),
        ] {
            if world.put(place.metres(at)).is_err() {
                return Some(format!("{at:?} is refused"));
            }
            world.step(Input::default(), &Tuning::default());
            if world.view().area != area {
                return Some(format!(
                    "at {at:?} he is in area {}, not {area}",
                    world.view().area
                ));
            }
        }
        None
    });
}

/// Whether he gets from -2 m through a corridor of a height from 2 m to 6 m, upright or crouching.
fn passes(place: &Place, high: i64, down: bool) -> Option<bool> {
    let features = [
        block(place, (-8 * M, DEEP), (20 * M, 0)),
        block(place, (2 * M, high), (6 * M, high + M)),
    ];
    let world = &mut place.world((-2 * M, 0), &features, &[])?;
    for _ in 0..(if down { 480 } else { 180 }) {
        let run = place.run(127);
        world.step(Input { down, ..run }, &Tuning::default());
    }
    let way = (world.view().position.x - place.x as f64 / 1e6).abs();
    Some(way > 6.5)
}

#[test]
fn a_corridor_of_the_stated_size_is_passed() {
    everywhere("corridors", |place, _| {
        // As README states them; and a centimetre less, which he does not pass.
        let found = [
            passes(place, 1_710_000, false),
            passes(place, 1_700_000, false),
            passes(place, 960_000, true),
            passes(place, 950_000, true),
        ];
        if found != [true, false, true, false].map(Some) {
            return Some(format!("passes: {found:?}"));
        }
        // A shaft, from above: he falls through it, or stays on its brink.
        for (wide, falls) in [(820_000, true), (810_000, false)] {
            let features = [
                block(place, (-8 * M, 0), (0, M)),
                block(place, (wide, 0), (wide + 8 * M, M)),
                block(place, (-8 * M, -4 * M), (8 * M, -3 * M)),
            ];
            let Some(mut world) = place.world((wide / 2, 2 * M), &features, &[]) else {
                return Some("the start is refused".into());
            };
            for _ in 0..180 {
                world.step(Input::default(), &Tuning::default());
            }
            if near(height(&world, place), -3 * M) != falls {
                return Some(format!("a shaft of {wide}: {:?}", height(&world, place)));
            }
        }
        None
    });
}

fn near((up, stands): (i64, bool), wanted: i64) -> bool {
    stands && (up - wanted).abs() <= 40
}

#[test]
fn ground_drawn_in_one_line_of_several_pieces_is_one_slope() {
    everywhere("slopes in pieces", |place, dice| {
        // 45 degrees, or 3 in 10, in five pieces, and a walker who leaves the ground at every bend.
        let (run, rise) = [(1, 1), (10, 3)][dice.below(2) as usize];
        let unit = place.up(20_000 + i64::from(dice.below(60_000)));
        let ends: Vec<i64> = (0..=5).map(|i| i * (i + 4) * unit).collect();
        let depth = DEEP - ends[5] * rise;
        let slope = ends.windows(2).map(|pair| {
            let [a, b] = [pair[0], pair[1]];
            place.outline(&[
                (a * run, depth),
                (b * run, depth),
                (b * run, -b * rise),
                (a * run, -a * rise),
            ])
        });
        let floor = block(place, (-8 * M, depth), (0, 0));
        let features: Vec<String> = std::iter::once(floor).chain(slope).collect();
        // On the slope, the downhill corner of the foot a quarter of a metre behind its middle.
        let start = ends[3] * run;
        let at = (start, -(start - 250_000) * rise / run);
        let Some(mut world) = place.world((-2 * M, 0), &features, &[]) else {
            return Some("the start is refused".into());
        };
        let tuning = Tuning {
            motion: Motion {
                joint: 2.0,
                slope_speed: 0.0,
                ..Motion::default()
            },
            ..Tuning::default()
        };
        if world.put(place.metres(at)).is_err() {
            return Some(format!("{at:?} is refused"));
        }
        // At rest on it first: who pushes off at once flies off it.
        world.step(Input::default(), &tuning);
        let end = ((ends[5] * run) as f64 / 1e6 - 0.1, place.x as f64 / 1e6);
        while (world.view().position.x - end.1).abs() < end.0 {
            world.step(place.run(127), &tuning);
            if !world.hero().supported() {
                let way = world.view().position.x - end.1;
                return Some(format!("off the ground at {way}, {run}, {unit}"));
            }
        }
        None
    });
}

/// Whether one who runs at a speed stays on the ground over the edge of a plain: it bends down by an angle, in an arc of a radius
/// that is drawn in pieces of a length; radians and metres.
fn stays(place: &Place, (angle, radius, piece): (f64, f64, f64), speed: f64) -> Option<bool> {
    let micro = |c: f64| (c * 1e6).round() as i64;
    let count = (angle * radius / piece).ceil() as u32;
    let mut line = vec![(-8 * M, 0)];
    line.extend((0..=count).map(|i| {
        let turn = angle * f64::from(i) / f64::from(count.max(1));
        (
            micro(radius * turn.sin()),
            micro(radius * (turn.cos() - 1.0)),
        )
    }));
    let end = *line.last().unwrap();
    line.push((
        end.0 + micro(4.0 * angle.cos()),
        end.1 - micro(4.0 * angle.sin()),
    ));
    let below = line[line.len() - 1];
    line.extend([(below.0, below.1 - M), (-8 * M, below.1 - M)]);
    let world = &mut place.world((-7 * M, 0), &[place.outline(&line)], &[])?;
    let motion = Motion {
        run_speed: speed,
        ..Motion::default()
    };
    let tuning = Tuning {
        motion,
        ..Tuning::default()
    };
    world.step(place.run(127), &tuning);
    while (world.view().position.x - place.x as f64 / 1e6).abs() > 6.9 {
        world.step(place.run(127), &tuning);
    }
    let mut stays = true;
    let past = below.0 as f64 / 1e6 - 0.5;
    while (world.view().position.x - place.x as f64 / 1e6)
        * (if place.mirrored { -1.0 } else { 1.0 })
        < past
    {
        world.step(place.run(127), &tuning);
        stays &= world.hero().supported();
    }
    Some(stays)
}

#[test]
fn scene_42_a_curve_holds_alike_however_finely_it_is_drawn() {
    tried("curves", 20 * SHARE, |place, dice| {
        let piece = [0.001, 0.002, 0.005, 0.009, 0.013, 0.025, 0.05][dice.below(7) as usize];
        let forty = 40.0_f64.to_radians();
        // s^2 k is 12.8, 64 and 107; gravity and stick make 74 on the steepest stretch and 85 on the level.
        let arcs = [5.0, 1.0, 0.6].map(|radius| {
            // In a level file an outline has at most 4096 corners.
            let angle = if radius > 3.0 { forty / 2.0 } else { forty };
            stays(place, (angle, radius, piece), 8.0)
        });
        if arcs != [true, true, false].map(Some) {
            return Some(format!("arcs in pieces of {piece}: {arcs:?}"));
        }
        // A corner of 30 degrees, sharp or rounded by less than a centimetre: it holds up to 12.5 m/s.
        let corner = 30.0_f64.to_radians();
        for (radius, piece) in [(0.0, 1.0), (0.01, 0.001), (0.008, 0.002), (0.004, 0.0005)] {
            let found = [11.0, 14.0].map(|speed| stays(place, (corner, radius, piece), speed));
            if found != [true, false].map(Some) {
                return Some(format!(
                    "corner of {radius} in pieces of {piece}: {found:?}"
                ));
            }
        }
        None
    });
}

/// Up a ramp, a step up, a step down; then onto a one-way, and into a room that begins at its floor.
#[test]
fn all_that_is_exactly_at_a_limit_is_within_it() {
    tried("walks over all limits", 1, |place, dice| {
        let run = place.up(M + i64::from(dice.below(2_000_000)));
        let step = 200_000;
        let line = place.line(&[(-20 * M, 4 * M), (-20 * M + run, 4 * M + run)]);
        let area =
            |name: &str, room: String| format!("(name: \"{name}\", room: {room}, mood: Dusk)");
        let areas = [
            area("upper", place.room((-8 * M, 0), (0, 3 * M))),
            area("else", place.room((-30 * M, DEEP), (30 * M, 9 * M))),
        ];
        let features = [
            block(place, (-8 * M, DEEP), (0, 0)),
            place.outline(&[(0, DEEP), (run, DEEP), (run, run), (0, 0)]),
            block(place, (run, DEEP), (run + 2 * M, run)),
            block(place, (run + 2 * M, DEEP), (run + 4 * M, run + step)),
            block(place, (run + 4 * M, DEEP), (run + 20 * M, run)),
            format!("kind: OneWay, {line}"),
        ];
        let Some(mut world) = place.world((-2 * M, 0), &features, &areas) else {
            return Some("the start is refused".into());
        };
        if !stands_at_once(&mut world, place, (-2 * M, 0)) || world.view().area != 0 {
            return Some("does not stand in the room where he starts".into());
        }
        let mut highest = 0;
        for _ in 0..180 {
            world.step(place.run(127), &Tuning::default());
            let (up, stands) = height(&world, place);
            highest = highest.max(up);
            if !stands {
                return Some(format!("in the air at {up}"));
            }
        }
        let (up, _) = height(&world, place);
        if (up - run).abs() > 40 || (highest - run - step).abs() > 40 {
            return Some(format!("up to {highest}, then at {up}, of {run}"));
        }
        let over = (-20 * M + run / 2, 4 * M + run / 2 + 300_000);
        if world.put(place.metres(over)).is_err() {
            return Some("no room over the one-way".into());
        }
        for _ in 0..30 {
            world.step(Input::default(), &Tuning::default());
        }
        let (up, stands) = height(&world, place);
        (!stands || up < 4 * M).then(|| format!("the one-way does not hold: {up}"))
    });
}
