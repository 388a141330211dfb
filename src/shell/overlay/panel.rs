//! The docked window: one column of sections, the most used first.

use super::scene::Show;
use super::style::{ALARM, FAINT, size};
use super::{Info, stats, tunables};
use crate::game::Stance;
use crate::shell::edits::{Edit, Group, SCALES};
use imgui::{Condition, SliderFlags, TreeNodeFlags, Ui};
use std::path::Path;

/// Width in text heights, and at most this share of the picture.
const WIDTH: f32 = 27.0;
const SHARE: f32 = 0.45;

/// What the panel remembers between frames.
#[derive(Debug, Default)]
pub struct Panel {
    filter: String,
}

/// How much of a picture's width the panel covers, given the height of the text.
pub fn width(text: f32, picture: f32) -> f32 {
    (text * WIDTH).min(picture * SHARE)
}

/// Size of the panel.
pub fn docked(ui: &Ui) -> [f32; 2] {
    let [picture, height] = ui.io().display_size;
    [width(ui.current_font_size(), picture), height]
}

/// Draws the panel; adds what was asked for to `edits`.
pub fn draw(ui: &Ui, panel: &mut Panel, info: &Info, show: &mut Show, edits: &mut Vec<Edit>) {
    let mut open = true;
    ui.window("Edgewalker")
        .position([0.0; 2], Condition::Always)
        .size(docked(ui), Condition::Always)
        .movable(false)
        .resizable(false)
        .collapsible(false)
        .focus_on_appearing(false)
        .opened(&mut open)
        .build(|| {
            time(ui, info, edits);
            sections(ui, panel, info, show, edits);
        });
    if !open {
        edits.push(Edit::Overlay(false));
    }
}

fn sections(ui: &Ui, panel: &mut Panel, info: &Info, show: &mut Show, edits: &mut Vec<Edit>) {
    let begins_open = |label: &str| ui.collapsing_header(label, TreeNodeFlags::DEFAULT_OPEN);
    let begins_closed = |label: &str| ui.collapsing_header(label, TreeNodeFlags::empty());
    if !info.notices.problems().is_empty() && begins_open("Problems") {
        problems(ui, info);
    }
    if begins_open("Hero") {
        hero(ui, info);
    }
    if begins_open("Drawings") {
        drawings(ui, show);
    }
    if begins_open("Tunables") {
        tunables::file_bar(ui, info.tuning, info.tuning_path, edits);
        ui.set_next_item_width(-1.0);
        ui.input_text("##filter", &mut panel.filter)
            .hint("filter by name or sentence")
            .build();
        for titled in [("Motion", Group::Motion), ("Camera", Group::Camera)] {
            tunables::rows(ui, titled, info.tuning, &panel.filter, edits);
        }
    }
    if begins_closed("Graphs") {
        stats::section(ui, info.stats);
    }
    if begins_closed("Mesh") {
        mesh(ui, info);
    }
    if begins_closed("Levels") {
        levels(ui, info, edits);
    }
}

/// Pause, step, speed, restart, quit.
fn time(ui: &Ui, info: &Info, edits: &mut Vec<Edit>) {
    let button = |label: &str, tip: &str| {
        let pressed = ui.button(label);
        if ui.is_item_hovered() {
            ui.tooltip_text(tip);
        }
        ui.same_line();
        pressed
    };
    if button(
        if info.paused {
            "Go on##pause"
        } else {
            "Pause##pause"
        },
        "P",
    ) {
        edits.push(Edit::Pause(!info.paused));
    }
    if button("Step", "One tick: full stop") {
        edits.push(Edit::Step);
    }
    if button("Restart", "R") {
        edits.push(Edit::Restart);
    }
    if button("Fullscreen", "F11") {
        edits.push(Edit::Fullscreen);
    }
    if button("Quit", "Esc, then Q") {
        edits.push(Edit::Quit);
    }
    ui.new_line();
    let mut scale = info.scale;
    ui.set_next_item_width(size(ui, 12.0));
    let slider = ui.slider_config("##scale", *SCALES.start(), *SCALES.end());
    let flags = SliderFlags::LOGARITHMIC | SliderFlags::ALWAYS_CLAMP;
    if slider
        .display_format("speed × %.2f")
        .flags(flags)
        .build(&mut scale)
    {
        edits.push(Edit::Scale(scale));
    }
    ui.same_line();
    if ui.button("× 1") {
        edits.push(Edit::Scale(1.0));
    }
    ui.spacing();
}

fn problems(ui: &Ui, info: &Info) {
    let _wrap = ui.push_text_wrap_pos();
    for (topic, reason) in info.notices.problems() {
        ui.text_colored(ALARM, topic.name());
        ui.text(reason);
    }
}

/// A line of the read-outs.
fn value(ui: &Ui, name: &str, text: impl AsRef<str>) {
    ui.text_colored(FAINT, name);
    ui.same_line_with_pos(size(ui, 6.0));
    ui.text(text);
}

fn hero(ui: &Ui, info: &Info) {
    let view = info.play.world.view();
    let stance = match view.stance {
        Stance::Air => "in the air",
        Stance::Ground => "on the ground",
        Stance::Slide => "sliding",
        Stance::Wedge => "wedged",
    };
    value(
        ui,
        "Stance",
        format!("{stance}{}", if view.crouched { ", crouched" } else { "" }),
    );
    value(
        ui,
        "Position",
        format!("{:9.4}  {:9.4} m", view.position.x, view.position.y),
    );
    let speed = view.velocity.length();
    value(
        ui,
        "Velocity",
        format!(
            "{:7.3}  {:7.3}  |{speed:.3}| m/s",
            view.velocity.x, view.velocity.y
        ),
    );
    value(
        ui,
        "Tick",
        format!(
            "{} at {} Hz, {:.3} s",
            info.play.world.tick(),
            info.play.world.tick_rate(),
            view.time
        ),
    );
    value(ui, "Hash", format!("{:016x}", info.play.world.hash()));
    value(ui, "Input", info.source);
}

fn drawings(ui: &Ui, show: &mut Show) {
    let second = size(ui, 12.0);
    ui.checkbox("Motion mesh", &mut show.mesh);
    ui.same_line_with_pos(second);
    ui.checkbox("Velocity", &mut show.velocity);
    ui.checkbox("Face and edge", &mut show.place);
    ui.same_line_with_pos(second);
    ui.checkbox("Path, last second", &mut show.path);
    ui.checkbox("Contact normal", &mut show.contact);
    ui.same_line_with_pos(second);
    ui.checkbox("Hide the world", &mut show.hide_world);
}

fn mesh(ui: &Ui, info: &Info) {
    let size = info.mesh_size;
    value(ui, "Vertices", size.vertices.to_string());
    value(ui, "Edges", size.edges.to_string());
    value(ui, "Faces", format!("{}, {} solid", size.faces, size.solid));
    value(ui, "Features", size.features.to_string());
}

fn levels(ui: &Ui, info: &Info, edits: &mut Vec<Edit>) {
    for path in info.levels {
        let is_current = path == info.level_path;
        if ui
            .selectable_config(label(path))
            .selected(is_current)
            .build()
        {
            edits.push(Edit::OpenLevel(path.clone()));
        }
    }
}

/// The last two parts of a path: enough to tell levels apart.
fn label(path: &Path) -> String {
    let parts: Vec<_> = path
        .components()
        .rev()
        .take(2)
        .map(|c| c.as_os_str().to_string_lossy())
        .collect();
    parts.into_iter().rev().collect::<Vec<_>>().join("/")
}
