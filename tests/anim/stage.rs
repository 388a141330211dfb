//! The figure in real levels: the whole recorded runs.

use super::RIG;
use super::feet::sole;
use edgewalker::anim::{Figure, Ground, Kind, angle_between};
use edgewalker::game::{Input, Replay, Sights, Soles, Stage, World};
use edgewalker::level;
use std::path::Path;
use std::sync::Arc;

/// The furthest that a bone turns within a tick, rad: a running thigh turns by 0.43.
const FASTEST: f32 = 0.49;

/// Ticks after which boots are on the ground once he has come to it.
const SETTLES: u32 = 4;
/// The furthest that boots may be in the ground, and over it after a landing, m.
const SUNK: f64 = 0.02;
const HOVERS: f64 = 0.06;
/// The share of a run's ticks in which one may be deeper, where limbs may turn no faster, and the furthest then, m: that is
/// at full speed up steps of 0.25 m.
const HURRIED: f64 = 0.02;
const HURRIED_SUNK: f64 = 0.35;

fn replay(name: &str) -> (Replay, World) {
    let path = Path::new("tests/golden").join(format!("{name}.replay.ron"));
    let replay = Replay::parse(&std::fs::read_to_string(path).unwrap()).unwrap();
    let stage = Stage::build(level::load(Path::new(&replay.level)).unwrap()).unwrap();
    let world = replay.world(Arc::new(stage)).unwrap();
    (replay, world)
}

#[test]
fn recorded_runs_are_acted_without_a_jump() {
    for run in ["gym", "quarry"] {
        let (replay, mut world) = replay(run);
        let mut soles = Soles::of(world.stage());
        let sights = Sights::of(world.stage());
        let mut figure = Figure::new(&world.view().moves(0.0, None), &RIG, &soles);
        let mut before = *figure.shown();
        let mut deaths = 0;
        let mut kinds = Vec::new();
        for input in replay.iter() {
            world.step(input, &replay.tuning);
            soles.follow(&world);
            let view = world.view();
            figure.advance(&view.moves(0.0, sights.near(view.position)), &RIG, &soles);
            assert!(figure.is_finite(), "{run}, tick {}", world.tick());
            let kind = figure.state().kind;
            if !kinds.contains(&kind) {
                kinds.push(kind);
            }
            let now = *figure.shown();
            if view.deaths == deaths {
                for (i, joint) in RIG.model.skeleton.joints.iter().enumerate() {
                    if ["cape", "lantern", "crest"]
                        .iter()
                        .any(|tail| joint.name.starts_with(tail))
                    {
                        continue; // what hangs swings freely
                    }
                    let turn = angle_between(before.pose.bones[i].turn, now.pose.bones[i].turn);
                    assert!(
                        turn < FASTEST,
                        "{run}, tick {}: {} turns by {turn} in {kind:?}",
                        world.tick(),
                        joint.name
                    );
                }
            }
            (before, deaths) = (now, view.deaths);
        }
        assert!(kinds.len() > 5, "{run}: {kinds:?}");
    }
}

/// How far the lower end of each boot is over the ground, m.
fn heights(figure: &Figure, soles: &Soles) -> [Option<f64>; 2] {
    [0, 1].map(|side| {
        let over = sole(figure.shown(), side).map(|end| {
            let ground = soles.under(end.x, end.y + 0.6, end.y - 1.0);
            ground.map(|(height, _)| end.y - height)
        });
        let found = over.into_iter().flatten();
        found.min_by(f64::total_cmp)
    })
}

/// What was seen of the boots in a run.
#[derive(Debug, Default)]
struct Seen {
    ticks: u32,
    hurried: u32,
    landings: u32,
}

impl Seen {
    /// Takes note of the lower boot of a figure that stands or goes; `name` says when.
    fn note(&mut self, kind: Kind, lowest: f64, name: &str) {
        self.ticks += 1;
        let goes = matches!(kind, Kind::Go | Kind::Turn);
        let deepest = if goes { HURRIED_SUNK } else { SUNK };
        assert!(lowest > -deepest, "{name}: a boot {lowest} m in the ground");
        self.hurried += u32::from(lowest < -SUNK);
        if matches!(kind, Kind::LandSoft | Kind::LandHard) {
            self.landings += 1;
            assert!(lowest < HOVERS, "{name}: boots {lowest} m over the ground");
        }
    }
}

#[test]
fn in_recorded_runs_no_boot_is_in_the_ground_and_none_hovers_after_a_landing() {
    let mut landings = 0;
    for run in ["gym", "quarry"] {
        let (replay, mut world) = replay(run);
        let mut soles = Soles::of(world.stage());
        let mut figure = Figure::new(&world.view().moves(0.0, None), &RIG, &soles);
        let (mut seen, mut since) = (Seen::default(), 0);
        for input in replay.iter() {
            world.step(input, &replay.tuning);
            soles.follow(&world);
            let was = figure.moves().support;
            figure.advance(&world.view().moves(0.0, None), &RIG, &soles);
            since = match figure.moves().support == was {
                true => since + 1,
                false => 0,
            };
            let state = figure.state();
            let found = heights(&figure, &soles);
            // Beyond a brink, in a run, there is none under either.
            let lowest = found.into_iter().flatten().min_by(f64::total_cmp);
            if let Some(lowest) = lowest.filter(|_| state.stands() && since >= SETTLES) {
                let name = format!("{run}, tick {}, {:?}", world.tick(), state.kind);
                seen.note(state.kind, lowest, &name);
            }
        }
        let most = HURRIED * f64::from(seen.ticks);
        assert!(f64::from(seen.hurried) < most, "{run}: {seen:?}");
        landings += seen.landings;
    }
    assert!(landings > 100, "{landings} ticks of landings");
}

#[test]
fn soles_find_floors_slopes_one_ways_and_movers() {
    let (_, mut world) = replay("gym");
    let mut soles = Soles::of(world.stage());
    let start = world.view().position;
    world.step(Input::default(), &Default::default());
    soles.follow(&world);
    let (height, slope) = soles.under(start.x, start.y + 0.7, start.y - 2.0).unwrap();
    assert!(
        (height - start.y).abs() < 2.0 && slope.abs() < 1.1,
        "{height} {slope}"
    );
    assert_eq!(soles.under(start.x, start.y + 500.0, start.y + 490.0), None);
}
