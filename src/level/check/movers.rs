//! The rules of what moves.

use super::features::{check_body, check_id};
use super::{check_point, require, shown};
use crate::level::{Entity, Feature, Flaw, Kind, Level, Mover, Repeat, Starts, Stop};
use glam::DVec2;
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
        check_ends(level, mover, &entity)?;
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

/// What sets it going is there.
fn check_start(level: &Level, mover: &Mover, entity: &Entity) -> Result<(), Flaw> {
    let holds = |f: &Feature| f.kind.is_terrain() || f.kind == Kind::Ladder;
    match &mover.starts {
        Starts::AtOnce => Ok(()),
        Starts::On(trigger) => check_trigger(level, trigger, entity, "starts"),
        Starts::Ridden => require(mover.features.iter().any(holds), entity, "starts", || {
            "nobody can ride it: it has no Solid, OneWay or Ladder".into()
        }),
    }
}

/// Some feature has this id, and is a trigger.
fn check_trigger(level: &Level, id: &str, entity: &Entity, field: &str) -> Result<(), Flaw> {
    let riders = level.movers.iter().flat_map(|mover| &mover.features);
    let mut all = level.features.iter().chain(riders);
    let found = all.find(|feature| feature.id == id);
    require(found.is_some(), entity, field, || {
        format!("there is no feature {id:?}")
    })?;
    let is_trigger = found.is_some_and(|feature| feature.kind == Kind::Trigger);
    require(is_trigger, entity, field, || {
        format!("feature {id:?} is no Trigger")
    })
}

/// What comes back or is called goes between two ends.
fn check_ends(level: &Level, mover: &Mover, entity: &Entity) -> Result<(), Flaw> {
    let has_ends = mover.repeat == Repeat::Once && mover.path.len() > 1;
    let only = |given: bool, field: &str| {
        require(!given || has_ends, entity, field, || {
            "needs a path of two or more stops that is gone Once".into()
        })
    };
    only(mover.back.is_some(), "back")?;
    only(!mover.calls.is_empty(), "calls")?;
    let back = mover.back.unwrap_or_default();
    require(
        (0.0..=SECONDS_LIMIT).contains(&back),
        entity,
        "back",
        || format!("{} is outside 0..={SECONDS_LIMIT} s", shown(back)),
    )?;
    for (i, call) in mover.calls.iter().enumerate() {
        check_trigger(level, &call.by, entity, &format!("calls[{i}].by"))?;
    }
    Ok(())
}

/// In bounds wherever it goes, and so is the place where a checkpoint puts the hero.
fn check_rider(feature: &Feature, mover: &Mover, entity: &Entity) -> Result<(), Flaw> {
    check_body(feature, entity)?;
    for (i, stop) in mover.path.iter().enumerate() {
        let place = feature.respawn.unwrap_or(DVec2::ZERO);
        check_point(entity, "respawn", place + stop.at).map_err(|flaw| Flaw {
            message: format!("at path[{i}], {}", flaw.message),
            ..flaw
        })?;
    }
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
