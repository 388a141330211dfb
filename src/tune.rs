//! Every tunable number of the game: one line each, with its default, range, unit and sentence.
//!
//! The lines below are the only declaration: from them come the structs that the simulation reads,
//! the RON that tuning files hold, the sliders of the overlay and the tests of the ranges.

use serde::{Deserialize, Serialize};

/// What is known of one tunable apart from its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meta {
    /// Field name, as tuning files write it.
    pub name: &'static str,
    /// Value before anybody turned the knob.
    pub default: f64,
    /// Smallest value that a slider or a file may set.
    pub min: f64,
    /// Largest value that a slider or a file may set.
    pub max: f64,
    /// Unit, for people; "" for a pure number.
    pub unit: &'static str,
    /// What it does, in a sentence.
    pub sentence: &'static str,
    /// Names of the values 0, 1, 2 ... of a choice; empty for a number.
    pub choices: &'static [&'static str],
}

macro_rules! tunables {
    ($(#[$doc:meta])* $group:ident {
        $($name:ident = $default:literal in $min:literal ..= $max:literal, $unit:literal, $sentence:literal $(, [$($choice:literal),+])?;)+
    }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
        #[serde(default, deny_unknown_fields)]
        pub struct $group {
            $(#[doc = concat!($sentence, " Unit: ", $unit, ".")] pub $name: f64,)+
        }

        impl Default for $group {
            fn default() -> Self {
                $group { $($name: $default,)+ }
            }
        }

        impl $group {
            /// The declaration of every tunable, in order.
            pub const META: &[Meta] = &[$(Meta {
                name: stringify!($name),
                default: $default,
                min: $min,
                max: $max,
                unit: $unit,
                sentence: $sentence,
                choices: &[$($($choice),+)?],
            },)+];

            /// The values, in the order of [`Self::META`].
            pub fn values(&self) -> Vec<f64> {
                vec![$(self.$name,)+]
            }

            /// The values for writing, in the order of [`Self::META`].
            pub fn values_mut(&mut self) -> Vec<&mut f64> {
                vec![$(&mut self.$name,)+]
            }

            /// Names the first value that is not a number or out of its range.
            fn check(&self) -> Result<(), TuneError> {
                for (meta, value) in Self::META.iter().zip(self.values()) {
                    if !(value >= meta.min && value <= meta.max) {
                        return Err(TuneError { meta: *meta, value });
                    }
                }
                Ok(())
            }
        }
    };
}

tunables! {
    /// How the hero moves.
    Motion {
        run_speed = 8.0 in 0.0..=60.0, "m/s", "Speed that full stick asks for, along the ground or sideways in the air.";
        run_accel = 80.0 in 0.0..=2000.0, "m/s^2", "Acceleration on the ground towards the wished speed.";
        run_brake = 100.0 in 0.0..=2000.0, "m/s^2", "Deceleration on the ground when the stick is released or turned.";
        over_speed_decay = 20.0 in 0.0..=2000.0, "m/s^2", "Deceleration while faster than wished in the wished direction.";
        crouch_speed = 3.0 in 0.0..=60.0, "m/s", "Speed that full stick asks for while crouched.";
        air_accel = 50.0 in 0.0..=2000.0, "m/s^2", "Sideways acceleration in the air.";
        air_brake = 30.0 in 0.0..=2000.0, "m/s^2", "Sideways deceleration in the air with the stick released or turned.";
        gravity = 45.0 in 0.0..=400.0, "m/s^2", "Downward acceleration in the air.";
        jump_speed = 16.0 in 0.0..=100.0, "m/s", "Upward speed at a jump.";
        jump_cut_speed = 4.0 in 0.0..=100.0, "m/s", "Upward speed, over that of what was left, down to which a jump let go of while rising is braked.";
        jump_cut_brake = 900.0 in 0.0..=10000.0, "m/s^2", "Deceleration of that, where it is more than gravity.";
        jump_least = 0.79 in 0.0..=10.0, "m", "How high, as seen from what was left, even the shortest tap jumps: earlier the brake does not begin.";
        lift_jump = 0.0 in 0.0..=2.0, "", "What a jump takes of the velocity of what carries one.", ["no fall", "all", "nothing"];
        apex_speed = 3.0 in 0.0..=50.0, "m/s", "Below this vertical speed a held jump floats under reduced gravity.";
        apex_gravity = 0.5 in 0.0..=1.0, "", "Share of gravity that acts on a held jump near its apex.";
        fall_speed = 24.0 in 0.0..=1000.0, "m/s", "Terminal speed of a fall.";
        fast_fall_speed = 34.0 in 0.0..=1000.0, "m/s", "Terminal speed of a fall with down held.";
        fast_fall_gravity = 1.6 in 1.0..=10.0, "", "Share of gravity that acts on a fall with down held.";
        coyote_time = 0.1 in 0.0..=1.0, "s", "How long after walking off an edge a jump is still granted.";
        jump_buffer = 0.1 in 0.0..=1.0, "s", "How long before a landing a jump may be pressed.";
        max_slope = 1.0 in 0.0..=10.0, "rise/run", "Steepest ground that can be stood on; 1 is 45 degrees, included.";
        joint = 1.0 in 0.0..=2.0, "", "What holds a walker to the ground where it bends away.", ["stick always", "curvature", "ballistic"];
        joint_stick = 40.0 in 0.0..=1000.0, "m/s^2", "Acceleration beside gravity that holds a walker to ground that curves away.";
        joint_span = 1.0 in 0.0001..=100.0, "m", "Longest stretch of an edge that counts as part of the curve at its end.";
        concave = 0.0 in 0.0..=1.0, "", "What a bend between walkable grounds towards the walker does to the speed; one to or from what is steeper takes it as if projected.", ["keep", "project"];
        slope_gravity = 0.0 in 0.0..=1.0, "", "Share of gravity that acts along walkable ground on one who has no wish.";
        friction = 0.0 in 0.0..=10.0, "", "Coefficient of friction of walkable ground on one who has no wish, beside the brake.";
        slope_speed = 0.0 in 0.0..=1.0, "", "Share of the wished speed lost uphill and won downhill, times the sine of the slope.";
        floor_snap = 0.2 in 0.0..=1.0, "m", "How far below the end of the ground a walker is set down on the next.";
        step_up = 0.2 in 0.0..=1.0, "m", "How high a step a walker takes without a jump.";
        corner_correction = 0.15 in 0.0..=1.0, "m", "How far a head that barely strikes a ceiling's corner is moved aside.";
        ledge_correction = 0.15 in 0.0..=1.0, "m", "How far feet that barely miss a ledge are lifted onto it.";
        ledge_correction_speed = 18.0 in 0.0..=1000.0, "m/s", "Fastest fall from which they are.";
        wall_slide_speed = 4.0 in 0.0..=1000.0, "m/s", "Terminal speed along a wall that is pushed against; 0: as in the air.";
        wall_slide_brake = 100.0 in 0.0..=2000.0, "m/s^2", "Deceleration of a faster slide to that speed.";
        wall_jump_out = 9.0 in 0.0..=100.0, "m/s", "Speed away from the wall at a wall jump.";
        wall_jump_up = 14.5 in 0.0..=100.0, "m/s", "Upward speed at a wall jump; 0: there is none.";
        wall_jump_lock = 0.15 in 0.0..=1.0, "s", "How long a wall jump holds the direction away from the wall.";
        wall_grace = 0.08 in 0.0..=1.0, "s", "How long after coming off a wall a wall jump is still granted.";
        ledge_hang = 1.3 in 0.0..=4.0, "m", "How far below a ledge the feet hang of one who holds it; 0: nobody does.";
        ledge_magnet = 0.2 in 0.0..=1.0, "m", "How far below that height a ledge is still taken hold of.";
        ledge_climb_speed = 5.0 in 0.0..=60.0, "m/s", "Speed of climbing up from a ledge.";
        climb_speed = 4.0 in 0.0..=60.0, "m/s", "Speed that full stick asks for on ladders and climbable walls.";
        climb_accel = 60.0 in 0.0..=2000.0, "m/s^2", "Acceleration there.";
        ladder_reach = 0.5 in 0.0..=4.0, "m", "How far above a ladder, or beside its end, ground may be that is climbed onto from it.";
        squeeze_speed = 24.0 in 0.0..=1000.0, "m/s", "Fastest that solids squeeze one out between them, or as fast as they move; faster crushes him.";
        lift_memory = 0.1 in 0.0..=1.0, "s", "How long one who leaves a moving solid may still jump with the speed it had.";
    }
}

tunables! {
    /// How the camera follows.
    Camera {
        distance = 17.0 in 4.0..=80.0, "m", "Distance of the camera from the plane of play.";
        field_of_view = 42.0 in 10.0..=100.0, "degrees", "Vertical opening angle.";
        height = 1.6 in -10.0..=10.0, "m", "How far above the hero's foot the camera aims.";
        tilt = 1.4 in -10.0..=10.0, "m", "How far above its aim the camera hangs, to look a little down.";
        lead = 0.28 in 0.0..=2.0, "s", "How far ahead of the hero the camera aims, as time at its speed.";
        lead_limit = 3.0 in 0.0..=20.0, "m", "Longest lead.";
        stiffness_x = 12.0 in 0.1..=60.0, "1/s", "How fast the camera closes in sideways.";
        stiffness_y = 8.0 in 0.1..=60.0, "1/s", "How fast the camera closes in up and down.";
        dead_zone_y = 3.2 in 0.0..=10.0, "m", "Height that the hero may rise in the air before the camera follows.";
        look = 3.0 in 0.0..=20.0, "m", "How far the camera looks up or down when asked.";
    }
}

/// All tunables.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Tuning {
    /// How the hero moves.
    pub motion: Motion,
    /// How the camera follows.
    pub camera: Camera,
}

impl Tuning {
    /// Names the first value that is not a number or out of its range.
    pub fn check(&self) -> Result<(), TuneError> {
        self.motion.check()?;
        self.camera.check()
    }
}

/// A tunable out of its range.
#[derive(Clone, Debug, PartialEq)]
pub struct TuneError {
    /// Which tunable.
    pub meta: Meta,
    /// The value that was refused.
    pub value: f64,
}

impl std::fmt::Display for TuneError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Meta {
            name,
            min,
            max,
            unit,
            ..
        } = self.meta;
        write!(
            f,
            "field `{name}`: {:?} is outside {min}..={max} {unit}",
            self.value
        )
    }
}

impl std::error::Error for TuneError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defaults_are_in_range_and_described() {
        Tuning::default().check().unwrap();
        for meta in Motion::META.iter().chain(Camera::META) {
            assert!(
                meta.sentence.ends_with('.') && meta.min < meta.max,
                "{}",
                meta.name
            );
        }
    }

    #[test]
    fn a_value_out_of_range_is_named() {
        let mut tuning = Tuning::default();
        tuning.motion.gravity = f64::NAN;
        assert!(tuning.check().unwrap_err().to_string().contains("gravity"));
    }
}
