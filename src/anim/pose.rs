//! A pose: where each bone is in its parent's space; and how poses are mixed.

use super::skeleton::MAX_BONES;
use super::trs::{Trs, angle_between, blend_turns};
use glam::Quat;

/// Where every bone is, each in the space of the one above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// In the order of the skeleton; what is beyond its bones rests.
    pub bones: [Trs; MAX_BONES],
}

/// How much each bone takes part in something, 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mask {
    /// In the order of the skeleton.
    pub shares: [f32; MAX_BONES],
}

impl Default for Pose {
    fn default() -> Pose {
        Pose {
            bones: [Trs::IDENTITY; MAX_BONES],
        }
    }
}

impl Pose {
    /// Goes a share (0 to 1) of the way to another pose.
    pub fn blend(&mut self, to: &Pose, share: f32) {
        if share > 0.0 {
            for (bone, to) in self.bones.iter_mut().zip(&to.bones) {
                *bone = bone.lerp(to, share);
            }
        }
    }

    /// Lets no bone of the mask turn further than so many radians from what it was.
    pub fn turn_at_most(&mut self, angle: f32, was: &Pose, mask: &Mask) {
        for ((bone, was), part) in self.bones.iter_mut().zip(&was.bones).zip(mask.shares) {
            let turn = angle_between(was.turn, bone.turn);
            if part > 0.0 && turn > angle {
                bone.turn = was.turn.slerp(bone.turn, angle / turn);
            }
        }
    }

    /// Adds a share of what one pose has beyond another: its turns after the bone's own, its places beside them.
    pub fn add(&mut self, more: &Pose, beyond: &Pose, share: f32, mask: &Mask) {
        let pairs = more.bones.iter().zip(&beyond.bones);
        for ((bone, (more, base)), part) in self.bones.iter_mut().zip(pairs).zip(mask.shares) {
            let share = share * part;
            if share > 0.0 {
                let turn = base.turn.conjugate() * more.turn;
                bone.turn = (bone.turn * blend_turns(Quat::IDENTITY, turn, share)).normalize();
                bone.place += (more.place - base.place) * share;
                bone.size += (more.size - base.size) * share;
            }
        }
    }

    /// Whether all numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.bones.iter().all(Trs::is_finite)
    }
}

#[cfg(test)]
mod tests {
    use super::super::trs::angle_between;
    use super::*;
    use glam::Vec3;

    fn bent(angle: f32) -> Pose {
        let mut pose = Pose::default();
        for bone in &mut pose.bones {
            bone.turn = Quat::from_rotation_z(angle);
            bone.place = Vec3::X * angle;
        }
        pose
    }

    #[test]
    fn what_is_added_comes_on_top() {
        let everything = Mask {
            shares: [1.0; MAX_BONES],
        };
        let mut pose = bent(0.5);
        pose.add(&bent(0.4), &bent(0.1), 1.0, &everything);
        assert!(angle_between(pose.bones[3].turn, Quat::from_rotation_z(0.8)) < 1e-5);
        assert!((pose.bones[3].place.x - 0.8).abs() < 1e-6);
    }

    #[test]
    fn a_turn_that_is_too_far_goes_as_far_as_it_may() {
        let mut mask = Mask {
            shares: [1.0; MAX_BONES],
        };
        mask.shares[2] = 0.0;
        let (mut pose, mut small) = (bent(1.0), bent(0.25));
        pose.turn_at_most(0.3, &bent(0.0), &mask);
        small.turn_at_most(0.3, &bent(0.0), &mask);
        let angle = |pose: &Pose, bone: usize| angle_between(pose.bones[bone].turn, Quat::IDENTITY);
        assert!((angle(&pose, 1) - 0.3).abs() < 1e-5, "too far");
        assert!((angle(&pose, 2) - 1.0).abs() < 1e-5, "spared by the mask");
        assert_eq!(small, bent(0.25), "not too far");
    }
}
