//! Music in layers: the files of a piece are decoded side by side, sample for sample, while they are played.
//!
//! A [`Feeder`] decodes ahead into a ring, on a thread of its own or when it is told to; what plays only takes out of it. At
//! the end all layers begin anew together. A layer that is missing or broken is silent.

use super::decode::{RATE, Reader};
use crate::cli::files::{self, FileError};
use crate::sound::{Layer, Piece};
use kira::Frame;
use kira::info::Info;
use kira::sound::{Sound, SoundData};
use rtrb::{Consumer, Producer, RingBuffer};
use std::collections::VecDeque;
use std::convert::Infallible;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::Sender;
use std::time::Duration;

/// Where music is.
pub const MUSIC: &str = "assets/music";
const LAYERS: usize = Layer::ALL.len();
/// Samples that are decoded ahead: one second.
const AHEAD: usize = RATE as usize;
/// How often the thread looks whether there is room.
const NAP: Duration = Duration::from_millis(80);
/// Samples that are left when what plays begins to fade, so that nothing clicks if the thread comes too late.
const LOW: usize = 2048;
/// Seconds in which layers, and the whole, come most of the way to another amplitude; and in which a dry ring fades.
const LAYER_FADE: f32 = 0.9;
const WHOLE_FADE: f32 = 0.5;
const DRY_FADE: f32 = 0.008;
/// What is softer is not played but waits where it is.
const SILENCE: f32 = 1e-4;

/// One moment of all layers.
type Moment = [Frame; LAYERS];

/// Decodes a piece ahead.
pub struct Feeder {
    readers: [Option<Reader>; LAYERS],
    decoded: [VecDeque<Frame>; LAYERS],
    packet: Vec<Frame>,
    ring: Producer<Moment>,
    problems: Sender<FileError>,
}

/// A piece that can be played.
pub struct Stems {
    ring: Consumer<Moment>,
}

/// A piece from the game's own folder, and what feeds it.
pub fn open(piece: Piece, problems: &Sender<FileError>) -> (Feeder, Stems) {
    let folder = files::find(Path::new(MUSIC));
    open_files(
        Layer::ALL.map(|layer| folder.join(piece.file(layer))),
        problems,
    )
}

/// The same from any files.
pub fn open_files(paths: [PathBuf; LAYERS], problems: &Sender<FileError>) -> (Feeder, Stems) {
    let (producer, consumer) = RingBuffer::new(AHEAD);
    let tell = |error| drop(problems.send(error)); // nobody may be listening
    let feeder = Feeder {
        readers: paths.map(|path| Reader::open_loop(&path).map_err(tell).ok()),
        decoded: Default::default(),
        packet: Vec::new(),
        ring: producer,
        problems: problems.clone(),
    };
    (feeder, Stems { ring: consumer })
}

impl Feeder {
    /// Feeds until nobody listens any more.
    pub fn run(mut self) {
        while !self.ring.is_abandoned() {
            self.fill();
            std::thread::sleep(NAP);
        }
    }

    /// Fills the ring.
    pub fn fill(&mut self) {
        while self.ring.slots() > 0 && self.readers.iter().any(Option::is_some) {
            let has_more = (0..LAYERS).all(|layer| self.decode(layer));
            if !has_more {
                self.begin_anew();
                continue;
            }
            let ready = |layer: usize| match self.readers[layer] {
                Some(_) => self.decoded[layer].len(),
                None => usize::MAX,
            };
            let count = (0..LAYERS).map(ready).min().unwrap_or(0);
            for _ in 0..count.min(self.ring.slots()) {
                let decoded = &mut self.decoded;
                let moment = decoded
                    .each_mut()
                    .map(|layer| layer.pop_front().unwrap_or_default());
                let _ = self.ring.push(moment); // there is room
            }
        }
    }

    /// Sees to it that a layer has something decoded; `false` at its end.
    fn decode(&mut self, layer: usize) -> bool {
        while self.decoded[layer].is_empty() {
            let Some(reader) = &mut self.readers[layer] else {
                return true;
            };
            self.packet.clear();
            match reader.read(&mut self.packet) {
                Ok(has_more) => {
                    self.decoded[layer].extend(&self.packet);
                    if !has_more {
                        return !self.decoded[layer].is_empty();
                    }
                }
                Err(error) => self.silence(layer, error),
            }
        }
        true
    }

    /// All layers from their beginning.
    fn begin_anew(&mut self) {
        for layer in 0..LAYERS {
            self.decoded[layer].clear();
            let rewound = self.readers[layer].as_mut().map(Reader::rewind);
            if let Some(Err(error)) = rewound {
                self.silence(layer, error);
            }
        }
    }

    fn silence(&mut self, layer: usize, error: FileError) {
        self.readers[layer] = None;
        drop(self.problems.send(error)); // nobody may be listening
    }
}

/// Where a piece is told how loud it shall be.
#[derive(Debug, Default)]
pub struct Faders {
    layers: [AtomicU32; LAYERS],
    whole: AtomicU32,
}

impl Faders {
    /// Sets the amplitudes that layers and whole shall come to.
    pub fn set(&self, layers: [f32; LAYERS], whole: f32) {
        for (word, value) in self.layers.iter().zip(layers) {
            word.store(value.to_bits(), Ordering::Relaxed);
        }
        self.whole.store(whole.to_bits(), Ordering::Relaxed);
    }
}

struct Playing {
    ring: Consumer<Moment>,
    faders: Arc<Faders>,
    layers: [f32; LAYERS],
    whole: f32,
    flow: f32,
}

impl SoundData for Stems {
    type Error = Infallible;
    type Handle = Arc<Faders>;

    fn into_sound(self) -> Result<(Box<dyn Sound>, Arc<Faders>), Infallible> {
        let faders = Arc::new(Faders::default());
        let playing = Playing {
            ring: self.ring,
            faders: faders.clone(),
            layers: [0.0; LAYERS],
            whole: 0.0,
            flow: 0.0,
        };
        Ok((Box::new(playing), faders))
    }
}

impl Sound for Playing {
    fn process(&mut self, out: &mut [Frame], dt: f64, _: &Info) {
        let value = |word: &AtomicU32| f32::from_bits(word.load(Ordering::Relaxed));
        let wanted = self.faders.layers.each_ref().map(value);
        let whole = value(&self.faders.whole);
        if whole < SILENCE && self.whole < SILENCE {
            return out.fill(Frame::ZERO);
        }
        let share = |time: f32| 1.0 - (-(dt as f32) / time).exp();
        let (layer_share, whole_share, flow_share) =
            (share(LAYER_FADE), share(WHOLE_FADE), share(DRY_FADE));
        let flows = if self.ring.slots() > LOW { 1.0 } else { 0.0 };
        for frame in out {
            let moment = self.ring.pop().unwrap_or_default();
            self.whole += (whole - self.whole) * whole_share;
            self.flow += (flows - self.flow) * flow_share;
            let mut sum = Frame::ZERO;
            for ((gain, wanted), layer) in self.layers.iter_mut().zip(wanted).zip(moment) {
                *gain += (wanted - *gain) * layer_share;
                sum += layer * *gain;
            }
            *frame = sum * (self.whole * self.flow);
        }
    }

    fn finished(&self) -> bool {
        false
    }
}
