//! The scenario: world, robot and queries, as one checked value.
//!
//! It is read from a document ([`Scenario::parse`]) or generated from a seed ([`generate`]), and written in one normal form. A
//! query has a goal or, for an arm, a target. Planners that grow by controls need its `goal_tolerance`, and end in that region.

pub(crate) mod document;
mod frame;
pub mod generate;
pub(crate) mod number;
pub(crate) mod obstacle;
#[cfg(feature = "schema")]
mod schema;
mod types;
pub(crate) mod validate;

pub use crate::json::{MAX_DEPTH, MAX_TEXT};
pub use crate::robot::LARGEST;
pub use frame::{MapFrame, MapPlane};
pub use obstacle::{Obstacle, polygon};
#[cfg(feature = "schema")]
pub use schema::schema;
#[cfg(feature = "schema")]
pub(crate) use schema::schema_of;
pub use types::{Goal, GoalTolerance, Query, Robot, Scenario, World};
pub(crate) use types::{Parts, find_query};

/// The `format` of a scenario.
pub const FORMAT: &str = "planarium-scenario-1";

/// The most obstacles that a scenario may have.
pub const MAX_OBSTACLES: usize = 100_000;

/// The most vertices that the polygons, holes and walls of a scenario may have together, as written.
pub const MAX_VERTICES: usize = 1_000_000;
