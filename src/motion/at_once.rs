//! What one instant brings together: edges of the level and of moving solids that a body meets at one and the same time.
//!
//! Impacts are taken one after the other. Between surfaces that leave room this ends: each takes what goes into it. Where they
//! leave none, the body would be thrown to and fro for ever at one time. So what it comes to is noted while the time stands still,
//! and as soon as it is back at an edge that it has left at this very time, all of them are asked at once: is there a velocity
//! that goes into none? With the normals n and the speeds b at which the edges come up along them, that is n . v >= b for
//! each. If there is none, two or three of them say so (Helly), by weights that cancel the normals and leave a positive sum of
//! the speeds (Farkas): the body is crushed.

use super::body::{Body, Size, Trace};
use super::terrain::Terrain;
use super::vertex::JOINT_STEPS;
use crate::geom::STEP;
use crate::mesh::SegmentId;
use glam::DVec2;

/// An edge that a body has come to at the present time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// The moving solid; `None`: the level.
    mover: Option<u32>,
    size: Size,
    segment: SegmentId,
    /// The body is still on it, or pressed by it.
    lasts: bool,
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
}

/// Whether demands whose weighted normals cancel ask for more than nothing together, by more than rounding.
fn contradict(weighted: &[(f64, Demand)]) -> bool {
    let sum: f64 = weighted.iter().map(|(w, d)| w * d.speed).sum();
    let rounding: f64 = weighted.iter().map(|(w, d)| w * d.rounding).sum();
    sum > rounding
}

impl Body {
    /// Notes what the body is on and what presses on it. If it is back at something that it has left at this very time, and all
    /// that it has met leaves it no velocity, it is crushed.
    pub(super) fn meet_again(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let mine = self.left_behind(terrain).into_iter().flatten();
        let mine = mine.map(|segment| (self.carrier(), segment));
        let pressing = self.beside.iter();
        let pressing = pressing.filter_map(|b| b.contact.map(|c| (b.mover(), c.segment)));
        let size = self.size;
        let present = mine.chain(pressing).map(|(mover, segment)| Meeting {
            mover,
            size,
            segment,
            lasts: true,
        });
        let is =
            |a: &Meeting, b: &Meeting| (a.mover, a.size, a.segment) == (b.mover, b.size, b.segment);
        let mut again = false;
        for known in &mut trace.meetings {
            let lasts = present.clone().any(|m| is(&m, known));
            again |= lasts && !known.lasts;
            known.lasts = lasts;
        }
        for new in present {
            if !trace.meetings.iter().any(|known| is(known, &new)) {
                trace.meetings.push(new);
            }
        }
        if again && self.has_no_way(&trace.meetings, terrain) {
            self.crush(terrain, trace);
        }
    }

    /// Whether edges that the body has come to leave it no velocity.
    fn has_no_way(&self, meetings: &[Meeting], terrain: &Terrain) -> bool {
        let demands = meetings.iter().filter_map(|m| self.demand(m, terrain));
        let demands: Vec<Demand> = demands.collect();
        let mut rest = &demands[..];
        while let [first, others @ ..] = rest {
            if first.excludes(others) {
                return true;
            }
            rest = others;
        }
        false
    }

    /// What an edge asks for, if the body has not been moved away from it since.
    fn demand(&self, m: &Meeting, terrain: &Terrain) -> Option<Demand> {
        let now = self.time;
        let piece = match m.mover == self.carrier() {
            true => self.frame_piece(),
            false => self.beside.iter().find(|b| b.mover() == m.mover)?.piece(),
        };
        let mesh = terrain.ground_under(m.mover, self.size);
        let (track, q) = (mesh.track(m.segment), self.position() - piece.offset(now));
        let edge = mesh.segment(m.segment);
        let [a, b] = [edge.a, edge.b].map(|end| track.parameter_of(end));
        let s = track.parameter(q);
        let beyond = (a.min(b) - s).max(s - a.max(b));
        let away = beyond.max(track.height(q, q, q).0.abs());
        let near = m.size == self.size && away <= f64::from(JOINT_STEPS) * STEP;
        near.then(|| Demand {
            n: track.normal,
            speed: track.normal.dot(piece.velocity(now)),
            rounding: piece.rounding(now),
        })
    }
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
}
