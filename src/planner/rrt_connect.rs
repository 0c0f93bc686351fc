//! RRT-Connect: two trees that reach for each other.
//!
//! Kuffner and LaValle 2000, "RRT-Connect: an efficient approach to single-query path planning". The smaller tree grows
//! one step towards a sample; the other then grows step by step towards what was added until it arrives or is refused.
//! Trees are kept in balance: the smaller one takes the sample, the start's tree where they are equal (LaValle 2006,
//! "Planning Algorithms", section 5.5.3). Where motions have a direction, the goal's tree grows against it: its motions
//! lead from new vertices to it. Several goals are roots of one forest.

use super::{Counters, Phase, Planner, Status};
use crate::graph::{Event, EventKind, Graph, VertexId};
use crate::nearest::{Index, Nearest, Way};
use crate::problem::Problem;
use crate::sampling::{Known, Sampler};
use crate::space::Space;

/// The planner. An iteration takes one sample: one extension, then one greedy connection of at most extent / step motions.
pub struct RrtConnect<S: Space> {
    step: f64,
    sampler: Box<dyn Sampler<S>>,
    graph: Graph<S>,
    /// The parent of every vertex; roots have none.
    parents: Vec<Option<VertexId>>,
    /// The start's tree, then the goal's.
    trees: [Index<S>; 2],
    /// Where the trees met: a vertex of the start's tree, one of the goal's.
    bridge: Option<[VertexId; 2]>,
    counters: Counters,
}

/// What one step towards a target did.
enum Growth<S> {
    /// The motion is not free.
    Refused,
    /// A vertex was added on the way.
    Advanced(VertexId),
    /// The motion to the target itself is free; nothing was added yet.
    Arrived(S),
}

impl<S: Space> RrtConnect<S> {
    /// Two trees with edges of length `step` at most, in the metric of the space, greater than 0.
    pub fn new(problem: &Problem<S>, step: f64, sampler: Box<dyn Sampler<S>>) -> Self {
        let mut planner = Self {
            step,
            sampler,
            graph: Graph::default(),
            parents: Vec::new(),
            trees: [Index::new(), Index::new()],
            bridge: None,
            counters: Counters::default(),
        };
        let roots = std::iter::once((0, problem.start())).chain(problem.goals().map(|goal| (1, goal)));
        for (tree, root) in roots {
            planner.add_vertex(problem.space(), tree, 0, None, *root);
        }
        planner
    }

    /// Which way motions lead between the states that a tree grows to and its vertices.
    fn way(space: &S, tree: usize) -> Way {
        if tree == 0 || space.is_symmetric() { Way::In } else { Way::Out }
    }

    fn add_vertex(
        &mut self,
        space: &S,
        tree: usize,
        iteration: u32,
        parent: Option<VertexId>,
        state: S::State,
    ) -> VertexId {
        let vertex = self.graph.add_vertex(iteration, state);
        self.trees[tree].insert(space, vertex, state);
        self.parents.push(parent);
        if let Some(parent) = parent {
            let [from, to] = Self::way(space, tree).ends(vertex, parent);
            self.graph.add_edge(iteration, from, to);
        }
        vertex
    }

    /// The vertex of a tree that is nearest to the state.
    fn nearest(&mut self, space: &S, tree: usize, state: &S::State) -> VertexId {
        self.counters.nearest_queries += 1;
        self.trees[tree].nearest_by(space, Self::way(space, tree), state).expect("a tree has a root").vertex
    }

    /// Grows a tree from one of its vertices by one step towards the target.
    fn grow(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        tree: usize,
        from: VertexId,
        target: &S::State,
    ) -> Growth<S::State> {
        let space = problem.space();
        let origin = *self.graph.state(from);
        let way = Self::way(space, tree);
        let [a, b] = way.ends(target, &origin);
        let distance = space.distance(a, b);
        let arrives = distance <= self.step;
        let next = match way {
            _ if arrives => *target,
            Way::In => space.interpolate(a, b, self.step / distance),
            Way::Out => space.interpolate(a, b, 1.0 - self.step / distance),
        };
        self.counters.motion_checks += 1;
        let [a, b] = way.ends(&next, &origin);
        if !problem.validity().is_motion_free(a, b) {
            let kind = EventKind::EdgeRefused;
            self.graph.add_event(Event { kind, iteration, vertex: Some(from), other: None, state: next });
            return Growth::Refused;
        }
        if arrives {
            return Growth::Arrived(next);
        }
        Growth::Advanced(self.add_vertex(space, tree, iteration, Some(from), next))
    }

    /// Grows a tree step by step towards a vertex of the other tree; answers the vertex next to it on arrival.
    fn connect(&mut self, problem: &Problem<S>, iteration: u32, tree: usize, target: VertexId) -> Option<VertexId> {
        let state = *self.graph.state(target);
        let mut from = self.nearest(problem.space(), tree, &state);
        // Every step brings the tree nearer by its length. Rounding could keep a steered one from that, but not forever.
        let most = libm::ceil(problem.space().extent() / self.step) as u64 + 2;
        for _ in 0..most {
            match self.grow(problem, iteration, tree, from, &state) {
                Growth::Refused => return None,
                Growth::Advanced(vertex) => from = vertex,
                Growth::Arrived(_) => return Some(from),
            }
        }
        None
    }
}

impl<S: Space> Planner<S> for RrtConnect<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if self.bridge.is_some() {
            return Status::Solved;
        }
        let space = problem.space();
        let tree = usize::from(self.trees[1].len() < self.trees[0].len());
        let sample = self.sampler.draw(problem, &mut self.counters.configuration_checks);
        if sample.known == Known::Useless {
            let (kind, state) = (EventKind::SampleRejected, sample.state);
            self.graph.add_event(Event { kind, iteration, vertex: None, other: None, state });
            return Status::Running;
        }
        let sample = sample.state;
        let near = self.nearest(space, tree, &sample);
        let added = match self.grow(problem, iteration, tree, near, &sample) {
            Growth::Refused => return Status::Running,
            Growth::Advanced(vertex) => vertex,
            Growth::Arrived(state) => self.add_vertex(space, tree, iteration, Some(near), state),
        };
        let Some(reached) = self.connect(problem, iteration, 1 - tree, added) else { return Status::Running };
        let bridge = if tree == 0 { [added, reached] } else { [reached, added] };
        self.graph.add_edge(iteration, bridge[0], bridge[1]);
        let state = *self.graph.state(added);
        let kind = EventKind::SolutionFound;
        self.graph.add_event(Event { kind, iteration, vertex: Some(added), other: Some(reached), state });
        self.bridge = Some(bridge);
        Status::Solved
    }

    fn phase(&self) -> Phase {
        if self.bridge.is_some() { Phase::Done } else { Phase::Growing }
    }

    fn graph(&self) -> &Graph<S> {
        &self.graph
    }

    fn path(&self) -> Vec<VertexId> {
        let Some([start_side, goal_side]) = self.bridge else { return Vec::new() };
        let to_root = |vertex| std::iter::successors(Some(vertex), |&v: &VertexId| self.parents[v.index()]);
        let mut path: Vec<VertexId> = to_root(start_side).collect();
        path.reverse();
        path.extend(to_root(goal_side));
        path
    }

    fn counters(&self) -> Counters {
        self.counters
    }
}
