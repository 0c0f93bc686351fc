//! RRT-Connect: two trees that grow towards each other.
//!
//! Kuffner and LaValle 2000, "RRT-Connect: an efficient approach to single-query path planning". The smaller tree grows
//! one step towards a sample; the other then grows step by step towards the new vertex until it arrives or is refused.
//! The trees stay balanced: the smaller one takes the sample, the start's tree if they are equal (LaValle 2006,
//! "Planning Algorithms", section 5.5.3). If motions have a direction, the goal's tree grows against it: its motions
//! lead from new vertices to it. Several goals are roots of one forest.

use super::groups::{EdgeOptions, Sampling, step_in};
use super::growth::Growth;
use super::info::{END, Grows, IMPROVE, Mark, NONE_FOUND, PlannerInfo, PlannerKind, line};
use super::{Planner, Status};
use crate::error::Error;
use crate::graph::{EventKind, Tree, VertexId};
use crate::nearest::{Direction, Index, Nearest};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

crate::options! {
    /// Options of RRT-Connect.
    pub struct RrtConnectOptions for crate::options::ALL;
    /// Longest step of a tree: short steps follow bends, long ones cross open space quickly.
    step: Option<f64>, in 1e-6..=1e7, "Step", unit "distance in the metric",
        else "a fifth of the largest distance in the space";
    /// Where samples come from.
    sampling: Sampling;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

impl PlannerKind for RrtConnectOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "rrt-connect",
        title: "RRT-Connect",
        summary: "Grows one tree from the start and one from the goal, each towards the other, until they meet.",
        guarantee: "Probabilistically complete: more iterations find any path that has clearance; paths are not short.",
        grows: Grows::Trees,
        presets: &[],
        pseudocode: &[
            line(0, "two trees, {start} and {goal}; repeat:", &[]),
            line(1, "A ← the smaller tree, B ← the other one", &[Mark::Growing]),
            line(1, "q ← a random configuration", &[Mark::Growing]),
            NONE_FOUND,
            line(1, "new ← from A's nearest a step towards q", &[Mark::Vertex, Mark::Refused]),
            line(1, "if that is free: add it to A, and", &[Mark::Vertex, Mark::Edge]),
            line(2, "B goes step by step from its nearest to new", &[Mark::Vertex, Mark::Edge]),
            line(2, "if B arrives: connect the trees, solved", &[Mark::Solved]),
            line(1, "a step that is not free is rejected", &[Mark::Refused]),
            IMPROVE,
            END,
        ],
    };

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        Ok(Box::new(RrtConnect::new(problem, self, seed)?))
    }
}

/// The planner. An iteration takes one sample: one extension, then one greedy connection of at most extent / step motions.
pub(super) struct RrtConnect<S: Space> {
    step: f64,
    pub sampler: Box<dyn Sampler<S>>,
    pub growth: Growth<S>,
    /// Both trees, as one forest.
    pub forest: Tree,
    /// The start's tree, then the goal's.
    pub indices: [Index; 2],
    /// The vertices at which the trees met: one of the start's tree, one of the goal's.
    pub bridge: Option<[VertexId; 2]>,
}

impl<S: Space> RrtConnect<S> {
    /// The planner at its beginning.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/step`, for a step that is too short.
    pub fn new(problem: &Problem<S>, options: &RrtConnectOptions, seed: u64) -> Result<Self, Error> {
        let mut planner = Self {
            step: step_in(options.step, problem.space().extent())?,
            sampler: options.sampling.sampler(problem.space(), seed),
            growth: Growth::new(problem),
            forest: Tree::default(),
            indices: [Index::default(), Index::default()],
            bridge: None,
        };
        let roots = std::iter::once((0, problem.start())).chain(problem.goals().iter().map(|goal| (1, goal)));
        for (tree, root) in roots {
            planner.add_vertex(problem.space(), tree, 0, None, *root);
        }
        Ok(planner)
    }

    /// The direction of the motions of a tree, relative to the new state: from the tree (`In`), or to it for the goal's (`Out`).
    fn direction(space: &S, tree: usize) -> Direction {
        if tree == 0 || space.is_symmetric() { Direction::In } else { Direction::Out }
    }

    /// The tree that takes the next sample.
    pub fn smaller(&self) -> usize {
        let [start_side, goal_side] = self.indices.each_ref().map(Nearest::<S>::len);
        usize::from(goal_side < start_side)
    }

    /// Adds a vertex to a tree, with its edge, or as a root.
    pub fn add_vertex(
        &mut self,
        space: &S,
        tree: usize,
        iteration: u32,
        parent: Option<VertexId>,
        state: S::State,
    ) -> VertexId {
        let vertex = self.growth.graph.add_vertex(iteration, state);
        self.indices[tree].insert(space, vertex, &state);
        self.forest.add(vertex, parent.unwrap_or(vertex));
        if let Some(parent) = parent {
            let [from, to] = Self::direction(space, tree).ends(vertex, parent);
            self.growth.graph.add_edge(iteration, from, to);
        }
        vertex
    }

    /// The vertex of a tree that is nearest to the state.
    fn nearest(&mut self, space: &S, tree: usize, state: &S::State) -> VertexId {
        self.growth.counters.nearest_queries += 1;
        let (index, states) = (&self.indices[tree], self.growth.graph.states());
        index.nearest_by(space, states, Self::direction(space, tree), state).expect("a tree has a root").vertex
    }

    /// The end of one step from a vertex of a tree towards a target, and whether it is the target; `None`, with an event, if the motion
    /// is not free. Adds nothing.
    pub fn step(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        tree: usize,
        from: VertexId,
        target: &S::State,
    ) -> Option<(S::State, bool)> {
        let space = problem.space();
        let origin = self.growth.state(from);
        let direction = Self::direction(space, tree);
        let [a, b] = direction.ends(target, &origin);
        let distance = space.distance(a, b);
        let arrives = distance <= self.step;
        let next = match direction {
            _ if arrives => *target,
            Direction::In => space.interpolate(a, b, self.step / distance),
            Direction::Out => space.interpolate(a, b, 1.0 - self.step / distance),
        };
        let [a, b] = direction.ends(&next, &origin);
        if self.growth.is_motion_free(problem, a, b) {
            return Some((next, arrives));
        }
        self.growth.add_event(EventKind::EdgeRefused, iteration, Some(from), None, next);
        None
    }

    /// Grows a tree step by step from one of its vertices towards one of the other tree; returns the vertex next to it on arrival.
    pub fn connect(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        tree: usize,
        mut from: VertexId,
        target: VertexId,
    ) -> Option<VertexId> {
        let state = self.growth.state(target);
        // Each step reduces the distance by its length. With steering, rounding could prevent this: the number is bounded.
        let most = libm::ceil(problem.space().extent() / self.step) as u64 + 2;
        for _ in 0..most {
            let (next, arrives) = self.step(problem, iteration, tree, from, &state)?;
            if arrives {
                return Some(from);
            }
            from = self.add_vertex(problem.space(), tree, iteration, Some(from), next);
        }
        None
    }

    /// Connects a vertex of a tree with one of the other: a path.
    pub fn meet(&mut self, iteration: u32, tree: usize, added: VertexId, reached: VertexId) {
        let bridge = if tree == 0 { [added, reached] } else { [reached, added] };
        self.growth.graph.add_edge(iteration, bridge[0], bridge[1]);
        let state = self.growth.state(added);
        self.growth.add_event(EventKind::SolutionFound, iteration, Some(added), Some(reached), state);
        self.bridge = Some(bridge);
    }
}

impl<S: Space> Planner<S> for RrtConnect<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        let (space, tree) = (problem.space(), self.smaller());
        let Some(sample) = self.growth.draw(problem, iteration, &mut *self.sampler) else { return Status::Running };
        let near = self.nearest(space, tree, &sample.state);
        let Some((state, _)) = self.step(problem, iteration, tree, near, &sample.state) else { return Status::Running };
        let added = self.add_vertex(space, tree, iteration, Some(near), state);
        let near = self.nearest(space, 1 - tree, &state);
        let Some(reached) = self.connect(problem, iteration, 1 - tree, near, added) else { return Status::Running };
        self.meet(iteration, tree, added, reached);
        Status::Solved
    }

    fn growth(&self) -> &Growth<S> {
        &self.growth
    }

    fn path(&self) -> Vec<VertexId> {
        let Some([start_side, goal_side]) = self.bridge else { return Vec::new() };
        let mut path = self.forest.from_root(start_side);
        path.extend(self.forest.to_root(goal_side));
        path
    }
}
