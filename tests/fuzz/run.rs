//! One life: ticks with inputs and edits, every invariant after each of them.

use super::case::{Case, Edit, Life, Ready};
use super::invariants::{outside, tick};
use super::tally::Tally;
use edgewalker::geom::Point;
use edgewalker::mesh::FeatureId;
use edgewalker::motion::{
    Body, EventKind, Mode, Terrain, Trace,
    check::{check, speed},
};
use edgewalker::tune::Motion;
use glam::DVec2;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Which invariant did not hold, and at which tick of the life.
#[derive(Clone, Debug)]
pub struct Failure {
    pub tick: u64,
    pub what: String,
}

impl Failure {
    /// The invariant's name, by which failures are told apart.
    pub fn class(&self) -> &str {
        self.what.split(':').next().unwrap_or("")
    }
}

/// A body below this has fallen out, m.
const BOTTOM: f64 = -60.0;

/// One above this, squeezed out between solids that move, is about to leave the world; no level has features there.
const TOP: f64 = 4000.0;

/// Ticks for which a crushed body is watched: it must not move any more.
const MOURNING: u64 = 5;

/// Lives a life in the meshes of its world, which may be changed by its edits.
pub fn live(case: &Case, ready: &mut Ready, tally: &mut Tally) -> Result<(), Failure> {
    let mut tick = 0;
    // A panic is a failure like any other, which can be cut down.
    let lived = catch_unwind(AssertUnwindSafe(|| ticks(case, ready, tally, &mut tick)));
    let what = match lived {
        Ok(Ok(())) => return Ok(()),
        Ok(Err(what)) => what,
        Err(panic) => {
            let text = panic.downcast_ref::<String>().map(String::as_str);
            let text = text.or(panic.downcast_ref::<&str>().copied());
            format!("panic: {}", text.unwrap_or("of another kind"))
        }
    };
    Err(Failure { tick, what })
}

fn ticks(case: &Case, ready: &mut Ready, tally: &mut Tally, n: &mut u64) -> Result<(), String> {
    let (world, life) = (&case.world, &case.life);
    let time = |n: u64| (life.since + n) as f64 / world.rate;
    ready.park(world);
    let Some(mut body) = born(ready, &world.tuning, life.start, time(0)) else {
        return Ok(());
    };
    tally.begin();
    let (mut trace, mut dead) = (Trace::default(), 0);
    let (mut inputs, mut edits) = (life.inputs.iter().peekable(), life.edits.iter().peekable());
    let inside = |body: &Body| (BOTTOM..TOP).contains(&body.position().y);
    while *n < life.ticks && inside(&body) && dead < MOURNING {
        *n += 1;
        trace.clear();
        let mut anew = *n == 1;
        while let Some((_, edit)) = edits.next_if(|e| e.0 <= *n) {
            change(ready, &world.tuning, &mut body, edit, &mut trace);
            anew = true;
        }
        let terrain = ready.terrain(&world.tuning);
        while let Some(&(_, control)) = inputs.next_if(|i| i.0 <= *n) {
            body.apply(control, &terrain, &mut trace);
            anew = true;
        }
        if let Err(what) = checked(&mut body, time(*n), anew, &terrain, &mut trace) {
            let last: Vec<_> = trace.events.iter().rev().take(8).rev().collect();
            return Err(format!("{what}\n    after {last:?}\n    {body:?}"));
        }
        tally.note(&body, &trace);
        set_out(ready, &world.tuning, &mut body, &mut trace);
        dead += u64::from(matches!(body.mode(), Mode::Crushed(_)));
    }
    Ok(())
}

/// What the body has come to ride in a tick, and has waited for that, begins to go.
fn set_out(ready: &mut Ready, tuning: &Motion, body: &mut Body, trace: &mut Trace) {
    let ridden = trace.events.iter().filter_map(|event| match event.kind {
        EventKind::Mounted(mover) => Some(mover as usize),
        _ => None,
    });
    let ridden: Vec<usize> = ridden.collect();
    for mover in ridden {
        if ready.movers[mover].start.is_none() {
            ready.movers[mover].start = Some(body.time());
            body.take_up_paths(&ready.terrain(tuning), trace);
        }
    }
}

/// A tick, and every invariant after it.
fn checked(
    body: &mut Body,
    to: f64,
    anew: bool,
    terrain: &Terrain,
    trace: &mut Trace,
) -> Result<(), String> {
    tick(body, to, anew, terrain, trace)?;
    if trace.events.iter().any(|e| e.kind == EventKind::Stuck) {
        return Err("cycle: the events did not end".into());
    }
    check(body, terrain, trace)?;
    speed(body, terrain)?;
    outside(body, terrain)
}

/// A body at a free place; none if it is not free.
pub fn born(ready: &Ready, tuning: &Motion, start: DVec2, time: f64) -> Option<Body> {
    let terrain = ready.terrain(tuning);
    let body = Body::spawn(start, time, &terrain).ok()?;
    outside(&body, &terrain).is_ok().then_some(body)
}

/// An edit of the level under a body.
pub fn change(ready: &mut Ready, tuning: &Motion, body: &mut Body, edit: &Edit, trace: &mut Trace) {
    let anchor = body.anchor(&ready.terrain(tuning));
    match edit {
        Edit::Insert(feature) => ready.insert(feature),
        Edit::InsertHere(feature) => {
            let mut feature = feature.clone();
            let here = Point::snap(body.position()).map_or(DVec2::ZERO, Point::metres);
            feature.outline.iter_mut().for_each(|p| *p += here);
            ready.insert(&feature);
        }
        Edit::Remove(id) => ready.remove(*id),
        Edit::RemoveGround => {
            if let Some(id) = ground(ready, body) {
                ready.remove(id);
            }
        }
    }
    body.rehome(&anchor, &ready.terrain(tuning), trace);
}

/// The feature of the level that the body is on.
fn ground(ready: &Ready, body: &Body) -> Option<FeatureId> {
    let mesh = &ready.meshes[body.size() as usize];
    let segment = body.segment().filter(|_| body.carrier().is_none())?;
    Some(mesh.segment(segment).feature)
}

/// A random start for a life that is free in the world at its time.
pub fn free_start(ready: &Ready, case: &Case, mut spot: impl FnMut() -> DVec2) -> DVec2 {
    let Life { since, .. } = case.life;
    let time = since as f64 / case.world.rate;
    loop {
        let at = spot();
        if born(ready, &case.world.tuning, at, time).is_some() {
            return at;
        }
    }
}
