//! The picture of a moment: the world from the camera, drawings over it, panels over those.

use super::ShellError;
use super::app::App;
use super::contrast;
use super::edits::Edit;
use super::jolt::shaken;
use super::menu::prompts::Device;
use super::overlay::Info;
use super::overlay::scene::{Drawing, MeshPicture};
use super::render::{CameraPose, Frame};
use crate::game::Shape;
use crate::game::camera::Pose;
use glam::{DVec2, DVec3, Vec3};
use std::f64::consts::TAU;
use std::mem::take;

/// Share of the picture's width that the title's letters take.
const TITLE_ASIDE: f64 = 0.42;
/// How the camera drifts behind the title: seconds of a swing and metres to each side, across, up and towards the scene.
const DRIFT: [(f64, f64); 3] = [(46.0, 2.4), (31.0, 0.5), (67.0, 1.1)];

/// Colour of the line around the hero for who wants high contrast: linear light.
const MARK: Vec3 = Vec3::new(0.25, 1.6, 2.0);

/// What is put together for each picture, in room that is kept from one to the next.
#[derive(Default)]
pub(super) struct Sketch {
    /// How far each mover is from where it was drawn.
    offsets: Vec<DVec2>,
    drawing: Drawing,
    /// The hero's shape, once it is asked for.
    hero: Option<Shape>,
}

impl App {
    /// Draws the moment between the last two ticks; returns what was asked for in the panels.
    pub(super) fn draw(&mut self, elapsed: f32) -> Result<Vec<Edit>, ShellError> {
        let share = self.clock.share();
        let pixels = self.platform.pixels();
        let view = self.play.view(share);
        let covered = self.overlay.covered(&self.platform);
        let mut sketch = take(&mut self.sketch);
        let Sketch {
            offsets,
            drawing,
            hero: shape,
        } = &mut sketch;
        offsets.clear();
        offsets.extend(self.play.world.offsets_at(view.time));
        let pose = self.play.pose(share, &self.tuning);
        let shake = f64::from(self.front.live.accessibility.shake) / 100.0;
        let pose = match self.front.is_title() {
            true => drifting(beside(pose, TITLE_ASIDE, pixels), self.front.clock),
            false => beside(shaken(pose, &view, shake), covered, pixels),
        };
        drawing.clear();
        if self.overlay.open || self.overlay.show.mesh {
            let show = self.overlay.show;
            let picture = self.mesh_picture();
            drawing.add(show, &self.play, picture, offsets, &view, &pose);
            drawing.scale_to(pixels.1);
        }
        if self.front.live.accessibility.contrast && !self.front.is_title() {
            let level = &self.play.world.stage().level;
            let hero = (&view, &*shape.get_or_insert_with(Shape::hero));
            contrast::outline(level, hero, offsets, pixels.1, &mut drawing.lines);
        }
        // The view's own time: what moves in the world stands still with it.
        let hero = self.play.shown(share);
        let contrast = self.front.live.accessibility.contrast;
        self.renderer.mark_hero(contrast.then_some(MARK));
        let frame = Frame {
            view: &view,
            hero: hero.as_ref(),
            offsets,
            camera: camera(&pose),
            time: view.time,
            lines: &drawing.lines,
            tris: &drawing.tris,
            show_world: !(self.overlay.open && self.overlay.show.hide_world),
        };
        self.renderer.draw(&frame, pixels);
        self.sketch = sketch;
        self.write_page(&view, elapsed, covered as f32);
        self.text_pass.draw(&mut self.text);
        let points = self.front.is_open() && self.controls.device() == Device::Keys;
        self.platform.show_mouse(self.overlay.open || points);
        let source = match self.overlay.open {
            true => self.feed.describe(self.recorder.as_ref()),
            false => String::new(),
        };
        // What the panels may see; what they want comes back as values.
        let info = Info {
            play: &self.play,
            view: &view,
            tuning: &self.tuning,
            tuning_path: self.tuning_file.path(),
            level_path: self.level_file.path(),
            levels: &self.levels,
            mesh_size: self.mesh_picture().size(),
            stats: &self.stats,
            notices: &self.notices,
            source: &source,
            paused: self.paused,
            scale: self.scale,
        };
        self.overlay.draw(&self.platform, &info)
    }

    /// Shows the stage that is played now.
    pub(super) fn show_stage(&mut self) {
        self.play.show_hero(&self.rig);
        let stage = self.play.world.stage();
        self.renderer.set_stage(stage);
        let land = self.play.world.land(0);
        self.mesh_pictures = [&land.stand, &land.crouch].map(MeshPicture::new);
    }

    /// The mesh that the hero moves in now.
    fn mesh_picture(&self) -> &MeshPicture {
        &self.mesh_pictures[usize::from(self.play.world.view().crouched)]
    }
}

/// The pose that shows beside a panel what it would show in the middle of the picture; `covered` is the panel's
/// share of the width.
fn beside(pose: Pose, covered: f64, (width, height): (u32, u32)) -> Pose {
    let half = DVec2::from_angle((pose.fov_degrees / 2.0).to_radians());
    let reach = (pose.eye.z - pose.target.z) * half.y / half.x;
    let aside = DVec3::new(
        reach * f64::from(width) / f64::from(height) * covered,
        0.0,
        0.0,
    );
    Pose {
        eye: pose.eye - aside,
        target: pose.target - aside,
        ..pose
    }
}

/// A pose that moves slowly, and never stands still.
fn drifting(pose: Pose, seconds: f64) -> Pose {
    let swing = |(period, reach): (f64, f64)| (seconds / period * TAU).sin() * reach;
    let [across, up, near] = DRIFT.map(swing);
    let aside = DVec3::new(across, up, 0.0);
    Pose {
        eye: pose.eye + aside - DVec3::Z * near,
        target: pose.target + aside * 0.7,
        ..pose
    }
}

/// The renderer's camera, in its single precision.
fn camera(pose: &Pose) -> CameraPose {
    CameraPose {
        eye: pose.eye.as_vec3(),
        target: pose.target.as_vec3(),
        fov_degrees: pose.fov_degrees as f32,
    }
}
