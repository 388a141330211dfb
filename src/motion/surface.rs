//! On a surface: along a feature edge, from one vertex of its chain to the next.

use super::body::{Next, Surface};
use super::roots::cover;
use super::terrain::Ground;
use super::vertex::{Heading, ahead, segment_at, surface_next};
use crate::mesh::{EdgeId, SegmentId};
use glam::DVec2;

impl Surface {
    /// The first of: the vertex ahead, a speed limit.
    pub(super) fn next(&self, mesh: Ground) -> Option<(f64, Next)> {
        let sign = self.sign();
        if sign == 0.0 {
            return None;
        }
        let there = self.joint_ahead(mesh, sign);
        let vertex = self
            .reaches(there)
            .map(|dt| (self.t0 + dt.max(self.since), Next::Vertex));
        Next::sooner(vertex, self.limit.map(|(at, _)| (at, Next::Limit)))
    }

    /// The parameter of the vertex ahead: where another feature edge goes on from it, that of the point where the two really
    /// cross, of which the vertex is the rounded place.
    fn joint_ahead(&self, mesh: Ground, sign: f64) -> f64 {
        let heading = self.heading(sign);
        let vertex = mesh.point(ahead(mesh, self.edge, heading));
        let segment = mesh.segment(self.segment);
        if vertex == segment.a || vertex == segment.b {
            return self.track.parameter_of(vertex);
        }
        let next = surface_next(mesh, self.edge, heading);
        let road = |s| mesh.track(s);
        let same_line = |s: SegmentId| s == self.segment || road(s).same_line(&self.track);
        let next = next.and_then(|next| segment_at(mesh, next, same_line));
        match next {
            Some(s) if !same_line(s) => self.track.parameter_at_joint(segment, &road(s), vertex),
            _ => self.track.parameter_of(vertex),
        }
    }

    /// When a parameter ahead is reached, as a time after `t0`.
    pub(super) fn reaches(&self, there: f64) -> Option<f64> {
        let sign = self.sign();
        let distance = ((there - self.s0) * sign).max(0.0);
        let rate = self.track.rate();
        cover(distance, rate * self.u0.abs(), rate * self.accel * sign)
    }

    /// The position at a time, on the free side of the mesh edge too: rounding may have put that up to half a step per axis
    /// before the feature edge, and a flight has to start inside its face.
    pub(super) fn take_off_point(&self, t: f64, mesh: Ground) -> DVec2 {
        let p = self.track.position(self.parameter(t));
        // In a corner it is where both feature edges meet: off one would be into the other.
        if mesh.chain(self.segment).len() == 2 || self.against != 0.0 {
            return p;
        }
        let lifted = beside(mesh, self.edge, p);
        // Under a ceiling of the same face: rather beside this edge than beyond that one.
        let second = mesh.lnext(self.edge);
        let others = [second, mesh.lnext(second)];
        if others
            .iter()
            .any(|&e| mesh.blocks(e) && depth_beyond(mesh, e, lifted) > 0.0)
        {
            return p;
        }
        lifted
    }

    /// Along or against the mesh edges, whose left is free.
    pub(super) fn heading(&self, sign: f64) -> Heading {
        Heading::of(sign, &self.track)
    }
}

/// The position on an edge nearest to one on its right; one on its left as it is.
fn beside(mesh: Ground, e: EdgeId, p: DVec2) -> DVec2 {
    let along = mesh.point(mesh.dest(e)).metres() - mesh.point(mesh.origin(e)).metres();
    let depth = depth_beyond(mesh, e, p) / along.length_squared();
    p + along.perp() * depth.max(0.0)
}

/// How far a position lies on the right of an edge, times its length. Measured from the lower end, for the mirror's sake.
fn depth_beyond(mesh: Ground, e: EdgeId, p: DVec2) -> f64 {
    let [from, to] = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres());
    let along = to - from;
    let lower = if along.y < 0.0 { to } else { from };
    -along.perp_dot(p - lower)
}
