//! The passes, in one flat list, and a program for each.

use super::canvas::Stages;
use super::frame::FrameBlock;
use super::gl::{Bound, Gl, Program};
use super::program::{self, Library};
use super::quality::Quality;
use super::scene::Chunk;
use super::state::{Blend, Cull, Depth};
use super::{RenderError, Renderer};
use std::ops::Range;
use std::path::Path;

/// Texture units, in the order of [`program::SAMPLERS`].
const SHADOW_UNIT: u32 = 0;
const LIGHT_UNIT: u32 = 1;
const BLOOM_UNIT: u32 = 2;
const SCREEN_UNIT: u32 = 3;
const PIECE_UNIT: u32 = 4;
/// What shows where no sky is drawn.
const DARK: [f32; 3] = [0.0; 3];

/// What a picture is made of, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Depth of everything near, seen from the key light.
    Shadow,
    /// The hero, the level and the distance.
    World,
    /// The water under the level.
    Water,
    /// The gradient of the sky.
    Sky,
    /// Sun, stars and clouds.
    Clouds,
    /// The light around lamps.
    Halos,
    /// Dust, embers, leaves, puffs, and the shadow right below the hero.
    Motes,
    /// What glows.
    Bloom,
    /// The way of the picture to the window that smooths or enlarges it.
    Finish,
}

impl Pass {
    /// All of them, in order.
    pub const ALL: [Pass; 9] = [
        Pass::Shadow,
        Pass::World,
        Pass::Water,
        Pass::Sky,
        Pass::Clouds,
        Pass::Halos,
        Pass::Motes,
        Pass::Bloom,
        Pass::Finish,
    ];
}

/// One program for each pass.
pub(super) struct Programs {
    shadow: Program,
    placed_shadow: Program,
    world: Program,
    piece: Program,
    loose: Program,
    hero: Program,
    hero_shadow: Program,
    hero_line: Program,
    water: Program,
    sky: Program,
    cloud: Program,
    glow: Program,
    mote: Program,
    bright: Program,
    shrink: Program,
    grow: Program,
    tone: Program,
    resolve: Program,
    line: Program,
    flat: Program,
}

impl Programs {
    pub(super) fn load(gl: &Gl, dir: &Path, quality: &Quality) -> Result<Programs, RenderError> {
        let defines = &quality.defines();
        let library = Library { dir, defines };
        let load = |vertex, fragment| program::load(gl, &library, vertex, fragment);
        Ok(Programs {
            shadow: load("shadow", "shadow")?,
            placed_shadow: load("placed_shadow", "shadow")?,
            world: load("world", "world")?,
            piece: load("piece", "world")?,
            loose: load("loose", "world")?,
            hero: load("hero", "world")?,
            hero_shadow: load("hero_shadow", "shadow")?,
            hero_line: load("hero_line", "tint")?,
            water: load("water", "water")?,
            sky: load("sky", "sky")?,
            cloud: load("cloud", "tint")?,
            glow: load("glow", "soft")?,
            mote: load("mote", "soft")?,
            bright: load("whole", "bright")?,
            shrink: load("whole", "shrink")?,
            grow: load("whole", "grow")?,
            tone: load("whole", quality.last_shader())?,
            resolve: load("whole", "resolve")?,
            line: load("line", "flat")?,
            flat: load("flat", "flat")?,
        })
    }
}

impl Renderer {
    /// The world in a window of a size.
    pub(super) fn draw_scene(
        &self,
        block: &FrameBlock,
        hero: Range<usize>,
        stages: &Stages,
        window: (Bound, (u32, u32)),
    ) {
        if let Some(map) = &self.shadow_map {
            map.draw_into(&self.gl);
            if self.runs(Pass::Shadow) {
                self.shadow_pass(block, hero.clone());
            }
            map.read_from(&self.gl, SHADOW_UNIT);
        }
        stages.scene.draw_into(&self.gl);
        if !self.runs(Pass::Sky) {
            self.gl.fill(DARK);
        }
        if self.runs(Pass::World) {
            self.world_pass(block, hero);
        }
        if self.runs(Pass::Water) {
            self.water_pass();
        }
        if self.runs(Pass::Sky) {
            self.sky_pass();
        }
        if self.runs(Pass::Clouds) {
            self.clouds_pass();
        }
        if self.runs(Pass::Halos) {
            self.halos_pass();
        }
        if self.runs(Pass::Motes) {
            self.motes_pass();
        }
        stages.scene.resolve(&self.gl);
        self.bloom_pass(stages);
        self.screen_pass(stages, window);
    }

    /// Whether a pass is drawn.
    fn runs(&self, pass: Pass) -> bool {
        self.left_out != Some(pass)
    }

    /// Depth of everything near, seen from the key light.
    fn shadow_pass(&self, block: &FrameBlock, hero: Range<usize>) {
        self.gl.state(Depth::Write, Blend::Off, Cull::Off);
        self.gl
            .triangles(&self.programs.hero_shadow, &self.hero.mesh, hero);
        let programs = &self.programs;
        self.crowd.draw_casting(&programs.placed_shadow);
        let chunks = self.chunks.iter();
        for chunk in chunks.filter(|chunk| block.shades(chunk.min, chunk.max)) {
            self.gl
                .triangles(&programs.shadow, &self.world, self.part(chunk));
        }
    }

    /// The vertices of a chunk that are not drawn as instances: all of them if there was no room for the light of those.
    fn part(&self, chunk: &Chunk) -> Range<usize> {
        match self.crowd.has_still() {
            true => chunk.bare.clone(),
            false => chunk.vertices.clone(),
        }
    }

    /// The hero, the level and the distance: from front to back, so that hidden fragments cost little.
    fn world_pass(&self, block: &FrameBlock, hero: Range<usize>) {
        self.gl.state(Depth::Write, Blend::Off, Cull::Back);
        self.gl
            .triangles(&self.programs.hero, &self.hero.mesh, hero.clone());
        if self.hero.is_marked() {
            self.gl
                .triangles(&self.programs.hero_line, &self.hero.mesh, hero);
        }
        let programs = &self.programs;
        self.crowd.draw_loose(&programs.loose);
        let chunks = self.chunks.iter();
        for chunk in chunks.filter(|chunk| block.sees(chunk.min, chunk.max)) {
            self.gl
                .triangles(&programs.world, &self.world, self.part(chunk));
        }
        self.crowd.draw_still(&programs.piece, PIECE_UNIT);
    }

    /// The water under the level.
    fn water_pass(&self) {
        self.gl.state(Depth::Write, Blend::Off, Cull::Off);
        self.gl
            .triangles(&self.programs.water, &self.water, 0..usize::MAX);
    }

    /// The gradient of the sky, wherever nothing else is.
    fn sky_pass(&self) {
        self.gl.state(Depth::Test, Blend::Off, Cull::Off);
        self.gl
            .triangles(&self.programs.sky, &self.sky, 0..usize::MAX);
    }

    /// Sun, stars and clouds.
    fn clouds_pass(&self) {
        self.gl.state(Depth::Test, Blend::Over, Cull::Off);
        self.gl
            .triangles(&self.programs.cloud, &self.firmament, 0..usize::MAX);
    }

    /// The light around lamps, over the scene but behind what is nearer.
    fn halos_pass(&self) {
        self.gl.state(Depth::Test, Blend::Over, Cull::Off);
        self.gl.instances(&self.programs.glow, &self.air.glows, 6);
    }

    /// What floats in the air.
    fn motes_pass(&self) {
        self.gl.state(Depth::Test, Blend::Over, Cull::Off);
        self.gl
            .triangles(&self.programs.mote, &self.air.motes, 0..usize::MAX);
    }

    /// What glows: the bright parts of the scene, made smaller and smaller, then added up again.
    fn bloom_pass(&self, stages: &Stages) {
        let gl = &self.gl;
        gl.state(Depth::Off, Blend::Off, Cull::Off);
        if !self.runs(Pass::Bloom) {
            stages.bloom.first().inspect(|stage| stage.draw_into(gl));
            return gl.fill(DARK);
        }
        let mut source = &stages.scene;
        for (number, stage) in stages.bloom.iter().enumerate() {
            source.read_from(gl, LIGHT_UNIT);
            stage.draw_into(gl);
            let program = match number {
                0 => &self.programs.bright,
                _ => &self.programs.shrink,
            };
            gl.triangles(program, &self.whole, 0..3);
            source = stage;
        }
        gl.state(Depth::Off, Blend::Over, Cull::Off);
        for pair in stages.bloom.windows(2).rev() {
            pair[1].read_from(gl, LIGHT_UNIT);
            pair[0].draw_into(gl);
            gl.triangles(&self.programs.grow, &self.whole, 0..3);
        }
    }

    /// The picture in the window: from linear light to the screen, at once or by way of a last pass that smooths.
    fn screen_pass(&self, stages: &Stages, (window, size): (Bound, (u32, u32))) {
        let gl = &self.gl;
        gl.state(Depth::Off, Blend::Off, Cull::Off);
        stages.scene.read_from(gl, LIGHT_UNIT);
        if let Some(bloom) = stages.bloom.first() {
            bloom.read_from(gl, BLOOM_UNIT);
        }
        let screen = stages.screen.as_ref().filter(|_| self.runs(Pass::Finish));
        if let Some(screen) = screen {
            screen.draw_into(gl);
            gl.triangles(&self.programs.tone, &self.whole, 0..3);
            screen.read_from(gl, SCREEN_UNIT);
        }
        gl.bind(window);
        gl.viewport(size.0, size.1);
        let program = match screen {
            Some(_) => &self.programs.resolve,
            None => &self.programs.tone,
        };
        gl.triangles(program, &self.whole, 0..3);
    }

    /// Developers' drawings, over everything.
    pub(super) fn debug_pass(&self) {
        self.gl.state(Depth::Off, Blend::Over, Cull::Off);
        self.gl
            .triangles(&self.programs.flat, &self.debug.tris, 0..usize::MAX);
        self.gl.instances(&self.programs.line, &self.debug.lines, 6);
    }
}
