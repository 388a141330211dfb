//! How the menus look: a calm column of letters over the scene, one warm light on what is focused.

mod parts;

use super::items::{Item, Screen};
use super::layout::{ARROW, Layout, Row};
use super::prompts::{self, Cap, Device};
use super::values::{self, Value};
use super::{BUTTON_COLUMN, Facts, Menu, caps};
use crate::shell::settings::bindings::Input;
use crate::shell::settings::{Deed, Settings};
use crate::shell::text::{Colour, Face, Rect, Style, Symbol, Text};
use caps::with_alpha;

/// Letters.
pub const PAPER: Colour = [0.95, 0.93, 0.89, 1.0];
/// What is focused: the lantern's light.
pub const WARM: Colour = [1.0, 0.78, 0.45, 1.0];
/// The dusk behind letters.
pub const INK: Colour = [0.05, 0.045, 0.075, 1.0];
/// What is wrong.
pub const ALARM: Colour = [1.0, 0.50, 0.42, 1.0];

/// Opacities: entries without focus, notes and hints, lines, the light on the focused row.
const QUIET: f32 = 0.80;
const NOTES: f32 = 0.78;
const RULE: f32 = 0.55;
const BAR: f32 = 0.28;
/// Seconds in which a page appears, and how far it comes from, in the design's pixels.
const APPEAR: f32 = 0.22;
const COME: f32 = 18.0;
/// How fast the light moves to the focus, per second.
const GLIDE: f32 = 22.0;
/// Seconds of the light's slow breathing, and by how much.
const BREATH: f32 = 3.2;
const BREATH_DEPTH: f32 = 0.22;

/// Everything that is drawn from.
pub struct Scene<'a> {
    /// The open page.
    pub menu: &'a Menu,
    /// What the values come from.
    pub settings: &'a Settings,
    /// What else is known.
    pub facts: &'a Facts,
    /// What the player has used last.
    pub device: Device,
    /// Seconds since the last frame.
    pub elapsed: f32,
}

/// What moves by itself between frames.
#[derive(Debug, Default)]
pub struct Look {
    bar: Option<(Screen, f32)>,
    clock: f32,
}

/// Pen and places for one page.
struct Page<'a> {
    text: &'a mut Text,
    scene: &'a Scene<'a>,
    layout: &'a Layout,
    screen: Screen,
    /// How far the page has appeared.
    shown: f32,
    breath: f32,
}

impl Look {
    /// Draws the open page over what is on the text's page; says where its parts are.
    pub fn draw(&mut self, text: &mut Text, scene: &Scene) -> Option<Layout> {
        let screen = scene.menu.screen()?;
        let mut layout = Layout::of(scene.menu, scene.facts, text.size())?;
        let given = layout.clone();
        self.clock += scene.elapsed;
        let shown = (scene.menu.age / APPEAR).min(1.0);
        let eased = 1.0 - (1.0 - shown).powi(3);
        layout.left -= COME * layout.unit * (1.0 - eased);
        let wave = (self.clock / BREATH * std::f32::consts::TAU).sin();
        let bar = self.glide(screen, &layout, scene);
        let mut page = Page {
            text,
            scene,
            layout: &layout,
            screen,
            shown: eased,
            breath: 1.0 - BREATH_DEPTH * (0.5 + 0.5 * wave),
        };
        page.veil();
        page.heading();
        page.light(bar);
        for row in &layout.rows {
            page.row(row);
        }
        match screen {
            Screen::Controls => page.columns(),
            Screen::Credits => page.credits(),
            Screen::Results => page.results(),
            _ => {}
        }
        page.bottom();
        Some(given)
    }

    /// Where the light is: on its way to the focused row.
    fn glide(&mut self, screen: Screen, layout: &Layout, scene: &Scene) -> f32 {
        let wanted = layout
            .rows
            .get(scene.menu.focus())
            .map_or(0.0, |row| row.rect[1]);
        let now = match self.bar {
            Some((before, y)) if before == screen => {
                y + (wanted - y) * (1.0 - (-GLIDE * scene.elapsed).exp())
            }
            _ => wanted,
        };
        self.bar = Some((screen, now));
        now
    }
}

impl Page<'_> {
    fn style(&self, px: f32) -> Style {
        Style {
            face: Face::Body,
            px,
            tracking: 0.015,
            colour: with_alpha(PAPER, self.shown),
            shadow: 0.6,
        }
    }

    /// Dusk from the left, over all of it where time stands still.
    fn veil(&mut self) {
        let [width, height] = self.text.size();
        let (all, side, reach) = match self.screen {
            Screen::Title => (0.10, 0.72, 0.62),
            Screen::Controls | Screen::Credits => (0.50, 0.62, 1.0),
            Screen::Video | Screen::Audio | Screen::Access => (0.42, 0.62, 0.95),
            _ => (0.38, 0.62, 0.72),
        };
        let ink = |opacity| with_alpha(INK, opacity);
        self.text.rect([0.0, 0.0, width, height], ink(all));
        let [dark, clear] = [ink(side), ink(0.0)];
        self.text.shaded(
            [0.0, 0.0, width * reach, height],
            [dark, clear, dark, clear],
        );
        let foot = height * 0.3;
        let [low, none] = [ink(0.45), ink(0.0)];
        self.text
            .shaded([0.0, height - foot, width, foot], [none, none, low, low]);
    }

    fn heading(&mut self) {
        let Layout {
            unit,
            left,
            measures,
            ..
        } = *self.layout;
        let [px, baseline] = measures.heading;
        let is_title = self.screen == Screen::Title;
        let style = Style {
            face: Face::Display,
            tracking: if is_title { 0.13 } else { 0.02 },
            shadow: 1.0,
            ..self.style(px)
        };
        let line = self.screen.heading();
        let line = if is_title {
            line.to_uppercase()
        } else {
            line.into()
        };
        let end = self.text.write(style, left - px * 0.04, baseline, &line);
        let length = if is_title { end - left } else { 300.0 * unit };
        self.rule(baseline + 26.0 * unit, length);
        let run =
            Some(self.scene.facts.paused_run.as_str()).filter(|_| self.screen == Screen::Pause);
        if let Some(preface) = self.screen.preface().or(run) {
            let style = self.style(22.0 * unit);
            self.text
                .write(style, left, baseline + 66.0 * unit, preface);
        }
    }

    /// A thin line that begins with a lozenge and fades.
    fn rule(&mut self, y: f32, length: f32) {
        let Layout { unit, left, .. } = *self.layout;
        let thick = (1.4 * unit).max(1.0).round();
        let [full, none] = [RULE * self.shown, 0.0].map(|a| with_alpha(WARM, a));
        let start = left + 16.0 * unit;
        self.text.shaded(
            [start, y.round(), length - 16.0 * unit, thick],
            [full, none, full, none],
        );
        let at = [left + 5.0 * unit, y.round() + thick / 2.0];
        self.text.symbol(
            Symbol::Lozenge,
            at,
            10.0 * unit,
            with_alpha(WARM, self.shown),
        );
    }

    /// The light on the focused row.
    fn light(&mut self, y: f32) {
        let Layout { unit, left, .. } = *self.layout;
        let Some(row) = self.layout.rows.get(self.scene.menu.focus()) else {
            return;
        };
        let [_, _, width, height] = row.rect;
        let inset = height * 0.08;
        let [full, none] = [BAR * self.shown * self.breath, 0.0].map(|a| with_alpha(WARM, a));
        // Brightest at the lozenge, fading to both sides.
        let (from, middle) = (left - ARROW * unit * 1.6, left - ARROW * unit * 0.5);
        let (top, tall) = (y + inset, height - 2.0 * inset);
        let (before, after) = (middle - from, left + width - middle);
        self.text
            .shaded([from, top, before, tall], [none, full, none, full]);
        self.text
            .shaded([middle, top, after, tall], [full, none, full, none]);
        let at = [left - 17.0 * unit, y + height / 2.0];
        let halo = [70.0 * unit; 2];
        self.text
            .glow(at, halo, with_alpha(WARM, 0.5 * self.shown * self.breath));
        self.text.symbol(
            Symbol::Lozenge,
            at,
            12.0 * unit,
            with_alpha(WARM, self.shown),
        );
    }

    fn is_focused(&self, row: &Row) -> bool {
        self.layout.rows.get(self.scene.menu.focus()) == Some(row)
    }

    fn row(&mut self, row: &Row) {
        let focused = self.is_focused(row);
        let px = self.layout.measures.text;
        let style = self.style(px);
        let colour = if focused {
            WARM
        } else {
            with_alpha(PAPER, QUIET)
        };
        let style = style.in_colour(with_alpha(colour, self.shown));
        let baseline = self.baseline(row.rect, style);
        let label = match row.item {
            Item::Level(index) => self
                .scene
                .facts
                .levels
                .get(index)
                .map_or("", String::as_str),
            item => item.label(),
        };
        self.text.write(style, self.layout.left, baseline, label);
        match values::value(row.item, self.scene.settings) {
            Value::None => {}
            Value::Choice(words) => self.choice(row, &words, style, focused),
            Value::Switch(on) => self.choice(row, if on { "On" } else { "Off" }, style, focused),
            Value::Scale(now, range) => {
                let share = (now - range.start()) as f32 / (range.end() - range.start()) as f32;
                self.scale(row, now, share, style, focused);
            }
            Value::Keys => {
                if let Item::Bind(deed) = row.item {
                    self.keys(row, deed, focused);
                }
            }
        }
    }

    /// Where capitals stand in the middle of a place.
    fn baseline(&self, [_, y, _, height]: Rect, style: Style) -> f32 {
        y + (height + self.text.cap_height(style)) / 2.0
    }

    /// Words between two arrows.
    fn choice(&mut self, row: &Row, words: &str, style: Style, focused: bool) {
        let [x, y, width, height] = row.value;
        let middle = y + height / 2.0;
        let baseline = self.baseline(row.value, style);
        self.text.centred(style, x + width / 2.0, baseline, words);
        let arrows = with_alpha(style.colour, if focused { 1.0 } else { 0.35 });
        let inset = ARROW * self.layout.unit / 2.0;
        let side = style.px * 0.8;
        self.text
            .symbol(Symbol::Left, [x + inset, middle], side, arrows);
        self.text
            .symbol(Symbol::Right, [x + width - inset, middle], side, arrows);
    }

    /// A line that is lit up to a lozenge, and the number after it.
    fn scale(&mut self, row: &Row, now: u32, share: f32, style: Style, focused: bool) {
        let unit = self.layout.unit;
        let [x, y, width, height] = self.layout.track(row);
        let middle = (y + height / 2.0).round();
        let thick = (3.0 * unit).max(2.0).round();
        let line = |from: f32, to: f32| [from, middle - thick / 2.0, to - from, thick];
        let at = x + width * share;
        let lit = if focused { 1.0 } else { 0.6 };
        self.text
            .rect(line(x, x + width), with_alpha(PAPER, 0.22 * self.shown));
        self.text
            .rect(line(x, at), with_alpha(WARM, lit * self.shown));
        let knob = if focused { 18.0 } else { 13.0 };
        let colour = with_alpha(if focused { WARM } else { PAPER }, self.shown);
        self.text
            .symbol(Symbol::Lozenge, [at, middle], knob * unit, colour);
        let baseline = self.baseline(row.value, style);
        let end = row.value[0] + row.value[2];
        self.text.ending(style, end, baseline, &format!("{now} %"));
    }

    /// The keys and the button of a deed.
    fn keys(&mut self, row: &Row, deed: Deed, focused: bool) {
        let bindings = &self.scene.settings.controls.bindings;
        let make = match self.scene.device {
            Device::Pad(make) => make,
            Device::Keys => prompts::Make::default(),
        };
        for column in 0..=BUTTON_COLUMN {
            let (input, cap) = match column {
                BUTTON_COLUMN => {
                    let button = bindings.button(deed);
                    (
                        button.map(Input::Button),
                        button.map(|b| prompts::button(b, make)),
                    )
                }
                slot => {
                    let key = bindings.keys(deed)[slot];
                    (key.map(Input::Key), key.map(prompts::key))
                }
            };
            let cell = self.layout.cell(row, column);
            let is_here = focused && self.scene.menu.column() == column;
            let wait = self
                .scene
                .menu
                .wait()
                .filter(|w| w.deed == deed && w.column == column);
            let conflict = input
                .and_then(|input| bindings.conflict(deed, input))
                .is_some();
            let colour = match () {
                () if conflict => ALARM,
                () if is_here => WARM,
                () => with_alpha(PAPER, if focused { 1.0 } else { QUIET }),
            };
            self.key_cell(
                cell,
                cap.filter(|_| wait.is_none()),
                wait.is_some(),
                is_here,
                conflict,
                colour,
            );
        }
    }

    fn key_cell(
        &mut self,
        cell: Rect,
        cap: Option<Cap>,
        waits: bool,
        is_here: bool,
        twice: bool,
        colour: Colour,
    ) {
        let px = self.layout.measures.text * 0.84;
        let colour = with_alpha(colour, self.shown);
        let style = self.style(px).in_colour(colour);
        let baseline = self.baseline(cell, style);
        let middle = cell[0] + cell[2] / 2.0;
        if is_here {
            let [x, y, width, height] = cell;
            let inset = height * 0.02;
            let frame = [x + 4.0, y + inset, width - 8.0, height - 2.0 * inset];
            self.text.pill(
                frame,
                true,
                with_alpha(WARM, 0.18 * self.shown * self.breath),
            );
            self.text
                .pill(frame, false, with_alpha(WARM, 0.8 * self.shown));
        }
        match cap {
            Some(cap) => {
                let width = caps::width(self.text, &cap, px);
                let end = caps::draw(self.text, &cap, middle - width / 2.0, baseline, px, colour);
                // For those to whom red says nothing.
                if twice {
                    let at = end + 8.0 * self.layout.unit;
                    self.text.write(style, at, baseline, "!");
                }
            }
            None if waits => self.text.centred(style, middle, baseline, "Press …"),
            None => self.text.centred(style.faded(0.5), middle, baseline, "—"),
        }
    }
}
