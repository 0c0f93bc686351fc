//! Robots: kinematics, footprint, bound on motion, and configuration space. One file per robot.
//!
//! A robot knows its own shape and bounds on the travel of its parts; it knows no obstacle and no planner.

mod arm;
mod body;
mod car;
mod cargo;
mod differential_drive;
mod disc;
mod range;
mod space;

pub(crate) use arm::link_name;
pub use arm::{Arm, Joint, MAX_LINKS, Target};
pub use body::{RigidBody, Weights};
pub use car::Car;
pub use cargo::{Cargo, CargoLimits, CargoState, GRAVITY};
pub use differential_drive::{DifferentialDrive, Footprint, Round};
pub use disc::DiscRobot;
pub use range::LARGEST;
pub(crate) use range::check_range;
pub use space::{joint_space, placements, plane};

use crate::geometry::Point;
use serde::Serialize;

/// One part of a robot, placed in the workspace; lengths in metres.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum Part {
    /// All points within `radius` of the segment from `a` to `b`; a segment if the radius is 0.
    Capsule {
        /// The first end of the axis.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
        a: Point,
        /// The second end of the axis.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
        b: Point,
        /// Half the width, at least 0.
        radius: f64,
    },
    /// A disc; a point if the radius is 0.
    Disc {
        /// The centre.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Point"))]
        center: Point,
        /// The radius, at least 0.
        radius: f64,
    },
    /// A simple polygon, filled.
    Polygon {
        /// The corners, counter-clockwise.
        #[cfg_attr(target_arch = "wasm32", tsify(type = "Point[]"))]
        vertices: Vec<Point>,
    },
}
