//! Deaths, and the ways back from them.
//!
//! A death is one event. The hero comes back at the last checkpoint, at once or as soon as that place is free: the time is
//! known at his death, in closed form out of the paths of what moves. Until then he is nowhere, and cannot die. Where it would
//! take too long, he comes back at an earlier checkpoint, or at the start.
//!
//! What was set going after he came to a checkpoint waits again as it did then, from his death on. Other bodies that it
//! carries go with it; who is in its way is crushed, as by a solid that is put there.

use super::going::Going;
use super::world::{HERO, World};
use crate::mesh::FeatureId;
use crate::motion::{Body, Event, EventKind, Spot};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The longest wait for the last checkpoint, s; if it takes longer, another place is looked for.
pub const PATIENCE: f64 = 10.0;

/// The longest wait for the start, if there is nothing else, s; if it takes longer, everything that moves begins anew.
const LAST_PATIENCE: f64 = 60.0;

/// For how long a place must be free, s. Who came back into less could do nothing before it closes.
pub const ROOM: f64 = 0.05;

/// Which place the hero comes back at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Back {
    /// The last checkpoint, or the start of who has come to none.
    #[default]
    Last,
    /// An earlier checkpoint: those after it are closed for too long.
    Earlier,
    /// The start: all checkpoints are closed for too long.
    Start,
    /// The start, and all that moves begins anew: else that would have been closed too.
    Anew,
}

/// A hero who is nowhere, between a death and his return.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Away {
    /// When he died, s.
    pub since: f64,
    /// When he comes back, s; `None`: not before the level is changed, for an edit has closed the start.
    pub until: Option<f64>,
    /// Where.
    pub back: Back,
    /// The checkpoint; `None`: the start.
    pub(super) to: Option<FeatureId>,
    /// Where that puts his foot, m.
    pub(super) at: DVec2,
}

/// The last time that the hero came back.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Return {
    /// When, s.
    pub at: f64,
    /// Where.
    pub back: Back,
    /// The checkpoint; `None`: the start.
    pub(super) to: Option<FeatureId>,
}

/// A checkpoint that the hero has come to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Visit {
    /// Its number.
    pub checkpoint: FeatureId,
    /// Where each mover was on its way then.
    pub going: Vec<Going>,
}

/// A place to come back at.
struct Place {
    to: Option<FeatureId>,
    going: Vec<Going>,
}

impl World {
    /// The hero dies, and comes back as soon as there is a place for him.
    pub(super) fn die(&mut self, at: f64) {
        self.state.deaths += 1;
        // Who dies as he comes back has not been there: the next place is another one, or later.
        let returned = self.state.returned.is_some_and(|last| last.at == at);
        self.leave(at, if returned { at + ROOM } else { at });
    }

    /// Back to the start of the level, for a new run: checkpoints, secrets and deaths are forgotten, and all that moves begins
    /// anew.
    pub(super) fn restart(&mut self) {
        let now = self.time();
        self.state.forget_run(now);
        let first = Going::at_first(&self.stage, now);
        self.set_going(first);
        self.leave(now, now);
    }

    /// The hero is nowhere from a time on, until he comes back, not before another one.
    pub(super) fn leave(&mut self, at: f64, from: f64) {
        let hero = &self.state.actors[HERO].body;
        hero.leave_way(&mut self.traces[HERO]);
        let here = hero.position();
        self.be_nowhere(here, at);
        self.wait_for_return(Away::for_ever(at, here), (at, from));
        if self.is_back_by(at) {
            self.come_back(at);
        }
    }

    /// Looks anew for a way back, for something has changed that may bar the one that was found.
    pub(super) fn look_for_way_back(&mut self, now: f64) {
        if let Some(old) = self.state.away {
            self.wait_for_return(old, (now, now));
        }
    }

    /// Whether the hero, who is nowhere, is to be back by a time.
    pub(super) fn is_back_by(&self, now: f64) -> bool {
        let until = self.state.away.and_then(|away| away.until);
        until.is_some_and(|until| until <= now)
    }

    /// Waits from a time on for the place of return that is found, not before another one.
    fn wait_for_return(&mut self, old: Away, (now, from): (f64, f64)) {
        let found = self.way_back(old.since, from);
        let (away, going) = match found {
            Some((away, going)) => (away, Some(going)),
            None => (Away::for_ever(old.since, old.at), None),
        };
        self.state.away = Some(away);
        self.be_nowhere(away.at, now);
        if let Some(going) = going {
            self.set_going(going);
        }
        self.note_riders(now);
    }

    /// Nobody is where the hero was: what the picture shows is a place.
    fn be_nowhere(&mut self, place: DVec2, now: f64) {
        let terrain = self.lands[HERO].terrain(&self.stage, &self.state.tuning);
        let held = self.state.actors[HERO].body.control();
        let mut nobody = Body::absent(place, now, &terrain);
        nobody.wish(held);
        self.state.actors[HERO].body = nobody;
    }

    /// Where the hero comes back, and when; and where the movers are on their ways from his death on. In order: the last place if he need not wait
    /// for long, an earlier one that is free, one that will be soon, the start, the start with everything anew.
    fn way_back(&self, since: f64, from: f64) -> Option<(Away, Vec<Going>)> {
        let mut places = self.places();
        let opens = |place: &Place, wait: f64| self.opens(place, (from, from + wait));
        let way = |place: Place, (until, at): (f64, DVec2), back: Back| {
            let Place { to, going } = place;
            let until = Some(until);
            let back = match (back, to) {
                (Back::Earlier, None) => Back::Start,
                _ => back,
            };
            let away = Away {
                since,
                until,
                back,
                to,
                at,
            };
            Some((away, going))
        };
        if let Some(at) = opens(&places[0], PATIENCE) {
            return way(places.swap_remove(0), at, Back::Last);
        }
        for wait in [0.0, PATIENCE] {
            let mut later = places.iter().enumerate().skip(1);
            let found = later.find_map(|(i, place)| Some((i, opens(place, wait)?)));
            if let Some((i, at)) = found {
                return way(places.swap_remove(i), at, Back::Earlier);
            }
        }
        let is_only = places.len() == 1;
        let start = places.pop()?;
        if let Some(at) = opens(&start, LAST_PATIENCE) {
            let back = if is_only { Back::Last } else { Back::Start };
            return way(start, at, back);
        }
        let anew = Place {
            going: Going::at_first(&self.stage, from),
            ..start
        };
        let at = opens(&anew, 0.0)?;
        way(anew, at, Back::Anew)
    }

    /// The places to come back at, the last checkpoint first; after all of them the start.
    fn places(&self) -> Vec<Place> {
        let visit = |visit: &Visit| {
            self.stage.feature(visit.checkpoint)?.respawn?;
            Some(Place {
                to: Some(visit.checkpoint),
                going: visit.going.clone(),
            })
        };
        let visited = self.state.visited.iter().rev().filter_map(visit);
        let start = Place {
            to: None,
            going: Going::waiting_again(&self.stage, &self.state.going),
        };
        visited.chain([start]).collect()
    }

    /// When a place is free first, in a span of time, and where it is then: what it rides on goes as nobody disturbs it.
    fn opens(&self, place: &Place, (from, latest): (f64, f64)) -> Option<(f64, DVec2)> {
        let mut land = self.lands[HERO].clone();
        let others = self.bodies().skip(1);
        let riders: Vec<u32> = others.filter_map(|body| body.rides()).collect();
        let span = (from, latest + ROOM);
        Going::foresee(&place.going, &self.stage, &mut land, &riders, span);
        let terrain = land.terrain(&self.stage, &self.state.tuning);
        let drawn = match place.to {
            Some(checkpoint) => self.stage.feature(checkpoint)?.respawn?,
            None => self.stage.level.start,
        };
        let carrier = place.to.and_then(|id| self.stage.mover_of(id));
        let spot = Spot {
            drawn,
            carrier: carrier.and_then(|i| land.movers.get(i)),
        };
        let kills = |id| self.stage.kills(id);
        let at = terrain.opens(spot, (from, latest), ROOM, kills)?;
        let (there, _) = self.place_of_return(place.to, &land.movers, at)?;
        Some((at, there))
    }

    /// The hero, who was nowhere, is there again. What is held goes on to count, from this very time.
    pub(super) fn come_back(&mut self, at: f64) {
        let Some(away) = self.state.away.take() else {
            return;
        };
        let land = &self.lands[HERO];
        let terrain = land.terrain(&self.stage, &self.state.tuning);
        let place = self.place_of_return(away.to, &land.movers, at);
        let spawned = place.and_then(|(place, velocity)| {
            let body = Body::spawn(place, at, &terrain).ok()?;
            Some((body, velocity))
        });
        let Some((mut body, velocity)) = spawned else {
            // Rounding has put the time before the one at which there is room.
            return self.wait_for_return(away, (at, at + ROOM));
        };
        let trace = &mut self.traces[HERO];
        let nobody = &self.state.actors[HERO].body;
        nobody.leave_way(trace);
        enter(&body, &mut trace.events);
        if velocity != DVec2::ZERO {
            body.set_velocity(velocity, &terrain, trace);
        }
        body.keep_control(nobody.control(), &terrain, trace);
        self.state.actors[HERO].body = body;
        let Away { back, to, .. } = away;
        self.state.returned = Some(Return { at, back, to });
    }

    /// A body begins where it is: it comes into all regions there.
    pub(super) fn begin(&mut self, body: usize) {
        enter(&self.state.actors[body].body, &mut self.traces[body].events);
    }
}

impl Away {
    /// Out of what is told of it.
    pub fn new(since: f64, until: Option<f64>, back: Back) -> Away {
        Away {
            until,
            back,
            ..Away::for_ever(since, DVec2::ZERO)
        }
    }

    /// Nobody knows for how long.
    fn for_ever(since: f64, at: DVec2) -> Away {
        Away {
            since,
            until: None,
            back: Back::Last,
            to: None,
            at,
        }
    }
}

/// A body that has just been put somewhere comes into the regions there.
fn enter(body: &Body, events: &mut Vec<Event>) {
    let time = body.time();
    let entered = |&id| Event {
        time,
        kind: EventKind::Entered(id),
    };
    events.extend(body.regions().iter().map(entered));
}
