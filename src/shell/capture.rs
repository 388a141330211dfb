//! Pictures as files.

use crate::cli::files::{FileError, write_atomic};
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

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

/// Pictures one after the other in one file, as PPM: what ffmpeg reads from a pipe.
#[derive(Debug)]
pub struct Reel {
    path: PathBuf,
    file: BufWriter<File>,
}

impl Reel {
    /// Begins a file. If it is a pipe, that waits for its reader.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn open(path: &Path) -> Result<Reel, FileError> {
        let file = File::create(path).map_err(|e| FileError::new(path, e.to_string()))?;
        Ok(Reel {
            path: path.to_path_buf(),
            file: BufWriter::new(file),
        })
    }

    /// Adds a picture: RGB bytes, rows from the top down.
    ///
    /// # Errors
    /// The disk is full, or the reader of the pipe is gone.
    pub fn push(&mut self, size: (u32, u32), rgb: &[u8]) -> Result<(), FileError> {
        let written = write_ppm(&mut self.file, size, rgb);
        self.told(written)
    }

    /// Ends the file.
    ///
    /// # Errors
    /// As [`push`](Self::push).
    pub fn close(mut self) -> Result<(), FileError> {
        let written = self.file.flush();
        self.told(written)
    }

    fn told(&self, written: io::Result<()>) -> Result<(), FileError> {
        written.map_err(|e| FileError::new(&self.path, e.to_string()))
    }
}

fn write_ppm(out: &mut impl Write, (width, height): (u32, u32), rgb: &[u8]) -> io::Result<()> {
    write!(out, "P6\n{width} {height}\n255\n")?;
    out.write_all(rgb)
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
    fn a_picture_of_a_film_is_its_size_and_its_bytes() {
        let mut out = Vec::new();
        write_ppm(&mut out, (2, 1), b"rgbRGB").unwrap();
        assert_eq!(out, b"P6\n2 1\n255\nrgbRGB");
    }

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
