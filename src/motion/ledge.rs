//! Where walls lead to: over convex corners to further wall, or to the ground on top.

use super::body::Surface;
use super::terrain::Ground;
use super::track::{Axis, Track};
use super::vertex::{Heading, ahead, bridge, segment_at, surface_next, turns_towards};
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

/// Looks beyond the vertex ahead on an edge of a wall. Lips of rounding between a wall and its top are looked past.
pub fn beyond(mesh: Ground, e: EdgeId, heading: Heading, track: &Track) -> Beyond {
    let same_line = |s: SegmentId| mesh.track(s).same_line(track);
    let onward = surface_next(mesh, e, heading)
        .and_then(|next| Some((next, segment_at(mesh, next, same_line)?)));
    let Some((next, s)) = onward else {
        return Beyond::End;
    };
    let directed = |track: &Track| track.heading(heading.sign(track));
    let (before, after) = (directed(track), directed(&mesh.track(s)));
    if same_line(s) {
        return Beyond::Wall(next, s);
    }
    if turns_towards(before, after, heading) {
        return Beyond::End;
    }
    if mesh.walkable(s) {
        return if before.1 > 0 {
            Beyond::Top(next, s)
        } else {
            Beyond::End
        };
    }
    if mesh.is_wall(s) {
        let goes_on = before.1.signum() == after.1.signum();
        return if goes_on {
            Beyond::Wall(next, s)
        } else {
            Beyond::End
        };
    }
    match bridge(mesh, ahead(mesh, e, heading), Some(next), heading) {
        Some((edge, s)) if before.1 > 0 => Beyond::Top(edge, s),
        _ => Beyond::End,
    }
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

    /// The piece further up on the same line that holds a parameter, as an edge of the mesh and its feature edge.
    pub(super) fn piece_above(&self, s: f64, mesh: Ground) -> Option<(EdgeId, SegmentId)> {
        let heading = self.heading(1.0);
        let (mut edge, mut segment) = (self.edge, self.segment);
        while self
            .track
            .parameter_of(mesh.point(ahead(mesh, edge, heading)))
            < s
        {
            edge = surface_next(mesh, edge, heading)?;
            let same_line = |s: SegmentId| s == segment || mesh.track(s).same_line(&self.track);
            let next = segment_at(mesh, edge, same_line)?;
            if !same_line(next) {
                return None;
            }
            segment = next;
        }
        Some((edge, segment))
    }
}
