//! What floats and lights up: the shards over lodestones, and the light of the gate.

use super::frame::PointLight;
use super::kit::{Kit, Part};
use crate::game::View;
use glam::{DVec2, Mat4, Vec3};

/// Height of a shard over the foot of its lodestone, and how far it rises and falls, in metres.
const HEIGHT: f32 = 1.86;
const BOB: f32 = 0.07;
/// Turns in radians per second, and rises in radians per second: as they wait, and once they are taken.
const SPIN: [f32; 2] = [0.5, 1.6];
const SWING: f32 = 1.9;
/// Share of its colour that shines, and its size: as it waits, and once it is taken.
const GLOW: [f32; 2] = [0.16, 1.0];
const SIZE: [f32; 2] = [0.9, 1.25];
/// How bright the gate is before the goal is reached, and how much its light breathes.
const WAITING: f32 = 0.55;
const BREATH: f32 = 0.12;
/// Seconds in which the gate lights up.
const DAWN: f64 = 1.2;
/// How far from the camera's aim shards are drawn, in metres along x; the gate is seen from further away.
const NEAR: f32 = 45.0;
const FAR: f32 = 160.0;
/// How much of the light of a lodestone it sheds while it waits.
pub const DIM: f32 = 0.3;

/// A shard over a lodestone.
struct Shard {
    /// Where the checkpoint puts the hero's foot: this tells it from others.
    respawn: DVec2,
    foot: Vec3,
    /// Its lamp, at full strength.
    light: Option<PointLight>,
}

/// Everything of a stage that floats.
#[derive(Default)]
pub struct Shards {
    /// Numbers of their pieces in the kit.
    shard: usize,
    gate: usize,
    shards: Vec<Shard>,
    gates: Vec<Vec3>,
}

impl Shards {
    /// Nothing floats yet.
    pub fn new(kit: &Kit) -> Shards {
        Shards {
            shard: kit.number(Part::LodestoneShard),
            gate: kit.number(Part::GateLight),
            ..Shards::default()
        }
    }

    /// Adds the shard of a lodestone that stands at a foot.
    pub fn lodestone(&mut self, respawn: DVec2, foot: Vec3, light: Option<PointLight>) {
        self.shards.push(Shard {
            respawn,
            foot,
            light,
        });
    }

    /// Adds the light of a gate that stands at a foot.
    pub fn gate(&mut self, foot: Vec3) {
        self.gates.push(foot);
    }

    /// The lamp of the checkpoint that holds.
    pub fn light(&self, view: &View) -> Option<PointLight> {
        let taken = self
            .shards
            .iter()
            .find(|s| Some(s.respawn) == view.checkpoint);
        taken.and_then(|shard| shard.light)
    }

    /// Calls `show` with the piece, the place and the glow of all that is near the camera's aim.
    pub fn place(&self, view: &View, aim: Vec3, time: f64, mut show: impl FnMut(usize, Mat4, f32)) {
        let seconds = time as f32;
        for shard in &self.shards {
            if (shard.foot.x - aim.x).abs() > NEAR {
                continue;
            }
            let taken = usize::from(view.checkpoint == Some(shard.respawn));
            let rise = BOB * (seconds * SWING + shard.foot.x).sin();
            let place = Mat4::from_translation(shard.foot + Vec3::Y * (HEIGHT + rise))
                * Mat4::from_rotation_y(seconds * SPIN[taken] + shard.foot.x)
                * Mat4::from_scale(Vec3::splat(SIZE[taken]));
            show(self.shard, place, GLOW[taken]);
        }
        for foot in self
            .gates
            .iter()
            .filter(|foot| (foot.x - aim.x).abs() < FAR)
        {
            let dawn = match view.won_at {
                Some(at) => ((view.time - at) / DAWN).clamp(0.0, 1.0) as f32,
                None => 0.0,
            };
            let breath = BREATH * (seconds * 0.8).sin();
            let glow = WAITING + breath + (1.0 - WAITING) * dawn;
            show(self.gate, Mat4::from_translation(*foot), glow);
        }
    }
}
