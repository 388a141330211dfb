//! A bucket grid: which items may be near a place. Only ever asked cell by cell, never iterated.
//!
//! Cells are squares of a power of two of steps. A segment is registered in every cell that it comes
//! within one step of, a point in its own cell; so the segments that meet the pixel of a point are among those
//! of the point's cell, and the pixels that a segment meets are among the points of the segment's cells.

use super::topology::NONE;
use crate::geom::Point;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// Items (any ids) by cell, as linked lists in one slab.
#[derive(Clone, Debug)]
pub struct Buckets {
    /// Cells have 2^shift steps.
    shift: u32,
    /// Blocks of four by four cells by their place: cells next to each other share a cache line.
    blocks: HashMap<u64, u32, BuildHasherDefault<CellHasher>>,
    /// For each block the first link of each of its cells.
    heads: Vec<[u32; 16]>,
    vacant: Vec<u32>,
    links: Vec<Link>,
    free: u32,
}

#[derive(Clone, Copy, Debug)]
struct Link {
    item: u32,
    next: u32,
}

/// Multiplies by an odd number and folds the high half back (as in Knuth's multiplicative hashing).
#[derive(Clone, Default)]
pub struct CellHasher(u64);

impl Hasher for CellHasher {
    fn finish(&self) -> u64 {
        self.0
    }
    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_u64(u64::from(byte));
        }
    }
    fn write_u32(&mut self, n: u32) {
        self.write_u64(u64::from(n));
    }
    fn write_i32(&mut self, n: i32) {
        self.write_u64(u64::from(n as u32));
    }
    fn write_usize(&mut self, n: usize) {
        self.write_u64(n as u64);
    }
    fn write_u64(&mut self, n: u64) {
        let wide = u128::from(self.0.rotate_left(32) ^ n) * 0x9e37_79b9_7f4a_7c15;
        self.0 = wide as u64 ^ (wide >> 64) as u64;
    }
}

impl Buckets {
    /// Empty buckets with cells of 2^shift steps.
    pub fn new(shift: u32) -> Self {
        Buckets {
            shift,
            blocks: HashMap::default(),
            heads: Vec::new(),
            vacant: Vec::new(),
            links: Vec::new(),
            free: NONE,
        }
    }

    fn key(column: i64, row: i64) -> u64 {
        ((column as u64) << 32) | u64::from(row as u32)
    }

    /// The block of a cell, and the cell's number in it.
    fn place(cell: u64) -> (u64, usize) {
        let (column, row) = ((cell >> 32) as i32, cell as i32);
        let block = Self::key(i64::from(column >> 2), i64::from(row >> 2));
        (block, (4 * (column & 3) + (row & 3)) as usize)
    }

    /// The first link of a cell's list.
    fn head(&self, cell: u64) -> u32 {
        let (block, i) = Self::place(cell);
        let block = self.blocks.get(&block);
        block.map_or(NONE, |&block| self.heads[block as usize][i])
    }

    /// The cell of a point.
    pub fn cell_of(&self, p: Point) -> u64 {
        Self::key(i64::from(p.x) >> self.shift, i64::from(p.y) >> self.shift)
    }

    /// Writes the cells within one step of a segment to `cells`, each once, in a fixed order.
    pub fn cells_along(&self, a: Point, b: Point, cells: &mut Vec<u64>) {
        cells.clear();
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let (lx, ly, hx, hy) = (
            i64::from(low.x),
            i64::from(low.y),
            i64::from(high.x),
            i64::from(high.y),
        );
        let (first, last) = ((ly - 1) >> self.shift, (hy + 1) >> self.shift);
        for row in first..=last {
            // The part of the segment within one step of this row, in x, rounded outwards.
            let from = ly.max((row << self.shift) - 1);
            let to = hy.min(((row + 1) << self.shift) + 1);
            let (x, y) = if first == last || ly == hy {
                (lx, hx)
            } else {
                let at = |y: i64| lx + ((hx - lx) * (y - ly)).div_euclid(hy - ly);
                (at(from.clamp(ly, hy)), at(to.clamp(ly, hy)))
            };
            for column in (x.min(y) - 1) >> self.shift..=(x.max(y) + 2) >> self.shift {
                cells.push(Self::key(column, row));
            }
        }
    }

    /// The items of a cell.
    pub fn items(&self, cell: u64) -> impl Iterator<Item = u32> + '_ {
        self.items_from(self.head(cell))
    }

    /// The items of a cell's list from a link on.
    pub fn items_from(&self, mut at: u32) -> impl Iterator<Item = u32> + '_ {
        std::iter::from_fn(move || {
            let link = self.links.get(at as usize)?;
            at = link.next;
            Some(link.item)
        })
    }

    /// The items of the cell of a point and of the eight around it, its own first.
    pub fn items_around(&self, p: Point) -> impl Iterator<Item = u32> + '_ {
        let (column, row) = (i64::from(p.x) >> self.shift, i64::from(p.y) >> self.shift);
        let order = [0, -1, 1];
        let cells = order
            .into_iter()
            .flat_map(move |dx| order.map(|dy| (column + dx, row + dy)));
        cells.flat_map(|(column, row)| self.items(Self::key(column, row)))
    }

    /// Adds an item to a cell. The link from which on its list has the items that were there.
    pub fn add(&mut self, cell: u64, item: u32) -> u32 {
        let (block, i) = Self::place(cell);
        let block = *self.blocks.entry(block).or_insert_with(|| {
            self.vacant.pop().unwrap_or_else(|| {
                self.heads.push([NONE; 16]);
                self.heads.len() as u32 - 1
            })
        });
        let head = &mut self.heads[block as usize][i];
        let (link, before) = (Link { item, next: *head }, *head);
        if self.free == NONE {
            *head = self.links.len() as u32;
            self.links.push(link);
        } else {
            *head = self.free;
            self.free = std::mem::replace(&mut self.links[*head as usize], link).next;
        }
        before
    }

    /// Removes an item from a cell, if it is there.
    pub fn remove(&mut self, cell: u64, item: u32) {
        let (block, i) = Self::place(cell);
        let Some(&index) = self.blocks.get(&block) else {
            return;
        };
        let heads = &mut self.heads[index as usize];
        let (mut before, mut at) = (NONE, heads[i]);
        while at != NONE && self.links[at as usize].item != item {
            (before, at) = (at, self.links[at as usize].next);
        }
        if at == NONE {
            return;
        }
        let next = std::mem::replace(&mut self.links[at as usize].next, self.free);
        self.free = at;
        if before != NONE {
            self.links[before as usize].next = next;
        } else {
            heads[i] = next;
            if *heads == [NONE; 16] {
                self.blocks.remove(&block);
                self.vacant.push(index);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::predicates::meets_pixel;

    #[test]
    fn every_pixel_that_a_segment_meets_is_in_one_of_its_cells() {
        let buckets = Buckets::new(2);
        let mut cells = Vec::new();
        let points: Vec<Point> = (-5..6)
            .flat_map(|x| (-6..5).map(move |y| Point::new(x, y)))
            .collect();
        for &a in &points {
            for &b in &points {
                buckets.cells_along(a, b, &mut cells);
                let met = points.iter().filter(|&&p| meets_pixel(a, b, p));
                let missed = met
                    .map(|&p| buckets.cell_of(p))
                    .find(|cell| !cells.contains(cell));
                assert_eq!(missed, None, "{a:?} {b:?}");
                let count = cells.len();
                cells.sort_unstable();
                cells.dedup();
                assert_eq!(cells.len(), count, "each cell once: {a:?} {b:?}");
            }
        }
    }

    #[test]
    fn items_come_and_go() {
        let mut buckets = Buckets::new(3);
        for (cell, item) in [(1, 10), (1, 11), (2, 10), (1, 12)] {
            buckets.add(cell, item);
        }
        let items = |buckets: &Buckets, cell| buckets.items(cell).collect::<Vec<_>>();
        assert_eq!(items(&buckets, 1), [12, 11, 10]);
        buckets.remove(1, 11);
        buckets.remove(1, 99);
        assert_eq!(
            (items(&buckets, 1), items(&buckets, 2)),
            (vec![12, 10], vec![10])
        );
        buckets.remove(1, 12);
        buckets.remove(1, 10);
        buckets.add(3, 7);
        assert_eq!(buckets.links.len(), 4, "links are used again");
        let [near, far] = [0, 1 << 20].map(|x| buckets.cell_of(Point::new(x, 0)));
        buckets.remove(3, 7);
        buckets.remove(2, 10);
        buckets.add(far, 1);
        assert_eq!(buckets.heads.len(), 1, "and so are blocks");
        assert_eq!(
            (items(&buckets, near), items(&buckets, far)),
            (vec![], vec![1])
        );
    }

    #[test]
    fn items_around_a_point_are_those_of_nine_cells() {
        let mut buckets = Buckets::new(3);
        for (item, at) in [
            (20, (-1, 8)),
            (21, (7, 15)),
            (22, (8, 0)),
            (23, (16, 8)),
            (24, (7, -1)),
        ] {
            buckets.add(buckets.cell_of(Point::new(at.0, at.1)), item);
        }
        let around = |x: i32, y: i32| buckets.items_around(Point::new(x, y)).collect::<Vec<_>>();
        assert_eq!(
            around(0, 8),
            [21, 20, 22],
            "its own cell first, then by columns"
        );
        assert_eq!(around(8, 0), [22, 24, 21, 23]);
    }
}
