//! The probabilistic roadmap: k-PRM, PRM with a radius, and PRM*, which is k-PRM with a k that grows as it must.
//!
//! Kavraki, Svestka, Latombe and Overmars 1996, "Probabilistic roadmaps for path planning in high-dimensional configuration
//! spaces"; LaValle 2006, "Planning Algorithms", section 5.6; Karaman and Frazzoli 2011, "Sampling-based algorithms for
//! optimal motion planning". The start is the first vertex, the goal the second; where there are several goals, they follow it.
//!
//! Where motions have a direction, so have edges (Svestka and Overmars 1997, "Motion planning for carlike robots using a
//! probabilistic learning approach"): a vertex is joined to the nearest that it leads to and to the nearest that lead to it.

use super::query::SearchRules;
use super::roadmap::{Connection, Ending, GOAL, Roadmap, START};
use super::{Counters, Phase, Planner, Status};
use crate::graph::{EventKind, Graph, VertexId};
use crate::nearest::{Neighbour, Way};
use crate::problem::Problem;
use crate::sampling::Sampler;
use crate::space::Space;

/// When samples are joined to their neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Order {
    /// First all samples, then all edges, every pair tried once.
    Batch,
    /// Each sample at once, to its neighbours among those before it.
    OneByOne {
        /// Whether a sample that connects to nothing is thrown away.
        discard: bool,
    },
}

/// How a roadmap is built.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrmOptions {
    /// How many free samples become vertices.
    pub samples: usize,
    /// To which neighbours a vertex is joined, k at least 1.
    pub connection: Connection,
    /// When.
    pub order: Order,
    /// How it is searched.
    pub rules: SearchRules,
}

/// The k of PRM* for a finished batch of `vertices` vertices: the least whole number above e (1 + 1/d) ln n.
pub fn prm_star_k(vertices: usize, dimension: usize) -> usize {
    let factor = std::f64::consts::E * (1.0 + 1.0 / dimension as f64);
    libm::floor(factor * libm::log(vertices as f64)) as usize + 1
}

/// The k of a course report for as many vertices: ln n, rounded up.
pub fn logarithmic_k(vertices: usize) -> usize {
    (libm::ceil(libm::log(vertices as f64)) as usize).max(1)
}

/// The planner. An iteration tries one sample, connects one vertex to its neighbours, or expands one vertex in the search.
pub struct Prm<S: Space> {
    roadmap: Roadmap<S>,
    vertices: usize,
    order: Order,
    sampler: Box<dyn Sampler<S>>,
    /// For every vertex already connected its last neighbour, and so which later vertices it has tried: out of it, and, where
    /// motions have a direction, into it.
    farthest: [Vec<Neighbour>; 2],
    neighbours: Vec<Neighbour>,
    stage: Stage,
}

/// How many vertices come before all samples: the start and the goals.
fn roadmap_ends<S: Space>(problem: &Problem<S>) -> usize {
    1 + problem.goals().len()
}

enum Stage {
    Sampling,
    /// The next vertex to connect, and the one after the last.
    Connecting {
        next: VertexId,
        end: VertexId,
    },
    /// The ends that are to be joined to a roadmap that exists, the next one last.
    Joining(Vec<VertexId>),
    Ending(Ending),
}

impl<S: Space> Prm<S> {
    /// A planner at its beginning.
    pub fn new(problem: &Problem<S>, options: &PrmOptions, sampler: Box<dyn Sampler<S>>) -> Self {
        let roadmap = Roadmap::new(problem, options.connection, options.rules);
        let mut prm = Self {
            roadmap,
            vertices: options.samples + roadmap_ends(problem),
            order: options.order,
            sampler,
            farthest: [Vec::new(), Vec::new()],
            neighbours: Vec::new(),
            stage: Stage::Sampling,
        };
        // One by one a goal comes right after the start, its neighbour.
        if matches!(options.order, Order::OneByOne { .. }) {
            for (i, goal) in problem.goals().enumerate() {
                for way in Way::all(problem.space()) {
                    let distance = way.distance(problem.space(), goal, problem.start());
                    if distance <= options.connection.radius {
                        let [from, to] = way.ends(VertexId(GOAL.0 + i as u32), START);
                        prm.roadmap.try_edge(problem, 0, from, to);
                    }
                }
            }
        }
        prm.finish_sampling(problem.space());
        prm
    }

    /// A planner whose roadmap exists, proven: it draws no more samples, joins start and goals to their neighbours and searches.
    /// A vertex of the roadmap that is the start or a goal is that one and stays joined as it was; all others come after
    /// these ends, in their order. O(states + edges), and the index of neighbours.
    ///
    /// # Panics
    /// Where an edge names a vertex that does not exist.
    pub fn resume(
        problem: &Problem<S>,
        connection: Connection,
        rules: SearchRules,
        sampler: Box<dyn Sampler<S>>,
        states: &[S::State],
        edges: &[[u32; 2]],
    ) -> Self {
        let mut roadmap = Roadmap::new(problem, connection, rules);
        let ends: Vec<VertexId> = (0..roadmap_ends(problem) as u32).map(VertexId).collect();
        let mut is_kept = vec![false; ends.len()];
        let mut vertices = Vec::with_capacity(states.len());
        for state in states {
            let is_new = |end: &VertexId| !is_kept[end.index()] && roadmap.graph.state(*end) == state;
            vertices.push(match ends.iter().copied().find(is_new) {
                Some(end) => {
                    is_kept[end.index()] = true;
                    end
                }
                None => roadmap.add_vertex(problem.space(), 0, *state),
            });
        }
        for edge in edges {
            let [from, to] = edge.map(|vertex| vertices[vertex as usize]);
            roadmap.graph.add_edge(0, from, to);
        }
        let left: Vec<VertexId> = ends.iter().rev().copied().filter(|end| !is_kept[end.index()]).collect();
        let stage = match left.is_empty() {
            true => Stage::Ending(roadmap.begin_search(problem.space())),
            false => Stage::Joining(left),
        };
        Self {
            vertices: states.len() + ends.len(),
            roadmap,
            order: Order::Batch,
            sampler,
            farthest: [Vec::new(), Vec::new()],
            neighbours: Vec::new(),
            stage,
        }
    }

    /// Goes on once there are enough samples.
    fn finish_sampling(&mut self, space: &S) {
        if self.roadmap.graph.states().len() < self.vertices {
            return;
        }
        self.stage = match self.order {
            Order::Batch => Stage::Connecting { next: START, end: VertexId(self.vertices as u32) },
            Order::OneByOne { .. } => Stage::Ending(self.roadmap.begin_search(space)),
        };
    }

    /// Tries one sample.
    fn sample(&mut self, problem: &Problem<S>, iteration: u32) {
        let Some(state) = self.roadmap.draw(problem, iteration, &mut *self.sampler) else { return };
        match self.order {
            Order::Batch => {
                self.roadmap.add_vertex(problem.space(), iteration, state);
            }
            Order::OneByOne { discard } => self.insert(problem, iteration, state, discard),
        }
        self.finish_sampling(problem.space());
    }

    /// Joins a sample to its neighbours among the vertices so far.
    fn insert(&mut self, problem: &Problem<S>, iteration: u32, state: S::State, discard: bool) {
        let space = problem.space();
        let mut neighbours = Vec::new();
        for &way in Way::all(space) {
            self.roadmap.neighbours(space, way, &state, false, &mut self.neighbours);
            neighbours.extend(self.neighbours.iter().map(|neighbour| (way, neighbour.vertex)));
        }
        let roadmap = &mut self.roadmap;
        if !discard {
            let vertex = roadmap.add_vertex(space, iteration, state);
            for (way, other) in neighbours {
                let [from, to] = way.ends(vertex, other);
                roadmap.try_edge(problem, iteration, from, to);
            }
            return;
        }
        // Whether there will be a vertex is known only after its edges are.
        neighbours.retain(|&(way, other)| {
            let other = *roadmap.graph.state(other);
            let [from, to] = way.ends(&state, &other);
            roadmap.is_motion_free(problem, from, to)
        });
        if neighbours.is_empty() {
            return roadmap.turn_away(EventKind::SampleDiscarded, iteration, state);
        }
        let vertex = roadmap.add_vertex(space, iteration, state);
        for (way, other) in neighbours {
            let [from, to] = way.ends(vertex, other);
            roadmap.graph.add_edge(iteration, from, to);
        }
    }

    /// Tries the motions between one vertex and its neighbours, but for those that were tried from the other side.
    fn connect(&mut self, problem: &Problem<S>, iteration: u32, vertex: VertexId) {
        for &way in Way::all(problem.space()) {
            self.connect_by(problem, iteration, way, vertex);
        }
    }

    /// Tries the motions of one way.
    fn connect_by(&mut self, problem: &Problem<S>, iteration: u32, way: Way, vertex: VertexId) {
        let Connection { k, radius } = self.roadmap.connection();
        let state = *self.roadmap.graph.state(vertex);
        self.roadmap.neighbours(problem.space(), way, &state, true, &mut self.neighbours);
        match self.neighbours.iter().position(|neighbour| neighbour.vertex == vertex) {
            Some(own) => drop(self.neighbours.remove(own)),
            None => self.neighbours.truncate(k),
        }
        let farthest = match self.neighbours.last() {
            Some(&last) if self.neighbours.len() == k => last,
            // Fewer than k: all within the radius were tried.
            _ => Neighbour { distance: radius, vertex: VertexId(u32::MAX) },
        };
        // What leads out of the one leads into the other.
        let (own, others) = match way {
            _ if problem.space().is_symmetric() => (0, 0),
            Way::Out => (0, 1),
            Way::In => (1, 0),
        };
        // An end that is not connected anew has tried nothing from its side.
        let nothing = Neighbour { distance: -1.0, vertex: START };
        self.farthest[own].resize(vertex.index(), nothing);
        self.farthest[own].push(farthest);
        for neighbour in &self.neighbours {
            let other = neighbour.vertex;
            let back = Neighbour { distance: neighbour.distance, vertex };
            // A vertex connected earlier has tried all up to its farthest neighbour.
            let tried = self.farthest[others].get(other.index()).copied().unwrap_or(nothing);
            if other < vertex && !tried.is_before(&back) {
                continue;
            }
            let [from, to] = way.ends(vertex, other);
            self.roadmap.try_edge(problem, iteration, from, to);
        }
    }
}

impl<S: Space> Planner<S> for Prm<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        match &mut self.stage {
            Stage::Sampling => self.sample(problem, iteration),
            Stage::Connecting { next, end } => {
                let vertex = *next;
                *next = VertexId(vertex.0 + 1);
                let is_last = next == end;
                self.connect(problem, iteration, vertex);
                if is_last {
                    self.stage = Stage::Ending(self.roadmap.begin_search(problem.space()));
                }
            }
            Stage::Joining(left) => {
                if let Some(vertex) = left.pop() {
                    let is_last = left.is_empty();
                    self.connect(problem, iteration, vertex);
                    if is_last {
                        self.stage = Stage::Ending(self.roadmap.begin_search(problem.space()));
                    }
                }
            }
            Stage::Ending(ending) => return ending.step(&mut self.roadmap, problem, iteration),
        }
        Status::Running
    }

    fn phase(&self) -> Phase {
        match self.stage {
            Stage::Sampling => Phase::Sampling,
            Stage::Connecting { .. } | Stage::Joining(_) => Phase::Connecting,
            Stage::Ending(ref ending) => ending.phase(),
        }
    }

    fn graph(&self) -> &Graph<S> {
        &self.roadmap.graph
    }

    fn path(&self) -> Vec<VertexId> {
        if let Stage::Ending(ending) = &self.stage { ending.path().to_vec() } else { Vec::new() }
    }

    fn counters(&self) -> Counters {
        self.roadmap.counters
    }

    fn connection(&self) -> Option<Connection> {
        Some(self.roadmap.connection())
    }

    fn roadmap(&mut self) -> Option<&mut Roadmap<S>> {
        Some(&mut self.roadmap)
    }
}
