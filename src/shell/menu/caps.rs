//! Keys and buttons as drawings among text.

use super::prompts::Cap;
use super::view::{INK, PAPER};
use crate::shell::text::{Colour, Face, Style, Symbol, Text};

/// Sizes as shares of the text's size: height of a cap, its name, room on both sides of a name, drawings within.
const HEIGHT: f32 = 1.5;
const NAME: f32 = 0.82;
const ROOM: f32 = 0.5;
const DRAWING: f32 = 0.78;

/// A colour with another opacity.
pub fn with_alpha([r, g, b, a]: Colour, opacity: f32) -> Colour {
    [r, g, b, a * opacity]
}

fn name_style(px: f32, colour: Colour) -> Style {
    Style {
        face: Face::Body,
        px: px * NAME,
        tracking: 0.02,
        colour,
        shadow: 0.0,
    }
}

/// How wide a cap is beside text of a size.
pub fn width(text: &Text, cap: &Cap, px: f32) -> f32 {
    let side = (px * HEIGHT).round();
    let named = |name: &str| {
        let inner = text.width(name_style(px, PAPER), name);
        (inner + px * ROOM * 2.0).max(side).round()
    };
    match cap {
        Cap::Key(name) => named(name),
        Cap::Plate(name) => named(name),
        Cap::Arrow(_) | Cap::Letter(_) | Cap::Shape(_) => side,
    }
}

/// Draws a cap from `x` on, its middle on the middle of capitals that stand on `baseline`; where it ends.
pub fn draw(text: &mut Text, cap: &Cap, x: f32, baseline: f32, px: f32, colour: Colour) -> f32 {
    let side = (px * HEIGHT).round();
    let width = width(text, cap, px);
    let style = name_style(px, colour);
    let cap_height = text.cap_height(Style { px, ..style });
    let middle = [x + width / 2.0, baseline - cap_height / 2.0];
    let inner = middle[1] + text.cap_height(style) / 2.0;
    let rect = [x, middle[1] - side / 2.0, width, side];
    let ground = with_alpha(INK, colour[3] * 0.7);
    let rim = with_alpha(colour, 0.75);
    match cap {
        Cap::Key(name) => {
            text.pill(rect, true, ground);
            text.pill(rect, false, rim);
            text.centred(style, middle[0], inner, name);
        }
        Cap::Plate(name) => {
            text.pill(rect, true, ground);
            text.pill(rect, false, rim);
            text.centred(style, middle[0], inner, name);
        }
        Cap::Arrow(symbol) => {
            text.pill(rect, true, ground);
            text.pill(rect, false, rim);
            text.symbol(*symbol, middle, side * DRAWING * 0.7, colour);
        }
        Cap::Letter(name) => {
            text.symbol(Symbol::Disc, middle, side, ground);
            text.symbol(Symbol::Ring, middle, side, rim);
            text.centred(style, middle[0], inner, name);
        }
        Cap::Shape(symbol) => {
            text.symbol(Symbol::Disc, middle, side, ground);
            text.symbol(Symbol::Ring, middle, side, rim);
            let share = if *symbol == Symbol::Ring {
                0.55
            } else {
                DRAWING
            };
            text.symbol(*symbol, middle, side * share, colour);
        }
    }
    x + width
}
