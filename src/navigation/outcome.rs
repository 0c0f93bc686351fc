//! How a drive ends.

use serde::Serialize;

/// How a rollout ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Outcome {
    /// The goal is reached.
    Reached,
    /// The next arc is not proven free: the robot would touch something.
    Collision,
    /// The load would be displaced beyond the limit of swing.
    Swing,
    /// The time limit was reached.
    Timeout,
}
