//! The music: which piece the place has, and how loud its layers are, by what one does and what is near.

use super::machines::Bounds;
use super::place::mood;
use super::{Cue, Layer, Moment, Piece, Sound};
use crate::level::{self, Kind, Mood};
use glam::DVec2;

/// Speed at which one moves as much as one can, m/s.
const BUSY: f64 = 6.0;
/// Seconds in which the pulse follows who begins to move, and who rests.
const WAKE: f64 = 2.5;
const REST: f64 = 9.0;
/// Danger is near within the second of these distances, and as near as it gets within the first, m.
const DANGER: (f64, f64) = (2.5, 9.0);
/// Seconds in which tension follows danger that comes, and danger that is past.
const ALARM: f64 = 1.2;
const RELIEF: f64 = 5.0;
/// What a death leaves of the music, and in how many seconds it comes back.
const MOURNING: f64 = 0.25;
const RECOVERY: f64 = 3.0;
/// What the bells of a checkpoint or a hidden place leave of it.
const TOLLING: f64 = 0.5;
/// What the goal leaves of it, so that its bells are heard.
const TRIUMPH: f64 = 0.2;

/// The music from now on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Music {
    /// What is played.
    pub piece: Piece,
    /// Amplitude of every layer, in the order of [`Layer::ALL`].
    pub layers: [f32; 4],
    /// Amplitude of the whole: less while something else must be heard.
    pub duck: f32,
}

impl Music {
    /// Before anything is played, as behind a title: what the place has to tell, and nobody moves.
    pub const TITLE: Music = Music {
        piece: Piece::Dusk,
        layers: [1.0, 0.0, 0.8, 0.0],
        duck: 0.8,
    };
}

/// What the music remembers.
#[derive(Clone, Debug)]
pub struct Score {
    /// What kills and stands still.
    hazards: Vec<Bounds>,
    /// What kills and moves, by the number of its mover, as it is drawn: hazards, and iron that stamps.
    moving: Vec<(usize, Bounds)>,
    busy: f64,
    danger: f64,
    duck: f64,
}

impl Score {
    /// Of a level.
    pub fn new(level: &level::Level) -> Score {
        let kills = |f: &&level::Feature| f.kind == Kind::Hazard;
        let hazards = level.features.iter().filter(kills);
        let movers = level.movers.iter().enumerate();
        let moving = movers.flat_map(|(i, mover)| {
            let parts = mover.features.iter().filter(kills);
            let parts = parts.chain(mover.crushers());
            parts.map(move |f| (i, Bounds::of([f])))
        });
        Score {
            hazards: hazards.map(|f| Bounds::of([f])).collect(),
            moving: moving.collect(),
            busy: 0.0,
            danger: 0.0,
            duck: 1.0,
        }
    }

    /// The music after a tick.
    pub fn hear(&mut self, moment: &Moment, cues: &[Cue]) -> Music {
        let (now, span) = (moment.now, moment.span().max(0.0));
        let follow = |value: &mut f64, wanted: f64, rise: f64, fall: f64| {
            let time = if wanted > *value { rise } else { fall };
            *value += (wanted - *value) * (1.0 - (-span / time).exp());
        };
        let pace = (now.velocity.length() / BUSY).min(1.0);
        let near = self.danger(moment);
        follow(&mut self.busy, pace, WAKE, REST);
        follow(&mut self.danger, near, ALARM, RELIEF);
        if now.deaths > moment.before.deaths {
            self.duck = MOURNING;
        }
        let tolls = |cue: &Cue| matches!(cue.sound, Sound::Checkpoint | Sound::Secret);
        if cues.iter().any(tolls) {
            self.duck = self.duck.min(TOLLING);
        }
        let whole = if now.won_at.is_some() { TRIUMPH } else { 1.0 };
        follow(&mut self.duck, whole, RECOVERY, 0.3);
        let mood = mood(moment);
        let (piece, pulse, melody) = match mood {
            Mood::Dusk => (Piece::Dusk, 0.7, 1.0),
            Mood::Summit => (Piece::Dusk, 1.0, 1.0),
            Mood::Works => (Piece::Deep, 1.0, 0.8),
            Mood::Depths => (Piece::Deep, 0.5, 0.9),
        };
        let mut layers = [0.0; 4];
        layers[Layer::Pad as usize] = 1.0;
        layers[Layer::Pulse as usize] = (pulse * self.busy) as f32;
        layers[Layer::Melody as usize] = (melody * (1.0 - 0.6 * self.danger)) as f32;
        layers[Layer::Tension as usize] = self.danger as f32;
        Music {
            piece,
            layers,
            duck: self.duck as f32,
        }
    }

    /// How near danger is: 0 far, 1 close by. Several dangers are more than one, and never more than 1.
    fn danger(&self, moment: &Moment) -> f64 {
        let (hero, time) = (moment.now.position, moment.now.time);
        let movers = &moment.world.land(0).movers;
        let offset = |i: usize| {
            let mover = movers.get(i);
            mover.map_or(DVec2::ZERO, |mover| mover.piece_at(time).offset(time))
        };
        let still = self.hazards.iter().map(|&b| (b, DVec2::ZERO));
        let moving = self.moving.iter().map(|&(i, b)| (b, offset(i)));
        let safety = still.chain(moving).map(|(bounds, offset)| {
            let distance = bounds.nearest(offset, hero).distance(hero);
            1.0 - ((DANGER.1 - distance) / (DANGER.1 - DANGER.0)).clamp(0.0, 1.0)
        });
        1.0 - safety.product::<f64>()
    }
}
