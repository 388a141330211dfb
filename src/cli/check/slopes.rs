//! The part of the check that looks at how steep ground is: what is a hair from the limit was hardly meant so.

use super::{Case, Report, name_of};
use crate::geom::drawn::{Drawn, length};
use crate::geom::polygon::area2;
use crate::level::{Feature, Kind};

/// The tangent of a tenth of a degree: so near to the limit a slope looks like it.
const NEAR: f64 = 0.001_745_33;

/// Shorter edges are pieces of curves, which may pass the limit, m.
const SHORT: f64 = 0.05;

/// Every edge of ground that is nearly as steep as can be stood on, and not exactly so.
pub(super) fn check(case: &Case, report: &mut Report) {
    let limit = case.tuning.motion.max_slope;
    for (_, feature) in case.stage.features() {
        if !feature.kind.is_terrain() {
            continue;
        }
        let corners = feature.outline.len();
        for (i, slope) in slopes(feature).filter_map(|(i, slope)| Some((i, slope?))) {
            let excess = slope - limit;
            // tan(a - b) of two angles by their tangents.
            let off = excess.abs() / (1.0 + slope * limit);
            if excess == 0.0 || off >= NEAR {
                continue;
            }
            let side = if excess > 0.0 { "over" } else { "under" };
            report.wrong(format!(
                "{}, outline[{i}] to outline[{}]: rises {slope:.6} on 1, just {side} the limit of {limit}",
                name_of(feature),
                (i + 1) % corners
            ));
        }
    }
}

/// Of each edge of a feature its rise on a run of 1, if it is ground and not short.
fn slopes(feature: &Feature) -> impl Iterator<Item = (usize, Option<f64>)> {
    let corners = feature.drawn();
    let is_line = feature.kind == Kind::OneWay;
    // The free side of an edge is above it where it runs to the left round a solid, and to the right as a line.
    let to_the_right = is_line || area2(&feature.snapped()) < 0;
    let edges = corners.len() - usize::from(is_line);
    (0..edges).map(move |i| {
        let (from, to): (Drawn, Drawn) = (corners[i], corners[(i + 1) % corners.len()]);
        let (dx, dy) = to.vector_from(from);
        let is_ground = dx != 0 && (dx > 0) == to_the_right;
        let long = dx.abs().max(dy.abs()) >= length(SHORT);
        let slope = dy.abs() as f64 / dx.abs() as f64;
        (i, (is_ground && long).then_some(slope))
    })
}
