//! The work of a run: one number, from its counts alone, that grows as the time on one core does.
//!
//! A unit is about a microsecond on a core of the present kind. The weights, in nanoseconds, were set by hand from the times of
//! some thirty runs of different planners and robots: a sum of counts is a rough measure. `cargo bench --bench planning -- steps`
//! prints the work and the time of each planner.

use crate::planner::Growth;
use crate::problem::{Problem, Stats};
use crate::space::Space;

/// What an iteration costs, whatever it does: a draw, and its row of events.
const ITERATION: u64 = 100;
/// A configuration tested for collision, besides the clearances evaluated.
const CONFIGURATION: u64 = 50;
/// A motion tested for collision, likewise.
const MOTION: u64 = 250;
/// A vertex or an edge more, with its memory and events.
const RECORD: u64 = 50;
/// A vertex expanded by a search.
const EXPANSION: u64 = 300;
/// A neighbour, an edge of a search or an entry of a queue that was looked at.
const LOOK: u64 = 30;
/// A vertex visited by a query where distances are lengths of curves; mostly a lower bound on its distance is enough.
const VISIT: u64 = 100;
/// A query of the nearest neighbours for each binary digit of the number of vertices and each coordinate.
const QUERY: u64 = 20;

/// What the space adds to the work of queries and looks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Weights {
    query: u64,
    evaluation: u64,
}

impl Weights {
    /// The weights of a problem.
    pub fn of<S: Space>(problem: &Problem<S>) -> Self {
        let space = problem.space();
        let evaluation = problem.validity().evaluation_nanoseconds();
        Self { query: QUERY * space.dimension() as u64, evaluation }
    }

    /// The work of a planner, whose collision checkers have made this number of evaluations. O(1).
    pub fn work<S: Space>(self, iterations: u64, growth: &Growth<S>, evaluations: u64) -> u64 {
        let Stats { configuration_checks, motion_checks, nearest_queries, visited, .. } = growth.counters;
        let (vertices, edges) = (growth.graph.states().len(), growth.graph.edges().len());
        let nanoseconds = ITERATION * iterations
            + CONFIGURATION * configuration_checks
            + MOTION * motion_checks
            + self.evaluation * evaluations
            + RECORD * (vertices + edges) as u64
            + EXPANSION * visited
            + LOOK * growth.looked
            + VISIT * growth.visited
            + self.query * nearest_queries * u64::from(usize::BITS - vertices.leading_zeros());
        nanoseconds / 1000
    }
}
