//! A run as a value: a level, a body's start, its inputs and the edits of the level. It can be repeated, mirrored, cut down
//! and written to a file.

use edgewalker::geom::{Collider, Point};
use edgewalker::level::{Concave, Easing, Feature, Kind, Mover, Repeat, Starts, Stop};
use edgewalker::mesh::{self, FeatureId, Mesh};
use edgewalker::motion::mover::{self, Path, Piece};
use edgewalker::motion::terrain::{self, Region, Traits};
use edgewalker::motion::{Control, Terrain};
use edgewalker::tune::Motion;
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Case {
    /// The random world that it comes from.
    pub seed: u64,
    pub world: World,
    pub life: Life,
}

/// A level, who moves in it, and how.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct World {
    pub features: Vec<Feature>,
    pub movers: Vec<Mover>,
    pub tuning: Motion,
    pub body: Build,
    /// Ticks a second.
    pub rate: f64,
}

/// The sizes of a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Build {
    Hero,
    Small,
    Wide,
}

/// What happens to one body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Life {
    /// The tick at which it starts.
    pub since: u64,
    /// Where its foot starts, m.
    pub start: DVec2,
    /// From which tick of the life on which control is held.
    pub inputs: Vec<(u64, Control)>,
    /// At which tick of the life what is done to the level.
    pub edits: Vec<(u64, Edit)>,
    /// How long it lasts.
    pub ticks: u64,
}

/// A change of the level.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Edit {
    /// A new feature where it is drawn.
    Insert(Feature),
    /// A new feature drawn about the origin, where the body is.
    InsertHere(Feature),
    /// The feature with this index away; nothing if there is none.
    Remove(FeatureId),
    /// The feature that the body stands on away; nothing if it does not stand.
    RemoveGround,
}

impl Build {
    /// Standing and crouching.
    pub fn colliders(self) -> [Collider; 2] {
        let upright = |half: f64, tall: f64| {
            let corners = [(-half, 0.0), (half, 0.0), (half, tall), (-half, tall)];
            let snap = |c: (f64, f64)| Point::snap(DVec2::from(c)).unwrap();
            Collider::new(corners.map(snap).to_vec()).unwrap()
        };
        match self {
            Build::Hero => [Collider::hero(), Collider::hero_crouched()],
            Build::Small => [upright(0.25, 0.5), upright(0.25, 0.25)],
            Build::Wide => [upright(0.75, 1.5), upright(0.75, 1.0)],
        }
    }
}

/// The meshes of a world.
#[derive(Clone)]
pub struct Ready {
    pub colliders: [Collider; 2],
    pub meshes: [Mesh; 2],
    pub movers: Vec<mover::Mover>,
    pub traits: Vec<Traits>,
    /// Edits have been made.
    pub edited: bool,
}

impl World {
    /// Builds the meshes. The features come first, then those of the movers.
    pub fn ready(&self) -> Ready {
        let colliders = self.body.colliders();
        let mesh = |features: &[Feature], first: usize, collider: &Collider| {
            let list = features.iter().enumerate();
            let parts = list.map(|(i, f)| ((first + i) as FeatureId, kind(f), f.expand(collider)));
            Mesh::of(&parts.collect::<Vec<_>>()).unwrap()
        };
        let meshes = colliders.each_ref().map(|c| mesh(&self.features, 0, c));
        let traits_of = |feature: &Feature| Traits {
            drawn: feature.drawn_ends(&colliders[0]),
            ..traits(feature)
        };
        let mut traits: Vec<Traits> = self.features.iter().map(traits_of).collect();
        let mut movers = Vec::new();
        for m in &self.movers {
            let [stand, crouch] = colliders
                .each_ref()
                .map(|c| Arc::new(mesh(&m.features, traits.len(), c)));
            let ridden = m.starts == Starts::Ridden;
            traits.extend(m.features.iter().map(|f| Traits {
                minds_riders: ridden,
                ..traits_of(f)
            }));
            let (path, start) = (path(m), (!ridden).then_some(0.0));
            movers.push(mover::Mover {
                stand,
                crouch,
                path,
                start,
            });
        }
        Ready {
            colliders,
            meshes,
            movers,
            traits,
            edited: false,
        }
    }
}

impl Ready {
    /// What bodies move in.
    pub fn terrain<'a>(&'a self, tuning: &'a Motion) -> Terrain<'a> {
        Terrain {
            traits: &self.traits,
            movers: &self.movers,
            ..Terrain::new(&self.meshes[0], &self.meshes[1], tuning)
        }
    }

    /// Movers that begin when they are ridden wait again.
    pub fn park(&mut self, world: &World) {
        for (mover, drawn) in self.movers.iter_mut().zip(&world.movers) {
            if drawn.starts == Starts::Ridden {
                mover.start = None;
            }
        }
    }

    /// Puts a feature into all meshes of the level.
    pub fn insert(&mut self, feature: &Feature) {
        let id = self.traits.len() as FeatureId;
        self.traits.push(traits(feature));
        for (mesh, collider) in self.meshes.iter_mut().zip(&self.colliders) {
            mesh.insert_as(id, kind(feature), &feature.expand(collider))
                .unwrap();
        }
        self.edited = true;
    }

    /// Takes a feature out of all meshes of the level, if it is in them.
    pub fn remove(&mut self, id: FeatureId) {
        if self.meshes[0].kind_of(id).is_some() {
            for mesh in &mut self.meshes {
                mesh.remove(id).unwrap();
            }
            self.edited = true;
        }
    }
}

fn kind(feature: &Feature) -> mesh::Kind {
    match feature.kind {
        Kind::Solid => mesh::Kind::Solid,
        Kind::OneWay => mesh::Kind::OneWay,
        _ => mesh::Kind::Region,
    }
}

fn traits(feature: &Feature) -> Traits {
    Traits {
        region: match feature.kind {
            Kind::Solid | Kind::OneWay => Region::None,
            Kind::Ladder => Region::Ladder,
            _ => Region::Plain,
        },
        drawn: [0.0; 2],
        climbable: feature.climbable,
        conveyor: feature.conveyor,
        friction: feature.friction,
        concave: feature.concave.map(|c| match c {
            Concave::Keep => terrain::Concave::Keep,
            Concave::Project => terrain::Concave::Project,
        }),
        minds_riders: false,
    }
}

/// The motion of a mover that starts at time 0.
fn path(mover: &Mover) -> Path {
    let mut stops = mover.path.clone();
    if mover.repeat == Repeat::PingPong {
        // On the way back the seconds of a way stand at its other end.
        let back = (1..stops.len().saturating_sub(1)).rev();
        let turned = back.map(|i| Stop {
            seconds: stops[i - 1].seconds,
            ..stops[i]
        });
        let turned: Vec<Stop> = turned.collect();
        if let [.., before, last] = stops.as_mut_slice() {
            last.seconds = before.seconds;
        }
        stops.extend(turned);
    }
    let (mut pieces, mut t) = (Vec::new(), 0.0);
    for (i, stop) in stops.iter().enumerate() {
        let next = &stops[(i + 1) % stops.len()];
        leg(stop, next, &mut t, &mut pieces);
    }
    Path {
        pieces,
        period: (mover.repeat != Repeat::Once).then_some(t),
    }
}

/// The wait at a stop and the way to the next one.
fn leg(stop: &Stop, next: &Stop, t: &mut f64, pieces: &mut Vec<Piece>) {
    let [from, to] = [stop.at, next.at].map(|p| Point::snap(p).unwrap().metres());
    let (still, v) = (DVec2::ZERO, (to - from) / stop.seconds);
    let mut push = |t0: f64, p0: DVec2, v0: DVec2, accel: DVec2| {
        pieces.push(Piece { t0, p0, v0, accel });
    };
    if stop.wait > 0.0 {
        push(*t, from, still, still);
        *t += stop.wait;
    }
    if stop.seconds > 0.0 {
        let half = 0.5 * stop.seconds;
        if stop.easing == Easing::Eased {
            push(*t, from, still, 2.0 * v / half);
            push(*t + half, 0.5 * (from + to), 2.0 * v, -2.0 * v / half);
        } else {
            push(*t, from, v, still);
        }
        *t += stop.seconds;
    }
}

impl Case {
    /// The same left and right.
    pub fn mirrored(&self) -> Case {
        let mut case = self.clone();
        let flip = |p: &mut DVec2| p.x = -p.x;
        let turn = |feature: &mut Feature| {
            feature.outline.iter_mut().for_each(flip);
            feature.outline.reverse();
            feature.conveyor = -feature.conveyor;
        };
        case.world.features.iter_mut().for_each(turn);
        for mover in &mut case.world.movers {
            mover.features.iter_mut().for_each(turn);
            mover.path.iter_mut().for_each(|stop| flip(&mut stop.at));
        }
        flip(&mut case.life.start);
        for (_, control) in &mut case.life.inputs {
            control.run = -control.run;
        }
        for (_, edit) in &mut case.life.edits {
            if let Edit::Insert(feature) | Edit::InsertHere(feature) = edit {
                turn(feature);
            }
        }
        case
    }
}
