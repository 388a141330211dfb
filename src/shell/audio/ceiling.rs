//! The last thing that everything passes: it is made louder, and what would then be too loud is turned down in time, so that
//! nothing ever clips and nothing is bent.

use kira::Frame;
use kira::effect::{Effect, EffectBuilder};
use kira::info::Info;

/// What is never passed: 2 dB below full, so that the curve between the samples stays 1 dB below it.
const MOST: f32 = 0.794;
/// Samples by which what comes is known before it is heard: 1.3 ms, in which the amplitude goes down.
const AHEAD: usize = 64;
/// Seconds in which the amplitude comes most of the way back.
const RECOVERY: f32 = 0.12;

/// How much louder the whole is made, as amplitude.
pub struct Ceiling(pub f32);

/// A limiter that looks ahead.
struct Limiter {
    lift: f32,
    /// What comes, and what it shall be turned down to, both of the last [`AHEAD`] samples by turns.
    coming: [Frame; AHEAD],
    bounds: [f32; AHEAD],
    /// The sum of the bounds: their mean goes down smoothly, and is down when what is too loud is heard.
    sum: f64,
    bound: f32,
    /// Samples for which the bound must stay.
    hold: usize,
    next: usize,
}

impl Limiter {
    fn new(lift: f32) -> Limiter {
        Limiter {
            lift,
            coming: [Frame::ZERO; AHEAD],
            bounds: [1.0; AHEAD],
            sum: AHEAD as f64,
            bound: 1.0,
            hold: 0,
            next: 0,
        }
    }

    /// Takes a frame, and gives the one from [`AHEAD`] samples before. `back` is the share of the way back in a sample.
    fn pass(&mut self, frame: Frame, back: f32) -> Frame {
        let frame = frame * self.lift;
        let wanted = MOST / frame.left.abs().max(frame.right.abs()).max(MOST);
        if wanted < 1.0 {
            (self.bound, self.hold) = (self.bound.min(wanted), AHEAD);
        } else if self.hold > 0 {
            self.hold -= 1;
        } else {
            self.bound += (1.0 - self.bound) * back;
        }
        let bound = std::mem::replace(&mut self.bounds[self.next], self.bound);
        self.sum += f64::from(self.bound) - f64::from(bound);
        let heard = std::mem::replace(&mut self.coming[self.next], frame);
        self.next = (self.next + 1) % AHEAD;
        heard * (self.sum / AHEAD as f64) as f32
    }
}

impl Effect for Limiter {
    fn process(&mut self, input: &mut [Frame], dt: f64, _: &Info) {
        let back = 1.0 - (-(dt as f32) / RECOVERY).exp();
        for frame in input {
            *frame = self.pass(*frame, back);
        }
    }
}

impl EffectBuilder for Ceiling {
    type Handle = ();

    fn build(self) -> (Box<dyn Effect>, ()) {
        (Box::new(Limiter::new(self.0)), ())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BACK: f32 = 0.001;

    fn pass(limiter: &mut Limiter, wave: impl Iterator<Item = f32>) -> Vec<f32> {
        wave.map(|sample| limiter.pass(Frame::new(sample, -0.5 * sample), BACK).left)
            .collect()
    }

    /// Waves that grow and fall back, with blows among them.
    fn rough(count: u32) -> impl Iterator<Item = f32> {
        (0..count).map(|i| {
            let blow = if i % 900 == 17 { 3.0 } else { 1.0 };
            let swell = 0.1 + 2.0 * (i as f32 / 4000.0).sin().powi(2);
            blow * swell * (i as f32 * 0.11).sin()
        })
    }

    #[test]
    fn what_is_soft_comes_out_unchanged_and_a_little_later() {
        let soft: Vec<f32> = rough(1000).map(|sample| sample * 0.05).collect();
        let heard = pass(&mut Limiter::new(2.0), soft.iter().copied());
        assert!(heard[..AHEAD].iter().all(|&sample| sample == 0.0));
        let wanted = soft.iter().map(|sample| sample * 2.0);
        assert!(heard[AHEAD..].iter().zip(wanted).all(|(a, b)| *a == b));
    }

    #[test]
    fn nothing_is_too_loud_and_the_amplitude_never_jumps() {
        let wave: Vec<f32> = rough(40_000).collect();
        let heard = pass(&mut Limiter::new(1.0), wave.iter().copied());
        let most = heard.iter().fold(0.0_f32, |most, s| most.max(s.abs()));
        assert!(most <= MOST + 1e-6 && most > 0.7 * MOST, "{most}");
        let pairs = wave.iter().zip(&heard[AHEAD..]);
        let gains: Vec<f32> = pairs
            .filter(|(a, _)| a.abs() > 1e-3)
            .map(|(a, b)| b / a)
            .collect();
        assert!(gains.iter().all(|&gain| gain > 0.0 && gain < 1.0001));
        let jump = gains
            .windows(2)
            .map(|pair| (pair[1] - pair[0]).abs())
            .fold(0.0, f32::max);
        assert!(jump < 4.0 / AHEAD as f32, "{jump}");
    }

    #[test]
    fn the_amplitude_comes_back() {
        let mut limiter = Limiter::new(1.0);
        pass(&mut limiter, std::iter::once(4.0));
        let heard = pass(&mut limiter, std::iter::repeat_n(0.5, 10_000));
        assert!(heard[AHEAD] < 0.2 && heard[9_999] > 0.499, "{heard:?}");
    }
}
