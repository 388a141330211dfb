//! Where the body and the figure differ: at the end of the ground, on a ledge just climbed, on a ladder.

use super::feet::sole;
use super::{RIG, at};
use edgewalker::anim::{Bone, Figure, Ground, Moves, Support};
use glam::{DVec2, Vec2};

const TICK: f64 = 1.0 / 120.0;
/// Half of the foot that the body has, m: so far out over a brink it can stand.
const FOOT: f64 = 0.25;
/// The furthest that a boot may be in the ground or over it, m.
const OFF: f64 = 0.02;
/// So much of a boot may hang over the brink, m: its toe.
const TOE: f64 = 0.07;

/// Level ground from the origin to the right, up to a place; a ladder stands on it.
struct Shelf {
    end: f64,
}

/// The ends of that ladder.
const LADDER: (f64, f64) = (3.0, 3.9);

impl Ground for Shelf {
    fn under(&self, x: f64, high: f64, low: f64) -> Option<(f64, f32)> {
        ((0.0..=self.end).contains(&x) && (low..=high).contains(&0.0)).then_some((0.0, 0.0))
    }

    fn ladder(&self, x: f64, _: f64) -> Option<(f64, f64)> {
        (LADDER.0..=LADDER.1).contains(&x).then_some(LADDER)
    }
}

const CLIFF: Shelf = Shelf { end: 50.0 };

/// Fails unless both boots are on the shelf.
fn expect_on(figure: &Figure, shelf: &Shelf, when: &str) {
    for side in 0..2 {
        for end in sole(figure.shown(), side) {
            let on = (-TOE..shelf.end + TOE).contains(&end.x) && end.y.abs() < OFF;
            assert!(on, "{when}: boot {side} at {end}");
        }
    }
}

#[test]
fn who_stands_at_a_brink_has_both_boots_on_the_ground() {
    for facing in [-1.0, 1.0] {
        for out in [0.0, 0.1, 0.2, FOOT] {
            let still = |t: f64| Moves {
                time: t,
                facing,
                ..Moves::standing(DVec2::new(-out, 0.0))
            };
            // He has come to a stop there.
            let comes = |t: f64| Moves {
                velocity: DVec2::NEG_X * 5.0,
                foot: DVec2::new(-out + 5.0 * (0.5 - t), 0.0),
                ..still(t)
            };
            let mut figure = Figure::new(&comes(0.0), &RIG, &CLIFF);
            for tick in 1..=180 {
                let t = f64::from(tick) * TICK;
                let moves = if t < 0.5 { comes(t) } else { still(t) };
                figure.advance(&moves, &RIG, &CLIFF);
            }
            expect_on(&figure, &CLIFF, &format!("{out} m out, facing {facing}"));
        }
    }
}

#[test]
fn on_a_narrow_post_he_stands_in_its_middle() {
    let post = Shelf { end: 0.3 };
    for x in [-0.2, 0.05, 0.15, 0.3, 0.5] {
        let figure = Figure::new(&Moves::standing(DVec2::new(x, 0.0)), &RIG, &post);
        let hips = at(figure.shown(), Bone::Hips).x;
        assert!((hips - 0.15).abs() < 0.1, "from {x}: hips at {hips}");
    }
}

#[test]
fn a_run_over_a_brink_is_not_held_back() {
    let moves = |t: f64| super::running(8.0, 0.0, t);
    let short = Shelf { end: 4.0 };
    let mut figure = Figure::new(&moves(0.0), &RIG, &short);
    for tick in 1..=60 {
        figure.advance(&moves(f64::from(tick) * TICK), &RIG, &short);
        let shown = figure.shown();
        assert!(shown.offset.x.abs() < 0.01, "tick {tick}: {}", shown.offset);
    }
}

#[test]
fn who_has_climbed_onto_a_ledge_stands_on_it() {
    // As the mover does it: up at 5 m/s beside the wall, in over the corner with the last of the height, then at rest.
    let from = DVec2::new(-0.406, -1.3);
    let moves = |t: f64| {
        let y = (from.y + 5.0 * t).min(0.0);
        let climbs = y < 0.0;
        let foot = DVec2::new(from.x + (0.344 + y).max(0.0) * (0.156 / 0.344), y);
        Moves {
            time: t,
            velocity: DVec2::Y * if climbs { 5.0 } else { 0.0 },
            support: if climbs {
                Support::Over
            } else {
                Support::Ground
            },
            normal: if climbs { Vec2::NEG_X } else { Vec2::Y },
            held_at: 0.0,
            ledge: -y as f32,
            ..Moves::standing(foot)
        }
    };
    let mut figure = Figure::new(&moves(0.0), &RIG, &CLIFF);
    for tick in 1..=70 {
        let time = f64::from(tick) * TICK;
        figure.advance(&moves(time), &RIG, &CLIFF);
        let height = -figure.moves().ledge;
        if (-1.1..-0.5).contains(&height) {
            let hand = at(figure.shown(), Bone::HandRight);
            assert!(
                hand.y.abs() < 0.12,
                "{height} m: the hand that pulls is at {hand}"
            );
        }
        for end in (0..2).flat_map(|side| sole(figure.shown(), side)) {
            assert!(
                end.x < 0.05 || end.y > -0.12,
                "{height} m: a boot in the stone, at {end}"
            );
        }
    }
    expect_on(&figure, &CLIFF, "in the end");
}

#[test]
fn a_ladder_is_climbed_in_its_middle() {
    for x in [3.05, 3.45, 3.8] {
        let moves = |t: f64| Moves {
            time: t,
            velocity: DVec2::Y * 4.0,
            support: Support::Ladder,
            ..Moves::standing(DVec2::new(x, 4.0 * t))
        };
        let mut figure = Figure::new(&moves(0.0), &RIG, &CLIFF);
        for tick in 1..=60 {
            figure.advance(&moves(f64::from(tick) * TICK), &RIG, &CLIFF);
            let hips = at(figure.shown(), Bone::Hips).x;
            let middle = (LADDER.0 + LADDER.1) / 2.0;
            assert!(
                (hips - middle).abs() < 0.06,
                "from {x}, tick {tick}: {hips}"
            );
        }
    }
}
