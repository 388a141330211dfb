//! What a replay sounds like, as a file: the same mixer, without a window or a device, as fast as it goes. And a single
//! sound, as the game decodes it.

use super::bank::Bank;
use super::decode::{RATE, decode_as_played};
use super::device::Tape;
use super::mixer::{Mixer, samples};
use super::stems::Feeder;
use super::{Clock, Volumes};
use crate::cli::files;
use crate::cli::load;
use crate::game::Replay;
use crate::shell::ShellError;
use crate::shell::play::Play;
use crate::sound::place::mood;
use crate::sound::{Ear, Heard, LOOPS, Level, Moment, Music, Soundscape};
use std::path::Path;
use std::sync::mpsc::channel;

/// Seconds that are played on after the last tick, for what still sounds.
const TAIL: f64 = 2.0;
/// Bytes of a sample in a file, and of the header before the first one.
const BYTES: u32 = 2;
const HEADER: u32 = 44;
const CHANNELS: u32 = 2;

/// Plays a replay and writes what is heard as WAV.
///
/// # Errors
/// The replay, its level or a sound is missing or broken, or the file cannot be written.
pub fn write(replay: &Path, file: &Path) -> Result<(), ShellError> {
    files::check_writable(file)?;
    let run = load::replay(replay)?;
    let samples = render(replay, &run, Volumes::default())?;
    Ok(files::write_atomic(file, &wav(&samples))?)
}

/// Decodes one file of sound or music and writes it as WAV.
///
/// # Errors
/// The sound is missing or broken, or the file cannot be written.
pub fn write_sound(sound: &Path, file: &Path) -> Result<(), ShellError> {
    files::check_writable(file)?;
    let frames = decode_as_played(sound)?;
    let samples: Vec<f32> = frames.iter().flat_map(|f| [f.left, f.right]).collect();
    Ok(files::write_atomic(file, &wav(&samples))?)
}

/// What is heard of a replay: left and right by turns.
///
/// # Errors
/// The level or a sound is missing or broken.
pub fn render(path: &Path, replay: &Replay, volumes: Volumes) -> Result<Vec<f32>, ShellError> {
    let world = load::replay_world(path, replay)?;
    let mut bank = Bank::load();
    let (tell, problems) = channel();
    let clock = Clock::default();
    let Ok(mut mixer) = Mixer::<Tape>::start(clock.clone(), clock);
    mixer.take_loops(&bank);
    mixer.set_volumes(volumes);
    let mut feeders = mixer.take_music(&tell);
    if let Some(problem) = bank.problems.drain(..).chain(problems.try_iter()).next() {
        return Err(problem.into());
    }
    let mut scape = Soundscape::new(&world);
    let mut play = Play::new(world, &replay.tuning);
    let mut heard = Vec::new();
    for input in replay.iter() {
        play.tick(input, 0.0, &replay.tuning);
        let (before, now) = play.moments();
        let moment = Moment {
            world: &play.world,
            before,
            now,
            ear: Ear {
                at: play.pose(1.0, &replay.tuning).target.truncate(),
            },
        };
        let Heard { cues, loops, music } = scape.tick(&moment);
        for cue in cues {
            mixer.play(&bank, cue, samples(cue.at) as u64, 1.0);
        }
        mixer.set_loops(loops);
        mixer.set_music(music);
        mixer.set_mood(mood(&moment));
        play_to(now.time, &mut mixer, &mut feeders, &mut heard);
    }
    mixer.set_loops(&[Level::SILENT; LOOPS]);
    mixer.set_music(&Music::default());
    play_to(
        play.world.time() + TAIL,
        &mut mixer,
        &mut feeders,
        &mut heard,
    );
    Ok(heard)
}

/// Plays up to a time in seconds.
fn play_to(time: f64, mixer: &mut Mixer<Tape>, feeders: &mut [Feeder], heard: &mut Vec<f32>) {
    feeders.iter_mut().for_each(Feeder::fill);
    let due = (samples(time) as u64).saturating_sub(mixer.clock().now());
    mixer.backend().play(due as usize, heard);
}

/// A WAV file of samples of 16 bits, left and right by turns.
pub fn wav(samples: &[f32]) -> Vec<u8> {
    let size = samples.len() as u32 * BYTES;
    let mut bytes = Vec::with_capacity((HEADER + size) as usize);
    bytes.extend(b"RIFF");
    bytes.extend((HEADER - 8 + size).to_le_bytes());
    bytes.extend(b"WAVEfmt ");
    bytes.extend(16_u32.to_le_bytes()); // length of what follows, up to the data
    bytes.extend(1_u16.to_le_bytes()); // plain samples
    bytes.extend((CHANNELS as u16).to_le_bytes());
    bytes.extend(RATE.to_le_bytes());
    bytes.extend((RATE * CHANNELS * BYTES).to_le_bytes());
    bytes.extend(((CHANNELS * BYTES) as u16).to_le_bytes());
    bytes.extend(((BYTES * 8) as u16).to_le_bytes());
    bytes.extend(b"data");
    bytes.extend(size.to_le_bytes());
    for sample in samples {
        let number = (sample.clamp(-1.0, 1.0) * f32::from(i16::MAX)).round() as i16;
        bytes.extend(number.to_le_bytes());
    }
    bytes
}
