//! RRT*: a tree whose paths approach the shortest as it grows.
//!
//! Karaman and Frazzoli 2011, "Sampling-based algorithms for optimal motion planning"; the radius of Solovey, Janson, Schmerling,
//! Frazzoli and Pavone 2020, "Revisiting the asymptotic optimality of RRT*".

use super::best_tree::BestTree;
use super::groups::{Aim, EdgeOptions, GoalBias, Sampling, Termination};
use super::growth::{Growth, START, goals};
use super::info::{DIRECT, END_NEAR, Grows, IMPROVE, Mark, NONE_FOUND, PlannerInfo, PlannerKind, line};
use super::near::{Near, NearRule, Nearness, Order, find_near};
use super::stride::Strides;
use super::{Planner, Status};
use crate::error::Error;
use crate::graph::{EventKind, VertexId};
use crate::nearest::{Direction, Index, Nearest, Neighbour};
use crate::problem::Problem;
use crate::space::Space;

crate::options! {
    /// How a tree is rewired.
    pub struct Rewiring for crate::options::ALL;
    /// Longest step, and distance at which the goal is tried: short steps follow bends, long ones are fast.
    step: Option<f64>, in 1e-6..=1e7, "Step", unit "distance in the metric",
        else "it adapts to the scene: a fifth of the largest distance in the space at first, half as long where that is refused";
    /// Which vertices are neighbours of a new one.
    nearness: Nearness;
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
            DIRECT,
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
pub(super) const REWIRE: super::PseudocodeLine = line(1, "new ← parent of those nearer through it", &[Mark::Rewired]);
pub(super) const ARRIVE: super::PseudocodeLine = line(1, "within a step of the goal, try new – goal", &[Mark::Solved]);

/// The most motions to neighbours that an iteration tries.
const MOST_TRIED: usize = 1000;

/// The planner. An iteration takes one sample; if very many neighbours are to be tried, the next ones go on with it.
pub(super) struct RrtStar<S: Space> {
    strides: Strides,
    near: Near,
    aim: Aim<S>,
    /// Whether samples and vertices that cannot shorten the path are discarded.
    is_informed: bool,
    best: BestTree<S>,
    /// The vertices of the tree without the goals.
    index: Index,
    found: Vec<Neighbour>,
    /// What is left to do for the last sample.
    pending: Option<Pending<S::State>>,
}

/// A sample whose motions are tried in several iterations.
enum Pending<T> {
    Choosing(Choosing<T>),
    Offering(Offering),
}

/// A new state, or a goal, that wants a parent.
struct Choosing<T> {
    state: T,
    goal: Option<VertexId>,
    /// The nearest vertex: the motion from it is free.
    nearest: Neighbour,
    /// The neighbours from which the path would be cheaper and that are still to be tried, the cheapest first, with the costs.
    cheaper: std::vec::IntoIter<(f64, Neighbour)>,
}

/// A new vertex that may become the parent of neighbours, of which these are still to be tried.
struct Offering {
    vertex: VertexId,
    found: std::vec::IntoIter<Neighbour>,
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
        let (space, mut index) = (problem.space(), Index::default());
        index.insert(space, START, problem.start());
        Ok(Self {
            near: Near::new(problem, options.nearness, NearRule::Radius)?,
            strides: Strides::new(options.step, space.extent())?,
            aim: Aim::new(*reaching, sampling, space, seed),
            is_informed,
            best: BestTree::new(problem),
            index,
            found: Vec::new(),
            pending: None,
        })
    }

    /// The neighbours of a state, by motions in one direction, into `found`.
    fn find(&mut self, problem: &Problem<S>, direction: Direction, state: &S::State) {
        let cost = match self.best.bound() {
            f64::INFINITY => problem.distance_to_goal(problem.start()),
            cost => cost,
        };
        let near = self.near.in_tree(Nearest::<S>::len(&self.index) + 1, cost, self.strides.longest());
        find_near(
            problem,
            &mut self.best.growth,
            &self.index,
            (direction, state),
            (near, Order::Sorted),
            &mut self.found,
        );
    }

    /// Whether a path through a state may be shorter than the best one, if the way to the state has this cost. Always, unless
    /// informed.
    fn may_help(&self, problem: &Problem<S>, cost: f64, state: &S::State) -> bool {
        let bound = self.best.bound();
        !self.is_informed || bound == f64::INFINITY || cost + problem.distance_to_goal(state) < bound
    }

    /// What the path to a neighbour and on costs, if the motion on costs its `distance`.
    fn cost_by(&self, neighbour: Neighbour) -> f64 {
        self.best.tree.cost(neighbour.vertex) + neighbour.distance
    }

    /// Takes one sample, as far as the nearest vertex: `None` if the motion from there is not free. Then that of no neighbour is
    /// tried.
    fn begin(&mut self, problem: &Problem<S>, iteration: u32) -> Option<Choosing<S::State>> {
        let space = problem.space();
        let bound = if self.is_informed { self.best.bound() } else { f64::INFINITY };
        let draw = |growth: &mut Growth<S>| self.aim.next(problem, iteration, growth);
        let target = self.best.growth.draw_within(problem, iteration, bound, draw)?;
        let mut nearest = self.best.growth.nearest(space, &self.index, Direction::In, &target);
        let origin = self.best.growth.state(nearest.vertex);
        let mut state = target;
        let step = self.strides.of(nearest.vertex);
        if nearest.distance > step {
            state = space.interpolate(&origin, &target, step / nearest.distance);
            nearest.distance = space.distance(&origin, &state);
        }
        let goal = goals(problem).find(|(_, goal)| **goal == state).map(|(goal, _)| goal);
        if !self.best.growth.is_motion_free(problem, &origin, &state) {
            self.strides.refused(nearest.vertex);
            self.best.refuse(iteration, nearest.vertex, None, state);
            return None;
        }
        nearest = self.best.priced(problem, nearest, &state);
        let limit = self.cost_by(nearest).min(goal.map_or(f64::INFINITY, |goal| self.best.tree.cost(goal)));
        self.find(problem, Direction::In, &state);
        let found = self.found.iter().filter(|&&near| self.cost_by(near) < limit);
        let priced = found.map(|&near| self.best.priced(problem, near, &state));
        let costs = priced.map(|near| (self.cost_by(near), near));
        let mut cheaper: Vec<_> = costs.filter(|&(cost, _)| cost < limit).collect();
        by_cost(&mut cheaper);
        Some(Choosing { state, goal, nearest, cheaper: cheaper.into_iter() })
    }

    /// Attaches a new vertex, or the goal, to the cheapest parent whose motion is free. `None` if it cannot be cheaper, is the
    /// goal, or if too many motions were tried: then that goes on in the next iteration.
    fn choose(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        mut choosing: Choosing<S::State>,
        left: &mut usize,
    ) -> Option<Offering> {
        let Choosing { state, goal, nearest, .. } = choosing;
        let mut parent = nearest;
        while let Some(&(_, neighbour)) = choosing.cheaper.as_slice().first() {
            if *left == 0 {
                self.pending = Some(Pending::Choosing(choosing));
                return None;
            }
            *left -= 1;
            choosing.cheaper.next();
            let origin = self.best.growth.state(neighbour.vertex);
            if self.best.growth.is_motion_free(problem, &origin, &state) {
                parent = neighbour;
                break;
            }
            self.best.refuse(iteration, neighbour.vertex, None, state);
        }
        let cost = self.cost_by(parent);
        if let Some(goal) = goal {
            if cost < self.best.tree.cost(goal) {
                self.best.attach(iteration, goal, parent);
            }
            return None;
        }
        if !self.may_help(problem, cost, &state) {
            self.best.growth.reject(EventKind::SampleDiscarded, iteration, state);
            return None;
        }
        let vertex = self.best.growth.graph.add_vertex(iteration, state);
        self.best.attach(iteration, vertex, parent);
        self.strides.free(nearest.vertex, vertex);
        if !problem.space().is_symmetric() {
            self.find(problem, Direction::Out, &state);
        }
        Some(Offering { vertex, found: std::mem::take(&mut self.found).into_iter() })
    }

    /// Makes a new vertex the parent of a vertex at a distance, if the path through it is cheaper and the motion free.
    fn offer(&mut self, problem: &Problem<S>, iteration: u32, new: VertexId, to: Neighbour) {
        let (near, former) = (Neighbour { vertex: new, ..to }, self.best.tree.cost(to.vertex));
        if self.cost_by(near) >= former {
            return;
        }
        let parent = self.best.priced(problem, near, self.best.growth.graph.state(to.vertex));
        if self.cost_by(parent) < former {
            self.best.try_parent(problem, iteration, to.vertex, parent);
        }
    }

    /// Offers a new vertex to its neighbours and to the goals; goes on in the next iteration if too many motions were tried.
    fn offer_all(&mut self, problem: &Problem<S>, iteration: u32, mut offering: Offering, left: usize) {
        let (vertex, before) = (offering.vertex, self.best.growth.counters.motion_checks);
        while let Some(&neighbour) = offering.found.as_slice().first() {
            if self.best.growth.counters.motion_checks - before >= left as u64 {
                self.pending = Some(Pending::Offering(offering));
                return;
            }
            offering.found.next();
            self.offer(problem, iteration, vertex, neighbour);
        }
        let (space, state) = (problem.space(), self.best.growth.state(vertex));
        self.index.insert(space, vertex, &state);
        for (goal, at) in goals(problem) {
            let distance = space.distance(&state, at);
            self.best.approach(vertex, distance);
            if distance <= self.strides.longest() {
                self.offer(problem, iteration, vertex, Neighbour { vertex: goal, distance });
            }
        }
    }

    /// Takes one sample, or goes on with the last one.
    fn grow(&mut self, problem: &Problem<S>, iteration: u32) {
        let mut left = MOST_TRIED;
        let offering = match self.pending.take() {
            Some(Pending::Offering(offering)) => Some(offering),
            Some(Pending::Choosing(choosing)) => self.choose(problem, iteration, choosing, &mut left),
            None => {
                self.begin(problem, iteration).and_then(|choosing| self.choose(problem, iteration, choosing, &mut left))
            }
        };
        if let Some(offering) = offering {
            self.offer_all(problem, iteration, offering, left);
        }
    }
}

impl<S: Space> Planner<S> for RrtStar<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        self.grow(problem, iteration);
        self.best.note(problem, iteration);
        Status::Running
    }

    fn cost(&self) -> f64 {
        self.best.bound()
    }

    fn growth(&self) -> &Growth<S> {
        &self.best.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.best.growth
    }

    fn path(&self) -> Vec<VertexId> {
        self.best.path()
    }

    fn approximate_path(&self) -> Vec<VertexId> {
        self.best.approximate_path()
    }
}

/// Sorts neighbours by what the path through them costs. Not in the planner, which is compiled for several spaces.
fn by_cost(neighbours: &mut [(f64, Neighbour)]) {
    neighbours.sort_unstable_by(|(a, x), (b, y)| a.total_cmp(b).then(x.vertex.cmp(&y.vertex)));
}
