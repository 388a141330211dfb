//! A flight that meets a vertex: a touch, a landing on one of its two edges, or rest between them.

use super::body::{Body, Mode, Trace};
use super::terrain::{Ground, Terrain};
use super::track::Track;
use super::vertex::{Bearing, Sector, sector, segment_at, surface_next};
use crate::mesh::{EdgeId, SegmentId, VertexId};
use glam::DVec2;

impl Body {
    /// The wall that has stopped a body on a surface, where it still stands against it.
    pub(super) fn wall_beside(&self, mesh: Ground) -> Option<SegmentId> {
        let Mode::Surface(on) = &self.mode else {
            return None;
        };
        let stopped = on.against != 0.0 && on.u0 == 0.0 && on.accel == 0.0;
        let wall = surface_next(mesh, on.edge, on.heading(on.against)).filter(|_| stopped)?;
        segment_at(mesh, wall, |_| false)
    }

    /// At a vertex, exactly or as rounding goes. `spoke` leaves it, with the free face that the body comes from on its left;
    /// it has come to a piece of `segment` there. False if the vertex does not decide anything: then it is a contact with that.
    ///
    /// If the motion leads into a free sector it was only a touch. Else the body meets the two edges that bound the
    /// solid sector: it goes on along one that it can follow, walkable ones first; it rests where there is none (a V),
    /// and on a tip whose two sides it strikes at once.
    pub(super) fn meet_vertex(
        &mut self,
        spoke: EdgeId,
        segment: SegmentId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) -> bool {
        let mesh = self.ground(terrain);
        let Mode::Air(air) = &mut self.mode else {
            return false;
        };
        let accel = air.accel;
        // The velocity at this very moment: the absolute time is too coarse for one that has turned since the piece began.
        let heading = Bearing::of(air.v0 + accel * air.since, accel);
        let (out, into) = match sector(mesh, spoke, heading) {
            // Again: here rounding keeps it on the piece.
            Sector::Free(face) if face == air.face && air.touching.contains(&Some(segment)) => {
                return false;
            }
            Sector::Free(face) => {
                air.face = face;
                air.touching[1] = Some(segment);
                trace.crossed += 1;
                return true;
            }
            Sector::Solid(out, into) => (out, into),
        };
        let vertex = mesh.origin(out);
        let sides = [out, into].map(|e| self.meet(e, vertex, accel, terrain));
        let [Some(a), Some(b)] = sides else {
            return false;
        };
        if !a.struck && !b.struck {
            return false;
        }
        let both = [&a, &b];
        let tip = both
            .iter()
            .all(|m| m.struck && m.outward > 0.0 && !m.walkable);
        let follows = |m: &&Meeting| m.struck && (m.outward >= 0.0 || m.walkable) && !tip;
        let best = both.into_iter().filter(follows);
        match best.max_by(|a, b| a.rank().partial_cmp(&b.rank()).expect("no NaN in a motion")) {
            Some(m) => {
                let other = if m.edge == a.edge { &b } else { &a };
                let s = m.track.parameter_at_joint(
                    mesh.segment(m.segment),
                    &other.track,
                    mesh.point(vertex),
                );
                let balanced = a.rank() == b.rank();
                let along = if m.outward > 0.0 && !balanced {
                    m.along
                } else {
                    0.0
                };
                self.settle(m.segment, m.edge, s, along, m.into, terrain, trace);
            }
            None if self.climbing => self.stop_at(&a, &b, vertex, terrain, trace),
            None => {
                let at = a.track.corner(&b.track, mesh.point(vertex));
                self.wedge(at, out, terrain, trace);
            }
        }
        true
    }

    /// One who climbs, between two edges that both lead back: he stops on one that he is not driven away from, against the
    /// other.
    fn stop_at(
        &mut self,
        a: &Meeting,
        b: &Meeting,
        vertex: VertexId,
        terrain: &Terrain,
        trace: &mut Trace,
    ) {
        let mesh = self.ground(terrain);
        let stays = |m: &Meeting| {
            (
                m.struck && !self.climbs_off(&m.track, &self.now(), terrain.tuning),
                m.rank(),
            )
        };
        let (a, b) = if stays(b) > stays(a) { (b, a) } else { (a, b) };
        let s = a
            .track
            .parameter_at_joint(mesh.segment(a.segment), &b.track, mesh.point(vertex));
        self.settle(a.segment, a.edge, s, 0.0, a.into.max(0.0), terrain, trace);
        if let Mode::Surface(on) = &mut self.mode {
            let away = (mesh.origin(a.edge) == vertex) == a.track.leftward_free;
            on.against = if away { -1.0 } else { 1.0 };
        }
    }

    /// How a motion at a vertex meets one of the edges there.
    fn meet(
        &self,
        edge: EdgeId,
        vertex: VertexId,
        accel: DVec2,
        terrain: &Terrain,
    ) -> Option<Meeting> {
        let mesh = self.ground(terrain);
        let v = self.local_velocity();
        let segment = segment_at(mesh, edge, |_| false)?;
        let track = mesh.track(segment);
        let into = -track.normal.dot(v);
        // Along the edge and away from the vertex: with the free side on the left for the edge that starts there.
        let away = if (mesh.origin(edge) == vertex) == track.leftward_free {
            1.0
        } else {
            -1.0
        };
        Some(Meeting {
            segment,
            track,
            edge,
            into,
            along: track.tangent.dot(v),
            outward: track.tangent.dot(Bearing::of(v, accel).d) * away,
            struck: into > 0.0 || into == 0.0 && track.normal.dot(accel) < 0.0,
            walkable: mesh.walkable(segment),
            normal_y: track.normal.y,
        })
    }
}

/// How a motion at a vertex meets one of its edges.
struct Meeting {
    segment: SegmentId,
    track: Track,
    edge: EdgeId,
    /// Speed into it.
    into: f64,
    /// Speed along its tangent.
    along: f64,
    /// Positive if the motion leads along it, away from the vertex.
    outward: f64,
    /// The motion goes into it.
    struck: bool,
    walkable: bool,
    normal_y: f64,
}

impl Meeting {
    /// Which of two edges a body goes on along; equal only for mirror images, between which it balances.
    fn rank(&self) -> (bool, bool, bool, f64, f64) {
        (
            self.struck,
            self.outward >= 0.0,
            self.walkable,
            self.normal_y,
            self.into,
        )
    }
}
