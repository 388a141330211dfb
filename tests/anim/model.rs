//! Models out of bytes: a small file made here, read as it was meant, and refused by name when it is broken.

use edgewalker::anim::{Model, Pose, Vertex};
use glam::{Vec3, Vec4};

/// A .glb file in parts, to be spoiled before it is put together.
struct File {
    json: String,
    blob: Vec<u8>,
}

/// Two bones, one above the other; one triangle; a clip in which the upper bone turns by a right angle about z and moves.
fn small() -> File {
    let mut blob = Vec::new();
    let mut put = |numbers: &[f32]| numbers.iter().for_each(|n| blob.extend(n.to_le_bytes()));
    put(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]); // places, at 0
    put(&[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0]); // normals, at 36
    put(&[1.0, 0.5, 0.25, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0]); // colours, at 72
    put(&[1.0, 0.0, 0.0, 0.0, 0.5, 0.5, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]); // weights, at 120
    for column in 0..2 {
        let lift = if column == 0 { 0.0 } else { -1.0 };
        let (x, y, z) = (
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0],
        );
        [x, y, z, [0.0, lift, 0.0, 1.0]].iter().for_each(|c| put(c)); // binds, at 168
    }
    let half = 0.5f32.sqrt();
    put(&[1.0, 1.1]); // times, at 296
    put(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, half, half]); // turns, at 304
    put(&[0.0, 1.0, 0.0, 0.0, 2.0, 0.0]); // places, at 336
    blob.extend([0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0]); // joints, at 360
    let view = |(at, length): (usize, usize)| {
        format!(r#"{{"buffer":0,"byteOffset":{at},"byteLength":{length}}}"#)
    };
    let views = [
        (0, 36),
        (36, 36),
        (72, 48),
        (120, 48),
        (168, 128),
        (296, 8),
        (304, 32),
        (336, 24),
        (360, 12),
    ]
    .map(view);
    let accessor = |(i, kind, shape, count): (usize, u32, &str, usize)| {
        let ends = match i {
            0 => r#","min":[0,0,0],"max":[1,1,0]"#,
            5 => r#","min":[1],"max":[1.1]"#,
            _ => "",
        };
        format!(
            r#"{{"bufferView":{i},"componentType":{kind},"type":"{shape}","count":{count}{ends}}}"#
        )
    };
    let accessors = [
        (0, 5126, "VEC3", 3),
        (1, 5126, "VEC3", 3),
        (2, 5126, "VEC4", 3),
        (3, 5126, "VEC4", 3),
        (4, 5126, "MAT4", 2),
        (5, 5126, "SCALAR", 2),
        (6, 5126, "VEC4", 2),
        (7, 5126, "VEC3", 2),
        (8, 5121, "VEC4", 3),
    ]
    .map(accessor);
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
        "nodes":[{{"name":"armature","children":[2,3],"extras":{{"stride":1.5,"who":"x"}}}},
            {{"name":"upper","translation":[0,1,0]}},{{"name":"lower","children":[1]}},{{"name":"body","mesh":0,"skin":0}}],
        "materials":[{{"name":"glow"}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1,"COLOR_0":2,"WEIGHTS_0":3,"JOINTS_0":8}},"material":0}}]}}],
        "skins":[{{"name":"bones","inverseBindMatrices":4,"joints":[1,2]}}],
        "animations":[{{"name":"bend","channels":[{{"sampler":0,"target":{{"node":1,"path":"rotation"}}}},
            {{"sampler":1,"target":{{"node":1,"path":"translation"}}}}],
            "samplers":[{{"input":5,"output":6}},{{"input":5,"output":7}}]}}],
        "buffers":[{{"byteLength":372}}],"bufferViews":[{}],"accessors":[{}]}}"#,
        views.join(","),
        accessors.join(",")
    );
    File { json, blob }
}

impl File {
    fn bytes(&self) -> Vec<u8> {
        let mut json = self.json.clone().into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let mut bytes = b"glTF".to_vec();
        let mut word = |n: usize| bytes.extend((n as u32).to_le_bytes());
        word(2);
        word(12 + 8 + json.len() + 8 + self.blob.len());
        word(json.len());
        bytes.extend(b"JSON");
        bytes.extend(json);
        bytes.extend((self.blob.len() as u32).to_le_bytes());
        bytes.extend(b"BIN\0");
        bytes.extend(&self.blob);
        bytes
    }

    fn with(mut self, from: &str, to: &str) -> File {
        assert!(self.json.contains(from), "{from}");
        self.json = self.json.replacen(from, to, 1);
        self
    }

    fn with_number(mut self, at: usize, number: f32) -> File {
        self.blob[at..at + 4].copy_from_slice(&number.to_le_bytes());
        self
    }

    fn read(&self) -> Result<Model, String> {
        Model::read("small.glb", &self.bytes()).map_err(|error| error.to_string())
    }
}

#[test]
fn a_file_is_read_as_it_was_meant() {
    let model = small().read().unwrap();
    let names: Vec<&str> = model.skeleton.joints.iter().map(|j| &*j.name).collect();
    assert_eq!(names, ["lower", "upper"], "parents come first");
    assert_eq!(model.skeleton.joints[1].parent, Some(0));
    let [_, second, third] = model.vertices[..] else {
        panic!("{} vertices", model.vertices.len());
    };
    // The skin's joint 0 is the upper bone, which the skeleton has as its second.
    let expected = Vertex {
        at: Vec3::Y,
        normal: Vec3::Z,
        colour: Vec3::Z,
        glows: true,
        joints: [1, 0, 1, 1],
        weights: [0.0, 1.0, 0.0, 0.0],
    };
    assert_eq!(third, expected);
    assert_eq!(second.weights, [0.5, 0.5, 0.0, 0.0]);
    assert_eq!(model.extra("stride"), Some(1.5));
    assert_eq!(model.extra("who"), None);
    assert_eq!(model.extra("width"), None);
}

#[test]
fn a_clip_starts_at_its_first_key_and_bends_the_bone() {
    let model = small().read().unwrap();
    let clip = model.clip("bend").unwrap();
    assert!((clip.seconds - 0.1).abs() < 1e-6, "{} s", clip.seconds);
    let mut pose = Pose::default();
    for (share, x, y) in [
        (0.0, 0.0, 2.0),
        (0.5, -0.5f32.sqrt(), 1.5 + 0.5f32.sqrt()),
        (1.0, -1.0, 2.0),
    ] {
        clip.sample(share * clip.seconds, &mut pose);
        let tip = model.skeleton.place(&pose).bones[1] * Vec4::new(0.0, 1.0, 0.0, 1.0);
        let off = (tip.truncate() - Vec3::new(x, y, 0.0)).length();
        // Keys lie between the file's own: the turn is not exactly even there.
        assert!(off < 0.01, "share {share}: {tip}");
    }
}

#[test]
fn what_is_broken_is_named() {
    let cases = [
        (small().with(r#""skin":0"#, r#""camera":9"#), "small.glb"),
        (
            small().with(r#""mesh":0,"skin":0"#, r#""mesh":0"#),
            "no skinned mesh",
        ),
        (
            small().with(r#""WEIGHTS_0":3,"#, ""),
            "node \"body\": no WEIGHTS_0",
        ),
        (
            small().with_number(120, 0.5),
            "node \"body\": vertex 0: its weights are 0.5",
        ),
        (
            small().with_number(4, f32::NAN),
            "node \"body\": POSITION: a number is not finite",
        ),
        (
            small().with(r#""byteLength":128"#, r#""byteLength":128,"byteStride":4"#),
            "overlap",
        ),
        (
            small().with(r#""byteOffset":360"#, r#""byteOffset":364"#),
            "JOINTS_0: an accessor is empty or reaches beyond",
        ),
        (
            small().with(r#""joints":[1,2]"#, r#""joints":[]"#),
            "skin \"bones\": 0 bones",
        ),
        (
            small().with(r#""inverseBindMatrices":4,"#, ""),
            "skin \"bones\": has no inverse bind",
        ),
        (
            small().with(
                r#""input":5,"output":6"#,
                r#""input":5,"output":6,"interpolation":"CUBICSPLINE""#,
            ),
            "clip \"bend\": bone \"upper\": cubic",
        ),
        (
            small().with_number(296, 2.0),
            "clip \"bend\": bone \"upper\": its keys have no order",
        ),
        (
            small().with_number(316, 3.0),
            "clip \"bend\": bone \"upper\": a key is no turn",
        ),
        (
            small().with_number(300, 1e9),
            "clip \"bend\": moves no bone, or for too long",
        ),
        (
            small().with(r#""input":5,"output":6"#, r#""input":0,"output":6"#),
            "clip \"bend\": bone \"upper\": 3 numbers where 1",
        ),
    ];
    for (i, (file, expected)) in cases.into_iter().enumerate() {
        let error = file.read().expect_err(expected);
        assert!(
            error.starts_with("small.glb") && error.contains(expected),
            "case {i}: {error}"
        );
    }
    assert!(
        Model::read("small.glb", b"glTF")
            .unwrap_err()
            .to_string()
            .contains("small.glb")
    );
}

#[test]
fn no_cut_and_no_wrong_byte_makes_it_panic() {
    let whole = small().bytes();
    for end in 0..whole.len() {
        assert!(Model::read("cut", &whole[..end]).is_err(), "{end} bytes");
    }
    let mut state = 1u32;
    for _ in 0..3000 {
        let mut bytes = whole.clone();
        for _ in 0..3 {
            state = state.wrapping_mul(1664525).wrapping_add(1013904223);
            let at = (state >> 8) as usize % bytes.len();
            bytes[at] = (state >> 24) as u8 ^ state as u8;
        }
        // Some of these still are models; none may end the game.
        let _ = Model::read("spoilt", &bytes);
    }
}

#[test]
fn no_flipped_byte_and_no_lying_length_makes_it_panic() {
    let whole = small().bytes();
    for at in 0..whole.len() {
        for flip in [0xff, 1, 0x10, 0x80] {
            let mut bytes = whole.clone();
            bytes[at] ^= flip;
            let _ = Model::read("flipped", &bytes);
        }
    }
    // The header and the chunks tell lengths.
    let description = u32::from_le_bytes(whole[12..16].try_into().unwrap()) as usize;
    for at in [8, 12, 20 + description] {
        for length in [0, 1, 11, 12, 17, 4096, 1 << 31, u32::MAX - 11, u32::MAX] {
            let mut bytes = whole.clone();
            bytes[at..at + 4].copy_from_slice(&length.to_le_bytes());
            assert!(Model::read("lying", &bytes).is_err(), "{length} at {at}");
            assert!(Model::read("lying", &bytes[..17]).is_err());
        }
    }
    for name in [
        "count",
        "byteLength",
        "byteOffset",
        "bufferView",
        "buffer",
        "input",
        "output",
    ] {
        for value in [
            "0",
            "1",
            "7",
            "4294967295",
            "18446744073709551615",
            "-1",
            "1e99",
            "null",
        ] {
            for nth in 0..9 {
                let mut file = small();
                let field = format!("\"{name}\":");
                let Some((at, _)) = file.json.match_indices(&field).nth(nth) else {
                    break;
                };
                let from = at + field.len();
                let end = from + file.json[from..].find([',', '}']).unwrap();
                file.json.replace_range(from..end, value);
                let _ = file.read();
            }
        }
    }
}

#[test]
fn a_blob_that_is_cut_is_told_of() {
    let whole = small();
    for length in 0..whole.blob.len() {
        let mut file = small();
        file.blob.truncate(length);
        let error = file.read().unwrap_err();
        assert!(error.contains("reaches beyond"), "{length}: {error}");
    }
}

#[test]
fn colours_are_floats_bytes_or_shorts_with_or_without_opacity() {
    let wanted = [[1.0, 0.5, 0.25], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
    let kinds = [(5126, false), (5121, true), (5123, true)];
    for ((kind, normalized), parts) in kinds.into_iter().flat_map(|kind| [(kind, 3), (kind, 4)]) {
        let mut file = small();
        let start = file.blob.len();
        for colour in wanted {
            let rgba = [colour.x, colour.y, colour.z, 0.3];
            for &share in &rgba[..parts] {
                match kind {
                    5121 => file.blob.push((share * 255.0).round() as u8),
                    5123 => file
                        .blob
                        .extend(((share * 65535.0).round() as u16).to_le_bytes()),
                    _ => file.blob.extend(share.to_le_bytes()),
                }
            }
        }
        let length = file.blob.len() - start;
        let file = file
            .with(
                r#"{"buffer":0,"byteOffset":72,"byteLength":48}"#,
                &format!(r#"{{"buffer":0,"byteOffset":{start},"byteLength":{length}}}"#),
            )
            .with(
                r#""bufferView":2,"componentType":5126,"type":"VEC4""#,
                &format!(
                    r#""bufferView":2,"normalized":{normalized},"componentType":{kind},"type":"VEC{parts}""#
                ),
            );
        for (vertex, colour) in file.read().unwrap().vertices.iter().zip(wanted) {
            assert!(
                (vertex.colour - colour).length() < 0.01,
                "{kind}, {parts}: {vertex:?}"
            );
        }
    }
    for (from, to) in [
        (
            r#""componentType":5126,"type":"VEC4","count":3"#,
            r#""componentType":5125,"type":"VEC4","count":3"#,
        ),
        (
            r#""componentType":5126,"type":"VEC4","count":3"#,
            r#""componentType":5121,"type":"VEC4","count":3"#,
        ),
        (
            r#""componentType":5126,"type":"VEC4","count":3"#,
            r#""componentType":5122,"normalized":true,"type":"VEC4","count":3"#,
        ),
        (r#""type":"VEC4","count":3"#, r#""type":"VEC2","count":3"#),
    ] {
        let error = small().with(from, to).read().unwrap_err();
        assert!(error.contains("node \"body\": COLOR_0: "), "{error}");
    }
}

#[test]
fn an_accessor_without_numbers_means_zeros() {
    let normals = r#""bufferView":1,"componentType":5126,"type":"VEC3","count":3"#;
    let zeros = r#""componentType":5126,"type":"VEC3","count":3"#;
    let model = small().with(normals, zeros).read().unwrap();
    // A normal without a direction is drawn upwards.
    assert!(model.vertices.iter().all(|vertex| vertex.normal == Vec3::Y));
    let weights = r#""bufferView":3,"componentType""#;
    let error = small().with(weights, r#""componentType""#).read();
    assert!(error.unwrap_err().contains("its weights are 0 in sum"));
    let huge = zeros.replace("\"count\":3", "\"count\":99999999999");
    let error = small().with(normals, &huge).read().unwrap_err();
    assert!(
        error.contains("accessor 1 is without numbers, and too long"),
        "{error}"
    );
    // One that nobody reads does no harm: Blender writes such for shape keys.
    let unread = format!(r#""accessors":[{{{zeros}}},"#);
    let mut file = small().with(r#""accessors":["#, &unread);
    for at in (0..9).rev() {
        for name in [
            "POSITION",
            "NORMAL",
            "COLOR_0",
            "WEIGHTS_0",
            "JOINTS_0",
            "inverseBindMatrices",
            "input",
            "output",
        ] {
            let (from, to) = (format!("\"{name}\":{at}"), format!("\"{name}\":{}", at + 1));
            file.json = file.json.replace(&from, &to);
        }
    }
    assert_eq!(file.read(), small().read());
}
