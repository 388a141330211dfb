//! Where each mover is on its way: what the state of a game knows of it, and what changes that.
//!
//! A mover waits at its first stop until its cause comes: a trigger, or a rider, any body that comes to stand on it or takes hold of
//! it. It goes its path. One that comes back does so from its last stop, the way that it came: when nobody has ridden it for a
//! while, or when a trigger calls it to its first stop. Whatever is asked of it on its way, it first comes to the end of that;
//! a rider who comes aboard on the way home is one who wants it to set out again. All of it happens at exact times: the
//! event's own, or that at which it is due, in closed form.

use super::paths::{Cause, Route, seconds};
use super::stage::{Land, Stage};
use super::world::World;
use crate::level::End;
use crate::mesh::FeatureId;
use crate::motion::{Mover, Path, Piece};
use glam::DVec2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use xxhash_rust::xxh3::Xxh3;

/// No path is foreseen in more pieces.
const FORESEEN: usize = 100_000;

/// Where a mover is on its way. A plain value: what a checkpoint knows of movers is a copy of these.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct Going {
    /// When it set out on its present way, s; `None`: it waits at its first stop.
    pub start: Option<f64>,
    /// That way leads from its last stop to the first.
    pub home: bool,
    /// It is wanted at the other end from that to which it goes.
    pub called: bool,
    /// Somebody rides it, as far as that matters.
    pub ridden: bool,
    /// Since when that has been so or not, s.
    pub since: f64,
}

impl Going {
    /// All movers of a stage as they are when a level begins at a time.
    pub fn at_first(stage: &Stage, now: f64) -> Vec<Going> {
        let going = stage.routes().iter().map(|route| Going {
            start: (route.cause == Cause::Level).then_some(now),
            ..Going::default()
        });
        going.collect()
    }

    /// The same, where only what was set going waits again.
    pub fn waiting_again(stage: &Stage, going: &[Going]) -> Vec<Going> {
        let both = going.iter().zip(stage.routes());
        both.map(|(now, route)| match route.cause {
            Cause::Level => *now,
            Cause::Trigger(_) | Cause::Rider => Going::default(),
        })
        .collect()
    }

    /// Lets the movers of a shape go as they will from a time on, until another one, if nothing happens to them: with all their
    /// turns as one path. `riders` are the movers that are ridden.
    pub fn foresee(
        going: &[Going],
        stage: &Stage,
        land: &mut Land,
        riders: &[u32],
        (now, until): (f64, f64),
    ) {
        Going::bring(going, stage, land);
        let all = land.movers.iter_mut().zip(going).zip(stage.routes());
        for (i, ((mover, going), route)) in all.enumerate() {
            let mut going = *going;
            if going.ridden && !riders.contains(&(i as u32)) {
                (going.ridden, going.since) = (false, now);
            }
            if going.due(route).is_none_or(|due| due > until) {
                continue;
            }
            let (mut path, mut from) = (Path::default(), now);
            while path.pieces.len() < FORESEEN {
                let due = going.due(route).filter(|&due| due <= until);
                path.pieces.extend(going.pieces(route, from, due));
                let Some(at) = due else {
                    break;
                };
                (going, from) = (going.turned(at), at);
            }
            (mover.path, mover.start) = (path, Some(0.0));
        }
    }

    /// The pieces of its present way in the time of the world, up to the end of that way; who waits stays from a time on.
    fn pieces(&self, route: &Route, from: f64, end: Option<f64>) -> Vec<Piece> {
        let own = &self.path(route).pieces;
        let Some(start) = self.start else {
            let rests = own.first().map(|first| Piece {
                t0: from,
                p0: first.p0,
                ..Piece::default()
            });
            return rests.into_iter().collect();
        };
        let moved = own.iter().map(|piece| Piece {
            t0: start + piece.t0,
            ..*piece
        });
        moved.filter(|p| end.is_none_or(|end| p.t0 < end)).collect()
    }

    /// Lets the movers of a shape be where these say.
    pub fn bring(going: &[Going], stage: &Stage, land: &mut Land) {
        let all = land.movers.iter_mut().zip(going).zip(stage.routes());
        for ((mover, going), route) in all {
            mover.start = going.start;
            let path = going.path(route);
            if mover.path != *path {
                mover.path = path.clone();
            }
        }
    }

    /// The way that it is on.
    fn path<'a>(&self, route: &'a Route) -> &'a Path {
        match self.home {
            true => &route.home,
            false => &route.out,
        }
    }

    /// After somebody has entered a trigger.
    fn heard(self, trigger: FeatureId, route: &Route, at: f64) -> Going {
        let starts = route.cause == Cause::Trigger(trigger);
        let going = if starts { self.wanted_out(at) } else { self };
        let calls = route.calls.iter().filter(|call| call.0 == trigger);
        calls.fold(going, |going, &(_, to)| match to {
            End::Last => going.wanted_out(at),
            End::First => going.wanted_home(),
        })
    }

    /// It is to go to its last stop.
    fn wanted_out(self, at: f64) -> Going {
        match self.start {
            None => Going {
                start: Some(at),
                ..self
            },
            Some(_) => Going {
                called: self.called || self.home,
                ..self
            },
        }
    }

    /// It is to come to its first stop.
    fn wanted_home(self) -> Going {
        let goes_out = self.start.is_some() && !self.home;
        Going {
            called: self.called || goes_out,
            ..self
        }
    }

    /// When it turns round, or comes to its first stop to stay; `None`: not before something happens to it.
    fn due(&self, route: &Route) -> Option<f64> {
        let arrives = self.start? + seconds(self.path(route));
        match (self.home || self.called, route.back) {
            (true, _) => Some(arrives),
            (false, Some(back)) if !self.ridden => Some(arrives.max(self.since) + back),
            _ => None,
        }
    }

    /// What it does when that is due.
    fn turned(self, at: f64) -> Going {
        let sets_out = !self.home || self.called;
        Going {
            start: sets_out.then_some(at),
            home: !self.home,
            called: false,
            ..self
        }
    }

    /// Adds it to a hash.
    pub fn hash_into(&self, hash: &mut Xxh3) {
        let time = |t: f64| (t + 0.0).to_bits().to_le_bytes();
        hash.update(&time(self.start.unwrap_or(-1.0)));
        let flags = [self.home, self.called, self.ridden].map(u8::from);
        if flags != [0; 3] || self.since != 0.0 {
            hash.update(&flags);
            hash.update(&time(self.since));
        }
    }
}

impl World {
    /// Whether a trigger changes what some mover is about to do.
    pub(super) fn waits_for(&self, trigger: FeatureId) -> bool {
        let mut all = self.state.going.iter().zip(self.stage.routes());
        all.any(|(going, route)| going.heard(trigger, route, 0.0) != *going)
    }

    /// Somebody has entered a trigger.
    pub(super) fn start_movers(&mut self, trigger: FeatureId, at: f64) {
        let all = self.state.going.iter().zip(self.stage.routes());
        let heard = all.map(|(going, route)| going.heard(trigger, route, at));
        self.set_going(heard.collect());
    }

    /// When the next mover turns round by itself.
    pub(super) fn due(&self) -> Option<f64> {
        if !self.stage.turns() {
            return None;
        }
        let all = self.state.going.iter().zip(self.stage.routes());
        let due = all.filter_map(|(going, route)| going.due(route));
        due.min_by(f64::total_cmp)
            .map(|due| due.max(self.hero().time()))
    }

    /// Lets movers turn round that are due by a time, which is now. Who rides them is known.
    pub(super) fn turn_movers(&mut self, at: f64) {
        let all = self.state.going.iter().zip(self.stage.routes());
        let turned = all.map(|(going, route)| {
            let due = going.due(route).is_some_and(|due| due <= at);
            if due { going.turned(at) } else { *going }
        });
        self.set_going(turned.collect());
    }

    /// Finds out who rides what, and lets movers begin that are ridden from now on.
    pub(super) fn note_riders(&mut self, at: f64) {
        if !self.stage.minds_riders() {
            return;
        }
        let riders: Vec<u32> = self.bodies().filter_map(|body| body.rides()).collect();
        let all = self.state.going.iter().zip(self.stage.routes());
        let noted = all.enumerate().map(|(i, (going, route))| {
            let ridden = riders.contains(&(i as u32));
            if going.ridden == ridden || !route.minds_riders() {
                return *going;
            }
            let since = at;
            let now = Going {
                ridden,
                since,
                ..*going
            };
            match ridden && route.cause == Cause::Rider {
                true => now.wanted_out(at),
                false => now,
            }
        });
        self.set_going(noted.collect());
    }

    /// Movers are where these say from now on, for all shapes and bodies.
    pub(super) fn set_going(&mut self, going: Vec<Going>) {
        let ways = |all: &[Going]| -> Vec<_> { all.iter().map(|g| (g.start, g.home)).collect() };
        let same = ways(&self.state.going) == ways(&going);
        self.state.going = going;
        if same {
            return;
        }
        for land in Arc::make_mut(&mut self.lands) {
            Going::bring(&self.state.going, &self.stage, land);
        }
        self.each(|body, terrain, trace| body.take_up_paths(terrain, trace));
    }

    /// Where a checkpoint puts the hero's foot at a time, m, and how fast that place moves, m/s, among movers: it rides along.
    /// `None`: the start.
    pub(super) fn place_of_return(
        &self,
        checkpoint: Option<FeatureId>,
        movers: &[Mover],
        at: f64,
    ) -> Option<(DVec2, DVec2)> {
        let Some(checkpoint) = checkpoint else {
            return Some((self.stage.level.start, DVec2::ZERO));
        };
        let place = self.stage.feature(checkpoint)?.respawn?;
        let mover = self.stage.mover_of(checkpoint).and_then(|i| movers.get(i));
        let piece = mover.map(|mover| mover.piece_at(at)).unwrap_or_default();
        Some((place + piece.offset(at), piece.velocity(at)))
    }
}
