//! What the app hands over for one picture, and the block of uniforms that is made of it.

use super::mood::Mood;
use crate::anim::Shown;
use crate::game::View;
use glam::camera::rh::proj::opengl::{orthographic, perspective};
use glam::camera::rh::view::look_to_mat4;
use glam::{DVec2, Mat4, Vec2, Vec3, Vec4};

/// Point lights that the shaders sum up.
pub const MAX_LIGHTS: usize = 16;
/// Nearest and farthest distance that is drawn, in metres.
const DEPTH_RANGE: (f32, f32) = (0.5, 600.0);
/// Texels along the side of the coarsest shadow map: others have a whole multiple.
pub const SHADOW_TEXELS: u32 = 1024;
/// Metres that the shadow map covers, across and along the light.
const SHADOW_REACH: f32 = 20.0;
const SHADOW_DEPTH: f32 = 70.0;
/// Towards the key light: high on the left, a little in front, so that tops shine and fronts are modelled.
pub const SUN: Vec3 = Vec3::new(-0.56, 0.79, 0.25);

/// Everything in one picture.
pub struct Frame<'a> {
    /// The hero and the state of the game, already interpolated between ticks.
    pub view: &'a View,
    /// The hero's figure; without one he is not drawn.
    pub hero: Option<&'a Shown>,
    /// How far each mover is from where it was drawn, in metres.
    pub offsets: &'a [DVec2],
    /// From where it is seen.
    pub camera: CameraPose,
    /// Seconds for wind, water and dust; may stand still while the game is paused.
    pub time: f64,
    /// Debug lines, drawn over the scene in their order.
    pub lines: &'a [Line],
    /// Debug triangles, drawn over the scene and below the lines.
    pub tris: &'a [Tri],
    /// Whether the world itself is drawn, or the lines alone.
    pub show_world: bool,
}

/// Where the camera is and what it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraPose {
    /// Its place, in metres.
    pub eye: Vec3,
    /// The middle of the picture.
    pub target: Vec3,
    /// Vertical opening angle.
    pub fov_degrees: f32,
}

/// A debug line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Start, in metres.
    pub a: Vec3,
    /// End, in metres.
    pub b: Vec3,
    /// Red, green, blue as on the screen, and opacity.
    pub colour: [f32; 4],
    /// In pixels.
    pub width: f32,
}

/// A debug triangle, seen from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tri {
    /// Corners, in metres.
    pub corners: [Vec3; 3],
    /// Red, green, blue as on the screen, and opacity.
    pub colour: [f32; 4],
}

/// A lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Its place, in metres.
    pub at: Vec3,
    /// How far it shines, in metres.
    pub reach: f32,
    /// Linear red, green, blue.
    pub colour: Vec3,
}

/// The values of the shaders' `FrameBlock`, in its order.
#[derive(Clone, Copy, Debug)]
pub struct FrameBlock {
    /// World to clip space.
    pub view_proj: Mat4,
    /// World to shadow map.
    pub shadow_proj: Mat4,
    /// Camera, seconds.
    pub eye: Vec4,
    /// Half the picture's width at distance 1, pixels across.
    pub ray_right: Vec4,
    /// Half the picture's height at distance 1, pixels down.
    pub ray_up: Vec4,
    /// Where the camera looks.
    pub ray_forward: Vec4,
    /// The hero's foot, and the height of the ground below him.
    pub hero: Vec4,
    /// Place and age of the last puff of dust.
    pub puff: Vec4,
    /// Number of lights (set by `write`), height of the water, how many lights move, strength of the puff.
    pub scene: Vec4,
    /// Whether the puff is of water: 0 or 1.
    pub wet: f32,
    /// Light and air.
    pub mood: Mood,
}

impl FrameBlock {
    /// The camera's part of the block. A camera that looks nowhere, or straight up or down, still gives finite numbers.
    pub fn new(camera: &CameraPose, size: (u32, u32), time: f64) -> FrameBlock {
        let (width, height) = (size.0.max(1) as f32, size.1.max(1) as f32);
        let forward = (camera.target - camera.eye)
            .try_normalize()
            .unwrap_or(Vec3::NEG_Z);
        let right = forward.cross(Vec3::Y).try_normalize().unwrap_or(Vec3::X);
        let up = right.cross(forward);
        let tangent = (camera.fov_degrees.clamp(1.0, 170.0).to_radians() / 2.0).tan();
        let view = look_to_mat4(camera.eye, forward, up);
        let projection = perspective(
            2.0 * tangent.atan(),
            width / height,
            DEPTH_RANGE.0,
            DEPTH_RANGE.1,
        );
        FrameBlock {
            view_proj: projection * view,
            shadow_proj: shadow_projection(camera.target),
            eye: camera.eye.extend(wrapped(time)),
            ray_right: (right * tangent * width / height).extend(width),
            ray_up: (up * tangent).extend(height),
            ray_forward: forward.extend(0.0),
            hero: Vec4::ZERO,
            puff: Vec4::ZERO,
            scene: Vec4::ZERO,
            wet: 0.0,
            mood: Mood::at(&[], Vec2::ZERO, 0),
        }
    }

    /// Replaces `words` by the block with these lights; those beyond [`MAX_LIGHTS`] are left out.
    pub fn write(&self, lights: &[PointLight], words: &mut Vec<u32>) {
        let lights = &lights[..lights.len().min(MAX_LIGHTS)];
        let scene = Vec4::new(
            lights.len() as f32,
            self.scene.y,
            self.scene.z,
            self.scene.w,
        );
        words.clear();
        for matrix in [self.view_proj, self.shadow_proj] {
            words.extend(matrix.to_cols_array().map(f32::to_bits));
        }
        let mut push = |v: Vec4| words.extend(v.to_array().map(f32::to_bits));
        let vectors = [
            self.eye,
            self.ray_right,
            self.ray_up,
            self.ray_forward,
            SUN.extend(0.0),
            self.hero,
            self.puff,
            scene,
        ];
        vectors.into_iter().for_each(&mut push);
        let [key, rest @ ..] = self.mood.vectors();
        push(key.with_w(self.wet));
        rest.into_iter().for_each(&mut push);
        for i in 0..MAX_LIGHTS {
            push(
                lights
                    .get(i)
                    .map_or(Vec4::W, |light| light.at.extend(light.reach)),
            );
        }
        for i in 0..MAX_LIGHTS {
            push(
                lights
                    .get(i)
                    .map_or(Vec4::ZERO, |light| light.colour.extend(0.0)),
            );
        }
    }

    /// Whether a box may be in the picture.
    pub fn sees(&self, min: Vec3, max: Vec3) -> bool {
        meets(self.view_proj, min, max)
    }

    /// Whether a box may throw a shadow that the shadow map holds.
    pub fn shades(&self, min: Vec3, max: Vec3) -> bool {
        let to_clip = Mat4::from_translation(Vec3::NEG_ONE) * Mat4::from_scale(Vec3::splat(2.0));
        meets(to_clip * self.shadow_proj, min, max)
    }
}

/// Seconds, wrapped so that single precision still tells milliseconds after days of play.
fn wrapped(seconds: f64) -> f32 {
    seconds.rem_euclid(3600.0) as f32
}

/// World to shadow map, 0 to 1: a box around a point, moved in whole texels so that shadows stand still under a moving camera.
fn shadow_projection(around: Vec3) -> Mat4 {
    let view = look_to_mat4(Vec3::ZERO, -SUN.normalize(), Vec3::Y);
    let texel = 2.0 * SHADOW_REACH / SHADOW_TEXELS as f32;
    let centre = view.transform_point3(around);
    let snap = |c: f32| (c / texel).round() * texel;
    let (x, y, z) = (snap(centre.x), snap(centre.y), snap(centre.z));
    let (reach, depth) = (SHADOW_REACH, SHADOW_DEPTH);
    let projection = orthographic(
        x - reach,
        x + reach,
        y - reach,
        y + reach,
        -z - depth,
        -z + depth,
    );
    Mat4::from_translation(Vec3::splat(0.5))
        * Mat4::from_scale(Vec3::splat(0.5))
        * projection
        * view
}

/// Whether a box may meet the clip volume of a matrix: false only if all corners lie beyond one of its planes.
fn meets(matrix: Mat4, min: Vec3, max: Vec3) -> bool {
    let corner = |i: usize| {
        let pick = |bit: usize, a: f32, b: f32| if i >> bit & 1 == 0 { a } else { b };
        matrix
            * Vec4::new(
                pick(0, min.x, max.x),
                pick(1, min.y, max.y),
                pick(2, min.z, max.z),
                1.0,
            )
    };
    let beyond = |test: fn(Vec4) -> bool| (0..8).all(|i| test(corner(i)));
    !(beyond(|p| p.x < -p.w)
        || beyond(|p| p.x > p.w)
        || beyond(|p| p.y < -p.w)
        || beyond(|p| p.y > p.w)
        || beyond(|p| p.z < -p.w)
        || beyond(|p| p.z > p.w))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(x: f32) -> CameraPose {
        CameraPose {
            eye: Vec3::new(x, 3.0, 17.0),
            target: Vec3::new(x, 2.0, 0.0),
            fov_degrees: 42.0,
        }
    }

    #[test]
    fn boxes_outside_the_picture_are_told_from_those_inside() {
        let block = FrameBlock::new(&camera(0.0), (1280, 720), 0.0);
        assert!(block.sees(Vec3::splat(-1.0), Vec3::splat(1.0)));
        assert!(block.sees(Vec3::splat(-500.0), Vec3::splat(500.0)));
        assert!(!block.sees(Vec3::new(40.0, 0.0, 0.0), Vec3::new(50.0, 1.0, 1.0)));
        assert!(!block.sees(Vec3::new(-1.0, 0.0, 20.0), Vec3::new(1.0, 1.0, 30.0)));
    }

    #[test]
    fn shadows_stand_still_under_a_moving_camera() {
        let point = Vec3::new(1.0, 2.0, 0.5);
        let texel = |x: f32| {
            FrameBlock::new(&camera(x), (1280, 720), 0.0)
                .shadow_proj
                .transform_point3(point)
                * SHADOW_TEXELS as f32
        };
        let fraction = |x: f32| texel(x) - texel(x).round();
        for i in 0..50 {
            let moved = (fraction(0.0) - fraction(i as f32 * 0.0137)).truncate();
            assert!(
                moved.length() < 0.02 || (moved.abs().max_element() - 1.0).abs() < 0.02,
                "{moved}"
            );
        }
    }

    #[test]
    fn a_camera_without_direction_gives_finite_numbers() {
        for target in [Vec3::ZERO, Vec3::Y] {
            let pose = CameraPose {
                eye: Vec3::ZERO,
                target,
                fov_degrees: 0.0,
            };
            assert!(FrameBlock::new(&pose, (0, 0), 1e12).view_proj.is_finite());
        }
    }

    #[test]
    fn the_block_has_the_shaders_size() {
        let mut words = Vec::new();
        FrameBlock::new(&camera(0.0), (64, 64), 0.0).write(&[], &mut words);
        assert_eq!(words.len(), 2 * 16 + 16 * 4 + 2 * MAX_LIGHTS * 4);
    }
}
