//! The numbers of a .glb file: its binary chunk, read by what the accessors say, with every bound checked.

use gltf::accessor::{DataType, Dimensions};
use gltf::{Accessor, Semantic};

/// Reads numbers out of a file's binary chunk.
#[derive(Clone, Copy)]
pub struct Numbers<'a> {
    /// The binary chunk.
    pub(super) blob: &'a [u8],
}

/// How many bytes one number has.
pub(super) fn width(kind: DataType) -> usize {
    match kind {
        DataType::I8 | DataType::U8 => 1,
        DataType::I16 | DataType::U16 => 2,
        DataType::U32 | DataType::F32 => 4,
    }
}

/// How many numbers one element has.
pub(super) fn parts(shape: Dimensions) -> usize {
    match shape {
        Dimensions::Scalar => 1,
        Dimensions::Vec2 => 2,
        Dimensions::Vec3 => 3,
        Dimensions::Vec4 | Dimensions::Mat2 => 4,
        Dimensions::Mat3 => 9,
        Dimensions::Mat4 => 16,
    }
}

/// One number; those of a normalized accessor are shares of the largest.
fn number(kind: DataType, bytes: &[u8], normalized: bool) -> f32 {
    let whole = |value: f32, largest: f32| match normalized {
        true => (value / largest).max(-1.0),
        false => value,
    };
    match (kind, bytes) {
        (DataType::U8, &[a]) => whole(f32::from(a), 255.0),
        (DataType::I8, &[a]) => whole(f32::from(a as i8), 127.0),
        (DataType::U16, &[a, b]) => whole(f32::from(u16::from_le_bytes([a, b])), 65535.0),
        (DataType::I16, &[a, b]) => whole(f32::from(i16::from_le_bytes([a, b])), 32767.0),
        (DataType::U32, &[a, b, c, d]) => u32::from_le_bytes([a, b, c, d]) as f32,
        (DataType::F32, &[a, b, c, d]) => f32::from_le_bytes([a, b, c, d]),
        _ => f32::NAN, // no element has such a width
    }
}

impl<'a> Numbers<'a> {
    /// The elements of an accessor as bytes, each exactly as long as it should be.
    fn elements(
        self,
        accessor: &Accessor,
    ) -> Result<impl Iterator<Item = &'a [u8]> + use<'a>, String> {
        if accessor.sparse().is_some() {
            return Err("sparse accessors are not read".into());
        }
        let view = accessor.view().ok_or("an accessor has no buffer view")?;
        let size = parts(accessor.dimensions()) * width(accessor.data_type());
        let stride = view.stride().unwrap_or(size);
        if stride < size {
            return Err("the elements of a buffer view overlap".into());
        }
        let start = view.offset().checked_add(accessor.offset());
        let length = accessor.count().checked_sub(1).and_then(|last| {
            let way = last.checked_mul(stride)?;
            way.checked_add(size)
        });
        let within = length.and_then(|length| length.checked_add(accessor.offset()));
        if within.is_none_or(|end| end > view.length()) {
            return Err("an accessor is empty or reaches beyond its buffer view".into());
        }
        let end = start
            .zip(length)
            .and_then(|(start, length)| start.checked_add(length));
        let bytes = start
            .zip(end)
            .and_then(|(start, end)| self.blob.get(start..end))
            .ok_or("an accessor is empty or reaches beyond the file's binary chunk")?;
        Ok(bytes.chunks(stride).map(move |chunk| &chunk[..size]))
    }

    /// All elements of an accessor, each of `N` finite numbers.
    ///
    /// # Errors
    /// It has another shape, a number is not finite, or its bytes are not in the file.
    pub fn read<const N: usize>(self, accessor: &Accessor) -> Result<Vec<[f32; N]>, String> {
        let (kind, found) = (accessor.data_type(), parts(accessor.dimensions()));
        if found != N {
            return Err(format!("{found} numbers where {N} are wanted"));
        }
        let mut all = Vec::with_capacity(accessor.count().min(self.blob.len()));
        for bytes in self.elements(accessor)? {
            let mut element = [0.0; N];
            for (value, bytes) in element.iter_mut().zip(bytes.chunks(width(kind))) {
                *value = number(kind, bytes, accessor.normalized());
            }
            if !element.iter().all(|value: &f32| value.is_finite()) {
                return Err("a number is not finite".into());
            }
            all.push(element);
        }
        Ok(all)
    }

    /// An attribute of a primitive's vertices.
    ///
    /// # Errors
    /// As [`Numbers::read`], or there is no such attribute; both name it.
    pub fn attribute<const N: usize>(
        self,
        primitive: &gltf::Primitive,
        semantic: Semantic,
    ) -> Result<Vec<[f32; N]>, String> {
        let name = semantic.to_string();
        let accessor = primitive
            .get(&semantic)
            .ok_or_else(|| format!("no {name}"))?;
        self.read(&accessor).map_err(|why| format!("{name}: {why}"))
    }

    /// The colours of a primitive's vertices, linear red, green and blue: floats, or bytes or shorts that are shares of the
    /// largest, with or without an opacity, which is not used.
    ///
    /// # Errors
    /// There are none, or of another kind.
    pub fn colours(self, primitive: &gltf::Primitive) -> Result<Vec<[f32; 3]>, String> {
        let semantic = Semantic::Colors(0);
        if let Some(accessor) = primitive.get(&semantic) {
            let kind = accessor.data_type();
            let shares = matches!(kind, DataType::U8 | DataType::U16) && accessor.normalized();
            if kind != DataType::F32 && !shares {
                let why = "floats are read, and bytes and shorts that are normalized";
                let name = semantic.to_string();
                return Err(format!("{name}: {why}, not {kind:?}"));
            }
            if accessor.dimensions() == Dimensions::Vec4 {
                let all: Vec<[f32; 4]> = self.attribute(primitive, semantic)?;
                return Ok(all.into_iter().map(|[r, g, b, _]| [r, g, b]).collect());
            }
        }
        self.attribute(primitive, semantic)
    }

    /// The corners of a primitive's triangles, as indices of its vertices.
    ///
    /// # Errors
    /// It is not made of triangles, or names vertices that it does not have.
    pub fn corners(
        self,
        primitive: &gltf::Primitive,
        vertices: usize,
    ) -> Result<Vec<usize>, String> {
        if primitive.mode() != gltf::mesh::Mode::Triangles {
            return Err("is not made of triangles".into());
        }
        let corners: Vec<usize> = match primitive.indices() {
            None => (0..vertices).collect(),
            // Exact up to 2^24, far more vertices than a figure has.
            Some(accessor) => {
                let indices: Vec<[f32; 1]> = self.read(&accessor)?;
                indices.into_iter().map(|[index]| index as usize).collect()
            }
        };
        match corners.iter().all(|&i| i < vertices) && corners.len().is_multiple_of(3) {
            true => Ok(corners),
            false => Err("its indices do not make triangles of its vertices".into()),
        }
    }
}
