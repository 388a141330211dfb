//! What moves by itself: motors and chains while it does, a clunk or a slam when it starts or stops; belts.

use super::crew::Crew;
use super::ear::{Chance, nearest};
use super::{Cue, LOOPS, Level, Loop, Moment, Sound};
use crate::level::{self, Kind, Repeat, Starts};
use crate::motion::Mover;
use glam::DVec2;

/// Speed at which a motor is as loud as it gets, m/s.
const FAST: f64 = 4.0;
/// What stops dead from this speed or a higher one slams, as loud as it gets at the second, m/s.
const SLAM: (f64, f64) = (3.5, 9.0);
/// Changes of speed that are smaller are not heard, m/s.
const STEADY: f64 = 0.05;
/// Most changes of speed of a mover that are looked at in a tick.
const NODES: usize = 4;
/// Amplitude of a start or stop beside that of a slam.
const SOFT_STOP: f64 = 0.7;
/// Share of a way that must go up or down for chains to be heard.
const HANGS: f64 = 0.4;

/// A box in the world.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    min: DVec2,
    max: DVec2,
}

impl Bounds {
    /// Of some features, as they are drawn.
    pub fn of<'a>(features: impl IntoIterator<Item = &'a level::Feature>) -> Bounds {
        let corners = features.into_iter().flat_map(|f| &f.outline);
        let empty = Bounds {
            min: DVec2::INFINITY,
            max: DVec2::NEG_INFINITY,
        };
        corners.fold(empty, |b, &p| Bounds {
            min: b.min.min(p),
            max: b.max.max(p),
        })
    }

    /// Its point nearest to another, when it is so far from where it was drawn.
    pub fn nearest(self, offset: DVec2, to: DVec2) -> DVec2 {
        nearest(self.min + offset, self.max + offset, to)
    }
}

/// What is known of the machines of a level.
#[derive(Clone, Debug)]
pub struct Machines {
    /// Of each mover: its place as drawn, and whether it is a door, which moves once.
    movers: Vec<(Bounds, bool)>,
    /// The places of the belts, and their speeds.
    belts: Vec<(Bounds, f64)>,
    /// Whose motors and belts are heard.
    motors: Crew<{ Loop::Motor.voices() }>,
    running: Crew<{ Loop::Belt.voices() }>,
    chance: Chance,
}

impl Machines {
    /// Those of a level.
    pub fn new(level: &level::Level) -> Machines {
        let comes_back = |m: &level::Mover| m.back.is_some() || !m.calls.is_empty();
        let is_door = |m: &level::Mover| {
            m.repeat == Repeat::Once && m.starts != Starts::AtOnce && !comes_back(m)
        };
        let movers = level.movers.iter();
        let is_belt = |f: &&level::Feature| f.conveyor != 0.0 && f.kind != Kind::Ladder;
        let belts = level.features.iter().filter(is_belt);
        Machines {
            movers: movers
                .map(|m| (Bounds::of(&m.features), is_door(m)))
                .collect(),
            belts: belts.map(|f| (Bounds::of([f]), f.conveyor)).collect(),
            motors: Crew::default(),
            running: Crew::default(),
            chance: Chance::default(),
        }
    }

    /// The sounds of a tick.
    pub fn hear(&mut self, moment: &Moment, cues: &mut Vec<Cue>, loops: &mut [Level; LOOPS]) {
        let all = &moment.world.land(0).movers;
        for (mover, &(bounds, is_door)) in all.iter().zip(&self.movers) {
            hear_nodes(mover, bounds, is_door, moment, &mut self.chance, cues);
        }
        let motors = all.iter().zip(&self.movers).enumerate();
        let motors = motors.filter(|(_, (_, (_, is_door)))| !is_door);
        let levels = motors.map(|(i, (mover, (bounds, _)))| (i, motor(mover, *bounds, moment)));
        let seated = self.motors.seat(levels, |(motor, _)| motor.gain);
        let slots = Loop::Motor.slots().zip(Loop::Chain.slots());
        for ((motor, chain), heard) in slots.zip(seated) {
            if let Some(heard) = heard {
                (loops[motor], loops[chain]) = heard;
            }
        }
        let belts = self.belts.iter().enumerate();
        let levels = belts.map(|(i, (bounds, speed))| (i, belt(*bounds, *speed, moment)));
        let seated = self.running.seat(levels, |belt| belt.gain);
        for (slot, heard) in Loop::Belt.slots().zip(seated) {
            if let Some(heard) = heard {
                loops[slot] = heard;
            }
        }
    }
}

/// Slats over rollers: the louder and higher, the faster they run.
fn belt(bounds: Bounds, speed: f64, moment: &Moment) -> Level {
    let place = bounds.nearest(DVec2::ZERO, moment.ear.at);
    let share = (speed.abs() / FAST).min(1.0);
    moment
        .ear
        .level(place, 0.5 + 0.5 * share, 0.8 + 0.4 * share)
}

/// A motor and its chain: the louder and higher, the faster it moves.
fn motor(mover: &Mover, bounds: Bounds, moment: &Moment) -> (Level, Level) {
    let (now, ear) = (moment.now.time, moment.ear);
    let piece = mover.piece_at(now);
    let velocity = piece.velocity(now);
    let share = (velocity.length() / FAST).min(1.0);
    if share == 0.0 {
        return (Level::SILENT, Level::SILENT);
    }
    let place = bounds.nearest(piece.offset(now), ear.at);
    let motor = ear.level(place, share.sqrt(), 0.75 + 0.5 * share);
    let chain = match velocity.y.abs() > HANGS * velocity.length() {
        true => ear.level(place, share.sqrt(), 0.6 + 0.7 * share),
        false => Level::SILENT,
    };
    (motor, chain)
}

/// What is heard of the changes of speed within the tick, each at its own time.
fn hear_nodes(
    mover: &Mover,
    bounds: Bounds,
    is_door: bool,
    moment: &Moment,
    chance: &mut Chance,
    cues: &mut Vec<Cue>,
) {
    let (mut time, end) = (moment.before.time, moment.now.time);
    for _ in 0..NODES {
        let Some(node) = mover.next_node(time).filter(|&node| node <= end) else {
            return;
        };
        let (old, new) = (mover.piece_at(time), mover.piece_at(node));
        let (before, after) = (old.velocity(node), new.velocity(node));
        let rests = |velocity: DVec2| velocity.length() < STEADY;
        let stops = !rests(before) && rests(after) || before.dot(after) < 0.0;
        let rested = rests(before) && old.accel == DVec2::ZERO;
        let starts = rested && (!rests(after) || new.accel != DVec2::ZERO);
        let crash = ((before - after).length() - SLAM.0) / (SLAM.1 - SLAM.0);
        let is_eased_stop = rests(before) && rests(after) && old.accel != DVec2::ZERO;
        let sound = match (stops || is_eased_stop, starts) {
            (true, _) if crash >= 0.0 => Some((Sound::Slam, 0.4 + 0.6 * crash.min(1.0))),
            (true, _) if !is_door => Some((Sound::Clunk, SOFT_STOP)),
            (_, true) if is_door => Some((Sound::Door, 1.0)),
            (_, true) => Some((Sound::Clunk, SOFT_STOP)),
            _ => None,
        };
        if let Some((sound, gain)) = sound {
            let place = bounds.nearest(new.offset(node), moment.ear.at);
            cues.push(chance.vary(moment.ear.cue(sound, place, gain, node)));
        }
        time = node;
    }
}
