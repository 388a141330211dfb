//! Where a new body is put: as its place was drawn. A position at the height of ground is on that ground, wherever the grid has
//! put either of them ([`crate::geom::drawn`]).

use super::body::{Body, Control, Crushed, Mode, Size, SpawnError, Trace, Wedge};
use super::edit::nearest_on;
use super::ladder::Reach;
use super::mover::Ride;
use super::size::free_face_at;
use super::terrain::{Ground, Terrain};
use super::track::wide_cross;
use super::vertex::{Bearing, spokes};
use crate::geom::STEP;
use crate::geom::drawn::{Drawn, PER_MICROMETRE, SLACK};
use crate::mesh::{EdgeId, FaceId, Place, Segment};
use glam::DVec2;

/// How far from where they were drawn rounding may have put two things, m.
const WIDTH: f64 = SLACK as f64 * STEP;

/// A place for a body: its position and the free face there.
type Spot = (DVec2, FaceId);

impl Body {
    /// A body at rest in the air, its foot at `at` (m), at a time (s). On ground, if that is where it was put: it lands at once.
    ///
    /// # Errors
    /// If the position is no position of the world, or the standing body would overlap a solid there.
    pub fn spawn(at: DVec2, time: f64, terrain: &Terrain) -> Result<Body, SpawnError> {
        let spot = spot(at, time, terrain)?;
        let mut body = Body::put(spot, time, Size::Stand, terrain)?;
        body.refresh(terrain, &mut Trace::default());
        Ok(body)
    }

    /// A body of a size at rest in the air, before anything follows from that.
    fn put((at, face): Spot, time: f64, size: Size, terrain: &Terrain) -> Result<Body, SpawnError> {
        let mut body = Body::lying(at, face, time);
        body.size = size;
        body.fly(at, DVec2::ZERO, face, [None; 2]);
        body.find_places(terrain)?;
        Ok(body)
    }

    /// The body where it is, as fast as it is and with what it wants, in other meshes and among other moving solids: standing
    /// if it stands and has room for that, else crouched.
    ///
    /// # Errors
    /// As [`Body::spawn`].
    pub fn moved_to(&self, terrain: &Terrain, trace: &mut Trace) -> Result<Body, SpawnError> {
        // Where it is it has not been drawn, but come to: no bit of that changes.
        let put = |size| {
            let spot = free_at(terrain.ground(size), self.position())?;
            Body::put(spot, self.time, size, terrain)
        };
        let mut body = match self.size {
            Size::Stand => put(Size::Stand).or_else(|_| put(Size::Crouch)),
            Size::Crouch => put(Size::Crouch),
        }?;
        (body.control, body.pressed_at) = (self.control, self.pressed_at);
        (body.rise, body.released_at) = (self.rise, self.released_at);
        body.coyote_from = self.coyote_from;
        (body.climbing, body.reach) = (self.climbing, self.reach);
        if let Mode::Air(air) = &mut body.mode {
            air.v0 = self.velocity();
        }
        body.refresh(terrain, trace);
        Ok(body)
    }

    /// Nobody: at a place without being there, until somebody comes. Nothing happens to it.
    pub fn absent(at: DVec2, time: f64, terrain: &Terrain) -> Body {
        let ground = terrain.ground(Size::Stand);
        let face = ground.locate(at, None).and_then(|place| match place {
            Place::Face(face) => Some(face),
            Place::Edge(e) => ground.left(e).or(ground.left(ground.sym(e))),
            Place::Vertex(v) => spokes(ground, v).find_map(|e| ground.left(e)),
        });
        let face = face.or(ground.faces().next());
        let face = face.expect("a mesh has a face");
        let mut body = Body::lying(at, face, time);
        body.mode = Mode::Crushed(Crushed { at, face });
        body
    }

    /// What a body that is not there wants when it comes.
    pub fn wish(&mut self, control: Control) {
        self.control = control;
    }

    fn lying(at: DVec2, face: FaceId, time: f64) -> Body {
        Body {
            mode: Mode::Wedge(Wedge { at, face }),
            frame: None,
            beside: Vec::new(),
            meetings: Vec::new(),
            lift: None,
            size: Size::Stand,
            control: Control::default(),
            time,
            pressed_at: None,
            coyote_from: None,
            off_wall: None,
            regions: Vec::new(),
            regions_move: false,
            climbing: false,
            ladder: None,
            mount: None,
            anew_at: None,
            faces: 0.0,
            reach: Reach::Open,
            released_at: None,
            rise: None,
            rides: None,
            next: None,
        }
    }
}

/// The place that a position means: on the ground of the level, on that of something that moves, or just there.
fn spot(at: DVec2, time: f64, terrain: &Terrain) -> Result<Spot, SpawnError> {
    let mesh = terrain.ground(Size::Stand);
    let Some(drawn) = Drawn::of(at) else {
        return Err(SpawnError::Outside);
    };
    if let Some((p, e)) = ground_at(mesh, at, |segment| lies_on(drawn, segment))
        && let Some(face) = mesh.left(e)
    {
        return Ok((p, face));
    }
    let at = deck_at(at, time, terrain).unwrap_or(at);
    // Beside a wall or under a ceiling it is by the rounding of the grid where that is.
    let on_grid = || free_at(mesh, drawn.point().metres());
    free_at(mesh, at).or_else(|error| on_grid().map_err(|_| error))
}

/// Just there. On ground a body may stand, whatever rounding has made of that; but not in it.
fn free_at(mesh: Ground, at: DVec2) -> Result<Spot, SpawnError> {
    let rounding = 8.0 * f64::EPSILON * at.abs().max_element().max(1.0);
    let down = Bearing::of(DVec2::NEG_Y, DVec2::NEG_Y);
    free_face_at(mesh, at, down, rounding).map(|face| (at, face))
}

/// Whether a point is on a feature edge, as both were drawn: on a level one exactly, else to the micrometre to which it could be
/// written. What is on the grid needs no rule.
fn lies_on(p: Drawn, segment: &Segment) -> bool {
    if segment.aside.is_none() && p == Drawn::from(p.point()) {
        return false;
    }
    let [a, b] = segment.drawn();
    let along = b.vector_from(a);
    let off = wide_cross(along, p.vector_from(a)).unsigned_abs();
    let allowed = match along.1 {
        0 => 0,
        _ => PER_MICROMETRE,
    };
    off <= u128::from(along.0.unsigned_abs()) * u128::from(allowed.unsigned_abs())
}

/// The top of something that moves where a position is on it, but for the rounding of its path.
fn deck_at(at: DVec2, time: f64, terrain: &Terrain) -> Option<DVec2> {
    (0..terrain.movers.len() as u32).find_map(|mover| {
        let offset = Ride::at(mover, time, terrain.movers).piece.offset(time);
        let mesh = terrain.ground_under(Some(mover), Size::Stand);
        let (p, _) = ground_at(mesh, at - offset, |_| true)?;
        Some(p + offset)
    })
}

/// The ground next to a position of which `is_meant` says that it is there, as the nearest position on it and the edge.
fn ground_at(
    mesh: Ground,
    at: DVec2,
    is_meant: impl Fn(&Segment) -> bool,
) -> Option<(DVec2, EdgeId)> {
    let mut found: Option<(f64, DVec2, EdgeId)> = None;
    // Of numbers that are not negative the bits have the same order.
    let reach = |e: EdgeId| (nearest_on(mesh, e, at) - at).length().to_bits();
    mesh.outwards(mesh.locate(at, None)?, reach, |e, distance| {
        if f64::from_bits(*distance) > WIDTH {
            return true;
        }
        for e in [e, mesh.sym(e)].into_iter().filter(|&e| mesh.blocks(e)) {
            let mut ground = mesh.facing(e).filter(|&s| mesh.walkable(s));
            let Some(s) = ground.find(|&s| is_meant(mesh.segment(s))) else {
                continue;
            };
            let track = mesh.track(s);
            let ends = [mesh.origin(e), mesh.dest(e)].map(|v| mesh.point(v).metres().x);
            let x = at.x.clamp(ends[0].min(ends[1]), ends[0].max(ends[1]));
            let p = track.above(DVec2::new(x, at.y));
            let away = (p - at).length();
            if away <= WIDTH && found.is_none_or(|(least, ..)| away < least) {
                found = Some((away, p, e));
            }
        }
        false
    });
    found.map(|(_, p, e)| (p, e))
}
