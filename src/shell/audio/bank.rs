//! All sounds and loops, decoded: what is missing or broken is left out, and told.

use super::decode;
use crate::cli::files::{self, FileError};
use crate::sound::{Loop, Sound};
use kira::Frame;
use std::path::Path;
use std::sync::Arc;

/// Where sounds are.
pub const SOUNDS: &str = "assets/sounds";

/// A decoded sound, shared by all that play it.
pub type Frames = Arc<[Frame]>;

/// What can be played.
#[derive(Default)]
pub struct Bank {
    sounds: Vec<Vec<Option<Frames>>>,
    loops: Vec<Option<Frames>>,
    /// What could not be loaded, and why.
    pub problems: Vec<FileError>,
}

impl Bank {
    /// Decodes everything in the game's own folder.
    pub fn load() -> Bank {
        Bank::load_from(&files::find(Path::new(SOUNDS)))
    }

    /// Decodes everything in a folder.
    pub fn load_from(folder: &Path) -> Bank {
        let mut bank = Bank::default();
        if let Err(error) = std::fs::read_dir(folder) {
            // Said once, not of each file in it.
            let reason = format!("cannot be read: {error}");
            bank.problems.push(FileError::new(folder, reason));
            return bank;
        }
        for sound in Sound::ALL {
            let all = (0..sound.variants()).map(|variant| folder.join(sound.file(variant)));
            let decoded = all.map(|path| bank.keep(decode::decode(&path))).collect();
            bank.sounds.push(decoded);
        }
        for which in Loop::ALL {
            let decoded = bank.keep(decode::decode_loop(&folder.join(which.file())));
            bank.loops.push(decoded);
        }
        bank
    }

    /// What was decoded, or the problem for later.
    fn keep(&mut self, decoded: Result<Vec<Frame>, FileError>) -> Option<Frames> {
        match decoded {
            Ok(frames) => Some(frames.into()),
            Err(error) => {
                self.problems.push(error);
                None
            }
        }
    }

    /// A variation of a sound, or any other of them that there is.
    pub fn sound(&self, sound: Sound, variant: u8) -> Option<&Frames> {
        let all = self.sounds.get(sound as usize)?;
        let wanted = all.get(variant as usize).and_then(Option::as_ref);
        wanted.or_else(|| all.iter().flatten().next())
    }

    /// A loop.
    pub fn looped(&self, which: Loop) -> Option<&Frames> {
        self.loops.get(which as usize)?.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_that_is_missing_is_told_once() {
        let bank = Bank::load_from(Path::new("no/such/folder"));
        let told: Vec<String> = bank.problems.iter().map(ToString::to_string).collect();
        assert!(
            matches!(told.as_slice(), [one] if one.starts_with("no/such/folder: cannot be read")),
            "{told:?}"
        );
        assert!(bank.sound(Sound::StepRock, 0).is_none() && bank.looped(Loop::Belt).is_none());
    }
}
