//! Text as named fields whose values are still unread: so that a value that makes no sense spoils no other.

use ron::value::RawValue;
use serde::de::{Deserialize, DeserializeOwned, Deserializer, MapAccess, Visitor};
use std::fmt;
use std::ops::RangeInclusive;

/// The fields of a RON struct by name, in the order of the text.
pub struct Fields<'a>(pub Vec<(String, &'a RawValue)>);

impl<'de: 'a, 'a> Deserialize<'de> for Fields<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;
        impl<'de> Visitor<'de> for Reader {
            type Value = Vec<(String, &'de RawValue)>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("named fields")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut fields = Vec::new();
                while let Some(name) = map.next_key()? {
                    fields.push((name, map.next_value()?));
                }
                Ok(fields)
            }
        }
        deserializer.deserialize_struct("", &[], Reader).map(Fields)
    }
}

/// What is wrong with single values, for people.
pub type Complaints = Vec<String>;

/// A value, or what is used instead of one that makes no sense.
pub fn value<T: DeserializeOwned>(
    raw: &RawValue,
    name: &str,
    instead: T,
    complaints: &mut Complaints,
) -> T {
    raw.into_rust().unwrap_or_else(|error| {
        complaints.push(format!("{name}: {error}; the default is used"));
        instead
    })
}

/// A number, kept within its range.
pub fn within<T: PartialOrd + Copy + fmt::Display>(
    number: T,
    name: &str,
    range: &RangeInclusive<T>,
    complaints: &mut Complaints,
) -> T {
    let (low, high) = (*range.start(), *range.end());
    let kept = match number {
        n if n < low => low,
        n if n > high => high,
        n => return n,
    };
    complaints.push(format!(
        "{name}: {number} is not within {low} to {high}; {kept} is used"
    ));
    kept
}
