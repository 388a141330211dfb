//! What players set to their liking, and what they have reached: plain values, and the files that keep them.
//!
//! In reading order: [`values`] (every setting, one line each), [`bindings`] (keys and buttons), [`progress`] (runs and
//! records), `merge` (those of several games at once), [`fields`] (text read so that one bad value spoils no other),
//! [`saver`] (files written aside), `lock` (by one game at a time), [`store`] (the files).

pub mod bindings;
mod fields;
mod lock;
mod merge;
pub mod progress;
pub mod saver;
pub mod store;
pub mod values;

pub use bindings::{Bindings, Deed};
pub use progress::Progress;
pub use store::Store;
pub use values::{Access, Audio, FrameCap, Hands, Hold, Settings, Size, Video};
