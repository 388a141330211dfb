//! A recorded movement: keys of every bone at an even rate, sampled at any time between.

use super::pose::Pose;
use super::trs::Trs;

/// Keys a second, in every clip.
pub const RATE: f32 = 30.0;

/// A recorded movement.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    /// As the file names it.
    pub name: String,
    /// Seconds from the first key to the last.
    pub seconds: f32,
    /// Bones of one key.
    bones: usize,
    /// Key after key, each with all bones; never empty.
    keys: Vec<Trs>,
}

impl Clip {
    /// A clip of keys that each hold all bones; `None` unless there is at least one, and none is incomplete.
    pub fn new(name: &str, bones: usize, keys: Vec<Trs>) -> Option<Clip> {
        if bones == 0 || keys.is_empty() || !keys.len().is_multiple_of(bones) {
            return None;
        }
        Some(Clip {
            name: name.to_string(),
            seconds: (keys.len() / bones - 1) as f32 / RATE,
            bones,
            keys,
        })
    }

    /// The pose at a time; before the first key that one, after the last that.
    pub fn sample(&self, seconds: f32, pose: &mut Pose) {
        let last = self.keys.len() / self.bones - 1;
        let at = (seconds * RATE).clamp(0.0, last as f32);
        let key = (at as usize).min(last.saturating_sub(1));
        let share = at - key as f32;
        let row = |key: usize| &self.keys[key * self.bones..][..self.bones];
        let pairs = row(key).iter().zip(row((key + 1).min(last)));
        for (bone, (from, to)) in pose.bones.iter_mut().zip(pairs) {
            *bone = from.lerp(to, share);
        }
    }

    /// The pose at a place in the cycle, of which each whole number is one round; the last key stands for the first.
    pub fn sample_cycle(&self, rounds: f64, pose: &mut Pose) {
        self.sample(rounds.rem_euclid(1.0) as f32 * self.seconds, pose);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    fn clip() -> Clip {
        let key = |x: f32| Trs {
            place: Vec3::X * x,
            ..Trs::IDENTITY
        };
        Clip::new("test", 1, [0.0, 1.0, 4.0].map(key).to_vec()).unwrap()
    }

    #[test]
    fn between_keys_it_goes_straight() {
        let mut pose = Pose::default();
        for (keys, x) in [(-1.0, 0.0), (0.5, 0.5), (1.0, 1.0), (1.5, 2.5), (9.0, 4.0)] {
            clip().sample(keys / RATE, &mut pose);
            assert!((pose.bones[0].place.x - x).abs() < 1e-5, "{keys} keys");
        }
    }

    #[test]
    fn a_cycle_comes_round() {
        let mut pose = Pose::default();
        for rounds in [0.25, 5.25, -0.75] {
            clip().sample_cycle(rounds, &mut pose);
            assert!((pose.bones[0].place.x - 0.5).abs() < 1e-5, "{rounds}");
        }
    }

    #[test]
    fn incomplete_keys_make_no_clip() {
        assert_eq!(Clip::new("test", 2, vec![Trs::IDENTITY; 3]), None);
        assert_eq!(Clip::new("test", 2, Vec::new()), None);
    }
}
