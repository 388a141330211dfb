//! The mesh: predicates, edits, queries and random worlds, against slow twins.

#[path = "../common/mod.rs"]
mod common;

mod crossings;
mod edits;
mod exact;
mod hard_cases;
mod kinds;
mod one_way;
mod queries;
mod scale;
mod soups;
mod surfaces;
mod worlds;
