//! The roadmap of one kind of robot: a PRM in the world without other robots, whose first vertices are the starts and the goals of the
//! robots of this kind. The straight motion from each start to its goal is an edge, too, if it is proven free.

use super::document::Fleet;
use super::motion::{Footprint, Pose};
use crate::error::Error;
use crate::planner::{Phase, Planner, PlannerKind, PrmOptions};
use crate::problem::Problem;
use crate::space::{MotionSpace, Space};
use crate::world::{PlanningWorld, SMALL};
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};

/// After this many clearance evaluations an iteration tries no further direct edge.
const MOST_EVALUATIONS: u64 = 1 << 14;

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
    /// The edges that are not those of the planner, and of how many robots they have been tried.
    direct: Vec<[u32; 2]>,
    tried: u32,
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
        Ok(Self {
            problem,
            planner,
            iteration: 0,
            robots,
            footprint,
            neighbours: Vec::new(),
            direct: Vec::new(),
            tried: 0,
        })
    }

    /// Whether all samples are connected.
    pub fn is_built(&self) -> bool {
        !self.neighbours.is_empty()
    }

    /// One iteration of the planner: a sample, or a vertex that is connected to its neighbours; at last some direct
    /// edges.
    pub fn iterate(&mut self) {
        if self.tried == 0 {
            self.iteration += 1;
            self.planner.iterate(&self.problem, self.iteration);
        }
        if !matches!(self.planner.phase(), Phase::Sampling | Phase::Connecting) {
            self.complete();
        }
    }

    /// Adds direct edges; once all have been tried, lists the neighbours of every vertex.
    fn complete(&mut self) {
        let graph = self.planner.graph();
        let edges: Vec<[u32; 2]> = graph.edges().iter().map(|edge| edge.map(|vertex| vertex.0)).collect();
        let is_end = |edge: &&[u32; 2]| edge.iter().all(|vertex| (*vertex as usize) < 2 * self.robots.len());
        let known: BTreeSet<[u32; 2]> = edges.iter().filter(is_end).copied().collect();
        let validity = self.problem.validity();
        let most = validity.clearance_evaluations() + MOST_EVALUATIONS;
        for robot in self.tried..self.robots.len() as u32 {
            if validity.clearance_evaluations() > most {
                return;
            }
            self.tried = robot + 1;
            let [start, goal] = [2 * robot, 2 * robot + 1];
            let [a, b] = [start, goal].map(|vertex| graph.states()[vertex as usize]);
            let is_known = known.contains(&[start, goal]) || known.contains(&[goal, start]);
            if !is_known && validity.is_motion_free(&a, &b) {
                self.direct.push([start, goal]);
            }
        }
        self.neighbours = vec![Vec::new(); graph.states().len()];
        for [a, b] in edges.into_iter().chain(self.direct.iter().copied()) {
            let way = self.footprint.travel(self.pose(a), self.pose(b));
            self.neighbours[a as usize].push((b, way));
            self.neighbours[b as usize].push((a, way));
        }
        for neighbours in &mut self.neighbours {
            neighbours.sort_by_key(|neighbour| neighbour.0);
            neighbours.dedup_by_key(|neighbour| neighbour.0);
        }
    }

    /// The start and the goal of a robot.
    pub fn ends(&self, robot: usize) -> [u32; 2] {
        let at = self.robots.iter().position(|one| *one == robot).expect("a robot of this kind") as u32;
        [2 * at, 2 * at + 1]
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
        self.planner.graph().edges().len() + self.direct.len()
    }

    /// The edges, in the order of their creation.
    pub fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let grown = self.planner.graph().edges().iter().map(|edge| edge.map(|vertex| vertex.0));
        grown.chain(self.direct.iter().copied())
    }

    /// The neighbours of a vertex, each with the length of the way there; none before the roadmap is built.
    pub fn neighbours(&self, vertex: u32) -> &[(u32, f64)] {
        &self.neighbours[vertex as usize]
    }

    /// The motions tested for collision.
    pub fn motion_checks(&self) -> u64 {
        self.planner.growth().counters.motion_checks + self.robots.len() as u64
    }

    /// The length of the way from every vertex to one, infinite if there is none. Dijkstra's algorithm, O(e log n).
    pub fn distances_to(&self, goal: u32) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; self.vertex_count()];
        distances[goal as usize] = 0.0;
        // Lengths are not negative, so their bits order as they do.
        let mut open = BinaryHeap::from([Reverse((0.0f64.to_bits(), goal))]);
        while let Some(Reverse((distance, vertex))) = open.pop() {
            let distance = f64::from_bits(distance);
            if distance > distances[vertex as usize] {
                continue;
            }
            for &(next, way) in self.neighbours(vertex) {
                if distance + way < distances[next as usize] {
                    distances[next as usize] = distance + way;
                    open.push(Reverse(((distance + way).to_bits(), next)));
                }
            }
        }
        distances
    }
}
