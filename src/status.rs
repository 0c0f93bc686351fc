//! Where a run stands.

/// Where a run stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    /// More iterations may help.
    Running,
    /// A path was found.
    Solved,
    /// The budget of iterations or samples is spent without a path.
    Exhausted,
}

impl Status {
    /// The status as it is printed: `running`, `solved` or `exhausted`.
    pub fn as_str(self) -> &'static str {
        match self {
            Status::Running => "running",
            Status::Solved => "solved",
            Status::Exhausted => "exhausted",
        }
    }
}
