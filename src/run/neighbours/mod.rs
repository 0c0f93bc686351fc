//! Nearest neighbours among the configurations of a scenario's robot: any index of [`crate::nearest`], in any of the robot's
//! metrics, behind one object-safe trait. For viewers and for measuring; planners hold an index of their own.

mod factory;
mod table;

pub use crate::nearest::{Neighbour, recall};
pub use factory::index;
pub use table::{ForestOptions, IndexInfo, IndexOptions, indexes};

pub use crate::planner::MetricOptions;

use crate::error::Error;

/// The most configurations that an index holds.
pub const MAX_CONFIGURATIONS: usize = 1_000_000;

/// The most configurations of a forest, times its trees.
pub const MAX_ENTRIES: usize = 10_000_000;

/// The result of a query.
#[derive(Debug, Clone, PartialEq)]
pub struct NearestResult {
    /// The neighbours, nearest first, ties by number.
    pub neighbours: Vec<Neighbour>,
    /// The number of configurations whose distance was computed.
    pub visited: usize,
}

/// An index of configurations that grows. They are numbered from 0 in the order in which they were added. If joints have
/// limits, configurations lie within them; angles of others may have any number of turns.
pub trait Neighbours {
    /// How many numbers a configuration has.
    fn dimension(&self) -> usize;

    /// How many configurations there are.
    fn len(&self) -> usize;

    /// Whether there is none.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds configurations, `dimension` numbers each; all of them, or none if one is refused. O(log n) each; O(1) in a scan.
    ///
    /// # Errors
    /// `wrong-dimension` if the last row is not whole; `not-finite` or `out-of-range` with a pointer of row and number, such
    /// as `/rows/2/0`; `too-large` beyond [`MAX_CONFIGURATIONS`], or [`MAX_ENTRIES`] in a forest.
    fn add(&mut self, rows: &[f64]) -> Result<(), Error>;

    /// The `k` configurations nearest to `q`; all, if there are fewer. O(n) by a scan, about O(log n + k) by a kd-tree in few
    /// dimensions, O(candidates + trees log n) by a forest.
    ///
    /// # Errors
    /// `wrong-dimension`, `not-finite` or `out-of-range`, with a pointer at or below `/q`.
    fn k_nearest(&self, q: &[f64], k: usize) -> Result<NearestResult, Error>;

    /// Those no farther from `q` than `radius`, in the unit of the metric; a forest finds those among its candidates.
    ///
    /// # Errors
    /// Of `q` as above; `not-finite` or `out-of-range` with the pointer `/radius` for one that is negative.
    fn within(&self, q: &[f64], radius: f64) -> Result<NearestResult, Error>;
}
