//! The game's sound as SDL's disk driver writes it to a file, while frames pass as fast as they do on a screen.

use super::hands::{FLAT, FRAME, frames, key, open, options, tap};
use edgewalker::cli::Options;
use edgewalker::shell::app::App;
use edgewalker::shell::audio::Volumes;
use sdl2::keyboard::Scancode;
use std::fs;
use std::path::Path;

/// Where the driver writes, and where it cannot.
pub const FILE_VARIABLE: &str = "SDL_DISKAUDIOFILE";
pub const NOWHERE: &str = "/no/such/folder/sound.raw";
/// Highest amplitude that the mixer lets through.
const CEILING: f32 = 0.971;
/// Largest jump between two samples that is no click: of a sound of 5000 Hz at half of the ceiling.
const JUMP: f32 = 0.32;
/// Softer than half of the smallest step of 16 bits.
const SILENT: f32 = 1.5e-5;
/// Left and right, a second of it.
const SECOND: usize = 2 * 48_000;

fn audible() -> Options {
    Options {
        mute: false,
        ..options(FLAT)
    }
}

/// Frames in real time.
fn live(app: &mut App, count: u32) {
    for _ in 0..count {
        frames(app, 1);
        std::thread::sleep(FRAME);
    }
}

/// What has been written; the game is over.
fn recorded(app: App) -> Vec<f32> {
    drop(app);
    let bytes = fs::read(std::env::var(FILE_VARIABLE).unwrap()).unwrap();
    let word = |b: &[u8]| f32::from_le_bytes([b[0], b[1], b[2], b[3]]);
    bytes.chunks_exact(4).map(word).collect()
}

fn largest(samples: &[f32]) -> f32 {
    samples
        .iter()
        .fold(0.0, |most: f32, sample| most.max(sample.abs()))
}

/// A run with jumps and a pause: it is heard, and neither clips nor clicks.
pub fn a_run_is_heard(_: &Path) {
    let mut app = open(&audible());
    live(&mut app, 60);
    key(&app, Scancode::D, true);
    for _ in 0..3 {
        live(&mut app, 25);
        tap(&mut app, Scancode::Space);
    }
    tap(&mut app, Scancode::Escape);
    assert!(app.is_paused());
    live(&mut app, 30);
    assert_eq!(app.notices.problems(), []);
    let samples = recorded(app);
    assert!(samples.len() > SECOND, "{}", samples.len());
    let loud = largest(&samples);
    assert!((0.05..CEILING).contains(&loud), "{loud}");
    for side in 0..2 {
        let channel: Vec<f32> = samples.iter().skip(side).step_by(2).copied().collect();
        let jumps = channel.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        let jump = jumps.fold(0.0, f32::max);
        assert!(jump < JUMP, "{jump}");
    }
}

pub fn volumes_of_nothing_are_silent(_: &Path) {
    let mut app = open(&audible());
    app.audio.set_volumes(Volumes {
        master: 0.0,
        ..Volumes::default()
    });
    key(&app, Scancode::D, true);
    live(&mut app, 60);
    assert!(largest(&recorded(app)[SECOND / 2..]) < SILENT);

    let mut app = open(&audible());
    app.audio.set_volumes(Volumes {
        effects: 0.0,
        music: 0.0,
        ..Volumes::default()
    });
    live(&mut app, 60);
    assert!(largest(&recorded(app)[SECOND / 2..]) < SILENT);
}

/// In a process of its own, whose device cannot be opened: it is said once, and the game is played.
pub fn without_a_device(_: &Path) {
    let mut app = open(&audible());
    let said = app.notices.notice().map(|(text, _)| text.to_string());
    assert!(said.is_some_and(|text| text.starts_with("No sound: ")));
    key(&app, Scancode::D, true);
    frames(&mut app, 60);
    assert!(app.play.world.view().position.x > 2.0);
}
