//! A skinned model out of the bytes of a .glb file: mesh, skeleton, clips, numbers that its makers left.
//!
//! One file holds one skinned mesh on one skeleton. Everything is checked here, at the door; what is wrong is said
//! with file and node or clip.

use super::clip::{Clip, RATE};
use super::glb::Glb;
use super::numbers::Numbers;
use super::skeleton::{Joint, MAX_BONES, Skeleton};
use super::trs::Trs;
use glam::{Mat4, Quat, Vec3};
use gltf::Semantic;
use gltf::animation::{Interpolation, Property};

/// Material whose colour shines by itself.
const GLOW: &str = "glow";
/// Longest clip, in seconds: a file that asks for more is broken.
const LONGEST: f32 = 60.0;
/// How far the weights of a vertex may be from one in sum.
const WEIGHT_SLACK: f32 = 0.02;

/// One corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Metres, in the pose that the mesh was bound in.
    pub at: Vec3,
    /// A unit vector.
    pub normal: Vec3,
    /// Linear red, green, blue.
    pub colour: Vec3,
    /// Shines by itself.
    pub glows: bool,
    /// Bones that move it, as indices of the skeleton.
    pub joints: [u8; 4],
    /// How much each of them does; in sum 1.
    pub weights: [f32; 4],
}

/// A figure with all that moves it.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Three for each triangle.
    pub vertices: Vec<Vertex>,
    /// Its bones.
    pub skeleton: Skeleton,
    /// Its movements.
    pub clips: Vec<Clip>,
    /// Numbers that its makers left on any node, by name.
    pub extras: Vec<(String, f32)>,
}

/// Why a model cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelError {
    /// The file.
    pub file: String,
    /// The node, clip, bone or number concerned; empty: the whole file.
    pub part: String,
    /// What is wrong.
    pub why: String,
}

impl std::fmt::Display for ModelError {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self.part.is_empty() {
            true => write!(f, "{}: {}", self.file, self.why),
            false => write!(f, "{}: {}: {}", self.file, self.part, self.why),
        }
    }
}

impl std::error::Error for ModelError {}

/// What is wrong, and with which part of the file.
type Flaw = (String, String);

/// Names the part that something is wrong with.
fn of<'a, W: Into<String>>(kind: &'a str, name: &'a str) -> impl Fn(W) -> Flaw + 'a {
    move |why| (format!("{kind} \"{name}\""), why.into())
}

impl Model {
    /// Reads a model; `file` is what errors call it.
    ///
    /// # Errors
    /// The bytes are no .glb, or do not hold what the header of this file says.
    pub fn read(file: &str, bytes: &[u8]) -> Result<Model, ModelError> {
        parse(bytes).map_err(|(part, why)| ModelError {
            file: file.to_string(),
            part,
            why,
        })
    }

    /// A number that its makers left.
    pub fn extra(&self, name: &str) -> Option<f32> {
        let found = self.extras.iter().find(|(known, _)| known == name);
        found.map(|(_, value)| *value)
    }

    /// A movement by its name.
    pub fn clip(&self, name: &str) -> Option<&Clip> {
        self.clips.iter().find(|clip| clip.name == name)
    }
}

fn parse(bytes: &[u8]) -> Result<Model, Flaw> {
    let whole = |why: String| (String::new(), why);
    let glb = Glb::open(bytes).map_err(whole)?;
    let (gltf, numbers) = (&glb.document, glb.numbers());
    let skinned = |node: &gltf::Node| node.mesh().is_some() && node.skin().is_some();
    let mut nodes = gltf.nodes().filter(skinned);
    let node = nodes
        .next()
        .ok_or_else(|| whole("has no skinned mesh".into()))?;
    if nodes.next().is_some() {
        return Err(whole("has more than one skinned mesh".into()));
    }
    let (mesh, skin) = node.mesh().zip(node.skin()).expect("the node has both");
    let bones = Bones::read(gltf, &skin, numbers)?;
    let mut vertices = Vec::new();
    for primitive in mesh.primitives() {
        read_primitive(&primitive, numbers, &bones, &mut vertices)
            .map_err(of("node", node.name().unwrap_or_default()))?;
    }
    let clips = gltf.animations().map(|clip| {
        let name = clip.name().unwrap_or_default();
        read_clip(&clip, numbers, &bones).map_err(of("clip", name))
    });
    Ok(Model {
        vertices,
        clips: clips.collect::<Result<_, _>>()?,
        extras: gltf.nodes().flat_map(|node| numbers_left(&node)).collect(),
        skeleton: bones.skeleton,
    })
}

/// The skeleton, and which of its bones a node and a number of the skin are.
struct Bones {
    skeleton: Skeleton,
    /// By node.
    of_node: Vec<Option<usize>>,
    /// By the skin's own numbers.
    of_skin: Vec<usize>,
}

impl Bones {
    fn read(gltf: &gltf::Document, skin: &gltf::Skin, numbers: Numbers) -> Result<Bones, Flaw> {
        let fail = of("skin", skin.name().unwrap_or_default());
        let joints: Vec<gltf::Node> = skin.joints().collect();
        if joints.is_empty() || joints.len() > MAX_BONES {
            let count = joints.len();
            return Err(fail(format!("{count} bones; 1 to {MAX_BONES} are read")));
        }
        let accessor = skin.inverse_bind_matrices();
        let accessor = accessor.ok_or_else(|| fail("has no inverse bind matrices".into()))?;
        let binds: Vec<[f32; 16]> = numbers.read(&accessor).map_err(&fail)?;
        if binds.len() < joints.len() {
            return Err(fail("has too few inverse bind matrices".into()));
        }
        let mut parents = vec![None; gltf.nodes().count()];
        for node in gltf.nodes() {
            for child in node.children() {
                parents[child.index()] = Some(node.index());
            }
        }
        let mut bones = Bones {
            skeleton: Skeleton::default(),
            of_node: vec![None; parents.len()],
            of_skin: vec![0; joints.len()],
        };
        let is_joint = |index: usize| joints.iter().any(|joint| joint.index() == index);
        // Parents first: whoever has all above him placed comes next, until nobody does.
        while bones.skeleton.joints.len() < joints.len() {
            let before = bones.skeleton.joints.len();
            for (number, joint) in joints.iter().enumerate() {
                let parent = parents[joint.index()].filter(|&up| is_joint(up));
                let ready = parent.is_none_or(|up| bones.of_node[up].is_some());
                if ready && bones.of_node[joint.index()].is_none() {
                    let parent = parent.and_then(|up| bones.of_node[up]);
                    bones.add(joint, number, parent, &binds[number])?;
                }
            }
            if bones.skeleton.joints.len() == before {
                return Err(fail("its bones hang from each other in a circle".into()));
            }
        }
        let top = joints.iter().find(|j| bones.of_node[j.index()] == Some(0));
        let above = top.and_then(|joint| parents[joint.index()]);
        bones.skeleton.above = standing(gltf, above, &parents);
        Ok(bones)
    }

    fn add(
        &mut self,
        node: &gltf::Node,
        number: usize,
        parent: Option<usize>,
        bind: &[f32; 16],
    ) -> Result<(), Flaw> {
        let name = node.name().unwrap_or_default();
        let (place, turn, size) = node.transform().decomposed();
        let rest = Trs {
            place: place.into(),
            turn: Quat::from_array(turn),
            size: size.into(),
        };
        if parent.is_none() && !self.skeleton.joints.is_empty() {
            return Err(of("bone", name)("a second one that hangs from nothing"));
        }
        let unit = (rest.turn.length() - 1.0).abs() < 1e-3;
        if !rest.is_finite() || !unit {
            return Err(of("bone", name)("rests at no place, or with no turn"));
        }
        let index = self.skeleton.joints.len();
        self.of_node[node.index()] = Some(index);
        self.of_skin[number] = index;
        self.skeleton.joints.push(Joint {
            name: name.to_string(),
            parent,
            rest,
            inverse_bind: Mat4::from_cols_array(bind),
        });
        Ok(())
    }
}

/// From a node's space to the scene's.
fn standing(gltf: &gltf::Document, node: Option<usize>, parents: &[Option<usize>]) -> Mat4 {
    let mut matrix = Mat4::IDENTITY;
    let mut at = node;
    // No way up is longer than there are nodes, unless it is a circle.
    for _ in 0..parents.len() {
        let Some(index) = at else { break };
        if let Some(node) = gltf.nodes().nth(index) {
            matrix = Mat4::from_cols_array_2d(&node.transform().matrix()) * matrix;
        }
        at = parents[index];
    }
    matrix
}

fn read_primitive(
    primitive: &gltf::Primitive,
    numbers: Numbers,
    bones: &Bones,
    vertices: &mut Vec<Vertex>,
) -> Result<(), String> {
    let places: Vec<[f32; 3]> = numbers.attribute(primitive, Semantic::Positions)?;
    let normals: Vec<[f32; 3]> = numbers.attribute(primitive, Semantic::Normals)?;
    let colours = numbers.colours(primitive)?;
    let joints: Vec<[f32; 4]> = numbers.attribute(primitive, Semantic::Joints(0))?;
    let weights: Vec<[f32; 4]> = numbers.attribute(primitive, Semantic::Weights(0))?;
    let count = places.len();
    if [normals.len(), colours.len(), joints.len(), weights.len()] != [count; 4] {
        return Err("its attributes are of different lengths".into());
    }
    let glows = primitive.material().name() == Some(GLOW);
    for i in numbers.corners(primitive, count)? {
        let sum: f32 = weights[i].iter().sum();
        if (sum - 1.0).abs() > WEIGHT_SLACK {
            return Err(format!("vertex {i}: its weights are {sum} in sum"));
        }
        let mut moved_by = [0; 4];
        for (bone, number) in moved_by.iter_mut().zip(joints[i]) {
            let found = bones.of_skin.get(number as usize);
            *bone =
                *found.ok_or_else(|| format!("vertex {i}: bone {number} does not exist"))? as u8;
        }
        vertices.push(Vertex {
            at: places[i].into(),
            normal: Vec3::from(normals[i]).normalize_or(Vec3::Y),
            colour: colours[i].into(),
            glows,
            joints: moved_by,
            weights: weights[i].map(|weight| weight / sum),
        });
    }
    Ok(())
}

/// What one channel of a clip moves, with its keys.
struct Channel {
    bone: usize,
    property: Property,
    times: Vec<f32>,
    values: Vec<[f32; 4]>,
    steps: bool,
}

fn read_clip(clip: &gltf::Animation, numbers: Numbers, bones: &Bones) -> Result<Clip, String> {
    let mut channels = Vec::new();
    for channel in clip.channels() {
        let node = channel.target().node();
        if let Some(bone) = bones.of_node[node.index()] {
            let name = node.name().unwrap_or_default();
            let read = read_channel(&channel, bone, numbers);
            channels.extend(read.map_err(|why| format!("bone \"{name}\": {why}"))?);
        }
    }
    let times = channels.iter().flat_map(|channel| &channel.times);
    let ends = times.fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), &t| {
        (a.min(t), b.max(t))
    });
    let (start, seconds) = (ends.0, ends.1 - ends.0);
    if !(0.0..LONGEST).contains(&seconds) {
        return Err("moves no bone, or for too long".into());
    }
    let count = bones.skeleton.joints.len();
    let mut keys = Vec::new();
    for key in 0..=(seconds * RATE).round() as usize {
        let first = keys.len();
        keys.extend(bones.skeleton.joints.iter().map(|joint| joint.rest));
        for channel in &channels {
            channel.put(start + key as f32 / RATE, &mut keys[first + channel.bone]);
        }
    }
    Clip::new(clip.name().unwrap_or_default(), count, keys).ok_or_else(|| "has no keys".into())
}

fn read_channel(
    channel: &gltf::animation::Channel,
    bone: usize,
    numbers: Numbers,
) -> Result<Option<Channel>, String> {
    let (sampler, property) = (channel.sampler(), channel.target().property());
    let steps = match sampler.interpolation() {
        Interpolation::Linear => false,
        Interpolation::Step => true,
        Interpolation::CubicSpline => return Err("cubic splines are not read".into()),
    };
    let values = match property {
        Property::MorphTargetWeights => return Ok(None),
        Property::Rotation => numbers.read::<4>(&sampler.output())?,
        Property::Translation | Property::Scale => {
            let three = numbers.read::<3>(&sampler.output())?;
            three.into_iter().map(|[x, y, z]| [x, y, z, 0.0]).collect()
        }
    };
    let times = numbers.read::<1>(&sampler.input())?;
    let times: Vec<f32> = times.into_iter().map(|[time]| time).collect();
    if times.len() != values.len() || !times.is_sorted() {
        return Err("its keys have no order, or not each has its time".into());
    }
    let is_turn = |value: &[f32; 4]| (Quat::from_array(*value).length() - 1.0).abs() < 0.01;
    if property == Property::Rotation && !values.iter().all(is_turn) {
        return Err("a key is no turn".into());
    }
    Ok(Some(Channel {
        bone,
        property,
        times,
        values,
        steps,
    }))
}

impl Channel {
    /// Puts what it says of a time.
    fn put(&self, time: f32, bone: &mut Trs) {
        let last = self.times.len() - 1;
        let next = self.times.partition_point(|&t| t <= time).min(last);
        let before = next.saturating_sub(1);
        let before = if time >= self.times[last] {
            last
        } else {
            before
        };
        let span = self.times[next] - self.times[before];
        let share = match span > 0.0 && !self.steps {
            true => ((time - self.times[before]) / span).clamp(0.0, 1.0),
            false => 0.0,
        };
        let trs = |key: usize| {
            let [x, y, z, w] = self.values[key];
            let mut trs = *bone;
            match self.property {
                Property::Translation => trs.place = Vec3::new(x, y, z),
                Property::Scale => trs.size = Vec3::new(x, y, z),
                _ => trs.turn = Quat::from_xyzw(x, y, z, w).normalize(),
            }
            trs
        };
        *bone = trs(before).lerp(&trs(next), share);
    }
}

/// The numbers among the extras of a node.
fn numbers_left(node: &gltf::Node) -> Vec<(String, f32)> {
    let Some(raw) = node.extras() else {
        return Vec::new();
    };
    let parsed = gltf::json::deserialize::from_str(raw.get());
    let Ok(gltf::json::Value::Object(fields)) = parsed else {
        return Vec::new();
    };
    let number = |(name, value): (String, gltf::json::Value)| Some((name, value.as_f64()? as f32));
    fields.into_iter().filter_map(number).collect()
}
