//! Turning about a vertex through free faces: the next edge of a surface, the sector of a direction, the joints that
//! rounding leaves. Everything here is decided by topology and exact signs.

use super::terrain::Ground;
use super::track::{Track, delta, dot, wide_cross};
use crate::geom::Point;
use crate::mesh::{EdgeId, FaceId, Segment, SegmentId, VertexId};
use glam::DVec2;

/// Rises, drops and gaps of at most this many grid steps between walkable edges count as joints: the one geometric
/// constant of the motion, about 30 micrometres. It heals the lips that rounding leaves at T-junctions.
pub const JOINT_STEPS: i32 = 2;

/// Along a surface, with the free side on the left of its mesh edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heading {
    /// Along the edges: free side on the left.
    Along,
    /// Against the edges.
    Against,
}

impl Heading {
    /// That of a motion along a road towards growing (1) or falling (-1) parameters.
    pub fn of(sign: f64, track: &Track) -> Heading {
        match (sign > 0.0) == track.leftward_free {
            true => Heading::Along,
            false => Heading::Against,
        }
    }

    /// The sign of the parameter's change along a road.
    pub fn sign(self, track: &Track) -> f64 {
        match (self == Heading::Along) == track.leftward_free {
            true => 1.0,
            false => -1.0,
        }
    }
}

/// The vertex that an edge of a surface leads to.
pub fn ahead(mesh: Ground, e: EdgeId, heading: Heading) -> VertexId {
    match heading {
        Heading::Along => mesh.dest(e),
        Heading::Against => mesh.origin(e),
    }
}

/// The vertex that an edge of a surface comes from.
pub fn behind(mesh: Ground, e: EdgeId, heading: Heading) -> VertexId {
    ahead(mesh, mesh.sym(e), heading)
}

/// The edge that continues a surface beyond the vertex ahead: the first blocking one when turning from `e` through the
/// free faces about that vertex. Left of it is free, like left of `e`.
///
/// ```text
///       \  free /
///        \ f1  / f0            e --> V : Along. From e's left face f0 clockwise about V
///    next \   /                (here e comes from the right) over free edges to `next`.
///          \ /
///  ---------V<------ e
///    solid
/// ```
///
/// `None` where the surface ends: at the free end of a one-way the turn comes round to its back.
pub fn surface_next(mesh: Ground, e: EdgeId, heading: Heading) -> Option<EdgeId> {
    let beyond = |f| match heading {
        Heading::Along => mesh.lnext(f),
        Heading::Against => mesh.lnext(mesh.lnext(f)),
    };
    let mut f = beyond(e);
    while !mesh.blocks(f) {
        if f == mesh.sym(e) {
            return None;
        }
        f = beyond(mesh.sym(f));
    }
    Some(f)
}

/// The feature edge that a body meets at a blocking mesh edge with the free side on its left: `prefer` if it runs there,
/// else the best of those that face it. Walkable ones come first, then belts and features with a friction of their own,
/// which may be drawn on a floor, then longer ones, then what [`Ground::rank`] says: so neither ids of the mesh nor the order of
/// features or of their insertion matter to the motion. `None` at the world's border.
pub fn segment_at(
    mesh: Ground,
    e: EdgeId,
    prefer: impl Fn(SegmentId) -> bool,
) -> Option<SegmentId> {
    let rank = |&s: &SegmentId| {
        let segment = mesh.segment(s);
        let d = delta(segment.a, segment.b);
        (
            prefer(s),
            mesh.walkable(s),
            mesh.drives(segment.feature),
            dot(d, d),
            mesh.rank(segment),
            std::cmp::Reverse((segment.feature, segment.source)),
        )
    };
    let mut facing = mesh.facing(e);
    let first = facing.next()?;
    match facing.next() {
        // Nearly everywhere it is the only one.
        None => Some(first),
        Some(second) => [first, second].into_iter().chain(facing).max_by_key(rank),
    }
}

/// The feature edge along a mesh edge that a motion leads into, from rest or along it by its acceleration: not the best of them,
/// if the body moves off that.
pub fn gone_into(mesh: Ground, edge: EdgeId, v: DVec2, accel: DVec2) -> Option<SegmentId> {
    let away = |s: SegmentId| {
        let normal = mesh.track(s).normal;
        let along = normal.dot(v) == 0.0;
        normal.dot(if along { accel } else { v })
    };
    let best = segment_at(mesh, edge, |_| false)?;
    match away(best) > 0.0 {
        true => segment_at(mesh, edge, |s| away(s) < 0.0),
        false => Some(best),
    }
}

/// The free faces about a vertex that can be reached from one of them by turning about it, either way, until an edge blocks
/// (or all around it). One-ways block from one side only: what is reached from a face need not reach that face.
struct Fan {
    /// Each face with its clockwise and its counter-clockwise spoke, counter-clockwise in order.
    faces: Vec<(FaceId, EdgeId, EdgeId)>,
    /// The blocking edge out of the vertex at the clockwise end and the one into it at the counter-clockwise end.
    ends: Option<(EdgeId, EdgeId)>,
}

/// The fan that holds the left face of `spoke`, an edge out of the vertex.
fn fan(mesh: Ground, spoke: EdgeId) -> Fan {
    let mut first = spoke;
    let mut all_around = false;
    while !all_around && !mesh.blocks(first) {
        first = mesh.oprev(first);
        all_around = first == spoke;
    }
    let mut faces = Vec::new();
    let mut out = first;
    // What lies clockwise of the spoke has been reached from it, whatever would stop the way back.
    let mut stops = false;
    while let Some(face) = mesh.left(out) {
        stops |= out == spoke && !all_around;
        let next = mesh.onext(out);
        faces.push((face, out, next));
        if stops && mesh.blocks(mesh.sym(next)) {
            return Fan {
                faces,
                ends: Some((first, mesh.sym(next))),
            };
        }
        out = next;
        if out == first {
            break;
        }
    }
    Fan { faces, ends: None }
}

/// The two blocking edges that bound the free faces about a vertex, of which the left face of `spoke` is one: out of it and into it.
pub fn fan_ends(mesh: Ground, spoke: EdgeId) -> Option<(EdgeId, EdgeId)> {
    fan(mesh, spoke).ends
}

/// Where a direction leads from a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sector {
    /// Into a free face.
    Free(FaceId),
    /// Into the solid between two blocking edges that have free on their left: one out of the vertex, one into it.
    Solid(EdgeId, EdgeId),
}

/// A direction with its tie-breaker: `d`, or the side to which `then` bends it where it runs exactly along a spoke.
#[derive(Clone, Copy, Debug)]
pub struct Bearing {
    /// Direction of motion.
    pub d: DVec2,
    /// Acceleration.
    pub then: DVec2,
}

impl Bearing {
    /// Of a motion that starts with a velocity, or from rest.
    pub fn of(velocity: DVec2, acceleration: DVec2) -> Bearing {
        let d = if velocity == DVec2::ZERO {
            acceleration
        } else {
            velocity
        };
        Bearing {
            d,
            then: acceleration,
        }
    }

    /// Positive if the bearing is counter-clockwise of the spoke, negative if clockwise; exact.
    fn turn(&self, spoke: (i64, i64)) -> f64 {
        let sign = |v: DVec2| {
            let origin = robust::Coord { x: 0.0, y: 0.0 };
            let spoke = robust::Coord {
                x: spoke.0 as f64,
                y: spoke.1 as f64,
            };
            robust::orient2d(origin, spoke, robust::Coord { x: v.x, y: v.y })
        };
        let first = sign(self.d);
        if first != 0.0 { first } else { sign(self.then) }
    }

    /// Whether the bearing lies in the wedge from one spoke counter-clockwise to another, less than half a turn on.
    fn within(&self, from: (i64, i64), to: (i64, i64)) -> bool {
        self.turn(from) >= 0.0 && self.turn(to) <= 0.0
    }
}

/// Where a bearing leads from the origin of `spoke`, among the free faces connected with that edge's left face.
pub fn sector(mesh: Ground, spoke: EdgeId, bearing: Bearing) -> Sector {
    let fan = fan(mesh, spoke);
    let vector = |e: EdgeId| delta(mesh.point(mesh.origin(e)), mesh.point(mesh.dest(e)));
    let hit = fan
        .faces
        .iter()
        .find(|(_, from, to)| bearing.within(vector(*from), vector(*to)));
    match (hit, fan.ends) {
        (Some(&(face, ..)), _) => Sector::Free(face),
        (None, Some((out, into))) => Sector::Solid(out, into),
        (None, None) => Sector::Free(fan.faces[0].0),
    }
}

/// The face that a bearing leads into from the origin of `spoke`; where it leads into the solid, the one on the left of that.
pub fn face_towards(mesh: Ground, spoke: EdgeId, bearing: Bearing) -> Option<FaceId> {
    match sector(mesh, spoke, bearing) {
        Sector::Free(face) => Some(face),
        Sector::Solid(..) => mesh.left(spoke),
    }
}

/// Looks past the lips and slits that rounding leaves at a vertex: a walkable edge within [`JOINT_STEPS`] of it that
/// goes on in the given direction, and its feature edge.
///
/// First along the surface beyond `next`, if it goes on, as long as it stays in the box about the vertex; then across slits
/// to vertices joined with this one by a free edge.
pub fn bridge(
    mesh: Ground,
    home: VertexId,
    next: Option<EdgeId>,
    heading: Heading,
) -> Option<(EdgeId, SegmentId)> {
    next.and_then(|next| along_surface(mesh, next, heading, mesh.point(home)))
        .or_else(|| across_slit(mesh, home, heading))
}

/// Whether a feature edge is no longer than a joint is wide: a walker passes over it if ground goes on beyond.
pub fn is_lip(segment: &Segment) -> bool {
    near(segment.a, segment.b)
}

/// The edge of a surface that leads out of the reach of a joint: `next`, or one beyond the lips that rounding leaves there.
pub fn past_lips(mesh: Ground, home: VertexId, next: EdgeId, heading: Heading) -> Option<EdgeId> {
    let mut e = next;
    // As for `along_surface`.
    for _ in 0..50 {
        if !near(mesh.point(ahead(mesh, e, heading)), mesh.point(home)) {
            return Some(e);
        }
        e = surface_next(mesh, e, heading)?;
    }
    None
}

fn near(p: Point, home: Point) -> bool {
    p.x.abs_diff(home.x) <= JOINT_STEPS as u32 && p.y.abs_diff(home.y) <= JOINT_STEPS as u32
}

fn along_surface(
    mesh: Ground,
    next: EdgeId,
    heading: Heading,
    home: Point,
) -> Option<(EdgeId, SegmentId)> {
    let mut e = next;
    // The box holds 25 grid points, and the surface passes each at most once on either side of a collapsed corridor.
    for _ in 0..50 {
        let ground = walkable_at(mesh, e).filter(|&s| !is_lip(mesh.segment(s)));
        if let Some(s) = ground {
            return Some((e, s));
        }
        if !near(mesh.point(ahead(mesh, e, heading)), home) {
            return None;
        }
        e = surface_next(mesh, e, heading)?;
    }
    None
}

fn across_slit(mesh: Ground, home: VertexId, heading: Heading) -> Option<(EdgeId, SegmentId)> {
    let from = mesh.point(home);
    let onward = |p: Point| {
        near(p, from)
            && if heading == Heading::Along {
                p.x > from.x
            } else {
                p.x < from.x
            }
    };
    let rims = spokes(mesh, home)
        .map(|e| mesh.dest(e))
        .filter(|&w| onward(mesh.point(w)));
    let edges = rims.flat_map(|w| spokes(mesh, w)).map(|out| {
        if heading == Heading::Along {
            out
        } else {
            mesh.sym(out)
        }
    });
    let walkable = edges
        .filter(|&e| mesh.blocks(e))
        .filter_map(|e| walkable_at(mesh, e).map(|s| (e, s)));
    walkable.min_by_key(|&(e, s)| {
        let w = mesh.point(behind(mesh, e, heading));
        (
            w.y.abs_diff(from.y),
            w.x.abs_diff(from.x),
            mesh.segment(s).feature,
            mesh.segment(s).source,
        )
    })
}

fn walkable_at(mesh: Ground, e: EdgeId) -> Option<SegmentId> {
    segment_at(mesh, e, |_| false).filter(|&s| mesh.walkable(s))
}

/// The edges out of a vertex, counter-clockwise.
pub fn spokes(mesh: Ground<'_>, v: VertexId) -> impl Iterator<Item = EdgeId> + '_ {
    let first = mesh.vertex_edge(v);
    std::iter::successors(Some(first), move |&e| {
        Some(mesh.onext(e)).filter(|&n| n != first)
    })
}

/// Whether the surface turns towards the body at a vertex (a concave corner), given the exact directions of motion before
/// and after it.
pub fn turns_towards(before: (i64, i64), after: (i64, i64), heading: Heading) -> bool {
    let turn = wide_cross(before, after);
    match heading {
        Heading::Along => turn > 0,
        Heading::Against => turn < 0,
    }
}
