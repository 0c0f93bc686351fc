//! Paths: what to do with one once it has been found.

mod verify;

pub use verify::{Verdict, verify};
