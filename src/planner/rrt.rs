//! RRT: a tree that grows from the start into the space.
//!
//! LaValle 1998, "Rapidly-exploring random trees: a new tool for path planning"; LaValle and Kuffner 2001, "Randomized
//! kinodynamic planning"; LaValle 2006, "Planning Algorithms", section 5.5. The goal is vertex 1 from the beginning, but in
//! the tree only once it is reached; several goals are the vertices from 1 on, and the tree grows towards each in turn.

use super::groups::{Aim, EdgeOptions, GoalBias, Overgrowth, Sampling};
use super::growth::{Growth, goals};
use super::info::{DIRECT, END_NEAR, Grows, IMPROVE, Mark, NONE_FOUND, PlannerInfo, PlannerKind, Preset, line};
use super::stride::Strides;
use super::{Planner, Reason, Status};
use crate::error::Error;
use crate::graph::{EventKind, Tree, VertexId};
use crate::nearest::{Direction, Index, Nearest};
use crate::problem::Problem;
use crate::space::Space;

crate::choice! {
    /// How far the tree grows towards a sample.
    pub enum Extend {
        /// One step at most.
        Step,
        /// Half the distance, or all of it if that is at most a step.
        Half,
        /// All of the distance, or to the last point before an obstacle that is proven free.
        UntilObstacle,
    }
}

crate::options! {
    /// Options of RRT.
    pub struct RrtOptions for crate::options::ALL;
    /// Longest step, and distance at which the goal is tried: short steps follow bends, long ones are fast.
    step: Option<f64>, in 1e-6..=1e7, "Step", unit "distance in the metric",
        else "it adapts to the scene: a fifth of the largest distance in the space at first, half as long where that is refused";
    /// How far the tree grows towards a sample: one step, half the distance, or until just before an obstacle.
    extend: Extend = Extend::Step, "Growth";
    /// Whether samples in collision are rejected, as in some course reports, at the price of a check each.
    free_samples: bool = false, "Free samples only";
    /// When the tree grows towards the goal.
    reaching: GoalBias;
    /// Growth past the goal.
    overgrowth: Overgrowth;
    /// Where samples come from.
    sampling: Sampling;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

impl PlannerKind for RrtOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "rrt",
        title: "RRT",
        summary: "Grows a tree from the start: the vertex nearest to a random sample takes a step towards it, repeatedly.",
        guarantee: "Probabilistically complete: more iterations find any path that has clearance; paths are not short.",
        grows: Grows::Tree,
        presets: &[
            Preset {
                id: "half-way",
                title: "Half the distance",
                settings: "extend=half goal_bias=0.05 max_iterations=1000",
            },
            Preset {
                id: "last-free-point",
                title: "To the last free point",
                settings: "extend=until-obstacle goal_bias=0.05 max_iterations=1000",
            },
            Preset {
                id: "thousand-vertices",
                title: "Half-way, 1000 vertices",
                settings: "extend=half goal_bias=0.05 edge_check=sampled edge_samples=5 vertices=1000",
            },
            Preset {
                id: "thousand-last-free",
                title: "Last free point, 1000 vertices",
                settings: "extend=until-obstacle goal_bias=0.05 vertices=1000",
            },
            Preset { id: "every-fifth", title: "Goal every 5th sample", settings: "goal_every=5 max_iterations=2000" },
        ],
        pseudocode: &[
            DIRECT,
            line(0, "T ← {start}; repeat:", &[]),
            line(1, "q ← a random configuration, or the goal", &[Mark::Growing]),
            NONE_FOUND,
            line(1, "near ← the vertex of T nearest to q", &[Mark::Edge, Mark::Refused]),
            line(1, "new ← from near some way towards q", &[Mark::Edge, Mark::Refused]),
            line(1, "if near – new is free: add both to T", &[Mark::Vertex, Mark::Edge]),
            line(1, "within a step of the goal, try new – goal:", &[]),
            line(2, "if that is free: solved", &[Mark::Solved]),
            line(1, "a motion that is not free is rejected", &[Mark::Refused]),
            IMPROVE,
            END_NEAR,
        ],
    };

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let space = problem.space();
        let (mut growth, mut tree, mut nearest) = (Growth::new(problem), Tree::default(), Index::default());
        let start = growth.graph.add_vertex(0, *problem.start());
        for goal in problem.goals() {
            growth.graph.add_vertex(0, *goal);
        }
        tree.add_root(start);
        nearest.insert(space, start, problem.start());
        Ok(Box::new(Rrt {
            strides: Strides::new(self.step, space.extent())?,
            extend: self.extend,
            overgrowth: self.overgrowth,
            aim: Aim::new(self.reaching, &self.sampling, space, seed).with_free(self.free_samples),
            growth,
            tree,
            nearest,
            closest: (start, problem.distance_to_goal(problem.start())),
            arrived: None,
        }))
    }
}

/// The planner. An iteration takes one sample: one motion towards it, and one to the goal if it is at most a step away.
struct Rrt<S: Space> {
    strides: Strides,
    extend: Extend,
    overgrowth: Overgrowth,
    aim: Aim<S>,
    growth: Growth<S>,
    tree: Tree,
    nearest: Index,
    /// The vertex of the tree nearest to a goal, and its distance.
    closest: (VertexId, f64),
    /// The goal that was reached, or a vertex in the goal region.
    arrived: Option<VertexId>,
}

impl<S: Space> Rrt<S> {
    /// The state to grow to from `origin` towards `target` if that motion is proven free; else the state of the refused motion.
    fn steer(
        &mut self,
        problem: &Problem<S>,
        vertex: VertexId,
        origin: &S::State,
        target: &S::State,
    ) -> Result<S::State, S::State> {
        let space = problem.space();
        let distance = space.distance(origin, target);
        let (step, longest) = (self.strides.of(vertex), self.strides.longest());
        let wanted = match self.extend {
            Extend::Step if distance > step => space.interpolate(origin, target, step / distance),
            Extend::Half if distance > longest => space.interpolate(origin, target, 0.5),
            _ => *target,
        };
        if self.growth.is_motion_free(problem, origin, &wanted) {
            return Ok(wanted);
        }
        if self.extend == Extend::UntilObstacle {
            self.growth.counters.motion_checks += 1;
            let hit = problem.validity().first_hit(origin, target).unwrap_or(0.0);
            let last = space.interpolate(origin, target, hit);
            // Proven again: rounding may have moved it off the motion that was proven.
            if last != *origin && self.growth.is_motion_free(problem, origin, &last) {
                return Ok(last);
            }
        }
        Err(wanted)
    }

    fn add_edge(&mut self, iteration: u32, from: VertexId, to: VertexId) {
        self.tree.add(to, from);
        self.growth.graph.add_edge(iteration, from, to);
    }

    /// The goal nearest to the state, ties by number, and its distance.
    fn nearest_goal(&self, problem: &Problem<S>, state: &S::State) -> (VertexId, f64) {
        let all = goals(problem).map(|(goal, at)| (goal, problem.space().distance(state, at)));
        all.min_by(|(_, a), (_, b)| a.total_cmp(b)).expect("a query has a goal")
    }

    /// Adds a goal to the tree, unless one is there: then the path stays.
    fn arrive(&mut self, iteration: u32, from: VertexId, goal: VertexId) {
        if self.arrived.is_some() {
            return;
        }
        self.add_edge(iteration, from, goal);
        let state = self.growth.state(goal);
        self.growth.add_event(EventKind::SolutionFound, iteration, Some(goal), Some(from), state);
        self.closest = (goal, 0.0);
        self.arrived = Some(goal);
    }

    /// Takes one sample.
    fn grow(&mut self, problem: &Problem<S>, iteration: u32) {
        let space = problem.space();
        let Some(target) = self.aim.next(problem, iteration, &mut self.growth) else { return };
        let near = self.growth.nearest(space, &self.nearest, Direction::In, &target).vertex;
        let origin = self.growth.state(near);
        let reached = match self.steer(problem, near, &origin, &target) {
            Ok(reached) => reached,
            Err(wanted) => {
                self.strides.refused(near);
                return self.growth.add_event(EventKind::EdgeRefused, iteration, Some(near), None, wanted);
            }
        };
        let (goal, left) = self.nearest_goal(problem, &reached);
        if reached == self.growth.state(goal) {
            return self.arrive(iteration, near, goal);
        }
        let vertex = self.growth.graph.add_vertex(iteration, reached);
        self.add_edge(iteration, near, vertex);
        self.nearest.insert(space, vertex, &reached);
        self.strides.free(near, vertex);
        if left < self.closest.1 {
            self.closest = (vertex, left);
        }
        if self.arrived.is_none() && problem.ends_in_region && problem.is_goal(&reached) {
            self.growth.add_event(EventKind::SolutionFound, iteration, Some(vertex), Some(near), reached);
            self.closest = (vertex, 0.0);
            self.arrived = Some(vertex);
            return;
        }
        if left <= self.strides.longest() && self.arrived.is_none() {
            let target = self.growth.state(goal);
            if self.growth.is_motion_free(problem, &reached, &target) {
                return self.arrive(iteration, vertex, goal);
            }
            self.growth.add_event(EventKind::EdgeRefused, iteration, Some(vertex), Some(goal), target);
        }
    }
}

impl<S: Space> Planner<S> for Rrt<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        self.grow(problem, iteration);
        // A goal is no vertex of the index.
        let is_goal = |vertex: VertexId| goals(problem).any(|(goal, _)| goal == vertex);
        let vertices = Nearest::<S>::len(&self.nearest) + usize::from(self.arrived.is_some_and(is_goal));
        self.overgrowth.status(self.arrived.is_some(), vertices)
    }

    fn growth(&self) -> &Growth<S> {
        &self.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.growth
    }

    fn reason(&self) -> Reason {
        Reason::VertexLimit
    }

    fn path(&self) -> Vec<VertexId> {
        self.arrived.map_or(Vec::new(), |goal| self.tree.from_root(goal))
    }

    fn approximate_path(&self) -> Vec<VertexId> {
        self.tree.from_root(self.closest.0)
    }
}
