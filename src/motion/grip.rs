//! Holding on: hanging from a ledge, climbing up onto it, climbing walls that can be climbed.
//!
//! A grip belongs to the body's place on a wall and ends with it. While it lasts there is no gravity: the speed along the
//! wall is driven to the wished one, and nothing else moves the body. Crouched bodies hold on to nothing, but one who climbs onto
//! a ledge with room for no more does so crouched.

use super::body::{Body, Control, EventKind, Mode, Next, Size, Surface, Trace};
use super::joint::{Joint, Onward};
use super::law::Law;
use super::ledge::{Beyond, Top, beyond, top_above};
use super::size::piece_at;
use super::terrain::{Ground, Terrain};
use crate::geom::STEP;
use crate::mesh::{EdgeId, Segment, SegmentId};
use crate::tune::Motion;
use serde::{Deserialize, Serialize};

/// What a body on a wall holds on to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Grip {
    /// Nothing: it slides.
    #[default]
    None,
    /// The ledge above, from which it hangs at rest.
    Ledge,
    /// The same ledge, while it climbs up and onto it.
    Over,
    /// The wall itself, which can be climbed.
    Wall,
}

/// Whether one of the features along a mesh edge has walls that can be climbed.
fn is_climbable(mesh: Ground, e: EdgeId, terrain: &Terrain) -> bool {
    let climbable = |s| terrain.traits_of(mesh.segment(s).feature).climbable;
    !terrain.traits.is_empty() && mesh.facing(e).any(climbable)
}

impl Body {
    /// What the body holds on to.
    pub fn grip(&self) -> Grip {
        match &self.mode {
            Mode::Surface(on) => on.grip,
            _ => Grip::None,
        }
    }

    /// Whether the stick leads away from the wall that the body is on.
    pub(super) fn turns_from_wall(&self, terrain: &Terrain) -> bool {
        self.away_from_wall(terrain)
            .is_some_and(|away| self.control.run * away > 0.0)
    }

    /// Lets go, takes hold, or begins to climb, as the control asks.
    ///
    /// A ledge is let go with down or away from it, and climbed with up or jump. A climbable wall is taken hold of with up,
    /// down, or the stick towards it, and held until the stick leads away from it.
    pub(super) fn grip_as_wished(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let (turns, down) = (self.turns_from_wall(terrain), self.control.down);
        let climbs = self.control.up || self.within(self.pressed_at, terrain.tuning.jump_buffer);
        let lets_go = match self.grip() {
            Grip::None => false,
            Grip::Ledge | Grip::Over => turns || down || self.has_lost_ledge(terrain),
            Grip::Wall => turns || !self.is_at_climbable(terrain),
        };
        if lets_go {
            self.hold_on(Grip::None, EventKind::LetGo, trace);
        }
        match self.grip() {
            Grip::Ledge if climbs => {
                self.pressed_at = None;
                self.crouch_under_roof(terrain, trace);
                self.hold_on(Grip::Over, EventKind::Climbed, trace);
            }
            Grip::None if self.reaches_for_wall(terrain) && self.is_at_climbable(terrain) => {
                self.hold_on(Grip::Wall, EventKind::Climbed, trace);
            }
            _ => {}
        }
    }

    /// Whether the ledge is no more from which the body hangs: the level has been edited, or its reach.
    pub(super) fn has_lost_ledge(&self, terrain: &Terrain) -> bool {
        match &self.mode {
            Mode::Surface(on) if on.grip == Grip::Ledge => {
                self.hang_parameter(on, STEP, terrain) != Some(on.s0)
            }
            _ => false,
        }
    }

    fn hold_on(&mut self, grip: Grip, kind: EventKind, trace: &mut Trace) {
        if let Mode::Surface(on) = &mut self.mode {
            on.grip = grip;
        }
        self.rise = None;
        self.log(kind, trace);
    }

    /// Wishes to take hold of a wall, should it be climbable.
    fn reaches_for_wall(&self, terrain: &Terrain) -> bool {
        let away = self.away_from_wall(terrain);
        let pushes = |away: f64| {
            self.control.run * away < 0.0
                || self.control.run == 0.0 && (self.control.up || self.control.down)
        };
        self.size == Size::Stand && !self.climbing && away.is_some_and(pushes)
    }

    fn is_at_climbable(&self, terrain: &Terrain) -> bool {
        self.edge()
            .is_some_and(|e| is_climbable(self.ground(terrain), e, terrain))
    }

    /// Whether the way along a wall that goes on in one line changes what the body may hold on to: a climber stops where
    /// the climbable part ends, and one who reaches for it takes hold where it begins.
    pub(super) fn meets_other_grip(&self, next: EdgeId, terrain: &Terrain) -> bool {
        let climbable = || is_climbable(self.ground(terrain), next, terrain);
        match self.grip() {
            Grip::Wall => !climbable(),
            Grip::None => self.reaches_for_wall(terrain) && climbable(),
            Grip::Ledge | Grip::Over => false,
        }
    }

    /// At a joint while holding on. False if it is one for a slide: down onto the ground.
    ///
    /// Up a wall, the way leads over convex corners to further wall and onto ground, where the body arrives at rest. A
    /// climber stops at everything else; who climbs over a ledge that is no more lets go.
    pub(super) fn climb_joint(
        &mut self,
        joint: &Joint,
        onward: Option<&Onward>,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let mesh = self.ground(terrain);
        let grip = self.grip();
        let Some(edge) = self.edge().filter(|_| grip != Grip::None) else {
            return false;
        };
        let ground = |on: &Onward| on.towards && mesh.walkable(on.segment);
        match beyond(mesh, edge, joint.heading, &joint.track) {
            Beyond::Wall(next, s) if grip == Grip::Over || is_climbable(mesh, next, terrain) => {
                let way = joint.onto(mesh, next, s);
                self.bend(&way, joint.speed, terrain, trace);
                if let Mode::Surface(on) = &mut self.mode {
                    on.grip = grip;
                }
            }
            _ if joint.before.1 < 0 && onward.is_some_and(ground) => return false,
            Beyond::Top(next, s) => {
                let on = joint.onto(mesh, next, s);
                self.settle(s, next, on.start, 0.0, 0.0, terrain, trace);
            }
            _ if self.is_pressed_at_joint(terrain, trace)
                && self.presses_on(joint.track.tangent * joint.sign, terrain) =>
            {
                // Nobody holds on against what drives him over the end of the wall.
                self.hold_on(Grip::None, EventKind::LetGo, trace);
                return false;
            }
            _ => {
                self.stop(joint, onward, trace, mesh);
                if grip == Grip::Over {
                    self.hold_on(Grip::None, EventKind::LetGo, trace);
                }
            }
        }
        true
    }

    /// Whether the body would hang from a ledge if there were one at the right height: standing upright on a wall, not
    /// holding on yet, and asking for nothing else.
    fn may_hang(&self, terrain: &Terrain) -> bool {
        terrain.tuning.ledge_hang > 0.0
            && self.size == Size::Stand
            && self.grip() == Grip::None
            && !self.climbing
            && !self.control.down
            && self
                .away_from_wall(terrain)
                .is_some_and(|away| self.control.run * away <= 0.0)
            && !self.is_driven(terrain)
    }

    /// The parameter at which the body's feet hang from the ledge above the wall that it is on, if that is no higher than
    /// `reach` above them. Only walls steeper than 45 degrees have one: there the parameter is the height.
    fn hang_parameter(&self, on: &Surface, reach: f64, terrain: &Terrain) -> Option<f64> {
        let (mesh, t) = (self.ground(terrain), terrain.tuning);
        let s = on.parameter(self.time);
        let highest = s + reach + t.ledge_hang;
        if !on.is_upright() {
            return None;
        }
        let top = top_above(mesh, on.edge, &on.track, highest);
        let top = top.or_else(|| self.top_for_crouched(on, highest, terrain))?;
        let hang = top.height - t.ledge_hang;
        (hang <= s + reach).then_some(hang)
    }

    /// The same place on the same wall for one who crouches: the edge of that mesh and its feature edge.
    fn on_wall_crouched(&self, on: &Surface, terrain: &Terrain) -> Option<(EdgeId, SegmentId)> {
        let [high, low] =
            [self.size, Size::Crouch].map(|s| terrain.ground_under(self.carrier(), s));
        let Segment {
            feature, source, ..
        } = *high.segment(on.segment);
        let segment = low.segment_of(feature, source)?;
        if !low.track(segment).same_line(&on.track) {
            return None;
        }
        let edge = piece_at(low, segment, on.parameter(self.time), &on.track, None)?;
        Some((edge, segment))
    }

    /// The ground on top of the wall for one who crouches: where one who stands upright finds none, there may be room for him.
    fn top_for_crouched(&self, on: &Surface, highest: f64, terrain: &Terrain) -> Option<Top> {
        let (edge, _) = self.on_wall_crouched(on, terrain)?;
        let low = terrain.ground_under(self.carrier(), Size::Crouch);
        top_above(low, edge, &on.track, highest)
    }

    /// Hanging from a ledge with room for no more: crouches, at that place.
    fn crouch_under_roof(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let Mode::Surface(on) = &self.mode else {
            return;
        };
        let highest = on.s0 + STEP + terrain.tuning.ledge_hang;
        if top_above(self.ground(terrain), on.edge, &on.track, highest).is_some() {
            return;
        }
        let Some(place) = self.on_wall_crouched(on, terrain) else {
            return;
        };
        self.follow(terrain);
        if let (true, Mode::Surface(on)) = (self.fits_beside(Size::Crouch, terrain), &mut self.mode)
        {
            (on.edge, on.segment) = place;
            self.take_places(Size::Crouch, terrain);
            self.size = Size::Crouch;
            self.log(EventKind::Resized(Size::Crouch), trace);
        }
    }

    /// A slide down past the height of the feet of one who hangs takes hold there, if that comes first.
    ///
    /// Who lets go there is at that height with no speed, and does not take hold again: no lock is needed.
    pub(super) fn sooner_if_grabs(
        &self,
        next: Option<(f64, Next)>,
        terrain: &Terrain,
    ) -> Option<(f64, Next)> {
        let Mode::Surface(on) = &self.mode else {
            return next;
        };
        if on.walkable || on.sign() * on.track.tangent.y >= 0.0 || !self.may_hang(terrain) {
            return next;
        }
        let grabs = self
            .hang_parameter(on, 0.0, terrain)
            .filter(|&hang| hang < on.parameter(self.time) || on.speed(self.time) != 0.0);
        let grabs = grabs
            .and_then(|hang| Some((on.t0 + on.reaches(hang)?.max(on.since), Next::Grab(hang))));
        Next::sooner(next, grabs)
    }

    /// Hangs from the ledge, its feet exactly at that parameter.
    pub(super) fn grab(&mut self, hang: f64, trace: &mut Trace) {
        self.rebase();
        if let Mode::Surface(on) = &mut self.mode {
            (on.s0, on.u0) = (hang, 0.0);
        }
        self.hold_on(Grip::Ledge, EventKind::Grabbed, trace);
    }

    /// Come to a wall in flight with its feet a little too low to hang: the body is lifted along the wall. The way is free,
    /// since it is the boundary of free space; it must be one line. A jump that waits goes first.
    pub(super) fn catch_ledge(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let t = terrain.tuning;
        let mesh = self.ground(terrain);
        let jumps = t.wall_jump_up > 0.0 && self.within(self.pressed_at, t.jump_buffer);
        let Mode::Surface(on) = &self.mode else {
            return;
        };
        if on.walkable || on.u0 * on.track.tangent.y > 0.0 || jumps || !self.may_hang(terrain) {
            return;
        }
        let hang = self.hang_parameter(on, t.ledge_magnet, terrain);
        let Some((hang, (edge, segment))) = hang
            .filter(|&hang| hang >= on.s0)
            .filter(|&hang| self.is_clear_to(on.track.position(hang), terrain))
            .and_then(|hang| Some((hang, on.piece_above(hang, mesh)?)))
        else {
            return;
        };
        if let Mode::Surface(on) = &mut self.mode {
            (on.edge, on.segment, on.track) = (edge, segment, mesh.track(segment));
        }
        self.grab(hang, trace);
    }
}

impl Surface {
    /// The acceleration of one who holds on, and the speed at which it ends.
    pub(super) fn choose_climb(&mut self, control: &Control, t: &Motion) {
        let wish = f64::from(u8::from(control.up)) - f64::from(u8::from(control.down));
        let speed = match self.grip {
            Grip::None | Grip::Ledge => 0.0,
            Grip::Over => t.ledge_climb_speed,
            Grip::Wall => wish * t.climb_speed,
        };
        let target = speed * self.track.tangent.y.signum();
        // A piece does not turn: what goes the other way stops first.
        let turns = self.u0 * target < 0.0;
        let climb = Law::towards(self.u0, if turns { 0.0 } else { target }, t.climb_accel);
        let left = climb.time_left(self.u0);
        self.accel = climb.accel;
        self.limit = left
            .zip(climb.until)
            .map(|(left, until)| (self.t0 + left, until));
    }
}
