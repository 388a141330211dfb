//! The search itself: clones of a world go on at random from wherever one has stood.

use super::way::{Place, Way};
use edgewalker::game::{Input, Stance, View, World};
use edgewalker::motion::Grip;
use edgewalker::tune::Tuning;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Ticks a second of all worlds: as often as somebody decides anew.
pub const RATE: u32 = 30;

/// The longest that a clone goes on from where it began, in ticks.
const LONGEST: u32 = 75;

/// The longest that one thing is held, in ticks.
const HELD: u64 = 12;

/// Speeds along the ground are told apart in steps of this, in m/s.
const PACE: f64 = 4.0;

/// What a skip loses of its length with every second that it takes: who has luck with machines and needs half the time of the
/// recorded run skips nothing.
const FORGIVEN: f64 = 1.0;

/// A world in which the hero stands somewhere, and how it came there.
struct Node {
    world: World,
    place: Place,
    /// The least lead over the recorded run so far, in seconds, and where that was.
    low: f64,
    low_at: Place,
    from: Option<usize>,
    /// How often somebody has gone on from here.
    used: u32,
}

/// A part of the way that is done in less time than the recorded run needs for it.
#[derive(Clone, Debug)]
pub struct Skip {
    pub seconds: f64,
    pub from: Place,
    pub to: Place,
    /// The node that it was found from.
    node: usize,
}

/// What has been found.
pub struct Flood<'a> {
    way: &'a Way,
    nodes: Vec<Node>,
    known: HashMap<(Place, i8), usize>,
    /// From each place that has been stood in, to which one can go.
    pub joins: BTreeMap<Place, BTreeSet<Place>>,
    /// Those in which somebody died where he stood.
    pub deadly: BTreeSet<Place>,
    /// The longest skip that ends in a place.
    pub skips: BTreeMap<Place, Skip>,
    chance: u64,
    /// Ticks done.
    pub ticks: u64,
}

/// Whether the hero stands or climbs; who hangs from a ledge is on the way to somewhere.
pub fn stands(view: &View) -> bool {
    match view.stance {
        Stance::Ground | Stance::Wedge | Stance::Climb => true,
        Stance::Slide => view.grip == Grip::Wall,
        Stance::Air => false,
    }
}

impl<'a> Flood<'a> {
    /// One that begins wherever the recorded run has been.
    pub fn new(way: &'a Way, tuning: &Tuning) -> Flood<'a> {
        let mut flood = Flood {
            way,
            nodes: Vec::new(),
            known: HashMap::new(),
            joins: BTreeMap::new(),
            deadly: BTreeSet::new(),
            skips: BTreeMap::new(),
            chance: 20,
            ticks: 0,
        };
        let mut world = way.begin();
        let mut before = None;
        for input in &way.inputs {
            let view = world.view();
            if view.won_at.is_some() {
                break;
            }
            if stands(&view) {
                let place = way.place(&world);
                flood.join(&mut before, place);
                if !flood.known.contains_key(&(place, pace(&view))) {
                    let node = Node {
                        world: world.clone(),
                        place,
                        low: way.times.get(&place).map_or(0.0, |time| time.1 - view.time),
                        low_at: place,
                        from: None,
                        used: 0,
                    };
                    flood.keep((place, pace(&view)), node);
                }
            }
            world.step(*input, tuning);
        }
        flood
    }

    fn keep(&mut self, key: (Place, i8), node: Node) {
        self.known.insert(key, self.nodes.len());
        self.nodes.push(node);
    }

    fn join(&mut self, before: &mut Option<Place>, place: Place) {
        if *before != Some(place) {
            self.joins.entry(place).or_default();
            if let Some(before) = before.replace(place) {
                self.joins.entry(before).or_default().insert(place);
            }
        }
    }

    /// Whether a place that is not of the way has been stood in with fewer levers pulled: what can be done there is known.
    fn is_old(&self, place: Place) -> bool {
        let is_known = |other: Place| self.joins.contains_key(&other);
        !self.way.times.contains_key(&place) && place.earlier().any(is_known)
    }

    /// The next of a fixed row of numbers (S. Vigna's splitmix64), less than `most`.
    fn chance(&mut self, most: u64) -> u64 {
        self.chance = self.chance.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.chance;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % most
    }

    /// What is held next.
    fn whim(&mut self) -> Input {
        let run = [-127, -127, -127, 0, 0, 60, -60, 127, 127, 127][self.chance(10) as usize];
        let jump = self.chance(2) == 0;
        let more = self.chance(10);
        Input {
            run,
            jump,
            up: more == 0,
            down: more == 1 || more == 2,
            ..Input::default()
        }
    }

    /// Goes on from one node after the other, the less used first, until so many ticks are done.
    pub fn run(&mut self, ticks: u64, tuning: &Tuning) {
        while self.ticks < ticks {
            let tried = [0; 3].map(|_| self.chance(self.nodes.len() as u64) as usize);
            let node = tried.into_iter().min_by_key(|&n| self.nodes[n].used);
            self.go_on(node.unwrap_or(0), tuning);
        }
    }

    /// Goes on from every node of some places, so many times.
    pub fn try_again(&mut self, places: &BTreeSet<Place>, times: u32, tuning: &Tuning) {
        let nodes = 0..self.nodes.len();
        let nodes: Vec<usize> = nodes
            .filter(|&n| places.contains(&self.nodes[n].place))
            .collect();
        for node in nodes.iter().cycle().take(nodes.len() * times as usize) {
            self.go_on(*node, tuning);
        }
    }

    /// Where somebody began who then did a skip, and where he stood between, in order.
    pub fn story(&self, skip: &Skip) -> Vec<(f64, Place)> {
        let mut node = &self.nodes[skip.node];
        let mut story = vec![(node.world.time(), node.place)];
        while let Some(from) = node.from {
            node = &self.nodes[from];
            story.push((node.world.time(), node.place));
        }
        story.reverse();
        story
    }

    fn go_on(&mut self, from: usize, tuning: &Tuning) {
        self.nodes[from].used += 1;
        let Node {
            world,
            place,
            low,
            low_at,
            ..
        } = &self.nodes[from];
        let (mut world, mut before) = (world.clone(), Some(*place));
        let (mut low, mut low_at) = (*low, *low_at);
        let began = world.view();
        let (mut held, mut left) = (Input::default(), 0);
        let mut stood = true;
        for _ in 0..LONGEST {
            if left == 0 {
                (held, left) = (self.whim(), 1 + self.chance(HELD));
            }
            left -= 1;
            world.step(held, tuning);
            self.ticks += 1;
            let view = world.view();
            if view.deaths > began.deaths {
                self.deadly.extend(before.filter(|_| stood));
            }
            if view.deaths > began.deaths || view.won_at.is_some() {
                return;
            }
            stood = stands(&view);
            low += FORGIVEN / f64::from(RATE);
            if !stood {
                continue;
            }
            let place = self.way.place(&world);
            self.join(&mut before, place);
            if let Some((least, most)) = self.way.lead(place, view.time) {
                let seconds = least - low;
                let known = self.skips.get(&place).map_or(1.0, |skip| skip.seconds);
                if seconds > known {
                    let skip = Skip {
                        seconds,
                        from: low_at,
                        to: place,
                        node: from,
                    };
                    self.skips.insert(place, skip);
                }
                if most < low {
                    (low, low_at) = (most, place);
                }
            }
            let key = (place, pace(&view));
            if self.is_old(place) {
                continue;
            }
            if !self.known.contains_key(&key) {
                let world = world.clone();
                let node = Node {
                    world,
                    place,
                    low,
                    low_at,
                    from: Some(from),
                    used: 0,
                };
                self.keep(key, node);
            }
        }
    }
}

/// The step of a speed along the ground.
fn pace(view: &View) -> i8 {
    (view.velocity.x / PACE).round() as i8
}
