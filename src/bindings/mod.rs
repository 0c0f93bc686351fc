//! The classes and functions that JavaScript sees, thin over [`crate::run`] and [`crate::inspect`]. The package wraps them once
//! more in JavaScript, where use before `init` and after `free` can be caught.
//!
//! Documents cross as JSON text. Every count comes in as a JavaScript number and is checked; every error is an `Error` with
//! `code` and `pointer`.

mod convert;
mod drive;
mod neighbours;
mod planner;
mod reach;
mod scenario;
mod trajectories;

pub use drive::RawDrive;
pub use neighbours::RawNeighbours;
pub use planner::RawPlanner;
pub use reach::RawReach;
pub use scenario::RawScenario;
pub use trajectories::{RawTrajectories, particle_points, trajectory_options};

use wasm_bindgen::prelude::*;

/// Every planner with its parameters, as JSON text.
#[wasm_bindgen]
pub fn planners() -> String {
    crate::planner::catalogue().to_json()
}

/// Every index of configurations with its parameters, as JSON text.
#[wasm_bindgen]
pub fn neighbour_indexes() -> String {
    crate::neighbours::catalogue().to_json()
}

/// Every generator with its options, as JSON text.
#[wasm_bindgen]
pub fn generators() -> String {
    crate::scenario::generate::catalogue().to_json()
}

/// Every method of inverse kinematics with its parameters, as JSON text.
#[wasm_bindgen]
pub fn reach_methods() -> String {
    crate::reach::catalogue().to_json()
}
