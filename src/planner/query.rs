//! A search of a roadmap for a path: algorithm, cost of an edge, estimate of the remaining cost.

use crate::graph::search::{
    BestFirst, Bidirectional, BreadthFirst, Expansion, Goals, Parents, Requeued, Stale, View, Walker,
};
use crate::graph::{Adjacency, Graph, VertexId};
use crate::problem::Problem;
use crate::space::Space;

crate::choice! {
    /// Which search.
    pub enum Algorithm {
        /// A*.
        AStar,
        /// Dijkstra's.
        Dijkstra,
        /// Breadth-first.
        BreadthFirst,
        /// Bidirectional breadth-first, by whole levels.
        Bidirectional,
        /// Bidirectional breadth-first with the fault of a course report, which visits more vertices than there are.
        BidirectionalRequeued,
        /// A* with the fault of a course report: what waits keeps its place and its parent when a cheaper way is found.
        AStarStale,
        /// From the goal from parent to parent, where each edge of the roadmap has overwritten the parent of its later end, as in
        /// a course report: it may miss the start.
        Parents,
    }
}

crate::choice! {
    /// What an edge costs.
    pub enum Cost {
        /// Its length in the metric of the space, and what the nearness of obstacles adds.
        Metric,
        /// 1.
        Hops,
    }
}

crate::choice! {
    /// The estimate of the cost to the goal in A*.
    pub enum Heuristic {
        /// The distance in the metric.
        Metric,
        /// The distance of the end effector from its goal, scaled so that it never exceeds the distance in the metric.
        EndEffector,
        /// The distance in the metric as a number of hops, as in a course report: not admissible, so the path may have
        /// more edges than it needs.
        MetricAsHops,
        /// The sum of the differences of coordinates without wrap-around, as in a course report: not admissible, so the path
        /// may be longer than it need be.
        Naive,
        /// 0.
        None,
    }
}

crate::options! {
    /// How a roadmap is searched.
    pub struct Searching for crate::options::ALL;
    /// Graph search: A* is guided, bidirectional starts at both ends; requeued, stale and parents are faulty.
    search: Algorithm = Algorithm::AStar, "Search";
    /// Cost that A* and Dijkstra minimise: path length or number of edges; breadth-first always counts edges.
    cost: Cost = Cost::Metric, "Cost of an edge";
    /// Estimate of the remaining cost in A*: good ones save work; metric-as-hops and naive may miss the best.
    heuristic: Heuristic = Heuristic::Metric, "Heuristic";
}

/// Less than 1 by more than the rounding of an estimate, so that no estimate exceeds a true cost.
const BELOW: f64 = 1.0 - 1e-12;

/// A running search.
pub(super) struct Query {
    adjacency: Adjacency,
    walker: Box<dyn Walker + Send>,
    rules: Searching,
    goals: Goals,
    /// The factor of estimates.
    scale: f64,
}

/// The sum of the differences of the coordinates, angles in [0, 2 pi).
fn unwrapped<S: Space>(space: &S, a: &S::State, b: &S::State) -> f64 {
    let along = |i: usize, x: f64| if x < 0.0 && space.period(i).is_finite() { x + space.period(i) } else { x };
    let pairs = space.coordinates(a).iter().zip(space.coordinates(b)).enumerate();
    pairs.map(|(i, (&a, &b))| (along(i, b) - along(i, a)).abs()).sum()
}

impl Query {
    /// A search over the graph's edges and `added` ones, along their direction if the space is not symmetric, from one vertex
    /// to any of the goals; `more` are the states of vertices numbered after the graph's.
    pub fn new<S: Space>(
        space: &S,
        graph: &Graph<S>,
        added: &[[VertexId; 2]],
        more: &[S::State],
        start: VertexId,
        goals: Goals,
        rules: Searching,
    ) -> Self {
        let vertices = graph.states().len() + more.len();
        let walker: Box<dyn Walker + Send> = match rules.search {
            Algorithm::AStar | Algorithm::Dijkstra => Box::new(BestFirst::new(vertices, start, goals.clone())),
            Algorithm::BreadthFirst => Box::new(BreadthFirst::new(vertices, start, goals.clone())),
            Algorithm::Bidirectional => Box::new(Bidirectional::new(vertices, start, goals.clone())),
            Algorithm::BidirectionalRequeued => Box::new(Requeued::new(vertices, start, goals.clone())),
            Algorithm::AStarStale => Box::new(Stale::new(vertices, start, goals.clone())),
            Algorithm::Parents => {
                Box::new(Parents::new(vertices, graph.edges().iter().chain(added), start, goals.clone()))
            }
        };
        let scale = match (rules.cost, rules.heuristic) {
            (Cost::Hops, Heuristic::Metric | Heuristic::EndEffector) => {
                let length = |&[a, b]: &[VertexId; 2]| space.distance(state(graph, more, a), state(graph, more, b));
                let longest = graph.edges().iter().chain(added).map(length).fold(0.0, f64::max);
                if longest > 0.0 { BELOW / longest } else { 0.0 }
            }
            (Cost::Metric, Heuristic::EndEffector) => BELOW,
            _ => 1.0,
        };
        let adjacency = Adjacency::new(vertices, graph.edges(), added, !space.is_symmetric());
        Self { adjacency, walker, rules, goals, scale }
    }

    /// Expands one vertex.
    pub fn step<S: Space>(&mut self, problem: &Problem<S>, graph: &Graph<S>, more: &[S::State]) -> Expansion {
        let space = problem.space();
        let at = |vertex| state(graph, more, vertex);
        let distance = |a: VertexId, b: VertexId| space.distance(at(a), at(b));
        let (goals, scale, rules) = (&self.goals, self.scale, self.rules);
        // The least estimate over all goals is an estimate, too.
        let least = |estimate: &dyn Fn(VertexId) -> f64| {
            (goals.start.0..goals.end.0).map(|goal| estimate(VertexId(goal))).fold(f64::INFINITY, f64::min)
        };
        let cost = |a, b| if rules.cost == Cost::Metric { problem.cost(at(a), at(b)) } else { 1.0 };
        let is_guided = matches!(rules.search, Algorithm::AStar | Algorithm::AStarStale);
        let heuristic = |vertex| match (is_guided, rules.heuristic, &problem.end_effector) {
            (true, Heuristic::Metric | Heuristic::MetricAsHops, _) => scale * least(&|goal| distance(vertex, goal)),
            (true, Heuristic::EndEffector, Some(estimate)) => scale * least(&|goal| estimate(at(vertex), at(goal))),
            (true, Heuristic::Naive, _) => least(&|goal| unwrapped(space, at(vertex), at(goal))),
            _ => 0.0,
        };
        self.walker.step(&View { adjacency: &self.adjacency, cost: &cost, heuristic: &heuristic })
    }

    /// Whether there is no path if a step has returned `Nothing`.
    pub fn is_exhaustive(&self) -> bool {
        self.walker.is_exhaustive()
    }

    /// How many vertices were expanded again.
    pub fn reopened(&self) -> u64 {
        self.walker.reopened()
    }

    /// The vertices of the path, once the goal is reached.
    pub fn path(&self) -> Vec<VertexId> {
        self.walker.path()
    }
}

/// The state of a vertex of the graph, or of those numbered after them.
pub(super) fn state<'a, S: Space>(graph: &'a Graph<S>, more: &'a [S::State], vertex: VertexId) -> &'a S::State {
    let count = graph.states().len();
    if vertex.index() < count { graph.state(vertex) } else { &more[vertex.index() - count] }
}
