//! A page: rectangles, drawings and text, put together from the back to the front.

use super::atlas::{Atlas, Key, Mark, SIDE, Slot, WHITE_AT};
use super::fonts::{BOX_WIDTH, Face, Fonts, Glyph};
use super::symbols::Symbol;
use crate::cli::files::FileError;

/// A colour as on the screen, and opacity.
pub type Colour = [f32; 4];

/// Colour and offset of shadows; the offset is a share of the text's size.
const SHADOW: [f32; 3] = [0.02, 0.02, 0.05];
const SHADOW_OPACITY: f32 = 0.75;
const SHADOW_DROP: f32 = 0.04;
/// Words of the page's vertices: place and place in the picture, then the colour.
const VERTEX_WORDS: usize = 5;
/// Smallest size that is drawn.
const SMALLEST: f32 = 4.0;

/// How a line of text looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The typeface.
    pub face: Face,
    /// Size in pixels.
    pub px: f32,
    /// What is added between letters, as a share of the size.
    pub tracking: f32,
    /// Its colour.
    pub colour: Colour,
    /// How strong its shadow is, 0 to 1.
    pub shadow: f32,
}

impl Style {
    /// The same in another colour.
    pub fn in_colour(self, colour: Colour) -> Style {
        Style { colour, ..self }
    }

    /// The same, so much fainter.
    pub fn faded(self, opacity: f32) -> Style {
        let [r, g, b, a] = self.colour;
        self.in_colour([r, g, b, a * opacity])
    }
}

/// Where a rectangle is: left, top, width, height.
pub type Rect = [f32; 4];

/// The fonts, the letters in use, and the page that is being filled.
pub struct Text {
    fonts: Fonts,
    atlas: Atlas,
    words: Vec<u32>,
    size: [f32; 2],
}

impl Text {
    /// An empty page.
    ///
    /// # Errors
    /// A font is missing or broken.
    pub fn new() -> Result<Text, FileError> {
        Ok(Text {
            fonts: Fonts::load()?,
            atlas: Atlas::default(),
            words: Vec::new(),
            size: [1.0; 2],
        })
    }

    /// Begins a page of so many pixels.
    pub fn begin(&mut self, (width, height): (u32, u32)) {
        self.words.clear();
        self.atlas.begin();
        self.size = [width.max(1) as f32, height.max(1) as f32];
    }

    /// Width and height of the page in pixels.
    pub fn size(&self) -> [f32; 2] {
        self.size
    }

    /// The vertices, three for each triangle.
    pub(super) fn words(&self) -> &[u32] {
        &self.words
    }

    /// The picture that they refer to.
    pub(super) fn atlas(&mut self) -> &mut Atlas {
        &mut self.atlas
    }

    /// How many rectangles, drawings and letters the page holds.
    pub fn quads(&self) -> usize {
        self.words.len() / VERTEX_WORDS / 6
    }

    /// How wide a line is, in pixels.
    pub fn width(&self, style: Style, line: &str) -> f32 {
        let mut pen = 0.0;
        self.walk(style, line, |_, _, end| pen = end);
        (pen - style.tracking * style.px).max(0.0)
    }

    /// Height of capitals, in pixels.
    pub fn cap_height(&self, style: Style) -> f32 {
        self.fonts.cap_height(style.face) * style.px
    }

    /// Writes a line from `x` on, its capitals standing on `baseline`; says where it ends.
    pub fn write(&mut self, style: Style, x: f32, baseline: f32, line: &str) -> f32 {
        let px = style.px.max(SMALLEST).round();
        if style.shadow > 0.0 {
            let [r, g, b] = SHADOW;
            let colour = [r, g, b, style.colour[3] * style.shadow * SHADOW_OPACITY];
            self.run(style, [x, baseline + px * SHADOW_DROP], line, true, colour);
        }
        self.run(style, [x, baseline], line, false, style.colour)
    }

    /// Writes a line around `x`.
    pub fn centred(&mut self, style: Style, x: f32, baseline: f32, line: &str) {
        let width = self.width(style, line);
        self.write(style, x - width / 2.0, baseline, line);
    }

    /// Writes a line that ends at `x`.
    pub fn ending(&mut self, style: Style, x: f32, baseline: f32, line: &str) {
        let width = self.width(style, line);
        self.write(style, x - width, baseline, line);
    }

    /// The lines that a text is broken into, between words, to be no wider than so many pixels.
    pub fn broken<'s>(&self, style: Style, text: &'s str, width: f32) -> Vec<&'s str> {
        let (mut lines, mut start, mut end) = (Vec::new(), 0, 0);
        for (gap, _) in text.match_indices(' ').chain([(text.len(), "")]) {
            if self.width(style, &text[start..gap]) > width && end > start {
                lines.push(&text[start..end]);
                start = end + 1;
            }
            end = gap;
        }
        lines.push(&text[start..]);
        lines
    }

    /// A filled rectangle.
    pub fn rect(&mut self, rect: Rect, colour: Colour) {
        self.shaded(rect, [colour; 4]);
    }

    /// A rectangle with a colour at each corner: top left, top right, bottom left, bottom right.
    pub fn shaded(&mut self, [x, y, width, height]: Rect, colours: [Colour; 4]) {
        let white = [WHITE_AT, WHITE_AT];
        self.quad([x, y], [x + width, y + height], white, white, colours);
    }

    /// A drawing in a square of `side` pixels around a point.
    pub fn symbol(&mut self, symbol: Symbol, [x, y]: [f32; 2], side: f32, colour: Colour) {
        let side = side.max(SMALLEST).round();
        self.mark(
            symbol,
            side,
            |_, slot| {
                let corner = [(x - side / 2.0).round(), (y - side / 2.0).round()];
                let (a, b) = texels(slot);
                (corner, corner.map(|c| c + side), a, b)
            },
            colour,
        );
    }

    /// A light that fades towards its rim, of any size.
    pub fn glow(&mut self, [x, y]: [f32; 2], [width, height]: [f32; 2], colour: Colour) {
        const TEXELS: f32 = 64.0;
        self.mark(
            Symbol::Glow,
            TEXELS,
            |_, slot| {
                let (a, b) = texels(slot);
                let from = [x - width / 2.0, y - height / 2.0];
                (from, [from[0] + width, from[1] + height], a, b)
            },
            colour,
        );
    }

    /// A field with round ends, filled or as an outline, at least as wide as high.
    pub fn pill(&mut self, [x, y, width, height]: Rect, filled: bool, colour: Colour) {
        let symbol = if filled {
            Symbol::Round
        } else {
            Symbol::RoundRing
        };
        let side = height.max(SMALLEST).round();
        let [x, y] = [x.round(), y.round()];
        let width = width.max(side).round();
        let half = side / 2.0;
        // Left end, the middle column stretched, right end.
        for (from, to, a, b) in [
            (0.0, half, 0.0, 0.5),
            (half, width - half, 0.5, 0.5),
            (width - half, width, 0.5, 1.0),
        ] {
            self.mark(
                symbol,
                side,
                |_, slot| {
                    let ([u0, v0], [u1, v1]) = texels(slot);
                    let u = |share: f32| u0 + (u1 - u0) * share;
                    ([x + from, y], [x + to, y + side], [u(a), v0], [u(b), v1])
                },
                colour,
            );
        }
    }

    /// A drawing at a place that depends on where it is in the picture.
    fn mark(
        &mut self,
        symbol: Symbol,
        side: f32,
        place: impl Fn(f32, Slot) -> ([f32; 2], [f32; 2], [f32; 2], [f32; 2]),
        colour: Colour,
    ) {
        let key = Key {
            mark: Mark::Symbol(symbol),
            px: side as u16,
            soft: false,
        };
        if let Some(slot) = self.atlas.slot(&self.fonts, key) {
            let (from, to, a, b) = place(side, slot);
            self.quad(from, to, a, b, [colour; 4]);
        }
    }

    /// The letters of a line, sharp or soft; where it ends.
    fn run(&mut self, style: Style, at: [f32; 2], line: &str, soft: bool, colour: Colour) -> f32 {
        let px = style.px.max(SMALLEST).round();
        let baseline = at[1].round();
        let mut end = at[0];
        let mut previous = None;
        for c in line.chars() {
            let glyph = self.fonts.glyph(style.face, c);
            let start = end + self.kern(previous, glyph, px);
            let mark = match glyph.is_missing() && !c.is_whitespace() {
                true => Mark::Symbol(Symbol::Missing),
                false => Mark::Glyph(glyph),
            };
            let (size, aside) = match mark {
                Mark::Glyph(_) => (px, 0.0),
                Mark::Symbol(_) => (
                    (px * BOX_SIZE).round(),
                    -(px * BOX_SIZE - px * BOX_WIDTH) / 2.0,
                ),
            };
            let key = Key {
                mark,
                px: size as u16,
                soft,
            };
            if let Some(slot) = self.atlas.slot(&self.fonts, key) {
                let x = (start + aside).round() + slot.left as f32;
                let y = baseline - slot.top as f32;
                let (a, b) = texels(slot);
                let to = [x + slot.width as f32, y + slot.height as f32];
                self.quad([x, y], to, a, b, [colour; 4]);
            }
            end = start + self.fonts.advance(glyph, px) + style.tracking * px;
            previous = Some(glyph);
        }
        end - style.tracking * px
    }

    /// Calls `see` with each letter, where it begins and where the next one would, without kerning towards that.
    fn walk(&self, style: Style, line: &str, mut see: impl FnMut(Glyph, f32, f32)) {
        let px = style.px.max(SMALLEST).round();
        let (mut end, mut previous) = (0.0, None);
        for c in line.chars() {
            let glyph = self.fonts.glyph(style.face, c);
            let start = end + self.kern(previous, glyph, px);
            end = start + self.fonts.advance(glyph, px) + style.tracking * px;
            see(glyph, start, end);
            previous = Some(glyph);
        }
    }

    fn kern(&self, previous: Option<Glyph>, glyph: Glyph, px: f32) -> f32 {
        previous.map_or(0.0, |left| self.fonts.kern(left, glyph, px))
    }

    /// Two triangles; places in pixels, places in the picture as shares of it, colours by corner.
    fn quad(
        &mut self,
        from: [f32; 2],
        to: [f32; 2],
        a: [f32; 2],
        b: [f32; 2],
        colours: [Colour; 4],
    ) {
        let [width, height] = self.size;
        let corner = |right: bool, down: bool| {
            let pick = |late: bool, axis: usize| {
                if late {
                    (to[axis], b[axis])
                } else {
                    (from[axis], a[axis])
                }
            };
            let ((x, u), (y, v)) = (pick(right, 0), pick(down, 1));
            let clip = [x / width * 2.0 - 1.0, 1.0 - y / height * 2.0, u, v];
            let colour = pack(colours[usize::from(down) * 2 + usize::from(right)]);
            let [x, y, u, v] = clip.map(f32::to_bits);
            [x, y, u, v, colour]
        };
        for (right, down) in [
            (false, false),
            (false, true),
            (true, false),
            (true, false),
            (false, true),
            (true, true),
        ] {
            self.words.extend(corner(right, down));
        }
    }
}

/// Side of the box for a missing character, as a share of the text's size.
const BOX_SIZE: f32 = 0.8;

/// The upper left and lower right corner of an entry, as shares of the picture.
fn texels(slot: Slot) -> ([f32; 2], [f32; 2]) {
    let share = |texel: usize| texel as f32 / SIDE as f32;
    (
        [share(slot.x), share(slot.y)],
        [share(slot.x + slot.width), share(slot.y + slot.height)],
    )
}

/// Four bytes, red first in memory.
fn pack(colour: Colour) -> u32 {
    let bytes = colour.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8);
    u32::from_ne_bytes(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STYLE: Style = Style {
        face: Face::Body,
        px: 20.0,
        tracking: 0.0,
        colour: [1.0; 4],
        shadow: 0.0,
    };

    fn text() -> Text {
        let mut text = Text::new().unwrap();
        text.begin((1280, 720));
        text
    }

    /// The corners of all quads in pixels.
    fn quads(text: &Text) -> Vec<[f32; 4]> {
        let place = |words: &[u32]| {
            let [x, y] = [f32::from_bits(words[0]), f32::from_bits(words[1])];
            [
                (x + 1.0) / 2.0 * text.size[0],
                (1.0 - y) / 2.0 * text.size[1],
            ]
        };
        text.words
            .chunks_exact(6 * VERTEX_WORDS)
            .map(|quad| {
                let ([x, y], [to_x, to_y]) = (place(quad), place(&quad[5 * VERTEX_WORDS..]));
                [x, y, to_x, to_y]
            })
            .collect()
    }

    #[test]
    fn pairs_are_kerned() {
        let text = text();
        let together = text.width(STYLE, "AV");
        let apart = text.width(STYLE, "A") + text.width(STYLE, "V");
        assert!(
            (apart - together - 0.047 * STYLE.px).abs() < 0.01,
            "{together} {apart}"
        );
    }

    /// At every size a line is as long as the page says, and three times the size is three times as long.
    #[test]
    fn text_at_once_and_at_three_times_the_size() {
        let mut text = text();
        let line = "Window size 1280 × 720";
        let mut widths = Vec::new();
        for px in [20.0, 60.0] {
            let style = Style { px, ..STYLE };
            text.begin((1280, 720));
            let end = text.write(style, 100.0, 300.0, line);
            assert!((end - 100.0 - text.width(style, line)).abs() < 0.01);
            let quads = quads(&text);
            assert_eq!(quads.len(), line.chars().filter(|c| *c != ' ').count());
            let (left, right) = (quads[0][0], quads.last().unwrap()[2]);
            assert!((left - 100.0).abs() < px * 0.1 && (right - end).abs() < px * 0.12);
            // Whole pixels: each letter is shown as it was rasterised.
            assert!(quads.iter().flatten().all(|c| (c - c.round()).abs() < 0.01));
            let tops = quads.iter().map(|q| q[1]).fold(f32::MAX, f32::min);
            assert!((300.0 - tops - text.cap_height(style)).abs() < px * 0.1);
            widths.push(end - 100.0);
        }
        assert!((widths[1] / widths[0] - 3.0).abs() < 0.01, "{widths:?}");
    }

    #[test]
    fn what_no_font_has_is_a_box() {
        let mut text = text();
        text.write(STYLE, 0.0, 100.0, "\u{1F3AE}");
        assert_eq!(text.quads(), 1);
        assert!((text.width(STYLE, "\u{1F3AE}") - BOX_WIDTH * STYLE.px).abs() < 0.01);
    }

    #[test]
    fn lines_break_between_words() {
        let text = text();
        let sentence = "A lantern burns in the drowned quarry all night";
        let lines = text.broken(STYLE, sentence, 150.0);
        assert_eq!(lines.join(" "), sentence);
        assert!(lines.len() > 2 && lines.iter().all(|line| text.width(STYLE, line) <= 150.0));
        assert_eq!(text.broken(STYLE, "Unbreakable", 10.0), ["Unbreakable"]);
    }

    #[test]
    fn a_shadow_is_drawn_first() {
        let mut text = text();
        text.write(
            Style {
                shadow: 1.0,
                ..STYLE
            },
            10.0,
            100.0,
            "ab",
        );
        let quads = quads(&text);
        assert_eq!(quads.len(), 4);
        assert!(quads[0][2] - quads[0][0] > quads[2][2] - quads[2][0]);
    }
}
