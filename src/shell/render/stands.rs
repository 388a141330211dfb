//! What carries planks, grates and chains that can be climbed: struts from the wall that they begin at, posts on the ground
//! below, rods from a ceiling, or piles that stand in the water. Which it is, is asked of the level.

use super::bearers::{BRACE, Bearers, Frame, HEMP, IRON, ROOT};
use super::fixtures::{bounds, is_floor, outline};
use super::model::{Model, Paint, paint};
use crate::level::{Feature, Kind, Level, Material};
use glam::Vec2;

/// Depth of posts and struts, under the back of the boards, and of rods, which pass behind them.
const DEPTH: f32 = -0.62;
/// Where chains that can be climbed hang.
const CHAIN: f32 = -0.5;
/// Half the thickness of posts and struts, and of rods, in metres.
const POST: f32 = 0.11;
const ROD: f32 = 0.055;
/// How far below a line of boards what carries them begins.
const UNDER: f32 = 0.16;
/// How far beside and below an end of boards a solid may be that they lie on.
const TOUCHING: f32 = 0.5;
const RESTING: f32 = 0.3;
/// How far below and above stone is looked for.
const BELOW: f32 = 7.0;
const ABOVE: f32 = 8.0;
/// Where posts stand along the boards, from an end, as a share.
const WITHIN: f32 = 0.14;
/// Boards between two walls that are longer than this, in metres, have ropes to hold on to: height, half thickness.
const BRIDGE: f32 = 9.0;
const HANDRAIL: (f32, f32) = (1.0, 0.05);
/// How far along boards a strut holds them: this share of their length, and no further; how steep it is; how far the wall may be.
const STRUT: (f32, f32) = (0.62, 4.0);
const STEEP: f32 = 0.9;
const ASIDE: f32 = 1.2;
/// Posts taller than this, in metres, are braced; rise of a brace by the distance of the posts.
const TALL: f32 = 2.6;
const BRACES: f32 = 1.6;
/// Depth of piles: behind the way of who passes below.
const PILE: f32 = -1.15;
/// How far a chain's hook is looked for beside it, in what steps, and how far it hangs out.
const GALLOWS: f32 = 3.0;
const STEP: f32 = 0.25;

const WOOD: Paint = paint(0x6a4c36).varied(0.12);

/// Builds what carries the planks and chains of a level over water of a height.
pub fn build(level: &Level, water: f32) -> Model {
    let around = Around::of(level, water);
    let mut model = Model::default();
    for feature in &level.features {
        frame(feature, &around).build(&mut model);
    }
    model
}

/// What may carry things: stone, and for ends that lie on something all solids.
struct Around {
    stone: Bearers,
    solids: Bearers,
}

impl Around {
    fn of(level: &Level, water: f32) -> Around {
        Around {
            stone: Bearers::stone(level, water),
            solids: Bearers::solids(level, water),
        }
    }

    /// Whether an end of boards lies on a solid, or beside it.
    fn touches(&self, end: Vec2) -> bool {
        let aside = [0.0, TOUCHING, -TOUCHING].map(|x| Vec2::new(x, 0.0));
        let places = aside.iter().flat_map(|x| [*x, *x - Vec2::Y * RESTING]);
        places
            .into_iter()
            .any(|offset| self.solids.hold(end + offset))
    }
}

/// What carries one feature; nothing for what needs nothing.
fn frame(feature: &Feature, around: &Around) -> Frame {
    let mut frame = Frame::default();
    match (feature.kind, feature.material) {
        (Kind::OneWay, material) => {
            let paint = if material == Material::Iron {
                IRON
            } else {
                WOOD
            };
            if is_floor(feature) {
                Boards::of(feature, paint).carry(around, &mut frame);
            }
        }
        (Kind::Ladder, Material::Iron) => hook(feature, &around.stone, &mut frame),
        _ => {}
    }
    frame
}

/// A line of boards.
struct Boards {
    corners: Vec<Vec2>,
    paint: Paint,
}

impl Boards {
    fn of(feature: &Feature, paint: Paint) -> Boards {
        let corners = outline(feature).collect();
        Boards { corners, paint }
    }

    fn length(&self) -> f32 {
        let parts = self.corners.windows(2);
        parts.map(|pair| pair[0].distance(pair[1])).sum()
    }

    /// The place under the boards so far from their left end, in metres.
    fn at(&self, mut far: f32) -> Vec2 {
        for pair in self.corners.windows(2) {
            let length = pair[0].distance(pair[1]);
            if far <= length {
                return pair[0].lerp(pair[1], far / length) - Vec2::Y * UNDER;
            }
            far -= length;
        }
        self.corners[self.corners.len() - 1] - Vec2::Y * UNDER
    }

    fn carry(&self, around: &Around, frame: &mut Frame) {
        let ends = [self.at(0.0), self.at(self.length())];
        match ends.map(|end| around.touches(end + Vec2::Y * UNDER)) {
            [true, true] if self.length() > BRIDGE => self.ropes(frame),
            [true, true] => {}
            [true, false] if self.strut(Vec2::NEG_X, &around.stone, frame) => {}
            [false, true] if self.strut(Vec2::X, &around.stone, frame) => {}
            _ => self.posts(&around.stone, frame),
        }
    }

    /// Ropes to hold on to, on stakes.
    fn ropes(&self, frame: &mut Frame) {
        let up = Vec2::Y * HANDRAIL.0;
        for pair in self.corners.windows(2) {
            let [a, b] = [pair[0] + up, pair[1] + up];
            let sag = (a + b) / 2.0 - up * 0.2;
            frame.beam(a, sag, HANDRAIL.1, DEPTH, HEMP);
            frame.beam(sag, b, HANDRAIL.1, DEPTH, HEMP);
        }
        for &corner in &self.corners {
            frame.beam(
                corner - up * 0.3,
                corner + up * 1.1,
                POST * 0.7,
                DEPTH,
                self.paint,
            );
        }
    }

    /// A strut from the wall at the end on a side; whether there is wall enough.
    fn strut(&self, side: Vec2, stone: &Bearers, frame: &mut Frame) -> bool {
        let far = (self.length() * STRUT.0).min(STRUT.1);
        let from = match side.x < 0.0 {
            true => self.at(far),
            false => self.at(self.length() - far),
        };
        let low = from - Vec2::Y * far * STEEP;
        let Some(foot) = stone.root(low, side, far + ASIDE) else {
            return false;
        };
        frame.beam(from, foot, POST, DEPTH, self.paint);
        frame.plate(foot - side * ROOT, side, DEPTH);
        true
    }

    /// A pair of posts on the ground, of rods from the ceiling, or of piles in the water.
    fn posts(&self, stone: &Bearers, frame: &mut Frame) {
        let length = self.length();
        let heads = [WITHIN, 1.0 - WITHIN].map(|share| self.at(length * share));
        let ground = heads.map(|head| stone.root(head, Vec2::NEG_Y, BELOW));
        let ceiling = heads.map(|head| stone.root(head, Vec2::Y, ABOVE));
        if let ([Some(a), Some(b)], _) = (ground, ceiling) {
            self.pair([(a, heads[0]), (b, heads[1])], DEPTH, frame);
        } else if let (_, [Some(a), Some(b)]) = (ground, ceiling) {
            for (head, root) in heads.into_iter().zip([a, b]) {
                frame.beam(head, root, ROD, DEPTH - 0.35, IRON);
                frame.plate(root - Vec2::Y * ROOT, Vec2::Y, DEPTH - 0.35);
            }
        } else {
            let feet = heads.map(|head| stone.drowned(head));
            self.pair([(feet[0], heads[0]), (feet[1], heads[1])], PILE, frame);
            frame.beam(heads[0], heads[1], POST, PILE, self.paint);
        }
    }

    /// Two posts, braced if they are tall.
    fn pair(&self, posts: [(Vec2, Vec2); 2], depth: f32, frame: &mut Frame) {
        for (foot, head) in posts {
            frame.beam(foot, head, POST, depth, self.paint);
        }
        if posts.iter().any(|(foot, head)| head.y - foot.y > TALL) {
            let apart = posts[1].1.x - posts[0].1.x;
            frame.brace(posts, apart * BRACES, self.paint);
        }
    }
}

/// What a chain that can be climbed hangs from: the ceiling, an arm from a wall, else an arm on a post beside it.
fn hook(feature: &Feature, stone: &Bearers, frame: &mut Frame) {
    let (min, max) = bounds(feature);
    let top = Vec2::new((min.x + max.x) / 2.0, max.y);
    let half = (max.x - min.x) / 2.0;
    if let Some(root) = stone.root(top, Vec2::Y, GALLOWS) {
        frame.beam(top, root, POST, CHAIN, IRON);
        return;
    }
    for side in [Vec2::X, Vec2::NEG_X] {
        if let Some(root) = stone.root(top, side, GALLOWS) {
            frame.beam(top - side * half, root, POST, CHAIN, IRON);
            return;
        }
    }
    let steps = (1..).map(|step| step as f32 * STEP);
    let asides = steps.take_while(|far| *far <= GALLOWS);
    let mut feet = asides
        .flat_map(|far| [Vec2::X * far, Vec2::NEG_X * far])
        .filter_map(|aside| {
            let foot = stone.root(top + aside, Vec2::NEG_Y, GALLOWS)?;
            Some((aside, foot))
        });
    let (aside, foot) = feet
        .next()
        .unwrap_or((Vec2::X, stone.drowned(top + Vec2::X)));
    let head = top + aside;
    frame.beam(top - aside.normalize() * half, head, POST, CHAIN, IRON);
    frame.beam(foot, head, POST, CHAIN, IRON);
    let brace = aside * 0.6;
    frame.beam(
        top + aside - brace,
        head - Vec2::Y * brace.length(),
        BRACE,
        CHAIN,
        IRON,
    );
}

#[cfg(test)]
mod tests {
    use super::super::bearers::tests::{extent, floating, level, quarry};
    use super::super::scene;
    use super::*;

    const BOARDS: &str = "(id: \"b\", kind: OneWay, material: Timber, outline: [(0, 0), (4, 0)]),";
    const CLIMB: &str =
        "(id: \"c\", kind: Ladder, material: Iron, outline: [(0, -4), (1, -4), (1, 2), (0, 2)]),";

    /// The frame of the first feature among others; it must not float.
    fn carried(first: &str, others: &[&str]) -> Frame {
        let level = level(&[&[first], others].concat().concat());
        let around = Around::of(&level, -10.0);
        let frame = frame(&level.features[0], &around);
        assert_eq!(floating(&frame, &around.stone), [], "{first} {others:?}");
        frame
    }

    const WEST: &str = "(id: \"w\", outline: [(-2, -6), (0.1, -6), (0.1, 1), (-2, 1)]),";
    const EAST: &str = "(id: \"e\", outline: [(3.9, -6), (6, -6), (6, 1), (3.9, 1)]),";
    const FLOOR: &str = "(id: \"f\", outline: [(-9, -4), (9, -4), (9, -3), (-9, -3)]),";
    const ROOF: &str = "(id: \"r\", outline: [(-9, 4), (9, 4), (9, 5), (-9, 5)]),";

    #[test]
    fn boards_are_carried_by_what_is_there() {
        assert!(
            carried(BOARDS, &[WEST, EAST]).beams.is_empty(),
            "they lie on walls"
        );
        let (low, high) = extent(&carried(BOARDS, &[WEST, FLOOR, ROOF]));
        assert!(
            low.x < 0.1 && low.y > -3.0 && high.y < 0.0,
            "a strut: {low}"
        );
        let (low, high) = extent(&carried(BOARDS, &[EAST, ROOF]));
        assert!(
            high.x > 3.9 && low.y > -3.0 && high.y < 0.0,
            "a strut: {high}"
        );
        let (low, high) = extent(&carried(BOARDS, &[FLOOR, ROOF]));
        assert!(low.y < -3.0 && low.y > -4.0 && high.y < 0.0, "posts: {low}");
        let (low, high) = extent(&carried(BOARDS, &[ROOF]));
        assert!(low.y > -1.0 && high.y > 4.0, "rods: {high}");
        let (low, _) = extent(&carried(BOARDS, &[]));
        assert!(low.y < -10.0, "piles: {low}");
    }

    #[test]
    fn a_chain_hangs_from_something() {
        let (_, high) = extent(&carried(CLIMB, &[ROOF]));
        assert!(high.y > 4.0, "the ceiling: {high}");
        let wall = "(id: \"w\", outline: [(2, -6), (4, -6), (4, 6), (2, 6)]),";
        let (low, high) = extent(&carried(CLIMB, &[wall]));
        assert!(high.x > 2.0 && low.y > 1.0, "an arm: {high}");
        let ledge = "(id: \"l\", outline: [(1.5, -6), (4, -6), (4, 1), (1.5, 1)]),";
        let (low, high) = extent(&carried(CLIMB, &[ledge]));
        assert!(high.x >= 1.5 && low.y < 1.0, "a post: {high}");
    }

    #[test]
    fn in_the_quarry_no_planks_and_no_chains_float() {
        let level = quarry();
        let around = Around::of(&level, scene::water(&level));
        for feature in &level.features {
            let frame = frame(feature, &around);
            let floating = floating(&frame, &around.stone);
            // What holds on to the boards is held by them.
            let long = Boards::of(feature, WOOD).length() > BRIDGE;
            let lies = feature.kind == Kind::OneWay && long;
            assert!(floating.is_empty() || lies, "{}: {floating:?}", feature.id);
            let ends = outline(feature).filter(|end| around.touches(*end));
            let carried = ends.count() > 1 || !frame.beams.is_empty();
            assert!(carried || feature.kind != Kind::OneWay, "{}", feature.id);
        }
    }
}
