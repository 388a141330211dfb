//! A body that comes from outside, out of a text that anybody may have changed: whether everything that it says of itself can be
//! true in its terrain, before it is asked to move.

use super::beside::Beside;
use super::body::{Air, Body, Mode, Next, Surface, Trace};
use super::check::check;
use super::contact::Contact;
use super::mover::{Piece, Ride};
use super::terrain::{Ground, Terrain};
use crate::mesh::{EdgeId, FaceId, Mesh, SegmentId};
use glam::DVec2;

/// No number of a body is larger: not the speed of the fastest mover, not an hour in seconds.
const LARGEST: f64 = 1e10;

/// How far apart two ways to work out one place may be, m; or times of one event, s; or two speeds, m/s, as a share of them.
const APART: f64 = 1e-3;

/// What is wrong, in words.
type Verdict = Result<(), String>;

fn require(ok: bool, what: impl Fn() -> String) -> Verdict {
    if ok { Ok(()) } else { Err(what()) }
}

/// Checks a body that shall go on at a time in a terrain.
///
/// # Errors
/// What cannot be true of it, with its numbers.
pub fn vet(body: &Body, now: f64, terrain: &Terrain) -> Verdict {
    let numbers = numbers(body);
    require(
        numbers.iter().all(|n| n.is_finite() && n.abs() <= LARGEST),
        || format!("one of its numbers is none: {numbers:?}"),
    )?;
    require(body.time == now, || {
        format!("its time is {}, that of the world {now}", body.time)
    })?;
    frames(body, terrain)?;
    places(body, terrain)?;
    body.beside
        .iter()
        .try_for_each(|b| vet_beside(body, b, terrain))?;
    check(body, terrain, &Trace::default())?;
    next(body, terrain)
}

/// Every number that it is made of.
fn numbers(body: &Body) -> Vec<f64> {
    let mut all = vec![body.time, body.control.run];
    let mut add = |more: &[f64]| all.extend(more);
    match &body.mode {
        Mode::Air(air) => air.numbers(&mut add),
        Mode::Surface(on) => {
            add(&[on.t0, on.s0, on.u0, on.accel, on.since, on.against]);
            on.limit.iter().for_each(|l| add(&[l.0, l.1]));
        }
        Mode::Wedge(wedge) => add(&wedge.at.to_array()),
        Mode::Crushed(crushed) => add(&crushed.at.to_array()),
    }
    let timers = [body.pressed_at, body.released_at, body.coyote_from];
    timers.into_iter().flatten().for_each(|t| add(&[t]));
    body.rise.iter().for_each(|rise| add(&rise.numbers()));
    body.lift.iter().for_each(|(at, v)| add(&[*at, v.x, v.y]));
    body.off_wall.iter().for_each(|w| add(&[w.at, w.away]));
    body.next.iter().for_each(|n| add(&[n.0]));
    for beside in &body.beside {
        beside.flight.numbers(&mut add);
        beside.next.iter().for_each(|n| add(&[n.0]));
        beside.of.iter().for_each(|piece| piece.numbers(&mut add));
    }
    all
}

impl Air {
    fn numbers(&self, add: &mut impl FnMut(&[f64])) {
        add(&[self.t0, self.since, self.grain]);
        for v in [self.p0, self.v0, self.accel] {
            add(&v.to_array());
        }
        let limits = self.limits.iter().flatten();
        limits.for_each(|l| add(&[l.0, l.1]));
        self.lock.iter().for_each(|l| add(&[l.until, l.run]));
    }
}

impl Piece {
    fn numbers(&self, add: &mut impl FnMut(&[f64])) {
        add(&[self.t0]);
        for v in [self.p0, self.v0, self.accel] {
            add(&v.to_array());
        }
    }
}

/// Every moving solid is there once, and where its path says.
fn frames(body: &Body, terrain: &Terrain) -> Verdict {
    let count = terrain.movers.len();
    let rides = body.beside.iter().map(|b| b.frame).chain([body.frame]);
    let is_crushed = matches!(body.mode, Mode::Crushed(_));
    let mut seen = vec![false; count];
    let mut levels = 0;
    for ride in rides {
        let Some(ride) = ride else {
            levels += 1;
            continue;
        };
        let known = seen.get_mut(ride.mover as usize);
        let is_new = known.is_some_and(|seen| !std::mem::replace(seen, true));
        require(is_new, || format!("mover {} of {count}", ride.mover))?;
        let now = Ride::at(ride.mover, body.time, terrain.movers);
        require(ride == now, || {
            format!("its ride is {ride:?} where the path says {now:?}")
        })?;
    }
    let all = seen.iter().all(|&seen| seen) || is_crushed && body.beside.is_empty();
    require(all && levels == 1, || {
        format!("it follows {seen:?} of the movers")
    })
}

fn is_edge(mesh: &Mesh, e: EdgeId) -> bool {
    mesh.edges().any(|known| known == e || mesh.sym(known) == e)
}

fn is_segment(mesh: &Mesh, s: SegmentId) -> bool {
    let mut all = mesh.features().flat_map(|f| mesh.segments_of(f));
    all.any(|&known| known == s)
}

fn some_segments(mesh: &Mesh, segments: [Option<SegmentId>; 3]) -> Verdict {
    let mut all = segments.into_iter().flatten();
    require(all.all(|s| is_segment(mesh, s)), || {
        format!("feature edges {segments:?} are not there")
    })
}

fn face(mesh: &Mesh, f: FaceId) -> Verdict {
    require(mesh.is_face(f), || format!("{f:?} is not there"))
}

/// What it names of the meshes is there, in its own frame and in those that it has met.
fn places(body: &Body, terrain: &Terrain) -> Verdict {
    let mesh = body.ground(terrain);
    let past = |from: f64, since: f64| from <= body.time && (0.0..=LARGEST).contains(&since);
    match &body.mode {
        Mode::Air(air) => {
            face(&mesh, air.face)?;
            let [a, b] = air.touching;
            some_segments(&mesh, [a, b, air.through])?;
            require(past(air.t0, air.since), || {
                "its flight is yet to begin".into()
            })?;
        }
        Mode::Surface(on) => {
            surface(on, mesh)?;
            require(past(on.t0, on.since), || "its walk is yet to begin".into())?;
        }
        Mode::Wedge(wedge) => face(&mesh, wedge.face)?,
        Mode::Crushed(crushed) => face(terrain.mesh(body.size), crushed.face)?,
    }
    let known = |id: &u32| (*id as usize) < terrain.traits.len();
    require(body.regions.iter().all(known), || {
        format!("regions {:?} are not there", body.regions)
    })?;
    let mover = |m: u32| (m as usize) < terrain.movers.len();
    let named = body.ladder.into_iter().chain(body.rides);
    require(named.into_iter().all(mover), || {
        format!("ladder of {:?}, riding {:?}", body.ladder, body.rides)
    })?;
    for meeting in &body.meetings {
        let mover = meeting.mover();
        let there = mover.is_none_or(|m| (m as usize) < terrain.movers.len());
        let ground = there.then(|| terrain.ground_under(mover, meeting.size()));
        let known = ground.is_some_and(|mesh| is_segment(&mesh, meeting.segment()));
        require(known, || format!("{meeting:?} is not there"))?;
    }
    Ok(())
}

fn surface(on: &Surface, mesh: Ground) -> Verdict {
    some_segments(&mesh, [Some(on.segment), None, None])?;
    let known = is_edge(&mesh, on.edge) && mesh.left(on.edge).is_some();
    require(known, || format!("{:?} is not there", on.edge))?;
    let track = mesh.track(on.segment);
    // Another feature edge on the same line has the same road.
    require(on.track == track, || {
        format!("{:?} is not {track:?}", on.track)
    })
}

/// Its place in another frame, and what presses on it from there.
fn vet_beside(body: &Body, entry: &Beside, terrain: &Terrain) -> Verdict {
    let mesh = entry.ground(body.size, terrain);
    let (flight, now) = (&entry.flight, body.time);
    face(&mesh, flight.face)?;
    let [a, b] = flight.touching;
    some_segments(&mesh, [a, b, flight.through])?;
    if let Some(Contact {
        segment,
        track,
        edge,
    }) = entry.contact
    {
        let known = is_segment(&mesh, segment) && is_edge(&mesh, edge) && mesh.blocks(edge);
        require(known && track == mesh.track(segment), || {
            format!("{:?} presses where it is not", entry.contact)
        })?;
    }
    let (p, v) = body.seen_from(entry);
    let near = |a: DVec2, b: DVec2| (a - b).length() <= APART * (1.0 + b.length());
    let follows = near(flight.position(now), p) && near(flight.velocity(now), v);
    require(follows && flight.since >= 0.0, || {
        format!("it follows {:?} from another place", entry.mover())
    })
}

/// What it says will happen next is what follows from where it is.
fn next(body: &Body, terrain: &Terrain) -> Verdict {
    let mut again = body.clone();
    for beside in &mut again.beside {
        beside.plan(body.time, body.size, terrain);
    }
    again.schedule(terrain);
    let same = |a: Option<(f64, Next)>, b: Option<(f64, Next)>| match (a, b) {
        (Some((at, _)), Some((then, _))) => (at - then).abs() <= APART,
        (a, b) => a.is_none() && b.is_none(),
    };
    let others = body.beside.iter().zip(&again.beside);
    let all =
        same(body.next, again.next) && others.fold(true, |all, (a, b)| all && a.next == b.next);
    require(
        all && body.next.map(|n| n.1) == again.next.map(|n| n.1),
        || format!("next is {:?}, not {:?}", again.next, body.next),
    )
}
