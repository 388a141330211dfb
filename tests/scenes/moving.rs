//! Moving solids in a scene.

use super::rig::{Run, Scene, Variant};
use edgewalker::mesh::FeatureId;
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
    pub fn build_movers(&self, variant: Variant, start: Option<f64>) -> Vec<Mover> {
        let turned = |piece: &Piece| Piece {
            t0: piece.t0,
            p0: variant.velocity(piece.p0),
            v0: variant.velocity(piece.v0),
            accel: variant.velocity(piece.accel),
        };
        let mut first = self.features() as FeatureId;
        let build = |(solids, path): &(Scene, Path)| {
            let mesh = |collider| Arc::new(solids.mesh_from(first, variant, collider));
            let [stand, crouch] = [&solids.stand, &solids.crouch].map(mesh);
            first += solids.features() as FeatureId;
            Mover {
                stand,
                crouch,
                path: Path {
                    pieces: path.pieces.iter().map(turned).collect(),
                    period: path.period,
                },
                start,
            }
        };
        self.movers.iter().map(build).collect()
    }
}

impl Run<'_> {
    /// Starts the moving solids of a scene that says when, at that time: where the body is changes by no bit.
    pub fn start(&mut self) -> &mut Self {
        let bits = |run: &Run| run.body().position().to_array().map(f64::to_bits);
        let before = bits(self);
        self.terrain.movers = self.going;
        let body = self.body.as_mut().expect("a body");
        body.take_up_paths(&self.terrain, &mut self.trace);
        assert_eq!(bits(self), before, "{:?}", self.variant);
        self.advance(self.time())
    }

    /// Moves up to a time in ticks of a rate.
    pub fn play(&mut self, until: f64, rate: f64) -> &mut Self {
        let first = (self.time() * rate).floor() as u32 + 1;
        for tick in (first..).map(|n| f64::from(n) / rate) {
            if tick >= until {
                break;
            }
            self.advance(tick);
        }
        self.advance(until)
    }
}

/// Runs a test on a scene in all variants at all tick rates, which it hands to [`Run::play`]: all must print the same.
pub fn at_every_rate(scene: &Scene, test: impl Fn(&mut Run, f64)) {
    for variant in [Variant::Plain, Variant::Mirrored, Variant::Shifted] {
        let told = std::cell::RefCell::new(Vec::new());
        for rate in [15.0, 30.0, 60.0, 120.0, 240.0, 1000.0] {
            scene.with(variant, &|run: &mut Run| {
                test(run, rate);
                let times = run.trace.events.iter().map(|e| (e.time.to_bits(), e.kind));
                told.borrow_mut()
                    .push((run.body().hash(), times.collect::<Vec<_>>()));
            });
        }
        for other in told.borrow().iter() {
            assert_eq!(*other, told.borrow()[0], "{variant:?}");
        }
    }
}
