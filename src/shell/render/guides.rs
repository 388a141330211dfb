//! What movers run on: a frame with a rope over wheels for a lift, a column for what stamps, a post for a door, a rail for
//! a ferry. What carries them is asked of the level: they stand on the ground, hang from a ceiling, are held by a wall, or
//! stand in the water.

use super::bearers::{Bearers, Frame, HEMP, IRON, ROOT};
use super::fixtures::outline;
use super::model::{Model, Paint, paint};
use crate::level::{Feature, Level, Material, Mover, is_upright};
use glam::Vec2;

/// Depth of posts and rails behind the hero, of what runs before them and of what braces them.
const DEPTH: f32 = -0.95;
const BEFORE: f32 = DEPTH + 0.24;
/// Half the thickness of a post or rail, and of a rope, in metres.
const POST: f32 = 0.12;
const ROPE: f32 = 0.05;
/// How far posts stand within the sides of what rides on them.
const WITHIN: f32 = 0.22;
/// How far a way goes on beyond the first and the last stop.
const BEYOND: f32 = 0.5;
/// How far a frame rises over what stamps at its highest stop, and over a lift, whose rider must not have a wheel behind his head.
const HEAD: f32 = 0.85;
const HEADROOM: f32 = 2.4;
/// Radius of the wheels that ropes run over.
const WHEEL: f32 = 0.34;
/// Rise of one of the braces that run to and fro between two posts, by their distance: no rung, nobody climbs here.
const BRACES: f32 = 1.0;
/// What leaves less room than this between its posts, in metres, has one post: a door.
const DOOR: f32 = 0.5;
/// How far below and above stone is looked for to stand on and to hang from, beside a frame, and beyond the end of a rail.
const BELOW: f32 = 9.0;
const ABOVE: f32 = 6.0;
const BESIDE: f32 = 4.0;
const ALONG: f32 = 10.0;
/// How much of its length the strut under an arm rises.
const STRUT: f32 = 0.8;

const RUST: Paint = paint(0x6e5348).varied(0.14);
const WOOD: Paint = paint(0x6d4d36).varied(0.12);

/// Builds the guides of all movers of a level over water of a height; they stand still.
pub fn build(level: &Level, water: f32) -> Model {
    let bearers = Bearers::stone(level, water);
    let mut model = Model::default();
    for mover in &level.movers {
        frame(mover, &bearers).build(&mut model);
    }
    model
}

/// What one mover runs on.
fn frame(mover: &Mover, bearers: &Bearers) -> Frame {
    // What runs on it is its terrain; what has none, like a saw, all of it.
    let is_terrain = |f: &&Feature| f.kind.is_terrain();
    let has_terrain = mover.features.iter().any(|f| f.kind.is_terrain());
    let runs = || {
        let all = mover.features.iter();
        all.filter(move |f| !has_terrain || is_terrain(f))
    };
    let corners = || runs().flat_map(outline);
    let min = corners().fold(Vec2::INFINITY, Vec2::min);
    let max = corners().fold(Vec2::NEG_INFINITY, Vec2::max);
    let timber = runs().all(|f| f.material == Material::Timber);
    let mut frame = Frame::default();
    for (a, b) in ways(mover) {
        let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
        if !is_upright((b - a).as_dvec2()) {
            let middle = (min + max) / 2.0;
            rail(middle + a, middle + b, bearers, &mut frame);
            continue;
        }
        let top = Vec2::new((min.x + max.x) / 2.0 + b.x, max.y + b.y);
        let room = if timber { HEADROOM } else { HEAD };
        let way = Upright {
            foot: Vec2::new((min.x + max.x) / 2.0 + a.x, min.y + a.y - BEYOND),
            head: top + Vec2::Y * bearers.reach(top, Vec2::Y, room).unwrap_or(room),
            half: (max.x - min.x) / 2.0 - WITHIN,
            timber,
        };
        match way.half < DOOR {
            true => way.post(bearers, &mut frame),
            false => way.hoist(bearers, &mut frame),
        }
    }
    frame
}

/// The ways from stop to stop, as offsets; those of a loop back to the first one as well.
fn legs(mover: &Mover) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
    mover.legs().map(|(a, b)| (a.as_vec2(), b.as_vec2()))
}

/// The ways between stops, each once.
fn ways(mover: &Mover) -> Vec<(Vec2, Vec2)> {
    let mut once: Vec<(Vec2, Vec2)> = Vec::new();
    for (a, b) in legs(mover) {
        if a != b && !once.contains(&(a, b)) && !once.contains(&(b, a)) {
            once.push((a, b));
        }
    }
    once
}

/// A way up.
struct Upright {
    foot: Vec2,
    head: Vec2,
    /// Half the distance of its posts, in metres.
    half: f32,
    /// Whether wood runs on it: a lift, else something that stamps.
    timber: bool,
}

impl Upright {
    /// Where the ground below its foot and the ceiling over its head would hold a post so far aside.
    fn roots(&self, aside: f32, bearers: &Bearers) -> [Option<Vec2>; 2] {
        let ends = [(self.foot, Vec2::NEG_Y, BELOW), (self.head, Vec2::Y, ABOVE)];
        ends.map(|(end, along, most)| bearers.root(end + Vec2::X * aside, along, most))
    }

    /// The one post of a door.
    fn post(&self, bearers: &Bearers, frame: &mut Frame) {
        let [foot, head] = self.roots(0.0, bearers);
        let (from, to) = match (foot, head) {
            (None, None) => (bearers.drowned(self.foot), self.head),
            (foot, head) => (foot.unwrap_or(self.foot), head.unwrap_or(self.head)),
        };
        frame.beam(from, to, POST, DEPTH, IRON);
    }

    /// Two posts with a head; between them braces and a rope over wheels, or the column of what stamps.
    fn hoist(&self, bearers: &Bearers, frame: &mut Frame) {
        let (rail, other) = if self.timber {
            (WOOD, IRON)
        } else {
            (IRON, RUST)
        };
        let sides = [-self.half, self.half];
        let posts = sides.map(|side| [self.foot, self.head].map(|p| p + Vec2::X * side));
        let roots = sides.map(|side| self.roots(side, bearers));
        let [stands, hangs] = [0, 1].map(|end| roots.iter().all(|root| root[end].is_some()));
        let held = stands || hangs || self.arms(posts, bearers, rail, frame);
        let ends = [0, 1].map(|i| {
            let [foot, head] = posts[i];
            let [stand, hang] = roots[i];
            let down = match (stand, held) {
                (Some(root), _) => root,
                (None, true) => foot,
                (None, false) => bearers.drowned(foot),
            };
            (down, hang.filter(|_| hangs).unwrap_or(head))
        });
        for (from, to) in ends {
            frame.beam(from, to, POST, DEPTH, rail);
        }
        let over = Vec2::X * (self.half + WITHIN);
        frame.beam(self.head - over, self.head + over, POST, DEPTH, rail);
        if !self.timber {
            let [floor, ceiling] = self.roots(0.0, bearers);
            let (from, to) = (floor.unwrap_or(self.foot), ceiling.unwrap_or(self.head));
            frame.beam(from, to, POST * 1.3, BEFORE, other);
            return;
        }
        frame.brace(ends, 2.0 * self.half * BRACES, other);
        frame.beam(self.foot - over, self.foot + over, POST, DEPTH, rail);
        for at in [self.foot, self.head] {
            frame.wheels.push((at, WHEEL, BEFORE, other));
        }
        for side in [-1.0, 1.0] {
            let [foot, head] = [self.foot, self.head].map(|p| p + Vec2::X * side * WHEEL);
            frame.beam(foot, head, ROPE, BEFORE, HEMP);
        }
    }

    /// Arms from a wall beside it at foot and head, each on a strut where there is wall enough; whether there are any.
    fn arms(
        &self,
        posts: [[Vec2; 2]; 2],
        bearers: &Bearers,
        paint: Paint,
        frame: &mut Frame,
    ) -> bool {
        let ways = [Vec2::NEG_X, Vec2::X].into_iter().zip(posts);
        let roots = ways.map(|(side, post)| {
            let roots = post.map(|p| bearers.root(p, side, BESIDE));
            (side, post, roots)
        });
        let most = roots.max_by_key(|(_, _, roots)| roots.iter().flatten().count());
        let Some((side, post, roots)) = most else {
            return false;
        };
        let mut any = false;
        for (from, root) in post.into_iter().zip(roots) {
            let Some(root) = root else { continue };
            any = true;
            frame.beam(from - side * 2.0 * self.half, root, POST, DEPTH, paint);
            frame.plate(root - side * ROOT, side, DEPTH);
            let low = from - Vec2::Y * (root - from).length() * STRUT;
            if let Some(foot) = bearers.root(low, side, BESIDE) {
                frame.beam(from, foot, POST * 0.8, DEPTH, paint);
            }
        }
        any
    }
}

/// A rail from stop to stop, and on to what holds its ends: a wall, else a post.
fn rail(a: Vec2, b: Vec2, bearers: &Bearers, frame: &mut Frame) {
    let along = (b - a).normalize_or_zero();
    let ends = [(a, -along), (b, along)].map(|(stop, out)| {
        let end = stop + out * BEYOND;
        if let Some(root) = bearers.root(end, out, ALONG) {
            frame.plate(root - out * ROOT, out, DEPTH);
            return root;
        }
        let ground = bearers.root(end, Vec2::NEG_Y, BELOW);
        let ceiling = bearers.root(end, Vec2::Y, ABOVE);
        let root = ground.or(ceiling).unwrap_or(bearers.drowned(end));
        frame.beam(end, root, POST, DEPTH, WOOD);
        frame.wheels.push((end, WHEEL, BEFORE, IRON));
        end
    });
    frame.beam(ends[0], ends[1], POST, DEPTH, RUST);
}

#[cfg(test)]
mod tests {
    use super::super::bearers::tests::{extent, floating, level, quarry};
    use super::super::scene;
    use super::*;
    use crate::level::{Feature, Repeat, Stop};
    use glam::DVec2;

    fn lift(to: (f64, f64), repeat: Repeat) -> Mover {
        let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 0.5), (0.0, 0.5)];
        let stop = |at: (f64, f64)| Stop {
            at: DVec2::from(at),
            ..Stop::default()
        };
        Mover {
            id: "lift".into(),
            features: vec![Feature {
                material: Material::Timber,
                outline: corners.map(DVec2::from).to_vec(),
                ..Feature::default()
            }],
            path: vec![stop((0.0, 0.0)), stop(to)],
            repeat,
            starts: Default::default(),
            ..Mover::default()
        }
    }

    #[test]
    fn guides_reach_from_the_first_stop_to_the_last() {
        for (to, stamping) in [((0.0, 5.0), true), ((6.0, 0.0), false)] {
            let mover = lift(to, Repeat::Loop);
            assert_eq!(ways(&mover).len(), 1, "there and back is one way");
            let mut iron = mover.clone();
            iron.features[0].material = Material::Iron;
            assert_eq!(iron.crushers().count(), usize::from(stamping));
            let frame = frame(&mover, &Bearers::default());
            let (min, max) = extent(&frame);
            assert!(max.x - min.x > to.0 as f32 && max.y - min.y > to.1 as f32);
            assert!(
                frame.beams.iter().all(|beam| beam.depth < -0.5),
                "behind the hero"
            );
        }
    }

    /// What carries a lift from 0 to 5 m: the ground if it is near, else a ceiling, else a wall, else the water.
    #[test]
    fn a_lift_is_carried_by_what_is_there() {
        let ground = "(id: \"g\", outline: [(-9, -4), (9, -4), (9, -3), (-9, -3)]),";
        let ceiling = "(id: \"c\", outline: [(-9, 9), (9, 9), (9, 10), (-9, 10)]),";
        let wall = "(id: \"w\", outline: [(5, -5), (6, -5), (6, 12), (5, 12)]),";
        let mover = lift((0.0, 5.0), Repeat::PingPong);
        let far = |features: &str| {
            let bearers = Bearers::stone(&level(features), -10.0);
            let frame = frame(&mover, &bearers);
            assert_eq!(floating(&frame, &bearers), [], "{features}");
            extent(&frame)
        };
        let (low, high) = far(&[ground, wall].concat());
        assert!(low.y < -3.0 && high.x < 3.0, "stands: {low} {high}");
        let (low, high) = far(&[ceiling, wall].concat());
        assert!(
            low.y > -2.0 && high.y > 9.0 && high.x < 3.0,
            "hangs: {low} {high}"
        );
        let (low, high) = far(wall);
        assert!(low.y > -6.0 && high.x > 5.0, "is held: {low} {high}");
        let (low, high) = far("");
        assert!(low.y < -10.0 && high.x < 3.0, "in the water: {low} {high}");
    }

    #[test]
    fn a_rail_ends_at_walls_or_on_posts() {
        let wall = "(id: \"w\", outline: [(-6, -5), (-5, -5), (-5, 12), (-6, 12)]),";
        let mover = lift((6.0, 0.0), Repeat::PingPong);
        let bearers = Bearers::stone(&level(wall), -10.0);
        let frame = frame(&mover, &bearers);
        assert_eq!(floating(&frame, &bearers), []);
        let (low, _) = extent(&frame);
        assert!(low.x < -5.0 && low.y < -10.0, "{low}");
        assert_eq!(frame.wheels.len(), 1, "where no wall is");
    }

    #[test]
    fn in_the_quarry_no_guide_floats() {
        let level = quarry();
        let bearers = Bearers::stone(&level, scene::water(&level));
        for mover in &level.movers {
            let floating = floating(&frame(mover, &bearers), &bearers);
            assert_eq!(floating, [], "{}", mover.id);
        }
    }
}
