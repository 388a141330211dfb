//! A death as it is seen: for a moment the picture stays where the hero was struck, and he goes down. No time passes in the
//! world meanwhile, so a player who holds a key runs nowhere unseen; and whoever presses one goes on at once.

use crate::game::camera::Pose;
use crate::game::{Input, View};

/// How long it lasts, s.
const LASTS: f64 = 0.34;
/// Depth above the level's bottom at which who dies has fallen out of it, m: there is nothing to see.
const FALLEN_OUT: f64 = 3.0;

/// What is shown of a death.
pub struct Fall {
    /// The moment before it.
    pub view: View,
    /// Where that is seen from.
    pub pose: Pose,
    left: f64,
}

impl Fall {
    /// The death between two moments, unless the player asked for it or it was a fall out of the level.
    pub fn seen(before: &View, now: &View, pose: Pose, input: Input, bottom: f64) -> Option<Fall> {
        let asked = input.respawn || input.retry;
        let died = now.deaths > before.deaths && !asked;
        let inside = before.position.y > bottom + FALLEN_OUT;
        (died && inside).then_some(Fall {
            view: *before,
            pose,
            left: LASTS,
        })
    }

    /// Lets time pass, in seconds; whether there is more of it.
    pub fn goes_on(&mut self, seconds: f64) -> bool {
        self.left -= seconds;
        self.left > 0.0
    }
}
