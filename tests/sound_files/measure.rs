//! What mastering engineers measure: loudness after ITU-R BS.1770, true peaks, levels in bands, clicks.

use edgewalker::shell::audio::decode::RATE;
use std::f64::consts::PI;

/// A filter of second order.
#[derive(Clone, Copy)]
struct Section {
    b: [f64; 3],
    a: [f64; 2],
    state: [f64; 2],
}

impl Section {
    fn new(b: [f64; 3], a: [f64; 2]) -> Section {
        let state = [0.0; 2];
        Section { b, a, state }
    }

    /// Lets pass what is higher, or lower, than a frequency in Hz.
    fn pass(frequency: f32, is_high: bool) -> Section {
        let w = 2.0 * PI * f64::from(frequency) / f64::from(RATE);
        let (alpha, cos) = (w.sin() / 2.0_f64.sqrt(), w.cos());
        let (side, middle) = match is_high {
            true => ((1.0 + cos) / 2.0, -1.0 - cos),
            false => ((1.0 - cos) / 2.0, 1.0 - cos),
        };
        let all = 1.0 + alpha;
        let b = [side, middle, side].map(|b| b / all);
        Section::new(b, [-2.0 * cos / all, (1.0 - alpha) / all])
    }

    fn next(&mut self, sample: f64) -> f64 {
        let out = self.b[0] * sample + self.state[0];
        self.state[0] = self.b[1] * sample - self.a[0] * out + self.state[1];
        self.state[1] = self.b[2] * sample - self.a[1] * out;
        out
    }
}

/// The two weighting filters of the standard, for 48 000 samples a second.
fn weighting() -> [Section; 2] {
    let head = (
        [1.53512485958697, -2.69169618940638, 1.19839281085285],
        [-1.69065929318241, 0.73248077421585],
    );
    let low = ([1.0, -2.0, 1.0], [-1.99004745483398, 0.99007225036621]);
    [head, low].map(|(b, a)| Section::new(b, a))
}

/// Samples of a block, and blocks of 0.1 s in a block of the standard, and in a second.
const BLOCK: usize = RATE as usize / 10;
const GATED: usize = 4;
const SECOND: usize = 10;
/// Blocks that are softer do not count, LUFS; nor do those so far below the mean of the others, dB.
const GATE: f32 = -70.0;
const BELOW: f32 = 10.0;

/// Weighted power of every tenth of a second.
pub struct Loudness {
    powers: Vec<f64>,
}

fn lufs(power: f64) -> f32 {
    (-0.691 + 10.0 * (power + 1e-12).log10()) as f32
}

fn mean(powers: &[f64]) -> f64 {
    powers.iter().sum::<f64>() / powers.len().max(1) as f64
}

impl Loudness {
    /// Of left and right by turns.
    pub fn of(heard: &[f32]) -> Loudness {
        let mut sides = [weighting(); 2];
        let weighted = |(side, &sample): (usize, &f32)| {
            let filters = sides[side % 2].iter_mut();
            filters
                .fold(f64::from(sample), |x, filter| filter.next(x))
                .powi(2)
        };
        let squares: Vec<f64> = heard.iter().enumerate().map(weighted).collect();
        let blocks = squares.chunks_exact(2 * BLOCK);
        let powers = blocks.map(|block| block.iter().sum::<f64>() / BLOCK as f64);
        Loudness {
            powers: powers.collect(),
        }
    }

    /// Of all, gated, LUFS.
    pub fn integrated(&self) -> f32 {
        let blocks: Vec<f64> = self.powers.windows(GATED).map(mean).collect();
        let above = |gate: f32| -> Vec<f64> {
            blocks.iter().copied().filter(|&b| lufs(b) > gate).collect()
        };
        let heard = lufs(mean(&above(GATE)));
        lufs(mean(&above(heard - BELOW)))
    }

    /// Of every second, LUFS.
    pub fn seconds(&self) -> Vec<f32> {
        let seconds = self.powers.chunks_exact(SECOND);
        seconds.map(|second| lufs(mean(second))).collect()
    }
}

/// Points between two samples at which the curve is looked at, and samples to either side from which it is known.
const BETWEEN: usize = 4;
const TAPS: isize = 12;

/// The highest point of the curve through the samples, dB.
pub fn true_peak(heard: &[f32]) -> f32 {
    let largest = heard.iter().fold(0.0, |most: f32, s| most.max(s.abs()));
    let mut most = largest;
    for side in 0..2 {
        let samples: Vec<f32> = heard.iter().skip(side).step_by(2).copied().collect();
        // Only next to what is loud can the curve be higher than all samples.
        let loud = (0..samples.len()).filter(|&i| samples[i].abs() > 0.6 * largest);
        for i in loud {
            for k in 1..BETWEEN {
                most = most.max(between(&samples, i, k as f32 / BETWEEN as f32).abs());
            }
        }
    }
    20.0 * most.log10()
}

/// The curve so far after a sample: a windowed sinc.
fn between(samples: &[f32], index: usize, share: f32) -> f32 {
    let mut sum = 0.0;
    for tap in 1 - TAPS..=TAPS {
        let at = index as isize + tap;
        let sample = usize::try_from(at).ok().and_then(|at| samples.get(at));
        let x = (tap as f32 - share) * PI as f32;
        let window = (x / (2.0 * TAPS as f32)).cos().powi(2);
        sum += sample.unwrap_or(&0.0) * x.sin() / x * window;
    }
    sum
}

/// Mean level in a band of frequencies, of left and right by turns, dB.
pub fn band(heard: &[f32], (from, to): (f32, f32)) -> f32 {
    let mut filters = [[Section::pass(from, true), Section::pass(to, false)]; 2];
    let passed = |(side, &sample): (usize, &f32)| {
        let filters = filters[side % 2].iter_mut();
        filters
            .fold(f64::from(sample), |x, filter| filter.next(x))
            .powi(2)
    };
    let power: f64 = heard.iter().enumerate().map(passed).sum();
    10.0 * (power / heard.len() as f64 + 1e-12).log10() as f32
}

/// Samples by which waves are shifted against one another.
const SHIFTS: isize = 240;

/// How alike two waves are where they fit best: 1 for the same one, 0 for such as have nothing in common.
pub fn likeness(a: &[f32], b: &[f32]) -> f32 {
    let power = |wave: &[f32]| wave.iter().map(|s| s * s).sum::<f32>();
    let whole = (power(a) * power(b)).sqrt();
    let laid = |shift: isize| {
        let (a, b) = (&a[shift.max(0) as usize..], &b[(-shift).max(0) as usize..]);
        a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>() / whole
    };
    (-SHIFTS..=SHIFTS).map(laid).fold(0.0, f32::max)
}

/// Samples before and after a place that are compared with it, and those at it that are not.
const AROUND: usize = 96;
const WIDTH: usize = 4;
/// A bend of the curve that is so large, and so many times as large as any around it, is a click.
const BEND: f32 = 0.02;
const SUDDEN: f32 = 6.0;

/// When the first click is, in seconds: a bend of the curve that stands alone, where nothing was loud before or after.
pub fn click(samples: &[f32]) -> Option<f32> {
    let bends: Vec<f32> = samples
        .windows(3)
        .map(|w| (w[0] - 2.0 * w[1] + w[2]).abs())
        .collect();
    let most = |part: &[f32]| part.iter().fold(0.0_f32, |most, &bend| most.max(bend));
    let is_click = |i: &usize| {
        let bend = bends[*i];
        let around = || {
            let before = most(&bends[i - AROUND..i - WIDTH]);
            before.max(most(&bends[i + WIDTH..i + AROUND]))
        };
        bend > BEND && bend > SUDDEN * around()
    };
    let at = (AROUND..bends.len() - AROUND).find(is_click)?;
    Some(at as f32 / RATE as f32)
}

#[test]
fn measures_measure() {
    let tone = |hertz: f64, amplitude: f64, seconds: usize| -> Vec<f32> {
        let sample = |i: usize| (2.0 * PI * hertz * i as f64 / f64::from(RATE) + 0.7).sin();
        let frames = 0..seconds * RATE as usize;
        frames
            .flat_map(|i| [(amplitude * sample(i)) as f32; 2])
            .collect()
    };
    // The standard's own example: a full tone of 997 Hz in one channel is -3.01 LUFS; in both, 0.
    let full = Loudness::of(&tone(997.0, 1.0, 5)).integrated();
    assert!(full.abs() < 0.1, "{full}");
    // At a quarter of the rate the samples of such a tone miss its peaks by 3 dB at worst.
    let peak = true_peak(&tone(12_000.0, 0.5, 1));
    assert!((peak + 6.02).abs() < 0.2, "{peak}");
    let inside = band(&tone(1000.0, 1.0, 1), (400.0, 6000.0));
    let outside = band(&tone(60.0, 1.0, 1), (400.0, 6000.0));
    assert!(
        (inside + 3.0).abs() < 0.3 && outside < -30.0,
        "{inside} {outside}"
    );
    let (low, high) = (tone(300.0, 0.5, 1), tone(800.0, 0.5, 1));
    assert!(likeness(&low, &low) > 0.999 && likeness(&low, &high) < 0.1);
    let mut samples: Vec<f32> = tone(300.0, 0.5, 1).into_iter().step_by(2).collect();
    assert_eq!(click(&samples), None);
    samples[30_000..].iter_mut().for_each(|s| *s *= 0.8);
    let at = click(&samples).expect("a jump of a fifth");
    assert!((at - 0.625).abs() < 1e-3, "{at}");
}
