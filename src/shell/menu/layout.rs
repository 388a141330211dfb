//! Where things are on a page, in pixels, and what is under the pointer.

use super::items::{Item, Screen, entries};
use super::values::Value;
use super::{BUTTON_COLUMN, Facts, Menu, Nav};
use crate::shell::text::Rect;

/// Size of the picture that lengths are meant for; other sizes are scaled.
const DESIGN: [f32; 2] = [1280.0, 720.0];
/// From the left edge to the text, and the same as a share of wide pictures.
const MARGIN: f32 = 96.0;
const MARGIN_SHARE: f32 = 0.075;
/// Where the bottom lines stand, from the lower edge.
pub const NOTE: f32 = 96.0;
/// Where the hints stand, likewise.
pub const HINTS: f32 = 44.0;

/// How the entries of a page are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// Size of the heading, and its baseline.
    pub heading: [f32; 2],
    /// Size of the entries.
    pub text: f32,
    /// Top of the first row, and from row to row.
    pub rows: [f32; 2],
    /// Width of the rows, and where values begin in them.
    pub width: [f32; 2],
}

impl Measures {
    /// Of a screen, in the design's pixels.
    fn of(screen: Screen) -> Measures {
        let list = |heading, rows| Measures {
            heading,
            text: 27.0,
            rows,
            width: [330.0, 330.0],
        };
        match screen {
            Screen::Title => list([88.0, 252.0], [330.0, 47.0]),
            Screen::Pause => list([58.0, 182.0], [284.0, 47.0]),
            Screen::Results => list([58.0, 170.0], [456.0, 47.0]),
            Screen::Confirm(_) => list([52.0, 190.0], [288.0, 47.0]),
            Screen::Settings | Screen::Levels => list([52.0, 142.0], [202.0, 47.0]),
            Screen::Credits => list([52.0, 142.0], [560.0, 47.0]),
            Screen::Video | Screen::Audio | Screen::Access => Measures {
                heading: [52.0, 142.0],
                text: 24.0,
                rows: [202.0, 46.0],
                width: [660.0, 330.0],
            },
            Screen::Controls => Measures {
                heading: [52.0, 112.0],
                text: 20.0,
                rows: [168.0, 34.5],
                width: [800.0, 260.0],
            },
        }
    }

    fn scaled(self, unit: f32) -> Measures {
        let pair = |values: [f32; 2]| values.map(|v| v * unit);
        Measures {
            heading: pair(self.heading),
            text: self.text * unit,
            rows: pair(self.rows),
            width: pair(self.width),
        }
    }
}

/// An entry's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The entry.
    pub item: Item,
    /// The whole row.
    pub rect: Rect,
    /// Where its value is shown.
    pub value: Rect,
}

/// A page's places.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Pixels for one of the design's.
    pub unit: f32,
    /// Where text begins.
    pub left: f32,
    /// The sizes on this page.
    pub measures: Measures,
    /// The entries, from the top down.
    pub rows: Vec<Row>,
}

/// Width of the arrows beside a value, in the design's pixels.
pub const ARROW: f32 = 34.0;
/// Width of the number after a scale, in the design's pixels.
pub const NUMBER: f32 = 88.0;
/// Width of the values of a list of settings.
const VALUE: f32 = 300.0;

impl Layout {
    /// The places on the open page, in a picture of so many pixels; `None` while the menus are closed.
    pub fn of(menu: &Menu, facts: &Facts, [width, height]: [f32; 2]) -> Option<Layout> {
        let screen = menu.screen()?;
        let unit = (width / DESIGN[0]).min(height / DESIGN[1]);
        let measures = Measures::of(screen).scaled(unit);
        let left = (MARGIN * unit).max(width * MARGIN_SHARE);
        // The design's height in the middle of a taller picture.
        let top = (height - DESIGN[1] * unit) / 2.0;
        let place = |(index, item): (usize, Item)| {
            let [first, step] = measures.rows;
            let y = top + first + index as f32 * step;
            let values = match item {
                Item::Bind(_) => measures.width[0] - measures.width[1],
                _ => VALUE * unit,
            };
            Row {
                item,
                rect: [left, y, measures.width[0], step],
                value: [left + measures.width[1], y, values, step],
            }
        };
        let mut measures_in_place = measures;
        measures_in_place.heading[1] += top;
        let rows = entries(screen, facts)
            .into_iter()
            .enumerate()
            .map(place)
            .collect();
        Some(Layout {
            unit,
            left,
            measures: measures_in_place,
            rows,
        })
    }

    /// A cell of the controls' table.
    pub fn cell(&self, row: &Row, column: usize) -> Rect {
        let [x, y, width, height] = row.value;
        let each = width / (BUTTON_COLUMN + 1) as f32;
        [x + each * column as f32, y, each, height]
    }

    /// The line of a scale in its value's place: from below the left arrow of other values to where the number begins.
    pub fn track(&self, row: &Row) -> Rect {
        let [x, y, width, height] = row.value;
        let start = ARROW * self.unit * 0.3;
        [x + start, y, width - start - NUMBER * self.unit, height]
    }

    /// The entry under a point, and the column of the table.
    pub fn under(&self, [x, y]: [f32; 2]) -> Option<Nav> {
        let inside = |rect: Rect| contains(rect, [x, y]);
        let index = self
            .rows
            .iter()
            .position(|row| inside(grown(row.rect, self.unit)))?;
        let row = &self.rows[index];
        let is_table = matches!(row.item, Item::Bind(_));
        let column = (0..=BUTTON_COLUMN).find(|c| is_table && inside(self.cell(row, *c)));
        Some(Nav::Point(index, column))
    }

    /// What a click at a point means for an entry with such a value: a share of its scale, a step, or choosing it.
    pub fn click(&self, index: usize, value: &Value, point: [f32; 2]) -> Nav {
        let Some(row) = self.rows.get(index) else {
            return Nav::Choose;
        };
        let [x, _, width, _] = row.value;
        match value {
            Value::Scale(..) if contains(row.value, point) => Nav::Share(self.share(row, point[0])),
            Value::Choice(_) | Value::Switch(_) if contains(row.value, point) => {
                if point[0] < x + width / 2.0 {
                    Nav::Left
                } else {
                    Nav::Right
                }
            }
            _ => Nav::Choose,
        }
    }

    /// Which share of an entry's scale a place across belongs to.
    pub fn share(&self, row: &Row, x: f32) -> f32 {
        let [from, _, width, _] = self.track(row);
        ((x - from) / width).clamp(0.0, 1.0)
    }
}

fn contains([x, y, width, height]: Rect, point: [f32; 2]) -> bool {
    (x..x + width).contains(&point[0]) && (y..y + height).contains(&point[1])
}

/// A row reaches a little further to the left than its text: there the focus is shown.
fn grown([x, y, width, height]: Rect, unit: f32) -> Rect {
    [x - ARROW * unit, y, width + ARROW * unit, height]
}
