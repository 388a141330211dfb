//! Real time cut into ticks, and frames held to a rate. Nothing in here reads a clock: durations come in.

use std::time::Duration;

/// Longest real time that one frame catches up with; the rest of a stall is dropped, so that a slow machine
/// plays slowly instead of working ever harder.
const CATCH_UP: f64 = 0.25;

/// Turns the real time between frames into whole ticks.
#[derive(Clone, Debug)]
pub struct TickClock {
    tick: f64,
    rest: f64,
}

impl TickClock {
    /// A clock of so many ticks per second.
    pub fn new(tick_rate: u32) -> TickClock {
        TickClock {
            tick: 1.0 / f64::from(tick_rate),
            rest: 0.0,
        }
    }

    /// Lets real time pass, `scale` times as fast as usual; returns the ticks that are due.
    pub fn advance(&mut self, elapsed: Duration, scale: f64) -> u32 {
        self.rest += elapsed.as_secs_f64().min(CATCH_UP) * scale;
        let due = (self.rest / self.tick).floor();
        self.rest -= due * self.tick;
        due as u32
    }

    /// How far the picture is between the last two ticks, from 0 to 1.
    pub fn share(&self) -> f64 {
        (self.rest / self.tick).clamp(0.0, 1.0)
    }

    /// Shows the last tick itself, as a paused game and a picture of one tick do.
    pub fn settle(&mut self) {
        self.rest = self.tick * (1.0 - f64::EPSILON);
    }
}

/// Frames in a row that must come too early before vsync counts as not holding.
const EARLY_FRAMES: u32 = 20;
/// Share of the display's time per frame below which a frame comes too early.
const EARLY: f64 = 0.7;

/// Keeps the frame rate down where vsync does not.
#[derive(Clone, Debug)]
pub struct FrameLimiter {
    vsync: bool,
    early: u32,
}

impl FrameLimiter {
    /// A limiter behind a vsync that was granted, or not.
    pub fn new(vsync: bool) -> FrameLimiter {
        FrameLimiter { vsync, early: 0 }
    }

    /// How long to wait after a frame that took `spent` with its wait for the display, which shows one per `shown`,
    /// when one per `wanted` is enough.
    pub fn wait(&mut self, spent: Duration, shown: Duration, wanted: Duration) -> Duration {
        let is_early = spent < shown.mul_f64(EARLY);
        self.early = if is_early { self.early + 1 } else { 0 };
        self.vsync &= self.early < EARLY_FRAMES;
        if self.vsync && wanted <= shown {
            return Duration::ZERO;
        }
        wanted.saturating_sub(spent)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_add_up_whatever_the_frame_rate() {
        for frames in [30, 60, 75, 144, 1000] {
            let mut clock = TickClock::new(120);
            let frame = Duration::from_secs_f64(1.0 / f64::from(frames));
            let ticks: u32 = (0..frames * 10).map(|_| clock.advance(frame, 1.0)).sum();
            assert!((1199..=1200).contains(&ticks), "{frames}: {ticks}");
            assert!((0.0..=1.0).contains(&clock.share()));
        }
    }

    #[test]
    fn a_stall_is_not_caught_up_with() {
        let mut clock = TickClock::new(120);
        assert_eq!(clock.advance(Duration::from_secs(3600), 1.0), 30);
        assert!(clock.advance(Duration::from_millis(8), 1.0) <= 1);
    }

    #[test]
    fn slow_motion_is_slow_and_a_settled_clock_shows_the_last_tick() {
        let mut clock = TickClock::new(120);
        let ticks: u32 = (0..100)
            .map(|_| clock.advance(Duration::from_millis(10), 0.25))
            .sum();
        assert!((29..=30).contains(&ticks));
        clock.settle();
        assert!(clock.share() > 0.999_999);
        assert_eq!(clock.advance(Duration::ZERO, 1.0), 0);
    }

    #[test]
    fn a_vsync_that_does_not_hold_is_replaced() {
        let (frame, fast) = (Duration::from_millis(16), Duration::from_millis(1));
        let mut held = FrameLimiter::new(true);
        assert!((0..1000).all(|_| held.wait(frame, frame, frame).is_zero()));
        let mut broken = FrameLimiter::new(true);
        let waits: Vec<Duration> = (0..30).map(|_| broken.wait(fast, frame, frame)).collect();
        assert!(waits[0].is_zero() && waits[29] == Duration::from_millis(15));
        let mut none = FrameLimiter::new(false);
        assert_eq!(none.wait(fast, frame, frame), Duration::from_millis(15));
    }

    #[test]
    fn a_window_that_nobody_looks_at_is_slowed_down_without_doubting_its_vsync() {
        let (frame, idle) = (Duration::from_millis(16), Duration::from_millis(33));
        let mut limiter = FrameLimiter::new(true);
        assert!((0..100).all(|_| limiter.wait(frame, frame, idle) == idle - frame));
        assert!(limiter.wait(frame, frame, frame).is_zero());
    }
}
