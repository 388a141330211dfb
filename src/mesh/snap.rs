//! The arrangement of all feature edges, snapped to the grid: which grid points are vertices, and through which
//! of them each segment runs.
//!
//! *Snap rounding* (Hobby 1999; the dynamic version Guibas and Marimont 1998): a pixel is *hot* while it holds
//! an end or a proper crossing of original segments; a segment becomes the chain of the hot pixels
//! that it meets. Chains stay within half a step per axis of their segments, are monotone along them and never
//! cross one another, and all of it is a function of the *set* of segments: every decision tests
//! originals, never pieces. An edit is a batch: it reports the pixels that heat up or cool down, and each
//! segment whose chain changes because of that.

use super::buckets::{Buckets, Slot};
use super::limit::{MOST_CROSSINGS, MOST_PIECES, MOST_VERTICES, Stop};
use super::progress::{Part, Phase};
use super::short::Short;
use super::{SegmentId, VertexId};
use crate::geom::Point;
use crate::geom::predicates::{crosses, crossing_pixel, meets_pixel};

/// The vertices of a chain; most chains have few.
pub type Chain = Short<VertexId, 6>;

/// About so many cells a segment has.
const CELLS: usize = 4;

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
    /// Ends of each original segment; those of unused ids mean nothing.
    ends: Vec<(Point, Point)>,
    /// The hot pixels that each meets, from its start to its end; none of unused ids.
    chains: Vec<Chain>,
    free_segments: Vec<SegmentId>,
    free_vertices: Vec<VertexId>,
    buckets: Buckets,
    /// Scratch: crossings of a segment with others.
    crossings: Vec<Point>,
    /// Scratch: a chain.
    chain: Vec<VertexId>,
    /// Scratch: cells along a segment.
    leaves: Vec<Slot>,
    /// Scratch: segments in the cells of another.
    met: Vec<u32>,
    /// How many segments have been registered.
    registered: u64,
    /// By segment which of them it was tested against last: what meets in many cells is tested once.
    tested: Vec<u64>,
}

impl Arrangement {
    /// An arrangement of no segments, with some vertex ids reserved for points that are never hot.
    ///
    /// `shift` is the binary logarithm of the cell size in steps: about the usual length of a segment is best.
    pub fn new(shift: u32, reserved: &[Point]) -> Self {
        Arrangement {
            ends: Vec::new(),
            chains: Vec::new(),
            free_segments: Vec::new(),
            free_vertices: Vec::new(),
            buckets: Buckets::new(shift, reserved),
            crossings: Vec::new(),
            chain: Vec::new(),
            leaves: Vec::new(),
            met: Vec::new(),
            registered: 0,
            tested: Vec::new(),
        }
    }

    /// The point of a vertex; that of an unused id means nothing.
    #[inline]
    pub fn point(&self, v: VertexId) -> Point {
        self.buckets.point(v)
    }

    /// The chain of a segment.
    pub fn chain(&self, segment: SegmentId) -> &[VertexId] {
        &self.chains[segment.index()]
    }

    /// The hot pixels near a grid point, in no particular order; there may be others that are as near.
    pub fn near(&self, p: Point) -> impl Iterator<Item = VertexId> + '_ {
        self.buckets.pixels_around(p)
    }

    /// Ends of a segment.
    pub fn ends(&self, segment: SegmentId) -> (Point, Point) {
        self.ends[segment.index()]
    }

    /// Adds segments (each of some length) and removes others. Returns what changes.
    ///
    /// The ids of removed segments and dead vertices may be given away by the next edit.
    ///
    /// # Errors
    /// Nobody waits for it any more, or it is too much and there is a bound; then all of it is to be thrown away.
    pub fn edit(
        &mut self,
        add: &[(Point, Point)],
        remove: &[SegmentId],
        bounded: bool,
        part: Part,
    ) -> Result<Diff, Stop> {
        let mut diff = Diff::default();
        for &segment in remove {
            let (old, new) = (self.unregister(segment), Chain::default());
            diff.rerouted.push(Reroute { segment, old, new });
        }
        let survivors = self.ends.len() > self.free_segments.len() + remove.len();
        self.ends.reserve(add.len());
        self.chains.reserve(add.len());
        // The slots of each, up to an index.
        let mut slots = Vec::with_capacity(CELLS * add.len());
        let mut spans = Vec::with_capacity(add.len());
        for &(a, b) in add {
            self.buckets.slots_along(a, b, &mut slots);
            spans.push(slots.len());
        }
        self.buckets.reserve(slots.len());
        let starts = std::iter::once(0).chain(spans.iter().copied());
        let spans = starts.zip(&spans).map(|(from, &to)| &slots[from..to]);
        let crossing = part.between(0.0, 0.6);
        crossing.begin(Phase::Crossing)?;
        let mut crossings = 0;
        for (&(a, b), slots) in add.iter().zip(spans.clone()) {
            let segment = self.register(a, b, slots, &mut diff.born, &mut crossings);
            diff.added.push(segment);
            crossing.done(diff.added.len(), add.len())?;
            if bounded && (diff.born.len() > MOST_VERTICES || crossings > MOST_CROSSINGS) {
                return Err(Stop::TooMuch);
            }
        }
        diff.dead = self.cooled(&diff.rerouted);
        if survivors {
            self.reroute_survivors(&mut diff);
        }
        for &v in &diff.dead {
            self.buckets.cool(v);
            self.free_vertices.push(v);
        }
        let snapping = part.between(0.6, 1.0);
        snapping.begin(Phase::Snapping)?;
        let mut pieces = 0;
        for (i, (&segment, slots)) in diff.added.iter().zip(spans).enumerate() {
            let chain = self.find_chain(segment, slots);
            pieces += chain.len();
            self.chains[segment.index()] = chain;
            snapping.done(i, add.len())?;
            if bounded && pieces > MOST_PIECES {
                return Err(Stop::TooMuch);
            }
        }
        self.free_segments.extend(remove.iter().rev());
        Ok(diff)
    }

    /// Takes a segment out of the buckets; returns its chain.
    fn unregister(&mut self, segment: SegmentId) -> Chain {
        let (a, b) = self.ends(segment);
        self.buckets.remove_segment(a, b, segment.0);
        std::mem::take(&mut self.chains[segment.index()])
    }

    /// Puts a segment into its cells and heats its ends and its crossings with those that are there, which are counted.
    fn register(
        &mut self,
        a: Point,
        b: Point,
        slots: &[Slot],
        born: &mut Vec<VertexId>,
        count: &mut usize,
    ) -> SegmentId {
        let segment = match self.free_segments.pop() {
            Some(free) => {
                self.ends[free.index()] = (a, b);
                free
            }
            None => {
                self.ends.push((a, b));
                self.chains.push(Chain::default());
                SegmentId(self.ends.len() as u32 - 1)
            }
        };
        self.heat(a, born);
        self.heat(b, born);
        self.registered += 1;
        self.tested.resize(self.ends.len(), 0);
        let mut crossings = std::mem::take(&mut self.crossings);
        let mut met = std::mem::take(&mut self.met);
        for &slot in slots {
            self.buckets.meet(slot, (a, b), segment.0, &mut met);
            for other in met.drain(..) {
                let tested = &mut self.tested[other as usize];
                if std::mem::replace(tested, self.registered) == self.registered {
                    continue;
                }
                let (c, d) = self.ends[other as usize];
                if boxes_meet((a, b), (c, d)) && crosses(a, b, c, d) {
                    crossings.push(crossing_pixel(a, b, c, d));
                }
            }
        }
        *count += crossings.len();
        // Many may lie in the same pixel.
        crossings.sort_unstable();
        crossings.dedup();
        for p in crossings.drain(..) {
            self.heat(p, born);
        }
        self.crossings = crossings;
        self.met = met;
        segment
    }

    /// The cells without cells of their own in the cells of a segment.
    fn leaves(&mut self, (a, b): (Point, Point), slots: &[Slot]) -> Vec<Slot> {
        let mut leaves = std::mem::take(&mut self.leaves);
        leaves.clear();
        for &slot in slots {
            self.buckets.leaves_along(slot, a, b, &mut leaves);
        }
        leaves
    }

    /// Makes the pixel of a grid point hot, if it is not.
    fn heat(&mut self, p: Point, born: &mut Vec<VertexId>) {
        let free = &mut self.free_vertices;
        let name = |buckets: &Buckets| {
            let next = VertexId(buckets.vertex_count() as u32);
            free.pop().unwrap_or(next)
        };
        born.extend(self.buckets.heat(p, name, &self.ends));
    }

    /// Segments in the buckets that meet the pixel of a grid point.
    fn meeting(&self, p: Point) -> impl Iterator<Item = SegmentId> + '_ {
        let near = self.buckets.segments_at(p).map(SegmentId);
        near.filter(move |&segment| {
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
        candidates.retain(|&v| !self.has_reason(self.point(v)));
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
            let stays = |&segment: &SegmentId| !self.chain(segment).is_empty();
            changes.extend(
                self.meeting(self.point(v))
                    .filter(stays)
                    .map(|segment| (segment, v)),
            );
        }
        changes.sort_unstable();
        let mut new = std::mem::take(&mut self.chain);
        for change in changes.chunk_by(|x, y| x.0 == y.0) {
            let segment = change[0].0;
            let lives = |v: &VertexId| diff.dead.binary_search(v).is_err();
            let old = self.chain(segment);
            let joins = change.iter().map(|&(_, v)| v);
            new.clear();
            new.extend(old.iter().copied().chain(joins).filter(lives));
            self.sort_along(segment, &mut new);
            let (old, changed) = differing(old, &new);
            self.chains[segment.index()] = Chain::from(new.as_slice());
            diff.rerouted.push(Reroute {
                segment,
                old,
                new: changed,
            });
        }
        self.chain = new;
    }

    /// The hot pixels that a segment meets, from end to end.
    fn find_chain(&mut self, segment: SegmentId, slots: &[Slot]) -> Chain {
        let (a, b) = self.ends(segment);
        let mut chain = std::mem::take(&mut self.chain);
        chain.clear();
        let leaves = self.leaves((a, b), slots);
        for &slot in &leaves {
            let near = self.buckets.pixels(slot);
            let met = near.filter(|pixel| meets_pixel(a, b, pixel.1));
            chain.extend(met.map(|pixel| pixel.0));
        }
        self.sort_along(segment, &mut chain);
        let found = Chain::from(chain.as_slice());
        self.chain = chain;
        self.leaves = leaves;
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
            let p = self.point(v);
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
