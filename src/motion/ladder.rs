//! Ladders: regions to climb in, up, down and sideways, without gravity.
//!
//! Who climbs is in the air, or on something too steep to stand on; his velocity is driven towards the wish. Solids stop
//! him, and so do one-ways, but those that can be stood on where the ladder goes on below them. A ladder that moves carries him:
//! he climbs in its frame. On ground that he comes to he stands. The top and the bottom of a ladder, its border edges of at
//! most 45 degrees, stop him as if the outside were solid ([`Ground`] says so to who climbs): he rests there exactly, for as
//! long as he likes. Over the other edges he steps off and falls. From the top he climbs on to ground that is near: see
//! [`super::mount`].
//!
//! Up takes hold, and so does down in the air or on a one-way with the ladder going on below; held keys count. Down that is
//! pressed on a one-way takes hold of a ladder that ends near below, too. A jump leaves the ladder, and what is held takes hold
//! again only when it rises no more. Who lets go (down and jump) or steps off has to press anew, or to stand first; down, in
//! any case, anew.

use super::beside::Beside;
use super::body::{Air, Body, EventKind, Mode, Next, Trace};
use super::change::{Moment, Times};
use super::grip::Grip;
use super::joint::{Joint, Onward};
use super::law::Law;
use super::mover::Piece;
use super::roots::exit;
use super::terrain::{Ground, Region, Terrain};
use super::track::{Track, delta};
use super::vertex::{segment_at, spokes};
use crate::geom::STEP;
use crate::mesh::{EdgeId, FaceId, Kind, SegmentId};
use crate::tune::Motion;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// What rounding makes of the part of a velocity across its own direction, as a share.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Whether a key that is held takes hold of a ladder.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reach {
    /// Yes.
    #[default]
    Open,
    /// Not before the jump off a ladder has come to its apex.
    AfterApex,
    /// Not before it is pressed anew, or the body has stood without down.
    Anew,
    /// Not before the control changes or the place is another one, apart from the ground: the climb that was wished for has led to it.
    Landed,
}

/// So far off ground that one has come off, he is apart from it, m.
const APART: f64 = STEP;

/// How a body takes hold.
enum Hold {
    /// Where it is, in the air or along something steep.
    Here,
    /// From ground that it stands on, or from a wedge.
    Off,
    /// Through the one-way that it stands on, into the face below, where the ladder goes on.
    Below(FaceId),
    /// The same, to a ladder that ends near below.
    Down(FaceId),
}

impl Body {
    /// Whether the body holds on to a ladder.
    pub fn climbing(&self) -> bool {
        self.climbing
    }

    /// Whether the body holds on to a ladder of a frame.
    pub(super) fn climbs(&self, mover: Option<u32>) -> bool {
        self.climbing && self.ladder == mover
    }

    /// Of which frame a ladder is that the body is in. Of several: that which it holds on to, that which carries it, the level, that
    /// beside which it is slowest.
    fn ladder_here(&self, terrain: &Terrain) -> Option<Option<u32>> {
        let is_ladder = |&f: &u32| terrain.traits_of(f).region == Region::Ladder;
        if !self.regions.iter().any(is_ladder) {
            return None;
        }
        if !self.regions_move {
            return Some(None);
        }
        let mine = self.ground(terrain);
        let mine = mine.is_ladder(self.face(&mine)).then_some(self.carrier());
        let others = self.beside.iter().filter(|b| {
            let mesh = terrain.ground_under(b.mover(), self.size);
            mesh.is_ladder(b.flight.face)
        });
        let found = mine.into_iter().chain(others.map(Beside::mover));
        let speed = |mover| (self.velocity() - self.piece_of(mover).velocity(self.time)).length();
        let rank = |mover: Option<u32>| {
            let held = self.climbs(mover);
            let rank = [held, mover == self.carrier(), mover.is_none()];
            (rank.map(|first| !first), speed(mover))
        };
        found.min_by(|&a, &b| {
            let (a, b) = (rank(a), rank(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        })
    }

    pub(super) fn on_ladder(&self, terrain: &Terrain) -> bool {
        self.ladder_here(terrain).is_some()
    }

    /// What carries the body, as the ladder sees it that the body holds on to: at rest if it is of the same frame.
    pub(super) fn drift(&self) -> Piece {
        self.drift_from(self.ladder)
    }

    fn drift_from(&self, ladder: Option<u32>) -> Piece {
        match ladder {
            _ if ladder == self.carrier() => Piece::default(),
            None => self.frame_piece(),
            Some(_) => self.frame_piece().seen_from(&self.piece_of(ladder)),
        }
    }

    /// What rounding may make of the velocity of that, m/s.
    fn drift_rounding(&self, t: f64) -> f64 {
        match self.ladder {
            _ if self.climbs(self.carrier()) => 0.0,
            None => self.frame_piece().rounding(t),
            Some(_) => self.frame_piece().rounding(t) + self.piece_of(self.ladder).rounding(t),
        }
    }

    /// The wish of one who climbs, as a share of full speed.
    fn climb_wish(&self) -> DVec2 {
        if let Some(wish) = self.mount_wish() {
            return wish;
        }
        let share = |key: bool| f64::from(u8::from(key));
        let up = share(self.control.up) - share(self.control.down);
        DVec2::new(self.control.run, up)
    }

    /// Whether the regions around the body make it take hold or lose its hold.
    pub(super) fn minds_ladder(&self, terrain: &Terrain) -> bool {
        let lost = match self.mount {
            Some(_) => self.mount_is_over(self.on_ladder(terrain)),
            None => self.ladder_here(terrain) != Some(self.ladder),
        };
        self.climbing && lost || self.hold_wished(terrain).is_some()
    }

    /// How the body would take hold now, if it would.
    fn hold_wished(&self, terrain: &Terrain) -> Option<Hold> {
        let wish = self.climb_wish();
        if self.climbing || self.reach != Reach::Open || wish.y == 0.0 {
            return None;
        }
        let ladder = self.ladder_here(terrain);
        let inside = ladder.is_some();
        let ladder = ladder.flatten();
        match &self.mode {
            Mode::Air(_) => inside.then_some(Hold::Here),
            Mode::Surface(on) if !on.walkable => {
                (inside && on.grip == Grip::None).then_some(Hold::Here)
            }
            Mode::Surface(on) if wish.y > 0.0 => {
                // Only if that leads off the ground: else he would land again at once.
                let away = self.climbs_away(on.track.normal, ladder, terrain.tuning);
                (inside && away && self.stays_on_ladder(ladder, terrain)).then_some(Hold::Off)
            }
            Mode::Surface(on) => {
                let mesh = self.ground(terrain);
                if !mesh.is_one_way(on.edge) {
                    return None;
                }
                let below = mesh.left(mesh.sym(on.edge))?;
                match mesh.leads_down_from(on.edge) {
                    true => Some(Hold::Below(below)),
                    false => self.ladder_below(on.edge, terrain).map(Hold::Down),
                }
            }
            Mode::Wedge(_) => {
                let away = wish.y > 0.0 && self.climbs_away(DVec2::Y, ladder, terrain.tuning);
                (inside && away).then_some(Hold::Off)
            }
            Mode::Crushed(_) => None,
        }
    }

    /// Whether a climb that begins here, on a ladder of a frame, is not over at once, because it leads over the side of it.
    fn stays_on_ladder(&self, ladder: Option<u32>, terrain: &Terrain) -> bool {
        if self.frame.is_some() && ladder.is_none() {
            return true;
        }
        let mesh = terrain.ground_under(ladder, self.size).climbed(true);
        let (mut climb, v) = match self.beside.iter().find(|b| b.mover() == ladder) {
            None => {
                let at = Air::resting(self.local_position(), self.face(&mesh));
                let touching = self.left_behind(terrain);
                (Air { touching, ..at }, self.local_velocity())
            }
            Some(place) => {
                let (at, v) = self.seen_from(place);
                let touching = place.flight.touching;
                let at = Air::resting(at, place.flight.face);
                (Air { touching, ..at }, v)
            }
        };
        (climb.v0, climb.accel) = (v, self.climb_accel(v, terrain.tuning));
        while let Some((_, Next::Cross(e, since))) = climb.next(mesh)
            && since == 0.0
            && let Some(beyond) = mesh.left(mesh.sym(e))
        {
            climb.face = beyond;
            if !mesh.is_ladder(beyond) {
                return false;
            }
        }
        true
    }

    /// Whether one who took hold of a ladder of a frame here and now would be driven away from ground with this normal, however
    /// both move.
    fn climbs_away(&self, normal: DVec2, ladder: Option<u32>, t: &Motion) -> bool {
        let v = self.velocity() - self.piece_of(ladder).velocity(self.time);
        let accel = self.climb_accel(v, t);
        normal.dot(accel - self.drift_from(ladder).accel) > 0.0
    }

    /// Loses its hold outside of ladders, and takes hold where it wants to and can.
    pub(super) fn mind_ladders(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let rises = self.velocity().y > 0.0;
        let stands = self.supported();
        let open = match self.reach {
            Reach::Open => true,
            Reach::AfterApex => stands || !rises,
            Reach::Anew => stands && !self.control.down,
            Reach::Landed => !self.is_by_ground(terrain) || !self.on_ladder(terrain),
        };
        if open {
            self.reach = Reach::Open;
        }
        if self.mount.is_some() {
            self.end_mount(self.on_ladder(terrain));
        }
        if self.climbing && !self.is_mounting() {
            self.keep_hold(terrain, trace);
            self.mount_as_wished(terrain);
        }
        let Some(hold) = self.hold_wished(terrain) else {
            return;
        };
        self.rebase();
        let mesh = self.ground(terrain);
        let (p, v) = (self.local_position(), self.local_velocity());
        let through = self.segment();
        let ladder = match hold {
            Hold::Below(_) | Hold::Down(_) => self.carrier(),
            _ => self.ladder_here(terrain).flatten(),
        };
        match hold {
            Hold::Here => {}
            Hold::Off => self.fly(p, v, self.face(&mesh), self.left_behind(terrain)),
            Hold::Below(face) => self.fly(p, v, face, [None; 2]),
            Hold::Down(face) => {
                self.fly(p, v, face, [None; 2]);
                self.dismount();
            }
        }
        if let Mode::Air(air) = &mut self.mode {
            air.lock = None;
            air.through = through.filter(|_| matches!(hold, Hold::Below(_) | Hold::Down(_)));
        }
        (self.climbing, self.ladder) = (true, ladder);
        (self.rise, self.coyote_from, self.off_wall) = (None, None, None);
        self.log(EventKind::Climbed, trace);
        self.go_home(terrain);
    }

    /// Who climbs where his ladder is not: on along one of another frame that he is in, else he has lost his hold.
    fn keep_hold(&mut self, terrain: &Terrain, trace: &mut Trace) {
        match self.ladder_here(terrain) {
            None => self.lose_hold(terrain, trace),
            Some(ladder) if ladder == self.ladder => {}
            Some(ladder) => {
                self.rebase();
                self.ladder = ladder;
                self.go_home(terrain);
            }
        }
    }

    /// Whether the body stands, or has come off ground and is not yet apart from it: a lift that brakes under him who has landed on
    /// it would be landed on again, ever sooner, if he took hold of the ladder as soon as it is gone.
    fn is_by_ground(&self, terrain: &Terrain) -> bool {
        let near = |mesh: Ground, s: SegmentId, p: DVec2| {
            mesh.walkable(s) && mesh.track(s).height(p, p, p).0.abs() < APART * (1.0 - 1e-9)
        };
        let beside = self.beside.iter().any(|b| {
            let (mesh, (q, _)) = (b.ground(self.size, terrain), self.seen_from(b));
            let mut touching = b.flight.touching.into_iter().flatten();
            touching.any(|s| near(mesh, s, q))
        });
        self.supported() || beside
    }

    /// When one who has come off ground is apart from it.
    pub(super) fn apart_from_ground(&self, terrain: &Terrain) -> Option<f64> {
        let apart = |b: &Beside, s: SegmentId| {
            let mesh = b.ground(self.size, terrain);
            let air = &b.flight;
            let (c, b, e) = mesh.track(s).height(air.p0, air.v0, air.accel);
            let at = exit(APART - c, -b, -e, air.since).map(|dt| air.t0 + dt);
            at.filter(|&at| mesh.walkable(s) && at > self.time)
        };
        let touched = self.beside.iter().flat_map(|b| {
            let touching = b.flight.touching.into_iter().flatten();
            touching.filter_map(move |s| apart(b, s))
        });
        touched.max_by(f64::total_cmp)
    }

    /// Holds on no longer: in the air, or sliding, from here on.
    fn lose_hold(&mut self, terrain: &Terrain, trace: &mut Trace) {
        // The law changes, also where the event was only a touch.
        self.rebase();
        (self.climbing, self.mount) = (false, None);
        self.reach = Reach::Anew;
        let mesh = self.ground(terrain);
        if let Mode::Surface(on) = &self.mode
            && (!mesh.blocks(on.edge) || mesh.kind(on.segment) == Kind::Region)
        {
            self.come_free(terrain);
        }
        self.log(EventKind::LetGo, trace);
    }

    /// Lets go, if down is held with the jump that was pressed; that is used up.
    pub(super) fn let_go_if_asked(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        let asked = self.climbing && self.control.down;
        if asked {
            self.lose_hold(terrain, trace);
            self.pressed_at = None;
        }
        asked
    }

    /// The acceleration of one who climbs freely: straight towards the velocity that he wishes for.
    fn climb_accel(&self, v: DVec2, t: &Motion) -> DVec2 {
        let miss = self.climb_wish() * t.climb_speed - v;
        match miss == DVec2::ZERO {
            true => DVec2::ZERO,
            false => miss / miss.length() * t.climb_accel,
        }
    }

    /// The accelerations of one who climbs: towards the velocity that he wishes for; along something steep, towards its part
    /// along that.
    pub(super) fn choose_on_ladder(&mut self, t: &Motion) {
        // From the base of the piece: a mere touch leaves the piece as it is.
        let (base, since) = match &self.mode {
            Mode::Air(air) => (air.v0, air.t0),
            Mode::Surface(on) => (self.velocity(), on.t0),
            _ => (self.velocity(), self.time),
        };
        let goal = self.climb_goal(since, t);
        let accel = self.climb_accel(base, t);
        let (carried, shaken) = (self.drift(), self.drift_rounding(since));
        match &mut self.mode {
            Mode::Air(air) => {
                let reached = air.t0 + (goal - air.v0).length() / t.climb_accel;
                air.accel = accel;
                air.limits = match accel == DVec2::ZERO {
                    true => [None; 2],
                    false => [Some((reached, goal.x)), Some((reached, goal.y))],
                };
            }
            Mode::Surface(on) => {
                let goal = goal.dot(on.track.tangent);
                // What carries him bears the wish of the level along.
                let drift = -on.track.tangent.dot(carried.accel);
                let rounding = shaken + ROUNDING * (goal.abs() + on.u0.abs());
                let law = Law::after(on.u0, goal, drift, t.climb_accel, rounding);
                let law = law.up_to_turn(on.u0);
                let left = law.until.zip(law.time_left(on.u0));
                on.accel = law.accel;
                on.limit = left.map(|(until, left)| (on.t0 + left, until));
            }
            Mode::Wedge(_) | Mode::Crushed(_) => {}
        }
    }

    /// Whether one who climbs along something is driven away from it, by more than rounding makes of a drive along it.
    pub(super) fn climbs_off(&self, track: &Track, moment: &Moment, t: &Motion) -> bool {
        let moment = self.as_ladder_sees(moment);
        let goal = self.climb_wish() * t.climb_speed - moment.carried;
        let speed = track.tangent.dot(moment.v - moment.carried).abs();
        let rounding = ROUNDING * (goal.length() + speed);
        let drive = self.climb_accel(moment.v, t) - moment.follows;
        let carried = self.carrier() != self.ladder;
        track.normal.dot(goal) > rounding && (!carried || track.normal.dot(drive) > 0.0)
    }

    /// A moment in the world, in the frame of the ladder.
    fn as_ladder_sees(&self, moment: &Moment) -> Moment {
        let (drift, ladder) = (self.drift(), self.piece_of(self.ladder));
        Moment {
            v: moment.v - ladder.velocity(moment.at),
            carried: drift.velocity(moment.at),
            follows: drift.accel,
            ..*moment
        }
    }

    /// When [`Body::climbs_off`] may change, for a velocity in the world that grows at `rate`: where the wish leads along the
    /// surface as it moves, and where the drive towards it has just the acceleration of that across it.
    pub(super) fn climbing_times(
        &self,
        times: &mut Times,
        normal: DVec2,
        moment: &Moment,
        rate: DVec2,
        t: &Motion,
    ) {
        let moment = self.as_ladder_sees(moment);
        let rate = rate - self.piece_of(self.ladder).accel;
        let (now, wish) = (moment.at, self.climb_wish() * t.climb_speed);
        let leads = normal.dot(wish - moment.carried);
        let rounding = moment.rounding + ROUNDING * (wish - moment.carried).length();
        let drawn = -normal.dot(moment.follows);
        times.linear(now, leads, drawn, &[0.0], rounding);
        times.departs(now, leads, drawn, rounding);
        let (miss, force) = (wish - moment.v, normal.dot(moment.follows));
        let square = |a: DVec2, b: DVec2| {
            let across = normal.dot(a) * normal.dot(b);
            t.climb_accel * t.climb_accel * across - force * force * a.dot(b)
        };
        let [c, b, a] = [
            square(miss, miss),
            -2.0 * square(miss, rate),
            square(rate, rate),
        ];
        times.quadratic(now, c, b, a);
    }

    /// The velocity that one who climbs wishes for, as what carries him at a time sees it: it counts in the frame of the ladder.
    fn climb_goal(&self, at: f64, t: &Motion) -> DVec2 {
        self.climb_wish() * t.climb_speed - self.drift().velocity(at)
    }

    /// Where one who climbs along something wants to go along it: where he wishes to, and where a ladder that moves past takes him.
    fn climb_lead(&self, t: &Motion) -> DVec2 {
        match self.carrier() == self.ladder {
            true => self.climb_wish(),
            false => self.climb_goal(self.time, t),
        }
    }

    /// At the top of a ladder: up onto a one-way in line with it, or on to ground that is near. False if there is none.
    pub(super) fn climb_onto(
        &mut self,
        border: EdgeId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let plain = self.ground(terrain).climbed(false);
        let floor = plain.sym(border);
        if !self.climbing || plain.mesh.blocks(border) {
            return false;
        }
        let platform = segment_at(plain, floor, |_| false);
        let platform = platform.filter(|&s| plain.is_one_way(floor) && plain.walkable(s));
        let Some(segment) = platform else {
            return self.mount(border, terrain);
        };
        self.stand_up_on(floor, segment, terrain, trace);
        true
    }

    /// From the ladder onto ground that is just here.
    pub(super) fn stand_up_on(
        &mut self,
        edge: EdgeId,
        segment: SegmentId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let track = self.ground(terrain).track(segment);
        let s = track.parameter(self.local_position());
        let along = track.tangent.dot(self.local_velocity());
        (self.climbing, self.mount) = (false, None);
        self.settle(segment, edge, s, along, 0.0, terrain, trace);
    }

    /// One who climbs along something steep, or along the end of his ladder, at a joint: onto ground, on if he wishes, past
    /// an end, else he stops.
    pub(super) fn ladder_joint(
        &mut self,
        joint: Joint,
        onward: Option<Onward>,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let mesh = self.ground(terrain);
        if joint
            .next
            .is_some_and(|next| self.climb_onto(next, terrain, trace))
        {
            return;
        }
        if let Some((edge, segment)) = ground_beyond(&joint, mesh) {
            return self.stand_up_on(edge, segment, terrain, trace);
        }
        let Some(on) = onward.filter(|on| on.towards) else {
            let end = joint.next;
            return self.leave(joint, end, terrain, trace);
        };
        let kept = (joint.speed * on.cosine).max(0.0);
        let leads_on = self.climb_lead(terrain.tuning).dot(on.track.tangent) * on.sign > 0.0;
        if leads_on || mesh.walkable(on.segment) {
            let into = joint.lost(kept);
            self.settle(
                on.segment,
                on.edge,
                on.start,
                on.sign * kept,
                into,
                terrain,
                trace,
            );
        } else {
            self.stop(&joint, Some(&on), trace, mesh);
        }
    }
}

/// The ground that begins where the end of a ladder ends, in the direction of the motion: the top of a ledge beside it.
fn ground_beyond(joint: &Joint, mesh: Ground) -> Option<(EdgeId, SegmentId)> {
    let plain = mesh.climbed(false);
    let forward = joint.before.0.signum();
    if forward == 0 || mesh.mesh.kind(joint.segment) != Kind::Region {
        return None;
    }
    let home = mesh.origin(joint.beside);
    let onward = spokes(plain, home).filter(|&out| {
        let (from, to) = (plain.point(home), plain.point(plain.dest(out)));
        delta(from, to).0.signum() == forward
    });
    let mut edges = onward.map(|out| if forward > 0 { out } else { plain.sym(out) });
    edges.find_map(|e| {
        let found = segment_at(plain, e, |_| false).filter(|_| plain.blocks(e))?;
        plain.walkable(found).then_some((e, found))
    })
}
