//! What is heard, as values: from what happens in the world to cues, loops and music. Nothing here makes a sound.
//!
//! A [`Soundscape`] is told of every tick, and answers with what is [`Heard`]: [`Cue`]s, each with its own time within the
//! tick, how loud every [`Loop`] shall be from now on, and which layers of which [`Music`] play. It depends on nothing but the
//! run, so that a replay sounds the same every time; the shell plays it, and may leave it out.
//!
//! In reading order: [`table`] (every sound there is), [`ear`] (how loud is what is how far away?), [`hero`] (steps, landings,
//! cape), [`machines`] (what moves), [`crew`] (which of them are heard), [`place`] (wind, water, lamps), [`score`] (music), [`crowd`] (not all at once).

pub mod crew;
pub mod crowd;
pub mod ear;
pub mod hero;
pub mod machines;
pub mod place;
pub mod score;
pub mod table;

pub use ear::Ear;
pub use hero::STRIDES;
pub use score::Music;
pub use table::{LOOPS, Layer, Loop, Piece, Sound};

use crate::game::{View, World};

/// A sound that begins at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cue {
    /// Which.
    pub sound: Sound,
    /// Which of its variations, from 0.
    pub variant: u8,
    /// Amplitude, 1 as it was recorded.
    pub gain: f32,
    /// -1 left, 1 right.
    pub pan: f32,
    /// Speed, 1 as it was recorded.
    pub pitch: f32,
    /// When, in simulated seconds.
    pub at: f64,
}

/// How a loop sounds from now on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Amplitude; 0: not at all.
    pub gain: f32,
    /// -1 left, 1 right.
    pub pan: f32,
    /// Speed, 1 as it was recorded.
    pub pitch: f32,
}

impl Level {
    /// Nothing.
    pub const SILENT: Level = Level {
        gain: 0.0,
        pan: 0.0,
        pitch: 1.0,
    };

    /// From the middle, as it was recorded.
    pub fn of(gain: f64) -> Level {
        Level {
            gain: gain as f32,
            ..Level::SILENT
        }
    }

    /// Takes the other one if that is louder.
    pub fn raise(&mut self, other: Level) {
        if other.gain > self.gain {
            *self = other;
        }
    }
}

/// Cues of one tick that there is room for from the start, before the list grows: a level may have this many machines turn at once.
const CUES: usize = 256;

/// What there is to hear of a tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Heard {
    /// What begins, in order of time.
    pub cues: Vec<Cue>,
    /// Of every voice of every loop, at their [slots](Loop::slots).
    pub loops: [Level; LOOPS],
    /// The music.
    pub music: Music,
}

/// One tick, as the parts of the soundscape look at it.
pub struct Moment<'a> {
    /// The world after it.
    pub world: &'a World,
    /// What was to be seen before it.
    pub before: &'a View,
    /// What is to be seen after it.
    pub now: &'a View,
    /// Who listens.
    pub ear: Ear,
}

impl Moment<'_> {
    /// Simulated seconds that it took.
    pub fn span(&self) -> f64 {
        self.now.time - self.before.time
    }

    /// The time at a share (0 to 1) of it.
    pub fn time_at(&self, share: f64) -> f64 {
        self.before.time + share * self.span()
    }
}

/// Everything that is remembered from tick to tick.
#[derive(Clone, Debug)]
pub struct Soundscape {
    hero: hero::Hero,
    machines: machines::Machines,
    place: place::Place,
    score: score::Score,
    crowd: crowd::Crowd,
    heard: Heard,
}

impl Soundscape {
    /// Of a world at its present tick, in its present stage.
    pub fn new(world: &World) -> Soundscape {
        let stage = world.stage();
        Soundscape {
            hero: hero::Hero::default(),
            machines: machines::Machines::new(&stage.level),
            place: place::Place::new(&stage.level),
            score: score::Score::new(&stage.level),
            crowd: crowd::Crowd::default(),
            heard: Heard {
                cues: Vec::with_capacity(CUES),
                loops: [Level::SILENT; LOOPS],
                music: Music::default(),
            },
        }
    }

    /// What there is to hear of a tick that the world has just made.
    pub fn tick(&mut self, moment: &Moment) -> &Heard {
        let Heard { cues, loops, music } = &mut self.heard;
        cues.clear();
        *loops = [Level::SILENT; LOOPS];
        self.hero.hear(moment, cues, loops);
        self.machines.hear(moment, cues, loops);
        self.place.hear(moment, cues, loops);
        *music = self.score.hear(moment, cues);
        self.crowd.thin_out(cues);
        &self.heard
    }
}
