//! The picture that holds every glyph in use, each at its exact size in pixels, and beside it a soft copy for shadows.

use super::fonts::{Bitmap, Fonts, Glyph};
use super::symbols::Symbol;
use std::collections::HashMap;
use std::ops::Range;

/// Side of the square picture, in texels.
pub const SIDE: usize = 2048;
/// Empty texels around each entry, so that filtering meets no neighbour.
const GAP: usize = 1;
/// Side of the white block that rectangles are made of, and the middle of it as a share of the picture.
const WHITE: usize = 4;
pub const WHITE_AT: f32 = WHITE as f32 / 2.0 / SIDE as f32;
/// Radius of a shadow's softness, as a share of the glyph's size; at least so many pixels.
const SOFTNESS: f32 = 0.07;
const SOFTEST: f32 = 2.0;
/// Passes of a box filter that look like a soft brush.
const PASSES: usize = 2;

/// What an entry shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mark {
    /// A letter.
    Glyph(Glyph),
    /// A drawing.
    Symbol(Symbol),
}

/// An entry: what, how large in pixels, soft or sharp.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Key {
    /// What it shows.
    pub mark: Mark,
    /// Size in pixels.
    pub px: u16,
    /// The shadow of it.
    pub soft: bool,
}

/// Where an entry is in the picture, and where it lies from the pen: right and up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slot {
    /// Left edge in texels.
    pub x: usize,
    /// Top edge in texels.
    pub y: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// From the pen to the left edge, pixels.
    pub left: i32,
    /// From the baseline up to the top edge, pixels.
    pub top: i32,
}

/// A row of entries.
struct Shelf {
    y: usize,
    height: usize,
    end: usize,
}

/// The picture and what is in it.
pub struct Atlas {
    pixels: Vec<u8>,
    slots: HashMap<Key, Slot>,
    shelves: Vec<Shelf>,
    changed: Range<usize>,
    is_full: bool,
}

impl Default for Atlas {
    fn default() -> Self {
        let mut atlas = Atlas {
            pixels: vec![0; SIDE * SIDE],
            slots: HashMap::new(),
            shelves: Vec::new(),
            changed: 0..0,
            is_full: false,
        };
        atlas.clear();
        atlas
    }
}

impl Atlas {
    /// Where an entry is; it is drawn when it is first asked for. `None` if there is nothing to see, or no room left.
    pub fn slot(&mut self, fonts: &Fonts, key: Key) -> Option<Slot> {
        if let Some(slot) = self.slots.get(&key) {
            return Some(*slot).filter(|slot| slot.width > 0);
        }
        let bitmap = draw(fonts, key);
        let slot = self.place(&bitmap)?;
        self.slots.insert(key, slot);
        Some(slot).filter(|slot| slot.width > 0)
    }

    /// Begins a page: a picture that is full is begun anew, for sizes may have changed.
    pub fn begin(&mut self) {
        if self.is_full {
            self.clear();
        }
    }

    /// The rows that have changed since the last call, and their texels.
    pub fn take_changes(&mut self) -> Option<(Range<usize>, &[u8])> {
        let rows = std::mem::replace(&mut self.changed, 0..0);
        let texels = &self.pixels[rows.start * SIDE..rows.end * SIDE];
        (!rows.is_empty()).then_some((rows, texels))
    }

    /// How many entries there are.
    #[cfg(test)]
    fn count(&self) -> usize {
        self.slots.len()
    }

    fn clear(&mut self) {
        self.pixels.fill(0);
        self.slots.clear();
        self.shelves.clear();
        self.is_full = false;
        self.changed = 0..SIDE;
        let white = Bitmap {
            width: WHITE,
            height: WHITE,
            left: 0,
            top: 0,
            pixels: vec![255; WHITE * WHITE],
        };
        self.place(&white); // the first entry lies in the corner
    }

    fn place(&mut self, bitmap: &Bitmap) -> Option<Slot> {
        let (width, height) = (bitmap.width, bitmap.height);
        let Some((x, y)) = self.room(width + GAP, height + GAP) else {
            self.is_full = true;
            return None;
        };
        for (row, texels) in bitmap.pixels.chunks_exact(width.max(1)).enumerate() {
            let start = (y + row) * SIDE + x;
            self.pixels[start..start + width].copy_from_slice(texels);
        }
        let rows = if self.changed.is_empty() {
            y..y + height
        } else {
            self.changed.start.min(y)..self.changed.end.max(y + height)
        };
        self.changed = rows;
        Some(Slot {
            x,
            y,
            width,
            height,
            left: bitmap.left,
            top: bitmap.top,
        })
    }

    /// A free place: on the lowest shelf that fits well, else on a new one.
    fn room(&mut self, width: usize, height: usize) -> Option<(usize, usize)> {
        let fits = |shelf: &&mut Shelf| {
            shelf.end + width <= SIDE && height <= shelf.height && shelf.height <= height * 3 / 2
        };
        if let Some(shelf) = self.shelves.iter_mut().find(fits) {
            shelf.end += width;
            return Some((shelf.end - width, shelf.y));
        }
        let y = self.shelves.last().map_or(0, |s| s.y + s.height);
        if y + height > SIDE || width > SIDE {
            return None;
        }
        let end = width;
        self.shelves.push(Shelf { y, height, end });
        Some((0, y))
    }
}

/// The pixels of an entry.
fn draw(fonts: &Fonts, key: Key) -> Bitmap {
    let side = usize::from(key.px);
    let nothing = Bitmap {
        width: 0,
        height: 0,
        left: 0,
        top: 0,
        pixels: Vec::new(),
    };
    let sharp = match key.mark {
        Mark::Glyph(glyph) => fonts.rasterise(glyph, f32::from(key.px)).unwrap_or(nothing),
        Mark::Symbol(symbol) => Bitmap {
            width: side,
            height: side,
            left: 0,
            top: side as i32,
            pixels: symbol.rasterise(side),
        },
    };
    if key.soft && sharp.width > 0 {
        soften(&sharp, (f32::from(key.px) * SOFTNESS).max(SOFTEST) as usize)
    } else {
        sharp
    }
}

/// A soft copy with room around it.
fn soften(sharp: &Bitmap, radius: usize) -> Bitmap {
    let margin = radius * PASSES;
    let (width, height) = (sharp.width + 2 * margin, sharp.height + 2 * margin);
    let mut pixels = vec![0; width * height];
    for (row, texels) in sharp.pixels.chunks_exact(sharp.width).enumerate() {
        let start = (row + margin) * width + margin;
        pixels[start..start + sharp.width].copy_from_slice(texels);
    }
    for _ in 0..PASSES {
        pixels = box_filter(&pixels, width, height, radius);
    }
    Bitmap {
        width,
        height,
        left: sharp.left - margin as i32,
        top: sharp.top + margin as i32,
        pixels,
    }
}

/// The mean over the neighbours along the row, then turned over: twice that is the mean along both axes.
fn box_filter(pixels: &[u8], width: usize, height: usize, radius: usize) -> Vec<u8> {
    let turned = mean_along_rows(pixels, width, height, radius);
    mean_along_rows(&turned, height, width, radius)
}

/// Means along the rows, written as columns.
fn mean_along_rows(pixels: &[u8], width: usize, height: usize, radius: usize) -> Vec<u8> {
    let mut out = vec![0; pixels.len()];
    let count = (2 * radius + 1) as u32;
    for (y, row) in pixels.chunks_exact(width).enumerate() {
        let at = |i: usize| row.get(i).copied().map_or(0, u32::from);
        let mut sum: u32 = (0..radius).map(at).sum();
        for x in 0..width {
            sum += at(x + radius);
            out[x * height + y] = (sum / count) as u8;
            sum -= if x >= radius { at(x - radius) } else { 0 };
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::fonts::Face;
    use super::*;

    fn key(fonts: &Fonts, c: char, px: u16, soft: bool) -> Key {
        Key {
            mark: Mark::Glyph(fonts.glyph(Face::Body, c)),
            px,
            soft,
        }
    }

    #[test]
    fn entries_do_not_overlap_and_are_drawn_once() {
        let (fonts, mut atlas) = (Fonts::load().unwrap(), Atlas::default());
        let mut slots = Vec::new();
        for px in [13, 17, 60] {
            for c in ('!'..'~').filter(|c| !c.is_whitespace()) {
                slots.extend(atlas.slot(&fonts, key(&fonts, c, px, false)));
                slots.extend(atlas.slot(&fonts, key(&fonts, c, px, true)));
            }
        }
        let count = atlas.count();
        for (i, a) in slots.iter().enumerate() {
            for b in &slots[..i] {
                let apart = a.x + a.width <= b.x
                    || b.x + b.width <= a.x
                    || a.y + a.height <= b.y
                    || b.y + b.height <= a.y;
                assert!(apart, "{a:?} {b:?}");
            }
        }
        assert!(atlas.take_changes().is_some() && atlas.take_changes().is_none());
        atlas.slot(&fonts, key(&fonts, 'a', 17, false));
        assert_eq!((atlas.count(), atlas.take_changes()), (count, None));
    }

    #[test]
    fn a_full_picture_is_begun_anew() {
        let (fonts, mut atlas) = (Fonts::load().unwrap(), Atlas::default());
        let all: Vec<Option<Slot>> = (200..260)
            .flat_map(|px| ['W', 'M', '@'].map(|c| (c, px)))
            .map(|(c, px)| atlas.slot(&fonts, key(&fonts, c, px, true)))
            .collect();
        assert!(all.last().unwrap().is_none(), "more than there is room for");
        atlas.begin();
        assert_eq!(atlas.count(), 0);
        assert!(atlas.slot(&fonts, key(&fonts, 'W', 200, true)).is_some());
    }

    #[test]
    fn a_shadow_is_softer_and_as_heavy() {
        let fonts = Fonts::load().unwrap();
        let sum = |b: &Bitmap| b.pixels.iter().map(|&p| u32::from(p)).sum::<u32>() as f32;
        let [sharp, soft] = [false, true].map(|soft| draw(&fonts, key(&fonts, 'R', 60, soft)));
        assert!(soft.width > sharp.width && soft.pixels.iter().max() < sharp.pixels.iter().max());
        assert!((sum(&soft) / sum(&sharp) - 1.0).abs() < 0.1);
    }
}
