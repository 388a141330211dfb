//! What events mean: hazards, crushers and a fall out of the level kill, checkpoints and goals are noted, triggers set movers going.
//!
//! All of it happens at the event's own time. Where an event changes the world for what follows in the same tick, the tick
//! is taken back to its beginning, run up to the event, and goes on from there: bodies are plain values, and where
//! a tick is cut changes no bit.
//!
//! Of what happens at one time the goal comes first, then checkpoints, which keep the world as it was before that time, then
//! what starts, then a death. Once the goal is reached nothing takes that back, and nobody dies any more.

use super::Input;
use super::returns::Visit;
use super::world::{HERO, World};
use crate::anim::Leap;
use crate::level::Kind;
use crate::mesh::FeatureId;
use crate::motion::{Event, EventKind, Grip};

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
        loop {
            let back = self.state.away.and_then(|away| away.until);
            let due = [back, self.due()].into_iter().flatten();
            let until = due.fold(to, f64::min);
            let busy = self.is_busy(until);
            let before = busy.then(|| (self.state.actors.clone(), self.traces.clone()));
            self.advance(until);
            let turn = self.first_turn().filter(|&at| at < until);
            if let Some((actors, traces)) = before
                && let Some(at) = turn
            {
                (self.state.actors, self.traces) = (actors, traces);
                self.advance(at);
            }
            let now = turn.unwrap_or(until);
            self.take_turns(now);
            if self.due().is_some_and(|due| due <= now) {
                self.turn_movers(now);
            }
            if self.is_back_by(now) {
                self.come_back(now);
            }
            if now >= to && self.is_settled() {
                return;
            }
        }
    }

    /// What has happened at this very time, outside of a tick, has its consequences.
    pub(super) fn settle(&mut self) {
        let now = self.time();
        while !self.is_settled() {
            self.take_turns(now);
        }
    }

    /// Whether all events have had their consequences.
    fn is_settled(&self) -> bool {
        let mut all = self.traces.iter().zip(&self.done);
        all.all(|(trace, &done)| trace.events.len() == done)
    }

    /// Whether anything happens to bodies until a time, or has happened that is still to be dealt with.
    fn is_busy(&self, until: f64) -> bool {
        let mut bodies = self.bodies();
        !self.is_settled() || bodies.any(|body| body.next_at().is_some_and(|at| at <= until))
    }

    fn advance(&mut self, to: f64) {
        self.each(|body, terrain, trace| body.advance(to, terrain, trace));
    }

    /// The turns among the events that have not had their consequences, with their times: body by body.
    fn turns(&self) -> impl Iterator<Item = (f64, Turn)> + '_ {
        let traces = self.traces.iter().zip(&self.done).enumerate();
        traces.flat_map(move |(body, (trace, &done))| {
            let turn = move |event: &Event| Some((event.time, self.turn(body, event.kind)?));
            trace.events[done..].iter().filter_map(turn)
        })
    }

    fn turn(&self, body: usize, kind: EventKind) -> Option<Turn> {
        let is_hero = body == HERO && self.state.away.is_none();
        let mortal = is_hero && self.state.won_at.is_none();
        match kind {
            EventKind::Crushed if mortal => Some(Turn::Death),
            EventKind::Entered(id) if mortal && self.stage.kills(id) => Some(Turn::Death),
            EventKind::Entered(id) if (is_hero || body != HERO) && self.waits_for(id) => {
                Some(Turn::Start(id))
            }
            EventKind::Mounted(_) | EventKind::Dismounted(_) => Some(Turn::Ride),
            _ => None,
        }
    }

    fn first_turn(&self) -> Option<f64> {
        self.turns().map(|(at, _)| at).min_by(f64::total_cmp)
    }

    /// All that is due at a time, which is now.
    fn take_turns(&mut self, at: f64) {
        self.note_places();
        let turns: Vec<Turn> = self.turns().map(|(_, turn)| turn).collect();
        for (done, trace) in self.done.iter_mut().zip(&self.traces) {
            *done = trace.events.len();
        }
        if turns.is_empty() {
            return;
        }
        let going = self.state.going.clone();
        for turn in &turns {
            if let Turn::Start(trigger) = turn {
                self.start_movers(*trigger, at);
            }
        }
        self.note_riders(at);
        if self.state.going != going {
            self.look_for_way_back(at);
        }
        if turns.contains(&Turn::Death) {
            self.die(at);
        }
    }

    /// Checkpoints, secrets and goals that the hero has entered.
    fn note_places(&mut self) {
        let events = &self.traces[HERO].events[self.done[HERO]..];
        let entered = events.iter().filter_map(|event| match event.kind {
            EventKind::Entered(id) => Some((event.time, id)),
            _ => None,
        });
        let entered: Vec<(f64, FeatureId)> = entered.collect();
        for (time, id) in entered {
            if self.state.away.is_some() || self.state.won_at.is_some_and(|won| won < time) {
                return;
            }
            match self.stage.feature(id).map(|feature| feature.kind) {
                Some(Kind::Checkpoint) => self.visit(id, time),
                Some(Kind::Secret) if !self.state.secrets.contains(&id) => {
                    self.state.secrets.push(id);
                    self.state.secret_at = Some(time);
                }
                Some(Kind::Goal) if self.state.won_at.is_none() => {
                    self.state.won_at = Some(time);
                }
                _ => {}
            }
        }
    }

    /// The hero comes to a checkpoint. The last one keeps what it knew when he came to it first; who only comes back at an
    /// earlier one has not come to it.
    fn visit(&mut self, checkpoint: FeatureId, time: f64) {
        let state = &mut self.state;
        let is_last = state.checkpoint() == Some(checkpoint);
        let returned = state.returned;
        let comes_back = returned.is_some_and(|r| r.at == time && r.to == Some(checkpoint));
        if is_last || comes_back {
            return;
        }
        state.visited.retain(|visit| visit.checkpoint != checkpoint);
        state.visited.push(Visit {
            checkpoint,
            going: state.going.clone(),
        });
    }

    /// What pictures and sounds need of the tick's events.
    pub(super) fn note_events(&mut self, input: Input) {
        if input.run != 0 {
            self.state.facing = f64::from(input.run.signum());
        }
        let is_over = self.hero().grip() == Grip::Over;
        for index in 0..self.traces[HERO].events.len() {
            let Event { time, kind } = self.traces[HERO].events[index];
            let height = self.hero_at(time).y;
            let state = &mut self.state;
            match kind {
                EventKind::Landed(speed) => (state.landed_at, state.landed_speed) = (time, speed),
                EventKind::Jumped => (state.left_at, state.leap) = (time, Leap::Jumped),
                EventKind::WallJumped => (state.left_at, state.leap) = (time, Leap::OffWall),
                EventKind::Left | EventKind::Dropped => {
                    (state.left_at, state.leap) = (time, Leap::Walked);
                }
                EventKind::Grabbed => state.held_at = time,
                EventKind::Climbed => {
                    state.held_at = time;
                    if is_over {
                        state.ledge_at = height + state.tuning.ledge_hang;
                    }
                }
                _ => {}
            }
        }
    }
}
