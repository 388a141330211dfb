//! The state of one body, and what can be read from it.

use super::at_once::Meeting;
use super::beside::Beside;
pub use super::event::{Event, EventKind, Trace};
use super::grip::Grip;
use super::ladder::Reach;
use super::mount::Mount;
use super::mover::Ride;
use super::rise::Rise;
use super::terrain::{Ground, Terrain};
use super::track::Track;
use super::wall::{Lock, OffWall};
use crate::mesh::{EdgeId, FaceId, FeatureId, Mesh, SegmentId};
use glam::DVec2;
use serde::{Deserialize, Serialize};
use xxhash_rust::xxh3::Xxh3;

/// What the body's will is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Control {
    /// Wished run, as a share of full speed: -1 (left) to 1 (right).
    pub run: f64,
    /// Jump is held.
    pub jump: bool,
    /// Down is held: crouch on the ground, fall fast in the air, climb down.
    pub down: bool,
    /// Up is held: climb.
    #[serde(default)]
    pub up: bool,
}

/// The sizes of a body. Their colliders share the lower chain, so that their meshes have the same floors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Size {
    /// Upright.
    #[default]
    Stand,
    /// Crouched.
    Crouch,
}

/// In the air: a parabola through free faces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Air {
    /// Start of the piece, s.
    pub t0: f64,
    /// Position then, m.
    pub p0: DVec2,
    /// Velocity then, m/s.
    pub v0: DVec2,
    /// Acceleration throughout, m/s^2.
    pub accel: DVec2,
    /// For x and y: when the speed reaches a limit, and which.
    pub limits: [Option<(f64, f64)>; 2],
    /// The discrete place.
    pub face: FaceId,
    /// How long after `t0` that face was entered, s.
    pub since: f64,
    /// The feature edge that the body has left for this flight, and one that it has touched since: not yet apart from
    /// them, as rounding goes.
    pub touching: [Option<SegmentId>; 2],
    /// The direction that a wall jump holds.
    pub lock: Option<Lock>,
    /// The feature edge of a one-way that the body lets itself fall through, while it is not yet apart from it.
    pub through: Option<SegmentId>,
    /// What rounding may have made of the velocity where that is the difference of two, the body's and a frame's, m/s; else 0.
    #[serde(default)]
    pub grain: f64,
}

/// On a surface: a quadratic along a feature edge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// Start of the piece, s.
    pub t0: f64,
    /// Parameter then, m.
    pub s0: f64,
    /// Speed along the tangent then, m/s.
    pub u0: f64,
    /// Acceleration along the tangent, m/s^2.
    pub accel: f64,
    /// When the speed reaches a limit, and which.
    pub limit: Option<(f64, f64)>,
    /// The feature edge.
    pub segment: SegmentId,
    /// Its line.
    pub track: Track,
    /// The discrete place: the mesh edge, with the free face on its left.
    pub edge: EdgeId,
    /// How long after `t0` that edge was entered, s.
    pub since: f64,
    /// Ground, not a slide.
    pub walkable: bool,
    /// The sign of the parameter's direction that is walled up here, or 0.
    pub against: f64,
    /// What the body holds on to, on a wall.
    #[serde(default)]
    pub grip: Grip,
}

/// Held at a vertex by two edges that drive the body back.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wedge {
    /// The vertex, m.
    pub at: DVec2,
    /// A free face there.
    pub face: FaceId,
}

/// Crushed: stays where it happened until it is put elsewhere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Crushed {
    /// Where, m.
    pub at: DVec2,
    /// A face of the level's mesh there.
    pub face: FaceId,
}

/// What the body is doing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Mode {
    /// In the air.
    Air(Air),
    /// On a surface.
    Surface(Surface),
    /// Wedged.
    Wedge(Wedge),
    /// Crushed.
    Crushed(Crushed),
}

/// What happens next, in closed form.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) enum Next {
    /// A free edge is crossed into its right face, so long after the start of the piece.
    Cross(EdgeId, f64),
    /// A blocking edge is reached, so long after the start of the piece.
    Hit(EdgeId, f64),
    /// A speed limit is reached.
    Limit,
    /// The vertex ahead on the surface is reached.
    Vertex,
    /// There is room to stand up; on a surface, from this parameter on.
    Clear(Option<f64>),
    /// A wall jump holds the direction no longer.
    Unlock,
    /// The height is reached at which the body hangs from a ledge: this parameter.
    Grab(f64),
    /// The feet of one who climbs from the end of a ladder come to ground, or to its height.
    Mount,
    /// The frame begins the next piece of its path.
    Node,
    /// What holds the body where it is changes.
    Change,
    /// A buffered jump counts as let go of.
    Cut,
    /// What is next in another frame, an entry of the body's list of them.
    Beside(u32),
}

impl Next {
    /// The sooner of two events; of two at one time the first.
    pub(super) fn sooner(
        first: Option<(f64, Next)>,
        other: Option<(f64, Next)>,
    ) -> Option<(f64, Next)> {
        match (first, other) {
            (Some((at, _)), Some((sooner, _))) if sooner < at => other,
            (None, other) => other,
            (first, _) => first,
        }
    }
}

/// One body. A plain value: clone it to take a snapshot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// In the frame of what carries the body.
    pub(super) mode: Mode,
    /// What carries the body; `None`: the level. In the air, between events, always the level, but for who climbs a ladder of a
    /// moving solid: that.
    #[serde(default)]
    pub(super) frame: Option<Ride>,
    /// Its places in all other frames.
    #[serde(default)]
    pub(super) beside: Vec<Beside>,
    /// The edges that it has come to among moving solids and is not yet away from.
    #[serde(default)]
    pub(super) meetings: Vec<Meeting>,
    /// When what carries the body slowed down at once, and the velocity that it had.
    #[serde(default)]
    pub(super) lift: Option<(f64, DVec2)>,
    pub(super) size: Size,
    pub(super) control: Control,
    /// Simulated time, s.
    pub(super) time: f64,
    /// When jump was pressed, while that press has not been used.
    pub(super) pressed_at: Option<f64>,
    /// When the ground was left by walking off it.
    pub(super) coyote_from: Option<f64>,
    /// The wall that was come off last, without anything met since.
    pub(super) off_wall: Option<OffWall>,
    /// The regions that it is in, ascending.
    #[serde(default)]
    pub(super) regions: Vec<FeatureId>,
    /// Regions move too: those of all frames count.
    #[serde(default)]
    pub(super) regions_move: bool,
    /// It holds on to a ladder.
    #[serde(default)]
    pub(super) climbing: bool,
    /// Of which moving solid the ladder is, while it holds on to one; `None`: of the level.
    #[serde(default)]
    pub(super) ladder: Option<u32>,
    /// It is on its way between the end of one and ground.
    #[serde(default)]
    pub(super) mount: Option<Mount>,
    /// When up or down was last pressed.
    #[serde(default)]
    pub(super) anew_at: Option<f64>,
    /// The sign of the last wish to run; 0: there has been none.
    #[serde(default)]
    pub(super) faces: f64,
    /// Whether up or down, if held, takes hold of one.
    #[serde(default)]
    pub(super) reach: Reach,
    /// The moving solid that it stands on or holds on to, if that minds it.
    #[serde(default)]
    pub(super) rides: Option<u32>,
    /// When jump was let go of, since that press.
    #[serde(default)]
    pub(super) released_at: Option<f64>,
    /// The rise of a jump.
    #[serde(default)]
    pub(super) rise: Option<Rise>,
    /// The next event and its time; `None` if nothing will ever happen by itself.
    pub(super) next: Option<(f64, Next)>,
}

/// A body cannot be placed here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpawnError {
    /// The position is not a number, or outside the world.
    Outside,
    /// The collider would overlap solids there.
    Solid,
}

impl std::fmt::Display for SpawnError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(match self {
            SpawnError::Outside => "the position is outside the world",
            SpawnError::Solid => "the body does not fit there: it overlaps a solid",
        })
    }
}

impl std::error::Error for SpawnError {}

impl Air {
    /// At rest somewhere.
    pub(super) fn resting(p0: DVec2, face: FaceId) -> Air {
        Air {
            t0: 0.0,
            p0,
            v0: DVec2::ZERO,
            accel: DVec2::ZERO,
            limits: [None; 2],
            face,
            since: 0.0,
            touching: [None; 2],
            lock: None,
            through: None,
            grain: 0.0,
        }
    }

    pub(super) fn position(&self, t: f64) -> DVec2 {
        let dt = t - self.t0;
        self.p0 + self.v0 * dt + self.accel * (0.5 * dt * dt)
    }

    pub(super) fn velocity(&self, t: f64) -> DVec2 {
        self.v0 + self.accel * (t - self.t0)
    }
}

impl Surface {
    /// On a feature edge from a time on, at a parameter and a speed; its law is yet to be chosen.
    pub(super) fn new(
        t0: f64,
        place: (SegmentId, Track, EdgeId),
        s0: f64,
        u0: f64,
        walkable: bool,
    ) -> Surface {
        let (segment, track, edge) = place;
        Surface {
            t0,
            s0,
            u0,
            accel: 0.0,
            limit: None,
            segment,
            track,
            edge,
            since: 0.0,
            walkable,
            against: 0.0,
            grip: Grip::None,
        }
    }

    pub(super) fn parameter(&self, t: f64) -> f64 {
        let dt = t - self.t0;
        self.s0 + self.track.rate() * (self.u0 * dt + 0.5 * self.accel * dt * dt)
    }

    pub(super) fn speed(&self, t: f64) -> f64 {
        self.u0 + self.accel * (t - self.t0)
    }

    /// 1 or -1 as the motion goes to larger or smaller parameters; 0 at rest.
    pub(super) fn sign(&self) -> f64 {
        match (self.u0 != 0.0, self.accel != 0.0) {
            (true, _) => self.u0.signum(),
            (false, true) => self.accel.signum(),
            (false, false) => 0.0,
        }
    }
}

impl Body {
    /// Simulated time, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// What the body is doing.
    pub fn mode(&self) -> &Mode {
        &self.mode
    }

    /// Its size.
    pub fn size(&self) -> Size {
        self.size
    }

    /// The control in force.
    pub fn control(&self) -> Control {
        self.control
    }

    /// Where the reference point, the middle of the foot, is; m.
    pub fn position(&self) -> DVec2 {
        let local = self.local_position();
        self.frame
            .map_or(local, |ride| local + ride.piece.offset(self.time))
    }

    /// m/s.
    pub fn velocity(&self) -> DVec2 {
        let local = self.local_velocity();
        self.frame
            .map_or(local, |ride| local + ride.piece.velocity(self.time))
    }

    /// The position in the frame of what carries the body, m: where it is in that mesh.
    pub(super) fn local_position(&self) -> DVec2 {
        match &self.mode {
            Mode::Air(air) => air.position(self.time),
            Mode::Surface(on) => on.track.position(on.parameter(self.time)),
            Mode::Wedge(wedge) => wedge.at,
            Mode::Crushed(crushed) => crushed.at,
        }
    }

    /// The velocity relative to what carries the body, m/s.
    pub(super) fn local_velocity(&self) -> DVec2 {
        match &self.mode {
            Mode::Air(air) => air.velocity(self.time),
            Mode::Surface(on) => on.track.tangent * on.speed(self.time),
            Mode::Wedge(_) | Mode::Crushed(_) => DVec2::ZERO,
        }
    }

    /// What carries the body: the index of a moving solid, or the level (`None`, also in the air).
    pub fn carrier(&self) -> Option<u32> {
        self.frame.map(|ride| ride.mover)
    }

    /// The moving solid that it stands on, holds on to or climbs on a ladder of, if that minds it
    /// ([`Traits::minds_riders`](super::Traits::minds_riders)).
    pub fn rides(&self) -> Option<u32> {
        self.rides
    }

    /// The mesh of what carries the body, as it meets it.
    pub(super) fn ground<'a>(&self, terrain: &Terrain<'a>) -> Ground<'a> {
        let mesh = terrain.ground_under(self.carrier(), self.size);
        match self.climbing {
            true => mesh
                .climbed(true)
                .with_ladder(self.ladder == self.carrier()),
            false => mesh,
        }
    }

    /// The mesh of the level, as the body meets it, whatever carries it.
    pub(super) fn level_ground<'a>(&self, terrain: &Terrain<'a>) -> Ground<'a> {
        terrain
            .ground(self.size)
            .climbed(self.climbing)
            .with_ladder(self.ladder.is_none())
    }

    /// When the next event is due, if there will be one.
    pub fn next_at(&self) -> Option<f64> {
        self.next.map(|(at, _)| at)
    }

    /// Position and velocity at a later time, if nothing happened until then.
    pub fn forecast(&self, time: f64) -> (DVec2, DVec2) {
        let later = Body {
            time,
            ..self.clone()
        };
        (later.position(), later.velocity())
    }

    /// Unit normal of the surface, towards the body; zero in the air.
    pub fn normal(&self) -> DVec2 {
        match &self.mode {
            Mode::Surface(on) => on.track.normal,
            Mode::Air(_) | Mode::Crushed(_) => DVec2::ZERO,
            Mode::Wedge(_) => DVec2::Y,
        }
    }

    /// What rounding may make of the position, m: two units in the last place for each of the sums that lead to it, and how
    /// far the body moves in a unit in the last place of the time.
    pub(super) fn rounding(&self) -> f64 {
        self.rounding_at(self.velocity().length())
    }

    /// The same for the parameter along a road, for a velocity in the frame of that: time counts only as far as it leads along it.
    pub(super) fn rounding_along(&self, track: &Track, v: DVec2) -> f64 {
        self.rounding_at(track.parameter(v).abs())
    }

    /// The same for a speed, m/s.
    pub(super) fn rounding_at(&self, speed: f64) -> f64 {
        let largest = self.position().abs().max_element().max(1.0);
        // On the way from one frame to another there are as many sums again.
        let sums = if self.beside.is_empty() { 8.0 } else { 16.0 };
        f64::EPSILON * (sums * largest + 2.0 * speed * self.time)
    }

    /// On walkable ground.
    pub fn supported(&self) -> bool {
        matches!(&self.mode, Mode::Surface(on) if on.walkable)
    }

    /// The feature edge that the body is on.
    pub fn segment(&self) -> Option<SegmentId> {
        match &self.mode {
            Mode::Surface(on) => Some(on.segment),
            _ => None,
        }
    }

    /// The mesh edge that the body is on, with the free face on its left.
    pub fn edge(&self) -> Option<EdgeId> {
        match &self.mode {
            Mode::Surface(on) => Some(on.edge),
            _ => None,
        }
    }

    /// The free face that the body is in or beside, in the mesh of its size of what carries it.
    pub fn face(&self, mesh: &Mesh) -> FaceId {
        match &self.mode {
            Mode::Air(air) => air.face,
            Mode::Surface(on) => mesh
                .left(on.edge)
                .expect("a free face lies left of a surface's edge"),
            Mode::Wedge(wedge) => wedge.face,
            Mode::Crushed(crushed) => crushed.face,
        }
    }

    /// Adds the state to a hash: what players can tell, never handles of the mesh. -0.0 counts as 0.0.
    pub fn hash_into(&self, hash: &mut Xxh3) {
        let (p, v) = (self.position(), self.velocity());
        let (mode, place) = match &self.mode {
            Mode::Air(_) => (0, [p.x, p.y]),
            Mode::Surface(on) => (1 + u8::from(on.walkable), [on.parameter(self.time), 0.0]),
            Mode::Wedge(_) => (3, [p.x, p.y]),
            Mode::Crushed(_) => (4, [p.x, p.y]),
        };
        let flags = [
            mode + 8 * u8::from(self.climbing) + 16 * self.reach as u8,
            u8::from(self.size == Size::Crouch),
            u8::from(self.rise.is_some()),
            self.grip() as u8,
        ];
        hash.update(&flags);
        if let Some(mount) = &self.mount {
            mount.hash_into(hash);
        }
        if let Some(ride) = self.frame {
            hash.update(&ride.mover.to_le_bytes());
        }
        if let Some(mover) = self.ladder.filter(|_| self.climbing) {
            hash.update(&mover.to_le_bytes());
        }
        let timer = |t: Option<f64>| t.unwrap_or(-1.0);
        let numbers = [
            place[0],
            place[1],
            v.x,
            v.y,
            self.time,
            timer(self.pressed_at),
            timer(self.coyote_from),
            timer(self.off_wall.map(|wall| wall.at)),
            self.off_wall.map_or(0.0, |wall| wall.away),
            timer(self.lock().map(|lock| lock.until)),
            self.lock().map_or(0.0, |lock| lock.run),
        ];
        let rise = self.rise.map(|rise| {
            let cut = f64::from(u8::from(rise.cut));
            [
                rise.base,
                rise.speed,
                cut,
                timer(rise.cut_at),
                timer(self.released_at),
            ]
        });
        for number in numbers.into_iter().chain(rise.into_iter().flatten()) {
            hash.update(&(number + 0.0).to_bits().to_le_bytes());
        }
    }

    /// Hash of the state; equal in every build on every machine.
    pub fn hash(&self) -> u64 {
        let mut hash = Xxh3::new();
        self.hash_into(&mut hash);
        hash.digest()
    }
}
