//! Where the figure looks: with its whole body to one side or the other, with its head at what is near.

use super::moves::Moves;
use super::state::Kind;
use glam::{DVec2, Vec2};
use std::f32::consts::{FRAC_PI_2, PI, TAU};

/// How far he is turned towards the viewer, standing and running, in radians.
const TURNED: (f32, f32) = (0.55, 0.22);
/// The farthest that he looks up or down, in radians.
const GAZE: f32 = 0.6;
/// Height of his eyes, m.
const EYES: f64 = 1.45;

/// The turn about the upright axis at which he looks where he shall, nearest to the present one. Between right and left
/// he turns by way of the viewer; on a ladder he looks into the picture.
pub fn facing(kind: Kind, moves: &Moves, run: f32, now: f32) -> f32 {
    if kind == Kind::Ladder {
        return FRAC_PI_2 + TAU * ((now - FRAC_PI_2) / TAU).round();
    }
    let aside = match kind {
        Kind::Go | Kind::Turn | Kind::Roll => TURNED.0 + (TURNED.1 - TURNED.0) * run,
        Kind::Air | Kind::Crawl => TURNED.1,
        Kind::WallSlide | Kind::Hang | Kind::ClimbOver | Kind::ClimbWall => 0.0,
        _ => TURNED.0,
    };
    let goal = if moves.side() > 0.0 {
        -aside
    } else {
        aside - PI
    };
    // Half a turn has no nearer way: then it is the one through the viewer's side, between -pi and 0.
    let turns = (now - goal) / TAU;
    goal + TAU * (turns.abs() - 0.05).round().copysign(turns)
}

/// Where he looks: to the side and up, against where his chest does, in radians.
pub fn gaze(kind: Kind, moves: &Moves) -> Vec2 {
    if matches!(
        kind,
        Kind::Roll | Kind::Die | Kind::GetUp | Kind::Ladder | Kind::ClimbWall | Kind::ClimbOver
    ) {
        return Vec2::ZERO;
    }
    if moves.look != 0.0 {
        return Vec2::new(0.0, moves.look * GAZE);
    }
    let Some(sight) = moves.sight else {
        return Vec2::ZERO;
    };
    let way = sight - moves.foot - DVec2::new(0.0, EYES);
    let ahead = way.x as f32 * moves.side();
    if ahead < 0.3 {
        return Vec2::ZERO;
    }
    // Along the plane of play, though the body is turned to the viewer.
    let aside = TURNED.0 * 0.8 * moves.side();
    Vec2::new(aside, (way.y as f32).atan2(ahead).clamp(-GAZE, GAZE))
}
