//! What a preset means for the passes.

use crate::cli::Preset;

/// What the passes do with a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Texels of the scene for a pixel of the window, along a side.
    pub scale: f32,
    /// Texels along the shadow map's side; without one, shadows are those that were baked into the vertices.
    pub shadow_side: Option<u32>,
    /// Samples for a texel of the scene; 0 for one without multisampling.
    pub samples: u32,
}

impl Quality {
    /// What a preset means.
    pub fn of(preset: Preset) -> Quality {
        match preset {
            Preset::Low => Quality {
                scale: 0.6,
                shadow_side: None,
                samples: 0,
            },
            Preset::Medium => Quality {
                scale: 1.0,
                shadow_side: Some(1024),
                samples: 0,
            },
            Preset::High => Quality {
                scale: 1.0,
                shadow_side: Some(2048),
                samples: 4,
            },
        }
    }

    /// The words that the shaders are compiled with.
    pub fn defines(&self) -> String {
        match self.shadow_side {
            Some(side) => format!("#define SHADOW_TEXELS {side}.0\n"),
            None => String::new(),
        }
    }
}
