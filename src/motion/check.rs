//! The invariants of a body that can be read off its state; tests and the fuzzer assert them after every step.

use super::beside::Beside;
use super::body::{Body, Mode, Next, Size, Trace};
use super::grip::Grip;
use super::terrain::{Ground, Region, Terrain};
use super::vertex::JOINT_STEPS;
use crate::geom::STEP;
use crate::mesh::{EdgeId, FeatureId, SegmentId};
use glam::DVec2;

/// Checks I1 (the place is free, and an airborne position is in it), I2 (the surface's edge exists, blocks, carries the
/// feature edge, the parameter is on it, the road is its own, and a limit of the speed lies ahead; who holds on is upright,
/// unless it climbs over a ledge, on a wall, and at rest if it hangs), I3 (all numbers are
/// finite) and I5 (the events of the step are bounded).
///
/// # Errors
/// The first invariant that does not hold, with its numbers.
pub fn check(body: &Body, terrain: &Terrain, trace: &Trace) -> Result<(), String> {
    let mesh = body.ground(terrain);
    let (p, v) = (body.position(), body.velocity());
    if !(p.is_finite() && v.is_finite() && body.time().is_finite()) {
        return Err(format!(
            "I3: position {p}, velocity {v}, time {}",
            body.time()
        ));
    }
    let crushed = matches!(body.mode(), Mode::Crushed(_));
    if !crushed && mesh.is_solid(body.face(&mesh)) {
        return Err(format!("I1: in a solid face at {p}"));
    }
    match body.mode() {
        Mode::Air(_) => in_face(body, mesh)?,
        Mode::Surface(_) => on_edge(body, mesh).and_then(|()| holds_on(body, mesh))?,
        Mode::Wedge(_) | Mode::Crushed(_) => {}
    }
    in_regions(body, terrain)?;
    body.beside
        .iter()
        .try_for_each(|b| beside(body, b, terrain))?;
    let bound = 64 + trace.crossed + trace.passed + 2 * trace.touched;
    if trace.events.len() as u64 > bound {
        return Err(format!(
            "I5: {} events where {bound} are allowed, the last ones {:?}",
            trace.events.len(),
            &trace.events[trace.events.len() - 8..]
        ));
    }
    Ok(())
}

/// The fastest that anything makes a body, m/s: its own run on a belt, a fall along the flattest slope that is too steep, or a
/// squeeze, with a jump on top, and what carries and pushes it. Where slopes pull a walker, or a solid speeds up for ever, there is
/// no such speed.
pub fn fastest(terrain: &Terrain) -> f64 {
    let t = terrain.tuning;
    if t.slope_gravity > 0.0 {
        return f64::INFINITY;
    }
    let belts = terrain.traits.iter().map(|traits| traits.conveyor.abs());
    let run = t.run_speed.max(t.crouch_speed) * (1.0 + t.slope_speed) + belts.fold(0.0, f64::max);
    let steep = t.max_slope / (1.0 + t.max_slope * t.max_slope).sqrt();
    let fall = t.fall_speed.max(t.fast_fall_speed) / steep;
    let jump = t.jump_speed.max(t.wall_jump_up + t.wall_jump_out);
    let climb = t.climb_speed.max(t.ledge_climb_speed);
    let movers = terrain.movers.iter().map(|mover| mover.path.fastest());
    let own = run.max(fall).max(t.squeeze_speed).max(climb);
    own + jump + 2.0 * movers.fold(0.0, f64::max)
}

/// Checks that a body is not faster than anything makes it.
///
/// # Errors
/// If it is, with both speeds.
pub fn speed(body: &Body, terrain: &Terrain) -> Result<(), String> {
    let (speed, bound) = (body.velocity().length(), fastest(terrain));
    match speed <= bound * (1.0 + 1e-9) {
        true => Ok(()),
        false => Err(format!("Speed: {speed} m/s where {bound} are the most")),
    }
}

/// Checks that a piece of motion holds at a time of it before the next event: a body that looks again there what holds it, and
/// chooses its law anew, goes on as it was going to. So every condition that can change does so at an event.
///
/// # Errors
/// What would change, with its numbers.
pub fn steady(body: &Body, at: f64, terrain: &Terrain) -> Result<(), String> {
    let mut later = body.clone();
    let mut trace = Trace::default();
    later.time = at;
    later.rebase();
    // What is within a step is met at once where anything else happens: there the next event may begin, and the last one last.
    let speeds = body.beside.iter().map(|b| later.seen_from(b).1.length());
    let fastest = match body.next {
        Some((_, Next::Beside(i))) => later.seen_from(&body.beside[i as usize]).1.length(),
        Some((_, Next::Hit(..) | Next::Vertex | Next::Grab(_) | Next::Clear(Some(_)))) => {
            later.local_velocity().length()
        }
        _ => speeds.fold(later.velocity().length(), f64::max),
    };
    let span = (body.next_at().unwrap_or(f64::INFINITY) - at).min(at - body.time());
    let near = (0..body.beside.len()).any(|i| later.runs_into(i, terrain).is_some());
    if near || fastest * span <= f64::from(2 * JOINT_STEPS) * STEP {
        return Ok(());
    }
    later.refresh(terrain, &mut trace);
    let told = |what: &str| {
        let (mode, then) = (body.mode(), later.mode());
        Err(format!(
            "Guard: {what} at {at}, in the middle of a piece: {mode:?} becomes {then:?}"
        ))
    };
    // From ground a ladder is taken hold of where a key, or the way, leads into it.
    let takes_hold = body.supported() && later.climbing();
    if let Some(event) = trace.events.first().filter(|_| !takes_hold) {
        return told(&format!("{:?}", event.kind));
    }
    let presses = |body: &Body| -> Vec<_> {
        let entries = body.beside.iter();
        entries
            .map(|b| (b.mover(), b.contact.map(|c| c.segment)))
            .collect()
    };
    if takes_hold {
        return Ok(());
    }
    if body.carrier() != later.carrier() || presses(body) != presses(&later) {
        return told("another contact");
    }
    let near = |a: DVec2, b: DVec2| (a - b).length() <= 1e-6 * (1.0 + a.length());
    let same = match (body.mode(), later.mode()) {
        (Mode::Air(a), Mode::Air(b)) => near(a.accel, b.accel),
        (Mode::Surface(a), Mode::Surface(b)) => {
            a.segment == b.segment
                && a.grip == b.grip
                && (a.accel - b.accel).abs() <= 1e-6 * (1.0 + a.accel.abs())
        }
        (Mode::Wedge(_), Mode::Wedge(_)) | (Mode::Crushed(_), Mode::Crushed(_)) => true,
        _ => false,
    };
    match same {
        true => Ok(()),
        false => told("another law"),
    }
}

/// An airborne position is at most 2 ulp outside its face. Rounding may have put a piece of a cut feature edge up to half a
/// step per axis before that edge: there the edge itself is the bound, and a body that has just left it starts from it. Behind
/// such a piece a body may be past the end of it, and so as far beyond the side of the face that begins there.
fn in_face(body: &Body, mesh: Ground) -> Result<(), String> {
    let Mode::Air(air) = body.mode() else {
        return Ok(());
    };
    let p = body.local_position();
    // Time is rounded, and in the frame of a moving solid, where its place may have been decided, the body moves faster.
    let seen = body.beside.iter().map(|b| body.seen_from(b).1.length());
    let slack = body.rounding_at(seen.fold(body.velocity().length(), f64::max));
    let touches = |s: SegmentId| air.touching.contains(&Some(s)) || air.through == Some(s);
    let cut = |&s: &SegmentId| mesh.chain(s).len() > 2;
    let touches_cut = air.touching.iter().chain([&air.through]).flatten().any(cut);
    let outside = |e: EdgeId| {
        let ends = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres());
        let along = ends[1] - ends[0];
        -along.perp_dot(p - ends[0]) / along.length()
    };
    let before_feature_edge = |s| mesh.track(s).height(p, p, p).0 >= -slack;
    let displaced =
        |e: EdgeId| mesh.blocks(e) && mesh.facing(e).any(|s| touches(s) || before_feature_edge(s));
    let sides = mesh.sides(air.face);
    let behind_piece = sides
        .into_iter()
        .any(|e| outside(e) > slack && displaced(e));
    for e in sides {
        let may = displaced(e) || touches_cut || !mesh.blocks(e) && behind_piece;
        let outside = outside(e);
        if outside > slack && !(may && outside <= STEP) {
            return Err(format!(
                "I1: {outside:e} m outside its face at {p}, {slack:e} allowed"
            ));
        }
    }
    Ok(())
}

/// The regions that have been told are those around the face, in every frame; who climbs is on a ladder, and no end of one is in his way that
/// is not under him.
fn in_regions(body: &Body, terrain: &Terrain) -> Result<(), String> {
    let told = body.regions();
    let region = |f: &FeatureId| terrain.traits_of(*f).region;
    let around = body.regions_around(terrain);
    if around != told && !matches!(body.mode(), Mode::Crushed(_)) {
        return Err(format!("I1: in regions {around:?}, told of {told:?}"));
    }
    if body.climbing() && !body.is_mounting() && !told.iter().any(|f| region(f) == Region::Ladder) {
        return Err("I1: climbs outside of ladders".into());
    }
    if !body.is_at_home() {
        return Err(format!("I1: in the air of {:?}", body.carrier()));
    }
    Ok(())
}

/// In every other frame the place is free too, and the position in it but for rounding and the lips that are passed over.
fn beside(body: &Body, entry: &Beside, terrain: &Terrain) -> Result<(), String> {
    let mesh = entry.ground(body.size(), terrain);
    let (p, _) = body.seen_from(entry);
    let face = entry.flight.face;
    if mesh.is_solid(face) {
        return Err(format!("I1: in a solid face of {:?} at {p}", entry.mover()));
    }
    if mesh.locate(p, None).is_none() {
        return Ok(()); // beyond the border of a moving solid's small world is nothing
    }
    let slack = body.rounding() + f64::from(2 * JOINT_STEPS) * STEP;
    for e in mesh.sides(face) {
        let ends = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres());
        let along = ends[1] - ends[0];
        let outside = -along.perp_dot(p - ends[0]) / along.length();
        if outside > slack {
            let mover = entry.mover();
            return Err(format!(
                "I1: {outside:e} m outside its face of {mover:?} at {p}"
            ));
        }
    }
    Ok(())
}

fn on_edge(body: &Body, mesh: Ground) -> Result<(), String> {
    let Mode::Surface(on) = body.mode() else {
        return Ok(());
    };
    if !mesh.blocks(on.edge) {
        return Err("I2: the edge under the body does not block".into());
    }
    if !mesh.facing(on.edge).any(|s| s == on.segment) {
        return Err("I2: the feature edge does not run along the edge under the body".into());
    }
    if !on.track.same_line(&mesh.track(on.segment)) {
        return Err("I2: the road under the body is not that of its feature edge".into());
    }
    if on
        .limit
        .is_some_and(|(at, until)| at < on.t0 || (until - on.u0) * on.accel < 0.0)
    {
        return Err(format!(
            "I2: the speed never reaches its limit {:?}",
            on.limit
        ));
    }
    let s = on.parameter(body.time());
    let ends =
        [mesh.origin(on.edge), mesh.dest(on.edge)].map(|v| on.track.parameter_of(mesh.point(v)));
    let slack = body.rounding()
        + f64::from(JOINT_STEPS) * STEP * f64::from(u8::from(mesh.chain(on.segment).len() > 2));
    if s < ends[0].min(ends[1]) - slack || s > ends[0].max(ends[1]) + slack {
        return Err(format!("I2: parameter {s} is not on the edge {ends:?}"));
    }
    Ok(())
}

/// What a grip promises.
fn holds_on(body: &Body, mesh: Ground) -> Result<(), String> {
    let Mode::Surface(on) = body.mode() else {
        return Ok(());
    };
    let climbs = on.speed(body.time()) * on.track.tangent.y;
    let broken = match on.grip {
        Grip::None => false,
        Grip::Ledge => climbs != 0.0 || on.accel != 0.0,
        Grip::Over => climbs < 0.0,
        Grip::Wall => false,
    };
    let on_wall = mesh.is_wall(on.segment);
    let stoops = body.size() != Size::Stand && on.grip != Grip::Over;
    if broken || on.grip != Grip::None && (stoops || !on_wall) {
        return Err(format!("I2: cannot hold on like this: {on:?}"));
    }
    Ok(())
}
