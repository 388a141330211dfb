//! What happens to a body, as values: each with its time within the tick.

use super::body::Size;
use super::mover::Piece;
use crate::mesh::FeatureId;
use serde::{Deserialize, Serialize};

/// Something that happened to a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Event {
    /// Simulated time, within the tick, s.
    pub time: f64,
    /// What.
    pub kind: EventKind,
}

/// Kinds of events.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum EventKind {
    /// Took off.
    Jumped,
    /// Walked off the ground.
    Left,
    /// Came to walkable ground, with this speed into it (m/s).
    Landed(f64),
    /// Met a wall, a ceiling or too steep a slope, with this speed into it (m/s).
    Hit(f64),
    /// Came off a wall or a steep slope.
    Parted,
    /// Walked round a bend.
    Joint,
    /// Walked against a wall, with this speed (m/s).
    Stopped(f64),
    /// Was wedged.
    Wedged,
    /// Changed size.
    Resized(Size),
    /// Reached the speed that it was accelerating to, or a change of gravity.
    Limit,
    /// Took off from a wall.
    WallJumped,
    /// Let itself fall through a one-way.
    Dropped,
    /// Was set down onto ground this far below the end of the old one (m).
    Snapped(f64),
    /// Stepped up onto ground this much higher (m).
    SteppedUp(f64),
    /// Was moved this far round a corner that it barely struck (m).
    Corrected(f64),
    /// Took hold of a ledge.
    Grabbed,
    /// Took hold of a ladder or of a wall that can be climbed.
    Climbed,
    /// Let go of what it held.
    LetGo,
    /// Came from one frame to another without leaving the ground: onto a moving solid, or onto the level (`None`).
    Boarded(Option<u32>),
    /// Has come to stand on a moving solid, or holds on to it, that minds it.
    Mounted(u32),
    /// Is on it no longer.
    Dismounted(u32),
    /// Is pushed by a moving solid from now on.
    Pushed(u32),
    /// Was crushed between a moving solid and something else.
    Crushed,
    /// Was found inside a solid that has just been put there, and moved this far out of it (m).
    Embedded(f64),
    /// Came into a region.
    Entered(FeatureId),
    /// Came out of a region.
    Exited(FeatureId),
    /// What carries or pushes it began another piece of its path.
    Node(u32),
    /// The time is over for which a wall jump holds the direction.
    Unlocked,
    /// Was held where it is because its events did not end: a defect of this code, kept from hanging the game.
    Stuck,
}

/// What happened in a step: the events, and the counts that bound its work.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// In order of time.
    pub events: Vec<Event>,
    /// Free edges crossed in the air.
    pub crossed: u64,
    /// Vertices reached on surfaces.
    pub passed: u64,
    /// Edges met and nodes passed in the frames of moving solids.
    pub touched: u64,
    /// The motions that came to an end in the step, in order of time.
    pub ways: Vec<Way>,
}

/// A motion that a body has had: in closed form, up to a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// In the world, whatever carried the body.
    pub piece: Piece,
    /// When it came to its end, s.
    pub until: f64,
}

impl Trace {
    /// Forgets everything; keeps the memory.
    pub fn clear(&mut self) {
        self.events.clear();
        self.ways.clear();
        (self.crossed, self.passed, self.touched) = (0, 0, 0);
    }

    /// Forgets all but the events after so many of them.
    pub fn forget(&mut self, told: usize) {
        self.events.drain(..told.min(self.events.len()));
        self.ways.clear();
        (self.crossed, self.passed, self.touched) = (0, 0, 0);
    }

    /// A body's motion comes to an end, or may: what goes on as it was is one motion.
    pub(super) fn ends(&mut self, way: Way) {
        match self.ways.last_mut() {
            Some(last) if last.piece == way.piece => last.until = way.until,
            _ => self.ways.push(way),
        }
    }
}
