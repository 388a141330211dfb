//! Not all at once: no sound twice in the same instant, and never more than can be told apart.

use super::{Cue, Sound};

/// Within this time of its beginning a sound hides another of its kind, in seconds.
const HIDES: f64 = 0.045;
/// Most sounds that begin in a tick: the softest are left out.
const MOST: usize = 8;
/// What is softer is left out, as amplitude.
const SOFTEST: f32 = 0.004;
/// How many sounds are remembered: more than can begin within [`HIDES`].
const REMEMBERED: usize = 32;

/// What has begun of late.
#[derive(Clone, Debug)]
pub struct Crowd {
    recent: [(Option<Sound>, f64); REMEMBERED],
    next: usize,
}

impl Default for Crowd {
    fn default() -> Self {
        Crowd {
            recent: [(None, 0.0); REMEMBERED],
            next: 0,
        }
    }
}

impl Crowd {
    /// Leaves out what would not be heard, and puts the rest in order of time.
    pub fn thin_out(&mut self, cues: &mut Vec<Cue>) {
        cues.retain(|cue| cue.gain >= SOFTEST);
        cues.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        cues.retain(|cue| {
            let hides = |(sound, at): &(Option<Sound>, f64)| {
                *sound == Some(cue.sound) && (cue.at - at).abs() < HIDES
            };
            let is_heard = !self.recent.iter().any(hides);
            if is_heard {
                self.recent[self.next] = (Some(cue.sound), cue.at);
                self.next = (self.next + 1) % REMEMBERED;
            }
            is_heard
        });
        cues.truncate(MOST);
        cues.sort_by(|a, b| a.at.total_cmp(&b.at));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sound::Ear;
    use glam::DVec2;

    fn cue(sound: Sound, gain: f64, at: f64) -> Cue {
        Ear { at: DVec2::ZERO }.cue(sound, DVec2::ZERO, gain, at)
    }

    #[test]
    fn of_the_same_sound_in_the_same_instant_the_loudest_is_heard() {
        let mut crowd = Crowd::default();
        let mut cues = vec![
            cue(Sound::Slam, 0.2, 1.0),
            cue(Sound::Slam, 0.9, 1.001),
            cue(Sound::Bump, 0.5, 0.999),
            cue(Sound::Bump, 0.001, 0.9),
        ];
        crowd.thin_out(&mut cues);
        let heard: Vec<_> = cues.iter().map(|cue| (cue.sound, cue.gain)).collect();
        assert_eq!(heard, [(Sound::Bump, 0.5), (Sound::Slam, 0.9)]);
        let mut again = vec![cue(Sound::Slam, 1.0, 1.03), cue(Sound::Bump, 1.0, 1.1)];
        crowd.thin_out(&mut again);
        assert_eq!(again.len(), 1, "{again:?}");
    }

    #[test]
    fn the_softest_are_left_out_of_too_many() {
        let mut cues: Vec<Cue> = Sound::ALL
            .iter()
            .enumerate()
            .map(|(i, &sound)| cue(sound, 0.1 + 0.01 * i as f64, 0.0))
            .collect();
        Crowd::default().thin_out(&mut cues);
        assert_eq!(cues.len(), MOST);
        let softest = cues.iter().map(|cue| cue.gain).fold(1.0, f32::min);
        assert!(softest > 0.1 + 0.01 * (Sound::ALL.len() - MOST - 1) as f32);
    }
}
