//! Is a configuration free, which part touches what, is a motion free: the proof.
//!
//! Obstacles are closed and filled: contact is collision. Bounds are closed: contact with them is allowed.
//!
//! **Slack.** Every clearance is compared with `eta` = 1e-12 times the largest coordinate plus the reach. It covers the
//! rounding of kinematics, midpoints, distances and bounds, below it in all (see `proof/separation.rs` for arms,
//! `proof/body_separation.rs` for bodies). Nothing is
//! promised about features smaller than `eta`; but for points, a configuration with clearance up to `eta` is in collision.
//!
//! **Tolerance.** A stretch that is still unproven when its bound on motion is below `tau` counts as hit: see
//! [`Tolerance`]. So accepted means free along all of it; refused without a collision are only motions that come within
//! `tau` of an obstacle or of the bounds, and those whose short way round is ambiguous.

mod arm;
mod body;
mod body_validity;
mod boxes;
mod disc;
mod driving;
mod motion;
mod obstacles;
mod proof;
mod sampled;
mod tolerance;

pub use arm::{ArmValidity, joint_space};
pub use body::BodyCollision;
pub use body_validity::{BodyValidity, placements};
pub use disc::{DiscValidity, plane};
pub use driving::{Driving, Integration};
pub use motion::{BodyMotion, LONGEST_DRIVE, LONGEST_TURN};
pub use obstacles::Obstacles;
pub use sampled::Sampled;
pub use tolerance::Tolerance;
