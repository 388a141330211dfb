//! The arrangement of all feature edges, snapped to the grid: which grid points are vertices, and through which
//! of them each segment runs.
//!
//! *Snap rounding* (Hobby 1999; the dynamic version Guibas and Marimont 1998): a pixel is *hot* while it holds
//! an end or a proper crossing of original segments; a segment becomes the chain of the hot pixels
//! that it meets. Chains stay within half a step per axis of their segments, are monotone along them and never
//! cross one another, and all of it is a function of the *set* of segments: every decision tests
//! originals, never pieces. An edit is a batch: it reports the pixels that heat up or cool down, and each
//! segment whose chain changes because of that.

use super::buckets::Buckets;
use super::short::Short;
use super::{SegmentId, VertexId};
use crate::geom::Point;
use crate::geom::predicates::{crosses, crossing_pixel, meets_pixel};

/// The vertices of a chain; most chains have few.
pub type Chain = Short<VertexId, 6>;

/// Ends and chain of one original segment.
#[derive(Clone, Debug)]
struct Original {
    a: Point,
    b: Point,
    /// The hot pixels it meets, from a to b; empty while the id is unused.
    chain: Chain,
}

/// What an edit does to the mesh.
#[derive(Clone, Debug, Default)]
pub struct Diff {
    /// Hot pixels that were not, in the order in which they were found.
    pub born: Vec<VertexId>,
    /// Hot pixels that are no more, ascending by id.
    pub dead: Vec<VertexId>,
    /// The added segments, in order; their chains are new.
    pub added: Vec<SegmentId>,
    /// Removed segments, and those that stay but change their chain.
    pub rerouted: Vec<Reroute>,
}

/// A stretch of a chain before and after an edit, with one vertex in common at each end; of a
/// removed segment the whole chain before and nothing after.
#[derive(Clone, Debug)]
pub struct Reroute {
    /// The segment.
    pub segment: SegmentId,
    /// Old vertices, from a to b.
    pub old: Chain,
    /// New vertices, from a to b.
    pub new: Chain,
}

/// All segments, all hot pixels, and where they are.
#[derive(Clone, Debug)]
pub struct Arrangement {
    originals: Vec<Original>,
    free_segments: Vec<SegmentId>,
    /// Point of each hot pixel by vertex id.
    points: Vec<Point>,
    free_vertices: Vec<VertexId>,
    segments: Buckets,
    pixels: Buckets,
    /// Scratch: cells of the segment being looked at.
    cells: Vec<u64>,
    /// Scratch: its crossings with others.
    crossings: Vec<Point>,
    /// Scratch: a chain.
    chain: Vec<VertexId>,
}

impl Arrangement {
    /// An arrangement of no segments, with some vertex ids reserved for points that are never hot.
    ///
    /// `shift` is the binary logarithm of the cell size in steps: about the usual length of a segment is best.
    pub fn new(shift: u32, reserved: &[Point]) -> Self {
        Arrangement {
            originals: Vec::new(),
            free_segments: Vec::new(),
            points: reserved.to_vec(),
            free_vertices: Vec::new(),
            segments: Buckets::new(shift),
            pixels: Buckets::new(shift),
            cells: Vec::new(),
            crossings: Vec::new(),
            chain: Vec::new(),
        }
    }

    /// Points by vertex id; those of unused ids mean nothing.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The chain of a segment.
    pub fn chain(&self, segment: SegmentId) -> &[VertexId] {
        &self.originals[segment.index()].chain
    }

    /// The hot pixels near a grid point, in no particular order; there may be others that are as near.
    pub fn near(&self, p: Point) -> impl Iterator<Item = VertexId> + '_ {
        self.pixels.items_around(p).map(VertexId)
    }

    /// Ends of a segment.
    pub fn ends(&self, segment: SegmentId) -> (Point, Point) {
        let s = &self.originals[segment.index()];
        (s.a, s.b)
    }

    /// Adds segments (each of some length) and removes others. Returns what changes.
    ///
    /// The ids of removed segments and dead vertices may be given away by the next edit.
    pub fn edit(&mut self, add: &[(Point, Point)], remove: &[SegmentId]) -> Diff {
        let mut diff = Diff::default();
        for &segment in remove {
            let (old, new) = (self.unregister(segment), Chain::default());
            diff.rerouted.push(Reroute { segment, old, new });
        }
        let survivors = self.originals.len() > self.free_segments.len() + remove.len();
        self.originals.reserve(add.len());
        for &(a, b) in add {
            let segment = self.register(a, b, &mut diff.born);
            diff.added.push(segment);
        }
        diff.dead = self.cooled(&diff.rerouted);
        if survivors {
            self.reroute_survivors(&mut diff);
        }
        self.bury(&diff.dead);
        for &segment in &diff.added {
            self.originals[segment.index()].chain = self.find_chain(segment);
        }
        self.free_segments.extend(remove.iter().rev());
        diff
    }

    /// Takes a segment out of the buckets; returns its chain.
    fn unregister(&mut self, segment: SegmentId) -> Chain {
        let (a, b) = self.ends(segment);
        self.segments.cells_along(a, b, &mut self.cells);
        for &cell in &self.cells {
            self.segments.remove(cell, segment.0);
        }
        std::mem::take(&mut self.originals[segment.index()].chain)
    }

    /// Puts a segment into the buckets and heats its ends and its crossings with those that are there.
    fn register(&mut self, a: Point, b: Point, born: &mut Vec<VertexId>) -> SegmentId {
        let segment = self
            .free_segments
            .pop()
            .unwrap_or(SegmentId(self.originals.len() as u32));
        let original = Original {
            a,
            b,
            chain: Chain::default(),
        };
        match self.originals.get_mut(segment.index()) {
            Some(free) => *free = original,
            None => self.originals.push(original),
        }
        self.heat(a, born);
        self.heat(b, born);
        let mut cells = std::mem::take(&mut self.cells);
        let mut crossings = std::mem::take(&mut self.crossings);
        self.segments.cells_along(a, b, &mut cells);
        for &cell in &cells {
            let others = self.segments.add(cell, segment.0);
            for other in self.segments.items_from(others) {
                let (c, d) = self.ends(SegmentId(other));
                if boxes_meet((a, b), (c, d)) && crosses(a, b, c, d) {
                    crossings.push(crossing_pixel(a, b, c, d));
                }
            }
        }
        for p in crossings.drain(..) {
            self.heat(p, born);
        }
        (self.cells, self.crossings) = (cells, crossings);
        segment
    }

    /// Makes the pixel of a grid point hot, if it is not.
    fn heat(&mut self, p: Point, born: &mut Vec<VertexId>) {
        let cell = self.pixels.cell_of(p);
        if self
            .pixels
            .items(cell)
            .any(|v| self.points[v as usize] == p)
        {
            return;
        }
        let v = self
            .free_vertices
            .pop()
            .unwrap_or(VertexId(self.points.len() as u32));
        match self.points.get_mut(v.index()) {
            Some(free) => *free = p,
            None => self.points.push(p),
        }
        born.push(v);
        self.pixels.add(cell, v.0);
    }

    /// Segments in the buckets that meet the pixel of a grid point.
    fn meeting(&self, p: Point) -> impl Iterator<Item = SegmentId> + '_ {
        self.segments
            .items(self.segments.cell_of(p))
            .map(SegmentId)
            .filter(move |&segment| {
                let (a, b) = self.ends(segment);
                meets_pixel(a, b, p)
            })
    }

    /// The vertices on old chains whose pixels no end and no crossing holds any more, ascending.
    fn cooled(&self, removed: &[Reroute]) -> Vec<VertexId> {
        let mut candidates: Vec<VertexId> =
            removed.iter().flat_map(|r| r.old.iter().copied()).collect();
        candidates.sort_unstable();
        candidates.dedup();
        candidates.retain(|&v| !self.has_reason(self.points[v.index()]));
        candidates
    }

    /// Whether an end or a proper crossing of segments lies in the pixel of a grid point.
    fn has_reason(&self, p: Point) -> bool {
        let meeting: Vec<(Point, Point)> =
            self.meeting(p).map(|segment| self.ends(segment)).collect();
        meeting.iter().any(|&(a, b)| a == p || b == p)
            || meeting.iter().enumerate().any(|(i, &(a, b))| {
                meeting[..i]
                    .iter()
                    .any(|&(c, d)| crosses(a, b, c, d) && crossing_pixel(a, b, c, d) == p)
            })
    }

    /// Re-routes the chains of segments that stay, through born pixels and past dead ones.
    fn reroute_survivors(&mut self, diff: &mut Diff) {
        let mut changes: Vec<(SegmentId, VertexId)> = Vec::with_capacity(64);
        for &v in diff.born.iter().chain(&diff.dead) {
            let stays = |&segment: &SegmentId| !self.originals[segment.index()].chain.is_empty();
            changes.extend(
                self.meeting(self.points[v.index()])
                    .filter(stays)
                    .map(|segment| (segment, v)),
            );
        }
        changes.sort_unstable();
        let mut new = std::mem::take(&mut self.chain);
        for change in changes.chunk_by(|x, y| x.0 == y.0) {
            let segment = change[0].0;
            let lives = |v: &VertexId| diff.dead.binary_search(v).is_err();
            let old = &self.originals[segment.index()].chain;
            let joins = change.iter().map(|&(_, v)| v);
            new.clear();
            new.extend(old.iter().copied().chain(joins).filter(lives));
            self.sort_along(segment, &mut new);
            let (old, changed) = differing(old, &new);
            self.originals[segment.index()].chain = Chain::from(new.as_slice());
            diff.rerouted.push(Reroute {
                segment,
                old,
                new: changed,
            });
        }
        self.chain = new;
    }

    /// Forgets pixels that cooled down.
    fn bury(&mut self, dead: &[VertexId]) {
        for &v in dead {
            let p = self.points[v.index()];
            self.pixels.remove(self.pixels.cell_of(p), v.0);
            self.free_vertices.push(v);
        }
    }

    /// The hot pixels that a segment meets, from end to end.
    fn find_chain(&mut self, segment: SegmentId) -> Chain {
        let (a, b) = self.ends(segment);
        let mut chain = std::mem::take(&mut self.chain);
        chain.clear();
        self.pixels.cells_along(a, b, &mut self.cells);
        for &cell in &self.cells {
            chain.extend(
                self.pixels
                    .items(cell)
                    .map(VertexId)
                    .filter(|&v| meets_pixel(a, b, self.points[v.index()])),
            );
        }
        self.sort_along(segment, &mut chain);
        let found = Chain::from(chain.as_slice());
        self.chain = chain;
        found
    }

    /// Sorts pixels that a segment meets in its direction. Rounding is monotone, so both coordinates are.
    fn sort_along(&self, segment: SegmentId, chain: &mut [VertexId]) {
        let (a, b) = self.ends(segment);
        let (x, y) = (
            i64::from((b.x - a.x).signum()),
            i64::from((b.y - a.y).signum()),
        );
        chain.sort_unstable_by_key(|&v| {
            let p = self.points[v.index()];
            x * i64::from(p.x) + y * i64::from(p.y)
        });
    }
}

/// Whether the bounding boxes of two segments meet.
fn boxes_meet((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    a.x.min(b.x) <= c.x.max(d.x)
        && c.x.min(d.x) <= a.x.max(b.x)
        && a.y.min(b.y) <= c.y.max(d.y)
        && c.y.min(d.y) <= a.y.max(b.y)
}

/// Two chains with the same ends, without their common beginning and end but for one vertex of each.
fn differing(old: &[VertexId], new: &[VertexId]) -> (Chain, Chain) {
    let head = old.iter().zip(new).take_while(|(v, w)| v == w).count();
    let shorter = old.len().min(new.len()) - head;
    let tail = old
        .iter()
        .rev()
        .zip(new.iter().rev())
        .take(shorter)
        .take_while(|(v, w)| v == w)
        .count();
    let cut = |chain: &[VertexId]| {
        Chain::from(&chain[head.saturating_sub(1)..chain.len() - tail.saturating_sub(1)])
    };
    (cut(old), cut(new))
}
