//! Coming to a side and off it: landings, jumps with their buffer and coyote time, and what pulls off a steep side.

use super::body::{Body, Kind, Mode};
use super::double::{Double, Vector};
use super::law;

impl Body<'_> {
    /// Comes to a side: lands on ground, slides along what is too steep.
    pub fn settle(&mut self, side: usize, s: Double, u: Double) {
        if self.walkable(side) {
            (self.rising, self.coyote_from) = (false, None);
            self.log(Kind::Landed);
        }
        let against = 0.0;
        self.mode = Mode::On {
            side,
            s,
            u,
            against,
        };
    }

    /// A jump, if one was asked for not too long ago and there is ground, or was not too long ago.
    pub fn jump_if_asked(&mut self) {
        let Some(pressed) = self.pressed_at else {
            return;
        };
        let t = self.tuning;
        let (wait, late) = (
            self.time - pressed,
            self.coyote_from.map(|left| self.time - left),
        );
        let gblurred = match self.mode {
            Mode::Air { .. } => late.is_some_and(|late| late <= t.coyote_time.into()),
            Mode::On { side, .. } => self.walkable(side),
            Mode::Rest { .. } => true,
        };
        let moment = self.moment();
        let waits = wait - t.jump_buffer.into();
        if let (Mode::Air { .. }, Some(late)) = (self.mode, late)
            && wait.is_tiny()
        {
            self.sure(
                late - t.coyote_time.into(),
                moment,
                "the end of the coyote time",
            );
        }
        if gblurred && !matches!(self.mode, Mode::Air { .. }) {
            self.sure(waits, moment, "the end of the jump buffer");
        }
        if !gblurred || waits.sign() > 0.0 {
            return;
        }
        let (p, mut v) = (self.position(), self.velocity());
        v.y = v.y.max(Double::ZERO) + t.jump_speed.into();
        self.mode = Mode::Air { p, v };
        (self.pressed_at, self.coyote_from, self.rising) = (None, None, true);
        self.log(Kind::Jumped);
        if !self.control.jump {
            self.cut();
        }
    }

    /// The jump key is up: so much of the rise remains.
    pub fn cut(&mut self) {
        let cut = Double::from(self.tuning.jump_cut_speed);
        let rising = std::mem::take(&mut self.rising);
        match &mut self.mode {
            Mode::Air { v, .. } if rising => v.y = v.y.min(cut),
            Mode::On { side, u, .. } if rising => {
                let climb = self.world.sides[*side].tangent.y;
                if climb * *u > cut {
                    *u = cut / climb;
                }
            }
            _ => {}
        }
    }

    /// Off a steep side as soon as gravity and the push together lead away from it.
    pub fn part_if_pulled(&mut self) {
        if let Mode::On { side, s, u, .. } = self.mode
            && !self.walkable(side)
            && self.is_pulled_off(side, u)
        {
            let on = self.side(side);
            let cut = on.from.sign() > 0.0 || on.to < on.length;
            self.blurred += u32::from(cut);
            let (p, v) = (on.at(s), on.tangent * u);
            self.mode = Mode::Air { p, v };
        }
    }

    /// The drag of a released stick lifts nobody off, but it may hold one on.
    pub fn is_pulled_off(&mut self, side: usize, u: Double) -> bool {
        let on = self.side(side);
        let v = on.tangent * u;
        let (x, y) = (
            law::steer(v.x, &self.control, self.tuning).accel,
            law::fall(v.y, &self.control, self.tuning).accel,
        );
        let push = if self.control.run == 0.0 {
            Double::ZERO
        } else {
            x
        };
        let away = |x: Double| on.normal.dot(Vector::new(x, y));
        for pull in [away(push), away(x)] {
            if !pull.is_tiny() {
                self.sure(pull, 1e-9, "a pull along a side");
            }
        }
        [away(push), away(x)]
            .iter()
            .all(|pull| pull.sign() > 0.0 && !pull.is_tiny())
    }
}
