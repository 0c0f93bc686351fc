//! FMT*: a wave of cheapest paths that runs once through a batch of samples, and proves one motion per new vertex.
//!
//! Janson, Schmerling, Clark and Pavone 2015, "Fast marching tree: a fast marching sampling-based method for optimal motion planning in
//! many dimensions". Differences: a motion that was refused is not tried again; and where the wave ends without a path, it goes on with
//! twice as many samples from all of the tree, where the paper gives up.

use super::best_tree::BestTree;
use super::groups::{EdgeOptions, Sampling};
use super::growth::{Growth, START, goals};
use super::info::{DIRECT, END_NEAR, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, line};
use super::near::{Near, NearRule, Nearness, Reach};
use super::{Phase, Planner, Status};
use crate::error::Error;
use crate::graph::VertexId;
use crate::nearest::{Direction, Index, Nearest, Neighbour};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

crate::options! {
    /// Options of FMT*.
    pub struct FmtStarOptions for crate::options::ALL;
    /// Number of free samples: more shorten the path but take longer; without a path there are twice as many.
    samples: usize = 1000, in 1.0..=1e6, "Samples";
    /// Which vertices are neighbours.
    nearness: Nearness;
    /// Where samples come from.
    sampling: Sampling;
    /// Collision checking, metric, steering and limits of its edges, and improvement of the path.
    edges: EdgeOptions;
}

impl PlannerKind for FmtStarOptions {
    const INFO: PlannerInfo = PlannerInfo {
        id: "fmt-star",
        title: "FMT*",
        summary: "Draws a batch of samples, and grows a tree through it in the order of cost, with one motion proven per vertex.",
        guarantee: "Asymptotically optimal: with more samples its one path approaches the shortest.",
        grows: Grows::Tree,
        presets: &[],
        pseudocode: &[
            DIRECT,
            line(0, "until there are n: draw a sample", &[Mark::Sampling, Mark::Vertex]),
            line(1, "if it collides: next sample", &[Mark::Rejected]),
            line(0, "T ← {start}, which is open; repeat:", &[]),
            line(1, "z ← the cheapest open vertex; a goal: solved", &[Mark::Growing, Mark::Expanded, Mark::Solved]),
            line(1, "for the neighbours x of z that are not in T:", &[]),
            line(2, "y ← the open neighbour best for x", &[]),
            line(2, "if y – x is free: add it, x is open next", &[Mark::Edge]),
            line(2, "else: x waits for another one", &[Mark::Refused]),
            line(1, "close z; if none is open: n ← 2 n", &[Mark::Expanded]),
            IMPROVE,
            END_NEAR,
        ],
    };

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let best = BestTree::new(problem);
        let mut index = Index::default();
        for (vertex, state) in (START.0..).zip(best.growth.graph.states()) {
            index.insert(problem.space(), VertexId(vertex), state);
        }
        let missing = self.samples;
        let stages = vec![Stage::Waiting; Nearest::<S>::len(&index)];
        Ok(Box::new(FmtStar {
            near: Near::new(problem, self.nearness, NearRule::KNearest)?,
            sampler: self.sampling.sampler(problem.space(), seed),
            missing,
            refused: vec![Vec::new(); stages.len()],
            around: vec![Vec::new(); stages.len()],
            stages,
            open: BinaryHeap::new(),
            best,
            index,
            found: Vec::new(),
        }))
    }
}

/// Where a vertex stands in the march.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// Not in the tree.
    Waiting,
    /// In the tree, at the front of the wave.
    Open,
    /// In the tree, behind the front: it gets no more children.
    Closed,
}

/// The planner. An iteration draws one sample or expands one vertex.
struct FmtStar<S: Space> {
    near: Near,
    sampler: Box<dyn Sampler<S>>,
    /// How many samples are still to be drawn.
    missing: usize,
    best: BestTree<S>,
    /// All vertices.
    index: Index,
    stages: Vec<Stage>,
    /// By vertex: those from which the motion to it was refused.
    refused: Vec<Vec<VertexId>>,
    /// The open vertices: the bits of their costs, which are not negative and so ordered as they are, and their numbers.
    open: BinaryHeap<Reverse<(u64, VertexId)>>,
    /// By vertex: the neighbours of one that waits, once the wave has met it.
    around: Vec<Vec<Neighbour>>,
    found: Vec<Neighbour>,
}

impl<S: Space> FmtStar<S> {
    /// Draws a sample.
    fn sample(&mut self, problem: &Problem<S>, iteration: u32) {
        let Some(state) = self.best.growth.draw_free(problem, iteration, &mut *self.sampler) else { return };
        let vertex = self.best.growth.graph.add_vertex(iteration, state);
        self.index.insert(problem.space(), vertex, &state);
        self.stages.push(Stage::Waiting);
        self.refused.push(Vec::new());
        self.around.push(Vec::new());
        self.missing -= 1;
        if self.missing == 0 {
            self.around.fill(Vec::new());
            let tree = (START.0..).zip(&self.stages).map(|(vertex, _)| VertexId(vertex));
            let tree = tree.filter(|&vertex| self.best.tree.cost(vertex) < f64::INFINITY).collect();
            self.open_all(tree);
        }
    }

    fn open_all(&mut self, vertices: Vec<VertexId>) {
        for vertex in vertices {
            self.stages[vertex.index()] = Stage::Open;
            self.open.push(Reverse((self.best.tree.cost(vertex).to_bits(), vertex)));
        }
    }

    /// The open neighbour by way of which a state costs least; `from` counts as one.
    fn parent(&mut self, problem: &Problem<S>, reach: Reach, vertex: VertexId, from: Neighbour) -> Neighbour {
        let around = &mut self.around[vertex.index()];
        if around.is_empty() {
            let state = self.best.growth.state(vertex);
            reach.find(problem, &mut self.best.growth, &self.index, Direction::In, &state, around);
        }
        let open = around.iter().filter(|near| self.stages[near.vertex.index()] == Stage::Open);
        let by = |near: &Neighbour| self.best.tree.cost(near.vertex) + near.distance;
        let best = open.chain([&from]).min_by(|a, b| by(a).total_cmp(&by(b)).then(a.vertex.cmp(&b.vertex)));
        *best.expect("there is at least one")
    }

    /// Expands a vertex.
    fn expand(&mut self, problem: &Problem<S>, iteration: u32, vertex: VertexId) {
        let state = self.best.expand(iteration, vertex);
        let reach = self.near.in_march(self.stages.len());
        let mut found = std::mem::take(&mut self.found);
        reach.find(problem, &mut self.best.growth, &self.index, Direction::Out, &state, &mut found);
        let mut joined = Vec::new();
        for near in &found {
            let to = near.vertex.index();
            if self.stages[to] != Stage::Waiting {
                continue;
            }
            let parent = self.parent(problem, reach, near.vertex, Neighbour { vertex, distance: near.distance });
            if self.refused[to].contains(&parent.vertex) {
                continue;
            }
            if self.best.try_parent(problem, iteration, near.vertex, parent) {
                self.around[to] = Vec::new();
                joined.push(near.vertex);
            } else {
                self.refused[to].push(parent.vertex);
            }
        }
        self.found = found;
        self.stages[vertex.index()] = Stage::Closed;
        for &vertex in &joined {
            self.best.approach(vertex, problem.distance_to_goal(self.best.growth.graph.state(vertex)));
        }
        self.open_all(joined);
    }
}

impl<S: Space> Planner<S> for FmtStar<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if self.missing > 0 {
            self.sample(problem, iteration);
            return Status::Running;
        }
        let Some(Reverse((_, vertex))) = self.open.pop() else {
            unreachable!("vertices are open, or samples are missing")
        };
        if goals(problem).any(|(goal, _)| vertex == goal) {
            self.best.note(problem, iteration);
            return Status::Solved;
        }
        self.expand(problem, iteration, vertex);
        if self.open.is_empty() {
            self.missing = self.stages.len();
        }
        Status::Running
    }

    fn phase(&self) -> Phase {
        match self.best.bound() {
            f64::INFINITY if self.missing > 0 => Phase::Sampling,
            f64::INFINITY => Phase::Growing,
            _ => Phase::Done,
        }
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
