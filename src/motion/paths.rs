//! The paths of moving solids from the view of a body: their nodes, and what the game changes about them.

use super::beside::Beside;
use super::body::{Body, EventKind, Mode, Trace};
use super::mover::Ride;
use super::size::free_face;
use super::terrain::Terrain;
use super::vertex::JOINT_STEPS;
use crate::geom::STEP;
use glam::DVec2;

impl Body {
    /// Another frame begins the next piece of its path. True if the body's own motion does not depend on it.
    pub(super) fn take_up_node(&mut self, i: usize, terrain: &Terrain, trace: &mut Trace) -> bool {
        let (now, p, v) = (self.time, self.position(), self.velocity());
        let beside = &mut self.beside[i];
        let Some(old) = beside.frame else {
            return true;
        };
        let new = Ride::at(old.mover, now, terrain.movers);
        (beside.frame, beside.of) = (Some(new), None);
        let leap = new.piece.offset(now) - old.piece.offset(now);
        let drives = beside.contact.is_some() || self.climbs(Some(old.mover));
        if drives {
            self.rebase();
        }
        let beside = &mut self.beside[i];
        if leap.abs().max_element() > f64::from(JOINT_STEPS) * STEP {
            let mesh = beside.ground(self.size, terrain);
            let at = p - new.piece.offset(now);
            match free_face(mesh, at, v - new.piece.velocity(now), DVec2::NEG_Y) {
                Ok(face) => *beside = Beside::new(Some(new), at, face),
                Err(_) => self.crush(terrain, trace),
            }
            return false;
        }
        if beside.contact.is_some() && new.piece != old.piece {
            self.log(EventKind::Node(old.mover), trace);
        }
        !drives
    }

    /// Takes up the paths as they are now, after the game has started or stopped a moving solid, or has added or removed some.
    /// An event for those whom one carries or presses on that goes another way from now on; the motion of all others
    /// keeps every bit.
    pub fn take_up_paths(&mut self, terrain: &Terrain, trace: &mut Trace) {
        if matches!(self.mode, Mode::Crushed(_)) {
            return;
        }
        let known = self.beside.len();
        if known != terrain.movers.len() {
            self.rebase();
            self.go_down_to_the_level(terrain);
            if self.find_places(terrain).is_err() {
                self.crush(terrain, trace);
            }
            return self.refresh(terrain, trace);
        }
        let now = self.time;
        let is_new = |ride: Ride| Ride::at(ride.mover, now, terrain.movers) != ride;
        let mut is_event = false;
        for i in 0..known {
            let entry = self.beside.get(i);
            if entry.is_some_and(|b| b.frame.is_some_and(is_new)) {
                is_event |= !self.take_up_node(i, terrain, trace);
            }
        }
        if self.frame.is_some_and(is_new) {
            self.ride_on(terrain, trace);
            is_event = true;
        }
        match is_event {
            true => self.refresh(terrain, trace),
            false => self.come_to_place(terrain, trace),
        }
    }

    /// What carries the body may be no more: in the air, where it is, as fast as it was.
    fn go_down_to_the_level(&mut self, terrain: &Terrain) {
        if self.frame.is_none() {
            return;
        }
        let face = self.level_face(terrain.mesh(self.size));
        self.fly(self.position(), self.velocity(), face, [None; 2]);
        (self.frame, self.ladder) = (None, None);
    }
}
