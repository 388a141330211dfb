//! What floats in the air: dust, embers, leaves, the glow around lamps, puffs at landings, splashes in the water; and the
//! shadow right below the hero. Squares that look at the viewer, but for the last.

use super::frame::PointLight;
use super::gl::{Geometry, Gl};
use super::model::pack;
use super::state::Format;
use crate::game::View;
use glam::{Vec3, Vec4};

/// Vertices of a square.
const CORNERS: usize = 6;
/// A corner of a mote: seed 0 to 1 on three axes, and its kind and number.
const MOTE: [Format; 2] = [Format::F4, Format::F1];
/// A glow: place and radius, colour.
const GLOW: [Format; 2] = [Format::F4, Format::Unorm4];
/// The kinds as the shader tells them apart, and how many there are of each, in the order in which they are drawn: the
/// hero's shadow, dust, embers, clouds of a puff, leaves.
const KINDS: [(f32, usize); 5] = [(4.0, 1), (0.0, 220), (1.0, 60), (2.0, 14), (3.0, 70)];
/// Seconds that a puff lasts.
const PUFF: f64 = 0.7;
/// Speeds into the ground, in m/s, up to which nothing is stirred up, and from which a puff is as large as it gets.
const GENTLE: f64 = 4.0;
const HARD: f64 = 20.0;
/// Seconds after which a puff that was not seen to begin is left out.
const LATE: f64 = 0.06;

/// Farther than this the hero does not get between two pictures, in metres: he was put somewhere else.
const STEP: f32 = 3.0;

/// The buffers.
pub struct Air {
    /// Dust, embers and puffs: where they are is worked out by the shader.
    pub motes: Geometry,
    /// Glows of the lamps in the picture.
    pub glows: Geometry,
    puff: Option<Puff>,
    /// Where the hero's foot was in the picture before.
    foot: Option<Vec3>,
}

/// Dust from a landing or a take-off.
#[derive(Clone, Copy)]
struct Puff {
    time: f64,
    at: Vec3,
    strength: f32,
    wet: bool,
}

/// What the frame's block says of a puff.
pub struct Stirred {
    /// Place, and age from 0 to 1.
    pub at: Vec4,
    /// How large it is, 0 to 1.
    pub strength: f32,
    /// Whether it is of water.
    pub wet: bool,
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
            wet: false,
        }
    }

    /// A splash where the hero's foot came through the water's surface.
    fn splash(view: &View, foot: Vec3, water: f32) -> Puff {
        Puff {
            time: view.time,
            at: foot.with_y(water),
            strength: (view.velocity.y.abs() / HARD).min(1.0) as f32,
            wet: true,
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
            .flat_map(|(kind, count)| (0..count).map(move |_| kind));
        for (index, kind) in kinds.enumerate() {
            let seed = [0.7548776662466927, 0.5698402909980532, 0.8191725133961645]
                .map(|step| spread(index + 1, step));
            let numbers = [
                seed[0],
                seed[1],
                seed[2],
                kind,
                spread(index + 1, 0.6180339887498949),
            ];
            (0..CORNERS).for_each(|_| words.extend(numbers.map(f32::to_bits)));
        }
        let mut motes = gl.geometry(&MOTE, false)?;
        motes.upload(&words);
        Ok(Air {
            motes,
            glows: gl.geometry(&GLOW, true)?,
            puff: None,
            foot: None,
        })
    }

    /// What is stirred up in a view, over water of a height.
    pub fn puff(&mut self, view: &View, foot: Vec3, water: f32) -> Stirred {
        let before = self.foot.replace(foot).unwrap_or(foot);
        if before.y > water && foot.y <= water && before.distance(foot) < STEP {
            self.puff = Some(Puff::splash(view, foot, water));
        }
        let last = view.landed_at.max(view.left_at);
        let seen = self
            .puff
            .filter(|puff| puff.time == last || (puff.wet && puff.time > last));
        let puff = *self
            .puff
            .insert(seen.unwrap_or_else(|| Puff::of(view, foot)));
        let age = (view.time - puff.time) / PUFF;
        let strength = if (0.0..1.0).contains(&age) {
            puff.strength
        } else {
            0.0
        };
        Stirred {
            at: puff.at.extend(age.clamp(0.0, 1.0) as f32),
            strength,
            wet: puff.wet,
        }
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
