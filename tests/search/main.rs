//! A search over the quarry: what can be reached, whether or not the way leads there. Clones of the world go on from wherever one
//! has stood, at random but always in the same order, so that a run of it says the same every time.
//!
//! A *place* is a square metre with the levers that have been pulled. Two places are joined if somebody went from one to the
//! other without standing anywhere between. How far along the way a place is says the recorded run.

mod flood;
#[path = "../common/player.rs"]
mod player;
mod way;

use edgewalker::game::Stage;
use edgewalker::tune::Tuning;
use flood::Flood;
use glam::DVec2;
use player::{Act, Fall, Jump, Player, Run, quarry};
use std::collections::BTreeSet;
use std::sync::Arc;
use way::{Cell, Place, Way};

/// How many ticks are done: so many that both ways around the levers that there once were are found in a quarter of them.
const TICKS: u64 = 2_000_000;

/// How often more is tried from places that seem to lead nowhere, and from where that leads.
const TRIES: u32 = 40;
const ROUNDS: u32 = 10;

/// The way may be shortened by this much, in seconds: by luck with machines, by better jumps.
const SHORTEST: f64 = 10.0;

/// What lies beside the way, the secrets and pockets of `tests/quarry.rs` among it: its name, and the lowest and the highest
/// cells that it may reach.
const BESIDE: &[(&str, Cell, Cell)] = &[
    ("under the brow", (-14, 7), (-3, 15)),
    ("beside the fallen stones", (26, -5), (43, 2)),
    ("brow of the lip", (57, 13), (64, 17)),
    ("crown of the lip", (64, 22), (75, 29)),
    ("alcove of the well", (107, -10), (113, -7)),
    ("low planks of the well", (110, -14), (116, -11)),
    ("west side of the great lift", (117, -10), (121, 8)),
    ("heart of the press", (125, -10), (135, -7)),
    ("on the heads of the crushers", (149, -17), (162, -11)),
    ("over the ore belt", (150, -8), (161, -2)),
    ("eaves of the boiler house", (157, 5), (166, 10)),
    ("culvert", (158, -22), (168, -18)),
    ("west side of the court lift", (196, -18), (199, -7)),
    ("east side of the court lift", (199, -19), (203, -7)),
    ("on the leaning column", (219, 2), (226, 9)),
    ("beside the bell hoist", (266, 33), (276, 48)),
    ("beams of the belfry", (275, 47), (283, 53)),
    ("on the buttress", (281, 36), (295, 43)),
    ("on the rope bridge", (284, 43), (306, 60)),
    ("beside the spire hoist", (290, 55), (303, 64)),
    ("over the vines", (298, 26), (306, 30)),
    ("on the fallen buttress", (298, 30), (310, 37)),
];

/// Ways to be much faster that are meant to be found: their names, where they begin and where they end at the soonest.
const SHORTCUTS: &[(&str, [Cell; 2], [Cell; 2])] = &[(
    "off the ferry at its fastest onto the scaffold of the court",
    [(149, -20), (176, -12)],
    [(180, -20), (204, -8)],
)];

/// Everything that is asked is asked of one search.
#[test]
#[cfg_attr(debug_assertions, ignore = "takes minutes unless it is optimised")]
fn the_quarry_is_what_its_way_says() {
    let stage = Arc::new(Stage::build(quarry()).unwrap());
    let tuning = Tuning::default();
    let way = Way::new(stage, &tuning);
    let mut flood = Flood::new(&way, &tuning);
    flood.run(TICKS, &tuning);
    let mut faults = early(&way, &flood);
    faults.extend(skips(&flood));
    for _ in 0..ROUNDS {
        flood.try_again(&lost(&way, &flood), TRIES, &tuning);
    }
    let lost = lost(&way, &flood);
    faults.extend(lost.iter().map(|place| format!("{place:?} leads nowhere")));
    faults.extend(unlisted(&way, &flood));
    println!("{} ticks, {} places", flood.ticks, flood.joins.len());
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Places of the way behind a lever where somebody stood who had not pulled it.
fn early(way: &Way, flood: &Flood) -> Vec<String> {
    let behind = way.behind.iter().enumerate();
    let faults = behind.filter_map(|(lever, (mover, cells))| {
        let is_early = |p: &&Place| cells.contains(&p.cell) && p.levers & (1 << lever) == 0;
        let early: BTreeSet<Cell> = flood
            .joins
            .keys()
            .filter(is_early)
            .map(|p| p.cell)
            .collect();
        (!early.is_empty()).then(|| format!("before {mover} has started: {early:?}"))
    });
    faults.collect()
}

/// Parts of the way that somebody has done too fast.
fn skips(flood: &Flood) -> Vec<String> {
    let mut skips: Vec<_> = flood.skips.values().collect();
    skips.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
    let fault = |skip: &&flood::Skip| {
        let (story, from, to) = (flood.story(skip), skip.from, skip.to);
        format!(
            "{:.1} s saved from {from:?} to {to:?}: {story:?}",
            skip.seconds
        )
    };
    let is_within = |[low, high]: &[Cell; 2], (x, y): Cell| {
        (low.0..=high.0).contains(&x) && (low.1..=high.1).contains(&y)
    };
    let is_meant = |skip: &flood::Skip| {
        let mut meant = SHORTCUTS.iter();
        meant.any(|(_, from, to)| is_within(from, skip.from.cell) && is_within(to, skip.to.cell))
    };
    let long = skips
        .iter()
        .filter(|skip| skip.seconds > SHORTEST && !is_meant(skip));
    long.map(fault).collect()
}

/// Places that have been stood in, which do not kill, and from which nobody has come back to the way.
fn lost(way: &Way, flood: &Flood) -> BTreeSet<Place> {
    let on = way.times.keys().chain(&flood.deadly);
    let mut back: BTreeSet<Place> = on.copied().collect();
    let leads = |back: &BTreeSet<Place>, (place, to): (&Place, &BTreeSet<Place>)| {
        to.iter().any(|to| back.contains(to)) || place.earlier().any(|place| back.contains(&place))
    };
    loop {
        let ways = flood.joins.iter();
        let more = ways.filter(|(place, to)| !back.contains(*place) && leads(&back, (*place, *to)));
        let more: Vec<Place> = more.map(|(place, _)| *place).collect();
        if more.is_empty() {
            let lost = flood.joins.keys().filter(|place| !back.contains(place));
            return lost.copied().collect();
        }
        back.extend(more);
    }
}

/// How far apart cells of one group are at most, and how far from the way what is beside it.
const NEAR: i32 = 2;

/// Fewer cells are no place of their own: the edge of a slab, the head of a wall.
const LEAST: usize = 4;

/// The cells within so many of one.
fn around((x, y): Cell, most: i32) -> impl Iterator<Item = Cell> {
    (x - most..=x + most).flat_map(move |x| (y - most..=y + most).map(move |y| (x, y)))
}

/// Groups of cells beside the way that are on no list, and what is on the list and was not found.
fn unlisted(way: &Way, flood: &Flood) -> Vec<String> {
    let on: BTreeSet<Cell> = way.times.keys().map(|place| place.cell).collect();
    let is_beside = |cell: &Cell| !around(*cell, NEAR - 1).any(|near| on.contains(&near));
    let mut beside: BTreeSet<Cell> = flood.joins.keys().map(|place| place.cell).collect();
    beside.retain(is_beside);
    let (mut faults, mut found) = (Vec::new(), BTreeSet::new());
    while let Some(first) = beside.pop_first() {
        let (mut group, mut next) = (vec![first], 0);
        while let Some(&cell) = group.get(next) {
            group.extend(around(cell, NEAR).filter(|near| beside.remove(near)));
            next += 1;
        }
        let holds = |(_, (left, low), (right, high)): &&(&str, Cell, Cell)| {
            let mut cells = group.iter();
            cells.all(|(x, y)| (*left..=*right).contains(x) && (*low..=*high).contains(y))
        };
        match BESIDE.iter().find(holds) {
            None if group.len() < LEAST => {}
            Some((name, ..)) => drop(found.insert(*name)),
            None => {
                let ends = |key: fn(&Cell) -> i32| {
                    let (least, most) = (group.iter().map(key).min(), group.iter().map(key).max());
                    (least.unwrap_or(0), most.unwrap_or(0))
                };
                let ((left, right), (low, high)) = (ends(|c| c.0), ends(|c| c.1));
                let count = group.len();
                faults.push(format!(
                    "(\"\", ({left}, {low}), ({right}, {high})), // {count} cells"
                ));
            }
        }
    }
    let missing = BESIDE.iter().filter(|(name, ..)| !found.contains(name));
    faults.extend(missing.map(|(name, ..)| format!("{name} was not found")));
    faults
}

/// A way around what one should do: its name, where it begins, what is tried, and the lowest and the highest corner of where it
/// must not lead.
type Wrong = (&'static str, (f64, f64), &'static [Act], [(f64, f64); 2]);

const WRONG_WAYS: &[Wrong] = &[
    (
        "over the roof of the gatehouse",
        (97.0, 18.5),
        &[Run(98.4), Jump(103.4), Jump(105.6), Run(108.8), Fall(113.4)],
        [(106.2, 4.0), (119.0, 40.0)],
    ),
    (
        "from the lone arch onto the roof of the gatehouse",
        (97.0, 18.5),
        &[Run(98.4), Jump(103.4)],
        [(103.6, 17.0), (119.0, 40.0)],
    ),
    (
        "over the pier and the shaft of the lift",
        (115.0, 5.6),
        &[Jump(117.0), Jump(119.0), Jump(125.2)],
        [(118.4, 6.0), (140.0, 30.0)],
    ),
    (
        "off the pier onto the deck of the great lift",
        (115.0, 5.6),
        &[Jump(117.0), Jump(119.0), Fall(122.0)],
        [(118.4, -9.0), (140.0, 30.0)],
    ),
    (
        "along the wall of the gatehouse and over it",
        (97.0, 18.5),
        &[Run(98.4), Jump(103.0), Act::Kick(1.0, 28.0)],
        [(103.6, 17.0), (119.0, 40.0)],
    ),
    (
        "up the pier by its wall",
        (115.0, 5.6),
        &[Act::Kick(1.0, 16.5)],
        [(116.0, 9.9), (140.0, 30.0)],
    ),
];

/// Whether a way leads where it must not: somebody who tries it stands there.
fn leads((name, start, acts, [min, max]): &Wrong) -> bool {
    let mut level = quarry();
    level.start = DVec2::from(*start);
    let stage = Stage::build(level).unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut player = Player::new(Arc::new(stage), Tuning::default(), 120);
    let (min, max) = (DVec2::from(*min), DVec2::from(*max));
    acts.iter().any(|act| {
        let ended = player.act(act);
        let view = player.world.view();
        println!("{name}: {} {:?}", view.position, ended);
        let there = view.position.cmpge(min).all() && view.position.cmple(max).all();
        there && flood::stands(&view)
    })
}

#[test]
fn wrong_ways_lead_nowhere() {
    let through: Vec<&str> = WRONG_WAYS
        .iter()
        .filter(|way| leads(way))
        .map(|way| way.0)
        .collect();
    assert!(through.is_empty(), "{through:?}");
}
