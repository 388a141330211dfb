//! The rules that the data of a level keeps. They are checked once, at the door; inside, nobody asks again.

use super::{Entity, Feature, Flaw, Level, Rect, Scenery, VERSION};
use crate::geom::polygon::winding;
use crate::geom::{Collider, OutlineError, Point, check_outline, expand};
use glam::DVec2;
use std::collections::BTreeMap;

/// Coordinates are smaller than this in magnitude, in metres: the mesh holds 4096, and outlines grow by the hero's size.
pub const COORDINATE_LIMIT: f64 = 4000.0;

/// An outline has at most this many corners.
pub const CORNER_LIMIT: usize = 4096;

/// Scenery stands at most this far from the plane of play, in metres.
const DEPTH_LIMIT: f64 = 1000.0;

/// Scenery is at most this many times its usual size.
const SCALE_LIMIT: f64 = 100.0;

/// Checks every rule, in the order of the fields.
///
/// # Errors
/// The first rule that is broken, and where.
pub fn check(level: &Level) -> Result<(), Flaw> {
    check_version(level)?;
    check_name(level)?;
    check_places(level)?;
    check_ids(level)?;
    level
        .features
        .iter()
        .enumerate()
        .try_for_each(|(index, feature)| check_feature(index, feature))?;
    check_start(level)?;
    level
        .scenery
        .iter()
        .enumerate()
        .try_for_each(|(index, scenery)| check_scenery(index, scenery))
}

fn check_version(level: &Level) -> Result<(), Flaw> {
    let message = || {
        format!(
            "{} is not supported; this build writes version {VERSION}",
            level.version
        )
    };
    require(level.version == VERSION, Entity::Level, "version", message)
}

fn check_name(level: &Level) -> Result<(), Flaw> {
    require(is_name(&level.name), Entity::Level, "name", || {
        NAME_RULE.into()
    })
}

/// Start, goal and bottom, each by itself and against each other.
fn check_places(level: &Level) -> Result<(), Flaw> {
    let Level {
        start,
        goal,
        bottom,
        ..
    } = *level;
    check_point(&Entity::Level, "start", start)?;
    check_point(&Entity::Level, "goal.min", goal.min)?;
    check_point(&Entity::Level, "goal.max", goal.max)?;
    check_coordinate(&Entity::Level, "bottom", bottom)?;
    let Rect { min, max } = goal;
    let rule =
        |ok, field: &str, message: &str| require(ok, Entity::Level, field, || message.into());
    rule(
        min.cmplt(max).all(),
        "goal",
        "min is not below and left of max",
    )?;
    rule(
        max.y > bottom,
        "goal",
        "lies below the bottom, where the hero falls out of the level",
    )?;
    rule(
        start.y > bottom,
        "start",
        "lies below the bottom, where the hero falls out of the level",
    )?;
    rule(
        !goal.contains(start),
        "start",
        "lies in the goal: the level would end before it begins",
    )
}

fn check_ids(level: &Level) -> Result<(), Flaw> {
    let mut seen = BTreeMap::new();
    for (index, feature) in level.features.iter().enumerate() {
        let entity = || Entity::Feature(index, feature.id.clone());
        require(is_name(&feature.id), entity(), "id", || NAME_RULE.into())?;
        if let Some(first) = seen.insert(&feature.id, index) {
            let message = format!("is the id of features[{first}] as well");
            return Err(Flaw {
                entity: entity(),
                field: "id".into(),
                corner: None,
                message,
            });
        }
    }
    Ok(())
}

fn check_feature(index: usize, feature: &Feature) -> Result<(), Flaw> {
    let entity = Entity::Feature(index, feature.id.clone());
    let outline = &feature.outline;
    for (corner, &p) in outline.iter().enumerate() {
        check_point(&entity, &format!("outline[{corner}]"), p).map_err(|flaw| Flaw {
            corner: Some(corner),
            ..flaw
        })?;
    }
    let flaw = |corner, message| Flaw {
        entity: entity.clone(),
        field: "outline".into(),
        corner,
        message,
    };
    if outline.len() > CORNER_LIMIT {
        let message = format!(
            "has {} corners; at most {CORNER_LIMIT} are allowed",
            outline.len()
        );
        return Err(flaw(None, message));
    }
    check_outline(&snapped(outline))
        .map_err(|error| flaw(corner_of(error), describe(error, outline)))
}

/// The grid points of an outline whose coordinates are in bounds.
fn snapped(outline: &[DVec2]) -> Vec<Point> {
    outline.iter().filter_map(|&p| Point::snap(p)).collect()
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

/// The standing hero must fit where the level starts; to touch is to fit.
fn check_start(level: &Level) -> Result<(), Flaw> {
    let hero = Collider::hero();
    let inside = |feature: &&Feature| {
        // The boundary of the outline expanded by the hero, who is then a point.
        let chain: Vec<Point> = expand(&snapped(&feature.outline), &hero)
            .iter()
            .map(|edge| edge.a)
            .collect();
        Point::snap(level.start)
            .and_then(|start| winding(&chain, start))
            .is_some_and(|turns| turns > 0)
    };
    match level.features.iter().find(inside) {
        Some(feature) => Err(Flaw::of_level(
            "start",
            format!("the hero would stand inside feature {:?}", feature.id),
        )),
        None => Ok(()),
    }
}

fn check_scenery(index: usize, scenery: &Scenery) -> Result<(), Flaw> {
    let entity = Entity::Scenery(index);
    let Scenery {
        at, depth, scale, ..
    } = *scenery;
    check_point(&entity, "at", at)?;
    require(depth.abs() <= DEPTH_LIMIT, entity.clone(), "depth", || {
        format!("{depth} is outside -{DEPTH_LIMIT}..={DEPTH_LIMIT} m")
    })?;
    require(scale > 0.0 && scale <= SCALE_LIMIT, entity, "scale", || {
        format!("{scale} is not above 0 and at most {SCALE_LIMIT}")
    })
}

fn check_point(entity: &Entity, field: &str, p: DVec2) -> Result<(), Flaw> {
    check_coordinate(entity, &format!("{field}.x"), p.x)?;
    check_coordinate(entity, &format!("{field}.y"), p.y)
}

fn check_coordinate(entity: &Entity, field: &str, value: f64) -> Result<(), Flaw> {
    require(value.is_finite(), entity.clone(), field, || {
        format!("{value} is not a finite number")
    })?;
    require(
        value.abs() < COORDINATE_LIMIT,
        entity.clone(),
        field,
        || {
            let value = if value.abs() < 1e9 {
                value.to_string()
            } else {
                format!("{value:e}")
            };
            format!(
                "{value} is out of bounds: coordinates are between -{COORDINATE_LIMIT} and {COORDINATE_LIMIT} m"
            )
        },
    )
}

fn require(
    ok: bool,
    entity: Entity,
    field: &str,
    message: impl Fn() -> String,
) -> Result<(), Flaw> {
    if ok {
        Ok(())
    } else {
        Err(Flaw {
            entity,
            field: field.into(),
            corner: None,
            message: message(),
        })
    }
}

const NAME_RULE: &str = "must have 1 to 64 characters, none of them a control character";

fn is_name(text: &str) -> bool {
    (1..=64).contains(&text.chars().count())
        && !text.trim().is_empty()
        && !text.chars().any(char::is_control)
}
