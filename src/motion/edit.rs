//! Edits of the level under a body: its place is found again in the new mesh.
//!
//! Ids of faces and edges do not outlive an edit that touches them. So a body is *anchored* before the edit, in terms of
//! grid points and features, and *brought home* after it. A body whose surroundings are as they were keeps every bit. One
//! that has lost its ground is in the air with its velocity unchanged; one whose ground goes on under another feature stays;
//! one that a solid was put over is moved to the nearest free place and told so.

use super::body::{Body, Event, EventKind, Mode, Surface, Trace};
use super::grip::Grip;
use super::size::free_face;
use super::terrain::{Ground, Terrain};
use super::vertex::{Bearing, JOINT_STEPS, Sector, sector, segment_at, spokes, surface_next};
use crate::geom::{Point, STEP};
use crate::mesh::{EdgeId, FaceId, Place, Segment, SegmentId};
use glam::DVec2;
use std::cmp::Ordering;

/// What a body holds on to, in terms that outlive an edit; see [`Body::anchor`].
#[derive(Clone, Debug, PartialEq)]
pub struct Anchor {
    /// The face of its place in the level, whatever carries it, and what there was to see from it.
    face: FaceId,
    seen: Seen,
    /// The feature edge of the level that it is on, or that presses on a rider.
    segment: Option<Segment>,
    /// Those that it has just left or touched in flight.
    touching: [Option<Segment>; 2],
    /// The one-way that it is falling through.
    through: Option<Segment>,
}

/// The surroundings that decide about a body at rest or on its way to the next event.
#[derive(Clone, Debug, Default, PartialEq)]
struct Seen {
    /// Sides of the face: the edge, its end points, whether it blocks.
    sides: Vec<(EdgeId, Point, Point, bool)>,
    /// The edges that hold a body which is stopped or wedged.
    held_by: Vec<(Point, Point)>,
}

impl Body {
    /// What the body holds on to, before an edit of the level. To be taken with the meshes as they are before it.
    pub fn anchor(&self, terrain: &Terrain) -> Anchor {
        let ground = self.level_ground(terrain);
        let face = self.level_face(&ground);
        let named = |s: SegmentId| *ground.segment(s);
        let (segment, touching) = self.in_contact();
        Anchor {
            face,
            seen: self.seen(ground, face),
            segment: segment.map(named),
            touching: touching.map(|s| s.map(named)),
            through: self.falls_through().map(named),
        }
    }

    fn falls_through(&self) -> Option<SegmentId> {
        match &self.mode {
            Mode::Air(air) => air.through,
            _ => None,
        }
    }

    /// The feature edge of the level that the body is on, or that presses on a rider; and those that it has just left or touched.
    fn in_contact(&self) -> (Option<SegmentId>, [Option<SegmentId>; 2]) {
        match (self.level_entry(), &self.mode) {
            (Some(level), _) => (level.contact.map(|c| c.segment), level.flight.touching),
            (None, Mode::Air(air)) => (None, air.touching),
            (None, _) => (self.segment(), [None; 2]),
        }
    }

    /// Takes its place in the meshes as they are after an edit of the level. An event only if its place is no more.
    pub fn rehome(&mut self, anchor: &Anchor, terrain: &Terrain, trace: &mut Trace) {
        let ground = self.level_ground(terrain);
        self.meetings.clear();
        if self.is_untouched(anchor, ground) && !self.has_lost_ledge(terrain) {
            return self.come_to_place(terrain, trace);
        }
        match &self.mode {
            _ if self.frame.is_some() => self.ride_again(anchor, terrain, trace),
            Mode::Surface(_) => self.stand_again(anchor, terrain, trace),
            Mode::Air(_) => self.fly_on(anchor, terrain, trace),
            Mode::Wedge(_) => self.come_loose(EventKind::Parted, terrain, trace),
            Mode::Crushed(_) => self.lie(ground),
        }
    }

    /// Crushed: where it lies, whatever is there now.
    fn lie(&mut self, ground: Ground) {
        if let Mode::Crushed(crushed) = &mut self.mode {
            let face = match ground.locate(crushed.at, None) {
                Some(Place::Face(face)) => Some(face),
                Some(Place::Edge(e)) => ground.left(e).or(ground.left(ground.sym(e))),
                Some(Place::Vertex(v)) => spokes(ground, v).find_map(|e| ground.left(e)),
                None => None,
            };
            crushed.face = face.unwrap_or(crushed.face);
        }
    }

    /// Whether nothing that decides about the body's next event has changed.
    fn is_untouched(&self, anchor: &Anchor, ground: Ground) -> bool {
        let same = |s: SegmentId, old: &Segment| again(ground, old) == Some(s);
        let (segment, touching) = self.in_contact();
        let known = touching.iter().zip(&anchor.touching);
        let through = self.falls_through();
        let mut known = known.chain([(&segment, &anchor.segment), (&through, &anchor.through)]);
        known.all(|(now, old)| now.zip(*old).is_none_or(|(s, old)| same(s, &old)))
            && ground.is_face(anchor.face)
            && !ground.is_solid(anchor.face)
            && self.seen(ground, anchor.face) == anchor.seen
    }

    /// On a moving solid: the same ride, at a place in the new mesh of the level, if there is one.
    fn ride_again(&mut self, anchor: &Anchor, terrain: &Terrain, trace: &mut Trace) {
        let ground = terrain.ground(self.size);
        let (p, v) = (self.position(), self.velocity());
        let again = |old: Option<Segment>| old.and_then(|old| again(ground, &old));
        let (pressing, touching) = (again(anchor.segment), anchor.touching.map(again));
        match free_face(ground, p, v, DVec2::NEG_Y) {
            Ok(face) if !is_in_solid(ground, p) => {
                self.rebase();
                self.take_level_place(face, pressing, touching, ground);
                self.refresh(terrain, trace);
            }
            _ => {
                self.come_free(terrain);
                self.climbing &= self.ladder.is_none();
                self.go_home(terrain);
                self.move_out(p, v, terrain, trace);
            }
        }
    }

    fn seen(&self, ground: Ground, face: FaceId) -> Seen {
        let ends = |e: EdgeId| (ground.point(ground.origin(e)), ground.point(ground.dest(e)));
        let side = |e: EdgeId| (e, ends(e).0, ends(e).1, ground.blocks(e));
        let sides: Vec<_> = ground.sides(face).map(side).to_vec();
        let held_by = match &self.mode {
            Mode::Surface(on) if self.frame.is_none() && on.against != 0.0 => {
                // The edge itself may be no more: then there is nothing to compare.
                let known = sides.iter().any(|s| s.0 == on.edge && s.3);
                let next = || surface_next(ground, on.edge, on.heading(on.against));
                let wall = if known { next() } else { None };
                wall.into_iter().map(ends).collect()
            }
            Mode::Wedge(wedge) if self.frame.is_none() => {
                let near = |p: Point| (p.metres() - wedge.at).abs().max_element() <= STEP;
                let corner = ground.sides(face).map(|e| ground.origin(e));
                let corner = corner.into_iter().find(|&v| near(ground.point(v)));
                let about = corner.into_iter().flat_map(|v| spokes(ground, v));
                let blocking = about.filter(|&e| ground.blocks(e) || ground.blocks(ground.sym(e)));
                let mut found: Vec<_> = blocking.map(ends).collect();
                found.sort_unstable();
                found
            }
            _ => Vec::new(),
        };
        Seen { sides, held_by }
    }

    /// On a surface: further along the same feature edge if that is still there and free, else along another one on the same
    /// line, else in the air.
    fn stand_again(&mut self, anchor: &Anchor, terrain: &Terrain, trace: &mut Trace) {
        let ground = self.level_ground(terrain);
        let Mode::Surface(on) = &mut self.mode else {
            return;
        };
        let s = on.parameter(self.time);
        let same = anchor.segment.and_then(|old| again(ground, &old));
        let seen = anchor.seen.sides.iter().find(|side| side.0 == on.edge);
        let was = seen.map(|&(_, from, to, _)| [from, to]);
        let found = same
            .and_then(|segment| {
                let edge = super::size::piece_at(ground, segment, s, &on.track, was)?;
                Some((edge, segment))
            })
            .or_else(|| on_line(ground, on, s));
        let Some((edge, segment)) = found else {
            let kind = if self.supported() {
                EventKind::Left
            } else {
                EventKind::Parted
            };
            return self.come_loose(kind, terrain, trace);
        };
        let is_same = Some(segment) == same;
        (on.edge, on.segment) = (edge, segment);
        if is_same && on.against == 0.0 && on.grip == Grip::None {
            return self.come_to_place(terrain, trace);
        }
        // Another feature may have other traits, and the wall may be gone: a new piece, at the same place and speed.
        self.rebase();
        if let Mode::Surface(on) = &mut self.mode {
            on.against = 0.0;
        }
        self.refresh(terrain, trace);
    }

    /// In flight: the same parabola, in a face of the new mesh.
    fn fly_on(&mut self, anchor: &Anchor, terrain: &Terrain, trace: &mut Trace) {
        let ground = self.level_ground(terrain);
        let (p, v) = (self.position(), self.velocity());
        let now = self.time;
        let Mode::Air(air) = &mut self.mode else {
            return;
        };
        air.touching = anchor
            .touching
            .map(|old| old.and_then(|old| again(ground, &old)));
        air.through = anchor.through.and_then(|old| again(ground, &old));
        match free_face(ground, p, v, air.accel) {
            Ok(face) if !is_in_solid(ground, p) => {
                (air.face, air.since) = (face, now - air.t0);
                self.come_to_place(terrain, trace);
            }
            _ => self.move_out(p, v, terrain, trace),
        }
    }

    /// What held the body is no more: in the air, where it is, as fast as it was.
    fn come_loose(&mut self, kind: EventKind, terrain: &Terrain, trace: &mut Trace) {
        let ground = self.level_ground(terrain);
        let (p, v) = (self.position(), self.velocity());
        if kind == EventKind::Left {
            self.coyote_from = Some(self.time);
        }
        match free_face(ground, p, v, DVec2::NEG_Y) {
            Ok(face) if !is_in_solid(ground, p) => {
                self.fly(p, v, face, [None; 2]);
                self.log(kind, trace);
                self.refresh(terrain, trace);
            }
            _ => self.move_out(p, v, terrain, trace),
        }
    }

    /// Out of the solid that was put over the body, to the nearest point of its rim. A step or less is rounding, and no event.
    fn move_out(&mut self, p: DVec2, v: DVec2, terrain: &Terrain, trace: &mut Trace) {
        let ground = self.level_ground(terrain);
        let Some((edge, at)) = nearest_rim(ground, p, v) else {
            return self.hold(terrain, trace);
        };
        let rim = ground
            .left(edge)
            .expect("a rim has a free face on its left");
        let segment = segment_at(ground, edge, |_| false);
        // At a vertex it goes on where its velocity leads, or meets the corner at once.
        let mut spokes = [edge, ground.lnext(edge)].into_iter();
        let spoke = spokes.find(|&e| ground.point(ground.origin(e)).metres() == at);
        let ahead = spoke.map(|e| sector(ground, e, Bearing::of(v, DVec2::NEG_Y)));
        let (face, shut) = match ahead {
            Some(Sector::Free(face)) => (face, false),
            Some(Sector::Solid(..)) => (rim, true),
            None => (rim, false),
        };
        self.rise = None;
        self.fly(at, v, face, [segment, None]);
        let first = trace.events.len();
        if !self.is_free_beside(terrain) {
            self.crush(terrain, trace);
        } else if shut {
            let falls = self.flight_accel(terrain.tuning);
            if let Mode::Air(air) = &mut self.mode {
                air.accel = falls;
            }
            self.hit(edge, 0.0, terrain, trace);
        }
        let (time, depth) = (self.time, (self.position() - p).length());
        if depth > 2.0 * STEP {
            let kind = EventKind::Embedded(depth);
            trace.events.insert(first, Event { time, kind });
        }
        self.refresh(terrain, trace);
    }
}

/// A feature edge after an edit, or in the mesh of another size: the one with the same source and ends.
pub(super) fn again(ground: Ground, old: &Segment) -> Option<SegmentId> {
    let s = ground.segment_of(old.feature, old.source)?;
    (ground.segment(s) == old).then_some(s)
}

/// Whether a position is strictly inside a solid face.
fn is_in_solid(ground: Ground, p: DVec2) -> bool {
    matches!(ground.locate(p, None), Some(Place::Face(f)) if ground.is_solid(f))
}

/// Another feature edge on the line of a surface, with its edge of the mesh, that is free at the body's parameter: what a floor
/// of several layers leaves when one of them goes.
fn on_line(ground: Ground, on: &Surface, s: f64) -> Option<(EdgeId, SegmentId)> {
    let p = on.track.position(s);
    let reach = f64::from(JOINT_STEPS) * STEP;
    let holds = |e: EdgeId| {
        let [a, b] =
            [ground.origin(e), ground.dest(e)].map(|v| on.track.parameter_of(ground.point(v)));
        ground.blocks(e) && a.min(b) - reach <= s && s <= a.max(b) + reach
    };
    let mut found = None;
    let nearness = |e: EdgeId| Nearness::of(ground, e, p, DVec2::ZERO);
    ground.outwards(ground.locate(p, None)?, nearness, |e, near| {
        if near.distance > reach {
            return true;
        }
        let same_line = |s: SegmentId| ground.track(s).same_line(&on.track);
        found = [e, ground.sym(e)]
            .into_iter()
            .filter(|&e| holds(e))
            .find_map(|e| {
                let segment = segment_at(ground, e, same_line)?;
                same_line(segment).then_some((e, segment))
            });
        found.is_some()
    });
    found
}

/// The nearest place on the rim of the free faces: the edge, with the free face on its left, and the point. Of two equally near
/// ones the higher one, then the one that the velocity leads to.
fn nearest_rim(ground: Ground, p: DVec2, v: DVec2) -> Option<(EdgeId, DVec2)> {
    let mut found = None;
    let nearness = |e: EdgeId| Nearness::of(ground, e, p, v);
    ground.outwards(ground.locate(p, None)?, nearness, |e, _| {
        let rim = [e, ground.sym(e)]
            .into_iter()
            .find(|&e| ground.mesh.blocks(e));
        found = rim.map(|e| (e, nearest_on(ground, e, p)));
        found.is_some()
    });
    found
}

/// The nearest point of an edge, measured from its lower end, or of equally low ones the nearer, for the mirror's sake.
pub(super) fn nearest_on(ground: Ground, e: EdgeId, p: DVec2) -> DVec2 {
    let [a, b] = [ground.origin(e), ground.dest(e)].map(|v| ground.point(v).metres());
    let nearer = (b.x - p.x).abs() < (a.x - p.x).abs();
    let (from, to) = match b.y < a.y || b.y == a.y && nearer {
        true => (b, a),
        false => (a, b),
    };
    let along = to - from;
    let share = (p - from).dot(along) / along.length_squared();
    from + along * share.clamp(0.0, 1.0)
}

/// How near an edge is to a position: smaller comes first. Of equally near edges that with the higher point, then that to which
/// a velocity leads, then the more level one, then the one that goes up: two that meet at the nearest point are told apart alike
/// in a mirrored world.
#[derive(PartialEq)]
struct Nearness {
    distance: f64,
    height: f64,
    leads: f64,
    level: f64,
    /// The heights of its ends together, in steps.
    top: i64,
    /// Tells apart what is equally near, the same way after any sequence of edits.
    ends: [Point; 2],
}

impl Nearness {
    fn of(ground: Ground, e: EdgeId, p: DVec2, v: DVec2) -> Nearness {
        let at = nearest_on(ground, e, p);
        let ends = [ground.origin(e), ground.dest(e)].map(|v| ground.point(v));
        let along = ends[1].metres() - ends[0].metres();
        Nearness {
            distance: (at - p).length(),
            height: at.y,
            leads: (at - p).dot(v),
            level: along.x.abs() / along.length(),
            top: ends.iter().map(|p| i64::from(p.y)).sum(),
            ends,
        }
    }
}

impl Eq for Nearness {}

impl Ord for Nearness {
    fn cmp(&self, other: &Nearness) -> Ordering {
        let by = |a: f64, b: f64| a.total_cmp(&b);
        by(self.distance, other.distance)
            .then(by(other.height, self.height))
            .then(by(other.leads, self.leads))
            .then(by(other.level, self.level))
            .then(other.top.cmp(&self.top))
            .then(self.ends.cmp(&other.ends))
    }
}

impl PartialOrd for Nearness {
    fn partial_cmp(&self, other: &Nearness) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
