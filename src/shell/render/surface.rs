//! Pictures that passes draw into: the shadow map, the scene, the stages of the bloom.

use super::gl::{Gl, Owned};
use super::state::{Spec, Texels};

/// A picture that passes draw into and later ones read.
pub struct Surface {
    size: (u32, u32),
    /// What is drawn into: the texture itself, or what has several samples a pixel.
    drawn: Owned,
    /// What is read, and a framebuffer that leads to it if `drawn` does not.
    texture: Owned,
    resolved: Option<Owned>,
    _depth: Option<Owned>,
    _samples: Option<Owned>,
}

impl Surface {
    /// A map of depths.
    pub fn depth(gl: &Gl, side: u32) -> Result<Surface, String> {
        Surface::new(gl, (side, side), Texels::Depth, 0)
    }

    /// A picture without depth.
    pub fn flat(gl: &Gl, size: (u32, u32), texels: Texels) -> Result<Surface, String> {
        Surface::new(gl, size, texels, 0)
    }

    /// A picture with depth, of one or several samples a pixel.
    pub fn scene(
        gl: &Gl,
        size: (u32, u32),
        texels: Texels,
        samples: u32,
    ) -> Result<Surface, String> {
        let bound = gl.bound();
        let built = Surface::build_scene(gl, size, texels, samples);
        gl.bind(bound);
        built
    }

    fn build_scene(
        gl: &Gl,
        size: (u32, u32),
        colours: Texels,
        samples: u32,
    ) -> Result<Surface, String> {
        let spec = |texels, samples| Spec {
            size,
            texels,
            samples,
        };
        let texture = texture(gl, spec(colours, 0))?;
        let depth = gl.renderbuffer(&spec(Texels::Depth, samples))?;
        if samples == 0 {
            let drawn = gl.framebuffer(&[(colours, &texture), (Texels::Depth, &depth)])?;
            return Ok(Surface {
                size,
                drawn,
                texture,
                resolved: None,
                _depth: Some(depth),
                _samples: None,
            });
        }
        let several = gl.renderbuffer(&spec(colours, samples))?;
        let drawn = gl.framebuffer(&[(colours, &several), (Texels::Depth, &depth)])?;
        let resolved = Some(gl.framebuffer(&[(colours, &texture)])?);
        Ok(Surface {
            size,
            drawn,
            texture,
            resolved,
            _depth: Some(depth),
            _samples: Some(several),
        })
    }

    fn new(gl: &Gl, size: (u32, u32), texels: Texels, samples: u32) -> Result<Surface, String> {
        let bound = gl.bound();
        let texture = texture(
            gl,
            Spec {
                size,
                texels,
                samples,
            },
        )?;
        let drawn = gl.framebuffer(&[(texels, &texture)]);
        gl.bind(bound);
        Ok(Surface {
            size,
            drawn: drawn?,
            texture,
            resolved: None,
            _depth: None,
            _samples: None,
        })
    }

    /// Makes it the target and clears its depth.
    pub fn draw_into(&self, gl: &Gl) {
        gl.bind(self.drawn.target());
        gl.viewport(self.size.0, self.size.1);
    }

    /// Lets shaders read it, at a texture unit: what was drawn before.
    pub fn read_from(&self, gl: &Gl, unit: u32) {
        gl.read_from(unit, &self.texture);
    }

    /// Ends drawing into it: of several samples a pixel, the mean is taken.
    pub fn resolve(&self, gl: &Gl) {
        if let Some(resolved) = &self.resolved {
            gl.copy(self.drawn.target(), resolved.target(), self.size);
        }
    }
}

/// A texture that is read smoothly, and up to its rim; one of depths is read by comparison.
fn texture(gl: &Gl, spec: Spec) -> Result<Owned, String> {
    let compare = match spec.texels {
        Texels::Depth => glow::COMPARE_REF_TO_TEXTURE,
        Texels::Light | Texels::Screen | Texels::Coverage => glow::NONE,
    };
    let parameters = [
        (glow::TEXTURE_MIN_FILTER, glow::LINEAR),
        (glow::TEXTURE_MAG_FILTER, glow::LINEAR),
        (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
        (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
        (glow::TEXTURE_COMPARE_MODE, compare),
        (glow::TEXTURE_COMPARE_FUNC, glow::LEQUAL),
    ];
    gl.texture(&spec, &parameters)
}
