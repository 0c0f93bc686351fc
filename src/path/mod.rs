//! Paths: the result document, and the independent verifier.

mod result;
mod verify;

pub use crate::shortening::{Blending, Improvement, LONGEST_TURN, Wanted, blend_saving, length, split};
pub use result::{Approximate, LengthMeasure, ResultDocument};
pub(crate) use verify::verify_path;
pub use verify::{Leg, Verdict, verify, verify_legs};
