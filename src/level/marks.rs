//! Where in the text of a level its parts begin, so that an error can name a line.
//!
//! The text is read a second time, as raw values that borrow from it: the format's own parser
//! decides where each value starts, so comments and strings that look like values fool nobody.
//! This costs time only when there is an error to report.

use super::{Entity, Flaw};
use ron::error::Span;
use ron::value::RawValue;
use serde::{Deserialize, Deserializer};

/// The raw parts of a level. A part that is missing is no matter here.
#[derive(Default, Deserialize)]
#[serde(default, rename = "Level")]
struct LevelParts<'a> {
    #[serde(borrow, deserialize_with = "raw")]
    version: Raw<'a>,
    #[serde(borrow, deserialize_with = "raw")]
    name: Raw<'a>,
    #[serde(borrow, deserialize_with = "raw")]
    start: Raw<'a>,
    #[serde(borrow, deserialize_with = "raw")]
    goal: Raw<'a>,
    #[serde(borrow, deserialize_with = "raw")]
    bottom: Raw<'a>,
    #[serde(borrow, deserialize_with = "raw")]
    features: Raw<'a>,
    #[serde(borrow, deserialize_with = "raw")]
    scenery: Raw<'a>,
}

/// The raw parts of a feature.
#[derive(Default, Deserialize)]
#[serde(default, rename = "Feature")]
struct FeatureParts<'a> {
    #[serde(borrow, deserialize_with = "raw")]
    id: Raw<'a>,
    #[serde(borrow, deserialize_with = "raw")]
    outline: Raw<'a>,
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

/// The places of the parts of one text.
pub(super) struct Marks<'a> {
    text: &'a str,
    level: LevelParts<'a>,
    features: Vec<&'a RawValue>,
    scenery: Vec<&'a RawValue>,
}

impl<'a> Marks<'a> {
    /// The places in a text, or `None` if its brackets and strings make no sense.
    pub fn read(text: &'a str) -> Option<Self> {
        let level: LevelParts = ron::from_str(text).ok()?;
        let (features, scenery) = (list(level.features), list(level.scenery));
        Some(Marks {
            text,
            level,
            features,
            scenery,
        })
    }

    /// The line of the value that a flaw is about, or of the nearest part around it.
    pub fn line(&self, flaw: &Flaw) -> Option<usize> {
        let value = match flaw.entity {
            Entity::Level => self.level_field(&flaw.field),
            Entity::Feature(index, _) => self.feature_field(self.features.get(index)?, flaw),
            Entity::Scenery(index) => self.scenery.get(index).copied(),
        };
        value.map(|value| self.line_of(value))
    }

    /// The feature or piece of scenery that an error of the parser lies in.
    pub fn entity(&self, error: &Span) -> Option<Entity> {
        let holds = |value: &&RawValue| {
            let first = self.offset(value);
            (first..first + value.get_ron().len()).contains(&self.offset_of(error))
        };
        if let Some(index) = self.features.iter().position(holds) {
            let parts: Option<FeatureParts> = self.features[index].into_rust().ok();
            let id = parts
                .and_then(|parts| parts.id)
                .and_then(|id| id.into_rust().ok());
            return Some(Entity::Feature(
                index,
                id.unwrap_or_else(|| format!("#{index}")),
            ));
        }
        self.scenery.iter().position(holds).map(Entity::Scenery)
    }

    fn level_field(&self, field: &str) -> Raw<'a> {
        match field.split('.').next()? {
            "version" => self.level.version,
            "name" => self.level.name,
            "start" => self.level.start,
            "goal" => self.level.goal,
            "bottom" => self.level.bottom,
            _ => None,
        }
    }

    fn feature_field(&self, feature: &'a RawValue, flaw: &Flaw) -> Raw<'a> {
        let parts: FeatureParts = feature.into_rust().ok()?;
        let corner = flaw
            .corner
            .and_then(|corner| list(parts.outline).get(corner).copied());
        let part = if flaw.field == "id" {
            parts.id
        } else {
            corner.or(parts.outline)
        };
        part.or(Some(feature))
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
