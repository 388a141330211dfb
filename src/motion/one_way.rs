//! One-ways: falling through one on request, and keeping to one's side of one.
//!
//! A one-way stops who comes from its front, decided by the face that he comes from ([`Ground::blocks`]). So one who wants
//! down is simply put into the face on the other side, there and then: no request stays open that could be lost.
//!
//! One falls through what one stands on, with down and a jump that is pressed there. A jump pressed in the air is none of these:
//! after the landing it is a jump, with down held too.

use super::body::{Air, Body, EventKind, Mode, Trace};
use super::ladder::Reach;
use super::terrain::{Ground, Terrain};
use super::vertex::JOINT_STEPS;
use crate::geom::STEP;
use crate::mesh::{EdgeId, FaceId, Segment};

impl Body {
    /// Through the one-way under the body, if down is held, the jump is pressed now, and nothing solid is there. It is used up.
    pub(super) fn drop_if_asked(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = self.ground(terrain);
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        let asks = self.control.down && self.pressed_at == Some(self.time);
        if !asks || !on.walkable || !mesh.is_one_way(on.edge) {
            return false;
        }
        let beyond = mesh.sym(on.edge);
        let face = mesh.left(beyond).expect("a one-way is free on either side");
        let through = on.segment;
        let (p, v) = (self.local_position(), self.local_velocity());
        // Ground that rounding alone tells from what he stands on.
        let width = f64::from(JOINT_STEPS) * STEP;
        let is_ground = |s| mesh.walkable(s) && mesh.track(s).height(p, p, p).0.abs() <= width;
        let mut below = mesh.sides(face).into_iter().filter(|&e| mesh.blocks(e));
        if below.any(|e| mesh.facing(e).any(is_ground)) {
            return false;
        }
        self.fly(p, v, face, [None; 2]);
        if let Mode::Air(air) = &mut self.mode {
            air.through = Some(through);
        }
        (self.rise, self.coyote_from, self.pressed_at) = (None, None, None);
        self.reach = Reach::Anew;
        self.log(EventKind::Dropped, trace);
        true
    }

    /// Forgets the one-way that the body has fallen through as soon as it is more than rounding apart from it.
    pub(super) fn come_apart_from_one_way(&mut self, terrain: &Terrain) {
        let (mesh, at) = (self.ground(terrain), self.local_position());
        if let Mode::Air(air) = &mut self.mode
            && let Some(through) = air.through
            && mesh.track(through).height(at, at, at).0.abs() > STEP
        {
            air.through = None;
        }
    }

    /// The face for a position in the mesh of another size, `face`, or the one across a one-way from it if the position is
    /// on that as rounding goes and the body is on the other side of it.
    pub(super) fn same_side(&self, face: FaceId, new: Ground, terrain: &Terrain) -> FaceId {
        let old = self.ground(terrain);
        let (here, p) = (self.face(&old), self.local_position());
        let faces_it = |e: EdgeId, one: &Segment| {
            let same =
                |s| (old.segment(s).feature, old.segment(s).source) == (one.feature, one.source);
            old.has_front(e) && old.fronts(e).any(same)
        };
        // Whether the body, before the front of a one-way as this is in the other mesh, is behind it, or the other way round.
        let differs = |e: EdgeId| {
            let [a, b] = [new.origin(e), new.dest(e)].map(|v| new.point(v).metres());
            let away = (b - a).perp_dot(p - a).abs() / (b - a).length();
            let crossed = |front: EdgeId, back: bool| {
                new.has_front(front)
                    && new.fronts(front).any(|s| {
                        let side = |e: EdgeId| if back { e } else { old.sym(e) };
                        let one = new.segment(s);
                        old.sides(here).into_iter().any(|e| faces_it(side(e), one))
                    })
            };
            // Who climbs keeps to his ladder in the same way.
            let [here, there] =
                [e, new.sym(e)].map(|e| new.left(e).is_some_and(|f| new.is_ladder(f)));
            let lost = self.climbing && !here && there;
            away <= self.rounding() && (crossed(e, false) || crossed(new.sym(e), true) || lost)
        };
        let across = new.sides(face).into_iter().find(|&e| differs(e));
        let across = across.and_then(|e| new.left(new.sym(e)));
        across.filter(|&f| !new.is_solid(f)).unwrap_or(face)
    }
}

impl Air {
    /// Whether an edge stops the body only by the one-way that it is falling through: rounding may have bent that up and
    /// down across its path by a step. One who has risen above it by more than that comes back to it like anybody else.
    pub(super) fn falls_through(&self, mesh: Ground, e: EdgeId) -> bool {
        let Some(through) = self.through.filter(|_| mesh.is_one_way(e)) else {
            return false;
        };
        let line = mesh.track(through);
        let (c, b, q) = line.height(self.p0, self.v0, self.accel);
        let highest = match (b > 0.0, q < 0.0) {
            (false, _) => c,
            (true, true) => c - b * b / (4.0 * q),
            (true, false) => f64::INFINITY,
        };
        let on_line = |s| mesh.track(s).same_line(&line);
        highest <= STEP && mesh.facing(e).all(on_line)
    }
}
