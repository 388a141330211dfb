//! The files of all sounds and music, decoded and measured: none clips, clicks, hums below hearing or is missing.

#[path = "../common/heard.rs"]
mod heard;
mod measure;
mod mix;

use edgewalker::cli::load;
use edgewalker::game::{Input, Replay};
use edgewalker::shell::audio::Volumes;
use edgewalker::shell::audio::bank::SOUNDS;
use edgewalker::shell::audio::decode::{RATE, Reader, decode, decode_as_played};
use edgewalker::shell::audio::soundtrack::{render, write_sound};
use edgewalker::shell::audio::stems::MUSIC;
use edgewalker::sound::{Layer, Loop, Piece, Sound};
use edgewalker::tune::Tuning;
use kira::Frame;
use measure::{band, likeness};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Highest amplitude of any file: -1 dB.
const PEAK: f32 = 0.891;
/// Farthest that the mean of a file may be from nothing.
const OFFSET: f32 = 0.002;
/// Highest amplitude at which a sound may begin or end: -50 dB.
const EDGE: f32 = 0.003;
/// Seconds after which a sound is under way, and how much of its largest amplitude it has had by then.
const FIRST: f32 = 0.005;
const BEGUN: f32 = 0.2;
/// What can be heard, and what small loudspeakers play of it, Hz; how much softer that may be, dB.
const HEARD: (f32, f32) = (25.0, 16_000.0);
const SMALL: (f32, f32) = (250.0, 16_000.0);
const LOST: f32 = 10.0;
/// How alike two variations may be, 1 for the same wave.
const ALIKE: f32 = 0.9;
/// All assets together, in bytes.
const SIZE: u64 = 12_000_000;

/// As the game decodes it.
fn all(path: &Path) -> Vec<Frame> {
    decode_as_played(path).unwrap_or_else(|e| panic!("{e}"))
}

fn sounds() -> impl Iterator<Item = PathBuf> {
    let variants = |sound: Sound| (0..sound.variants()).map(move |v| sound.file(v));
    let files = Sound::ALL.iter().flat_map(move |&sound| variants(sound));
    files.map(|file| Path::new(SOUNDS).join(file))
}

fn loops() -> impl Iterator<Item = PathBuf> {
    Loop::ALL
        .iter()
        .map(|which| Path::new(SOUNDS).join(which.file()))
}

fn layers() -> impl Iterator<Item = PathBuf> {
    let files = |piece: Piece| Layer::ALL.map(|layer| piece.file(layer));
    Piece::ALL
        .iter()
        .flat_map(move |&piece| files(piece))
        .map(|file| Path::new(MUSIC).join(file))
}

fn channels(frames: &[Frame]) -> [Vec<f32>; 2] {
    [
        frames.iter().map(|frame| frame.left).collect(),
        frames.iter().map(|frame| frame.right).collect(),
    ]
}

fn largest(samples: &[f32]) -> f32 {
    samples
        .iter()
        .fold(0.0, |most: f32, sample| most.max(sample.abs()))
}

/// The largest jump from one sample to the next.
fn steepest(samples: &[f32]) -> f32 {
    samples
        .windows(2)
        .fold(0.0, |most: f32, pair| most.max((pair[1] - pair[0]).abs()))
}

/// Mean power, weighted roughly as ears do: lows count little. In decibels.
fn loudness(frames: &[Frame]) -> f32 {
    let mut power = 0.0;
    for samples in channels(frames) {
        let mut slow = 0.0;
        for sample in &samples {
            slow += (sample - slow) * 0.02; // what is below about 150 Hz
            power += (sample - slow).powi(2);
        }
    }
    10.0 * (power / frames.len() as f32 + 1e-12).log10()
}

/// The loudest tenth of a second.
fn loudest(frames: &[Frame]) -> f32 {
    let window = RATE as usize / 10;
    let parts = frames.chunks(window).filter(|part| part.len() * 2 > window);
    parts.map(loudness).fold(f32::NEG_INFINITY, f32::max)
}

#[test]
fn nothing_clips_or_hums_below_hearing() {
    for path in sounds().chain(loops()).chain(layers()) {
        let frames = all(&path);
        for samples in channels(&frames) {
            let (peak, mean) = (
                largest(&samples),
                samples.iter().sum::<f32>() / samples.len() as f32,
            );
            assert!(peak <= PEAK, "{}: peak {peak}", path.display());
            assert!(peak >= 0.01, "{}: peak {peak}", path.display());
            assert!(mean.abs() <= OFFSET, "{}: mean {mean}", path.display());
        }
    }
}

#[test]
fn sounds_begin_and_end_at_nothing_and_are_short() {
    for path in sounds() {
        let frames = all(&path);
        let seconds = frames.len() as f32 / RATE as f32;
        assert!(
            (0.05..9.0).contains(&seconds),
            "{}: {seconds} s",
            path.display()
        );
        for samples in channels(&frames) {
            let ends = [&samples[..4], &samples[samples.len() - 4..]].map(largest);
            assert!(ends[0].max(ends[1]) < EDGE, "{}: {ends:?}", path.display());
        }
    }
}

/// Nobody waits for a sound: within five milliseconds of its beginning it is well under way.
#[test]
fn sounds_begin_at_once() {
    for path in sounds() {
        let frames = all(&path);
        let first = (FIRST * RATE as f32) as usize;
        for samples in channels(&frames) {
            let (begun, most) = (largest(&samples[..first]), largest(&samples));
            assert!(
                begun > BEGUN * most,
                "{}: {begun} of {most}",
                path.display()
            );
        }
    }
}

/// Small loudspeakers play nothing of what is low: everything has enough above it. So has every layer of music.
#[test]
fn small_loudspeakers_are_enough() {
    for path in sounds().chain(loops()).chain(layers()) {
        let both: Vec<f32> = all(&path).iter().flat_map(|f| [f.left, f.right]).collect();
        let (whole, heard) = (band(&both, HEARD), band(&both, SMALL));
        let lost = whole - heard;
        assert!(lost < LOST, "{}: {lost} dB are lost", path.display());
    }
}

/// Of a sound that is often heard no two variations are the same wave, wherever one lays them.
#[test]
fn variations_are_not_copies() {
    for &sound in Sound::ALL {
        let waves: Vec<Vec<f32>> = (0..sound.variants())
            .map(|variant| all(&Path::new(SOUNDS).join(sound.file(variant))))
            .map(|frames| channels(&frames)[0].clone())
            .collect();
        for (i, a) in waves.iter().enumerate() {
            for (j, b) in waves.iter().enumerate().skip(i + 1) {
                let alike = likeness(a, b);
                assert!(alike < ALIKE, "{sound:?}: {i} and {j} are {alike} alike");
            }
        }
    }
}

/// The jump from the end of a loop to its beginning is no larger than those within it.
#[test]
fn loops_and_music_join_without_a_click() {
    for path in loops().chain(layers()) {
        let frames = all(&path);
        for samples in channels(&frames) {
            let join = (samples[0] - samples[samples.len() - 1]).abs();
            let within = steepest(&samples);
            assert!(join <= within, "{}: {join} beside {within}", path.display());
            // Nor does it bend more there.
            let bend = |a: f32, b: f32, c: f32| (a - 2.0 * b + c).abs();
            let n = samples.len();
            let at_join = bend(samples[n - 2], samples[n - 1], samples[0]).max(bend(
                samples[n - 1],
                samples[0],
                samples[1],
            ));
            let most = samples
                .windows(3)
                .fold(0.0, |most: f32, w| most.max(bend(w[0], w[1], w[2])));
            assert!(
                at_join <= most,
                "{}: {at_join} beside {most}",
                path.display()
            );
        }
    }
}

/// Variations of a sound are equally loud, and the parts of the whole are in balance.
#[test]
fn loudness_is_even() {
    for &sound in Sound::ALL {
        let loudness: Vec<f32> = (0..sound.variants())
            .map(|variant| loudest(&all(&Path::new(SOUNDS).join(sound.file(variant)))))
            .collect();
        let (least, most) = loudness
            .iter()
            .fold((0.0_f32, -99.0_f32), |(a, b), &l| (a.min(l), b.max(l)));
        assert!(most - least < 5.0, "{sound:?}: {loudness:?}");
        assert!((-50.0..-8.0).contains(&least), "{sound:?}: {loudness:?}");
    }
    let of = |paths: &mut dyn Iterator<Item = PathBuf>| -> Vec<f32> {
        paths.map(|path| loudness(&all(&path))).collect()
    };
    let (music, loops) = (of(&mut layers()), of(&mut loops()));
    assert!(
        music.iter().all(|l| (-45.0..-22.0).contains(l)),
        "{music:?}"
    );
    assert!(
        loops.iter().all(|l| (-40.0..-22.0).contains(l)),
        "{loops:?}"
    );
}

/// Layers are heard together, so they are equally long, to the sample; and as long the second time.
#[test]
fn layers_are_equally_long_and_come_again() {
    for &piece in Piece::ALL {
        let path = |layer: Layer| Path::new(MUSIC).join(piece.file(layer));
        let lengths = Layer::ALL.map(|layer| all(&path(layer)).len());
        assert!(
            lengths.iter().all(|&length| length == lengths[0]),
            "{piece:?}: {lengths:?}"
        );
        let seconds = lengths[0] as f32 / RATE as f32;
        assert!((90.0..180.0).contains(&seconds), "{piece:?}: {seconds} s");
        let mut reader = Reader::open_loop(&path(Layer::Pulse)).unwrap_or_else(|e| panic!("{e}"));
        let mut passes = [Vec::new(), Vec::new(), Vec::new()];
        for pass in &mut passes {
            while reader.read(pass).unwrap() {}
            reader.rewind().unwrap();
        }
        // The first one begins; into the others the one before goes over.
        let [first, second, third] = passes;
        assert_eq!(first.len(), second.len());
        assert!(second == third, "{piece:?}: another sound the third time");
    }
}

#[test]
fn there_is_no_file_too_many_and_all_are_small() {
    let named: BTreeSet<PathBuf> = sounds().chain(loops()).chain(layers()).collect();
    let mut size = 0;
    let mut there = BTreeSet::new();
    for folder in [SOUNDS, MUSIC] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let entry = entry.unwrap();
            size += entry.metadata().unwrap().len();
            there.insert(entry.path());
        }
    }
    assert_eq!(there, named);
    assert!(size < SIZE, "{size} bytes");
}

#[test]
fn what_is_no_sound_is_named() {
    for (path, reason) in [
        ("assets/sounds/no such.ogg", "not found"),
        ("levels/dev/flat.ron", "no sound that can be played"),
    ] {
        let error = decode(Path::new(path)).err().unwrap().to_string();
        assert!(error.starts_with(path) && error.contains(reason), "{error}");
    }
}

/// One sound as plain samples: all of it, as the game plays it.
#[test]
fn a_sound_is_written_as_it_is_played() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    for path in [
        Path::new(SOUNDS).join("belt.ogg"),
        Path::new(SOUNDS).join("checkpoint.ogg"),
    ] {
        let file = folder.join("sound.wav");
        write_sound(&path, &file).unwrap_or_else(|e| panic!("{e}"));
        let bytes = std::fs::read(&file).unwrap();
        let plain = bytes[44..]
            .chunks_exact(2)
            .map(|b| i16::from_le_bytes([b[0], b[1]]));
        let frames = all(&path);
        let played = frames.iter().flat_map(|frame| [frame.left, frame.right]);
        assert_eq!(plain.len(), 2 * frames.len(), "{path:?}");
        for (plain, played) in plain.zip(played) {
            assert!(
                (f32::from(plain) / f32::from(i16::MAX) - played).abs() < 2e-5,
                "{path:?}"
            );
        }
    }
}

/// A few seconds of a run as a file: heard, and the same every time; nothing clips, and without volumes nothing is heard.
#[test]
fn a_soundtrack_is_heard_and_does_not_clip() {
    let path = Path::new("levels/dev/stairs.ron");
    let stage = load::stage(path).unwrap_or_else(|e| panic!("{e}"));
    let mut replay = Replay::new("levels/dev/stairs.ron", &stage, 120, 7, &Tuning::default());
    for tick in 0..600_u32 {
        replay.push(Input {
            run: if tick > 60 { 127 } else { 0 },
            jump: tick % 90 < 30,
            ..Input::default()
        });
    }
    let volumes = Volumes::default();
    let heard = render(path, &replay, volumes).unwrap_or_else(|e| panic!("{e}"));
    assert!(heard.len() > 2 * 7 * RATE as usize - 4, "{}", heard.len());
    let most = largest(&heard);
    assert!((0.1..0.971).contains(&most), "{most}");
    let frames: Vec<Frame> = heard
        .chunks_exact(2)
        .map(|c| Frame::new(c[0], c[1]))
        .collect();
    let loudness = loudness(&frames[RATE as usize..5 * RATE as usize]);
    assert!((-40.0..-16.0).contains(&loudness), "{loudness}");
    let again = render(path, &replay, volumes).unwrap_or_else(|e| panic!("{e}"));
    assert!(heard == again, "another sound the second time");
    let master = 0.0;
    let silent = render(path, &replay, Volumes { master, ..volumes });
    let silent = silent.unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(largest(&silent[RATE as usize / 2..]), 0.0);
}
