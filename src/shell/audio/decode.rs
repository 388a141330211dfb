//! Sounds from files: Ogg Vorbis, 48 000 samples a second, one channel or two.

use crate::cli::files::{self, FileError};
use crate::sound::{Layer, Loop, Piece};
use kira::Frame;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use symphonia::core::audio::SampleBuffer;
use symphonia::core::codecs::{CODEC_TYPE_NULL, Decoder, DecoderOptions};
use symphonia::core::errors::Error;
use symphonia::core::formats::{FormatOptions, FormatReader, SeekMode, SeekTo};
use symphonia::core::io::{MediaSourceStream, MediaSourceStreamOptions};
use symphonia::core::meta::MetadataOptions;
use symphonia::core::probe::Hint;

/// Samples a second, of all files and of what is played.
pub const RATE: u32 = 48_000;

/// What files of loops have at both ends beside the loop itself, in samples, so that the codec is well under way where it
/// begins; as `assets/source/sound/synth.py` writes them.
const MARGIN: usize = 4096;
/// Samples over which the end of a loop goes over into its beginning: what the codec lost is not the same in both.
const BLEND: usize = 1024;
/// Samples at either end of a sound that are faded: half a millisecond.
const EDGE: usize = 24;

/// A file that is being decoded, packet by packet.
pub struct Reader {
    path: PathBuf,
    format: Box<dyn FormatReader>,
    decoder: Box<dyn Decoder>,
    samples: Option<SampleBuffer<f32>>,
    track: u32,
    channels: usize,
    /// What is left out at both ends, and how many samples there are between.
    margin: usize,
    length: usize,
    /// How many samples have been decoded since the beginning, margins included.
    decoded: usize,
    /// What has followed the end, this time and the last time.
    beyond: Vec<Frame>,
    tail: Vec<Frame>,
}

impl Reader {
    /// Opens a file and looks at its header.
    ///
    /// # Errors
    /// The file cannot be read, is no Ogg Vorbis, or has another rate or more than two channels.
    pub fn open(path: &Path) -> Result<Reader, FileError> {
        Reader::with_margin(path, 0)
    }

    /// Opens a file of something that loops, without its margins.
    ///
    /// # Errors
    /// As [`Reader::open`].
    pub fn open_loop(path: &Path) -> Result<Reader, FileError> {
        Reader::with_margin(path, MARGIN)
    }

    fn with_margin(path: &Path, margin: usize) -> Result<Reader, FileError> {
        let failed = |reason: String| FileError::new(path, reason);
        let unreadable = |e: Error| failed(format!("no sound that can be played: {e}"));
        let bytes = Cursor::new(files::read(path)?);
        let stream = MediaSourceStream::new(Box::new(bytes), MediaSourceStreamOptions::default());
        let gapless = FormatOptions {
            enable_gapless: true,
            ..FormatOptions::default()
        };
        let format = symphonia::default::get_probe()
            .format(&Hint::new(), stream, &gapless, &MetadataOptions::default())
            .map_err(unreadable)?
            .format;
        let track = format
            .tracks()
            .iter()
            .find(|track| track.codec_params.codec != CODEC_TYPE_NULL)
            .ok_or_else(|| failed("holds no sound".into()))?;
        let params = &track.codec_params;
        let (rate, channels) = (params.sample_rate, params.channels.map_or(0, |c| c.count()));
        if rate != Some(RATE) || !(1..=2).contains(&channels) {
            return Err(failed(format!(
                "has {} channels and {} samples a second: one or two and {RATE} are wanted",
                channels,
                rate.unwrap_or(0)
            )));
        }
        let length = params.n_frames.unwrap_or(0) as usize;
        if length <= 2 * margin {
            return Err(failed(format!("is too short: {length} samples")));
        }
        let decoder = symphonia::default::get_codecs()
            .make(params, &DecoderOptions::default())
            .map_err(unreadable)?;
        Ok(Reader {
            path: path.to_path_buf(),
            track: track.id,
            format,
            decoder,
            samples: None,
            channels,
            margin,
            length: length - 2 * margin,
            decoded: 0,
            beyond: Vec::new(),
            tail: Vec::new(),
        })
    }

    /// Adds the next packet to a list; `false` at the end.
    ///
    /// # Errors
    /// The file is broken here.
    pub fn read(&mut self, into: &mut Vec<Frame>) -> Result<bool, FileError> {
        let broken = |path: &Path, e: Error| FileError::new(path, format!("broken sound: {e}"));
        let packet = match self.format.next_packet() {
            Ok(packet) => packet,
            Err(Error::IoError(e)) if e.kind() == std::io::ErrorKind::UnexpectedEof => {
                return Ok(false);
            }
            Err(e) => return Err(broken(&self.path, e)),
        };
        if packet.track_id() != self.track {
            return Ok(true);
        }
        let decoded = self
            .decoder
            .decode(&packet)
            .map_err(|e| broken(&self.path, e))?;
        let spec = *decoded.spec();
        let room = decoded.capacity() as u64;
        let new = || SampleBuffer::new(room, spec);
        let mut samples = self.samples.take().unwrap_or_else(new);
        samples.copy_interleaved_ref(decoded);
        for channels in samples.samples().chunks_exact(self.channels) {
            let frame = Frame::new(channels[0], channels[self.channels - 1]);
            self.place(frame, into);
        }
        self.samples = Some(samples);
        Ok(self.decoded < self.margin + self.length + self.blend())
    }

    /// Puts the next frame of the file where it belongs: into the list, or to what goes on after the end.
    fn place(&mut self, frame: Frame, into: &mut Vec<Frame>) {
        let index = self.decoded;
        self.decoded += 1;
        let Some(index) = index.checked_sub(self.margin) else {
            return;
        };
        if index >= self.length {
            if index - self.length < self.blend() {
                self.beyond.push(frame);
            }
        } else if let Some(&before) = self.tail.get(index) {
            let share = index as f32 / self.tail.len() as f32;
            into.push(before * (1.0 - share) + frame * share);
        } else {
            into.push(frame);
        }
    }

    /// Samples after the end of a loop that go over into its beginning.
    fn blend(&self) -> usize {
        BLEND.min(self.margin)
    }

    /// Back to the beginning, into which what followed the end goes over.
    ///
    /// # Errors
    /// The file is broken there.
    pub fn rewind(&mut self) -> Result<(), FileError> {
        let start = SeekTo::TimeStamp {
            ts: 0,
            track_id: self.track,
        };
        let sought = self.format.seek(SeekMode::Accurate, start);
        sought.map_err(|e| FileError::new(&self.path, format!("cannot be played again: {e}")))?;
        self.decoder.reset();
        self.decoded = 0;
        self.tail = std::mem::take(&mut self.beyond);
        Ok(())
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// All of a sound that is heard once; its ends are faded, since the codec leaves a little there.
///
/// # Errors
/// As [`Reader::open`] and [`Reader::read`].
pub fn decode(path: &Path) -> Result<Vec<Frame>, FileError> {
    let (mut frames, mut reader) = (Vec::new(), Reader::open(path)?);
    while reader.read(&mut frames)? {}
    let edge = EDGE.min(frames.len() / 2);
    for index in 0..edge {
        let share = index as f32 / edge as f32;
        let last = frames.len() - 1 - index;
        frames[index] *= share;
        frames[last] *= share;
    }
    Ok(frames)
}

/// All of a loop, without its margins.
///
/// # Errors
/// As [`Reader::open`] and [`Reader::read`].
pub fn decode_loop(path: &Path) -> Result<Vec<Frame>, FileError> {
    let mut frames = Vec::new();
    let mut reader = Reader::open_loop(path)?;
    while reader.read(&mut frames)? {}
    // Once more, now that it is known what follows its end.
    reader.rewind()?;
    frames.clear();
    while reader.read(&mut frames)? {}
    Ok(frames)
}

/// All of a file as the game plays it: as a loop if it has the name of one or of a layer of music, else as a sound that is
/// heard once.
///
/// # Errors
/// As [`Reader::open`] and [`Reader::read`].
pub fn decode_as_played(path: &Path) -> Result<Vec<Frame>, FileError> {
    let is_named = |name: &str| path.file_name().is_some_and(|file| file == name);
    let is_layer = |piece: Piece| Layer::ALL.iter().any(|&l| is_named(piece.file(l)));
    let is_loop = Loop::ALL.iter().any(|which| is_named(which.file()));
    match is_loop || Piece::ALL.iter().copied().any(is_layer) {
        true => decode_loop(path),
        false => decode(path),
    }
}
