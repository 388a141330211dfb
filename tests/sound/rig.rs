//! A run that is listened to, in levels made of a few boxes.

use edgewalker::game::{Input, Stage, World};
use edgewalker::level::{By, Feature, Kind, Level, Material, Mover, Rect};
use edgewalker::sound::{Cue, Ear, Heard, LOOPS, Loop, Moment, Sound, Soundscape};
use edgewalker::tune::Tuning;
use glam::DVec2;
use std::sync::Arc;

const RATE: u32 = 120;

pub fn block(id: &str, material: Material, (x0, y0): (f64, f64), (x1, y1): (f64, f64)) -> Feature {
    Feature {
        id: id.into(),
        material,
        outline: [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
            .map(DVec2::from)
            .to_vec(),
        ..Feature::default()
    }
}

pub fn region(id: &str, kind: Kind, x: f64) -> Feature {
    Feature {
        kind,
        by: Some(By::Foot),
        ..block(id, Material::Rock, (x, -0.5), (x + 1.0, 3.0))
    }
}

/// A level with its start at the origin.
pub fn level(features: Vec<Feature>, movers: Vec<Mover>) -> Level {
    Level {
        version: 1,
        name: "Sounds".into(),
        start: DVec2::ZERO,
        goal: Rect {
            min: DVec2::new(180.0, -0.5),
            max: DVec2::new(181.0, 3.0),
        },
        bottom: -20.0,
        features,
        movers,
        areas: Vec::new(),
        frames: Vec::new(),
        prompts: Vec::new(),
        scenery: Vec::new(),
    }
}

/// A long floor.
pub fn floor(material: Material) -> Feature {
    block("floor", material, (-60.0, -1.0), (170.0, 0.0))
}

/// A run that is listened to.
pub struct Run {
    pub world: World,
    pub scape: Soundscape,
    pub cues: Vec<Cue>,
    /// Of every tick: its end, and how loud the loops are.
    pub loops: Vec<(f64, [f32; LOOPS])>,
    /// What the loops have come to.
    pub levels: [edgewalker::sound::Level; LOOPS],
    pub layers: [f32; 4],
    pub duck: f32,
    pub ear: Option<DVec2>,
}

impl Run {
    pub fn new(level: Level) -> Run {
        let world = World::new(Arc::new(Stage::build(level).unwrap()), RATE, 0);
        Run {
            scape: Soundscape::new(&world),
            world,
            cues: Vec::new(),
            loops: Vec::new(),
            levels: [edgewalker::sound::Level::SILENT; LOOPS],
            layers: [0.0; 4],
            duck: 1.0,
            ear: None,
        }
    }

    pub fn step(&mut self, input: Input) {
        let before = self.world.view();
        self.world.step(input, &Tuning::default());
        let now = self.world.view();
        let moment = Moment {
            world: &self.world,
            before: &before,
            now: &now,
            ear: Ear {
                at: self.ear.unwrap_or(now.position),
            },
        };
        let Heard { cues, loops, music } = self.scape.tick(&moment);
        for cue in cues {
            assert!(cue.gain > 0.0 && cue.gain < 2.0, "{cue:?}");
            assert!(
                cue.pan.abs() <= 1.0 && (0.5..2.0).contains(&cue.pitch),
                "{cue:?}"
            );
            assert!(cue.variant < cue.sound.variants(), "{cue:?}");
            assert!(cue.at > before.time - 1e-9, "{cue:?} is late");
        }
        self.cues.extend(cues);
        self.loops.push((now.time, loops.map(|level| level.gain)));
        self.levels = *loops;
        (self.layers, self.duck) = (music.layers, music.duck);
    }

    /// Plays for so many seconds, to the right (1), to the left (-1) or at rest (0).
    pub fn play(&mut self, seconds: f64, run: i8) -> &mut Run {
        let end = self.world.time() + seconds;
        while self.world.time() < end - 1e-9 {
            self.step(Input {
                run: 127 * run,
                ..Input::default()
            });
        }
        self
    }

    pub fn heard(&self, sound: Sound) -> Vec<Cue> {
        self.cues
            .iter()
            .copied()
            .filter(|cue| cue.sound == sound)
            .collect()
    }

    pub fn loudest(&self, which: Loop) -> f32 {
        let gains = self
            .loops
            .iter()
            .flat_map(|(_, gains)| &gains[which.slots()]);
        gains.copied().fold(0.0, f32::max)
    }
}
