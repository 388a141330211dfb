//! The beginning and the end of the report: what was measured on what, what was aimed at, where we lose, every setting.

use crate::cases::Held;
use crate::machine;
use crate::movers;
use crate::page::{Page, metres, time};
use crate::precision::Precision;
use crate::recorded::Recorded;
use crate::scaling::Scaling;

/// Where the summary goes, once everything is measured.
const MARK: &str = "(summary)\n";

pub fn begin(page: &mut Page) {
    page.heading(1, "Speed against error");
    page.say(
        "Edgewalker moves a body through 2D level geometry by exact decisions on a constrained Delaunay mesh, event by event, in closed \
         form. This page measures it side by side with others, in the same scenes and in the same run: the character mover of \
         Box2D v3, the kinematic character controller of Rapier, a move-and-slide by the shape casts of Parry, and the usual \
         hand-made `move, then push out`; its mesh side by side with spade and delaunator. `scripts/report` makes all of it anew.",
    );
    page.say(&format!(
        "Measured on: {}. Crates: boxdd-sys {} (Box2D v3.2), rapier2d {}, parry2d {}, spade {}, delaunator {}, all built \
         with `opt-level = 3`. What is compared is timed in turn, over and over, and the median is given; other programs may have \
         run beside it, so that ratios within a table mean more than its nanoseconds. In ours, *e* is events and *f* is faces crossed per tick.",
        machine::name(),
        machine::version("boxdd-sys"),
        machine::version("rapier2d"),
        machine::version("parry2d"),
        machine::version("spade"),
        machine::version("delaunator"),
    ));
    page.say(MARK);
}

/// Every setting of every mover.
pub fn settings(page: &mut Page) {
    page.heading(2, "7. Settings");
    let makers = movers::all();
    let all = makers
        .iter()
        .map(|maker| format!("**{}**: {}.", maker.name, maker.settings));
    page.list(&all.collect::<Vec<_>>());
    page.say(
        "The convex shapes of Rapier and Parry have kept all of their corners: that is asserted. All peers are driven alike: a tick takes gravity into the velocity, moves the body by it, and takes what contacts leave of \
         it; who walks has his speed along x set at every tick, and no gravity while he stands. A lift moves before the body \
         does, for Rapier after it. Rapier, Parry and push out start as far above ground as they like to be. Box2D takes a capsule \
         as wide and as high as the boxes of the others; each scene's exact trajectory is that of the shape.",
    );
}

pub fn fill(
    page: &mut Page,
    precision: &Precision,
    recorded: &Recorded,
    held: &Held,
    scaling: &Scaling,
) {
    let targets = targets(precision, recorded, scaling);
    let met = targets.iter().filter(|target| target.met).count();
    let mut text = String::from("## Summary\n\n| aim | measured | |\n|---|---:|---:|\n");
    for target in &targets {
        let verdict = if target.met { "met" } else { "**missed**" };
        text += &format!("| {} | {} | {verdict} |\n", target.aim, target.measured);
    }
    text += &format!("\n{met} of {} aims are met. ", targets.len());
    text += &format!(
        "Of {} hard cases, exact: {}; within 1 cm: {}.\n\n",
        held.cases,
        counts(held, &held.exact),
        counts(held, &held.centimetre),
    );
    text +=
        "Instructions (callgrind, `scripts/counts`; they do not depend on the machine's load):\n\n";
    for line in include_str!("../../benches/counts.txt").lines() {
        let (name, count) = line.rsplit_once(' ').unwrap_or((line, ""));
        text += &format!("- {name}: {count}\n");
    }
    text += "\n";
    text += &losses(precision, scaling);
    page.fill(MARK.trim_end(), text.trim_end());
}

struct Target {
    aim: &'static str,
    measured: String,
    met: bool,
}

fn targets(precision: &Precision, recorded: &Recorded, scaling: &Scaling) -> Vec<Target> {
    let target = |aim, measured, met| Target { aim, measured, met };
    let [rapier, box2d] = [recorded.rapier, recorded.box2d].map(|ns| ns / recorded.ours);
    let growth = scaling.steps[1] / scaling.steps[0];
    let build = scaling.build[0] / scaling.build[1];
    let [air, ground] = recorded.steps;
    let ours = precision.ours.max(recorded.errors[1]);
    vec![
        target(
            "a step in the recorded run at least 20 times faster than Rapier's",
            format!("{rapier:.1} times"),
            rapier >= 20.0,
        ),
        target(
            "and 5 times faster than Box2D's",
            format!("{box2d:.1} times"),
            box2d >= 5.0,
        ),
        target(
            "at most 150 ns, in the air or on the ground, in the median",
            format!("{air:.0} ns, {ground:.0} ns"),
            air <= 150.0 && ground <= 150.0,
        ),
        target(
            "1e6 constrained edges cost a step at most 1.5 times what 1e2 do",
            format!(
                "{growth:.2} times ({} and {} edges)",
                scaling.edges[1], scaling.edges[0]
            ),
            growth <= 1.5,
        ),
        target(
            "error at most 1e-9 m at every tick rate",
            format!("{} m", metres(ours)),
            ours <= 1e-9 && recorded.errors[0] <= 1e-9,
        ),
        target(
            "building 1e4 overlapping octagons in at most 0.8 of spade's time",
            format!(
                "{build:.2}: {}, {}",
                time(scaling.build[0]),
                time(scaling.build[1])
            ),
            build <= 0.8,
        ),
        target(
            "moving one octagon among 1000 below 40 µs, no vertex left behind",
            format!(
                "{}; {} vertices before, {} after",
                time(scaling.moving),
                scaling.vertices[0],
                scaling.vertices[1]
            ),
            scaling.moving < 40e3 && scaling.vertices[0] == scaling.vertices[1],
        ),
        target(
            "a straight sweep at most 30 ns per edge crossed",
            format!("{:.1} ns", scaling.sweep),
            scaling.sweep <= 30.0,
        ),
    ]
}

fn counts(held: &Held, counts: &[usize]) -> String {
    let all = held
        .names
        .iter()
        .zip(counts)
        .map(|(name, count)| format!("{name} {count}"));
    all.collect::<Vec<_>>().join(", ")
}

/// Where others are better.
fn losses(precision: &Precision, scaling: &Scaling) -> String {
    let mut close: Vec<&(f64, String)> = precision
        .best_peers
        .iter()
        .filter(|best| best.0 < 1e-3)
        .collect();
    close.sort_by(|a, b| a.0.total_cmp(&b.0));
    let close = close
        .iter()
        .map(|(error, what)| format!("{what} ({} m)", metres(*error)));
    let close = close.collect::<Vec<_>>().join(", ");
    let mut text = String::from("**Where Edgewalker loses, or is not better:**\n\n");
    text += &format!(
        "- Not every peer is off by 1e-3 m everywhere. Better than that at their best rate: {close}.\n"
    );
    let [crossing, apart] = scaling.slowest;
    text += &format!(
        "- Building its mesh takes up to {crossing:.2} times as long as building spade's where outlines cross, the most in small \
         meshes, and up to {apart:.2} times where they do not (section 4).\n"
    );
    text += "- Its mesh takes about twice spade's memory per vertex, and plain points are much faster with delaunator (section 4).\n";
    text += "- Its world ends 4096 m from the origin, on a grid of 15 micrometres; the others go on, less exactly (section 5).\n";
    text += "- Bodies are convex polygons that do not turn, and do not push one another; solids move but do not rotate. Box2D and Rapier do all \
        of that.\n";
    text += "- A body that meets something new at every tick pays for an event at every tick: compare the ticks at 15 Hz with those at 960 Hz in section 1.\n";
    text
}
