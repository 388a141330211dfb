//! A .glb file as its two parts, the description and the numbers, with all checked that reading either takes for granted.
//!
//! Nothing here trusts a length or an index, and no file ends in anything but an error: the `gltf` crate's own reading computes
//! with lengths before it checks them.

use super::numbers::{Numbers, parts, width};
use gltf::json::validation::{Checked, USize64};
use gltf::json::{Index, Root, buffer};

/// What a file may have of accessors without numbers of their own, which mean zeros, in bytes.
const MOST_ZEROS: u64 = 1 << 24;

/// A .glb file.
pub struct Glb {
    /// What there is.
    pub document: gltf::Document,
    /// The numbers.
    blob: Vec<u8>,
}

/// Takes a number off the front of some bytes.
fn word(bytes: &mut &[u8]) -> Option<u32> {
    let (first, rest) = bytes.split_first_chunk()?;
    *bytes = rest;
    Some(u32::from_le_bytes(*first))
}

/// Takes a chunk off the front of some bytes: what kind it is of, and what is in it.
fn chunk<'a>(bytes: &mut &'a [u8]) -> Result<(u32, &'a [u8]), String> {
    let cut = || "ends in the middle of a chunk".to_string();
    let length = word(bytes).ok_or_else(cut)? as usize;
    let kind = word(bytes).ok_or_else(cut)?;
    let (chunk, rest) = bytes.split_at_checked(length).ok_or_else(cut)?;
    *bytes = rest;
    Ok((kind, chunk))
}

/// The description and the numbers, as bytes.
fn chunks(bytes: &[u8]) -> Result<(&[u8], &[u8]), String> {
    const JSON: u32 = u32::from_le_bytes(*b"JSON");
    const BIN: u32 = u32::from_le_bytes(*b"BIN\0");
    let mut rest = bytes.strip_prefix(b"glTF").ok_or("is no .glb file")?;
    let (version, length) = word(&mut rest)
        .zip(word(&mut rest))
        .ok_or("has no header")?;
    if version != 2 {
        return Err(format!("is of version {version} of the format; 2 is read"));
    }
    if length as usize != bytes.len() {
        let found = bytes.len();
        return Err(format!("has {found} bytes, and by its header {length}"));
    }
    let (JSON, json) = chunk(&mut rest)? else {
        return Err("does not begin with its description".into());
    };
    // Chunks of other kinds may come behind these two, says the format.
    let (BIN, blob) = chunk(&mut rest).map_err(|_| "has no binary chunk")? else {
        return Err("has no binary chunk".into());
    };
    Ok((json, blob))
}

impl Glb {
    /// Opens a file.
    ///
    /// # Errors
    /// The bytes are no .glb, or name what is not there.
    pub fn open(bytes: &[u8]) -> Result<Glb, String> {
        let (json, blob) = chunks(bytes)?;
        let mut blob = blob.to_vec();
        let mut root = Root::from_slice(json).map_err(|error| error.to_string())?;
        check_attributes(&root)?;
        check_channels(&root)?;
        check_buffers(&root)?;
        give_zeros(&mut root, &mut blob)?;
        let document = gltf::Document::from_json(root).map_err(|error| error.to_string())?;
        Ok(Glb { document, blob })
    }

    /// Its numbers.
    pub fn numbers(&self) -> Numbers<'_> {
        Numbers { blob: &self.blob }
    }
}

/// What the crate's own checks take for granted: that the accessors exist which primitives name.
fn check_attributes(root: &Root) -> Result<(), String> {
    for primitive in root.meshes.iter().flat_map(|mesh| &mesh.primitives) {
        let mut named = primitive.attributes.values().chain(&primitive.indices);
        if let Some(index) = named.find(|index| index.value() >= root.accessors.len()) {
            return Err(format!("accessor {} does not exist", index.value()));
        }
    }
    Ok(())
}

/// And that what channels move is known.
fn check_channels(root: &Root) -> Result<(), String> {
    let mut channels = root.animations.iter().flat_map(|clip| &clip.channels);
    match channels.find(|channel| matches!(channel.target.path, Checked::Invalid)) {
        Some(_) => Err("an animation moves what is not known".into()),
        None => Ok(()),
    }
}

/// All numbers are in the file itself.
fn check_buffers(root: &Root) -> Result<(), String> {
    match root.buffers.as_slice() {
        [buffer] if buffer.uri.is_none() => Ok(()),
        [] => Err("has no buffer".into()),
        _ => Err("has numbers in other files, which are not read".into()),
    }
}

/// Lets accessors without numbers, which mean zeros and which the crate refuses, read zeros behind those of the file.
fn give_zeros(root: &mut Root, blob: &mut Vec<u8>) -> Result<(), String> {
    let (view, mut most) = (Index::new(root.buffer_views.len() as u32), 0);
    for (i, accessor) in root.accessors.iter_mut().enumerate() {
        if accessor.buffer_view.is_some() || accessor.sparse.is_some() {
            continue;
        }
        // What it is without kind or shape, the crate says.
        let (Checked::Valid(kind), Checked::Valid(shape)) =
            (accessor.component_type, accessor.type_)
        else {
            continue;
        };
        let size = (parts(shape) * width(kind.0)) as u64;
        let Some(bytes) = size
            .checked_mul(accessor.count.0)
            .filter(|&bytes| bytes <= MOST_ZEROS)
        else {
            return Err(format!("accessor {i} is without numbers, and too long"));
        };
        accessor.buffer_view = Some(view);
        accessor.byte_offset = None;
        most = most.max(bytes);
    }
    if most > 0 {
        root.buffer_views.push(buffer::View {
            buffer: Index::new(0),
            byte_length: USize64(most),
            byte_offset: Some(USize64(blob.len() as u64)),
            byte_stride: None,
            name: None,
            target: None,
            extensions: None,
            extras: None,
        });
        blob.resize(blob.len() + most as usize, 0);
    }
    Ok(())
}
