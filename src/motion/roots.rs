//! Closed forms for the time at which a quadratic changes sign.

/// When f(t) = c + b t + e t^2, the signed distance to a line, goes from positive to negative.
///
/// `now` is the time up to which the motion is known to be on the positive side: the discrete place says so,
/// whatever rounding makes of f. A touch without crossing is none. `None` if it never leaves.
///
/// The exit is the root where the slope b + 2 e t is -sqrt(D), D = b^2 - 4 e c. Of its two algebraically equal forms the
/// one without cancellation is taken (Press et al., Numerical Recipes, 5.6).
///
/// ```
/// // A point at height 1 that falls from rest under 2 m/s^2 reaches the ground after one second.
/// assert_eq!(edgewalker::motion::roots::exit(1.0, 0.0, -1.0, 0.0), Some(1.0));
/// // One that only touches does not leave.
/// assert_eq!(edgewalker::motion::roots::exit(1.0, -2.0, 1.0, 0.0), None);
/// ```
pub fn exit(c: f64, b: f64, e: f64, now: f64) -> Option<f64> {
    if b >= 0.0 && e >= 0.0 {
        return None;
    }
    let d = b * b - 4.0 * e * c;
    let root = if d > 0.0 {
        let sqrt = d.sqrt();
        if b > 0.0 {
            (b + sqrt) / (-2.0 * e)
        } else {
            2.0 * c / (sqrt - b)
        }
    } else if e < 0.0 {
        // On the negative side throughout, by rounding: leaves as soon as it moves outwards.
        b / (-2.0 * e)
    } else {
        return None;
    };
    if root >= now {
        return Some(root);
    }
    (b + 2.0 * e * now < 0.0).then_some(now)
}

/// When u t + a t^2 / 2 first covers the distance `d` >= 0 for a motion in the direction of `d`: u >= 0, and a speed that
/// does not turn before. `None` if it never does.
pub fn cover(d: f64, u: f64, a: f64) -> Option<f64> {
    exit(d, -u, -0.5 * a, 0.0)
}

/// The roots of c + b t + e t^2, each once, in the form without cancellation. What is 0 throughout has none.
pub fn zeros(c: f64, b: f64, e: f64) -> [Option<f64>; 2] {
    if e == 0.0 {
        return [(b != 0.0).then(|| -c / b), None];
    }
    let d = b * b - 4.0 * e * c;
    if d < 0.0 {
        return [None; 2];
    }
    let q = -0.5 * (b + d.sqrt().copysign(b));
    [Some(q / e), (q != 0.0).then(|| c / q)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ceiling_one_step_below_the_apex_is_hit_exactly() {
        // Scene 26: v = 12, g = 32, a ceiling at 2.25 - 2^-16.
        let c = 2.25 - 1.0 / 65536.0;
        assert_eq!(exit(c, -12.0, 16.0, 0.0), Some(0.3740234375));
        assert_eq!(exit(2.25, -12.0, 16.0, 0.0), None);
    }

    #[test]
    fn a_start_on_the_line_leaves_at_once_or_never() {
        assert_eq!(exit(0.0, -1.0, 0.0, 0.0), Some(0.0));
        assert_eq!(exit(0.0, 0.0, -1.0, 0.0), Some(0.0));
        assert_eq!(exit(0.0, 0.0, 0.0, 0.0), None);
        assert_eq!(exit(0.0, 1.0, -1.0, 0.0), Some(1.0));
        assert_eq!(exit(0.0, -1.0, 1.0, 0.0), Some(0.0));
    }

    #[test]
    fn a_side_lost_by_rounding_counts_as_zero() {
        assert_eq!(exit(-1e-17, -1.0, 0.0, 0.0), Some(0.0));
        assert_eq!(exit(-1e-17, 0.0, -1.0, 0.0), Some(0.0));
        assert_eq!(exit(-1e-17, 1.0, 0.0, 0.0), None);
    }

    #[test]
    fn after_the_exit_it_is_either_leaving_or_back() {
        // f = (t - 1)(t - 3): negative between.
        assert_eq!(exit(3.0, -4.0, 1.0, 0.5), Some(1.0));
        assert_eq!(exit(3.0, -4.0, 1.0, 1.5), Some(1.5));
        assert_eq!(exit(3.0, -4.0, 1.0, 3.0), None);
    }

    #[test]
    fn both_roots_of_a_quadratic() {
        let sorted = |c, b, e| {
            let mut found: Vec<f64> = zeros(c, b, e).into_iter().flatten().collect();
            found.sort_by(f64::total_cmp);
            found
        };
        assert_eq!(sorted(3.0, -4.0, 1.0), [1.0, 3.0]);
        assert_eq!(sorted(3.0, 4.0, 1.0), [-3.0, -1.0]);
        assert_eq!(sorted(-4.0, 0.0, 1.0), [-2.0, 2.0]);
        assert_eq!(sorted(6.0, -2.0, 0.0), [3.0]);
        assert!(sorted(1.0, 0.0, 1.0).is_empty() && sorted(0.0, 0.0, 0.0).is_empty());
        // One root of 1e-16 t^2 - t + 1 is next to 1: the other form of it would lose every digit.
        assert!((sorted(1.0, -1.0, 1e-16)[0] - 1.0).abs() < 1e-15);
    }

    #[test]
    fn covering_a_distance() {
        assert_eq!(cover(10.0, 5.0, 0.0), Some(2.0));
        assert_eq!(cover(1.0, 0.0, 2.0), Some(1.0));
        assert_eq!(cover(1.0, 1.0, -1.0), None);
        assert_eq!(cover(0.0, 1.0, 0.0), Some(0.0));
    }
}
