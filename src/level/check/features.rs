//! The rules of single features: their outlines, and which fields go with which kind.

use super::{CORNER_LIMIT, NAME_RULE, check_point, is_name, require, shown};
use crate::geom::{OutlineError, check_outline, check_polyline};
use crate::level::{By, Entity, Feature, Flaw, Kind};
use glam::DVec2;
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// Speeds of conveyors, in m/s.
const CONVEYOR: RangeInclusive<f64> = -100.0..=100.0;

/// Coefficients of friction.
const FRICTION: RangeInclusive<f64> = 0.0..=10.0;

/// How far from its foot a point of a body may be, in metres.
const POINT_LIMIT: f64 = 64.0;

/// An id is a name, and nobody else's; `seen` has the owners of those before.
pub(super) fn check_id(
    id: &str,
    entity: &Entity,
    owner: String,
    seen: &mut BTreeMap<String, String>,
) -> Result<(), Flaw> {
    require(is_name(id), entity, "id", || NAME_RULE.into())?;
    match seen.insert(id.into(), owner) {
        None => Ok(()),
        Some(first) => require(false, entity, "id", || {
            format!("is the id of {first} as well")
        }),
    }
}

/// Everything about a feature but its id.
pub(super) fn check_body(feature: &Feature, entity: &Entity) -> Result<(), Flaw> {
    check_corners(feature, entity)?;
    check_traits(feature, entity)?;
    check_region(feature, entity)
}

fn check_corners(feature: &Feature, entity: &Entity) -> Result<(), Flaw> {
    let outline = &feature.outline;
    for (corner, &p) in outline.iter().enumerate() {
        check_point(entity, &format!("outline[{corner}]"), p).map_err(|flaw| Flaw {
            corner: Some(corner),
            ..flaw
        })?;
    }
    require(outline.len() <= CORNER_LIMIT, entity, "outline", || {
        let count = outline.len();
        format!("has {count} corners; at most {CORNER_LIMIT} are allowed")
    })?;
    let check = match feature.kind {
        Kind::OneWay => check_polyline,
        _ => check_outline,
    };
    check(&feature.snapped()).map_err(|error| Flaw {
        entity: entity.clone(),
        field: "outline".into(),
        corner: corner_of(error),
        message: describe(error, outline),
    })
}

/// The corner at which to look first.
fn corner_of(error: OutlineError) -> Option<usize> {
    match error {
        OutlineError::TooFew { .. } | OutlineError::TooShort { .. } => None,
        OutlineError::ZeroLength { edge } => Some(edge),
        OutlineError::Spike { corner } => Some(corner),
        OutlineError::Meet { first, .. } => Some(first),
    }
}

/// The error with places, as the file writes them.
fn describe(error: OutlineError, outline: &[DVec2]) -> String {
    let corner = |i: usize| {
        outline
            .get(i % outline.len())
            .map_or(String::new(), |p| format!("({}, {})", p.x, p.y))
    };
    let ends = |i: usize| format!("{} to {}", corner(i), corner(i + 1));
    match error {
        OutlineError::TooFew { .. } | OutlineError::TooShort { .. } => error.to_string(),
        OutlineError::ZeroLength { edge } => format!("{error}: {}", ends(edge)),
        OutlineError::Spike { corner: i } => format!("{error}: {}", corner(i)),
        OutlineError::Meet { first, second } => {
            format!("{error}: {} and {}", ends(first), ends(second))
        }
    }
}

/// What bodies feel of terrain is in bounds, and only terrain has it.
fn check_traits(feature: &Feature, entity: &Entity) -> Result<(), Flaw> {
    let &Feature {
        kind,
        climbable,
        conveyor,
        friction,
        concave,
        ..
    } = feature;
    let only = |given: bool, may: bool, field: &str| {
        require(!given || may, entity, field, || meaningless(kind))
    };
    only(climbable, kind == Kind::Solid, "climbable")?;
    only(conveyor != 0.0, kind.is_terrain(), "conveyor")?;
    only(friction.is_some(), kind.is_terrain(), "friction")?;
    only(concave.is_some(), kind.is_terrain(), "concave")?;
    let within = |value: f64, range: RangeInclusive<f64>, field: &str, unit: &str| {
        require(range.contains(&value), entity, field, || {
            format!(
                "{} is outside {}..={}{unit}",
                shown(value),
                range.start(),
                range.end()
            )
        })
    };
    within(conveyor, CONVEYOR, "conveyor", " m/s")?;
    within(friction.unwrap_or(0.0), FRICTION, "friction", "")
}

/// What belongs to regions is in bounds, and only they have it.
fn check_region(feature: &Feature, entity: &Entity) -> Result<(), Flaw> {
    let &Feature {
        kind, by, respawn, ..
    } = feature;
    require(by.is_none() || !kind.is_terrain(), entity, "by", || {
        meaningless(kind)
    })?;
    if let Some(By::Point(x, y)) = by {
        let near = x.abs().max(y.abs()) <= POINT_LIMIT && x.is_finite() && y.is_finite();
        require(near, entity, "by", || {
            format!("Point({x}, {y}) is not within {POINT_LIMIT} m of the foot")
        })?;
    }
    match (kind, respawn) {
        (Kind::Checkpoint, Some(p)) => check_point(entity, "respawn", p),
        (Kind::Checkpoint, None) => require(false, entity, "respawn", || {
            "is missing: a checkpoint says where the hero comes back".into()
        }),
        (_, Some(_)) => require(false, entity, "respawn", || meaningless(kind)),
        (_, None) => Ok(()),
    }
}

fn meaningless(kind: Kind) -> String {
    format!("means nothing for kind {kind:?}")
}
