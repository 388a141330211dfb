//! The hero's pose: a small knight of rigid parts, moved by what the body does rather than by recorded clips.
//!
//! The figure stands with its foot at the origin, looks along +x, its right hand at +z; lengths are metres, angles radians.
//! Feet are placed first and the legs follow by two-bone inverse kinematics, so that they stand on slopes.

use glam::{Mat4, Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, TAU};

/// Parts of the figure, as indices of [`Pose::parts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Part {
    /// Hips and skirt of the armour.
    Hips,
    /// Chest and shoulders.
    Chest,
    /// Helmet.
    Head,
    /// Left thigh.
    ThighLeft,
    /// Left shin and foot.
    ShinLeft,
    /// Right thigh.
    ThighRight,
    /// Right shin and foot.
    ShinRight,
    /// Left upper arm.
    ArmLeft,
    /// Left forearm, which holds the lantern.
    ForearmLeft,
    /// Right upper arm.
    ArmRight,
    /// Right forearm with the sword.
    ForearmRight,
    /// The lantern, hanging from the left hand.
    Lantern,
    /// First strip of the cape, at the shoulders; the others follow it.
    Cape,
}

/// Strips of the cape.
pub const CAPE: usize = 4;
/// Number of parts.
pub const PARTS: usize = Part::Cape as usize + CAPE;
/// Length of thigh and of shin with foot.
pub const BONE: f32 = 0.37;
/// Length of upper arm and of forearm.
pub const ARM: f32 = 0.25;
/// Length of a strip of the cape.
pub const STRIP: f32 = 0.24;
/// Height of the hips of the standing figure.
const HIPS: f32 = 0.70;
/// From the hips to the shoulders, and to the neck.
const SHOULDERS: f32 = 0.50;
/// Metres of ground that a full cycle of the run covers.
const STRIDE: f32 = 2.5;
/// How far the figure is turned towards the viewer when it looks left or right.
const THREE_QUARTERS: f32 = 0.5;

/// What the body is doing at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moves {
    /// Seconds, for breath and wind.
    pub time: f64,
    /// Place of the foot along the level, in metres: drives the steps.
    pub x: f64,
    /// Metres per second.
    pub velocity: Vec2,
    /// -1 left, 1 right.
    pub facing: f32,
    /// Normal of the ground or wall in contact; zero in the air.
    pub normal: Vec2,
    /// What carries it.
    pub support: Support,
    /// In the smaller size.
    pub crouched: bool,
    /// Seconds since the last landing, and the speed into the ground then.
    pub landed: (f32, f32),
}

/// What carries a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// Nothing.
    Air,
    /// Ground.
    Ground,
    /// A wall or a steep slope that it slides along.
    Wall,
}

/// What follows the body late: the cape, the turn, the change of stance. Kept from picture to picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Memory {
    time: f64,
    facing: f32,
    wind: Vec2,
    crouch: f32,
    ground: f32,
    slope: f32,
}

/// Where each part is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// From the part's own space to the space of the foot.
    pub parts: [Mat4; PARTS],
}

impl Pose {
    /// Where the lantern shines from, relative to the foot.
    pub fn lantern(&self) -> Vec3 {
        self.parts[Part::Lantern as usize].transform_point3(Vec3::NEG_Y * 0.14)
    }
}

/// Rise over run of the ground; level on walls and in the air.
fn slope(moves: &Moves) -> f32 {
    if moves.support == Support::Ground && moves.normal.y > 0.3 {
        -moves.normal.x / moves.normal.y
    } else {
        0.0
    }
}

impl Memory {
    /// A body that has been doing this for long.
    pub fn new(moves: &Moves) -> Memory {
        let flag = |on: bool| f32::from(u8::from(on));
        Memory {
            time: moves.time,
            facing: moves.facing,
            wind: moves.velocity,
            crouch: flag(moves.crouched),
            ground: flag(moves.support == Support::Ground),
            slope: slope(moves),
        }
    }

    /// Lets time pass up to a moment. A jump in time, either way, forgets everything.
    pub fn follow(&mut self, moves: &Moves) {
        let passed = moves.time - self.time;
        let now = Memory::new(moves);
        if !(0.0..0.25).contains(&passed) {
            *self = now;
            return;
        }
        let share = |rate: f32| 1.0 - (-rate * passed as f32).exp();
        let towards = |from: f32, to: f32, rate: f32| from + (to - from) * share(rate);
        self.time = now.time;
        self.facing = towards(self.facing, now.facing, 22.0);
        self.wind += (now.wind - self.wind) * share(9.0);
        self.crouch = towards(self.crouch, now.crouch, 20.0);
        self.ground = towards(
            self.ground,
            now.ground,
            if now.ground > 0.5 { 40.0 } else { 16.0 },
        );
        self.slope = towards(self.slope, now.slope, 25.0);
    }

    /// The pose at the moment that was last followed.
    pub fn pose(&self, moves: &Moves) -> Pose {
        let stance = Stance::new(self, moves);
        let turn = Mat4::from_rotation_y(-FRAC_PI_2 + self.facing * (FRAC_PI_2 - THREE_QUARTERS));
        let mut parts = [Mat4::IDENTITY; PARTS];
        stance.legs(&mut parts);
        stance.trunk(&mut parts);
        stance.arms(&mut parts);
        stance.cape(self, &mut parts);
        Pose {
            parts: parts.map(|part| turn * part),
        }
    }
}

/// The numbers that the parts are placed by, in the plane of the run: x forward, y up.
struct Stance {
    time: f32,
    /// 0 standing to 1 running at full speed.
    run: f32,
    /// Angle of the cycle of steps.
    phase: f32,
    /// 1 on the ground, 0 in the air.
    ground: f32,
    /// -1 falling fast to 1 rising fast.
    rise: f32,
    /// 1 pressed together by a landing.
    squash: f32,
    /// 1 against a wall.
    wall: f32,
    hips: Vec2,
    /// How far the trunk leans forward.
    lean: f32,
    feet: [Vec2; 2],
}

impl Stance {
    fn new(memory: &Memory, moves: &Moves) -> Stance {
        let side = if moves.facing < 0.0 { -1.0 } else { 1.0 };
        let forward = moves.velocity.x * side;
        let run = (forward.abs() / 7.0).min(1.0) * memory.ground;
        let phase =
            ((moves.x / f64::from(STRIDE)).rem_euclid(1.0) as f32 * side).rem_euclid(1.0) * TAU;
        let squash =
            (-9.0 * moves.landed.0).exp() * (moves.landed.1 / 18.0).min(1.0) * memory.ground;
        let wall = f32::from(u8::from(moves.support == Support::Wall));
        let mut stance = Stance {
            time: moves.time.rem_euclid(3600.0) as f32,
            run,
            phase,
            ground: memory.ground,
            rise: (moves.velocity.y / 12.0).clamp(-1.0, 1.0),
            squash,
            wall,
            hips: Vec2::ZERO,
            lean: 0.05 + 0.26 * run * forward.signum() + 0.55 * memory.crouch + 0.25 * squash
                - 0.2 * wall,
            feet: [Vec2::ZERO; 2],
        };
        let slope = memory.slope * side;
        stance.feet = [stance.foot(0.0, slope), stance.foot(0.5, slope)];
        let breath = (stance.time * 2.1).sin() * 0.008 * (1.0 - run);
        let bob = (2.0 * phase).sin().abs() * 0.05 * run;
        let drop = 0.26 * memory.crouch + 0.2 * squash + 0.03 * run + 0.12 * slope.abs();
        let forward_of_feet = 0.05 * run - 0.1 * memory.crouch;
        stance.hips = Vec2::new(forward_of_feet, HIPS - drop + bob + breath);
        stance
    }

    /// Where a foot goes; `ahead` is its lead in the cycle of steps.
    fn foot(&self, ahead: f32, slope: f32) -> Vec2 {
        let (sin, cos) = (self.phase + ahead * TAU).sin_cos();
        let spread = if ahead > 0.0 { -1.0 } else { 1.0 };
        let standing = Vec2::new(0.13 * spread, 0.0);
        // The sole goes back at ground speed while it is down, and forward in an arc.
        let running = Vec2::new(-0.36 * cos, 0.26 * (-sin).max(0.0));
        let walked = standing.lerp(running, (self.run * 1.6).min(1.0));
        let grounded = walked + Vec2::Y * slope * walked.x;
        let rising = if ahead > 0.0 {
            Vec2::new(-0.24, 0.02)
        } else {
            Vec2::new(0.22, 0.34)
        };
        let falling = if ahead > 0.0 {
            Vec2::new(-0.2, 0.16)
        } else {
            Vec2::new(0.2, 0.06)
        };
        let flying = falling.lerp(rising, self.rise * 0.5 + 0.5);
        let sliding = if ahead > 0.0 {
            Vec2::new(0.1, 0.0)
        } else {
            Vec2::new(0.22, 0.26)
        };
        flying.lerp(sliding, self.wall).lerp(grounded, self.ground)
    }

    fn legs(&self, parts: &mut [Mat4; PARTS]) {
        for (side, foot, thigh, shin) in [
            (-1.0, self.feet[0], Part::ThighLeft, Part::ShinLeft),
            (1.0, self.feet[1], Part::ThighRight, Part::ShinRight),
        ] {
            let knee = knee(self.hips, foot);
            let depth = 0.105 * side;
            parts[thigh as usize] = bone(self.hips, knee, depth);
            parts[shin as usize] = bone(knee, foot, depth);
        }
    }

    fn trunk(&self, parts: &mut [Mat4; PARTS]) {
        let hips = Mat4::from_translation(self.hips.extend(0.0));
        let twist = 0.16 * self.run * self.phase.cos();
        let sway = Mat4::from_rotation_y(twist) * Mat4::from_rotation_z(-self.lean);
        parts[Part::Hips as usize] =
            hips * Mat4::from_rotation_y(-twist) * Mat4::from_rotation_z(-self.lean * 0.4);
        parts[Part::Chest as usize] = hips * sway;
        let neck = hips * sway * Mat4::from_translation(Vec3::Y * SHOULDERS);
        let nod = self.lean * 0.75
            + 0.12 * self.rise * (1.0 - self.ground)
            + 0.02 * (self.time * 1.3).sin();
        parts[Part::Head as usize] =
            neck * Mat4::from_rotation_z(nod) * Mat4::from_rotation_y(-twist);
    }

    /// Upper arms and forearms as angles forward from hanging down; the left hand carries the lantern ahead.
    fn arms(&self, parts: &mut [Mat4; PARTS]) {
        let chest = parts[Part::Chest as usize];
        let (air, swing) = (1.0 - self.ground, self.run * self.phase.cos());
        let spread = (air * (0.5 - 0.5 * self.rise)).max(self.squash * 0.6);
        let breath = 0.03 * (self.time * 2.1 + 0.6).sin();
        let left = (
            0.55 + 0.45 * swing + 0.7 * air + breath,
            0.75 + 0.3 * self.run,
        );
        let right = (
            -0.25 - 0.75 * swing - 0.5 * spread + 0.9 * self.wall - breath,
            0.5 + 0.7 * self.run,
        );
        for (side, (angle, bend), arm, forearm) in [
            (-1.0, left, Part::ArmLeft, Part::ForearmLeft),
            (1.0, right, Part::ArmRight, Part::ForearmRight),
        ] {
            let shoulder = Mat4::from_translation(Vec3::new(0.0, SHOULDERS - 0.06, 0.255 * side));
            let out = Mat4::from_rotation_x(-side * (0.12 + 0.9 * spread));
            let upper = chest * shoulder * out * Mat4::from_rotation_z(angle);
            parts[arm as usize] = upper;
            parts[forearm as usize] =
                upper * Mat4::from_translation(Vec3::NEG_Y * ARM) * Mat4::from_rotation_z(bend);
        }
        let hand = parts[Part::ForearmLeft as usize].transform_point3(Vec3::NEG_Y * ARM);
        let dangle = -0.35 * swing + 0.1 * (self.time * 2.7).sin();
        parts[Part::Lantern as usize] =
            Mat4::from_translation(hand) * Mat4::from_rotation_z(dangle);
    }

    /// A chain of strips that the wind of the motion lifts, each a little later than the one above.
    fn cape(&self, memory: &Memory, parts: &mut [Mat4; PARTS]) {
        let side = if memory.facing < 0.0 { -1.0 } else { 1.0 };
        // Air that streams past: back when running, up when falling. Weight pulls down.
        let pull =
            Vec2::new(-memory.wind.x * side * 0.42, -memory.wind.y * 0.34) + Vec2::new(-0.35, -2.6);
        let stream = pull.x.abs().atan2(-pull.y);
        let flutter = (memory.wind.length() / 9.0).min(1.0);
        let mut joint =
            parts[Part::Chest as usize].transform_point3(Vec3::new(-0.15, SHOULDERS - 0.02, 0.0));
        for strip in 0..CAPE {
            let late = strip as f32;
            let wave = (self.time * (3.0 + 9.0 * flutter) - late * 1.15).sin()
                * (0.05 + 0.13 * flutter)
                * (0.4 + 0.3 * late);
            let angle = stream * (0.72 + 0.1 * late) + wave + 0.1;
            let place = Mat4::from_translation(joint) * Mat4::from_rotation_z(-angle);
            parts[Part::Cape as usize + strip] = place;
            joint = place.transform_point3(Vec3::NEG_Y * STRIP);
        }
    }
}

/// The knee between hip and foot, bent forward; the foot is pulled in where the leg is too short.
fn knee(hip: Vec2, foot: Vec2) -> Vec2 {
    let way = foot - hip;
    let length = way.length().clamp(0.05, 2.0 * BONE - 1e-3);
    let along = way.normalize_or(Vec2::NEG_Y);
    let aside = (BONE * BONE - length * length / 4.0).max(0.0).sqrt();
    hip + along * (length / 2.0) + along.perp() * aside
}

/// A bone that hangs from one point towards another.
fn bone(from: Vec2, to: Vec2, depth: f32) -> Mat4 {
    let way = to - from;
    Mat4::from_translation(from.extend(depth)) * Mat4::from_rotation_z(way.x.atan2(-way.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn standing() -> Moves {
        Moves {
            time: 1.0,
            x: 0.0,
            velocity: Vec2::ZERO,
            facing: 1.0,
            normal: Vec2::Y,
            support: Support::Ground,
            crouched: false,
            landed: (10.0, 0.0),
        }
    }

    fn sole(pose: &Pose, shin: Part) -> Vec3 {
        pose.parts[shin as usize].transform_point3(Vec3::NEG_Y * BONE)
    }

    #[test]
    fn feet_stand_on_the_slope() {
        for slope in [-0.8f32, -0.3, 0.0, 0.5, 0.9] {
            let moves = Moves {
                normal: Vec2::new(-slope, 1.0).normalize(),
                ..standing()
            };
            let pose = Memory::new(&moves).pose(&moves);
            for shin in [Part::ShinLeft, Part::ShinRight] {
                // The figure is turned towards the viewer; along its own plane the ground rises by the slope.
                let foot = sole(&pose, shin);
                let forward = Mat4::from_rotation_y(THREE_QUARTERS)
                    .transform_point3(foot)
                    .x;
                assert!(
                    (foot.y - slope * forward).abs() < 0.03,
                    "slope {slope}: {foot}"
                );
            }
        }
    }

    #[test]
    fn the_figure_is_as_tall_as_its_collider_and_ducks_below_it() {
        let moves = standing();
        let head = |moves: &Moves| {
            Memory::new(moves).pose(moves).parts[Part::Head as usize]
                .transform_point3(Vec3::Y * 0.42)
                .y
        };
        assert!((1.55..1.75).contains(&head(&moves)), "{}", head(&moves));
        let ducked = head(&Moves {
            crouched: true,
            ..moves
        });
        assert!(ducked < head(&moves) - 0.25, "{ducked}");
    }

    #[test]
    fn steps_follow_the_ground() {
        let at = |x: f64| {
            let moves = Moves {
                x,
                velocity: Vec2::new(8.0, 0.0),
                ..standing()
            };
            let pose = Memory::new(&moves).pose(&moves);
            [Part::ShinLeft, Part::ShinRight].map(|shin| sole(&pose, shin))
        };
        for i in 0..50 {
            let x = f64::from(i) * 0.05;
            let lowest = at(x)
                .map(|foot| foot.y)
                .into_iter()
                .fold(f32::INFINITY, f32::min);
            assert!(
                (-0.02..0.06).contains(&lowest),
                "at {x} the lower foot is at {lowest}"
            );
            assert!((at(x)[0] - at(x + f64::from(STRIDE))[0]).length() < 1e-3);
        }
    }

    #[test]
    fn a_mirrored_run_steps_alike() {
        let right = Moves {
            x: 0.7,
            velocity: Vec2::new(8.0, 0.0),
            ..standing()
        };
        let left = Moves {
            x: -0.7,
            velocity: Vec2::new(-8.0, 0.0),
            facing: -1.0,
            ..standing()
        };
        let feet = |moves: &Moves| {
            Memory::new(moves)
                .pose(moves)
                .parts
                .map(|part| part.transform_point3(Vec3::ZERO).y)
        };
        for (a, b) in feet(&right).into_iter().zip(feet(&left)) {
            assert!((a - b).abs() < 1e-4, "{a} {b}");
        }
    }

    #[test]
    fn nothing_jumps_when_the_body_turns_or_lands() {
        let mut moves = Moves {
            support: Support::Air,
            normal: Vec2::ZERO,
            velocity: Vec2::new(6.0, -15.0),
            ..standing()
        };
        let mut memory = Memory::new(&moves);
        let mut before = memory.pose(&moves);
        for i in 0..240 {
            moves.time += 1.0 / 240.0;
            if i == 60 {
                moves = Moves {
                    support: Support::Ground,
                    normal: Vec2::Y,
                    velocity: Vec2::new(6.0, 0.0),
                    landed: (0.0, 15.0),
                    ..moves
                };
            }
            moves.facing = if i < 120 { 1.0 } else { -1.0 };
            moves.landed.0 += 1.0 / 240.0;
            moves.x += f64::from(moves.velocity.x) / 240.0;
            memory.follow(&moves);
            let pose = memory.pose(&moves);
            let hips = |pose: &Pose| pose.parts[Part::Hips as usize].transform_point3(Vec3::ZERO);
            assert!(pose.parts.iter().all(|part| part.is_finite()));
            assert!((hips(&pose) - hips(&before)).length() < 0.05, "step {i}");
            before = pose;
        }
    }
}
