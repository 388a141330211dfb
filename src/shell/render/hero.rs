//! The hero's figure: a small knight with a red cape, a lantern and a short sword, one solid or more for each part of the
//! pose. Built in each part's own space: limbs hang from their joint along -y.

use super::frame::PointLight;
use super::model::{Model, Paint, paint};
use crate::anim::hero::{ARM, BONE, CAPE, Memory, Moves, PARTS, Part, Pose, STRIP, Support};
use crate::game::{Stance, View};
use glam::{Mat4, Vec2, Vec3, vec3};

const STEEL: Paint = paint(0xc9d2da).varied(0.10);
const DARK: Paint = paint(0x39424f);
const CLOTH: Paint = paint(0x2c5f73);
const LEATHER: Paint = paint(0x6b4630);
const RED: Paint = paint(0xd83a2b).varied(0.12);
const BRASS: Paint = paint(0xd6a04e);
const FLAME: Paint = paint(0xffd27a).glowing(1.0);

/// Matrices before the hero's in the parts block: that of everything that stands still.
pub const FIRST_PART: u8 = 1;

/// The figure.
pub fn figure() -> Model {
    let mut figure = Model::default();
    trunk(&mut figure);
    head(&mut figure);
    for side in [Part::ThighLeft, Part::ThighRight] {
        leg(side, &mut figure);
    }
    for side in [Part::ArmLeft, Part::ArmRight] {
        arm(side, &mut figure);
    }
    sword(&mut figure);
    lantern(&mut figure);
    for strip in 0..CAPE {
        cape(strip, &mut figure);
    }
    figure
}

/// A paint on a part of the figure.
fn on(paint: Paint, part: Part) -> Paint {
    paint.on(FIRST_PART + part as u8)
}

/// The limb that hangs from another.
fn below(part: Part) -> Part {
    match part {
        Part::ThighLeft => Part::ShinLeft,
        Part::ThighRight => Part::ShinRight,
        Part::ArmLeft => Part::ForearmLeft,
        _ => Part::ForearmRight,
    }
}

/// Skirt, belt, a breastplate that widens to the shoulders, a surcoat, and the collar of the cape.
fn trunk(figure: &mut Model) {
    let (skirt, belt) = (on(CLOTH, Part::Hips), on(LEATHER, Part::Hips));
    figure.block(Vec3::Y * -0.16, (0.19, 0.22), (0.14, 0.17), 0.22, skirt);
    figure.slab(Vec3::Y * 0.04, (0.15, 0.18), 0.07, belt);
    let [steel, cloth, red] = [STEEL, CLOTH, RED].map(|paint| on(paint, Part::Chest));
    figure.block(Vec3::Y * 0.08, (0.13, 0.16), (0.18, 0.23), 0.30, steel);
    figure.block(Vec3::Y * 0.38, (0.18, 0.23), (0.10, 0.13), 0.13, steel);
    let chest = vec3(0.13, 0.1, 0.0);
    figure.block(chest, (0.045, 0.07), (0.06, 0.09), 0.30, cloth);
    let collar = [(0.0, 0.21), (0.06, 0.19), (0.11, 0.11)];
    figure.lathe(vec3(-0.02, 0.44, 0.0), 7, &collar, red);
}

/// A great helm: a slit for eyes that glow a little, a brass ridge that parts the face, a crest that streams back.
fn head(figure: &mut Model) {
    let [steel, dark, brass, eyes, crest] =
        [STEEL, DARK, BRASS, FLAME.glowing(0.8), RED].map(|paint| on(paint, Part::Head));
    let bowl = [
        (0.0, 0.145),
        (0.10, 0.185),
        (0.26, 0.18),
        (0.36, 0.10),
        (0.39, 0.0),
    ];
    figure.lathe(Vec3::Y * 0.02, 8, &bowl, steel);
    figure.slab(vec3(0.10, 0.17, 0.0), (0.10, 0.135), 0.055, dark);
    figure.slab(vec3(0.165, 0.04, 0.0), (0.035, 0.018), 0.26, brass);
    for side in [-0.06, 0.06] {
        figure.slab(vec3(0.17, 0.18, side), (0.036, 0.024), 0.034, eyes);
    }
    let (brow, crown, nape) = (
        vec3(0.06, 0.39, 0.0),
        vec3(-0.12, 0.42, 0.0),
        vec3(-0.30, 0.33, 0.0),
    );
    figure.beam(brow, crown, 0.035, crest);
    figure.beam(crown + Vec3::X * 0.02, nape, 0.028, crest);
}

/// A thigh in dark cloth; a greave with its knee, and a boot that points forward.
fn leg(thigh: Part, figure: &mut Model) {
    let shin = below(thigh);
    let (cloth, steel, boot) = (on(DARK, thigh), on(STEEL, shin), on(LEATHER, shin));
    let (foot, ankle) = (Vec3::Y * -BONE, Vec3::Y * (0.07 - BONE));
    figure.block(foot, (0.07, 0.07), (0.095, 0.09), BONE + 0.03, cloth);
    figure.block(ankle, (0.065, 0.07), (0.085, 0.085), BONE - 0.04, steel);
    let knee = vec3(0.01, -0.05, 0.0);
    figure.block(knee, (0.085, 0.085), (0.07, 0.07), 0.10, steel);
    let toes = foot + Vec3::X * 0.05;
    figure.block(toes, (0.14, 0.085), (0.08, 0.07), 0.10, boot);
}

/// A round shoulder plate, a sleeve, a bracer and a fist.
fn arm(upper: Part, figure: &mut Model) {
    let lower = below(upper);
    let plate = [(0.0, 0.13), (0.09, 0.14), (0.17, 0.06)];
    figure.lathe(Vec3::Y * -0.10, 6, &plate, on(STEEL, upper));
    let (elbow, wrist, fist) = (
        Vec3::Y * -ARM,
        Vec3::Y * (0.05 - ARM),
        Vec3::Y * (-0.04 - ARM),
    );
    figure.block(
        elbow,
        (0.05, 0.05),
        (0.06, 0.06),
        ARM - 0.05,
        on(DARK, upper),
    );
    figure.block(
        wrist,
        (0.06, 0.06),
        (0.07, 0.07),
        ARM - 0.05,
        on(STEEL, lower),
    );
    figure.slab(fist, (0.055, 0.055), 0.10, on(LEATHER, lower));
}

/// Grip, guard and a short blade, held forward and down.
fn sword(figure: &mut Model) {
    let [leather, brass, steel] =
        [LEATHER, BRASS, STEEL].map(|paint| on(paint, Part::ForearmRight));
    let (hand, along) = (Vec3::Y * -ARM, vec3(0.8, -0.6, 0.0));
    let (guard, across) = (hand + along * 0.07, vec3(-0.06, -0.08, 0.0));
    figure.beam(hand - along * 0.12, guard, 0.022, leather);
    figure.beam(guard - across, guard + across, 0.022, brass);
    figure.beam(guard, guard + along * 0.50, 0.026, steel);
}

/// A ring, a hood, the flame behind glass, a foot.
fn lantern(figure: &mut Model) {
    let [brass, flame] = [BRASS, FLAME].map(|paint| on(paint, Part::Lantern));
    let glass = [(0.0, 0.055), (0.07, 0.075), (0.13, 0.055)];
    figure.beam(Vec3::ZERO, Vec3::Y * -0.07, 0.012, brass);
    figure.lathe(Vec3::Y * -0.12, 6, &[(0.0, 0.085), (0.06, 0.0)], brass);
    figure.lathe(Vec3::Y * -0.25, 6, &glass, flame);
    figure.lathe(Vec3::Y * -0.29, 6, &[(0.0, 0.06), (0.04, 0.08)], brass);
}

/// A strip of the cape: a thin slab that widens downwards, the last with a torn hem.
fn cape(strip: usize, figure: &mut Model) {
    let width = |at: usize| 0.21 + 0.05 * at as f32;
    let thick = 0.014;
    let red = RED.on(FIRST_PART + Part::Cape as u8 + strip as u8);
    let red = red.towards(paint(0x7e1c22), 0.16 * strip as f32);
    if strip + 1 < CAPE {
        figure.block(
            Vec3::Y * -STRIP,
            (thick, width(strip + 1)),
            (thick, width(strip)),
            STRIP,
            red,
        );
        return;
    }
    let hem = [-0.75, 0.0, 0.8];
    for (tooth, lengthen) in hem.into_iter().zip([1.0, 0.75, 1.15]) {
        let (middle, half) = (tooth * width(strip) * 0.75, width(strip) * 0.36);
        let top = Vec3::Z * middle;
        let [up, down] = [Vec3::ZERO, Vec3::Y * -STRIP * lengthen];
        for side in [thick, -thick] {
            let at = |p: Vec3, z: f32| top + p + Vec3::new(side, 0.0, z);
            let corners = [at(up, half), at(up, -half), at(down, 0.3 * half)];
            let turned = [corners[1], corners[0], corners[2]];
            figure.facet(if side > 0.0 { corners } else { turned }, [1.0; 3], red);
        }
    }
}

/// The moving figure: what the pose remembers between pictures.
#[derive(Default)]
pub struct Hero {
    memory: Option<Memory>,
}

impl Hero {
    /// The pose for a view.
    pub fn pose(&mut self, view: &View) -> Pose {
        let moves = moves(view);
        let memory = self.memory.get_or_insert_with(|| Memory::new(&moves));
        memory.follow(&moves);
        memory.pose(&moves)
    }
}

/// What the figure has to show of a view.
fn moves(view: &View) -> Moves {
    let support = match view.stance {
        Stance::Air => Support::Air,
        Stance::Ground | Stance::Wedge => Support::Ground,
        Stance::Slide | Stance::Climb => Support::Wall,
    };
    Moves {
        time: view.time,
        x: view.position.x,
        velocity: view.velocity.as_vec2(),
        facing: view.facing as f32,
        // A ladder is before him, wherever he looks.
        normal: match view.stance {
            Stance::Climb => Vec2::new(-view.facing as f32, 0.0),
            _ => view.normal.as_vec2(),
        },
        support,
        crouched: view.crouched,
        landed: (
            (view.time - view.landed_at).max(0.0) as f32,
            view.landed_speed as f32,
        ),
    }
}

/// The matrices of all parts, in the order of the parts block, as words.
pub fn write_parts(pose: &Pose, foot: Vec3, words: &mut Vec<u32>) {
    words.clear();
    let place = Mat4::from_translation(foot);
    let parts: [Mat4; PARTS] = pose.parts.map(|part| place * part);
    for part in std::iter::once(Mat4::IDENTITY).chain(parts) {
        words.extend(part.to_cols_array().map(f32::to_bits));
    }
}

/// The light of the hero's lantern; it flickers a little.
pub fn lamp(pose: &Pose, foot: Vec3, time: f64) -> PointLight {
    let seconds = time.rem_euclid(3600.0) as f32;
    let flicker = 1.0 + 0.05 * (seconds * 11.0).sin() + 0.04 * (seconds * 17.3).sin();
    PointLight {
        at: foot + pose.lantern() + Vec3::Z * 0.25,
        reach: 6.0,
        colour: Vec3::new(1.15, 0.66, 0.27) * flicker,
    }
}
