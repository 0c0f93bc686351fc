//! Robots: kinematics, footprint, bound on motion, and configuration space. One file per robot.
//!
//! A robot knows its own shape and bounds on the travel of its parts; it knows no obstacle and no planner.

mod arm;
mod body;
mod car;
mod disc;
mod footprint;
mod range;
mod space;

pub use arm::{Arm, MAX_LINKS, Target};
pub use body::{RigidBody, Weights};
pub use car::Car;
pub use disc::DiscRobot;
pub use footprint::Part;
pub use range::LARGEST;
pub(crate) use range::check_range;
pub use space::{joint_space, placements, plane};
