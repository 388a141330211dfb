//! What floats and lights up: the shards over lodestones, and the light of the gate.

use super::frame::{Frame, PointLight};
use super::kit::{Kit, Part};
use crate::game::View;
use glam::{DVec2, Mat4, Vec2, Vec3};

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
    /// Where the checkpoint puts the hero's foot, as it was drawn: this tells it from others.
    respawn: DVec2,
    foot: Foot,
    /// Its lamp, at full strength.
    light: Option<PointLight>,
}

/// Where something stands, as it was drawn, and the number of the mover that it rides on.
#[derive(Clone, Copy)]
struct Foot {
    at: Vec3,
    mover: Option<usize>,
}

impl Foot {
    /// Where it is by the offsets of the movers.
    fn moved(self, offsets: &[DVec2]) -> Vec3 {
        let offset = self.mover.and_then(|mover| offsets.get(mover));
        self.at
            + offset
                .map_or(Vec2::ZERO, |offset| offset.as_vec2())
                .extend(0.0)
    }
}

/// Everything of a stage that floats.
#[derive(Default)]
pub struct Shards {
    /// Numbers of their pieces in the kit.
    shard: usize,
    gate: usize,
    shards: Vec<Shard>,
    gates: Vec<Foot>,
    /// The mover on which the next ones ride.
    mover: Option<usize>,
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

    /// What is added from now on rides on a mover.
    pub fn riding(&mut self, mover: usize) -> &mut Shards {
        self.mover = Some(mover);
        self
    }

    /// Adds the shard of a lodestone that stands at a foot.
    pub fn lodestone(&mut self, respawn: DVec2, foot: Vec3, light: Option<PointLight>) {
        let foot = self.foot(foot);
        self.shards.push(Shard {
            respawn,
            foot,
            light,
        });
    }

    /// Adds the light of a gate that stands at a foot.
    pub fn gate(&mut self, foot: Vec3) {
        self.gates.push(self.foot(foot));
    }

    fn foot(&self, at: Vec3) -> Foot {
        let mover = self.mover;
        Foot { at, mover }
    }

    /// The lamp of the checkpoint that holds; movers are where their offsets say.
    pub fn light(&self, view: &View, offsets: &[DVec2]) -> Option<PointLight> {
        let mut shards = self.shards.iter();
        let taken = shards.find(|s| Some(s.respawn) == view.checkpoint)?;
        let light = taken.light?;
        let at = light.at + (taken.foot.moved(offsets) - taken.foot.at);
        Some(PointLight { at, ..light })
    }

    /// Calls `show` with the piece, the place and the glow of all that is near the camera's aim, movers by their offsets.
    pub fn place(&self, frame: &Frame, mut show: impl FnMut(usize, Mat4, f32)) {
        let (view, aim, offsets) = (frame.view, frame.camera.target, frame.offsets);
        let seconds = frame.time as f32;
        for shard in &self.shards {
            let foot = shard.foot.moved(offsets);
            if (foot.x - aim.x).abs() > NEAR {
                continue;
            }
            let taken = usize::from(view.checkpoint == Some(shard.respawn));
            // What rides swings and turns as where it was drawn.
            let drawn = shard.foot.at.x;
            let rise = BOB * (seconds * SWING + drawn).sin();
            let place = Mat4::from_translation(foot + Vec3::Y * (HEIGHT + rise))
                * Mat4::from_rotation_y(seconds * SPIN[taken] + drawn)
                * Mat4::from_scale(Vec3::splat(SIZE[taken]));
            show(self.shard, place, GLOW[taken]);
        }
        let gates = self.gates.iter().map(|foot| foot.moved(offsets));
        for foot in gates.filter(|foot| (foot.x - aim.x).abs() < FAR) {
            let dawn = match view.won_at {
                Some(at) => ((view.time - at) / DAWN).clamp(0.0, 1.0) as f32,
                None => 0.0,
            };
            let breath = BREATH * (seconds * 0.8).sin();
            let glow = WAITING + breath + (1.0 - WAITING) * dawn;
            show(self.gate, Mat4::from_translation(foot), glow);
        }
    }
}
