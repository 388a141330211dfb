//! The docked window: one column of sections; the long one, the tunables, comes last, that none be out of sight.

use super::scene::Show;
use super::style::{ACCENT, ALARM, FAINT, size};
use super::{Info, MeshSize, stats, tunables};
use crate::game::World;
use crate::motion::grip::Grip;
use crate::motion::{Event, EventKind, Mode};
use crate::shell::edits::{Edit, Group, SCALES};
use glam::DVec2;
use imgui::{Condition, SliderFlags, TreeNodeFlags, Ui};
use std::path::Path;

/// Width in text heights, and at most this share of the picture.
const WIDTH: f32 = 27.0;
const SHARE: f32 = 0.45;
/// Rows of events.
const ROWS: usize = 4;

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

/// The sections; those that are not needed all the time begin closed.
fn sections(ui: &Ui, panel: &mut Panel, info: &Info, show: &mut Show, edits: &mut Vec<Edit>) {
    let begins_open = |label: &str| ui.collapsing_header(label, TreeNodeFlags::DEFAULT_OPEN);
    let begins_closed = |label: &str| ui.collapsing_header(label, TreeNodeFlags::empty());
    if !info.notices.problems().is_empty() && begins_open("Problems") {
        problems(ui, info);
    }
    if begins_open("Hero") {
        hero(ui, info);
    }
    if begins_open("Events") {
        events(ui, info);
    }
    if begins_open("Drawings") {
        drawings(ui, show);
    }
    if begins_closed("Levels") {
        levels(ui, info, edits);
    }
    if begins_closed("Graphs") {
        stats::section(ui, info.stats);
    }
    if begins_closed("Mesh") {
        mesh(ui, info);
    }
    if begins_open("Tunables") {
        tunables::file_bar(ui, info.tuning, info.tuning_path, edits);
        ui.set_next_item_width(-1.0); // as wide as the panel
        let filter = ui.input_text("##filter", &mut panel.filter);
        filter.hint("filter by name or sentence").build();
        for titled in [("Motion", Group::Motion), ("Camera", Group::Camera)] {
            tunables::rows(ui, titled, info.tuning, &panel.filter, edits);
        }
    }
}

/// What is done with the run as a whole, each with its key as a tip.
fn time(ui: &Ui, info: &Info, edits: &mut Vec<Edit>) {
    let pause = if info.paused { "Go on" } else { "Pause" };
    for (label, key, edit) in [
        (pause, "P", Edit::Pause(!info.paused)),
        ("Step", "One tick: full stop", Edit::Step),
        ("Restart", "R", Edit::Restart),
        ("Fullscreen", "F11", Edit::Fullscreen),
        ("Quit", "Esc, then Q", Edit::Quit),
    ] {
        // What is behind the triple hash names the button, so that it stays the same one when its label changes.
        let id = if label == pause { "###pause" } else { "" };
        if ui.button(format!("{label}{id}")) {
            edits.push(edit);
        }
        if ui.is_item_hovered() {
            ui.tooltip_text(key);
        }
        ui.same_line();
    }
    ui.new_line();
    speed(ui, info.scale, edits);
}

/// How fast time runs: evenly slower to the left and faster to the right.
fn speed(ui: &Ui, mut scale: f64, edits: &mut Vec<Edit>) {
    ui.set_next_item_width(size(ui, 12.0));
    let flags = SliderFlags::LOGARITHMIC | SliderFlags::ALWAYS_CLAMP;
    let slider = ui.slider_config("##scale", *SCALES.start(), *SCALES.end());
    let slider = slider.display_format("speed × %.2f").flags(flags);
    if slider.build(&mut scale) {
        edits.push(Edit::Scale(scale));
    }
    ui.same_line();
    if ui.button("× 1") {
        edits.push(Edit::Scale(1.0));
    }
    ui.spacing();
}

/// What is broken, in full.
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

/// The state at the last tick, not at the moment that is drawn: that is what the hash and the replays are about.
fn hero(ui: &Ui, info: &Info) {
    let world = &info.play.world;
    let view = world.view();
    let (DVec2 { x, y }, velocity) = (view.position, view.velocity);
    let speed = velocity.length();
    let (tick, rate, time) = (world.tick(), world.tick_rate(), view.time);
    for (name, text) in [
        ("Mode", mode(world)),
        ("On", footing(world)),
        ("Position", format!("{x:9.4}  {y:9.4} m")),
        (
            "Velocity",
            format!("{:7.3}  {:7.3}  |{speed:.3}| m/s", velocity.x, velocity.y),
        ),
        ("Tick", format!("{tick} at {rate} Hz, {time:.3} s")),
        ("Hash", format!("{:016x}", world.hash())),
        ("Input", info.source.to_owned()),
    ] {
        value(ui, name, text);
    }
}

/// What the hero is doing, as the motion knows it.
fn mode(world: &World) -> String {
    let hero = world.hero();
    let mode = match hero.mode() {
        _ if hero.climbing() => "on a ladder",
        Mode::Air(_) => "in the air",
        Mode::Surface(_) if hero.supported() => "on the ground",
        Mode::Surface(_) if hero.grip() != Grip::None => "holding on",
        Mode::Surface(_) => "on a wall or a steep slope",
        Mode::Wedge(_) => "wedged",
        Mode::Crushed(_) => "crushed",
    };
    let size = if world.view().crouched {
        ", crouched"
    } else {
        ""
    };
    format!("{mode}{size}")
}

/// What the hero is on: the feature, what it is made of, and what carries it.
fn footing(world: &World) -> String {
    let Some(feature) = world.underfoot() else {
        return "nothing".into();
    };
    let carrier = world.hero().carrier();
    let mover = carrier.and_then(|i| world.stage().level.movers.get(i as usize));
    let carried = mover.map_or(String::new(), |mover| format!(", carried by {}", mover.id));
    format!("{}, {:?}{carried}", feature.id, feature.material)
}

/// What happened in the last ticks in which something did, the latest tick first; always so many rows, so that
/// nothing below them moves.
fn events(ui: &Ui, info: &Info) {
    let world = &info.play.world;
    let mut rows = Vec::new();
    for (tick, events) in info.play.happened() {
        let colour = if *tick == world.tick() { ACCENT } else { FAINT };
        rows.extend(events.iter().map(|event| (*tick, colour, event)));
    }
    let hidden = rows.len().saturating_sub(ROWS);
    for row in 0..ROWS {
        let Some((tick, colour, Event { time, kind })) = rows.get(row) else {
            ui.text("");
            continue;
        };
        let more = match row + 1 == ROWS && hidden > 0 {
            true => format!("  and {hidden} before"),
            false => String::new(),
        };
        ui.text_colored(*colour, format!("{tick}"));
        ui.same_line_with_pos(size(ui, 4.0));
        ui.text(format!("{time:.6} s"));
        ui.same_line_with_pos(size(ui, 10.0));
        ui.text(format!("{}{more}", named(world, kind)));
    }
}

/// An event in words; regions and movers by their ids.
fn named(world: &World, kind: &EventKind) -> String {
    let stage = world.stage();
    let region = |id: &u32| match stage.feature(*id) {
        Some(feature) => feature.id.as_str(),
        None if *id == stage.pit() => "the pit",
        None if stage.is_outside(*id) => "the sky",
        None => "?",
    };
    let mover = |i: &u32| stage.level.movers.get(*i as usize).map_or("?", |m| &m.id);
    match kind {
        EventKind::Entered(id) => format!("Entered {}", region(id)),
        EventKind::Exited(id) => format!("Exited {}", region(id)),
        EventKind::Boarded(Some(i)) => format!("Boarded {}", mover(i)),
        EventKind::Boarded(None) => "Back on the level".into(),
        EventKind::Pushed(i) => format!("Pushed by {}", mover(i)),
        EventKind::Node(i) => format!("Turn of {}", mover(i)),
        kind => format!("{kind:?}"),
    }
}

/// Switches for what is drawn over the scene, in two columns.
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

/// How much there is of the mesh that the hero moves in: it has another one when he crouches.
fn mesh(ui: &Ui, info: &Info) {
    let MeshSize {
        vertices,
        edges,
        faces,
        solid,
        features,
    } = info.mesh_size;
    value(ui, "Vertices", vertices.to_string());
    value(ui, "Edges", edges.to_string());
    value(ui, "Faces", format!("{faces}, {solid} solid"));
    value(ui, "Features", features.to_string());
}

/// The levels; a click plays one from its start.
fn levels(ui: &Ui, info: &Info, edits: &mut Vec<Edit>) {
    for path in info.levels {
        let entry = ui.selectable_config(label(path));
        if entry.selected(path == info.level_path).build() {
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
