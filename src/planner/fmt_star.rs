//! FMT*: a wave of cheapest paths that runs once through a batch of samples, and proves one motion per new vertex.
//!
//! Janson, Schmerling, Clark and Pavone 2015, "Fast marching tree: a fast marching sampling-based method for optimal motion
//! planning in many dimensions". Differences: a motion that was refused is not tried again; and where the wave ends without a
//! path, and the number of samples was not given, it goes on with twice as many from all of the tree, where the paper gives up.

use super::best_tree::BestTree;
use super::groups::{EdgeOptions, Sampling};
use super::growth::{Growth, START, goals};
use super::info::{DIRECT, END_NEAR, Grows, IMPROVE, Mark, PlannerInfo, PlannerKind, line};
use super::near::{Near, NearRule, Nearness, Order, find_near};
use super::{Phase, Planner, Status};
use crate::error::Error;
use crate::graph::{Ordered, VertexId};
use crate::nearest::{Direction, Index, Nearest, Neighbour, Neighbourhood};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The number of samples to begin with if none is given.
const DEFAULT_SAMPLES: usize = 1000;

/// The most motions that an iteration tries.
const MOST_TRIED: usize = 256;
/// About the most neighbours that an iteration looks at.
const MOST_LOOKED: u64 = 50_000;

crate::options! {
    /// Options of FMT*.
    pub struct FmtStarOptions for crate::options::ALL;
    /// Number of free samples: more find narrower passages and shorter paths but take longer.
    samples: Option<usize>, in 1.0..=1e6, "Samples", else "1000, and twice as many again while there is no path";
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
            line(1, "close z; if none is open: more samples", &[Mark::Expanded]),
            IMPROVE,
            END_NEAR,
        ],
    };

    fn needed(&self) -> Option<[u64; 2]> {
        self.samples.map(|samples| [samples as u64, samples as u64 + 2])
    }

    fn begin<S: Space + 'static>(&self, problem: &Problem<S>, seed: u64) -> Result<Box<dyn Planner<S>>, Error> {
        let best = BestTree::new(problem);
        let mut index = Index::default();
        for (vertex, state) in (START.0..).zip(best.growth.graph.states()) {
            index.insert(problem.space(), VertexId(vertex), state);
        }
        let missing = self.samples.unwrap_or(DEFAULT_SAMPLES);
        let stages = vec![Stage::Waiting; Nearest::<S>::len(&index)];
        Ok(Box::new(FmtStar {
            near: Near::new(problem, self.nearness, NearRule::KNearest)?,
            sampler: self.sampling.sampler(problem.space(), seed),
            missing,
            grows: self.samples.is_none(),
            refused: vec![Vec::new(); stages.len()],
            around: vec![Vec::new(); stages.len()],
            stages,
            open: BinaryHeap::new(),
            best,
            index,
            expanding: None,
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

/// The planner. An iteration draws one sample or expands one vertex; one with very many neighbours in several iterations.
struct FmtStar<S: Space> {
    near: Near,
    sampler: Box<dyn Sampler<S>>,
    /// How many samples are still to be drawn.
    missing: usize,
    /// Whether there are twice as many samples where the wave ends without a path.
    grows: bool,
    best: BestTree<S>,
    /// All vertices.
    index: Index,
    stages: Vec<Stage>,
    /// By vertex: those from which the motion to it was refused.
    refused: Vec<Vec<VertexId>>,
    /// The open vertices, with their costs.
    open: BinaryHeap<Reverse<(Ordered, VertexId)>>,
    /// By vertex: the neighbours of one that waits, once the wave has met it.
    around: Vec<Vec<Neighbour>>,
    /// The vertex whose expansion goes on.
    expanding: Option<Expanding>,
}

/// A vertex that is being expanded.
struct Expanding {
    vertex: VertexId,
    neighbourhood: Neighbourhood,
    /// The neighbours that are still to be tried.
    found: std::vec::IntoIter<Neighbour>,
    /// Those that it has become the parent of, or another open vertex.
    joined: Vec<VertexId>,
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
            self.open.push(Reverse((Ordered::new(self.best.tree.cost(vertex)), vertex)));
        }
    }

    /// The open neighbour through which a state costs least; `from` counts as one.
    fn parent(
        &mut self,
        problem: &Problem<S>,
        neighbourhood: Neighbourhood,
        vertex: VertexId,
        from: Neighbour,
    ) -> Neighbour {
        let around = &mut self.around[vertex.index()];
        if around.is_empty() {
            let state = self.best.growth.state(vertex);
            find_near(
                problem,
                &mut self.best.growth,
                &self.index,
                (Direction::In, &state),
                (neighbourhood, Order::Sorted),
                around,
            );
            for near in &mut *around {
                *near = self.best.priced(problem, *near, &state);
            }
        }
        self.best.growth.looked += around.len() as u64;
        let open = around.iter().filter(|near| self.stages[near.vertex.index()] == Stage::Open);
        let by = |near: &Neighbour| self.best.tree.cost(near.vertex) + near.distance;
        let best = open.chain([&from]).min_by(|a, b| by(a).total_cmp(&by(b)).then(a.vertex.cmp(&b.vertex)));
        *best.expect("there is at least one")
    }

    /// Begins to expand a vertex: finds its neighbours.
    fn begin(&mut self, problem: &Problem<S>, iteration: u32, vertex: VertexId) -> Expanding {
        let state = self.best.expand(iteration, vertex);
        let mut found = Vec::new();
        let neighbourhood = self.near.in_march(self.stages.len());
        find_near(
            problem,
            &mut self.best.growth,
            &self.index,
            (Direction::Out, &state),
            (neighbourhood, Order::Sorted),
            &mut found,
        );
        Expanding { vertex, neighbourhood, found: found.into_iter(), joined: Vec::new() }
    }

    /// Goes on with the expansion of a vertex; keeps it for the next iteration if it is not done. The costs of the open vertices
    /// stay, so it does not matter where it is divided.
    fn expand(&mut self, problem: &Problem<S>, iteration: u32, mut at: Expanding) {
        let (mut tried, looked) = (0, self.best.growth.looked);
        while let Some(near) = at.found.next() {
            let to = near.vertex.index();
            if self.stages[to] != Stage::Waiting {
                continue;
            }
            let from = Neighbour { vertex: at.vertex, distance: near.distance };
            let from = self.best.priced(problem, from, self.best.growth.graph.state(near.vertex));
            let parent = self.parent(problem, at.neighbourhood, near.vertex, from);
            if self.refused[to].contains(&parent.vertex) {
                continue;
            }
            if self.best.try_parent(problem, iteration, near.vertex, parent) {
                self.around[to] = Vec::new();
                at.joined.push(near.vertex);
            } else {
                self.refused[to].push(parent.vertex);
            }
            tried += 1;
            if tried == MOST_TRIED || self.best.growth.looked - looked > MOST_LOOKED {
                self.expanding = Some(at);
                return;
            }
        }
        self.stages[at.vertex.index()] = Stage::Closed;
        for &vertex in &at.joined {
            self.best.approach(vertex, problem.distance_to_goal(self.best.growth.graph.state(vertex)));
        }
        self.open_all(at.joined);
    }
}

impl<S: Space> Planner<S> for FmtStar<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        if self.missing > 0 {
            self.sample(problem, iteration);
            return Status::Running;
        }
        let at = match self.expanding.take() {
            Some(at) => at,
            None => {
                let Some(Reverse((_, vertex))) = self.open.pop() else {
                    unreachable!("vertices are open, or samples are missing")
                };
                if goals(problem).any(|(goal, _)| vertex == goal) {
                    self.best.note(problem, iteration);
                    return Status::Solved;
                }
                self.begin(problem, iteration, vertex)
            }
        };
        self.expand(problem, iteration, at);
        if self.expanding.is_none() && self.open.is_empty() {
            if !self.grows {
                return Status::Exhausted;
            }
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
