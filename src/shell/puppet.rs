//! The hero's figure in a world that is played: fed with what happens at each tick, shown between two of them.

use crate::anim::{Figure, Rig, Shown};
use crate::cli::files::{self, FileError};
use crate::game::{Sights, Soles, View, World};
use std::path::Path;
use std::sync::Arc;

/// The hero's model.
pub const MODEL: &str = "assets/models/hero.glb";

/// Reads the hero's model.
///
/// # Errors
/// The file is missing, or no such model; names what is wrong with which part of it.
pub fn load(path: &Path) -> Result<Arc<Rig>, FileError> {
    let bytes = files::read(path)?;
    let rig = Rig::read(&path.display().to_string(), &bytes);
    rig.map(Arc::new).map_err(|error| {
        let named = !error.part.is_empty();
        let part = if named {
            format!("{}: ", error.part)
        } else {
            String::new()
        };
        FileError::new(path, part + &error.why)
    })
}

/// The figure, and what it needs to know of its world.
pub struct Puppet {
    rig: Arc<Rig>,
    soles: Soles,
    sights: Sights,
    figure: Figure,
    before: Shown,
    /// The figure that died last, where that was.
    struck: Option<Figure>,
}

impl Puppet {
    /// The figure in a world, as if it had been there for long.
    pub fn new(rig: &Arc<Rig>, world: &World) -> Puppet {
        let mut soles = Soles::of(world.stage());
        soles.follow(world);
        let figure = Figure::new(&world.view().moves(0.0, None), rig, &soles);
        Puppet {
            rig: Arc::clone(rig),
            sights: Sights::of(world.stage()),
            before: *figure.shown(),
            soles,
            figure,
            struck: None,
        }
    }

    /// What the world did in a tick, and where the player asks to look.
    pub fn tick(&mut self, world: &World, view: &View, look: f64) {
        self.soles.follow(world);
        let sight = self.sights.near(view.position);
        let moves = view.moves(look, sight);
        let deaths = self.figure.moves().deaths;
        self.before = *self.figure.shown();
        if deaths != view.deaths {
            self.struck = Some(self.figure);
            self.struck.iter_mut().for_each(|f| f.strike(&self.rig));
        }
        self.figure.advance(&moves, &self.rig, &self.soles);
        let far = self.before.foot.distance(view.position) > 2.0;
        if deaths != view.deaths || far {
            self.before = *self.figure.shown();
        }
    }

    /// Lets the figure that died last go down for so many seconds more.
    pub fn fall(&mut self, seconds: f64) {
        let struck = self.struck.iter_mut();
        struck.for_each(|figure| figure.fall(seconds, &self.rig, &self.soles));
    }

    /// The figure that died last.
    pub fn struck(&self) -> Option<Shown> {
        self.struck.map(|figure| *figure.shown())
    }

    /// The figure at a share (0 to 1) of the way from the last tick but one to the last.
    pub fn shown(&self, share: f64) -> Shown {
        self.figure.shown().since(&self.before, share)
    }
}
