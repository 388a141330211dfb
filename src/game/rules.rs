//! What events mean: hazards, crushers and a fall out of the level kill, checkpoints and goals are noted, triggers set movers going.
//!
//! All of it happens at the event's own time. Where an event changes the world for what follows in the same tick, the tick
//! is taken back to its beginning, run up to the event, and goes on from there: bodies are plain values, and where
//! a tick is cut changes no bit.

use super::Input;
use super::going::Going;
use super::world::{HERO, World};
use crate::anim::Leap;
use crate::level::Kind;
use crate::mesh::FeatureId;
use crate::motion::{Body, Event, EventKind, Grip, Trace};
use glam::DVec2;

/// How often a tick may be cut. Only a hero who dies as soon as he comes back needs more; he dies again in the next.
const CUTS: usize = 16;

/// An event that changes the world for what follows it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Turn {
    /// The hero dies.
    Death,
    /// Somebody has entered a trigger that movers wait for.
    Start(FeatureId),
    /// Somebody rides a mover to which that matters, or does so no longer.
    Ride,
}

impl World {
    /// Moves all bodies to a time, with all that their events entail.
    pub(super) fn run(&mut self, to: f64) {
        for _ in 0..CUTS {
            let (actors, traces) = (self.state.actors.clone(), self.traces.clone());
            let seen: Vec<usize> = traces.iter().map(|trace| trace.events.len()).collect();
            let due = self.due().filter(|&due| due <= to);
            self.advance(due.unwrap_or(to));
            let Some((at, _)) = self.first_turn(&seen) else {
                self.note_places(seen[HERO]);
                match due {
                    Some(at) => self.turn_movers(at),
                    None => return,
                }
                continue;
            };
            (self.state.actors, self.traces) = (actors, traces);
            self.advance(at);
            self.note_places(seen[HERO]);
            self.take_turns(at, &seen);
        }
        let seen: Vec<usize> = self.traces.iter().map(|trace| trace.events.len()).collect();
        self.advance(to);
        self.note_places(seen[HERO]);
        self.state.doomed |= matches!(self.first_turn(&seen), Some((_, Turn::Death)));
    }

    fn advance(&mut self, to: f64) {
        self.each(|body, terrain, trace| body.advance(to, terrain, trace));
    }

    /// The turns among the events after those that were seen, with their times: body by body.
    fn turns(&self, seen: &[usize]) -> Vec<(f64, Turn)> {
        let mut found = Vec::new();
        for (body, (trace, &seen)) in self.traces.iter().zip(seen).enumerate() {
            let turn = |event: &Event| Some((event.time, self.turn(body, event.kind)?));
            found.extend(trace.events[seen..].iter().filter_map(turn));
        }
        found
    }

    fn turn(&self, body: usize, kind: EventKind) -> Option<Turn> {
        match kind {
            EventKind::Crushed if body == HERO => Some(Turn::Death),
            EventKind::Entered(id) if body == HERO && self.stage.kills(id) => Some(Turn::Death),
            EventKind::Entered(id) if self.waits_for(id) => Some(Turn::Start(id)),
            EventKind::Mounted(_) | EventKind::Dismounted(_) => Some(Turn::Ride),
            _ => None,
        }
    }

    /// Whether the hero is where it kills to be without having come there: an edit has put it over him, or somebody him into it.
    pub(super) fn is_doomed(&self) -> bool {
        let regions = self.hero().regions();
        self.state.doomed || regions.iter().any(|&id| self.stage.kills(id))
    }

    fn first_turn(&self, seen: &[usize]) -> Option<(f64, Turn)> {
        let turns = self.turns(seen);
        turns.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// All that is due at a time, which is now.
    fn take_turns(&mut self, at: f64, seen: &[usize]) {
        let turns = self.turns(seen);
        for (_, turn) in &turns {
            if let Turn::Start(trigger) = turn {
                self.start_movers(*trigger, at);
            }
        }
        if turns.iter().any(|(_, turn)| *turn == Turn::Death) {
            self.die(at);
        }
        self.note_riders(at);
    }

    /// Checkpoints, secrets and goals that the hero has entered, in the events after those that were seen.
    fn note_places(&mut self, seen: usize) {
        for event in &self.traces[HERO].events[seen..] {
            let EventKind::Entered(id) = event.kind else {
                continue;
            };
            match self.stage.feature(id).map(|feature| feature.kind) {
                Some(Kind::Checkpoint) => self.state.checkpoint = Some(id),
                Some(Kind::Secret) if !self.state.secrets.contains(&id) => {
                    self.state.secrets.push(id);
                    self.state.secret_at = Some(event.time);
                }
                Some(Kind::Goal) if self.state.won_at.is_none() => {
                    self.state.won_at = Some(event.time);
                }
                _ => {}
            }
        }
    }

    /// In which area the hero's foot is; between areas, the last one counts.
    pub(super) fn note_area(&mut self) {
        let foot = self.hero().position();
        let mut areas = self.stage.level.areas.iter();
        if let Some(area) = areas.position(|area| area.room.contains(foot)) {
            self.state.area = area;
        }
    }

    /// The hero dies, and comes back at the last checkpoint.
    pub(super) fn die(&mut self, at: f64) {
        self.state.deaths += 1;
        self.come_back(at);
    }

    /// Back to the start of the level, for a new run: checkpoints, secrets and deaths are forgotten, and what waited for a
    /// trigger waits again.
    pub(super) fn restart(&mut self) {
        self.state.forget_run(self.time());
        let first = Going::at_first(&self.stage);
        self.set_going(first);
        self.come_back(self.time());
    }

    /// Puts the hero at the last checkpoint, or if that is not free at the start. If an edit has closed that too, he stays.
    /// What is held goes on to count, from this very time.
    pub(super) fn come_back(&mut self, at: f64) {
        let checkpoint = self.state.checkpoint;
        let places = [
            checkpoint.and_then(|id| self.place_of_return(id, at)),
            Some((self.stage.level.start, DVec2::ZERO)),
        ];
        let terrain = self.lands[HERO].terrain(&self.stage, &self.state.tuning);
        let spawn = |(place, velocity)| {
            let body = Body::spawn(place, at, &terrain).ok()?;
            Some((body, velocity))
        };
        let held = self.state.actors[HERO].body.control();
        if let Some((mut body, velocity)) = places.into_iter().flatten().find_map(spawn) {
            if velocity != DVec2::ZERO {
                body.set_velocity(velocity, &terrain, &mut self.traces[HERO]);
            }
            body.keep_control(held, &terrain, &mut self.traces[HERO]);
            self.state.actors[HERO].body = body;
        }
        self.state.doomed = false;
        self.state.won_at = None;
    }

    /// What pictures and sounds need of the tick's events.
    pub(super) fn note_events(&mut self, input: Input) {
        let state = &mut self.state;
        if input.run != 0 {
            state.facing = f64::from(input.run.signum());
        }
        let Trace { events, .. } = &self.traces[HERO];
        for Event { time, kind } in events {
            match *kind {
                EventKind::Landed(speed) => (state.landed_at, state.landed_speed) = (*time, speed),
                EventKind::Jumped => (state.left_at, state.leap) = (*time, Leap::Jumped),
                EventKind::WallJumped => (state.left_at, state.leap) = (*time, Leap::OffWall),
                EventKind::Left | EventKind::Dropped => {
                    (state.left_at, state.leap) = (*time, Leap::Walked);
                }
                EventKind::Grabbed => state.held_at = *time,
                EventKind::Climbed => {
                    let body = &state.actors[HERO].body;
                    state.held_at = *time;
                    if body.grip() == Grip::Over {
                        state.ledge_at = body.position().y + state.tuning.ledge_hang;
                    }
                }
                _ => {}
            }
        }
    }
}
