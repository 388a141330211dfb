//! Rest where a walker is driven back from either side: between belts that meet, at the bottom of a valley, at the end of the
//! ground where the stick wants him back. Without it he would swing about that vertex, ever faster.

use super::body::{Body, Mode, Size, Surface, Trace};
use super::change::settled;
use super::footing::Footing;
use super::joint::{Joint, Onward};
use super::law;
use super::terrain::Terrain;
use super::vertex::JOINT_STEPS;
use crate::geom::STEP;

impl Body {
    /// One who stands against something and is driven towards it looks again what it is: with another wish he may step up
    /// onto it, or leave the vertex where two belts have held him. True if he has gone on.
    pub(super) fn press_on(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        let mesh = self.ground(terrain);
        let Mode::Surface(on) = &self.mode else {
            return false;
        };
        if !on.walkable || on.u0 != 0.0 || on.accel * on.against <= 0.0 {
            return false;
        }
        let joint = Joint::ahead(on, on.against, 0.0, mesh);
        let onward = joint.onward(mesh);
        let is_held = match self.ground_ahead(&joint, onward.as_ref(), terrain) {
            Some(ground) => self.is_held(&joint, &ground, terrain),
            None if joint.is_end(onward.as_ref()) => {
                self.is_brought_back(&joint, self.time, terrain)
            }
            None => return self.step_up(&joint, terrain, trace),
        };
        if let Mode::Surface(on) = &mut self.mode
            && !is_held
        {
            // Nothing stands in the way: the vertex is reached again, at once.
            on.against = 0.0;
        }
        false
    }

    /// Whether one who stands at the end of the ground, driven over it, would be brought back at a time; `None` if that is not what
    /// keeps him.
    pub(super) fn keeps_at_end(&self, on: &Surface, at: f64, terrain: &Terrain) -> Option<bool> {
        if on.against == 0.0 || on.u0 != 0.0 || on.accel != 0.0 {
            return None;
        }
        let mesh = self.ground(terrain);
        let joint = Joint::ahead(on, on.against, 0.0, mesh);
        let onward = joint.onward(mesh);
        let goes_on = self
            .ground_ahead(&joint, onward.as_ref(), terrain)
            .is_some();
        let ends = !goes_on && joint.is_end(onward.as_ref());
        ends.then(|| self.is_brought_back(&joint, at, terrain))
    }

    /// Whether a walker comes to rest at a joint because the ground drives him back to it from either side: belts that meet,
    /// a wish against a stronger belt that has carried him back, a valley. He passes it while he runs there himself, or is
    /// faster than the speed that drives him there, and goes further than the width of a joint before he turns: so swings in a
    /// valley that grow ever smaller end.
    pub(super) fn is_held(&self, joint: &Joint, on: &Onward, terrain: &Terrain) -> bool {
        let mesh = self.ground(terrain);
        let (t, forward) = (terrain.tuning, joint.forward());
        let crouched = self.size == Size::Crouch;
        let footing = |e, s, track| Footing::under(e, s, track, mesh, terrain);
        let old = footing(joint.edge, joint.segment, &joint.track);
        let new = footing(on.edge, on.segment, &on.track);
        let drive = |f: &Footing| forward * f.law(0.0, &self.control, crouched, t).accel;
        let (push, back) = (drive(&old), drive(&new));
        let steady = forward * old.steady(&self.control, crouched, t);
        let width = f64::from(JOINT_STEPS) * STEP;
        // Who runs there by himself goes on, be the belt beyond faster than he: it carries him back, and then he is held.
        let runs = self.control.run * forward > 0.0;
        !self.is_pressed()
            && push > 0.0
            && back < 0.0
            && (!runs && joint.speed <= steady || joint.speed * joint.speed <= -2.0 * back * width)
    }

    /// Whether one who leaves the ground here is back at once: he is so slow that the stick brings him back through the air in
    /// less than the width of a joint; or a belt carries him off while he holds up, and he climbs again what he has just
    /// climbed. At the end of the ground he stops then; at a bend he stays on the ground.
    pub(super) fn is_brought_back(&self, joint: &Joint, at: f64, terrain: &Terrain) -> bool {
        let (t, forward) = (terrain.tuning, joint.forward());
        let ground = Footing::under(
            joint.edge,
            joint.segment,
            &joint.track,
            self.ground(terrain),
            terrain,
        );
        let crouched = self.size == Size::Crouch;
        let push = forward * ground.law(0.0, &self.control, crouched, t).accel;
        // The stick and the drag of the air count in the level, whatever carries him.
        let frame = self.frame_piece();
        let x = forward * joint.speed + frame.velocity(at).x;
        let x = settled(
            x,
            &law::marks_of_steering(&self.control, t),
            frame.rounding(at),
        );
        let back = forward * (law::steer(x, &self.control, t).accel - frame.accel.x);
        let wishes = self.control.run * forward < 0.0 || self.frame.is_some();
        let width = f64::from(JOINT_STEPS) * STEP;
        let flies_back = wishes && back < 0.0 && joint.speed * joint.speed <= -2.0 * back * width;
        let climbs_back =
            self.control.up && self.control.run == 0.0 && push > 0.0 && joint.speed == 0.0;
        !self.is_pressed() && (flies_back || climbs_back)
    }
}
