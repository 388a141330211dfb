//! The hard cases: scenes with exact expectations, each also mirrored and shifted. Numbers in the names are those of the
//! list of hard cases; conventions: y up, gravity 30, solids counter-clockwise, P a point, B a box of half-size
//! (13/32, 29/32) whose reference point is the middle of its foot.

mod degenerate;
mod edits;
mod found;
mod ground;
mod ladders;
mod ledges;
mod movers;
mod moving;
mod one_ways;
mod regions;
mod rig;
mod slopes;
mod stairs;
mod stress;
mod swept;
mod timing;
mod walls;

#[path = "../common/worlds.rs"]
mod worlds;
