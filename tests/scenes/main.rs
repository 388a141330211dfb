//! The hard cases: scenes with exact expectations, each also mirrored and shifted. Numbers in the names are those of the
//! list of hard cases; conventions: y up, gravity 30, solids counter-clockwise, P a point, B a box of half-size
//! (13/32, 29/32) whose reference point is the middle of its foot.

mod belts;
mod braking;
mod build;
mod bumps;
mod degenerate;
mod edits;
mod found;
mod ground;
mod jumps;
mod ladder_ends;
mod ladders;
mod ledges;
mod lips;
mod low_ledges;
mod movers;
mod moving;
mod moving_ladders;
mod moving_one_ways;
mod moving_regions;
mod moving_walls;
mod one_ways;
mod regions;
mod rides;
mod rig;
mod slopes;
mod squeezes;
mod stairs;
mod starts;
mod stress;
mod swept;
mod timing;
mod valves;
mod walls;

#[path = "../common/worlds.rs"]
mod worlds;
