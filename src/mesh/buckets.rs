//! A bucket grid: which segments and which hot pixels may be near a place. Only ever asked cell by cell, never iterated.
//!
//! Cells are squares of a power of two of steps. A segment is registered in every cell that it comes
//! within one step of, a pixel in the cell of its point; so the segments that meet a pixel are among those
//! of the pixel's cell, and the pixels that a segment meets are among those of the segment's cells.
//!
//! A cell with many pixels is split into smaller ones, so lists stay short wherever crossings crowd.

mod split;

use super::VertexId;
use super::topology::NONE;
use crate::geom::Point;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// Where a cell has its lists. It stays there while there is anything in it.
pub type Slot = u32;

/// Segments and hot pixels by cell, as linked lists.
#[derive(Clone, Debug)]
pub struct Buckets {
    /// Cells have 2^shift steps.
    shift: u32,
    /// Blocks of four by four cells by their place: cells next to each other lie together in memory.
    blocks: HashMap<u64, u32, BuildHasherDefault<CellHasher>>,
    /// The block that was asked for last: mostly the next one, too.
    recent: Option<(u64, u32)>,
    /// Sixteen for each block.
    cells: Vec<Cell>,
    /// Blocks that can be given away.
    vacant: Vec<u32>,
    /// Cells that have cells instead of lists.
    splits: Vec<split::Split>,
    /// Those of them that can be given away.
    vacant_splits: Vec<u32>,
    links: Vec<Link>,
    /// The first of the unused links.
    free: u32,
    /// By vertex.
    pixels: Vec<Pixel>,
    /// Scratch: cells along a segment.
    leaves: Vec<Slot>,
}

/// The first link of a cell's segments, and the first of its pixels; of one that is split see [`Cell::split`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cell {
    segments: u32,
    pixels: u32,
}

/// The corners of all cells.
const EVERYWHERE: ((i64, i64), (i64, i64)) = ((i64::MIN, i64::MIN), (i64::MAX, i64::MAX));

/// Cells in a block.
const BLOCK: usize = 16;

const EMPTY: Cell = Cell {
    segments: NONE,
    pixels: NONE,
};

#[derive(Clone, Copy, Debug)]
struct Link {
    segment: u32,
    next: u32,
}

/// A hot pixel, and the next one in its cell.
#[derive(Clone, Copy, Debug)]
struct Pixel {
    point: Point,
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

// Cells.
impl Buckets {
    /// Empty buckets with cells of 2^shift steps, and some vertices that are in none.
    pub fn new(shift: u32, reserved: &[Point]) -> Self {
        let pixel = |&point: &Point| Pixel { point, next: NONE };
        Buckets {
            shift,
            blocks: HashMap::default(),
            recent: None,
            cells: Vec::new(),
            vacant: Vec::new(),
            splits: Vec::new(),
            vacant_splits: Vec::new(),
            links: Vec::new(),
            free: NONE,
            pixels: reserved.iter().map(pixel).collect(),
            leaves: Vec::new(),
        }
    }

    /// The place of the block of a cell, and the cell's number in it.
    fn place(column: i64, row: i64) -> (u64, Slot) {
        let block = ((column >> 2) as u64) << 32 | u64::from((row >> 2) as u32);
        (block, (4 * (column & 3) + (row & 3)) as Slot)
    }

    /// The slot of a cell that may have lists.
    fn find(&self, column: i64, row: i64) -> Option<Slot> {
        let (place, cell) = Self::place(column, row);
        let block = self.blocks.get(&place)?;
        Some(BLOCK as Slot * block + cell)
    }

    /// The slot of a cell that is to have lists.
    #[inline]
    fn slot(&mut self, column: i64, row: i64) -> Slot {
        let (place, cell) = Self::place(column, row);
        let block = match self.recent {
            Some((recent, block)) if recent == place => block,
            _ => self.block(place),
        };
        BLOCK as Slot * block + cell
    }

    /// The block at a place, made if it is not there.
    fn block(&mut self, place: u64) -> u32 {
        let block = match self.blocks.get(&place) {
            Some(&block) => block,
            None => {
                let block = self.make_block();
                self.blocks.insert(place, block);
                block
            }
        };
        self.recent = Some((place, block));
        block
    }

    /// A block of empty cells.
    fn make_block(&mut self) -> u32 {
        self.vacant.pop().unwrap_or_else(|| {
            self.cells.extend([EMPTY; BLOCK]);
            (self.cells.len() / BLOCK) as u32 - 1
        })
    }

    /// Lets the block of a cell go if nothing is left in it.
    fn tidy(&mut self, slot: Slot, column: i64, row: i64) {
        let first = slot as usize / BLOCK * BLOCK;
        if self.cells[first..first + BLOCK] == [EMPTY; BLOCK] {
            self.blocks.remove(&Self::place(column, row).0);
            self.recent = None;
            self.vacant.push(slot / BLOCK as Slot);
        }
    }

    fn cell_of(&self, p: Point) -> (i64, i64) {
        (i64::from(p.x) >> self.shift, i64::from(p.y) >> self.shift)
    }

    /// Calls `each` with column and row of the cells within one step of a segment, each once, in a fixed order.
    #[inline]
    fn along(shift: u32, a: Point, b: Point, each: impl FnMut(i64, i64)) {
        Self::along_within(shift, a, b, EVERYWHERE, each);
    }

    /// The same for the cells between two corners.
    #[inline]
    fn along_within(
        shift: u32,
        a: Point,
        b: Point,
        (least, most): ((i64, i64), (i64, i64)),
        mut each: impl FnMut(i64, i64),
    ) {
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let (lx, ly, hx, hy) = (
            i64::from(low.x),
            i64::from(low.y),
            i64::from(high.x),
            i64::from(high.y),
        );
        let (first, last) = ((ly - 1) >> shift, (hy + 1) >> shift);
        for row in first.max(least.1)..=last.min(most.1) {
            // The part of the segment within one step of this row, in x, rounded outwards.
            let from = (row << shift) - 1;
            let to = ((row + 1) << shift) + 1;
            let at = |y: i64| lx + ((hx - lx) * (y - ly)).div_euclid(hy - ly);
            let x = if from <= ly { lx } else { at(from.min(hy)) };
            let y = if to >= hy { hx } else { at(to.max(ly)) };
            let (left, right) = ((x.min(y) - 1) >> shift, (x.max(y) + 2) >> shift);
            for column in left.max(least.0)..=right.min(most.0) {
                each(column, row);
            }
        }
    }

    /// Writes the slots of the cells within one step of a segment behind those that are in a list. The segment is to be added
    /// to them, or is in them.
    pub fn slots_along(&mut self, a: Point, b: Point, slots: &mut Vec<Slot>) {
        Self::along(self.shift, a, b, |column, row| {
            slots.push(self.slot(column, row));
        });
    }
}

// Segments.
impl Buckets {
    /// Makes room for so many more entries of segments in cells.
    pub fn reserve(&mut self, entries: usize) {
        self.links.reserve(entries);
    }

    /// The segments in a cell's list from a link on.
    #[inline]
    pub fn segments_from(&self, mut at: u32) -> impl Iterator<Item = u32> + '_ {
        std::iter::from_fn(move || {
            let link = self.links.get(at as usize)?;
            at = link.next;
            Some(link.segment)
        })
    }

    /// The segments in the cell of a point.
    pub fn segments_at(&self, p: Point) -> impl Iterator<Item = u32> + '_ {
        let (column, row) = self.cell_of(p);
        let slot = self.find(column, row).map(|slot| self.leaf(slot, p));
        self.segments_from(slot.map_or(NONE, |slot| self.cells[slot as usize].segments))
    }

    /// Adds a segment to a cell. The link from which on its list has the segments that were there.
    pub fn add_segment(&mut self, slot: Slot, segment: u32) -> u32 {
        let before = self.cells[slot as usize].segments;
        self.cells[slot as usize].segments = self.make_link(segment, before);
        before
    }

    /// A link with a segment before another link.
    fn make_link(&mut self, segment: u32, next: u32) -> u32 {
        let link = Link { segment, next };
        let at = self.free;
        match self.links.get_mut(at as usize) {
            Some(free) => {
                self.free = std::mem::replace(free, link).next;
                at
            }
            None => {
                self.links.push(link);
                self.links.len() as u32 - 1
            }
        }
    }

    /// Removes a segment from all cells that it is in.
    pub fn remove_segment(&mut self, a: Point, b: Point, segment: u32) {
        Self::along(self.shift, a, b, |column, row| {
            if let Some(slot) = self.find(column, row) {
                self.part(slot, (a, b), segment);
                self.tidy(slot, column, row);
            }
        });
    }

    fn unlink(&mut self, slot: Slot, segment: u32) {
        let mut head = self.cells[slot as usize].segments;
        self.unlink_from(&mut head, segment);
        self.cells[slot as usize].segments = head;
    }

    /// Removes a segment from the list that starts with a link; whether it was there.
    fn unlink_from(&mut self, head: &mut u32, segment: u32) -> bool {
        let (mut before, mut at) = (NONE, *head);
        while at != NONE && self.links[at as usize].segment != segment {
            (before, at) = (at, self.links[at as usize].next);
        }
        if at == NONE {
            return false;
        }
        let next = std::mem::replace(&mut self.links[at as usize].next, self.free);
        self.free = at;
        match self.links.get_mut(before as usize) {
            Some(link) => link.next = next,
            None => *head = next,
        }
        true
    }
}

// Pixels.
impl Buckets {
    /// One more than the largest vertex id in use so far.
    pub fn vertex_count(&self) -> usize {
        self.pixels.len()
    }

    /// The point of a vertex; that of an unused id means nothing.
    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.pixels[v.index()].point
    }

    /// The hot pixels in a cell.
    #[inline]
    pub fn pixels(&self, slot: Slot) -> impl Iterator<Item = (VertexId, Point)> + '_ {
        let mut at = self.cells[slot as usize].pixels;
        std::iter::from_fn(move || {
            let v = VertexId(at);
            let pixel = self.pixels.get(v.index())?;
            at = pixel.next;
            Some((v, pixel.point))
        })
    }

    /// The hot pixels in the cell of a point and in the eight around it, its own first.
    pub fn pixels_around(&self, p: Point) -> impl Iterator<Item = VertexId> + '_ {
        let (column, row) = self.cell_of(p);
        let order = [0, -1, 1];
        let cells = order
            .into_iter()
            .flat_map(move |dx| order.map(|dy| (column + dx, row + dy)));
        cells
            .filter_map(|(column, row)| self.find(column, row))
            .flat_map(move |slot| self.pixels_below(slot, p))
    }

    /// Makes the pixel of a point hot, with the vertex that `name` gives it; nothing if it is hot. A cell that is split for it
    /// asks for the ends of segments.
    pub fn heat(
        &mut self,
        p: Point,
        name: impl FnOnce(&Self) -> VertexId,
        ends: &[(Point, Point)],
    ) -> Option<VertexId> {
        let (column, row) = self.cell_of(p);
        let top = self.slot(column, row);
        let slot = self.leaf(top, p);
        let mut others = 0;
        for (_, other) in self.pixels(slot) {
            if other == p {
                return None;
            }
            others += 1;
        }
        let v = name(self);
        let pixel = Pixel {
            point: p,
            next: NONE,
        };
        match self.pixels.get_mut(v.index()) {
            Some(free) => *free = pixel,
            None => self.pixels.push(pixel),
        }
        self.add_pixel(slot, v);
        if slot != top || others >= split::MANY {
            self.grow(top, p, others, ends);
        }
        Some(v)
    }

    /// Puts a hot pixel into a cell's list.
    fn add_pixel(&mut self, slot: Slot, v: VertexId) {
        let head = &mut self.cells[slot as usize].pixels;
        self.pixels[v.index()].next = std::mem::replace(head, v.0);
    }

    /// Forgets a hot pixel.
    pub fn cool(&mut self, v: VertexId) {
        let Pixel { point, next } = self.pixels[v.index()];
        let (column, row) = self.cell_of(point);
        let Some(top) = self.find(column, row) else {
            return;
        };
        let slot = self.leaf(top, point);
        let head = &mut self.cells[slot as usize].pixels;
        if *head == v.0 {
            *head = next;
        } else {
            let mut before = *head as usize;
            while self.pixels[before].next != v.0 {
                before = self.pixels[before].next as usize;
            }
            self.pixels[before].next = next;
        }
        if slot != top {
            self.shrink(top, point);
        }
        self.tidy(top, column, row);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::predicates::{crosses, meets_pixel};

    #[test]
    fn every_pixel_that_a_segment_meets_is_in_one_of_its_cells() {
        let buckets = Buckets::new(2, &[]);
        let points: Vec<Point> = (-5..6)
            .flat_map(|x| (-6..5).map(move |y| Point::new(x, y)))
            .collect();
        for &a in &points {
            for &b in &points {
                let mut cells = Vec::new();
                Buckets::along(buckets.shift, a, b, |column, row| cells.push((column, row)));
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
    fn segments_come_and_go() {
        let mut buckets = Buckets::new(3, &[]);
        let at = |x: i32| (Point::new(x, 3), Point::new(x, 4));
        for (x, segment) in [(4, 10), (4, 11), (12, 10), (4, 12)] {
            let mut slots = Vec::new();
            buckets.slots_along(at(x).0, at(x).1, &mut slots);
            assert_eq!(slots.len(), 1, "all in one cell");
            buckets.add_segment(slots[0], segment);
        }
        let all = |buckets: &Buckets, x| buckets.segments_at(at(x).0).collect::<Vec<_>>();
        let remove = |buckets: &mut Buckets, x, segment| {
            buckets.remove_segment(at(x).0, at(x).1, segment);
        };
        assert_eq!(all(&buckets, 4), [12, 11, 10]);
        remove(&mut buckets, 4, 11);
        remove(&mut buckets, 4, 99);
        assert_eq!(
            (all(&buckets, 4), all(&buckets, 12)),
            (vec![12, 10], vec![10])
        );
        remove(&mut buckets, 4, 12);
        remove(&mut buckets, 4, 10);
        remove(&mut buckets, 12, 10);
        let far = (1 << 20) + 4;
        let mut slots = Vec::new();
        buckets.slots_along(at(far).0, at(far).1, &mut slots);
        buckets.add_segment(slots[0], 1);
        assert_eq!((all(&buckets, 4), all(&buckets, far)), (vec![], vec![1]));
        assert_eq!(buckets.links.len(), 4, "links are used again");
        assert_eq!(buckets.cells.len(), BLOCK, "and so are blocks");
    }

    /// Hot pixels with vertices from 20 on.
    fn heated(points: &[(i32, i32)]) -> Buckets {
        let mut buckets = Buckets::new(3, &[Point::new(0, 0); 20]);
        for &(x, y) in points {
            let next = |b: &Buckets| VertexId(b.vertex_count() as u32);
            let v = buckets.heat(Point::new(x, y), next, &[]);
            assert!(v.is_some(), "not hot yet");
        }
        buckets
    }

    #[test]
    fn pixels_around_a_point_are_those_of_nine_cells() {
        let buckets = heated(&[(-1, 8), (7, 15), (8, 0), (16, 8), (7, -1)]);
        let around = |x: i32, y: i32| {
            let all = buckets.pixels_around(Point::new(x, y)).map(|v| v.0);
            all.collect::<Vec<_>>()
        };
        let own_first = "its own cell first, then by columns";
        assert_eq!(around(0, 8), [21, 20, 22], "{own_first}");
        assert_eq!(around(8, 0), [22, 24, 21, 23]);
    }

    /// All that buckets say of every point of a square, and what is in memory for it.
    fn said(buckets: &Buckets, ends: &[(Point, Point)], side: i32) -> Vec<(Vec<u32>, Vec<u32>)> {
        let points = (0..side * side).map(|i| Point::new(i % side, i / side));
        let said = |p: Point| {
            let met = |&s: &u32| meets_pixel(ends[s as usize].0, ends[s as usize].1, p);
            let mut segments: Vec<u32> = buckets.segments_at(p).filter(met).collect();
            segments.sort_unstable();
            let hot = |v: &VertexId| buckets.point(*v) == p;
            let pixels = buckets.pixels_around(p).filter(hot).map(|v| v.0);
            (segments, pixels.collect())
        };
        points.map(said).collect()
    }

    #[test]
    fn crowded_cells_are_split_and_made_whole_again() {
        let side = 70;
        let segment = |i: i32| (Point::new(i * 7, 3), Point::new(69 - i * 3, 66));
        let ends: Vec<(Point, Point)> = (0..10).map(segment).collect();
        let mut buckets = Buckets::new(6, &[]);
        let add = |buckets: &mut Buckets, segment: usize| {
            let ((a, b), mut slots, mut met) = (ends[segment], Vec::new(), Vec::new());
            buckets.slots_along(a, b, &mut slots);
            for slot in slots {
                buckets.meet(slot, (a, b), segment as u32, &mut met);
            }
            let crosses = |&other: &usize| crosses(a, b, ends[other].0, ends[other].1);
            let mut crossed = (0..segment).filter(crosses);
            assert!(crossed.all(|other| met.contains(&(other as u32))));
        };
        (0..5).for_each(|segment| add(&mut buckets, segment));
        let sparse = said(&buckets, &ends, side);
        let points: Vec<Point> = (0..900)
            .map(|i| Point::new(i * 31 % side, i * 47 % 63))
            .collect();
        let next = |b: &Buckets| VertexId(b.vertex_count() as u32);
        let born: Vec<VertexId> = points
            .iter()
            .filter_map(|&p| buckets.heat(p, next, &ends))
            .collect();
        assert!(born.len() > 400 && buckets.cells.len() > 10 * BLOCK);
        (5..10).for_each(|segment| add(&mut buckets, segment));
        for (i, (segments, pixels)) in said(&buckets, &ends, side).into_iter().enumerate() {
            let p = Point::new(i as i32 % side, i as i32 / side);
            let met = (0..10).filter(|&s| meets_pixel(ends[s].0, ends[s].1, p));
            assert_eq!(segments, met.map(|s| s as u32).collect::<Vec<_>>(), "{p:?}");
            let hot = born.iter().filter(|v| buckets.point(**v) == p).map(|v| v.0);
            assert_eq!(pixels, hot.collect::<Vec<_>>(), "{p:?}");
        }
        for (segment, &(a, b)) in ends.iter().enumerate().skip(5) {
            buckets.remove_segment(a, b, segment as u32);
        }
        born.iter().for_each(|&v| buckets.cool(v));
        assert_eq!(said(&buckets, &ends, side), sparse);
        let gone = buckets.vacant.len() * BLOCK;
        assert!(
            buckets.cells.len() - gone <= 4 * BLOCK,
            "all cells are whole"
        );
        assert_eq!(buckets.splits.len(), buckets.vacant_splits.len());
    }

    #[test]
    fn pixels_heat_up_and_cool_down() {
        let points = [(1, 1), (2, 2), (3, 3), (40, 1)];
        for order in [[0, 1, 2], [2, 1, 0], [1, 0, 2], [1, 2, 0]] {
            let mut buckets = heated(&points);
            let again = buckets.heat(Point::new(2, 2), |_| VertexId(99), &[]);
            assert_eq!(again, None, "it is hot");
            for (gone, i) in order.into_iter().enumerate() {
                buckets.cool(VertexId(20 + i));
                assert_eq!(buckets.pixels_around(Point::new(1, 1)).count(), 2 - gone);
            }
            buckets.cool(VertexId(23));
            assert_eq!(
                buckets.heat(Point::new(99, 9), |_| VertexId(21), &[]),
                Some(VertexId(21))
            );
            assert_eq!(buckets.point(VertexId(21)), Point::new(99, 9));
            assert!(buckets.cells.len() <= 2 * BLOCK, "blocks are used again");
        }
    }
}
