//! One run played by the motion and by the reference, compared after every tick.

use super::body::{Body, Kind, Mode};
use super::double::Vector;
use super::outline::World;
use super::runs::Run;
use edgewalker::geom::expand;
use edgewalker::mesh::Mesh;
use edgewalker::motion::{self, EventKind, Terrain, Trace};

/// Ticks per second.
const RATE: f64 = 60.0;

/// A run ends when a body has fallen below this, m: under all that there is.
const BOTTOM: f64 = -12.0;

/// How far the two may be apart, m: what sixteen digits lose in two seconds of play.
const EXACT: f64 = 1e-9;

/// The same for each shift of a blurred body (see [`Body::blurred`]): a step, and what slow hits make of it in the rest of the
/// run, where a shift in velocity goes on to part the two. In 40 000 runs one exceeded 1e-3, with 4e-3.
const BLURRED: f64 = 1e-2;

/// Velocities may differ by so much per metre, 1/s.
const PER_METRE: f64 = 100.0;

/// What a run showed.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Why the comparison ended before its time.
    pub doubt: Option<&'static str>,
    pub blurred: bool,
    /// Largest differences: position in m, velocity in m/s, event times in s.
    pub errors: [f64; 3],
    /// Events that were compared.
    pub events: usize,
    /// Ticks that were compared, in the air, on ground, on what is too steep, at rest in a V.
    pub ticks: [usize; 4],
}

/// Plays a run twice.
///
/// # Errors
/// The first difference that rounding does not explain.
pub fn play(run: &Run) -> Result<Outcome, String> {
    let expanded = run.outlines.iter().map(|o| expand(o, &run.collider));
    let mesh = Mesh::build(&expanded.collect::<Vec<_>>()).map_err(|e| e.to_string())?;
    let terrain = Terrain::new(&mesh, &mesh, &run.tuning);
    let world = World::new(&run.outlines, &run.collider);
    let start = Vector::new(run.start.x, run.start.y);
    let mut slow = Body::new(&world, &run.tuning, start);
    let mut body = motion::Body::spawn(run.start, 0.0, &terrain).map_err(|e| e.to_string())?;
    let (mut trace, mut outcome) = (Trace::default(), Outcome::default());
    for (tick, &control) in run.controls.iter().enumerate() {
        trace.clear();
        slow.events.clear();
        let to = (tick + 1) as f64 / RATE;
        slow.apply(control);
        slow.advance(to);
        outcome.doubt = slow.doubt;
        if slow.doubt.is_some() || slow.position().to_f64().y < BOTTOM {
            break;
        }
        body.apply(control, &terrain, &mut trace);
        body.advance(to, &terrain, &mut trace);
        outcome
            .note(&slow, &body, &trace)
            .map_err(|e| format!("tick {tick}, {control:?}: {e}, after {:?}", trace.events))?;
    }
    Ok(outcome)
}

impl Outcome {
    /// Compares the two after a tick.
    fn note(&mut self, slow: &Body, body: &motion::Body, trace: &Trace) -> Result<(), String> {
        self.blurred = slow.blurred > 0;
        let tolerance = EXACT.max(BLURRED * f64::from(slow.blurred));
        let (p, v) = (slow.position().to_f64(), slow.velocity().to_f64());
        let position = (body.position() - p).length();
        let velocity = (body.velocity() - v).length();
        let [mode, other] = [mode(slow), mode_of(body.mode())];
        if mode != other || position > tolerance || velocity > PER_METRE * tolerance {
            let (q, w, is) = (body.position(), body.velocity(), body.mode());
            return Err(format!(
                "at {q} going {w}, {is:?}; should be at {p} going {v}, {:?}",
                slow.mode
            ));
        }
        let events: Vec<(f64, Kind)> = trace.events.iter().filter_map(kind).collect();
        let pairs = || events.iter().zip(&slow.events);
        let late = pairs().map(|(a, b)| (a.0 - b.0).abs()).fold(0.0, f64::max);
        let same = events.len() == slow.events.len() && pairs().all(|(a, b)| a.1 == b.1);
        if !same || late > tolerance {
            return Err(format!("{events:?}, should be {:?}", slow.events));
        }
        self.events += events.len();
        self.ticks[mode] += 1;
        for (largest, error) in self.errors.iter_mut().zip([position, velocity, late]) {
            *largest = largest.max(error);
        }
        Ok(())
    }
}

/// Index of the mode in [`Outcome::ticks`].
fn mode(slow: &Body) -> usize {
    match slow.mode {
        Mode::Air { .. } => 0,
        Mode::On { side, .. } if slow.walkable(side) => 1,
        Mode::On { .. } => 2,
        Mode::Rest { .. } => 3,
    }
}

fn mode_of(mode: &motion::Mode) -> usize {
    match mode {
        motion::Mode::Air(_) => 0,
        motion::Mode::Surface(on) if on.walkable => 1,
        motion::Mode::Surface(_) => 2,
        motion::Mode::Wedge(_) => 3,
        _ => 4,
    }
}

fn kind(event: &motion::Event) -> Option<(f64, Kind)> {
    let kind = match event.kind {
        EventKind::Jumped => Kind::Jumped,
        EventKind::Left => Kind::Left,
        EventKind::Landed(_) => Kind::Landed,
        _ => return None,
    };
    Some((event.time, kind))
}
