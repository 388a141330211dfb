//! One body in the mesh: a hybrid automaton with a discrete place and closed-form pieces.
//!
//! A body is in the air, on a surface (walking, or sliding along what is too steep) or wedged at a vertex. Its *place*, a
//! face or an edge of the mesh, is the truth about where it is; its position is derived. In every mode the acceleration is
//! constant until an event, so that the motion is a parabola or a quadratic along an edge, and the time of the next event
//! is a root in closed form. A piece keeps its base until a real event. Neither the end of a tick nor the crossing of
//! a free edge is one, and so results depend neither on the tick rate nor on how free space is triangulated.
//!
//! In reading order: [`terrain`] and [`mover`] (in what?), [`roots`] (when?), [`track`] (along what?), [`vertex`] (what
//! next?), [`law`] and [`footing`] (how fast?), [`body`] (the state), `spawn`, [`event`] (what happens to it), `step` (the
//! sequence of events) with `air`, `corner`, `surface`, `joint`, `curve`, `held`, `snap`, `stair`, `one_way`, `region`, `ladder`,
//! `mount` and `size`; [`rise`] (of a jump); [`wall`], [`grip`], [`ledge`] and `correct` (at walls); `change` (what holds a body no
//! longer); `beside` (the places in all other frames), `paths`, `ride`, `contact`, `push` and `at_once` (what moving solids do); [`Anchor`] (edits under a body), `opening` (when is a
//! place free?), [`check`] (the invariants), [`vet`] (what comes from outside).
//!
//! What is absent: swimming, and solids that rotate. Bodies do not meet each other.

mod air;
mod at_once;
mod beside;
pub mod body;
mod change;
pub mod check;
mod contact;
mod corner;
mod correct;
mod curve;
mod edit;
pub mod event;
pub mod footing;
pub mod grip;
mod held;
mod joint;
mod ladder;
pub mod law;
pub mod ledge;
pub mod mount;
pub mod mover;
mod one_way;
mod opening;
mod paths;
mod push;
mod region;
mod ride;
pub mod rise;
pub mod roots;
mod size;
mod snap;
mod spawn;
mod stair;
mod step;
mod surface;
pub mod terrain;
pub mod track;
pub mod vertex;
mod vet;
pub mod wall;

pub use body::{Body, Control, Event, EventKind, Mode, Size, SpawnError, Trace};
pub use edit::Anchor;
pub use event::Way;
pub use grip::Grip;
pub use mover::{Mover, Path, Piece};
pub use opening::Spot;
pub use terrain::{Concave, Ground, Region, Terrain, Traits};
pub use vet::vet;
