//! The rules of terrain that moves.

use super::features::{check_body, check_id};
use super::{check_point, require, shown};
use crate::level::{Entity, Feature, Flaw, Kind, Level, Mover, Repeat, Starts, Stop};
use std::collections::BTreeMap;

/// A mover stops at most this often on one path.
const STOP_LIMIT: usize = 1024;

/// Nothing on a path takes longer, in seconds.
const SECONDS_LIMIT: f64 = 3600.0;

/// The shortest way between two stops, in seconds: no mover is faster than the world is wide in a tick.
const SECONDS_LEAST: f64 = 0.01;

/// Checks every mover. `seen` holds the ids of the level's features, with what they belong to.
pub(super) fn check_movers(level: &Level, mut seen: BTreeMap<String, String>) -> Result<(), Flaw> {
    let mut names = BTreeMap::new();
    for (index, mover) in level.movers.iter().enumerate() {
        let entity = Entity::Mover(index, mover.id.clone());
        check_id(&mover.id, &entity, format!("movers[{index}]"), &mut names)?;
        check_path(mover, &entity)?;
        check_start(level, mover, &entity)?;
        let some = !mover.features.is_empty();
        require(some, &entity, "features", || {
            "nothing moves: there are none".into()
        })?;
        for (number, feature) in mover.features.iter().enumerate() {
            let entity = Entity::Rider(index as u32, number as u32, feature.id.clone());
            let owner = format!("movers[{index}].features[{number}]");
            check_id(&feature.id, &entity, owner, &mut seen)?;
            check_rider(feature, mover, &entity)?;
        }
    }
    Ok(())
}

/// The stops one by one, and the ways between them.
fn check_path(mover: &Mover, entity: &Entity) -> Result<(), Flaw> {
    let stops = &mover.path;
    let count = (1..=STOP_LIMIT).contains(&stops.len());
    require(count, entity, "path", || {
        format!("has {} stops; 1 to {STOP_LIMIT} are allowed", stops.len())
    })?;
    let goes_on = |i: usize| i + 1 < stops.len() || mover.repeat == Repeat::Loop && stops.len() > 1;
    for (i, stop) in stops.iter().enumerate() {
        let &Stop {
            at, wait, seconds, ..
        } = stop;
        check_point(entity, &format!("path[{i}].at"), at)?;
        let field = format!("path[{i}].wait");
        require(
            (0.0..=SECONDS_LIMIT).contains(&wait),
            entity,
            &field,
            || format!("{} is outside 0..={SECONDS_LIMIT} s", shown(wait)),
        )?;
        let field = format!("path[{i}].seconds");
        if goes_on(i) {
            let ok = (SECONDS_LEAST..=SECONDS_LIMIT).contains(&seconds);
            require(ok, entity, &field, || {
                format!(
                    "{} is outside {SECONDS_LEAST}..={SECONDS_LIMIT} s: the way to the next stop takes some time",
                    shown(seconds)
                )
            })?;
        } else {
            require(seconds == 0.0, entity, &field, || {
                format!("{} s to nowhere: no stop follows this one", shown(seconds))
            })?;
        }
    }
    Ok(())
}

/// What sets it going is there, and is a trigger.
fn check_start(level: &Level, mover: &Mover, entity: &Entity) -> Result<(), Flaw> {
    let Starts::On(trigger) = &mover.starts else {
        return Ok(());
    };
    let found = level.features.iter().find(|feature| feature.id == *trigger);
    require(found.is_some(), entity, "starts", || {
        format!("there is no feature {trigger:?}")
    })?;
    let is_trigger = found.is_some_and(|feature| feature.kind == Kind::Trigger);
    require(is_trigger, entity, "starts", || {
        format!("feature {trigger:?} is no Trigger")
    })
}

/// Terrain only, and in bounds wherever it goes.
fn check_rider(feature: &Feature, mover: &Mover, entity: &Entity) -> Result<(), Flaw> {
    require(feature.kind.is_terrain(), entity, "kind", || {
        format!("{:?} cannot move: only Solid and OneWay can", feature.kind)
    })?;
    check_body(feature, entity)?;
    for (i, stop) in mover.path.iter().enumerate() {
        for (corner, &p) in feature.outline.iter().enumerate() {
            check_point(entity, &format!("outline[{corner}]"), p + stop.at).map_err(|flaw| {
                Flaw {
                    corner: Some(corner),
                    message: format!("at path[{i}], {}", flaw.message),
                    ..flaw
                }
            })?;
        }
    }
    Ok(())
}
