//! RRT-Connect: two trees that grow towards each other.
//!
//! Kuffner and LaValle 2000, "RRT-Connect: an efficient approach to single-query path planning". One tree grows one step towards
//! a sample; the other then grows step by step towards the new vertex until it arrives or is refused. The trees take samples in
//! turn, as in the paper. With a step that is given, the smaller one takes the sample, the start's tree if they are equal
//! (LaValle 2006, "Planning Algorithms", section 5.5.3), unless it is stuck. If motions have a direction, the goal's tree grows
//! against it: its motions lead from new vertices to it. Several goals are roots of one forest.
//!
//! A tree whose extensions are refused takes every other sample about one of its vertices, as trees of expansive spaces grow
//! (Hsu, Latombe and Motwani 1999, "Path planning in expansive configuration spaces").

use super::groups::{EdgeOptions, Sampling};
use super::growth::Growth;
use super::info::{DIRECT, END, Grows, IMPROVE, Mark, NONE_FOUND, PlannerInfo, PlannerKind, line};
use super::stride::Strides;
use super::{Planner, Status};
use crate::error::Error;
use crate::graph::{EventKind, Tree, VertexId};
use crate::nearest::{Direction, Index, Nearest};
use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::sampling::Sampler;
use crate::space::Space;

crate::options! {
    /// Options of RRT-Connect.
    pub struct RrtConnectOptions for crate::options::ALL;
    /// Longest step of a tree: short steps follow bends, long ones cross open space quickly.
    step: Option<f64>, in 1e-6..=1e7, "Step", unit "distance in the metric",
        else "it adapts to the scene: a fifth of the largest distance in the space at first, half as long where that is refused";
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
            DIRECT,
            line(0, "two trees, {start} and {goal}; repeat:", &[]),
            line(1, "A ← the tree in turn, B ← the other one", &[Mark::Growing]),
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

/// How many refusals in a row of steps that were given pass the turn to the other tree.
const PATIENCE: u32 = 100;

/// The most motions of one greedy connection, by steps that adapt.
const MOST_MOTIONS: u64 = 64;

/// The planner. An iteration takes one sample: one extension, then one greedy connection of a bounded number of motions.
pub(super) struct RrtConnect<S: Space> {
    pub strides: Strides,
    /// The tree whose turn it was last.
    turn: usize,
    /// How many extensions of each tree were refused since its last vertex.
    refusals: [u32; 2],
    /// The vertices of each tree, to draw samples around.
    members: [Vec<VertexId>; 2],
    /// Draws samples around vertices.
    random: Random,
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
            strides: Strides::new(options.step, problem.space().extent())?,
            turn: 1,
            refusals: [0; 2],
            members: [Vec::new(), Vec::new()],
            random: Random::new(seed, Stream::Bias),
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

    /// The tree that takes the next sample: in turn; if a step was given, the smaller one, unless it is stuck.
    pub fn next_turn(&mut self) -> usize {
        let [start_side, goal_side] = self.members.each_ref().map(Vec::len);
        let smaller = usize::from(goal_side < start_side);
        let is_in_turn = self.strides.adapts() || self.refusals[smaller] >= PATIENCE;
        self.turn = if is_in_turn { 1 - self.turn } else { smaller };
        self.turn
    }

    /// The next sample of a tree; `None`, with an event, if the sampler found none. Every other one is drawn around a vertex of
    /// the tree while its extensions are refused: at a start or a goal that is enclosed, few of the others lead anywhere.
    pub fn draw(&mut self, problem: &Problem<S>, iteration: u32, tree: usize) -> Option<S::State> {
        if self.strides.adapts() && self.refusals[tree] % 2 == 1 {
            let vertex = self.members[tree][self.random.below(self.members[tree].len() as u64) as usize];
            let (origin, target) = (self.growth.state(vertex), problem.space().sample(&mut self.random));
            let reach = 2.0 * self.random.uniform() * self.strides.of(vertex);
            return Some(Self::towards(problem.space(), tree, &origin, &target, reach).0);
        }
        Some(self.growth.draw(problem, iteration, &mut *self.sampler)?.state)
    }

    /// Extends a tree from one of its vertices towards a target by a step; `None`, with an event, if that is refused.
    pub fn extend(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        tree: usize,
        from: VertexId,
        target: &S::State,
    ) -> Option<S::State> {
        let end = self.step(problem, iteration, tree, from, target);
        self.refusals[tree] = if end.is_some() { 0 } else { self.refusals[tree].saturating_add(1) };
        end.map(|(state, _)| state)
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
        self.members[tree].push(vertex);
        if let Some(parent) = parent {
            self.strides.free(parent, vertex);
            let [from, to] = Self::direction(space, tree).ends(vertex, parent);
            self.growth.graph.add_edge(iteration, from, to);
        }
        vertex
    }

    /// The vertex of a tree that is nearest to the state.
    fn nearest(&mut self, space: &S, tree: usize, state: &S::State) -> VertexId {
        self.growth.nearest(space, &self.indices[tree], Self::direction(space, tree), state).vertex
    }

    /// The state a step from a vertex of a tree towards a target, or the target if it is no farther, and whether it is.
    fn towards(space: &S, tree: usize, origin: &S::State, target: &S::State, step: f64) -> (S::State, bool) {
        let direction = Self::direction(space, tree);
        let [a, b] = direction.ends(target, origin);
        let distance = space.distance(a, b);
        let next = match direction {
            _ if distance <= step => *target,
            Direction::In => space.interpolate(a, b, step / distance),
            Direction::Out => space.interpolate(a, b, 1.0 - step / distance),
        };
        (next, distance <= step)
    }

    /// Begins both trees again, with their roots alone.
    pub fn restart(&mut self, problem: &Problem<S>) {
        (self.indices, self.members, self.refusals) = Default::default();
        for (root, state) in std::iter::once(problem.start()).chain(problem.goals()).enumerate() {
            let (tree, vertex) = (root.min(1), VertexId(root as u32));
            self.indices[tree].insert(problem.space(), vertex, state);
            self.members[tree].push(vertex);
        }
    }

    /// The end of one step from a vertex of a tree towards a target, and whether it is the target; `None`, with an event, if the
    /// motion is not free. Adds nothing.
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
        let (next, arrives) = Self::towards(space, tree, &origin, target, self.strides.of(from));
        let [a, b] = Self::direction(space, tree).ends(&next, &origin);
        if self.growth.is_motion_free(problem, a, b) {
            return Some((next, arrives));
        }
        self.strides.refused(from);
        self.growth.add_event(EventKind::EdgeRefused, iteration, Some(from), None, next);
        None
    }

    /// Grows a tree step by step from one of its vertices towards one of the other tree; returns the vertex next to it on
    /// arrival.
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
        let most = match self.strides.adapts() {
            true => MOST_MOTIONS,
            false => libm::ceil(problem.space().extent() / self.strides.longest()) as u64 + 2,
        };
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
        let (space, tree) = (problem.space(), self.next_turn());
        let Some(sample) = self.draw(problem, iteration, tree) else { return Status::Running };
        let near = self.nearest(space, tree, &sample);
        let Some(state) = self.extend(problem, iteration, tree, near, &sample) else { return Status::Running };
        let added = self.add_vertex(space, tree, iteration, Some(near), state);
        let near = self.nearest(space, 1 - tree, &state);
        let Some(reached) = self.connect(problem, iteration, 1 - tree, near, added) else { return Status::Running };
        self.meet(iteration, tree, added, reached);
        Status::Solved
    }

    fn growth(&self) -> &Growth<S> {
        &self.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.growth
    }

    fn path(&self) -> Vec<VertexId> {
        let Some([start_side, goal_side]) = self.bridge else { return Vec::new() };
        let mut path = self.forest.from_root(start_side);
        path.extend(self.forest.to_root(goal_side));
        path
    }
}
