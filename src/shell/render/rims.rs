//! The rims of solids: where their fronts bend down to the outlines, and which way the open lies.

use super::facets::{Facets, next};
use super::terrain::rim;
use glam::DVec2;

/// How far beside its place a vertex within may be put, as a share of its distance from the border.
const ASIDE: f64 = 0.1;

/// What is known of the vertices at which free space begins, by vertex.
pub(super) struct Rims {
    /// Unit vector into the open: the mean of the borders' normals; zero within the solid.
    outward: Vec<DVec2>,
    /// How much sky a vertex sees: 1 on flat ground, less in corners.
    open: Vec<f32>,
    /// The normals, into the open, of the border that comes to a vertex and of the one that leaves it.
    sides: Vec<[DVec2; 2]>,
}

impl Rims {
    pub(super) fn of(facets: &Facets) -> Rims {
        let mut rims = Rims {
            outward: vec![DVec2::ZERO; facets.points.len()],
            open: vec![1.0; facets.points.len()],
            sides: vec![[DVec2::ZERO; 2]; facets.points.len()],
        };
        let mut arriving = vec![DVec2::ZERO; facets.points.len()];
        let borders = || (0..facets.origin.len()).filter(|&e| facets.is_border(e));
        let along = |e: usize| (facets.ends(e).1 - facets.ends(e).0).normalize_or_zero();
        for e in borders() {
            for v in [facets.origin[e], facets.origin[next(e)]] {
                rims.outward[v] -= along(e).perp();
            }
            arriving[facets.origin[next(e)]] = along(e);
        }
        for e in borders() {
            let v = facets.origin[e];
            rims.outward[v] = rims.outward[v].normalize_or_zero();
            rims.sides[v] = [-arriving[v].perp(), -along(e).perp()];
            // A turn to the right is a corner of the room: the solid is on the left.
            let turn = -arriving[v].perp_dot(along(e)) as f32;
            rims.open[v] = 1.0 - 0.6 * turn.clamp(0.0, 1.0);
        }
        rims
    }

    /// Into the open at a vertex; zero within the solid, also for vertices that were added later.
    pub(super) fn outward(&self, v: usize) -> DVec2 {
        self.outward.get(v).copied().unwrap_or_default()
    }

    /// How far a position lies within the solid, from both borders at a vertex; 0 for vertices within it.
    pub(super) fn inward(&self, v: usize, from: DVec2, p: DVec2) -> f64 {
        let sides = self.sides.get(v).copied().unwrap_or_default();
        let [a, b] = sides.map(|normal| normal.dot(from - p));
        a.min(b)
    }

    /// How much sky a vertex sees.
    pub(super) fn open(&self, v: usize) -> f32 {
        self.open.get(v).copied().unwrap_or(1.0)
    }

    /// Adds the vertices at which the front bends down to the rim: one inside of each border vertex.
    pub(super) fn bend(&self, facets: &mut Facets) {
        let starts: Vec<usize> = (0..facets.origin.len())
            .filter(|&e| facets.is_border(e))
            .collect();
        let spots: Vec<(usize, f64, f64)> = starts
            .iter()
            .map(|&e| {
                (
                    facets.origin[e],
                    self.mitre(facets, e),
                    rim(facets.look[e / 3]),
                )
            })
            .collect();
        for (v, mitre, width) in spots {
            let inward = self.outward[v] * -width * mitre;
            // Beside it, where it would lie on an edge: rooms of right angles are full of those.
            let spots = [0.0, ASIDE, -ASIDE].map(|aside| inward + inward.perp() * aside);
            let from = facets.points[v];
            spots
                .into_iter()
                .find_map(|spot| facets.insert(v, from + spot, width * 0.6));
        }
    }

    /// How much further than the rim's width its inner line lies from the corner at which border `e` starts.
    fn mitre(&self, facets: &Facets, e: usize) -> f64 {
        let (a, b) = facets.ends(e);
        let normal = -(b - a).normalize_or_zero().perp();
        1.0 / normal.dot(self.outward[facets.origin[e]]).max(0.5)
    }
}
