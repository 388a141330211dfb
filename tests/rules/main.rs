//! What events mean: deaths and returns, checkpoints, goals, triggers, areas, each at its own time between two ticks, and
//! the same at every tick rate.

mod areas;
mod begins;
mod events;
mod goals;
mod heights;
mod kept;
mod reload;
mod returns;
mod story;

#[path = "../common/hall.rs"]
mod hall;
