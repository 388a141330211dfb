//! Which movement the figure is in, since when, and what its clips say then.
//!
//! A movement begins at the very time of the event that caused it, between two ticks if need be.

use super::moves::{Leap, Moves, Support};
use super::pose::Pose;
use super::rig::{Act, Bone, Rig, Stride};

/// Slower than this the hero stands, m/s.
const STANDS: f32 = 0.35;
/// Speeds at which he walks and no longer runs, and at which he only runs, m/s.
const WALKS: f32 = 2.2;
const RUNS: f32 = 5.5;
/// Speed against the way he looks from which on he brakes and turns, m/s.
const TURNS: f32 = 1.2;
/// Longest turn of a running hero, s.
const TURN_TIME: f64 = 0.24;
/// Landing speeds above which he goes to his knees, and below which nothing is seen, m/s.
const HARD: f32 = 19.0;
const SOFT: f32 = 4.0;
/// Speed on the ground above which he runs on after a landing, m/s.
const RUNS_ON: f32 = 2.0;
/// Speeds down and forward from which on he rolls, m/s.
const ROLLS: (f32, f32) = (21.0, 6.0);
/// Upward speeds between which a rise becomes a fall, m/s.
const APEX: (f32, f32) = (4.0, -6.0);
/// Share of the jump's clip after which the rise takes over.
const TAKE_OFF: f32 = 0.5;
/// Share of the climb's clip that is spent going up; the rest is standing up.
const GOES_UP: f32 = 0.7;
/// How much faster than it was recorded he goes down at a death.
const GOES_DOWN: f64 = 1.7;
/// How much faster than it was recorded he gets up after a death, and from which share of that clip on.
const GETS_UP: (f64, f64) = (2.6, 0.75);

/// Kinds of movement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Stands.
    Idle,
    /// Walks or runs.
    Go,
    /// Brakes and turns.
    Turn,
    /// Comes to rest after a landing.
    LandSoft,
    /// The same, from high up.
    LandHard,
    /// Rolls on after a landing.
    Roll,
    /// Sits.
    Crouch,
    /// Walks crouched.
    Crawl,
    /// Jumps, rises, falls.
    Air,
    /// Slides down a steep slope.
    Skid,
    /// Slides down a wall.
    WallSlide,
    /// Hangs from a ledge.
    Hang,
    /// Climbs onto it.
    ClimbOver,
    /// Climbs a wall.
    ClimbWall,
    /// Climbs a ladder.
    Ladder,
    /// Goes down, struck dead.
    Die,
    /// Gets up after he has come back.
    GetUp,
}

/// Where he is in his steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pace {
    /// Cycles so far, of two steps each.
    pub rounds: f64,
    /// 0 walking to 1 running.
    pub run: f32,
    /// 0 rising to 1 falling.
    pub fall: f32,
}

/// A movement and when it began.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// What.
    pub kind: Kind,
    /// Since when, s.
    pub since: f64,
}

impl State {
    /// What the figure does now, after what it did: this movement, or another from the time of the event that began it.
    pub fn next(self, moves: &Moves, rig: &Rig) -> State {
        if self.kind == Kind::Die {
            return self;
        }
        let age = moves.time - self.since;
        let seconds = |act: Act| f64::from(rig.clip(act).seconds);
        let (speed, forward) = (moves.forward().abs(), moves.forward());
        let goes = if speed > STANDS { Kind::Go } else { Kind::Idle };
        let kind = match moves.support {
            Support::Air => Kind::Air,
            Support::Slide if moves.normal.y > 0.4 => Kind::Skid,
            Support::Slide => Kind::WallSlide,
            Support::Ledge => Kind::Hang,
            Support::Over => Kind::ClimbOver,
            Support::Wall => Kind::ClimbWall,
            Support::Ladder => Kind::Ladder,
            Support::Ground if self.kind == Kind::ClimbOver && speed < STANDS => {
                // On top he still has to stand up.
                let rest = seconds(Act::LedgeClimb) * f64::from(1.0 - GOES_UP);
                return match moves.time - moves.landed.0.max(self.since) < rest {
                    true => self,
                    false => State::at(Kind::Idle, moves.time),
                };
            }
            Support::Ground if moves.crouched => match speed > STANDS {
                true => Kind::Crawl,
                false => Kind::Crouch,
            },
            Support::Ground if self.kind == Kind::Air => landing(moves),
            Support::Ground => match self.kind {
                Kind::Turn if age < TURN_TIME && forward < RUNS => Kind::Turn,
                _ if forward < -TURNS => Kind::Turn,
                Kind::LandSoft if age < seconds(Act::LandSoft) && speed < RUNS_ON => Kind::LandSoft,
                Kind::LandHard if age < seconds(Act::LandHard) && speed < RUNS_ON => Kind::LandHard,
                Kind::Roll if age < seconds(Act::Roll) && forward > RUNS_ON => Kind::Roll,
                Kind::GetUp
                    if age < seconds(Act::Death) * GETS_UP.1 / GETS_UP.0 && speed < STANDS =>
                {
                    Kind::GetUp
                }
                _ => goes,
            },
        };
        match kind == self.kind {
            true => self,
            false => State::at(kind, began(kind, moves)),
        }
    }

    fn at(kind: Kind, since: f64) -> State {
        State { kind, since }
    }

    /// Seconds that the change to this movement takes, from another.
    pub fn fade_in(self, from: Kind) -> f32 {
        match (from, self.kind) {
            (_, Kind::Die) => 0.1,
            (_, Kind::Air | Kind::Roll) => 0.12,
            (
                Kind::Air,
                Kind::Go | Kind::LandSoft | Kind::LandHard | Kind::Crouch | Kind::Crawl,
            ) => 0.14,
            (Kind::Air, _) => 0.15,
            (Kind::Roll | Kind::GetUp, _) => 0.16,
            (Kind::Go, Kind::Turn) | (Kind::Turn, Kind::Go) => 0.16,
            (Kind::Go, Kind::Idle) => 0.3,
            (_, Kind::Go) => 0.2,
            (_, Kind::Idle) => 0.35,
            _ => 0.22,
        }
    }

    /// Whether the feet carry the figure, so that they must not slide.
    pub fn stands(self) -> bool {
        matches!(
            self.kind,
            Kind::Idle
                | Kind::Go
                | Kind::LandSoft
                | Kind::LandHard
                | Kind::Crouch
                | Kind::Crawl
                | Kind::Turn
        )
    }

    /// Whether the ground under the feet is looked for.
    pub fn is_on_ground(self) -> bool {
        self.stands() || self.kind == Kind::Skid
    }

    /// The pose that the clips give.
    pub fn pose(self, moves: &Moves, pace: Pace, rig: &Rig) -> Pose {
        let Pace { rounds, run, fall } = pace;
        let age = (moves.time - self.since).max(0.0);
        let idling = |act: Act| rig.cycle(act, age / f64::from(rig.clip(act).seconds.max(1e-3)));
        match self.kind {
            // The breath does not begin anew whenever he stops.
            Kind::Idle => rig.cycle(
                Act::Idle,
                moves.time / f64::from(rig.clip(Act::Idle).seconds.max(1e-3)),
            ),
            Kind::Go => {
                let mut pose = rig.cycle(Act::Walk, rounds);
                pose.blend(&rig.cycle(Act::Run, rounds), run);
                land_on_top(moves, rig, &mut pose);
                pose
            }
            Kind::Turn => rig.sample(
                Act::Turn,
                age / TURN_TIME * f64::from(rig.clip(Act::Turn).seconds),
            ),
            Kind::LandSoft => rig.sample(Act::LandSoft, age),
            Kind::LandHard => rig.sample(Act::LandHard, age),
            Kind::Roll => rig.sample(Act::Roll, age),
            Kind::Crouch | Kind::Skid => idling(Act::Crouch),
            Kind::Crawl => rig.cycle(Act::Crawl, rounds),
            Kind::Air => flight(moves, age, fall, rig),
            Kind::WallSlide => idling(Act::WallSlide),
            Kind::Hang => idling(Act::LedgeHang),
            Kind::ClimbOver => rig.sample(Act::LedgeClimb, self.climbed_over(moves, rig)),
            Kind::ClimbWall => rig.cycle(Act::ClimbWall, rounds),
            Kind::Ladder => rig.cycle(Act::Ladder, rounds),
            Kind::Die => rig.sample(Act::Death, age * GOES_DOWN),
            Kind::GetUp => {
                let left = f64::from(rig.clip(Act::Death).seconds) * GETS_UP.1 - age * GETS_UP.0;
                rig.sample(Act::Death, left.max(0.0))
            }
        }
    }

    /// How far the climb onto a ledge has come, in seconds of its clip: by height while there is some left to climb.
    fn climbed_over(self, moves: &Moves, rig: &Rig) -> f64 {
        let seconds = f64::from(rig.clip(Act::LedgeClimb).seconds);
        let up = f64::from(GOES_UP) * seconds;
        match moves.support {
            Support::Over => up * f64::from(1.0 - (moves.ledge / HANGS).clamp(0.0, 1.0)),
            _ => up + (moves.time - moves.landed.0.max(self.since)).max(0.0),
        }
    }
}

/// Height of the ledge over the foot in the clips that hang from it, m.
pub const LEDGE: f32 = 1.6;
/// And in the game, when a climb begins, m.
pub const HANGS: f32 = 1.3;

/// A body that was in the air has come to the ground.
fn landing(moves: &Moves) -> Kind {
    let (speed, down) = (moves.forward(), moves.landed.1);
    match speed.abs() > RUNS_ON {
        true if down > ROLLS.0 && speed > ROLLS.1 => Kind::Roll,
        true if speed < -TURNS => Kind::Turn,
        true => Kind::Go,
        false if down > HARD => Kind::LandHard,
        false if down > SOFT => Kind::LandSoft,
        false => Kind::Idle,
    }
}

/// When the event was that begins a movement now.
fn began(kind: Kind, moves: &Moves) -> f64 {
    let event = match kind {
        Kind::Air => moves.left.0,
        Kind::LandSoft | Kind::LandHard | Kind::Roll => moves.landed.0,
        Kind::Hang | Kind::ClimbOver | Kind::ClimbWall | Kind::Ladder => moves.held_at,
        _ => moves.time,
    };
    // An event of long ago did not begin what begins now.
    match (moves.time - event) < EVENT_AGE {
        true => event,
        false => moves.time,
    }
}

/// Oldest event that a movement may have begun with when it is first seen, s.
const EVENT_AGE: f64 = 0.1;

/// How much of a run and how little of a walk his speed is, 0 to 1.
pub fn run_share(moves: &Moves) -> f32 {
    run_share_at(moves.forward().abs())
}

/// The same of a speed, m/s.
pub fn run_share_at(speed: f32) -> f32 {
    smooth((speed - WALKS) / (RUNS - WALKS))
}

/// How much of a fall and how little of a rise his speed is, 0 to 1.
pub fn fall_share(moves: &Moves) -> f32 {
    smooth((APEX.0 - moves.velocity.y as f32) / (APEX.0 - APEX.1))
}

/// Metres of ground, or of height, for a cycle of steps.
pub fn stride(kind: Kind, pace: Pace, rig: &Rig) -> f32 {
    let (walk, run) = (rig.stride(Stride::Walk), rig.stride(Stride::Run));
    match kind {
        Kind::Crawl => rig.stride(Stride::Crawl),
        Kind::ClimbWall => rig.stride(Stride::ClimbWall),
        Kind::Ladder => rig.stride(Stride::Ladder),
        _ => walk + (run - walk) * pace.run,
    }
}

/// 0 below 0, 1 above 1, and without a bend between.
pub fn smooth(x: f32) -> f32 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Takes off, rises, falls: by the speed upwards, so the apex is where it is in the jump.
fn flight(moves: &Moves, age: f64, falls: f32, rig: &Rig) -> Pose {
    let turns = |act: Act| rig.cycle(act, age / f64::from(rig.clip(act).seconds.max(1e-3)));
    let mut pose = turns(Act::Rise);
    pose.blend(&turns(Act::Fall), falls);
    let jump = rig.clip(Act::Jump).seconds;
    if moves.left.1 != Leap::Walked && (age as f32) < jump {
        let share = 1.0 - smooth((age as f32 / jump - TAKE_OFF) / (1.0 - TAKE_OFF));
        pose.blend(&rig.sample(Act::Jump, age), share * (1.0 - falls));
    }
    pose
}

/// Who runs on after a landing still feels it: the upper body sinks as in the soft landing.
fn land_on_top(moves: &Moves, rig: &Rig, pose: &mut Pose) {
    let age = moves.time - moves.landed.0;
    let clip = rig.clip(Act::LandSoft);
    if (0.0..f64::from(clip.seconds)).contains(&age) {
        let strength = smooth((moves.landed.1 - SOFT) / (HARD - SOFT));
        let landed = rig.sample(Act::LandSoft, age);
        let end = rig.sample(Act::LandSoft, f64::from(clip.seconds));
        pose.add(&landed, &end, strength * LANDING_SHARE, &rig.upper);
        let hips = rig.bone(Bone::Hips);
        let sunk = landed.bones[hips].place - end.bones[hips].place;
        pose.bones[hips].place += sunk * strength * LANDING_SHARE;
    }
}

/// How much of a landing is seen in a run.
const LANDING_SHARE: f32 = 0.8;
