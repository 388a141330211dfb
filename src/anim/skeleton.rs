//! Bones: who hangs from whom, where they rest, and how the mesh is bound to them.

use super::trs::Trs;
use glam::Mat4;

/// Most bones that a skeleton may have.
pub const MAX_BONES: usize = 40;

/// One bone.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// As the file names it.
    pub name: String,
    /// The bone that it hangs from: always an earlier one.
    pub parent: Option<usize>,
    /// Where it is when nothing moves it, in the parent's space.
    pub rest: Trs,
    /// From the space of the mesh to the bone's own, in the pose that the mesh was bound in.
    pub inverse_bind: Mat4,
}

/// All bones, parents before children.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skeleton {
    /// The bones.
    pub joints: Vec<Joint>,
    /// What stands above the first bone, in the file's scene.
    pub above: Mat4,
}

/// The matrices of all bones, in the space of the figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// From each bone's own space; those beyond the skeleton's bones are identities.
    pub bones: [Mat4; MAX_BONES],
}

impl Skeleton {
    /// The index of a bone by its name.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.joints.iter().position(|joint| joint.name == name)
    }

    /// The pose in which nothing moves.
    pub fn rest(&self) -> super::pose::Pose {
        let mut pose = super::pose::Pose::default();
        for (bone, joint) in pose.bones.iter_mut().zip(&self.joints) {
            *bone = joint.rest;
        }
        pose
    }

    /// Where a pose puts the bones, each by those above it.
    pub fn place(&self, pose: &super::pose::Pose) -> Placed {
        let mut placed = Placed {
            bones: [Mat4::IDENTITY; MAX_BONES],
        };
        self.place_from(pose, 0, &mut placed);
        placed
    }

    /// As [`Skeleton::place`], for the bones from an index on, where those before it are in their places already.
    pub fn place_from(&self, pose: &super::pose::Pose, first: usize, placed: &mut Placed) {
        for (i, joint) in self.joints.iter().enumerate().skip(first) {
            let above = joint.parent.map_or(self.above, |up| placed.bones[up]);
            placed.bones[i] = above * pose.bones[i].matrix();
        }
    }
}
