//! How far the figure is beside its body.
//!
//! The body is a box: it stands on a ledge with its outermost corner, climbs a ladder wherever it took hold of it, and goes up
//! a step at once. The figure has two feet, which want ground under them; it climbs in the middle of a ladder, and
//! needs a moment for a step. What is between the two is here, and goes over from one value to the next without a jump.

use super::feet::Ground;
use super::figure::share;
use super::moves::{Moves, Support};
use super::state::{HANGS, Kind, LEDGE, smooth};
use glam::Vec3;

/// How fast a sudden small change of place is taken, 1/s, and the smallest that is, m.
const TAKES_STEP: f32 = 16.0;
const STEP: f64 = 0.02;
/// How fast he finds the place where he stands or climbs, and gives it up again, 1/s.
const FINDS: f32 = 14.0;
const GIVES_UP: f32 = 9.0;
/// How far from a brink he stands, m: both boots are on the ground then, but for a toe.
const INSIDE: f64 = 0.22;
/// How far from the body's foot there may be the ground that it stands on, m: half its width and a little.
const REACH: f64 = 0.45;
/// Ground that is further below the body's foot does not carry it, nor what is higher, m.
const CARRIES: f64 = 0.3;
/// Half of the foot that the body has, m: on a slope its corner touches the ground.
const FOOT: f64 = 0.25;
/// The stride in which the ground is looked for, m, and how often that is halved at the brink.
const STRIDE: f64 = 0.05;
const HALVINGS: u32 = 6;
/// Speeds from which on he goes on in his run rather than to look for ground, and at which he only does, m/s.
const RUNS_PAST: (f32, f32) = (1.0, 4.0);
/// Height of the ledge over his foot from which on he leans in over it while he climbs onto it, m.
const LEANS_IN: f32 = 0.5;
/// Room that he takes on a ladder to either side, m.
const ELBOWS: f64 = 0.6;
/// Height of the middle of the body, m.
const MIDDLE: f64 = 0.85;

/// How far the figure is beside its body, m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Beside {
    /// What is left of a sudden small change of place.
    step: Vec3,
    /// How much lower the clips are played that hang from a ledge.
    ledge: f32,
    /// To the right, towards the ground that carries him or the middle of his ladder.
    footing: f32,
}

impl Beside {
    /// Of one who has been doing this for long.
    pub fn settled(kind: Kind, moves: &Moves, ground: &dyn Ground) -> Beside {
        Beside {
            step: Vec3::ZERO,
            ledge: lowered(kind, moves),
            footing: footing(moves, ground).unwrap_or(0.0),
        }
    }

    /// Goes on to a moment, `span` seconds after another.
    pub fn follow(
        &mut self,
        kind: Kind,
        (before, moves): (&Moves, &Moves),
        span: f32,
        ground: &dyn Ground,
    ) {
        self.ledge += (lowered(kind, moves) - self.ledge) * share(TAKES_STEP, span);
        let (goal, rate) = match footing(moves, ground) {
            Some(goal) => (goal, FINDS),
            None => (0.0, GIVES_UP),
        };
        self.footing += (goal - self.footing) * share(rate, span);
        self.take_steps(before, moves, span);
    }

    /// A change of place that no speed explains (up a step, down a little edge, to a ledge) is shown as a quick move.
    fn take_steps(&mut self, before: &Moves, moves: &Moves, span: f32) {
        let mean = (before.velocity + moves.velocity) * 0.5;
        let beyond = moves.foot - before.foot - mean * f64::from(span);
        let bent = (moves.velocity - before.velocity).length() * f64::from(span);
        let hold = [before.support, moves.support].contains(&Support::Air)
            && moves.support != Support::Ledge;
        if beyond.length() > STEP + bent && !hold {
            self.step -= beyond.as_vec2().extend(0.0);
        }
        self.step *= 1.0 - share(TAKES_STEP, span);
    }

    /// All of it.
    pub fn place(&self) -> Vec3 {
        self.step + Vec3::new(self.footing, self.ledge, 0.0)
    }
}

/// How much lower the clips are played that hang from a ledge: they have it higher than the game, until both are up.
fn lowered(kind: Kind, moves: &Moves) -> f32 {
    let hangs = matches!(kind, Kind::Hang | Kind::ClimbOver);
    match hangs && matches!(moves.support, Support::Ledge | Support::Over) {
        true => moves.ledge * (1.0 - LEDGE / HANGS),
        false => 0.0,
    }
}

/// Where he belongs, from the body's foot to the right; `None` where it is all the same.
fn footing(moves: &Moves, ground: &dyn Ground) -> Option<f32> {
    let brink = Brink { moves, ground };
    match moves.support {
        Support::Ground => {
            let speed = moves.own_velocity().length() as f32;
            let (slow, fast) = RUNS_PAST;
            let stays = 1.0 - smooth((speed - slow) / (fast - slow));
            (stays > 0.0).then(|| brink.stance() as f32 * stays)
        }
        Support::Over => {
            let side = f64::from(moves.side());
            let to = brink.ahead(side, f64::from(moves.ledge))?;
            Some(to as f32 * smooth(1.0 - moves.ledge / LEANS_IN))
        }
        Support::Ladder => {
            let (left, right) = ground.ladder(moves.foot.x, moves.foot.y + MIDDLE)?;
            let elbows = ELBOWS.min((right - left) / 2.0);
            Some((moves.foot.x.clamp(left + elbows, right - elbows) - moves.foot.x) as f32)
        }
        _ => None,
    }
}

/// The end of the ground near a body's foot.
struct Brink<'a> {
    moves: &'a Moves,
    ground: &'a dyn Ground,
}

impl Brink<'_> {
    /// Whether there is ground so far to the right of the foot, about as high as what the body stands on is there, `above` the foot.
    fn carries(&self, dx: f64, above: f64) -> bool {
        let slope = f64::from(self.moves.slope());
        let level = self.moves.foot.y + above + slope * dx - slope.abs() * FOOT;
        let x = self.moves.foot.x + dx;
        self.ground
            .under(x, level + CARRIES, level - CARRIES)
            .is_some()
    }

    /// The end of the ground between a place that has some and one that has none.
    fn end(&self, with: f64, without: f64, above: f64) -> f64 {
        let halve = |(with, without): (f64, f64), _| {
            let middle = (with + without) / 2.0;
            match self.carries(middle, above) {
                true => (middle, without),
                false => (with, middle),
            }
        };
        (0..HALVINGS).fold((with, without), halve).0
    }

    /// The nearest place to the foot where both boots are on the ground, as far as there is one.
    fn stance(&self) -> f64 {
        let lacks = [-1.0, 1.0].map(|side| !self.carries(side * INSIDE, 0.0));
        let end = |with: f64, side: f64| self.end(with, side * INSIDE, 0.0);
        match (lacks, self.carries(0.0, 0.0)) {
            ([false, false], _) => 0.0,
            ([true, true], true) => (end(0.0, -1.0) + end(0.0, 1.0)) / 2.0,
            ([true, true], false) => self.nearest(),
            ([true, false], under) => end(if under { 0.0 } else { INSIDE }, -1.0) + INSIDE,
            ([false, true], under) => end(if under { 0.0 } else { -INSIDE }, 1.0) - INSIDE,
        }
    }

    /// Where he stands if the ground is to one side only.
    fn nearest(&self) -> f64 {
        let sides = [-1.0, 1.0].map(|side| self.ahead(side, 0.0));
        let found = sides.into_iter().flatten();
        found
            .min_by(|a, b| a.abs().total_cmp(&b.abs()))
            .unwrap_or(0.0)
    }

    /// Where he stands if the ground begins to that side.
    fn ahead(&self, side: f64, above: f64) -> Option<f64> {
        let mut without = 0.0;
        while without < REACH {
            let next = without + STRIDE;
            if self.carries(side * next, above) {
                return Some(self.end(side * next, side * without, above) + side * INSIDE);
            }
            without = next;
        }
        None
    }
}
