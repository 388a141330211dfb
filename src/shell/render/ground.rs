//! Where the ground is below the hero: for the shadow right under him, which tells where he will land.

use crate::game::Stage;
use crate::level::Kind;
use glam::Vec2;

/// Least height of an edge's unit normal that a shadow falls on.
const FACES_UP: f32 = 0.3;
/// A foot on the ground may be this much below it by rounding, in metres.
const SLACK: f32 = 0.05;

/// The upper edges of everything solid that stands still, from left to right each.
#[derive(Default)]
pub struct Ground(Vec<(Vec2, Vec2)>);

impl Ground {
    /// The ground of a stage.
    pub fn of(stage: &Stage) -> Ground {
        let mut edges = Vec::new();
        for feature in &stage.level.features {
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
        Ground(edges)
    }

    /// The height of the ground below a point; nothing if there is none.
    pub fn below(&self, p: Vec2) -> Option<f32> {
        let heights = self.0.iter().filter(|(a, b)| (a.x..=b.x).contains(&p.x));
        let heights = heights.map(|(a, b)| a.y + (b.y - a.y) * (p.x - a.x) / (b.x - a.x));
        heights.filter(|&y| y <= p.y + SLACK).max_by(f32::total_cmp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_edge_below_is_the_ground() {
        let edge = |y: f32| (Vec2::new(0.0, y), Vec2::new(4.0, y + 2.0));
        let ground = Ground(vec![edge(-5.0), edge(0.0), edge(7.0)]);
        assert_eq!(ground.below(Vec2::new(2.0, 3.0)), Some(1.0));
        assert_eq!(ground.below(Vec2::new(2.0, 0.98)), Some(1.0));
        assert_eq!(ground.below(Vec2::new(2.0, 0.5)), Some(-4.0));
        assert_eq!(ground.below(Vec2::new(5.0, 3.0)), None);
    }
}
