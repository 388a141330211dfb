//! On a surface: along a feature edge, from one vertex of its chain to the next.

use super::body::{Next, Surface};
use super::roots::cover;
use super::terrain::Ground;
use super::vertex::{Heading, ahead};
use glam::DVec2;

impl Surface {
    /// The first of: the vertex ahead, a speed limit.
    pub(super) fn next(&self, mesh: Ground) -> Option<(f64, Next)> {
        let sign = self.sign();
        if sign == 0.0 {
            return None;
        }
        let there = self
            .track
            .parameter_of(mesh.point(ahead(mesh, self.edge, self.heading(sign))));
        let vertex = self
            .reaches(there)
            .map(|dt| (self.t0 + dt.max(self.since), Next::Vertex));
        Next::or_limit(vertex, self.limit.map(|(at, _)| at))
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
        let [from, to] =
            [mesh.origin(self.edge), mesh.dest(self.edge)].map(|v| mesh.point(v).metres());
        let along = to - from;
        // Measured from the lower end, for the mirror's sake.
        let lower = if along.y < 0.0 { to } else { from };
        let depth = -along.perp_dot(p - lower) / along.length_squared();
        p + along.perp() * depth.max(0.0)
    }

    /// Along or against the mesh edges, whose left is free.
    pub(super) fn heading(&self, sign: f64) -> Heading {
        if (sign > 0.0) == self.track.leftward_free {
            Heading::Along
        } else {
            Heading::Against
        }
    }
}
