//! What a body moves in: the meshes, the traits of their features, the moving solids, the tuning.

use super::body::Size;
use super::mover::Mover;
use super::snap::in_steps;
use super::track::{Track, walkable};
use super::vertex::JOINT_STEPS;
use super::wall::is_wall;
use crate::geom::Point;
use crate::geom::drawn::Height;
use crate::mesh::{EdgeId, FaceId, FeatureId, Kind, Mesh, Segment, SegmentId, Source, Use};
use crate::tune::Motion;
use serde::{Deserialize, Serialize};
use std::ops::Deref;

/// What a closed feature that stops nobody is to a body inside it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Region {
    /// Nothing: coming and going are not even noted.
    #[default]
    None,
    /// It can be climbed, up, down and sideways.
    Ladder,
    /// Coming and going are events; what they mean is for the rules of the game.
    Plain,
}

/// What a concave joint does to the speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Concave {
    /// All of it goes on.
    Keep,
    /// Only its part along the next edge goes on.
    Project,
}

/// What a feature is to bodies, besides its shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Traits {
    /// What it is to a body inside it, if it is a region.
    pub region: Region,
    /// Of a ladder: how far its drawn lower and upper ends lie above those of the region, in which the feet of one who climbs are, m.
    pub drawn: [f64; 2],
    /// Its walls can be climbed.
    pub climbable: bool,
    /// Speed of its top, a belt, towards growing x, m/s.
    pub conveyor: f64,
    /// Coefficient of friction of walkable ground, instead of the tuning's.
    pub friction: Option<f64>,
    /// What its concave joints do, instead of the tuning's choice.
    pub concave: Option<Concave>,
    /// To come to stand on the moving solid that it belongs to, and to leave it, are events.
    pub minds_riders: bool,
}

/// What a body moves in.
#[derive(Clone, Copy, Debug)]
pub struct Terrain<'a> {
    /// Mesh of the level for the standing collider.
    pub stand: &'a Mesh,
    /// Mesh of the level for the crouching collider.
    pub crouch: &'a Mesh,
    /// How it moves.
    pub tuning: &'a Motion,
    /// By feature; those beyond the end have the default.
    pub traits: &'a [Traits],
    /// The moving solids.
    pub movers: &'a [Mover],
}

impl<'a> Terrain<'a> {
    /// Still ground without any traits.
    pub fn new(stand: &'a Mesh, crouch: &'a Mesh, tuning: &'a Motion) -> Terrain<'a> {
        Terrain {
            stand,
            crouch,
            tuning,
            traits: &[],
            movers: &[],
        }
    }

    /// The mesh of the level for a size.
    pub fn mesh(&self, size: Size) -> &'a Mesh {
        match size {
            Size::Stand => self.stand,
            Size::Crouch => self.crouch,
        }
    }

    /// The level as a body of a size meets it.
    pub fn ground(&self, size: Size) -> Ground<'a> {
        Ground {
            mesh: self.mesh(size),
            traits: self.traits,
            max_slope: self.tuning.max_slope,
            climbing: false,
            ends: false,
        }
    }

    /// What carries a body, or the level if nothing does, as a body of a size meets it.
    pub fn ground_under(&self, mover: Option<u32>, size: Size) -> Ground<'a> {
        match mover {
            None => self.ground(size),
            Some(mover) => Ground {
                mesh: self.movers[mover as usize].mesh(size),
                traits: self.traits,
                max_slope: self.tuning.max_slope,
                climbing: false,
                ends: false,
            },
        }
    }

    /// What two features say about a concave joint between them, the same from either side: `Project` if one of them says
    /// so, else `Keep` if one of them does, else nothing.
    pub(super) fn concave_of(&self, a: FeatureId, b: FeatureId) -> Option<Concave> {
        match (self.traits_of(a).concave, self.traits_of(b).concave) {
            (Some(Concave::Keep), Some(Concave::Keep) | None) => Some(Concave::Keep),
            (None, b) => b,
            (Some(_), _) => Some(Concave::Project),
        }
    }

    /// Whether to come to stand on a moving solid, and to leave it, are events.
    pub(super) fn minds_riders(&self, mover: u32) -> bool {
        let mut features = self.movers[mover as usize].stand.features();
        features.any(|f| self.traits_of(f).minds_riders)
    }

    /// The traits of a feature.
    pub fn traits_of(&self, feature: FeatureId) -> Traits {
        self.traits
            .get(feature as usize)
            .copied()
            .unwrap_or_default()
    }
}

/// A mesh as a body meets it: besides solids, one-ways stop who comes from their front.
#[derive(Clone, Copy, Debug)]
pub struct Ground<'a> {
    /// The mesh.
    pub mesh: &'a Mesh,
    /// By feature; those beyond the end have the default.
    pub traits: &'a [Traits],
    /// Steepest ground that can be stood on.
    pub max_slope: f64,
    /// To who climbs on a ladder: one-ways that can be stood on do not stop him, where it leads on through them.
    pub climbing: bool,
    /// To who climbs on a ladder of this mesh: the tops and the bottoms of its ladders stop him.
    pub ends: bool,
}

impl<'a> Ground<'a> {
    /// Whether the ground of a feature is a belt, or has a friction of its own.
    pub fn drives(&self, feature: FeatureId) -> bool {
        self.traits
            .get(feature as usize)
            .is_some_and(|t| t.conveyor != 0.0 || t.friction.is_some())
    }

    /// What decides between feature edges that are alike but for their traits: the faster belt, the larger friction, what can be
    /// climbed, what says how its concave joints are; then the upper and the steeper one. It does not depend on the order in which
    /// features come, and mirrored ones have the same.
    pub(super) fn rank(&self, segment: &Segment) -> impl Ord + use<> {
        let traits = self.traits_of(segment.feature);
        let concave = traits.concave.map(|concave| concave == Concave::Keep);
        let (_, dy) = segment.direction();
        (
            // Of numbers that are not negative the bits have their order.
            traits.conveyor.abs().to_bits(),
            traits.friction.map(|friction| friction.abs().to_bits()),
            traits.climbable,
            concave,
            i64::from(segment.a.y) + i64::from(segment.b.y),
            dy.abs(),
        )
    }

    /// Whether along an edge of the mesh a belt lies flush with one that runs the other way just as fast, so that neither moves.
    pub(super) fn is_held_still(self, e: EdgeId, belt: SegmentId) -> bool {
        let speed = |s: SegmentId| self.traits_of(self.mesh.segment(s).feature).conveyor;
        let long = |s: SegmentId| {
            let (dx, dy) = self.mesh.segment(s).direction();
            dx * dx + dy * dy
        };
        let against = |s: SegmentId| speed(s) == -speed(belt) && long(s) == long(belt);
        speed(belt) != 0.0 && self.facing(e).any(|s| self.walkable(s) && against(s))
    }

    /// Whether walkers are driven alike on two feature edges, each along an edge of the mesh: then a joint between them that goes
    /// straight on is no event.
    pub(super) fn drive_alike(self, a: (EdgeId, SegmentId), b: (EdgeId, SegmentId)) -> bool {
        let drive = |(e, s): (EdgeId, SegmentId)| {
            let traits = self.traits_of(self.mesh.segment(s).feature);
            match self.is_held_still(e, s) {
                true => (0.0, traits.friction),
                false => (traits.conveyor, traits.friction),
            }
        };
        drive(a) == drive(b)
    }

    fn traits_of(&self, feature: FeatureId) -> Traits {
        let traits = self.traits.get(feature as usize).copied();
        traits.unwrap_or_default()
    }

    /// The same as it meets one who climbs on a ladder, or does not.
    pub fn climbed(self, climbing: bool) -> Ground<'a> {
        Ground {
            climbing,
            ends: climbing,
            ..self
        }
    }

    /// The same as it meets one whose ladder is, or is not, of this mesh.
    pub fn with_ladder(self, here: bool) -> Ground<'a> {
        let ends = self.ends && here;
        Ground { ends, ..self }
    }

    /// Whether a body left of the edge is stopped by it: by a solid on its right, by a line, or by the front of a one-way. So
    /// a one-way is decided by the face that the body comes from, and by nothing else.
    #[inline]
    pub fn blocks(&self, e: EdgeId) -> bool {
        self.mesh.blocks(e)
            || self.mesh.has_front(e) && self.has_front_that_stops(e)
            || self.ends && self.ends_ladder(e)
    }

    /// Whether one-ways alone stop a body left of the edge.
    pub fn is_one_way(&self, e: EdgeId) -> bool {
        let is_line = |s: SegmentId| self.mesh.kind(s) == Kind::Line;
        !self.mesh.blocks(e)
            && self.mesh.has_front(e)
            && self.has_front_that_stops(e)
            && !self.mesh.fronts(e).any(is_line)
    }

    fn has_front_that_stops(&self, e: EdgeId) -> bool {
        let free = self.mesh.left(e).is_some_and(|f| !self.mesh.is_solid(f));
        free && self.mesh.fronts(e).any(|s| self.stops(s)) && !(self.climbing && self.is_passage(e))
    }

    /// Whether one-ways alone stop a body left of the edge, that can be stood on, and its ladder leads on through them.
    fn is_passage(&self, e: EdgeId) -> bool {
        let is_platform = |s| self.mesh.kind(s) == Kind::OneWay && self.walkable(s);
        self.mesh
            .fronts(e)
            .filter(|&s| self.stops(s))
            .all(is_platform)
            && self.leads_below(e)
    }

    /// Whether a climber who comes down to a one-way from above goes on below it: if his ladder has been drawn further down than
    /// that, or another one begins where it ends. In a frame without his ladder one-ways are nothing to him.
    fn leads_below(&self, e: EdgeId) -> bool {
        let above = self.mesh.left(e);
        let his = self.ends && above.is_some_and(|f| self.is_ladder(f));
        !his || self.leads_down_from(e)
    }

    /// Whether a ladder leads down from an edge, on the left of which a body stands.
    pub(super) fn leads_down_from(&self, e: EdgeId) -> bool {
        let below = self.mesh.left(self.mesh.sym(e));
        let (a, b) = self.mesh.ends(e);
        let height = a.y.min(b.y);
        let cover = below.map_or(&[][..], |f| self.mesh.cover(f));
        let rungs = cover.iter().filter(|&&f| self.is_rung(f));
        rungs.into_iter().any(|&f| self.is_drawn_below(f, height))
    }

    /// Whether a ladder has been drawn further down than a height, in grid steps and by more than a joint, or leads on to one.
    fn is_drawn_below(&self, ladder: FeatureId, height: i32) -> bool {
        let mesh = self.mesh;
        let above_region = self.traits.get(ladder as usize).map_or(0.0, |t| t.drawn[0]);
        let lowest = height - in_steps(above_region) - JOINT_STEPS;
        let is_foot = |s: SegmentId| {
            let segment = mesh.segment(s);
            self.is_end(s) && segment.a.x < segment.b.x
        };
        let goes_on = |s: SegmentId| {
            let edges = mesh.chain(s).windows(2);
            let mut edges = edges.filter_map(|v| mesh.edge_between(v[1], v[0]));
            edges.any(|e| mesh.left(e).is_some_and(|f| self.is_ladder(f)))
        };
        let mut feet = mesh.segments_of(ladder).iter().filter(|&&s| is_foot(s));
        feet.any(|&s| {
            let Segment { a, b, .. } = *mesh.segment(s);
            a.y.min(b.y) < lowest || goes_on(s)
        })
    }

    /// Whether a ladder covers the face.
    pub fn is_ladder(&self, f: FaceId) -> bool {
        self.mesh.cover(f).iter().any(|&f| self.is_rung(f))
    }

    fn is_rung(&self, feature: FeatureId) -> bool {
        let traits = self.traits.get(feature as usize);
        traits.is_some_and(|t| t.region == Region::Ladder)
    }

    /// Whether an edge is the top or the bottom of the ladder on its left, with free space beyond.
    fn ends_ladder(&self, e: EdgeId) -> bool {
        let [inside, beyond] = [e, self.mesh.sym(e)].map(|e| self.mesh.left(e));
        let is_ladder = |f: Option<FaceId>| f.is_some_and(|f| self.is_ladder(f));
        let free = inside.is_some_and(|f| !self.mesh.is_solid(f));
        let mut uses = self.mesh.uses(e);
        free && is_ladder(inside)
            && !is_ladder(beyond)
            && uses.any(|u| u.forward && self.is_end(u.segment))
    }

    /// Whether a feature edge is the top or the bottom of a ladder: rising at most 45 degrees.
    pub(super) fn is_end(&self, s: SegmentId) -> bool {
        let segment = self.mesh.segment(s);
        let (dx, dy) = segment.direction();
        dy.abs() <= dx.abs() && self.is_rung(segment.feature)
    }

    /// The feature edges along an edge that a body left of it can meet: those of solids and of one-ways that have their free
    /// side, or their front, there. Regions stop nobody.
    pub fn facing(self, e: EdgeId) -> impl Iterator<Item = SegmentId> + 'a {
        let meets = move |u: &Use| match self.mesh.kind(u.segment) {
            Kind::Region => u.forward && self.ends && self.is_end(u.segment),
            _ => !u.forward && self.stops(u.segment),
        };
        self.mesh.uses(e).filter(meets).map(|u| u.segment)
    }

    /// Whether a feature edge stops who comes from its free side, or its front.
    fn stops(&self, s: SegmentId) -> bool {
        match self.mesh.kind(s) {
            Kind::Solid | Kind::Line => true,
            Kind::OneWay => self.walkable(s) || self.is_held_up(s),
            Kind::Region => false,
        }
    }

    /// Whether a feature edge of a one-way that cannot be stood on stops who comes from its front: a wall or a ceiling.
    ///
    /// All that has been drawn does, and what the collider's sides make of its bends. At its ends they do if they go on as it
    /// is, as a wall or as a ceiling: so it is passed beyond its end, as a platform is.
    fn is_held_up(&self, s: SegmentId) -> bool {
        let segment = self.mesh.segment(s);
        let Source::Corner { vertex, .. } = segment.source else {
            return true;
        };
        let drawn = |edge: u32| {
            let source = Source::Edge { edge };
            self.mesh.segment_of(segment.feature, source)
        };
        match (vertex.checked_sub(1).and_then(drawn), drawn(vertex)) {
            (Some(end), None) | (None, Some(end)) => {
                !self.walkable(end) && self.is_wall(end) == self.is_wall(s)
            }
            (into, _) => into.is_some(),
        }
    }

    /// Whether a feature edge can be stood on.
    pub fn walkable(&self, s: SegmentId) -> bool {
        self.mesh.kind(s) != Kind::Region && walkable(self.mesh.segment(s), self.max_slope)
    }

    /// Whether a feature edge is a wall.
    pub fn is_wall(&self, s: SegmentId) -> bool {
        is_wall(self.mesh.segment(s), self.max_slope)
    }

    /// The length of a feature edge, m.
    pub(super) fn length(&self, s: SegmentId) -> f64 {
        let segment = self.mesh.segment(s);
        (segment.b.metres() - segment.a.metres()).length()
    }

    /// The exact direction of a motion along the road of a feature edge, towards growing (1) or falling (-1) parameters, as that
    /// was drawn.
    pub(super) fn heading(&self, s: SegmentId, track: &Track, sign: f64) -> (i64, i64) {
        let segment = self.mesh.segment(s);
        // The end of a ladder is met from the other side; nothing is compared with its direction.
        if segment.aside.is_none() || self.mesh.kind(s) == Kind::Region {
            return track.heading(sign);
        }
        let (dx, dy) = segment.direction();
        match (sign > 0.0) == track.leftward_free {
            true => (-dx, -dy),
            false => (dx, dy),
        }
    }

    /// The height of a feature edge at one of its vertices, as it was drawn: at its ends, or if it is level.
    pub(super) fn height(&self, s: SegmentId, vertex: Point) -> Height {
        let segment = self.mesh.segment(s);
        let [a, b] = segment.drawn();
        match () {
            () if vertex == segment.a || a.y == b.y => Height::of(a),
            () if vertex == segment.b => Height::of(b),
            () => Height::rounded(vertex),
        }
    }

    /// The road along a feature edge; that of a ladder's end is on its inside.
    pub fn track(&self, s: SegmentId) -> Track {
        let segment = *self.mesh.segment(s);
        let Segment { a, b, .. } = segment;
        match self.mesh.kind(s) {
            Kind::Region => Track::of(&Segment {
                a: b,
                b: a,
                aside: segment.aside.turned(),
                ..segment
            }),
            _ => Track::of(&segment),
        }
    }
}

impl Deref for Ground<'_> {
    type Target = Mesh;

    fn deref(&self) -> &Mesh {
        self.mesh
    }
}
