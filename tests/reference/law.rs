//! What drives a body, written from the sentences of the tunables alone.

use super::double::Double;
use edgewalker::motion::Control;
use edgewalker::tune::Motion;

/// An acceleration, and the speed up to which it is sure to hold; the pieces may be shorter than needed.
#[derive(Clone, Copy, Debug)]
pub struct Drive {
    pub accel: Double,
    pub until: Option<Double>,
}

impl Drive {
    const NONE: Drive = Drive {
        accel: Double::ZERO,
        until: None,
    };

    fn towards(speed: Double, goal: Double, rate: f64) -> Drive {
        if rate == 0.0 || (goal - speed).is_tiny() {
            return Drive::NONE;
        }
        let accel = Double::from(rate * (goal - speed).sign());
        Drive {
            accel,
            until: Some(goal),
        }
    }
}

/// The wished speed is reached with `accel`; released or turned, the body stops with `brake`; what is faster
/// than the wish in its direction decays.
fn pushed(speed: Double, wish: Double, [accel, brake, decay]: [f64; 3]) -> Drive {
    let against = speed.sign() * wish.sign() < 0.0 && !speed.is_tiny();
    if wish == Double::ZERO || against {
        return Drive::towards(speed, Double::ZERO, brake);
    }
    let too_fast = speed.abs() > wish.abs();
    Drive::towards(speed, wish, if too_fast { decay } else { accel })
}

/// The speed along walkable ground that the stick asks for.
pub fn wish(control: &Control, crouched: bool, t: &Motion) -> Double {
    let full = if crouched {
        t.crouch_speed
    } else {
        t.run_speed
    };
    Double::from(control.run) * full.into()
}

/// Along walkable ground; speeds count towards growing x.
pub fn walk(speed: Double, control: &Control, crouched: bool, t: &Motion) -> Drive {
    let rates = [t.run_accel, t.run_brake, t.over_speed_decay];
    pushed(speed, wish(control, crouched, t), rates)
}

/// Sideways in the air.
pub fn steer(speed: Double, control: &Control, t: &Motion) -> Drive {
    let rates = [t.air_accel, t.air_brake, t.over_speed_decay];
    let wish = Double::from(control.run) * t.run_speed.into();
    pushed(speed, wish, rates)
}

/// Up and down in the air; speeds count upwards.
pub fn fall(speed: Double, control: &Control, t: &Motion) -> Drive {
    let terminal = if control.down {
        t.fast_fall_speed
    } else {
        t.fall_speed
    };
    if (speed + terminal.into()).is_tiny() {
        return Drive::NONE;
    }
    if speed < (-terminal).into() {
        return Drive::towards(speed, (-terminal).into(), t.over_speed_decay);
    }
    // At a mark the piece below it begins.
    let marks = [t.apex_speed, 0.0, -t.apex_speed, -terminal].map(Double::from);
    let beneath = |mark: &Double| *mark < speed && !(*mark - speed).is_tiny();
    let next = marks.into_iter().filter(beneath).reduce(Double::max);
    let next = next.expect("faster upwards than the terminal speed");
    let middle = ((speed + next) * 0.5.into()).to_f64();
    let mut gravity = Double::from(t.gravity);
    if control.jump && middle.abs() < t.apex_speed {
        gravity = gravity * t.apex_gravity.into();
    }
    if control.down && middle < 0.0 {
        gravity = gravity * t.fast_fall_gravity.into();
    }
    if gravity == Double::ZERO {
        return Drive::NONE;
    }
    Drive {
        accel: -gravity,
        until: Some(next),
    }
}

#[test]
fn a_held_fast_jump_has_five_pieces() {
    let t = Motion::default();
    let held = Control {
        run: 0.0,
        jump: true,
        down: true,
        ..Control::default()
    };
    let mut speed = Double::from(t.jump_speed);
    let mut pieces = Vec::new();
    while let Drive {
        accel,
        until: Some(until),
    } = fall(speed, &held, &t)
    {
        pieces.push((accel.to_f64(), until.to_f64()));
        speed = until;
    }
    let expected = [(-45.0, 3.0), (-22.5, 0.0), (-36.0, -3.0), (-72.0, -34.0)];
    assert_eq!(pieces, expected);
}
