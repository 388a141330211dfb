//! Where a picture is put together before it comes to the window: the scene at the preset's resolution,
//! the stages of its bloom, and the picture as the screen will have it.

use super::gl::Gl;
use super::quality::{Finish, Quality};
use super::state::Texels;
use super::surface::Surface;

/// Most texels of a scene: those of a display of 5120 by 2880 points.
const MOST: f32 = 5120.0 * 2880.0;
/// The first stage of the bloom has a quarter of the scene's sides, each further one half of the one before.
const FIRST_STAGE: u32 = 4;

/// Surfaces of one size of the window.
pub struct Stages {
    /// The scene: in linear light, or as on the screen.
    pub scene: Surface,
    /// The bloom, from the largest stage to the smallest.
    pub bloom: Vec<Surface>,
    /// The picture as on the screen, where that is not drawn into the window at once.
    pub screen: Option<Surface>,
}

/// The surfaces, made anew when the window's size changes.
#[derive(Default)]
pub struct Canvas {
    stages: Option<Stages>,
    wanted: (u32, u32),
}

impl Canvas {
    /// Makes the surfaces fit a window. If OpenGL has no room for them, those of before remain.
    pub fn fit(&mut self, gl: &Gl, quality: &Quality, window: (u32, u32)) {
        let size = scene_size(quality.scale, window, gl.largest_side());
        if self.wanted == size {
            return;
        }
        self.wanted = size;
        if let Ok(stages) = Stages::new(gl, quality, size) {
            self.stages = Some(stages);
        }
    }

    /// The surfaces; none if there never was room for them.
    pub fn stages(&self) -> Option<&Stages> {
        self.stages.as_ref()
    }
}

impl Stages {
    fn new(gl: &Gl, quality: &Quality, size: (u32, u32)) -> Result<Stages, String> {
        let stage = |number: u32| {
            let share = FIRST_STAGE << number;
            let size = ((size.0 / share).max(1), (size.1 / share).max(1));
            Surface::flat(gl, size, quality.texels)
        };
        let screen =
            (quality.finish != Finish::AtOnce).then(|| Surface::flat(gl, size, Texels::Screen));
        Ok(Stages {
            scene: Surface::scene(gl, size, quality.texels, quality.samples)?,
            bloom: (0..quality.bloom_stages)
                .map(stage)
                .collect::<Result<_, _>>()?,
            screen: screen.transpose()?,
        })
    }
}

/// Texels of the scene of a window: so many for a pixel, but not more than the driver and [`MOST`] allow.
fn scene_size(scale: f32, (width, height): (u32, u32), largest: u32) -> (u32, u32) {
    let (w, h) = (width as f32 * scale, height as f32 * scale);
    let fit = (MOST / (w * h)).sqrt().min(1.0);
    let side = |texels: f32| (texels * fit).round().clamp(1.0, largest as f32) as u32;
    (side(w), side(h))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_have_the_windows_size_times_the_scale_within_bounds() {
        assert_eq!(scene_size(1.0, (1280, 720), 16384), (1280, 720));
        assert_eq!(scene_size(0.6, (1280, 720), 16384), (768, 432));
        assert_eq!(scene_size(0.5, (1, 1), 16384), (1, 1));
        let (w, h) = scene_size(1.0, (16_000, 9_000), 8192);
        assert!(w <= 8192 && (w as f32) * (h as f32) < MOST * 1.01);
        assert_eq!(scene_size(1.0, (u32::MAX, 1), 4096), (4096, 1));
    }
}
