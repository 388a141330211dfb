//! The mixer: which track plays what, how loud the tracks are, and when what begins.
//!
//! Effects, ambience (the loops) and music have a track each; effects and ambience send some of themselves to a room. The whole
//! passes the [ceiling](super::ceiling).

use super::bank::Bank;
use super::ceiling::Ceiling;
use super::decode::RATE;
use super::stems::{self, Faders, Feeder};
use super::voice::{Dial, Looped, Voice};
use super::{Clock, Volumes};
use crate::cli::files::FileError;
use crate::level::Mood;
use crate::sound::{Cue, LOOPS, Level, Loop, Music, Piece, Sound};
use kira::backend::Backend;
use kira::effect::filter::{FilterBuilder, FilterHandle};
use kira::effect::reverb::ReverbBuilder;
use kira::track::{MainTrackBuilder, SendTrackBuilder, SendTrackHandle, TrackBuilder, TrackHandle};
use kira::{AudioManager, AudioManagerSettings, Capacities, Decibels, Mix, Tween};
use std::sync::Arc;
use std::sync::mpsc::Sender;
use std::time::Duration;

/// Most sounds at the same time; what comes when there are so many is left out.
const VOICES: usize = 40;
/// The whole, beside the loudness of the files, in decibels: the recorded run comes to -18 LUFS.
const WHOLE: f32 = 5.7;
/// Music beside effects.
const MUSIC_GAIN: f32 = 0.65;
/// How fast volumes change.
const VOLUME_TIME: Duration = Duration::from_millis(60);
/// Music in a pause: what is higher is taken away, Hz, and how fast.
const OPEN: f64 = 19_000.0;
const MUFFLED: f64 = 650.0;
const MUFFLE_TIME: Duration = Duration::from_millis(350);
/// How slow time changes the pitch of what is heard: by this power of its speed.
const SLOW_PITCH: f64 = 0.35;
/// The room: how long it rings, and how fast its high sounds die.
const ROOM: (f64, f64) = (0.82, 0.45);
/// How much of effects and ambience goes into the room in a mood, in decibels.
const fn room_send(mood: Mood) -> f32 {
    match mood {
        Mood::Dusk => -20.0,
        Mood::Works => -15.0,
        Mood::Depths => -9.0,
        Mood::Summit => -26.0,
    }
}

/// Everything that plays.
pub struct Mixer<B: Backend> {
    manager: AudioManager<B>,
    effects: TrackHandle,
    ambience: TrackHandle,
    music: TrackHandle,
    room: SendTrackHandle,
    muffle: FilterHandle,
    mood: Option<Mood>,
    dials: [Option<Arc<Dial>>; LOOPS],
    faders: Vec<(Piece, Arc<Faders>)>,
    clock: Clock,
}

impl<B: Backend> Mixer<B> {
    /// Starts a backend, of which `clock` tells how far it is.
    ///
    /// # Errors
    /// The backend's own.
    pub fn start(settings: B::Settings, clock: Clock) -> Result<Mixer<B>, B::Error> {
        let mut manager = AudioManager::<B>::new(AudioManagerSettings {
            capacities: Capacities::default(),
            main_track_builder: MainTrackBuilder::new().with_effect(Ceiling(amplitude(WHOLE))),
            internal_buffer_size: 128,
            backend_settings: settings,
        })?;
        let room = ReverbBuilder::new()
            .feedback(ROOM.0)
            .damping(ROOM.1)
            .mix(Mix::WET);
        let full = "a new manager has room for four tracks";
        let room = manager
            .add_send_track(SendTrackBuilder::new().with_effect(room))
            .expect(full);
        let sending = || TrackBuilder::new().with_send(&room, room_send(Mood::Dusk));
        let mut add = |track: TrackBuilder| {
            manager
                .add_sub_track(track.sound_capacity(VOICES))
                .expect(full)
        };
        let (effects, ambience) = (add(sending()), add(sending()));
        let mut music = TrackBuilder::new();
        let muffle = music.add_effect(FilterBuilder::new().cutoff(OPEN));
        let music = add(music);
        Ok(Mixer {
            manager,
            effects,
            ambience,
            music,
            room,
            muffle,
            mood: None,
            dials: Default::default(),
            faders: Vec::new(),
            clock,
        })
    }

    /// Takes up the loops of a bank, silent.
    pub fn take_loops(&mut self, bank: &Bank) {
        for &which in Loop::ALL {
            for (voice, slot) in which.slots().enumerate() {
                if let Some(old) = self.dials[slot].take() {
                    old.end();
                }
                let begins_at = voice as f64 / which.voices() as f64;
                let looped = bank.looped(which).cloned().map(|frames| Looped {
                    begins_at: begins_at * frames.len() as f64,
                    frames,
                });
                self.dials[slot] = looped.and_then(|looped| self.ambience.play(looped).ok());
            }
        }
    }

    /// Takes up the music, silent; what is returned feeds it.
    pub fn take_music(&mut self, problems: &Sender<FileError>) -> Vec<Feeder> {
        let mut feeders = Vec::new();
        for &piece in Piece::ALL {
            let (feeder, stems) = stems::open(piece, problems);
            if let Ok(faders) = self.music.play(stems) {
                self.faders.push((piece, faders));
                feeders.push(feeder);
            }
        }
        feeders
    }

    /// How loud everything is.
    pub fn set_volumes(&mut self, volumes: Volumes) {
        let tween = tween(VOLUME_TIME);
        self.manager
            .main_track()
            .set_volume(decibels(volumes.master), tween);
        self.effects.set_volume(decibels(volumes.effects), tween);
        self.ambience.set_volume(decibels(volumes.effects), tween);
        self.room.set_volume(decibels(volumes.effects), tween);
        self.music.set_volume(decibels(volumes.music), tween);
    }

    /// Plays a cue at a sample of all that are played.
    pub fn play(&mut self, bank: &Bank, cue: &Cue, start: u64, scale: f64) {
        let Some(frames) = bank.sound(cue.sound, cue.variant) else {
            return;
        };
        let voice = Voice {
            frames: frames.clone(),
            gain: cue.gain * amplitude(cue.sound.decibels()),
            pan: cue.pan,
            pitch: cue.pitch * scale.powf(SLOW_PITCH) as f32,
            start,
            played: self.clock.played.clone(),
        };
        drop(self.effects.play(voice)); // one too many is not heard
    }

    /// Plays a sound at once, as it was recorded.
    pub fn play_now(&mut self, bank: &Bank, sound: Sound) {
        let cue = Cue {
            sound,
            variant: 0,
            gain: 1.0,
            pan: 0.0,
            pitch: 1.0,
            at: 0.0,
        };
        self.play(bank, &cue, 0, 1.0);
    }

    /// Brings the loops to their levels.
    pub fn set_loops(&mut self, levels: &[Level; LOOPS]) {
        for &which in Loop::ALL {
            for slot in which.slots() {
                if let Some(dial) = &self.dials[slot] {
                    let level = levels[slot];
                    let gain = level.gain * amplitude(which.decibels());
                    dial.set(Level { gain, ..level });
                }
            }
        }
    }

    /// Brings the music to its amplitudes; the other piece fades.
    pub fn set_music(&mut self, music: &Music) {
        for (piece, faders) in &self.faders {
            let is_played = *piece == music.piece;
            let whole = if is_played {
                music.duck * MUSIC_GAIN
            } else {
                0.0
            };
            faders.set(music.layers, whole);
        }
    }

    /// Brings the music behind a curtain, or out of it.
    pub fn muffle(&mut self, is_muffled: bool) {
        let cutoff = if is_muffled { MUFFLED } else { OPEN };
        self.muffle.set_cutoff(cutoff, tween(MUFFLE_TIME));
    }

    /// Changes the room to that of a mood.
    pub fn set_mood(&mut self, mood: Mood) {
        if self.mood.replace(mood) == Some(mood) {
            return;
        }
        for track in [&mut self.effects, &mut self.ambience] {
            let set = track.set_send(&self.room, room_send(mood), tween(MUFFLE_TIME * 4));
            set.expect("both were made to send to it");
        }
    }

    /// How far the backend is.
    pub fn clock(&self) -> &Clock {
        &self.clock
    }

    /// The backend itself.
    pub fn backend(&mut self) -> &mut B {
        self.manager.backend_mut()
    }
}

/// A delay in samples.
pub fn samples(seconds: f64) -> f64 {
    seconds * f64::from(RATE)
}

fn tween(duration: Duration) -> Tween {
    Tween {
        duration,
        ..Tween::default()
    }
}

/// Amplitude of a loudness in decibels.
pub fn amplitude(decibels: f32) -> f32 {
    10_f32.powf(decibels / 20.0)
}

/// A volume from 0 to 1, as ears understand it: half of it sounds half as loud.
fn decibels(volume: f32) -> Decibels {
    if volume <= 0.0 {
        return Decibels::SILENCE;
    }
    Decibels(40.0 * volume.min(1.0).log10())
}
