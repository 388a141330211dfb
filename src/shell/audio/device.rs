//! What the mixer plays on: SDL's audio device, or a tape that is filled as fast as one likes.

use super::Clock;
use super::decode::RATE;
use kira::backend::{Backend, Renderer};
use sdl2::AudioSubsystem;
use sdl2::audio::{AudioCallback, AudioDevice, AudioSpecDesired};
use std::convert::Infallible;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::Ordering;

/// Samples that the device asks for at a time: 11 ms.
const BLOCK: u16 = 512;
const CHANNELS: u8 = 2;

/// Both ends of what is played: the renderer, and how far it is.
struct Player {
    renderer: Renderer,
    clock: Clock,
    /// The mixer has failed: it is silent from then on, since what called it is not of Rust and cannot be unwound.
    has_failed: bool,
}

impl Player {
    fn new(renderer: Renderer, clock: Clock) -> Player {
        Player {
            renderer,
            clock,
            has_failed: false,
        }
    }
}

fn mix(mut renderer: AssertUnwindSafe<&mut Renderer>, out: AssertUnwindSafe<&mut [f32]>) {
    renderer.on_start_processing();
    renderer.process(out.0, CHANNELS.into());
}

impl AudioCallback for Player {
    type Channel = f32;

    fn callback(&mut self, out: &mut [f32]) {
        if !self.has_failed {
            let renderer = AssertUnwindSafe(&mut self.renderer);
            let block = AssertUnwindSafe(&mut *out);
            self.has_failed = catch_unwind(move || mix(renderer, block)).is_err();
        }
        if self.has_failed {
            out.fill(0.0);
        }
        let frames = out.len() / usize::from(CHANNELS);
        self.clock
            .played
            .fetch_add(frames as u64, Ordering::Release);
    }
}

/// SDL's device.
pub struct Device {
    audio: AudioSubsystem,
    clock: Clock,
    device: Option<AudioDevice<Player>>,
}

impl Backend for Device {
    type Settings = (AudioSubsystem, Clock);
    type Error = String;

    fn setup((audio, clock): Self::Settings, _: usize) -> Result<(Self, u32), String> {
        let device = Device {
            audio,
            clock,
            device: None,
        };
        Ok((device, RATE))
    }

    fn start(&mut self, renderer: Renderer) -> Result<(), String> {
        let wanted = AudioSpecDesired {
            freq: Some(RATE as i32),
            channels: Some(CHANNELS),
            samples: Some(BLOCK),
        };
        let clock = self.clock.clone();
        // What the device cannot do, SDL converts.
        let device = self
            .audio
            .open_playback(None, &wanted, |_| Player::new(renderer, clock))?;
        device.resume();
        self.device = Some(device);
        Ok(())
    }
}

/// A backend that plays when it is told to.
pub struct Tape {
    clock: Clock,
    player: Option<Player>,
}

impl Backend for Tape {
    type Settings = Clock;
    type Error = Infallible;

    fn setup(clock: Clock, _: usize) -> Result<(Self, u32), Infallible> {
        Ok((
            Tape {
                clock,
                player: None,
            },
            RATE,
        ))
    }

    fn start(&mut self, renderer: Renderer) -> Result<(), Infallible> {
        let clock = self.clock.clone();
        self.player = Some(Player::new(renderer, clock));
        Ok(())
    }
}

impl Tape {
    /// Plays so many samples, left and right by turns, into a list.
    pub fn play(&mut self, samples: usize, into: &mut Vec<f32>) {
        let from = into.len();
        into.resize(from + samples * usize::from(CHANNELS), 0.0);
        if let Some(player) = &mut self.player {
            player.callback(&mut into[from..]);
        }
    }
}
