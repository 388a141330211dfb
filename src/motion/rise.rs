//! The rise of a jump: what it takes from what it leaves, and how it ends when the key is let go.
//!
//! A jump takes the velocity of what carries the body, its fall excepted, or as `lift_jump` says. Seen from there it rises like one
//! from the ground: let go of, it is braked by `jump_cut_brake` to `jump_cut_speed` over that, at a rate and not at once, so that
//! the height of a jump depends continuously on how long the key is held. A tap brakes no earlier than lets it rise
//! `jump_least`: that is a speed, too, at which the brake begins. One who pressed and let go before he landed has held the
//! key for as long as he had held it then.

use super::body::{Body, EventKind, Mode, Next, Trace};
use super::law::Cut;
use super::terrain::Terrain;
use crate::tune::Motion;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The rise of a jump.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rise {
    /// The vertical speed that the jump took from what it left, m/s.
    pub base: f64,
    /// The speed over that with which it began, m/s.
    pub speed: f64,
    /// The key has been let go of.
    pub cut: bool,
    /// When it counts as let go of, if it was before the jump, s.
    pub cut_at: Option<f64>,
}

impl Rise {
    /// The numbers that it is made of, 0 for a time that it does not have.
    pub(super) fn numbers(&self) -> [f64; 3] {
        [self.base, self.speed, self.cut_at.unwrap_or(0.0)]
    }

    /// The speed over the base at which the brake begins, for a jump let go of at its start: so that it rises as high as the
    /// least one.
    fn begins(&self, t: &Motion) -> f64 {
        let (brake, cut) = (t.jump_cut_brake, t.jump_cut_speed);
        if brake <= t.gravity || t.gravity == 0.0 || self.speed <= cut {
            return f64::INFINITY;
        }
        // With u the speed there: (speed^2 - u^2) / 2g before, (u^2 - cut^2) / 2 brake + cut^2 / 2g from there on.
        let halves = [t.gravity, brake].map(|a| 0.5 / a);
        let squares = self.speed * self.speed + cut * cut;
        let square = halves[0] * squares - halves[1] * cut * cut - t.jump_least;
        (square / (halves[0] - halves[1])).max(cut * cut).sqrt()
    }

    /// What it makes of the fall, if it is cut; `base`: the speed from which it counts.
    fn brakes(&self, base: f64, t: &Motion) -> Option<Cut> {
        self.cut.then(|| Cut {
            from: base + self.begins(t),
            to: base + t.jump_cut_speed,
            brake: t.jump_cut_brake,
        })
    }
}

impl Body {
    /// What a jump takes of the velocity of what carries the body: that which it has, or had a moment ago.
    fn taken(&self, terrain: &Terrain) -> DVec2 {
        let has = self.frame_piece().velocity(self.time) + self.remembered(terrain);
        match terrain.tuning.lift_jump {
            1.0 => has,
            2.0 => DVec2::ZERO,
            _ => DVec2::new(has.x, has.y.max(0.0)),
        }
    }

    /// The velocity of a jump in the frame of what carries the body, from one over what it takes of that. It never leads into that.
    pub(super) fn leap(&self, v: DVec2, away: f64, terrain: &Terrain) -> DVec2 {
        if self.frame.is_none() {
            return v;
        }
        let carried = self.frame_piece().velocity(self.time);
        let leap = v + (self.taken(terrain) - carried);
        match away {
            0.0 => DVec2::new(leap.x, leap.y.max(0.0)),
            away => DVec2::new((leap.x * away).max(0.0) * away, leap.y),
        }
    }

    /// In the rise of a jump that has just begun, `base` taken from what it left.
    pub(super) fn rise(&mut self, terrain: &Terrain) {
        let base = self.frame.map_or(0.0, |_| self.taken(terrain).y);
        let speed = self.velocity().y - base;
        // A buffered jump whose key is up again has been held as long as then.
        let held = self
            .released_at
            .zip(self.pressed_at)
            .map(|(up, down)| up - down);
        let cut_at = match self.control.jump {
            true => None,
            false => Some(self.time + held.map_or(0.0, |held| held.max(0.0))),
        };
        self.rise = Some(Rise {
            base,
            speed,
            cut: false,
            cut_at,
        });
        (self.pressed_at, self.coyote_from, self.off_wall) = (None, None, None);
    }

    /// The key is let go of: what remains of the rise is braked from now on.
    pub(super) fn cut_jump(&mut self) {
        if let Some(rise) = self.rise.as_mut().filter(|rise| rise.cut_at.is_none()) {
            rise.cut = true;
        }
    }

    /// The time at which a buffered jump counts as let go of, if that comes first.
    pub(super) fn sooner_if_cut(&self, next: Option<(f64, Next)>) -> Option<(f64, Next)> {
        let at = self.rise.and_then(|rise| rise.cut_at);
        Next::sooner(next, at.map(|at| (at, Next::Cut)))
    }

    /// From now on it does.
    pub(super) fn come_to_cut(&mut self, trace: &mut Trace) {
        self.rebase();
        if let Some(rise) = &mut self.rise {
            (rise.cut, rise.cut_at) = (true, None);
        }
        self.log(EventKind::Limit, trace);
    }

    /// The brake of a jump let go of, for speeds in the frame of what carries the body, while it rises faster than that leaves it. Along
    /// what moves the rise counts from that.
    pub(super) fn braked_rise(&mut self, t: &Motion) -> Option<Cut> {
        let rise = self.rise.filter(|rise| rise.cut)?;
        let cut = self.cut_of(&rise, 0.0, t)?;
        let climbs = match &self.mode {
            Mode::Air(air) => air.v0.y,
            Mode::Surface(on) => on.u0 * on.track.tangent.y,
            Mode::Wedge(_) | Mode::Crushed(_) => f64::NEG_INFINITY,
        };
        if climbs <= cut.to {
            self.rise = None;
            return None;
        }
        Some(cut)
    }

    /// The same for speeds in the world, as far as it is known.
    pub(super) fn rise_in_world(&self, carried: DVec2, t: &Motion) -> Option<Cut> {
        let rise = self.rise.filter(|rise| rise.cut)?;
        self.cut_of(&rise, carried.y, t)
    }

    fn cut_of(&self, rise: &Rise, carried: f64, t: &Motion) -> Option<Cut> {
        let base = match self.frame {
            Some(_) => carried,
            None => rise.base,
        };
        rise.brakes(base, t)
    }
}
