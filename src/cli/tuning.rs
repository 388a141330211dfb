//! Tuning files: what was changed, as RON, with units beside the numbers.

use super::files::{FileError, read_text, write_atomic};
use super::lines;
use crate::tune::{Camera, Meta, Motion, Tuning};
use std::fmt::Write;
use std::path::Path;

/// Where the overlay saves to and the game loads from, unless told otherwise.
pub const DEFAULT_FILE: &str = "tuning.local.ron";

/// Reads a tuning file; what it does not name keeps its default.
///
/// # Errors
/// Names the file, the line and the field.
pub fn load(path: &Path) -> Result<Tuning, FileError> {
    parse(&read_text(path)?).map_err(|reason| FileError::new(path, reason))
}

/// Understands the text of a tuning file.
///
/// # Errors
/// The reason, with line and field.
pub fn parse(text: &str) -> Result<Tuning, String> {
    if text.trim().is_empty() {
        return Err("line 1: the file is empty".into());
    }
    let tuning: Tuning =
        ron::from_str(text).map_err(|e| format!("line {}: {}", e.span.start.line, e.code))?;
    tuning
        .check()
        .map_err(|e| format!("line {}: {e}", lines::of_field(text, e.meta.name)))?;
    Ok(tuning)
}

/// The text of a tuning file: the changed values alone, bit for bit.
pub fn text(tuning: &Tuning) -> String {
    let mut out =
        String::from("// Changed tunables; what is not named here keeps its default.\n(\n");
    for (group, meta, values) in [
        ("motion", Motion::META, tuning.motion.values()),
        ("camera", Camera::META, tuning.camera.values()),
    ] {
        let changed: Vec<(&Meta, f64)> = meta
            .iter()
            .zip(values)
            .filter(|(meta, value)| meta.default != *value)
            .collect();
        if changed.is_empty() {
            continue;
        }
        let _ = writeln!(out, "    {group}: (");
        for (Meta { name, unit, .. }, value) in changed {
            let unit = if unit.is_empty() {
                String::new()
            } else {
                format!(" // {unit}")
            };
            let _ = writeln!(out, "        {name}: {value:?},{unit}");
        }
        out.push_str("    ),\n");
    }
    out.push_str(")\n");
    out
}

/// Writes a tuning file.
///
/// # Errors
/// The file cannot be written.
pub fn save(path: &Path, tuning: &Tuning) -> Result<(), FileError> {
    write_atomic(path, text(tuning).as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn saved_values_come_back_bit_for_bit_and_defaults_are_not_named() {
        let mut tuning = Tuning::default();
        tuning.motion.gravity = 0.1 + 0.2;
        tuning.camera.tilt = -1e-300;
        let text = text(&tuning);
        assert_eq!(parse(&text), Ok(tuning));
        assert!(
            text.contains("gravity: 0.30000000000000004, // m/s^2") && !text.contains("jump_speed")
        );
        assert_eq!(
            parse(&super::text(&Tuning::default())),
            Ok(Tuning::default())
        );
    }

    #[test]
    fn a_broken_file_is_refused_by_line_and_field() {
        for (text, reason) in [
            ("", "line 1: the file is empty"),
            (
                "(\n motion: (\n  gravity: 1e300,\n ),\n)",
                "line 3: field `gravity`: ",
            ),
            (
                "(\n motion: (\n  gravity: NaN,\n ),\n)",
                "line 3: field `gravity`: NaN is outside",
            ),
            (
                "(\n motion: (\n\n  gravty: 1.0,\n ),\n)",
                "line 4: Unexpected field named `gravty`",
            ),
            (
                "( // gravity: high\n motion: (\n  apex_gravity: 0.5,\n  run_speed: 1.0, gravity : -1.0))",
                "line 4: field `gravity`: -1.0 is outside",
            ),
            ("(\n motion: (\n  gravity: 4", "line 3: "),
            ("(\n motion: (\n  gravity: \"much\",\n ),\n)", "line 3: "),
        ] {
            let error = parse(text).unwrap_err();
            assert!(error.starts_with(reason), "{text:?}: {error}");
        }
    }
}
