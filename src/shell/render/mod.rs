//! The picture: a stage and a view of the game in, one frame out.
//!
//! OpenGL 3.3 core. Everything is flat-shaded triangles with colours per vertex and no textures; lighting is worked out in
//! linear light. The scene is drawn at the preset's resolution, and the last pass brings it to the window.

mod air;
mod backdrop;
mod bake;
mod bearers;
mod canvas;
mod carried;
mod courses;
mod crowd;
mod dangers;
mod debug;
mod edging;
mod error;
mod facets;
mod fixtures;
mod frame;
pub(in crate::shell) mod gl;
mod ground;
mod growth;
mod guides;
mod hero;
mod inward;
mod kit;
mod lamps;
mod model;
mod mood;
mod passes;
pub(in crate::shell) mod program;
mod quality;
mod rims;
mod scene;
mod scenery;
mod seen;
mod shards;
mod sky;
mod stands;
pub(in crate::shell) mod state;
mod surface;
mod terrain;
mod water;

pub use crate::cli::Preset;
pub use error::RenderError;
pub use frame::{CameraPose, Frame, Line, PointLight, Tri};
pub use gl::load;
pub use passes::Pass;
pub use state::Work;

use crate::anim::Rig;
use crate::game::{Stage, Stance, View};
use crate::level::Area;
use air::Air;
use canvas::Canvas;
use carried::Carried;
use crowd::Crowd;
use debug::Debug;
use frame::FrameBlock;
use gl::{Geometry, Gl, Uniforms};
use glam::{DVec2, Mat4, Vec3, Vec4};
use ground::Ground;
use hero::Hero;
use kit::Kit;
use mood::Mood;
use passes::Programs;
use quality::Quality;
use scene::{Chunk, Scene};
use shards::Shards;
use state::Format;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;
use surface::Surface;

/// Layout of the model's vertices: position, normal, colour, traits, baked light.
const VERTEX: [Format; 5] = [
    Format::F3,
    Format::Snorm4,
    Format::Unorm4,
    Format::Unorm4,
    Format::Unorm4,
];
/// Behind the debug lines when the world is not drawn.
const BACKGROUND: [f32; 3] = [0.07, 0.08, 0.10];
/// At most so many lamps that ride on movers light a picture.
const RIDING_LIGHTS: usize = 4;

/// Draws frames. Owns everything it made in its OpenGL context.
pub struct Renderer {
    gl: Gl,
    shader_dir: PathBuf,
    quality: Quality,
    programs: Programs,
    frame_uniforms: Uniforms,
    shadow_map: Option<Surface>,
    canvas: Canvas,
    left_out: Option<Pass>,
    /// Three corners for passes over the whole picture.
    whole: Geometry,
    world: Geometry,
    chunks: Vec<Chunk>,
    kit: Kit,
    carried: Carried,
    shards: Shards,
    /// Instances: pieces that stand still, and what moves.
    crowd: Crowd,
    hero: Hero,
    water: Geometry,
    water_height: f32,
    areas: Vec<Area>,
    sky: Geometry,
    firmament: Geometry,
    ground: Ground,
    air: Air,
    debug: Debug,
    /// All lamps of the stage, and those of the current picture.
    lamps: Vec<PointLight>,
    lit: Vec<PointLight>,
    /// Those of them that ride on movers.
    riding: Vec<PointLight>,
    gate: Option<PointLight>,
    /// Room to put uploads together in, kept from frame to frame.
    words: Vec<u32>,
}

impl Renderer {
    /// Compiles the shaders of a directory, reads the models of another and makes the buffers; draws an empty world until a
    /// stage is set.
    ///
    /// # Errors
    /// OpenGL is older than 3.3, a file is missing or wrong, or OpenGL is out of memory.
    pub fn new(
        ctx: Rc<glow::Context>,
        shader_dir: &Path,
        models: &Path,
    ) -> Result<Renderer, RenderError> {
        let gl = Gl::new(ctx);
        if gl.version() < (3, 3) {
            return Err(RenderError::Version {
                found: gl.version(),
            });
        }
        let quality = Quality::of(Preset::default());
        let programs = Programs::load(&gl, shader_dir, &quality)?;
        let mut whole = gl.geometry(&[Format::F1], false)?;
        whole.upload(&[0; 3]);
        Ok(Renderer {
            shader_dir: shader_dir.to_path_buf(),
            programs,
            frame_uniforms: gl.uniforms(0)?,
            shadow_map: shadow_map(&gl, &quality)?,
            canvas: Canvas::default(),
            left_out: None,
            whole,
            quality,
            world: gl.geometry(&VERTEX, false)?,
            chunks: Vec::new(),
            kit: Kit::load(models)?,
            carried: Carried::default(),
            shards: Shards::default(),
            crowd: Crowd::new(&gl)?,
            hero: Hero::new(&gl)?,
            water: water::surface(&gl)?,
            water_height: 0.0,
            areas: Vec::new(),
            sky: sky::grid(&gl)?,
            firmament: sky::things(&gl)?,
            ground: Ground::default(),
            air: Air::new(&gl)?,
            debug: Debug::new(&gl)?,
            lamps: Vec::new(),
            gate: None,
            lit: Vec::with_capacity(frame::MAX_LIGHTS + 1),
            riding: Vec::with_capacity(frame::MAX_LIGHTS + 1),
            words: Vec::new(),
            gl,
        })
    }

    /// Replaces the world by that of a stage.
    pub fn set_stage(&mut self, stage: &Stage) {
        self.shards = Shards::new(&self.kit);
        let scene = Scene::of(stage, &self.kit, &mut self.shards);
        self.world.upload(&scene.words);
        self.water.upload(&scene.water_words);
        self.water_height = scene.water;
        self.chunks = scene.chunks;
        self.carried = Carried::of(stage, &self.kit, &mut self.shards);
        let (pieces, movers) = (scene.pieces, self.carried.models());
        self.crowd.set(&self.kit, movers, pieces, &scene.light);
        self.lamps = scene.lamps;
        self.gate = scene.gate;
        self.areas = stage.level.areas.clone();
        self.ground = Ground::of(stage);
    }

    /// Replaces the hero's model.
    pub fn set_hero(&mut self, rig: &Arc<Rig>) {
        self.hero.set_model(rig);
    }

    /// Draws a line of a colour (linear red, green, blue) around the hero, or none.
    pub fn mark_hero(&mut self, colour: Option<Vec3>) {
        self.hero.mark(colour);
    }

    /// Lets pictures cost this much from now on.
    ///
    /// # Errors
    /// OpenGL is out of memory, or a shader file is wrong; everything stays as it was.
    pub fn set_preset(&mut self, preset: Preset) -> Result<(), RenderError> {
        let quality = Quality::of(preset);
        if quality == self.quality {
            return Ok(());
        }
        let programs = Programs::load(&self.gl, &self.shader_dir, &quality)?;
        self.shadow_map = shadow_map(&self.gl, &quality)?;
        self.programs = programs;
        self.canvas = Canvas::default();
        self.quality = quality;
        Ok(())
    }

    /// Draws pictures without one of their passes, to see what it is good for; `None` draws all.
    pub fn leave_out(&mut self, pass: Option<Pass>) {
        self.left_out = pass;
    }

    /// Reads all shaders again.
    ///
    /// # Errors
    /// Names file and line of the first error; all programs stay as they were.
    pub fn reload_shaders(&mut self) -> Result<(), RenderError> {
        self.programs = Programs::load(&self.gl, &self.shader_dir, &self.quality)?;
        Ok(())
    }

    /// Draws a frame into the framebuffer that is bound, `size` in its pixels. Without area nothing is drawn.
    pub fn draw(&mut self, frame: &Frame, size: (u32, u32)) {
        if size.0 == 0 || size.1 == 0 {
            return;
        }
        let window = self.gl.bound();
        let block = self.upload(frame, size);
        self.gl.reset();
        self.canvas.fit(&self.gl, &self.quality, size);
        let hero = 0..frame.hero.map_or(0, |_| usize::MAX);
        if let (true, Some(stages)) = (frame.show_world, self.canvas.stages()) {
            self.draw_scene(&block, hero, stages, (window, size));
        } else {
            self.gl.viewport(size.0, size.1);
            self.gl.fill(BACKGROUND);
        }
        self.debug_pass();
    }

    /// The picture that was drawn last, `size` in pixels: RGB, rows from the top down. Call before the buffers are swapped.
    pub fn read_pixels(&self, size: (u32, u32)) -> Vec<u8> {
        let upwards = self.gl.read_pixels(size.0, size.1);
        let rows = upwards.chunks_exact((size.0 as usize * 3).max(1));
        let mut downwards = Vec::with_capacity(upwards.len());
        rows.rev().for_each(|row| downwards.extend_from_slice(row));
        downwards
    }

    /// Waits until all is drawn: for measuring alone.
    pub fn finish(&self) {
        self.gl.finish();
    }

    /// What was asked of OpenGL since the last call.
    pub fn take_work(&self) -> Work {
        self.gl.work.take()
    }

    /// The first OpenGL error since the last call, as OpenGL's number.
    pub fn take_error(&self) -> Option<u32> {
        self.gl.take_error()
    }

    /// Hands the frame's values to the GPU.
    fn upload(&mut self, frame: &Frame, size: (u32, u32)) -> FrameBlock {
        let foot = frame.view.position.as_vec2().extend(0.0);
        let lamp = self.hero.upload(frame.hero, frame.time, &mut self.words);
        let moving = self.light(frame, lamp);
        let water = self.water_height;
        let stirred = self.air.puff(frame.view, foot, water);
        let block = FrameBlock {
            hero: foot.extend(self.ground_below(frame.view, frame.offsets)),
            puff: stirred.at,
            scene: Vec4::new(0.0, water, moving as f32, stirred.strength),
            wet: f32::from(u8::from(stirred.wet)),
            mood: Mood::at(&self.areas, frame.camera.target.truncate(), frame.view.area),
            ..FrameBlock::new(&frame.camera, size, frame.time)
        };
        block.write(&self.lit, &mut self.words);
        self.frame_uniforms.upload(&self.words);
        self.place(frame, &block);
        self.air.upload(&self.lit, &mut self.words);
        self.debug.upload(frame.lines, frame.tris, &mut self.words);
        block
    }

    /// Puts what is drawn as instances where it is in this picture.
    fn place(&mut self, frame: &Frame, block: &FrameBlock) {
        let (crowd, words) = (&mut self.crowd, &mut self.words);
        crowd.begin(words);
        if crowd.has_still() {
            crowd.show_still(block, self.shadow_map.is_some(), words);
        }
        let first = self.kit.count();
        self.carried.place(frame.offsets, frame.time, |number, at| {
            let place = (first + number, Mat4::from_translation(at));
            crowd.show(block, place, None, words);
        });
        self.shards.place(frame, |piece, place, glow| {
            crowd.show(block, (piece, place), Some(glow), words);
        });
        crowd.upload(words);
    }

    /// Chooses the lamps of a picture: the hero's always, the checkpoint's that holds, the gate's second light once it is
    /// reached, a few that ride on movers, then the nearest. Gives how many of them are not baked into what stands still.
    fn light(&mut self, frame: &Frame, hero: Option<PointLight>) -> usize {
        self.lit.clear();
        let aim = frame.camera.target;
        self.riding.clear();
        lamps::choose(self.carried.lamps(frame.offsets), aim, &mut self.riding);
        self.riding.truncate(RIDING_LIGHTS);
        lamps::choose(self.lamps.iter().copied(), aim, &mut self.lit);
        self.lit.truncate(frame::MAX_LIGHTS - 3 - self.riding.len());
        let standing = self.lit.len();
        self.lit.extend(&self.riding);
        self.lit
            .extend(self.shards.light(frame.view, frame.offsets));
        if let (Some(at), Some(gate)) = (frame.view.won_at, self.gate) {
            let share = (frame.view.time - at).clamp(0.0, 1.0) as f32;
            self.lit.push(PointLight {
                colour: gate.colour * share,
                ..gate
            });
        }
        self.lit.extend(hero);
        let moving = self.lit.len() - standing;
        self.lit.rotate_right(moving);
        moving
    }

    /// The height of what is under the hero; far below where nothing is.
    fn ground_below(&self, view: &View, offsets: &[DVec2]) -> f32 {
        let foot = view.position.as_vec2();
        match view.stance {
            Stance::Ground | Stance::Wedge => foot.y,
            Stance::Air | Stance::Slide | Stance::Climb => {
                self.ground.below(foot, offsets).unwrap_or(f32::MIN / 2.0)
            }
        }
    }
}

/// The shadow map of a preset that has one.
fn shadow_map(gl: &Gl, quality: &Quality) -> Result<Option<Surface>, String> {
    let side = quality.shadow_side;
    side.map(|side| Surface::depth(gl, side)).transpose()
}
