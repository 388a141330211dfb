//! What one place brings together: edges of the level and of moving solids that a body meets at one and the same time.
//!
//! Impacts are taken one after the other. Between surfaces that leave room this ends: each takes what goes into it. Where they
//! leave none, the body would be thrown to and fro for ever at one time, or, where a corner is rounded, ever faster between
//! places less than a joint apart. So what it comes to is noted until it is away from it, and as soon as it is back at an edge
//! that it has left, all of them are asked at once: is there a velocity that goes into none? With the normals n and the speeds b
//! at which the edges come up along them, that is n . v >= b for each. If there is none, two or three of them say so (Helly), by
//! weights that cancel the normals and leave a positive sum of the speeds (Farkas): the body is crushed. If there is one, and the
//! body is back at the very same time, it flies on from there with the one nearest to its own: the impact of all of them at once
//! (Moreau's for edges without friction or bounce).

use super::beside::ROUNDING;
use super::body::{Body, EventKind, Mode, Size, Trace};
use super::step::CREEP;
use super::terrain::Terrain;
use super::vertex::JOINT_STEPS;
use crate::geom::STEP;
use crate::mesh::SegmentId;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// An edge that a body has come to and is not yet away from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Meeting {
    /// The moving solid; `None`: the level.
    mover: Option<u32>,
    size: Size,
    segment: SegmentId,
    /// The body is still on it, or pressed by it.
    lasts: bool,
    /// When it was last, s.
    at: f64,
}

impl Meeting {
    /// The moving solid; `None`: the level.
    pub(super) fn mover(&self) -> Option<u32> {
        self.mover
    }

    /// The size in whose mesh it was.
    pub(super) fn size(&self) -> Size {
        self.size
    }

    /// The edge.
    pub(super) fn segment(&self) -> SegmentId {
        self.segment
    }
}

impl Meeting {
    /// Whether another one is with the same edge.
    fn is_with(&self, other: &Meeting) -> bool {
        let edge = |m: &Meeting| (m.mover, m.size, m.segment);
        edge(self) == edge(other)
    }
}

/// What an edge asks of a velocity.
#[derive(Clone, Copy, Debug)]
struct Demand {
    /// Its normal.
    n: DVec2,
    /// The speed along that which is needed at least, m/s.
    speed: f64,
    /// What rounding may have made of it.
    rounding: f64,
}

impl Demand {
    /// Whether another edge, or two others, ask for the opposite: no velocity meets all.
    fn excludes(&self, others: &[Demand]) -> bool {
        let pair = |b: &Demand| contradict(&[(1.0, *self), (1.0, *b)]);
        let triple = |(i, b): (usize, &Demand)| {
            let a = self;
            others[i + 1..].iter().any(|c| {
                let weights = [b.n.perp_dot(c.n), c.n.perp_dot(a.n), a.n.perp_dot(b.n)];
                let sign = weights[0].signum();
                let same = weights.iter().all(|w| w * sign > 0.0);
                let [u, v, w] = weights.map(f64::abs);
                same && contradict(&[(u, *a), (v, *b), (w, *c)])
            })
        };
        let faces = |b: &Demand| self.n == -b.n && pair(b);
        others.iter().any(faces) || others.iter().enumerate().any(triple)
    }

    /// Whether a velocity goes into the edge, by more than rounding.
    fn forbids(&self, v: DVec2) -> bool {
        self.n.dot(v) < self.speed - self.rounding - ROUNDING * v.length()
    }

    /// The velocity next to one that is just not forbidden.
    fn nearest(&self, v: DVec2) -> DVec2 {
        v + self.n * (self.speed - self.n.dot(v))
    }

    /// The one velocity along this edge and another; `None` if they are parallel.
    fn both(&self, other: &Demand) -> Option<DVec2> {
        let det = self.n.perp_dot(other.n);
        let solved = (self.n * other.speed - other.n * self.speed).perp() / det;
        (det != 0.0).then_some(solved)
    }
}

/// The velocity nearest to one that no demand forbids, unless that is the one itself.
fn way_out(demands: &[Demand], v: DVec2) -> Option<DVec2> {
    if !demands.iter().any(|d| d.forbids(v)) {
        return None;
    }
    let singly = demands.iter().map(|d| d.nearest(v));
    let after = |i: usize| demands[i + 1..].iter();
    let pairs = demands.iter().enumerate();
    let pairs = pairs.flat_map(|(i, a)| after(i).filter_map(|b| a.both(b)));
    let allowed = singly.chain(pairs);
    let allowed = allowed.filter(|&w| !demands.iter().any(|d| d.forbids(w)));
    let away = |w: &DVec2| (*w - v).length_squared();
    allowed.min_by(|a, b| away(a).total_cmp(&away(b)))
}

/// Whether demands whose weighted normals cancel ask for more than nothing together, by more than rounding.
fn contradict(weighted: &[(f64, Demand)]) -> bool {
    let sum: f64 = weighted.iter().map(|(w, d)| w * d.speed).sum();
    let rounding: f64 = weighted.iter().map(|(w, d)| w * d.rounding).sum();
    sum > rounding
}

impl Body {
    /// Notes what the body is on and what presses on it. If it is back at something that it has left, and all that it has met
    /// leaves it no velocity, it is crushed; if it leaves one, and no time has passed, it goes on with that.
    pub(super) fn meet_again(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let mut meetings = std::mem::take(&mut self.meetings);
        let back = self.note(&mut meetings, terrain);
        meetings.retain(|m| m.lasts || self.demand(m, terrain).is_some());
        self.meetings = meetings;
        let Some(left) = back else {
            return;
        };
        let demands = self.meetings.iter();
        let demands: Vec<Demand> = demands.filter_map(|m| self.demand(m, terrain)).collect();
        let at_once = self.time - left <= CREEP * self.time.abs();
        if leave_none(&demands) {
            self.crush(terrain, trace);
        } else if at_once && let Some(v) = way_out(&demands, self.velocity()) {
            match v.length() > self.fastest_way_out(terrain) {
                true => self.crush(terrain, trace),
                false => self.fly_off(v, terrain, trace),
            }
        }
    }

    /// So fast solids may drive the body off: as fast as it is or they are, or as a squeeze may be.
    fn fastest_way_out(&self, terrain: &Terrain) -> f64 {
        let pieces = self.beside.iter().map(|b| b.piece());
        let pieces = pieces.chain([self.frame_piece()]);
        let speeds = pieces.map(|piece| piece.velocity(self.time).length());
        let fastest = speeds.fold(self.velocity().length(), f64::max);
        terrain.tuning.squeeze_speed.max(fastest * (1.0 + ROUNDING)) + fastest
    }

    /// Notes what the body is on and what presses on it. If it is back at something, when it left that, s; the last time of several.
    fn note(&self, meetings: &mut Vec<Meeting>, terrain: &Terrain) -> Option<f64> {
        let (now, size) = (self.time, self.size);
        let mine = self.left_behind(terrain).into_iter().flatten();
        let mine = mine.map(|segment| (self.carrier(), segment));
        let pressing = self.beside.iter();
        let pressing = pressing.filter_map(|b| b.contact.map(|c| (b.mover(), c.segment)));
        let present = mine.chain(pressing).map(|(mover, segment)| Meeting {
            mover,
            size,
            segment,
            lasts: true,
            at: now,
        });
        let mut back = None;
        for old in meetings.iter_mut() {
            let lasts = present.clone().any(|new| new.is_with(old));
            if lasts && !old.lasts {
                back = Some(back.map_or(old.at, |at: f64| at.max(old.at)));
            }
            if lasts || old.lasts {
                (old.lasts, old.at) = (lasts, now);
            }
        }
        for new in present {
            if !meetings.iter().any(|old| new.is_with(old)) {
                meetings.push(new);
            }
        }
        back
    }

    /// Off what it is on, with a velocity in the world.
    fn fly_off(&mut self, v: DVec2, terrain: &Terrain, trace: &mut Trace) {
        if matches!(self.mode, Mode::Air(_)) {
            return;
        }
        let local = v - self.frame_piece().velocity(self.time);
        let face = self.face_ahead(local, self.ground(terrain));
        let touching = self.left_behind(terrain);
        let kind = match self.supported() {
            true => EventKind::Left,
            false => EventKind::Parted,
        };
        self.come_off_wall(terrain);
        self.fly(self.local_position(), local, face, touching);
        self.log(kind, trace);
    }

    /// What an edge asks for, if the body has not been moved away from it since.
    fn demand(&self, m: &Meeting, terrain: &Terrain) -> Option<Demand> {
        let now = self.time;
        if m.size != self.size {
            return None; // that edge is of another mesh
        }
        let piece = match m.mover == self.carrier() {
            true => self.frame_piece(),
            false => self.beside.iter().find(|b| b.mover() == m.mover)?.piece(),
        };
        let mesh = terrain.ground_under(m.mover, self.size);
        let (track, q) = (mesh.track(m.segment), self.position() - piece.offset(now));
        let edge = mesh.segment(m.segment);
        let beyond = track.past(q, [edge.a, edge.b]);
        let away = beyond.max(track.height(q, q, q).0.abs());
        let near = away <= f64::from(JOINT_STEPS) * STEP;
        near.then(|| Demand {
            n: track.normal,
            speed: track.normal.dot(piece.velocity(now)),
            rounding: piece.rounding(now),
        })
    }
}

/// Whether edges leave no velocity at all.
fn leave_none(demands: &[Demand]) -> bool {
    let mut rest = demands;
    while let [first, others @ ..] = rest {
        if first.excludes(others) {
            return true;
        }
        rest = others;
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    fn demand(x: f64, y: f64, speed: f64) -> Demand {
        Demand {
            n: DVec2::new(x, y).normalize(),
            speed,
            rounding: 1e-12,
        }
    }

    #[test]
    fn a_crusher_leaves_a_way_out_only_if_a_side_is_open() {
        let (floor, press) = (demand(0.0, 1.0, 0.0), demand(0.0, -1.0, 1.0));
        assert!(press.excludes(&[floor]));
        assert!(!demand(0.0, -1.0, 0.0).excludes(&[floor]), "at rest");
        assert!(!demand(0.0, -1.0, 1e-13).excludes(&[floor]), "rounding");
        let slope = demand(1.0, 1.0, 0.0);
        assert!(!press.excludes(&[slope]), "down along it");
        assert!(press.excludes(&[slope, demand(-1.0, 1.0, 0.0)]), "a vee");
        assert!(press.excludes(&[demand(-1.0, 0.0, 0.0), slope]), "a wall");
        assert!(!press.excludes(&[demand(1.0, 0.0, 0.0), slope]), "behind");
    }

    #[test]
    fn of_the_ways_out_the_nearest_is_taken() {
        let (floor, wall) = (demand(0.0, 1.0, 0.0), demand(-1.0, 0.0, 2.0));
        let free = DVec2::new(-3.0, 1.0);
        assert_eq!(way_out(&[floor, wall], free), None);
        let falls = DVec2::new(-3.0, -1.0);
        assert_eq!(way_out(&[floor, wall], falls), Some(DVec2::new(-3.0, 0.0)));
        let both = DVec2::new(1.0, -1.0);
        assert_eq!(way_out(&[floor, wall], both), Some(DVec2::new(-2.0, 0.0)));
    }
}
