//! What the figure is moved by, out of what there is to see of a moment; and what he may want to look at.

use super::stage::Stage;
use super::world::{HERO, World};
use super::{Stance, View};
use crate::anim::{Moves, Support};
use crate::level::Kind;
use crate::motion::Grip;
use glam::DVec2;

/// How near something must be for a look, m.
const NEAR: f64 = 7.0;

impl View {
    /// What the figure is moved by; `look` is where the player asks to look, -1 (down) to 1 (up), `sight` what is nearby.
    pub fn moves(&self, look: f64, sight: Option<DVec2>) -> Moves {
        Moves {
            time: self.time,
            foot: self.position,
            velocity: self.velocity,
            carried: self.carried,
            support: match (self.stance, self.grip) {
                (Stance::Air, _) => Support::Air,
                (Stance::Climb, _) => Support::Ladder,
                (Stance::Ground | Stance::Wedge, _) => Support::Ground,
                (Stance::Slide, Grip::None) => Support::Slide,
                (Stance::Slide, Grip::Ledge) => Support::Ledge,
                (Stance::Slide, Grip::Over) => Support::Over,
                (Stance::Slide, Grip::Wall) => Support::Wall,
            },
            normal: self.normal.as_vec2(),
            facing: self.facing as f32,
            crouched: self.crouched,
            left: (self.left_at, self.leap),
            landed: (self.landed_at, self.landed_speed as f32),
            held_at: self.held_at,
            ledge: self.ledge as f32,
            look: look as f32,
            sight,
            deaths: self.deaths,
        }
    }
}

impl World {
    /// Velocity of what carries the hero: of a mover, and of a belt on it.
    pub(super) fn carried(&self) -> DVec2 {
        let (hero, time) = (self.hero(), self.time());
        let movers = &self.lands[HERO].movers;
        let mover = hero.carrier().and_then(|i| movers.get(i as usize));
        let lifted = mover.map_or(DVec2::ZERO, |mover| mover.piece_at(time).velocity(time));
        let belt = match hero.supported() {
            true => self.underfoot().map_or(0.0, |feature| feature.conveyor),
            false => 0.0,
        };
        let along = -hero.normal().perp();
        lifted + along * belt
    }

    /// Height over the foot of the ledge from which he hangs, or onto which he climbs.
    pub(super) fn ledge(&self) -> f64 {
        let hang = self.state.tuning.ledge_hang;
        match self.hero().grip() {
            Grip::Ledge => hang,
            Grip::Over => (self.state.ledge_at - self.hero().position().y).clamp(0.0, hang),
            Grip::None | Grip::Wall => 0.0,
        }
    }
}

/// Places that are worth a look: what kills, what saves, where it ends.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sights {
    /// Boxes by their corners.
    boxes: Vec<(DVec2, DVec2)>,
}

impl Sights {
    /// Those of a stage that stand still.
    pub fn of(stage: &Stage) -> Sights {
        let worth = |kind| matches!(kind, Kind::Hazard | Kind::Checkpoint | Kind::Goal);
        let bounds = |outline: &[DVec2]| {
            let start = (DVec2::INFINITY, DVec2::NEG_INFINITY);
            let grow = |(min, max): (DVec2, DVec2), p: &DVec2| (min.min(*p), max.max(*p));
            outline.iter().fold(start, grow)
        };
        let still = |id| stage.mover_of(id).is_none();
        let features = stage.features();
        let features = features.filter(|&(id, f)| worth(f.kind) && still(id));
        Sights {
            boxes: features.map(|(_, f)| bounds(&f.outline)).collect(),
        }
    }

    /// The nearest one to a place, if any is near.
    pub fn near(&self, from: DVec2) -> Option<DVec2> {
        let nearest = self.boxes.iter().map(|&(min, max)| from.clamp(min, max));
        let found = nearest.min_by(|a, b| {
            let (a, b) = (a.distance_squared(from), b.distance_squared(from));
            a.total_cmp(&b)
        });
        found.filter(|at| at.distance_squared(from) < NEAR * NEAR)
    }
}
