//! The typefaces: which one has a character, how far it carries the pen, how two of them are kerned.

use crate::cli::files::{self, FileError};
use fontdue::{Font, FontSettings};
use std::cell::OnceCell;
use std::path::Path;

const DISPLAY_FILE: &str = "assets/fonts/Quattrocento-Regular.otf";
const BODY_FILE: &str = "assets/fonts/Cabin-Medium.otf";
/// Many scripts, for the names of keys; large, so it is read when first needed.
const FALLBACK_FILE: &str = "assets/fonts/DejaVuSans.ttf";
/// Sizes in pixels that outlines are made ready for.
const DISPLAY_SCALE: f32 = 120.0;
const BODY_SCALE: f32 = 60.0;
/// Size at which proportions are measured.
const MEASURE: f32 = 100.0;
/// Width of the box that stands for a missing character, as a share of the size.
pub const BOX_WIDTH: f32 = 0.55;

/// What text is set in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Face {
    /// For titles and names: a Roman of stone-cut proportions.
    Display,
    /// For everything that is read.
    Body,
}

/// Which font a glyph comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// The one that was asked for.
    Of(Face),
    /// The one that has what the others lack.
    Fallback,
}

/// A glyph, or the lack of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Glyph {
    /// Its font.
    pub origin: Origin,
    /// Its number there; 0 if no font has the character.
    pub index: u16,
}

impl Glyph {
    /// No font has the character: a box is drawn.
    pub fn is_missing(self) -> bool {
        self.index == 0
    }
}

/// The pixels of a glyph and where they lie.
pub struct Bitmap {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// From the pen to the left edge, pixels.
    pub left: i32,
    /// From the baseline up to the top edge, pixels.
    pub top: i32,
    /// Coverage, 0 to 255, rows from the top down.
    pub pixels: Vec<u8>,
}

/// The fonts that are loaded.
pub struct Fonts {
    display: Font,
    body: Font,
    fallback: OnceCell<Option<Font>>,
    cap: [f32; 2],
}

impl Fonts {
    /// Reads the two typefaces.
    ///
    /// # Errors
    /// A file is missing or no font.
    pub fn load() -> Result<Fonts, FileError> {
        let display = read(DISPLAY_FILE, DISPLAY_SCALE)?;
        let body = read(BODY_FILE, BODY_SCALE)?;
        let cap = |font: &Font| font.metrics('H', MEASURE).bounds.height / MEASURE;
        Ok(Fonts {
            cap: [cap(&display), cap(&body)],
            display,
            body,
            fallback: OnceCell::new(),
        })
    }

    /// The glyph of a character.
    pub fn glyph(&self, face: Face, c: char) -> Glyph {
        let own = self.face(face).lookup_glyph_index(c);
        if own != 0 || c.is_whitespace() {
            return Glyph {
                origin: Origin::Of(face),
                index: own,
            };
        }
        let index = self.fallback().map_or(0, |font| font.lookup_glyph_index(c));
        Glyph {
            origin: Origin::Fallback,
            index,
        }
    }

    /// How far a glyph carries the pen, in pixels at a size in pixels.
    pub fn advance(&self, glyph: Glyph, px: f32) -> f32 {
        match self.font(glyph.origin) {
            Some(font) if !glyph.is_missing() => {
                font.metrics_indexed(glyph.index, px).advance_width
            }
            _ => BOX_WIDTH * px,
        }
    }

    /// What is added between two glyphs, in pixels.
    pub fn kern(&self, left: Glyph, right: Glyph, px: f32) -> f32 {
        if left.origin != right.origin {
            return 0.0;
        }
        let font = self.font(left.origin);
        font.and_then(|font| font.horizontal_kern_indexed(left.index, right.index, px))
            .unwrap_or(0.0)
    }

    /// Height of capitals as a share of the size.
    pub fn cap_height(&self, face: Face) -> f32 {
        self.cap[face as usize]
    }

    /// A glyph in pixels; nothing if it is missing.
    pub fn rasterise(&self, glyph: Glyph, px: f32) -> Option<Bitmap> {
        let font = self.font(glyph.origin).filter(|_| !glyph.is_missing())?;
        let (metrics, pixels) = font.rasterize_indexed(glyph.index, px);
        Some(Bitmap {
            width: metrics.width,
            height: metrics.height,
            left: metrics.xmin,
            top: metrics.ymin + metrics.height as i32,
            pixels,
        })
    }

    fn face(&self, face: Face) -> &Font {
        match face {
            Face::Display => &self.display,
            Face::Body => &self.body,
        }
    }

    fn font(&self, origin: Origin) -> Option<&Font> {
        match origin {
            Origin::Of(face) => Some(self.face(face)),
            Origin::Fallback => self.fallback(),
        }
    }

    /// Without it there are boxes: no reason to stop the game.
    fn fallback(&self) -> Option<&Font> {
        self.fallback
            .get_or_init(|| read(FALLBACK_FILE, BODY_SCALE).ok())
            .as_ref()
    }
}

fn read(path: &str, scale: f32) -> Result<Font, FileError> {
    let path = files::find(Path::new(path));
    let settings = FontSettings {
        scale,
        load_substitutions: false,
        ..FontSettings::default()
    };
    Font::from_bytes(files::read(&path)?, settings)
        .map_err(|reason| FileError::new(&path, format!("is not a font: {reason}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_typeface_lacks_comes_from_another_and_what_all_lack_is_missing() {
        let fonts = Fonts::load().unwrap();
        let origin = |c| fonts.glyph(Face::Body, c).origin;
        assert_eq!(origin('Q'), Origin::Of(Face::Body));
        assert_eq!(origin('Ж'), Origin::Fallback);
        assert!(fonts.glyph(Face::Body, '\u{1F3AE}').is_missing());
        assert!(!fonts.glyph(Face::Body, 'Ж').is_missing());
    }

    #[test]
    fn capitals_have_the_height_that_the_fonts_state() {
        let fonts = Fonts::load().unwrap();
        assert!((fonts.cap_height(Face::Display) - 0.66).abs() < 0.02);
        assert!((fonts.cap_height(Face::Body) - 0.70).abs() < 0.02);
    }
}
