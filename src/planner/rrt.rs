//! RRT: a tree that grows from the start into the space.
//!
//! LaValle 1998, "Rapidly-exploring random trees: a new tool for path planning"; LaValle and Kuffner 2001, "Randomized
//! kinodynamic planning"; LaValle 2006, "Planning Algorithms", section 5.5. The goal is vertex 1 from the beginning, but in
//! the tree only once it is reached; where there are several they are the vertices from 1 on, and it reaches for each in turn.

use super::{Counters, Phase, Planner, Status};
use crate::graph::{Event, EventKind, Graph, VertexId};
use crate::nearest::{Index, Nearest};
use crate::problem::Problem;
use crate::random::Random;
use crate::sampling::{Known, Sampler};
use crate::space::Space;

/// The first goal.
const GOAL: VertexId = VertexId(1);

/// How far the tree grows towards a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extend {
    /// One step at most.
    Step,
    /// Half the way, or all of it where that is a step at most.
    Half,
    /// All the way, or to the last place before an obstacle that is proven free.
    UntilObstacle,
}

/// When the tree grows towards the goal and not towards a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GoalBias {
    /// With this probability.
    Share(f64),
    /// Every n-th iteration, n at least 1.
    Every(u32),
}

impl GoalBias {
    /// Whether the tree grows towards the goal in this iteration.
    pub(super) fn is_due(self, iteration: u32, random: &mut Random) -> bool {
        match self {
            GoalBias::Share(share) => share > 0.0 && random.uniform() < share,
            GoalBias::Every(n) => iteration.is_multiple_of(n),
        }
    }
}

/// How a tree grows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RrtOptions {
    /// The length of a step in the metric of the space, greater than 0.
    pub step: f64,
    /// How far it grows.
    pub extend: Extend,
    /// When it reaches for the goal.
    pub bias: GoalBias,
}

/// The planner. An iteration takes one sample: one motion towards it, and one to the goal where that is a step at most.
pub struct Rrt<S: Space> {
    options: RrtOptions,
    sampler: Box<dyn Sampler<S>>,
    random: Random,
    graph: Graph<S>,
    parents: Vec<Option<VertexId>>,
    nearest: Index<S>,
    /// The vertex of the tree nearest to a goal, and how far it is.
    closest: (VertexId, f64),
    /// How often it has reached for a goal.
    reaches: usize,
    /// The goal that was reached.
    arrived: Option<VertexId>,
    counters: Counters,
}

impl<S: Space> Rrt<S> {
    /// A planner at its beginning; `random` decides when it reaches for the goal.
    pub fn new(problem: &Problem<S>, options: RrtOptions, sampler: Box<dyn Sampler<S>>, random: Random) -> Self {
        let (mut graph, mut nearest) = (Graph::default(), Index::new());
        let start = graph.add_vertex(0, *problem.start());
        for goal in problem.goals() {
            graph.add_vertex(0, *goal);
        }
        nearest.insert(problem.space(), start, *problem.start());
        let closest = (start, problem.distance_to_goal(problem.start()));
        let (parents, counters) = (vec![None; graph.states().len()], Counters::default());
        Self { options, sampler, random, graph, parents, nearest, closest, reaches: 0, arrived: None, counters }
    }

    /// Where to grow this time; `None` where the sampler has nothing.
    fn target(&mut self, problem: &Problem<S>, iteration: u32) -> Option<S::State> {
        if self.options.bias.is_due(iteration, &mut self.random) {
            self.reaches = self.reaches.wrapping_add(1);
            return Some(*problem.goal_in_turn(self.reaches - 1));
        }
        let sample = self.sampler.draw(problem, &mut self.counters.configuration_checks);
        if sample.known == Known::Useless {
            let (kind, state) = (EventKind::SampleRejected, sample.state);
            self.graph.add_event(Event { kind, iteration, vertex: None, other: None, state });
            return None;
        }
        Some(sample.state)
    }

    fn is_motion_free(&mut self, problem: &Problem<S>, a: &S::State, b: &S::State) -> bool {
        self.counters.motion_checks += 1;
        problem.validity().is_motion_free(a, b)
    }

    /// The state to grow to from `origin` towards `target`, where that motion is proven free.
    fn steer(&mut self, problem: &Problem<S>, origin: &S::State, target: &S::State) -> Result<S::State, S::State> {
        let space = problem.space();
        let distance = space.distance(origin, target);
        let wanted = match self.options.extend {
            Extend::Step if distance > self.options.step => {
                space.interpolate(origin, target, self.options.step / distance)
            }
            Extend::Half if distance > self.options.step => space.interpolate(origin, target, 0.5),
            _ => *target,
        };
        if self.is_motion_free(problem, origin, &wanted) {
            return Ok(wanted);
        }
        if self.options.extend == Extend::UntilObstacle {
            self.counters.motion_checks += 1;
            let hit = problem.validity().first_hit(origin, target).unwrap_or(0.0);
            let last = space.interpolate(origin, target, hit);
            // Proven anew: rounding may have moved it off the motion that was proven up to there.
            if last != *origin && self.is_motion_free(problem, origin, &last) {
                return Ok(last);
            }
        }
        Err(wanted)
    }

    fn add_edge(&mut self, iteration: u32, from: VertexId, to: VertexId) {
        self.parents[to.index()] = Some(from);
        self.graph.add_edge(iteration, from, to);
    }

    fn refuse(&mut self, iteration: u32, from: VertexId, other: Option<VertexId>, state: S::State) {
        let kind = EventKind::EdgeRefused;
        self.graph.add_event(Event { kind, iteration, vertex: Some(from), other, state });
    }

    /// The goal that is nearest to the state, the first of those equally near, and how far it is.
    fn nearest_goal(&self, problem: &Problem<S>, state: &S::State) -> (VertexId, f64) {
        let mut nearest = (GOAL, f64::INFINITY);
        for (i, goal) in problem.goals().enumerate() {
            let left = problem.space().distance(state, goal);
            if left < nearest.1 {
                nearest = (VertexId(GOAL.0 + i as u32), left);
            }
        }
        nearest
    }

    /// Joins a goal to the tree.
    fn arrive(&mut self, iteration: u32, from: VertexId, goal: VertexId) -> Status {
        self.add_edge(iteration, from, goal);
        let (kind, state) = (EventKind::SolutionFound, *self.graph.state(goal));
        self.graph.add_event(Event { kind, iteration, vertex: Some(goal), other: Some(from), state });
        self.closest = (goal, 0.0);
        self.arrived = Some(goal);
        Status::Solved
    }

    fn way(&self, to: VertexId) -> Vec<VertexId> {
        let mut way: Vec<_> = std::iter::successors(Some(to), |v| self.parents[v.index()]).collect();
        way.reverse();
        way
    }
}

impl<S: Space> Planner<S> for Rrt<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if self.arrived.is_some() {
            return Status::Solved;
        }
        let space = problem.space();
        let Some(target) = self.target(problem, iteration) else { return Status::Running };
        self.counters.nearest_queries += 1;
        let near = self.nearest.nearest(space, &target).expect("a tree has a root").vertex;
        let origin = *self.graph.state(near);
        let reached = match self.steer(problem, &origin, &target) {
            Ok(reached) => reached,
            Err(wanted) => {
                self.refuse(iteration, near, None, wanted);
                return Status::Running;
            }
        };
        let (goal, left) = self.nearest_goal(problem, &reached);
        if reached == *self.graph.state(goal) {
            return self.arrive(iteration, near, goal);
        }
        let vertex = self.graph.add_vertex(iteration, reached);
        self.parents.push(None);
        self.add_edge(iteration, near, vertex);
        self.nearest.insert(space, vertex, reached);
        if left < self.closest.1 {
            self.closest = (vertex, left);
        }
        if left <= self.options.step {
            let target = *self.graph.state(goal);
            if self.is_motion_free(problem, &reached, &target) {
                return self.arrive(iteration, vertex, goal);
            }
            self.refuse(iteration, vertex, Some(goal), target);
        }
        Status::Running
    }

    fn phase(&self) -> Phase {
        if self.arrived.is_some() { Phase::Done } else { Phase::Growing }
    }

    fn graph(&self) -> &Graph<S> {
        &self.graph
    }

    fn path(&self) -> Vec<VertexId> {
        self.arrived.map_or(Vec::new(), |goal| self.way(goal))
    }

    fn approximate_path(&self) -> Vec<VertexId> {
        self.way(self.closest.0)
    }

    fn counters(&self) -> Counters {
        self.counters
    }
}
