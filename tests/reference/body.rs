//! A slow, clearly right body: every step asks every side of the boundary, in 32 digits, with no mesh and no memory of faces.
//!
//! It also knows what it cannot know. The motion under test rounds crossings of outlines to the grid, so that within a
//! few steps of a corner, or of a graze, or within a moment of a timer's end, both answers are right: there the reference
//! notes a *doubt*, and the run ends. And where that rounding shifts a body by up to a step, the run is *blurred* from then on.

use super::double::{Double, Vector};
use super::outline::{Side, World};
use edgewalker::geom::STEP;
use edgewalker::motion::Control;
use edgewalker::tune::Motion;

/// Within this distance of a corner or of a graze the outcome is in doubt, m: what rounding may move (half a step), what the
/// motion treats as a joint (two steps) and as the same hit (four), with room to spare.
pub const MARGIN: f64 = 8.0 * STEP;

/// Events closer in time to the end of a tick or to the end of a timer are in doubt, s.
const MOMENT: f64 = 1e-9;

/// What is added to that for each shift of a blurred body, s.
const SHIFT: f64 = 1e-4;

/// So many events without time passing are a cycle.
const CYCLE: u32 = 200;

#[derive(Clone, Copy, Debug)]
pub enum Mode {
    Air {
        p: Vector,
        v: Vector,
    },
    /// On a side, at an arc length, with a speed along its tangent; walled up in a direction (1, -1) or not (0).
    On {
        side: usize,
        s: Double,
        u: Double,
        against: f64,
    },
    /// At rest in a V.
    Rest {
        p: Vector,
    },
}

/// What is compared of the events.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Jumped,
    Left,
    Landed,
}

pub struct Body<'a> {
    pub world: &'a World,
    pub tuning: &'a Motion,
    pub control: Control,
    pub time: Double,
    pub mode: Mode,
    pub pressed_at: Option<Double>,
    pub coyote_from: Option<Double>,
    pub rise: Option<Rise>,
    /// When jump was let go of, since it was pressed.
    pub released_at: Option<Double>,
    /// Down has been held on ground, and since then.
    pub crouched: bool,
    /// Why this run cannot be compared from here on.
    pub doubt: Option<&'static str>,
    /// The same for a time to come, unless something else happens before.
    pub doubtful: Option<(Double, &'static str)>,
    /// How often rounding may have shifted the motion under test, by up to a step: it comes off a cut steep edge where the
    /// pieces of that leave it room, and it meets them, not the edge, if it comes at a small angle or out of a corner.
    pub blurred: u32,
    pub events: Vec<(f64, Kind)>,
}

/// The rise of a jump: its speed at the start, and from when on it is braked.
#[derive(Clone, Copy, Debug)]
pub struct Rise {
    pub speed: Double,
    pub cut_at: Option<Double>,
}

/// What ends a piece.
#[derive(Clone, Copy, Debug)]
pub enum Next {
    /// A speed is reached: of x and y in the air, or along a side.
    Limit([Option<Double>; 2]),
    /// A jump pressed and let go of before it began counts as let go of.
    Cut,
    /// The end of the side, in a direction.
    End(f64),
    /// A side is hit.
    Hit(usize),
}

impl<'a> Body<'a> {
    /// At rest in the air.
    pub fn new(world: &'a World, tuning: &'a Motion, p: Vector) -> Self {
        let v = Vector::default();
        Body {
            world,
            tuning,
            control: Control::default(),
            time: Double::ZERO,
            mode: Mode::Air { p, v },
            pressed_at: None,
            coyote_from: None,
            rise: None,
            released_at: None,
            crouched: false,
            doubt: None,
            doubtful: None,
            blurred: 0,
            events: Vec::new(),
        }
    }

    pub fn side(&self, side: usize) -> &'a Side {
        &self.world.sides[side]
    }

    pub fn walkable(&self, side: usize) -> bool {
        self.side(side).walkable(self.tuning.max_slope)
    }

    pub fn position(&self) -> Vector {
        match self.mode {
            Mode::Air { p, .. } | Mode::Rest { p } => p,
            Mode::On { side, s, .. } => self.side(side).at(s),
        }
    }

    pub fn velocity(&self) -> Vector {
        match self.mode {
            Mode::Air { v, .. } => v,
            Mode::Rest { .. } => Vector::default(),
            Mode::On { side, u, .. } => self.side(side).tangent * u,
        }
    }

    pub fn doubt(&mut self, why: &'static str) {
        self.doubt.get_or_insert(why);
    }

    /// Notes a doubt if a quantity that decides something by its sign is too near zero.
    pub fn sure(&mut self, quantity: Double, margin: f64, why: &'static str) {
        if quantity.abs().to_f64() < margin {
            self.doubt(why);
        }
    }

    pub fn log(&mut self, kind: Kind) {
        self.events.push((self.time.to_f64(), kind));
    }

    /// Takes a control.
    pub fn apply(&mut self, control: Control) {
        let before = std::mem::replace(&mut self.control, control);
        if control.jump && !before.jump {
            (self.pressed_at, self.released_at) = (Some(self.time), None);
        }
        if before.jump && !control.jump {
            self.released_at = Some(self.time);
            self.cut();
        }
    }

    /// Moves up to a time.
    pub fn advance(&mut self, to: f64) {
        let to = Double::from(to);
        let (start, mut still) = (self.time, 0);
        while self.doubt.is_none() && still < CYCLE {
            self.take_up_wishes();
            let next = self.next();
            let left = to - self.time;
            self.note_doubts(next, start, to);
            let Some((dt, what)) = next.filter(|&(dt, _)| dt <= left) else {
                self.flow(left);
                self.time = to;
                return;
            };
            still = if dt.is_tiny() { still + 1 } else { 0 };
            self.flow(dt);
            self.happen(what);
        }
        self.doubt("a cycle of events");
    }

    /// What the will and the pulls of now change at once.
    fn take_up_wishes(&mut self) {
        let stands = matches!(self.mode, Mode::On { side, .. } if self.walkable(side));
        self.crouched = self.control.down && (stands || self.crouched);
        self.jump_if_asked();
        self.part_if_pulled();
        self.jump_if_asked();
        self.end_rise();
    }

    /// Notes a doubt about the flight up to the next event, and if that is hardly before or after an end of the tick: then the
    /// two may have taken it under different controls.
    fn note_doubts(&mut self, next: Option<(Double, Next)>, start: Double, to: Double) {
        let left = to - self.time;
        let dt = next.map_or(left, |(dt, _)| dt);
        if let Some((at, why)) = self.doubtful.take()
            && at <= self.time + dt.min(left)
        {
            self.doubt(why);
        }
        if let Some((dt, Next::End(_) | Next::Hit(_))) = next {
            let (before, after) = (left - dt, self.time + dt - start);
            let near = |span: Double| span.abs().to_f64() < self.moment();
            if near(before) || near(after) && !after.is_tiny() {
                self.doubt("an event at the end of a tick");
            }
        }
    }

    pub fn moment(&self) -> f64 {
        MOMENT + SHIFT * f64::from(self.blurred)
    }

    /// Lets time pass under the accelerations of now.
    fn flow(&mut self, dt: Double) {
        let half = dt * dt * 0.5.into();
        let accel = self.acceleration();
        match &mut self.mode {
            Mode::Air { p, v } => {
                *p = *p + *v * dt + accel * half;
                *v = *v + accel * dt;
            }
            Mode::On { side, s, u, .. } => {
                let along = self.world.sides[*side].tangent.dot(accel);
                *s = *s + *u * dt + along * half;
                *u = *u + along * dt;
            }
            Mode::Rest { .. } => {}
        }
        self.time = self.time + dt;
    }

    /// An event takes place.
    fn happen(&mut self, what: Next) {
        match (what, &mut self.mode) {
            (Next::Limit([x, y]), Mode::Air { v, .. }) => {
                (v.x, v.y) = (x.unwrap_or(v.x), y.unwrap_or(v.y));
            }
            (Next::Limit([Some(mark), _]), Mode::On { u, against, .. }) => {
                (*u, *against) = (mark, 0.0);
            }
            (Next::End(direction), Mode::On { .. }) => self.corner(direction),
            (Next::Hit(side), Mode::Air { .. }) => self.hit(side),
            _ => {}
        }
    }
}
