//! When a run ends whose planner goes on to shorter paths: by conditions that have names, of which one is enough or all must
//! hold.
//!
//! They are evaluated after each iteration of the planner, from counts alone, so where a run ends depends on no clock and no
//! slicing.

use crate::planner::{Limits, Reason, StopWhen, Termination};

/// A path this near to a lower bound on the costs of all paths is the shortest.
const SHORTEST: f64 = 1.0 + 1e-12;

/// The fewest iterations since the first path whose last half shows whether the length has converged.
const FEWEST: u32 = 1000;

/// The costs of the paths so far, and the conditions.
#[derive(Debug, Clone)]
pub(super) struct Progress {
    termination: Termination,
    /// A lower bound on the costs of all paths, as the planner counts them; 0 if there is none.
    least: f64,
    /// Whether the path is as cheap as that.
    is_shortest: bool,
    /// Each iteration that found a path cheaper than all before, and its cost.
    falls: Vec<(u32, f64)>,
}

impl Progress {
    /// No path yet.
    pub fn new(termination: Termination, least: f64) -> Self {
        Self { termination, least, is_shortest: false, falls: Vec::new() }
    }

    /// Notes the path after an iteration, if it is cheaper than all before: its cost, as results report it and as the planner
    /// counts it. O(1).
    pub fn note(&mut self, iteration: u32, cost: f64, counted: f64) {
        self.is_shortest |= counted <= SHORTEST * self.least;
        if self.falls.last().is_none_or(|&(_, least)| cost < least) {
            self.falls.push((iteration, cost));
        }
    }

    /// Whether the run ends with this iteration, after this number of clearance evaluations. O(log paths).
    pub fn is_over(&self, iteration: u32, evaluations: u64) -> bool {
        let Termination { improve_iterations, stop_evaluations, stop_cost, stop_stale, stop_converged, stop_when } =
            self.termination;
        let cost = self.falls.last().map_or(f64::INFINITY, |&(_, cost)| cost);
        let first = self.falls.first().map(|&(first, _)| iteration - first);
        let last = self.falls.last().map(|&(last, _)| iteration - last);
        let conditions = [
            Some(first.is_some_and(|since| since >= improve_iterations)),
            stop_evaluations.map(|most| evaluations >= most),
            stop_cost.map(|most| cost <= most),
            stop_stale.map(|most| last.is_some_and(|since| since >= most)),
            stop_converged.map(|share| self.has_converged(iteration, share)),
        ];
        let mut given = conditions.into_iter().flatten();
        self.is_shortest
            || match stop_when {
                StopWhen::Any => given.any(|holds| holds),
                StopWhen::All => given.all(|holds| holds),
            }
    }

    /// Whether conditions other than the number of iterations are still to hold, after these iterations: they may never do.
    pub fn may_never_end(&self, iteration: u32) -> bool {
        let since = self.falls.first().map_or(0, |&(first, _)| iteration - first);
        self.termination.stop_when == StopWhen::All && since >= self.termination.improve_iterations
    }

    /// How many times the path has become cheaper.
    pub fn falls(&self) -> usize {
        self.falls.len()
    }

    /// Whether the last half of the iterations since the first path made it cheaper by no more than a share of its cost.
    fn has_converged(&self, iteration: u32, share: f64) -> bool {
        let (Some(&(first, _)), Some(&(_, now))) = (self.falls.first(), self.falls.last()) else { return false };
        let half = (iteration - first) / 2;
        let before = self.falls.partition_point(|&(at, _)| at <= iteration - half);
        let then = self.falls[before - 1].1;
        2 * half >= FEWEST && then - now <= share * then
    }
}

/// The limits of a run without a path, and what they are counted from.
#[derive(Debug, Clone)]
pub(super) struct Limiting {
    /// The most iterations, `u32::MAX` if any number, and the most work, since then.
    most: (u32, u64),
    since: (u32, u64),
    /// What the run had gained by then.
    gained: usize,
}

impl Limiting {
    /// From the beginning.
    pub fn new(limits: Limits) -> Self {
        Self { most: (limits.max_iterations.unwrap_or(u32::MAX), limits.work()), since: (0, 0), gained: 0 }
    }

    /// The limit that is spent after these iterations and this work.
    pub fn exceeded(&self, iteration: u32, work: u64) -> Option<Reason> {
        if iteration - self.since.0 >= self.most.0 {
            return Some(Reason::IterationLimit);
        }
        (work - self.since.1 >= self.most.1).then_some(Reason::WorkLimit)
    }

    /// Whether the run has gained something since the limits are counted: vertices, or shorter paths.
    pub fn has_gained(&mut self, now: usize) -> bool {
        std::mem::replace(&mut self.gained, now) < now
    }

    /// Counts from here on.
    pub fn begin_again(&mut self, iteration: u32, work: u64) {
        self.since = (iteration, work);
    }
}
