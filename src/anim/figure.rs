//! The moving hero: from moment to moment, what his body does becomes a pose.
//!
//! The order of a moment: which movement, its clips, the fade from the last one; then what comes on top: lean, gaze;
//! then the feet on the ground; then what hangs. All of it is a plain value without a heap: clone it to come back.

use super::aim::{facing, gaze};
use super::beside::Beside;
use super::fade::Fade;
use super::feet::{Foot, Goal, Ground, Step};
use super::ik::{Limb, reach};
use super::moves::Moves;
use super::pose::Pose;
use super::rig::{Bone, Rig};
use super::shown::Shown;
use super::skeleton::Placed;
use super::state::{Kind, Pace, State, fall_share, run_share, smooth, stride};
use super::tails::{Moment, Outline, Tails};
use glam::{Mat4, Quat, Vec2, Vec3};

/// Longest time that is caught up with, s; after more the figure begins anew.
const LONGEST: f64 = 0.25;
/// How fast he turns about, 1/s.
const TURNING: f32 = 15.0;
/// How fast he comes to the ground and off it, 1/s.
const GROUNDING: (f32, f32) = (35.0, 14.0);
/// How fast feet that were drawn up in the air are put down at a landing, 1/s, until its clip has them there, s.
const LANDING: f32 = 90.0;
const LANDS: f32 = 0.16;
/// How fast a walk becomes a run, and how fast a change of slope is taken, 1/s.
const PACING: f32 = 30.0;
const SLOPING: f32 = 22.0;
/// The fastest that hands follow each other up a wall, as a speed, m/s.
const CLIMBS: f64 = 4.0;
/// The fastest that a limb turns, whatever comes together, rad/s: somewhat more than a thigh at full speed.
const FASTEST: f32 = 58.0;
/// How fast the lean follows, 1/s; the most of it, in radians, and the acceleration for that, m/s^2.
const LEANING: f32 = 12.0;
const LEAN: (f32, f32) = (0.20, 90.0);
/// How much of a slope he leans into.
const UPHILL: f32 = 0.30;
/// How fast the gaze follows, 1/s.
const GAZING: f32 = 7.0;
/// How fast the hips sink for a foot that is low and rise again, 1/s, and how far they may, m.
const SINKING: (f32, f32) = (110.0, 5.0);
const SINKS: f32 = 0.36;
/// Share of its length that a leg which carries weight is stretched to at most.
const BENT: f32 = 0.965;
/// The most that he is stretched or squashed.
const STRETCH: f32 = 0.08;
/// A landing so long ago is no longer felt, s.
const FORGOTTEN: f64 = 5.0;
/// Speeds at which that is reached: down into the ground, and through the air, m/s.
const SQUASHED_AT: f32 = 24.0;
const STRETCHED_AT: f32 = 30.0;

/// The figure at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    moves: Moves,
    state: State,
    fade: Fade,
    /// What the clips and the fade give, now and before.
    base: Pose,
    earlier: (Pose, f32),
    pace: Pace,
    yaw: f32,
    /// 0 in the air to 1 on the ground.
    weight: f32,
    lean: f32,
    slope: f32,
    gaze: Vec2,
    drop: f32,
    beside: Beside,
    feet: [Foot; 2],
    tails: Tails,
    shown: Shown,
}

/// How much of the way to a goal is gone in a time, at a rate.
pub fn share(rate: f32, span: f32) -> f32 {
    1.0 - (-rate * span).exp()
}

impl Figure {
    /// One who has been doing this for long.
    pub fn new(moves: &Moves, rig: &Rig, ground: &dyn Ground) -> Figure {
        let idle = State {
            kind: Kind::Idle,
            since: moves.time,
        };
        let state = idle.next(moves, rig);
        Figure::doing(state, moves, rig, ground)
    }

    fn doing(state: State, moves: &Moves, rig: &Rig, ground: &dyn Ground) -> Figure {
        let pace = Pace {
            rounds: 0.0,
            run: run_share(moves),
            fall: fall_share(moves),
        };
        let base = state.pose(moves, pace, rig);
        let placed = rig.model.skeleton.place(&base);
        let mut figure = Figure {
            moves: *moves,
            state,
            fade: Fade::none(),
            base,
            earlier: (base, 0.0),
            pace,
            yaw: facing(state.kind, moves, pace.run, 0.0),
            weight: f32::from(u8::from(state.is_on_ground())),
            lean: 0.0,
            slope: moves.slope(),
            gaze: Vec2::ZERO,
            drop: 0.0,
            beside: Beside::settled(state.kind, moves, ground),
            feet: [Foot::default(); 2],
            tails: Tails::new(rig, &placed, &Mat4::IDENTITY, &moment(moves, Vec3::ZERO)),
            shown: Shown::resting(base, moves.foot),
        };
        let pose = figure.finish(0.0, Vec3::ZERO, rig, ground);
        let placed = rig.model.skeleton.place(&pose);
        let stand = figure.rigid();
        figure.tails = Tails::new(rig, &placed, &stand, &moment(moves, Vec3::ZERO));
        figure.hang(pose, placed, rig);
        figure
    }

    /// What is to be seen now.
    pub fn shown(&self) -> &Shown {
        &self.shown
    }

    /// What his body did at the last moment.
    pub fn moves(&self) -> &Moves {
        &self.moves
    }

    /// The movement that he is in.
    pub fn state(&self) -> State {
        self.state
    }

    /// Goes on to a moment. After a death, a jump in time or in space it begins anew there.
    pub fn advance(&mut self, moves: &Moves, rig: &Rig, ground: &dyn Ground) {
        let span = moves.time - self.moves.time;
        if moves.deaths != self.moves.deaths {
            let state = State {
                kind: Kind::GetUp,
                since: moves.time,
            };
            *self = Figure::doing(state, moves, rig, ground);
            return;
        }
        if !(0.0..LONGEST).contains(&span) || self.is_cut(moves, span) {
            *self = Figure::new(moves, rig, ground);
            return;
        }
        let before = self.moves;
        self.change_movement(moves, rig);
        self.play(moves, rig);
        let moved = (moves.foot - before.foot).as_vec2().extend(0.0);
        self.follow(&before, moves, span as f32, ground);
        let was = self.shown.pose;
        let mut pose = self.finish(span as f32, moved, rig, ground);
        pose.turn_at_most(FASTEST * span as f32, &was, &rig.muscles);
        let placed = rig.model.skeleton.place(&pose);
        let stand = self.rigid();
        let outline = self.outline(rig, &placed);
        let moment = moment(moves, moved);
        self.tails.advance(rig, &placed, &stand, &moment, &outline);
        self.hang(pose, placed, rig);
    }

    /// Strikes him dead where he is: from now on he only goes down, by [`fall`](Self::fall).
    pub fn strike(&mut self, rig: &Rig) {
        let at = self.moves.time;
        let from = self.state.kind;
        self.state = State {
            kind: Kind::Die,
            since: at,
        };
        let new = self.state.pose(&self.moves, self.pace, rig);
        let (earlier, seconds) = (&self.earlier.0, self.earlier.1);
        let fade_in = self.state.fade_in(from);
        self.fade = Fade::new(at, fade_in, &self.base, (earlier, seconds), &new);
    }

    /// Goes down for so many seconds more, in his own time.
    pub fn fall(&mut self, span: f64, rig: &Rig, ground: &dyn Ground) {
        let moves = Moves {
            time: self.moves.time + span,
            facing: self.moves.side(),
            ..Moves::standing(self.moves.foot)
        };
        let deaths = self.moves.deaths;
        self.advance(&Moves { deaths, ..moves }, rig, ground);
    }

    /// Whether he was put elsewhere rather than moved there.
    fn is_cut(&self, moves: &Moves, span: f64) -> bool {
        let speed = moves.velocity.length().max(self.moves.velocity.length());
        moves.foot.distance(self.moves.foot) > 1.0 + 2.0 * speed * span
    }

    /// Begins another movement, at the time of the event that caused it.
    fn change_movement(&mut self, moves: &Moves, rig: &Rig) {
        let next = self.state.next(moves, rig);
        if next == self.state {
            return;
        }
        let span = moves.time - self.moves.time;
        let at = next.since.clamp(self.moves.time, moves.time);
        let share = if span > 0.0 {
            (at - self.moves.time) / span
        } else {
            1.0
        };
        let between = moves.since(&self.moves, share);
        self.play(&between, rig);
        if matches!(next.kind, Kind::Go | Kind::Crawl) && !self.state.stands() {
            self.pace.rounds = (self.pace.rounds * 2.0).ceil() / 2.0; // a foot is just down
            self.pace.run = run_share(moves);
        }
        if next.kind == Kind::Air {
            self.pace.fall = fall_share(moves);
        }
        let from = self.state.kind;
        self.state = next;
        let begun = Moves {
            time: at,
            foot: between.foot,
            ..*moves
        };
        let new = next.pose(&begun, self.pace, rig);
        let (earlier, seconds) = (&self.earlier.0, self.earlier.1);
        self.fade = Fade::new(at, next.fade_in(from), &self.base, (earlier, seconds), &new);
    }

    /// Lets the movement that he is in go on.
    fn play(&mut self, moves: &Moves, rig: &Rig) {
        let span = moves.time - self.moves.time;
        let mean = (self.moves.own_velocity() + moves.own_velocity()) * 0.5;
        let forward = match self.state.kind {
            // Who comes to a wall with the speed of a jump holds on rather than grasping a dozen times a second.
            Kind::ClimbWall | Kind::Ladder => mean.y.clamp(-CLIMBS, CLIMBS) * span,
            _ => mean.x * span * f64::from(moves.side()),
        };
        self.pace.run += (run_share(moves) - self.pace.run) * share(PACING, span as f32);
        self.pace.fall += (fall_share(moves) - self.pace.fall) * share(PACING, span as f32);
        self.pace.rounds += forward / f64::from(stride(self.state.kind, self.pace, rig));
        let mut pose = self.state.pose(moves, self.pace, rig);
        self.fade.apply(moves.time, &mut pose);
        if span > 0.0 {
            self.earlier = (self.base, span as f32);
        }
        self.base = pose;
        self.moves = *moves;
    }

    /// What follows the body late.
    fn follow(&mut self, before: &Moves, moves: &Moves, span: f32, ground: &dyn Ground) {
        let on_ground = self.state.is_on_ground();
        let (to, rate) = match on_ground {
            true => (1.0, GROUNDING.0),
            false => (0.0, GROUNDING.1),
        };
        self.weight += (to - self.weight) * share(rate, span);
        let goal = facing(self.state.kind, moves, self.pace.run, self.yaw);
        self.yaw += (goal - self.yaw) * share(TURNING, span);
        let change = (moves.own_velocity() - before.own_velocity()).x as f32 * moves.side();
        let pushed = match span > 0.0 && on_ground {
            true => (change / span / LEAN.1).clamp(-1.0, 1.0) * LEAN.0,
            false => 0.0,
        };
        let uphill = moves.slope().atan() * moves.side() * UPHILL;
        self.lean += (pushed + uphill - self.lean) * share(LEANING, span);
        self.slope += (moves.slope() - self.slope) * share(SLOPING, span);
        self.gaze += (gaze(self.state.kind, moves) - self.gaze) * share(GAZING, span);
        let kind = self.state.kind;
        self.beside.follow(kind, (before, moves), span, ground);
    }

    /// Squashed by landings, stretched by speed: the factor upwards, while the volume stays.
    fn squash(&self) -> f32 {
        let age = (self.moves.time - self.moves.landed.0).clamp(0.0, FORGOTTEN) as f32;
        let down = (self.moves.landed.1 / SQUASHED_AT).min(1.0) * STRETCH;
        let landed =
            down * (1.0 - (-70.0 * age).exp()) * (-13.0 * age).exp() * (20.0 * age).cos() * 1.4;
        let speed = (self.moves.velocity.y as f32).abs() / STRETCHED_AT;
        let flight = STRETCH * smooth(speed) * (1.0 - self.weight);
        let squash = flight - landed * self.weight;
        let rolls = matches!(self.state.kind, Kind::Roll | Kind::Die | Kind::GetUp);
        1.0 + if rolls {
            0.0
        } else {
            squash.clamp(-STRETCH, STRETCH)
        }
    }

    /// From the figure's space to the level's axes about the body's foot, without the squash.
    fn rigid(&self) -> Mat4 {
        Mat4::from_rotation_translation(Quat::from_rotation_y(self.yaw), self.beside.place())
    }

    /// The whole pose but what hangs: lean, gaze, feet.
    fn finish(&mut self, span: f32, moved: Vec3, rig: &Rig, ground: &dyn Ground) -> Pose {
        let mut pose = self.base;
        self.bow(rig, &mut pose);
        let squash = self.squash();
        (self.shown.foot, self.shown.squash) = (self.moves.foot, squash);
        (self.shown.yaw, self.shown.offset) = (self.yaw, self.beside.place());
        if self.weight < 0.01 {
            self.feet = [Foot::default(); 2];
            self.drop = 0.0;
            return pose;
        }
        let moves = self.moves;
        let carried = (moves.carried * f64::from(span)).as_vec2().extend(0.0);
        let step = Step {
            span,
            moved: moved - carried,
            stands: self.state.stands(),
            on_ground: self.state.is_on_ground(),
            rests: matches!(self.state.kind, Kind::Idle | Kind::Crouch),
            ground,
            foot: moves.foot,
            weight: self.weight,
            slope: self.slope,
            lands: 0.0,
        };
        let clean = rig.model.skeleton.place(&self.base);
        let level = Mat4::from_translation(self.beside.place().with_y(0.0))
            * Mat4::from_rotation_y(self.yaw);
        let feet = [0, 1].map(|side| level * clean.bones[rig.legs[side].bones[2]]);
        let lands = self.lands(feet.map(|foot| foot.w_axis.y));
        let mut follow = |side: usize| {
            let lands = lands[side];
            let busy = self.feet[1 - side].is_stepping();
            let step = Step { lands, ..step };
            self.feet[side].follow(&feet[side], &rig.legs[side], &step, busy)
        };
        let goals = [follow(0), follow(1)];
        let stand = self.rigid() * Mat4::from_scale(widths(squash));
        let back = stand.inverse();
        let beside = self.beside.place().y;
        // A foot in the air goes along with the body, but not into the ground; one on the ground does not.
        let lift = |goal: Goal| Vec3::Y * (beside * (1.0 - goal.load)).max(-goal.low.max(0.0));
        let mut ankles = goals.map(|goal| back.transform_point3(goal.ankle + lift(goal)));
        self.sink(span, &goals.map(|goal| goal.load), &ankles, rig, &pose);
        pose.bones[rig.bone(Bone::Hips)].place.y -= self.drop;
        for (ankle, goal) in ankles.iter_mut().zip(&goals) {
            ankle.y -= self.drop.min(goal.low.max(0.0)) * (1.0 - goal.load);
        }
        let placed = rig.model.skeleton.place(&pose);
        for i in 0..2 {
            let tilt =
                Quat::from_rotation_y(-self.yaw) * goals[i].tilt * Quat::from_rotation_y(self.yaw);
            let sole = tilt * Quat::from_mat4(&clean.bones[rig.legs[i].bones[2]]);
            put_leg(rig, i, &placed, ankles[i], sole, &mut pose);
        }
        pose
    }

    /// How far the feet are brought down to the ground for a landing: both, or in a run the lower one.
    fn lands(&self, heights: [f32; 2]) -> [f32; 2] {
        let age = (self.moves.time - self.moves.landed.0).min(FORGOTTEN) as f32;
        if !self.state.stands() || !(0.0..LANDS).contains(&age) {
            return [0.0; 2];
        }
        let down = share(LANDING, age) * (1.0 - smooth(age / LANDS));
        let runs = matches!(self.state.kind, Kind::Go | Kind::Turn | Kind::Crawl);
        [0, 1].map(|side| match runs && heights[side] > heights[1 - side] {
            true => 0.0,
            false => down,
        })
    }

    /// Leans and looks.
    fn bow(&self, rig: &Rig, pose: &mut Pose) {
        let steady = !matches!(self.state.kind, Kind::Roll | Kind::Die | Kind::GetUp);
        if !steady {
            return;
        }
        let mut turn = |bone: Bone, by: Quat| {
            let bone = &mut pose.bones[rig.bone(bone)];
            bone.turn = (by * bone.turn).normalize();
        };
        for (bone, part) in [(Bone::Spine, 0.6), (Bone::Chest, 0.4)] {
            turn(bone, Quat::from_rotation_z(-self.lean * part));
        }
        for (bone, part) in [(Bone::Neck, 0.4), (Bone::Head, 0.6)] {
            let nod = Quat::from_rotation_z((self.gaze.y + self.lean * 0.8) * part);
            turn(bone, Quat::from_rotation_y(self.gaze.x * part) * nod);
        }
    }

    /// Lets the hips sink as far as the legs need to reach the ground.
    fn sink(&mut self, span: f32, loads: &[f32; 2], ankles: &[Vec3; 2], rig: &Rig, pose: &Pose) {
        let placed = rig.model.skeleton.place(pose);
        let mut need = 0.0f32;
        for i in 0..2 {
            let leg = &rig.legs[i];
            let hip = placed.bones[leg.bones[0]].transform_point3(Vec3::ZERO);
            let length = BENT * (leg.lengths[0] + leg.lengths[1]);
            let aside = (ankles[i] - hip).with_y(0.0).length_squared();
            let reach = (length * length - aside).max(0.0).sqrt();
            let lacks = hip.y - ankles[i].y - reach;
            if lacks > SINKS {
                self.feet[i].let_go(); // nobody goes to his knees for a step
            } else {
                need = need.max(lacks * loads[i]);
            }
        }
        let goal = need.clamp(0.0, SINKS);
        let sinks = goal > self.drop;
        let part = match span > 0.0 {
            true => share(if sinks { SINKING.0 } else { SINKING.1 }, span),
            false => 1.0,
        };
        self.drop += (goal - self.drop) * part;
    }

    /// The body as the cape sees it.
    fn outline(&self, rig: &Rig, placed: &Placed) -> Outline {
        let stand = self.rigid();
        let at = |bone: Bone| (stand * placed.bones[rig.bone(bone)]).transform_point3(Vec3::ZERO);
        let bones = [Bone::Hips, Bone::Neck, Bone::ShinLeft, Bone::ShinRight];
        Outline {
            forward: Quat::from_rotation_y(self.yaw) * Vec3::X,
            joints: bones.map(at),
            ground: self.state.is_on_ground().then_some(self.slope),
        }
    }

    /// Turns what hangs, and keeps the whole as what is shown.
    fn hang(&mut self, mut pose: Pose, mut placed: Placed, rig: &Rig) {
        self.tails.bend(rig, &mut placed, &self.rigid(), &mut pose);
        self.shown.pose = pose;
    }

    /// Which end of a foot (0 left, 1 right) carries him: 0 the heel, 1 the ball; `None` while it is in the air.
    pub fn stands_on(&self, side: usize) -> Option<usize> {
        self.feet[side].stands_on()
    }

    /// Whether all of it are finite numbers.
    pub fn is_finite(&self) -> bool {
        self.shown.pose.is_finite() && self.tails.is_finite() && self.shown.offset.is_finite()
    }
}

fn moment(moves: &Moves, moved: Vec3) -> Moment {
    Moment {
        time: moves.time,
        foot: moves.foot,
        moved,
        velocity: moves.velocity.as_vec2().extend(0.0),
    }
}

/// Factors of the size for a factor upwards, with the same volume.
pub fn widths(squash: f32) -> Vec3 {
    let wide = 1.0 / squash.sqrt();
    Vec3::new(wide, squash, wide)
}

/// Bends a leg so that its ankle is at a place and its sole has a turn, in the figure's space.
fn put_leg(rig: &Rig, side: usize, placed: &Placed, ankle: Vec3, sole: Quat, pose: &mut Pose) {
    let leg = &rig.legs[side];
    let at = |bone: usize| placed.bones[bone].transform_point3(Vec3::ZERO);
    let turn = |bone: usize| Quat::from_mat4(&placed.bones[bone]);
    let [thigh, shin, foot] = leg.bones;
    let limb = Limb {
        hip: at(thigh),
        knee: at(shin),
        ankle: at(foot),
    };
    let [first, second] = reach(limb, leg.lengths, ankle, Vec3::X);
    let above = rig.model.skeleton.joints[thigh].parent;
    let above = above.map_or(Quat::IDENTITY, &turn);
    let upper = first * turn(thigh);
    let lower = second * first * turn(shin);
    pose.bones[thigh].turn = (above.conjugate() * upper).normalize();
    pose.bones[shin].turn = (upper.conjugate() * lower).normalize();
    pose.bones[foot].turn = (lower.conjugate() * sole).normalize();
}
