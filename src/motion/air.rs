//! In the air: free faces are crossed, blocking edges are hit.

use super::beside::ROUNDING;
use super::body::{Air, Body, EventKind, Mode, Next, Surface, Trace, Wedge};
use super::change::{Moment, flight};
use super::grip::Grip;
use super::ladder::Reach;
use super::roots::exit;
use super::terrain::{Ground, Terrain};
use super::track::{Track, delta};
use super::vertex::{Bearing, JOINT_STEPS, Sector, gone_into, sector, segment_at};
use crate::geom::{Point, STEP};
use crate::mesh::{EdgeId, SegmentId, VertexId};
use glam::DVec2;
use std::cmp::Ordering;

/// How far a hit on a piece of a feature edge that rounding has displaced may lie from the feature edge itself, m.
pub(super) const DISPLACED: f64 = 4.0 * STEP;

impl Air {
    /// The first of: leaving the face, reaching a speed limit.
    pub(super) fn next(&self, mesh: Ground) -> Option<(f64, Next)> {
        let mut best: Option<(f64, bool, EdgeId)> = None;
        for e in mesh.sides(self.face) {
            let blocks = mesh.blocks(e) && !self.falls_through(mesh, e);
            let Some(at) = self.leaves(mesh, e, blocks) else {
                continue;
            };
            // At a vertex a free edge goes first: whether the corner is hit is for the face behind it to say. Then one ahead. Of
            // two free ones the higher, so that who goes exactly along an edge from there on is above it, as on a floor.
            let depth = |e: EdgeId| match blocks {
                true => 0,
                false => [mesh.origin(e), mesh.dest(e)]
                    .map(|v| -i64::from(mesh.point(v).y))
                    .iter()
                    .sum(),
            };
            let rank = |blocks: bool, e: EdgeId| {
                (blocks, blocks && !self.leads_along(mesh, e, at), depth(e))
            };
            let goes_first = |stops: bool, f: EdgeId| match rank(blocks, e).cmp(&rank(stops, f)) {
                Ordering::Equal => blocks && self.meets_sooner(mesh, at, e, f),
                order => order.is_lt(),
            };
            if best.is_none_or(|(b, stops, f)| at < b || at == b && goes_first(stops, f)) {
                best = Some((at, blocks, e));
            }
        }
        let left = best.map(|(dt, blocks, e)| match blocks {
            true if self.is_beyond(mesh, e, dt, DISPLACED) => {
                let (end, e) = self.passes_lip(mesh, dt).unwrap_or((dt, e));
                (self.t0 + end, Next::Hit(e, end))
            }
            true => (
                self.t0 + self.on_feature_edge(mesh, e, dt),
                Next::Hit(e, dt),
            ),
            false => self
                .passes_end(mesh, e, dt)
                .unwrap_or((self.t0 + dt, Next::Cross(e, dt))),
        });
        let limit = self
            .limits
            .iter()
            .flatten()
            .map(|l| l.0)
            .min_by(f64::total_cmp);
        Next::sooner(left, limit.map(|at| (at, Next::Limit)))
    }

    /// The side over which the parabola leaves its face first, whatever that stops, and when, as a time after `t0`.
    pub(super) fn way_out(&self, mesh: Ground) -> Option<(f64, EdgeId)> {
        let leaves = mesh.sides(self.face).into_iter().filter_map(|e| {
            let (a, b) = (mesh.point(mesh.origin(e)), mesh.point(mesh.dest(e)));
            let (c, b, q) = self.distance(a, b);
            exit(c, b, q, self.since).map(|at| (at, e))
        });
        leaves.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// When the parabola leaves the face over its edge `e`, as a time after `t0`.
    fn leaves(&self, mesh: Ground, e: EdgeId, blocks: bool) -> Option<f64> {
        let (c, b, q) = self.distance(mesh.point(mesh.origin(e)), mesh.point(mesh.dest(e)));
        let over_piece = exit(c, b, q, self.since)?;
        if !blocks {
            return Some(over_piece);
        }
        let Some(left) = self.touched(mesh, e) else {
            return Some(over_piece);
        };
        // Others that share the piece and face the same way are within a step of the one that was left.
        let normal = |s: SegmentId| mesh.track(s).normal;
        let across = |s: SegmentId| normal(s).dot(normal(left)) < 0.5;
        let mut others = mesh.facing(e).filter(|&s| !self.touches(s));
        if others.any(across) {
            return Some(over_piece);
        }
        self.comes_back_to(mesh, left).map(|at| over_piece.max(at))
    }

    fn touches(&self, s: SegmentId) -> bool {
        self.touching.contains(&Some(s))
    }

    /// The feature edge along a mesh edge that the body is not yet apart from.
    fn touched(&self, mesh: Ground, e: EdgeId) -> Option<SegmentId> {
        mesh.facing(e).find(|&s| self.touches(s))
    }

    /// When a feature edge is hit that was just left, whatever the pieces say: they may point anywhere. Heights over it within
    /// a step are rounding and count as none, unless they grow or shrink.
    fn comes_back_to(&self, mesh: Ground, segment: SegmentId) -> Option<f64> {
        let track = mesh.track(segment);
        let (c, b, q) = track.height(self.p0, self.v0, self.accel);
        // In another frame a height above it, and what the velocity and the acceleration have across it, may be rounding too.
        let (highest, grain, flat) = match self.grain > 0.0 {
            true => (
                self.rounding(),
                self.grain + f64::EPSILON * self.t0.abs() * self.accel.length(),
                q.abs() <= ROUNDING * self.accel.length(),
            ),
            false => (0.0, 0.0, false),
        };
        let on_it = (-STEP..=highest).contains(&c);
        let along = on_it && b.abs() <= 16.0 * f64::EPSILON * self.v0.length() + grain;
        let (c, b) = (if on_it { 0.0 } else { c }, if along { 0.0 } else { b });
        exit(c, b, if along && flat { 0.0 } else { q }, self.since)
    }

    /// What rounding makes of the position at the start of the piece, m.
    fn rounding(&self) -> f64 {
        16.0 * f64::EPSILON * self.p0.abs().max_element().max(1.0)
    }

    /// Whether more of an edge lies ahead of the motion than behind it, so long after `t0`.
    fn leads_along(&self, mesh: Ground, e: EdgeId, dt: f64) -> bool {
        let t = self.t0 + dt;
        let [a, b] = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres());
        (0.5 * (a + b) - self.position(t)).dot(self.velocity(t)) > 0.0
    }

    /// Of two pieces that are hit at one time, in a corner, whether the feature edge along the first is met before that along the
    /// second, or faces up more: so that a mirrored body meets the mirrored one.
    fn meets_sooner(&self, mesh: Ground, at: f64, e: EdgeId, f: EdgeId) -> bool {
        let [(a, up), (b, other)] = [e, f].map(|e| {
            let segment = segment_at(mesh, e, |_| false);
            let up = segment.map_or(0.0, |s| mesh.track(s).normal.y);
            (self.on_feature_edge(mesh, e, at), up)
        });
        a < b || a == b && up > other
    }

    /// Whether the body, so long after `t0`, is further beyond an end of an edge than rounding displaces, m. Only an edge that
    /// it touches can be hit there: who flies past a lip of a step comes back to the feature edge much later.
    fn is_beyond(&self, mesh: Ground, e: EdgeId, dt: f64, displaced: f64) -> bool {
        let p = self.position(self.t0 + dt);
        let [a, b] = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres());
        let excess = (p - a).dot(a - b).max((p - b).dot(b - a));
        excess > displaced * (b - a).length()
    }

    /// When the parabola first passes the end of an edge that it touches, before `until`, and that edge.
    fn passes_lip(&self, mesh: Ground, until: f64) -> Option<(f64, EdgeId)> {
        let touched = |&e: &EdgeId| mesh.blocks(e) && self.touched(mesh, e).is_some();
        let sides = mesh.sides(self.face).into_iter().filter(touched);
        let ends = sides.flat_map(|e| {
            let [a, b] = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres());
            [(b - a, a), (a - b, b)].map(|(back, end)| (back, end, e))
        });
        let passes = ends.filter_map(|(back, end, e)| {
            let (c, b) = (back.dot(self.p0 - end), back.dot(self.v0));
            exit(c, b, 0.5 * back.dot(self.accel), self.since).map(|at| (at, e))
        });
        passes
            .filter(|&(at, _)| at > self.since && at < until)
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// When a flight along an edge that it touches, or that it falls through, passes the end of that, where the free edge `e`
    /// begins, and where it leads from there: if it crosses the line of that edge later, at `dt`, and only beyond this end.
    fn passes_end(&self, mesh: Ground, e: EdgeId, dt: f64) -> Option<(f64, Next)> {
        // Its end is a vertex, which rounding has put at most a step off.
        if !self.is_beyond(mesh, e, dt, STEP) {
            return None;
        }
        let there = self.position(self.t0 + dt);
        let away = |w: &VertexId| (mesh.point(*w).metres() - there).length();
        let ends = [mesh.origin(e), mesh.dest(e)].into_iter();
        let end = ends.min_by(|a, b| away(a).total_cmp(&away(b)))?;
        let meets = |e: &EdgeId| mesh.origin(*e) == end || mesh.dest(*e) == end;
        let sides = mesh.sides(self.face);
        let mut at_end = sides.into_iter().filter(meets);
        let along_through = |e: EdgeId| {
            let mut uses = mesh.uses(e);
            self.through.filter(|&s| uses.any(|u| u.segment == s))
        };
        let touched = at_end.find_map(|e| match mesh.blocks(e) {
            true => self.touched(mesh, e),
            false => along_through(e),
        })?;
        let track = mesh.track(touched);
        let along = |p: DVec2| track.parameter(p);
        let (left, past) = (along(self.p0), along(there));
        let mark = track.parameter_of(mesh.point(end));
        let sign = (past - mark).signum();
        let (u, a) = (along(self.v0), along(self.accel));
        let at = exit((mark - left) * sign, -u * sign, -0.5 * a * sign, self.since);
        let at = at.filter(|&at| at < dt)?;
        let bearing = Bearing::of(self.velocity(self.t0 + at), self.accel);
        let spoke = sides.into_iter().find(|&e| mesh.origin(e) == end)?;
        let next = match sector(mesh, spoke, bearing) {
            Sector::Free(face) if face == self.face => return None,
            Sector::Free(face) => Next::Cross(mesh.sym(mesh.sides(face)[0]), at),
            Sector::Solid(out, into) => {
                // The one that it goes into more: a mirrored corner has them the other way round.
                let away = |e: EdgeId| {
                    let s = segment_at(mesh, e, |_| false);
                    s.map_or(0.0, |s| mesh.track(s).normal.dot(bearing.d))
                };
                let struck = if away(into) < away(out) { into } else { out };
                Next::Hit(struck, at)
            }
        };
        Some((self.t0 + at, next))
    }

    /// Signed area distance to the line from `from` to `to`, positive on its left, and its derivatives: c, b, e of [`exit`].
    /// Anchored at the lower point, so that a mirrored world gives the same bits.
    pub(super) fn distance(&self, from: Point, to: Point) -> (f64, f64, f64) {
        let (dx, dy) = delta(from, to);
        let d = DVec2::new(dx as f64, dy as f64);
        let anchor = if dy < 0 { to } else { from };
        (
            d.perp_dot(self.p0 - anchor.metres()),
            d.perp_dot(self.v0),
            0.5 * d.perp_dot(self.accel),
        )
    }

    /// At most how far the body moves between two times after `t0`: the way, not the distance, for a motion along an edge that
    /// turns comes back to where it was.
    pub(super) fn way(&self, from: f64, to: f64) -> f64 {
        let (speed, span) = (self.velocity(self.t0 + from).length(), (to - from).abs());
        (speed + 0.5 * self.accel.length() * span) * span
    }

    /// The time of a hit on a piece of a feature edge is that on the feature edge itself: a piece that was cut lies up to
    /// half a step beside it, and so cuts elsewhere along it change nothing, nor does which of several collinear edges is hit.
    fn on_feature_edge(&self, mesh: Ground, e: EdgeId, dt: f64) -> f64 {
        let Some(s) = segment_at(mesh, e, |_| false) else {
            return dt;
        };
        let (track, edge) = (mesh.track(s), mesh.segment(s));
        let (c, b, q) = track.height(self.p0, self.v0, self.accel);
        // Who starts on it is before it, whatever rounding says; but not who starts behind its line where it has ended.
        let on_it = c >= -STEP && track.past(self.p0, [edge.a, edge.b]) <= STEP;
        let c = if on_it { c.max(0.0) } else { c };
        exit(c, b, q, self.since)
            .filter(|&there| self.way(dt, there) <= DISPLACED)
            .unwrap_or(dt)
    }
}

impl Body {
    /// Over a free edge: no event of the motion, only of the place.
    ///
    /// `since` is the time of the crossing after the piece's start, as it was computed: rounded to an absolute time it would
    /// not tell apart the crossings of several edges about a vertex.
    pub(super) fn cross(&mut self, edge: EdgeId, since: f64, terrain: &Terrain, trace: &mut Trace) {
        let mesh = self.ground(terrain);
        if let Mode::Air(air) = &mut self.mode {
            air.face = mesh
                .left(mesh.sym(edge))
                .expect("a free edge has a face on either side");
            air.since = since;
        }
        trace.crossed += 1;
        self.come_to_place(terrain, trace);
    }

    /// At a blocking edge.
    pub(super) fn hit(&mut self, edge: EdgeId, since: f64, terrain: &Terrain, trace: &mut Trace) {
        let mesh = self.ground(terrain);
        let at = self.local_position();
        let mut accel = DVec2::ZERO;
        if let Mode::Air(air) = &mut self.mode {
            (air.since, accel) = (since, air.accel);
        }
        if self.climb_onto(edge, terrain, trace) {
            return;
        }
        match gone_into(mesh, edge, self.local_velocity(), accel) {
            Some(segment) => self.contact(segment, edge, terrain, trace),
            None => self.wedge(at, edge, terrain, trace),
        }
        self.catch_ledge(terrain, trace);
    }

    /// Meets a feature edge on one of its pieces. At an end of the piece, as rounding goes, the vertex decides.
    fn contact(&mut self, segment: SegmentId, edge: EdgeId, terrain: &Terrain, trace: &mut Trace) {
        let mesh = self.ground(terrain);
        let track = mesh.track(segment);
        let (at, v) = (self.local_position(), self.local_velocity());
        let into = -track.normal.dot(v);
        if let Mode::Air(air) = &mut self.mode
            && into < 0.0
            && !air.touching.contains(&Some(segment))
        {
            // Moving off: only a lip that rounding has left is in the way, less than a step high.
            air.touching[1] = Some(segment);
            return;
        }
        if !self.climbing
            && (self.correct_corner(edge, segment, terrain, trace)
                || self.correct_ledge(edge, segment, terrain, trace))
        {
            return;
        }
        let s = track.parameter(at);
        let ends =
            [edge, mesh.lnext(edge)].map(|e| (track.parameter_of(mesh.point(mesh.origin(e))), e));
        for ((end, spoke), (other, _)) in [(ends[0], ends[1]), (ends[1], ends[0])] {
            if (s - end) * (other - end).signum()
                <= self.rounding_along(&track, self.local_velocity())
                && self.meet_vertex(spoke, segment, terrain, trace)
            {
                return;
            }
        }
        let along = track.tangent.dot(v);
        let held = self.is_held_between(&track, at, along, mesh);
        let (u, into) = (if held { 0.0 } else { along }, into.max(0.0));
        self.settle(segment, edge, s, u, into, terrain, trace);
    }

    /// Whether the velocity that one blocking edge leaves goes into another one, which the body has just left and is not yet
    /// apart from by more than a joint: the solution for two edges at once is rest. Without it a body that rises into a
    /// crevice is thrown from side to side ever faster. Beside that edge, and on its own line, nothing holds.
    fn is_held_between(&self, new: &Track, at: DVec2, along: f64, mesh: Ground) -> bool {
        let Mode::Air(air) = &self.mode else {
            return false;
        };
        air.touching.iter().flatten().any(|&s| {
            let left = mesh.segment(s);
            let track = Track::of(left);
            let (height, away, _) = track.height(at, new.tangent * along, DVec2::ZERO);
            let beside = track.past(at, [left.a, left.b]);
            let near = height.abs().max(beside) <= f64::from(JOINT_STEPS) * STEP;
            near && away < 0.0 && !track.same_line(new)
        })
    }

    /// Comes to a surface, at a parameter, with a speed along it and a speed into it. Ground is landed on; what cannot be
    /// stood on is slid along. [`Body::part_if_pulled`] decides whether it lasts.
    #[allow(clippy::too_many_arguments)]
    pub(super) fn settle(
        &mut self,
        segment: SegmentId,
        edge: EdgeId,
        s0: f64,
        u0: f64,
        into: f64,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let mesh = self.ground(terrain);
        let walkable = mesh.walkable(segment);
        self.off_wall = None;
        if walkable {
            (self.rise, self.coyote_from) = (None, None);
            if std::mem::take(&mut self.climbing) {
                self.reach = Reach::Landed;
            }
            self.log(EventKind::Landed(into), trace);
        } else {
            self.log(EventKind::Hit(into), trace);
        }
        let place = (segment, mesh.track(segment), edge);
        self.mode = Mode::Surface(Surface::new(self.time, place, s0, u0, walkable));
    }

    /// Off a steep surface as soon as something pulls the body from it.
    pub(super) fn part_if_pulled(&mut self, terrain: &Terrain, trace: &mut Trace) {
        let Mode::Surface(on) = &self.mode else {
            return;
        };
        let held = on.walkable || on.grip != Grip::None || self.is_pinned(on.track.normal);
        if !held && self.pulled_off(&on.track, &self.moment(&on.track, on.u0), terrain) {
            let (segment, v, face) = (
                on.segment,
                on.track.tangent * on.u0,
                self.face(&self.ground(terrain)),
            );
            let p = on.take_off_point(self.time, self.ground(terrain));
            self.come_off_wall(terrain);
            self.fly(p, v, face, [Some(segment), None]);
            self.log(EventKind::Parted, trace);
        }
    }

    /// Whether gravity and the active push together point away from a steep surface. The drag of a released stick alone
    /// lifts nobody off what does not move off itself, but it may hold one on: in flight the whole acceleration must lead away.
    pub(super) fn pulled_off(&self, track: &Track, moment: &Moment, terrain: &Terrain) -> bool {
        if self.climbing {
            return self.climbs_off(track, moment, terrain.tuning);
        }
        let (x, y) = flight(self, moment, terrain.tuning);
        let recedes = track.normal.dot(moment.carried) < -moment.rounding;
        let push = match self.control.run != 0.0 || recedes {
            true => x.accel,
            false => 0.0,
        };
        let away = |x: f64| track.normal.dot(DVec2::new(x, y.accel) - moment.follows) > 0.0;
        away(push) && away(x.accel)
    }

    /// Held from here on, until a jump.
    pub(super) fn wedge(&mut self, at: DVec2, edge: EdgeId, terrain: &Terrain, trace: &mut Trace) {
        let face = self
            .ground(terrain)
            .left(edge)
            .expect("free on the left of a blocking edge");
        (self.rise, self.off_wall, self.climbing) = (None, None, false);
        self.mode = Mode::Wedge(Wedge { at, face });
        self.log(EventKind::Wedged, trace);
    }
}
