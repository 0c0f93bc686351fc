//! AORRTC: RRT-Connect again and again, each time for a path shorter than the best one.
//!
//! Wilson, Thomason, Kingston and Gammell 2025, "AORRTC: almost-surely asymptotically optimal planning with RRT-Connect", on the
//! scheme AO-x of Hauser and Zhou 2016, "Asymptotically optimal planning by feasible kinodynamic planning in a state-cost space".
//! The first search is RRT-Connect. Every further one begins two new trees in the space of states and costs: a sample has a
//! random cost, within which it can be reached and the path stay shorter than the best, and is approached from the nearest vertex
//! that keeps within it. A new vertex gets cheaper parents by further random costs as long as their motions are free. Each path
//! found is shortened before the next search.
//!
//! Differences: a search reuses the roots of the one before; vertices of former searches that are on no path are reported as
//! removed; the path is shortened by removing vertices and by random shortcuts, one attempt per iteration.

use super::groups::Termination;
use super::growth::{Growth, START};
use super::info::{END, Grows, IMPROVE, Mark, NONE_FOUND, PlannerInfo, PlannerKind, line};
use super::rrt_connect::{RrtConnect, RrtConnectOptions};
use super::{Planner, Status};
use crate::error::Error;
use crate::graph::{EventKind, VertexId};
use crate::nearest::{Nearest, Neighbour, Query};
use crate::problem::Problem;
use crate::random::{MAX_SEED, Random, Stream};
use crate::shortening::{Improvement, Wanted};
use crate::space::Space;

/// A path that is shorter by less than this share is no better: that might be rounding.
const GAIN: f64 = 1e-9;

/// How many neighbours are asked for: more each time that there may be a better one beyond.
const NEIGHBOURS: [usize; 3] = [8, 32, 128];

/// How many times a new vertex gets another parent at most.
const PARENTS: u32 = 10;

crate::options! {
    /// Options of AORRTC.
    pub struct AorrtcOptions for crate::options::ALL;
    /// Number of shortcuts tried on each path that is found, before the next search: few leave more work to searches.
    path_shortcuts: u64 = 50, in 0.0..=1e6, "Shortcuts per path";
    /// When it stops.
    termination: Termination = Termination { improve_iterations: 10_000, ..Default::default() };
    /// Those of RRT-Connect.
    trees: RrtConnectOptions;
}

impl PlannerKind for AorrtcOptions {
    const NEEDS_SYMMETRY: bool = true;
    const INFO: PlannerInfo = PlannerInfo {
        id: "aorrtc",
        title: "AORRTC",
        summary: "RRT-Connect again and again, each time for a path shorter than the best one, which is then shortened.",
        guarantee: "Almost-surely asymptotically optimal: with more iterations the path approaches the shortest.",
        grows: Grows::Trees,
        presets: &[],
        pseudocode: &[
            line(0, "the first path ← RRT-Connect", &[Mark::Growing]),
            NONE_FOUND,
            line(0, "repeat, c ← the length of the best path:", &[Mark::Improving]),
            line(1, "shorten the path; begin two new trees", &[Mark::Removed]),
            line(1, "q ← a sample with start – q – goal below c", &[Mark::Vertex, Mark::Refused, Mark::Discarded]),
            line(1, "b ← a random cost for q that may lead below c", &[Mark::Vertex, Mark::Refused]),
            line(1, "new ← a step to q, from a vertex within b", &[Mark::Vertex, Mark::Refused]),
            line(1, "parent of new ← a cheaper one, b after b", &[Mark::Vertex, Mark::Edge]),
            line(1, "the other tree goes to new, if below c", &[Mark::Vertex, Mark::Edge]),
            line(2, "if it arrives: a shorter path", &[Mark::Solved]),
            IMPROVE,
            END,
        ],
    };

    /// # Panics
    /// If the space is not symmetric.
    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        assert!(problem.space().is_symmetric(), "AORRTC requires a symmetric space");
        Ok(Box::new(Aorrtc {
            trees: RrtConnect::new(problem, &self.trees, seed)?,
            wanted: Wanted { reduce: self.path_shortcuts > 0, shortcuts: self.path_shortcuts, ..Wanted::default() },
            random: Random::new(seed, Stream::Costs),
            goals: problem.goals().len() as u32,
            cost: f64::INFINITY,
            shortening: None,
            costs: Vec::new(),
            present: Vec::new(),
            first: 0,
            found: Vec::new(),
        }))
    }
}

/// The planner. An iteration takes one sample, as in RRT-Connect, or tries to shorten the path once.
struct Aorrtc<S: Space> {
    trees: RrtConnect<S>,
    /// How each path is shortened.
    wanted: Wanted,
    /// Draws the costs of samples, and the seeds of shortcuts.
    random: Random,
    /// How many goals there are: the vertices from 1 on.
    goals: u32,
    /// The cost of the best path.
    cost: f64,
    /// The best path, while it is being shortened.
    shortening: Option<Improvement<S>>,
    /// By vertex of the present trees: the cost of the path between it and its root.
    costs: Vec<f64>,
    /// The vertices of the best path that are older than the present trees.
    present: Vec<VertexId>,
    /// The first vertex of the present trees that is no root.
    first: u32,
    found: Vec<Neighbour>,
}

/// A vertex of a tree, and the least cost that it gives to a state that is connected to it: as if only lengths counted.
#[derive(Debug, Clone, Copy)]
struct Parent {
    vertex: VertexId,
    cost: f64,
}

impl<S: Space> Aorrtc<S> {
    /// The cost that a better path has to be below.
    fn bound(&self) -> f64 {
        self.cost * (1.0 - GAIN)
    }

    /// The cost of the path from the root to a vertex and on to a state.
    fn cost_by(&self, problem: &Problem<S>, vertex: VertexId, state: &S::State) -> f64 {
        self.costs[vertex.index()] + problem.cost(self.trees.growth.graph.state(vertex), state)
    }

    /// The vertex of a tree that is nearest to the state in space and cost, if the cost of the state is to be at most `most`: the
    /// nearest of many, or else a root. O(log vertices).
    fn nearest(&mut self, space: &S, tree: usize, state: &S::State, most: f64) -> Option<Parent> {
        self.trees.growth.counters.nearest_queries += 1;
        for k in NEIGHBOURS {
            let query = Query::to(space, self.trees.growth.graph.states(), state);
            let visited = self.trees.indices[tree].k_nearest(query, k, &mut self.found);
            self.trees.growth.note_visited(space, visited);
            let fits = self.found.iter().filter_map(|&Neighbour { vertex, distance }| {
                let from = self.costs[vertex.index()];
                let parent = Parent { vertex, cost: from + distance };
                (parent.cost <= most).then_some((libm::hypot(distance, most - from), parent))
            });
            let best = fits.min_by(|(a, x), (b, y)| a.total_cmp(b).then(x.vertex.cmp(&y.vertex)));
            // A vertex that fits is as far in cost as in space at least.
            let next = self.found.last().map_or(0.0, |farthest| farthest.distance * f64::sqrt(2.0));
            let is_all = self.found.len() < k || Some(&k) == NEIGHBOURS.last();
            match best {
                Some((apart, parent)) if is_all || apart <= next => return Some(parent),
                None if is_all => break,
                _ => {}
            }
        }
        let roots = if tree == 0 { 0..1 } else { 1..1 + self.goals };
        let states = &self.trees.growth.graph;
        let roots = roots.map(VertexId).map(|at| Parent { vertex: at, cost: space.distance(states.state(at), state) });
        roots.min_by(|a, b| a.cost.total_cmp(&b.cost)).filter(|root| root.cost <= most)
    }

    /// The distances of a state from the root of a tree and to that of the other one: the least costs.
    fn least_costs(problem: &Problem<S>, tree: usize, state: &S::State) -> [f64; 2] {
        let mut both = problem.distances_through(state);
        both.rotate_left(tree);
        both
    }

    /// A parent for a new state of a tree, at least as cheap as the one given.
    fn parent(
        &mut self,
        problem: &Problem<S>,
        iteration: u32,
        tree: usize,
        mut parent: Parent,
        state: &S::State,
    ) -> Parent {
        let [least, _] = Self::least_costs(problem, tree, state);
        for _ in 0..PARENTS {
            let most = least + self.random.uniform() * (parent.cost - least);
            let Some(other) = self.nearest(problem.space(), tree, state, most) else { break };
            if other.vertex == parent.vertex || other.cost >= parent.cost {
                break;
            }
            let growth = &mut self.trees.growth;
            let origin = growth.state(other.vertex);
            if !growth.is_motion_free(problem, &origin, state) {
                growth.add_event(EventKind::EdgeRefused, iteration, Some(other.vertex), None, *state);
                break;
            }
            let cost = other.cost + problem.validity().nearness_cost(&origin, state);
            if cost >= parent.cost {
                break;
            }
            parent = Parent { cost, ..other };
        }
        parent
    }

    /// Takes one sample for a path that is shorter than the best; whether there is one.
    fn search(&mut self, problem: &Problem<S>, iteration: u32) -> Option<()> {
        let (space, bound, trees) = (problem.space(), self.bound(), &mut self.trees);
        let draw = |growth: &mut Growth<S>| Some(growth.draw(problem, iteration, &mut *trees.sampler)?.state);
        let sample = trees.growth.draw_within(problem, iteration, bound, draw)?;
        let tree = trees.next_turn();
        let [come, go] = Self::least_costs(problem, tree, &sample);
        let most = come + self.random.uniform() * (bound - come - go);
        let near = self.nearest(space, tree, &sample, most)?;
        let state = self.trees.extend(problem, iteration, tree, near.vertex, &sample)?;
        let cost = self.cost_by(problem, near.vertex, &state);
        let parent = self.parent(problem, iteration, tree, Parent { cost, ..near }, &state);
        let added = self.trees.add_vertex(space, tree, iteration, Some(parent.vertex), state);
        self.costs.push(parent.cost);
        let near = self.nearest(space, 1 - tree, &state, bound - parent.cost)?;
        let reached = self.trees.connect(problem, iteration, 1 - tree, near.vertex, added);
        for vertex in self.costs.len()..self.trees.growth.graph.states().len() {
            let vertex = VertexId(vertex as u32);
            let parent = self.trees.forest.parent(vertex).expect("a new vertex is no root");
            let state = self.trees.growth.state(vertex);
            self.costs.push(self.cost_by(problem, parent, &state));
        }
        let reached = reached?;
        let last = problem.cost(self.trees.growth.graph.state(reached), &state);
        let total = parent.cost + self.costs[reached.index()] + last;
        (total < bound).then(|| self.trees.meet(iteration, tree, added, reached))
    }

    /// Notes the path that was found, which is to be shortened.
    fn arrive(&mut self, problem: &Problem<S>, iteration: u32) {
        let states: Vec<_> = self.trees.path().into_iter().map(|vertex| self.trees.growth.state(vertex)).collect();
        self.cost = problem.path_cost(&states);
        let shortening = Improvement::new(states, self.wanted, self.random.bits() & MAX_SEED);
        self.go_on(problem, iteration, shortening);
    }

    /// Tries once to shorten the path.
    fn shorten(&mut self, problem: &Problem<S>, iteration: u32, mut shortening: Improvement<S>) {
        let before = shortening.motion_checks;
        shortening.attempt(problem);
        self.trees.growth.counters.motion_checks += shortening.motion_checks - before;
        self.go_on(problem, iteration, shortening);
    }

    /// Keeps a path that is to be shortened further, or begins the next search with it.
    fn go_on(&mut self, problem: &Problem<S>, iteration: u32, shortening: Improvement<S>) {
        if shortening.is_done() {
            self.restart(problem, iteration, shortening.path());
        } else {
            self.shortening = Some(shortening);
        }
    }

    /// Adds the shortened path to the graph, if it is better, and begins two new trees.
    fn restart(&mut self, problem: &Problem<S>, iteration: u32, path: &[S::State]) {
        let (space, bound, trees) = (problem.space(), self.bound(), &mut self.trees);
        let shortened = problem.path_cost(path);
        if shortened < bound {
            let goal = trees.bridge.map(|[_, goal_side]| trees.forest.to_root(goal_side));
            let goal = goal.and_then(|way| way.last().copied()).expect("a path was found");
            let mut end = START;
            for state in &path[1..path.len() - 1] {
                end = trees.add_vertex(space, 0, iteration, Some(end), *state);
            }
            trees.meet(iteration, 0, end, goal);
            self.cost = shortened;
        }
        let mut stays = trees.path();
        stays.sort_unstable();
        let roots = 1 + self.goals;
        let count = trees.growth.graph.states().len() as u32;
        let present = std::mem::take(&mut self.present);
        for vertex in present.into_iter().chain((self.first.max(roots)..count).map(VertexId)) {
            if stays.binary_search(&vertex).is_err() {
                let state = trees.growth.state(vertex);
                trees.growth.add_event(EventKind::VertexRemoved, iteration, Some(vertex), None, state);
            }
        }
        stays.retain(|vertex| vertex.0 >= roots);
        (self.present, self.first) = (stays, count);
        self.costs.resize(count as usize, 0.0);
        trees.restart(problem);
    }
}

impl<S: Space> Planner<S> for Aorrtc<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if let Some(shortening) = self.shortening.take() {
            self.shorten(problem, iteration, shortening);
            return Status::Running;
        }
        let is_found = if self.cost < f64::INFINITY {
            self.search(problem, iteration).is_some()
        } else {
            self.trees.iterate(problem, iteration) == Status::Solved
        };
        if is_found {
            self.arrive(problem, iteration);
        }
        Status::Running
    }

    fn cost(&self) -> f64 {
        self.cost
    }

    fn growth(&self) -> &Growth<S> {
        &self.trees.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.trees.growth
    }

    fn path(&self) -> Vec<VertexId> {
        self.trees.path()
    }
}
