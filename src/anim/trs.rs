//! Translation, rotation, scale: where one bone is in the space of the bone above it.

use glam::{Mat4, Quat, Vec3};

/// A place, a turn and a size, applied in the opposite order: first the size, last the place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trs {
    /// Metres.
    pub place: Vec3,
    /// A unit quaternion.
    pub turn: Quat,
    /// Factors along the bone's own axes.
    pub size: Vec3,
}

impl Trs {
    /// Changes nothing.
    pub const IDENTITY: Trs = Trs {
        place: Vec3::ZERO,
        turn: Quat::IDENTITY,
        size: Vec3::ONE,
    };

    /// A share (0 to 1) of the way to another; turns go the short way round.
    pub fn lerp(&self, to: &Trs, share: f32) -> Trs {
        Trs {
            place: self.place.lerp(to.place, share),
            turn: blend_turns(self.turn, to.turn, share),
            size: self.size.lerp(to.size, share),
        }
    }

    /// As a matrix.
    pub fn matrix(&self) -> Mat4 {
        Mat4::from_scale_rotation_translation(self.size, self.turn, self.place)
    }

    /// Whether all numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.place.is_finite() && self.turn.is_finite() && self.size.is_finite()
    }
}

/// A share of the way between two turns, along the chord: nearly even for the small angles between keys, and cheap.
pub fn blend_turns(from: Quat, to: Quat, share: f32) -> Quat {
    let to = if from.dot(to) < 0.0 { -to } else { to };
    (from * (1.0 - share) + to * share).normalize()
}

/// The angle between two turns, in radians.
pub fn angle_between(a: Quat, b: Quat) -> f32 {
    // By the difference's length rather than the cosine, which is blind to small angles.
    let b = if a.dot(b) < 0.0 { -b } else { b };
    4.0 * ((a - b).length() / 2.0).min(1.0).asin()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_short_way_is_taken() {
        let (a, b) = (Quat::from_rotation_y(0.2), Quat::from_rotation_y(1.0));
        let middle = Quat::from_rotation_y(0.6);
        for to in [b, -b] {
            assert!(angle_between(blend_turns(a, to, 0.5), middle) < 1e-6);
        }
        assert!((angle_between(a, -b) - 0.8).abs() < 1e-6);
    }
}
