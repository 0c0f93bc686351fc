//! The straight motion from start to goal, tried before anything else.
//!
//! A planner of one query ends with it if it is free: its first iteration then adds the edge and nothing else. A planner that
//! minimises costs does so only if the motion costs no more than its length, and one that goes on to better paths only if it
//! leads to the nearest goal as well: no path is cheaper. Roadmaps have it as an edge in any case: see
//! [`Roadmap::connect_ends`](super::Roadmap).

use super::growth::{Growth, START, goals};
use super::{Phase, Planner, Status};
use crate::graph::{EventKind, VertexId};
use crate::nearest::Neighbour;
use crate::problem::Problem;
use crate::space::Space;

/// A planner whose first two vertices and those after them are the start and the goals, and that grows no roadmap.
pub(super) struct Direct<S: Space> {
    planner: Box<dyn Planner<S>>,
    /// Whether the planner goes on to shorter paths.
    improves: bool,
    /// Whether its path is the cheapest that it finds.
    minimises: bool,
    /// The goal that the straight motion leads to, if one is free, and its distance.
    arrived: Option<(VertexId, f64)>,
}

impl<S: Space> Direct<S> {
    /// Tries the straight motions first, then leaves the rest to the planner.
    pub fn first(planner: Box<dyn Planner<S>>, improves: bool, minimises: bool) -> Self {
        Self { planner, improves, minimises, arrived: None }
    }

    /// Tries the motions from the start to the goals, the nearest first.
    fn arrive(&mut self, problem: &Problem<S>, iteration: u32) -> Option<(VertexId, f64)> {
        let distance = |goal: &S::State| problem.space().distance(problem.start(), goal);
        let mut all: Vec<_> =
            goals(problem).map(|(vertex, state)| Neighbour { distance: distance(state), vertex }).collect();
        Neighbour::sort(&mut all);
        let least = all.first().map_or(0.0, |nearest| nearest.distance);
        for Neighbour { distance, vertex: goal } in all {
            if self.improves && distance > least {
                break;
            }
            let growth = self.planner.growth_mut();
            let state = growth.state(goal);
            if growth.is_motion_free(problem, problem.start(), &state) {
                if self.minimises && problem.validity().nearness_cost(problem.start(), &state) > 0.0 {
                    return None;
                }
                growth.graph.add_edge(iteration, START, goal);
                growth.add_event(EventKind::SolutionFound, iteration, Some(goal), Some(START), state);
                return Some((goal, distance));
            }
            growth.add_event(EventKind::EdgeRefused, iteration, Some(START), Some(goal), state);
        }
        None
    }
}

impl<S: Space> Planner<S> for Direct<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if iteration == 1 {
            self.arrived = self.arrive(problem, iteration);
            if self.arrived.is_some() {
                return Status::Solved;
            }
        }
        self.planner.iterate(problem, iteration)
    }

    fn phase(&self) -> Phase {
        if self.arrived.is_some() { Phase::Done } else { self.planner.phase() }
    }

    fn cost(&self) -> f64 {
        match self.arrived {
            Some((_, distance)) if self.improves => distance,
            _ => self.planner.cost(),
        }
    }

    fn growth(&self) -> &Growth<S> {
        self.planner.growth()
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        self.planner.growth_mut()
    }

    fn is_full(&self) -> bool {
        self.planner.is_full()
    }

    fn path(&self) -> Vec<VertexId> {
        self.arrived.map_or_else(|| self.planner.path(), |(goal, _)| vec![START, goal])
    }

    fn approximate_path(&self) -> Vec<VertexId> {
        self.planner.approximate_path()
    }
}
