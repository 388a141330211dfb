//! From devices to what menus understand: directions that repeat while they are held, choosing, going back.

use std::time::Duration;

/// What a player wants of a menu.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Nav {
    /// To the entry above.
    Up,
    /// To the entry below.
    Down,
    /// The value before, or the column to the left.
    Left,
    /// The value after, or the column to the right.
    Right,
    /// Do it, open it, change it.
    Choose,
    /// To the page before.
    Back,
    /// Take it away.
    Clear,
    /// The pointer is on an entry, and on one of its columns.
    Point(usize, Option<usize>),
    /// The pointer is at this share of the entry's scale.
    Share(f32),
}

impl Nav {
    /// Directions repeat while they are held.
    fn repeats(self) -> bool {
        matches!(self, Nav::Up | Nav::Down | Nav::Left | Nav::Right)
    }
}

/// Time until a held direction is repeated, and between two repetitions.
const DELAY: Duration = Duration::from_millis(380);
const PERIOD: Duration = Duration::from_millis(95);

/// The direction that is held, and for how long until it counts again; not yet, if it went down in this frame.
#[derive(Clone, Debug, Default)]
pub struct Repeater {
    held: Option<(Nav, Option<Duration>)>,
}

impl Repeater {
    /// A direction goes down.
    pub fn press(&mut self, nav: Nav) {
        self.held = nav.repeats().then_some((nav, None));
    }

    /// A direction is let go.
    pub fn release(&mut self, nav: Nav) {
        self.held = self.held.filter(|(held, _)| *held != nav);
    }

    /// Nothing is held any more.
    pub fn clear(&mut self) {
        self.held = None;
    }

    /// Lets the time since the last frame pass; the direction if it counts again. At most once a call: a stall moves no
    /// focus far. Nothing of it is counted for what went down in this frame: it was not held before.
    pub fn advance(&mut self, elapsed: Duration) -> Option<Nav> {
        let (nav, left) = self.held.as_mut()?;
        let now = left.map_or(DELAY, |left| left.saturating_sub(elapsed));
        let due = now.is_zero();
        *left = Some(if due { PERIOD } else { now });
        due.then_some(*nav)
    }
}

/// Shares of a stick's way at which it counts as pushed and as let go.
const PUSHED: f64 = 0.6;
const RELEASED: f64 = 0.4;

/// A stick as four directions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StickNav {
    along: Option<Nav>,
}

impl StickNav {
    /// The stick has moved, right and down positive; a direction that it has taken, and one that it has left.
    pub fn moved(&mut self, [x, y]: [f64; 2]) -> (Option<Nav>, Option<Nav>) {
        let reach = x.abs().max(y.abs());
        let wanted = match self.along {
            _ if reach >= PUSHED && y.abs() >= x.abs() => {
                Some(if y < 0.0 { Nav::Up } else { Nav::Down })
            }
            _ if reach >= PUSHED => Some(if x < 0.0 { Nav::Left } else { Nav::Right }),
            held if reach > RELEASED => held,
            _ => None,
        };
        if wanted == self.along {
            return (None, None);
        }
        (wanted, std::mem::replace(&mut self.along, wanted))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_held_direction_repeats_after_a_while() {
        let mut repeater = Repeater::default();
        let frame = Duration::from_millis(10);
        repeater.press(Nav::Down);
        let times: Vec<usize> = (0..70)
            .filter(|_| repeater.advance(frame).is_some())
            .collect();
        assert_eq!(times, [38, 48, 58, 68]);
        repeater.release(Nav::Up);
        assert_eq!(repeater.advance(DELAY), Some(Nav::Down));
        repeater.release(Nav::Down);
        assert_eq!(repeater.advance(DELAY), None);
        repeater.press(Nav::Choose);
        assert_eq!(repeater.advance(DELAY), None);
    }

    #[test]
    fn what_is_tapped_in_a_slow_frame_counts_once() {
        let mut repeater = Repeater::default();
        repeater.press(Nav::Up);
        assert_eq!(repeater.advance(2 * DELAY), None, "it was not held so long");
        repeater.release(Nav::Up);
        assert_eq!(repeater.advance(2 * DELAY), None);
        repeater.press(Nav::Up);
        assert_eq!(repeater.advance(2 * DELAY), None);
        assert_eq!(repeater.advance(DELAY), Some(Nav::Up), "but it is now");
    }

    #[test]
    fn a_stick_is_pushed_once_and_let_go_once() {
        let mut stick = StickNav::default();
        assert_eq!(stick.moved([0.5, 0.1]), (None, None));
        assert_eq!(stick.moved([0.7, 0.1]), (Some(Nav::Right), None));
        assert_eq!(stick.moved([0.5, 0.1]), (None, None));
        assert_eq!(stick.moved([0.1, -0.9]), (Some(Nav::Up), Some(Nav::Right)));
        assert_eq!(stick.moved([0.0, 0.0]), (None, Some(Nav::Up)));
    }
}
