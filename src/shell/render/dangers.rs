//! What kills, so that it reads at a glance: spikes out of the stone that a hazard touches, a ring of teeth around one
//! that touches none. All of it is black, with tips of one colour that nothing else in the game has.

use super::fixtures::{bounds, edges, outline};
use super::frame::PointLight;
use super::kit::{Kit, Part};
use super::model::{Model, Paint, paint};
use crate::level::{Feature, Kind};
use glam::{Mat4, Vec2, Vec3};

/// The one colour of dangers: red-hot iron.
pub const HOT: Paint = paint(0xff4e1e).glowing(1.0).varied(0.05);
/// What carries it.
const BLACK: Paint = paint(0x2a2830).varied(0.10);

/// How far outside an edge stone is looked for, in metres.
const REACH: f32 = 0.08;
/// Longest spikes and teeth, in metres.
const SPIKE: f32 = 1.6;
const TOOTH: f32 = 0.45;
/// Teeth are at most this share of the thickness of what bears them.
const THICK: f32 = 0.3;
/// How far a corner may stand out where two sides meet sharply: one plus the cosine between them is at least this.
const SHARPEST: f32 = 0.3;
/// Height of a tooth of the piece, in metres.
const TOOTH_OF_PIECE: f32 = 0.5;
/// Front and back of the body that carries teeth.
const BODY: [f32; 2] = [0.30, -0.72];
/// The glow of dangers: metres between lamps, reach, colour.
const APART: f32 = 4.0;
const GLOW_REACH: f32 = 3.6;
const GLOW: Vec3 = Vec3::new(1.5, 0.30, 0.08);

/// Builds a hazard among the features that stand still or move with it.
pub fn build(
    kit: &Kit,
    hazard: &Feature,
    among: &[&Feature],
    model: &mut Model,
    lamps: &mut Vec<PointLight>,
) {
    let roots = roots(hazard, among);
    if roots.is_empty() {
        ring(kit, hazard, model);
    }
    for (a, b) in roots {
        let inward = (b - a).normalize_or_zero().perp();
        let depth = outline(hazard).map(|p| (p - a).dot(inward));
        let height = depth.fold(0.0, f32::max).min(SPIKE);
        row(kit.part(Part::Spikes), a, b, inward, height, model);
    }
    shine(hazard, lamps);
}

/// The edges that spikes grow from: those on stone; of these the ones below, else those above, else those at the sides.
fn roots(hazard: &Feature, among: &[&Feature]) -> Vec<(Vec2, Vec2)> {
    let solid = |p: Vec2| {
        let mut solids = among.iter().filter(|feature| feature.kind == Kind::Solid);
        solids.any(|feature| contains(feature, p))
    };
    let rooted = |&(a, b): &(Vec2, Vec2)| {
        let out = -(b - a).normalize_or_zero().perp() * REACH;
        let touching = [0.2, 0.5, 0.8].map(|share| solid(a.lerp(b, share) + out));
        touching.iter().filter(|&&touches| touches).count() >= 2
    };
    let all: Vec<_> = edges(hazard).into_iter().filter(rooted).collect();
    let up = |&(a, b): &(Vec2, Vec2)| (b - a).normalize_or_zero().perp().y;
    let below = all.iter().copied().filter(|edge| up(edge) > 0.5);
    let above = all.iter().copied().filter(|edge| up(edge) < -0.5);
    [below.collect(), above.collect(), all.clone()]
        .into_iter()
        .find(|edges: &Vec<_>| !edges.is_empty())
        .unwrap_or_default()
}

/// Whether a point is inside a feature's outline: an odd number of its edges lies to the right of it.
pub fn contains(feature: &Feature, p: Vec2) -> bool {
    let crossings = edges(feature).into_iter().filter(|(a, b)| {
        let level = (a.y > p.y) != (b.y > p.y);
        level && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)
    });
    crossings.count() % 2 == 1
}

/// Pieces of a metre side by side along an edge, growing along `up` to a height.
fn row(piece: &Model, a: Vec2, b: Vec2, up: Vec2, height: f32, model: &mut Model) {
    let length = a.distance(b);
    let count = length.round().max(1.0);
    let along = (b - a) / length.max(f32::EPSILON);
    // To the right as seen with `up` upwards, so that fronts stay in front.
    let right = if up.perp_dot(along) < 0.0 {
        along
    } else {
        -along
    };
    for i in 0..count as u32 {
        let foot = a.lerp(b, (i as f32 + 0.5) / count).extend(0.0);
        let place = Mat4::from_cols(
            (right * length / count).extend(0.0).extend(0.0),
            (up * height).extend(0.0).extend(0.0),
            Vec3::Z.extend(0.0),
            foot.extend(1.0),
        );
        model.add(piece, place);
    }
}

/// A black body with teeth all around, whose tips lie on the outline.
fn ring(kit: &Kit, hazard: &Feature, model: &mut Model) {
    let (min, max) = bounds(hazard);
    let tooth = ((max - min).min_element() * THICK).min(TOOTH);
    let sides = edges(hazard);
    let inward = |i: usize| {
        let (a, b) = sides[i % sides.len()];
        (b - a).normalize_or_zero().perp()
    };
    // Where two sides meet that are moved inwards by the length of a tooth.
    let corner = |i: usize| {
        let (before, after) = (inward(i + sides.len() - 1), inward(i));
        let mitre = (before + after) / (1.0 + before.dot(after)).max(SHARPEST);
        sides[i % sides.len()].0 + mitre * tooth
    };
    let ring = |z: f32| -> Vec<Vec3> { (0..sides.len()).map(|i| corner(i).extend(z)).collect() };
    let [front, back] = BODY.map(ring);
    model.cap(&front, BLACK);
    model.band(&back, &front, BLACK);
    for i in 0..sides.len() {
        let height = tooth / TOOTH_OF_PIECE;
        let (a, b) = (corner(i), corner(i + 1));
        row(kit.part(Part::Teeth), a, b, -inward(i), height, model);
    }
}

/// Dangers light what is around them.
fn shine(hazard: &Feature, lamps: &mut Vec<PointLight>) {
    let (min, max) = bounds(hazard);
    let count = ((max.x - min.x) / APART).round().max(1.0);
    for i in 0..count as u32 {
        let x = min.x + (max.x - min.x) * (i as f32 + 0.5) / count;
        lamps.push(PointLight {
            at: Vec3::new(x, (min.y + max.y) / 2.0, 0.4),
            reach: GLOW_REACH,
            colour: GLOW,
        });
    }
}

/// Marks the underside of what crushes: a black plate on its front with long hot teeth under a hot bar, so that even a narrow
/// one is seen from afar.
pub fn crusher(feature: &Feature, front: f32, model: &mut Model) {
    const WIDTH: f32 = 0.36;
    const HEIGHT: f32 = 0.62;
    const BAR: [f32; 2] = [0.74, 0.84];
    const PLATE: f32 = 0.92;
    const PROUD: f32 = 0.012;
    for (a, b) in edges(feature) {
        let along = (b - a).normalize_or_zero();
        if along.perp().y < 0.7 {
            continue; // not an underside: the outside is not below
        }
        let count = (a.distance(b) / WIDTH).round().max(1.0);
        for i in 0..count as u32 {
            let at = |share: f32| a.lerp(b, (i as f32 + share) / count);
            let up = along.perp();
            let [left, right] = [at(0.04), at(0.96)].map(|p| (p + up * HEIGHT).extend(front));
            let tip = at(0.5).extend(front);
            model.facet([left, tip, right], [1.0; 3], HOT);
        }
        let mut field = |[low, high]: [f32; 2], z: f32, paint: Paint| {
            let corner = |p: Vec2, height: f32| (p + along.perp() * height).extend(z);
            let corners = [
                corner(a, low),
                corner(b, low),
                corner(b, high),
                corner(a, high),
            ];
            model.quad(corners, paint);
        };
        field([0.0, PLATE], front - PROUD, BLACK);
        field(BAR, front, HOT);
    }
}

#[cfg(test)]
mod tests {
    use super::super::kit::tests::kit;
    use super::super::model::VERTEX_WORDS;
    use super::*;
    use glam::DVec2;

    fn boxed(kind: Kind, [left, bottom, right, top]: [f64; 4]) -> Feature {
        let corners = [(left, bottom), (right, bottom), (right, top), (left, top)];
        Feature {
            kind,
            outline: corners.map(DVec2::from).to_vec(),
            ..Feature::default()
        }
    }

    fn places(hazard: &Feature, among: &[&Feature]) -> Vec<Vec3> {
        let (mut model, mut lamps) = (Model::default(), Vec::new());
        build(&kit(), hazard, among, &mut model, &mut lamps);
        assert!(!lamps.is_empty());
        let place = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        model.words.chunks_exact(VERTEX_WORDS).map(place).collect()
    }

    fn extent(places: &[Vec3]) -> (Vec3, Vec3) {
        places
            .iter()
            .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), p| {
                (min.min(*p), max.max(*p))
            })
    }

    #[test]
    fn spikes_grow_out_of_the_floor_or_the_ceiling_that_they_touch() {
        let hazard = boxed(Kind::Hazard, [0.0, 0.0, 4.0, 0.8]);
        let floor = boxed(Kind::Solid, [-2.0, -2.0, 6.0, 0.0]);
        let (min, max) = extent(&places(&hazard, &[&floor, &hazard]));
        assert!(
            min.x > -0.3 && max.x < 4.3 && min.y > -0.2 && (0.7..0.85).contains(&max.y),
            "{min} {max}"
        );
        let ceiling = boxed(Kind::Solid, [-2.0, 0.8, 6.0, 2.0]);
        let (min, max) = extent(&places(&hazard, &[&ceiling, &hazard]));
        assert!(max.y < 1.0 && (-0.05..0.1).contains(&min.y), "{min} {max}");
        // What hangs shows its front as well: no facet is turned inside out.
        assert_eq!(
            roots(&hazard, &[&floor, &ceiling]).len(),
            1,
            "the floor alone"
        );
    }

    #[test]
    fn what_touches_nothing_has_teeth_all_around_that_end_at_its_outline() {
        let hazard = boxed(Kind::Hazard, [0.0, 0.0, 3.0, 2.0]);
        let (min, max) = extent(&places(&hazard, &[&hazard]));
        assert!(
            min.x > -0.1 && min.x < 0.2 && max.x < 3.1 && min.y > -0.1 && max.y < 2.1,
            "{min} {max}"
        );
    }

    #[test]
    fn a_crusher_is_marked_below_and_nowhere_else() {
        let mut model = Model::default();
        crusher(&boxed(Kind::Solid, [0.0, 1.0, 2.0, 3.0]), 0.8, &mut model);
        let place = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
        let places: Vec<Vec3> = model.words.chunks_exact(VERTEX_WORDS).map(place).collect();
        assert_eq!(places.len(), 3 * 6 + 2 * 6, "teeth, plate and bar");
        assert!(places.iter().all(|p| (1.0..2.0).contains(&p.y)));
    }
}
