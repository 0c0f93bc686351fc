//! A custom planner, in your own crate: expansive space trees, as simple as possible (Hsu, Latombe and Motwani 1997, "Path planning
//! in expansive configuration spaces").
//!
//! The tree grows from a vertex that has grown seldom so far, a limited way towards a sample. It knows a space, samples and proven
//! motions; robots and obstacles are Planarium's. So it plans for each robot that has a space, and its paths are proven.
//!
//! ```
//! use own_planner::Expansive;
//! use planarium::run::{self, OwnPlanner, Status};
//!
//! let scenario = planarium::worlds::generate("discs", &serde_json::json!({ "seed": 3 }))?;
//! let planner = OwnPlanner { id: "expansive", seed: 7, ..OwnPlanner::default() };
//! let mut run = run::start_with::<4>(&scenario, &planner, |problem, seed| Ok(Expansive::boxed(problem, seed)))?;
//! while run.step(100) == Status::Running {}
//! assert_eq!(run.status(), Status::Solved);
//! # Ok::<(), planarium::Error>(())
//! ```
#![deny(missing_docs)]

use planarium::graph::VertexId;
use planarium::planner::{Growth, Planner};
use planarium::problem::Problem;
use planarium::random::{Random, Stream};
use planarium::run::Status;
use planarium::sampling::Uniform;
use planarium::space::Space;

/// The longest step, as a fraction of the largest distance in the space.
const STEP: f64 = 0.1;

/// The number of vertices that are drawn at random; the one among them that has grown least often grows.
const DRAWN: u64 = 8;

/// The planner: a value that is stepped.
pub struct Expansive<S: Space> {
    growth: Growth<S>,
    samples: Uniform,
    random: Random,
    /// The parent of each vertex, and how often it has grown.
    tree: Vec<(VertexId, u32)>,
    /// The vertex at the goal.
    arrived: Option<VertexId>,
}

impl<S: Space + 'static> Expansive<S> {
    /// The planner at its beginning, for [`planarium::run::start_with`]. The seed decides every sample.
    pub fn boxed(problem: &Problem<S>, seed: u64) -> Box<dyn Planner<S>> {
        let mut growth = Growth::new(problem);
        let start = growth.graph.add_vertex(0, *problem.start());
        let samples = Uniform(Random::new(seed, Stream::Samples));
        let random = Random::new(seed, Stream::Bias);
        Box::new(Self { growth, samples, random, tree: vec![(start, 0)], arrived: None })
    }

    /// The vertex that grows.
    fn choose(&mut self) -> VertexId {
        let drawn = (0..DRAWN).map(|_| self.random.below(self.tree.len() as u64) as u32);
        let least = drawn.min_by_key(|&vertex| (self.tree[vertex as usize].1, vertex)).expect("some are drawn");
        self.tree[least as usize].1 += 1;
        VertexId(least)
    }

    /// Adds a vertex if the motion to it is free.
    fn add(&mut self, problem: &Problem<S>, iteration: u32, from: VertexId, to: S::State) -> Option<VertexId> {
        let origin = self.growth.state(from);
        if !self.growth.is_motion_free(problem, &origin, &to) {
            return None;
        }
        let vertex = self.growth.graph.add_vertex(iteration, to);
        self.growth.graph.add_edge(iteration, from, vertex);
        self.tree.push((from, 0));
        Some(vertex)
    }
}

impl<S: Space + 'static> Planner<S> for Expansive<S> {
    fn iterate(&mut self, problem: &Problem<S>, iteration: u32) -> Status {
        let Some(sample) = self.growth.draw_free(problem, iteration, &mut self.samples) else { return Status::Running };
        let (space, from) = (problem.space(), self.choose());
        let origin = self.growth.state(from);
        let (distance, step) = (space.distance(&origin, &sample), STEP * space.extent());
        let target = if distance > step { space.interpolate(&origin, &sample, step / distance) } else { sample };
        if let Some(vertex) = self.add(problem, iteration, from, target) {
            self.arrived = self.add(problem, iteration, vertex, *problem.goal());
        }
        if self.arrived.is_some() { Status::Solved } else { Status::Running }
    }

    fn growth(&self) -> &Growth<S> {
        &self.growth
    }

    fn growth_mut(&mut self) -> &mut Growth<S> {
        &mut self.growth
    }

    fn path(&self) -> Vec<VertexId> {
        let Some(mut vertex) = self.arrived else { return Vec::new() };
        let mut path = vec![vertex];
        while vertex.0 > 0 {
            vertex = self.tree[vertex.index()].0;
            path.push(vertex);
        }
        path.reverse();
        path
    }
}
