//! How sharply ground bends away where it was drawn as a curve: what decides whether a walker stays on it.
//!
//! Between two pieces of some length their directions tell. Of short ones the directions are those of rounding, whether to the
//! grid or to the digits of a file: there the curve is seen over a window, from the chord behind the vertex to that ahead of it.

use super::joint::{Joint, Onward};
use super::terrain::Ground;
use super::vertex::{Heading, ahead, behind, segment_at, surface_next};
use crate::mesh::{EdgeId, SegmentId};
use crate::tune::Motion;
use glam::DVec2;

/// Pieces of this length and more tell how the ground runs, m; shorter ones are taken together up to it. Where curves are
/// small, so that their span is set below the usual metre, it is as much less.
fn window(t: &Motion) -> f64 {
    0.02 * t.joint_span.min(1.0)
}

/// At most so many pieces are taken together.
const PIECES: u32 = 64;

/// A stretch of ground on one side of a joint: from where to where, in any unit, and how long it is, m.
struct Stretch {
    along: DVec2,
    length: f64,
}

/// The bend at a joint.
struct Bend {
    before: Stretch,
    after: Stretch,
}

impl Bend {
    /// Whether a walker of a speed stays on it: iff s^2 k <= g cos(slope) + stick, with the slope of the bisector and
    /// k = 2 tan(turn / 2) over the mean length of both stretches, each counted up to the curve span.
    fn holds(&self, speed: f64, t: &Motion) -> bool {
        let unit = |stretch: &Stretch| stretch.along / stretch.along.length();
        let (before, after) = (unit(&self.before), unit(&self.after));
        let tan_half = before.perp_dot(after).abs() / (1.0 + before.dot(after));
        let span = |stretch: &Stretch| stretch.length.min(t.joint_span);
        let curvature = 2.0 * tan_half / (0.5 * (span(&self.before) + span(&self.after)));
        let bisector = before + after;
        let cos_slope = bisector.x.abs() / bisector.length();
        speed * speed * curvature <= t.gravity * cos_slope + t.joint_stick
    }

    /// Whether it turns away from a body that moves with the free side on its left, or on its right.
    fn turns_away(&self, heading: Heading) -> bool {
        let turn = self.before.along.perp_dot(self.after.along);
        match heading {
            Heading::Along => turn < 0.0,
            Heading::Against => turn > 0.0,
        }
    }
}

impl Joint {
    /// Whether a walker stays on the ground where it bends away from him: always, by curvature, or only at rest. `edge`: the
    /// edge of the mesh that he is on. Independent of how finely a curve is drawn.
    pub(super) fn holds(&self, edge: EdgeId, on: &Onward, mesh: Ground, t: &Motion) -> bool {
        let window = window(t);
        let fine = |s: SegmentId| mesh.length(s) < window;
        if t.joint != 1.0 || !fine(self.segment) && !fine(on.segment) {
            return self.holds_onto(on.after, mesh.length(on.segment), mesh, t);
        }
        let back = match self.heading {
            Heading::Along => Heading::Against,
            Heading::Against => Heading::Along,
        };
        let mut before = stretch(mesh, edge, back, window);
        before.along = -before.along;
        let bend = Bend {
            before,
            after: stretch(mesh, on.edge, self.heading, window),
        };
        !bend.turns_away(self.heading) || bend.holds(self.speed, t)
    }

    /// The same for a single feature edge beyond the joint, which may be in another mesh: its direction and its length, m.
    pub(super) fn holds_onto(
        &self,
        after: (i64, i64),
        length: f64,
        mesh: Ground,
        t: &Motion,
    ) -> bool {
        if t.joint == 0.0 {
            return true;
        }
        if t.joint == 2.0 {
            return self.speed == 0.0;
        }
        let stretch = |(x, y): (i64, i64), length| Stretch {
            along: DVec2::new(x as f64, y as f64),
            length,
        };
        let bend = Bend {
            before: stretch(self.before, mesh.length(self.segment)),
            after: stretch(after, length),
        };
        bend.holds(self.speed, t)
    }
}

/// The ground that begins with an edge and goes on in a direction, up to the end of the piece with which it is long enough to tell
/// how it runs.
fn stretch(mesh: Ground, first: EdgeId, heading: Heading, window: f64) -> Stretch {
    let (mut along, mut length) = ((0, 0), 0.0);
    let mut next = Some(first);
    for _ in 0..PIECES {
        let ground = |e| segment_at(mesh, e, |_| false).filter(|&s| mesh.walkable(s));
        let Some((e, s)) = next.and_then(|e| Some((e, ground(e)?))) else {
            break;
        };
        let whole = mesh.length(s) >= window;
        let (from, to) = match whole {
            // The free side is on the left of the way from its end to its start.
            true => {
                let [a, b] = mesh.segment(s).drawn();
                match heading {
                    Heading::Along => (b, a),
                    Heading::Against => (a, b),
                }
            }
            false => {
                let ends = [behind(mesh, e, heading), ahead(mesh, e, heading)];
                let [from, to] = ends.map(|v| mesh.segment(s).drawn_at(mesh.point(v)));
                (from, to)
            }
        };
        let (x, y) = to.vector_from(from);
        along = (along.0 + x, along.1 + y);
        length += (to.metres() - from.metres()).length();
        if length >= window {
            break;
        }
        next = surface_next(mesh, e, heading);
    }
    Stretch {
        along: DVec2::new(along.0 as f64, along.1 as f64),
        length,
    }
}
