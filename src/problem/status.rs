//! Where a run stands.

use serde::{Deserialize, Serialize};
use strum::IntoStaticStr;

/// Where a run stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[strum(serialize_all = "kebab-case")]
pub enum Status {
    /// More iterations may help.
    Running,
    /// A path was found.
    Solved,
    /// The budget of iterations, samples or memory (`graph::MAX_RECORDS`) is spent without a path.
    Exhausted,
}

impl Status {
    /// The status as it is printed: `running`, `solved` or `exhausted`.
    pub fn as_str(self) -> &'static str {
        self.into()
    }
}
