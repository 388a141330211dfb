//! Changes of size: allowed iff the mesh of the new size says that the place is free. They shift a body by no more than a joint,
//! before a wall.

use super::air::DISPLACED;
use super::body::{Air, Body, EventKind, Mode, Next, Size, SpawnError, Surface, Trace, Wedge};
use super::edit::again;
use super::grip::Grip;
use super::roots::exit;
use super::terrain::{Ground, Terrain};
use super::track::{Track, delta};
use super::vertex::{
    Bearing, Heading, JOINT_STEPS, Sector, ahead, face_towards, fan_ends, sector, segment_at,
    spokes, surface_next,
};
use crate::geom::{Point, STEP};
use crate::mesh::{EdgeId, FaceId, Kind, Place, SegmentId, VertexId};
use glam::DVec2;

/// The free face that holds a position, or borders it where it lies on an edge or a vertex; towards `v`, then `accel`. On
/// a one-way it is the one before its front.
///
/// A position up to a grid step inside a solid, where only the rounding of a chain has put it, counts as on its border.
pub(super) fn free_face(
    mesh: Ground,
    p: DVec2,
    v: DVec2,
    accel: DVec2,
) -> Result<FaceId, SpawnError> {
    free_face_at(mesh, p, Bearing::of(v, accel), f64::INFINITY)
}

/// The same, for a position that is known to be off the feature edges themselves but for some rounding, m.
pub(super) fn free_face_at(
    mesh: Ground,
    p: DVec2,
    bearing: Bearing,
    rounding: f64,
) -> Result<FaceId, SpawnError> {
    if !p.is_finite() {
        return Err(SpawnError::Outside);
    }
    let free = |f: Option<FaceId>| f.filter(|&f| !mesh.is_solid(f));
    let found = match mesh.locate(p, None).ok_or(SpawnError::Outside)? {
        Place::Face(f) => free(Some(f))
            .or_else(|| beside(mesh, f, p, rounding))
            .or_else(|| about(mesh, corner_near(mesh, f, p)?, bearing)),
        Place::Edge(e) => {
            let sides = [e, mesh.sym(e)];
            let front = sides.into_iter().find(|&e| mesh.blocks(e));
            let mut sides = front.into_iter().chain(sides);
            sides.find_map(|e| free(mesh.left(e)))
        }
        Place::Vertex(w) => {
            if let Some(e) = one_way_spoke(mesh, w) {
                return face_towards(mesh, e, bearing).ok_or(SpawnError::Solid);
            }
            about(mesh, w, bearing)
        }
    };
    found.ok_or(SpawnError::Solid)
}

/// The free face about a vertex into which a bearing leads, else one of them.
fn about(mesh: Ground, w: VertexId, bearing: Bearing) -> Option<FaceId> {
    let is_free = |e: &EdgeId| mesh.left(*e).is_some_and(|f| !mesh.is_solid(f));
    let mut fans = spokes(mesh, w).filter(is_free);
    let first = fans.next()?;
    let leads = |e: EdgeId| match sector(mesh, e, bearing) {
        Sector::Free(f) => Some(f),
        Sector::Solid(..) => None,
    };
    leads(first)
        .or_else(|| fans.find_map(leads))
        .or(mesh.left(first))
}

/// The corner of a face that is at most a step away.
fn corner_near(mesh: Ground, f: FaceId, p: DVec2) -> Option<VertexId> {
    let corners = mesh.sides(f).map(|e| mesh.origin(e)).into_iter();
    let away = |w: &VertexId| (mesh.point(*w).metres() - p).length();
    corners
        .filter(|w| away(w) <= STEP)
        .min_by(|a, b| away(a).total_cmp(&away(b)))
}

/// An edge out of a vertex that has the front of a one-way beside its left face.
fn one_way_spoke(mesh: Ground, w: VertexId) -> Option<EdgeId> {
    let front = |e: EdgeId| {
        if mesh.is_one_way(e) {
            return Some(e);
        }
        // It comes in here: its front is clockwise of this spoke.
        mesh.is_one_way(mesh.sym(e)).then(|| mesh.oprev(e))
    };
    spokes(mesh, w).find_map(front)
}

/// The free face across an edge of a solid one that is at most a step away, where the position is on the free side of a feature
/// edge along that but for rounding.
fn beside(mesh: Ground, solid: FaceId, p: DVec2, rounding: f64) -> Option<FaceId> {
    mesh.sides(solid)
        .into_iter()
        .map(|e| mesh.sym(e))
        .filter(|&e| mesh.blocks(e))
        .find_map(|e| {
            let (a, b) = (mesh.point(mesh.origin(e)), mesh.point(mesh.dest(e)));
            let (dx, dy) = delta(a, b);
            let d = DVec2::new(dx as f64, dy as f64);
            let depth = -d.perp_dot(p - a.metres()) / d.length();
            let outside = |s| mesh.track(s).height(p, p, p).0 >= -rounding;
            mesh.left(e)
                .filter(|_| depth <= STEP && mesh.facing(e).any(outside))
        })
}

/// The piece of a feature edge at a parameter that has a free face beside it, as the mesh edge with that face on its left.
/// A body in a corner may stand up to a joint's width beyond the rounded vertex where the piece ends.
///
/// At a vertex two pieces qualify. One that shares more than that vertex with the piece that the body was on, if its ends
/// are known, goes first: a wall may stand on the vertex, and the body is on one side of it.
pub(super) fn piece_at(
    mesh: Ground,
    segment: SegmentId,
    s: f64,
    track: &Track,
    was: Option<[Point; 2]>,
) -> Option<EdgeId> {
    let beyond = |from: f64, to: f64| (from.min(to) - s).max(s - from.max(to)).max(0.0);
    let apart = |from: f64, to: f64| {
        was.is_some_and(|was| {
            let [a, b] = was.map(|p| track.parameter_of(p));
            from.max(to).min(a.max(b)) <= from.min(to).max(a.min(b))
        })
    };
    pieces(mesh, segment, track)
        .filter(|&(.., free)| free)
        .map(|(from, to, edge, _)| (apart(from, to), beyond(from, to), edge))
        .filter(|&(_, beyond, _)| beyond <= f64::from(JOINT_STEPS) * STEP)
        .min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)))
        .map(|(.., edge)| edge)
}

/// The pieces of a feature edge, from its start: parameters of both ends, the mesh edge with the free side on its left,
/// and whether it is free there.
fn pieces<'a>(
    mesh: Ground<'a>,
    segment: SegmentId,
    track: &'a Track,
) -> impl Iterator<Item = (f64, f64, EdgeId, bool)> + 'a {
    mesh.mesh.chain(segment).windows(2).filter_map(move |ends| {
        let e = mesh.edge_between(ends[1], ends[0])?;
        let [from, to] = [ends[0], ends[1]].map(|v| track.parameter_of(mesh.point(v)));
        Some((from, to, e, mesh.blocks(e)))
    })
}

/// The parameter of a body that may stand up to a joint's width beyond the end of its piece; not behind the wall there, which for
/// another size may begin a little before the one that has stopped it.
fn before_wall(mesh: Ground, on: &Surface) -> f64 {
    let [a, b] =
        [mesh.origin(on.edge), mesh.dest(on.edge)].map(|v| on.track.parameter_of(mesh.point(v)));
    let sign = match on.s0 {
        s if s > a.max(b) => 1.0,
        s if s < a.min(b) => -1.0,
        s => return s,
    };
    let heading = Heading::of(sign, &on.track);
    let wall = surface_next(mesh, on.edge, heading).and_then(|e| segment_at(mesh, e, |_| false));
    let wall = wall.map(|s| mesh.track(s));
    let p = on.track.position(on.s0);
    let is_behind = |wall: &Track| {
        wall.normal.dot(on.track.tangent * sign) < 0.0 && wall.height(p, p, p).0 < 0.0
    };
    wall.filter(is_behind).map_or(on.s0, |wall| {
        let vertex = mesh.point(ahead(mesh, on.edge, heading));
        on.track
            .parameter_at_joint(mesh.segment(on.segment), &wall, vertex)
    })
}

impl Body {
    /// Crouches or stands up as the control asks, if it can.
    pub(super) fn resize_as_wished(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let wish = self.wished_size();
        if wish == self.size {
            return;
        }
        self.follow(terrain);
        if self.fits_beside(wish, terrain) && self.fit(wish, terrain) {
            self.take_places(wish, terrain);
            self.size = wish;
            self.log(EventKind::Resized(wish), trace);
        }
    }

    /// Whether the body would have another size if there were room.
    pub(super) fn waits_for_room(&self) -> bool {
        self.wished_size() != self.size
    }

    /// Down means crouch on the ground; in the air it only keeps a body crouched. A climb onto a ledge is ended as it was begun.
    fn wished_size(&self) -> Size {
        if matches!(self.mode, Mode::Crushed(_)) || self.grip() == Grip::Over {
            return self.size;
        }
        let may = self.supported() || self.size == Size::Crouch;
        if self.control.down && may && !self.climbing {
            Size::Crouch
        } else {
            Size::Stand
        }
    }

    /// Takes its place in the mesh of another size. False, and nothing changed, if there is no room.
    fn fit(&mut self, size: Size, terrain: &Terrain) -> bool {
        let mesh = terrain
            .ground_under(self.carrier(), size)
            .climbed(self.climbing)
            .with_ladder(self.ladder == self.carrier());
        self.rebase();
        let (p, v, carrier) = (self.local_position(), self.local_velocity(), self.carrier());
        let on_border = self
            .segment()
            .is_some_and(|s| self.ground(terrain).kind(s) == Kind::Region);
        if let Mode::Surface(on) = &mut self.mode
            && !on_border
        {
            let old = *terrain.ground_under(carrier, self.size).segment(on.segment);
            if let Some(segment) = again(mesh, &old) {
                let from = terrain.ground_under(carrier, self.size);
                let was = [from.origin(on.edge), from.dest(on.edge)].map(|v| from.point(v));
                let edge = piece_at(mesh, segment, on.s0, &on.track, Some(was));
                if let Some(edge) = edge {
                    // What stopped the old size may not stop the new one.
                    (on.edge, on.segment, on.against) = (edge, segment, 0.0);
                    on.s0 = before_wall(mesh, on);
                }
                return edge.is_some();
            }
        }
        if let Some(wedge) = self.same_wedge(mesh, terrain) {
            self.mode = Mode::Wedge(wedge);
            return true;
        }
        // Not on anything that both sizes share: in the air, then, where it is.
        let down = DVec2::new(0.0, -1.0);
        let Ok(face) = free_face_at(mesh, p, Bearing::of(v, down), self.rounding()) else {
            return false;
        };
        let face = self.same_side(face, mesh, terrain);
        match &mut self.mode {
            Mode::Air(air) => {
                let old = terrain.ground_under(carrier, self.size);
                let same = |s: Option<SegmentId>| again(mesh, old.segment(s?));
                (air.face, air.touching) = (face, air.touching.map(same));
                air.through = same(air.through);
            }
            _ => self.fly(p, v, face, [None; 2]),
        }
        true
    }

    /// The same corner between the same two feature edges in the mesh of another size, where a body is wedged now.
    fn same_wedge(&self, new: Ground, terrain: &Terrain) -> Option<Wedge> {
        let sides = self.sides_of_wedge(terrain)?.map(|(side, _)| side);
        let old = self.ground(terrain);
        let corner = old.point(old.origin(sides[0].edge));
        let Place::Vertex(w) = new.locate(corner.metres(), None)? else {
            return None;
        };
        let [a, b] = sides.map(|side| again(new, old.segment(side.segment)));
        let holds = |e: EdgeId, s: Option<SegmentId>| new.facing(e).any(|f| Some(f) == s);
        let between = |&e: &EdgeId| {
            let free = new.left(e).is_some_and(|f| !new.is_solid(f));
            let ends = fan_ends(new, e).filter(|_| free);
            ends.is_some_and(|(out, into)| holds(out, a) && holds(into, b))
        };
        let face = spokes(new, w).find(between).and_then(|e| new.left(e))?;
        let at = self.local_position();
        Some(Wedge { at, face })
    }

    /// A body that waits to stand up does so as soon as there is room, within the tick.
    pub(super) fn sooner_if_clear(
        &self,
        next: Option<(f64, Next)>,
        terrain: &Terrain,
    ) -> Option<(f64, Next)> {
        if self.wished_size() == self.size {
            return next;
        }
        let until = next.map_or(f64::INFINITY, |n| n.0);
        let clear = match &self.mode {
            Mode::Surface(on) => self.clear_along(on, terrain),
            Mode::Air(air) => self.clear_of_solids(air, until, terrain).map(|at| {
                // Where only rounding tells that place from here, what is here in the way is there in the way too.
                let way = air.way(self.time - air.t0, at - air.t0);
                match at > self.time && way > self.rounding() {
                    true => (at, None),
                    false => (air.a_step_on(self.time), None),
                }
            }),
            Mode::Wedge(_) | Mode::Crushed(_) => None,
        };
        // Where other frames are in the way, room in its own is not enough.
        let clear = clear.filter(|&(at, _)| at > self.time || self.beside.is_empty());
        let beside = self.clear_beside(until, terrain).map(|at| (at, None));
        let clear = clear.into_iter().chain(beside);
        clear
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .filter(|&(at, _)| at < until)
            .map(|(at, parameter)| (at, Next::Clear(parameter)))
            .or(next)
    }

    /// When a flight comes out of what is in the way of the standing body. Along a wall that it touches it is on the free side.
    fn clear_of_solids(&self, air: &Air, until: f64, terrain: &Terrain) -> Option<f64> {
        let mesh = self.ground(terrain);
        let normals = air.touching.iter().flatten();
        let normals = normals.map(|&s| mesh.track(s).normal);
        let aside = normals.sum::<DVec2>() * (STEP / 16.0);
        clear_in_flight(air, aside, self.time, until, terrain.ground(Size::Stand))
    }

    /// At the place where there is room: exactly there, whatever rounding has made of the parameter.
    pub(super) fn come_clear(&mut self, parameter: Option<f64>) {
        self.rebase();
        if let (Mode::Surface(on), Some(s)) = (&mut self.mode, parameter) {
            on.s0 = s;
        }
    }

    /// When the first piece ahead is reached that is free for the standing body, and its parameter.
    fn clear_along(&self, on: &Surface, terrain: &Terrain) -> Option<(f64, Option<f64>)> {
        let [low, high] =
            [Size::Crouch, Size::Stand].map(|s| terrain.ground_under(self.carrier(), s));
        let old = low.segment(on.segment);
        let segment = high.segment_of(old.feature, old.source)?;
        let here = on.parameter(self.time);
        let sign = on.sign();
        let ahead = pieces(high, segment, &on.track)
            .filter(|p| p.3)
            .map(|(from, to, ..)| {
                if sign > 0.0 {
                    from.min(to)
                } else {
                    from.max(to)
                }
            });
        let nearest = ahead
            .filter(|&s| (s - here) * sign > 0.0)
            .min_by(|a, b| (a * sign).total_cmp(&(b * sign)))?;
        on.reaches(nearest).map(|dt| (on.t0 + dt, Some(nearest)))
    }
}

impl Air {
    /// When the body has moved by about a step: what did not decide here may do so there.
    pub(super) fn a_step_on(&self, now: f64) -> f64 {
        let speed = self.velocity(now).length() + (self.accel.length() * STEP).sqrt();
        now + STEP / speed
    }

    /// When the body comes out of the feature edge along an edge: about when it comes over that, `at`.
    fn comes_out(&self, mesh: Ground, e: EdgeId, at: f64) -> f64 {
        let Some(s) = segment_at(mesh, e, |_| false) else {
            return at;
        };
        let (c, b, q) = mesh.track(s).height(self.p0, self.v0, self.accel);
        let out = exit(-c, -b, -q, self.since);
        out.filter(|&out| self.way(at, out) <= DISPLACED)
            .unwrap_or(at)
    }
}

/// When a parabola comes out of the solids of a mesh: a walk through its solid faces, so far aside of it. Not after `until`.
pub(super) fn clear_in_flight(
    air: &Air,
    aside: DVec2,
    now: f64,
    until: f64,
    mesh: Ground,
) -> Option<f64> {
    // Exactly on an edge the face ahead of it counts.
    let ahead = now + (air.a_step_on(now) - now) / 16.0;
    let found = [now, ahead].into_iter().find_map(|from| {
        match mesh.locate(air.position(from) + aside, None)? {
            Place::Face(face) => Some((face, from)),
            _ => None,
        }
    });
    let (face, from) = found?;
    if !mesh.is_solid(face) {
        return Some(from);
    }
    let mut way = Air {
        face,
        since: from - air.t0,
        p0: air.p0 + aside,
        ..air.clone()
    };
    while way.t0 + way.since < until {
        let (at, e) = way.way_out(mesh)?;
        let out = mesh.sym(e);
        way.face = mesh.left(out)?;
        if !mesh.is_solid(way.face) {
            return Some(way.t0 + air.comes_out(mesh, out, at));
        }
        way.since = at;
    }
    None
}
