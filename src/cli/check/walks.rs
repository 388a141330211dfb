//! The part of the check that plays at random.

use super::{Case, Plan, Report};
use crate::cli::walk::{Player, Start, Walk, walk};
use crate::game::{Replay, World};
use glam::DVec2;
use std::sync::Arc;

/// Random play from the start and from every checkpoint.
pub(super) fn check(case: &Case, report: &mut Report) {
    let Case {
        plan,
        stage,
        tuning,
    } = *case;
    let start = Start {
        name: "the start".into(),
        at: stage.level.start,
    };
    let checkpoint = |(feature, offset): (&crate::level::Feature, DVec2)| {
        let name = format!("checkpoint {:?}", feature.id);
        let at = feature.respawn? + offset;
        Some(Start { name, at })
    };
    let still = stage.level.features.iter().map(|f| (f, DVec2::ZERO));
    let movers = stage.level.movers.iter();
    let moving = movers.flat_map(|m| m.features.iter().map(move |f| (f, m.parked())));
    let checkpoints = still.chain(moving).filter_map(checkpoint);
    let starts: Vec<Start> = std::iter::once(start).chain(checkpoints).collect();
    let walks = starts.len() as u64;
    let Plan {
        ticks,
        tick_rate,
        seed,
        ..
    } = *plan;
    report.done(format!(
        "walks     {walks}, together {ticks} ticks at {tick_rate} Hz, seed {seed}"
    ));
    for (number, start) in (0..).zip(&starts) {
        // What is left over goes to the first walks.
        let share = ticks / walks + u64::from(number < ticks % walks);
        let mut player = Player::new(seed.wrapping_add(number));
        let level = plan.level.to_string_lossy();
        let mut replay = Replay::new(&level, stage, tick_rate, seed, tuning);
        replay.start = (number > 0).then_some(start.at);
        let world = match replay.world(Arc::clone(stage)) {
            Ok(world) => world,
            Err(error) => {
                report.wrong(format!("{}: {error}", start.name));
                continue;
            }
        };
        let Walk { replay, fault } = walk(world, share, replay, &mut player, World::check);
        if let Some(fault) = fault {
            report.wrong(format!("from {}: {fault}", start.name));
            report.replay.get_or_insert(replay);
        }
    }
}
