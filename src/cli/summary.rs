//! What a run came to: printed after a headless replay and when a game is left.

use crate::game::{View, World};

/// The outcome of a run, gathered tick by tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// The level's name.
    pub level: String,
    /// Ticks done, at so many per second.
    pub ticks: u64,
    /// Ticks per second.
    pub tick_rate: u32,
    /// How the run ended.
    pub last: View,
    /// Greatest height of the hero's foot above its start, in metres.
    pub highest: f64,
    /// The final state's hash.
    pub hash: u64,
    /// How many secrets the level has.
    pub secrets: usize,
    start: f64,
}

impl Summary {
    /// Of a run that has not begun.
    pub fn new(world: &World) -> Summary {
        Summary {
            level: world.stage().level.name.clone(),
            ticks: world.tick(),
            tick_rate: world.tick_rate(),
            last: world.view(),
            highest: 0.0,
            hash: world.hash(),
            secrets: world.stage().secret_count(),
            start: world.stage().level.start.y,
        }
    }

    /// Takes note of the state after a tick.
    pub fn watch(&mut self, world: &World) {
        self.last = world.view();
        self.ticks = world.tick();
        self.hash = world.hash();
        self.highest = self.highest.max(world.highest() - self.start);
    }
}

impl std::fmt::Display for Summary {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        let View {
            time,
            position,
            won_at,
            deaths,
            secrets,
            ..
        } = self.last;
        writeln!(f, "level     {}", self.level)?;
        writeln!(
            f,
            "ticks     {} at {} Hz, {time:.3} s",
            self.ticks, self.tick_rate
        )?;
        writeln!(f, "position  {:.6} {:.6} m", position.x, position.y)?;
        writeln!(f, "highest   {:.3} m above the start", self.highest)?;
        writeln!(f, "deaths    {deaths}")?;
        writeln!(f, "secrets   {secrets} of {}", self.secrets)?;
        match won_at {
            Some(_) => writeln!(f, "goal      reached after {:.3} s", self.last.run_time())?,
            None => writeln!(f, "goal      not reached")?,
        }
        write!(f, "hash      {:016x}", self.hash)
    }
}
