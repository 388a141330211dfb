//! The rules that the data of a level keeps. They are checked once, at the door; inside, nobody asks again.

use super::simple::first_clash;
use super::{Entity, Feature, Flaw, Level, Rect, Scenery, VERSION};
use crate::geom::Point;
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
    let flaw = |corner, message| {
        Err(Flaw {
            entity: entity.clone(),
            field: "outline".into(),
            corner,
            message,
        })
    };
    match outline.len() {
        n @ 0..3 => return flaw(None, format!("has {n} corners; an outline needs 3")),
        n if n > CORNER_LIMIT => {
            return flaw(
                None,
                format!("has {n} corners; at most {CORNER_LIMIT} are allowed"),
            );
        }
        _ => {}
    }
    let points: Vec<Point> = outline.iter().filter_map(|&p| Point::snap(p)).collect();
    if let Some(i) = (0..points.len()).find(|&i| points[i] == points[(i + 1) % points.len()]) {
        let next = (i + 1) % points.len();
        return flaw(
            Some(i),
            format!("corners {i} and {next} are one point of the grid: an edge of no length"),
        );
    }
    if let Some((i, j)) = first_clash(&points) {
        return flaw(Some(i), format!("edges {i} and {j} cross or touch"));
    }
    Ok(())
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
