//! What a body does, as far as it can be seen: all that the figure is moved by.

use glam::{DVec2, Vec2};
use serde::{Deserialize, Serialize};

/// What carries a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// Nothing.
    Air,
    /// Walkable ground.
    Ground,
    /// A wall or a steep slope that it slides along.
    Slide,
    /// A ledge from which it hangs.
    Ledge,
    /// The same ledge, while it climbs onto it.
    Over,
    /// A wall that can be climbed.
    Wall,
    /// A ladder.
    Ladder,
}

/// How a body came into the air.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Leap {
    /// It walked off an edge, or what carried it went away.
    #[default]
    Walked,
    /// It jumped off the ground.
    Jumped,
    /// It jumped off a wall.
    OffWall,
}

/// What a body does at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moves {
    /// Seconds.
    pub time: f64,
    /// Place of the foot in the level, m.
    pub foot: DVec2,
    /// Metres per second.
    pub velocity: DVec2,
    /// Velocity of the ground or wall itself: of a lift, of a belt.
    pub carried: DVec2,
    /// What carries it.
    pub support: Support,
    /// Normal of the ground or wall in contact; zero in the air.
    pub normal: Vec2,
    /// -1 left, 1 right.
    pub facing: f32,
    /// In the smaller size.
    pub crouched: bool,
    /// Time of the last take-off, and how that was.
    pub left: (f64, Leap),
    /// Time of the last landing, and the speed into the ground then.
    pub landed: (f64, f32),
    /// When the ledge, ladder or wall was taken hold of that it holds on to, or the climb onto the ledge began.
    pub held_at: f64,
    /// Height of the ledge that it hangs from above the foot, m.
    pub ledge: f32,
    /// Where the player asks to look, from -1 (down) to 1 (up).
    pub look: f32,
    /// Something nearby that is worth a look.
    pub sight: Option<DVec2>,
    /// How often it has died: each time it begins anew elsewhere.
    pub deaths: u32,
}

impl Moves {
    /// At rest on level ground.
    pub fn standing(foot: DVec2) -> Moves {
        Moves {
            time: 0.0,
            foot,
            velocity: DVec2::ZERO,
            carried: DVec2::ZERO,
            support: Support::Ground,
            normal: Vec2::Y,
            facing: 1.0,
            crouched: false,
            left: (f64::NEG_INFINITY, Leap::Walked),
            landed: (f64::NEG_INFINITY, 0.0),
            held_at: f64::NEG_INFINITY,
            ledge: 0.0,
            look: 0.0,
            sight: None,
            deaths: 0,
        }
    }

    /// Velocity beside the ground or wall in contact.
    pub fn own_velocity(&self) -> DVec2 {
        self.velocity - self.carried
    }

    /// Speed forward, against what carries it; negative backwards.
    pub fn forward(&self) -> f32 {
        self.own_velocity().x as f32 * self.side()
    }

    /// -1 or 1: where the figure looks. On a wall it is turned to the wall.
    pub fn side(&self) -> f32 {
        let at_wall = match self.support {
            Support::Slide | Support::Ledge | Support::Over | Support::Wall => -self.normal.x,
            Support::Air | Support::Ground | Support::Ladder => 0.0,
        };
        match at_wall.abs() > 0.3 {
            true => at_wall.signum(),
            false if self.facing < 0.0 => -1.0,
            false => 1.0,
        }
    }

    /// Rise over run of the ground; level on walls and in the air.
    pub fn slope(&self) -> f32 {
        let grounded = self.support == Support::Ground && self.normal.y > 0.3;
        match grounded {
            true => -self.normal.x / self.normal.y,
            false => 0.0,
        }
    }

    /// The moment at a share (0 to 1) of the way from another; all but time and place is as it was then:
    /// what changes in between changes at an event.
    pub fn since(&self, before: &Moves, share: f64) -> Moves {
        Moves {
            time: before.time + (self.time - before.time) * share,
            foot: before.foot.lerp(self.foot, share),
            ..*before
        }
    }
}
