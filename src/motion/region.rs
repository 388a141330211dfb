//! Regions: a body is in those that cover the free face of its place, in the level and in the frame of every moving solid: a body
//! at rest too, which a region moves over. Coming and going are events at the very time at which the place changes: where a flight
//! crosses an edge, in whatever frame, a walker passes a vertex, a size or a side is changed.
//!
//! Regions cut edges of the mesh into pieces, and that is all that they do to it: they stop nobody, and no piece of the
//! motion gets a new base. What a ladder does is in [`super::ladder`].

use super::body::{Body, EventKind, Trace};
use super::terrain::{Region, Terrain};
use crate::mesh::FeatureId;

impl Body {
    /// The regions that the body is in, ascending: those features whose traits make them one. Where it is put at the start
    /// it is without an event.
    pub fn regions(&self) -> &[FeatureId] {
        &self.regions
    }

    /// Tells which regions the body has come out of and into. True if there are any.
    pub(super) fn note_regions(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        if self.regions_move {
            return self.note_all_regions(terrain, trace);
        }
        let level = terrain.mesh(self.size);
        let cover = level.cover(self.level_face(level));
        if cover.is_empty() && self.regions.is_empty() {
            return false;
        }
        let is_region = |f: &FeatureId| terrain.traits_of(*f).region != Region::None;
        let now = || cover.iter().copied().filter(is_region);
        if now().eq(self.regions.iter().copied()) {
            return false;
        }
        let now = now().collect();
        self.tell_regions(now, trace);
        true
    }

    /// The same in all frames.
    fn note_all_regions(&mut self, terrain: &Terrain, trace: &mut Trace) -> bool {
        let now = self.regions_around(terrain);
        let news = now != self.regions;
        if news {
            self.tell_regions(now, trace);
        }
        news
    }

    /// The regions that cover the place of the body in any frame, ascending.
    pub(super) fn regions_around(&self, terrain: &Terrain) -> Vec<FeatureId> {
        let mine = terrain.ground_under(self.carrier(), self.size).mesh;
        let others = self.beside.iter().map(|b| {
            let mesh = terrain.ground_under(b.mover(), self.size).mesh;
            mesh.cover(b.flight.face)
        });
        let covers = others.chain([mine.cover(self.face(mine))]);
        let is_region = |f: &FeatureId| terrain.traits_of(*f).region != Region::None;
        let mut around: Vec<_> = covers.flatten().copied().filter(is_region).collect();
        around.sort_unstable();
        around
    }

    fn tell_regions(&mut self, now: Vec<FeatureId>, trace: &mut Trace) {
        let before = std::mem::replace(&mut self.regions, now);
        for &left in before.iter().filter(|f| !self.regions.contains(f)) {
            self.log(EventKind::Exited(left), trace);
        }
        for &new in self.regions.iter().filter(|f| !before.contains(f)) {
            self.log(EventKind::Entered(new), trace);
        }
    }

    /// After a change of the place that is no event of the motion, unless a ladder makes it one.
    pub(super) fn come_to_place(&mut self, terrain: &Terrain, trace: &mut Trace) {
        // Who was set down or corrected is at another place in every other frame too.
        if self.frame.is_some() || self.regions_move {
            self.follow(terrain);
        }
        let news = self.note_regions(terrain, trace);
        // Who has taken hold in one size may have changed to another, of which no ladder is in reach.
        if (news || self.climbing) && self.minds_ladder(terrain) {
            self.rebase();
            self.refresh(terrain, trace);
        } else {
            self.schedule(terrain);
        }
    }
}
