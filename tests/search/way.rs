//! The recorded way as the search sees it: which places it stands in, and when.

use super::flood::{RATE, stands};
use super::player::{Player, way};
use edgewalker::game::{Input, Stage, World};
use edgewalker::level::Starts;
use edgewalker::tune::Tuning;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The whole metres of a place to the right and up.
pub type Cell = (i32, i32);

/// A square metre, and which levers have been pulled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    pub cell: Cell,
    pub levers: u8,
}

impl Place {
    /// The same cell with all that can have been pulled before, fewest first. What can be done there then can still be done:
    /// levers open, and close nothing.
    pub fn earlier(self) -> impl Iterator<Item = Place> {
        let fewer = (0..self.levers).filter(move |levers| levers & !self.levers == 0);
        fewer.map(move |levers| Place { levers, ..self })
    }
}

/// The recorded way.
pub struct Way {
    stage: Arc<Stage>,
    /// What is held, tick by tick.
    pub inputs: Vec<Input>,
    /// When each place is first and last stood in, in seconds.
    pub times: BTreeMap<Place, (f64, f64)>,
    /// The movers that wait for levers.
    levers: Vec<usize>,
    /// Of each of them: the cells that the way first stands in when it has pulled that lever and passed that mover.
    pub behind: Vec<(String, BTreeSet<Cell>)>,
}

/// Half the room about a mover, where it was drawn, that counts as being at it, in metres.
const AT: f64 = 1.0;

impl Way {
    pub fn new(stage: Arc<Stage>, tuning: &Tuning) -> Way {
        let mut player = Player::new(Arc::clone(&stage), tuning.clone(), RATE);
        for act in way() {
            player.act(&act).unwrap();
        }
        let movers = &stage.level.movers;
        let waits = |i: &usize| movers[*i].starts != Starts::AtOnce;
        let levers: Vec<usize> = (0..movers.len()).filter(waits).collect();
        let mut way = Way {
            inputs: player.inputs,
            times: BTreeMap::new(),
            behind: levers
                .iter()
                .map(|&i| (movers[i].id.clone(), BTreeSet::new()))
                .collect(),
            levers,
            stage,
        };
        way.follow(tuning);
        way
    }

    /// A world at the beginning of the way.
    pub fn begin(&self) -> World {
        World::new(Arc::clone(&self.stage), RATE, 0)
    }

    /// Where the hero is.
    pub fn place(&self, world: &World) -> Place {
        let at = world.hero().position();
        let movers = &world.land(0).movers;
        let pulled =
            |(bit, &mover): (usize, &usize)| u8::from(movers[mover].start.is_some()) << bit;
        Place {
            cell: (at.x.floor() as i32, at.y.floor() as i32),
            levers: self.levers.iter().enumerate().map(pulled).sum(),
        }
    }

    /// How far ahead of the recorded run a hero is who stands in a place of it at a time, in seconds: at least, and at most.
    pub fn lead(&self, place: Place, time: f64) -> Option<(f64, f64)> {
        let (first, last) = self.times.get(&place)?;
        Some((first - time, last - time))
    }

    fn follow(&mut self, tuning: &Tuning) {
        let mut world = self.begin();
        let boxes: Vec<_> = self.levers.iter().map(|&i| self.room(i)).collect();
        // Of each lever: whether its mover has been come to, and been left again.
        let mut state = vec![(false, false); self.levers.len()];
        let mut stood = BTreeSet::new();
        for input in self.inputs.clone() {
            world.step(input, tuning);
            let view = world.view();
            let place = self.place(&world);
            for (lever, (come, left)) in state.iter_mut().enumerate() {
                let (min, max) = boxes[lever];
                let is_at = view.position.cmpge(min).all() && view.position.cmple(max).all();
                *come |= is_at && place.levers & (1 << lever) != 0;
                *left |= *come && !is_at;
            }
            if !stands(&view) {
                continue;
            }
            let time = self.times.entry(place).or_insert((view.time, view.time));
            time.1 = view.time;
            if stood.insert(place.cell) {
                let left = state.iter().enumerate().filter(|(_, (_, left))| *left);
                for (lever, _) in left {
                    self.behind[lever].1.insert(place.cell);
                }
            }
        }
    }

    /// The room about a mover where it was drawn.
    fn room(&self, mover: usize) -> (glam::DVec2, glam::DVec2) {
        let features = &self.stage.level.movers[mover].features;
        let corners = || features.iter().flat_map(|f| f.outline.iter().copied());
        let min = corners().reduce(glam::DVec2::min).unwrap() - AT;
        (min, corners().reduce(glam::DVec2::max).unwrap() + AT)
    }
}
