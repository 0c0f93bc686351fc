//! How far a run has come.

use serde::{Deserialize, Serialize};

/// How far a run has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// There is more to do.
    Running,
    /// A path has been found.
    Solved,
    /// The budget is spent and no path has been found.
    Exhausted,
}

impl Status {
    /// The status as it stands in results: `running`, `solved` or `exhausted`.
    pub fn as_str(self) -> &'static str {
        match self {
            Status::Running => "running",
            Status::Solved => "solved",
            Status::Exhausted => "exhausted",
        }
    }
}
