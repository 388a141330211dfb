//! What may carry something: the deep stone of a level, asked by what hangs, stands or is held in the air; and frames of
//! beams and wheels that lead there.

use super::model::{Model, Paint, paint};
use crate::level::{Feature, Kind, Level, Material};
use glam::{Mat4, Vec2, Vec3};

/// How far beams go into what holds them, in metres.
pub const ROOT: f32 = 0.35;
/// Half the thickness of a brace, in metres.
pub const BRACE: f32 = 0.065;
/// What posts, rods and plates are made of, and ropes.
pub const IRON: Paint = paint(0x4b4d55).varied(0.10);
pub const HEMP: Paint = paint(0x8f7a56).varied(0.08);
/// How deep under the water what stands in it ends.
const SUNK: f32 = 2.0;
/// Half the side of the plate where a beam meets stone, and half its thickness.
const PLATE: (f32, f32) = (0.26, 0.08);
/// Half the thickness of a wheel, and how much of its radius its groove has.
const WHEEL: f32 = 0.10;
const GROOVE: f32 = 0.78;
/// The hub of a wheel: share of its radius, how far it stands out in metres, and how much brighter it is.
const HUB: (f32, f32, f32) = (0.4, 0.05, 0.45);
const BRIGHT: Paint = paint(0xc8b89a);
/// Facets around a wheel.
const SIDES: usize = 9;

/// The outlines of what stands still and may bear something.
#[derive(Default)]
pub struct Bearers {
    edges: Vec<(Vec2, Vec2)>,
    /// Height of the water, under which nothing is seen any more.
    water: f32,
}

impl Bearers {
    /// The stone of a level: timber and iron are too thin to hold what stands behind the plane of play.
    pub fn stone(level: &Level, water: f32) -> Bearers {
        let is_deep = |f: &&Feature| matches!(f.material, Material::Rock | Material::Masonry);
        Bearers::of(level.features.iter().filter(is_deep), water)
    }

    /// All solids of a level.
    pub fn solids(level: &Level, water: f32) -> Bearers {
        Bearers::of(level.features.iter(), water)
    }

    fn of<'a>(features: impl Iterator<Item = &'a Feature>, water: f32) -> Bearers {
        let solid = features.filter(|feature| feature.kind == Kind::Solid);
        Bearers {
            edges: solid.flat_map(super::fixtures::edges).collect(),
            water,
        }
    }

    /// Whether a point is inside one of them: they lie to the left of their edges, so the edges that a way to the right
    /// crosses upwards outnumber the others.
    pub fn hold(&self, p: Vec2) -> bool {
        let mut around = 0;
        for (a, b) in &self.edges {
            let rises = a.y <= p.y && b.y > p.y;
            if rises || (b.y <= p.y && a.y > p.y) {
                let x = a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
                if x > p.x {
                    around += if rises { 1 } else { -1 };
                }
            }
        }
        around > 0
    }

    /// How far it is from a point along a unit vector until something holds, if that is at most so far; 0 inside.
    pub fn reach(&self, from: Vec2, along: Vec2, most: f32) -> Option<f32> {
        if self.hold(from) {
            return Some(0.0);
        }
        let met = self.edges.iter().filter_map(|&(a, b)| {
            let side = (b - a).perp_dot(along);
            let far = (b - a).perp_dot(a - from) / side;
            let share = along.perp_dot(a - from) / side;
            (far >= 0.0 && far <= most && (0.0..=1.0).contains(&share)).then_some(far)
        });
        met.min_by(f32::total_cmp)
    }

    /// The end of a beam that leads from a point along a unit vector into what holds.
    pub fn root(&self, from: Vec2, along: Vec2, most: f32) -> Option<Vec2> {
        let far = self.reach(from, along, most)?;
        Some(from + along * (far + ROOT))
    }

    /// The place under the water below a point.
    pub fn drowned(&self, from: Vec2) -> Vec2 {
        Vec2::new(from.x, self.water.min(from.y) - SUNK)
    }
}

/// A beam, rod or rope.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// Its ends, in the plane of play.
    pub from: Vec2,
    /// The other one.
    pub to: Vec2,
    /// Half its thickness, in metres.
    pub half: f32,
    /// How far it is behind the plane of play (negative).
    pub depth: f32,
    /// What it is made of.
    pub paint: Paint,
}

/// What carries one thing: beams and wheels.
#[derive(Default)]
pub struct Frame {
    /// Its beams.
    pub beams: Vec<Beam>,
    /// Middles, radii, depths and paints of its wheels, each on a beam.
    pub wheels: Vec<(Vec2, f32, f32, Paint)>,
}

impl Frame {
    /// Adds a beam.
    pub fn beam(&mut self, from: Vec2, to: Vec2, half: f32, depth: f32, paint: Paint) {
        self.beams.push(Beam {
            from,
            to,
            half,
            depth,
            paint,
        });
    }

    /// Adds the plate through which a beam meets a wall, a ceiling or a floor, by where it does and along which axis.
    pub fn plate(&mut self, at: Vec2, along: Vec2, depth: f32) {
        let across = along.perp() * PLATE.0;
        self.beam(at - across, at + across, PLATE.1, depth + PLATE.1, IRON);
    }

    /// Beams to and fro between two upright ones, from the foot of the left one up.
    pub fn brace(&mut self, [left, right]: [(Vec2, Vec2); 2], rise: f32, paint: Paint) {
        let depth = self.beams.last().map_or(0.0, |beam| beam.depth) - BRACE;
        let length = (left.1.y - left.0.y).min(right.1.y - right.0.y);
        let count = (length / rise).round().max(1.0);
        for i in 0..count as u32 {
            let [foot, top] = [0.0, 1.0].map(|end| (i as f32 + end) / count);
            let (a, b) = if i % 2 == 0 {
                (left, right)
            } else {
                (right, left)
            };
            let [from, to] = [a.0.lerp(a.1, foot), b.0.lerp(b.1, top)];
            self.beam(from, to, BRACE, depth, paint);
        }
    }

    /// Puts it into a model.
    pub fn build(&self, model: &mut Model) {
        for beam in &self.beams {
            let [from, to] = [beam.from, beam.to].map(|p| p.extend(beam.depth));
            model.beam(from, to, beam.half, beam.paint);
        }
        for &(at, radius, depth, paint) in &self.wheels {
            wheel(at.extend(depth), radius, paint, model);
        }
    }
}

/// A grooved wheel about the z axis.
fn wheel(at: Vec3, radius: f32, paint: Paint, model: &mut Model) {
    let mut wheel = Model::default();
    let groove = [(-1.0, 1.0), (-0.3, GROOVE), (0.3, GROOVE), (1.0, 1.0)];
    let profile = groove.map(|(height, share)| (height * WHEEL, radius * share));
    wheel.lathe(Vec3::ZERO, SIDES, &profile, paint);
    let hub =
        [(0.0, HUB.0), (WHEEL + HUB.1, HUB.0)].map(|(height, share)| (height, radius * share));
    wheel.lathe(Vec3::ZERO, SIDES, &hub, paint.towards(BRIGHT, HUB.2));
    let turn = Mat4::from_rotation_x(std::f32::consts::FRAC_PI_2);
    model.add(&wheel, Mat4::from_translation(at) * turn);
}

#[cfg(test)]
pub mod tests {
    use super::super::inward::distance;
    use super::*;
    use std::path::Path;

    /// How far apart two beams may be that bear each other, beside their thickness, in metres.
    const SLACK: f32 = 0.06;

    /// A level of features, with its water at -10.
    pub fn level(features: &str) -> Level {
        let text = format!(
            "(version: 1, name: \"n\", start: (0, 40), goal: (min: (8, 39), max: (9, 42)), bottom: -12, features: [{features}])"
        );
        crate::level::parse(&text, Path::new("test")).unwrap()
    }

    /// The game's level.
    pub fn quarry() -> Level {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("levels/quarry.ron");
        crate::level::load(&path).unwrap()
    }

    /// Whether a place holds what ends there: in stone, or out of sight under the water.
    fn is_anchor(bearers: &Bearers, p: Vec2) -> bool {
        bearers.hold(p) || p.y < bearers.water
    }

    /// The lowest and the highest corner of a frame's beams.
    pub fn extent(frame: &Frame) -> (Vec2, Vec2) {
        let ends = || frame.beams.iter().flat_map(|beam| [beam.from, beam.to]);
        let min = ends().fold(Vec2::INFINITY, Vec2::min);
        (min, ends().fold(Vec2::NEG_INFINITY, Vec2::max))
    }

    /// The distance of two pieces of line.
    fn apart(a: &Beam, b: &Beam) -> f32 {
        let to = |p: Vec2, line: &Beam| distance(p, line.from, line.to);
        let cross = |a: &Beam, b: &Beam| {
            let side = |p: Vec2| (a.to - a.from).perp_dot(p - a.from);
            (side(b.from) > 0.0) != (side(b.to) > 0.0)
        };
        if cross(a, b) && cross(b, a) {
            return 0.0;
        }
        [to(a.from, b), to(a.to, b), to(b.from, a), to(b.to, a)]
            .into_iter()
            .fold(f32::INFINITY, f32::min)
    }

    /// Where beams and wheels of a frame float: those that no chain of others leads from to stone or into the water.
    pub fn floating(frame: &Frame, bearers: &Bearers) -> Vec<Vec2> {
        let count = frame.beams.len();
        let mut held: Vec<bool> = (frame.beams.iter())
            .map(|beam| is_anchor(bearers, beam.from) || is_anchor(bearers, beam.to))
            .collect();
        for _ in 0..count {
            for i in 0..count {
                let touches = |j: usize| {
                    let (a, b) = (&frame.beams[i], &frame.beams[j]);
                    held[j] && apart(a, b) <= a.half + b.half + SLACK
                };
                held[i] = held[i] || (0..count).any(touches);
            }
        }
        let loose = (0..count).filter(|&i| !held[i]);
        let mut places: Vec<Vec2> = loose.map(|i| frame.beams[i].from).collect();
        for &(at, radius, ..) in &frame.wheels {
            let hub = |beam: &Beam| Beam {
                from: at,
                to: at + Vec2::X * 1e-3,
                ..*beam
            };
            let near = |beam: &&Beam| apart(&hub(beam), beam) <= radius;
            if !frame.beams.iter().any(|beam| near(&beam)) {
                places.push(at);
            }
        }
        places
    }

    #[test]
    fn stone_is_reached_in_every_direction_and_iron_is_no_stone() {
        let level = level(
            "(id: \"rock\", outline: [(0, 0), (4, 0), (4, 2), (0, 2)]),
             (id: \"inside\", outline: [(1, 0.5), (1, 1), (3, 1), (3, 0.5)]),
             (id: \"iron\", material: Iron, outline: [(6, 0), (7, 0), (7, 2), (6, 2)])",
        );
        let stone = Bearers::stone(&level, -10.0);
        assert!(stone.hold(Vec2::new(2.0, 0.7)) && !stone.hold(Vec2::new(6.5, 1.0)));
        let near = |from: (f32, f32), along: Vec2, far: Option<f32>| {
            assert_eq!(stone.reach(Vec2::from(from), along, 3.0), far, "{from:?}");
        };
        near((2.0, 5.0), Vec2::NEG_Y, Some(3.0));
        near((2.0, 5.5), Vec2::NEG_Y, None);
        near((2.0, -1.0), Vec2::Y, Some(1.0));
        near((-2.0, 1.0), Vec2::X, Some(2.0));
        near((5.0, 1.0), Vec2::X, None);
        near((5.0, 1.0), Vec2::NEG_X, Some(1.0));
        near((2.0, 1.0), Vec2::NEG_X, Some(0.0));
        let all = Bearers::solids(&level, -10.0);
        assert_eq!(all.reach(Vec2::new(5.0, 1.0), Vec2::X, 3.0), Some(1.0));
        assert!(is_anchor(&all, all.drowned(Vec2::new(20.0, 3.0))));
    }

    #[test]
    fn what_no_beam_leads_to_floats() {
        let stone = Bearers::stone(
            &level("(id: \"r\", outline: [(0, 0), (4, 0), (4, 2), (0, 2)])"),
            -10.0,
        );
        let mut frame = Frame::default();
        let paint = super::super::model::paint(0x808080);
        let mut beam = |from: (f32, f32), to: (f32, f32)| {
            frame.beam(Vec2::from(from), Vec2::from(to), 0.1, -1.0, paint);
        };
        beam((1.0, 1.0), (1.0, 5.0));
        beam((0.9, 5.0), (3.0, 5.0));
        beam((3.0, 4.0), (3.0, 4.5));
        assert_eq!(floating(&frame, &stone), [Vec2::new(3.0, 4.0)]);
    }
}
