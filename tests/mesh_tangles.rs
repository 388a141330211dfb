//! Worlds with many crossings for their size: their meshes are right, come out the same however they are made, and cost what is
//! in them.

mod common;
#[path = "common/tangles.rs"]
mod tangles;

use common::{checker, worlds};
use edgewalker::geom::{Collider, ExpandedEdge};
use edgewalker::mesh::Mesh;
use std::time::{Duration, Instant};
use tangles::{TANGLES, Tangle};

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

/// The least time of three builds.
fn time((name, world): Tangle, n: usize) -> Duration {
    let features = features(world, n);
    let build = |_| {
        let start = Instant::now();
        let mesh = Mesh::build(&features).unwrap();
        let took = start.elapsed();
        assert!(mesh.vertices().count() > 4, "{name}");
        took
    };
    (0..3).map(build).min().unwrap()
}

/// Sixteen times the crossings would take 256 times as long if every one looked at all others. The bound leaves room for a machine
/// that does something else meanwhile, and for caches.
#[test]
fn time_grows_with_the_crossings_and_not_with_their_square() {
    for tangle in TANGLES {
        let (few, many) = (time(tangle, 40), time(tangle, 160));
        let bound = 64 * few + Duration::from_millis(60);
        println!("{}: {few:?}, of 16 times the crossings {many:?}", tangle.0);
        assert!(
            cfg!(debug_assertions) || many < bound,
            "{}: {few:?}, {many:?}",
            tangle.0
        );
    }
}
