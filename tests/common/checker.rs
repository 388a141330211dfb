//! An exact checker of meshes that shares no code with them: it reads a mesh through its public face alone and decides
//! everything anew in i128.

#![allow(dead_code, reason = "each test uses its own part")]

use super::slow::{Spot, meets, spot, turn};
use edgewalker::mesh::{EdgeId, FaceId, Kind, Mesh, VertexId};
use std::collections::{HashMap, HashSet};

/// What the checker counted, so that a test can tell that it saw something.
#[derive(Clone, Copy, Debug, Default)]
pub struct Census {
    /// Vertices, with the corners of the world.
    pub vertices: usize,
    /// Undirected edges.
    pub edges: usize,
    /// Triangles.
    pub faces: usize,
    /// Edges along which no feature edge runs.
    pub free_edges: usize,
    /// Pieces of chains.
    pub pieces: usize,
}

/// Positive when d is inside the circle through a, b, c, which turn left: the 3x3 determinant, expanded by its last column.
fn in_circle(a: Spot, b: Spot, c: Spot, d: Spot) -> i128 {
    let row = |p: Spot| {
        let (x, y) = (p.0 - d.0, p.1 - d.1);
        (x, y, x * x + y * y)
    };
    let minor = |p: (i128, i128, i128), q: (i128, i128, i128)| p.0 * q.1 - p.1 * q.0;
    let (a, b, c) = (row(a), row(b), row(c));
    a.2 * minor(b, c) - b.2 * minor(a, c) + c.2 * minor(a, b)
}

/// Checks a mesh: triangles turn left and fill the world once, chains lie within half a step per axis of their segments, all
/// other edges are Delaunay, Euler's formula holds, and who covers what follows from what runs along the edges.
///
/// # Errors
/// The first thing found wrong, in words.
pub fn check(mesh: &Mesh) -> Result<Census, String> {
    let mut census = Census {
        vertices: mesh.vertices().count(),
        ..Census::default()
    };
    let sides = check_faces(mesh, &mut census)?;
    let constrained = check_chains(mesh, &mut census)?;
    check_edges(mesh, &sides, &constrained, &mut census)?;
    let Census {
        vertices,
        edges,
        faces,
        ..
    } = census;
    if vertices + faces + 1 != edges + 2 {
        return Err(format!(
            "Euler: {vertices} vertices, {edges} edges, {faces} faces"
        ));
    }
    Ok(census)
}

/// A directed edge by its ends.
type Ends = (VertexId, VertexId);

/// The faces turn left, no directed edge belongs to two of them, and together they are as large as the world. The result is
/// the face left of each directed edge and the vertex across.
fn check_faces(
    mesh: &Mesh,
    census: &mut Census,
) -> Result<HashMap<Ends, (FaceId, VertexId)>, String> {
    let mut sides = HashMap::new();
    let mut area = 0;
    for face in mesh.faces() {
        let edges = mesh.sides(face);
        let corners = edges.map(|e| mesh.origin(e));
        let [a, b, c] = corners.map(|v| spot(mesh.point(v)));
        if turn(a, b, c) <= 0 {
            return Err(format!("{face:?} does not turn left: {a:?} {b:?} {c:?}"));
        }
        area += turn(a, b, c);
        for i in 0..3 {
            let ends = (corners[i], corners[(i + 1) % 3]);
            let across = corners[(i + 2) % 3];
            if sides.insert(ends, (face, across)).is_some() {
                return Err(format!("two faces are left of {ends:?}"));
            }
        }
        census.faces += 1;
    }
    let spots: Vec<Spot> = mesh.vertices().map(|v| spot(mesh.point(v))).collect();
    let extent = |c: fn(&Spot) -> i128| {
        spots.iter().map(c).max().unwrap_or(0) - spots.iter().map(c).min().unwrap_or(0)
    };
    let world = 2 * extent(|p| p.0) * extent(|p| p.1);
    if area != world {
        return Err(format!("the faces have {area} of {world}"));
    }
    Ok(sides)
}

/// Chains run from end to end through pixels that their segments meet, forwards. The result is the pieces in use, with the
/// gain in winding of each closed feature from their right to their left.
fn check_chains(
    mesh: &Mesh,
    census: &mut Census,
) -> Result<HashMap<Ends, Vec<(u32, i32)>>, String> {
    let mut pieces: HashMap<Ends, Vec<(u32, i32)>> = HashMap::new();
    let mut on_chain: HashSet<VertexId> = mesh.vertices().take(4).collect();
    for feature in mesh.features() {
        let segments = mesh.segments_of(feature);
        let at = |i: usize| mesh.segment(segments[i % segments.len()]);
        let closed = (0..segments.len()).all(|i| at(i).b == at(i + 1).a);
        let gain =
            i32::from(closed && matches!(mesh.kind_of(feature), Some(Kind::Solid | Kind::Region)));
        for &s in segments {
            let (a, b) = (spot(mesh.segment(s).a), spot(mesh.segment(s).b));
            let chain = mesh.chain(s);
            let spots: Vec<Spot> = chain.iter().map(|&v| spot(mesh.point(v))).collect();
            if spots.first() != Some(&a) || spots.last() != Some(&b) {
                return Err(format!("{s:?} has other ends than its chain"));
            }
            if let Some(p) = spots.iter().find(|&&p| !meets(a, b, p)) {
                return Err(format!("{s:?}: its chain strays from its segment to {p:?}"));
            }
            let along = |p: Spot| (p.0 - a.0) * (b.0 - a.0) + (p.1 - a.1) * (b.1 - a.1);
            if !spots.windows(2).all(|pair| along(pair[0]) < along(pair[1])) {
                return Err(format!("{s:?}: its chain turns back"));
            }
            for pair in chain.windows(2) {
                pieces
                    .entry((pair[0], pair[1]))
                    .or_default()
                    .push((feature, gain));
                pieces
                    .entry((pair[1], pair[0]))
                    .or_default()
                    .push((feature, -gain));
                census.pieces += 1;
            }
            on_chain.extend(chain);
        }
    }
    match mesh.vertices().find(|v| !on_chain.contains(v)) {
        Some(v) => Err(format!("{v:?} is on no chain")),
        None => Ok(pieces),
    }
}

/// Each edge has a face on either side (or the outside), is in use or Delaunay, and parts what its uses say.
fn check_edges(
    mesh: &Mesh,
    sides: &HashMap<Ends, (FaceId, VertexId)>,
    pieces: &HashMap<Ends, Vec<(u32, i32)>>,
    census: &mut Census,
) -> Result<(), String> {
    if let Some(ends) = pieces
        .keys()
        .find(|&&(v, w)| !sides.contains_key(&(v, w)) && !sides.contains_key(&(w, v)))
    {
        return Err(format!("the piece {ends:?} is no edge"));
    }
    let nothing = Vec::new();
    for (&(v, w), &(left, across)) in sides {
        let back = sides.get(&(w, v));
        if v < w || back.is_none() {
            census.edges += 1;
        }
        let uses = pieces.get(&(v, w)).unwrap_or(&nothing);
        check_cover(mesh, left, back.map(|b| b.0), uses)?;
        let Some(&(_, opposite)) = back else { continue };
        if uses.is_empty() {
            census.free_edges += 1;
            let [a, b, c, d] = [v, w, across, opposite].map(|v| spot(mesh.point(v)));
            if in_circle(a, b, c, d) > 0 {
                return Err(format!("the free edge {v:?} {w:?} is not Delaunay"));
            }
        }
        let found: Option<EdgeId> = mesh.edge_between(v, w);
        if found.is_none_or(|e| mesh.uses(e).count() != uses.len()) {
            return Err(format!(
                "edge {v:?} {w:?} does not know its {} uses",
                uses.len()
            ));
        }
    }
    census.free_edges /= 2;
    Ok(())
}

/// From the right face (`None` is the outside) to the left one, exactly the features that gain come or go; solid is who has a
/// solid. Features that wind around both sides stay, however often they wind.
fn check_cover(
    mesh: &Mesh,
    left: FaceId,
    right: Option<FaceId>,
    uses: &[(u32, i32)],
) -> Result<(), String> {
    let cover = mesh.cover(left);
    let solid = cover.iter().any(|&f| mesh.kind_of(f) == Some(Kind::Solid));
    if solid != mesh.is_solid(left) {
        return Err(format!(
            "{left:?}: solid {}, covered by {cover:?}",
            mesh.is_solid(left)
        ));
    }
    let beyond = right.map_or(&[][..], |f| mesh.cover(f));
    let changed = |f: &&u32| cover.contains(f) != beyond.contains(f);
    for &f in cover.iter().chain(beyond).filter(changed) {
        let gain: i32 = uses.iter().filter(|u| u.0 == f).map(|u| u.1).sum();
        if (gain > 0) != cover.contains(&f) || gain == 0 {
            return Err(format!(
                "{left:?} gains {gain} of feature {f} from {right:?}"
            ));
        }
    }
    Ok(())
}
