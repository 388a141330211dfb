//! Pictures as files.

use crate::cli::files::{FileError, write_atomic};
use std::path::Path;

/// Writes a picture as PNG: RGB bytes, rows from the top down.
///
/// # Errors
/// The file cannot be written.
///
/// # Panics
/// The bytes are not `width * height * 3`.
pub fn write_png(path: &Path, (width, height): (u32, u32), rgb: &[u8]) -> Result<(), FileError> {
    assert_eq!(
        rgb.len(),
        width as usize * height as usize * 3,
        "{width}x{height}"
    );
    let encoded = encode(width, height, rgb).map_err(|e| FileError::new(path, e.to_string()))?;
    write_atomic(path, &encoded)
}

fn encode(width: u32, height: u32, rgb: &[u8]) -> Result<Vec<u8>, png::EncodingError> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.write_header()?.write_image_data(rgb)?;
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_reads_back() {
        let rgb: Vec<u8> = (0..4 * 3 * 3).collect();
        let bytes = encode(4, 3, &rgb).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
            .read_info()
            .unwrap();
        let mut back = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut back).unwrap();
        assert_eq!((reader.info().size(), back), ((4, 3), rgb));
    }
}
