//! The rules of what is a place: start, goal and bottom, the areas, and what the camera frames.

use super::{BELOW, NAME_RULE, check_coordinate, check_point, is_name, require, shown};
use crate::level::{Entity, Flaw, Level, Rect};
use std::ops::RangeInclusive;

/// How many times larger than usual a frame may show things.
const ZOOM: RangeInclusive<f64> = 0.25..=4.0;

/// Start, goal and bottom, each by itself and against each other.
pub(super) fn check_places(level: &Level) -> Result<(), Flaw> {
    let Level {
        start,
        goal,
        bottom,
        ..
    } = *level;
    check_point(&Entity::Level, "start", start)?;
    check_room(&Entity::Level, "goal", goal)?;
    check_coordinate(&Entity::Level, "bottom", bottom)?;
    let rule =
        |ok, field: &str, message: &str| require(ok, &Entity::Level, field, || message.into());
    rule(goal.max.y > bottom, "goal", BELOW)?;
    rule(start.y > bottom, "start", BELOW)?;
    rule(
        !goal.contains(start),
        "start",
        "lies in the goal: the level would end before it begins",
    )
}

/// Every area by itself.
pub(super) fn check_areas(level: &Level) -> Result<(), Flaw> {
    for (index, area) in level.areas.iter().enumerate() {
        let entity = Entity::Area(index, area.name.clone());
        require(is_name(&area.name), &entity, "name", || NAME_RULE.into())?;
        check_room(&entity, "room", area.room)?;
    }
    Ok(())
}

/// Every frame by itself.
pub(super) fn check_frames(level: &Level) -> Result<(), Flaw> {
    for (index, frame) in level.frames.iter().enumerate() {
        let entity = Entity::Frame(index);
        check_room(&entity, "room", frame.room)?;
        if let Some(at) = frame.at {
            check_point(&entity, "at", at)?;
        }
        require(ZOOM.contains(&frame.zoom), &entity, "zoom", || {
            let zoom = shown(frame.zoom);
            format!("{zoom} is outside {}..={}", ZOOM.start(), ZOOM.end())
        })?;
    }
    Ok(())
}

/// Every prompt by itself.
pub(super) fn check_prompts(level: &Level) -> Result<(), Flaw> {
    let prompts = level.prompts.iter().enumerate();
    let mut rooms = prompts.map(|(index, prompt)| (Entity::Prompt(index), prompt.room));
    rooms.try_for_each(|(entity, room)| check_room(&entity, "room", room))
}

/// The corners are in bounds and the right way around.
fn check_room(entity: &Entity, field: &str, room: Rect) -> Result<(), Flaw> {
    check_point(entity, &format!("{field}.min"), room.min)?;
    check_point(entity, &format!("{field}.max"), room.max)?;
    require(room.min.cmplt(room.max).all(), entity, field, || {
        "min is not below and left of max".into()
    })
}
