//! Frame times: so many frames as fast as they can be drawn, and what they asked of the machine. Those of a replay are spread
//! over all of it. Each picture is drawn again a few times: the least of its times is what it costs, the first has in it what
//! else the machine did meanwhile.

use super::ShellError;
use super::app::{App, MEASURED_FRAME};
use crate::cli::Preset;
use std::io::Write;
use std::time::{Duration, Instant};

/// Frames that are drawn before measuring: shaders are compiled on their first use, and memory is touched.
const WARM_UP: u32 = 10;
/// Frames that are drawn to choose a preset, and those before them.
const TRIED: usize = 9;
const WARM_UP_TRIED: usize = 3;
/// Times that each picture is drawn.
const DRAWN: usize = 3;
/// Ticks of a frame in the usual replays.
const TICKS: u64 = 2;
/// Units of the kernel's account of processor time, in a second.
const ACCOUNT_RATE: f64 = 100.0;

/// Measures, and says what came out.
///
/// # Errors
/// OpenGL fails.
pub fn run(
    app: &mut App,
    frames: u32,
    preset: Option<Preset>,
    begin: Instant,
) -> Result<(), ShellError> {
    frame(app)?;
    say(&format!("first frame after {:.0} ms", ms(begin.elapsed())));
    let presets = Preset::ALL.into_iter();
    let wanted = presets.filter(|p| preset.is_none_or(|wanted| wanted == *p));
    let measured = u64::from(frames) * wanted.clone().count() as u64;
    let apart = app.feed.ticks() / measured.max(1);
    for preset in wanted {
        app.renderer.set_preset(preset)?;
        say(&measure(app, frames, apart, preset)?);
    }
    Ok(())
}

impl App {
    /// On a start for which nobody has chosen a preset: chooses one, and keeps it in the settings.
    ///
    /// # Errors
    /// OpenGL fails.
    pub(super) fn choose_first_preset(&mut self) -> Result<(), ShellError> {
        if self.settings().video.preset.is_none() {
            let before = self.settings().clone();
            self.front.live.video.preset = Some(self.choose_preset()?);
            self.adopt(&before);
        }
        Ok(())
    }

    /// Sets the preset that this machine can bear, found by timing a few frames of [`Preset::Medium`]; gives it.
    ///
    /// # Errors
    /// OpenGL fails.
    pub fn choose_preset(&mut self) -> Result<Preset, ShellError> {
        self.renderer.set_preset(Preset::Medium)?;
        let mut times = Vec::with_capacity(TRIED);
        for _ in 0..WARM_UP_TRIED + TRIED {
            let begin = Instant::now();
            self.draw(0.0)?;
            self.renderer.finish();
            times.push(ms(begin.elapsed()));
        }
        times.drain(..WARM_UP_TRIED);
        times.sort_by(f64::total_cmp);
        let preset = Preset::for_frame_time(percentile(&times, 50));
        self.renderer.set_preset(preset)?;
        Ok(preset)
    }
}

/// Milliseconds of one frame.
struct Frame {
    /// As it came.
    first: f64,
    /// With the quickest drawing of its picture.
    least: f64,
}

/// One frame: its ticks, and its picture a few times.
fn frame(app: &mut App) -> Result<Frame, ShellError> {
    let begin = Instant::now();
    app.measured_ticks();
    let ticks = ms(begin.elapsed());
    let mut pictures = [0.0; DRAWN];
    let mut after = MEASURED_FRAME;
    for time in &mut pictures {
        let begin = Instant::now();
        app.measured_picture(after)?;
        *time = ms(begin.elapsed());
        after = Duration::ZERO;
    }
    Ok(Frame {
        first: ticks + pictures[0],
        least: ticks + pictures.into_iter().fold(f64::INFINITY, f64::min),
    })
}

/// Draws the frames of one preset, so many ticks from one to the next; gives a line about them.
fn measure(app: &mut App, frames: u32, apart: u64, preset: Preset) -> Result<String, ShellError> {
    for _ in 0..WARM_UP {
        frame(app)?;
    }
    app.renderer.take_work();
    let processor = processor_time();
    let mut times = Vec::with_capacity(frames as usize);
    let mut least = Vec::with_capacity(frames as usize);
    let mut slowest = (0.0, 0);
    for _ in 0..frames {
        let next = app.play.world.tick() + apart.saturating_sub(TICKS);
        while app.play.world.tick() < next && app.tick() {}
        let frame = frame(app)?;
        times.push(frame.first);
        least.push(frame.least);
        if frame.least > slowest.0 {
            slowest = (frame.least, app.play.world.tick());
        }
    }
    let work = app.renderer.take_work();
    let drawn = frames * DRAWN as u32;
    let processor = match (processor, processor_time()) {
        (Some(from), Some(to)) => format!(
            ", {:.1} ms of processors",
            (to - from) * 1000.0 / f64::from(drawn)
        ),
        _ => String::new(),
    };
    times.sort_by(f64::total_cmp);
    least.sort_by(f64::total_cmp);
    Ok(format!(
        "{:6} median {:.1} ms, 99th percentile {:.1} ms; of the least of {DRAWN} drawings {:.1} ms, {:.1} ms, \
         most {:.1} ms at tick {}{processor}; a picture: {} calls, {} draws, {} triangles",
        preset.name(),
        percentile(&times, 50),
        percentile(&times, 99),
        percentile(&least, 50),
        percentile(&least, 99),
        slowest.0,
        slowest.1,
        work.calls / drawn,
        work.draws / drawn,
        work.triangles / drawn as usize,
    ))
}

fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1000.0
}

/// The value that so many of a hundred sorted ones do not exceed.
fn percentile(sorted: &[f64], share: usize) -> f64 {
    let rank = (sorted.len() * share).div_ceil(100).max(1);
    sorted.get(rank - 1).copied().unwrap_or(f64::NAN)
}

/// Seconds that all processors have worked for this program, where the kernel tells (Linux).
fn processor_time() -> Option<f64> {
    let account = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The second field is the program's name in brackets; user and system time are the 14th and 15th.
    let mut fields = account.rsplit_once(')')?.1.split_whitespace().skip(11);
    let mut time = || fields.next()?.parse::<f64>().ok();
    Some((time()? + time()?) / ACCOUNT_RATE)
}

/// To the terminal, or to a reader who may have gone.
fn say(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_values_that_occurred() {
        let times: Vec<f64> = (1..=200).map(f64::from).collect();
        assert_eq!(
            (percentile(&times, 50), percentile(&times, 99)),
            (100.0, 198.0)
        );
        assert_eq!(percentile(&[7.0], 99), 7.0);
        assert!(percentile(&[], 50).is_nan());
    }
}
