//! Whole worlds: the regression vectors that broke other libraries, the families of worlds at offsets and rotations,
//! and the levels that ship.

use crate::common::slow::{self, Spot, spot};
use crate::common::soups::sound;
use crate::common::worlds::{self, Dice, wire};
use edgewalker::geom::{BOUND, Collider, ExpandedEdge, Point, Source, expand};
use edgewalker::level::Kind;
use edgewalker::mesh::{Mesh, MeshError};
use glam::DVec2;
use std::path::Path;

/// Segments by their coordinates, in metres.
type Vectors = &'static [[f64; 4]];

/// Sets of segments on which public libraries displaced crossings, panicked or hung.
const REGRESSIONS: [(&str, Vectors); 4] = [
    (
        "crossing displaced by 0.33",
        &[
            [
                12.204078684688866,
                -0.24589318396995186,
                8.881607835435757,
                -2.4732655048591474,
            ],
            [
                11.09968634028461,
                -2.1901970567278264,
                7.767921674991158,
                -0.8120300802325926,
            ],
            [
                9.712225547749036,
                -1.9164224246368482,
                11.38275478841593,
                -4.40827556157668,
            ],
        ],
    ),
    (
        "crossing displaced by 1.0",
        &[
            [
                11.921010236557546,
                1.9721853208789026,
                14.148382557446741,
                -1.3502855283742061,
            ],
            [
                13.034696397002143,
                0.3109498962523478,
                12.204078684688866,
                -0.24589318396995186,
            ],
            [
                13.308471029093122,
                1.6984106887879244,
                10.816617892153289,
                0.02788144812102722,
            ],
        ],
    ),
    (
        "panic",
        &[
            [
                -1.989695592118069,
                9.800056706504607,
                -1.3250727911248847,
                10.547235756264328,
            ],
            [
                -2.8194308906442282,
                11.8764813582509,
                -1.989695592118069,
                9.800056706504607,
            ],
            [
                -1.9855227812562841,
                21.84165056228838,
                -1.6552977861905358,
                16.194443159276354,
            ],
            [
                -2.654318393111353,
                9.052877656744885,
                -0.6604499901315002,
                11.29441480602405,
            ],
        ],
    ),
    (
        "hang",
        &[
            [
                -4.322517204881381,
                -3.2118289203356483,
                -5.289284234711664,
                -3.4674878924706647,
            ],
            [
                -5.033625262576647,
                -4.434254922300948,
                -4.066858232746364,
                -4.178595950165931,
            ],
            [
                -6.200182405832162,
                -7.84587395606183,
                -4.322517204881381,
                -3.2118289203356483,
            ],
            [
                -5.800602178981697,
                -1.5339538328100994,
                -4.77796629044163,
                -5.401021952131231,
            ],
            [
                -5.033625262576647,
                -4.434254922300948,
                -5.54494320684668,
                -2.500720862640382,
            ],
        ],
    ),
];

#[test]
fn regression_vectors_are_snapped_like_the_slow_twin_at_all_scales() {
    for (name, vectors) in REGRESSIONS {
        // From one where all of it is a few steps wide to one that nearly fills the world.
        for scale in [
            2f64.powi(-15),
            2f64.powi(-12),
            0.001,
            0.1,
            1.0,
            std::f64::consts::PI,
            100.0,
        ] {
            let point = |x: f64, y: f64| Point::snap(DVec2::new(x, y) * scale).unwrap();
            let all: Vec<(Point, Point)> = vectors
                .iter()
                .map(|&[a, b, c, d]| (point(a, b), point(c, d)))
                .collect();
            let segments: Vec<_> = all.into_iter().filter(|(a, b)| a != b).collect();
            let features: Vec<_> = segments.iter().map(|&s| wire(&[s])).collect();
            let mesh = Mesh::build(&features).unwrap();
            sound(&mesh, &(name, scale));
            let spots: Vec<(Spot, Spot)> =
                segments.iter().map(|&(a, b)| (spot(a), spot(b))).collect();
            let (_, chains) = slow::snap(&spots);
            for (feature, expected) in (0..).zip(chains) {
                let chain: Vec<Spot> = mesh
                    .chain(mesh.segments_of(feature)[0])
                    .iter()
                    .map(|&v| spot(mesh.point(v)))
                    .collect();
                assert_eq!(chain, expected, "{name} at {scale}");
            }
            let mut backwards = Mesh::build(&[]).unwrap();
            for (id, feature) in features.iter().enumerate().rev() {
                backwards.insert(id as u32, feature).unwrap();
            }
            assert_eq!(mesh.hash(), backwards.hash(), "{name} at {scale}");
        }
    }
}

/// A family of worlds by name, with the size and collider that it is run with.
type Family = (
    &'static str,
    fn(&mut Dice, usize) -> Vec<worlds::Outline>,
    usize,
    Collider,
);

fn families() -> [Family; 4] {
    let octagon = [
        (-0.2, 0.0),
        (0.2, 0.0),
        (0.45, 0.25),
        (0.45, 0.95),
        (0.2, 1.2),
        (-0.2, 1.2),
        (-0.45, 0.95),
        (-0.45, 0.25),
    ];
    let octagon = octagon.map(|(x, y)| Point::snap(DVec2::new(x, y)).unwrap());
    [
        ("sparse", worlds::sparse, 20, Collider::hero()),
        (
            "random",
            worlds::random,
            40,
            Collider::new(octagon.to_vec()).unwrap(),
        ),
        ("slopes", worlds::slopes, 40, worlds::centred_box(0.4, 0.8)),
        ("grid", worlds::grid, 40, Collider::hero_crouched()),
    ]
}

/// Builds a world, checks it, and checks that taking a feature out and putting it back changes nothing.
fn try_world(outlines: &[Vec<Point>], collider: &Collider, story: &dyn std::fmt::Debug) {
    let features = worlds::expanded(outlines, collider);
    let mut mesh = Mesh::build(&features).unwrap();
    sound(&mesh, story);
    let hash = mesh.hash();
    let middle = features.len() / 2;
    mesh.remove(middle as u32).unwrap();
    mesh.insert(middle as u32, &features[middle]).unwrap();
    assert_eq!(mesh.hash(), hash, "{story:?}");
}

#[test]
fn families_are_sound_at_offsets_up_to_1000() {
    for (name, family, n, collider) in families() {
        for seed in 0..100 {
            let world = family(&mut Dice::new(seed), n);
            for x in [0.0, 1.0 / 3.0, 300.0, 1000.0] {
                let moved = worlds::placed(&world, DVec2::new(x, x / 2.0), 0.0);
                try_world(&worlds::snapped(&moved), &collider, &(name, seed, x));
            }
        }
    }
}

#[test]
fn families_are_sound_at_50_rotations() {
    for (name, family, n, collider) in families() {
        let world = family(&mut Dice::new(99), n);
        for i in 0..50 {
            let angle = f64::from(i) * 0.1257;
            let turned = worlds::placed(&world, DVec2::new(50.0, 25.0), angle);
            try_world(&worlds::snapped(&turned), &collider, &(name, i));
        }
    }
}

#[test]
fn ten_thousand_polygons_are_sound() {
    let world = worlds::random(&mut Dice::new(4), 10_000);
    let features = worlds::expanded(&worlds::snapped(&world), &Collider::point());
    let mesh = Mesh::build(&features).unwrap();
    sound(&mesh, &"1e4 polygons");
    assert!(
        mesh.vertices().count() > 45_000,
        "{} vertices",
        mesh.vertices().count()
    );
    assert!(mesh.faces().any(|f| mesh.cover(f).len() > 2));
}

#[test]
fn a_long_line_through_all_scales_is_one_feature() {
    // A floor right across the world with a thousand small boxes on it, and one step from a second floor.
    let end = BOUND - 2;
    let floor = [
        Point::new(-end, 0),
        Point::new(end, 1),
        Point::new(end, 2),
        Point::new(-end, 3),
    ];
    let mut features = vec![
        expand(&floor, &Collider::point()),
        wire(&[(Point::new(-end, -1), Point::new(end, 2))]),
    ];
    for i in -500..500 {
        let x = i * 500_000;
        features.push(wire(&[
            (Point::new(x, 0), Point::new(x + 7, 2)),
            (Point::new(x + 7, -9), Point::new(x + 2, 9)),
        ]));
    }
    let mut mesh = Mesh::build(&features).unwrap();
    sound(&mesh, &"long line");
    let hash = mesh.hash();
    for id in [1, 0, 500] {
        mesh.remove(id).unwrap();
        sound(&mesh, &id);
        mesh.insert(id, &features[id as usize]).unwrap();
    }
    assert_eq!(mesh.hash(), hash);
}

#[test]
fn what_cannot_go_in_is_named_and_changes_nothing() {
    let edge = |a: Point, b: Point| ExpandedEdge::new(a, b, Source::Edge { edge: 0 });
    let (o, p) = (Point::new(0, 0), Point::new(9, 9));
    let far = Point::new(0, BOUND - 1);
    assert_eq!(
        Mesh::build(&[vec![], vec![edge(o, p), edge(p, far)]]).unwrap_err(),
        MeshError::OutOfBounds {
            feature: 1,
            edge: 1
        }
    );
    let mut mesh = Mesh::build(&[vec![edge(o, p)]]).unwrap();
    let hash = mesh.hash();
    assert_eq!(
        mesh.insert(5, &[edge(o, o)]),
        Err(MeshError::ZeroLength {
            feature: 5,
            edge: 0
        })
    );
    assert_eq!(
        mesh.insert(0, &[edge(o, p)]),
        Err(MeshError::Occupied { feature: 0 })
    );
    assert_eq!(mesh.remove(5), Err(MeshError::Unknown { feature: 5 }));
    assert_eq!(mesh.hash(), hash);
    let text = MeshError::OutOfBounds {
        feature: 1,
        edge: 1,
    }
    .to_string();
    assert!(
        text.contains("feature 1") && text.contains("edge 1"),
        "{text}"
    );
}

/// The closed outlines of a shipped level, in metres.
fn level_outlines(file: &Path) -> Vec<worlds::Outline> {
    let level = edgewalker::level::load(file).unwrap_or_else(|e| panic!("{e}"));
    let closed = level
        .features
        .into_iter()
        .filter(|f| f.kind != Kind::OneWay);
    closed.map(|f| f.outline).collect()
}

#[test]
fn shipped_levels_are_sound_for_all_colliders() {
    let folders =
        ["levels", "levels/dev"].map(|folder| Path::new(env!("CARGO_MANIFEST_DIR")).join(folder));
    let entries = folders
        .iter()
        .flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let files = entries.map(|entry| entry.unwrap().path());
    let mut seen = 0;
    let is_level = |file: &Path| {
        let name = file.file_name().unwrap().to_string_lossy();
        name.ends_with(".ron") && !name.ends_with(".tuning.ron")
    };
    for file in files.filter(|file| is_level(file)) {
        let outlines = level_outlines(&file);
        let on_grid = worlds::snapped(&outlines);
        assert_eq!(
            on_grid.len(),
            outlines.len(),
            "{file:?}: all outlines are simple"
        );
        for collider in [
            Collider::hero(),
            Collider::hero_crouched(),
            Collider::point(),
        ] {
            try_world(&on_grid, &collider, &file);
        }
        seen += 1;
    }
    assert!(seen > 1, "{seen} levels");
}

/// A real map, expanded and turned: the family on which every library with rounded coordinates fails.
#[test]
fn the_quarry_is_sound_at_50_rotations() {
    let quarry = level_outlines(&Path::new(env!("CARGO_MANIFEST_DIR")).join("levels/quarry.ron"));
    for i in 0..50 {
        let turned = worlds::snapped(&worlds::placed(&quarry, DVec2::ZERO, f64::from(i) * 0.1257));
        assert_eq!(turned.len(), quarry.len(), "turned outlines stay simple");
        try_world(&turned, &Collider::hero(), &i);
    }
}
