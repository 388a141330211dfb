//! What is shown of the hero: his pose, where it stands, and the matrices that the mesh is moved by.

use super::figure::widths;
use super::pose::Pose;
use super::rig::{Bone, Rig};
use super::skeleton::MAX_BONES;
use glam::{DVec2, Mat4, Quat, Vec3};

/// Below the ring of the lantern is its light, m.
const FLAME: Vec3 = Vec3::new(0.0, -0.16, 0.0);

/// What is shown at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// Where each bone is.
    pub pose: Pose,
    /// The body's foot in the level, m.
    pub foot: DVec2,
    /// How far the figure is beside it, m.
    pub offset: Vec3,
    /// Its turn about the upright axis: 0 looks right, -pi left.
    pub yaw: f32,
    /// Factor upwards.
    pub squash: f32,
}

impl Shown {
    /// A pose where the body is, looking right.
    pub fn resting(pose: Pose, foot: DVec2) -> Shown {
        Shown {
            pose,
            foot,
            offset: Vec3::ZERO,
            yaw: 0.0,
            squash: 1.0,
        }
    }

    /// The moment at a share (0 to 1) of the way from another, between two ticks.
    pub fn since(&self, before: &Shown, share: f64) -> Shown {
        let part = share as f32;
        let mut pose = before.pose;
        pose.blend(&self.pose, part);
        let mix = |a: f32, b: f32| a + (b - a) * part;
        Shown {
            pose,
            foot: before.foot.lerp(self.foot, share),
            offset: before.offset.lerp(self.offset, part),
            yaw: mix(before.yaw, self.yaw),
            squash: mix(before.squash, self.squash),
        }
    }

    /// From the figure's space to the level's, about the foot.
    pub fn stand(&self) -> Mat4 {
        let turned = Mat4::from_rotation_translation(Quat::from_rotation_y(self.yaw), self.offset);
        turned * Mat4::from_scale(widths(self.squash))
    }

    /// Where all bones are, in the level's axes about the foot.
    pub fn bones(&self, rig: &Rig) -> [Mat4; MAX_BONES] {
        let stand = self.stand();
        let placed = rig.model.skeleton.place(&self.pose);
        placed.bones.map(|bone| stand * bone)
    }

    /// The matrices that move the mesh out of the pose that it was bound in, in the level's axes about the foot.
    pub fn skin(&self, rig: &Rig) -> [Mat4; MAX_BONES] {
        let mut bones = self.bones(rig);
        for (bone, joint) in bones.iter_mut().zip(&rig.model.skeleton.joints) {
            *bone *= joint.inverse_bind;
        }
        bones
    }

    /// Where the lantern shines, about the foot.
    pub fn lantern(&self, rig: &Rig) -> Vec3 {
        self.bones(rig)[rig.bone(Bone::Lantern)].transform_point3(FLAME)
    }
}
