//! The scenery of a level: set pieces, put where the level wants them.

use super::frame::PointLight;
use super::kit::Kit;
use super::model::{Model, hash};
use super::terrain;
use crate::level::{Level, Scenery, SceneryKind};
use glam::{Mat4, vec3};
use std::f32::consts::TAU;

/// How far in front of the plane of play scenery may stand: what is further in front would hang before the terrain.
const FOREMOST: f32 = terrain::EDGE - 0.12;
/// Least scale at which the reach of a lamp shrinks with it.
const SMALLEST_LAMP: f32 = 0.2;

/// Builds all scenery of a level, with its lamps.
pub fn build(kit: &Kit, level: &Level) -> (Model, Vec<PointLight>) {
    let (mut all, mut lamps) = (Model::default(), Vec::new());
    for thing in &level.scenery {
        let (place, scale) = place(thing);
        all.add(kit.scenery(thing.kind), place);
        lamps.extend(kit.scenery_lights(thing.kind, place, scale.max(SMALLEST_LAMP)));
    }
    (all, lamps)
}

/// Where a thing stands, and its scale.
fn place(thing: &Scenery) -> (Mat4, f32) {
    let foot = thing
        .at
        .as_vec2()
        .extend((thing.depth as f32).min(FOREMOST));
    let scale = thing.scale as f32;
    let mirror = vec3(if thing.flip { -1.0 } else { 1.0 }, 1.0, 1.0);
    let turn = match thing.turn {
        Some(degrees) => (degrees as f32).to_radians(),
        None => own_turn(thing.kind) * (hash(foot, 20) - 0.5),
    };
    let place = Mat4::from_translation(foot)
        * Mat4::from_rotation_y(turn)
        * Mat4::from_scale(mirror * scale);
    (place, scale)
}

/// Over which angle a kind may be turned by its place, so that no two look alike and nothing flat is seen edge-on.
fn own_turn(kind: SceneryKind) -> f32 {
    use SceneryKind::*;
    match kind {
        // What is round, or has no front.
        Pillar | PillarFluted | PillarBroken | Barrel | Grass | Fern | Bush | Reed | DeadTree
        | Mushrooms | Rubble | RubbleSmall | Stalactite | CliffStack => TAU,
        // What hangs at a wall, or is to be looked at from the front.
        LanternWall | LanternWallDead | Ivy | Ladder | Scaffold | Gear | Arch | ArchBroken => 0.0,
        Tower | TowerRuin | Windmill | Crane | Aqueduct => 1.0,
        Crate | Crates | Cart | Tomb | StatueHead | RubbleBlocks | Boiler | Tree => 0.7,
        Lantern | LanternDead | LanternHanging | LanternHangingDead | PillarSquare
        | PillarFallen | Banner | BannerTorn | BannerLong | GearSmall | Press | Winch | Pipe
        | Treadwheel | Pulley | Vine | Chain | Rope | StatueKneeling | Bird => 0.4,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec2, Vec3};

    fn thing(turn: Option<f64>, flip: bool) -> Scenery {
        Scenery {
            kind: SceneryKind::Lantern,
            at: DVec2::new(3.0, 2.0),
            depth: -1.0,
            scale: 2.0,
            turn,
            flip,
        }
    }

    #[test]
    fn scenery_stands_where_it_is_put_turned_and_flipped() {
        let right = Vec3::X;
        let shown = |turn, flip| place(&thing(turn, flip)).0.transform_point3(right);
        let near = |a: Vec3, b: Vec3| assert!(a.distance(b) < 1e-5, "{a} {b}");
        near(shown(Some(0.0), false), vec3(5.0, 2.0, -1.0));
        near(shown(Some(0.0), true), vec3(1.0, 2.0, -1.0));
        // Counter-clockwise seen from above: right becomes away from the viewer.
        near(shown(Some(90.0), false), vec3(3.0, 2.0, -3.0));
        let free = shown(None, false);
        assert!(free.distance(vec3(5.0, 2.0, -1.0)) < 0.5 && free != shown(Some(0.0), false));
    }

    #[test]
    fn nothing_stands_before_the_terrain() {
        let close = Scenery {
            depth: 5.0,
            ..thing(None, false)
        };
        assert_eq!(place(&close).0.transform_point3(Vec3::ZERO).z, FOREMOST);
    }
}
