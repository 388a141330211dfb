//! What sounds: a voice that begins at a sample and ends, a loop that follows its level without a click.

use super::bank::Frames;
use crate::sound::Level;
use kira::Frame;
use kira::info::Info;
use kira::sound::{Sound, SoundData};
use std::convert::Infallible;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, AtomicU64, Ordering};

/// Seconds in which a loop comes most of the way to another level.
const FADE: f32 = 0.035;
/// A loop that is softer than this is not worked out.
const SILENCE: f32 = 1e-5;
/// Share of a channel's amplitude that equal power leaves to each side in the middle, turned back to 1 there.
const MIDDLE: f32 = std::f32::consts::SQRT_2;

/// The frame of a sound at a place between two samples: a cubic through four of them.
fn between(frames: &[Frame], place: f64, is_loop: bool) -> Frame {
    let (base, count) = (place.floor() as isize, frames.len() as isize);
    let at = |offset: isize| {
        let index = base + offset;
        match is_loop {
            true => frames[index.rem_euclid(count) as usize],
            false if (0..count).contains(&index) => frames[index as usize],
            false => Frame::ZERO,
        }
    };
    let share = (place - place.floor()) as f32;
    if share == 0.0 {
        return at(0);
    }
    let (a, b, c, d) = (at(-1), at(0), at(1), at(2));
    let (slope, bend) = ((c - a) * 0.5, a - b * 2.5 + c * 2.0 - d * 0.5);
    let turn = (b - c) * 1.5 + (d - a) * 0.5;
    b + (slope + (bend + turn * share) * share) * share
}

/// What a side leaves of left and right.
fn sides(pan: f32) -> (f32, f32) {
    let share = (pan.clamp(-1.0, 1.0) + 1.0) * 0.5;
    ((1.0 - share).sqrt() * MIDDLE, share.sqrt() * MIDDLE)
}

/// A sound that is heard once.
pub struct Voice {
    /// What is played.
    pub frames: Frames,
    /// Amplitude.
    pub gain: f32,
    /// -1 left, 1 right.
    pub pan: f32,
    /// Speed.
    pub pitch: f32,
    /// At which sample of all that are played it begins; if that is past, at once.
    pub start: u64,
    /// How many samples have been played so far.
    pub played: Arc<AtomicU64>,
}

/// A voice that has come to be played.
struct Playing {
    voice: Voice,
    /// Samples until it begins; `None` before the first call.
    wait: Option<u64>,
    place: f64,
}

impl SoundData for Voice {
    type Error = Infallible;
    type Handle = ();

    fn into_sound(self) -> Result<(Box<dyn Sound>, ()), Infallible> {
        let playing = Playing {
            voice: self,
            wait: None,
            place: 0.0,
        };
        Ok((Box::new(playing), ()))
    }
}

impl Sound for Playing {
    fn process(&mut self, out: &mut [Frame], _: f64, _: &Info) {
        let voice = &self.voice;
        let played = || voice.played.load(Ordering::Acquire);
        let wait = self
            .wait
            .get_or_insert_with(|| voice.start.saturating_sub(played()));
        let silent = (*wait).min(out.len() as u64);
        *wait -= silent;
        let (rest, sounding) = out.split_at_mut(silent as usize);
        rest.fill(Frame::ZERO);
        let (left, right) = sides(voice.pan);
        for frame in sounding {
            let sample = between(&voice.frames, self.place, false) * voice.gain;
            *frame = Frame::new(sample.left * left, sample.right * right);
            self.place += f64::from(voice.pitch);
        }
    }

    fn finished(&self) -> bool {
        self.place >= self.voice.frames.len() as f64
    }
}

/// Where a loop is told its level; read by the thread that plays.
#[derive(Debug)]
pub struct Dial {
    gain: AtomicU32,
    pan: AtomicU32,
    pitch: AtomicU32,
    is_over: AtomicBool,
}

impl Dial {
    /// Sets the level that the loop shall come to.
    pub fn set(&self, level: Level) {
        for (word, value) in [
            (&self.gain, level.gain),
            (&self.pan, level.pan),
            (&self.pitch, level.pitch),
        ] {
            word.store(value.to_bits(), Ordering::Relaxed);
        }
    }

    /// Ends the loop at once.
    pub fn end(&self) {
        self.is_over.store(true, Ordering::Relaxed);
    }

    fn level(&self) -> Level {
        let value = |word: &AtomicU32| f32::from_bits(word.load(Ordering::Relaxed));
        Level {
            gain: value(&self.gain),
            pan: value(&self.pan),
            pitch: value(&self.pitch),
        }
    }
}

/// A sound that goes on for ever, silent at first.
pub struct Looped {
    /// What is played.
    pub frames: Frames,
    /// At which of its samples it begins.
    pub begins_at: f64,
}

struct Turning {
    frames: Frames,
    dial: Arc<Dial>,
    now: Level,
    place: f64,
}

impl SoundData for Looped {
    type Error = Infallible;
    type Handle = Arc<Dial>;

    fn into_sound(self) -> Result<(Box<dyn Sound>, Arc<Dial>), Infallible> {
        let dial = Arc::new(Dial {
            gain: AtomicU32::new(0),
            pan: AtomicU32::new(0),
            pitch: AtomicU32::new(1.0_f32.to_bits()),
            is_over: AtomicBool::new(false),
        });
        let turning = Turning {
            frames: self.frames,
            dial: dial.clone(),
            now: Level::SILENT,
            place: self.begins_at,
        };
        Ok((Box::new(turning), dial))
    }
}

impl Sound for Turning {
    fn process(&mut self, out: &mut [Frame], dt: f64, _: &Info) {
        let wanted = self.dial.level();
        if wanted.gain < SILENCE && self.now.gain < SILENCE {
            self.now.gain = 0.0;
            return out.fill(Frame::ZERO);
        }
        if self.now.gain < SILENCE {
            // Nobody hears it turn to another side.
            (self.now.pan, self.now.pitch) = (wanted.pan, wanted.pitch);
        }
        let share = 1.0 - (-(dt as f32) / FADE).exp();
        let Level { gain, pan, pitch } = &mut self.now;
        let (mut left, mut right) = sides(*pan);
        for frame in out {
            *gain += (wanted.gain - *gain) * share;
            *pitch += (wanted.pitch - *pitch) * share;
            if *pan != wanted.pan {
                *pan += (wanted.pan - *pan) * share;
                (left, right) = sides(*pan);
            }
            let sample = between(&self.frames, self.place, true) * *gain;
            *frame = Frame::new(sample.left * left, sample.right * right);
            self.place = (self.place + f64::from(*pitch)) % self.frames.len() as f64;
        }
    }

    fn finished(&self) -> bool {
        self.dial.is_over.load(Ordering::Relaxed)
    }
}
