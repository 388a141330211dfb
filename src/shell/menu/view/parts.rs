//! What only some pages have, and the lines at the foot of all.

use super::super::items::{Item, Screen};
use super::super::layout::{HINTS, Layout, NOTE};
use super::super::prompts::{self, Cap};
use super::super::values::{self, Value};
use super::super::{BUTTON_COLUMN, caps, credits};
use super::{ALARM, NOTES, PAPER, Page, WARM};
use crate::shell::settings::bindings::Input;
use crate::shell::settings::progress::{MARKED, clock};
use crate::shell::text::{Face, Style, Symbol};
use caps::with_alpha;

/// Speed of the credits, and the step by hand, in the design's pixels.
const ROLL: f32 = 26.0;
const PUSH: f32 = 46.0;
/// Where they begin below the heading, in the design's pixels, and where they come to rest, as a share of their room.
const START: f32 = 150.0;
const REST: f32 = 0.7;

impl Page<'_> {
    /// What stands over the table's columns.
    pub(super) fn columns(&mut self) {
        let Some(first) = self.layout.rows.first() else {
            return;
        };
        let style = self.style(16.0 * self.layout.unit).faded(NOTES);
        for (column, name) in ["Key", "Other key", "Controller"].into_iter().enumerate() {
            let [x, y, width, _] = self.layout.cell(first, column);
            self.text
                .centred(style, x + width / 2.0, y - 8.0 * self.layout.unit, name);
        }
    }

    /// Lines that rise between heading and entries.
    pub(super) fn credits(&mut self) {
        let Layout {
            unit,
            left,
            ref rows,
            measures,
            ..
        } = *self.layout;
        let menu = self.scene.menu;
        let top = measures.heading[1] + 60.0 * unit;
        let bottom = rows.first().map_or(top, |row| row.rect[1]) - 20.0 * unit;
        // They come to rest with the last lines in sight.
        let whole: f32 = credits::LINES.iter().map(|line| size(line).1).sum();
        let rest = START + whole - (bottom - top) / unit * REST;
        let rolled = (menu.age * ROLL + menu.pushed * PUSH).clamp(0.0, rest.max(0.0));
        let mut y = top + (START - rolled) * unit;
        for line in credits::LINES {
            let (px, step) = size(line);
            y += step * unit;
            let fade = 40.0 * unit;
            let shown = ((y - top) / fade).min((bottom - y) / fade).clamp(0.0, 1.0);
            match line {
                credits::Line::Part(words) if shown > 0.0 => {
                    let style = Style {
                        face: Face::Display,
                        ..self.style(px * unit)
                    };
                    let style = style.in_colour(with_alpha(WARM, shown * self.shown));
                    self.text.write(style, left, y, words);
                }
                credits::Line::Name(words) if shown > 0.0 => {
                    self.text
                        .write(self.style(px * unit).faded(shown), left, y, words);
                }
                _ => {}
            }
        }
    }

    /// What the run came to.
    pub(super) fn results(&mut self) {
        let Some(results) = self.scene.facts.results else {
            return;
        };
        let Layout {
            unit,
            left,
            measures,
            ..
        } = *self.layout;
        let value = left + 150.0 * unit;
        let mut y = measures.heading[1] + 84.0 * unit;
        let best = results.best().map(|best| clock(best).to_string());
        let figures = [
            ("Time", clock(results.seconds).to_string()),
            ("Best", best.unwrap_or_default()),
            ("Deaths", results.deaths.to_string()),
            (
                "Secrets",
                format!("{} of {}", results.secrets.0, results.secrets.1),
            ),
        ];
        let style = self.style(26.0 * unit);
        let is_there = |name: &str| match name {
            "Secrets" => results.secrets.1 > 0,
            "Best" => results.best().is_some(),
            _ => true,
        };
        for (name, words) in figures.into_iter().filter(|(name, _)| is_there(name)) {
            self.text.write(style.faded(NOTES), left, y, name);
            let end = self.text.write(style, value, y, &words);
            if name == "Time" && results.is_record() {
                let warm = style.in_colour(with_alpha(WARM, self.shown));
                let at = [end + 30.0 * unit, y - self.text.cap_height(style) / 2.0];
                self.text
                    .glow(at, [80.0 * unit; 2], with_alpha(WARM, 0.5 * self.breath));
                self.text
                    .symbol(Symbol::Lozenge, at, 13.0 * unit, warm.colour);
                self.text.write(warm, end + 48.0 * unit, y, "New record");
            }
            if name == "Time" && results.marked {
                let small = self.style(18.0 * unit).faded(NOTES);
                self.text.write(small, end + 24.0 * unit, y, MARKED);
            }
            y += 44.0 * unit;
        }
    }

    /// A sentence about the focused entry, and what the keys do here.
    pub(super) fn bottom(&mut self) {
        let Layout { unit, left, .. } = *self.layout;
        let height = self.text.size()[1];
        let (note, is_wrong) = self.note();
        let style = self.style(18.0 * unit);
        let colour = if is_wrong {
            ALARM
        } else {
            with_alpha(PAPER, NOTES)
        };
        self.text.write(
            style.in_colour(with_alpha(colour, self.shown)),
            left,
            height - NOTE * unit,
            &note,
        );
        let baseline = height - HINTS * unit;
        let px = 16.0 * unit;
        let style = self.style(px).faded(NOTES);
        let mut x = left;
        for (cap, words) in self.hints() {
            x = caps::draw(self.text, &cap, x, baseline, px, style.colour) + 9.0 * unit;
            x = self.text.write(style, x, baseline, words) + 30.0 * unit;
        }
        if self.screen == Screen::Title {
            let right = self.text.size()[0] - 40.0 * unit;
            self.text
                .ending(style.faded(0.7), right, baseline, env!("CARGO_PKG_VERSION"));
        }
    }

    /// The sentence, and whether it tells of something wrong.
    fn note(&self) -> (String, bool) {
        let menu = self.scene.menu;
        let bindings = &self.scene.settings.controls.bindings;
        if let Some(wait) = menu.wait() {
            let what = if wait.column == BUTTON_COLUMN {
                "a button"
            } else {
                "a key"
            };
            return (
                format!(
                    "Press {what} for “{}”. Esc leaves it as it is.",
                    wait.deed.label()
                ),
                false,
            );
        }
        match menu.focused(self.scene.facts) {
            Some(Item::Bind(deed)) => {
                let input = match menu.column() {
                    BUTTON_COLUMN => bindings.button(deed).map(Input::Button),
                    slot => bindings.keys(deed)[slot].map(Input::Key),
                };
                match input.and_then(|input| bindings.conflict(deed, input)) {
                    Some(other) => (format!("This also does “{}”.", other.label()), true),
                    None => (Item::Bind(deed).note().into(), false),
                }
            }
            Some(item) => (self.record(item).unwrap_or(item.note()).into(), false),
            None => (String::new(), false),
        }
    }

    /// The best that was reached in the level that an entry begins.
    fn record(&self, item: Item) -> Option<&str> {
        let facts = self.scene.facts;
        let level = match item {
            Item::Level(level) => level,
            Item::NewGame if facts.levels.len() == 1 => 0,
            _ => return None,
        };
        facts.records.get(level).map(String::as_str)
    }

    fn hints(&self) -> Vec<(Cap, &'static str)> {
        let device = self.scene.device;
        let Some(item) = self.scene.menu.focused(self.scene.facts) else {
            return Vec::new();
        };
        let mut hints = Vec::new();
        match values::value(item, self.scene.settings) {
            Value::Scale(..) => {}
            Value::Choice(_) | Value::Switch(_) => hints.push((prompts::choose(device), "Change")),
            Value::None | Value::Keys => hints.push((prompts::choose(device), "Choose")),
        }
        if let Value::Scale(..) | Value::Choice(_) | Value::Switch(_) =
            values::value(item, self.scene.settings)
        {
            hints.push((Cap::Arrow(Symbol::ToLeft), "Less"));
            hints.push((Cap::Arrow(Symbol::ToRight), "More"));
        }
        if let Item::Bind(_) = item {
            hints.push((prompts::clear(device), "Remove"));
        }
        if self.screen != Screen::Title {
            hints.push((prompts::back(device), "Back"));
        }
        hints
    }
}

/// Size of a line of the credits, and from line to line, in the design's pixels.
fn size(line: &credits::Line) -> (f32, f32) {
    match line {
        credits::Line::Part(_) => (30.0, 44.0),
        credits::Line::Name(_) => (21.0, 32.0),
        credits::Line::Gap => (0.0, 34.0),
    }
}
