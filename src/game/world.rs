//! The world: one hero in one level, tick by tick.

use super::stage::Stage;
use super::{Input, Stance, View};
use crate::mesh::Mesh;
use crate::motion::{Body, Control, Event, EventKind, Mode, Size, Trace};
use crate::tune::{Motion, Tuning};
use glam::DVec2;
use std::sync::Arc;
use xxhash_rust::xxh3::Xxh3;

/// The whole simulation state. Clone it to take a snapshot.
#[derive(Clone, Debug)]
pub struct World {
    stage: Arc<Stage>,
    rate: u32,
    seed: u64,
    tick: u64,
    hero: Body,
    /// The tuning of the tick before: a change is an event.
    tuning: Motion,
    retry: bool,
    facing: f64,
    left_at: f64,
    landed_at: f64,
    landed_speed: f64,
    won_at: Option<f64>,
    deaths: u32,
    trace: Trace,
}

impl World {
    /// A world at tick 0, the hero at the start; `tick_rate` ticks a second, at least one.
    pub fn new(stage: Arc<Stage>, tick_rate: u32, seed: u64) -> World {
        let tuning = Motion::default();
        let hero = at_start(&stage, 0.0, &tuning);
        World {
            stage,
            rate: tick_rate.max(1),
            seed,
            tick: 0,
            hero,
            tuning,
            retry: false,
            facing: 1.0,
            left_at: 0.0,
            landed_at: 0.0,
            landed_speed: 0.0,
            won_at: None,
            deaths: 0,
            trace: Trace::default(),
        }
    }

    /// One tick: takes the input, then moves the hero to the tick's end, event by event; then the rules.
    pub fn step(&mut self, input: Input, tuning: &Tuning) {
        self.trace.clear();
        let stage = Arc::clone(&self.stage);
        if self.tuning != tuning.motion {
            self.tuning = tuning.motion.clone();
            self.hero
                .retune(&stage.terrain(&self.tuning), &mut self.trace);
        }
        if input.retry && !self.retry {
            self.restart();
        }
        self.retry = input.retry;
        let terrain = stage.terrain(&tuning.motion);
        self.hero.apply(input.control(), &terrain, &mut self.trace);
        self.tick += 1;
        self.hero.advance(self.time(), &terrain, &mut self.trace);
        self.note_events(input);
        self.judge();
    }

    /// What pictures and sounds need of the tick's events.
    fn note_events(&mut self, input: Input) {
        if input.run != 0 {
            self.facing = f64::from(input.run.signum());
        }
        for Event { time, kind } in &self.trace.events {
            match *kind {
                EventKind::Landed(speed) => (self.landed_at, self.landed_speed) = (*time, speed),
                EventKind::Jumped | EventKind::Left => self.left_at = *time,
                _ => {}
            }
        }
    }

    /// Falls out of the level, reaches the goal.
    fn judge(&mut self) {
        let p = self.hero.position();
        if p.y < self.stage.level.bottom {
            self.deaths += 1;
            self.restart();
        } else if self.won_at.is_none() && self.stage.level.goal.contains(p) {
            self.won_at = Some(self.time());
        }
    }

    fn restart(&mut self) {
        self.hero = at_start(&self.stage, self.time(), &self.tuning);
        self.won_at = None;
    }

    /// Goes on in another version of the level: the hero stays where he is if that place is free, else he restarts.
    pub fn replace_stage(&mut self, stage: Arc<Stage>) {
        let terrain = stage.terrain(&self.tuning);
        let (p, v) = (self.hero.position(), self.hero.velocity());
        match Body::spawn(p, self.time(), &terrain) {
            Ok(mut hero) => {
                hero.set_velocity(v, &terrain, &mut self.trace);
                self.hero = hero;
                self.stage = stage;
            }
            Err(_) => {
                self.stage = stage;
                self.restart();
            }
        }
    }

    /// What to draw.
    pub fn view(&self) -> View {
        View {
            time: self.time(),
            position: self.hero.position(),
            velocity: self.hero.velocity(),
            normal: self.hero.normal(),
            stance: match self.hero.mode() {
                Mode::Air(_) => Stance::Air,
                Mode::Surface(_) if self.hero.supported() => Stance::Ground,
                Mode::Surface(_) => Stance::Slide,
                Mode::Wedge(_) | Mode::Crushed(_) => Stance::Wedge,
            },
            crouched: self.hero.size() == Size::Crouch,
            facing: self.facing,
            left_at: self.left_at,
            landed_at: self.landed_at,
            landed_speed: self.landed_speed,
            won_at: self.won_at,
            deaths: self.deaths,
        }
    }

    /// Hash of the state, equal on every machine and in every build.
    pub fn hash(&self) -> u64 {
        let mut hash = Xxh3::new();
        self.hero.hash_into(&mut hash);
        let won = self.won_at.unwrap_or(-1.0);
        for word in [
            self.tick,
            self.seed,
            u64::from(self.deaths),
            u64::from(self.retry),
            self.facing.to_bits(),
            won.to_bits(),
        ] {
            hash.update(&word.to_le_bytes());
        }
        hash.digest()
    }

    /// Ticks done.
    pub fn tick(&self) -> u64 {
        self.tick
    }

    /// Ticks a second.
    pub fn tick_rate(&self) -> u32 {
        self.rate
    }

    /// Simulated seconds: the tick's number over the rate, rounded once.
    pub fn time(&self) -> f64 {
        self.tick as f64 / f64::from(self.rate)
    }

    /// The level with its meshes.
    pub fn stage(&self) -> &Arc<Stage> {
        &self.stage
    }

    /// The hero's body.
    pub fn hero(&self) -> &Body {
        &self.hero
    }

    /// The mesh that the hero moves in now.
    pub fn mesh(&self) -> &Mesh {
        self.stage.terrain(&self.tuning).mesh(self.hero.size())
    }

    /// What happened in the last tick.
    pub fn trace(&self) -> &Trace {
        &self.trace
    }
}

fn at_start(stage: &Stage, time: f64, tuning: &Motion) -> Body {
    Body::spawn(stage.level.start, time, &stage.terrain(tuning))
        .expect("the stage was built with a free start")
}

impl Input {
    /// As the hero's body takes it.
    pub fn control(self) -> Control {
        Control {
            run: f64::from(self.run.max(-127)) / 127.0,
            jump: self.jump,
            down: self.down,
            up: false,
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
            left_at: 0.0,
            landed_at: 0.0,
            landed_speed: 0.0,
            won_at: None,
            deaths: 0,
        }
    }
}
