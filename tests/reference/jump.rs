//! Coming to a side and off it: landings, jumps with their buffer and coyote time, and what pulls off a steep side.

use super::body::{Body, Kind, Mode, Rise};
use super::double::{Double, Vector};
use super::law;

impl Body<'_> {
    /// Comes to a side: lands on ground, slides along what is too steep.
    pub fn settle(&mut self, side: usize, s: Double, u: Double) {
        if self.walkable(side) {
            (self.rise, self.coyote_from) = (None, None);
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
        // Pressed and let go of before: held for as long as then.
        let cut_at = match (self.control.jump, self.released_at) {
            (false, Some(up)) => Some(self.time + (up - pressed)),
            _ => None,
        };
        self.rise = Some(Rise { speed: v.y, cut_at });
        (self.pressed_at, self.coyote_from) = (None, None);
        self.log(Kind::Jumped);
    }

    /// The jump key is up: from now on the rise is braked.
    pub fn cut(&mut self) {
        if let Some(rise) = &mut self.rise {
            rise.cut_at.get_or_insert(self.time);
        }
    }

    /// How long until a jump let go of before it began counts as let go of.
    pub fn cut_ahead(&self) -> Option<Double> {
        let left = self.rise?.cut_at? - self.time;
        (left.sign() > 0.0 && !left.is_tiny()).then_some(left)
    }

    /// A rise that the brake has done with is over.
    pub fn end_rise(&mut self) {
        let is_cut = self.rise.is_some_and(|r| r.cut_at.is_some()) && self.cut_ahead().is_none();
        let cut = Double::from(self.tuning.jump_cut_speed);
        if is_cut && self.velocity().y <= cut {
            self.rise = None;
        }
    }

    /// Up and down in the air, with the brake of a jump that is let go of: a tap is braked from the speed on from which it just
    /// rises `jump_least`.
    pub fn fall(&self, speed: Double) -> law::Drive {
        let t = self.tuning;
        let drive = law::fall(speed, &self.control, t);
        let Some(rise) = self
            .rise
            .filter(|r| r.cut_at.is_some() && self.cut_ahead().is_none())
        else {
            return drive;
        };
        let [g, brake, cut] = [t.gravity, t.jump_cut_brake, t.jump_cut_speed].map(Double::from);
        let above = |mark: Double| speed > mark && !(speed - mark).is_tiny();
        if brake <= g || rise.speed <= cut || !above(cut) {
            return drive;
        }
        let half = Double::from(0.5);
        let full = (rise.speed * rise.speed + cut * cut) * half / g;
        let lost = cut * cut * half / brake + t.jump_least.into();
        let square = (full - lost) / (half / g - half / brake);
        let from = if square > cut * cut {
            square.sqrt()
        } else {
            cut
        };
        let stop = |drive: law::Drive, mark: Double| law::Drive {
            until: Some(drive.until.map_or(mark, |until| until.max(mark))),
            ..drive
        };
        match above(from) {
            true => stop(drive, from),
            false => law::Drive {
                accel: -brake,
                until: Some(cut),
            },
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
            self.fall(v.y).accel,
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
