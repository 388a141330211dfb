//! Where walls lead to: over convex corners to further wall, or to the ground on top.

use super::body::Surface;
use super::terrain::Ground;
use super::track::{Axis, Track, wide_cross};
use super::vertex::{Heading, ahead, bridge, past_lips, segment_at, surface_next, turns_towards};
use crate::geom::Point;
use crate::mesh::{EdgeId, SegmentId};

/// What is beyond the vertex ahead on a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Beyond {
    /// More wall: on the same line, or turning away from the body and still leading the same way, up or down.
    Wall(EdgeId, SegmentId),
    /// Ground on which the body can stand, the wall leading up to it and turning away from the body.
    Top(EdgeId, SegmentId),
    /// Anything else: a corner, a ceiling, a tip, the world's border.
    End,
}

/// Looks beyond the vertex ahead on an edge of a wall, past the lips that rounding leaves there.
pub fn beyond(mesh: Ground, e: EdgeId, heading: Heading, track: &Track) -> Beyond {
    let same_line = |s: SegmentId| mesh.track(s).same_line(track);
    let at = |e: EdgeId| Some((e, segment_at(mesh, e, same_line)?));
    let home = ahead(mesh, e, heading);
    let Some((next, s)) = surface_next(mesh, e, heading).and_then(at) else {
        return Beyond::End;
    };
    let here = mesh.facing(e).find(|&s| same_line(s));
    let sign = heading.sign(track);
    let before = here.map_or_else(|| track.heading(sign), |s| mesh.heading(s, track, sign));
    let judge = |(e, s)| judge(mesh, e, s, heading, (track, before));
    if !same_line(s) {
        let far = past_lips(mesh, home, next, heading).and_then(at);
        match far.filter(|far| far.1 != s).and_then(judge) {
            None | Some(Beyond::End) => {}
            Some(found) => return found,
        }
    }
    judge((next, s)).unwrap_or_else(|| match bridge(mesh, home, Some(next), heading) {
        Some((edge, s)) if heading.sign(track) * track.tangent.y > 0.0 => Beyond::Top(edge, s),
        _ => Beyond::End,
    })
}

/// What an edge is to the wall that leads to it, of which the road and the direction up to there are known; `None` for what is
/// neither a wall nor ground, but turns away.
fn judge(
    mesh: Ground,
    e: EdgeId,
    s: SegmentId,
    heading: Heading,
    (track, before): (&Track, (i64, i64)),
) -> Option<Beyond> {
    let next = mesh.track(s);
    if next.same_line(track) {
        return Some(Beyond::Wall(e, s));
    }
    let after = mesh.heading(s, &next, heading.sign(&next));
    if turns_towards(before, after, heading) {
        return Some(Beyond::End);
    }
    if mesh.walkable(s) {
        return Some(match before.1 > 0 {
            true => Beyond::Top(e, s),
            false => Beyond::End,
        });
    }
    let goes_on = before.1.signum() == after.1.signum();
    mesh.is_wall(s).then_some(match goes_on {
        true => Beyond::Wall(e, s),
        false => Beyond::End,
    })
}

/// The ground on top of a wall.
pub struct Top {
    /// The edge of the ground that begins at the top, and its feature edge.
    pub edge: EdgeId,
    /// The feature edge of the ground.
    pub segment: SegmentId,
    /// The last stretch of the wall.
    pub wall: Track,
    /// Where both meet.
    pub vertex: Point,
    /// The height of that, m.
    pub height: f64,
}

/// The ground on top of the wall that `e` is an edge of, if the wall ends there and no higher than `highest`, m.
pub fn top_above(mesh: Ground, e: EdgeId, track: &Track, highest: f64) -> Option<Top> {
    let heading = Heading::of(track.tangent.y, track);
    let (mut e, mut wall) = (e, *track);
    // Each stretch of wall leads further up, so this ends.
    loop {
        let vertex = mesh.point(ahead(mesh, e, heading));
        let height = vertex.metres().y;
        if height > highest {
            return None;
        }
        match beyond(mesh, e, heading, &wall) {
            Beyond::Wall(next, s) => (e, wall) = (next, mesh.track(s)),
            Beyond::Top(edge, segment) => {
                return Some(Top {
                    edge,
                    segment,
                    wall,
                    vertex,
                    height,
                });
            }
            Beyond::End => return None,
        }
    }
}

impl Surface {
    /// Steeper than 45 degrees: the parameter is the height.
    pub(super) fn is_upright(&self) -> bool {
        self.track.axis == Axis::Y
    }

    /// The piece further up on the same line, lips of rounding apart, that holds a parameter: as an edge of the mesh and its
    /// feature edge.
    pub(super) fn piece_above(&self, s: f64, mesh: Ground) -> Option<(EdgeId, SegmentId)> {
        let heading = self.heading(1.0);
        let (mut edge, mut segment, mut track) = (self.edge, self.segment, self.track);
        while track.parameter_of(mesh.point(ahead(mesh, edge, heading))) < s {
            let Beyond::Wall(next, onward) = beyond(mesh, edge, heading, &track) else {
                return None;
            };
            (edge, segment, track) = (next, onward, mesh.track(onward));
            let [own, there] = [
                mesh.heading(self.segment, &self.track, 1.0),
                mesh.heading(segment, &track, 1.0),
            ];
            if wide_cross(own, there) != 0 || track.axis != self.track.axis {
                return None;
            }
        }
        Some((edge, segment))
    }
}
