//! Searches as walkers: a search holds its own marks and is handed the graph at every step, so that it can be paused and
//! watched. Searches know no space: costs and heuristics are given.

mod a_star;

pub use a_star::{AStar, Expansion};
