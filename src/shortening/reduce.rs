//! Vertex reduction: vertices of a path are removed if the straight motion past them is proven free.
//!
//! Geraerts and Overmars 2007, "Creating high-quality paths for motion planning".

use super::is_free;
use super::priced::Priced;
use crate::problem::Problem;
use crate::space::Space;

/// From every vertex the farthest one along the path that can be reached straight is tried first.
#[derive(Debug, Clone)]
pub(super) struct Reduction {
    /// The vertex that motions start from, and the one they try to reach.
    from: usize,
    to: usize,
}

impl Reduction {
    /// The reduction of a path with this number of vertices.
    pub fn new(vertices: usize) -> Self {
        Self { from: 0, to: vertices.saturating_sub(1) }
    }

    /// Whether every vertex was tried.
    pub fn is_done(&self) -> bool {
        self.to < self.from + 2
    }

    /// Tries one motion past at least one vertex: one motion check.
    pub fn attempt<S: Space>(&mut self, problem: &Problem<S>, path: &mut Priced<S>, checks: &mut u64) {
        let Self { from, to } = *self;
        let (a, b) = (path.states()[from], path.states()[to]);
        // The triangle inequality holds except for rounding, and of lengths alone.
        let is_cheaper = path.motions().cost_with(problem.cost(&a, &b), from..to) <= path.motions().cost();
        if is_cheaper && is_free(problem, &[a, b], checks) {
            let reduced = [&path.states()[..=from], &path.states()[to..]].concat();
            *path = path.changed(problem, reduced);
            self.to = from + 1;
        } else {
            self.to -= 1;
        }
        if self.to == self.from + 1 {
            (self.from, self.to) = (self.from + 1, path.states().len() - 1);
        }
    }
}
