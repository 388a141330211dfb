//! The hero's movements as values: a model read from a .glb file, poses sampled from its clips and mixed, a figure that
//! goes from one to the next by what its body does.
//!
//! The figure stands with its foot at the origin, looks along +x, its right hand at +z; lengths are metres, angles radians.
//! Nothing here draws, opens a file or reads a clock, and nothing but reading a model allocates.

mod aim;
mod beside;
mod clip;
mod fade;
mod feet;
mod figure;
mod glb;
mod ik;
mod model;
mod moves;
mod numbers;
mod pose;
mod rig;
mod shown;
mod skeleton;
mod springs;
mod state;
mod tails;
mod trs;

pub use clip::{Clip, RATE};
pub use feet::Ground;
pub use figure::Figure;
pub use glb::Glb;
pub use model::{Model, ModelError, Vertex};
pub use moves::{Leap, Moves, Support};
pub use numbers::Numbers;
pub use pose::{Mask, Pose};
pub use rig::{Act, Bone, Leg, Rig, Stride};
pub use shown::Shown;
pub use skeleton::{Joint, MAX_BONES, Placed, Skeleton};
pub use state::{Kind, State, run_share_at};
pub use trs::{Trs, angle_between, blend_turns};
