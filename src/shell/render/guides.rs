//! What movers run on: rails behind them along their paths, a wheel where a rail ends, chains that lifts hang from.

use super::fixtures::outline;
use super::kit::Kit;
use super::model::{Model, Paint, paint};
use crate::level::{Feature, Material, Mover, Repeat, SceneryKind};
use glam::{Mat4, Vec2, Vec3};

/// Depth of rails and chains, behind the hero.
const DEPTH: f32 = -0.95;
/// Half the thickness of a rail, and how far rails stand within the sides of what rides on them, in metres.
const RAIL: f32 = 0.07;
const WITHIN: f32 = 0.22;
/// How far a rail goes on beyond the last stop.
const BEYOND: f32 = 0.45;
/// Radius of the wheels at its ends.
const WHEEL: f32 = 0.24;
/// Rise of one of the braces that run to and fro between two rails, by their distance: no rung, nobody climbs here.
const BRACES: f32 = 1.0;
/// How long a piece of chain hangs down, in metres, and how large it is here.
const CHAIN: f32 = 3.9;
const FINE: f32 = 0.8;
/// A way is upright if it leads this much more upwards than sideways.
const UPRIGHT: f32 = 3.0;

const IRON: Paint = paint(0x4b4d55).varied(0.10);
const RUST: Paint = paint(0x6e5348).varied(0.14);
const WOOD: Paint = paint(0x6d4d36).varied(0.12);

/// Builds the guides of all movers; they stand still.
pub fn build(kit: &Kit, movers: &[Mover]) -> Model {
    let mut model = Model::default();
    for mover in movers {
        let corners = || mover.features.iter().flat_map(outline);
        let min = corners().fold(Vec2::INFINITY, Vec2::min);
        let max = corners().fold(Vec2::NEG_INFINITY, Vec2::max);
        let iron = mover
            .features
            .iter()
            .any(|f| f.material != Material::Timber);
        let look = if iron { [IRON, RUST] } else { [WOOD, IRON] };
        for (a, b) in ways(mover) {
            way(kit, (min, max), (a, b), look, &mut model);
        }
    }
    model
}

/// The ways from stop to stop, as offsets; those of a loop back to the first one as well.
fn legs(mover: &Mover) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
    let stops = || mover.path.iter().map(|stop| stop.at.as_vec2());
    let back = match mover.repeat {
        Repeat::Loop => stops().next_back().zip(stops().next()),
        _ => None,
    };
    stops().zip(stops().skip(1)).chain(back)
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

/// One way: upright, two braced rails and a chain; else one rail through the middle.
fn way(
    kit: &Kit,
    (min, max): (Vec2, Vec2),
    (a, b): (Vec2, Vec2),
    [rail, other]: [Paint; 2],
    model: &mut Model,
) {
    let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
    let (middle, along) = ((min + max) / 2.0, (b - a).normalize_or_zero());
    if (b - a).y < UPRIGHT * (b - a).x.abs() {
        let [from, to] = [middle + a - along * BEYOND, middle + b + along * BEYOND];
        model.beam(from.extend(DEPTH), to.extend(DEPTH), RAIL, rail);
        for end in [from, to] {
            wheel(end, other, model);
        }
        return;
    }
    let half = ((max.x - min.x) / 2.0 - WITHIN).max(RAIL);
    let (low, high) = (min.y + a.y - BEYOND, max.y + b.y + BEYOND);
    let x = |y: f32| middle.x + a.x + (b.x - a.x) * ((y - low) / (high - low)).clamp(0.0, 1.0);
    for side in [-half, half] {
        let [foot, top] = [low, high].map(|y| Vec2::new(x(y) + side, y));
        model.beam(foot.extend(DEPTH), top.extend(DEPTH), RAIL, rail);
        wheel(top, other, model);
    }
    let count = ((high - low) / (2.0 * half * BRACES)).round().max(1.0);
    for i in 0..count as u32 {
        let [foot, top] = [0.0, 1.0].map(|end| low + (high - low) * (i as f32 + end) / count);
        let side = if i % 2 == 0 { half } else { -half };
        let [from, to] = [(foot, side), (top, -side)].map(|(y, side)| Vec2::new(x(y) + side, y));
        model.beam(
            from.extend(DEPTH - RAIL),
            to.extend(DEPTH - RAIL),
            RAIL * 0.5,
            other,
        );
    }
    let lengths = ((high - low) / (CHAIN * FINE)).round().max(1.0);
    for i in 0..lengths as u32 {
        let y = high - (high - low) * i as f32 / lengths;
        let size = Vec3::new(FINE, (high - low) / (lengths * CHAIN), FINE);
        let top = Vec3::new(x(y), y, DEPTH + 0.05);
        let place = Mat4::from_translation(top) * Mat4::from_scale(size);
        model.add(kit.scenery(SceneryKind::Chain), place);
    }
}

/// A wheel about the z axis.
fn wheel(at: Vec2, paint: Paint, model: &mut Model) {
    let mut wheel = Model::default();
    let profile = [
        (-0.10, WHEEL),
        (-0.03, WHEEL * 0.8),
        (0.03, WHEEL * 0.8),
        (0.10, WHEEL),
    ];
    wheel.lathe(Vec3::ZERO, 9, &profile, paint);
    let turn = Mat4::from_rotation_x(std::f32::consts::FRAC_PI_2);
    model.add(&wheel, Mat4::from_translation(at.extend(DEPTH)) * turn);
}

/// Whether a mover goes up and down: what it comes down on is crushed.
fn stamps(mover: &Mover) -> bool {
    let upright = |(a, b): &(Vec2, Vec2)| (*b - *a).y.abs() >= UPRIGHT * (*b - *a).x.abs();
    legs(mover).filter(|(a, b)| a != b).any(|leg| upright(&leg))
}

/// The parts of a mover that are shown as dangerous: the iron of one that stamps.
pub fn crushers(mover: &Mover) -> impl Iterator<Item = &Feature> {
    let stamps = stamps(mover);
    let parts = mover.features.iter();
    parts.filter(move |feature| stamps && feature.material == Material::Iron)
}

#[cfg(test)]
mod tests {
    use super::super::kit::tests::kit;
    use super::super::model::VERTEX_WORDS;
    use super::*;
    use crate::level::Stop;
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
                outline: corners.map(DVec2::from).to_vec(),
                ..Feature::default()
            }],
            path: vec![stop((0.0, 0.0)), stop(to)],
            repeat,
            starts: Default::default(),
        }
    }

    #[test]
    fn rails_reach_from_the_first_stop_to_the_last() {
        for (to, stamping) in [((0.0, 5.0), true), ((6.0, 0.0), false)] {
            let mover = lift(to, Repeat::Loop);
            assert_eq!(ways(&mover).len(), 1, "there and back is one way");
            assert_eq!(stamps(&mover), stamping);
            let model = build(&kit(), &[mover]);
            let place = |v: &[u32]| Vec3::from_array([0, 1, 2].map(|i| f32::from_bits(v[i])));
            let places = || model.words.chunks_exact(VERTEX_WORDS).map(place);
            let max = places().fold(Vec3::NEG_INFINITY, Vec3::max);
            let min = places().fold(Vec3::INFINITY, Vec3::min);
            assert!(max.x - min.x > to.0 as f32 && max.y - min.y > to.1 as f32);
            assert!(max.z < -0.5, "behind the hero: {max}");
        }
    }
}
