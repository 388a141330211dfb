//! Sound: SDL's device asks, the mixer answers, and what is heard is decided by [`crate::sound`].
//!
//! In reading order: [`decode`] (files), [`bank`] (all of them), [`voice`] and [`stems`] (what sounds), [`ceiling`] (never too
//! loud), [`mixer`] (tracks), [`device`] (where it goes), [`soundtrack`] (a replay as a file). Without a device, or on wish,
//! nothing sounds and the game goes on.

pub mod bank;
pub mod ceiling;
pub mod decode;
pub mod device;
pub mod mixer;
pub mod soundtrack;
pub mod stems;
pub mod voice;

use crate::cli::files::FileError;
use crate::game::{View, World};
use crate::sound::place::mood;
use crate::sound::{Cue, Ear, Heard, LOOPS, Level, Moment, Music, Sound, Soundscape};
use bank::Bank;
use device::Device;
use mixer::{Mixer, samples};
use sdl2::AudioSubsystem;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

/// How loud everything is, from 0 to 1 each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volumes {
    /// The whole.
    pub master: f32,
    /// What happens, and the place.
    pub effects: f32,
    /// Music.
    pub music: f32,
}

impl Default for Volumes {
    fn default() -> Self {
        Volumes {
            master: 1.0,
            effects: 1.0,
            music: 1.0,
        }
    }
}

/// How far playing is, in samples.
#[derive(Clone, Debug, Default)]
pub struct Clock {
    /// Counted by the thread that plays.
    pub played: Arc<AtomicU64>,
}

impl Clock {
    /// Samples played so far.
    pub fn now(&self) -> u64 {
        self.played.load(Ordering::Acquire)
    }
}

/// Seconds after which what happens now is heard, beside the device's own delay: enough for sounds that happen between two
/// frames to keep their distances.
const DELAY: f64 = 0.012;
/// The device takes samples in blocks; what is now is known more finely from the frames, and drawn to the device's own count
/// by this share of the difference each frame. If it is off by more than so many seconds, it is set.
const DRAW: f64 = 0.05;
const SLACK: f64 = 0.08;

/// The game's sound; does nothing if there is no device.
#[derive(Default)]
pub struct Audio {
    playing: Option<Playing>,
}

/// What there is when there is a device.
struct Playing {
    mixer: Mixer<Device>,
    bank: Bank,
    /// Comes when it is decoded.
    loading: Option<Receiver<Bank>>,
    problems: Receiver<FileError>,
    scape: Option<Soundscape>,
    cues: Vec<Cue>,
    loops: [Level; LOOPS],
    music: Music,
    now: f64,
    paused: bool,
}

impl Audio {
    /// Opens the device, and begins to decode everything on another thread.
    ///
    /// # Errors
    /// There is no device.
    pub fn open(audio: AudioSubsystem) -> Result<Audio, String> {
        let clock = Clock::default();
        let mut mixer = Mixer::<Device>::start((audio, clock.clone()), clock)?;
        let (tell, problems) = channel();
        for feeder in mixer.take_music(&tell) {
            std::thread::spawn(move || feeder.run());
        }
        Ok(Audio {
            playing: Some(Playing {
                mixer,
                bank: Bank::default(),
                loading: Some(load(tell)),
                problems,
                scape: None,
                cues: Vec::new(),
                loops: [Level::SILENT; LOOPS],
                music: Music::TITLE,
                now: 0.0,
                paused: false,
            }),
        })
    }

    /// How loud everything is from now on.
    pub fn set_volumes(&mut self, volumes: Volumes) {
        if let Some(playing) = &mut self.playing {
            playing.mixer.set_volumes(volumes);
        }
    }

    /// Plays a sound of the menus.
    pub fn play(&mut self, sound: Sound) {
        if let Some(Playing { mixer, bank, .. }) = &mut self.playing {
            mixer.play_now(bank, sound);
        }
    }

    /// Another world, or another stage of it: what was remembered of the last one is forgotten.
    pub fn enter(&mut self, world: &World) {
        if let Some(playing) = &mut self.playing {
            playing.scape = Some(Soundscape::new(world));
        }
    }

    /// A tick has been made.
    pub fn tick(&mut self, world: &World, before: &View, now: &View, ear: Ear) {
        let Some(playing) = &mut self.playing else {
            return;
        };
        let scape = playing.scape.get_or_insert_with(|| Soundscape::new(world));
        let moment = Moment {
            world,
            before,
            now,
            ear,
        };
        let Heard { cues, loops, music } = scape.tick(&moment);
        playing.cues.extend(cues);
        (playing.loops, playing.music) = (*loops, *music);
        playing.mixer.set_mood(mood(&moment));
    }

    /// A frame has been made, `elapsed` after the last one: `now` is what the simulated time has come to, `scale` its speed.
    /// Returns a file that could not be loaded, if there is one.
    pub fn frame(
        &mut self,
        elapsed: Duration,
        now: f64,
        scale: f64,
        paused: bool,
    ) -> Option<FileError> {
        let playing = self.playing.as_mut()?;
        playing.take_bank();
        playing.follow_clock(elapsed);
        playing.pause(paused);
        playing.send(now, scale);
        playing.problems.try_recv().ok()
    }
}

impl Playing {
    /// Takes up what has been decoded in the meantime.
    fn take_bank(&mut self) {
        let loaded = self
            .loading
            .as_ref()
            .and_then(|loading| loading.try_recv().ok());
        if let Some(bank) = loaded {
            self.mixer.take_loops(&bank);
            (self.bank, self.loading) = (bank, None);
        }
    }

    fn follow_clock(&mut self, elapsed: Duration) {
        self.now += samples(elapsed.as_secs_f64());
        let off = self.mixer.clock().now() as f64 - self.now;
        self.now += if off.abs() > samples(SLACK) {
            off
        } else {
            off * DRAW
        };
    }

    /// A pause silences the place, and puts the music behind a curtain.
    fn pause(&mut self, paused: bool) {
        if self.paused != paused {
            self.paused = paused;
            self.mixer.muffle(paused);
        }
    }

    /// Sends what the ticks of this frame have gathered, each cue at its own time.
    fn send(&mut self, now: f64, scale: f64) {
        for cue in self.cues.drain(..) {
            let ahead = (cue.at - now) / scale + DELAY;
            let start = (self.now + samples(ahead)).max(0.0) as u64;
            self.mixer.play(&self.bank, &cue, start, scale);
        }
        let silence = [Level::SILENT; LOOPS];
        self.mixer
            .set_loops(if self.paused { &silence } else { &self.loops });
        self.mixer.set_music(&self.music);
    }
}

/// Decodes everything on a thread of its own, and tells what cannot be.
fn load(problems: Sender<FileError>) -> Receiver<Bank> {
    let (send, loaded) = channel();
    std::thread::spawn(move || {
        let mut bank = Bank::load();
        for problem in bank.problems.drain(..) {
            drop(problems.send(problem)); // the game may be over
        }
        drop(send.send(bank));
    });
    loaded
}
