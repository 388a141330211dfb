//! What the hero does: steps, jumps, landings, walls, ladders, cape, death. Steps come from the way that the feet have gone
//! over what is under them, never from a clock.

use super::ear::Chance;
use super::{Cue, LOOPS, Level, Loop, Moment, Sound};
use crate::anim::run_share_at;
use crate::game::{Stance, View};
use crate::level::{Kind, Material};
use crate::mesh::FeatureId;
use crate::motion::{Event, EventKind, Size, grip::Grip};
use glam::DVec2;

/// Speed of a run at full stick, m/s: what is louder when fast is as loud there as it gets by steps.
const RUN: f64 = 8.0;
/// Share of [`RUN`] below which the hero stands.
const STANDS: f64 = 0.02;
/// Metres from step to step of one who walks, runs, crawls: half a cycle of the clips, so that feet are heard when they come down.
pub const STRIDES: [f64; 3] = [0.53333, 1.56, 0.53538];
/// Amplitude of steps at rest and at [`RUN`], and what crouching leaves of it.
const STEP: (f64, f64) = (0.35, 1.0);
const SNEAK: f64 = 0.45;
/// How much lower and louder steps are straight up a slope of 45 degrees (and the other way down it).
const UPHILL_PITCH: f64 = 0.08;
const UPHILL_GAIN: f64 = 0.25;
/// Metres from rung to rung, and from hold to hold of a wall.
const RUNG: f64 = 0.45;
const HOLD: f64 = 0.7;
/// Speed into the ground below which a landing is not heard at all, m/s.
const TOUCH: f64 = 0.3;
/// Speeds into the ground: below the first a landing is only a step; from the second on it hurts, the more up to the third.
const LANDING: (f64, f64, f64) = (2.5, 14.0, 25.0);
/// Speeds into a wall: below the first it is not heard, from the second on as loud as it gets.
const BUMP: (f64, f64) = (3.0, 12.0);
/// Speed along a wall at which the slide is as loud as it gets.
const SLIDE: f64 = 6.0;
/// Speeds at which the cape begins to flap, and flaps most.
const CAPE: (f64, f64) = (4.0, 16.0);
/// Speeds of a fall at which the air begins to be heard, and is loudest.
const RUSH: (f64, f64) = (11.0, 34.0);
/// Every so many steps the lantern's handle is heard.
const SWING: u32 = 7;
/// How long after a death the hero's return is heard, s.
const RETURN: f64 = 0.34;
/// Depth above the level's bottom at which who dies has fallen into water, m.
const DROWNS: f64 = 3.0;
/// How far to the side the hero's own sounds are panned: he is where one looks.
const OWN_PAN: f32 = 0.5;

/// What the hero's sounds depend on beside the moment.
#[derive(Clone, Debug, Default)]
pub struct Hero {
    /// Share of the way to the next step, rung or hold.
    step: f64,
    climb: f64,
    steps: u32,
    /// The last checkpoint.
    awake: Option<FeatureId>,
    chance: Chance,
}

impl Hero {
    /// The sounds of a tick.
    pub fn hear(&mut self, moment: &Moment, cues: &mut Vec<Cue>, loops: &mut [Level; LOOPS]) {
        let (before, now) = (moment.before, moment.now);
        if now.deaths > before.deaths {
            return self.hear_death(moment, cues);
        }
        let waited = before.away.is_some() && now.away.is_none() && now.began_at == before.began_at;
        if let Some(last) = now.returned.filter(|_| waited) {
            cues.push(self.cue(Sound::Respawn, 1.0, last.at, moment));
        }
        self.hear_ends(moment, cues);
        for event in &moment.world.trace().events {
            self.hear_event(*event, moment, cues);
        }
        if !moment.now.is_cut_from(moment.before) {
            self.hear_steps(moment, cues);
            self.hear_climb(moment, cues);
        }
        hear_air(moment, loops);
    }

    /// A cue at the hero's own place.
    fn cue(&mut self, sound: Sound, gain: f64, at: f64, moment: &Moment) -> Cue {
        let pan = moment.ear.pan(moment.now.position) as f32 * OWN_PAN;
        let (gain, variant, pitch) = (gain as f32, 0, 1.0);
        self.chance.vary(Cue {
            sound,
            variant,
            gain,
            pan,
            pitch,
            at,
        })
    }

    fn hear_death(&mut self, moment: &Moment, cues: &mut Vec<Cue>) {
        let stage = moment.world.stage();
        let kills = |kind: EventKind| match kind {
            EventKind::Crushed => true,
            EventKind::Entered(id) => stage.kills(id),
            _ => false,
        };
        let mut events = moment.world.trace().events.iter();
        let killer = events.find(|event| kills(event.kind));
        let at = killer.map_or(moment.time_at(1.0), |event| event.time);
        let bottom = stage.level.bottom;
        if moment.before.position.y < bottom + DROWNS {
            cues.push(self.cue(Sound::Splash, 1.0, at, moment));
        }
        cues.push(self.cue(Sound::Death, 1.0, at, moment));
        if moment.now.away.is_none() {
            cues.push(self.cue(Sound::Respawn, 1.0, at + RETURN, moment));
        }
        self.step = 0.0;
    }

    /// Secrets, and the goal; a new run.
    fn hear_ends(&mut self, moment: &Moment, cues: &mut Vec<Cue>) {
        let (before, now) = (moment.before, moment.now);
        if now.began_at != before.began_at {
            self.awake = None;
            cues.push(self.cue(Sound::Respawn, 1.0, now.time, moment));
        }
        if let Some(at) = now.secret_at.filter(|_| now.secrets > before.secrets) {
            cues.push(self.cue(Sound::Secret, 1.0, at, moment));
        }
        if let (Some(at), None) = (now.won_at, before.won_at) {
            cues.push(self.cue(Sound::Goal, 1.0, at, moment));
        }
    }

    fn hear_event(&mut self, event: Event, moment: &Moment, cues: &mut Vec<Cue>) {
        let (at, ground) = (event.time, material(moment));
        let mut add = |sound: Sound, gain: f64| cues.push(self.cue(sound, gain, at, moment));
        match event.kind {
            EventKind::Jumped => add(Sound::Jump, 1.0),
            EventKind::WallJumped => add(Sound::WallJump, 1.0),
            EventKind::Landed(speed) if speed < TOUCH => {}
            EventKind::Landed(speed) => self.hear_landing(speed, at, moment, cues),
            EventKind::Hit(speed) | EventKind::Stopped(speed) => {
                let share = between(BUMP, speed);
                if share > 0.0 {
                    add(Sound::Bump, 0.25 + 0.75 * share);
                }
            }
            EventKind::Grabbed => add(Sound::Grab, 1.0),
            EventKind::Climbed => match moment.world.hero().grip() {
                Grip::Over => add(Sound::Scrape, 1.0),
                _ => add(hold(moment), 1.0),
            },
            EventKind::LetGo => add(Sound::Cloth, 0.8),
            EventKind::Resized(size) => {
                add(Sound::Cloth, if size == Size::Crouch { 1.0 } else { 0.6 })
            }
            EventKind::Dropped => add(step_on(ground), 0.5),
            EventKind::SteppedUp(_) => add(step_on(ground), 0.8),
            EventKind::Entered(id) => self.hear_region(id, at, moment, cues),
            _ => {}
        }
    }

    /// Soft and hard landings overlap: between them, both are heard.
    fn hear_landing(&mut self, speed: f64, at: f64, moment: &Moment, cues: &mut Vec<Cue>) {
        let (quiet, hard, hardest) = LANDING;
        let soft = between((quiet, hard), speed);
        let pain = between((hard, hardest), speed);
        let mut step = self.cue(step_on(material(moment)), 0.5 + 0.7 * soft, at, moment);
        step.pitch *= (1.0 - 0.12 * soft) as f32;
        cues.push(step);
        if soft > 0.0 {
            cues.push(self.cue(Sound::LandSoft, soft.powf(0.7), at, moment));
        }
        if pain > 0.0 {
            cues.push(self.cue(Sound::LandHard, 0.2 + 0.8 * pain, at, moment));
            cues.push(self.cue(Sound::Swing, 0.5 + 0.5 * pain, at, moment));
        }
        self.step = 0.0;
    }

    /// A checkpoint that was not the last one, and what sets a machine going.
    fn hear_region(&mut self, id: FeatureId, at: f64, moment: &Moment, cues: &mut Vec<Cue>) {
        let stage = moment.world.stage();
        match stage.feature(id).map(|feature| feature.kind) {
            Some(Kind::Checkpoint) if self.awake != Some(id) => {
                self.awake = Some(id);
                cues.push(self.cue(Sound::Checkpoint, 1.0, at, moment));
            }
            Some(Kind::Trigger) if starts_something(at, moment) => {
                cues.push(self.cue(Sound::Lever, 1.0, at, moment))
            }
            _ => {}
        }
    }

    /// One for every stride of way over the ground.
    fn hear_steps(&mut self, moment: &Moment, cues: &mut Vec<Cue>) {
        let (before, now) = (moment.before, moment.now);
        if before.stance != Stance::Ground || now.stance != Stance::Ground {
            self.step = 0.0; // a foot comes down first
            return;
        }
        let way = way_over_ground(moment);
        let pace = (way.length() / moment.span() / RUN).min(1.5);
        if pace < STANDS {
            return;
        }
        let forward = way.x * now.facing;
        let (from, to) = (self.step, self.step + forward / stride(now, way, moment));
        self.step = to.rem_euclid(1.0);
        if to < 1.0 {
            return;
        }
        let at = moment.time_at((1.0 - from) / (to - from));
        let uphill = now.normal.x * -way.x.signum();
        let mut gain = (STEP.0 + (STEP.1 - STEP.0) * pace) * (1.0 + UPHILL_GAIN * uphill);
        if now.crouched {
            gain *= SNEAK;
        }
        let mut step = self.cue(step_on(material(moment)), gain, at, moment);
        step.pitch *= (0.97 + 0.05 * pace - UPHILL_PITCH * uphill) as f32;
        cues.push(step);
        self.steps += 1;
        if self.steps.is_multiple_of(SWING) {
            cues.push(self.cue(Sound::Swing, 0.3 + 0.3 * pace, at, moment));
        }
    }

    /// One for every rung of a ladder, every hold of a wall.
    fn hear_climb(&mut self, moment: &Moment, cues: &mut Vec<Cue>) {
        let grip = moment.world.hero().grip();
        let is_climbing =
            moment.now.stance == Stance::Climb || matches!(grip, Grip::Wall | Grip::Over);
        let carried = carrier_way(moment);
        let way = (moment.now.position - moment.before.position - carried).length();
        if !is_climbing || way == 0.0 {
            return;
        }
        let length = if grip == Grip::None { RUNG } else { HOLD };
        let (from, to) = (self.climb, self.climb + way / length);
        self.climb = to.fract();
        if to >= 1.0 {
            let at = moment.time_at((1.0 - from) / (to - from));
            cues.push(self.cue(hold(moment), 0.8, at, moment));
        }
    }
}

/// The loops of speed: along a wall, through the air.
fn hear_air(moment: &Moment, loops: &mut [Level; LOOPS]) {
    let now = moment.now;
    let speed = now.velocity.length();
    let pan = moment.ear.pan(now.position) as f32 * OWN_PAN;
    let mut set = |which: Loop, gain: f64, pitch: f64| {
        loops[which.slot()] = Level {
            gain: gain as f32,
            pan,
            pitch: pitch as f32,
        };
    };
    let slides = now.stance == Stance::Slide && moment.world.hero().grip() == Grip::None;
    if slides {
        let share = (speed / SLIDE).min(1.0);
        set(Loop::Slide, share.sqrt(), 0.8 + 0.35 * share);
    }
    let flaps = between(CAPE, speed);
    set(Loop::Cape, flaps, 0.85 + 0.4 * flaps);
    let rush = between(RUSH, -now.velocity.y);
    set(Loop::Fall, rush.powf(1.5), 0.9 + 0.3 * rush);
}

/// Whether a machine has waited for what happened at this time.
fn starts_something(at: f64, moment: &Moment) -> bool {
    let mut movers = moment.world.land(0).movers.iter();
    movers.any(|mover| mover.start == Some(at))
}

/// How far the feet have gone over what is under them: what carries them along does not count.
fn way_over_ground(moment: &Moment) -> DVec2 {
    let belt = moment.world.underfoot().map_or(0.0, |f| f.conveyor);
    let along = DVec2::new(moment.now.normal.y, -moment.now.normal.x);
    let way = moment.now.position - moment.before.position - carrier_way(moment);
    way - along * belt * moment.span()
}

/// Metres of ground for a step, as the figure takes it.
fn stride(now: &View, way: DVec2, moment: &Moment) -> f64 {
    let [walk, run, crawl] = STRIDES;
    if now.crouched {
        return crawl;
    }
    let speed = way.x.abs() / moment.span();
    walk + (run - walk) * f64::from(run_share_at(speed as f32))
}

/// How far the moving solid has gone that carries the hero.
fn carrier_way(moment: &Moment) -> DVec2 {
    let carrier = moment.world.hero().carrier();
    let movers = &moment.world.land(0).movers;
    carrier
        .and_then(|i| movers.get(i as usize))
        .map_or(DVec2::ZERO, |mover| {
            let at = |view: &View| mover.piece_at(view.time).offset(view.time);
            at(moment.now) - at(moment.before)
        })
}

/// What is under the feet, or was.
fn material(moment: &Moment) -> Material {
    let View { material, .. } = *moment.now;
    material.or(moment.before.material).unwrap_or_default()
}

/// The sound of a step on a material.
pub fn step_on(material: Material) -> Sound {
    match material {
        Material::Rock => Sound::StepRock,
        Material::Masonry => Sound::StepMasonry,
        Material::Timber => Sound::StepTimber,
        Material::Iron => Sound::StepIron,
    }
}

/// The sound of the next hold: ladders have rungs where they are made by hand, else they are vines.
fn hold(moment: &Moment) -> Sound {
    match (moment.now.stance, material(moment)) {
        (Stance::Climb, Material::Timber | Material::Iron) => Sound::Rung,
        (Stance::Climb, _) => Sound::Rope,
        _ => Sound::Scrape,
    }
}

/// 0 below a range, 1 above it.
fn between((from, to): (f64, f64), value: f64) -> f64 {
    ((value - from) / (to - from)).clamp(0.0, 1.0)
}
