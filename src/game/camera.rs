//! The camera that follows the hero: a plain value, stepped once per tick.
//!
//! It aims ahead of the motion, lets the hero jump without nodding along, and is smooth by construction:
//! what it aims at passes two low-pass filters in a row, each solved exactly over the step. So the path does
//! not depend on how time is cut into steps, nothing oscillates, and nothing in here can shake. What the level asks to be
//! shown ([`Framing`]) is blended in: from shot to shot by shares that pass two filters as well.
//! Absent: any knowledge of the window.

use super::framing::{Aim, Framing, between, half_picture};
use super::{Stance, View};
use crate::tune::Camera;
use glam::{DVec2, DVec3};

/// The lead turns round this much more slowly than the camera follows, so that a quick turn does not swing it.
const LEAD_RATIO: f64 = 0.5;

/// Share of half the picture's height that the focus may be away from the hero, however fast he falls.
const KEEP_IN: f64 = 0.6;

/// The middle of the hero above his foot, m.
const MIDDLE: f64 = 0.85;

/// Share of half the picture that the hero may be away from its middle, whatever the speed and whatever the level asks for.
const SEEN: f64 = 0.8;

/// The last part of that way over which the picture is taken along.
const SEEN_KNEE: f64 = 0.1;

/// How fast the camera goes over from one shot of the level to another, 1/s.
const BLEND_RATE: f64 = 2.5;

/// How fast the speed may change that the camera leads by, in m/s^2: a hero who jumps off a wall shall not jerk the picture.
const PACE_RATE: f64 = 40.0;

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

/// How much of the picture a shot has: what passed one filter, and what passed both.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Share {
    wished: f64,
    shown: f64,
}

/// What the camera remembers from tick to tick.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraState {
    shares: Vec<Share>, // of each shot of the level; together 1
    focus: DVec2,       // the point of the plane of play that is looked at, before `height`
    lead: DVec2,        // how far ahead of the anchor the focus is drawn
    anchor: DVec2,      // the hero's place, without the small ups and downs of a jump
    pace: f64, // the speed sideways that is led by: the hero's, but for jumps of it off a wall or into one
    last: View, // the view of the previous step
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
            focus: view.position,
            lead: DVec2::ZERO,
            anchor: view.position,
            pace: view.velocity.x,
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
        (self.focus, self.anchor, self.lead) = (view.position, view.position, DVec2::ZERO);
        (self.pace, self.last) = (view.velocity.x, *view);
    }

    /// Follows for `dt` seconds; `look` from -1 (down) to 1 (up) is where the player asks to look.
    pub fn step(&mut self, view: &View, look: f64, framing: &Framing, tuning: &Camera, dt: f64) {
        if view.is_cut_from(&self.last) {
            self.cut(view, framing);
            return;
        }
        self.blend(framing.shot_at(self.last.position), dt);
        let mut before = self.anchor;
        let held = held_height(before.y, view, tuning.dead_zone_y);
        let has_landed = flies(self.last.stance) && !flies(view.stance);
        if has_landed {
            // The anchor jumps to the foot. The lead takes that up, so that the aim does not jump but drifts.
            let jump = view.position.y - held;
            self.lead.y -= jump;
            before.y += jump;
        }
        self.anchor = match view.stance {
            Stance::Air | Stance::Slide => DVec2::new(view.position.x, held),
            Stance::Ground | Stance::Wedge | Stance::Climb => view.position,
        };
        // Who climbs holds the same keys to get on.
        let look = match view.stance {
            Stance::Climb | Stance::Slide => 0.0,
            Stance::Air | Stance::Ground | Stance::Wedge => look,
        };
        let most = PACE_RATE * dt;
        self.pace += (view.velocity.x - self.pace).clamp(-most, most);
        let asked = DVec2::new(0.0, look.clamp(-1.0, 1.0) * tuning.look);
        let wished = asked + wished_lead(view, self.pace, self.anchor.y != before.y, tuning);
        let rates = DVec2::new(tuning.stiffness_x, tuning.stiffness_y);
        self.follow(before, wished, rates, dt);
        let reach = DVec2::splat(KEEP_IN * half_picture(tuning.distance, tuning).y);
        let hero = view.position;
        self.focus = self.focus.clamp(hero - reach, hero + reach);
        self.last = *view;
    }

    /// The two filters, both axes at once. With the anchor p moving evenly (velocity v) and the lead l drawn to
    /// w, l' = a (w - l) and x' = k (p + l - x) have the solution below; a = k [`LEAD_RATIO`] keeps it regular.
    fn follow(&mut self, before: DVec2, wished: DVec2, k: DVec2, dt: f64) {
        if dt <= 0.0 {
            return;
        }
        let a = k * LEAD_RATIO;
        let lag = (self.anchor - before) / dt / k;
        let (fade, lead_fade) = ((-k * dt).exp(), (-a * dt).exp());
        let swing = (self.lead - wished) * (k / (k - a));
        let rest = self.focus - (before - lag + wished + swing);
        self.focus = self.anchor - lag + wished + swing * lead_fade + rest * fade;
        self.lead = wished + (self.lead - wished) * lead_fade;
    }

    /// Goes over to a shot. With the wish d of a shot 1 or 0, u' = r (d - u) and w' = r (u - w) have this solution.
    fn blend(&mut self, shot: usize, dt: f64) {
        let (r, fade) = (BLEND_RATE, (-BLEND_RATE * dt).exp());
        for (index, share) in self.shares.iter_mut().enumerate() {
            let wish = if index == shot { 1.0 } else { 0.0 };
            let (u, w) = (share.wished - wish, share.shown - wish);
            share.wished = wish + u * fade;
            share.shown = wish + (w + u * r * dt) * fade;
        }
    }

    /// Where the picture is taken from.
    pub fn pose(&self, framing: &Framing, tuning: &Camera) -> Pose {
        let free = self.focus + DVec2::new(0.0, tuning.height);
        let mut seen = Aim {
            target: DVec2::ZERO,
            distance: 0.0,
        };
        for (shot, share) in self.shares.iter().enumerate() {
            if share.shown != 0.0 {
                let aim = framing.aim(shot, free, tuning);
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

/// The anchor's height in the air: it changes only when the hero leaves the dead zone about it.
fn held_height(before: f64, view: &View, dead_zone: f64) -> f64 {
    let y = view.position.y;
    before.clamp(y - dead_zone, y + dead_zone)
}

/// How far ahead of the anchor the aim should be drawn: the tuned lead, and what the filter will lag behind an even
/// motion. Sideways always; up and down only while the height is followed, and not for the rise of a jump.
fn wished_lead(view: &View, pace: f64, follows_height: bool, tuning: &Camera) -> DVec2 {
    let rises = flies(view.stance) && view.velocity.y > 0.0;
    let fall = match follows_height && !rises {
        true => view.velocity.y,
        false => 0.0,
    };
    let velocity = DVec2::new(pace, fall);
    let limit = DVec2::splat(tuning.lead_limit);
    let lag = velocity / DVec2::new(tuning.stiffness_x, tuning.stiffness_y);
    (velocity * tuning.lead).clamp(-limit, limit) + lag
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
