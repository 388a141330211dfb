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

/// The direction that is held, and for how long until it counts again.
#[derive(Clone, Debug, Default)]
pub struct Repeater {
    held: Option<(Nav, Duration)>,
}

impl Repeater {
    /// A direction goes down.
    pub fn press(&mut self, nav: Nav) {
        self.held = nav.repeats().then_some((nav, DELAY));
    }

    /// A direction is let go.
    pub fn release(&mut self, nav: Nav) {
        self.held = self.held.filter(|(held, _)| *held != nav);
    }

    /// Nothing is held any more.
    pub fn clear(&mut self) {
        self.held = None;
    }

    /// Lets time pass; the direction if it counts again. At most once a call: a stall moves no focus far.
    pub fn advance(&mut self, elapsed: Duration) -> Option<Nav> {
        let (nav, left) = self.held.as_mut()?;
        *left = left.saturating_sub(elapsed);
        let due = left.is_zero();
        if due {
            *left = PERIOD;
        }
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
        assert_eq!(times, [37, 47, 57, 67]);
        repeater.release(Nav::Up);
        assert_eq!(repeater.advance(DELAY), Some(Nav::Down));
        repeater.release(Nav::Down);
        assert_eq!(repeater.advance(DELAY), None);
        repeater.press(Nav::Choose);
        assert_eq!(repeater.advance(DELAY), None);
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
