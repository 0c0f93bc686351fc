//! Collision checking: configurations, contacts, and the proof that a motion is free.
//!
//! Motions of arms and bodies are proven in `proof/`, called from `arm.rs` and `body.rs`; `body_validity.rs` splits the curve of
//! a car into arcs, `car_dynamics.rs` proves controlled motions arc by arc, and `disc.rs` has an exact test of its own.
//!
//! A rounded corner of a path is proven in bands, each a straight motion of a robot that is grown for it: `blend.rs`.
//!
//! Obstacles are closed and filled: contact is collision. Bounds are closed: contact with them is allowed.
//!
//! **Slack.** Every clearance is compared with `eta` = 1e-12 times the largest coordinate plus the reach. It exceeds
//! the total rounding error of kinematics, midpoints, distances and bounds (see `proof/arm.rs` and `proof/body.rs`).
//! Nothing is promised about features smaller than `eta`; except for points, a configuration with clearance up to `eta`
//! is in collision.
//!
//! **Tolerance.** An interval that is still unproven when its bound on travel is below `tau` counts as hit: see
//! [`Tolerance`]. An accepted motion is therefore free everywhere. A collision-free motion is refused only if it comes
//! within `tau` of an obstacle or of the bounds, if the shorter direction of its turn is ambiguous, or if its proof would take
//! more evaluations than its budget (see `proof/driver.rs`).

mod arm;
mod blend;
mod body;
mod body_validity;
mod car_dynamics;
mod disc;
mod joint_lines;
mod keep_away;
mod motion;
mod obstacles;
mod proof;
mod tolerance;
mod world;

pub use arm::ArmValidity;
pub use body::BodyCollision;
pub use body_validity::BodyValidity;
pub use car_dynamics::{CarDynamics, Integration};
pub use disc::DiscValidity;
pub use joint_lines::JointLines;
pub(crate) use keep_away::KeepAway;
pub use motion::{BodyMotion, LONGEST_DRIVE, LONGEST_TURN};
pub use obstacles::Obstacles;
pub(crate) use obstacles::largest_coordinate;
pub use tolerance::Tolerance;
pub use world::CollisionWorld;
