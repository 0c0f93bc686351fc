//! Paths: the result document, the independent verifier, and the judge of paths of any origin.

mod judge;
mod result;
mod verify;

pub use crate::shortening::{Blending, Improvement, LONGEST_TURN, Wanted, blend_saving, length, split};
pub use judge::{
    Blocked, FirstContact, JudgeOptions, Judgement, MAX_WAYPOINTS, MOST_TURNS, PathClearance, PathPlace, Turn,
    TurnFault, Turns, judge,
};
pub use result::{Approximate, LengthMeasure, PathCost, ResultDocument};
pub(crate) use verify::verify_path;
pub use verify::{Leg, Verdict, verify, verify_legs};
