//! Where the hero is: wind by the mood of the area, water by its distance, lamps, drops in the depths.

use super::ear::{Chance, share_of};
use super::{Cue, LOOPS, Level, Loop, Moment, Sound};
use crate::level::{self, Mood, SceneryKind};
use glam::DVec2;

/// Height of the water above the level's bottom, as it is drawn, m.
const WATER: f64 = 1.2;
/// The hero's own lamp, as a share of one that he stands before.
const OWN_LAMP: f64 = 0.12;
/// Height of a lamp's flame above its foot, m.
const FLAME: f64 = 1.8;
/// Lamps are soft: they are heard from so much nearer than machines.
const SOFT: f64 = 3.0;
/// Seconds after which a drop may fall in the depths, and how often it does.
const DROP: f64 = 0.7;
const DROPS: f64 = 0.3;
/// How far to the sides drops fall, m.
const CAVE: f64 = 14.0;
/// Seconds in which the place changes around who comes from one area into another.
const CHANGE: f64 = 1.5;

/// Amplitude of wind and water in a mood.
fn air(mood: Mood) -> (f64, f64) {
    match mood {
        Mood::Dusk => (0.7, 1.0),
        Mood::Works => (0.35, 1.0),
        Mood::Depths => (0.12, 0.8),
        Mood::Summit => (1.0, 0.5),
    }
}

/// The mood of the area that the hero is in.
pub fn mood(moment: &Moment) -> Mood {
    let areas = &moment.world.stage().level.areas;
    areas
        .get(moment.now.area)
        .map(|area| area.mood)
        .unwrap_or_default()
}

/// What is known of the place, and how it sounds just now.
#[derive(Clone, Debug)]
pub struct Place {
    lamps: Vec<DVec2>,
    air: Option<(f64, f64)>,
    chance: Chance,
}

impl Place {
    /// A level's.
    pub fn new(level: &level::Level) -> Place {
        use SceneryKind::{Lantern, LanternHanging, LanternWall};
        let burns = |kind| matches!(kind, Lantern | LanternHanging | LanternWall);
        let lamps = level.scenery.iter().filter(|s| burns(s.kind));
        let flame = |s: &level::Scenery| match s.kind {
            Lantern => s.at + DVec2::Y * FLAME * s.scale,
            _ => s.at,
        };
        Place {
            lamps: lamps.map(flame).collect(),
            air: None,
            chance: Chance::default(),
        }
    }

    /// The sounds of a tick.
    pub fn hear(&mut self, moment: &Moment, cues: &mut Vec<Cue>, loops: &mut [Level; LOOPS]) {
        let mood = mood(moment);
        let wanted = air(mood);
        let share = 1.0 - (-moment.span() / CHANGE).exp();
        let (wind, water) = self.air.unwrap_or(wanted);
        let air = (
            wind + (wanted.0 - wind) * share,
            water + (wanted.1 - water) * share,
        );
        self.air = Some(air);
        loops[Loop::Wind.slot()] = Level::of(air.0);
        let surface = moment.world.stage().level.bottom + WATER;
        let below = DVec2::new(moment.ear.at.x, surface.min(moment.ear.at.y));
        loops[Loop::Water.slot()] = Level::of(air.1 * moment.ear.gain(below));
        self.hear_lamps(moment, loops);
        if mood == Mood::Depths {
            self.hear_drops(moment, cues);
        }
    }

    /// The nearest of them.
    fn hear_lamps(&self, moment: &Moment, loops: &mut [Level; LOOPS]) {
        let hero = moment.now.position;
        let far = |lamp: &&DVec2| lamp.distance_squared(hero);
        let nearest = self.lamps.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
        let hum = &mut loops[Loop::Hum.slot()];
        *hum = Level::of(OWN_LAMP);
        if let Some(&lamp) = nearest {
            // Heard as if it were farther away than it is.
            let place = moment.ear.at + (lamp - hero) * SOFT;
            hum.raise(moment.ear.level(place, 1.0, 1.0));
        }
    }

    /// In some of the moments in which one may fall, somewhere around.
    fn hear_drops(&mut self, moment: &Moment, cues: &mut Vec<Cue>) {
        let turn = |time: f64| (time / DROP).floor();
        let now = turn(moment.now.time);
        if now == turn(moment.before.time) || share_of(now as u64) > DROPS {
            return;
        }
        let side = (2.0 * self.chance.share() - 1.0) * CAVE;
        let place = moment.ear.at + DVec2::new(side, 0.0);
        let drop = moment.ear.cue(Sound::Drip, place, 1.0, now * DROP);
        cues.push(self.chance.vary(drop));
    }
}
