//! A way through a level as data: what to hold, until when. So a run can be recorded anew when the feel has changed.

#![allow(dead_code, reason = "each test uses its own part")]

use edgewalker::game::{Input, Stage, Stance, View, World};
use edgewalker::tune::Tuning;
use serde::Deserialize;
use std::sync::Arc;

/// One thing that the player does.
#[derive(Debug, Deserialize)]
pub struct Part {
    /// What it is.
    what: String,
    /// What is held.
    #[serde(default)]
    hold: Input,
    /// Until when.
    until: Until,
}

/// When a part is over.
#[derive(Clone, Copy, Debug, Deserialize)]
enum Until {
    /// The foot is further to the right than this, m.
    RightOf(f64),
    /// The foot is further to the left.
    LeftOf(f64),
    /// The foot is higher.
    Above(f64),
    /// The foot is lower.
    Below(f64),
    /// So many seconds have passed.
    Seconds(f64),
    /// The hero stands on the ground.
    Grounded,
    /// He stands on it and does not move.
    Still,
    /// He hangs on a wall or holds something.
    OnWall,
    /// He falls.
    Falling,
    /// A mover is this far (x, y) from where it was drawn, to 5 cm.
    Mover(usize, f64, f64),
    /// He has died: the only part in which he may.
    Died,
    /// The level is won.
    Won,
}

/// Seconds that one part may take.
const LONGEST: f64 = 15.0;

impl Until {
    fn is_over(self, world: &World, begin: &View) -> bool {
        let View {
            time,
            position,
            velocity,
            stance,
            won_at,
            deaths,
            ..
        } = world.view();
        let grounded = matches!(stance, Stance::Ground | Stance::Wedge);
        match self {
            Until::RightOf(x) => position.x > x,
            Until::LeftOf(x) => position.x < x,
            Until::Above(y) => position.y > y,
            Until::Below(y) => position.y < y,
            Until::Seconds(s) => time - begin.time >= s,
            Until::Grounded => grounded,
            Until::Still => grounded && velocity.length() == 0.0,
            Until::OnWall => matches!(stance, Stance::Slide | Stance::Climb),
            Until::Falling => stance == Stance::Air && velocity.y < 0.0,
            Until::Mover(index, x, y) => {
                let offset = world
                    .offsets_at(time)
                    .nth(index)
                    .expect("a mover of the level");
                (offset - glam::DVec2::new(x, y)).abs().max_element() < 0.05
            }
            Until::Died => deaths > begin.deaths,
            Until::Won => won_at.is_some(),
        }
    }
}

/// Goes a way; the inputs of every tick, or where it went wrong.
pub fn go(
    text: &str,
    stage: &Arc<Stage>,
    tuning: &Tuning,
    rate: u32,
) -> Result<Vec<Input>, String> {
    let way: Vec<Part> = ron::from_str(text).map_err(|e| e.to_string())?;
    let mut world = World::new(Arc::clone(stage), rate, 0);
    let mut held = Vec::new();
    for Part { what, hold, until } in way {
        let begin = world.view();
        loop {
            world.step(hold, tuning);
            held.push(hold);
            let View {
                time,
                position,
                stance,
                deaths,
                ..
            } = world.view();
            if until.is_over(&world, &begin) {
                println!(
                    "{time:8.3} s  {:8.3} {:8.3}  {stance:?}  {what}",
                    position.x, position.y
                );
                break;
            }
            if time > begin.time + LONGEST || deaths > begin.deaths {
                return Err(format!(
                    "{what}: {stance:?} at {position}, {time:.2} s, {deaths} deaths"
                ));
            }
        }
    }
    Ok(held)
}
