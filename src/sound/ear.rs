//! How loud is what is how far away, and from which side?

use super::{Cue, Level, Sound};
use glam::DVec2;

/// Distance at which a sound has lost half of its amplitude, in metres.
const HALF: f64 = 7.0;
/// Distance from which on nothing is heard, in metres.
const FAR: f64 = 38.0;
/// Distance to the side at which a sound comes from that side alone, in metres: somewhat beyond the picture's edge.
const SIDE: f64 = 16.0;
/// Farthest to one side that anything is panned: both ears hear everything.
const MOST_PAN: f64 = 0.85;

/// Where the listener is: in the plane of play, before the middle of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ear {
    /// Metres.
    pub at: DVec2,
}

impl Ear {
    /// Amplitude of what sounds at a place, 1 near by to 0 far away.
    pub fn gain(self, place: DVec2) -> f64 {
        let distance = self.at.distance(place);
        let left = 1.0 - (distance / FAR).min(1.0);
        left / (1.0 + (distance / HALF).powi(2))
    }

    /// The side from which it comes: -1 left, 1 right.
    pub fn pan(self, place: DVec2) -> f64 {
        ((place.x - self.at.x) / SIDE).clamp(-1.0, 1.0) * MOST_PAN
    }

    /// A loop that sounds at a place.
    pub fn level(self, place: DVec2, gain: f64, pitch: f64) -> Level {
        Level {
            gain: (gain * self.gain(place)) as f32,
            pan: self.pan(place) as f32,
            pitch: pitch as f32,
        }
    }

    /// A sound at a place; the caller chooses its variation.
    pub fn cue(self, sound: Sound, place: DVec2, gain: f64, at: f64) -> Cue {
        Cue {
            sound,
            variant: 0,
            gain: (gain * self.gain(place)) as f32,
            pan: self.pan(place) as f32,
            pitch: 1.0,
            at,
        }
    }
}

/// The point of a box that is nearest to another.
pub fn nearest(min: DVec2, max: DVec2, to: DVec2) -> DVec2 {
    to.clamp(min, max)
}

/// Variations by chance, the same in every run: numbers from a counter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Chance {
    count: u64,
    last: u8,
}

/// How much faster or slower a variation may be.
const DETUNE: f64 = 0.035;

impl Chance {
    /// A number from 0 to 1.
    pub fn share(&mut self) -> f64 {
        self.count += 1;
        share_of(self.count)
    }

    /// Gives a cue one of its sound's variations, never the last one again, and a slightly other pitch.
    pub fn vary(&mut self, mut cue: Cue) -> Cue {
        let variants = cue.sound.variants();
        if variants > 1 {
            let step = 1 + (self.share() * f64::from(variants - 1)) as u8;
            self.last = (self.last + step.min(variants - 1)) % variants;
            cue.variant = self.last;
            cue.pitch *= (1.0 + DETUNE * (2.0 * self.share() - 1.0)) as f32;
        }
        cue
    }
}

/// A number from 0 to 1 that looks like chance.
pub fn share_of(number: u64) -> f64 {
    // The mixing steps of SplitMix64.
    let mut word = number.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    let bits = (word ^ (word >> 31)) >> 11;
    bits as f64 / (1_u64 << 53) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_is_loud_and_far_is_silent() {
        let ear = Ear { at: DVec2::ZERO };
        let gains = [0.0, 2.0, 7.0, 20.0, 37.0].map(|x| ear.gain(DVec2::new(x, 0.0)));
        assert!(gains.is_sorted_by(|a, b| a > b), "{gains:?}");
        assert_eq!((gains[0], ear.gain(DVec2::new(0.0, 40.0))), (1.0, 0.0));
        let pans = [-30.0, -5.0, 0.0, 5.0, 30.0].map(|x| ear.pan(DVec2::new(x, 3.0)));
        assert_eq!((pans[0], pans[2], pans[4]), (-MOST_PAN, 0.0, MOST_PAN));
        assert!(pans[1] < 0.0 && pans[3] == -pans[1]);
    }

    #[test]
    fn no_variation_comes_twice_in_a_row_and_all_come() {
        let ear = Ear { at: DVec2::ZERO };
        let mut chance = Chance::default();
        let cue = ear.cue(Sound::StepRock, DVec2::ZERO, 1.0, 0.0);
        let mut seen = [0; 6];
        let mut last = None;
        for _ in 0..600 {
            let varied = chance.vary(cue);
            assert_ne!(Some(varied.variant), last);
            assert!((varied.pitch - 1.0).abs() <= DETUNE as f32 + 1e-6);
            last = Some(varied.variant);
            seen[varied.variant as usize] += 1;
        }
        assert!(seen.iter().all(|&count| count > 50), "{seen:?}");
    }
}
