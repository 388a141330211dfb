//! The accelerations: for every mode a constant, chosen from the control, the tuning and the speed, together with the speed
//! at which the choice changes. Those along walkable ground are in `footing`.

use super::body::Control;
use crate::tune::Motion;

/// A constant acceleration and the speed at which it stops to hold; `None` if it holds for ever.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law {
    /// m/s^2.
    pub accel: f64,
    /// m/s; always in the direction of `accel`.
    pub until: Option<f64>,
}

/// Relative rounding of a speed that was turned into one along a slope and back.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Law {
    /// None at all.
    pub const REST: Law = Law {
        accel: 0.0,
        until: None,
    };

    /// Towards a speed, and no further.
    pub(super) fn towards(speed: f64, target: f64, rate: f64) -> Law {
        if rate == 0.0 || speed == target {
            return Law::REST;
        }
        Law {
            accel: rate.copysign(target - speed),
            until: Some(target),
        }
    }

    /// Towards a speed that drifts itself, m/s^2, and from there on with it. `rounding`: so near it counts as reached.
    pub(super) fn after(speed: f64, target: f64, drift: f64, rate: f64, rounding: f64) -> Law {
        let miss = target - speed;
        if drift == 0.0 {
            return Law::towards(speed, target, rate);
        }
        if miss.abs() <= rounding {
            return Law {
                accel: drift.clamp(-rate, rate),
                until: None,
            };
        }
        let accel = rate.copysign(miss);
        let left = miss / (accel - drift);
        Law {
            accel,
            until: (left > 0.0 && left.is_finite()).then_some(speed + accel * left),
        }
    }

    /// The same, but no further than to the turn, if the speed turns before.
    pub(super) fn up_to_turn(self, speed: f64) -> Law {
        let turns = speed * self.accel < 0.0 && self.until.is_none_or(|until| until * speed < 0.0);
        Law {
            until: if turns { Some(0.0) } else { self.until },
            ..self
        }
    }

    /// Whether a speed turns so soon that the time, `now`, is still the same: then it has turned.
    pub(super) fn turns_at_once(&self, speed: f64, now: f64) -> bool {
        self.until == Some(0.0) && self.time_left(speed).is_some_and(|left| now + left == now)
    }

    /// How long it holds from a speed on.
    pub fn time_left(&self, speed: f64) -> Option<f64> {
        self.until.map(|until| (until - speed) / self.accel)
    }
}

/// Drives a speed to the wished one over a base, the speed of a belt: `accel` when it is too low, `brake` when it must stop
/// on the belt or turn first, `decay` when it is over the wish (over-speed decays and is never clipped).
pub(super) fn drive(speed: f64, base: f64, wish: f64, accel: f64, brake: f64, decay: f64) -> Law {
    let goal = base + wish;
    if wish == 0.0 || (speed - base) * wish < 0.0 {
        Law::towards(speed, base, brake)
    } else if (goal - speed) * wish >= 0.0 {
        Law::towards(speed, goal, accel)
    } else {
        Law::towards(speed, goal, decay)
    }
}

/// Sideways in the air. The wish is met but for the rounding of a speed that was turned into one along a slope and back:
/// else the last bit would say whether a slide that has reached it is still pushed.
pub fn steer(speed: f64, control: &Control, t: &Motion) -> Law {
    let wish = control.run * t.run_speed;
    let met = (speed - wish).abs() <= ROUNDING * wish.abs();
    drive(
        if met { wish } else { speed },
        0.0,
        wish,
        t.air_accel,
        t.air_brake,
        t.over_speed_decay,
    )
}

/// The speeds at which [`steer`] changes.
pub(super) fn marks_of_steering(control: &Control, t: &Motion) -> [f64; 2] {
    [0.0, control.run * t.run_speed]
}

/// The speeds at which [`fall`] changes.
pub(super) fn marks_of_fall(control: &Control, t: &Motion) -> [f64; 4] {
    let terminal = match control.down {
        true => t.fast_fall_speed,
        false => t.fall_speed,
    };
    [-terminal, t.apex_speed, -t.apex_speed, 0.0]
}

/// How a rise that was let go of is braked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cut {
    /// From this speed on, m/s.
    pub(super) from: f64,
    /// Down to this one, m/s.
    pub(super) to: f64,
    /// The deceleration, m/s^2.
    pub(super) brake: f64,
}

/// [`fall`], or a rise that is let go of.
pub(super) fn rise_or_fall(speed: f64, cut: Option<Cut>, control: &Control, t: &Motion) -> Law {
    let law = fall(speed, control, t);
    let Some(cut) = cut else {
        return law;
    };
    let above = |mark: f64| speed - mark > ROUNDING * mark.abs();
    match (above(cut.from), above(cut.to)) {
        (true, _) if law.until.is_none_or(|until| until < cut.from) => Law {
            until: Some(cut.from),
            ..law
        },
        (false, true) if cut.brake > -law.accel => Law {
            accel: -cut.brake,
            until: Some(cut.to),
        },
        (false, true) if law.until.is_none_or(|until| until < cut.to) => Law {
            until: Some(cut.to),
            ..law
        },
        _ => law,
    }
}

/// Up and down in the air: gravity, the band of reduced gravity about the apex of a held jump, the fast fall, the
/// terminal speed. Speeds count upwards.
pub fn fall(speed: f64, control: &Control, t: &Motion) -> Law {
    let (terminal, heavy) = match control.down {
        true => (t.fast_fall_speed, t.fast_fall_gravity),
        false => (t.fall_speed, 1.0),
    };
    let floats = control.jump && t.apex_gravity < 1.0 && t.apex_speed > 0.0;
    // Below each of these speeds another share of gravity acts; the last one is the terminal speed.
    let share = |below: f64| {
        let falling = if below <= 0.0 { heavy } else { 1.0 };
        if floats && below <= t.apex_speed && below > -t.apex_speed {
            t.apex_gravity * falling
        } else {
            falling
        }
    };
    // A fall along a slope is a component of a speed that was computed from a fall: but for rounding it is still that mark.
    // Braked for a last bit over its limit, it would be lifted off the slope, and fall back, for ever.
    let is_met = |mark: &f64| (speed - mark).abs() <= ROUNDING * mark.abs();
    let speed = [-terminal, t.apex_speed, -t.apex_speed]
        .into_iter()
        .find(is_met)
        .unwrap_or(speed);
    if speed < -terminal {
        return Law::towards(speed, -terminal, t.over_speed_decay);
    }
    if speed == -terminal {
        return Law::REST;
    }
    let mut marks = [f64::NEG_INFINITY; 3];
    if floats {
        marks = [t.apex_speed, f64::NEG_INFINITY, -t.apex_speed];
    }
    if heavy != 1.0 {
        marks[1] = 0.0;
    }
    let next = marks
        .into_iter()
        .find(|&m| m < speed && m > -terminal)
        .unwrap_or(-terminal);
    Law::towards(speed, next, t.gravity * share(speed))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tuning() -> Motion {
        Motion {
            gravity: 30.0,
            apex_speed: 4.0,
            apex_gravity: 0.5,
            fall_speed: 20.0,
            ..Motion::default()
        }
    }

    #[test]
    fn a_held_jump_passes_the_band_of_reduced_gravity() {
        let held = Control {
            jump: true,
            ..Control::default()
        };
        let law = |speed| fall(speed, &held, &tuning());
        assert_eq!(
            law(12.0),
            Law {
                accel: -30.0,
                until: Some(4.0)
            }
        );
        assert_eq!(
            law(4.0),
            Law {
                accel: -15.0,
                until: Some(-4.0)
            }
        );
        assert_eq!(
            law(-4.0),
            Law {
                accel: -30.0,
                until: Some(-20.0)
            }
        );
        assert_eq!(law(-20.0), Law::REST);
        assert_eq!(law(-30.0).accel, tuning().over_speed_decay);
    }

    #[test]
    fn a_fast_fall_starts_at_the_apex() {
        let down = Control {
            down: true,
            ..Control::default()
        };
        let t = tuning();
        assert_eq!(
            fall(3.0, &down, &t),
            Law {
                accel: -30.0,
                until: Some(0.0)
            }
        );
        assert_eq!(
            fall(0.0, &down, &t),
            Law {
                accel: -30.0 * t.fast_fall_gravity,
                until: Some(-t.fast_fall_speed)
            }
        );
    }

    #[test]
    fn a_mark_is_met_but_for_rounding() {
        let t = Motion::default();
        let off = [1.0 - 4.0 * f64::EPSILON, 1.0, 1.0 + 4.0 * f64::EPSILON];
        for factor in off {
            assert_eq!(fall(-24.0 * factor, &Control::default(), &t), Law::REST);
            let held = Control {
                jump: true,
                ..Control::default()
            };
            assert_eq!(fall(3.0 * factor, &held, &t).until, Some(-3.0));
        }
        assert!(fall(-24.0 - 1e-12, &Control::default(), &t).accel > 0.0);
    }
}
