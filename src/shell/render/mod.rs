//! The picture: a stage and a view of the game in, one frame out.
//!
//! OpenGL 3.3 core. Everything is flat-shaded triangles with colours per vertex and no textures; lighting is worked out in
//! linear light. The scene is drawn at the preset's resolution, and the last pass brings it to the window.

mod air;
mod backdrop;
mod canvas;
mod carried;
mod dangers;
mod debug;
mod error;
mod facets;
mod fixtures;
mod frame;
pub(in crate::shell) mod gl;
mod growth;
mod guides;
mod hero;
mod kit;
mod lamps;
mod model;
pub(in crate::shell) mod program;
mod quality;
mod scene;
mod scenery;
mod shards;
pub(in crate::shell) mod state;
mod surface;
mod terrain;
mod water;

pub use crate::cli::Preset;
pub use error::RenderError;
pub use frame::{CameraPose, Frame, Line, PointLight, Tri};
pub use gl::load;

use crate::anim::Rig;
use crate::game::Stage;
use air::Air;
use canvas::Canvas;
use carried::Carried;
use debug::Debug;
use frame::FrameBlock;
use gl::{Geometry, Gl, Program, Uniforms};
use glam::{Vec3, Vec4};
use hero::Hero;
use kit::Kit;
use program::Library;
use quality::Quality;
use scene::{Chunk, Scene};
use shards::Shards;
use state::{Blend, Cull, Depth, Format};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;
use surface::Surface;

/// Layout of the model's vertices: position, normal, colour, traits.
const VERTEX: [Format; 4] = [Format::F3, Format::Snorm4, Format::Unorm4, Format::Unorm4];
/// Behind the debug lines when the world is not drawn.
const BACKGROUND: [f32; 3] = [0.07, 0.08, 0.10];
/// Texture units, in the order of [`program::SAMPLERS`].
const SHADOW_UNIT: u32 = 0;
const LIGHT_UNIT: u32 = 1;

/// Draws frames. Owns everything it made in its OpenGL context.
pub struct Renderer {
    gl: Gl,
    shader_dir: PathBuf,
    quality: Quality,
    programs: Programs,
    frame_uniforms: Uniforms,
    shadow_map: Option<Surface>,
    canvas: Canvas,
    /// Three corners for passes over the whole picture.
    whole: Geometry,
    world: Geometry,
    chunks: Vec<Chunk>,
    kit: Kit,
    carried: Carried,
    shards: Shards,
    movers: Geometry,
    hero: Hero,
    water: Geometry,
    water_height: f32,
    air: Air,
    debug: Debug,
    /// All lamps of the stage, and those of the current picture.
    lamps: Vec<PointLight>,
    lit: Vec<PointLight>,
    gate: Option<PointLight>,
    /// Room to put uploads together in, kept from frame to frame.
    words: Vec<u32>,
}

/// One program for each pass.
struct Programs {
    shadow: Program,
    world: Program,
    hero: Program,
    hero_shadow: Program,
    hero_line: Program,
    water: Program,
    sky: Program,
    glow: Program,
    mote: Program,
    resolve: Program,
    line: Program,
    flat: Program,
}

impl Programs {
    fn load(gl: &Gl, dir: &Path, quality: &Quality) -> Result<Programs, RenderError> {
        let defines = &quality.defines();
        let library = Library { dir, defines };
        let load = |vertex, fragment| program::load(gl, &library, vertex, fragment);
        Ok(Programs {
            shadow: load("shadow", "shadow")?,
            world: load("world", "world")?,
            hero: load("hero", "world")?,
            hero_shadow: load("hero_shadow", "shadow")?,
            hero_line: load("hero_line", "flat")?,
            water: load("water", "water")?,
            sky: load("sky", "sky")?,
            glow: load("glow", "soft")?,
            mote: load("mote", "soft")?,
            resolve: load("whole", "resolve")?,
            line: load("line", "flat")?,
            flat: load("flat", "flat")?,
        })
    }
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
            whole,
            quality,
            world: gl.geometry(&VERTEX, false)?,
            chunks: Vec::new(),
            kit: Kit::load(models)?,
            carried: Carried::default(),
            shards: Shards::default(),
            movers: gl.geometry(&VERTEX, false)?,
            hero: Hero::new(&gl)?,
            water: water::surface(&gl)?,
            water_height: 0.0,
            air: Air::new(&gl)?,
            debug: Debug::new(&gl)?,
            lamps: Vec::new(),
            gate: None,
            lit: Vec::with_capacity(frame::MAX_LIGHTS + 1),
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
        self.carried = Carried::of(stage, &self.kit);
        self.lamps = scene.lamps;
        self.gate = scene.gate;
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
        if let (true, Some(scene)) = (frame.show_world, self.canvas.scene()) {
            self.shadow_pass(&block, hero.clone());
            scene.draw_into(&self.gl);
            self.world_pass(&block, hero);
            self.water_pass();
            self.sky_pass();
            self.air_pass();
            scene.resolve(&self.gl);
            self.gl.bind(window);
            self.gl.viewport(size.0, size.1);
            self.resolve_pass(scene);
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
        rows.rev().flatten().copied().collect()
    }

    /// The first OpenGL error since the last call, as OpenGL's number.
    pub fn take_error(&self) -> Option<u32> {
        self.gl.take_error()
    }

    /// Hands the frame's values to the GPU.
    fn upload(&mut self, frame: &Frame, size: (u32, u32)) -> FrameBlock {
        let foot = frame.view.position.as_vec2().extend(0.0);
        let lamp = self.hero.upload(frame.hero, frame.time, &mut self.words);
        self.light(frame, lamp);
        let (puff, strength) = self.air.puff(frame.view, foot);
        let block = FrameBlock {
            hero: foot.extend(0.0),
            puff,
            scene: Vec4::new(0.0, self.water_height, 0.0, strength),
            ..FrameBlock::new(&frame.camera, size, frame.time)
        };
        block.write(&self.lit, &mut self.words);
        self.frame_uniforms.upload(&self.words);
        self.carried.write(frame.offsets, &mut self.words);
        let aim = frame.camera.target;
        self.shards
            .write(frame.view, aim, frame.time, &mut self.words);
        self.movers.upload(&self.words);
        self.air.upload(&self.lit, &mut self.words);
        self.debug.upload(frame.lines, frame.tris, &mut self.words);
        block
    }

    /// Chooses the lamps of a picture: the hero's always, the checkpoint's that holds, the gate's second light once it is
    /// reached, then the nearest.
    fn light(&mut self, frame: &Frame, hero: Option<PointLight>) {
        self.lit.clear();
        lamps::choose(&self.lamps, frame.camera.target, &mut self.lit);
        self.lit.truncate(frame::MAX_LIGHTS - 3);
        self.lit.extend(self.shards.light(frame.view));
        if let (Some(at), Some(gate)) = (frame.view.won_at, self.gate) {
            let share = (frame.view.time - at).clamp(0.0, 1.0) as f32;
            self.lit.push(PointLight {
                colour: gate.colour * share,
                ..gate
            });
        }
        self.lit.extend(hero);
    }

    /// Depth of everything near, seen from the key light.
    fn shadow_pass(&self, block: &FrameBlock, hero: Range<usize>) {
        let Some(shadow_map) = &self.shadow_map else {
            return;
        };
        shadow_map.draw_into(&self.gl);
        self.gl.state(Depth::Write, Blend::Off, Cull::Off);
        self.gl
            .triangles(&self.programs.hero_shadow, &self.hero.mesh, hero.clone());
        self.gl
            .triangles(&self.programs.shadow, &self.movers, 0..usize::MAX);
        for chunk in self
            .chunks
            .iter()
            .filter(|chunk| block.shades(chunk.min, chunk.max))
        {
            self.gl
                .triangles(&self.programs.shadow, &self.world, chunk.vertices.clone());
        }
    }

    /// The hero, the level and the distance: from front to back, so that hidden fragments cost little.
    fn world_pass(&self, block: &FrameBlock, hero: Range<usize>) {
        if let Some(shadow_map) = &self.shadow_map {
            shadow_map.read_from(&self.gl, SHADOW_UNIT);
        }
        self.gl.state(Depth::Write, Blend::Off, Cull::Back);
        self.gl
            .triangles(&self.programs.hero, &self.hero.mesh, hero.clone());
        if self.hero.is_marked() {
            self.gl
                .triangles(&self.programs.hero_line, &self.hero.mesh, hero);
        }
        self.gl
            .triangles(&self.programs.world, &self.movers, 0..usize::MAX);
        for chunk in self
            .chunks
            .iter()
            .filter(|chunk| block.sees(chunk.min, chunk.max))
        {
            self.gl
                .triangles(&self.programs.world, &self.world, chunk.vertices.clone());
        }
    }

    /// The water under the level.
    fn water_pass(&self) {
        self.gl.state(Depth::Write, Blend::Off, Cull::Off);
        self.gl
            .triangles(&self.programs.water, &self.water, 0..usize::MAX);
    }

    /// The sky, wherever nothing else is.
    fn sky_pass(&self) {
        self.gl.state(Depth::Test, Blend::Off, Cull::Off);
        self.gl.triangles(&self.programs.sky, &self.whole, 0..3);
    }

    /// Halos, dust, embers and puffs, over the scene but behind what is nearer.
    fn air_pass(&self) {
        self.gl.state(Depth::Test, Blend::Over, Cull::Off);
        self.gl.instances(&self.programs.glow, &self.air.glows, 6);
        self.gl.instances(&self.programs.mote, &self.air.motes, 6);
    }

    /// The scene in the window: from linear light to the screen.
    fn resolve_pass(&self, scene: &Surface) {
        self.gl.state(Depth::Off, Blend::Off, Cull::Off);
        scene.read_from(&self.gl, LIGHT_UNIT);
        self.gl.triangles(&self.programs.resolve, &self.whole, 0..3);
    }

    /// Developers' drawings, over everything.
    fn debug_pass(&self) {
        self.gl.state(Depth::Off, Blend::Over, Cull::Off);
        self.gl
            .triangles(&self.programs.flat, &self.debug.tris, 0..usize::MAX);
        self.gl.instances(&self.programs.line, &self.debug.lines, 6);
    }
}

/// The shadow map of a preset that has one.
fn shadow_map(gl: &Gl, quality: &Quality) -> Result<Option<Surface>, String> {
    let side = quality.shadow_side;
    side.map(|side| Surface::depth(gl, side)).transpose()
}
