//! BIT*: batches of samples, each searched for a better path in the order of what paths may cost at best.
//!
//! Gammell, Srinivasa and Barfoot 2015, "Batch Informed Trees (BIT*): sampling-based optimal planning via the heuristically
//! guided search of implicit random geometric graphs"; Gammell, Barfoot and Srinivasa 2020, "Batch Informed Trees (BIT*):
//! informed asymptotically optimal anytime search". Vertices and edges are in one queue: a vertex comes before all edges from it,
//! as none of them promises a shorter path. Differences: the first batch is of the start and the goals alone, without samples;
//! edges from vertices expanded before to a new sample are queued with the sample; a vertex that cannot help leaves the tree at
//! the end of the batch that shows it, if it has no children.

use super::best_tree::BestTree;
use super::groups::{EdgeOptions, Sampling, Termination};
use super::growth::{GOAL, Growth, START};
use super::info::{END_NEAR, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, line};
use super::near::{Near, NearRule, Nearness, Order, find_near};
use super::{Phase, Planner, Status};
use crate::error::Error;
use crate::graph::{Ordered, VertexId};
use crate::nearest::{Direction, Index, Nearest, Neighbour, Neighbourhood};
use crate::problem::Problem;
use crate::sampling::{Known, Sample, Sampler};
use crate::space::Space;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

crate::options! {
    /// Options of BIT*.
    pub struct BitStarOptions for crate::options::ALL;
    /// Number of samples of a batch: few give a first path soon, many are searched with less waste.
    batch_size: usize = 100, in 1.0..=1e6, "Batch";
    /// Which vertices are neighbours.
    nearness: Nearness;
    /// Where samples come from.
    sampling: Sampling;
    /// When it stops.
    termination: Termination = Termination { improve_iterations: 10_000, ..Default::default() };
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

impl PlannerKind for BitStarOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "bit-star",
        title: "BIT*",
        summary: "Draws batches of samples that can shorten the path, and searches each by the edge that promises most.",
        guarantee: "Asymptotically optimal: with more batches the path approaches the shortest.",
        grows: Grows::Tree,
        presets: &[],
        pseudocode: &[
            line(0, "T ← {start}; Q ← {start}; repeat:", &[]),
            line(1, "if Q is empty: remove what cannot help,", &[Mark::Removed]),
            line(2, "draw a batch that may help, Q ← vertices", &[Mark::Sampling, Mark::Vertex]),
            line(2, "without those that collide, or cannot help", &[Mark::Rejected, Mark::Discarded]),
            line(1, "take from Q what promises the shortest path", &[Mark::Growing, Mark::Improving]),
            line(1, "vertex: Q ← its edges that may help", &[Mark::Expanded]),
            line(1, "edge: if it may help, try it", &[]),
            line(2, "if it is not free: reject it", &[Mark::Refused]),
            line(2, "else: add it, in place of a worse one", &[Mark::Edge, Mark::Rewired]),
            line(2, "at a goal: the best path so far", &[Mark::Solved]),
            IMPROVE,
            END_NEAR,
        ],
    };

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let mut bit = BitStar {
            near: Near::new(problem, self.nearness, NearRule::Radius)?,
            sampler: self.sampling.sampler(problem.space(), seed),
            batch_size: self.batch_size,
            missing: 0,
            best: BestTree::new(problem),
            members: Vec::new(),
            index: Index::default(),
            nodes: Vec::new(),
            draws: 0,
            useful: Vec::new(),
            neighbourhood: Neighbourhood::Within(f64::INFINITY),
            queue: BinaryHeap::new(),
            found: Vec::new(),
        };
        for (vertex, state) in (START.0..).zip(bit.best.growth.graph.states().to_vec()) {
            bit.insert(problem, VertexId(vertex), &state, Node::of(problem, &state));
        }
        bit.queue_vertex(START);
        Ok(Box::new(bit))
    }
}

/// What is known about a vertex or a sample.
#[derive(Debug, Clone, Copy)]
struct Node {
    /// The distance from the start.
    from_start: f64,
    /// The distance to the nearest goal.
    to_goal: f64,
    /// Whether edges from it were queued.
    is_expanded: bool,
    /// Whether it may still be on a better path.
    is_useful: bool,
}

impl Node {
    /// A vertex or a sample in this state, which is new.
    fn of<S: Space>(problem: &Problem<S>, state: &S::State) -> Self {
        let [from_start, to_goal] = problem.distances_through(state);
        Self { from_start, to_goal, is_expanded: false, is_useful: true }
    }

    /// The least cost of a path through it.
    fn least(self) -> f64 {
        self.from_start + self.to_goal
    }
}

/// An entry of the queue: the least cost of a path through it, the cost of reaching its end, the vertex, and of an edge the
/// vertex that it leads to with its length. The least comes first.
type Entry = Reverse<(Ordered, Ordered, VertexId, Option<(VertexId, Ordered)>)>;

/// The planner. An iteration draws one sample, expands one vertex or tries one edge.
struct BitStar<S: Space> {
    near: Near,
    sampler: Box<dyn Sampler<S>>,
    batch_size: usize,
    /// How many samples of the present batch are still to be drawn.
    missing: usize,
    best: BestTree<S>,
    /// The start, the goals, and the vertices and samples that may be on a better path.
    members: Vec<VertexId>,
    /// The members, and some that were.
    index: Index,
    nodes: Vec<Node>,
    /// How many samples were drawn in all, free or not.
    draws: usize,
    /// Of each of them that may help, the least cost of a path through it.
    useful: Vec<f64>,
    /// The neighbours of a vertex in this batch.
    neighbourhood: Neighbourhood,
    queue: BinaryHeap<Entry>,
    found: Vec<Neighbour>,
}

impl<S: Space> BitStar<S> {
    /// Adds a vertex of the graph to the samples.
    fn insert(&mut self, problem: &Problem<S>, vertex: VertexId, state: &S::State, node: Node) {
        self.nodes.push(node);
        self.index.insert(problem.space(), vertex, state);
        self.members.push(vertex);
    }

    fn queue_vertex(&mut self, vertex: VertexId) {
        let cost = self.best.tree.cost(vertex);
        let least = cost + self.nodes[vertex.index()].to_goal;
        if least < self.best.bound() {
            self.queue.push(Reverse((Ordered::new(least), Ordered::new(cost), vertex, None)));
        }
    }

    /// Queues an edge if it may help.
    fn queue_edge(&mut self, from: VertexId, to: VertexId, distance: f64) {
        let Node { to_goal, is_useful, .. } = self.nodes[to.index()];
        let cost = self.best.tree.cost(from) + distance;
        let least = cost + to_goal;
        if is_useful && least < self.best.bound() && cost < self.best.tree.cost(to) {
            self.best.growth.looked += 1;
            let edge = Some((to, Ordered::new(distance)));
            self.queue.push(Reverse((Ordered::new(least), Ordered::new(cost), from, edge)));
        }
    }

    /// Removes what cannot be on a better path, and begins a batch.
    fn begin_batch(&mut self, problem: &Problem<S>, iteration: u32) {
        let bound = self.best.bound();
        self.best.growth.looked += self.members.len() as u64;
        let (members, useless): (Vec<VertexId>, Vec<VertexId>) = self.members.iter().partition(|&&vertex| {
            vertex.0 < GOAL.0 + problem.goals().len() as u32 || self.nodes[vertex.index()].least() < bound
        });
        self.useful.retain(|&least| least < bound);
        for vertex in useless {
            self.nodes[vertex.index()].is_useful = false;
            let mut leaf = Some(vertex);
            while let Some(vertex) = leaf.filter(|at| !self.nodes[at.index()].is_useful && self.best.tree.is_leaf(*at))
            {
                leaf = self.best.remove(iteration, vertex);
            }
        }
        if 2 * members.len() < Nearest::<S>::len(&self.index) {
            self.index = Index::default();
            for &vertex in &members {
                self.index.insert(problem.space(), vertex, self.best.growth.graph.state(vertex));
            }
        }
        self.members = members;
        self.missing = self.batch_size;
        let share = if self.draws == 0 { 1.0 } else { self.useful.len().max(1) as f64 / self.draws as f64 };
        self.neighbourhood = self.near.in_informed_set(self.members.len() + self.batch_size, share);
        for at in 0..self.members.len() {
            let vertex = self.members[at];
            if !self.nodes[vertex.index()].is_expanded {
                self.queue_vertex(vertex);
            }
        }
    }

    /// Draws a sample, and queues the edges to it from vertices that were expanded before.
    fn sample(&mut self, problem: &Problem<S>, iteration: u32) {
        let Self { best, sampler, draws, useful, .. } = self;
        let mut known = Known::Nothing;
        let draw = |growth: &mut Growth<S>| {
            let sample = growth.draw(problem, iteration, &mut **sampler)?;
            *draws += 1;
            known = sample.known;
            Some(sample.state)
        };
        let bound = best.bound();
        let Some(state) = best.growth.draw_within(problem, iteration, bound, draw) else { return };
        let node = Node::of(problem, &state);
        useful.push(node.least());
        let Some(state) = best.growth.if_free(problem, iteration, Sample { state, known }) else { return };
        let mut found = std::mem::take(&mut self.found);
        let from = (Direction::In, &state);
        find_near(problem, &mut self.best.growth, &self.index, from, (self.neighbourhood, Order::Any), &mut found);
        let vertex = self.best.growth.graph.add_vertex(iteration, state);
        self.insert(problem, vertex, &state, node);
        for near in &found {
            if self.nodes[near.vertex.index()].is_expanded {
                self.queue_edge(near.vertex, vertex, near.distance);
            }
        }
        self.found = found;
        self.missing -= 1;
    }

    /// Queues the edges from a vertex.
    fn expand(&mut self, problem: &Problem<S>, iteration: u32, vertex: VertexId) {
        let state = self.best.expand(iteration, vertex);
        let mut found = std::mem::take(&mut self.found);
        let from = (Direction::Out, &state);
        find_near(problem, &mut self.best.growth, &self.index, from, (self.neighbourhood, Order::Any), &mut found);
        self.nodes[vertex.index()].is_expanded = true;
        for near in &found {
            self.queue_edge(vertex, near.vertex, near.distance);
        }
        self.found = found;
    }

    /// The best entry of the queue. If it cannot shorten the path, costs have changed: all entries are then queued again.
    fn pop(&mut self) -> Option<(VertexId, Option<(VertexId, Ordered)>)> {
        let Reverse((least, _, _, _)) = self.queue.peek()?;
        if least.value() >= self.best.bound() {
            for Reverse((_, _, from, edge)) in std::mem::take(&mut self.queue).into_vec() {
                match edge {
                    None => self.queue_vertex(from),
                    Some((to, distance)) => self.queue_edge(from, to, distance.value()),
                }
            }
        }
        self.queue.pop().map(|Reverse((_, _, from, edge))| (from, edge))
    }

    /// Takes entries from the queue until a vertex is expanded or an edge tried; returns whether one was.
    fn search(&mut self, problem: &Problem<S>, iteration: u32) -> bool {
        while let Some((from, edge)) = self.pop() {
            self.best.growth.looked += 1;
            let Some((to, distance)) = edge else {
                if self.nodes[from.index()].is_expanded {
                    continue;
                }
                self.expand(problem, iteration, from);
                return true;
            };
            let near = Neighbour { vertex: from, distance: distance.value() };
            let Node { to_goal, is_expanded, .. } = self.nodes[to.index()];
            let is_useful = |best: &BestTree<S>, distance: f64| {
                let cost = best.tree.cost(from) + distance;
                cost < best.tree.cost(to) && cost + to_goal < best.bound()
            };
            if !is_useful(&self.best, near.distance) {
                continue;
            }
            let parent = self.best.priced(problem, near, self.best.growth.graph.state(to));
            if !is_useful(&self.best, parent.distance) {
                return true;
            }
            if self.best.try_parent(problem, iteration, to, parent) {
                self.best.approach(to, to_goal);
                if !is_expanded {
                    self.queue_vertex(to);
                }
            }
            return true;
        }
        false
    }
}

impl<S: Space> Planner<S> for BitStar<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if self.missing == 0 && !self.search(problem, iteration) {
            self.begin_batch(problem, iteration);
        }
        if self.missing > 0 {
            self.sample(problem, iteration);
        }
        self.best.note(problem, iteration);
        Status::Running
    }

    fn phase(&self) -> Phase {
        match self.best.bound() {
            f64::INFINITY if self.missing > 0 => Phase::Sampling,
            f64::INFINITY => Phase::Growing,
            _ => Phase::Improving,
        }
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
