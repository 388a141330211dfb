//! What a preset means for the passes.

use super::state::Texels;
use crate::cli::Preset;

/// How the picture comes to the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finish {
    /// As it is: multisampling has smoothed its edges.
    AtOnce,
    /// By a pass that smooths steps along edges.
    Smoothed,
    /// By a pass that makes it larger.
    Enlarged,
}

/// What the passes do with a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Texels of the scene for a pixel of the window, along a side.
    pub scale: f32,
    /// What a texel of the scene holds: linear light; or the colour that the screen will have, which takes half the memory and no
    /// pass of its own to the screen, but sums lights only about as they are.
    pub texels: Texels,
    /// Texels along the shadow map's side; without one, shadows are those that were baked into the vertices.
    pub shadow_side: Option<u32>,
    /// Samples for a texel of the scene; 0 for one without multisampling.
    pub samples: u32,
    /// How the picture comes to the window.
    pub finish: Finish,
    /// Stages of the bloom.
    pub bloom_stages: u32,
    /// Whether lamps light each pixel, rather than the corners of facets, and shadows are filtered with care.
    pub per_pixel: bool,
    /// The share of dust, embers and leaves that flies.
    pub motes: f32,
    /// How dark it is right below the hero, beside the shadow map.
    pub blob: f32,
}

impl Quality {
    /// What a preset means.
    pub fn of(preset: Preset) -> Quality {
        match preset {
            Preset::Low => Quality {
                scale: 0.5,
                texels: Texels::Screen,
                shadow_side: None,
                samples: 0,
                finish: Finish::Enlarged,
                bloom_stages: 2,
                per_pixel: false,
                motes: 0.35,
                blob: 0.62,
            },
            Preset::Medium => Quality {
                scale: 1.0,
                texels: Texels::Light,
                shadow_side: Some(1024),
                samples: 0,
                finish: Finish::Smoothed,
                bloom_stages: 3,
                per_pixel: false,
                motes: 0.6,
                blob: 0.5,
            },
            Preset::High => Quality {
                scale: 1.0,
                texels: Texels::Light,
                shadow_side: Some(2048),
                samples: 4,
                finish: Finish::AtOnce,
                bloom_stages: 4,
                per_pixel: true,
                motes: 1.0,
                blob: 0.5,
            },
        }
    }

    /// The fragment shader that brings the scene's texels, one by one, to what the screen shows.
    pub fn last_shader(&self) -> &'static str {
        match self.texels {
            Texels::Screen => "edges",
            _ => "tone",
        }
    }

    /// The words that the shaders are compiled with.
    pub fn defines(&self) -> String {
        let mut lines = format!(
            "#define MOTES {:?}\n#define BLOB {:?}\n",
            self.motes, self.blob
        );
        if let Some(side) = self.shadow_side {
            lines += &format!("#define SHADOW_TEXELS {side}.0\n");
        }
        lines += match self.finish {
            Finish::AtOnce => "#define AT_ONCE\n",
            Finish::Smoothed => "",
            Finish::Enlarged => "#define ENLARGED\n",
        };
        if self.texels == Texels::Screen {
            lines += "#define SCREEN_TEXELS\n";
        }
        if self.per_pixel {
            lines += "#define PER_PIXEL\n#define SOFT_SHADOW\n";
        }
        lines
    }
}
