//! Corners: where a walk or a slide comes to the end of a side, and where a flight comes exactly into one.

use super::body::{Body, Kind, MARGIN, Mode};
use super::double::{Double, Vector};
use super::law;
use super::outline::{SAME, Side, World};
use edgewalker::geom::STEP;

/// Turns by less than this are in doubt, as a sine: so narrow a crossing may be rounded to anywhere.
const NARROW: f64 = 1e-3;

/// Hits at a smaller angle than this, as a sine, come at a time that rounding shifts: the pieces of a cut edge lie up to half a
/// step beside it.
const SHALLOW: f64 = 0.15;

/// What follows a side at one of its ends.
#[derive(Clone, Copy, Debug)]
pub enum Onward {
    /// Another side on the same line.
    Straight(usize),
    /// Another side at an angle, towards the free side or away from it.
    Turn { side: usize, towards: bool },
    /// Nothing that was found: sides that touch at a point only within rounding.
    Nothing,
}

fn same(a: Vector, b: Vector) -> bool {
    (a - b).x.abs().max((a - b).y.abs()).to_f64() < SAME
}

/// What follows the end of a side in a direction: the first side when turning about the end through the free side.
pub fn onward(world: &World, side: usize, direction: f64) -> Onward {
    let on = &world.sides[side];
    let p = on.at(on.end(direction));
    // From the way back over the free side: clockwise where that is left of the motion.
    let turned = |k: &&usize| {
        let next = &world.sides[**k];
        let back = on.tangent * (-direction).into();
        let ahead = next.tangent * direction.into();
        let angle = back.cross(ahead).to_f64().atan2(back.dot(ahead).to_f64());
        (-direction * angle).rem_euclid(std::f64::consts::TAU)
    };
    let starts = |&k: &usize| {
        let next = &world.sides[k];
        k != side && same(next.at(next.end(-direction)), p)
    };
    let all: Vec<usize> = (0..world.sides.len()).filter(starts).collect();
    let first = all.iter().min_by(|a, b| turned(a).total_cmp(&turned(b)));
    let Some(next) = first.and_then(|&next| longest(world, next, p, direction)) else {
        return Onward::Nothing;
    };
    let towards = direction * on.tangent.cross(world.sides[next].tangent).sign() > 0.0;
    match on.same_line(&world.sides[next]) {
        true => Onward::Straight(next),
        false => Onward::Turn {
            side: next,
            towards,
        },
    }
}

/// The side that is longest, before cuts, among those on the line of one that lead from a position on in a direction.
fn longest(world: &World, side: usize, p: Vector, direction: f64) -> Option<usize> {
    let line = &world.sides[side];
    let leads_on = |&k: &usize| {
        let on = &world.sides[k];
        let s = on.tangent.dot(p - on.start);
        let ahead = (on.end(direction) - s) * direction.into();
        let behind = (on.end(-direction) - s) * direction.into();
        line.same_line(on) && ahead.to_f64() > SAME && behind.to_f64() < SAME
    };
    let by_length = |a: &usize, b: &usize| {
        let length = |k: usize| world.sides[k].length.to_f64();
        length(*a).total_cmp(&length(*b)).then(b.cmp(a))
    };
    (0..world.sides.len()).filter(leads_on).max_by(by_length)
}

/// A corner reached along a side.
struct Corner<'a> {
    p: Vector,
    direction: f64,
    speed: Double,
    before: &'a Side,
    after: &'a Side,
    side: usize,
    towards: bool,
    /// Cosine of the turn.
    cosine: Double,
}

impl Corner<'_> {
    /// Whether the flank of the body's foot would slide up the corner of a step here: that is a wall to walkers.
    fn is_bump(&self) -> bool {
        let ahead = |side: &Side| side.tangent * self.direction.into();
        let (before, after) = (ahead(self.before), ahead(self.after));
        self.after.is_flank && after.y.sign() > 0.0 && (after.x * before.x).sign() > 0.0
    }
}

impl Body<'_> {
    /// At the end of a side.
    pub fn corner(&mut self, direction: f64) {
        let Mode::On {
            side, u, against, ..
        } = self.mode
        else {
            return;
        };
        let on = self.side(side);
        let p = on.at(on.end(direction));
        if self.is_crowded(p) {
            self.doubt("corners close together");
        }
        match onward(self.world, side, direction) {
            Onward::Nothing => self.doubt("a corner without a way on"),
            Onward::Straight(side) => {
                let next = self.side(side);
                let s = next.tangent.dot(p - next.start);
                self.mode = Mode::On {
                    side,
                    s,
                    u,
                    against,
                };
            }
            Onward::Turn {
                side: next,
                towards,
            } => {
                let way_here = longest(self.world, side, p, -direction).unwrap_or(side);
                let (before, after) = (self.side(way_here), self.side(next));
                let corner = Corner {
                    p,
                    direction,
                    speed: u.abs(),
                    before,
                    after,
                    side: next,
                    towards,
                    cosine: before.tangent.dot(after.tangent),
                };
                if before.tangent.cross(after.tangent).abs().to_f64() < NARROW {
                    self.doubt("a narrow turn");
                }
                if self.walkable(side) {
                    self.walk_round(corner);
                } else {
                    self.slide_round(corner);
                }
            }
        }
    }

    /// Whether another corner is so near that rounding may confuse them.
    fn is_crowded(&self, p: Vector) -> bool {
        let ends = |side: &Side| [side.at(side.from), side.at(side.to)];
        let near = |q: Vector| !same(p, q) && (p - q).length().to_f64() < MARGIN;
        self.world.sides.iter().flat_map(ends).any(near)
    }

    /// A walker: on to other ground, up or against a wall, or off the edge.
    fn walk_round(&mut self, corner: Corner) {
        let t = self.tuning;
        if self.walkable(corner.side) {
            if !corner.towards && !self.holds(&corner) {
                return self.leave(&corner);
            }
            // A turn of a right angle or more is a wall and no bend.
            let project = corner.towards && (t.concave == 1.0 || corner.cosine.sign() <= 0.0);
            let kept = if project {
                corner.cosine.max(Double::ZERO)
            } else {
                Double::ONE
            };
            self.go_on(&corner, corner.speed * kept);
        } else if !corner.towards {
            self.leave(&corner);
        } else if corner.is_bump() {
            self.stop(&corner);
        } else {
            // Up a wall only with a speed that carries it higher than a joint may rise: two steps.
            let up = corner.speed * corner.cosine;
            let rise = Double::from(2.0 * t.gravity * 2.0 * STEP);
            if up.sign() > 0.0 && !up.is_tiny() {
                self.sure(
                    up * up - rise,
                    0.1 * rise.to_f64(),
                    "a climb of a joint's height",
                );
            }
            if up.sign() > 0.0 && up * up > rise {
                let s = corner.after.tangent.dot(corner.p - corner.after.start);
                self.settle(corner.side, s, up * corner.direction.into());
            } else {
                self.stop(&corner);
            }
        }
    }

    /// Whether a walker stays on ground that bends away: iff s^2 k <= g cos(slope) + stick, with the slope of the bisector
    /// and k = 2 tan(turn/2) / mean of min(length, span) of the two edges.
    fn holds(&mut self, corner: &Corner) -> bool {
        let t = self.tuning;
        match t.joint {
            0.0 => return true,
            2.0 => return corner.speed.is_tiny(),
            _ => {}
        }
        let (u, v) = (corner.before.tangent, corner.after.tangent);
        let tangent_of_half = u.cross(v).abs() / (Double::ONE + u.dot(v));
        let span = |side: &Side| side.length.min(t.joint_span.into());
        let curvature = tangent_of_half * 4.0.into() / (span(corner.before) + span(corner.after));
        let bisector = u + v;
        let level = bisector.x.abs() / bisector.length();
        let pull = level * t.gravity.into() + t.joint_stick.into();
        let throw = corner.speed * corner.speed * curvature;
        let margin = if self.blurred > 0 { 0.02 } else { 1e-9 };
        self.sure(
            pull - throw,
            margin * pull.to_f64(),
            "the speed that a bend holds",
        );
        throw <= pull
    }

    fn go_on(&mut self, corner: &Corner, speed: Double) {
        let s = corner.after.tangent.dot(corner.p - corner.after.start);
        self.mode = Mode::On {
            side: corner.side,
            s,
            u: speed * corner.direction.into(),
            against: 0.0,
        };
    }

    fn leave(&mut self, corner: &Corner) {
        let walked = matches!(self.mode, Mode::On { side, .. } if self.walkable(side));
        let v = corner.before.tangent * (corner.speed * corner.direction.into());
        self.mode = Mode::Air { p: corner.p, v };
        if walked {
            self.coyote_from = Some(self.time);
            self.log(Kind::Left);
        }
    }

    /// At rest in the corner, which from now on takes up every push.
    fn stop(&mut self, corner: &Corner) {
        if let Mode::On {
            side,
            s,
            u,
            against,
        } = &mut self.mode
        {
            *s = self.world.sides[*side].end(corner.direction);
            (*u, *against) = (Double::ZERO, corner.direction);
        }
    }

    /// A slide: lands on ground, goes on along what gravity leads it along, rests in a V, stops, or flies off.
    fn slide_round(&mut self, corner: Corner) {
        if !corner.towards {
            return self.leave(&corner);
        }
        let direction = Double::from(corner.direction);
        let kept = (corner.speed * corner.cosine).max(Double::ZERO);
        let kept = if kept.is_tiny() { Double::ZERO } else { kept };
        let s = corner.after.tangent.dot(corner.p - corner.after.start);
        let (before, after) = (
            corner.before.tangent * direction,
            corner.after.tangent * direction,
        );
        let (sinks, goes_down) = (before.y.sign() < 0.0, after.y.sign() < 0.0);
        if self.walkable(corner.side) {
            // Who holds against the slope that he comes down on stands at its foot.
            let wish = law::wish(&self.control, self.crouched, self.tuning);
            let holds_against = wish.sign() * after.x.sign() < 0.0;
            if holds_against {
                self.sure(kept - wish.abs(), 1e-6, "a slide as fast as the wish");
            }
            if holds_against && kept <= wish.abs() {
                self.settle(corner.side, s, Double::ZERO);
                if let Mode::On { against, .. } = &mut self.mode {
                    *against = -corner.direction;
                }
            } else {
                self.settle(corner.side, s, kept * direction);
            }
            return;
        }
        let lasts = kept.sign() > 0.0 || !self.is_pulled_off(corner.side, Double::ZERO);
        if lasts && (goes_down || !sinks && kept.sign() > 0.0) {
            self.settle(corner.side, s, kept * direction);
        } else if sinks && !goes_down {
            self.rest(corner.p);
        } else {
            self.stop(&corner);
        }
    }

    fn rest(&mut self, p: Vector) {
        self.rise = None;
        self.mode = Mode::Rest { p };
    }

    /// A flight comes to a side.
    pub fn hit(&mut self, side: usize) {
        let Mode::Air { p, v } = self.mode else {
            return;
        };
        let on = self.side(side);
        let s = on.tangent.dot(p - on.start);
        let into = on.normal.dot(v).abs().to_f64();
        let cut = on.from.sign() > 0.0 || on.to < on.length;
        self.blurred += u32::from(cut && into < SHALLOW * v.length().to_f64());
        for direction in [1.0, -1.0] {
            if (on.end(direction) - s).is_tiny()
                && let Onward::Turn {
                    side: next,
                    towards: true,
                } = onward(self.world, side, direction)
            {
                return self.hit_corner([(side, -direction), (next, direction)], p, v);
            }
        }
        self.settle(side, s, on.tangent.dot(v));
    }

    /// A flight comes exactly into a corner: along one of the sides that it strikes, if it leads away there or the side is
    /// ground; else it rests. Each side comes with the direction in which it leaves the corner.
    fn hit_corner(&mut self, sides: [(usize, f64); 2], p: Vector, v: Vector) {
        if self.is_crowded(p) {
            self.doubt("corners close together");
        }
        let whole = |c: Double| {
            let steps = c / STEP.into();
            (steps - steps.to_f64().round().into()).abs().to_f64() < 1e-12
        };
        let rounded = !(whole(p.x) && whole(p.y));
        self.blurred += u32::from(rounded);
        let accel = self.acceleration();
        let clean = |a: Double| if a.is_tiny() { 0.0 } else { a.to_f64() };
        let met = sides.map(|(side, away)| {
            let on = self.side(side);
            let into = -clean(on.normal.dot(v));
            let bearing = if clean(v.x) == 0.0 && clean(v.y) == 0.0 {
                accel
            } else {
                v
            };
            let outward = clean(on.tangent.dot(bearing)) * away;
            let struck = into > 0.0 || into == 0.0 && clean(on.normal.dot(accel)) < 0.0;
            let rank = (
                struck,
                outward >= 0.0,
                self.walkable(side),
                on.normal.y.to_f64(),
                into,
            );
            (side, outward, rank)
        });
        let follows = |m: &&(usize, f64, (bool, bool, bool, f64, f64))| m.2.0 && (m.2.1 || m.2.2);
        // The motion meets the sides of a rounded corner one after the other, perhaps after a moment of flight between them.
        let both = met.iter().all(|m| m.2.0);
        let slanted = met.iter().any(|m| m.2.0 && !m.2.2 && m.2.4 > 0.0);
        if rounded && (both || slanted) {
            self.doubt("a hit in a rounded corner");
        }
        let best = met.iter().filter(follows);
        match best.max_by(|a, b| a.2.partial_cmp(&b.2).expect("numbers")) {
            None => self.rest(p),
            Some(&(side, outward, _)) => {
                let on = self.side(side);
                let balanced = met[0].2 == met[1].2;
                let along = outward > 0.0 && !balanced;
                let u = if along {
                    on.tangent.dot(v)
                } else {
                    Double::ZERO
                };
                self.settle(side, on.tangent.dot(p - on.start), u);
            }
        }
    }
}
