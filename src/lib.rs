//! Motion planning that a person can watch.
#![deny(missing_docs)]
#![deny(unsafe_code)]

pub mod collision;
pub mod error;
pub mod geometry;
pub mod graph;
pub mod nearest;
pub mod problem;
pub mod random;
pub mod robot;
pub mod scenario;
pub mod space;
pub mod validity;

pub use error::Error;
