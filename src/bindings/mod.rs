//! The classes and functions that JavaScript sees, thin over [`crate::run`] and [`crate::run::inspect`]. The package wraps them
//! once more in JavaScript, where use before `init` and after `free` can be caught.
//!
//! Scenarios and roadmaps come in as JSON text, options and records cross as plain objects, tables as typed arrays, which are
//! copies and stay valid. Every count comes in as a JavaScript number and is checked; every error is an `Error` with `code` and
//! `pointer`.

/// Declares methods of a class without arguments, each by the value that it returns.
macro_rules! getters {
    ($Class:ident($self:ident) $( $(#[doc = $doc:literal])? $name:ident: $Type:ty = $value:expr; )*) => {
        #[wasm_bindgen]
        impl $Class {
            $( $(#[doc = $doc])? pub fn $name(&$self) -> $Type { $value } )*
        }
    };
}

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
pub use trajectories::{RawTrajectories, particle_points};

use crate::Error;
use wasm_bindgen::prelude::*;

/// A fresh seed.
#[wasm_bindgen]
pub fn random_seed() -> Result<f64, Error> {
    crate::random::random_seed().map(|seed| seed as f64)
}
