//! The world: the hero and other bodies in one level, tick by tick.

use super::going::Going;
use super::meshes::Shape;
use super::snapshot::State;
use super::stage::{Edit, EditError, Land, Stage};
use super::{Input, Stance, View};
use crate::anim::Leap;
use crate::level::{Feature, Kind};
use crate::mesh::{Mesh, MeshError};
use crate::motion::{Body, Control, EventKind, Grip, Mode, Size, SpawnError, Trace, check};
use crate::tune::{Motion, Tuning};
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use xxhash_rust::xxh3::Xxh3;

/// The whole simulation. Clone it, or take a [`Snapshot`](super::Snapshot), to come back to this moment.
#[derive(Clone, Debug)]
pub struct World {
    pub(super) stage: Arc<Stage>,
    pub(super) state: State,
    /// The ground for each shape of the state, in the same order.
    pub(super) lands: Arc<Vec<Land>>,
    /// What happened to each body in the last tick.
    pub(super) traces: Vec<Trace>,
}

/// A body in the world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Actor {
    /// Index of its shape.
    pub(super) shape: usize,
    /// What it wants, from the next tick on.
    pub(super) control: Control,
    pub(super) body: Body,
}

/// Why a body cannot be added.
#[derive(Clone, Debug, PartialEq)]
pub enum AddError {
    /// It does not fit there.
    Spawn(SpawnError),
    /// The level has no meshes for its shape.
    Mesh(MeshError),
}

impl std::fmt::Display for AddError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self {
            AddError::Spawn(error) => error.fmt(f),
            AddError::Mesh(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for AddError {}

/// The hero's place among the bodies.
pub(super) const HERO: usize = 0;

impl World {
    /// A world at tick 0, the hero at the start; `tick_rate` ticks a second, at least one.
    pub fn new(stage: Arc<Stage>, tick_rate: u32, seed: u64) -> World {
        let tuning = Motion::default();
        let land = stage
            .land(&Shape::hero())
            .expect("the stage was built for the hero");
        let body = Body::spawn(stage.level.start, 0.0, &land.terrain(&stage, &tuning))
            .expect("the stage was built with a free start");
        let mut world = World {
            state: State::new(&stage, body, tick_rate.max(1), seed),
            stage,
            lands: Arc::new(vec![land]),
            traces: vec![Trace::default()],
        };
        world.note_area();
        world
    }

    /// One tick: takes the input, then moves all bodies to the tick's end, event by event; then the rules.
    pub fn step(&mut self, input: Input, tuning: &Tuning) {
        self.traces.iter_mut().for_each(Trace::clear);
        if self.state.tuning != tuning.motion {
            self.state.tuning = tuning.motion.clone();
            self.each(|body, terrain, trace| body.retune(terrain, trace));
        }
        if input.retry && !self.state.retry {
            self.restart();
        } else if input.respawn || self.is_doomed() {
            self.die(self.time());
        }
        self.state.retry = input.retry;
        self.state.actors[HERO].control = input.control();
        self.each_actor(|actor, terrain, trace| actor.body.apply(actor.control, terrain, trace));
        self.note_riders(self.time());
        self.state.tick += 1;
        self.run(self.time());
        self.note_events(input);
        self.note_area();
    }

    /// Does something with every body in its terrain.
    pub(super) fn each(
        &mut self,
        mut act: impl FnMut(&mut Body, &crate::motion::Terrain, &mut Trace),
    ) {
        self.each_actor(|actor, terrain, trace| act(&mut actor.body, terrain, trace));
    }

    fn each_actor(&mut self, mut act: impl FnMut(&mut Actor, &crate::motion::Terrain, &mut Trace)) {
        let State { actors, tuning, .. } = &mut self.state;
        for (actor, trace) in actors.iter_mut().zip(&mut self.traces) {
            let terrain = self.lands[actor.shape].terrain(&self.stage, tuning);
            act(actor, &terrain, trace);
        }
    }

    /// Adds a body at rest, its foot at `at` (m); its number, by which it is then known. The hero's is 0.
    ///
    /// # Errors
    /// If it does not fit there, or the expanded level leaves the world.
    pub fn add_body(&mut self, shape: &Shape, at: DVec2) -> Result<usize, AddError> {
        let index = match self.state.shapes.iter().position(|s| s == shape) {
            Some(index) => index,
            None => {
                let mut land = self.stage.land(shape).map_err(AddError::Mesh)?;
                Going::bring(&self.state.going, &self.stage, &mut land);
                Arc::make_mut(&mut self.lands).push(land);
                self.state.shapes.push(shape.clone());
                self.lands.len() - 1
            }
        };
        let terrain = self.lands[index].terrain(&self.stage, &self.state.tuning);
        let body = Body::spawn(at, self.time(), &terrain).map_err(AddError::Spawn)?;
        self.state.actors.push(Actor {
            shape: index,
            control: Control::default(),
            body,
        });
        self.traces.push(Trace::default());
        Ok(self.state.actors.len() - 1)
    }

    /// What a body other than the hero shall want from the next tick on.
    pub fn control(&mut self, body: usize, control: Control) {
        if let Some(actor) = self.state.actors.get_mut(body) {
            actor.control = control;
        }
    }

    /// Puts the hero somewhere, at rest, his foot at `at` (m).
    ///
    /// # Errors
    /// If he does not fit there; he then stays where he is.
    pub fn put(&mut self, at: DVec2) -> Result<(), SpawnError> {
        let terrain = self.lands[HERO].terrain(&self.stage, &self.state.tuning);
        self.state.actors[HERO].body = Body::spawn(at, self.time(), &terrain)?;
        self.note_area();
        Ok(())
    }

    /// Checks the invariants of all bodies after the last tick.
    ///
    /// # Errors
    /// The first that does not hold, and whose.
    pub fn check(&self) -> Result<(), String> {
        let State { actors, tuning, .. } = &self.state;
        for (number, (actor, trace)) in actors.iter().zip(&self.traces).enumerate() {
            let terrain = self.lands[actor.shape].terrain(&self.stage, tuning);
            let stuck = trace.events.iter().any(|e| e.kind == EventKind::Stuck);
            let checked = match stuck {
                true => Err("its events did not end".into()),
                false => check::check(&actor.body, &terrain, trace),
            };
            checked.map_err(|error| match number {
                HERO => error,
                _ => format!("body {number}: {error}"),
            })?;
        }
        Ok(())
    }

    /// Changes the level under the bodies. Those that touch nothing of the change do not notice it.
    ///
    /// # Errors
    /// As [`Stage::edit`]; nothing has changed then.
    pub fn edit(&mut self, edit: Edit) -> Result<(), EditError> {
        let mut anchors = Vec::new();
        self.each(|body, terrain, _| anchors.push(body.anchor(terrain)));
        // Let go of the meshes, so that they are changed in place.
        self.lands = Arc::default();
        let edited = Arc::make_mut(&mut self.stage).edit(edit);
        self.lands = Arc::new(self.state.lands(&self.stage));
        edited?;
        let mut anchors = anchors.iter();
        self.each(|body, terrain, trace| {
            let anchor = anchors.next().expect("every body has its anchor");
            body.rehome(anchor, terrain, trace);
        });
        Ok(())
    }

    /// Goes on in another version of the level: bodies stay where they are if that place is free; else the hero
    /// restarts, and others are gone.
    pub fn replace_stage(&mut self, stage: Arc<Stage>) {
        self.state.forget_level(&stage);
        self.stage = stage;
        self.lands = Arc::new(self.state.lands(&self.stage));
        let (time, traces) = (self.time(), &mut self.traces);
        let State { actors, tuning, .. } = &mut self.state;
        let mut index = 0;
        let mut lost = false;
        actors.retain_mut(|actor| {
            let terrain = self.lands[actor.shape].terrain(&self.stage, tuning);
            let (p, v) = (actor.body.position(), actor.body.velocity());
            let placed = Body::spawn(p, time, &terrain).map(|mut body| {
                body.set_velocity(v, &terrain, &mut traces[index]);
                actor.body = body;
            });
            let stays = index == HERO || placed.is_ok();
            lost |= index == HERO && placed.is_err();
            index += 1;
            stays
        });
        self.traces
            .resize_with(self.state.actors.len(), Trace::default);
        if lost {
            self.restart();
        }
        self.note_area();
    }

    /// What to draw.
    pub fn view(&self) -> View {
        let (hero, state) = (self.hero(), &self.state);
        View {
            time: self.time(),
            position: hero.position(),
            velocity: hero.velocity(),
            normal: hero.normal(),
            stance: match hero.mode() {
                _ if hero.climbing() => Stance::Climb,
                Mode::Air(_) => Stance::Air,
                Mode::Surface(_) if hero.supported() => Stance::Ground,
                Mode::Surface(_) => Stance::Slide,
                Mode::Wedge(_) | Mode::Crushed(_) => Stance::Wedge,
            },
            crouched: hero.size() == Size::Crouch,
            facing: state.facing,
            material: self.underfoot().map(|feature| feature.material),
            grip: hero.grip(),
            carried: self.carried(),
            ledge: self.ledge(),
            left_at: state.left_at,
            leap: state.leap,
            held_at: state.held_at,
            landed_at: state.landed_at,
            landed_speed: state.landed_speed,
            won_at: state.won_at,
            deaths: state.deaths,
            began_at: state.began_at,
            area: state.area,
            secrets: state.secrets.len() as u32,
            secret_at: state.secret_at,
            checkpoint: self.checkpoint().and_then(|feature| feature.respawn),
        }
    }

    /// The feature that the hero is on: the ladder that he climbs, or the ground or wall in contact.
    pub fn underfoot(&self) -> Option<&Feature> {
        if self.hero().climbing() {
            let regions = self.hero().regions().iter();
            let mut features = regions.filter_map(|&id| self.stage.feature(id));
            return features.find(|feature| feature.kind == Kind::Ladder);
        }
        let segment = self.hero().segment()?;
        self.stage
            .feature(self.mesh_under().segment(segment).feature)
    }

    /// The checkpoint at which the hero would come back; `None`: at the start.
    pub fn checkpoint(&self) -> Option<&Feature> {
        self.stage.feature(self.state.checkpoint?)
    }

    /// The mesh of what carries the hero: of a mover, where it was drawn, or of the level.
    pub fn mesh_under(&self) -> &Mesh {
        let carrier = self.hero().carrier();
        let mover = carrier.and_then(|i| self.lands[HERO].movers.get(i as usize));
        mover.map_or(self.mesh(), |mover| mover.mesh(self.hero().size()))
    }

    /// Hash of the state, equal on every machine and in every build.
    pub fn hash(&self) -> u64 {
        let mut hash = Xxh3::new();
        for actor in &self.state.actors {
            actor.body.hash_into(&mut hash);
        }
        self.state.hash_into(&mut hash);
        hash.digest()
    }

    /// Ticks done.
    pub fn tick(&self) -> u64 {
        self.state.tick
    }

    /// Ticks a second.
    pub fn tick_rate(&self) -> u32 {
        self.state.rate
    }

    /// Simulated seconds: the tick's number over the rate, rounded once.
    pub fn time(&self) -> f64 {
        self.state.tick as f64 / f64::from(self.state.rate)
    }

    /// The level with its meshes.
    pub fn stage(&self) -> &Arc<Stage> {
        &self.stage
    }

    /// The hero's body.
    pub fn hero(&self) -> &Body {
        &self.state.actors[HERO].body
    }

    /// All bodies, the hero first.
    pub fn bodies(&self) -> impl ExactSizeIterator<Item = &Body> {
        self.state.actors.iter().map(|actor| &actor.body)
    }

    /// The ground that a body moves in.
    pub fn land(&self, body: usize) -> &Land {
        &self.lands[self.state.actors[body].shape]
    }

    /// How far each mover is from where it was drawn at a time near now, m.
    pub fn offsets_at(&self, time: f64) -> impl ExactSizeIterator<Item = DVec2> {
        let offset = move |mover: &crate::motion::Mover| mover.piece_at(time).offset(time);
        self.lands[HERO].movers.iter().map(offset)
    }

    /// The mesh of the level that the hero moves in now.
    pub fn mesh(&self) -> &Mesh {
        let land = &self.lands[HERO];
        match self.hero().size() {
            Size::Stand => &land.stand.level,
            Size::Crouch => &land.crouch.level,
        }
    }

    /// What happened to the hero in the last tick.
    pub fn trace(&self) -> &Trace {
        &self.traces[HERO]
    }

    /// What happened to a body in the last tick.
    pub fn trace_of(&self, body: usize) -> &Trace {
        &self.traces[body]
    }
}

impl Input {
    /// As the hero's body takes it.
    pub fn control(self) -> Control {
        Control {
            run: f64::from(self.run.max(-127)) / 127.0,
            jump: self.jump,
            down: self.down,
            up: self.up,
        }
    }
}

impl View {
    /// Nothing yet: at rest at a place.
    pub fn at(position: DVec2) -> View {
        View {
            time: 0.0,
            position,
            velocity: DVec2::ZERO,
            normal: DVec2::ZERO,
            stance: Stance::Air,
            crouched: false,
            facing: 1.0,
            material: None,
            grip: Grip::None,
            carried: DVec2::ZERO,
            ledge: 0.0,
            left_at: 0.0,
            leap: Leap::Walked,
            held_at: 0.0,
            landed_at: 0.0,
            landed_speed: 0.0,
            won_at: None,
            deaths: 0,
            began_at: 0.0,
            area: 0,
            secrets: 0,
            secret_at: None,
            checkpoint: None,
        }
    }

    /// How long the run has taken, in seconds: up to the goal, if that has been reached.
    pub fn run_time(&self) -> f64 {
        self.won_at.unwrap_or(self.time) - self.began_at
    }
}
