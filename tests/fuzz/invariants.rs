//! The invariants that [`check`](edgewalker::motion::check::check) cannot read off a state: those of events, of time, and of
//! places judged from outside.

use super::dice::Dice;
use edgewalker::geom::STEP;
use edgewalker::mesh::{Mesh, Place};
use edgewalker::motion::check::steady;
use edgewalker::motion::vertex::JOINT_STEPS;
use edgewalker::motion::{Body, Event, EventKind, Mode, Terrain, Trace};
use edgewalker::tune::Motion;
use glam::DVec2;

/// So many events in a tick count as endless: those that creep on by a unit in the last place of the time would take hours.
const ENDLESS: u32 = 1_000_000;

/// At so many random instants of each piece every condition must be as at its start.
const INSTANTS: u32 = 16;

/// As much of a piece as is looked at, s.
const HORIZON: f64 = 2.0;

/// Every condition is asked again inside the piece that has begun.
pub fn guards(body: &Body, terrain: &Terrain) -> Result<(), String> {
    let now = body.time();
    let end = body.next_at().unwrap_or(f64::INFINITY).min(now + HORIZON);
    // Shorter pieces have no inside, as times are rounded.
    if end - now < 1e-7 {
        return Ok(());
    }
    let mut dice = Dice::new(now.to_bits());
    for _ in 0..INSTANTS {
        let share = 0.001 + 0.998 * dice.unit();
        steady(body, now + share * (end - now), terrain)?;
    }
    Ok(())
}

/// A tick, event by event: I4, I6, and the guards of each new piece. `anew`: one has begun already.
pub fn tick(
    body: &mut Body,
    to: f64,
    anew: bool,
    terrain: &Terrain,
    trace: &mut Trace,
) -> Result<(), String> {
    let mut events_left = ENDLESS;
    if anew {
        guards(body, terrain)?;
    }
    while let Some(at) = body.next_at().filter(|&at| at <= to) {
        events_left -= 1;
        if events_left == 0 {
            return Err(format!("I5: endless events, at {at}"));
        }
        let before = body.clone();
        let (events, touched) = (trace.events.len(), trace.touched);
        body.advance(at, terrain, trace);
        let met = trace.touched > touched;
        event(&before, body, met, &trace.events[events..], terrain)?;
        if trace.events.len() > events || met {
            guards(body, terrain)?;
        }
    }
    let promised = body.forecast(to);
    body.advance(to, terrain, trace);
    if body.time() != to {
        return Err(format!("I4: {} s left", to - body.time()));
    }
    if promised != (body.position(), body.velocity()) {
        return Err(format!("I6: {promised:?} was to come without an event"));
    }
    Ok(())
}

/// I6: no event lifts or speeds up a body, or moves it further than a joint may, apart from those that are there for it.
/// `met`: it met something of another frame.
fn event(
    before: &Body,
    body: &Body,
    met: bool,
    news: &[Event],
    terrain: &Terrain,
) -> Result<(), String> {
    let (p, v) = before.forecast(body.time());
    let (q, w) = (body.position(), body.velocity());
    let joint = f64::from(2 * JOINT_STEPS) * STEP * (1 + news.len()) as f64;
    let moves: f64 = news.iter().map(|e| may_move(e.kind, terrain.tuning)).sum();
    if (q - p).length() > joint + moves {
        return Err(format!(
            "I6: an event moved the body by {} at {p}: {news:?}",
            q - p
        ));
    }
    let free = met
        || news.iter().any(|e| may_speed_up(e.kind))
        || [before, body].iter().any(|b| is_carried(b, terrain));
    if !free && w.length() > v.length() * (1.0 + 1e-12) + 1e-12 + late(before) {
        return Err(format!(
            "I6: an event sped the body up from {v} to {w} at {p}: {news:?}"
        ));
    }
    Ok(())
}

/// What the rounding of an event's time, half a unit in the last place, makes of a speed: at a limit the speed becomes exactly
/// the limit, though the acceleration has ended by so much too early. No mode accelerates by more than this.
fn late(body: &Body) -> f64 {
    const LARGEST_ACCELERATION: f64 = 1000.0;
    LARGEST_ACCELERATION * f64::EPSILON * body.time()
}

/// How far an event may move a body, m.
fn may_move(kind: EventKind, t: &Motion) -> f64 {
    // Along a slope as steep as may be walked, set down or stepped up, or up the flank of a foot.
    let sideways = |h: f64| h * (1.0 + 1.0 / t.max_slope.max(0.1));
    match kind {
        EventKind::SteppedUp(h) if h <= t.step_up + 2.0 * STEP => sideways(h),
        EventKind::Snapped(h) if h <= t.floor_snap + 2.0 * STEP => sideways(h),
        EventKind::Corrected(h) if h <= t.corner_correction.max(t.ledge_correction) + STEP => {
            sideways(h)
        }
        EventKind::Grabbed => sideways(t.ledge_magnet) + STEP,
        EventKind::Embedded(h) => h + STEP,
        _ => 0.0,
    }
}

fn may_speed_up(kind: EventKind) -> bool {
    matches!(
        kind,
        EventKind::Jumped
            | EventKind::WallJumped
            | EventKind::Climbed
            | EventKind::Embedded(_)
            | EventKind::Boarded(_)
            | EventKind::Pushed(_)
            | EventKind::Node(_)
    )
}

/// On or against what moves: a moving solid or a belt. There speeds count in its frame.
fn is_carried(body: &Body, terrain: &Terrain) -> bool {
    let ground = terrain.ground_under(body.carrier(), body.size());
    let belt = |s| terrain.traits_of(ground.segment(s).feature).conveyor != 0.0;
    let moved = body.carrier().is_some() || body.pushed_by().is_some();
    moved || body.segment().is_some_and(belt)
}

/// I1 from outside: the position is in no solid, of the level or moving, but for rounding.
pub fn outside(body: &Body, terrain: &Terrain) -> Result<(), String> {
    if matches!(body.mode(), Mode::Crushed(_)) {
        return Ok(());
    }
    let p = body.position();
    if is_deep(terrain.mesh(body.size()), p) {
        return Err(format!("I1: {p} is in a solid of the level"));
    }
    for (i, mover) in terrain.movers.iter().enumerate() {
        let there = p - mover.piece_at(body.time()).offset(body.time());
        if is_deep(mover.mesh(body.size()), there) {
            return Err(format!("I1: {p} is in moving solid {i}"));
        }
    }
    Ok(())
}

/// In a solid, and further from everything free than the rounding of a corner: a search through the faces around.
fn is_deep(mesh: &Mesh, p: DVec2) -> bool {
    let Some(Place::Face(start)) = mesh.locate(p, None) else {
        return false;
    };
    let (mut stack, mut seen) = (vec![start], vec![start]);
    while let Some(face) = stack.pop() {
        if !mesh.is_solid(face) {
            return false;
        }
        for e in mesh.sides(face) {
            let ends = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres());
            let beyond = mesh.left(mesh.sym(e)).filter(|f| !seen.contains(f));
            if let Some(f) = beyond.filter(|_| distance(p, ends) <= 2.0 * STEP) {
                stack.push(f);
                seen.push(f);
            }
        }
    }
    true
}

/// From a point to a segment, m.
fn distance(p: DVec2, [a, b]: [DVec2; 2]) -> f64 {
    let along = b - a;
    let share = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (p - a - along * share).length()
}
