//! One row per tunable, made from its declaration: name, slider or choice, unit, sentence, reset.

use super::style::{ACCENT, FAINT, size};
use crate::shell::edits::{Edit, Group};
use crate::tune::{Meta, Tuning};
use imgui::{SliderFlags, Ui};
use std::path::Path;

/// Ranges so wide that small values need more of the slider.
const WIDE: f64 = 100.0;

/// The buttons over the rows, how much was changed, and the file that they save to and load from.
pub fn file_bar(ui: &Ui, tuning: &Tuning, path: &Path, edits: &mut Vec<Edit>) {
    let save = "Write the changed values to the file.";
    let load = "Read the values from the file.";
    for (label, edit, tip) in [
        ("Save", Edit::SaveTuning, save),
        ("Load", Edit::LoadTuning, load),
        ("Reset all", Edit::ResetTuning, "Back to the defaults."),
    ] {
        if ui.button(label) {
            edits.push(edit);
        }
        if ui.is_item_hovered() {
            ui.tooltip_text(tip);
        }
        ui.same_line();
    }
    let changed = changes(tuning, Group::Motion) + changes(tuning, Group::Camera);
    let colour = if changed > 0 { ACCENT } else { FAINT };
    ui.text_colored(colour, format!("{changed} changed"));
    ui.text_colored(FAINT, path.display().to_string());
}

/// How many values of a group differ from their defaults.
fn changes(tuning: &Tuning, group: Group) -> usize {
    let values = group.values(tuning);
    let differs = |(meta, value): &(&Meta, f64)| meta.default != *value;
    group.meta().iter().zip(values).filter(differs).count()
}

/// The rows of a group, those whose name or sentence contains the filter, below the group's title.
pub fn rows(
    ui: &Ui,
    (title, group): (&str, Group),
    tuning: &Tuning,
    filter: &str,
    edits: &mut Vec<Edit>,
) {
    let _id = ui.push_id(title);
    let filter = filter.trim().to_lowercase();
    let matches = |meta: &Meta| {
        label(meta).contains(&filter) || meta.sentence.to_lowercase().contains(&filter)
    };
    if group.meta().iter().any(matches) {
        ui.text_colored(FAINT, title);
    }
    for (index, (meta, value)) in group.meta().iter().zip(group.values(tuning)).enumerate() {
        if !matches(meta) {
            continue;
        }
        let _id = ui.push_id_usize(index);
        if let Some(value) = row(ui, meta, value) {
            edits.push(Edit::Tune {
                group,
                index,
                value,
            });
        }
    }
}

/// One row: the name, the control, and a button that takes a change back. The new value, if it was changed.
fn row(ui: &Ui, meta: &Meta, value: f64) -> Option<f64> {
    let is_changed = value != meta.default;
    ui.align_text_to_frame_padding();
    let name = label(meta);
    if is_changed {
        ui.text_colored(ACCENT, name);
    } else {
        ui.text(name);
    }
    explain(ui, meta);
    // The control takes what the name leaves, with room for the button whether or not there is one: rows shall not move.
    let reset = size(ui, 1.6);
    ui.same_line_with_pos(size(ui, 9.6));
    ui.set_next_item_width(ui.content_region_avail()[0] - reset - size(ui, 0.4));
    let edited = if meta.choices.is_empty() {
        slider(ui, meta, value)
    } else {
        choice(ui, meta, value)
    };
    explain(ui, meta);
    if !is_changed {
        return edited;
    }
    ui.same_line();
    let was_reset = ui.button_with_size("×", [reset, 0.0]);
    if ui.is_item_hovered() {
        ui.tooltip_text(format!("Back to {}", meta.default));
    }
    if was_reset {
        Some(meta.default)
    } else {
        edited
    }
}

/// What a tunable does, where the mouse is; not while it is being dragged, when the number is what matters.
fn explain(ui: &Ui, meta: &Meta) {
    if !ui.is_item_hovered() || ui.is_item_active() {
        return;
    }
    let Meta {
        min, max, default, ..
    } = meta;
    ui.tooltip(|| {
        let _wrap = ui.push_text_wrap_pos_with_pos(size(ui, 24.0));
        ui.text(meta.sentence);
        if meta.choices.is_empty() {
            let range = format!("{min} to {max} {}, usually {default}", unit(meta));
            ui.text_colored(FAINT, range);
            ui.text_colored(FAINT, "Ctrl-click to type a number.");
        } else {
            let usual = meta.choices[*default as usize];
            ui.text_colored(FAINT, format!("usually {usual}"));
        }
    });
}

/// Digits after the point: the wider the range, the fewer a hand can set.
fn digits(range: f64) -> usize {
    match range {
        ..=2.0 => 3,
        ..=40.0 => 2,
        _ => 1,
    }
}

/// A number. What is typed is held to the range as well as what is dragged.
fn slider(ui: &Ui, meta: &Meta, value: f64) -> Option<f64> {
    let range = meta.max - meta.min;
    let mut flags = SliderFlags::ALWAYS_CLAMP;
    if range >= WIDE && meta.min >= 0.0 {
        flags |= SliderFlags::LOGARITHMIC;
    }
    let mut edited = value;
    let slider = ui.slider_config("##value", meta.min, meta.max);
    let format = format!("%.{}f {}", digits(range), unit(meta));
    let has_changed = slider
        .display_format(format)
        .flags(flags)
        .build(&mut edited);
    has_changed.then_some(edited)
}

/// One of a few names; the value is its place among them.
fn choice(ui: &Ui, meta: &Meta, value: f64) -> Option<f64> {
    let mut index = (value.round() as usize).min(meta.choices.len() - 1);
    let has_changed = ui.combo_simple_string("##value", &mut index, meta.choices);
    has_changed.then_some(index as f64)
}

/// The name as it is printed.
fn label(meta: &Meta) -> String {
    meta.name.replace('_', " ")
}

/// The unit as it is printed.
fn unit(meta: &Meta) -> String {
    meta.unit.replace("^2", "²").replace("degrees", "°")
}
