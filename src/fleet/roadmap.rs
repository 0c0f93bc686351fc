//! The roadmap of one kind of robot: a PRM in the world without other robots, whose first vertices are the starts and the goals
//! of the robots of this kind. The straight motion from each start to its goal is an edge, too, if it is proven free. A roadmap
//! that is complete can grow by more samples, each connected to its neighbours at once.

use super::document::Fleet;
use super::motion::{Footprint, Pose};
use crate::error::Error;
use crate::geometry::sort_stably;
use crate::graph::{Ordered, VertexId};
use crate::planner::{Phase, Planner, PlannerKind, PrmOptions};
use crate::problem::Problem;
use crate::random::{Random, Stream};
use crate::space::{MotionSpace, Space};
use crate::world::{PlanningWorld, SMALL};
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

/// After this many clearance evaluations an iteration tries no further direct edge.
const MOST_EVALUATIONS: u64 = 1 << 14;
/// The most samples drawn for one that is wanted. If they do not suffice, there is little free space.
const DRAWS: u64 = 50;

/// A roadmap that grows.
pub(super) struct Roadmap {
    problem: Problem<MotionSpace<SMALL>>,
    planner: Box<dyn Planner<MotionSpace<SMALL>>>,
    iteration: u32,
    /// The robots of this kind, in order.
    robots: Vec<usize>,
    pub footprint: Footprint,
    /// Of every vertex, its neighbours, each with the length of the way there; filled once the roadmap is built.
    neighbours: Vec<Vec<(u32, f64)>>,
    /// Of how many robots the motion from the start straight to the goal has been tried.
    tried: u32,
    random: Random,
    /// The number of vertices to grow to, and how many more samples may be drawn for it.
    wanted: (usize, u64),
}

impl Roadmap {
    /// The roadmap of the robots of one kind, before its first sample.
    pub fn new(
        fleet: &Fleet,
        world: &PlanningWorld,
        robots: Vec<usize>,
        options: &PrmOptions,
        seed: u64,
    ) -> Result<Self, Error> {
        let space = MotionSpace::new(world.default_space());
        let members = robots.iter().map(|&i| &fleet.robots()[i]);
        let ends: Vec<_> = members.flat_map(|member| [&member.start, &member.goal]).map(|q| space.state(q)).collect();
        let checker = world.checker(&space, options.edges.limits.tolerance);
        let checker = ends.chunks(2).fold(checker, |checker, ends| checker.fitted(&ends[0], &ends[1]));
        let mut problem = Problem::new(space, checker.validity(), ends[0], ends[1])?;
        problem.add_goals(&ends[2..]);
        problem.records_events = false;
        let planner = options.begin(&problem, seed)?;
        let footprint = Footprint::of(world.scenario().robot());
        let random = Random::new(seed, Stream::Growth);
        let (iteration, neighbours, tried, wanted) = (0, Vec::new(), 0, (0, 0));
        Ok(Self { problem, planner, iteration, robots, footprint, neighbours, tried, random, wanted })
    }

    /// Whether all samples are connected.
    pub fn is_built(&self) -> bool {
        !self.neighbours.is_empty()
    }

    /// Begins to grow to this number of vertices; until it has them, it is not built.
    pub fn grow_to(&mut self, vertices: usize) {
        let more = vertices.saturating_sub(self.vertex_count()) as u64;
        self.wanted = (vertices, DRAWS * more);
        self.neighbours = Vec::new();
    }

    /// One iteration: a sample, or a vertex that is connected to its neighbours; at last some direct edges.
    pub fn iterate(&mut self) {
        if self.wanted.0 > 0 {
            self.iteration += 1;
            return self.draw();
        }
        if self.tried == 0 {
            self.iteration += 1;
            self.planner.iterate(&self.problem, self.iteration);
        }
        if !matches!(self.planner.phase(), Phase::Sampling | Phase::Connecting) && self.add_direct_edges() {
            self.complete();
        }
    }

    /// One more sample.
    fn draw(&mut self) {
        let (vertices, left) = self.wanted;
        if self.vertex_count() >= vertices || left == 0 {
            return self.complete();
        }
        self.wanted.1 = left - 1;
        let state = self.problem.space().sample(&mut self.random);
        if self.problem.validity().is_free(&state)
            && let Some(roadmap) = self.planner.roadmap_mut()
        {
            roadmap.extend(&self.problem, self.iteration, state);
        }
    }

    /// Adds some of the motions from each start straight to its goal; returns whether all have been tried.
    fn add_direct_edges(&mut self) -> bool {
        let is_end = |edge: &[u32; 2]| edge.iter().all(|vertex| (*vertex as usize) < self.end_count());
        let known: BTreeSet<[u32; 2]> = self.edges().filter(is_end).collect();
        let most = self.problem.validity().clearance_evaluations() + MOST_EVALUATIONS;
        while (self.tried as usize) < self.robots.len() {
            if self.problem.validity().clearance_evaluations() > most {
                return false;
            }
            let [start, goal] = [2 * self.tried, 2 * self.tried + 1];
            self.tried += 1;
            let is_new = !known.contains(&[start, goal]) && !known.contains(&[goal, start]);
            if is_new && let Some(roadmap) = self.planner.roadmap_mut() {
                roadmap.join(&self.problem, self.iteration, VertexId(start), VertexId(goal));
            }
        }
        true
    }

    /// Lists the neighbours of every vertex.
    fn complete(&mut self) {
        let graph = self.planner.graph();
        let edges: Vec<[u32; 2]> = graph.edges().iter().map(|edge| edge.map(|vertex| vertex.0)).collect();
        self.neighbours = vec![Vec::new(); graph.states().len()];
        for [a, b] in edges {
            let way = self.footprint.travel(self.pose(a), self.pose(b));
            self.neighbours[a as usize].push((b, way));
            self.neighbours[b as usize].push((a, way));
        }
        for neighbours in &mut self.neighbours {
            sort_stably(neighbours, |a, b| a.0.cmp(&b.0));
            neighbours.dedup_by_key(|neighbour| neighbour.0);
        }
    }

    /// The start and the goal of a robot.
    pub fn ends(&self, robot: usize) -> [u32; 2] {
        let at = self.robots.iter().position(|one| *one == robot).expect("a robot of this kind") as u32;
        [2 * at, 2 * at + 1]
    }

    /// How many vertices are starts and goals.
    pub fn end_count(&self) -> usize {
        2 * self.robots.len()
    }

    /// The pose of a vertex.
    pub fn pose(&self, vertex: u32) -> Pose {
        let [x, y, theta, _] = self.planner.graph().states()[vertex as usize];
        [x, y, theta]
    }

    /// The number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.planner.graph().states().len()
    }

    /// The number of edges.
    pub fn edge_count(&self) -> usize {
        self.planner.graph().edges().len()
    }

    /// The edges, in the order of their creation.
    pub fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.planner.graph().edges().iter().map(|edge| edge.map(|vertex| vertex.0))
    }

    /// The neighbours of a vertex, each with the length of the way there; none before the roadmap is built.
    pub fn neighbours(&self, vertex: u32) -> &[(u32, f64)] {
        &self.neighbours[vertex as usize]
    }

    /// The mean length of the edges, in metres; infinite if there is none.
    pub fn mean_way(&self) -> f64 {
        let ways = self.neighbours.iter().flatten().map(|(_, way)| *way);
        let (count, sum) = ways.fold((0u32, 0.0), |(count, sum), way| (count + 1, sum + way));
        if count == 0 { f64::INFINITY } else { sum / f64::from(count) }
    }

    /// The motions tested for collision.
    pub fn motion_checks(&self) -> u64 {
        self.planner.growth().counters.motion_checks
    }

    /// The length of the way from every vertex to one, infinite if there is none. Dijkstra's algorithm, O(e log n).
    pub fn distances_to(&self, goal: u32) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; self.vertex_count()];
        distances[goal as usize] = 0.0;
        let mut open = BinaryHeap::from([Reverse((Ordered::ZERO, goal))]);
        while let Some(Reverse((distance, vertex))) = open.pop() {
            let distance = distance.value();
            if distance > distances[vertex as usize] {
                continue;
            }
            for &(next, way) in self.neighbours(vertex) {
                if distance + way < distances[next as usize] {
                    distances[next as usize] = distance + way;
                    open.push(Reverse((Ordered::new(distance + way), next)));
                }
            }
        }
        distances
    }
}
