//! Where the ground is below the hero: for the shadow right under him, which tells where he will land.

use crate::game::Stage;
use crate::level::{Feature, Kind};
use glam::{DVec2, Vec2};

/// Least height of an edge's unit normal that a shadow falls on.
const FACES_UP: f32 = 0.3;
/// A foot on the ground may be this much below it by rounding, in metres.
const SLACK: f32 = 0.05;

/// Edges from left to right.
type Edges = Vec<(Vec2, Vec2)>;

/// The upper edges of everything that holds.
#[derive(Default)]
pub struct Ground {
    /// Of what stands still.
    still: Edges,
    /// Of each mover, where it was drawn.
    moving: Vec<Edges>,
}

impl Ground {
    /// The ground of a stage.
    pub fn of(stage: &Stage) -> Ground {
        let movers = stage.level.movers.iter();
        Ground {
            still: upper_edges(&stage.level.features),
            moving: movers.map(|mover| upper_edges(&mover.features)).collect(),
        }
    }

    /// The height of the ground below a point, with the movers so far from where they were drawn; nothing if there is none.
    pub fn below(&self, p: Vec2, offsets: &[DVec2]) -> Option<f32> {
        let moving = self.moving.iter().zip(offsets);
        let moving = moving.filter_map(|(edges, offset)| {
            let offset = offset.as_vec2();
            highest(edges, p - offset).map(|height| height + offset.y)
        });
        moving.chain(highest(&self.still, p)).reduce(f32::max)
    }
}

/// The edges of some features that a shadow falls on.
fn upper_edges(features: &[Feature]) -> Edges {
    let mut edges = Vec::new();
    for feature in features {
        let corners: Vec<Vec2> = feature.outline.iter().map(|p| p.as_vec2()).collect();
        let n = corners.len();
        let pairs = (0..n).map(|i| (corners[i], corners[(i + 1) % n]));
        let area: f32 = pairs.clone().map(|(a, b)| a.perp_dot(b)).sum();
        match feature.kind {
            Kind::Solid if area < 0.0 => edges.extend(pairs),
            Kind::Solid => edges.extend(pairs.map(|(a, b)| (b, a))),
            Kind::OneWay => edges.extend(corners.windows(2).map(|pair| (pair[0], pair[1]))),
            _ => {}
        }
    }
    edges.retain(|(a, b)| (*b - *a).normalize_or_zero().x > FACES_UP);
    edges
}

/// The height of the highest of some edges below a point.
fn highest(edges: &Edges, p: Vec2) -> Option<f32> {
    let heights = edges.iter().filter(|(a, b)| (a.x..=b.x).contains(&p.x));
    let heights = heights.map(|(a, b)| a.y + (b.y - a.y) * (p.x - a.x) / (b.x - a.x));
    heights.filter(|&y| y <= p.y + SLACK).max_by(f32::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(y: f32) -> (Vec2, Vec2) {
        (Vec2::new(0.0, y), Vec2::new(4.0, y + 2.0))
    }

    #[test]
    fn the_nearest_edge_below_is_the_ground() {
        let ground = Ground {
            still: vec![edge(-5.0), edge(0.0), edge(7.0)],
            moving: Vec::new(),
        };
        let below = |x: f32, y: f32| ground.below(Vec2::new(x, y), &[]);
        assert_eq!(below(2.0, 3.0), Some(1.0));
        assert_eq!(below(2.0, 0.98), Some(1.0));
        assert_eq!(below(2.0, 0.5), Some(-4.0));
        assert_eq!(below(5.0, 3.0), None);
    }

    #[test]
    fn a_shadow_falls_on_movers_where_they_are() {
        let ground = Ground {
            still: vec![edge(-5.0)],
            moving: vec![vec![edge(0.0)], vec![edge(20.0)]],
        };
        let below =
            |x: f32, y: f32, offset: DVec2| ground.below(Vec2::new(x, y), &[offset, DVec2::ZERO]);
        assert_eq!(below(2.0, 9.0, DVec2::ZERO), Some(1.0));
        assert_eq!(below(2.0, 9.0, DVec2::new(0.0, 3.5)), Some(4.5));
        assert_eq!(
            below(2.0, 9.0, DVec2::new(30.0, 0.0)),
            Some(-4.0),
            "it is elsewhere"
        );
        assert_eq!(below(32.0, 9.0, DVec2::new(30.0, 0.0)), Some(1.0));
        assert_eq!(below(2.0, 0.5, DVec2::ZERO), Some(-4.0), "it is above");
    }
}
