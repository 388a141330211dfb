//! Where the scene is drawn before it comes to the window: in linear light, at the preset's resolution.

use super::gl::Gl;
use super::quality::Quality;
use super::surface::Surface;

/// Most texels of a scene: those of a display of 5120 by 2880 points.
const MOST: f32 = 5120.0 * 2880.0;

/// The scene's surface, made anew when the window's size changes.
#[derive(Default)]
pub struct Canvas {
    scene: Option<Surface>,
    wanted: (u32, u32),
}

impl Canvas {
    /// Makes the surface fit a window. If OpenGL has no room for that, the one before remains.
    pub fn fit(&mut self, gl: &Gl, quality: &Quality, window: (u32, u32)) {
        let size = scene_size(quality.scale, window, gl.largest_side());
        if self.wanted == size {
            return;
        }
        self.wanted = size;
        if let Ok(scene) = Surface::scene(gl, size, quality.samples) {
            self.scene = Some(scene);
        }
    }

    /// The scene's surface; none if there never was room for one.
    pub fn scene(&self) -> Option<&Surface> {
        self.scene.as_ref()
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
