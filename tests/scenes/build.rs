//! From a scene to meshes and traits. Features have ids in the order of the fields of a scene, those of moving solids after
//! all that stand still.

use super::rig::{Scene, Variant};
use edgewalker::geom::{Collider, ExpandedEdge, Point, Source, expand, expand_one_way};
use edgewalker::mesh::{FeatureId, Kind, Mesh};
use edgewalker::motion::Traits;
use glam::DVec2;

impl Scene {
    /// The mesh of all that stands still.
    pub fn mesh(&self, variant: Variant, collider: &Collider) -> Mesh {
        self.mesh_from(0, variant, collider)
    }

    /// The same with the ids of features from a number on.
    pub fn mesh_from(&self, first: FeatureId, variant: Variant, collider: &Collider) -> Mesh {
        let snap = |corners: &[DVec2]| {
            let mut outline: Vec<_> = corners
                .iter()
                .map(|&p| Point::snap(variant.there(p)).unwrap())
                .collect();
            if variant == Variant::Mirrored {
                outline.reverse();
            }
            outline
        };
        let outlines = self
            .solids
            .iter()
            .map(|s| (Kind::Solid, expand(&snap(s), collider)));
        let wires = self.wires.iter().map(|&(a, b)| {
            let [a, b] = [a, b].map(|p| Point::snap(variant.there(p)).unwrap());
            let source = Source::Edge { edge: 0 };
            (Kind::Solid, vec![ExpandedEdge::new(a, b, source)])
        });
        let one_ways = self
            .one_ways
            .iter()
            .map(|line| (Kind::OneWay, expand_one_way(&snap(line), collider)));
        let regions = self
            .regions
            .iter()
            .map(|(_, outline)| (Kind::Region, expand(&snap(outline), &Collider::point())));
        let lines = self.lines.iter().map(|&(a, b)| {
            let [a, b] = [a, b].map(|p| Point::snap(variant.there(p)).unwrap());
            let edge = |a, b, edge| ExpandedEdge::new(a, b, Source::Edge { edge });
            (Kind::Line, vec![edge(a, b, 0), edge(b, a, 1)])
        });
        let features = outlines
            .chain(wires)
            .chain(one_ways)
            .chain(regions)
            .chain(lines);
        let features: Vec<_> = (first..)
            .zip(features)
            .map(|(id, (k, e))| (id, k, e))
            .collect();
        Mesh::of(&features).unwrap()
    }

    /// The traits of all features, in the order of the mesh.
    pub fn all_traits(&self, variant: Variant) -> Vec<Traits> {
        let others = self.solids.len() + self.wires.len() + self.one_ways.len();
        let mut traits = self.traits.clone();
        traits.resize(others, Traits::default());
        traits.extend(self.regions.iter().map(|&(region, _)| Traits {
            region,
            drawn: self.drawn,
            ..Traits::default()
        }));
        if variant == Variant::Mirrored {
            traits.iter_mut().for_each(|t| t.conveyor = -t.conveyor);
        }
        traits.resize(self.features(), Traits::default());
        traits.extend(self.movers.iter().flat_map(|m| m.0.all_traits(variant)));
        traits
    }

    /// How many features stand still.
    pub fn features(&self) -> usize {
        let closed = self.solids.len() + self.regions.len();
        closed + self.wires.len() + self.one_ways.len() + self.lines.len()
    }
}
