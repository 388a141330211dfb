//! The hero's model, checked for all that moving him needs: bones, clips and strides by name, measures of the legs.

use super::clip::Clip;
use super::model::{Model, ModelError};
use super::pose::{Mask, Pose};
use super::skeleton::MAX_BONES;
use glam::Vec3;

macro_rules! named {
    ($(#[$doc:meta])* $group:ident, $what:literal { $($(#[$line:meta])* $name:ident = $text:literal,)+ }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        pub enum $group {
            $($(#[$line])* #[doc = concat!("`", $text, "`")] $name,)+
        }

        impl $group {
            /// All, in their order.
            pub const ALL: &[$group] = &[$($group::$name,)+];
            const NAMES: &[&str] = &[$($text,)+];

            /// As the file names it.
            pub fn name(self) -> &'static str {
                Self::NAMES[self as usize]
            }
        }
    };
}

named! {
    /// Bones that the hero must have; `.l` and `.r` are his left and right side.
    Bone, "bone" {
        Root = "root", Hips = "hips", Spine = "spine", Chest = "chest", Neck = "neck", Head = "head",
        UpperArmLeft = "upper_arm.l", UpperArmRight = "upper_arm.r", ForearmLeft = "forearm.l", ForearmRight = "forearm.r",
        HandLeft = "hand.l", HandRight = "hand.r", ThighLeft = "thigh.l", ThighRight = "thigh.r", ShinLeft = "shin.l",
        ShinRight = "shin.r", FootLeft = "foot.l", FootRight = "foot.r", Cape1 = "cape.1", Cape2 = "cape.2",
        Cape3 = "cape.3", Cape4 = "cape.4", Cape5 = "cape.5", Lantern = "lantern", Sword = "sword",
    }
}

named! {
    /// Clips that the hero must have.
    Act, "clip" {
        Idle = "idle", Walk = "walk", Run = "run", Turn = "turn", Jump = "jump", Rise = "rise", Fall = "fall",
        LandSoft = "land_soft", LandHard = "land_hard", Crouch = "crouch", Crawl = "crawl", WallSlide = "wall_slide",
        LedgeHang = "ledge_hang", LedgeClimb = "ledge_climb", Ladder = "ladder", ClimbWall = "climb_wall", Roll = "roll",
        Death = "death",
    }
}

named! {
    /// Metres per cycle of what goes on by itself, left as numbers in the file.
    Stride, "number" {
        Walk = "stride_walk", Run = "stride_run", Crawl = "stride_crawl", Ladder = "rise_ladder", ClimbWall = "rise_climb_wall",
    }
}

/// A bone of tufts that the file may have: it is moved by the wind.
const CREST: &str = "crest";
/// How the names of bones begin that springs turn.
const HANGS: [&str; 3] = ["cape", "lantern", CREST];

/// A leg's bones and lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leg {
    /// Indices of thigh, shin and foot.
    pub bones: [usize; 3],
    /// From hip to knee and from knee to ankle, m.
    pub lengths: [f32; 2],
    /// Height of the ankle over the flat sole, m.
    pub ankle: f32,
}

/// The hero's model, ready to be moved.
#[derive(Clone, Debug, PartialEq)]
pub struct Rig {
    /// The file's content.
    pub model: Model,
    /// The left and the right leg.
    pub legs: [Leg; 2],
    /// All above the hips, and what hangs from there.
    pub upper: Mask,
    /// All that muscles turn: what hangs is left out.
    pub muscles: Mask,
    /// The crest's bone, if there is one.
    pub crest: Option<usize>,
    bones: [usize; Bone::ALL.len()],
    clips: [usize; Act::ALL.len()],
    strides: [f32; Stride::ALL.len()],
}

impl Rig {
    /// Reads the hero; `file` is what errors call it.
    ///
    /// # Errors
    /// The bytes are no model, or one of the bones, clips and numbers above is missing.
    pub fn read(file: &str, bytes: &[u8]) -> Result<Rig, ModelError> {
        let model = Model::read(file, bytes)?;
        let missing = |kind: &str, name: &str| ModelError {
            file: file.to_string(),
            part: format!("{kind} \"{name}\""),
            why: "is missing".into(),
        };
        let (mut bones, mut clips) = ([0; Bone::ALL.len()], [0; Act::ALL.len()]);
        for (index, bone) in bones.iter_mut().zip(Bone::NAMES) {
            let found = model.skeleton.find(bone);
            *index = found.ok_or_else(|| missing("bone", bone))?;
        }
        for (index, act) in clips.iter_mut().zip(Act::NAMES) {
            let found = model.clips.iter().position(|clip| clip.name == *act);
            *index = found.ok_or_else(|| missing("clip", act))?;
        }
        let mut strides = [0.0; Stride::ALL.len()];
        for (metres, name) in strides.iter_mut().zip(Stride::NAMES) {
            let found = model.extra(name).filter(|&metres| metres > 0.0);
            *metres = found.ok_or_else(|| missing("number above zero", name))?;
        }
        let [left, right] = [
            [Bone::ThighLeft, Bone::ShinLeft, Bone::FootLeft],
            [Bone::ThighRight, Bone::ShinRight, Bone::FootRight],
        ]
        .map(|leg| leg.map(|bone| bones[bone as usize]));
        for leg in [left, right] {
            for (above, below) in [(leg[0], leg[1]), (leg[1], leg[2])] {
                if model.skeleton.joints[below].parent != Some(above) {
                    return Err(ModelError {
                        file: file.to_string(),
                        part: format!("bone \"{}\"", model.skeleton.joints[below].name),
                        why: format!(
                            "does not hang from \"{}\"",
                            model.skeleton.joints[above].name
                        ),
                    });
                }
            }
        }
        Ok(Rig {
            legs: [left, right].map(|bones| measure(&model, bones)),
            upper: below(&model, bones[Bone::Spine as usize]),
            muscles: muscles(&model),
            crest: model.skeleton.find(CREST),
            bones,
            clips,
            strides,
            model,
        })
    }

    /// The index of a bone.
    pub fn bone(&self, bone: Bone) -> usize {
        self.bones[bone as usize]
    }

    /// A clip.
    pub fn clip(&self, act: Act) -> &Clip {
        &self.model.clips[self.clips[act as usize]]
    }

    /// Metres per cycle.
    pub fn stride(&self, stride: Stride) -> f32 {
        self.strides[stride as usize]
    }

    /// The pose of a clip at a time.
    pub fn sample(&self, act: Act, seconds: f64) -> Pose {
        let mut pose = Pose::default();
        self.clip(act).sample(seconds as f32, &mut pose);
        pose
    }

    /// The pose of a clip at a place in its cycle.
    pub fn cycle(&self, act: Act, rounds: f64) -> Pose {
        let mut pose = Pose::default();
        self.clip(act).sample_cycle(rounds, &mut pose);
        pose
    }
}

fn measure(model: &Model, bones: [usize; 3]) -> Leg {
    let placed = model.skeleton.place(&model.skeleton.rest());
    let at = bones.map(|bone| placed.bones[bone].transform_point3(Vec3::ZERO));
    Leg {
        bones,
        lengths: [at[0].distance(at[1]), at[1].distance(at[2])],
        ankle: at[2].y,
    }
}

/// All bones but those that hang freely.
fn muscles(model: &Model) -> Mask {
    let mut mask = Mask {
        shares: [1.0; MAX_BONES],
    };
    for (share, joint) in mask.shares.iter_mut().zip(&model.skeleton.joints) {
        let hangs = HANGS.iter().any(|name| joint.name.starts_with(name));
        *share = f32::from(u8::from(!hangs));
    }
    mask
}

/// A bone and all that hangs from it.
fn below(model: &Model, top: usize) -> Mask {
    let mut mask = Mask {
        shares: [0.0; MAX_BONES],
    };
    for (i, joint) in model.skeleton.joints.iter().enumerate() {
        let hangs = joint.parent.is_some_and(|up| mask.shares[up] > 0.0);
        mask.shares[i] = f32::from(u8::from(i == top || hangs));
    }
    mask
}
