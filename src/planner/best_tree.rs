//! A tree with costs and the best path in it so far: what planners share whose paths get shorter. The start is vertex 0. The
//! goals are the vertices from 1 on, in the tree once they are reached, and have no children, except in FMT*.

use super::growth::{Growth, START, goals};
use crate::graph::{CostTree, EventKind, VertexId};
use crate::nearest::Neighbour;
use crate::problem::Problem;
use crate::space::Space;

/// The tree, its vertices and events, and its best path.
#[derive(Debug, Clone)]
pub(super) struct BestTree<S: Space> {
    pub growth: Growth<S>,
    pub tree: CostTree,
    /// The vertex of the tree nearest to a goal, and its distance.
    closest: (VertexId, f64),
    /// The goal that the best path ends at, and its cost.
    best: Option<(VertexId, f64)>,
}

impl<S: Space> BestTree<S> {
    /// The tree of the start alone, with the goals as vertices beside it.
    pub fn new(problem: &Problem<S>) -> Self {
        let mut growth = Growth::new(problem);
        for state in std::iter::once(problem.start()).chain(problem.goals()) {
            growth.graph.add_vertex(0, *state);
        }
        let closest = (START, problem.distance_to_goal(problem.start()));
        Self { growth, tree: CostTree::of(START), closest, best: None }
    }

    /// The cost of the best path, which others have to be below; infinite without a path.
    pub fn bound(&self) -> f64 {
        self.best.map_or(f64::INFINITY, |(_, cost)| cost)
    }

    /// A neighbour with the cost of the motion from it to a state in place of its distance, which is never more.
    pub fn priced(&self, problem: &Problem<S>, near: Neighbour, to: &S::State) -> Neighbour {
        let added = problem.validity().nearness_cost(self.growth.graph.state(near.vertex), to);
        Neighbour { distance: near.distance + added, ..near }
    }

    /// Notes that a vertex of the tree is so near to a goal.
    pub fn approach(&mut self, vertex: VertexId, distance: f64) {
        if distance < self.closest.1 {
            self.closest = (vertex, distance);
        }
    }

    /// Counts the expansion of a vertex, with an event, and returns its state.
    pub fn expand(&mut self, iteration: u32, vertex: VertexId) -> S::State {
        let state = self.growth.state(vertex);
        self.growth.counters.visited += 1;
        self.growth.add_event(EventKind::VertexExpanded, iteration, Some(vertex), None, state);
        state
    }

    /// Adds the event that a motion is not free.
    pub fn refuse(&mut self, iteration: u32, from: VertexId, to: Option<VertexId>, state: S::State) {
        self.growth.add_event(EventKind::EdgeRefused, iteration, Some(from), to, state);
    }

    /// Makes `parent` the parent of a vertex.
    pub fn attach(&mut self, iteration: u32, vertex: VertexId, parent: Neighbour) {
        self.growth.graph.add_edge(iteration, parent.vertex, vertex);
        if let Some(former) = self.tree.attach(vertex, parent.vertex, parent.distance) {
            let state = self.growth.state(vertex);
            self.growth.add_event(EventKind::ParentChanged, iteration, Some(vertex), Some(former), state);
        }
    }

    /// Makes `parent` the parent of a vertex if the motion is free; returns whether it is.
    pub fn try_parent(&mut self, problem: &Problem<S>, iteration: u32, vertex: VertexId, parent: Neighbour) -> bool {
        let [from, to] = [parent.vertex, vertex].map(|vertex| self.growth.state(vertex));
        let is_free = self.growth.is_motion_free(problem, &from, &to);
        if is_free {
            self.attach(iteration, vertex, parent);
        } else {
            self.refuse(iteration, parent.vertex, Some(vertex), to);
        }
        is_free
    }

    /// Removes a vertex without children, in the tree or not; returns its parent.
    pub fn remove(&mut self, iteration: u32, vertex: VertexId) -> Option<VertexId> {
        let state = self.growth.state(vertex);
        self.growth.add_event(EventKind::VertexRemoved, iteration, Some(vertex), None, state);
        self.tree.remove(vertex)
    }

    /// Notes the best path, if it has become cheaper.
    pub fn note(&mut self, problem: &Problem<S>, iteration: u32) {
        let goals = goals(problem).map(|(goal, _)| (self.tree.cost(goal), goal));
        let (cost, goal) = goals.min_by(|(a, _), (b, _)| a.total_cmp(b)).expect("a query has a goal");
        if cost < self.bound() {
            self.best = Some((goal, cost));
            let state = self.growth.state(goal);
            let parent = self.tree.tree().parent(goal);
            self.growth.add_event(EventKind::SolutionFound, iteration, Some(goal), parent, state);
            self.closest = (goal, 0.0);
        }
    }

    /// The vertices of the best path; empty until there is one.
    pub fn path(&self) -> Vec<VertexId> {
        self.best.map_or(Vec::new(), |(goal, _)| self.tree.tree().from_root(goal))
    }

    /// The vertices of the path to the vertex nearest to a goal.
    pub fn approximate_path(&self) -> Vec<VertexId> {
        self.tree.tree().from_root(self.closest.0)
    }
}
