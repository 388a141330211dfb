//! A view between two ticks: what is drawn when a frame falls between them.

use super::View;

/// Metres beyond what the speeds explain, from which a change of place counts as a jump in space.
const SLACK: f64 = 1.0;

impl View {
    /// Whether the hero was put elsewhere (a restart, a fall out of the level) rather than moved there.
    pub fn is_cut_from(&self, before: &View) -> bool {
        let span = (self.time - before.time).abs();
        let speed = before.velocity.length().max(self.velocity.length());
        self.deaths != before.deaths
            || self.began_at != before.began_at
            || self.position.distance(before.position) > SLACK + 2.0 * speed * span
    }

    /// The view at a share (0 to 1) of the way from `before` to `self`; after a cut there is no way between.
    pub fn since(&self, before: &View, share: f64) -> View {
        if self.is_cut_from(before) {
            return *self;
        }
        View {
            time: before.time + (self.time - before.time) * share,
            position: before.position.lerp(self.position, share),
            velocity: before.velocity.lerp(self.velocity, share),
            ..*self
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use glam::DVec2;

    /// A hero in the air at a place and a time.
    pub(crate) fn view(time: f64, position: DVec2, velocity: DVec2) -> View {
        View {
            time,
            velocity,
            ..View::at(position)
        }
    }

    #[test]
    fn a_half_way_view_lies_half_way() {
        let run = DVec2::new(8.0, 0.0);
        let (a, b) = (
            view(1.0, DVec2::ZERO, run),
            view(1.5, DVec2::new(4.0, 2.0), run),
        );
        let middle = b.since(&a, 0.5);
        assert_eq!((middle.time, middle.position), (1.25, DVec2::new(2.0, 1.0)));
        assert_eq!(b.since(&a, 1.0), b);
    }

    #[test]
    fn a_restart_is_a_cut_and_a_fast_fall_is_none() {
        let fall = DVec2::new(0.0, -1000.0);
        let (a, b) = (
            view(0.0, DVec2::ZERO, fall),
            view(0.01, DVec2::new(0.0, -10.0), fall),
        );
        assert!(!b.is_cut_from(&a));
        let restarted = view(0.01, DVec2::new(-5.0, 0.0), DVec2::ZERO);
        let still = view(0.0, DVec2::ZERO, DVec2::ZERO);
        assert!(restarted.is_cut_from(&still));
        assert_eq!(restarted.since(&still, 0.5), restarted);
    }
}
