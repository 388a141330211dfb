//! The recorded run of the quarry: our own mover plays it, the peers are led along it.
//!
//! No peer has the game's rules. So each is put where the run is, is given the accelerations that act there and the changes of
//! speed that jumps and inputs make, and moves for some time by itself; then it is put back onto the run.

use crate::movers::walker::{Rule, Slide, integrate};
use edgewalker::game::{Replay, Shape, Stage};
use edgewalker::geom::Collider;
use edgewalker::level;
use edgewalker::motion::grip::Grip;
use edgewalker::motion::{Body, Control, Mode, Size, Terrain, Trace};
use glam::DVec2;

/// Inputs per second of the recording.
pub const RATE: f64 = 120.0;

/// The level, and what was played in it.
pub struct Quarry {
    pub stage: Stage,
    pub replay: Replay,
    pub controls: Vec<Control>,
    pub solids: Vec<Vec<DVec2>>,
}

/// What the peers are told of a moment.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    pub at: DVec2,
    pub velocity: DVec2,
    /// What the input of this moment has changed about the velocity at once.
    pub kick: DVec2,
    pub accel: DVec2,
    /// Upright, and not hanging from anything: what the peers can do too.
    pub plain: bool,
}

impl Quarry {
    pub fn load() -> Quarry {
        let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../");
        let level = level::load(format!("{root}levels/dev/crossing.ron").as_ref())
            .expect("a level of ours");
        let text = std::fs::read_to_string(format!("{root}tests/golden/crossing.replay.ron"));
        let replay = Replay::parse(&text.expect("the recorded run")).expect("the recorded run");
        let counter_clockwise = |outline: &Vec<DVec2>| {
            let n = outline.len();
            let area: f64 = (0..n)
                .map(|i| outline[i].perp_dot(outline[(i + 1) % n]))
                .sum();
            let mut outline = outline.clone();
            if area < 0.0 {
                outline.reverse();
            }
            outline
        };
        Quarry {
            solids: level
                .features
                .iter()
                .map(|f| counter_clockwise(&f.outline))
                .collect(),
            controls: replay.iter().map(|input| input.control()).collect(),
            stage: Stage::build(level).expect("a level of ours"),
            replay,
        }
    }

    pub fn seconds(&self) -> f64 {
        self.controls.len() as f64 / RATE
    }

    /// Plays the run with so many ticks per second, each input at its time, and shows the body at the end of each tick. The
    /// events and the faces crossed.
    pub fn play(&self, rate: f64, mut see: impl FnMut(&Body)) -> (usize, usize) {
        let land = self.stage.land(&Shape::hero()).expect("the hero's meshes");
        let terrain = land.terrain(&self.stage, &self.replay.tuning.motion);
        let (mut trace, mut counts) = (Trace::default(), (0, 0));
        let mut body = Body::spawn(self.stage.level.start, 0.0, &terrain).expect("a free start");
        let mut next = 0;
        for tick in 1..=(self.seconds() * rate).round() as u32 {
            let end = f64::from(tick) / rate;
            while next < self.controls.len() && next as f64 / RATE < end {
                body.advance(next as f64 / RATE, &terrain, &mut trace);
                body.apply(self.controls[next], &terrain, &mut trace);
                next += 1;
            }
            body.advance(end, &terrain, &mut trace);
            counts = (
                counts.0 + trace.events.len(),
                counts.1 + trace.crossed as usize,
            );
            trace.clear();
            see(&body);
        }
        counts
    }

    /// The moments at the beginnings of all ticks, as the run goes without any ticks but those of its inputs.
    pub fn moments(&self, rate: f64) -> Vec<Moment> {
        let land = self.stage.land(&Shape::hero()).expect("the hero's meshes");
        let terrain = land.terrain(&self.stage, &self.replay.tuning.motion);
        let mut trace = Trace::default();
        let mut body = Body::spawn(self.stage.level.start, 0.0, &terrain).expect("a free start");
        let (mut next, mut moments) = (0, Vec::new());
        for tick in 0..=(self.seconds() * rate).round() as u32 {
            let now = f64::from(tick) / rate;
            let mut kick = DVec2::ZERO;
            while next < self.controls.len() && next as f64 / RATE <= now {
                body.advance(next as f64 / RATE, &terrain, &mut trace);
                let before = body.velocity();
                body.apply(self.controls[next], &terrain, &mut trace);
                kick += body.velocity() - before;
                next += 1;
            }
            body.advance(now, &terrain, &mut trace);
            trace.clear();
            moments.push(moment(&body, kick, &terrain));
        }
        moments
    }
}

fn moment(body: &Body, kick: DVec2, terrain: &Terrain) -> Moment {
    let pull = terrain.tuning.gravity;
    let (accel, free) = match body.mode() {
        Mode::Air(air) => (air.accel, true),
        // Pressed to the ground, so that it is not left at every bend; what would pull along it is in the law already.
        Mode::Surface(on) if on.walkable => {
            (on.track.tangent * on.accel - on.track.normal * pull, true)
        }
        Mode::Surface(on) => (on.track.tangent * on.accel, on.grip == Grip::None),
        _ => (DVec2::ZERO, true),
    };
    Moment {
        at: body.position(),
        velocity: body.velocity(),
        kick,
        accel,
        plain: free && body.size() == Size::Stand,
    }
}

/// Leads a peer along the run, and puts it back onto it every so many ticks.
pub fn lead(
    slide: &mut dyn Slide,
    moments: &[Moment],
    rate: f64,
    every: usize,
    mut see: impl FnMut(f64),
) -> usize {
    let dt = 1.0 / rate;
    let (mut at, mut velocity, mut ticks, mut alone) = (DVec2::ZERO, DVec2::ZERO, 0, false);
    for (i, pair) in moments.windows(2).enumerate() {
        let [now, then] = [pair[0], pair[1]];
        alone &= now.plain && i % every != 0;
        match alone {
            true => velocity += now.kick,
            false => (at, velocity) = (now.at, now.velocity),
        }
        if !now.plain || !then.plain {
            alone = false;
            continue;
        }
        alone = true;
        let (delta, after) = integrate(velocity, now.accel, dt, Rule::Euler);
        let moved = slide.slide(at, after, delta, dt);
        (at, velocity) = (moved.at, moved.velocity);
        ticks += 1;
        if (i + 1) % every == 0 {
            see((at - then.at).length());
        }
    }
    ticks
}

/// The hero's shape.
pub fn hero() -> Collider {
    Collider::hero()
}
