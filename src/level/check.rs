//! The rules that the data of a level keeps. They are checked once, at the door; inside, nobody asks again.

mod features;
mod movers;
mod places;

use super::{Entity, Feature, Flaw, Kind, Level, Mover, Scenery, VERSION};
use crate::geom::drawn::winds_about;
use crate::geom::{Collider, Drawn};
use features::{check_body, check_id};
use glam::DVec2;
use movers::check_movers;
use places::{check_areas, check_frames, check_places, check_prompts};
use std::collections::BTreeMap;

/// Coordinates are smaller than this in magnitude, in metres: the mesh holds 4096, and outlines grow by the hero's size.
pub const COORDINATE_LIMIT: f64 = 4000.0;

/// An outline has at most this many corners.
pub const CORNER_LIMIT: usize = 4096;

/// Scenery stands at most this far from the plane of play, in metres.
const DEPTH_LIMIT: f64 = 1000.0;

/// Scenery is at most this many times its usual size.
const SCALE_LIMIT: f64 = 100.0;

/// Scenery is turned by at most this many degrees, either way.
const TURN_LIMIT: f64 = 360.0;

/// Checks every rule, in the order of the fields.
///
/// # Errors
/// The first rule that is broken, and where.
pub fn check(level: &Level) -> Result<(), Flaw> {
    check_version(level)?;
    check_name(level)?;
    check_places(level)?;
    check_areas(level)?;
    check_frames(level)?;
    check_prompts(level)?;
    check_features(level)?;
    check_starts(level)?;
    level
        .scenery
        .iter()
        .enumerate()
        .try_for_each(|(index, scenery)| check_scenery(index, scenery))
}

/// Checks a feature that is to stand still in a level; not whether its id is free.
///
/// # Errors
/// The first rule that is broken, and where.
pub fn check_feature(feature: &Feature) -> Result<(), Flaw> {
    let entity = Entity::Feature(0, feature.id.clone());
    require(is_name(&feature.id), &entity, "id", || NAME_RULE.into())?;
    check_body(feature, &entity)
}

fn check_version(level: &Level) -> Result<(), Flaw> {
    let message = || {
        format!(
            "{} is not supported; this build writes version {VERSION}",
            level.version
        )
    };
    require(level.version == VERSION, &Entity::Level, "version", message)
}

fn check_name(level: &Level) -> Result<(), Flaw> {
    require(is_name(&level.name), &Entity::Level, "name", || {
        NAME_RULE.into()
    })
}

/// Every feature by itself, then every mover: ids are unique among all of them.
fn check_features(level: &Level) -> Result<(), Flaw> {
    let mut seen = BTreeMap::new();
    for (index, feature) in level.features.iter().enumerate() {
        let entity = Entity::Feature(index, feature.id.clone());
        check_id(
            &feature.id,
            &entity,
            format!("features[{index}]"),
            &mut seen,
        )?;
    }
    for (index, feature) in level.features.iter().enumerate() {
        check_body(feature, &Entity::Feature(index, feature.id.clone()))?;
    }
    check_movers(level, seen)
}

/// The standing hero must fit where the level starts, and where he comes back; to touch is to fit.
fn check_starts(level: &Level) -> Result<(), Flaw> {
    check_free(level, level.start, &Entity::Level, "start")?;
    for (index, feature) in level.features.iter().enumerate() {
        if let Some(respawn) = feature.respawn {
            let entity = Entity::Feature(index, feature.id.clone());
            check_free(level, respawn, &entity, "respawn")?;
            require(respawn.y > level.bottom, &entity, "respawn", || {
                BELOW.into()
            })?;
        }
    }
    for (index, mover) in level.movers.iter().enumerate() {
        check_rides(level, index, mover)?;
    }
    Ok(())
}

/// Where the hero comes back on a mover: free when that begins its way, and above the bottom all the time.
fn check_rides(level: &Level, index: usize, mover: &Mover) -> Result<(), Flaw> {
    for (number, feature) in mover.features.iter().enumerate() {
        let Some(respawn) = feature.respawn else {
            continue;
        };
        let entity = Entity::Rider(index as u32, number as u32, feature.id.clone());
        check_free(level, respawn + mover.parked(), &entity, "respawn")?;
        let stops = mover.path.iter();
        let above = stops
            .clone()
            .all(|stop| respawn.y + stop.at.y > level.bottom);
        require(above, &entity, "respawn", || BELOW.into())?;
    }
    Ok(())
}

/// No solid is where the hero would stand, not even one that will move, and nothing that would end his life or the level.
fn check_free(level: &Level, at: DVec2, entity: &Entity, field: &str) -> Result<(), Flaw> {
    let hero = Collider::hero();
    let inside = |feature: &Feature, offset: DVec2| {
        let place = Drawn::of(at - offset);
        place.is_some_and(|place| winds_about(&feature.expand(&hero), place))
    };
    let ends = |feature: &Feature, offset: DVec2| {
        let what = match feature.kind {
            Kind::Solid => "would stand inside",
            Kind::Hazard => "would die in",
            Kind::Goal => "would win at once in",
            Kind::OneWay | Kind::Ladder | Kind::Checkpoint | Kind::Trigger | Kind::Secret => {
                return None;
            }
        };
        inside(feature, offset).then(|| format!("the hero {what} feature {:?}", feature.id))
    };
    let fixed = level.features.iter().map(|feature| (feature, DVec2::ZERO));
    let moving = level
        .movers
        .iter()
        .flat_map(|mover| mover.features.iter().map(move |f| (f, mover.parked())));
    match fixed
        .chain(moving)
        .find_map(|(feature, offset)| ends(feature, offset))
    {
        Some(message) => require(false, entity, field, || message.clone()),
        None => Ok(()),
    }
}

fn check_scenery(index: usize, scenery: &Scenery) -> Result<(), Flaw> {
    let entity = Entity::Scenery(index);
    let Scenery {
        at,
        depth,
        scale,
        turn,
        ..
    } = *scenery;
    check_point(&entity, "at", at)?;
    require(depth.abs() <= DEPTH_LIMIT, &entity, "depth", || {
        let depth = shown(depth);
        format!("{depth} is outside -{DEPTH_LIMIT}..={DEPTH_LIMIT} m")
    })?;
    require(
        scale > 0.0 && scale <= SCALE_LIMIT,
        &entity,
        "scale",
        || format!("{} is not above 0 and at most {SCALE_LIMIT}", shown(scale)),
    )?;
    let turn = turn.unwrap_or_default();
    require(turn.abs() <= TURN_LIMIT, &entity, "turn", || {
        let turn = shown(turn);
        format!("{turn} is outside -{TURN_LIMIT}..={TURN_LIMIT} degrees")
    })
}

fn check_point(entity: &Entity, field: &str, p: DVec2) -> Result<(), Flaw> {
    check_coordinate(entity, &format!("{field}.x"), p.x)?;
    check_coordinate(entity, &format!("{field}.y"), p.y)
}

fn check_coordinate(entity: &Entity, field: &str, value: f64) -> Result<(), Flaw> {
    require(value.is_finite(), entity, field, || {
        format!("{value} is not a finite number")
    })?;
    require(value.abs() < COORDINATE_LIMIT, entity, field, || {
        let value = shown(value);
        format!(
            "{value} is out of bounds: coordinates are between -{COORDINATE_LIMIT} and {COORDINATE_LIMIT} m"
        )
    })
}

/// A number as an error shows it: not with three hundred zeros.
fn shown(value: f64) -> String {
    if value.abs() < 1e9 || !value.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

fn require(
    ok: bool,
    entity: &Entity,
    field: &str,
    message: impl Fn() -> String,
) -> Result<(), Flaw> {
    if ok {
        Ok(())
    } else {
        Err(Flaw {
            entity: entity.clone(),
            field: field.into(),
            corner: None,
            message: message(),
        })
    }
}

const BELOW: &str = "lies below the bottom, where the hero falls out of the level";

const NAME_RULE: &str = "must have 1 to 64 characters, none of them a control character";

fn is_name(text: &str) -> bool {
    (1..=64).contains(&text.chars().count())
        && !text.trim().is_empty()
        && !text.chars().any(char::is_control)
}
