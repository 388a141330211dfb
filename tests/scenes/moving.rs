//! Moving solids in a scene.

use super::rig::{Scene, Variant};
use edgewalker::motion::{Mover, Path, Piece};
use glam::DVec2;
use std::sync::Arc;

impl Scene {
    /// A box that moves, by pieces of (time, offset, velocity, acceleration).
    pub fn moving(
        self,
        x: (f64, f64),
        y: (f64, f64),
        pieces: &[(f64, DVec2, DVec2, DVec2)],
    ) -> Scene {
        let solid = Scene {
            stand: self.stand.clone(),
            crouch: self.crouch.clone(),
            ..Scene::point()
        };
        self.mover(solid.rect(x, y), pieces)
    }

    /// The solids of another scene, moving.
    pub fn mover(mut self, solids: Scene, pieces: &[(f64, DVec2, DVec2, DVec2)]) -> Scene {
        let piece = |&(t0, p0, v0, accel): &(f64, DVec2, DVec2, DVec2)| Piece { t0, p0, v0, accel };
        let pieces = pieces.iter().map(piece).collect();
        self.movers.push((
            solids,
            Path {
                pieces,
                period: None,
            },
        ));
        self
    }

    /// The moving solids, for a variant.
    pub fn build_movers(&self, variant: Variant) -> Vec<Mover> {
        let turned = |piece: &Piece| Piece {
            t0: piece.t0,
            p0: variant.velocity(piece.p0),
            v0: variant.velocity(piece.v0),
            accel: variant.velocity(piece.accel),
        };
        let build = |(solids, path): &(Scene, Path)| Mover {
            stand: Arc::new(solids.mesh(variant, &solids.stand)),
            crouch: Arc::new(solids.mesh(variant, &solids.crouch)),
            path: Path {
                pieces: path.pieces.iter().map(turned).collect(),
                period: path.period,
            },
            start: Some(0.0),
        };
        self.movers.iter().map(build).collect()
    }
}
