//! The set pieces in the repository: every kind of scenery has its piece, each is light enough, coloured, and stands on its foot.

use edgewalker::level::SceneryKind;
use edgewalker::pieces::{Piece, Pieces};
use glam::Vec3;
use std::fs;
use std::path::{Path, PathBuf};

/// Triangles of a piece.
const FEWEST: usize = 20;
const MOST: usize = 600;
/// How far below its origin a foot may reach where nothing goes down into the ground on purpose, in metres.
const SUNK: f32 = 0.8;

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/models/pieces.glb")
}

fn pieces() -> Pieces {
    Pieces::read(&fs::read(file()).unwrap(), &file()).unwrap()
}

#[test]
fn every_kind_of_scenery_has_its_piece() {
    let pieces = pieces();
    for kind in SceneryKind::ALL {
        assert!(!pieces.get(kind.node()).unwrap().facets.is_empty());
    }
}

#[test]
fn pieces_are_light_and_have_many_colours() {
    for (name, piece) in pieces().iter() {
        let count = piece.facets.len();
        assert!(
            (FEWEST..=MOST).contains(&count),
            "{name}: {count} triangles"
        );
        let corners = || piece.facets.iter().flat_map(|facet| facet.corners);
        assert!(corners().all(|c| c.at.is_finite() && c.colour.min_element() >= 0.0));
        let shades = corners().map(|c| c.colour.to_array().map(|v| (v * 255.0) as u8));
        let mut shades: Vec<[u8; 3]> = shades.collect();
        shades.sort();
        shades.dedup();
        assert!(shades.len() >= 8, "{name}: {} colours", shades.len());
    }
}

#[test]
fn occlusion_is_baked_where_stone_lies_on_stone() {
    let pieces = pieces();
    for name in ["rubble", "tomb", "arch", "gate"] {
        let piece = pieces.get(name).unwrap();
        let open = piece.facets.iter().flat_map(|f| f.corners).map(|c| c.open);
        let (least, most) = open.fold((1.0f32, 0.0f32), |(a, b), o| (a.min(o), b.max(o)));
        assert!(least < 0.45 && most > 0.95, "{name}: {least} to {most}");
    }
}

/// What hangs has its origin at its top, what stands at its foot, what clings to a wall behind it.
#[test]
fn origins_are_where_pieces_are_fixed() {
    use SceneryKind::*;
    let pieces = pieces();
    let founded = [
        Pillar,
        PillarFluted,
        PillarSquare,
        PillarBroken,
        Arch,
        ArchBroken,
        Tower,
        TowerRuin,
        Aqueduct,
        CliffStack,
        Windmill,
    ];
    for &kind in SceneryKind::ALL {
        let (min, max) = pieces.get(kind.node()).unwrap().bounds();
        match kind {
            LanternHanging | LanternHangingDead | BannerTorn | BannerLong | Pulley | Vine
            | Chain | Rope | Stalactite => {
                assert!(max.y < 0.5 && min.y < -0.6, "{kind:?}: {min} {max}");
            }
            LanternWall | LanternWallDead | Ivy => assert!(min.z > -0.05, "{kind:?}: {min}"),
            _ if founded.contains(&kind) => assert!(min.y < -2.5, "{kind:?}: {min}"),
            _ => assert!((-SUNK..=0.08).contains(&min.y), "{kind:?}: {min}"),
        }
        assert!(
            min.x < 0.3 && max.x > -0.3,
            "{kind:?} stands beside its origin"
        );
    }
}

#[test]
fn lit_lanterns_shine_and_dead_ones_do_not() {
    let pieces = pieces();
    let shines = |piece: &Piece| piece.facets.iter().any(|facet| facet.glows);
    for (lit, dead) in [
        (SceneryKind::Lantern, SceneryKind::LanternDead),
        (SceneryKind::LanternWall, SceneryKind::LanternWallDead),
        (SceneryKind::LanternHanging, SceneryKind::LanternHangingDead),
    ] {
        let (lit, dead) = (
            pieces.get(lit.node()).unwrap(),
            pieces.get(dead.node()).unwrap(),
        );
        assert!(shines(lit) && !shines(dead));
        assert!(dead.lights.is_empty() && lit.lights.len() == 1);
        let (min, max) = lit.bounds();
        let light = lit.lights[0];
        assert!(light.at.cmpge(min).all() && light.at.cmple(max).all() && light.reach > 5.0);
    }
    for name in ["lodestone", "gate", "pedestal"] {
        assert!(!pieces.get(name).unwrap().lights.is_empty(), "{name}");
    }
}

#[test]
fn the_wind_moves_what_is_light_and_not_what_is_stone() {
    let pieces = pieces();
    for name in ["grass", "banner", "vine", "tree"] {
        assert!(pieces.get(name).unwrap().sway > 0.0, "{name}");
    }
    for name in ["pillar", "tomb", "rubble", "gate"] {
        assert_eq!(pieces.get(name).unwrap().sway, 0.0, "{name}");
    }
}

/// Whether a colour, linear, is the gold that says: this can be climbed.
fn is_gold(colour: Vec3) -> bool {
    let [red, green, blue] = colour.to_array();
    red > 0.4 && (0.4..0.7).contains(&(green / red)) && blue / red < 0.1
}

/// So a stranger can tell what can be climbed from what only looks as if.
#[test]
fn gold_is_on_what_can_be_climbed_and_on_nothing_else() {
    let climbed = ["chain_metre", "ladder_metre", "vine_metre"];
    for (name, piece) in pieces().iter() {
        let matte = piece.facets.iter().filter(|facet| !facet.glows);
        let gold = matte.filter(|facet| facet.corners.iter().all(|c| is_gold(c.colour)));
        let count = gold.count();
        match climbed.contains(&name) {
            true => assert!(count >= 8, "{name}: {count} golden facets"),
            false => assert_eq!(count, 0, "{name} looks as if it could be climbed"),
        }
    }
}

#[test]
fn a_broken_file_is_named_with_what_is_wrong() {
    let read = |bytes: &[u8]| Pieces::read(bytes, Path::new("some/pieces.glb"));
    let complaint = |bytes: &[u8]| read(bytes).unwrap_err().to_string();
    assert!(complaint(b"").starts_with("some/pieces.glb: "));
    assert!(complaint(b"no model at all, but text").starts_with("some/pieces.glb: "));
    let whole = fs::read(file()).unwrap();
    for length in [11, 19, 500, whole.len() / 2, whole.len() - 1] {
        assert!(read(&whole[..length]).is_err(), "cut after {length} bytes");
    }
    let error = read(&whole).unwrap().get("sphinx").unwrap_err().to_string();
    assert_eq!(error, "some/pieces.glb: node \"sphinx\": is missing");
}

/// The same length, so that the header of the file stays true.
fn changed(from: &str, to: &str) -> String {
    assert_eq!(from.len(), to.len());
    let mut bytes = fs::read(file()).unwrap();
    let at = bytes.windows(from.len()).position(|w| w == from.as_bytes());
    let at = at.unwrap_or_else(|| panic!("{from} is in the file"));
    bytes[at..at + to.len()].copy_from_slice(to.as_bytes());
    let error = Pieces::read(&bytes, Path::new("pieces.glb")).unwrap_err();
    error.to_string()
}

#[test]
fn a_node_that_is_wrong_is_named() {
    let error = changed("\"sway\":0.0", "\"sway\":9.0");
    assert!(
        error.starts_with("pieces.glb: node \"")
            && error.ends_with("extras: sway 9 is outside 0..=1"),
        "{error}"
    );
    let error = changed("\"reach\":1", "\"reach\":x");
    assert!(error.starts_with("pieces.glb: "), "{error}");
    let error = changed("\"reach\"", "\"roach\"");
    assert!(
        error.contains("node \"lantern\": \"light\": extras: missing field `reach`"),
        "{error}"
    );
    let error = changed("\"_OPENNESS\"", "\"_OPINIONS\"");
    assert!(
        error.contains("node \"") && error.contains("no _OPENNESS"),
        "{error}"
    );
    let error = changed("\"name\":\"fern\"", "\"name\":\"reed\"");
    assert!(
        error.contains("node \"reed\": there is another one of this name"),
        "{error}"
    );
}

#[test]
fn random_damage_never_panics() {
    let whole = fs::read(file()).unwrap();
    let mut seed = 7u64;
    let mut draw = |below: usize| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % below
    };
    // The description is at the front: most damage there.
    for round in 0..60 {
        let mut bytes = whole.clone();
        let reach = if round % 3 == 0 { whole.len() } else { 60_000 };
        for _ in 0..1 + draw(6) {
            let at = draw(reach);
            bytes[at] = draw(256) as u8;
        }
        let _ = Pieces::read(&bytes, Path::new("pieces.glb"));
    }
}

/// A piece of one triangle, white, under the open sky, as a description and numbers.
const SMALL: &str = r#"{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"name":"rock","mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1,"_OPENNESS":2}}]}],"buffers":[{"byteLength":84}],
    "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},
        {"buffer":0,"byteOffset":72,"byteLength":12}],
    "accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3,"min":[0,0,0],"max":[1,1,0]},
        {"bufferView":1,"componentType":5126,"type":"VEC3","count":3},
        {"bufferView":2,"componentType":5126,"type":"SCALAR","count":3}]}"#;

/// A .glb file of a description and the numbers of [`SMALL`].
fn glb(json: &str) -> Vec<u8> {
    let places = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let numbers = places.into_iter().chain([1.0; 9]).chain([1.0; 3]);
    let blob: Vec<u8> = numbers.flat_map(|n: f32| n.to_le_bytes()).collect();
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let word = |n: usize| (n as u32).to_le_bytes();
    let length = 12 + 8 + json.len() + 8 + blob.len();
    [
        b"glTF",
        &word(2)[..],
        &word(length),
        &word(json.len()),
        b"JSON",
        &json,
        &word(blob.len()),
        b"BIN\0",
        &blob,
    ]
    .concat()
}

#[test]
fn no_cut_and_no_flipped_byte_makes_it_panic() {
    let read = |bytes: &[u8]| Pieces::read(bytes, Path::new("pieces.glb"));
    let whole = glb(SMALL);
    let pieces = read(&whole).unwrap();
    assert_eq!(pieces.get("rock").unwrap().facets.len(), 1);
    for at in 0..whole.len() {
        assert!(read(&whole[..at]).is_err(), "{at} bytes");
        for flip in [0xff, 1, 0x10, 0x80] {
            let mut bytes = whole.clone();
            bytes[at] ^= flip;
            let _ = read(&bytes);
        }
    }
    // Seventeen bytes with a length that is smaller than the header.
    for length in 0..40u32 {
        let mut bytes = whole[..17].to_vec();
        bytes[8..12].copy_from_slice(&length.to_le_bytes());
        assert!(read(&bytes).is_err(), "{length}");
    }
}

#[test]
fn pieces_take_colours_with_opacity_and_zeros_without_numbers() {
    let read = |json: &str| Pieces::read(&glb(json), Path::new("pieces.glb"));
    let colours = r#""bufferView":1,"componentType":5126,"type":"VEC3","count":3"#;
    // The twelve numbers from the first colour on are ones: three colours with opacity.
    let rgba = SMALL.replace(
        colours,
        r#""bufferView":1,"componentType":5126,"type":"VEC4","count":3"#,
    );
    let rgba = rgba.replace(
        r#""byteOffset":36,"byteLength":36"#,
        r#""byteOffset":36,"byteLength":48"#,
    );
    assert_eq!(read(&rgba), read(SMALL));
    let zeros = read(&SMALL.replace(colours, &colours[15..])).unwrap();
    let rock = zeros.get("rock").unwrap();
    assert!(
        rock.facets[0]
            .corners
            .iter()
            .all(|c| c.colour == Vec3::ZERO)
    );
    let whole_numbers = SMALL.replace(
        colours,
        r#""bufferView":1,"componentType":5121,"type":"VEC4","count":3"#,
    );
    let error = read(&whole_numbers).unwrap_err().to_string();
    assert!(
        error.starts_with("pieces.glb: node \"rock\": COLOR_0: floats are read"),
        "{error}"
    );
}
