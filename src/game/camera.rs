//! The camera that follows the hero: a plain value, stepped once per tick.
//!
//! It aims ahead of the motion, lets the hero jump without nodding along, sees where a fall leads and comes to rest where it
//! ends. It is smooth by construction: a spring draws it to what it aims at, with no more than a stated acceleration, in
//! steps of its own. So the path does not depend on how time is cut into ticks, nothing oscillates, and nothing in here can
//! shake. What the level asks to be shown ([`Framing`]) is blended in: from shot to shot by shares that pass two filters.
//! Absent: any knowledge of the window.

use super::framing::{Aim, FALL_SPEED, Framing, GRAVITY, between, half_picture};
use super::{Stance, View};
use crate::tune::Camera;
use glam::{DVec2, DVec3};

/// Shares of half the picture's height that the focus may be below and above the hero, however fast he is.
const KEEP_IN: (f64, f64) = (0.8, 0.6);

/// How far ahead of a fall is seen, as time at its speed, in s; and so much more, in m, as the spring lags behind.
const FORESEEN: f64 = 0.4;
const MARGIN: f64 = 0.5;

/// A fall that ends less than this below the place where the hero left the ground is none, in m.
const DEEP: f64 = 1.0;

/// The speeds at which falls end between which the camera draws back more and more, in m/s; by how much of its distance; how
/// fast it does, in 1/s.
const FALLS: (f64, f64) = (15.0, 22.0);
const BACK: f64 = 0.5;
const BACK_RATE: f64 = 8.0;

/// With this the aim slows down over where a fall ends, in m/s^2.
const STOP: f64 = 70.0;

/// The middle of the hero above his foot, m.
const MIDDLE: f64 = 0.85;

/// Share of half the picture that the hero may be away from its middle, whatever the speed and whatever the level asks for.
const SEEN: f64 = 0.8;

/// The last part of that way over which the picture is taken along.
const SEEN_KNEE: f64 = 0.1;

/// How fast the camera goes over from one shot of the level to another, 1/s.
const BLEND_RATE: f64 = 2.5;

/// The greatest acceleration of the focus, in m/s^2: a hero who turns, jumps off a wall or lands shall not jerk the picture.
const MOST: DVec2 = DVec2::new(108.0, 130.0);

/// The longest step of the spring, in s.
const STEP: f64 = 1.0 / 960.0;

/// Where a picture is taken from. Metres; x right, y up, z towards the viewer, the plane of play at z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Where the camera is.
    pub eye: DVec3,
    /// What is in the middle of the picture.
    pub target: DVec3,
    /// Vertical opening angle, in degrees.
    pub fov_degrees: f64,
}

impl Pose {
    /// The pose at a share (0 to 1) of the way from `before` to `self`.
    pub fn since(&self, before: &Pose, share: f64) -> Pose {
        Pose {
            eye: before.eye.lerp(self.eye, share),
            target: before.target.lerp(self.target, share),
            fov_degrees: self.fov_degrees,
        }
    }
}

/// How much of the picture something has: what passed one filter, and what passed both.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Share {
    wished: f64,
    shown: f64,
}

impl Share {
    /// Follows a wish. With it d, u' = r (d - u) and w' = r (u - w) have this solution.
    fn follow(&mut self, wish: f64, rate: f64, dt: f64) {
        let fade = (-rate * dt).exp();
        let (u, w) = (self.wished - wish, self.shown - wish);
        self.wished = wish + u * fade;
        self.shown = wish + (w + u * rate * dt) * fade;
    }
}

/// What the camera remembers from tick to tick.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraState {
    shares: Vec<Share>, // of each shot of the level; together 1
    back: Share,        // how far the camera has drawn back from a fall
    focus: DVec2,       // the point of the plane of play that is looked at, before `height`
    speed: DVec2,       // of the focus
    anchor: DVec2,      // the hero's place, without the ups and downs of a jump
    falls: bool,        // he goes down to deeper than where he came from
    last: View,         // the view of the previous step
}

impl CameraState {
    /// A camera at rest on the hero.
    pub fn new(view: &View, framing: &Framing) -> CameraState {
        let mut shares = vec![Share::default(); framing.count()];
        shares[framing.shot_at(view.position)] = Share {
            wished: 1.0,
            shown: 1.0,
        };
        CameraState {
            shares,
            back: Share::default(),
            focus: view.position,
            speed: DVec2::new(view.velocity.x, 0.0),
            anchor: view.position,
            falls: false,
            last: *view,
        }
    }

    /// Cuts to the hero, if he was put elsewhere; no memory is taken for it.
    fn cut(&mut self, view: &View, framing: &Framing) {
        let shot = framing.shot_at(view.position);
        for (index, share) in self.shares.iter_mut().enumerate() {
            let part = if index == shot { 1.0 } else { 0.0 };
            (share.wished, share.shown) = (part, part);
        }
        (self.focus, self.anchor, self.last) = (view.position, view.position, *view);
        self.falls = false;
        (self.speed, self.back) = (DVec2::new(view.velocity.x, 0.0), Share::default());
    }

    /// Follows for `dt` seconds; `look` from -1 (down) to 1 (up) is where the player asks to look.
    pub fn step(&mut self, view: &View, look: f64, framing: &Framing, tuning: &Camera, dt: f64) {
        if view.is_cut_from(&self.last) {
            self.cut(view, framing);
            return;
        }
        self.blend(framing.shot_at(self.last.position), dt);
        let before = self.anchor;
        let mut drawn = 0.0;
        self.anchor = view.position;
        let fell = std::mem::take(&mut self.falls);
        if flies(view.stance) {
            let held = held_height(before.y, view, tuning.dead_zone_y);
            self.anchor.y = held;
            if let Some((end, speed)) = fall(view, held, fell, framing) {
                self.falls = view.velocity.y <= 0.0;
                drawn = ((speed - FALLS.0) / (FALLS.1 - FALLS.0)).clamp(0.0, 1.0);
                let aim = view.position.y - wished_drop(drawn, speed, tuning);
                let most = (2.0 * STOP * (held - end).max(0.0)).sqrt() * dt;
                self.anchor.y = aim.max(end).min(held).max(held - most);
            }
        }
        self.back.follow(drawn, BACK_RATE, dt);
        // Who climbs holds the same keys to get on.
        let look = match view.stance {
            Stance::Climb | Stance::Slide => 0.0,
            Stance::Air | Stance::Ground | Stance::Wedge => look,
        };
        let limit = tuning.lead_limit;
        let ahead = (self.last.velocity.x * tuning.lead).clamp(-limit, limit);
        let wished = DVec2::new(ahead, look.clamp(-1.0, 1.0) * tuning.look);
        // Who lands above or below where he was held is drifted to: that is no speed of his.
        let has_landed = flies(self.last.stance) && !flies(view.stance);
        let rise = if has_landed {
            0.0
        } else {
            self.anchor.y - before.y
        };
        let moved = DVec2::new(self.anchor.x - before.x, rise);
        self.follow(moved, wished, tuning, dt);
        let half = DVec2::splat(half_picture(tuning.distance, tuning).y);
        let hero = view.position;
        self.focus = self
            .focus
            .clamp(hero - half * KEEP_IN.0, hero + half * KEEP_IN.1);
        self.last = *view;
    }

    /// The spring, both axes at once, in steps of its own: towards the anchor, which has moved evenly, and a wish.
    fn follow(&mut self, moved: DVec2, wished: DVec2, tuning: &Camera, dt: f64) {
        let count = (dt / STEP - 1e-6).ceil();
        if count < 1.0 {
            return;
        }
        let moved = moved / dt;
        let step = dt / count;
        let k = DVec2::new(tuning.stiffness_x, tuning.stiffness_y);
        for n in 1..=count as u32 {
            let left = moved * (step * (count - f64::from(n)));
            let off = self.anchor - left + wished - self.focus;
            let pull = k * k * off + 2.0 * k * (moved - self.speed);
            self.speed += pull.clamp(-MOST, MOST) * step;
            self.focus += self.speed * step;
        }
    }

    /// How far away the camera would be without a level.
    fn distance(&self, tuning: &Camera) -> f64 {
        tuning.distance * (1.0 + BACK * self.back.shown)
    }

    /// Goes over to a shot.
    fn blend(&mut self, shot: usize, dt: f64) {
        for (index, share) in self.shares.iter_mut().enumerate() {
            let wish = if index == shot { 1.0 } else { 0.0 };
            share.follow(wish, BLEND_RATE, dt);
        }
    }

    /// Where the picture is taken from.
    pub fn pose(&self, framing: &Framing, tuning: &Camera) -> Pose {
        let free = self.focus + DVec2::new(0.0, tuning.height);
        let drawn = Camera {
            distance: self.distance(tuning),
            ..tuning.clone()
        };
        let mut seen = Aim {
            target: DVec2::ZERO,
            distance: 0.0,
        };
        for (shot, share) in self.shares.iter().enumerate() {
            if share.shown != 0.0 {
                let aim = framing.aim(shot, free, &drawn);
                seen.target += aim.target * share.shown;
                seen.distance += aim.distance * share.shown;
            }
        }
        // The last word: the hero is in the picture.
        let reach = half_picture(seen.distance, tuning) * SEEN;
        let hero = self.last.position + DVec2::new(0.0, MIDDLE);
        let near = |x: f64, hero: f64, reach: f64| {
            between(x, hero - reach, hero + reach, SEEN_KNEE * reach)
        };
        let x = near(seen.target.x, hero.x, reach.x);
        let y = near(seen.target.y, hero.y, reach.y);
        let target = DVec3::new(x, y, 0.0);
        Pose {
            eye: target + DVec3::new(0.0, tuning.tilt, seen.distance),
            target,
            fov_degrees: tuning.field_of_view,
        }
    }
}

/// Whether the height is not followed at once: who jumps from wall to wall shall not shake the picture.
fn flies(stance: Stance) -> bool {
    matches!(stance, Stance::Air | Stance::Slide)
}

/// The anchor's height in the air: it is held while the hero is no further above it than the dead zone is high.
fn held_height(before: f64, view: &View, dead_zone: f64) -> f64 {
    before.max(view.position.y - dead_zone)
}

/// Where a fall that leads deeper than a height ends, and with what speed, in m and m/s. One whose end is not known is one when
/// the hero is deeper, and one that has begun goes on.
fn fall(view: &View, held: f64, fell: bool, framing: &Framing) -> Option<(f64, f64)> {
    let foot = view.position.y;
    if view.stance != Stance::Air || view.velocity.y > 0.0 {
        return (foot < held).then_some((foot, 0.0));
    }
    let unknown = || (fell || foot < held - DEEP / 2.0).then_some(f64::NEG_INFINITY);
    let end = framing.end_of_fall(view.position, view.velocity);
    let end = end
        .or_else(unknown)
        .filter(|end| fell || *end < held - DEEP)?;
    let square = view.velocity.y.powi(2) + 2.0 * GRAVITY * (view.position.y - end).max(0.0);
    Some((end, square.sqrt().min(FALL_SPEED)))
}

/// How far below the hero the aim should be drawn, that what a fall comes to in [`FORESEEN`] is in the picture of a camera that
/// has drawn back so far.
fn wished_drop(drawn: f64, speed: f64, tuning: &Camera) -> f64 {
    let half = half_picture(tuning.distance * (1.0 + BACK * drawn), tuning).y;
    (speed * FORESEEN + MARGIN + tuning.height - half).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::game::blend::tests::view;

    /// A step with nobody looking aside, nothing framed and nothing tuned.
    fn follow(camera: &mut CameraState, view: &View, dt: f64) {
        camera.step(view, 0.0, &Framing::free(), &Camera::default(), dt);
    }

    /// A run on flat ground at 8 m/s for `seconds`, in steps of `dt`; then the camera.
    fn run(seconds: f64, dt: f64) -> (View, CameraState) {
        let speed = DVec2::new(8.0, 0.0);
        let at = |t: f64| View {
            stance: Stance::Ground,
            ..view(t, speed * t, speed)
        };
        let mut camera = CameraState::new(&at(0.0), &Framing::free());
        let steps = (seconds / dt).round() as u32;
        for n in 1..=steps {
            follow(&mut camera, &at(f64::from(n) * dt), dt);
        }
        (at(f64::from(steps) * dt), camera)
    }

    #[test]
    fn a_camera_on_a_resting_hero_does_not_move_by_a_bit() {
        let still = View {
            stance: Stance::Ground,
            ..view(0.0, DVec2::new(3.7, -1.3), DVec2::ZERO)
        };
        let first = CameraState::new(&still, &Framing::free());
        let mut camera = first.clone();
        for _ in 0..10_000 {
            follow(&mut camera, &still, 1.0 / 120.0);
        }
        assert_eq!(camera, first);
    }

    #[test]
    fn it_comes_to_rest_on_a_hero_who_stops_and_never_runs_further_than_the_lead() {
        let (moving, mut camera) = run(2.0, 1.0 / 120.0);
        let still = View {
            velocity: DVec2::ZERO,
            ..moving
        };
        for _ in 0..1200 {
            follow(&mut camera, &still, 1.0 / 120.0);
            assert!((camera.focus.x - still.position.x).abs() < Camera::default().lead_limit);
        }
        assert!(
            (camera.focus - still.position).length() < 1e-9,
            "{camera:?}"
        );
    }

    #[test]
    fn it_leads_to_the_side_of_the_motion() {
        let (at, camera) = run(3.0, 1.0 / 120.0);
        let tuning = Camera::default();
        let steady = 8.0 * tuning.lead;
        assert!(
            (camera.focus.x - at.position.x - steady).abs() < 1e-2,
            "{camera:?}"
        );
    }

    #[test]
    fn the_path_does_not_depend_on_the_step() {
        let (_, fine) = run(1.0, 1.0 / 960.0);
        for rate in [24.0, 30.0, 60.0, 120.0, 240.0] {
            let (_, coarse) = run(1.0, 1.0 / rate);
            assert!(
                (fine.focus - coarse.focus).length() < 1e-12,
                "{rate}: {fine:?} {coarse:?}"
            );
        }
    }

    #[test]
    fn a_hop_within_the_dead_zone_does_not_nod() {
        let ground = View {
            stance: Stance::Ground,
            ..view(0.0, DVec2::ZERO, DVec2::ZERO)
        };
        let mut camera = CameraState::new(&ground, &Framing::free());
        for n in 1..=60 {
            let t = f64::from(n) / 120.0;
            let height = 4.0 * t * (0.5 - t) * 4.0; // up 1 m and down again in half a second
            follow(
                &mut camera,
                &view(t, DVec2::new(0.0, height), DVec2::ZERO),
                1.0 / 120.0,
            );
            assert_eq!(camera.focus.y, 0.0);
        }
    }

    #[test]
    fn a_falling_hero_stays_in_the_picture_and_a_restart_is_a_cut() {
        let fall = DVec2::new(0.0, -200.0);
        let start = view(0.0, DVec2::ZERO, fall);
        let mut camera = CameraState::new(&start, &Framing::free());
        let tuning = Camera::default();
        for n in 1..=240 {
            let t = f64::from(n) / 120.0;
            camera.step(
                &view(t, fall * t, fall),
                0.0,
                &Framing::free(),
                &tuning,
                1.0 / 120.0,
            );
            let target = camera.pose(&Framing::free(), &tuning).target.y - tuning.height;
            assert!((target - fall.y * t).abs() < 0.6 * 0.4 * tuning.distance);
        }
        let restarted = view(2.01, DVec2::ZERO, DVec2::ZERO);
        camera.step(&restarted, 0.0, &Framing::free(), &tuning, 1.0 / 120.0);
        assert_eq!(camera, CameraState::new(&restarted, &Framing::free()));
    }

    #[test]
    fn looking_up_lifts_the_aim_by_the_tuned_height() {
        let still = View {
            stance: Stance::Ground,
            ..view(0.0, DVec2::ZERO, DVec2::ZERO)
        };
        let mut camera = CameraState::new(&still, &Framing::free());
        for _ in 0..1200 {
            camera.step(
                &still,
                1.0,
                &Framing::free(),
                &Camera::default(),
                1.0 / 120.0,
            );
        }
        assert!((camera.focus.y - Camera::default().look).abs() < 1e-6);
    }
}
