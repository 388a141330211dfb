//! Worlds with many crossings for their size: their meshes are right, come out the same however they are made, and cost what is
//! in them.

use crate::common::tangles::{self, TANGLES, Tangle};
use crate::common::{checker, worlds};
use edgewalker::geom::{Collider, ExpandedEdge, Point};
use edgewalker::mesh::{Kind, Mesh, MeshError, Part, Phase, Progress};
use std::time::{Duration, Instant};

fn features(world: fn(usize) -> Vec<worlds::Outline>, n: usize) -> Vec<Vec<ExpandedEdge>> {
    worlds::expanded(&worlds::snapped(&world(n)), &Collider::point())
}

/// Hashes of all families with 25 things, as they have always been.
const HASHES: [(&str, u64); 14] = [
    ("beams", 0x8512_81da_703f_7530),
    ("tilted beams", 0xe09f_703c_c3ed_f627),
    ("slivers", 0x6aaf_ddd0_d982_d913),
    ("fine slivers", 0xbeda_81af_2688_08ed),
    ("combs", 0x5710_bb25_74b0_a722),
    ("tilted combs", 0x90a0_3098_5c53_e74a),
    ("sticks", 0xc4a3_efa9_bfb2_6ae0),
    ("needles", 0xa26a_0669_bfb3_dbfd),
    ("pencils", 0x4e5a_b429_ca0f_d2ba),
    ("stars", 0x7081_5c9d_1f7d_e3fb),
    ("stack", 0x1a02_b034_d873_8dd2),
    ("stairs", 0xb3cd_47ee_233e_13d2),
    ("parallels", 0x2f67_af6a_b46c_0bed),
    ("corner", 0x463d_e11f_175c_317f),
];

#[test]
fn every_tangle_is_the_mesh_that_it_was() {
    for ((name, world), (same, hash)) in TANGLES.into_iter().zip(HASHES) {
        assert_eq!(name, same);
        let mesh = Mesh::build(&features(world, 25)).unwrap();
        assert_eq!(mesh.check(), Ok(()), "{name}");
        assert_eq!(mesh.hash(), hash, "{name}");
    }
}

#[test]
fn every_tangle_is_right_by_the_checker_that_shares_no_code() {
    for (name, world) in TANGLES {
        let mesh = Mesh::build(&features(world, 8)).unwrap();
        if let Err(wrong) = checker::check(&mesh) {
            panic!("{name}: {wrong}");
        }
    }
}

#[test]
fn tangles_come_and_go_feature_by_feature() {
    for (name, world) in TANGLES.into_iter().filter(|t| t.0 != "corner") {
        let features = features(world, 20);
        let whole = Mesh::build(&features).unwrap().hash();
        let mut mesh = Mesh::build(&[]).unwrap();
        let empty = mesh.hash();
        // From the outside to the middle, and away the other way around.
        let count = features.len();
        let order: Vec<usize> = (0..count)
            .map(|i| if i % 2 == 0 { i / 2 } else { count - 1 - i / 2 })
            .collect();
        for &i in &order {
            mesh.insert(i as u32, &features[i]).unwrap();
        }
        assert_eq!((mesh.check(), mesh.hash()), (Ok(()), whole), "{name}");
        for (gone, &i) in order.iter().enumerate() {
            mesh.remove(i as u32).unwrap();
            // What came before and goes has left its numbers to others.
            mesh.insert(i as u32, &features[i]).unwrap();
            mesh.remove(i as u32).unwrap();
            if gone == count / 2 {
                assert_eq!(mesh.check(), Ok(()), "{name}");
            }
        }
        assert_eq!((mesh.check(), mesh.hash()), (Ok(()), empty), "{name}");
    }
}

/// How long the processor has worked for this thread; the clock's time where the system does not tell.
fn worked(since: Instant) -> Duration {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split(' ').next()?.parse().ok());
    nanoseconds.map_or_else(|| since.elapsed(), Duration::from_nanos)
}

/// How long the processor works for a build: many, so that what else it does counts for little.
fn time((name, world): Tangle, n: usize) -> Duration {
    let features = features(world, n);
    let (clock, mut builds) = (Instant::now(), 0);
    let start = worked(clock);
    loop {
        let mesh = Mesh::build(&features).unwrap();
        assert!(mesh.vertices().count() > 4, "{name}");
        builds += 1;
        let all = worked(clock) - start;
        if all > Duration::from_millis(150) {
            return all / builds;
        }
    }
}

/// Sixteen times the crossings would take 256 times as long if every one looked at all others. The bound leaves room for a machine
/// that does something else meanwhile, and for caches.
#[test]
fn time_grows_with_the_crossings_and_not_with_their_square() {
    for tangle in TANGLES {
        let (few, many) = (time(tangle, 40), time(tangle, 160));
        let bound = 64 * few;
        println!("{}: {few:?}, of 16 times the crossings {many:?}", tangle.0);
        assert!(
            cfg!(debug_assertions) || many < bound,
            "{}: {few:?}, {many:?}",
            tangle.0
        );
    }
}

/// A family as solids with ids.
fn numbered(
    world: fn(usize) -> Vec<worlds::Outline>,
    n: usize,
) -> Vec<(u32, Kind, Vec<ExpandedEdge>)> {
    let numbered = (0..).zip(features(world, n));
    numbered
        .map(|(id, edges)| (id, Kind::Solid, edges))
        .collect()
}

#[test]
fn a_build_can_be_left_in_every_phase_and_says_how_far_it_is() {
    let features = numbered(tangles::beams, 40);
    let progress = Progress::default();
    let mesh = Mesh::watched(&features, Part::whole(&progress)).unwrap();
    let whole = mesh.hash();
    assert!(progress.share() > 0.99 - 0.04, "{}", progress.share());
    assert_eq!(
        whole,
        Mesh::of(&features).unwrap().hash(),
        "whoever watches"
    );
    let mut seen = Vec::new();
    for percent in 0..90 {
        let progress = Progress::default();
        let share = percent as f32 / 100.0;
        progress.leave_at(share);
        let left = Mesh::watched(&features, Part::whole(&progress));
        assert_eq!(left.err(), Some(MeshError::Left), "at {percent} %");
        assert!(progress.share() >= share - 1e-5 && progress.share() < share + 0.5);
        seen.push(progress.phase());
    }
    assert!(seen.is_sorted());
    seen.dedup();
    use Phase::{Covering, Crossing, Snapping, Triangulating};
    assert_eq!(seen, [Crossing, Snapping, Triangulating, Covering]);
}

#[test]
fn what_is_too_much_is_refused_soon_and_names_who_crosses_most() {
    // 1100 lines across 1100 lines, some twice as dense, among many that cross nothing.
    let line = |i: i32, lies: bool| {
        let (a, b) = (Point::new(-50, 100 * i), Point::new(110_050, 100 * i + 1));
        let turned = |p: Point| Point::new(p.y, p.x);
        if lies { (a, b) } else { (turned(a), turned(b)) }
    };
    let lines = |lies: bool| worlds::wire(&(0..1100).map(|i| line(i, lies)).collect::<Vec<_>>());
    let across: Vec<_> = lines(false);
    let mut all = vec![
        (3, Kind::Solid, lines(true)),
        (9, Kind::Solid, across.clone()),
    ];
    for id in 20..24 {
        // Each crosses what lies in fewer places than the one before.
        let some = across
            .iter()
            .enumerate()
            .filter(|(i, _)| i % (id as usize - 17) != 0);
        let moved = some.map(|(_, e)| ExpandedEdge {
            a: Point::new(e.a.x + id - 15, e.a.y),
            b: Point::new(e.b.x + id - 15, e.b.y),
            ..*e
        });
        all.push((id as u32, Kind::Solid, moved.collect()));
    }
    let begin = Instant::now();
    let error = Mesh::of(&all).unwrap_err();
    let took = begin.elapsed();
    assert_eq!(
        error,
        MeshError::TooMuch {
            first: 3,
            second: 9
        }
    );
    let limit = Duration::from_secs(if cfg!(debug_assertions) { 600 } else { 60 });
    assert!(took < limit, "{took:?}");
    println!("refused after {took:?}: {error}");
}

/// Lines that lie on one another make few vertices, and still are not built for ever.
#[test]
fn what_has_too_many_pieces_is_refused_too() {
    let origin = Point::new(0, 0);
    let line = |i: i32| worlds::wire(&[(origin, Point::new(100 * i, 0))]);
    let lines: Vec<_> = (1..8300)
        .map(|i| (i as u32, Kind::Solid, line(i)))
        .collect();
    let begin = Instant::now();
    let error = Mesh::of(&lines).unwrap_err();
    assert!(matches!(error, MeshError::TooMuch { .. }), "{error}");
    println!("refused after {:?}: {error}", begin.elapsed());
}
