//! The quarry is made by hand: no two stretches of it, 20 m long, are alike, not even mirrored.
//!
//! A stretch is what can be seen around a corner of the terrain: where ground meets air, on a coarse grid about it, and what
//! stands there. Two are compared by both: each cell of surface, and each thing, must find its like in the other one nearby.

use edgewalker::level::{self, Feature, Kind, Level, Rect, Scenery};
use glam::DVec2;
use std::path::Path;

/// Half of a stretch's length and height, m.
const HALF: DVec2 = DVec2::new(10.0, 6.0);

/// Size of a cell of the grid, m.
const CELL: f64 = 0.5;

/// Cells of a stretch, along and up.
const COLUMNS: usize = (2.0 * HALF.x / CELL) as usize;
const ROWS: usize = (2.0 * HALF.y / CELL) as usize;

/// One bit for each cell of a row.
const ALL: u64 = (1 << COLUMNS) - 1;

/// Fewer cells of surface than this say nothing: a bare slope has 40.
const LEAST_SURFACE: u32 = 50;

/// Things match when they are as near as this, m.
const NEAR: f64 = 1.0;

/// Stretches with this share of their surfaces in common are of one kind: of such no two may be dressed alike.
const SAME_KIND: f64 = 0.75;

/// The share of things in common from which on two are dressed alike.
const SAME_THINGS: f64 = 0.5;

/// Stretches with this share of their surfaces in common are the same place twice, however they are dressed.
const SAME_PLACE: f64 = 0.9;

/// Where copies are put, and how far off somebody who copies by hand is, m.
const FAR: DVec2 = DVec2::new(1000.0, 0.0);
const CLUMSY: f64 = 0.15;

/// Rows of cells from below; in each, the lowest bit is the cell furthest to the left.
type Cells = [u64; ROWS];

/// What stands somewhere: a name of its kind, and where it is, m.
type Thing = (String, DVec2);

/// What can be seen around a corner.
struct Stretch {
    /// The corner, m.
    at: DVec2,
    /// Cells where ground meets air.
    surface: Cells,
    /// The same and those beside them.
    around: Cells,
    /// What stands there, seen from the corner.
    things: Vec<Thing>,
}

/// What stands in a level apart from its terrain, and where.
fn things(level: &Level) -> Vec<Thing> {
    let middle = |outline: &[DVec2]| outline.iter().sum::<DVec2>() / outline.len() as f64;
    let regions = level.features.iter().filter(|f| !f.kind.is_terrain());
    let regions = regions.map(|f| (format!("{:?}", f.kind), middle(&f.outline)));
    let movers = level.movers.iter().flat_map(|mover| {
        let decks = mover.features.iter();
        decks.map(|deck| {
            (
                format!("a mover of {:?}", deck.material),
                middle(&deck.outline),
            )
        })
    });
    let near = level.scenery.iter().filter(|piece| piece.depth > -8.0);
    let near = near.map(|piece| (format!("{:?}", piece.kind), piece.at));
    regions.chain(movers).chain(near).collect()
}

/// The bits of a row whose middles are within `from..to`, m from its left end.
fn run(from: f64, to: f64) -> u64 {
    let bit = |x: f64| (x / CELL - 0.5).ceil().clamp(0.0, COLUMNS as f64) as u32;
    let below = |bit: u32| (1_u64 << bit) - 1;
    below(bit(to)) & !below(bit(from))
}

/// Adds the inside of a closed outline.
fn fill(cells: &mut Cells, outline: &[DVec2], origin: DVec2) {
    for (row, cells) in cells.iter_mut().enumerate() {
        let y = origin.y + (row as f64 + 0.5) * CELL;
        let ends = outline.iter().zip(outline.iter().cycle().skip(1));
        let crossed = ends.filter(|(a, b)| (a.y > y) != (b.y > y));
        let mut at: Vec<f64> = crossed
            .map(|(a, b)| a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x) - origin.x)
            .collect();
        at.sort_by(f64::total_cmp);
        for inside in at.chunks_exact(2) {
            *cells |= run(inside[0], inside[1]);
        }
    }
}

/// Adds the cells along an open line that goes to the right.
fn trace(cells: &mut Cells, line: &[DVec2], origin: DVec2) {
    for ends in line.windows(2) {
        let (a, b) = (ends[0] - origin, ends[1] - origin);
        for column in 0..COLUMNS {
            let x = (column as f64 + 0.5) * CELL;
            let row = ((a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y)) / CELL).floor();
            if (a.x..b.x).contains(&x) && (0.0..ROWS as f64).contains(&row) {
                cells[row as usize] |= 1 << column;
            }
        }
    }
}

/// Cells of ground with air beside them.
fn skin(ground: &Cells) -> Cells {
    std::array::from_fn(|row| {
        let cells = ground[row];
        let below = row.checked_sub(1).map_or(ALL, |row| ground[row]);
        let above = ground.get(row + 1).copied().unwrap_or(ALL);
        let left = cells << 1 | 1;
        let right = cells >> 1 | 1 << (COLUMNS - 1);
        cells & !(below & above & left & right)
    })
}

/// Cells and those beside them.
fn widen(cells: &Cells) -> Cells {
    let wide = cells.map(|row| (row | row << 1 | row >> 1) & ALL);
    std::array::from_fn(|row| {
        let below = row.checked_sub(1).map_or(0, |row| wide[row]);
        wide[row] | below | wide.get(row + 1).copied().unwrap_or(0)
    })
}

fn count(cells: &Cells) -> u32 {
    cells.iter().map(|row| row.count_ones()).sum()
}

/// The share of the first cells that the others have too.
fn shared(cells: &Cells, others: &Cells) -> f64 {
    let both = std::array::from_fn(|row| cells[row] & others[row]);
    f64::from(count(&both)) / f64::from(count(cells))
}

/// Left and right exchanged.
fn turned(cells: &Cells) -> Cells {
    cells.map(|row| row.reverse_bits() >> (64 - COLUMNS))
}

/// All stretches of a level, one around each corner of its terrain and of what moves in it.
fn stretches(level: &Level) -> Vec<Stretch> {
    let moving = level.movers.iter().flat_map(|mover| &mover.features);
    let terrain = level.features.iter().filter(|f| f.kind.is_terrain());
    let terrain: Vec<(&Feature, Rect)> = terrain
        .chain(moving)
        .map(|f| {
            let corners = f.outline.iter().copied();
            let min = corners.clone().reduce(DVec2::min).unwrap();
            (
                f,
                Rect {
                    min,
                    max: corners.reduce(DVec2::max).unwrap(),
                },
            )
        })
        .collect();
    let things = things(level);
    let corners = terrain.iter().flat_map(|(f, _)| &f.outline);
    let all = corners.filter(|at| at.y > level.bottom).map(|&at| {
        let origin = at - HALF;
        let (mut ground, mut lines) = ([0; ROWS], [0; ROWS]);
        let seen = |box_: &Rect| box_.max.cmpgt(origin).all() && box_.min.cmplt(at + HALF).all();
        for (feature, _) in terrain.iter().filter(|(_, box_)| seen(box_)) {
            match feature.kind {
                Kind::OneWay => trace(&mut lines, &feature.outline, origin),
                _ => fill(&mut ground, &feature.outline, origin),
            }
        }
        let skin = skin(&ground);
        let surface = std::array::from_fn(|row| skin[row] | lines[row]);
        let near = things.iter().map(|(kind, p)| (kind.clone(), *p - at));
        Stretch {
            at,
            surface,
            around: widen(&surface),
            things: near.filter(|(_, p)| p.abs().cmplt(HALF).all()).collect(),
        }
    });
    all.filter(|stretch| count(&stretch.surface) >= LEAST_SURFACE)
        .collect()
}

/// Left and right as they are, and exchanged.
const SIDES: [f64; 2] = [1.0, -1.0];

/// The share of the first things that have one of their kind near them among the others, whose left and right side may be exchanged.
fn matched(things: &[Thing], others: &[Thing], side: f64) -> f64 {
    let side = DVec2::new(side, 1.0);
    let has_its_like = |(kind, p): &&Thing| {
        let mut others = others.iter();
        others.any(|(other, q)| kind == other && p.distance(*q * side) < NEAR)
    };
    let matched = things.iter().filter(has_its_like).count();
    if things.is_empty() {
        0.0
    } else {
        matched as f64 / things.len() as f64
    }
}

impl Stretch {
    /// Whether somebody would take one for the other.
    fn is_like(&self, other: &Stretch, side: f64) -> bool {
        let as_seen = |cells: &Cells| if side < 0.0 { turned(cells) } else { *cells };
        let there = shared(&self.surface, &as_seen(&other.around));
        let ground = there.min(shared(&other.surface, &as_seen(&self.around)));
        if ground < SAME_KIND {
            return false;
        }
        let things = matched(&self.things, &other.things, side);
        ground >= SAME_PLACE
            || things.min(matched(&other.things, &self.things, side)) >= SAME_THINGS
    }
}

/// Two stretches of a level that repeat each other and share nothing, if there are any: their middles.
fn repeated(level: &Level) -> Option<(DVec2, DVec2)> {
    let all = stretches(level);
    let pairs = all.iter().enumerate();
    let mut pairs = pairs.flat_map(|(i, a)| all[..i].iter().map(move |b| (a, b)));
    let alike = |(a, b): &(&Stretch, &Stretch)| {
        let overlap = (a.at - b.at).abs().cmplt(2.0 * HALF).all();
        !overlap && SIDES.iter().any(|&side| a.is_like(b, side))
    };
    pairs.find(alike).map(|(a, b)| (a.at, b.at))
}

fn quarry() -> Level {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("levels/quarry.ron");
    level::load(&file).unwrap()
}

/// A level whose last part is a copy of what is within 10 m of `x`, far from the rest: moved by hand, so that no corner is
/// exactly where it was.
fn with_copy(level: &Level, x: f64, side: f64, dressed: bool) -> Level {
    let mut count = 0.0;
    let mut there = |p: DVec2| {
        count += 1.0;
        let slip = CLUMSY * DVec2::new(libm::sin(17.0 * count), libm::cos(23.0 * count));
        FAR + DVec2::new(side * (p.x - x), p.y) + slip
    };
    let within = |p: &DVec2| (p.x - x).abs() <= HALF.x;
    let mut copy = level.clone();
    for feature in &level.features {
        let (first, last) = reach(&feature.outline);
        if first <= x + HALF.x && last >= x - HALF.x {
            let outline = feature.outline.iter().map(|&p| there(p)).collect();
            copy.features.push(Feature {
                outline,
                ..feature.clone()
            });
        }
    }
    for piece in level
        .scenery
        .iter()
        .filter(|piece| dressed && within(&piece.at))
    {
        copy.scenery.push(Scenery {
            at: there(piece.at),
            ..piece.clone()
        });
    }
    copy
}

/// The least and the greatest x of some corners.
fn reach(outline: &[DVec2]) -> (f64, f64) {
    let x = outline.iter().map(|p| p.x);
    (
        x.clone().fold(f64::MAX, f64::min),
        x.fold(f64::MIN, f64::max),
    )
}

#[test]
fn no_two_stretches_of_the_quarry_repeat() {
    assert_eq!(repeated(&quarry()), None);
}

#[test]
fn a_stretch_that_is_copied_is_noticed() {
    let level = quarry();
    for x in [0.0, 34.0, 72.0, 130.0, 156.0, 196.0, 246.0, 280.0] {
        for (side, dressed) in [(1.0, true), (-1.0, true), (1.0, false)] {
            let found = repeated(&with_copy(&level, x, side, dressed));
            let (copy, _) = found.unwrap_or_else(|| panic!("{x}, {side}, {dressed}"));
            assert!(copy.x > FAR.x / 2.0, "{x}: {copy}");
        }
    }
}
