//! Light and air of an area: the colours of sun, sky and haze, and what floats about.

use crate::level::{self, Area, Rect};
use glam::{Vec2, Vec3, Vec4};

/// Metres beside an area over which its mood gives way to another's.
const BORDER: f32 = 9.0;

/// Light and air. Colours are linear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mood {
    /// The key light.
    pub key: Vec3,
    /// Light from above, and how much of the leaves there is, 0 to 1.
    pub sky: Vec4,
    /// Light from below, and how much of the dust.
    pub ground: Vec4,
    /// The distance, and how thick the haze is, per metre.
    pub cool: Vec4,
    /// The distance where the sun has gone, and how much thicker the haze is low over the water.
    pub warm: Vec4,
    /// The sky above, and how many of the embers fly.
    pub zenith: Vec4,
    /// The sky between horizon and zenith, and how many of the stars are out.
    pub rose: Vec4,
    /// Clouds away from the sun, and by how much everything is exposed.
    pub cloud: Vec4,
}

/// The quarry under the open sky: a burning horizon through rose to a deep blue.
const DUSK: Mood = Mood {
    key: Vec3::new(2.35, 1.38, 0.74),
    sky: Vec4::new(0.22, 0.33, 0.52, 0.55),
    ground: Vec4::new(0.07, 0.10, 0.13, 0.8),
    cool: Vec4::new(0.150, 0.205, 0.310, 0.0112),
    warm: Vec4::new(1.05, 0.47, 0.19, 0.010),
    zenith: Vec4::new(0.045, 0.085, 0.21, 0.35),
    rose: Vec4::new(0.46, 0.23, 0.30, 0.15),
    cloud: Vec4::new(0.17, 0.13, 0.22, 1.0),
};

/// Wet machines in green haze, lit by what is left of the sun and by sparks.
const WORKS: Mood = Mood {
    key: Vec3::new(1.75, 1.15, 0.62),
    sky: Vec4::new(0.17, 0.33, 0.38, 0.06),
    ground: Vec4::new(0.06, 0.12, 0.12, 1.0),
    cool: Vec4::new(0.110, 0.205, 0.225, 0.0190),
    warm: Vec4::new(0.66, 0.42, 0.19, 0.016),
    zenith: Vec4::new(0.03, 0.085, 0.12, 1.0),
    rose: Vec4::new(0.23, 0.26, 0.25, 0.0),
    cloud: Vec4::new(0.10, 0.14, 0.15, 1.08),
};

/// Night under the rock: little but the lanterns.
const DEPTHS: Mood = Mood {
    key: Vec3::new(0.50, 0.56, 0.86),
    sky: Vec4::new(0.12, 0.15, 0.29, 0.08),
    ground: Vec4::new(0.05, 0.06, 0.11, 0.9),
    cool: Vec4::new(0.034, 0.048, 0.100, 0.0200),
    warm: Vec4::new(0.15, 0.095, 0.15, 0.010),
    zenith: Vec4::new(0.012, 0.018, 0.055, 0.45),
    rose: Vec4::new(0.075, 0.062, 0.14, 0.9),
    cloud: Vec4::new(0.035, 0.035, 0.070, 1.22),
};

/// Above it all: clear, cold, far to see.
const SUMMIT: Mood = Mood {
    key: Vec3::new(2.30, 1.72, 1.22),
    sky: Vec4::new(0.29, 0.43, 0.70, 0.40),
    ground: Vec4::new(0.12, 0.15, 0.22, 0.4),
    cool: Vec4::new(0.270, 0.390, 0.600, 0.0080),
    warm: Vec4::new(1.15, 0.70, 0.40, 0.005),
    zenith: Vec4::new(0.055, 0.150, 0.420, 0.05),
    rose: Vec4::new(0.45, 0.47, 0.66, 0.35),
    cloud: Vec4::new(0.52, 0.54, 0.66, 0.98),
};

impl Mood {
    /// The palette of a level's mood.
    pub fn of(mood: level::Mood) -> Mood {
        match mood {
            level::Mood::Dusk => DUSK,
            level::Mood::Works => WORKS,
            level::Mood::Depths => DEPTHS,
            level::Mood::Summit => SUMMIT,
        }
    }

    /// The mood at a place: that of the area around it, and near its sides partly that of the next. Away from all areas
    /// it is that of the area `last`; without areas, dusk.
    pub fn at(areas: &[Area], place: Vec2, last: usize) -> Mood {
        let (mut sum, mut left) = (0.0, 1.0);
        let mut mood = areas.get(last).map_or(DUSK, |area| Mood::of(area.mood));
        for area in areas {
            let share = (0.5 + inside(&area.room, place) / BORDER).clamp(0.0, 1.0);
            let weight = left * share * share * (3.0 - 2.0 * share);
            if weight > 0.0 {
                sum += weight;
                left -= weight;
                mood = mood.towards(Mood::of(area.mood), weight / sum);
            }
        }
        mood
    }

    /// Part of the way to another mood.
    fn towards(self, other: Mood, share: f32) -> Mood {
        let mix = |a: Vec4, b: Vec4| a.lerp(b, share);
        Mood {
            key: self.key.lerp(other.key, share),
            sky: mix(self.sky, other.sky),
            ground: mix(self.ground, other.ground),
            cool: mix(self.cool, other.cool),
            warm: mix(self.warm, other.warm),
            zenith: mix(self.zenith, other.zenith),
            rose: mix(self.rose, other.rose),
            cloud: mix(self.cloud, other.cloud),
        }
    }

    /// The vectors of the shaders' frame block; the key light's last number is left to the frame.
    pub fn vectors(&self) -> [Vec4; 8] {
        [
            self.key.extend(0.0),
            self.sky,
            self.ground,
            self.cool,
            self.warm,
            self.zenith,
            self.rose,
            self.cloud,
        ]
    }
}

/// How far inside a room a place is, in metres; negative outside.
fn inside(room: &Rect, place: Vec2) -> f32 {
    let beyond = (room.min.as_vec2() - place).max(place - room.max.as_vec2());
    match beyond.max_element() <= 0.0 {
        true => -beyond.max_element(),
        false => -beyond.max(Vec2::ZERO).length(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn area(from: f64, to: f64, mood: level::Mood) -> Area {
        let room = Rect {
            min: DVec2::new(from, -50.0),
            max: DVec2::new(to, 50.0),
        };
        Area {
            name: "somewhere".into(),
            room,
            mood,
        }
    }

    #[test]
    fn moods_blend_over_the_border_and_nowhere_else() {
        let areas = [
            area(0.0, 100.0, level::Mood::Works),
            area(100.0, 200.0, level::Mood::Summit),
        ];
        let at = |x: f32| Mood::at(&areas, Vec2::new(x, 0.0), 0);
        assert_eq!((at(50.0), at(150.0)), (WORKS, SUMMIT));
        let red: Vec<f32> = (90..110).map(|x| at(x as f32).key.x).collect();
        assert!(
            red.windows(2)
                .all(|pair| (0.0..0.2).contains(&(pair[1] - pair[0]))),
            "{red:?}"
        );
        assert!(red[10] > WORKS.key.x && red[10] < SUMMIT.key.x);
    }

    #[test]
    fn somebody_lost_keeps_the_last_mood() {
        let areas = [area(0.0, 10.0, level::Mood::Depths)];
        assert_eq!(Mood::at(&areas, Vec2::splat(900.0), 0), DEPTHS);
        assert_eq!(Mood::at(&[], Vec2::ZERO, 3), DUSK);
    }
}
