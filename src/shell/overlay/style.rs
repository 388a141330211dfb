//! How panels look: dusk-blue slate, one warm accent, sizes in proportion to the text.

use imgui::{Style, StyleColor, Ui};

/// What was changed, what is active: the colour of the lantern.
pub const ACCENT: [f32; 4] = [0.98, 0.72, 0.36, 1.0];
/// Text that may be overlooked.
pub const FAINT: [f32; 4] = [0.60, 0.65, 0.72, 1.0];
/// What is wrong.
pub const ALARM: [f32; 4] = [1.0, 0.48, 0.40, 1.0];

// From the ground up: behind everything, fields and buttons, what the mouse is on.
const SLATE: [f32; 3] = [0.085, 0.105, 0.14];
const STONE: [f32; 3] = [0.17, 0.205, 0.26];
const LIGHT: [f32; 3] = [0.29, 0.35, 0.44];
/// The grab of a slider: dark enough for the number that is written over it.
const GRAB: [f32; 3] = [0.38, 0.47, 0.60];

/// A length of so many text heights.
pub fn size(ui: &Ui, lines: f32) -> f32 {
    ui.current_font_size() * lines
}

/// Colours and sizes on top of ImGui's own; `scale` is 1 for text of 15 points.
pub fn make(base: &Style, scale: f32) -> Style {
    let mut style = *base;
    style.use_dark_colors();
    (
        style.window_rounding,
        style.frame_rounding,
        style.grab_rounding,
    ) = (0.0, 3.0, 3.0);
    (style.popup_rounding, style.scrollbar_rounding) = (4.0, 4.0);
    (style.window_border_size, style.frame_border_size) = (0.0, 0.0);
    style.window_padding = [12.0, 10.0];
    style.frame_padding = [6.0, 3.0];
    style.item_spacing = [7.0, 5.0];
    style.item_inner_spacing = [6.0, 4.0];
    style.scrollbar_size = 11.0;
    style.grab_min_size = 9.0;
    style.scale_all_sizes(scale);
    colours(&mut style);
    style
}

/// Every colour that differs from ImGui's dark ones. They are as on the screen (sRGB), with opacity.
fn colours(style: &mut Style) {
    let solid = |[r, g, b]: [f32; 3], a: f32| [r, g, b, a];
    let [r, g, b, _] = ACCENT;
    let warm = |a: f32| [r, g, b, a];
    for (what, colour) in [
        (StyleColor::Text, [0.90, 0.92, 0.95, 1.0]),
        (StyleColor::TextDisabled, FAINT),
        (StyleColor::WindowBg, solid(SLATE, 0.90)),
        (StyleColor::PopupBg, solid(SLATE, 0.97)),
        (StyleColor::TitleBg, solid(SLATE, 1.0)),
        (StyleColor::TitleBgActive, solid(STONE, 1.0)),
        (StyleColor::FrameBg, solid(STONE, 0.9)),
        (StyleColor::FrameBgHovered, solid(LIGHT, 0.8)),
        (StyleColor::FrameBgActive, solid(LIGHT, 1.0)),
        (StyleColor::SliderGrab, solid(GRAB, 1.0)),
        (StyleColor::SliderGrabActive, warm(1.0)),
        (StyleColor::CheckMark, warm(1.0)),
        (StyleColor::Button, solid(STONE, 1.0)),
        (StyleColor::ButtonHovered, solid(LIGHT, 1.0)),
        (StyleColor::ButtonActive, warm(0.55)),
        (StyleColor::Header, solid(STONE, 0.75)),
        (StyleColor::HeaderHovered, solid(LIGHT, 0.9)),
        (StyleColor::HeaderActive, solid(LIGHT, 1.0)),
        (StyleColor::Separator, solid(LIGHT, 0.5)),
        (StyleColor::ScrollbarBg, [0.0; 4]),
        (StyleColor::ScrollbarGrab, solid(LIGHT, 0.7)),
        (StyleColor::PlotLines, warm(0.95)),
        (StyleColor::TextSelectedBg, warm(0.35)),
    ] {
        style[what] = colour;
    }
}
