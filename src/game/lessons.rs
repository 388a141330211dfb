//! What a player has shown that he knows: seen in what his hero does, tick by tick.

use super::{Input, Stance, View};
use crate::anim::Leap;
use crate::level::Skill;
use crate::motion::Grip;

/// Who looks up for so long while he stands has looked up, in s.
const LOOK: f64 = 0.3;

/// What is remembered from tick to tick.
#[derive(Clone, Debug, Default)]
pub struct Lessons {
    before: Option<View>,
    /// Since when he has looked up, in simulated seconds.
    looks_since: Option<f64>,
}

impl Lessons {
    /// Sees a tick: what the hero does now, what is held and where the player asks to look (-1 down to 1 up). Gives what was done in
    /// it.
    pub fn watch(&mut self, view: &View, input: Input, look: f64) -> Option<Skill> {
        let before = self.before.replace(*view)?;
        let stands = view.stance == Stance::Ground && view.velocity.x == 0.0;
        self.looks_since = match stands && look > 0.5 {
            true => self.looks_since.or(Some(view.time)),
            false => None,
        };
        let has_looked = self
            .looks_since
            .is_some_and(|since| view.time - since >= LOOK);
        let leaves = before.stance == Stance::Ground && view.stance == Stance::Air;
        let drops = leaves && view.leap == Leap::Walked && input.down && input.jump;
        let kicks = view.leap == Leap::OffWall && view.left_at > before.left_at;
        match view.grip {
            Grip::Over => Some(Skill::Ledge),
            _ if kicks => Some(Skill::WallJump),
            _ if drops => Some(Skill::Drop),
            _ if view.crouched && view.stance == Stance::Ground => Some(Skill::Crouch),
            _ if has_looked => Some(Skill::Look),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn on(stance: Stance) -> View {
        View {
            stance,
            ..View::at(DVec2::ZERO)
        }
    }

    /// What is learnt of a tick that leads from one moment to another.
    fn learnt(from: View, to: View, input: Input) -> Option<Skill> {
        let mut lessons = Lessons::default();
        assert_eq!(lessons.watch(&from, Input::default(), 0.0), None);
        lessons.watch(&to, input, 0.0)
    }

    #[test]
    fn each_skill_is_seen_and_nothing_else_is() {
        let (ground, air) = (on(Stance::Ground), on(Stance::Air));
        let (none, both) = (
            Input::default(),
            Input {
                down: true,
                jump: true,
                ..Input::default()
            },
        );
        assert_eq!(learnt(ground, ground, both), None);
        assert_eq!(learnt(ground, air, none), None, "he fell");
        assert_eq!(learnt(ground, air, both), Some(Skill::Drop));
        let jumped = View {
            leap: Leap::Jumped,
            left_at: 1.0,
            ..air
        };
        assert_eq!(learnt(ground, jumped, both), None, "he jumped");
        let kicked = View {
            leap: Leap::OffWall,
            ..jumped
        };
        assert_eq!(
            learnt(on(Stance::Slide), kicked, none),
            Some(Skill::WallJump)
        );
        assert_eq!(learnt(kicked, kicked, none), None, "only once");
        let crouched = View {
            crouched: true,
            ..ground
        };
        assert_eq!(learnt(ground, crouched, none), Some(Skill::Crouch));
        let over = View {
            grip: Grip::Over,
            ..on(Stance::Slide)
        };
        assert_eq!(learnt(on(Stance::Slide), over, none), Some(Skill::Ledge));
    }

    #[test]
    fn who_looks_up_for_a_moment_has_looked() {
        let mut lessons = Lessons::default();
        let mut seen = Vec::new();
        for tick in 0..60 {
            let view = View {
                time: f64::from(tick) / 120.0,
                ..on(Stance::Ground)
            };
            let look = if tick < 10 { 0.0 } else { 1.0 };
            seen.push(lessons.watch(&view, Input::default(), look));
        }
        let first = seen.iter().position(|skill| *skill == Some(Skill::Look));
        assert!(
            first.is_some_and(|tick| (44..=48).contains(&tick)),
            "{first:?}"
        );
    }
}
