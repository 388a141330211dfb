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
    /// Of each body: how many of these events have had their consequences.
    pub(super) done: Vec<usize>,
    /// Of each body: how many were there at the end of the last tick.
    pub(super) told: Vec<usize>,
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
            done: vec![0],
            told: vec![0],
        };
        world.begin(HERO);
        world.settle();
        world.note_area();
        world
    }

    /// One tick: takes the input, then moves all bodies to the tick's end, event by event, with what the rules make of them.
    pub fn step(&mut self, input: Input, tuning: &Tuning) {
        self.forget_told();
        if self.state.tuning != tuning.motion {
            self.state.tuning = tuning.motion.clone();
            self.state.marked |= tuning.motion != Motion::default();
            self.each(|body, terrain, trace| body.retune(terrain, trace));
            self.settle();
        }
        let is_new = (
            input.retry && !self.state.retry,
            input.respawn && !self.state.respawn,
        );
        (self.state.retry, self.state.respawn) = (input.retry, input.respawn);
        match is_new {
            (true, _) => self.restart(),
            (_, true) if self.state.away.is_none() && self.state.won_at.is_none() => {
                self.die(self.time());
            }
            _ => {}
        }
        self.state.actors[HERO].control = input.control();
        self.apply_controls();
        self.note_riders(self.time());
        self.state.tick += 1;
        self.run(self.time());
        self.note_events(input);
        self.note_area();
        self.told();
    }

    /// All bodies take their controls; who is nowhere has them when he comes.
    fn apply_controls(&mut self) {
        let away = self.state.away.is_some();
        let mut is_hero = true;
        self.each_actor(
            |actor, terrain, trace| match std::mem::take(&mut is_hero) && away {
                true => actor.body.wish(actor.control),
                false => actor.body.apply(actor.control, terrain, trace),
            },
        );
    }

    /// The traces tell of the next tick from now on, and of what has happened since the last one.
    fn forget_told(&mut self) {
        for ((trace, done), told) in self
            .traces
            .iter_mut()
            .zip(&mut self.done)
            .zip(&mut self.told)
        {
            trace.forget(*told);
            (*done, *told) = (*done - *told, 0);
        }
    }

    /// All events have been told at the end of a tick.
    fn told(&mut self) {
        for (told, trace) in self.told.iter_mut().zip(&self.traces) {
            *told = trace.events.len();
        }
    }

    /// From now on the run counts for no best time.
    pub fn mark(&mut self) {
        self.state.marked = true;
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
        self.done.push(0);
        self.told.push(0);
        let number = self.state.actors.len() - 1;
        self.begin(number);
        self.settle();
        Ok(number)
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
        self.state.away = None;
        self.begin(HERO);
        self.settle();
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
        self.state.marked = true;
        self.settle();
        self.look_for_way_back(self.time());
        Ok(())
    }

    /// Goes on in another version of the level: bodies stay where they are, as fast as they are, if that place is free; else
    /// the hero restarts, and others are gone.
    pub fn replace_stage(&mut self, stage: Arc<Stage>) {
        self.state.forget_level(&stage);
        self.stage = stage;
        self.lands = Arc::new(self.state.lands(&self.stage));
        let mut lost = self.state.away.is_some();
        let State { actors, tuning, .. } = &mut self.state;
        let mut index = 0;
        let mut traces = std::mem::take(&mut self.traces).into_iter();
        actors.retain_mut(|actor| {
            let mut trace = traces.next().unwrap_or_default();
            trace.clear();
            let terrain = self.lands[actor.shape].terrain(&self.stage, tuning);
            let moved = actor.body.moved_to(&terrain, &mut trace);
            let is_hero = index == HERO;
            index += 1;
            // In the new meshes the old body has no place: nobody may ask it for one.
            let nobody = || Body::absent(actor.body.position(), actor.body.time(), &terrain);
            let stays = moved.is_ok() || is_hero;
            lost |= is_hero && moved.is_err();
            let held = actor.body.control();
            actor.body = moved.unwrap_or_else(|_| nobody());
            actor.body.wish(held);
            if stays {
                self.traces.push(trace);
            }
            stays
        });
        self.begin_again(lost);
        self.note_area();
    }

    /// What is left to do for bodies that have been put into another level.
    fn begin_again(&mut self, lost: bool) {
        let bodies = self.state.actors.len();
        (self.done, self.told) = (vec![0; bodies], vec![0; bodies]);
        for body in usize::from(lost)..bodies {
            self.traces[body].events.clear();
            self.begin(body);
        }
        if lost {
            self.restart();
        }
        self.settle();
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
            away: state.away,
            returned: state.returned,
            marked: state.marked,
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
        self.stage.feature(self.state.checkpoint()?)
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
            away: None,
            returned: None,
            marked: false,
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
