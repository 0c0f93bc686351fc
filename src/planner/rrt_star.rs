//! RRT*: a tree whose paths approach the shortest as it grows.
//!
//! Karaman and Frazzoli 2011, "Sampling-based algorithms for optimal motion planning"; the radius of Solovey, Janson, Schmerling,
//! Frazzoli and Pavone 2020, "Revisiting the asymptotic optimality of RRT*". The goals are vertices from 1 on, in the tree once they are
//! reached, and have no children.

use super::groups::{Aim, EdgeOptions, GoalBias, Sampling, Termination, step_in};
use super::growth::Growth;
use super::info::{END_NEAR, Grows, IMPROVE, Mark, NONE_FOUND, PlannerInfo, PlannerKind, line};
use super::prm::prm_star_k;
use super::{Planner, Status};
use crate::error::Error;
use crate::graph::{CostTree, EventKind, VertexId};
use crate::nearest::{Direction, Index, Nearest, Neighbour};
use crate::options::out_of_range;
use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::space::{MAX_DIMENSION, Space};

const START: VertexId = VertexId(0);
/// The first goal.
const GOAL: u32 = 1;

/// How many samples an informed iteration draws until one may help.
const DRAWS: u32 = 100;

/// How many directions measure a ball of the space.
const DIRECTIONS: usize = 1024;
/// Their length, as a fraction of the side of the space.
const LENGTH: f64 = 1e-3;

crate::choice! {
    /// Which vertices may become the parent of a new one, or its children.
    pub enum NearRule {
        /// Those within a radius that falls like (ln n / n)^(1 / (d + 1)).
        Radius,
        /// The nearest, as many as in PRM*.
        KNearest,
    }
}

crate::options! {
    /// How a tree is rewired.
    pub struct Rewiring for crate::options::ALL;
    /// Longest step, and distance at which the goal is tried: short steps follow bends, long ones are fast.
    step: Option<f64>, in 1e-6..=1e7, "Step", unit "distance in the metric",
        else "a fifth of the largest distance in the space";
    /// Neighbours of a new vertex: radius (near-optimal in the limit), or the k nearest, fewer and faster.
    near: Option<NearRule>, "Neighbour rule", else "radius; k-nearest along curves of a car";
    /// Multiplies the radius: less than 1 is faster, without a guarantee.
    radius_factor: f64 = 1.0, in 0.01..=10.0, "Radius factor";
}

crate::options! {
    /// Options of RRT*.
    pub struct RrtStarOptions for crate::options::ALL;
    /// How the tree is rewired.
    rewiring: Rewiring;
    /// When the tree grows towards the goal.
    reaching: GoalBias;
    /// Where samples come from.
    sampling: Sampling;
    /// When it stops.
    termination: Termination;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

impl PlannerKind for RrtStarOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "rrt-star",
        title: "RRT*",
        summary: "An RRT that connects each new vertex where its path is shortest, and shortens the paths to its neighbours.",
        guarantee: "Asymptotically near-optimal by its radius: with more iterations the path approaches the shortest.",
        grows: Grows::Tree,
        presets: &[],
        pseudocode: &[
            line(0, "T ← {start}; repeat:", &[]),
            line(1, "q ← a random configuration, or the goal", &[Mark::Growing, Mark::Improving]),
            NONE_FOUND,
            STEER,
            REFUSED,
            PARENT,
            REWIRE,
            ARRIVE,
            IMPROVE,
            END_NEAR,
        ],
    };

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        Ok(Box::new(RrtStar::new(problem, self, seed, false)?))
    }
}

pub(super) const STEER: super::PseudocodeLine =
    line(1, "new ← from the nearest of T a step towards q", &[Mark::Vertex, Mark::Refused]);
pub(super) const REFUSED: super::PseudocodeLine = line(1, "a motion that is not free is rejected", &[Mark::Refused]);
pub(super) const PARENT: super::PseudocodeLine =
    line(1, "parent of new ← the best of its neighbours", &[Mark::Vertex, Mark::Edge]);
pub(super) const REWIRE: super::PseudocodeLine = line(1, "new ← parent of those nearer by way of it", &[Mark::Rewired]);
pub(super) const ARRIVE: super::PseudocodeLine = line(1, "within a step of the goal, try new – goal", &[Mark::Solved]);

/// The path so far.
#[derive(Debug, Clone, Copy)]
struct Best {
    goal: VertexId,
    cost: f64,
}

/// The planner. An iteration takes one sample.
pub(super) struct RrtStar<S: Space> {
    step: f64,
    /// The radius of a ball with the measure of the space, times a factor; `None` if the nearest are neighbours.
    radius: Option<f64>,
    aim: Aim<S>,
    /// Whether samples and vertices that cannot shorten the path are discarded.
    is_informed: bool,
    growth: Growth<S>,
    tree: CostTree,
    /// The vertices of the tree without the goals.
    index: Index,
    /// The vertex of the tree nearest to a goal, and its distance.
    closest: (VertexId, f64),
    best: Option<Best>,
    found: Vec<Neighbour>,
}

impl<S: Space> RrtStar<S> {
    /// The planner at its beginning.
    ///
    /// # Errors
    /// `out-of-range`, pointer `/step`, for a step that is too short, or `/near`, for a radius along curves.
    pub(super) fn new(
        problem: &Problem<S>,
        options: &RrtStarOptions,
        seed: u64,
        is_informed: bool,
    ) -> Result<Self, Error> {
        let RrtStarOptions { rewiring: options, reaching, sampling, .. } = options;
        let space = problem.space();
        let is_straight = space.curve(problem.start(), problem.goal()).is_none();
        if options.near == Some(NearRule::Radius) && !is_straight {
            let sentence = "near must be k-nearest along curves: their balls have no measure to take a radius from";
            return Err(out_of_range("near", sentence.to_owned()));
        }
        let rule = options.near.unwrap_or(if is_straight { NearRule::Radius } else { NearRule::KNearest });
        let (mut growth, mut index) = (Growth::new(problem), Index::default());
        for state in std::iter::once(problem.start()).chain(problem.goals()) {
            growth.graph.add_vertex(0, *state);
        }
        index.insert(space, START, problem.start());
        Ok(Self {
            step: step_in(options.step, space.extent())?,
            radius: (rule == NearRule::Radius).then(|| options.radius_factor * radius_of_space(space)),
            aim: Aim::new(*reaching, sampling, space, seed),
            is_informed,
            growth,
            tree: CostTree::of(START),
            index,
            closest: (START, problem.distance_to_goal(problem.start())),
            best: None,
            found: Vec::new(),
        })
    }

    /// The cost that a path has to be below.
    fn bound(&self) -> f64 {
        self.best.map_or(f64::INFINITY, |best| best.cost)
    }

    /// The radius of neighbours for the vertices so far: the least of Solovey et al., theorem 1, with theta = 1/4 and epsilon
    /// and mu going to 0, where the cost of the shortest path is replaced by a bound on it.
    fn near_radius(&self, problem: &Problem<S>, scale: f64) -> f64 {
        let (d, n) = (problem.space().dimension() as f64, Nearest::<S>::len(&self.index) as f64 + 1.0);
        let cost = self.best.map_or_else(|| problem.distance_to_goal(problem.start()), |best| best.cost);
        // gamma = (2 + theta) (cost |X| / ((d + 1) theta zeta))^(1 / (d + 1)), and |X| / zeta = scale^d.
        let gamma = 2.25 * libm::pow(4.0 * cost / (d + 1.0) * libm::pow(scale, d), 1.0 / (d + 1.0));
        (gamma * libm::pow(libm::log(n) / n, 1.0 / (d + 1.0))).min(self.step)
    }

    /// The neighbours of a state, by motions in one direction, into `found`.
    fn find(&mut self, problem: &Problem<S>, direction: Direction, state: &S::State) {
        let (space, states) = (problem.space(), self.growth.graph.states());
        self.growth.counters.nearest_queries += 1;
        match self.radius {
            Some(scale) => {
                let radius = self.near_radius(problem, scale);
                self.index.within_by(space, states, direction, state, radius, &mut self.found);
            }
            None => {
                let k = prm_star_k(Nearest::<S>::len(&self.index) + 1, space.dimension());
                self.index.k_nearest_by(space, states, direction, state, k, &mut self.found);
            }
        }
    }

    fn refuse(&mut self, iteration: u32, from: VertexId, to: Option<VertexId>, state: S::State) {
        self.growth.add_event(EventKind::EdgeRefused, iteration, Some(from), to, state);
    }

    /// The parent of least cost for a state among `nearest` and the neighbours, with the cost of its edge, if that makes the path to the
    /// state cheaper than `bound`. `nearest` comes first: where its motion is not free, that of no neighbour is tried.
    fn parent(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        nearest: Neighbour,
        state: &S::State,
        bound: f64,
    ) -> Option<Neighbour> {
        let origin = self.growth.state(nearest.vertex);
        if !self.growth.is_motion_free(problem, &origin, state) {
            self.refuse(iteration, nearest.vertex, None, *state);
            return None;
        }
        let by = |tree: &CostTree, neighbour: Neighbour| tree.cost(neighbour.vertex) + neighbour.distance;
        let limit = by(&self.tree, nearest).min(bound);
        self.find(problem, Direction::In, state);
        let found = self.found.iter().map(|&neighbour| (by(&self.tree, neighbour), neighbour));
        let mut cheaper: Vec<_> = found.filter(|&(cost, _)| cost < limit).collect();
        cheaper.sort_unstable_by(|(a, x), (b, y)| a.total_cmp(b).then(x.vertex.cmp(&y.vertex)));
        for (_, neighbour) in cheaper {
            let origin = self.growth.state(neighbour.vertex);
            if self.growth.is_motion_free(problem, &origin, state) {
                return Some(neighbour);
            }
            self.refuse(iteration, neighbour.vertex, None, *state);
        }
        (by(&self.tree, nearest) < bound).then_some(nearest)
    }

    /// Makes `parent` the parent of a vertex.
    fn attach(&mut self, iteration: u32, vertex: VertexId, parent: Neighbour) {
        self.growth.graph.add_edge(iteration, parent.vertex, vertex);
        if let Some(former) = self.tree.attach(vertex, parent.vertex, parent.distance) {
            let state = self.growth.state(vertex);
            self.growth.add_event(EventKind::ParentChanged, iteration, Some(vertex), Some(former), state);
        }
    }

    /// Makes a new vertex the parent of a vertex, if the path by way of it is cheaper and the motion free.
    fn offer(&mut self, problem: &Problem<S>, iteration: u32, new: VertexId, vertex: VertexId, distance: f64) {
        if self.tree.cost(new) + distance >= self.tree.cost(vertex) {
            return;
        }
        let [from, to] = [new, vertex].map(|vertex| self.growth.state(vertex));
        if self.growth.is_motion_free(problem, &from, &to) {
            self.attach(iteration, vertex, Neighbour { vertex: new, distance });
        } else {
            self.refuse(iteration, new, Some(vertex), to);
        }
    }

    /// Whether a path through a state may be shorter than the best one, if the way to the state has this cost. Always, unless informed.
    fn may_help(&self, problem: &Problem<S>, cost: f64, state: &S::State) -> bool {
        !self.is_informed || self.best.is_none_or(|best| cost + problem.distance_to_goal(state) < best.cost)
    }

    /// The next sample that may help; `None`, with an event, if there is none among a few.
    fn sample(&mut self, problem: &Problem<S>, iteration: u32) -> Option<S::State> {
        let mut useless = None;
        for _ in 0..DRAWS {
            let target = self.aim.next(problem, iteration, &mut self.growth)?;
            if self.may_help(problem, problem.space().distance(problem.start(), &target), &target) {
                return Some(target);
            }
            useless = Some(target);
        }
        self.growth.reject(EventKind::SampleDiscarded, iteration, useless?);
        None
    }

    /// Takes one sample.
    fn grow(&mut self, problem: &Problem<S>, iteration: u32) {
        let space = problem.space();
        let Some(target) = self.sample(problem, iteration) else { return };
        self.growth.counters.nearest_queries += 1;
        let nearest = self.index.nearest(space, self.growth.graph.states(), &target).expect("a tree has a root");
        let origin = self.growth.state(nearest.vertex);
        let (mut state, mut nearest) = (target, nearest);
        if nearest.distance > self.step {
            state = space.interpolate(&origin, &target, self.step / nearest.distance);
            nearest.distance = space.distance(&origin, &state);
        }
        if let Some(goal) = problem.goals().iter().position(|goal| *goal == state) {
            let goal = VertexId(GOAL + goal as u32);
            if let Some(parent) = self.parent(problem, iteration, nearest, &state, self.tree.cost(goal)) {
                self.attach(iteration, goal, parent);
            }
            return;
        }
        let Some(parent) = self.parent(problem, iteration, nearest, &state, f64::INFINITY) else { return };
        if !self.may_help(problem, self.tree.cost(parent.vertex) + parent.distance, &state) {
            return self.growth.reject(EventKind::SampleDiscarded, iteration, state);
        }
        let vertex = self.growth.graph.add_vertex(iteration, state);
        self.attach(iteration, vertex, parent);
        if !space.is_symmetric() {
            self.find(problem, Direction::Out, &state);
        }
        for neighbour in std::mem::take(&mut self.found) {
            self.offer(problem, iteration, vertex, neighbour.vertex, neighbour.distance);
        }
        self.index.insert(space, vertex, &state);
        for (goal, at) in (GOAL..).zip(problem.goals()) {
            let distance = space.distance(&state, at);
            if distance < self.closest.1 {
                self.closest = (vertex, distance);
            }
            if distance <= self.step {
                self.offer(problem, iteration, vertex, VertexId(goal), distance);
            }
        }
    }

    /// Notes the best path, if it has become cheaper.
    fn note(&mut self, problem: &Problem<S>, iteration: u32) {
        let goals = (GOAL..).zip(problem.goals()).map(|(goal, _)| (self.tree.cost(VertexId(goal)), VertexId(goal)));
        let (cost, goal) = goals.min_by(|(a, _), (b, _)| a.total_cmp(b)).expect("a query has a goal");
        if cost < self.bound() {
            self.best = Some(Best { goal, cost });
            let state = self.growth.state(goal);
            let parent = self.tree.tree().parent(goal);
            self.growth.add_event(EventKind::SolutionFound, iteration, Some(goal), parent, state);
            self.closest = (goal, 0.0);
        }
    }
}

impl<S: Space> Planner<S> for RrtStar<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        self.grow(problem, iteration);
        self.note(problem, iteration);
        Status::Running
    }

    fn cost(&self) -> f64 {
        self.bound()
    }

    fn growth(&self) -> &Growth<S> {
        &self.growth
    }

    fn path(&self) -> Vec<VertexId> {
        self.best.map_or(Vec::new(), |best| self.tree.tree().from_root(best.goal))
    }

    fn approximate_path(&self) -> Vec<VertexId> {
        self.tree.tree().from_root(self.closest.0)
    }
}

/// The radius of a ball whose measure is that of the space, if balls of every size are as they are about the middle of the space: so a
/// ball of radius r has the share (r / radius)^d of the space. O(1): short motions in many directions are measured.
///
/// The share of a ball of radius r is s^d E[(r g / rho)^d] for points drawn in a cube of side s about the middle, where g is how far
/// out in the cube a point is, 0 to 1, and rho its distance: along the direction of each point, the ball ends r g / rho out.
fn radius_of_space<S: Space>(space: &S) -> f64 {
    let (d, middle) = (space.dimension(), space.at(&[0.5; MAX_DIMENSION][..space.dimension()]));
    let mut random = Random::new(0, Stream::Samples);
    let mut sum = 0.0;
    for _ in 0..DIRECTIONS {
        let mut unit = [0.0; MAX_DIMENSION];
        let mut out = 0.0f64;
        for x in &mut unit[..d] {
            let offset = 2.0 * random.uniform() - 1.0;
            out = out.max(offset.abs());
            *x = 0.5 + LENGTH / 2.0 * offset;
        }
        let distance = space.distance(&middle, &space.at(&unit[..d]));
        sum += libm::pow(LENGTH * out / distance, d as f64);
    }
    libm::pow(sum / DIRECTIONS as f64, -1.0 / d as f64)
}
