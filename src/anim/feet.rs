//! Feet: where they stand they stay, on slopes and stairs too; the legs follow by inverse kinematics.
//!
//! The clips are made for level ground. A foot of theirs that is on it is held where it came down, until it is lifted;
//! what it is held back by is given up in the air. Each foot then goes as high as the ground under it.

use super::rig::Leg;
use glam::{Mat4, Quat, Vec3};

/// Heel and ball of the flat foot before the ankle, m: about these the clips roll it.
const SOLE: [f32; 2] = [-0.055, 0.105];
/// How much higher than the other an end must be for the sole to turn about the other alone, m.
const SOLE_TILT: f32 = 0.04;
/// How far the clips may have a sole in the ground, m: it gives, and nobody sees it.
const SINKS_IN: f32 = 0.015;
/// Heights of the sole at which a foot comes down, and at which it is lifted, m.
const DOWN: f32 = 0.010;
const LIFTED: f32 = 0.022;
/// How much lower heel or ball must be than the other to become what the foot stands on, m.
const ROLLS_OVER: f32 = 0.006;
/// A foot that would be held back further than this slips, m.
const SLIPS: f32 = 0.26;
/// How fast it is given up in the air what a foot was held back by, 1/s.
const GIVES_UP: f32 = 16.0;
/// Who stands with his feet further than this from where they belong takes a small step, m; its time, s, and height, m.
const UNEASY: f32 = 0.05;
const STEP_TIME: f32 = 0.2;
const STEP_HEIGHT: f32 = 0.05;
/// Changes of the ground's height within a tick that are more than its slope, m, and how fast the foot takes them, 1/s.
const EDGE: f32 = 0.03;
const TAKES_EDGE: f32 = 28.0;
/// How far above and below the foot's level the ground is looked for, m.
const REACH: f64 = 0.75;
/// A foot in the air that is lower than this will carry weight soon, m.
const LOADS_BELOW: f32 = 0.12;
/// A foot this high does not rise and fall with the ground, m.
const FREE_ABOVE: f32 = 0.35;
/// A sole this high no longer turns with the slope, m.
const TURNS_BELOW: f32 = 0.14;

/// Where the ground is.
pub trait Ground {
    /// The height of the highest ground at `x` between `low` and `high`, and its rise over run there.
    fn under(&self, x: f64, high: f64, low: f64) -> Option<(f64, f32)>;

    /// The left and the right end of the ladder at a place, at that height.
    fn ladder(&self, _x: f64, _y: f64) -> Option<(f64, f64)> {
        None
    }
}

/// One foot, from moment to moment. All places are in the level's axes, about the body's foot.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Foot {
    /// Where it stands, and on which end of the sole; `None` in the air.
    stands: Option<(Vec3, usize)>,
    /// It slipped, and is not held until it is lifted.
    slipped: bool,
    /// Where heel and ball were put.
    soles: [Vec3; 2],
    /// How far it is from where the clips have it.
    shift: Vec3,
    /// When a small step began, counting down, s; and the shift then.
    steps: Option<(f32, Vec3)>,
    /// Height of the ground under it, and how much of a sudden change it has not yet taken.
    height: f32,
    edge: f32,
    slope: f32,
    x: f32,
}

/// What moves a foot at a moment.
#[derive(Clone, Copy)]
pub struct Step<'a> {
    /// Seconds since the last.
    pub span: f32,
    /// How far the body came since then, beside the ground itself.
    pub moved: Vec3,
    /// Whether feet carry it, and whether they are to stay where they are.
    pub stands: bool,
    /// Whether there is ground to look for.
    pub on_ground: bool,
    /// Whether it stands still.
    pub rests: bool,
    /// Where the ground is, and the body's foot in the level.
    pub ground: &'a dyn Ground,
    /// The body's foot in the level, m.
    pub foot: glam::DVec2,
    /// 0 in the air to 1 on the ground.
    pub weight: f32,
    /// Rise over run of the ground under the body.
    pub slope: f32,
    /// How far a foot that the clips still have in the air is brought down to the ground after a landing, 0 to 1.
    pub lands: f32,
}

/// Where a foot shall be: its ankle, its turn, and how high the sole was in the clips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goal {
    /// In the level's axes, about the body's foot, m.
    pub ankle: Vec3,
    /// By the slope, after the clips' own.
    pub tilt: Quat,
    /// How high the sole is in the clips, m.
    pub low: f32,
    /// How much weight it carries or is about to, 0 to 1.
    pub load: f32,
}

impl Foot {
    /// The next moment of a foot whose bone is `placed` by the clips; where it shall be.
    pub fn follow(&mut self, placed: &Mat4, leg: &Leg, step: &Step, other_steps: bool) -> Goal {
        let ends = SOLE.map(|x| placed.transform_point3(Vec3::new(x, -leg.ankle, 0.0)));
        let low = ends[0].y.min(ends[1].y);
        // Whatever comes together in a pose, no foot goes into the ground, and who has landed has one on it.
        let raised = match low < 0.0 {
            true => (-low - SINKS_IN).max(0.0) * step.weight,
            false => -low * step.lands,
        };
        let ends = ends.map(|end| end + Vec3::Y * raised);
        let low = low + raised;
        self.soles.iter_mut().for_each(|sole| *sole -= step.moved);
        self.hold(&ends, low, step);
        self.take_small_step(step, other_steps);
        // The sole turns about what it stands on; in the air that goes over from one end to the other.
        let to_ball = ((ends[0].y - ends[1].y) / SOLE_TILT * 0.5 + 0.5).clamp(0.0, 1.0);
        let pivot = match self.stands {
            Some((_, end)) => ends[end],
            None => ends[0].lerp(ends[1], to_ball),
        };
        if step.on_ground {
            self.find_ground(pivot.x + self.shift.x, step);
        }
        let lift = match self.steps {
            Some((left, _)) => STEP_HEIGHT * (std::f32::consts::PI * left / STEP_TIME).sin(),
            None => 0.0,
        };
        let turns = (1.0 - (low + lift) / TURNS_BELOW).clamp(0.0, 1.0) * step.weight;
        let tilt = Quat::from_rotation_z(self.slope.atan() * turns);
        // A foot that is high above the ground has no part in it.
        let near = (1.0 - low / FREE_ABOVE).clamp(0.0, 1.0);
        let near = near * near * (3.0 - 2.0 * near);
        let height = (self.height + self.edge) * step.weight * near + lift;
        let put = |p: Vec3| pivot + tilt * (p - pivot) + self.shift.with_y(height);
        self.soles = ends.map(put);
        Goal {
            ankle: put(placed.transform_point3(Vec3::ZERO) + Vec3::Y * raised),
            tilt,
            low,
            load: match self.stands {
                Some(_) => 1.0,
                None => (1.0 - (low + lift) / LOADS_BELOW).clamp(0.0, 1.0) * step.weight,
            },
        }
    }

    /// The end of the sole that carries: 0 the heel, 1 the ball.
    pub fn stands_on(&self) -> Option<usize> {
        self.stands.map(|(_, end)| end)
    }

    /// Gives up the place where it stands, until it is lifted.
    pub fn let_go(&mut self) {
        if self.stands.take().is_some() {
            self.slipped = true;
        }
    }

    /// Whether it is in the middle of a small step.
    pub fn is_stepping(&self) -> bool {
        self.steps.is_some()
    }

    /// Holds a foot that is down where it came down.
    fn hold(&mut self, ends: &[Vec3; 2], low: f32, step: &Step) {
        if let Some((at, _)) = &mut self.stands {
            *at -= step.moved;
        }
        let lowest = usize::from(ends[1].y < ends[0].y);
        let is_down = step.stands && self.steps.is_none();
        self.stands = match self.stands {
            _ if !is_down || low > LIFTED => None,
            Some((at, end)) if ends[lowest].y > ends[end].y - ROLLS_OVER => Some((at, end)),
            // It rolls from the heel onto the ball: that stays where it now is.
            Some(_) => Some((self.soles[lowest], lowest)),
            None if low < DOWN && !self.slipped => Some((ends[lowest] + self.shift, lowest)),
            None => None,
        };
        if low > LIFTED || !step.stands {
            self.slipped = false;
        }
        if let Some((at, end)) = self.stands {
            let held = at - ends[end];
            self.shift = Vec3::new(held.x, 0.0, held.z);
            if self.shift.length() > SLIPS {
                (self.stands, self.slipped) = (None, true);
            }
        }
        if self.stands.is_none() && self.steps.is_none() {
            self.shift *= (-GIVES_UP * step.span).exp();
        }
    }

    /// One foot after the other goes back to where it belongs.
    fn take_small_step(&mut self, step: &Step, other_steps: bool) {
        if !step.stands {
            self.steps = None;
        }
        match &mut self.steps {
            Some((left, from)) => {
                *left -= step.span;
                let share = (*left / STEP_TIME).clamp(0.0, 1.0);
                self.shift = *from * (share * share * (3.0 - 2.0 * share));
                if *left <= 0.0 {
                    self.steps = None;
                }
            }
            None => {
                let uneasy = step.rests && !other_steps && self.stands.is_some();
                if uneasy && self.shift.length() > UNEASY {
                    (self.steps, self.stands) = (Some((STEP_TIME, self.shift)), None);
                }
            }
        }
    }

    /// The height of the ground where the foot is; an edge is taken in a moment, a slope at once.
    fn find_ground(&mut self, x: f32, step: &Step) {
        let at = step.foot.x + f64::from(x);
        // Uphill the ground before him is higher than his foot, by as much as the slope says.
        let level = step.foot.y + f64::from(step.slope * x);
        let found = step.ground.under(at, level + REACH, level - REACH);
        let (height, slope) = match found {
            Some((height, slope)) => ((height - step.foot.y) as f32, slope),
            None => (step.slope * x, step.slope), // over a brink he stands as if the ground went on
        };
        let passed = x + step.moved.x - self.x;
        let expected = self.height - step.moved.y + self.slope * passed;
        if step.weight > 0.01 && (height - expected).abs() > EDGE + slope.abs() * passed.abs() {
            self.edge += expected - height;
        }
        self.edge *= (-TAKES_EDGE * step.span).exp();
        let turning = 1.0 - (-TAKES_EDGE * step.span).exp();
        self.slope += (slope - self.slope) * if step.weight > 0.01 { turning } else { 1.0 };
        (self.height, self.x) = (height, x);
    }
}
