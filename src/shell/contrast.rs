//! High contrast: the hero and everything deadly in bright outlines over the scene, for those to whom shades say too little.

use super::render::Line;
use crate::game::{Shape, View};
use crate::geom::Collider;
use crate::level::{Feature, Kind, Level};
use glam::{DVec2, Vec3};

/// Colours of the hero and of what kills.
const HERO: [f32; 4] = [0.45, 1.0, 1.0, 1.0];
const DANGER: [f32; 4] = [1.0, 0.16, 0.12, 1.0];
/// Under them, so that they are seen on a bright sky and pale stone as well as in the dark.
const UNDER: [f32; 4] = [0.02, 0.02, 0.04, 1.0];
/// Width of the outlines, and of what is under them, as shares of the picture's height.
const WIDTH: f32 = 0.006;
const UNDER_WIDTH: f32 = 0.011;
/// Before the plane of play, so that no front covers them, in metres.
const BEFORE: f32 = 0.2;

/// Adds the outlines of a moment to the lines of a picture of this height in pixels; `offsets` is how far each mover is
/// from where it was drawn, `hero` the hero's shape.
pub fn outline(
    level: &Level,
    (view, hero): (&View, &Shape),
    offsets: &[DVec2],
    height: u32,
    lines: &mut Vec<Line>,
) {
    let height = height as f32;
    for feature in hazards(&level.features) {
        ring(
            feature.outline.iter().copied(),
            DVec2::ZERO,
            DANGER,
            height,
            lines,
        );
    }
    for (mover, &offset) in level.movers.iter().zip(offsets) {
        for feature in hazards(&mover.features).chain(mover.crushers()) {
            ring(
                feature.outline.iter().copied(),
                offset,
                DANGER,
                height,
                lines,
            );
        }
    }
    let Shape { stand, crouch } = hero;
    let body = if view.crouched { crouch } else { stand };
    ring(corners(body), view.position, HERO, height, lines);
}

/// What kills whoever comes into it.
fn hazards(features: &[Feature]) -> impl Iterator<Item = &Feature> {
    features.iter().filter(|f| f.kind == Kind::Hazard)
}

/// The corners of a body, in metres from its foot.
fn corners(body: &Collider) -> impl ExactSizeIterator<Item = DVec2> + Clone + '_ {
    body.corners().iter().map(|corner| corner.metres())
}

/// A closed line through some corners, with a dark edge, in a picture of that height.
fn ring(
    corners: impl ExactSizeIterator<Item = DVec2> + Clone,
    offset: DVec2,
    colour: [f32; 4],
    height: f32,
    lines: &mut Vec<Line>,
) {
    let at = |corner: DVec2| -> Vec3 { (corner + offset).as_vec2().extend(BEFORE) };
    for (colour, width) in [(UNDER, UNDER_WIDTH), (colour, WIDTH)] {
        let next = corners.clone().cycle().skip(1);
        lines.extend(corners.clone().zip(next).map(|(a, b)| Line {
            a: at(a),
            b: at(b),
            colour,
            width: width * height,
        }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::level;
    use std::path::Path;

    #[test]
    fn the_hero_and_what_kills_are_outlined_where_they_are() {
        let text =
            "(version: 1, name: \"n\", start: (0, 0), goal: (min: (8, 0), max: (9, 3)), bottom: -9,
            features: [
                (id: \"floor\", outline: [(-9, -3), (9, -3), (9, 0), (-9, 0)]),
                (id: \"spikes\", kind: Hazard, outline: [(3, 0), (4, 0), (3.5, 1)]),
            ],
            movers: [
                (id: \"press\", features: [(id: \"block\", material: Iron, outline: [(5, 3), (6, 3), (6, 4), (5, 4)])],
                    path: [(at: (0, 0), seconds: 1), (at: (0, -2), seconds: 1)], repeat: Loop),
                (id: \"lift\", features: [(id: \"deck\", material: Timber, outline: [(7, 0), (8, 0), (8, 0.2)])],
                    path: [(at: (0, 0), seconds: 1), (at: (0, 2), seconds: 1)], repeat: Loop),
            ])";
        let level = level::parse(text, Path::new("test")).unwrap();
        let view = View::at(DVec2::new(-5.0, 0.0));
        let mut lines = Vec::new();
        let offsets = [DVec2::NEG_Y, DVec2::Y];
        let shape = Shape::hero();
        outline(&level, (&view, &shape), &offsets, 720, &mut lines);
        let hero = shape.stand.corners().len();
        assert_eq!(lines.len(), 2 * (3 + 4 + hero), "each with a dark edge");
        assert!(lines[0].colour == UNDER && lines[0].width > lines[3].width);
        lines.retain(|line| line.colour != UNDER);
        assert_eq!(lines.len(), 3 + 4 + hero);
        assert_eq!(lines[0].a, Vec3::new(3.0, 0.0, BEFORE));
        assert_eq!(
            lines[3].a,
            Vec3::new(5.0, 2.0, BEFORE),
            "the press a metre below its place"
        );
        assert!(
            lines[7..]
                .iter()
                .all(|line| line.colour == HERO && line.a.x < -4.0)
        );
    }
}
