//! Provenance of edges: which feature edges run along each mesh edge, with direction and multiplicity.
//!
//! Lists are linked through one slab, sorted by feature, source and ends: their order is a property of
//! the set of features and not of how the mesh came about.

use super::topology::{NONE, Quarter};
use super::{FeatureId, Segment, SegmentId, Use};

/// Lists of uses by edge record.
#[derive(Clone, Debug, Default)]
pub struct Uses {
    /// By edge record; edges beyond the end have no uses.
    edges: Vec<EdgeUses>,
    links: Vec<Link>,
    free: Vec<u32>,
    /// Those that are to be put into long lists, when all are there.
    late: Vec<Late>,
}

/// A use that is not in its edge's list yet.
#[derive(Clone, Copy, Debug)]
struct Late {
    edge: Quarter,
    segment: SegmentId,
    owner: Owner,
}

/// Who would have to pass so many others to his place in a list waits until all can be put into theirs in one go.
const FAR: usize = 12;

#[derive(Clone, Copy, Debug)]
struct EdgeUses {
    /// First link of the edge's list.
    head: u32,
    /// Whether the front of a one-way lies left of the quarter-edge with r = 0, and of that with r = 2. Bodies ask at every
    /// edge that they cross.
    fronts: [bool; 2],
}

/// What a segment is part of, as far as those ask who cross it.
#[derive(Clone, Copy, Debug)]
pub struct Owner {
    /// The feature.
    pub feature: FeatureId,
    /// Whether its edges have fronts.
    pub has_fronts: bool,
    /// Whether it covers what it winds around, so that crossing the segment changes the cover.
    pub winds: bool,
}

#[derive(Clone, Copy, Debug)]
struct Link {
    segment: SegmentId,
    owner: Owner,
    /// Direction relative to the quarter-edge with r = 0.
    forward: bool,
    next: u32,
}

impl Uses {
    fn head(&self, e: Quarter) -> u32 {
        self.edges.get((e >> 2) as usize).map_or(NONE, |e| e.head)
    }

    /// Whether nothing runs along an edge.
    pub fn is_empty(&self, e: Quarter) -> bool {
        self.head(e) == NONE
    }

    /// Whether the front of a one-way lies left of an edge: it runs the other way.
    #[inline]
    pub fn has_front(&self, e: Quarter) -> bool {
        let edge = self.edges.get((e >> 2) as usize);
        edge.is_some_and(|edge| edge.fronts[usize::from(e & 2 != 0)])
    }

    /// The uses of an edge, by feature, source and ends, with directions relative to `e`.
    pub fn of(&self, e: Quarter) -> impl Iterator<Item = Use> + '_ {
        let along = e & 2 == 0;
        self.links(e).map(move |link| Use {
            segment: link.segment,
            forward: link.forward == along,
        })
    }

    /// By how much more the features that run along an edge wind around its left than around its right: one entry for each
    /// use by a feature that winds at all.
    pub fn gains(&self, e: Quarter) -> impl Iterator<Item = (FeatureId, i32)> + '_ {
        let along = e & 2 == 0;
        let winding = self.links(e).filter(|link| link.owner.winds);
        winding.map(move |link| {
            let gain = if link.forward == along { 1 } else { -1 };
            (link.owner.feature, gain)
        })
    }

    fn links(&self, e: Quarter) -> impl Iterator<Item = &Link> + '_ {
        let mut at = self.head(e);
        std::iter::from_fn(move || {
            let link = self.links.get(at as usize)?;
            at = link.next;
            Some(link)
        })
    }

    /// Makes room for so many more edges, and for so many more uses of them.
    pub fn reserve(&mut self, edges: usize, uses: usize) {
        self.edges.reserve(edges);
        self.links.reserve(uses);
    }

    /// Adds a use of an edge by a segment that runs in the direction of `e`. When all are added call [`Uses::settle`].
    pub fn add(&mut self, e: Quarter, segment: SegmentId, owner: Owner, segments: &[Segment]) {
        if self.edges.len() <= (e >> 2) as usize {
            let unused = EdgeUses {
                head: NONE,
                fronts: [false; 2],
            };
            self.edges.resize((e >> 2) as usize + 1, unused);
        }
        let rank = |s: SegmentId| segments[s.index()].rank();
        let (mut before, mut at, mut passed) = (NONE, self.head(e), 0);
        while at != NONE && rank(self.links[at as usize].segment) < rank(segment) {
            (before, at) = (at, self.links[at as usize].next);
            passed += 1;
            if passed == FAR {
                return self.late.push(Late {
                    edge: e,
                    segment,
                    owner,
                });
            }
        }
        self.link(e, before, segment, owner);
    }

    /// Puts all that were added into their lists.
    pub fn settle(&mut self, segments: &[Segment]) {
        let mut late = std::mem::take(&mut self.late);
        let rank = |s: SegmentId| segments[s.index()].rank();
        late.sort_unstable_by_key(|l| (l.edge >> 2, rank(l.segment)));
        for group in late.chunk_by(|l, m| l.edge >> 2 == m.edge >> 2) {
            let (mut before, mut at) = (NONE, self.head(group[0].edge));
            for new in group {
                while at != NONE && rank(self.links[at as usize].segment) < rank(new.segment) {
                    (before, at) = (at, self.links[at as usize].next);
                }
                before = self.link(new.edge, before, new.segment, new.owner);
            }
        }
        late.clear();
        self.late = late;
    }

    /// Puts a use into the list of `e` behind the link `before`, or first; returns its link.
    fn link(&mut self, e: Quarter, before: u32, segment: SegmentId, owner: Owner) -> u32 {
        let next = match self.links.get(before as usize) {
            Some(link) => link.next,
            None => self.head(e),
        };
        let link = Link {
            segment,
            owner,
            forward: e & 2 == 0,
            next,
        };
        let new = match self.free.pop() {
            Some(free) => {
                self.links[free as usize] = link;
                free
            }
            None => {
                self.links.push(link);
                self.links.len() as u32 - 1
            }
        };
        self.set_next(e, before, new);
        self.edges[(e >> 2) as usize].fronts[usize::from(link.forward)] |= owner.has_fronts;
        new
    }

    /// Removes the use of an edge by a segment, which must be there.
    pub fn remove(&mut self, e: Quarter, segment: SegmentId) {
        let (mut before, mut at) = (NONE, self.head(e));
        while self.links[at as usize].segment != segment {
            (before, at) = (at, self.links[at as usize].next);
        }
        self.set_next(e, before, self.links[at as usize].next);
        self.free.push(at);
        self.note_fronts(e);
    }

    /// Brings the fronts of an edge up to date with its list.
    fn note_fronts(&mut self, e: Quarter) {
        let mut fronts = [false; 2];
        let mut at = self.head(e);
        while let Some(link) = self.links.get(at as usize) {
            fronts[usize::from(link.forward)] |= link.owner.has_fronts;
            at = link.next;
        }
        self.edges[(e >> 2) as usize].fronts = fronts;
    }

    /// Lets the list of `e` go on with `next` after the link `before`, or start with it.
    fn set_next(&mut self, e: Quarter, before: u32, next: u32) {
        match self.links.get_mut(before as usize) {
            Some(link) => link.next = next,
            None => self.edges[(e >> 2) as usize].head = next,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::{Aside, Point, Source};

    #[test]
    fn uses_are_listed_by_feature_whatever_the_order_of_arrival() {
        let (a, b) = (Point::new(0, 0), Point::new(1, 0));
        let source = Source::Edge { edge: 0 };
        let segment = |feature| Segment {
            a,
            b,
            feature,
            source,
            aside: Aside::default(),
        };
        let segments = [7, 3, 5].map(segment);
        let ids = |uses: &Uses, e| {
            uses.of(e)
                .map(|u| (u.segment.0, u.forward))
                .collect::<Vec<_>>()
        };
        for order in [[0, 1, 2], [2, 1, 0], [1, 0, 2]] {
            let mut uses = Uses::default();
            for s in order {
                // The one of feature 3 runs against the others.
                let owner = Owner {
                    feature: segments[s as usize].feature,
                    has_fronts: s == 1,
                    winds: s != 1,
                };
                uses.add(if s == 1 { 10 } else { 8 }, SegmentId(s), owner, &segments);
            }
            uses.settle(&segments);
            assert_eq!(ids(&uses, 8), [(1, false), (2, true), (0, true)]);
            assert_eq!(ids(&uses, 10), [(1, true), (2, false), (0, false)]);
            // And it is a one-way: its front is on its right.
            assert!(uses.has_front(8) && !uses.has_front(10));
            // It does not wind, and the others do.
            assert_eq!(uses.gains(8).collect::<Vec<_>>(), [(5, 1), (7, 1)]);
            assert_eq!(uses.gains(10).collect::<Vec<_>>(), [(5, -1), (7, -1)]);
            uses.remove(8, SegmentId(2));
            assert_eq!(ids(&uses, 8), [(1, false), (0, true)]);
            uses.remove(8, SegmentId(1));
            uses.remove(10, SegmentId(0));
            assert!(uses.is_empty(8) && uses.is_empty(400));
            assert!(!uses.has_front(8) && !uses.has_front(400));
        }
    }

    #[test]
    fn long_lists_are_in_order_too() {
        let count = 40 * FAR as u32;
        let (a, b) = (Point::new(0, 0), Point::new(1, 0));
        let segment = |feature| Segment {
            a,
            b,
            feature,
            source: Source::Edge { edge: 0 },
            aside: Aside::default(),
        };
        let segments: Vec<Segment> = (0..count).map(segment).collect();
        for stride in [1, 7, 11, count - 1] {
            let mut uses = Uses::default();
            for i in 0..count {
                let s = i * stride % count;
                let owner = Owner {
                    feature: s,
                    has_fronts: s == count - 1,
                    winds: true,
                };
                uses.add(8 + 2 * (s % 2), SegmentId(s), owner, &segments);
                if i == count / 2 {
                    uses.settle(&segments);
                }
            }
            uses.settle(&segments);
            let all = uses.of(8).map(|u| (u.segment.0, u.forward));
            let expected = (0..count).map(|s| (s, s % 2 == 0));
            assert_eq!(all.collect::<Vec<_>>(), expected.collect::<Vec<_>>());
            assert!(uses.has_front(8) && !uses.has_front(10));
        }
    }
}
