//! The head of a ladder: on from its end, in the same climb, up to ground that is near above, and from there down onto it.
//!
//! A ladder is climbed with a point of the body on it, its middle as a rule: the feet end far below the ladder's own end. Ground
//! that lies no higher than that end, or a little, is climbed onto nevertheless. Who comes to the end of the ladder with up held
//! goes on straight up, through one-ways, and stands on what is above him; where the ground begins beside him, he climbs to
//! its height and then aside onto it. On his way up he may rest and go back down; there is no going sideways.

use super::body::{Air, Body, Mode, Next, Size, Trace};
use super::ride::ground_near;
use super::roots::exit;
use super::snap::in_steps;
use super::terrain::{Ground, Terrain};
use super::vertex::{JOINT_STEPS, segment_at};
use crate::geom::{BOUND, Point, STEP};
use crate::mesh::{Cast, EdgeId, FaceId, FeatureId, Kind, Segment, SegmentId};
use glam::DVec2;
use serde::{Deserialize, Serialize};
use xxhash_rust::xxh3::Xxh3;

/// The way of a climber from the end of his ladder up to ground.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mount {
    /// Where his feet come to the ground, in the frame of what carries him, m.
    to: DVec2,
    /// He has come up beside the ground, and is on his way aside to it.
    aside: bool,
}

impl Mount {
    /// Adds the way to a hash.
    pub(super) fn hash_into(&self, hash: &mut Xxh3) {
        hash.update(&[u8::from(self.aside)]);
        for number in self.to.to_array() {
            hash.update(&(number + 0.0).to_bits().to_le_bytes());
        }
    }
}

/// How far above the reach of climbers ground is at most that a ladder was meant to lead to, and how far below its end, m.
const MEANT: f64 = 2.0;

/// Ground near the end of a ladder.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Found {
    /// How far aside it begins; 0: it is straight above.
    aside: f64,
    at: DVec2,
}

impl Body {
    /// What one who is on his way between the end of a ladder and ground wishes for, as a share of full speed.
    pub(super) fn mount_wish(&self) -> Option<DVec2> {
        let mount = self.mount?;
        let Mode::Air(air) = &self.mode else {
            return None;
        };
        let share = |key: bool| f64::from(u8::from(key));
        let up = share(self.control.up) - share(self.control.down);
        Some(match mount.aside {
            true => DVec2::new((mount.to.x - air.p0.x).signum(), 0.0),
            false => DVec2::new(0.0, up),
        })
    }

    /// Whether the body is between the end of a ladder and ground, where nothing but that holds it.
    pub(super) fn is_mounting(&self) -> bool {
        self.mount.is_some() && matches!(self.mode, Mode::Air(_))
    }

    /// Over the end of a ladder, an edge with the ladder on its left, on to ground that is near. True if there is some.
    pub(super) fn mount(&mut self, border: EdgeId, terrain: &Terrain) -> bool {
        if !self.climbing || self.size != Size::Stand || !self.control.up || self.control.down {
            return false;
        }
        let mesh = self.ground(terrain).climbed(false);
        let ends = |s: &SegmentId| mesh.kind(*s) == Kind::Region;
        let mut ends = self.ground(terrain).facing(border).filter(ends);
        let Some(end) = ends.next().filter(|&s| mesh.track(s).normal.y < 0.0) else {
            return false;
        };
        let (p, v) = (self.local_position(), self.local_velocity());
        let beyond = mesh.left(mesh.sym(border)).filter(|&f| !mesh.is_solid(f));
        let first_side = if self.faces < 0.0 { -1.0 } else { 1.0 };
        let search = Search {
            first_side,
            ..Search::at(p, *mesh.segment(end), mesh, terrain)
        };
        let Some((face, found)) = beyond.zip(search.ground()) else {
            return false;
        };
        if !self.is_clear_to(DVec2::new(p.x, found.at.y), terrain) {
            return false;
        }
        self.fly(p, DVec2::new(0.0, v.y.max(0.0)), face, [None; 2]);
        self.mount = Some(Mount {
            to: found.at,
            aside: false,
        });
        true
    }

    /// From the end of a ladder on to ground that is near, if up is held by one who rests there, or has just been pressed: in between
    /// it would be for other events to say when ground comes into reach.
    pub(super) fn mount_as_wished(&mut self, terrain: &Terrain) {
        if let Mode::Surface(on) = &self.mode
            && self.climbing
            && (on.speed(self.time) == 0.0 || self.presses_anew())
        {
            self.mount(on.edge, terrain);
        }
    }

    /// Whether up or down is pressed at this very time.
    pub(super) fn presses_anew(&self) -> bool {
        self.anew_at == Some(self.time)
    }

    /// The face below a one-way on which the body stands and down has just been pressed, over a ladder that ends near below it.
    pub(super) fn ladder_below(&self, edge: EdgeId, terrain: &Terrain) -> Option<FaceId> {
        if !self.presses_anew() {
            return None;
        }
        let mesh = self.ground(terrain);
        let face = mesh.left(mesh.sym(edge)).filter(|&f| !mesh.is_ladder(f))?;
        let p = self.local_position();
        let mut way = Air {
            v0: DVec2::NEG_Y,
            ..Air::resting(p, face)
        };
        loop {
            let (at, e) = way.way_out(mesh)?;
            let next = mesh.left(mesh.sym(e))?;
            if mesh.blocks(e) {
                return None;
            }
            if mesh.is_ladder(next) {
                let rungs = mesh.cover(next).iter();
                let drawn = rungs.map(|&f| terrain.traits_of(f).drawn[1]);
                let reach = drawn.fold(0.0, f64::max) + terrain.tuning.ladder_reach;
                return (at <= reach + f64::from(JOINT_STEPS) * STEP).then_some(face);
            }
            (way.face, way.since) = (next, at);
        }
    }

    /// Down from ground, with the feet on it, to the ladder below.
    pub(super) fn dismount(&mut self) {
        let at = self.local_position();
        if let Mode::Air(air) = &mut self.mode {
            air.v0 = DVec2::ZERO;
        }
        self.mount = Some(Mount {
            to: at,
            aside: false,
        });
    }

    /// Back on the ladder, or off it: there is no way to ground any more.
    pub(super) fn end_mount(&mut self, on_ladder: bool) {
        if self.mount_is_over(on_ladder) {
            self.rebase();
            self.mount = None;
        }
    }

    /// Whether the way to ground is at an end: on a ladder again, but for one that is only passed on the way aside.
    pub(super) fn mount_is_over(&self, on_ladder: bool) -> bool {
        let back = on_ladder && self.mount.is_some_and(|mount| !mount.aside);
        !self.climbing || !self.is_mounting() || back
    }

    /// When the feet of one who climbs from the end of a ladder come to the ground, or beside it, if that comes first.
    pub(super) fn sooner_if_mounts(
        &self,
        mount: &Mount,
        next: Option<(f64, Next)>,
    ) -> Option<(f64, Next)> {
        let Mode::Air(air) = &self.mode else {
            return next;
        };
        if !self.climbing {
            return next;
        }
        let left = mount.to - air.p0;
        let at = match mount.aside {
            true => {
                let sign = left.x.signum();
                exit(
                    left.x * sign,
                    -air.v0.x * sign,
                    -0.5 * air.accel.x * sign,
                    air.since,
                )
            }
            false => exit(left.y, -air.v0.y, -0.5 * air.accel.y, air.since),
        };
        match at.map(|at| air.t0 + at) {
            Some(at) if next.is_none_or(|(other, _)| at <= other) => Some((at, Next::Mount)),
            _ => next,
        }
    }

    /// At the height of the ground: onto it, or aside to it.
    pub(super) fn come_to_ground(&mut self, terrain: &Terrain, trace: &mut Trace) {
        self.rebase();
        let Some(mount) = self.mount else {
            return;
        };
        let mesh = self.ground(terrain).climbed(false);
        let Mode::Air(air) = &mut self.mode else {
            return;
        };
        let towards = mount.to.x - air.p0.x;
        if !mount.aside && towards != 0.0 {
            (air.p0.y, air.v0) = (mount.to.y, DVec2::ZERO);
            self.mount = Some(Mount {
                aside: true,
                ..mount
            });
            return;
        }
        let side = match air.v0.x {
            0.0 => [1.0, -1.0],
            x => [x.signum(); 2],
        };
        (air.p0, air.v0) = (mount.to, DVec2::ZERO);
        let face = air.face;
        self.mount = None;
        let found = side.map(|dx| ground_near(mesh, face, mount.to, dx));
        if let Some((edge, segment)) = found.into_iter().flatten().next() {
            self.stand_up_on(edge, segment, terrain, trace);
        }
    }
}

/// What is looked for at the end of a ladder, and from where.
struct Search<'a> {
    mesh: Ground<'a>,
    /// Where the feet are.
    from: DVec2,
    /// The end of the ladder.
    ladder: Segment,
    /// How far above the feet ground may be, and how far below them where it begins beside them, m.
    above: f64,
    below: f64,
    /// How far beside the ladder it may begin, m.
    beside: f64,
    /// The side that counts first where both are alike.
    first_side: f64,
}

/// How far above the reach of one who climbs to the upper end of a ladder the ground is that is meant by it, m; `None` if he
/// comes onto some, or steps off onto some from the ladder, or there is none.
pub fn short_of_ground(ladder: FeatureId, terrain: &Terrain) -> Option<f64> {
    let mesh = terrain.ground(Size::Stand);
    let ends = mesh.segments_of(ladder).iter();
    let tops = ends.filter(|&&s| mesh.climbed(true).is_end(s) && mesh.track(s).normal.y < 0.0);
    let mut least: Option<f64> = None;
    for &top in tops {
        let end = *mesh.segment(top);
        let from = 0.5 * (end.a.metres() + end.b.metres());
        let search = Search {
            below: MEANT,
            ..Search::at(from, end, mesh, terrain)
        };
        if search.ground().is_some() {
            return None;
        }
        let reach = search.above;
        let wider = Search {
            above: reach + MEANT,
            ..search
        };
        let short = wider.ground().map(|found| found.at.y - from.y - reach);
        least = short.into_iter().chain(least).min_by(f64::total_cmp);
    }
    least
}

impl<'a> Search<'a> {
    /// What one who climbs comes to from the end of a ladder.
    fn at(from: DVec2, ladder: Segment, mesh: Ground<'a>, terrain: &Terrain) -> Search<'a> {
        Search {
            mesh,
            from,
            ladder,
            above: terrain.traits_of(ladder.feature).drawn[1] + terrain.tuning.ladder_reach,
            below: 0.0,
            beside: terrain.tuning.ladder_reach,
            first_side: 1.0,
        }
    }

    /// The ground that one comes to: what is straight above goes first; then what begins nearest to a side, the lower of two that
    /// begin alike.
    fn ground(&self) -> Option<Found> {
        let mesh = self.mesh;
        let faces = mesh.overlap(&self.room())?.faces.into_iter();
        let edges = faces.flat_map(|f| mesh.sides(f));
        let found = edges.filter_map(|e| self.found(e)).filter(|found| {
            let corner = DVec2::new(self.from.x, found.at.y);
            is_clear(mesh, self.from, corner) && is_clear(mesh, corner, found.at)
        });
        let to_side = |f: &Found| (self.from.x - f.at.x) * self.first_side;
        let rank = |f: &Found| (f.aside, f.at.y, to_side(f));
        let order = |a: &Found, b: &Found| rank(a).partial_cmp(&rank(b));
        found.min_by(|a, b| order(a, b).expect("no NaN in a mesh"))
    }

    /// What is looked through, and a little more: to touch is not to overlap.
    fn room(&self) -> [Point; 4] {
        let (a, b) = (self.ladder.a, self.ladder.b);
        let within = |c: i32| c.clamp(2 - BOUND, BOUND - 2);
        let lengths = [self.above, self.below, self.beside];
        let [above, below, beside] = lengths.map(|m| in_steps(m) + 2 * JOINT_STEPS);
        let foot = (self.from.y / STEP).floor() as i32;
        let [x0, x1] = [a.x.min(b.x) - beside, a.x.max(b.x) + beside].map(within);
        let [y0, y1] = [foot - below, foot + above].map(within);
        [(x0, y0), (x1, y0), (x1, y1), (x0, y1)].map(|(x, y)| Point::new(x, y))
    }

    /// The place on a mesh edge, if that is ground, to which one would come.
    fn found(&self, e: EdgeId) -> Option<Found> {
        let (mesh, p) = (self.mesh, self.from);
        if !mesh.blocks(e) {
            return None;
        }
        let ground = segment_at(mesh, e, |_| false).filter(|&s| mesh.walkable(s))?;
        // Ground has its free side on the left: it runs towards growing x.
        let (left, right) = mesh.ends(e);
        let [left, right] = [left, right].map(Point::metres);
        let at = match (left.x <= p.x, p.x <= right.x) {
            (true, true) => mesh.track(ground).above(p),
            (false, _) => left,
            (_, false) => right,
        };
        let width = f64::from(JOINT_STEPS) * STEP;
        let ends = [self.ladder.a, self.ladder.b].map(|end| end.metres().x);
        let aside = (ends[0].min(ends[1]) - at.x).max(at.x - ends[0].max(ends[1]));
        let lowest = if at.x == p.x {
            p.y + width
        } else {
            p.y - self.below - width
        };
        let near = (lowest..=p.y + self.above + width).contains(&at.y);
        (near && aside <= self.beside + width).then_some(Found {
            aside: (at.x - p.x).abs(),
            at,
        })
    }
}

/// Whether nothing stops a point on a straight way.
fn is_clear(mesh: Ground, from: DVec2, to: DVec2) -> bool {
    from == to || mesh.cast_by(from, to, None, |e| mesh.blocks(e)) == Cast::Clear
}
