//! Motion planning that a person can watch.
#![deny(missing_docs)]
#![deny(unsafe_code)]

#[cfg(target_arch = "wasm32")]
#[allow(missing_docs, unsafe_code)]
pub mod bindings;
pub mod collision;
pub mod error;
pub mod geometry;
pub mod graph;
pub mod inspect;
pub mod nearest;
pub mod path;
pub mod planner;
pub mod problem;
pub mod random;
pub mod result;
pub mod robot;
pub mod run;
pub mod scenario;
pub mod space;
pub mod stats;
pub mod status;
pub mod validity;

pub use error::Error;
