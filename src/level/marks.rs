//! Where in the text of a level its parts begin, so that an error can name a line.
//!
//! The text is read a second time, as raw values that borrow from it: the format's own parser
//! decides where each value starts, so comments and strings that look like values fool nobody.
//! This costs time only when there is an error to report.

use super::{Entity, Flaw};
use ron::error::Span;
use ron::value::RawValue;
use serde::{Deserialize, Deserializer};

/// The raw parts of one type of the format, by the names of its fields. A part that is missing is no matter here.
macro_rules! parts {
    ($($name:ident is $text:literal { $($field:ident),+ })+) => { $(
        #[derive(Default, Deserialize)]
        #[serde(default, rename = $text)]
        struct $name<'a> {
            $(#[serde(borrow, deserialize_with = "raw")] $field: Raw<'a>,)+
        }

        impl<'a> $name<'a> {
            /// The part with this name in a raw value.
            fn find(value: &'a RawValue, field: &str) -> Raw<'a> {
                let parts: $name = value.into_rust().ok()?;
                match field {
                    $(stringify!($field) => parts.$field,)+
                    _ => None,
                }
            }
        }
    )+ };
}

parts! {
    LevelParts is "Level" { version, name, start, goal, bottom, areas, frames, prompts, features, movers, scenery }
    AreaParts is "Area" { name, room, mood }
    FrameParts is "Frame" { room, at, zoom }
    PromptParts is "Prompt" { skill, room }
    FeatureParts is "Feature" { id, kind, outline, climbable, conveyor, friction, concave, by, respawn }
    MoverParts is "Mover" { id, features, path, repeat, starts, back, calls }
    CallParts is "Call" { by, to }
    StopParts is "Stop" { at, wait, seconds, easing }
}

type Raw<'a> = Option<&'a RawValue>;

fn raw<'de: 'a, 'a, D: Deserializer<'de>>(deserializer: D) -> Result<Raw<'a>, D::Error> {
    <&RawValue>::deserialize(deserializer).map(Some)
}

/// The elements of a raw list; none if it is not one.
fn list<'a>(value: Raw<'a>) -> Vec<&'a RawValue> {
    value
        .and_then(|value| value.into_rust().ok())
        .unwrap_or_default()
}

/// The value of a field like `outline[4].x`: the element that the index names where there is one.
fn element<'a>(field: &str, find: impl Fn(&str) -> Raw<'a>) -> Raw<'a> {
    let first = field.split('.').next()?;
    let Some((name, index)) = first.split_once('[') else {
        return find(first);
    };
    let whole = find(name);
    let index: Option<usize> = index.trim_end_matches(']').parse().ok();
    index
        .and_then(|index| list(whole).get(index).copied())
        .or(whole)
}

/// The id in the raw value of a feature or a mover, or its number.
fn id_of(find: impl Fn(&str) -> Option<String>, index: usize) -> String {
    find("id").unwrap_or_else(|| format!("#{index}"))
}

/// The corner of a feature that a flaw is about, or else its field.
fn feature_field<'a>(feature: &'a RawValue, flaw: &Flaw) -> Raw<'a> {
    let find = |name: &str| FeatureParts::find(feature, name);
    let corner = flaw
        .corner
        .and_then(|corner| list(find("outline")).get(corner).copied());
    corner
        .or_else(|| element(&flaw.field, find))
        .or(Some(feature))
}

/// A field of a mover, or one of a stop of its path or of a call.
fn mover_field<'a>(mover: &'a RawValue, field: &str) -> Raw<'a> {
    let found = element(field, |name| MoverParts::find(mover, name));
    let inner = field.split_once('.').map(|(_, rest)| rest);
    let stop = found.zip(inner).and_then(|(part, rest)| {
        let stop = element(rest, |name| StopParts::find(part, name));
        stop.or_else(|| element(rest, |name| CallParts::find(part, name)))
    });
    stop.or(found).or(Some(mover))
}

/// The places of the parts of one text.
pub(super) struct Marks<'a> {
    text: &'a str,
    level: &'a RawValue,
    areas: Vec<&'a RawValue>,
    frames: Vec<&'a RawValue>,
    prompts: Vec<&'a RawValue>,
    features: Vec<&'a RawValue>,
    movers: Vec<&'a RawValue>,
    scenery: Vec<&'a RawValue>,
}

impl<'a> Marks<'a> {
    /// The places in a text, or `None` if its brackets and strings make no sense.
    pub fn read(text: &'a str) -> Option<Self> {
        let level: &RawValue = ron::from_str(text).ok()?;
        let part = |name| list(LevelParts::find(level, name));
        Some(Marks {
            text,
            level,
            areas: part("areas"),
            frames: part("frames"),
            prompts: part("prompts"),
            features: part("features"),
            movers: part("movers"),
            scenery: part("scenery"),
        })
    }

    /// The line of the value that a flaw is about, or of the nearest part around it.
    pub fn line(&self, flaw: &Flaw) -> Option<u32> {
        let value = match flaw.entity {
            Entity::Level => element(&flaw.field, |name| LevelParts::find(self.level, name)),
            Entity::Feature(index, _) => feature_field(self.features.get(index)?, flaw),
            Entity::Mover(index, _) => mover_field(self.movers.get(index)?, &flaw.field),
            Entity::Rider(mover, index, _) => {
                let riders = self.riders(self.movers.get(mover as usize)?);
                feature_field(riders.get(index as usize)?, flaw)
            }
            Entity::Area(index, _) => {
                let area = self.areas.get(index).copied()?;
                element(&flaw.field, |name| AreaParts::find(area, name)).or(Some(area))
            }
            Entity::Frame(index) => {
                let frame = self.frames.get(index).copied()?;
                element(&flaw.field, |name| FrameParts::find(frame, name)).or(Some(frame))
            }
            Entity::Prompt(index) => {
                let prompt = self.prompts.get(index).copied()?;
                element(&flaw.field, |name| PromptParts::find(prompt, name)).or(Some(prompt))
            }
            Entity::Scenery(index) => self.scenery.get(index).copied(),
        };
        value.and_then(|value| u32::try_from(self.line_of(value)).ok())
    }

    /// The feature, mover, area, frame, prompt or piece of scenery that an error of the parser lies in.
    pub fn entity(&self, error: &Span) -> Option<Entity> {
        let at = self.offset_of(error);
        let holds = |value: &&RawValue| {
            let first = self.offset(value);
            (first..first + value.get_ron().len()).contains(&at)
        };
        let text = |raw: Raw<'a>| raw.and_then(|id| id.into_rust::<String>().ok());
        let feature_id =
            |value: &'a RawValue, index| id_of(|name| text(FeatureParts::find(value, name)), index);
        if let Some(index) = self.features.iter().position(holds) {
            return Some(Entity::Feature(
                index,
                feature_id(self.features[index], index),
            ));
        }
        if let Some(mover) = self.movers.iter().position(holds) {
            let riders = self.riders(self.movers[mover]);
            return Some(match riders.iter().position(holds) {
                Some(index) => {
                    Entity::Rider(mover as u32, index as u32, feature_id(riders[index], index))
                }
                None => {
                    let id = |name: &str| text(MoverParts::find(self.movers[mover], name));
                    Entity::Mover(mover, id_of(id, mover))
                }
            });
        }
        if let Some(index) = self.areas.iter().position(holds) {
            let name = text(AreaParts::find(self.areas[index], "name"));
            return Some(Entity::Area(
                index,
                name.unwrap_or_else(|| format!("#{index}")),
            ));
        }
        if let Some(index) = self.frames.iter().position(holds) {
            return Some(Entity::Frame(index));
        }
        if let Some(index) = self.prompts.iter().position(holds) {
            return Some(Entity::Prompt(index));
        }
        self.scenery.iter().position(holds).map(Entity::Scenery)
    }

    /// The features of a mover.
    fn riders(&self, mover: &'a RawValue) -> Vec<&'a RawValue> {
        list(MoverParts::find(mover, "features"))
    }

    /// Where a value begins, in bytes from the start of the text: both borrow from one string.
    fn offset(&self, value: &RawValue) -> usize {
        value.trim().get_ron().as_ptr() as usize - self.text.as_ptr() as usize
    }

    fn line_of(&self, value: &RawValue) -> usize {
        1 + self.text.as_bytes()[..self.offset(value)]
            .iter()
            .filter(|&&b| b == b'\n')
            .count()
    }

    /// The byte at which the parser stopped. It counts lines from 1 and columns in characters from 1.
    fn offset_of(&self, error: &Span) -> usize {
        let line_start: usize = self
            .text
            .split_inclusive('\n')
            .take(error.start.line - 1)
            .map(str::len)
            .sum();
        let columns = self.text[line_start..]
            .char_indices()
            .nth(error.start.col.saturating_sub(1));
        line_start + columns.map_or(0, |(bytes, _)| bytes)
    }
}
