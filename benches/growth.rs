//! How the time to build a mesh grows with its crossings: `cargo bench --no-default-features --bench growth [FAMILY [N ...]]`.
//!
//! A line says how large a world is, how large its mesh, how long it took, and how that compares with the line before. The hash
//! tells whether another build of this program makes the same meshes.

#[path = "../tests/common/tangles.rs"]
mod tangles;
#[path = "../tests/common/worlds.rs"]
mod worlds;

use edgewalker::geom::{Collider, ExpandedEdge};
use edgewalker::mesh::Mesh;
use std::time::Instant;
use tangles::TANGLES;

fn main() {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    arguments.retain(|a| a != "--bench");
    let family = arguments.first().cloned().unwrap_or_default();
    let mut sizes: Vec<usize> = arguments
        .iter()
        .skip(1)
        .filter_map(|a| a.parse().ok())
        .collect();
    if sizes.is_empty() {
        sizes = vec![25, 50, 100, 200];
    }
    let collider = match std::env::var("COLLIDER").as_deref() {
        Ok("hero") => Collider::hero(),
        _ => Collider::point(),
    };
    for (name, world) in TANGLES
        .iter()
        .filter(|(name, _)| family.is_empty() || *name == family)
    {
        let mut before: Option<(usize, f64)> = None;
        for &n in &sizes {
            let features = worlds::expanded(&worlds::snapped(&world(n)), &collider);
            let (mesh, seconds) = timed(&features);
            let vertices = mesh.vertices().count();
            let grown = before.map_or_else(String::new, |(v, s)| {
                format!(
                    ", {:.1} times the vertices in {:.1} times the time",
                    vertices as f64 / v as f64,
                    seconds / s
                )
            });
            println!(
                "{name} {n}: {} features, {} edges, {vertices} vertices, {:.1} ms, hash {:016x}{grown}",
                features.len(),
                features.iter().map(Vec::len).sum::<usize>(),
                seconds * 1e3,
                mesh.hash(),
            );
            before = Some((vertices, seconds));
        }
    }
}

/// How long the processor has worked for this thread, s; the clock's time where the system does not tell.
fn worked(since: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| since.elapsed().as_secs_f64(), |ns| ns * 1e-9)
}

/// The mesh of some features, and how long the processor works for one, s.
fn timed(features: &[Vec<ExpandedEdge>]) -> (Mesh, f64) {
    let (clock, mut builds) = (Instant::now(), 0.0);
    let start = worked(clock);
    loop {
        let mesh = Mesh::build(features).expect("families keep inside the world");
        builds += 1.0;
        let seconds = worked(clock) - start;
        if seconds > 0.2 || std::env::var_os("ONCE").is_some() {
            return (mesh, seconds / builds);
        }
    }
}
