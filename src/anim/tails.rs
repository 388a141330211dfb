//! Cape, lantern and crest: where they are held, what they may not go through, and how their bones follow.

use super::ik::arc;
use super::pose::Pose;
use super::rig::{Bone, Rig};
use super::skeleton::Placed;
use super::springs::{Hold, Stuff, Thread};
use glam::{DVec2, Mat4, Quat, Vec2, Vec3};

const CAPE: [Bone; 5] = [
    Bone::Cape1,
    Bone::Cape2,
    Bone::Cape3,
    Bone::Cape4,
    Bone::Cape5,
];

/// Cloth.
const CLOTH: Stuff = Stuff {
    weight: 14.0,
    drag: 4.5,
    stiffness: 12.0,
    damping: 2.5,
    bend: 0.80,
};
/// Brass and glass on a ring.
const BRASS: Stuff = Stuff {
    weight: 19.0,
    drag: 0.5,
    stiffness: 60.0,
    damping: 9.0,
    bend: 0.0,
};
/// Stiff hair.
const HAIR: Stuff = Stuff {
    weight: 1.0,
    drag: 5.0,
    stiffness: 420.0,
    damping: 14.0,
    bend: 0.0,
};
/// From where the lantern hangs to its weight, and from the crest's foot to its end, m.
const LANTERN: Vec3 = Vec3::new(0.0, -0.2, 0.0);
const CREST: Vec3 = Vec3::new(-0.17, 0.04, 0.0);
/// How far the cape stays behind the middle of the trunk and of a thigh, m.
const TRUNK: f32 = 0.175;
const THIGH: f32 = 0.11;
/// How far it stays above the ground, m.
const HEM: f32 = 0.03;
/// What is further behind the body's front than this is not pushed back through it, m.
const THROUGH: f32 = 0.4;
/// The evening's wind, m/s, and what it varies by.
const WIND: (f32, f32) = (0.9, 0.7);
/// How much of the speed against the air beats the cloth up and down.
const FLUTTER: f32 = 0.08;

/// The body that the cape may not go through: as seen from aside, forward and up, about the body's foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Where it looks, in the level's axes.
    pub forward: Vec3,
    /// Hips, neck, left knee, right knee.
    pub joints: [Vec3; 4],
    /// Rise over run of the ground, if it stands on some.
    pub ground: Option<f32>,
}

impl Outline {
    /// A point of the cape, put behind the body and over the ground if it is not.
    fn keep(&self, p: Vec3) -> Vec3 {
        let flat = |p: Vec3| Vec2::new(p.dot(self.forward), p.y);
        let [hips, neck, left, right] = self.joints.map(flat);
        let start = flat(p);
        let mut at = start;
        for (from, to, thick) in [
            (neck, hips, TRUNK),
            (hips, left, THIGH),
            (hips, right, THIGH),
        ] {
            let along = (to - from).normalize_or(Vec2::NEG_Y);
            let back = Vec2::new(along.y, -along.x);
            let (way, beyond) = ((at - from).dot(along), (at - from).dot(back));
            if way > 0.0 && way < from.distance(to) + thick && beyond > -THROUGH && beyond < thick {
                at += back * (thick - beyond);
            }
        }
        let mut kept = p + self.forward * (at.x - start.x) + Vec3::Y * (at.y - start.y);
        if let Some(slope) = self.ground {
            kept.y = kept.y.max(slope * kept.x + HEM);
        }
        kept
    }
}

/// All that hangs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tails {
    cape: Thread<5>,
    lantern: Thread<1>,
    crest: Thread<1>,
}

/// When and where a figure is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Seconds.
    pub time: f64,
    /// Its foot in the level, m.
    pub foot: DVec2,
    /// How far that has come since the last moment.
    pub moved: Vec3,
    /// m/s.
    pub velocity: Vec3,
}

/// The air at a place and a time, m/s, and how it beats: gusts that run along the level.
fn wind(moment: &Moment) -> (Vec3, f32) {
    let (time, x) = (moment.time.rem_euclid(3600.0) as f32, moment.foot.x as f32);
    let gust = (0.7 * time - 0.11 * x).sin() + 0.5 * (1.9 * time - 0.23 * x).sin();
    let against = Vec3::new(WIND.0 + WIND.1 * gust, 0.0, 0.0);
    let speed = (moment.velocity - against).length();
    (against, speed * FLUTTER)
}

/// Where the threads are held by a pose whose bones are `placed` by the matrix `stand`.
fn holds(
    rig: &Rig,
    placed: &Placed,
    stand: &Mat4,
    (air, beat): (Vec3, f32),
) -> (Hold<5>, Hold<1>, Hold<1>) {
    let at = |bone: usize, offset: Vec3| (*stand * placed.bones[bone]).transform_point3(offset);
    let cape = CAPE.map(|bone| rig.bone(bone));
    let joints = &rig.model.skeleton.joints;
    let mut rest = [Vec3::ZERO; 5];
    for (i, point) in rest.iter_mut().enumerate() {
        // Behind the last bone the cape goes on as before it.
        let next = cape[(i + 1).min(4)];
        *point = at(cape[i], joints[next].rest.place);
    }
    let single = |bone: usize, offset: Vec3| Hold {
        anchor: at(bone, Vec3::ZERO),
        rest: [at(bone, offset)],
        wind: air,
        beat,
    };
    let crest = rig.crest.unwrap_or_else(|| rig.bone(Bone::Head));
    let cape = Hold {
        anchor: at(cape[0], Vec3::ZERO),
        rest,
        wind: air,
        beat,
    };
    let mut lantern = single(rig.bone(Bone::Lantern), LANTERN);
    lantern.rest = [lantern.anchor + LANTERN]; // it hangs, whatever the hand does
    (cape, lantern, single(crest, CREST))
}

impl Tails {
    /// All hanging still.
    pub fn new(rig: &Rig, placed: &Placed, stand: &Mat4, moment: &Moment) -> Tails {
        let (cape, lantern, crest) = holds(rig, placed, stand, wind(moment));
        Tails {
            cape: Thread::new(moment.time, cape),
            lantern: Thread::new(moment.time, lantern),
            crest: Thread::new(moment.time, crest),
        }
    }

    /// Lets time pass.
    pub fn advance(
        &mut self,
        rig: &Rig,
        placed: &Placed,
        stand: &Mat4,
        moment: &Moment,
        outline: &Outline,
    ) {
        let (cape, lantern, crest) = holds(rig, placed, stand, wind(moment));
        let (time, moved) = (moment.time, moment.moved);
        self.cape
            .advance(time, cape, moved, &CLOTH, |p| outline.keep(p));
        self.lantern.advance(time, lantern, moved, &BRASS, |p| p);
        self.crest.advance(time, crest, moved, &HAIR, |p| p);
    }

    /// Turns the bones to where the threads are. `stand` must not stretch.
    pub fn bend(&self, rig: &Rig, placed: &mut Placed, stand: &Mat4, pose: &mut Pose) {
        let back = stand.inverse();
        let joints = &rig.model.skeleton.joints;
        let cape = CAPE.map(|bone| rig.bone(bone));
        let points = self.cape.points();
        let mut from = stand.transform_point3(placed.bones[cape[0]].transform_point3(Vec3::ZERO));
        let mut turn = |bone: usize, rest: Vec3, from: Vec3, to: Vec3| {
            let way = back.transform_vector3(to - from);
            let above = joints[bone]
                .parent
                .map_or(Mat4::IDENTITY, |up| placed.bones[up]);
            let above = Quat::from_mat4(&above);
            let hung = arc(above * rest, way) * above;
            pose.bones[bone].turn = (above.conjugate() * hung).normalize();
            let parent = joints[bone]
                .parent
                .map_or(rig.model.skeleton.above, |up| placed.bones[up]);
            placed.bones[bone] = parent * pose.bones[bone].matrix();
            stand.transform_point3(placed.bones[bone].transform_point3(rest))
        };
        for i in 0..CAPE.len() {
            let rest = joints[cape[(i + 1).min(4)]].rest.place;
            from = turn(cape[i], rest, from, points[i]);
        }
        let lantern = rig.bone(Bone::Lantern);
        let ring = self.lantern.anchor();
        turn(lantern, LANTERN, ring, self.lantern.points()[0]);
        if let Some(crest) = rig.crest {
            turn(crest, CREST, self.crest.anchor(), self.crest.points()[0]);
        }
    }

    /// Whether all points are finite numbers.
    pub fn is_finite(&self) -> bool {
        let ends = [self.lantern.points()[0], self.crest.points()[0]];
        self.cape
            .points()
            .iter()
            .chain(&ends)
            .all(|p| p.is_finite())
    }
}
