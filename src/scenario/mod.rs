//! The scenario: world, robot and queries, as one checked value.

mod types;

pub use types::{Obstacle, Query, Robot, Scenario, World};
