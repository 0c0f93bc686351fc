//! The clock of commands that step: slices of iterations, and progress bars.

use indicatif::ProgressDrawTarget;
use std::io::{IsTerminal, stderr};
use std::time::Duration;

/// The target duration of a slice of iterations: short compared with the time limit.
const SLICE: Duration = Duration::from_micros(500);

/// The most iterations of a slice: few compared with the phases of a planner, enough to make the cost of the clock negligible.
const MOST: u64 = 16;

/// The time between two updates of the progress bar.
pub const REDRAW: Duration = Duration::from_millis(100);

/// The iterations of the next slice, after this many took this long.
pub fn next_slice(iterations: u64, took: Duration) -> u64 {
    let longer = if took * 2 <= SLICE { iterations * 2 } else { iterations };
    let fitting = if took > SLICE { iterations / 2 } else { longer };
    fitting.clamp(1, MOST)
}

/// Standard error, if that is a terminal.
pub fn progress_target() -> ProgressDrawTarget {
    if stderr().is_terminal() { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() }
}
