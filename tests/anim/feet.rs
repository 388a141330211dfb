//! Feet stay where they stand.

use super::{RIG, Slope, Stairs, at, running};
use edgewalker::anim::{Bone, Figure, Ground, Moves, Shown};
use glam::{DVec2, Vec3};

/// Heel and ball of a sole beside the ankle, as hero_pose.py has them, m.
const SOLE: [f32; 2] = [-0.055, 0.105];
const TICK: f64 = 1.0 / 120.0;

/// The two ends of a sole in the level.
pub fn sole(shown: &Shown, side: usize) -> [DVec2; 2] {
    let leg = &RIG.legs[side];
    let bone = shown.bones(&RIG)[leg.bones[2]];
    SOLE.map(|x| {
        let end = bone.transform_point3(Vec3::new(x, -leg.ankle, 0.0));
        shown.foot + end.truncate().as_dvec2()
    })
}

/// Follows the soles of a run: how far the end that carries slides during a contact, and the number of contacts.
fn slides(ground: &dyn Ground, moves: impl Fn(f64) -> Moves, seconds: f64) -> (f64, usize) {
    let mut figure = Figure::new(&moves(0.0), &RIG, ground);
    let mut stood: [Option<(usize, DVec2)>; 2] = [None; 2];
    let (mut worst, mut contacts) = (0.0f64, 0);
    for tick in 1..=(seconds / TICK) as u32 {
        let time = f64::from(tick) * TICK;
        figure.advance(&moves(time), &RIG, ground);
        for (side, stood) in stood.iter_mut().enumerate() {
            let ends = sole(figure.shown(), side);
            let Some(end) = figure.stands_on(side) else {
                *stood = None;
                continue;
            };
            match *stood {
                Some((was, at)) if was == end => worst = worst.max((ends[end].x - at.x).abs()),
                _ => {
                    contacts += usize::from(stood.is_none());
                    *stood = Some((end, ends[end]));
                }
            }
        }
    }
    (worst, contacts)
}

#[test]
fn feet_do_not_slide_at_any_speed_on_any_slope() {
    for speed in [0.8, 1.6, 3.0, 4.5, 6.0, 8.0, -8.0, -2.0] {
        for slope in [0.0, 0.3, -0.3, 0.7, -0.7] {
            let (worst, contacts) = slides(&Slope(slope), |t| running(speed, slope, t), 3.0);
            let name = format!("{speed} m/s on a slope of {slope}");
            assert!(contacts >= 3, "{name}: {contacts} contacts");
            // At full speed down the steepest slopes a leg comes a tick late: it may turn no faster.
            let downhill = -slope * speed.signum();
            let most = if downhill > 0.5 { 0.03 } else { 0.01 };
            assert!(worst < most, "{name}: slides {worst} m");
        }
    }
}

#[test]
fn feet_do_not_slide_while_the_speed_changes() {
    // 0 to 8 m/s and back to 0, at 8 m/s^2.
    let moves = |t: f64| {
        let (up, down) = (t.min(1.0), (t - 1.0).clamp(0.0, 1.0));
        let x = 4.0 * up * up + 8.0 * down - 4.0 * down * down;
        Moves {
            time: t,
            velocity: DVec2::X * 8.0 * (up - down),
            ..Moves::standing(DVec2::X * x)
        }
    };
    let (worst, contacts) = slides(&Slope(0.0), moves, 3.0);
    assert!(
        worst < 0.01 && contacts > 5,
        "{worst} m, {contacts} contacts"
    );
}

#[test]
fn feet_are_planted_on_lifts_and_belts() {
    // Standing on a belt that carries him: the feet go with it.
    let moves = |t: f64| Moves {
        time: t,
        velocity: DVec2::X * 3.0,
        carried: DVec2::X * 3.0,
        ..Moves::standing(DVec2::X * 3.0 * t)
    };
    let mut figure = Figure::new(&moves(0.0), &RIG, &Slope(0.0));
    let start = sole(figure.shown(), 0)[0].x;
    for tick in 1..=120 {
        figure.advance(&moves(f64::from(tick) * TICK), &RIG, &Slope(0.0));
    }
    let carried = sole(figure.shown(), 0)[0].x - start;
    assert!((carried - 3.0).abs() < 0.02, "{carried}");
}

#[test]
fn standing_feet_are_on_the_slope_and_on_the_stairs() {
    for slope in [-0.8, -0.4, 0.0, 0.3, 0.9] {
        let moves = |t: f64| Moves {
            time: t,
            ..running(0.0, slope, 0.0)
        };
        let mut figure = Figure::new(&moves(0.0), &RIG, &Slope(slope));
        (1..=120).for_each(|i| figure.advance(&moves(f64::from(i) * TICK), &RIG, &Slope(slope)));
        for side in 0..2 {
            for end in sole(figure.shown(), side) {
                let off = end.y - slope * end.x;
                assert!(off.abs() < 0.03, "slope {slope}, side {side}: {off} m");
            }
        }
    }
}

#[test]
fn on_the_edge_of_a_stair_one_foot_is_a_step_lower() {
    // Where along the edge the feet are on both sides of it depends on the clip's stance.
    let heights = |x: f64| {
        let still = |t: f64| Moves {
            time: t,
            ..Moves::standing(DVec2::new(x, 0.2))
        };
        let mut figure = Figure::new(&still(0.0), &RIG, &Stairs);
        (1..=240).for_each(|i| figure.advance(&still(f64::from(i) * TICK), &RIG, &Stairs));
        [0, 1].map(|side| sole(figure.shown(), side)[0].y)
    };
    let apart = |[a, b]: [f64; 2]| a.min(b).abs() < 0.02 && (a.max(b) - 0.2).abs() < 0.02;
    let found: Vec<[f64; 2]> = (0..20)
        .map(|i| heights(0.5 + 0.01 * f64::from(i)))
        .collect();
    assert!(found.iter().any(|&pair| apart(pair)), "{found:?}");
}

#[test]
fn who_has_stopped_stands_as_he_should_after_a_moment() {
    let moves = |t: f64| {
        let x = if t < 1.0 { 8.0 * t } else { 8.0 };
        Moves {
            time: t,
            velocity: DVec2::X * if t < 1.0 { 8.0 } else { 0.0 },
            ..Moves::standing(DVec2::X * x)
        }
    };
    let mut figure = Figure::new(&moves(0.0), &RIG, &Slope(0.0));
    (1..=300).for_each(|i| figure.advance(&moves(f64::from(i) * TICK), &RIG, &Slope(0.0)));
    let rested = Figure::new(&moves(2.5), &RIG, &Slope(0.0));
    for foot in [Bone::FootLeft, Bone::FootRight] {
        let off = at(figure.shown(), foot).distance(at(rested.shown(), foot));
        assert!(off < 0.06, "{foot:?}: {off} m");
    }
}
