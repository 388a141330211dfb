//! The pieces of a level: terrain, and regions that stop nobody.

use crate::geom::drawn::length;
use crate::geom::{Collider, Drawn, ExpandedEdge, Point, expand_drawn, expand_one_way_drawn};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// A piece of a level: a simple closed outline, counter-clockwise or clockwise, or (a one-way platform) an open line.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Feature {
    /// Unique name.
    pub id: String,
    /// What it is made of: how it looks and sounds.
    #[serde(default)]
    pub material: Material,
    /// What it does to bodies.
    #[serde(default, skip_serializing_if = "is_default")]
    pub kind: Kind,
    /// Corners in metres; the last one is joined to the first unless the feature is one-way.
    pub outline: Vec<DVec2>,
    /// Its walls can be held on to and climbed. Solids only.
    #[serde(default, skip_serializing_if = "is_default")]
    pub climbable: bool,
    /// Speed of its walkable ground towards growing x, in m/s. Terrain only.
    #[serde(default, skip_serializing_if = "is_default")]
    pub conveyor: f64,
    /// Its coefficient of friction, instead of the tuned one. Terrain only.
    #[serde(default, skip_serializing_if = "is_default")]
    pub friction: Option<f64>,
    /// What its bends towards a walker do to the speed, instead of the tuned choice. Terrain only.
    #[serde(default, skip_serializing_if = "is_default")]
    pub concave: Option<Concave>,
    /// What of a body must be in the region; by default the whole body counts, on a ladder its middle. Regions only.
    #[serde(default, skip_serializing_if = "is_default")]
    pub by: Option<By>,
    /// Where the hero's foot is put when he comes back, in metres. Checkpoints only, and needed there.
    #[serde(default, skip_serializing_if = "is_default")]
    pub respawn: Option<DVec2>,
}

/// What a feature does to bodies. The first two are terrain, the others regions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Kind {
    /// Stops them from all sides.
    #[default]
    Solid,
    /// A line that stops who comes from its front: the upper side, where it is drawn from left to right.
    OneWay,
    /// Can be climbed.
    Ladder,
    /// Kills the hero.
    Hazard,
    /// Where the hero comes back after a death.
    Checkpoint,
    /// Ends the level, as its goal box does.
    Goal,
    /// Starts movers, and calls them.
    Trigger,
    /// A hidden place: whoever finds it is told so, once.
    Secret,
}

impl Kind {
    /// Whether it stops bodies, from some side.
    pub fn is_terrain(self) -> bool {
        matches!(self, Kind::Solid | Kind::OneWay)
    }
}

/// What of a body decides whether it is in a region.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum By {
    /// Any part of it.
    Body,
    /// The middle of its foot.
    Foot,
    /// The middle between its foot and its top.
    Middle,
    /// A point so many metres to the right of its foot and above it.
    Point(f64, f64),
}

/// What a bend towards a walker does to the speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Concave {
    /// It is kept.
    Keep,
    /// What is left of it in the new direction remains.
    Project,
}

/// What a feature is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Material {
    /// The quarry's own rock.
    #[default]
    Rock,
    /// Dressed stone blocks.
    Masonry,
    /// Beams and planks.
    Timber,
    /// Rusted machinery.
    Iron,
}

impl Feature {
    /// What of a body decides whether it is in the region.
    pub fn by(&self) -> By {
        self.by.unwrap_or(match self.kind {
            Kind::Ladder => By::Middle,
            _ => By::Body,
        })
    }

    /// The corners as they were drawn; those outside the world are left out, which a checked level has none of.
    pub fn drawn(&self) -> Vec<Drawn> {
        let corners = self.outline.iter();
        corners.filter_map(|&p| Drawn::of(p)).collect()
    }

    /// The outline on the grid.
    pub fn snapped(&self) -> Vec<Point> {
        self.drawn().iter().map(|corner| corner.point()).collect()
    }

    /// How far the lower and the upper end of the region, as it is drawn, lie above those of the places where the foot of a body is
    /// that is in it, in metres.
    pub fn drawn_ends(&self, body: &Collider) -> [f64; 2] {
        let metres = |steps: i32| Point::new(0, steps).metres().y;
        match self.by() {
            By::Body => {
                let (low, high) = heights(body);
                [high, low].map(metres)
            }
            By::Foot => [0.0; 2],
            By::Middle => [metres(middle(body).y); 2],
            By::Point(_, y) => [y; 2],
        }
    }

    /// The edges of the feature for a body, which is then a point: around the places where it would overlap a solid or
    /// be in a region, or along those where a one-way holds it.
    pub fn expand(&self, body: &Collider) -> Vec<ExpandedEdge> {
        let outline = self.drawn();
        let about = |at: Drawn| {
            let outline: Vec<Drawn> = outline.iter().map(|p| p.moved(-at.x, -at.y)).collect();
            expand_drawn(&outline, &Collider::point())
        };
        match (self.kind, self.by()) {
            (Kind::Solid, _) => expand_drawn(&outline, body),
            (Kind::OneWay, _) => expand_one_way_drawn(&outline, body),
            (_, By::Body) => expand_drawn(&outline, body),
            (_, By::Foot) => expand_drawn(&outline, &Collider::point()),
            (_, By::Middle) => about(middle(body).into()),
            (_, By::Point(x, y)) => about(Drawn {
                x: length(x),
                y: length(y),
            }),
        }
    }
}

/// The lowest and the highest corner, in steps above the reference point.
fn heights(body: &Collider) -> (i32, i32) {
    let heights = || body.corners().iter().map(|p| p.y);
    (heights().min().unwrap_or(0), heights().max().unwrap_or(0))
}

/// Half way up above the reference point.
fn middle(body: &Collider) -> Point {
    let (low, high) = heights(body);
    Point::new(0, low + (high - low) / 2)
}

/// Whether a field need not be written.
pub(super) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::polygon::winding;

    /// A point of the body is in the region iff the body's reference point is in the expanded one.
    #[test]
    fn a_region_is_entered_by_the_point_that_it_names() {
        let square = [(0, 0), (1, 0), (1, 1), (0, 1)];
        let outline = square.map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
        let inside = |by: By, x: f64, y: f64| {
            let region = Feature {
                kind: Kind::Trigger,
                outline: outline.to_vec(),
                by: Some(by),
                ..Feature::default()
            };
            let edges = region.expand(&Collider::hero());
            let chain: Vec<Point> = edges.iter().map(|edge| edge.a).collect();
            winding(&chain, Point::snap(DVec2::new(x, y)).unwrap()).is_some_and(|turns| turns > 0)
        };
        // The hero is 109/64 m tall and 13/16 m wide.
        assert!(inside(By::Foot, 0.5, 0.9) && !inside(By::Foot, 0.5, -0.1));
        assert!(inside(By::Body, 0.5, -1.7) && !inside(By::Body, 0.5, -1.71));
        assert!(inside(By::Body, 1.4, -0.5) && !inside(By::Body, 1.41, -0.5));
        assert!(inside(By::Middle, 0.5, -0.85) && !inside(By::Middle, 0.5, -0.86));
        assert!(inside(By::Middle, 0.5, 0.14) && !inside(By::Middle, 0.5, 0.15));
        assert!(
            inside(By::Point(0.25, 1.0), 0.7, -0.5) && !inside(By::Point(0.25, 1.0), 0.8, -0.5)
        );
    }
}
