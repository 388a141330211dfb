//! Pictures of a run that nobody waits for: one of a tick, or a film of some seconds.

use super::ShellError;
use super::app::App;
use super::capture;
use crate::cli::files;
use std::path::Path;
use std::time::Duration;

/// Pictures a second of a film, and the time from one to the next.
const FILM_RATE: u32 = 60;
const FILM_FRAME: Duration = Duration::from_nanos(1_000_000_000 / FILM_RATE as u64);
/// Frames after which ImGui's windows have found their sizes, and seconds after which a menu has come to rest.
const SETTLE_FRAMES: usize = 3;
const SETTLE_TIME: f32 = 1.0;

impl App {
    /// Takes the pictures of so many seconds after a tick, as many a second as a film has, without waiting for them in real
    /// time.
    ///
    /// # Errors
    /// OpenGL fails, the file cannot be written, or the replay is over before that tick.
    pub fn film(&mut self, file: &Path, at: u64, seconds: u32) -> Result<(), ShellError> {
        let size = self.platform.pixels();
        let mut reel = capture::Reel::open(file)?;
        self.go_to(at)?;
        for _ in 0..seconds * FILM_RATE {
            self.notices.advance(FILM_FRAME);
            self.paused = false;
            self.advance_front(FILM_FRAME);
            self.advance(FILM_FRAME);
            while self.platform.events.poll_event().is_some() {}
            self.draw(FILM_FRAME.as_secs_f32())?;
            reel.push(size, &self.renderer.read_pixels(size))?;
        }
        Ok(reel.close()?)
    }

    /// Plays until a tick without showing anything.
    fn go_to(&mut self, at: u64) -> Result<(), ShellError> {
        let span = Duration::from_secs(1) / self.play.world.tick_rate();
        while self.play.world.tick() < at {
            self.notices.advance(span);
            self.advance_front(span);
            if !self.tick() {
                let end = self.play.world.tick();
                return Err(ShellError::Replay(format!(
                    "--at {at}: the replay is over at tick {end}"
                )));
            }
        }
        self.clock.settle();
        self.play.skip_fall();
        Ok(())
    }

    /// Takes the picture of a tick without waiting for it in real time.
    ///
    /// # Errors
    /// OpenGL fails, the file cannot be written, or the replay is over before that tick.
    pub fn screenshot(&mut self, file: &Path, at: u64) -> Result<(), ShellError> {
        files::check_writable(file)?;
        self.go_to(at)?;
        let size = self.platform.pixels();
        self.front.menu.advance(SETTLE_TIME);
        for _ in 0..SETTLE_FRAMES {
            // The window system wants its events taken, but none of them may pause the picture.
            while self.platform.events.poll_event().is_some() {}
            self.draw(SETTLE_TIME)?;
        }
        let pixels = self.renderer.read_pixels(size);
        Ok(capture::write_png(file, size, &pixels)?)
    }
}
