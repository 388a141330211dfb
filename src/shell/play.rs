//! A world being played: where its inputs come from, and what is remembered for the picture between two ticks.

use super::fall::Fall;
use super::puppet::Puppet;
use crate::anim::{Rig, Shown};
use crate::cli::summary::Summary;
use crate::game::camera::{CameraState, Pose};
use crate::game::framing::Framing;
use crate::game::{Input, Stage, View, World};
use crate::motion::Event;
use crate::tune::Tuning;
use glam::DVec2;
use std::collections::VecDeque;
use std::sync::Arc;

/// Seconds of the hero's path that are kept to be drawn.
const TRAIL: u32 = 1;

/// Ticks with events whose events are kept to be listed.
const TICKS: usize = 3;

/// A world, the moment before it, and the camera's.
pub struct Play {
    /// The simulation.
    pub world: World,
    /// What the run has come to.
    pub summary: Summary,
    /// Motion events of the run so far.
    pub events: u64,
    before: View,
    now: View,
    framing: Framing,
    puppet: Option<Puppet>,
    /// The death that is being shown.
    fall: Option<Fall>,
    camera: CameraState,
    pose_before: Pose,
    pose: Pose,
    trail: VecDeque<DVec2>,
    happened: VecDeque<(u64, Vec<Event>)>,
}

impl Play {
    /// A world at its present tick.
    pub fn new(world: World, tuning: &Tuning) -> Play {
        let now = world.view();
        let framing = Framing::new(&world.stage().level);
        let camera = CameraState::new(&now, &framing);
        let pose = camera.pose(&framing, &tuning.camera);
        let summary = Summary::new(&world);
        let trail = VecDeque::from([now.position]);
        let events = 0;
        Play {
            world,
            summary,
            events,
            before: now,
            now,
            framing,
            puppet: None,
            fall: None,
            camera,
            pose_before: pose,
            pose,
            trail,
            happened: VecDeque::new(),
        }
    }

    /// One tick; `look` is where the player asks to look, from -1 (down) to 1 (up).
    pub fn tick(&mut self, input: Input, look: f64, tuning: &Tuning) {
        self.world.step(input, tuning);
        self.summary.watch(&self.world);
        let events = &self.world.trace().events;
        self.events += events.len() as u64;
        if !events.is_empty() {
            // The room of what is forgotten is used again.
            let is_full = self.happened.len() == TICKS;
            let oldest = if is_full {
                self.happened.pop_back()
            } else {
                None
            };
            let (_, mut kept) = oldest.unwrap_or_default();
            kept.clone_from(events);
            self.happened.push_front((self.world.tick(), kept));
        }
        self.before = std::mem::replace(&mut self.now, self.world.view());
        if let Some(puppet) = &mut self.puppet {
            puppet.tick(&self.world, &self.now, look);
        }
        self.camera.step(
            &self.now,
            look,
            &self.framing,
            &tuning.camera,
            1.0 / f64::from(self.world.tick_rate()),
        );
        self.pose_before = std::mem::replace(
            &mut self.pose,
            self.camera.pose(&self.framing, &tuning.camera),
        );
        let bottom = self.world.stage().level.bottom;
        self.fall = Fall::seen(&self.before, &self.now, self.pose_before, input, bottom);
        if self.now.is_cut_from(&self.before) {
            self.pose_before = self.pose;
            self.trail.clear();
        }
        self.trail.push_back(self.now.position);
        let surplus = self
            .trail
            .len()
            .saturating_sub((TRAIL * self.world.tick_rate()) as usize);
        self.trail.drain(..surplus);
    }

    /// Whether a death is being shown, for which the world waits.
    pub fn is_falling(&self) -> bool {
        self.fall.is_some()
    }

    /// Shows a death for some seconds more, if there is one.
    pub fn fall(&mut self, seconds: f64) {
        if let Some(fall) = &mut self.fall {
            self.puppet.iter_mut().for_each(|p| p.fall(seconds));
            if !fall.goes_on(seconds) {
                self.fall = None;
            }
        }
    }

    /// Shows no more of a death.
    pub fn skip_fall(&mut self) {
        self.fall = None;
    }

    /// Goes on in a changed level.
    pub fn replace_stage(&mut self, stage: Arc<Stage>) {
        self.fall = None;
        self.world.replace_stage(stage);
        self.before = self.world.view();
        self.now = self.before;
        self.framing = Framing::new(&self.world.stage().level);
        self.camera = CameraState::new(&self.now, &self.framing);
    }

    /// Lets a figure act the hero from now on.
    pub fn show_hero(&mut self, rig: &Arc<Rig>) {
        self.puppet = Some(Puppet::new(rig, &self.world));
    }

    /// The hero's figure at a share (0 to 1) of the way from the last tick but one to the last.
    pub fn shown(&self, share: f64) -> Option<Shown> {
        let puppet = self.puppet.as_ref()?;
        match self.fall {
            Some(_) => puppet.struck(),
            None if self.now.away.is_some() => None,
            None => Some(puppet.shown(share)),
        }
    }

    /// The views before and after the last tick.
    pub fn moments(&self) -> (&View, &View) {
        (&self.before, &self.now)
    }

    /// The view at a share (0 to 1) of the way from the last tick but one to the last.
    pub fn view(&self, share: f64) -> View {
        match &self.fall {
            Some(fall) => fall.view,
            None => self.now.since(&self.before, share),
        }
    }

    /// Where the picture is taken from, at such a share; the tunables of the pose act at once, paused or not.
    pub fn pose(&self, share: f64, tuning: &Tuning) -> Pose {
        if let Some(fall) = &self.fall {
            return fall.pose;
        }
        let settled = self.camera.pose(&self.framing, &tuning.camera);
        if settled == self.pose {
            self.pose.since(&self.pose_before, share)
        } else {
            settled
        }
    }

    /// The last ticks in which something happened to the hero, and what: the latest first.
    pub fn happened(&self) -> &VecDeque<(u64, Vec<Event>)> {
        &self.happened
    }

    /// Where the hero was at the ticks of the last second, the oldest first.
    pub fn trail(&self) -> &VecDeque<DVec2> {
        &self.trail
    }
}
