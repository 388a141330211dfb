//! The hero's model as bytes: `assets/models/hero.glb` has the bones, clips and extras that the game plays, its loops close, its
//! feet do not slide, its weights sum to one.

use glam::{Mat4, Quat, Vec3};
use gltf::animation::util::ReadOutputs;
use gltf::{Gltf, Semantic};
use std::collections::{BTreeMap, BTreeSet};

const KEYS_A_SECOND: f32 = 30.0;
/// A foot this close to the ground stands on it; metres.
const TOUCHES: f32 = 0.003;
/// How far a key's number may be from a whole one.
const ROUNDING: f32 = 1e-3;

/// Clip, its shortest and longest allowed time in seconds, whether it is a loop.
const CLIPS: [(&str, f32, f32, bool); 18] = [
    ("idle", 1.5, 6.0, true),
    ("walk", 0.6, 1.5, true),
    ("run", 0.4, 1.0, true),
    ("turn", 0.2, 0.8, false),
    ("jump", 0.2, 0.8, false),
    ("rise", 0.5, 2.0, true),
    ("fall", 0.5, 2.0, true),
    ("land_soft", 0.2, 0.8, false),
    ("land_hard", 0.2, 0.8, false),
    ("crouch", 1.0, 6.0, true),
    ("crawl", 0.4, 1.5, true),
    ("wall_slide", 0.5, 2.0, true),
    ("ledge_hang", 1.0, 4.0, true),
    ("ledge_climb", 0.2, 0.8, false),
    ("ladder", 0.4, 1.5, true),
    ("climb_wall", 0.4, 1.5, true),
    ("roll", 0.2, 0.8, false),
    ("death", 1.15, 1.25, false),
];

/// Bone and the bone that carries it; `.?` stands for both sides.
const BONES: [(&str, &str); 20] = [
    ("hips", "root"),
    ("spine", "hips"),
    ("chest", "spine"),
    ("neck", "chest"),
    ("head", "neck"),
    ("crest", "head"),
    ("upper_arm.?", "chest"),
    ("forearm.?", "upper_arm.?"),
    ("hand.?", "forearm.?"),
    ("thigh.?", "hips"),
    ("shin.?", "thigh.?"),
    ("foot.?", "shin.?"),
    ("cape.1", "chest"),
    ("cape.2", "cape.1"),
    ("cape.3", "cape.2"),
    ("cape.4", "cape.3"),
    ("cape.5", "cape.4"),
    ("lantern", "hand.l"),
    ("sword", "hips"),
    ("root", "hero_rig"),
];

/// A corner of the mesh.
struct Corner {
    at: Vec3,
    joints: [u16; 4],
    weights: [f32; 4],
}

/// The keys of one property of one node.
struct Channel {
    node: usize,
    times: Vec<f32>,
    values: Values,
}

enum Values {
    Shift(Vec<Vec3>),
    Turn(Vec<Quat>),
}

impl Channel {
    /// The two keys about a time, and the share of the second.
    fn about(&self, time: f32) -> (usize, usize, f32) {
        let after = self
            .times
            .partition_point(|&t| t <= time)
            .min(self.times.len() - 1);
        let before = after.saturating_sub(1);
        let span = self.times[after] - self.times[before];
        let share = if span > 0.0 {
            ((time - self.times[before]) / span).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (before, after, share)
    }
}

/// What the tests need of the file.
struct Model {
    file: Gltf,
    blob: Vec<u8>,
    corners: Vec<Corner>,
}

impl Model {
    fn load() -> Model {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/models/hero.glb");
        let mut file = Gltf::from_slice(&std::fs::read(path).unwrap()).unwrap();
        let blob = file.blob.take().unwrap();
        let mesh = file.meshes().find(|m| m.name() == Some("hero")).unwrap();
        let mut corners = Vec::new();
        for primitive in mesh.primitives() {
            let reader = primitive.reader(|_| Some(&blob));
            let joints = reader.read_joints(0).unwrap().into_u16();
            let weights = reader.read_weights(0).unwrap().into_f32();
            let places = reader.read_positions().unwrap();
            for ((at, joints), weights) in places.zip(joints).zip(weights) {
                corners.push(Corner {
                    at: at.into(),
                    joints,
                    weights,
                });
            }
        }
        Model {
            file,
            blob,
            corners,
        }
    }

    fn node(&self, name: &str) -> gltf::Node<'_> {
        let found = self.file.nodes().find(|node| node.name() == Some(name));
        found.unwrap_or_else(|| panic!("no node {name}"))
    }

    fn carriers(&self) -> BTreeMap<usize, usize> {
        let pairs = self.file.nodes().flat_map(|node| {
            let carried: Vec<usize> = node.children().map(|child| child.index()).collect();
            carried.into_iter().map(move |child| (child, node.index()))
        });
        pairs.collect()
    }

    fn channels(&self, clip: &str) -> Vec<Channel> {
        let found = self.file.animations().find(|a| a.name() == Some(clip));
        let animation = found.unwrap_or_else(|| panic!("no clip {clip}"));
        let mut channels = Vec::new();
        for channel in animation.channels() {
            let reader = channel.reader(|_| Some(&self.blob));
            let values = match reader.read_outputs().unwrap() {
                ReadOutputs::Translations(shifts) => {
                    Values::Shift(shifts.map(Vec3::from).collect())
                }
                ReadOutputs::Rotations(turns) => {
                    Values::Turn(turns.into_f32().map(Quat::from_array).collect())
                }
                ReadOutputs::Scales(mut scales) => {
                    assert!(
                        scales.all(|s| (Vec3::from(s) - Vec3::ONE).length() < 1e-4),
                        "{clip} changes sizes"
                    );
                    continue;
                }
                ReadOutputs::MorphTargetWeights(_) => panic!("{clip} has morph targets"),
            };
            channels.push(Channel {
                node: channel.target().node().index(),
                times: reader.read_inputs().unwrap().collect(),
                values,
            });
        }
        channels
    }

    /// Where all corners are at a time of a clip.
    fn posed(&self, channels: &[Channel], time: f32) -> Vec<Vec3> {
        let rest = |node: gltf::Node| {
            let (shift, turn, _) = node.transform().decomposed();
            (Vec3::from(shift), Quat::from_array(turn))
        };
        let mut local: Vec<(Vec3, Quat)> = self.file.nodes().map(rest).collect();
        for channel in channels {
            let (a, b, share) = channel.about(time);
            match &channel.values {
                Values::Shift(v) => local[channel.node].0 = v[a].lerp(v[b], share),
                Values::Turn(v) => local[channel.node].1 = v[a].slerp(v[b], share),
            }
        }
        let carriers = self.carriers();
        let world = |mut node: usize| {
            let matrix =
                |node: usize| Mat4::from_rotation_translation(local[node].1, local[node].0);
            let mut placed = matrix(node);
            while let Some(&carrier) = carriers.get(&node) {
                placed = matrix(carrier) * placed;
                node = carrier;
            }
            placed
        };
        let skin = self.file.skins().next().unwrap();
        let reader = skin.reader(|_| Some(&self.blob));
        let inverse = reader.read_inverse_bind_matrices().unwrap();
        let bones: Vec<Mat4> = skin
            .joints()
            .zip(inverse)
            .map(|(joint, inverse)| world(joint.index()) * Mat4::from_cols_array_2d(&inverse))
            .collect();
        let place = |corner: &Corner| {
            let parts = corner.joints.iter().zip(corner.weights);
            parts
                .map(|(&joint, weight)| bones[joint as usize].transform_point3(corner.at) * weight)
                .sum()
        };
        self.corners.iter().map(place).collect()
    }

    /// The corners that follow a bone alone.
    fn of_bone(&self, name: &str) -> Vec<usize> {
        let skin = self.file.skins().next().unwrap();
        let joint = skin.joints().position(|j| j.name() == Some(name)).unwrap();
        let whole = |corner: &Corner| {
            let parts = corner.joints.iter().zip(corner.weights);
            let share: f32 = parts
                .filter(|(j, _)| **j as usize == joint)
                .map(|(_, w)| w)
                .sum();
            share > 0.99
        };
        let all = self.corners.iter().enumerate();
        all.filter(|(_, corner)| whole(corner))
            .map(|(i, _)| i)
            .collect()
    }

    fn extra(&self, name: &str) -> f32 {
        let rig = self.node("hero_rig");
        // A JSON object is a map in RON as well.
        let text = rig.extras().as_ref().expect("extras").get();
        let extras: BTreeMap<String, ron::Value> = ron::from_str(text).unwrap();
        match extras.get(name) {
            Some(ron::Value::Number(number)) => number.into_f64() as f32,
            other => panic!("{name} is {other:?}"),
        }
    }
}

/// Seconds that a clip takes.
fn seconds(channels: &[Channel]) -> f32 {
    let ends = channels
        .iter()
        .map(|channel| *channel.times.last().unwrap());
    ends.fold(0.0, f32::max)
}

/// All names of the two-sided bones.
fn both_sides(name: &str) -> Vec<String> {
    match name.strip_suffix(".?") {
        Some(stem) => vec![format!("{stem}.l"), format!("{stem}.r")],
        None => vec![name.to_string()],
    }
}

#[test]
fn the_body_is_one_coloured_mesh_of_few_triangles() {
    let model = Model::load();
    let mut triangles = 0;
    let mut materials = BTreeSet::new();
    for primitive in model.file.meshes().flat_map(|mesh| mesh.primitives()) {
        triangles += primitive.indices().unwrap().count() / 3;
        materials.insert(primitive.material().name().unwrap_or("").to_string());
        assert!(!primitive.material().double_sided());
        for semantic in [Semantic::Normals, Semantic::Colors(0)] {
            assert!(primitive.get(&semantic).is_some(), "no {semantic:?}");
        }
    }
    assert!((2000..=4000).contains(&triangles), "{triangles} triangles");
    assert_eq!(materials.into_iter().collect::<Vec<_>>(), ["glow", "matte"]);
    assert_eq!(model.file.meshes().count(), 1);
    assert_eq!(model.file.skins().count(), 1);
}

#[test]
fn every_bone_is_there_with_the_axes_of_the_figure() {
    let model = Model::load();
    let carriers = model.carriers();
    let skin = model.file.skins().next().unwrap();
    let joints: BTreeSet<&str> = skin.joints().filter_map(|joint| joint.name()).collect();
    let mut count = 0;
    for (bone, carrier) in BONES {
        for (bone, side) in both_sides(bone).iter().zip(["l", "r"]) {
            let node = model.node(bone);
            let by = model.node(&carrier.replace('?', side)).index();
            assert_eq!(carriers.get(&node.index()), Some(&by), "{bone}");
            let turn = Quat::from_array(node.transform().decomposed().1);
            assert!(
                turn.angle_between(Quat::IDENTITY) < 1e-3,
                "{bone} is turned"
            );
            assert!(joints.contains(bone.as_str()), "{bone} moves nothing");
            count += 1;
        }
    }
    assert_eq!(joints.len(), count, "{joints:?}");
}

#[test]
fn weights_sum_to_one_over_at_most_three_bones() {
    let model = Model::load();
    for corner in &model.corners {
        let sum: f32 = corner.weights.iter().sum();
        assert!((sum - 1.0).abs() < 1e-4, "{} at {}", sum, corner.at);
        let bones = corner.weights.iter().filter(|&&w| w > 0.0).count();
        assert!(bones <= 3, "{bones} bones at {}", corner.at);
    }
}

#[test]
fn every_clip_is_there_keyed_thirty_times_a_second() {
    let model = Model::load();
    let names: BTreeSet<&str> = model.file.animations().filter_map(|a| a.name()).collect();
    assert_eq!(names, CLIPS.map(|clip| clip.0).into_iter().collect());
    for (clip, shortest, longest, _) in CLIPS {
        let channels = model.channels(clip);
        let length = seconds(&channels);
        assert!((shortest..=longest).contains(&length), "{clip}: {length} s");
        for channel in &channels {
            assert_eq!(channel.times[0], 0.0, "{clip}");
            assert!(
                (channel.times.last().unwrap() - length).abs() < 1e-5,
                "{clip}"
            );
            for time in &channel.times {
                let key = time * KEYS_A_SECOND;
                assert!(
                    (key - key.round()).abs() < ROUNDING,
                    "{clip}: a key at {time} s"
                );
            }
        }
    }
}

#[test]
fn loops_end_as_they_begin() {
    let model = Model::load();
    for (clip, _, _, _) in CLIPS.into_iter().filter(|clip| clip.3) {
        let channels = model.channels(clip);
        let length = seconds(&channels);
        let (first, last) = (model.posed(&channels, 0.0), model.posed(&channels, length));
        let apart = first.iter().zip(&last).map(|(a, b)| (*a - *b).length());
        assert!(apart.fold(0.0, f32::max) < 1e-4, "{clip} does not close");
    }
}

#[test]
fn what_the_game_moves_by_springs_is_left_alone() {
    let model = Model::load();
    let loose: Vec<usize> = ["cape.1", "cape.2", "cape.3", "cape.4", "cape.5", "crest"]
        .map(|name| model.node(name).index())
        .into();
    for (clip, ..) in CLIPS {
        for channel in model.channels(clip) {
            if let Values::Turn(turns) = &channel.values
                && loose.contains(&channel.node)
            {
                let turned = turns.iter().map(|turn| turn.angle_between(Quat::IDENTITY));
                assert!(
                    turned.fold(0.0, f32::max) < 1e-3,
                    "{clip} turns cape or crest"
                );
            }
        }
    }
}

/// Of a foot at two times of a loop: the corner that is lowest at the first, at both times.
fn lowest(foot: &[usize], before: &[Vec3], after: &[Vec3]) -> (Vec3, Vec3) {
    let by_height = |a: &&usize, b: &&usize| before[**a].y.total_cmp(&before[**b].y);
    let corner = *foot.iter().min_by(by_height).unwrap();
    (before[corner], after[corner])
}

#[test]
fn feet_on_the_ground_go_back_at_the_speed_of_the_ground() {
    let model = Model::load();
    for clip in ["walk", "run", "crawl"] {
        let channels = model.channels(clip);
        let length = seconds(&channels);
        let speed = model.extra(&format!("stride_{clip}")) / length;
        // Between the keys too: a quarter of a key at a time.
        let parts = 4;
        let step = 1.0 / (KEYS_A_SECOND * parts as f32);
        let times = (length / step).round() as usize;
        let poses: Vec<_> = (0..=times)
            .map(|i| model.posed(&channels, i as f32 * step))
            .collect();
        for side in ["foot.l", "foot.r"] {
            let foot = model.of_bone(side);
            let mut planted = 0;
            for key in (0..times).step_by(parts) {
                let down = |i: usize| lowest(&foot, &poses[i], &poses[i]).0.y.abs() < TOUCHES;
                if !down(key) || !down(key + parts) {
                    continue;
                }
                planted += 1;
                let (from, to) = lowest(&foot, &poses[key], &poses[key + parts]);
                let back = (from.x - to.x) * KEYS_A_SECOND;
                assert!(
                    (back / speed - 1.0).abs() < 0.05,
                    "{clip}: {side} goes back at {back} m/s of {speed} from key {}",
                    key / parts
                );
                for part in 1..parts {
                    let (from, now) = lowest(&foot, &poses[key], &poses[key + part]);
                    let slid = now.x - from.x + speed * step * part as f32;
                    assert!(slid.abs() < 0.01, "{clip}: {side} slides {slid} m");
                    assert!(now.y > -0.01, "{clip}: {side} is {} m deep", now.y);
                }
            }
            let share = planted as f32 / (length * KEYS_A_SECOND);
            assert!(
                (0.2..0.7).contains(&share),
                "{clip}: {side} is down for {share}"
            );
        }
    }
}

#[test]
fn the_figure_has_the_size_of_its_collider() {
    let model = Model::load();
    let head = model.of_bone("head");
    let extent = |clip: &str, axis: usize| {
        let posed = model.posed(&model.channels(clip), 0.0);
        let all = posed.iter().map(|corner| corner[axis]);
        let (low, high) = all.fold((f32::MAX, f32::MIN), |(l, h), v| (l.min(v), h.max(v)));
        (low, high, high - low)
    };
    let (foot, top, _) = extent("idle", 1);
    assert!(foot.abs() < 0.01, "the soles are at {foot}");
    assert!((1.62..1.72).contains(&top), "{top} m tall");
    let width = extent("idle", 0).2;
    assert!(width <= 0.8, "{width} m wide");
    // Crouching, the helm stays below a low ceiling; the crest may bend.
    for clip in ["crouch", "crawl"] {
        let channels = model.channels(clip);
        let keys = (seconds(&channels) * KEYS_A_SECOND).round() as usize;
        for key in 0..=keys {
            let posed = model.posed(&channels, key as f32 / KEYS_A_SECOND);
            let top = head.iter().map(|&i| posed[i].y).fold(f32::MIN, f32::max);
            assert!(
                top < 61.0 / 64.0,
                "{clip}: the head is at {top} at key {key}"
            );
        }
    }
}

/// How deep something may be in the ground for a moment: less than a sole's thickness, m.
const SINKS: f32 = 0.02;

/// All corners but those that springs move, in whole or in part.
fn body(model: &Model) -> Vec<usize> {
    let skin = model.file.skins().next().unwrap();
    let springs = ["cape", "crest", "lantern"];
    let is_sprung =
        |joint: gltf::Node| springs.iter().any(|s| joint.name().unwrap().starts_with(s));
    let sprung: Vec<bool> = skin.joints().map(is_sprung).collect();
    let is_free = |corner: &Corner| {
        let mut parts = corner.joints.iter().zip(corner.weights);
        parts.all(|(&joint, weight)| weight == 0.0 || !sprung[joint as usize])
    };
    let all = model.corners.iter().enumerate();
    all.filter(|(_, corner)| is_free(corner))
        .map(|(i, _)| i)
        .collect()
}

#[test]
fn nothing_sinks_into_the_ground() {
    let model = Model::load();
    let body = body(&model);
    let mut deep = Vec::new();
    for clip in "idle walk run turn land_soft land_hard crouch crawl roll death".split(' ') {
        let channels = model.channels(clip);
        let keys = (seconds(&channels) * KEYS_A_SECOND).round() as usize;
        for key in 0..=keys {
            let posed = model.posed(&channels, key as f32 / KEYS_A_SECOND);
            let low = body.iter().map(|&i| posed[i].y).fold(f32::MAX, f32::min);
            if low < -SINKS {
                deep.push(format!("{clip} at key {key}: {low:.3} m"));
            }
        }
    }
    assert!(deep.is_empty(), "{deep:#?}");
}
