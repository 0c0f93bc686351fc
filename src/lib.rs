//! Motion planning that a person can watch.
#![deny(missing_docs)]
#![deny(unsafe_code)]

pub mod error;
pub mod geometry;
pub mod robot;
pub mod scenario;

pub use error::Error;
