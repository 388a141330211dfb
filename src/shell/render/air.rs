//! What floats in the air: dust and embers, the glow around lamps, puffs at landings. Squares that look at the viewer.

use super::frame::PointLight;
use super::gl::{Geometry, Gl};
use super::model::pack;
use super::state::Format;
use crate::game::View;
use glam::{Vec3, Vec4};

/// A mote: seed 0 to 1 on three axes, and its kind and number.
const MOTE: [Format; 2] = [Format::F4, Format::F1];
/// A glow: place and radius, colour.
const GLOW: [Format; 2] = [Format::F4, Format::Unorm4];
/// How many there are of each kind: dust, embers, clouds of a puff.
const KINDS: [usize; 3] = [120, 26, 12];
/// Seconds that a puff lasts.
const PUFF: f64 = 0.7;
/// Speeds into the ground, in m/s, up to which nothing is stirred up, and from which a puff is as large as it gets.
const GENTLE: f64 = 4.0;
const HARD: f64 = 20.0;
/// Seconds after which a puff that was not seen to begin is left out.
const LATE: f64 = 0.06;

/// The buffers.
pub struct Air {
    /// Dust, embers and puffs: where they are is worked out by the shader.
    pub motes: Geometry,
    /// Glows of the lamps in the picture.
    pub glows: Geometry,
    puff: Option<Puff>,
}

/// Dust from a landing or a take-off.
#[derive(Clone, Copy)]
struct Puff {
    time: f64,
    at: Vec3,
    strength: f32,
}

impl Puff {
    /// The last one of a view that is seen for the first time.
    fn of(view: &View, foot: Vec3) -> Puff {
        let landed = view.landed_at >= view.left_at;
        let (time, speed) = match landed {
            true => (view.landed_at, view.landed_speed),
            false => (view.left_at, 0.5 * view.velocity.y),
        };
        // Seen a little later than it happened: go back along the way. Seen much later, nobody knows where it was.
        let age = view.time - time;
        let way = view.velocity.as_vec2().extend(0.0) * age as f32;
        let strength = match speed > GENTLE && age < LATE {
            true => (speed / HARD).min(1.0) as f32,
            false => 0.0,
        };
        Puff {
            time,
            at: foot - way,
            strength,
        }
    }
}

/// A number from 0 to 1 from a counter: additive steps of irrational size spread evenly.
fn spread(index: usize, step: f64) -> f32 {
    (index as f64 * step).fract() as f32
}

impl Air {
    /// The motes; no glow yet.
    pub fn new(gl: &Gl) -> Result<Air, String> {
        let mut words: Vec<u32> = Vec::new();
        let kinds = KINDS
            .into_iter()
            .enumerate()
            .flat_map(|(kind, count)| (0..count).map(move |_| kind));
        for (index, kind) in kinds.enumerate() {
            let seed = [0.7548776662466927, 0.5698402909980532, 0.8191725133961645]
                .map(|step| spread(index + 1, step));
            let numbers = [
                seed[0],
                seed[1],
                seed[2],
                kind as f32,
                spread(index + 1, 0.6180339887498949),
            ];
            words.extend(numbers.map(f32::to_bits));
        }
        let mut motes = gl.geometry(&MOTE, true)?;
        motes.upload(&words);
        Ok(Air {
            motes,
            glows: gl.geometry(&GLOW, true)?,
            puff: None,
        })
    }

    /// The puff of a view, for the frame's block: place and age, strength.
    pub fn puff(&mut self, view: &View, foot: Vec3) -> (Vec4, f32) {
        let seen = self
            .puff
            .filter(|puff| puff.time == view.landed_at.max(view.left_at));
        let puff = *self
            .puff
            .insert(seen.unwrap_or_else(|| Puff::of(view, foot)));
        let age = (view.time - puff.time) / PUFF;
        let strength = if (0.0..1.0).contains(&age) {
            puff.strength
        } else {
            0.0
        };
        (puff.at.extend(age.clamp(0.0, 1.0) as f32), strength)
    }

    /// Replaces the glows by those of these lamps.
    pub fn upload(&mut self, lamps: &[PointLight], words: &mut Vec<u32>) {
        words.clear();
        for lamp in lamps {
            words.extend(
                lamp.at
                    .extend(lamp.reach * 0.26)
                    .to_array()
                    .map(f32::to_bits),
            );
            let brightest = lamp.colour.max_element().max(1e-3);
            words.push(pack((lamp.colour / brightest).extend(1.0).to_array()));
        }
        self.glows.upload(words);
    }
}
