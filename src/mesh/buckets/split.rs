//! Cells that are split: they have a block of four by four cells of their own instead of lists, and so on down to single
//! pixels.
//!
//! A list of pixels so never gets long, however many crossings lie in a place. A cell that was split is made whole again when
//! few of its pixels are left.

use super::{BLOCK, Buckets, Cell, EMPTY, Slot};
use crate::geom::Point;
use crate::mesh::VertexId;
use crate::mesh::topology::NONE;

/// A cell with more pixels is split.
pub const MANY: u32 = 16;

/// A split cell with fewer pixels is made whole: not so many that it is split again by the next few.
const FEW: u32 = 6;

/// Marks a split cell in the place of its segments.
const SPLIT: u32 = NONE - 1;

/// What a split cell has.
#[derive(Clone, Copy, Debug)]
pub struct Split {
    /// Its cells.
    block: u32,
    /// They have 2^shift steps.
    shift: u32,
    /// Column and row of the first of them.
    first: (i64, i64),
    /// How many pixels they have together.
    pixels: u32,
    /// The first link of the segments in all of them, if it is in no split cell itself.
    segments: u32,
    /// How many those are.
    count: u32,
}

impl Split {
    /// The cell of a point.
    fn inner(&self, p: Point) -> Slot {
        let place = |c: i32| (c >> self.shift & 3) as Slot;
        BLOCK as Slot * self.block + 4 * place(p.x) + place(p.y)
    }

    /// All cells.
    fn all(&self) -> std::ops::Range<Slot> {
        let first = BLOCK as Slot * self.block;
        first..first + BLOCK as Slot
    }
}

impl Cell {
    /// Index among the splits of a cell that is split.
    #[inline]
    fn split(self) -> Option<usize> {
        (self.segments == SPLIT).then_some(self.pixels as usize)
    }
}

impl Buckets {
    #[inline]
    fn split_of(&self, slot: Slot) -> Option<&Split> {
        let cell = self.cells[slot as usize];
        cell.split().map(|index| &self.splits[index])
    }

    /// The cell without cells of its own that a point of a cell is in.
    #[inline]
    pub(super) fn leaf(&self, mut slot: Slot, p: Point) -> Slot {
        while let Some(split) = self.split_of(slot) {
            slot = split.inner(p);
        }
        slot
    }

    /// Writes the cells without cells of their own, in a cell that is one of a segment's, within one step of the
    /// segment behind those that are in a list.
    #[inline]
    pub fn leaves_along(&self, slot: Slot, a: Point, b: Point, leaves: &mut Vec<Slot>) {
        match self.split_of(slot) {
            None => leaves.push(slot),
            Some(split) => self.inner_along(split, a, b, leaves),
        }
    }

    fn inner_along(&self, split: &Split, a: Point, b: Point, leaves: &mut Vec<Slot>) {
        let (left, low) = split.first;
        let within = (split.first, (left + 3, low + 3));
        Self::along_within(split.shift, a, b, within, |column, row| {
            let place = 4 * (column - left) + row - low;
            let slot = split.all().start + place as Slot;
            self.leaves_along(slot, a, b, leaves);
        });
    }

    /// Adds a segment to one of its cells, and writes the segments that were there to a list; some may come several times.
    pub fn meet(&mut self, slot: Slot, (a, b): (Point, Point), segment: u32, met: &mut Vec<u32>) {
        let Some(index) = self.cells[slot as usize].split() else {
            let before = self.add_segment(slot, segment);
            met.extend(self.segments_from(before));
            return;
        };
        let Split {
            segments, count, ..
        } = self.splits[index];
        let (mut leaves, first) = (std::mem::take(&mut self.leaves), met.len());
        self.leaves_along(slot, a, b, &mut leaves);
        for leaf in leaves.drain(..) {
            let before = self.add_segment(leaf, segment);
            if met.len() - first <= count as usize {
                met.extend(self.segments_from(before));
            }
        }
        self.leaves = leaves;
        // Long ones beside each other meet in many cells: then each is asked once, wherever it is.
        if met.len() - first > count as usize {
            met.truncate(first);
            met.extend(self.segments_from(segments));
        }
        let link = self.make_link(segment, segments);
        let split = &mut self.splits[index];
        (split.segments, split.count) = (link, count + 1);
    }

    /// Removes a segment from one of its cells.
    pub(super) fn part(&mut self, slot: Slot, (a, b): (Point, Point), segment: u32) {
        let Some(index) = self.cells[slot as usize].split() else {
            return self.unlink(slot, segment);
        };
        let mut leaves = std::mem::take(&mut self.leaves);
        self.leaves_along(slot, a, b, &mut leaves);
        for leaf in leaves.drain(..) {
            self.unlink(leaf, segment);
        }
        self.leaves = leaves;
        let mut head = self.splits[index].segments;
        if self.unlink_from(&mut head, segment) {
            let split = &mut self.splits[index];
            (split.segments, split.count) = (head, split.count - 1);
        }
    }

    /// The pixels of a cell and of those in it, first of the one that a point lies in, if it does.
    pub(super) fn pixels_below(&self, slot: Slot, p: Point) -> impl Iterator<Item = VertexId> + '_ {
        let nearest = self.split_of(slot).map(|_| self.leaf(slot, p));
        let mut todo = vec![slot];
        let leaves = std::iter::from_fn(move || {
            loop {
                let slot = todo.pop()?;
                match self.split_of(slot) {
                    Some(split) => todo.extend(split.all()),
                    None => return Some(slot),
                }
            }
        });
        let others = leaves.filter(move |&slot| Some(slot) != nearest);
        let leaves = nearest.into_iter().chain(others);
        leaves.flat_map(|slot| self.pixels(slot).map(|pixel| pixel.0))
    }

    /// Counts a new pixel in the split cells that it is in, and splits the last one if it has got too many with it.
    pub(super) fn grow(&mut self, top: Slot, p: Point, others: u32, ends: &[(Point, Point)]) {
        let (mut slot, mut shift) = (top, self.shift);
        while let Some(index) = self.cells[slot as usize].split() {
            let split = &mut self.splits[index];
            split.pixels += 1;
            shift = split.shift;
            slot = split.inner(p);
        }
        if others >= MANY {
            let kept = slot == top;
            self.split(slot, shift, p, ends, kept);
        }
    }

    /// Splits a cell of 2^shift steps, more than the square root of [`MANY`], that a point lies in; its list of segments is
    /// kept beside the new ones if that is wanted.
    fn split(&mut self, slot: Slot, shift: u32, p: Point, ends: &[(Point, Point)], kept: bool) {
        let first = |c: i32| 4 * (i64::from(c) >> shift);
        let split = Split {
            block: self.make_block(),
            shift: shift - 2,
            first: (first(p.x), first(p.y)),
            pixels: 0,
            segments: NONE,
            count: 0,
        };
        let index = self.vacant_splits.pop().unwrap_or_else(|| {
            self.splits.push(split);
            self.splits.len() as u32 - 1
        });
        let cell = Cell {
            segments: SPLIT,
            pixels: index,
        };
        let whole = std::mem::replace(&mut self.cells[slot as usize], cell);
        self.splits[index as usize] = split;
        let mut leaves = Vec::new();
        let segments = match kept {
            true => self.segments_from(whole.segments).collect(),
            false => self.take_segments(whole.segments),
        };
        if kept {
            let split = &mut self.splits[index as usize];
            (split.segments, split.count) = (whole.segments, segments.len() as u32);
        }
        for segment in segments {
            let (a, b) = ends[segment as usize];
            self.inner_along(&split, a, b, &mut leaves);
            for leaf in leaves.drain(..) {
                self.add_segment(leaf, segment);
            }
        }
        for v in self.take_pixels(whole) {
            let p = self.point(v);
            self.add_pixel(split.inner(p), v);
            self.splits[index as usize].pixels += 1;
        }
        for inner in split.all() {
            let pixels = self.pixels(inner).count() as u32;
            let some = self.pixels(inner).next();
            if let Some((_, p)) = some.filter(|_| pixels > MANY) {
                self.split(inner, split.shift, p, ends, false);
            }
        }
    }

    /// Counts a pixel less in the split cells that it was in, and makes the largest whole that has few left.
    pub(super) fn shrink(&mut self, top: Slot, p: Point) {
        let (mut slot, mut sparse) = (top, None);
        while let Some(index) = self.cells[slot as usize].split() {
            let split = &mut self.splits[index];
            split.pixels -= 1;
            if split.pixels < FEW && sparse.is_none() {
                sparse = Some(slot);
            }
            slot = split.inner(p);
        }
        let Some(slot) = sparse else { return };
        let (mut segments, mut pixels) = (Vec::new(), Vec::new());
        self.clear(slot, &mut segments, &mut pixels);
        segments.sort_unstable();
        segments.dedup();
        for segment in segments {
            self.add_segment(slot, segment);
        }
        for v in pixels {
            self.add_pixel(slot, v);
        }
    }

    /// Empties a cell with those in it; a segment may come several times.
    fn clear(&mut self, slot: Slot, segments: &mut Vec<u32>, pixels: &mut Vec<VertexId>) {
        let cell = std::mem::replace(&mut self.cells[slot as usize], EMPTY);
        let Some(index) = cell.split() else {
            segments.extend(self.take_segments(cell.segments));
            pixels.extend(self.take_pixels(cell));
            return;
        };
        let split = self.splits[index];
        self.take_segments(split.segments);
        for inner in split.all() {
            self.clear(inner, segments, pixels);
        }
        self.vacant.push(split.block);
        self.vacant_splits.push(index as u32);
    }

    /// The segments from a link on; their links are free.
    fn take_segments(&mut self, first: u32) -> Vec<u32> {
        let segments = self.segments_from(first).collect();
        let mut at = first;
        while let Some(link) = self.links.get_mut(at as usize) {
            let next = std::mem::replace(&mut link.next, self.free);
            self.free = std::mem::replace(&mut at, next);
        }
        segments
    }

    /// The pixels of a cell that has been taken away.
    fn take_pixels(&mut self, cell: Cell) -> Vec<VertexId> {
        let next = |v: &VertexId| {
            let next = VertexId(self.pixels[v.index()].next);
            Some(next).filter(|next| next.0 != NONE)
        };
        let first = Some(VertexId(cell.pixels)).filter(|first| first.0 != NONE);
        std::iter::successors(first, next).collect()
    }
}
