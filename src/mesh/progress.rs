//! How far long work is, for those who wait for it, and whether they still do. Nothing that is made depends on it.

use std::sync::atomic::{AtomicU8, AtomicU32, Ordering};

/// What is being done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Phase {
    /// A file is read and checked.
    #[default]
    Reading,
    /// Edges are tested against each other.
    Crossing,
    /// Edges are led through the hot pixels that they meet.
    Snapping,
    /// Vertices and edges go into the triangulation.
    Triangulating,
    /// Faces get to know what covers them.
    Covering,
}

impl Phase {
    const ALL: [Phase; 5] = [
        Phase::Reading,
        Phase::Crossing,
        Phase::Snapping,
        Phase::Triangulating,
        Phase::Covering,
    ];
}

/// Shared between who works and who waits.
#[derive(Debug)]
pub struct Progress {
    /// What is done, in millionths.
    share: AtomicU32,
    phase: AtomicU8,
    /// What is waited for, in millionths.
    until: AtomicU32,
}

impl Default for Progress {
    fn default() -> Progress {
        Progress {
            share: AtomicU32::default(),
            phase: AtomicU8::default(),
            until: AtomicU32::new(u32::MAX),
        }
    }
}

impl Progress {
    /// How much is done, 0 to 1; it never becomes less.
    pub fn share(&self) -> f32 {
        self.share.load(Ordering::Relaxed) as f32 * 1e-6
    }

    /// What is being done.
    pub fn phase(&self) -> Phase {
        let phase = usize::from(self.phase.load(Ordering::Relaxed));
        Phase::ALL.get(phase).copied().unwrap_or_default()
    }

    /// Nobody waits any more: the work ends soon, unfinished.
    pub fn leave(&self) {
        self.leave_at(0.0);
    }

    /// Nobody waits any more when so much is done.
    pub fn leave_at(&self, share: f32) {
        self.until.store(millionths(share), Ordering::Relaxed);
    }
}

fn millionths(share: f32) -> u32 {
    (share * 1e6) as u32
}

/// Nobody waits any more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Left;

/// A part of long work: from one share of the whole to another.
#[derive(Clone, Copy, Debug)]
pub struct Part<'a> {
    progress: Option<&'a Progress>,
    from: f32,
    to: f32,
}

impl<'a> Part<'a> {
    /// Work that nobody watches.
    pub const UNSEEN: Part<'static> = Part {
        progress: None,
        from: 0.0,
        to: 1.0,
    };

    /// All of it.
    pub fn whole(progress: &'a Progress) -> Part<'a> {
        Part {
            progress: Some(progress),
            ..Part::UNSEEN
        }
    }

    /// A part of this part, between two shares of it.
    pub fn between(self, from: f32, to: f32) -> Part<'a> {
        let share = |s: f32| self.from + (self.to - self.from) * s;
        Part {
            from: share(from),
            to: share(to),
            ..self
        }
    }

    /// Begins it.
    ///
    /// # Errors
    /// Nobody waits for it any more.
    pub fn begin(self, phase: Phase) -> Result<(), Left> {
        if let Some(progress) = self.progress {
            progress.phase.store(phase as u8, Ordering::Relaxed);
        }
        self.done(0, 1)
    }

    /// Says that so many of so many are done.
    ///
    /// # Errors
    /// Nobody waits for it any more.
    #[inline]
    pub fn done(self, count: usize, of: usize) -> Result<(), Left> {
        match self.progress {
            None => Ok(()),
            Some(progress) => {
                let share = self.from + (self.to - self.from) * count as f32 / of.max(1) as f32;
                let done = millionths(share);
                progress.share.fetch_max(done, Ordering::Relaxed);
                match done < progress.until.load(Ordering::Relaxed) {
                    true => Ok(()),
                    false => Err(Left),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_parts_add_up_and_never_go_back() {
        let progress = Progress::default();
        let half = Part::whole(&progress).between(0.5, 1.0);
        half.begin(Phase::Snapping).unwrap();
        assert_eq!((progress.share(), progress.phase()), (0.5, Phase::Snapping));
        half.between(0.0, 0.5).done(1, 2).unwrap();
        assert!((progress.share() - 0.625).abs() < 1e-5);
        half.done(0, 10).unwrap();
        assert!((progress.share() - 0.625).abs() < 1e-5);
        progress.leave();
        assert_eq!(half.done(1, 1), Err(Left));
        assert_eq!(Part::UNSEEN.done(1, 1), Ok(()));
        for (i, phase) in Phase::ALL.into_iter().enumerate() {
            assert_eq!(phase as usize, i);
        }
    }
}
