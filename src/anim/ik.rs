//! Two-bone inverse kinematics: how hip and knee turn so that the ankle comes to a place.

use glam::{Quat, Vec3};

/// Share of a leg's length that it is stretched to at most: a knee that is quite straight would jump.
const STRETCH: f32 = 0.999;
/// Share of its length at the end of which it gives way.
const SOFT: f32 = 0.02;

/// A knee that is out of line by less than this share of the upper bone is led forward.
const STRAIGHT: f32 = 0.15;

/// Where a leg's joints are, in one space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limb {
    /// The joint that stays.
    pub hip: Vec3,
    /// The one that bends.
    pub knee: Vec3,
    /// The one that has a goal.
    pub ankle: Vec3,
}

/// The turns, in that space, that bring the ankle to the goal, or as near as the limb reaches: of the upper bone, then of the
/// lower one beside the first. The knee stays on its side; `forward` is that of a limb which is quite straight.
pub fn reach(limb: Limb, lengths: [f32; 2], goal: Vec3, forward: Vec3) -> [Quat; 2] {
    let Limb { hip, knee, ankle } = limb;
    let [upper, lower] = lengths;
    let (nearest, farthest) = (
        (upper - lower).abs() * 1.01 + 1e-3,
        (upper + lower) * STRETCH,
    );
    let was = (ankle - hip).normalize_or(Vec3::NEG_Y);
    let along = (goal - hip).normalize_or(was);
    let way = soften((goal - hip).length(), upper + lower).clamp(nearest, farthest);
    let swing = Quat::from_rotation_arc(was, along);
    let bend = swing * (knee - hip).reject_from_normalized(was);
    let straight = (swing * forward).reject_from_normalized(along);
    // Whatever is left of a bend leads; the hint takes over as it vanishes.
    let aside =
        (bend + straight * (STRAIGHT * upper - bend.length()).max(0.0)).normalize_or(forward);
    let cos = ((upper * upper + way * way - lower * lower) / (2.0 * upper * way)).clamp(-1.0, 1.0);
    let sin = (1.0 - cos * cos).sqrt();
    let bent = hip + (along * cos + aside * sin) * upper;
    let first = arc(knee - hip, bent - hip);
    let second = arc(first * (ankle - knee), hip + along * way - bent);
    [first, second]
}

/// A knee near its end would snap; the last of a limb's length is given out slowly instead.
fn soften(way: f32, length: f32) -> f32 {
    let (start, room) = (length * (STRETCH - SOFT), length * SOFT);
    match way > start {
        true => start + room * (1.0 - (-(way - start) / room).exp()),
        false => way,
    }
}

/// The shortest turn from one direction to another.
pub fn arc(from: Vec3, to: Vec3) -> Quat {
    match (from.try_normalize(), to.try_normalize()) {
        (Some(from), Some(to)) => Quat::from_rotation_arc(from, to),
        _ => Quat::IDENTITY,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn leg(bend: f32) -> Limb {
        Limb {
            hip: Vec3::Y,
            knee: Vec3::new(bend, 0.6, 0.02),
            ankle: Vec3::new(0.0, 0.2, 0.0),
        }
    }

    fn ankle(limb: Limb, [first, second]: [Quat; 2]) -> (Vec3, Vec3) {
        let knee = limb.hip + first * (limb.knee - limb.hip);
        (knee, knee + second * first * (limb.ankle - limb.knee))
    }

    #[test]
    fn the_ankle_comes_to_its_goal_and_the_knee_stays_before_it() {
        for bend in [0.001, 0.05, 0.2] {
            let limb = leg(bend);
            let lengths = [limb.hip.distance(limb.knee), limb.knee.distance(limb.ankle)];
            for goal in [
                (0.3, 0.3, 0.1),
                (-0.4, 0.4, 0.0),
                (0.0, 0.5, -0.1),
                (0.1, 0.3, 0.0),
            ] {
                let goal = Vec3::from(goal);
                let (knee, reached) = ankle(limb, reach(limb, lengths, goal, Vec3::X));
                assert!(reached.distance(goal) < 1e-3, "{goal}: {reached}");
                let middle = (limb.hip + goal) / 2.0;
                assert!((knee - middle).dot(Vec3::X) > -0.05, "{goal}: knee {knee}");
            }
        }
    }

    #[test]
    fn a_goal_out_of_reach_is_pointed_at() {
        let limb = leg(0.1);
        let lengths = [limb.hip.distance(limb.knee), limb.knee.distance(limb.ankle)];
        let (_, reached) = ankle(
            limb,
            reach(limb, lengths, Vec3::new(9.0, 1.0, 0.0), Vec3::X),
        );
        assert!(
            (reached.y - 1.0).abs() < 1e-3 && reached.x > 0.75,
            "{reached}"
        );
        let (_, nowhere) = ankle(limb, reach(limb, lengths, limb.hip, Vec3::X));
        assert!(nowhere.is_finite());
    }
}
