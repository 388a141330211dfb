//! Walkable ground as a walker feels it: its slope, its friction, its belt, and the law along it.
//!
//! Who wishes to run is driven to the wished speed over the belt, which a slope changes (`slope_speed`). Who does not is
//! pulled downhill by a share of gravity (`slope_gravity`) and braked by `run_brake` and by dry friction (Coulomb's law: the
//! coefficient times the force into the ground); at rest on the belt he sticks iff the pull is not the larger of the two,
//! which is decided on the exact direction of the feature edge. All speeds and accelerations here count towards growing x.

use super::body::Control;
use super::law::{Law, drive};
use super::terrain::{Ground, Terrain, Traits};
use super::track::{Track, reduced};
use crate::mesh::{EdgeId, SegmentId};
use crate::tune::Motion;

/// Ground under a walker.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footing {
    /// Exact direction towards growing x as it was drawn, without a common factor; `run` is positive.
    rise: f64,
    run: f64,
    /// Length of that direction.
    length: f64,
    /// Speed of the ground itself, a belt, m/s.
    belt: f64,
    /// Coefficient of friction.
    friction: f64,
}

impl Footing {
    /// Ground with this direction towards growing x, of a feature with these traits.
    pub fn of((run, rise): (i64, i64), traits: &Traits, t: &Motion) -> Footing {
        let (run, rise) = (run as f64, rise as f64);
        Footing {
            rise,
            run,
            length: (run * run + rise * rise).sqrt(),
            belt: traits.conveyor,
            friction: traits.friction.unwrap_or(t.friction),
        }
    }

    /// The ground along a feature edge, the road of which is known, where it runs along an edge of the mesh.
    pub(super) fn under(
        edge: EdgeId,
        s: SegmentId,
        track: &Track,
        mesh: Ground,
        terrain: &Terrain,
    ) -> Footing {
        let segment = mesh.segment(s);
        let sign = if track.tangent.x < 0.0 { -1.0 } else { 1.0 };
        let direction = match segment.aside.is_none() {
            true => track.heading(sign),
            false => reduced(mesh.heading(s, track, sign)),
        };
        let mut traits = terrain.traits_of(segment.feature);
        if mesh.is_held_still(edge, s) {
            traits.conveyor = 0.0;
        }
        Footing::of(direction, &traits, terrain.tuning)
    }

    /// The law at a speed. It ends where the motion turns, which on a belt is not where it slips no more.
    pub fn law(&self, speed: f64, control: &Control, crouched: bool, t: &Motion) -> Law {
        let law = match self.wish(control, crouched, t) {
            0.0 => self.coast(speed, t),
            wish => drive(
                speed,
                self.belt,
                wish,
                t.run_accel,
                t.run_brake,
                t.over_speed_decay,
            ),
        };
        law.up_to_turn(speed)
    }

    /// The speed at which the law ends that holds at rest: the belt's and the wished one.
    pub fn steady(&self, control: &Control, crouched: bool, t: &Motion) -> f64 {
        self.belt + self.wish(control, crouched, t)
    }

    /// The wished speed over the belt.
    fn wish(&self, control: &Control, crouched: bool, t: &Motion) -> f64 {
        let full = match crouched {
            true => t.crouch_speed,
            false => t.run_speed,
        };
        let wish = control.run * full;
        let uphill = if wish < 0.0 { -self.rise } else { self.rise };
        wish * (1.0 - t.slope_speed * (uphill / self.length))
    }

    /// Without a wish: the pull of the slope against what holds the walker to the belt.
    fn coast(&self, speed: f64, t: &Motion) -> Law {
        let pull = -t.slope_gravity * t.gravity * self.rise;
        let rub = t.gravity * (self.friction * self.run);
        let slip = speed - self.belt;
        let sticks = pull.abs() <= rub + t.run_brake * self.length;
        if slip == 0.0 && sticks {
            return Law::REST;
        }
        let against = if slip == 0.0 { pull } else { slip }.signum();
        let accel = (pull - against * rub) / self.length - against * t.run_brake;
        match accel * against < 0.0 {
            // The pull is larger by less than rounding can tell.
            true if slip == 0.0 => Law::REST,
            true => Law {
                accel,
                until: Some(self.belt),
            },
            false => Law { accel, until: None },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ground that rises so many steps on so many.
    fn ground(rise: i32, run: i32, traits: Traits, t: &Motion) -> Footing {
        Footing::of((run.into(), rise.into()), &traits, t)
    }

    fn running(run: f64) -> Control {
        Control {
            run,
            ..Control::default()
        }
    }

    fn law(accel: f64, until: f64) -> Law {
        Law {
            accel,
            until: Some(until),
        }
    }

    #[test]
    fn a_run_brakes_turns_and_never_clips() {
        let t = Motion::default();
        let level = ground(0, 1, Traits::default(), &t);
        let at = |speed: f64, run: f64| level.law(speed, &running(run), false, &t);
        assert_eq!(at(0.0, 1.0), law(t.run_accel, 8.0));
        assert_eq!(at(-2.0, 1.0), law(t.run_brake, 0.0));
        assert_eq!(at(9.0, 1.0), law(-t.over_speed_decay, 8.0));
        assert_eq!(at(8.0, 1.0), Law::REST);
        assert_eq!(at(0.0, 0.0), Law::REST);
        assert_eq!(at(3.0, 0.0), law(-t.run_brake, 0.0));
    }

    #[test]
    fn a_belt_is_the_ground_that_a_run_counts_from() {
        let t = Motion::default();
        let traits = Traits {
            conveyor: -3.0,
            ..Traits::default()
        };
        let belt = ground(0, 1, traits, &t);
        let at = |speed: f64, run: f64| belt.law(speed, &running(run), false, &t);
        assert_eq!(at(-3.0, 0.0), Law::REST);
        assert_eq!(at(0.0, 0.0), law(-t.run_brake, -3.0));
        assert_eq!(at(-3.0, 1.0), law(t.run_accel, 0.0), "turns");
        assert_eq!(at(0.0, 1.0), law(t.run_accel, 5.0));
        assert_eq!(at(-4.0, 1.0), law(t.run_brake, -3.0));
        assert_eq!(at(2.0, 0.0), law(-t.run_brake, 0.0), "turns");
        assert_eq!(at(5.0, 1.0), Law::REST);
        assert_eq!(belt.steady(&running(-0.5), false, &t), -7.0);
    }

    #[test]
    fn a_law_ends_where_the_speed_turns() {
        let t = Motion::default();
        let traits = Traits {
            conveyor: 3.0,
            ..Traits::default()
        };
        let belt = ground(0, 1, traits, &t);
        let at = |speed: f64| belt.law(speed, &running(-1.0), false, &t);
        assert_eq!(at(2.0), law(-t.run_accel, 0.0));
        assert_eq!(at(0.0), law(-t.run_accel, -5.0));
    }

    /// 3:4:5, 8:15:17, 20:21:29, and one step in a hundred million.
    #[test]
    fn friction_holds_iff_the_slope_is_at_most_its_coefficient() {
        for (rise, run) in [(3, 4), (8, 15), (20, 21), (1, 100_000_000)] {
            let bound = f64::from(rise) / f64::from(run);
            for (friction, holds) in [
                (bound, true),
                (bound.next_up(), true),
                (bound.next_down(), false),
            ] {
                let t = Motion {
                    slope_gravity: 1.0,
                    run_brake: 0.0,
                    friction,
                    ..Motion::default()
                };
                for rise in [rise, -rise] {
                    let slope = ground(rise, run, Traits::default(), &t);
                    let idle = slope.law(0.0, &Control::default(), false, &t);
                    // A pull that differs by less than a unit in the last place may hold too.
                    let held = idle == Law::REST;
                    assert!(held == holds || !holds && idle.accel.abs() < 1e-12);
                    assert!(idle.accel * f64::from(rise) <= 0.0, "never uphill");
                    let wet = Traits {
                        friction: Some(0.5 * bound),
                        ..Traits::default()
                    };
                    let slope = ground(rise, run, wet, &t);
                    let idle = slope.law(0.0, &Control::default(), false, &t);
                    assert!(idle.accel * f64::from(rise) < 0.0 && idle.until.is_none());
                }
            }
        }
    }

    #[test]
    fn a_slope_changes_the_wished_speed_by_its_sine() {
        let t = Motion {
            slope_speed: 0.5,
            ..Motion::default()
        };
        let slope = ground(3, 4, Traits::default(), &t);
        let wish = |run: f64| slope.steady(&running(run), false, &t);
        assert_eq!(wish(1.0), 8.0 * 0.7);
        assert_eq!(wish(-1.0), -8.0 * 1.3);
    }
}
